//! How the cost grows: `percuss-growth` prints, for each size, nanoseconds of thread CPU time for one m̄ and for one body of it,
//! the memory of the process, and the exponent between the least and the greatest size.
//!
//! Each size is a process of its own, so that its memory is its own: `percuss-growth TASK-SIZE` prints one line.

use cpu_time::ThreadTime;
use percuss_benches::task;
use std::process::Command;
use std::time::Duration;

/// What grows, and to which sizes.
const FAMILIES: [(&str, &[usize]); 4] = [
    ("chain", &[10, 100, 1_000, 10_000]),
    ("chain-lanes", &[10, 100, 1_000, 10_000]),
    ("separate", &[10, 50, 200]),
    ("ladder", &[10, 50, 200]),
];
/// Each size is run so long, and the least counts.
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
    // On Linux; 0 elsewhere.
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = peak.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok()).unwrap_or(0.0);
    println!("{least} {} {}", least / task.bodies as f64, kilobytes / 1024.0);
}
