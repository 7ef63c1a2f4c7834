//! Walk over the kinematic tree: bodies, frames and replicates.

use crate::mjcf::bodies::body::{Bodies, Body, BodyJoint, JointType, Site};
use crate::mjcf::bodies::geom::{frame_on_line, read_geom};
use crate::mjcf::bodies::inertia::read_inertial;
use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::classes::{ClassId, DefaultKind};
use crate::mjcf::values::models::Models;
use crate::mjcf::values::orientation::{read_orientation, read_pose, rotation_from_euler, unit};
use crate::parts::{SPRING_LEFT_OUT, joint_spring};
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::limits::{LONGEST_NAME, MAX_ELEMENTS_PER_KIND, MAX_TREE_VISITS};
use crate::reading::report::quoted;
use percuss_mechanism::{Severity, SpringDamper};
use percuss_spatial::{Matrix3, Transform, Vector3};

/// Keywords of `type` of a joint.
const JOINT_TYPES: [(&str, JointType); 4] = [
    ("free", JointType::Free),
    ("ball", JointType::Ball),
    ("slide", JointType::Slide),
    ("hinge", JointType::Hinge),
];

/// Position of an element in the tree.
#[derive(Clone)]
struct Parent {
    body: usize,
    /// Frame of the enclosing `<frame>` and `<replicate>` elements in the body.
    frame: Transform<f64>,
    /// Nearest `childclass`.
    class: Option<ClassId>,
    /// Suffix of the names within replicates.
    suffix: String,
    /// True directly within a `<replicate>`, where joints have no body.
    in_replicate: bool,
}

/// Reads all bodies. A tree with too many elements is an error, after which the tree is incomplete.
pub(crate) fn read_bodies(models: &Models<'_>, findings: &mut Findings<'_>) -> Bodies {
    let tree = findings.tree;
    let world = Body {
        element: tree.root(),
        name: "world".to_owned(),
        parent: 0,
        pose: Transform::identity(),
        world_pose: Transform::identity(),
        joints: Vec::new(),
        geoms: Vec::new(),
        inertial: None,
        moving_ancestor: 0,
    };
    let bodies =
        Bodies { bodies: vec![world], body_by_name: [("world".to_owned(), 0)].into(), ..Bodies::default() };
    let mut walker = Walker { tree, models, findings, bodies, visits: 0 };
    let mut has_world = false;
    for section in tree.children_named(tree.root(), "worldbody") {
        has_world = true;
        let class = models.classes(section).named(section, "childclass", walker.findings);
        let parent = Parent {
            body: 0,
            frame: Transform::identity(),
            class,
            suffix: String::new(),
            in_replicate: false,
        };
        walker.walk_children(section, &parent);
    }
    if !has_world {
        walker.findings.error("no-worldbody", tree.root(), || {
            "the model has no <worldbody>, the element that contains the bodies".to_owned()
        });
    }
    walker.bodies
}

struct Walker<'w, 't, 'f> {
    tree: &'t ElementTree,
    models: &'t Models<'t>,
    findings: &'w mut Findings<'f>,
    bodies: Bodies,
    visits: usize,
}

impl<'t> Walker<'_, 't, '_> {
    /// Reads the contents of a body, frame or replicate. The recursion is bounded by the nesting of the elements.
    fn walk_children(&mut self, element: ElementId, parent: &Parent) {
        let tree = self.tree;
        for &child in tree.children(element) {
            if !self.count_visit(child) {
                return;
            }
            match tree.tag(child) {
                "body" => self.read_body(child, parent),
                "frame" => {
                    let frame =
                        read_pose(Attributes::new(tree, child), self.models.settings(child), self.findings);
                    let class = self.models.classes(child).named(child, "childclass", self.findings);
                    let inner = Parent {
                        frame: parent.frame * frame,
                        class: class.or(parent.class),
                        ..parent.clone()
                    };
                    self.walk_children(child, &inner);
                }
                "replicate" => self.replicate(child, parent),
                // Classes of the surrounding model have no effect on an attached one.
                "attach" => self.walk_children(child, &Parent { class: None, ..parent.clone() }),
                "joint" | "freejoint" | "inertial" => self.read_body_part(child, parent),
                "geom" => {
                    let attributes = self.attributes(child, DefaultKind::Geom, parent);
                    let geom =
                        read_geom(attributes, &parent.frame, self.models.settings(child), self.findings);
                    self.bodies.bodies[parent.body].geoms.extend(geom);
                }
                "site" => self.read_site(child, parent),
                // Cameras and lights; the grammar reports other elements.
                _ => {}
            }
        }
    }

