//! What an effective mass depends on: its rate with the mass, the centre of mass and the armature of each part, and with
//! each hardpoint of a sheet.
//!
//! m̄ = min { vᵀMv : Av = 0, jv = 1 } changes with a parameter of M alone by dm̄/dp = v*ᵀ (∂M/∂p) v*: the motion at the
//! minimum need not be differentiated (docs/FORMULAS.md, F37). Hardpoints change A and j too: their rates are central
//! differences of the whole question asked again.

use crate::answer::Answered;
use crate::changes::Changes;
use crate::error::StudyError;
use crate::model::Model;
use crate::question::MassQuestion;
use crate::thresholds::{POINT_STEP, STRONGEST};
use nalgebra::Vector3;
use percuss_dynamics::{ContactResponse, EffectiveMass, PointVelocity, Pose};
use percuss_mechanism::{Inertial, LinkId};
use rayon::prelude::*;
use serde::Serialize;

/// What an effective mass depends on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Explanation {
    /// m̄, kg.
    pub effective_mass: f64,
    /// Every link with mass, in file order.
    pub links: Vec<LinkSensitivity>,
    /// Every joint whose rotor would turn.
    pub rotors: Vec<RotorSensitivity>,
    /// Every hardpoint of a sheet; none for a URDF.
    pub points: Vec<PointSensitivity>,
    /// The links whose mass counts most, the first the most.
    pub most_per_kilogram: Vec<MassChange>,
    /// The hardpoints whose place counts most, the first the most.
    pub most_per_millimetre: Vec<PointChange>,
}

/// How m̄ changes with a link.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LinkSensitivity {
    /// The link.
    pub link: String,
    /// Its mass, kg.
    pub mass: f64,
    /// Its share of m̄.
    pub share: f64,
    /// dm̄/dm, kg/kg, the moments about the centre of mass in proportion: share · m̄ / m.
    pub per_kilogram: f64,
    /// dm̄/dc, kg/m, along the link's axes, the moments about the centre of mass as they are.
    pub per_metre_of_com: Option<[f64; 3]>,
}

/// How m̄ changes with the armature of a joint.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RotorSensitivity {
    /// The joint.
    pub joint: String,
    /// dm̄/dI for each velocity: q̇², kg/(kg·m²) of a joint that turns, kg/kg of one that slides.
    pub per_armature: Vec<f64>,
}

/// How m̄ changes with a hardpoint.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PointSensitivity {
    /// The hardpoint.
    pub point: String,
    /// dm̄/dx, dm̄/dy, dm̄/dz, kg/m, in the sheet's axes; null where the question has no answer beside the design.
    pub per_metre: Option<[f64; 3]>,
    /// What the differences may be off by, kg/m.
    pub per_metre_error: Option<f64>,
}

/// A change of mass that lowers m̄; its opposite raises it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MassChange {
    /// The link.
    pub link: String,
    /// By how much m̄ is lowered for each kilogram less, kg, to first order.
    pub lowers_by: f64,
}

/// A move that lowers m̄; its opposite raises it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PointChange {
    /// The hardpoint.
    pub point: String,
    /// Which way, a unit vector in the sheet's axes.
    pub direction: [f64; 3],
    /// By how much m̄ is lowered for each millimetre, kg, to first order.
    pub lowers_by: f64,
}

/// Explains the answer to a contact; none where it has no finite mass, or another on each branch.
///
/// # Errors
/// [`StudyError`], as for `mass`.
pub fn explain(model: &Model, question: &MassQuestion) -> Result<Option<Explanation>, StudyError> {
    let answered = Answered::new(model, question)?;
    let response = &answered.answer.response;
    let EffectiveMass::Finite(mass) = response.effective_mass else { return Ok(None) };
    if response.singular_pose {
        return Ok(None);
    }
    let (links, rotors) = (links(&answered, mass), rotors(&answered));
    let points = points(model, question);
    let mut by_mass: Vec<&LinkSensitivity> = links.iter().filter(|link| link.per_kilogram > 0.0).collect();
    by_mass.sort_by(|a, b| b.per_kilogram.total_cmp(&a.per_kilogram));
    let of_mass =
        |link: &&LinkSensitivity| MassChange { link: link.link.clone(), lowers_by: link.per_kilogram };
    let steepest = |point: &PointSensitivity| {
        let rate = Vector3::from(point.per_metre?);
        let known = rate.norm() > point.per_metre_error.unwrap_or_default();
        let direction = (-rate).try_normalize(0.0)?;
        known.then(|| PointChange {
            point: point.point.clone(),
            direction: direction.into(),
            lowers_by: rate.norm() * 1e-3,
        })
    };
    let mut by_place: Vec<PointChange> = points.iter().filter_map(steepest).collect();
    by_place.sort_by(|a, b| b.lowers_by.total_cmp(&a.lowers_by));
    by_place.truncate(STRONGEST);
    Ok(Some(Explanation {
        effective_mass: mass,
        most_per_kilogram: by_mass.iter().take(STRONGEST).map(of_mass).collect(),
        most_per_millimetre: by_place,
        links,
        rotors,
        points,
    }))
}

