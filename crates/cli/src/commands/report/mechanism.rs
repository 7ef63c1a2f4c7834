//! Picture of the mechanism, and contents of a model without a contact.

use super::findings::add_warnings;
use super::results::StudyResults;
use crate::commands::check;
use crate::files::html::Page;
use crate::terminal::limits;
use crate::terminal::text::shell_quoted;
use percuss_mechanism::ContactKind;
use percuss_render::{
    Drawing, DrawnArrow, DrawnCircle, DrawnFacet, DrawnLine, DrawnSymbol, SkinMark, SymbolKind,
};
use percuss_study::{CheckReport, DrawnElement, DrawnMechanism, MassReport};
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
    page.facts(check::facts(contents));
    let tables = check::tables(contents);
    page.heading("Links");
    page.table(tables.links.rows());
    if !contents.joints.is_empty() {
        page.heading("Joints");
        page.table(tables.joints.rows());
    }
    if !contents.closures.is_empty() {
        page.heading("Loops");
        page.table(tables.loops.rows());
    }
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

/// Symbol of a named contact; `None` for a contact without a symbol.
fn symbol(element: &DrawnElement) -> Option<DrawnSymbol> {
    let kind = match element.kind {
        ContactKind::Spring => SymbolKind::Spring,
        ContactKind::Damper => SymbolKind::Damper,
        ContactKind::Stop => SymbolKind::Stop,
        ContactKind::Patch => SymbolKind::Ground,
        ContactKind::Other => return None,
    };
    // The face of a stop is one gap away from its pad, wherever the seat of its line is.
    let [point, seat] = element.ends;
    let face = element.gap.map(|gap| std::array::from_fn(|k| point[k] + gap * element.normal[k]));
    let end = if kind == SymbolKind::Stop { face.unwrap_or(seat) } else { seat };
    Some(DrawnSymbol { kind, ends: [point, end], normal: element.normal })
}

/// Drawing of the mechanism; with a contact, also the normal and the velocities of the centres of mass.
pub(super) fn drawing(report: Option<&MassReport>, mechanism: &DrawnMechanism) -> Drawing {
    let links = &mechanism.links;
    let contact = report.map(|report| &report.contact);
    let lines = links.iter().flat_map(|link| {
        link.lines
            .iter()
            .map(|ends| DrawnLine { ends: *ends, intensity: report.map(|_| link.share.unwrap_or(0.0)) })
    });
    let facets = links.iter().flat_map(|link| {
        link.facets.iter().map(|corners| DrawnFacet { corners: *corners, intensity: report.and(link.share) })
    });
    let moving = links.iter().filter_map(|link| {
        Some(DrawnArrow { from: link.com?, vector: link.velocity?, label: String::new() })
    });
    let circles = mechanism.wheels.iter().map(|wheel| DrawnCircle {
        centre: wheel.centre,
        axis: wheel.axis,
        radius: wheel.radius.unwrap_or_default(),
    });
    let normal = contact.map(|contact| DrawnArrow {
        from: contact.point_world,
        vector: contact.normal_world,
        label: "n".into(),
    });
    let mark = contact.map(|contact| SkinMark { at: contact.point_world, label: String::new() });
    let points = mechanism.points.iter().map(|point| SkinMark { at: point.at, label: point.name.clone() });
    let elements = mechanism.elements.iter().map(|element| SkinMark {
        at: element.ends[0],
        label: match element.kind {
            ContactKind::Other => element.name.clone(),
            kind => format!("{} ({})", element.name, kind.name()),
        },
    });
    Drawing {
        shading: report.map_or("", |_| "contribution to the effective mass").into(),
        circles: circles.collect(),
        facets: facets.collect(),
        lines: lines.collect(),
        arrows: moving.chain(normal).collect(),
        symbols: mechanism.elements.iter().filter_map(symbol).collect(),
        marks: mark.into_iter().collect(),
        points: points.chain(elements).take(limits::NAMED_POINTS).collect(),
        has_top_view: true,
        ..Drawing::default()
    }
}
