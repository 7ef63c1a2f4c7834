//! Rates of all coordinates over independent ones: G with A G = 0. The independent rows and the dependent coordinates
//! are chosen once, at several assembled configurations; expressions that the generated code compares with a limit
//! reveal a configuration where this choice fails.

use super::constraint_rows::Constraints;
use crate::error::GenerateError;
use crate::expression::graph::{Expr, Graph};

/// Largest rate of a dependent coordinate over an independent one, both scaled to displacements: the rounding of the
/// rates grows with this number.
const LARGEST_RATE: f64 = 1e5;
/// Smallest tolerance of the rows that were found redundant, relative to unit rates.
const REDUNDANT_ROW: f64 = 1e-9;
/// Factor between the residual of redundant rows at the samples and their tolerance.
const REDUNDANT_MARGIN: f64 = 100.0;
/// Residual of redundant rows at the samples above which the rank is unclear.
const UNCLEAR_ROW: f64 = 1e-4;
/// Score of a pivot, relative to the best, below which sparsity does not count.
const SPARSE_PIVOT: f64 = 0.2;
/// Smallest pivot, scaled to displacements and relative to the pivots at the samples: rounding amounts to 1e-10 of such a
/// pivot.
const LEAST_PIVOT: f64 = 1e-6;
/// Score below which a pivot counts as zero.
const ZERO_PIVOT: f64 = 1e-9;

/// Rates over the independent coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Rates {
    /// Coordinates that are independent, ascending.
    pub independent: Vec<usize>,
    /// Rate of every coordinate over every independent coordinate.
    pub rates: Vec<Vec<Expr>>,
    /// Newton step of every dependent coordinate: −A_d⁻¹ r.
    pub corrections: Vec<(usize, Expr)>,
    /// Σ of squares that is at most 1 where the choice of rows and coordinates is valid.
    pub violation: Expr,
    /// Smallest score of a pivot.
    pub score: f64,
}

/// Pivot of the elimination.
struct Pivot {
    row: usize,
    column: usize,
    inverse: Expr,
}

/// Eliminates the constraints. `fixed`: coordinates that have to be independent. `lengths`: displacement of every
/// coordinate at unit rate, m. `samples`: inputs of assembled configurations.
pub(crate) fn eliminate_rates(
    g: &mut Graph,
    constraints: &Constraints,
    rank: usize,
    fixed: &[bool],
    lengths: &[f64],
    samples: &[Vec<f64>],
) -> Result<Rates, GenerateError> {
    let n = lengths.len();
    // The last column is the residual.
    let mut matrix: Vec<Vec<Expr>> = constraints
        .rows
        .iter()
        .map(|row| row.entries.iter().copied().chain([row.residual]).collect())
        .collect();
    let mut free_rows: Vec<usize> = (0..matrix.len()).collect();
    let mut free_columns: Vec<usize> = (0..n).filter(|&c| !fixed[c]).collect();
    let mut pivots: Vec<Pivot> = Vec::new();
    let mut score: f64 = 1.0;
    while pivots.len() < rank {
        let values: Vec<Vec<f64>> = samples.iter().map(|q| g.evaluate(q)).collect();
        let (row, column, best) =
            choose_pivot(g, &matrix, &free_rows, &free_columns, lengths, &values).unwrap_or((0, 0, 0.0));
        if best.is_nan() || best <= ZERO_PIVOT {
            return Err(GenerateError::NoIndependentRows { rank, found: pivots.len() });
        }
        score = score.min(best);
        free_rows.retain(|&r| r != row);
        free_columns.retain(|&c| c != column);
        let one = g.one();
        let inverse = g.div(one, matrix[row][column]);
        for &other in &free_rows {
            if g.is_zero(matrix[other][column]) {
                continue;
            }
            let factor = g.mul(matrix[other][column], inverse);
            for c in (0..=n).filter(|&c| c != column) {
                let product = g.mul(factor, matrix[row][c]);
                matrix[other][c] = g.sub(matrix[other][c], product);
            }
            matrix[other][column] = g.zero();
        }
        pivots.push(Pivot { row, column, inverse });
    }
    let independent: Vec<usize> = (0..n).filter(|c| !pivots.iter().any(|p| p.column == *c)).collect();
    let zero = g.zero();
    let mut rates = vec![vec![zero; independent.len()]; n];
    let mut corrections = vec![zero; n];
    for (y, &c) in independent.iter().enumerate() {
        rates[c][y] = g.one();
    }
    for (number, pivot) in pivots.iter().enumerate().rev() {
        for y in 0..=independent.len() {
            let of = |c: usize| if y < independent.len() { rates[c][y] } else { corrections[c] };
            let known = independent.iter().copied().chain(pivots[number + 1..].iter().map(|p| p.column));
            let terms: Vec<(usize, Expr)> = known.map(|c| (c, of(c))).collect();
            let mut sum = if y < independent.len() { zero } else { matrix[pivot.row][n] };
            for (c, rate) in terms {
                let product = g.mul(matrix[pivot.row][c], rate);
                sum = g.add(sum, product);
            }
            let solved = g.mul(sum, pivot.inverse);
            let solved = g.neg(solved);
            if y < independent.len() {
                rates[pivot.column][y] = solved;
            } else {
                corrections[pivot.column] = solved;
            }
        }
    }
    let floors = pivot_floors(g, &pivots, lengths, samples);
    let violation = violation(g, constraints, &free_rows, &rates, &independent, lengths, samples)?;
    let violation = g.add(violation, floors);
    let corrections = pivots.iter().map(|p| (p.column, corrections[p.column])).collect();
    Ok(Rates { independent, rates, corrections, violation, score })
}

