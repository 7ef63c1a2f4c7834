//! Parser of `<contact>` in the robot: a named contact between two links.
//!
//! ```xml
//! <contact name="bump_stop" type="stop">
//!   <body link="lower_arm" xyz="0 0.1 0.05"/>
//!   <other link="chassis"/>
//!   <normal xyz="0 0 1"/>       <!-- in the frame of the other link; or <toward xyz="…"/> a point of the other link, the
//!                                    normal of a spring or damper, or <away xyz="…"/>, for a stop of the extension -->
//!   <gap value="0.05"/>         <!-- with all joints at 0; without: the parts always touch -->
//! </contact>
//! ```

use crate::reading::findings::did_you_mean;
use crate::reading::report::{Place, Report, quoted};
use crate::reading::xml::Node;
use crate::urdf::elements::joints::joint::read_link_name;
use crate::urdf::elements::link::read_name;
use crate::urdf::elements::numbers::{optional_numbers, required_number, required_numbers};
use crate::urdf::elements::survey::child;
use percuss_mechanism::{ContactDescription, ContactKind, ContactNormal, near_names};
use percuss_spatial::Vector3;

/// Reads a `<contact>` of the robot. Each number of the result is finite; defects are reported.
pub(crate) fn read_contact(node: Node<'_>, report: &mut Report) -> ContactDescription {
    let name = read_name(node, report);
    let [link, against] = ["body", "other"].map(|tag| read_link_name(node, tag, report));
    let point = child(node, "body").map_or([0.0; 3], |body| optional_numbers(body, "xyz", [0.0; 3], report));
    ContactDescription {
        name: name.to_owned(),
        kind: read_kind(node, report),
        link: link.to_owned(),
        point: point.into(),
        against: against.to_owned(),
        normal: read_normal(node, report),
        gap: child(node, "gap").and_then(|gap| required_number(gap, "value", report)),
    }
}

/// Reads the kind; [`ContactKind::Other`] without the attribute or after an error.
fn read_kind(node: Node<'_>, report: &mut Report) -> ContactKind {
    let Some(text) = node.attribute("type") else { return ContactKind::Other };
    let names = ContactKind::ALL.map(ContactKind::name);
    if let Some(kind) = ContactKind::ALL.into_iter().find(|kind| kind.name() == text) {
        return kind;
    }
    report.error("unknown-contact-type", Place::Attribute(node, "type"), || {
        let guess = did_you_mean(&near_names(text, names));
        format!("the contact type {} is unknown{guess}; it is one of {}", quoted(text), names.join(", "))
    });
    ContactKind::Other
}

/// Reads `<normal>`, `<toward>` or `<away>`; exactly one of the three is expected.
fn read_normal(node: Node<'_>, report: &mut Report) -> ContactNormal {
    let default = ContactNormal::Fixed(Vector3::z());
    let mut given = ["normal", "toward", "away"].into_iter().filter_map(|tag| Some((tag, child(node, tag)?)));
    let Some((tag, element)) = given.next() else {
        report.error("missing-element", Place::Element(node), || {
            "<contact> has no <normal>; it needs <normal xyz=\"...\"/>, out of the body into the other side and in the frame \
             of the other link, or <toward xyz=\"...\"/> or <away xyz=\"...\"/>, a point of the other link"
                .to_owned()
        });
        return default;
    };
    if let Some((second, element)) = given.next() {
        report.error("two-normals", Place::Element(element), || {
            format!("<contact> has both <{tag}> and <{second}>; remove one")
        });
        return default;
    }
    let xyz = required_numbers(element, "xyz", [0.0, 0.0, 1.0], report).into();
    match tag {
        "normal" => ContactNormal::Fixed(xyz),
        "toward" => ContactNormal::Toward(xyz),
        _ => ContactNormal::Away(xyz),
    }
}
