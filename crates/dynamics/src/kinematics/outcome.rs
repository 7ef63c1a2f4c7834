//! Results of a contact query: effective mass, route, remarks and errors.

use crate::kinematics::contact::ContactError;
use crate::model::input::QUATERNION_TOLERANCE;
use crate::model::velocities::StateSizeError;
use crate::tolerances::MEGABYTE;
use percuss_mechanism::JointId;
use std::fmt;

/// Resistance of the mechanism to the contact along its normal.
#[must_use]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EffectiveMass {
    /// m̄, kg.
    Finite(f64),
    /// No admissible motion closes the gap.
    Immovable,
    /// A motion without kinetic energy closes the gap: m̄ = 0.
    Massless,
}

impl EffectiveMass {
    /// m̄ in kilograms; `None` if the contact is immovable or massless. For a moment about an axis, the number is in kg·m²: see
    /// [`value`](Self::value).
    pub fn kilograms(self) -> Option<f64> {
        self.value()
    }

    /// m̄ in the unit of the contact ([`ContactResponse::unit`](crate::ContactResponse::unit)): kg, or kg·m² for a moment about an axis; `None`
    /// if the contact is immovable or massless.
    pub fn value(self) -> Option<f64> {
        match self {
            EffectiveMass::Finite(m) => Some(m),
            EffectiveMass::Immovable | EffectiveMass::Massless => None,
        }
    }

    /// Effective mass against a free body of mass `other` (kg) on the other side: 1/m̄ = 1/m̄₁ + 1/m₂. Unchanged if
    /// `other` is `None`.
    ///
    /// An immovable mechanism gives m̄ = m₂; a massless mechanism stays massless. `other` must be finite and > 0.
    pub fn against_mass(self, other: Option<f64>) -> Self {
        match (self, other) {
            (EffectiveMass::Finite(own), Some(other)) => EffectiveMass::Finite(own / (1.0 + own / other)),
            (EffectiveMass::Immovable, Some(other)) => EffectiveMass::Finite(other),
            (mass, _) => mass,
        }
    }
}

impl fmt::Display for EffectiveMass {
    /// `2.5 kg`, `immovable` or `massless`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EffectiveMass::Finite(m) => {
                fmt::Display::fmt(m, f)?;
                f.write_str(" kg")
            }
            EffectiveMass::Immovable => f.write_str("immovable"),
            EffectiveMass::Massless => f.write_str("massless"),
        }
    }
}

/// Computation method of m̄.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// Dense route: mass matrix, kernel of the constraints, least energy; O(n³).
    Dense,
    /// Articulated-body recursion over clusters; O(n).
    Articulated,
}

/// Choice of the route.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RouteChoice {
    /// The recursion where it is accurate, otherwise the dense route.
    #[default]
    Auto,
    /// The given route only; an error states why the route is not possible.
    Only(Route),
}

/// Reason for running the dense route in addition to the recursion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DenseReason {
    /// The recursion finds a motion of negative mass (accepted indefinite inertias).
    NegativeMass,
    /// The recursion finds the contact massless. A sum of possibly large terms was classified as zero.
    Massless,
    /// The rounding error of the recursion may exceed 1e-11.
    Error {
        /// Estimated rounding error, relative to m̄.
        relative: f64,
    },
}

