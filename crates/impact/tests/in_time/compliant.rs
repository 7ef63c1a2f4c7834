//! Impacts of mechanisms with elastic bushes and gears.

use nalgebra::{DMatrix, DVector, Vector3};
use percuss_contact::DamperCurve;
use percuss_dynamics::{Conditions, Configuration, Contact, Load, LocatedContact, Pose, System};
use percuss_impact::{
    CompliantImpact, CompliantLaw, ContactEnd, ForcesAtTouch, JointRates, PointSpring, Support,
    TimeConditions, compliant_impact, compliant_impact_with_forces, impact_in_time,
};
use percuss_mechanism::{
    BushDescription, Inertial, JointDescription, JointKind, LinkDescription, MechanismBuilder,
};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::f64::consts::PI;
use std::sync::Arc;

/// Carts on a line: masses, and stiffness and damping of the bush before each cart after the first. A massless cart has the mass 0.
struct Carts {
    masses: Vec<f64>,
    bushes: Vec<[f64; 2]>,
}

impl Carts {
    fn random(rng: &mut StdRng, is_massless: bool) -> Self {
        let count = rng.random_range(2..6);
        let mut masses: Vec<f64> = (0..count).map(|_| 10f64.powf(rng.random_range(-0.5..1.0))).collect();
        if is_massless && count > 2 {
            masses[1] = 0.0;
        }
        let bush = |_| {
            let k = 10f64.powf(rng.random_range(4.0..6.5));
            [k, if rng.random_bool(0.5) { k * 10f64.powf(rng.random_range(-4.5..-3.0)) } else { 0.0 }]
        };
        Self { bushes: (1..count).map(bush).collect(), masses }
    }

    fn pose(&self) -> (Pose, LocatedContact) {
        let mut builder = MechanismBuilder::new("carts").link(LinkDescription::massless("ground"));
        for (i, mass) in self.masses.iter().enumerate() {
            let name = format!("cart_{i}");
            let link = match mass {
                0.0 => LinkDescription::massless(name),
                _ => LinkDescription::new(name, Inertial::point(*mass, [0.0; 3])),
            };
            builder = builder.link(link);
            builder = match i.checked_sub(1) {
                None => {
                    builder.joint(JointDescription::new("slide", JointKind::Prismatic, "ground", "cart_0"))
                }
                Some(before) => {
                    let (name, child, parent) =
                        (format!("fixed_{i}"), format!("cart_{i}"), format!("cart_{before}"));
                    let mut bush =
                        BushDescription::new(format!("bush_{i}"), &child, &parent).replacing(&name);
                    bush.stiffness = [f64::INFINITY; 6];
                    bush.rigid = [true; 6];
                    [bush.stiffness[3], bush.damping[3]] = self.bushes[before];
                    builder.joint(JointDescription::new(name, JointKind::Fixed, parent, child)).bush(bush)
                }
            };
        }
        let mechanism = Arc::new(builder.build().expect("carts").mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).unwrap();
        let pose = system.pose(&Configuration::zero(&mechanism)).unwrap();
        let link = mechanism.find_link(&format!("cart_{}", self.masses.len() - 1)).unwrap();
        let contact = pose.locate(&Contact::new(link, [0.0; 3], [1.0, 0.0, 0.0])).unwrap();
        (pose, contact)
    }

    /// Mass, stiffness and damping matrices with a contact at the last cart. A massless cart has the mass `tiny`.
    fn matrices(&self, [k, c]: [f64; 2]) -> [DMatrix<f64>; 3] {
        let n = self.masses.len();
        let mut found = [DMatrix::zeros(n, n), DMatrix::zeros(n, n), DMatrix::zeros(n, n)];
        self.masses.iter().enumerate().for_each(|(i, m)| found[0][(i, i)] = *m);
        for (i, factors) in self.bushes.iter().enumerate() {
            for part in 0..2 {
                for (r, column, sign) in
                    [(i, i, 1.0), (i + 1, i + 1, 1.0), (i, i + 1, -1.0), (i + 1, i, -1.0)]
                {
                    found[1 + part][(r, column)] += sign * factors[part];
                }
            }
        }
        found[1][(n - 1, n - 1)] += k;
        found[2][(n - 1, n - 1)] += c;
        found
    }
}

