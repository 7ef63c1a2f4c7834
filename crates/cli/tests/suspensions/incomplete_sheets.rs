//! Sheets without masses, and without the points of a part.

use super::kinematics::rows;
use crate::support::Scratch;
use crate::support::{done, run_in as run};

/// A sheet without masses has the same kinematics; the unsprung mass names the missing masses, the wheel rate the missing points.
#[test]
fn kinematics_need_no_masses() {
    let folder = Scratch::new("kinematics-massless");
    let text = done(&folder, &["template", "double-wishbone"]);
    let text = text.replacen("[spring]", "[spring]\nrate = \"35 N/mm\"", 1);
    folder.write("car.toml", &text);
    let is_mass = |line: &&str| ["mass =", "com =", "inertia ="].iter().any(|key| line.starts_with(key));
    folder.write("points.toml", &text.lines().filter(|line| !is_mass(line)).collect::<Vec<_>>().join("\n"));
    let range = ["--wheel-travel", "-40mm:40mm:3"];
    for (row, bare) in rows(&folder, "car.toml", &range).iter().zip(&rows(&folder, "points.toml", &range)) {
        for (name, value) in
            row.as_object().expect("a row").iter().filter(|(name, _)| *name != "unsprung_mass")
        {
            assert_eq!(&bare[name], value, "{name}");
        }
        assert!(bare["unsprung_mass"].is_null() && !row["unsprung_mass"].is_null());
    }
    let told = done(&folder, &["kinematics", "points.toml"]);
    assert!(told.contains("masses are missing in the sheet: lower_arm.mass"), "{told}");
    let outcome = run(&folder, &["mass", "points.toml", "--at", "bump_stop"]);
    assert!(outcome.code == 2 && outcome.stderr.contains("lower_arm.mass"), "{}", outcome.stderr);
    let study = "[model]\npath = \"points.toml\"\n[kinematics]\nvary = \"wheel-travel=-40mm:40mm:3\"\ncolumns = [\"camber\"]\n";
    folder.write("study.toml", study);
    folder.write("both.toml", &format!("{study}[contact]\nat = \"bump_stop\"\n"));
    let of_command = done(&folder, &["kinematics", "points.toml", "--columns", "camber", range[0], range[1]]);
    assert_eq!(done(&folder, &["run", "study.toml"]), of_command);
    let outcome = run(&folder, &["run", "both.toml"]);
    assert!(outcome.code == 2 && outcome.stderr.contains("lower_arm.mass"), "{}", outcome.stderr);
    folder.write(
        "cut.toml",
        &text.lines().filter(|line| !line.starts_with("spring_")).collect::<Vec<_>>().join("\n"),
    );
    let told = done(&folder, &["kinematics", "cut.toml", "--columns", "wheel_rate"]);
    assert!(told.contains("the sheet has spring.rate") && told.contains("spring_chassis_seat"), "{told}");
}
