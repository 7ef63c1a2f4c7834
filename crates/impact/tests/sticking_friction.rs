//! Least coefficient of friction of sticking feet against an independent solver: bisection on μ over polyhedral cones.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use percuss_dynamics::{Base, Conditions, Contact, Direction, Frame, Pose, System};
use percuss_impact::{Delassus, ImpactError, JointRates, StickingImpact, sticking_impact};
use percuss_mechanism::{Inertial, LinkDescription, MechanismBuilder};
use percuss_spatial::{Twist, plane_basis};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Number of random sets of feet.
const SETS: u64 = 600;

/// Generators of a polyhedral cone. The cone over the inscribed polygon at μ contains the circular cone at μ cos(π/256), so that the
/// least coefficient of the polygons is too large by at most the factor 1/cos(π/256) = 1.000075.
const FACETS: usize = 256;

/// Distance of the load from the cone, relative to the load, below which the load is in the cone: rounding of the active-set solver.
const IN_CONE: f64 = 1e-9;

/// Bisections on μ, from 1e-6 to 1e4 to a few parts in 1e9.
const BISECTIONS: usize = 40;

/// Relative difference of the coefficients: the facets, 7.5e-5, and the limits [`IN_CONE`] of the bisection.
const AGREEMENT: f64 = 1e-4;

/// Sum of the impulses of a solution, relative to the load, up to which the search of the library contains this solution too: a tenth of
/// its limit of the open impulses.
const SMALL_IMPULSES: f64 = 100.0;

/// Foot of the body: lever from the centre of mass and normal n̂, world axes.
struct Foot {
    at: Vector3<f64>,
    normal: Vector3<f64>,
}

/// Free rigid body with feet and its velocity (angular, linear at the centre of mass).
struct Fall {
    mass: f64,
    inertia: Matrix3<f64>,
    feet: Vec<Foot>,
    before: [Vector3<f64>; 2],
}

impl Fall {
    fn random(rng: &mut StdRng, feet: usize) -> Self {
        fn vector(rng: &mut StdRng) -> Vector3<f64> {
            Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0))
        }
        let factor = Matrix3::from_fn(|_, _| rng.random_range(-0.3..0.3));
        let tilt = rng.random_range(0.0..1.5);
        let foot = |rng: &mut StdRng| {
            let normal = (-Vector3::z() + vector(rng) * tilt).normalize();
            Foot { at: vector(rng).component_mul(&Vector3::new(1.0, 1.0, 0.3)) - Vector3::z() * 0.5, normal }
        };
        let feet = (0..feet).map(|_| foot(rng)).collect();
        let inertia = factor * factor.transpose();
        let inertia = inertia + Matrix3::from_diagonal_element(inertia.trace());
        let before = [vector(rng), vector(rng) * 0.5 - Vector3::z()];
        Self { mass: rng.random_range(0.5..5.0), inertia, feet, before }
    }

    /// Result of the library.
    fn impact(&self) -> Result<StickingImpact, ImpactError> {
        let inertial = Inertial { mass: self.mass, com: Vector3::zeros(), about_com: self.inertia };
        let builder = MechanismBuilder::new("body").link(LinkDescription::new("body", inertial));
        let mechanism = Arc::new(builder.build().expect("a mechanism").mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new().base(Base::Floating));
        let system = system.expect("a system");
        let pose: Pose = system.pose(&system.configuration()).expect("a pose");
        let link = mechanism.find_link("body").expect("a link");
        let located = self.feet.iter().map(|foot| {
            let normal = Direction::Along(foot.normal, Frame::World);
            pose.locate(&Contact { link, against: None, point: foot.at, normal }).expect("a contact")
        });
        let located: Vec<_> = located.collect();
        let delassus = Delassus::new(&pose, &located).expect("a mobility");
        let base = Twist::new(self.before[0], self.before[1]);
        let before = JointRates { joints: Vec::new(), base };
        sticking_impact(&delassus, &delassus.velocities(&pose, &before))
    }

    /// Momentum that the feet `sticking` transmit: that of the motion of least kinetic energy relative to the motion before at which they
    /// rest. Angular part about the centre of mass.
    fn load(&self, sticking: &[usize]) -> DVector<f64> {
        let mut mass = DMatrix::identity(6, 6) * self.mass;
        mass.view_mut((0, 0), (3, 3)).copy_from(&self.inertia);
        let mut rows = DMatrix::zeros(3 * sticking.len(), 6);
        for (k, &i) in sticking.iter().enumerate() {
            rows.view_mut((3 * k, 0), (3, 3)).copy_from(&-self.feet[i].at.cross_matrix());
            rows.view_mut((3 * k, 3), (3, 3)).fill_with_identity();
        }
        let before = DVector::from_iterator(6, self.before.iter().flat_map(|v| v.iter().copied()));
        // Admissible motions: the kernel of the rows, from the right singular vectors.
        let svd = (rows.transpose() * &rows).symmetric_eigen();
        let largest = svd.eigenvalues.amax();
        let free: Vec<usize> = (0..6).filter(|&k| svd.eigenvalues[k] < 1e-10 * largest).collect();
        let after = if free.is_empty() {
            DVector::zeros(6)
        } else {
            let basis = svd.eigenvectors.select_columns(&free);
            let reduced = basis.transpose() * &mass * &basis;
            &basis * reduced.lu().solve(&(basis.transpose() * &mass * &before)).expect("a regular matrix")
        };
        mass * (after - before)
    }

    /// Generators of the polyhedral cones of all feet at μ, as loads: columns 6×(feet · [`FACETS`]).
    fn generators(&self, sticking: &[usize], friction: f64) -> DMatrix<f64> {
        let mut columns = DMatrix::zeros(6, sticking.len() * FACETS);
        for (k, &i) in sticking.iter().enumerate() {
            let Foot { at, normal } = &self.feet[i];
            let (t1, t2) = plane_basis(normal);
            for f in 0..FACETS {
                let (s, c) = (TAU * f as f64 / FACETS as f64).sin_cos();
                let impulse = (-normal + (t1 * c + t2 * s) * friction).normalize();
                columns.view_mut((0, k * FACETS + f), (3, 1)).copy_from(&at.cross(&impulse));
                columns.view_mut((3, k * FACETS + f), (3, 1)).copy_from(&impulse);
            }
        }
        columns
    }

    /// Least coefficient of friction over the polyhedral cones with the sum of its impulses relative to the load; `None` above 1e4.
    fn least_friction(&self, sticking: &[usize]) -> Option<(f64, f64)> {
        let load = self.load(sticking);
        let size = load.norm();
        let feasible = |friction: f64| {
            let (weights, rest) = nonnegative_least_squares(&self.generators(sticking, friction), &load);
            (rest <= IN_CONE * size).then(|| weights.sum() / size)
        };
        // The cones of a large μ have nearly opposite generators: the solver can miss a solution there, but not at a smaller μ.
        let start = [1e4, 1e3, 1e2, 1e1, 1.0];
        let (mut low, (mut high, mut sum)) =
            (1e-6_f64, start.iter().find_map(|&mu| Some((mu, feasible(mu)?)))?);
        for _ in 0..BISECTIONS {
            let middle = (low * high).sqrt();
            match feasible(middle) {
                Some(found) => (high, sum) = (middle, found),
                None => low = middle,
            }
        }
        Some((high, sum))
    }
}

