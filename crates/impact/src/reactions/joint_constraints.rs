//! Separate impulses of each lock, mimic and coupling on its joints.

use crate::group_rows::GroupRows;
use crate::reactions::reaction::{Component, JointConstraint, JointConstraintReaction};
use crate::reactions::tree_frames::TreeFrames;
use percuss_dynamics::{ConstraintSource, Pose};
use percuss_mechanism::JointId;
use percuss_spatial::Wrench;

/// Wrenches on each link from its parent joint at unit multipliers: for each link, the groups with their rows.
pub(crate) type Sensitivities = [Vec<(usize, Vec<Wrench<f64>>)>];

/// Locks, mimics and couplings at one pose.
///
/// The load of a joint gives only the sum of the impulses of its constraints. The multipliers λ of the couplings are known from the groups.
/// S is the load without the couplings: S = ν + µ at a mimic, and S = ν − Σ m µ at its master, with the impulses ν of the lock and µ of the
/// mimics, and the multipliers m. These equations determine the impulse of one lock in a family of a master and its mimics; two locks are
/// redundant. An impulse is also open if it changes along ker Aᵀ of a group.
#[derive(Clone, Debug, Default)]
pub(crate) struct JointConstraints {
    locks: Vec<Lock>,
    mimics: Vec<Mimic>,
    couplings: Vec<CouplingRow>,
}

/// Lock of a joint.
#[derive(Clone, Debug)]
struct Lock {
    joint: JointId,
    /// Impulse on each velocity of the joint.
    impulses: Vec<Impulse>,
}

/// Mimic: µ acts on the follower, −multiplier · µ on the master.
#[derive(Clone, Debug)]
struct Mimic {
    follower: JointId,
    master: JointId,
    multiplier: f64,
    impulse: Impulse,
}

/// Row of a coupling.
#[derive(Clone, Debug)]
struct CouplingRow {
    /// Index into the couplings of the mechanism.
    coupling: usize,
    group: usize,
    /// Index of the row in its group.
    row: usize,
    /// Index of the row among the rows of all groups.
    row_of_all: usize,
    /// Joint, its velocity index, and the generalised force at unit multiplier; each joint once.
    joints: Vec<(JointId, usize, f64)>,
    open_by: Vec<String>,
}

/// Impulse of a lock or mimic on one velocity: a linear combination of the values S.
#[derive(Clone, Debug, Default)]
struct Impulse {
    /// Joint, velocity index among the velocities of all joints, and factor.
    terms: Vec<(JointId, usize, f64)>,
    /// Names of the constraints that leave the value open; empty if it is determinate.
    open_by: Vec<String>,
}

/// Master with its mimics.
struct Family {
    master: JointId,
    /// Mimics with their multipliers.
    mimics: Vec<(JointId, f64)>,
}

impl JointConstraints {
    /// Locks, mimics and couplings at a pose. `first_rows`: index of the first row of each group.
    pub fn new(
        pose: &Pose,
        tree: &TreeFrames,
        groups: &[GroupRows],
        first_rows: &[usize],
        sensitivities: &Sensitivities,
    ) -> Self {
        let couplings = coupling_rows(tree, groups, first_rows);
        let (mut locks, mut mimics) = (Vec::new(), Vec::new());
        for joint in tree.mechanism.joint_ids().filter(|joint| pose.has_lock(*joint)) {
            let first = tree.first_column(joint);
            let velocities = first..first + tree.columns(joint).len();
            locks.push(Lock { joint, impulses: velocities.map(|v| Impulse::of(joint, v)).collect() });
        }
        for family in families(tree) {
            family.add_mimics(pose, tree, &mut locks, &mut mimics);
        }
        let of_locks = locks.iter_mut().map(|Lock { joint, impulses }| ("lock", *joint, &mut impulses[..]));
        let of_mimics = mimics
            .iter_mut()
            .map(|Mimic { follower, impulse, .. }| ("mimic", *follower, std::slice::from_mut(impulse)));
        for (kind, joint, impulses) in of_locks.chain(of_mimics) {
            for impulse in impulses {
                let name = || format!("{kind} of {}", tree.mechanism.joint(joint).name());
                impulse.find_open_terms(tree, groups, sensitivities, &couplings, name);
            }
        }
        Self { locks, mimics, couplings }
    }

