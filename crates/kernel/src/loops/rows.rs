//! Rows of A, their elimination in the order of the plan, and the rates of the dependent coordinates.

use super::frames::{direction, fill_frames, joint_axis, point};
use super::layout::{FRAME, cross, dot, get, get_vector, minus, plus, size, store, times};
use super::plan::{Block, BlockRow, BlockTerm, LoopBody, LoopPlan};
use super::relations::{RelationValues, relation_values};
use crate::columns::PositionColumns;
use crate::mechanism::RowForm;
use crate::tolerances::{FAR_ROUNDINGS, OPEN_ROUNDINGS};
use percuss_spatial::lanes::{Lanes, Single};

/// Nonzero entries of A at the given positions, row by row.
pub(super) fn matrix_at(plan: &LoopPlan, positions: &[f64]) -> Vec<f64> {
    let mut scratch = vec![0.0; plan.layout.total];
    fill_frames::<Single>(plan, PositionColumns { values: positions, stride: 1 }, 0, &mut scratch);
    fill_rows::<Single, false>(plan, &mut scratch);
    scratch[plan.layout.entries..plan.layout.inverse_pivots].to_vec()
}

/// Quantities of the loops, computed with their rows.
#[derive(Clone, Copy)]
pub(super) struct LoopResiduals<T> {
    /// Largest residual of a row, m.
    pub residual: T,
    /// Errors of the entries of A from the residual and from short rods.
    pub roundings: RowRoundings<T>,
}

/// Errors of the entries of A, in roundings.
#[derive(Clone, Copy)]
pub(super) struct RowRoundings<T> {
    /// Error from short rods and from the slopes of curves.
    pub rods: T,
    /// Error from open loops. Divided by the pivots, the residual is also an error of the positions, and so of the
    /// entries.
    pub open: T,
}

