//! m̄ over directions at one point: the belted ellipsoid.

use crate::checks::findings::singular_map_finding;
use crate::evaluation::named_contact::findings_at_touch;
use crate::evaluation::passed_stops::passed_stop_findings;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::map::contact_findings::{MapResults, map_contact_findings};
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::pose::positions::{PoseLayout, Positions};
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::reports::mass_report::ConditionsRecord;
use crate::thresholds::DIRECTIONS;
use nalgebra::Vector3;
use percuss_dynamics::{BatchAnswer, Contact, Direction, EffectiveMass, Frame};
use percuss_spatial::Transform;
use schemars::JsonSchema;
use serde::Serialize;

/// m̄ along a direction.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DirectionMass {
    /// Unit vector, link's axes.
    pub direction_link: [f64; 3],
    /// Unit vector, world axes.
    pub direction_world: [f64; 3],
    /// `finite`, `immovable`, `massless` or `no answer`.
    pub status: &'static str,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// Error bound of m̄, kg; null if unknown.
    pub effective_mass_error: Option<f64>,
}

/// Report of `percuss map --point`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct PointMapReport {
    /// `percuss.map-point/1`.
    #[schemars(extend("const" = "percuss.map-point/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// The link.
    pub link: String,
    /// Point, link's frame, m.
    pub point_link: [f64; 3],
    /// Point, world frame, m.
    pub point_world: [f64; 3],
    /// The three directions with stationary m̄, from the lightest to the heaviest; empty if any of them has no
    /// result.
    pub principal: Vec<DirectionMass>,
    /// Directions distributed evenly over the sphere.
    pub directions: Vec<DirectionMass>,
    /// Other link; null for the ground.
    pub against: Option<String>,
    /// Conditions of the question.
    pub conditions: ConditionsRecord,
    /// True if the pose is singular; every m̄ is then a lower bound.
    pub singular_pose: bool,
    /// Joint positions.
    pub pose: Positions,
    /// Warnings and notes.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Evaluates `directions` directions and the principal directions at the point of a question. The normal of the
/// question is ignored.
///
/// # Errors
/// [`StudyError`]: unknown names, an unreachable pose, a number of directions out of range.
pub fn map_point(
    model: &Model,
    question: &MassQuestion,
    directions: usize,
) -> Result<PointMapReport, StudyError> {
    if !DIRECTIONS.contains(&directions) {
        let (least, most) = (DIRECTIONS.start(), DIRECTIONS.end());
        let why = format!("{directions} directions; {least} to {most} are possible");
        return Err(StudyError::input("map.directions", why));
    }
    let given = question;
    let question = question.resolve_contact(&model.mechanism)?.into_owned();
    question.refuse_moment("map of directions")?;
    let contact = question.contact.with_normal([1.0, 0.0, 0.0], question.contact.normal_frame());
    let question = MassQuestion { contact, ..question };
    let prepared = PreparedQuestion::new(model, &question)?;
    let pose = prepared.pose()?;
    let contact = prepared.contact_at(&pose);
    let map = pose
        .contact_map(contact.link, contact.against, contact.point, 0.0)
        .map_err(StudyError::about("contact.point"))?;
    let x_wl = pose.link(contact.link);
    let other = prepared.other_mass();
    let alone: Vec<(Vector3<f64>, BatchAnswer)> = (0..directions)
        .map(|i| spiral_direction(i, directions))
        .map(|direction| (direction, map.effective_mass(&contact.point, &direction)))
        .collect();
    let of_direction = |(direction, answer): &(Vector3<f64>, BatchAnswer)| {
        direction_mass(&x_wl, direction, answer.mass, answer.error, other)
    };
    let principal = map.principal_masses(&contact.point);
    let principal: Vec<(Vector3<f64>, BatchAnswer)> = (principal.iter().flatten())
        .map(|p| (p.direction, BatchAnswer { mass: Some(p.mass), error: p.error, ..BatchAnswer::NONE }))
        .collect();
    let mut diagnostics: Vec<DiagnosticRecord> = model.diagnostics.clone();
    diagnostics.extend(prepared.start_findings(&pose, &contact).into_iter().map(DiagnosticRecord::from));
    diagnostics.extend(passed_stop_findings(&prepared, &pose).into_iter().map(DiagnosticRecord::from));
    diagnostics.extend(findings_at_touch(model, given).into_iter().map(DiagnosticRecord::from));
    diagnostics.extend(singular_map_finding(&pose).map(DiagnosticRecord::from));
    for (of, word) in [(&principal, "principal direction"), (&alone, "direction")] {
        let results = MapResults {
            statuses: &of.iter().map(|(_, answer)| answer.status()).collect::<Vec<_>>(),
            errors: &of.iter().map(|(_, answer)| relative_error(answer)).collect::<Vec<_>>(),
            contact: |i: usize| Contact { normal: Direction::Along(of[i].0, Frame::Link), ..contact },
            word,
        };
        for finding in map_contact_findings(&prepared, &pose, &results) {
            if !diagnostics.contains(&finding) {
                diagnostics.push(finding);
            }
        }
    }
    Ok(PointMapReport {
        schema: "percuss.map-point/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: prepared.inputs(),
        link: question.contact.link().to_owned(),
        point_link: contact.point.into(),
        point_world: x_wl.point(&contact.point).into(),
        principal: principal.iter().map(of_direction).collect(),
        directions: alone.iter().map(of_direction).collect(),
        against: question.contact.against.clone(),
        conditions: ConditionsRecord::of(&question),
        singular_pose: pose.rank().singular,
        pose: Positions::from_pose(&PoseLayout::new(&model.mechanism), &pose),
        diagnostics,
    })
}

/// Relative error of m̄ of a mechanism alone; NaN if unknown.
fn relative_error(answer: &BatchAnswer) -> f64 {
    match (answer.mass, answer.error) {
        (Some(EffectiveMass::Finite(mass)), Some(error)) => error / mass,
        _ => f64::NAN,
    }
}

/// Result along one direction, including a free body on the other side: dm̄ = (m̄/m̄₁)² dm̄₁.
fn direction_mass(
    x_wl: &Transform<f64>,
    direction: &Vector3<f64>,
    mass: Option<EffectiveMass>,
    error: Option<f64>,
    other: Option<f64>,
) -> DirectionMass {
    let together = mass.map(|mass| mass.against_mass(other));
    let (status, effective_mass) = match together {
        Some(EffectiveMass::Finite(m)) => ("finite", Some(m)),
        Some(EffectiveMass::Immovable) => ("immovable", None),
        Some(EffectiveMass::Massless) => ("massless", None),
        None => ("no answer", None),
    };
    let factor = match (mass, effective_mass) {
        (Some(EffectiveMass::Finite(own)), Some(m)) => (m / own).powi(2),
        _ => 0.0,
    };
    DirectionMass {
        direction_link: (*direction).into(),
        direction_world: x_wl.vector(direction).into(),
        status,
        effective_mass,
        effective_mass_error: effective_mass.and(error).map(|e| e * factor),
    }
}

/// Direction `i` of `count`: a spiral on the sphere with equal distances between turns and between points
/// (Swinbank and Purser 2006; cited from memory).
fn spiral_direction(i: usize, count: usize) -> Vector3<f64> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let z = 1.0 - (2.0 * i as f64 + 1.0) / count as f64;
    let turn = std::f64::consts::TAU * (i as f64 * GOLDEN).fract();
    let radius = (1.0 - z * z).sqrt();
    Vector3::new(radius * turn.cos(), radius * turn.sin(), z)
}
