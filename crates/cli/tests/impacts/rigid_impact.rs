//! `percuss impact`: closed forms, indeterminate components, refusals, and the study table.

use crate::support::{Scratch, json, percuss, root};
use serde_json::Value;

const FOUR_BAR: &str =
    "impact models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --restitution 0.3";

/// Rounding of a few operations.
const ROUNDING: f64 = 1e-12;

fn close(value: &Value, expected: f64) {
    let got = value.as_f64().unwrap_or_else(|| panic!("{value} is no number; expected {expected}"));
    assert!((got - expected).abs() < ROUNDING * expected.abs().max(1.0), "{got} {expected}");
}

fn named<'a>(list: &'a Value, key: &str, name: &str) -> &'a Value {
    let entries = list.as_array().expect("a list");
    entries.iter().find(|entry| entry[key] == name).unwrap_or_else(|| panic!("{name} is missing in {list}"))
}

#[test]
fn a_four_bar_has_the_rates_of_its_fractions() {
    let report = json(&format!("{FOUR_BAR} --rates crank_hinge=-24 --reflected crank_hinge --format json"));
    // Per unit rate of the crank the contact moves by −1/12 m, the coupler by −5/21, the rocker by 8/21 rad.
    let mass = 417_304.0 / 6125.0;
    close(&report["closing_speed"], 2.0);
    close(&report["impulse"], 1.3 * mass * 2.0);
    close(&report["energy_loss"], 0.5 * mass * (1.0 - 0.09) * 4.0);
    close(&report["mass"]["effective_mass"], mass);
    assert_eq!(report["motion_before"], "given");
    let rocker = named(&report["rates"], "joint", "rocker_hinge");
    close(&rocker["before"][0], -24.0 * 8.0 / 21.0);
    close(&rocker["after"][0], 0.3 * 24.0 * 8.0 / 21.0);
    close(&named(&report["reflected_inertia"], "joint", "crank_hinge")["free"], 52163.0 / 110_250.0);
    // A loop of parallel hinges is redundant out of its plane, and only there.
    let hinge = named(&report["reactions"], "name", "crank_hinge");
    assert!(hinge["force"][2].is_null() && hinge["moment"][0].is_null() && hinge["moment"][1].is_null());
    assert!(hinge["force"][0].is_number() && hinge["moment"][2].is_number());
    assert_eq!(hinge["open_by"], serde_json::json!(["rocker_pin"]));
    assert!(report["reaction_residual"].as_f64().expect("a number") < ROUNDING);
    // The ground balances the impulse and the change of momentum, also out of the plane.
    let ground = named(&report["reactions"], "place", "ground");
    assert!(ground["force"].as_array().expect("three").iter().all(Value::is_number));
    // The same impulse from a speed alone, whose motion is stated.
    let assumed = json(&format!("{FOUR_BAR} --speed 2 --format json"));
    close(&assumed["impulse"], 1.3 * mass * 2.0);
    assert_eq!(assumed["motion_before"], "least-energy");
    let text = percuss(&format!("{FOUR_BAR} --speed 2")).stdout;
    assert!(
        text.contains("assumed: the motion of least energy") && text.contains("?: indeterminate"),
        "{text}"
    );
}

#[test]
fn peak_forces_are_reactions_times_the_peak_of_the_contact() {
    let report = json(&format!("{FOUR_BAR} --speed 2 --stiffness 200N/mm --format json"));
    let factor = report["contact_law"]["peak_force"].as_f64().expect("a force")
        / report["impulse"].as_f64().expect("an impulse");
    let hinge = named(&report["reactions"], "name", "rocker_hinge");
    for k in 0..2 {
        close(&hinge["peak_force"][k], factor * hinge["force"][k].as_f64().expect("determinate"));
    }
    assert!(hinge["peak_force"][2].is_null());
    // The contact itself by percuss damp.
    let damp = "damp --mass-from models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --restitution 0.3 \
                --speed 2 --stiffness 200N/mm --format json";
    close(&report["contact_law"]["peak_force"], json(damp)["peak_force"].as_f64().expect("a force"));
}