/// Impact of carts at 1 m/s.
fn impact(carts: &Carts, law: CompliantLaw<'_>, conditions: &TimeConditions) -> CompliantImpact {
    let (pose, contact) = carts.pose();
    let mut before = JointRates::at_rest(pose.mechanism());
    before.joints[0] = vec![1.0];
    compliant_impact(&pose, &contact, (1.0, &before), law, &[], conditions).expect("an impact")
}

/// Second algorithm: Taylor series of z over small steps from z̈ = −M⁻¹(Cż + Kz), with a massless cart condensed by hand out of the equations.
struct Taylor {
    stiffness: DMatrix<f64>,
    damping: DMatrix<f64>,
}

impl Taylor {
    /// State (z, ż) after a step `h`.
    fn step(&self, z: &DVector<f64>, v: &DVector<f64>, h: f64) -> (DVector<f64>, DVector<f64>) {
        let (mut a, mut b) = (z.clone(), v.clone());
        let (mut sum_z, mut sum_v) = (z.clone(), v.clone());
        let mut factor = 1.0;
        for order in 1..30 {
            let next = -(&self.stiffness * &a) - &self.damping * &b;
            (a, b) = (b, next);
            factor *= h / f64::from(order);
            sum_z += &a * factor;
            sum_v += &b * factor;
        }
        (sum_z, sum_v)
    }
}

/// Duration, impulse, peak force and largest force of every bush by the Taylor series; `None` for a contact without an end.
fn reference(carts: &Carts, law: [f64; 2], by_force: bool) -> Option<(f64, f64, f64, Vec<f64>)> {
    let [mass, stiffness, damping] = carts.matrices(law);
    let inverse = DMatrix::from_diagonal(&mass.diagonal().map(|m| 1.0 / m));
    let n = mass.nrows();
    let series = Taylor { stiffness: &inverse * stiffness, damping: &inverse * damping };
    let h = 0.004 / series.stiffness.amax().sqrt();
    let (mut z, mut v) = (DVector::zeros(n), DVector::from_element(n, 1.0));
    let force = |z: &DVector<f64>, v: &DVector<f64>| law[0] * z[n - 1] + law[1] * v[n - 1];
    let remaining = |z: &DVector<f64>, v: &DVector<f64>| if by_force { force(z, v) } else { z[n - 1] };
    let bush = |i: usize, z: &DVector<f64>, v: &DVector<f64>| {
        let [k, c] = carts.bushes[i];
        (k * (z[i + 1] - z[i]) + c * (v[i + 1] - v[i])).abs()
    };
    // Vertex of the parabola through three equidistant values.
    let vertex = |[a, b, c]: [f64; 3]| match a - 2.0 * b + c {
        curvature if curvature < 0.0 && b >= a.max(c) => b - (a - c).powi(2) / (8.0 * curvature),
        _ => b,
    };
    let all = |z: &DVector<f64>, v: &DVector<f64>| {
        (0..n - 1).map(|i| bush(i, z, v)).chain([force(z, v)]).collect::<Vec<_>>()
    };
    let (mut before, mut now) = (all(&z, &v), all(&z, &v));
    let mut peaks = now.clone();
    let (mut time, mut steps) = (0.0, 0);
    loop {
        let (nz, nv) = series.step(&z, &v, h);
        steps += 1;
        if steps > 4_000_000 {
            return None;
        }
        if nv[n - 1] < 0.0 && remaining(&nz, &nv) <= 0.0 {
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let (mz, mv) = series.step(&z, &v, middle);
                if mv[n - 1] < 0.0 && remaining(&mz, &mv) <= 0.0 { high = middle } else { low = middle }
            }
            let (ez, ev) = series.step(&z, &v, low);
            let momentum = (0..n).map(|i| carts.masses[i] * (1.0 - ev[i])).sum();
            all(&ez, &ev).iter().zip(&mut peaks).for_each(|(x, most)| *most = most.max(*x));
            let contact = peaks.pop().unwrap();
            return Some((time + low, momentum, contact, peaks));
        }
        let next = all(&nz, &nv);
        for i in 0..n {
            peaks[i] = peaks[i].max(vertex([before[i], now[i], next[i]]));
        }
        (before, now) = (now, next);
        (z, v) = (nz, nv);
        time += h;
    }
}

