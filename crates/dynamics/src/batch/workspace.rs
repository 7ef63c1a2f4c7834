//! Workspace for many configurations. After the first configuration nothing is allocated, if no group of loops has
//! more than 64 coordinates and no cluster more than 48 degrees of freedom.

use crate::analysis::assembly::Assembly;
use crate::analysis::pose::Pose;
use crate::analysis::routes::{RecursionWorkspace, RouteInput};
use crate::analysis::system::System;
use crate::kernels::lane_kernel::LaneKernel;
use crate::kinematics::contact::{Contact, ContactError, ContactPoint, Direction, Frame};
use crate::kinematics::frames::Kinematics;
use crate::kinematics::outcome::{EffectiveMass, ResponseError};
use crate::kinematics::remarks::RemarkFlags;
use crate::mobility::{GroupMobility, MobilityWorkspace};
use crate::model::Model;
use crate::model::input::{
    InputError, foreign_link, is_number, normalise_quaternion, quaternion_of, rigid_base_pose,
};
use crate::model::velocities::{StateSizeError, check_positions};
use crate::recursion::{Decisions, Recursion, RepeatedPivoting};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::{Scalar, SpatialInertia, Transform, Wrench};
use std::ops::Range;
use std::sync::Arc;

/// Reusable buffers for m̄ at many poses of a system: trees, mimics, loops and held contacts. No allocation if the
/// recursion gives the result without the dense route.
#[derive(Clone, Debug)]
pub struct Workspace {
    assembly: Arc<Assembly>,
    kinematics: Kinematics<f64>,
    groups: Vec<GroupMobility>,
    mobility_workspace: MobilityWorkspace,
    recursion: RecursionWorkspace,
    /// SIMD kernel for trees without mimics and for linkages of few degrees of freedom.
    kernel: Option<LaneKernel>,
    /// Contact for which the SIMD kernel is prepared.
    kernel_contact: Option<Contact>,
    /// True if `kinematics` is out of date.
    stale: bool,
    /// True if the buffers of the recursion are already allocated.
    is_allocated: bool,
    /// Ranges of the quaternions among the positions.
    quaternions: Vec<(JointId, Range<usize>)>,
    /// Residuals of a group of loops; a reusable buffer.
    residuals: Vec<f64>,
    /// Pose of the root link in the world, if given.
    base: Option<Transform<f64>>,
    /// Findings about the last result.
    remarks: RemarkFlags,
}

impl System {
    /// Workspace for many poses of this system. The assembly is found from all joints at 0; loops that do not close
    /// from there stay as drawn.
    pub fn workspace(&self) -> Workspace {
        self.reference_or_open().workspace()
    }
}

impl Assembly {
    /// Workspace for many poses of this assembly, initially at the first closed pose.
    pub fn workspace(self: &Arc<Self>) -> Workspace {
        let model = self.model();
        let mut kinematics = Kinematics::zero(model);
        if !model.groups.is_empty() {
            kinematics.q.copy_from_slice(&self.facts().reference);
            kinematics.refill(model);
        }
        let mut workspace = Workspace {
            assembly: Arc::clone(self),
            kinematics,
            groups: vec![GroupMobility::default(); model.groups.len()],
            mobility_workspace: MobilityWorkspace::default(),
            recursion: RecursionWorkspace::new(model),
            kernel: LaneKernel::compile(self),
            kernel_contact: None,
            stale: false,
            is_allocated: false,
            quaternions: quaternions(model),
            residuals: Vec::new(),
            base: None,
            remarks: RemarkFlags::NONE,
        };
        workspace.update_frames();
        workspace
    }
}

impl Workspace {
    /// Sets the positions of all joints one after another, in joint order (layouts of
    /// [`JointKind`](percuss_mechanism::JointKind)). Quaternions must be unit quaternions. Entries of mimics are not
    /// read. Loops must be closed, as at the positions of a [`Pose`] of the same assembly. The values are checked
    /// with the next computation of m̄.
    ///
    /// # Errors
    /// [`StateSizeError::PositionCount`]: a wrong number of positions. The workspace keeps its previous positions.
    pub fn set_positions(&mut self, positions: &[f64]) -> Result<(), StateSizeError> {
        check_positions(positions.len(), self.kinematics.q.len())?;
        self.kinematics.q.copy_from_slice(positions);
        self.stale = true;
        Ok(())
    }

