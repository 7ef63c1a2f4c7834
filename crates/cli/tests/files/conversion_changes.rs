//! `percuss convert` reports everything that it changes or loses: every field of the mechanism that differs in the written file, and every
//! part of a file that is no part of a mechanism.

use crate::support::{Scratch, percuss};
use percuss_formats::load_file;
use percuss_mechanism::{Inertial, JointKind, Mechanism};
use serde_json::Value;

/// Roundings of inertias that are turned, relative.
const ROUNDING: f64 = 1e-12;

/// Elements of a mechanism that another one does not have in the same form: name and field.
fn differences(before: &Mechanism, after: &Mechanism) -> Vec<(String, &'static str)> {
    let mut found = Vec::new();
    for link in before.links() {
        let Ok(other) = after.find_link(link.name()) else {
            found.push((link.name().to_owned(), "link"));
            continue;
        };
        if !same_inertia(link.inertial(), after.link(other).inertial()) {
            found.push((link.name().to_owned(), "inertia"));
        }
    }
    for joint in before.joints() {
        let mut differ = |field| found.push((joint.name().to_owned(), field));
        let Some(other) = after.joints().iter().find(|other| other.name() == joint.name()) else {
            differ("joint");
            continue;
        };
        let kind = |kind: JointKind| if kind == JointKind::Continuous { JointKind::Revolute } else { kind };
        if kind(joint.kind()) != kind(other.kind()) {
            differ("kind");
        }
        if joint.limits().map(|l| [l.lower, l.upper]) != other.limits().map(|l| [l.lower, l.upper]) {
            differ("limits");
        }
        let armature = |joint: &percuss_mechanism::Joint| joint.armature().iter().any(|a| *a != 0.0);
        if (armature(joint) || armature(other)) && joint.armature() != other.armature() {
            differ("armature");
        }
        if joint.independent() != other.independent() {
            differ("role");
        }
        let master = |mechanism: &Mechanism, joint: &percuss_mechanism::Joint| {
            joint.mimic().map(|m| (mechanism.joint(m.master).name().to_owned(), m.multiplier, m.offset))
        };
        if master(before, joint) != master(after, other) {
            differ("mimic");
        }
    }
    for closure in before.closures() {
        let other = after.closures().iter().find(|other| other.name() == closure.name());
        if other.is_none_or(|other| other.kind() != closure.kind()) {
            found.push((closure.name().to_owned(), "loop"));
        }
    }
    for coupling in before.couplings() {
        let other = after.couplings().iter().find(|other| other.name() == coupling.name());
        let terms = |of: &percuss_mechanism::Coupling| of.terms().len();
        if other.is_none_or(|other| {
            terms(other) != terms(coupling) || other.ratio().is_some() != coupling.ratio().is_some()
        }) {
            found.push((coupling.name().to_owned(), "coupling"));
        }
    }
    for contact in before.contacts() {
        let other = after.contacts().iter().find(|other| other.name() == contact.name());
        let against = |mechanism: &Mechanism, of: &percuss_mechanism::NamedContact| {
            of.against()
                .filter(|link| *link != mechanism.root())
                .map(|link| mechanism.link(link).name().to_owned())
        };
        let is_same = |other: &percuss_mechanism::NamedContact| {
            other.kind() == contact.kind()
                && other.gap() == contact.gap()
                && against(after, other) == against(before, contact)
                && std::mem::discriminant(other.normal()) == std::mem::discriminant(contact.normal())
        };
        if !other.is_some_and(is_same) {
            found.push((contact.name().to_owned(), "contact"));
        }
    }
    found
}

/// True for equal inertias; a link without an inertia is one of mass 0.
fn same_inertia(a: Option<&Inertial>, b: Option<&Inertial>) -> bool {
    let zero = Inertial::diagonal(0.0, [0.0; 3], [0.0; 3]);
    let (a, b) = (a.unwrap_or(&zero), b.unwrap_or(&zero));
    let near = |x: f64, y: f64, scale: f64| (x - y).abs() <= ROUNDING * scale;
    near(a.mass, b.mass, a.mass)
        && (a.mass == 0.0 || a.com.iter().zip(b.com.iter()).all(|(x, y)| near(*x, *y, 1.0)))
        && a.about_com.iter().zip(b.about_com.iter()).all(|(x, y)| near(*x, *y, a.about_com.amax()))
}

/// URDF files of all shipped models: the mechanisms, and the suspensions of the templates.
fn shipped_models(folder: &Scratch) -> Vec<String> {
    let own = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models");
    let files = std::fs::read_dir(own).expect("the models").flatten();
    let paths = files.map(|file| file.path().to_string_lossy().into_owned());
    let mut models: Vec<String> = paths.filter(|path| path.ends_with(".urdf")).collect();
    let listed = percuss("template --list").stdout;
    for name in
        listed.lines().filter(|line| !line.starts_with(' ')).filter_map(|line| line.split_whitespace().next())
    {
        let (sheet, file) = (folder.path(&format!("{name}.toml")), folder.path(&format!("{name}.urdf")));
        if percuss(&format!("template {name} -o {sheet}")).code == 0 {
            assert_eq!(percuss(&format!("convert {sheet} -o {file}")).code, 0, "{name}");
            models.push(file);
        }
    }
    models.sort();
    models
}