#[test]
fn impacts_of_carts_are_those_of_a_taylor_series() {
    for seed in 0..40 {
        let mut rng = StdRng::seed_from_u64(seed);
        let carts = Carts::random(&mut rng, false);
        let total: f64 = carts.masses.iter().sum();
        let k = 10f64.powf(rng.random_range(3.5..7.0));
        let c = if seed % 2 == 0 { 0.0 } else { rng.random_range(0.0..0.4) * (k * total).sqrt() };
        let by_force = seed % 3 > 0;
        let conditions = TimeConditions { ends_without_force: by_force, ..TimeConditions::default() };
        let linear = impact(&carts, CompliantLaw { linear: [k, c], force: None }, &conditions);
        let (duration, impulse, peak, bushes) =
            reference(&carts, [k, c], by_force).expect("an end of the contact");
        let close = |a: f64, b: f64, most: f64| (a - b).abs() <= most * b.abs();
        assert!(close(linear.duration, duration, 1e-9), "{seed}: {} {duration}", linear.duration);
        assert!(close(linear.impulse, impulse, 1e-9), "{seed}: {} {impulse}", linear.impulse);
        // Both have the parabola through three samples at the peak.
        assert!(close(linear.peak_force, peak, 1e-8), "{seed}: {} {peak}", linear.peak_force);
        let largest = bushes.iter().fold(0.0_f64, |most, x| most.max(*x));
        for (i, expected) in bushes.iter().enumerate() {
            let name = format!("bush_{}", i + 1);
            let found = linear.elements.iter().find(|e| e.element == name && e.direction.is_some()).unwrap();
            assert!(
                (found.force - expected).abs() <= 1e-6 * largest,
                "{seed}: {name} {} {expected}",
                found.force
            );
        }
        let energy = linear.energy;
        assert!(energy.residual().abs() <= 1e-4 * energy.kinetic_before, "{seed}: {energy:?}");
        // The same law as a force that is not linear has the same impact.
        let force = |x: f64, v: f64| k * x + c * v;
        let near = [0.7 * k, c + 0.1 * (k * total).sqrt()];
        let other = impact(&carts, CompliantLaw { linear: near, force: Some(&force) }, &conditions);
        assert!(
            close(other.duration, linear.duration, 1e-8),
            "{seed}: {} {}",
            other.duration,
            linear.duration
        );
        assert!(
            close(other.impulse, linear.impulse, 1e-8) && close(other.peak_force, linear.peak_force, 1e-8)
        );
    }
}

#[test]
fn massless_pads_are_springs_in_series() {
    let (m, bush, k) = (7.0, 3e5, 2e5);
    let carts = Carts { masses: vec![m, 0.0], bushes: vec![[bush, 0.0]] };
    let conditions = TimeConditions { ends_without_force: true, ..TimeConditions::default() };
    let found = impact(&carts, CompliantLaw { linear: [k, 0.0], force: None }, &conditions);
    let series = bush * k / (bush + k);
    assert!((found.duration / (PI * (m / series).sqrt()) - 1.0).abs() < 1e-9, "{}", found.duration);
    assert!(
        (found.peak_force / (series * m).sqrt() - 1.0).abs() < 1e-10
            && (found.impulse / (2.0 * m) - 1.0).abs() < 1e-9
    );
    assert_eq!(found.end, ContactEnd::Separates);
    // A damper in series, such as behind a mount: force c v at the touch, F = c v exp(−c t/m) without end if the contact never yields.
    let c = 300.0;
    let damped = Carts { masses: vec![m, 0.0], bushes: vec![[0.0, c]] };
    let slow = impact(&damped, CompliantLaw { linear: [k, 0.0], force: None }, &conditions);
    assert_eq!(slow.end, ContactEnd::NoRebound);
    // F = k δ with δ̇ = v − F/c and m v̇ = −F: an oscillator with the damping ratio √(k m)/(2 c), far above 1 here.
    let (sum, product) = (k / c, k / m);
    let root = (0.25 * sum * sum - product).sqrt();
    let (fast, tail) = (0.5 * sum + root, 0.5 * sum - root);
    let at = (fast / tail).ln() / (fast - tail);
    let peak = k * ((-tail * at).exp() - (-fast * at).exp()) / (fast - tail);
    assert!((slow.peak_force / peak - 1.0).abs() < 1e-9, "{} {peak}", slow.peak_force);
}

