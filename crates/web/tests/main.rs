//! Tests of the engine of the explorer, natively: the module has the same functions.

use base64::Engine;
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_study::{
    Changes, ContactTable, DampingQuestion, KinematicVariable, KinematicsQuestion, MassQuestion, Model,
    WheelMotion, damp_contact, kinematics, mass,
};
use percuss_web::{Session, percuss_answer, percuss_reply, percuss_request};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Largest distance of points that coincide in exact arithmetic, m: coordinates are of the order of 1 m, and loops are closed
/// to 1e-10 of the size of the mechanism.
const SAME_POINT: f64 = 1e-8;

/// Largest relative difference of two computations of one number: masses of these models are known to 1e-12.
const RELATIVE: f64 = 1e-9;

fn models() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models")
}

/// Shipped models of one text file: URDF files and sheets without a table of points.
fn shipped() -> Vec<PathBuf> {
    let folders = [models(), models().join("suspensions")];
    let mut found: Vec<PathBuf> = folders
        .iter()
        .flat_map(|folder| std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()))
        .filter(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let is_sheet = path.parent().unwrap().ends_with("suspensions");
            name.ends_with(".urdf") || is_sheet && name.ends_with(".toml") && !name.contains("with-table")
        })
        .collect();
    found.sort();
    assert!(found.len() > 30, "only {} models were found", found.len());
    found
}

fn ask(session: &mut Session, request: &Value) -> Value {
    serde_json::from_slice(&session.answer(request.to_string().as_bytes())).expect("a reply in JSON")
}

fn open(session: &mut Session, path: &Path) -> Value {
    let text = std::fs::read_to_string(path).unwrap();
    let name = path.to_string_lossy();
    let reply = ask(session, &json!({ "do": "open", "model": { "path": name }, "text": text }));
    assert!(reply["ok"].is_object(), "{name}: {reply}");
    reply["ok"].clone()
}

fn double_wishbone() -> PathBuf {
    models().join("suspensions/double-wishbone.toml")
}

