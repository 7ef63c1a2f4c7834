//! C and C++ programs with the library: compiled with all warnings as errors, linked statically and dynamically, and
//! run.
//!
//! Needs a C compiler (`CC`, else cc) and a C++ compiler (`CXX`, else c++); the tests fail without them. Programs are
//! linked with the installed libraries (`packaging/install.sh`).

use crate::built::folder;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

fn crate_folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[derive(Clone, Copy, PartialEq)]
enum Linked {
    Static,
    Shared,
}

fn run(command: &mut Command) -> Output {
    let output = command.output().unwrap_or_else(|error| {
        panic!(
            "{:?} does not run: {error}; a C and a C++ compiler are needed (CC, CXX)",
            command.get_program()
        )
    });
    assert!(
        output.status.success(),
        "{command:?}: {}\n{}{}",
        output.status,
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    output
}

/// Installation folder of the library.
fn prefix() -> &'static Path {
    static PREFIX: OnceLock<PathBuf> = OnceLock::new();
    PREFIX.get_or_init(|| {
        let prefix = Path::new(env!("CARGO_TARGET_TMPDIR")).join("prefix");
        let mut install = Command::new("sh");
        install.arg(crate_folder().join("packaging/install.sh"));
        run(install.arg("--prefix").arg(&prefix).arg("--libraries").arg(folder()));
        prefix
    })
}

/// Compiles and runs a program; returns its output.
fn program(source: &str, linked: Linked) -> String {
    let is_c = source.ends_with(".c");
    let (variable, default, standard) =
        if is_c { ("CC", "cc", "-std=c11") } else { ("CXX", "c++", "-std=c++17") };
    let compiler = std::env::var(variable).unwrap_or_else(|_| default.into());
    let kind = if linked == Linked::Static { "static" } else { "shared" };
    let name = Path::new(source).file_name().expect("a name").to_string_lossy().replace('.', "_");
    let binary = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}_{kind}"));
    let mut compile = Command::new(compiler);
    compile.args([standard, "-O1", "-g", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]);
    compile.arg("-I").arg(prefix().join("include")).arg(crate_folder().join(source)).arg("-o").arg(&binary);
    let libraries = prefix().join("lib");
    match linked {
        Linked::Static => {
            compile.arg(libraries.join("libpercuss.a")).args(["-lpthread", "-ldl", "-lm"]);
            if cfg!(target_os = "linux") {
                compile.args(["-lutil", "-lrt"]);
            }
        }
        Linked::Shared => {
            compile.arg("-L").arg(&libraries).args(["-lpercuss", "-lpthread", "-lm"]);
            compile.arg(format!("-Wl,-rpath,{}", libraries.display()));
        }
    }
    run(&mut compile);
    // The guide has paths of models from the root of the repository.
    let mut start = Command::new(&binary);
    String::from_utf8(run(start.current_dir(crate_folder().join("../.."))).stdout).expect("text")
}

#[test]
fn every_function_answers() {
    for linked in [Linked::Static, Linked::Shared] {
        assert!(program("tests/c/api.c", linked).contains("every function answered"));
    }
}

#[test]
fn derivatives_agree() {
    for linked in [Linked::Static, Linked::Shared] {
        assert!(program("tests/c/derivatives.c", linked).contains("every derivative agrees"));
    }
}

#[test]
fn built_models_agree() {
    for linked in [Linked::Static, Linked::Shared] {
        assert!(program("tests/c/builder.c", linked).contains("every built model agrees"));
    }
}

#[test]
fn poses_at_stops_and_of_mujoco() {
    assert!(program("tests/c/poses.c", Linked::Static).contains("every pose was reached"));
}

#[test]
fn misuse_gives_errors() {
    assert!(program("tests/c/misuse.c", Linked::Static).contains("every misuse was noticed"));
}

/// Input rules × entry points of C; this test checks the number of tested combinations.
#[test]
fn every_rule_holds_at_every_entry_point() {
    let printed = program("tests/c/rules.c", Linked::Static);
    assert!(printed.contains("230 cases of rule and entry point"), "{printed}");
}

/// glibc's function feenableexcept enables traps of floating-point arithmetic.
#[test]
#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn callers_with_traps_meet_none() {
    let printed = program("tests/c/traps.c", Linked::Static);
    assert!(printed.contains("calls without a trap"), "{printed}");
}

#[test]
fn two_threads() {
    assert!(program("tests/c/threads.c", Linked::Static).contains("two threads"));
}

#[test]
fn layouts_are_as_programs_were_compiled_for() {
    program("tests/c/abi.c", Linked::Static);
    program("tests/c/abi_cxx.cc", Linked::Shared);
}

#[test]
fn the_layer_for_cxx() {
    for linked in [Linked::Static, Linked::Shared] {
        assert!(program("tests/c/wrapper.cc", linked).contains("C++"));
    }
}

/// The examples in C of the book, each as a function of one program.
#[test]
fn the_book_computes_the_stated_masses() {
    let pages = ["howto/C.md", "howto/KINEMATICS.md", "tutorials/SUSPENSION.md"]
        .map(|page| std::fs::read_to_string(crate_folder().join("../../docs").join(page)).expect("a page"));
    let book = pages.concat();
    let examples: Vec<&str> =
        book.split("```c\n").skip(1).map(|rest| rest.split("```").next().unwrap_or_default()).collect();
    let mut text = "#include <percuss.h>\n#include <stdio.h>\n#include <stdlib.h>\n".to_owned();
    let mut calls = String::new();
    for (number, example) in examples.iter().enumerate() {
        text += &format!("static void example_{number}(void) {{\n{example}\n}}\n");
        calls += &format!("example_{number}();\n");
    }
    text += &format!("int main(void) {{\n{calls}return 0; }}\n");
    let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join("guide.c");
    std::fs::write(&source, text).expect("a file");
    let printed = program(source.to_str().expect("UTF-8"), Linked::Shared);
    assert!(
        examples.len() == 4 && printed.contains("151.081 kg") && printed.contains("percuss.report/1"),
        "{printed}"
    );
}

#[test]
fn the_example_rebounds_as_asked() {
    let printed = program("examples/rebound.c", Linked::Shared);
    assert!(printed.contains("all rebounds as asked"), "{printed}");
}