#[test]
fn other_forces_are_those_of_the_impact_of_the_rigid_mechanism() {
    // A single cart is linear, so both integrations have the same motion.
    let carts = Carts { masses: vec![12.0], bushes: Vec::new() };
    let (pose, contact) = carts.pose();
    let mechanism = pose.mechanism();
    let (cart, ground) = (mechanism.find_link("cart_0").unwrap(), mechanism.root());
    let ends = [(ground, Vector3::new(-2.0, 0.0, 0.0)), (cart, Vector3::zeros())];
    let curve =
        DamperCurve::new(vec![-1.0, -0.2, 0.0, 0.1, 1.0], vec![-900.0, -400.0, 0.0, 150.0, 500.0]).unwrap();
    let line =
        PointSpring { damper: Some(Arc::new(curve)), drive: 40.0, ..PointSpring::new(ends, 9e3, Some(1.98)) };
    let support = Support {
        link: cart,
        point: Vector3::zeros(),
        direction: Vector3::x(),
        rate: 2e4,
        damping: 30.0,
        force: 60.0,
        is_balanced: true,
    };
    let conditions = TimeConditions {
        gravity: Vector3::new(3.0, 0.0, -9.0),
        point_springs: vec![line],
        supports: vec![support],
        ..TimeConditions::default()
    };
    let mut before = JointRates::at_rest(mechanism);
    before.joints[0] = vec![1.0];
    let force = |x: f64, v: f64| 4e6 * x.max(0.0).powf(1.5) * (1.0 + 0.3 * v).max(0.0);
    let law = CompliantLaw { linear: [2e5, 300.0], force: Some(&force) };
    let found = compliant_impact(&pose, &contact, (1.0, &before), law, &[], &conditions).unwrap();
    let declared = Contact::new(cart, [0.0; 3], [1.0, 0.0, 0.0]);
    let other = impact_in_time(&pose, &declared, 1.0, &before, &force, &conditions).unwrap();
    let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-6 * b.abs(), "{a} {b}");
    close(found.duration, other.duration);
    close(found.restitution, other.restitution);
    close(found.max_penetration, other.max_penetration);
    assert!((found.peak_force / other.peak_force - 1.0).abs() < 1e-4);
    close(found.energy.taken_by_contact, other.energy.taken_by_contact);
    assert!(found.energy.residual().abs() < 1e-5, "{:?}", found.energy);
}

/// The largest force at a corner of a force curve, at which the parabola through samples is too large.
#[test]
fn peaks_at_corners_are_those_of_the_rigid_mechanism() {
    let carts = Carts { masses: vec![9.0], bushes: Vec::new() };
    let (pose, contact) = carts.pose();
    let cart = pose.mechanism().find_link("cart_0").unwrap();
    let mut before = JointRates::at_rest(pose.mechanism());
    before.joints[0] = vec![1.0];
    for (corner, damping) in [(0.004, 350.0), (0.0025, 500.0), (0.005, 250.0)] {
        let curve = |x: f64| if x < corner { 2e5 * x } else { 2e5 * corner + 2e3 * (x - corner) };
        let force = |x: f64, v: f64| curve(x) + damping * v;
        let law = CompliantLaw { linear: [1e5, 300.0], force: Some(&force) };
        let conditions = TimeConditions { corners: vec![corner], ..TimeConditions::default() };
        let found = compliant_impact(&pose, &contact, (1.0, &before), law, &[], &conditions).unwrap();
        let declared = Contact::new(cart, [0.0; 3], [1.0, 0.0, 0.0]);
        let other = impact_in_time(&pose, &declared, 1.0, &before, &force, &conditions).unwrap();
        let at = other.samples.iter().find(|s| (s.penetration - corner).abs() < 1e-12).expect("the corner");
        assert!((other.peak_force / at.force - 1.0).abs() < 1e-12, "the peak is at the corner");
        assert!((found.peak_force / at.force - 1.0).abs() < 1e-8, "{} {}", found.peak_force, at.force);
    }
}

