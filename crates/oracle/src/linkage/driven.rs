//! A mechanism with loops and the joints that drive it.

use crate::limits;
use crate::maximal::{NotClosed, close};
use crate::positions::{follow, zero_positions};
use percuss_mechanism::{JointId, Mechanism};

/// A mechanism with loops, and how it is driven.
#[derive(Debug)]
pub struct Linkage {
    /// What it is called among [`all`](super::all).
    pub name: &'static str,
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Joints with one position that drive it: as many as its mobility on the ground, free massless spins aside.
    pub drivers: Vec<String>,
    /// A position not far from a closed, non-singular one; joints that are not named stand at zero.
    pub start: Vec<(String, Vec<f64>)>,
    /// From where to where each driver can go, all others anywhere in theirs, without leaving the assembly.
    pub range: Vec<[f64; 2]>,
}

impl Linkage {
    pub(super) fn new<'a>(
        mechanism: Mechanism,
        name: &'static str,
        drivers: impl IntoIterator<Item = (&'a str, [f64; 2])>,
        start: impl IntoIterator<Item = (&'a str, f64)>,
    ) -> Self {
        let (drivers, range) = drivers.into_iter().map(|(name, range)| (name.to_owned(), range)).unzip();
        let start = start.into_iter().map(|(name, value)| (name.to_owned(), vec![value])).collect();
        Self { name, mechanism, drivers, start, range }
    }

    fn joint(&self, name: &str) -> JointId {
        match self.mechanism.find_joint(name) {
            Ok(id) => id,
            Err(error) => panic!("{}: {error}", self.name),
        }
    }

    /// Every joint that moves and neither drives nor mimics.
    pub fn dependent(&self) -> Vec<JointId> {
        let drivers: Vec<JointId> = self.drivers.iter().map(|name| self.joint(name)).collect();
        let follows = |id: &JointId| {
            let joint = self.mechanism.joint(*id);
            joint.kind().dofs() > 0 && joint.mimic().is_none() && !drivers.contains(id)
        };
        self.mechanism.joint_ids().filter(follows).collect()
    }

    /// The closed position at the drivers' start.
    ///
    /// # Panics
    /// Where the start does not close: a mistake in the zoo.
    pub fn closed_start(&self) -> Vec<Vec<f64>> {
        let mut positions = zero_positions(&self.mechanism);
        for (name, value) in &self.start {
            positions[self.joint(name).index()].clone_from(value);
        }
        follow(&self.mechanism, &mut positions);
        match close(&self.mechanism, &positions, &self.dependent()) {
            Ok(closed) => closed,
            Err(error) => panic!("{}: {error}", self.name),
        }
    }

    /// Where the drivers stand in a position.
    pub fn drivers_at(&self, positions: &[Vec<f64>]) -> Vec<f64> {
        self.drivers.iter().map(|name| positions[self.joint(name).index()][0]).collect()
    }

    /// Moves from a closed position in small steps to the drivers' values, on the same branch.
    ///
    /// # Errors
    /// [`NotClosed`] where the straight way there cannot be closed.
    pub fn go(&self, from: &[Vec<f64>], drivers: &[f64]) -> Result<Vec<Vec<f64>>, NotClosed> {
        let (begin, dependent) = (self.drivers_at(from), self.dependent());
        let steps = begin.iter().zip(drivers).zip(&self.range).map(|((a, b), range)| {
            ((b - a).abs() / (limits::DRIVER_STEP * (range[1] - range[0])))
                .ceil()
                .min(limits::MOST_DRIVER_STEPS)
        });
        let steps = steps.fold(1.0, f64::max);
        let mut here = from.to_vec();
        let mut before = here.clone();
        for k in 1..=steps as usize {
            let part = k as f64 / steps;
            // The last step again is the best guess of the next, turns that are quaternions aside.
            let mut guess = here.clone();
            for (g, b) in guess.iter_mut().zip(&before).filter(|(g, _)| g.len() == 1) {
                g[0] += g[0] - b[0];
            }
            for ((name, a), b) in self.drivers.iter().zip(&begin).zip(drivers) {
                guess[self.joint(name).index()][0] = if part == 1.0 { *b } else { a + part * (b - a) };
            }
            before = std::mem::replace(&mut here, close(&self.mechanism, &guess, &dependent)?);
        }
        Ok(here)
    }

    /// Closed positions, `count` of them, the drivers going through their ranges together, lowest first.
    ///
    /// # Panics
    /// Where the range cannot be closed: a mistake in the zoo.
    pub fn sweep(&self, count: usize) -> Vec<Vec<Vec<f64>>> {
        let mut here = self.closed_start();
        let mut all = Vec::with_capacity(count);
        for i in 0..count {
            let part = if count > 1 { i as f64 / (count - 1) as f64 } else { 0.5 };
            let drivers: Vec<f64> = self.range.iter().map(|[from, to]| from + part * (to - from)).collect();
            here = match self.go(&here, &drivers) {
                Ok(there) => there,
                Err(error) => panic!("{} at {drivers:?}: {error}", self.name),
            };
            all.push(here.clone());
        }
        all
    }
}
