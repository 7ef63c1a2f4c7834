//! SDF `<joint>` in a `<gazebo>` of the robot: an additional joint that closes a loop.
//!
//! SDF gives the joint frame relative to the child link. The frame on the parent link follows from the pose with all
//! joints at 0, in which the loop is therefore closed. Source: SDFormat 1.11, joint.sdf, and sdformat's
//! `parser_urdf.cc`, which copies the element into the model.

use crate::reading::limits::{MAX_RELATION_PATH, MIN_AXIS_COMPONENT, OBLIQUE_PINS};
use crate::reading::report::{Place, Report, quoted};
use crate::reading::xml::{Node, text_of};
use crate::urdf::elements::joints::joint::JointText;
use crate::urdf::elements::link::read_name;
use crate::urdf::elements::numbers::parse_numbers;
use crate::urdf::elements::sdf_values;
use crate::urdf::elements::survey::{child, refuse_gazebo_joint as refuse};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, JointDescription, JointKind, LinkDescription, Problem,
    RelationDescription, Severity,
};
use percuss_spatial::{Transform, Vector3};
use std::collections::{HashMap, HashSet};

/// SDF name of the model frame, which coincides with the root link's frame.
const MODEL: &str = "__model__";
const WORLD: &str = "world";

/// Largest distance between the axis of a screw and that of its hinge, m, for links of a meter: files have six decimals.
const SCREW_AXIS_OFFSET: f64 = 1e-6;

/// True for a joint between the world and the root link: the joint fixes the model to the world and closes no loop. A joint
/// of this kind that is not fixed is an error, because the root would move.
pub(crate) fn fixes_root_to_world(
    node: Node<'_>,
    is_root: impl Fn(&str) -> bool,
    report: &mut Report,
) -> bool {
    let [parent, child] =
        ["parent", "child"].map(|tag| child(node, tag).and_then(text_of).unwrap_or_default());
    let root = match (parent.trim_ascii(), child.trim_ascii()) {
        (WORLD, root) | (root, WORLD) => root,
        _ => return false,
    };
    if !is_root(root) {
        return false;
    }
    if node.attribute("type") == Some("fixed") {
        report.note("gazebo-joint", Place::Element(node), || {
            format!("the joint fixes the root link {} to the world, as a fixed base does", quoted(root))
        });
    } else {
        refuse(node, report, || {
            format!(
                "it moves the root link {} on the world; make it a <joint> from a link \"world\" without \
                 mass",
                quoted(root)
            )
        });
    }
    true
}

/// True for a joint to one of the links or models that a `<gazebo>` adds.
pub(crate) fn joins_any(node: Node<'_>, added: &HashSet<&str>) -> bool {
    ["parent", "child"].iter().any(|tag| {
        let name = child(node, tag).and_then(text_of).unwrap_or_default();
        added.contains(name.trim_ascii().split("::").next().unwrap_or_default())
    })
}

/// True for a screw or a gearbox: a relation between joints of the tree, or a screw that closes a loop.
pub(crate) fn is_relation(node: Node<'_>) -> bool {
    matches!(node.attribute("type"), Some("screw" | "gearbox"))
}

/// Frames of links and tree joints relative to the root link, with all joints at 0. Angles that round multiples of π/12 are exact: loops
/// of the file may depend on each other only with exact angles.
pub(crate) struct ZeroPoseFrames<'j, 'a> {
    /// The joint of the tree above each link.
    above: HashMap<&'a str, &'j JointText<'a>>,
    links: HashMap<&'a str, Transform<f64>>,
    /// Child link of each tree joint. The SDF frame of a URDF joint is the frame of its child.
    children: HashMap<&'a str, &'a str>,
}

