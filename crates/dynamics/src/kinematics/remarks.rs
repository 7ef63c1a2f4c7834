//! Findings about a result, as flags and as text.

use crate::kinematics::outcome::{EffectiveMass, Remark, ResponseError};
use crate::tolerances::WARNED_RELATIVE_ERROR;
use std::fmt;
use std::ops::{BitOr, BitOrAssign};

/// Kinds of findings about a result, one bit each. The bits equal those of `PERCUSS_REMARK_…` in the C interface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RemarkFlags(u32);

impl RemarkFlags {
    /// No finding.
    pub const NONE: Self = Self(0);
    /// [`Remark::NearlyImmovable`].
    pub const NEARLY_IMMOVABLE: Self = Self(1);
    /// [`Remark::MasslessMotions`].
    pub const MASSLESS_MOTIONS: Self = Self(1 << 1);
    /// [`Remark::MasslessToRounding`].
    pub const MASSLESS_TO_ROUNDING: Self = Self(1 << 2);
    /// [`Remark::UndeterminedMotion`].
    pub const UNDETERMINED_MOTION: Self = Self(1 << 3);
    /// [`Remark::UnclearRank`].
    pub const UNCLEAR_RANK: Self = Self(1 << 4);
    /// [`Remark::IndefiniteMassMatrix`].
    pub const INDEFINITE_MASS_MATRIX: Self = Self(1 << 5);
    /// Branches cross at the pose: m̄ is a lower bound ([`ContactResponse::singular_pose`](crate::ContactResponse::singular_pose)).
    pub const SINGULAR_POSE: Self = Self(1 << 6);
    /// [`Remark::OtherAssembly`].
    pub const OTHER_ASSEMBLY: Self = Self(1 << 7);
    /// [`Remark::DrawnOpen`].
    pub const DRAWN_OPEN: Self = Self(1 << 8);
    /// [`Remark::InexactLoops`].
    pub const INEXACT_LOOPS: Self = Self(1 << 9);
    /// [`Remark::DriverOffZero`].
    pub const DRIVER_OFF_ZERO: Self = Self(1 << 10);
    /// [`Remark::OffTarget`].
    pub const OFF_TARGET: Self = Self(1 << 11);
    /// [`Remark::OutsideLimits`].
    pub const OUTSIDE_LIMITS: Self = Self(1 << 12);
    /// [`Remark::WeaklyConstrained`].
    pub const WEAKLY_CONSTRAINED: Self = Self(1 << 13);
    /// [`Remark::UnclearMobility`].
    pub const UNCLEAR_MOBILITY: Self = Self(1 << 14);
    /// [`Remark::BaseNotGiven`].
    pub const BASE_NOT_GIVEN: Self = Self(1 << 15);
    /// No result: a position is not finite.
    pub const NOT_FINITE: Self = Self(1 << 16);
    /// No result: a quaternion is not of unit length.
    pub const NOT_UNIT_QUATERNION: Self = Self(1 << 17);
    /// No result: the loops are open.
    pub const OPEN_LOOPS: Self = Self(1 << 18);
    /// No result for another reason; [`Workspace::effective_mass`](crate::Workspace::effective_mass) returns the
    /// error.
    pub const NO_ANSWER: Self = Self(1 << 19);
    /// The error of m̄ is above 1e-6 m̄.
    pub const UNCERTAIN_MASS: Self = Self(1 << 20);
    /// The error of a finite m̄ is unknown.
    pub const UNKNOWN_ERROR: Self = Self(1 << 21);
    /// [`Remark::OpenGap`].
    pub const OPEN_GAP: Self = Self(1 << 22);
    /// [`Remark::OutsideLimits`] with `many_turns`.
    pub const MANY_TURNS: Self = Self(1 << 23);

    /// Flags for the error of m̄, kg: [`UNCERTAIN_MASS`](Self::UNCERTAIN_MASS), [`UNKNOWN_ERROR`](Self::UNKNOWN_ERROR), or none.
    pub fn of_error(mass: EffectiveMass, error: Option<f64>) -> Self {
        let EffectiveMass::Finite(m) = mass else { return Self::NONE };
        // An absent error is NaN, which no comparison accepts.
        match error.unwrap_or(f64::NAN) {
            error if error <= WARNED_RELATIVE_ERROR * m => Self::NONE,
            error if error.is_finite() => Self::UNCERTAIN_MASS,
            _ => Self::UNKNOWN_ERROR,
        }
    }

    /// The flags as bits.
    pub const fn bits(self) -> u32 {
        self.0
    }

    /// Flags from [`bits`](Self::bits).
    pub const fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    /// True without findings.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// True if all flags of `other` are set.
    pub const fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }
}

