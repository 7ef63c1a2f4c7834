//! Grids, position files and random positions: every row equals the result of `percuss mass`.

use crate::support::{Scratch, Sweep, json, percuss, percuss_with_stdin};

const ARM: &str = "models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1 --normal-frame world";
const COUPLER: &str = "models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0";
const STOP: &str = "models/double_wishbone.urdf --link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --turning-normal \
                    --against chassis";

fn swept(line: &str) -> Sweep {
    let outcome = percuss(line);
    assert_eq!(outcome.code, 0, "{line}\n{}", outcome.stderr);
    Sweep::read(&outcome.stdout)
}

/// Compares m̄ of a row with `percuss mass` at the same joint positions.
fn assert_is_mass(sweep: &Sweep, row: usize, contact: &str, joints: &[&str]) {
    let set: Vec<String> =
        joints.iter().map(|joint| format!("--set {joint}={}", sweep.cell(row, joint))).collect();
    let report = json(&format!("mass {contact} {} --format json", set.join(" ")));
    let (got, wanted) =
        (sweep.number(row, "effective_mass").expect("finite"), report["effective_mass"].as_f64().unwrap());
    assert!((got / wanted - 1.0).abs() < 1e-10, "row {row}: {got} {wanted}");
    for (joint, values) in report["pose"].as_object().expect("a pose") {
        if let [value] = &values.as_array().expect("numbers")[..] {
            let (got, wanted) = (sweep.number(row, joint).expect("a position"), value.as_f64().unwrap());
            assert!(
                (got - wanted).abs() < 1e-9 * wanted.abs().max(1.0),
                "row {row}, {joint}: {got} {wanted}"
            );
        }
    }
}

#[test]
fn a_grid_has_every_combination_the_first_flag_the_slowest() {
    let joints = ["shoulder", "elbow"];
    let sweep = swept(&format!("sweep {ARM} --vary shoulder=-40deg:40deg:3 --vary elbow=10deg:70deg:4"));
    assert_eq!(sweep.header[..4], ["row", "shoulder", "elbow", "status"]);
    assert!(sweep.header[4..].iter().all(|name| !joints.contains(&name.as_str())), "{:?}", sweep.header);
    assert_eq!(sweep.rows.len(), 12);
    for row in 0..12 {
        let values = [-40.0 + 40.0 * (row / 4) as f64, 10.0 + 20.0 * (row % 4) as f64];
        for (joint, value) in joints.iter().zip(values) {
            assert!((sweep.number(row, joint).unwrap() - f64::to_radians(value)).abs() < 1e-12);
        }
        assert_is_mass(&sweep, row, ARM, &joints);
    }
}

/// Grid over a driver and a joint outside its loops, and over a travel.
#[test]
fn a_grid_of_a_linkage_is_answered_line_by_line() {
    let sweep = swept(&format!("sweep {STOP} --vary spin=0:40deg:3 --vary lower_arm_hinge=-0.2:0.2:5"));
    for row in [0, 4, 7, 14] {
        assert_is_mass(&sweep, row, STOP, &["spin", "lower_arm_hinge"]);
    }
    let travel = "travel:wheel_centre:0,0,0:0,0,1=-40mm:40mm:3";
    let sweep = swept(&format!("sweep {STOP} --vary spin=0:40deg:3 --vary {travel}"));
    for row in 0..9 {
        assert_is_mass(&sweep, row, STOP, &["spin", "lower_arm_hinge"]);
        // The wheel is rotationally symmetric: its spin has no effect.
        let same = sweep.number(row % 3, "effective_mass").unwrap();
        assert!((sweep.number(row, "effective_mass").unwrap() / same - 1.0).abs() < 1e-9, "row {row}");
    }
}

/// Grid lines longer than a block, and several lines per block, for different numbers of threads.
#[test]
fn no_answer_depends_on_the_number_of_threads() {
    for varied in [
        "--vary spin=0:1:2 --vary lower_arm_hinge=-0.6:0.3:300",
        "--vary spin=0:1:12 --vary lower_arm_hinge=-0.6:0.6:20",
        "--random 100 --seed 4 --set spin=0",
    ] {
        let [one, three] = [1, 3].map(|n| percuss(&format!("sweep {STOP} {varied} --threads {n}")));
        assert_eq!(one.code, 0, "{}", one.stderr);
        assert!(one.stdout == three.stdout, "{varied}");
        assert_eq!(one.stderr, three.stderr, "{varied}");
    }
}

/// An unreachable line of a grid does not affect the others.
#[test]
fn lines_do_not_depend_on_one_another() {
    let sweep = percuss(&format!("sweep {STOP} --vary lower_arm_hinge=1:0:3 --vary spin=0:1:3"));
    assert_eq!(sweep.code, 0, "{}", sweep.stderr);
    let sweep = Sweep::read(&sweep.stdout);
    let reached: Vec<bool> = (0..9).map(|row| sweep.cell(row, "status") == "finite").collect();
    assert_eq!(reached, [false, false, false, false, false, false, true, true, true]);
}

