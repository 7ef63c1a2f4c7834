//! Energetic law of several simultaneous contacts.

use crate::error::ImpactError;
use crate::mobility::semidefinite::contact_scale;
use crate::numerics::extrapolation::{controlled_step, step};
use crate::tolerances::{
    COMPLEMENTARY, DIFFERENT_FREQUENCIES, LEAST_ENERGETIC, MOST_ENERGETIC_STEPS, STEP_ERROR,
};
use nalgebra::{DMatrix, DVector};

/// Stiffness ratios of the contacts, and exponent of their forces k δ^η.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactStiffness {
    /// Stiffness of each contact; only the ratios matter.
    pub ratios: Vec<f64>,
    /// η: 1 for linear springs, 3/2 for spheres (Hertz).
    pub exponent: f64,
}

/// Normal impulses by the energetic law with the stiffness ratios of the contacts.
///
/// The forces are F_i = k_i δ_i^η, with δ_i′ = −u_i while the gap closes and −u_i/e_i² while it opens, so that each contact returns e_i²
/// of its energy. With e_i = 0 the force vanishes at the end of compression, the limit for e_i → 0. The impulses are the integrals of F
/// with u′ = W F; the pose is constant. This is the law of Liu, Zhao and Brogliato 2008 in time instead of impulses: dP_i/dP_j =
/// (k_i/k_j)^{1/(η+1)} (E_i/E_j)^{η/(η+1)} with the stored energies E.
///
/// As in that source, a contact has no gap: a contact that has opened stays at δ = 0, and closes again as soon as its speed is negative.
/// Springs first have to cross the gap that has opened. Both agree if no contact closes again. For the elastic uniform rod that falls flat on
/// stops at both ends with the stiffnesses 1 and 4, this law gives the speeds 1.4248 and 0.50306, and springs give 1.3735 and 0.57226.
///
/// # Errors
/// [`ImpactError`]: coefficients of restitution between 0 and 0.01 (expansions too short for the integration), stiffnesses or an
/// exponent out of range, an impact without an end.
pub(crate) fn energetic_impulses(
    matrix: &DMatrix<f64>,
    before: &DVector<f64>,
    restitution: &[f64],
    stiffness: &ContactStiffness,
) -> Result<DVector<f64>, ImpactError> {
    for &e in restitution {
        if e > 0.0 && e < LEAST_ENERGETIC {
            let valid = "0, or a number from 0.01 to 1 for the energetic law";
            return Err(ImpactError::OutOfRange { what: "the coefficient of restitution", got: e, valid });
        }
    }
    for &ratio in &stiffness.ratios {
        if !(ratio.is_finite() && ratio > 0.0) {
            let valid = "a number above zero";
            return Err(ImpactError::OutOfRange { what: "a ratio of stiffnesses", got: ratio, valid });
        }
    }
    if !(1.0..=10.0).contains(&stiffness.exponent) {
        let (what, valid) = ("the exponent of the contact forces", "a number from 1 to 10");
        return Err(ImpactError::OutOfRange { what, got: stiffness.exponent, valid });
    }
    let contacts = Contacts::new(matrix, before, restitution, stiffness);
    contacts.integrate().ok_or_else(|| {
        let frequency = |i: &usize| contacts.frequencies[*i];
        let movable = (0..before.len()).filter(|i| frequency(i) > 0.0);
        let slowest = movable.min_by(|a, b| frequency(a).total_cmp(&frequency(b))).unwrap_or(0);
        match frequency(&slowest).recip() {
            ratio if ratio > DIFFERENT_FREQUENCIES => {
                ImpactError::SlowContact { contact: slowest + 1, ratio }
            }
            _ => ImpactError::NoEnd { law: "energetic" },
        }
    })
}

/// State of a contact during the impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    Open,
    Compression,
    Expansion,
}

/// Contacts in units in which each mobility W_ii is one: speeds u_i/√W_ii over the largest, impulses P_i √W_ii, and stiffnesses
/// k_i W_ii^((η+1)/2) over the largest. The speed, the stiffness and the impulse of an immovable contact are zero.
struct Contacts<'a> {
    mobility: DMatrix<f64>,
    before: DVector<f64>,
    ratios: Vec<f64>,
    /// Natural frequency of each contact alone at unit speed, relative to the highest.
    frequencies: Vec<f64>,
    restitution: &'a [f64],
    exponent: f64,
    /// Impulse of one unit of each contact, N·s.
    units: DVector<f64>,
}

