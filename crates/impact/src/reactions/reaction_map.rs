//! Reactions at a pose: the parts that depend on the pose only, and the reactions to given loads.

use crate::group_rows::GroupRows;
use crate::reactions::force_elements::SpringForces;
use crate::reactions::joint_constraints::JointConstraints;
use crate::reactions::reaction::{Component, DriveImpulse, JointReaction, Reaction, Reactions};
use crate::reactions::tree_frames::{TreeFrames, axes_along};
use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{ConstraintSource, ContactResponse, EffectiveMass, LocatedContact, Pose};
use percuss_mechanism::{ClosureKind, LinkId};
use percuss_spatial::{Transform, Twist, Wrench};
use std::sync::Arc;

/// Error of reactions to a unit impulse.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReactionError {
    /// A motion without mass closes the gap: the contact transmits no impulse.
    #[error("a motion without mass closes the gap: the contact transmits no impulse")]
    Massless,
    /// The response belongs to another pose or mechanism.
    #[error("the contact response belongs to another mechanism")]
    ForeignResponse,
}

/// Reactions in all joints, closures and held contacts at one pose.
///
/// The factorised constraint rows, and the components that redundant rows leave open, depend on the pose only. A map computes them
/// once; each impulse then costs one sweep over the links and a triangular solution.
///
/// The multipliers λ of the constraints satisfy Aᵀλ = M Δq̇ + jᵀ; redundant rows leave λ open up to Z = ker Aᵀ. The wrench in joint i
/// is r_i = Σ (I_b ΔV_b − impulses of contact and constraints on b) over the bodies b of its subtree, in one sweep, massless links
/// included. A component of r_i is determinate if its derivative by λ vanishes on Z.
///
/// Cost: O(m² n) for a group of m constraint rows over n coordinates; O(n + m n) for each impulse. Sources: Wittenburg 2008, §5.8; for
/// the rank of redundant constraints, Wojtyra 2005.
#[derive(Clone, Debug)]
pub struct ReactionMap {
    tree: TreeFrames,
    /// For each coordinate: true if a group constrains it.
    bound: Vec<bool>,
    groups: Vec<GroupRows>,
    /// Index of the first row of each group among the rows of all groups.
    first_rows: Vec<usize>,
    /// Links between the two ends of each constraint of all groups, group by group.
    routes: Vec<Vec<LoadedLink>>,
    /// For each link: groups whose rows load its parent joint, with the wrench on the link at each unit multiplier, in
    /// the link's axes at its origin.
    sensitivities: Vec<Vec<(usize, Vec<Wrench<f64>>)>>,
    ground: Option<ReactionLayout>,
    joints: Vec<ReactionLayout>,
    /// For each velocity of all joints: true if redundant rows leave the constraint impulse of the drive open.
    open_drives: Vec<bool>,
    /// Locks, mimics and couplings.
    joint_constraints: JointConstraints,
    closures: Vec<ConstraintLayout>,
    holds: Vec<ConstraintLayout>,
}

/// Link whose parent joint a constraint loads.
#[derive(Clone, Copy, Debug)]
struct LoadedLink {
    link: LinkId,
    /// Index of the group among the groups that load this joint.
    entry: usize,
    /// +1 on the side of the successor, −1 on the side of the predecessor.
    sign: f64,
}

/// Frame and open components of a reaction.
#[derive(Clone, Debug)]
struct ReactionLayout {
    /// Frame of the components, in the frame of the root link.
    frame: Transform<f64>,
    /// Axes of the components in the axes of the wrench.
    axes: Matrix3<f64>,
    /// True for components that redundant rows leave open: force, then moment.
    open: [bool; 6],
    loops: Vec<String>,
}

/// Reaction of a closure or a held contact: number of its group, index in the group, and layout.
#[derive(Clone, Debug)]
struct ConstraintLayout {
    group: usize,
    index: usize,
    layout: ReactionLayout,
}

/// Reusable buffers for the reactions to one load.
#[derive(Clone, Debug, Default)]
pub(crate) struct ReactionBuffers {
    /// Changes of the velocities, or accelerations, of all joints.
    pub change: Vec<f64>,
    /// Wrenches of the parent joints of all links: first without the constraints of loops and holds, then with them.
    pub loads: Vec<Wrench<f64>>,
    twists: Vec<Twist<f64>>,
    forces: Vec<f64>,
    /// Multipliers of all groups, concatenated.
    multipliers: Vec<f64>,
    /// Scratch of the triangular solution.
    solution: Vec<f64>,
    /// For each velocity of all joints: sum of the impulses of the lock, the mimics and the couplings; the couplings are subtracted later.
    sums: Vec<f64>,
}

