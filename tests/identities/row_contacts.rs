//! A contact point and a normal for each configuration: every result equals that of a batch of this contact alone, bit for bit.

use nalgebra::Vector3;
use percuss_dynamics::{
    BatchAnswer, BatchContacts, BatchError, BatchPositions, BatchRows, Contact, ContactStatus, Direction,
    EffectiveMass, Frame, RowColumns,
};
use percuss_spatial::rotation_about;
use percuss_tests::answer::answers;
use percuss_tests::subjects::{Subject, of_linkages, of_trees};
use rand::{Rng, SeedableRng, rngs::StdRng};

const COUNT: usize = 13;

fn any(rng: &mut StdRng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0))
}

/// A result, with the bits of its numbers.
fn bits(answer: &BatchAnswer) -> (Option<u64>, Option<EffectiveMass>, Option<u64>) {
    match answer.mass {
        Some(EffectiveMass::Finite(m)) => (Some(m.to_bits()), None, answer.error.map(f64::to_bits)),
        other => (None, other, answer.error.map(f64::to_bits)),
    }
}

/// Trees and linkages, normals in each frame, on a tilted base; one third with one point or one normal for all rows.
#[test]
fn each_row_equals_a_batch_of_its_contact() {
    let mut rng = StdRng::seed_from_u64(11);
    let (mut rows, mut in_lanes) = (0, 0);
    let subjects = of_trees(24, 3, 21).into_iter().chain(of_linkages(44, 12));
    for (k, Subject { name, pose, contact, .. }) in subjects.enumerate() {
        let Direction::Along(_, frame) = contact.normal else { continue };
        let frame = [frame, Frame::World, Frame::Link][k % 3];
        let contact = contact.normal(Direction::Along(Vector3::x(), frame));
        let mut workspace = pose.assembly().workspace();
        let tilt = rotation_about(&any(&mut rng).normalize(), 1.0);
        workspace.set_base(&percuss_spatial::Transform::new(tilt, any(&mut rng))).expect("a rigid frame");
        let batch = workspace.batch(&contact).expect("a contact that fits");
        let mut given: [Vec<f64>; 2] =
            [0, 1].map(|_| (0..3 * COUNT).map(|_| rng.random_range(-1.0..1.0)).collect());
        if k % 3 == 1 {
            given[k % 2].truncate(3);
        }
        let contacts = BatchContacts { points: &given[0], normals: &given[1] };
        let width = pose.positions().len();
        let values = pose.positions().repeat(COUNT);
        let by_columns: Vec<f64> = pose.positions().iter().flat_map(|x| [*x; COUNT]).collect();
        for positions in [
            BatchPositions::Rows { values: &values, stride: width },
            BatchPositions::Columns { values: &by_columns, stride: COUNT },
        ] {
            let all = BatchRows { contacts: Some(contacts), ..positions.into() };
            let found = answers(&batch, all, COUNT, 5).expect("enough");
            for row in 0..COUNT {
                let of = |numbers: &[f64]| {
                    let first = if numbers.len() == 3 { 0 } else { 3 * row };
                    Vector3::from_column_slice(&numbers[first..first + 3])
                };
                let normal = Direction::Along(of(&given[1]), frame);
                let alone = Contact { point: of(&given[0]), normal, ..contact };
                let mut alone = workspace.batch(&alone).expect("a contact that fits");
                let expected = alone.effective_mass(pose.positions()).expect("positions");
                let found = found[row];
                assert_eq!(bits(&found), bits(&expected), "{name}, row {row}");
                assert_eq!(found.remarks, expected.remarks, "{name}, row {row}");
                rows += 1;
                in_lanes += usize::from(batch.has_lanes() && found.error.is_some());
            }
        }
        // The contact of the batch is as before.
        let one = BatchPositions::Rows { values: pose.positions(), stride: width };
        let found = answers(&batch, one, 1, 1).expect("enough");
        let mut fresh = workspace.batch(&contact).expect("a contact that fits");
        let expected = fresh.effective_mass(pose.positions()).expect("positions");
        assert_eq!(bits(&found[0]), bits(&expected), "{name}");
    }
    println!("{rows} rows, {in_lanes} of them in lanes");
    assert!(rows > 16_000 && in_lanes > 6_400, "{rows} rows, {in_lanes} in lanes");
}

#[test]
fn wrong_contacts_are_refused() {
    let subjects = of_trees(4, 1, 22);
    let Subject { pose, contact, .. } =
        subjects.iter().find(|s| matches!(s.contact.normal, Direction::Along(..))).expect("a fixed normal");
    let batch = pose.assembly().batch(contact).expect("a contact that fits");
    let values = pose.positions().repeat(2);
    let two = BatchPositions::Rows { values: &values, stride: pose.positions().len() };
    let ask = |positions: BatchPositions<'_>, points: &[f64], normals: &[f64], count: usize| {
        let contacts = Some(BatchContacts { points, normals });
        answers(&batch, BatchRows { contacts, ..positions.into() }, count, 1)
    };
    let x = [1.0, 0.0, 0.0];
    assert!(matches!(ask(two, &[0.0; 6], &[1.0; 5], 2), Err(BatchError::ContactCount { normals: 5, .. })));
    assert!(matches!(ask(two, &[0.0; 9], &x, 2), Err(BatchError::ContactCount { points: 9, .. })));
    let no_normal = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert!(matches!(ask(two, &x, &no_normal, 2), Err(BatchError::Contact { configuration: 1, .. })));
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let points = [0.0, 0.0, 0.0, 0.0, bad, 0.0];
        assert!(
            matches!(ask(two, &points, &x, 2), Err(BatchError::Contact { configuration: 1, .. })),
            "{bad}"
        );
    }
    assert!(ask(two, &[], &[], 0).is_ok());
}

