//! Validation of bushes.

use crate::checks::check::Check;
use crate::elements::bush::{Bush, BushDescription};
use crate::problem::{Problem, Subject};
use crate::{ClosureId, JointId, LinkDescription, LinkId, Mechanism};
use percuss_spatial::Matrix3;
use std::collections::HashMap;

/// Subject of a finding about bush number `index`.
fn bush_subject(index: usize, name: &str) -> Subject {
    Subject::Bush { index, name: name.to_owned() }
}

/// Checks names and numbers of bushes; needs no tree.
pub(crate) fn check(
    bushes: &[BushDescription],
    links: &[LinkDescription],
    ids: &HashMap<String, usize>,
    check: &mut Check,
) {
    check.unique(bushes.iter().map(|bush| &bush.name), bush_subject);
    for (i, bush) in bushes.iter().enumerate() {
        let subject = bush_subject(i, &bush.name);
        for (role, link, is_ground) in
            [("bush", &bush.link, false), ("other", &bush.against, bush.against == "world")]
        {
            if !ids.contains_key(link) && !is_ground {
                let near = check.near(link, links.iter().map(|l| l.name.as_str()));
                check.add(subject.clone(), Problem::UnknownLink { role, link: link.clone(), near });
            }
        }
        if bush.link == bush.against {
            check.add(subject.clone(), Problem::ClosesOnItself { link: bush.link.clone() });
        }
        check.frame(&subject, &bush.frame);
        let finite: Vec<&f64> = bush.stiffness.iter().filter(|k| **k != f64::INFINITY).collect();
        let numbers =
            finite.into_iter().chain(&bush.damping).chain([&bush.loss_factor, &bush.dynamic_factor]);
        let numbers: Vec<f64> = numbers.copied().collect();
        let is_lost = |(k, preload): (&f64, &f64)| *preload != 0.0 && (*k == f64::INFINITY || *k == 0.0);
        if check.is_valid(&subject, "preload", &bush.preload)
            && bush.stiffness.iter().zip(&bush.preload).any(is_lost)
        {
            let why = "a preload needs a finite stiffness above 0 in its direction";
            check.add(subject.clone(), Problem::BadBush { why: why.to_owned() });
        }
        if check.is_valid(&subject, "stiffness or damping", &numbers)
            && (numbers.iter().any(|x| *x < 0.0) || bush.dynamic_factor == 0.0)
        {
            let why = "its stiffness, damping and loss factor must be 0 or more, its dynamic factor above 0";
            check.add(subject, Problem::BadBush { why: why.to_owned() });
        }
    }
}

/// Adds the checked bushes to the mechanism, with links, joints and closures resolved. Adds an error for a joint that a bush cannot replace.
pub(crate) fn attach(mechanism: &mut Mechanism, bushes: &[BushDescription], check: &mut Check) {
    let mut free: HashMap<JointId, bool> = HashMap::new();
    for (i, description) in bushes.iter().enumerate() {
        match resolve(mechanism, description, &mut free) {
            Ok(bush) => mechanism.bushes.push(bush),
            Err(problem) => check.add(bush_subject(i, &description.name), problem),
        }
    }
}

/// Bush with resolved names. `free`: for every joint that a bush replaces, true if the joint becomes free.
fn resolve(
    mechanism: &Mechanism,
    description: &BushDescription,
    free: &mut HashMap<JointId, bool>,
) -> Result<Bush, Problem> {
    let unknown = |link: &str| Problem::UnknownLink { role: "bush", link: link.to_owned(), near: Vec::new() };
    let link = mechanism.find_link(&description.link).map_err(|_| unknown(&description.link))?;
    let against = mechanism.link_named(&description.against);
    let mut bush =
        Bush { description: description.clone(), link, against, joints: Vec::new(), closures: Vec::new() };
    for name in &description.replaces {
        let closure = mechanism.closures.iter().position(|closure| closure.name == *name);
        match (mechanism.joint_by_name.get(name), closure) {
            (Some(joint), _) => bush.joints.push(*joint),
            (None, Some(closure)) => bush.closures.push(ClosureId(closure as u32)),
            (None, None) => {
                let names = mechanism.joints.iter().map(|joint| joint.name.as_str());
                let names = names.chain(mechanism.closures.iter().map(|closure| closure.name.as_str()));
                let near = crate::near_names(name, names);
                return Err(Problem::UnknownJoint { joint: name.clone(), near });
            }
        }
    }
    let bad = |why: String| Err(Problem::BadBush { why });
    let mut on_path = path(mechanism, link, against);
    if bush.joints.iter().any(|joint| !on_path.contains(joint))
        || !bush.joints.is_empty() && on_path.iter().any(|joint| !bush.joints.contains(joint))
    {
        on_path.sort_unstable();
        let names: Vec<&str> = on_path.iter().map(|joint| mechanism.joint(*joint).name()).collect();
        return bad(format!(
            "it must replace all joints between its two links ({}) or none of them",
            if names.is_empty() { "none".to_owned() } else { names.join(", ") }
        ));
    }
    for (i, joint) in bush.joints.iter().enumerate() {
        let declared = mechanism.joint(*joint);
        let is_last = i + 1 == bush.joints.len();
        let in_relation = mechanism
            .joints
            .iter()
            .any(|other| other.mimic.is_some_and(|m| m.master == *joint))
            || mechanism.couplings.iter().any(|coupling| coupling.terms.iter().any(|term| term.0 == *joint));
        if declared.mimic.is_some() || in_relation || declared.armature.iter().any(|a| *a != 0.0) {
            return bad(format!(
                "joint \"{}\" has a rotor, or its position is in a relation to others: a bush cannot replace it",
                declared.name
            ));
        }
        if !is_last && mechanism.link(declared.child).inertia.mass > 0.0 {
            let child = mechanism.link(declared.child).name();
            return bad(format!(
                "link \"{child}\" between its two links has a mass: give it a bush of its own"
            ));
        }
        if *free.entry(*joint).or_insert(is_last) != is_last {
            return bad(format!("joint \"{}\" is replaced by other bushes in another order", declared.name));
        }
    }
    Ok(bush)
}

/// Joints of the tree between two links.
fn path(mechanism: &Mechanism, link: LinkId, against: Option<LinkId>) -> Vec<JointId> {
    let up = |from: LinkId| {
        std::iter::successors(mechanism.parent_joint(from), |joint| {
            mechanism.parent_joint(mechanism.joint(*joint).parent())
        })
        .collect::<Vec<_>>()
    };
    let (mut own, mut other) = (up(link), up(against.unwrap_or(mechanism.root)));
    while let (Some(a), Some(b)) = (own.last(), other.last())
        && a == b
    {
        own.pop();
        other.pop();
    }
    own.extend(other);
    own
}

impl Check {
    /// Checks the numbers of a frame.
    fn frame(&mut self, subject: &Subject, frame: &percuss_spatial::Transform<f64>) {
        self.is_valid(subject, "origin", &frame.translation);
        if self.is_valid(subject, "rotation", &frame.rotation) {
            let defect = (frame.rotation.transpose() * frame.rotation - Matrix3::identity()).amax();
            if defect > crate::limits::ROTATION_DEFECT {
                self.add(subject.clone(), Problem::NotARotation { defect });
            }
        }
    }
}
