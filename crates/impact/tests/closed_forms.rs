//! Closed forms: pendulum and door, a free rod, the four-bar linkage, geared joints.

use nalgebra::{Matrix3, Vector2, Vector3};
use percuss_dynamics::{Base, Conditions, Contact, Direction, EffectiveMass, Frame, Pose, System};
use percuss_formats::load_file;
use percuss_impact::{
    Component, DriverRate, FrictionLaw, JointConstraint, JointRates, PercussionError, RatesError,
    RestitutionLaw, RigidImpact, centre_of_percussion, centre_of_percussion_in_plane, closing_speed,
    greatest_closing_speed, greatest_closing_speed_of_gears, held_point_mass, locked_body_masses,
    rates_from_drivers, reactions_to_unit_impulse, reflected_inertia, worst_reaction_within,
};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::{Transform, Twist};
use std::sync::Arc;

/// Rounding of sums of a few terms of order one.
pub const ROUNDING: f64 = 1e-13;

pub fn model(name: &str) -> Arc<Mechanism> {
    let path = format!("{}/../../models/{name}.urdf", env!("CARGO_MANIFEST_DIR"));
    Arc::new(load_file(&path).expect("a model").mechanism)
}

pub fn pose_of(mechanism: &Arc<Mechanism>, conditions: &Conditions, set: &[(&str, f64)]) -> Pose {
    let system = System::new(Arc::clone(mechanism), conditions).expect("a system");
    let mut configuration = system.configuration();
    for (joint, value) in set {
        configuration.set(joint, &[*value]).expect("a position");
    }
    system.pose(&configuration).expect("a pose")
}

/// Uniform rod of mass `mass` and length `length` along x, hinged at its end about z.
pub fn hinged_rod(mass: f64, length: f64) -> Arc<Mechanism> {
    let about_com = Matrix3::from_diagonal(&Vector3::new(0.0, 1.0, 1.0)) * (mass * length * length / 12.0);
    let mut builder = MechanismBuilder::new("rod");
    let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let com = Vector3::new(length / 2.0, 0.0, 0.0);
    builder = builder.link(LinkDescription::new("ground", none));
    builder = builder.link(LinkDescription::new("rod", Inertial { mass, com, about_com }));
    let mut hinge = JointDescription::new("hinge", JointKind::Continuous, "ground", "rod");
    hinge.axis = Vector3::z();
    builder = builder.joint(hinge);
    Arc::new(builder.build().expect("a mechanism").mechanism)
}

fn finite(mass: EffectiveMass) -> f64 {
    match mass {
        EffectiveMass::Finite(m) => m,
        other => panic!("{other:?}"),
    }
}

pub fn value(component: Component) -> f64 {
    component.value().expect("a determinate component")
}

#[test]
fn a_door_stop_at_two_thirds_leaves_the_hinge_without_impulse() {
    let (mass, length) = (3.0, 0.9);
    let door = hinged_rod(mass, length);
    let pose = pose_of(&door, &Conditions::new(), &[]);
    let link = door.find_link("rod").expect("the rod");
    let hinge = door.find_joint("hinge").expect("the hinge");
    for part in [0.1, 0.5, 2.0 / 3.0, 0.9] {
        let at = Vector3::new(part * length, 0.0, 0.0);
        let contact = Contact::new(link, at, Vector3::y());
        let response = pose.respond(&contact).expect("a response");
        assert!((finite(response.effective_mass) / (mass / (3.0 * part * part)) - 1.0).abs() < ROUNDING);
        let reactions = reactions_to_unit_impulse(&pose, &response).expect("reactions");
        let reaction = &reactions.joints[0].reaction;
        // Along y: m Δv_com = −3/2 part = −1 + R, so R = 1 − 3/2 part; in the axes x, y, z of the hinge.
        let expected = 1.0 - 1.5 * part;
        assert!((value(reaction.force[1]) - expected).abs() < ROUNDING, "{part}: {reaction:?}");
        assert!(value(reaction.force[0]).abs() < ROUNDING && value(reaction.force[2]).abs() < ROUNDING);
        assert!(reaction.moment.iter().all(|m| value(*m).abs() < ROUNDING));
        // The ground carries what the hinge transmits.
        let ground = reactions.ground.expect("a fixed base");
        assert!((value(ground.force[1]) - expected).abs() < ROUNDING);
        // The best point along the door is at 2/3, from every start.
        let best = centre_of_percussion(&pose, &contact, hinge, Vector3::x()).expect("a centre");
        assert!((best.point.x - 2.0 * length / 3.0).abs() < ROUNDING, "{best:?}");
        assert!(
            best.remaining_reaction < ROUNDING && (best.given_reaction - expected.abs()).abs() < ROUNDING
        );
        // In the tangent plane, points displaced along the hinge change the moments only.
        let best = centre_of_percussion_in_plane(&pose, &contact, hinge).expect("a centre");
        assert!((best.point - Vector3::new(2.0 * length / 3.0, 0.0, 0.0)).norm() < ROUNDING, "{best:?}");
    }
}

