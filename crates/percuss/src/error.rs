//! One error for programs that call several steps.

use crate::{contact, impact};

/// Any error of percuss except those of studies and suspensions: `?` converts all others.
///
/// ```
/// use percuss::prelude::*;
///
/// fn mass(path: &str) -> Result<Option<f64>, percuss::Error> {
///     let mechanism = load_file(path)?.mechanism;
///     let contact = Contact::new(mechanism.find_link("coupler")?, [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
///     let system = System::new(mechanism, &Conditions::new())?;
///     Ok(system.pose(&system.configuration())?.respond(&contact)?.effective_mass.kilograms())
/// }
/// assert!(mass("../../models/four_bar.urdf").is_ok());
/// assert!(matches!(mass("no/such/file.urdf"), Err(percuss::Error::Load(_))));
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Loops that do not close.
    #[error(transparent)]
    Assembly(#[from] crate::AssemblyError),
    /// Rows of a batch.
    #[error(transparent)]
    Batch(#[from] crate::BatchError),
    /// A mechanism that cannot be built.
    #[error(transparent)]
    Build(#[from] crate::BuildError),
    /// Bushes, springs and gears.
    #[error(transparent)]
    Compliance(#[from] crate::ComplianceError),
    /// Base, locks, held points.
    #[error(transparent)]
    Conditions(#[from] crate::ConditionsError),
    /// Positions of joints.
    #[error(transparent)]
    Configuration(#[from] crate::ConfigurationError),
    /// A contact that does not exist.
    #[error(transparent)]
    Contact(#[from] crate::ContactError),
    /// Numbers of the caller's matrices.
    #[error(transparent)]
    Layout(#[from] crate::LayoutError),
    /// A file.
    #[error(transparent)]
    Load(#[from] crate::LoadError),
    /// Contacts of one link.
    #[error(transparent)]
    Map(#[from] crate::MapError),
    /// Matrices of another solver.
    #[error(transparent)]
    Matrix(#[from] crate::MatrixError),
    /// A mesh.
    #[error(transparent)]
    Mesh(#[from] crate::MeshError),
    /// A mechanism that MJCF cannot express.
    #[error(transparent)]
    Mjcf(#[from] crate::MjcfError),
    /// No proof.
    #[error(transparent)]
    Certificate(#[from] crate::NoCertificate),
    /// Positions of MuJoCo.
    #[error(transparent)]
    Qpos(#[from] crate::QposError),
    /// m̄ of a contact.
    #[error(transparent)]
    Response(#[from] crate::ResponseError),
    /// A route of the computation.
    #[error(transparent)]
    Route(#[from] crate::RouteError),
    /// A mechanism that SDFormat cannot express.
    #[error(transparent)]
    Sdf(#[from] crate::SdfError),
    /// Arrays of a state.
    #[error(transparent)]
    StateSize(#[from] crate::StateSizeError),
    /// Shapes of a link.
    #[error(transparent)]
    Surface(#[from] crate::SurfaceError),
    /// A length to be reached.
    #[error(transparent)]
    Travel(#[from] crate::TravelError),
    /// A name that the model does not have.
    #[error(transparent)]
    Name(#[from] crate::UnknownName),
    /// Several contacts.
    #[error(transparent)]
    Delassus(#[from] impact::DelassusError),
    /// A search over positions.
    #[error(transparent)]
    Extremes(#[from] impact::ExtremesError),
    /// A rigid impact.
    #[error(transparent)]
    Impact(#[from] impact::ImpactError),
    /// A centre of percussion.
    #[error(transparent)]
    Percussion(#[from] impact::PercussionError),
    /// A range of positions.
    #[error(transparent)]
    Range(#[from] impact::RangeError),
    /// Rates of drivers.
    #[error(transparent)]
    Rates(#[from] impact::RatesError),
    /// Reactions of joints.
    #[error(transparent)]
    Reaction(#[from] impact::ReactionError),
    /// Inertia at a joint.
    #[error(transparent)]
    Reflected(#[from] impact::ReflectedError),
    /// A contact law.
    #[error(transparent)]
    Law(#[from] contact::ContactLawError),
}