/// Reason for a route to refuse a mechanism.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RouteError {
    /// A motion has a negative mass.
    #[error(
        "the articulated route found a motion with negative mass (accepted indefinite inertias); use the dense route"
    )]
    Indefinite,
    /// The mechanism has more coordinates than the dense route accepts.
    #[error("the dense route is limited to {limit} coordinates; this mechanism has {coordinates}")]
    TooLarge {
        /// Number of coordinates.
        coordinates: usize,
        /// Largest accepted number.
        limit: usize,
    },
    /// The bodies of a cluster (bound by loops) have so many degrees of freedom that the cluster matrices exceed the
    /// memory limit.
    #[error(
        "the bodies bound together by {} have {freedoms} freedoms over {coordinates} coordinates: the recursion's matrices \
         would take {:.0} MB and {work:.0e} multiplications in all, of at most {:.0} MB and {most_work:.0e}; lock joints \
         that hardly move (--lock), or model a long chain inside a loop with fewer links",
        quoted(loops), bytes / MEGABYTE, most_bytes / MEGABYTE
    )]
    ClusterTooLarge {
        /// Loops, couplings and held contacts of the largest cluster of bodies; empty if mimics bind the cluster.
        loops: Vec<String>,
        /// Number of coordinates of the cluster.
        coordinates: usize,
        /// Number of independent coordinates of the cluster.
        freedoms: usize,
        /// Memory needed for the matrices of all clusters, bytes.
        bytes: f64,
        /// Memory limit, bytes.
        most_bytes: f64,
        /// Number of multiplications needed.
        work: f64,
        /// Largest accepted number of multiplications.
        most_work: f64,
    },
    /// Accepted indefinite inertias give no positive mass at the contact.
    #[error(
        "the mass matrix is indefinite and the effective mass is {value} kg: inertias with negative moments are \
         not valid here"
    )]
    IndefiniteMass {
        /// The stationary value of the energy, kg.
        value: f64,
    },
    /// Forward dynamics supports open chains only.
    #[error("accelerations are found for open chains; here {what} bind the joints")]
    Bound {
        /// `loops`, `held contacts` or `mimics`.
        what: &'static str,
    },
    /// A joint moves no mass.
    #[error(
        "a joint moves no mass (least pivot {least_pivot:.1e} of its terms): its acceleration is undetermined"
    )]
    SingularPivot {
        /// Smallest pivot relative to the size of its terms.
        least_pivot: f64,
    },
    /// The velocities do not fit the mechanism.
    #[error(transparent)]
    Velocities(#[from] StateSizeError),
    /// A link handle of another mechanism.
    #[error(
        "link number {index} is not in this mechanism, which has {links} links; look up the link by name"
    )]
    ForeignLink {
        /// Index of the handle.
        index: usize,
        /// Number of links of this mechanism.
        links: usize,
    },
    /// The accelerations belong to another mechanism.
    #[error(
        "the accelerations are of {got} bodies, this mechanism has {expected}; compute them with a pose of this \
         mechanism"
    )]
    ForeignAccelerations {
        /// Number of bodies of the accelerations.
        got: usize,
        /// Number of bodies of this mechanism.
        expected: usize,
    },
    /// Φ or 1/m̄ is infinite: a motion without mass responds to a wrench.
    #[error("a wrench on this link causes a motion without mass: J M⁻¹ Jᵀ is infinite")]
    MasslessMotion,
}

/// Error of a contact query.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ResponseError {
    /// The contact is invalid.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The route refuses the mechanism.
    #[error(transparent)]
    Route(#[from] RouteError),
    /// A position in a workspace is not a valid number.
    #[error(
        "position {index} (from 0, of all joints in joint order) is {value:e}; expected a finite number of at most 1e100"
    )]
    NotFinite {
        /// Index of the position.
        index: usize,
        /// The value: NaN, infinite or too large.
        value: f64,
    },
    /// A quaternion in a workspace is not of unit length.
    #[error(
        "joint \"{joint}\": the quaternion w,x,y,z has norm {norm}; expected a unit quaternion, 1 ± {QUATERNION_TOLERANCE}: \
         divide it by its norm"
    )]
    Quaternion {
        /// The joint.
        joint: String,
        /// Norm of the quaternion.
        norm: f64,
    },
    /// Loops are open at the positions in a workspace.
    #[error(
        "{} is open by {gap:.3e} m at these positions; expected closed loops, to {tolerance:.1e} m: give the positions of a \
         pose of this assembly, or the driving joints to a pose, which closes the loops",
        quoted(loops)
    )]
    OpenLoops {
        /// Loops and couplings of the group, the largest residual first.
        loops: Vec<String>,
        /// Largest residual, m.
        gap: f64,
        /// Largest accepted residual, m.
        tolerance: f64,
    },
}