fn links(answered: &Answered, mass: f64) -> Vec<LinkSensitivity> {
    let (mechanism, response) = (&answered.prepared.model.mechanism, &answered.answer.response);
    let shares = response.contributions.as_ref();
    let share = |id: LinkId| shares.and_then(|s| s.links.get(id.index()).copied()).unwrap_or(0.0);
    let of_link = |id: LinkId| {
        let link = mechanism.link(id);
        let inertial = link.inertial().filter(|inertial| inertial.mass > 0.0)?;
        Some(LinkSensitivity {
            link: link.name().to_owned(),
            mass: inertial.mass,
            share: share(id),
            per_kilogram: share(id) * mass / inertial.mass,
            per_metre_of_com: per_metre_of_com(&answered.pose, response, id, inertial),
        })
    };
    mechanism.link_ids().filter_map(of_link).collect()
}

/// 2 m v_c · (ω × e): ω × e is what the velocity of the link's points changes by along e.
fn per_metre_of_com(
    pose: &Pose,
    response: &ContactResponse,
    link: LinkId,
    inertial: &Inertial,
) -> Option<[f64; 3]> {
    let at = |point: Vector3<f64>| match pose.point_velocity_over_ground(response, link, &point)? {
        PointVelocity::Known(v) => Some(v),
        PointVelocity::Undetermined => None,
    };
    let of_com = at(inertial.com)?;
    let mut rates = [0.0; 3];
    for (i, rate) in rates.iter_mut().enumerate() {
        let along = Vector3::ith(i, 1.0);
        *rate = 2.0 * inertial.mass * of_com.dot(&(at(inertial.com + along)? - of_com));
    }
    Some(rates)
}

fn rotors(answered: &Answered) -> Vec<RotorSensitivity> {
    let (mechanism, response) = (&answered.prepared.model.mechanism, &answered.answer.response);
    let of_joint = |(joint, velocities): (_, &Vec<f64>)| {
        let per_armature: Vec<f64> = velocities.iter().map(|v| v * v).collect();
        let turns = per_armature.iter().any(|rate| *rate > 0.0);
        turns.then(|| RotorSensitivity { joint: mechanism.joint(joint).name().to_owned(), per_armature })
    };
    mechanism.joint_ids().zip(&response.joint_velocities).filter_map(of_joint).collect()
}

/// Central differences of four values: (8 (f(h) − f(−h)) − (f(2h) − f(−2h))) / 12h. What they may be off by is how far they
/// are from those of two.
fn points(model: &Model, question: &MassQuestion) -> Vec<PointSensitivity> {
    let step = POINT_STEP * model.mechanism.characteristic_length();
    let rate = |name: &String, axis: usize| -> Option<(f64, f64)> {
        let at = |parts: f64| {
            let mut by = [0.0; 3];
            by[axis] = parts * step;
            let moves = vec![(name.clone(), by)];
            mass_of(model, question, &Changes { moves, ..Changes::default() })
        };
        let (one, two) = (at(1.0)? - at(-1.0)?, at(2.0)? - at(-2.0)?);
        let rate = (8.0 * one - two) / (12.0 * step);
        Some((rate, (rate - one / (2.0 * step)).abs()))
    };
    let of_point = |name: &String| {
        let rates: Vec<Option<(f64, f64)>> = (0..3).map(|axis| rate(name, axis)).collect();
        let rates: Option<Vec<(f64, f64)>> = rates.into_iter().collect();
        PointSensitivity {
            point: name.clone(),
            per_metre: rates.as_ref().map(|r| [r[0].0, r[1].0, r[2].0]),
            per_metre_error: rates.as_ref().map(|r| r.iter().map(|(_, off)| *off).fold(0.0, f64::max)),
        }
    };
    model.hardpoints().par_iter().map(of_point).collect()
}

/// m̄ of the model with something changed; none where the question has no finite answer.
pub(crate) fn mass_of(model: &Model, question: &MassQuestion, changes: &Changes) -> Option<f64> {
    let changed = model.changed(changes).ok()?;
    let answered = Answered::new(&changed, question).ok()?;
    match answered.answer.response.effective_mass {
        EffectiveMass::Finite(mass) if !answered.answer.response.singular_pose => Some(mass),
        _ => None,
    }
}
