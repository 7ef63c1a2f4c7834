//! Corpus of `tests/malformed` on the command line: exit code 2, a message with its position, bounded time and
//! memory.

use crate::support::{Outcome, percuss, percuss_with_stdin, root, run};

fn corpus(folder: &str) -> Vec<String> {
    let mut files: Vec<String> = std::fs::read_dir(root().join(folder))
        .expect("the corpus is there")
        .map(|entry| entry.expect("a readable entry").file_name().to_string_lossy().into_owned())
        .filter(|name| name.ends_with(".urdf") || name.ends_with(".sdf"))
        .map(|name| format!("{folder}/{name}"))
        .collect();
    files.sort();
    files
}

fn assert_refused(what: &str, outcome: &Outcome) {
    assert_eq!(outcome.code, 2, "{what}: {}", outcome.stderr);
    assert!(outcome.stdout.is_empty(), "{what} prints a result");
    assert!(outcome.stderr.contains(": error: "), "{what}: {}", outcome.stderr);
    assert!(!outcome.stderr.contains("panicked"), "{what}: {}", outcome.stderr);
    assert!(outcome.stderr.len() < 100_000, "{what}: a message of {} bytes", outcome.stderr.len());
}

#[test]
fn malformed_files_are_refused() {
    let files = corpus("tests/malformed");
    assert!(files.len() >= 60, "only {} files", files.len());
    for file in &files {
        for line in [format!("check {file}"), format!("mass {file} --link a --point 0,0,0 --normal 0,0,1")] {
            let outcome = percuss(&line);
            assert_refused(file, &outcome);
            assert!(outcome.stderr.contains(file), "{file}: {}", outcome.stderr);
        }
    }
}

#[test]
fn doubtful_files_load_with_a_word() {
    for file in corpus("tests/malformed/warned") {
        let outcome = percuss(&format!("check {file} --notes"));
        assert_eq!(outcome.code, 0, "{file}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(&file), "{file}: {}", outcome.stderr);
    }
}

/// Runs `percuss check` on bytes; on Unix within 500 MB of address space and 20 s of processor time, which is less than a second
/// as a rule. Windows shells have no such limits.
fn check_bytes(what: &str, bytes: &[u8]) -> Outcome {
    let path = std::env::temp_dir().join(format!("percuss-{}-{what}.urdf", std::process::id()));
    std::fs::write(&path, bytes).expect("a temporary file");
    let outcome = if cfg!(unix) {
        std::process::Command::new("/bin/sh")
            .args(["-c", "ulimit -v 500000 2>/dev/null; ulimit -t 20; exec \"$0\" check \"$1\""])
            .arg(env!("CARGO_BIN_EXE_percuss"))
            .arg(&path)
            .output()
            .expect("the command runs")
            .into()
    } else {
        percuss(&format!("check {}", path.display()))
    };
    std::fs::remove_file(&path).expect("it was there");
    outcome
}

#[test]
fn hostile_files_are_refused_in_bounded_memory() {
    let deep = 100_000;
    let laughs: String =
        (1..30).map(|i| format!("<!ENTITY l{i} \"{}\">", format!("&l{};", i - 1).repeat(10))).collect();
    let many_links: String = (0..150_000).map(|i| format!("<link name=\"l{i}\"/>")).collect();
    let unknown: String = (0..100_000)
        .map(|i| {
            format!(
                "<joint name=\"j{i}\" type=\"fixed\"><parent link=\"p{i}\"/><child link=\"c{i}\"/></joint>"
            )
        })
        .collect();
    let cases: [(&str, Vec<u8>); 8] = [
        ("deep", format!("<robot>{}{}</robot>", "<a>".repeat(deep), "</a>".repeat(deep)).into()),
        ("deep-links", format!("<robot>{}", "<link name='a'>".repeat(deep)).into()),
        ("large", [b"<robot>".to_vec(), vec![b' '; 33 << 20], b"</robot>".to_vec()].concat()),
        ("junk", (0..200_000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8).collect()),
        ("utf-16", "<robot/>".encode_utf16().flat_map(u16::to_le_bytes).collect()),
        ("laughs", format!("<!DOCTYPE r [<!ENTITY l0 \"ha\">{laughs}]><robot name=\"&l29;\"/>").into()),
        ("roots", format!("<robot name=\"r\">{many_links}</robot>").into()),
        ("unknown", format!("<robot name=\"r\"><link name=\"a\"/>{unknown}</robot>").into()),
    ];
    for (what, bytes) in cases {
        assert_refused(what, &check_bytes(what, &bytes));
    }
}

#[test]
fn loops_that_positions_cannot_resolve_are_refused() {
    let arm = |name: &str, x: f64, y: f64| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/>\
             <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\
             <joint name=\"to_{name}\" type=\"continuous\"><parent link=\"base\"/><child link=\"{name}\"/>\
             <origin xyz=\"{x} {y} 0\"/><axis xyz=\"0 0 1\"/></joint>"
        )
    };
    for x in [1e13, 1e20, 1e90] {
        let text = format!(
            "<robot name=\"r\"><link name=\"base\"/>{}{}<loop name=\"pin\" type=\"revolute\">\
             <predecessor link=\"a\"><origin xyz=\"1 0 0\"/></predecessor>\
             <successor link=\"b\"><origin xyz=\"1 0 0\"/></successor><axis xyz=\"0 0 1\"/></loop></robot>",
            arm("a", x, 0.0),
            arm("b", x, 1.0)
        );
        let outcome = check_bytes("far-out", text.as_bytes());
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{x}: {}", outcome.stderr);
        for said in ["\"pin\"", "from the root link", "expected: at most", "move the root link"] {
            assert!(outcome.stderr.contains(said), "{x}: {}", outcome.stderr);
        }
    }
}

#[test]
fn a_file_cut_short_is_refused_wherever_it_is_cut() {
    let whole = std::fs::read(root().join("models/double_pendulum.urdf")).unwrap();
    let end = whole.iter().rposition(|b| *b == b'>').unwrap();
    let mut cuts = 0;
    for cut in (0..end).step_by(10) {
        assert_refused(&format!("cut at {cut}"), &percuss_with_stdin("check -", &whole[..cut]));
        cuts += 1;
    }
    assert!(cuts > 100);
}

#[test]
fn paths_that_are_no_file_are_refused() {
    let directory = percuss("check tests");
    assert_refused("a directory", &directory);
    assert!(directory.stderr.contains("this is a directory"), "{}", directory.stderr);
    assert_refused("a missing file", &percuss("check no/such/file.urdf"));
    assert_refused("an empty name", &run(["check", ""]));
    assert_refused("no stdin", &percuss_with_stdin("check -", b""));
}

/// Unix only: Windows has no such device, and its shells cannot close stdin.
#[cfg(unix)]
#[test]
fn an_endless_or_closed_input_is_refused() {
    assert_refused("an endless device", &percuss("check /dev/zero"));
    let closed = std::process::Command::new("/bin/sh")
        .args(["-c", "exec \"$0\" check - <&-"])
        .arg(env!("CARGO_BIN_EXE_percuss"))
        .stdout(std::process::Stdio::piped())
        .output();
    assert_refused("a closed stdin", &closed.unwrap().into());
}
