//! m̄ of a mechanism with loops and few degrees of freedom from its kinetic energy, in SIMD lanes: hinges, slides, planar joints, balls and
//! floating joints on the ground or on a floating base.
//!
//! The kernel returns only results without doubt. All other cases (redundant rows that contradict each other, positions that do not close the loops, poses near singular ones, massless or immovable contacts and
//! contacts near either) are left to the caller.

mod alternatives;
mod compile;
mod continuation;
mod energy;
mod frames;
mod layout;
mod plan;
mod relations;
mod rows;

pub(crate) use alternatives::AlternativeKernels;
pub use continuation::{FollowedRow, LoopContinuation, Positions};

use crate::aligned::Aligned;
use crate::columns::{CertifiedMass, LaneContacts, MassColumns, PositionColumns, WIDEST};
use crate::contact::{Contact, ContactConversion, LinkFrame, Normal, NormalFrame, relative_frame};
use crate::mechanism::{BodyDirection, Linkage, Mechanism};
use crate::tolerances::{LANES_TRUSTED_ERROR, LARGE_TRUSTED_ERROR, QUICK_COORDINATES};
use energy::{LoopContact, LoopNormal, LoopResponse, evaluate};
use nalgebra::{Matrix3, Vector3};
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::{LoopPlan, LoopVelocity};
use std::sync::Arc;

/// Compiled linkage, its contact, and a workspace.
#[derive(Clone, Debug)]
pub struct LoopKernel {
    plan: Arc<LoopPlan>,
    contact: Option<LoopContact>,
    scratch: Aligned,
    /// Instruction set.
    pub instructions: Instructions,
}

impl LoopKernel {
    /// Kernel of a linkage whose rows are regular at the given positions; `None` if the linkage is not supported.
    pub fn compile(linkage: &Linkage, positions: &[f64]) -> Option<Self> {
        Self::compile_weighted(linkage, positions, &|_| 1.0)
    }

    /// As [`compile`](Self::compile), with a weight of each coordinate in the choice of pivots.
    fn compile_weighted(linkage: &Linkage, positions: &[f64], weight: &dyn Fn(usize) -> f64) -> Option<Self> {
        Some(Self::from_plan(LoopPlan::compile(linkage, positions, weight)?))
    }

    fn from_plan(plan: LoopPlan) -> Self {
        let scratch = Aligned::zeros(plan.layout.total * WIDEST);
        Self { plan: Arc::new(plan), contact: None, scratch, instructions: Instructions::best() }
    }

    /// Sets a checked contact, also between two links or along a line; returns false for contacts on a massless root. Allocates
    /// nothing.
    pub fn set_contact(&mut self, contact: &Contact) -> bool {
        let plan = &self.plan;
        let target = match &contact.normal {
            Normal::Along(..) => None,
            Normal::Toward { end, .. } => Some(end),
        };
        let mut links = [Some(&contact.on), contact.against.as_ref(), target].into_iter().flatten();
        if links.any(|link| link.body.is_some_and(|body| plan.massless.contains(&body))) {
            return false;
        }
        let point = |link: &LinkFrame, at: &Vector3<f64>| plan.point(link.body, &link.frame.point(at));
        // Body of a link, and the rotation from the link's axes to those of the body in the plan.
        let axes =
            |link: &LinkFrame| (link.body, relative_frame(&plan.frame(link.body), &link.frame).rotation);
        let on = point(&contact.on, &contact.point);
        let against = contact.against.and_then(|link| link.body);
        let to_body = relative_frame(&plan.frame(contact.on.body), &contact.on.frame);
        let mut conversion = ContactConversion { point: to_body, normal: Matrix3::identity() };
        let normal = match &contact.normal {
            Normal::Along(n, frame) => {
                let (body, axes) = match (frame, &contact.against) {
                    (NormalFrame::Link, _) => axes(&contact.on),
                    (NormalFrame::Against, Some(other)) => axes(other),
                    (NormalFrame::Root, _) | (NormalFrame::Against, None) => (None, Matrix3::identity()),
                };
                conversion.normal = axes;
                let [_, e] = conversion.convert(&contact.point, n);
                LoopNormal::Along(BodyDirection { body, e: e.into() })
            }
            // m̄ is the same for both senses of the normal.
            Normal::Toward { end, point: at, drawn, shortest, least_cosine } => LoopNormal::Toward {
                end: point(end, at),
                drawn: match &contact.against {
                    Some(other) => plan.direction(other.body, &other.frame.vector(drawn)),
                    None => BodyDirection { body: None, e: (*drawn).into() },
                },
                shortest: *shortest,
                least_cosine: *least_cosine,
            },
        };
        let is_moment = contact.is_moment;
        self.contact = Some(LoopContact { on, against, normal, is_moment, columns: None, conversion });
        true
    }

