//! Validation of closures and couplings.

use crate::axis::unit;
use crate::checks::check::Check;
use crate::elements::closure::{Closure, ClosureKind, LoopFrame};
use crate::elements::coupling::{Coupling, LinkRatio};
use crate::limits;
use crate::problem::{Problem, Subject};
use crate::{
    ClosureDescription, CouplingDescription, JointDescription, JointId, JointKind, LinkDescription, LinkId,
    Mechanism,
};
use percuss_spatial::{Matrix3, Transform, Vector3};
use std::collections::HashMap;

/// Subject of a finding about closure number `index`.
fn closure_subject(index: usize, name: &str) -> Subject {
    Subject::Closure { index, name: name.to_owned() }
}

/// Subject of a finding about coupling number `index`.
pub(crate) fn coupling_subject(index: usize, name: &str) -> Subject {
    Subject::Coupling { index, name: name.to_owned() }
}

/// Converts a joint whose child already has a parent joint to a closure, or returns the reason why this is impossible.
pub(crate) fn of_joint(joint: JointDescription) -> Result<ClosureDescription, &'static str> {
    let kind = match joint.kind {
        JointKind::Fixed => ClosureKind::Fixed,
        JointKind::Revolute | JointKind::Continuous => ClosureKind::Revolute,
        JointKind::Prismatic => ClosureKind::Prismatic,
        JointKind::Planar => ClosureKind::Planar,
        JointKind::Spherical => ClosureKind::Spherical,
        JointKind::Floating => return Err("a floating joint constrains nothing"),
    };
    if joint.mimic.is_some() {
        return Err("it mimics another; let a joint of the tree mimic, or use a <coupling>");
    }
    if joint.armature.iter().any(|a| *a != 0.0) {
        return Err("it has an armature; put the rotor on a joint of the tree");
    }
    let axis = joint.axis;
    let new = ClosureDescription::new(joint.name, kind, joint.parent, joint.child);
    Ok(ClosureDescription { predecessor_frame: joint.origin, axis, ..new })
}

/// Checks names and numbers of closures and couplings; needs no tree.
pub(crate) fn check(
    closures: &[ClosureDescription],
    couplings: &[CouplingDescription],
    links: &[LinkDescription],
    ids: &HashMap<String, usize>,
    check: &mut Check,
) {
    check.unique(closures.iter().map(|c| &c.name), closure_subject);
    check.unique(couplings.iter().map(|c| &c.name), coupling_subject);
    let exists = |subject: &Subject, role: &'static str, link: &String, world: bool, check: &mut Check| {
        let known = ids.contains_key(link) || (world && link == "world");
        if !known {
            let near = check.near(link, links.iter().map(|l| l.name.as_str()));
            check.add(subject.clone(), Problem::UnknownLink { role, link: link.clone(), near });
        }
    };
    for (i, closure) in closures.iter().enumerate() {
        let subject = closure_subject(i, &closure.name);
        exists(&subject, "predecessor", &closure.predecessor, true, check);
        exists(&subject, "successor", &closure.successor, true, check);
        if closure.predecessor == closure.successor {
            check.add(subject.clone(), Problem::ClosesOnItself { link: closure.successor.clone() });
        }
        closure_numbers(&subject, closure, check);
    }
    for (i, coupling) in couplings.iter().enumerate() {
        let subject = coupling_subject(i, &coupling.name);
        exists(&subject, "predecessor", &coupling.predecessor, false, check);
        exists(&subject, "successor", &coupling.successor, false, check);
        if coupling.predecessor == coupling.successor {
            check.add(subject.clone(), Problem::ClosesOnItself { link: coupling.successor.clone() });
        }
        check.is_valid(&subject, "ratio", [&coupling.ratio]);
    }
    check_coupling_cycles(couplings, check);
}

/// Checks the numbers of a closure: loop frames, the axes that its kind uses (nonzero), and the distance (> 0).
fn closure_numbers(subject: &Subject, closure: &ClosureDescription, check: &mut Check) {
    for frame in [&closure.predecessor_frame, &closure.successor_frame] {
        check.is_valid(subject, "origin", &frame.translation);
        if check.is_valid(subject, "rotation", &frame.rotation) {
            let defect = (frame.rotation.transpose() * frame.rotation - Matrix3::identity()).amax();
            if defect > limits::ROTATION_DEFECT || frame.rotation.determinant() < 0.0 {
                check.add(subject.clone(), Problem::NotARotation { defect });
            }
        }
    }
    let axes: &[&Vector3<f64>] = match closure.kind {
        ClosureKind::Universal => &[&closure.axis, &closure.axis2],
        kind if kind.has_axis() => &[&closure.axis],
        _ => &[],
    };
    for axis in axes {
        if check.is_valid(subject, "axis", *axis) && axis.amax() < limits::SHORTEST_AXIS {
            check.add(subject.clone(), Problem::ZeroAxis);
        }
    }
    if let Some(distance) = closure.distance.filter(|_| closure.kind == ClosureKind::Distance)
        && check.is_valid(subject, "distance", [&distance])
        && distance <= 0.0
    {
        check.add(subject.clone(), Problem::BadDistance { distance });
    }
}

