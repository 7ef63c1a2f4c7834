//! Joints with their ends and axes.

use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::{Findings, similar_name};
use crate::reading::limits::OBLIQUE_PINS;
use crate::reading::report::quoted;
use crate::sdf::elements::axis::{JointAxis, read_axis};
use crate::sdf::frames::scopes::{Attached, FrameId, ScopeId, Scopes};
use crate::sdf::values::{read_boolean_in, read_number_in, text_in};
use crate::urdf::elements::sdf_values::screw_advance;

/// Kinds of joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum JointType {
    Fixed,
    Revolute,
    Prismatic,
    Ball,
    /// Two revolute joints, about `axis` of the parent and `axis2` of the child.
    Universal,
    Revolute2,
    Screw,
    Gearbox,
}

const TYPES: [(&str, JointType); 9] = [
    ("fixed", JointType::Fixed),
    ("revolute", JointType::Revolute),
    ("continuous", JointType::Revolute),
    ("prismatic", JointType::Prismatic),
    ("ball", JointType::Ball),
    ("universal", JointType::Universal),
    ("revolute2", JointType::Revolute2),
    ("screw", JointType::Screw),
    ("gearbox", JointType::Gearbox),
];

impl JointType {
    /// Number of axes.
    pub fn axes(self) -> usize {
        match self {
            JointType::Fixed | JointType::Ball => 0,
            JointType::Revolute | JointType::Prismatic | JointType::Screw => 1,
            JointType::Universal | JointType::Revolute2 | JointType::Gearbox => 2,
        }
    }

    /// Name in files.
    pub fn name(self) -> &'static str {
        TYPES.iter().find(|(_, kind)| *kind == self).map_or("", |(name, _)| name)
    }
}

/// Joint with its values.
#[derive(Clone, Debug)]
pub(crate) struct JointBody {
    /// Index in [`Scopes::joints`].
    pub index: usize,
    pub element: ElementId,
    pub name: String,
    pub kind: JointType,
    pub frame: FrameId,
    pub parent: Attached,
    /// Index of the child in [`Scopes::links`].
    pub child: usize,
    pub axes: Vec<JointAxis>,
    /// Advance of a screw, m/rad.
    pub advance: f64,
    /// Reflected inertia of the rotor, kg·m² or kg.
    pub armature: f64,
    /// True if the file marks the joint as one that closes a loop.
    pub is_loop_joint: bool,
    /// Ratio and reference body of a gearbox.
    pub gear: Option<(f64, Attached)>,
}

/// Reads a joint; `None`, with an error, if its type or an end is invalid.
pub(crate) fn read_joint(scopes: &Scopes, index: usize, findings: &mut Findings<'_>) -> Option<JointBody> {
    let tree = findings.tree;
    let joint = &scopes.joints[index];
    let element = joint.element;
    let kind = read_type(element, findings);
    let parent = read_end(scopes, (joint.scope, element), "parent", findings);
    let child = read_end(scopes, (joint.scope, element), "child", findings);
    let (kind, parent, child) = (kind?, parent?, child?);
    let Attached::Link(child) = child else {
        findings.error("child-world", element, || {
            "the child of the joint is the world; exchange <parent> and <child>".to_owned()
        });
        return None;
    };
    if parent == Attached::Link(child) {
        findings.error("joins-itself", element, || {
            format!("the joint joins the link {} to itself", quoted(scopes.link_name(child)))
        });
        return None;
    }
    let tags = ["axis", "axis2"];
    let axes = tags.iter().take(kind.axes());
    let axes: Vec<JointAxis> = axes.map(|tag| read_axis(scopes, joint.frame, tag, findings)).collect();
    for tag in tags.iter().take(kind.axes()).filter(|tag| tree.child(element, tag).is_none()) {
        if kind.axes() == 2 {
            findings.error("missing-element", element, || format!("a {} joint has no <{tag}>", kind.name()));
        } else {
            findings.note("default-axis", element, || {
                format!("the {} joint has no <{tag}>: 0 0 1 is taken, as SDFormat says", kind.name())
            });
        }
    }
    if let (JointType::Universal, [first, second]) = (kind, &axes[..])
        && first.direction.normalize().dot(&second.direction.normalize()).abs() > OBLIQUE_PINS
    {
        findings.warning("oblique-pins", element, || {
            "the axes of the universal joint are not at right angles, and libsdformat refuses the file; here they are two hinges".to_owned()
        });
    }
    let unused = [
        ("axis2", kind.axes() == 2),
        ("thread_pitch", kind == JointType::Screw),
        ("screw_thread_pitch", kind == JointType::Screw),
        ("gearbox_ratio", kind == JointType::Gearbox),
        ("gearbox_reference_body", kind == JointType::Gearbox),
    ];
    for (tag, _) in unused.into_iter().filter(|(tag, is_used)| !is_used && tree.child(element, tag).is_some())
    {
        findings.note("ignored", element, || format!("<{tag}> has no effect in a {} joint", kind.name()));
    }
    if kind.axes() > 0
        && tree.child(element, "drake:gear_ratio").is_some()
        && tree.child(element, "drake:rotor_inertia").is_none()
    {
        findings.note("gear-without-rotor", element, || {
            "a gear ratio without <drake:rotor_inertia>: the reflected inertia I·N² is missing, which is often the largest part of the \
             effective mass of a geared arm"
                .to_owned()
        });
    }
    let is_continuous = tree.attribute(element, "type") == Some("continuous");
    let axes =
        axes.into_iter().map(|axis| JointAxis { limits: axis.limits.filter(|_| !is_continuous), ..axis });
    let axes = axes.collect();
    let rotor = read_number_in(element, "drake:rotor_inertia", findings).unwrap_or(0.0);
    let ratio = read_number_in(element, "drake:gear_ratio", findings).unwrap_or(1.0);
    let simbody = tree.child(element, "physics").and_then(|physics| tree.child(physics, "simbody"));
    Some(JointBody {
        index,
        element,
        name: scopes.frame(joint.frame).name.clone(),
        kind,
        frame: joint.frame,
        parent,
        child,
        axes,
        advance: if kind == JointType::Screw { read_advance(element, findings) } else { 0.0 },
        armature: rotor * ratio * ratio,
        is_loop_joint: simbody
            .is_some_and(|simbody| read_boolean_in(simbody, "must_be_loop_joint", findings)),
        gear: if kind == JointType::Gearbox { read_gear(scopes, index, findings) } else { None },
    })
}

