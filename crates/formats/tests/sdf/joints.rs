//! Links, joints and axes.

use super::{axis, drawn_pose, find, inertial, joint, link, model, read};
use crate::support::codes;
use approx::assert_relative_eq;
use nalgebra::Rotation3;
use percuss_formats::{Purpose, Solid};
use percuss_mechanism::{JointKind, Severity};
use percuss_spatial::Vector3;
use std::f64::consts::{PI, TAU};

/// SDFormat 1.12: the moment −k (q − spring_reference) − d q̇.
#[test]
fn springs_of_joints() {
    let dynamics = "<dynamics><damping>0.5</damping><friction>9</friction><spring_reference>0.2</spring_reference>\
                    <spring_stiffness>40</spring_stiffness></dynamics>";
    let text = model(
        12,
        &format!("{}{}", link("a", ""), joint("j", "revolute", "world", "a", &axis("0 1 0", dynamics))),
    );
    let loaded = read(&text);
    let spring = loaded.mechanism.joints().iter().find_map(|joint| joint.spring()).expect("a spring");
    assert_eq!((spring.stiffness, spring.damping, spring.reference), (40.0, 0.5, 0.2));
    let back = read(&percuss_formats::write_sdf(&loaded.mechanism, "").unwrap().text);
    assert_eq!(back.mechanism.joints().iter().find_map(|joint| joint.spring()), Some(spring));
}

#[test]
fn kinds_of_joint() {
    let limits = "<limit><lower>-1</lower><upper>2</upper></limit>";
    let links: String = ["a", "b", "c", "d", "e", "f", "g", "h"].map(|name| link(name, "")).concat();
    let two = format!("{}<axis2><xyz>0 1 0</xyz>{limits}</axis2>", axis("1 0 0", ""));
    let joints = [
        joint("to_a", "fixed", "world", "a", ""),
        joint("to_b", "revolute", "a", "b", &axis("0 0 2", limits)),
        joint("to_c", "continuous", "b", "c", &axis("0 1 0", limits)),
        joint(
            "to_d",
            "prismatic",
            "c",
            "d",
            &axis("0 1 0", "<limit><lower>-inf</lower><upper>1e16</upper></limit>"),
        ),
        joint("to_e", "ball", "d", "e", ""),
        joint("to_f", "universal", "e", "f", &two),
        joint("to_g", "revolute2", "f", "g", &two.replace("0 1 0", "1 1 0")),
        joint(
            "to_h",
            "screw",
            "g",
            "h",
            &format!("<screw_thread_pitch>0.02</screw_thread_pitch>{}", axis("0 0 1", "")),
        ),
    ];
    let loaded = read(&model(12, &format!("{links}{}", joints.concat())));
    let mechanism = &loaded.mechanism;
    assert_eq!((mechanism.name(), mechanism.link(mechanism.root()).name()), ("m", "world"));
    let kinds: Vec<(&str, JointKind)> =
        mechanism.joints().iter().map(|joint| (joint.name(), joint.kind())).collect();
    let expected = [
        ("to_a", JointKind::Fixed),
        ("to_b", JointKind::Revolute),
        ("to_c", JointKind::Continuous),
        ("to_d", JointKind::Prismatic),
        ("to_e", JointKind::Spherical),
        ("to_f/axis", JointKind::Continuous),
        ("to_f/axis2", JointKind::Revolute),
        ("to_g/axis", JointKind::Continuous),
        ("to_g/axis2", JointKind::Revolute),
        ("to_h", JointKind::Continuous),
        ("to_h/advance", JointKind::Prismatic),
    ];
    assert_eq!(kinds, expected);
    assert_eq!(find(mechanism, "to_b").limits().map(|l| (l.lower, l.upper)), Some((-1.0, 2.0)));
    assert_eq!(*find(mechanism, "to_b").axis(), Vector3::z());
    assert_eq!(find(mechanism, "to_d").limits(), None);
    let advance = find(mechanism, "to_h/advance").mimic().expect("a mimic");
    assert_eq!(mechanism.joint(advance.master).name(), "to_h");
    assert_relative_eq!(advance.multiplier, 0.02 / TAU, max_relative = 1e-15);
    assert_eq!(codes(&Ok(loaded)), []);
}

