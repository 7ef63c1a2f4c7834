//! What is answered to a contact, and why something is not.

use crate::contact::ContactError;

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
}

/// Something about an answer that its reader should know.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
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
}
