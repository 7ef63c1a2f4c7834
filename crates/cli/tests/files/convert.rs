//! `percuss convert`, and MJCF or SDFormat in place of a URDF.

use crate::support::{Outcome, Scratch, json, percuss, percuss_with_stdin, root};
use serde_json::Value;

/// Models with a contact, and a driving joint.
const CONTACTS: [(&str, &str, &str); 9] = [
    ("antiparallelogram", "--link coupler --point 0.2,0.1,0 --normal 0.3,1,0", ""),
    ("double_pendulum", "--link lower --point 0.1,0,-0.2 --normal 1,0.2,0.1", ""),
    ("double_wishbone", "--link wheel --point 0,0,-0.3 --normal 0.1,0.2,1", ""),
    ("four_bar", "--link coupler --point 0.35,0.1,0 --normal 0.2,1,0", "crank_hinge=0.4"),
    ("macpherson_strut", "--link upright --point 0,0,-0.3 --normal 0.1,0.2,1", ""),
    ("planar_2r", "--link outer --point 0.3,0,0 --normal 0.4,1,0", "shoulder=0.3"),
    ("six_bar", "--link coupler --point 0.1,0.1,0 --normal 0.2,1,0", ""),
    ("six_r_arm", "--link tool --point 0.08,0,0 --normal 0.1,0.2,-1", ""),
    ("slider_crank", "--link slider --point 0.1,0,0 --normal 1,0,0", ""),
];

fn mass(outcome: &Outcome) -> f64 {
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let report: Value = serde_json::from_str(&outcome.stdout).expect("JSON");
    report["effective_mass"].as_f64().unwrap_or_else(|| panic!("{report}"))
}

/// The model written in a format and read again has the same effective mass, or the refusal names an element.
#[test]
fn shipped_models_keep_their_mass() {
    for (ending, format, least) in [("xml", "MJCF", 5), ("sdf", "SDFormat", 6)] {
        let written = convert_and_compare(ending, format);
        assert!(written >= least, "{written} models were written as {format}");
    }
}

/// Number of models that have the same effective mass after their conversion.
fn convert_and_compare(ending: &str, format: &str) -> usize {
    let folder = Scratch::new(&format!("convert-{ending}"));
    let mut written = 0;
    for (model, contact, driver) in CONTACTS {
        let source = format!("models/{model}.urdf");
        let file = folder.path(&format!("{model}.{ending}"));
        let outcome = percuss(&format!("convert {source} -o {file}"));
        if outcome.code != 0 {
            assert_eq!(outcome.code, 2, "{}", outcome.stderr);
            assert!(
                outcome.stderr.contains(&format!("cannot be written as {format}: l")),
                "{}",
                outcome.stderr
            );
            continue;
        }
        let question = |path: &str| {
            let set = if driver.is_empty() { String::new() } else { format!(" --set {driver}") };
            mass(&percuss(&format!("mass {path} {contact}{set} --format json")))
        };
        let (before, after) = (question(&source), question(&file));
        assert!((after / before - 1.0).abs() < 1e-12, "{model}: {before} kg, as {format} {after} kg");
        // Back again: the URDF of the file.
        let back = folder.path(&format!("{model}.urdf"));
        assert_eq!(percuss(&format!("convert {file} -o {back}")).code, 0);
        let again = question(&back);
        assert!((again / before - 1.0).abs() < 1e-12, "{model}: {before} kg, as URDF again {again} kg");
        written += 1;
    }
    written
}

