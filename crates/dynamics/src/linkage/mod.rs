//! A mechanism with loops that has few freedoms, by its velocities: hinges, slides and balls on the ground or on a floating
//! base, in lanes.
//!
//! It takes mechanisms of one piece whose rows of A all count, and answers what it is sure of; all else (other joints,
//! redundant rows, positions that do not close the loops, poses near singular ones, what is massless or immovable or near
//! either) is left to [`crate::routes`].

mod compile;
mod driven;
mod motion;
mod place;
mod plan;
mod room;
mod rows;

pub(crate) use driven::Driven;

use crate::assembly::Assembly;
use crate::clear_mass::{ClearMass, Columns, WIDEST};
use crate::contact::{Contact, Direction, Frame};
use crate::model::Model;
use motion::{Answer, Normal, Struck, evaluate};
use percuss_mechanism::LinkId;
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::{BodyDirection, BodyPoint, Motion, Plan};
use std::sync::Arc;

/// A linkage prepared, the contact that it is asked for, and room.
#[derive(Clone, Debug)]
pub(crate) struct Linkage {
    plan: Arc<Plan>,
    struck: Option<Struck>,
    room: Vec<f64>,
    pub instructions: Instructions,
}

impl Linkage {
    /// None where the assembly is no such linkage.
    pub fn of(assembly: &Assembly) -> Option<Self> {
        Some(Self::with(Plan::of(assembly)?))
    }

    fn with(plan: Plan) -> Self {
        let room = vec![0.0; plan.layout.total * WIDEST];
        Self { plan: Arc::new(plan), struck: None, room, instructions: Instructions::best() }
    }

    /// Takes a checked contact, between two links too, along a line too. Allocates nothing.
    pub fn aim(&mut self, model: &Model, contact: &Contact) {
        let on = self.point(model, contact.link, &contact.point);
        let against = contact.against.and_then(|link| model.body_of(link));
        let normal = match contact.normal {
            Direction::Along(n, frame) => {
                let n = n.normalize();
                Normal::Along(match (frame, contact.against) {
                    (Frame::Link, _) => self.direction(model, contact.link, &n),
                    (Frame::Against, Some(other)) => self.direction(model, other, &n),
                    (Frame::World, _) | (Frame::Against, None) => BodyDirection { body: None, e: n.into() },
                })
            }
            Direction::Toward(link, to) => Normal::Toward(self.point(model, link, &to)),
        };
        self.struck = Some(Struck { on, against, normal });
    }

    fn point(&self, model: &Model, link: LinkId, at: &nalgebra::Vector3<f64>) -> BodyPoint {
        let on = &model.link_frames[link.index()];
        self.plan.point(on.body, &on.frame.point(at))
    }

    fn direction(&self, model: &Model, link: LinkId, e: &nalgebra::Vector3<f64>) -> BodyDirection {
        let on = &model.link_frames[link.index()];
        self.plan.direction(on.body, &on.frame.vector(e))
    }

    /// m̄ at one configuration, of the contact that it is aimed at.
    pub fn one(&mut self, positions: &[f64]) -> Option<ClearMass> {
        let (mut response, mut error) = ([0.0], [0.0]);
        let columns = Columns { values: positions, stride: 1 };
        let instructions = self.instructions;
        instructions.run_one(self.group(columns, 0, [&mut response, &mut error])?);
        ClearMass::within(response[0], error[0])
    }

    /// m̄ at as many configurations, from `first` on, as the instruction set has lanes.
    pub fn lanes(&mut self, columns: Columns<'_>, first: usize) -> [Option<ClearMass>; WIDEST] {
        let [mut responses, mut errors] = [[f64::NAN; WIDEST]; 2];
        let instructions = self.instructions;
        if let Some(group) = self.group(columns, first, [&mut responses, &mut errors]) {
            instructions.run(group);
        }
        std::array::from_fn(|lane| ClearMass::within(responses[lane], errors[lane]))
    }

    /// Which positions are read.
    pub fn read(&self) -> impl Iterator<Item = usize> + '_ {
        self.plan.bodies.iter().flat_map(|body| match body.motion {
            Motion::Fixed | Motion::Free => 0..0,
            Motion::Turn(position) | Motion::Slide(position) => position.q..position.q + 1,
            Motion::Ball(q) => q..q + 4,
        })
    }

    fn group<'a>(
        &'a mut self,
        columns: Columns<'a>,
        first: usize,
        answers: [&'a mut [f64]; 2],
    ) -> Option<Group<'a>> {
        let Self { plan, struck, room, .. } = self;
        Some(Group { plan, struck: struck.as_ref()?, columns, first, room, answers })
    }
}

/// Some lanes.
struct Group<'a> {
    plan: &'a Plan,
    struck: &'a Struck,
    columns: Columns<'a>,
    first: usize,
    room: &'a mut [f64],
    /// Responses and their errors.
    answers: [&'a mut [f64]; 2],
}

impl Work for Group<'_> {
    #[inline(always)]
    fn run<T: Lanes>(self) {
        let answer: Answer<T> = evaluate(self.plan, self.struck, self.columns, self.first, self.room);
        let [responses, errors] = self.answers;
        answer.response.store(responses);
        answer.error.store(errors);
    }
}
