//! `percuss map` compared with `percuss mass` and with a closed form; contents of its files.

use crate::support::{json, percuss};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;

const ARM: &str = "models/shaped_arm.urdf";
const POSE: &str = "--set shoulder=-40deg --set elbow=70deg";

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("percuss-map-{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn triple(v: &Value) -> String {
    let numbers: Vec<String> = v.as_array().expect("three").iter().map(|x| x.to_string()).collect();
    numbers.join(",")
}

fn number(v: &Value) -> f64 {
    v.as_f64().unwrap_or_else(|| panic!("{v} is no number"))
}

#[test]
fn extremes_are_what_mass_says_there() {
    for others in [
        "",
        "--base floating --link-mass pedestal=20kg",
        "--against pedestal",
        "--against-mass 3kg",
        "--lock elbow",
    ] {
        let report = json(&format!("map {ARM} --all {POSE} {others} --edge 4cm --format json"));
        assert_eq!(report["schema"], "percuss.map/1");
        let links = report["links"].as_array().expect("links");
        assert!(links.len() >= 4, "{others}: {links:?}");
        let mut compared = 0;
        for link in links {
            let sum: u64 = ["finite", "immovable", "massless", "unanswered"]
                .iter()
                .map(|k| link[k].as_u64().expect("a count"))
                .sum();
            assert_eq!(Some(sum), link["contacts"].as_u64());
            for extreme in ["smallest", "largest"].map(|k| &link[k]).into_iter().filter(|e| !e.is_null()) {
                let name = link["link"].as_str().expect("a name");
                let one = json(&format!(
                    "mass {ARM} --link {name} --point {} --normal {} {POSE} {others} --format json",
                    triple(&extreme["point_link"]),
                    triple(&extreme["normal_link"])
                ));
                let (a, b) = (number(&extreme["effective_mass"]), number(&one["effective_mass"]));
                let allowed = number(&extreme["effective_mass_error"])
                    + number(&one["effective_mass_error"])
                    + 1e-14 * b;
                assert!((a - b).abs() <= allowed, "{others} {name}: {a} {b}");
                compared += 1;
            }
        }
        assert!(compared >= 6, "{others}: {compared}");
    }
}

/// One hinge: m̄ = J/(a·(r × n))² at every facet of every shape.
#[test]
fn a_hinged_link_has_its_closed_form_everywhere() {
    let folder = folder("pendulum");
    let model = folder.join("pendulum.urdf");
    let shapes = r#"<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>
        <collision><origin xyz="0.1 0 -0.3" rpy="0.2 0.4 0"/><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
        <collision><origin xyz="0 0.2 -0.5"/><geometry><sphere radius="0.1"/></geometry></collision>
        <collision><origin xyz="0 0 -0.6" rpy="1 0 0"/><geometry><cylinder radius="0.05" length="0.2"/></geometry></collision>
        <collision><geometry><mesh filename="package://pendulum/tip.stl" scale="0.001 0.001 0.001"/></geometry></collision>"#;
    let text = format!(
        r#"<robot name="pendulum"><link name="ground"/><link name="body"><inertial><origin xyz="0 0 -0.4"/><mass value="3"/>
        <inertia ixx="0.07" ixy="0" ixz="0" iyy="0.07" iyz="0" izz="0.01"/></inertial>{shapes}</link>
        <joint name="hinge" type="continuous"><parent link="ground"/><child link="body"/><axis xyz="0 1 0"/></joint></robot>"#
    );
    fs::write(&model, text).expect("written");
    let package = folder.join("files");
    fs::create_dir_all(&package).expect("made");
    let tip = "solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 -700\nvertex 100 0 -700\nvertex 0 100 -750\nendloop\nendfacet\nendsolid t\n";
    fs::write(package.join("tip.stl"), tip).expect("written");
    let (model, package) = (model.display(), package.display());
    let line = format!("map {model} --link body --edge 2cm --set hinge=0.7 --package pendulum={package}");
    let table = percuss(&format!("{line} --format csv"));
    assert_eq!(table.code, 0, "{}", table.stderr);
    let mut rows = table.stdout.lines();
    let header = rows.next().expect("a header");
    assert!(header.starts_with("link,x,y,z,normal_x"), "{header}");
    let (mut finite, mut immovable) = (0, 0);
    for row in rows {
        let cells: Vec<&str> = row.split(',').collect();
        let v = |i: usize| cells[i].parse::<f64>().expect("a number");
        // a·(r × n) with a = y.
        let arm = v(3) * v(4) - v(1) * v(6);
        match cells[11] {
            "finite" => {
                let m = v(12);
                // r and n have 16 digits; cancellation in their product loses some of them.
                assert!((m * arm * arm / 0.55 - 1.0).abs() < 1e-12 + 4e-15 / arm.abs(), "{row}");
                finite += 1;
            }
            "immovable" => {
                assert!(arm.abs() < 1e-9, "{row}");
                assert_eq!((cells[12], cells[13]), ("", ""));
                immovable += 1;
            }
            other => panic!("{other}"),
        }
    }
    assert!(finite > 1000 && immovable > 10, "{finite} {immovable}");
    let missing = percuss(&format!("map {model} --link body"));
    assert_eq!(missing.code, 2);
    for part in ["body", "tip.stl", "--package NAME=FOLDER"] {
        assert!(missing.stderr.contains(part), "{}", missing.stderr);
    }
    let all = percuss(&format!("map {model} --all"));
    assert_eq!(all.code, 2, "no link is left: {}", all.stdout);
    fs::remove_dir_all(folder).expect("removed");
}