/// Finding about a result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Remark {
    /// The gap almost cannot close: m̄ is large and uncertain.
    NearlyImmovable {
        /// Closing speed relative to the size of its terms.
        closing_speed: f64,
        /// Resulting relative uncertainty of m̄.
        uncertainty: f64,
    },
    /// Some motions have no mass. A finite m̄ does not depend on these motions.
    MasslessMotions {
        /// Number of massless directions.
        directions: usize,
    },
    /// The contact is massless only within rounding. Masses lost in sums with larger masses may be present.
    MasslessToRounding {
        /// Upper limit of m̄, kg.
        up_to: f64,
    },
    /// v* is not unique because a motion has no mass; m̄ and the contributions are unique.
    UndeterminedMotion,
    /// The rank of the constraints is unclear, because the pose is close to a crossing of branches.
    UnclearRank {
        /// Ratio of the smallest nonzero singular value to the largest zero one.
        gap: f64,
    },
    /// M has negative directions (accepted indefinite inertias). m̄ is a stationary value, not a minimum.
    IndefiniteMassMatrix,
    /// The pose is in another assembly mode than the first closed pose; the configuration accepts other modes.
    OtherAssembly {
        /// Number of seeded starts until the pose was found.
        starts: usize,
    },
    /// A loop as drawn is open by more than a hundredth of its size; a point may be mistyped. The remark gives the
    /// widest gap; [`Assembly::drawn_gaps`](crate::Assembly::drawn_gaps) lists all gaps.
    DrawnOpen {
        /// Gap of the loop, m.
        gap: f64,
        /// Size of its group of loops, m.
        size: f64,
    },
    /// The loops contradict one another by rounding and are closed in the least-squares sense.
    InexactLoops {
        /// Remaining misfit of the loops, m.
        inexactness: f64,
    },
    /// A driving joint was not set, and its position 0 cannot be reached.
    DriverOffZero {
        /// The joint.
        joint: JointId,
        /// Position of the joint, rad or m.
        value: f64,
    },
    /// A joint was set to more values than its loops leave degrees of freedom.
    OffTarget {
        /// The joint.
        joint: JointId,
        /// Distance from the given position, rad or m.
        distance: f64,
    },
    /// A joint is outside its limits.
    OutsideLimits {
        /// The joint.
        joint: JointId,
        /// Position of the joint, rad or m.
        value: f64,
        /// True for a hinge more than a turn from 0: the number is probably in degrees.
        many_turns: bool,
    },
    /// The contact has a gap in the model, which is open at the pose: an impact occurs at the touch, with the m̄ there.
    OpenGap {
        /// The gap, m.
        gap: f64,
    },
    /// The mechanism is weakly constrained: a small error in the figures of a file can free one more motion.
    WeaklyConstrained {
        /// Smallest nonzero singular value of A at a generic pose, relative to the largest.
        least: f64,
    },
    /// The generic rank of the constraints is unclear; the mobility may differ.
    UnclearMobility {
        /// Ratio of the smallest nonzero singular value to the largest zero one.
        gap: f64,
    },
    /// The normal is given in the world and the base floats, but no base pose was given. The root link is taken to be
    /// at the world's origin.
    BaseNotGiven,
}

/// Names of joints in quotation marks, for messages: at most six, then the number of the others. `mimics` if empty.
fn quoted(names: &[String]) -> String {
    if names.is_empty() {
        return "mimics".into();
    }
    let shown = names.iter().take(6).map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ");
    if names.len() > 6 { format!("{shown} and {} more", names.len() - 6) } else { shown }
}
