//! Links of the file: links with a body, frames, and links that are a part of a joint.

use super::error::SdfError;
use crate::reading::unique_names::UniqueNames;
use crate::writing::changes::Change;
use crate::writing::structure::{drawn_poses, held_links, immovable_links, is_massless};
use crate::writing::xml_text::{append, escape_attribute, format_number, format_vector};
use percuss_mechanism::{Inertial, Joint, JointId, JointKind, LinkId, Mechanism};
use percuss_spatial::{Matrix3, Transform, Vector3, rpy_from_rotation};

/// Largest distance of two axes of rotation that meet in one point, relative to the size of the mechanism: a few roundings.
const COMMON_POINT: f64 = 1e-13;
/// Largest |cosine| of the angle between the axes of a universal joint: a few roundings.
const RIGHT_ANGLE: f64 = 1e-13;

/// Radius of gyration of the mass that replaces a mass of 0, relative to the size of the mechanism: no check of percuss or of a simulator
/// finds it implausible.
const PLACEHOLDER_RADIUS: f64 = 0.1;
/// Least moment of this mass, kg·m².
const LEAST_PLACEHOLDER: f64 = 1e-9;

/// Form of a link in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// The world itself.
    World,
    Link,
    /// Frame attached to the parent link.
    Frame,
    /// No element: the link lies within the chain of joints of another.
    Merged,
}

/// Kinds of joint of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ChainKind {
    /// The first joint of the chain alone.
    Single,
    Universal,
    Revolute2,
    Screw,
}

/// Joints between two links of the file, from the parent on: one or two that move, then fixed joints.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub kind: ChainKind,
    pub joints: Vec<JointId>,
}

/// Links of the file.
pub(super) struct Bodies<'m> {
    pub mechanism: &'m Mechanism,
    /// Pose of every link in the world with all joints at 0.
    pub world_poses: Vec<Transform<f64>>,
    pub forms: Vec<Form>,
    /// Chain of joints that supports each link of the form `Link`; `None` for the root.
    pub chains: Vec<Option<Chain>>,
    /// Names in the file; empty for merged links.
    pub names: Vec<String>,
    /// Names in use, for those of joints.
    pub used_names: UniqueNames,
    pub changes: Vec<Change>,
}

/// Name without `::`, which separates the names of models in SDFormat, and without blanks at its ends, which readers remove from the texts
/// that refer to it.
pub(super) fn valid_name(name: &str) -> String {
    let name = name.replace("::", "_");
    let trimmed = name.trim();
    match trimmed == name {
        true => name,
        // The name without blanks may be reserved.
        false if trimmed.is_empty() || trimmed == "world" || trimmed.starts_with("__") => {
            format!("renamed_{trimmed}")
        }
        false => trimmed.to_owned(),
    }
}

/// Name of the model.
pub(super) fn model_name(mechanism: &Mechanism) -> String {
    match mechanism.name() {
        "" | "world" => "model".to_owned(),
        name => name.replace("::", "_"),
    }
}

impl<'m> Bodies<'m> {
    /// Finds the forms of all links.
    ///
    /// # Errors
    /// [`SdfError`] for names that SDFormat reserves.
    pub fn new(mechanism: &'m Mechanism) -> Result<Self, SdfError> {
        let count = mechanism.links().len();
        let root = mechanism.root();
        let world_poses = drawn_poses(mechanism);
        let mut bodies = Self {
            mechanism,
            world_poses,
            forms: vec![Form::Link; count],
            chains: vec![None; count],
            names: vec![String::new(); count],
            used_names: UniqueNames::default(),
            changes: Vec::new(),
        };
        if mechanism.link(root).name() == "world" {
            bodies.forms[root.index()] = Form::World;
        }
        bodies.find_chains();
        bodies.changes = bodies.form_changes();
        bodies.name_links()?;
        Ok(bodies)
    }