/// Rod on a rotational bush with a pull at its end: the geometric stiffness makes the contact of the end an oscillator of stiffness
/// k + (c + P l)/l² and mass m. The whole equation m l² θ″ = −c θ − P l sin θ − k l² sin θ cos θ differs by the square of the angle.
#[test]
fn a_pull_acts_by_its_geometric_stiffness() {
    let (length, mass, rate, k, speed) = (0.8, 3.0, 40.0, 900.0, 1e-4);
    let mut bush = BushDescription::new("foot", "rod", "ground").replacing("mount");
    bush.stiffness = [rate, rate, f64::INFINITY, f64::INFINITY, f64::INFINITY, f64::INFINITY];
    bush.rigid = [true, false, true, true, true, true];
    let built = MechanismBuilder::new("rod")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("rod", Inertial::point(mass, [0.0, 0.0, length])))
        .joint(JointDescription::new("mount", JointKind::Continuous, "ground", "rod").axis([0.0, 1.0, 0.0]))
        .bush(bush);
    let mechanism = Arc::new(built.build().unwrap().mechanism);
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).unwrap();
    let pose = system.pose(&Configuration::zero(&mechanism)).unwrap();
    let rod = mechanism.find_link("rod").unwrap();
    let contact = pose.locate(&Contact::new(rod, [0.0, 0.0, length], [1.0, 0.0, 0.0])).unwrap();
    let mut before = JointRates::at_rest(&mechanism);
    before.joints[0] = vec![speed / length];
    let law = CompliantLaw { linear: [k, 0.0], force: None };
    let conditions = TimeConditions { ends_without_force: true, ..TimeConditions::default() };
    for pull in [0.0, 300.0, -40.0] {
        let load = Load::force(rod, Vector3::new(0.0, 0.0, length), Vector3::new(0.0, 0.0, pull));
        let forces = ForcesAtTouch { loads: vec![load], ..ForcesAtTouch::default() };
        let motion = (speed, &before);
        let found =
            compliant_impact_with_forces(&pose, &contact, motion, law, &[], &conditions, &forces).unwrap();
        let stiffness = k + (rate + pull * length) / (length * length);
        let (depth, duration) = (speed * (mass / stiffness).sqrt(), PI * (mass / stiffness).sqrt());
        assert!((found.max_penetration / depth - 1.0).abs() < 1e-9, "{pull}: {}", found.max_penetration);
        assert!((found.duration / duration - 1.0).abs() < 1e-9, "{pull}: {}", found.duration);
        // The equation itself by the Runge-Kutta method of order 4.
        let change = |q: f64| {
            let (s, c) = q.sin_cos();
            -(rate * q + pull * length * s + k * length * length * s * c) / (mass * length * length)
        };
        let (h, mut q, mut u, mut deepest) = (1e-4 * duration, 0.0, speed / length, 0.0_f64);
        while u > 0.0 {
            let (a, b) = (change(q), change(q + 0.5 * h * u));
            let c = change(q + 0.5 * h * (u + 0.5 * h * a));
            let d = change(q + h * (u + 0.5 * h * b));
            (q, u) = (q + h * (u + h * (a + b + c) / 6.0), u + h * (a + 2.0 * (b + c) + d) / 6.0);
            deepest = deepest.max(length * q.sin());
        }
        assert!((found.max_penetration / deepest - 1.0).abs() < 1e-6, "{pull}: {deepest}");
        let plain = compliant_impact(&pose, &contact, motion, law, &[], &conditions).unwrap();
        let is_same = (plain.peak_force / found.peak_force - 1.0).abs() < 1e-9;
        assert_eq!(is_same, pull == 0.0, "{pull}: {} {}", plain.peak_force, found.peak_force);
    }
}
