//! Picture of the mechanism, and contents of a model without a contact.

use super::findings::add_warnings;
use super::results::StudyResults;
use crate::commands::check;
use crate::files::html::Page;
use crate::pictures::mechanism::drawing;
use crate::terminal::text::shell_quoted;
use percuss_render::Picture;
use percuss_study::CheckReport;
use std::path::Path;

/// Explanation of the picture: of links, and of the parts of a suspension.
const LEGEND: &str = "A line joins the joints, the ends of loops and the centre of mass of a link, over its shapes if the model has shapes. \
    The pointer shows the names of the joints.";
const LEGEND_OF_SHEET: &str = "Arms and rods are drawn from each bush to the outer point, the tyre as an outline. The gap of a stop is the \
    distance between its pad and the hatched face. The pointer shows the names of the points.";

/// Section with the picture of the mechanism.
pub(super) fn add_mechanism(results: &StudyResults, page: &mut Page) {
    page.section("The mechanism at this pose");
    let report = results.report.mass.as_ref();
    let has_sheet = !results.mechanism.wheels.is_empty();
    let mut caption = if has_sheet { LEGEND_OF_SHEET } else { LEGEND }.to_owned();
    if let Some(report) = report {
        caption += match report.contact.is_moment {
            true => {
                " The contact is a moment about an axis: n is the axis, and the blue dot is the origin of the contact link."
            }
            false => " The blue dot is the contact point, and n is its normal.",
        };
        caption += " Colour and width of a link show its share of m̄. Grey arrows are the velocities of the centres of mass while the \
                    contact closes; the longest is drawn as long as n.";
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
