//! Small or valid files with a high cost: the command computes each file, or refuses the file with the limit, in bounded
//! memory and work.
//!
//! The limits of the command concern work and memory. The limit of processor time in these tests is far above the time of each
//! file in this profile, and reveals a cost that grows with the square of the input. `tests/fuzz/measured.py` writes the time and
//! the memory of every file to a table.

#![cfg(unix)]

use crate::support::{Outcome, Scratch, root};
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::Command;

/// Address space, kB.
const MEMORY: usize = 1_500_000;
/// Largest processor time, s: enough for an unoptimised program on a busy machine.
const PATIENCE: usize = 15;

/// Runs the command within the limits. A signal, for example by an abort or the time limit, is a failure.
fn bounded(arguments: &[&str]) -> Outcome {
    bounded_by(PATIENCE, arguments)
}

/// Runs the command within a limit of processor time, s, and the limit of memory.
fn bounded_by(seconds: usize, arguments: &[&str]) -> Outcome {
    let script = format!("ulimit -v {MEMORY}; ulimit -t {seconds}; exec $PERCUSS_UNDER \"$0\" \"$@\"");
    let run = Command::new("/bin/sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_percuss")])
        .args(arguments)
        .current_dir(root())
        .output()
        .expect("the command runs");
    assert!(
        run.status.code().is_some(),
        "{arguments:?}: {:?} {}",
        run.status,
        String::from_utf8_lossy(&run.stderr)
    );
    let outcome = Outcome::from(run);
    assert!(!outcome.stderr.contains("panicked"), "{arguments:?}: {}", outcome.stderr);
    assert!(outcome.stderr.len() < 100_000, "{arguments:?}: {} bytes of messages", outcome.stderr.len());
    outcome
}

fn refused(arguments: &[&str], code: i32, words: &[&str]) {
    let outcome = bounded(arguments);
    assert_eq!(outcome.code, code, "{arguments:?}: {}", outcome.stderr);
    for word in words {
        assert!(outcome.stderr.contains(word), "{arguments:?}: {word} is not in {}", outcome.stderr);
    }
}

const INERTIAL: &str = "<inertial><mass value=\"1\"/><inertia ixx=\"1e-4\" iyy=\"1e-4\" izz=\"1e-4\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";

fn link(name: &str) -> String {
    format!("<link name=\"{name}\">{INERTIAL}</link>")
}

fn joint(number: usize, parent: &str, child: &str, at: [f64; 2], more: &str) -> String {
    format!(
        "<joint name=\"j{number}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
         <origin xyz=\"{} {} 0\"/><axis xyz=\"0 0 1\"/>{more}</joint>",
        at[0], at[1]
    )
}

fn closure(number: usize, links: [&str; 2], at: [f64; 2]) -> String {
    format!(
        "<loop name=\"p{number}\" type=\"revolute\"><predecessor link=\"{}\"><origin xyz=\"{} 0.2 0\"/></predecessor>\
         <successor link=\"{}\"><origin xyz=\"{} 0 0\"/></successor><axis xyz=\"0 0 1\"/></loop>",
        links[0], at[0], links[1], at[1]
    )
}

/// Chain of `links` hinges; with `mimics`, every second hinge follows the previous hinge.
fn chain(links: usize, mimics: bool) -> String {
    let mut text = String::from("<robot name=\"r\"><link name=\"l0\"/>");
    for i in 1..=links {
        let master =
            if mimics && i % 2 == 0 { format!("<mimic joint=\"j{}\"/>", i - 1) } else { String::new() };
        text += &link(&format!("l{i}"));
        text += &joint(i, &format!("l{}", i - 1), &format!("l{i}"), [0.01, 0.0], &master);
    }
    text + "</robot>"
}

const CONTACT: &str = "[contact]\nlink = \"rod\"\npoint = [0, 0, -0.8]\nnormal = [1, 0, 0]\n";

fn pendulum() -> String {
    root().join("models/point_mass_pendulum.urdf").to_string_lossy().into_owned()
}

