//! Parameters of each simulator, one file per simulator.

mod curve;
mod engines;
pub(super) mod equivalent;
mod multibody;
pub(super) mod simulated;

pub(super) use engines::{bullet, dart, gazebo, gazebo_classic, jolt, mujoco, newton, ode, physx, rapier};
pub(super) use multibody::{adams, chrono, drake, exudyn, opensim, simscape};
