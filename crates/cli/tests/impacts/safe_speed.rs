//! `percuss safe-speed`: the transient contact in closed form, and refusals.

use crate::support::{Scratch, json, percuss, root};

const ARM: &str =
    "safe-speed models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 1,0,0 --set elbow=70deg";

#[test]
fn the_effective_mass_stands_beside_the_standards() {
    let report = json(&format!("{ARM} --region chest --force 280 --load 2 --format json"));
    // The load is a point mass at the contact; as a link of the model, it gives the same result.
    let scratch = Scratch::new("safe-speed-load");
    let text = std::fs::read_to_string(root().join("models/six_r_arm.urdf")).expect("the model");
    let load = "<link name=\"held\"><inertial><origin xyz=\"0.08 0 0\"/><mass value=\"2\"/>\
                <inertia ixx=\"0\" iyy=\"0\" izz=\"0\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\
                <joint name=\"held_fixed\" type=\"fixed\"><parent link=\"tool\"/><child link=\"held\"/></joint></robot>";
    let with_load = scratch.write("loaded.urdf", &text.replace("</robot>", load));
    let contact = ARM.replace("safe-speed models/six_r_arm.urdf", &format!("mass {with_load}"));
    let m = json(&format!("{contact} --format json"))["effective_mass"].as_f64().expect("a mass");
    // Chest: 40 kg on 25 N/mm.
    let speed = |robot: f64| 280.0 / (25e3 / (1.0 / 40.0 + 1.0 / robot)).sqrt();
    let close = |value: &serde_json::Value, expected: f64| {
        let got = value.as_f64().expect("a number");
        assert!((got / expected - 1.0).abs() < 1e-12, "{got} {expected}");
    };
    close(&report["reflected"]["robot_mass"], m);
    close(&report["reflected"]["speed"], speed(m));
    let bare = ARM.replace("safe-speed", "mass");
    let bare = json(&format!("{bare} --format json"))["effective_mass"].as_f64().expect("a mass");
    assert!(m > bare + 2.0, "more than by the load alone: it moves across too ({m}, {bare})");
    let standard = 0.5 * report["moving_mass"].as_f64().expect("a mass") + 2.0;
    close(&report["standard"]["robot_mass"], standard);
    close(&report["standard"]["speed"], speed(standard));
    close(&report["energy"], 280.0 * 280.0 / (2.0 * 25e3));
    // 140 N/cm² on 2 cm² are 280 N.
    let pressed = json(&format!("{ARM} --region chest --pressure 140 --area 2 --load 2 --format json"));
    close(&pressed["reflected"]["speed"], speed(m));
    let text = percuss(&format!("{ARM} --region chest --force 280")).stdout;
    assert!(text.contains("not a certification") && text.contains("M/2 + m_L"), "{text}");
}

#[test]
fn a_direction_without_give_leaves_the_persons_mass() {
    // The arm is stretched out, and the contact normal is along the arm.
    let stretched = "safe-speed models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 1,0,0 --region chest --force 280";
    let report = json(&format!("{stretched} --format json"));
    assert!(report["reflected"]["robot_mass"].is_null());
    let speed = report["reflected"]["speed"].as_f64().expect("a speed");
    assert!((speed / (280.0 / (40.0f64 * 25e3).sqrt()) - 1.0).abs() < 1e-14, "{speed}");
    let codes: Vec<_> =
        report["diagnostics"].as_array().expect("a list").iter().map(|d| d["code"].clone()).collect();
    for code in ["immovable-robot", "standard-too-fast"] {
        assert!(codes.contains(&code.into()), "{codes:?}");
    }
    for other in ["--against-mass 5", "--against base"] {
        let outcome = percuss(&format!("{stretched} {other}"));
        assert!(
            outcome.code == 2 && outcome.stderr.contains("the other side is the person"),
            "{}",
            outcome.stderr
        );
    }
}

/// The bound for the surface of a link covers the largest m̄ of its map at every pose in the ranges, and is not far above; a link that can be
/// pushed towards its axis has the speed of an immovable robot.
#[test]
fn proved_speeds_cover_the_surface_of_a_link() {
    let scratch = Scratch::new("safe-speed-surface");
    let text = std::fs::read_to_string(root().join("models/shaped_arm.urdf")).expect("the model");
    let drawn = "<geometry><mesh filename=\"meshes/finger.obj\"/></geometry>";
    let with = |name: &str, solid: &str| {
        let turned = "<origin xyz=\"0.05 0.01 0\" rpy=\"0.3 1.2 -0.4\"/>";
        scratch.write(name, &text.replace(drawn, &format!("{turned}<geometry><{solid}/></geometry>")))
    };
    let shipped = || "models/shaped_arm.urdf".to_owned();
    for (model, link, parts, is_bounded) in [
        (shipped(), "forearm", 6, true),
        (shipped(), "finger", 36, true),
        (shipped(), "upper_arm", 3, false),
        (shipped(), "turret", 1, false),
        (with("sphere.urdf", "sphere radius=\"0.02\""), "finger", 1, true),
        (with("cylinder.urdf", "cylinder radius=\"0.03\" length=\"0.01\""), "finger", 3, true),
        (with("capsule.urdf", "capsule radius=\"0.02\" length=\"0.08\""), "finger", 3, true),
        (with("box.urdf", "box size=\"0.1 0.04 0.03\""), "finger", 6, true),
    ] {
        let report = json(&format!(
            "safe-speed {model} --link {link} --point 0,0,0.01 --normal 0,0,1 --range shoulder=-10deg:10deg --range elbow=50deg:70deg \
             --certify 2% --surface --region chest --force 280 --format json"
        ));
        let proved = &report["proved"];
        assert_eq!(proved["surface"]["patches"], parts, "{link} of {model}");
        let Some(upper) = proved["speed"]["robot_mass"].as_f64() else {
            assert!(!is_bounded && proved["speed"]["speed"].as_f64() > Some(0.0), "{link} of {model}");
            continue;
        };
        assert!(is_bounded && proved["is_sharp"] == true, "{link} of {model}: {upper}");
        let mut largest = 0.0_f64;
        for (shoulder, elbow) in [(-10, 50), (-10, 70), (10, 50), (10, 70), (3, 61)] {
            let map = json(&format!(
                "map {model} --link {link} --set shoulder={shoulder}deg --set elbow={elbow}deg --edge 5mm --format json"
            ));
            largest = largest.max(map["links"][0]["largest"]["effective_mass"].as_f64().expect("a mass"));
        }
        // 2 % of the proof, and the distance of the facets of the map from its largest value.
        assert!(largest <= upper && upper < 1.12 * largest, "{link} of {model}: {largest} {upper}");
    }
}
