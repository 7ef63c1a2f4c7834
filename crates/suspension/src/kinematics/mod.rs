//! Kinematics of a suspension at a pose: angles, roll centre, motion ratios and rates as derivatives along a motion of the wheels.
//!
//! [`SuspensionParts`] finds the wheels, the force elements and the rack in a mechanism by the names of the importer;
//! [`SuspensionParts::values`] computes all quantities at a pose, with loads also those of the bushes. Angles and axes: ISO 8855 and SAE J670, in the vehicle's axes.

mod compliance;
mod force_element;
mod linkage_motion;
mod loads;
mod parts;
mod pose_values;
mod values;
mod wheel;
mod wheel_points;

pub use force_element::ForceElement;
pub use linkage_motion::MotionError;
pub use loads::{AntiRollBar, ComplianceLoads, LoadCase, LoadedWheels};
pub(crate) use parts::torsion_sign;
pub use parts::{MissingWheel, SuspensionParts};
pub use pose_values::Vehicle;
pub use values::{KinematicUnit, KinematicValue, KinematicValues};
pub use wheel_points::{
    RACK, SIDES, WHEEL_CENTRE, is_on_wheel, sliding_rack, wheel_centres, wheel_of_patch, wheel_points,
};