#[test]
fn a_free_rod_rebounds_as_in_the_textbook() {
    // Nikravesh, Planar Multibody Dynamics, example 11.3: rod of length 2, m = 1 kg, J = 0.01 kg·m², at 315°, falling at
    // 6.5 m/s, e = 0.95. Closed form: 1/m̄ = 1/m + x²/J = 51 with x² = 1/2.
    let mut builder = MechanismBuilder::new("rod");
    let about_com = Matrix3::identity() * 0.01;
    builder =
        builder.link(LinkDescription::new("rod", Inertial { mass: 1.0, com: Vector3::zeros(), about_com }));
    let rod = Arc::new(builder.build().expect("a mechanism").mechanism);
    let pose = pose_of(&rod, &Conditions::new().base(Base::Floating), &[]);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let contact = Contact::new(rod.root(), Vector3::new(half, -half, 0.0), -Vector3::y());
    let response = pose.respond(&contact).expect("a response");
    assert!((finite(response.effective_mass) * 51.0 - 1.0).abs() < ROUNDING);
    let before =
        JointRates { joints: Vec::new(), base: Twist::new(Vector3::zeros(), Vector3::new(0.0, -6.5, 0.0)) };
    let closing = closing_speed(&pose, &response.contact, &before);
    assert!((closing - 6.5).abs() < ROUNDING);
    let impact = RigidImpact::new(&pose, &response, closing, 0.95, Some(before)).expect("an impact");
    let impulse = 1.95 * 6.5 / 51.0;
    assert!((impact.impulse - impulse).abs() < ROUNDING && (impulse - 0.2485294).abs() < 5e-8);
    let omega = half * impulse / 0.01;
    assert!((impact.after.base.angular.z - omega).abs() < 100.0 * ROUNDING);
    assert!((omega - 17.5736832).abs() < 5e-8);
    assert!((impact.after.base.linear.y - (impulse - 6.5)).abs() < ROUNDING);
    assert!(impact.reactions.ground.is_none());
}

/// Crank angle from the drawing, kg·m² at the crank, by the vector loop of `models/four_bar.urdf`.
fn four_bar_inertia(turn: f64) -> f64 {
    let rotate = |v: Vector2<f64>, by: f64| {
        let (s, c) = by.sin_cos();
        Vector2::new(c * v.x - s * v.y, s * v.x + c * v.y)
    };
    let across = |v: Vector2<f64>| Vector2::new(-v.y, v.x);
    let crank = rotate(Vector2::new(0.0, 0.3), turn);
    let d = Vector2::new(0.65, 0.0);
    // B is at 0.5 m from A and 0.65 m from D, on the drawn side.
    let line = d - crank;
    let distance = line.norm();
    let along = (0.25 - 0.4225 + distance * distance) / (2.0 * distance);
    let side = (0.25 - along * along).sqrt();
    let b = crank + line * (along / distance) + across(line) * (side / distance);
    let (coupler, rocker) = (b - crank, b - d);
    // v_A + ω k × coupler = ψ k × rocker, by Cramer's rule.
    let (v_a, p, q) = (across(crank), across(coupler), across(rocker));
    let determinant = -p.x * q.y + p.y * q.x;
    let omega = (v_a.x * q.y - v_a.y * q.x) / determinant;
    let psi = (v_a.x * p.y - v_a.y * p.x) / determinant;
    let centre = v_a + p * (omega / 2.0);
    2.0 * 0.09 / 3.0 + 4.8 * centre.norm_squared() + 0.1 * omega * omega + 3.0 * 0.4225 / 3.0 * psi * psi
}