/// Fills A; with `KEPT`, also stores the residual of each row (m).
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn fill_rows<T: Lanes, const KEPT: bool>(
    plan: &LoopPlan,
    scratch: &mut [f64],
) -> LoopResiduals<T> {
    for entry in &plan.filled_in {
        store(scratch, plan.layout.entries + entry, T::zero());
    }
    macro_rules! keep {
        ($row:expr, $residual:expr) => {
            if KEPT && let Some(own) = &$row {
                store(scratch, plan.layout.residuals + own.row, $residual);
            }
        };
    }
    let (mut open, mut rods) = (T::zero(), T::zero());
    let still = [T::zero(); 3];
    for block in &plan.blocks {
        let at: [T; 3] = point(scratch, &block.successor);
        let apart = match &block.predecessor {
            Some(place) => minus(&at, &point(scratch, place)),
            None => still,
        };
        for (form, rows) in &block.forms {
            match form {
                RowForm::Point => {
                    open = open.max(size(&apart));
                    keep!(rows[0], apart[0]);
                    keep!(rows[1], apart[1]);
                    keep!(rows[2], apart[2]);
                    add_point(plan, block, rows, &at, scratch);
                }
                RowForm::Along(e) => {
                    let force = direction(scratch, e);
                    let gap = dot(&apart, &force);
                    open = open.max(gap.abs());
                    keep!(rows[0], gap);
                    add_force_row(plan, block, &rows[0], &force, &at, scratch);
                }
                RowForm::Cosine(e, b, length) => {
                    let (e, b): ([T; 3], [T; 3]) = (direction(scratch, e), direction(scratch, b));
                    let length = T::from_f64(*length);
                    let gap = dot(&b, &e) * length;
                    open = open.max(gap.abs());
                    keep!(rows[0], gap);
                    add_moment_row(plan, block, &rows[0], &times(&cross(&b, &e), length), scratch);
                }
                RowForm::Orientation(own, other, length) => {
                    let length = T::from_f64(*length);
                    let own: [[T; 3]; 3] = [0, 1, 2].map(|k| direction(scratch, &own[k]));
                    let other: [[T; 3]; 3] = [0, 1, 2].map(|k| direction(scratch, &other[k]));
                    // Σ e × b is twice the sine of the angle times the axis.
                    let twice = plus(&cross(&own[0], &other[0]), &cross(&own[1], &other[1]));
                    let twice = plus(&twice, &cross(&own[2], &other[2]));
                    let half = length * T::from_f64(0.5);
                    let mut k = 0;
                    while k < 3 {
                        let gap = dot(&twice, &own[k]) * half;
                        open = open.max(gap.abs());
                        keep!(rows[k], gap);
                        add_moment_row(plan, block, &rows[k], &times(&own[k], length), scratch);
                        k += 1;
                    }
                    // Beyond a right angle the sine decreases again.
                    let cosine = dot(&own[0], &other[0]) + dot(&own[1], &other[1]) + dot(&own[2], &other[2]);
                    open = open.max(half * (T::one() - cosine));
                }
                RowForm::Distance(distance) => {
                    let square: T = dot(&apart, &apart);
                    let length = square.sqrt();
                    let gap = length - T::from_f64(*distance);
                    open = open.max(gap.abs());
                    keep!(rows[0], gap);
                    let over = T::one() / length;
                    rods = rods.max((size(&at) + size(&apart)) * over);
                    add_force_row(plan, block, &rows[0], &times(&apart, over), &at, scratch);
                }
                RowForm::Relation => {
                    let Some(row) = &rows[0] else { continue };
                    let values = block.relation.map(|number| relation_values::<T>(plan, number, scratch));
                    let gap = values.map_or(T::zero(), |values| values.residual);
                    open = open.max(gap.abs());
                    keep!(rows[0], gap);
                    for (term, entry) in block.terms.iter().zip(&row.entries) {
                        let to = plan.layout.entries + entry;
                        add_entry(term, to, T::one(), scratch);
                        if let Some(RelationValues { slope, rounding, .. }) = values {
                            let argument = T::from_f64(-term.argument);
                            store(scratch, to, argument.mul_add(slope, get(scratch, to)));
                            rods = rods.max(rounding * T::from_f64(term.argument.abs() / plan.scale));
                        }
                    }
                }
            }
        }
    }
    let of_open = open * T::from_f64(OPEN_ROUNDINGS / (f64::EPSILON * plan.length));
    LoopResiduals {
        residual: open,
        roundings: RowRoundings { rods: rods * T::from_f64(FAR_ROUNDINGS), open: of_open },
    }
}

/// Axis of the joint velocity of a term, and the vector from its body's origin to the point `at`; root axes.
#[cfg_attr(not(debug_assertions), inline(always))]
fn lever<T: Lanes>(term: &BlockTerm, bodies: &[LoopBody], at: &[T; 3], scratch: &[f64]) -> ([T; 3], [T; 3]) {
    let place: [T; 3] = get_vector(scratch, FRAME * term.body + 9);
    (joint_axis(bodies, term.body, term.component, scratch), minus(at, &place))
}

/// Entry before a term is added: zero for the first term.
#[cfg_attr(not(debug_assertions), inline(always))]
fn entry_before<T: Lanes>(term: &BlockTerm, entry: usize, scratch: &[f64]) -> T {
    if term.is_first { T::zero() } else { get(scratch, entry) }
}

/// Adds the three rows of the velocity of a point.
#[cfg_attr(not(debug_assertions), inline(always))]
fn add_point<T: Lanes>(
    plan: &LoopPlan,
    block: &Block,
    rows: &[Option<BlockRow>; 3],
    at: &[T; 3],
    scratch: &mut [f64],
) {
    for (number, term) in block.terms.iter().enumerate() {
        let (a, arm) = lever(term, &plan.bodies, at, scratch);
        let velocity = if term.slides { a } else { cross(&a, &arm) };
        let mut k = 0;
        while k < 3 {
            if let Some(row) = &rows[k] {
                let to = plan.layout.entries + row.entries[number];
                add_entry(term, to, velocity[k], scratch);
            }
            k += 1;
        }
    }
}

