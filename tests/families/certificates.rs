//! Proved bounds of m̄: they contain the values of percuss, at poses and over ranges, and are refused where m̄ has no bound.

use nalgebra::Vector3;
use percuss_dynamics::{
    Conditions, Contact, Direction, EffectiveMass, Frame, NoCertificate, Pose, RangeProof, System,
};
use percuss_formats::load_file;
use percuss_impact::{ExtremeKind, JointRange, NormalRange, SearchedContact, extreme_effective_mass};
use percuss_mechanism::{JointId, JointKind};
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::f64::consts::TAU;

const PROOF: RangeProof = RangeProof {
    tolerance: 0.05,
    budget: 300,
    mass_tolerance: 0.0,
    only_largest: false,
    cone: [0.0; 2],
    edges: [[0.0; 3]; 2],
    is_disc: false,
    known: 0.0,
};

/// A shipped model with joints set, and a contact along a world normal.
fn shipped(
    file: &str,
    set: &[(&str, f64)],
    link: &str,
    point: [f64; 3],
    normal: [f64; 3],
) -> (System, Pose, Contact) {
    let path = format!("{}/../models/{file}", env!("CARGO_MANIFEST_DIR"));
    let system = System::new(load_file(&path).unwrap().mechanism, &Conditions::new()).unwrap();
    let mut configuration = system.configuration();
    set.iter().for_each(|(joint, q)| {
        configuration.set(joint, &[*q]).unwrap();
    });
    let pose = system.pose(&configuration).unwrap();
    let link = system.mechanism().find_link(link).unwrap();
    let contact = Contact::new(link, point, normal).normal(Direction::Along(normal.into(), Frame::World));
    (system, pose, contact)
}

fn mass(pose: &Pose, contact: &Contact) -> f64 {
    pose.respond(contact).unwrap().effective_mass.kilograms().unwrap()
}

/// Each certificate contains m̄ within its stated error, and is narrow. Immovable and massless contacts have none.
fn check_poses(subjects: &[Subject]) -> (usize, usize) {
    let (mut proved, mut refused) = (0, 0);
    for Subject { name, pose, contact, .. } in subjects {
        let response = pose.respond(contact).unwrap();
        match (pose.certify(contact), response.effective_mass) {
            (Ok(found), EffectiveMass::Finite(m)) => {
                let error = response.effective_mass_error().unwrap_or(f64::INFINITY);
                // Rows that are left out may be violated by rounding; m̄ is then that of nearby numbers.
                let slack = error + 1e-12 * m;
                assert!(found.lower <= m + slack && m - slack <= found.upper, "{name}: {m} {found:?}");
                // The bounds grow with the condition of the mass matrix, as the stated error does.
                assert!(found.upper / found.lower - 1.0 < 1e-5, "{name}: {m} {found:?}");
                proved += 1;
            }
            (Ok(found), other) => panic!("{name}: {other:?}, but {found:?}"),
            (Err(_), _) => refused += 1,
        }
    }
    (proved, refused)
}

#[test]
fn certificates_contain_the_masses_of_trees_and_linkages() {
    let (proved, refused) = check_poses(&of_trees(7, 1, 60));
    // Refused: massless and immovable contacts.
    assert!(proved > 120, "trees: {proved} proved, {refused} refused");
    let (proved, refused) = check_poses(&of_linkages(7, 3));
    // Also refused: held points, locks in loops, change points.
    assert!(proved > 12, "linkages: {proved} proved, {refused} refused");
}