#[test]
fn reflected_inertia_of_the_four_bar() {
    let mechanism = model("four_bar");
    let crank = mechanism.find_joint("crank_hinge").expect("the crank");
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let mut pose = system.pose(&system.configuration()).expect("a pose");
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for step in 0..=720 {
        let turn = std::f64::consts::TAU * step as f64 / 720.0;
        let mut configuration = system.configuration();
        configuration.set("crank_hinge", &[turn]).expect("a position");
        pose = system.pose_from(&pose, &configuration).expect("a pose");
        let found = reflected_inertia(&pose, crank, 0).expect("an inertia");
        let (free, expected) = (finite(found.free), four_bar_inertia(turn));
        // The conditioning of the loop over the turn is below 100.
        assert!((free / expected - 1.0).abs() < 1e-12, "{turn}: {free} {expected}");
        // The crank is the only driver.
        assert_eq!(found.held, Some(found.free));
        (least, most) = (least.min(free), most.max(free));
    }
    // Extremes over the turn; a grid of half a degree misses them by less than 1e-4 of their value.
    assert!((least / 0.1972447 - 1.0).abs() < 1e-4 && least >= 0.1972446, "{least}");
    assert!((most / 1.1849697 - 1.0).abs() < 1e-4 && most <= 1.1849698, "{most}");
    assert!((four_bar_inertia(0.0) - 52163.0 / 110250.0).abs() < ROUNDING);
}

#[test]
fn rates_of_drivers_move_the_four_bar() {
    let mechanism = model("four_bar");
    let pose = pose_of(&mechanism, &Conditions::new(), &[]);
    let joint = |name: &str| mechanism.find_joint(name).expect("a joint");
    let rate = |name: &str, rate: f64| DriverRate { joint: joint(name), rates: vec![rate] };
    // The fractions of the model: coupler −5/21, rocker 8/21 per unit rate of the crank.
    let rates = rates_from_drivers(&pose, &[rate("crank_hinge", 2.1)], Twist::zero()).expect("rates");
    assert!((rates.joint(joint("rocker_hinge"))[0] - 0.8).abs() < ROUNDING);
    assert!((rates.joint(joint("crank_pin"))[0] - (-0.5 - 2.1)).abs() < ROUNDING);
    // A second rate must agree.
    let both = |rocker: f64| [rate("crank_hinge", 2.1), rate("rocker_hinge", rocker)];
    assert_eq!(rates_from_drivers(&pose, &both(0.8), Twist::zero()).expect("rates").joints.len(), 3);
    match rates_from_drivers(&pose, &both(1.0), Twist::zero()) {
        Err(RatesError::Inadmissible { residual, .. }) => assert!(residual > 0.01 && residual < 0.1),
        other => panic!("{other:?}"),
    }
    match rates_from_drivers(&pose, &[], Twist::zero()) {
        Err(RatesError::Undetermined { open: 1, freedoms: 1, joints }) => assert_eq!(joints.len(), 3),
        other => panic!("{other:?}"),
    }
    let error =
        rates_from_drivers(&pose, &[rate("crank_hinge", 1.0), rate("crank_hinge", 1.0)], Twist::zero());
    assert!(matches!(error, Err(RatesError::Twice { .. })), "{error:?}");
}

#[test]
fn a_redundant_hinge_is_open_out_of_the_plane_only() {
    let mechanism = model("four_bar");
    let pose = pose_of(&mechanism, &Conditions::new(), &[]);
    let link = mechanism.find_link("coupler").expect("the coupler");
    let contact = Contact::new(link, Vector3::new(0.35, 0.1, 0.0), Vector3::y());
    let response = pose.respond(&contact).expect("a response");
    let reactions = reactions_to_unit_impulse(&pose, &response).expect("reactions");
    let all = reactions.joints.iter().map(|joint| &joint.reaction).chain(&reactions.closures);
    for reaction in all {
        let known = |components: &[Component; 3]| components.map(|c| c.value().is_some());
        // The force along the axes z and the moments about x and y are open in a planar loop of parallel hinges.
        assert_eq!(known(&reaction.force), [true, true, false], "{reaction:?}");
        assert_eq!(known(&reaction.moment), [false, false, true], "{reaction:?}");
        assert_eq!(reaction.loops, ["rocker_pin"]);
    }
    assert!(reactions.residual < ROUNDING, "{:e}", reactions.residual);
}

