//! SIMD kernels for many configurations at once: trees in body-fixed axes, and linkages of few degrees of freedom by their velocities.

use crate::columns::{CertifiedMass, LaneContacts, MassColumns, PositionColumns};
use crate::contact::{Contact, ContactConversion};
use crate::loops::{AlternativeKernels, LoopKernel};
use crate::mechanism::Linkage;
use crate::tolerances::LANES_TRUSTED_ERROR;
use crate::tree::TreeKernel;
use percuss_spatial::lanes::Instructions;

/// Compiled kernel of a mechanism, with its buffers.
#[derive(Clone, Debug)]
pub struct Kernel {
    plan: CompiledPlan,
    /// Kernels for the results that the plan does not certify; `None` for a tree without mimics.
    alternatives: Option<AlternativeKernels>,
    /// Indices of the positions that the kernel reads; `None` for a tree without mimics, which reads those of the contact's subtree.
    read: Option<Vec<usize>>,
    contact: Option<Contact>,
    /// Columns of the points and normals of the rows.
    row_contacts: Option<LaneContacts>,
}

#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "one kernel per workspace; a contact allocates nothing")]
enum CompiledPlan {
    Tree(TreeKernel),
    Loop(LoopKernel),
}

/// Evaluates an expression for the kernel of a plan.
macro_rules! with_plan {
    ($plan:expr, $kernel:ident => $value:expr) => {
        match $plan {
            CompiledPlan::Tree($kernel) => $value,
            CompiledPlan::Loop($kernel) => $value,
        }
    };
}

impl Kernel {
    /// Kernel of a mechanism; `None` if the mechanism is not supported. The rows of constraints are ordered at the first of `poses` at which
    /// they are regular.
    pub fn compile(linkage: Linkage, poses: &[&[f64]]) -> Option<Self> {
        let tree = if linkage.blocks.is_empty() { TreeKernel::compile(&linkage.mechanism) } else { None };
        let of_loops = || poses.iter().find_map(|positions| LoopKernel::compile(&linkage, positions));
        let plan = match tree {
            Some(tree) => CompiledPlan::Tree(tree),
            None => CompiledPlan::Loop(of_loops()?),
        };
        let positions = poses.last().copied().unwrap_or_default();
        let read = linkage.mechanism.read_positions();
        let (alternatives, read) = match &plan {
            CompiledPlan::Tree(_) if linkage.mechanism.clusters.is_empty() => (None, None),
            CompiledPlan::Tree(_) => (Some(AlternativeKernels::of_tree(linkage, positions)), Some(read)),
            CompiledPlan::Loop(first) => {
                (Some(AlternativeKernels::of_linkage(linkage, positions, first)), Some(read))
            }
        };
        Some(Self { plan, alternatives, read, contact: None, row_contacts: None })
    }

    /// Prepares the kernel for a checked contact; false if the kernel does not support the contact. Allocates nothing
    /// after the first call.
    pub fn set_contact(&mut self, contact: &Contact) -> bool {
        self.contact = Some(*contact);
        with_plan!(&mut self.plan, kernel => kernel.set_contact(contact))
    }

    /// Conversion of points and normals to the frames of the kernel, for the current contact. `None` if the kernel does not
    /// support contacts that differ from row to row.
    pub fn conversion(&self) -> Option<ContactConversion> {
        with_plan!(&self.plan, kernel => kernel.conversion())
    }

    /// Reads the points and normals of the rows from columns (`None`: those of the current contact).
    pub fn set_lane_contacts(&mut self, columns: Option<LaneContacts>) {
        self.row_contacts = columns;
        with_plan!(&mut self.plan, kernel => kernel.set_lane_contacts(columns));
    }

    /// Selects an instruction set.
    pub fn set_instructions(&mut self, set: Instructions) {
        with_plan!(&mut self.plan, kernel => kernel.instructions = set);
    }

    fn instructions(&self) -> Instructions {
        with_plan!(&self.plan, kernel => kernel.instructions)
    }

    /// Number of configurations computed in parallel.
    pub fn width(&self) -> usize {
        self.instructions().width()
    }

    /// m̄ of the prepared contact at one configuration; `None` if the result is not certified.
    pub fn effective_mass(&mut self, positions: &[f64]) -> Option<CertifiedMass> {
        let own = with_plan!(&mut self.plan, kernel => kernel.effective_mass(positions));
        own.or_else(|| self.alternative_mass(&self.contact?, positions))
    }

    /// m̄ of a checked contact at one configuration, if the plan does not certify its result; `None` if no alternative certifies one either.
    pub fn alternative_mass(&mut self, contact: &Contact, positions: &[f64]) -> Option<CertifiedMass> {
        let instructions = self.instructions();
        self.alternatives.as_mut()?.effective_mass(contact, positions, instructions)
    }

    /// Computes m̄ at the configurations from `first` on. The number of configurations is the length of `answers`, a
    /// multiple of the lane count. For a tree with mimics whose rows have contacts of their own, [`alternative_mass`](Self::alternative_mass)
    /// may certify further results.
    pub fn effective_masses(&mut self, columns: PositionColumns<'_>, first: usize, answers: MassColumns<'_>) {
        let MassColumns { masses, errors } = answers;
        let own = MassColumns { masses: &mut *masses, errors: &mut *errors };
        with_plan!(&mut self.plan, kernel => kernel.effective_masses(columns, first, own));
        let (instructions, limit) = (self.instructions(), self.trusted_error());
        // The points and normals of the rows are in the frames of the plan: all plans of a linkage have the same frames.
        let has_other_frames = matches!(self.plan, CompiledPlan::Tree(_)) && self.row_contacts.is_some();
        let alternatives = self.alternatives.as_mut().filter(|_| !has_other_frames);
        if let (Some(alternatives), Some(contact)) = (alternatives, &self.contact) {
            let answers = MassColumns { masses, errors };
            let contacts = (contact, self.row_contacts);
            alternatives.replace_doubtful(contacts, columns, first, answers, instructions, limit);
        }
    }

    /// Largest relative error of a certified result.
    pub fn trusted_error(&self) -> f64 {
        match &self.plan {
            CompiledPlan::Tree(_) => LANES_TRUSTED_ERROR,
            CompiledPlan::Loop(linkage) => linkage.trusted_error(),
        }
    }

    /// Indices of the positions that the kernel reads.
    pub fn read_positions(&self) -> Vec<usize> {
        match (&self.plan, &self.read) {
            (CompiledPlan::Tree(tree), None) => tree.read_positions().collect(),
            (_, read) => read.clone().unwrap_or_default(),
        }
    }
}
