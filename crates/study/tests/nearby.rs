//! Rates of m̄ by hardpoints along random directions: those of an explanation, which follow from designs near the pose without an assembly,
//! are the fourth-order differences of complete evaluations with new assemblies, paths and responses.

use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_study::{Changes, MassQuestion, Model, PoseTable, explain, mass};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// Step of all hardpoints together, m. With parts of 10 mm, truncation is (5e-5/0.01)⁴ = 6e-10; poses are accurate to 1e-12 of 1 m, which
/// gives 1e-12/5e-5 = 2e-8.
const STEP: f64 = 5e-5;
/// Largest difference, relative to the sum of the magnitudes of all rates.
const AGREEMENT: f64 = 1e-6;
/// Largest stated error of a rate, relative to the largest rate; the differences of complete evaluations reach 1e-6.
const STATED: f64 = 1e-7;

/// Sheets with contacts: stops at the touch, seats at a travel, the moving contact point of a wheel, and an axle with both stops.
const QUESTIONS: [(&str, &str, &[&str]); 10] = [
    ("double-wishbone", "bump_stop", &[]),
    ("double-wishbone-rods", "spring", &["wheel-travel=25mm"]),
    ("five-link", "rebound_stop", &[]),
    ("macpherson-strut", "contact_patch", &["wheel-travel=-20mm"]),
    ("multi-link", "damper", &[]),
    ("pushrod-rocker", "bump_stop", &[]),
    ("twist-beam", "rebound_stop", &[]),
    ("solid-axle-watt", "bump_stop_left", &[]),
    ("solid-axle-panhard", "spring_left", &["heave=15mm", "roll=10mm"]),
    ("solid-axle-leaf-springs", "contact_patch_right", &[]),
];

#[test]
fn rates_are_those_of_complete_evaluations() {
    let mut random = StdRng::seed_from_u64(51);
    for (sheet, contact, travels) in QUESTIONS {
        let path = format!("{}/../../models/suspensions/{sheet}.toml", env!("CARGO_MANIFEST_DIR"));
        let model = Model::load(&path, DEFAULT_MAX_SIZE, &LoadOptions::default()).expect(sheet);
        // Another design in each question, so that no symmetry of a sheet hides a term.
        let moves = |step: f64, random: &mut StdRng| -> Vec<(String, [f64; 3])> {
            let points = model.hardpoints().iter();
            points
                .map(|point| (point.clone(), [(); 3].map(|()| step * random.random_range(-1.0..1.0))))
                .collect()
        };
        let design = Changes { moves: moves(2e-3, &mut random), ..Changes::default() };
        let design = model.with_changes(&design).expect(sheet);
        let travel = travels.iter().map(|travel| travel.parse().expect(travel)).collect();
        let pose = PoseTable { travel, ..PoseTable::default() };
        let question = MassQuestion { pose, ..MassQuestion::default().at_contact(contact) };
        let explained = explain(&design, &question).expect(sheet).expect(sheet);
        let along = moves(1.0, &mut random);
        let at = |step: f64| {
            let moves = along.iter().map(|(name, by)| (name.clone(), by.map(|by| step * by))).collect();
            let moved = design.with_changes(&Changes { moves, ..Changes::default() }).expect(sheet);
            mass(&moved, &question).expect(sheet).effective_mass.expect(sheet)
        };
        let (one, two) = (at(STEP) - at(-STEP), at(2.0 * STEP) - at(-2.0 * STEP));
        let expected = (8.0 * one - two) / (12.0 * STEP);
        let (mut rate, mut size, mut largest, mut stated) = (0.0, 0.0, 0.0f64, 0.0f64);
        for (point, (name, by)) in explained.points.iter().zip(&along) {
            assert_eq!(&point.point, name);
            for (own, by) in point.per_metre.expect(name).into_iter().zip(by) {
                rate += own * by;
                size += (own * by).abs();
                largest = largest.max(own.abs());
            }
            stated = stated.max(point.per_metre_error.expect(name));
        }
        assert!((rate - expected).abs() <= AGREEMENT * size, "{sheet}, {contact}: {rate} {expected} {size}");
        assert!(stated <= STATED * largest, "{sheet}: {stated} {largest}");
    }
}