#[test]
fn a_gear_receives_the_armature_times_the_jump() {
    let mechanism = model("planar_2r");
    let pose = pose_of(&mechanism, &Conditions::new(), &[("elbow", 1.1)]);
    let link = mechanism.find_link("outer").expect("the outer link");
    let contact = Contact::new(link, Vector3::new(0.4, 0.0, 0.0), Vector3::new(0.3, 0.8, 0.0));
    let response = pose.respond(&contact).expect("a response");
    let impact = RigidImpact::new(&pose, &response, 1.2, 0.5, None).expect("an impact");
    for (number, armature) in [0.3, 0.1].into_iter().enumerate() {
        let jump = impact.after.joints[number][0] - impact.before.joints[number][0];
        let joint = &impact.reactions.joints[number];
        let scale = impact.impulse;
        assert!((joint.drives[0].gear - armature * jump).abs() < ROUNDING * scale);
        // The joint receives the opposite about its axis, and no other impulse.
        assert!((value(joint.reaction.moment[2]) + armature * jump).abs() < ROUNDING * scale);
        assert!(value(joint.drives[0].constraint).abs() < ROUNDING * scale);
    }
    // The closing speed is reversed and multiplied by e.
    let speed = |rates: &JointRates| closing_speed(&pose, &response.contact, rates);
    assert!((speed(&impact.before) - 1.2).abs() < ROUNDING && (speed(&impact.after) + 0.6).abs() < ROUNDING);
    // Largest speed for a jump of 2 rad/s of the elbow.
    let elbow = mechanism.find_joint("elbow").expect("the elbow");
    let (most, by) = greatest_closing_speed(&response, 0.5, &[(elbow, 0, 2.0)]).expect("a limit");
    let jump = impact.after.joints[1][0] - impact.before.joints[1][0];
    assert!((most - 2.0 * 1.2 / jump.abs()).abs() < ROUNDING && by == elbow);
}

/// Two uniform rods of 1 kg and 1 m in a row, with the hinges `shoulder` and `elbow`.
pub fn two_rods() -> MechanismBuilder {
    let mut builder = MechanismBuilder::new("rods");
    let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let about_com = Matrix3::from_diagonal(&Vector3::new(0.0, 1.0, 1.0)) / 12.0;
    let rod = Inertial { mass: 1.0, com: Vector3::new(0.5, 0.0, 0.0), about_com };
    builder = builder.link(LinkDescription::new("ground", none));
    for (name, parent, at, joint) in [("inner", "ground", 0.0, "shoulder"), ("outer", "inner", 1.0, "elbow")]
    {
        builder = builder.link(LinkDescription::new(name, rod));
        let mut hinge = JointDescription::new(joint, JointKind::Continuous, parent, name);
        hinge.axis = Vector3::z();
        hinge.origin = Transform::from_translation(Vector3::new(at, 0.0, 0.0));
        builder = builder.joint(hinge);
    }
    builder
}

#[test]
fn a_lock_receives_the_impulse_of_the_joint() {
    // With the locked elbow, both rods are one rod of twice the length.
    let rods = Arc::new(two_rods().build().expect("a mechanism").mechanism);
    let pose = pose_of(&rods, &Conditions::new().lock("elbow"), &[]);
    let contact = Contact::new(rods.find_link("outer").expect("a link"), Vector3::x(), Vector3::y());
    let response = pose.respond(&contact).expect("a response");
    let reactions = reactions_to_unit_impulse(&pose, &response).expect("reactions");
    // I = 8/3, Δω = −2/(8/3) = −3/4. Outer rod: Δv of its centre −9/8; force at the elbow −9/8 + 1 = −1/8; moment about
    // the elbow: 1/12 Δω + 1/2 Δv − (−1) = −1/16 − 9/16 + 1 = 3/8.
    let elbow = &reactions.joints[1];
    assert!((value(elbow.reaction.force[1]) + 0.125).abs() < ROUNDING, "{elbow:?}");
    assert!((value(elbow.drives[0].constraint) - 0.375).abs() < ROUNDING, "{elbow:?}");
    assert!((value(elbow.reaction.moment[2]) - 0.375).abs() < ROUNDING, "{elbow:?}");
    let [lock] = &reactions.joint_constraints[..] else { panic!("{reactions:?}") };
    assert_eq!(lock.constraint, JointConstraint::Lock(elbow.joint));
    assert!((value(lock.impulses[0].2) - 0.375).abs() < ROUNDING, "{lock:?}");
}

