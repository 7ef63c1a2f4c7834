//! Errors of a search for extremes.

use crate::motion::driver_rates::RatesError;
use percuss_dynamics::{AssemblyError, ConfigurationError, Pose, ResponseError, System};
use percuss_mechanism::JointId;

/// Error of a search for extremes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExtremesError {
    /// A range is empty or not finite.
    #[error("joint \"{joint}\": the range {lower} to {upper} is empty or not finite")]
    Range {
        /// The joint.
        joint: String,
        /// Lower end, rad or m.
        lower: f64,
        /// Upper end.
        upper: f64,
    },
    /// The axis of a range of normals has no direction.
    #[error("the axis of the normals has no direction; expected a vector other than 0,0,0")]
    NoAxis,
    /// A range of normals for a reflected inertia.
    #[error(
        "a reflected inertia does not depend on the contact, so a range of normals has no effect; expected no range of normals"
    )]
    NormalsOfContact,
    /// A cone of normals or a patch of points that the search does not cover.
    #[error(
        "a cone of normals (0 to 90°) and edges of contact points (two at most) apply to the effective mass at a point with a fixed normal; \
         expected no other quantity, no line between two points, no wheel, and edges neither for a moment nor with `any` or `across`"
    )]
    VariedContact,
    /// The bearing is the ground, but the base floats.
    #[error(
        "the ground has no reaction, because the base floats; expected a joint or a loop closure as the bearing"
    )]
    FloatingBase,
    /// The normal of a kept point has no direction.
    #[error(
        "the normal of kept point number {number} (from 1) has no direction; expected a finite vector other than 0,0,0"
    )]
    NoKeptNormal {
        /// Number of the kept point, from 1.
        number: usize,
    },
    /// The kept points leave no motion of the varied joints.
    #[error(
        "the kept points leave no motion of the varied joints ({}): there is one pose only; vary more joints, or keep fewer directions",
        joints.join(", ")
    )]
    NoSelfMotion {
        /// Varied joints.
        joints: Vec<String>,
    },
    /// A row of a path does not fit its joints.
    #[error(
        "row {row} of the path (from 0) has {got} numbers, or one that is not finite; expected {expected} finite numbers"
    )]
    PathRow {
        /// Number of the row, from 0.
        row: usize,
        /// Number of its numbers.
        got: usize,
        /// Number of joints of the path.
        expected: usize,
    },
    /// A path without rows.
    #[error("the path has no rows; expected at least one row of positions")]
    NoRows,
    /// No joint varies.
    #[error("no joint varies; give the range of at least one driving joint")]
    NoJoint,
    /// A varied joint does not drive, or has several velocities.
    #[error(
        "joint \"{joint}\" is no driving joint with one velocity; {}",
        if drivers.is_empty() { "no joint drives".to_owned() } else { format!("expected one of {}", drivers.join(", ")) }
    )]
    NoDriver {
        /// The joint.
        joint: String,
        /// Joints with one velocity that drive at the pose.
        drivers: Vec<String>,
    },
    /// A joint whose inertia with the other drivers at rest is searched does not drive.
    #[error(
        "joint \"{joint}\" does not drive, so that it has no inertia with the other drivers at rest (held); driving joints: {}. Set its position, by which \
         a joint of a loop drives, or search its inertia with free drivers (reflected:{joint})",
        if drivers.is_empty() { "none".to_owned() } else { drivers.join(", ") }
    )]
    NotHeld {
        /// The joint.
        joint: String,
        /// Joints that drive at the pose.
        drivers: Vec<String>,
    },
    /// No start has a pose with a finite value.
    #[error("no start of the search has a pose with a finite value")]
    NoStart,
    /// The configuration cannot be set.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// A pose does not close.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// A contact is invalid.
    #[error(transparent)]
    Contact(#[from] ResponseError),
    /// The motions of the drivers are not determined.
    #[error(transparent)]
    Rates(#[from] RatesError),
}

/// Joints whose positions can be chosen at a pose: outside loops, or drivers of loops; neither locked nor mimics.
pub(super) fn variable_joints(system: &System, pose: &Pose) -> Vec<JointId> {
    let drivers = pose.assembly().drivers();
    let is_variable = |joint: &JointId| !system.is_bound(*joint) || drivers.contains(joint);
    pose.coordinate_joints().into_iter().filter_map(|(joint, _)| joint).filter(is_variable).collect()
}

/// Error about a joint whose position cannot be chosen, with the joints that can be varied at `pose`.
pub(super) fn no_driver(pose: Option<&Pose>, system: &System, joint: JointId) -> ExtremesError {
    let mechanism = system.mechanism();
    let name = |id: JointId| mechanism.joint(id).name().to_owned();
    let drivers = pose.map(|pose| variable_joints(system, pose)).unwrap_or_default();
    let single = drivers.into_iter().filter(|id| mechanism.joint(*id).kind().dofs() == 1);
    ExtremesError::NoDriver { joint: name(joint), drivers: single.map(name).collect() }
}
