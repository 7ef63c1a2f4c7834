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
    // The rows may be singular as drawn.
    let poses = [&assembly.facts().reference[..], assembly.generic_positions()];
    let is_tree = assembly.model().groups.is_empty();
    Kernel::compile(linkage(assembly)?, if is_tree { &poses[1..] } else { &poses })
}
