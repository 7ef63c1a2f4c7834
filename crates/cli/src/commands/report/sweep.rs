//! Sweep of a study: table, figure and values of some rows.

use super::bands::{add_band, tolerances_over};
use super::findings::add_warnings;
use crate::commands::sweep_text::SweepText;
use crate::files::csv::SweepTable;
use crate::files::html::Page;
use crate::files::table_style::TableStyle;
use crate::pictures::clipping::{clip_outliers, remove_flat_panels};
use crate::pictures::sweep_figure::{SweepCurves, axis_unit, motion_ratio_name};
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::number::number;
use crate::terminal::units::varied_name;
use percuss_render::{Figure, LabelledPoint, Picture, Style};
use percuss_study::{Input, MassReport, StudyFile, SweepEnd, SweepQuestion};
use std::ops::ControlFlow;
use std::path::Path;

/// Result of a sweep: table, end, and picture if possible.
pub(super) struct SweepSection {
    pub csv: String,
    pub end: SweepEnd,
    pub inputs: Vec<Input>,
    /// Figure and caption, or the reason for no figure.
    picture: Result<(String, String), String>,
    /// Rows of the table on the page.
    text: SweepText,
    /// Name of the motion ratio.
    ratio: String,
    /// Name of the varied number.
    pub varied: String,
    /// Curve of m̄ for the first page; `None` without a picture.
    pub half_figure: Option<String>,
}

/// Runs the sweep of a study: its table, its end, and its pictures. `mass`: result that is marked on the curve.
pub(super) fn run_sweep(
    study: &StudyFile,
    requested: &SweepQuestion,
    mass: Option<&MassReport>,
) -> Result<SweepSection, Failure> {
    let question = &study.question_of_rows(study.question.as_ref().unwrap_or(&study.conditions));
    let sweep = study.prepared_sweep(requested, question)?;
    let table =
        SweepTable::new(sweep.heading(), &study.model.mechanism, TableStyle::from_study(&requested.table()));
    let ratio = motion_ratio_name(sweep.heading().motion_ratio_of.as_deref());
    let inputs = sweep.heading().inputs.clone();
    let scale = match &sweep.heading().varied[..] {
        [varied] => axis_unit(varied, sweep.heading().length_unit).0,
        _ => 1.0,
    };
    let varied = sweep.heading().varied.last().map_or_else(String::new, |varied| varied_name(&varied.name));
    let is_travel =
        sweep.heading().varied.len() == 1 && WHEEL_TRAVELS.contains(&&*sweep.heading().varied[0].name);
    let mut half_figure = None;
    let mut csv = table.header().to_owned();
    let mut text = SweepText::new(sweep.heading());
    let mut values = Vec::new();
    let mut curves = SweepCurves::new(sweep.heading()).ok();
    let end = sweep.run(&mut |row| {
        csv += &table.row(&row);
        // A picture with too many curves is not drawn; its rows are no longer kept.
        if curves.as_mut().is_some_and(|curves| !curves.add(&row)) {
            curves = None;
        }
        text.add(&row);
        if values.len() < limits::ROWS_KEPT {
            values.push(row.varied.values().first().copied().unwrap_or_default());
        }
        ControlFlow::Continue(())
    })?;
    let picture = match curves.map(|curves| curves.figure(question, &requested.figure())) {
        Some(Ok(mut figure)) => {
            // A report shows no path of the machine.
            let model = Path::new(&figure.subtitle).file_name();
            figure.subtitle = model.map_or_else(String::new, |name| name.to_string_lossy().into_owned());
            let clipped = clip_outliers(&mut figure);
            let band = match &study.question {
                Some(question) => tolerances_over(study, question, &requested.rows(), &values, scale)?,
                None => Vec::new(),
            };
            let band = add_band(&mut figure, &band);
            if is_travel {
                mark_result(&mut figure, mass, scale);
            }
            let constants = remove_flat_panels(&mut figure);
            let caption = [&constants, &clipped, band].join(" ").trim().to_owned();
            half_figure = half_of(&figure);
            if figure.panels.is_empty() { Err(caption) } else { Ok((figure.to_svg(), caption)) }
        }
        // The picture cannot show this sweep; the table contains it.
        None | Some(Err(_)) => Err(
            "No picture: a picture shows one range, or one curve for each value of the first of two ranges."
                .to_owned(),
        ),
    };
    Ok(SweepSection { csv, end, inputs, picture, text, ratio, varied, half_figure })
}

