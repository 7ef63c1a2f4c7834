//! Picture of a sweep: effective mass with the estimate, and the motion ratio below.

use crate::terminal::failure::Failure;
use crate::terminal::text::short_number;
use indicatif::ProgressBar;
use percuss_render::{Figure, Mark, Panel, Series, Style};
use percuss_study::{
    AxisLimits, Continuation, Dimension, MassQuestion, StudyFigure, Sweep, SweepEnd, VariedColumn,
};
use percuss_suspension::LengthUnit;
use std::ops::ControlFlow;

/// Points of a curve: the varied number in the unit of the axis, and the value if any.
type Curve = Vec<(f64, Option<f64>)>;

/// Largest number of marks at singular poses; more would merge into a line.
const MAX_MARKS: usize = 10_000;

/// Largest number of curves in one picture; more cannot be distinguished.
pub const MAX_CURVES: usize = 7;

/// Scale factor from SI, and unit of the axis for a varied number; `length`: unit of lengths.
pub fn axis_unit(column: &VariedColumn, length: LengthUnit) -> (f64, &'static str) {
    match column.unit {
        "m" => (length.of_metres(1.0), length.name()),
        "rad" => Dimension::Angle.display_unit().map_or((1.0, "rad"), |unit| (unit.per_si, unit.name)),
        _ => (1.0, ""),
    }
}

/// Legend of the estimate.
fn estimate_name(question: &MassQuestion) -> String {
    let links = question.estimate.as_ref().map_or_else(String::new, |estimate| estimate.links.join(" + "));
    format!("estimate: mass of {links} / (motion ratio)²")
}

/// Name of a motion ratio. `of`: its motion, as in [`percuss_study::SweepHeading`] or the name of the varied column.
pub fn motion_ratio_name(of: Option<&str>) -> String {
    match of {
        Some("estimate") => "contact per travel of the point of the estimate".to_owned(),
        Some(motion @ ("heave" | "roll")) => format!("contact per {motion}"),
        Some(of) => match of.strip_prefix("travel:") {
            Some(link) => format!("contact per travel of {link}"),
            None => "contact per travel".to_owned(),
        },
        None => "contact per travel".to_owned(),
    }
}

/// Runs a sweep and keeps only the data of the picture.
pub fn sweep_figure(
    sweep: Sweep,
    question: &MassQuestion,
    requested: &StudyFigure,
    bar: &ProgressBar,
) -> Result<(Figure, SweepEnd), Failure> {
    let heading = sweep.heading().clone();
    let (outer, varied) = match &heading.varied[..] {
        [varied] => (None, varied),
        [outer, varied] if heading.continuation != Continuation::Path && heading.seed.is_none() => {
            (Some(outer), varied)
        }
        _ => {
            return Err(Failure::bad_input(
                "--output: a picture shows one range, or one curve for each value of the first of two ranges; \
                 give a file that ends in .csv, .xlsx, .parquet, .json or .jsonl",
            ));
        }
    };
    let (scale, unit) = axis_unit(varied, heading.length_unit);
    let (mut estimates, mut ratios) = (Curve::new(), Curve::new());
    // One curve per value of the outer range.
    let mut masses: Vec<(f64, Curve)> = Vec::new();
    let mut marks = Vec::new();
    // Value of the axis and gap of the last row.
    let mut last: Option<(f64, f64)> = None;
    let end = sweep.run(&mut |row| {
        bar.inc(1);
        let values = row.varied.values();
        let x = scale * values.last().copied().unwrap_or_default();
        let of = if outer.is_some() { values[0] } else { 0.0 };
        if masses.last().is_none_or(|(last, _)| *last != of) {
            masses.push((of, Curve::new()));
        }
        if masses.len() > MAX_CURVES {
            return ControlFlow::Break(());
        }
        if let Some((_, curve)) = masses.last_mut() {
            curve.push((x, row.effective_mass));
        }
        estimates.push((x, row.estimate));
        ratios.push((x, row.motion_ratio));
        let gap = row.gap.flatten();
        // Between two rows the gap is nearly linear in the travel.
        if let (Some((last_x, last_gap)), Some(gap)) = (last, gap)
            && last_gap * gap <= 0.0
            && last_gap != gap
            && outer.is_none()
        {
            let touch = last_x + (x - last_x) * last_gap / (last_gap - gap);
            marks.push(Mark { x: touch, label: "touch".into() });
        }
        last = gap.filter(|gap| *gap != 0.0).map(|gap| (x, gap));
        if row.singular_pose == Some(true) && marks.len() < MAX_MARKS {
            marks.push(Mark { x, label: "singular".into() });
        }
        ControlFlow::Continue(())
    })?;
    let series = |name: &str, style, points| Series { name: name.into(), style, points };
    let is_drawn = |curve: &Curve| curve.iter().any(|(_, value)| value.is_some());
    if masses.len() > MAX_CURVES {
        return Err(Failure::bad_input(format!(
            "--output: the first range has more than {MAX_CURVES} values, and each value is one curve; use fewer \
             values, or give a file that ends in .csv, .xlsx, .parquet, .json or .jsonl"
        )));
    }
    let mut first: Vec<Series> = masses
        .into_iter()
        .map(|(value, curve)| match outer {
            None => series("effective mass", Style::Line, curve),
            Some(outer) => {
                let (scale, unit) = axis_unit(outer, heading.length_unit);
                let name = format!("{} = {} {unit}", outer.name, short_number(scale * value));
                series(name.trim_end(), Style::Line, curve)
            }
        })
        .collect();
    // With several curves, the estimate would be a single line running back and forth.
    let alone = outer.is_none();
    if alone && is_drawn(&estimates) {
        first.push(series(&estimate_name(question), Style::Dashed, estimates));
    }
    let mut panels = vec![Panel {
        y_label: format!("m̄ ({})", heading.unit),
        series: first,
        y_limits: requested.y_limits.map(AxisLimits::ends),
    }];
    if alone && is_drawn(&ratios) {
        let of = motion_ratio_name(heading.motion_ratio_of.as_deref());
        let ratio = series(&of, Style::Line, ratios);
        panels.push(Panel {
            y_label: format!("motion ratio, {of}"),
            series: vec![ratio],
            ..Panel::default()
        });
    }
    let figure = Figure {
        title: requested.title.clone().unwrap_or_else(|| {
            format!("Effective mass at {}", heading.contact.as_ref().unwrap_or(&heading.link))
        }),
        x_limits: requested.x_limits.map(AxisLimits::ends),
        subtitle: heading.inputs.first().map_or_else(String::new, |input| input.path.clone()),
        x_label: if unit.is_empty() { varied.name.clone() } else { format!("{} ({unit})", varied.name) },
        panels,
        marks,
    };
    Ok((figure, end))
}