/// The map of a converted model in another folder equals that of the source, for all kinds of shapes and all formats.
#[test]
fn shapes_keep_their_map() {
    let folder = Scratch::new("convert-shapes");
    let map = |file: &str, of_file: &str| {
        let report =
            json(&format!("map {file} --link {of_file} --set shoulder=-40deg --edge 4cm --format json"));
        let link = &report["links"][0];
        let masses = ["smallest", "largest"].map(|end| link[end]["effective_mass"].as_f64().expect("a mass"));
        (link["finite"].as_u64().expect("a count"), masses)
    };
    for ending in ["xml", "sdf", "urdf"] {
        let file = folder.path(&format!("arm.{ending}"));
        let report = json(&format!("convert models/shaped_arm.urdf -o {file} --format json"));
        let changes = report["changes"].as_array().expect("changes");
        let is_shape = |what: String| ["a shape (", "collision> in"].iter().any(|word| what.contains(word));
        assert!(changes.iter().all(|change| !is_shape(change["what"].to_string())), "{changes:#?}");
        for link in ["upper_arm", "forearm", "finger"] {
            let (count, before) = map("models/shaped_arm.urdf", link);
            let (after_count, after) = map(&file, link);
            assert_eq!(count, after_count, "{ending} {link}");
            for (one, two) in before.iter().zip(after) {
                // The frames of shapes are rounded when angles are converted.
                assert!((one / two - 1.0).abs() < 1e-12, "{ending} {link}: {one} {two}");
            }
        }
    }
    let text = std::fs::read_to_string(folder.path("arm.xml")).expect("a file");
    assert!(text.contains("models/meshes/finger.obj\""), "{text}");
    // An output path that climbs out of the current folder.
    let [models, other] = ["models/meshes", "other"].map(|name| folder.path(name));
    for folder in [&models, &other] {
        std::fs::create_dir_all(folder).expect("a folder");
    }
    std::fs::copy(root().join("models/shaped_arm.urdf"), folder.path("models/arm.urdf")).expect("a copy");
    std::fs::copy(root().join("models/meshes/finger.obj"), format!("{models}/finger.obj")).expect("a copy");
    let source = folder.path("models/arm.urdf");
    for ending in ["xml", "sdf", "urdf"] {
        let file = format!("{other}/../other/arm.{ending}");
        assert_eq!(percuss(&format!("convert {source} -o {file}")).code, 0);
        let text = std::fs::read_to_string(&file).expect("a file");
        assert!(
            text.contains("\"../models/meshes/finger.obj\"")
                || text.contains(">../models/meshes/finger.obj<"),
            "{text}"
        );
    }
}

/// Without a contact, `percuss export` writes the same file as `percuss convert`. An impact in SDFormat or URDF is an error.
#[test]
fn export_without_a_contact_writes_the_mechanism() {
    let folder = Scratch::new("export-mechanism");
    for ending in ["xml", "sdf", "urdf"] {
        let [exported, converted] = ["one", "two"].map(|name| folder.path(&format!("{name}.{ending}")));
        assert_eq!(percuss(&format!("export models/four_bar.urdf -o {exported}")).code, 0);
        assert_eq!(percuss(&format!("convert models/four_bar.urdf -o {converted}")).code, 0);
        let text = |file: &str| std::fs::read_to_string(file).expect("a file");
        assert_eq!(text(&exported), text(&converted));
    }
    let contact = "--link coupler --point 0.2,0,0 --normal 1,0,0 --restitution 0.3 --stiffness 1e6";
    for (ending, format) in [("sdf", "SDFormat"), ("urdf", "URDF")] {
        let refused = percuss(&format!(
            "export models/four_bar.urdf {contact} -o {}",
            folder.path(&format!("x.{ending}"))
        ));
        assert_eq!(refused.code, 2);
        assert!(
            refused.stderr.contains(&format!("{format} cannot store the positions")),
            "{}",
            refused.stderr
        );
    }
}

const PENDULUM: &str = r#"<mujoco><worldbody><body name="rod"><joint name="hinge" axis="0 1 0"/>
    <inertial pos="0 0 -0.5" mass="2" diaginertia="1e-9 1e-9 1e-9"/></body></worldbody></mujoco>"#;