impl ReactionMap {
    /// Prepares the reactions at a pose.
    pub fn new(pose: &Pose) -> Self {
        let mut map = Self {
            tree: TreeFrames::new(pose),
            bound: Vec::new(),
            groups: pose.constraint_groups().into_iter().map(GroupRows::new).collect(),
            first_rows: Vec::new(),
            routes: Vec::new(),
            sensitivities: vec![Vec::new(); pose.mechanism().links().len()],
            ground: None,
            joints: Vec::new(),
            open_drives: Vec::new(),
            joint_constraints: JointConstraints::default(),
            closures: Vec::new(),
            holds: Vec::new(),
        };
        map.bound.resize(map.tree.coordinate_count, false);
        map.groups.iter().flat_map(GroupRows::coordinates).for_each(|&c| map.bound[c] = true);
        let mut rows = 0;
        for group in &map.groups {
            map.first_rows.push(rows);
            rows += group.rows();
        }
        map.find_routes();
        map.prepare(pose);
        map
    }

    /// Moves the map to another pose of the same system, and reuses its memory.
    ///
    /// # Panics
    /// If the pose belongs to another mechanism.
    pub fn update(&mut self, pose: &Pose) {
        assert!(Arc::ptr_eq(pose.mechanism(), &self.tree.mechanism), "the pose belongs to another mechanism");
        self.tree.update(pose);
        for (number, group) in self.groups.iter_mut().enumerate() {
            group.update(pose, number);
        }
        self.prepare(pose);
    }

    fn prepare(&mut self, pose: &Pose) {
        self.collect_sensitivities();
        self.joint_constraints =
            JointConstraints::new(pose, &self.tree, &self.groups, &self.first_rows, &self.sensitivities);
        self.lay_out();
    }

    /// Reactions to a unit impulse (1 N·s) at the contact of a response at this pose, times `scale`.
    ///
    /// The impulse −n̂ acts on the contact link, and n̂ on the other link. It changes the velocities by Δq̇ = −v*/m̄ (zero if the
    /// mechanism is immovable).
    ///
    /// # Errors
    /// [`ReactionError`]: a massless contact; a response of another mechanism.
    pub fn reactions(&self, response: &ContactResponse, scale: f64) -> Result<Reactions, ReactionError> {
        let (joints, base) = (&response.joint_velocities, response.base_velocity);
        if joints.len() != self.joints.len() {
            return Err(ReactionError::ForeignResponse);
        }
        let star = joints.iter().flatten().copied();
        let (mut buffers, mut reactions) = (ReactionBuffers::default(), Reactions::none());
        let (contact, mass) = (&response.contact, response.effective_mass);
        self.reactions_of_motion(contact, mass, star, base, scale, &mut buffers, &mut reactions)?;
        Ok(reactions)
    }

    /// As [`reactions`](Self::reactions), but writes to `reactions` and reuses its memory. `mass`: m̄ of the contact; `star`, `base`:
    /// v* of all joints, and of the root (root axes, root origin).
    #[expect(clippy::too_many_arguments, reason = "a motion, a scale, and the memory for the results")]
    pub(crate) fn reactions_of_motion(
        &self,
        contact: &LocatedContact,
        mass: EffectiveMass,
        star: impl Iterator<Item = f64>,
        base: Twist<f64>,
        scale: f64,
        buffers: &mut ReactionBuffers,
        reactions: &mut Reactions,
    ) -> Result<(), ReactionError> {
        let factor = match mass {
            EffectiveMass::Finite(mass) => -1.0 / mass,
            EffectiveMass::Immovable => 0.0,
            EffectiveMass::Massless => return Err(ReactionError::Massless),
        };
        let ReactionBuffers { change, loads, twists, .. } = buffers;
        change.clear();
        change.extend(star.map(|rate| factor * rate));
        self.tree.impulse_loads(contact, change, base * factor, twists, loads);
        self.reactions_to_loads(scale, buffers, reactions);
        Ok(())
    }

