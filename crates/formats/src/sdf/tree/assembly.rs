//! Links, joints, closures and couplings of the chosen model.

use crate::parts::{LinkOrigin, Parts};
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::report::quoted;
use crate::reading::unique_names::UniqueNames;
use crate::sdf::elements::body::{LinkBody, read_body};
use crate::sdf::elements::joint::{JointBody, JointType, read_joint};
use crate::sdf::frames::scopes::{Attached, FrameId, FrameKind, ScopeId, Scopes};
use crate::sdf::tree::chain::{ChainBuilder, GROUND, StepNames, body_frame, body_name, step_name};
use crate::sdf::tree::relations::{add_closure, add_gearbox};
use crate::sdf::tree::spanning::{SpanningTree, Support, grow_tree};
use crate::shape::Shape;
use percuss_mechanism::{JointDescription, JointKind, LinkDescription, Severity};
use std::collections::{HashMap, HashSet};

/// Parts of the mechanism of the model `main`, and the shapes of its links, by index of the link in the scopes. `None` after an error.
pub(crate) fn assemble(
    scopes: &Scopes,
    main: ElementId,
    findings: &mut Findings<'_>,
) -> Option<(Parts, Vec<Option<Vec<Shape>>>)> {
    let tree = findings.tree;
    let is_read = read_scopes(tree, scopes, main);
    let joints: Vec<JointBody> = (0..scopes.joints.len())
        .filter(|joint| is_joint_read(tree, scopes, &is_read, *joint))
        .filter_map(|joint| read_joint(scopes, joint, findings))
        .collect();
    if findings.has_errors() {
        return None;
    }
    let links: Vec<Option<bool>> = scopes
        .links
        .iter()
        .map(|link| is_read[scopes.scope(link.scope).top.0].then_some(scopes.scope(link.scope).is_static))
        .collect();
    if links.iter().all(Option::is_none) {
        findings.error("no-links", main, || "the model has no <link>".to_owned());
        return None;
    }
    let leaders: HashSet<usize> =
        joints.iter().flat_map(|joint| &joint.axes).filter_map(|axis| Some(axis.mimic?.leader.0)).collect();
    let spanning = grow_tree(&joints, &links, &leaders);
    check_followers(&joints, &spanning, findings);
    let is_fixed = fixed_links(&joints, &spanning);
    let bodies: Vec<Option<LinkBody>> = links
        .iter()
        .enumerate()
        .map(|(link, read)| read.map(|_| read_body(scopes, link, is_fixed[link], findings)))
        .collect();
    if findings.has_errors() {
        return None;
    }
    let mut parts = Parts::default();
    add_links(scopes, &joints, &spanning, &bodies, &mut parts, findings);
    add_frames(scopes, &is_read, &mut parts, findings);
    for (position, joint) in joints.iter().enumerate() {
        if joint.kind == JointType::Gearbox {
            add_gearbox(scopes, &joints, &spanning, joint, &mut parts, findings);
        } else if !spanning.in_tree[position] && !joins_fixed(joint, &is_fixed) {
            add_closure(scopes, joint, leaders.contains(&joint.index), &mut parts, findings);
        }
    }
    if findings.has_errors() {
        return None;
    }
    Some((parts, bodies.into_iter().map(|body| body.map(|body| body.shapes)).collect()))
}

/// True for a joint between two links that cannot move: it has no effect.
fn joins_fixed(joint: &JointBody, is_fixed: &[bool]) -> bool {
    let parent = match joint.parent {
        Attached::Ground => true,
        Attached::Link(link) => is_fixed[link],
    };
    parent && is_fixed[joint.child]
}

