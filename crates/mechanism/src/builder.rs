//! Builds a mechanism from descriptions, with all validation.

use crate::axis::unit;
use crate::checks::check::Check;
use crate::checks::{bushes, closures, contacts, inertias, relations};
use crate::names::name_mark::NameMark;
use crate::problem::{Accept, Problem, Severity, Subject};
use crate::{
    BushDescription, ClosureDescription, ClosureKind, ContactDescription, CouplingDescription, Geometry,
    Inertial, Joint, JointDescription, JointId, JointKind, Link, LinkDescription, LinkId, Mechanism, Mimic,
    RelationDescription, tree,
};
use percuss_spatial::{SpatialInertia, Vector3};
use std::collections::HashMap;
use std::fmt;

/// Mechanism with the findings of the builder.
#[derive(Debug)]
pub struct Built {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Warnings and notes.
    pub findings: Vec<(Subject, Problem)>,
}

/// Error of the builder: at least one finding is an error.
#[derive(Debug, thiserror::Error)]
pub struct BuildError {
    /// All findings, including warnings and notes.
    pub findings: Vec<(Subject, Problem)>,
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors = self.findings.iter().filter(|(_, p)| p.severity() == Severity::Error);
        for (i, (subject, problem)) in errors.enumerate() {
            write!(f, "{}{subject}: {problem}", if i == 0 { "" } else { "\n" })?;
        }
        Ok(())
    }
}

/// Collects descriptions of links and joints; [`build`](Self::build) validates them.
#[derive(Clone, Debug, Default)]
pub struct MechanismBuilder {
    name: String,
    accept: Accept,
    links: Vec<LinkDescription>,
    joints: Vec<JointDescription>,
    /// Original index of each tree joint. The indices differ from the positions in `joints` once joints to
    /// second parents are removed.
    joint_index: Vec<usize>,
    closures: Vec<ClosureDescription>,
    couplings: Vec<CouplingDescription>,
    relations: Vec<RelationDescription>,
    contacts: Vec<ContactDescription>,
    bushes: Vec<BushDescription>,
}

impl MechanismBuilder {
    /// Creates a builder of an empty mechanism with this name.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// Sets the accepted findings.
    pub fn accept(mut self, accept: Accept) -> Self {
        self.accept = accept;
        self
    }

    /// Adds a link.
    pub fn link(mut self, link: LinkDescription) -> Self {
        self.links.push(link);
        self
    }

    /// Adds a joint.
    pub fn joint(mut self, joint: JointDescription) -> Self {
        self.joints.push(joint);
        self
    }

    /// Adds a joint that closes a loop.
    pub fn closure(mut self, closure: ClosureDescription) -> Self {
        self.closures.push(closure);
        self
    }

    /// Adds a coupling.
    pub fn coupling(mut self, coupling: CouplingDescription) -> Self {
        self.couplings.push(coupling);
        self
    }

    /// Adds a relation between joint positions. In the mechanism the relations are couplings, behind those of
    /// [`coupling`](Self::coupling).
    pub fn relation(mut self, relation: RelationDescription) -> Self {
        self.relations.push(relation);
        self
    }

    /// Adds a named contact.
    pub fn contact(mut self, contact: ContactDescription) -> Self {
        self.contacts.push(contact);
        self
    }

    /// Adds a bush.
    pub fn bush(mut self, bush: BushDescription) -> Self {
        self.bushes.push(bush);
        self
    }

    /// Applies `change` to the links added so far.
    #[must_use]
    pub fn map_links(mut self, change: impl FnMut(LinkDescription) -> LinkDescription) -> Self {
        self.links = self.links.into_iter().map(change).collect();
        self
    }

    /// Validates all descriptions and builds the mechanism.
    ///
    /// # Errors
    /// [`BuildError`] with all findings if one of them is an error. Checked: one root, tree structure, unique
    /// names, finite numbers, masses and armatures ≥ 0, no negative principal moment, nonzero axes, mimics that
    /// end at a joint with one degree of freedom.
    pub fn build(self) -> Result<Built, BuildError> {
        let mut check = Check::default();
        let built = self.assemble(&mut check);
        let findings = check.findings;
        match built {
            Some(mechanism) if !findings.iter().any(|(_, p)| p.severity() == Severity::Error) => {
                Ok(Built { mechanism, findings })
            }
            _ => Err(BuildError { findings }),
        }
    }

