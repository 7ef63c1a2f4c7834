//! What the recursion keeps of the eliminations that it made.

use crate::mobility::Rates;
use crate::model::Model;
use percuss_spatial::{Scalar, Twist, Wrench};

/// Room for the motion that the recursion leads to; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct Motion<T: Scalar> {
    /// Velocities of the tree.
    pub velocities: Vec<T>,
    /// Twists of the bodies, root axes at the contact point.
    pub twists: Vec<Twist<T>>,
    /// Of the cluster at hand: rates of its independent coordinates.
    pub(super) rates: Vec<T>,
}

impl<T: Scalar> Motion<T> {
    pub fn new(model: &Model) -> Self {
        Self {
            velocities: vec![T::zero(); model.follows.len()],
            twists: vec![Twist::zero(); model.bodies.len()],
            rates: Vec::new(),
        }
    }
}

/// What the recursion keeps for one velocity.
#[derive(Clone, Debug)]
pub(crate) struct JointElimination<T: Scalar, const K: usize> {
    /// Motion column in root axes at the contact point.
    pub s: Twist<T>,
    /// U = Iᴬ s.
    pub u: Wrench<T>,
    /// D = sᵀ Iᴬ s + armature.
    pub d: T,
    /// sᵀ f for every test wrench.
    pub t: [T; K],
    /// Whether the pivot counts; else the motion has no mass.
    pub counts: bool,
}

impl<T: Scalar, const K: usize> JointElimination<T, K> {
    pub fn blank() -> Self {
        Self { s: Twist::zero(), u: Wrench::zero(), d: T::zero(), t: [T::zero(); K], counts: false }
    }
}

/// What the recursion keeps for one bound cluster; `d` is the number of its independent coordinates.
#[derive(Clone, Debug)]
pub(crate) struct ClusterElimination<T: Scalar, const K: usize> {
    pub(super) rates: Vec<Rates<T>>,
    /// G, coordinates × d, row by row: rates of the cluster's coordinates over the independent ones.
    pub g: Vec<T>,
    pub d: usize,
    /// For each independent coordinate, its index into the cluster's.
    pub independent: Vec<usize>,
    /// Columns of motion of the cluster's velocities, root axes at the contact point.
    pub s: Vec<Twist<T>>,
    /// Ψ, bodies × d.
    pub psi: Vec<Twist<T>>,
    /// U, then what the elimination leaves of it; d of them.
    pub u: Vec<Wrench<T>>,
    /// D, d × d: below the diagonal the factors of the elimination, on it the pivots.
    pub factor: Vec<T>,
    /// t, then what the elimination leaves of it.
    pub t: Vec<[T; K]>,
    /// The pivots that count, in their order.
    pub order: Vec<usize>,
    /// Those that do not: motions without mass.
    pub dropped: Vec<usize>,
    /// Whether each is still to be eliminated.
    pub open: Vec<bool>,
}

impl<T: Scalar, const K: usize> Default for ClusterElimination<T, K> {
    fn default() -> Self {
        Self {
            rates: Vec::new(),
            g: Vec::new(),
            d: 0,
            independent: Vec::new(),
            s: Vec::new(),
            psi: Vec::new(),
            u: Vec::new(),
            factor: Vec::new(),
            t: Vec::new(),
            order: Vec::new(),
            dropped: Vec::new(),
            open: Vec::new(),
        }
    }
}

impl<T: Scalar, const K: usize> ClusterElimination<T, K> {
    /// How many numbers it holds.
    pub fn numbers(&self) -> usize {
        self.g.capacity() + 6 * (self.s.capacity() + self.psi.capacity()) + 2 * self.factor.capacity()
    }
}

impl<const K: usize> JointElimination<f64, K> {
    pub fn is_positive(&self) -> bool {
        self.counts && self.d > 0.0
    }
}

impl<const K: usize> ClusterElimination<f64, K> {
    /// Whether all pivots count, and none is below zero.
    pub fn is_positive(&self) -> bool {
        self.dropped.is_empty() && self.order.iter().all(|y| self.factor[y * self.d + y] > 0.0)
    }
}
