//! Collection of many checks before a test fails: a table of the failures, and a line per failure.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Checks by question (the name of the reporting test) and by column.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    checks: BTreeMap<(&'static str, String), Column>,
}

#[derive(Clone, Debug, Default)]
struct Column {
    made: usize,
    skipped: usize,
    failures: Vec<String>,
}

/// Number of printed failures per column, unless `PERCUSS_ALL` is set.
const SHOWN: usize = 5;

impl Tally {
    fn column(&mut self, asked: &'static str, column: &str) -> &mut Column {
        self.checks.entry((asked, column.to_owned())).or_default()
    }

    /// Records a check with a one-line description of its failure. Returns true if it holds.
    pub fn check(
        &mut self,
        asked: &'static str,
        column: &str,
        holds: bool,
        line: impl FnOnce() -> String,
    ) -> bool {
        let column = self.column(asked, column);
        column.made += 1;
        if !holds {
            column.failures.push(line());
        }
        holds
    }

    /// Records an inapplicable check.
    pub fn skip(&mut self, asked: &'static str, column: &str) {
        self.column(asked, column).skipped += 1;
    }

    /// Questions with failures.
    pub fn wrong(&self) -> Vec<&'static str> {
        let mut wrong: Vec<_> = self
            .checks
            .iter()
            .filter(|(_, c)| !c.failures.is_empty())
            .map(|((asked, _), _)| *asked)
            .collect();
        wrong.dedup();
        wrong
    }

    /// Appends the checks of another tally.
    pub fn merge(&mut self, other: Tally) {
        for ((asked, column), more) in other.checks {
            let own = self.column(asked, &column);
            own.made += more.made;
            own.skipped += more.skipped;
            own.failures.extend(more.failures);
        }
    }

    /// Prints the results for a question.
    ///
    /// # Panics
    /// If a check failed, or a column has fewer than `least` checks.
    pub fn report(&self, asked: &str, least: usize) {
        let all = std::env::var_os("PERCUSS_ALL").is_some();
        let (mut failed, mut made, mut columns) = (0, 0, 0);
        for ((_, name), column) in self.checks.iter().filter(|((what, _), _)| *what == asked) {
            let Column { made: checks, skipped, failures } = column;
            let skips = if *skipped > 0 { format!(", {skipped} skipped") } else { String::new() };
            println!("{asked} | {name}: {} of {checks} fail{skips}", failures.len());
            let shown = if all { failures.len() } else { SHOWN };
            failures.iter().take(shown).for_each(|line| println!("    {asked} | {name} | {line}"));
            if failures.len() > shown {
                println!("    … and {} more (PERCUSS_ALL=1 shows them)", failures.len() - shown);
            }
            assert!(*checks >= least, "{asked} | {name}: only {checks} checks");
            failed += failures.len();
            made += checks;
            columns += 1;
        }
        assert!(columns > 0, "{asked}: nothing was checked");
        assert!(failed == 0, "{asked}: {failed} of {made} fail");
    }
}

/// Runs the cases on two threads; the tallies are merged in the order of the cases.
pub fn over<C: Sync>(cases: &[C], judge: impl Fn(&C, &mut Tally) + Sync) -> Tally {
    let next = AtomicUsize::new(0);
    let run = || {
        let mut own = Vec::new();
        while let Some((index, case)) = {
            let index = next.fetch_add(1, Ordering::Relaxed);
            cases.get(index).map(|case| (index, case))
        } {
            let mut tally = Tally::default();
            judge(case, &mut tally);
            own.push((index, tally));
        }
        own
    };
    let mut all = std::thread::scope(|scope| {
        let other = scope.spawn(run);
        let mut all = run();
        all.extend(other.join().expect("a judge that does not panic"));
        all
    });
    all.sort_by_key(|(index, _)| *index);
    let mut tally = Tally::default();
    all.into_iter().for_each(|(_, part)| tally.merge(part));
    tally
}
