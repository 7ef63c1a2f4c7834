//! Positions of MuJoCo: their layout, and keyframes as named poses.

use crate::NamedPose;
use crate::mjcf::bodies::body::{Bodies, JointType};
use crate::mjcf::chain::Chains;
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::document::qpos::{LengthJoint, QposError, QposJoint, QposLayout};
use crate::reading::findings::Findings;
use crate::reading::limits::{MAX_ELEMENTS_PER_KIND, MAX_POSITIONS};
use crate::reading::unique_names::UniqueNames;
use crate::urdf::elements::numbers::parse_numbers;
use percuss_mechanism::{JointKind, Mechanism, Severity};
use std::collections::HashMap;

/// Reads the keyframes of the main model. The position of a joint is `qpos` minus the attribute `ref`; the pose of a free joint is relative
/// to the pose as drawn. Mimics and locked joints are left out. A keyframe whose `qpos` does not fit the model is left out with a warning:
/// MuJoCo refuses it.
pub(crate) fn read_keyframes(layout: &QposLayout, findings: &mut Findings<'_>) -> Vec<NamedPose> {
    let tree = findings.tree;
    let keys: Vec<ElementId> = tree.in_sections("keyframe").take(MAX_ELEMENTS_PER_KIND).collect();
    let mut names = UniqueNames::default();
    names.reserve(keys.iter().filter_map(|key| tree.attribute(*key, "name")));
    let mut poses = Vec::new();
    let joints = layout.joints.len();
    let most = MAX_POSITIONS / joints.max(1);
    for (number, key) in keys.into_iter().enumerate() {
        if poses.len() >= most {
            findings.add_once(Severity::Warning, "too-complex", "keyframe", key, || {
                format!("keyframes after the first {most} are left out: the model has {joints} joints")
            });
            continue;
        }
        let name = tree.attribute(key, "name").map(str::to_owned);
        let name = name.unwrap_or_else(|| names.take(format!("keyframe{number}")));
        let values = tree.attribute(key, "qpos").map(|text| numbers(text, layout.qpos_count())).transpose();
        let positions =
            values.and_then(|values| layout.by_name(values.as_deref()).map_err(|error| error.to_string()));
        match positions {
            Ok(positions) => poses.push(NamedPose { name, positions }),
            Err(reason) => {
                findings.warning("keyframe", key, || format!("the keyframe is left out: {reason}"))
            }
        }
    }
    poses
}

/// Numbers of a text. Of a text with more than `count` words, the others are not parsed.
fn numbers(text: &str, count: usize) -> Result<Vec<f64>, String> {
    let words = text.split_ascii_whitespace();
    let given = words.clone().count();
    if given != count {
        return Err(QposError::Count { got: given, expected: count }.to_string());
    }
    words.map(|word| parse_numbers::<1>(word).map(|[value]| value)).collect()
}

/// Layout of `qpos` of the main model.
pub(crate) fn qpos_layout(
    tree: &ElementTree,
    bodies: &Bodies,
    chains: &Chains,
    mechanism: &Mechanism,
) -> QposLayout {
    let mut next = 0;
    let mut places = HashMap::new();
    for joint in mechanism.joints() {
        let range = next..next + joint.kind().positions();
        next = range.end;
        let is_written = joint.kind() != JointKind::Fixed && joint.mimic().is_none();
        places.insert(joint.name(), is_written.then_some(range));
    }
    let place = |name: &str| places.get(name).cloned().flatten();
    let mut joints = Vec::new();
    let mut count = 0;
    for (index, body) in bodies.bodies.iter().enumerate() {
        for (position, joint) in body.joints.iter().enumerate() {
            let qpos = count..count + size(joint.kind);
            count = qpos.end;
            let name = chains.joint_names.get(&(index, position)).cloned().unwrap_or_default();
            let own = place(&name);
            joints.push(QposJoint { name, qpos, own, reference: joint.reference, pose: body.pose });
        }
    }
    let single: HashMap<&str, (usize, f64)> = joints
        .iter()
        .filter(|joint| joint.qpos.len() == 1)
        .map(|joint| (joint.name.as_str(), (joint.qpos.start, joint.reference)))
        .collect();
    let mut lengths = Vec::new();
    for (relation, _) in &chains.parts.relations {
        if let [(length, factor), terms @ ..] = &relation.terms[..]
            && relation.curve.is_none()
            && !single.contains_key(length.as_str())
            && let Some(own) = place(length)
        {
            let term = |(joint, factor): &(String, f64)| {
                single.get(joint.as_str()).map(|(index, drawn)| (*index, *drawn, *factor))
            };
            let (name, constant) = (length.clone(), relation.constant);
            let terms = terms.iter().filter_map(term).collect();
            lengths.push(LengthJoint { name, own: own.start, factor: *factor, constant, terms });
        }
    }
    let drawn = NamedPose { name: String::new(), positions: Vec::new() }.all_positions(mechanism);
    QposLayout { count, joints, lengths, drawn, is_aligned: is_aligned(tree, bodies) }
}

/// True if MuJoCo moves the frame of a free body to its centre of mass.
fn is_aligned(tree: &ElementTree, bodies: &Bodies) -> bool {
    let is_true = |element, name| tree.attribute(element, name) == Some("true");
    let joints = bodies.bodies.iter().flat_map(|body| &body.joints);
    tree.children_named(tree.root(), "compiler").any(|element| is_true(element, "alignfree"))
        || joints.into_iter().any(|joint| is_true(joint.element, "align"))
}

/// Number of positions of a joint of MuJoCo.
fn size(kind: JointType) -> usize {
    match kind {
        JointType::Free => 7,
        JointType::Ball => 4,
        JointType::Slide | JointType::Hinge => 1,
    }
}
