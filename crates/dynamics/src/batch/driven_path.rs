//! m̄ of one contact along a path of the drivers with closed loops: a SIMD kernel for linkages of few degrees of
//! freedom.

use crate::analysis::pose::Pose;
use crate::batch::row_remarks::{PositionLimits, RowGap};
use crate::kernels::{kernel_contact, linkage};
use crate::kinematics::contact::Contact;
use crate::kinematics::frames::Kinematics;
use crate::kinematics::outcome::{Remark, ResponseError};
use crate::kinematics::remarks::RemarkFlags;
use crate::loops::assembling::LoopState;
use crate::model::velocities::{StateSizeError, check_positions};
use percuss_kernel::loops::LoopContinuation;
use percuss_mechanism::JointId;

/// Result of one row of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathAnswer {
    /// m̄ and its error by rounding and by the residual of the loops, kg. `None` if the result is uncertain; query
    /// the pose of [`DrivenPath::pose_at`] instead.
    pub mass: Option<(f64, f64)>,
    /// Largest residual of the loops, m.
    pub residual: f64,
    /// Findings about the row: those of the branch, and joints outside their limits. A row without a result for m̄ has
    /// further findings in the response of its pose.
    pub remarks: RemarkFlags,
}

/// One contact of a linkage whose drivers follow a path. Newton's method closes the loops of each row, starting from
/// the previous row, for several rows at once.
///
/// The path stays on the branch of its start pose, and stops before a row for which the branch is in doubt.
/// [`pose`](Self::pose) then returns the current pose, from which [`Assembly::pose_from`](crate::Assembly::pose_from)
/// can continue. [`restart`](Self::restart) continues the path after the doubtful row. A row has a result for m̄ if
/// m̄ is finite and its relative error at most 1e-9.
#[derive(Clone, Debug)]
pub struct DrivenPath {
    /// Start pose.
    from: Pose,
    continuation: LoopContinuation,
    residual: f64,
    contact: Contact,
    /// Findings that hold for every row of the branch.
    remarks: RemarkFlags,
    limits: PositionLimits,
    /// Gap of the contact, if it is a named contact with a gap.
    gap: Option<RowGap>,
}

impl Pose {
    /// Path of `joints` from this pose; each row gives one number per joint. All other drivers keep their positions.
    /// `None` if the mechanism is not a linkage of few degrees of freedom, the rows of A are redundant or constrain
    /// only velocities, the pose is singular, or a joint is not a driver. For points and normals in the world, the
    /// root link is at the world's origin.
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact.
    pub fn driven_path(
        &self,
        contact: &Contact,
        joints: &[JointId],
    ) -> Result<Option<DrivenPath>, ResponseError> {
        let model = self.assembly.model();
        model.check_contact(contact)?;
        let Some(dependent) = self.dependent_coordinates() else { return Ok(None) };
        let given = joints.iter().map(|joint| model.joint_q.get(joint.index()).filter(|q| q.len() == 1));
        let Some(given) = given.map(|q| q.map(|q| q.start)).collect::<Option<Vec<usize>>>() else {
            return Ok(None);
        };
        let linkage = match model.groups.is_empty() {
            true => None,
            false => linkage(&self.assembly),
        };
        let driven = linkage.and_then(|linkage| {
            let on = kernel_contact(model, contact);
            LoopContinuation::of(&linkage, &on, self.positions(), &dependent, &given)
        });
        let residual = self.loops.as_ref().map_or(0.0, |loops| loops.residual);
        Ok(driven.map(|driven| DrivenPath {
            from: self.clone(),
            continuation: driven,
            residual,
            contact: *contact,
            remarks: self.branch_remarks(contact),
            limits: PositionLimits::of(model, true),
            gap: RowGap::of(model, contact),
        }))
    }

    /// Findings about a contact that hold for every pose of the branch with a finite m̄.
    fn branch_remarks(&self, contact: &Contact) -> RemarkFlags {
        let remarks = self.remarks();
        let of_branch = remarks.iter().filter(|remark| !matches!(remark, Remark::OutsideLimits { .. }));
        let base = self.assembly.base_remark(contact, self.base_is_given);
        of_branch.chain(&base).collect::<RemarkFlags>() | self.assembly.kernel_remarks()
    }

    /// For each coordinate: true if it is dependent at this pose. `None` if locks or held contacts change the groups, or if the
    /// pose is singular.
    fn dependent_coordinates(&self) -> Option<Vec<bool>> {
        let (model, loops) = (self.assembly.model(), self.loops.as_ref()?);
        if !self.assembly.has_single_model() || loops.anchors.iter().any(Option::is_some) {
            return None;
        }
        let mut dependent = vec![false; model.coordinates.len()];
        for (group, own) in model.groups.iter().zip(&loops.dependent) {
            own.iter().for_each(|&at| dependent[group.coordinates[at]] = true);
        }
        Some(dependent)
    }
}

impl DrivenPath {
    /// Follows rows, each with one number per joint of the path, until a row is in doubt. Returns the number of
    /// completed rows. Their results and the positions of all joints (row by row) are appended to `answers` and
    /// `positions`.
    pub fn follow(&mut self, rows: &[f64], answers: &mut Vec<PathAnswer>, positions: &mut Vec<f64>) -> usize {
        let width = self.continuation.positions().len();
        let Self { from, continuation: driven, residual, remarks, limits, gap, .. } = self;
        let model = from.assembly.model();
        driven.follow(rows, &mut |followed, at| {
            *residual = followed.residual;
            let mut own = limits.flags(|q| at.at(q));
            if let Some(gap) = gap {
                own |= gap.flags(model, |q| at.at(q));
            }
            answers.push(PathAnswer {
                mass: followed.mass.map(|clear| (clear.mass, clear.error)),
                residual: followed.residual,
                remarks: *remarks | own,
            });
            positions.extend((0..width).map(|q| at.at(q)));
        })
    }

    /// The current pose of the path.
    pub fn pose(&self) -> Pose {
        self.pose_from_positions(self.continuation.positions(), self.residual)
    }

    /// Pose of a completed row, from its positions (see [`follow`](Self::follow)) and its residual (m).
    ///
    /// # Errors
    /// [`StateSizeError::PositionCount`]: a wrong number of positions.
    pub fn pose_at(&self, positions: &[f64], residual: f64) -> Result<Pose, StateSizeError> {
        check_positions(positions.len(), self.continuation.positions().len())?;
        Ok(self.pose_from_positions(positions, residual))
    }

    /// Pose at given positions, with the given residual of the loops.
    pub(crate) fn pose_from_positions(&self, positions: &[f64], residual: f64) -> Pose {
        let model = self.from.assembly.pose_model();
        let mut kinematics = Kinematics::new(model);
        kinematics.q.copy_from_slice(positions);
        kinematics.refill(model);
        let loops = self.from.loops.as_ref().map(|l| LoopState { residual, ..l.clone() });
        self.from.assembly.pose_at(kinematics, self.from.base, loops, &self.from)
    }

    /// Moves the path to another pose; the following rows start from this pose. False if the path cannot continue
    /// there: the pose is singular, belongs to another assembly, or is driven by other joints.
    pub fn restart(&mut self, pose: &Pose) -> bool {
        let alike = std::sync::Arc::ptr_eq(&self.from.assembly, &pose.assembly)
            && pose.dependent_coordinates().is_some()
            && pose.dependent_coordinates() == self.from.dependent_coordinates();
        let is_accepted = alike && self.continuation.set_pose(pose.positions());
        if is_accepted {
            self.remarks = pose.branch_remarks(&self.contact);
            self.from = pose.clone();
        }
        is_accepted
    }
}
