//! Import of hardpoint files: links and joints, positions, masses, refusals.

mod figures;
mod headers;
mod implausible;
mod keys;
mod mechanics;
mod models;
mod names;
mod refusals;
mod sheet_refusals;
mod sheets;
mod units;
mod write_back;

use mechanics::{place, poses, residuals, respond};
use models::{all, changed, double_wishbone, file, hmmwv};
use nalgebra::{Matrix3, Rotation3, Vector3};
use percuss_formats::{LoadError, LoadOptions, Source, load, write_urdf_with};
use percuss_mechanism::{Joint, JointKind, Link, Mechanism, Severity};
use percuss_suspension::{ImportOptions, Imported, Rack, Side, Wheel, import};

const WHEEL: Wheel = Wheel { mass: 20.0, inertia: [0.5, 0.9, 0.5], radius: Some(0.3) };

fn import_text(text: &str, options: &ImportOptions) -> Result<Imported, LoadError> {
    import(&Source::from_text("corner.json", text), options)
}

fn imported(template: &str, keys: &[(&str, &str)], options: &ImportOptions) -> Imported {
    import_text(&file(template, keys), options).unwrap_or_else(|e| panic!("{template}: {e}"))
}

fn on(side: Side) -> ImportOptions {
    ImportOptions { side: Some(side), ..ImportOptions::default() }
}

fn link<'m>(mechanism: &'m Mechanism, name: &str) -> &'m Link {
    mechanism.link(mechanism.find_link(name).unwrap())
}

fn joint<'m>(mechanism: &'m Mechanism, name: &str) -> &'m Joint {
    mechanism.joint(mechanism.find_joint(name).unwrap())
}

/// S = diag(1, −1, 1).
fn mirror() -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0))
}

#[test]
fn each_template_has_its_links_joints_loops_and_mass() {
    // Template, links, joints, closures, kg, parent link of the spindle.
    let expected = [
        ("DoubleWishbone", 11, 10, 2, 11.0, "upright"),
        ("DoubleWishboneReduced", 7, 6, 5, 5.0, "upright"),
        ("MacPhersonStrut", 12, 11, 2, 12.0, "upright"),
        ("SemiTrailingArm", 8, 7, 0, 7.0, "trailing_arm"),
        ("ThreeLinkIRS", 12, 11, 2, 9.25, "trailing_arm"),
        ("MultiLink", 14, 13, 3, 15.0, "upright"),
    ];
    for ((template, keys), (name, links, joints, closures, mass, parent)) in all().into_iter().zip(expected) {
        assert_eq!(template, name);
        let left = imported(template, &keys, &on(Side::Left)).mechanism;
        let counts = (left.links().len(), left.joints().len(), left.closures().len());
        assert_eq!(counts, (links, joints, closures), "{template}");
        assert!((left.total_mass() - mass).abs() < 1e-12, "{template}: {}", left.total_mass());
        assert_eq!(left.link(left.root()).name(), "chassis");
        let spin = joint(&left, "spin");
        assert_eq!((left.link(spin.parent()).name(), spin.kind()), (parent, JointKind::Continuous));
        let both = imported(template, &keys, &on(Side::Both)).mechanism;
        // One chassis, and one rack if the template has tie rods.
        let shared = 1 + usize::from(left.find_link("rack").is_ok());
        assert_eq!(both.links().len(), 2 * links - shared, "{template}");
        assert_eq!(both.joints().len(), 2 * joints - (shared - 1), "{template}");
        assert_eq!(both.closures().len(), 2 * closures, "{template}");
        assert!((both.total_mass() - 2.0 * mass).abs() < 1e-12, "{template}");
    }
}

