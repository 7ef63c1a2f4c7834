//! Matrices in 96 digits: elimination, factorisation of M, and m̄.

use super::definition::Outcome;
use super::wide::Wide;

/// Pivot: its index, its value, and the factors of the remaining columns.
type Pivot = (usize, Wide, Vec<(usize, Wide)>);

/// M over the admissible motions, factorised.
#[derive(Default)]
pub struct MassMatrix {
    /// Powers of two that scale M to a diagonal of about 1.
    scales: Vec<i64>,
    /// Pivots in the order of elimination.
    pivots: Vec<Pivot>,
    /// Directions without mass.
    free: Vec<usize>,
}

/// m̄ for matrices M (n × n), j (n) and A (m × n, rows independent) as given. `None` if the elimination of A is not clear.
pub fn of_matrices(mass: &[Vec<f64>], row: &[f64], constraints: &[Vec<f64>]) -> Option<Outcome> {
    let wide = |row: &Vec<f64>| -> Vec<Wide> { row.iter().map(|x| Wide::new(*x)).collect() };
    // Multiples of a row by a power of two are exact.
    let unit = |row: &Vec<f64>| {
        let most = row.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        wide(row).into_iter().map(|x| x.shifted(-most.log2().floor() as i64)).collect()
    };
    let basis = eliminate(constraints.iter().map(unit).collect())?.kernel(row.len());
    let factors = MassMatrix::of(projected(mass.iter().map(wide).collect(), &basis));
    Some(factors.effective_mass(over_basis(&wide(&row.to_vec()), &basis)))
}

/// Rows of A after the elimination by complete pivoting.
pub struct Eliminated {
    pub rows: Vec<Vec<Wide>>,
    pub columns: Vec<usize>,
}

pub fn eliminate(mut rows: Vec<Vec<Wide>>) -> Option<Eliminated> {
    let mut columns: Vec<usize> = Vec::new();
    for k in 0..rows.len() {
        let open = (k..rows.len()).flat_map(|r| (0..rows[r].len()).map(move |c| (r, c)));
        let open = open.filter(|(_, c)| !columns.contains(c));
        let size = |(r, c): &(usize, usize)| rows[*r][*c].abs();
        let (r, c) = open.max_by(|a, b| size(a).partial_cmp(&size(b)).expect("numbers"))?;
        if rows[r][c].abs().to_f64() < 1e-9 {
            return None;
        }
        rows.swap(k, r);
        columns.push(c);
        let over = Wide::new(1.0) / rows[k][c];
        rows[k].iter_mut().for_each(|x| *x = *x * over);
        let pivot = rows[k].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(other, _)| *other != k) {
            let factor = row[c];
            row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= factor * *p);
        }
    }
    Some(Eliminated { rows, columns })
}

impl Eliminated {
    pub fn kernel(&self, n: usize) -> Vec<Vec<Wide>> {
        let free: Vec<usize> = (0..n).filter(|c| !self.columns.contains(c)).collect();
        let mut basis = vec![vec![Wide::ZERO; free.len()]; n];
        for (y, &c) in free.iter().enumerate() {
            basis[c][y] = Wide::new(1.0);
            for (row, &dependent) in self.rows.iter().zip(&self.columns) {
                basis[dependent][y] = -row[c];
            }
        }
        basis
    }
}

/// Solves rows[·][columns] x = right.
pub fn solve(rows: &[Vec<Wide>], columns: &[usize], right: &[Wide]) -> Option<Vec<Wide>> {
    let n = columns.len();
    let row = |(row, r): (&Vec<Wide>, &Wide)| columns.iter().map(|c| row[*c]).chain([*r]).collect();
    let mut square: Vec<Vec<Wide>> = rows.iter().zip(right).map(row).collect();
    for k in 0..n {
        let size = |r: &usize| square[*r][k].abs();
        let r = (k..n).max_by(|a, b| size(a).partial_cmp(&size(b)).expect("numbers"))?;
        if square[r][k].is_zero() {
            return None;
        }
        square.swap(k, r);
        let over = Wide::new(1.0) / square[k][k];
        square[k].iter_mut().for_each(|x| *x = *x * over);
        let pivot = square[k].clone();
        for (_, row) in square.iter_mut().enumerate().filter(|(other, _)| *other != k) {
            let factor = row[k];
            row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= factor * *p);
        }
    }
    Some(square.iter().map(|row| row[n]).collect())
}

