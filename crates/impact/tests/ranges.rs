//! Extremes and reflected inertias over ranges of positions.

use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{Conditions, Contact, Direction, EffectiveMass, Frame, Pose, System};
use percuss_formats::load_file;
use percuss_impact::{
    Bearing, ExtremeKind, ExtremeMass, ExtremesError, JointRange, NoSubstitute, NormalRange, PeakForceLaw,
    RigidImpact, SearchedContact, SearchedQuantity, extreme_effective_mass, extreme_quantity,
    reactions_to_unit_impulse, reflected_inertia_over,
};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder, MimicDescription,
};
use percuss_spatial::Transform;
use std::sync::Arc;

/// Planar arm with point masses at the ends of its links of length 1.
fn arm(m1: f64, m2: f64) -> Arc<Mechanism> {
    let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let point = |mass| Inertial { mass, com: Vector3::x(), about_com: Matrix3::zeros() };
    let mut builder = MechanismBuilder::new("arm").link(LinkDescription::new("ground", none));
    for (name, parent, at, joint, mass) in
        [("inner", "ground", 0.0, "shoulder", m1), ("outer", "inner", 1.0, "elbow", m2)]
    {
        builder = builder.link(LinkDescription::new(name, point(mass)));
        let mut hinge = JointDescription::new(joint, JointKind::Continuous, parent, name);
        hinge.axis = Vector3::z();
        hinge.origin = Transform::from_translation(Vector3::new(at, 0.0, 0.0));
        builder = builder.joint(hinge);
    }
    Arc::new(builder.build().expect("a mechanism").mechanism)
}

/// Asserts that an extreme is at least as extreme as all values of a scan, and near the extreme of the scan. `tolerance`: relative, of the
/// order of the square of the step of the scan.
fn assert_extreme_of_scan(extreme: ExtremeKind, value: f64, scan: &[f64], tolerance: f64) {
    let is_least = extreme == ExtremeKind::Least;
    let pick = if is_least { f64::min } else { f64::max };
    let of_scan = scan.iter().copied().reduce(pick).expect("a scan");
    assert!((value / of_scan - 1.0).abs() < tolerance, "{extreme:?}: {value}, scan {of_scan}");
    let beyond = if is_least { value - of_scan } else { of_scan - value };
    assert!(beyond <= 1e-9 * of_scan, "{extreme:?}: {value}, scan {of_scan}");
}

#[test]
fn extremes_of_a_planar_arm() {
    // Λ = m₂ 1 + (m₁/sin²q₂) u₂u₂ᵀ, so m₂ ≤ m̄ ≤ m₂ + m₁/sin²q₂; both are reached by turning the shoulder.
    let (m1, m2) = (3.0, 2.0);
    let mechanism = arm(m1, m2);
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let contact = Contact {
        link: mechanism.find_link("outer").expect("the outer link"),
        against: None,
        point: Vector3::x(),
        normal: Direction::Along(Vector3::y(), Frame::World),
    };
    let joint = |name: &str| mechanism.find_joint(name).expect("a joint");
    let range = |name: &str, lower, upper| JointRange { joint: joint(name), lower, upper };
    let ranges = [range("shoulder", -3.0, 3.0), range("elbow", 0.3, 2.0)];
    let search = |ranges: &[JointRange], extreme| {
        extreme_effective_mass(&system, &system.configuration(), (&contact).into(), ranges, extreme, 16)
    };
    let least = search(&ranges, ExtremeKind::Least).expect("a minimum");
    let EffectiveMass::Finite(mass) = least.effective_mass else { panic!("{least:?}") };
    assert!((mass / m2 - 1.0).abs() < 1e-9, "{least:?}");
    assert!(least.residual < 1e-6 && least.agreeing >= 8, "{least:?}");
    let most = search(&ranges, ExtremeKind::Most).expect("a maximum");
    let EffectiveMass::Finite(mass) = most.effective_mass else { panic!("{most:?}") };
    let expected = m2 + m1 / 0.3_f64.sin().powi(2);
    assert!((mass / expected - 1.0).abs() < 1e-9, "{most:?} {expected}");
    assert_eq!(most.active_limits, [(joint("elbow"), false)], "{most:?}");
    assert!(most.residual < 1e-6 && most.agreeing >= 4, "{most:?}");
    // The same call has the same result.
    assert_eq!(search(&ranges, ExtremeKind::Most).expect("a maximum"), most);
    // With the stretched arm inside the range the tip is immovable along the arm.
    let wide = [range("shoulder", -3.0, 3.0), range("elbow", -1.0, 2.0)];
    let most = search(&wide, ExtremeKind::Most).expect("a maximum");
    assert_eq!(most.effective_mass, EffectiveMass::Immovable, "{most:?}");
    assert!(most.positions[1].abs() < 1e-3 && (most.positions[0].sin().abs() - 1.0).abs() < 1e-3, "{most:?}");
    let empty = [range("elbow", 1.0, 1.0)];
    assert!(matches!(search(&empty, ExtremeKind::Most), Err(ExtremesError::Range { .. })));
    assert!(matches!(search(&[], ExtremeKind::Most), Err(ExtremesError::NoJoint)));
}