    /// Sets the pose X_wr of the root link in the world, used for normals given in the world. Poses relative to the
    /// root do not change.
    ///
    /// # Errors
    /// [`InputError`]: X_wr is not a rigid frame.
    pub fn set_base(&mut self, x_wr: &Transform<f64>) -> Result<(), InputError> {
        self.base = Some(rigid_base_pose(x_wr)?);
        Ok(())
    }

    /// Findings about the last result of [`effective_mass`](Self::effective_mass). Joint limits are not checked.
    pub fn remarks(&self) -> RemarkFlags {
        self.remarks
    }

    /// Converts a normal given in the world to the root frame, and returns the findings that hold for the contact at
    /// every configuration.
    pub(crate) fn contact_in_root(&self, contact: &Contact) -> (Contact, RemarkFlags) {
        let mut flags: RemarkFlags = self.assembly.remarks().iter().collect();
        if let Some(remark) = self.assembly.base_remark(contact, self.base.is_some()) {
            flags |= RemarkFlags::from(&remark);
        }
        match (self.base, contact.normal) {
            (Some(x_wr), Direction::Along(normal, _)) if contact.has_world_normal() => {
                let normal = Direction::Along(x_wr.inverse_vector(&normal), Frame::World);
                (Contact { normal, ..*contact }, flags)
            }
            _ => (*contact, flags),
        }
    }

    /// Removes and returns the SIMD kernel; afterwards the workspace uses the recursion.
    pub(crate) fn take_kernel(&mut self) -> Option<LaneKernel> {
        self.kernel_contact = None;
        self.kernel.take()
    }

    /// Updates the frames and the mobility decisions.
    fn update_frames(&mut self) {
        self.stale = false;
        let model = self.assembly.model();
        self.kinematics.refill(model);
        for (number, group) in model.groups.iter().enumerate() {
            let (floor, expected) = (self.assembly.floor(number), self.assembly.expected_rank(number));
            let decided = &mut self.groups[number];
            model.decide_mobility(
                &mut self.mobility_workspace,
                &self.kinematics,
                group,
                floor,
                Some(expected),
                decided,
            );
        }
    }

    /// m̄ of a contact at the current positions. Equal within rounding to [`Pose::respond`].
    /// Bitwise equal, except for mechanisms with a SIMD kernel (trees without mimics against the ground, linkages of
    /// few degrees of freedom). If the recursion is inaccurate, the dense route runs and allocates. For normals given
    /// in the world, the root link is at the pose of [`set_base`](Self::set_base), by default at the world's origin.
    /// No error estimate is returned; use [`Pose::respond`]. The findings are in [`remarks`](Self::remarks).
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact; a position that is not finite, a quaternion that is not of unit length,
    /// or open loops, if m̄ depends on them; motions of negative mass without a positive effective mass; a cluster of
    /// bodies that is too large.
    pub fn effective_mass(&mut self, contact: &Contact) -> Result<EffectiveMass, ResponseError> {
        let (contact, flags) = self.contact_in_root(contact);
        self.remarks = flags;
        let contact = &contact;
        if self.kernel_contact.as_ref() != Some(contact) {
            self.kernel_contact = None;
            let model = self.assembly.model();
            model.check_contact(contact)?;
            if self.kernel.as_mut().is_none_or(|lanes| !lanes.set_contact(model, contact)) {
                return self.recursion_mass(contact);
            }
            self.kernel_contact = Some(*contact);
        }
        let Some(clear) = self.kernel.as_mut().and_then(|lanes| lanes.effective_mass(&self.kinematics.q))
        else {
            return self.recursion_mass(contact);
        };
        if !self.is_allocated {
            // Allocate the buffers of the recursion once, for configurations with uncertain lanes.
            let _ = self.recursion_mass(contact);
            self.remarks = flags;
        }
        Ok(EffectiveMass::Finite(clear.mass))
    }

