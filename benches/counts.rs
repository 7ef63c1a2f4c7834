//! `percuss-counts TASK TIMES` runs a task the given number of times and prints the number of work units.
//! `benches/counts.sh` runs this program under valgrind with and without the task; the difference is the number
//! of instructions.

use percuss_benches::task;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [name, times] = &words[..] else { panic!("percuss-counts TASK TIMES") };
    let mut task = task(name).unwrap_or_else(|| panic!("{name}: no work has this name"));
    // The first run allocates workspaces and trains the branch predictor.
    (task.run)();
    let times: usize = times.parse().expect("a number of times");
    (0..times).for_each(|_| (task.run)());
    println!("{}", times * task.units);
}
