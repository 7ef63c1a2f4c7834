//! Joints of the tree as joints of a mechanism.
//!
//! A joint of a mechanism ends at the origin of its child link. A joint elsewhere, or with several axes, becomes a chain of massless
//! links `LINK/JOINT`, and a fixed joint leads from the anchor to the origin. A joint that is passed from child to parent keeps the sign
//! of its position: its steps are reversed, and their axes change the sign. The quaternion of a ball joint then turns the parent in the
//! child.

use crate::parts::{LinkOrigin, Parts};
use crate::reading::unique_names::UniqueNames;
use crate::sdf::elements::axis::JointAxis;
use crate::sdf::elements::joint::{JointBody, JointType};
use crate::sdf::frames::scopes::{Attached, FrameId, Scopes};
use percuss_mechanism::{JointDescription, JointKind, LinkDescription, MimicDescription};
use percuss_spatial::{Transform, Vector3};
use std::collections::HashMap;

/// Name of the ground in a mechanism.
pub(crate) const GROUND: &str = "world";

/// One motion of a joint.
#[derive(Clone, Debug)]
struct Step {
    name: String,
    kind: JointKind,
    /// In the joint frame.
    axis: Vector3<f64>,
    /// Index of the axis in the file; `None` for the advance of a screw.
    of_axis: Option<usize>,
}

/// Names of the motions of all joints, by index of the joint in the file and axis.
pub(crate) type StepNames = HashMap<(usize, usize), String>;

/// Adds the links and joints of a chain.
pub(crate) struct ChainBuilder<'a> {
    pub scopes: &'a Scopes,
    pub parts: &'a mut Parts,
    pub link_names: &'a mut UniqueNames,
    pub joint_names: &'a mut UniqueNames,
    /// Names of the motions that others may follow.
    pub step_names: &'a StepNames,
}

/// Name of a body in the mechanism.
pub(crate) fn body_name(scopes: &Scopes, body: Attached) -> &str {
    match body {
        Attached::Ground => GROUND,
        Attached::Link(link) => scopes.link_name(link),
    }
}

/// Frame of a body.
pub(crate) fn body_frame(scopes: &Scopes, body: Attached) -> FrameId {
    match body {
        Attached::Ground => FrameId(0),
        Attached::Link(link) => scopes.links[link].frame,
    }
}

/// Name of the motion of a joint about or along one of its axes.
pub(crate) fn step_name(joint: &JointBody, axis: usize) -> String {
    match (joint.kind, axis) {
        (JointType::Universal | JointType::Revolute2, 0) => format!("{}/axis", joint.name),
        (JointType::Universal | JointType::Revolute2, _) => format!("{}/axis2", joint.name),
        _ => joint.name.clone(),
    }
}

/// Motions of a joint, from the parent to the child.
fn steps(joint: &JointBody) -> Vec<Step> {
    let rotation =
        |axis: &JointAxis| if axis.limits.is_some() { JointKind::Revolute } else { JointKind::Continuous };
    let about = |index: usize| Step {
        name: step_name(joint, index),
        kind: rotation(&joint.axes[index]),
        axis: joint.axes[index].direction,
        of_axis: Some(index),
    };
    let without_axis =
        |kind| vec![Step { name: joint.name.clone(), kind, axis: Vector3::z(), of_axis: None }];
    match joint.kind {
        JointType::Fixed | JointType::Gearbox => without_axis(JointKind::Fixed),
        JointType::Ball => without_axis(JointKind::Spherical),
        JointType::Revolute => vec![about(0)],
        JointType::Prismatic => vec![Step { kind: JointKind::Prismatic, ..about(0) }],
        JointType::Universal | JointType::Revolute2 => vec![about(0), about(1)],
        JointType::Screw => vec![
            about(0),
            Step {
                name: format!("{}/advance", joint.name),
                kind: JointKind::Prismatic,
                of_axis: None,
                ..about(0)
            },
        ],
    }
}

