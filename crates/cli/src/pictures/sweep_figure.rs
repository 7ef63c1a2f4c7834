//! Picture of a sweep: effective mass with the estimate, and the motion ratio below.

use crate::terminal::failure::Failure;
use crate::terminal::number::number;
use crate::terminal::units::varied_name;
use indicatif::ProgressBar;
use percuss_render::{Figure, Mark, Panel, Series, Style};
use percuss_study::{
    AxisLimits, Continuation, Dimension, MassQuestion, StudyFigure, Sweep, SweepEnd, SweepHeading, SweepRow,
    VariedColumn,
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
        Dimension::Length => (length.of_metres(1.0), length.name()),
        Dimension::Angle => {
            Dimension::Angle.display_unit().map_or((1.0, "rad"), |unit| (unit.per_si, unit.name))
        }
        _ => (1.0, ""),
    }
}

/// Figure without panels, with the requested title, otherwise its own one, and the requested x axis.
pub fn requested_figure(requested: &StudyFigure, own_title: &str) -> Figure {
    Figure {
        title: requested.title.clone().unwrap_or_else(|| own_title.to_owned()),
        x_limits: requested.x_limits.map(AxisLimits::ends),
        ..Figure::default()
    }
}

/// Legend of the estimate.
fn estimate_name(question: &MassQuestion) -> String {
    let links =
        question.contact.estimate.as_ref().map_or_else(String::new, |estimate| estimate.links.join(" + "));
    format!("estimate: mass of {links} / (motion ratio)²")
}

/// Name of a motion ratio. `of`: its motion, as in [`percuss_study::SweepHeading`] or the name of the varied column.
pub fn motion_ratio_name(of: Option<&str>) -> String {
    match of {
        Some("estimate") => "contact per travel of the point of the estimate".to_owned(),
        Some("travel:wheel_centre" | "wheel-travel") => "contact per wheel travel".to_owned(),
        Some(of) => format!("contact per {}", varied_name(of)),
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
    let mut curves = SweepCurves::new(sweep.heading())?;
    let end = sweep.run(&mut |row| {
        bar.inc(1);
        if curves.add(&row) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    })?;
    Ok((curves.figure(question, requested)?, end))
}

/// Data of a picture, collected row by row.
pub struct SweepCurves {
    heading: SweepHeading,
    /// True for two ranges: one curve for each value of the first.
    has_outer: bool,
    /// Factor from SI to the unit of the axis.
    scale: f64,
    unit: &'static str,
    /// One curve per value of the outer range.
    masses: Vec<(f64, Curve)>,
    estimates: Curve,
    ratios: Curve,
    marks: Vec<Mark>,
    /// Value of the axis and gap of the last row.
    last: Option<(f64, f64)>,
}

impl SweepCurves {
    /// No rows yet.
    ///
    /// # Errors
    /// More varied numbers than a picture shows.
    pub fn new(heading: &SweepHeading) -> Result<Self, Failure> {
        let is_grid = heading.continuation != Continuation::Path && heading.seed.is_none();
        let varied = match &heading.varied[..] {
            [varied] => varied,
            [_, varied] if is_grid => varied,
            _ => {
                return Err(Failure::bad_input(
                    "--output: a picture shows one range, or one curve for each value of the first of two ranges; \
                     give a file that ends in .csv, .xlsx, .parquet, .json or .jsonl",
                ));
            }
        };
        let (scale, unit) = axis_unit(varied, heading.length_unit);
        Ok(Self {
            has_outer: heading.varied.len() > 1,
            heading: heading.clone(),
            scale,
            unit,
            masses: Vec::new(),
            estimates: Curve::new(),
            ratios: Curve::new(),
            marks: Vec::new(),
            last: None,
        })
    }

    /// Adds a row; false if the picture would have too many curves.
    pub fn add(&mut self, row: &SweepRow) -> bool {
        let values = row.varied.values();
        let x = self.scale * values.last().copied().unwrap_or_default();
        let of = if self.has_outer { values[0] } else { 0.0 };
        if self.masses.last().is_none_or(|(last, _)| *last != of) {
            if self.masses.len() > MAX_CURVES {
                return false;
            }
            self.masses.push((of, Curve::new()));
        }
        if let Some((_, curve)) = self.masses.last_mut() {
            curve.push((x, row.effective_mass));
        }
        self.estimates.push((x, row.estimate));
        self.ratios.push((x, row.motion_ratio));
        let gap = row.gap.flatten();
        // Between two rows the gap is nearly linear in the travel.
        if let (Some((last_x, last_gap)), Some(gap)) = (self.last, gap)
            && last_gap * gap <= 0.0
            && last_gap != gap
            && !self.has_outer
        {
            let touch = last_x + (x - last_x) * last_gap / (last_gap - gap);
            self.marks.push(Mark { x: touch, label: "touch".into() });
        }
        self.last = gap.filter(|gap| *gap != 0.0).map(|gap| (x, gap));
        if row.singular_pose == Some(true) && self.marks.len() < MAX_MARKS {
            self.marks.push(Mark { x, label: "singular".into() });
        }
        self.masses.len() <= MAX_CURVES
    }

    /// Picture of the rows.
    ///
    /// # Errors
    /// Too many curves.
    pub fn figure(self, question: &MassQuestion, requested: &StudyFigure) -> Result<Figure, Failure> {
        let Self { heading, has_outer, unit, masses, estimates, ratios, marks, .. } = self;
        let series = |name: &str, style, points| Series { name: name.into(), style, points };
        let is_drawn = |curve: &Curve| curve.iter().any(|(_, value)| value.is_some());
        if masses.len() > MAX_CURVES {
            return Err(Failure::bad_input(format!(
                "--output: the first range has more than {MAX_CURVES} values, and each value is one curve; use fewer \
                 values, or give a file that ends in .csv, .xlsx, .parquet, .json or .jsonl"
            )));
        }
        let outer = heading.varied.first().filter(|_| has_outer);
        let of_value = |(value, curve): (f64, Curve)| match outer {
            None => series("effective mass", Style::Line, curve),
            Some(outer) => {
                let (scale, unit) = axis_unit(outer, heading.length_unit);
                let name = format!("{} = {} {unit}", outer.name, number(scale * value));
                series(name.trim_end(), Style::Line, curve)
            }
        };
        let mut first: Vec<Series> = masses.into_iter().map(of_value).collect();
        // With several curves, the estimate would be a single line running back and forth.
        let alone = !has_outer;
        if alone && is_drawn(&estimates) {
            first.push(series(&estimate_name(question), Style::Dashed, estimates));
        }
        let mut panels = vec![Panel {
            y_label: format!("m̄ ({})", heading.unit),
            series: first,
            y_limits: requested.y_limits.map(AxisLimits::ends),
            ..Panel::default()
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
        let varied = heading.varied.last().map_or_else(String::new, |varied| varied_name(&varied.name));
        let contact = heading.contact.as_ref().unwrap_or(&heading.link);
        Ok(Figure {
            subtitle: heading.inputs.first().map_or_else(String::new, |input| input.path.clone()),
            x_label: if unit.is_empty() { varied } else { format!("{varied} ({unit})") },
            panels,
            marks,
            ..requested_figure(requested, &format!("Effective mass at {contact}"))
        })
    }
}
