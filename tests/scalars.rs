//! The recursions hold over any scalar: dual numbers give ∂M, and lanes give each its own answer to the last bit.

use nalgebra::DMatrix;
use num_traits::{One, Zero};
use percuss_mechanism::JointKind;
use percuss_spatial::{Scalar, dual::Dual64};
use percuss_tests::cases::{self, Case};
use percuss_tests::differences::{DIFFERENCE, derivative};
use percuss_tests::gauge::Gauge;
use percuss_tests::motion::Motion;
use rand::{SeedableRng, rngs::StdRng};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Four numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lanes([f64; 4]);

macro_rules! lane_by_lane {
    ($($op:ident $method:ident $assign:ident $assign_method:ident),*) => {$(
        impl $op for Lanes {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Lanes(std::array::from_fn(|i| self.0[i].$method(other.0[i])))
            }
        }

        impl $assign for Lanes {
            fn $assign_method(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}

lane_by_lane!(Add add AddAssign add_assign, Sub sub SubAssign sub_assign);
lane_by_lane!(Mul mul MulAssign mul_assign, Div div DivAssign div_assign);

impl Neg for Lanes {
    type Output = Self;
    fn neg(self) -> Self {
        Lanes(self.0.map(Neg::neg))
    }
}

impl Zero for Lanes {
    fn zero() -> Self {
        Lanes([0.0; 4])
    }

    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Lanes {
    fn one() -> Self {
        Lanes([1.0; 4])
    }
}

impl Scalar for Lanes {
    fn from_f64(x: f64) -> Self {
        Lanes([x; 4])
    }

    fn sin_cos(self) -> (Self, Self) {
        let both = self.0.map(f64::sin_cos);
        (Lanes(both.map(|x| x.0)), Lanes(both.map(|x| x.1)))
    }
}

/// Every case: of the zoo and at random.
fn all_cases() -> Vec<Case> {
    [cases::of_the_zoo(3, 2), cases::at_random(3000, 80, 30)].concat()
}

#[test]
fn dual_numbers_differentiate_the_mass_matrix() {
    let mut rng = StdRng::seed_from_u64(31);
    let mut value = Gauge::new("M over dual numbers");
    let mut slope = Gauge::new("∂M");
    let mut moved = Vec::new();
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        // One joint after another would name the culprit; all at once also sees how they mix.
        let motion = Motion::random(&mut rng, &system);
        let rates = system.position_rates(pose.positions(), &motion.joints);
        let seeded: Vec<Dual64> =
            pose.positions().iter().zip(&rates).map(|(&q, &rate)| Dual64::new(q, rate)).collect();
        let dual = system.mass_matrix_over(&seeded);
        let plain = system.mass_matrix(&pose);
        if plain.is_empty() {
            continue;
        }
        let size = plain.amax();
        // The dual product may round otherwise than the plain one: the same sum in another order.
        value.note(&case.name, (dual.map(|x| x.re) - &plain).amax() / size.max(1e-300), 1e-13);
        let expected: DMatrix<f64> = derivative(&motion, |h| {
            system.mass_matrix(&system.advanced(&pose, &motion.joints, &motion.base, h))
        });
        // M is quadratic in positions that the whole chain turns: its derivative is as large as M times the rates.
        let bound = 2.0 * DIFFERENCE * size * motion.size();
        let deviation = (dual.map(|x| x.eps) - expected).amax();
        if bound > 0.0 {
            slope.note(&case.name, deviation / (size * motion.size()), bound / (size * motion.size()));
            let kinds = case.mechanism.joint_ids().filter(|&id| !system.is_locked(id));
            moved.extend(kinds.map(|id| case.mechanism.joint(id).kind()));
        }
    }
    value.report();
    slope.report();
    for kind in JointKind::ALL {
        assert!(moved.contains(&kind), "{kind:?} never moved");
    }
}

#[test]
fn every_lane_is_the_plain_answer_to_the_last_bit() {
    let mut entries = 0;
    for (i, case) in all_cases().into_iter().enumerate() {
        let system = case.system();
        let mut rng = StdRng::seed_from_u64(32 + i as u64);
        let four: [Vec<f64>; 4] = std::array::from_fn(|_| {
            let other = percuss_oracle::random::positions(&mut rng, &case.mechanism);
            other.into_iter().flatten().collect()
        });
        let together: Vec<Lanes> =
            (0..four[0].len()).map(|k| Lanes(std::array::from_fn(|lane| four[lane][k]))).collect();
        let lanes = system.mass_matrix_over(&together);
        for (lane, positions) in four.iter().enumerate() {
            let plain = system.mass_matrix_over(positions.as_slice());
            for (a, b) in lanes.iter().zip(&plain) {
                assert_eq!(a.0[lane].to_bits(), b.to_bits(), "{}, lane {lane}", case.name);
                entries += 1;
            }
        }
    }
    assert!(entries > 0);
}

#[test]
fn positions_one_after_another_are_those_of_the_pose() {
    let mut rng = StdRng::seed_from_u64(33);
    let mut different = 0;
    for case in all_cases() {
        let system = case.system();
        let pose = case.pose(&system);
        assert_eq!(system.mass_matrix_over(pose.positions()), system.mass_matrix(&pose), "{}", case.name);
        // Entries of mimics are not read.
        let mut positions = pose.positions().to_vec();
        let mut first = 0;
        for joint in case.mechanism.joints() {
            if joint.mimic().is_some() {
                positions[first] = rand::Rng::random_range(&mut rng, -9.0..9.0);
                different += 1;
            }
            first += joint.kind().positions();
        }
        assert_eq!(system.mass_matrix_over(&positions), system.mass_matrix(&pose), "{}", case.name);
    }
    assert!(different > 0, "no mimic came");
}