#[test]
fn loops_close_at_the_design_position_on_every_side() {
    for (template, keys) in all() {
        let angles = [("Camber Angle (deg)", "1.5"), ("Toe Angle (deg)", "-0.7")];
        for keys in [keys.clone(), changed(&keys, &angles)] {
            for side in [Side::Left, Side::Right, Side::Both] {
                let mechanism = imported(template, &keys, &on(side)).mechanism;
                // A few roundings of coordinates below 1 m.
                assert!(residuals(&mechanism).iter().all(|r| *r < 1e-15), "{template} {side:?}");
            }
        }
    }
}

#[test]
fn links_stand_where_the_file_says() {
    type Places = &'static [(&'static str, [f64; 3])];
    let expected: [(&str, Places); 6] = [
        (
            "DoubleWishbone",
            &[
                ("lower_arm", [0.2, 0.35, -0.1]),
                ("upper_arm", [0.1, 0.45, 0.2]),
                ("upright", [0.01, 0.82, -0.16]),
            ],
        ),
        ("DoubleWishboneReduced", &[("upright", [0.01, 0.82, -0.16]), ("rack", [-0.2, 0.0, 0.02])]),
        ("MacPhersonStrut", &[("control_arm", [0.2, 0.35, -0.1]), ("strut", [0.05, 0.55, 0.35])]),
        ("SemiTrailingArm", &[("trailing_arm", [0.5, 0.85, 0.02]), ("spring_seat", [0.06, 0.62, -0.1])]),
        ("ThreeLinkIRS", &[("trailing_arm", [0.7, 0.8, 0.03]), ("lower_link", [-0.02, 0.2, 0.05])]),
        ("MultiLink", &[("lateral", [0.03, 0.35, -0.12]), ("trailing_link", [0.7, 0.6, -0.07])]),
    ];
    for ((template, keys), (_, links)) in all().into_iter().zip(expected) {
        let mechanism = imported(template, &keys, &on(Side::Left)).mechanism;
        let common: [(&str, [f64; 3]); 4] = [
            ("spindle", [0.0, 0.9, -0.02]),
            ("wheel_centre", [0.0, 0.9, -0.02]),
            ("shock_seat", [0.05, 0.65, -0.1]),
            ("shock_chassis_seat", [0.03, 0.53, 0.4]),
        ];
        for (name, at) in links.iter().chain(&common) {
            let off = (place(&mechanism, name) - Vector3::from(*at)).amax();
            assert!(off < 1e-15, "{template}: {name} is off by {off}");
        }
        // Chassis seats are fixed to the chassis, other seats are not.
        for (seat, still) in [("shock_chassis_seat", true), ("shock_seat", false)] {
            let parent = mechanism.parent_joint(mechanism.find_link(seat).unwrap()).unwrap();
            assert_eq!(mechanism.joint(parent).parent() == mechanism.root(), still, "{template}: {seat}");
        }
    }
}

#[test]
fn springs_and_shocks_stand_on_the_links_of_the_template() {
    let parents = ["lower_arm", "upright", "upright", "trailing_arm", "trailing_arm", "trailing_link"];
    for ((template, keys), expected) in all().into_iter().zip(parents) {
        let mechanism = imported(template, &keys, &on(Side::Left)).mechanism;
        for seat in ["spring_seat", "shock_seat"] {
            let Ok(seat) = mechanism.find_link(seat) else {
                assert_eq!((template, seat), ("DoubleWishboneReduced", "spring_seat"));
                continue;
            };
            let parent = mechanism.joint(mechanism.parent_joint(seat).unwrap()).parent();
            assert_eq!(mechanism.link(parent).name(), expected, "{template}");
        }
    }
}

