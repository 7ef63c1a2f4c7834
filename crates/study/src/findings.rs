//! What the reader of an answer should know, as diagnostics.

use crate::question::{MassQuestion, StudyError};
use crate::{DiagnosticRecord, Model, far_point};
use nalgebra::Vector3;
use percuss_dynamics::{Contact, EffectiveMass, PointVelocity, Pose, Remark, RouteChoice, Strike, System};
use percuss_mechanism::Severity;

fn warning(code: &'static str, message: String) -> DiagnosticRecord {
    DiagnosticRecord::about_answer(Severity::Warning, code, message)
}

fn note(code: &'static str, message: String) -> DiagnosticRecord {
    DiagnosticRecord::about_answer(Severity::Note, code, message)
}

/// Limits, and how the loops came together.
pub(crate) fn about_pose(system: &System, pose: &Pose) -> Vec<DiagnosticRecord> {
    let mechanism = system.mechanism();
    let name = |joint| mechanism.joint(joint).name();
    let mut found: Vec<DiagnosticRecord> = pose
        .outside_limits(system)
        .map(|(joint, value, limits)| {
            let message = format!(
                "joint \"{}\" stands at {value}, outside its limits {} to {}",
                name(joint),
                limits.lower,
                limits.upper
            );
            warning("outside-limits", message)
        })
        .collect();
    let Some(loops) = pose.loops() else { return found };
    if loops.inexactness > 0.0 {
        let part = loops.inexactness / mechanism.characteristic_length();
        let message = format!(
            "the file's loops are inexact: they fit to {:.2e} m only ({part:.1e} of the size), closed in least squares; \
             are its angles rounded (1.5708)?",
            loops.inexactness
        );
        found.push(warning("inexact-loops", message));
    }
    for (joint, value) in &loops.off_zero {
        let message = format!(
            "joint \"{}\" drives and was not set; 0 is out of reach, so it stands at {value:.9}; set it",
            name(*joint)
        );
        found.push(warning("driver-off-zero", message));
    }
    if !loops.declared {
        let drivers: Vec<String> = loops.drivers.iter().map(|j| format!("\"{}\"", name(*j))).collect();
        if !drivers.is_empty() {
            let message =
                format!("the loops are driven by {}: chosen by rank, none is declared", drivers.join(", "));
            found.push(note("drivers-chosen", message));
        }
    }
    if !system.rank_is_clear() {
        let gap = system.rank_gap().unwrap_or_default();
        let message =
            format!("the rank of the constraints is unclear (gap {gap:.1e}): mobility may be another");
        found.push(warning("unclear-rank", message));
    }
    found
}

/// The contact point, and the remarks of the strike.
pub(crate) fn about_strike(system: &System, contact: &Contact, strike: &Strike) -> Vec<DiagnosticRecord> {
    let mut found: Vec<DiagnosticRecord> =
        far_point::doubt(system.mechanism(), contact.link, &contact.point).into_iter().collect();
    found.extend(strike.remarks.iter().map(remark));
    if strike.singular_pose {
        let message = format!(
            "singular pose (change point): {} degrees of freedom here, {} at a generic pose; branches cross, and the value \
             is a lower bound that none of them attains: see the limits along the branches",
            strike.degrees_of_freedom,
            system.degrees_of_freedom()
        );
        found.push(warning("singular-pose", message));
    }
    found
}

/// Held contacts that would have to pull: without them, the point leaves what it is held to.
pub(crate) fn about_holds(
    model: &Model,
    question: &MassQuestion,
    pose: &Pose,
    contact: &Contact,
) -> Result<Vec<DiagnosticRecord>, StudyError> {
    let mut found = Vec::new();
    for (i, hold) in question.hold.iter().enumerate() {
        let Some(normal) = hold.normal else { continue };
        let mut without = question.clone();
        without.hold.remove(i);
        let system = without.system(&model.mechanism)?;
        let strike = system.strike(pose, contact, RouteChoice::Auto)?;
        let link = model.mechanism.find_link(&hold.link)?;
        let velocity = system.point_velocity(pose, &strike, link, &Vector3::from(hold.point));
        // The blow changes velocities by −v*: approaching the ground is −v*·n > 0.
        if let (Some(PointVelocity::Known(v)), EffectiveMass::Finite(m)) = (velocity, strike.effective_mass)
            && v.dot(&Vector3::from(normal).normalize()) > 1e-9
        {
            let message = format!(
                "the held contact of link \"{}\" would have to pull: the blow lifts it off; without it the effective mass \
                 is {m} kg",
                hold.link
            );
            found.push(warning("hold-pulls", message));
        }
    }
    Ok(found)
}

fn remark(remark: &Remark) -> DiagnosticRecord {
    match remark {
        Remark::NearlyImmovable { approach, uncertainty } => warning(
            "nearly-immovable",
            format!(
                "the gap hardly closes (closing speed {approach:.1e} of its terms): the mass is uncertain by \
                 {uncertainty:.1e} of itself"
            ),
        ),
        Remark::MasslessMotions { directions } => note(
            "massless-motions",
            format!("{directions} motion(s) of the mechanism carry no mass; they do not matter here"),
        ),
        Remark::UndeterminedMotion => note(
            "undetermined-motion",
            "a motion without mass leaves some velocities of the blow open; the mass and the shares are not"
                .into(),
        ),
        Remark::IndefiniteMassMatrix => warning(
            "indefinite-mass-matrix",
            "the mass matrix has negative directions: the value is stationary, not a minimum".into(),
        ),
        _ => note("remark", format!("{remark:?}")),
    }
}