/// Largest deviation of the lanes from the pose, relative to the largest entry: the agreement of m̄ that the kernel of derivatives
/// demands, and ten times as much for entries that are differences of larger ones.
const DERIVATIVES: f64 = 1e-8;

/// Largest deviation relative to the largest expected entry, or to `least` if this is larger.
fn deviation(found: &[f64], expected: &[f64], least: f64) -> f64 {
    let size = expected.iter().fold(least, |size, x| size.max(x.abs()));
    let off = found.iter().zip(expected).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    if size > 0.0 { off / size } else { off }
}

/// Gradients and inverse operational inertias of trees and linkages, with a contact for each row, against those of poses.
#[test]
fn gradients_and_inverse_inertias_are_those_of_the_pose() {
    let mut rng = StdRng::seed_from_u64(17);
    let (mut in_lanes, mut at_poses, mut worst) = (0, 0, 0.0_f64);
    for (k, Subject { name, pose, contact, .. }) in
        of_trees(29, 4, 30).into_iter().chain(of_linkages(48, 8)).enumerate()
    {
        let Direction::Along(_, frame) = contact.normal else { continue };
        let frame = [frame, Frame::World, Frame::Link][k % 3];
        let contact = contact.normal(Direction::Along(Vector3::x(), frame));
        let batch = pose.assembly().batch(&contact).expect("a contact that fits");
        let width = pose.positions().len();
        let values = pose.positions().repeat(COUNT);
        let positions = BatchPositions::Rows { values: &values, stride: width };
        let given: [Vec<f64>; 2] =
            [0, 1].map(|_| (0..3 * COUNT).map(|_| rng.random_range(-1.0..1.0)).collect());
        let contacts = BatchContacts { points: &given[0], normals: &given[1] };
        let n = batch.velocities();
        let (mut masses, mut errors) = ([f64::NAN; COUNT], [f64::NAN; COUNT]);
        let (mut gradients, mut inverses) = (vec![0.0; COUNT * n], vec![0.0; COUNT * 36]);
        let columns = RowColumns {
            masses: &mut masses,
            errors: &mut errors,
            statuses: &mut [ContactStatus::Finite; COUNT],
            remarks: None,
            gradients: Some(&mut gradients),
            inverse_inertias: Some(&mut inverses),
        };
        batch.run(BatchRows { contacts: Some(contacts), ..positions.into() }, columns, 4).expect("enough");
        for row in 0..COUNT {
            let of = |numbers: &[f64]| Vector3::from_column_slice(&numbers[3 * row..3 * row + 3]);
            let alone =
                Contact { point: of(&given[0]), normal: Direction::Along(of(&given[1]), frame), ..contact };
            let own = &gradients[n * row..n * (row + 1)];
            match pose.effective_mass_gradient(&alone) {
                Ok(Some(gradient)) => {
                    let expected: Vec<f64> = gradient.joints.concat();
                    // By symmetry a gradient may be a difference of equal terms of the size of m̄.
                    let off = deviation(own, &expected, gradient.effective_mass);
                    assert!(off <= DERIVATIVES, "{name}, row {row}: {off:e}: {own:?}, expected {expected:?}");
                    worst = worst.max(off);
                    *(if batch.has_derivative_lanes() { &mut in_lanes } else { &mut at_poses }) += 1;
                }
                _ => assert!(own.iter().all(|x| x.is_nan()), "{name}, row {row}: {own:?}"),
            }
            let located = pose.locate(&alone).expect("a contact");
            let own = &inverses[36 * row..36 * (row + 1)];
            match pose.inverse_operational_inertia(&located) {
                Ok(found) => {
                    let expected: Vec<f64> = (0..36).map(|k| found.matrix()[(k / 6, k % 6)]).collect();
                    let off = deviation(own, &expected, 0.0);
                    assert!(off <= DERIVATIVES, "{name}, row {row}: {off:e}: {own:?}, expected {expected:?}");
                    worst = worst.max(off);
                }
                Err(_) => assert!(own.iter().all(|x| x.is_nan()), "{name}, row {row}: {own:?}"),
            }
        }
    }
    println!("{in_lanes} rows in lanes, {at_poses} at poses, largest deviation {worst:e}");
    assert!(in_lanes > 500 && at_poses > 500, "{in_lanes} rows in lanes, {at_poses} at poses");
    let batch = zoo_batch();
    let columns = RowColumns {
        masses: &mut [0.0; 2],
        errors: &mut [0.0; 2],
        statuses: &mut [ContactStatus::Finite; 2],
        remarks: None,
        gradients: Some(&mut [0.0; 3]),
        inverse_inertias: None,
    };
    let positions = BatchPositions::Rows { values: &[0.0; 4], stride: 2 };
    let refused = batch.run(positions, columns, 2);
    assert!(
        matches!(refused, Err(BatchError::DerivativeCount { got: 3, configurations: 2, .. })),
        "{refused:?}"
    );
}

/// Derivatives of a subject of two hinges or more.
fn zoo_batch() -> percuss_dynamics::Batch {
    let subjects = of_trees(31, 1, 4);
    let found = subjects.iter().find_map(|s| s.pose.assembly().batch(&s.contact).ok());
    found.expect("a tree")
}
