//! Branches close to each other: every row of a sweep is on its starting branch, for any spacing of the rows, or is
//! refused.
//!
//! `PERCUSS_FAMILY=10000 cargo test --workspace --test suites -- --nocapture every_row` takes that many linkages. Of
//! each kind, every tenth is also swept with 601 rows, and every hundredth with 6,001. `PERCUSS_SEED=N` takes one of
//! them, with all rows.

use percuss_dynamics::{AssemblyError, Contact, DrivenPath};
use percuss_mechanism::JointId;
use percuss_oracle::closed_form::Crossing;
use percuss_oracle::linkage::{
    self, BRANCHING_KINDS, Branching, branching, nearly_parallel_four_bar, position_distance,
};
use percuss_tests::rig::Rig;
use std::collections::BTreeMap;

/// Linkages of the short version: 20 of each kind.
const COUNT: u64 = 20 * BRANCHING_KINDS;
/// Rows of a sweep; the short version takes the first [`SHORT_COUNTS`].
const COUNTS: [usize; 6] = [3, 7, 13, 61, 601, 6001];
const SHORT_COUNTS: usize = 4;
/// Rad: branches of a mismatch of 1e-6 approach each other to 1e-3, and rounding leaves 1e-12 over that.
const SAME: f64 = 1e-6;
/// Rows closer to a limit than this are not judged, rad: the platform's limits are known to one step of its
/// continuation.
const AT_END: f64 = 5e-3;
/// Rows closer to a limit of a closed form than this are not judged, rad: the square root of the rounding of its
/// lengths.
const AT_EXACT_END: f64 = 1e-9;

#[derive(Debug, Default)]
struct Seen {
    rows: usize,
    answered: usize,
    in_lanes: usize,
    refused: usize,
    uncertain: usize,
    wrong: Vec<String>,
    /// Rows refused within the branch.
    lost: Vec<String>,
    worst: f64,
}

impl Seen {
    fn merge(mut self, other: Self) -> Self {
        self.rows += other.rows;
        self.answered += other.answered;
        self.in_lanes += other.in_lanes;
        self.refused += other.refused;
        self.uncertain += other.uncertain;
        self.wrong.extend(other.wrong);
        self.lost.extend(other.lost);
        self.worst = self.worst.max(other.worst);
        self
    }
}

/// Orders of the rows of a sweep: forwards, backwards, from the middle to one side and to the other.
fn sweeps([from, to]: [f64; 2], count: usize) -> [Vec<f64>; 4] {
    let at = |k: usize| from + (to - from) * k as f64 / (count - 1) as f64;
    let middle = count / 2;
    [
        (0..count).map(at).collect(),
        (0..count).rev().map(at).collect(),
        (middle..count).map(at).collect(),
        (0..=middle).rev().map(at).collect(),
    ]
}

struct Sweep<'a> {
    rig: &'a Rig,
    case: &'a Branching,
    contact: Contact,
    driver: JointId,
}