impl<'j, 'a> ZeroPoseFrames<'j, 'a> {
    /// Computes the frames of all child links of `joints`; each frame is computed once.
    pub fn new(joints: &'j [JointText<'a>]) -> Self {
        // The first joint to a link belongs to the tree; later joints to the same link close loops.
        let mut above: HashMap<&str, &JointText<'a>> = HashMap::new();
        for joint in joints {
            above.entry(joint.child).or_insert(joint);
        }
        let tree = || {
            joints
                .iter()
                .filter(|joint| above.get(joint.child).is_some_and(|first| std::ptr::eq(*first, *joint)))
        };
        let mut links = HashMap::new();
        for joint in tree() {
            let mut path = Vec::new();
            let mut current = joint.child;
            // The builder reports cycles of links; the length bound ends the walk.
            while let Some(joint) = above.get(current)
                && !links.contains_key(current)
                && path.len() <= joints.len()
            {
                path.push(*joint);
                current = joint.parent;
            }
            let mut frame = links.get(current).copied().unwrap_or_else(Transform::identity);
            for joint in path.into_iter().rev() {
                frame = frame * joint.origin.unrounded;
                links.insert(joint.child, frame);
            }
        }
        let children = tree().map(|joint| (joint.name, joint.child)).collect();
        Self { above, links, children }
    }

    /// Joints with a position that move `second` against `first`, each with the sign of its motion; `None` for a path without end, or a long one.
    fn joints_between(&self, first: &str, second: &str) -> Option<Vec<(&'j JointText<'a>, f64)>> {
        let path = |link: &str| {
            let mut joints = Vec::new();
            let mut current = link;
            while let Some(joint) = self.above.get(current) {
                joints.push(*joint);
                current = joint.parent;
                if joints.len() > MAX_RELATION_PATH {
                    return None;
                }
            }
            Some(joints)
        };
        let (mut up, mut down) = (path(first)?, path(second)?);
        while let (Some(a), Some(b)) = (up.last(), down.last())
            && std::ptr::eq(*a, *b)
        {
            up.pop();
            down.pop();
        }
        let signed =
            up.into_iter().map(|joint| (joint, -1.0)).chain(down.into_iter().map(|joint| (joint, 1.0)));
        Some(signed.filter(|(joint, _)| joint.kind.dofs() > 0).collect())
    }

    /// X_rl, link to root link. Identity for the root link (no parent joint) and for the world.
    pub fn link_frame(&self, link: &str) -> Transform<f64> {
        self.links.get(link).copied().unwrap_or_else(Transform::identity)
    }

    /// X_rf of the model, a link or a tree joint; `None` for an unknown name.
    fn named_frame(&self, frame: &str, links: &HashMap<&str, usize>) -> Option<Transform<f64>> {
        match self.children.get(frame) {
            _ if frame == MODEL => Some(Transform::identity()),
            _ if links.contains_key(frame) => Some(self.link_frame(frame)),
            Some(child) => Some(self.link_frame(child)),
            None => None,
        }
    }
}

/// Screw that closes a loop: a massless nut turns on the first link, a second one advances on it with the angle and is fixed to the other
/// link.
pub(crate) struct ScrewLoop {
    pub links: [LinkDescription; 2],
    pub joints: [JointDescription; 2],
    pub closure: ClosureDescription,
}

/// Reads SDF joints as closures.
pub(crate) struct GazeboJointReader<'f, 'a> {
    pub zero_pose: &'f ZeroPoseFrames<'f, 'a>,
    /// Index of each link by name.
    pub links: &'f HashMap<&'a str, usize>,
}

