//! Reactions to a unit impulse at a contact.

use crate::group_rows::GroupRows;
use crate::motion::joint_rates::JointRates;
use crate::reactions::link_loads::{LinkLoads, path_to_root};
use crate::reactions::reaction::{Component, DriveImpulse, JointReaction, Reaction, Reactions};
use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{ConstraintSource, ContactResponse, EffectiveMass, Pose};
use percuss_mechanism::{ClosureKind, JointId, LinkId};
use percuss_spatial::{Transform, Wrench, plane_basis};

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

/// Reactions in all joints, closures and held contacts to a unit impulse (1 N·s) at the contact of a response.
///
/// The impulse −n̂ acts on the contact link, and n̂ on the other link. It changes the velocities by Δq̇ = −v*/m̄ (by
/// nothing if the mechanism is immovable). The multipliers λ of the constraints satisfy Aᵀλ = M Δq̇ + jᵀ; redundant rows
/// leave λ open up to Z = ker Aᵀ. The wrench in joint i is r_i = Σ (I_b ΔV_b − impulses of contact and constraints on b)
/// over the bodies b of its subtree, in one sweep, massless links included. A component of r_i is determinate if its
/// derivative by λ vanishes on Z.
///
/// Cost: O(n) for a tree; O(m² n) for a group of m constraint rows over n coordinates. Sources: Wittenburg 2008, §5.8;
/// for the rank of redundant constraints, Wojtyra 2005.
///
/// # Errors
/// [`ReactionError`]: a massless contact; a response of another mechanism.
pub fn reactions_to_unit_impulse(
    pose: &Pose,
    response: &ContactResponse,
) -> Result<Reactions, ReactionError> {
    let mechanism = pose.mechanism();
    if response.joint_velocities.len() != mechanism.joints().len() {
        return Err(ReactionError::ForeignResponse);
    }
    let factor = match response.effective_mass {
        EffectiveMass::Finite(mass) => -1.0 / mass,
        EffectiveMass::Immovable => 0.0,
        EffectiveMass::Massless => return Err(ReactionError::Massless),
    };
    let star = JointRates { joints: response.joint_velocities.clone(), base: response.base_velocity };
    let change = JointRates::at_rest(mechanism).plus_scaled(&star, factor);
    Ok(Sweep::new(pose, response, change).reactions())
}

/// Reactions (N, N·m) to given loads of the links in motion, with the accelerations `change`.
pub(crate) fn reactions_to_loads(pose: &Pose, loads: LinkLoads, change: JointRates) -> Reactions {
    Sweep::solved(pose, loads, change).reactions()
}

/// Generalised forces of given loads over the coordinates: h + jᵀF − Q, and M u̇ with the accelerations `change`.
pub(crate) fn generalised_loads(pose: &Pose, loads: LinkLoads, change: JointRates) -> Vec<f64> {
    Sweep::unsolved(pose, loads, change).generalised_impulses()
}

/// Linear function of the multipliers of one group: one number per row.
type RowFunction = (usize, Vec<f64>);

/// State of the computation. A constraint is identified by the number of its group and its index in the group.
struct Sweep<'a> {
    pose: &'a Pose,
    change: JointRates,
    loads: LinkLoads,
    groups: Vec<GroupRows>,
    multipliers: Vec<Vec<f64>>,
    /// For each link: groups whose rows load its parent joint, with the wrench on the link at each unit multiplier, in
    /// the link's axes at its origin.
    sensitivities: Vec<Vec<(usize, Vec<Wrench<f64>>)>>,
    /// Largest unbalanced generalised impulse, relative to the unit impulse.
    residual: f64,
}

impl<'a> Sweep<'a> {
    /// Solves the multipliers and the loads of all links. `change`: Δq̇.
    fn new(pose: &'a Pose, response: &ContactResponse, change: JointRates) -> Self {
        let loads = LinkLoads::new(pose, response, &change.joints, change.base);
        Self::solved(pose, loads, change)
    }

