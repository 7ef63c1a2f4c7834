//! Values in the texts of elements.

use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::limits::UNLIMITED;
use crate::reading::report::quoted;
use crate::urdf::elements::numbers::parse_numbers;
use crate::urdf::elements::origin::{degrees_in_place_of_radians, large_angle_message};
use crate::urdf::elements::sdf_values;
use percuss_spatial::Transform;

/// N finite numbers in the text of an element; `None`, with an error, if invalid.
pub(crate) fn read_numbers<const N: usize>(
    element: ElementId,
    findings: &mut Findings<'_>,
) -> Option<[f64; N]> {
    let text = findings.tree.text(element);
    match parse_numbers::<N>(text) {
        Ok(values) => Some(values),
        Err(defect) => {
            findings.error("bad-number", element, || format!("{}: {defect}", quoted(text)));
            None
        }
    }
}

/// Finite number in a child element; `None` if absent, or, with an error, if invalid.
pub(crate) fn read_number_in(parent: ElementId, tag: &str, findings: &mut Findings<'_>) -> Option<f64> {
    let element = findings.tree.child(parent, tag)?;
    read_numbers::<1>(element, findings).map(|[value]| value)
}

/// Position limit in a child element; `None` if absent or without effect (infinite, or at least 1e16).
pub(crate) fn read_limit_in(parent: ElementId, tag: &str, findings: &mut Findings<'_>) -> Option<f64> {
    let element = findings.tree.child(parent, tag)?;
    match findings.tree.text(element).to_ascii_lowercase().as_str() {
        "inf" | "+inf" | "-inf" | "infinity" | "-infinity" => None,
        _ => {
            let [value] = read_numbers::<1>(element, findings)?;
            Some(value).filter(|value| value.abs() < UNLIMITED)
        }
    }
}

/// Boolean in a child element; false if absent, or, with an error, if invalid.
pub(crate) fn read_boolean_in(parent: ElementId, tag: &str, findings: &mut Findings<'_>) -> bool {
    let Some(element) = findings.tree.child(parent, tag) else { return false };
    boolean(findings.tree.text(element), element, findings)
}

/// Boolean in an attribute; false if absent, or, with an error, if invalid.
pub(crate) fn read_boolean_attribute(element: ElementId, name: &str, findings: &mut Findings<'_>) -> bool {
    findings.tree.attribute(element, name).is_some_and(|text| boolean(text, element, findings))
}

/// Truth value of a text; false, with an error, if invalid.
fn boolean(text: &str, element: ElementId, findings: &mut Findings<'_>) -> bool {
    let value = sdf_values::parse_boolean(text);
    if value.is_none() {
        findings.error("bad-keyword", element, || format!("{} is neither true nor false", quoted(text)));
    }
    value.unwrap_or(false)
}

/// Pose in the text of an element; the identity, with an error, if invalid.
pub(crate) fn read_pose(pose: ElementId, findings: &mut Findings<'_>) -> Transform<f64> {
    let format = findings.tree.attribute(pose, "rotation_format").unwrap_or("euler_rpy");
    let degrees = read_boolean_attribute(pose, "degrees", findings);
    let angles =
        parse_numbers::<6>(findings.tree.text(pose)).ok().filter(|_| !degrees && format == "euler_rpy");
    if let Some(angle) = angles.and_then(|numbers| degrees_in_place_of_radians(&numbers[3..])) {
        findings.warning("large-angle", pose, || large_angle_message(angle) + ", or degrees=\"true\"");
    }
    sdf_values::parse_pose(findings.tree.text(pose), format, degrees).unwrap_or_else(|defect| {
        findings.error("bad-pose", pose, || defect);
        Transform::identity()
    })
}

/// Pose in the child `<pose>`; the identity if absent, or, with an error, if invalid.
pub(crate) fn read_pose_in(parent: ElementId, findings: &mut Findings<'_>) -> Transform<f64> {
    findings.tree.child(parent, "pose").map_or_else(Transform::identity, |pose| read_pose(pose, findings))
}

/// Name in the text of a child element; empty if absent.
pub(crate) fn text_in<'t>(tree: &'t ElementTree, parent: ElementId, tag: &str) -> &'t str {
    tree.child(parent, tag).map(|element| tree.text(element)).unwrap_or_default()
}