    /// Index of the first position that is read and not finite.
    fn first_not_finite(&self) -> Option<usize> {
        let (q, bodies) = (&self.kinematics.q, &self.assembly.model().bodies);
        let is_mimic = |at: usize| bodies.iter().any(|body| body.mimic.is_some() && body.q.start == at);
        (0..q.len()).find(|&at| !is_number(q[at]) && !is_mimic(at))
    }

    /// The assembly of the workspace.
    pub(crate) fn assembly(&self) -> &Arc<Assembly> {
        &self.assembly
    }

    /// Computes m̄ by the recursion, starting from findings that hold at every configuration.
    pub(crate) fn recursion_mass_with(
        &mut self,
        contact: &Contact,
        remarks: RemarkFlags,
    ) -> Result<EffectiveMass, ResponseError> {
        self.remarks = remarks;
        self.recursion_mass(contact)
    }

    /// Upper limit of m̄ (kg) of the contact that the recursion last found massless; `None` if negligible.
    pub(crate) fn massless_limit(&self) -> Option<f64> {
        self.recursion.massless_limit(self.assembly.model())
    }

    /// Computes m̄ by the recursion, without the SIMD kernel.
    pub(crate) fn recursion_mass(&mut self, contact: &Contact) -> Result<EffectiveMass, ResponseError> {
        // The SIMD kernel never certifies a result from such values. Without this check the recursion would find no
        // moving body.
        if let Some(index) = self.first_not_finite() {
            return Err(ResponseError::NotFinite { index, value: self.kinematics.q[index] });
        }
        for (joint, range) in &self.quaternions {
            normalise_quaternion(&mut self.kinematics.q[range.clone()]).map_err(|norm| {
                let joint = self.assembly.model().mechanism.joint(*joint).name().to_owned();
                ResponseError::Quaternion { joint, norm }
            })?;
        }
        self.is_allocated = true;
        if self.stale {
            self.update_frames();
        }
        self.assembly.refuse_open_loops(&self.kinematics, &mut self.residuals)?;
        let model = self.assembly.model();
        let located = model.locate(&self.kinematics, &Transform::identity(), contact)?;
        model.refuse_large_clusters::<f64>(&self.groups)?;
        let route_input = RouteInput {
            model,
            kinematics: &self.kinematics,
            groups: &self.groups,
            misfits: self.assembly.misfits(),
            located: &located,
        };
        route_input.run_recursion(&mut self.recursion);
        let (mass, flags) = route_input.effective_mass(&mut self.recursion)?;
        self.remarks |= flags;
        Ok(mass)
    }
}

/// Ranges of the quaternions among the positions of a mechanism.
fn quaternions(model: &Model) -> Vec<(JointId, Range<usize>)> {
    let of_joint = |id: JointId| {
        let own = quaternion_of(model.mechanism.joint(id).kind())?;
        let first = model.joint_q[id.index()].start;
        Some((id, first + own.start..first + own.end))
    };
    model.mechanism.joint_ids().filter_map(of_joint).collect()
}

/// Computation of 1/m̄ over another scalar type: dual numbers for derivatives, SIMD lanes for several configurations.
/// The computation does not branch on values. Dependent coordinates and massless motions are those of the pose from
/// which the workspace was made.
#[derive(Debug)]
pub struct ScalarWorkspace<T: Scalar> {
    assembly: Arc<Assembly>,
    groups: Vec<GroupMobility>,
    decisions: Decisions,
    base: Transform<f64>,
    contact: Contact,
    kinematics: Kinematics<T>,
    recursion: Recursion<T, 1>,
}

