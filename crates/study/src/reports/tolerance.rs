//! Variation of an effective mass within tolerances of masses, centres of mass, armatures and hardpoints: to
//! first order, and by random samples.

use crate::checks::design_variant::no_sheet;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::random_rows::RandomStream;
use crate::model::changes::Changes;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::mass::{Sampling, Tolerance};
use crate::reports::explain::{Explanation, changed_mass, explain_parts};
use crate::thresholds::SAMPLES;
use percuss_dynamics::interruption;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;

/// Variation of m̄ within tolerances.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ToleranceReport {
    /// m̄, kg.
    pub effective_mass: f64,
    /// Tolerances.
    pub tolerance: Tolerance,
    /// First-order variation of m̄, kg: root sum square of the effects of all numbers at their limits, for
    /// independent numbers.
    pub root_sum_square: f64,
    /// First-order variation of m̄, kg: sum of the absolute effects of all numbers at their limits.
    pub worst_case: f64,
    /// Root sum square of each kind of number, kg.
    pub parts: ToleranceParts,
    /// Random samples, if requested.
    pub samples: Option<SampleRecord>,
    /// First-order effect of each number at its limit, largest first; not part of the JSON.
    #[serde(skip)]
    pub effects: Vec<ToleranceEffect>,
}

/// First-order effect of one number at its limit on m̄.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceEffect {
    /// The number, such as `mass of upright` or `lower_ball, z`.
    pub number: String,
    /// Change of m̄ if the number is at its upper limit, kg.
    pub change: f64,
}

/// First-order variation of m̄ due to each kind of number, kg, as root sum square.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct ToleranceParts {
    /// Masses of links.
    pub mass: f64,
    /// Centres of mass.
    pub com: f64,
    /// Armatures.
    pub armature: f64,
    /// Hardpoints.
    pub point: f64,
}

/// m̄ of designs with random deviations, uniform between the limits.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SampleRecord {
    /// Number of samples with a finite m̄.
    pub count: usize,
    /// Number of samples without a finite m̄.
    pub unanswered: usize,
    /// The seed.
    pub seed: u64,
    /// Mean, kg.
    pub mean: f64,
    /// Standard deviation, kg.
    pub standard_deviation: f64,
    /// Smallest m̄, kg.
    pub least: f64,
    /// Largest m̄, kg.
    pub greatest: f64,
    /// 2.5th percentile, kg.
    pub percentile_2_5: f64,
    /// 97.5th percentile, kg.
    pub percentile_97_5: f64,
    /// All finite m̄ in ascending order, kg; not part of the JSON.
    #[serde(skip)]
    pub masses: Vec<f64>,
}

/// Variation of m̄ at a contact within tolerances; `None` if m̄ is not finite or the pose is singular.
///
/// # Errors
/// [`StudyError`], as for `mass`; a tolerance of hardpoints for a model without hardpoints; a number of samples
/// out of range.
pub fn tolerance_report(
    model: &Model,
    question: &MassQuestion,
    tolerance: Tolerance,
    sampling: Option<Sampling>,
) -> Result<Option<ToleranceReport>, StudyError> {
    tolerances_of(&EvaluatedQuestion::new(model, question)?, question, tolerance, sampling)
}

/// Variation of m̄ as for [`tolerance_report`], at the evaluated contact of `question`.
pub(crate) fn tolerances_of(
    evaluated: &EvaluatedQuestion,
    question: &MassQuestion,
    tolerance: Tolerance,
    sampling: Option<Sampling>,
) -> Result<Option<ToleranceReport>, StudyError> {
    let model = evaluated.prepared.model;
    if tolerance.point > 0.0 && model.hardpoints().is_empty() {
        let path = model.inputs.first().map_or_else(String::new, |input| input.path.clone());
        return Err(StudyError::input("mass.tolerance", no_sheet(&path)));
    }
    if let Some(Sampling { count, .. }) = sampling.filter(|s| !SAMPLES.contains(&s.count)) {
        let why = format!("{count} samples; {} to {} are possible", SAMPLES.start(), SAMPLES.end());
        return Err(StudyError::input("mass.samples", why));
    }
    let with_points = tolerance.point > 0.0;
    let Some(explanation) = explain_parts(evaluated, question, with_points) else { return Ok(None) };
    let rates = MassDeviations::from_explanation(model, question, &explanation, tolerance);
    let root = |all: &[ToleranceEffect]| all.iter().map(|e| e.change * e.change).sum::<f64>().sqrt();
    let all = rates.concatenated();
    Ok(Some(ToleranceReport {
        effective_mass: explanation.effective_mass,
        tolerance,
        root_sum_square: root(&all),
        worst_case: all.iter().map(|e| e.change.abs()).sum(),
        parts: ToleranceParts {
            mass: root(&rates.mass),
            com: root(&rates.com),
            armature: root(&rates.armature),
            point: root(&rates.point),
        },
        samples: sampling
            .and_then(|options| sample_masses(model, question, &explanation, tolerance, options)),
        effects: largest_first(all),
    }))
}

/// Effects without zeros, sorted by magnitude.
fn largest_first(mut effects: Vec<ToleranceEffect>) -> Vec<ToleranceEffect> {
    effects.retain(|effect| effect.change != 0.0);
    effects.sort_by(|a, b| b.change.abs().total_cmp(&a.change.abs()));
    effects
}

/// Effect of each number at its limit on m̄, by kind of number.
struct MassDeviations {
    mass: Vec<ToleranceEffect>,
    com: Vec<ToleranceEffect>,
    armature: Vec<ToleranceEffect>,
    point: Vec<ToleranceEffect>,
}

