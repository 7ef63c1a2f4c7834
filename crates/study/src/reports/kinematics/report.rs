//! Report of the kinematics of a suspension: one row per value of the variable.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::names::Names;
use crate::question::tables::kinematics::{KinematicVariable, KinematicsQuestion};
use crate::question::travel::moved::WheelMotion;
use crate::reports::kinematics::column_names::{column_name, is_of_every_contact, unknown_column};
use crate::reports::kinematics::errors::KinematicsError;
use crate::reports::kinematics::load_cases::KinematicLoads;
use crate::reports::kinematics::suspension_kinematics::SuspensionKinematics;
use crate::values::quantities::schema_of;
use crate::values::value::NumberOrText;
use nalgebra::DMatrix;
use percuss_contact::ForceCurve;
use percuss_suspension::LengthUnit;
use percuss_suspension::kinematics::{KinematicUnit, KinematicValue, KinematicValues};
use schemars::JsonSchema;
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Column of a report.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct KinematicColumn {
    /// Quantity.
    pub quantity: String,
    /// `left`, `right`, or empty for one wheel and for both together.
    pub side: &'static str,
    /// SI unit; empty for a plain number.
    #[serde(serialize_with = "si_unit")]
    #[schemars(with = "String")]
    pub unit: KinematicUnit,
    /// Reason for the absence of all values; null if a row has a value.
    pub missing: Option<String>,
}

/// Serializes the name of the SI unit.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "signature required by serde")]
fn si_unit<S: Serializer>(unit: &KinematicUnit, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(unit.si())
}

impl KinematicColumn {
    /// Name with the ending of the side.
    pub fn name(&self) -> String {
        if self.side.is_empty() { self.quantity.clone() } else { format!("{}_{}", self.quantity, self.side) }
    }
}

/// Row of a report.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsRow {
    /// Value of the variable, m; `None` for a single row.
    pub variable: Option<f64>,
    /// Values in the order of the columns, SI units.
    pub values: Vec<Option<f64>>,
    /// Reason for a missing pose.
    pub problem: Option<String>,
    columns: Arc<[KinematicColumn]>,
}

schema_of!(KinematicsRow, BTreeMap<String, Option<NumberOrText>>);

impl Serialize for KinematicsRow {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("variable", &self.variable)?;
        map.serialize_entry("problem", &self.problem)?;
        for (column, value) in self.columns.iter().zip(&self.values) {
            map.serialize_entry(&column.name(), value)?;
        }
        map.end()
    }
}

/// Kinematics of a suspension.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct KinematicsReport {
    /// `percuss.kinematics/1`.
    #[schemars(extend("const" = "percuss.kinematics/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Source files.
    pub inputs: Vec<Input>,
    /// Motion of the derivatives: `heave` (all wheels up) or `roll` (left up, right down).
    pub derivatives: &'static str,
    /// Variable of the rows; null for a single row.
    pub variable: Option<&'static str>,
    /// Loads of the motions per load; null without compliance.
    pub loads: Option<KinematicLoads>,
    /// Columns, without the variable.
    pub columns: Vec<KinematicColumn>,
    /// Rows.
    pub rows: Vec<KinematicsRow>,
    /// Compliance matrix of each row, empty without compliance: displacements (m) along x, y, z and rotations (rad) about them of the wheel
    /// centres per unit force (N) and moment (N·m), 6×6, or 12×12 with the left wheel first; null if a motion without stiffness gives way.
    pub compliance_matrices: Vec<Option<Vec<Vec<f64>>>>,
    /// Warnings and notes.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// True if the question names the columns.
    #[serde(skip)]
    pub is_selected: bool,
    /// Unit of lengths in tables and figures.
    #[serde(skip)]
    pub length_unit: LengthUnit,
}