    fn solved(pose: &'a Pose, loads: LinkLoads, change: JointRates) -> Self {
        let mut sweep = Self::unsolved(pose, loads, change);
        sweep.groups = pose.constraint_groups().into_iter().map(GroupRows::new).collect();
        sweep.solve_multipliers();
        sweep.collect_sensitivities();
        sweep
    }

    fn unsolved(pose: &'a Pose, loads: LinkLoads, change: JointRates) -> Self {
        let links = pose.mechanism().links().len();
        Self {
            pose,
            change,
            loads,
            groups: Vec::new(),
            multipliers: Vec::new(),
            sensitivities: vec![Vec::new(); links],
            residual: 0.0,
        }
    }

    /// Solves Aᵀλ = M Δq̇ + jᵀ for each group, and measures the unbalanced generalised impulses.
    fn solve_multipliers(&mut self) {
        let forces = self.generalised_impulses();
        let mut bound = vec![false; forces.len()];
        for group in &self.groups {
            group.coordinates().iter().for_each(|&c| bound[c] = true);
            let (multipliers, residual) = group.multipliers(&forces);
            self.residual = self.residual.max(residual);
            self.multipliers.push(multipliers);
        }
        let size = self.pose.mechanism().characteristic_length();
        let free = forces.iter().zip(&bound).filter(|(_, bound)| !**bound);
        // Impulses on rotations are moments: they are compared with the unit impulse at the characteristic length.
        self.residual = free.fold(self.residual, |most, (force, _)| most.max(force.abs() / size.max(1.0)));
    }

    /// M Δq̇ + jᵀ over the coordinates: the impulses that the joints would have to transmit along their free motions
    /// without the constraints.
    fn generalised_impulses(&self) -> Vec<f64> {
        let mechanism = self.pose.mechanism();
        let coordinates = self.pose.coordinate_joints();
        let mut first = vec![None; mechanism.joints().len()];
        let mut forces = vec![0.0; coordinates.len()];
        let root = &self.loads.transmitted[mechanism.root().index()];
        for (c, &(joint, k)) in coordinates.iter().enumerate() {
            match joint {
                None => forces[c] = if k < 3 { root.moment[k] } else { root.force[k - 3] },
                Some(joint) if k == 0 => first[joint.index()] = Some(c),
                Some(_) => {}
            }
        }
        for joint in mechanism.joint_ids() {
            let mimic = mechanism.joint(joint).mimic();
            let (master, multiplier) = mimic.map_or((joint, 1.0), |m| (m.master, m.multiplier));
            let Some(c) = first[master.index()].filter(|_| !self.pose.is_locked(joint)) else { continue };
            for (k, impulse) in self.impulses_on_velocities(joint).into_iter().enumerate() {
                forces[c + k] += multiplier * impulse;
            }
        }
        forces
    }

    /// Sᵀr + armature · Δq̇ of a joint, without the constraints of loops and holds.
    fn impulses_on_velocities(&self, joint: JointId) -> Vec<f64> {
        let child = self.pose.mechanism().joint(joint).child().index();
        let columns = self.pose.motion_subspace(joint);
        let armature = self.pose.armature(joint);
        let rates = &self.change.joints[joint.index()];
        let gear = |k: usize| armature.get(k).map_or(0.0, |a| a * rates[k]);
        let along = columns.iter().map(|s| self.loads.transmitted[child].power(s));
        along.enumerate().map(|(k, impulse)| impulse + gear(k)).collect()
    }

