//! m̄ from matrices of the caller: a family with a closed form and masses over many decades, compared with the stated
//! error; and results of poses from their own M, A and j.

use nalgebra::{DMatrix, DVector};
use percuss_dynamics::{
    EffectiveMass, MatrixError, MatrixName, MatrixOptions, MatrixResponse, MatrixView, RegularMatrices,
    Remark, effective_mass,
};
use percuss_tests::gauge::Gauge;
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::collections::BTreeMap;
use std::ops::AddAssign;

/// Bodies that slide on one line; the contact is on the last body. Some are geared to the last body, x_i = r_i x_n;
/// others are free.
struct Slides {
    masses: Vec<f64>,
    /// Gear ratio of each body except the last; `None` for a free body.
    ratios: Vec<Option<f64>>,
    /// True if the last body is held.
    is_held: bool,
    /// Positions of the bodies over the coordinates: x = B u, with integer entries.
    bodies: DMatrix<f64>,
    /// Combinations of the constraints, stated as additional rows.
    combined: DMatrix<f64>,
    /// Decades of the scales of the rows of A.
    row_decades: f64,
}

impl Slides {
    fn random(rng: &mut StdRng, decades: f64) -> Self {
        let n = rng.random_range(1..=9);
        let mass = |rng: &mut StdRng| match rng.random_range(0..8) {
            0 => 0.0,
            _ => 10f64.powf(rng.random_range(-decades / 2.0..=decades / 2.0)),
        };
        let ratios: Vec<Option<f64>> =
            (1..n).map(|_| rng.random_bool(0.5).then(|| f64::from(rng.random_range(-3..=3)) / 4.0)).collect();
        let is_held = rng.random_bool(0.1);
        let mut bodies = DMatrix::identity(n, n);
        // Products of shears: regular, integer, and each coordinate moves several bodies.
        for _ in 0..n {
            let (to, from) = (rng.random_range(0..n), rng.random_range(0..n));
            if to != from {
                let factor = f64::from(rng.random_range(-1..=1));
                let row = bodies.row(from) * factor;
                bodies.row_mut(to).add_assign(&row);
            }
        }
        let rows = ratios.iter().flatten().count() + usize::from(is_held);
        let more = if rows > 0 { rng.random_range(0..4) } else { 0 };
        let combined = DMatrix::from_fn(more, rows, |_, _| f64::from(rng.random_range(-2..=2)));
        let row_decades = if rng.random_bool(0.5) { 24.0 } else { 0.0 };
        let masses = (0..n).map(|_| mass(rng)).collect();
        Self { masses, ratios, is_held, bodies, combined, row_decades }
    }

    /// m̄ = m_n + Σ r_i² m_i over the geared bodies.
    fn exact(&self) -> EffectiveMass {
        if self.is_held {
            return EffectiveMass::Immovable;
        }
        let geared = self.ratios.iter().zip(&self.masses).filter_map(|(r, m)| Some(r.as_ref()?.powi(2) * m));
        let sum = self.masses.last().expect("a body") + geared.sum::<f64>();
        if sum > 0.0 { EffectiveMass::Finite(sum) } else { EffectiveMass::Massless }
    }

    fn rows(&self) -> DMatrix<f64> {
        let n = self.masses.len();
        let mut rows: Vec<DVector<f64>> = Vec::new();
        for (i, r) in self.ratios.iter().enumerate() {
            if let Some(r) = r {
                rows.push(DVector::from_fn(n, |k, _| {
                    f64::from(u8::from(k == i)) - if k == n - 1 { *r } else { 0.0 }
                }));
            }
        }
        if self.is_held {
            rows.push(DVector::from_fn(n, |k, _| f64::from(u8::from(k == n - 1))));
        }
        let first = DMatrix::from_fn(rows.len(), n, |r, c| rows[r][c]);
        let all = DMatrix::from_fn(rows.len() + self.combined.nrows(), n, |r, c| {
            if r < rows.len() { first[(r, c)] } else { (self.combined.row(r - rows.len()) * &first)[c] }
        });
        let mut all = all * &self.bodies;
        // Each row in its own unit.
        for (r, mut row) in all.row_iter_mut().enumerate() {
            row *= 10f64.powf(self.row_decades * ((0.618 * (r + 1) as f64).fract() - 0.5));
        }
        all
    }

