//! Valid files give the expected numbers, and every kind of element gets the treatment of the table.

use crate::support::{PENDULUM, changed, codes, load_text, told};
use approx::assert_relative_eq;
use percuss_formats::{LoadOptions, Source, load};
use percuss_mechanism::{Accept, Geometry, JointKind, Limits, Mechanism, Severity};
use percuss_spatial::{Matrix3, Vector3, rotation_about, rotation_from_rpy};
use std::f64::consts::FRAC_PI_2;

// A few roundings of numbers of order one.
const TOL: f64 = 1e-15 * 8.0;

fn mechanism(changes: &[(&str, &str)]) -> Mechanism {
    changed(changes).unwrap_or_else(|e| panic!("{e}")).mechanism
}

#[test]
fn a_pendulum_gives_its_numbers() {
    let loaded = load_text(PENDULUM).unwrap();
    let m = &loaded.mechanism;
    assert_eq!(m.name(), "pendulum");
    assert_eq!(m.links().iter().map(|l| l.name()).collect::<Vec<_>>(), ["base", "arm"]);
    let hinge = &m.joints()[0];
    assert_eq!((hinge.name(), hinge.kind()), ("hinge", JointKind::Revolute));
    assert_eq!((hinge.parent(), hinge.child()), (m.find_link("base").unwrap(), m.find_link("arm").unwrap()));
    assert_eq!(hinge.origin().translation, Vector3::new(0.0, 0.0, 1.0));
    assert_eq!(hinge.origin().rotation, Matrix3::identity());
    assert_eq!(*hinge.axis(), Vector3::y());
    assert_eq!(hinge.limits(), Some(Limits { lower: -1.0, upper: 1.5 }));
    assert_eq!(hinge.armature(), [0.0]);
    let arm = &m.links()[1];
    assert_eq!(arm.inertia().mass, 2.0);
    assert_eq!(arm.inertia().first_moment, Vector3::new(0.0, 0.0, -1.0));
    // Parallel axis theorem: 2 kg at a distance of 0.5 m.
    assert_eq!(arm.inertia().rotational, Matrix3::from_diagonal(&Vector3::new(0.6, 0.62, 0.03)));
    assert_eq!(arm.geometry(), Geometry::Within(0.5 + 0.3f64.hypot(0.4)));
    assert_eq!(codes(&Ok(loaded)), []);
}

#[test]
fn a_turned_inertial_frame_turns_the_inertia() {
    // The x axis of the inertial frame is the z axis of the link.
    let m = mechanism(&[("xyz=\"0 0 -0.5\" rpy=\"0 0 0\"", "xyz=\"0 0 0\" rpy=\"0 -1.5707963267948966 0\"")]);
    let expected = Matrix3::from_diagonal(&Vector3::new(0.03, 0.12, 0.1));
    assert_relative_eq!(m.links()[1].inertia().rotational, expected, epsilon = TOL);
    // A tensor with products, in a general rotation, compared with R I Rᵀ.
    let m = mechanism(&[
        ("xyz=\"0 0 -0.5\" rpy=\"0 0 0\"", "rpy=\"0.3 -0.4 0.5\""),
        ("ixy=\"0\"", "ixy=\"0.01\""),
        ("iyz=\"0\"", "iyz=\"-0.02\""),
    ]);
    let i = Matrix3::new(0.1, 0.01, 0.0, 0.01, 0.12, -0.02, 0.0, -0.02, 0.03);
    let r = rotation_from_rpy([0.3, -0.4, 0.5]);
    assert_relative_eq!(m.links()[1].inertia().rotational, r * i * r.transpose(), epsilon = TOL);
}