    /// Reactions to `buffers.loads` ([`TreeFrames::impulse_loads`], [`TreeFrames::motion_loads`]) and `buffers.change`, times `scale`, with
    /// the multipliers that balance them. Overwrites `reactions` and reuses its memory.
    pub(crate) fn reactions_to_loads(
        &self,
        scale: f64,
        buffers: &mut ReactionBuffers,
        reactions: &mut Reactions,
    ) {
        let ReactionBuffers { change, loads, forces, multipliers, solution, sums, .. } = buffers;
        self.tree.generalised_loads(loads, change, forces);
        let mut residual: f64 = 0.0;
        multipliers.clear();
        for group in &self.groups {
            residual = residual.max(group.add_multipliers(forces, multipliers, solution));
        }
        let size = self.tree.mechanism.characteristic_length();
        for (force, _) in forces.iter().zip(&self.bound).filter(|(_, bound)| !**bound) {
            // For a rotation the unbalanced value is a moment: its scale is a unit impulse at the characteristic length.
            residual = residual.max(force.abs() / size.max(1.0));
        }
        for (load, sensitivities) in loads.iter_mut().zip(&self.sensitivities) {
            for (number, wrenches) in sensitivities {
                for (wrench, multiplier) in wrenches.iter().zip(&multipliers[self.first_rows[*number]..]) {
                    *load += *wrench * *multiplier;
                }
            }
        }
        match &self.ground {
            Some(ground) => {
                let to = reactions.ground.get_or_insert_with(Reaction::zero);
                ground.write_reaction(&loads[self.tree.mechanism.root().index()], scale, to);
            }
            None => reactions.ground = None,
        }
        let ids = || self.tree.mechanism.joint_ids();
        sums.clear();
        let empty = |joint| JointReaction { joint, reaction: Reaction::zero(), drives: Vec::new() };
        if reactions.joints.len() != self.joints.len() {
            reactions.joints = ids().map(empty).collect();
        }
        for ((joint, layout), to) in ids().zip(&self.joints).zip(&mut reactions.joints) {
            let child = self.tree.mechanism.joint(joint).child().index();
            let first = self.tree.first_column(joint);
            let drive = |(k, column): (usize, &Twist<f64>)| {
                let gear = self.tree.armature[first + k] * change[first + k];
                let sum = loads[child].power(column) + gear + self.tree.applied(joint, k);
                sums.push(sum);
                let constraint = component(scale * sum, self.open_drives[first + k]);
                DriveImpulse { gear: scale * gear, constraint }
            };
            to.joint = joint;
            to.drives.clear();
            to.drives.extend(self.tree.columns(joint).iter().enumerate().map(drive));
            layout.write_reaction(&loads[child], scale, &mut to.reaction);
        }
        self.joint_constraints.write_reactions(sums, multipliers, scale, &mut reactions.joint_constraints);
        let all = [(&self.closures, &mut reactions.closures), (&self.holds, &mut reactions.holds)];
        for (constraints, to) in all {
            to.resize_with(constraints.len(), Reaction::zero);
            for (constraint, to) in constraints.iter().zip(to) {
                let action = &self.groups[constraint.group].group().constraints[constraint.index];
                let own = &multipliers[self.first_rows[constraint.group] + action.first..];
                let sum = |sum, (wrench, multiplier): (&Wrench<f64>, &f64)| sum + *wrench * *multiplier;
                let total = action.wrenches.iter().zip(own).fold(Wrench::zero(), sum);
                constraint.layout.write_reaction(&total, scale, to);
            }
        }
        reactions.residual = residual;
    }

    /// Reactions in a motion: forces (N) and moments (N·m), as by [`reactions_to_loads`](Self::reactions_to_loads). `force`: contact force;
    /// then rates and accelerations of the coordinates; `gravity`: m/s², root axes.
    #[expect(clippy::too_many_arguments, reason = "a motion, and the memory for the results")]
    pub(crate) fn reactions_in_motion(
        &self,
        pose: &Pose,
        contact: &LocatedContact,
        force: f64,
        (rates, accelerations): (&[f64], &[f64]),
        gravity: &Vector3<f64>,
        buffers: &mut ReactionBuffers,
        reactions: &mut Reactions,
    ) {
        let tree = &self.tree;
        let mut velocities = Vec::new();
        tree.joint_velocities(rates, &mut velocities);
        tree.joint_velocities(accelerations, &mut buffers.change);
        let rates = (&velocities[..], tree.base_twist(rates));
        let changes = (&buffers.change[..], tree.base_twist(accelerations));
        buffers.loads = tree.motion_loads(pose, contact, force, rates, changes, gravity);
        self.reactions_to_loads(1.0, buffers, reactions);
    }

    /// Sets the forces of springs and dampers at `pose` and at the rates of the coordinates.
    pub(crate) fn apply_springs(&mut self, pose: &Pose, springs: &SpringForces, rates: &[f64]) {
        let mut velocities = Vec::new();
        self.tree.joint_velocities(rates, &mut velocities);
        let base = self.tree.base_twist(rates);
        self.tree.apply_springs(pose, springs, &velocities, base);
    }