    /// Finds frames, chains and the links within them. Links come before the links that support them.
    fn find_chains(&mut self) {
        let mechanism = self.mechanism;
        let held = held_links(mechanism);
        let mergeable = |link: LinkId| {
            is_massless(mechanism, link)
                && mechanism.child_joints(link).len() == 1
                && mechanism.parent_joint(link).is_some()
                && !held[link.index()]
        };
        for &link in mechanism.order().iter().rev() {
            let Some(id) = mechanism.parent_joint(link) else { continue };
            if self.forms[link.index()] == Form::Merged {
                continue;
            }
            let joint = mechanism.joint(id);
            let is_on_world = self.forms[joint.parent().index()] == Form::World;
            if joint.kind() == JointKind::Fixed && is_massless(mechanism, link) && !is_on_world {
                self.forms[link.index()] = Form::Frame;
                continue;
            }
            let mut joints = vec![id];
            let above = |id: JointId| {
                let parent = mechanism.joint(id).parent();
                mechanism.parent_joint(parent).filter(|_| mergeable(parent))
            };
            if joint.kind() == JointKind::Fixed
                && let Some(moving) = above(id).filter(|id| can_have_pose(mechanism.joint(*id)))
            {
                joints.insert(0, moving);
            }
            let mut kind = ChainKind::Single;
            if let Some(first) = above(joints[0])
                && let Some(pair) = pair_kind(mechanism, first, joints[0])
            {
                kind = pair;
                joints.insert(0, first);
            }
            for id in &joints[1..] {
                self.forms[mechanism.joint(*id).parent().index()] = Form::Merged;
            }
            self.chains[link.index()] = Some(Chain { kind, joints });
        }
    }

    /// Changes of links and joints, because SDFormat has frames, and joints with a pose and two axes.
    fn form_changes(&self) -> Vec<Change> {
        let mechanism = self.mechanism;
        let mut changes = Vec::new();
        if self.forms[mechanism.root().index()] == Form::Link {
            let what = "a link that a joint fixes to the world";
            let reason = "a model of SDFormat floats without such a joint";
            changes.push(Change::changed("link", mechanism.link(mechanism.root()).name(), what, reason));
        }
        for id in mechanism.link_ids() {
            let name = mechanism.link(id).name();
            match self.forms[id.index()] {
                Form::World | Form::Link => {}
                Form::Frame => {
                    changes.push(Change::changed(
                        "link",
                        name,
                        "a frame",
                        "simulators refuse links without mass",
                    ));
                    if let Some(joint) = mechanism.parent_joint(id).map(|joint| mechanism.joint(joint)) {
                        let reason = "a frame is attached without a joint";
                        changes.push(Change::lost("joint", joint.name(), "its name", reason));
                    }
                }
                Form::Merged => {
                    let what = "no link of its own: it is within a joint";
                    changes.push(Change::changed("link", name, what, "simulators refuse links without mass"));
                }
            }
        }
        for chain in self.chains.iter().flatten() {
            let first = mechanism.joint(chain.joints[0]);
            if first.kind() == JointKind::Floating {
                let reason = "a link without a joint floats in SDFormat";
                changes.push(Change::lost("joint", first.name(), "its name", reason));
            }
            let (form, moving) = match chain.kind {
                ChainKind::Single => ("the pose of a joint", 1),
                ChainKind::Universal => ("an axis of a universal joint", 0),
                ChainKind::Revolute2 => ("an axis of a revolute2 joint", 0),
                ChainKind::Screw => ("the advance of a screw", 1),
            };
            for id in chain.joints.iter().skip(moving) {
                let name = mechanism.joint(*id).name();
                let form = if mechanism.joint(*id).kind() == JointKind::Fixed {
                    "the pose of a joint"
                } else {
                    form
                };
                changes.push(Change::changed(
                    "joint",
                    name,
                    form,
                    "a joint of SDFormat has a pose and up to two axes",
                ));
            }
        }
        changes
    }

