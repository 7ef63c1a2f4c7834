//! Values of MuJoCo 4.0.0 and closed forms.

use super::{load_mjcf, model};
use crate::support::{Folder, codes};
use approx::assert_relative_eq;
use percuss_formats::{Loaded, Solid};
use percuss_mechanism::{ClosureKind, Inertial, JointKind, Mechanism, Severity};
use percuss_spatial::{Transform, Vector3};

fn read(text: &str) -> Loaded {
    load_mjcf(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn inertial(mechanism: &Mechanism, link: &str) -> Inertial {
    *mechanism.link(mechanism.find_link(link).unwrap()).inertial().expect("an inertia")
}

/// Pose of a link in the world with all joints at 0.
fn drawn_pose(mechanism: &Mechanism, link: &str) -> Transform<f64> {
    let mut pose = Transform::identity();
    let mut current = mechanism.find_link(link).unwrap();
    while let Some(id) = mechanism.parent_joint(current) {
        let joint = mechanism.joint(id);
        pose = *joint.origin() * pose;
        current = joint.parent();
    }
    pose
}

const BODY: &str = "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>";

#[test]
fn kinds_of_joint_and_their_positions() {
    let loaded = read(&model(
        &format!(
            "<body name=\"f\"><freejoint name=\"free\"/>{BODY}
               <body name=\"h\" pos=\"1 0 0\"><joint name=\"hinge\" axis=\"0 2 0\" range=\"-1 2\" armature=\"0.3\"/>{BODY}
                 <body name=\"s\"><joint name=\"slide\" type=\"slide\" limited=\"false\" range=\"-1 2\"/>{BODY}
                   <body name=\"b\"><joint name=\"ball\" type=\"ball\" armature=\"0.1\"/>{BODY}
                     <body name=\"r\">{BODY}</body></body></body></body></body>"
        ),
        "",
    ));
    let mechanism = &loaded.mechanism;
    let joint = |name: &str| mechanism.joint(mechanism.find_joint(name).unwrap());
    assert_eq!(mechanism.name(), "test");
    assert_eq!(mechanism.link(mechanism.root()).name(), "world");
    assert_eq!(joint("free").kind(), JointKind::Floating);
    let hinge = joint("hinge");
    assert_eq!((hinge.kind(), hinge.armature()), (JointKind::Revolute, &[0.3][..]));
    assert_eq!(*hinge.axis(), Vector3::y());
    assert_eq!(hinge.limits().map(|l| (l.lower, l.upper)), Some((-1.0, 2.0)));
    assert_eq!((joint("slide").kind(), joint("slide").limits()), (JointKind::Prismatic, None));
    assert_eq!((joint("ball").kind(), joint("ball").armature()), (JointKind::Spherical, &[0.1; 3][..]));
    assert_eq!(joint("r_fixed").kind(), JointKind::Fixed);
    assert_eq!(codes(&Ok(loaded)), []);
}

/// MuJoCo 4.0.0: qfrc_spring = −k (qpos − springref), qfrc_damper = −d qvel; qpos is `ref` as drawn.
#[test]
fn springs_of_joints() {
    let text = model(
        &format!(
            "<body name=\"a\"><joint name=\"hinge\" ref=\"0.2\" springref=\"0.5\" stiffness=\"7\" damping=\"0.2\"/>{BODY}
               <body name=\"b\"><joint name=\"slide\" type=\"slide\" springref=\"0.1\" stiffness=\"30\"/>{BODY}
                 <body name=\"c\"><joint name=\"plain\"/>{BODY}</body></body></body>"
        ),
        "",
    );
    let loaded = read(&text);
    let spring = |name: &str| {
        let mechanism = &loaded.mechanism;
        mechanism.joint(mechanism.find_joint(name).unwrap()).spring()
    };
    let hinge = spring("hinge").expect("a spring");
    assert_eq!((hinge.stiffness, hinge.damping), (7.0, 0.2));
    assert_relative_eq!(hinge.reference, 0.3, max_relative = 1e-15);
    let slide = spring("slide").expect("a spring");
    assert_eq!((slide.stiffness, slide.damping, slide.reference), (30.0, 0.0, 0.1));
    assert_eq!(spring("plain"), None);
    let back = read(&percuss_formats::write_mjcf(&loaded.mechanism, "").unwrap().text);
    for joint in loaded.mechanism.joints() {
        let again = back.mechanism.joint(back.mechanism.find_joint(joint.name()).unwrap());
        assert_eq!(again.spring(), joint.spring());
    }
    let left_out = [
        ("type=\"ball\" damping=\"1\"", Severity::Note),
        ("stiffness=\"-1\"", Severity::Note),
        ("stiffness=\"1 0 2\"", Severity::Warning),
        ("springdamper=\"0.1 1\"", Severity::Warning),
    ];
    for (attributes, severity) in left_out {
        let text = model(&format!("<body name=\"a\"><joint name=\"j\" {attributes}/>{BODY}</body>"), "");
        assert_eq!(codes(&load_mjcf(&text)), [(severity, "spring-left-out")], "{attributes}");
    }
}

#[test]
fn several_joints_and_anchors_make_a_chain() {
    let loaded = read(&model(
        &format!(
            "<body name=\"a\" pos=\"0 0 1\"><joint name=\"x\" type=\"slide\" axis=\"1 0 0\"/>
               <joint name=\"turn\" pos=\"0.5 0 0\"/>{BODY}</body>"
        ),
        "",
    ));
    let names: Vec<&str> = loaded.mechanism.links().iter().map(|link| link.name()).collect();
    assert_eq!(names, ["world", "a/x", "a/turn", "a"]);
    let joints: Vec<&str> = loaded.mechanism.joints().iter().map(|joint| joint.name()).collect();
    assert_eq!(joints, ["x", "turn", "a_fixed"]);
    // The frame of the link is the frame of the body.
    assert_eq!(drawn_pose(&loaded.mechanism, "a").translation, Vector3::new(0.0, 0.0, 1.0));
    assert_eq!(drawn_pose(&loaded.mechanism, "a/turn").translation, Vector3::new(0.5, 0.0, 1.0));
}

#[test]
fn angles_are_degrees_by_default_and_positions_count_from_the_drawing() {
    let body = |compiler: &str| {
        format!(
            "<mujoco>{compiler}<worldbody><body euler=\"90 90 0\"><joint name=\"j\" ref=\"90\" range=\"80 100\"/>{BODY}</body>
             </worldbody></mujoco>"
        )
    };
    let loaded = read(&body(""));
    let joint = &loaded.mechanism.joints()[0];
    let limits = joint.limits().unwrap();
    assert_relative_eq!(limits.upper, 10f64.to_radians(), epsilon = 1e-15);
    assert_relative_eq!(limits.lower, -10f64.to_radians(), epsilon = 1e-15);
    // Rotation of the quaternion (0.5, 0.5, 0.5, 0.5), as in MuJoCo.
    assert_relative_eq!(joint.origin().rotation * Vector3::x(), Vector3::y(), epsilon = 1e-15);
    assert_eq!(codes(&Ok(loaded)), [(Severity::Warning, "reference-position")]);
    let fixed = read(&body("<compiler eulerseq=\"XYZ\"/>"));
    let rotation = fixed.mechanism.joints()[0].origin().rotation;
    assert_relative_eq!(rotation * Vector3::x(), -Vector3::z(), epsilon = 1e-15);
}

#[test]
fn inertias_of_geoms() {
    let loaded = read(&model(
        "<body name=\"two\"><joint/><geom size=\"0.1\" pos=\"1 0 0\" mass=\"2\"/><geom size=\"0.1\" pos=\"-1 0 0\" mass=\"2\"/>
           <geom size=\"1\" mass=\"0\"/><geom size=\"1\" group=\"5\"/></body>
         <body name=\"rod\"><joint/><geom type=\"cylinder\" size=\"0.1\" fromto=\"0 0 0 0 2 0\" density=\"1\" contype=\"0\" conaffinity=\"0\"/></body>",
        "<compiler inertiagrouprange=\"0 4\"/>",
    ));
    let two = inertial(&loaded.mechanism, "two");
    assert_relative_eq!(two.mass, 4.0, epsilon = 1e-15);
    assert_relative_eq!(two.com, Vector3::zeros(), epsilon = 1e-15);
    assert_relative_eq!(two.about_com[(0, 0)], 2.0 * 2.0 * 0.4 * 0.01, epsilon = 1e-15);
    assert_relative_eq!(two.about_com[(2, 2)], 4.0 + 2.0 * 2.0 * 0.4 * 0.01, epsilon = 1e-14);
    // Visual geoms count too.
    let rod = inertial(&loaded.mechanism, "rod");
    assert_relative_eq!(rod.mass, std::f64::consts::PI * 0.02, epsilon = 1e-15);
    assert_relative_eq!(rod.com, Vector3::new(0.0, 1.0, 0.0), epsilon = 1e-15);
    assert_relative_eq!(rod.about_com[(1, 1)], rod.mass * 0.005, epsilon = 1e-15);
    let shapes = &loaded.shapes[loaded.mechanism.find_link("rod").unwrap().index()];
    assert_eq!(shapes[0].solid, Solid::Cylinder { radius: 0.1, length: 2.0 });
}

#[test]
fn changes_of_the_compiler() {
    let text = |compiler: &str| {
        format!(
            "<mujoco><compiler {compiler}/><worldbody><body name=\"a\"><joint type=\"slide\"/>
             <inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 4\"/></body></worldbody></mujoco>"
        )
    };
    // As MuJoCo 4.0.0 gives.
    let bounded = inertial(&read(&text("balanceinertia=\"true\" boundmass=\"3\"")).mechanism, "a");
    assert_eq!(bounded.mass, 3.0);
    assert_relative_eq!(bounded.about_com[(2, 2)], 2.0, epsilon = 1e-15);
    let scaled = read(&text("settotalmass=\"5\""));
    assert_eq!(inertial(&scaled.mechanism, "a").about_com[(2, 2)], 20.0);
    assert!(codes(&Ok(scaled)).contains(&(Severity::Warning, "changed-inertia")));
}

#[test]
fn classes_of_defaults() {
    let loaded = read(
        "<mujoco><worldbody><body name=\"a\" childclass=\"inner\"><joint name=\"j\"/><geom size=\"1\"/>
           <body name=\"b\"><joint name=\"k\" class=\"main\"/><geom class=\"outer\" size=\"1\"/>
             <frame childclass=\"outer\"><body name=\"c\"><freejoint name=\"unused\"/></body></frame></body></body></worldbody>
         <default><joint armature=\"7\"/><default class=\"outer\"><geom mass=\"3\"/><joint armature=\"5\"/>
           <default class=\"inner\"><joint type=\"slide\"/></default></default></default></mujoco>"
            .replace("<body name=\"c\"><freejoint name=\"unused\"/></body>", "<body name=\"c\"><geom size=\"1\"/></body>")
            .as_str(),
    );
    let joint = |name: &str| loaded.mechanism.joint(loaded.mechanism.find_joint(name).unwrap());
    assert_eq!((joint("j").kind(), joint("j").armature()), (JointKind::Prismatic, &[5.0][..]));
    assert_eq!((joint("k").kind(), joint("k").armature()), (JointKind::Continuous, &[7.0][..]));
    for link in ["a", "b", "c"] {
        assert_eq!(inertial(&loaded.mechanism, link).mass, 3.0, "{link}");
    }
}

#[test]
fn replicates_and_frames() {
    let loaded = read(
        "<mujoco><worldbody><replicate count=\"3\" offset=\"1 0 0\" euler=\"0 0 30\"><body name=\"a\" pos=\"0 1 0\"><joint name=\"j\"/>
         <geom size=\".1\"/></body></replicate>
         <replicate count=\"11\" sep=\"_\"><replicate count=\"2\"><body name=\"g\"/></replicate></replicate></worldbody></mujoco>",
    );
    // As MuJoCo 4.0.0 gives.
    let second = drawn_pose(&loaded.mechanism, "a1");
    assert_relative_eq!(second.translation, Vector3::new(0.5, 0.8660254037844386, 0.0), epsilon = 1e-15);
    let third = drawn_pose(&loaded.mechanism, "a2");
    assert_relative_eq!(third.translation, Vector3::new(1.0, 1.0, 0.0), epsilon = 1e-15);
    assert_relative_eq!(third.rotation[(1, 0)], 60f64.to_radians().sin(), epsilon = 1e-15);
    for name in ["j0", "j2"] {
        assert!(loaded.mechanism.find_joint(name).is_ok(), "{name}");
    }
    for name in ["g0_00", "g1_00", "g0_10", "g1_10"] {
        assert!(loaded.mechanism.find_link(name).is_ok(), "{name}");
    }
}

#[test]
fn constraints_become_closures_and_mimics() {
    let body = |name: &str| {
        format!(
            "<body name=\"{name}\" pos=\"1 0 0\"><joint name=\"j{name}\"/><geom size=\".1\"/><site name=\"s{name}\" pos=\"0 1 0\"/></body>"
        )
    };
    let bodies = ["a", "b", "c", "d"].map(body).concat();
    let loaded = read(&model(
        &bodies,
        "<equality>
           <connect name=\"pin\" body1=\"a\" anchor=\"0 0 1\"/>
           <connect site1=\"sa\" site2=\"sb\"/>
           <weld body1=\"a\" body2=\"b\" anchor=\"1 2 3\"/>
           <weld body1=\"a\" body2=\"b\" anchor=\"1 2 3\" relpose=\"4 5 6 2 0 0 0\" torquescale=\"0\"/>
           <weld body1=\"a\" body2=\"b\" active=\"false\"/>
           <tendon tendon1=\"rod\" polycoef=\"0.5\"/>
           <joint joint1=\"ja\" joint2=\"jb\" polycoef=\"0.25 -2\"/>
           <joint joint1=\"jc\" polycoef=\"0.5\"/>
           <tendon tendon1=\"pair\"/>
         </equality>
         <tendon><spatial name=\"rod\"><site site=\"sa\"/><site site=\"sd\"/></spatial>
           <fixed name=\"pair\"><joint joint=\"jd\" coef=\"2\"/><joint joint=\"jb\" coef=\"-1\"/></fixed></tendon>",
    ));
    let kinds: Vec<(&str, ClosureKind)> =
        loaded.mechanism.closures().iter().map(|c| (c.name(), c.kind())).collect();
    let expected = [
        ("pin", ClosureKind::Spherical),
        ("connect", ClosureKind::Spherical),
        ("weld", ClosureKind::Fixed),
        ("weld_2", ClosureKind::Spherical),
        ("tendon", ClosureKind::Distance),
    ];
    assert_eq!(kinds, expected);
    let closures = loaded.mechanism.closures();
    // The point of the second body (the world) coincides with the anchor as drawn.
    assert_eq!(closures[0].successor().frame.translation, Vector3::new(1.0, 0.0, 1.0));
    assert_eq!(closures[2].predecessor().frame.translation, Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(closures[3].predecessor().frame.translation, Vector3::new(4.0, 5.0, 6.0));
    assert_eq!(closures[4].distance(), Some(0.5));
    let joint = |name: &str| loaded.mechanism.joint(loaded.mechanism.find_joint(name).unwrap());
    let mimic = joint("ja").mimic().unwrap();
    assert_eq!((mimic.multiplier, mimic.offset), (-2.0, 0.25));
    assert_eq!(joint("jd").mimic().unwrap().multiplier, 0.5);
    // A joint without a partner is locked, at half a radian.
    assert_eq!(joint("jc").kind(), JointKind::Fixed);
    assert_relative_eq!(joint("jc").origin().rotation[(1, 0)], 0.5f64.sin(), epsilon = 1e-15);
}

#[test]
fn actuators_and_tendons_add_armature() {
    let loaded = read(&model(
        &format!("<body><joint name=\"a\" armature=\"1\"/>{BODY}</body><body><joint name=\"b\" type=\"ball\"/>{BODY}</body>"),
        "<default><motor armature=\"0.5\"/></default><tendon><fixed name=\"t\" armature=\"2\"><joint joint=\"a\" coef=\"3\"/></fixed></tendon>
         <actuator><general joint=\"a\" gear=\"2\"/><motor jointinparent=\"b\" gear=\"3 4\" armature=\"1\"/>
           <position tendon=\"t\" armature=\"1\"/></actuator>",
    ));
    let armature =
        |name: &str| loaded.mechanism.joint(loaded.mechanism.find_joint(name).unwrap()).armature().to_vec();
    // 1 + 2²·0.5 + 3²·2 + 3²·1; a ball joint has gear[0]² on all velocities.
    assert_eq!(armature("a"), [30.0]);
    assert_eq!(armature("b"), [9.0; 3]);
}

#[test]
fn meshes_in_the_model() {
    let loaded = read(&model(
        "<body name=\"m\"><joint/><geom type=\"mesh\" mesh=\"m\"/></body>",
        "<asset><mesh name=\"m\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\" face=\"0 2 1 0 1 3 0 3 2 1 2 3\" refpos=\"1 0 0\"
           refquat=\"1 0 0 1\" scale=\"1 2 3\" inertia=\"exact\"/></asset>",
    ));
    // As MuJoCo 4.0.0 gives: the mesh is shifted, turned, and then scaled.
    let found = inertial(&loaded.mechanism, "m");
    assert_relative_eq!(found.mass, 1000.0, epsilon = 1e-12);
    assert_relative_eq!(found.com, Vector3::new(0.25, 1.5, 0.75), epsilon = 1e-15);
    let mut moments: Vec<f64> = found.about_com.symmetric_eigenvalues().iter().copied().collect();
    moments.sort_by(f64::total_cmp);
    for (own, theirs) in moments.iter().zip([158.91753023, 388.61481474, 502.46765503]) {
        assert_relative_eq!(*own, theirs, max_relative = 1e-9);
    }
}

#[test]
fn included_files_and_mesh_files() {
    let arm = "<mujocoinclude><body name=\"arm\"><joint/><geom type=\"mesh\" mesh=\"cube\"/></body></mujocoinclude>";
    let faces = "f 1 2 4\nf 1 4 3\nf 5 7 8\nf 5 8 6\nf 1 5 6\nf 1 6 2\nf 3 4 8\nf 3 8 7\nf 1 3 7\nf 1 7 5\nf 2 6 8\nf 2 8 4\n";
    let corners: String = (0..8).map(|i| format!("v {} {} {}\n", i & 1, i >> 1 & 1, i >> 2 & 1)).collect();
    let main = "<mujoco><compiler meshdir=\"parts\"/><asset><mesh file=\"cube.obj\"/></asset>
         <worldbody><include file=\"parts/arm.xml\"/></worldbody></mujoco>";
    let mut files = vec![
        ("parts/arm.xml", arm.to_owned()),
        ("parts/cube.obj", corners + faces),
        ("main.xml", main.to_owned()),
    ];
    let loaded = Folder::new("mjcf-files", &files).load("main.xml").unwrap_or_else(|error| panic!("{error}"));
    let arm = inertial(&loaded.mechanism, "arm");
    assert_relative_eq!(arm.mass, 1000.0, epsilon = 1e-9);
    assert_relative_eq!(arm.about_com[(0, 0)], 1000.0 / 6.0, epsilon = 1e-9);
    assert_eq!(loaded.files.len(), 2, "{:?}", loaded.files);
    // A circle of files is refused, with the position in the included file.
    files[0].1 =
        "<mujocoinclude>\n<body name=\"arm\"/>\n<include file=\"main.xml\"/></mujocoinclude>".to_owned();
    let error = Folder::new("mjcf-circle", &files).load("main.xml").expect_err("a circle");
    let diagnostic = &error.diagnostics[0];
    assert_eq!((diagnostic.code, diagnostic.line), ("included-twice", Some(3)));
    assert!(diagnostic.path.ends_with("arm.xml"), "{}", diagnostic.path);
}

/// Values of MuJoCo 3.3: of two objects or groups the first counts, for a hull all vertices. Lines that begin no object do not count.
#[test]
fn the_first_object_of_a_mesh_file_counts() {
    let cube = |x: usize, size: usize, first: usize| {
        let corner =
            |i: usize| format!("v {} {} {}\n", x + size * (i & 1), size * (i >> 1 & 1), size * (i >> 2));
        let corners: String = (0..8).map(corner).collect();
        let faces = [[1, 2, 4], [1, 4, 3], [5, 7, 8], [5, 8, 6], [1, 5, 6], [1, 6, 2]];
        let more = [[3, 4, 8], [3, 8, 7], [1, 3, 7], [1, 7, 5], [2, 6, 8], [2, 8, 4]];
        let face = |f: &[usize; 3]| format!("f {} {} {}\n", f[0] + first, f[2] + first, f[1] + first);
        corners + &faces.iter().chain(&more).map(face).collect::<String>()
    };
    let both = |between: &str| format!("o lid\n{}{between}{}", cube(0, 1, 0), cube(1, 2, 8));
    let main = |rule: &str| {
        format!(
            "<mujoco><asset><mesh name=\"m\" file=\"two.obj\" inertia=\"{rule}\"/></asset><worldbody><body name=\"b\"><joint/>
               <geom type=\"mesh\" mesh=\"m\" density=\"1\"/></body></worldbody></mujoco>"
        )
    };
    for (between, expected, notes) in [
        ("o box\n", 1.0, true),
        ("g box\n", 1.0, true),
        ("g\tbox\n", 1.0, true),
        ("  o lid\n", 1.0, true),
        ("", 9.0, false),
        ("g\n", 9.0, false),
        ("usemtl red\n", 9.0, false),
        ("s 1\n", 9.0, false),
    ] {
        for rule in ["exact", "convex"] {
            let files = [("two.obj", both(between)), ("m.xml", main(rule))];
            let loaded = Folder::new("mjcf-objects", &files).load("m.xml").unwrap_or_else(|e| panic!("{e}"));
            let mass = inertial(&loaded.mechanism, "b").mass;
            let is_hull = rule == "convex";
            // The hull is a cube of 2 m behind a frustum from 1 m² to 4 m², 1 m long.
            let expected = if is_hull { 8.0 + (1.0 + 2.0 + 4.0) / 3.0 } else { expected };
            assert_relative_eq!(mass, expected, epsilon = 1e-12);
            let is_noted = loaded.diagnostics.iter().any(|found| found.code == "first-object");
            assert_eq!(is_noted, notes && !is_hull, "{between:?} {rule}");
        }
    }
}