    /// Computes the wrench in each parent joint per unit multiplier. A constraint loads the joints between its two ends; joints
    /// above both ends receive no wrench.
    fn collect_sensitivities(&mut self) {
        for (number, rows) in self.groups.iter().enumerate() {
            let group = rows.group();
            let count = group.rows.nrows();
            for action in &group.constraints {
                let ends = [(action.successor, 1.0), (action.predecessor, -1.0)];
                let paths = ends.map(|(link, _)| path_to_root(self.pose, link));
                for (side, &(_, sign)) in ends.iter().enumerate() {
                    for &link in paths[side].iter().filter(|link| !paths[1 - side].contains(link)) {
                        let of_link = &mut self.sensitivities[link.index()];
                        if of_link.last().is_none_or(|(last, _)| *last != number) {
                            of_link.push((number, vec![Wrench::zero(); count]));
                        }
                        let Some((_, wrenches)) = of_link.last_mut() else { continue };
                        for (row, wrench) in action.wrenches.iter().enumerate() {
                            // The joint carries what the constraint does not.
                            let in_link = self.loads.in_link(link, wrench, &action.point);
                            wrenches[action.first + row] -= in_link * sign;
                        }
                    }
                }
            }
        }
    }

    /// All reactions.
    fn reactions(&self) -> Reactions {
        let mechanism = self.pose.mechanism();
        // The first coordinates of a floating base belong to no joint.
        let is_fixed = self.pose.coordinate_joints().first().is_none_or(|(joint, _)| joint.is_some());
        let ground = is_fixed.then(|| self.tree_reaction(mechanism.root(), &Matrix3::identity()));
        let mut reactions = Reactions {
            ground,
            joints: mechanism.joint_ids().map(|joint| self.joint_reaction(joint)).collect(),
            closures: Vec::new(),
            holds: Vec::new(),
            residual: self.residual,
        };
        let mut closures: Vec<(usize, Reaction)> = Vec::new();
        let mut holds: Vec<(usize, Reaction)> = Vec::new();
        for (number, rows) in self.groups.iter().enumerate() {
            for (index, action) in rows.group().constraints.iter().enumerate() {
                match action.source {
                    ConstraintSource::Closure(i) => {
                        closures.push((i, self.constraint_reaction(number, index)))
                    }
                    ConstraintSource::Hold(i) => holds.push((i, self.constraint_reaction(number, index))),
                    ConstraintSource::Coupling(_) => {}
                }
            }
        }
        closures.sort_by_key(|(i, _)| *i);
        holds.sort_by_key(|(i, _)| *i);
        reactions.closures = closures.into_iter().map(|(_, reaction)| reaction).collect();
        reactions.holds = holds.into_iter().map(|(_, reaction)| reaction).collect();
        reactions
    }

    /// Reaction in a joint of the tree.
    fn joint_reaction(&self, joint: JointId) -> JointReaction {
        let declared = self.pose.mechanism().joint(joint);
        let child = declared.child();
        let axes = if declared.kind().has_axis() { axes_along(declared.axis()) } else { Matrix3::identity() };
        let columns = self.pose.motion_subspace(joint);
        let (armature, rates) = (self.pose.armature(joint), &self.change.joints[joint.index()]);
        let without = self.impulses_on_velocities(joint);
        let drives = (0..columns.len()).map(|k| {
            let functions = self.functions(child, |wrench| wrench.power(&columns[k]));
            let size = if columns[k].angular.norm() > 0.0 { None } else { Some(1.0) };
            DriveImpulse {
                gear: armature.get(k).map_or(0.0, |a| a * rates[k]),
                constraint: self.component(without[k], &functions, size, &mut Vec::new()),
            }
        });
        let drives = drives.collect();
        JointReaction { joint, reaction: self.tree_reaction(child, &axes), drives }
    }

    /// Wrench on a link from its parent joint, or from the ground, along axes fixed in the link.
    fn tree_reaction(&self, link: LinkId, axes: &Matrix3<f64>) -> Reaction {
        let total = &self.loads.transmitted[link.index()];
        let mut loops = Vec::new();
        let mut along = |k: usize, moment: bool| {
            let axis = axes.column(k).into_owned();
            let part = move |w: &Wrench<f64>| if moment { w.moment.dot(&axis) } else { w.force.dot(&axis) };
            let functions = self.functions(link, part);
            self.component(part(total), &functions, (!moment).then_some(1.0), &mut loops)
        };
        let force = [0, 1, 2].map(|k| along(k, false));
        let moment = [0, 1, 2].map(|k| along(k, true));
        let frame = &self.loads.frames[link.index()];
        let frame = Transform::new(frame.rotation * axes, frame.translation);
        Reaction { frame, force, moment, loops: self.loop_names(loops) }
    }

