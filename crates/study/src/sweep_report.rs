//! A sweep as it stands in JSON: what is the same for all rows, the rows, and the whole.

use crate::model::Input;
use crate::positions::{PoseLayout, Positions};
use crate::record::DiagnosticRecord;
use serde::Serialize;
use std::sync::Arc;

/// What is the same for all rows.
#[derive(Clone, Debug, Serialize)]
pub struct SweepHeading {
    /// `percuss.sweep/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The file.
    pub inputs: Vec<Input>,
    /// What is varied.
    pub varied: String,
    /// `rad` or `m`.
    pub unit: &'static str,
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
    /// What is varied, rad or m.
    pub value: f64,
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
