//! References of joints by name. The checks run here, because the positions in the file are known and the cost is
//! bounded.

use crate::reading::limits::{LONGEST_MIMIC_CHAIN, MOST_CANDIDATES, MOST_SUGGESTIONS};
use crate::reading::report::{Place, Report, shortened};
use crate::urdf::elements::joint::JointText;
use crate::urdf::elements::link::LinkText;
use crate::urdf::elements::survey::child;
use percuss_mechanism::{Problem, near_names};
use roxmltree::Node;
use std::collections::HashMap;

/// Index of the first occurrence of each name.
pub(crate) fn index<'a>(names: impl Iterator<Item = &'a str>) -> HashMap<&'a str, usize> {
    let mut index = HashMap::new();
    for (i, name) in names.enumerate() {
        index.entry(name).or_insert(i);
    }
    index
}

/// Search for similar names, limited in number because of its cost.
pub(crate) struct Suggestions {
    left: usize,
}

impl Suggestions {
    pub fn new() -> Self {
        Self { left: MOST_SUGGESTIONS }
    }

    pub fn near<'a>(&mut self, name: &str, names: impl Iterator<Item = &'a str>) -> Vec<String> {
        if self.left == 0 {
            return Vec::new();
        }
        self.left -= 1;
        near_names(name, names.take(MOST_CANDIDATES)).iter().map(|n| shortened(n)).collect()
    }
}

/// Checks the link and joint names in joints. A mimic of an unknown joint is dropped, with a warning.
pub(crate) fn check<'a, 'i: 'a>(
    links: &[LinkText<'a>],
    joints: &mut [JointText<'a>],
    nodes: &[Node<'a, 'i>],
    joint_index: &HashMap<&'a str, usize>,
    suggestions: &mut Suggestions,
    report: &mut Report,
) {
    let link_index = index(links.iter().map(|l| l.name));
    for (joint, node) in joints.iter().zip(nodes) {
        for (role, name) in [("parent", joint.parent), ("child", joint.child)] {
            // An empty name stands for a missing one, which is reported already.
            let element = child(*node, role).filter(|n| n.has_attribute("link"));
            if let Some(element) = element
                && !link_index.contains_key(name)
            {
                let near = suggestions.near(name, links.iter().map(|l| l.name));
                let problem = Problem::UnknownLink { role, link: shortened(name), near };
                report
                    .add(problem.severity(), problem.code(), Place::Element(element), || problem.to_string());
            }
        }
    }
    let names: Vec<&str> = joints.iter().map(|j| j.name).collect();
    for (joint, node) in joints.iter_mut().zip(nodes) {
        let Some(mimic) = &joint.mimic else { continue };
        if !joint_index.contains_key(mimic.joint) && !mimic.joint.is_empty() {
            let near = suggestions.near(mimic.joint, names.iter().copied());
            let problem = Problem::DanglingMimic { master: shortened(mimic.joint), near };
            let place = child(*node, "mimic").map_or(Place::Element(*node), Place::Element);
            report.add(problem.severity(), problem.code(), place, || problem.to_string());
            joint.mimic = None;
        }
    }
    chains(joints, nodes, joint_index, report);
}

/// Refuses cycles and long chains of mimics, whose cost and messages would grow with their length.
fn chains<'a, 'i: 'a>(
    joints: &[JointText<'a>],
    nodes: &[Node<'a, 'i>],
    index: &HashMap<&'a str, usize>,
    report: &mut Report,
) {
    let master = |joint: &JointText<'a>| joint.mimic.as_ref().and_then(|m| index.get(m.joint).copied());
    let next: Vec<Option<usize>> = joints.iter().map(master).collect();
    let mut told = vec![false; joints.len()];
    for (start, node) in nodes.iter().enumerate() {
        // A cycle is reported once, at the first joint that leads to it.
        let walk = std::iter::successors(Some(start), |i| next[*i]).take_while(|i| !told[*i]);
        let path: Vec<usize> = walk.take(LONGEST_MIMIC_CHAIN + 1).collect();
        if path.len() <= LONGEST_MIMIC_CHAIN {
            continue;
        }
        let place = child(*node, "mimic").map_or(Place::Element(*node), Place::Element);
        let closes =
            |(step, joint): (usize, &usize)| path[..step].iter().position(|j| j == joint).map(|i| i..step);
        let Some(circle) = path.iter().enumerate().find_map(closes) else {
            report.error("mimic-chain", place, || {
                format!("more than {LONGEST_MIMIC_CHAIN} joints mimic one another in a row")
            });
            return;
        };
        let circle = &path[circle];
        circle.iter().for_each(|joint| told[*joint] = true);
        let names = circle.iter().map(|joint| shortened(joints[*joint].name)).collect();
        let problem = Problem::MimicCycle { joints: names };
        report.add(problem.severity(), problem.code(), place, || problem.to_string());
    }
}
