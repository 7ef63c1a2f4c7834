//! A closed form for every kind of closure and for the coupling, and the effects of floating bases and massless parts
//! on loops.

use nalgebra::{Vector2, Vector3};
use percuss_dynamics::{Base, Conditions, System};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, Mechanism,
    MechanismBuilder,
};
use percuss_oracle::closed_form::{self, Crossing, planar_effective_mass};
use percuss_oracle::{alter, linkage};
use percuss_spatial::{Transform, rotation_from_rpy};
use percuss_tests::bench::{Bench, assert_close};
use percuss_tests::gauge::Gauge;
use percuss_tests::rig::{Rig, in_plane, mass};

/// Masses of the wedge's sliders, kg.
const WEDGE: [f64; 2] = [1.7, 0.9];

/// Two sliders along x and along y, each on the ground; a closure keeps the second slider on a line (or a plane) that
/// rises by `slope` on the first: y = ±x tan(slope). For a contact on the first slider along x, m̄ = m₁ + m₂ tan².
///
/// A cylindrical or planar closure leaves the rotation about its axis free, which the slides hold.
fn wedge(kind: ClosureKind, slope: f64) -> Mechanism {
    let body = |name: &str, mass: f64| {
        LinkDescription::new(name, Inertial::diagonal(mass, [0.02, 0.01, 0.03], [0.01, 0.012, 0.015]))
    };
    let place = Transform::new(rotation_from_rpy([0.4, -0.7, 1.1]), Vector3::new(0.2, -0.1, 0.5));
    let slide = |name: &str, axis: [f64; 3]| {
        JointDescription::new(name, JointKind::Prismatic, "ground", name).origin(place).axis(axis)
    };
    let (sin, cos) = slope.sin_cos();
    let axis = match kind {
        ClosureKind::Planar => [-sin, cos, 0.0],
        // The second slider moves down the slope of the first: y up while x moves forward.
        _ => [-cos, sin, 0.0],
    };
    let closure = ClosureDescription::new("slope", kind, "first", "second").at([0.0; 3], [0.0; 3]).axis(axis);
    MechanismBuilder::new("wedge")
        .link(LinkDescription::massless("ground"))
        .link(body("first", WEDGE[0]))
        .link(body("second", WEDGE[1]))
        .joint(slide("first", [1.0, 0.0, 0.0]))
        .joint(slide("second", [0.0, 1.0, 0.0]))
        .closure(closure)
        .build()
        .expect("a wedge")
        .mechanism
}

#[test]
fn sliding_closures_are_wedges() {
    let mut gauge = Gauge::new("wedges");
    for (kind, redundant) in
        [(ClosureKind::Prismatic, 4), (ClosureKind::Cylindrical, 3), (ClosureKind::Planar, 2)]
    {
        for slope in [0.2, 0.7, 1.2] {
            let bench = Bench::new(wedge(kind, slope)).set("first", &[0.3]);
            let pose = bench.system.pose(&bench.configuration).expect("it closes");
            let y = pose.joint(bench.system.mechanism().find_joint("second").unwrap())[0];
            // On the line, the second slider rises as the first moves forward; on the plane, it falls.
            let rise = if kind == ClosureKind::Planar { -0.3 } else { 0.3 };
            assert!((y - rise * slope.tan()).abs() < 1e-12, "{kind:?}: {y}");
            let normal =
                Transform::new(rotation_from_rpy([0.4, -0.7, 1.1]), Vector3::zeros()).vector(&Vector3::x());
            let response = bench.respond(&bench.contact("first", [0.1, 0.2, 0.3], normal));
            let expected = WEDGE[0] + WEDGE[1] * slope.tan().powi(2);
            gauge.relative(&format!("{kind:?} {slope}"), mass(&response), expected, 1e-12);
            assert_eq!(bench.system.degrees_of_freedom(), 1);
            assert_eq!(bench.system.reference_or_open().redundant_constraints(), redundant, "{kind:?}");
        }
    }
    gauge.report();
}

/// A linkage with a closed form m̄(driver) for a contact at a link, along a normal that may depend on the driver.
type Form<'a> = (&'a str, [f64; 3], &'a dyn Fn(f64) -> Vector3<f64>, &'a dyn Fn(f64) -> f64);