#[test]
fn studies() {
    let folder = Scratch::new("bounded-studies");
    let head = format!("[model]\npath = {:?}\n", pendulum());
    let long = "k".repeat(100_000);
    let list = "0,".repeat(100_000);
    let path = folder.write("list.toml", &format!("{head}[model.link_mass]\n{long} = [{list}]\n{CONTACT}"));
    refused(&["run", &path], 2, &["error", "link_mass.kkkk"]);
    let sheet = folder.write(
        "sheet.toml",
        &format!(
            "[{long}]\n{}",
            (0..100_000).fold(String::new(), |mut text, i| {
                let _ = writeln!(text, "k{i} = 1");
                text
            })
        ),
    );
    refused(&["import", &sheet, "-o", "-"], 2, &["a key of 100000 bytes; at most 1024"]);
    for (count, words) in
        [(300_000, ["unknown key \"k0\"", "299950 more unknown keys"]), (500_000, ["limit", "4194304"])]
    {
        let keys: String = (0..count).map(|i| format!("k{i}=0\n")).collect();
        let path = folder.write("unknown.toml", &keys);
        refused(&["run", &path], 2, &words);
    }
    for key in [vec!["a"; 20_000].join("."), format!("[{}]\nx", vec!["a"; 20_000].join("."))] {
        refused(&["run", &folder.write("deep.toml", &format!("{key} = 1\n"))], 2, &["error"]);
    }
    let names: String = (0..60_000).map(|i| format!("[[variant]]\nname = \"{i}\"\n")).collect();
    let path = folder.write("variants.toml", &format!("{head}{CONTACT}{names}"));
    refused(&["run", &path], 2, &["60000 variants; at most 10000"]);
    let set: String = (0..20_000).map(|i| format!("joint_{i} = {i}.5\n")).collect();
    let names: String = (0..5_000).map(|i| format!("[[variant]]\nname = \"{i}\"\n")).collect();
    let path = folder.write("copies.toml", &format!("{head}{CONTACT}[pose.set]\n{set}{names}"));
    refused(&["run", &path], 2, &["5000 variants; at most"]);
    let model = folder.write("chain.urdf", &chain(10_000, false));
    let names: String =
        (0..200).map(|i| format!("[[variant]]\nname = \"{i}\"\nlink_mass.l5 = {i}.5\n")).collect();
    let contact = "[contact]\nlink = \"l9\"\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n";
    let path = folder.write("models.toml", &format!("[model]\npath = {model:?}\n{contact}{names}"));
    refused(&["run", &path], 2, &["links together; at most 1000000"]);
}

/// Workbook with these parts in addition to the mandatory parts.
fn workbook(parts: &[(&str, &str)]) -> Vec<u8> {
    let usual = [
        (
            "_rels/.rels",
            r#"<Relationships><Relationship Id="r" Type="http://x/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>"#,
        ),
        (
            "xl/_rels/workbook.xml.rels",
            r#"<Relationships><Relationship Id="s" Type="http://x/relationships/worksheet" Target="worksheets/sheet1.xml"/></Relationships>"#,
        ),
        (
            "xl/workbook.xml",
            r#"<workbook xmlns:r="r"><sheets><sheet name="a" sheetId="1" r:id="s"/></sheets></workbook>"#,
        ),
    ];
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let packed = zip::write::SimpleFileOptions::default();
    for (name, text) in usual.iter().chain(parts) {
        archive.start_file(*name, packed).expect("a part");
        archive.write_all(text.as_bytes()).expect("written");
    }
    archive.finish().expect("an archive").into_inner()
}

fn sheet(rows: &str) -> String {
    format!("<worksheet><sheetData>{rows}</sheetData></worksheet>")
}

