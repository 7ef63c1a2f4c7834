//! Loop closures as equality constraints.

use super::body_tree::{BodyTree, inertial_element, pose_attributes};
use super::error::MjcfError;
use crate::writing::changes::Change;
use crate::writing::structure::loop_frame;
use crate::writing::xml_text::{append, escape_attribute, format_number, format_vector};
use percuss_mechanism::{Closure, ClosureKind, LinkId, LoopFrame, Mechanism};
use percuss_spatial::{Transform, Vector3, plane_basis};

/// Largest error as drawn of a closure that is written as joints to a second half: rotation, rad, and translation relative to the size of
/// the mechanism.
pub(crate) const DRAWING_TOLERANCE: f64 = 1e-9;

/// Writes all closures; adds sites and second halves of links to the bodies.
pub(super) fn write_closures(tree: &mut BodyTree<'_>) -> Result<(), MjcfError> {
    let mechanism = tree.mechanism;
    // Links are split first, since every half takes a part of the inertia.
    let mut halves = vec![0usize; mechanism.links().len()];
    for closure in mechanism.closures().iter().filter(|closure| needs_half(closure.kind())) {
        halves[split_end(mechanism, closure)?.0.index()] += 1;
    }
    for (share, count) in tree.share.iter_mut().zip(&halves) {
        *share = 1.0 / (1 + count) as f64;
    }
    for closure in mechanism.closures() {
        let name = escape_attribute(closure.name());
        if !needs_half(closure.kind()) {
            report_open_drawing(tree, closure);
        }
        match closure.kind() {
            ClosureKind::Fixed => {
                add_sites(tree, closure, &name, &Vector3::zeros());
                append!(
                    tree.equalities,
                    "    <weld name=\"{name}\" site1=\"{name}/1\" site2=\"{name}/2\"/>\n"
                );
            }
            ClosureKind::Spherical => add_connect(tree, closure, &name, &Vector3::zeros()),
            ClosureKind::Revolute => {
                add_connect(tree, closure, &name, &Vector3::zeros());
                let along = closure.axis() * mechanism.characteristic_length();
                add_connect(tree, closure, &format!("{name}/axis"), &along);
                tree.changes.push(Change::changed(
                    "loop",
                    closure.name(),
                    "connects of two points of its axis",
                    "MJCF has no revolute constraint",
                ));
            }
            ClosureKind::Distance => {
                add_rod(tree, closure, &name);
                tree.changes.push(Change::changed(
                    "loop",
                    closure.name(),
                    "a tendon of constant length",
                    "MJCF has no distance constraint",
                ));
            }
            ClosureKind::Prismatic
            | ClosureKind::Cylindrical
            | ClosureKind::Planar
            | ClosureKind::Universal => {
                add_half(tree, closure, &name)?;
            }
        }
    }
    Ok(())
}

/// True for kinds without an equality constraint in MJCF: one of the two links is split, and its second half has the joints of the
/// closure to the other link.
fn needs_half(kind: ClosureKind) -> bool {
    match kind {
        ClosureKind::Prismatic | ClosureKind::Cylindrical | ClosureKind::Planar | ClosureKind::Universal => {
            true
        }
        ClosureKind::Fixed | ClosureKind::Revolute | ClosureKind::Spherical | ClosureKind::Distance => false,
    }
}

/// Adds the sites `NAME/1` and `NAME/2` of a closure, shifted by `along` in the loop frames.
fn add_sites(tree: &mut BodyTree<'_>, closure: &Closure, name: &str, along: &Vector3<f64>) {
    for (number, LoopFrame { link, frame }) in [(1, closure.predecessor()), (2, closure.successor())] {
        let shifted = *frame * Transform::from_translation(*along);
        let line = format!("<site name=\"{name}/{number}\"{}/>\n", pose_attributes(&shifted));
        tree.append_content(*link, &line);
    }
}

/// Adds a `<connect>` of the points at `along` in the two loop frames, m.
fn add_connect(tree: &mut BodyTree<'_>, closure: &Closure, name: &str, along: &Vector3<f64>) {
    add_sites(tree, closure, name, along);
    append!(tree.equalities, "    <connect name=\"{name}\" site1=\"{name}/1\" site2=\"{name}/2\"/>\n");
}

