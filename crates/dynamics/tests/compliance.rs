//! Bushes: free mass, residual compliance, receptance and modes.

use nalgebra::{Complex, DMatrix, DVector, Matrix3, Rotation3, Vector3};
use percuss_dynamics::{
    Base, ComplianceError, Conditions, Configuration, Contact, Direction, EffectiveMass, ElasticSystem,
    ElementMotion, Frame, LinearElement, Load, Pose, ResidualCompliance, System,
};
use percuss_mechanism::{
    BushDescription, Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::Transform;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::sync::Arc;

/// Pose of a mechanism with its joints at the given positions.
fn posed(mechanism: Mechanism, positions: &[f64], conditions: &Conditions) -> Pose {
    let mechanism = Arc::new(mechanism);
    let system = System::new(Arc::clone(&mechanism), conditions).expect("valid conditions");
    let mut configuration = Configuration::zero(&mechanism);
    let movable = mechanism.joints().iter().filter(|joint| joint.kind().positions() == 1);
    for (joint, q) in movable.zip(positions) {
        configuration.set(joint.name(), &[*q]).expect("a position");
    }
    system.pose(&configuration).expect("a tree has a pose")
}

/// Rigid mass in kilograms.
fn kilograms(mass: EffectiveMass) -> f64 {
    mass.kilograms().unwrap_or_else(|| panic!("{mass:?} is not finite"))
}

/// Two carts on a line, joined by a bush; the contact is on the second.
fn carts(masses: [f64; 2], bush: BushDescription) -> MechanismBuilder {
    let cart = |i: usize| LinkDescription::new(format!("cart_{i}"), Inertial::point(masses[i], [0.0; 3]));
    MechanismBuilder::new("carts")
        .link(LinkDescription::massless("ground"))
        .link(cart(0))
        .link(cart(1))
        .joint(JointDescription::new("slide", JointKind::Prismatic, "ground", "cart_0"))
        .joint(JointDescription::new("coupling", JointKind::Fixed, "cart_0", "cart_1"))
        .bush(bush)
}

/// Bush along x with ideal rows across.
fn coupling(stiffness: f64) -> BushDescription {
    let mut bush = BushDescription::new("rubber", "cart_1", "cart_0").replacing("coupling");
    bush.stiffness = [f64::INFINITY, f64::INFINITY, f64::INFINITY, stiffness, f64::INFINITY, f64::INFINITY];
    bush.rigid = [true; 6];
    bush
}

#[test]
fn two_carts_have_the_closed_form() {
    let [m1, m2, k, c] = [3.0, 2.0, 8e4, 60.0];
    let mut bush = coupling(k);
    bush.damping[3] = c;
    let pose = posed(carts([m1, m2], bush).build().unwrap().mechanism, &[0.3], &Conditions::new());
    let link = pose.mechanism().find_link("cart_1").unwrap();
    let contact = pose.locate(&Contact::new(link, [0.0; 3], [1.0, 0.0, 0.0])).unwrap();
    let system = ElasticSystem::new(&pose, &contact, &[], None).unwrap();
    let found = system.residual().unwrap();
    assert!((kilograms(found.free) - m2).abs() < 1e-14 * m2);
    assert!((kilograms(found.rigid) - (m1 + m2)).abs() < 1e-14 * m2);
    let exact = m1 * m1 / (k * (m1 + m2).powi(2));
    assert!((found.compliance.unwrap() / exact - 1.0).abs() < 1e-13);
    assert!(found.is_free_along_motion && found.shares[0].share > 1.0 - 1e-12);
    let modes = system.modes().unwrap();
    let omega = (k * (m1 + m2) / (m1 * m2)).sqrt();
    assert_eq!(modes.len(), 2);
    assert!(modes[0].angular_frequency == 0.0 && (modes[1].angular_frequency / omega - 1.0).abs() < 1e-13);
    // ζ = c/(2 ω m) with the reduced mass.
    assert!((modes[1].damping_ratio / (c / (2.0 * omega) * (m1 + m2) / (m1 * m2)) - 1.0).abs() < 1e-12);
    // A free body on the other side adds in series; the bush is then between three bodies.
    let against = ElasticSystem::new(&pose, &contact, &[], Some(5.0)).unwrap().residual().unwrap();
    assert!(
        (kilograms(against.rigid) - 2.5).abs() < 1e-13
            && (kilograms(against.free) - 10.0 / 7.0).abs() < 1e-13
    );
    // A spring to the ground acts along the rigid motion.
    let ground = pose.mechanism().root();
    let along = ElementMotion::Length([(link, Vector3::zeros()), (ground, Vector3::new(9.0, 0.0, 0.0))]);
    let spring = LinearElement::spring("spring", along, 10.0);
    let with_spring = ElasticSystem::new(&pose, &contact, &[spring], None).unwrap();
    assert!(!with_spring.residual().unwrap().is_free_along_motion);
    let static_compliance = with_spring.receptance(&[1e-6]).unwrap()[0].unwrap().receptance.re;
    assert!((static_compliance * 10.0 - 1.0).abs() < 1e-9, "{static_compliance}");
}

#[test]
fn bad_bushes_are_refused() {
    let refused = |change: &dyn Fn(&mut BushDescription)| {
        let mut bush = coupling(1e5);
        change(&mut bush);
        carts([1.0, 1.0], bush).build().expect_err("a bad bush").to_string()
    };
    type Change = (&'static str, &'static dyn Fn(&mut BushDescription));
    let changes: [Change; 6] = [
        ("does not exist", &|b| b.link = "cart_9".into()),
        ("does not exist", &|b| b.replaces = vec!["couplin".into()]),
        ("itself", &|b| b.against = "cart_1".into()),
        ("0 or more", &|b| b.stiffness[3] = -1.0),
        ("finite", &|b| b.damping[3] = f64::NAN),
        ("all joints between its two links", &|b| b.against = "ground".into()),
    ];
    for (message, change) in changes {
        let text = refused(change);
        assert!(text.contains(message) && text.contains("rubber"), "{text}");
    }
    let plain = carts([1.0, 1.0], coupling(1.0)).build().unwrap().mechanism;
    let locked = posed(plain, &[], &Conditions::new().lock("coupling"));
    let link = locked.mechanism().find_link("cart_1").unwrap();
    let contact = locked.locate(&Contact::new(link, [0.0; 3], [1.0, 0.0, 0.0])).unwrap();
    let refused = ElasticSystem::new(&locked, &contact, &[], None).expect_err("a locked bush");
    assert!(matches!(refused, ComplianceError::LockedBush { .. }));
}

/// Random tree with bushes in place of some joints, and its description.
struct Sample {
    mechanism: Mechanism,
    positions: Vec<f64>,
    link: String,
    point: Vector3<f64>,
    normal: Vector3<f64>,
    floating: bool,
}

fn direction(rng: &mut StdRng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0)) + Vector3::new(1e-3, 0.0, 0.0)
}