/// Contents of a PLY after `end_header`: masses of the vertices, and mass and status of the faces.
fn ply(bytes: &[u8]) -> (Vec<f64>, Vec<(f64, u8)>) {
    let end = b"end_header\n";
    let at = bytes.windows(end.len()).position(|w| w == end).expect("a header") + end.len();
    let header = std::str::from_utf8(&bytes[..at]).expect("text");
    let count = |what: &str| -> usize {
        let line = header.lines().find(|l| l.starts_with(&format!("element {what}"))).expect("an element");
        line.rsplit(' ').next().expect("a count").parse().expect("a number")
    };
    let (vertices, faces) = (count("vertex"), count("face"));
    let (vertex, face) = (6 * 4 + 3 + 8, 1 + 12 + 3 + 8 + 1);
    assert_eq!(bytes.len(), at + vertices * vertex + faces * face);
    let double = |i: usize| f64::from_le_bytes(bytes[i..i + 8].try_into().expect("eight"));
    let of_vertices = (0..vertices).map(|i| double(at + i * vertex + 27)).collect();
    let first = at + vertices * vertex;
    let of_faces =
        (0..faces).map(|i| (double(first + i * face + 16), bytes[first + i * face + 24])).collect();
    (of_vertices, of_faces)
}

#[test]
fn files_hold_the_masses_of_the_table() {
    let folder = folder("files");
    let files: Vec<PathBuf> = ["a.ply", "a.glb", "a.gltf", "a.svg", "a.png", "a.csv", "a.json"]
        .iter()
        .map(|f| folder.join(f))
        .collect();
    let outputs: String = files.iter().map(|f| format!(" -o {}", f.display())).collect();
    let outcome = percuss(&format!("map {ARM} --all {POSE} --edge 3cm{outputs}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    for part in ["link", "smallest", "forearm", "finger", "immovable", "relative errors"] {
        assert!(outcome.stdout.contains(part), "{part}: {}", outcome.stdout);
    }
    let read = |i: usize| fs::read(&files[i]).expect("written");
    let table = String::from_utf8(read(5)).expect("text");
    let masses: Vec<Option<f64>> =
        table.lines().skip(1).map(|row| row.split(',').nth(12).expect("a cell").parse().ok()).collect();
    let (vertices, faces) = ply(&read(0));
    assert_eq!((vertices.len(), faces.len()), (3 * masses.len(), masses.len()));
    for (i, mass) in masses.iter().enumerate() {
        let (of_face, status) = faces[i];
        assert_eq!(of_face, mass.unwrap_or(-1.0));
        assert_eq!(status, u8::from(mass.is_none()));
        assert!(vertices[3 * i..3 * i + 3].iter().all(|v| *v == of_face));
    }
    let glb = read(1);
    assert_eq!((&glb[..4], glb.len() % 4), (&b"glTF"[..], 0));
    let word = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().expect("four")) as usize;
    assert_eq!((word(4), word(8)), (2, glb.len()));
    let document: Value = serde_json::from_slice(&glb[20..20 + word(12)]).expect("JSON");
    let binary = &glb[28 + word(12)..];
    let mut found = Vec::new();
    for mesh in document["meshes"].as_array().expect("meshes") {
        let accessor = mesh["primitives"][0]["attributes"]["_EFFECTIVE_MASS"].as_u64().expect("an attribute");
        let view = &document["bufferViews"]
            [document["accessors"][accessor as usize]["bufferView"].as_u64().expect("a view") as usize];
        let (start, length) =
            (view["byteOffset"].as_u64().expect("an offset"), view["byteLength"].as_u64().expect("a length"));
        let part = &binary[start as usize..(start + length) as usize];
        found.extend(part.chunks_exact(12).map(|c| f32::from_le_bytes(c[..4].try_into().expect("four"))));
    }
    let expected: Vec<f32> = masses.iter().map(|m| m.unwrap_or(-1.0) as f32).collect();
    assert_eq!(found, expected);
    let text: Value = serde_json::from_slice(&read(2)).expect("JSON");
    assert!(
        text["buffers"][0]["uri"]
            .as_str()
            .expect("inside")
            .starts_with("data:application/octet-stream;base64,")
    );
    let svg = String::from_utf8(read(3)).expect("text");
    for part in ["effective mass", "largest", "data:image/png;base64,", "immovable"] {
        assert!(svg.contains(part), "{part}");
    }
    assert!(read(4).starts_with(b"\x89PNG"));
    let whole: Value = serde_json::from_slice(&read(6)).expect("JSON");
    assert_eq!(whole["contacts"].as_array().map(Vec::len), Some(masses.len()));
    fs::remove_dir_all(folder).expect("removed");
}

