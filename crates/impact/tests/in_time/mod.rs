//! Impact in time: closed forms, one freedom by its own equation, conserved energy, orders of convergence.

mod bearings;
mod compliant;
mod forces;
mod two_freedoms;

use crate::cases::all;
use nalgebra::{DVector, Matrix3, Vector3};
use percuss_dynamics::{Conditions, Contact, Direction, EffectiveMass, Frame, Pose, Remark, System};
use percuss_formats::load_file;
use percuss_impact::{
    ImpactError, ImpactInTime, JointRates, JointSpring, RigidImpact, TimeConditions, forces_of_motion,
    impact_in_time,
};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::Twist;
use std::sync::Arc;

/// Body on one joint: a uniform rod of length 1 along x (hinge about z) or a block (slide along x).
fn body(kind: JointKind, mass: f64) -> Arc<Mechanism> {
    let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let about_com = Matrix3::from_diagonal(&Vector3::new(0.0, 1.0, 1.0)) * (mass / 12.0);
    let com = Vector3::new(0.5, 0.0, 0.0);
    let mut builder = MechanismBuilder::new("body").link(LinkDescription::new("ground", none));
    builder = builder.link(LinkDescription::new("body", Inertial { mass, com, about_com }));
    let mut joint = JointDescription::new("joint", kind, "ground", "body");
    joint.axis = if kind == JointKind::Prismatic { Vector3::x() } else { Vector3::z() };
    if kind == JointKind::Prismatic {
        joint.limits = Some(percuss_mechanism::Limits { lower: -10.0, upper: 10.0 });
    }
    Arc::new(builder.joint(joint).build().expect("a mechanism").mechanism)
}

/// The body at a position of its joint, with a contact at its end; the normal is `normal` in the world.
fn at(mechanism: &Arc<Mechanism>, position: f64, normal: Vector3<f64>) -> (Pose, Contact) {
    let system = System::new(Arc::clone(mechanism), &Conditions::new()).expect("a system");
    let mut configuration = system.configuration();
    configuration.set("joint", &[position]).expect("a position");
    let pose = system.pose(&configuration).expect("a pose");
    let link = mechanism.find_link("body").expect("a link");
    let point = Vector3::x();
    (pose, Contact { link, against: None, point, normal: Direction::Along(normal, Frame::World) })
}

/// v* c: motion of least energy with the closing speed c.
fn motion(pose: &Pose, contact: &Contact, speed: f64) -> JointRates {
    let response = pose.respond(contact).expect("a contact");
    let star = JointRates { joints: response.joint_velocities.clone(), base: response.base_velocity };
    JointRates::at_rest(pose.mechanism()).plus_scaled(&star, speed)
}

fn run(pose: &Pose, contact: &Contact, speed: f64, force: &dyn Fn(f64, f64) -> f64) -> ImpactInTime {
    let conditions = TimeConditions { ends_without_force: true, ..TimeConditions::default() };
    impact_in_time(pose, contact, speed, &motion(pose, contact, speed), force, &conditions)
        .expect("an impact")
}

/// A block on a slide that hits a force curve with Hunt–Crossley damping: the restitution does not depend on the curve, and the largest
/// penetration follows from the energy integral ∫ F_s dx = m (a − ln(1 + a))/d², a = d v.
#[test]
fn a_block_on_a_force_curve_has_the_closed_form() {
    let (mass, speed, number) = (40.0, 1.2, 3.087_081_981_129_62_f64);
    let points = [(0.0, 0.0), (0.004, 250.0), (0.008, 700.0), (0.012, 1700.0), (0.016, 4200.0), (0.03, 2e4)];
    let spring = |x: f64| {
        let (a, b) =
            points.windows(2).map(|p| (p[0], p[1])).find(|(_, b)| x < b.0).unwrap_or((points[4], points[5]));
        a.1 + (x - a.0) * (b.1 - a.1) / (b.0 - a.0)
    };
    let force = |x: f64, v: f64| spring(x) * (1.0 + number / speed * v).max(0.0);
    let (pose, contact) = at(&body(JointKind::Prismatic, mass), 0.2, Vector3::x());
    let corners = points[1..].iter().map(|(x, _)| *x).collect();
    let conditions = TimeConditions { corners, ..TimeConditions::default() };
    let found = impact_in_time(&pose, &contact, speed, &motion(&pose, &contact, speed), &force, &conditions);
    let found = found.expect("an impact");
    assert!((found.restitution - 0.3).abs() < 1e-10, "{}", found.restitution);
    let work = mass * (number - number.ln_1p()) * (speed / number).powi(2);
    let done = |depth: f64| {
        let inner = points.iter().filter(|(x, _)| *x < depth).copied().chain([(depth, spring(depth))]);
        let inner: Vec<(f64, f64)> = inner.collect();
        inner.windows(2).map(|p| 0.5 * (p[1].0 - p[0].0) * (p[0].1 + p[1].1)).sum::<f64>()
    };
    assert!((done(found.max_penetration) / work - 1.0).abs() < 1e-10, "{}", found.max_penetration);
}