/// `factor`: multiplies all stiffness. `only_rigid`: no stiffness besides the rigid rows.
fn sample(seed: u64, factor: f64, only_rigid: bool) -> Sample {
    let mut rng = StdRng::seed_from_u64(seed);
    let rng = &mut rng;
    let bodies = rng.random_range(2..6);
    let mut builder = MechanismBuilder::new("sample").link(LinkDescription::new(
        "link_0",
        Inertial { mass: 4.0, com: Vector3::zeros(), about_com: Matrix3::identity() * 0.1 },
    ));
    let mut positions = Vec::new();
    for i in 1..=bodies {
        let spread = Matrix3::from_diagonal(&Vector3::from_fn(|_, _| rng.random_range(0.5..0.9)));
        let turn = Rotation3::new(direction(rng)).into_inner();
        let mass = 10f64.powf(rng.random_range(-1.0..1.5));
        let about_com = turn * spread * turn.transpose() * (mass * 0.02);
        let com = direction(rng) * 0.1;
        builder = builder.link(LinkDescription::new(format!("link_{i}"), Inertial { mass, com, about_com }));
        let kind = [JointKind::Revolute, JointKind::Prismatic, JointKind::Spherical, JointKind::Fixed]
            [rng.random_range(0..4)];
        let parent = rng.random_range(0..i);
        let origin = Transform {
            rotation: Rotation3::new(direction(rng)).into_inner(),
            translation: direction(rng) * 0.4,
        };
        let joint =
            JointDescription::new(format!("joint_{i}"), kind, format!("link_{parent}"), format!("link_{i}"))
                .origin(origin)
                .axis(direction(rng).into());
        if kind.positions() == 1 {
            positions.push(rng.random_range(-0.8..0.8));
        }
        let axis = joint.axis.normalize();
        builder = builder.joint(joint);
        if i == bodies || rng.random_bool(0.5) {
            let mut bush =
                BushDescription::new(format!("bush_{i}"), format!("link_{i}"), format!("link_{parent}"))
                    .replacing(format!("joint_{i}"));
            // The bush frame is at the joint, with its z-axis along the axis of the joint.
            let x = axis.cross(&Vector3::new(0.3, -0.8, 0.5)).normalize();
            bush.frame.rotation = Matrix3::from_columns(&[x, axis.cross(&x), axis]);
            bush.rigid = match kind {
                JointKind::Revolute => [true, true, false, true, true, true],
                JointKind::Prismatic => [true, true, true, true, true, false],
                JointKind::Spherical => [false, false, false, true, true, true],
                _ => [true; 6],
            };
            for row in 0..6 {
                let size = if row < 3 { 2e3 } else { 1e5 };
                if bush.rigid[row] || !only_rigid && rng.random_bool(0.5) {
                    bush.stiffness[row] = factor * size * 10f64.powf(rng.random_range(-1.0..1.0));
                    bush.damping[row] = if only_rigid { 0.0 } else { 1e-3 * bush.stiffness[row] / factor };
                }
            }
            bush.loss_factor = if only_rigid { 0.0 } else { 0.1 };
            bush.dynamic_factor = 1.25;
            builder = builder.bush(bush);
        }
    }
    let link = format!("link_{bodies}");
    Sample {
        mechanism: builder.build().expect("a valid mechanism").mechanism,
        positions,
        link,
        point: direction(rng) * 0.3,
        normal: direction(rng).normalize(),
        floating: rng.random_bool(0.3),
    }
}