/// Varied numbers that are the travel of the wheel.
const WHEEL_TRAVELS: [&str; 2] = ["wheel-travel", "travel:wheel_centre"];

/// Marks the result at its touch and the value in the design position on the curve of m̄. `scale`: factor to the unit of the axis.
fn mark_result(figure: &mut Figure, mass: Option<&MassReport>, scale: f64) {
    let Some(panel) = figure.panels.first_mut() else { return };
    let Some(series) = panel.series.iter_mut().find(|series| series.style == Style::Line) else { return };
    let drawn = series.points.iter().find(|(x, _)| x.abs() < 1e-9).and_then(|(x, y)| Some((*x, (*y)?)));
    panel.values.extend(drawn.map(|(x, y)| LabelledPoint {
        x,
        y,
        spread: None,
        label: format!("{} in the design position", number(y)),
    }));
    let touch = mass.and_then(|report| {
        let contact = report.named_contact.as_ref().filter(|contact| contact.brought_to_touch)?;
        let [wheel] = &contact.wheel_travel[..] else { return None };
        Some((scale * wheel.travel, report.effective_mass?, report))
    });
    if let Some((x, y, report)) = touch {
        let spread = report.tolerance.as_ref().map(|tolerance| tolerance.root_sum_square);
        panel.values.push(LabelledPoint { x, y, spread, label: format!("{} at the touch", number(y)) });
        // The curve continues to the touch.
        let at = series.points.partition_point(|point| point.0 < x);
        if series.points.get(at).is_none_or(|point| point.0 != x) {
            series.points.insert(at, (x, Some(y)));
        }
    }
}

/// Curve of m̄ for a place beside text; `None` if the figure has no panel.
fn half_of(figure: &Figure) -> Option<String> {
    // A constant has no curve.
    let mut panel = figure.panels.first().filter(|panel| panel.y_label.starts_with("m̄"))?.clone();
    for series in panel.series.iter_mut().filter(|series| series.style == Style::Dashed) {
        series.name = "estimate by the motion ratio".to_owned();
    }
    let half = Figure {
        title: String::new(),
        subtitle: String::new(),
        panels: vec![panel],
        is_half: true,
        ..figure.clone()
    };
    Some(half.to_svg())
}

impl SweepSection {
    /// Adds the section of the sweep; `table` is the name of the CSV file. `first`: name of the first of several contacts, whose
    /// figure and warnings are in the section of the contacts.
    pub fn add_to(&self, page: &mut Page, table: &str, first: Option<&str>) {
        match first {
            Some(contact) => page.section(&format!("The sweep at {contact}")),
            None => page.section("The sweep"),
        }
        match &self.picture {
            _ if first.is_some() => {
                page.paragraph("soft", "The figures of all contacts are in the next section.")
            }
            Ok((svg, clipped)) => page.picture(svg, "Effective mass over the varied quantity", clipped),
            Err(why) => page.paragraph("soft", why),
        }
        if first.is_none() {
            add_warnings(&self.end.diagnostics, page);
        }
        if let Some(error) = self.end.first_error.as_ref().filter(|_| self.end.rows_without_result > 0) {
            page.warning(&format!(
                "{} rows have no result; the first: {error}",
                self.end.rows_without_result
            ));
        }
        page.facts([("rows", self.text.summary()), ("all rows", table.to_owned())]);
        page.table_with_bars(&self.text.table(limits::SWEEP_ROWS_SHOWN));
        page.paragraph("soft", &format!("Motion ratio: {}.", self.ratio));
    }
}