impl<'a> GazeboJointReader<'_, 'a> {
    /// Description of the closure, with finite numbers.
    pub fn read_closure(&self, node: Node<'a>, report: &mut Report) -> ClosureDescription {
        let name = read_name(node, report).to_owned();
        let kind = read_joint_type(node, report);
        let [predecessor, successor] = ["parent", "child"].map(|tag| read_link_name(node, tag, report));
        let x_rc = self.zero_pose.link_frame(&successor);
        let x_rj = self.read_joint_frame(node, &x_rc, report);
        let kind_with_axis = kind.filter(|kind| kind.has_axis());
        let axis = self.read_axis(node, "axis", &x_rj, kind_with_axis, report);
        let universal = kind.filter(|kind| *kind == ClosureKind::Universal);
        let axis2 = self.read_axis(node, "axis2", &x_rj, universal, report);
        if universal.is_some() && axis.normalize().dot(&axis2.normalize()).abs() > OBLIQUE_PINS {
            refuse(node, report, || {
                "the two axes of a universal joint are at right angles here; these are not".to_owned()
            });
        }
        if let Some(kind) = kind {
            report.note("gazebo-joint", Place::Element(node), || {
                format!(
                    "the joint inside <gazebo> is read as a {} loop, placed on {} and held by {} as drawn",
                    kind.name(),
                    quoted(&successor),
                    quoted(&predecessor)
                )
            });
        }
        ClosureDescription {
            name,
            kind: kind.unwrap_or(ClosureKind::Fixed),
            predecessor_frame: self.zero_pose.link_frame(&predecessor).inverse() * x_rj,
            predecessor,
            successor_frame: x_rc.inverse() * x_rj,
            successor,
            axis,
            axis2,
            distance: None,
        }
    }

    /// Relation between the joints that a screw or a gearbox couples. If the path between its links holds other joints, which the relation
    /// would leave free, a screw is added to `screws`, and a gearbox is warned about.
    pub fn read_relation(
        &self,
        node: Node<'a>,
        screws: &mut Vec<ScrewLoop>,
        report: &mut Report,
    ) -> Option<RelationDescription> {
        let name = read_name(node, report).to_owned();
        let [parent, child] = ["parent", "child"].map(|tag| read_link_name(node, tag, report));
        let x_rj = self.read_joint_frame(node, &self.zero_pose.link_frame(&child), report);
        let hinge = Some(ClosureKind::Revolute);
        let axes = ["axis", "axis2"].map(|tag| {
            let kind = hinge.filter(|_| tag == "axis" || node.attribute("type") == Some("gearbox"));
            x_rj.vector(&self.read_axis(node, tag, &x_rj, kind, report).normalize())
        });
        let number = |tag| child_number(node, tag);
        let terms = if node.attribute("type") == Some("screw") {
            match sdf_values::screw_advance(number("screw_thread_pitch"), number("thread_pitch")) {
                Ok(advance) => {
                    let ends = [parent.as_str(), &child];
                    let terms = self.screw_terms(ends, &axes[0], &x_rj.translation, advance);
                    if terms.is_none() {
                        screws.push(self.screw_loop(&name, ends, &x_rj, &axes[0], advance));
                        report.note("gazebo-joint", Place::Element(node), || {
                            format!(
                                "the screw is read as a loop: \"{name}\" turns a massless nut on {}, and \"{name}/advance\" moves it",
                                quoted(&parent)
                            )
                        });
                    }
                    return Some(RelationDescription { name, terms: terms?, constant: 0.0, curve: None });
                }
                Err((code, defect)) => {
                    report.error(code, Place::Element(node), || defect.to_owned());
                    return None;
                }
            }
        } else {
            report.add_once(Severity::Warning, "gearbox", "gearbox".to_owned(), Place::Element(node), || {
                sdf_values::GEARBOX.to_owned()
            });
            let reference = read_link_name(node, "gearbox_reference_body", report);
            let ratio = number("gearbox_ratio").unwrap_or(1.0);
            self.gearbox_terms(&reference, [&parent, &child], &axes, ratio)
        };
        if terms.is_none() {
            report.warning("gazebo-joint", Place::Element(node), || {
                "the joint is not read, and its coupling is missing here: a gearbox is read \
                 between links that one hinge each, with its axes, connects to <gearbox_reference_body>. \
                 Write a <relation> of the joints \
                 instead: factor 1 for the hinge of the child and the ratio for that of the parent"
                    .to_owned()
            });
        }
        Some(RelationDescription { name, terms: terms?, constant: 0.0, curve: None })
    }

    /// Sign of a joint's motion about or along a direction in the root frame; `None` if the two are not parallel.
    fn sign_along(&self, joint: &JointText<'_>, direction: &Vector3<f64>) -> Option<f64> {
        let own = self.zero_pose.link_frame(joint.child).vector(&joint.axis).try_normalize(0.0)?;
        let cosine = own.dot(direction);
        ((cosine.abs() - 1.0).abs() <= sdf_values::PARALLEL_AXES).then(|| cosine.signum())
    }

    /// s_p q_p = advance · s_r q_r for the slide p and the hinge r that move the second link against the first.
    fn screw_terms(
        &self,
        [first, second]: [&str; 2],
        axis: &Vector3<f64>,
        point: &Vector3<f64>,
        advance: f64,
    ) -> Option<Vec<(String, f64)>> {
        let mut joints = self.zero_pose.joints_between(first, second)?;
        joints.sort_by_key(|(joint, _)| joint.kind != JointKind::Prismatic);
        let [(slide, along), (hinge, about)] = joints[..] else { return None };
        let off = self.zero_pose.link_frame(hinge.child).translation - point;
        let is_screw = slide.kind == JointKind::Prismatic
            && is_hinge(hinge)
            && off.cross(axis).norm() <= SCREW_AXIS_OFFSET * (1.0 + off.norm());
        let [along, about] = [along * self.sign_along(slide, axis)?, about * self.sign_along(hinge, axis)?];
        is_screw.then(|| vec![(slide.name.to_owned(), along), (hinge.name.to_owned(), -advance * about)])
    }

    /// Screw between two links that the tree connects in another way. `axis`: in the root frame.
    fn screw_loop(
        &self,
        name: &str,
        [first, second]: [&str; 2],
        x_rj: &Transform<f64>,
        axis: &Vector3<f64>,
        advance: f64,
    ) -> ScrewLoop {
        let axis = x_rj.inverse_vector(axis).into();
        let [nut, advanced] = ["nut", "advance"].map(|part| format!("{name}/{part}"));
        let in_link = |link| self.zero_pose.link_frame(link).inverse() * *x_rj;
        let turn = JointDescription::new(name, JointKind::Continuous, first, &nut);
        let slide = JointDescription::new(&advanced, JointKind::Prismatic, &nut, &advanced);
        let fixed = ClosureDescription::new(&nut, ClosureKind::Fixed, &advanced, second);
        ScrewLoop {
            joints: [turn.origin(in_link(first)).axis(axis), slide.axis(axis).mimic(name, advance, 0.0)],
            closure: ClosureDescription { successor_frame: in_link(second), ..fixed },
            links: [nut, advanced].map(LinkDescription::massless),
        }
    }

    /// s₂ q₂ = −ratio · s₁ q₁ for the hinges of the parent and the child on the reference link.
    fn gearbox_terms(
        &self,
        reference: &str,
        ends: [&str; 2],
        axes: &[Vector3<f64>; 2],
        ratio: f64,
    ) -> Option<Vec<(String, f64)>> {
        let mut terms = Vec::new();
        for ((end, axis), factor) in ends.iter().zip(axes).zip([ratio, 1.0]) {
            let joints = self.zero_pose.joints_between(reference, end)?;
            let [(hinge, sign)] = joints[..] else { return None };
            let sign = sign * self.sign_along(hinge, axis)?;
            is_hinge(hinge).then_some(())?;
            terms.push((hinge.name.to_owned(), factor * sign));
        }
        (terms[0].0 != terms[1].0).then_some(terms)
    }

    /// X_rj. The pose is relative to the child link (X_rc) unless another frame is named.
    fn read_joint_frame(&self, node: Node<'a>, x_rc: &Transform<f64>, report: &mut Report) -> Transform<f64> {
        let Some(pose) = child(node, "pose") else { return *x_rc };
        let base = pose.attribute("relative_to").or_else(|| pose.attribute("frame"));
        let base = self.frame_or_default(pose, base, x_rc, report);
        let text = text_of(pose).unwrap_or_default();
        let format = pose.attribute("rotation_format").unwrap_or("euler_rpy");
        let degrees = pose.attribute("degrees").is_some_and(|text| read_boolean(pose, text, report));
        let relative = sdf_values::parse_pose(text, format, degrees)
            .map_err(|defect| refuse(pose, report, || defect))
            .ok();
        base * relative.unwrap_or_else(Transform::identity)
    }

    /// X_rf, named frame to root link; `default` if there is no name or the name is unknown.
    fn frame_or_default(
        &self,
        node: Node<'_>,
        named: Option<&str>,
        default: &Transform<f64>,
        report: &mut Report,
    ) -> Transform<f64> {
        let Some(frame) = named.map(str::trim_ascii).filter(|frame| !frame.is_empty()) else {
            return *default;
        };
        self.zero_pose.named_frame(frame, self.links).unwrap_or_else(|| {
            refuse(node, report, || {
                format!(
                    "the frame {} is not known; expected {MODEL}, or the name of a link or of a joint of \
                     the tree",
                    quoted(frame)
                )
            });
            *default
        })
    }

    /// Axis in the joint frame. The default of SDF is 0 0 1.
    fn read_axis(
        &self,
        node: Node<'a>,
        tag: &'static str,
        x_rj: &Transform<f64>,
        kind: Option<ClosureKind>,
        report: &mut Report,
    ) -> Vector3<f64> {
        let Some(element) = child(node, tag) else {
            if let Some(kind) = kind.filter(|_| tag == "axis2") {
                refuse(node, report, || format!("a {} joint has no <{tag}>", kind.name()));
            } else if let Some(kind) = kind {
                report.note("default-axis", Place::Element(node), || {
                    format!("the {} joint has no <{tag}>: 0 0 1 is taken, as SDF says", kind.name())
                });
            }
            return Vector3::z();
        };
        let old = child(element, "use_parent_model_frame");
        let in_model_frame =
            old.is_some_and(|old| read_boolean(old, text_of(old).unwrap_or_default(), report));
        let given = child(element, "xyz");
        let expressed_in = given.and_then(|xyz| xyz.attribute("expressed_in"));
        if in_model_frame && expressed_in.is_some() {
            refuse(element, report, || {
                "<use_parent_model_frame> and expressed_in are both given; leave one of them out".to_owned()
            });
        }
        let frame = if in_model_frame { Some(MODEL) } else { expressed_in };
        let x_rf = self.frame_or_default(given.unwrap_or(element), frame, x_rj, report);
        let axis =
            given.and_then(|xyz| parse_element_numbers::<3>(xyz, text_of(xyz).unwrap_or_default(), report));
        let axis: Vector3<f64> = axis.map_or_else(Vector3::z, Into::into);
        if kind.is_some() && axis.amax() < MIN_AXIS_COMPONENT {
            let problem = Problem::ZeroAxis;
            report.add_problem(Place::Element(element), &problem);
        }
        x_rj.inverse_vector(&x_rf.vector(&axis))
    }
}

