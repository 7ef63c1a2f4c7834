//! Samples of an impact in time, and the largest forces between the samples.

use crate::reactions::reaction::Reactions;
use crate::reactions::reaction_map::{ReactionBuffers, ReactionMap};
use crate::time::equations::rates_of;
use crate::time::history::ImpactSample;
use crate::time::motion::{BASE, Instant, Motion, finite_mass};
use crate::tolerances::{GOLDEN, MOST_PEAKS, NEAR_PEAK, NO_FORCE, PEAK_WIDTH};
use percuss_dynamics::{Contact, Pose, Workspace};

/// Samples of an impact, with reused buffers.
pub(super) struct Sampler {
    /// Pose of the sample.
    pub pose: Pose,
    map: ReactionMap,
    buffers: ReactionBuffers,
    masses: Workspace,
    pub samples: Vec<ImpactSample>,
    /// State at each sample.
    nodes: Vec<Node>,
}

/// Scaled state at a sample.
struct Node {
    /// Scaled time.
    time: f64,
    state: Vec<f64>,
    /// Derivative of the state by scaled time.
    rate: Vec<f64>,
    /// Direction of the motion after the sample, for a force that jumps at the reversal.
    is_closing: bool,
}

impl Sampler {
    pub fn new(motion: &Motion) -> Self {
        let pose = motion.start.clone();
        let (map, masses) = (ReactionMap::new(&pose), pose.assembly().workspace());
        let (samples, nodes) = (Vec::new(), Vec::new());
        Self { pose, map, buffers: ReactionBuffers::default(), masses, samples, nodes }
    }

    /// Adds a sample at the current pose. `time`: scaled time; `state` and `rate`: scaled state and its derivative by scaled time.
    pub fn add(&mut self, motion: &Motion, time: f64, at: &Instant, (state, rate): (&[f64], &[f64])) {
        let reactions = self.reactions(motion, at, rate);
        let effective_mass = self.effective_mass(motion.contact);
        let pose = &self.pose;
        self.samples.push(ImpactSample {
            time: time * motion.depth / motion.speed,
            penetration: at.penetration,
            rate: at.closing,
            force: at.force,
            effective_mass,
            loop_gap: pose.loops().map_or(0.0, |loops| loops.residual),
            reactions,
            positions: pose.positions().to_vec(),
            base: *pose.base(),
            rates: rates_of(pose, &at.rates),
        });
        let (state, rate) = (state.to_vec(), rate.to_vec());
        self.nodes.push(Node { time, state, rate, is_closing: motion.is_closing.get() });
    }

    /// Adds the samples within a step that starts at the scaled time `time` and has the scaled duration `h`. `states`: state at a scaled
    /// time after the start of the step.
    pub fn add_within(&mut self, motion: &Motion, time: f64, h: f64, states: &dyn Fn(f64) -> Vec<f64>) {
        let count = motion.conditions.samples_within_steps;
        if count == 0 {
            return;
        }
        let end = self.pose.clone();
        for k in 1..=count {
            let part = h * k as f64 / (count + 1) as f64;
            let state = states(part);
            let mut rate = vec![0.0; state.len()];
            motion.derivative(&state, &mut rate);
            let Some(at) = motion.take_instant(&mut self.pose) else { continue };
            self.add(motion, time + part, &at, (&state, &rate));
        }
        self.pose = end;
    }

    /// Reactions in all joints and loops at the current pose. `rate`: derivative of the scaled state by scaled time.
    fn reactions(&mut self, motion: &Motion, at: &Instant, rate: &[f64]) -> Reactions {
        let pose = &self.pose;
        let unit = motion.rate * motion.speed / motion.depth;
        let first = motion.start.positions().len() + BASE;
        let scaled = rate[first..].iter().zip(&motion.lengths);
        let change: Vec<f64> = scaled.map(|(scaled, length)| scaled * unit / length).collect();
        self.map.update(pose);
        self.map.apply_springs(pose, &motion.springs, &at.rates);
        let mut reactions = Reactions::none();
        self.map.reactions_in_motion(
            pose,
            &at.contact,
            at.force,
            (&at.rates[..], &change[..]),
            &motion.gravity(pose),
            &mut self.buffers,
            &mut reactions,
        );
        reactions
    }

    /// m̄ at the pose; `None` if it is not finite.
    fn effective_mass(&mut self, contact: &Contact) -> Option<f64> {
        // The compiled kernel of the workspace is several times as fast as the recursion at a pose.
        let masses = &mut self.masses;
        let is_set =
            masses.set_positions(self.pose.positions()).is_ok() && masses.set_base(self.pose.base()).is_ok();
        match masses.effective_mass(contact) {
            Ok(mass) if is_set => mass.kilograms(),
            _ => finite_mass(&self.pose, contact),
        }
    }

