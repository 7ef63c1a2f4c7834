//! Models of the repository: every command in a model's head gives the value stated in its comments, and every study
//! runs.

use crate::support;
use crate::support::{Scratch, Sweep, json, percuss, root};

/// Names of the files in `models` with this ending, sorted.
fn shipped(ending: &str) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(root().join("models"))
        .expect("models are shipped")
        .map(|entry| entry.expect("a readable entry").file_name().to_string_lossy().into_owned())
        .filter_map(|name| name.strip_suffix(ending).map(str::to_owned))
        .collect();
    names.sort();
    names
}

/// Texts of the processing instructions `<?percuss…?>` after a word.
fn instructions<'a>(text: &'a str, word: &str) -> Vec<&'a str> {
    text.split(word).skip(1).map(|rest| rest.split("?>").next().unwrap_or("")).collect()
}

#[test]
fn every_model_answers_with_its_figure() {
    let (mut commands, models) = (0, shipped(".urdf"));
    for model in &models {
        let text = std::fs::read_to_string(root().join(format!("models/{model}.urdf"))).expect("a text file");
        // A formula, or an independently computed value if no formula is available.
        assert!(["Closed form", "Reference:"].iter().any(|w| text.contains(w)), "{model} states no figure");
        let found = instructions(&text, "<?percuss ");
        assert!(!found.is_empty(), "{model} shows no command");
        // Codes of the accepted warnings of a model; other warnings fail the test.
        let allowed = instructions(&text, "<?percuss-allows ");
        for command in &found {
            assert!(
                command.contains(&format!("models/{model}.urdf")) && command.contains("--expect"),
                "{command}"
            );
            // 1e-12: rounding of a formula of a few operations, and the digits in the file. References state their
            // own tolerance.
            let tolerance = if command.contains("--tolerance") { "" } else { "--tolerance 1e-12" };
            let outcome = percuss(&format!("{command} {tolerance} --format json"));
            assert_eq!(outcome.code, 0, "{command}\n{}", outcome.stderr);
            let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("JSON");
            for finding in report["diagnostics"].as_array().expect("a list") {
                let code = finding["code"].as_str().unwrap_or("");
                assert!(finding["severity"] == "note" || allowed.contains(&code), "{command}: {finding}");
            }
        }
        commands += found.len();
    }
    assert!(models.len() >= 18 && commands >= 30, "{} models, {commands} commands", models.len());
}

#[test]
fn every_study_runs_and_all_its_rows_are_sound() {
    let studies = shipped(".toml");
    assert!(studies.len() >= 16, "only {studies:?}");
    for study in &studies {
        let text = std::fs::read_to_string(root().join(format!("models/{study}.toml"))).expect("a text file");
        let vary = text.lines().find_map(|l| l.strip_prefix("vary = \"")).expect("a sweep");
        let count: usize = vary.trim_end_matches('"').rsplit(':').next().unwrap().parse().expect("a count");
        let outcome = percuss(&format!("run models/{study}.toml"));
        assert_eq!(outcome.code, 0, "{study}: {}", outcome.stderr);
        let sweep = Sweep::read(&outcome.stdout);
        assert_eq!(sweep.rows.len(), count, "{study}");
        assert!(!outcome.stdout.contains("NaN") && !outcome.stdout.contains("inf"), "{study}");
        let dead_centres = if study == "slider_crank" { 2 } else { 0 };
        let immovable = (0..count).filter(|row| sweep.cell(*row, "status") == "immovable").count();
        assert_eq!(immovable, dead_centres, "{study}");
        for row in 0..count {
            match sweep.cell(row, "status") {
                "finite" => {
                    assert!(sweep.number(row, "effective_mass").is_some_and(|m| m > 0.0), "{study} {row}")
                }
                "immovable" => assert_eq!(sweep.cell(row, "effective_mass"), "", "{study} {row}"),
                other => panic!("{study}, row {row}: {other}"),
            }
            // The models are between 0.3 m and a few metres: 1e-12 of the size.
            assert!(sweep.number(row, "closure_residual").unwrap_or(0.0) <= 3e-13, "{study} {row}");
            assert_eq!(sweep.cell(row, "singular_pose"), "false", "{study} {row}");
        }
    }
}

/// Every study with a thousand steps: loops are closed to 1e-12 of the model's size in all rows.
#[test]
fn every_study_keeps_its_loops_closed_over_a_thousand_steps() {
    let scratch = Scratch::new("models-thousand");
    let mut looped = 0;
    for study in shipped(".toml") {
        let text = std::fs::read_to_string(root().join(format!("models/{study}.toml"))).expect("a text file");
        let model = root().join(format!("models/{study}.urdf"));
        let length =
            json(&format!("run models/{study}.toml --format json"))["characteristic_length"].as_f64();
        let long: Vec<String> = text
            .lines()
            .map(|line| match line.split_once(" = ") {
                Some(("vary", range)) => {
                    let (range, _) = range.rsplit_once(':').expect("a count");
                    format!("vary = {range}:1001\"")
                }
                Some(("path", _)) => format!("path = {:?}", model.to_string_lossy()),
                _ => line.to_owned(),
            })
            .collect();
        let outcome = percuss(&format!("run {}", scratch.write("long.toml", &long.join("\n"))));
        assert_eq!(outcome.code, 0, "{study}: {}", outcome.stderr);
        let sweep = Sweep::read(&outcome.stdout);
        assert_eq!(sweep.rows.len(), 1001, "{study}");
        for row in 0..1001 {
            assert_ne!(sweep.cell(row, "status"), "", "{study} {row}");
            if let Some(residual) = sweep.number(row, "closure_residual") {
                looped += usize::from(row == 0);
                assert!(residual <= 1e-12 * length.expect("a length"), "{study} {row}: {residual:e}");
            }
        }
    }
    assert!(looped >= 10, "{looped} studies have loops");
}

