//! Malformed files: the files of `tests/malformed` with one defect each, and large files generated here.
//!
//! `UPDATE_EXPECTED=1 cargo test -p percuss-formats malformed` writes the expected messages anew; check the
//! difference.

use crate::support;
use crate::support::{PENDULUM, bounded, codes, load_text};
use percuss_formats::{LoadError, LoadOptions, Source, load};
use percuss_mechanism::Severity;
use std::fmt::Write;
use std::path::{Path, PathBuf};

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/malformed")
}

fn models(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the corpus is there");
    let mut files: Vec<PathBuf> = entries.map(|e| e.expect("a readable entry").path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e == "urdf" || e == "sdf"));
    files.sort();
    files
}

fn load_file(path: &Path) -> Result<percuss_formats::Loaded, LoadError> {
    let mut source = Source::read(path.to_str().expect("a name in UTF-8"), 1 << 20)?;
    source.name = path.file_name().expect("a file").to_string_lossy().into_owned();
    load(&source, &LoadOptions::default())
}

#[test]
fn every_malformed_file_is_refused_with_the_expected_words() {
    let refused = models(&corpus());
    let warned = models(&corpus().join("warned"));
    assert!(refused.len() >= 140, "only {} malformed files were found", refused.len());
    assert!(warned.len() >= 35, "only {} doubtful files were found", warned.len());
    let mut found = String::new();
    for path in &refused {
        let error = load_file(path).err().unwrap_or_else(|| panic!("{} loads", path.display()));
        assert!(error.diagnostics.iter().any(|d| d.severity == Severity::Error), "{}", path.display());
        error.diagnostics.iter().for_each(|d| writeln!(found, "{d} [{}]", d.code).unwrap());
    }
    for path in &warned {
        let loaded = load_file(path).unwrap_or_else(|e| panic!("{} is refused: {e}", path.display()));
        assert!(!loaded.diagnostics.is_empty(), "{} raises no doubt", path.display());
        loaded.diagnostics.iter().for_each(|d| writeln!(found, "warned/{d} [{}]", d.code).unwrap());
    }
    let expected = corpus().join("expected.txt");
    if std::env::var_os("UPDATE_EXPECTED").is_some() {
        std::fs::write(&expected, &found).expect("the expectations can be written");
    }
    let expected = std::fs::read_to_string(expected).expect("expected.txt is there");
    for (line, expected) in found.lines().zip(expected.lines()) {
        assert_eq!(line, expected);
    }
    assert_eq!(found, expected, "expected.txt has other lines at its end");
}

/// Checks a defect of a file that is too large for the repository.
fn refused(what: &str, text: impl Into<Vec<u8>>, code: &str) {
    let source = Source::new(what, text.into());
    let result = bounded(what, || load(&source, &LoadOptions::default()));
    assert!(result.is_err(), "{what} loads");
    assert!(codes(&result).contains(&(Severity::Error, code)), "{what}: {:?}", support::told(&result));
    assert!(support::told(&result).len() <= 153, "{what}: too many diagnostics");
}

#[test]
fn hostile_sizes_are_refused_in_bounded_time() {
    let deep = 100_000;
    refused("deep", format!("<robot>{}{}</robot>", "<a>".repeat(deep), "</a>".repeat(deep)), "too-complex");
    refused("deep and open", format!("<robot>{}", "<link>".repeat(deep)), "too-complex");
    refused("elements", format!("<robot>{}</robot>", "<a/>".repeat(2_000_000)), "too-complex");
    refused("tags", "<".repeat(8 << 20), "too-complex");
    refused("comments", format!("<robot>{}</robot>", "x<!---->".repeat(1_600_000)), "too-complex");
    let attributes: String = (0..300).map(|i| format!(" a{i}=\"\"")).collect();
    refused("attributes of one", format!("<robot{attributes}/>"), "too-complex");
    let one = format!("<a{}/>", (0..200).map(|i| format!(" a{i}=\"\"")).collect::<String>());
    refused("attributes of all", format!("<robot>{}</robot>", one.repeat(15_500)), "too-complex");
    let spaces: String = (0..200).map(|i| format!("<a xmlns:n{i}=\"u{i}\"/>")).collect();
    refused("namespaces", format!("<robot>{spaces}</robot>"), "too-complex");
    let links: String = (0..100_001).map(|i| format!("<link name=\"{i}\"/>")).collect();
    refused("links", format!("<robot>{links}</robot>"), "too-complex");
    let joints = "<joint/>".repeat(100_000);
    refused(
        "joints that lack all",
        format!("<robot><link name=\"a\"/>{joints}</robot>"),
        "missing-attribute",
    );
    let strangers: String = (0..200_000).map(|i| format!("<linc{i} nmae{i}=\"\"/>")).collect();
    refused("strangers", format!("<robot>{strangers}</robot>"), "no-links");
    refused("a long name", format!("<robot><link name=\"{}\"/></robot>", "a".repeat(8 << 20)), "long-name");
    refused("a long line", format!("<robot>{}<link/></robot>", "é".repeat(4 << 20)), "missing-attribute");
    let comments = "<!---->".repeat(400_000);
    let robot = "<link/>".repeat(50_000);
    refused("comments first", format!("{comments}<robot xmlns=\"u\">{robot}</robot>"), "missing-attribute");
}