impl Sweep<'_> {
    fn judge(&self, value: f64, positions: Option<&[f64]>, line: &str, seen: &mut Seen) {
        seen.rows += 1;
        let near = if self.case.label.contains("platform") { AT_END } else { AT_EXACT_END };
        if self.case.ends.iter().any(|end| (value - end).abs() < near) {
            return;
        }
        let expected = self.case.at(value);
        let within = value > self.case.ends[0] && value < self.case.ends[1];
        let Some(positions) = positions else {
            seen.refused += 1;
            if expected.is_some() {
                seen.lost.push(format!("{} {line}: {value} refused", self.case.label));
            }
            return;
        };
        seen.answered += 1;
        let Some(expected) = expected else {
            if !within {
                seen.wrong.push(format!("{} {line}: {value} answered beyond the limit", self.case.label));
            }
            return;
        };
        let mechanism = &self.rig.mechanism;
        let places: Vec<usize> = mechanism
            .joints()
            .iter()
            .scan(0, |next, joint| {
                let own = *next;
                *next += joint.kind().positions();
                Some(own)
            })
            .collect();
        for (name, position) in expected {
            let place = places[self.rig.joint(name).index()];
            let far = position_distance(&positions[place..place + position.len()], &position);
            if far > SAME {
                seen.wrong.push(format!("{} {line}: {name} at {value} off by {far:.2e}", self.case.label));
            } else {
                seen.worst = seen.worst.max(far);
            }
        }
    }

    /// Poses the rows as a sweep does: several rows at once if the path follows them, otherwise one by one.
    fn run(&self, rows: &[f64], line: &str, seen: &mut Seen) {
        let mut last = self.rig.closed();
        let mut path: Option<DrivenPath> = None;
        let mut next = 0;
        while next < rows.len() {
            if let Some(path) = &mut path {
                let (mut answers, mut positions) = (Vec::new(), Vec::new());
                let reached = path.follow(&rows[next..], &mut answers, &mut positions);
                for (value, own) in rows[next..].iter().zip(positions.chunks(last.positions().len())) {
                    self.judge(*value, Some(own), line, seen);
                }
                seen.in_lanes += reached;
                next += reached;
                if reached > 0 {
                    last = path.pose();
                }
                if next == rows.len() {
                    break;
                }
            }
            let value = rows[next];
            next += 1;
            match self.rig.move_drivers(&last, &[value]) {
                Ok(pose) => {
                    self.judge(value, Some(pose.positions()), line, seen);
                    let restarted = path.as_mut().is_some_and(|path| path.restart(&pose));
                    if !restarted {
                        path = pose.driven_path(&self.contact, &[self.driver]).expect("a contact");
                    }
                    last = pose;
                }
                Err(error) => {
                    seen.uncertain += usize::from(matches!(error, AssemblyError::BranchUncertain { .. }));
                    self.judge(value, None, line, seen);
                    path = None;
                }
            }
        }
    }
}

/// Sweeps of a linkage over a range (its own if `None`), with these numbers of rows.
fn judged(mut case: Branching, range: Option<[f64; 2]>, counts: &[usize]) -> Seen {
    let range = range.unwrap_or(case.linkage.range[0]);
    let linkage = std::mem::replace(&mut case.linkage, linkage::parallelogram());
    let rig = Rig::new(linkage);
    let link = rig.mechanism.links().last().expect("a link").name().to_owned();
    let contact = rig.contact(&link, [0.1, 0.05, 0.0], [0.3, 0.8, 0.1].into());
    let driver = rig.joint(&rig.drivers[0]);
    let sweep = Sweep { rig: &rig, case: &case, contact, driver };
    let mut seen = Seen::default();
    for &count in counts {
        for (order, rows) in ["forwards", "backwards", "up", "down"].iter().zip(sweeps(range, count)) {
            sweep.run(&rows, &format!("{count} {order}"), &mut seen);
        }
    }
    seen
}