/// Weights w ≥ 0 with the least |G w − load|, and this distance: the active-set method of Lawson and Hanson 1974, ch. 23.
fn nonnegative_least_squares(g: &DMatrix<f64>, load: &DVector<f64>) -> (DVector<f64>, f64) {
    let n = g.ncols();
    let mut weights = DVector::zeros(n);
    let mut passive: Vec<usize> = Vec::new();
    for _ in 0..60 * g.nrows() {
        let rest = load - g * &weights;
        let gains = g.tr_mul(&rest);
        let best = (0..n).filter(|k| !passive.contains(k)).max_by(|a, b| gains[*a].total_cmp(&gains[*b]));
        let Some(best) = best.filter(|&k| gains[k] > f64::EPSILON * load.norm()) else { break };
        passive.push(best);
        loop {
            let qr = g.select_columns(&passive).qr();
            let reduced = qr.q().tr_mul(load);
            let dependent = passive.len() > g.nrows();
            let solution = qr.r().solve_upper_triangular(&reduced).filter(|_| !dependent);
            // A column that depends on the others has no gain beyond rounding.
            let Some(solution) = solution else {
                passive.retain(|k| *k != best);
                break;
            };
            if solution.iter().all(|x| *x > 0.0) {
                weights.fill(0.0);
                passive.iter().zip(solution.iter()).for_each(|(&k, x)| weights[k] = *x);
                break;
            }
            let mut step = 1.0_f64;
            for (&k, x) in passive.iter().zip(solution.iter()).filter(|(_, x)| **x <= 0.0) {
                step = step.min(weights[k] / (weights[k] - x));
            }
            for (&k, x) in passive.iter().zip(solution.iter()) {
                weights[k] += step * (x - weights[k]);
            }
            passive.retain(|&k| weights[k] > 1e-14 * load.norm());
            (0..n).filter(|k| !passive.contains(k)).for_each(|k| weights[k] = 0.0);
        }
        // A gain that is rounding: the new column is removed again.
        if weights[best] == 0.0 {
            break;
        }
    }
    let rest = (load - g * &weights).norm();
    (weights, rest)
}

#[test]
fn the_least_friction_equals_that_of_polyhedral_cones() {
    let (mut agreed, mut impossible, mut squeezed, mut refused) = (0, 0, 0, 0);
    let mut worst = 0.0_f64;
    for seed in 0..SETS {
        let mut rng = StdRng::seed_from_u64(4100 + seed);
        let fall = Fall::random(&mut rng, 2 + seed as usize % 4);
        let Ok(impact) = fall.impact() else {
            refused += 1;
            continue;
        };
        let sticking: Vec<usize> = (0..fall.feet.len()).filter(|&i| impact.contacts[i].sticks).collect();
        let expected = fall.least_friction(&sticking);
        match (impact.least_friction, expected) {
            (None, None) => impossible += 1,
            (Some(found), Some((expected, sum))) => {
                // Each found coefficient is attained by impulses, so that it is at least the infimum.
                assert!(found > expected * (1.0 - AGREEMENT), "{seed}: {found} {expected}");
                if sum > SMALL_IMPULSES {
                    squeezed += 1;
                    continue;
                }
                let error = found / expected - 1.0;
                worst = worst.max(error.abs());
                assert!(error.abs() < AGREEMENT, "{seed}: {found} {expected}, sum {sum}");
                agreed += 1;
            }
            (found, expected) => panic!("{seed}, {} feet: {found:?} {expected:?}", sticking.len()),
        }
    }
    println!(
        "{agreed} agreed (worst {worst:.1e}), {impossible} impossible, {squeezed} squeezed, {refused} refused"
    );
    assert!(
        agreed >= 400,
        "{agreed} agreed, {impossible} impossible, {squeezed} squeezed, {refused} refused"
    );
}