    /// Wrench of a closure or a held contact.
    fn constraint_reaction(&self, number: usize, index: usize) -> Reaction {
        let group = self.groups[number].group();
        let action = &group.constraints[index];
        let axes = self.constraint_axes(number, index);
        let mut loops = Vec::new();
        let mut along = |k: usize, moment: bool| {
            let axis = axes.column(k).into_owned();
            let part = |w: &Wrench<f64>| if moment { w.moment.dot(&axis) } else { w.force.dot(&axis) };
            let mut function = vec![0.0; group.rows.nrows()];
            for (row, wrench) in action.wrenches.iter().enumerate() {
                function[action.first + row] = part(wrench);
            }
            let unit = (!moment).then_some(1.0);
            self.component(0.0, &[(number, function)], unit, &mut loops)
        };
        let force = [0, 1, 2].map(|k| along(k, false));
        let moment = [0, 1, 2].map(|k| along(k, true));
        let frame = Transform::new(axes, action.point);
        Reaction { frame, force, moment, loops: self.loop_names(loops) }
    }

    /// Axes, as columns in root axes, along which the reaction of constraint `index` of group `number` is resolved.
    fn constraint_axes(&self, number: usize, index: usize) -> Matrix3<f64> {
        let mechanism = self.pose.mechanism();
        let action = &self.groups[number].group().constraints[index];
        match action.source {
            ConstraintSource::Closure(i) => {
                let closure = &mechanism.closures()[i];
                let end = closure.predecessor();
                let of_link = end.link.map_or(Matrix3::identity(), |l| self.loads.frames[l.index()].rotation);
                let frame = of_link * end.frame.rotation;
                match closure.kind() {
                    // The direction of a rod is that of its only force.
                    ClosureKind::Distance => axes_along(&action.wrenches[0].force),
                    kind if kind.has_axis() => frame * axes_along(closure.axis()),
                    _ => frame,
                }
            }
            ConstraintSource::Hold(_) if action.count == 1 => axes_along(&action.wrenches[0].force),
            ConstraintSource::Hold(_) | ConstraintSource::Coupling(_) => Matrix3::identity(),
        }
    }

    /// `part` (a component) of the wrench on a link from its parent joint, as linear functions of the multipliers.
    fn functions(&self, link: LinkId, part: impl Fn(&Wrench<f64>) -> f64) -> Vec<RowFunction> {
        let of_link = &self.sensitivities[link.index()];
        of_link.iter().map(|(number, wrenches)| (*number, wrenches.iter().map(&part).collect())).collect()
    }

    /// Value of a component: `constant` plus functions of the multipliers. `unit`: size at a unit multiplier; `None`
    /// for a moment, whose size is that of the group. Appends the redundant constraints that make the value indeterminate to
    /// `open`.
    fn component(
        &self,
        constant: f64,
        functions: &[RowFunction],
        unit: Option<f64>,
        open: &mut Vec<(usize, usize)>,
    ) -> Component {
        let mut sum = constant;
        let mut is_open = false;
        for (number, function) in functions {
            let group = &self.groups[*number];
            sum += function.iter().zip(&self.multipliers[*number]).map(|(f, l)| f * l).sum::<f64>();
            let constraints = group.open_constraints(function, unit.unwrap_or(group.group().size));
            is_open |= !constraints.is_empty();
            open.extend(constraints.into_iter().map(|index| (*number, index)));
        }
        if is_open { Component::Indeterminate } else { Component::Determinate(sum) }
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

/// Two transverse directions and the axis, as columns. A zero vector gives the unit matrix.
fn axes_along(axis: &Vector3<f64>) -> Matrix3<f64> {
    if axis.norm() == 0.0 {
        return Matrix3::identity();
    }
    let axis = axis.normalize();
    let (e1, e2) = plane_basis(&axis);
    Matrix3::from_columns(&[e1, e2, axis])
}