    /// Validates the descriptions and builds the mechanism. Findings are added to `check`; `None` if the tree cannot be
    /// built. A mechanism can also be returned together with errors, found after the tree was built.
    fn assemble(mut self, check: &mut Check) -> Option<Mechanism> {
        if self.links.is_empty() {
            check.add(Subject::Mechanism, Problem::NoLinks);
            return None;
        }
        let link_ids = check.unique(self.links.iter().map(|l| &l.name), link_subject);
        check.unique(self.joints.iter().map(|j| &j.name), joint_subject);
        for (i, link) in self.links.iter().enumerate() {
            check.link_numbers(link_subject(i, &link.name), link);
        }
        for (i, joint) in self.joints.iter().enumerate() {
            check.joint_numbers(joint_subject(i, &joint.name), joint);
        }
        closures::check(&self.closures, &self.couplings, &self.links, &link_ids, check);
        relations::check(&self.relations, self.couplings.len(), check);
        contacts::check(&self.contacts, &self.links, &link_ids, check);
        bushes::check(&self.bushes, &self.links, &link_ids, check);
        let second_parents = self.take_second_parents(check, &link_ids);
        self.closures.extend(second_parents);
        let joint_ids = self.joints.iter().enumerate().map(|(i, j)| (j.name.clone(), i)).collect();
        let ends = self.ends(check, &link_ids);
        let mimics = self.mimics(check, &joint_ids);
        if check.has_errors() {
            return None;
        }
        let names: Vec<String> = self.links.iter().map(|l| l.name.clone()).collect();
        let joint_names: Vec<&str> = self.joints.iter().map(|j| j.name.as_str()).collect();
        let tree = match tree::build(&names, &joint_names, &ends) {
            Ok(tree) => tree,
            Err(problem) => {
                check.add(Subject::Mechanism, problem);
                return None;
            }
        };
        let joints = self.joints(&ends, mimics);
        let mut links: Vec<Link> = self.links.iter().map(make_link).collect();
        for joint in &joints {
            let reach = joint.origin.translation.norm();
            let parent = &mut links[joint.parent.index()];
            parent.extent = parent.extent.max(reach);
        }
        let length = characteristic_length(&links, &joints, &self.closures, tree.root);
        for (i, link) in self.links.iter().enumerate() {
            let problem = match &link.inertial {
                Some(inertial) => inertias::check(inertial, length, self.accept.indefinite_inertia),
                None if tree.root.index() != i => Some(Problem::Massless),
                None => None,
            };
            if let Some(problem) = problem {
                check.add(link_subject(i, &link.name), problem);
            }
        }
        let mut mechanism = Mechanism::new(self.name, links, joints, tree, length);
        closures::attach(&mut mechanism, &self.closures, &self.couplings, check);
        relations::attach(&mut mechanism, &self.relations, self.couplings.len(), check);
        contacts::attach(&mut mechanism, &self.contacts);
        bushes::attach(&mut mechanism, &self.bushes, check);
        Some(mechanism)
    }

    /// Removes every joint whose child already has a parent joint, and returns these joints as closures. Adds a finding
    /// for each.
    fn take_second_parents(
        &mut self,
        check: &mut Check,
        ids: &HashMap<String, usize>,
    ) -> Vec<ClosureDescription> {
        let mut first_parent: HashMap<String, String> = HashMap::new();
        let mut closures = Vec::new();
        for (i, joint) in std::mem::take(&mut self.joints).into_iter().enumerate() {
            let known = ids.contains_key(&joint.parent) && ids.contains_key(&joint.child);
            let first =
                first_parent.get(&joint.child).filter(|_| known && joint.parent != joint.child).cloned();
            let Some(first) = first else {
                first_parent.entry(joint.child.clone()).or_insert_with(|| joint.name.clone());
                self.joint_index.push(i);
                self.joints.push(joint);
                continue;
            };
            let (subject, link) = (joint_subject(i, &joint.name), joint.child.clone());
            match closures::of_joint(joint) {
                Ok(closure) => {
                    check.add(subject, Problem::SecondParent { link, first });
                    closures.push(closure);
                }
                Err(why) => check.add(subject, Problem::NoClosure { link, first, why }),
            }
        }
        closures
    }