    /// Overwrites `reactions` with the impulses of all locks, mimics and couplings, times `scale`, and reuses its memory. `loads`: sum of
    /// these impulses on each velocity of all joints, overwritten by S. `multipliers`: multipliers of all groups.
    pub fn write_reactions(
        &self,
        loads: &mut [f64],
        multipliers: &[f64],
        scale: f64,
        reactions: &mut Vec<JointConstraintReaction>,
    ) {
        for coupling in &self.couplings {
            for (_, velocity, factor) in &coupling.joints {
                loads[*velocity] -= factor * multipliers[coupling.row_of_all];
            }
        }
        let empty = || JointConstraintReaction {
            constraint: JointConstraint::Coupling(0),
            impulses: Vec::new(),
            open_by: Vec::new(),
        };
        reactions.resize_with(self.locks.len() + self.mimics.len() + self.couplings.len(), empty);
        let (of_locks, others) = reactions.split_at_mut(self.locks.len());
        let (of_mimics, of_couplings) = others.split_at_mut(self.mimics.len());
        for (Lock { joint, impulses }, to) in self.locks.iter().zip(of_locks) {
            to.constraint = JointConstraint::Lock(*joint);
            to.impulses.clear();
            let value = |(k, impulse): (usize, &Impulse)| (*joint, k, impulse.value(loads, scale));
            to.impulses.extend(impulses.iter().enumerate().map(value));
            to.open_by = unique(impulses.iter().flat_map(|impulse| &impulse.open_by));
        }
        for (Mimic { follower, master, multiplier, impulse }, to) in self.mimics.iter().zip(of_mimics) {
            let value = impulse.value(loads, scale);
            to.constraint = JointConstraint::Mimic(*follower);
            to.impulses.clear();
            to.impulses.extend([(*follower, 0, value), (*master, 0, value.scaled(-multiplier))]);
            to.open_by.clone_from(&impulse.open_by);
        }
        for (coupling, to) in self.couplings.iter().zip(of_couplings) {
            let value = |factor: f64| match coupling.open_by.is_empty() || factor == 0.0 {
                true => Component::Determinate(scale * factor * multipliers[coupling.row_of_all]),
                false => Component::Indeterminate,
            };
            to.constraint = JointConstraint::Coupling(coupling.coupling);
            to.impulses.clear();
            to.impulses.extend(coupling.joints.iter().map(|&(joint, _, factor)| (joint, 0, value(factor))));
            to.open_by.clone_from(&coupling.open_by);
        }
    }
}

impl Family {
    /// Adds the impulses of the mimics of the family to `mimics`, and replaces the impulses of the locks of the family in `locks`.
    fn add_mimics(&self, pose: &Pose, tree: &TreeFrames, locks: &mut [Lock], mimics: &mut Vec<Mimic>) {
        let name = |joint: JointId| tree.mechanism.joint(joint).name();
        let members = [(self.master, 1.0)].into_iter().chain(self.mimics.iter().copied());
        // A mimic with the multiplier 0 is at rest. Its lock does not act on the master, so it is not redundant with other locks.
        let locked = |(joint, multiplier): &(JointId, f64)| pose.has_lock(*joint) && *multiplier != 0.0;
        let locked: Vec<JointId> = members.filter(locked).map(|(joint, _)| joint).collect();
        let redundant = || Impulse {
            terms: Vec::new(),
            open_by: locked.iter().map(|joint| format!("lock of {}", name(*joint))).collect(),
        };
        let mut set_lock = |joint: JointId, impulse: Impulse| {
            let own = locks.iter_mut().find(|lock| lock.joint == joint);
            own.into_iter().for_each(|lock| lock.impulses = vec![impulse.clone()]);
        };
        for &(follower, multiplier) in &self.mimics {
            let velocity = tree.first_column(follower);
            let impulse = if !pose.has_lock(follower) {
                Impulse::of(follower, velocity)
            } else if multiplier == 0.0 {
                let of = |what: &str| format!("{what} of {}", name(follower));
                let open = Impulse { terms: Vec::new(), open_by: vec![of("lock"), of("mimic")] };
                set_lock(follower, open.clone());
                open
            } else if locked.len() > 1 {
                set_lock(follower, redundant());
                redundant()
            } else {
                // The balance of the master gives µ of the locked mimic; the impulse of the lock is ν = S − µ.
                let mimic = self.balance(tree, Some(follower)).scaled(-1.0 / multiplier);
                let mut lock = mimic.scaled(-1.0);
                lock.terms.push((follower, velocity, 1.0));
                set_lock(follower, lock);
                mimic
            };
            mimics.push(Mimic { follower, master: self.master, multiplier, impulse });
        }
        if pose.has_lock(self.master) {
            let impulse = if locked.len() > 1 { redundant() } else { self.balance(tree, None) };
            set_lock(self.master, impulse);
        }
    }

    /// S of the master plus Σ m S of its mimics except `without`: the impulse of the lock of the master if no mimic is locked.
    fn balance(&self, tree: &TreeFrames, without: Option<JointId>) -> Impulse {
        let mimics = self.mimics.iter().filter(|(joint, _)| Some(*joint) != without);
        let members = [(self.master, 1.0)].into_iter().chain(mimics.copied());
        let terms = members.map(|(joint, multiplier)| (joint, tree.first_column(joint), multiplier));
        Impulse { terms: terms.collect(), open_by: Vec::new() }
    }
}

