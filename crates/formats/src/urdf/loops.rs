//! References of loops, couplings and second parent joints. The checks run here, because the positions in the file
//! are known and the cost is bounded.

use crate::reading::limits::MAX_COUPLING_STEPS;
use crate::reading::report::{Place, Report, quoted, shortened};
use crate::reading::xml::Node;
use crate::urdf::elements::closure::link_tags;
use crate::urdf::elements::joints::joint::JointText;
use crate::urdf::elements::nodes::Nodes;
use crate::urdf::elements::survey::child;
use crate::urdf::references::{Suggestions, index_by_name};
use crate::urdf::texts::Texts;
use percuss_mechanism::{Problem, Severity};
use std::collections::{HashMap, HashSet};

/// True for each joint whose child is already the child of an earlier joint. The builder turns these joints into
/// closures.
pub(crate) fn find_loop_closing_joints(joints: &[JointText<'_>]) -> Vec<bool> {
    let mut children = HashSet::new();
    joints.iter().map(|joint| !children.insert(joint.child)).collect()
}

/// Contents of a file with their XML elements, and the flags of joints that close loops.
pub(crate) struct LoopChecks<'f, 'a> {
    pub texts: &'f Texts<'a>,
    pub nodes: &'f Nodes<'a>,
    /// Result of [`find_loop_closing_joints`].
    pub closes_loop: &'f [bool],
}

impl<'a> LoopChecks<'_, 'a> {
    /// Reports unknown links, repeated names, properties that closures cannot have, and too many couplings.
    pub fn check_all(&self, suggestions: &mut Suggestions, report: &mut Report) {
        let links = index_by_name(self.texts.links.iter().map(|l| l.name));
        for (closure, node) in self.texts.closures.iter().zip(&self.nodes.closures) {
            let names = [closure.predecessor.as_str(), &closure.successor];
            self.check_link_names(
                *node,
                names,
                &|link| link == "world" || links.contains_key(link),
                suggestions,
                report,
            );
        }
        for (coupling, node) in self.texts.couplings.iter().zip(&self.nodes.couplings) {
            let names = [coupling.predecessor.as_str(), &coupling.successor];
            self.check_link_names(*node, names, &|link| links.contains_key(link), suggestions, report);
        }
        self.check_unique_names(report);
        self.refuse_mimics_of_closures(report);
        self.note_unused_limits(report);
        if self.coupling_path_lengths() > MAX_COUPLING_STEPS {
            report.error("too-complex", Place::File, || {
                format!(
                    "the couplings' paths to the root have more than {MAX_COUPLING_STEPS} joints together"
                )
            });
        }
    }

    /// Reports unknown links at both ends of a loop or coupling.
    fn check_link_names(
        &self,
        node: Node<'a>,
        names: [&str; 2],
        exists: &dyn Fn(&str) -> bool,
        suggestions: &mut Suggestions,
        report: &mut Report,
    ) {
        for ((tag, role), name) in link_tags(node).iter().zip(["predecessor", "successor"]).zip(names) {
            // An empty name means that the name is missing; this error is already reported.
            let element = child(node, tag).filter(|_| !name.is_empty());
            if let Some(element) = element
                && !exists(name)
            {
                let near = suggestions.similar_names(name, self.texts.links.iter().map(|l| l.name));
                let problem = Problem::UnknownLink { role, link: shortened(name), near };
                report.add_problem(Place::Element(element), &problem);
            }
        }
    }

    /// Closures, couplings and joints that close loops share one set of names.
    fn check_unique_names(&self, report: &mut Report) {
        let closures = self.texts.closures.iter().map(|c| c.name.as_str()).zip(&self.nodes.closures);
        let couplings = self.texts.couplings.iter().map(|c| c.name.as_str()).zip(&self.nodes.couplings);
        let relations = self.texts.relations.iter().map(|r| r.name.as_str()).zip(&self.nodes.relations);
        let joints = self.texts.joints.iter().map(|j| j.name).zip(&self.nodes.joints);
        let joints = joints.zip(self.closes_loop).filter(|(_, closes)| **closes).map(|(named, _)| named);
        let mut given: HashMap<&str, Node<'a>> = HashMap::new();
        for (name, node) in
            closures.chain(couplings).chain(relations).chain(joints).filter(|(name, _)| !name.is_empty())
        {
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

    /// A joint that closes a loop has no position coordinate to mimic.
    fn refuse_mimics_of_closures(&self, report: &mut Report) {
        let closing = self.texts.joints.iter().zip(self.closes_loop).filter(|(_, closes)| **closes);
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

    /// A joint that closes a loop has no position coordinate to limit.
    fn note_unused_limits(&self, report: &mut Report) {
        let closing = self.texts.joints.iter().zip(&self.nodes.joints).zip(self.closes_loop);
        for ((_, node), _) in closing.filter(|((joint, _), closes)| **closes && joint.limits.is_some()) {
            let place = child(*node, "limit").map_or(Place::Element(*node), Place::Element);
            report.add_once(Severity::Note, "unused-element", "limit".to_owned(), place, || {
                "the joint closes a loop, and its limits are not checked; give limits to a joint of the tree".to_owned()
            });
        }
    }

    /// Number of joints on the paths from coupled links to the root, summed: the work of the builder.
    fn coupling_path_lengths(&self) -> usize {
        if self.texts.couplings.is_empty() {
            return 0;
        }
        let tree = self.texts.joints.iter().zip(self.closes_loop).filter(|(_, closes)| !**closes);
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
