//! Ranges of joints: those of a question, and the proved bounds of m̄ over them.

use crate::evaluation::certificate::{ExtremesCertificateRecord, extremes_certificate};
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::extremes::{DEFAULT_BOXES, ExtremesQuestion, GivenEdge, GivenRange};
use crate::values::quantities::Ratio;
use percuss_dynamics::{Contact, Pose, RangeProof};
use percuss_impact::{ExtremesError, JointRange, NormalRange, driving_joints};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use percuss_units::{Dimension, Quantity};

/// Proved bounds over the ranges of a question.
///
/// # Errors
/// [`StudyError`]: no pose at the middle of the ranges; a stiffness or a speed of another dimension.
pub(crate) fn prove(
    prepared: &PreparedQuestion,
    pose: &Pose,
    contact: &Contact,
    question: &ExtremesQuestion,
) -> Result<ExtremesCertificateRecord, StudyError> {
    let ranges = wide_ranges(prepared, pose, question)?;
    prove_over(prepared, pose, contact, &ranges, question, range_proof(question))
}

/// Ranges of a question, for a proof.
///
/// # Errors
/// [`StudyError`]: a range without width.
pub(crate) fn wide_ranges(
    prepared: &PreparedQuestion,
    pose: &Pose,
    question: &ExtremesQuestion,
) -> Result<Vec<JointRange>, StudyError> {
    let ranges = ranges(prepared, pose, question)?;
    match ranges.iter().find(|range| range.lower >= range.upper) {
        Some(range) => {
            let joint = prepared.model.mechanism.joint(range.joint).name().to_owned();
            let (lower, upper) = (range.lower, range.upper);
            Err(search_error(ExtremesError::Range { joint, lower, upper }, "extremes.range"))
        }
        None => Ok(ranges),
    }
}

/// Parameters of the proof of a question.
pub(crate) fn range_proof(question: &ExtremesQuestion) -> RangeProof {
    let Ratio(tolerance) = question.certify.unwrap_or_default();
    RangeProof {
        tolerance,
        budget: question.boxes.unwrap_or(DEFAULT_BOXES) as usize,
        mass_tolerance: question.mass_tolerance.map_or(0.0, |Ratio(masses)| masses),
        only_largest: false,
        cone: match question.normals.unwrap_or_default().0 {
            NormalRange::Cone(angle) => [0.0, angle],
            _ => [0.0; 2],
        },
        edges: [0, 1].map(|k| question.edge.get(k).map_or([0.0; 3], |GivenEdge(edge)| *edge)),
        is_disc: false,
        known: 0.0,
    }
}

/// Proved bounds over ranges; a range without width sets the joint.
///
/// # Errors
/// As for [`prove`].
pub(crate) fn prove_over(
    prepared: &PreparedQuestion,
    pose: &Pose,
    contact: &Contact,
    ranges: &[JointRange],
    question: &ExtremesQuestion,
    proof: RangeProof,
) -> Result<ExtremesCertificateRecord, StudyError> {
    let tolerance = proof.tolerance;
    if prepared.wheel().is_some() {
        let reason = Some("a contact patch that moves over a wheel is not supported by the proof".to_owned());
        return Ok(ExtremesCertificateRecord { tolerance, reason, ..ExtremesCertificateRecord::default() });
    }
    // The middle of the ranges, on the branch of the pose.
    let mut middle = prepared.configuration.clone();
    for range in ranges {
        let name = prepared.model.mechanism.joint(range.joint).name();
        let position = 0.5 * range.lower + 0.5 * range.upper;
        middle.replace(name, &[position]).map_err(|error| search_error(error.into(), "extremes.range"))?;
    }
    let middle = prepared.system.pose_from(pose, &middle);
    let middle = middle.map_err(|error| search_error(error.into(), "extremes.range"))?;
    let wide: Vec<JointRange> = ranges.iter().filter(|range| range.lower < range.upper).copied().collect();
    let mut proved = extremes_certificate(&middle, contact, &wide, proof);
    if let (Some(stiffness), Some(speed)) = (question.stiffness, question.speed) {
        let law =
            DampingQuestion { stiffness: Some(stiffness), speed: Some(speed), ..DampingQuestion::default() };
        law.check_dimensions("extremes.stiffness", "extremes.speed", contact.normal.is_moment())?;
        let upper = proved.most.as_ref().and_then(|most| most.upper);
        // Rounded outward: a product, a root and a product.
        let force = |mass: f64| speed.0.value.abs() * (stiffness.0.value * mass).sqrt();
        proved.peak_force = upper.map(|mass| force(mass) * (1.0 + 4.0 * f64::EPSILON));
    }
    Ok(proved)
}