impl ChainBuilder<'_> {
    /// Adds a link that is supported by a joint from `below`, and the links of the chain before it.
    pub fn add_supported(
        &mut self,
        joint: &JointBody,
        reversed: bool,
        below: Attached,
        link: (LinkDescription, LinkOrigin),
    ) {
        let (base, own) =
            (body_frame(self.scopes, below), body_frame(self.scopes, self.moving_body(joint, reversed)));
        // Frame of the joint in the supported link, and of that link in the base, as drawn.
        let x_lj = self.scopes.relative_pose(own, joint.frame);
        let x_bl = self.scopes.relative_pose(base, own);
        let mut steps = steps(joint);
        if reversed {
            steps.reverse();
            steps.iter_mut().for_each(|step| step.axis = -step.axis);
        }
        // The links of a chain of axes are parallel to the supported link.
        steps.iter_mut().for_each(|step| step.axis = x_lj.vector(&step.axis));
        let anchor = match joint.kind {
            // The positions of a ball joint are rotations in its frame.
            JointType::Ball => x_lj,
            _ => Transform::from_translation(needed_anchor(&steps, x_lj.translation)),
        };
        let link_name = link.0.name.clone();
        let mut parent = body_name(self.scopes, below).to_owned();
        let mut origin = x_bl * anchor;
        let count = steps.len();
        for (position, step) in steps.into_iter().enumerate() {
            let is_last = position + 1 == count && anchor == Transform::identity();
            let child = if is_last {
                link_name.clone()
            } else {
                self.link_names.take(format!("{link_name}/{}", step.name))
            };
            let described = self.describe(joint, &step, (&parent, &child), origin);
            self.parts.joints.push((described, joint.element));
            if is_last {
                self.parts.links.push(link);
                return;
            }
            self.parts.add_auxiliary(child.clone(), joint.element);
            parent = child;
            origin = Transform::identity();
        }
        let name = self.joint_names.take(format!("{link_name}_fixed"));
        let fixed = JointDescription::new(name, JointKind::Fixed, parent, link_name);
        self.parts.joints.push((fixed.origin(anchor.inverse()), joint.element));
        self.parts.links.push(link);
    }

    /// Link that a joint moves, seen from the root of the tree.
    fn moving_body(&self, joint: &JointBody, reversed: bool) -> Attached {
        if reversed { joint.parent } else { Attached::Link(joint.child) }
    }

    /// Joint of the mechanism for one step of the joint of the file.
    fn describe(
        &self,
        joint: &JointBody,
        step: &Step,
        (parent, child): (&str, &str),
        origin: Transform<f64>,
    ) -> JointDescription {
        let described =
            JointDescription::new(&step.name, step.kind, parent, child).origin(origin).axis(step.axis.into());
        let Some(index) = step.of_axis else {
            return match (joint.kind, step.kind) {
                (JointType::Screw, JointKind::Prismatic) => described.mimic(&joint.name, joint.advance, 0.0),
                _ => described,
            };
        };
        let axis = &joint.axes[index];
        let mimic = axis.mimic.and_then(|mimic| {
            let leader = self.step_names.get(&mimic.leader)?;
            Some(MimicDescription {
                joint: leader.clone(),
                multiplier: mimic.multiplier,
                offset: mimic.offset,
            })
        });
        let armature = if joint.armature == 0.0 || index > 0 { Vec::new() } else { vec![joint.armature] };
        JointDescription { limits: axis.limits, mimic, armature, spring: axis.spring, ..described }
    }
}

/// Anchor of a chain in the supported link; the origin if the place of the anchor has no effect: for a slide, a fixed joint, and a
/// rotation whose axis passes through the origin.
fn needed_anchor(steps: &[Step], anchor: Vector3<f64>) -> Vector3<f64> {
    let is_free = steps.iter().all(|step| match step.kind {
        JointKind::Fixed | JointKind::Prismatic => true,
        JointKind::Revolute | JointKind::Continuous => anchor.cross(&step.axis) == Vector3::zeros(),
        JointKind::Planar | JointKind::Spherical | JointKind::Floating => false,
    });
    if is_free { Vector3::zeros() } else { anchor }
}