/// No result depends on the number of threads.
#[test]
fn threads_do_not_matter() {
    let line = format!("map {ARM} --all {POSE} --format csv --edge 6mm");
    let one = percuss(&format!("{line} --threads 1")).stdout;
    assert!(one.lines().count() > 10_000);
    assert!(one == percuss(&format!("{line} --threads 3")).stdout);
}

#[test]
fn directions_at_a_point_have_their_principal_masses() {
    let report = json(&format!("map {ARM} --link finger --point 0.1,0,0 --directions 500 --format json"));
    let principal = report["principal"].as_array().expect("three");
    assert_eq!(principal.len(), 3);
    // Stretched along x: immovable along x; sideways, the closed form of the model.
    assert_eq!(principal[2]["status"], "immovable");
    let sideways = principal.iter().find(|p| number(&p["direction_link"][1]).abs() > 0.999).expect("along y");
    assert!((number(&sideways["effective_mass"]) / 1.792578125 - 1.0).abs() < 1e-9);
    let directions = report["directions"].as_array().expect("a list");
    assert_eq!(directions.len(), 500);
    let least = number(&principal[0]["effective_mass"]);
    for d in directions.iter().filter(|d| d["status"] == "finite") {
        assert!(number(&d["effective_mass"]) >= least * (1.0 - 1e-9));
        let one =
            |i: usize, k: usize| number(&principal[i]["direction_link"][k]) * number(&d["direction_link"][k]);
        let inverse = |i: usize| {
            (0..3).map(|k| one(i, k)).sum::<f64>().powi(2) / number(&principal[i]["effective_mass"])
        };
        assert!((number(&d["effective_mass"]) * (inverse(0) + inverse(1)) - 1.0).abs() < 1e-7);
    }
    let text = percuss(&format!("map {ARM} --link finger --point 0.1,0,0 --directions 500"));
    assert!(text.code == 0 && text.stdout.contains("1.793 kg   (0, 1, 0)"), "{}", text.stdout);
}

