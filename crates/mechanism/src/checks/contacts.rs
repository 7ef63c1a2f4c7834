//! Validation of named contacts.

use crate::axis::unit;
use crate::checks::check::Check;
use crate::elements::contact::{ContactDescription, ContactNormal, NamedContact};
use crate::limits;
use crate::problem::{Problem, Subject};
use crate::{LinkDescription, Mechanism};
use std::collections::HashMap;

/// Subject of a finding about contact number `index`.
fn contact_subject(index: usize, name: &str) -> Subject {
    Subject::Contact { index, name: name.to_owned() }
}

/// Checks names and numbers of contacts; needs no tree.
pub(crate) fn check(
    contacts: &[ContactDescription],
    links: &[LinkDescription],
    ids: &HashMap<String, usize>,
    check: &mut Check,
) {
    check.unique(contacts.iter().map(|c| &c.name), contact_subject);
    for (i, contact) in contacts.iter().enumerate() {
        let subject = contact_subject(i, &contact.name);
        for (role, link, is_ground) in
            [("contact", &contact.link, false), ("other", &contact.against, contact.against == "world")]
        {
            if !ids.contains_key(link) && !is_ground {
                let near = check.near(link, links.iter().map(|l| l.name.as_str()));
                check.add(subject.clone(), Problem::UnknownLink { role, link: link.clone(), near });
            }
        }
        if contact.link == contact.against {
            check.add(subject.clone(), Problem::ClosesOnItself { link: contact.link.clone() });
        }
        check.is_valid(&subject, "contact point", &contact.point);
        check.is_valid(&subject, "gap", &contact.gap);
        match &contact.normal {
            ContactNormal::Fixed(normal) => {
                if check.is_valid(&subject, "normal", normal) && normal.amax() < limits::SHORTEST_AXIS {
                    check.add(subject, Problem::ZeroAxis);
                }
            }
            ContactNormal::Toward(point) | ContactNormal::Away(point) => {
                check.is_valid(&subject, "point of the line", point);
            }
        }
    }
}

/// Adds the checked contacts to the mechanism.
pub(crate) fn attach(mechanism: &mut Mechanism, contacts: &[ContactDescription]) {
    let found = contacts.iter().filter_map(|contact| {
        let against = mechanism.link_named(&contact.against);
        Some(NamedContact {
            name: contact.name.clone(),
            kind: contact.kind,
            link: mechanism.find_link(&contact.link).ok()?,
            point: contact.point,
            against,
            normal: match contact.normal {
                ContactNormal::Fixed(normal) => ContactNormal::Fixed(unit(&normal)),
                line @ (ContactNormal::Toward(_) | ContactNormal::Away(_)) => line,
            },
            gap: contact.gap,
        })
    });
    mechanism.contacts = found.collect();
}
