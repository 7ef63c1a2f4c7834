//! Stored eliminations of the recursion.

use crate::mobility::Rates;
use crate::model::Model;
use percuss_spatial::{Scalar, Twist, Wrench};

/// Workspace for the motion computed from the recursion; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct RecursionMotion<T: Scalar> {
    /// Velocities of the tree.
    pub velocities: Vec<T>,
    /// Twists of the bodies, root axes at the contact point.
    pub twists: Vec<Twist<T>>,
    /// Rates of the independent coordinates of the current cluster.
    pub(super) rates: Vec<T>,
}

impl<T: Scalar> RecursionMotion<T> {
    /// Zero motion, with buffers of the size of the model.
    pub fn new(model: &Model) -> Self {
        Self {
            velocities: vec![T::zero(); model.velocity_coordinates.len()],
            twists: vec![Twist::zero(); model.bodies.len()],
            rates: Vec::new(),
        }
    }
}

/// Stored elimination of one velocity.
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
    /// True if the pivot counts; otherwise the motion is massless.
    pub counts: bool,
}

impl<T: Scalar, const K: usize> JointElimination<T, K> {
    pub fn zero() -> Self {
        Self { s: Twist::zero(), u: Wrench::zero(), d: T::zero(), t: [T::zero(); K], counts: false }
    }
}

/// Stored elimination of one bound cluster; `d` is the number of its independent coordinates.
#[derive(Clone, Debug)]
pub(crate) struct ClusterElimination<T: Scalar, const K: usize> {
    pub(super) rates: Vec<Rates<T>>,
    /// G, coordinates × d, row by row: rates of the cluster's coordinates per rate of the independent ones.
    pub g: Vec<T>,
    pub d: usize,
    /// For each independent coordinate, its index into the cluster's.
    pub independent: Vec<usize>,
    /// Motion columns of the cluster's velocities, root axes at the contact point.
    pub s: Vec<Twist<T>>,
    /// Ψ, bodies × d.
    pub psi: Vec<Twist<T>>,
    /// U, reduced by the elimination; d wrenches.
    pub u: Vec<Wrench<T>>,
    /// D, d × d: factors of the elimination below the diagonal, pivots on the diagonal.
    pub factor: Vec<T>,
    /// t, reduced by the elimination.
    pub t: Vec<[T; K]>,
    /// Pivots that count, in the order of elimination.
    pub order: Vec<usize>,
    /// Dropped pivots: massless motions.
    pub dropped: Vec<usize>,
    /// True for coordinates not yet eliminated.
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
    /// Number of stored numbers.
    pub fn stored_count(&self) -> usize {
        self.g.capacity() + 6 * (self.s.capacity() + self.psi.capacity()) + 2 * self.factor.capacity()
    }
}

impl<const K: usize> JointElimination<f64, K> {
    pub fn is_positive(&self) -> bool {
        self.counts && self.d > 0.0
    }
}

impl<const K: usize> ClusterElimination<f64, K> {
    /// True if all pivots count and none is negative.
    pub fn is_positive(&self) -> bool {
        self.dropped.is_empty() && self.order.iter().all(|y| self.factor[y * self.d + y] > 0.0)
    }
}
