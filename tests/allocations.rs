//! The hot path allocates nothing after warm-up: every allocation of this binary is counted.

// A global allocator is the only way to see an allocation, and implementing one is unsafe by nature; this one counts
// and hands on to the system's.
#![allow(unsafe_code)]

use percuss_dynamics::{EffectiveMass, Route, RouteChoice, RouteError, Strike, StrikeError};
use percuss_tests::cases::{self, Case};
use percuss_tests::gauge::Gauge;
use percuss_tests::judge::{hard, rounding};
use rand::{SeedableRng, rngs::StdRng};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    /// Of this thread alone: the test harness allocates in others.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

fn count() {
    ALLOCATIONS.with(|n| n.set(n.get() + 1));
}

// SAFETY: every call goes to the system's allocator unchanged; counting allocates nothing.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: the caller's promises are handed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promises are handed on.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: the caller's promises are handed on.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: the caller's promises are handed on.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

fn allocations() -> usize {
    ALLOCATIONS.with(Cell::get)
}

#[test]
fn the_counter_counts() {
    let before = allocations();
    drop(std::hint::black_box(vec![1.0f64; 10]));
    assert!(allocations() > before);
}

#[test]
fn a_workspace_allocates_nothing_and_says_what_strike_says() {
    let mut rng = StdRng::seed_from_u64(41);
    let mut same = Gauge::new("workspace = strike");
    let mut immovable = 0;
    for case in [cases::of_the_zoo(4, 1), cases::at_random(4000, 60, 40)].concat() {
        let system = case.system();
        let mut workspace = system.workspace();
        let contact = case.contact();
        let configurations: Vec<Vec<f64>> = (0..20)
            .map(|_| {
                let positions = percuss_oracle::random::positions(&mut rng, &case.mechanism);
                positions.into_iter().flatten().collect()
            })
            .collect();
        let mut answers = Vec::with_capacity(configurations.len());
        workspace.repose(&configurations[0]);
        let _ = workspace.effective_mass(&contact);
        let before = allocations();
        for configuration in &configurations {
            workspace.repose(configuration);
            answers.push(workspace.effective_mass(&contact));
        }
        assert_eq!(allocations() - before, 0, "{}", case.name);
        for (configuration, answer) in configurations.iter().zip(answers) {
            let strike = strike(&case, &system, configuration);
            match answer {
                Ok(EffectiveMass::Finite(m)) => {
                    // The same recursion; but a configuration normalises its quaternions, which are off by ε.
                    let strike = strike.unwrap_or_else(|error| panic!("{}: {error}", case.name));
                    let EffectiveMass::Finite(expected) = strike.effective_mass else {
                        panic!("{}", case.name)
                    };
                    same.relative(&case.name, m, expected, rounding(&strike));
                }
                Ok(EffectiveMass::Immovable) => {
                    assert_eq!(
                        strike.map(|s| s.effective_mass),
                        Ok(EffectiveMass::Immovable),
                        "{}",
                        case.name
                    );
                    immovable += 1;
                }
                Ok(EffectiveMass::Massless) => panic!("{}: the recursion never says massless", case.name),
                // The pivot that is no pivot depends on the last bits; that it is none does not.
                Err(StrikeError::Route(RouteError::SingularPivot { .. })) => {
                    let again = match &strike {
                        Ok(strike) => hard(strike),
                        Err(error) => matches!(error, StrikeError::Route(RouteError::SingularPivot { .. })),
                    };
                    assert!(again, "{}: {strike:?}", case.name);
                }
                Err(error) => assert_eq!(strike.map(|s| s.effective_mass), Err(error), "{}", case.name),
            }
        }
    }
    same.report();
    assert!(immovable > 0, "nothing was immovable");
}

/// By way of a configuration and a pose.
fn strike(case: &Case, system: &percuss_dynamics::System, flat: &[f64]) -> Result<Strike, StrikeError> {
    let mut positions = Vec::new();
    let mut rest = flat;
    for joint in case.mechanism.joints() {
        let (own, others) = rest.split_at(joint.kind().positions());
        positions.push(own.to_vec());
        rest = others;
    }
    let pose = Case { positions, ..case.clone() }.pose(system);
    system.strike(&pose, &case.contact(), RouteChoice::Only(Route::Articulated))
}
