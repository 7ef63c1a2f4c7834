//! Route C: the effective mass in maximal coordinates.
//!
//! Every link has six velocities (world axes, linear part at the centre of mass), and every joint adds its
//! constraint rows; nothing is eliminated by topology. The matrices are large and dense, and no formula is
//! shared with the tested recursions.

mod close;
mod joints;
mod loops;
mod minimum;
mod pose;
mod question;
mod reactions;
mod residual;
mod row;
mod rows;

pub use close::{NotClosed, close, close_as_far_as_possible, moved};
pub use pose::poses;
pub use question::{Answer, Held, Outcome, Question};
pub use reactions::{ImpactReactions, PlaceReaction, RowReaction, reactions};
pub use residual::{residual, residuals};

/// Effective mass m̄ = min { vᵀMv : Av = 0, jv = 1 } in maximal coordinates.
///
/// Outcome of [`solve`].
pub fn effective_mass(question: &Question) -> Outcome {
    solve(question).outcome
}

/// Solves (D) by a null-space method, with M = WᵀW assembled body by body and never multiplied out.
///
/// 1. Angular velocities are multiplied by the longest moment arm, and the rows of A are normalised.
/// 2. Z, an orthonormal basis of ker A, is computed in two steps: the kernel of the joint rows, which are
///    independent by construction, from a QR; within it the kernel of all other rows from a singular value
///    decomposition. Singular values up to [`threshold`](Question::threshold) count as zero.
/// 3. `Immovable` if |jZ| ≤ 1e-10 |j|.
/// 4. A reflection of the columns of Z leaves a closing speed only in the first. The others minimise |W Z z|²
///    by Householder QR with row and column pivoting, which is stable row by row: a needle on a heavy base loses
///    no digits (Cox and Higham 1998).
/// 5. `Massless` if |W v*| is below 1e-11 of max|Wᵢ| |v*|, that is, m̄ below 1e-22 of the largest mass.
///
/// Cost: O((6 links)³); 60 links take a fraction of a second in an optimised build.
///
/// # Panics
/// If positions or armatures do not match the joints, an id belongs to another mechanism, or the loop residual
/// exceeds 1e-3 of the size and no threshold is given.
pub fn solve(question: &Question) -> Answer {
    minimum::minimum(&rows::assemble(question))
}
