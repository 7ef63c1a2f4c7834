//! Kernels of a linkage with other dependent coordinates, for results in doubt.
//!
//! The order of elimination is fixed when a kernel is compiled. At some poses its pivots are small, although the rows are regular: a four-bar
//! at the dead centre of its independent coordinate. A kernel with another independent coordinate is accurate there.

use super::LoopKernel;
use crate::columns::{CertifiedMass, LaneContacts, MassColumns, PositionColumns, WIDEST};
use crate::contact::Contact;
use crate::mechanism::Linkage;
use crate::tolerances::{ALTERNATIVE_KERNELS, DEPENDED_BEFORE};
use percuss_spatial::lanes::Instructions;
use std::sync::Arc;

/// Kernels of one linkage, compiled one after another at the first results in doubt.
#[derive(Clone, Debug)]
pub(crate) struct AlternativeKernels {
    linkage: Arc<Linkage>,
    /// Positions at which the rows are ordered.
    positions: Arc<[f64]>,
    /// Weight of each coordinate in the choice of pivots: the coordinates that are independent in earlier kernels are preferred.
    weights: Vec<f64>,
    kernels: Vec<LoopKernel>,
    /// Number of kernels that may still be compiled.
    left: usize,
}

impl AlternativeKernels {
    /// Alternatives to a kernel of a linkage.
    pub fn of_linkage(linkage: Linkage, positions: &[f64], first: &LoopKernel) -> Self {
        let left = if linkage.rank > 0 { ALTERNATIVE_KERNELS } else { 0 };
        let mut own = Self { left, ..Self::of_tree(linkage, positions) };
        own.reduce_weights(first);
        own
    }

    /// The alternative to the kernel of a tree: by the kinetic energy of all bodies, with sums of all terms in its bound of the error.
    pub fn of_tree(linkage: Linkage, positions: &[f64]) -> Self {
        let weights = vec![1.0; linkage.mechanism.coordinates];
        let (linkage, positions) = (Arc::new(linkage), positions.into());
        Self { linkage, positions, weights, kernels: Vec::new(), left: 1 }
    }

    /// Reduces the weights of the dependent coordinates of a kernel.
    fn reduce_weights(&mut self, kernel: &LoopKernel) {
        kernel
            .dependent_coordinates(&self.linkage.mechanism)
            .for_each(|c| self.weights[c] *= DEPENDED_BEFORE);
    }

    /// Kernel with a number, compiled when first needed, for a checked contact; `None` after the last one, and if the contact is not
    /// supported.
    fn kernel(
        &mut self,
        number: usize,
        contact: &Contact,
        instructions: Instructions,
    ) -> Option<&mut LoopKernel> {
        if number == self.kernels.len() && self.left > 0 {
            let weights = &self.weights;
            let compiled = LoopKernel::compile_weighted(&self.linkage, &self.positions, &|c| weights[c]);
            self.left = if compiled.is_some() { self.left - 1 } else { 0 };
            let kernel = compiled?;
            self.reduce_weights(&kernel);
            self.kernels.push(kernel);
        }
        let kernel = self.kernels.get_mut(number)?;
        kernel.instructions = instructions;
        kernel.set_contact(contact).then_some(kernel)
    }

    /// m̄ of a contact at one configuration by the first kernel that certifies its result.
    pub fn effective_mass(
        &mut self,
        contact: &Contact,
        positions: &[f64],
        instructions: Instructions,
    ) -> Option<CertifiedMass> {
        let mut number = 0;
        while let Some(kernel) = self.kernel(number, contact, instructions) {
            if let Some(certified) = kernel.effective_mass(positions) {
                return Some(certified);
            }
            number += 1;
        }
        None
    }

    /// Replaces the results with a relative error above `limit` by results of the first kernel that certifies them. `rows`: columns of the
    /// points and normals of the rows. Other arguments: as for [`LoopKernel::effective_masses`].
    pub fn replace_doubtful(
        &mut self,
        (contact, rows): (&Contact, Option<LaneContacts>),
        columns: PositionColumns<'_>,
        first: usize,
        answers: MassColumns<'_>,
        instructions: Instructions,
        limit: f64,
    ) {
        let MassColumns { masses, errors } = answers;
        let is_clear = |mass: f64, error: f64| CertifiedMass { mass, error }.is_clear(limit);
        let width = instructions.width();
        for (start, (masses, errors)) in
            (first..).step_by(width).zip(masses.chunks_mut(width).zip(errors.chunks_mut(width)))
        {
            let mut number = 0;
            while (0..width).any(|lane| !is_clear(masses[lane], errors[lane]))
                && let Some(kernel) = self.kernel(number, contact, instructions)
            {
                let [mut own_masses, mut own_errors] = [[f64::NAN; WIDEST]; 2];
                let own = MassColumns { masses: &mut own_masses[..width], errors: &mut own_errors[..width] };
                kernel.set_lane_contacts(rows);
                kernel.effective_masses(columns, start, own);
                for lane in 0..width {
                    let (mass, error) = (own_masses[lane], own_errors[lane]);
                    if !is_clear(masses[lane], errors[lane]) && is_clear(mass, error) {
                        (masses[lane], errors[lane]) = (mass, error);
                    }
                }
                number += 1;
            }
        }
    }
}