/// Row over the coordinates of a basis.
pub fn over_basis(row: &[Wide], basis: &[Vec<Wide>]) -> Vec<Wide> {
    let count = basis.first().map_or(0, Vec::len);
    let sum = |y: usize| row.iter().zip(basis).fold(Wide::ZERO, |sum, (x, b)| sum + *x * b[y]);
    (0..count).map(sum).collect()
}

/// Bᵀ M B.
pub fn projected(mass: Vec<Vec<Wide>>, basis: &[Vec<Wide>]) -> Vec<Vec<Wide>> {
    let count = basis.first().map_or(0, Vec::len);
    let half: Vec<Vec<Wide>> = mass.iter().map(|row| over_basis(row, basis)).collect();
    (0..count)
        .map(|y| {
            let sum = |z: usize| half.iter().zip(basis).fold(Wide::ZERO, |sum, (h, b)| sum + b[y] * h[z]);
            (0..count).map(sum).collect()
        })
        .collect()
}

impl MassMatrix {
    pub fn of(mut mass: Vec<Vec<Wide>>) -> Self {
        let n = mass.len();
        let power = |x: Wide| if x.is_zero() { 0 } else { -(x.to_f64().log2() / 2.0) as i64 };
        let scales: Vec<i64> = (0..n).map(|k| power(mass[k][k])).collect();
        for r in 0..n {
            for c in 0..n {
                mass[r][c] = mass[r][c].shifted(scales[r] + scales[c]);
            }
        }
        let mut pivots = Vec::new();
        // Exact zeros leave a rounding of 1e-96, magnified by masses and levers.
        let zero = Wide::new(1e-66);
        let mut open: Vec<usize> = (0..n).collect();
        loop {
            let larger =
                |a: &&usize, b: &&usize| mass[**a][**a].partial_cmp(&mass[**b][**b]).expect("numbers");
            let Some(&pivot) = open.iter().max_by(larger).filter(|k| mass[**k][**k] > zero) else { break };
            open.retain(|k| *k != pivot);
            let (d, over) = (mass[pivot][pivot], Wide::new(1.0) / mass[pivot][pivot]);
            let factors: Vec<(usize, Wide)> = open.iter().map(|&k| (k, mass[k][pivot] * over)).collect();
            for (r, factor) in &factors {
                for &c in &open {
                    let change = *factor * mass[pivot][c];
                    mass[*r][c] -= change;
                }
            }
            pivots.push((pivot, d, factors));
        }
        Self { scales, pivots, free: open }
    }

    pub fn effective_mass(&self, row: Vec<Wide>) -> Outcome {
        let mut t: Vec<Wide> = row.iter().zip(&self.scales).map(|(x, scale)| x.shifted(*scale)).collect();
        let size = t.iter().fold(Wide::ZERO, |sum, x| sum + *x * *x);
        let mut response = Wide::ZERO;
        for (pivot, d, factors) in &self.pivots {
            response += t[*pivot] * t[*pivot] / *d;
            for (k, factor) in factors {
                let change = *factor * t[*pivot];
                t[*k] -= change;
            }
        }
        let left = self.free.iter().fold(Wide::ZERO, |sum, k| sum + t[*k] * t[*k]);
        if left > size * Wide::new(1e-60) {
            Outcome::Massless
        } else if response < Wide::new(1e-100) {
            Outcome::Immovable
        } else {
            Outcome::Finite(Wide::new(1.0) / response)
        }
    }
}