fn read_type(element: ElementId, findings: &mut Findings<'_>) -> Option<JointType> {
    let given = findings.tree.attribute(element, "type").unwrap_or_default();
    let found = TYPES.iter().find(|(word, _)| *word == given).map(|(_, kind)| *kind);
    if found.is_none() {
        findings.attribute_error("unknown-joint-type", element, "type", || {
            let guess = similar_name(given, TYPES.iter().map(|(word, _)| *word));
            let list = TYPES.map(|(word, _)| word).join(", ");
            format!("the type of the joint is {}{guess}; it is one of {list}", quoted(given))
        });
    }
    found
}

/// Body at an end of a joint: a link, a frame or model attached to one, or the world.
fn read_end(
    scopes: &Scopes,
    (scope, joint): (ScopeId, ElementId),
    tag: &'static str,
    findings: &mut Findings<'_>,
) -> Option<Attached> {
    let tree = findings.tree;
    let element = tree.child(joint, tag).filter(|element| !tree.text(*element).is_empty());
    let Some(element) = element else {
        findings.error("missing-element", joint, || {
            format!("the joint has no <{tag}>LINK</{tag}>, with the name of a link as text")
        });
        return None;
    };
    resolve_body(scopes, scope, element, findings)
}

/// Body that the text of an element names.
fn resolve_body(
    scopes: &Scopes,
    scope: ScopeId,
    element: ElementId,
    findings: &mut Findings<'_>,
) -> Option<Attached> {
    let name = findings.tree.text(element);
    if name == "world" {
        return Some(Attached::Ground);
    }
    let Some(frame) = scopes.find(scope, name) else {
        findings.error("unknown-link", element, || {
            let guess = similar_name(name, scopes.scope(scope).names.keys().map(String::as_str));
            format!("the link or frame {} does not exist{guess}", quoted(name))
        });
        return None;
    };
    let attached = scopes.attached(frame);
    if attached.is_none() {
        findings.error("unknown-link", element, || format!("{} is attached to no link", quoted(name)));
    }
    attached
}

/// Advance of a screw, m/rad: right-handed metres per turn, or (older) left-handed radians per metre.
fn read_advance(element: ElementId, findings: &mut Findings<'_>) -> f64 {
    let [turn, pitch] =
        ["screw_thread_pitch", "thread_pitch"].map(|tag| read_number_in(element, tag, findings));
    screw_advance(turn, pitch).unwrap_or_else(|(code, defect)| {
        findings.error(code, element, || defect.to_owned());
        0.0
    })
}

/// Ratio and reference body of a gearbox; `None`, with an error, if the body is unknown.
fn read_gear(scopes: &Scopes, index: usize, findings: &mut Findings<'_>) -> Option<(f64, Attached)> {
    let joint = &scopes.joints[index];
    let ratio = read_number_in(joint.element, "gearbox_ratio", findings).unwrap_or(1.0);
    let Some(reference) = findings.tree.child(joint.element, "gearbox_reference_body") else {
        findings.error("missing-element", joint.element, || {
            "the gearbox has no <gearbox_reference_body>, the link relative to which its angles count"
                .to_owned()
        });
        return None;
    };
    if text_in(findings.tree, joint.element, "gearbox_reference_body").is_empty() {
        return None;
    }
    resolve_body(scopes, joint.scope, reference, findings).map(|body| (ratio, body))
}
