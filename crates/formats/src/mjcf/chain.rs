//! Bodies as links and joints of a mechanism. A body with several joints, or with a joint outside its origin, becomes a chain of massless
//! links.

use crate::mjcf::bodies::body::{Bodies, Body, BodyJoint, JointType};
use crate::mjcf::relations::actuator::TendonRotor;
use crate::mjcf::relations::joint_relations::{JointRelations, JointSum, Relation};
use crate::mjcf::relations::references::JointKey;
use crate::parts::{LinkOrigin, Parts};
use crate::reading::document::element_tree::ElementId;
use crate::reading::unique_names::UniqueNames;
use percuss_mechanism::{
    CurveDescription, Geometry, Inertial, JointDescription, JointKind, Limits, LinkDescription,
    MimicDescription, RelationDescription,
};
use percuss_spatial::{Transform, Vector3, rotation_about};
use std::collections::HashMap;

/// Links and joints of a model with their elements.
#[derive(Debug, Default)]
pub(crate) struct Chains {
    pub parts: Parts,
    /// Name of the link of every body.
    pub link_names: Vec<String>,
    /// Name of every joint of a body.
    pub joint_names: HashMap<JointKey, String>,
}

/// Converts the bodies to links and joints. `inertias` and `extents`: inertia and extent of each body.
pub(crate) fn build_chains(
    bodies: &Bodies,
    inertias: Vec<Option<Inertial>>,
    extents: Vec<Geometry>,
    relations: &mut JointRelations,
    rotors: &[TendonRotor],
    sums: Vec<(ElementId, JointSum)>,
) -> Chains {
    let mut link_names = UniqueNames::default();
    let mut joint_names = UniqueNames::default();
    let named = bodies.bodies.iter().map(|body| body.name.as_str()).filter(|name| !name.is_empty());
    link_names.reserve(named);
    joint_names.reserve(bodies.joint_by_name.keys().map(String::as_str));
    let mut builder = ChainBuilder { chains: Chains::default(), link_names, joint_names };
    for (index, body) in bodies.bodies.iter().enumerate() {
        let name = match body.name.as_str() {
            "" => builder.link_names.take(format!("body{index}")),
            name => name.to_owned(),
        };
        builder.chains.link_names.push(name);
    }
    builder.name_joints(bodies);
    for (index, ((body, inertial), geometry)) in bodies.bodies.iter().zip(inertias).zip(extents).enumerate() {
        let link = LinkDescription { name: builder.chains.link_names[index].clone(), inertial, geometry };
        if index > 0 {
            builder.add_joints(index, body, relations);
        }
        let origin = LinkOrigin { element: body.element, link: Some(index), has_default_inertia: false };
        builder.chains.parts.links.push((link, origin));
    }
    rotors.iter().for_each(|rotor| builder.add_rotor(rotor, relations));
    for (element, sum) in sums {
        let described = builder.describe_sum(sum);
        builder.chains.parts.relations.push((described, element));
    }
    builder.chains
}

struct ChainBuilder {
    chains: Chains,
    link_names: UniqueNames,
    joint_names: UniqueNames,
}

impl ChainBuilder {
    /// Gives every joint a name.
    fn name_joints(&mut self, bodies: &Bodies) {
        for (index, body) in bodies.bodies.iter().enumerate() {
            for (position, joint) in body.joints.iter().enumerate() {
                let name = match joint.name.as_str() {
                    "" => self.joint_names.take(format!("{}_joint", self.chains.link_names[index])),
                    name => name.to_owned(),
                };
                self.chains.joint_names.insert((index, position), name);
            }
        }
    }

    /// Adds the joints of a body, from the parent to the body, with massless links between them.
    ///
    /// The frame after joint i is parallel to the body's frame as drawn, with its origin at the anchor of the joint. A fixed joint leads
    /// from the last anchor back to the body's origin, unless they coincide.
    fn add_joints(&mut self, index: usize, body: &Body, relations: &mut JointRelations) {
        let body_name = self.chains.link_names[index].clone();
        let mut parent = self.chains.link_names[body.parent].clone();
        let mut origin = body.pose;
        let mut anchor = Vector3::zeros();
        for (position, joint) in body.joints.iter().enumerate() {
            let own_anchor = needed_anchor(joint);
            origin = origin * Transform::from_translation(own_anchor - anchor);
            anchor = own_anchor;
            let joint_name = self.chains.joint_names[&(index, position)].clone();
            let is_last = position + 1 == body.joints.len() && anchor == Vector3::zeros();
            let child = if is_last {
                body_name.clone()
            } else {
                self.link_names.take(format!("{body_name}/{joint_name}"))
            };
            let relation = relations.get((index, position));
            let joint_element = joint.element;
            let described = self.describe(joint, &joint_name, relation, (&parent, &child), origin);
            self.chains.parts.joints.push((described, joint_element));
            if is_last {
                return;
            }
            self.chains.parts.add_auxiliary(child.clone(), joint_element);
            parent = child;
            origin = Transform::identity();
        }
        let name = self.joint_names.take(format!("{body_name}_fixed"));
        let fixed = JointDescription::new(name, JointKind::Fixed, parent, body_name);
        let fixed = fixed.origin(origin * Transform::from_translation(-anchor));
        self.chains.parts.joints.push((fixed, body.element));
    }

