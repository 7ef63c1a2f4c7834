//! The picture of a sweep: effective mass with the estimate, and the motion ratio below it.

use crate::failure::Failure;
use indicatif::ProgressBar;
use percuss_render::{Figure, Mark, Panel, Series, Style};
use percuss_study::{Sweep, SweepEnd};
use std::ops::ControlFlow;

/// Points of a curve: what was varied, in the unit of the axis, and a value where there is one.
type Curve = Vec<(f64, Option<f64>)>;

/// Marks at singular poses that are drawn: more of them are a line.
const MARKS: usize = 10_000;

/// Goes through a sweep, keeping of its rows what is drawn.
pub fn drawn(sweep: Sweep, bar: &ProgressBar) -> Result<(Figure, SweepEnd), Failure> {
    let heading = sweep.heading().clone();
    let [varied] = &heading.varied[..] else {
        return Err(Failure::bad_input(
            "--output: a picture shows what one range gives; name a file that ends in .csv, .parquet, .json or .jsonl",
        ));
    };
    let (scale, unit) = if varied.unit == "m" { (1e3, "mm") } else { (180.0 / std::f64::consts::PI, "deg") };
    let (mut masses, mut estimates, mut ratios) = (Curve::new(), Curve::new(), Curve::new());
    let mut marks = Vec::new();
    let end = sweep.run(&mut |row| {
        bar.inc(1);
        let x = scale * row.varied.values().first().copied().unwrap_or_default();
        masses.push((x, row.effective_mass));
        estimates.push((x, row.estimate));
        ratios.push((x, row.motion_ratio));
        if row.singular_pose == Some(true) && marks.len() < MARKS {
            marks.push(Mark { x, label: "singular".into() });
        }
        ControlFlow::Continue(())
    })?;
    let series = |name: &str, style, points| Series { name: name.into(), style, points };
    let is_drawn = |curve: &Curve| curve.iter().any(|(_, value)| value.is_some());
    let mut first = vec![series("effective mass", Style::Line, masses)];
    if is_drawn(&estimates) {
        first.push(series("estimate", Style::Dashed, estimates));
    }
    let mut panels = vec![Panel { y_label: "m̄ (kg)".into(), series: first }];
    if is_drawn(&ratios) {
        let ratio = series("A over contact", Style::Line, ratios);
        panels.push(Panel { y_label: "motion ratio".into(), series: vec![ratio] });
    }
    let figure = Figure {
        title: format!("Effective mass at {}", heading.link),
        subtitle: heading.inputs.first().map_or_else(String::new, |input| input.path.clone()),
        x_label: format!("{} ({unit})", varied.name),
        panels,
        marks,
    };
    Ok((figure, end))
}