#[test]
fn quaternions_are_exact_near_the_pole_in_every_version() {
    for version in ["", "version=\"1.0\"", "version=\"1.1\"", "version=\"1.2\""] {
        for pitch in [FRAC_PI_2, -FRAC_PI_2, FRAC_PI_2 - 1e-3, 1e-9 - FRAC_PI_2, 0.3] {
            let (s, c) = (pitch / 2.0).sin_cos();
            let quaternion = format!("quat_xyzw=\"0 {s:e} 0 {c:e}\"");
            let m = mechanism(&[
                ("rpy=\"0 0 0\"", &quaternion),
                ("name=\"pendulum\"", &format!("name=\"p\" {version}")),
            ]);
            let expected = rotation_about(&Vector3::y(), pitch);
            assert_relative_eq!(m.joints()[0].origin().rotation, expected, epsilon = TOL);
        }
    }
    // A general quaternion that is not normalised and takes precedence over rpy.
    let loaded = changed(&[("rpy=\"0 0 0\"", "rpy=\"1 2 3\" quat_xyzw=\"2 -4 6 8\"")]).unwrap();
    let axis = Vector3::new(2.0, -4.0, 6.0);
    let expected = rotation_about(&axis.normalize(), 2.0 * axis.norm().atan2(8.0));
    assert_relative_eq!(loaded.mechanism.joints()[0].origin().rotation, expected, epsilon = TOL);
    let expected = [(Severity::Warning, "quaternion-not-unit"), (Severity::Warning, "two-rotations")];
    assert_eq!(codes(&Ok(loaded)), expected);
}

const DRAKE: (&str, &str) = ("name=\"pendulum\"", "name=\"pendulum\" xmlns:drake=\"http://drake.mit.edu\"");
const GEARED: &str = "<drake:rotor_inertia value=\"2e-4\"/><drake:gear_ratio value=\"50\"/>";

#[test]
fn armatures_are_read_in_every_spelling() {
    let armature = |changes: &[(&str, &str)]| mechanism(changes).joints()[0].armature().to_vec();
    let reflected = 2e-4 * 50.0 * 50.0;
    assert_eq!(armature(&[("<axis", "<dynamics damping=\"1\" armature=\"0.25\"/><axis")]), [0.25]);
    assert_eq!(armature(&[DRAKE, ("<axis", &format!("{GEARED}<axis"))]), [reflected]);
    assert_eq!(armature(&[DRAKE, ("<axis", &format!("<actuator>{GEARED}</actuator><axis"))]), [reflected]);
    let transmission = format!(
        "<transmission><type>simple</type><joint name=\"hinge\"/><actuator name=\"a\">{GEARED}</actuator></transmission>"
    );
    assert_eq!(armature(&[DRAKE, ("</robot>", &format!("{transmission}</robot>"))]), [reflected]);
    // Two equal values count once.
    let both = format!("<dynamics armature=\"0.5\"/>{GEARED}<axis");
    assert_eq!(armature(&[DRAKE, ("<axis", &both)]), [reflected]);
    assert_eq!(armature(&[DRAKE, ("<axis", "<drake:rotor_inertia value=\"0.125\"/><axis")]), [0.125]);
    // A gear ratio without a rotor adds nothing.
    assert_eq!(armature(&[DRAKE, ("<axis", "<drake:gear_ratio value=\"50\"/><axis")]), [0.0]);
    // One value per velocity.
    let planar = [("revolute", "planar"), ("<axis", "<dynamics armature=\"1 2 3\"/><axis")];
    assert_eq!(armature(&planar), [1.0, 2.0, 3.0]);
}