    /// Largest force of the contact, N.
    pub fn peak_force(&mut self, motion: &Motion) -> f64 {
        let forces: Vec<f64> = self.samples.iter().map(|sample| sample.force).collect();
        let (nodes, pose) = (&self.nodes, &mut self.pose);
        let mut force = |k: usize, time: f64| {
            let state = state_between(nodes, motion, k, time);
            motion.instant(&state, pose).map_or(0.0, |at| at.force)
        };
        largest(nodes, &forces, 0.0, &mut force).0
    }

    /// Largest force (N) in each bearing and its time (s), in the order of [`Reactions::determinate_forces`]; empty without samples within the steps.
    pub fn bearing_peaks(&mut self, motion: &Motion) -> Vec<(f64, f64)> {
        if motion.conditions.samples_within_steps == 0 {
            return Vec::new();
        }
        let all: Vec<Vec<f64>> =
            self.samples.iter().map(|sample| sample.reactions.determinate_forces()).collect();
        let contact = self.samples.iter().map(|sample| sample.force.abs()).fold(0.0, f64::max);
        let nodes = std::mem::take(&mut self.nodes);
        let mut rate = Vec::new();
        let mut peak = |bearing: usize| {
            let forces: Vec<f64> = all.iter().map(|forces| forces[bearing]).collect();
            let mut force = |k: usize, time: f64| {
                let state = state_between(&nodes, motion, k, time);
                rate.resize(state.len(), 0.0);
                motion.derivative(&state, &mut rate);
                let at = motion.take_instant(&mut self.pose);
                at.map_or(0.0, |at| self.reactions(motion, &at, &rate).determinate_forces()[bearing])
            };
            let (force, time) = largest(&nodes, &forces, NO_FORCE * contact, &mut force);
            (force, time * motion.depth / motion.speed)
        };
        (0..all.first().map_or(0, Vec::len)).map(&mut peak).collect()
    }
}

/// State at a scaled time between the samples `k` and `k + 1`: cubic polynomial through both states with their derivatives. The interval has no point
/// of the force curve and no reversal inside. Sets the direction of the motion.
fn state_between(nodes: &[Node], motion: &Motion, k: usize, time: f64) -> Vec<f64> {
    let (a, b) = (&nodes[k], &nodes[k + 1]);
    motion.is_closing.set(a.is_closing);
    let h = b.time - a.time;
    let x = (time - a.time) / h;
    let (of_end, of_rates) =
        (x * x * (3.0 - 2.0 * x), [x * (1.0 - x) * (1.0 - x) * h, x * x * (x - 1.0) * h]);
    let value = |i: usize| {
        let change = b.state[i] - a.state[i];
        a.state[i] + of_end * change + of_rates[0] * a.rate[i] + of_rates[1] * b.rate[i]
    };
    (0..a.state.len()).map(value).collect()
}

/// Largest value of a quantity and its scaled time, from its values at the samples and, about their maxima, by golden sections between the samples:
/// `value` at a scaled time after the sample of a number. Values up to `least` are rounding. At a time with two samples the quantity can jump.
fn largest(
    nodes: &[Node],
    values: &[f64],
    least: f64,
    value: &mut dyn FnMut(usize, f64) -> f64,
) -> (f64, f64) {
    let is_interval = |k: usize| k + 1 < nodes.len() && nodes[k + 1].time > nodes[k].time;
    let before = |k: usize| if k > 0 && is_interval(k - 1) { k - 1 } else { k };
    let after = |k: usize| if is_interval(k) { k + 1 } else { k };
    let most = values.iter().copied().fold(0.0, f64::max);
    let is_peak = |k: &usize| {
        let v = values[*k];
        v > least && v >= NEAR_PEAK * most && v >= values[before(*k)] && v >= values[after(*k)]
    };
    let mut peaks: Vec<usize> = (0..nodes.len()).filter(is_peak).collect();
    peaks.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let mut best = peaks.first().map_or((most, 0.0), |k| (values[*k], nodes[*k].time));
    for k in peaks.into_iter().take(MOST_PEAKS) {
        let (first, middle) = (before(k), nodes[k].time);
        let (mut from, mut to) = (nodes[first].time, nodes[after(k)].time);
        let end = PEAK_WIDTH * (to - from);
        let mut at = |time: f64| {
            let found = value(if time < middle { first } else { k }, time);
            if found > best.0 {
                best = (found, time);
            }
            found
        };
        let (mut low, mut high) = (at(to - GOLDEN * (to - from)), at(from + GOLDEN * (to - from)));
        while to - from > end {
            if low > high {
                (to, high) = (from + GOLDEN * (to - from), low);
                low = at(to - GOLDEN * (to - from));
            } else {
                (from, low) = (to - GOLDEN * (to - from), high);
                high = at(from + GOLDEN * (to - from));
            }
        }
    }
    best
}