    fn mass(&self) -> DMatrix<f64> {
        self.bodies.transpose()
            * DMatrix::from_diagonal(&DVector::from_vec(self.masses.clone()))
            * &self.bodies
    }

    fn ask(&self) -> MatrixResponse {
        let (mass, rows) = (self.mass(), self.rows());
        let row: Vec<f64> = self.bodies.row(self.masses.len() - 1).iter().copied().collect();
        // Entries of M are sums of some products; the other matrices are exact.
        let options = MatrixOptions::new().accuracy(16.0 * f64::EPSILON).row_noise(0.0);
        effective_mass(&mass, &row, Some((&rows).into()), &options).expect("matrices in order")
    }
}

#[test]
fn slides_over_many_decades_are_within_the_stated_error() {
    let mut rng = StdRng::seed_from_u64(2024);
    let mut stated = Gauge::new("error of slides, in units of what is stated");
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for number in 0..20_000 {
        let decades = f64::from(number % 19);
        let slides = Slides::random(&mut rng, decades);
        let (exact, got) = (slides.exact(), slides.ask());
        let name = || format!("slides {number}, masses {:?}, ratios {:?}", slides.masses, slides.ratios);
        let outcome = match (exact, got.effective_mass) {
            (EffectiveMass::Finite(m), EffectiveMass::Finite(found)) => match got.error {
                Some(error) => {
                    stated.note(&name(), (found - m).abs() / error, 1.0);
                    "finite"
                }
                // Depends on the last digit of an entry.
                None => "undetermined",
            },
            // A mass below the rounding of the other masses is lost in M itself, and the result must report this.
            (EffectiveMass::Finite(m), EffectiveMass::Massless) => {
                let up_to =
                    |r: &Remark| if let Remark::MasslessToRounding { up_to } = r { *up_to } else { 0.0 };
                let most = got.remarks.iter().map(up_to).fold(0.0, f64::max);
                // A mass below 1e-9 of the greatest mass is not reported, as for a pose.
                let greatest = slides.mass().diagonal().max();
                assert!(m <= most.max(1e-9 * greatest), "{}: {m} kg, said to be at most {most}", name());
                "lost in rounding"
            }
            (EffectiveMass::Immovable, EffectiveMass::Immovable) => "immovable",
            (EffectiveMass::Massless, EffectiveMass::Massless) => "massless",
            (exact, found) => panic!("{}: {found:?}, exactly {exact:?}", name()),
        };
        *counts.entry(outcome).or_default() += 1;
        let gears = slides.ratios.iter().flatten().count() + usize::from(slides.is_held);
        assert_eq!(got.rank.rank, gears, "{}", name());
        assert_eq!(got.rank.redundant_rows.len(), slides.combined.nrows(), "{}", name());
        assert_eq!(got.degrees_of_freedom, slides.masses.len() - gears, "{}", name());
        assert!(got.rank.is_clear, "{}: {:?}", name(), got.rank);
    }
    stated.report();
    println!("{counts:?}");
    assert!(counts.get("undetermined").is_none_or(|count| *count < 100), "{counts:?}");
    for outcome in ["finite", "lost in rounding", "immovable", "massless"] {
        assert!(counts.get(outcome).is_some_and(|count| *count > 20), "{outcome}: {counts:?}");
    }
}

/// The quick solution has the exact m̄ within its stated error, which is at most a hundred times that of the other solution. Only finite masses
/// have one.
#[test]
fn regular_slides_are_within_the_stated_error() {
    let mut rng = StdRng::seed_from_u64(2025);
    let (mut regular, mut solved) = (RegularMatrices::default(), 0);
    for number in 0..20_000 {
        let slides = Slides { row_decades: 0.0, ..Slides::random(&mut rng, f64::from(number % 13)) };
        let (mass, rows) = (slides.mass(), slides.rows());
        let row: Vec<f64> = slides.bodies.row(slides.masses.len() - 1).iter().copied().collect();
        let options = MatrixOptions::new().accuracy(16.0 * f64::EPSILON);
        let found = regular.solve(&(&mass).into(), &(&row).into(), Some(&(&rows).into()), &options);
        let Some((found, error)) = found else { continue };
        let name = format!("slides {number}, masses {:?}, ratios {:?}", slides.masses, slides.ratios);
        let EffectiveMass::Finite(exact) = slides.exact() else { panic!("{name}: {found} kg") };
        assert!((found - exact).abs() <= error, "{name}: {found} ± {error}, exactly {exact}");
        let other = effective_mass(&mass, &row, Some((&rows).into()), &options).expect("matrices in order");
        assert!(
            other.error.is_some_and(|other| error <= 100.0 * other),
            "{name}: {error}, {:?}",
            other.error
        );
        solved += 1;
    }
    println!("{solved} of 20000");
    assert!(solved > 1_000, "{solved} of 20000");
}

