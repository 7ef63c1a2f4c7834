//! The checked-in header matches the sources; the library exports the listed symbols and no others.
//!
//! `PERCUSS_UPDATE=1 cargo test -p percuss-capi --test capi` rewrites both files.

use crate::built::folder;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn crate_folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

const NOTICE: &str = "/* percuss: the effective mass of a mechanism at a contact. Made by cbindgen from crates/capi/src; not written by \
                      hand. docs/howto/C.md says how it is used. */";

/// Attribute of all functions with a status, except those that free a handle.
const NODISCARD: &str = "/* A compiler of C++17 or C23 warns of a status that is not read. */\n#ifndef PERCUSS_NODISCARD\n\
                         #if (defined(__cplusplus) && __cplusplus >= 201703L) || \
                         (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 202311L)\n\
                         #define PERCUSS_NODISCARD [[nodiscard]]\n#else\n#define PERCUSS_NODISCARD\n#endif\n#endif\n\n";

fn versions() -> String {
    let (major, minor, patch) =
        (env!("CARGO_PKG_VERSION_MAJOR"), env!("CARGO_PKG_VERSION_MINOR"), env!("CARGO_PKG_VERSION_PATCH"));
    let version = env!("CARGO_PKG_VERSION");
    format!(
        "\n/* The version of this header. While the first number is 0, the second changes with every change that programs must be\n   \
         compiled again for. */\n#define PERCUSS_VERSION \"{version}\"\n#define PERCUSS_VERSION_MAJOR {major}\n\
         #define PERCUSS_VERSION_MINOR {minor}\n#define PERCUSS_VERSION_PATCH {patch}\n\n\
         {NODISCARD}\
         /* No link: the ground. */\n#define PERCUSS_GROUND SIZE_MAX\n\n\
         /* No link is given: the link of a contact before it is set. */\n#define PERCUSS_NO_LINK (SIZE_MAX - 1)"
    )
}

/// Types first, in reading order.
const FILES: [&str; 20] = [
    "boundary/status",
    "version",
    "setup/model",
    "setup/builder",
    "setup/conditions",
    "setup/configuration",
    "setup/system",
    "evaluation/contact",
    "evaluation/pose",
    "evaluation/touch",
    "evaluation/response",
    "evaluation/impact",
    "evaluation/workspace",
    "evaluation/batch",
    "evaluation/derivatives",
    "evaluation/contact_map",
    "evaluation/path",
    "laws",
    "suspension",
    "ask",
];

fn generated() -> String {
    let config = cbindgen::Config {
        language: cbindgen::Language::C,
        cpp_compat: true,
        include_guard: Some("PERCUSS_H".into()),
        header: Some(NOTICE.into()),
        no_includes: true,
        sys_includes: vec!["stddef.h".into(), "stdint.h".into()],
        after_includes: Some(versions()),
        usize_is_size_t: true,
        line_length: 120,
        tab_width: 2,
        style: cbindgen::Style::Both,
        documentation: true,
        documentation_style: cbindgen::DocumentationStyle::C,
        sort_by: cbindgen::SortKey::None,
        export: cbindgen::ExportConfig {
            exclude: vec!["PERCUSS_GROUND".into(), "PERCUSS_NO_LINK".into()],
            ..Default::default()
        },
        ..Default::default()
    };
    let mut builder = cbindgen::Builder::new().with_config(config);
    for file in FILES.into_iter().chain(["dense"]) {
        builder = builder.with_src(crate_folder().join("src").join(format!("{file}.rs")));
    }
    let mut bytes = Vec::new();
    builder.generate().expect("sources that cbindgen reads").write(&mut bytes);
    let text = String::from_utf8(bytes).expect("UTF-8");
    let is_checked = |line: &str| {
        let name = line.strip_prefix("percuss_status percuss_").and_then(|rest| rest.split('(').next());
        name.is_some_and(|name| !name.ends_with("_free"))
    };
    let marked = |line: &str| {
        if is_checked(line) { format!("PERCUSS_NODISCARD {line}\n") } else { format!("{line}\n") }
    };
    text.replace(" # Safety\n", " Pointers:\n").lines().map(marked).collect()
}

fn names(header: &str) -> BTreeSet<String> {
    let before = |at: usize| {
        let start = header[..at].rfind(|c: char| !(c.is_alphanumeric() || c == '_')).map_or(0, |i| i + 1);
        header[start..at].to_owned()
    };
    let found = header.match_indices('(').map(|(at, _)| before(at));
    found.filter(|name| name.starts_with("percuss_")).collect()
}

/// Compares a file with the expected text, or rewrites the file if PERCUSS_UPDATE is set.
fn assert_same_text(path: &Path, expected: &str) {
    if std::env::var_os("PERCUSS_UPDATE").is_some() {
        fs::write(path, expected).expect("a file that can be written");
    }
    let found = fs::read_to_string(path).unwrap_or_default();
    assert!(
        found == expected,
        "{} is not what the sources say; PERCUSS_UPDATE=1 cargo test -p percuss-capi --test capi writes it anew",
        path.display()
    );
}

#[test]
fn the_header_is_fresh() {
    assert_same_text(&crate_folder().join("include/percuss.h"), &generated());
}

#[test]
fn every_file_with_functions_is_in_the_header() {
    let mut folders = vec![crate_folder().join("src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("sources").flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = fs::read_to_string(&path).expect("a readable file");
            let mut files = FILES.into_iter().chain(["dense"]);
            let listed = files.any(|file| path == crate_folder().join("src").join(format!("{file}.rs")));
            assert!(listed || !text.contains("#[unsafe(no_mangle)]"), "{} is not in FILES", path.display());
        }
    }
}

#[test]
fn the_exports_are_those_of_the_list() {
    // The header generated from the sources: with PERCUSS_UPDATE, another test may not have written the file yet.
    let header = generated();
    let declared: BTreeSet<String> = names(&header)
        .into_iter()
        .filter(|name| header.contains(&format!(" {name}(")) || header.contains(&format!("*{name}(")))
        .collect();
    assert!(declared.len() > 40, "only {} functions were found", declared.len());
    let list: String = declared.iter().map(|name| format!("{name}\n")).collect();
    assert_same_text(&crate_folder().join("symbols.txt"), &list);
    if !cfg!(target_os = "linux") {
        println!("the shared library's own table is read on Linux only");
        return;
    }
    let library: PathBuf = folder().join("libpercuss_c.so");
    let output = Command::new("nm").args(["-D", "--defined-only"]).arg(&library).output();
    let output = output.expect("nm, of the binutils that come with a C compiler");
    assert!(output.status.success(), "nm {}: {}", library.display(), String::from_utf8_lossy(&output.stderr));
    let table = String::from_utf8(output.stdout).expect("text");
    let exported: BTreeSet<String> =
        table.lines().filter_map(|l| l.split(' ').nth(2)).map(str::to_owned).collect();
    assert_eq!(exported, declared);
}
