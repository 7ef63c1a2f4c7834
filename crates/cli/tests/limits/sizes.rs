//! Models of up to 60,000 links, on Unix within 1.5 GB of address space: a result, without an abort.

use crate::support::Outcome;
use std::fmt::Write;
use std::process::Command;

const LINK: &str = r#"<inertial><origin xyz="0.5 0 0"/><mass value="1"/><inertia ixx="0.01" iyy="0.09" izz="0.09" ixy="0" ixz="0" iyz="0"/></inertial>"#;

/// URDF under construction.
struct Model(String);

impl Model {
    fn new() -> Self {
        Self(r#"<robot name="large"><link name="base"/>"#.into())
    }

    fn link(&mut self, name: &str, inertial: &str) {
        let _ = write!(self.0, r#"<link name="{name}">{inertial}</link>"#);
    }

    /// Adds a hinge about `axis`, at `xyz` and rotated by `yaw` in the parent.
    fn hinge(&mut self, parent: &str, child: &str, xyz: [f64; 3], yaw: f64, axis: &str, more: &str) {
        let [x, y, z] = xyz;
        let _ = write!(
            self.0,
            r#"<joint name="to_{child}" type="continuous"><parent link="{parent}"/><child link="{child}"/><origin xyz="{x:?} {y:?} {z:?}" rpy="0 0 {yaw:?}"/><axis xyz="{axis}"/>{more}</joint>"#
        );
    }

    /// Adds a hinge about z that closes a loop.
    fn pin(&mut self, name: &str, on: &str, at: [f64; 2], against: &str, there: [f64; 2]) {
        let ([x, y], [u, v]) = (at, there);
        let _ = write!(
            self.0,
            r#"<loop name="{name}" type="revolute"><predecessor link="{on}"><origin xyz="{x:?} {y:?} 0"/></predecessor><successor link="{against}"><origin xyz="{u:?} {v:?} 0"/></successor><axis xyz="0 0 1"/></loop>"#
        );
    }

    /// Output of `percuss check`, and of `percuss mass` at a link.
    fn ask(mut self, name: &str, link: &str) -> [Outcome; 2] {
        self.0 += "</robot>";
        let path = std::env::temp_dir().join(format!("percuss-{name}-{}.urdf", std::process::id()));
        std::fs::write(&path, self.0).expect("room for the model");
        let run = |arguments: &[&str]| -> Outcome {
            // Windows shells cannot limit memory; there the models run without a limit.
            let mut command = if cfg!(unix) {
                let mut shell = Command::new("sh");
                shell.args([
                    "-c",
                    "ulimit -v 1500000 2>/dev/null; exec \"$0\" \"$@\"",
                    env!("CARGO_BIN_EXE_percuss"),
                ]);
                shell
            } else {
                Command::new(env!("CARGO_BIN_EXE_percuss"))
            };
            command.args(arguments).arg(&path);
            command.output().expect("the command runs").into()
        };
        let contact = ["--link", link, "--point", "0.5,0.1,0", "--normal", "0.3,1,0.1", "--format", "json"];
        let outcomes = [run(&["check"]), run(&[&["mass"], &contact[..]].concat())];
        let _ = std::fs::remove_file(path);
        outcomes
    }
}

/// Asserts success of both commands and returns m̄; `None` if not finite.
fn effective_mass(name: &str, [check, mass]: [Outcome; 2]) -> Option<f64> {
    assert_eq!(check.code, 0, "{name}: {}", check.stderr);
    assert_eq!(mass.code, 0, "{name}: {}", mass.stderr);
    let report: serde_json::Value = serde_json::from_str(&mass.stdout).expect("JSON on stdout");
    report["effective_mass"].as_f64()
}

fn chain(count: usize, inertial: &str) -> Model {
    let mut model = Model::new();
    for i in 0..count {
        let parent = if i == 0 { "base".into() } else { format!("l{}", i - 1) };
        model.link(&format!("l{i}"), inertial);
        let axis = ["0 0 1", "0 1 0", "1 0 0"][i % 3];
        model.hinge(&parent, &format!("l{i}"), [0.1, 0.02, 0.0], (i as f64).sin(), axis, "");
    }
    model
}

#[test]
fn chains() {
    let finite = effective_mass("chain", chain(20_000, LINK).ask("chain", "l19999")).expect("finite");
    // Mostly the mass of the last link.
    assert!((0.05..20.0).contains(&finite), "{finite}");
    assert_eq!(effective_mass("massless", chain(60_000, "").ask("massless", "l59999")), None);
}

#[test]
fn mimics_and_couplings() {
    let mut model = Model::new();
    model.link("m", LINK);
    model.hinge("base", "m", [0.0; 3], 0.0, "0 0 1", "");
    for i in 0..20_000 {
        model.link(&format!("l{i}"), LINK);
        let mimic = r#"<mimic joint="to_m" multiplier="1.5"/>"#;
        model.hinge("base", &format!("l{i}"), [0.0, 0.0, 0.01 * i as f64], 0.0, "0 0 1", mimic);
    }
    // Every link rotates with 0.34 kg·m² about its hinge. The contact link has 1.5 times the master's rate, and its
    // lever arm about z is (0.5 · 1 − 0.1 · 0.3)/|n|.
    let mass = effective_mass("mimics", model.ask("mimics", "l10000")).expect("finite");
    let arm = 1.5 * (0.5 - 0.03) / f64::sqrt(0.09 + 1.0 + 0.01);
    let expected = (1.0 + 20_000.0 * 1.5 * 1.5) * 0.34 / (arm * arm);
    assert!((mass / expected - 1.0).abs() < 1e-9, "{mass}, expected {expected}");
    let mut model = Model::new();
    for i in 0..=10_000 {
        model.link(&format!("l{i}"), LINK);
        model.hinge("base", &format!("l{i}"), [0.0, 0.0, 0.01 * i as f64], 0.0, "0 0 1", "");
    }
    for i in 0..10_000 {
        let _ = write!(
            model.0,
            r#"<coupling name="g{i}"><predecessor link="l{i}"/><successor link="l{}"/><ratio value="-1"/></coupling>"#,
            i + 1
        );
    }
    let mass = effective_mass("couplings", model.ask("couplings", "l9000")).expect("finite");
    let arm = (0.5 - 0.03) / f64::sqrt(0.09 + 1.0 + 0.01);
    let expected = 10_001.0 * 0.34 / (arm * arm);
    assert!((mass / expected - 1.0).abs() < 1e-9, "{mass}, expected {expected}");
}

#[test]
fn ladders_and_rings() {
    // Rungs of 0.5 m on the ground with connected tips: one degree of freedom; all rungs rotate by the same angle.
    let (rungs, length, angle) = (301, 0.5, 1.2_f64);
    let mut model = Model::new();
    for i in 0..rungs {
        model.link(&format!("r{i}"), LINK);
        model.hinge("base", &format!("r{i}"), [0.4 * i as f64, 0.0, 0.0], angle, "0 0 1", "");
    }
    for i in 0..rungs - 1 {
        model.link(&format!("c{i}"), LINK);
        let rung = format!("r{i}");
        model.hinge(&rung, &format!("c{i}"), [length, 0.0, 0.0], -angle, "0 0 1", "");
        model.pin(&format!("k{i}"), &format!("c{i}"), [0.4, 0.0], &format!("r{}", i + 1), [length, 0.0]);
    }
    let mass = effective_mass("ladder", model.ask("ladder", "r150")).expect("finite");
    let arm = (0.5 - 0.03) / f64::sqrt(0.09 + 1.0 + 0.01);
    // The rungs rotate with 0.34 kg·m²; the couplers, 1 kg each, move on circles of 0.5 m.
    let expected = (301.0 * 0.34 + 300.0 * 0.25) / (arm * arm);
    assert!((mass / expected - 1.0).abs() < 1e-9, "{mass}, expected {expected}");
    // One loop of 300 links: 297 degrees of freedom.
    let (count, turn) = (300, std::f64::consts::TAU / 300.0);
    let (mut model, mut end, mut heading) = (Model::new(), [0.0, 0.0], 0.0_f64);
    for i in 0..count - 1 {
        let (parent, x) = if i == 0 { ("base".into(), 0.0) } else { (format!("l{}", i - 1), 1.0) };
        model.link(&format!("l{i}"), LINK);
        model.hinge(&parent, &format!("l{i}"), [x, 0.0, 0.0], turn, "0 0 1", "");
        heading += turn;
        end = [end[0] + heading.cos(), end[1] + heading.sin()];
    }
    model.pin("k", "base", end, &format!("l{}", count - 2), [1.0, 0.0]);
    let mass = effective_mass("ring", model.ask("ring", "l100")).expect("finite");
    assert!((0.5..10.0).contains(&mass), "{mass}");
}

/// Each loop is a group of its own: the data of one group must not store all positions, and its search must not touch
/// other groups.
#[test]
fn thousands_of_long_loops() {
    let (loops, links) = (1_500, 20);
    let turn = std::f64::consts::TAU / f64::from(links + 1);
    let mut model = Model::new();
    for k in 0..loops {
        let (mut x, mut y, mut heading) = (3.0 * f64::from(k), 0.0, 0.0_f64);
        let mut parent = "base".to_owned();
        for i in 0..links {
            let child = format!("l{k}_{i}");
            model.link(&child, LINK);
            let at = if i == 0 { [x, y, 0.0] } else { [1.0, 0.0, 0.0] };
            model.hinge(&parent, &child, at, if i == 0 { 0.0 } else { turn }, "0 0 1", "");
            heading += if i == 0 { 0.0 } else { turn };
            (x, y) = (x + heading.cos(), y + heading.sin());
            parent = child;
        }
        model.pin(&format!("loop{k}"), "base", [x, y], &parent, [1.0, 0.0]);
    }
    assert!(effective_mass("long loops", model.ask("long-loops", "l7_9")).expect("finite") > 0.1);
}