#[test]
fn hostile_references_are_refused_in_bounded_time() {
    let name = |i: usize| format!("{:0>150}", i);
    let joint = |i: usize, parent: usize, child: usize, rest: &str| {
        let (name, parent, child) = (name(i), name(parent), name(child));
        format!(
            "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/>{rest}</joint>"
        )
    };
    let robot = |links: usize, joints: &dyn Fn(usize) -> String| {
        let links: String = (0..links).map(|i| format!("<link name=\"{}\"/>", name(i))).collect();
        let joints: String = (0..30_000).map(joints).collect();
        format!("<robot>{links}{joints}</robot>")
    };
    let floating = |i: usize, rest: &str| joint(i, 0, 1, rest).replace("continuous", "floating");
    let m1 = format!("<mimic joint=\"{}\"/>", name(1));
    refused("unknown links", robot(30_000, &|i| joint(i, i, 900_000 + i, "")), "unknown-link");
    let mimic = |i: usize| format!("<mimic joint=\"{}\"/>", name(i));
    refused("strange masters", robot(2, &|i| floating(i, &mimic(900_000 + i))), "two-parents");
    refused("a chain of mimics", robot(2, &|i| joint(i, 0, 1, &mimic(i + 1))), "mimic-chain");
    refused("a circle of mimics", robot(2, &|i| joint(i, 0, 1, &mimic((i + 1) % 90))), "mimic-cycle");
    refused("a star of parents", robot(2, &|i| floating(i, "")), "two-parents");
    refused("followers", robot(2, &|i| joint(i, 0, 1, if i < 2 { "" } else { &m1 })), "mimic-of-closure");
}

#[test]
fn hostile_loops_are_refused_in_bounded_time() {
    const COUNT: usize = 30_000;
    let chain: String = (1..COUNT)
        .map(|i| {
            format!(
                "<link name=\"{i}\"/><joint name=\"{i}\" type=\"continuous\"><parent link=\"{}\"/>\
                 <child link=\"{i}\"/></joint>",
                i - 1
            )
        })
        .collect();
    let with = |more: &dyn Fn(usize) -> String| {
        let more: String = (1..COUNT).map(more).collect();
        format!("<robot><link name=\"0\"/>{chain}{more}</robot>")
    };
    let held = |from: usize, to: usize| format!("<predecessor link=\"{from}\"/><successor link=\"{to}\"/>");
    let coupling = |i: usize, from: usize, to: usize| {
        format!("<coupling name=\"c{i}\">{}<ratio value=\"2\"/></coupling>", held(from, to))
    };
    let ball = |name: usize, from: usize, to: usize| {
        format!("<loop name=\"{name}\" type=\"spherical\">{}</loop>", held(from, to))
    };
    refused("long paths", with(&|i| coupling(i, 0, i)), "too-complex");
    refused("a circle of couplings", with(&|i| coupling(i, i % 50, (i + 1) % 50)), "coupling-cycle");
    refused("strange links of loops", with(&|i| ball(i, i, 900_000 + i)), "unknown-link");
    refused("loops of one name", with(&|i| ball(7, i, 0)), "duplicate-name");
    refused("loops to themselves", with(&|i| ball(i, i, i)), "closes-on-itself");
    let many = "<loop/>".repeat(100_001);
    refused("loops", format!("<robot><link name=\"0\"/>{many}</robot>"), "too-complex");
    let circle = "<link name=\"a\"/><link name=\"b\"/>\
                  <joint name=\"1\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\
                  <joint name=\"2\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint>\
                  <coupling name=\"c\"><predecessor link=\"a\"/><successor link=\"b\"/><ratio value=\"2\"/></coupling>";
    refused("a coupling in a circle of links", format!("<robot>{circle}</robot>"), "cycle");
    // Thousands of valid elements load.
    let text = with(&|i| if i < 200 { coupling(i, i, i + 1) } else { ball(i, 0, i) });
    let loaded = bounded("valid elements", || load_text(&text)).unwrap();
    assert_eq!((loaded.mechanism.couplings().len(), loaded.mechanism.closures().len()), (199, COUNT - 200));
}