/// A parallelogram's platform has 7.5 kg / cos². The estimate of figure 3 is exact for massless arms, but inexact for
/// the real corner.
#[test]
fn studies_follow_their_closed_forms() {
    let rows = |study: &str| Sweep::read(&percuss(&format!("run models/{study}.toml")).stdout);
    let platform = rows("parallelogram");
    for row in 0..platform.rows.len() {
        let cosine = platform.number(row, "first_hinge").unwrap().cos();
        let mass = platform.number(row, "effective_mass").unwrap();
        assert!((mass * cosine * cosine / 7.5 - 1.0).abs() < 1e-12, "row {row}: {mass}");
    }
    let figure_3 = rows("massless_arm_suspension");
    for row in 0..figure_3.rows.len() {
        let mass = figure_3.number(row, "effective_mass").unwrap();
        assert!((mass / 97.28 - 1.0).abs() < 1e-12, "row {row}: {mass}");
        assert!(figure_3.number(row, "estimate_error_percent").unwrap().abs() < 1e-10);
    }
    let corner = rows("double_wishbone");
    for row in 0..corner.rows.len() {
        let off = corner.number(row, "estimate_error_percent").unwrap();
        assert!((-25.0..-5.0).contains(&off), "row {row}: {off} %");
    }
    // Crossed four-bar: tan(ψ/2) = −k tan(θ/2) for crank and rocker, measured from the ground line;
    // k = (g + a)/(g − a).
    let crossed = rows("antiparallelogram");
    let (ground, k) = (0.3f64.atan2(0.72), (0.78 + 0.5) / (0.78 - 0.5));
    for row in 0..crossed.rows.len() {
        let angle = |joint: &str, at_zero: f64| crossed.number(row, joint).unwrap() + at_zero - ground;
        let theta = angle("crank_hinge", 0.3f64.atan2(0.4));
        let psi = angle("rocker_hinge", (-0.3f64).atan2(0.4));
        assert!(
            ((psi / 2.0).tan() + k * (theta / 2.0).tan()).abs() < 1e-10 * (1.0 + (psi / 2.0).tan().powi(2))
        );
    }
}

/// The reference of the double wishbone has no wheel; see the values in docs/reference/SUSPENSIONS.md.
#[test]
fn the_double_wishbone_without_its_wheel_is_the_reference() {
    let text = std::fs::read_to_string(root().join("models/double_wishbone.urdf")).expect("a text file");
    let start = text.find("<link name=\"wheel\">").expect("a wheel");
    let end = start + text[start..].find("</link>").expect("it ends") + "</link>".len();
    let bare = format!("{}<link name=\"wheel\"/>{}", &text[..start], &text[end..]);
    // The axle's 0.4 kg·m² about the spin axis is part of the wheel; in the reference it is part of the spindle.
    assert!(bare.contains("iyy=\"0.07352\""));
    let bare = bare.replace("iyy=\"0.07352\"", "iyy=\"0.47352\"");
    let spring =
        "mass - --link spring_seat --point 0,0,0 --along-line spring_chassis_seat:0,0,0 --against chassis";
    for (more, mass, digits) in [("", 207.34216375745, 1e-11), ("--lock spin", 208.15253268130, 1e-11)] {
        let line = format!("{spring} {more} --expect {mass} --tolerance {digits}");
        let outcome = support::percuss_with_stdin(&line, bare.as_bytes());
        assert_eq!(outcome.code, 0, "{more}: {}", outcome.stderr);
    }
    // Estimate with the vertical speed of the spindle, the reference of all motion ratios of a suspension.
    for point in ["", ":0,0,0:0,0,1"] {
        let (ratio, kilograms) = (2.21478924, 167.5402);
        let line = format!("{spring} --estimate spindle,upright{point} --format json");
        let outcome = support::percuss_with_stdin(&line, bare.as_bytes());
        let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("JSON");
        let close =
            |key: &str, figure: f64| (report["estimate"][key].as_f64().unwrap() / figure - 1.0).abs() < 1e-6;
        assert!(close("motion_ratio", 1.0 / ratio) && close("estimate", kilograms), "{}", report["estimate"]);
    }
}

#[test]
fn a_wrong_expectation_is_noticed() {
    let pendulum = "mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0";
    let off = percuss(&format!("{pendulum} --expect 0.78126"));
    assert_eq!(off.code, 1);
    assert!(off.stderr.contains("differs from the expected 0.78126 kg"), "{}", off.stderr);
    let immovable =
        percuss("mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 0,0,1 --expect 1");
    assert_eq!(immovable.code, 1);
    assert!(immovable.stderr.contains("the contact is immovable"), "{}", immovable.stderr);
}
