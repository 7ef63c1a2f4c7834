//! Inertias that are impossible for the size of the link are found; inertias of real models are accepted.

use crate::support::{load_text, told};
use percuss_formats::{LoadOptions, Source, load};
use percuss_mechanism::{Accept, Severity};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::path::Path;

const CODE: &str = "implausible-inertia";

/// Arm of length 0.5 m with a tip link; mass and inertia are about the midpoint.
fn arm(mass: f64, moments: [f64; 3]) -> String {
    let [xx, yy, zz] = moments;
    format!(
        "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"><inertial><origin xyz=\"0.25 0 0\"/><mass value=\"{mass:e}\"/>\n\
         <inertia ixx=\"{xx:e}\" iyy=\"{yy:e}\" izz=\"{zz:e}\"/></inertial></link><link name=\"tip\"/>\
         <joint name=\"hinge\" type=\"continuous\"><parent link=\"base\"/><child link=\"arm\"/><axis xyz=\"0 0 1\"/></joint>\
         <joint name=\"fixed\" type=\"fixed\"><origin xyz=\"0.5 0 0\"/><parent link=\"arm\"/><child link=\"tip\"/></joint></robot>"
    )
}

/// Severity of the finding about the arm.
fn found(mass: f64, moments: [f64; 3]) -> Option<Severity> {
    let loaded = load_text(&arm(mass, moments));
    told(&loaded).iter().find(|d| d.code == CODE).map(|d| d.severity)
}

/// Box of random size and density: mass and moments.
fn solid(rng: &mut StdRng) -> (f64, [f64; 3]) {
    let [a, b, c] = [0.5, rng.random_range(0.02..0.2), rng.random_range(0.02..0.2)];
    let mass = a * b * c * rng.random_range(300.0..8000.0);
    let moment = |p: f64, q: f64| mass / 12.0 * (p * p + q * q);
    (mass, [moment(b, c), moment(a, c), moment(a, b)])
}

#[test]
fn wrong_units_are_found_and_right_ones_are_not() {
    let rng = &mut StdRng::seed_from_u64(4);
    let (mut dense, arms) = (0, 500);
    for _ in 0..arms {
        let (mass, moments) = solid(rng);
        assert_eq!(found(mass, moments), None, "{mass} {moments:?}");
        // kg·mm² read as kg·m².
        assert_eq!(found(mass, moments.map(|x| x * 1e6)), Some(Severity::Error), "{mass} {moments:?}");
        // Mass in grams with an inertia in kg·m², then mass in grams with an inertia in g·m².
        assert_eq!(found(mass * 1e3, moments), Some(Severity::Warning), "{mass} {moments:?}");
        dense += usize::from(found(mass * 1e3, moments.map(|x| x * 1e3)).is_some());
        // Inertia without mass.
        assert_eq!(found(0.0, moments), Some(Severity::Warning), "{moments:?}");
        // Point mass.
        assert_eq!(found(mass, [0.0; 3]), None);
    }
    // By the radius of gyration, a slender wooden arm in grams has the density of a compact metal arm.
    println!("{dense} of {arms} arms in grams and g·m² are found");
    assert!(dense > arms / 2, "{dense}");
}

#[test]
fn the_message_names_the_element_the_numbers_and_the_remedy() {
    let text = arm(2.0, [1.0, 41_667.0, 41_667.0]);
    let error = load_text(&text).expect_err("far out");
    let [found] = &error.diagnostics.iter().filter(|d| d.code == CODE).collect::<Vec<_>>()[..] else {
        panic!("{error}")
    };
    assert_eq!(found.line, Some(2));
    for part in ["2.0000e0 kg", "1.4434e2 m", "kg·mm²", "--accept implausible-inertia"] {
        assert!(found.message.contains(part), "{}", found.message);
    }
    let options = LoadOptions {
        accept: Accept { implausible_inertia: true, ..Accept::default() },
        ..LoadOptions::default()
    };
    let accepted = load(&Source::from_text("arm.urdf", text), &options).expect("accepted");
    assert!(accepted.diagnostics.iter().any(|d| d.code == CODE && d.severity == Severity::Warning));
}

/// The rotor of a gear may have an inertia without a mass.
#[test]
fn rotors_of_couplings_need_no_mass() {
    let text = arm(2.0, [0.01, 0.05, 0.05]).replace(
        "</robot>",
        "<link name=\"rotor\"><inertial><mass value=\"0\"/><inertia ixx=\"1e-4\" iyy=\"1e-4\" izz=\"1e-4\"/></inertial></link>\
         <joint name=\"spin\" type=\"continuous\"><parent link=\"base\"/><child link=\"rotor\"/><axis xyz=\"0 0 1\"/></joint>\
         <coupling name=\"gear\"><predecessor link=\"arm\"/><successor link=\"rotor\"/><ratio value=\"6\"/></coupling></robot>",
    );
    let coupled = load_text(&text);
    assert!(coupled.is_ok() && told(&coupled).iter().all(|d| d.code != CODE), "{:?}", told(&coupled));
    let (before, rest) = text.split_once("<coupling").unwrap();
    let (_, after) = rest.split_once("</coupling>").unwrap();
    let free = load_text(&format!("{before}{after}"));
    assert!(told(&free).iter().any(|d| d.code == CODE), "{:?}", told(&free));
}

#[test]
fn shipped_models_are_plausible() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("models").flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|ending| ending != "urdf") {
            continue;
        }
        let name = path.to_string_lossy().into_owned();
        let loaded =
            load(&Source::read(&name, percuss_formats::DEFAULT_MAX_SIZE).unwrap(), &LoadOptions::default());
        assert!(told(&loaded).iter().all(|d| d.code != CODE), "{name}: {:?}", told(&loaded));
        count += 1;
    }
    assert!(count > 15, "{count}");
}
