//! SIMD kernels for many configurations at once: trees in body-fixed axes, and linkages of few degrees of freedom by their velocities.

use crate::columns::{CertifiedMass, LaneContacts, MassColumns, PositionColumns};
use crate::contact::{Contact, ContactConversion};
use crate::loops::LoopKernel;
use crate::mechanism::{Linkage, Mechanism};
use crate::tolerances::LANES_TRUSTED_ERROR;
use crate::tree::TreeKernel;
use percuss_spatial::lanes::Instructions;

/// Compiled kernel of a mechanism, with its buffers.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "one kernel per workspace; a contact allocates nothing")]
pub enum Kernel {
    /// Tree of joints.
    Tree(TreeKernel),
    /// Mechanism with closed loops or other constraints.
    Loop(LoopKernel),
}

impl Kernel {
    /// Kernel of a tree; `None` if the tree is not supported.
    pub fn of_tree(mechanism: &Mechanism) -> Option<Self> {
        TreeKernel::compile(mechanism).map(Self::Tree)
    }

    /// Kernel of a linkage whose rows are regular at the given positions; `None` if the linkage is not supported.
    pub fn of_linkage(linkage: &Linkage, positions: &[f64]) -> Option<Self> {
        LoopKernel::compile(linkage, positions).map(Self::Loop)
    }

    /// Prepares the kernel for a checked contact; false if the kernel does not support the contact. Allocates nothing
    /// after the first call.
    pub fn set_contact(&mut self, contact: &Contact) -> bool {
        match self {
            Self::Tree(tree) => tree.set_contact(contact),
            Self::Loop(linkage) => linkage.set_contact(contact),
        }
    }

    /// Conversion of points and normals to the frames of the kernel, for the current contact. `None` if the kernel does not
    /// support contacts that differ from row to row.
    pub fn conversion(&self) -> Option<ContactConversion> {
        match self {
            Self::Tree(tree) => tree.conversion(),
            Self::Loop(linkage) => linkage.conversion(),
        }
    }

    /// Reads the points and normals of the rows from columns (`None`: those of the current contact).
    pub fn set_lane_contacts(&mut self, columns: Option<LaneContacts>) {
        match self {
            Self::Tree(tree) => tree.set_lane_contacts(columns),
            Self::Loop(linkage) => linkage.set_lane_contacts(columns),
        }
    }

    /// Selects an instruction set.
    pub fn set_instructions(&mut self, set: Instructions) {
        match self {
            Self::Tree(tree) => tree.instructions = set,
            Self::Loop(linkage) => linkage.instructions = set,
        }
    }

    /// Number of configurations computed in parallel.
    pub fn width(&self) -> usize {
        match self {
            Self::Tree(tree) => tree.instructions.width(),
            Self::Loop(linkage) => linkage.instructions.width(),
        }
    }

    /// m̄ of the prepared contact at one configuration; `None` if the result is not certified.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Option<CertifiedMass> {
        match self {
            Self::Tree(tree) => tree.effective_mass(positions),
            Self::Loop(linkage) => linkage.effective_mass(positions),
        }
    }

    /// Computes m̄ at the configurations from `first` on. The number of configurations is the length of `answers`, a
    /// multiple of the lane count.
    pub fn effective_masses(&mut self, columns: PositionColumns<'_>, first: usize, answers: MassColumns<'_>) {
        match self {
            Self::Tree(tree) => tree.effective_masses(columns, first, answers),
            Self::Loop(linkage) => linkage.effective_masses(columns, first, answers),
        }
    }

    /// Largest relative error of a certified result.
    pub fn trusted_error(&self) -> f64 {
        match self {
            Self::Tree(_) => LANES_TRUSTED_ERROR,
            Self::Loop(linkage) => linkage.trusted_error(),
        }
    }

    /// Indices of the positions that the kernel reads.
    pub fn read_positions(&self) -> Vec<usize> {
        match self {
            Self::Tree(tree) => tree.read_positions().collect(),
            Self::Loop(linkage) => linkage.read_positions().collect(),
        }
    }
}
