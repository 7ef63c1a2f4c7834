//! `percuss generate`: files, self-test, refusals.

use crate::support::{Scratch, percuss};
use std::process::Command;

const ARM: &str = "generate models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1";

/// The self-test of the C code compiles without warnings and agrees with percuss; a second run replaces the files.
#[test]
fn the_self_test_agrees() {
    let folder = Scratch::new("generated-code");
    let output = folder.path("code");
    for _ in 0..2 {
        let outcome = percuss(&format!("{ARM} --velocity --gradient --mobility --batch -o {output}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        assert!(outcome.stdout.contains("six_r_arm_mass: 6 positions"), "{}", outcome.stdout);
    }
    let compiled = Command::new("cc")
        .args(["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-O1"])
        .args(["six_r_arm.c", "six_r_arm_test.c", "-lm", "-o", "self-test"])
        .current_dir(&output)
        .output()
        .expect("a C compiler");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let run = Command::new(format!("{output}/self-test")).output().expect("the program runs");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stdout));
}
