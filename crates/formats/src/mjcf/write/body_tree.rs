//! Links and joints as nested bodies.

use super::error::MjcfError;
use super::moments::{LEAST_INERTIA, check_moments, raise_moments, round_moments};
use super::rotors::{Rotor, rotor_inertial};
use crate::writing::changes::Change;
use crate::writing::structure::{drawn_poses, held_links, immovable_links, is_massless};
use crate::writing::xml_text::{append, escape_attribute, format_number, format_numbers, format_vector};
use nalgebra::{Rotation3, UnitQuaternion};
use percuss_mechanism::{Closure, Inertial, Joint, JointId, JointKind, Limits, LinkId, Mechanism};
use percuss_spatial::{Matrix3, Transform, Vector3, plane_basis};

/// Largest depth of nested bodies: readers bound the nesting of elements.
const MAX_DEPTH: usize = 200;

/// Least moment of a body that is written by its inertia matrix, relative to the largest moment.
const THIN_ROD: f64 = 1e-9;
/// Least principal moment of a body that is written as an inertia matrix, kg·m². MuJoCo's eigenvalue iteration stops at off-diagonal
/// entries of 1e-12 kg·m² (kEigEPS); this limit is ten times larger.
const LEAST_DECOMPOSED: f64 = 1e-11;

/// Bodies of the file: one per link, except massless links whose joints belong to the body of their child.
pub(super) struct BodyTree<'m> {
    pub mechanism: &'m Mechanism,
    /// Pose of every link in the world with all joints at 0.
    pub world_poses: Vec<Transform<f64>>,
    /// Inertia of each link; the moments of a thin rod and of a point mass are not 0.
    pub inertials: Vec<Option<Inertial>>,
    /// Fraction of the inertia of each link in its own body: 1, or less for a split link.
    pub share: Vec<f64>,
    /// Joints of the body of each link, from the parent to the link; `None` for a merged link.
    chains: Vec<Option<Vec<JointId>>>,
    /// Further lines within each body: sites, and halves of other links.
    pub contents: Vec<String>,
    /// Further lines within the world.
    pub world_contents: String,
    /// Lines of the sections of constraints.
    pub tendons: String,
    pub equalities: String,
    /// Form of each link that is a rotor.
    pub rotors: Vec<Option<Rotor>>,
    pub changes: Vec<Change>,
    /// Closures whose second halves are within the body of a link, or within the world, in the order of the file.
    halves: Vec<(Option<LinkId>, usize)>,
    /// True if the root link is the world.
    pub root_is_world: bool,
    /// The only joint whose limits are written, with their attributes; `None` for the limits of all joints.
    only_limit: Option<(JointId, String)>,
    /// True if the springs and dampers of the joints are written.
    pub has_springs: bool,
}

/// Joints of MuJoCo that belong together.
pub(super) enum Coordinates {
    /// Joints for a joint of the mechanism; axes of its child as drawn in those of the body.
    Joint {
        /// Joint of the mechanism.
        joint: JointId,
        /// Rotation from the axes of the joint's child to those of the body, all joints at 0.
        in_body: Matrix3<f64>,
    },
    /// Free joint of a link.
    Free(LinkId),
    /// Joints of the second half of a link for a closure, by its number.
    Half(usize),
}

