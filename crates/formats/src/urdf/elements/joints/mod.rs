//! Joints, and the armatures of their motors.

pub(crate) mod armature;
pub(crate) mod gazebo_joint;
pub(crate) mod joint;
pub(crate) mod simulator_couplings;
pub(crate) mod transmission;