impl BitOr for RemarkFlags {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl BitOrAssign for RemarkFlags {
    fn bitor_assign(&mut self, other: Self) {
        self.0 |= other.0;
    }
}

impl From<&Remark> for RemarkFlags {
    fn from(remark: &Remark) -> Self {
        match remark {
            Remark::NearlyImmovable { .. } => Self::NEARLY_IMMOVABLE,
            Remark::MasslessMotions { .. } => Self::MASSLESS_MOTIONS,
            Remark::MasslessToRounding { .. } => Self::MASSLESS_TO_ROUNDING,
            Remark::UndeterminedMotion => Self::UNDETERMINED_MOTION,
            Remark::UnclearRank { .. } => Self::UNCLEAR_RANK,
            Remark::IndefiniteMassMatrix => Self::INDEFINITE_MASS_MATRIX,
            Remark::OtherAssembly { .. } => Self::OTHER_ASSEMBLY,
            Remark::DrawnOpen { .. } => Self::DRAWN_OPEN,
            Remark::InexactLoops { .. } => Self::INEXACT_LOOPS,
            Remark::DriverOffZero { .. } => Self::DRIVER_OFF_ZERO,
            Remark::OffTarget { .. } => Self::OFF_TARGET,
            Remark::OutsideLimits { many_turns: false, .. } => Self::OUTSIDE_LIMITS,
            Remark::OutsideLimits { many_turns: true, .. } => Self::OUTSIDE_LIMITS | Self::MANY_TURNS,
            Remark::OpenGap { .. } => Self::OPEN_GAP,
            Remark::WeaklyConstrained { .. } => Self::WEAKLY_CONSTRAINED,
            Remark::UnclearMobility { .. } => Self::UNCLEAR_MOBILITY,
            Remark::BaseNotGiven => Self::BASE_NOT_GIVEN,
        }
    }
}

impl From<&ResponseError> for RemarkFlags {
    /// Flag for the reason of a missing result.
    fn from(error: &ResponseError) -> Self {
        match error {
            ResponseError::NotFinite { .. } => Self::NOT_FINITE,
            ResponseError::Quaternion { .. } => Self::NOT_UNIT_QUATERNION,
            ResponseError::OpenLoops { .. } => Self::OPEN_LOOPS,
            ResponseError::Contact(_) | ResponseError::Route(_) => Self::NO_ANSWER,
        }
    }
}

impl<'a> FromIterator<&'a Remark> for RemarkFlags {
    fn from_iter<I: IntoIterator<Item = &'a Remark>>(remarks: I) -> Self {
        remarks.into_iter().fold(Self::NONE, |all, remark| all | remark.into())
    }
}

impl fmt::Display for Remark {
    /// Writes one clause; joints are identified by their index.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NearlyImmovable { uncertainty, .. } => {
                write!(f, "nearly immovable: relative uncertainty {uncertainty:.1e}")
            }
            Self::MasslessMotions { directions } => write!(f, "{directions} motions have no mass"),
            Self::MasslessToRounding { up_to } => {
                write!(f, "massless within rounding: up to {up_to:.1e} kg")
            }
            Self::UndeterminedMotion => write!(f, "a motion without mass leaves the velocities undetermined"),
            Self::UnclearRank { gap } => write!(f, "the rank of the constraints is unclear: gap {gap:.1e}"),
            Self::IndefiniteMassMatrix => write!(f, "the mass matrix is indefinite: a stationary value"),
            Self::OtherAssembly { starts } => write!(
                f,
                "a different assembly mode than that of the first closed pose, found from {starts} of the \
                 seeded starts"
            ),
            Self::DrawnOpen { gap, size } => write!(
                f,
                "a loop is {gap:.3e} m open in the design pose, {:.1} % of its size: check its points for \
                 typing errors",
                100.0 * gap / size
            ),
            Self::InexactLoops { inexactness } => {
                write!(
                    f,
                    "the best fit of the loops leaves a gap of {inexactness:.2e} m, closed in the \
                    least-squares sense"
                )
            }
            Self::DriverOffZero { joint, value } => write!(
                f,
                "joint number {} is a driving joint without a given position; 0 cannot be reached, so it is at \
                 {value:.9}",
                joint.index()
            ),
            Self::OffTarget { joint, distance } => write!(
                f,
                "joint number {} was set to more values than the loops leave degrees of freedom: the nearest \
                 reachable position is used, {distance:.6} away",
                joint.index()
            ),
            Self::OutsideLimits { joint, value, many_turns } => {
                let hint = if *many_turns { "; it is in rad: were degrees given?" } else { "" };
                write!(f, "joint number {} is at {value}, outside its limits{hint}", joint.index())
            }
            Self::OpenGap { gap } => {
                write!(f, "the contact is {gap:.3e} m open at this pose; an impact occurs at the touch")
            }
            Self::WeaklyConstrained { least } => write!(
                f,
                "weakly constrained: the least singular value counted as nonzero is {least:.1e} of the largest"
            ),
            Self::UnclearMobility { gap } => {
                write!(f, "the generic rank of the constraints is unclear: gap {gap:.1e}")
            }
            Self::BaseNotGiven => write!(
                f,
                "the normal is given in the world and the base floats, but its pose was not given: it is at the world's origin"
            ),
        }
    }
}