#[test]
fn older_screws_are_left_handed() {
    let screw = format!("<thread_pitch>4</thread_pitch>{}", axis("0 0 1", ""));
    let loaded = read(&model(6, &(link("a", "") + &joint("j", "screw", "world", "a", &screw))));
    // 4 rad/m: −2π/4 m per turn.
    assert_eq!(find(&loaded.mechanism, "j/advance").mimic().map(|mimic| mimic.multiplier), Some(-0.25));
}

#[test]
fn a_joint_beside_the_origin_makes_a_chain() {
    let pose = "<pose relative_to=\"a\">1 0 0 0 0 1</pose>";
    let loaded = read(&model(
        7,
        &format!(
            "{}{}{}{}",
            link("a", "<pose>0 0 3 0 0 0</pose>"),
            link("b", pose),
            joint("base", "fixed", "world", "a", ""),
            joint("j", "revolute", "a", "b", &format!("<pose>0 2 0 0 0 0</pose>{}", axis("0 0 1", "")))
        ),
    ));
    let mechanism = &loaded.mechanism;
    let names: Vec<&str> = mechanism.links().iter().map(|link| link.name()).collect();
    assert_eq!(names, ["world", "a", "b/j", "b"]);
    assert_relative_eq!(drawn_pose(mechanism, "b").translation, Vector3::new(1.0, 0.0, 3.0), epsilon = 1e-15);
    let anchor = Vector3::new(1.0 - 2.0 * 1f64.sin(), 2.0 * 1f64.cos(), 3.0);
    assert_relative_eq!(drawn_pose(mechanism, "b/j").translation, anchor, epsilon = 1e-15);
    // A slide needs no anchor, nor does an axis through the origin.
    for (kind, at, xyz) in [("prismatic", "0 2 0", "1 0 0"), ("revolute", "0 2 0", "0 1 0")] {
        let pose = format!("<pose>{at} 0 0 0</pose>{}", axis(xyz, ""));
        let loaded = read(&model(7, &(link("a", "") + &joint("j", kind, "world", "a", &pose))));
        assert_eq!(loaded.mechanism.links().len(), 2, "{kind}");
    }
}

/// Values of libsdformat 12.3.0: with a child turned by 90°, the axis 1 0 0 of version 1.4 is 0 −1 0 in the joint.
#[test]
fn frames_of_axes_by_version() {
    let quarter = "<pose>0 0 0 0 0 1.5707963267948966</pose>";
    let file = |minor, pose: &str, contents: &str| {
        read(&model(minor, &(link("a", pose) + &joint("j", "revolute", "world", "a", contents))))
    };
    let direction = |minor, contents: &str| *find(&file(minor, quarter, contents).mechanism, "j").axis();
    let old = "<use_parent_model_frame>1</use_parent_model_frame>";
    let in_model = Vector3::new(0.0, -1.0, 0.0);
    for (minor, contents, expected) in [
        (4, axis("1 0 0", ""), in_model),
        (5, axis("1 0 0", ""), Vector3::x()),
        (6, axis("1 0 0", old), in_model),
        (7, "<axis><xyz expressed_in=\"__model__\">1 0 0</xyz></axis>".to_owned(), in_model),
        (7, axis("1 0 0", ""), Vector3::x()),
        (12, "<axis><xyz expressed_in=\"a\">1 0 0</xyz></axis>".to_owned(), Vector3::x()),
    ] {
        assert_relative_eq!(direction(minor, &contents), expected, epsilon = 1e-15);
    }
    // Ignored from version 1.7 on, with a warning.
    let newer = file(7, quarter, &axis("1 0 0", old));
    assert_eq!(*find(&newer.mechanism, "j").axis(), Vector3::x());
    assert_eq!(codes(&Ok(newer)), [(Severity::Warning, "ignored")]);
    // No axis: the z-axis, with a note.
    let absent = file(7, quarter, "");
    assert_eq!(*find(&absent.mechanism, "j").axis(), Vector3::z());
    assert_eq!(codes(&Ok(absent)), [(Severity::Note, "default-axis")]);
}

