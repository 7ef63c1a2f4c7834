//! m̄ of matrices and its stated error, compared with 96 digits.

use super::definition::Outcome;
use super::families::{NEGLIGIBLE, Tally, decades, rows_asked};
use super::linear_algebra::of_matrices;
use percuss_dynamics::{EffectiveMass, MatrixOptions, Remark, effective_mass};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// Matrices with condition numbers up to 1e12, masses and rows of A in units over twelve decades, and redundant rows.
#[test]
fn by_definition_matrices() {
    let (mut tally, mut massless, rows) = (Tally::default(), 0, rows_asked(2000));
    for seed in 0..rows as u64 {
        let rng = &mut StdRng::seed_from_u64(seed);
        let n = rng.random_range(1..9usize);
        let weak = decades(rng, -6.0, 0.0);
        let scales: Vec<f64> = (0..n).map(|_| decades(rng, -3.0, 3.0)).collect();
        let factor = nalgebra::DMatrix::from_fn(n, n, |r, c| {
            let strength = if r == 0 { weak } else { 1.0 };
            strength * rng.random_range(-1.0..1.0) * scales[c]
        });
        let product = factor.transpose() * &factor;
        let mass: Vec<Vec<f64>> =
            (0..n).map(|r| (0..n).map(|c| product[(r.min(c), r.max(c))]).collect()).collect();
        let row: Vec<f64> = (0..n).map(|_| rng.random_range(-1.0..1.0)).collect();
        let constraints: Vec<Vec<f64>> = (0..rng.random_range(0..n))
            .map(|_| {
                let unit = decades(rng, -6.0, 6.0);
                (0..n).map(|_| unit * rng.random_range(-1.0..1.0)).collect()
            })
            .collect();
        let Some(Outcome::Finite(truth)) = of_matrices(&mass, &row, &constraints) else { continue };
        let mut given = constraints.clone();
        if let Some(first) = constraints.first().filter(|_| rng.random_bool(0.3)) {
            given.push(first.iter().map(|x| 4.0 * x).collect());
        }
        let given = nalgebra::DMatrix::from_fn(given.len(), n, |r, c| given[r][c]);
        let matrix = nalgebra::DMatrix::from_fn(n, n, |r, c| mass[r][c]);
        let options = MatrixOptions::new().row_noise(0.0);
        let answer = effective_mass(&matrix, &row[..], Some((&given).into()), &options).expect("matrices");
        let name = || format!("matrices {seed}");
        tally.rows += 1;
        match (answer.effective_mass, answer.error) {
            (EffectiveMass::Finite(mass), Some(error)) => tally.take(name, (mass, error), truth),
            (EffectiveMass::Finite(_), None) => {}
            (EffectiveMass::Massless, _) => {
                let up_to = answer.remarks.iter().find_map(|r| match r {
                    Remark::MasslessToRounding { up_to } => Some(*up_to),
                    _ => None,
                });
                let greatest = matrix.diagonal().max();
                let most = up_to.unwrap_or(0.0).max(NEGLIGIBLE * greatest);
                assert!(
                    truth.to_f64() <= most,
                    "{}: massless, true {}, at most {most}",
                    name(),
                    truth.to_f64()
                );
                massless += 1;
            }
            (EffectiveMass::Immovable, _) => panic!("{}: immovable, true {}", name(), truth.to_f64()),
        }
    }
    let (stated, median) = (tally.stated, tally.median());
    println!(
        "matrices: {} rows, {stated} stated, {massless} massless, {} exceeded, true/stated at most {:.2}, median {median:.0}",
        tally.rows, tally.exceeded, tally.worst
    );
    assert!(tally.complaints.is_empty(), "{:?}", &tally.complaints[..tally.complaints.len().min(12)]);
    assert!(stated * 10 >= tally.rows * 9 && median <= 1e4, "{stated} of {}, median {median}", tally.rows);
}
