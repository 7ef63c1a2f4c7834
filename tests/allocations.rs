//! The hot path allocates nothing after warm-up: this program counts every allocation.

// Allocations are visible only to a global allocator, whose implementation is unsafe; this allocator counts and calls
// the system's allocator.
#![allow(unsafe_code)]

use percuss_dynamics::{
    BatchPositions, Contact, ContactColumns, ContactResponse, ContactStatus, Direction, EffectiveMass, Frame,
    MapAnswers, Pose, Remark, ResponseError, RowResults, Workspace,
};
use percuss_impact::{ImpactWorkspace, RigidImpact};
use percuss_oracle::linkage;
use percuss_tests::cases::{self, Case};
use percuss_tests::gauge::Gauge;
use percuss_tests::imposed::{Imposed, VARIANTS};
use percuss_tests::judge::{NEAR, near_at};
use percuss_tests::rig::Rig;
use rand::{SeedableRng, rngs::StdRng};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    /// Allocations of this thread only: the test harness allocates on other threads.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

fn count() {
    ALLOCATIONS.with(|n| n.set(n.get() + 1));
}

// SAFETY: every call is forwarded unchanged to the system's allocator; counting allocates nothing.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: the caller's guarantees are forwarded.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's guarantees are forwarded.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: the caller's guarantees are forwarded.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: the caller's guarantees are forwarded.
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

/// Results of a workspace at a series of configurations, with the allocations of each. Every configuration is solved once before: further
/// kernels are compiled at the first results in doubt.
fn answers(
    workspace: &mut Workspace,
    contact: &Contact,
    configurations: &[Vec<f64>],
) -> Vec<(Result<EffectiveMass, ResponseError>, usize)> {
    let mut answers = Vec::with_capacity(configurations.len());
    for configuration in configurations {
        workspace.set_positions(configuration).expect("positions that fit");
        let _ = workspace.effective_mass(contact);
    }
    for configuration in configurations {
        let before = allocations();
        workspace.set_positions(configuration).expect("positions that fit");
        let answer = workspace.effective_mass(contact);
        answers.push((answer, allocations() - before));
    }
    answers
}

/// Asserts that a result of the recursion alone allocates nothing.
#[track_caller]
fn assert_allocates_nothing(name: &str, allocated: usize, response: &ContactResponse) {
    // For a relative uncertainty above 1e-11 the energy is computed too, which may halve the stated error.
    let error = response.effective_mass_error().unwrap_or(0.0);
    let in_doubt = matches!(response.effective_mass, EffectiveMass::Finite(m) if error > 5e-12 * m);
    assert!(
        allocated == 0 || response.dense_reason.is_some() || response.is_energy_value || in_doubt,
        "{name}: {allocated} allocations, {response:?}"
    );
}

/// Contacts on trees, loops, pairs of links and floating bases that Φ solves.
#[test]
fn a_map_allocates_nothing() {
    let (mut answered, mut maps) = (0, 0);
    let trees = cases::at_random(4400, 10, 12);
    let poses = trees.iter().map(|case| (case.contact(), case.pose(&case.system())));
    let linkages = percuss_tests::subjects::of_linkages(903, 1);
    for (contact, pose) in poses.chain(linkages.iter().map(|s| (s.contact, s.pose.clone()))) {
        let map = pose.contact_map(contact.link, contact.against, [0.0; 3], 0.5).expect("a region");
        if !map.is_by_inertia() {
            continue;
        }
        let columns: [Vec<f64>; 6] = std::array::from_fn(|column| {
            (0..1000).map(|i| ((i * (2 * column + 3) + 1) as f64 * 0.618).fract() - 0.5).collect()
        });
        let [x, y, z, nx, ny, nz] = columns.each_ref().map(|c| &c[..]);
        let contacts = ContactColumns { points: [x, y, z], normals: [nx, ny, nz] };
        let (mut masses, mut errors) = (vec![0.0; 1000], vec![0.0; 1000]);
        let mut statuses = vec![ContactStatus::Finite; 1000];
        let mut answers =
            MapAnswers { masses: &mut masses, relative_errors: &mut errors, statuses: &mut statuses };
        let before = allocations();
        map.fill_answers(contacts, &mut answers).expect("columns of one length");
        let allocated = allocations() - before;
        // Contacts that are uncertain by Φ are solved individually, which allocates temporary memory.
        maps += 1;
        answered += usize::from(allocated == 0);
    }
    assert!(answered > 10 && answered * 2 > maps, "{answered} of {maps} maps");
}

