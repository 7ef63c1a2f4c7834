//! Versions of the format.

use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::report::quoted;

/// Version 1.N of a file, as N.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Version(pub u32);

impl Version {
    /// First and last version that is read.
    pub const FIRST: Version = Version(4);
    pub const LAST: Version = Version(12);
    /// First version with `relative_to` and frames as ends of joints.
    pub const WITH_FRAMES: Version = Version(7);

    /// Version of the file that contains an element: attribute of the nearest `<sdf>`. The last version if the attribute is invalid,
    /// which [`check_version`] reports.
    pub fn of_element(tree: &ElementTree, element: ElementId) -> Version {
        let mut current = Some(element);
        while let Some(id) = current {
            if tree.tag(id) == "sdf" {
                return tree.attribute(id, "version").and_then(parse).unwrap_or(Version::LAST);
            }
            current = tree.element(id).parent;
        }
        Version::LAST
    }
}

/// Reports an absent or unknown version of an `<sdf>`.
pub(crate) fn check_version(sdf: ElementId, findings: &mut Findings<'_>) {
    let (first, last) = (Version::FIRST.0, Version::LAST.0);
    let Some(text) = findings.tree.attribute(sdf, "version") else {
        findings.error("missing-attribute", sdf, || {
            format!("<sdf> has no attribute \"version\" (1.{first} to 1.{last}), on which the meaning of poses and axes depends")
        });
        return;
    };
    match parse(text) {
        Some(version) if version < Version::FIRST => {
            findings.attribute_error("unknown-version", sdf, "version", || {
                format!(
                    "version {} is older than 1.{first}; convert the file with \"gz sdf -p FILE\" and load the result",
                    quoted(text)
                )
            });
        }
        Some(version) if version > Version::LAST => {
            findings.warning("unknown-version", sdf, || {
                format!("version {} is newer than 1.{last}; it is read as 1.{last}", quoted(text))
            });
        }
        Some(_) => {}
        None => findings.attribute_error("unknown-version", sdf, "version", || {
            format!("version {}: 1.{first} to 1.{last} is expected", quoted(text))
        }),
    }
}

/// N of `1.N` or `1.N.M`.
fn parse(text: &str) -> Option<Version> {
    let mut parts = text.trim_ascii().split('.');
    let is_first = parts.next() == Some("1");
    let minor = parts.next().and_then(|minor| minor.parse().ok());
    let rest_is_number = parts.all(|part| part.parse::<u32>().is_ok());
    minor.filter(|_| is_first && rest_is_number).map(Version)
}