/// Positions of the vertices of a PLY.
fn places(bytes: &[u8], count: usize) -> Vec<[f64; 3]> {
    let end = b"end_header\n";
    let at = bytes.windows(end.len()).position(|w| w == end).expect("a header") + end.len();
    let single = |i: usize| f64::from(f32::from_le_bytes(bytes[i..i + 4].try_into().expect("four")));
    (0..count).map(|i| [0, 4, 8].map(|k| single(at + i * (6 * 4 + 3 + 8) + k))).collect()
}

#[test]
fn a_belted_ellipsoid_is_as_far_as_the_mass_is_large() {
    let folder = folder("ellipsoid");
    let file = folder.join("belt.ply");
    // Finite in all directions; stretched, with an immovable direction; folded; against a free body.
    for flags in ["--set elbow=70deg", "", "--set elbow=170deg", "--set elbow=70deg --against-mass 2kg"] {
        let line = format!("map {ARM} --link finger --point 0.1,0,0 {flags} --directions 10 --force");
        let report = json(&format!("{line} --format json -o {}", file.display()));
        let principal = report["principal"].as_array().expect("three");
        let inverse = |n: [f64; 3]| -> f64 {
            let along = |p: &Value| (0..3).map(|k| number(&p["direction_world"][k]) * n[k]).sum::<f64>();
            let finite = principal.iter().filter(|p| p["status"] == "finite");
            finite.map(|p| along(p).powi(2) / number(&p["effective_mass"])).sum()
        };
        let bytes = fs::read(&file).expect("written");
        let (masses, faces) = ply(&bytes);
        let (mut furthest, mut nearest, mut cut) = (0.0f64, f64::INFINITY, 0);
        for (i, [x, y, z]) in places(&bytes, masses.len()).into_iter().enumerate() {
            let far = x.hypot(y).hypot(z);
            (furthest, nearest) = (furthest.max(far), nearest.min(far));
            let expected = 1.0 / inverse([x / far, y / far, z / far]);
            // Positions have single precision. A facet without a value reaches the cut-off.
            let (_, status) = faces[i / 3];
            cut += usize::from(status == 1);
            assert!(status == 1 || (far / expected - 1.0).abs() < 1e-5 || far < expected, "{far} {expected}");
        }
        let finite: Vec<f64> = principal
            .iter()
            .filter(|p| p["status"] == "finite")
            .map(|p| number(&p["effective_mass"]))
            .collect();
        let (least, largest) = (finite[0], finite[finite.len() - 1]);
        // The poles of the grid are principal directions.
        assert!((nearest / least - 1.0).abs() < 1e-3, "{nearest} {least}");
        let reach = if finite.len() < 3 { 4.0 * largest } else { largest };
        assert!((furthest / reach - 1.0).abs() < 1e-5, "{furthest} {reach}");
        assert_eq!(cut > 0, finite.len() < 3);
    }
    for ending in ["svg", "png", "pdf", "glb", "gltf"] {
        let file = folder.join(format!("belt.{ending}"));
        let line = format!("map {ARM} --link finger --point 0.1,0,0 --directions 10 -o {}", file.display());
        assert_eq!(percuss(&line).code, 0);
        assert!(fs::metadata(&file).expect("written").len() > 1000, "{ending}");
    }
    fs::remove_dir_all(folder).expect("removed");
}
