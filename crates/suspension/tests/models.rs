//! Hardpoint files: one per template with invented round values, and two with the values of real cars.

use std::fmt::Write;

/// Builds a file from keys and values; `"Section/Key"` denotes a key in a section.
pub fn file(template: &str, keys: &[(&str, &str)]) -> String {
    let mut sections: Vec<(&str, Vec<(&str, &str)>)> = Vec::new();
    let mut out =
        format!("{{\n  \"Name\": \"test\",\n  \"Type\": \"Suspension\",\n  \"Template\": \"{template}\"");
    for (path, value) in keys {
        let Some((section, key)) = path.split_once('/') else {
            write!(out, ",\n  \"{path}\": {value}").unwrap();
            continue;
        };
        match sections.iter_mut().find(|s| s.0 == section) {
            Some(found) => found.1.push((key, value)),
            None => sections.push((section, vec![(key, value)])),
        }
    }
    for (section, keys) in sections {
        let body: Vec<String> = keys.iter().map(|(key, value)| format!("    \"{key}\": {value}")).collect();
        write!(out, ",\n  \"{section}\": {{\n{}\n  }}", body.join(",\n")).unwrap();
    }
    out + "\n}\n"
}

pub type Keys = Vec<(&'static str, &'static str)>;

/// Keys with some replaced or added; an empty value removes the key.
pub fn changed(keys: &[(&'static str, &'static str)], changes: &[(&'static str, &'static str)]) -> Keys {
    let mut keys = keys.to_vec();
    for (key, value) in changes {
        match keys.iter_mut().find(|k| k.0 == *key) {
            Some(found) => found.1 = value,
            None => keys.push((key, value)),
        }
    }
    keys.retain(|k| !k.1.is_empty());
    keys
}

const SPINDLE: [(&str, &str); 6] = [
    ("Spindle/Mass", "2.0"),
    ("Spindle/COM", "[0.0, 0.9, -0.02]"),
    ("Spindle/Inertia", "[0.02, 0.03, 0.025]"),
    ("Spindle/Radius", "0.1"),
    ("Spindle/Width", "0.05"),
    ("Axle/Inertia", "0.3"),
];
const UPRIGHT: [(&str, &str); 3] =
    [("Upright/Mass", "3.0"), ("Upright/COM", "[0.01, 0.8, 0.0]"), ("Upright/Inertia", "[0.05, 0.04, 0.03]")];
const TIE_ROD: [(&str, &str); 2] =
    [("Tierod/Location Chassis", "[-0.2, 0.4, 0.02]"), ("Tierod/Location Upright", "[-0.15, 0.8, -0.03]")];

fn struts(moving: &'static str) -> Keys {
    let (spring, shock) = match moving {
        "Upright" => ("Spring/Location Upright", "Shock/Location Upright"),
        "Link" => ("Spring/Location Link", "Shock/Location Link"),
        _ => ("Spring/Location Arm", "Shock/Location Arm"),
    };
    vec![
        ("Spring/Location Chassis", "[0.05, 0.55, 0.35]"),
        (spring, "[0.06, 0.62, -0.1]"),
        ("Spring/Spring Coefficient", "1e5"),
        ("Spring/Free Length", "0.4"),
        ("Shock/Location Chassis", "[0.03, 0.53, 0.4]"),
        (shock, "[0.05, 0.65, -0.1]"),
        ("Shock/Damping Coefficient", "1e4"),
    ]
}

fn joined(parts: &[&[(&'static str, &'static str)]]) -> Keys {
    parts.concat()
}

const POINTS_UPPER: [(&str, &str); 3] = [
    ("Upper Control Arm/Location Chassis Front", "[0.1, 0.45, 0.2]"),
    ("Upper Control Arm/Location Chassis Back", "[-0.2, 0.48, 0.17]"),
    ("Upper Control Arm/Location Upright", "[-0.03, 0.75, 0.22]"),
];
const POINTS_LOWER: [(&str, &str); 3] = [
    ("Lower Control Arm/Location Chassis Front", "[0.2, 0.35, -0.1]"),
    ("Lower Control Arm/Location Chassis Back", "[-0.25, 0.33, -0.08]"),
    ("Lower Control Arm/Location Upright", "[0.01, 0.82, -0.16]"),
];