/// Frame of a link in a list of frames: rows of the rotation, and position.
fn point_at(frames: &Value, link: usize, point: &Value) -> [f64; 3] {
    let number = |i: usize| frames[12 * link + i].as_f64().unwrap();
    let p: Vec<f64> = point.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    [0, 1, 2].map(|i| (0..3).map(|j| number(3 * i + j) * p[j]).sum::<f64>() + number(9 + i))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn every_shipped_model_has_the_mass_of_the_library() {
    for path in shipped() {
        let mut session = Session::new();
        let opened = open(&mut session, &path);
        let question = json!({ "model": { "path": path.to_string_lossy() }, "contact": opened["contact"],
                               "conditions": opened["conditions"] });
        let reply = ask(&mut session, &json!({ "do": "show", "question": question }));
        let report = &reply["ok"]["result"]["ok"]["report"];
        let model = Model::load(&path.to_string_lossy(), DEFAULT_MAX_SIZE, &LoadOptions::default()).unwrap();
        let contact = &report["contact"];
        let triple = |key: &str| [0, 1, 2].map(|i| contact[key][i].as_f64().unwrap());
        let mut native = match opened["contact"]["at"].as_str() {
            Some(name) => MassQuestion::default().at_contact(name),
            None => {
                let link = opened["contact"]["link"].as_str().expect("a link");
                let contact = ContactTable::at_point(link, triple("point_link"), triple("normal_link"));
                MassQuestion { contact, ..MassQuestion::default() }
            }
        };
        let is_floating = report["conditions"]["base"] == "floating";
        native.conditions.base = is_floating.then_some(percuss_study::BaseName::Floating);
        let expected = mass(&model, &native).unwrap();
        assert_eq!(report["effective_mass"].as_f64(), expected.effective_mass, "{}", path.display());
        assert_eq!(report["status"], json!(expected.status), "{}", path.display());
    }
}

#[test]
fn frames_close_the_loops_at_any_travel() {
    for path in shipped() {
        let mut session = Session::new();
        let opened = open(&mut session, &path);
        let scene = &opened["scene"];
        let motion = scene["motions"][0].as_str();
        let travel = motion.map_or_else(|| json!([]), |motion| json!([format!("{motion}=12mm")]));
        let question = json!({ "model": { "path": path.to_string_lossy() }, "contact": opened["contact"],
                               "conditions": opened["conditions"], "pose": { "travel": travel } });
        let reply = ask(&mut session, &json!({ "do": "show", "question": question }));
        let frames = &reply["ok"]["result"]["ok"]["frames"];
        assert_eq!(frames.as_array().unwrap().len(), 12 * scene["links"].as_array().unwrap().len());
        for closure in scene["closures"].as_array().unwrap() {
            // Other kinds leave a distance between the ends.
            if !["spherical", "revolute", "fixed", "universal"].contains(&closure["kind"].as_str().unwrap()) {
                continue;
            }
            let end = |i: usize| {
                let link = closure["ends"][i][0].as_u64();
                let point = &closure["ends"][i][1];
                link.map(|link| point_at(frames, usize::try_from(link).unwrap(), point))
            };
            if let (Some(a), Some(b)) = (end(0), end(1)) {
                assert!(distance(a, b) < SAME_POINT, "{}: {}", path.display(), closure["name"]);
            }
        }
    }
}

#[test]
fn hardpoints_are_at_their_coordinates_in_the_design_position() {
    let (mut points, mut carried) = (0, 0);
    for path in shipped() {
        let opened = open(&mut Session::new(), &path);
        let scene = &opened["scene"];
        for point in scene["sheet"]["hardpoints"].as_array().unwrap_or(&Vec::new()) {
            let link = usize::try_from(point["link"].as_u64().unwrap()).unwrap();
            let at = point_at(&scene["design"], link, &point["point"]);
            let given = [0, 1, 2]
                .map(|k| point["coordinates"][k].as_f64().unwrap() * point["to_world"][k].as_f64().unwrap());
            assert!(distance(at, given) < SAME_POINT, "{}: {}", path.display(), point["name"]);
            points += 1;
            carried += usize::from(point["link"] != scene["root"]);
        }
    }
    // The others are on the chassis: seats of springs, and stops.
    assert!(points > 300 && carried * 10 > points * 7, "{carried} of {points} hardpoints move with a link");
}

#[test]
fn a_moved_hardpoint_gives_the_mass_of_the_moved_design() {
    let mut session = Session::new();
    let path = double_wishbone();
    open(&mut session, &path);
    let shift = [0.0, 0.002, 0.005];
    let table = |moves: Value| json!({ "path": path.to_string_lossy(), "move": moves });
    let asked = |moves: Value| json!({ "model": table(moves), "contact": { "at": "spring" } });
    let show = |session: &mut Session, moves: Value| {
        ask(session, &json!({ "do": "show", "question": asked(moves) }))
    };
    let reply = show(&mut session, json!({ "lower_ball": shift }));
    let model = Model::load(&path.to_string_lossy(), DEFAULT_MAX_SIZE, &LoadOptions::default()).unwrap();
    let moved = model
        .with_changes(&Changes { moves: vec![("lower_ball".into(), shift)], ..Changes::default() })
        .unwrap();
    let question = MassQuestion::default().at_contact("spring");
    let expected = mass(&moved, &question).unwrap().effective_mass;
    assert_eq!(reply["ok"]["result"]["ok"]["report"]["effective_mass"].as_f64(), expected);
    assert!(reply["ok"]["scene"].is_object(), "the scene has changed");
    let moved_question = asked(json!({ "lower_ball": shift }));
    let curve = json!({ "do": "curve", "question": moved_question, "vary": "wheel-travel=-20mm:40mm:7" });
    let rows = ask(&mut session, &curve)["ok"]["rows"].as_array().unwrap().clone();
    assert_eq!(rows.len(), 7);
    assert!(rows.iter().all(|row| row["mass"].as_f64().is_some()));
    // The row at no travel is the pose of the question.
    assert_eq!(rows[2]["at"].as_f64(), Some(0.0));
    let at_design = rows[2]["mass"].as_f64().unwrap();
    let error = rows[2]["error"].as_f64().unwrap() + 1e-9;
    assert!((at_design - expected.unwrap()).abs() <= error);
    // Without the moves the first design is back, and the same request again has no scene.
    let back = show(&mut session, json!({}));
    let first = mass(&model, &question).unwrap().effective_mass;
    assert_eq!(back["ok"]["result"]["ok"]["report"]["effective_mass"].as_f64(), first);
    assert!(back["ok"]["scene"].is_object());
    assert!(show(&mut session, json!({}))["ok"]["scene"].is_null());
}

#[test]
fn a_travel_out_of_reach_is_explained_and_the_session_goes_on() {
    let mut session = Session::new();
    let path = double_wishbone();
    open(&mut session, &path);
    let show = |session: &mut Session, travel: &str| {
        let question = json!({ "model": { "path": path.to_string_lossy() }, "contact": { "at": "spring" },
                               "pose": { "travel": [travel] } });
        ask(session, &json!({ "do": "show", "question": question }))
    };
    let refused = show(&mut session, "wheel-travel=900mm")["ok"]["result"]["refused"].clone();
    assert_eq!(refused["no_result"], json!(true));
    assert!(refused["message"].as_str().unwrap().contains("reach"), "{refused}");
    assert!(show(&mut session, "wheel-travel=9mm")["ok"]["result"]["ok"].is_object());
}

#[test]
fn further_results_are_those_of_the_library() {
    let mut session = Session::new();
    let path = double_wishbone();
    open(&mut session, &path);
    let table = json!({ "path": path.to_string_lossy(), "move": { "lower_ball": [0.0, 0.0, 0.005] } });
    let question = json!({ "model": table, "contact": { "at": "spring" } });
    let model = Model::load(&path.to_string_lossy(), DEFAULT_MAX_SIZE, &LoadOptions::default())
        .unwrap()
        .with_changes(&Changes {
            moves: vec![("lower_ball".into(), [0.0, 0.0, 0.005])],
            ..Changes::default()
        })
        .unwrap();
    let native = MassQuestion::default().at_contact("spring");
    let m = mass(&model, &native).unwrap().effective_mass.unwrap();
    let damping = json!({ "restitution": 0.3, "stiffness": "200 N/mm", "speed": 1.0, "for": "mujoco" });
    let reply = ask(&mut session, &json!({ "do": "damp", "question": question, "damping": damping }));
    let mut wanted = DampingQuestion::new(0.3, 2e5);
    wanted.speed = Some(1.0.into());
    let expected = damp_contact(&model, &native, &wanted).unwrap();
    assert_eq!(reply["ok"]["damping"].as_f64(), expected.damper.damping, "{reply}");
    assert!(reply["ok"]["exports"]["mujoco"]["snippet"].as_str().unwrap().contains("solref"));
    let impact = json!({ "restitution": 0.3, "speed": 1.0 });
    let reply = ask(&mut session, &json!({ "do": "impact", "question": question, "impact": impact }));
    // p = (1 + e) m v.
    let impulse = reply["ok"]["impulse"].as_f64().unwrap();
    assert!((impulse / (1.3 * m) - 1.0).abs() < RELATIVE, "{impulse} N·s");
    let state = json!({ "wheel-travel": 0.02, "steer": 0.0 });
    let reply = ask(&mut session, &json!({ "do": "kinematics", "model": table, "state": state }));
    let wanted = KinematicsQuestion {
        state: vec![
            (KinematicVariable::Steer, 0.0),
            (KinematicVariable::Wheels(WheelMotion::WheelTravel), 0.02),
        ],
        ..KinematicsQuestion::default()
    };
    let expected = serde_json::to_value(kinematics(&model, &wanted).unwrap()).unwrap();
    assert!(expected["rows"][0]["camber"].is_number());
    assert_eq!(reply["ok"]["rows"], expected["rows"]);
    let unknown =
        ask(&mut session, &json!({ "do": "kinematics", "model": table, "state": { "speed": 1.0 } }));
    assert!(unknown["refused"]["message"].as_str().unwrap().contains("wheel-travel"), "{unknown}");
}

/// Crane with a site, two keyframes and a limited hinge. Inertia of the boom about the hinge: 9 + 12 · 1.5² = 36 kg·m²; length: 3 m.
const CRANE: &str = r#"<mujoco model="crane"><compiler angle="radian"/>
  <worldbody><body name="mast"><joint name="slew" axis="0 0 1"/><inertial pos="0 0 1" mass="40" diaginertia="14 14 1"/>
    <body name="boom" pos="0 0 2"><joint name="luff" axis="0 -1 0" range="-0.2 1.2"/>
      <inertial pos="1.5 0 0" mass="12" diaginertia="0.1 9 9"/><site name="hook" pos="3 0 0"/></body></body></worldbody>
  <keyframe><key name="rest" qpos="0 0"/><key name="raised" qpos="0.4 0.9"/></keyframe></mujoco>"#;

/// The boom of the crane in SDFormat.
const BOOM: &str = r#"<sdf version="1.9"><model name="boom">
  <joint name="luff" type="revolute"><parent>world</parent><child>boom</child><axis><xyz>0 -1 0</xyz></axis></joint>
  <link name="boom"><inertial><pose>1.5 0 0 0 0 0</pose><mass>12</mass>
    <inertia><ixx>0.1</ixx><iyy>9</iyy><izz>9</izz></inertia></inertial></link></model></sdf>"#;

fn assert_same(found: &Value, expected: f64, what: &str) {
    let found = found.as_f64().unwrap_or_else(|| panic!("{what}: {found}"));
    assert!((found / expected - 1.0).abs() < RELATIVE, "{what}: {found} instead of {expected}");
}

#[test]
fn keyframes_are_poses_and_stops_of_joints_have_their_inertia() {
    let mut session = Session::new();
    let open = json!({ "do": "open", "model": { "path": "crane.xml" }, "text": CRANE });
    let opened = ask(&mut session, &open)["ok"].clone();
    assert_eq!(opened["poses"], json!(["rest", "raised"]));
    let question =
        |pose: Value| json!({ "model": { "path": "crane.xml" }, "contact": { "at": "hook" }, "pose": pose });
    let reply =
        ask(&mut session, &json!({ "do": "show", "question": question(json!({ "file": "raised" })) }));
    let report = &reply["ok"]["result"]["ok"]["report"];
    // The hook rises by 3 cos φ m per radian of the hinge.
    assert_same(&report["effective_mass"], 36.0 / (3.0 * 0.9_f64.cos()).powi(2), "raised");
    assert_eq!(report["pose"]["luff"], json!([0.9]));
    let unknown =
        ask(&mut session, &json!({ "do": "show", "question": question(json!({ "file": "lowered" })) }));
    let message = unknown["ok"]["result"]["refused"]["message"].to_string();
    assert!(message.contains("lowered") && message.contains("raised"), "{unknown}");
    let damping = |stiffness: &str| json!({ "restitution": 0.3, "stiffness": stiffness, "speed": "1 rad/s", "limit": "luff:upper" });
    let damp = |stiffness: &str| json!({ "do": "damp", "question": question(json!({})), "damping": damping(stiffness) });
    let damped = ask(&mut session, &damp("2000 Nm/rad"));
    assert_same(&damped["ok"]["effective_mass"], 36.0, "inertia at the stop");
    assert_eq!(damped["ok"]["stop"], json!({ "joint": "luff", "motion": "turn" }));
    let refused = ask(&mut session, &damp("200 N/mm"));
    assert!(refused["refused"]["message"].to_string().contains("rad"), "{refused}");
}

#[test]
fn sdformat_is_read() {
    let mut session = Session::new();
    let opened = ask(&mut session, &json!({ "do": "open", "model": { "path": "boom.sdf" }, "text": BOOM }));
    assert!(opened["ok"].is_object(), "{opened}");
    let question = json!({ "model": { "path": "boom.sdf" },
                           "contact": { "link": "boom", "point": [3, 0, 0], "normal": [0, 0, 1] } });
    let reply = ask(&mut session, &json!({ "do": "show", "question": question }));
    assert_same(&reply["ok"]["result"]["ok"]["report"]["effective_mass"], 4.0, "at the tip");
}

/// Base64 of texts, by file name.
fn packed(files: &[(&str, &str)]) -> Value {
    let encode = |text: &str| base64::engine::general_purpose::STANDARD.encode(text);
    files
        .iter()
        .map(|(name, text)| ((*name).to_owned(), json!(encode(text))))
        .collect::<serde_json::Map<_, _>>()
        .into()
}

/// Tetrahedron with three edges of 1 m along the axes.
const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#[test]
fn a_folder_has_the_included_files_and_the_meshes() {
    let mut session = Session::new();
    let mut open = |path: &str, text: &str, files: Value| {
        let request =
            json!({ "do": "open", "model": { "path": path }, "text": text, "files": files, "shapes": true });
        ask(&mut session, &request)
    };
    // The inertia of the body follows from the mesh: a density of 6000 kg/m³ and a volume of 1/6 m³ give 1000 kg.
    let scene = "<mujoco><include file=\"arm.xml\"/></mujoco>";
    let arm = "<mujocoinclude><asset><mesh name=\"t\" file=\"meshes/t.obj\"/></asset><worldbody><body name=\"arm\"><joint/>
        <geom type=\"mesh\" mesh=\"t\" density=\"6000\"/></body></worldbody></mujocoinclude>";
    let files = packed(&[("robot/arm.xml", arm), ("robot/meshes/t.obj", TETRAHEDRON)]);
    let opened = open("robot/scene.xml", scene, files.clone());
    let link = opened["ok"]["scene"]["links"].as_array().unwrap().iter().find(|link| link["name"] == "arm");
    let arm_link = link.unwrap_or_else(|| panic!("{opened}")).clone();
    assert_same(&arm_link["mass"], 1000.0, "mass of the tetrahedron");
    // About the centre of mass (1/4, 1/4, 1/4): m (1/10 + 1/10) − m (1/16 + 1/16) = 3/40 m, for edges of 1 m.
    for k in 0..3 {
        assert_same(&arm_link["moments"][k], 75.0, "moment of the tetrahedron");
    }
    let missing = open("robot/scene.xml", scene, json!({}));
    assert!(missing["refused"]["message"].as_str().unwrap().contains("arm.xml"), "{missing}");
    // A mesh of a package is found in a folder with the name of the package, even if no parent folder of the model contains that folder.
    let urdf = r#"<robot name="r"><link name="a"><visual><geometry><mesh filename="package://parts/t.obj"/></geometry></visual>
        <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>"#;
    let opened = open("ws/robot/r.urdf", urdf, packed(&[("ws/meshes/parts/t.obj", TETRAHEDRON)]));
    let shape = opened["ok"]["shapes"]["links"][0].as_str().unwrap_or_else(|| panic!("{opened}")).to_owned();
    let triangles = base64::engine::general_purpose::STANDARD.decode(shape).unwrap();
    assert_eq!(triangles.len(), 4 * 9 * 4, "four triangles of nine numbers");
    let without = open("ws/robot/r.urdf", urdf, json!({}));
    assert!(without["ok"]["shapes"]["links"][0].is_null());
    let finding = without["ok"]["shapes"]["diagnostics"][0]["message"].as_str().unwrap();
    assert!(finding.contains("t.obj"), "{finding}");
    let damaged = open("r.urdf", urdf, json!({ "a": "***" }));
    assert!(damaged["refused"]["message"].as_str().unwrap().contains("base64"), "{damaged}");
}

/// A sheet with its points in a table gives the same results as the sheet that contains the points, also with moved points.
#[test]
fn a_sheet_has_its_table() {
    let text = std::fs::read_to_string(double_wishbone()).unwrap();
    let (head, points, rest) = {
        let from = text.find("\n[points]").unwrap() + 1;
        let to = from + text[from + 1..].find("\n[").unwrap() + 2;
        (&text[..from], &text[from..to], &text[to..])
    };
    let csv: String = points
        .lines()
        .filter_map(|line| {
            let (name, list) = line.split('#').next().unwrap().split_once('=')?;
            Some(format!("{},{}\n", name.trim(), list.trim().trim_matches(['[', ']'])))
        })
        .collect();
    let sheet = format!("points = \"points.csv\"\n{head}{rest}");
    let mass = |name: &str, text: &str, files: Value, moves: Value| {
        let mut session = Session::new();
        let request = json!({ "do": "open", "model": { "path": name }, "text": text, "files": files });
        let opened = ask(&mut session, &request);
        assert!(opened["ok"].is_object(), "{opened}");
        let question = json!({ "model": { "path": name, "move": moves }, "contact": { "at": "spring" } });
        let reply = ask(&mut session, &json!({ "do": "show", "question": question }));
        reply["ok"]["result"]["ok"]["report"]["effective_mass"].as_f64().expect("a finite mass")
    };
    let files = packed(&[("car/points.csv", &format!("name,x,y,z\n{csv}"))]);
    for moves in [json!({}), json!({ "lower_ball": [0.0, 0.0, 0.005] })] {
        let expected = mass("car/whole.toml", &text, json!({}), moves.clone());
        assert_eq!(mass("car/sheet.toml", &sheet, files.clone(), moves), expected);
    }
}

#[test]
fn moments_of_inertia_are_changed() {
    let mut session = Session::new();
    ask(&mut session, &json!({ "do": "open", "model": { "path": "boom.sdf" }, "text": BOOM }));
    let mass = |session: &mut Session, changes: Value| {
        let mut model = json!({ "path": "boom.sdf" });
        model.as_object_mut().unwrap().extend(changes.as_object().unwrap().clone());
        let question =
            json!({ "model": model, "contact": { "link": "boom", "point": [3, 0, 0], "normal": [0, 0, 1] } });
        ask(session, &json!({ "do": "show", "question": question }))["ok"].clone()
    };
    let of = |shown: &Value| shown["result"]["ok"]["report"]["effective_mass"].clone();
    let first = mass(&mut session, json!({}));
    // m̄ = J/r²: nine more kg·m² about the hinge, 3 m from the contact, add 1 kg.
    let boom = |shown: &Value| {
        let links = shown["scene"]["links"].as_array().unwrap().clone();
        links.iter().find(|link| link["name"] == "boom").unwrap()["moments"].clone()
    };
    let large = mass(&mut session, json!({ "link_inertia": { "boom": [9, 18, 9] } }));
    assert_eq!(boom(&large), json!([9.0, 18.0, 9.0]));
    let larger = mass(&mut session, json!({ "link_inertia": { "boom": [9, 9, 9] } }));
    assert_same(&of(&larger), of(&large).as_f64().unwrap() - 1.0, "9 kg·m² less");
    assert_eq!(of(&mass(&mut session, json!({}))), of(&first));
}

#[test]
fn a_cable_pulls_along_its_line() {
    let mut session = Session::new();
    ask(&mut session, &json!({ "do": "open", "model": { "path": "boom.sdf" }, "text": BOOM }));
    // The cable runs from the tip to a point 3 m above the hinge, at 45°. Its lever arm is 3/√2 m.
    let contact = json!({ "link": "boom", "point": [3, 0, 0], "along_line": { "link": "world", "point": [0, 0, 3] },
                          "cable": true });
    let question = json!({ "model": { "path": "boom.sdf" }, "contact": contact });
    let reply = ask(&mut session, &json!({ "do": "show", "question": question }));
    let report = &reply["ok"]["result"]["ok"]["report"];
    assert_same(&report["effective_mass"], 8.0, "along the cable");
    // Lengthening of the cable closes the gap: the normal points from the far end of the cable to the contact point.
    assert_same(&report["contact"]["normal_world"][0], 0.5_f64.sqrt(), "x");
    assert_same(&report["contact"]["normal_world"][2], -0.5_f64.sqrt(), "z");
}

#[test]
fn a_safe_speed_needs_a_limit() {
    let mut session = Session::new();
    let path = models().join("six_r_arm.urdf");
    open(&mut session, &path);
    let contact = json!({ "link": "tool", "point": [0.08, 0.0, 0.0], "normal": [0.0, 0.0, -1.0] });
    let question = json!({ "model": { "path": path.to_string_lossy() }, "contact": contact });
    let mut ask_speed = |table: Value| {
        ask(&mut session, &json!({ "do": "safe-speed", "question": question, "safe_speed": table }))
    };
    let refused = ask_speed(json!({ "region": "chest" }));
    assert!(refused["refused"]["message"].as_str().unwrap().contains("one limit is required"), "{refused}");
    let found = ask_speed(json!({ "region": "chest", "force": 140.0 }));
    assert!(found["ok"][0]["reflected"]["speed"].as_f64().unwrap() > 0.0, "{found}");
}

/// A map in one request has the masses of single questions, and the principal directions give the mass of every normal.
#[test]
fn maps_and_directions_are_single_questions() {
    let mut session = Session::new();
    let path = models().join("six_r_arm.urdf");
    open(&mut session, &path);
    let pose = json!({ "set": { "elbow": 0.7, "shoulder": -0.4 } });
    let contacts: Vec<[f64; 6]> = (0..20)
        .map(|i| {
            let turn = f64::from(i) * 0.7;
            [0.05 * turn.cos(), 0.05 * turn.sin(), 0.01 * f64::from(i), turn.sin(), 0.3, turn.cos()]
        })
        .collect();
    let question = |contact: &[f64; 6]| {
        json!({ "model": { "path": path.to_string_lossy() }, "pose": pose,
                "contact": { "link": "tool", "point": contact[..3], "normal": contact[3..] } })
    };
    let mut mass_of = |contact: &[f64; 6]| {
        let reply = ask(&mut session, &json!({ "do": "show", "question": question(contact) }));
        reply["ok"]["result"]["ok"]["report"]["effective_mass"].as_f64().expect("a finite mass")
    };
    let single: Vec<f64> = contacts.iter().map(&mut mass_of).collect();
    let request =
        json!({ "do": "map", "question": question(&contacts[0]), "link": "tool", "contacts": contacts });
    let reply = ask(&mut session, &request);
    let map = reply["ok"].as_array().expect("masses").clone();
    assert_eq!(map.len(), contacts.len());
    for (found, expected) in map.iter().zip(&single) {
        assert!(
            (found["effective_mass"].as_f64().unwrap() / expected - 1.0).abs() < RELATIVE,
            "{found}, {expected}"
        );
    }
    let reply = ask(&mut session, &json!({ "do": "directions", "question": question(&contacts[3]) }));
    let axes = reply["ok"]["principal"].as_array().expect("three axes").clone();
    assert_eq!(axes.len(), 3);
    let normal = &contacts[3][3..];
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    let inverse: f64 = axes
        .iter()
        .map(|axis| {
            let along: f64 = (0..3).map(|k| normal[k] * axis["direction_link"][k].as_f64().unwrap()).sum();
            axis["effective_mass"].as_f64().map_or(0.0, |m| (along / length).powi(2) / m)
        })
        .sum();
    assert!((inverse * single[3] - 1.0).abs() < RELATIVE, "{inverse}, {}", single[3]);
}

/// The contacts of a changed design have the masses of the library, and sensitivities to some hardpoints are a part of all sensitivities.
#[test]
fn contacts_and_sensitivities_are_those_of_the_changed_design() {
    let mut session = Session::new();
    let path = double_wishbone();
    open(&mut session, &path);
    let question = |moves: Value| json!({ "model": { "path": path.to_string_lossy(), "move": moves }, "contact": { "at": "bump_stop" } });
    let masses = |session: &mut Session, moves: Value| -> Vec<f64> {
        let reply = ask(session, &json!({ "do": "contacts", "question": question(moves) }));
        let contacts = reply["ok"]["contacts"].as_array().expect("contacts");
        contacts.iter().map(|contact| contact["report"]["effective_mass"].as_f64().unwrap()).collect()
    };
    let first = masses(&mut session, json!({}));
    let moved = masses(&mut session, json!({ "bump_stop_pad": [0.0, 0.002, 0.0] }));
    let model = Model::load(&path.to_string_lossy(), DEFAULT_MAX_SIZE, &LoadOptions::default()).unwrap();
    let changes = Changes { moves: vec![("bump_stop_pad".into(), [0.0, 0.002, 0.0])], ..Changes::default() };
    let native = MassQuestion::default().at_contact("bump_stop");
    let expected = mass(&model.with_changes(&changes).unwrap(), &native).unwrap().effective_mass;
    assert_eq!(Some(moved[0]), expected);
    assert!(moved.len() == first.len() && moved.len() > 4 && first[0] > moved[0] + 1.0, "{first:?}");
    let explained = ask(&mut session, &json!({ "do": "explain", "question": question(json!({})) }));
    let points = explained["ok"]["points"].as_array().unwrap();
    assert!(points.len() > 10 && points.iter().all(|point| point["per_metre"].is_array()), "{points:?}");
}

/// A search by a hardpoint and by a mass reaches the required m̄ at the contact of the question.
#[test]
fn a_target_is_reached() {
    let mut session = Session::new();
    let path = double_wishbone();
    open(&mut session, &path);
    let question = |changes: Value| {
        let mut model = json!({ "path": path.to_string_lossy() });
        model.as_object_mut().unwrap().extend(changes.as_object().unwrap().clone());
        json!({ "model": model, "contact": { "at": "spring" }, "pose": { "travel": ["wheel-travel=20mm"] } })
    };
    let mass = |session: &mut Session, changes: Value| {
        let reply = ask(session, &json!({ "do": "show", "question": question(changes) }));
        reply["ok"]["result"]["ok"]["report"]["effective_mass"].as_f64().unwrap()
    };
    let required = mass(&mut session, json!({})) - 5.0;
    for (unknown, table) in [("spring_seat.y", "move"), ("wheel.mass", "link_mass")] {
        let solve = json!({ "do": "solve", "question": question(json!({})), "unknown": unknown, "mass": required, "within": 0.03 });
        let found = ask(&mut session, &solve)["ok"].clone();
        assert_eq!(found["is_reached"], json!(true), "{unknown}: {found}");
        let by_name = &found[if table == "move" { "moves" } else { "link_masses" }][0];
        let (name, value) = (&by_name[0], &by_name[1]);
        let again = mass(&mut session, json!({ table: { name.as_str().unwrap(): value } }));
        // The search ends at a difference of 1e-8 of the scale of a mass, 1 kg.
        assert!((again - required).abs() < 1e-6, "{unknown}: {again}, {required}");
    }
}

/// The curve of an axle over the heave has its roll.
#[test]
fn a_curve_keeps_an_independent_travel() {
    let mut session = Session::new();
    let path = models().join("suspensions/solid-axle-panhard.toml");
    open(&mut session, &path);
    let question = |travel: Value| {
        json!({ "model": { "path": path.to_string_lossy() }, "contact": { "at": "spring_left" },
                "pose": { "travel": travel } })
    };
    let mut middle_row = |travel: Value| {
        let curve = json!({ "do": "curve", "question": question(travel), "vary": "heave=-10mm:10mm:3" });
        ask(&mut session, &curve)["ok"]["rows"][1].clone()
    };
    let row = middle_row(json!(["roll=15mm"]));
    let straight = middle_row(json!([]))["mass"].as_f64().unwrap();
    let rolled = ask(&mut session, &json!({ "do": "show", "question": question(json!(["roll=15mm"])) }));
    let at_pose = rolled["ok"]["result"]["ok"]["report"]["effective_mass"].as_f64().unwrap();
    assert_eq!(row["at"].as_f64(), Some(0.0));
    assert!((row["mass"].as_f64().unwrap() / at_pose - 1.0).abs() < RELATIVE, "{row}, {at_pose}");
    assert!((straight / at_pose - 1.0).abs() > RELATIVE, "the roll changes the mass");
}

#[test]
fn invalid_requests_are_refused_with_a_reason() {
    let mut session = Session::new();
    let reason = |session: &mut Session, request: &[u8]| {
        let reply: Value = serde_json::from_slice(&session.answer(request)).unwrap();
        reply["refused"]["message"].as_str().expect("a refusal").to_owned()
    };
    assert!(reason(&mut session, b"\xff").contains("invalid"));
    assert!(reason(&mut session, b"{}").contains("do"));
    let question = json!({ "model": { "path": "a" }, "contact": { "at": "spring" } });
    let show = json!({ "do": "show", "question": question }).to_string();
    assert!(reason(&mut session, show.as_bytes()).contains("no model"));
    let open = json!({ "do": "open", "model": { "path": "a.toml" }, "text": "template = 3" }).to_string();
    assert!(!reason(&mut session, open.as_bytes()).is_empty());
    let typo = json!({ "do": "show", "question": { "model": { "path": "a" }, "contakt": {} } }).to_string();
    assert!(reason(&mut session, typo.as_bytes()).contains("contakt"));
}

#[test]
fn the_boundary_exchanges_bytes() {
    let request = br#"{"do":"sheet","model":{"path":"a"}}"#;
    let at = percuss_request(request.len());
    // SAFETY: `at` has room for the request, which no other test of this program touches: only this one uses the boundary.
    unsafe { std::ptr::copy_nonoverlapping(request.as_ptr(), at, request.len()) };
    let length = percuss_answer();
    // SAFETY: the reply has `length` bytes until the next call.
    let reply = unsafe { std::slice::from_raw_parts(percuss_reply(), length) };
    let reply: Value = serde_json::from_slice(reply).unwrap();
    assert!(reply["refused"]["message"].as_str().unwrap().contains("no model"));
}