    /// Adds the rotor of a tendon: a massless link on a slide with the armature, which follows the sum of the tendon's joints.
    fn add_rotor(&mut self, rotor: &TendonRotor, relations: &mut JointRelations) {
        let tendon = if rotor.name.is_empty() { "tendon" } else { &rotor.name };
        let link = self.link_names.take(format!("{tendon}/rotor"));
        let joint = self.joint_names.take(format!("{tendon}/length"));
        let world = self.chains.link_names[0].clone();
        let slide = JointDescription::new(joint.clone(), JointKind::Prismatic, world, link.clone());
        let slide = JointDescription { independent: Some(false), ..slide.armature(rotor.armature) };
        self.chains.parts.joints.push((slide, rotor.element));
        self.chains.parts.add_auxiliary(link, rotor.element);
        let mut sum = JointSum { terms: rotor.terms.clone(), ..JointSum::default() };
        relations.take_locked(&mut sum.terms);
        // The length is 0 as drawn; there the mimics are at their offsets.
        let drawn: f64 = sum
            .terms
            .iter()
            .filter_map(|(joint, factor)| match relations.get(*joint) {
                Some(Relation::Mimic { offset, .. }) => Some(factor * offset),
                _ => None,
            })
            .sum();
        let mut described = self.describe_sum(sum);
        described.constant -= drawn;
        described.terms.iter_mut().for_each(|(_, factor)| *factor = -*factor);
        described.terms.insert(0, (joint, 1.0));
        // The length counts from the drawing: a constant has no effect on rates.
        described.name = format!("{tendon}/length");
        self.chains.parts.relations.push((described, rotor.element));
    }

    /// Relation with the names of the joints; its own name is empty.
    fn describe_sum(&self, sum: JointSum) -> RelationDescription {
        let named = |terms: Vec<(JointKey, f64)>| {
            terms.into_iter().map(|(key, factor)| (self.chains.joint_names[&key].clone(), factor)).collect()
        };
        RelationDescription {
            name: String::new(),
            terms: named(sum.terms),
            constant: sum.constant,
            curve: sum.curve.map(|curve| CurveDescription {
                terms: named(curve.terms),
                offset: curve.offset,
                coefficients: curve.coefficients,
            }),
        }
    }

    /// Joint of the mechanism. A joint that an equality locks becomes a fixed joint at that position.
    fn describe(
        &self,
        joint: &BodyJoint,
        name: &str,
        relation: Option<Relation>,
        (parent, child): (&str, &str),
        origin: Transform<f64>,
    ) -> JointDescription {
        let limits = joint.limits.map(|[lower, upper]| Limits { lower, upper });
        let kind = match joint.kind {
            JointType::Free => JointKind::Floating,
            JointType::Ball => JointKind::Spherical,
            JointType::Slide => JointKind::Prismatic,
            JointType::Hinge if limits.is_some() => JointKind::Revolute,
            JointType::Hinge => JointKind::Continuous,
        };
        let described =
            JointDescription::new(name, kind, parent, child).origin(origin).axis(joint.axis.into());
        if let Some(Relation::Locked(position)) = relation {
            let motion = match joint.kind {
                JointType::Slide => Transform::from_translation(joint.axis * position),
                _ => Transform::new(rotation_about(&joint.axis, position), Vector3::zeros()),
            };
            return JointDescription { kind: JointKind::Fixed, origin: origin * motion, ..described };
        }
        let mimic = match relation {
            Some(Relation::Mimic { master, multiplier, offset }) => {
                Some(MimicDescription { joint: self.chains.joint_names[&master].clone(), multiplier, offset })
            }
            _ => None,
        };
        // One value for all velocities suits only joints with one unit.
        let count = if kind == JointKind::Floating { 6 } else { 1 };
        let armature = if joint.armature == 0.0 { Vec::new() } else { vec![joint.armature; count] };
        JointDescription { limits, mimic, armature, spring: joint.spring, ..described }
    }
}

/// Anchor of a joint; the origin if the place of the anchor has no effect: for slides and free joints, and for hinges whose axis passes
/// through the origin.
fn needed_anchor(joint: &BodyJoint) -> Vector3<f64> {
    match joint.kind {
        JointType::Free | JointType::Slide => Vector3::zeros(),
        JointType::Hinge if joint.anchor.cross(&joint.axis) == Vector3::zeros() => Vector3::zeros(),
        JointType::Ball | JointType::Hinge => joint.anchor,
    }
}