impl Pose {
    /// Workspace for 1/m̄ of a contact over another scalar type, with the decisions of this pose. For an immovable
    /// contact 1/m̄ is 0 within rounding.
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact; a contact that is massless at this pose
    /// ([`MasslessMotion`](crate::RouteError::MasslessMotion)); a motion of negative mass
    /// ([`Indefinite`](crate::RouteError::Indefinite)); a cluster of bodies that is too large.
    pub fn workspace_over<T: Scalar>(&self, contact: &Contact) -> Result<ScalarWorkspace<T>, ResponseError> {
        let located = self.locate(contact)?;
        let model = self.assembly.model();
        model.refuse_large_clusters::<T>(&self.groups)?;
        let mut kinematics = Kinematics::new(model);
        for (to, from) in kinematics.q.iter_mut().zip(self.positions()) {
            *to = T::from_f64(*from);
        }
        kinematics.refill(model);
        Ok(ScalarWorkspace {
            assembly: Arc::clone(&self.assembly),
            groups: self.groups.clone(),
            decisions: self.decisions(&located)?,
            base: self.base,
            contact: *contact,
            kinematics,
            recursion: Recursion::new(model),
        })
    }
}

impl<T: Scalar> ScalarWorkspace<T> {
    /// Sets the positions (layout of [`Workspace::set_positions`]).
    ///
    /// # Errors
    /// [`StateSizeError::PositionCount`]: a wrong number of positions. The workspace keeps its previous positions.
    pub fn set_positions(&mut self, positions: &[T]) -> Result<(), StateSizeError> {
        check_positions(positions.len(), self.kinematics.q.len())?;
        self.kinematics.q.copy_from_slice(positions);
        self.kinematics.refill(self.assembly.model());
        Ok(())
    }

    /// Adds to the inertia of a link (about the link's origin, in link axes), for derivatives with respect to
    /// inertial parameters. No effect on a link of the ground.
    ///
    /// # Errors
    /// [`ContactError::ForeignLink`]: a link of another mechanism.
    pub fn add_inertia(&mut self, link: LinkId, change: &SpatialInertia<T>) -> Result<(), ContactError> {
        let frames = &self.assembly.model().link_frames;
        if let Some(index) = foreign_link(&self.assembly.model().mechanism, [link]) {
            return Err(ContactError::ForeignLink { index, links: frames.len() });
        }
        let on = &frames[link.index()];
        if let Some(body) = on.body {
            self.recursion.bodies[body] += on.frame.cast().inertia(change);
        }
        Ok(())
    }

    /// 1/m̄ at the current positions, 1/kg.
    pub fn inverse_effective_mass(&mut self) -> T {
        let model = self.assembly.model();
        let ContactPoint { point, normal } = model.contact_point(&self.kinematics, &self.base, &self.contact);
        self.recursion.clear();
        let unit = Wrench::new(Vector3::zeros(), normal);
        self.recursion.add_wrench(model.body_of(self.contact.link), 0, unit);
        let against = self.contact.against.and_then(|link| model.body_of(link));
        self.recursion.add_wrench(against, 0, -unit);
        let mut following = RepeatedPivoting(&self.decisions);
        self.recursion.eliminate(model, &self.kinematics, &self.groups, &point, &mut following);
        self.recursion.response(0, 0)
    }

    /// Measure of the distance of the last [`inverse_effective_mass`](Self::inverse_effective_mass) from a change of
    /// decisions. The sum of (zero/pivot)² over the pivots used, of D and of the constraints' K, plus the sum of
    /// (pivot/zero)² over the omitted pivots of plain joints. `zero` is the threshold below which a pose classifies a
    /// pivot as zero.
    ///
    /// Decisions are valid for the pose at which they were made. At a lane with a value not below 1 (NaN included),
    /// another decision is due; compute that lane with [`Workspace`] or [`Pose::respond`]. If the square root of the
    /// value is x, the rounding error is at most x/256 of the nearest pivot of D: 1e-6 leaves eight digits. Cost:
    /// O(n) operations, without an elimination.
    pub fn pivot_loss(&self) -> T {
        let model = self.assembly.model();
        let point = model.contact_point(&self.kinematics, &self.base, &self.contact).point;
        self.recursion.pivot_loss(model, &self.kinematics, &self.groups, &point)
    }

    /// M over the coordinates, n×n, at the current positions.
    pub fn mass_matrix(&self) -> nalgebra::DMatrix<T> {
        self.assembly.model().mass_matrix(&self.kinematics)
    }
}
