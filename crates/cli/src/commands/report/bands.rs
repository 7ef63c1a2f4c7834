//! Tolerance of the effective mass over a sweep, as a band about the curve.

use crate::pictures::sweep_figure::axis_unit;
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use percuss_render::{Figure, Series, Style};
use percuss_study::{
    ComparisonReport, GivenPosition, GivenTravel, MassQuestion, Model, RowSource, StudyContact, StudyFile,
    Varied, tolerance_report,
};
use rayon::prelude::*;

/// Pairs of a value on the axis and a tolerance of m̄, kg.
pub(super) type Tolerances = Vec<(f64, f64)>;

/// First-order tolerance, kg, at evenly distributed values (SI units) of a sweep over one range: pairs of the value times `scale` and the
/// root sum square of the tolerances of the study. Empty without tolerances, for another source of rows, and without a result.
///
/// # Errors
/// Those of [`tolerance_report`], apart from a pose that is not reached.
pub(super) fn tolerances_over(
    study: &StudyFile,
    question: &MassQuestion,
    rows: &RowSource,
    values: &[f64],
    scale: f64,
) -> Result<Tolerances, Failure> {
    let (Some(tolerance), RowSource::Grid(ranges)) = (study.mass.tolerance(), rows) else {
        return Ok(Vec::new());
    };
    let question = &study.question_of_rows(question);
    let ([range], Some(last)) = (&ranges[..], values.len().checked_sub(1)) else { return Ok(Vec::new()) };
    let rows = match study.contacts.len() {
        0 | 1 => limits::TOLERANCE_ROWS,
        contacts => limits::TOLERANCE_ROWS_OF_ALL / contacts,
    };
    if rows < limits::LEAST_TOLERANCE_ROWS {
        return Ok(Vec::new());
    }
    let steps = last.min(rows - 1);
    let at_row = |i: usize| {
        let value = values[i * last / steps.max(1)];
        let at_row = question_at(question, &study.model, &range.quantity, value)?;
        let found = match tolerance_report(&study.model, &at_row, tolerance, None) {
            Ok(Some(report)) => Ok((scale * value, report.root_sum_square)),
            Ok(None) => return None,
            Err(error) if error.has_no_result() => return None,
            Err(error) => Err(error.into()),
        };
        Some(found)
    };
    let mut found: Tolerances =
        (0..=steps).into_par_iter().filter_map(at_row).collect::<Result<_, Failure>>()?;
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(found)
}

/// Tolerances over the rows of a comparison at each contact of a study with several contacts, in the unit of its figures.
pub(super) fn tolerances_of_contacts(
    study: &StudyFile,
    compared: &ComparisonReport,
) -> Result<Vec<Tolerances>, Failure> {
    let (Some(sweep), [varied]) = (&study.tables.sweep, &compared.varied[..]) else { return Ok(Vec::new()) };
    let values: Vec<f64> = compared.rows.iter().filter_map(|row| row.varied.first().copied()).collect();
    let scale = axis_unit(varied, study.model.length_unit()).0;
    let of_contact =
        |contact: &StudyContact| tolerances_over(study, &contact.question, &sweep.rows(), &values, scale);
    study.contacts.par_iter().map(of_contact).collect()
}

/// Adds the band of the tolerances to the first curve of a figure, that of m̄ of the design itself; returns the sentence of the caption.
pub(super) fn add_band(figure: &mut Figure, tolerances: &[(f64, f64)]) -> &'static str {
    let Some(panel) = figure.panels.first_mut() else { return "" };
    let Some(band) = panel.series.first().and_then(|mass| tolerance_band(&mass.points, tolerances)) else {
        return "";
    };
    panel.series.push(band);
    "The band is the first-order effect of the tolerances."
}

/// Band of the tolerances about a curve: `tolerances` in ascending order of x, interpolated linearly. `None` for fewer than two.
fn tolerance_band(curve: &[(f64, Option<f64>)], tolerances: &[(f64, f64)]) -> Option<Series> {
    let half_width = |x: f64| {
        let pair = tolerances.windows(2).find(|pair| (pair[0].0..=pair[1].0).contains(&x))?;
        let [(from, low), (to, high)] = [pair[0], pair[1]];
        let part = if to > from { (x - from) / (to - from) } else { 0.0 };
        Some(low + part * (high - low))
    };
    let drawn = |&(x, mass): &(f64, Option<f64>)| Some((x, mass?, half_width(x)?));
    let all: Vec<Option<(f64, f64, f64)>> = curve.iter().map(drawn).collect();
    let mut points = Vec::new();
    for run in all.split(Option::is_none).filter(|run| run.len() > 1) {
        let run: Vec<(f64, f64, f64)> = run.iter().copied().flatten().collect();
        // A mass is not negative.
        points.extend(run.iter().map(|(x, mass, half)| (*x, Some((mass - half).max(0.0)))));
        points.extend(run.iter().rev().map(|(x, mass, half)| (*x, Some(mass + half))));
        points.push((run[0].0, None));
    }
    let name = "± tolerances (root sum square)".to_owned();
    (!points.is_empty()).then_some(Series { name, style: Style::Band, points })
}

/// Question with the varied quantity at a value.
fn question_at(question: &MassQuestion, model: &Model, varied: &Varied, value: f64) -> Option<MassQuestion> {
    let mut question = question.clone();
    match varied {
        Varied::Travel(moved) => {
            question.pose.travel.push(GivenTravel { moved: moved.clone(), distance: value });
        }
        Varied::Joint(joint) => {
            model.mechanism.find_joint(joint).ok()?;
            question.pose.set.retain(|(other, _)| other != joint);
            question.pose.set.push((joint.clone(), GivenPosition::from_numbers(&[value]).ok()?));
        }
    }
    Some(question)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_band_follows_the_curve() {
        let curve = [(0.0, Some(10.0)), (1.0, Some(12.0)), (2.0, None), (3.0, Some(11.0)), (4.0, Some(11.0))];
        let band = tolerance_band(&curve, &[(0.0, 1.0), (2.0, 3.0), (4.0, 1.0)]).expect("a band");
        let lower = [(0.0, Some(9.0)), (1.0, Some(10.0))];
        let upper = [(1.0, Some(14.0)), (0.0, Some(11.0)), (0.0, None)];
        assert_eq!(band.points[..5], [lower.as_slice(), &upper].concat());
        assert_eq!(
            band.points[5..],
            [(3.0, Some(9.0)), (4.0, Some(10.0)), (4.0, Some(12.0)), (3.0, Some(13.0)), (3.0, None)]
        );
        assert_eq!(tolerance_band(&curve, &[(0.0, 1.0)]), None);
    }
}
