//! Report of a sweep in JSON: heading, rows, and the full report.

use crate::model::loading::Input;
use crate::model::record::DiagnosticRecord;
use crate::pose::positions::{PoseLayout, Positions};
use crate::question::travel::varied_values::{VariedColumn, VariedValues};
use crate::sweep::row_gradient::{GradientLayout, RowGradient};
use percuss_units::LengthUnit;
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::Arc;

/// Continuation of the rows of a sweep: loops are closed on the branch of the preceding row. Without loops no
/// row depends on another row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Continuation {
    /// All rows form one path: each row continues from the last row reached.
    Path,
    /// Each line of a grid, along the fastest range, is a separate path.
    Lines,
    /// Each row is evaluated separately, as by `percuss mass`.
    Independent,
}

/// Heading of a sweep: data common to all rows.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SweepHeading {
    /// `percuss.sweep/2`.
    #[schemars(extend("const" = "percuss.sweep/2"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files: model, study, and file of positions.
    pub inputs: Vec<Input>,
    /// Varied columns; for a grid the slowest range is first.
    pub varied: Vec<VariedColumn>,
    /// Continuation of the rows.
    pub continuation: Continuation,
    /// Seed of the random positions; null without random positions.
    pub seed: Option<u64>,
    /// Contact link.
    pub link: String,
    /// Unit of all effective masses: `kg`; `kg·m²` for a moment about an axis, and for the stop of a revolute joint.
    pub unit: &'static str,
    /// Named contact, for the title of a figure.
    #[serde(skip)]
    pub contact: Option<String>,
    /// Travel of the motion ratio: the name of the varied travel, or `estimate` for the point of the estimate. The ratio of one point
    /// holds for the motion of the impact (with a sliding rack held, and without spin of a wheel with the contact on it). The ratio of
    /// `heave` or `roll` holds for this motion of the wheels, per upward travel of the wheel on the side of the contact. The key is
    /// absent without a motion ratio.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion_ratio_of: Option<String>,
    /// Joints of the pose of each row.
    #[serde(skip)]
    pub joints: Arc<PoseLayout>,
    /// True if the contact is a named contact with a gap; the rows then contain it.
    #[serde(skip)]
    pub has_gap: bool,
    /// Unit of lengths in figures.
    #[serde(skip)]
    pub length_unit: LengthUnit,
    /// Joints of the gradient of each row; `None` without gradients.
    #[serde(skip)]
    pub gradient: Option<Arc<GradientLayout>>,
}

/// A row of a sweep.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SweepRow {
    /// Number of the row, from 0.
    pub row: usize,
    /// The varied numbers, rad or m, by name.
    pub varied: VariedValues,
    /// `finite`, `immovable`, `massless`; `unreachable` if the pose does not exist; `no answer`.
    pub status: &'static str,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// First-order error bound of m̄, kg.
    pub effective_mass_error: Option<f64>,
    /// Closure residual of the loops, m; null without loops.
    pub closure_residual: Option<f64>,
    /// True if the pose is singular.
    pub singular_pose: Option<bool>,
    /// Motion ratio: closing of the contact per travel of the point along its direction; without a travel, per travel of the
    /// estimate's point.
    pub motion_ratio: Option<f64>,
    /// The classical estimate, kg.
    pub estimate: Option<f64>,
    /// Difference of the estimate from m̄, per cent.
    pub estimate_error_percent: Option<f64>,
    /// Gap of the named contact at the pose of the row, m, negative for a penetration; null without a pose. The key is absent
    /// for a contact without a gap.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<Option<f64>>,
    /// Gradient of m̄, one number per velocity of every movable joint, kg/rad or kg/m; empty unless m̄ is finite. The key is absent unless
    /// gradients are requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gradient: Option<RowGradient>,
    /// Position of every movable joint; empty if the pose was not reached.
    pub pose: Positions,
    /// Reason for a missing result.
    pub error: Option<String>,
}

/// End of a sweep.
#[derive(Clone, Debug)]
pub struct SweepEnd {
    /// Number of rows.
    pub rows: usize,
    /// Number of rows without a result.
    pub rows_without_result: usize,
    /// Reason for the first row without a result.
    pub first_error: Option<String>,
    /// Findings about the rows, each reported once. Findings about the file belong to the model.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// A sweep with all its rows.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SweepReport {
    /// Heading: data common to all rows.
    #[serde(flatten)]
    pub heading: SweepHeading,
    /// All rows.
    pub rows: Vec<SweepRow>,
    /// Findings about the file and the rows.
    pub diagnostics: Vec<DiagnosticRecord>,
}