#[test]
fn a_free_body_on_the_other_side_and_a_floating_base() {
    // Two free masses: 1/m̄ = 1/m₁ + 1/m₂.
    let scratch = Scratch::new("impact-free");
    let body = r#"<robot name="b"><link name="body"><inertial><mass value="3"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>"#;
    let model = scratch.write("body.urdf", body);
    let contact = format!("impact {model} --link body --point 0,0,0 --normal 0,0,-1 --base floating");
    let report = json(&format!(
        "{contact} --restitution 0.5 --speed 4 --base-twist 0,0,0,0,0,-3 --against-mass 6 --format json"
    ));
    let impulse = 1.5 * 2.0 * 4.0;
    close(&report["impulse"], impulse);
    close(&report["base"]["linear_after"][2], -3.0 + impulse / 3.0);
    close(&report["other_body"]["speed_change"], impulse / 6.0);
    close(&report["sticking_mass"], 2.0);
    // Without the other body, the given motion gives the closing speed.
    let falling = json(&format!("{contact} --restitution 0 --base-twist 0,0,0,0,0,-3 --format json"));
    close(&falling["closing_speed"], 3.0);
    close(&falling["base"]["linear_after"][2], 0.0);
    assert!(!falling["diagnostics"].to_string().contains("base-at-rest"), "{falling}");
    // Rates of joints without a velocity of the base: a note. Two bars of 2 kg in line, hinged at their ends; the second
    // turns about the hinge.
    let bar = |name: &str| {
        format!(
            r#"<link name="{name}"><inertial><origin xyz="0 0 -0.3"/><mass value="2"/>
            <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.05" iyz="0" izz="0.1"/></inertial></link>"#
        )
    };
    let text = format!(
        r#"<robot name="bars">{}{}<joint name="elbow" type="continuous"><parent link="body"/><child link="tip"/>
        <origin xyz="0 0 -0.5"/><axis xyz="0 1 0"/></joint></robot>"#,
        bar("body"),
        bar("tip")
    );
    let bars = scratch.write("bars.urdf", &text);
    let elbow = format!(
        "impact {bars} --link tip --point 0,0,-0.5 --normal 1,0,0 --restitution 0 --rates elbow=-1 --format json"
    );
    let base = "--base floating";
    let codes = |flags: &str| json(&format!("{elbow} {flags}"))["diagnostics"].to_string();
    let floating = codes(base);
    assert!(
        floating.contains("base-at-rest") && floating.contains("(--base-twist)") && floating.contains("note"),
        "{floating}"
    );
    for other in ["--base floating --base-twist 0,0,0,0,0,0", ""] {
        assert!(!codes(other).contains("base-at-rest"), "{other}");
    }
}

#[test]
fn friction_at_the_stop_of_a_linkage() {
    // e_kinematic = e √((1−µt)/(1+µt)); t is the sliding of the point at unit closing speed.
    let report = json(&format!("{FOUR_BAR} --speed 2 --friction 0.2 --format json"));
    let number = |key: &str| report["friction"][key].as_f64().expect("a number");
    // At (0.35, 0.1) of the coupler, per unit rate of the crank: v = (−0.3 + 0.1·5/21, −0.35·5/21).
    let slope = (0.3 - 0.5 / 21.0) * 12.0;
    assert!((number("slope") / slope - 1.0).abs() < ROUNDING);
    let product = 0.2 * slope;
    let reached = 0.3 * ((1.0 - product) / (1.0 + product)).sqrt();
    assert!((number("kinematic_restitution") - reached).abs() < ROUNDING, "{report}");
    let mass = 417_304.0 / 6125.0;
    close(&report["impulse"], mass * 2.0 * (1.0 / (1.0 + product) + 0.3 / (1.0 - product * product).sqrt()));
    close(&named(&report["rates"], "joint", "crank_hinge")["after"][0], reached * 24.0);
    // Beyond µt = 1 the contact wedges.
    let wedged = json(&format!("{FOUR_BAR} --speed 2 --friction 0.4 --format json"));
    assert_eq!(wedged["friction"]["wedged"], true);
    close(&named(&wedged["rates"], "joint", "crank_hinge")["after"][0], 0.0);
    assert!(
        percuss(&format!("{FOUR_BAR} --speed 2 --friction 0.4")).stdout.contains("wedged, without rebound")
    );
    for (command, words) in [
        (format!("{FOUR_BAR} --speed 2 --friction -1"), "--friction: the coefficient"),
        (
            "impact models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=1 --restitution 0 --speed 1 \
             --friction 0.3"
                .to_owned(),
            "several directions",
        ),
    ] {
        let outcome = percuss(&command);
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{command}: {}", outcome.stderr);
    }
}