    /// Frames and motion subspaces of the tree.
    pub(crate) fn tree(&self) -> &TreeFrames {
        &self.tree
    }

    /// Finds the links whose parent joints the constraints load, and allocates their wrenches. A constraint loads the joints between its
    /// two ends; joints above both ends receive no wrench. The links are the same at every pose.
    fn find_routes(&mut self) {
        let Self { tree, groups, routes, sensitivities, .. } = self;
        for (number, rows) in groups.iter().enumerate() {
            let group = rows.group();
            let count = group.rows.nrows();
            for action in &group.constraints {
                let mut route = Vec::new();
                let ends = [
                    (action.successor, action.predecessor, 1.0),
                    (action.predecessor, action.successor, -1.0),
                ];
                for (end, other, sign) in ends {
                    let between =
                        tree.path_to_root(end).filter(|link| !tree.path_to_root(other).any(|l| l == *link));
                    for link in between {
                        let of_link = &mut sensitivities[link.index()];
                        let known = of_link.iter().position(|(known, _)| *known == number);
                        let at = known.unwrap_or(of_link.len());
                        if known.is_none() {
                            of_link.push((number, vec![Wrench::zero(); count]));
                        }
                        route.push(LoadedLink { link, entry: at, sign });
                    }
                }
                routes.push(route);
            }
        }
    }

    /// Computes the wrench in each parent joint per unit multiplier.
    fn collect_sensitivities(&mut self) {
        let Self { tree, groups, routes, sensitivities, .. } = self;
        sensitivities.iter_mut().flatten().for_each(|(_, wrenches)| wrenches.fill(Wrench::zero()));
        let actions = groups.iter().flat_map(|rows| &rows.group().constraints);
        for (action, route) in actions.zip(routes.iter()) {
            for LoadedLink { link, entry, sign } in route {
                let wrenches = &mut sensitivities[link.index()][*entry].1;
                for (row, wrench) in action.wrenches.iter().enumerate() {
                    // A wrench of the constraint on the subtree reduces the wrench of the parent joint.
                    let in_link = tree.in_link(*link, wrench, &action.point);
                    wrenches[action.first + row] -= in_link * *sign;
                }
            }
        }
    }

    /// Computes the frames and the open components of all reactions.
    fn lay_out(&mut self) {
        let mechanism = Arc::clone(&self.tree.mechanism);
        self.ground =
            (!self.tree.is_floating).then(|| self.tree_layout(mechanism.root(), &Matrix3::identity()));
        self.joints.clear();
        self.open_drives.clear();
        for joint in mechanism.joint_ids() {
            let child = mechanism.joint(joint).child();
            self.joints.push(self.tree_layout(child, &self.tree.axes[joint.index()]));
            for column in self.tree.columns(joint) {
                let unit = (column.angular.norm_squared() == 0.0).then_some(1.0);
                let is_open = self.is_open(child, |w| w.power(column), unit, &mut Vec::new());
                self.open_drives.push(is_open);
            }
        }
        let (mut closures, mut holds) = (Vec::new(), Vec::new());
        for (group, rows) in self.groups.iter().enumerate() {
            for (index, action) in rows.group().constraints.iter().enumerate() {
                let to = match action.source {
                    ConstraintSource::Closure(i) => (&mut closures, i),
                    ConstraintSource::Hold(i) => (&mut holds, i),
                    ConstraintSource::Coupling(_) => continue,
                };
                let layout = self.constraint_layout(group, index);
                to.0.push((to.1, ConstraintLayout { group, index, layout }));
            }
        }
        let sorted = |mut of: Vec<(usize, ConstraintLayout)>| {
            of.sort_by_key(|(i, _)| *i);
            of.into_iter().map(|(_, constraint)| constraint).collect()
        };
        (self.closures, self.holds) = (sorted(closures), sorted(holds));
    }

    /// Layout of the wrench on a link from its parent joint, or from the ground, along axes fixed in the link.
    fn tree_layout(&self, link: LinkId, axes: &Matrix3<f64>) -> ReactionLayout {
        let mut loops = Vec::new();
        let is_redundant = |&(number, _): &(usize, Vec<_>)| self.groups[number].is_redundant();
        let open = if self.sensitivities[link.index()].iter().any(is_redundant) {
            open_components(axes, |part, unit| self.is_open(link, part, unit, &mut loops))
        } else {
            [false; 6]
        };
        let frame = &self.tree.frames[link.index()];
        let frame = Transform::new(frame.rotation * axes, frame.translation);
        ReactionLayout { frame, axes: *axes, open, loops: self.loop_names(loops) }
    }

