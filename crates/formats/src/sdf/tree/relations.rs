//! Joints that close loops, and gearboxes.

use crate::parts::{Parts, SPRING_LEFT_OUT};
use crate::reading::findings::Findings;
use crate::reading::limits::OBLIQUE_PINS;
use crate::reading::report::quoted;
use crate::sdf::elements::joint::{JointBody, JointType};
use crate::sdf::frames::scopes::{Attached, Scopes};
use crate::sdf::tree::chain::{body_frame, body_name};
use crate::sdf::tree::spanning::{SpanningTree, Support};
use crate::urdf::elements::sdf_values::{GEARBOX, PARALLEL_AXES};
use percuss_mechanism::{ClosureDescription, ClosureKind, CouplingDescription, Severity};
use percuss_spatial::Vector3;

/// Adds a joint that closes a loop. Kinds and properties that a closure cannot have are errors; `is_leader`: another joint follows this
/// one by `<mimic>`.
pub(crate) fn add_closure(
    scopes: &Scopes,
    joint: &JointBody,
    is_leader: bool,
    parts: &mut Parts,
    findings: &mut Findings<'_>,
) {
    let refuse = |findings: &mut Findings<'_>, reason: &str| {
        findings.error("loop-unsupported", joint.element, || {
            format!(
                "the joint closes a loop, and {reason}; mark another joint of the loop by must_be_loop_joint (in physics/simbody), so that \
                 this one belongs to the tree"
            )
        });
    };
    let kind = match joint.kind {
        JointType::Fixed | JointType::Gearbox => ClosureKind::Fixed,
        JointType::Revolute => ClosureKind::Revolute,
        JointType::Prismatic => ClosureKind::Prismatic,
        JointType::Ball => ClosureKind::Spherical,
        JointType::Universal | JointType::Revolute2 => ClosureKind::Universal,
        JointType::Screw => {
            refuse(findings, "a screw cannot close one");
            return;
        }
    };
    if is_leader || joint.axes.iter().any(|axis| axis.mimic.is_some()) {
        refuse(findings, "it has no position of its own for a <mimic>");
        return;
    }
    if joint.armature != 0.0 {
        refuse(findings, "it has a rotor");
        return;
    }
    let [axis, axis2] = [0, 1].map(|i| joint.axes.get(i).map_or_else(Vector3::x, |axis| axis.direction));
    if kind == ClosureKind::Universal && axis.normalize().dot(&axis2.normalize()).abs() > OBLIQUE_PINS {
        refuse(findings, "its two axes are not at right angles");
        return;
    }
    if joint.axes.iter().any(|axis| axis.limits.is_some()) {
        findings.add_once(Severity::Note, "unused-element", "limit", joint.element, || {
            "the joint closes a loop, and its limits are not checked; give limits to a joint of the tree"
                .to_owned()
        });
    }
    if joint.axes.iter().any(|axis| axis.spring.is_some()) {
        findings.add_once(Severity::Note, SPRING_LEFT_OUT, "spring", joint.element, || {
            "the joint closes a loop, and its spring and damper are left out; give them to a joint of the tree".to_owned()
        });
    }
    let child = Attached::Link(joint.child);
    let frame = |body| scopes.relative_pose(body_frame(scopes, body), joint.frame);
    let names = [joint.parent, child].map(|body| body_name(scopes, body));
    let closure = ClosureDescription {
        predecessor_frame: frame(joint.parent),
        successor_frame: frame(child),
        axis,
        axis2,
        ..ClosureDescription::new(&joint.name, kind, names[0], names[1])
    };
    parts.closures.push((closure, joint.element));
}

/// Adds a gearbox: θ₂ = −ratio · θ₁ with the angle θ₁ of the parent about the first axis and θ₂ of the child about the second, both
/// relative to the reference body. The parent and the child must turn on the reference body by one revolute joint each.
pub(crate) fn add_gearbox(
    scopes: &Scopes,
    joints: &[JointBody],
    tree: &SpanningTree,
    gearbox: &JointBody,
    parts: &mut Parts,
    findings: &mut Findings<'_>,
) {
    let Some((ratio, reference)) = gearbox.gear else { return };
    let reference = rigid_base(joints, tree, reference);
    let child = Attached::Link(gearbox.child);
    let signs = [(gearbox.parent, 0), (child, 1)].map(|(body, axis)| {
        let (joint, reversed, base) = turning_joint(joints, tree, body)?;
        let axes = [(&gearbox.axes[axis].direction, gearbox.frame), (&joint.axes[0].direction, joint.frame)];
        let [wanted, own] =
            axes.map(|(direction, frame)| scopes.frame(frame).world_pose.vector(direction).normalize());
        let cosine = wanted.dot(&own);
        let is_parallel = (cosine.abs() - 1.0).abs() <= PARALLEL_AXES;
        // A reversed joint moves its parent against its axis.
        let sign = cosine.signum() * if reversed { -1.0 } else { 1.0 };
        (base == reference && is_parallel).then_some(sign)
    });
    let [Some(first), Some(second)] = signs else {
        findings.error("gearbox", gearbox.element, || {
            format!(
                "the gearbox is not read: its parent {} and its child {} must turn on <gearbox_reference_body> by one revolute joint \
                 each, about <axis> and <axis2>; give one of the joints a <mimic> instead",
                quoted(body_name(scopes, gearbox.parent)),
                quoted(body_name(scopes, child))
            )
        });
        return;
    };
    findings.add_once(Severity::Warning, "gearbox", "gearbox", gearbox.element, || GEARBOX.to_owned());
    let names = [gearbox.parent, child].map(|body| body_name(scopes, body).to_owned());
    let [predecessor, successor] = names;
    let coupling = CouplingDescription {
        name: gearbox.name.clone(),
        predecessor,
        successor,
        ratio: -ratio * first * second,
    };
    parts.couplings.push((coupling, gearbox.element));
}

/// Body below all fixed joints that support a body.
fn rigid_base(joints: &[JointBody], tree: &SpanningTree, body: Attached) -> Attached {
    let mut current = body;
    while let Attached::Link(link) = current {
        current = match tree.supports[link] {
            Support::Static => Attached::Ground,
            Support::Joint { joint, .. } if joints[joint].kind == JointType::Fixed => tree.below[link],
            Support::Joint { .. } | Support::Floating | Support::Absent => break,
        };
    }
    current
}

/// Revolute joint that supports a body through fixed joints, its direction, and the rigid base of the body below it.
fn turning_joint<'j>(
    joints: &'j [JointBody],
    tree: &SpanningTree,
    body: Attached,
) -> Option<(&'j JointBody, bool, Attached)> {
    let Attached::Link(link) = rigid_base(joints, tree, body) else { return None };
    match tree.supports[link] {
        Support::Joint { joint, reversed } if joints[joint].kind == JointType::Revolute => {
            Some((&joints[joint], reversed, rigid_base(joints, tree, tree.below[link])))
        }
        _ => None,
    }
}