#[test]
fn entities_that_grow_are_refused() {
    let doctype = |entities: &str| format!("<!DOCTYPE robot [{entities}]>\n");
    let mut laughs = String::from("<!ENTITY a0 \"ha\">");
    for i in 1..12 {
        write!(laughs, "<!ENTITY a{i} \"{}\">", format!("&a{};", i - 1).repeat(10)).unwrap();
    }
    let robot = |use_: &str| format!("<robot name=\"{use_}\"><link name=\"a\"/></robot>");
    refused("billion laughs", doctype(&laughs) + &robot("&a11;"), "not-xml");
    let long = format!("<!ENTITY a \"{}\">", "ha".repeat(1 << 20));
    refused("quadratic growth", doctype(&long) + &robot(&"&a;".repeat(1 << 20)), "too-complex");
    let many: String = (0..100).map(|i| format!("<!ENTITY a{i} \"b\">")).collect();
    refused("many entities", doctype(&many) + &robot("&a1;"), "too-complex");
    // A quote in another declaration must not hide the following text from the scan.
    let deep = format!("<robot>{}", "<a>".repeat(1_000));
    refused("a stray quote", doctype("<!ELEMENT robot '>") + &deep, "too-complex");
    refused("a bracket in a name", format!("<!DOCTYPE robot SYSTEM \"a[\">{deep}"), "too-complex");
    refused("a quote in a comment", doctype("<!-- ' -->") + &deep, "too-complex");
}

#[test]
fn an_entity_that_stands_for_a_number_is_read() {
    let text = PENDULUM
        .replace("<robot name", "<!DOCTYPE robot [<!ENTITY m \"2.5\">]>\n<robot name")
        .replace("value=\"2\"", "value=\"&m;\"");
    let loaded = load_text(&text).unwrap();
    assert_eq!(loaded.mechanism.total_mass(), 2.5);
}

#[test]
fn what_is_no_text_is_refused() {
    refused("junk", (0..4096u32).map(|i| (i * 167 % 251) as u8).collect::<Vec<u8>>(), "binary");
    refused("bytes", vec![0x80u8; 100], "not-utf-8");
    let wide: Vec<u8> = PENDULUM.encode_utf16().flat_map(u16::to_be_bytes).collect();
    refused("UTF-16 without a mark", wide.clone(), "utf-16");
    refused("UTF-16 with a mark", [vec![0xFE, 0xFF], wide].concat(), "utf-16");
    let marked = [b"\xEF\xBB\xBF".to_vec(), PENDULUM.as_bytes().to_vec()].concat();
    assert!(load(&Source::new("marked", marked), &LoadOptions::default()).is_ok());
}

#[test]
fn a_file_cut_anywhere_is_refused() {
    let last = PENDULUM.rfind('>').unwrap();
    let mut cuts = 0;
    for end in (0..=last).step_by(10) {
        let result = load_text(&PENDULUM[..end]);
        assert!(result.is_err(), "cut at byte {end} it loads");
        cuts += 1;
    }
    assert!(cuts > 50);
}

#[test]
fn files_that_cannot_be_read_are_refused() {
    let folder = env!("CARGO_MANIFEST_DIR");
    let file = format!("{folder}/src/lib.rs");
    let size = std::fs::metadata(&file).unwrap().len();
    for (path, limit, code) in [
        (format!("{folder}/no-such.urdf"), 1000, "no-such-file"),
        (folder.to_owned(), 1000, "directory"),
        (file.clone(), size - 1, "too-large-file"),
        (format!("{file}/below"), 1000, "unreadable"),
    ] {
        let error = Source::read(&path, limit).unwrap_err();
        assert_eq!(error.diagnostics[0].code, code, "{error}");
        assert!(error.to_string().starts_with(&path), "{error}");
    }
    assert_eq!(Source::read(&file, size).unwrap().bytes.len() as u64, size);
    if Path::new("/dev/zero").exists() {
        assert_eq!(Source::read("/dev/zero", 1000).unwrap_err().diagnostics[0].code, "too-large-file");
    }
}

#[test]
fn errors_are_told_together_and_counted() {
    let links: String = (0..80)
        .map(|i| format!("<link name=\"l{i}\"><inertial><mass value=\"x\"/></inertial></link>\n"))
        .collect();
    let error = load_text(&format!("<robot name=\"r\">\n{links}</robot>")).unwrap_err();
    let bad = error.diagnostics.iter().filter(|d| d.code == "bad-number").count();
    assert_eq!(bad, 50);
    assert_eq!(
        error.diagnostics.iter().find(|d| d.code == "and-more").unwrap().message,
        "and 30 more errors"
    );
    assert_eq!(error.diagnostics.iter().find(|d| d.code == "bad-number").unwrap().line, Some(2));
}
