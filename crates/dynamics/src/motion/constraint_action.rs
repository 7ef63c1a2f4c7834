//! Rows of the constraints at a pose, with the wrenches that their multipliers exert on the links.

use crate::analysis::pose::Pose;
use crate::kinematics::rows::closure_wrenches;
use crate::model::{Constraint, ConstraintRows};
use nalgebra::{DMatrix, Vector3};
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::Wrench;

/// Element of the mechanism or of the conditions that imposes a constraint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstraintSource {
    /// Index into [`Mechanism::closures`](percuss_mechanism::Mechanism::closures).
    Closure(usize),
    /// Index into [`Mechanism::couplings`](percuss_mechanism::Mechanism::couplings).
    Coupling(usize),
    /// Index of a held contact, in the order of [`Conditions::hold`](crate::Conditions::hold).
    Hold(usize),
}

/// Rows of one constraint at a pose, as actions on the links.
#[derive(Clone, Debug)]
pub struct ConstraintAction {
    /// The constraint.
    pub source: ConstraintSource,
    /// Name of the closure or coupling; for a held contact a text with the name of its link.
    pub name: String,
    /// First row of the constraint in its group.
    pub first: usize,
    /// Number of rows.
    pub count: usize,
    /// Point at which the wrenches act: origin of the successor's loop frame, or the held point, m, root frame.
    pub point: Vector3<f64>,
    /// For each row: wrench on the successor at unit multiplier, in root axes about [`point`](Self::point). The
    /// opposite wrench acts on the predecessor. Empty for a coupling.
    pub wrenches: Vec<Wrench<f64>>,
    /// Link on which the wrenches act: successor or held link; `None` for the ground and for a coupling.
    pub successor: Option<LinkId>,
    /// Link on which the opposite wrenches act; `None` for the ground and for a coupling.
    pub predecessor: Option<LinkId>,
    /// Generalised force on the joints at unit multiplier; for a coupling only.
    pub joint_forces: Vec<(JointId, f64)>,
}

/// Constraints that share coordinates, directly or through other constraints, at a pose.
///
/// The rows are rates of residuals in metres: rows of angles are multiplied by [`size`](Self::size). A multiplier is
/// therefore a force in newtons, or an impulse in N·s, for every row.
#[derive(Clone, Debug)]
pub struct ConstraintGroup {
    /// Indices of the coordinates, ascending.
    pub coordinates: Vec<usize>,
    /// For each coordinate: displacement, m, of a point at the characteristic length at unit rate.
    pub lengths: Vec<f64>,
    /// Characteristic length, m.
    pub size: f64,
    /// A of the group, rows × coordinates.
    pub rows: DMatrix<f64>,
    /// Rank of the rows at the pose, as decided for all other results of the pose.
    pub rank: usize,
    /// Smallest nonzero singular value of the rows over scaled coordinates, relative to the largest.
    pub least_singular_value: f64,
    /// Singular value, relative to the largest, below which a value counts as zero: the accuracy of the rows.
    pub floor: f64,
    /// The constraints, in the order of their rows.
    pub constraints: Vec<ConstraintAction>,
}

impl Pose {
    /// Groups of constraints at the pose, in the order of [`Assembly::groups`](crate::Assembly::groups).
    ///
    /// With multipliers λ, the generalised forces on the coordinates are Aᵀλ, and the wrench on the successor of a
    /// constraint is Σ λ w over its rows. The multipliers of redundant rows are not unique: λ + z with Aᵀz = 0 gives
    /// the same motion.
    pub fn constraint_groups(&self) -> Vec<ConstraintGroup> {
        let model = self.assembly.model();
        let of_group = |(number, group): (usize, &crate::model::Group)| {
            let action = |rows| self.constraint_action(rows);
            let mut own = ConstraintGroup {
                coordinates: group.coordinates.clone(),
                lengths: group.lengths.clone(),
                size: group.size,
                rows: DMatrix::zeros(group.rows, group.coordinates.len()),
                rank: 0,
                least_singular_value: 0.0,
                floor: 0.0,
                constraints: group.constraints.iter().map(action).collect(),
            };
            self.update_constraint_group(number, &mut own);
            own
        };
        model.groups.iter().enumerate().map(of_group).collect()
    }