/// Masters with their mimics.
fn families(tree: &TreeFrames) -> Vec<Family> {
    let mut families: Vec<Family> = Vec::new();
    for joint in tree.mechanism.joint_ids().filter(|joint| !tree.columns(*joint).is_empty()) {
        let Some(mimic) = tree.mechanism.joint(joint).mimic() else { continue };
        let own = (joint, mimic.multiplier);
        match families.iter_mut().find(|family| family.master == mimic.master) {
            Some(family) => family.mimics.push(own),
            None => families.push(Family { master: mimic.master, mimics: vec![own] }),
        }
    }
    families
}

/// Rows of the couplings of all groups, in the order of the mechanism.
fn coupling_rows(tree: &TreeFrames, groups: &[GroupRows], first_rows: &[usize]) -> Vec<CouplingRow> {
    let mut rows = Vec::new();
    for (group, of_group) in groups.iter().enumerate() {
        for action in &of_group.group().constraints {
            let ConstraintSource::Coupling(coupling) = action.source else { continue };
            let mut joints: Vec<(JointId, usize, f64)> = Vec::new();
            for &(joint, factor) in &action.joint_forces {
                match joints.iter_mut().find(|(known, ..)| *known == joint) {
                    Some((_, _, sum)) => *sum += factor,
                    None => joints.push((joint, tree.first_column(joint), factor)),
                }
            }
            let mut function = vec![0.0; of_group.rows()];
            function[action.first] = 1.0;
            rows.push(CouplingRow {
                coupling,
                group,
                row: action.first,
                row_of_all: first_rows[group] + action.first,
                joints,
                open_by: of_group.open_names(&function, 1.0),
            });
        }
    }
    rows.sort_by_key(|row| row.coupling);
    rows
}

/// Names without repetitions, in order of occurrence.
fn unique<'a>(names: impl Iterator<Item = &'a String>) -> Vec<String> {
    let mut unique: Vec<String> = Vec::new();
    for name in names {
        if !unique.contains(name) {
            unique.push(name.clone());
        }
    }
    unique
}

impl Impulse {
    /// S of one velocity.
    fn of(joint: JointId, velocity: usize) -> Self {
        Self { terms: vec![(joint, velocity, 1.0)], open_by: Vec::new() }
    }

    /// Impulse times `scale`. `rest`: S of all velocities.
    fn value(&self, rest: &[f64], scale: f64) -> Component {
        if !self.open_by.is_empty() {
            return Component::Indeterminate;
        }
        let sum: f64 = self.terms.iter().map(|&(_, velocity, factor)| factor * rest[velocity]).sum();
        Component::Determinate(scale * sum)
    }

    fn scaled(&self, factor: f64) -> Self {
        let terms = self.terms.iter().map(|&(joint, velocity, own)| (joint, velocity, factor * own));
        Self { terms: terms.collect(), open_by: self.open_by.clone() }
    }

    /// Adds names to `open_by` if the value changes along ker Aᵀ of a group: the constraints of this kernel, and the lock or mimic.
    fn find_open_terms(
        &mut self,
        tree: &TreeFrames,
        groups: &[GroupRows],
        sensitivities: &Sensitivities,
        couplings: &[CouplingRow],
        name: impl Fn() -> String,
    ) {
        for (number, group) in groups.iter().enumerate().filter(|(_, group)| group.is_redundant()) {
            // Derivatives of the value by the multipliers of the group.
            let mut function = vec![0.0; group.rows()];
            let mut unit: f64 = 0.0;
            for &(joint, velocity, factor) in &self.terms {
                let column = tree.columns(joint)[velocity - tree.first_column(joint)];
                let child = tree.mechanism.joint(joint).child();
                let own = sensitivities[child.index()].iter().filter(|(known, _)| *known == number);
                for (row, wrench) in own.flat_map(|(_, wrenches)| wrenches.iter().enumerate()) {
                    function[row] += factor * wrench.power(&column);
                }
                for coupling in couplings.iter().filter(|coupling| coupling.group == number) {
                    let own = coupling.joints.iter().find(|(_, known, _)| *known == velocity);
                    function[coupling.row] -= own.map_or(0.0, |(_, _, force)| factor * force);
                }
                let turns = column.angular.norm_squared() > 0.0;
                unit = unit.max(factor.abs() * if turns { group.group().size } else { 1.0 });
            }
            let open = group.open_names(&function, unit);
            if !open.is_empty() {
                self.open_by = unique(self.open_by.iter().chain(&open).chain([&name()]));
            }
        }
    }
}
