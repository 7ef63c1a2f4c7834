//! Axes of joints: direction, limits, and the joint that an axis follows.

use crate::parts::{SPRING_LEFT_OUT, joint_spring};
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::limits::{MIN_AXIS_COMPONENT, UNLIMITED};
use crate::reading::report::quoted;
use crate::sdf::document::version::Version;
use crate::sdf::frames::poses::report_unknown_frame;
use crate::sdf::frames::scopes::{FrameId, FrameKind, Scopes};
use crate::sdf::values::{read_boolean_in, read_limit_in, read_number_in, read_numbers};
use crate::urdf::elements::numbers::parse_numbers;
use percuss_mechanism::{Limits, Severity, SpringDamper};
use percuss_spatial::Vector3;

/// Relation q = multiplier · q_leader + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SdfMimic {
    pub element: ElementId,
    /// Index of the leader in [`Scopes::joints`], and its axis, 0 or 1.
    pub leader: (usize, usize),
    pub multiplier: f64,
    /// rad or m.
    pub offset: f64,
}

/// Axis of a joint.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct JointAxis {
    /// In the joint frame as drawn; not normalised.
    pub direction: Vector3<f64>,
    pub limits: Option<Limits>,
    pub mimic: Option<SdfMimic>,
    /// Spring and damper parallel to the motion.
    pub spring: Option<SpringDamper>,
}

/// Reads `<axis>` or `<axis2>` of a joint; the z-axis without limits if absent.
pub(crate) fn read_axis(
    scopes: &Scopes,
    joint: FrameId,
    tag: &'static str,
    findings: &mut Findings<'_>,
) -> JointAxis {
    let own = scopes.frame(joint);
    let Some(axis) = findings.tree.child(own.element, tag) else {
        return JointAxis { direction: Vector3::z(), limits: None, mimic: None, spring: None };
    };
    if let Some(position) = read_number_in(axis, "initial_position", findings).filter(|q| *q != 0.0) {
        findings.add_once(Severity::Warning, "ignored", "initial position", axis, || {
            format!("<initial_position> {position} is not applied: joints are at 0 as drawn; set the joint to it (--set)")
        });
    }
    JointAxis {
        direction: read_direction(scopes, joint, axis, findings),
        limits: findings.tree.child(axis, "limit").and_then(|limit| read_limits(limit, findings)),
        mimic: read_mimic(scopes, joint, axis, findings),
        spring: read_spring(axis, findings),
    }
}

/// Direction of an axis in the joint frame.
fn read_direction(
    scopes: &Scopes,
    joint: FrameId,
    axis: ElementId,
    findings: &mut Findings<'_>,
) -> Vector3<f64> {
    let tree = findings.tree;
    let own = scopes.frame(joint);
    let xyz = tree.child(axis, "xyz");
    let given = xyz.and_then(|xyz| read_numbers::<3>(xyz, findings));
    let direction: Vector3<f64> = given.map_or_else(Vector3::z, Into::into);
    if direction.amax() < MIN_AXIS_COMPONENT {
        findings.error("zero-axis", xyz.unwrap_or(axis), || {
            "the axis is zero; it needs a direction, such as 0 0 1".to_owned()
        });
        return Vector3::z();
    }
    let version = Version::of_element(tree, own.element);
    let is_stated = tree.child(axis, "use_parent_model_frame").is_some();
    if is_stated && version >= Version::WITH_FRAMES {
        findings.warning("ignored", axis, || {
            "<use_parent_model_frame> ended with version 1.6 and is ignored; write expressed_in=\"__model__\""
                .to_owned()
        });
    }
    // The converter of older files replaces `expressed_in` by the model frame.
    let is_in_model_frame = version < Version::WITH_FRAMES
        && if is_stated {
            read_boolean_in(axis, "use_parent_model_frame", findings)
        } else {
            version == Version::FIRST && is_in_outer_model(tree, own.element)
        };
    let named = xyz.and_then(|xyz| tree.attribute(xyz, "expressed_in")).filter(|name| !name.is_empty());
    let frame = match named {
        _ if is_in_model_frame => Some(scopes.scope(own.scope).frame),
        Some(name) => {
            let found = scopes.find(own.scope, name);
            if found.is_none() {
                report_unknown_frame(scopes, own.scope, xyz.unwrap_or(axis), name, findings);
            }
            found
        }
        None => None,
    };
    match frame {
        Some(frame) => scopes.relative_pose(joint, frame).vector(&direction),
        None => direction,
    }
}