pub fn double_wishbone() -> Keys {
    joined(&[
        &SPINDLE,
        &UPRIGHT[..2],
        &[
            ("Upright/Moments of Inertia", "[0.05, 0.04, 0.03]"),
            ("Upright/Products of Inertia", "[0.001, -0.002, 0.003]"),
            ("Upper Control Arm/Mass", "1.5"),
            ("Upper Control Arm/COM", "[-0.05, 0.6, 0.2]"),
            ("Upper Control Arm/Moments of Inertia", "[0.02, 0.03, 0.04]"),
            ("Upper Control Arm/Products of Inertia", "[0.001, 0.002, -0.001]"),
            ("Lower Control Arm/Mass", "4.5"),
            ("Lower Control Arm/COM", "[0.0, 0.6, -0.12]"),
            ("Lower Control Arm/Moments of Inertia", "[0.12, 0.13, 0.2]"),
            ("Lower Control Arm/Products of Inertia", "[0.01, -0.005, 0.002]"),
        ],
        &POINTS_UPPER,
        &POINTS_LOWER,
        &TIE_ROD,
        &struts("Arm"),
    ])
}

pub fn double_wishbone_reduced() -> Keys {
    let shock: Keys = struts("Upright").into_iter().filter(|k| k.0.starts_with("Shock")).collect();
    joined(&[&SPINDLE, &UPRIGHT, &POINTS_UPPER, &POINTS_LOWER, &TIE_ROD, &shock])
}

pub fn macpherson_strut() -> Keys {
    joined(&[
        &SPINDLE,
        &UPRIGHT,
        &[
            ("Control Arm/Mass", "4.5"),
            ("Control Arm/COM", "[0.0, 0.6, -0.12]"),
            ("Control Arm/Inertia", "[0.12, 0.13, 0.2]"),
            ("Control Arm/Location Chassis Front", "[0.2, 0.35, -0.1]"),
            ("Control Arm/Location Chassis Back", "[-0.25, 0.33, -0.08]"),
            ("Control Arm/Location Upright", "[0.01, 0.82, -0.16]"),
            ("Strut/Mass", "2.5"),
            ("Strut/Inertia", "[0.02, 0.021, 0.004]"),
            ("Strut/Radius", "0.02"),
        ],
        &TIE_ROD,
        &struts("Upright"),
    ])
}

pub fn semi_trailing_arm() -> Keys {
    joined(&[
        &SPINDLE,
        &[
            ("Trailing Arm/Mass", "5.0"),
            ("Trailing Arm/COM", "[0.25, 0.7, 0.0]"),
            ("Trailing Arm/Inertia", "[0.06, 0.05, 0.1]"),
            ("Trailing Arm/Location Chassis Outer", "[0.5, 0.85, 0.02]"),
            ("Trailing Arm/Location Chassis Inner", "[0.4, 0.5, -0.03]"),
            ("Trailing Arm/Location Spindle", "[0.0, 0.8, 0.0]"),
        ],
        &struts("Arm"),
    ])
}

pub fn three_link_irs() -> Keys {
    joined(&[
        &SPINDLE,
        &[
            ("Trailing Arm/Mass", "5.0"),
            ("Trailing Arm/COM", "[0.3, 0.8, 0.0]"),
            ("Trailing Arm/Inertia", "[0.06, 0.05, 0.1]"),
            ("Trailing Arm/Location Chassis", "[0.7, 0.8, 0.03]"),
            ("Trailing Arm/Location Spindle", "[0.0, 0.85, 0.0]"),
            ("Upper Link/Mass", "1.0"),
            ("Upper Link/COM", "[-0.05, 0.5, 0.2]"),
            ("Upper Link/Inertia", "[0.002, 0.02, 0.021]"),
            ("Upper Link/Location Chassis", "[-0.06, 0.25, 0.28]"),
            ("Upper Link/Location Arm", "[-0.05, 0.8, 0.12]"),
            ("Upper Link/Universal Joint Axis", "[2, 0.1, 0]"),
            ("Lower Link/Mass", "1.25"),
            ("Lower Link/COM", "[-0.04, 0.5, 0.0]"),
            ("Lower Link/Inertia", "[0.003, 0.03, 0.031]"),
            ("Lower Link/Location Chassis", "[-0.02, 0.2, 0.05]"),
            ("Lower Link/Location Arm", "[-0.05, 0.82, -0.1]"),
            ("Lower Link/Universal Joint Axis", "[1, 0, 0]"),
        ],
        &struts("Arm"),
    ])
}

