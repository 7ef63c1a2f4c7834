//! Reflected inertias as text, table and figure; command `percuss impact --reflected` without a contact.

use crate::args::ImpactArgs;
use crate::commands::mass::conditions::base_text;
use crate::document::{self, Document};
use crate::files::contents::{Cells, Contents};
use crate::files::csv::Cell;
use crate::files::output::record_input;
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::number::{number, rounded};
use crate::terminal::report::{with_findings, write_diagnostics};
use percuss_render::{Figure, Panel, Picture, Series, Sheet, Style};
use percuss_study::{
    Dimension, Input, MimicJointRecord, MimicSubstituteRecord, ReflectedRangeRecord, ReflectedRecord,
    ReflectedReport, Status, reflected_inertias,
};

/// Runs `percuss impact --reflected` without a contact.
pub fn run(args: &ImpactArgs) -> Result<(), Failure> {
    let conditions = args.contact.conditions()?;
    let model = args.model.load()?;
    let found = reflected_inertias(&model, &conditions, &args.impact.reflected);
    let report = with_findings(found, &model)?;
    write_diagnostics(&report.diagnostics, args.model.reading.strict)?;
    if let Some(path) = &args.output {
        write_ranges(&report.reflected_over, &report.inputs, path)?;
    }
    document::print(&report, args.format, || document(&report))
}

/// Reflected inertias without a contact.
fn document(report: &ReflectedReport) -> Document<'_> {
    let ReflectedReport { reflected_inertia, reflected_over, drivers, conditions, .. } = report;
    let mut facts = facts(reflected_inertia, reflected_over);
    facts.push(("base", base_text(conditions)));
    facts.push(("driving joints", drivers.join(", ")));
    if !conditions.lock.is_empty() {
        facts.push(("locked joints", conditions.lock.join(", ")));
    }
    let mut out = Document::default();
    out.facts(facts);
    out
}

/// Reflected inertias as text.
pub fn facts(records: &[ReflectedRecord], ranges: &[ReflectedRangeRecord]) -> Vec<(&'static str, String)> {
    let mut facts: Vec<_> = records.iter().map(|record| ("reflected", reflected(record))).collect();
    for range in ranges {
        facts.push(("armature", armature(range)));
        facts.extend(range.substitute.as_ref().map(|found| ("mimic joints", substitute(range, found))));
        facts.extend(range.substitute_refused_by.as_ref().map(|joint| {
            let why = format!("not possible: {joint} moves with {} and has several velocities", range.joint);
            ("mimic joints", why)
        }));
    }
    facts
}

/// Inertias reflected to a joint as text, with the unit: with all other joints free, and with the other drivers held.
fn reflected(record: &ReflectedRecord) -> String {
    let value = |status: Status, value: Option<f64>| match (status, value) {
        (Status::Finite, Some(value)) => format!("{} {}", number(value), record.unit),
        (status, _) => status.name().to_owned(),
    };
    let free = value(record.free_status, record.free);
    let held = record.held_status.map_or_else(
        || format!("no driving joint (driving joints: {})", record.other_drivers.join(", ")),
        |status| {
            let others = record.other_drivers.join(", ");
            let others = if others.is_empty() { "the other drivers".to_owned() } else { others };
            format!("{} with {others} held", value(status, record.held))
        },
    );
    let direction = record.direction.map_or_else(String::new, |direction| format!(" {direction}"));
    format!("{}{direction}: {free} free; {held}", record.joint)
}

/// Reflected inertia over a range as text.
fn armature(range: &ReflectedRangeRecord) -> String {
    let unit = range.unit;
    let (state, values) = match is_held(range) {
        true => ("with the other drivers held", &range.held),
        false => ("free", &range.free),
    };
    let (count, all) = (values.iter().flatten().count(), values.len());
    let (Some(least), Some(most)) = (range.least, range.most) else {
        return format!("{}: massless or immovable at all {all} positions", range.joint);
    };
    let (Some(constant), Some(error)) = (range.best_constant, range.largest_error) else {
        return format!(
            "{}: {} to {} {unit} {state} at {count} of {all} positions; massless or immovable at the others, so that no constant \
             armature replaces the linkage",
            range.joint,
            number(least),
            number(most),
        );
    };
    format!(
        "{}: {} to {} {unit} {state} over {} positions; the best constant is {} {unit}, wrong by up to {} %. It includes the inertia \
         of the links: in a simulator whose model contains the links, set only the missing part as armature",
        range.joint,
        number(least),
        number(most),
        range.positions.len(),
        number(constant),
        percent(error),
    )
}