/// A block on a slide is the damped oscillator: δ = c/ω_d e^{−ζωt} sin ω_d t, until the force k δ + d δ̇ vanishes.
#[test]
fn a_block_is_the_damped_oscillator() {
    let (mass, stiffness, speed) = (2.5, 4e5, 1.3);
    let (pose, contact) = at(&body(JointKind::Prismatic, mass), 0.2, Vector3::x());
    for ratio in [0.05, 0.3, 0.7] {
        let natural: f64 = (stiffness / mass).sqrt();
        let damped = natural * (1.0_f64 - ratio * ratio).sqrt();
        let damping = 2.0 * ratio * natural * mass;
        let found = run(&pose, &contact, speed, &|x, v| stiffness * x + damping * v);
        // k δ + d δ̇ is proportional to e^{−ζωt} sin(ω_d t + φ) with tan φ = 2ζ√(1−ζ²)/(1−2ζ²).
        let phase = (2.0 * ratio * (1.0 - ratio * ratio).sqrt()).atan2(1.0 - 2.0 * ratio * ratio);
        let end = (std::f64::consts::PI - phase) / damped;
        let turn = (1.0 - ratio * ratio).sqrt().atan2(ratio) / damped;
        let depth = speed / damped * (-ratio * natural * turn).exp() * (damped * turn).sin();
        let decay = (-ratio * natural * end).exp();
        let rebound = -decay * ((damped * end).cos() - ratio * natural / damped * (damped * end).sin());
        // Twelve digits a step, over a hundred steps.
        assert!((found.duration / end - 1.0).abs() < 1e-10, "{ratio}: {} {end}", found.duration);
        assert!((found.restitution - rebound).abs() < 1e-10, "{ratio}: {} {rebound}", found.restitution);
        assert!((found.max_penetration / depth - 1.0).abs() < 1e-10, "{ratio}: {}", found.max_penetration);
        for sample in &found.samples {
            let t = sample.time;
            let x = speed / damped * (-ratio * natural * t).exp() * (damped * t).sin();
            assert!((sample.penetration - x).abs() < 1e-10 * depth, "{ratio}: {t}");
        }
    }
}

