//! Attached models. Expected values: MuJoCo 4.0.0.

use crate::support::{Folder, bounded};
use percuss_formats::{LoadError, Loaded};
use percuss_mechanism::Mechanism;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Attached model: radians, fixed axes of Euler angles, a class, a body below a frame, and constraints within and across bodies.
const CHILD: &str = r#"<mujoco model="child"><compiler angle="radian" eulerseq="XYZ"/>
<default><geom density="500"/><default class="c"><joint axis="0 1 0" armature=".1"/></default></default>
<worldbody><site name="ws"/>
<frame name="fr" pos="0 0 2" euler="0 0 1.5">
<body name="a" pos="1 0 0" euler="0 0 0.5" childclass="c"><joint name="j"/><geom type="sphere" size=".1"/>
<body name="b" pos="0 0 1"><joint name="k"/><geom size=".1"/></body></body></frame>
<body name="o"><joint name="oj"/><geom size=".1"/></body></worldbody>
<equality><joint joint1="j" joint2="k" name="e1"/><joint joint1="j" joint2="oj" name="e2"/></equality>
<actuator><motor name="mo" joint="oj" armature="0.5"/></actuator>
</mujoco>"#;

fn main_model(worldbody: &str) -> String {
    format!(
        "<mujoco><compiler angle=\"degree\"/><default><default class=\"z\"><joint armature=\"9\"/><geom density=\"1\"/></default></default>
         <asset><model name=\"ch\" file=\"child.xml\"/></asset><worldbody>{worldbody}</worldbody></mujoco>"
    )
}

fn read(worldbody: &str, child: &str) -> Result<Loaded, LoadError> {
    // Tests run at the same time in one process.
    static NUMBER: AtomicUsize = AtomicUsize::new(0);
    let name = format!("attach-{}", NUMBER.fetch_add(1, Ordering::Relaxed));
    let files = [("main.xml", main_model(worldbody)), ("child.xml", child.to_owned())];
    Folder::new(&name, &files).load("main.xml")
}

fn joint_names(mechanism: &Mechanism) -> Vec<&str> {
    mechanism.joints().iter().map(|joint| joint.name()).collect()
}

#[test]
fn a_body_keeps_the_settings_and_classes_of_its_model() {
    let body = "<body name=\"p\" childclass=\"z\"><joint name=\"pj\"/><geom size=\".1\"/>
        <frame euler=\"0 0 90\"><attach model=\"ch\" body=\"a\" prefix=\"x_\"/></frame></body>";
    let loaded = read(body, CHILD).unwrap();
    let mechanism = &loaded.mechanism;
    assert_eq!(joint_names(mechanism), ["pj", "x_j", "x_k"]);
    let joint = |name: &str| mechanism.joint(mechanism.find_joint(name).unwrap());
    // 90° of the frame in degrees, then 0.5 rad; frames around the body in its model do not count.
    let turned = joint("x_j").origin().vector(&percuss_spatial::Vector3::x());
    let angle = std::f64::consts::FRAC_PI_2 + 0.5;
    assert!((turned.y.atan2(turned.x) - angle).abs() < 1e-14, "{turned}");
    assert_eq!((joint("pj").armature()[0], joint("x_j").armature()[0]), (9.0, 0.1));
    // 500 kg/m³ of the attached model, not the 1 kg/m³ of the class around it.
    let sphere = 4.0 / 3.0 * std::f64::consts::PI * 1e-3;
    let mass = |name: &str| mechanism.link(mechanism.find_link(name).unwrap()).inertial().unwrap().mass;
    assert!((mass("x_a") / (500.0 * sphere) - 1.0).abs() < 1e-14);
    // The relation within the body is attached, that with a joint outside is not, with a warning.
    assert_eq!(mechanism.joint(mechanism.find_joint("x_j").unwrap()).mimic().unwrap().multiplier, 1.0);
    let warnings: Vec<&str> = loaded.diagnostics.iter().map(|d| d.code).collect();
    assert_eq!(warnings, ["attached-part"]);
}

#[test]
fn a_world_a_frame_and_a_part_of_the_own_model_are_attached() {
    let all = read("<attach model=\"ch\" prefix=\"y_\"/>", CHILD).unwrap().mechanism;
    assert_eq!(joint_names(&all), ["y_j", "y_k", "y_oj"]);
    assert_eq!(all.joint(all.find_joint("y_oj").unwrap()).armature(), [0.5]);
    let frame = read("<attach model=\"ch\" frame=\"fr\" prefix=\"r_\"/>", CHILD).unwrap().mechanism;
    assert_eq!(joint_names(&frame), ["r_j", "r_k"]);
    assert_eq!(frame.joint(frame.find_joint("r_j").unwrap()).origin().translation.z, 2.0);
    let own = "<body name=\"q\"><joint name=\"qj\"/><geom size=\".1\"/></body><attach body=\"q\" prefix=\"again_\"/>";
    assert_eq!(joint_names(&read(own, CHILD).unwrap().mechanism), ["qj", "again_qj"]);
}

#[test]
fn defects_are_reported_with_their_line() {
    for (worldbody, code, words) in [
        ("<attach model=\"nobody\" prefix=\"x\"/>", "unknown-reference", "nobody"),
        ("<attach model=\"ch\" body=\"nobody\" prefix=\"x\"/>", "unknown-reference", "nobody"),
        ("<attach model=\"ch\" body=\"a\" frame=\"fr\" prefix=\"x\"/>", "two-notations", "frame"),
        ("<attach prefix=\"x\"/>", "missing-attribute", "body or frame"),
        ("<body name=\"q\"><attach body=\"q\" prefix=\"x\"/></body>", "attach-circle", "<attach>"),
        ("<attach model=\"ch\" body=\"a\" prefx=\"x\"/>", "unknown-attribute", "prefix"),
    ] {
        let error = read(worldbody, CHILD).expect_err("a refusal");
        let first = &error.diagnostics[0];
        assert_eq!(first.code, code, "{first}");
        assert!(first.message.contains(words) && first.line.is_some(), "{first}");
    }
}

#[test]
fn circles_and_explosions_are_bounded() {
    let circle = r#"<mujoco><asset><model name="main" file="main.xml"/></asset><worldbody><attach model="main" prefix="m"/></worldbody></mujoco>"#;
    let error = bounded("a circle", || read("<attach model=\"ch\" prefix=\"x\"/>", circle));
    let error = error.expect_err("a circle");
    assert!(["too-complex", "attach-circle"].contains(&error.diagnostics[0].code), "{error}");
    // Every part attaches the one before a hundred times.
    let copies = |body: &str, name: &str| {
        let all: String =
            (0..100).map(|i| format!("<attach body=\"{body}\" prefix=\"{name}{i}_\"/>")).collect();
        format!("<body name=\"{name}\">{all}</body>")
    };
    let bodies =
        ["b", "c", "d", "e", "f"].windows(2).map(|pair| copies(pair[0], pair[1])).collect::<String>();
    let text = format!("<body name=\"b\"><geom size=\"1\"/></body>{bodies}");
    let error = bounded("copies", || read(&text, CHILD)).expect_err("too many");
    assert_eq!(error.diagnostics[0].code, "too-complex");
    assert!(error.diagnostics[0].line.is_some());
}