#[test]
fn a_workspace_allocates_nothing_and_agrees_with_a_pose() {
    let mut rng = StdRng::seed_from_u64(41);
    let mut same = Gauge::new("workspace = pose");
    let (mut immovable, mut massless) = (0, 0);
    for case in [cases::of_the_zoo(4, 1), cases::at_random(4000, 60, 40)].concat() {
        let system = case.system();
        let contact = case.contact();
        let configurations: Vec<Vec<f64>> = (0..20)
            .map(|_| {
                let positions = percuss_oracle::random::positions(&mut rng, &case.mechanism);
                positions.into_iter().flatten().collect()
            })
            .collect();
        let all = answers(&mut system.workspace(), &contact, &configurations);
        for (configuration, (answer, allocated)) in configurations.iter().zip(all) {
            let pose = pose(&case, &system, configuration);
            let response = pose.respond(&contact).expect("an answer");
            assert_allocates_nothing(&case.name, allocated, &response);
            match answer.unwrap_or_else(|error| panic!("{}: {error}", case.name)) {
                EffectiveMass::Finite(m) => {
                    // The same recursion, but a configuration normalises its quaternions, which changes them by ε.
                    let EffectiveMass::Finite(expected) = response.effective_mass else {
                        panic!("{}: {m} kg in the workspace, {:?}", case.name, response.effective_mass)
                    };
                    same.relative(&case.name, m, expected, near_at(&pose));
                }
                other => {
                    assert_eq!(other, response.effective_mass, "{}", case.name);
                    immovable += usize::from(other == EffectiveMass::Immovable);
                    massless += usize::from(other == EffectiveMass::Massless);
                }
            }
        }
    }
    same.report();
    assert!(immovable > 0 && massless > 0, "{immovable} immovable, {massless} massless");
}

/// The full response of a workspace allocates nothing after the first call, on trees and linkages.
#[test]
fn a_response_of_a_workspace_allocates_nothing() {
    let mut tested = 0;
    for case in [cases::of_the_zoo(4, 1), cases::at_random(4100, 20, 12)].concat() {
        let (system, contact) = (case.system(), case.contact());
        let (mut workspace, mut velocities) = (system.workspace(), Vec::new());
        let Ok(first) = workspace.respond(&contact, &mut velocities) else { continue };
        let before = allocations();
        let again = workspace.respond(&contact, &mut velocities);
        let allocated = allocations() - before;
        assert_eq!(again, Ok(first), "{}", case.name);
        let pose = system.pose(&percuss_dynamics::Configuration::zero(&case.mechanism));
        let is_accurate = pose
            .is_ok_and(|pose| pose.respond(&contact).is_ok_and(|response| response.dense_reason.is_none()));
        if is_accurate {
            assert_eq!(allocated, 0, "{}", case.name);
            tested += 1;
        }
    }
    assert!(tested > 20, "{tested} cases");
}

/// A configuration solved in lanes allocates nothing: as a single configuration, and after the first in a thread's
/// portion.
#[test]
fn a_batch_allocates_nothing() {
    let mechanism = percuss_oracle::zoo::six_r_arm();
    let mut rng = StdRng::seed_from_u64(42);
    let rows: Vec<f64> =
        (0..400).flat_map(|_| percuss_oracle::random::positions(&mut rng, &mechanism).concat()).collect();
    let link = *mechanism.order().last().expect("links");
    let contact = Contact::new(link, [0.05, -0.02, 0.03], [0.3, -0.5, 0.8]);
    let system =
        percuss_dynamics::System::new(mechanism, &percuss_dynamics::Conditions::new()).expect("fits");
    let mut batch = system.reference_or_open().batch(&contact).expect("a contact");
    let mut results = RowResults::new(400);
    for row in rows.chunks(6) {
        let before = allocations();
        let answer = batch.effective_mass(row).expect("six");
        let allocated = allocations() - before;
        assert!(answer.error.is_some() && allocated == 0, "{answer:?}: {allocated} allocations");
    }
    let rows = BatchPositions::Rows { values: &rows, stride: 6 };
    let mut of = |count: usize| {
        let before = allocations();
        batch.run(rows, results.columns().part(0..count), count).expect("enough");
        allocations() - before
    };
    // One allocation of a thread's workspace.
    assert!(of(8) > 0);
    assert_eq!((of(8), of(400)), (0, 0));
    assert!(results.masses.iter().all(|m| *m > 0.0));
}

