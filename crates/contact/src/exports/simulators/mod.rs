//! Parameters of each simulator, one file per simulator.

pub(super) mod adams;
pub(super) mod bullet;
pub(super) mod chrono;
pub(super) mod dart;
pub(super) mod drake;
pub(super) mod exudyn;
pub(super) mod gazebo;
pub(super) mod gazebo_classic;
pub(super) mod jolt;
pub(super) mod mujoco;
pub(super) mod newton;
pub(super) mod ode;
pub(super) mod opensim;
pub(super) mod physx;
pub(super) mod rapier;
pub(super) mod simscape;
