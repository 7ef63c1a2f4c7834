//! Joints of the tree.

use super::bodies::{Bodies, Chain, ChainKind, Form, path_pose, pose_text, valid_name};
use super::error::SdfError;
use crate::writing::changes::Change;
use crate::writing::xml_text::{append, escape_attribute, format_number, format_vector};
use percuss_mechanism::{Joint, JointId, JointKind, LinkId, Mechanism};
use percuss_spatial::{Transform, Vector3};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Relation of an axis to a leading joint: its position is multiplier · leader + offset.
#[derive(Clone, Copy, Debug)]
struct Follower {
    leader: JointId,
    multiplier: f64,
    offset: f64,
}

/// Names of the joints in the file, and the axes that follow others.
pub(super) struct Axes {
    /// Name of the joint of the file and tag of its axis, for every joint of the tree that moves.
    names: HashMap<JointId, (String, &'static str)>,
    followers: HashMap<JointId, Follower>,
    /// True if a joint has an armature.
    pub has_rotors: bool,
}

impl Axes {
    /// Names the joints and collects mimics and couplings.
    ///
    /// # Errors
    /// [`SdfError`] for couplings that are no mimic.
    pub fn new(bodies: &mut Bodies<'_>) -> Result<Self, SdfError> {
        let mechanism = bodies.mechanism;
        let mut axes = Self { names: HashMap::new(), followers: HashMap::new(), has_rotors: false };
        let mut chains: Vec<Chain> = bodies.chains.iter().flatten().cloned().collect();
        // Joints with a valid name keep it.
        chains.sort_by_key(|chain| {
            let name = chain_name(mechanism, chain);
            valid_name(&name) != name
        });
        let mut screws = Vec::new();
        for chain in chains {
            let first = chain.joints[0];
            let name = bodies.joint_name(&chain_name(mechanism, &chain));
            axes.names.insert(first, (name.clone(), "axis"));
            match chain.kind {
                ChainKind::Universal | ChainKind::Revolute2 => {
                    axes.names.insert(chain.joints[1], (name, "axis2"));
                }
                ChainKind::Screw => screws.push(chain.joints[1]),
                ChainKind::Single => {}
            }
        }
        for (id, joint) in mechanism.joint_ids().zip(mechanism.joints()) {
            if let Some(mimic) = joint.mimic().filter(|_| !screws.contains(&id)) {
                let (multiplier, offset) = (mimic.multiplier, mimic.offset);
                axes.followers.insert(id, Follower { leader: mimic.master, multiplier, offset });
            }
        }
        for coupling in mechanism.couplings() {
            let refusal = |reason: &str| SdfError::new("coupling", coupling.name(), reason);
            if coupling.curve().is_some() || coupling.constant() != 0.0 && coupling.terms().len() != 2 {
                return Err(refusal("SDFormat has only linear relations of two joints, by a <mimic>"));
            }
            let [(first, a), (second, b)] = coupling.terms() else {
                return Err(refusal(
                    "SDFormat couples two joints, by a <mimic>; this coupling has another number of joints",
                ));
            };
            let (follower, leader, multiplier, own) = if axes.followers.contains_key(first) {
                (*second, *first, -a / b, *b)
            } else {
                (*first, *second, -b / a, *a)
            };
            let offset = coupling.constant() / own;
            if axes.followers.contains_key(&follower) || !multiplier.is_finite() || !offset.is_finite() {
                return Err(refusal(
                    "in SDFormat a joint follows one other, and both joints of this coupling follow another already",
                ));
            }
            axes.followers.insert(follower, Follower { leader, multiplier, offset });
            let what = format!("a mimic of joint \"{}\"", mechanism.joint(follower).name());
            let reason = "SDFormat has no other relation of joints";
            bodies.changes.push(Change::changed("coupling", coupling.name(), what, reason));
        }
        for (id, follower) in &axes.followers {
            if ![id, &follower.leader].iter().all(|joint| axes.names.contains_key(joint)) {
                let name = mechanism.joint(*id).name();
                return Err(SdfError::new(
                    "joint",
                    name,
                    "it follows, or leads, the advance of a screw; let it follow the screw",
                ));
            }
        }
        axes.has_rotors = mechanism.joints().iter().any(|joint| joint.armature().iter().any(|a| *a != 0.0));
        Ok(axes)
    }

    /// True if a joint follows another.
    pub fn has_mimics(&self) -> bool {
        !self.followers.is_empty()
    }

    /// Joints of the tree, in the order of the links.
    ///
    /// # Errors
    /// [`SdfError`] for planar joints, and for armatures that SDFormat cannot express.
    pub fn write_joints(&self, bodies: &mut Bodies<'_>) -> Result<String, SdfError> {
        let mechanism = bodies.mechanism;
        let mut out = String::new();
        let root = mechanism.root();
        if bodies.forms[root.index()] == Form::Link {
            let name =
                escape_attribute(&bodies.joint_name(&format!("{}_static", mechanism.link(root).name())));
            let link = escape_attribute(bodies.name(root));
            append!(
                out,
                "    <joint name=\"{name}\" type=\"fixed\"><parent>world</parent><child>{link}</child></joint>\n"
            );
        }
        for id in mechanism.link_ids() {
            if let Some(chain) = &bodies.chains[id.index()] {
                self.append_chain(bodies, id, chain, &mut out)?;
            }
        }
        Ok(out)
    }