#[test]
fn a_workspace_of_loops_allocates_nothing_and_agrees_with_a_pose() {
    let mut same = Gauge::new("workspace = pose, loops");
    let (mut asked, mut allocating) = (0, 0);
    for (number, linkage) in linkage::all().into_iter().enumerate() {
        let rig = Rig::new(linkage);
        let mut rng = StdRng::seed_from_u64(42 + number as u64);
        let mut poses = vec![rig.closed()];
        for i in 0..12 {
            poses.push(rig.reach(&poses[i], &rig.at((i as f64 + 0.5) / 12.0)));
        }
        let configurations: Vec<Vec<f64>> = poses.iter().map(|pose| pose.positions().to_vec()).collect();
        // Locks and held contacts constrain velocities only: the same closed positions are valid.
        for variant in 0..VARIANTS {
            let given = Imposed::at_random(&mut rng, &rig.mechanism, variant);
            let system = rig.with(&given.conditions);
            let plain = variant == 0;
            let name = format!("{}, {}", rig.name, given.name);
            let (on, against, point, normal) = percuss_oracle::random::contact(&mut rng, &rig.mechanism);
            let contact = Contact::new(on, point, normal).normal(Direction::Along(normal, Frame::World));
            let contact = against.map_or(contact, |other| contact.against(other));
            let all = answers(&mut system.workspace(), &contact, &configurations);
            for (pose, (answer, allocated)) in poses.iter().zip(all) {
                // Allocations come from the dense route, which is rarely used.
                (asked, allocating) = (asked + 1, allocating + usize::from(allocated > 0));
                if !plain {
                    continue;
                }
                let response = pose.respond(&contact).expect("an answer");
                assert_allocates_nothing(&name, allocated, &response);
                match (answer.expect("an answer"), response.effective_mass) {
                    (EffectiveMass::Finite(m), EffectiveMass::Finite(expected)) => {
                        same.relative(&name, m, expected, NEAR);
                    }
                    (got, expected) => assert_eq!(got, expected, "{name}"),
                }
            }
        }
    }
    same.report();
    println!("{allocating} of {asked} answers allocated");
    assert!(16 * allocating < asked, "{allocating} of {asked} answers allocated");
}

#[test]
fn an_impact_in_a_workspace_allocates_nothing() {
    let (mut asked, mut allocating) = (0, 0);
    for (number, linkage) in linkage::all().into_iter().enumerate() {
        let rig = Rig::new(linkage);
        let pose = rig.closed();
        let mut rng = StdRng::seed_from_u64(7 + number as u64);
        let (mut workspace, mut impact) = (ImpactWorkspace::new(&pose), RigidImpact::none());
        let mut here = workspace.at(&pose);
        for _ in 0..4 {
            let (on, against, point, normal) = percuss_oracle::random::contact(&mut rng, &rig.mechanism);
            let contact = Contact::new(on, point, normal).normal(Direction::Along(normal, Frame::World));
            let contact = against.map_or(contact, |other| contact.against(other));
            // For such a motion, the dense route computes the undetermined joints, which allocates.
            let remarks = pose.respond(&contact).map(|response| response.remarks).unwrap_or_default();
            if remarks.contains(&Remark::UndeterminedMotion) {
                continue;
            }
            let mut run = || here.impact_into(&contact, 1.0, 0.3, &mut impact).is_ok();
            if !run() {
                continue;
            }
            let before = allocations();
            assert!(run());
            (asked, allocating) = (asked + 1, allocating + usize::from(allocations() > before));
        }
    }
    println!("{allocating} of {asked} impacts allocated");
    // Allocations come from the dense route.
    assert!(asked > 60 && 10 * allocating < asked, "{allocating} of {asked} impacts allocated");
}

fn pose(case: &Case, system: &percuss_dynamics::System, flat: &[f64]) -> Pose {
    let mut positions = Vec::new();
    let mut rest = flat;
    for joint in case.mechanism.joints() {
        let (own, others) = rest.split_at(joint.kind().positions());
        positions.push(own.to_vec());
        rest = others;
    }
    Case { positions, ..case.clone() }.pose(system)
}