impl MassDeviations {
    /// First-order deviations of m̄: each sensitivity times its tolerance.
    fn from_explanation(
        model: &Model,
        question: &MassQuestion,
        explanation: &Explanation,
        tolerance: Tolerance,
    ) -> Self {
        let effect = |number: String, change: f64| ToleranceEffect { number, change };
        let by_axis = |rates: [f64; 3]| ["x", "y", "z"].into_iter().zip(rates);
        let masses = explanation.links.iter().map(|link| {
            let change = link.per_kilogram * link.mass * tolerance.mass;
            effect(format!("mass of {}", link.link), change)
        });
        let coms = explanation.links.iter().filter_map(|link| Some((link, link.per_metre_of_com?)));
        let coms = coms.flat_map(|(link, rates)| {
            let of_axis = |(axis, rate)| {
                effect(format!("centre of mass of {}, {axis}", link.link), rate * tolerance.com)
            };
            by_axis(rates).map(of_axis).collect::<Vec<_>>()
        });
        let rotors = explanation.rotors.iter().flat_map(|rotor| {
            let own = armature(model, question, &rotor.joint, rotor.per_armature.len());
            let changes = own.into_iter().zip(&rotor.per_armature);
            changes
                .map(|(own, rate)| {
                    effect(format!("armature of {}", rotor.joint), own * rate * tolerance.armature)
                })
                .collect::<Vec<_>>()
        });
        let points = explanation.points.iter().filter_map(|point| Some((point, point.per_metre?)));
        let points = points.flat_map(|(point, rates)| {
            let of_axis = |(axis, rate)| effect(format!("{}, {axis}", point.point), rate * tolerance.point);
            by_axis(rates).map(of_axis).collect::<Vec<_>>()
        });
        Self {
            mass: masses.collect(),
            com: coms.collect(),
            armature: rotors.collect(),
            point: points.collect(),
        }
    }

    /// All deviations in one list.
    fn concatenated(&self) -> Vec<ToleranceEffect> {
        [&self.mass, &self.com, &self.armature, &self.point].into_iter().flatten().cloned().collect()
    }
}

/// Armature of a joint, one value per velocity.
fn armature(model: &Model, question: &MassQuestion, joint: &str, velocities: usize) -> Vec<f64> {
    let options =
        question.conditions.armature.iter().find(|(name, _)| name == joint).map(|(_, values)| values.clone());
    let own = || {
        let id = model.mechanism.find_joint(joint).ok()?;
        Some(model.mechanism.joint(id).armature().to_vec())
    };
    match options.or_else(own).as_deref() {
        None | Some([]) => vec![0.0; velocities],
        Some([one]) => vec![*one; velocities],
        Some(several) => several.to_vec(),
    }
}

/// Statistics of m̄ of random designs within the tolerances; `None` if no design has a finite mass.
fn sample_masses(
    model: &Model,
    question: &MassQuestion,
    explanation: &Explanation,
    tolerance: Tolerance,
    options: Sampling,
) -> Option<SampleRecord> {
    let of_sample = |number: usize| {
        if interruption::is_requested() {
            return None;
        }
        let mut uniform = RandomStream::new(options.seed, number as u64);
        let mut off = |most: f64| most * (2.0 * uniform.next() - 1.0);
        let mut moved = Changes::default();
        if tolerance.point > 0.0 {
            let points = model.hardpoints().iter();
            moved.moves =
                points.map(|point| (point.clone(), [(); 3].map(|()| off(tolerance.point)))).collect();
        }
        // A centre of mass is fixed in the vehicle, but the link frame moves with a hardpoint. Hence the
        // centres of mass are read from the model with the hardpoints moved.
        let model = &model.with_changes(&moved).ok()?;
        let mut changes = Changes::default();
        for link in &explanation.links {
            changes.link_mass.push((link.link.clone(), link.mass * (1.0 + off(tolerance.mass))));
            if tolerance.com > 0.0 {
                let id = model.mechanism.find_link(&link.link).ok()?;
                let com = model.mechanism.link(id).inertial()?.com;
                let com = [com.x, com.y, com.z].map(|x| x + off(tolerance.com));
                changes.link_com.push((link.link.clone(), com));
            }
        }
        let mut question = question.clone();
        for rotor in &explanation.rotors {
            let own = armature(model, &question, &rotor.joint, rotor.per_armature.len());
            if own.iter().any(|value| *value > 0.0) {
                let values = own.iter().map(|value| value * (1.0 + off(tolerance.armature))).collect();
                question.conditions.armature.retain(|(joint, _)| *joint != rotor.joint);
                question.conditions.armature.push((rotor.joint.clone(), values));
            }
        }
        changed_mass(model, &question, &changes)
    };
    let masses: Vec<Option<f64>> = (0..options.count).into_par_iter().map(of_sample).collect();
    interruption::check();
    let mut found: Vec<f64> = masses.into_iter().flatten().collect();
    found.sort_by(f64::total_cmp);
    let (&least, &greatest) = (found.first()?, found.last()?);
    let count = found.len() as f64;
    let mean = found.iter().sum::<f64>() / count;
    let square = found.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / (count - 1.0).max(1.0);
    let at = |part: f64| found[((count - 1.0) * part).round() as usize];
    Some(SampleRecord {
        count: found.len(),
        unanswered: options.count - found.len(),
        seed: options.seed,
        mean,
        standard_deviation: square.sqrt(),
        least,
        greatest,
        percentile_2_5: at(0.025),
        percentile_97_5: at(0.975),
        masses: found,
    })
}
