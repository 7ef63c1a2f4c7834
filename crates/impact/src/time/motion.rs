//! Motion of a mechanism during an impact: its state, the rates of the state, and the contact.

use crate::motion::driver_rates::lengths;
use crate::motion::joint_rates::JointRates;
use crate::numerics::multistep::MultistepIntegrator;
use crate::reactions::force_elements::SpringForces;
use crate::time::conditions::TimeConditions;
use crate::time::equations::{MotionEquations, base_motion};
use crate::tolerances::{LARGEST_TIME_STEP, TIME_STEP_ERROR};
use nalgebra::{DVector, Vector3};
use percuss_dynamics::{Contact, LocatedContact, Pose, interruption};
use percuss_spatial::quaternion_product;
use std::cell::{Cell, RefCell};

/// Unit of the works, over the kinetic energy ½ m̄ c²: so large that their errors do not shorten the steps.
const WORK_UNIT: f64 = 1e3;
/// Numbers that describe the motion of a base: position and quaternion w, x, y, z.
pub(super) const BASE: usize = 7;

/// Motion in scaled variables, each of order one: displacements of the joints and of the base over `depth`, rates over the largest
/// rate, penetration over `depth`, speed of the other body over the closing speed, work taken by the contact and work of the other forces over
/// `work`; time over `depth`/closing speed.
pub(super) struct Motion<'a> {
    pub(super) start: &'a Pose,
    pub(super) contact: &'a Contact,
    pub(super) force: &'a dyn Fn(f64, f64) -> f64,
    pub(super) conditions: &'a TimeConditions,
    pub(super) speed: f64,
    pub(super) depth: f64,
    /// Largest rate before the impact, m/s over scaled coordinates.
    pub(super) rate: f64,
    /// Factor from a coordinate's rate to the rate of a displacement in metres.
    pub(super) lengths: Vec<f64>,
    /// State at the touch.
    pub(super) initial: Vec<f64>,
    evaluation: RefCell<Evaluation>,
    /// True if the last evaluation is beyond the end of the contact.
    pub(super) is_over: Cell<bool>,
    /// Direction of the motion, for a force that jumps at the reversal.
    pub(super) is_closing: Cell<bool>,
    /// True after the contact: its force is 0.
    pub(super) is_free: Cell<bool>,
    pub(super) springs: SpringForces,
    /// Unit of the works, J.
    pub(super) work: f64,
}

/// Last evaluation of the derivative.
struct Evaluation {
    pose: Pose,
    equations: MotionEquations,
    /// `None` if the contact did not exist.
    instant: Option<Instant>,
}

/// Contact, rates and contact force at one state (SI units).
pub(super) struct Instant {
    pub(super) contact: LocatedContact,
    pub(super) rates: Vec<f64>,
    pub(super) penetration: f64,
    pub(super) closing: f64,
    pub(super) force: f64,
}

impl<'a> Motion<'a> {
    #[allow(clippy::too_many_arguments, reason = "parts of one question")]
    pub(super) fn new(
        start: &'a Pose,
        contact: &'a Contact,
        speed: f64,
        before: &JointRates,
        force: &'a dyn Fn(f64, f64) -> f64,
        conditions: &'a TimeConditions,
        (depth, energy): (f64, f64),
        springs: SpringForces,
    ) -> Self {
        let lengths = lengths(start, &start.coordinate_joints());
        let u = before.coordinates(start);
        let scaled = |(u, length): (&f64, &f64)| (u * length).abs();
        let rate = u.iter().zip(&lengths).map(scaled).fold(speed, f64::max);
        let row = start.locate(contact).map(|located| start.contact_row(&located)).unwrap_or_default();
        let own: f64 = row.iter().zip(&u).map(|(j, u)| j * u).sum();
        let mut initial = vec![0.0; start.positions().len() + BASE];
        initial.extend(u.iter().zip(&lengths).map(|(u, length)| u * length / rate));
        initial.extend([
            0.0,
            if conditions.other_mass.is_some() { (speed - own) / speed } else { 0.0 },
            0.0,
            0.0,
        ]);
        let equations = MotionEquations::new(start, springs.clone());
        let evaluation = RefCell::new(Evaluation { pose: start.clone(), equations, instant: None });
        Self {
            start,
            contact,
            force,
            conditions,
            speed,
            depth,
            rate,
            lengths,
            initial,
            evaluation,
            is_over: Cell::new(false),
            is_closing: Cell::new(true),
            is_free: Cell::new(false),
            springs,
            work: WORK_UNIT * energy,
        }
    }

    /// Integrator from a state with the scaled rates `rate`.
    pub(super) fn integrator(&self, rate: Vec<f64>) -> MultistepIntegrator {
        let integrator = MultistepIntegrator::new(rate, LARGEST_TIME_STEP, TIME_STEP_ERROR);
        integrator.with_kinks(self.springs.has_kinks())
    }

    /// Displacement of positions, rad or m, per unit of a scaled position.
    fn displacement(&self) -> f64 {
        self.depth * self.rate / self.speed
    }