#[test]
fn workbooks() {
    let folder = Scratch::new("bounded-workbooks");
    let texts = |count: &str, texts: &str| format!("<sst uniqueCount=\"{count}\">{texts}</sst>");
    let cell = "<row r=\"1\"><c r=\"A1\" t=\"s\"><v>0</v></c></row>";
    let one = sheet(cell);
    let wide: String = (1..=1000)
        .map(|row| {
            let cells: String = (0..52)
                .map(|c| {
                    let column = char::from(b'A' + c % 26);
                    let first = if c < 26 { "" } else { "A" };
                    format!("<c r=\"{first}{column}{row}\" t=\"s\"><v>0</v></c>")
                })
                .collect();
            format!("<row r=\"{row}\">{cells}</row>")
        })
        .collect();
    let fonts = format!("<fonts><font><name val=\"{}\"/></font></fonts>", "f".repeat(1 << 20));
    let styles = |fonts: &str, count: usize| {
        format!(
            "<styleSheet>{fonts}<cellXfs>{}</cellXfs></styleSheet>",
            "<xf fontId=\"0\"></xf>".repeat(count)
        )
    };
    let refers = |attribute: &str| {
        let cell = format!("<row r=\"1\"><c {attribute} t=\"s\"><v>0</v></c></row>");
        workbook(&[
            ("xl/sharedStrings.xml", &texts("1", "<si><t>x</t></si>")),
            ("xl/worksheets/sheet1.xml", &sheet(&cell)),
        ])
    };
    let cases: [(&str, Vec<u8>, &str); 12] = [
        ("row", refers("r=\"A99999999999\""), "cell reference \"A99999999999\""),
        ("column", refers("s=\"0\"\nr = 'ABCDEFGHIJKLMNOP1'"), "cell reference \"ABCDEFGHIJKLMNOP1\""),
        ("number", refers("r=\"18446744073709551616\""), "cell reference \"18446744073709551616\""),
        (
            "abort",
            workbook(&[
                ("xl/sharedStrings.xml", &texts("99999999999", "")),
                ("xl/worksheets/sheet1.xml", &one),
            ]),
            "states 99999999999 shared texts",
        ),
        (
            "panic",
            workbook(&[
                ("xl/sharedStrings.xml", &texts("18446744073709551615", "")),
                ("xl/worksheets/sheet1.xml", &one),
            ]),
            "states 18446744073709551615 shared texts",
        ),
        (
            "overflow",
            workbook(&[
                ("xl/sharedStrings.xml", &texts("0000099999999999999999999999", "")),
                ("xl/worksheets/sheet1.xml", &one),
            ]),
            "shared texts",
        ),
        (
            "unpacked",
            workbook(&[
                ("xl/sharedStrings.xml", &texts("1", &"<si></si>".repeat(8_000_000))),
                ("xl/worksheets/sheet1.xml", &one),
            ]),
            "more than 16777216 bytes",
        ),
        (
            "pad",
            workbook(&[("xl/media/x.png", &" ".repeat(200 << 20)), ("xl/worksheets/sheet1.xml", &one)]),
            "more than 16777216 bytes",
        ),
        (
            "texts",
            workbook(&[
                ("xl/sharedStrings.xml", &texts("1", &format!("<si><t>{}</t></si>", "x".repeat(1 << 20)))),
                ("xl/worksheets/sheet1.xml", &sheet(&wide)),
            ]),
            "more than 16777216 bytes of text",
        ),
        (
            "fonts",
            workbook(&[("xl/styles.xml", &styles(&fonts, 50_000)), ("xl/worksheets/sheet1.xml", &one)]),
            "cell formats name fonts or number formats of up to 10485",
        ),
        (
            "formats",
            workbook(&[("xl/styles.xml", &styles("", 500_000)), ("xl/worksheets/sheet1.xml", &one)]),
            "cell formats; at most 131072",
        ),
        (
            "cells",
            workbook(&[(
                "xl/worksheets/sheet1.xml",
                &sheet(&"<row r=\"1\"><c r=\"A1\"></c></row>".repeat(500_000)),
            )]),
            "error",
        ),
    ];
    for (name, bytes, words) in cases {
        let path = folder.path(&format!("{name}.xlsx"));
        std::fs::write(&path, bytes).expect("written");
        refused(&["import", &path, "-o", "-"], 2, &[words]);
    }
}

#[test]
fn workbooks_that_are_written() {
    let folder = Scratch::new("bounded-xlsx");
    let model = folder.write("chain.urdf", &chain(200, false));
    let out = folder.path("rows.xlsx");
    let contact = ["--link", "l200", "--point", "0,0,0", "--normal", "0,1,0"];
    let sweep = [&["sweep", &model][..], &contact, &["--vary", "j1=0:1:100000", "--output", &out]].concat();
    refused(&sweep, 2, &["100000 rows of 208 columns", "at most 5000000", ".parquet"]);
    assert!(!std::path::Path::new(&out).exists());
}

/// Random numbers, equal in every run.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, most: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % most
    }

    /// Random number from −1 to 1.
    fn signed(&mut self) -> f64 {
        self.below(2000) as f64 / 1000.0 - 1.0
    }
}