#[test]
fn shipped_linkages_have_sharp_certificates() {
    let wishbone = [("wheel_centre", [0.0; 3], [0.0, 0.0, -1.0])];
    for (file, contacts, implied) in [
        ("double_wishbone.urdf", wishbone, 0),
        ("four_bar.urdf", [("coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0])], 3),
    ] {
        for (link, point, normal) in contacts {
            let (_, pose, contact) = shipped(file, &[], link, point, normal);
            let found = pose.certify(&contact).unwrap();
            let m = mass(&pose, &contact);
            assert!(
                found.lower <= m && m <= found.upper && found.upper / found.lower - 1.0 < 1e-11,
                "{file} {found:?}"
            );
            // A mass that is wrong by 1e-11 is outside.
            assert!(found.upper < m * (1.0 + 1e-11) && m * (1.0 - 1e-11) < found.lower, "{file} {found:?}");
            assert_eq!((found.implied, found.omitted.len()), (implied, 0), "{file}");
            assert!(found.uniqueness.is_some_and(|radius| radius > 0.05), "{file} {found:?}");
        }
    }
}

#[test]
fn change_points_immovable_and_massless_contacts_have_no_certificate() {
    // A normal across the plane of the linkage.
    let (_, pose, contact) = shipped("four_bar.urdf", &[], "coupler", [0.35, 0.1, 0.0], [0.0, 0.0, 1.0]);
    assert_eq!(pose.certify(&contact), Err(NoCertificate::Immovable));
    // All bars on one line.
    let (_, pose, contact) = shipped("parallelogram.urdf", &[], "platform", [0.1, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let flat = pose.certify(&contact);
    assert!(!pose.rank().singular || flat.is_err(), "{flat:?}");
    let (_, pose, contact) =
        shipped("antiparallelogram.urdf", &[], "coupler", [0.1, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let flat = pose.certify(&contact);
    assert!(!pose.rank().singular || flat.is_err(), "{flat:?}");
}

/// Factor of the number of random points: `PERCUSS_ROWS=100000` gives ten thousand for each question of the nightly run.
fn more() -> usize {
    std::env::var("PERCUSS_ROWS")
        .ok()
        .and_then(|rows| rows.parse::<usize>().ok())
        .map_or(1, |rows| 1 + rows / 100)
}

/// Random points and corners of ranges are inside the brackets; the number of checked points.
fn check_range(
    name: &str,
    pose: &Pose,
    contact: &Contact,
    ranges: &[(JointId, f64, f64)],
    system: &System,
    points: usize,
) -> usize {
    let found = pose.certify_extremes(contact, ranges, PROOF).unwrap_or_else(|why| panic!("{name}: {why}"));
    let (least, most) = (found.least.unwrap(), found.most);
    let mut rng = StdRng::seed_from_u64(5);
    let mechanism = system.mechanism();
    for number in 0..points * more() {
        let mut configuration = system.configuration();
        for joint in mechanism.joint_ids().filter(|joint| mechanism.joint(*joint).mimic().is_none()) {
            if pose.loops().is_none() && mechanism.joint(joint).kind().dofs() > 0 {
                configuration.set(mechanism.joint(joint).name(), pose.joint(joint)).unwrap();
            }
        }
        for (k, (joint, lower, upper)) in ranges.iter().enumerate() {
            let part = if number < 16 {
                f64::from(u8::from(number >> k & 1 == 1))
            } else {
                rng.random_range(0.0..1.0)
            };
            configuration.replace(mechanism.joint(*joint).name(), &[lower + part * (upper - lower)]).unwrap();
        }
        let there = system.pose_from(pose, &configuration).unwrap();
        let m = match there.respond(contact).unwrap().effective_mass {
            EffectiveMass::Finite(m) => m,
            EffectiveMass::Immovable => f64::INFINITY,
            EffectiveMass::Massless => 0.0,
        };
        assert!(
            least.lower <= m * (1.0 + 1e-12) && m * (1.0 - 1e-12) <= most.upper,
            "{name}: {m} outside {least:?} {most:?}"
        );
    }
    assert!(least.lower <= least.upper && most.lower <= most.upper, "{name}");
    points
}

#[test]
fn random_points_and_corners_are_inside_the_brackets() {
    let (mut checked, mut sharp) = (0, 0);
    let mut rng = StdRng::seed_from_u64(11);
    for subject in of_trees(3, 1, 10) {
        let mechanism = subject.mechanism();
        let drives = |joint: &JointId| {
            let own = mechanism.joint(*joint);
            own.kind().dofs() == 1 && own.mimic().is_none() && own.kind() != JointKind::Fixed
        };
        let ranges: Vec<_> = mechanism
            .joint_ids()
            .filter(drives)
            .take(3)
            .map(|joint| {
                let (at, half) = (subject.pose.joint(joint)[0], rng.random_range(0.01..0.2));
                (joint, at - half, at + half)
            })
            .collect();
        if ranges.is_empty() || subject.pose.certify(&subject.contact).is_err() {
            continue;
        }
        checked += check_range(&subject.name, &subject.pose, &subject.contact, &ranges, &subject.system, 60);
        sharp += 1;
    }
    assert!(checked > 300 && sharp > 5, "{checked} points of {sharp} trees");
}

#[test]
fn the_travel_of_a_wishbone_is_enclosed_on_one_branch() {
    let (system, pose, contact) =
        shipped("double_wishbone.urdf", &[], "wheel_centre", [0.0; 3], [0.0, 0.0, -1.0]);
    let arm = system.mechanism().find_joint("lower_arm_hinge").unwrap();
    let ranges = [(arm, -0.25, 0.25)];
    let found = pose.certify_extremes(&contact, &ranges, RangeProof { budget: 3_000, ..PROOF }).unwrap();
    assert!(found.branch.is_some_and(|branch| branch.is_one_branch) && found.most.is_proved);
    check_range("wishbone", &pose, &contact, &ranges, &system, 80);
    // Two drivers of the loops.
    let spin = system.mechanism().find_joint("spin").unwrap();
    let both = [(arm, -0.05, 0.05), (spin, -0.1, 0.1)];
    check_range("wishbone with spin", &pose, &contact, &both, &system, 40);
}

#[test]
fn an_arm_has_sharp_brackets_over_three_joints() {
    let set = [("shoulder", -0.6), ("elbow", 1.0), ("wrist_pitch", 0.8)];
    let (system, pose, contact) = shipped("six_r_arm.urdf", &set, "tool", [0.0; 3], [0.0, 0.0, -1.0]);
    let ranges: Vec<_> = set
        .iter()
        .map(|(name, q)| (system.mechanism().find_joint(name).unwrap(), q - 0.15, q + 0.15))
        .collect();
    let found = pose.certify_extremes(&contact, &ranges, RangeProof { budget: 3_000, ..PROOF }).unwrap();
    let least = found.least.clone().unwrap();
    assert!(found.most.is_proved && least.is_proved, "{found:?}");
    check_range("six_r_arm", &pose, &contact, &ranges, &system, 500);
    // All masses within 20 %: the bounds are those of the extreme masses.
    let heavier = pose
        .certify_extremes(&contact, &ranges, RangeProof { mass_tolerance: 0.2, budget: 3_000, ..PROOF })
        .unwrap();
    let lighter = heavier.least.unwrap();
    for (scaled, nominal) in [
        (heavier.most.lower, 1.2 * found.most.lower),
        (heavier.most.upper, 1.2 * found.most.upper),
        (lighter.lower, 0.8 * least.lower),
        (lighter.upper, 0.8 * least.upper),
    ] {
        // The factor and the product are rounded outward.
        assert!((scaled / nominal - 1.0).abs() < 1e-15, "{scaled} {nominal}");
    }
    assert!(heavier.most.is_proved && lighter.is_proved);
}

/// Random positions, normals of a cone and points of a patch are inside the brackets, for normals of the link and of the world.
#[test]
fn cones_of_normals_and_facets_of_points_are_enclosed() {
    let set = [("shoulder", -0.6), ("elbow", 1.0)];
    let (system, pose, contact) =
        shipped("six_r_arm.urdf", &set, "tool", [0.02, 0.0, 0.01], [0.0, 0.0, -1.0]);
    let (shoulder, elbow) =
        (system.mechanism().find_joint("shoulder"), system.mechanism().find_joint("elbow"));
    let ranges = [(shoulder.unwrap(), -0.65, -0.55), (elbow.unwrap(), 0.95, 1.05)];
    let (cone, edges) = (0.15, [[0.03, 0.0, 0.0], [0.0, 0.02, 0.04]]);
    let mut rng = StdRng::seed_from_u64(9);
    for frame in [Frame::World, Frame::Link] {
        let given = Vector3::new(0.1, -0.2, -1.0).normalize();
        let contact = contact.normal(Direction::Along(given, frame));
        let proof = RangeProof { budget: 3_000, cone: [0.0, cone], edges, ..PROOF };
        let found = pose.certify_extremes(&contact, &ranges, proof).unwrap();
        let (least, most) = (found.least.unwrap(), found.most);
        assert!(least.lower > 0.0 && most.upper.is_finite() && found.tree.is_some(), "{frame:?} {most:?}");
        assert_eq!(most.positions.len(), 6);
        let (e1, e2) = percuss_spatial::plane_basis(&given);
        let (mut smallest, mut largest) = (f64::INFINITY, 0.0_f64);
        for number in 0..2_000 * more() {
            let mut part =
                || if number < 64 { f64::from(u8::from(rng.random_bool(0.5))) } else { rng.random() };
            let mut configuration = system.configuration();
            for (joint, lower, upper) in ranges {
                let q = lower + (upper - lower) * part();
                configuration.set(system.mechanism().joint(joint).name(), &[q]).unwrap();
            }
            let (s, t, psi, theta) = (part(), part(), TAU * part(), cone * part());
            let point = contact.point + Vector3::from(edges[0]) * s + Vector3::from(edges[1]) * t;
            let normal = given * theta.cos() + (e1 * psi.cos() + e2 * psi.sin()) * theta.sin();
            let moved = Contact { point, ..contact.normal(Direction::Along(normal, frame)) };
            let m = mass(&system.pose(&configuration).unwrap(), &moved);
            assert!(
                least.lower <= m && m <= most.upper,
                "{frame:?} {m} outside {} {}",
                least.lower,
                most.upper
            );
            (smallest, largest) = (smallest.min(m), largest.max(m));
        }
        // The inner bounds are values: no random one is much further out.
        assert!(
            least.upper <= 1.01 * smallest && most.lower >= 0.99 * largest,
            "{frame:?} {smallest} {largest} {most:?}"
        );
        // The search finds extremes inside the brackets, with these normals and points.
        let edges = edges.map(Vector3::from);
        let searched =
            SearchedContact { normals: NormalRange::Cone(cone), edges: &edges, ..(&contact).into() };
        let joints = ranges.map(|(joint, lower, upper)| JointRange { joint, lower, upper });
        for (kind, bracket) in [(ExtremeKind::Least, &least), (ExtremeKind::Most, &most)] {
            let configuration = system.configuration();
            let found =
                extreme_effective_mass(&system, &configuration, searched, &joints[..], kind, 8).unwrap();
            let m = found.effective_mass.kilograms().unwrap();
            assert!(
                bracket.lower * (1.0 - 1e-9) <= m && m <= bracket.upper * (1.0 + 1e-9),
                "{frame:?} {m} {bracket:?}"
            );
            assert!(found.point_link.is_some() && found.normal_world.is_some());
            let outside = if kind == ExtremeKind::Least { m > smallest } else { m < largest };
            assert!(!outside, "{frame:?} {kind:?} {m} {smallest} {largest}");
        }
    }
    // Against a body, along a line, and on loops there is no proof.
    let (_, pose, contact) = shipped("four_bar.urdf", &[], "coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
    let crank = pose.mechanism().find_joint("crank_hinge").unwrap();
    let refused =
        pose.certify_extremes(&contact, &[(crank, 0.1, 0.2)], RangeProof { cone: [0.0, cone], ..PROOF });
    assert_eq!(refused.unwrap_err(), NoCertificate::VariedContact);
}

/// A rod on a hinge, J = 1/3 kg·m²: m̄ = J/(r cos θ)² at the distance r, along a normal at the angle θ from the tangent in the plane.
#[test]
fn a_rod_has_its_closed_form_over_points_and_normals() {
    let text = "<robot name='rod'><link name='ground'/><link name='rod'><inertial><origin xyz='0.5 0 0'/><mass value='1'/>\
                <inertia ixx='0.01' iyy='0.08333333333333333' izz='0.08333333333333333' ixy='0' ixz='0' iyz='0'/></inertial></link>\
                <joint name='hinge' type='continuous'><parent link='ground'/><child link='rod'/><axis xyz='0 0 1'/></joint></robot>";
    let source = percuss_formats::Source::from_text("rod.urdf", text);
    let system = System::new(
        percuss_formats::load(&source, &Default::default()).unwrap().mechanism,
        &Conditions::new(),
    )
    .unwrap();
    let rod = system.mechanism().find_link("rod").unwrap();
    let hinge = system.mechanism().find_joint("hinge").unwrap();
    let contact = Contact::new(rod, [0.5, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let pose = system.pose(&system.configuration()).unwrap();
    let (cone, edge) = (0.4_f64, [0.3, 0.0, 0.0]);
    let proof =
        RangeProof { tolerance: 1e-3, budget: 20_000, cone: [0.0, cone], edges: [edge, [0.0; 3]], ..PROOF };
    let found = pose.certify_extremes(&contact, &[(hinge, -1.0, 1.0)], proof).unwrap();
    let expected = [1.0 / 3.0 / 0.8_f64.powi(2), 1.0 / 3.0 / (0.5 * cone.cos()).powi(2)];
    let edges = [Vector3::from(edge)];
    let searched = SearchedContact { normals: NormalRange::Cone(cone), edges: &edges, ..(&contact).into() };
    let range = [JointRange { joint: hinge, lower: -1.0, upper: 1.0 }];
    for (m, bracket, kind) in [
        (expected[0], found.least.unwrap(), ExtremeKind::Least),
        (expected[1], found.most, ExtremeKind::Most),
    ] {
        assert!(
            bracket.is_proved && bracket.lower <= m * (1.0 + 1e-12) && m * (1.0 - 1e-12) <= bracket.upper,
            "{m} {bracket:?}"
        );
        let found =
            extreme_effective_mass(&system, &system.configuration(), searched, &range[..], kind, 4).unwrap();
        assert!((found.effective_mass.kilograms().unwrap() / m - 1.0).abs() < 1e-12, "{found:?} {m}");
    }
}

/// The pose is at the middle of a range, which is the common face of the first two boxes.
#[test]
fn ranges_around_every_pose_are_proved() {
    for x in [0.1, 0.12, 0.2505, 0.3, 2.2] {
        let set = [("crank_hinge", x)];
        let (system, pose, contact) =
            shipped("four_bar.urdf", &set, "coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
        let crank = system.mechanism().find_joint("crank_hinge").unwrap();
        let found = pose.certify_extremes(&contact, &[(crank, x - 0.01, x + 0.01)], PROOF).unwrap();
        let within = found.most.lower..=found.most.upper;
        assert!(found.most.is_proved && found.least.is_some_and(|least| least.is_proved), "{x}: {within:?}");
    }
}

/// System of a URDF text, with its pose at zero.
fn of_text(text: &str) -> (System, Pose) {
    let source = percuss_formats::Source::from_text("text.urdf", text);
    let loaded = percuss_formats::load(&source, &Default::default()).unwrap();
    let system = System::new(loaded.mechanism, &Conditions::new()).unwrap();
    let pose = system.pose(&system.configuration()).unwrap();
    (system, pose)
}

/// Implied and omitted rows of a linkage whose coupler has the closed form of models/four_bar.urdf in its plane; `None` without a proof.
fn rows_of_four_bar(text: &str) -> Option<(usize, usize)> {
    let (system, pose) = of_text(text);
    let coupler = system.mechanism().find_link("coupler").unwrap();
    let contact = Contact::new(coupler, [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
    let found = pose.certify(&contact).ok()?;
    let m = 417304.0 / 6125.0;
    assert!(found.lower <= m && m <= found.upper && found.upper / found.lower - 1.0 < 1e-10, "{found:?}");
    assert_eq!(found.rows, 5);
    Some((found.implied, found.omitted.len()))
}

/// The axes of a planar loop are proved parallel on a tilted frame and with parts at different heights; a height that is wrong by 1e-12 m is
/// no planar loop.
#[test]
fn planar_loops_are_proved_on_tilted_frames_and_at_different_heights() {
    let text = std::fs::read_to_string(format!("{}/../models/four_bar.urdf", env!("CARGO_MANIFEST_DIR")));
    let drawn = text.unwrap();
    let tilted = drawn
        .replace("<link name=\"ground\"/>", "<link name=\"ground\"/><link name=\"table\"/><joint name=\"tilt\" type=\"fixed\"><parent link=\"ground\"/><child link=\"table\"/><origin xyz=\"0.1 0.2 0.3\" rpy=\"0.3 0.2 0.1\"/></joint>")
        .replace("<parent link=\"ground\"/>\n", "<parent link=\"table\"/>\n");
    let raised = |rocker: &str| {
        tilted
            .replace("<child link=\"crank\"/>", "<child link=\"crank\"/><origin xyz=\"0 0 0.1\"/>")
            .replace("xyz=\"0 0.3 0\"/>", "xyz=\"0 0.3 0.07\"/>")
            .replace("xyz=\"0.65 0 0\"", &format!("xyz=\"0.65 0 {rocker}\""))
            .replace("xyz=\"-0.25 0.6 0\"", "xyz=\"-0.25 0.6 0.07\"")
    };
    assert_ne!(raised("0.1"), tilted);
    for text in [&drawn, &tilted, &raised("0.1")] {
        assert_eq!(rows_of_four_bar(text), Some((3, 0)));
    }
    // The parallel axes are still proved.
    assert_eq!(rows_of_four_bar(&raised("0.100000000001")), Some((2, 1)));
    // A tilt of one axis.
    let skew = tilted.replace(
        "<axis xyz=\"0 0 1\"/>\n  </joint>\n  <joint name=\"rocker_hinge\"",
        "<axis xyz=\"0 1e-12 1\"/>\n  </joint>\n  <joint name=\"rocker_hinge\"",
    );
    assert_ne!(skew, tilted);
    assert_eq!(rows_of_four_bar(&skew), Some((0, 3)));
}

/// Four hinges with axes through one point: the origins of the closure coincide at all positions. m̄ is that of percuss.
#[test]
fn spherical_loops_are_proved() {
    let rotation = |rpy: [f64; 3]| percuss_spatial::rotation_from_rpy(rpy);
    let words = |rpy: [f64; 3]| rpy.map(|x| x.to_string()).join(" ");
    let mut rng = StdRng::seed_from_u64(57);
    for number in 0..20 {
        let mut turn = || [0, 1, 2].map(|_| rng.random_range(-1.0..1.0_f64));
        let [crank, coupler, rocker, pin] = [turn(), turn(), turn(), turn()];
        // X of the loop frame in the rocker, closed as drawn.
        let other = rotation(rocker).transpose() * rotation(crank) * rotation(coupler) * rotation(pin);
        let other = percuss_spatial::rpy_from_rotation(&other);
        let centre = if number % 2 == 0 { "0 0 0" } else { "0.3 0.1 -0.2" };
        // A loop frame beside the centre, on the axis, is one without a proof.
        let beside = if number % 5 == 4 { 0.1 } else { 0.0 };
        let point = |rpy: [f64; 3]| words((rotation(rpy) * Vector3::z() * beside).into());
        let inertial = "<inertial><origin xyz='0.1 0.2 0.3'/><mass value='2'/><inertia ixx='0.1' iyy='0.12' izz='0.15' ixy='0' ixz='0' iyz='0'/></inertial>";
        let joint = |name: &str, parent: &str, xyz: &str, rpy: [f64; 3]| {
            format!(
                "<link name='{name}'>{inertial}</link><joint name='to_{name}' type='continuous'><parent link='{parent}'/><child link='{name}'/>\
                 <origin xyz='{xyz}' rpy='{}'/><axis xyz='0 0 1'/></joint>",
                words(rpy)
            )
        };
        let text = format!(
            "<robot name='spherical'><link name='ground'/>{}{}{}<loop name='pin' type='revolute'><predecessor link='coupler'>\
             <origin xyz='{}' rpy='{}'/></predecessor><successor link='rocker'><origin xyz='{}' rpy='{}'/></successor>\
             <axis xyz='0 0 1'/></loop></robot>",
            joint("crank", "ground", centre, crank),
            joint("coupler", "crank", "0 0 0", coupler),
            joint("rocker", "ground", centre, rocker),
            point(pin),
            words(pin),
            point(other),
            words(other),
        );
        let (system, pose) = of_text(&text);
        let contact =
            Contact::new(system.mechanism().find_link("coupler").unwrap(), [0.3, 0.2, 0.1], [0.0, 1.0, 0.0]);
        let m = mass(&pose, &contact);
        let found = pose.certify(&contact).unwrap();
        assert!(
            found.lower <= m * (1.0 + 1e-12) && m * (1.0 - 1e-12) <= found.upper,
            "{number}: {m} {found:?}"
        );
        let is_proved = beside == 0.0;
        assert_eq!((found.implied == 3, found.omitted.is_empty()), (is_proved, is_proved), "{number}");
    }
}

/// Axes that are a coordinate axis up to 1e-12, of the length 1 in double precision: two hinges about such an axis through the origin, and a
/// ball beside it, are no spherical loop; the normals of a prismatic closure are no coordinate axes. With the axis itself, both are proved.
#[test]
fn axes_that_are_nearly_coordinate_axes_are_not_proved() {
    let link = |name: &str, axis: &str| {
        format!(
            "<link name='{name}'><inertial><origin xyz='0.1 0.2 0.3'/><mass value='2'/>\
             <inertia ixx='0.1' iyy='0.12' izz='0.15' ixy='0' ixz='0' iyz='0'/></inertial></link>\
             <joint name='to_{name}' type='continuous'><parent link='ground'/><child link='{name}'/><axis xyz='{axis}'/></joint>"
        )
    };
    let implied = |axis: &str, closure: &str| {
        let text = format!(
            "<robot name='nearly'><link name='ground'/>{}{}{closure}</robot>",
            link("one", axis),
            link("two", axis)
        );
        let (system, pose) = of_text(&text);
        let one = system.mechanism().find_link("one").unwrap();
        pose.certify(&Contact::new(one, [0.3, 0.2, 0.1], [1.0, 0.5, 0.0])).unwrap().implied
    };
    let ball = |at: &str| {
        format!(
            "<loop name='ball' type='spherical'><predecessor link='one'><origin xyz='{at}'/></predecessor>\
             <successor link='two'><origin xyz='{at}'/></successor></loop>"
        )
    };
    assert_eq!(implied("0 0 1", &ball("0 0 0.2")), 3);
    for axis in ["0 1e-12 1", "1e-12 0 1", "-1e-9 1e-9 1"] {
        assert_eq!(implied(axis, &ball("0 0 0.2")), 0, "{axis}");
        assert_eq!(implied(axis, &ball("0 0.2 0")), 0, "{axis}");
    }
    // Heights along x of a loop about x: the row of the normal (0, −1e-9, 1) also contains y.
    let slide = |axis: &str| {
        format!(
            "<loop name='slide' type='prismatic'><predecessor link='one'><origin xyz='0 0.2 0'/></predecessor>\
             <successor link='two'><origin xyz='0 0.2 0'/></successor><axis xyz='{axis}'/></loop>"
        )
    };
    let exact = implied("0 0 1", &slide("0 1 0"));
    assert!(exact > 0);
    assert!(implied("0 0 1", &slide("0 1 1e-9")) < exact);
}