/// Pose of a sample, and its matrices.
fn elastic(sample: &Sample, mechanism: Mechanism) -> (Pose, ElasticSystem) {
    let base = if sample.floating { Base::Floating } else { Base::Fixed };
    let pose = posed(mechanism, &sample.positions, &Conditions::new().base(base));
    let contact = located(sample, &pose);
    let system = ElasticSystem::new(&pose, &contact, &[], None).expect("a system");
    (pose, system)
}

fn located(sample: &Sample, pose: &Pose) -> percuss_dynamics::LocatedContact {
    let link = pose.mechanism().find_link(&sample.link).unwrap();
    let contact =
        Contact::new(link, sample.point, sample.normal).normal(Direction::Along(sample.normal, Frame::World));
    pose.locate(&contact).expect("a contact")
}

/// Second algorithm: all links with six velocities (v at the world's origin, ω), the ideal rows with multipliers:
/// [K + iωC − ω²M, Aᵀ; A, 0].
struct Maximal {
    mass: DMatrix<f64>,
    ideal: Vec<DVector<f64>>,
    /// Complex stiffness without damping, damping, row.
    elastic: Vec<(Complex<f64>, f64, DVector<f64>)>,
    contact: DVector<f64>,
}

impl Maximal {
    fn new(sample: &Sample, pose: &Pose) -> Self {
        let mechanism = pose.mechanism();
        let n = 6 * mechanism.links().len();
        let mut mass = DMatrix::zeros(n, n);
        // Row of the component `e` of the relative velocity at `p` (translation) or of the relative rotation.
        let row = |child: usize, parent: Option<usize>, p: Vector3<f64>, e: Vector3<f64>, turns: bool| {
            let mut row = DVector::zeros(n);
            for (link, sign) in [(Some(child), 1.0), (parent, -1.0)] {
                let Some(link) = link else { continue };
                let (linear, angular) = if turns { (Vector3::zeros(), e) } else { (e, p.cross(&e)) };
                row.rows_mut(6 * link, 3).copy_from(&(linear * sign));
                row.rows_mut(6 * link + 3, 3).copy_from(&(angular * sign));
            }
            row
        };
        for id in mechanism.link_ids() {
            let Some(inertial) = mechanism.link(id).inertial() else { continue };
            let frame = pose.link(id);
            let com = frame.point(&inertial.com);
            let about = frame.rotation * inertial.about_com * frame.rotation.transpose();
            let skew = com.cross_matrix();
            let first = 6 * id.index();
            let mut block = mass.view_mut((first, first), (6, 6));
            block.view_mut((0, 0), (3, 3)).copy_from(&(Matrix3::identity() * inertial.mass));
            block.view_mut((0, 3), (3, 3)).copy_from(&(-skew * inertial.mass));
            block.view_mut((3, 0), (3, 3)).copy_from(&(skew * inertial.mass));
            block.view_mut((3, 3), (3, 3)).copy_from(&(about - skew * skew * inertial.mass));
        }
        let mut ideal = Vec::new();
        if !sample.floating {
            for k in 0..6 {
                let mut fixed = DVector::zeros(n);
                fixed[k] = 1.0;
                ideal.push(fixed);
            }
        }
        let replaced = |name: &str| {
            mechanism.bushes().iter().any(|bush| bush.description().replaces.iter().any(|j| j == name))
        };
        for joint in mechanism.joints().iter().filter(|joint| !replaced(joint.name())) {
            let frame = pose.link(joint.child());
            let axis = frame.rotation * joint.axis();
            let x = axis.cross(&Vector3::new(0.2, 0.9, -0.4)).normalize();
            let y = axis.cross(&x);
            let all = [x, y, axis];
            let (turning, moving): (&[_], &[_]) = match joint.kind() {
                JointKind::Revolute => (&all[..2], &all),
                JointKind::Prismatic => (&all, &all[..2]),
                JointKind::Spherical => (&[], &all),
                _ => (&all, &all),
            };
            let (child, parent) = (joint.child().index(), Some(joint.parent().index()));
            ideal.extend(turning.iter().map(|e| row(child, parent, frame.translation, *e, true)));
            ideal.extend(moving.iter().map(|e| row(child, parent, frame.translation, *e, false)));
        }
        let mut elastic = Vec::new();
        for bush in mechanism.bushes() {
            let given = bush.description();
            let frame = pose.link(bush.link()) * given.frame;
            for i in 0..6 {
                let e = frame.rotation.column(i % 3).into_owned();
                let parent = bush.against().map(|link| link.index());
                let k = Complex::new(1.0, given.loss_factor) * (given.stiffness[i] * given.dynamic_factor);
                elastic.push((
                    k,
                    given.damping[i],
                    row(bush.link().index(), parent, frame.translation, e, i < 3),
                ));
            }
        }
        let at = located(sample, pose);
        let contact = row(at.link.index(), None, at.point_world, at.normal_world, false);
        Self { mass, ideal, elastic, contact }
    }