/// Adds one row of A: the power of a force at the point `at` (root axes) on the velocities of the block. Nothing is added if `row` is `None`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn add_force_row<T: Lanes>(
    plan: &LoopPlan,
    block: &Block,
    row: &Option<BlockRow>,
    force: &[T; 3],
    at: &[T; 3],
    scratch: &mut [f64],
) {
    let Some(row) = row else { return };
    for (term, entry) in block.terms.iter().zip(&row.entries) {
        let (a, arm) = lever(term, &plan.bodies, at, scratch);
        let power = if term.slides { dot(&a, force) } else { dot(&a, &cross(&arm, force)) };
        add_entry(term, plan.layout.entries + entry, power, scratch);
    }
}

/// Adds one row of A: the power of a moment (root axes) on the velocities of the block. Nothing is added if `row` is `None`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn add_moment_row<T: Lanes>(
    plan: &LoopPlan,
    block: &Block,
    row: &Option<BlockRow>,
    moment: &[T; 3],
    scratch: &mut [f64],
) {
    let Some(row) = row else { return };
    for (term, entry) in block.terms.iter().zip(&row.entries) {
        let a = joint_axis(&plan.bodies, term.body, term.component, scratch);
        let power = if term.slides { T::zero() } else { dot(&a, moment) };
        add_entry(term, plan.layout.entries + entry, power, scratch);
    }
}

/// Adds the power on the joint velocity of a term to an entry of A.
#[cfg_attr(not(debug_assertions), inline(always))]
fn add_entry<T: Lanes>(term: &BlockTerm, to: usize, power: T, scratch: &mut [f64]) {
    store(scratch, to, power.mul_add(T::from_f64(term.factor), entry_before(term, to, scratch)));
}

/// Eliminates the dependent coordinates in the order of the plan. The entries below the pivots are kept. Returns the
/// largest 1/|pivot|, or a larger value than any such quotient if a redundant row is not redundant here.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn eliminate<T: Lanes>(plan: &LoopPlan, scratch: &mut [f64]) -> T {
    let entries = plan.layout.entries;
    let mut least = T::zero();
    for (k, pivot) in plan.pivots.iter().enumerate() {
        let over = T::one() / get::<T>(scratch, entries + pivot.entry);
        least = least.max(over.abs());
        store(scratch, plan.layout.inverse_pivots + k, over);
        let mut changed = pivot.changed.iter();
        for (_, below) in &pivot.rows {
            let factor = -(get::<T>(scratch, entries + below) * over);
            for ((_, from), to) in pivot.columns.iter().zip(&mut changed) {
                let change: T = get(scratch, entries + from);
                store(scratch, entries + to, change.mul_add(factor, get(scratch, entries + to)));
            }
        }
    }
    let mut left = T::zero();
    for &entry in &plan.remainders {
        left = left.max(get::<T>(scratch, entries + entry).abs());
    }
    let excess = (left - T::from_f64(plan.redundant)).max(T::zero());
    excess.mul_add(T::from_f64(f64::MAX), least)
}

/// Factor of pivot row `k` that was added to a row in the elimination; `below`: entry of that row in the column of the pivot.
#[cfg_attr(not(debug_assertions), inline(always))]
fn factor<T: Lanes>(plan: &LoopPlan, k: usize, below: usize, scratch: &[f64]) -> T {
    let below: T = get(scratch, plan.layout.entries + below);
    -(below * get::<T>(scratch, plan.layout.inverse_pivots + k))
}