/// Ranges in SI units. Without given ranges: the limits of all driving joints with limits, except those with a given position. With kept
/// points, joints with a given position vary too.
pub(crate) fn ranges(
    prepared: &PreparedQuestion,
    pose: &Pose,
    question: &ExtremesQuestion,
) -> Result<Vec<JointRange>, StudyError> {
    let mechanism = &prepared.model.mechanism;
    // With kept links or points, the given positions only define where these stay.
    let is_set = |name: &str| {
        question.keep.is_empty() && prepared.question.pose.set.iter().any(|(joint, _)| joint == name)
    };
    if question.range.is_empty() {
        let mut drivers = driving_joints(pose);
        drivers.retain(|joint| !is_set(mechanism.joint(*joint).name()));
        let limited = drivers.into_iter().filter_map(|joint| {
            let limits = mechanism.joint(joint).limits()?;
            let is_single = mechanism.joint(joint).kind().dofs() == 1;
            (is_single && limits.lower < limits.upper).then_some(JointRange {
                joint,
                lower: limits.lower,
                upper: limits.upper,
            })
        });
        return Ok(limited.collect());
    }
    let range = |given: &GivenRange| {
        let joint = find_joint(mechanism, "extremes.range", &given.joint)?;
        if is_set(&given.joint) {
            let joint = &given.joint;
            let why = format!("joint \"{joint}\" has a range and a given position; expected one of the two");
            return Err(StudyError::input("extremes.range", why));
        }
        let dimension = match mechanism.joint(joint).kind() {
            JointKind::Revolute | JointKind::Continuous => Dimension::Angle,
            JointKind::Prismatic => Dimension::Length,
            _ => {
                return Err(StudyError::input(
                    "extremes.range",
                    Fault::NoMotion { joint: given.joint.clone() },
                ));
            }
        };
        let end = |end: Quantity| {
            end.in_dimension(dimension, &end.to_string()).map_err(StudyError::about("extremes.range"))
        };
        Ok(JointRange { joint, lower: end(given.lower)?, upper: end(given.upper)? })
    };
    question.range.iter().map(range).collect()
}

/// Converts the error of a search. `field`: field of the question that gives the positions.
pub(crate) fn search_error(error: ExtremesError, field: &'static str) -> StudyError {
    match error {
        ExtremesError::Assembly(error) => StudyError::from(error),
        ExtremesError::Contact(error) => StudyError::from(error),
        ExtremesError::NoKeptNormal { .. } | ExtremesError::NoSelfMotion { .. } => {
            StudyError::input("extremes.keep", error)
        }
        ExtremesError::VariedContact => StudyError::input("extremes.edge", error),
        error => StudyError::input(field, error),
    }
}

/// Joint by name.
pub(crate) fn find_joint(
    mechanism: &Mechanism,
    field: &'static str,
    name: &str,
) -> Result<JointId, StudyError> {
    mechanism.find_joint(name).map_err(|error| {
        if mechanism.closures().iter().any(|closure| closure.name() == name) {
            let why = format!(
                "\"{name}\" is the closure of a loop; expected a joint of the tree. The reactions of `percuss impact` include this closure"
            );
            return StudyError::input(field, why);
        }
        StudyError::input(field, error)
    })
}
