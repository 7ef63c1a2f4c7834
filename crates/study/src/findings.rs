//! What the reader of an answer should know, as diagnostics.

use crate::question::{MassQuestion, StudyError};
use crate::{DiagnosticRecord, Model, far_point};
use nalgebra::Vector3;
use percuss_dynamics::{
    BranchLimits, Configuration, Contact, EffectiveMass, PointVelocity, Pose, Remark, RouteChoice,
    Singularity, Strike, System,
};
use percuss_mechanism::{JointKind, Severity};

/// A finite answer that is less certain than this comes with a warning.
const DOUBTFUL: f64 = 1e-6;

/// An assembly is far from its guess from this angle on (rad, or parts of the size).
const FAR_FROM_GUESS: f64 = 0.5;

/// Rows that bind more weakly than this part may owe it to rounded figures.
const BY_A_HAIR: f64 = 1e-4;

fn remainder(x: f64, period: f64) -> f64 {
    x - period * (x / period).round()
}

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
    for name in system.reversed_axes() {
        let message = format!(
            "the axis of loop \"{name}\" points opposite ways in its two frames with all joints at 0; the successor's was \
             taken reversed"
        );
        found.push(note("reversed-axis", message));
    }
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
    let least = system.least_singular_value();
    if least < BY_A_HAIR {
        let message = format!(
            "the loops bind by a hair: the least singular value of their rows that counts is {least:.1e} of the largest; if \
             the file's figures are rounded by as much, there is a degree of freedom more than the {} counted",
            system.degrees_of_freedom()
        );
        found.push(warning("bound-by-a-hair", message));
    }
    found
}

/// Guesses that were of no use, and those that the assembly found is far from.
pub(crate) fn about_guesses(system: &System, pose: &Pose, wanted: &Configuration) -> Vec<DiagnosticRecord> {
    let drives = |joint| pose.loops().is_some_and(|loops| loops.drivers.contains(&joint));
    let mut found = Vec::new();
    for (joint, guess) in wanted.guesses() {
        let name = system.mechanism().joint(joint).name();
        if !system.is_bound(joint) {
            let message =
                format!("the guess for joint \"{name}\" is not used: no loop binds it; --set moves it");
            found.push(warning("unused-guess", message));
        } else if drives(joint) {
            let message =
                format!("the guess for joint \"{name}\" is not used: it drives its loops; --set moves it");
            found.push(warning("unused-guess", message));
        } else if let (&[at], &[guess]) = (pose.joint(joint), guess) {
            let size = system.mechanism().characteristic_length();
            let turns = system.mechanism().joint(joint).kind() != JointKind::Prismatic;
            let off = if turns {
                remainder(at - guess, std::f64::consts::TAU).abs()
            } else {
                (at - guess).abs() / size
            };
            if off > FAR_FROM_GUESS {
                let message = format!(
                    "joint \"{name}\" was guessed at {guess} and stands at {at:.9}: no nearer way to close its loops was \
                     found"
                );
                found.push(warning("far-from-guess", message));
            }
        }
    }
    found
}

/// The contact point, and the remarks of the strike.
pub(crate) fn about_strike(system: &System, contact: &Contact, strike: &Strike) -> Vec<DiagnosticRecord> {
    let mut found: Vec<DiagnosticRecord> =
        far_point::doubt(system.mechanism(), contact.link, &contact.point).into_iter().collect();
    let finite = matches!(strike.effective_mass, EffectiveMass::Finite(_));
    // A massless answer says it already.
    let told = |r: &&Remark| finite || !matches!(r, Remark::MasslessMotions { .. });
    found.extend(strike.remarks.iter().filter(told).map(remark));
    if let (EffectiveMass::Finite(m), Some(error)) = (strike.effective_mass, strike.effective_mass_error)
        && error > DOUBTFUL * m
    {
        let message = format!(
            "the effective mass is uncertain by {:.1e} of itself: the pose is close to a singular one, or the mass matrix \
             is; do not trust its digits beyond that",
            error / m
        );
        found.push(warning("uncertain-mass", message));
    }
    found
}

/// Where branches cross, or something binds less than beside the pose.
pub(crate) fn about_branches(
    system: &System,
    pose: &Pose,
    strike: &Strike,
    limits: &BranchLimits,
) -> Option<DiagnosticRecord> {
    if !strike.singular_pose {
        return None;
    }
    let (here, generic) = (strike.degrees_of_freedom, system.degrees_of_freedom());
    let loops = pose.loops().is_some_and(|l| l.singularities.contains(&Singularity::ChangePoint));
    let kind = if loops { "singular pose (change point)" } else { "singular pose" };
    let mut message = format!("{kind}: {here} degrees of freedom here, {generic} at a generic pose; ");
    message += match (limits.limits.is_empty(), limits.continuous, limits.complete) {
        (true, ..) if !loops => {
            "what is held or locked binds less here than beside it, and the value is a lower bound"
        }
        (true, ..) => {
            "no branch was found to lead away from it, and the value is a lower bound that no finite motion attains"
        }
        (false, true, _) => {
            "a continuum of branches meets here, the limit depends on the direction of approach, and the value is a lower \
             bound: see the least and the greatest of the limits that were found"
        }
        (false, false, true) => {
            "branches cross, and the value is a lower bound that none of them attains: see the limits along the branches"
        }
        (false, false, false) => {
            "many branches cross, and the value is a lower bound that none of them attains: see the limits along those that \
             were found; there may be more"
        }
    };
    Some(warning("singular-pose", message))
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
        let velocity = system.point_velocity_over_ground(pose, &strike, link, &Vector3::from(hold.point));
        // The blow changes velocities by −v*: the point approaches what it is held to where −v*·n > 0.
        let n = Vector3::from(normal).normalize();
        let lifts = match velocity {
            Some(PointVelocity::Known(v)) => pose.base().vector(&v).dot(&n) > 1e-9,
            Some(PointVelocity::Undetermined) | None => false,
        };
        if lifts {
            let without = match question.against_mass {
                Some(other) => strike.against_mass(other).effective_mass,
                None => strike.effective_mass,
            };
            let value = match without {
                EffectiveMass::Finite(m) => format!("the effective mass is {m} kg"),
                EffectiveMass::Immovable => "the contact is immovable".into(),
                EffectiveMass::Massless => "the contact is massless".into(),
            };
            let message = format!(
                "the held contact of link \"{}\" would have to pull: the blow lifts it off; without it {value}",
                hold.link
            );
            found.push(warning("hold-pulls", message));
        } else if !matches!(strike.effective_mass, EffectiveMass::Finite(_))
            || velocity == Some(PointVelocity::Undetermined)
        {
            let message = format!(
                "without the held contact of link \"{}\" the motion of the blow is not determined: whether it pulls cannot \
                 be said",
                hold.link
            );
            found.push(note("hold-undetermined", message));
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
        Remark::UnclearRank { gap } => warning(
            "unclear-rank-here",
            format!(
                "the rank of the constraints is in doubt at this pose (gap {gap:.1e}): it is close to a change point, where \
                 mobility is another"
            ),
        ),
        _ => note("remark", format!("{remark:?}")),
    }
}
