//! m̄ of a mechanism with loops and few degrees of freedom from its kinetic energy, in SIMD lanes: hinges, slides, balls and floating
//! joints on the ground or on a floating base.
//!
//! The kernel accepts connected mechanisms, and returns only results without doubt. All other cases (planar joints, redundant rows
//! that contradict each other, positions that do not close the loops, poses near singular ones, massless or immovable contacts and
//! contacts near either) are left to [`crate::analysis::routes`].

mod compile;
mod continuation;
mod energy;
mod frames;
mod layout;
mod plan;
mod rows;

pub(crate) use continuation::LoopContinuation;

use crate::analysis::assembly::Assembly;
use crate::kernels::aligned::Aligned;
use crate::kernels::estimate::{
    CertifiedMass, ContactConversion, LaneContacts, MassColumns, PositionColumns, WIDEST, relative_frame,
};
use crate::kinematics::contact::{Contact, Direction, Frame};
use crate::model::Model;
use crate::tolerances::SHORTEST_LINE;
use energy::{LoopContact, LoopNormal, LoopResponse, evaluate};
use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::LinkId;
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::{BodyDirection, BodyPoint, LoopMotion, LoopPlan};
use std::sync::Arc;

/// Compiled linkage, its contact, and a workspace.
#[derive(Clone, Debug)]
pub(crate) struct LoopKernel {
    plan: Arc<LoopPlan>,
    contact: Option<LoopContact>,
    scratch: Aligned,
    pub instructions: Instructions,
}

impl LoopKernel {
    /// `None` if the assembly is not a supported linkage.
    pub fn compile(assembly: &Assembly) -> Option<Self> {
        Some(Self::from_plan(LoopPlan::of(assembly)?))
    }

    fn from_plan(plan: LoopPlan) -> Self {
        let scratch = Aligned::zeros(plan.layout.total * WIDEST);
        Self { plan: Arc::new(plan), contact: None, scratch, instructions: Instructions::best() }
    }

    /// Sets a checked contact, also between two links or along a line; returns false for contacts on a massless root. Allocates
    /// nothing.
    pub fn set_contact(&mut self, model: &Model, contact: &Contact) -> bool {
        let target = match contact.normal {
            Direction::Along(..) => None,
            Direction::Toward(link, _)
            | Direction::TurningToward(link, _)
            | Direction::TurningAwayFrom(link, _) => Some(link),
        };
        let mut links = [Some(contact.link), contact.against, target].into_iter().flatten();
        if links.any(|link| model.body_of(link).is_some_and(|body| self.plan.massless.contains(&body))) {
            return false;
        }
        let on = self.point(model, contact.link, &contact.point);
        let against = contact.against.and_then(|link| model.body_of(link));
        let on_link = &model.link_frames[contact.link.index()];
        let to_body = relative_frame(&self.plan.frame(on_link.body), &on_link.frame);
        let mut conversion = ContactConversion { point: to_body, normal: Matrix3::identity() };
        let normal = match contact.normal {
            Direction::Along(n, frame) => {
                let (body, axes) = match (frame, contact.against) {
                    (Frame::Link, _) => self.axes(model, contact.link),
                    (Frame::Against, Some(other)) => self.axes(model, other),
                    (Frame::World, _) | (Frame::Against, None) => (None, Matrix3::identity()),
                };
                conversion.normal = axes;
                let [_, e] = conversion.convert(&contact.point, &n);
                LoopNormal::Along(BodyDirection { body, e: e.into() })
            }
            // m̄ is the same for both senses of the normal.
            Direction::Toward(link, to)
            | Direction::TurningToward(link, to)
            | Direction::TurningAwayFrom(link, to) => {
                let drawn = model.drawn_line(contact);
                let length = drawn.map_or(f64::INFINITY, |drawn| drawn.length);
                let unit = drawn.map_or_else(Vector3::x, |drawn| drawn.unit);
                LoopNormal::Toward {
                    end: self.point(model, link, &to),
                    drawn: match contact.against {
                        Some(other) => self.direction(model, other, &unit),
                        None => BodyDirection { body: None, e: unit.into() },
                    },
                    shortest: SHORTEST_LINE * length,
                    least_cosine: contact.normal.least_cosine(),
                }
            }
        };
        self.contact = Some(LoopContact { on, against, normal, columns: None, conversion });
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

    /// Body of a link, and the rotation from the link's axes to those of the body in the plan.
    fn axes(&self, model: &Model, link: LinkId) -> (Option<usize>, Matrix3<f64>) {
        let on = &model.link_frames[link.index()];
        (on.body, relative_frame(&self.plan.frame(on.body), &on.frame).rotation)
    }

    fn point(&self, model: &Model, link: LinkId, at: &nalgebra::Vector3<f64>) -> BodyPoint {
        let on = &model.link_frames[link.index()];
        self.plan.point(on.body, &on.frame.point(at))
    }

    fn direction(&self, model: &Model, link: LinkId, e: &nalgebra::Vector3<f64>) -> BodyDirection {
        let on = &model.link_frames[link.index()];
        self.plan.direction(on.body, &on.frame.vector(e))
    }

    /// m̄ at one configuration for the current contact, with its rounding error. `None` if m̄ is not finite, or if its
    /// rounding error is not small.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Option<CertifiedMass> {
        CertifiedMass::of_one(|answers| {
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

    /// Indices of the positions that the kernel reads.
    pub fn read_positions(&self) -> impl Iterator<Item = usize> + '_ {
        self.plan.bodies.iter().flat_map(|body| match body.motion {
            LoopMotion::Fixed | LoopMotion::Base => 0..0,
            LoopMotion::Turn(position) | LoopMotion::Slide(position) => position.q..position.q + 1,
            LoopMotion::Ball(q) => q..q + 4,
            LoopMotion::Floating(q) => q..q + 7,
        })
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