    /// Contact, rates and force at a scaled state. Moves `pose` to the state; `None` if the contact does not exist there.
    pub(super) fn instant(&self, y: &[f64], pose: &mut Pose) -> Option<Instant> {
        interruption::check();
        let (positions, rest) = y.split_at(self.start.positions().len());
        let (base, rest) = rest.split_at(BASE);
        let (rates, rest) = rest.split_at(self.lengths.len());
        let size = self.displacement();
        let q: Vec<f64> = self.start.positions().iter().zip(positions).map(|(q, x)| q + size * x).collect();
        pose.move_to(&q, *self.start.base() * base_motion(base, size)).ok()?;
        let contact = pose.locate(self.contact).ok()?;
        let rates: Vec<f64> = rates.iter().zip(&self.lengths).map(|(x, l)| x * self.rate / l).collect();
        let own: f64 = pose.contact_row(&contact).iter().zip(&rates).map(|(j, u)| j * u).sum();
        let (penetration, closing) = (self.depth * rest[0], own + self.speed * rest[1]);
        let rate = match (self.conditions.jumps_at_reversal, self.is_closing.get()) {
            (false, _) => closing,
            (true, true) => closing.max(f64::MIN_POSITIVE),
            (true, false) => closing.min(-f64::MIN_POSITIVE),
        };
        let force = if self.is_free.get() { 0.0 } else { (self.force)(penetration, rate) };
        Some(Instant { contact, rates, penetration, closing, force })
    }

    /// True if springs, dampers, drives, supports or gravity act.
    pub(super) fn has_other_forces(&self) -> bool {
        !self.springs.is_empty() || self.conditions.gravity != Vector3::zeros()
    }

    /// Gravity in root axes.
    pub(super) fn gravity(&self, pose: &Pose) -> Vector3<f64> {
        pose.base().inverse_vector(&self.conditions.gravity)
    }

    /// Rates of the scaled state over scaled time; NaN if the contact does not exist.
    pub(super) fn derivative(&self, y: &[f64], out: &mut [f64]) {
        if self.try_derivative(y, out).is_none() {
            out.fill(f64::NAN);
        }
    }

    fn try_derivative(&self, y: &[f64], out: &mut [f64]) -> Option<()> {
        let mut evaluation = self.evaluation.borrow_mut();
        evaluation.instant = None;
        let Evaluation { pose, equations, instant } = &mut *evaluation;
        let at = self.instant(y, pose)?;
        self.is_over.set(self.is_end(&at));
        let time = self.depth / self.speed;
        let change = equations.accelerations(pose, &at.contact, &at.rates, at.force, &self.gravity(pose))?;
        let (n, m) = (self.start.positions().len(), self.lengths.len());
        let size = self.displacement();
        let (of_positions, twist) = equations.position_rates(pose, &at.rates)?;
        out[..n].iter_mut().zip(&of_positions).for_each(|(out, rate)| *out = rate * time / size);
        let base = &y[n..n + BASE];
        let spin = twist.angular * 0.5;
        let slide = base_motion(base, size).vector(&twist.linear);
        let quaternion = [1.0 + size * base[3], size * base[4], size * base[5], size * base[6]];
        let turn = quaternion_product(quaternion, [0.0, spin.x, spin.y, spin.z]);
        for (out, rate) in out[n..n + BASE].iter_mut().zip(slide.iter().chain(&turn)) {
            *out = rate * time / size;
        }
        let scaled = change.iter().zip(&self.lengths).map(|(a, length)| a * length * time / self.rate);
        out[n + BASE..n + BASE + m].iter_mut().zip(scaled).for_each(|(out, rate)| *out = rate);
        out[n + BASE + m] = at.closing * time / self.depth;
        out[n + BASE + m + 1] =
            self.conditions.other_mass.map_or(0.0, |mass| -at.force / mass * time / self.speed);
        let gravity = self.gravity(pose);
        let others = match self.springs.is_empty() && gravity == Vector3::zeros() {
            true => 0.0,
            false => equations.applied_power(pose, &at.contact, &at.rates, &gravity),
        };
        out[n + BASE + m + 2] = at.force * at.closing * time / self.work;
        out[n + BASE + m + 3] = others * time / self.work;
        *instant = Some(at);
        Some(())
    }

    /// Values at the state of the last derivative. Exchanges `pose` for the pose there.
    pub(super) fn take_instant(&self, pose: &mut Pose) -> Option<Instant> {
        let mut evaluation = self.evaluation.borrow_mut();
        std::mem::swap(&mut evaluation.pose, pose);
        evaluation.instant.take()
    }

    /// Quantity that falls through zero at the end of the contact, of order one.
    pub(super) fn remaining(&self, at: &Instant) -> f64 {
        // A force curve can have a force at the touch: the gap closes before the force vanishes.
        if self.conditions.ends_without_force && (self.force)(0.0, at.closing) <= 0.0 {
            at.force / (self.force)(self.depth, 0.0)
        } else {
            at.penetration / self.depth
        }
    }

    /// True if a state is at or beyond the end of the contact: the sides separate, and the force or the penetration is not positive.
    pub(super) fn is_end(&self, at: &Instant) -> bool {
        at.closing < 0.0 && self.remaining(at) <= 0.0
    }

    /// Kinetic energy at a scaled state, with a free body on the other side, J; 0 if the contact does not exist there.
    pub(super) fn kinetic_energy(&self, y: &[f64]) -> f64 {
        let mut pose = self.start.clone();
        let Some(at) = self.instant(y, &mut pose) else { return 0.0 };
        let rates = DVector::from_vec(at.rates);
        let own = 0.5 * rates.dot(&(pose.mass_matrix() * &rates));
        let other = self.speed * y[y.len() - 3];
        own + self.conditions.other_mass.map_or(0.0, |mass| 0.5 * mass * other * other)
    }
}

/// m̄ at a pose; `None` if it is not finite.
pub(super) fn finite_mass(pose: &Pose, contact: &Contact) -> Option<f64> {
    pose.respond(contact).ok()?.effective_mass.kilograms()
}
