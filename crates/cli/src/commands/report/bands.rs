//! Tolerance of the effective mass at some rows of a sweep, as error bars.

use crate::terminal::failure::Failure;
use crate::terminal::limits;
use percuss_render::{Series, Style};
use percuss_study::{
    GivenPosition, GivenTravel, MassQuestion, Model, RowSource, StudyFile, Varied, tolerance_report,
};

/// Error bars at evenly distributed values (SI units) of a sweep over one range: the root sum square of the tolerances of
/// the study. `None` without tolerances, for another source of rows, and without a result.
///
/// # Errors
/// Those of [`tolerance_report`], apart from a pose that is not reached.
pub(super) fn tolerance_bars(
    study: &StudyFile,
    rows: &RowSource,
    values: &[f64],
    scale: f64,
) -> Result<Option<Series>, Failure> {
    let (Some(tolerance), Some(question), RowSource::Grid(ranges)) =
        (study.mass.tolerance, &study.question, rows)
    else {
        return Ok(None);
    };
    let question = &study.question_of_rows(question);
    let ([range], Some(last)) = (&ranges[..], values.len().checked_sub(1)) else { return Ok(None) };
    let steps = last.min(limits::TOLERANCE_BARS - 1);
    let mut points = Vec::new();
    for i in 0..=steps {
        let value = values[i * last / steps.max(1)];
        let Some(at_row) = question_at(question, &study.model, &range.quantity, value) else {
            return Ok(None);
        };
        match tolerance_report(&study.model, &at_row, tolerance, None) {
            Ok(Some(report)) => {
                let (mass, off) = (report.effective_mass, report.root_sum_square);
                points.extend([Some(mass - off), Some(mass + off), None].map(|y| (scale * value, y)));
            }
            Ok(None) => {}
            Err(error) if error.has_no_result() => {}
            Err(error) => return Err(error.into()),
        }
    }
    let name = "± tolerances (root sum square)".to_owned();
    Ok((!points.is_empty()).then_some(Series { name, style: Style::Line, points }))
}

/// Question with the varied quantity at a value.
fn question_at(question: &MassQuestion, model: &Model, varied: &Varied, value: f64) -> Option<MassQuestion> {
    let mut question = question.clone();
    match varied {
        Varied::Travel(moved) => {
            question.travel.push(GivenTravel { moved: moved.clone(), distance: value });
        }
        Varied::Joint(joint) => {
            model.mechanism.find_joint(joint).ok()?;
            question.set.retain(|(other, _)| other != joint);
            question.set.push((joint.clone(), GivenPosition::from_numbers(&[value]).ok()?));
        }
    }
    Some(question)
}
