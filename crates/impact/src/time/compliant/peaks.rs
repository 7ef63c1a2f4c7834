//! Largest forces of the bushes and elements over the time of an impact.

use super::flow::Flow;
use crate::time::history::peak_over_time;
use nalgebra::DVector;
use percuss_dynamics::{ElasticDirection, ElasticMotion, JointForce};

/// Levels of halving between the samples near a peak, once per refinement.
const FINER: usize = 4;
/// Largest number of refinements: each is sixteen times as fine, so that the parabola across a corner of a force has nine digits.
const MOST_REFINEMENTS: usize = 6;
/// Relative change of a peak by a refinement at which the refinements end.
const REFINED: f64 = 1e-11;
/// Part of the largest estimate from which another maximum is refined too: the estimates have four digits.
const NEAR_LARGEST: f64 = 0.999;
/// Largest number of refined maxima of one force.
const MOST_REFINED: usize = 16;

/// States of a motion over time.
#[derive(Default)]
pub(super) struct Trace {
    /// Times since the touch, s.
    pub times: Vec<f64>,
    /// Level of the step before each sample.
    pub levels: Vec<usize>,
    pub states: Vec<DVector<f64>>,
    /// Forces that are not linear.
    pub forces: Vec<DVector<f64>>,
}

impl Trace {
    pub fn add(&mut self, flow: &Flow, time: f64, level: usize, state: DVector<f64>) {
        self.times.push(time);
        self.levels.push(level);
        self.forces.push(flow.forces(&state));
        self.states.push(state);
    }

    /// Values of a quantity at all samples.
    pub fn values(&self, quantity: impl Fn(&DVector<f64>, &DVector<f64>) -> f64) -> Vec<f64> {
        self.states.iter().zip(&self.forces).map(|(state, forces)| quantity(state, forces)).collect()
    }
}

/// Rows of the elements whose forces form one result.
pub(super) struct Quantity {
    pub element: String,
    /// `None`: magnitude of the three forces of a bush.
    pub direction: Option<ElasticDirection>,
    pub number: Option<usize>,
    pub is_moment: bool,
    /// Rows.
    rows: Vec<RowForce>,
    /// Number of an ideal joint in place of the rows.
    joint: Option<usize>,
}

/// Force of a row: k x + c ẋ − preload and the value of an input.
struct RowForce {
    row: usize,
    stiffness: f64,
    damping: f64,
    preload: f64,
    input: Option<usize>,
}

impl Quantity {
    /// All rows with a force, the magnitude of the forces of every bush, and that of every ideal joint. `input_of`: input of the element with a number.
    pub fn all(
        motion: &ElasticMotion,
        joints: &[JointForce],
        input_of: impl Fn(usize) -> Option<usize>,
    ) -> Vec<Self> {
        let force = |row: usize| {
            let of = &motion.rows[row];
            let input = of.number.and_then(&input_of);
            RowForce { row, stiffness: of.stiffness, damping: of.damping, preload: of.preload, input }
        };
        let acts = |row: &usize| {
            let force = force(*row);
            motion.rows[*row].direction != ElasticDirection::Geometric && force.stiffness > 0.0
                || force.damping > 0.0
                || force.input.is_some()
        };
        let mut all: Vec<Self> = Vec::new();
        for row in (0..motion.rows.len()).filter(acts) {
            let of = &motion.rows[row];
            let is_translation = matches!(
                of.direction,
                ElasticDirection::RadialX | ElasticDirection::RadialY | ElasticDirection::Axial
            );
            if is_translation {
                let is_same = |other: &&mut Self| other.direction.is_none() && other.element == of.element;
                match all.iter_mut().find(is_same) {
                    Some(sum) => sum.rows.push(force(row)),
                    None => all.push(Self {
                        element: of.element.clone(),
                        direction: None,
                        number: None,
                        is_moment: false,
                        rows: vec![force(row)],
                        joint: None,
                    }),
                }
            }
            all.push(Self {
                element: of.element.clone(),
                direction: Some(of.direction),
                number: of.number,
                is_moment: of.is_moment,
                rows: vec![force(row)],
                joint: None,
            });
        }
        all.extend(joints.iter().enumerate().map(|(number, joint)| Self {
            element: joint.name.clone(),
            direction: None,
            number: None,
            is_moment: false,
            rows: Vec::new(),
            joint: Some(number),
        }));
        all
    }

