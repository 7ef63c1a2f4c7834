//! Steps between the ground and the links in contact, and the order in which the forces on both are propagated.

use super::plan::ScheduledStep;

/// Frame of the normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TreeNormalFrame {
    /// The frame of the contact link's body.
    Body,
    /// The frame of the body on the other side.
    Against,
    /// The frame of the root link.
    Root,
}

/// Use of a step in the evaluation of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum StepRole {
    /// It does not affect the result.
    Unused,
    /// Its position rotates the normal, or moves the contact point relative to the other link.
    Route,
    /// Its inertia affects the result.
    Inertia,
    /// It transmits the force on the contact link, or both forces.
    Path,
    /// It transmits the force on the link on the other side.
    OtherPath,
}

impl StepRole {
    /// True if the inertia of the step affects the result.
    pub fn is_eliminated(self) -> bool {
        !matches!(self, Self::Unused | Self::Route)
    }

    /// True if the step transmits a contact force.
    pub fn is_on_path(self) -> bool {
        matches!(self, Self::Path | Self::OtherPath)
    }
}

/// Change of the propagated force before a step, for a contact between two bodies: their forces are propagated separately.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change {
    /// The propagated force is exchanged with the stored one.
    Exchange,
    /// The stored force is added, because both act on the body of the step.
    Merge,
}

/// Steps between the ground and the two links in contact.
#[derive(Clone, Debug)]
pub(super) struct Branches {
    /// Indices of the steps from the ground to the contact link's body; empty for the root link.
    pub path: Vec<usize>,
    /// Indices of the steps from the ground to the body on the other side; empty for the ground.
    pub other: Vec<usize>,
    /// Number of the first steps that both paths share.
    pub shared: usize,
    /// Indices of the steps from the ground to the body at the end of the line that defines the normal.
    pub line: Vec<usize>,
    /// Number of the first steps that this path shares with `path`.
    pub line_shared: usize,
    /// Role of every step.
    pub roles: Vec<StepRole>,
    /// Changes, and the index of the step before which each happens.
    pub changes: Vec<(usize, Change)>,
}

impl Branches {
    /// Without a contact, for a number of steps.
    pub fn none(steps: usize) -> Self {
        Self {
            path: Vec::with_capacity(steps),
            other: Vec::with_capacity(steps),
            shared: 0,
            line: Vec::with_capacity(steps),
            line_shared: 0,
            roles: vec![StepRole::Unused; steps],
            changes: Vec::with_capacity(steps + 1),
        }
    }

    /// Finds the steps of a contact of two bodies, or of one with the ground. `line`: body at the end of the line that defines the normal.
    pub fn find(
        &mut self,
        steps: &[ScheduledStep],
        body: Option<usize>,
        against: Option<usize>,
        line: Option<Option<usize>>,
    ) {
        find_path(steps, body, &mut self.path);
        find_path(steps, against, &mut self.other);
        self.shared = self.path.iter().zip(&self.other).take_while(|(a, b)| a == b).count();
        let last = steps.len() - 1;
        let root = |body: Option<usize>| body.map(|body| steps[last - body].subtree_root);
        let roots = [root(body.or(against)), root(against.or(body))];
        for (role, placed) in self.roles.iter_mut().zip(steps) {
            let affects = roots.contains(&Some(placed.subtree_root));
            *role = if affects { StepRole::Inertia } else { StepRole::Unused };
        }
        let sides = [(&self.path, StepRole::Path), (&self.other, StepRole::OtherPath)];
        for ((path, own), root) in sides.into_iter().zip(roots) {
            for &at in path {
                self.roles[at] = match (Some(steps[at].subtree_root) == root, self.roles[at]) {
                    (true, StepRole::Inertia) => own,
                    (false, StepRole::Unused) => StepRole::Route,
                    (_, role) => role,
                };
            }
        }
        find_path(steps, line.flatten(), &mut self.line);
        self.line_shared = self.path.iter().zip(&self.line).take_while(|(a, b)| a == b).count();
        for &at in &self.line {
            if self.roles[at] == StepRole::Unused {
                self.roles[at] = StepRole::Route;
            }
        }
        self.changes.clear();
        if against.is_some() {
            // Forces on bodies of two subtrees never meet.
            let meeting = self.path[..self.shared].last().filter(|_| roots[0] == roots[1]);
            self.find_changes(steps, meeting.map_or(steps.len(), |&at| at));
        }
    }

    /// Finds the changes up to the step at which both forces meet.
    fn find_changes(&mut self, steps: &[ScheduledStep], meeting: usize) {
        let [mut current, mut next] = [StepRole::Path, StepRole::OtherPath];
        for (at, placed) in steps[..meeting].iter().enumerate() {
            // The coordinates of a cluster are eliminated at its last joint.
            let joint = placed.step.cluster_joint.as_ref().filter(|joint| joint.is_last);
            let cluster = joint.map(|joint| joint.cluster);
            let acts_on_cluster = |role: StepRole| {
                let path = if role == StepRole::Path { &self.path } else { &self.other };
                cluster.is_some()
                    && path.iter().any(|&at| self.roles[at] == role && steps[at].cluster() == cluster)
            };
            let is_needed = match self.roles[at].is_on_path() {
                true => self.roles[at] == next,
                false => acts_on_cluster(next) && !acts_on_cluster(current),
            };
            if is_needed {
                self.changes.push((at, Change::Exchange));
                (current, next) = (next, current);
            }
        }
        self.changes.push((meeting, Change::Merge));
    }
}

/// Indices of the steps from the ground to a body; none for `None`.
fn find_path(steps: &[ScheduledStep], body: Option<usize>, path: &mut Vec<usize>) {
    let last = steps.len() - 1;
    path.clear();
    path.extend(std::iter::successors(body.map(|body| last - body), |&at| {
        steps[at].step.parent.map(|parent| last - parent)
    }));
    path.reverse();
}