/// True for a joint whose model is in no other model of the same file: the converter of version 1.4 changes only these.
fn is_in_outer_model(tree: &ElementTree, joint: ElementId) -> bool {
    let model = tree.element(joint).parent;
    let holder = model.and_then(|model| tree.element(model).parent);
    holder.is_some_and(|holder| matches!(tree.tag(holder), "sdf" | "world"))
}

/// Spring and damper of an axis, of the element `<dynamics>`.
fn read_spring(axis: ElementId, findings: &mut Findings<'_>) -> Option<SpringDamper> {
    let dynamics = findings.tree.child(axis, "dynamics")?;
    let numbers = ["spring_stiffness", "damping", "spring_reference"]
        .map(|tag| read_number_in(dynamics, tag, findings).unwrap_or(0.0));
    joint_spring(1, numbers).unwrap_or_else(|why| {
        findings.note(SPRING_LEFT_OUT, dynamics, || why.to_owned());
        None
    })
}

/// Position limits, m or rad; `None` if both are missing or infinite.
fn read_limits(limit: ElementId, findings: &mut Findings<'_>) -> Option<Limits> {
    let lower = read_limit_in(limit, "lower", findings);
    let upper = read_limit_in(limit, "upper", findings);
    if lower.is_none() && upper.is_none() {
        return None;
    }
    // One missing limit has the value that SDFormat takes for infinite.
    Some(Limits { lower: lower.unwrap_or(-UNLIMITED), upper: upper.unwrap_or(UNLIMITED) })
}

/// Reads `<mimic>` of an axis, or Drake's of the joint.
fn read_mimic(
    scopes: &Scopes,
    joint: FrameId,
    axis: ElementId,
    findings: &mut Findings<'_>,
) -> Option<SdfMimic> {
    let tree = findings.tree;
    let own = scopes.frame(joint);
    if let Some(mimic) = tree.child(axis, "mimic") {
        let mut number = |tag, default| read_number_in(mimic, tag, findings).unwrap_or(default);
        let (multiplier, offset) = (number("multiplier", 1.0), number("offset", 0.0));
        let reference = number("reference", 0.0);
        let leader_axis = usize::from(tree.attribute(mimic, "axis") == Some("axis2"));
        let leader = find_leader(scopes, joint, mimic, findings)?;
        let offset = offset - multiplier * reference;
        return Some(SdfMimic { element: mimic, leader: (leader, leader_axis), multiplier, offset });
    }
    let mimic = tree.child(own.element, "drake:mimic").filter(|_| tree.tag(axis) == "axis")?;
    let mut number = |name: &str, default| match tree.attribute(mimic, name).map(parse_numbers::<1>) {
        Some(Ok([value])) => value,
        Some(Err(defect)) => {
            findings.attribute_error("bad-number", mimic, name, || format!("{name}: {defect}"));
            default
        }
        None => default,
    };
    let (multiplier, offset) = (number("multiplier", 1.0), number("offset", 0.0));
    let leader = find_leader(scopes, joint, mimic, findings)?;
    Some(SdfMimic { element: mimic, leader: (leader, 0), multiplier, offset })
}

/// Joint that a mimic names.
fn find_leader(
    scopes: &Scopes,
    joint: FrameId,
    mimic: ElementId,
    findings: &mut Findings<'_>,
) -> Option<usize> {
    let name = findings.tree.attribute(mimic, "joint").unwrap_or_default();
    let found = scopes.find(scopes.frame(joint).scope, name).map(|frame| scopes.frame(frame).kind);
    if let Some(FrameKind::Joint(leader)) = found {
        return Some(leader);
    }
    findings.attribute_error("unknown-joint", mimic, "joint", || {
        format!("the joint {} does not exist in the model", quoted(name))
    });
    None
}
