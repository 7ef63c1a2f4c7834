//! How fast a robot may move where it may hit a person: the effective mass in place of the standard's M/2 + m_L.

use crate::answer::{Answer, Answered};
use crate::error::StudyError;
use crate::model::{Input, Model};
use crate::question::MassQuestion;
use crate::record::DiagnosticRecord;
use percuss_contact::{BodyRegion, ContactLawError, TransientContact, standard_robot_mass};
use percuss_dynamics::{Base, EffectiveMass};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, LinkId, Mechanism, Severity,
};
use serde::Serialize;

/// The limit that the user sets, from the edition of the standard that applies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// Greatest force, N.
    Force(f64),
    /// Greatest pressure, Pa, on an area, m².
    Pressure(f64, f64),
}

/// Who is struck, and what may happen.
#[derive(Clone, Debug, PartialEq)]
pub struct SafeSpeedQuestion {
    /// Name of the body's region.
    pub region: String,
    /// The limit.
    pub limit: Limit,
    /// Load with its tool that the model does not hold, kg.
    pub load: f64,
}

/// The speed for one mass of the robot.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SpeedRecord {
    /// m_R, kg; null where the robot does not give way. The effective mass with what it may be off by; at a singular pose
    /// the greatest of its limits along the branches.
    pub robot_mass: Option<f64>,
    /// μ = 1/(1/m_H + 1/m_R), kg.
    pub reduced_mass: f64,
    /// The greatest relative speed, m/s.
    pub speed: f64,
}