impl<'m> BodyTree<'m> {
    /// Finds the bodies.
    ///
    /// # Errors
    /// [`MjcfError`] for links that MuJoCo refuses.
    pub fn new(mechanism: &'m Mechanism) -> Result<Self, MjcfError> {
        let count = mechanism.links().len();
        let root = mechanism.root();
        let world_poses = drawn_poses(mechanism);
        let merged = merged_links(mechanism);
        let rotors: Vec<_> = mechanism.link_ids().map(|link| Rotor::of_link(mechanism, link)).collect();
        let is_merged = |link: LinkId| merged[link.index()];
        let mut chains = Vec::with_capacity(count);
        for link in mechanism.link_ids() {
            let name = mechanism.link(link).name();
            if name == "world" && link != root {
                return Err(MjcfError::new(
                    "link",
                    name,
                    "MuJoCo reserves this name for the ground; rename the link",
                ));
            }
            if is_merged(link) || matches!(rotors[link.index()], Some(Rotor::Tendon(_) | Rotor::Follower)) {
                chains.push(None);
                continue;
            }
            let mut chain = Vec::new();
            let mut current = link;
            while let Some(id) = mechanism.parent_joint(current) {
                chain.push(id);
                current = mechanism.joint(id).parent();
                if !is_merged(current) {
                    break;
                }
            }
            chain.reverse();
            chains.push(Some(chain));
        }
        let mut tree = Self {
            mechanism,
            world_poses,
            inertials: mechanism.links().iter().map(|link| link.inertial().copied()).collect(),
            share: vec![1.0; count],
            chains,
            contents: vec![String::new(); count],
            world_contents: String::new(),
            tendons: String::new(),
            equalities: String::new(),
            rotors,
            changes: Vec::new(),
            halves: Vec::new(),
            root_is_world: mechanism.link(root).name() == "world",
            only_limit: None,
            has_springs: true,
        };
        let at_rest = immovable_links(mechanism);
        let mut errors = Vec::new();
        for link in mechanism.link_ids() {
            let Some(chain) = &tree.chains[link.index()] else { continue };
            let name = mechanism.link(link).name();
            if let (Some(Rotor::Body), [joint]) = (tree.rotors[link.index()], &chain[..]) {
                tree.inertials[link.index()] = Some(rotor_inertial(mechanism.joint(*joint)));
                tree.changes.push(Change::changed(
                    "link",
                    name,
                    "a body whose mass is the armature of its joint",
                    "MuJoCo leaves the armature of a tendon over several branches out of the mass matrix",
                ));
                continue;
            }
            if let Some(inertial) = tree.inertials[link.index()].as_mut() {
                round_moments(inertial, name);
            }
            let inertial = tree.inertials[link.index()].as_ref();
            let refused =
                check_body(mechanism, link, chain, inertial).and_then(|()| check_moments(inertial, name));
            if at_rest[link.index()] {
                if refused.is_err() {
                    tree.inertials[link.index()] = None;
                    let reason = "MuJoCo refuses moments with A + B < C; the link cannot move, so its inertia has no effect";
                    tree.changes.push(Change::lost("link", name, "its inertia", reason));
                }
                continue;
            }
            if let Err(error) = refused {
                errors.push(error);
                continue;
            }
            // MuJoCo accepts moments of 0 of a body without joints of its own.
            let moves = chain.iter().any(|id| mechanism.joint(*id).kind().dofs() > 0);
            if let Some(inertial) = tree.inertials[link.index()].as_mut().filter(|_| moves)
                && let Some(least) = raise_moments(inertial, mechanism.characteristic_length())
            {
                tree.changes.push(Change::changed(
                    "link",
                    name,
                    format!("moments of inertia below {least:.1e} kg·m² are raised to this value"),
                    "MuJoCo refuses moments of 0",
                ));
            }
        }
        match MjcfError::combined(errors) {
            Some(error) => Err(error),
            None => Ok(tree),
        }
    }

    /// True unless the link is merged into the body of its child.
    pub fn has_body(&self, link: LinkId) -> bool {
        self.chains[link.index()].is_some()
    }

    /// Writes the limits of one joint only, with the given attributes. The limits of other joints are lost.
    pub fn limit_only(&mut self, joint: JointId, attributes: String) {
        let mechanism = self.mechanism;
        let lost = mechanism.joint_ids().filter(|id| *id != joint && mechanism.joint(*id).limits().is_some());
        self.changes.extend(lost.map(|id| {
            Change::lost(
                "joint",
                mechanism.joint(id).name(),
                "its limits",
                "the only limit in the file is the stop",
            )
        }));
        self.only_limit = Some((joint, attributes));
    }