/// Rod on a hinge: I q̈ = −F L cos q, hinge force m a − F(contact), in the axes of the world.
#[test]
fn a_rod_loads_its_hinge_as_newton_says() {
    let mass = 3.0;
    let (pose, contact) = at(&body(JointKind::Continuous, mass), 0.4, Vector3::y());
    let gravity = Vector3::new(0.0, -9.81, 0.0);
    // The samples within the steps obey the same equations.
    let conditions = TimeConditions {
        gravity,
        ends_without_force: true,
        samples_within_steps: 2,
        ..TimeConditions::default()
    };
    let force = |x: f64, v: f64| 2e4 * x + 30.0 * v;
    let before = motion(&pose, &contact, 1.0);
    let found = impact_in_time(&pose, &contact, 1.0, &before, &force, &conditions).expect("an impact");
    let mut angle = 0.4;
    let inertia = mass / 3.0;
    for (k, sample) in found.samples.iter().enumerate() {
        // Without dissipation of position: δ = sin q − sin q₀.
        angle = if k == 0 { angle } else { (0.4_f64.sin() + sample.penetration).asin() };
        let (sine, cosine) = f64::sin_cos(angle);
        let rate = sample.rates.joints[0][0];
        assert!((rate * cosine - sample.rate).abs() < 1e-11, "{}", sample.time);
        let acceleration = (-sample.force * cosine - mass * 9.81 * 0.5 * cosine) / inertia;
        let of_com = Vector3::new(-sine, cosine, 0.0) * (0.5 * acceleration)
            - Vector3::new(cosine, sine, 0.0) * (0.5 * rate * rate);
        let expected = of_com * mass - gravity * mass + Vector3::y() * sample.force;
        let hinge = &sample.reactions.joints[0].reaction;
        let values = hinge.force.map(|c| c.value().expect("determinate"));
        let reaction = hinge.frame.rotation * Vector3::from(values);
        assert!((reaction - expected).norm() < 1e-9 * sample.force.max(1.0), "{reaction} {expected}");
    }
    assert!(found.samples.len() > 120);
}

/// A rod of length 1 m that rotates about its hinge pulls the hinge with m ω²/2 along the rod; twice the rates give four times the forces.
#[test]
fn a_motion_loads_bearings_quadratically() {
    let (pose, contact) = at(&body(JointKind::Continuous, 3.0), 0.4, Vector3::y());
    let located = pose.locate(&contact).expect("a contact");
    let rates = JointRates { joints: vec![vec![5.0]], base: Twist::zero() };
    let hinge = forces_of_motion(&pose, &located, &rates).expect("forces").joints.remove(0).reaction;
    let force = hinge.frame.rotation * Vector3::from(hinge.force.map(|c| c.value().expect("determinate")));
    let expected = Vector3::new(0.4_f64.cos(), 0.4_f64.sin(), 0.0) * (-3.0 * 0.5 * 25.0);
    assert!((force - expected).norm() < 1e-12, "{force}");
    let mut count = 0;
    for case in all(24) {
        let Ok(located) = case.pose.locate(&case.contact) else { continue };
        let once = motion(&case.pose, &case.contact, 0.5);
        let twice = once.plus_scaled(&once, 1.0);
        let [once, twice] =
            [once, twice].map(|rates| forces_of_motion(&case.pose, &located, &rates).expect("fits"));
        let largest = |r: &percuss_impact::Reactions| {
            let all = r.joints.iter().flat_map(|joint| joint.reaction.force);
            all.filter_map(|c| c.value()).fold(0.0, |most: f64, f| most.max(f.abs()))
        };
        let (a, b) = (4.0 * largest(&once), largest(&twice));
        // Tolerance for the accelerations of a linkage without change point.
        assert!((a - b).abs() < 1e-6 * a.max(1e-6), "{}: {a} {b}", case.name);
        count += 1;
    }
    assert!(count > 100, "{count}");
}

/// Steps of the classical Runge–Kutta method for one freedom of the four-bar linkage.
const FREEDOM_STEPS: usize = 3000;

