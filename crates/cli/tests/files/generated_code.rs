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

#[test]
fn bad_input_is_refused() {
    let folder = Scratch::new("generated-refusals");
    let output = folder.path("code");
    for (flags, message) in [
        (format!("{ARM} --close -o {output}"), "--close: the mechanism has no loops"),
        (format!("{ARM} --name Arm -o {output}"), "--name Arm: a prefix of names"),
        (format!("{ARM} --lock nothing -o {output}"), "--lock"),
        (format!("{ARM} --estimate forearm -o {output}"), "--estimate"),
        (
            format!("generate models/planar_2r.urdf --link outer --point 0,0,0 --normal 0,0,1 -o {output}"),
            "no motion of the mechanism closes this gap",
        ),
        (
            format!("generate models/six_r_arm.urdf --link tool -o {output}"),
            "a contact of the model is required",
        ),
    ] {
        let outcome = percuss(&flags);
        assert_eq!(outcome.code, 2, "{flags}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(message), "{flags}: {}", outcome.stderr);
    }
    // A file that percuss did not write stays.
    std::fs::create_dir_all(&output).expect("a folder");
    std::fs::write(format!("{output}/six_r_arm.c"), "int mine;\n").expect("a file");
    let outcome = percuss(&format!("{ARM} -o {output}"));
    assert_eq!(outcome.code, 2, "{}", outcome.stderr);
    assert!(outcome.stderr.contains("--force replaces it"), "{}", outcome.stderr);
    assert!(!std::path::Path::new(&format!("{output}/six_r_arm.h")).exists());
}