/// Axes of all versions by the rules of libsdformat. Its converters make of a true `use_parent_model_frame` of versions 1.4 to 1.6 an
/// `expressed_in` of the model, which replaces another; version 1.4 has it where it is not stated. Both attributes of a pose count before
/// version 1.7, where `frame` was renamed.
#[test]
fn frames_of_axes_in_every_version() {
    let turn = |angle: f64| *Rotation3::from_axis_angle(&Vector3::z_axis(), angle).matrix();
    let (base, child, own) = (0.3, 0.5, 0.8);
    let xyz = Vector3::new(0.6, 0.0, 0.8);
    let mut count = 0;
    for minor in 4..=12 {
        for relative in ["", "relative_to=\"base\"", "frame=\"base\""] {
            for expressed in ["", "__model__", "base", "child", "j"] {
                for parent_frame in ["", "0", "1", "true"] {
                    let pose = format!("<pose {relative}>0 0 0 0 0 {child}</pose>");
                    let frame = match expressed {
                        "" => String::new(),
                        name => format!(" expressed_in=\"{name}\""),
                    };
                    let flag = match parent_frame {
                        "" => String::new(),
                        value => format!("<use_parent_model_frame>{value}</use_parent_model_frame>"),
                    };
                    let contents = format!(
                        "<pose>0 0 0 0 0 {own}</pose><axis><xyz{frame}>{} {} {}</xyz>{flag}</axis>",
                        xyz.x, xyz.y, xyz.z
                    );
                    let text = model(
                        minor,
                        &(link("base", &format!("<pose>0 0 0 0 0 {base}</pose>"))
                            + &link("child", &pose)
                            + &joint("j", "revolute", "base", "child", &contents)),
                    );
                    // Angles about z in the model.
                    let is_old = minor < 7;
                    let of_base = relative.starts_with("relative") || relative.starts_with("frame") && is_old;
                    let at_child = child + if of_base { base } else { 0.0 };
                    let at_joint = at_child + own;
                    let in_model = is_old
                        && (["1", "true"].contains(&parent_frame) || minor == 4 && parent_frame.is_empty());
                    let given = match expressed {
                        _ if in_model => 0.0,
                        "__model__" => 0.0,
                        "base" => base,
                        "child" => at_child,
                        _ => at_joint,
                    };
                    let drawn = turn(given) * xyz;
                    let loaded = read(&text);
                    let joint = find(&loaded.mechanism, "j");
                    let found = drawn_pose(&loaded.mechanism, "child").vector(joint.axis());
                    assert_relative_eq!(found, drawn, epsilon = 1e-14);
                    count += 1;
                }
            }
        }
    }
    assert_eq!(count, 540);
}

#[test]
fn declared_and_default_inertias() {
    let bare =
        read(&model(7, "<link name=\"a\"/><link name=\"b\"><inertial><mass>0.1</mass></inertial></link>"));
    let default = inertial(&bare.mechanism, "a");
    assert_eq!((default.mass, default.about_com[(1, 1)]), (1.0, 1.0));
    let partial = inertial(&bare.mechanism, "b");
    assert_eq!((partial.mass, partial.about_com[(1, 1)]), (0.1, 1.0));
    let found = codes(&Ok(bare));
    assert_eq!(
        found.iter().filter(|found| **found == (Severity::Warning, "default-inertia")).count(),
        2,
        "{found:?}"
    );
    // A link that cannot move needs no inertia.
    let held = read(&model(7, "<static>true</static><link name=\"a\"/>"));
    assert_eq!(codes(&Ok(held)), []);
    let turned = read(&model(
        9,
        "<link name=\"a\"><inertial><pose degrees=\"true\">1 2 3 0 0 90</pose><mass>2</mass>
           <inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz><ixy>0.1</ixy></inertia></inertial></link>",
    ));
    let own = inertial(&turned.mechanism, "a");
    assert_eq!(own.com, Vector3::new(1.0, 2.0, 3.0));
    for ((row, column), value) in [((0, 0), 2.0), ((1, 1), 1.0), ((2, 2), 2.5), ((0, 1), -0.1)] {
        assert_relative_eq!(own.about_com[(row, column)], value, epsilon = 1e-15);
    }
}