/// m̄ δ̈ + ½ m̄′ δ̇² = −F over the crank angle of the four-bar linkage, by fixed steps, from the touch until the force vanishes.
fn one_freedom(
    system: &System,
    contact: &Contact,
    crank: f64,
    speed: f64,
    force: &dyn Fn(f64, f64) -> f64,
    duration: f64,
) -> (f64, f64) {
    let joint = system.mechanism().find_joint("crank_hinge").expect("a joint");
    let rates = |[angle, x, v]: [f64; 3]| {
        let mut configuration = system.configuration();
        configuration.set("crank_hinge", &[angle]).expect("a position");
        let pose = system.pose(&configuration).expect("a pose");
        let response = pose.respond(contact).expect("a contact");
        let gradient = pose.effective_mass_gradient(contact).expect("a contact").expect("a mass");
        let slope = gradient.rate(&response.joint_velocities);
        let acceleration = -(force(x, v) + 0.5 * slope * v * v) / gradient.effective_mass;
        [response.joint_velocities[joint.index()][0] * v, v, acceleration]
    };
    let along = |y: [f64; 3], r: [f64; 3], h: f64| [0, 1, 2].map(|k| y[k] + h * r[k]);
    let h = duration / FREEDOM_STEPS as f64;
    let mut y = [crank, 0.0, speed];
    for _ in 0..FREEDOM_STEPS {
        let a = rates(y);
        let b = rates(along(y, a, 0.5 * h));
        let c = rates(along(y, b, 0.5 * h));
        let d = rates(along(y, c, h));
        y = [0, 1, 2].map(|k| y[k] + h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
    }
    (y[1], y[2])
}

/// The general equations of motion agree with the equation of one freedom, for a linkage whose m̄ changes strongly.
#[test]
fn a_four_bar_moves_as_its_one_freedom() {
    let path = format!("{}/../../models/four_bar.urdf", env!("CARGO_MANIFEST_DIR"));
    let mechanism = Arc::new(load_file(&path).expect("a model").mechanism);
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let link = mechanism.find_link("coupler").expect("a link");
    let point = Vector3::new(0.35, 0.1, 0.0);
    let contact =
        Contact { link, against: None, point, normal: Direction::Along(Vector3::y(), Frame::World) };
    // The first impact passes a dead centre, at which m̄ is infinite: it has no equation over δ.
    for (crank, stiffness, speed, damping) in
        [(0.0, 2e4, 2.0, 0.0), (0.0, 2e5, 0.5, 0.0), (0.0, 2e5, 0.5, 900.0), (0.3, 1e5, 0.2, 400.0)]
    {
        let mut configuration = system.configuration();
        configuration.set("crank_hinge", &[crank]).expect("a position");
        let pose = system.pose(&configuration).expect("a pose");
        let force = |x: f64, v: f64| stiffness * x + damping * v;
        let found = run(&pose, &contact, speed, &force);
        for sample in found.samples.iter().filter(|_| damping == 0.0) {
            let mass = sample.effective_mass.expect("a mass");
            let energy = 0.5 * (mass * sample.rate.powi(2) + stiffness * sample.penetration.powi(2));
            let initial = 0.5 * found.samples[0].effective_mass.expect("a mass") * speed * speed;
            assert!((energy / initial - 1.0).abs() < 1e-10, "{} {energy} {initial}", sample.time);
        }
        if stiffness < 1e5 {
            assert!(found.samples.iter().filter_map(|s| s.effective_mass).fold(0.0, f64::max) > 150.0);
            continue;
        }
        let (depth, rate) = one_freedom(&system, &contact, crank, speed, &force, found.duration);
        let last = found.samples.last().expect("samples");
        assert!(
            (last.penetration - depth).abs() < 1e-10 * found.max_penetration,
            "{stiffness}: {depth} {}",
            last.penetration
        );
        assert!((last.rate - rate).abs() < 1e-10 * speed, "{} {rate}", last.rate);
        let masses = found.samples.iter().filter_map(|s| s.effective_mass);
        let (least, most) = masses.fold((f64::MAX, 0.0_f64), |(a, b), m| (a.min(m), b.max(m)));
        assert!(most / least > 1.05, "{least} {most}");
        let gap = found.samples.iter().map(|s| s.loop_gap).fold(0.0, f64::max);
        assert!(gap < 1e-10, "{gap:e}");
    }
}

/// Ȧ u is the difference quotient of the rows, for every kind of closure, held points and floating bases.
#[test]
fn the_bias_of_the_constraints_is_the_rate_of_their_rows() {
    let mut compared = 0;
    for case in all(24) {
        let pose = &case.pose;
        let n = pose.coordinate_joints().len();
        let u: Vec<f64> = (0..n).map(|k| (1.0 + k as f64).sin()).collect();
        let (joints, base) = pose.joint_velocities(&u);
        // Poses keep the ground at the root link: rows between both are not those of a base that moves.
        let is_floating = pose.coordinate_joints().first().is_some_and(|(joint, _)| joint.is_none());
        let mut constraints = pose.constraint_groups().into_iter().flat_map(|group| group.constraints);
        if is_floating
            && constraints.any(|c| c.count > 0 && (c.successor.is_none() || c.predecessor.is_none()))
        {
            continue;
        }
        let bias = pose.constraint_bias(&joints, &base).expect("velocities that fit");
        let h = 1e-5;
        let rows = |sign: f64| -> Vec<DVector<f64>> {
            let moved = pose.advanced(&joints, &base, sign * h).expect("a step");
            let of_group = |group: percuss_dynamics::ConstraintGroup| {
                let own = group.coordinates.iter().map(|&c| u[c]);
                group.rows * DVector::from_iterator(group.coordinates.len(), own)
            };
            moved.constraint_groups().into_iter().map(of_group).collect()
        };
        for ((plus, minus), bias) in rows(1.0).into_iter().zip(rows(-1.0)).zip(&bias) {
            let quotient = (plus - minus) / (2.0 * h);
            let size = quotient.amax().max(1.0);
            for (a, b) in quotient.iter().zip(bias) {
                // The error of central differences: h² and ε/h.
                assert!((a - b).abs() < 1e-7 * size * size, "{}: {a} {b}", case.name);
                compared += 1;
            }
        }
    }
    assert!(compared > 500, "{compared}");
}

/// An elastic contact returns the energy: the motion of random linkages, redundant, massless and floating.
#[test]
fn elastic_contacts_keep_the_energy() {
    let (mut kept, mut left) = (0, 0);
    for case in all(24) {
        let pose = &case.pose;
        let response = pose.respond(&case.contact).expect("a contact");
        let EffectiveMass::Finite(mass) = response.effective_mass else { continue };
        let is_regular = pose.rank().clear
            && !pose.rank().singular
            && pose.constraint_groups().iter().all(|g| g.least_singular_value > 1e-3)
            && !response.remarks.contains(&Remark::UndeterminedMotion);
        if !is_regular {
            continue;
        }
        // The contact compresses by about 2 mm.
        let (speed, stiffness) = (0.5, mass * (0.5_f64 / 0.002).powi(2));
        let before = motion(pose, &case.contact, speed);
        let fast = before.joints.iter().flatten().fold(0.0, |most: f64, v| most.max(v.abs()));
        if fast > 20.0 {
            continue;
        }
        let conditions =
            TimeConditions { ends_without_force: true, samples_within_steps: 3, ..TimeConditions::default() };
        let force = |x: f64, _: f64| stiffness * x;
        let found = match impact_in_time(pose, &case.contact, speed, &before, &force, &conditions) {
            Ok(found) => found,
            Err(ImpactError::GroundedBase) => continue,
            Err(ImpactError::EndlessContact { .. } | ImpactError::LostContact) => {
                left += 1;
                continue;
            }
            Err(error) => panic!("{}: {error}", case.name),
        };
        let last = found.samples.last().expect("samples");
        let deepest = found.samples.iter().fold(0.0, |most: f64, sample| most.max(sample.penetration));
        assert!(deepest <= found.max_penetration * (1.0 + 1e-9), "{}: {deepest} {found:?}", case.name);
        // The energy at the end by the mass matrix at the end, from the positions over time.
        let energy = kinetic_energy(pose, &found);
        let error = (energy / (0.5 * mass * speed * speed) - 1.0).abs();
        assert!(error < 1e-8, "{}: {error:e}, gap {:e}", case.name, last.loop_gap);
        kept += 1;
    }
    println!("{kept} kept the energy, {left} did not end");
    assert!(kept > 60 && left * 20 <= kept, "{kept}, {left}");
}

/// Kinetic energy at the last sample, by the twists of all links.
fn kinetic_energy(start: &Pose, found: &ImpactInTime) -> f64 {
    let last = found.samples.last().expect("samples");
    let pose = start.at_positions(&last.positions, last.base).expect("positions");
    let mechanism = pose.mechanism();
    let mut twists = vec![Twist::zero(); mechanism.links().len()];
    let mut energy = 0.0;
    for &link in mechanism.order() {
        twists[link.index()] = match mechanism.parent_joint(link) {
            None => last.rates.base,
            Some(joint) => {
                let parent = twists[mechanism.joint(joint).parent().index()];
                let columns = pose.motion_subspace(joint);
                let rates = &last.rates.joints[joint.index()];
                energy += pose.armature(joint).iter().zip(rates).map(|(a, v)| 0.5 * a * v * v).sum::<f64>();
                let own = columns.iter().zip(rates).fold(Twist::zero(), |sum, (s, v)| sum + *s * *v);
                pose.joint_transform(joint).inverse_twist(&parent) + own
            }
        };
        energy += 0.5 * mechanism.link(link).inertia().twice_energy(&twists[link.index()]);
    }
    energy
}

/// In the stiff limit the restitution approaches that of a constant mass with 1/k at a symmetric pose and 1/√k otherwise,
/// and all rates approach those of the rigid impact.
#[test]
fn the_stiff_limit_has_its_order() {
    let mechanism = body(JointKind::Continuous, 3.0);
    for (angle, order) in [(0.0, 1.0), (0.5, 0.5)] {
        let (pose, contact) = at(&mechanism, angle, Vector3::y());
        let response = pose.respond(&contact).expect("a contact");
        let mass = response.effective_mass.kilograms().expect("a mass");
        let (speed, ratio) = (1.0, 0.2_f64);
        let phase = (2.0 * ratio * (1.0 - ratio * ratio).sqrt()).atan2(1.0 - 2.0 * ratio * ratio);
        let e = (-ratio / (1.0 - ratio * ratio).sqrt() * (std::f64::consts::PI - phase)).exp();
        let error = |stiffness: f64| {
            let damping = 2.0 * ratio * (stiffness * mass).sqrt();
            let found = run(&pose, &contact, speed, &|x, v| stiffness * x + damping * v);
            let rigid = RigidImpact::new(&pose, &response, speed, e, None).expect("an impact");
            let last = found.samples.last().expect("samples");
            let apart = (last.rates.joints[0][0] - rigid.after.joints[0][0]).abs();
            assert!(apart < 20.0 * speed * (mass / stiffness).sqrt(), "{apart}");
            (found.restitution - e).abs()
        };
        let (soft, hard) = (1e8, 1.6e9);
        let found = (error(soft) / error(hard)).ln() / (hard / soft).ln();
        assert!((found - order).abs() < 0.02, "{angle}: {found}");
    }
}

/// A free body on the other side: two masses with the reduced mass.
#[test]
fn a_free_body_on_the_other_side_takes_its_part() {
    let (mass, other, stiffness, speed) = (2.0, 3.0, 1e5, 1.0);
    let (pose, contact) = at(&body(JointKind::Prismatic, mass), 0.0, Vector3::x());
    let conditions =
        TimeConditions { other_mass: Some(other), ends_without_force: true, ..TimeConditions::default() };
    let before = motion(&pose, &contact, 0.25);
    let force = |x: f64, _: f64| stiffness * x;
    let found = impact_in_time(&pose, &contact, speed, &before, &force, &conditions).expect("an impact");
    let reduced: f64 = mass * other / (mass + other);
    let half_period = std::f64::consts::PI * (reduced / stiffness).sqrt();
    assert!((found.duration / half_period - 1.0).abs() < 1e-10);
    assert!((found.restitution - 1.0).abs() < 1e-10);
    let after = found.samples.last().expect("samples").rates.joints[0][0];
    assert!((after - (0.25 - 2.0 * reduced * speed / mass)).abs() < 1e-10, "{after}");
}

/// A block on a slide with a joint spring k₂ and a damper d against a contact of stiffness k is an oscillator of stiffness k + k₂ and
/// damping d: the contact ends after half a period with the restitution e^{−ζωπ/ω_d}. The reaction of the slide along its axis is the
/// force of spring and damper; the impulse of a lock is zero.
#[test]
fn springs_and_dampers_of_joints_act() {
    let (mass, stiffness, own, damping, speed) = (2.5, 3e5, 1e5, 150.0, 1.3);
    let (pose, contact) = at(&body(JointKind::Prismatic, mass), 0.2, Vector3::x());
    let joint =
        pose.mechanism().joint_ids().find(|id| pose.motion_subspace(*id).len() == 1).expect("a joint");
    let spring = JointSpring { joint, other: None, stiffness: own, damping, free_position: None, drive: 0.0 };
    let conditions = |spring| TimeConditions {
        ends_without_force: true,
        springs: vec![spring],
        ..TimeConditions::default()
    };
    let before = motion(&pose, &contact, speed);
    let run =
        |spring| impact_in_time(&pose, &contact, speed, &before, &|x, _| stiffness * x, &conditions(spring));
    let found = run(spring).expect("an impact");
    let natural: f64 = ((stiffness + own) / mass).sqrt();
    let ratio = 0.5 * damping / (natural * mass);
    let damped = natural * (1.0 - ratio * ratio).sqrt();
    let end = std::f64::consts::PI / damped;
    assert!((found.duration / end - 1.0).abs() < 1e-10, "{} {end}", found.duration);
    assert!((found.restitution - (-ratio * natural * end).exp()).abs() < 1e-10, "{}", found.restitution);
    for sample in &found.samples {
        let force = own * sample.penetration + damping * sample.rate;
        let reaction = &sample.reactions.joints[joint.index()];
        let size = (stiffness + own) * found.max_penetration;
        let transmitted = reaction.reaction.force_magnitude().expect("a magnitude");
        assert!((transmitted - force.abs()).abs() < 1e-9 * size, "{transmitted} {force}");
        let lock = reaction.drives[0].constraint.value().expect("a value");
        assert!(lock.abs() < 1e-9 * size, "{lock}");
    }
    // A preload of the spring in the direction of the impact makes the contact longer.
    let preloaded = JointSpring { free_position: Some(0.2 + 1e-3), ..spring };
    assert!(run(preloaded).expect("an impact").duration > found.duration);
    let refused = run(JointSpring { stiffness: -1.0, ..spring });
    assert!(matches!(refused, Err(ImpactError::Spring { .. })), "{refused:?}");
}

/// End of m x″ = −k xᵖ − d x′ from x = 0 with the speed `speed`: duration and speed ratio, by the Runge-Kutta method of order 4 and the time at
/// which x returns to 0.
fn damped_block(mass: f64, stiffness: f64, exponent: f64, damping: f64, speed: f64) -> (f64, f64) {
    let rates = |(x, v): (f64, f64)| (v, -(stiffness * x.max(0.0).powf(exponent) + damping * v) / mass);
    let along = |(x, v): (f64, f64), (dx, dv): (f64, f64), h: f64| (x + h * dx, v + h * dv);
    let step = |y: (f64, f64), h: f64| {
        let a = rates(y);
        let b = rates(along(y, a, 0.5 * h));
        let c = rates(along(y, b, 0.5 * h));
        let d = rates(along(y, c, h));
        (y.0 + h / 6.0 * (a.0 + 2.0 * (b.0 + c.0) + d.0), y.1 + h / 6.0 * (a.1 + 2.0 * (b.1 + c.1) + d.1))
    };
    let depth = (0.5 * (exponent + 1.0) * mass * speed * speed / stiffness).powf(1.0 / (exponent + 1.0));
    let (h, mut t, mut y) = (1e-4 * depth / speed, 0.0, (0.0, speed));
    loop {
        let next = step(y, h);
        if next.0 <= 0.0 && next.1 < 0.0 {
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if step(y, middle).0 > 0.0 { low = middle } else { high = middle }
            }
            return (t + low, -step(y, low).1 / speed);
        }
        (t, y) = (t + h, next);
    }
}

