//! Workspace for many configurations. After the first configuration and the first results that a kernel does not certify, nothing is
//! allocated, if no group of loops has more than 64 coordinates and no cluster more than 48 degrees of freedom.

use crate::analysis::assembly::Assembly;
use crate::analysis::pose::Pose;
use crate::analysis::routes::{RecursionWorkspace, RouteInput};
use crate::analysis::system::System;
use crate::batch::row_remarks::PositionLimits;
use crate::kernels::kernel_contact;
use crate::kinematics::contact::{Contact, Frame, LocatedContact};
use crate::kinematics::frames::Kinematics;
use crate::kinematics::gap::Gap;
use crate::kinematics::outcome::{EffectiveMass, ResponseError, RouteError};
use crate::kinematics::remarks::RemarkFlags;
use crate::loops::assembling::LoopState;
use crate::mobility::{GroupMobility, MobilityWorkspace};
use crate::model::Model;
use crate::model::input::{InputError, is_number, normalise_quaternion, quaternion_of, rigid_base_pose};
use crate::model::interruption;
use crate::model::velocities::{StateSizeError, check_positions};
use nalgebra::Vector3;
use percuss_kernel::Kernel;
use percuss_mechanism::JointId;
use percuss_spatial::{Transform, Twist};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// Reusable buffers for m̄ at many poses of a system: trees, mimics, loops and held contacts. No allocation if the
/// recursion gives the result without the dense route; the first results that a kernel does not certify compile further kernels.
#[derive(Clone, Debug)]
pub struct Workspace {
    assembly: Arc<Assembly>,
    kinematics: Kinematics,
    groups: Vec<GroupMobility>,
    mobility_workspace: MobilityWorkspace,
    recursion: RecursionWorkspace,
    /// SIMD kernel for trees and for linkages of few degrees of freedom.
    kernel: Option<Kernel>,
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
    /// Joint limits.
    pub(super) limits: PositionLimits,
    /// Gaps of the named contacts with a gap.
    gaps: Vec<(Contact, Gap)>,
    /// Pose of the root link in the world, if given.
    base: Option<Transform<f64>>,
    /// Findings about the last result.
    remarks: RemarkFlags,
    /// v* of all tree velocities; a reusable buffer.
    velocities: Vec<f64>,
}

/// Response of a [`Workspace`] to a contact.
#[must_use]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkspaceResponse {
    /// m̄.
    pub effective_mass: EffectiveMass,
    /// Error of m̄ by rounding, kg; `None` unless m̄ is finite. The errors by the closing of loops and by the file are in
    /// [`ContactResponse::error`](crate::ContactResponse::error) of a pose.
    pub error: Option<f64>,
    /// Findings, as [`Workspace::remarks`].
    pub remarks: RemarkFlags,
    /// v* of a floating root link, in its axes at its origin; zero for a fixed root link.
    pub base_velocity: Twist<f64>,
}

/// Response of a [`Workspace`] to a contact at a pose: [`Workspace::respond_at`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResponseAtPose {
    /// m̄.
    pub effective_mass: EffectiveMass,
    /// Findings, as [`Workspace::remarks`].
    pub remarks: RemarkFlags,
    /// v* of a floating root link, in its axes at its origin; zero for a fixed root link.
    pub base_velocity: Twist<f64>,
    /// The contact at the pose.
    pub contact: LocatedContact,
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
            kernel: crate::kernels::compile(self),
            kernel_contact: None,
            stale: false,
            is_allocated: false,
            quaternions: quaternions(model),
            residuals: Vec::new(),
            limits: PositionLimits::of(model, false),
            gaps: Gap::all(model),
            base: None,
            remarks: RemarkFlags::NONE,
            velocities: vec![0.0; model.velocity_coordinates.len()],
        };
        if workspace.kernel.is_some() {
            // Computed here, so that no later configuration allocates.
            let _ = self.kernel_remarks();
        }
        workspace.update_frames();
        workspace
    }
}