#[test]
fn inertias_of_collisions() {
    let collision = |shape: &str, more: &str| {
        format!("<collision name=\"c{}\">{more}<geometry>{shape}</geometry></collision>", shape.len())
    };
    let file = |inertial: &str, collisions: &str| {
        read(&model(
            11,
            &format!("<link name=\"a\"><inertial auto=\"true\">{inertial}</inertial>{collisions}</link>"),
        ))
    };
    let cuboid = collision("<box><size>1 2 3</size></box>", "<pose>0 0 1 0 0 0</pose>");
    let loaded = file("", &cuboid);
    let own = inertial(&loaded.mechanism, "a");
    assert_eq!((own.mass, own.com), (6000.0, Vector3::z()));
    assert_relative_eq!(own.about_com[(0, 0)], 6000.0 * 13.0 / 12.0, max_relative = 1e-15);
    assert_eq!(loaded.shapes[1][0].solid, Solid::Box { size: [1.0, 2.0, 3.0] });
    assert_eq!(loaded.shapes[1][0].purpose, Purpose::Collision);
    // The density of the collision counts before that of the inertia.
    let cone = collision("<cone><radius>2</radius><length>4</length></cone>", "<density>3</density>");
    let own = inertial(&file("<density>7</density>", &cone).mechanism, "a");
    let mass = 3.0 * PI * 4.0 * 4.0 / 3.0;
    assert_relative_eq!(own.mass, mass, max_relative = 1e-15);
    assert_relative_eq!(own.com, Vector3::new(0.0, 0.0, -1.0), epsilon = 1e-15);
    assert_relative_eq!(own.about_com[(2, 2)], 0.3 * mass * 4.0, max_relative = 1e-15);
    assert_relative_eq!(own.about_com[(0, 0)], mass * (0.15 * 4.0 + 16.0 * 3.0 / 80.0), max_relative = 1e-15);
    // Two collisions, scaled to a mass.
    let two = cuboid + &collision("<sphere><radius>1</radius></sphere>", "<pose>0 0 -1 0 0 0</pose>");
    let scaled = inertial(&file("<mass>5</mass>", &two).mechanism, "a");
    let (first, second) = (6.0, 4.0 / 3.0 * PI);
    assert_relative_eq!(scaled.mass, 5.0, max_relative = 1e-15);
    assert_relative_eq!(scaled.com.z, (first - second) / (first + second), max_relative = 1e-14);
}

#[test]
fn a_rotor_of_drake_is_an_armature() {
    let rotor = "<drake:rotor_inertia>0.002</drake:rotor_inertia><drake:gear_ratio>10</drake:gear_ratio>";
    let contents = format!("{}{rotor}", axis("0 0 1", ""));
    let loaded = read(&model(7, &(link("a", "") + &joint("j", "revolute", "world", "a", &contents))));
    assert_relative_eq!(find(&loaded.mechanism, "j").armature()[0], 0.2, max_relative = 1e-15);
}

/// Inertias of joints where SDFormat has none, and angles of more than a turn: a warning names each.
#[test]
fn values_of_joints_in_unread_parts_are_named() {
    let of = |in_joint: &str, in_axis: &str, pose: &str| {
        let joint = joint("j", "revolute", "world", "a", &format!("{}{in_joint}", axis("0 0 1", in_axis)));
        read(&model(12, &format!("{}{joint}", link("a", pose))))
    };
    for (in_joint, in_axis, pose, code) in [
        ("", "<dynamics><armature>0.1</armature></dynamics>", "", "unknown-element"),
        ("", "<dynamics armature=\"0.1\"/>", "", "unknown-attribute"),
        ("<physics><ode><armature>0.1</armature></ode></physics>", "", "", "ignored"),
        ("<sensor name=\"s\" type=\"t\"><armature>0.1</armature></sensor>", "", "", "ignored"),
        ("<plugin name=\"p\" filename=\"f\"><rotor_inertia>0.1</rotor_inertia></plugin>", "", "", "ignored"),
        ("<mujoco:armature>0.1</mujoco:armature>", "", "", "ignored"),
        ("<drake:armature>0.1</drake:armature>", "", "", "unknown-element"),
        ("", "<drake:rotor_inertia>0.1</drake:rotor_inertia>", "", "unknown-element"),
        ("", "", "<pose>0 0 0 0 0 90</pose>", "large-angle"),
    ] {
        let loaded = of(in_joint, in_axis, pose);
        let told = loaded.diagnostics.iter().any(|d| d.code == code && d.severity == Severity::Warning);
        assert!(told, "{in_joint}{in_axis}{pose}: {:?}", loaded.diagnostics);
    }
    for (in_joint, code) in [
        ("<drake:gear_ratio>10</drake:gear_ratio>", "gear-without-rotor"),
        ("<thread_pitch>5</thread_pitch>", "ignored"),
        ("<gearbox_ratio>5</gearbox_ratio>", "ignored"),
    ] {
        let loaded = of(in_joint, "", "<pose degrees=\"true\">0 0 0 0 0 90</pose>");
        let told: Vec<_> = loaded.diagnostics.iter().map(|d| (d.code, d.severity)).collect();
        assert_eq!(told, [(code, Severity::Note)], "{in_joint}");
    }
}