/// `percuss safe-speed`, as JSON.
#[derive(Clone, Debug, Serialize)]
pub struct SafeSpeedReport {
    /// `percuss.safe-speed/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The files.
    pub inputs: Vec<Input>,
    /// The region struck.
    pub region: String,
    /// Its effective mass, kg.
    pub region_mass: f64,
    /// Its stiffness, N/m.
    pub region_stiffness: f64,
    /// What is less certain about it.
    pub region_note: Option<String>,
    /// The greatest force, N.
    pub force: f64,
    /// The energy of the impact, J.
    pub energy: f64,
    /// With the effective mass at the contact.
    pub reflected: SpeedRecord,
    /// With the standard's M/2 + m_L.
    pub standard: SpeedRecord,
    /// M: mass of all links that can move, kg.
    pub moving_mass: f64,
    /// m_L, kg.
    pub load: f64,
    /// What was found.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// How fast the contact of a robot may go.
///
/// # Errors
/// [`StudyError`], as for `mass`; limits out of range, a region that is not in the table, a contact
/// that carries no mass, a mass that nothing bounds from above.
pub fn safe_speed(
    model: &Model,
    question: &MassQuestion,
    asked: &SafeSpeedQuestion,
) -> Result<SafeSpeedReport, StudyError> {
    let region = BodyRegion::from_name(&asked.region)?;
    if question.against.is_some() || question.against_mass.is_some() {
        return Err(StudyError::PersonIsTheOther);
    }
    let bare = Answered::new(model, question)?;
    let moving_mass = moving_mass(&bare);
    let loaded = if asked.load > 0.0 { Some(loaded(&bare, asked.load)?) } else { None };
    let answered = loaded.as_ref().map_or(Ok(bare), |model| Answered::new(model, question))?;
    let speed = |robot_mass: Option<f64>| -> Result<_, ContactLawError> {
        let contact = match robot_mass {
            Some(mass) => TransientContact::new(region, mass)?,
            None => TransientContact::immovable(region),
        };
        let safe = match asked.limit {
            Limit::Force(force) => contact.speed_for_force(force),
            Limit::Pressure(pressure, area) => contact.speed_for_pressure(pressure, area),
        }?;
        Ok((SpeedRecord { robot_mass, reduced_mass: contact.reduced_mass(), speed: safe.speed }, safe))
    };
    let (standard, safe) = speed(Some(standard_robot_mass(moving_mass, asked.load)?))?;
    let mut diagnostics = model.diagnostics.clone();
    diagnostics.extend(answered.answer.findings.iter().cloned().map(DiagnosticRecord::from));
    let (reflected, _) = match greatest_mass(&answered.answer)? {
        EffectiveMass::Finite(m) => speed(Some(m))?,
        EffectiveMass::Immovable => {
            let message =
                "the robot is immovable along this direction: the person's mass alone decides".to_owned();
            diagnostics.push(DiagnosticRecord::about_answer(Severity::Warning, "immovable-robot", message));
            speed(None)?
        }
        EffectiveMass::Massless => return Err(StudyError::NoMass),
    };
    if reflected.speed < standard.speed {
        let message = format!(
            "the standard's mass allows {:.3} m/s, the effective mass only {:.3} m/s: here M/2 + m_L is too light",
            standard.speed, reflected.speed
        );
        diagnostics.push(DiagnosticRecord::about_answer(Severity::Warning, "standard-too-fast", message));
    }
    Ok(SafeSpeedReport {
        schema: "percuss.safe-speed/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: answered.prepared.inputs(),
        region: region.name.clone(),
        region_mass: region.mass,
        region_stiffness: region.stiffness,
        region_note: region.note.clone(),
        force: safe.force,
        energy: safe.energy,
        reflected,
        standard,
        moving_mass,
        load: asked.load,
        diagnostics,
    })
}

/// The greatest mass that a motion from the pose meets: too light a robot would be allowed too high a speed. At a singular
/// pose the value of the answer is a lower bound, and the greatest limit along the branches counts.
fn greatest_mass(answer: &Answer) -> Result<EffectiveMass, StudyError> {
    let response = &answer.response;
    if response.singular_pose {
        let limits = &answer.limits;
        let weight = |mass: &EffectiveMass| match mass {
            EffectiveMass::Finite(m) => *m,
            EffectiveMass::Immovable => f64::INFINITY,
            EffectiveMass::Massless => 0.0,
        };
        let greatest =
            answer.all_branches().and_then(|all| all.iter().max_by(|a, b| weight(a).total_cmp(&weight(b))));
        return greatest.copied().ok_or_else(|| StudyError::NoGreatestMass {
            limits: limits.limits.clone(),
            complete: limits.complete && !limits.continuous,
        });
    }
    match (response.effective_mass, response.effective_mass_error()) {
        (EffectiveMass::Finite(m), Some(error)) => Ok(EffectiveMass::Finite(m + error)),
        (EffectiveMass::Finite(_), None) => Err(StudyError::MassUnknown),
        (mass @ (EffectiveMass::Immovable | EffectiveMass::Massless), _) => Ok(mass),
    }
}

/// The model with a load: a point mass at the contact, held by the struck link.
fn loaded(bare: &Answered, load: f64) -> Result<Model, StudyError> {
    let model = bare.prepared.model;
    let mechanism = &model.mechanism;
    let at = bare.contact.point;
    let name = (0..).map(|i| format!("load{i}")).find(|name| mechanism.find_link(name).is_err());
    let name = name.unwrap_or_default();
    let struck = mechanism.link(bare.contact.link).name();
    let builder = mechanism
        .to_builder()
        .link(LinkDescription::new(&name, Inertial::point(load, at.into())))
        .joint(JointDescription::new(format!("{name} on {struck}"), JointKind::Fixed, struck, &name));
    let built = builder.build().map_err(|_| ContactLawError::OutOfRange {
        what: "load, kg",
        got: load,
        valid: "a finite number, 0 or above",
    })?;
    Ok(Model { mechanism: built.mechanism.into(), ..model.clone() })
}

/// Mass of the links that can move: not the ground, and not behind locked joints alone.
fn moving_mass(answered: &Answered) -> f64 {
    let prepared = &answered.prepared;
    let mechanism: &Mechanism = &prepared.model.mechanism;
    let moves = |link: &LinkId| {
        let above = std::iter::successors(mechanism.parent_joint(*link), |joint| {
            mechanism.parent_joint(mechanism.joint(*joint).parent())
        });
        let floats = prepared.question.base == Base::Floating;
        floats
            || above
                .into_iter()
                .any(|joint| mechanism.joint(joint).kind().dofs() > 0 && !prepared.system.is_locked(joint))
    };
    let mass = |link: LinkId| mechanism.link(link).inertial().map_or(0.0, |i| i.mass);
    mechanism.link_ids().filter(moves).map(mass).sum()
}