#[test]
fn random_positions_lie_within_limits_and_repeat() {
    let run = |seed: u64, count: usize| swept(&format!("sweep {ARM} --random {count} --seed {seed}"));
    let (sweep, again, other, more) = (run(7, 40), run(7, 40), run(8, 40), run(7, 60));
    assert_eq!(sweep.rows, again.rows);
    assert_ne!(sweep.rows, other.rows);
    // A row depends only on the seed and its number.
    assert_eq!(sweep.rows[..], more.rows[..40]);
    let joints: Vec<&str> = sweep.header[1..7].iter().map(String::as_str).collect();
    for row in 0..40 {
        if row % 8 == 0 {
            assert_is_mass(&sweep, row, ARM, &joints);
        }
    }
    let check = json("check models/six_r_arm.urdf --format json");
    for joint in check["joints"].as_array().expect("joints") {
        let (name, limits) = (joint["name"].as_str().unwrap(), &joint["limits"]);
        if let (true, Some(limits)) = (joints.contains(&name), limits.as_array()) {
            let [lower, upper] = [0, 1].map(|i| limits[i].as_f64().unwrap());
            let values: Vec<f64> = (0..60).map(|row| more.number(row, name).unwrap()).collect();
            assert!(values.iter().all(|v| (lower..=upper).contains(v)), "{name}");
            let spread = values.iter().fold(f64::MIN, |a, b| a.max(*b))
                - values.iter().fold(f64::MAX, |a, b| a.min(*b));
            assert!(spread > 0.7 * (upper - lower), "{name}: {spread}");
        }
    }
}

/// Scripts rely on the numbers of a seed: they are the same on every machine and in every version.
#[test]
fn the_numbers_of_a_seed_are_these() {
    let sweep = swept(
        "sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --random 2 --seed 1",
    );
    let angles = [0, 1].map(|row| sweep.cell(row, "crank_hinge"));
    // Computed with another implementation of ChaCha8, in Python.
    assert_eq!(angles, ["-0.7446239774865901", "-2.4910747580258272"]);
}

#[test]
fn random_positions_close_the_loops_and_set_joints_stay() {
    let sweep = swept(&format!("sweep {COUPLER} --random 20 --seed 3"));
    for row in [0, 7, 19] {
        assert_is_mass(&sweep, row, COUPLER, &["crank_hinge"]);
    }
    let sweep = swept(&format!("sweep {ARM} --random 5 --set elbow=70deg"));
    assert!((0..5).all(|row| sweep.number(row, "elbow") == Some(70f64.to_radians())));
    let slide = r#"<robot name="r"><link name="g"/><link name="a"><inertial><mass value="2"/>
        <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
        <joint name="p" type="KIND"><parent link="g"/><child link="a"/><axis xyz="0 0 1"/></joint></robot>"#;
    for (kind, words) in [
        ("floating", "--random: joint \"p\" is floating and has no limits to sample between; set it (--set)"),
        ("planar", "--random: joint \"p\" is planar and has no limits to sample between; set it (--set)"),
        ("fixed", "--random: no joint can be sampled"),
    ] {
        let line = "sweep - --link a --point 1,0,0 --normal 0,0,1 --random 3";
        let outcome = percuss_with_stdin(line, slide.replace("KIND", kind).as_bytes());
        assert_eq!(outcome.code, 2, "{}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{}", outcome.stderr);
    }
    // Ball joints take any orientation.
    let line = "sweep - --link a --point 1,0,0 --normal 0,0,1 --normal-frame world --random 50";
    let outcome = percuss_with_stdin(line, slide.replace("KIND", "spherical").as_bytes());
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let sweep = Sweep::read(&outcome.stdout);
    for row in 0..50 {
        let norm: f64 = (0..4).map(|i| sweep.number(row, &format!("p[{i}]")).unwrap().powi(2)).sum();
        assert!((norm - 1.0).abs() < 1e-14, "row {row}: {norm}");
    }
}

/// Gradients of a tree (in lanes) and of a linkage (at poses) against central differences of rows 2h apart.
#[test]
fn gradients_are_differences_of_rows() {
    // The third derivative of m̄ times h² and rounding over h are both below 1e-6 of m̄.
    const H: f64 = 1e-3;
    for (contact, driver, velocities) in [
        (ARM, "elbow", vec!["elbow"]),
        (COUPLER, "crank_hinge", vec!["crank_hinge", "crank_pin", "rocker_hinge"]),
    ] {
        let (low, high) = (0.2 - H, 0.2 + H);
        let sweep = swept(&format!("sweep {contact} --vary {driver}={low}:{high}:3 --gradient"));
        let value = |row: usize, name: &str| sweep.number(row, name).expect("a number");
        let slope = (value(2, "effective_mass") - value(0, "effective_mass")) / (2.0 * H);
        // Velocities of the joints per velocity of the driver.
        let rates = velocities.iter().map(|joint| (value(2, joint) - value(0, joint)) / (2.0 * H));
        let found: f64 = velocities
            .iter()
            .zip(rates)
            .map(|(joint, rate)| rate * value(1, &format!("gradient_{joint}")))
            .sum();
        let size = value(1, "effective_mass");
        assert!((found - slope).abs() < 1e-4 * size.max(slope.abs()), "{driver}: {found} {slope}");
    }
    let plain = swept(&format!("sweep {ARM} --vary elbow=0:1:2"));
    assert!(!plain.header.iter().any(|name| name.starts_with("gradient")), "{:?}", plain.header);
    let scratch = Scratch::new("gradients");
    let path = scratch.path("rows.json");
    let written = percuss(&format!("sweep {ARM} --vary elbow=0:1:2 --gradient -o {path}"));
    assert_eq!(written.code, 0, "{}", written.stderr);
    let report: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(&path).expect("a report")).expect("JSON");
    assert_eq!(report["rows"][0]["gradient"].as_object().expect("a gradient by joint").len(), 6);
}
