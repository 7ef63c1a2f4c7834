//! A closure in a study file.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::model::loading::{Model, Origin};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::refusal::InvalidKey;
use crate::values::quantities::{Angles, Length, Point, Vector};
use percuss_mechanism::{BuildError, ClosureDescription, ClosureKind, Problem, Severity, Subject};
use percuss_spatial::{Transform, rotation_from_rpy};
use schemars::JsonSchema;
use serde::Deserialize;
use std::sync::Arc;

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClosureText {
    /// Name of the loop.
    pub name: String,
    /// Kind of the loop, which defines the free motions.
    #[serde(rename = "type")]
    #[schemars(extend("enum" = kinds()))]
    pub kind: String,
    /// The first link.
    pub predecessor: String,
    /// Origin of the loop's frame in the first link, m.
    #[serde(default)]
    pub predecessor_xyz: Point,
    /// Axes of the loop's frame: roll, pitch, yaw, rad.
    #[serde(default)]
    pub predecessor_rpy: Angles,
    /// The second link.
    pub successor: String,
    /// Origin of the loop's frame in the second link, m.
    #[serde(default)]
    pub successor_xyz: Point,
    /// Axes of the loop's frame: roll, pitch, yaw, rad.
    #[serde(default)]
    pub successor_rpy: Angles,
    /// The axis, in the first frame.
    pub axis: Option<Vector>,
    /// The second axis of a universal loop, in the second frame.
    pub axis2: Option<Vector>,
    /// The distance of a rod, m; default: the distance with all joints at 0.
    pub distance: Option<Length>,
}

/// Names of the kinds of loops.
fn kinds() -> Vec<&'static str> {
    ClosureKind::ALL.iter().map(|kind| kind.name()).chain(["continuous"]).collect()
}

impl ClosureText {
    /// Key at fault for a problem of the closure.
    pub fn key_of(&self, problem: &Problem) -> Option<&'static str> {
        let size = |numbers: &[f64; 3]| numbers.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let of_axis = |axis: Option<Vector>| axis.map_or(1.0, |axis| size(&axis.0));
        let [first, second] = [self.axis, self.axis2].map(of_axis);
        Some(match problem {
            Problem::EmptyName | Problem::DuplicateName { .. } => "name",
            Problem::UnknownLink { role, .. } => role,
            Problem::ClosesOnItself { .. } => "successor",
            Problem::BadDistance { .. } => "distance",
            Problem::ZeroAxis if second < first => "axis2",
            Problem::ZeroAxis => "axis",
            Problem::TooLarge { quantity, .. } | Problem::NotFinite { quantity, .. } => match *quantity {
                "axis" if second > first => "axis2",
                "origin" if size(&self.predecessor_xyz.0) > size(&self.successor_xyz.0) => "predecessor_xyz",
                "origin" => "successor_xyz",
                other => other,
            },
            _ => return None,
        })
    }

    /// Converts the keys to a closure.
    pub fn closure_description(&self) -> Result<ClosureDescription, InvalidKey> {
        let named = if self.kind == "continuous" { "revolute" } else { &self.kind };
        let Some(kind) = ClosureKind::ALL.into_iter().find(|k| k.name() == named) else {
            let known: Vec<&str> = ClosureKind::ALL.iter().map(|k| k.name()).collect();
            return Err(InvalidKey::new(
                "closure.type",
                format!("\"{}\"; known are {}", self.kind, known.join(", ")),
            ));
        };
        let frame = |xyz: Point, rpy: Angles| Transform::new(rotation_from_rpy(rpy.0), xyz.0.into());
        let mut closure = ClosureDescription::new(&self.name, kind, &self.predecessor, &self.successor);
        closure.predecessor_frame = frame(self.predecessor_xyz, self.predecessor_rpy);
        closure.successor_frame = frame(self.successor_xyz, self.successor_rpy);
        closure.axis = self.axis.map_or(closure.axis, |axis| axis.0.into());
        closure.axis2 = self.axis2.map_or(closure.axis2, |axis| axis.0.into());
        closure.distance = self.distance.map(|length| length.0);
        Ok(closure)
    }
}

/// Key at fault and its reason, for a mechanism with the closures of a study after `of_file` closures of its file. `None` for another error.
pub(crate) fn closure_fault(
    closures: &[ClosureText],
    of_file: usize,
    error: &BuildError,
) -> Option<(String, String)> {
    let errors = error.findings.iter().filter(|(_, problem)| problem.severity() == Severity::Error);
    let of_study = |(subject, problem): &(Subject, Problem)| {
        let Subject::Closure { index, .. } = subject else { return None };
        let number = index.checked_sub(of_file)?;
        let key = closures.get(number)?.key_of(problem)?;
        Some((format!("closure[{number}].{key}"), format!("{subject}: {problem}")))
    };
    errors.into_iter().find_map(of_study)
}

/// Model with additional closures, and with the findings about them.
pub(crate) fn with_closures(
    model: Model,
    path: &str,
    closures: Vec<ClosureDescription>,
) -> Result<Model, BuildError> {
    let of_file = model.mechanism.closures().len();
    let mut diagnostics = model.diagnostics;
    for closure in closures.iter().filter(|c| c.kind == ClosureKind::Distance && c.distance.is_none()) {
        let message =
            format!("loop \"{}\" has no distance: the distance with all joints at 0 is used", closure.name);
        let record = DiagnosticRecord::from(Finding::about_result(FindingKind::DefaultDistance, message));
        diagnostics.push(DiagnosticRecord { path: Some(path.to_owned()), ..record });
    }
    // The findings about unbound joints concern the model file alone; the added closures may bind these joints.
    diagnostics.retain(|d| d.code != "unbound-joint");
    let added = closures.clone();
    let builder = closures.into_iter().fold(model.mechanism.to_builder(), |b, closure| b.closure(closure));
    let built = builder.build()?;
    // Other findings of the builder were reported, with positions, when the model file was read.
    for (subject, problem) in built.findings {
        if matches!(subject, Subject::Closure { index, .. } if index >= of_file) {
            diagnostics.push(DiagnosticRecord {
                severity: problem.severity(),
                code: problem.code(),
                path: Some(path.to_owned()),
                line: None,
                column: None,
                element: None,
                message: format!("{subject}: {problem}"),
            });
        }
    }
    let origin = Origin { closures: added, ..model.origin };
    Ok(Model { mechanism: Arc::new(built.mechanism), diagnostics, origin, ..model })
}