#[test]
fn the_content_selects_the_format() {
    // A point mass of 2 kg, 0.5 m below the hinge, hit 0.8 m below it: 2 · (0.5/0.8)².
    let contact = "--link rod --point 0,0,-0.8 --normal 1,0,0 --format json";
    let from_stdin = mass(&percuss_with_stdin(&format!("mass - {contact}"), PENDULUM.as_bytes()));
    assert!((from_stdin - 0.78125).abs() < 1e-8, "{from_stdin}");
    let folder = Scratch::new("mjcf-content");
    let file = folder.path("model.urdf");
    std::fs::write(&file, PENDULUM).expect("a file");
    assert_eq!(mass(&percuss(&format!("mass {file} {contact}"))), from_stdin);
    let check = percuss(&format!("check {file}"));
    assert!(check.stdout.contains("links                  2 (2 kg in all)"), "{}", check.stdout);
}

const SDF_PENDULUM: &str = r#"<sdf version="1.7"><model name="rod"><pose>0 0 2 0 0 0</pose><link name="rod"><inertial>
    <pose>0 0 -0.5 0 0 0</pose><mass>2</mass><inertia><ixx>0</ixx><iyy>0</iyy><izz>0</izz></inertia></inertial></link>
    <joint name="hinge" type="revolute"><parent>world</parent><child>rod</child><axis><xyz>0 1 0</xyz></axis></joint></model>
    <model name="other"><link name="a"/></model></sdf>"#;

#[test]
fn one_model_of_an_sdf_file_is_chosen() {
    let contact = "--link rod --point 0,0,-0.8 --normal 1,0,0 --format json";
    let folder = Scratch::new("sdf-content");
    let file = folder.path("models.sdf");
    std::fs::write(&file, SDF_PENDULUM).expect("a file");
    let several = percuss(&format!("mass {file} {contact}"));
    assert_eq!(several.code, 2);
    assert!(several.stderr.contains("several models: rod, other"), "{}", several.stderr);
    let chosen = mass(&percuss(&format!("mass {file}#rod {contact}")));
    assert!((chosen - 0.78125).abs() < 1e-14, "{chosen}");
    let urdf = folder.path("rod.urdf");
    assert_eq!(percuss(&format!("convert {file}#rod -o {urdf}")).code, 0);
    assert!((mass(&percuss(&format!("mass {urdf} {contact}"))) - 0.78125).abs() < 1e-14);
    // The file that was read is not overwritten.
    let onto_itself = percuss(&format!("convert {file}#rod -o {file}"));
    assert_eq!(onto_itself.code, 2, "{}", onto_itself.stdout);
}

/// A crank and a slide with a reference position, a ball, a follower, and a free body that is drawn turned.
const KEYFRAMES: &str = r#"<mujoco><compiler angle="degree"/><worldbody>
    <body name="a"><joint name="h" axis="0 1 0" ref="30"/><inertial pos="0 0 -.3" mass="2" diaginertia=".1 .1 .1"/>
    <body name="b" pos="0 0 -1"><joint name="s" type="slide" axis="1 0 0" ref="0.1"/><joint name="f" axis="0 1 0"/>
    <inertial pos=".1 0 -.3" mass="1" diaginertia=".1 .2 .1"/></body></body>
    <body name="c" pos="1 0 0" euler="0 0 90"><freejoint name="free"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
    <body name="d"><joint name="ball" type="ball"/><inertial pos=".1 0 .3" mass="1" diaginertia=".1 .2 .1"/></body></body></worldbody>
    <equality><joint joint1="f" joint2="h" polycoef="0 2 0 0 0"/></equality>
    <keyframe><key name="home" qpos="1.2 0.3 1.35 1 2 0 1 0 0 0 0.5 0.5 0.5 0.5"/><key name="drawn"/><key qpos="1 2"/></keyframe></mujoco>"#;

