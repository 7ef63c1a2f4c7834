//! m̄ of many configurations, one after another and in SIMD lanes: differences, and times by the clock.
//!
//! `cargo run --release -p percuss --example lanes`; on another processor, or in WebAssembly, as docs/howto/RUST.md describes.

use percuss::spatial::lanes::Instructions;
use percuss::{
    BatchPositions, Conditions, Contact, EffectiveMass, LoadOptions, RowResults, Source, System, load,
};
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

/// Number of configurations. The time is the least of `RUNS` repetitions.
const COUNT: usize = 1024;
const RUNS: usize = 20;
/// Largest accepted relative difference from the result at a pose: twice the largest error of a result in lanes.
const LARGEST_DIFFERENCE: f64 = 2e-9;

/// Time of one repetition per configuration, ns.
fn fastest(mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least * 1e9 / COUNT as f64
}

/// Compares single evaluations with SIMD lanes for one model. `driver`: joint that drives the loops; `None`: all joints move.
fn compare(name: &str, text: &str, link: &str, driver: Option<&str>) -> Result<(), Box<dyn Error>> {
    let mechanism = load(&Source::from_text(name, text), &LoadOptions::default())?.mechanism;
    let contact = Contact::new(mechanism.find_link(link)?, [0.1, 0.05, 0.02], [0.3, 0.4, 0.5]);
    let system = System::new(mechanism, &Conditions::new())?;
    let mut pose = system.pose(&system.configuration())?;
    let (mut rows, mut expected) = (Vec::new(), Vec::new());
    for k in 0..COUNT {
        let share = 2.0 * k as f64 / (COUNT - 1) as f64 - 1.0;
        let mut configuration = system.configuration();
        match driver {
            Some(joint) => _ = configuration.set(joint, &[0.15 * share])?,
            None => {
                for (number, joint) in pose.mechanism().joints().iter().enumerate() {
                    let angle = (1.0 + number as f64) * share;
                    let positions = vec![angle.sin(); joint.kind().positions()];
                    configuration.set(joint.name(), &positions)?;
                }
            }
        }
        pose = system.pose_from(&pose, &configuration)?;
        rows.extend_from_slice(pose.positions());
        expected.push(pose.respond(&contact)?.effective_mass);
    }
    let width = rows.len() / COUNT;
    let mut batch = pose.assembly().batch(&contact)?;
    let mut results = RowResults::new(COUNT);
    let positions = BatchPositions::Rows { values: &rows, stride: width };
    batch.run(positions, results.columns(), COUNT)?;
    let mut largest = 0.0_f64;
    for (k, (row, expected)) in rows.chunks(width).zip(&expected).enumerate() {
        for mass in [results.answer(k).mass, batch.effective_mass(row)?.mass] {
            let (Some(EffectiveMass::Finite(m)), EffectiveMass::Finite(expected)) = (mass, expected) else {
                return Err(format!("{name}: {mass:?} instead of {expected:?}").into());
            };
            largest = largest.max((m / expected - 1.0).abs());
        }
    }
    if largest > LARGEST_DIFFERENCE {
        return Err(format!("{name}: results differ by {largest:.1e}").into());
    }
    let one =
        fastest(|| rows.chunks(width).for_each(|row| _ = black_box(batch.effective_mass(black_box(row)))));
    let lanes = fastest(|| _ = black_box(batch.run(black_box(positions), results.columns(), COUNT)));
    println!(
        "{name}: one by one {one:.0} ns, in lanes {lanes:.0} ns, {:.2} times as fast; largest difference {largest:.1e}",
        one / lanes
    );
    Ok(())
}

/// Compares an arm, a suspension and a four-bar linkage.
pub fn main() -> Result<(), Box<dyn Error>> {
    let set = Instructions::best();
    println!("{}: {} lanes ({})", std::env::consts::ARCH, set.width(), set.name());
    compare("six_r_arm.urdf", include_str!("../../../models/six_r_arm.urdf"), "tool", None)?;
    compare(
        "double_wishbone.urdf",
        include_str!("../../../models/double_wishbone.urdf"),
        "upright",
        Some("lower_arm_hinge"),
    )?;
    compare("four_bar.urdf", include_str!("../../../models/four_bar.urdf"), "coupler", Some("crank_hinge"))
}
