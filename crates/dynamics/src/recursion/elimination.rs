//! Stored eliminations of the recursion.

use crate::mobility::Rates;
use crate::model::Model;
use percuss_spatial::{Twist, Wrench};

/// Workspace for the motion computed from the recursion; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct RecursionMotion {
    /// Velocities of the tree.
    pub velocities: Vec<f64>,
    /// Twists of the bodies, root axes at the contact point.
    pub twists: Vec<Twist<f64>>,
    /// Rates of the independent coordinates of the current cluster.
    pub(super) rates: Vec<f64>,
}

impl RecursionMotion {
    /// Zero motion, with buffers of the size of the model.
    pub fn new(model: &Model) -> Self {
        Self {
            velocities: vec![0.0; model.velocity_coordinates.len()],
            twists: vec![Twist::zero(); model.bodies.len()],
            rates: Vec::new(),
        }
    }
}

/// Stored elimination of one velocity.
#[derive(Clone, Debug)]
pub(crate) struct JointElimination<const K: usize> {
    /// Motion column in root axes at the contact point.
    pub s: Twist<f64>,
    /// U = Iᴬ s.
    pub u: Wrench<f64>,
    /// D = sᵀ Iᴬ s + armature.
    pub d: f64,
    /// sᵀ f for every test wrench.
    pub t: [f64; K],
    /// True if the pivot counts; otherwise the motion is massless.
    pub counts: bool,
}

impl<const K: usize> JointElimination<K> {
    pub fn zero() -> Self {
        Self { s: Twist::zero(), u: Wrench::zero(), d: 0.0, t: [0.0; K], counts: false }
    }
}

/// Stored elimination of one bound cluster; `d` is the number of its independent coordinates.
#[derive(Clone, Debug, Default)]
pub(crate) struct ClusterElimination<const K: usize> {
    pub(super) rates: Vec<Rates>,
    /// G, coordinates × d, row by row: rates of the cluster's coordinates per rate of the independent ones.
    pub g: Vec<f64>,
    pub d: usize,
    /// For each independent coordinate, its index into the cluster's.
    pub independent: Vec<usize>,
    /// Motion columns of the cluster's velocities, root axes at the contact point.
    pub s: Vec<Twist<f64>>,
    /// Ψ, bodies × d.
    pub psi: Vec<Twist<f64>>,
    /// U, reduced by the elimination; d wrenches.
    pub u: Vec<Wrench<f64>>,
    /// D, d × d: factors of the elimination below the diagonal, pivots on the diagonal.
    pub factor: Vec<f64>,
    /// t, reduced by the elimination.
    pub t: Vec<[f64; K]>,
    /// Pivots that count, in the order of elimination.
    pub order: Vec<usize>,
    /// Dropped pivots: massless motions.
    pub dropped: Vec<usize>,
    /// True for coordinates not yet eliminated.
    pub open: Vec<bool>,
}

impl<const K: usize> ClusterElimination<K> {
    /// Number of stored numbers.
    pub fn stored_count(&self) -> usize {
        self.g.capacity() + 6 * (self.s.capacity() + self.psi.capacity()) + 2 * self.factor.capacity()
    }
}

impl<const K: usize> JointElimination<K> {
    pub fn is_positive(&self) -> bool {
        self.counts && self.d > 0.0
    }
}

impl<const K: usize> ClusterElimination<K> {
    /// True if all pivots count and none is negative.
    pub fn is_positive(&self) -> bool {
        self.dropped.is_empty() && self.order.iter().all(|y| self.factor[y * self.d + y] > 0.0)
    }
}
