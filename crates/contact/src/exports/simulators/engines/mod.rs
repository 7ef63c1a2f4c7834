//! Physics engines of robotics, games and learning.

pub(in crate::exports) mod bullet;
pub(in crate::exports) mod dart;
pub(in crate::exports) mod gazebo;
pub(in crate::exports) mod gazebo_classic;
pub(in crate::exports) mod jolt;
pub(in crate::exports) mod mujoco;
pub(in crate::exports) mod newton;
pub(in crate::exports) mod ode;
pub(in crate::exports) mod physx;
pub(in crate::exports) mod rapier;
