//! `percuss-counts TASK TIMES`: does a piece of work so often, and prints how many units of it that was. Run under valgrind
//! twice, with and without the work, it shows how many instructions the work takes: `benches/counts.sh`.

use percuss_benches::task;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [name, times] = &words[..] else { panic!("percuss-counts TASK TIMES") };
    let mut task = task(name).unwrap_or_else(|| panic!("{name}: no work has this name"));
    // Rooms are made, and branches predicted, by the first.
    (task.run)();
    let times: usize = times.parse().expect("a number of times");
    (0..times).for_each(|_| (task.run)());
    println!("{}", times * task.units);
}
