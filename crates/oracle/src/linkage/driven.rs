//! Mechanism with loops and driving joints.

use crate::limits;
use crate::maximal::{NotClosed, close};
use crate::positions::{follow, zero_positions};
use percuss_mechanism::{JointId, Mechanism};

/// Mechanism with loops, driving joints and a start position.
#[derive(Debug)]
pub struct Linkage {
    /// Name in [`all`](super::all).
    pub name: &'static str,
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Driving joints, each with one position; their number is the mobility on the ground without free massless
    /// rotations.
    pub drivers: Vec<String>,
    /// Start position near a closed, non-singular position; joints without entry are at zero.
    pub start: Vec<(String, Vec<f64>)>,
    /// Range of each driver in which the linkage stays on its branch, for any values of the other drivers in
    /// their ranges.
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

    /// Joint by name. Panics for an unknown name.
    fn joint(&self, name: &str) -> JointId {
        match self.mechanism.find_joint(name) {
            Ok(id) => id,
            Err(error) => panic!("{}: {error}", self.name),
        }
    }

    /// Joints that move and are neither drivers nor mimics.
    pub fn dependent(&self) -> Vec<JointId> {
        let drivers: Vec<JointId> = self.drivers.iter().map(|name| self.joint(name)).collect();
        let follows = |id: &JointId| {
            let joint = self.mechanism.joint(*id);
            joint.kind().dofs() > 0 && joint.mimic().is_none() && !drivers.contains(id)
        };
        self.mechanism.joint_ids().filter(follows).collect()
    }

    /// Closed position at the start values of the drivers.
    ///
    /// # Panics
    /// If the start does not close: an error in the zoo.
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

    /// Values of the drivers in a position.
    pub fn drivers_at(&self, positions: &[Vec<f64>]) -> Vec<f64> {
        self.drivers.iter().map(|name| positions[self.joint(name).index()][0]).collect()
    }

    /// Moves the drivers from a closed position to new values in small steps, on the same branch.
    ///
    /// # Errors
    /// [`NotClosed`] if a position on the straight path of the drivers cannot be closed.
    pub fn move_drivers(&self, from: &[Vec<f64>], drivers: &[f64]) -> Result<Vec<Vec<f64>>, NotClosed> {
        let (begin, dependent) = (self.drivers_at(from), self.dependent());
        let steps = begin.iter().zip(drivers).zip(&self.range).map(|((a, b), range)| {
            ((b - a).abs() / (limits::DRIVER_STEP * (range[1] - range[0])))
                .ceil()
                .min(limits::MAX_DRIVER_STEPS)
        });
        let steps = steps.fold(1.0, f64::max);
        let mut positions = from.to_vec();
        let mut previous = positions.clone();
        for k in 1..=steps as usize {
            let part = k as f64 / steps;
            // Linear extrapolation of the last step, except for quaternions.
            let mut guess = positions.clone();
            for (g, b) in guess.iter_mut().zip(&previous).filter(|(g, _)| g.len() == 1) {
                g[0] += g[0] - b[0];
            }
            for ((name, a), b) in self.drivers.iter().zip(&begin).zip(drivers) {
                guess[self.joint(name).index()][0] = if part == 1.0 { *b } else { a + part * (b - a) };
            }
            previous = std::mem::replace(&mut positions, close(&self.mechanism, &guess, &dependent)?);
        }
        Ok(positions)
    }

    /// Returns `count` closed positions with all drivers moving through their ranges together, in ascending order.
    ///
    /// # Panics
    /// If a position in the range does not close: an error in the zoo.
    pub fn sweep(&self, count: usize) -> Vec<Vec<Vec<f64>>> {
        let mut positions = self.closed_start();
        let mut all = Vec::with_capacity(count);
        for i in 0..count {
            let part = if count > 1 { i as f64 / (count - 1) as f64 } else { 0.5 };
            let drivers: Vec<f64> = self.range.iter().map(|[from, to]| from + part * (to - from)).collect();
            positions = match self.move_drivers(&positions, &drivers) {
                Ok(reached) => reached,
                Err(error) => panic!("{} at {drivers:?}: {error}", self.name),
            };
            all.push(positions.clone());
        }
        all
    }
}