/// A contact without damping, and a contact force that cannot pull, end where the penetration returns to zero, and not at the end of a step
/// of the integration. Linear contacts: half a period of the damped oscillator.
#[test]
fn contacts_without_pull_end_at_zero_penetration() {
    let (mass, stiffness, speed) = (2.5, 3e5, 1.3);
    let (pose, contact) = at(&body(JointKind::Prismatic, mass), 0.2, Vector3::x());
    let joint =
        pose.mechanism().joint_ids().find(|id| pose.motion_subspace(*id).len() == 1).expect("a joint");
    let before = motion(&pose, &contact, speed);
    for (exponent, largest) in [(1.0, 411.0), (1.5, 150.0), (3.0, 15.0)] {
        for damping in [0.0, 0.3 * largest, largest] {
            let spring =
                JointSpring { joint, other: None, stiffness: 0.0, damping, free_position: None, drive: 0.0 };
            let (duration, ratio) = damped_block(mass, stiffness, exponent, damping, speed);
            for ends_without_force in [true, false].into_iter().take(if damping > 0.0 { 1 } else { 2 }) {
                let conditions =
                    TimeConditions { ends_without_force, springs: vec![spring], ..TimeConditions::default() };
                let force = |x: f64, _: f64| stiffness * x.max(0.0).powf(exponent);
                let found =
                    impact_in_time(&pose, &contact, speed, &before, &force, &conditions).expect("an impact");
                let context = format!("{exponent} {damping} {ends_without_force}");
                assert!(
                    (found.duration / duration - 1.0).abs() < 1e-8,
                    "{context}: {} {duration}",
                    found.duration
                );
                assert!((found.restitution - ratio).abs() < 1e-8, "{context}: {} {ratio}", found.restitution);
            }
            if exponent == 1.0 {
                let (natural, decay) = ((stiffness / mass).sqrt(), 0.5 * damping / mass);
                let half = std::f64::consts::PI / (natural * natural - decay * decay).sqrt();
                assert!((duration / half - 1.0).abs() < 1e-8 && (ratio - (-decay * half).exp()).abs() < 1e-8);
            }
        }
    }
}

