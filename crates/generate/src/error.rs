//! Reasons for which no function can be generated.

use percuss_dynamics::{AssemblyError, ResponseError};

/// Error of a function that cannot be generated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GenerateError {
    /// The contact is immovable in every configuration that was tried.
    #[error(
        "no motion of the mechanism closes this gap: the effective mass is unbounded in every configuration that was \
         tried. Give another normal; --mobility then gives 1/m along every normal"
    )]
    Immovable,
    /// A motion without mass closes the gap.
    #[error(
        "a motion without mass closes this gap: the effective mass is 0. Give the massless links a mass, or another \
         contact"
    )]
    Massless,
    /// A pivot of the mass matrix is not positive.
    #[error(
        "{joint}: its motion moves no mass or a negative mass ({value:.1e} relative to the mechanism); give the links \
         below this joint a mass, or the joint an armature"
    )]
    MasslessMotion {
        /// Joint, or the floating base.
        joint: String,
        /// Pivot relative to its length scale.
        value: f64,
    },
    /// The contact is a moment about an axis.
    #[error(
        "the contact is a moment about an axis, for which no code is generated; expected a contact point with a normal"
    )]
    Moment,
    /// The normal of a stop is a line that may turn by 5° only.
    #[error(
        "the normal is a line that may turn by at most 5°, which generated code does not check; give a fixed normal, or \
         permit the line to turn"
    )]
    LimitedLine,
    /// No choice of independent rows is valid in all samples.
    #[error(
        "the loops have {rank} independent constraint rows; only {found} rows were found that are independent in every \
         sampled configuration. Give another design pose by --set or --guess"
    )]
    NoIndependentRows {
        /// Rank of the constraints.
        rank: usize,
        /// Number of pivots found.
        found: usize,
    },
    /// Rows that the rank leaves out are not redundant.
    #[error(
        "the number of independent constraint rows is unclear: a row that counts as redundant has the residual \
         {residual:.1e} (relative to unit rates)"
    )]
    UnclearRank {
        /// Residual.
        residual: f64,
    },
    /// A closure of the kind distance has the length 0.
    #[error("loop \"{closure}\": a distance of 0 has no direction; use a spherical closure")]
    ZeroDistance {
        /// Closure.
        closure: String,
    },
    /// The function would be too long.
    #[error(
        "the function would have {operations} operations, more than {limit}: compilers take minutes for such a \
         function. Lock joints that do not move, or use the library"
    )]
    TooLong {
        /// Number of operations.
        operations: usize,
        /// Largest number.
        limit: usize,
    },
    /// The mechanism has no configuration in which the loops close.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// The library gives no result at the design pose.
    #[error(transparent)]
    Response(#[from] ResponseError),
    /// The generated expressions do not give the result of the library.
    #[error(
        "the expressions give {found} kg, the library {expected} kg (relative difference {difference:.1e}): the \
         mechanism is too badly conditioned for the plain elimination of the generated code"
    )]
    Disagreement {
        /// Value of the expressions, kg.
        found: f64,
        /// Value of the library, kg.
        expected: f64,
        /// Relative difference.
        difference: f64,
    },
    /// Branches cross at the design pose.
    #[error("branches of the loops cross at the design pose; give another pose by --set or --guess")]
    SingularPose,
    /// The option applies to loops only.
    #[error("--close: the mechanism has no loops that could be closed")]
    NoLoops,
    /// The drivers of the loops do not determine the other joints.
    #[error(
        "--close: the driving joints of the loops do not determine the other joints ({drivers}); set other driving \
         joints in the model (independent)"
    )]
    Drivers {
        /// Driving joints.
        drivers: String,
    },
}
