//! Tests of the engine of the explorer, natively: the module has the same functions.

use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_study::{Changes, MassQuestion, Model, mass};
use percuss_web::{Session, percuss_answer, percuss_reply, percuss_request};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Largest distance of points that coincide in exact arithmetic, m: coordinates are of the order of 1 m, and loops are closed
/// to 1e-10 of the size of the mechanism.
const SAME_POINT: f64 = 1e-8;

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
        let native = MassQuestion {
            at: opened["contact"]["at"].as_str().map(str::to_owned),
            link: opened["contact"]["link"].as_str().unwrap_or_default().to_owned(),
            point: if opened["contact"]["at"].is_null() { triple("point_link") } else { [0.0; 3] },
            normal: percuss_study::Normal::Along(triple("normal_link")),
            base: if report["conditions"]["base"] == "floating" {
                percuss_study::BaseName::Floating.into()
            } else {
                percuss_study::BaseName::Fixed.into()
            },
            ..MassQuestion::without_contact()
        };
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
    let show = |session: &mut Session, moves: Value| {
        let question = json!({ "model": table(moves), "contact": { "at": "spring" } });
        ask(session, &json!({ "do": "show", "question": question, "vary": "wheel-travel=-20mm:40mm:7" }))
    };
    let reply = show(&mut session, json!({ "lower_ball": shift }));
    let model = Model::load(&path.to_string_lossy(), DEFAULT_MAX_SIZE, &LoadOptions::default()).unwrap();
    let moved = model
        .with_changes(&Changes { moves: vec![("lower_ball".into(), shift)], ..Changes::default() })
        .unwrap();
    let question = MassQuestion { at: Some("spring".into()), ..MassQuestion::without_contact() };
    let expected = mass(&moved, &question).unwrap().effective_mass;
    assert_eq!(reply["ok"]["result"]["ok"]["report"]["effective_mass"].as_f64(), expected);
    assert!(reply["ok"]["scene"].is_object(), "the scene has changed");
    let rows = reply["ok"]["curve"]["ok"]["rows"].as_array().unwrap().clone();
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
