//! Summary of an import, as text.

use crate::terminal::escape::line;
use crate::terminal::wrap;
use percuss_suspension::{LengthUnit, Side, Understood};
use std::fmt::Write;

/// Summary as one table: contents of the file, lengths, masses.
pub fn import_summary(of: &Understood, output: &str) -> String {
    let mut out = String::new();
    let mut fact = |name: &str, value: String| {
        out += &wrap::fact_line(name, &line(&value));
    };
    let side = match of.side {
        Side::Left if of.track.is_none() && !of.wheels.is_empty() => "a wheel in the middle plane",
        Side::Left => "the left side",
        Side::Right => "the right side",
        Side::Both => "both sides",
    };
    fact("suspension", format!("{}, template {}", of.name, of.template));
    fact("built", format!("{side}, written to {output}"));
    fact("read in", format!("{}, axes {}: {}", of.unit.name(), of.axes.name(), of.axes.words()));
    if let Some(track) = of.track {
        fact("track", with_unit(of.unit, track));
    }
    for wheel in &of.wheels {
        let at: [f64; 3] = of.axes.from_iso(wheel.centre.into()).into();
        let [x, y, z] = at.map(|x| length_text(of.unit, x, 0));
        fact("wheel centre", format!("({x}, {y}, {z}) {}, axes {}", of.unit.name(), of.axes.name()));
    }
    if let Some(Some(radius)) = of.wheel.map(|wheel| wheel.radius) {
        fact("wheel radius", with_unit(of.unit, radius));
    }
    out.push('\n');
    // Length and mass of a link are in one row.
    let _ = writeln!(out, "{:<28} {:>12} {:>10}", "link", format!("length, {}", of.unit.name()), "mass, kg");
    for (name, mass) in &of.masses {
        let name = line(name);
        let plain = name.trim_end_matches("_left").trim_end_matches("_right");
        let length = of.lengths.iter().find(|(known, _)| known == plain);
        let length = length.map_or_else(|| "–".to_owned(), |(_, length)| length_text(of.unit, *length, 1));
        let _ = writeln!(out, "{name:<28} {length:>12} {mass:>10.3}");
    }
    let is_massless = |name: &str| {
        !of.masses.iter().any(|(known, _)| known == name || known.strip_suffix("_left") == Some(name))
    };
    for (name, length) in of.lengths.iter().filter(|(name, _)| is_massless(name)) {
        let name = line(name);
        let length = length_text(of.unit, *length, 1);
        let _ = writeln!(out, "{name:<28} {length:>12} {:>10}", "massless");
    }
    let _ = writeln!(out, "{:<28} {:>12} {:>10.3}", "all", "", of.total_mass);
    out.push_str("\nLengths: of an arm from its hinge axis to its outer point, of a rod from end to\nend.\n");
    out
}

/// Length (m) in a unit, to a tenth of a millimetre; `digits`: further decimals.
fn length_text(unit: LengthUnit, metres: f64, digits: usize) -> String {
    let decimals = digits
        + match unit {
            LengthUnit::Millimetre => 1,
            LengthUnit::Centimetre => 2,
            LengthUnit::Metre => 4,
            LengthUnit::Inch => 3,
        };
    format!("{:.decimals$}", unit.of_metres(metres) + 0.0)
}

/// Length (m) with its unit.
fn with_unit(unit: LengthUnit, metres: f64) -> String {
    format!("{} {}", length_text(unit, metres, 0), unit.name())
}