/// Σ (floor/pivot)², above 1 if a pivot is below its floor, a fraction of its smallest value at the samples. At a change
/// point a row vanishes apart from rounding, and the rates would be ratios of rounding errors.
fn pivot_floors(g: &mut Graph, pivots: &[Pivot], lengths: &[f64], samples: &[Vec<f64>]) -> Expr {
    let values: Vec<Vec<f64>> = samples.iter().map(|q| g.evaluate(q)).collect();
    let mut terms = Vec::new();
    for pivot in pivots {
        let largest = values.iter().map(|v| v[pivot.inverse.index()].abs()).fold(0.0, f64::max);
        let usual = (lengths[pivot.column] * largest).max(1.0);
        let scaled = g.scale(pivot.inverse, LEAST_PIVOT * lengths[pivot.column] / usual);
        // Constant pivots need no check.
        if g.value(scaled).is_none() {
            terms.push(g.square(scaled));
        }
    }
    g.sum(terms)
}

/// Pivot with the largest score, and the score: the smallest magnitude over the samples, relative to the largest entry
/// of the sample. Among good pivots the one with the fewest other entries in its row and column is chosen.
fn choose_pivot(
    g: &Graph,
    matrix: &[Vec<Expr>],
    rows: &[usize],
    columns: &[usize],
    lengths: &[f64],
    values: &[Vec<f64>],
) -> Option<(usize, usize, f64)> {
    let entry = |sample: &Vec<f64>, r: usize, c: usize| (sample[matrix[r][c].index()] / lengths[c]).abs();
    let largest: Vec<f64> = values
        .iter()
        .map(|sample| {
            let entries = rows.iter().flat_map(|&r| columns.iter().map(move |&c| (r, c)));
            entries.map(|(r, c)| entry(sample, r, c)).fold(f64::MIN_POSITIVE, f64::max)
        })
        .collect();
    let mut candidates = Vec::new();
    for &r in rows {
        for &c in columns.iter().filter(|&&c| !g.is_zero(matrix[r][c])) {
            let score = values
                .iter()
                .zip(&largest)
                .map(|(sample, largest)| entry(sample, r, c) / largest.max(1e-3))
                .fold(f64::INFINITY, f64::min);
            candidates.push((r, c, score));
        }
    }
    let best = candidates.iter().map(|c| c.2).fold(0.0, f64::max);
    let filled = |r: usize, c: usize| {
        let in_row = matrix[r].iter().filter(|e| !g.is_zero(**e)).count();
        let in_column = rows.iter().filter(|&&other| !g.is_zero(matrix[other][c])).count();
        (in_row - 1) * (in_column - 1)
    };
    candidates
        .into_iter()
        .filter(|(_, _, score)| *score >= SPARSE_PIVOT * best)
        .min_by(|a, b| filled(a.0, a.1).cmp(&filled(b.0, b.1)).then(b.2.total_cmp(&a.2)))
}

/// Sum of (rate/limit)² and, for redundant rows, (residual/tolerance)². Above 1, the chosen rows do not determine the
/// motion.
fn violation(
    g: &mut Graph,
    constraints: &Constraints,
    redundant: &[usize],
    rates: &[Vec<Expr>],
    independent: &[usize],
    lengths: &[f64],
    samples: &[Vec<f64>],
) -> Result<Expr, GenerateError> {
    let mut terms = Vec::new();
    for (c, row) in rates.iter().enumerate().filter(|(c, _)| !independent.contains(c)) {
        for (rate, &y) in row.iter().zip(independent) {
            let scaled = g.scale(*rate, lengths[c] / lengths[y] / LARGEST_RATE);
            terms.push(g.square(scaled));
        }
    }
    let mut left = Vec::new();
    for &row in redundant {
        for (y, &c) in independent.iter().enumerate() {
            let mut sum = g.zero();
            for (entry, rates) in constraints.rows[row].entries.iter().zip(rates) {
                let product = g.mul(*entry, rates[y]);
                sum = g.add(sum, product);
            }
            if !g.is_zero(sum) {
                left.push(g.scale(sum, 1.0 / lengths[c]));
            }
        }
    }
    let values: Vec<Vec<f64>> = samples.iter().map(|q| g.evaluate(q)).collect();
    let worst = values.iter().flat_map(|v| left.iter().map(|e| v[e.index()].abs())).fold(0.0, f64::max);
    if worst.is_nan() || worst >= UNCLEAR_ROW {
        return Err(GenerateError::UnclearRank { residual: worst });
    }
    let tolerance = (REDUNDANT_MARGIN * worst).max(REDUNDANT_ROW);
    for residual in left {
        let scaled = g.scale(residual, 1.0 / tolerance);
        terms.push(g.square(scaled));
    }
    Ok(g.sum(terms))
}