fn over_the_range(rig: &Rig, (link, point, normal, form): Form, degrees: usize, gauge: &mut Gauge) {
    assert_eq!(rig.system.degrees_of_freedom(), degrees, "{}", rig.name);
    let mut pose = rig.closed();
    for i in 0..=72 {
        let drivers = rig.at(f64::from(i) / 72.0);
        pose = rig.reach(&pose, &drivers);
        let response = rig.respond(&pose, &rig.contact(link, point, normal(drivers[0])));
        gauge.relative(&format!("{} at {drivers:?}", rig.name), mass(&response), form(drivers[0]), 1e-12);
    }
}

#[test]
fn every_other_kind_has_its_closed_form() {
    let mut gauge = Gauge::new("closed forms of closures and couplings");
    // Universal closure.
    for beta in [0.2, 0.6, 1.1] {
        let across = |t: f64| linkage::plane().vector(&Vector3::new(-t.sin(), t.cos(), 0.0));
        let form = |t| closed_form::hooke_shaft(0.03, 0.08, beta, t, 0.15);
        let rig = Rig::new(linkage::hooke_shaft(beta));
        over_the_range(&rig, ("input", [0.15, 0.0, 0.4], &across, &form), 1, &mut gauge);
        let pose = rig.reach(&rig.closed(), &[2.5]);
        let output = pose.joint(rig.joint("output"))[0];
        assert!((output - closed_form::hooke_output_angle(beta, 2.5)).abs() < 1e-12, "{output}");
    }
    // Distance closure: a rod between balls, whose spin is massless.
    let ([first, second], length) = linkage::TRAMMEL;
    let along = |_: f64| linkage::plane().vector(&Vector3::x());
    let form = |x: f64| closed_form::elliptic_trammel(first, second, x, (length * length - x * x).sqrt());
    over_the_range(&Rig::new(linkage::trammel()), ("first", [0.1, 0.0, 0.2], &along, &form), 1, &mut gauge);
    let rod = Rig::new(linkage::trammel_with_rod());
    over_the_range(&rod, ("first", [0.1, 0.0, 0.2], &along, &form), 2, &mut gauge);
    // Couplings: in metres, in turns; fixed closures and couplings in one group.
    let rack = Rig::new(linkage::rack_and_pinion());
    let form = |_| closed_form::rack_and_pinion(1.5, 0.0021, 0.06);
    over_the_range(&rack, ("rack", [0.2, 0.1, 0.0], &|_| Vector3::x(), &form), 1, &mut gauge);
    let across = |rig: &Rig, joint: &str, t: f64| {
        let origin = *rig.mechanism.joint(rig.joint(joint)).origin();
        origin.vector(&Vector3::new(-t.sin(), t.cos(), 0.0))
    };
    let pair = Rig::new(linkage::geared_pair());
    let form = |_| closed_form::gear_pair(0.02, 0.005, -2.5, 0.08);
    over_the_range(&pair, ("slow", [0.08, 0.0, 0.1], &|t| across(&pair, "slow", t), &form), 1, &mut gauge);
    let gear = Rig::new(linkage::planetary_gear());
    let inertias = [0.004, 0.0006, 0.0003];
    let form = |_| closed_form::planetary_gear(inertias, 0.4, 0.063, 1.0, [24.0, 18.0, 60.0], 0.05);
    over_the_range(
        &gear,
        ("carrier", [0.05, 0.0, 0.0], &|t| across(&gear, "carrier", t), &form),
        1,
        &mut gauge,
    );
    assert_eq!(gear.system.reference_or_open().redundant_constraints(), 5);
    gauge.report();
}

#[test]
fn arms_without_mass_are_exact() {
    let rig = Rig::new(linkage::massless_arm_suspension());
    let mut pose = rig.closed();
    for i in 0..=40 {
        let theta = rig.at(f64::from(i) / 40.0);
        pose = rig.reach(&pose, &theta);
        for r_b in [0.1, 0.25, 0.4] {
            let n = in_plane(Vector2::new(-theta[0].sin(), theta[0].cos()));
            let response = rig.respond(&pose, &rig.contact("crank", [r_b, 0.0, 0.0], n));
            assert_close(mass(&response), closed_form::massless_arm_suspension(38.0, 0.4, r_b));
        }
    }
}

