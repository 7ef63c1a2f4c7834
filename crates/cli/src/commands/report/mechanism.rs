//! Picture of the mechanism, and contents of a model without a contact.

use super::findings::add_warnings;
use super::results::StudyResults;
use crate::commands::check;
use crate::files::html::Page;
use crate::pictures::mechanism::drawing;
use crate::terminal::limits;
use crate::terminal::text::shell_quoted;
use percuss_render::Picture;
use percuss_study::CheckReport;
use std::path::Path;

/// Explanation of the picture.
const LEGEND: &str = "Arms and rods of a suspension are drawn from each bush to the outer point. For other links a line joins the \
    joints, the loops' ends and the centre of mass, over the shapes if the model has shapes. Springs, dampers, stops and contact \
    patches are drawn where the model names them; the gap of a stop is the distance between its pad and the hatched face. A \
    wheel of a suspension is a circle.";

/// Section with the picture of the mechanism.
pub(super) fn add_mechanism(results: &StudyResults, page: &mut Page) {
    page.section("The mechanism at this pose");
    let report = results.report.mass.as_ref();
    let mut caption = LEGEND.to_owned();
    if let Some(report) = report {
        caption += match report.contact.is_moment {
            true => {
                " The contact is a moment about an axis: n is the axis, and the red dot is the origin of the contact link."
            }
            false => " The red dot is the contact point, and n is its normal.",
        };
        caption += " Blue arrows are the velocities of the centres of mass while the contact closes; the longest is drawn as long as n.";
    }
    let named = results.mechanism.points.len() + results.mechanism.elements.len();
    if named > limits::NAMED_POINTS {
        caption += &format!(" {} of {named} named points are numbered.", limits::NAMED_POINTS);
    }
    let views = "The mechanism from the front, from the left and from above";
    page.large_picture(&drawing(report, &results.mechanism).to_svg(), views);
    page.paragraph("soft", &caption);
    add_warnings(&results.mechanism.diagnostics, page);
}

/// Sections of a model without a contact: contents, possible questions.
pub(super) fn add_model(contents: &CheckReport, page: &mut Page) {
    page.section("The model");
    check::document(contents).show(page);
    page.section("Possible contacts");
    page.paragraph(
        "",
        "The study has no [contact] with a normal, so this page shows no effective mass. A contact is a link, a point of \
         it and a normal (or a line towards a point of another link); this command writes a study with a contact of \
         this model that has a result, and with sweeps, variants and dampers as options:",
    );
    let model = contents.inputs.first().and_then(|input| Path::new(&input.path).file_name());
    let model = model.map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    page.code(&format!("percuss init {} -o contact.toml", shell_quoted(&model)));
}
