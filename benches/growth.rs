//! Growth of the cost with the size: `percuss-growth` prints for each size the nanoseconds of thread CPU time
//! for one m̄ and per body, the memory of the process, and the exponent between the smallest and the largest
//! size.
//!
//! Each size runs in a separate process, so that its memory can be measured: `percuss-growth TASK-SIZE` prints
//! one line.

use cpu_time::ThreadTime;
use percuss_benches::task;
use std::process::Command;
use std::time::Duration;

/// Families and their sizes.
const FAMILIES: [(&str, &[usize]); 4] = [
    ("chain", &[10, 100, 1_000, 10_000]),
    ("chain-lanes", &[10, 100, 1_000, 10_000]),
    ("separate", &[10, 50, 200]),
    ("ladder", &[10, 50, 200]),
];
/// Measuring time per size; the smallest time counts.
const TIME: Duration = Duration::from_millis(1500);

fn main() {
    if let Some(name) = std::env::args().nth(1) {
        return one(&name);
    }
    for (family, sizes) in FAMILIES {
        println!("{family}: size, ns, ns a body, MB");
        let mut ends = Vec::new();
        for size in sizes {
            let program = std::env::current_exe().expect("this program");
            let output = Command::new(program).arg(format!("{family}-{size}")).output().expect("it runs");
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            let text = String::from_utf8_lossy(&output.stdout);
            let numbers: Vec<f64> = text.split_whitespace().map(|x| x.parse().expect("a number")).collect();
            println!("{size:>8} {:>12.0} {:>8.1} {:>8.1}", numbers[0], numbers[1], numbers[2]);
            ends.push((*size as f64, numbers[0]));
        }
        let (first, last) = (ends[0], ends[ends.len() - 1]);
        println!("exponent {:.2}", (last.1 / first.1).ln() / (last.0 / first.0).ln());
    }
}

fn one(name: &str) {
    let mut task = task(name).unwrap_or_else(|| panic!("{name}: no work has this name"));
    let (mut least, mut spent) = (f64::INFINITY, Duration::ZERO);
    while spent < TIME {
        let start = ThreadTime::now();
        (task.run)();
        let elapsed = start.elapsed();
        spent += elapsed;
        least = least.min(elapsed.as_nanos() as f64 / task.units as f64);
    }
    // Only on Linux; 0 on other systems.
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = peak.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok()).unwrap_or(0.0);
    println!("{least} {} {}", least / task.bodies as f64, kilobytes / 1024.0);
}