    /// Appends the `<joint>` of a chain; nothing for a floating joint, which SDFormat expresses by the absence of a joint.
    fn append_chain(
        &self,
        bodies: &Bodies<'_>,
        link: LinkId,
        chain: &Chain,
        out: &mut String,
    ) -> Result<(), SdfError> {
        let mechanism = bodies.mechanism;
        let first = mechanism.joint(chain.joints[0]);
        let moving = if chain.kind == ChainKind::Single { 1 } else { 2 };
        let last = mechanism.joint(chain.joints[moving - 1]);
        let kind = match (chain.kind, first.kind()) {
            (ChainKind::Universal, _) => "universal",
            (ChainKind::Revolute2, _) => "revolute2",
            (ChainKind::Screw, _) => "screw",
            (_, JointKind::Fixed) => "fixed",
            // Not continuous, because some versions of Gazebo fix continuous joints.
            (_, JointKind::Revolute | JointKind::Continuous) => "revolute",
            (_, JointKind::Prismatic) => "prismatic",
            (_, JointKind::Spherical) => "ball",
            (_, JointKind::Floating) => {
                return if first.armature().iter().all(|armature| *armature == 0.0) {
                    Ok(())
                } else {
                    Err(no_armature(first))
                };
            }
            (_, JointKind::Planar) => {
                let reason = "SDFormat has no planar joint; use two prismatic joints and a revolute joint with links between";
                return Err(SdfError::new("joint", first.name(), reason));
            }
        };
        let name =
            self.names.get(&chain.joints[0]).map(|(name, _)| escape_attribute(name)).unwrap_or_default();
        append!(out, "    <joint name=\"{name}\" type=\"{kind}\">\n");
        // Frame of the moving joints in the link.
        let pose = path_pose(mechanism, last.child(), link).inverse();
        if last.child() != link && pose != Transform::identity() {
            append!(out, "      <pose>{}</pose>\n", pose_text(&pose));
        }
        let [parent, child] = [first.parent(), link].map(|link| escape_attribute(bodies.name(link)));
        append!(out, "      <parent>{parent}</parent>\n      <child>{child}</child>\n");
        match chain.kind {
            ChainKind::Single if first.kind().has_axis() => {
                self.append_axis("axis", chain.joints[0], first, first.axis(), out);
            }
            ChainKind::Single => {}
            ChainKind::Universal | ChainKind::Revolute2 => {
                let axis = last.origin().inverse_vector(first.axis());
                self.append_axis("axis", chain.joints[0], first, &axis, out);
                self.append_axis("axis2", chain.joints[1], last, last.axis(), out);
            }
            ChainKind::Screw => {
                let advance = last.mimic().map_or(0.0, |mimic| mimic.multiplier);
                let [pitch, old_pitch] = [advance * TAU, -1.0 / advance].map(format_number);
                // Right-handed metres per turn for libsdformat from 13 on; left-handed radians per metre for earlier versions.
                append!(out, "      <screw_thread_pitch>{pitch}</screw_thread_pitch>\n");
                append!(out, "      <thread_pitch>{old_pitch}</thread_pitch>\n");
                let axis = last.origin().inverse_vector(first.axis());
                self.append_axis("axis", chain.joints[0], first, &axis, out);
            }
        }
        match first.armature() {
            armature if armature.iter().all(|value| *value == 0.0) => {}
            [value] => append!(
                out,
                "      <drake:rotor_inertia>{}</drake:rotor_inertia>\n      <drake:gear_ratio>1</drake:gear_ratio>\n",
                format_number(*value)
            ),
            _ => return Err(no_armature(first)),
        }
        out.push_str("    </joint>\n");
        Ok(())
    }

    /// Appends the element `tag` of an axis with its limits and its `<mimic>`; `axis` is the direction in the joint's frame.
    fn append_axis(&self, tag: &str, id: JointId, joint: &Joint, axis: &Vector3<f64>, out: &mut String) {
        append!(out, "      <{tag}>\n        <xyz>{}</xyz>\n", format_vector(&axis.map(|x| x + 0.0)));
        if let Some(limits) = joint.limits() {
            let [lower, upper] = [limits.lower, limits.upper].map(format_number);
            append!(out, "        <limit><lower>{lower}</lower><upper>{upper}</upper></limit>\n");
        }
        if let Some(spring) = joint.spring() {
            let [stiffness, damping, reference] =
                [spring.stiffness, spring.damping, spring.reference].map(format_number);
            append!(
                out,
                "        <dynamics><damping>{damping}</damping><friction>0</friction><spring_reference>{reference}</spring_reference>\
                 <spring_stiffness>{stiffness}</spring_stiffness></dynamics>\n"
            );
        }
        if let Some(Follower { leader, multiplier, offset }) = self.followers.get(&id)
            && let Some((name, axis)) = self.names.get(leader)
        {
            let (name, [multiplier, offset]) =
                (escape_attribute(name), [*multiplier, *offset].map(format_number));
            append!(
                out,
                "        <mimic joint=\"{name}\" axis=\"{axis}\"><multiplier>{multiplier}</multiplier><offset>{offset}</offset><reference>0</reference></mimic>\n"
            );
        }
        append!(out, "      </{tag}>\n");
    }
}

fn no_armature(joint: &Joint) -> SdfError {
    SdfError::new(
        "joint",
        joint.name(),
        "it has an armature, and only joints with one degree of freedom have one in SDFormat (drake:rotor_inertia); remove it",
    )
}

/// Name of the joint in the file. A universal joint that was read from a file keeps the name from that file.
fn chain_name(mechanism: &Mechanism, chain: &Chain) -> String {
    let name = |position: usize| mechanism.joint(chain.joints[position]).name();
    match chain.kind {
        ChainKind::Universal | ChainKind::Revolute2 => {
            let base = name(0).strip_suffix("/axis");
            match base.filter(|base| name(1).strip_suffix("/axis2") == Some(base)) {
                Some(base) => base.to_owned(),
                None => format!("{}/{}", name(0), name(1)),
            }
        }
        ChainKind::Single | ChainKind::Screw => name(0).to_owned(),
    }
}
