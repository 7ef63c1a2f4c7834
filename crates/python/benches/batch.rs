//! The sweep of sweep.py without Python: reads configurations (raw float64, row by row) and prints the least CPU time
//! of all threads, in seconds, for results in a new vector (as in Python) and in a reused vector.
//!
//!     batch MODEL.urdf LINK X,Y,Z NX,NY,NZ FILE

use cpu_time::ProcessTime;
use percuss::{BatchPositions, Conditions, Contact, LoadOptions, RowResults, Source, System, load};
use std::hint::black_box;

const REPETITIONS: usize = 5;
/// Configurations per task of a thread.
const BLOCK: usize = 512;

fn triple(text: &str) -> [f64; 3] {
    let numbers: Vec<f64> = text.split(',').map(|x| x.parse().expect("a number")).collect();
    numbers.try_into().expect("three numbers")
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let [model, link, point, normal, file] = &arguments[..] else {
        println!("batch: run by sweep.py");
        return;
    };
    let source = Source::read(model, percuss::DEFAULT_MAX_SIZE).expect("a model");
    let mechanism = load(&source, &LoadOptions::default()).expect("a model").mechanism;
    let contact = Contact::new(mechanism.find_link(link).expect("a link"), triple(point), triple(normal));
    let width: usize = mechanism.joints().iter().map(|joint| joint.kind().positions()).sum();
    let bytes = std::fs::read(file).expect("configurations");
    let (numbers, _) = bytes.as_chunks::<8>();
    let values: Vec<f64> = numbers.iter().map(|number| f64::from_le_bytes(*number)).collect();
    let count = values.len() / width;
    let system = System::new(mechanism, &Conditions::new()).expect("a system");
    let batch = system.reference().expect("closed loops").batch(&contact).expect("a contact");
    let ask = |results: &mut RowResults| {
        let positions = BatchPositions::Rows { values: black_box(&values), stride: width };
        batch.run(positions, results.columns(), BLOCK).expect("answers");
    };
    let mut kept = RowResults::new(count);
    let [mut of_new, mut of_kept] = [f64::INFINITY; 2];
    for _ in 0..REPETITIONS {
        let start = ProcessTime::now();
        let mut answers = RowResults::new(count);
        ask(&mut answers);
        of_new = of_new.min(start.elapsed().as_secs_f64());
        let _ = black_box(answers);
        let start = ProcessTime::now();
        ask(&mut kept);
        of_kept = of_kept.min(start.elapsed().as_secs_f64());
        black_box(&kept);
    }
    println!("{of_new} {of_kept}");
}
