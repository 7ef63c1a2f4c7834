//! Keyframes as named poses.

use crate::NamedPose;
use crate::mjcf::bodies::body::{Bodies, BodyJoint, JointType};
use crate::mjcf::chain::Chains;
use crate::reading::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::limits::{MAX_ELEMENTS_PER_KIND, MAX_POSITIONS};
use crate::reading::unique_names::UniqueNames;
use crate::urdf::elements::numbers::parse_numbers;
use nalgebra::{Quaternion, Rotation3, UnitQuaternion};
use percuss_mechanism::{JointDescription, JointKind, Severity};
use percuss_spatial::{Transform, Vector3};
use std::collections::HashMap;

/// Reads the keyframes of the main model. The position of a joint is `qpos` minus the attribute `ref`; the pose of a free joint is relative
/// to the pose as drawn. Mimics and locked joints are left out. A keyframe whose `qpos` does not fit the model is left out with a warning:
/// MuJoCo refuses it.
pub(crate) fn read_keyframes(
    tree: &ElementTree,
    bodies: &Bodies,
    chains: &Chains,
    findings: &mut Findings<'_>,
) -> Vec<NamedPose> {
    let keys: Vec<ElementId> = tree.in_sections("keyframe").take(MAX_ELEMENTS_PER_KIND).collect();
    // MuJoCo moves the frame of an aligned free body to its centre of mass; qpos refers to the moved frame.
    let is_true = |element: ElementId, name| tree.attribute(element, name) == Some("true");
    let is_aligned = tree
        .children_named(tree.root(), "compiler")
        .any(|element| is_true(element, "alignfree"))
        || bodies.bodies.iter().flat_map(|body| &body.joints).any(|joint| is_true(joint.element, "align"));
    let mut names = UniqueNames::default();
    names.reserve(keys.iter().filter_map(|key| tree.attribute(*key, "name")));
    let mut poses = Vec::new();
    let joints: usize = bodies.bodies.iter().map(|body| body.joints.len()).sum();
    let most = MAX_POSITIONS / joints.max(1);
    let count = bodies.bodies.iter().flat_map(|body| &body.joints).map(|joint| size(joint.kind)).sum();
    let own = chains.joints.iter().map(|joint| (joint.name.as_str(), joint)).collect();
    for (number, key) in keys.into_iter().enumerate() {
        if poses.len() >= most {
            findings.add_once(Severity::Warning, "too-complex", "keyframe", key, || {
                format!("keyframes after the first {most} are left out: the model has {joints} joints")
            });
            continue;
        }
        let name = tree.attribute(key, "name").map(str::to_owned);
        let name = name.unwrap_or_else(|| names.take(format!("keyframe{number}")));
        let qpos = tree.attribute(key, "qpos");
        if is_aligned && qpos.is_some() {
            findings.warning("keyframe", key, || {
                "the keyframe is left out: MuJoCo moves the frame of an aligned free body (alignfree, align), and qpos refers to that frame"
                    .to_owned()
            });
            continue;
        }
        match positions(qpos, bodies, chains, &own, count) {
            Ok(positions) => poses.push(NamedPose { name, positions }),
            Err(reason) => {
                findings.warning("keyframe", key, || format!("the keyframe is left out: {reason}"))
            }
        }
    }
    poses
}

/// Positions of the joints of the mechanism, by name; without `qpos`, the positions as drawn. `own`: joints of the mechanism by name;
/// `count`: number of positions of the model.
fn positions(
    qpos: Option<&str>,
    bodies: &Bodies,
    chains: &Chains,
    own: &HashMap<&str, &JointDescription>,
    count: usize,
) -> Result<Vec<(String, Vec<f64>)>, String> {
    let joints = || {
        bodies.bodies.iter().enumerate().flat_map(|(index, body)| {
            body.joints.iter().enumerate().map(move |(position, joint)| ((index, position), body, joint))
        })
    };
    let values = match qpos {
        None => None,
        Some(text) => {
            let words = text.split_ascii_whitespace().take(count + 1);
            let values: Vec<f64> =
                words.map(|word| parse_numbers::<1>(word).map(|[value]| value)).collect::<Result<_, _>>()?;
            if values.len() != count {
                return Err(format!(
                    "qpos has {} numbers, and the joints of the model have {count} positions",
                    text.split_ascii_whitespace().count()
                ));
            }
            Some(values)
        }
    };
    let mut found = Vec::new();
    let mut known: HashMap<&str, f64> = HashMap::new();
    let mut next = 0;
    for (key, body, joint) in joints() {
        let range = next..next + size(joint.kind);
        next = range.end;
        let Some(name) = chains.joint_names.get(&key) else { continue };
        let position = match &values {
            Some(values) => position(joint, &body.pose, &values[range])?,
            None => drawn(joint.kind),
        };
        if let [value] = position[..] {
            known.insert(name, value);
        }
        let is_free = |joint: &&JointDescription| joint.kind != JointKind::Fixed && joint.mimic.is_none();
        if own.get(name.as_str()).is_some_and(is_free) {
            found.push((name.clone(), position));
        }
    }
    // The length joint of a tendon with an armature follows the joints of the tendon.
    for (_, relation) in &chains.relations {
        if let [(length, factor), terms @ ..] = &relation.terms[..]
            && relation.curve.is_none()
            && own.contains_key(length.as_str())
            && !known.contains_key(length.as_str())
        {
            let sum: f64 =
                terms.iter().map(|(joint, factor)| factor * known.get(joint.as_str()).unwrap_or(&0.0)).sum();
            found.push((length.clone(), vec![(relation.constant - sum) / factor]));
        }
    }
    Ok(found)
}

/// Number of positions of a joint.
fn size(kind: JointType) -> usize {
    match kind {
        JointType::Free => 7,
        JointType::Ball => 4,
        JointType::Slide | JointType::Hinge => 1,
    }
}

/// Position as drawn.
fn drawn(kind: JointType) -> Vec<f64> {
    match kind {
        JointType::Free => vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
        JointType::Ball => vec![1.0, 0.0, 0.0, 0.0],
        JointType::Slide | JointType::Hinge => vec![0.0],
    }
}

/// Position of a joint of the mechanism. `pose`: pose of the body as drawn (in the world for a free joint).
fn position(joint: &BodyJoint, pose: &Transform<f64>, qpos: &[f64]) -> Result<Vec<f64>, String> {
    let unit = |w: f64, x: f64, y: f64, z: f64| {
        UnitQuaternion::try_new(Quaternion::new(w, x, y, z), f64::MIN_POSITIVE)
            .ok_or_else(|| format!("the quaternion of joint \"{}\" is 0", joint.name))
    };
    Ok(match *qpos {
        [value] => vec![value - joint.reference],
        [w, x, y, z] => {
            let q = unit(w, x, y, z)?;
            vec![q.w, q.i, q.j, q.k]
        }
        [px, py, pz, w, x, y, z] => {
            let at = pose.inverse_vector(&(Vector3::new(px, py, pz) - pose.translation));
            let drawn =
                UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(pose.rotation));
            let q = drawn.inverse() * unit(w, x, y, z)?;
            vec![at.x, at.y, at.z, q.w, q.i, q.j, q.k]
        }
        _ => Vec::new(),
    })
}
