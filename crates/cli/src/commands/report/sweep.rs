//! Sweep of a study: table, figure and values of some rows.

use super::bands::{add_band, tolerances_over};
use super::findings::add_warnings;
use crate::files::csv::SweepTable;
use crate::files::html::Page;
use crate::files::table_style::TableStyle;
use crate::pictures::clipping::{clip_outliers, remove_flat_panels};
use crate::pictures::sweep_figure::{SweepCurves, axis_unit, motion_ratio_name};
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::text::{number, short_number};
use percuss_render::Picture;
use percuss_study::{Input, Status, StudyFile, SweepEnd, SweepQuestion};
use std::ops::ControlFlow;
use std::path::Path;

/// Result of a sweep: table, end, and picture if possible.
pub(super) struct SweepSection {
    pub csv: String,
    pub end: SweepEnd,
    pub inputs: Vec<Input>,
    /// Figure and caption, or the reason for no figure.
    picture: Result<(String, String), String>,
    least: Option<f64>,
    greatest: Option<f64>,
    /// Numbers of rows whose contact is immovable or massless.
    immovable: usize,
    massless: usize,
    /// Unit of m̄.
    unit: &'static str,
    /// Name of the motion ratio.
    ratio: String,
    /// Name of the varied number with its unit, and rows of the table on the page; empty for several varied numbers.
    column: String,
    rows: Vec<[String; 3]>,
}

/// Runs the sweep of a study: its table, its end, and its picture.
pub(super) fn run_sweep(study: &StudyFile, requested: &SweepQuestion) -> Result<SweepSection, Failure> {
    let question = &study.question_of_rows(study.question.as_ref().unwrap_or(&study.conditions));
    let sweep = study.prepared_sweep(requested, question)?;
    let table =
        SweepTable::new(sweep.heading(), &study.model.mechanism, TableStyle::from_study(&requested.table()));
    let ratio = format!("motion ratio, {}", motion_ratio_name(sweep.heading().motion_ratio_of.as_deref()));
    let (inputs, unit) = (sweep.heading().inputs.clone(), sweep.heading().unit);
    let varied = match &sweep.heading().varied[..] {
        [varied] => Some((varied.name.clone(), axis_unit(varied, sweep.heading().length_unit))),
        _ => None,
    };
    let mut csv = table.header().to_owned();
    let (mut least, mut greatest) = (None::<f64>, None::<f64>);
    let (mut immovable, mut massless) = (0, 0);
    let mut rows: Vec<[String; 3]> = Vec::new();
    let mut values = Vec::new();
    let mut curves = SweepCurves::new(sweep.heading()).ok();
    let end = sweep.run(&mut |row| {
        csv += &table.row(&row);
        // A picture with too many curves is not drawn; its rows are no longer kept.
        if curves.as_mut().is_some_and(|curves| !curves.add(&row)) {
            curves = None;
        }
        immovable += usize::from(row.status == Status::Immovable.name());
        massless += usize::from(row.status == Status::Massless.name());
        if let Some(m) = row.effective_mass {
            least = Some(least.map_or(m, |l| l.min(m)));
            greatest = Some(greatest.map_or(m, |g| g.max(m)));
        }
        if let Some((_, (scale, _))) = &varied
            && rows.len() < limits::ROWS_KEPT
        {
            let value = row.varied.values().first().copied().unwrap_or_default();
            values.push(value);
            let at = scale * value;
            let mass = row.effective_mass.map_or_else(|| row.status.to_owned(), short_number);
            rows.push([
                short_number(at),
                mass,
                row.motion_ratio.map_or_else(|| "–".to_owned(), short_number),
            ]);
        }
        ControlFlow::Continue(())
    })?;
    let picture = match curves.map(|curves| curves.figure(question, &requested.figure())) {
        Some(Ok(mut figure)) => {
            // A report shows no path of the machine.
            let model = Path::new(&figure.subtitle).file_name();
            figure.subtitle = model.map_or_else(String::new, |name| name.to_string_lossy().into_owned());
            let clipped = clip_outliers(&mut figure);
            let scale = varied.as_ref().map_or(1.0, |(_, (scale, _))| *scale);
            let band = match &study.question {
                Some(question) => tolerances_over(study, question, &requested.rows(), &values, scale)?,
                None => Vec::new(),
            };
            let band = add_band(&mut figure, &band);
            let constants = remove_flat_panels(&mut figure);
            let caption = [&constants, &clipped, band].join(" ").trim().to_owned();
            if figure.panels.is_empty() { Err(caption) } else { Ok((figure.to_svg(), caption)) }
        }
        // The picture cannot show this sweep; the table contains it.
        None | Some(Err(_)) => Err(
            "No picture: a picture shows one range, or one curve for each value of the first of two ranges."
                .to_owned(),
        ),
    };
    let column = varied.map_or_else(String::new, |(name, (_, unit))| match unit {
        "" => name,
        unit => format!("{name} ({unit})"),
    });
    Ok(SweepSection {
        csv,
        end,
        inputs,
        picture,
        least,
        greatest,
        immovable,
        massless,
        unit,
        ratio,
        column,
        rows,
    })
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
        let mass = |m: Option<f64>| m.map_or("–".to_owned(), |m| format!("{} {}", number(m), self.unit));
        let counts = [
            (self.immovable, "immovable"),
            (self.massless, "massless"),
            (self.end.rows_without_result, "without a result"),
        ];
        let counts = counts.iter().filter(|(count, _)| *count > 0);
        let rows: String = counts.map(|(count, what)| format!(", {count} {what}")).collect();
        page.facts([
            ("rows", format!("{}{rows}", self.end.rows)),
            ("smallest", mass(self.least)),
            ("largest", mass(self.greatest)),
            ("all rows", table.to_owned()),
        ]);
        self.add_rows(page);
    }

    /// Table of evenly distributed rows, with the first and the last. A sweep of more rows than are kept has none.
    fn add_rows(&self, page: &mut Page) {
        if self.rows.is_empty() || self.end.rows > self.rows.len() {
            return;
        }
        let last = self.rows.len() - 1;
        let steps = last.clamp(1, limits::SWEEP_ROWS_SHOWN - 1);
        let mass = format!("m̄ ({})", self.unit);
        let has_ratio = self.rows.iter().any(|row| row[2] != "–");
        let chosen = (0..=steps.min(last)).map(|i| &self.rows[(i * last + steps / 2) / steps]);
        if has_ratio {
            let mut rows = vec![[self.column.as_str(), &mass, self.ratio.as_str()].map(str::to_owned)];
            rows.extend(chosen.cloned());
            page.table(&rows);
        } else {
            let mut rows = vec![[self.column.as_str(), &mass].map(str::to_owned)];
            rows.extend(chosen.map(|[at, mass, _]| [at.clone(), mass.clone()]));
            page.table(&rows);
        }
    }
}