    /// Links at the ends of every joint. An unknown name adds an error and gets an invalid index.
    fn ends(&self, check: &mut Check, ids: &HashMap<String, usize>) -> Vec<(LinkId, LinkId)> {
        let mut ends = Vec::with_capacity(self.joints.len());
        for (i, joint) in self.joints.iter().enumerate() {
            let subject = self.tree_joint(i);
            let mut find = |role: &'static str, link: &String| {
                ids.get(link).copied().unwrap_or_else(|| {
                    let near = check.near(link, self.links.iter().map(|l| l.name.as_str()));
                    check.add(subject.clone(), Problem::UnknownLink { role, link: link.clone(), near });
                    usize::MAX
                })
            };
            let (parent, child) = (find("parent", &joint.parent), find("child", &joint.child));
            if parent == child && parent != usize::MAX {
                check.add(subject.clone(), Problem::JoinsItself { link: joint.child.clone() });
            }
            ends.push((LinkId::new(parent, &joint.parent), LinkId::new(child, &joint.child)));
        }
        ends
    }

    /// Subject for the tree joint at position `i`, with its original index.
    fn tree_joint(&self, i: usize) -> Subject {
        joint_subject(self.joint_index[i], &self.joints[i].name)
    }

    /// Mimic of every joint, with a chain of mimics folded into one relation to the joint at its end, which mimics no
    /// other. Adds an error for a cycle. Each joint is resolved once: linear cost.
    fn mimics(&self, check: &mut Check, ids: &HashMap<String, usize>) -> Vec<Option<Mimic>> {
        let next: Vec<Option<usize>> = (0..self.joints.len()).map(|i| self.mimicked(check, ids, i)).collect();
        let mut resolved: Vec<Option<Mimic>> = vec![None; self.joints.len()];
        let mut done = vec![false; self.joints.len()];
        let mut on_chain = vec![false; self.joints.len()];
        for start in 0..self.joints.len() {
            let mut chain = Vec::new();
            let mut at = start;
            while !done[at] && !on_chain[at] {
                on_chain[at] = true;
                chain.push(at);
                match next[at] {
                    Some(master) => at = master,
                    None => break,
                }
            }
            if on_chain[at] && next[at].is_some() {
                let first = chain.iter().position(|&i| i == at).unwrap_or(0);
                let joints = chain[first..].iter().map(|&i| self.joints[i].name.clone()).collect();
                check.add(self.tree_joint(at), Problem::MimicCycle { joints });
            }
            while let Some(i) = chain.pop() {
                (done[i], on_chain[i]) = (true, false);
                let (Some(master), Some(mimic)) = (next[i], &self.joints[i].mimic) else { continue };
                let own = Mimic {
                    master: JointId::new(master, &self.joints[master].name),
                    multiplier: mimic.multiplier,
                    offset: mimic.offset,
                };
                let folded = match resolved[master] {
                    None => own,
                    Some(further) => Mimic {
                        master: further.master,
                        multiplier: own.multiplier * further.multiplier,
                        offset: own.offset + own.multiplier * further.offset,
                    },
                };
                // Each factor of a chain is valid, but the product may overflow.
                check.is_valid(&self.tree_joint(i), "mimic", [&folded.multiplier, &folded.offset]);
                resolved[i] = Some(folded);
            }
        }
        resolved
    }

    /// Index of the joint that joint `i` mimics directly. `None` if there is no mimic, or if the mimic is invalid (adds an
    /// error): unknown joint, or a joint without exactly one degree of freedom.
    fn mimicked(&self, check: &mut Check, ids: &HashMap<String, usize>, i: usize) -> Option<usize> {
        let joint = &self.joints[i];
        let mimic = joint.mimic.as_ref()?;
        let subject = self.tree_joint(i);
        let Some(&master) = ids.get(&mimic.joint) else {
            let near = check.near(&mimic.joint, self.joints.iter().map(|j| j.name.as_str()));
            check.add(subject, Problem::DanglingMimic { master: mimic.joint.clone(), near });
            return None;
        };
        for either in [joint, &self.joints[master]] {
            if either.kind.dofs() != 1 {
                let problem = Problem::MimicKind { joint: either.name.clone(), kind: either.kind.name() };
                check.add(subject, problem);
                return None;
            }
        }
        Some(master)
    }

    /// Joints of the tree, in the order of the descriptions: axes of unit length, one armature per velocity. `ends`: parent
    /// and child of each joint; `mimics`: resolved mimic of each joint.
    fn joints(&self, ends: &[(LinkId, LinkId)], mimics: Vec<Option<Mimic>>) -> Vec<Joint> {
        let make = |((joint, &(parent, child)), mimic): ((&JointDescription, _), _)| Joint {
            name: joint.name.clone(),
            mark: NameMark::of(&joint.name),
            kind: joint.kind,
            parent,
            child,
            origin: joint.origin,
            axis: if joint.kind.has_axis() { unit(&joint.axis) } else { Vector3::z() },
            limits: joint.limits.filter(|l| l.lower <= l.upper && joint.kind != JointKind::Continuous),
            armature: match joint.armature[..] {
                [] => vec![0.0; joint.kind.dofs()],
                [value] => vec![value; joint.kind.dofs()],
                _ => joint.armature.clone(),
            },
            mimic,
            rate_limit: joint
                .rate_limit
                .filter(|rate| rate.is_finite() && *rate > 0.0 && joint.kind.dofs() == 1),
            independent: joint.independent,
            spring: joint.spring,
            gear: joint.gear,
        };
        self.joints.iter().zip(ends).zip(mimics).map(make).collect()
    }
}