#[test]
fn the_table_says_what_becomes_of_every_kind_of_element() {
    use Severity::{Error, Note, Warning};
    let at_robot = |element: &str| changed(&[("</robot>", &format!("{element}</robot>"))]);
    let at_link = |element: &str| changed(&[("<visual>", &format!("{element}<visual>"))]);
    let at_joint = |element: &str| changed(&[("<axis", &format!("{element}<axis"))]);
    let drake = |name: &str| changed(&[DRAKE, ("</robot>", &format!("<drake:{name}/></robot>"))]);
    let cases = [
        (at_robot("<material name=\"red\"/>"), None),
        (at_robot("<gazebo reference=\"arm\"><kp>1</kp><sensor><any/></sensor></gazebo>"), None),
        (
            at_robot("<gazebo reference=\"arm\"><any thing=\"x\"/></gazebo>"),
            Some((Warning, "unknown-element")),
        ),
        (at_robot("<transmission name=\"t\"><any/></transmission>"), Some((Warning, "unknown-element"))),
        (at_robot("<sensor/><ros2_control name=\"x\"><joint name=\"hinge\"/></ros2_control>"), None),
        (at_robot("<other:thing xmlns:other=\"http://example.org\"/>"), None),
        (at_robot("<thing/>"), Some((Warning, "unknown-element"))),
        (at_robot("<constraint name=\"c\"/>"), Some((Error, "loop-unsupported"))),
        (at_robot("<mujoco><compiler/></mujoco>"), None),
        (at_robot("<mujoco><equality/></mujoco>"), Some((Error, "loop-unsupported"))),
        (drake("ball_constraint"), Some((Error, "loop-unsupported"))),
        (drake("distance_constraint"), Some((Warning, "ignored"))),
        (drake("linear_bushing_rpy"), Some((Warning, "ignored"))),
        (drake("linear_spring_damper"), None),
        (drake("weld_constraint"), Some((Error, "loop-unsupported"))),
        (drake("coupler_constraint"), Some((Error, "loop-unsupported"))),
        (at_link("<collision><any/></collision><contact/><self_collision_checking/>"), None),
        (at_link("<kinematic/>"), Some((Note, "ignored"))),
        (at_link("<origin xyz=\"0 0 0\"/>"), Some((Warning, "ignored"))),
        (at_link("<inertail/>"), Some((Warning, "unknown-element"))),
        (at_joint("<calibration rising=\"x\"/><safety_controller k_velocity=\"x\"/>"), None),
        (at_joint("<dynamics damping=\"x\"/>"), Some((Error, "bad-number"))),
        (at_joint("<dynamics damping=\"0.1\" friction=\"\"/>"), None),
        (at_joint("<dynamics damping=\"-0.1\"/>"), Some((Note, "spring-left-out"))),
        (at_robot("<elastic joint=\"swin\" stiffness=\"9\"/>"), Some((Error, "unknown-joint"))),
        (at_robot("<elastic stiffness=\"9\"/>"), Some((Error, "missing-attribute"))),
        (at_joint("<dynamics dumping=\"1\"/>"), Some((Warning, "unknown-attribute"))),
        (at_joint("<frobnicate/>"), Some((Warning, "unknown-element"))),
        (at_joint("loose words"), Some((Warning, "stray-text"))),
        (changed(&[("type=\"revolute\"", "type=\"revolute\" independent=\"True\"")]), None),
        (
            changed(&[("type=\"revolute\"", "type=\"revolute\" independent=\"FALSE\"")]),
            Some((Warning, "unbound-joint")),
        ),
        (
            changed(&[("type=\"revolute\"", "type=\"revolute\" independent=\"perhaps\"")]),
            Some((Warning, "bad-flag")),
        ),
        (changed(&[("name=\"pendulum\"", "name=\"p\" version=\"3\"")]), Some((Warning, "unknown-version"))),
        (changed(&[(" name=\"pendulum\"", "")]), Some((Note, "unnamed-robot"))),
        (changed(&[("effort=\"10\" velocity=\"3\"", "")]), None),
        (changed(&[("lower=\"-1\" upper=\"1.5\"", "")]), Some((Note, "no-limits"))),
        (changed(&[("    <axis xyz=\"0 1 0\"/>\n", "")]), Some((Note, "default-axis"))),
    ];
    for (i, (loaded, expected)) in cases.iter().enumerate() {
        assert_eq!(
            codes(loaded),
            expected.iter().copied().collect::<Vec<_>>(),
            "case {i}: {:?}",
            told(loaded)
        );
        let refused = expected.is_some_and(|(severity, _)| severity == Error);
        assert_eq!(loaded.is_err(), refused, "case {i}");
    }
}

#[test]
fn defaults_are_those_of_urdf() {
    let m = mechanism(&[("    <axis xyz=\"0 1 0\"/>\n", "")]);
    assert_eq!(*m.joints()[0].axis(), Vector3::x());
    // Effort and speed alone define no range; if only one end is given, the other is 0.
    assert_eq!(mechanism(&[("lower=\"-1\" upper=\"1.5\"", "")]).joints()[0].limits(), None);
    let one_end = mechanism(&[(" upper=\"1.5\"", "")]);
    assert_eq!(one_end.joints()[0].limits(), Some(Limits { lower: -1.0, upper: 0.0 }));
    let hand = "<link name=\"hand\"/><joint name=\"wrist\" type=\"prismatic\"><parent link=\"arm\"/>\
                <child link=\"hand\"/><mimic joint=\"hinge\"/></joint></robot>";
    let mimic = mechanism(&[("</robot>", hand)]).joints()[1].mimic().unwrap();
    assert_eq!((mimic.master.index(), mimic.multiplier, mimic.offset), (0, 1.0, 0.0));
}