/// Adds a distance closure as a tendon of constant length between two sites. MuJoCo's constraint is relative to the length as drawn.
fn add_rod(tree: &mut BodyTree<'_>, closure: &Closure, name: &str) {
    add_sites(tree, closure, name, &Vector3::zeros());
    let [first, second] = [closure.predecessor(), closure.successor()]
        .map(|end| loop_frame(&tree.world_poses, end).translation);
    let drawn = (second - first).norm();
    let excess = closure.distance().map_or(0.0, |distance| distance - drawn);
    append!(
        tree.tendons,
        "    <spatial name=\"{name}\">\n      <site site=\"{name}/1\"/>\n      <site site=\"{name}/2\"/>\n    </spatial>\n"
    );
    append!(
        tree.equalities,
        "    <tendon name=\"{name}\" tendon1=\"{name}\" polycoef=\"{} 1 0 0 0\"/>\n",
        format_number(excess)
    );
}

/// Link that is split for a closure, its loop frame, and the other end; true if the link is the successor.
fn split_end<'c>(
    mechanism: &Mechanism,
    closure: &'c Closure,
) -> Result<(LinkId, &'c LoopFrame, &'c LoopFrame, bool), MjcfError> {
    let has_mass = |end: &LoopFrame| {
        end.link.filter(|link| {
            *link != mechanism.root() && mechanism.link(*link).inertial().is_some_and(|i| i.mass > 0.0)
        })
    };
    let (predecessor, successor) = (closure.predecessor(), closure.successor());
    if let Some(link) = has_mass(successor) {
        Ok((link, successor, predecessor, true))
    } else if let Some(link) = has_mass(predecessor) {
        Ok((link, predecessor, successor, false))
    } else {
        Err(MjcfError::new(
            "loop",
            closure.name(),
            format!(
                "a {} loop is written as joints to a second half of one of its links, and neither link has a mass; use spherical, \
                 revolute, fixed or distance loops",
                closure.kind().name()
            ),
        ))
    }
}

/// Joint between the other link of a closure and the second half of the split link.
pub(super) struct HalfJoint {
    suffix: &'static str,
    /// True for a slide, false for a hinge.
    pub slides: bool,
    /// Axis in the loop frame of the half, as drawn.
    pub axis: Vector3<f64>,
}

/// Joints of a second half, in the order of the file. `drawn`: loop frame of the half in that of the other link, as drawn.
fn half_joints(closure: &Closure, drawn: &Transform<f64>, is_successor: bool) -> Vec<HalfJoint> {
    let slide = |suffix, axis| HalfJoint { suffix, slides: true, axis };
    let hinge = |suffix, axis| HalfJoint { suffix, slides: false, axis };
    let axis = *closure.axis();
    let (e1, e2) = plane_basis(&axis);
    let in_half = |axis: &Vector3<f64>| drawn.inverse_vector(axis);
    match closure.kind() {
        ClosureKind::Prismatic => vec![slide("slide", axis)],
        ClosureKind::Cylindrical => vec![slide("slide", axis), hinge("angle", axis)],
        ClosureKind::Planar => vec![slide("x", e1), slide("y", e2), hinge("angle", axis)],
        // The pin of the other link comes first.
        _ if is_successor => vec![hinge("1", in_half(&axis)), hinge("2", *closure.axis2())],
        _ => vec![hinge("1", in_half(closure.axis2())), hinge("2", axis)],
    }
}

/// Second half of a link with its joints, as needed for their positions.
pub(super) struct Half<'c> {
    /// Loop frame of the split link.
    pub own: &'c LoopFrame,
    /// Loop frame of the other link.
    pub base: &'c LoopFrame,
    /// Loop frame of the half in that of the other link, as drawn.
    pub drawn: Transform<f64>,
    pub joints: Vec<HalfJoint>,
}

/// Second half that the writer adds for a closure.
pub(super) fn half_of<'c>(tree: &BodyTree<'_>, closure: &'c Closure) -> Result<Half<'c>, MjcfError> {
    let (_, own, base, is_successor) = split_end(tree.mechanism, closure)?;
    let drawn = loop_frame(&tree.world_poses, base).inverse() * loop_frame(&tree.world_poses, own);
    Ok(Half { own, base, drawn, joints: half_joints(closure, &drawn, is_successor) })
}

