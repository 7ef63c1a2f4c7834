//! Drawing of the mechanism.

use crate::terminal::limits;
use crate::terminal::number::fixed;
use percuss_mechanism::ContactKind;
use percuss_render::{
    Drawing, DrawnArrow, DrawnCircle, DrawnFacet, DrawnLine, DrawnName, DrawnSymbol, SkinMark, SymbolKind,
    Views,
};
use percuss_study::{DrawnElement, DrawnLink, DrawnMechanism, MassReport};

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

/// Width of a tyre relative to the radius of its wheel: sheets do not give it.
const TYRE_WIDTH: f64 = 0.6;
/// Smallest share of m̄ of a link with a name in a drawing, and in the drawing of the first page.
const NAMED_SHARE: f64 = 3e-3;
const NAMED_SHARE_BESIDE_TEXT: f64 = 1e-2;

/// Drawing of the mechanism in three views; with a contact, also the normal and the velocities of the centres of mass.
pub fn drawing(report: Option<&MassReport>, mechanism: &DrawnMechanism) -> Drawing {
    let contact = report.map(|report| &report.contact);
    let largest = largest_share(mechanism);
    // Shares are drawn relative to the largest.
    let scale = |share: Option<f64>| report.map(|_| share.unwrap_or(0.0) / largest);
    let links = &mechanism.links;
    let lines = links.iter().flat_map(|link| {
        link.lines.iter().map(|ends| DrawnLine { ends: *ends, intensity: scale(link.share) })
    });
    let facets = links.iter().flat_map(|link| {
        link.facets.iter().map(|corners| DrawnFacet { corners: *corners, intensity: scale(link.share) })
    });
    let moving = links.iter().filter_map(|link| {
        Some(DrawnArrow { from: link.com?, vector: link.velocity?, label: String::new() })
    });
    let circles = mechanism.wheels.iter().map(|wheel| {
        let radius = wheel.radius.unwrap_or_default();
        let share = wheel_link(wheel.centre, mechanism).and_then(|link| link.share);
        DrawnCircle {
            centre: wheel.centre,
            axis: wheel.axis,
            radius,
            width: TYRE_WIDTH * radius,
            intensity: scale(share),
        }
    });
    let normal = contact.map(|contact| DrawnArrow {
        from: contact.point_world,
        vector: contact.normal_world,
        label: "n".into(),
    });
    let mark = contact.map(|contact| SkinMark { at: contact.point_world, label: String::new() });
    let points = mechanism.points.iter().map(|point| SkinMark { at: point.at, label: point.name.clone() });
    Drawing {
        content: "The mechanism".into(),
        shading: report.map(|_| ("share of m̄".to_owned(), 100.0 * largest)),
        circles: circles.collect(),
        facets: facets.collect(),
        lines: lines.collect(),
        arrows: moving.chain(normal).collect(),
        symbols: mechanism.elements.iter().filter_map(symbol).collect(),
        marks: mark.into_iter().collect(),
        points: points.collect(),
        names: names(report, mechanism, NAMED_SHARE),
        views: Views::Three,
        ..Drawing::default()
    }
}

/// Drawing in the plane that shows most, without the velocities, for a place beside text.
pub fn best_view(report: &MassReport, mechanism: &DrawnMechanism) -> Drawing {
    let all = drawing(Some(report), mechanism);
    Drawing {
        arrows: all.arrows.into_iter().filter(|arrow| !arrow.label.is_empty()).collect(),
        names: names(Some(report), mechanism, NAMED_SHARE_BESIDE_TEXT),
        views: Views::Best,
        ..all
    }
}

/// Largest share of m̄ of a link; above zero.
fn largest_share(mechanism: &DrawnMechanism) -> f64 {
    mechanism.links.iter().filter_map(|link| link.share).fold(f64::MIN_POSITIVE, f64::max)
}

/// Link of a wheel by the name that the importer gives it: the nearest one.
fn wheel_link(centre: [f64; 3], mechanism: &DrawnMechanism) -> Option<&DrawnLink> {
    let distance = |link: &DrawnLink| -> Option<f64> {
        Some(link.com?.iter().zip(centre).map(|(a, b)| (a - b).powi(2)).sum())
    };
    let wheels = mechanism.links.iter().filter(|link| link.name.starts_with("wheel"));
    let nearest = wheels.filter_map(|link| Some((distance(link)?, link)));
    nearest.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, link)| link)
}

/// Names of the contact, of the links with their shares, and of springs, dampers and stops.
fn names(report: Option<&MassReport>, mechanism: &DrawnMechanism, smallest: f64) -> Vec<DrawnName> {
    let largest = largest_share(mechanism);
    let in_words = |name: &str| name.replace('_', " ");
    let middle = |[a, b]: [[f64; 3]; 2]| std::array::from_fn(|k| 0.5 * (a[k] + b[k]));
    let of_link = |link: &DrawnLink| {
        let text = match (report, link.share) {
            (None, _) => in_words(&link.name),
            (Some(_), Some(share)) if share >= smallest => {
                let decimals = usize::from(share < 0.01);
                format!("{} {} %", in_words(&link.name), fixed(100.0 * share, decimals))
            }
            (Some(_), _) => return None,
        };
        let is_of_link = |centre| wheel_link(centre, mechanism).is_some_and(|wheel| wheel.name == link.name);
        let points: Vec<[f64; 3]> = match mechanism.wheels.iter().find(|wheel| is_of_link(wheel.centre)) {
            // Points on the tyre, above and below its centre.
            Some(wheel) => {
                let ([x, y, z], radius) = (wheel.centre, wheel.radius.unwrap_or_default());
                [0.7, -0.7, 0.4, -0.4].map(|part| [x, y, z + part * radius]).to_vec()
            }
            None if link.lines.is_empty() => link.com.into_iter().collect(),
            None => link.lines.iter().map(|line| middle(*line)).collect(),
        };
        let intensity = link.share.filter(|_| report.is_some()).map(|share| share / largest);
        (!points.is_empty()).then_some(DrawnName { text, points, intensity })
    };
    let contact = report.and_then(|report| report.named_contact.as_ref());
    let is_contact = |element: &DrawnElement| contact.is_some_and(|contact| contact.name == element.name);
    let of_element = |element: &DrawnElement| {
        let points = match element.kind {
            ContactKind::Spring | ContactKind::Damper => {
                vec![middle(element.ends), element.ends[0], element.ends[1]]
            }
            ContactKind::Stop => vec![element.ends[0]],
            ContactKind::Patch | ContactKind::Other => return None,
        };
        let name = DrawnName { text: in_words(&element.name), points, intensity: None };
        (!is_contact(element)).then_some(name)
    };
    let of_contact = report.map(|report| DrawnName {
        text: contact.map_or_else(|| "contact".to_owned(), |contact| in_words(&contact.name)),
        points: vec![report.contact.point_world],
        intensity: None,
    });
    let links = mechanism.links.iter().filter_map(of_link);
    let elements = mechanism.elements.iter().filter_map(of_element);
    of_contact.into_iter().chain(links).chain(elements).take(limits::NAMED_PARTS).collect()
}