#[test]
fn a_point_that_cannot_slide_is_heavier() {
    // Two point-like links with both hinges free: Λ by hand from the Jacobian of the tip.
    let mechanism = model("planar_2r");
    let pose = pose_of(&mechanism, &Conditions::new(), &[("elbow", 0.7)]);
    let link = mechanism.find_link("outer").expect("the outer link");
    let normal = Vector3::new(0.6, 0.8, 0.0);
    let contact = Contact::new(link, Vector3::new(0.4, 0.0, 0.0), normal)
        .normal(Direction::Along(normal, Frame::World));
    let response = pose.respond(&contact).expect("a response");
    let held = held_point_mass(&pose, &response.contact).expect("matrices");
    let jacobian = pose.point_jacobian(link, &Vector3::new(0.4, 0.0, 0.0));
    let inverse = pose.mass_matrix().try_inverse().expect("regular");
    let planar = jacobian.rows(0, 2);
    let lambda = (planar * inverse * planar.transpose()).try_inverse().expect("regular");
    let n = Vector2::new(0.6, 0.8);
    let expected = (n.transpose() * lambda * n)[(0, 0)];
    assert!((finite(held) / expected - 1.0).abs() < 1e-12, "{held:?} {expected}");
    assert!(finite(held) > finite(response.effective_mass));
}

#[test]
fn friction_of_one_motion_has_the_energetic_restitution() {
    // A rod hinged at one end touches at its other end: at unit closing speed the end slides with t = |tan|.
    let (mass, length) = (2.0, 0.8);
    let rod = hinged_rod(mass, length);
    let pose = pose_of(&rod, &Conditions::new(), &[]);
    let link = rod.find_link("rod").expect("the rod");
    let normal = Vector3::new(0.6, 0.8, 0.0);
    let contact = Contact::new(link, Vector3::new(length, 0.0, 0.0), normal);
    let response = pose.respond(&contact).expect("a response");
    let (m, slope) = (finite(response.effective_mass), 0.75);
    let (c, e) = (1.5, 0.6);
    for coefficient in [0.0, 0.2, 0.9, 1.3, 1.4, 3.0] {
        let impact = RigidImpact::with_friction(&pose, &response, c, e, energetic(coefficient), None)
            .expect("an impact");
        let friction = impact.friction.expect("friction");
        let product = coefficient * slope;
        assert!(
            (friction.thresholds.slope.expect("one motion") - slope).abs() < ROUNDING
                && friction.is_wedged == (product >= 1.0)
        );
        let compression = m * c / (1.0 + product);
        let after = closing_speed(&pose, &response.contact, &impact.after);
        if product < 1.0 {
            let reached = e * ((1.0 - product) / (1.0 + product)).sqrt();
            assert!((after + reached * c).abs() < ROUNDING, "{coefficient}: {after}");
            // Work of the normal impulse: restitution is e² of compression (Stronge).
            let expansion = impact.impulse - compression;
            let (work_in, work_out) = (0.5 * c * compression, 0.5 * reached * c * expansion);
            assert!((work_out / work_in - e * e).abs() < ROUNDING, "{coefficient}");
        } else {
            assert!(after.abs() < ROUNDING && (impact.impulse - compression).abs() < ROUNDING);
        }
        // Kinetic energy by the inertia about the hinge.
        let inertia = mass * length * length / 3.0;
        let energy = |rates: &JointRates| 0.5 * inertia * rates.joints[0][0] * rates.joints[0][0];
        assert!((energy(&impact.before) - energy(&impact.after) - impact.energy_loss).abs() < ROUNDING);
        // Angular momentum about the hinge: the moment of normal and friction changes the rate.
        let force = -normal * impact.impulse + friction.tangential_impulse;
        let jump = impact.after.joints[0][0] - impact.before.joints[0][0];
        assert!((length * force.y - inertia * jump).abs() < ROUNDING, "{coefficient}");
        // The hinge carries the rest: m Δv_com = F + R.
        let reaction = &impact.reactions.joints[0].reaction;
        let along = value(reaction.force[0]);
        assert!((along + force.x).abs() < ROUNDING, "{coefficient}: {along}");
        let across = value(reaction.force[1]);
        assert!((mass * jump * length / 2.0 - force.y - across).abs() < ROUNDING, "{coefficient}: {across}");
        assert!(normal.dot(&friction.tangential_impulse).abs() < ROUNDING);
    }
}

