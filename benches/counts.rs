//! `percuss-counts TASK TIMES` runs a task the given number of times and prints the number of work units.
//! `benches/counts.sh` runs this program under valgrind with and without the task; the difference is the number
//! of instructions.
//!
//! `percuss-counts` alone prints the table of operations of `benches/README.md`: CPU time of all threads per work unit, the least of many runs, and
//! the ratio to the time of an operation that this one contains.

use cpu_time::ProcessTime;
use percuss_benches::task;
use std::time::Duration;

/// Operations, and for each the task that it contains.
const OPERATIONS: [(&str, &str); 28] = [
    ("scalar", ""),
    ("lanes", "scalar"),
    ("moment", "scalar"),
    ("line", "scalar"),
    ("gradient", "lanes"),
    ("workspace", ""),
    ("response-arm", "scalar"),
    ("linkage", ""),
    ("step", "linkage"),
    ("response", "linkage"),
    ("impact-arm", "response-arm"),
    ("impact-pose-arm", "scalar"),
    ("impact-time-arm", "impact-pose-arm"),
    ("impact", "response"),
    ("impact-pose", "linkage"),
    ("impact-time", "impact-pose"),
    ("ask-mass", "response"),
    ("ask-explain", "ask-mass"),
    ("ask-tolerance", "ask-mass"),
    ("ask-samples", "linkage"),
    ("ask-row", "ask-mass"),
    ("ask-sweep", "step"),
    ("ask-kinematics", "step"),
    ("ask-extremes", "ask-mass"),
    ("load", ""),
    ("chain-100", ""),
    ("chain-10000", "chain-100"),
    ("ladder-200", "ladder-10"),
];
/// Measuring time per task; the smallest time counts.
const TIME: Duration = Duration::from_millis(400);

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if words.is_empty() {
        return print_operations();
    }
    let [name, times] = &words[..] else { panic!("percuss-counts [TASK TIMES]") };
    let mut task = task(name).unwrap_or_else(|| panic!("{name}: no work has this name"));
    // The first run allocates workspaces and trains the branch predictor.
    (task.run)();
    let times: usize = times.parse().expect("a number of times");
    (0..times).for_each(|_| (task.run)());
    println!("{}", times * task.units);
}

fn print_operations() {
    println!("| operation | µs | contains | ratio |\n|---|---|---|---|");
    for (name, part) in OPERATIONS {
        let own = least_time(name);
        let ratio = if part.is_empty() { String::new() } else { format!("{:.2}", own / least_time(part)) };
        println!("| `{name}` | {:.3} | {part} | {ratio} |", 1e6 * own);
    }
}

/// Least CPU time of a task, of all threads, s per work unit.
fn least_time(name: &str) -> f64 {
    let mut task = task(name).unwrap_or_else(|| panic!("{name}: no work has this name"));
    (task.run)();
    let (mut least, mut spent) = (f64::INFINITY, Duration::ZERO);
    while spent < TIME {
        let start = ProcessTime::now();
        (task.run)();
        let elapsed = start.elapsed();
        spent += elapsed;
        least = least.min(elapsed.as_secs_f64());
    }
    least / task.units as f64
}
