//! Loop closures as joints.

use super::bodies::{Bodies, Form, pose_text};
use super::error::SdfError;
use crate::mjcf::write::closures::{DRAWING_TOLERANCE, drawing_error};
use crate::writing::changes::Change;
use crate::writing::structure::loop_frame;
use crate::writing::xml_text::{append, escape_attribute, format_vector};
use percuss_mechanism::{Closure, ClosureKind, JointKind, LoopFrame};
use percuss_spatial::{Transform, Vector3};

/// Writes all closures. SDFormat defines the frame of a joint in its child; the frame in the parent follows from the poses as drawn.
///
/// # Errors
/// [`SdfError`] for kinds without a joint in SDFormat, and for closures that are open as drawn.
pub(super) fn write_closures(bodies: &mut Bodies<'_>) -> Result<String, SdfError> {
    let mechanism = bodies.mechanism;
    let mut out = String::new();
    let floats = mechanism.joints().iter().any(|joint| joint.kind() == JointKind::Floating);
    for closure in mechanism.closures() {
        let refusal = |reason: String| SdfError::new("loop", closure.name(), reason);
        let kind = match closure.kind() {
            ClosureKind::Fixed => "fixed",
            ClosureKind::Revolute => "revolute",
            ClosureKind::Prismatic => "prismatic",
            ClosureKind::Spherical => "ball",
            ClosureKind::Universal => "universal",
            ClosureKind::Cylindrical | ClosureKind::Planar | ClosureKind::Distance => {
                return Err(refusal(format!(
                    "SDFormat has no {} joint; use fixed, revolute, prismatic, spherical or universal loops",
                    closure.kind().name()
                )));
            }
        };
        let frame = |end| loop_frame(&bodies.world_poses, end);
        let (x_wp, x_ws) = (frame(closure.predecessor()), frame(closure.successor()));
        let drawn = x_wp.inverse() * x_ws;
        let error = drawing_error(closure, &drawn, mechanism.characteristic_length());
        if error > DRAWING_TOLERANCE {
            return Err(refusal(format!(
                "the loop is open by {error:.1e} with all joints at 0 (rad, or relative to the size of the mechanism), and SDFormat \
                 closes loops as drawn; correct the drawing"
            )));
        }
        let name = escape_attribute(&bodies.joint_name(closure.name()));
        append!(out, "    <joint name=\"{name}\" type=\"{kind}\">\n");
        if floats {
            bodies.changes.push(Change::changed(
                "loop",
                closure.name(),
                "a joint, which closes no loop if it is the first joint to a floating link",
                "SDFormat has no floating joints: a link floats if it has no joint",
            ));
        }
        append_ends(bodies, closure, &drawn, &mut out);
        // Readers that build a tree open the loop at this joint, as the mechanism does.
        out.push_str(
            "      <physics><simbody><must_be_loop_joint>true</must_be_loop_joint></simbody></physics>\n",
        );
        out.push_str("    </joint>\n");
    }
    Ok(out)
}

/// Appends pose, ends and axes. The child is the successor, or the predecessor if the successor is the world. `drawn`: loop frame of the
/// successor in that of the predecessor.
fn append_ends(bodies: &Bodies<'_>, closure: &Closure, drawn: &Transform<f64>, out: &mut String) {
    let is_world = |end: &LoopFrame| end.link.is_none_or(|link| bodies.forms[link.index()] == Form::World);
    let is_swapped = is_world(closure.successor());
    let (parent, child) = if is_swapped {
        (closure.successor(), closure.predecessor())
    } else {
        (closure.predecessor(), closure.successor())
    };
    append!(out, "      <pose>{}</pose>\n", pose_text(&child.frame));
    for (tag, end) in [("parent", parent), ("child", child)] {
        let name = end.link.map_or("world", |link| bodies.name(link));
        append!(out, "      <{tag}>{}</{tag}>\n", escape_attribute(name));
    }
    // Axes in the loop frame of the child; the first axis of a universal joint is that of the parent.
    let axes: Vec<Vector3<f64>> = match closure.kind() {
        ClosureKind::Universal if is_swapped => vec![drawn.vector(closure.axis2()), *closure.axis()],
        ClosureKind::Universal => vec![drawn.inverse_vector(closure.axis()), *closure.axis2()],
        kind if kind.has_axis() => vec![*closure.axis()],
        _ => Vec::new(),
    };
    for (tag, axis) in ["axis", "axis2"].iter().zip(axes) {
        append!(out, "      <{tag}><xyz>{}</xyz></{tag}>\n", format_vector(&axis.map(|x| x + 0.0)));
    }
}