/// Substitute with mimic joints as text.
fn substitute(range: &ReflectedRangeRecord, found: &MimicSubstituteRecord) -> String {
    let mimic = |joint: &MimicJointRecord| {
        let offset = rounded(joint.offset, 1.0);
        let (sign, size) = (if offset < 0.0 { '−' } else { '+' }, number(offset.abs()));
        format!("{} = {} q {sign} {size}", joint.joint, number(joint.multiplier))
    };
    let joints: Vec<String> = found.joints.iter().map(mimic).collect();
    format!(
        "for a simulator without loops, the tree with {}, q the position of {}, and an additional armature of {} {} at {}: the inertia is \
         wrong by up to {} %",
        joints.join(", "),
        range.joint,
        number(found.armature),
        range.unit,
        range.joint,
        percent(found.largest_error),
    )
}

/// Relative error in percent.
fn percent(error: f64) -> String {
    number(rounded(100.0 * error, 100.0))
}

/// True if the range contains the inertia with the other drivers held: the joint drives.
fn is_held(range: &ReflectedRangeRecord) -> bool {
    range.held.iter().any(Option::is_some)
}

/// True if the free and the held inertia are equal up to rounding at all positions, as in a mechanism with one degree of freedom.
fn has_equal_curves(range: &ReflectedRangeRecord) -> bool {
    range.free.iter().zip(&range.held).all(|(free, held)| match (free, held) {
        (Some(free), Some(held)) => (free - held).abs() <= limits::EQUAL_CURVES * held,
        (free, held) => free == held,
    })
}

/// Error for `--output` if the result has neither a history nor a range.
pub fn no_output(path: &str) -> Failure {
    Failure::bad_input(format!(
        "--output {path}: the result has no table and no figure; give --in-time, or a range --reflected JOINT=FROM:TO:COUNT"
    ))
}

/// Writes reflected inertias over ranges as a table or a figure.
pub fn write_ranges(ranges: &[ReflectedRangeRecord], inputs: &[Input], path: &str) -> Result<(), Failure> {
    if ranges.is_empty() {
        return Err(no_output(path));
    }
    inputs.iter().for_each(|input| record_input(&input.path));
    let table = || cells(ranges);
    let model = inputs.first().map_or("", |input| &input.path);
    let picture = || Ok(Box::new(sheet(ranges, model)) as Box<dyn Picture>);
    Contents {
        name: "reflected inertia",
        table: Some(&table),
        picture: Some(&picture),
        ..Contents::default()
    }
    .write(path)
}

/// One row for each position of each joint.
fn cells(ranges: &[ReflectedRangeRecord]) -> Cells {
    let columns = ["joint", "position", "free", "held", "mimic_tree"].map(str::to_owned).to_vec();
    let row = |range: &ReflectedRangeRecord, k: usize| {
        let tree = range.substitute.as_ref().map(|found| found.inertias[k]);
        vec![
            Cell::Text(range.joint.clone().into()),
            Cell::Number(range.positions[k]),
            Cell::from_value(range.free[k]),
            Cell::from_value(range.held[k]),
            Cell::from_value(tree),
        ]
    };
    let rows = ranges.iter().flat_map(|range| (0..range.positions.len()).map(move |k| row(range, k)));
    (columns, rows.collect())
}

/// Figure for each joint: inertia over the position, free and held, and the best constant.
pub fn sheet(ranges: &[ReflectedRangeRecord], model: &str) -> Sheet {
    let figure = |range: &ReflectedRangeRecord| {
        let turns = range.unit == "kg·m²";
        let dimension = if turns { Dimension::Angle } else { Dimension::Length };
        let (scale, unit) = dimension.display_unit().map_or((1.0, ""), |unit| (unit.per_si, unit.name));
        let curve = |values: &[Option<f64>]| -> Vec<(f64, Option<f64>)> {
            range.positions.iter().zip(values).map(|(x, y)| (scale * x, *y)).collect()
        };
        let series = |name: String, style, points| Series { name, style, points };
        let mut curves = Vec::new();
        if has_equal_curves(range) {
            curves.push(series("other joints free or held".into(), Style::Line, curve(&range.free)));
        } else {
            curves.push(series("other joints free".into(), Style::Line, curve(&range.free)));
            if is_held(range) {
                curves.push(series("other drivers held".into(), Style::Line, curve(&range.held)));
            }
        }
        let constant = range.best_constant.zip(range.largest_error);
        if let Some((constant, error)) = constant.filter(|(_, error)| *error > limits::EQUAL_CURVES) {
            let name = format!("best constant, ± {} %", percent(error));
            let constant = vec![Some(constant); range.positions.len()];
            curves.push(series(name, Style::Dashed, curve(&constant)));
        }
        Figure {
            title: format!("Inertia reflected to {}", range.joint),
            subtitle: model.to_owned(),
            x_label: format!("{} ({unit})", range.joint),
            panels: vec![Panel {
                y_label: format!("reflected inertia ({})", range.unit),
                series: curves,
                ..Panel::default()
            }],
            ..Figure::default()
        }
    };
    Sheet { figures: ranges.iter().map(figure).collect() }
}