/// The matrix in another storage: column by column, row by row with gaps, or reversed.
struct Stored {
    values: Vec<f64>,
    shape: [usize; 2],
    how: usize,
}

impl Stored {
    const GAP: usize = 3;

    fn new(matrix: &DMatrix<f64>, how: usize) -> Self {
        let (rows, columns) = matrix.shape();
        let values = match how % 3 {
            0 => matrix.as_slice().to_vec(),
            1 => {
                let wide = matrix.transpose().resize_vertically(columns + Self::GAP, f64::NAN);
                wide.as_slice().to_vec()
            }
            _ => matrix.iter().rev().copied().collect(),
        };
        Self { values, shape: [rows, columns], how: how % 3 }
    }

    fn view(&self) -> MatrixView<'_> {
        let [rows, columns] = self.shape;
        let view = match self.how {
            0 => MatrixView::column_major(&self.values, rows, columns),
            1 => MatrixView::row_major_with(&self.values, rows, columns, columns + Self::GAP),
            _ => {
                let last = self.values.len().saturating_sub(1);
                MatrixView::strided(&self.values, last, self.shape, [-1, -(rows as isize)])
            }
        };
        view.expect("a layout that fits")
    }
}

fn outcome(mass: EffectiveMass) -> &'static str {
    match mass {
        EffectiveMass::Finite(_) => "finite",
        EffectiveMass::Immovable => "immovable",
        EffectiveMass::Massless => "massless",
    }
}

/// Comparison of a pose with its own matrices.
struct Poses {
    masses: Gauge,
    responses: Gauge,
    counts: BTreeMap<String, usize>,
}

impl Poses {
    fn compare(&mut self, number: usize, subject: &Subject) {
        let Subject { name, pose, contact, system, .. } = subject;
        let response = pose.respond(contact).expect("an answer");
        let (mass, rows) = (pose.mass_matrix(), pose.constraint_matrix());
        let row = pose.contact_row(&response.contact);
        let (mass, rows) = (Stored::new(&mass, number), Stored::new(&rows, number / 3));
        let size = subject.mechanism().characteristic_length();
        let turns = |(joint, component): &(Option<percuss_mechanism::JointId>, usize)| match joint {
            None => *component < 3,
            Some(id) => {
                use percuss_mechanism::JointKind::{
                    Continuous, Fixed, Floating, Planar, Prismatic, Revolute, Spherical,
                };
                match subject.mechanism().joint(*id).kind() {
                    Revolute | Continuous | Spherical => true,
                    Fixed | Prismatic => false,
                    Planar => *component == 2,
                    Floating => *component < 3,
                }
            }
        };
        let lengths: Vec<f64> =
            system.coordinate_joints().iter().map(|c| if turns(c) { size } else { 1.0 }).collect();
        // Entries are sums of many products, and positions are rounded.
        let options = MatrixOptions::new().accuracy(64.0 * f64::EPSILON);
        let asked = [options, options.lengths(&lengths)].map(|options| {
            effective_mass(mass.view(), &row, Some(rows.view()), &options)
                .unwrap_or_else(|error| panic!("{name}: {error}"))
        });
        for got in asked {
            let (here, there) = (outcome(got.effective_mass), outcome(response.effective_mass));
            let unclear = !pose.rank().clear || !got.rank.is_clear;
            if !unclear {
                assert_eq!(got.rank.rank, pose.rank().rank, "{name}: rank");
                assert_eq!(got.degrees_of_freedom, response.degrees_of_freedom, "{name}");
                assert_eq!(got.rank.redundant_rows.len(), rows.shape[0] - got.rank.rank, "{name}");
            }
            *self.counts.entry(if unclear { "unclear".into() } else { there.to_string() }).or_default() += 1;
            if unclear {
                continue;
            }
            assert_eq!(here, there, "{name}: {got:?}, {:?} {:?}", response.effective_mass, response.remarks);
            let EffectiveMass::Finite(m) = got.effective_mass else { continue };
            let EffectiveMass::Finite(expected) = response.effective_mass else { unreachable!() };
            let stated = got.error.expect("a finite answer states its error");
            // The closing error is part of the matrices too: both results refer to the same pose.
            let theirs = response.error.and_then(|e| e.rounding).expect("a pose states its rounding");
            self.masses.note(name, (m - expected).abs() / (stated + theirs), 1.0);
            let closing: f64 = got.velocity.iter().zip(&row).map(|(v, j)| v * j).sum();
            let terms: f64 = got.velocity.iter().zip(&row).map(|(v, j)| (v * j).abs()).sum();
            self.responses.note(name, (closing - 1.0).abs() / terms, 1e-9);
        }
    }
}