/// Over positions and normals of the plane: m₂ on a continuum, and m₂ + m₁/sin²q₂ at the limit of least |sin q₂|, for masses and
/// limits over a grid. At least 95 % of the starts find the planted value.
#[test]
fn extremes_over_normals_are_planted() {
    let (mut agreeing, mut starts) = (0, 0);
    for (m1, m2) in [(3.0, 2.0), (0.5, 4.0), (20.0, 0.3)] {
        let mechanism = arm(m1, m2);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let contact = Contact {
            link: mechanism.find_link("outer").expect("the outer link"),
            against: None,
            point: Vector3::x(),
            normal: Direction::Along(Vector3::y(), Frame::World),
        };
        let elbow = mechanism.find_joint("elbow").expect("a joint");
        let shoulder = mechanism.find_joint("shoulder").expect("a joint");
        for (lower, upper) in [(0.3, 1.4), (0.2, 1.1), (1.7, 2.9)] {
            let ranges = [
                JointRange { joint: shoulder, lower: -1.0, upper: 1.0 },
                JointRange { joint: elbow, lower, upper },
            ];
            let search = |normals, extreme| {
                let start = system.configuration();
                extreme_effective_mass(
                    &system,
                    &start,
                    SearchedContact { normals, ..(&contact).into() },
                    &ranges,
                    extreme,
                    16,
                )
                .expect("an extreme")
            };
            let across = NormalRange::Across(Vector3::z() * 3.0);
            let (least, most) = (search(across, ExtremeKind::Least), search(across, ExtremeKind::Most));
            let sine = lower.sin().min(upper.sin());
            let expected = m2 + m1 / (sine * sine);
            let mass = |found: &ExtremeMass| found.effective_mass.kilograms().expect("a finite mass");
            assert!((mass(&least) / m2 - 1.0).abs() < 1e-9, "{least:?}");
            assert!((mass(&most) / expected - 1.0).abs() < 1e-9, "{most:?} {expected}");
            assert_eq!(most.active_limits, [(elbow, upper.sin() < lower.sin())], "{most:?}");
            let normal = most.normal_world.expect("a normal");
            assert!(normal.z.abs() < 1e-12 && (normal.norm() - 1.0).abs() < 1e-12, "{normal}");
            let at = Contact { normal: Direction::Along(normal, Frame::World), ..contact };
            let mut there = system.configuration();
            there.set("shoulder", &[most.positions[0]]).expect("a position");
            there.set("elbow", &[most.positions[1]]).expect("a position");
            let check = system.pose(&there).expect("a pose").respond(&at).expect("a response");
            let check = check.effective_mass.kilograms().expect("a mass");
            assert!((check / expected - 1.0).abs() < 1e-9, "{check} {expected}");
            agreeing += least.agreeing + most.agreeing;
            starts += least.starts + most.starts;
            // In space the arm is immovable along its hinges.
            let any = search(NormalRange::Any, ExtremeKind::Most);
            assert_eq!(any.effective_mass, EffectiveMass::Immovable, "{any:?}");
        }
    }
    println!("{agreeing} of {starts}");
    assert!(agreeing * 100 >= starts * 95, "{agreeing} of {starts}");
    let mechanism = arm(1.0, 1.0);
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let joint = mechanism.find_joint("elbow").expect("a joint");
    let contact = Contact {
        link: mechanism.find_link("outer").expect("the outer link"),
        against: None,
        point: Vector3::x(),
        normal: Direction::Along(Vector3::y(), Frame::World),
    };
    let none = NormalRange::Across(Vector3::zeros());
    let ranges = [JointRange { joint, lower: 0.1, upper: 1.0 }];
    let start = system.configuration();
    let refused = extreme_effective_mass(
        &system,
        &start,
        SearchedContact { normals: none, ..(&contact).into() },
        &ranges,
        ExtremeKind::Most,
        1,
    );
    assert!(matches!(refused, Err(ExtremesError::NoAxis)), "{refused:?}");
}

