//! Relations of couplings: slopes of their curves, and residuals.

use super::layout::{RELATION, get, store};
use super::plan::LoopPlan;
use crate::columns::PositionColumns;
use percuss_spatial::lanes::Lanes;

/// Values of a relation at a configuration.
#[derive(Clone, Copy)]
pub(super) struct RelationValues<T> {
    /// Σ k cₖ sᵏ⁻¹: derivative of the curve by its argument.
    pub slope: T,
    /// Σ factor · q − constant − Σ cₖ sᵏ, m.
    pub residual: T,
    /// Error of the slope, in roundings: Σ k² |cₖ| Sᵏ⁻¹ with S the sum of the magnitudes of the terms of s.
    pub rounding: T,
}

/// Stores the values of the relations.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn fill_relations<T: Lanes>(
    plan: &LoopPlan,
    columns: PositionColumns<'_>,
    first: usize,
    scratch: &mut [f64],
) {
    let of = T::from_f64;
    for (number, relation) in plan.relations.iter().enumerate() {
        let (mut sum, mut s) = (of(-relation.constant), of(relation.offset));
        let mut size = s.abs();
        for joint in &relation.joints {
            let q: T = columns.at(joint.q, first);
            sum = q.mul_add(of(joint.factor), sum);
            let part = q * of(joint.argument);
            s += part;
            size += part.abs();
        }
        let [c2, c3, c4] = relation.curve;
        let slope = s * s.mul_add(s.mul_add(of(4.0 * c4), of(3.0 * c3)), of(2.0 * c2));
        let curve = s * s * s.mul_add(s.mul_add(of(c4), of(c3)), of(c2));
        let [c2, c3, c4] = [c2, c3, c4].map(f64::abs);
        let rounding = size * size.mul_add(size.mul_add(of(16.0 * c4), of(9.0 * c3)), of(4.0 * c2));
        let at = plan.layout.relations + RELATION * number;
        store(scratch, at, slope);
        store(scratch, at + 1, (sum - curve) * of(relation.length));
        store(scratch, at + 2, rounding);
    }
}

/// Values of relation `number`, after [`fill_relations`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn relation_values<T: Lanes>(
    plan: &LoopPlan,
    number: usize,
    scratch: &[f64],
) -> RelationValues<T> {
    let at = plan.layout.relations + RELATION * number;
    RelationValues { slope: get(scratch, at), residual: get(scratch, at + 1), rounding: get(scratch, at + 2) }
}