    /// Solves with the dynamic stiffness Σ k bᵀb − ω²M, bordered by `held`; returns jᵀx for the force j.
    fn solve(&self, matrix: DMatrix<Complex<f64>>, held: &[DVector<f64>]) -> Complex<f64> {
        let (n, rows) = (self.contact.len(), held.len());
        let mut bordered = DMatrix::zeros(n + rows, n + rows);
        bordered.view_mut((0, 0), (n, n)).copy_from(&matrix);
        let size = matrix.iter().map(|x| x.norm()).fold(1.0, f64::max);
        for (r, row) in held.iter().enumerate() {
            for c in 0..n {
                bordered[(n + r, c)] = Complex::new(row[c] * size, 0.0);
                bordered[(c, n + r)] = bordered[(n + r, c)];
            }
        }
        let mut force = DVector::zeros(n + rows);
        (0..n).for_each(|c| force[c] = Complex::new(self.contact[c], 0.0));
        let x = bordered.full_piv_lu().solve(&force).expect("a regular system");
        (0..n).map(|c| x[c] * self.contact[c]).sum()
    }

    fn receptance(&self, omega: f64) -> Complex<f64> {
        let mut matrix = self.mass.map(|m| Complex::new(-omega * omega * m, 0.0));
        for (k, c, row) in &self.elastic {
            let factor = k + Complex::new(0.0, omega * c);
            let complex = row.map(|x| Complex::new(x, 0.0));
            matrix.ger(factor, &complex, &complex, Complex::new(1.0, 0.0));
        }
        self.solve(matrix, &self.ideal)
    }

    /// m̄ with the ideal rows alone.
    fn free_mass(&self) -> f64 {
        1.0 / self.solve(self.mass.map(|m| Complex::new(m, 0.0)), &self.ideal).re
    }
}