impl<'a> Contacts<'a> {
    fn new(
        matrix: &DMatrix<f64>,
        before: &DVector<f64>,
        restitution: &'a [f64],
        stiffness: &ContactStiffness,
    ) -> Self {
        let scale = contact_scale(matrix);
        let speeds = before.component_mul(&scale);
        let (speed, power) = (speeds.amax(), stiffness.exponent + 1.0);
        let ratio = |(ratio, scale): (&f64, &f64)| if *scale > 0.0 { ratio / scale.powf(power) } else { 0.0 };
        let ratios: Vec<f64> = stiffness.ratios.iter().zip(scale.iter()).map(ratio).collect();
        let largest = ratios.iter().copied().fold(0.0, f64::max);
        let ratios: Vec<f64> = ratios.iter().map(|ratio| ratio / largest).collect();
        Self {
            mobility: DMatrix::from_fn(ratios.len(), ratios.len(), |r, c| {
                scale[r] * matrix[(r, c)] * scale[c]
            }),
            before: speeds / speed,
            frequencies: ratios.iter().map(|ratio| ratio.powf(1.0 / power)).collect(),
            ratios,
            restitution,
            exponent: stiffness.exponent,
            units: scale * speed,
        }
    }

    /// Opening speed of contact `i`. State `y`: depths δ of all contacts, then their impulses.
    fn velocity(&self, y: &[f64], i: usize) -> f64 {
        let k = self.ratios.len();
        self.before[i] + (0..k).map(|c| self.mobility[(i, c)] * y[k + c]).sum::<f64>()
    }

    /// Rates `r` of the state `y` in given modes. They stay smooth beyond the end of a mode, where the integration evaluates them too.
    fn rates(&self, modes: &[Mode], y: &[f64], r: &mut [f64]) {
        let k = modes.len();
        for (i, mode) in modes.iter().enumerate() {
            let factor = match mode {
                Mode::Open => 0.0,
                Mode::Compression => 1.0,
                Mode::Expansion => 1.0 / (self.restitution[i] * self.restitution[i]),
            };
            r[i] = -factor * self.velocity(y, i);
            let force = self.ratios[i] * y[i].abs().powf(self.exponent).copysign(y[i]);
            r[k + i] = if *mode == Mode::Open { 0.0 } else { force };
        }
    }

    /// Next mode of contact `i` in the state `y`; `None` if the contact is still in the current `mode`.
    fn next_mode(&self, mode: Mode, y: &[f64], i: usize) -> Option<Mode> {
        let u = self.velocity(y, i);
        match mode {
            // Contacts with a small e close repeatedly; their speeds decrease geometrically. Speeds that are rounding end the sequence.
            Mode::Open if y[self.ratios.len() + i] > 0.0 => (u < -COMPLEMENTARY).then_some(Mode::Compression),
            Mode::Open => (u < 0.0).then_some(Mode::Compression),
            // A plastic contact has no expansion.
            Mode::Compression if self.restitution[i] == 0.0 => (u >= 0.0).then_some(Mode::Open),
            Mode::Compression => (u > 0.0).then_some(Mode::Expansion),
            Mode::Expansion if y[i] <= 0.0 => Some(Mode::Open),
            Mode::Expansion => (u < 0.0).then_some(Mode::Compression),
        }
    }

    /// Impulses, N·s; `None` if the impact does not end.
    fn integrate(&self) -> Option<DVector<f64>> {
        let k = self.ratios.len();
        let mut modes: Vec<Mode> = vec![Mode::Open; k];
        let mut y = vec![0.0; 2 * k];
        let part = 0.1 / (k as f64).sqrt();
        let mut h = 1e-3 * part;
        for _ in 0..MOST_ENERGETIC_STEPS {
            let mut changed = false;
            for i in 0..k {
                if let Some(next) = self.next_mode(modes[i], &y, i) {
                    modes[i] = next;
                    changed = true;
                    if next == Mode::Open {
                        y[i] = 0.0;
                    }
                }
            }
            if !changed && modes.iter().all(|mode| *mode == Mode::Open) {
                return Some(DVector::from_fn(k, |i, _| y[k + i] * self.units[i]));
            }
            let closed = (0..k).filter(|i| modes[*i] != Mode::Open);
            let largest_step = part / closed.map(|i| self.frequencies[i]).fold(0.0, f64::max);
            let rates = |y: &[f64], r: &mut [f64]| self.rates(&modes, y, r);
            let (next, taken, proposal) = controlled_step(&rates, &y, h.min(largest_step), STEP_ERROR);
            h = proposal;
            let leaves = |y: &[f64]| (0..k).any(|i| self.next_mode(modes[i], y, i).is_some());
            if !leaves(&next) {
                y = next;
                continue;
            }
            // The first end of a mode, by bisection over the length of the step.
            let (mut low, mut high, mut found) = (0.0, taken, next);
            loop {
                let middle = 0.5 * (low + high);
                if middle <= low || middle >= high {
                    break;
                }
                let (at, _) = step(&rates, &y, middle, STEP_ERROR);
                if leaves(&at) {
                    (high, found) = (middle, at);
                } else {
                    low = middle;
                }
            }
            y = found;
        }
        None
    }
}