impl KinematicsReport {
    /// Report with the named columns only, in the order of the names. A name without a side selects both sides; `CONTACT.QUANTITY` selects
    /// the column of a contact (`column_name`). Without names, the report keeps all columns.
    ///
    /// # Errors
    /// [`KinematicsError::Search`]: an unknown name, with the nearest.
    fn with_columns(mut self, names: &[String]) -> Result<Self, KinematicsError> {
        if names.is_empty() || self.columns.is_empty() {
            return Ok(self);
        }
        let mut chosen: Vec<usize> = Vec::new();
        for text in names {
            let name = column_name(text.trim());
            let is_named = |column: &KinematicColumn| {
                column.name() == name
                    || column.quantity == name
                    || is_of_every_contact(&name, &column.quantity)
            };
            let found: Vec<usize> = (0..self.columns.len())
                .filter(|i| is_named(&self.columns[*i]) && !chosen.contains(i))
                .collect();
            if found.is_empty() && !self.columns.iter().any(is_named) {
                let known: Vec<String> = self.columns.iter().map(KinematicColumn::name).collect();
                let why = format!("columns: {}", unknown_column(&name, &known));
                return Err(KinematicsError::Search { why });
            }
            chosen.extend(found);
        }
        let columns: Arc<[KinematicColumn]> = chosen.iter().map(|i| self.columns[*i].clone()).collect();
        for row in &mut self.rows {
            row.values = chosen.iter().map(|i| row.values.get(*i).copied().flatten()).collect();
            row.columns = Arc::clone(&columns);
        }
        self.columns = columns.to_vec();
        self.is_selected = true;
        Ok(self)
    }
}

/// True if the derivatives are those of roll: the variable of the rows is roll.
pub(crate) fn rolls(question: &KinematicsQuestion) -> bool {
    let roll = KinematicVariable::Wheels(WheelMotion::Roll);
    question.range.as_ref().is_some_and(|(variable, _)| *variable == roll)
}

/// Quantities at one state of the variables, or the reason for a missing pose.
pub(crate) fn evaluate_state(
    kinematics: &SuspensionKinematics,
    question: &KinematicsQuestion,
    state: &[(KinematicVariable, f64)],
) -> Result<Result<KinematicValues, String>, KinematicsError> {
    let pose = match kinematics.pose(state) {
        Ok(pose) => pose,
        Err(KinematicsError::Study(error)) if error.has_no_result() => {
            return Ok(Err(error.message(Names::Flags)));
        }
        Err(error) => return Err(error),
    };
    Ok(kinematics.parts.values(&pose, &question.vehicle.vehicle(), rolls(question))?)
}

/// Kinematics of a suspension: all quantities at each value of the variable. Every row is closed from the pose as drawn,
/// along its branch.
///
/// # Errors
/// [`KinematicsError`]: a model without a sheet or a wheel, an invalid travel.
pub fn kinematics(model: &Model, question: &KinematicsQuestion) -> Result<KinematicsReport, KinematicsError> {
    let prepared = SuspensionKinematics::new(model, question.steers())?;
    let (variable, values) = match &question.range {
        Some((variable, values)) => (Some(*variable), values.iter().map(|value| Some(*value)).collect()),
        None => (None, vec![None]),
    };
    let mut found = Vec::with_capacity(values.len());
    let mut compliance_matrices = Vec::new();
    for value in &values {
        let mut state = question.state.clone();
        state.extend(variable.zip(*value));
        found.push(evaluate_state(&prepared, question, &state)?);
        if let Some(loads) = question.vehicle.vehicle().loads {
            let matrix = prepared.pose(&state).ok();
            let matrix = matrix.and_then(|pose| prepared.parts.compliance_matrix(&pose, loads).ok());
            let rows =
                |matrix: DMatrix<f64>| matrix.row_iter().map(|row| row.iter().copied().collect()).collect();
            compliance_matrices.push(matrix.map(rows));
        }
    }
    let columns: Arc<[KinematicColumn]> = columns(&found).into();
    let beyond_data = beyond_data(&prepared, &values, &found, model.length_unit());
    let row = |(variable, found): (Option<f64>, Result<KinematicValues, String>)| {
        let value = |column: &KinematicColumn| {
            let values = found.as_ref().ok()?;
            let same = |v: &&KinematicValue| {
                v.name == column.quantity && v.side.trim_start_matches('_') == column.side
            };
            values.0.iter().find(same)?.value.clone().ok()
        };
        let values = columns.iter().map(value).collect();
        KinematicsRow { variable, values, problem: found.err(), columns: Arc::clone(&columns) }
    };
    let rows = values.into_iter().zip(found).map(row).collect();
    let mut diagnostics = model.diagnostics.clone();
    diagnostics.extend(prepared.rack_finding(question.steers()).map(DiagnosticRecord::from));
    diagnostics.extend(beyond_data.into_iter().map(DiagnosticRecord::from));
    let report = KinematicsReport {
        schema: "percuss.kinematics/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        derivatives: if rolls(question) { "roll" } else { "heave" },
        variable: variable.map(KinematicVariable::name),
        loads: question.vehicle.vehicle().loads.map(KinematicLoads::of),
        columns: columns.to_vec(),
        rows,
        compliance_matrices,
        diagnostics,
        is_selected: false,
        length_unit: model.length_unit(),
    };
    report.with_columns(&question.columns)
}