    /// Conversion of points and normals to the frames of the kernel, for the current contact. `None` before a contact is set,
    /// and for a normal along a line.
    pub fn conversion(&self) -> Option<ContactConversion> {
        let contact = self.contact.as_ref().filter(|contact| matches!(contact.normal, LoopNormal::Along(_)));
        contact.map(|contact| contact.conversion)
    }

    /// Reads points and normals from columns (`None`: those of the current contact).
    pub fn set_lane_contacts(&mut self, columns: Option<LaneContacts>) {
        if let Some(contact) = &mut self.contact {
            contact.columns = columns;
        }
    }

    /// m̄ at one configuration for the current contact, with its rounding error. `None` if m̄ is not finite, or if its
    /// rounding error is not small.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Option<CertifiedMass> {
        CertifiedMass::of_one(self.trusted_error(), |answers| {
            let columns = PositionColumns { values: positions, stride: 1 };
            let instructions = self.instructions;
            if let Some(groups) = self.groups(columns, 0, answers) {
                instructions.run_one(groups);
            }
        })
    }

    /// m̄ at the configurations from `first` on, one per element of the output: a multiple of the instruction set's
    /// lanes.
    pub fn effective_masses(&mut self, columns: PositionColumns<'_>, first: usize, answers: MassColumns<'_>) {
        let instructions = self.instructions;
        if let Some(groups) = self.groups(columns, first, answers) {
            instructions.run(groups);
        }
    }

    /// Largest accepted relative error.
    pub fn trusted_error(&self) -> f64 {
        if self.plan.columns > QUICK_COORDINATES { LARGE_TRUSTED_ERROR } else { LANES_TRUSTED_ERROR }
    }

    /// Dependent coordinates of the mechanism from which the kernel is compiled.
    fn dependent_coordinates(&self, mechanism: &Mechanism) -> impl Iterator<Item = usize> {
        let bodies = self.plan.bodies.iter().zip(&mechanism.bodies);
        let velocities = bodies.flat_map(|(own, body)| own.velocities.iter().zip(&body.velocities));
        let is_dependent = |own: &LoopVelocity| own.column < self.plan.layout.count;
        velocities.filter_map(move |(own, velocity)| velocity.coordinate.filter(|_| is_dependent(own)))
    }

    fn groups<'a>(
        &'a mut self,
        columns: PositionColumns<'a>,
        first: usize,
        answers: MassColumns<'a>,
    ) -> Option<LoopLaneWork<'a>> {
        let Self { plan, contact, scratch, .. } = self;
        Some(LoopLaneWork { plan, contact: contact.as_ref()?, columns, first, scratch, answers })
    }
}

/// Configurations, one per lane.
struct LoopLaneWork<'a> {
    plan: &'a LoopPlan,
    contact: &'a LoopContact,
    columns: PositionColumns<'a>,
    first: usize,
    scratch: &'a mut [f64],
    answers: MassColumns<'a>,
}

impl Work for LoopLaneWork<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<T: Lanes>(self) {
        let Self { plan, contact, columns, first, scratch, mut answers } = self;
        let mut done = 0;
        while done < answers.masses.len() {
            let answer: LoopResponse<T> = evaluate(plan, contact, columns, first + done, scratch);
            answers.store(done, answer.response, answer.error);
            done += T::WIDTH;
        }
    }
}