    /// Attributes of the limits of a joint.
    fn limit_attributes(&self, joint: JointId) -> String {
        match &self.only_limit {
            Some((limited, attributes)) if *limited == joint => attributes.clone(),
            Some(_) => String::new(),
            None => self.mechanism.joint(joint).limits().filter(has_range).map_or(String::new(), |limits| {
                format!(" range=\"{} {}\"", format_number(limits.lower), format_number(limits.upper))
            }),
        }
    }

    /// Attributes of the limits and of the spring of a joint.
    fn further_attributes(&self, joint: JointId) -> String {
        let mut attributes = self.limit_attributes(joint);
        if let Some(spring) = self.mechanism.joint(joint).spring().filter(|_| self.has_springs) {
            let names = ["stiffness", "damping", "springref"];
            let values = [spring.stiffness, spring.damping, spring.reference];
            for (name, value) in names.into_iter().zip(values).filter(|(_, value)| *value != 0.0) {
                append!(attributes, " {name}=\"{}\"", format_number(value));
            }
        }
        attributes
    }

    /// Appends a line within the body of a link; within the world for `None`.
    pub fn append_content(&mut self, link: Option<LinkId>, line: &str) {
        match link.filter(|link| !self.is_world(*link)) {
            Some(link) => self.contents[link.index()].push_str(line),
            None => self.world_contents.push_str(line),
        }
    }

    /// Appends the second half of a link for a closure within the body of a link; within the world for `None`.
    pub fn append_half(&mut self, link: Option<LinkId>, closure: &Closure, lines: &str) {
        self.append_content(link, lines);
        let number = self.mechanism.closures().iter().position(|other| other.name() == closure.name());
        let holder = link.filter(|link| !self.is_world(*link));
        self.halves.extend(number.map(|number| (holder, number)));
    }

    /// True if the link is the world of MuJoCo.
    pub fn is_world(&self, link: LinkId) -> bool {
        self.root_is_world && link == self.mechanism.root()
    }