/// Number of random mechanisms.
const SAMPLES: u64 = 60;

#[test]
fn receptance_and_free_mass_are_those_of_maximal_coordinates() {
    for seed in 0..SAMPLES {
        let sample = sample(seed, 1.0, false);
        let (pose, system) = elastic(&sample, super_of(seed, 1.0, false));
        let maximal = Maximal::new(&sample, &pose);
        let found = system.residual().unwrap();
        let free = maximal.free_mass();
        assert!((kilograms(found.free) / free - 1.0).abs() < 1e-10, "{seed}: {found:?} {free}");
        let frequencies = [3.0, 40.0, 170.0, 900.0];
        let receptances = system.receptance(&frequencies).unwrap();
        for (omega, h) in frequencies.iter().zip(receptances) {
            let (h, exact) = (h.expect("a solution").receptance, maximal.receptance(*omega));
            // The saddle point in doubles keeps about seven digits near resonances.
            assert!((h - exact).norm() < 1e-7 * exact.norm(), "{seed} at {omega}: {h} {exact}");
        }
    }
}

/// The same mechanism once more: a mechanism has no copy.
fn super_of(seed: u64, factor: f64, only_rigid: bool) -> Mechanism {
    sample(seed, factor, only_rigid).mechanism
}

#[test]
fn residual_compliance_is_the_sum_over_the_modes() {
    let mut immovable = 0;
    for seed in 0..SAMPLES {
        let sample = sample(seed, 1.0, true);
        let (pose, system) = elastic(&sample, super_of(seed, 1.0, true));
        let ResidualCompliance { free, rigid, compliance, shares, .. } = system.residual().unwrap();
        let modes = system.modes().unwrap();
        let elastic = || modes.iter().filter(|mode| mode.angular_frequency > 0.0);
        let sum: f64 = elastic().map(|mode| (mode.participation / mode.angular_frequency).powi(2)).sum();
        let compliance = compliance.expect("a compliance");
        assert!((compliance / sum - 1.0).abs() < 1e-9, "{seed}: {compliance} {sum}");
        assert!((shares.iter().map(|row| row.share).sum::<f64>() - 1.0).abs() < 1e-12, "{seed}");
        let inverse: f64 = modes.iter().map(|mode| mode.participation.powi(2)).sum();
        assert!((inverse * kilograms(free) - 1.0).abs() < 1e-10, "{seed}");
        // h = Σ φ²/(ωᵢ² − ω²).
        let omega = 77.0;
        let modal: f64 = modes
            .iter()
            .map(|m| m.participation.powi(2) / (m.angular_frequency.powi(2) - omega * omega))
            .sum();
        let h = system.receptance(&[omega]).unwrap()[0].expect("a solution");
        assert!((h.receptance.re / modal - 1.0).abs() < 1e-8, "{seed}: {h:?} {modal}");
        // The rigid mass is that of the mechanism without bushes.
        let contact = located(&sample, &pose);
        let own = pose.respond(&Contact {
            link: contact.link,
            against: None,
            point: contact.point_link,
            normal: Direction::Along(contact.normal_link, Frame::Link),
        });
        match (rigid, own.expect("a response").effective_mass) {
            (EffectiveMass::Finite(a), EffectiveMass::Finite(b)) => {
                assert!((a / b - 1.0).abs() < 1e-10, "{seed}: {a} {b}");
                assert!(kilograms(free) <= a * (1.0 + 1e-12), "{seed}");
            }
            (a, b) => {
                assert_eq!(a, b, "{seed}");
                immovable += 1;
            }
        }
    }
    assert!(immovable < SAMPLES / 2, "{immovable} of {SAMPLES} are immovable");
}

#[test]
fn stiff_bushes_give_the_rigid_mass() {
    for seed in 0..SAMPLES {
        let sample = sample(seed, 1e6, true);
        let (_, system) = elastic(&sample, super_of(seed, 1e6, true));
        let EffectiveMass::Finite(rigid) = system.residual().unwrap().rigid else { continue };
        let at = system.receptance(&[1.0]).unwrap()[0].expect("a solution");
        let m = at.apparent_mass().re;
        assert!((m / rigid - 1.0).abs() < 1e-4, "{seed}: {m} {rigid}");
    }
}

/// Number of random impacts.
const IMPACTS: u64 = 10_000;