#[test]
fn extremes_of_a_linkage_are_those_of_its_sweep() {
    let mechanism = four_bar();
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let crank = mechanism.find_joint("crank_hinge").expect("the crank");
    let contact = contact_of_coupler(&mechanism);
    let (lower, upper) = (-0.6, 0.6);
    let mass = |turn: f64| {
        let mut configuration = system.configuration();
        configuration.set("crank_hinge", &[turn]).expect("a position");
        let pose = system.pose(&configuration).expect("a pose");
        pose.respond(&contact).expect("a response").effective_mass.kilograms().expect("a finite mass")
    };
    let sweep: Vec<f64> = (0..=600).map(|k| mass(lower + (upper - lower) * f64::from(k) / 600.0)).collect();
    let ranges = [JointRange { joint: crank, lower, upper }];
    for extreme in [ExtremeKind::Least, ExtremeKind::Most] {
        let found =
            extreme_effective_mass(&system, &system.configuration(), (&contact).into(), &ranges, extreme, 8);
        let found = found.expect("an extreme");
        let EffectiveMass::Finite(value) = found.effective_mass else { panic!("{found:?}") };
        assert_extreme_of_scan(extreme, value, &sweep, 1e-4);
        assert!((mass(found.positions[0]) / value - 1.0).abs() < 1e-9);
    }
}