/// Forces that never stop the motion are refused. Without a rebound, because a weight keeps the contact closed or the return is overdamped, the
/// compression is that of the motion: for a critically damped oscillator x = v t e^(−ωt), with the maximum v/(ω e).
#[test]
fn contacts_without_an_end_are_refused() {
    let (pose, contact) = at(&body(JointKind::Prismatic, 1.0), 0.0, Vector3::x());
    let before = motion(&pose, &contact, 1.0);
    let conditions = TimeConditions::default();
    let nothing = impact_in_time(&pose, &contact, 1.0, &before, &|_, _| 0.0, &conditions);
    assert!(matches!(nothing, Err(ImpactError::EndlessContact { .. })), "{nothing:?}");
    let pressed = TimeConditions { gravity: Vector3::x() * 9.81, ..conditions };
    let damped = impact_in_time(&pose, &contact, 1.0, &before, &|x, v| 1e4 * x + 2e2 * v, &pressed);
    let damped = damped.expect("a contact without rebound");
    assert!(!damped.separates && damped.restitution == 0.0, "{damped:?}");
    let rest = damped.samples.last().expect("samples").penetration;
    assert!((rest / 9.81e-4 - 1.0).abs() < 0.1, "at rest under the weight: {rest}");
    for ratio in [1.0, 3.0, 40.0] {
        let force = |x: f64, v: f64| 1e4 * x + 2e2 * ratio * v;
        let found = impact_in_time(&pose, &contact, 1.0, &before, &force, &TimeConditions::default());
        let found = found.expect("a contact without rebound");
        assert!(!found.separates && found.restitution == 0.0, "{}", found.restitution);
        // x = v (e^(−at) − e^(−bt))/(b − a), with the roots of s² + 2ζω s + ω².
        let root = (ratio * ratio - 1.0f64).sqrt() * 100.0;
        let (a, b) = (1e4 / (100.0 * ratio + root), 100.0 * ratio + root);
        let expected = if root == 0.0 {
            (-1.0f64).exp() / 100.0
        } else {
            let t = (b / a).ln() / (b - a);
            ((-a * t).exp() - (-b * t).exp()) / (b - a)
        };
        assert!(
            (found.max_penetration / expected - 1.0).abs() < 1e-9,
            "{ratio}: {} {expected}",
            found.max_penetration
        );
    }
}
