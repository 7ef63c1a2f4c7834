//! Contacts that a sheet names itself, each in a section `contact.NAME`.

use crate::corner::design::OwnContact;
use crate::findings::{Findings, Spot};
use crate::options::Side;
use crate::sheet::entries::{Entries, Quantity};
use crate::units::Frame;
use percuss_formats::reading::quoted;

/// First part of the name of a section.
pub(in crate::sheet) const CONTACT: &str = "contact";
/// Name of all contacts in a question.
const ALL: &str = "all";
/// Keys of a section.
const KEYS: [&str; 5] = ["point", "on", "direction", "against", "gap"];

/// Keys of all contacts in the sheet.
pub(in crate::sheet) fn contact_keys(entries: &Entries) -> Vec<String> {
    let sections = entries.sections_of(CONTACT).into_iter();
    sections.flat_map(|(name, _)| KEYS.map(|key| format!("{CONTACT}.{name}.{key}"))).collect()
}

/// Reads the contacts, mirrored to the left side.
pub(in crate::sheet) fn read_contacts(
    entries: &mut Entries,
    findings: &mut Findings,
    frame: Frame,
    points_side: Side,
) -> Vec<OwnContact> {
    let mut contacts = Vec::new();
    for (name, spot) in entries.sections_of(CONTACT) {
        if name == ALL || name.contains(',') {
            let message =
                format!("{} names several contacts in a question: choose another name", quoted(&name));
            findings.error("reserved-name", &spot, message);
        }
        let [point_key, on_key, direction_key, against_key, gap_key] =
            KEYS.map(|key| format!("{CONTACT}.{name}.{key}"));
        let point = entries.point(findings, &point_key, frame);
        let on = entries.text(findings, &on_key, "the name of a link");
        let direction = entries.direction(findings, &direction_key, frame, points_side);
        let against = entries.text(findings, &against_key, "the name of a link");
        let gap = entries.numbers(findings, &gap_key, Quantity::Length(frame.unit), &[1]);
        for (key, is_given, expected) in [
            (&point_key, point.is_some(), "the point of the contact, [x, y, z],"),
            (&on_key, on.is_some(), "the link that the point is on"),
            (&direction_key, direction.is_some(), "[x, y, z], in which the point moves toward the obstacle,"),
        ] {
            if !is_given && !entries.has(key) {
                entries.missing(findings, key, expected);
            }
        }
        let (Some((mut at, _)), Some((link, on)), Some((direction, _))) = (point, on, direction) else {
            continue;
        };
        if points_side == Side::Right {
            at.y = 0.0 - at.y;
        }
        let spot = Spot { path: Some(format!("{CONTACT}.{name}")), ..spot };
        let gap = gap.map(|(values, _)| values[0]);
        contacts.push(OwnContact { name, link: (link, on), at, direction, against, gap, spot });
    }
    contacts
}
