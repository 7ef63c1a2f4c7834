//! The hot path: many configurations, nothing allocated after the first where no group of loops has more than 64
//! coordinates and no cluster more than 48 freedoms.

use crate::assembly::Assembly;
use crate::contact::{Contact, ContactError, ContactPoint, Direction, Frame};
use crate::in_lanes::InLanes;
use crate::input::{
    InputError, foreign_link, is_number, normalise_quaternion, quaternion_of, rigid_base_pose,
};
use crate::kinematics::Kinematics;
use crate::mobility::{GroupMobility, MobilityRoom};
use crate::model::Model;
use crate::outcome::{EffectiveMass, ResponseError};
use crate::pose::Pose;
use crate::recursion::{Decisions, Following, Recursion};
use crate::remarks::RemarkFlags;
use crate::routes::{Question, RecursionRoom};
use crate::system::System;
use crate::velocities::{VelocityError, check_positions};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::{Scalar, SpatialInertia, Transform, Wrench};
use std::ops::Range;
use std::sync::Arc;

/// Room to pose a system again and again and to ask for m̄: trees, mimics, loops and held contacts. Nothing is allocated
/// where the recursion answers by itself.
#[derive(Clone, Debug)]
pub struct Workspace {
    assembly: Arc<Assembly>,
    kinematics: Kinematics<f64>,
    groups: Vec<GroupMobility>,
    room: MobilityRoom,
    recursion: RecursionRoom,
    /// For trees without mimics, and for linkages of few freedoms.
    in_lanes: Option<InLanes>,
    /// The contact that lanes are aimed at.
    aimed: Option<Contact>,
    /// Whether the frames are those of positions given before the last ones.
    stale: bool,
    /// Whether there is room already for what is not answered in lanes.
    has_room: bool,
    /// Where quaternions are among the positions.
    quaternions: Vec<(JointId, Range<usize>)>,
    /// Residuals of a group of loops; refilled in place.
    residuals: Vec<f64>,
    /// The pose of the root link in the world, where it is given.
    base: Option<Transform<f64>>,
    /// The findings about the last answer.
    remarks: RemarkFlags,
}

impl System {
    /// Room for many poses of this system, in the assembly found from all joints at 0 (as drawn, where that does not
    /// close).
    pub fn workspace(&self) -> Workspace {
        self.reference_or_open().workspace()
    }
}

impl Assembly {
    /// Room for many poses of this assembly; it stands at its first closed pose.
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
            room: MobilityRoom::default(),
            recursion: RecursionRoom::new(model),
            in_lanes: InLanes::of(self),
            aimed: None,
            stale: false,
            has_room: false,
            quaternions: quaternions(model),
            residuals: Vec::new(),
            base: None,
            remarks: RemarkFlags::NONE,
        };
        workspace.refill();
        workspace
    }
}

impl Workspace {
    /// Moves to other positions: those of all joints one after another, in joint order (layouts of
    /// [`JointKind`](percuss_mechanism::JointKind)); unit quaternions; entries of mimics are not read. Loops must be closed
    /// there: positions of a [`Pose`] of the same assembly are. The values are checked when m̄ is asked.
    ///
    /// # Errors
    /// [`VelocityError::Positions`]: not as many as the mechanism has. The workspace stays where it was.
    pub fn set_positions(&mut self, positions: &[f64]) -> Result<(), VelocityError> {
        check_positions(positions.len(), self.kinematics.q.len())?;
        self.kinematics.q.copy_from_slice(positions);
        self.stale = true;
        Ok(())
    }

    /// Sets the pose X_wr of the root link in the world, for normals that are given in the world. Moves nothing relative to
    /// the root.
    ///
    /// # Errors
    /// [`InputError`]: no rigid frame.
    pub fn set_base(&mut self, x_wr: &Transform<f64>) -> Result<(), InputError> {
        self.base = Some(rigid_base_pose(x_wr)?);
        Ok(())
    }

    /// The findings about the last answer of [`effective_mass`](Self::effective_mass). Limits of joints are not looked at.
    pub fn remarks(&self) -> RemarkFlags {
        self.remarks
    }

