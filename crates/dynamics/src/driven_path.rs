//! One contact along a path of the drivers, loops closed on the way: for linkages of few freedoms, in lanes.

use crate::assembling::LoopState;
use crate::contact::Contact;
use crate::kinematics::Kinematics;
use crate::linkage::Driven;
use crate::outcome::ResponseError;
use crate::pose::Pose;
use crate::velocities::{VelocityError, check_positions};
use percuss_mechanism::JointId;

/// A row of a path that was reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathAnswer {
    /// m̄, kg, and what rounding and what is left open of the loops may amount to; none where that is in doubt:
    /// [`DrivenPath::pose_at`] is the pose to ask.
    pub mass: Option<(f64, f64)>,
    /// How far the farthest loop is from closed, m.
    pub residual: f64,
}

/// One contact of a linkage whose drivers follow a path: each row's loops are closed by Newton's method from the row before,
/// several rows at once.
///
/// It stands on the branch of the pose that it came from, and stops before a row of which that is in doubt.
/// [`pose`](Self::pose) then gives where it stands, for [`Assembly::pose_from`](crate::Assembly::pose_from) to go on, and
/// [`restart`](Self::restart) takes it up again behind. m̄ is answered where it is finite and its error below 1e-11.
#[derive(Clone, Debug)]
pub struct DrivenPath {
    /// The pose that it came from.
    from: Pose,
    driven: Driven,
    residual: f64,
}

impl Pose {
    /// A path of `joints` from here, which rows give one number each; all other drivers stay. None where the mechanism is
    /// no linkage of few freedoms, its rows of A are redundant or bind velocities alone, this pose is singular, or these joints
    /// are not drivers. Points and normals in the world are taken with the root link at the world's origin.
    ///
    /// # Errors
    /// [`ResponseError`]: a contact that means nothing.
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
        let driven = Driven::of(&self.assembly, contact, self.positions(), &dependent, &given);
        let residual = self.loops.as_ref().map_or(0.0, |loops| loops.residual);
        Ok(driven.map(|driven| DrivenPath { from: self.clone(), driven, residual }))
    }

    /// For each coordinate, whether it depends; none where the loops are not those that answer, or stand at a singular pose.
    fn dependent_coordinates(&self) -> Option<Vec<bool>> {
        let (model, loops) = (self.assembly.model(), self.loops.as_ref()?);
        if !self.assembly.is_of_posing() || loops.anchors.iter().any(Option::is_some) {
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
    /// Follows rows, each of one number for every joint of the path, until one is in doubt. Gives how many were reached: what
    /// is known of them and the positions of all joints (one row after another) are added to `answers` and `positions`.
    pub fn follow(&mut self, rows: &[f64], answers: &mut Vec<PathAnswer>, positions: &mut Vec<f64>) -> usize {
        let width = self.driven.positions().len();
        let residual = &mut self.residual;
        self.driven.follow(rows, &mut |followed, at| {
            *residual = followed.residual;
            answers.push(PathAnswer {
                mass: followed.mass.map(|clear| (clear.mass, clear.error)),
                residual: followed.residual,
            });
            positions.extend((0..width).map(|q| at.at(q)));
        })
    }

    /// The pose where it stands.
    pub fn pose(&self) -> Pose {
        self.made(self.driven.positions(), self.residual)
    }

    /// The pose of a row that was reached: its positions, as [`follow`](Self::follow) gave them, and its residual (m).
    ///
    /// # Errors
    /// [`VelocityError::Positions`]: not as many as the mechanism has.
    pub fn pose_at(&self, positions: &[f64], residual: f64) -> Result<Pose, VelocityError> {
        check_positions(positions.len(), self.driven.positions().len())?;
        Ok(self.made(positions, residual))
    }

    fn made(&self, positions: &[f64], residual: f64) -> Pose {
        let model = self.from.assembly.posing();
        let mut kinematics = Kinematics::new(model);
        kinematics.q.copy_from_slice(positions);
        kinematics.refill(model);
        let loops = self.from.loops.as_ref().map(|l| LoopState { residual, ..l.clone() });
        self.from.assembly.pose_at(kinematics, self.from.base, loops, &self.from)
    }

    /// Stands at another pose of the same path, which the rows after it are followed from; false where it does not go on from
    /// there: its pose is singular, of another assembly, or other joints drive it.
    pub fn restart(&mut self, pose: &Pose) -> bool {
        let alike = std::sync::Arc::ptr_eq(&self.from.assembly, &pose.assembly)
            && pose.dependent_coordinates().is_some()
            && pose.dependent_coordinates() == self.from.dependent_coordinates();
        let stands = alike && self.driven.stand(pose.positions());
        if stands {
            self.from = pose.clone();
        }
        stands
    }
}