#[test]
fn every_row_lies_on_the_branch_it_began_on() {
    let asked: Option<u64> = std::env::var("PERCUSS_FAMILY").ok().and_then(|count| count.parse().ok());
    let count = asked.unwrap_or(COUNT);
    let only: Option<u64> = std::env::var("PERCUSS_SEED").ok().and_then(|seed| seed.parse().ok());
    let own = |thread: u64| -> Vec<(u64, Seen)> {
        let seeds = (0..count).filter(move |seed| (seed / BRANCHING_KINDS) % 2 == thread);
        let seeds = seeds.filter(|seed| only.is_none_or(|only| *seed == only));
        let judged = |seed| {
            let mut case = branching(seed);
            case.label = format!("seed {seed}, {}", case.label);
            // The kinds change with the seed: six neighbours have one of each.
            let long = match (seed / BRANCHING_KINDS) % 100 {
                _ if only.is_some() => 2,
                0 if asked.is_some() => 2,
                k if asked.is_some() && k % 10 == 0 => 1,
                _ => 0,
            };
            judged(case, None, &COUNTS[..SHORT_COUNTS + long])
        };
        seeds.map(|seed| (seed % BRANCHING_KINDS, judged(seed))).collect()
    };
    let mut all = std::thread::scope(|scope| {
        let other = scope.spawn(|| own(1));
        let mut all = own(0);
        all.extend(other.join().expect("no panic"));
        all
    });
    all.sort_by_key(|(kind, _)| *kind);
    let mut kinds: BTreeMap<u64, Seen> = BTreeMap::new();
    for (kind, seen) in all {
        let so_far = kinds.remove(&kind).unwrap_or_default();
        kinds.insert(kind, so_far.merge(seen));
    }
    let total = kinds.into_iter().fold(Seen::default(), |total, (kind, seen)| {
        let Seen { rows, answered, in_lanes, refused, uncertain, worst, .. } = &seen;
        let (wrong, lost) = (seen.wrong.len(), seen.lost.len());
        println!(
            "kind {kind}: {rows} rows, {answered} answered ({in_lanes} in lanes), {refused} refused, {uncertain} uncertain, \
             {wrong} wrong, {lost} lost, off by {worst:.1e} at most"
        );
        total.merge(seen)
    });
    total.wrong.iter().take(20).for_each(|line| println!("wrong: {line}"));
    total.lost.iter().take(20).for_each(|line| println!("lost: {line}"));
    assert!(total.wrong.is_empty(), "{} of {} rows", total.wrong.len(), total.rows);
    assert!(total.lost.len() * 1000 <= total.rows, "{} of {} rows", total.lost.len(), total.rows);
    // Ranges go beyond the limits of the mechanism; of a single one, nearly all rows may lie there.
    assert!(
        only.is_some() || total.answered * 5 > total.rows * 2 && total.in_lanes > 70,
        "{} {}",
        total.answered,
        total.in_lanes
    );
}

/// Platforms whose loops are nearly, but not exactly, closed at a pose near the zero of all joints: that pose is the end of a
/// branch, not a rounded drawing.
#[test]
fn loops_that_are_nearly_closed_by_chance_are_not_taken_for_rounded() {
    for seed in [4090, 4456] {
        let Seen { answered, wrong, lost, .. } = judged(branching(seed), None, &COUNTS[..SHORT_COUNTS + 1]);
        assert!(wrong.is_empty() && lost.is_empty(), "seed {seed}: {wrong:?} {lost:?}");
        assert!(answered > 100, "seed {seed}: {answered} rows");
    }
}

/// A platform whose driver reverses twice within 1e-3 rad, at the end of the branch: both points beside the two reversals have
/// the same driver direction and the same orientation.
#[test]
fn a_step_does_not_pass_over_two_reversals_of_the_driver() {
    let mut case = branching(6082);
    let end = case.ends[0];
    let rig = Rig::new(std::mem::replace(&mut case.linkage, linkage::parallelogram()));
    let mut compared = 0;
    for ratio in [0.9, 0.5, 0.1, 0.03, 0.01] {
        let mut pose = rig.closed();
        let mut beyond_end = 0.03;
        while beyond_end > 1e-5 {
            let value = end + beyond_end;
            pose =
                rig.move_drivers(&pose, &[value]).unwrap_or_else(|error| panic!("{ratio} {value}: {error}"));
            let [(_, expected)] = &case.at(value).expect("a closed pose")[..] else { panic!("one ball") };
            let far = position_distance(&pose.positions()[1..], expected);
            assert!(far < SAME, "{ratio} {value}: off by {far:e}");
            compared += 1;
            beyond_end *= ratio;
        }
    }
    assert!(compared > 90, "{compared}");
}

#[test]
fn a_four_bar_near_a_parallelogram_keeps_its_branch_on_every_grid() {
    for crossing in [Crossing::Left, Crossing::Right] {
        // Crank angles from 0 to 6.2 rad; the linkage is drawn at 1 rad.
        let range = Some([-1.0, 5.2]);
        let Seen { rows, in_lanes, refused, wrong, worst, .. } =
            judged(nearly_parallel_four_bar(crossing), range, &[7, 13, 31, 61, 601, 6001]);
        assert!(wrong.is_empty() && refused == 0, "{crossing:?}: {refused} refused, {wrong:?}");
        println!("{crossing:?}: {rows} rows, {in_lanes} in lanes, off by {worst:.1e}");
        // The rounding of lengths over a transmission angle of 2.9°.
        assert!(worst < 1e-11, "{crossing:?}: {worst:e} over {rows} rows");
    }
}