    /// The contact with its normal in the root link's frame instead of the world's, and the findings that hold for it at
    /// every configuration.
    pub(crate) fn prepare(&self, contact: &Contact) -> (Contact, RemarkFlags) {
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

    /// What it answers in lanes with: it goes by the recursion from now on.
    pub(crate) fn take_lanes(&mut self) -> Option<InLanes> {
        self.aimed = None;
        self.in_lanes.take()
    }

    fn refill(&mut self) {
        self.stale = false;
        let model = self.assembly.model();
        self.kinematics.refill(model);
        for (number, group) in model.groups.iter().enumerate() {
            let (floor, expected) = (self.assembly.floor(number), self.assembly.expected_rank(number));
            let decided = &mut self.groups[number];
            model.decide_mobility(&mut self.room, &self.kinematics, group, floor, Some(expected), decided);
        }
    }

    /// m̄ of a contact at the positions last given: within rounding that of [`Pose::respond`] by the automatic choice, to the
    /// last bit where it does not go a way of its own, as trees without mimics against the ground do, and linkages of
    /// few freedoms. Where the recursion is not accurate the careful route
    /// is asked, which allocates. Normals in the world are taken with the root link where [`set_base`](Self::set_base) has put
    /// it, else at the world's origin. States no error: [`Pose::respond`] does. [`remarks`](Self::remarks) has the findings.
    ///
    /// # Errors
    /// [`ResponseError`]: a contact that means nothing; a position that is not finite, a quaternion that is not of unit length,
    /// loops that are open, where they matter; motions of negative mass that leave none that is positive; too large a cluster
    /// of bodies.
    pub fn effective_mass(&mut self, contact: &Contact) -> Result<EffectiveMass, ResponseError> {
        let (contact, flags) = self.prepare(contact);
        self.remarks = flags;
        let contact = &contact;
        if self.aimed.as_ref() != Some(contact) {
            self.aimed = None;
            let model = self.assembly.model();
            model.check_contact(contact)?;
            if self.in_lanes.as_mut().is_none_or(|lanes| !lanes.aim(model, contact)) {
                return self.by_recursion(contact);
            }
            self.aimed = Some(*contact);
        }
        let Some(clear) = self.in_lanes.as_mut().and_then(|lanes| lanes.one(&self.kinematics.q)) else {
            return self.by_recursion(contact);
        };
        if !self.has_room {
            // The memory of the recursion is reserved once, for configurations that the lanes leave in doubt.
            let _ = self.by_recursion(contact);
            self.remarks = flags;
        }
        Ok(EffectiveMass::Finite(clear.mass))
    }

    /// The first position that is not finite, of those that are read.
    fn not_finite(&self) -> Option<usize> {
        let (q, bodies) = (&self.kinematics.q, &self.assembly.model().bodies);
        let is_mimic = |at: usize| bodies.iter().any(|body| body.mimic.is_some() && body.q.start == at);
        (0..q.len()).find(|&at| !is_number(q[at]) && !is_mimic(at))
    }

    /// The assembly.
    pub(crate) fn assembly(&self) -> &Arc<Assembly> {
        &self.assembly
    }

    /// By the recursion, with findings that hold at every configuration.
    pub(crate) fn by_recursion_with(
        &mut self,
        contact: &Contact,
        remarks: RemarkFlags,
    ) -> Result<EffectiveMass, ResponseError> {
        self.remarks = remarks;
        self.by_recursion(contact)
    }

    /// The largest m̄ (kg) that the contact may have that the recursion last found massless; `None` if that is negligible.
    pub(crate) fn massless_to(&self) -> Option<f64> {
        self.recursion.massless_to(self.assembly.model())
    }

    /// The same, whatever lanes may know.
    pub(crate) fn by_recursion(&mut self, contact: &Contact) -> Result<EffectiveMass, ResponseError> {
        // Lanes are sure of no answer that comes of these; the recursion would find nothing that moves.
        if let Some(index) = self.not_finite() {
            return Err(ResponseError::NotFinite { index, value: self.kinematics.q[index] });
        }
        for (joint, range) in &self.quaternions {
            normalise_quaternion(&mut self.kinematics.q[range.clone()]).map_err(|norm| {
                let joint = self.assembly.model().mechanism.joint(*joint).name().to_owned();
                ResponseError::Quaternion { joint, norm }
            })?;
        }
        self.has_room = true;
        if self.stale {
            self.refill();
        }
        self.assembly.refuse_open_loops(&self.kinematics, &mut self.residuals)?;
        let model = self.assembly.model();
        let located = model.locate(&self.kinematics, &Transform::identity(), contact)?;
        model.refuse_large_clusters::<f64>(&self.groups)?;
        let question = Question {
            model,
            kinematics: &self.kinematics,
            groups: &self.groups,
            misfits: self.assembly.misfits(),
            located: &located,
        };
        question.run(&mut self.recursion);
        let (mass, flags) = question.effective_mass(&mut self.recursion)?;
        self.remarks |= flags;
        Ok(mass)
    }
}

/// Where quaternions are among the positions of a mechanism.
fn quaternions(model: &Model) -> Vec<(JointId, Range<usize>)> {
    let of_joint = |id: JointId| {
        let own = quaternion_of(model.mechanism.joint(id).kind())?;
        let first = model.joint_q[id.index()].start;
        Some((id, first + own.start..first + own.end))
    };
    model.mechanism.joint_ids().filter_map(of_joint).collect()
}

/// The whole answer over another scalar: dual numbers for derivatives, lanes for several configurations. Branches on no
/// value: it follows what a pose decided (which coordinates depend, which motions have no mass).
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
    /// Room to ask for m̄ of a contact over another scalar, with the decisions of this pose. Of an immovable contact 1/m̄ is
    /// 0 to rounding.
    ///
    /// # Errors
    /// [`ResponseError`]: a contact that means nothing; one that is massless here
    /// ([`MasslessMotion`](crate::RouteError::MasslessMotion)); a motion of negative mass
    /// ([`Indefinite`](crate::RouteError::Indefinite)); too large a cluster of bodies.
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
    /// Moves to other positions (layout of [`Workspace::set_positions`]).
    ///
    /// # Errors
    /// [`VelocityError::Positions`]: not as many as the mechanism has. The workspace stays where it was.
    pub fn set_positions(&mut self, positions: &[T]) -> Result<(), VelocityError> {
        check_positions(positions.len(), self.kinematics.q.len())?;
        self.kinematics.q.copy_from_slice(positions);
        self.kinematics.refill(self.assembly.model());
        Ok(())
    }

