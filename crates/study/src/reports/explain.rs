//! Sensitivity of an effective mass to the mass, the centre of mass and the armature of each part, and to each
//! hardpoint of a sheet.
//!
//! m̄ = min { vᵀMv : Av = 0, jv = 1 } changes with a parameter p of M alone by dm̄/dp = v*ᵀ (∂M/∂p) v*; the
//! derivative of the motion v* is not needed (docs/reference/FORMULAS.md, F38). Hardpoints change A, j and the pose too; their
//! rates are differences of designs near the pose ([`NearbyMasses`]), or of complete evaluations.

use crate::evaluation::nearby_masses::{NearbyMasses, moved};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::changes::Changes;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::thresholds::{LISTED_CHANGES, POINT_STEP};
use nalgebra::Vector3;
use percuss_dynamics::{ContactResponse, EffectiveMass, PointVelocity, Pose};
use percuss_mechanism::{Inertial, LinkId};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;

/// Sensitivities of an effective mass.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Explanation {
    /// m̄, kg.
    pub effective_mass: f64,
    /// Links with mass, in file order.
    pub links: Vec<LinkSensitivity>,
    /// Joints that move in the motion v*, including joints without armature.
    pub rotors: Vec<RotorSensitivity>,
    /// Hardpoints of a sheet; empty for a URDF.
    pub points: Vec<PointSensitivity>,
    /// Links with the largest rate per kilogram, largest first.
    pub most_per_kilogram: Vec<MassChange>,
    /// Hardpoints with the largest rate per millimetre, largest first.
    pub most_per_millimetre: Vec<PointChange>,
}

/// Sensitivity of m̄ to a link.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LinkSensitivity {
    /// The link.
    pub link: String,
    /// Mass of the link, kg.
    pub mass: f64,
    /// Share of the link in m̄.
    pub share: f64,
    /// dm̄/dm = share · m̄ / m, kg/kg, with moments about the centre of mass in proportion to the mass.
    pub per_kilogram: f64,
    /// dm̄/dc, kg/m, in the link's axes, with constant moments about the centre of mass. Null if a velocity is
    /// undetermined.
    pub per_metre_of_com: Option<[f64; 3]>,
}

/// Sensitivity of m̄ to the armature of a joint.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RotorSensitivity {
    /// The joint.
    pub joint: String,
    /// dm̄/dI = q̇² for each velocity, kg/(kg·m²) for a rotation, kg/kg for a translation.
    pub per_armature: Vec<f64>,
}

/// Sensitivity of m̄ to a hardpoint.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PointSensitivity {
    /// The hardpoint.
    pub point: String,
    /// dm̄/dx, dm̄/dy, dm̄/dz, kg/m, in the sheet's axes; null if the question has no result at a neighbouring
    /// design.
    pub per_metre: Option<[f64; 3]>,
    /// Error estimate of the differences, kg/m.
    pub per_metre_error: Option<f64>,
}

/// Change of mass that lowers m̄; the opposite change raises m̄.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MassChange {
    /// The link.
    pub link: String,
    /// Decrease of m̄ per kilogram of removed mass, kg, to first order.
    pub lowers_by: f64,
}

/// Displacement that lowers m̄; the opposite displacement raises m̄.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PointChange {
    /// The hardpoint.
    pub point: String,
    /// Direction of the displacement, a unit vector in the sheet's axes.
    pub direction: [f64; 3],
    /// Decrease of m̄ per millimetre, kg, to first order.
    pub lowers_by: f64,
}

/// Sensitivities of m̄ at a contact; `None` if m̄ is not finite or the pose is singular.
///
/// # Errors
/// [`StudyError`], as for `mass`.
pub fn explain(model: &Model, question: &MassQuestion) -> Result<Option<Explanation>, StudyError> {
    Ok(explain_parts(&EvaluatedQuestion::new(model, question)?, question, true))
}