#[test]
fn poses_from_their_own_matrices() {
    let mut poses = Poses {
        masses: Gauge::new("matrices − pose, in units of what both state"),
        responses: Gauge::new("closing speed of v*"),
        counts: BTreeMap::new(),
    };
    let subjects = of_trees(16, 3, 120).into_iter().chain(of_linkages(800, 8));
    subjects.enumerate().for_each(|(number, subject)| poses.compare(number, &subject));
    poses.masses.report();
    poses.responses.report();
    println!("{:?}", poses.counts);
    for outcome in ["finite", "immovable", "massless"] {
        assert!(poses.counts.get(outcome).is_some_and(|count| *count > 10), "{outcome}: {:?}", poses.counts);
    }
}

/// Slides with every entry rounded to single precision: the stated accuracy decides the rank and bounds the error.
#[test]
fn slides_in_single_precision_are_within_the_stated_error() {
    let single = |matrix: &DMatrix<f64>| matrix.map(|x| f64::from(x as f32));
    let mut rng = StdRng::seed_from_u64(7);
    let mut stated = Gauge::new("error of slides in single precision, in units of what is stated");
    let (mut finite, mut immovable, mut unclear) = (0, 0, 0);
    for number in 0..4000 {
        let slides = Slides::random(&mut rng, f64::from(number % 6));
        let (mass, rows) = (single(&slides.mass()), single(&(slides.rows() / 3.0)));
        let row: Vec<f64> = slides.bodies.row(slides.masses.len() - 1).iter().copied().collect();
        let options = MatrixOptions::new().accuracy(0.5f64.powi(24)).row_noise(0.0);
        let got = effective_mass(&mass, &row, Some((&rows).into()), &options).expect("matrices in order");
        let name = || format!("slides {number}, masses {:?}, ratios {:?}", slides.masses, slides.ratios);
        let gears = slides.ratios.iter().flatten().count() + usize::from(slides.is_held);
        // Rows of 24 decades with seven digits: a dropped singular value may exceed the rounding.
        if !got.rank.is_clear {
            assert!(got.error.is_none(), "{}: {:?}", name(), got.rank);
            unclear += 1;
            continue;
        }
        assert_eq!(got.rank.rank, gears, "{}", name());
        match (slides.exact(), got.effective_mass, got.error) {
            (EffectiveMass::Finite(m), EffectiveMass::Finite(found), Some(error)) => {
                stated.note(&name(), (found - m).abs() / error, 1.0);
                finite += 1;
            }
            (EffectiveMass::Immovable, EffectiveMass::Immovable, _) => immovable += 1,
            (EffectiveMass::Finite(_) | EffectiveMass::Massless, EffectiveMass::Massless, _)
            | (EffectiveMass::Finite(_), EffectiveMass::Finite(_), None) => {}
            (exact, found, _) => panic!("{}: {found:?}, exactly {exact:?}", name()),
        }
    }
    stated.report();
    assert!(finite > 2000 && immovable > 100 && unclear < 400, "{finite} {immovable} {unclear}");
}

