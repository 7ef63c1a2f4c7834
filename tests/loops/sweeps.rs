//! Every linkage through its whole range in a thousand steps, and the error stated with a result.

use percuss_dynamics::{EffectiveMass, Pose};
use percuss_oracle::closed_form::{Crossing, FourBar, planar_effective_mass};
use percuss_oracle::linkage::{self, Linkage};
use percuss_oracle::maximal::{self, Outcome};
use percuss_oracle::random;
use percuss_tests::gauge::Gauge;
use percuss_tests::rig::{Rig, in_plane, mass, positions, question};
use rand::{SeedableRng, rngs::StdRng};

#[test]
fn a_thousand_steps() {
    let mut open = Gauge::new("open loops along sweeps, parts of the size");
    for linkage in linkage::all() {
        let rig = Rig::new(linkage);
        // First to the start of the range: some corners are out of reach from other poses.
        let mut pose = rig.closed();
        let first = pose.clone();
        let mut last: Option<Pose> = None;
        for i in 0..=1000 {
            let part = f64::from(i) / 1000.0;
            pose = rig.reach(if i == 0 { &first } else { &pose }, &rig.at(part));
            let state = pose.loops().expect("loops");
            let own = state.residual / rig.mechanism.characteristic_length();
            let case = format!("{} at {part}", rig.name);
            open.note(&case, own, 1e-12);
            open.note(&case, rig.open(&pose), 2e-12);
            assert_eq!(state.inexactness, 0.0, "{case}");
            // No jump: another assembly would have distant positions.
            if let Some(last) = &last {
                let jump = pose.positions().iter().zip(last.positions()).map(|(a, b)| (a - b).abs());
                assert!(jump.fold(0.0, f64::max) < 0.1, "{case}");
            }
            last = Some(pose.clone());
        }
    }
    open.report();
}

/// A pose closed by the oracle from some distance, with a tenth of the tolerance, has the same mass within the
/// response's error.
#[test]
fn the_error_bounds_what_another_closing_gives() {
    let mut gauge = Gauge::new("deviation from another closing, in units of the error stated");
    let mut masses = Gauge::new("deviation from another closing");
    let mut largest = 0.0f64;
    for (linkage, oracle) in linkage::all().into_iter().zip(linkage::all()) {
        if linkage.mechanism.links().len() > 20 {
            continue;
        }
        let rig = Rig::new(linkage);
        let mut rng = StdRng::seed_from_u64(77);
        let mut pose = rig.closed();
        for i in 0..12 {
            pose = rig.reach(&pose, &rig.at((f64::from(i) + 0.5) / 12.0));
            let mut off = positions(&rig.mechanism, &pose);
            for id in oracle.dependent() {
                off[id.index()].iter_mut().enumerate().for_each(|(k, q)| *q += 1e-4 * (k as f64 + 0.7));
                if off[id.index()].len() == 4 {
                    let norm = off[id.index()].iter().map(|x| x * x).sum::<f64>().sqrt();
                    off[id.index()].iter_mut().for_each(|x| *x /= norm);
                }
            }
            let closed =
                maximal::close(&rig.mechanism, &off, &oracle.dependent()).expect("near a closed pose");
            for _ in 0..3 {
                let (on, against, point, normal) = random::contact(&mut rng, &rig.mechanism);
                let mut contact = rig.contact(rig.mechanism.link(on).name(), point.into(), normal);
                contact.against = against;
                let response = rig.respond(&pose, &contact);
                let mut asked = question(&rig.system, &rig.mechanism, &pose, &contact);
                asked.positions.clone_from(&closed);
                match (response.effective_mass, maximal::effective_mass(&asked)) {
                    (EffectiveMass::Finite(a), Outcome::Finite(c)) => {
                        let stated = response.effective_mass_error();
                        let stated =
                            stated.unwrap_or_else(|| panic!("{} {i}: {:?}", rig.name, response.error)) / a;
                        // A free spin may have another angle; route C has its own rounding error.
                        gauge.note(&format!("{} {i}", rig.name), (a / c - 1.0).abs() / (stated + 2e-12), 1.0);
                        masses.relative(rig.name, a, c, 1e-10);
                        largest = largest.max(stated);
                    }
                    (EffectiveMass::Immovable, Outcome::Immovable)
                    | (EffectiveMass::Massless, Outcome::Massless) => {}
                    (a, c) => panic!("{}: {a:?} {c:?}", rig.name),
                }
            }
        }
    }
    println!("largest error stated: {largest:e}");
    gauge.report();
    masses.report();
    assert!(largest < 1e-8, "{largest:e}");
}

/// Near a change point and near a dead centre digits are lost; the stated error covers the loss, and is not much
/// larger.
#[test]
fn the_error_is_stated_near_singular_poses() {
    let mut gauge = Gauge::new("deviation near singular poses, in units of the error stated");
    let mut masses = Gauge::new("deviation near singular poses, in units of ε over the distance");
    let mut vague = Gauge::new("stated errors near singular poses");
    let (point, n) = ([0.31, -0.12].into(), [0.6, 0.8].into());
    let bodies = linkage::FOUR_BAR_BODIES;
    let mut check = |linkage: Linkage, bar: FourBar, crossing: Crossing, singular: f64, power: f64| {
        let rig = Rig::new(linkage);
        let contact = rig.contact("coupler", [0.31, -0.12, 0.0], in_plane(n));
        let mut pose = rig.closed();
        for k in 0..=60 {
            let distance = 10f64.powf(-0.5 - f64::from(k) / 10.0);
            let theta = singular - distance;
            pose = rig.reach(&pose, &[theta]);
            let motions = bar.poses(theta, crossing).expect("in reach");
            let all: Vec<_> = bodies.into_iter().zip(motions).collect();
            let expected = planar_effective_mass(&all, 1, point, n);
            let response = rig.respond(&pose, &contact);
            let stated = response.effective_mass_error().expect("finite") / mass(&response);
            // Rounding error of the closed form: a root of a difference.
            let own = 4e-15 / distance.powf(power);
            let case = format!("{} {distance:e} before", rig.name);
            gauge.note(&case, (mass(&response) / expected - 1.0).abs() / (stated + own), 1.0);
            masses.relative(&case, mass(&response), expected, 1e-12 + 10.0 * own);
            vague.note(&case, stated, 1e-12 + 3e-13 / distance.powf(power));
        }
    };
    // Coupler and rocker aligned: rates of dependent joints grow as 1/√distance.
    let bar = FourBar { ground: 0.8, crank: 0.6, coupler: 0.5, rocker: 0.4 };
    let limit = ((0.36 + 0.64 - 0.81f64) / 0.96).acos();
    let triple = linkage::four_bar_of("triple rocker", bar, bodies, Crossing::Left, 0.7, [-1.3, 1.3]);
    check(triple, bar, Crossing::Left, limit, 1.0);
    // Branches cross at π: the singular values of the rows decrease with the distance.
    check(linkage::parallelogram(), linkage::PARALLELOGRAM, Crossing::Left, std::f64::consts::PI, 2.0);
    check(linkage::antiparallelogram(), linkage::PARALLELOGRAM, Crossing::Right, std::f64::consts::PI, 2.0);
    gauge.report();
    masses.report();
    vague.report();
}
