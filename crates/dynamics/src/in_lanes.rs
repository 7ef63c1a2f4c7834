//! What answers many configurations at once: trees in their bodies' own axes, for contacts with the ground; linkages of few
//! freedoms by their velocities, for all contacts.

use crate::answered::{Answered, Answers, Columns};
use crate::assembly::Assembly;
use crate::contact::Contact;
use crate::linkage::Linkage;
use crate::model::Model;
use crate::own_axes::OwnAxes;
use percuss_spatial::lanes::Instructions;

/// A mechanism prepared for lanes, and room.
#[derive(Clone, Debug)]
pub(crate) enum InLanes {
    Tree(OwnAxes),
    Linkage(Linkage),
}

impl InLanes {
    /// None where the mechanism is of neither kind.
    pub fn of(assembly: &Assembly) -> Option<Self> {
        let tree = OwnAxes::of(assembly.model()).map(Self::Tree);
        tree.or_else(|| Linkage::of(assembly).map(Self::Linkage))
    }

    /// Takes a checked contact; not where it is none of its kind. Allocates nothing after the first time.
    pub fn aim(&mut self, model: &Model, contact: &Contact) -> bool {
        match self {
            Self::Tree(tree) => tree.aim(model, contact),
            Self::Linkage(linkage) => {
                linkage.aim(model, contact);
                true
            }
        }
    }

    /// Takes another instruction set.
    pub fn set_instructions(&mut self, set: Instructions) {
        match self {
            Self::Tree(tree) => tree.instructions = set,
            Self::Linkage(linkage) => linkage.instructions = set,
        }
    }

    /// How many configurations go side by side.
    pub fn width(&self) -> usize {
        match self {
            Self::Tree(tree) => tree.instructions.width(),
            Self::Linkage(linkage) => linkage.instructions.width(),
        }
    }

    /// m̄ at one configuration, of the contact that it is aimed at.
    pub fn one(&mut self, positions: &[f64]) -> Option<Answered> {
        match self {
            Self::Tree(tree) => tree.one(positions),
            Self::Linkage(linkage) => linkage.one(positions),
        }
    }

    /// m̄ at the configurations from `first` on, as many as there are answers: a multiple of the instruction set's lanes.
    pub fn lanes(&mut self, columns: Columns<'_>, first: usize, answers: Answers<'_>) {
        match self {
            Self::Tree(tree) => tree.lanes(columns, first, answers),
            Self::Linkage(linkage) => linkage.lanes(columns, first, answers),
        }
    }

    /// Which positions are read.
    pub fn read(&self) -> Vec<usize> {
        match self {
            Self::Tree(tree) => tree.read().collect(),
            Self::Linkage(linkage) => linkage.read().collect(),
        }
    }
}
