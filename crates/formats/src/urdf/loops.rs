//! References of loops, couplings and second parent joints. The checks run here, because the positions in the file
//! are known and the cost is bounded.

use crate::reading::limits::MAX_COUPLING_STEPS;
use crate::reading::report::{Place, Report, quoted, shortened};
use crate::urdf::elements::closure::end_tags;
use crate::urdf::elements::joint::JointText;
use crate::urdf::elements::nodes::Nodes;
use crate::urdf::elements::survey::child;
use crate::urdf::references::{Suggestions, index_by_name};
use crate::urdf::texts::Texts;
use percuss_mechanism::{Problem, Severity};
use roxmltree::Node;
use std::collections::{HashMap, HashSet};

/// True for each joint whose child is already the child of an earlier joint. The builder turns these joints into
/// closures.
pub(crate) fn second_parents(joints: &[JointText<'_>]) -> Vec<bool> {
    let mut children = HashSet::new();
    joints.iter().map(|joint| !children.insert(joint.child)).collect()
}

/// Contents of a file with their XML elements, and the flags of joints that close loops.
pub(crate) struct Loops<'f, 'a, 'i> {
    pub texts: &'f Texts<'a>,
    pub nodes: &'f Nodes<'a, 'i>,
    /// Result of [`second_parents`].
    pub is_second_parent: &'f [bool],
}

impl<'a, 'i: 'a> Loops<'_, 'a, 'i> {
    /// Checks the links named by loops and couplings, the names of loops and couplings, properties that joints in
    /// loops cannot have, and the amount of work caused by couplings.
    pub fn check(&self, suggestions: &mut Suggestions, report: &mut Report) {
        let links = index_by_name(self.texts.links.iter().map(|l| l.name));
        for (closure, node) in self.texts.closures.iter().zip(&self.nodes.closures) {
            let names = [closure.predecessor.as_str(), &closure.successor];
            self.check_ends(
                *node,
                names,
                &|link| link == "world" || links.contains_key(link),
                suggestions,
                report,
            );
        }
        for (coupling, node) in self.texts.couplings.iter().zip(&self.nodes.couplings) {
            let names = [coupling.predecessor.as_str(), &coupling.successor];
            self.check_ends(*node, names, &|link| links.contains_key(link), suggestions, report);
        }
        self.check_names(report);
        self.refuse_mimics(report);
        self.note_limits(report);
        if self.coupling_steps() > MAX_COUPLING_STEPS {
            report.error("too-complex", Place::File, || {
                format!(
                    "the couplings' paths to the root have more than {MAX_COUPLING_STEPS} joints together"
                )
            });
        }
    }

    /// Checks the link names at both ends of a loop or coupling.
    fn check_ends(
        &self,
        node: Node<'a, 'i>,
        names: [&str; 2],
        exists: &dyn Fn(&str) -> bool,
        suggestions: &mut Suggestions,
        report: &mut Report,
    ) {
        for ((tag, role), name) in end_tags(node).iter().zip(["predecessor", "successor"]).zip(names) {
            // An empty name means that the name is missing; this error is already reported.
            let element = child(node, tag).filter(|_| !name.is_empty());
            if let Some(element) = element
                && !exists(name)
            {
                let near = suggestions.similar_names(name, self.texts.links.iter().map(|l| l.name));
                let problem = Problem::UnknownLink { role, link: shortened(name), near };
                report
                    .add(problem.severity(), problem.code(), Place::Element(element), || problem.to_string());
            }
        }
    }

    /// Checks uniqueness: closures, couplings and joints that close loops share one set of names.
    fn check_names(&self, report: &mut Report) {
        let closures = self.texts.closures.iter().map(|c| c.name.as_str()).zip(&self.nodes.closures);
        let couplings = self.texts.couplings.iter().map(|c| c.name.as_str()).zip(&self.nodes.couplings);
        let joints = self.texts.joints.iter().map(|j| j.name).zip(&self.nodes.joints);
        let joints = joints.zip(self.is_second_parent).filter(|(_, second)| **second).map(|(named, _)| named);
        let mut given: HashMap<&str, Node<'a, 'i>> = HashMap::new();
        for (name, node) in closures.chain(couplings).chain(joints).filter(|(name, _)| !name.is_empty()) {
            if let Some(first) = given.get(name) {
                let tag = first.tag_name().name();
                report.error("duplicate-name", Place::Element(*node), || {
                    format!(
                        "the name was given before, to a <{tag}>; names must be unique among loops, couplings and \
                         joints that close loops"
                    )
                });
            } else {
                given.insert(name, *node);
            }
        }
    }

    /// Refuses mimics of joints that close loops, because these have no position coordinate.
    fn refuse_mimics(&self, report: &mut Report) {
        let closing = self.texts.joints.iter().zip(self.is_second_parent).filter(|(_, second)| **second);
        let closing: HashSet<&str> = closing.map(|(joint, _)| joint.name).collect();
        for (joint, node) in self.texts.joints.iter().zip(&self.nodes.joints) {
            let Some(mimic) = joint.mimic.as_ref().filter(|m| closing.contains(m.joint)) else { continue };
            let place = child(*node, "mimic").map_or(Place::Element(*node), Place::Element);
            report.error("mimic-of-closure", place, || {
                format!(
                    "mimics joint {}, which closes a loop and has no position of its own; mimic a joint of the \
                     tree, or use a <coupling>",
                    quoted(mimic.joint)
                )
            });
        }
    }

    /// Notes limits of joints that close loops: a closure has no position coordinate.
    fn note_limits(&self, report: &mut Report) {
        let closing = self.texts.joints.iter().zip(&self.nodes.joints).zip(self.is_second_parent);
        for ((_, node), _) in closing.filter(|((joint, _), second)| **second && joint.limits.is_some()) {
            let place = child(*node, "limit").map_or(Place::Element(*node), Place::Element);
            report.add_once(Severity::Note, "unused-element", "limit".to_owned(), place, || {
                "the joint closes a loop, its limits are not checked; limit a joint of the tree".to_owned()
            });
        }
    }

    /// Number of joints that the builder visits because of couplings; quadratic in the length of a chain.
    fn coupling_steps(&self) -> usize {
        if self.texts.couplings.is_empty() {
            return 0;
        }
        let tree = self.texts.joints.iter().zip(self.is_second_parent).filter(|(_, second)| !**second);
        let parent: HashMap<&str, &str> = tree.map(|(joint, _)| (joint.child, joint.parent)).collect();
        let mut depths: HashMap<&str, usize> = HashMap::new();
        let mut steps = 0usize;
        for link in self.texts.couplings.iter().flat_map(|c| [c.predecessor.as_str(), &c.successor]) {
            let mut path = Vec::new();
            let mut current = link;
            // The builder reports cycles of links; the length bound ends the walk.
            while path.len() <= self.texts.joints.len() && !depths.contains_key(current) {
                path.push(current);
                match parent.get(current) {
                    Some(above) => current = above,
                    None => break,
                }
            }
            let above = depths.get(current).map_or(0, |depth| depth + 1);
            for (i, link) in path.iter().rev().enumerate() {
                depths.insert(link, above + i);
            }
            steps = steps.saturating_add(depths.get(link).copied().unwrap_or(0));
        }
        steps
    }
}