    /// Counts a visit; false, with an error, beyond the limit.
    fn count_visit(&mut self, element: ElementId) -> bool {
        self.visits += 1;
        let is_within = self.visits <= MAX_TREE_VISITS && self.bodies.bodies.len() <= MAX_ELEMENTS_PER_KIND;
        if !is_within {
            self.findings.add_once(Severity::Error, "too-complex", "tree", element, || {
                format!(
                    "with all copies of <replicate>, the tree has more than {MAX_ELEMENTS_PER_KIND} bodies or \
                     {MAX_TREE_VISITS} elements"
                )
            });
        }
        is_within
    }

    /// Attributes of an element, with the defaults of its class or of the `childclass` of its body.
    fn attributes(&mut self, element: ElementId, kind: DefaultKind, parent: &Parent) -> Attributes<'t> {
        self.models.attributes(element, kind, parent.class, self.findings)
    }

    /// Name of an element with the suffix of its replicates; empty if absent.
    fn name(&mut self, element: ElementId, parent: &Parent) -> String {
        let name = self.tree.attribute(element, "name").unwrap_or_default();
        if name.is_empty() {
            return String::new();
        }
        if !parent.suffix.is_empty() {
            self.bodies.replicated_names.insert(name.to_owned(), element);
        }
        let length = name.len() + parent.suffix.len();
        if length > LONGEST_NAME {
            self.findings.error("long-name", element, || {
                format!("the name is {length} bytes long; at most {LONGEST_NAME} are read")
            });
            return String::new();
        }
        format!("{name}{}", parent.suffix)
    }

    fn report_duplicate(&mut self, element: ElementId, name: &str) {
        self.findings.error("duplicate-name", element, || {
            format!("the name {} was given before; names must be unique", quoted(name))
        });
    }

    fn read_body(&mut self, element: ElementId, parent: &Parent) {
        let attributes = Attributes::new(self.tree, element);
        let pose = parent.frame * read_pose(attributes, self.models.settings(element), self.findings);
        let name = self.name(element, parent);
        let index = self.bodies.bodies.len();
        if !name.is_empty() && self.bodies.body_by_name.insert(name.clone(), index).is_some() {
            self.report_duplicate(element, &name);
        }
        let is_mocap = attributes.flag("mocap", self.findings).unwrap_or(false);
        if is_mocap {
            self.findings.add_once(Severity::Warning, "mocap", "mocap", element, || {
                "a mocap body is moved by the user; here it is fixed to the world as drawn".to_owned()
            });
        }
        let above = &self.bodies.bodies[parent.body];
        self.bodies.bodies.push(Body {
            element,
            name,
            parent: parent.body,
            pose,
            world_pose: above.world_pose * pose,
            joints: Vec::new(),
            geoms: Vec::new(),
            inertial: None,
            moving_ancestor: above.moving_ancestor,
        });
        let class = self.models.classes(element).named(element, "childclass", self.findings);
        let inner = Parent {
            body: index,
            frame: Transform::identity(),
            class: class.or(parent.class),
            suffix: parent.suffix.clone(),
            in_replicate: false,
        };
        // Joints come first: a body may list them behind its child bodies, whose moving ancestor it is.
        if has_joint(self.tree, element) {
            self.bodies.bodies[index].moving_ancestor = index;
        }
        self.walk_children(element, &inner);
    }

    /// Reads a joint or an inertia, which belong to a body.
    fn read_body_part(&mut self, element: ElementId, parent: &Parent) {
        let tag = self.tree.tag(element);
        if parent.body == 0 || parent.in_replicate {
            self.findings.error("misplaced", element, || {
                format!(
                    "a <{tag}> belongs to a <body>, not to the world or a <replicate>; put it into a body"
                )
            });
            return;
        }
        if tag == "inertial" {
            let attributes = Attributes::new(self.tree, element);
            let inertial =
                read_inertial(attributes, &parent.frame, self.models.settings(element), self.findings);
            if parent.frame != Transform::identity() {
                self.findings.add_once(Severity::Warning, "frame-of-inertia", "frame", element, || {
                    "an <inertial> within a <frame> is placed in that frame, as in MuJoCo from version 3.14 on; earlier \
                     versions ignore the frame"
                        .to_owned()
                });
            }
            let body = &mut self.bodies.bodies[parent.body];
            if body.inertial.is_some() {
                self.findings
                    .error("duplicate-element", element, || "a second <inertial>; a body has one".to_owned());
            }
            body.inertial = inertial.map(|inertial| (inertial, element));
            return;
        }
        let joint = self.read_joint(element, parent);
        let body = &mut self.bodies.bodies[parent.body];
        let only_one = [JointType::Free].contains(&joint.kind) && !body.joints.is_empty()
            || body.joints.iter().any(|other| other.kind == JointType::Free);
        if only_one {
            self.findings.error("free-joint", element, || {
                "a free joint is the only joint of its body; remove the other joints".to_owned()
            });
        }
        if joint.kind == JointType::Free && body.parent != 0 {
            self.findings.error("free-joint", element, || {
                "a free joint belongs to a body directly in <worldbody>".to_owned()
            });
        }
        let place = (parent.body, body.joints.len());
        let name = joint.name.clone();
        body.joints.push(joint);
        if !name.is_empty() && self.bodies.joint_by_name.insert(name.clone(), place).is_some() {
            self.report_duplicate(element, &name);
        }
    }

    fn read_joint(&mut self, element: ElementId, parent: &Parent) -> BodyJoint {
        let name = self.name(element, parent);
        let free = BodyJoint {
            element,
            name,
            kind: JointType::Free,
            anchor: Vector3::zeros(),
            axis: Vector3::z(),
            limits: None,
            reference: 0.0,
            armature: 0.0,
            spring: None,
        };
        // A free joint by its own element takes no defaults.
        if self.tree.tag(element) == "freejoint" {
            return free;
        }
        let attributes = self.attributes(element, DefaultKind::Joint, parent);
        let kind = attributes.word("type", &JOINT_TYPES, self.findings).unwrap_or(JointType::Hinge);
        let armature = attributes.number("armature", self.findings).unwrap_or(0.0);
        let given = attributes.number("ref", self.findings).unwrap_or(0.0);
        let reference = match kind {
            JointType::Hinge => given * self.models.settings(element).angle_unit,
            JointType::Slide => given,
            JointType::Ball | JointType::Free => 0.0,
        };
        let spring = self.read_spring(attributes, kind, reference);
        if kind == JointType::Free {
            return BodyJoint { armature, ..free };
        }
        let anchor = attributes.numbers::<3>("pos", self.findings).unwrap_or_default();
        let axis = attributes.numbers::<3>("axis", self.findings).unwrap_or([0.0, 0.0, 1.0]);
        let axis = unit(axis.into());
        if axis.is_none() && kind != JointType::Ball {
            self.findings.attribute_error("zero-axis", element, "axis", || {
                "the axis is zero; it needs a direction, such as 0 0 1".to_owned()
            });
        }
        BodyJoint {
            kind,
            anchor: parent.frame.point(&anchor.into()),
            axis: parent.frame.vector(&axis.unwrap_or_else(Vector3::z)),
            limits: self.read_limits(attributes, kind),
            reference,
            armature,
            spring,
            ..free
        }
    }

    /// Spring and damper of a joint. `reference`: position as drawn.
    fn read_spring(
        &mut self,
        attributes: Attributes<'_>,
        kind: JointType,
        reference: f64,
    ) -> Option<SpringDamper> {
        let element = attributes.element;
        let unit = if kind == JointType::Hinge { self.models.settings(element).angle_unit } else { 1.0 };
        let findings = &mut *self.findings;
        let free = unit * attributes.number("springref", findings).unwrap_or(0.0) - reference;
        let [stiffness, damping] = ["stiffness", "damping"].map(|name| {
            let given = attributes.list(name, 3, findings).unwrap_or_default();
            if given.iter().skip(1).any(|factor| *factor != 0.0) {
                findings.warning(SPRING_LEFT_OUT, element, || {
                    format!("{name}: the linear term alone is read; the joint is not linear in MuJoCo")
                });
            }
            given.first().copied().unwrap_or(0.0)
        });
        if attributes
            .numbers::<2>("springdamper", findings)
            .is_some_and(|given| given.iter().all(|x| *x > 0.0))
        {
            findings.warning(SPRING_LEFT_OUT, element, || {
                "springdamper: MuJoCo computes stiffness and damping from the masses as drawn, and they are left out; give stiffness and \
                 damping, which mujoco.mj_saveLastXML writes"
                    .to_owned()
            });
            return None;
        }
        let dofs = match kind {
            JointType::Hinge | JointType::Slide => 1,
            JointType::Ball => 3,
            JointType::Free => 6,
        };
        joint_spring(dofs, [stiffness, damping, free]).unwrap_or_else(|why| {
            findings.note(SPRING_LEFT_OUT, element, || why.to_owned());
            None
        })
    }

    /// Limits of a hinge or slide relative to its reference position.
    fn read_limits(&mut self, attributes: Attributes<'_>, kind: JointType) -> Option<[f64; 2]> {
        let findings = &mut *self.findings;
        let element = attributes.element;
        let unit = if kind == JointType::Slide { 1.0 } else { self.models.settings(element).angle_unit };
        let range = attributes.numbers::<2>("range", findings);
        let words = [("true", Some(true)), ("false", Some(false)), ("auto", None)];
        let limited = attributes.word("limited", &words, findings).flatten();
        let reference = attributes.number("ref", findings).unwrap_or(0.0);
        if kind == JointType::Ball {
            if limited == Some(true) || limited.is_none() && range.is_some() {
                findings.add_once(Severity::Note, "ball-limit", "ball", element, || {
                    "the limit of a ball joint is an angle about any axis; it is not checked".to_owned()
                });
            }
            return None;
        }
        if reference != 0.0 {
            findings.add_once(Severity::Warning, "reference-position", "ref", element, || {
                "the joint has a reference position (ref): the position here is 0 as drawn, that is MuJoCo's qpos minus ref"
                    .to_owned()
            });
        }
        if range.is_some() && limited.is_none() && !self.models.settings(element).auto_limits {
            findings.error("limits", element, || {
                "the joint has a range but no \"limited\", and autolimits is false; MuJoCo refuses this: set limited to true or false"
                    .to_owned()
            });
        }
        let [lower, upper] = range.filter(|_| limited != Some(false))?;
        if lower >= upper {
            findings.warning("limits", element, || {
                format!(
                    "range=\"{lower} {upper}\": the first limit is not below the second; both are ignored"
                )
            });
            return None;
        }
        Some([(lower - reference) * unit, (upper - reference) * unit])
    }

    fn read_site(&mut self, element: ElementId, parent: &Parent) {
        let attributes = self.attributes(element, DefaultKind::Site, parent);
        let frame = match attributes.numbers::<6>("fromto", self.findings) {
            Some(line) => frame_on_line(attributes, line, self.findings),
            None => {
                let position = attributes.numbers::<3>("pos", self.findings).unwrap_or_default();
                let rotation = read_orientation(attributes, self.models.settings(element), self.findings);
                Some(Transform::new(rotation.unwrap_or_else(Matrix3::identity), position.into()))
            }
        };
        let name = self.name(element, parent);
        let (Some(frame), false) = (frame, name.is_empty()) else { return };
        let site = Site { body: parent.body, frame: parent.frame * frame };
        if self.bodies.sites.insert(name.clone(), site).is_some() {
            self.report_duplicate(element, &name);
        }
    }

    /// Reads the contents of a `<replicate>` once for each copy. Copy i is turned by the Euler angles times i; the offset is added in
    /// the frame of the copy before.
    fn replicate(&mut self, element: ElementId, parent: &Parent) {
        let attributes = Attributes::new(self.tree, element);
        let count = attributes.number("count", self.findings);
        let Some(count) = count.filter(|count| *count >= 1.0 && count.fract() == 0.0 && *count <= 1e9) else {
            self.findings.error("bad-count", element, || {
                "a <replicate> needs count, a positive whole number of copies".to_owned()
            });
            return;
        };
        let contents = self.tree.children(element).len();
        let needed = (count as usize).saturating_mul(contents + 1);
        if needed > MAX_TREE_VISITS - self.visits.min(MAX_TREE_VISITS) {
            self.visits = MAX_TREE_VISITS;
            self.count_visit(element);
            return;
        }
        if contents == 0 {
            return;
        }
        let separator = attributes.text("sep").unwrap_or_default();
        let offset = Vector3::from(attributes.numbers::<3>("offset", self.findings).unwrap_or_default());
        let angles = attributes.numbers::<3>("euler", self.findings).unwrap_or_default();
        let class = self.models.classes(element).named(element, "childclass", self.findings);
        let digits = (count as usize).to_string().len();
        let mut translation = Vector3::zeros();
        for copy in 0..count as usize {
            if !self.count_visit(element) {
                return;
            }
            let rotation =
                rotation_from_euler(angles.map(|angle| angle * copy as f64), self.models.settings(element));
            let frame = parent.frame * Transform::new(rotation, translation);
            translation += rotation * offset;
            let inner = Parent {
                body: parent.body,
                frame,
                class: class.or(parent.class),
                // The suffix of the innermost replicate comes first.
                suffix: format!("{separator}{copy:0digits$}{}", parent.suffix),
                in_replicate: true,
            };
            self.walk_children(element, &inner);
        }
    }
}

/// True if a body has a joint, directly or within frames.
fn has_joint(tree: &ElementTree, element: ElementId) -> bool {
    tree.children(element).iter().any(|child| match tree.tag(*child) {
        "joint" | "freejoint" => true,
        "frame" | "attach" => has_joint(tree, *child),
        _ => false,
    })
}