#[test]
fn the_right_side_is_the_mirror_image_of_the_left() {
    let angles = [("Camber Angle (deg)", "1.5"), ("Toe Angle (deg)", "-0.7")];
    let options = |side| ImportOptions { side: Some(side), wheel: Some(WHEEL), ..ImportOptions::default() };
    for (template, keys) in all() {
        let keys = changed(&keys, &angles);
        let left = imported(template, &keys, &options(Side::Left)).mechanism;
        let right = imported(template, &keys, &options(Side::Right)).mechanism;
        let both = imported(template, &keys, &options(Side::Both)).mechanism;
        for (a, b) in left.links().iter().zip(right.links()) {
            assert_eq!(a.name(), b.name());
            assert_eq!(
                mirror() * place(&left, a.name()),
                place(&right, b.name()),
                "{template}: {}",
                a.name()
            );
            let (Some(i), Some(k)) = (a.inertial(), b.inertial()) else {
                assert_eq!(a.inertial(), b.inertial());
                continue;
            };
            assert_eq!((i.mass, mirror() * i.com), (k.mass, k.com), "{template}: {}", a.name());
            assert_eq!(mirror() * i.about_com * mirror(), k.about_com, "{template}: {}", a.name());
        }
        for (a, b) in left.joints().iter().zip(right.joints()).filter(|(a, _)| a.kind().has_axis()) {
            // A rotation axis is mirrored with the opposite sign.
            let off = (mirror() * a.axis() + b.axis()).amax();
            assert!(off < 1e-15, "{template}: {} is off by {off}", a.name());
        }
        // The two sides of one chassis equal separate sides; their effective masses agree.
        let seat = |m: &Mechanism, suffix: &str| {
            let [seat, top] = ["shock_seat", "shock_chassis_seat"].map(|n| format!("{n}{suffix}"));
            let line = (place(m, &top) - place(m, &seat)).normalize();
            respond(m, &seat, line, &[]).mass
        };
        let expected = seat(&left, "");
        for (mass, which) in
            [(seat(&right, ""), "right"), (seat(&both, "_left"), "both"), (seat(&both, "_right"), "both")]
        {
            assert!((mass / expected - 1.0).abs() < 1e-11, "{template}, {which}: {mass} and {expected}");
        }
    }
}

#[test]
fn every_template_can_travel_and_spin_and_no_more() {
    for (template, keys) in all() {
        let mechanism = imported(template, &keys, &on(Side::Left)).mechanism;
        let free = respond(&mechanism, "wheel_centre", Vector3::z(), &[]);
        assert_eq!(free.mobility, 2, "{template}");
        // A tie rod with mass does not add mobility.
        if !["DoubleWishboneReduced", "SemiTrailingArm", "ThreeLinkIRS"].contains(&template) {
            let keys = changed(&keys, &models::HEAVY_TIE_ROD);
            let heavy = imported(template, &keys, &on(Side::Left)).mechanism;
            let found = respond(&heavy, "wheel_centre", Vector3::z(), &[]);
            assert_eq!(
                (found.mobility, heavy.closures().len()),
                (2, mechanism.closures().len()),
                "{template}"
            );
            assert!(found.mass > free.mass && found.mass < free.mass + 0.75, "{template}");
            assert!((heavy.total_mass() - mechanism.total_mass() - 0.75).abs() < 1e-12);
            assert!(residuals(&heavy).iter().all(|r| *r < 1e-15));
        }
    }
}