    /// Force at a state: with the sign of the displacement for one row, otherwise the magnitude.
    pub fn at(&self, flow: &Flow, state: &DVector<f64>, forces: &DVector<f64>) -> f64 {
        if let Some(joint) = self.joint {
            let squares = flow.joints[joint].iter().map(|line| line.at(state, forces).0.powi(2));
            return squares.sum::<f64>().sqrt();
        }
        let inputs = flow.inputs(forces);
        let force = |row: &RowForce| {
            let (x, v) = flow.rows[row.row].at(state, forces);
            row.stiffness * x + row.damping * v - row.preload + row.input.map_or(0.0, |input| inputs[input])
        };
        match &self.rows[..] {
            [row] if self.direction.is_some() => force(row),
            rows => rows.iter().map(|row| force(row).powi(2)).sum::<f64>().sqrt(),
        }
    }
}

/// Largest magnitude of a quantity and its time, refined between the samples.
pub(super) fn peak(
    flow: &mut Flow,
    trace: &Trace,
    quantity: impl Fn(&Flow, &DVector<f64>, &DVector<f64>) -> f64,
) -> (f64, f64) {
    let values = trace.values(|state, forces| quantity(flow, state, forces).abs());
    let last = values.len().saturating_sub(1);
    let value = |k: usize| values.get(k).copied().unwrap_or(0.0);
    let ends = [(value(0), trace.times[0]), (value(last), trace.times[last])];
    let mut best = if ends[1].0 > ends[0].0 { ends[1] } else { ends[0] };
    let is_maximum = |k: &usize| value(*k) >= value(k - 1) && value(*k) >= value(k + 1) && value(*k) > 0.0;
    let estimate = |k: usize| {
        let near = k - 1..k + 2;
        peak_over_time(&trace.times[near.clone()], &values[near]).map_or(0.0, |(most, _)| most)
    };
    let mut maxima: Vec<(f64, usize)> = (1..last).filter(is_maximum).map(|k| (estimate(k), k)).collect();
    maxima.sort_by(|a, b| b.0.total_cmp(&a.0));
    let least = NEAR_LARGEST * maxima.first().map_or(0.0, |(most, _)| *most);
    for (_, k) in maxima.into_iter().take(MOST_REFINED).filter(|(most, _)| *most >= least) {
        let mut level = trace.levels[k].max(trace.levels[k + 1]);
        let mut start = (trace.times[k - 1], trace.states[k - 1].clone());
        let mut end = trace.times[k + 1];
        let mut peak = (0.0, 0.0);
        for _ in 0..MOST_REFINEMENTS {
            level += FINER;
            let part = flow.step_of(level);
            let (mut times, mut fine, mut states) = (Vec::new(), Vec::new(), Vec::new());
            let mut at = start.clone();
            // Up to the rounding of the times.
            while at.0 < end + 1e-3 * part {
                let forces = flow.forces(&at.1);
                times.push(at.0);
                fine.push(quantity(flow, &at.1, &forces).abs());
                let next = flow.advance(&at.1, level);
                let later = (at.0 + part, next);
                states.push(std::mem::replace(&mut at, later));
            }
            let before = peak;
            peak = peak_over_time(&times, &fine).unwrap_or(before);
            if (peak.0 - before.0).abs() <= REFINED * peak.0 {
                break;
            }
            let most = (0..fine.len()).max_by(|&a, &b| fine[a].total_cmp(&fine[b])).unwrap_or(0);
            end = times[(most + 1).min(times.len() - 1)];
            start = states.swap_remove(most.saturating_sub(1));
        }
        if peak.0 > best.0 {
            best = peak;
        }
    }
    best
}