#[test]
fn impacts_are_within_the_proved_bounds() {
    let mut above_rigid = 0;
    for seed in 0..IMPACTS {
        let mut rng = StdRng::seed_from_u64(seed);
        // Modal coordinates: the first mode is the rigid motion, and all have mass 1.
        let n = rng.random_range(2..7);
        let phi = DVector::from_fn(n, |_, _| 10f64.powf(rng.random_range(-1.0..0.5)));
        let stiffness =
            DVector::from_fn(n, |i, _| if i == 0 { 0.0 } else { 10f64.powf(rng.random_range(0.0..5.0)) });
        let (rigid, free) = (1.0 / phi[0].powi(2), 1.0 / phi.norm_squared());
        let k = rigid * 10f64.powf(rng.random_range(0.0..5.0));
        let c_res: f64 = (1..n).map(|i| phi[i].powi(2) / stiffness[i]).sum();
        let matrix = DMatrix::from_diagonal(&stiffness) + &phi * phi.transpose() * k;
        let eigen = matrix.symmetric_eigen();
        // Unit speed of the contact in the rigid motion: q̇ = (1/φ₀, 0, …).
        let start = eigen.eigenvectors.row(0).transpose() / phi[0];
        let contact = eigen.eigenvectors.tr_mul(&phi);
        let omega = eigen.eigenvalues.map(|x| x.max(0.0).sqrt());
        let at = |t: f64, rate: bool| -> f64 {
            let one = |i: usize| {
                let wave =
                    if rate { (omega[i] * t).cos() } else { (omega[i] * t).sin() / omega[i].max(1e-12) };
                contact[i] * start[i] * wave
            };
            (0..n).map(one).sum()
        };
        let step = 0.1 / omega.max();
        let (mut t, mut peak) = (step, 0.0_f64);
        while at(t, false) > 0.0 {
            peak = peak.max(k * at(t, false));
            t += step;
        }
        let (mut low, mut high) = (t - step, t);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if at(middle, false) > 0.0 { low = middle } else { high = middle }
        }
        // The peak between two samples is at most (0.1)²/8 higher.
        let (least, most) = ((k * free).sqrt(), (k * rigid).sqrt());
        assert!(
            peak * (1.0 + 1.3e-3) >= least && peak <= most * (1.0 + 1e-9),
            "{seed}: {least} {peak} {most}"
        );
        let impulse = rigid * (1.0 - rate_of_rigid(&phi, &eigen.eigenvectors, &start, &omega, low));
        if k * c_res < 0.02 {
            assert!(
                1.0 - peak / most < 1.5 * 1.2 * k * c_res + 1.5e-3,
                "{seed}: {peak} {most} {}",
                k * c_res
            );
        }
        let restitution = -at(low, true);
        let mass = impulse / (1.0 + restitution);
        // The zero is exact to some roundings of the largest frequency.
        let rounding = 1.0 + 1e-8;
        assert!(restitution <= rounding, "{seed}: {restitution}");
        assert!(mass * rounding >= free, "{seed}: {mass} {free}");
        assert!(mass <= 2.0 * rigid / (1.0 + restitution) * rounding, "{seed}: {mass} {rigid} {restitution}");
        assert!(low * rounding >= std::f64::consts::PI * (free / k).sqrt(), "{seed}: {low}");
        above_rigid += u64::from(mass > rigid);
    }
    // The rigid mass is no bound of the impulse.
    assert!(above_rigid > IMPACTS / 10, "{above_rigid}");
}

