//! What is answered to a contact, and why something is not.

use crate::contact::ContactError;
use crate::input::QUATERNION_TOLERANCE;
use crate::velocities::VelocityError;
use percuss_mechanism::JointId;

/// What the mechanism opposes to the contact along its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EffectiveMass {
    /// m̄, kg.
    Finite(f64),
    /// No admissible motion closes the gap.
    Immovable,
    /// A motion without energy closes the gap: m̄ = 0.
    Massless,
}

impl EffectiveMass {
    /// The same where the other side is a free mass (kg) of its own, if it is: 1/m̄ = 1/m̄₁ + 1/m₂.
    ///
    /// An immovable mechanism leaves m̄ = m₂; a massless one stays massless. `other` must be finite and > 0.
    pub fn against_mass(self, other: Option<f64>) -> Self {
        match (self, other) {
            (EffectiveMass::Finite(own), Some(other)) => EffectiveMass::Finite(own / (1.0 + own / other)),
            (EffectiveMass::Immovable, Some(other)) => EffectiveMass::Finite(other),
            (mass, _) => mass,
        }
    }
}

/// How m̄ was computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// Mass matrix, kernel of the constraints, least energy: the careful route, O(n³).
    Dense,
    /// Articulated recursion over clusters: O(n).
    Articulated,
}

/// Which route to take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RouteChoice {
    /// The recursion where it is accurate, else the careful route.
    #[default]
    Auto,
    /// This one, or an error that says why not.
    Only(Route),
}

/// Why the careful route was asked beside the recursion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CarefulReason {
    /// The recursion meets a motion of negative mass (accepted indefinite inertias).
    NegativeMass,
    /// The recursion finds the contact massless: a sum is taken for zero against terms that may be large.
    Massless,
    /// The recursion's answer may be off by more than 1e-11 by rounding.
    Error {
        /// What its rounding may amount to, relative to m̄.
        relative: f64,
    },
}

/// Why a route does not take a mechanism.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RouteError {
    /// Some motion has a negative mass.
    #[error(
        "the articulated route meets a motion of negative mass (accepted indefinite inertias); the dense route takes it"
    )]
    Indefinite,
    /// The dense route has a limit.
    #[error("the dense route takes up to {limit} coordinates; this mechanism has {coordinates}")]
    TooLarge {
        /// How many there are.
        coordinates: usize,
        /// How many it takes.
        limit: usize,
    },
    /// Bodies bound together by loops have so many freedoms that their matrices would not fit into memory.
    #[error(
        "the bodies bound together by {} have {freedoms} freedoms over {coordinates} coordinates: the recursion's matrices \
         would take {:.0} MB and {work:.0e} multiplications in all, of at most {:.0} MB and {most_work:.0e}; lock joints \
         that hardly move (--lock), or model a long chain inside a loop with fewer links",
        quoted(loops), bytes / 1e6, most_bytes / 1e6
    )]
    ClusterTooLarge {
        /// The loops, couplings and held contacts of the largest cluster of bodies; none where mimics bind it.
        loops: Vec<String>,
        /// How many coordinates it has.
        coordinates: usize,
        /// How many of them are independent.
        freedoms: usize,
        /// What the matrices of all clusters would take, bytes.
        bytes: f64,
        /// What they may take, bytes.
        most_bytes: f64,
        /// Multiplications that they would take.
        work: f64,
        /// Multiplications that they may take.
        most_work: f64,
    },
    /// Accepted indefinite inertias leave no positive mass at the contact.
    #[error(
        "the mass matrix is indefinite and the contact's effective mass comes out as {value} kg: \
         inertias with negative moments have no meaning here"
    )]
    IndefiniteMass {
        /// The stationary value, kg.
        value: f64,
    },
    /// Forward dynamics go along open chains.
    #[error("accelerations are found for open chains; here {what} bind the joints")]
    Bound {
        /// `loops`, `held contacts` or `mimics`.
        what: &'static str,
    },
    /// A joint moves no mass.
    #[error("a joint moves no mass (least pivot {least_pivot:.1e} of its terms): its acceleration is open")]
    SingularPivot {
        /// Smallest pivot relative to the size of its terms.
        least_pivot: f64,
    },
    /// Velocities that are not the mechanism's.
    #[error(transparent)]
    Velocities(#[from] VelocityError),
    /// A handle of another mechanism.
    #[error(
        "link number {index} is not of this mechanism, which has {links} links; ask it for the link by name"
    )]
    ForeignLink {
        /// The handle's number.
        index: usize,
        /// How many links this mechanism has.
        links: usize,
    },
    /// Accelerations of another mechanism.
    #[error(
        "the accelerations are of {got} bodies, this mechanism has {expected}; ask a pose of its own for them"
    )]
    ForeignAccelerations {
        /// Of how many bodies they are.
        got: usize,
        /// How many this mechanism has.
        expected: usize,
    },
    /// Φ, or 1/m̄, is not defined where a motion without mass answers a wrench.
    #[error("a motion without mass answers a wrench on this link: J M⁻¹ Jᵀ is infinite")]
    MasslessMotion,
}