    /// Joints of the second halves within a body, or within the world.
    fn half_coordinates(&self, link: Option<LinkId>) -> impl Iterator<Item = Coordinates> + '_ {
        self.halves
            .iter()
            .filter(move |(holder, _)| *holder == link)
            .map(|(_, number)| Coordinates::Half(*number))
    }

    /// Writes all bodies. Returns their joints in the order of `qpos`.
    ///
    /// # Errors
    /// [`MjcfError`] for joints without a form in MJCF, and for bodies nested too deep.
    pub fn append_bodies(&self, out: &mut String) -> Result<Vec<Coordinates>, MjcfError> {
        let mut coordinates = Vec::new();
        let root = self.mechanism.root();
        // Links to open, and the depth of bodies to close.
        enum Step {
            Open(LinkId, usize),
            Close(usize),
        }
        let mut steps = Vec::new();
        let children = |link: LinkId| self.child_bodies(link);
        if self.root_is_world {
            steps.extend(children(root).into_iter().rev().map(|child| Step::Open(child, 0)));
        } else {
            // Floating bodies belong to the world: the root does not move.
            let is_floating = |link: &LinkId| self.is_free(*link);
            let floating = children(root).into_iter().filter(is_floating);
            steps.extend(floating.rev().map(|child| Step::Open(child, 0)).collect::<Vec<_>>());
            steps.push(Step::Open(root, 0));
        }
        while let Some(step) = steps.pop() {
            let (link, depth) = match step {
                Step::Close(depth) => {
                    append!(out, "{}</body>\n", indent(depth));
                    continue;
                }
                Step::Open(link, depth) => (link, depth),
            };
            if depth > MAX_DEPTH {
                let name = self.mechanism.link(link).name();
                return Err(MjcfError::new(
                    "link",
                    name,
                    format!("bodies are nested deeper than {MAX_DEPTH} levels"),
                ));
            }
            self.open_body(link, depth, out)?;
            coordinates.extend(self.body_coordinates(link));
            steps.push(Step::Close(depth));
            let moves_with_root = |child: &LinkId| link != root || !self.is_free(*child);
            let below = children(link).into_iter().filter(moves_with_root);
            steps.extend(below.rev().map(|child| Step::Open(child, depth + 1)).collect::<Vec<_>>());
        }
        for line in self.world_contents.lines() {
            append!(out, "{}{line}\n", indent(0));
        }
        coordinates.extend(self.half_coordinates(None));
        Ok(coordinates)
    }

    /// Joints of the body of a link and of the halves within it.
    fn body_coordinates(&self, link: LinkId) -> Vec<Coordinates> {
        let own = self.world_poses[link.index()];
        let is_free = self.is_free(link);
        let of_joint = |&joint: &JointId| match is_free {
            true => Coordinates::Free(link),
            false => Coordinates::Joint {
                joint,
                in_body: own.rotation.transpose()
                    * self.world_poses[self.mechanism.joint(joint).child().index()].rotation,
            },
        };
        let chain = self.chains[link.index()].as_deref().unwrap_or_default();
        chain.iter().map(of_joint).chain(self.half_coordinates(Some(link))).collect()
    }

    /// Bodies directly below the body of a link, through merged links.
    fn child_bodies(&self, link: LinkId) -> Vec<LinkId> {
        let mechanism = self.mechanism;
        let through = |id: &JointId| {
            let mut child = mechanism.joint(*id).child();
            while self.chains[child.index()].is_none() {
                let Some(below) = mechanism.child_joints(child).first() else { break };
                child = mechanism.joint(*below).child();
            }
            child
        };
        let has_body = |child: &LinkId| self.chains[child.index()].is_some();
        mechanism.child_joints(link).iter().map(through).filter(has_body).collect()
    }

    /// True for a body with a free joint of MuJoCo: a floating joint to the root.
    pub fn is_free(&self, link: LinkId) -> bool {
        let Some([id]) = self.chains[link.index()].as_deref() else { return false };
        let joint = self.mechanism.joint(*id);
        joint.kind() == JointKind::Floating && joint.parent() == self.mechanism.root()
    }

    /// Writes the opening tag and the contents of a body.
    fn open_body(&self, link: LinkId, depth: usize, out: &mut String) -> Result<(), MjcfError> {
        let mechanism = self.mechanism;
        let chain = self.chains[link.index()].as_deref().unwrap_or_default();
        let own = self.world_poses[link.index()];
        let pose = match chain.first() {
            Some(first) => self.world_poses[mechanism.joint(*first).parent().index()].inverse() * own,
            None => Transform::identity(),
        };
        let lead = indent(depth);
        let description = mechanism.link(link);
        let is_rotor = self.rotors[link.index()] == Some(Rotor::Body);
        append!(
            out,
            "{lead}<body name=\"{}\"{}{}>\n",
            escape_attribute(description.name()),
            pose_attributes(&pose),
            // The mass of a rotor has no weight.
            if is_rotor { " gravcomp=\"1\"" } else { "" }
        );
        for &id in chain {
            let joint = mechanism.joint(id);
            // Frame of the joint in the body, with all joints at 0.
            let frame = own.inverse() * self.world_poses[joint.child().index()];
            let lines = if self.is_free(link) {
                free_joint(joint)
            } else {
                joint_lines(joint, &frame, !is_rotor, &self.further_attributes(id))
            };
            for line in lines? {
                append!(out, "{lead}  {line}\n");
            }
        }
        if let Some(inertial) = &self.inertials[link.index()] {
            append!(out, "{lead}  {}\n", inertial_element(inertial, self.share[link.index()]));
        }
        for line in self.contents[link.index()].lines() {
            append!(out, "{lead}  {line}\n");
        }
        Ok(())
    }
}