#[test]
fn gears_are_between_rotor_and_joint() {
    let [m, rotor, k, d] = [3.0, 5.0, 9e4, 19.0];
    for kind in [JointKind::Prismatic, JointKind::Revolute] {
        let inertia = Inertial { mass: m, com: Vector3::zeros(), about_com: Matrix3::identity() * m };
        let build = || {
            let builder = MechanismBuilder::new("drive")
                .link(LinkDescription::massless("ground"))
                .link(LinkDescription::new("arm", inertia))
                .joint(JointDescription::new("joint", kind, "ground", "arm"));
            builder.build().unwrap().mechanism
        };
        let conditions = Conditions::new().armature("joint", [rotor]);
        let pose = posed(build(), &[0.4], &conditions);
        let (link, joint) =
            (pose.mechanism().find_link("arm").unwrap(), pose.mechanism().find_joint("joint").unwrap());
        let contact = match kind {
            JointKind::Prismatic => Contact::new(link, [0.0; 3], [1.0, 0.0, 0.0]),
            _ => Contact::about_axis(link, [1.0, 0.0, 0.0]),
        };
        let contact = pose.locate(&contact).unwrap();
        let gear = |stiffness| LinearElement {
            damping: d,
            ..LinearElement::spring("joint", ElementMotion::Gear(joint), stiffness)
        };
        let system = ElasticSystem::new(&pose, &contact, &[gear(k)], None).unwrap();
        let found = system.residual().unwrap();
        assert!(
            (kilograms(found.free) / m - 1.0).abs() < 1e-13
                && (kilograms(found.rigid) / (m + rotor) - 1.0).abs() < 1e-13
        );
        let omega = (k * (m + rotor) / (m * rotor)).sqrt();
        let modes = system.modes().unwrap();
        assert!((modes[1].angular_frequency / omega - 1.0).abs() < 1e-13 && modes[1].rows[0].0 == "joint");
        for bad in [conditions.lock("joint"), Conditions::new()] {
            let bad = posed(build(), &[0.4], &bad);
            let refused = ElasticSystem::new(&bad, &contact, &[gear(k)], None).expect_err("no gear");
            assert!(matches!(refused, ComplianceError::Gear { .. }), "{refused}");
        }
    }
}

/// A column on a bush at its foot under a weight P at the height h. The axes of the bush turn with the column: with the displacement x of the foot
/// and the rotation θ, V = k x²/2 + κ θ²/2 − P x θ − P h θ²/2.
#[test]
fn column_under_a_weight_has_the_closed_form() {
    let [radial, conical, h] = [4e5, 900.0, 0.4];
    let mut bush = BushDescription::new("foot", "column", "ground").replacing("stand");
    bush.stiffness = [conical, conical, 50.0, radial, radial, 1e6];
    bush.rigid = [true; 6];
    bush.dynamic_factor = 1.4;
    let column = LinkDescription::new("column", Inertial::point(2.0, [0.0, 0.0, 0.2]));
    let mechanism = MechanismBuilder::new("column")
        .link(LinkDescription::massless("ground"))
        .link(column)
        .joint(JointDescription::new("stand", JointKind::Fixed, "ground", "column"))
        .bush(bush)
        .build()
        .unwrap()
        .mechanism;
    let pose = posed(mechanism, &[], &Conditions::new());
    let link = pose.mechanism().find_link("column").unwrap();
    let contact = pose.locate(&Contact::new(link, [0.0; 3], [1.0, 0.0, 0.0])).unwrap();
    let system = ElasticSystem::new(&pose, &contact, &[], None).unwrap();
    let top = Vector3::new(0.0, 0.0, h);
    let load = |force| Load::force(link, top, force);
    for weight in [0.0, 300.0, 1500.0] {
        let statics = system.statics(&[load(Vector3::new(0.0, 0.0, -weight))]).unwrap();
        let stiffness = nalgebra::Matrix2::new(radial, -weight, -weight, conical - weight * h);
        let push = nalgebra::Vector2::new(10.0, 10.0 * h);
        let exact = stiffness.try_inverse().unwrap() * push;
        let found = statics.displacement(&[load(Vector3::new(10.0, 0.0, 0.0))]).unwrap();
        let [turn, at] = found.of(link, &top).unwrap();
        // The differences of the geometric stiffness are exact to 1e-12 of the weight.
        assert!((at.x / (exact[0] + h * exact[1]) - 1.0).abs() < 1e-10, "{weight}: {at} {exact}");
        assert!((turn.y / exact[1] - 1.0).abs() < 1e-10);
    }
    let buckled = system.statics(&[load(Vector3::new(0.0, 0.0, -conical / h))]);
    assert_eq!(buckled.err(), Some(ComplianceError::Unstable));
}

/// Speed of the rigid motion at the contact at the time t.
fn rate_of_rigid(
    phi: &DVector<f64>,
    modes: &DMatrix<f64>,
    start: &DVector<f64>,
    omega: &DVector<f64>,
    t: f64,
) -> f64 {
    let rates = DVector::from_fn(start.len(), |i, _| start[i] * (omega[i] * t).cos());
    phi[0] * (modes * rates)[0]
}