#[test]
fn inertias_are_turned_out_of_the_axes_they_are_stated_in() {
    let mechanism = imported("DoubleWishbone", &double_wishbone(), &on(Side::Left)).mechanism;
    let arm = link(&mechanism, "lower_arm").inertial().unwrap().about_com;
    // Reference axes of the arm's plane: x from the back hinge point to the front one, z normal to the plane, upward.
    let [front, back, ball] =
        [[0.2, 0.35, -0.1], [-0.25, 0.33, -0.08], [0.01, 0.82, -0.16]].map(Vector3::from);
    let x = (front - back).normalize();
    let z = (back - ball).cross(&(front - ball)).normalize();
    assert!(z.z > 0.9);
    let y = z.cross(&x);
    for (entry, value) in [(x.dot(&(arm * x)), 0.12), (y.dot(&(arm * y)), 0.13), (z.dot(&(arm * z)), 0.2)] {
        assert!((entry - value).abs() < 1e-15);
    }
    for (entry, value) in [(x.dot(&(arm * y)), 0.01), (x.dot(&(arm * z)), -0.005), (y.dot(&(arm * z)), 0.002)]
    {
        assert!((entry - value).abs() < 1e-15);
    }
    let upright = link(&mechanism, "upright").inertial().unwrap().about_com;
    assert_eq!(upright, Matrix3::new(0.05, 0.001, -0.002, 0.001, 0.04, 0.003, -0.002, 0.003, 0.03));
    // With the flag, the inertia of the arm is in the vehicle's axes too.
    let keys = changed(&double_wishbone(), &[("Vehicle-Frame Inertia", "true")]);
    let mechanism = imported("DoubleWishbone", &keys, &on(Side::Left)).mechanism;
    let arm = link(&mechanism, "lower_arm").inertial().unwrap().about_com;
    assert_eq!(arm, Matrix3::new(0.12, 0.01, -0.005, 0.01, 0.13, 0.002, -0.005, 0.002, 0.2));
}

#[test]
fn pins_of_universal_joints_stay_with_the_bodies_that_chrono_gives_them() {
    let pins = |template: &str, keys: &[(&str, &str)], name: &str| {
        let mechanism = imported(template, keys, &on(Side::Left)).mechanism;
        ["first", "second"].map(|which| *joint(&mechanism, &format!("{name}_{which}_pin")).axis())
    };
    let close = |[a, b]: [Vector3<f64>; 2], [c, d]: [Vector3<f64>; 2]| {
        (a - c.normalize()).amax() < 1e-15 && (b - d.normalize()).amax() < 1e-15
    };
    let v = |x, y, z| Vector3::new(x, y, z);
    // The pin in the file is fixed in the link; the chassis pin is the vertical direction made normal to it.
    let keys = models::three_link_irs();
    assert!(close(pins("ThreeLinkIRS", &keys, "upper_link"), [Vector3::z(), v(2.0, 0.1, 0.0)]));
    // Chrono's first body is the link and gets the axis of the key "... Chassis".
    let keys = models::multi_link();
    assert!(close(pins("MultiLink", &keys, "trailing_link"), [Vector3::z(), v(-0.3, 1.0, 0.0)]));
    // y is normal to the plane of the spring axis and the arm's back hinge point; z is along the spring axis.
    let (top, bottom, back) = (v(0.05, 0.55, 0.35), v(0.06, 0.62, -0.1), v(-0.25, 0.33, -0.08));
    let y = (bottom - back).cross(&(top - back));
    let keys = models::macpherson_strut();
    assert!(close(pins("MacPhersonStrut", &keys, "strut"), [y.cross(&(top - bottom)), y]));
    // z along the rod, y = z × x of the vehicle.
    let rod = v(-0.15, 0.8, -0.03) - v(-0.2, 0.4, 0.02);
    let y = rod.cross(&Vector3::x());
    let keys = changed(&double_wishbone(), &models::HEAVY_TIE_ROD);
    assert!(close(pins("DoubleWishbone", &keys, "tie_rod"), [y.cross(&rod), y]));
}