    /// Gives the links their names.
    fn name_links(&mut self) -> Result<(), SdfError> {
        let mechanism = self.mechanism;
        // Links with a valid name keep it.
        let (valid, changed): (Vec<LinkId>, Vec<LinkId>) = mechanism.link_ids().partition(|id| {
            let name = mechanism.link(*id).name();
            valid_name(name) == name
        });
        for id in valid.into_iter().chain(changed) {
            let name = mechanism.link(id).name();
            match self.forms[id.index()] {
                Form::World => {
                    self.names[id.index()] = "world".to_owned();
                    continue;
                }
                Form::Merged => continue,
                Form::Link | Form::Frame => {}
            }
            if name == "world" || name.starts_with("__") && name.ends_with("__") {
                let reason = "SDFormat reserves this name; rename the link";
                return Err(SdfError::new("link", name, reason));
            }
            let own = self.used_names.take(valid_name(name));
            if own != name {
                self.changes.push(changed_name("link", name, &own));
            }
            self.names[id.index()] = own;
        }
        Ok(())
    }

    /// Name of a link in the file.
    pub fn name(&self, link: LinkId) -> &str {
        &self.names[link.index()]
    }

    /// Reserves a name for a joint: its own, or with a number if the own name is in use in the model.
    pub fn joint_name(&mut self, name: &str) -> String {
        let own = self.used_names.take(valid_name(name));
        if own != name {
            self.changes.push(changed_name("joint", name, &own));
        }
        own
    }

    /// Writes all links and frames. `shapes`: visuals and collisions of each link as XML, in link order.
    pub fn append_links(&mut self, shapes: &[String], out: &mut String) {
        let mechanism = self.mechanism;
        let fixed = immovable_links(mechanism);
        for id in mechanism.link_ids() {
            let form = self.forms[id.index()].clone();
            let parent = match form {
                Form::World | Form::Merged => continue,
                Form::Frame => mechanism.parent_joint(id).map(|joint| mechanism.joint(joint).parent()),
                Form::Link => {
                    let chain = self.chains[id.index()].as_ref();
                    chain.and_then(|chain| chain.joints.first()).map(|joint| mechanism.joint(*joint).parent())
                }
            };
            let name = escape_attribute(self.name(id));
            let pose = self.pose_element(parent, id);
            if form == Form::Frame {
                let parent = parent.map(|parent| escape_attribute(self.name(parent))).unwrap_or_default();
                append!(out, "    <frame name=\"{name}\" attached_to=\"{parent}\">{pose}</frame>\n");
                continue;
            }
            append!(out, "    <link name=\"{name}\">\n");
            if !pose.is_empty() {
                append!(out, "      {pose}\n");
            }
            let inertial = self.inertial_of(id, fixed[id.index()]);
            append_inertial(out, &inertial);
            out.push_str(&shapes[id.index()]);
            out.push_str("    </link>\n");
        }
    }

    /// `<pose>` of a link relative to the link that supports it; empty for the identity in the model.
    fn pose_element(&self, parent: Option<LinkId>, link: LinkId) -> String {
        let pose = match parent {
            Some(parent) => path_pose(self.mechanism, parent, link),
            None => Transform::identity(),
        };
        match parent.filter(|parent| self.forms[parent.index()] != Form::World) {
            Some(parent) => {
                let name = escape_attribute(self.name(parent));
                format!("<pose relative_to=\"{name}\">{}</pose>", pose_text(&pose))
            }
            None if pose == Transform::identity() => String::new(),
            None => format!("<pose>{}</pose>", pose_text(&pose)),
        }
    }

    /// Inertia of a link as written.
    fn inertial_of(&mut self, link: LinkId, is_fixed: bool) -> Inertial {
        let mechanism = self.mechanism;
        let name = mechanism.link(link).name();
        let massless = Inertial::diagonal(0.0, [0.0; 3], [0.0; 3]);
        let own = mechanism.link(link).inertial().copied().unwrap_or(massless);
        if is_massless(mechanism, link) && is_fixed {
            let moment =
                (PLACEHOLDER_RADIUS * mechanism.characteristic_length()).powi(2).max(LEAST_PLACEHOLDER);
            let what = format!("1 kg and {moment:.1e} kg·m² instead of no mass; it cannot move");
            self.changes.push(Change::changed("link", name, what, "simulators refuse a mass of 0"));
            return Inertial::diagonal(1.0, [0.0; 3], [moment; 3]);
        }
        let moments = own.about_com.symmetric_eigenvalues();
        if !is_fixed && (own.mass <= 0.0 || moments.min() <= 0.0) {
            let what = "a mass or a moment of inertia of 0 is written as it is";
            self.changes.push(Change::changed(
                "link",
                name,
                what,
                "SDFormat allows 0, and simulators refuse it",
            ));
        }
        own
    }
}