/// Sensitivities as for [`explain`], at the evaluated contact of `question`; `with_points`: also those of the hardpoints, which together
/// take the time of some evaluations.
pub(crate) fn explain_parts(
    evaluated: &EvaluatedQuestion,
    question: &MassQuestion,
    with_points: bool,
) -> Option<Explanation> {
    let response = &evaluated.result.response;
    let EffectiveMass::Finite(mass) = response.effective_mass else { return None };
    if response.singular_pose {
        return None;
    }
    let (links, rotors) = (links(evaluated, mass), rotors(evaluated));
    let points = if with_points { rates_of_points(evaluated, question) } else { Vec::new() };
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
    by_place.truncate(LISTED_CHANGES);
    Some(Explanation {
        effective_mass: mass,
        most_per_kilogram: by_mass.iter().take(LISTED_CHANGES).map(of_mass).collect(),
        most_per_millimetre: by_place,
        links,
        rotors,
        points,
    })
}

/// Sensitivities to the mass and the centre of mass of each link.
fn links(evaluated: &EvaluatedQuestion, mass: f64) -> Vec<LinkSensitivity> {
    let (mechanism, response) = (&evaluated.prepared.model.mechanism, &evaluated.result.response);
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
            per_metre_of_com: com_sensitivity(&evaluated.pose, response, id, inertial),
        })
    };
    mechanism.link_ids().filter_map(of_link).collect()
}

/// Rate 2 m v_c · (ω × e) for each axis e; ω × e is the velocity of the point c + e relative to the point c.
fn com_sensitivity(
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

/// Sensitivities to the armature of each joint.
fn rotors(evaluated: &EvaluatedQuestion) -> Vec<RotorSensitivity> {
    let (mechanism, response) = (&evaluated.prepared.model.mechanism, &evaluated.result.response);
    let of_joint = |(joint, velocities): (_, &Vec<f64>)| {
        let per_armature: Vec<f64> = velocities.iter().map(|v| v * v).collect();
        let turns = per_armature.iter().any(|rate| *rate > 0.0);
        turns.then(|| RotorSensitivity { joint: mechanism.joint(joint).name().to_owned(), per_armature })
    };
    mechanism.joint_ids().zip(&response.joint_velocities).filter_map(of_joint).collect()
}

/// Rates by each coordinate of the hardpoints.
fn rates_of_points(evaluated: &EvaluatedQuestion, question: &MassQuestion) -> Vec<PointSensitivity> {
    let model = evaluated.prepared.model;
    let points = model.hardpoints();
    let nearby = if points.is_empty() { None } else { NearbyMasses::new(evaluated, question) };
    let of_point = |name: &String| {
        let near = |axis| nearby.as_ref().and_then(|nearby| nearby.rate(name, axis));
        let rates = (0..3).map(|axis| near(axis).or_else(|| difference(model, question, name, axis)));
        let rates: Option<Vec<(f64, f64)>> = rates.collect();
        PointSensitivity {
            point: name.clone(),
            per_metre: rates.as_ref().map(|r| [r[0].0, r[1].0, r[2].0]),
            per_metre_error: rates.as_ref().map(|r| r.iter().map(|(_, off)| *off).fold(0.0, f64::max)),
        }
    };
    points.par_iter().map(of_point).collect()
}

/// Fourth-order central difference of complete evaluations, (8 (f(h) − f(−h)) − (f(2h) − f(−2h))) / 12h, and its error estimate, the
/// difference from the second-order formula, kg/m.
fn difference(model: &Model, question: &MassQuestion, name: &str, axis: usize) -> Option<(f64, f64)> {
    let step = POINT_STEP * model.mechanism.characteristic_length();
    let at = |parts: f64| {
        let changes = Changes { moves: vec![moved(name, axis, parts * step)], ..Changes::default() };
        changed_mass(model, question, &changes)
    };
    let (one, two) = (at(1.0)? - at(-1.0)?, at(2.0)? - at(-2.0)?);
    let rate = (8.0 * one - two) / (12.0 * step);
    Some((rate, (rate - one / (2.0 * step)).abs()))
}

/// m̄ of the changed model; `None` without a finite result or at a singular pose.
pub(crate) fn changed_mass(model: &Model, question: &MassQuestion, changes: &Changes) -> Option<f64> {
    let changed = model.with_changes(changes).ok()?;
    let evaluated = EvaluatedQuestion::new(&changed, question).ok()?;
    match evaluated.result.response.effective_mass {
        EffectiveMass::Finite(mass) if !evaluated.result.response.singular_pose => Some(mass),
        _ => None,
    }
}