fn link_subject(index: usize, name: &str) -> Subject {
    Subject::Link { index, name: name.to_owned() }
}

fn joint_subject(index: usize, name: &str) -> Subject {
    Subject::Joint { index, name: name.to_owned() }
}

/// Link with its inertia about the origin and its extent (m): the largest of the distance of the centre of mass, the
/// radius of gyration and the radius of the shape. Child joints are not yet included.
fn make_link(link: &LinkDescription) -> Link {
    let reach = match link.geometry {
        Geometry::None | Geometry::Mesh => 0.0,
        Geometry::Within(radius) => radius,
    };
    let extent = link.inertial.as_ref().map_or(0.0, |i| i.com.norm().max(gyration(i))).max(reach);
    Link {
        name: link.name.clone(),
        mark: NameMark::of(&link.name),
        inertia: link.inertial.as_ref().map_or_else(SpatialInertia::zero, Inertial::spatial),
        inertial: link.inertial,
        geometry: link.geometry,
        extent,
    }
}

/// Upper bound of the radius of gyration, m; zero without mass.
fn gyration(inertial: &Inertial) -> f64 {
    if inertial.mass > 0.0 { (inertial.about_com.trace().abs() / inertial.mass).sqrt() } else { 0.0 }
}

/// Characteristic length, m: largest distance from a link's origin to its centre of mass, the end of its shape, a
/// child joint or a loop frame, or length of a distance closure; the root is excluded. If all are zero: the extent of the
/// root, then the largest radius of gyration, then 1. The radius of gyration comes last, since files give massless frames
/// a tiny mass with an arbitrary inertia.
fn characteristic_length(
    links: &[Link],
    joints: &[Joint],
    closures: &[ClosureDescription],
    root: LinkId,
) -> f64 {
    let reach = |link: &Link| {
        let shape = match link.geometry {
            Geometry::None | Geometry::Mesh => 0.0,
            Geometry::Within(radius) => radius,
        };
        link.inertial.map_or(0.0, |i| i.com.norm()).max(shape)
    };
    let of_links = links.iter().enumerate().filter(|&(i, _)| i != root.index()).map(|(_, l)| reach(l));
    let of_joints = joints.iter().filter(|j| j.parent != root).map(|j| j.origin.translation.norm());
    let root_name = &links[root.index()].name;
    let of_closures = closures
        .iter()
        .flat_map(|c| [(&c.predecessor, &c.predecessor_frame), (&c.successor, &c.successor_frame)])
        .filter(|(link, _)| *link != root_name && *link != "world")
        .map(|(_, frame)| frame.translation.norm())
        .chain(closures.iter().filter_map(|c| c.distance.filter(|_| c.kind == ClosureKind::Distance)));
    let lengths = [
        of_links.chain(of_joints).chain(of_closures).fold(0.0, f64::max),
        links[root.index()].extent,
        links.iter().map(|l| l.extent).fold(0.0, f64::max),
    ];
    lengths.into_iter().find(|length| *length > 0.0).unwrap_or(1.0)
}
