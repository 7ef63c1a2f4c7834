//! Gradient of m̄ at many configurations of chains with 2 to 10 hinges, compared with m̄ alone in the same run: thread CPU time per
//! configuration, least of many runs, and the ratio. Before the timing, gradients are compared with those of poses.

use cpu_time::ThreadTime;
use percuss_benches::loaded;
use percuss_dynamics::{BatchPositions, Conditions, Contact, RowColumns, RowResults, System};
use std::fmt::Write;
use std::hint::black_box;

/// Configurations of a batch; positions and results stay in the inner caches.
const COUNT: usize = 1024;
const RUNS: usize = 300;
/// Largest accepted ratio of the time with the gradient to the time of m̄ alone, up to ten hinges.
const LARGEST_RATIO: f64 = 4.0;
/// Largest relative difference from the gradient at a pose: the condition numbers are up to some thousand.
const AGREEMENT: f64 = 1e-9;

/// URDF of a chain with hinges about x, y and z in turn.
fn chain(hinges: usize) -> String {
    let mut text = String::from("<robot name=\"chain\"><link name=\"link_0\"/>");
    for k in 1..=hinges {
        let axis = ["1 0 0", "0 1 0", "0 0 1"][k % 3];
        let _ = write!(
            text,
            "<link name=\"link_{k}\"><inertial><origin xyz=\"0.15 0.02 0.01\"/><mass value=\"{mass}\"/><inertia ixx=\"0.02\" \
             iyy=\"0.03\" izz=\"0.025\" ixy=\"0.001\" ixz=\"0\" iyz=\"0\"/></inertial></link><joint name=\"joint_{k}\" \
             type=\"continuous\"><parent link=\"link_{before}\"/><child link=\"link_{k}\"/><origin xyz=\"0.3 0 0.05\" \
             rpy=\"0.1 0.2 0.3\"/><axis xyz=\"{axis}\"/></joint>",
            mass = 1.0 + 0.3 * k as f64,
            before = k - 1,
        );
    }
    text + "</robot>"
}

fn main() {
    // `cargo bench -- NAME` of another benchmark.
    if std::env::args().skip(1).any(|word| !word.starts_with("--") && !"gradients".contains(&word)) {
        return;
    }
    println!("hinges: m̄, ns; with gradient, ns; ratio");
    for hinges in [2, 3, 4, 6, 7, 8, 10] {
        let mechanism = loaded(&chain(hinges));
        let tip = mechanism.find_link(&format!("link_{hinges}")).expect("the last link");
        let system = System::new(mechanism, &Conditions::new()).expect("a system");
        let contact = Contact::new(tip, [0.3, 0.05, 0.0], [0.2, 0.9, -0.3]);
        let assembly = system.reference().expect("a tree");
        let batch = assembly.batch(&contact).expect("a contact");
        assert!(batch.has_derivative_lanes() && batch.velocities() == hinges);
        // Irrational steps cover the range of angles evenly.
        let angle = |k: usize, c: usize| {
            2.0 * std::f64::consts::PI * (0.618_034 * (k * hinges + c + 1) as f64).fract()
        };
        let values: Vec<f64> = (0..COUNT).flat_map(|k| (0..hinges).map(move |c| angle(k, c))).collect();
        let positions = BatchPositions::Rows { values: &values, stride: hinges };
        let mut results = RowResults::new(COUNT);
        let mut gradients = vec![0.0; COUNT * hinges];
        batch
            .run(positions, RowColumns { gradients: Some(&mut gradients), ..results.columns() }, COUNT)
            .expect("rows");
        for k in (0..COUNT).step_by(101) {
            let pose = assembly.pose(
                &percuss_dynamics::Configuration::from_positions(
                    system.mechanism(),
                    &values[k * hinges..][..hinges],
                )
                .expect("positions"),
            );
            let expected = pose.expect("a tree").effective_mass_gradient(&contact).expect("a contact");
            let expected = expected.expect("a finite mass").joints.concat();
            let size = expected.iter().fold(results.masses[k], |most, g| g.abs().max(most));
            let off =
                expected.iter().zip(&gradients[k * hinges..]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off <= AGREEMENT * size, "{hinges} hinges, row {k}: {off:e}");
        }
        let (mut alone, mut both) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..RUNS {
            let start = ThreadTime::now();
            batch.run(black_box(positions), results.columns(), COUNT).expect("rows");
            alone = alone.min(start.elapsed().as_secs_f64());
            black_box(&results);
            let start = ThreadTime::now();
            batch
                .run(
                    black_box(positions),
                    RowColumns { gradients: Some(&mut gradients), ..results.columns() },
                    COUNT,
                )
                .expect("rows");
            both = both.min(start.elapsed().as_secs_f64());
            black_box(&gradients);
        }
        let ns = |seconds: f64| 1e9 * seconds / COUNT as f64;
        println!("{hinges}: {:.1}; {:.1}; {:.2}", ns(alone), ns(both), both / alone);
        assert!(both <= LARGEST_RATIO * alone, "{hinges} hinges: {:.2} times m̄ alone", both / alone);
    }
}
