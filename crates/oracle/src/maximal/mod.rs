//! Route C: the effective mass in maximal coordinates.
//!
//! Every link has six velocities of its own (world axes, the linear three at its centre of mass), every joint is
//! so many constraint rows, nothing is merged or eliminated by topology. The matrices are large and plain, and no
//! formula is shared with the recursions that are tested.

mod close;
mod joints;
mod loops;
mod minimum;
mod pose;
mod question;
mod residual;
mod row;
mod rows;

pub use close::{NotClosed, close, close_as_far_as_possible, moved};
pub use pose::poses;
pub use question::{Answer, Held, Outcome, Question};
pub use residual::{residual, residuals};

/// The effective mass: m̄ = min { vᵀMv : Av = 0, jv = 1 } in maximal coordinates.
///
/// See [`solve`], of which this is the outcome.
pub fn effective_mass(question: &Question) -> Outcome {
    solve(question).outcome
}

/// Solves (D) by a null-space method, with M = WᵀW written down body by body and never formed.
///
/// 1. Angular velocities are multiplied by the longest arm and the rows of A made unit vectors.
/// 2. Z, an orthonormal basis of ker A, in two steps: the kernel of the joints' rows, which are independent by
///    construction, from a QR; within it the kernel of all other rows from a singular value decomposition, whose
///    small values, up to [`threshold`](Question::threshold), count as zero.
/// 3. `Immovable` where |jZ| ≤ 1e-10 |j|.
/// 4. A reflection of the columns of Z leaves the closing speed to the first; the others minimise |W Z z|² by
///    Householder QR with rows and columns pivoted, which is stable row by row: a needle on a heavy base loses no
///    digits (Cox and Higham 1998).
/// 5. `Massless` where |W v*| is below 1e-11 of max|Wᵢ| |v*|, that is m̄ below 1e-22 of the largest mass.
///
/// Cost: O((6 links)³); 60 links take a fraction of a second in an optimised build.
///
/// # Panics
/// Where positions or armatures do not fit the joints, an id is of another mechanism, or the loops are open by more
/// than 1e-3 of the size and no threshold is given.
pub fn solve(question: &Question) -> Answer {
    minimum::minimum(&rows::assemble(question))
}