#[test]
fn rods_have_their_axes_along_them() {
    // Link, start, end, and the given moment about the axis of the link.
    type Case = (&'static str, &'static str, [f64; 3], [f64; 3], f64);
    let cases: [Case; 5] = [
        ("ThreeLinkIRS", "trailing_arm", [0.7, 0.8, 0.03], [0.0, 0.85, 0.0], 0.06),
        ("ThreeLinkIRS", "upper_link", [-0.06, 0.25, 0.28], [-0.05, 0.8, 0.12], 0.002),
        ("MultiLink", "lateral", [0.03, 0.35, -0.12], [0.02, 0.8, -0.1], 0.001),
        ("MultiLink", "trailing_link", [0.7, 0.6, -0.07], [0.0, 0.83, -0.15], 0.21),
        ("MultiLink", "tie_rod", [-0.2, 0.4, 0.02], [-0.15, 0.8, -0.03], 0.001),
    ];
    let files = all();
    for (template, name, from, to, moment) in cases {
        let keys = &files.iter().find(|f| f.0 == template).unwrap().1;
        let keys = if name == "tie_rod" { changed(keys, &models::HEAVY_TIE_ROD) } else { keys.clone() };
        let mechanism = imported(template, &keys, &on(Side::Left)).mechanism;
        let inertia = link(&mechanism, name).inertial().unwrap().about_com;
        let line = (Vector3::from(to) - Vector3::from(from)).normalize();
        assert!((line.dot(&(inertia * line)) - moment).abs() < 1e-15, "{name}");
    }
    // For a multi-link, y is normal to a plane through a third point: the foot of the trailing link, or the spring
    // seat.
    let mechanism = imported("MultiLink", &models::multi_link(), &on(Side::Left)).mechanism;
    let (foot, seat) = ([0.0, 0.83, -0.15], [0.06, 0.62, -0.1]);
    for (name, ends, third, moment) in [
        ("lateral", [[0.02, 0.8, -0.1], [0.03, 0.35, -0.12]], foot, 0.041),
        ("trailing_link", [foot, [0.7, 0.6, -0.07]], seat, 0.2),
    ] {
        let [a, b] = ends.map(|end| Vector3::from(end) - Vector3::from(third));
        let y = a.cross(&b).normalize();
        let inertia = link(&mechanism, name).inertial().unwrap().about_com;
        assert!((y.dot(&(inertia * y)) - moment).abs() < 1e-15, "{name}");
    }
    // For a three-link, the horizontal axis of the rod is y.
    let mechanism = imported("ThreeLinkIRS", &models::three_link_irs(), &on(Side::Left)).mechanism;
    let inertia = link(&mechanism, "trailing_arm").inertial().unwrap().about_com;
    let level = Vector3::z().cross(&Vector3::new(0.7, -0.05, 0.03)).normalize();
    assert!((level.dot(&(inertia * level)) - 0.05).abs() < 1e-15);
}

#[test]
fn toe_and_camber_turn_the_spindle_and_the_axle_adds_to_its_axis() {
    let keys = changed(
        &double_wishbone(),
        &[("Camber Angle (deg)", "2"), ("Toe Angle (deg)", "3"), ("Axle/Inertia", "0.25")],
    );
    for (side, sign) in [(Side::Left, -1.0), (Side::Right, 1.0)] {
        let mechanism = imported("DoubleWishbone", &keys, &on(side)).mechanism;
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), sign * 3f64.to_radians())
            * Rotation3::from_axis_angle(&Vector3::x_axis(), sign * 2f64.to_radians());
        let axis = turn * Vector3::y();
        assert!((joint(&mechanism, "spin").axis() - axis).amax() < 1e-15, "{side:?}");
        let stated = Matrix3::from_diagonal(&Vector3::new(0.02, 0.03 + 0.25, 0.025));
        let expected = turn.matrix() * stated * turn.matrix().transpose();
        let inertia = link(&mechanism, "spindle").inertial().unwrap().about_com;
        assert!((inertia - expected).amax() < 1e-15, "{side:?}");
    }
}

#[test]
fn a_wheel_adds_its_mass_and_its_lowest_point() {
    let options = ImportOptions { wheel: Some(WHEEL), ..ImportOptions::default() };
    let keys = changed(&double_wishbone(), &[("Camber Angle (deg)", "2")]);
    let with = imported("DoubleWishbone", &keys, &options);
    assert!(with.diagnostics.iter().all(|d| d.code != "no-wheel"));
    let without = imported("DoubleWishbone", &keys, &on(Side::Left));
    assert!(without.diagnostics.iter().any(|d| d.code == "no-wheel" && d.severity == Severity::Warning));
    assert!((with.mechanism.total_mass() - without.mechanism.total_mass() - 20.0).abs() < 1e-12);
    let down = place(&with.mechanism, "contact_patch") - place(&with.mechanism, "wheel_centre");
    let axis = *joint(&with.mechanism, "spin").axis();
    assert!((down.norm() - 0.3).abs() < 1e-15 && down.dot(&axis).abs() < 1e-16 && down.z < -0.299);
    assert!(without.mechanism.find_link("contact_patch").is_err());
}

