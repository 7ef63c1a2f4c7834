//! Hostile files of every format: refused within seconds with the file and the line, or read in bounded memory.

use crate::support::bounded;
use percuss_formats::load_file;
use percuss_mechanism::Severity;
use std::path::PathBuf;

fn folder() -> PathBuf {
    let folder = std::env::temp_dir().join(format!("percuss-hostile-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// MJCF of a body whose inertia follows from a mesh file.
fn with_mesh(file: &str) -> String {
    format!(
        "<mujoco><asset>\n<mesh name=\"m\" file=\"{file}\"/></asset><worldbody><body><joint/><geom type=\"mesh\" mesh=\"m\"/></body>\
         </worldbody></mujoco>"
    )
}

/// Elements within each other.
fn nested(open: &str, close: &str, depth: usize) -> String {
    open.repeat(depth) + &close.repeat(depth)
}

#[test]
fn hostile_files_are_refused_with_their_line() {
    let folder = folder();
    let include = |file: &str| format!("<mujoco>\n<include file=\"{file}\"/><worldbody/></mujoco>");
    let attach = |file: &str, body: &str| {
        format!(
            "<mujoco>\n<asset><model name=\"m\" file=\"{file}\"/></asset><worldbody><body name=\"{body}\"><geom size=\"1\"/>\
             <attach model=\"m\" prefix=\"p\"/></body></worldbody></mujoco>"
        )
    };
    let part = |file: &str| {
        format!("<sdf version=\"1.9\"><model name=\"m\">\n<include><uri>{file}</uri></include></model></sdf>")
    };
    let mut entities = format!("<!DOCTYPE m [<!ENTITY a \"{}\">", "x".repeat(1000));
    for pair in ["ba", "cb", "dc", "ed", "fe", "gf", "hg"] {
        let (own, other) = pair.split_at(1);
        entities += &format!("<!ENTITY {own} \"{}\">", format!("&{other};").repeat(20));
    }
    entities += "]>";
    let body = "<body><joint/><geom size=\"1\"/></body>";
    let twice = "<mujoco><default>\n<default class=\"a\"><default class=\"b\"/></default>\n<default class=\"b\"><default class=\"a\"/></default>\
                 </default><worldbody/></mujoco>";
    let texts = [
        ("include_a.xml", include("include_b.xml")),
        ("include_b.xml", include("include_a.xml")),
        ("include_self.xml", include("include_self.xml")),
        ("attach_a.xml", attach("attach_b.xml", "x")),
        ("attach_b.xml", attach("attach_a.xml", "y")),
        (
            "replicate.xml",
            format!(
                "<mujoco><worldbody>\n<replicate count=\"1000000\">{body}</replicate></worldbody></mujoco>"
            ),
        ),
        ("classes.xml", twice.to_owned()),
        (
            "deep.xml",
            format!("<mujoco><worldbody>{}</worldbody></mujoco>", nested("<frame>\n", "</frame>", 5000)),
        ),
        ("entities.xml", format!("{entities}\n<mujoco model=\"&h;\"/>")),
        ("truncated.xml", "<mujoco><worldbody>\n<body>".to_owned()),
        ("stl.xml", with_mesh("false.stl")),
        ("msh.xml", with_mesh("false.msh")),
        ("obj.xml", with_mesh("false.obj")),
        ("include_a.sdf", part("include_b.sdf")),
        ("include_b.sdf", part("include_a.sdf")),
        (
            "deep.sdf",
            format!(
                "<sdf version=\"1.9\"><model name=\"m\">{}</model></sdf>",
                nested("<model name=\"n\">\n", "</model>", 3000)
            ),
        ),
        ("entities.sdf", format!("{entities}\n<sdf version=\"1.9\"><model name=\"&h;\"/></sdf>")),
        ("truncated.sdf", "<sdf version=\"1.9\">\n<model name=\"m\">".to_owned()),
        ("deep.urdf", format!("<robot name=\"m\">{}</robot>", nested("<link>\n", "</link>", 5000))),
        ("entities.urdf", format!("{entities}\n<robot name=\"&h;\"/>")),
    ];
    // Counts of 4 294 967 295 triangles and 2 147 483 647 vertices, and an index beyond the vertices.
    let stl = [&[0u8; 80][..], &u32::MAX.to_le_bytes(), &[0; 100]].concat();
    let msh = [&i32::MAX.to_le_bytes().repeat(4)[..], &[0; 50]].concat();
    let obj = format!("{}f 1 2 99999999999\n", "v 0 0 0\n".repeat(3)).into_bytes();
    for (name, bytes) in [("false.stl", stl), ("false.msh", msh), ("false.obj", obj)] {
        std::fs::write(folder.join(name), bytes).expect("a file");
    }
    for (name, text) in &texts {
        std::fs::write(folder.join(name), text).expect("a file");
    }
    for (name, _) in &texts {
        let error = bounded(name, || load_file(&folder.join(name).to_string_lossy())).expect_err(name);
        let first =
            error.diagnostics.iter().find(|found| found.severity == Severity::Error).expect("an error");
        assert!(first.line.is_some() && !first.path.is_empty(), "{name}: {first}");
    }
}

/// A product of keyframes and joints is bounded: no more positions are kept than the limit allows.
#[test]
fn many_keyframes_are_bounded() {
    let file = folder().join("keyframes.xml");
    let bodies = "<body><joint/><geom size=\"1\"/></body>".repeat(3000);
    let keys = "<key/>\n".repeat(50_000);
    std::fs::write(
        &file,
        format!("<mujoco><worldbody>{bodies}</worldbody><keyframe>{keys}</keyframe></mujoco>"),
    )
    .expect("a file");
    let loaded = bounded("keyframes", || load_file(&file.to_string_lossy())).expect("a model");
    assert!(!loaded.poses.is_empty() && loaded.poses.len() * 3000 <= 300_000, "{}", loaded.poses.len());
    assert!(loaded.diagnostics.iter().any(|found| found.message.contains("keyframes after the first")));
}