#[test]
fn the_unit_of_a_row_has_no_influence() {
    // The first body is geared to the second, the second to the third; the second gear is stated in small units.
    let mass = DMatrix::identity(3, 3);
    let ask = |scale: f64, options: &MatrixOptions<'_>| {
        let rows = DMatrix::from_row_slice(2, 3, &[1.0, -1.0, 0.0, 0.0, scale, -scale]);
        effective_mass(&mass, &[1.0, 0.0, 0.0][..], Some((&rows).into()), options).unwrap()
    };
    for decade in -90..=90 {
        let got = ask(10f64.powi(decade), &MatrixOptions::new().row_noise(0.0));
        let EffectiveMass::Finite(m) = got.effective_mass else { panic!("{got:?}") };
        assert!((m - 3.0).abs() <= got.error.unwrap() && got.rank.rank == 2, "1e{decade}: {got:?}");
        let is_small = got.rank.small_rows.len() == 1;
        assert_eq!(is_small, decade.abs() > 12, "1e{decade}: {:?}", got.rank);
    }
    // A row of rounding errors is no constraint.
    let rounding = ask(1e-17, &MatrixOptions::new());
    assert!(matches!(rounding.effective_mass, EffectiveMass::Finite(m) if (m - 2.0).abs() < 1e-14));
    assert_eq!((rounding.rank.rank, rounding.rank.redundant_rows), (1, vec![1]));
    // A dropped singular value above rounding is reported, and no error is stated.
    let near = DMatrix::from_row_slice(2, 3, &[1.0, -1.0, 0.0, 1.0, -1.0, 1e-11]);
    let got =
        effective_mass(&mass, &[1.0, 0.0, 0.0][..], Some((&near).into()), &MatrixOptions::new()).unwrap();
    assert!(!got.rank.is_clear && got.error.is_none(), "{got:?}");
}

/// A dependent row, with both rows rounded to single precision, adds no constraint by its rounding.
#[test]
fn the_accuracy_decides_the_rank() {
    let third = f64::from(1.0_f32 / 3.0);
    let rows = DMatrix::from_row_slice(2, 2, &[1.0, -3.0, third, -1.0]);
    let mass = DMatrix::from_diagonal(&DVector::from_vec(vec![2.0, 9.0]));
    let ask = |options: MatrixOptions<'_>| {
        effective_mass(&mass, &[1.0, 0.0][..], Some((&rows).into()), &options).unwrap()
    };
    assert_eq!(ask(MatrixOptions::new()).effective_mass, EffectiveMass::Immovable);
    for options in
        [MatrixOptions::new().accuracy(6e-8), MatrixOptions::new().accuracy_of(MatrixName::Constraints, 6e-8)]
    {
        let got = ask(options);
        let EffectiveMass::Finite(m) = got.effective_mass else { panic!("{got:?}") };
        let error = got.error.unwrap();
        assert!((m - 3.0).abs() <= error && error > 1e-8 && error < 1e-4, "{got:?}");
    }
}

