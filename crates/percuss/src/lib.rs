#![doc = include_str!("../../../README.md")]
//!
//! # The crate
//! Public interface of the library, re-exported from the crates of the workspace; every type has exactly one
//! name. Matrices and vectors are those of [`nalgebra`], which is re-exported too.
//!
//! A model is loaded from a path or from text:
//!
//! ```
//! use percuss::{DEFAULT_MAX_SIZE, LoadOptions, Source, load};
//!
//! let text = r#"<robot name="pendulum"><link name="ground"/><link name="rod"/>
//!     <joint name="hinge" type="continuous"><parent link="ground"/><child link="rod"/></joint></robot>"#;
//! let loaded = load(&Source::from_text("pendulum.urdf", text), &LoadOptions::default())?;
//! assert_eq!(loaded.mechanism.joints().len(), 1);
//!
//! let missing = Source::read("there/is/no/such/file.urdf", DEFAULT_MAX_SIZE);
//! assert_eq!(missing.unwrap_err().diagnostics[0].code, "no-such-file");
//! # Ok::<(), percuss::LoadError>(())
//! ```
//!
//! [`suspension::import`] reads hardpoints from the same [`Source`]. The computation continues with values,
//! each computed from the previous one: [`System`] → [`Assembly`] → [`Pose`] → [`ContactResponse`].
//! `examples/own_solver.rs` computes m̄ from the matrices of a pose with a separate solver.
//!
//! [`study`] provides the analyses of the command line with the same JSON output; [`contact`] provides the
//! contact laws.

// Links to the pages of the crates, not copies: a copy shows `Matrix<f64, Const<3>, Const<1>, ArrayStorage<f64, 3, 1>>` where the
// crate's own page has `Vector3<f64>`, since compiled crates do not keep the names of type aliases.
pub use nalgebra;
pub use percuss_contact as contact;
#[doc(no_inline)]
pub use percuss_dynamics::{
    Accelerations, Assembly, AssemblyError, Base, Batch, BatchAnswer, BatchError, BatchPositions,
    BranchLimits, ConditionOfJoint, Conditions, ConditionsError, Configuration, ConfigurationError,
    ConstraintRank, Contact, ContactColumns, ContactError, ContactMap, ContactPart, ContactResponse,
    ContactStatus, Contributions, DenseReason, DepartingAxis, Direction, DrawnGap, DrivenPath, EffectiveMass,
    ErrorBudget, Frame, InverseOperationalInertia, LayoutError, LocatedContact, LoopState, MapAnswers,
    MapError, MatrixError, MatrixName, MatrixOptions, MatrixResponse, MatrixView, PathAnswer, PointForce,
    PointVelocity, Pose, PoseRank, PrincipalMass, Remark, RemarkFlags, ResponseError, RigidLoops, Route,
    RouteChoice, RouteError, ScalarWorkspace, Singularity, StateSizeError, System, Travel, TravelError,
    Workspace, effective_mass, input,
};
#[doc(no_inline)]
pub use percuss_formats::{
    Comments, DEFAULT_MAX_MESH_SIZE, DEFAULT_MAX_SIZE, Diagnostic, Facet, LoadError, LoadOptions, Loaded,
    MeshError, MeshFolders, Orientation, Purpose, Shape, Solid, Source, Surface, SurfaceError, Triangles,
    load, read_mesh, suspension, write_urdf, write_urdf_with,
};
pub use percuss_mechanism as mechanism;
#[doc(no_inline)]
pub use percuss_mechanism::{
    Accept, BuildError, Built, Closure, ClosureDescription, ClosureId, ClosureKind, Coupling,
    CouplingDescription, Geometry, Inertial, Joint, JointDescription, JointId, JointKind, Limits, Link,
    LinkDescription, LinkId, LoopFrame, Mechanism, MechanismBuilder, Mimic, MimicDescription, NameKind,
    Problem, Severity, Subject, UnknownName,
};
pub use percuss_spatial as spatial;
pub use percuss_study as study;
