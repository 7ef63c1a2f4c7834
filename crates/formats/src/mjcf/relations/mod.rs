//! Equality constraints, tendons and actuators: closures, relations between joint positions, and armatures.

pub(crate) mod actuator;
pub(crate) mod equality;
pub(crate) mod joint_relations;
pub(crate) mod keyframe;
pub(crate) mod references;
pub(crate) mod tendon;