/// Second half of a link, jointed to the other link of the closure and welded to the first half.
fn add_half(tree: &mut BodyTree<'_>, closure: &Closure, name: &str) -> Result<(), MjcfError> {
    let mechanism = tree.mechanism;
    let (link, own, base, is_successor) = split_end(mechanism, closure)?;
    let (x_wb, x_wo) = (loop_frame(&tree.world_poses, base), loop_frame(&tree.world_poses, own));
    // The split link's loop frame in the loop frame of the other link, as drawn.
    let drawn = x_wb.inverse() * x_wo;
    check_drawing(mechanism, closure, &drawn, is_successor)?;
    let joints = half_joints(closure, &drawn, is_successor);
    let mut lines = String::new();
    // The frame of the half is the loop frame of the split link.
    let pose = base.frame * drawn;
    append!(lines, "<body name=\"{name}/half\"{}>\n", pose_attributes(&pose));
    for HalfJoint { suffix, slides, axis } in joints {
        let kind = if slides { "slide" } else { "hinge" };
        append!(
            lines,
            "  <joint name=\"{name}/{suffix}\" type=\"{kind}\" axis=\"{}\"/>\n",
            format_vector(&axis)
        );
    }
    if let Some(mut inertial) = tree.inertials[link.index()] {
        inertial.com = own.frame.inverse_point(&inertial.com);
        let rotation = own.frame.rotation;
        let turned = rotation.transpose() * inertial.about_com * rotation;
        inertial.about_com = turned * 0.5 + turned.transpose() * 0.5;
        append!(lines, "  {}\n", inertial_element(&inertial, tree.share[link.index()]));
    }
    append!(lines, "  <site name=\"{name}/1\"/>\n</body>\n");
    tree.append_half(base.link, closure, &lines);
    let site = format!("<site name=\"{name}/2\"{}/>\n", pose_attributes(&own.frame));
    tree.append_content(Some(link), &site);
    append!(tree.equalities, "    <weld name=\"{name}\" site1=\"{name}/1\" site2=\"{name}/2\"/>\n");
    let split = mechanism.link(link).name();
    tree.changes.push(Change::changed(
        "loop",
        closure.name(),
        format!(
            "joints to a body \"{}/half\" with a part of the mass and inertia of link \"{split}\", and a weld",
            closure.name()
        ),
        format!("MJCF has no {} constraint", closure.kind().name()),
    ));
    Ok(())
}

/// Refuses a closure that is open as drawn, because the joints of the half would keep this error.
fn check_drawing(
    mechanism: &Mechanism,
    closure: &Closure,
    drawn: &Transform<f64>,
    is_successor: bool,
) -> Result<(), MjcfError> {
    // Frame of the successor in the predecessor.
    let drawn = if is_successor { *drawn } else { drawn.inverse() };
    let error = drawing_error(closure, &drawn, mechanism.characteristic_length());
    if error <= DRAWING_TOLERANCE {
        return Ok(());
    }
    Err(MjcfError::new(
        "loop",
        closure.name(),
        format!(
            "the loop is open by {error:.1e} with all joints at 0 (rad, or relative to the size of the mechanism), and MJCF places the \
             joints of a {} loop as drawn; correct the drawing",
            closure.kind().name()
        ),
    ))
}

/// Reports a closure that is open as drawn: programs close such a loop at different poses.
fn report_open_drawing(tree: &mut BodyTree<'_>, closure: &Closure) {
    let mechanism = tree.mechanism;
    let frame = |end| loop_frame(&tree.world_poses, end);
    let drawn = frame(closure.predecessor()).inverse() * frame(closure.successor());
    let error = drawing_error(closure, &drawn, mechanism.characteristic_length());
    if error > DRAWING_TOLERANCE {
        let what = format!(
            "its pose can differ: the loop is open by {error:.1e} with all joints at 0 (rad, or relative to the size of the mechanism)"
        );
        let reason = "each program closes such a loop in its own way; correct the drawing";
        tree.changes.push(Change::changed("loop", closure.name(), what, reason));
    }
}

/// Error of a closure as drawn: rotation, rad, or translation relative to the size of the mechanism (m). `drawn`: loop frame of the
/// successor in that of the predecessor.
pub(crate) fn drawing_error(closure: &Closure, drawn: &Transform<f64>, size: f64) -> f64 {
    let axis = closure.axis();
    let p = drawn.translation / size;
    let turned = (drawn.vector(axis) - axis).norm();
    let across = p.cross(axis).norm();
    let rotated = (drawn.rotation - nalgebra::Matrix3::identity()).amax();
    match closure.kind() {
        ClosureKind::Fixed => p.norm().max(rotated),
        ClosureKind::Revolute => p.norm().max(turned),
        ClosureKind::Spherical => p.norm(),
        ClosureKind::Prismatic => across.max(rotated),
        ClosureKind::Cylindrical => across.max(turned),
        ClosureKind::Planar => p.dot(axis).abs().max(turned),
        ClosureKind::Universal => p.norm().max(axis.dot(&drawn.vector(closure.axis2())).abs()),
        ClosureKind::Distance => closure.distance().map_or(0.0, |length| (p.norm() - length / size).abs()),
    }
}