#[test]
fn which_rows_are_redundant() {
    let mass = DMatrix::identity(4, 4);
    let ask = |rows: &[[f64; 4]]| {
        let rows = DMatrix::from_fn(rows.len(), 4, |r, c| rows[r][c]);
        effective_mass(&mass, &[1.0, 0.0, 0.0, 0.0][..], Some((&rows).into()), &MatrixOptions::new()).unwrap()
    };
    // x₀ = x₁ twice, scaled by a thousand, a row of zeros, and x₂ held.
    let got = ask(&[[1.0, -1.0, 0.0, 0.0], [-1e3, 1e3, 0.0, 0.0], [0.0; 4], [0.0, 0.0, 2.0, 0.0]]);
    assert_eq!((got.rank.rank, got.degrees_of_freedom), (2, 2));
    assert_eq!(got.rank.redundant_rows.len(), 2);
    assert!(got.rank.redundant_rows.contains(&2), "{:?}", got.rank);
    let mut sets = got.rank.dependent_sets.clone();
    sets.sort();
    assert_eq!(sets, [vec![0, 1], vec![2]]);
    assert!(matches!(got.effective_mass, EffectiveMass::Finite(m) if (m - 2.0).abs() <= got.error.unwrap()));
    // A nearly dependent row is classified by its size and reported as unclear; the caller sets the floor.
    let near = [[1.0, -1.0, 0.0, 0.0], [1.0, -1.0, 1e-10, 0.0]];
    assert!(!ask(&near).rank.is_clear);
    assert!(ask(&near).remarks.iter().any(|r| matches!(r, Remark::UnclearRank { .. })));
    let rows = DMatrix::from_fn(2, 4, |r, c| near[r][c]);
    for (floor, rank) in [(1e-8, 1), (1e-13, 2)] {
        let options = MatrixOptions::new().rank_floor(floor);
        let got = effective_mass(&mass, &[0.0, 0.0, 1.0, 0.0][..], Some((&rows).into()), &options).unwrap();
        assert_eq!((got.rank.rank, got.rank.is_clear), (rank, true), "{floor}");
        assert_eq!(got.effective_mass == EffectiveMass::Immovable, rank == 2, "{floor}");
    }
    // In micrometres instead of metres, the same row is far from zero; `lengths` states the unit.
    let micrometres = [[1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 1e-12, 0.0]];
    let rows = DMatrix::from_fn(2, 4, |r, c| micrometres[r][c]);
    for (lengths, rank) in [([1.0, 1.0, 1.0, 1.0], 1), ([1.0, 1.0, 1e-12, 1.0], 2)] {
        let options = MatrixOptions::new().lengths(&lengths);
        let got = effective_mass(&mass, &[0.0, 0.0, 1.0, 1.0][..], Some((&rows).into()), &options).unwrap();
        assert_eq!(got.rank.rank, rank);
    }
}

/// The error for invalid matrices.
fn refused(mass: &[&[f64]], row: &[f64], rows: &[&[f64]], options: &MatrixOptions<'_>) -> MatrixError {
    let dense = |rows: &[&[f64]], n: usize| DMatrix::from_fn(rows.len(), n, |r, c| rows[r][c]);
    let (mass, rows) = (dense(mass, mass[0].len()), dense(rows, rows.first().map_or(row.len(), |r| r.len())));
    effective_mass(&mass, row, Some((&rows).into()), options).expect_err("a refusal")
}