/// Tree of `links` with `loops` between random links with numbers 2 to `span` + 2 apart; the loops cannot be closed. The parent
/// of a link is one of the `near` previous links.
fn open_linkage(links: usize, loops: usize, near: usize, span: usize) -> String {
    let mut numbers = Numbers(1);
    let mut text = String::from("<robot name=\"r\"><link name=\"l0\"/>");
    for i in 1..links {
        let parent = format!("l{}", i - 1 - numbers.below(i.min(near)));
        let at = [0.6 + 0.4 * numbers.signed(), 0.3 * numbers.signed()];
        text += &link(&format!("l{i}"));
        text += &joint(i, &parent, &format!("l{i}"), at, "");
    }
    for k in 0..loops {
        let a = 14 + numbers.below(links - 14);
        let ends = [format!("l{a}"), format!("l{}", a - 2 - numbers.below(span.min(a - 2) + 1))];
        let at = [numbers.signed(), numbers.signed()];
        text += &closure(k, [&ends[0], &ends[1]], at);
    }
    text + "</robot>"
}

#[test]
fn linkages() {
    let folder = Scratch::new("bounded-linkages");
    let mut cut = 0;
    for (links, loops, near, span) in [
        (154, 72, 4, 10),
        (154, 72, 1, 12),
        (154, 72, 4, 150),
        (320, 128, 4, 10),
        (320, 128, 1, 12),
        (320, 128, 4, 300),
    ] {
        let model = folder.write("open.urdf", &open_linkage(links, loops, near, span));
        let contact = ["--link", "l20", "--point", "0,0,0", "--normal", "0,1,0"];
        let outcome = bounded(&[&["mass", &model][..], &contact].concat());
        assert_eq!(outcome.code, 1, "{links} {loops} {near} {span}: {}", outcome.stderr);
        assert!(outcome.stderr.contains("do not close"), "{}", outcome.stderr);
        cut += usize::from(outcome.stderr.contains("the search was cut short"));
    }
    assert!(cut >= 3, "only {cut} searches were cut short, so that the bound is not tested");
}

#[test]
fn many_loops_and_mimics() {
    let folder = Scratch::new("bounded-many");
    let pins = |count: usize| {
        let two = [joint(1, "base", "a", [0.0, 0.0], ""), joint(2, "base", "b", [1.0, 0.2], "")].concat();
        let loops: String = (0..count).map(|i| closure(i, ["a", "b"], [0.5, -0.5])).collect();
        format!("<robot name=\"r\"><link name=\"base\"/>{}{}{two}{loops}</robot>", link("a"), link("b"))
    };
    for (name, text, link) in [
        ("pins", pins(33_000), "a"),
        ("mimics", chain(20_000, true), "l20000"),
        ("tree", chain(60_000, false), "l60000"),
    ] {
        let model = folder.write(&format!("{name}.urdf"), &text);
        let outcome = bounded(&["mass", &model, "--link", link, "--point", "0,0,0", "--normal", "0,1,0"]);
        assert!((0..=2).contains(&outcome.code), "{name}: {}", outcome.stderr);
    }
}

