//! References of joints by name. The checks run here, because the positions in the file are known and the cost is
//! bounded.

use crate::reading::limits::{MAX_CANDIDATES, MAX_MIMIC_CHAIN, MAX_SUGGESTIONS};
use crate::reading::report::{Place, Report, shortened};
use crate::reading::xml::Node;
use crate::urdf::elements::joints::joint::JointText;
use crate::urdf::elements::link::LinkText;
use crate::urdf::elements::survey::child;
use percuss_mechanism::{Problem, near_names};
use std::collections::HashMap;

/// Index of the first occurrence of each name.
pub(crate) fn index_by_name<'a>(names: impl Iterator<Item = &'a str>) -> HashMap<&'a str, usize> {
    let mut index = HashMap::new();
    for (i, name) in names.enumerate() {
        index.entry(name).or_insert(i);
    }
    index
}

/// Searches for similar names, limited in number because of their cost.
pub(crate) struct Suggestions {
    /// Number of searches still allowed.
    remaining: usize,
}

impl Suggestions {
    /// Starts with `MAX_SUGGESTIONS` searches.
    pub fn new() -> Self {
        Self { remaining: MAX_SUGGESTIONS }
    }

    /// Names similar to `name`; empty when the searches are used up.
    pub fn similar_names<'a>(&mut self, name: &str, names: impl Iterator<Item = &'a str>) -> Vec<String> {
        if self.remaining == 0 {
            return Vec::new();
        }
        self.remaining -= 1;
        near_names(name, names.take(MAX_CANDIDATES)).iter().map(|n| shortened(n)).collect()
    }
}

/// Reports unknown links and joints in joints. A mimic of an unknown joint is dropped, with a warning.
pub(crate) fn check_joint_references<'a>(
    links: &[LinkText<'a>],
    joints: &mut [JointText<'a>],
    nodes: &[Node<'a>],
    joint_index: &HashMap<&'a str, usize>,
    suggestions: &mut Suggestions,
    report: &mut Report,
) {
    let link_index = index_by_name(links.iter().map(|l| l.name));
    for (joint, node) in joints.iter().zip(nodes) {
        for (role, name) in [("parent", joint.parent), ("child", joint.child)] {
            // An empty name means that the name is missing; this error is already reported.
            let element = child(*node, role).filter(|n| n.has_attribute("link"));
            if let Some(element) = element
                && !link_index.contains_key(name)
            {
                let near = suggestions.similar_names(name, links.iter().map(|l| l.name));
                let problem = Problem::UnknownLink { role, link: shortened(name), near };
                report.add_problem(Place::Element(element), &problem);
            }
        }
    }
    let names: Vec<&str> = joints.iter().map(|j| j.name).collect();
    for (joint, node) in joints.iter_mut().zip(nodes) {
        let Some(mimic) = &joint.mimic else { continue };
        if !joint_index.contains_key(mimic.joint) && !mimic.joint.is_empty() {
            let near = suggestions.similar_names(mimic.joint, names.iter().copied());
            let problem = Problem::DanglingMimic { master: shortened(mimic.joint), near };
            let place = child(*node, "mimic").map_or(Place::Element(*node), Place::Element);
            report.add_problem(place, &problem);
            joint.mimic = None;
        }
    }
    refuse_mimic_cycles(joints, nodes, joint_index, report);
}

/// Refuses cycles and long chains of mimics, whose cost and messages would grow with their length.
fn refuse_mimic_cycles<'a>(
    joints: &[JointText<'a>],
    nodes: &[Node<'a>],
    index: &HashMap<&'a str, usize>,
    report: &mut Report,
) {
    let master = |joint: &JointText<'a>| joint.mimic.as_ref().and_then(|m| index.get(m.joint).copied());
    let next: Vec<Option<usize>> = joints.iter().map(master).collect();
    let mut reported = vec![false; joints.len()];
    for (start, node) in nodes.iter().enumerate() {
        // A cycle is reported once, at the first joint that leads to it.
        let walk = std::iter::successors(Some(start), |i| next[*i]).take_while(|i| !reported[*i]);
        let path: Vec<usize> = walk.take(MAX_MIMIC_CHAIN + 1).collect();
        if path.len() <= MAX_MIMIC_CHAIN {
            continue;
        }
        let place = child(*node, "mimic").map_or(Place::Element(*node), Place::Element);
        let closing_step =
            |(step, joint): (usize, &usize)| path[..step].iter().position(|j| j == joint).map(|i| i..step);
        let Some(cycle) = path.iter().enumerate().find_map(closing_step) else {
            report.error("mimic-chain", place, || {
                format!("more than {MAX_MIMIC_CHAIN} joints mimic one another in a row")
            });
            return;
        };
        let cycle = &path[cycle];
        cycle.iter().for_each(|joint| reported[*joint] = true);
        let names = cycle.iter().map(|joint| shortened(joints[*joint].name)).collect();
        let problem = Problem::MimicCycle { joints: names };
        report.add_problem(place, &problem);
    }
}