    /// Layout of the wrench of a closure or a held contact, which is in root axes.
    fn constraint_layout(&self, number: usize, index: usize) -> ReactionLayout {
        let rows = &self.groups[number];
        let action = &rows.group().constraints[index];
        let axes = self.constraint_axes(number, index);
        let mut loops = Vec::new();
        let is_redundant = rows.is_redundant();
        let open = open_components(&axes, |part, unit| {
            if !is_redundant {
                return false;
            }
            let mut function = vec![0.0; rows.group().rows.nrows()];
            for (row, wrench) in action.wrenches.iter().enumerate() {
                function[action.first + row] = part(wrench);
            }
            let open = rows.open_constraints(&function, unit.unwrap_or(rows.group().size));
            loops.extend(open.iter().map(|&index| (number, index)));
            !open.is_empty()
        });
        let frame = Transform::new(axes, action.point);
        ReactionLayout { frame, axes, open, loops: self.loop_names(loops) }
    }

    /// Axes, as columns in root axes, along which the reaction of constraint `index` of group `number` is resolved.
    fn constraint_axes(&self, number: usize, index: usize) -> Matrix3<f64> {
        let action = &self.groups[number].group().constraints[index];
        match action.source {
            ConstraintSource::Closure(i) => {
                let closure = &self.tree.mechanism.closures()[i];
                let end = closure.predecessor();
                let of_link = end.link.map_or(Matrix3::identity(), |l| self.tree.frames[l.index()].rotation);
                let frame = of_link * end.frame.rotation;
                match closure.kind() {
                    // The force of a rod acts along the rod.
                    ClosureKind::Distance => axes_along(&action.wrenches[0].force),
                    kind if kind.has_axis() => frame * axes_along(closure.axis()),
                    _ => frame,
                }
            }
            ConstraintSource::Hold(_) if action.count == 1 => axes_along(&action.wrenches[0].force),
            ConstraintSource::Hold(_) | ConstraintSource::Coupling(_) => Matrix3::identity(),
        }
    }

    /// True if redundant rows leave `part` (a component) of the wrench on a link from its parent joint open. `unit`: size at a unit
    /// multiplier; `None` for a moment, whose size is that of the group. Appends the constraints that leave the value open to `loops`.
    fn is_open(
        &self,
        link: LinkId,
        part: impl Fn(&Wrench<f64>) -> f64,
        unit: Option<f64>,
        loops: &mut Vec<(usize, usize)>,
    ) -> bool {
        let before = loops.len();
        for (number, wrenches) in &self.sensitivities[link.index()] {
            let group = &self.groups[*number];
            if group.is_redundant() {
                let function: Vec<f64> = wrenches.iter().map(&part).collect();
                let open = group.open_constraints(&function, unit.unwrap_or(group.group().size));
                loops.extend(open.into_iter().map(|index| (*number, index)));
            }
        }
        loops.len() > before
    }

    /// Names of constraints, without repetitions.
    fn loop_names(&self, mut constraints: Vec<(usize, usize)>) -> Vec<String> {
        constraints.sort_unstable();
        constraints.dedup();
        let name =
            |(number, index): (usize, usize)| self.groups[number].group().constraints[index].name.clone();
        constraints.into_iter().map(name).collect()
    }
}

impl ReactionLayout {
    /// Overwrites `reaction` with the reaction of a wrench, times `scale`.
    fn write_reaction(&self, wrench: &Wrench<f64>, scale: f64, reaction: &mut Reaction) {
        let along = |vector: &Vector3<f64>, first: usize| {
            [0, 1, 2].map(|k| component(scale * self.axes.column(k).dot(vector), self.open[first + k]))
        };
        reaction.frame = self.frame;
        reaction.force = along(&wrench.force, 0);
        reaction.moment = along(&wrench.moment, 3);
        reaction.loops.clone_from(&self.loops);
    }
}

fn component(value: f64, is_open: bool) -> Component {
    if is_open { Component::Indeterminate } else { Component::Determinate(value) }
}

/// Open components along the axes: force, then moment. The arguments of `is_open` are the component as a function of the wrench, and its
/// size at a unit multiplier (`None` for a moment).
fn open_components(
    axes: &Matrix3<f64>,
    mut is_open: impl FnMut(&dyn Fn(&Wrench<f64>) -> f64, Option<f64>) -> bool,
) -> [bool; 6] {
    [0, 1, 2, 3, 4, 5].map(|k| {
        let axis = axes.column(k % 3).into_owned();
        if k < 3 {
            is_open(&|w| w.force.dot(&axis), Some(1.0))
        } else {
            is_open(&|w| w.moment.dot(&axis), None)
        }
    })
}