/// Newton steps of the dependent coordinates, m, after the elimination of A: A\[d\] δ = −r. Eliminates the residuals. Returns ‖δ‖.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn fill_steps<T: Lanes>(plan: &LoopPlan, scratch: &mut [f64]) -> T {
    let rank = plan.layout.count;
    for (k, pivot) in plan.pivots.iter().enumerate() {
        let own: T = get(scratch, plan.layout.residuals + k);
        for &(r, below) in &pivot.rows {
            let to = plan.layout.residuals + r;
            store(scratch, to, own.mul_add(factor(plan, k, below, scratch), get(scratch, to)));
        }
    }
    let mut square = T::zero();
    let mut k = rank;
    while k > 0 {
        k -= 1;
        let mut sum: T = get(scratch, plan.layout.residuals + k);
        for &(c, entry) in &plan.pivots[k].columns {
            if c < rank {
                let entry: T = get(scratch, plan.layout.entries + entry);
                sum = entry.mul_add(get(scratch, plan.layout.steps + c), sum);
            }
        }
        let step = -(sum * get::<T>(scratch, plan.layout.inverse_pivots + k));
        square = step.mul_add(step, square);
        store(scratch, plan.layout.steps + k, step);
    }
    square.sqrt()
}

/// Rates of all coordinates for unit rates of the independent coordinates.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn fill_rates<T: Lanes>(plan: &LoopPlan, scratch: &mut [f64]) {
    let (f, rank, rates) = (plan.freedoms, plan.layout.count, plan.layout.rates);
    let mut y = 0;
    while y < f {
        let mut free = 0;
        while free < f {
            let unit = if free == y { T::one() } else { T::zero() };
            store(scratch, rates + (rank + free) * f + y, unit);
            free += 1;
        }
        let mut k = rank;
        while k > 0 {
            k -= 1;
            if !plan.depends_on[k * f + y] {
                store(scratch, rates + k * f + y, T::zero());
                continue;
            }
            let mut sum = T::zero();
            for &(c, entry) in &plan.pivots[k].columns {
                if plan.depends_on[c * f + y] {
                    let entry: T = get(scratch, plan.layout.entries + entry);
                    sum = entry.mul_add(get(scratch, rates + c * f + y), sum);
                }
            }
            store(scratch, rates + k * f + y, -(sum * get::<T>(scratch, plan.layout.inverse_pivots + k)));
        }
        y += 1;
    }
}

/// Errors of the rates, per error of an entry of A: the sum of all rates divided by the smallest pivot (`least`: the largest
/// 1/|pivot|), or the errors propagated through the rows, whichever is smaller.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn fill_rate_errors<T: Lanes>(plan: &LoopPlan, least: T, scratch: &mut [f64]) {
    let (n, f, rank) = (plan.columns, plan.freedoms, plan.layout.count);
    let (rates, errors, growth) = (plan.layout.rates, plan.layout.rate_errors, plan.layout.growth);
    for row in 0..errors - growth {
        store(scratch, growth + row, T::one());
    }
    for (k, pivot) in plan.pivots.iter().enumerate() {
        let own: T = get(scratch, growth + k);
        for &(r, below) in &pivot.rows {
            let factor: T = factor(plan, k, below, scratch);
            store(scratch, growth + r, own.mul_add(factor.abs(), get(scratch, growth + r)));
        }
    }
    let mut y = 0;
    while y < f {
        let mut all = T::one();
        for k in 0..rank {
            all += get::<T>(scratch, rates + k * f + y).abs();
        }
        let most = all * least;
        for free in rank..n {
            store(scratch, errors + free * f + y, T::zero());
        }
        let mut k = rank;
        while k > 0 {
            k -= 1;
            let mut error = T::zero();
            if plan.depends_on[k * f + y] {
                let mut sum = get::<T>(scratch, rates + k * f + y).abs();
                for &(c, _) in &plan.pivots[k].columns {
                    if plan.depends_on[c * f + y] {
                        sum += get::<T>(scratch, rates + c * f + y).abs();
                    }
                }
                sum *= get::<T>(scratch, growth + k);
                for &(c, entry) in &plan.pivots[k].columns {
                    if c < rank {
                        let entry: T = get(scratch, plan.layout.entries + entry);
                        sum = entry.abs().mul_add(get(scratch, errors + c * f + y), sum);
                    }
                }
                let over: T = get(scratch, plan.layout.inverse_pivots + k);
                error = -(-(sum * over.abs())).max(-most);
            }
            store(scratch, errors + k * f + y, error);
        }
        y += 1;
    }
}
