//! SIMD kernels for many configurations at once. Trees use body-fixed axes, for contacts with the ground. Linkages of
//! few degrees of freedom use their velocities, for all contacts.

use crate::analysis::assembly::Assembly;
use crate::kernels::estimate::{Answered, Answers, Columns};
use crate::kernels::linkage::Linkage;
use crate::kernels::own_axes::OwnAxes;
use crate::kinematics::contact::Contact;
use crate::model::Model;
use percuss_spatial::lanes::Instructions;

/// SIMD kernel of a mechanism, with its buffers.
#[derive(Clone, Debug)]
pub(crate) enum InLanes {
    Tree(OwnAxes),
    Linkage(Linkage),
}

impl InLanes {
    /// Kernel of a mechanism; `None` if the mechanism is neither kind.
    pub fn of(assembly: &Assembly) -> Option<Self> {
        let tree = OwnAxes::of(assembly.model()).map(Self::Tree);
        tree.or_else(|| Linkage::of(assembly).map(Self::Linkage))
    }

    /// Prepares the kernel for a checked contact; false if the kernel does not support the contact. Allocates nothing
    /// after the first call.
    pub fn aim(&mut self, model: &Model, contact: &Contact) -> bool {
        match self {
            Self::Tree(tree) => tree.aim(model, contact),
            Self::Linkage(linkage) => {
                linkage.aim(model, contact);
                true
            }
        }
    }

    /// Selects an instruction set.
    pub fn set_instructions(&mut self, set: Instructions) {
        match self {
            Self::Tree(tree) => tree.instructions = set,
            Self::Linkage(linkage) => linkage.instructions = set,
        }
    }

    /// Number of configurations computed in parallel.
    pub fn width(&self) -> usize {
        match self {
            Self::Tree(tree) => tree.instructions.width(),
            Self::Linkage(linkage) => linkage.instructions.width(),
        }
    }

    /// m̄ of the prepared contact at one configuration; `None` if the result is not certified.
    pub fn one(&mut self, positions: &[f64]) -> Option<Answered> {
        match self {
            Self::Tree(tree) => tree.one(positions),
            Self::Linkage(linkage) => linkage.one(positions),
        }
    }

    /// Computes m̄ at the configurations from `first` on. The number of configurations is the length of `answers`, a
    /// multiple of the lane count.
    pub fn lanes(&mut self, columns: Columns<'_>, first: usize, answers: Answers<'_>) {
        match self {
            Self::Tree(tree) => tree.lanes(columns, first, answers),
            Self::Linkage(linkage) => linkage.lanes(columns, first, answers),
        }
    }

    /// Indices of the positions that the kernel reads.
    pub fn read(&self) -> Vec<usize> {
        match self {
            Self::Tree(tree) => tree.read().collect(),
            Self::Linkage(linkage) => linkage.read().collect(),
        }
    }
}