/// Why a contact has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ResponseError {
    /// The contact means nothing.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The route does not take the mechanism.
    #[error(transparent)]
    Route(#[from] RouteError),
    /// A workspace stands at a position that is no number.
    #[error(
        "position {index} (from 0, of all joints in joint order) is {value:e}; expected a finite number of at most 1e100"
    )]
    NotFinite {
        /// Its number.
        index: usize,
        /// NaN, infinite or too large.
        value: f64,
    },
    /// A workspace is given a quaternion that is not of unit length.
    #[error(
        "joint \"{joint}\": the quaternion w,x,y,z has norm {norm}; expected a unit quaternion, 1 ± {QUATERNION_TOLERANCE}: \
         divide it by its norm"
    )]
    Quaternion {
        /// The joint.
        joint: String,
        /// The norm of the quaternion.
        norm: f64,
    },
    /// A workspace is given positions at which loops are open.
    #[error(
        "{} is open by {gap:.3e} m at these positions; expected closed loops, to {tolerance:.1e} m: give the positions of a \
         pose of this assembly, or the driving joints to a pose, which closes the loops",
        quoted(loops)
    )]
    OpenLoops {
        /// The loops and couplings of the group, the worst first.
        loops: Vec<String>,
        /// The largest residual, m.
        gap: f64,
        /// What is accepted, m.
        tolerance: f64,
    },
}

/// Something about an answer that its reader should know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Remark {
    /// The gap hardly closes: the answer is large and uncertain.
    NearlyImmovable {
        /// Closing speed relative to the size of its terms.
        closing_speed: f64,
        /// Relative uncertainty of m̄ that follows.
        uncertainty: f64,
    },
    /// Some motions have no mass. They do not matter for a finite m̄.
    MasslessMotions {
        /// How many.
        directions: usize,
    },
    /// The contact is massless to rounding only: masses that were left out in sums of larger ones may be there.
    MasslessToRounding {
        /// What m̄ may be, kg.
        up_to: f64,
    },
    /// A motion without mass leaves v* open; m̄ and the contributions are not.
    UndeterminedMotion,
    /// The pose is so near to where branches cross that the rank of its constraints is unclear.
    UnclearRank {
        /// Between the singular values that count and those that do not.
        gap: f64,
    },
    /// M has negative directions (accepted indefinite inertias): m̄ is a stationary value, no minimum.
    IndefiniteMassMatrix,
    /// The pose is on another assembly mode than that of the first closed pose, as the configuration accepts.
    OtherAssembly {
        /// From how many seeded starts it was found.
        starts: usize,
    },
    /// A loop is open as drawn by more than a hundredth of its size: a point may be mistyped. The widest;
    /// [`Assembly::drawn_gaps`](crate::Assembly::drawn_gaps) has all.
    DrawnOpen {
        /// How far it is open, m.
        gap: f64,
        /// The size of its group of loops, m.
        size: f64,
    },
    /// The loops contradict one another by rounding: closed in least squares.
    InexactLoops {
        /// How far they are from fitting, m.
        inexactness: f64,
    },
    /// A driving joint was not set, and 0 is out of reach.
    DriverOffZero {
        /// The joint.
        joint: JointId,
        /// Its position, rad or m.
        value: f64,
    },
    /// A joint was set to more numbers than its loops leave degrees of freedom.
    OffTarget {
        /// The joint.
        joint: JointId,
        /// How far it is from there, rad or m.
        distance: f64,
    },
    /// A joint is outside its limits.
    OutsideLimits {
        /// The joint.
        joint: JointId,
        /// Its position, rad or m.
        value: f64,
    },
    /// A little off in the figures of a file, and the loops leave one motion more.
    WeaklyConstrained {
        /// The least singular value of A that counts at a generic pose, as a part of the largest.
        least: f64,
    },
    /// The generic rank of the constraints is unclear: the mobility may be another.
    UnclearMobility {
        /// Between the singular values that count and those that do not.
        gap: f64,
    },
    /// The normal is given in the world and the base floats, but the pose of the base was not given: it is taken at the
    /// world's origin.
    BaseNotGiven,
}

fn quoted(names: &[String]) -> String {
    if names.is_empty() {
        return "mimics".into();
    }
    let shown = names.iter().take(6).map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ");
    if names.len() > 6 { format!("{shown} and {} more", names.len() - 6) } else { shown }
}