#[test]
fn partial_inertials_are_taken_as_they_are() {
    let point =
        mechanism(&[("<inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.12\" iyz=\"0\" izz=\"0.03\"/>", "")]);
    let body = point.links()[1].inertia();
    assert_eq!((body.mass, body.rotational), (2.0, Matrix3::from_diagonal(&Vector3::new(0.5, 0.5, 0.0))));
    let flywheel = mechanism(&[("<mass value=\"2\"/>", "<mass value=\"0\"/>")]);
    let body = flywheel.links()[1].inertia();
    assert_eq!((body.mass, body.rotational), (0.0, Matrix3::from_diagonal(&Vector3::new(0.1, 0.12, 0.03))));
    assert!(flywheel.links()[1].has_inertial() && !flywheel.links()[0].has_inertial());
}

#[test]
fn shapes_reach_as_far_as_they_are_declared() {
    let geometry =
        |shapes: &str| mechanism(&[("<visual>", &format!("{shapes}<visual>"))]).links()[1].geometry();
    let sphere =
        "<collision><origin xyz=\"0 3 4\"/><geometry><sphere radius=\"0.5\"/></geometry></collision>";
    assert_eq!(geometry(sphere), Geometry::Within(5.5));
    let capsule = "<collision><geometry><capsule radius=\"1\" length=\"4\"/></geometry></collision>";
    assert_eq!(geometry(capsule), Geometry::Within(3.0));
    let cuboid = "<visual><geometry><box size=\"4 6 12\"/></geometry></visual>";
    assert_eq!(geometry(cuboid), Geometry::Within(7.0));
    let mesh = "<visual><geometry><mesh filename=\"package://none/x.stl\"/></geometry></visual>";
    assert_eq!(geometry(mesh), Geometry::Mesh);
}

#[test]
fn indefinite_inertias_need_the_users_word() {
    let text = PENDULUM.replace("izz=\"0.03\"", "izz=\"-0.03\"");
    let error = load_text(&text).unwrap_err();
    assert_eq!(error.diagnostics[0].code, "indefinite-inertia");
    assert_eq!(error.diagnostics[0].element.as_deref(), Some("robot/link[arm]/inertial/inertia"));
    let options = LoadOptions {
        accept: Accept { indefinite_inertia: true, ..Accept::default() },
        ..LoadOptions::default()
    };
    let loaded = load(&Source::from_text("model.urdf", text), &options).unwrap();
    assert_eq!(
        (loaded.diagnostics[0].severity, loaded.diagnostics[0].code),
        (Severity::Warning, "indefinite-inertia")
    );
}

#[test]
fn a_finding_says_where_it_is() {
    let error = changed(&[("<axis xyz=\"0 1 0\"/>", "<!-- é --> <axis xyz=\"0 q 0\"/>")]).unwrap_err();
    let finding = &error.diagnostics[0];
    assert_eq!((finding.line, finding.column), (Some(8), Some(22)));
    assert_eq!(
        finding.to_string(),
        "model.urdf:8: error: robot/joint[hinge]/axis: xyz=\"0 q 0\": \"q\" is not a number; 3 finite numbers are expected"
    );
}

#[test]
fn repeated_findings_are_told_once() {
    let text = PENDULUM.replace("</robot>", &format!("{}</robot>", "<thing/>".repeat(7)));
    let loaded = load_text(&text).unwrap();
    assert_eq!(loaded.diagnostics.len(), 1);
    assert!(loaded.diagnostics[0].message.ends_with("(6 more like it)"), "{}", loaded.diagnostics[0]);
}

#[test]
fn names_may_hold_what_xml_escapes() {
    let m = mechanism(&[
        ("name=\"arm\"", "name=\"a &lt;&amp;&#x22;é\""),
        ("link=\"arm\"", "link=\"a &lt;&amp;&quot;é\""),
    ]);
    assert_eq!(m.links()[1].name(), "a <&\"é");
}