/// Per scope: true for the chosen model and for models that joints of the world connect to it, directly or through others. Only the
/// entries of models directly in the world have a meaning.
fn read_scopes(tree: &ElementTree, scopes: &Scopes, main: ElementId) -> Vec<bool> {
    let mut is_read = vec![false; scopes.scopes.len()];
    for (index, scope) in scopes.scopes.iter().enumerate().skip(1) {
        is_read[index] = scope.include == Some(main) || scope.include.is_none() && scope.element == main;
    }
    let world_joints: Vec<[Option<ScopeId>; 2]> = scopes
        .joints
        .iter()
        .filter(|joint| joint.scope.0 == 0)
        .map(|joint| ends_of(tree, scopes, joint.element))
        .collect();
    let mut queue: Vec<usize> = (0..is_read.len()).filter(|scope| is_read[*scope]).collect();
    let mut neighbours: HashMap<usize, Vec<usize>> = HashMap::new();
    for ends in &world_joints {
        if let [Some(a), Some(b)] = ends {
            neighbours.entry(a.0).or_default().push(b.0);
            neighbours.entry(b.0).or_default().push(a.0);
        }
    }
    while let Some(scope) = queue.pop() {
        for &other in neighbours.get(&scope).into_iter().flatten() {
            if !std::mem::replace(&mut is_read[other], true) {
                queue.push(other);
            }
        }
    }
    is_read
}

/// Models at the ends of a joint of the world; `None` for the world itself and for unknown names.
fn ends_of(tree: &ElementTree, scopes: &Scopes, joint: ElementId) -> [Option<ScopeId>; 2] {
    ["parent", "child"].map(|tag| {
        let frame = scopes.find(ScopeId(0), tree.text(tree.child(joint, tag)?))?;
        match scopes.attached(frame)? {
            Attached::Ground => None,
            Attached::Link(link) => Some(scopes.scope(scopes.links[link].scope).top),
        }
    })
}

/// True for a joint in a model that is read, or for a joint of the world with an end in such a model.
fn is_joint_read(tree: &ElementTree, scopes: &Scopes, is_read: &[bool], joint: usize) -> bool {
    let joint = &scopes.joints[joint];
    if joint.scope.0 > 0 {
        return is_read[scopes.scope(joint.scope).top.0];
    }
    ends_of(tree, scopes, joint.element).iter().flatten().any(|scope| is_read[scope.0])
}

/// Reports mimics of joints that have no position.
fn check_followers(joints: &[JointBody], spanning: &SpanningTree, findings: &mut Findings<'_>) {
    let by_index: HashMap<usize, usize> =
        joints.iter().enumerate().map(|(position, joint)| (joint.index, position)).collect();
    for mimic in joints.iter().flat_map(|joint| joint.axes.iter().filter_map(|axis| axis.mimic)) {
        let leader =
            by_index.get(&mimic.leader.0).map(|position| (&joints[*position], spanning.in_tree[*position]));
        let has_axis = leader.is_some_and(|(leader, in_tree)| in_tree && leader.axes.len() > mimic.leader.1);
        if !has_axis {
            findings.error("mimic", mimic.element, || {
                "the joint that is followed has no position: it has no such axis, or it closes a loop; follow a joint of the tree".to_owned()
            });
        }
    }
}

/// Per link: true if it cannot move, because it is static or fixed to a link that cannot move.
fn fixed_links(joints: &[JointBody], spanning: &SpanningTree) -> Vec<bool> {
    let mut known: Vec<Option<bool>> = vec![None; spanning.supports.len()];
    for start in 0..known.len() {
        let mut path = Vec::new();
        let mut current = Attached::Link(start);
        let result = loop {
            let Attached::Link(link) = current else { break true };
            if let Some(fixed) = known[link] {
                break fixed;
            }
            match spanning.supports[link] {
                Support::Static => break true,
                Support::Joint { joint, .. } if joints[joint].kind == JointType::Fixed => {
                    path.push(link);
                    current = spanning.below[link];
                }
                Support::Joint { .. } | Support::Floating | Support::Absent => break false,
            }
        };
        known[start] = Some(result);
        path.into_iter().for_each(|link| known[link] = Some(result));
    }
    known.into_iter().map(|fixed| fixed == Some(true)).collect()
}

