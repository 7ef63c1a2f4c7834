//! Converts mechanisms, linkages and contacts to the input of the crate `kernel`.

mod contact;
mod linkage;
mod massless_root;
mod mechanism;

use crate::analysis::assembly::Assembly;
pub(crate) use contact::kernel_contact;
pub(crate) use linkage::linkage;
pub(crate) use mechanism::mechanism;
use percuss_kernel::Kernel;

/// Compiled kernel of a mechanism; `None` if no kernel supports the mechanism.
pub(crate) fn compile(assembly: &Assembly) -> Option<Kernel> {
    let model = assembly.model();
    if model.groups.is_empty() {
        return Kernel::of_tree(&mechanism(model));
    }
    let linkage = linkage(assembly)?;
    // The rows may be singular as drawn.
    let kernel = Kernel::of_linkage(&linkage, &assembly.facts().reference);
    kernel.or_else(|| Kernel::of_linkage(&linkage, assembly.generic_positions()))
}