/// True for limits that MuJoCo accepts.
pub(super) fn has_range(limits: &Limits) -> bool {
    limits.lower < limits.upper
}

/// Per link: true if it has no body of its own, which holds for a massless moving link with one child and no closure.
fn merged_links(mechanism: &Mechanism) -> Vec<bool> {
    let held = held_links(mechanism);
    let mut merged = vec![false; mechanism.links().len()];
    for &link in mechanism.order() {
        let Some(own) = mechanism.parent_joint(link).map(|id| mechanism.joint(id)) else { continue };
        let [below] = mechanism.child_joints(link) else { continue };
        let is_free = [own.kind(), mechanism.joint(*below).kind()].contains(&JointKind::Floating);
        // A link that does not move keeps its body, unless it is within a chain.
        let moves = own.kind() != JointKind::Fixed || merged[own.parent().index()];
        merged[link.index()] = moves && !is_free && is_massless(mechanism, link) && !held[link.index()];
    }
    merged
}

/// Returns an error if MuJoCo refuses the joints or the mass of a body.
fn check_body(
    mechanism: &Mechanism,
    link: LinkId,
    chain: &[JointId],
    inertial: Option<&Inertial>,
) -> Result<(), MjcfError> {
    let name = mechanism.link(link).name();
    let kinds = || chain.iter().map(|id| mechanism.joint(*id).kind());
    let dofs: usize = kinds().map(JointKind::dofs).sum();
    if dofs > 6 {
        let reason =
            format!("MuJoCo allows 6 degrees of freedom between two bodies with mass; here are {dofs}");
        return Err(MjcfError::new("link", name, reason));
    }
    let moving: Vec<JointKind> = kinds().filter(|kind| kind.dofs() > 0).collect();
    let is_ball_before =
        |pair: &[JointKind]| pair[0] == JointKind::Spherical && pair[1] != JointKind::Prismatic;
    if moving.windows(2).any(is_ball_before) {
        let reason = "MuJoCo allows no rotation after a ball joint without a mass between them";
        return Err(MjcfError::new("link", name, reason));
    }
    let mass = inertial.map_or(0.0, |inertial| inertial.mass);
    if !moving.is_empty() && mass < LEAST_INERTIA {
        let reason = format!(
            "MuJoCo refuses a moving body without mass ({mass} kg), and a small mass would be another mechanism; give the link a mass, or \
             join it to another by a fixed joint"
        );
        return Err(MjcfError::new("link", name, reason));
    }
    Ok(())
}

/// `<inertial>` with a share of the mass and inertia. Principal moments are written if one of them is very small, absolutely or relative to
/// the largest one: MuJoCo's decomposition of a matrix could return a negative moment.
pub(super) fn inertial_element(inertial: &Inertial, share: f64) -> String {
    let i = inertial.about_com * share;
    let head = format!(
        "<inertial pos=\"{}\" mass=\"{}\"",
        format_vector(&inertial.com),
        format_number(inertial.mass * share)
    );
    let principal = i.symmetric_eigen();
    if principal.eigenvalues.min() > LEAST_DECOMPOSED.max(THIN_ROD * principal.eigenvalues.max()) {
        let moments = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|at| i[at]);
        return format!("{head} fullinertia=\"{}\"/>", format_numbers(&moments));
    }
    let mut axes = principal.eigenvectors;
    if axes.determinant() < 0.0 {
        axes.column_mut(0).neg_mut();
    }
    let rotation = pose_attributes(&Transform::new(axes, Vector3::zeros()));
    format!("{head}{rotation} diaginertia=\"{}\"/>", format_vector(&principal.eigenvalues))
}

/// Attributes `pos` and `quat`; none for the identity.
pub(super) fn pose_attributes(pose: &Transform<f64>) -> String {
    let mut text = String::new();
    if pose.translation != Vector3::zeros() {
        append!(text, " pos=\"{}\"", format_vector(&pose.translation));
    }
    if pose.rotation != Matrix3::identity() {
        let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(pose.rotation));
        append!(text, " quat=\"{}\"", format_numbers(&[q.w, q.i, q.j, q.k]));
    }
    text
}