#[test]
fn tables_and_meshes() {
    let folder = Scratch::new("bounded-files");
    let breaks = folder.write("breaks.csv", &format!("hinge\n\"{}\"\n", "\n".repeat(400_000)));
    let pendulum = pendulum();
    let contact = ["--link", "rod", "--point", "0,0,-0.8", "--normal", "1,0,0"];
    let sweep = [&["sweep", &pendulum][..], &contact, &["--input", &breaks]].concat();
    refused(&sweep, 2, &["breaks.csv:2"]);

    let positions = "0 0 0 1 0 0 0 1 0 ".repeat(20_000);
    let primitives =
        "<triangles><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p></triangles>"
            .repeat(20_000);
    let turns = "<rotate>0 0 1 1</rotate>".repeat(20_000);
    let instances = "<instance_node url=\"#n\"/>".repeat(20_000);
    let dae = format!(
        "<COLLADA><library_geometries><geometry id=\"g\"><mesh><source id=\"s\"><float_array>{positions}</float_array></source>\
         <vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/></vertices>{primitives}</mesh></geometry></library_geometries>\
         <library_nodes><node id=\"n\">{turns}</node></library_nodes><library_visual_scenes><visual_scene><node>{instances}\
         <instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes></COLLADA>"
    );
    let polygon = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2{}\n", " 3".repeat(6_000_000));
    let vertices = "v 0 0 0\n".repeat(15_000_001);
    let words = format!("solid x\nfacet{}\n", " a".repeat(20_000_000));
    for (name, text, code, words) in [
        ("shared.dae", &dae, 0, ""),
        ("polygon.obj", &polygon, 2, "line 4: more than 5000000 triangles"),
        ("vertices.obj", &vertices, 2, "line 15000001: more than 15000000 vertices"),
        ("words.stl", &words, 2, "line 2, facet 1: \"facet normal\" with three finite numbers is expected"),
    ] {
        folder.write(name, text);
        let model = folder.write(
            "robot.urdf",
            &format!(
                "<robot name=\"r\"><link name=\"base\"/><link name=\"a\">{INERTIAL}<collision><geometry><mesh filename=\"{name}\"/>\
                 </geometry></collision></link>{}</robot>",
                joint(1, "base", "a", [0.0, 0.0], "")
            ),
        );
        let outcome = bounded(&["map", &model, "--link", "a", "--edge", "1"]);
        assert_eq!(outcome.code, code, "{name}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{name}: {}", outcome.stderr);
        let _ = std::fs::remove_file(folder.path(name));
    }
}

/// MuJoCo's binary mesh: points on a sphere and a triangle for each.
fn sphere(points: usize) -> Vec<u8> {
    let counts = [points, 0, 0, points - 2].map(|count| (count as i32).to_le_bytes());
    let corner = |i: usize| {
        let (height, turn) = (2.0 * (i as f64 + 0.5) / points as f64 - 1.0, 2.4 * i as f64);
        let radius = (1.0 - height * height).sqrt();
        [radius * turn.cos(), radius * turn.sin(), height].map(|x| (x as f32).to_le_bytes())
    };
    let faces = (0..points as i32 - 2).flat_map(|i| [i, i + 1, i + 2]).map(i32::to_le_bytes);
    let all = counts.into_iter().chain((0..points).flat_map(corner)).chain(faces);
    all.flatten().collect()
}

/// Models whose cost grew with the square of their size, or without a limit.
#[test]
fn models_in_mjcf_and_sdformat() {
    const SECONDS: usize = 5;
    let folder = Scratch::new("bounded-formats");
    let body = "<joint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>";
    let mjcf = |bodies: &str, head: &str| format!("<mujoco>{head}<worldbody>{bodies}</worldbody></mujoco>");
    let count = 20_000;
    let geoms = format!("<body>{body}{}</body>", "<geom size=\"1\"/>".repeat(count));
    let nested: String = (0..200).map(|i| format!("<default class=\"c{i}\"><geom size=\"1\"/>")).collect();
    let nested = format!("<default>{nested}{}</default>", "</default>".repeat(200));
    let of_class = format!("<body>{body}{}</body>", "<geom class=\"c199\"/>".repeat(count));
    let keys = format!("<keyframe>{}</keyframe>", "<key qpos=\"1\"/>".repeat(count));
    let assets: String = (0..100)
        .map(|i| format!("<mesh name=\"m{i}\" file=\"s.msh\" inertia=\"convex\" scale=\"1 1 {}\"/>", 1 + i))
        .collect();
    let meshes: String =
        (0..100).map(|i| format!("<body><joint/><geom type=\"mesh\" mesh=\"m{i}\"/></body>")).collect();
    std::fs::write(folder.path("s.msh"), sphere(6_000)).expect("a mesh");
    let own =
        "<asset><model name=\"x\" file=\"own.xml\"/><model name=\"y\" file=\"own.xml\"/></asset>".repeat(100);
    let site = format!("<site user=\"{}\"/>", "1 ".repeat(500_000));
    let copies: String =
        (0..1_000).map(|i| format!("<body><attach body=\"a\" prefix=\"p{i}\"/></body>")).collect();
    let (mut links, mut joints) = (String::new(), String::new());
    for i in 0..20_000 {
        let parent = if i == 0 { "world".to_owned() } else { format!("l{}", i - 1) };
        let relative = if i == 0 { String::new() } else { format!(" relative_to=\"{parent}\"") };
        let _ = write!(links, "<link name=\"l{i}\"><pose{relative}>0.1 0 0 0 0.1 0</pose></link>");
        let _ = write!(
            joints,
            "<joint name=\"j{i}\" type=\"revolute\"><parent>{parent}</parent><child>l{i}</child></joint>"
        );
    }
    let chain = format!("<sdf version=\"1.9\"><model name=\"m\">{links}{joints}</model></sdf>");
    let names: String = (0..5_000)
        .map(|i| format!("<frame name=\"f{i}\"><pose relative_to=\"{}\"/></frame>", "::".repeat(1_000)))
        .collect();
    let names = format!("<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"/>{names}</model></sdf>");
    for (name, text, code, words) in [
        ("defaults.xml", mjcf(&geoms, &format!("<default>{}</default>", "<geom/>".repeat(count))), 0, ""),
        ("classes.xml", mjcf(&of_class, &nested), 0, ""),
        ("keys.xml", mjcf(&format!("<body>{body}</body>").repeat(count), &keys), 0, "19950 more warnings"),
        ("hulls.xml", mjcf(&meshes, &format!("<asset>{assets}</asset>")), 2, "too many vertices in all"),
        ("own.xml", mjcf("", &own), 2, "150 more errors"),
        (
            "copies.xml",
            mjcf(&format!("<body name=\"a\">{body}{site}</body>{copies}"), ""),
            2,
            "MiB of copies",
        ),
        ("replicate.xml", mjcf("<replicate count=\"1000000000\"/>", ""), 2, "copies of <replicate>"),
        ("chain.sdf", chain, 0, ""),
        ("names.sdf", names, 2, "4950 more errors"),
    ] {
        let outcome = bounded_by(SECONDS, &["check", &folder.write(name, &text)]);
        let message = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == code && message.contains(words), "{name}: {} {message}", outcome.code);
    }
}