/// Adds the ground and all links with the joints that support them, in the order of the file.
fn add_links(
    scopes: &Scopes,
    joints: &[JointBody],
    spanning: &SpanningTree,
    bodies: &[Option<LinkBody>],
    parts: &mut Parts,
    findings: &mut Findings<'_>,
) {
    let mut step_names = StepNames::new();
    for joint in joints {
        for axis in 0..joint.axes.len() {
            step_names.insert((joint.index, axis), step_name(joint, axis));
        }
    }
    let (mut link_names, mut joint_names) = (UniqueNames::default(), UniqueNames::default());
    link_names.reserve([GROUND].into_iter());
    link_names.reserve(scopes.frames.iter().map(|frame| frame.name.as_str()));
    joint_names.reserve(joints.iter().map(|joint| joint.name.as_str()));
    joint_names.reserve(step_names.values().map(String::as_str));
    let mut builder = ChainBuilder {
        scopes,
        parts,
        link_names: &mut link_names,
        joint_names: &mut joint_names,
        step_names: &step_names,
    };
    builder.parts.add_auxiliary(GROUND.to_owned(), scopes.scope(ScopeId(0)).element);
    for (link, body) in bodies.iter().enumerate() {
        let Some(body) = body else { continue };
        let (name, element) = (scopes.link_name(link), scopes.links[link].element);
        let inertial = Some(body.inertia.inertial);
        let described = LinkDescription { name: name.to_owned(), inertial, geometry: body.extent };
        let origin = LinkOrigin { element, link: Some(link), has_default_inertia: body.inertia.is_default };
        let added = (described, origin);
        let x_wl = scopes.relative_pose(FrameId(0), scopes.links[link].frame);
        let (kind, ending) = match spanning.supports[link] {
            Support::Joint { joint, reversed } => {
                builder.add_supported(&joints[joint], reversed, spanning.below[link], added);
                continue;
            }
            Support::Static => (JointKind::Fixed, "static"),
            Support::Floating => (JointKind::Floating, "floating"),
            Support::Absent => continue,
        };
        let joint_name = builder.joint_names.take(format!("{name}_{ending}"));
        if kind == JointKind::Floating {
            findings.add_once(Severity::Note, "floating", "floating", element, || {
                format!(
                    "no joint leads to the world, and the model is not static: the link {} floats, by the joint {}; lock \
                     that joint to hold it",
                    quoted(name),
                    quoted(&joint_name)
                )
            });
        }
        let joint = JointDescription::new(joint_name, kind, GROUND, name).origin(x_wl);
        builder.parts.joints.push((joint, element));
        builder.parts.links.push(added);
    }
}

/// Adds the named frames as massless links, so that contacts can be given in them.
fn add_frames(scopes: &Scopes, is_read: &[bool], parts: &mut Parts, findings: &mut Findings<'_>) {
    let mut names: HashSet<String> = parts.links.iter().map(|(link, _)| link.name.clone()).collect();
    let mut joint_names = UniqueNames::default();
    joint_names.reserve(parts.joints.iter().map(|(joint, _)| joint.name.as_str()));
    for (index, frame) in scopes.frames.iter().enumerate() {
        let is_within = frame.scope.0 == 0 || is_read[scopes.scope(frame.scope).top.0];
        if frame.kind != FrameKind::Frame || !is_within || names.contains(&frame.name) {
            continue;
        }
        let Some(body) = scopes.attached(FrameId(index)) else {
            findings.error("unknown-link", frame.element, || {
                "the frame is attached to no link: attached_to is a circle, or its model has no link"
                    .to_owned()
            });
            continue;
        };
        let is_present = match body {
            Attached::Ground => true,
            Attached::Link(link) => is_read[scopes.scope(scopes.links[link].scope).top.0],
        };
        if !is_present {
            continue;
        }
        names.insert(frame.name.clone());
        let joint = joint_names.take(format!("{}_frame", frame.name));
        let pose = scopes.relative_pose(body_frame(scopes, body), FrameId(index));
        let joint =
            JointDescription::new(joint, JointKind::Fixed, body_name(scopes, body), &frame.name).origin(pose);
        parts.joints.push((joint, frame.element));
        parts.add_auxiliary(&frame.name, frame.element);
    }
}