    /// Moves group `number` of [`constraint_groups`](Self::constraint_groups), of another pose of the same system, to this pose. Reuses the
    /// memory of the group.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn update_constraint_group(&self, number: usize, group: &mut ConstraintGroup) {
        let (own, decided) = (&self.assembly.model().groups[number], &self.groups[number]);
        group.rows.fill(0.0);
        decided.rows.for_each(own, |row, column, value| group.rows[(row, column)] += value);
        group.rank = decided.rank.rank;
        group.least_singular_value = decided.rank.least;
        group.floor = decided.floor;
        for (rows, action) in own.constraints.iter().zip(&mut group.constraints) {
            self.move_constraint_action(rows.constraint, own.size, action);
        }
    }

    /// Rows A of group `number` of [`constraint_groups`](Self::constraint_groups) at the pose, row by row, in `rows`. Returns their
    /// rank. Does not describe the constraints, so that the same memory serves many poses.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn constraint_rows(&self, number: usize, rows: &mut Vec<f64>) -> usize {
        let (group, decided) = (&self.assembly.model().groups[number], &self.groups[number]);
        decided.rows.dense_into(group, rows);
        decided.rank.rank
    }

    /// The parts of the action of one constraint that are the same at all poses.
    fn constraint_action(&self, rows: &ConstraintRows) -> ConstraintAction {
        let model = self.assembly.model();
        let (source, successor, predecessor) = match rows.constraint {
            Constraint::Closure(i) => {
                let declared = &model.mechanism.closures()[i];
                (ConstraintSource::Closure(i), declared.successor().link, declared.predecessor().link)
            }
            Constraint::Coupling(i) => (ConstraintSource::Coupling(i), None, None),
            Constraint::Hold(i) => (ConstraintSource::Hold(i), Some(model.holds[i].link), None),
        };
        ConstraintAction {
            source,
            name: model.constraint_name(rows.constraint),
            first: rows.first,
            count: rows.count,
            point: Vector3::zeros(),
            wrenches: Vec::new(),
            successor,
            predecessor,
            joint_forces: Vec::new(),
        }
    }

    /// Computes the point, the wrenches and the joint forces of a constraint at the pose; `size` is the length of its group.
    fn move_constraint_action(&self, constraint: Constraint, size: f64, action: &mut ConstraintAction) {
        let model = self.assembly.model();
        action.wrenches.clear();
        action.joint_forces.clear();
        match constraint {
            Constraint::Closure(i) => {
                let closure = &model.closures[i];
                let x_rp = self.kinematics.frame_of(&closure.predecessor);
                let x_rs = self.kinematics.frame_of(&closure.successor);
                action.point = x_rs.translation;
                let wrenches = closure_wrenches(closure, &x_rp, &x_rs, size);
                action.wrenches.extend_from_slice(&wrenches[..action.count]);
            }
            Constraint::Coupling(i) => {
                let (coupling, declared) = (&model.couplings[i], &model.mechanism.couplings()[i]);
                let scale = if coupling.turns { size } else { 1.0 };
                let [slope, _] = coupling.curve_derivatives(&self.kinematics.q);
                let curve = declared.curve().map_or(&[][..], |curve| curve.terms());
                let in_curve = curve.iter().map(|&(joint, argument)| (joint, -slope * argument));
                let terms = declared.terms().iter().copied().chain(in_curve);
                action.joint_forces.extend(terms.map(|(joint, factor)| (joint, scale * factor)));
            }
            Constraint::Hold(i) => {
                let hold = &model.holds[i];
                action.point = self.kinematics.link_frame(model, hold.link).point(&hold.point);
                let along = hold.directions().map(|d| Wrench::new(Vector3::zeros(), d));
                action.wrenches.extend_from_slice(&along[..action.count]);
            }
        }
    }
}