/// A search over many joints ends at the limit of its work, and every output says so.
#[test]
fn extremes_of_many_joints() {
    const SECONDS: usize = 60;
    let folder = Scratch::new("bounded-extremes");
    let text = chain(150, false)
        .replace("type=\"continuous\"", "type=\"revolute\"")
        .replace("</joint>", "<limit lower=\"-2\" upper=\"2\" effort=\"1\" velocity=\"1\"/></joint>");
    let model = folder.write("chain.urdf", &text);
    let arguments = ["extremes", &model, "--link", "l150", "--point", "0.1,0.02,0", "--normal", "0.3,1,0.2"];
    let outcome = bounded_by(SECONDS, &[&arguments[..], &["--format", "json"]].concat());
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("JSON");
    for extreme in [&report["least"], &report["most"]] {
        assert_eq!(extreme["is_stopped"], true, "{extreme}");
        assert!(extreme["starts"].as_u64() < report["starts"].as_u64(), "{extreme}");
    }
}

/// Stops beyond the reach of the mechanism: the search for the smallest gap takes at most 0.4 s in this profile. The gap that is
/// closed does not depend on the gap as drawn.
#[test]
fn stops_out_of_reach() {
    const SECONDS: usize = 3;
    let folder = Scratch::new("bounded-stops");
    let templates = [
        "double-wishbone",
        "macpherson-strut",
        "five-link",
        "multi-link",
        "twist-beam",
        "solid-axle-panhard",
    ];
    for template in templates {
        let text = bounded(&["template", template, "--unit", "mm"]).stdout;
        let stop = if template.starts_with("solid") { "bump_stop_left" } else { "bump_stop" };
        let closed = [300, 400].map(|gap| {
            let (head, section) = text.split_once("[bump_stop]\n").expect("a stop");
            let old = section.lines().find(|line| line.starts_with("gap = ")).expect("a gap");
            let section = section.replacen(old, &format!("gap = {gap}"), 1);
            let sheet = folder.write("far.toml", &format!("{head}[bump_stop]\n{section}"));
            let outcome = bounded_by(SECONDS, &["mass", &sheet, "--at", stop]);
            let message = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(outcome.code == 1 && message.contains("cannot be reached"), "{template}: {message}");
            let (_, rest) = message.split_once("it closes by ").expect("the closed part");
            rest.split(' ').next().expect("a length").to_owned()
        });
        assert_eq!(closed[0], closed[1], "{template}");
    }
}