#[test]
fn keyframes_are_named_poses() {
    let folder = Scratch::new("keyframes");
    let file = folder.path("model.xml");
    std::fs::write(&file, KEYFRAMES).expect("a file");
    let check = percuss(&format!("check {file}"));
    assert!(check.stdout.contains("named poses            home, drawn (--pose NAME)"), "{}", check.stdout);
    assert!(
        check.stderr.contains("qpos has 2 numbers; expected 14, the positions of all joints"),
        "{}",
        check.stderr
    );
    let pose = |flags: &str| {
        let contact = "--link b --point 0.1,0.2,-0.3 --normal 1,0.2,0.3 --format json";
        let outcome = percuss(&format!("mass {file} {contact} {flags}"));
        let report: Value =
            serde_json::from_str(&outcome.stdout).unwrap_or_else(|_| panic!("{}", outcome.stderr));
        report["pose"].clone()
    };
    let home = pose("--pose home");
    let numbers = |joint: &str| {
        let list = home[joint].as_array().expect("numbers");
        list.iter().map(|x| x.as_f64().expect("a number")).collect::<Vec<f64>>()
    };
    let near = |joint: &str, expected: &[f64]| {
        let found = numbers(joint);
        let error = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // Roundings of angles and rotations.
        assert!(found.len() == expected.len() && error < 1e-14, "{joint}: {found:?} {expected:?}");
    };
    let reference = std::f64::consts::FRAC_PI_6;
    near("h", &[1.2 - reference]);
    near("s", &[0.3 - 0.1]);
    near("f", &[2.0 * (1.2 - reference)]);
    near("ball", &[0.5, 0.5, 0.5, 0.5]);
    // The body is drawn at (1, 0, 0), turned by 90° about z: the quaternion 1 0 0 0 of MuJoCo is a turn by −90°.
    let half = 0.5f64.sqrt();
    near("free", &[2.0, 0.0, 0.0, half, 0.0, 0.0, -half]);
    assert_eq!(pose("--pose drawn"), pose(""));
    // A position that is set goes over the pose.
    assert_eq!(pose("--pose home --set s=0.05")["s"][0], 0.05);
    let unknown = percuss(&format!("mass {file} --link b --point 0,0,0 --normal 1,0,0 --pose hoem"));
    assert!(
        unknown.code == 2 && unknown.stderr.contains("which has \"home\", \"drawn\""),
        "{}",
        unknown.stderr
    );
    let converted = percuss(&format!("convert {file} -o {}", folder.path("model.urdf")));
    assert!(converted.stdout.contains("pose \"home\": the named pose"), "{}", converted.stdout);
}

const ROTOR: &str = r#"<mujoco><worldbody>
    <body name="a"><joint name="x" axis="0 1 0"/><inertial pos="0 0 -.3" mass="2" diaginertia=".1 .1 .1"/>
    <body name="b" pos="1 0 0"><joint name="y" axis="0 1 0"/><inertial pos="0 0 -.3" mass="2" diaginertia=".1 .1 .1"/></body></body>
    <body name="c" pos="2 0 0"><joint name="z" axis="0 1 0"/><inertial pos="0 0 -.3" mass="2" diaginertia=".1 .1 .1"/></body></worldbody>
    <tendon><fixed name="t" armature=".5"><joint joint="x" coef="1"/><joint joint="SECOND" coef="2"/></fixed></tendon></mujoco>"#;

#[test]
fn rotors_of_tendons_are_written_back() {
    let folder = Scratch::new("rotors");
    for (second, expected) in
        [("y", "<fixed name=\"t\" armature=\"0.5\">"), ("z", "<body name=\"t/rotor\" gravcomp=\"1\">")]
    {
        let [file, back] = ["model.xml", "back.xml"].map(|name| folder.path(&format!("{second}-{name}")));
        std::fs::write(&file, ROTOR.replace("SECOND", second)).expect("a file");
        assert_eq!(percuss(&format!("convert {file} -o {back}")).code, 0);
        let text = std::fs::read_to_string(&back).expect("the file");
        assert!(text.contains(expected), "{text}");
        let contact = format!(
            "--link {} --point 0.1,0.1,-0.4 --normal 1,0,0.3 --format json",
            if second == "y" { "b" } else { "c" }
        );
        let [before, after] = [&file, &back].map(|model| mass(&percuss(&format!("mass {model} {contact}"))));
        assert!((after / before - 1.0).abs() < 1e-12, "{before} {after}");
    }
}
