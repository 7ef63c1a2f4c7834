//! Choice of the joints of the tree.
//!
//! SDFormat gives no tree: `parent` and `child` only name the ends of a joint, and a link can be the parent of all its joints. The tree is grown
//! from the ground along joints in either direction; the other joints close loops.

use crate::sdf::elements::joint::{JointBody, JointType};
use crate::sdf::frames::scopes::Attached;
use std::collections::{HashSet, VecDeque};

/// Node of the graph: 0 is the ground, link i is node i + 1.
fn node(body: Attached) -> usize {
    match body {
        Attached::Ground => 0,
        Attached::Link(link) => link + 1,
    }
}

/// Connection of a link to the tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Support {
    /// The link belongs to a static model.
    Static,
    /// Position in the list of joints. `reversed`: the link is the parent of the joint in the file.
    Joint { joint: usize, reversed: bool },
    /// No joint leads to the world.
    Floating,
    /// The link belongs to a model that is not read.
    Absent,
}

/// Spanning tree.
#[derive(Debug)]
pub(crate) struct SpanningTree {
    /// Support of each link.
    pub supports: Vec<Support>,
    /// Body that supports each link.
    pub below: Vec<Attached>,
    /// Per joint: true if it belongs to the tree.
    pub in_tree: Vec<bool>,
}

/// Classes of joints in the order in which they are taken into the tree.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Preference {
    /// Screws, joints with a rotor or in a mimic or gearbox: they cannot close a loop.
    Required,
    First,
    /// The child already has a joint to a parent.
    SecondParent,
    /// Marked by the file as closing a loop.
    Loop,
}

/// Grows the tree. `links`: per link, `None` for a link that is not read, else true for a static one. `leaders`: joints that another
/// follows, as indices of the file.
pub(crate) fn grow_tree(
    joints: &[JointBody],
    links: &[Option<bool>],
    leaders: &HashSet<usize>,
) -> SpanningTree {
    let geared: HashSet<Attached> = joints
        .iter()
        .filter(|joint| joint.kind == JointType::Gearbox)
        .flat_map(|joint| [joint.parent, Attached::Link(joint.child)])
        .collect();
    let mut children = HashSet::new();
    let mut order: Vec<(Preference, usize)> = Vec::new();
    for (position, joint) in joints.iter().enumerate() {
        if joint.kind == JointType::Gearbox {
            continue;
        }
        let is_first = children.insert(joint.child);
        let is_required = joint.kind == JointType::Screw
            || joint.armature != 0.0
            || joint.axes.iter().any(|axis| axis.mimic.is_some())
            || leaders.contains(&joint.index)
            || geared.contains(&Attached::Link(joint.child));
        let preference = if is_required {
            Preference::Required
        } else if joint.is_loop_joint {
            Preference::Loop
        } else if is_first {
            Preference::First
        } else {
            Preference::SecondParent
        };
        order.push((preference, position));
    }
    order.sort();
    let mut sets = DisjointSets::new(links.len() + 1);
    for (link, is_static) in links.iter().enumerate() {
        if *is_static == Some(true) {
            sets.join(0, link + 1);
        }
    }
    let mut in_tree = vec![false; joints.len()];
    for (_, position) in order {
        let joint = &joints[position];
        in_tree[position] = sets.join(node(joint.parent), joint.child + 1);
    }
    direct_tree(joints, links, in_tree)
}

/// Directs the tree away from the ground, and from a base link of each part that floats.
fn direct_tree(joints: &[JointBody], links: &[Option<bool>], in_tree: Vec<bool>) -> SpanningTree {
    let mut adjacent: Vec<Vec<usize>> = vec![Vec::new(); links.len() + 1];
    let mut is_child = vec![false; links.len()];
    for (position, joint) in joints.iter().enumerate().filter(|(position, _)| in_tree[*position]) {
        adjacent[node(joint.parent)].push(position);
        adjacent[joint.child + 1].push(position);
        is_child[joint.child] = true;
    }
    let mut tree = SpanningTree {
        supports: vec![Support::Absent; links.len()],
        below: vec![Attached::Ground; links.len()],
        in_tree,
    };
    let mut queue = VecDeque::from([Attached::Ground]);
    for (link, is_static) in links.iter().enumerate() {
        if *is_static == Some(true) {
            tree.supports[link] = Support::Static;
            queue.push_back(Attached::Link(link));
        }
    }
    tree.spread(joints, &adjacent, queue);
    // The base is a link that is the child of no joint, if one exists.
    let by_choice = (0..links.len()).filter(|link| !is_child[*link]).chain(0..links.len());
    for link in by_choice {
        if links[link].is_some() && tree.supports[link] == Support::Absent {
            tree.supports[link] = Support::Floating;
            tree.spread(joints, &adjacent, VecDeque::from([Attached::Link(link)]));
        }
    }
    tree
}

impl SpanningTree {
    /// Gives a support to all links that joints of the tree connect to the bodies in `queue`.
    fn spread(&mut self, joints: &[JointBody], adjacent: &[Vec<usize>], mut queue: VecDeque<Attached>) {
        while let Some(body) = queue.pop_front() {
            for &position in &adjacent[node(body)] {
                let joint = &joints[position];
                let (other, reversed) = if Attached::Link(joint.child) == body {
                    (joint.parent, true)
                } else {
                    (Attached::Link(joint.child), false)
                };
                if let Attached::Link(link) = other
                    && self.supports[link] == Support::Absent
                {
                    self.supports[link] = Support::Joint { joint: position, reversed };
                    self.below[link] = body;
                    queue.push_back(other);
                }
            }
        }
    }
}

/// Union of sets, with path halving.
struct DisjointSets {
    parents: Vec<usize>,
}

impl DisjointSets {
    fn new(count: usize) -> Self {
        Self { parents: (0..count).collect() }
    }

    /// Representative element of the set of `i`.
    fn root(&mut self, mut i: usize) -> usize {
        while self.parents[i] != i {
            self.parents[i] = self.parents[self.parents[i]];
            i = self.parents[i];
        }
        i
    }

    /// Joins the sets of two elements; false if they are in one set.
    fn join(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[b] = a;
        a != b
    }
}