fn energetic(coefficient: f64) -> FrictionLaw {
    FrictionLaw { coefficient, restitution: RestitutionLaw::Energetic }
}

/// A rod of mass m and length l, hit at s from its hinge: the impulse in the hinge per impulse is 1 − s m l/(2 I), I = m l²/3. A
/// displacement along the hinge axis adds a moment in the hinge and no force, so that the worst point of a circle is on the rod.
#[test]
fn the_worst_point_of_a_circle_is_on_the_rod() {
    let (mass, length) = (2.0, 0.6);
    let mechanism = hinged_rod(mass, length);
    let pose = pose_of(&mechanism, &Conditions::new(), &[]);
    let hinge = mechanism.joint_ids().next().expect("a hinge");
    let axis = *mechanism.joint(hinge).axis();
    let link = mechanism.joint(hinge).child();
    let com = mechanism.link(link).inertia().first_moment / mass;
    let along = com.normalize();
    let ratio = |s: f64| 1.0 - 1.5 * s / length;
    for (s, radius) in [(0.3, 0.05), (0.45, 0.05), (0.4, 0.0), (0.1, 0.3), (0.39, 0.02)] {
        let point = along * s;
        let contact =
            Contact { link, against: None, point, normal: Direction::Along(axis.cross(&along), Frame::Link) };
        let found = worst_reaction_within(&pose, &contact, hinge, radius).expect("a reaction");
        let expected = ratio(s - radius).abs().max(ratio(s + radius).abs());
        assert!((found.given_reaction - ratio(s).abs()).abs() < 1e-12, "{found:?}");
        assert!((found.worst_reaction - expected).abs() < 1e-12, "{found:?} {expected}");
        let moved = Contact { point: found.point, ..contact };
        let response = pose.respond(&moved).expect("a contact");
        let reactions = reactions_to_unit_impulse(&pose, &response).expect("reactions");
        let there = reactions.joints[hinge.index()].reaction.force_magnitude().expect("a magnitude");
        assert!((there - found.worst_reaction).abs() < 1e-12, "{there}");
    }
    let contact = Contact::new(link, [0.1, 0.1, 0.1], [1.0, 0.0, 0.0]);
    let refused = worst_reaction_within(&pose, &contact, hinge, -1.0);
    assert!(matches!(refused, Err(PercussionError::Radius { .. })), "{refused:?}");
}