#[test]
fn invalid_matrices_are_refused() {
    let default = MatrixOptions::new();
    let unit: &[&[f64]] = &[&[1.0, 0.0], &[0.0, 1.0]];
    let row = [1.0, 0.0];
    let shape = |error: MatrixError| match error {
        MatrixError::Shape { matrix, .. } => matrix,
        other => panic!("{other}"),
    };
    assert_eq!(shape(refused(&[&[1.0, 0.0]], &row, &[], &default)), MatrixName::Mass);
    assert_eq!(shape(refused(unit, &row[..1], &[], &default)), MatrixName::ContactRow);
    assert_eq!(shape(refused(unit, &[1.0; 3], &[], &default)), MatrixName::ContactRow);
    assert_eq!(shape(refused(unit, &row, &[&[1.0]], &default)), MatrixName::Constraints);
    assert_eq!(shape(refused(unit, &row, &[&[1.0, 0.0, 0.0]], &default)), MatrixName::Constraints);
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e101] {
        let place = |error: MatrixError| match error {
            MatrixError::NotFinite { matrix, row, column, .. } => (matrix, row, column),
            other => panic!("{other}"),
        };
        let mass: &[&[f64]] = &[&[1.0, 0.0], &[bad, 1.0]];
        assert_eq!(place(refused(mass, &row, &[], &default)), (MatrixName::Mass, 1, 0));
        assert_eq!(place(refused(unit, &[0.0, bad], &[], &default)), (MatrixName::ContactRow, 0, 1));
        assert_eq!(
            place(refused(unit, &row, &[&[1.0, 1.0], &[bad, 0.0]], &default)),
            (MatrixName::Constraints, 1, 0)
        );
    }
    let upper: &[&[f64]] = &[&[1.0, 0.5], &[0.0, 1.0]];
    assert!(matches!(
        refused(upper, &row, &[], &default),
        MatrixError::NotSymmetric { row: 0, column: 1, is_triangle: true, .. }
    ));
    assert!(refused(upper, &row, &[], &default).to_string().contains("mirror"));
    let skew: &[&[f64]] = &[&[1.0, 0.5], &[0.4, 1.0]];
    assert!(matches!(
        refused(skew, &row, &[], &default),
        MatrixError::NotSymmetric { is_triangle: false, .. }
    ));
    let negative: &[&[f64]] = &[&[1.0, 0.0], &[0.0, -1e-9]];
    assert!(matches!(
        refused(negative, &row, &[], &default),
        MatrixError::NegativeDiagonal { coordinate: 1, .. }
    ));
    // Indefinite: by a pair, by a pair with zeros on the diagonal, by three coordinates without an indefinite pair.
    for pair in [[[1.0, 2.0], [2.0, 1.0]], [[0.0, 1.0], [1.0, 0.0]], [[4.0, 1e-3], [1e-3, 0.0]]] {
        let mass: &[&[f64]] = &[&pair[0], &pair[1]];
        assert!(matches!(refused(mass, &row, &[], &default), MatrixError::IndefinitePair { .. }), "{pair:?}");
    }
    let three: &[&[f64]] = &[&[1.0, 1.0, 1.0], &[1.0, 1.0, 0.5], &[1.0, 0.5, 1.0]];
    assert!(matches!(refused(three, &[1.0, 0.0, 0.0], &[], &default), MatrixError::Indefinite { .. }));
    // Options.
    for (options, option) in [
        (default.rank_floor(0.0), "floor"),
        (default.rank_floor(f64::NAN), "floor"),
        (default.rank_floor(0.2), "floor"),
        (default.accuracy(-1e-16), "accuracy"),
        (default.accuracy(f64::NAN), "accuracy"),
        (default.accuracy(0.1), "accuracy"),
        (default.accuracy_of(MatrixName::ContactRow, f64::NAN), "accuracy"),
        (default.row_noise(-1.0), "noise"),
        (default.row_noise(f64::NAN), "noise"),
        (default.lengths(&[1.0, 0.0]), "length"),
        (default.lengths(&[1.0, f64::NAN]), "length"),
    ] {
        match refused(unit, &row, &[], &options) {
            MatrixError::Option { option: found, .. } => assert!(found.contains(option), "{found}"),
            other => panic!("{other}"),
        }
    }
    assert!(matches!(
        refused(unit, &row, &[], &default.lengths(&[1.0])),
        MatrixError::LengthCount { got: 1, expected: 2 }
    ));
    let large = DMatrix::<f64>::identity(1001, 1001);
    let long = vec![1.0; 1001];
    assert!(matches!(effective_mass(&large, &long, None, &default), Err(MatrixError::TooLarge { .. })));
}

#[test]
fn small_and_empty_matrices() {
    let none = DMatrix::<f64>::zeros(0, 0);
    let empty: &[f64] = &[];
    let got = effective_mass(&none, empty, None, &MatrixOptions::new()).unwrap();
    assert_eq!((got.effective_mass, got.degrees_of_freedom), (EffectiveMass::Immovable, 0));
    // M that differs from its transpose by rounding: the mean is used.
    let mass = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0 + 1e-12, 2.0]);
    let got = effective_mass(&mass, &[1.0, 0.0][..], None, &MatrixOptions::new()).unwrap();
    let EffectiveMass::Finite(m) = got.effective_mass else { panic!("{got:?}") };
    assert!((m - 1.5).abs() <= got.error.unwrap() && got.error.unwrap() > 1e-13, "{got:?}");
    // The accuracy of the entries enters the stated error.
    let rough = effective_mass(&mass, &[1.0, 0.0][..], None, &MatrixOptions::new().accuracy(1e-6)).unwrap();
    assert!(rough.error.unwrap() > 1e-6 && rough.error.unwrap() < 1e-4, "{rough:?}");
    // Extreme units.
    for scale in [1e-90, 1e-30, 1e30, 1e90] {
        let mass = DMatrix::from_diagonal_element(2, 2, scale);
        let got = effective_mass(&mass, &[1.0, 1.0][..], None, &MatrixOptions::new()).unwrap();
        let EffectiveMass::Finite(m) = got.effective_mass else { panic!("{got:?}") };
        assert!((m / scale - 0.5).abs() < 1e-14);
    }
}