/// Findings about forces outside the data of the sheet: a spring longer than its free length, a stop compressed beyond its curve. The
/// values are those of the first such row.
fn beyond_data(
    kinematics: &SuspensionKinematics,
    variables: &[Option<f64>],
    rows: &[Result<KinematicValues, String>],
    unit: LengthUnit,
) -> Vec<Finding> {
    let mut findings = Vec::new();
    for element in &kinematics.parts.elements {
        let column = format!("force_{}", element.name);
        let force = |row: &KinematicValues| {
            let value = row
                .0
                .iter()
                .find(|value| value.name == column && (element.is_shared || value.side == element.side));
            value.and_then(|value| value.value.clone().ok())
        };
        let end = element.stop.as_ref().map(ForceCurve::end);
        let is_beyond = |force: &f64| match end {
            Some((_, last_force)) => *force > last_force,
            None => *force < 0.0,
        };
        let outside: Vec<(Option<f64>, f64)> = variables
            .iter()
            .zip(rows)
            .filter_map(|(variable, row)| Some((*variable, force(row.as_ref().ok()?).filter(is_beyond)?)))
            .collect();
        let Some((variable, force)) = outside.first() else { continue };
        let at = variable.map_or_else(String::new, |x| format!(" at {}", unit.text(x)));
        let rows = if outside.len() > 1 { format!(" ({} rows)", outside.len()) } else { String::new() };
        let name = format!("{}{}", element.name, element.side);
        let message = match end {
            Some((deflection, last_force)) => format!(
                "{name}: the force {force:.0} N{at} is beyond the end of the curve of the sheet ({last_force:.0} N at {}){rows}; \
                 the last slope is extrapolated, but a real stop becomes stiffer",
                unit.text(deflection)
            ),
            None => format!(
                "{name}: the force is {force:.0} N{at}{rows}: the spring is longer than its free length and would pull. A coil spring \
                 leaves its seat instead, and the wheel rate is then smaller"
            ),
        };
        findings.push(Finding::about_result(FindingKind::ForceBeyondData, message));
    }
    findings
}

/// Columns of all rows in the order of the first row reached, with the first reason of a column without values.
fn columns(found: &[Result<KinematicValues, String>]) -> Vec<KinematicColumn> {
    let rows: Vec<&KinematicValues> = found.iter().flatten().collect();
    let Some(first) = rows.first() else { return Vec::new() };
    let column = |(i, value): (usize, &KinematicValue)| {
        let all_missing = rows.iter().all(|row| row.0.get(i).is_none_or(|value| value.value.is_err()));
        KinematicColumn {
            quantity: value.name.clone(),
            side: value.side.trim_start_matches('_'),
            unit: value.unit,
            missing: value.value.clone().err().filter(|_| all_missing),
        }
    };
    first.0.iter().enumerate().map(column).collect()
}
