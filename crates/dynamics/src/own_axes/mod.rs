//! The recursion of a tree in its bodies' own axes, on the ground or floating, in lanes.
//!
//! It answers what it is sure of; all else (what is massless, immovable, near either, lost to rounding) is left to
//! [`crate::routes`], as are mimics, loops and contacts between two links.

mod carried;
mod hinge;
mod plan;
mod recursion;

use crate::clear_mass::{ClearMass, Columns, WIDEST};
use crate::contact::{Contact, Direction, Frame};
use crate::model::Model;
use carried::ROOM;
use nalgebra::Vector3;
use percuss_spatial::lanes::{Instructions, Lanes, Work};
use plan::{Placed, Plan};
use recursion::{Answer, Normal, Selection, Struck, evaluate};
use std::sync::Arc;

/// A tree prepared, the contact that it is asked for, and room.
#[derive(Clone, Debug)]
pub(crate) struct OwnAxes {
    steps: Arc<[Placed]>,
    selection: Selection,
    room: Vec<f64>,
    pub instructions: Instructions,
}

impl OwnAxes {
    /// None where the model is no such tree.
    pub fn of(model: &Model) -> Option<Self> {
        let plan = Plan::of(model)?;
        let selection = Selection::none(plan.steps.len(), plan.travel);
        let steps: Arc<[Placed]> = plan.placed().into();
        let room = vec![0.0; steps.len() * ROOM * WIDEST];
        Some(Self { steps, selection, room, instructions: Instructions::best() })
    }

    /// Takes a checked contact; not where it is none of its kind. Allocates nothing after the first time.
    pub fn aim(&mut self, model: &Model, contact: &Contact) -> bool {
        let Some(body) = model.body_of(contact.link) else { return false };
        let Direction::Along(n, frame) = contact.normal else { return false };
        let other = contact.against.map(|link| &model.link_frames[link.index()]);
        if other.is_some_and(|other| other.body.is_some()) {
            return false;
        }
        let last = self.steps.len() - 1;
        let own = &self.steps[last - body].step.frame;
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

    /// m̄ at one configuration, by what it is aimed at.
    pub fn one(&mut self, positions: &[f64]) -> Option<ClearMass> {
        let (mut response, mut terms, mut loss) = ([0.0], [0.0], [0.0]);
        let columns = Columns { values: positions, stride: 1 };
        let instructions = self.instructions;
        instructions.run_one(self.group(columns, 0, [&mut response, &mut terms, &mut loss]));
        ClearMass::of(response[0], terms[0], loss[0])
    }

    /// m̄ at as many configurations, from `first` on, as the instruction set has lanes.
    pub fn lanes(&mut self, columns: Columns<'_>, first: usize) -> [Option<ClearMass>; WIDEST] {
        let [mut responses, mut terms, mut losses] = [[f64::NAN; WIDEST]; 3];
        let instructions = self.instructions;
        instructions.run(self.group(columns, first, [&mut responses, &mut terms, &mut losses]));
        std::array::from_fn(|lane| ClearMass::of(responses[lane], terms[lane], losses[lane]))
    }

    /// Which positions are read.
    pub fn read(&self) -> impl Iterator<Item = usize> + '_ {
        let Selection { on_path, top, .. } = &self.selection;
        let steps = self.steps.iter().zip(on_path);
        let read = steps.filter(|(placed, on_path)| placed.top == *top || **on_path);
        read.flat_map(|(placed, _)| placed.step.positions())
    }

    fn group<'a>(&'a mut self, columns: Columns<'a>, first: usize, answers: [&'a mut [f64]; 3]) -> Group<'a> {
        let Self { steps, selection, room, .. } = self;
        Group { steps, selection, columns, first, room, answers }
    }
}

/// Some lanes.
struct Group<'a> {
    steps: &'a [Placed],
    selection: &'a Selection,
    columns: Columns<'a>,
    first: usize,
    room: &'a mut [f64],
    /// Responses, terms, losses.
    answers: [&'a mut [f64]; 3],
}

impl Work for Group<'_> {
    #[inline(always)]
    fn run<T: Lanes>(self) {
        let answer: Answer<T> = evaluate(self.steps, self.selection, self.columns, self.first, self.room);
        let [responses, terms, losses] = self.answers;
        answer.response.store(responses);
        answer.terms.store(terms);
        answer.loss.store(losses);
    }
}
