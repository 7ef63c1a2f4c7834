//! m̄ of a mechanism with loops and few degrees of freedom from its kinetic energy, in SIMD lanes: hinges, slides and
//! balls on the ground or on a floating base.
//!
//! The kernel accepts connected mechanisms without redundant rows of A, and returns only results without doubt. All
//! other cases (other joints, redundant rows, positions that do not close the loops, poses near singular ones,
//! massless or immovable contacts and contacts near either) are left to [`crate::analysis::routes`].

mod compile;
mod driven;
mod motion;
mod place;
mod plan;
mod room;
mod rows;

pub(crate) use driven::Driven;

use crate::analysis::assembly::Assembly;
use crate::kernels::aligned::Aligned;
use crate::kernels::estimate::{Answered, Answers, Columns, WIDEST};
use crate::kinematics::contact::{Contact, Direction, Frame};
use crate::model::Model;
use crate::tolerances::SHORTEST_LINE;
use motion::{Answer, Normal, Struck, evaluate};
use nalgebra::Vector3;
use percuss_mechanism::LinkId;
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::{BodyDirection, BodyPoint, Motion, Plan};
use std::sync::Arc;

/// Compiled linkage, its contact, and a workspace.
#[derive(Clone, Debug)]
pub(crate) struct Linkage {
    plan: Arc<Plan>,
    struck: Option<Struck>,
    room: Aligned,
    pub instructions: Instructions,
}

impl Linkage {
    /// `None` if the assembly is not a supported linkage.
    pub fn of(assembly: &Assembly) -> Option<Self> {
        Some(Self::with(Plan::of(assembly)?))
    }

    fn with(plan: Plan) -> Self {
        let room = Aligned::zeros(plan.layout.total * WIDEST);
        Self { plan: Arc::new(plan), struck: None, room, instructions: Instructions::best() }
    }

    /// Sets a checked contact, also between two links or along a line. Allocates nothing.
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
            Direction::Toward(link, to) | Direction::TurningToward(link, to) => {
                let drawn = model.drawn_line(contact);
                let length = drawn.map_or(f64::INFINITY, |drawn| drawn.length);
                let unit = drawn.map_or_else(Vector3::x, |drawn| drawn.unit);
                Normal::Toward {
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

    /// m̄ at one configuration for the current contact.
    pub fn one(&mut self, positions: &[f64]) -> Option<Answered> {
        Answered::of_one(|answers| {
            let columns = Columns { values: positions, stride: 1 };
            let instructions = self.instructions;
            if let Some(groups) = self.groups(columns, 0, answers) {
                instructions.run_one(groups);
            }
        })
    }

    /// m̄ at the configurations from `first` on, one per element of the output: a multiple of the instruction set's
    /// lanes.
    pub fn lanes(&mut self, columns: Columns<'_>, first: usize, answers: Answers<'_>) {
        let instructions = self.instructions;
        if let Some(groups) = self.groups(columns, first, answers) {
            instructions.run(groups);
        }
    }

    /// Positions that are read.
    pub fn read(&self) -> impl Iterator<Item = usize> + '_ {
        self.plan.bodies.iter().flat_map(|body| match body.motion {
            Motion::Fixed | Motion::Free => 0..0,
            Motion::Turn(position) | Motion::Slide(position) => position.q..position.q + 1,
            Motion::Ball(q) => q..q + 4,
        })
    }

    fn groups<'a>(
        &'a mut self,
        columns: Columns<'a>,
        first: usize,
        answers: Answers<'a>,
    ) -> Option<Groups<'a>> {
        let Self { plan, struck, room, .. } = self;
        Some(Groups { plan, struck: struck.as_ref()?, columns, first, room, answers })
    }
}

/// Configurations, one per lane.
struct Groups<'a> {
    plan: &'a Plan,
    struck: &'a Struck,
    columns: Columns<'a>,
    first: usize,
    room: &'a mut [f64],
    answers: Answers<'a>,
}

impl Work for Groups<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<T: Lanes>(self) {
        let Self { plan, struck, columns, first, room, mut answers } = self;
        let mut done = 0;
        while done < answers.masses.len() {
            let answer: Answer<T> = evaluate(plan, struck, columns, first + done, room);
            answers.put(done, answer.response, answer.error);
            done += T::WIDTH;
        }
    }
}
