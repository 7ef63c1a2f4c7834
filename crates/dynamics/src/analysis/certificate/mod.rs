//! Proved bounds of m̄: at a pose, and over ranges of joints.
//!
//! All numbers of the mechanism, of the contact and of the positions are enclosed by intervals, and every operation rounds outward: the
//! bounds hold for every mechanism whose numbers differ from those of the model by a few units in the last place (0 and ±1 are exact). The
//! mechanism is rigid, and its joints are ideal.

mod bracket;
mod certify;
mod linkage_range;
mod load;
mod loops;
mod plan;
mod problem;
mod range;
mod records;
mod subgroup;

pub use records::{
    BranchProof, CertifiedTree, ExtremeBracket, ExtremesCertificate, MassCertificate, NoCertificate,
    RangeProof,
};