#[test]
fn invalid_motions_are_refused() {
    let pendulum =
        "impact models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg";
    for (command, code, words) in [
        (format!("{FOUR_BAR} --rates crank_hinge=-2 --rates rocker_hinge=1"), 2, "--rates: joint"),
        (format!("{FOUR_BAR} --rates crank_hinge=-2 --rates rocker_hinge=1"), 2, "residual"),
        (format!("{FOUR_BAR} --rates crank_hinge=2"), 2, "open the gap"),
        (format!("{FOUR_BAR} --rates crank=2"), 2, "no joint"),
        (format!("{FOUR_BAR} --rates crank_hinge=2m/s"), 2, "crank_hinge"),
        (format!("{FOUR_BAR} --rates crank_hinge=-24 --speed 3"), 2, "leave one of the two out"),
        (FOUR_BAR.to_owned(), 2, "--speed: no motion"),
        (format!("{FOUR_BAR} --speed -1"), 2, "--speed: the closing speed"),
        (format!("{FOUR_BAR} --speed 1 --base-twist 0,0,0,0,0,1"), 2, "the base is fixed"),
        (format!("{FOUR_BAR} --speed 1 --reflected nope"), 2, "--reflected"),
        (format!("{FOUR_BAR} --speed 1 --rate-limit crank_hinge=-2"), 2, "--rate-limit"),
        (format!("{pendulum} --restitution 0 --rates elbow=1"), 2, "shoulder"),
        (format!("{pendulum} --restitution 2 --speed 1"), 2, "--restitution"),
        (FOUR_BAR.replace("0,1,0 ", "0,0,1 ") + " --speed 1", 1, "immovable"),
    ] {
        let outcome = percuss(&command);
        assert_eq!(outcome.code, code, "{command}\n{}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{command}: {words} is missing in\n{}", outcome.stderr);
    }
}

#[test]
fn a_study_keeps_the_flags() {
    let scratch = Scratch::new("impact-study");
    let model = root().join("models/four_bar.urdf");
    let study = scratch.write(
        "impact.toml",
        &format!(
            "[model]\npath = '{}'\n[contact]\nlink = \"coupler\"\npoint = [0.35, 0.1, 0]\nnormal = [0, 1, 0]\n[impact]\n\
             restitution = 0.3\nrates = {{ crank_hinge = \"-120deg/s\" }}\nreflected = \"crank_hinge\"\n",
            model.display()
        ),
    );
    let ran = percuss(&format!("run {study}")).stdout;
    let printed =
        percuss(&format!("{FOUR_BAR} --rates crank_hinge=-120deg/s --reflected crank_hinge")).stdout;
    assert!(ran.ends_with(&printed), "{ran}\n{printed}");
    let page = scratch.path("report.html");
    let outcome = percuss(&format!("run {study} --report {page}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = std::fs::read_to_string(page).expect("the report");
    assert!(page.contains("Reactions") && page.contains("rocker_pin"), "no reactions in the report");
}