pub fn multi_link() -> Keys {
    joined(&[
        &SPINDLE,
        &UPRIGHT,
        &[
            ("Upper Arm/Mass", "2.5"),
            ("Upper Arm/COM", "[-0.02, 0.6, 0.1]"),
            ("Upper Arm/Inertia", "[0.02, 0.03, 0.04]"),
            ("Upper Arm/Location Chassis Front", "[0.08, 0.5, 0.08]"),
            ("Upper Arm/Location Chassis Back", "[-0.15, 0.48, 0.07]"),
            ("Upper Arm/Location Upright", "[0.04, 0.82, 0.15]"),
            ("Lateral/Mass", "1.5"),
            ("Lateral/COM", "[0.03, 0.6, -0.1]"),
            ("Lateral/Inertia", "[0.04, 0.041, 0.001]"),
            ("Lateral/Location Chassis", "[0.03, 0.35, -0.12]"),
            ("Lateral/Location Upright", "[0.02, 0.8, -0.1]"),
            ("Lateral/Universal Joint Axis Link", "[1, 0, 0]"),
            ("Lateral/Universal Joint Axis Chassis", "[0, 0, 2]"),
            ("Trailing Link/Mass", "6.0"),
            ("Trailing Link/COM", "[0.3, 0.7, -0.12]"),
            ("Trailing Link/Inertia", "[0.03, 0.2, 0.21]"),
            ("Trailing Link/Location Chassis", "[0.7, 0.6, -0.07]"),
            ("Trailing Link/Location Upright", "[0.0, 0.83, -0.15]"),
            ("Trailing Link/Universal Joint Axis Link", "[0, 0, 1]"),
            ("Trailing Link/Universal Joint Axis Chassis", "[-0.3, 1, 0]"),
        ],
        &TIE_ROD,
        &struts("Link"),
    ])
}