/// Change of a name.
pub(super) fn changed_name(kind: &str, name: &str, own: &str) -> Change {
    let reason = match (name.contains("::"), name.trim() == name) {
        (true, _) => "\"::\" separates the names of models in SDFormat",
        (_, false) => "blanks at the ends of a text are no part of it in SDFormat",
        _ => "names of links, joints and frames are unique in SDFormat",
    };
    Change::changed(kind, name, format!("its name is \"{own}\""), reason)
}

/// X_al of a link in a link on its path to the root: the product of the origins of the joints between.
pub(super) fn path_pose(mechanism: &Mechanism, above: LinkId, link: LinkId) -> Transform<f64> {
    let mut pose = Transform::identity();
    let mut current = link;
    while current != above {
        let Some(id) = mechanism.parent_joint(current) else { break };
        let joint = mechanism.joint(id);
        pose = *joint.origin() * pose;
        current = joint.parent();
    }
    pose
}

/// Text of a pose: x y z roll pitch yaw.
pub(super) fn pose_text(pose: &Transform<f64>) -> String {
    // Adding 0 turns −0 into 0.
    let clean = |v: Vector3<f64>| format_vector(&v.map(|x| x + 0.0));
    if pose.rotation == Matrix3::identity() {
        return format!("{} 0 0 0", clean(pose.translation));
    }
    format!("{} {}", clean(pose.translation), clean(rpy_from_rotation(&pose.rotation).into()))
}

/// Appends `<inertial>`: mass, kg; centre of mass, m, and inertia about it, kg·m², in the axes of the link.
fn append_inertial(out: &mut String, inertial: &Inertial) {
    out.push_str("      <inertial>\n");
    if inertial.com != Vector3::zeros() {
        let pose = pose_text(&Transform::from_translation(inertial.com));
        append!(out, "        <pose>{pose}</pose>\n");
    }
    append!(out, "        <mass>{}</mass>\n        <inertia>", format_number(inertial.mass));
    for (tag, row, column) in
        [("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2)]
    {
        append!(out, "<{tag}>{}</{tag}>", format_number(inertial.about_com[(row, column)]));
    }
    out.push_str("</inertia>\n      </inertial>\n");
}

fn is_rotation(joint: &Joint) -> bool {
    matches!(joint.kind(), JointKind::Revolute | JointKind::Continuous)
}

/// True for a joint that the file may place outside the origin of its child.
fn can_have_pose(joint: &Joint) -> bool {
    match joint.kind() {
        JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic | JointKind::Spherical => true,
        JointKind::Fixed | JointKind::Planar | JointKind::Floating => false,
    }
}

/// Kind of the joint of the file for two joints in a row; `None` if there is none.
fn pair_kind(mechanism: &Mechanism, first: JointId, second: JointId) -> Option<ChainKind> {
    let [one, two] = [first, second].map(|id| mechanism.joint(id));
    if one.armature().iter().chain(two.armature()).any(|armature| *armature != 0.0) {
        return None;
    }
    // Axis of the first joint in the frame of the second.
    let axis = two.origin().inverse_vector(one.axis());
    let distance = two.origin().translation;
    if is_rotation(one) && is_rotation(two) {
        let is_common = distance.norm() <= COMMON_POINT * mechanism.characteristic_length();
        let kind = if axis.dot(two.axis()).abs() <= RIGHT_ANGLE {
            ChainKind::Universal
        } else {
            ChainKind::Revolute2
        };
        return is_common.then_some(kind);
    }
    let follows = two
        .mimic()
        .is_some_and(|mimic| mimic.master == first && mimic.offset == 0.0 && mimic.multiplier != 0.0);
    let is_screw = is_rotation(one)
        && two.kind() == JointKind::Prismatic
        && two.limits().is_none()
        && follows
        && axis == *two.axis()
        && distance == Vector3::zeros();
    is_screw.then_some(ChainKind::Screw)
}
