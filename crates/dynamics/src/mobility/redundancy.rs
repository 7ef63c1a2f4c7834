//! Constraints (loops, couplings, held contacts) that contain redundant rows of A.

use crate::model::structure::partition::Partition;
use crate::tolerances::FAINT_COEFFICIENT;
use faer::Mat;
use faer::linalg::solvers::Solve;
use nalgebra::DMatrix;
use std::collections::BTreeMap;

/// Sets of names whose rows depend on one another. Names that cannot be separated form one set.
#[derive(Debug)]
pub(crate) struct Redundancy<N> {
    pub sets: Vec<Vec<N>>,
}

impl<N> Default for Redundancy<N> {
    fn default() -> Self {
        Self { sets: Vec::new() }
    }
}

impl<N: Clone + PartialEq> Redundancy<N> {
    /// Finds the dependencies among rows of the given rank. Each row has a name; columns are divided by `lengths`.
    ///
    /// Every row outside a basis is a combination of basis rows. Names that occur in one combination belong to one
    /// set. The sets are the connected components of the rows' matroid, for every choice of the basis (Oxley, Matroid
    /// Theory, 2011, §4.3). Components that share a name are merged.
    pub fn look_at(&mut self, rows: &DMatrix<f64>, lengths: &[f64], rank: usize, names: &[N]) {
        let (m, n) = rows.shape();
        if rank >= m {
            return;
        }
        let mut together = Partition::new(m);
        let mut redundant = vec![false; m];
        let transposed = Mat::from_fn(n, m, |c, r| rows[(r, c)] / lengths[c]);
        let qr = transposed.col_piv_qr();
        let (r, order) = (qr.R(), qr.P().arrays().0);
        let basis = Mat::from_fn(rank, rank, |i, k| if k >= i { r[(i, k)] } else { 0.0 });
        let dependent = Mat::from_fn(rank, m - rank, |i, k| r[(i, rank + k)]);
        let coefficients = if rank > 0 { basis.full_piv_lu().solve(&dependent) } else { dependent };
        for k in 0..m - rank {
            let row = order[rank + k];
            redundant[row] = true;
            let largest = (0..rank).map(|i| coefficients[(i, k)].abs()).fold(0.0, f64::max);
            for i in (0..rank).filter(|&i| coefficients[(i, k)].abs() > FAINT_COEFFICIENT * largest.max(1.0))
            {
                redundant[order[i]] = true;
                together.join(row, order[i]);
            }
        }
        // Rows of one name are adjacent; redundant rows of one name belong together.
        let mut before: Option<usize> = None;
        for row in (0..m).filter(|row| redundant[*row]) {
            if let Some(before) = before.filter(|before| names[*before] == names[row]) {
                together.join(before, row);
            }
            before = Some(row);
        }
        // The root of a set is its first row.
        let mut sets: BTreeMap<usize, Vec<N>> = BTreeMap::new();
        for row in (0..m).filter(|row| redundant[*row]) {
            let set = sets.entry(together.root(row)).or_default();
            if set.last() != Some(&names[row]) {
                set.push(names[row].clone());
            }
        }
        self.sets.extend(sets.into_values());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sets(rows: &[[f64; 3]], rank: usize, names: &[&str]) -> Vec<Vec<String>> {
        let mut redundancy = Redundancy::default();
        let matrix = DMatrix::from_fn(rows.len(), 3, |r, c| rows[r][c]);
        let names: Vec<String> = names.iter().map(|n| n.to_string()).collect();
        redundancy.look_at(&matrix, &[1.0; 3], rank, &names);
        redundancy.sets
    }

    #[test]
    fn separable_dependencies_are_told_apart() {
        let x = [1.0, 0.0, 0.0];
        let y = [0.0, 1.0, 0.0];
        let z = [0.0, 0.0, 1.0];
        assert_eq!(sets(&[x, x, y, y, z], 3, &["a", "a", "b", "b", "c"]), [vec!["a"], vec!["b"]]);
        assert_eq!(sets(&[x, y, [1.0, 1.0, 0.0], z], 3, &["a", "b", "c", "d"]), [vec!["a", "b", "c"]]);
        // b repeats a in x, and c repeats b in y: b connects both sets.
        assert_eq!(sets(&[x, x, y, y], 2, &["a", "b", "b", "c"]), [vec!["a", "b", "c"]]);
        assert_eq!(sets(&[x, [0.0; 3]], 1, &["a", "empty"]), [vec!["empty"]]);
        assert_eq!(sets(&[[0.0; 3], [0.0; 3]], 0, &["a", "b"]), [vec!["a"], vec!["b"]]);
        assert!(sets(&[x, y], 2, &["a", "b"]).is_empty());
    }
}