/// Adds an error for every coupling that closes a cycle of couplings between links: the ratios of a cycle contradict or
/// duplicate each other.
fn check_coupling_cycles(couplings: &[CouplingDescription], check: &mut Check) {
    let mut group: HashMap<&str, usize> = HashMap::new();
    let mut parent: Vec<usize> = Vec::new();
    /// Representative of the set of `i` (union–find, with path halving).
    fn root(parent: &mut [usize], mut i: usize) -> usize {
        while parent[i] != i {
            parent[i] = parent[parent[i]];
            i = parent[i];
        }
        i
    }
    for (i, coupling) in couplings.iter().enumerate() {
        if coupling.predecessor == coupling.successor {
            continue;
        }
        let ends = [&coupling.predecessor, &coupling.successor].map(|link| {
            *group.entry(link).or_insert_with(|| {
                parent.push(parent.len());
                parent.len() - 1
            })
        });
        let [a, b] = ends.map(|end| root(&mut parent, end));
        if a == b {
            let links = [coupling.predecessor.clone(), coupling.successor.clone()];
            check.add(coupling_subject(i, &coupling.name), Problem::CouplingCycle { links });
        }
        parent[a] = b;
    }
}

/// Adds the valid closures and couplings to the mechanism, with link names resolved. A coupling whose path has a joint
/// with several degrees of freedom, or no moving joint, adds an error instead.
pub(crate) fn attach(
    mechanism: &mut Mechanism,
    closures: &[ClosureDescription],
    couplings: &[CouplingDescription],
    check: &mut Check,
) {
    let frame = |mechanism: &Mechanism, link: &str, frame: Transform<f64>| LoopFrame {
        link: mechanism.link_by_name.get(link).copied(),
        frame,
    };
    mechanism.closures = closures
        .iter()
        .map(|c| Closure {
            name: c.name.clone(),
            kind: c.kind,
            predecessor: frame(mechanism, &c.predecessor, c.predecessor_frame),
            successor: frame(mechanism, &c.successor, c.successor_frame),
            axis: if c.kind.has_axis() { unit(&c.axis) } else { Vector3::x() },
            axis2: if c.kind == ClosureKind::Universal { unit(&c.axis2) } else { Vector3::y() },
            distance: c.distance.filter(|_| c.kind == ClosureKind::Distance),
        })
        .collect();
    for (i, coupling) in couplings.iter().enumerate() {
        let ends =
            [&coupling.predecessor, &coupling.successor].map(|l| mechanism.link_by_name.get(l).copied());
        let [Some(predecessor), Some(successor)] = ends else { continue };
        match terms(mechanism, predecessor, successor, coupling.ratio) {
            Ok(terms) => mechanism.couplings.push(Coupling {
                name: coupling.name.clone(),
                ratio: Some(LinkRatio { predecessor, successor, ratio: coupling.ratio }),
                terms,
                constant: 0.0,
                curve: None,
            }),
            Err(problem) => check.add(coupling_subject(i, &coupling.name), problem),
        }
    }
}

/// Joints and factors of the sum that a coupling keeps constant: Σ q over the path from the nearest common ancestor to
/// the successor, minus ratio · Σ q over the path to the predecessor. Factors: 1 and −ratio. Error if a joint has
/// several degrees of freedom, or if no joint moves.
fn terms(
    mechanism: &Mechanism,
    predecessor: LinkId,
    successor: LinkId,
    ratio: f64,
) -> Result<Vec<(JointId, f64)>, Problem> {
    let path = |mut link: LinkId| {
        let mut joints = Vec::new();
        while let Some(joint) = mechanism.parent_joint(link) {
            joints.push(joint);
            link = mechanism.joint(joint).parent();
        }
        joints
    };
    let (mut on, mut against) = (path(successor), path(predecessor));
    while on.last().is_some() && on.last() == against.last() {
        on.pop();
        against.pop();
    }
    let on = on.into_iter().map(|joint| (joint, 1.0));
    let mut terms = Vec::new();
    for (id, factor) in on.chain(against.into_iter().map(|joint| (joint, -ratio))) {
        let joint = mechanism.joint(id);
        match joint.kind().dofs() {
            0 => {}
            1 => terms.push((id, factor)),
            _ => {
                let problem =
                    Problem::CouplingKind { joint: joint.name().to_owned(), kind: joint.kind().name() };
                return Err(problem);
            }
        }
    }
    if terms.is_empty() { Err(Problem::CouplingOfNothing) } else { Ok(terms) }
}