    /// Adds to the inertia of a link (about its own origin, in its axes): a derivative by a mass is asked that way. A link
    /// of the ground carries none.
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

    /// 1/m̄ at the positions last given, 1/kg.
    pub fn inverse_effective_mass(&mut self) -> T {
        let model = self.assembly.model();
        let ContactPoint { point, normal } = model.contact_point(&self.kinematics, &self.base, &self.contact);
        self.recursion.clear();
        let unit = Wrench::new(Vector3::zeros(), normal);
        self.recursion.add_wrench(model.body_of(self.contact.link), 0, unit);
        let against = self.contact.against.and_then(|link| model.body_of(link));
        self.recursion.add_wrench(against, 0, -unit);
        let mut following = Following(&self.decisions);
        self.recursion.eliminate(model, &self.kinematics, &self.groups, &point, &mut following);
        self.recursion.response(0, 0)
    }

    /// How near the pivots of the last [`inverse_effective_mass`](Self::inverse_effective_mass) are to what a pose takes for
    /// zero: the sum of (zero/pivot)² over those that it followed, of D and of the constraints' K, and of (pivot/zero)² over
    /// those of plain joints that it left out.
    ///
    /// Decisions hold for the pose that they were made at. A lane where this is not below 1 (NaN is not) stands where
    /// another decision is due: ask there again with [`Workspace`] or [`Pose::respond`]. Where its root is x, rounding is up
    /// to x/256 of the nearest pivot of D: 1e-6 leaves eight digits. It costs O(n) operations and no elimination.
    pub fn pivot_loss(&self) -> T {
        let model = self.assembly.model();
        let point = model.contact_point(&self.kinematics, &self.base, &self.contact).point;
        self.recursion.pivot_loss(model, &self.kinematics, &self.groups, &point)
    }

    /// M over the coordinates, n×n, at the positions last given.
    pub fn mass_matrix(&self) -> nalgebra::DMatrix<T> {
        self.assembly.model().mass_matrix(&self.kinematics)
    }
}
