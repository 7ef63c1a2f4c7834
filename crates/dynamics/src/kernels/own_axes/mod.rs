//! Recursion of a tree in the bodies' own axes, with a fixed or a floating base, in SIMD lanes.
//!
//! The kernel returns only results without doubt. All other cases (massless or immovable contacts and contacts near
//! either, results lost to rounding) are left to [`crate::analysis::routes`], as are mimics, loops and contacts between two
//! links.

mod carried;
mod hinge;
mod plan;
mod recursion;
mod sizes;
mod slid;
mod way;

use crate::kernels::aligned::Aligned;
use crate::kernels::estimate::{Answered, Answers, Columns, WIDEST};
use crate::kinematics::contact::{Contact, Direction, Frame};
use crate::model::Model;
use carried::ROOM;
use nalgebra::Vector3;
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::{Placed, Plan};
use recursion::{Answer, Normal, Selection, Struck, evaluate};
use std::sync::Arc;

/// Compiled tree, its contact, and a workspace.
#[derive(Clone, Debug)]
pub(crate) struct OwnAxes {
    steps: Arc<[Placed]>,
    selection: Selection,
    room: Aligned,
    pub instructions: Instructions,
}

impl OwnAxes {
    /// `None` if the model has mimics, loops or negative masses.
    pub fn of(model: &Model) -> Option<Self> {
        let plan = Plan::of(model)?;
        let selection = Selection::none(plan.steps.len(), plan.travel);
        let mut steps = plan.placed();
        slid::find(&mut steps);
        let steps: Arc<[Placed]> = steps.into();
        let room = Aligned::zeros(steps.len() * ROOM * WIDEST);
        Some(Self { steps, selection, room, instructions: Instructions::best() })
    }

    /// Sets a checked contact; returns false for an unsupported kind. Allocates nothing after the first call.
    pub fn aim(&mut self, model: &Model, contact: &Contact) -> bool {
        let Some(body) = model.body_of(contact.link) else { return false };
        let Direction::Along(n, frame) = contact.normal else { return false };
        let other = contact.against.map(|link| &model.link_frames[link.index()]);
        if other.is_some_and(|other| other.body.is_some()) {
            return false;
        }
        let last = self.steps.len() - 1;
        let own = &self.steps[last - body].step.own.frame;
        let link = &model.link_frames[contact.link.index()].frame;
        let n = n.normalize();
        let normal = match (frame, other) {
            (Frame::Link, _) => Normal::Body(own.inverse_vector(&link.vector(&n)).into()),
            (Frame::Against, Some(other)) => Normal::Root(other.frame.vector(&n).into()),
            (Frame::World, _) | (Frame::Against, None) => Normal::Root(n.into()),
        };
        let point: Vector3<f64> = own.inverse_point(&link.point(&contact.point));
        let Selection { path, on_path, .. } = &mut self.selection;
        path.iter().for_each(|&at| on_path[at] = false);
        path.clear();
        let mut next = Some(body);
        while let Some(number) = next {
            path.push(last - number);
            on_path[last - number] = true;
            next = self.steps[last - number].step.parent;
        }
        path.reverse();
        self.selection.top = self.steps[last - body].top;
        self.selection.struck = Struck { point: point.into(), normal };
        true
    }

    /// m̄ at one configuration for the current contact.
    pub fn one(&mut self, positions: &[f64]) -> Option<Answered> {
        Answered::of_one(|answers| {
            let columns = Columns { values: positions, stride: 1 };
            let instructions = self.instructions;
            instructions.run_one(self.groups(columns, 0, answers));
        })
    }

    /// m̄ at the configurations from `first` on, one per element of the output: a multiple of the instruction set's
    /// lanes.
    pub fn lanes(&mut self, columns: Columns<'_>, first: usize, answers: Answers<'_>) {
        let instructions = self.instructions;
        instructions.run(self.groups(columns, first, answers));
    }

    /// Positions that are read.
    pub fn read(&self) -> impl Iterator<Item = usize> + '_ {
        let Selection { on_path, top, .. } = &self.selection;
        let steps = self.steps.iter().zip(on_path);
        let read = steps.filter(|(placed, on_path)| placed.top == *top || **on_path);
        read.flat_map(|(placed, _)| placed.step.positions())
    }

    fn groups<'a>(&'a mut self, columns: Columns<'a>, first: usize, answers: Answers<'a>) -> Groups<'a> {
        let Self { steps, selection, room, .. } = self;
        Groups { steps, selection, columns, first, room, answers }
    }
}

/// Configurations, one per lane.
struct Groups<'a> {
    steps: &'a [Placed],
    selection: &'a Selection,
    columns: Columns<'a>,
    first: usize,
    room: &'a mut [f64],
    answers: Answers<'a>,
}

impl Work for Groups<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<T: Lanes>(self) {
        let Self { steps, selection, columns, first, room, mut answers } = self;
        let mut done = 0;
        while done < answers.masses.len() {
            let answer: Answer<T> = evaluate(steps, selection, columns, first + done, room);
            answers.put(done, answer.response, answer.roundings * answer.terms);
            done += T::WIDTH;
        }
    }
}
