//! What the suites share: cases to try, motions, velocities from differences of poses, and a gauge that keeps the
//! worst deviation seen. For tests only, so it panics where a case makes no sense.

pub mod answer;
pub mod bench;
pub mod cases;
pub mod differences;
pub mod gauge;
pub mod imposed;
pub mod judge;
pub mod motion;
pub mod readers;
pub mod rig;
pub mod routes;
pub mod subjects;
pub mod tally;