/// Reflected inertias at the shoulder of a planar arm with point masses and links of 1 m: m₁ + m₂ sin²q₂ with a free elbow, which is
/// smallest at a stretched elbow and largest at a right angle; m₁ + m₂ (2 + 2 cos q₂) with a held elbow. At least 95 % of the starts find
/// the extreme of the closed form.
#[test]
fn extremes_of_reflected_inertias_are_planted() {
    let (mut agreeing, mut starts) = (0, 0);
    for (m1, m2) in [(3.0, 2.0), (0.5, 4.0), (20.0, 0.3)] {
        let mechanism = arm(m1, m2);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let contact =
            Contact::new(mechanism.find_link("outer").expect("a link"), [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        let joint = |name: &str| mechanism.find_joint(name).expect("a joint");
        for (lower, upper) in [(0.3, 2.0), (-1.2, 0.9), (1.7, 3.0)] {
            let ranges = [JointRange { joint: joint("elbow"), lower, upper }];
            let search = |held, extreme| {
                let quantity = SearchedQuantity::ReflectedInertia { joint: joint("shoulder"), held };
                let start = system.configuration();
                extreme_quantity(&system, &start, (&contact).into(), quantity, &ranges, extreme, 16)
                    .expect("an extreme")
            };
            let free = |q: f64| m1 + m2 * q.sin().powi(2);
            let held = |q: f64| m1 + m2 * (2.0 + 2.0 * q.cos());
            // Values at the ends, and at the stationary points inside the range.
            let candidates = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
                let quarter = std::f64::consts::FRAC_PI_2;
                let inside = (-2..=2).map(|k| f64::from(k) * quarter).filter(|q| (lower..upper).contains(q));
                [lower, upper].into_iter().chain(inside).map(f).collect()
            };
            for (is_held, f) in [(false, &free as &dyn Fn(f64) -> f64), (true, &held)] {
                let values = candidates(f);
                let least = values.iter().copied().fold(f64::INFINITY, f64::min);
                let most = values.iter().copied().fold(0.0, f64::max);
                for (extreme, expected) in [(ExtremeKind::Least, least), (ExtremeKind::Most, most)] {
                    let found = search(is_held, extreme);
                    let value = found.effective_mass.kilograms().expect("a finite inertia");
                    assert!(
                        (value / expected - 1.0).abs() < 1e-9,
                        "{is_held} {extreme:?}: {found:?} {expected}"
                    );
                    assert!(found.residual < 1e-6, "{found:?}");
                    starts += found.starts;
                    agreeing += found.agreeing;
                }
            }
        }
    }
    // Some ranges have two maxima of the free inertia.
    println!("{agreeing} of {starts}");
    assert!(agreeing * 100 >= starts * 95, "{agreeing} of {starts}");
}

/// Shipped four-bar.
fn four_bar() -> Arc<Mechanism> {
    let path = format!("{}/../../models/four_bar.urdf", env!("CARGO_MANIFEST_DIR"));
    Arc::new(load_file(&path).expect("a model").mechanism)
}

/// Point of the coupler of the four-bar, with a normal fixed in the world.
fn contact_of_coupler(mechanism: &Mechanism) -> Contact {
    Contact {
        link: mechanism.find_link("coupler").expect("the coupler"),
        against: None,
        point: Vector3::new(0.35, 0.1, 0.0),
        normal: Direction::Along(Vector3::x(), Frame::World),
    }
}

/// Tip of the outer link of an arm, with a normal fixed in the world.
fn contact_of_tip(arm: &Mechanism) -> Contact {
    Contact {
        link: arm.find_link("outer").expect("the outer link"),
        against: None,
        point: Vector3::x(),
        normal: Direction::Along(Vector3::y(), Frame::World),
    }
}

/// Impulse in the rocker hinge of a four-bar per closing speed of a plastic impact, with a normal fixed in the world: the extremes over
/// the crank angle agree with those of a scan of 601 poses.
#[test]
fn extremes_of_a_bearing_are_those_of_a_scan() {
    let mechanism = four_bar();
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let joint = |name: &str| mechanism.find_joint(name).expect("a joint");
    let contact = contact_of_coupler(&mechanism);
    let (lower, upper) = (-0.6, 0.6);
    let bearing = joint("rocker_hinge");
    let impulse = |turn: f64| {
        let mut configuration = system.configuration();
        configuration.set("crank_hinge", &[turn]).expect("a position");
        let pose = system.pose(&configuration).expect("a pose");
        let response = pose.respond(&contact).expect("a response");
        let rigid = RigidImpact::new(&pose, &response, 1.0, 0.0, None).expect("an impact");
        let force = rigid.reactions.joints[bearing.index()].reaction.force;
        force.iter().filter_map(|c| c.value()).map(|x| x * x).sum::<f64>().sqrt()
    };
    let scan: Vec<f64> = (0..=600).map(|k| impulse(lower + (upper - lower) * f64::from(k) / 600.0)).collect();
    let ranges = [JointRange { joint: joint("crank_hinge"), lower, upper }];
    for extreme in [ExtremeKind::Least, ExtremeKind::Most] {
        let quantity = SearchedQuantity::BearingImpulse { bearing: bearing.into() };
        let start = system.configuration();
        let found = extreme_quantity(&system, &start, (&contact).into(), quantity, &ranges, extreme, 8);
        let found = found.expect("an extreme");
        let value = found.effective_mass.kilograms().expect("a finite impulse");
        assert_extreme_of_scan(extreme, value, &scan, 1e-3);
        assert!((impulse(found.positions[0]) / value - 1.0).abs() < 1e-9);
    }
    // At some poses the hinge has no impulse: the smallest value is zero, where |R| is not differentiable. At least 95 % of the starts
    // find it.
    let arm = arm(3.0, 2.0);
    let planar = System::new(Arc::clone(&arm), &Conditions::new()).expect("a system");
    let tip = contact_of_tip(&arm);
    let of =
        |name: &str, lower, upper| JointRange { joint: arm.find_joint(name).expect("a joint"), lower, upper };
    let wide = [of("shoulder", -1.2, 1.2), of("elbow", 0.3, 2.8)];
    let quantity = SearchedQuantity::BearingImpulse { bearing: wide[0].joint.into() };
    let found = extreme_quantity(
        &planar,
        &planar.configuration(),
        (&tip).into(),
        quantity,
        &wide,
        ExtremeKind::Least,
        16,
    );
    let found = found.expect("an extreme");
    assert_eq!(found.effective_mass, EffectiveMass::Finite(0.0), "{found:?}");
    assert!(found.agreeing * 100 >= found.starts * 95 && found.residual < 1e-3, "{found:?}");
    let quantity = SearchedQuantity::ReflectedInertia { joint: bearing, held: false };
    let any = SearchedContact { normals: NormalRange::Any, ..(&contact).into() };
    let start = system.configuration();
    let refused = extreme_quantity(&system, &start, any, quantity, &ranges, ExtremeKind::Most, 1);
    assert!(matches!(refused, Err(ExtremesError::NormalsOfContact)), "{refused:?}");
}

/// Extreme loads of a joint, a closure and the ground of a four-bar, over the crank angle and the normals in the plane, are equal to the
/// extremes of a grid of rigid impacts. The loads are the impulse, and the peak forces with a linear spring and with a Hertzian contact.
#[test]
fn bearing_loads_over_positions_and_normals_are_those_of_a_grid() {
    let mechanism = four_bar();
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let joint = |name: &str| mechanism.find_joint(name).expect("a joint");
    let contact = contact_of_coupler(&mechanism);
    let (lower, upper) = (0.2, 0.9);
    let ranges = [JointRange { joint: joint("crank_hinge"), lower, upper }];
    let pose = |turn: f64| {
        let mut configuration = system.configuration();
        configuration.set("crank_hinge", &[turn]).expect("a position");
        system.pose(&configuration).expect("a pose")
    };
    // Load at a pose and a normal, from one rigid impact; no load if the contact is immovable.
    let load = |pose: &Pose, normal: Vector3<f64>, bearing: Bearing, law: PeakForceLaw| {
        let contact = Contact { normal: Direction::Along(normal, Frame::World), ..contact };
        let response = pose.respond(&contact).expect("a response");
        let mass = response.effective_mass.kilograms()?;
        let reactions = reactions_to_unit_impulse(pose, &response).expect("reactions");
        let force = bearing.reaction(&reactions).expect("a reaction").force;
        let size = force.iter().filter_map(|c| c.value()).map(|x| x * x).sum::<f64>().sqrt();
        Some(size * law.force * mass.powf(law.power))
    };
    let poses: Vec<Pose> = (0..=20).map(|k| pose(lower + (upper - lower) * f64::from(k) / 20.0)).collect();
    let bearings = [Bearing::Joint(joint("rocker_hinge")), Bearing::Closure(0), Bearing::Ground];
    let laws = [(1.0, 1.0), (800.0, 0.5), (800.0, 0.6)].map(|(force, power)| PeakForceLaw { force, power });
    let direction = |angle: f64| Vector3::new(angle.cos(), angle.sin(), 0.0);
    for bearing in bearings {
        for law in laws {
            let quantity = match law.power == 1.0 {
                true => SearchedQuantity::BearingImpulse { bearing },
                false => SearchedQuantity::BearingPeakForce { bearing, law },
            };
            for extreme in [ExtremeKind::Least, ExtremeKind::Most] {
                let search = |normals| {
                    let searched = SearchedContact { normals, ..(&contact).into() };
                    let start = system.configuration();
                    extreme_quantity(&system, &start, searched, quantity, &ranges, extreme, 2)
                        .expect("an extreme")
                };
                let of_normal: Vec<f64> =
                    poses.iter().filter_map(|pose| load(pose, Vector3::x(), bearing, law)).collect();
                let fixed = search(NormalRange::Given);
                let value = fixed.effective_mass.kilograms().expect("a finite load");
                assert_extreme_of_scan(extreme, value, &of_normal, 1e-2);
                // With one degree of freedom, the point is immovable perpendicular to its path, so the largest load is unbounded.
                let found = search(NormalRange::Across(Vector3::z()));
                match extreme {
                    ExtremeKind::Most => {
                        assert_eq!(found.effective_mass, EffectiveMass::Immovable, "{found:?}")
                    }
                    ExtremeKind::Least => {
                        let angles = (0..90).map(|k| std::f64::consts::PI * f64::from(k) / 90.0);
                        let normals: Vec<Vector3<f64>> = angles.map(direction).collect();
                        let grid = poses.iter().flat_map(|pose| normals.iter().map(move |n| (pose, *n)));
                        let values: Vec<f64> =
                            grid.filter_map(|(pose, normal)| load(pose, normal, bearing, law)).collect();
                        let value = found.effective_mass.kilograms().expect("a finite load");
                        assert_extreme_of_scan(extreme, value, &values, 1e-2);
                        let normal = found.normal_world.expect("a normal");
                        let there = load(&pose(found.positions[0]), normal, bearing, law).expect("a load");
                        assert!((there / value - 1.0).abs() < 1e-9, "{there} {value}");
                    }
                }
            }
        }
    }
}

/// The largest loads of both hinges of an arm, over positions and all normals in the plane, are bounded and equal to the largest values of
/// a grid.
#[test]
fn the_largest_bearing_load_over_normals_of_an_arm_is_that_of_a_grid() {
    let arm = arm(3.0, 2.0);
    let system = System::new(Arc::clone(&arm), &Conditions::new()).expect("a system");
    let contact = contact_of_tip(&arm);
    let joint = |name: &str| arm.find_joint(name).expect("a joint");
    let (lower, upper) = (0.4, 2.4);
    let ranges = [JointRange { joint: joint("elbow"), lower, upper }];
    let law = PeakForceLaw { force: 300.0, power: 0.5 };
    for name in ["shoulder", "elbow"] {
        let bearing = Bearing::Joint(joint(name));
        for quantity in [
            SearchedQuantity::BearingImpulse { bearing },
            SearchedQuantity::BearingPeakForce { bearing, law },
        ] {
            let law = match quantity {
                SearchedQuantity::BearingPeakForce { law, .. } => law,
                _ => PeakForceLaw { force: 1.0, power: 1.0 },
            };
            let mut grid = Vec::new();
            for k in 0..=40 {
                let mut configuration = system.configuration();
                let turn = lower + (upper - lower) * f64::from(k) / 40.0;
                configuration.set("elbow", &[turn]).expect("a position");
                let pose = system.pose(&configuration).expect("a pose");
                for angle in (0..180).map(|degrees| f64::from(degrees).to_radians()) {
                    let normal = Direction::Along(Vector3::new(angle.cos(), angle.sin(), 0.0), Frame::World);
                    let response = pose.respond(&Contact { normal, ..contact }).expect("a response");
                    let reactions = reactions_to_unit_impulse(&pose, &response).expect("reactions");
                    let force = bearing.reaction(&reactions).expect("a reaction").force;
                    let size = force.iter().filter_map(|c| c.value()).map(|x| x * x).sum::<f64>().sqrt();
                    let mass = response.effective_mass.kilograms().expect("a mass");
                    grid.push(size * law.force * mass.powf(law.power));
                }
            }
            let searched =
                SearchedContact { normals: NormalRange::Across(Vector3::z()), ..(&contact).into() };
            let start = system.configuration();
            let found = extreme_quantity(&system, &start, searched, quantity, &ranges, ExtremeKind::Most, 3);
            let value = found.expect("an extreme").effective_mass.kilograms().expect("a finite load");
            assert_extreme_of_scan(ExtremeKind::Most, value, &grid, 2e-3);
        }
    }
}

/// Towards the stretched arm along the normal the mass of the tip has no bound, and both hinges take the whole impulse. A range without
/// that pose has a bound.
#[test]
fn a_bearing_impulse_towards_an_immovable_pose_is_unbounded() {
    let arm = arm(3.0, 2.0);
    let system = System::new(Arc::clone(&arm), &Conditions::new()).expect("a system");
    let contact = contact_of_tip(&arm);
    let joint = |name: &str| arm.find_joint(name).expect("a joint");
    let most = |bearing: &str, lower: f64, upper: f64| {
        let ranges = [
            JointRange { joint: joint("shoulder"), lower: -3.0, upper: 3.0 },
            JointRange { joint: joint("elbow"), lower, upper },
        ];
        let quantity = SearchedQuantity::BearingImpulse { bearing: joint(bearing).into() };
        let start = system.configuration();
        extreme_quantity(&system, &start, (&contact).into(), quantity, &ranges, ExtremeKind::Most, 16)
            .expect("an extreme")
    };
    for bearing in ["shoulder", "elbow"] {
        let stretched = most(bearing, -1.0, 2.0);
        assert_eq!(stretched.effective_mass, EffectiveMass::Immovable, "{stretched:?}");
        let [shoulder, elbow] = stretched.positions[..] else { panic!("{stretched:?}") };
        assert!(elbow.abs() < 1e-3 && (shoulder.sin().abs() - 1.0).abs() < 1e-3, "{stretched:?}");
        assert!(stretched.agreeing > 0);
        let bent = most(bearing, 0.4, 2.0);
        assert!(bent.effective_mass.kilograms().is_some_and(|value| value > 1.0), "{bent:?}");
    }
}

#[test]
fn the_best_constant_armature_of_the_four_bar() {
    let mechanism = four_bar();
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let crank = mechanism.find_joint("crank_hinge").expect("the crank");
    let positions: Vec<f64> = (0..=360).map(|k| std::f64::consts::TAU * f64::from(k) / 360.0).collect();
    let range = reflected_inertia_over(&system, &system.configuration(), crank, &positions).expect("a range");
    let (least, most) = (range.least.expect("finite"), range.most.expect("finite"));
    assert!((least / 0.197_244_7 - 1.0).abs() < 1e-3 && (most / 1.184_969_7 - 1.0).abs() < 1e-3);
    let constant = range.best_constant.expect("finite");
    let worst = range.largest_error.expect("finite");
    assert!((worst - 0.7146).abs() < 1e-3, "{worst}");
    // Both ends have the same relative error, and no other constant has a smaller one.
    assert!((constant / least - 1.0 - worst).abs() < 1e-12 && (1.0 - constant / most - worst).abs() < 1e-12);
    assert_eq!(range.samples.len(), 361);
}

/// Substitutes of a four-bar linkage over ranges: a separately built tree with the same mimic joints has the stated inertias, and no other
/// armature has a smaller error. Over small ranges the error is proportional to the range.
#[test]
fn substitutes_with_mimic_joints_are_their_own_trees() {
    let mechanism = four_bar();
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
    let crank = mechanism.find_joint("crank_hinge").expect("the crank");
    let mut errors = Vec::new();
    for (middle, half) in [(0.4, 0.5), (0.4, 0.05), (0.4, 0.005), (2.0, 0.6), (3.0, 0.1)] {
        let positions: Vec<f64> = (0..=40).map(|k| middle + half * (f64::from(k) / 20.0 - 1.0)).collect();
        let range =
            reflected_inertia_over(&system, &system.configuration(), crank, &positions).expect("a range");
        let found = range.substitute.expect("a substitute");
        // The tree of the model with its joints as mimic joints.
        let none = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
        let mut builder = MechanismBuilder::new("substitute");
        for link in mechanism.links() {
            builder =
                builder.link(LinkDescription::new(link.name(), link.inertial().copied().unwrap_or(none)));
        }
        for id in mechanism.joint_ids() {
            let joint = mechanism.joint(id);
            let [parent, child] = [joint.parent(), joint.child()].map(|link| mechanism.link(link).name());
            let mut own = JointDescription::new(joint.name(), JointKind::Continuous, parent, child);
            (own.origin, own.axis) = (*joint.origin(), *joint.axis());
            own.mimic = found.joints.iter().find(|mimic| mimic.joint == id).map(|mimic| MimicDescription {
                joint: "crank_hinge".into(),
                multiplier: mimic.multiplier,
                offset: mimic.offset,
            });
            builder = builder.joint(own);
        }
        let tree = Arc::new(builder.build().expect("a tree").mechanism);
        let tree = System::new(tree, &Conditions::new()).expect("a system");
        assert_eq!(found.joints.len(), 2);
        let own = reflected_inertia_over(&tree, &tree.configuration(), crank, &positions).expect("a range");
        let mut differences = Vec::new();
        for ((sample, exact), stated) in own.samples.iter().zip(&range.samples).zip(&found.inertias) {
            let value = sample.inertia.held.expect("a driver").kilograms().expect("finite");
            assert!((value / stated - 1.0).abs() < 1e-12, "{value} {stated}");
            let exact = exact.inertia.held.expect("a driver").kilograms().expect("finite");
            differences.push((value, exact));
        }
        let error =
            |a: f64| differences.iter().map(|(tree, all)| ((tree + a) / all - 1.0).abs()).fold(0.0, f64::max);
        assert!((error(found.armature) / found.largest_error - 1.0).abs() < 1e-6, "{found:?}");
        // The crank has no armature, so the additional armature is not negative.
        for other in [-1e-3, -1e-5, 1e-5, 1e-3].map(|step| found.armature + step) {
            assert!(other < 0.0 || error(other) >= found.largest_error * (1.0 - 1e-9), "{other}: {found:?}");
        }
        errors.push(found.largest_error);
    }
    // The second range is ten times the third: the error is about ten times larger.
    assert!(errors[1] / errors[2] > 8.0, "{errors:?}");
    // A tree has no substitute.
    let arm = arm(1.0, 1.0);
    let system = System::new(Arc::clone(&arm), &Conditions::new()).expect("a system");
    let elbow = arm.find_joint("elbow").expect("a joint");
    let range =
        reflected_inertia_over(&system, &system.configuration(), elbow, &[0.1, 0.5]).expect("a range");
    assert_eq!(range.substitute, Err(NoSubstitute::NoDependentJoint));
}
