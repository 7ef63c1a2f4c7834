//! A sweep as it stands in JSON: what is the same for all rows, the rows, and the whole.

use crate::model::Input;
use crate::positions::{PoseLayout, Positions};
use crate::record::DiagnosticRecord;
use crate::varied_values::{VariedColumn, VariedValues};
use serde::Serialize;
use std::sync::Arc;

/// Which rows of a sweep were followed from one another: loops are closed on the branch of the row before. Where nothing
/// closes a loop, no row depends on another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Continuation {
    /// All rows are one path: each is followed from the last one that was reached.
    Path,
    /// Each line of a grid is a path of its own, along what is varied fastest.
    Lines,
    /// Each row is answered by itself, as `percuss mass` would.
    Independent,
}

/// What is the same for all rows.
#[derive(Clone, Debug, Serialize)]
pub struct SweepHeading {
    /// `percuss.sweep/2`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The files: the model's, the study's, and that of the positions.
    pub inputs: Vec<Input>,
    /// What is varied: of a grid the slowest first.
    pub varied: Vec<VariedColumn>,
    /// Which rows were followed from one another.
    pub continuation: Continuation,
    /// The seed of random positions; null where they are not random.
    pub seed: Option<u64>,
    /// The struck link.
    pub link: String,
    /// The joints of every row's pose.
    #[serde(skip)]
    pub joints: Arc<PoseLayout>,
}

/// A row of a sweep.
#[derive(Clone, Debug, Serialize)]
pub struct SweepRow {
    /// Its number, from 0.
    pub row: usize,
    /// The varied numbers, rad or m, by name.
    pub varied: VariedValues,
    /// `finite`, `immovable`, `massless`; `unreachable` where the pose does not exist; `no answer`.
    pub status: &'static str,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// First-order bound on its error, kg.
    pub effective_mass_error: Option<f64>,
    /// How far loops are from closed, m; null without loops.
    pub closure_residual: Option<f64>,
    /// Whether the pose is singular.
    pub singular_pose: Option<bool>,
    /// Point A's speed per unit closing speed: of the estimate, or of the travelling point along its direction.
    pub motion_ratio: Option<f64>,
    /// The classical estimate, kg.
    pub estimate: Option<f64>,
    /// By how much it is off, per cent.
    pub estimate_error_percent: Option<f64>,
    /// Position of every movable joint; empty where the pose was not reached.
    pub pose: Positions,
    /// Why there is no answer.
    pub error: Option<String>,
}

/// How a sweep ended.
#[derive(Clone, Debug)]
pub struct SweepEnd {
    /// How many rows there are.
    pub rows: usize,
    /// How many of them have no answer.
    pub unanswered: usize,
    /// Why the first of those has none.
    pub first_error: Option<String>,
    /// What was found in the rows, each thing once; what was found in the file is the model's.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// A sweep with all its rows.
#[derive(Clone, Debug, Serialize)]
pub struct SweepReport {
    /// What is the same for all rows.
    #[serde(flatten)]
    pub heading: SweepHeading,
    /// All rows.
    pub rows: Vec<SweepRow>,
    /// What was found, in the file and in the rows.
    pub diagnostics: Vec<DiagnosticRecord>,
}
