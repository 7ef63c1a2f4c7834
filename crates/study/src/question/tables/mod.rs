//! Tables of a question: the only description of its parts. Each key is a key of studies, and a flag of the command line unless it
//! says `arg(skip)`; its documentation is the help of the flag and the description in the JSON schema.

pub(crate) mod contact;
pub(crate) mod damping;
pub(crate) mod exports;
pub(crate) mod extremes;
pub(crate) mod identify;
pub(crate) mod impact;
pub(crate) mod kinematics;
pub(crate) mod map;
pub(crate) mod mass;
pub(crate) mod model;
pub(crate) mod response;
pub(crate) mod safe_speed;
pub(crate) mod sweep;

#[cfg(feature = "flags")]
pub mod headings {
    //! Headings in the help of the command line, under which the flags of several tables appear.

    /// Link, point and normal.
    pub const CONTACT: &str = "Contact";
    /// Joint positions.
    pub const POSE: &str = "Pose";
    /// Locks, fixed points, armatures, base.
    pub const CONDITIONS: &str = "Conditions";
    /// Output in addition to the effective mass.
    pub const ADDITIONAL: &str = "Additional results";
    /// Changes to masses and hardpoints.
    pub const CHANGES: &str = "Changes to the model";
    /// Limits and checks of input files.
    pub const READING: &str = "Reading";
    /// Format of the result.
    pub const ANSWER: &str = "Result";
    /// Data of the vehicle.
    pub const VEHICLE: &str = "Vehicle";
    /// Output files.
    pub const OUTPUT: &str = "Output";
    /// Restitution, stiffness and law of a damper.
    pub const DAMPER: &str = "Damper";
    /// Restitution, motion and contact law of an impact.
    pub const IMPACT: &str = "Impact";
    /// Rows of a sweep.
    pub const ROWS: &str = "Rows";
    /// Surfaces and directions of a map.
    pub const SURFACE: &str = "Surface or directions";
    /// Body region and limit of a safe speed.
    pub const LIMIT: &str = "Person and limit";
    /// Directions and positions of a safe speed.
    pub const WHICH: &str = "Directions, positions";
}