fn indent(depth: usize) -> String {
    "  ".repeat(depth + 2)
}

/// Free joint of MuJoCo.
fn free_joint(joint: &Joint) -> Result<Vec<String>, MjcfError> {
    let name = escape_attribute(joint.name());
    let armature = joint.armature();
    if armature.iter().all(|value| *value == 0.0) {
        return Ok(vec![format!("<freejoint name=\"{name}\"/>")]);
    }
    let armature = common_armature(joint, 0..armature.len())?;
    Ok(vec![format!("<joint name=\"{name}\" type=\"free\"{armature}/>")])
}

/// Joints of MuJoCo for a joint whose frame in the body is given; without the armature of a rotor that is a body.
/// `further`: attributes of its limits and of its spring.
fn joint_lines(
    joint: &Joint,
    frame: &Transform<f64>,
    has_armature: bool,
    further: &str,
) -> Result<Vec<String>, MjcfError> {
    let name = escape_attribute(joint.name());
    let anchor = match frame.translation {
        at if at == Vector3::zeros() => String::new(),
        at => format!(" pos=\"{}\"", format_vector(&at)),
    };
    let line = |name: &str, kind: &str, axis: &Vector3<f64>, rest: &str| {
        let axis = format_vector(&frame.vector(axis));
        format!("<joint name=\"{name}\" type=\"{kind}\"{anchor} axis=\"{axis}\"{rest}/>")
    };
    let single = |index: usize| match has_armature {
        true => common_armature(joint, index..index + 1),
        false => Ok(String::new()),
    };
    Ok(match joint.kind() {
        JointKind::Fixed => Vec::new(),
        JointKind::Revolute | JointKind::Continuous => {
            vec![line(&name, "hinge", joint.axis(), &format!("{}{further}", single(0)?))]
        }
        JointKind::Prismatic => vec![line(&name, "slide", joint.axis(), &format!("{}{further}", single(0)?))],
        JointKind::Planar => {
            let (e1, e2) = plane_basis(joint.axis());
            vec![
                line(&format!("{name}/x"), "slide", &e1, &single(0)?),
                line(&format!("{name}/y"), "slide", &e2, &single(1)?),
                line(&format!("{name}/angle"), "hinge", joint.axis(), &single(2)?),
            ]
        }
        JointKind::Spherical => {
            let armature = common_armature(joint, 0..3)?;
            vec![format!("<joint name=\"{name}\" type=\"ball\"{anchor}{armature}/>")]
        }
        JointKind::Floating => {
            // Isotropic armatures do not depend on the axes of the slides.
            let (angular, linear) = (common_armature(joint, 0..3)?, common_armature(joint, 3..6)?);
            let slides = [("x", Vector3::x()), ("y", Vector3::y()), ("z", Vector3::z())];
            let mut lines: Vec<String> = slides
                .iter()
                .map(|(axis, along)| line(&format!("{name}/{axis}"), "slide", along, &linear))
                .collect();
            lines.push(format!("<joint name=\"{name}/ball\" type=\"ball\"{anchor}{angular}/>"));
            lines
        }
    })
}

/// Attribute `armature` of velocities that have one value in MuJoCo.
fn common_armature(joint: &Joint, velocities: std::ops::Range<usize>) -> Result<String, MjcfError> {
    let Some(values) = joint.armature().get(velocities) else { return Ok(String::new()) };
    match values {
        [] => Ok(String::new()),
        [first, rest @ ..] if rest.iter().all(|value| value == first) => {
            Ok(if *first == 0.0 { String::new() } else { format!(" armature=\"{}\"", format_number(*first)) })
        }
        _ => Err(MjcfError::new(
            "joint",
            joint.name(),
            "its armatures differ, and MuJoCo has one value for a ball or free joint; give them the same value",
        )),
    }
}