/// All templates, each with its file.
pub fn all() -> [(&'static str, Keys); 6] {
    [
        ("DoubleWishbone", double_wishbone()),
        ("DoubleWishboneReduced", double_wishbone_reduced()),
        ("MacPhersonStrut", macpherson_strut()),
        ("SemiTrailingArm", semi_trailing_arm()),
        ("ThreeLinkIRS", three_link_irs()),
        ("MultiLink", multi_link()),
    ]
}

/// Keys of a tie rod with mass.
pub const HEAVY_TIE_ROD: [(&str, &str); 3] =
    [("Tierod/Mass", "0.75"), ("Tierod/Inertia", "[0.01, 0.011, 0.001]"), ("Tierod/Radius", "0.01")];

/// Values of Project Chrono's data/vehicle/hmmwv/suspension/HMMWV_DoubleWishboneFront.json (BSD-3-Clause).
pub fn hmmwv() -> Keys {
    vec![
        ("Spindle/Mass", "14.705"),
        ("Spindle/COM", "[-0.040, 0.910, -0.026]"),
        ("Spindle/Inertia", "[0.04117, 0.07352, 0.04117]"),
        ("Upright/Mass", "19.450"),
        ("Upright/COM", "[-0.040, 0.751, -0.026]"),
        ("Upright/Moments of Inertia", "[0.1656, 0.1934, 0.04367]"),
        ("Upright/Products of Inertia", "[0, 0, 0]"),
        ("Upper Control Arm/Mass", "5.813"),
        ("Upper Control Arm/COM", "[-0.106, 0.589, 0.218]"),
        ("Upper Control Arm/Moments of Inertia", "[0.03, 0.03, 0.06276]"),
        ("Upper Control Arm/Products of Inertia", "[0, 0, 0]"),
        ("Upper Control Arm/Location Chassis Front", "[-0.048, 0.446, 0.245]"),
        ("Upper Control Arm/Location Chassis Back", "[-0.268, 0.478, 0.196]"),
        ("Upper Control Arm/Location Upright", "[-0.053, 0.716, 0.215]"),
        ("Lower Control Arm/Mass", "23.965"),
        ("Lower Control Arm/COM", "[0.000, 0.547, -0.059]"),
        ("Lower Control Arm/Moments of Inertia", "[0.4, 0.4, 0.8938]"),
        ("Lower Control Arm/Products of Inertia", "[0, 0, 0]"),
        ("Lower Control Arm/Location Chassis Front", "[0.223, 0.307, 0.000]"),
        ("Lower Control Arm/Location Chassis Back", "[-0.223, 0.307, 0.000]"),
        ("Lower Control Arm/Location Upright", "[-0.036, 0.787, -0.118]"),
        ("Tierod/Location Chassis", "[-0.250, 0.448, 0.054]"),
        ("Tierod/Location Upright", "[-0.176, 0.821, -0.016]"),
        ("Spring/Location Chassis", "[0.104, 0.510, 0.197]"),
        ("Spring/Location Arm", "[0.097, 0.543, -0.047]"),
        ("Shock/Location Chassis", "[0.104, 0.498, 0.323]"),
        ("Shock/Location Arm", "[0.097, 0.543, -0.047]"),
        ("Axle/Inertia", "0.4"),
    ]
}

/// Values of Project Chrono's data/vehicle/sedan/suspension/Sedan_DoubleWishbone.json (BSD-3-Clause).
pub fn sedan() -> Keys {
    vec![
        ("Spindle/Mass", "1.103"),
        ("Spindle/COM", "[0, 0.7979, -0.1199]"),
        ("Spindle/Inertia", "[0.000478, 0.000496, 0.000478]"),
        ("Upright/Mass", "1.397"),
        ("Upright/COM", "[-0.0224, 0.7470, -0.1118]"),
        ("Upright/Moments of Inertia", "[0.0138, 0.0146, 0.00283]"),
        ("Upright/Products of Inertia", "[0, 0, 0]"),
        ("Upper Control Arm/Mass", "1.032"),
        ("Upper Control Arm/COM", "[-0.1083, 0.5972, 0.1063]"),
        ("Upper Control Arm/Moments of Inertia", "[0.00591, 0.00190, 0.00769]"),
        ("Upper Control Arm/Products of Inertia", "[0, 0, 0]"),
        ("Upper Control Arm/Location Chassis Front", "[-0.100, 0.4700, 0.1050]"),
        ("Upper Control Arm/Location Chassis Back", "[-0.250, 0.5100, 0.1100]"),
        ("Upper Control Arm/Location Upright", "[-0.040, 0.6950, 0.1050]"),
        ("Lower Control Arm/Mass", "1.611"),
        ("Lower Control Arm/COM", "[0.0048, 0.6112, -0.2932]"),
        ("Lower Control Arm/Moments of Inertia", "[0.0151, 0.0207, 0.0355]"),
        ("Lower Control Arm/Products of Inertia", "[0, 0, 0]"),
        ("Lower Control Arm/Location Chassis Front", "[0.2, 0.4200, -0.2700]"),
        ("Lower Control Arm/Location Chassis Back", "[-0.2, 0.4700, -0.2650]"),
        ("Lower Control Arm/Location Upright", "[0.0, 0.7700, -0.3200]"),
        ("Tierod/Location Chassis", "[-0.2, 0.4200, -0.1200]"),
        ("Tierod/Location Upright", "[-0.15, 0.7700, -0.1200]"),
        ("Spring/Location Chassis", "[-0.04, 0.5200, 0.2300]"),
        ("Spring/Location Arm", "[0.0, 0.6200, -0.2700]"),
        ("Shock/Location Chassis", "[-0.04, 0.5200, 0.2300]"),
        ("Shock/Location Arm", "[0.0, 0.6200, -0.2700]"),
        ("Axle/Inertia", "0.4"),
    ]
}