/// Kind of closure for the SDF joint type; `None` if invalid.
fn read_joint_type(node: Node<'_>, report: &mut Report) -> Option<ClosureKind> {
    let read = [
        ("revolute", ClosureKind::Revolute),
        ("continuous", ClosureKind::Revolute),
        ("prismatic", ClosureKind::Prismatic),
        ("ball", ClosureKind::Spherical),
        ("universal", ClosureKind::Universal),
        ("revolute2", ClosureKind::Universal),
        ("fixed", ClosureKind::Fixed),
    ];
    let given = node.attribute("type").unwrap_or_default();
    let kind = read.iter().find(|(word, _)| *word == given).map(|(_, kind)| *kind);
    if kind.is_none() {
        refuse(node, report, || {
            let words = read.map(|(word, _)| word).join(", ");
            format!("its type is {}; {words}, screw and gearbox are read", quoted(given))
        });
    }
    kind
}

/// Link name in the text of a child element; empty if absent.
fn read_link_name(node: Node<'_>, tag: &'static str, report: &mut Report) -> String {
    let element = child(node, tag);
    let name = element.and_then(text_of).unwrap_or_default();
    let name = name.trim_ascii();
    if name.is_empty() {
        refuse(element.unwrap_or(node), report, || {
            format!("it has no <{tag}>LINK</{tag}>, with the link's name as text")
        });
    }
    name.to_owned()
}

/// True for a joint with one rotation.
fn is_hinge(joint: &JointText<'_>) -> bool {
    matches!(joint.kind, JointKind::Revolute | JointKind::Continuous)
}

/// Number in the text of a child element; `None` if the element is absent or holds no number.
fn child_number(node: Node<'_>, tag: &'static str) -> Option<f64> {
    parse_numbers::<1>(text_of(child(node, tag)?)?).ok().map(|[value]| value)
}

/// Boolean value in SDF notation; false, with an error, for another text.
fn read_boolean(node: Node<'_>, text: &str, report: &mut Report) -> bool {
    let value = sdf_values::parse_boolean(text);
    if value.is_none() {
        refuse(node, report, || format!("{} is neither true nor false", quoted(text.trim_ascii())));
    }
    value.unwrap_or(false)
}

/// Parses the N numbers in the text of an element; `None` if invalid.
fn parse_element_numbers<const N: usize>(
    node: Node<'_>,
    text: &str,
    report: &mut Report,
) -> Option<[f64; N]> {
    let values = parse_numbers::<N>(text);
    if let Err(defect) = &values {
        report
            .error("bad-number", Place::Element(node), || format!("{}: {defect}", quoted(text.trim_ascii())));
    }
    values.ok()
}
