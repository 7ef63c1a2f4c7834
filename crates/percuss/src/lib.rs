#![doc = include_str!("../../../README.md")]
//!
//! # The crate
//! Everything a user of the library needs, re-exported from the crates that hold it.

pub use percuss_contact as contact;
pub use percuss_dynamics::{
    Accelerations, AssemblyError, Base, BranchLimits, Conditions, ConditionsError, Configuration,
    ConfigurationError, Contact, ContactError, Direction, EffectiveMass, Frame, InverseOperationalInertia,
    LocatedContact, PointForce, Pose, Remark, Route, RouteChoice, RouteError, Shares, Strike, StrikeError,
    System, Workspace,
};
pub use percuss_formats::{
    DEFAULT_MAX_SIZE, Diagnostic, LoadError, LoadOptions, Loaded, Source, load, write_urdf,
};
pub use percuss_mechanism as mechanism;
pub use percuss_mechanism::{
    Accept, BuildError, Built, Closure, ClosureDescription, ClosureKind, Coupling, CouplingDescription,
    Geometry, Inertial, Joint, JointDescription, JointId, JointKind, Limits, Link, LinkDescription, LinkId,
    Mechanism, MechanismBuilder, Mimic, MimicDescription, Problem, Severity, Subject, UnknownName,
};
pub use percuss_spatial as spatial;
pub use percuss_study as study;