#[test]
fn a_heavy_chassis_is_the_ground() {
    let n = Vector2::new(0.6, 0.8);
    let bar = linkage::FOUR_BAR;
    let bodies: Vec<_> =
        linkage::FOUR_BAR_BODIES.into_iter().zip(bar.poses(0.9, Crossing::Left).unwrap()).collect();
    let fixed = planar_effective_mass(&bodies, 1, [0.31, -0.12].into(), n);
    let mut last = f64::INFINITY;
    for decade in [2, 4, 6, 8, 10] {
        let heavy = 10f64.powi(decade);
        let four_bar = linkage::four_bar();
        let (mut links, joints) = alter::describe(&four_bar.mechanism);
        let (closures, couplings) = alter::describe_loops(&four_bar.mechanism);
        links[0].inertial = Some(Inertial::diagonal(heavy, [0.1, 0.2, 0.0], [heavy, heavy, heavy]));
        let mechanism = alter::build_with_loops("heavy", links, joints, closures, couplings);
        let floating = Conditions::new().base(Base::Floating);
        let rig = Rig::under(linkage::Linkage { mechanism, ..four_bar }, &floating);
        assert_eq!(rig.system.degrees_of_freedom(), 7);
        let pose = rig.reach(&rig.closed(), &[0.9]);
        let here = mass(&rig.respond(&pose, &rig.contact("coupler", [0.31, -0.12, 0.0], in_plane(n))));
        let short = 1.0 - here / fixed;
        // The deviation decreases as 1/M, down to rounding.
        assert!(short > -1e-11 && short < (0.02 * last).max(1e-11), "{heavy:e}: {short:e} after {last:e}");
        last = short;
    }
    assert!(last < 1e-8, "{last:e}");
}

#[test]
fn a_loop_onto_the_world_does_not_let_the_base_off() {
    // The base is at its reference pose; if it floats, the closure constrains its six freedoms.
    let floating = Rig::under(linkage::foot_on_the_world(), &Conditions::new().base(Base::Floating));
    let ground = Rig::new(linkage::foot_on_the_world());
    assert_eq!((floating.system.degrees_of_freedom(), ground.system.degrees_of_freedom()), (8, 2));
    let mut poses = (floating.closed(), ground.closed());
    for part in [0.1, 0.5, 0.9] {
        poses = (floating.reach(&poses.0, &floating.at(part)), ground.reach(&poses.1, &ground.at(part)));
        for (a, b) in poses.0.positions().iter().zip(poses.1.positions()) {
            assert!((a - b).abs() < 1e-13, "{a} {b}");
        }
        let contact = ground.contact("base", [0.1, 0.2, 0.3], Vector3::new(0.2, -0.5, 0.6));
        let response = floating.respond(&poses.0, &contact);
        assert!(mass(&response) > 0.0);
    }
    // A body connected to the world by a closure alone.
    let body = LinkDescription::new("body", Inertial::diagonal(2.0, [0.3, 0.0, 0.0], [0.02, 0.03, 0.04]));
    let arm = LinkDescription::new("arm", Inertial::diagonal(0.5, [0.1, 0.0, 0.0], [0.002, 0.003, 0.004]));
    let mechanism = MechanismBuilder::new("hung")
        .link(body)
        .link(arm)
        .joint(
            JointDescription::new("wrist", JointKind::Revolute, "body", "arm")
                .at([0.5, 0.0, 0.0])
                .axis([0.0, 0.0, 1.0]),
        )
        .closure(
            ClosureDescription::new("hook", ClosureKind::Revolute, "world", "body").axis([0.0, 0.0, 1.0]),
        )
        .build()
        .expect("a body on a hook")
        .mechanism;
    let system = System::new(mechanism, &Conditions::new().base(Base::Floating).lock("wrist")).expect("free");
    assert_eq!(system.degrees_of_freedom(), 1);
    let bench = Bench { configuration: system.configuration(), system };
    let response = bench.respond(&bench.contact("body", [0.8, 0.0, 0.0], Vector3::y()));
    let j_o = 0.04 + 2.0 * 0.09 + 0.004 + 0.5 * 0.36;
    assert_close(mass(&response), closed_form::physical_pendulum(j_o, 0.8));
}
