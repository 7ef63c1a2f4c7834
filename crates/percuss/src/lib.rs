#![doc = include_str!("../README.md")]
//!
//! # Models from files
//!
//! ```
//! use percuss::{LoadOptions, Source, load, load_file};
//!
//! let text = r#"<robot name="pendulum"><link name="ground"/><link name="rod"/>
//!     <joint name="hinge" type="continuous"><parent link="ground"/><child link="rod"/></joint></robot>"#;
//! let loaded = load(&Source::from_text("pendulum.urdf", text), &LoadOptions::default())?;
//! assert_eq!(loaded.mechanism.joints().len(), 1);
//!
//! let missing = load_file("there/is/no/such/file.urdf");
//! assert_eq!(missing.unwrap_err().diagnostics[0].code, "no-such-file");
//! # Ok::<(), percuss::LoadError>(())
//! ```
//!
//! With the feature `suspension`, `suspension::import` reads hardpoints from the same [`Source`].
//!
//! # Tasks
//!
//! | task | items |
//! |---|---|
//! | read or build a mechanism | [`load_file`], [`load`] with [`LoadOptions`], [`MechanismBuilder`]; write it: [`write_urdf`], [`write_mjcf`], [`write_sdf`] |
//! | base, locks, held points, rotors | [`Conditions`], then [`System`] |
//! | m̄ at a contact of one pose, its error, v*, shares | [`Configuration`], [`Pose::respond`], [`ContactResponse`] |
//! | m̄ in a time loop, without allocation | [`Workspace`] |
//! | one contact at many configurations; gradients and Λ⁻¹ of each | [`Batch`] |
//! | many contacts of a link at one pose | [`ContactMap`] |
//! | M, A, j for another solver; m̄ from its matrices | [`Pose::mass_matrix`], [`Pose::constraint_matrix`], [`Pose::contact_row`]; [`effective_mass()`], [`RegularMatrices`] |
//! | gradient of m̄ | [`Pose::effective_mass_gradient`] |
//! | impacts | [`impact::state_impact`] and its module |
//! | contact laws, safe speeds, parameters of simulators | [`contact`] |
//! | positions of MuJoCo | [`QposLayout`] |
//! | proved bounds | [`Pose::certify`] |
//!
//! # Steps of the computation
//!
//! Each step is an immutable value: [`System`] (a mechanism under [`Conditions`]) → [`Assembly`] (loops closed) → [`Pose`] →
//! [`ContactResponse`] (m̄, its error, velocities, shares of the links). For many configurations or contacts:
//! [`Workspace`], [`Batch`], [`ContactMap`]. For matrices of another solver: [`effective_mass()`].
//!
//! [`impact`] has rigid impacts: impulses, rates after the impact, and the reactions in all joints and loops. [`contact`] has
//! the contact laws and the parameters of simulators. Matrices and vectors are those of [`nalgebra`], which is
//! re-exported. Every type has one name; [`prelude`] has those of most programs. The guide `docs/howto/RUST.md` of the repository has more examples.

// Links to the pages of the crates, not copies: a copy shows `Matrix<f64, Const<3>, Const<1>, ArrayStorage<f64, 3, 1>>` where the
// crate's own page has `Vector3<f64>`, since compiled crates do not keep the names of type aliases.
pub use nalgebra;
pub use percuss_contact as contact;
mod error;
pub mod prelude;
pub use error::Error;
#[doc(no_inline)]
pub use percuss_dynamics::{
    Accelerations, Assembly, AssemblyError, Base, Batch, BatchAnswer, BatchContacts, BatchError,
    BatchPositions, BatchRows, BranchLimits, BranchProof, CertifiedTree, ComplianceError, ConditionOfJoint,
    Conditions, ConditionsError, Configuration, ConfigurationError, ConstraintAction, ConstraintGroup,
    ConstraintRank, ConstraintSource, Contact, ContactColumns, ContactError, ContactMap, ContactPart,
    ContactResponse, ContactStatus, Contributions, DenseReason, DepartingAxis, DeterminedSystem, Direction,
    DrawnGap, DrivenPath, EffectiveMass, ElasticDirection, ElasticInput, ElasticMotion, ElasticOutput,
    ElasticRowOutput, ElasticSystem, ElementMotion, ErrorBudget, ExtremeBracket, ExtremesCertificate, Frame,
    Gap, GivenPositions, InverseOperationalInertia, JointForce, LayoutError, LinearElement, Load,
    LocatedContact, LoopState, LowestPoint, MapAnswers, MapError, MassCertificate, MassGradient, MatrixError,
    MatrixName, MatrixOptions, MatrixResponse, MatrixView, Mode, NearbyDesigns, NoCertificate, PathAnswer,
    PointForce, PointVelocity, Pose, PoseCondition, PoseRank, PrincipalMass, RangeProof, Receptance,
    RegularMatrices, Remark, RemarkFlags, ResidualCompliance, ResponseAtPose, ResponseError, RigidLoops,
    Route, RouteChoice, RouteError, RowAnswer, RowColumns, RowHandler, RowPath, RowResults, RowShare,
    Singularity, StateSizeError, StaticDisplacement, StaticSystem, System, Travel, TravelError, Workspace,
    WorkspaceResponse, effective_mass, input, interruption,
};
#[cfg(feature = "urdf-rs")]
#[doc(no_inline)]
pub use percuss_formats::from_urdf_rs;
#[doc(no_inline)]
pub use percuss_formats::{
    Change, Comments, DEFAULT_MAX_MESH_SIZE, DEFAULT_MAX_SIZE, Diagnostic, Effect, Facet, FileKind,
    FileStore, FileSystem, FindMesh, ImpactContact, ImpactSurfaces, LoadError, LoadOptions, Loaded,
    MechanismState, MemoryFiles, MeshError, MeshFile, MeshFolders, MjcfError, MjcfImpact, ModelParts,
    ModelText, NOT_READ, NamedPose, OpenFile, Orientation, Purpose, QposError, QposLayout, SdfError, Shape,
    SharedFiles, Solid, Source, Surface, SurfaceError, Triangles, balance_inertia, inertia_of_shapes, load,
    load_file, lost_pose, read_mesh, write_mjcf, write_mjcf_impact, write_sdf, write_urdf, write_urdf_model,
    write_urdf_with,
};
pub use percuss_impact as impact;
pub use percuss_mechanism as mechanism;
#[doc(no_inline)]
pub use percuss_mechanism::{
    Accept, BuildError, Built, Bush, BushDescription, Closure, ClosureDescription, ClosureId, ClosureKind,
    ContactDescription, ContactKind, ContactNormal, Coupling, CouplingDescription, Curve, CurveDescription,
    ElasticGear, Geometry, Inertial, Joint, JointDescription, JointId, JointKind, Limits, Link,
    LinkDescription, LinkId, LinkRatio, LoopFrame, Mechanism, MechanismBuilder, Mimic, MimicDescription,
    NameKind, NamedContact, Problem, RelationDescription, Severity, SpringDamper, Subject, UnknownName,
};
pub use percuss_spatial as spatial;
#[cfg(feature = "study")]
pub use percuss_study as study;
#[cfg(feature = "suspension")]
pub use percuss_suspension as suspension;

/// Rust of the book, compiled by the tests of the documentation.
#[cfg(all(doctest, feature = "study"))]
#[doc = include_str!("../../../docs/tutorials/SUSPENSION.md")]
struct Book;
