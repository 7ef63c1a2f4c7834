//! Parser of `<loop>` and `<loop_joint>` (joints outside the tree) and of `<coupling>` (a ratio between rates).

use crate::reading::findings::did_you_mean;
use crate::reading::limits::MIN_AXIS_COMPONENT;
use crate::reading::report::{Place, Report, quoted};
use crate::reading::xml::Node;
use crate::urdf::elements::joints::joint::read_link_name;
use crate::urdf::elements::link::read_name;
use crate::urdf::elements::numbers::{required_number, required_numbers};
use crate::urdf::elements::origin;
use crate::urdf::elements::survey::{child, is_gazebo_joint, is_named};
use percuss_mechanism::{ClosureDescription, ClosureKind, CouplingDescription, Problem, near_names};
use percuss_spatial::{Transform, Vector3};

/// Default axis, and default second axis (the successor's pin of a universal joint).
const DEFAULT_AXIS: [f64; 3] = [1.0, 0.0, 0.0];
const DEFAULT_AXIS2: [f64; 3] = [0.0, 1.0, 0.0];

/// True for `<loop>` and `<loop_joint>`.
pub(crate) fn is_loop_element(node: Node<'_>) -> bool {
    is_named(node, "loop") || is_named(node, "loop_joint")
}

/// Tags of the elements that name the two links: predecessor first, successor second.
pub(crate) fn link_tags(node: Node<'_>) -> &'static [&'static str; 2] {
    if is_gazebo_joint(node) {
        &["parent", "child"]
    } else if is_named(node, "loop_joint") {
        &["link1", "link2"]
    } else {
        &["predecessor", "successor"]
    }
}

/// Description of a `<loop>` or `<loop_joint>`, with finite numbers.
pub(crate) fn read_loop(node: Node<'_>, report: &mut Report) -> ClosureDescription {
    let name = read_name(node, report);
    let kind = read_loop_type(node, report);
    let [predecessor, successor] = link_tags(node).map(|tag| read_link_name(node, tag, report));
    let [predecessor_frame, successor_frame] = link_tags(node).map(|tag| read_loop_frame(node, tag, report));
    if let Some(kind) = kind {
        report_unused_elements(node, kind, report);
    }
    let universal = kind == Some(ClosureKind::Universal);
    ClosureDescription {
        name: name.to_owned(),
        kind: kind.unwrap_or(ClosureKind::Fixed),
        predecessor: predecessor.to_owned(),
        predecessor_frame,
        successor: successor.to_owned(),
        successor_frame,
        axis: read_axis(node, "axis", DEFAULT_AXIS, kind.filter(|k| k.has_axis()), report),
        axis2: read_axis(node, "axis2", DEFAULT_AXIS2, kind.filter(|_| universal), report),
        distance: read_distance(node, kind, report),
    }
}

/// Description of a `<coupling>`.
pub(crate) fn read_coupling(node: Node<'_>, report: &mut Report) -> CouplingDescription {
    let name = read_name(node, report);
    // "rolling" is the only type in use.
    if let Some(other) = node.attribute("type").filter(|t| *t != "rolling") {
        report.warning("unknown-coupling-type", Place::Attribute(node, "type"), || {
            format!("the coupling type {} is unknown; it is read as a ratio between rates", quoted(other))
        });
    }
    let [predecessor, successor] = link_tags(node).map(|tag| read_link_name(node, tag, report).to_owned());
    let ratio = match child(node, "ratio") {
        Some(ratio) => required_number(ratio, "value", report),
        None => {
            report.error("missing-element", Place::Element(node), || {
                "<coupling> has no <ratio>; it needs <ratio value=\"...\"/>, the successor's rate over the \
                 predecessor's"
                    .to_owned()
            });
            None
        }
    };
    CouplingDescription { name: name.to_owned(), predecessor, successor, ratio: ratio.unwrap_or(1.0) }
}

/// Kind of closure from the attribute `type`; `None` if invalid.
fn read_loop_type(node: Node<'_>, report: &mut Report) -> Option<ClosureKind> {
    // URDF has two names for a hinge joint: "revolute" and "continuous".
    let names = || ClosureKind::ALL.map(ClosureKind::name).into_iter().chain(["continuous"]);
    let listed = || names().collect::<Vec<_>>().join(", ");
    let Some(text) = node.attribute("type") else {
        report.error("missing-attribute", Place::Element(node), || {
            let tag = node.tag_name().name();
            format!("<{tag}> has no attribute \"type\"; it is one of {}", listed())
        });
        return None;
    };
    let word = if text == "continuous" { ClosureKind::Revolute.name() } else { text };
    let kind = ClosureKind::ALL.into_iter().find(|k| k.name() == word);
    let place = Place::Attribute(node, "type");
    if word == "floating" {
        report.error("loop-of-nothing", place, || {
            format!(
                "a floating joint holds nothing, so that it closes no loop; the type is one of {}",
                listed()
            )
        });
    } else if kind.is_none() {
        report.error("unknown-loop-type", place, || {
            let guess = did_you_mean(&near_names(text, names()));
            format!("the loop type {} is unknown{guess}; it is one of {}", quoted(text), listed())
        });
    }
    kind
}

/// Loop frame in the link: `<origin>` of `<predecessor>` or `<successor>`; attributes of `<link1>` or `<link2>`.
fn read_loop_frame(node: Node<'_>, tag: &'static str, report: &mut Report) -> Transform<f64> {
    match child(node, tag) {
        Some(end) if is_named(node, "loop_joint") => origin::read_origin_attributes(end, report).transform,
        Some(end) => origin::read_origin(end, report).transform,
        None => Transform::identity(),
    }
}

/// Axis in the loop frame. `kind` is `Some` if the loop needs this axis; then a zero axis is an error.
fn read_axis(
    node: Node<'_>,
    tag: &'static str,
    default: [f64; 3],
    kind: Option<ClosureKind>,
    report: &mut Report,
) -> Vector3<f64> {
    let axis = match child(node, tag) {
        Some(axis) => required_numbers(axis, "xyz", default, report),
        None => {
            if let Some(kind) = kind {
                report.note("default-axis", Place::Element(node), || {
                    let [x, y, z] = default;
                    format!("the {} loop has no <{tag}>: {x} {y} {z} is taken", kind.name())
                });
            }
            default
        }
    };
    let axis = Vector3::from(axis);
    // The builder does not distinguish `<axis>` from `<axis2>`; the check here names the element.
    if let Some(element) = child(node, tag).filter(|_| kind.is_some() && axis.amax() < MIN_AXIS_COMPONENT) {
        let problem = Problem::ZeroAxis;
        report.add_problem(Place::Element(element), &problem);
    }
    axis
}

/// Distance, m; `None` without the element.
fn read_distance(node: Node<'_>, kind: Option<ClosureKind>, report: &mut Report) -> Option<f64> {
    let element = child(node, "distance");
    if element.is_none() && kind == Some(ClosureKind::Distance) {
        report.note("default-distance", Place::Element(node), || {
            "the loop has no <distance>: it keeps the distance its points have with all joints at 0"
                .to_owned()
        });
    }
    required_number(element?, "value", report)
}

/// Reports elements that the kind of loop does not use. A superfluous axis is common (a note); a superfluous second
/// axis or distance is a likely mistake (a warning).
fn report_unused_elements(node: Node<'_>, kind: ClosureKind, report: &mut Report) {
    let message = |tag: &str| format!("a {} loop has no <{tag}>; ignored", kind.name());
    if let Some(axis) = child(node, "axis").filter(|_| !kind.has_axis()) {
        report.note("unused-element", Place::Element(axis), || message("axis"));
    }
    if let Some(axis2) = child(node, "axis2").filter(|_| kind != ClosureKind::Universal) {
        report.warning("unused-element", Place::Element(axis2), || message("axis2"));
    }
    if let Some(distance) = child(node, "distance").filter(|_| kind != ClosureKind::Distance) {
        report.warning("unused-element", Place::Element(distance), || message("distance"));
    }
}