impl Workspace {
    /// Sets the positions of all joints one after another, in joint order (layouts of
    /// [`JointKind`](percuss_mechanism::JointKind)). Quaternions must be unit quaternions. Entries of mimics are not
    /// read. Loops must be closed, as at the positions of a [`Pose`](crate::Pose) of the same assembly. The values are checked
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

    /// Findings about the last result of [`effective_mass`](Self::effective_mass).
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
        match (self.base, contact.normal.vector()) {
            (Some(x_wr), Some((vector, _))) if contact.has_world_normal() => {
                let normal = contact.normal.with_vector(x_wr.inverse_vector(&vector), Frame::World);
                (Contact { normal, ..*contact }, flags)
            }
            _ => (*contact, flags),
        }
    }

    /// Pose of the root link by which [`contact_in_root`](Self::contact_in_root) converts the normal of a contact, if it does.
    pub(crate) fn base_of_normal(&self, contact: &Contact) -> Option<Transform<f64>> {
        self.base.filter(|_| contact.has_world_normal())
    }

    /// Findings about the current positions: joints outside their limits, and [`RemarkFlags::OPEN_GAP`] if the contact is a named contact
    /// that does not touch.
    fn position_flags(&mut self, contact: &Contact) -> RemarkFlags {
        let of_limits = self.limits.flags(|q| self.kinematics.q[q]);
        let named = self.gaps.iter().find(|(named, _)| named == contact);
        let Some((_, gap)) = named else { return of_limits };
        let model = self.assembly.model();
        self.kinematics.refill(model);
        gap.open_at(model, &self.kinematics).map_or(of_limits, |_| of_limits | RemarkFlags::OPEN_GAP)
    }

    /// Removes and returns the SIMD kernel; afterwards the workspace uses the recursion.
    pub(crate) fn take_kernel(&mut self) -> Option<Kernel> {
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

    /// m̄ of a contact at the current positions. Equal within rounding to [`Pose::respond`](crate::Pose::respond).
    /// Bitwise equal, except for mechanisms with a SIMD kernel (trees, linkages of
    /// few degrees of freedom). If the recursion is inaccurate, the dense route runs and allocates. For normals given
    /// in the world, the root link is at the pose of [`set_base`](Self::set_base), by default at the world's origin.
    /// No error estimate is returned; use [`Pose::respond`](crate::Pose::respond). The findings are in [`remarks`](Self::remarks).
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact; a position that is not finite, a quaternion that is not of unit length,
    /// or open loops, if m̄ depends on them; motions of negative mass without a positive effective mass; a cluster of
    /// bodies that is too large.
    pub fn effective_mass(&mut self, contact: &Contact) -> Result<EffectiveMass, ResponseError> {
        let of_positions = self.position_flags(contact);
        let (contact, flags) = self.contact_in_root(contact);
        let flags = flags | of_positions;
        self.remarks = flags;
        let contact = &contact;
        if self.kernel_contact.as_ref() != Some(contact) {
            self.kernel_contact = None;
            let model = self.assembly.model();
            model.check_contact(contact)?;
            let own = self.kernel.as_mut();
            if own.is_none_or(|lanes| !lanes.set_contact(&kernel_contact(model, contact))) {
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
        }
        self.remarks = flags | self.assembly.kernel_remarks();
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

    /// m̄ at the current positions by the recursion, its error (kg), and the findings of the result. The error is `None` unless m̄ is
    /// finite with an error below 100 %. For loops it contains the error of closing, at the cost of a pose and with allocations. For a
    /// massless contact, it is the upper limit of m̄, if massless only within rounding.
    pub(crate) fn evaluate(
        &mut self,
        contact: &Contact,
    ) -> Result<(EffectiveMass, Option<f64>, RemarkFlags), ResponseError> {
        let (mass, rounding, limit, flags) = self.with_recursion(contact, |route_input, recursion| {
            let found = route_input.evaluate(recursion)?;
            let limit = route_input.massless_limit(recursion, found.mass);
            Ok((found.mass, found.error, limit, found.flags))
        })?;
        let is_tree = self.assembly.model().groups.is_empty();
        let error =
            rounding.and_then(|own| if is_tree { Some(own) } else { self.error_with_closing(contact) });
        // Above 100 %, a relative error of 1/m̄ bounds no m̄.
        let error = error.filter(|error| matches!(mass, EffectiveMass::Finite(m) if *error < m));
        Ok((mass, error.or(limit), flags | RemarkFlags::of_error(mass, error) | self.singular_flags()))
    }

    /// [`RemarkFlags::SINGULAR_POSE`] if branches cross at the current positions. Allocates only at a loss of rank.
    fn singular_flags(&self) -> RemarkFlags {
        let rank: usize = self.groups.iter().map(|group| group.rank.rank).sum();
        let is_singular = rank < self.assembly.generic_rank() && {
            let (assembly, kinematics) = (Arc::clone(&self.assembly), self.kinematics.clone());
            Pose::new(assembly, kinematics, Transform::identity(), None).rank().singular
        };
        if is_singular { RemarkFlags::SINGULAR_POSE } else { RemarkFlags::NONE }
    }

    /// Error of a finite m̄ of a mechanism with loops at the current positions, kg, as a pose states it: the loops may close at nearby
    /// positions of the dependent coordinates.
    fn error_with_closing(&self, contact: &Contact) -> Option<f64> {
        // Locks and held contacts change the groups; the loops close without these.
        let (posing, mut of_loops) = (self.assembly.pose_model(), Cow::Borrowed(&self.groups));
        if !self.assembly.has_single_model() {
            of_loops = Cow::Owned(self.assembly.decide_loop_mobility(&self.kinematics));
        }
        let dependent = posing.groups.iter().zip(of_loops.iter()).map(|(group, decided)| {
            let is_dependent = |at: &usize| !decided.independent.contains(at);
            (0..group.coordinates.len()).filter(is_dependent).collect()
        });
        let loops = LoopState { dependent: dependent.collect(), ..LoopState::default() };
        let (assembly, kinematics) = (Arc::clone(&self.assembly), self.kinematics.clone());
        let pose = Pose::new(assembly, kinematics, Transform::identity(), Some(loops));
        pose.respond(contact).ok()?.effective_mass_error()
    }

    /// m̄ of a contact at the current positions, its error by rounding, and v*: the velocities of all joints at unit closing speed
    /// (1/m·rad, 1), in joint order, in `velocities`. Zeros if the contact is not finite. Always by the recursion: m̄ equals that
    /// of [`Pose::respond`](crate::Pose::respond). Allocates nothing after the first call if the recursion is accurate enough.
    ///
    /// # Errors
    /// As [`effective_mass`](Self::effective_mass). `velocities` is then empty.
    pub fn respond(
        &mut self,
        contact: &Contact,
        velocities: &mut Vec<f64>,
    ) -> Result<WorkspaceResponse, ResponseError> {
        velocities.clear();
        let of_positions = self.position_flags(contact);
        let (contact, flags) = self.contact_in_root(contact);
        self.remarks = flags | of_positions;
        self.prepare_recursion()?;
        let assembly = Arc::clone(&self.assembly);
        let model = assembly.model();
        let located = model.locate(&self.kinematics, &Transform::identity(), &contact)?;
        model.refuse_large_clusters(&self.groups)?;
        let route_input = RouteInput {
            model,
            kinematics: &self.kinematics,
            groups: &self.groups,
            misfits: assembly.misfits(),
            located: &located,
        };
        route_input.run_recursion(&mut self.recursion);
        let (effective_mass, error, own) =
            route_input.respond_into(&mut self.recursion, &mut self.velocities)?;
        self.remarks |= own | RemarkFlags::of_error(effective_mass, error) | self.singular_flags();
        let base_velocity = self.split_velocities(model, velocities);
        Ok(WorkspaceResponse { effective_mass, error, remarks: self.remarks, base_velocity })
    }

    /// m̄ and v* as by [`respond`](Self::respond), at a pose of the same system, whose frames and closed loops are reused. `velocities`: v*
    /// of all joints.
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact; a mechanism that the recursion refuses. `velocities` is then empty.
    ///
    /// # Panics
    /// If the pose belongs to another system.
    pub fn respond_at(
        &mut self,
        pose: &Pose,
        contact: &Contact,
        velocities: &mut Vec<f64>,
    ) -> Result<ResponseAtPose, ResponseError> {
        velocities.clear();
        let assembly = &pose.assembly;
        let model = assembly.model();
        assert!(std::ptr::eq(model, self.assembly.model()), "the pose belongs to another system");
        self.remarks = assembly.remarks().iter().collect();
        if let Some(remark) = assembly.base_remark(contact, pose.base_is_given) {
            self.remarks |= RemarkFlags::from(&remark);
        }
        if Gap::open_of(contact, model, &pose.kinematics).is_some() {
            self.remarks |= RemarkFlags::OPEN_GAP;
        }
        let contact = pose.locate(contact)?;
        model.refuse_large_clusters(&pose.groups)?;
        let route_input = RouteInput {
            model,
            kinematics: &pose.kinematics,
            groups: &pose.groups,
            misfits: assembly.misfits(),
            located: &contact,
        };
        route_input.run_recursion(&mut self.recursion);
        let (effective_mass, own) = route_input.move_into(&mut self.recursion, &mut self.velocities)?;
        self.remarks |= own;
        let base_velocity = self.split_velocities(model, velocities);
        Ok(ResponseAtPose { effective_mass, remarks: self.remarks, base_velocity, contact })
    }

    /// Appends v* of all joints in joint order to `velocities`; returns that of a floating root link.
    fn split_velocities(&self, model: &Model, velocities: &mut Vec<f64>) -> Twist<f64> {
        for (joint, body) in model.mechanism.joints().iter().zip(&model.body_of_joint) {
            match body.map(|b| &model.bodies[b].v).filter(|v| !v.is_empty()) {
                Some(v) => velocities.extend_from_slice(&self.velocities[v.clone()]),
                None => velocities.extend(std::iter::repeat_n(0.0, joint.kind().dofs())),
            }
        }
        let base = model.bodies.iter().find(|body| body.joint.is_none() && !body.v.is_empty());
        base.map_or_else(Twist::zero, |base| {
            let v = &self.velocities[base.v.clone()];
            Twist::new(Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]))
        })
    }

    /// Checks the positions and updates the frames.
    fn prepare_recursion(&mut self) -> Result<(), ResponseError> {
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
        self.assembly.refuse_open_loops(&self.kinematics, &mut self.residuals)
    }

    /// Computes m̄ by the recursion, without the SIMD kernel.
    pub(crate) fn recursion_mass(&mut self, contact: &Contact) -> Result<EffectiveMass, ResponseError> {
        let (mass, flags) =
            self.with_recursion(contact, |route_input, recursion| route_input.effective_mass(recursion))?;
        self.remarks |= flags | self.singular_flags();
        Ok(mass)
    }

    /// Runs the recursion for a contact at the current positions, and `evaluate` after it.
    fn with_recursion<T>(
        &mut self,
        contact: &Contact,
        evaluate: impl FnOnce(&RouteInput<'_>, &mut RecursionWorkspace) -> Result<T, RouteError>,
    ) -> Result<T, ResponseError> {
        interruption::check();
        self.prepare_recursion()?;
        let model = self.assembly.model();
        let located = model.locate(&self.kinematics, &Transform::identity(), contact)?;
        model.refuse_large_clusters(&self.groups)?;
        let route_input = RouteInput {
            model,
            kinematics: &self.kinematics,
            groups: &self.groups,
            misfits: self.assembly.misfits(),
            located: &located,
        };
        route_input.run_recursion(&mut self.recursion);
        Ok(evaluate(&route_input, &mut self.recursion)?)
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
