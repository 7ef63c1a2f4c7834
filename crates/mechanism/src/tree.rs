//! Validates the tree structure and orders the links, parents before children.

use crate::{JointId, LinkId, Problem};

/// Tree in lists, indexed by link.
pub(crate) struct Tree {
    pub root: LinkId,
    /// Joint to the parent of each link; `None` for the root.
    pub parent_joint: Vec<Option<JointId>>,
    /// Joints to the children of each link, in the given order.
    pub child_joints: Vec<Vec<JointId>>,
    /// All links, parents first.
    pub order: Vec<LinkId>,
}

/// Builds the tree of `links` from the (parent, child) pairs of the joints. The caller ensures that no link has two
/// parents. Error if there are several roots, or if some links form a cycle.
pub(crate) fn build(
    links: &[String],
    joint_names: &[&str],
    joints: &[(LinkId, LinkId)],
) -> Result<Tree, Problem> {
    let mut parent_joint = vec![None; links.len()];
    let mut child_joints = vec![Vec::new(); links.len()];
    for (i, (parent, child)) in joints.iter().enumerate() {
        let id = JointId::new(i, joint_names[i]);
        parent_joint[child.index()] = Some(id);
        child_joints[parent.index()].push(id);
    }
    let roots: Vec<usize> = (0..links.len()).filter(|&i| parent_joint[i].is_none()).collect();
    let root = match roots[..] {
        [root] => LinkId::new(root, &links[root]),
        [] => return Err(cycle(links, joints, &parent_joint, 0)),
        _ => {
            return Err(Problem::SeveralRoots { roots: roots.iter().map(|&i| links[i].clone()).collect() });
        }
    };
    // Depth-first search with an explicit stack: a long chain would overflow the call stack.
    let mut order = Vec::with_capacity(links.len());
    let mut stack = vec![root];
    while let Some(link) = stack.pop() {
        order.push(link);
        stack.extend(child_joints[link.index()].iter().rev().map(|j| joints[j.index()].1));
    }
    if order.len() < links.len() {
        let mut seen = vec![false; links.len()];
        order.iter().for_each(|l| seen[l.index()] = true);
        let lost = seen.iter().position(|s| !s).unwrap_or(0);
        return Err(cycle(links, joints, &parent_joint, lost));
    }
    Ok(Tree { root, parent_joint, child_joints, order })
}

/// Follows the parents from `start`, which has no root among its ancestors, until a link repeats.
fn cycle(
    links: &[String],
    joints: &[(LinkId, LinkId)],
    parent_joint: &[Option<JointId>],
    start: usize,
) -> Problem {
    let mut visited = vec![usize::MAX; links.len()];
    let mut path = Vec::new();
    let mut link = start;
    while visited[link] == usize::MAX {
        visited[link] = path.len();
        path.push(link);
        match parent_joint[link] {
            Some(joint) => link = joints[joint.index()].0.index(),
            None => break,
        }
    }
    let mut names: Vec<String> = path[visited[link]..].iter().map(|&i| links[i].clone()).collect();
    names.reverse();
    Problem::Cycle { links: names }
}