fn report(command: &str) -> Option<Value> {
    let outcome = percuss(command);
    if outcome.code != 0 {
        assert_eq!(outcome.code, 2, "{}", outcome.stderr);
        let refusal = ["link \"", "loop \"", "joint \"", "coupling \""];
        assert!(refusal.iter().any(|element| outcome.stderr.contains(element)), "{}", outcome.stderr);
        return None;
    }
    Some(serde_json::from_str(&outcome.stdout).expect("a report"))
}

#[test]
fn every_difference_of_a_written_model_is_reported() {
    let folder = Scratch::new("conversion-changes");
    let models = shipped_models(&folder);
    assert!(models.len() > 30, "{} models", models.len());
    let (mut written, mut counted) = ([0; 3], 0);
    for model in &models {
        let before = load_file(model).expect("a shipped model").mechanism;
        for (number, ending) in ["xml", "sdf", "urdf"].into_iter().enumerate() {
            let file = folder.path(&format!("written.{ending}"));
            let Some(report) = report(&format!("convert {model} -o {file} --format json --force")) else {
                continue;
            };
            written[number] += 1;
            let after = load_file(&file).expect("the written model").mechanism;
            let changes = report["changes"].as_array().expect("changes");
            let text = |change: &Value, key: &str| change[key].as_str().unwrap_or_default().to_owned();
            for (name, field) in differences(&before, &after) {
                counted += 1;
                let quoted = format!("\"{name}\"");
                let is_named = |change: &Value| {
                    text(change, "element").contains(&quoted) || text(change, "what").contains(&quoted)
                };
                assert!(
                    changes.iter().any(is_named),
                    "{model} as {ending}: {field} of {quoted} is not in {changes:#?}"
                );
            }
        }
    }
    // Every model has a form in URDF+; the refusals of the others name an element.
    assert_eq!(written[2], models.len());
    assert!(written[0] > 20 && written[1] > 5 && counted > 200, "{written:?} {counted}");
}

/// Parts of a file that are no part of a mechanism: one for each format.
#[test]
fn parts_that_are_not_read_are_reported() {
    let folder = Scratch::new("conversion-unread");
    let mjcf = r#"<mujoco><option timestep="0.01"/><worldbody><body name="a"><joint name="j" frictionloss="2" margin="3"/>
        <geom size="0.1" friction="1 0 0"/><camera name="c"/></body></worldbody><sensor><jointpos joint="j"/></sensor></mujoco>"#;
    let sdf = r#"<sdf version="1.7"><model name="m"><link name="a"><inertial><mass>1</mass></inertial><sensor name="s" type="imu"/>
        <visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry><material/></visual></link><joint name="j" type="revolute">
        <parent>world</parent><child>a</child><axis><xyz>0 0 1</xyz><dynamics><friction>2</friction></dynamics></axis></joint></model></sdf>"#;
    let urdf = r#"<robot name="r"><link name="w"/><link name="a"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0"
        izz="1"/></inertial><visual><geometry><sphere radius="1"/></geometry><material name="red"/></visual></link><joint name="j" type="continuous">
        <parent link="w"/><child link="a"/><dynamics friction="2"/></joint><transmission name="t"/><cable/></robot>"#;
    for (name, text, expected) in [
        (
            "a.xml",
            mjcf,
            ["frictionloss of <joint>", "margin of <joint>", "<camera>", "<sensor>", "timestep of <option>"]
                .as_slice(),
        ),
        (
            "a.sdf",
            sdf,
            ["<sensor> in <link>", "<friction> in <dynamics>", "<material> in <visual>"].as_slice(),
        ),
        (
            "a.urdf",
            urdf,
            [
                "friction of <dynamics>",
                "name of <transmission>",
                "unknown element <cable>",
                "<material> in <visual>",
            ]
            .as_slice(),
        ),
    ] {
        let (file, output) = (folder.path(name), folder.path("out.urdf"));
        std::fs::write(&file, text).expect("a file");
        let report = report(&format!("convert {file} -o {output} --format json --force")).expect("a report");
        let changes = report["changes"].as_array().expect("changes");
        for part in expected {
            let found =
                changes.iter().find(|change| change["what"].as_str().is_some_and(|what| what.contains(part)));
            let Some(found) = found else { panic!("{name}: {part} is not in {changes:#?}") };
            assert_eq!(found["effect"], "lost", "{name}: {part}");
            assert!(found["line"].as_u64().is_some(), "{name}: {part} has no line");
        }
        // Only the materials of shapes are lost.
        let is_shape = |what: String| {
            ["a shape (", "visual> in", "collision> in"].iter().any(|word| what.contains(word))
        };
        assert!(changes.iter().all(|change| !is_shape(change["what"].to_string())), "{changes:#?}");
        // Without a conversion these parts are silent.
        assert!(!percuss(&format!("check {file} --notes")).stderr.contains("no part of a mechanism"));
    }
}