/// The impulse in a gear reaches its limit at the greatest closing speed.
#[test]
fn the_greatest_speed_of_gears_reaches_the_limit() {
    let mechanism = model("planar_2r");
    let conditions = Conditions::new().armature("shoulder", [0.2]).armature("elbow", [0.05]);
    let pose = pose_of(&mechanism, &conditions, &[("elbow", 0.7)]);
    let contact =
        Contact::new(mechanism.find_link("outer").expect("a link"), [0.4, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let response = pose.respond(&contact).expect("a contact");
    let joint = |name: &str| mechanism.find_joint(name).expect("a joint");
    let limits = [(joint("shoulder"), 0, 0.3), (joint("elbow"), 0, 0.4)];
    let (speed, limiting) = greatest_closing_speed_of_gears(&pose, &response, 0.2, &limits).expect("a limit");
    let impact = RigidImpact::new(&pose, &response, speed, 0.2, None).expect("an impact");
    for (joint, k, limit) in limits {
        let gear = impact.reactions.joints[joint.index()].drives[k].gear.abs();
        assert!(gear <= limit * (1.0 + 1e-12), "{gear} {limit}");
        assert_eq!((gear / limit - 1.0).abs() < 1e-12, joint == limiting, "{gear} {limit}");
    }
    // A joint without a rotor has no gear.
    let rod = hinged_rod(2.0, 0.6);
    let pose = pose_of(&rod, &Conditions::new(), &[]);
    let hinge = rod.joint_ids().next().expect("a hinge");
    let contact = Contact::new(rod.joint(hinge).child(), [0.4, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let response = pose.respond(&contact).expect("a contact");
    assert_eq!(greatest_closing_speed_of_gears(&pose, &response, 0.2, &[(hinge, 0, 0.1)]), None);
}

/// Masses with locked joints equal those of one free body, 1/(1/m + (r × n)ᵀ I⁻¹ (r × n)) for a sliding point. On a floating base the
/// sliding mass equals the effective mass with all joints locked, and is not below the effective mass with free joints.
#[test]
fn locked_joints_are_one_body() {
    let mechanism = model("six_r_arm");
    let set = [("shoulder", -0.7), ("elbow", 1.2), ("yaw", 0.4)];
    let names: Vec<String> = mechanism
        .joints()
        .iter()
        .filter(|joint| joint.kind().dofs() > 0)
        .map(|joint| joint.name().to_owned())
        .collect();
    let contact = Contact {
        link: mechanism.find_link("tool").expect("the tool"),
        against: None,
        point: Vector3::new(0.08, 0.01, -0.02),
        normal: Direction::Along(Vector3::new(0.2, 0.5, -1.0), Frame::World),
    };
    for (base, is_floating) in [(Base::Fixed, false), (Base::Floating, true)] {
        let pose = pose_of(&mechanism, &Conditions::new().base(base), &set);
        let located = pose.locate(&contact).expect("a contact");
        let [sliding, sticking] = locked_body_masses(&pose, &located).expect("masses").map(finite);
        let (mut mass, mut moment) = (0.0, Vector3::zeros());
        let parts: Vec<(f64, Vector3<f64>, Matrix3<f64>)> = mechanism
            .link_ids()
            .filter(|link| is_floating || *link != mechanism.root())
            .map(|link| {
                let (frame, inertia) = (pose.link(link), mechanism.link(link).inertia());
                let com = inertia.first_moment / inertia.mass.max(f64::MIN_POSITIVE);
                let about_origin = inertia.rotational;
                let shift = Matrix3::from_diagonal_element(com.norm_squared()) - com * com.transpose();
                let about_com = about_origin - shift * inertia.mass;
                let rotated = frame.rotation * about_com * frame.rotation.transpose();
                (inertia.mass, frame.point(&com), rotated)
            })
            .collect();
        for (m, com, _) in &parts {
            mass += m;
            moment += com * *m;
        }
        let com = moment / mass;
        let mut inertia = Matrix3::zeros();
        for (m, own, about) in &parts {
            let d = own - com;
            inertia += about + (Matrix3::from_diagonal_element(d.norm_squared()) - d * d.transpose()) * *m;
        }
        let inverse = inertia.try_inverse().expect("an inertia");
        let r = pose.link(contact.link).point(&contact.point) - com;
        let mobility =
            Matrix3::from_diagonal_element(1.0 / mass) - r.cross_matrix() * inverse * r.cross_matrix();
        let n = located.normal_world;
        let expected = 1.0 / (n.transpose() * mobility * n)[0];
        assert!((sliding / expected - 1.0).abs() < 1e-12, "{sliding} {expected}");
        let expected = (n.transpose() * mobility.try_inverse().expect("a mobility") * n)[0];
        assert!((sticking / expected - 1.0).abs() < 1e-12, "{sticking} {expected}");
        assert!(sticking >= sliding * (1.0 - ROUNDING));
        if is_floating {
            let locked = names.iter().fold(Conditions::new().base(base), |c, name| c.lock(name));
            let locked = pose_of(&mechanism, &locked, &set);
            let mass = finite(locked.respond(&contact).expect("a response").effective_mass);
            assert!((sliding / mass - 1.0).abs() < 1e-10, "{sliding} {mass}");
            let free = finite(pose.respond(&contact).expect("a response").effective_mass);
            assert!(sliding >= free * (1.0 - ROUNDING), "{sliding} {free}");
        }
        let between = located_between(&pose, &contact);
        assert_eq!(locked_body_masses(&pose, &between).expect("masses"), [EffectiveMass::Immovable; 2]);
    }
}

/// The same contact against the parent link.
fn located_between(pose: &Pose, contact: &Contact) -> percuss_dynamics::LocatedContact {
    let mechanism = pose.mechanism();
    let parent = mechanism.parent_joint(contact.link).map(|joint| mechanism.joint(joint).parent());
    pose.locate(&Contact { against: parent, ..*contact }).expect("a contact")
}