#[test]
fn the_rack_is_fixed_unless_it_slides() {
    for (template, keys) in all() {
        let options = ImportOptions { rack: Some(Rack::Sliding { mass: 2.0 }), ..ImportOptions::default() };
        let sliding = imported(template, &keys, &options);
        if ["SemiTrailingArm", "ThreeLinkIRS"].contains(&template) {
            assert!(sliding.diagnostics.iter().any(|d| d.code == "no-rack"), "{template}");
            assert!(sliding.mechanism.find_link("rack").is_err());
            continue;
        }
        let fixed = imported(template, &keys, &on(Side::Left)).mechanism;
        assert_eq!(joint(&fixed, "rack").kind(), JointKind::Fixed);
        let rack = joint(&sliding.mechanism, "rack");
        assert_eq!((rack.kind(), rack.axis()), (JointKind::Prismatic, &Vector3::y()));
        assert_eq!(rack.independent(), Some(true), "a travel of the wheel does not move the rack");
        let free = respond(&sliding.mechanism, "shock_seat", Vector3::z(), &[]);
        let locked = respond(&sliding.mechanism, "shock_seat", Vector3::z(), &["rack"]);
        let never = respond(&fixed, "shock_seat", Vector3::z(), &[]);
        assert_eq!((free.mobility, locked.mobility), (3, 2), "{template}");
        assert!(free.mass < locked.mass && (locked.mass / never.mass - 1.0).abs() < 1e-12, "{template}");
    }
}

#[test]
fn every_part_is_explained_and_survives_being_written() {
    for (template, keys) in all() {
        let imported = imported(template, &keys, &on(Side::Both));
        let (mechanism, comments) = (&imported.mechanism, &imported.comments);
        assert!(comments.heading[0].contains(template));
        assert!(mechanism.links().iter().all(|l| !comments.links[l.name()].is_empty()), "{template}");
        assert!(mechanism.closures().iter().all(|c| !comments.closures[c.name()].is_empty()), "{template}");
        let moving = mechanism.joints().iter().filter(|j| j.kind() != JointKind::Fixed);
        assert!(moving.into_iter().all(|j| !comments.joints[j.name()].is_empty()), "{template}");
        let text = write_urdf_with(mechanism, comments);
        let back = load(&Source::from_text("back.urdf", text), &LoadOptions::default()).unwrap().mechanism;
        let mass = |m: &Mechanism| respond(m, "shock_seat_left", Vector3::z(), &[]).mass;
        assert!((mass(&back) / mass(mechanism) - 1.0).abs() < 1e-12, "{template}");
        assert_eq!(poses(&back), poses(mechanism), "{template}");
    }
}

#[test]
fn comments_and_a_byte_order_mark_are_read_over() {
    let text = file("DoubleWishbone", &hmmwv());
    let text = text.replacen('{', "\u{feff}{ // é \"\n/* { */", 1).replace("\u{feff}", "");
    let plain = imported("DoubleWishbone", &hmmwv(), &on(Side::Left));
    let read = import_text(&format!("\u{feff}{text}"), &on(Side::Left)).unwrap();
    assert_eq!(read.mechanism.total_mass(), plain.mechanism.total_mass());
    // Lines are shifted by one.
    let lines = |i: &Imported| i.diagnostics.iter().filter_map(|d| d.line).collect::<Vec<_>>();
    assert_eq!(lines(&read), lines(&plain).iter().map(|l| l + 1).collect::<Vec<_>>());
    assert!(!lines(&plain).is_empty());
}
