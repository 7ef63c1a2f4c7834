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
        let of_group = |(group, decided): (&crate::model::Group, &crate::mobility::GroupMobility)| {
            let action = |rows| self.constraint_action(rows, group.size);
            ConstraintGroup {
                coordinates: group.coordinates.clone(),
                lengths: group.lengths.clone(),
                size: group.size,
                rows: model.group_matrix(&self.kinematics, group),
                rank: decided.rank.rank,
                least_singular_value: decided.rank.least,
                floor: decided.floor,
                constraints: group.constraints.iter().map(action).collect(),
            }
        };
        model.groups.iter().zip(&self.groups).map(of_group).collect()
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

    /// Wrenches of the rows of one constraint; `size` is the length of its group.
    fn constraint_action(&self, rows: &ConstraintRows, size: f64) -> ConstraintAction {
        let model = self.assembly.model();
        let mut action = ConstraintAction {
            source: ConstraintSource::Closure(0),
            name: model.constraint_name(rows.constraint),
            first: rows.first,
            count: rows.count,
            point: Vector3::zeros(),
            wrenches: Vec::new(),
            successor: None,
            predecessor: None,
            joint_forces: Vec::new(),
        };
        match rows.constraint {
            Constraint::Closure(i) => {
                let (closure, declared) = (&model.closures[i], &model.mechanism.closures()[i]);
                let x_rp = self.kinematics.frame_of(&closure.predecessor);
                let x_rs = self.kinematics.frame_of(&closure.successor);
                action.source = ConstraintSource::Closure(i);
                action.point = x_rs.translation;
                action.wrenches = closure_wrenches(closure, &x_rp, &x_rs, size)[..rows.count].to_vec();
                action.successor = declared.successor().link;
                action.predecessor = declared.predecessor().link;
            }
            Constraint::Coupling(i) => {
                let (coupling, declared) = (&model.couplings[i], &model.mechanism.couplings()[i]);
                let scale = if coupling.turns { size } else { 1.0 };
                let [slope, _] = coupling.curve_derivatives(&self.kinematics.q);
                let curve = declared.curve().map_or(&[][..], |curve| curve.terms());
                let in_curve = curve.iter().map(|&(joint, argument)| (joint, -slope * argument));
                let terms = declared.terms().iter().copied().chain(in_curve);
                action.source = ConstraintSource::Coupling(i);
                action.joint_forces = terms.map(|(joint, factor)| (joint, scale * factor)).collect();
            }
            Constraint::Hold(i) => {
                let hold = &model.holds[i];
                action.source = ConstraintSource::Hold(i);
                action.point = self.kinematics.link_frame(model, hold.link).point(&hold.point);
                let along = hold.directions().map(|d| Wrench::new(Vector3::zeros(), d));
                action.wrenches = along[..rows.count].to_vec();
                action.successor = Some(hold.link);
            }
        }
        action
    }
}
