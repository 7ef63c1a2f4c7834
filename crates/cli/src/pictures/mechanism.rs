//! Drawing of the mechanism.

use crate::terminal::limits;
use percuss_mechanism::ContactKind;
use percuss_render::{
    Drawing, DrawnArrow, DrawnCircle, DrawnFacet, DrawnLine, DrawnSymbol, SkinMark, SymbolKind,
};
use percuss_study::{DrawnElement, DrawnMechanism, MassReport};

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
pub fn drawing(report: Option<&MassReport>, mechanism: &DrawnMechanism) -> Drawing {
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
