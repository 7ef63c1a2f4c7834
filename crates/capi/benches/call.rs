//! What the C interface costs: one m̄ from a warm workspace, called as a C program calls it, over the same call in Rust; CPU time of
//! the thread, the two in turn. `cargo bench -p percuss-capi --bench call`

use cpu_time::ThreadTime;
use percuss::{Conditions, Contact, EffectiveMass, LoadOptions, Source, System, load};
use percuss_c::*;
use std::fmt::Write;
use std::hint::black_box;
use std::ptr::{null, null_mut};

/// Calls of a block, and blocks of each kind.
const CALLS: usize = 4096;
const BLOCKS: usize = 120;

/// An arm of so many hinges, their axes in turn along z, y and x.
fn arm(hinges: usize) -> String {
    let mut text = String::from("<robot name=\"arm\"><link name=\"link_0\"/>");
    for i in 1..=hinges {
        let axis = ["0 0 1", "0 1 0", "1 0 0"][i % 3];
        let _ = write!(
            text,
            "<link name=\"link_{i}\"><inertial><origin xyz=\"0.1 0.02 0.05\"/><mass value=\"2\"/><inertia ixx=\"0.01\" \
             ixy=\"0\" ixz=\"0\" iyy=\"0.02\" iyz=\"0\" izz=\"0.03\"/></inertial></link><joint name=\"joint_{i}\" \
             type=\"continuous\"><parent link=\"link_{}\"/><child link=\"link_{i}\"/><origin xyz=\"0.2 0 0.1\"/><axis \
             xyz=\"{axis}\"/></joint>",
            i - 1
        );
    }
    text + "</robot>"
}

/// Nanoseconds a call.
fn time(mut call: impl FnMut(usize)) -> f64 {
    let start = ThreadTime::now();
    (0..CALLS).for_each(&mut call);
    start.elapsed().as_nanos() as f64 / CALLS as f64
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn ok(status: percuss_status) {
    assert_eq!(status, PERCUSS_OK);
}

fn compare(name: &str, text: &str, link: &str) {
    let mechanism = load(&Source::from_text(name, text), &LoadOptions::default()).expect("a model").mechanism;
    let count: usize = mechanism.joints().iter().map(|joint| joint.kind().positions()).sum();
    let on = mechanism.find_link(link).expect("a link");
    let contact = Contact::new(on, [0.05, -0.02, 0.03], [0.3, -0.5, 0.8]);
    let system = System::new(mechanism, &Conditions::new()).expect("a system");
    let reference = system.reference().expect("it closes");
    let mut workspace = reference.workspace();
    // Of a linkage the closed pose alone; of a tree, anything.
    let closed = system.pose(&system.configuration()).expect("a pose").positions().to_vec();
    let spread = if reference.groups().is_empty() { 1.0 } else { 0.0 };
    let positions: Vec<Vec<f64>> = (0..256)
        .map(|i| (0..count).map(|q| closed[q] + spread * ((i * 7 + q * 13) as f64).sin()).collect())
        .collect();

    let (mut model, mut compiled, mut assembly, mut room) = (null_mut(), null_mut(), null_mut(), null_mut());
    let in_c = percuss_contact {
        link: on.index(),
        against: PERCUSS_GROUND,
        point: contact.point.into(),
        normal: [0.3, -0.5, 0.8],
        normal_given: PERCUSS_NORMAL_LINK,
        toward: 0,
    };
    // SAFETY: every pointer is to a value of this function, or a handle that these calls made.
    unsafe {
        ok(percuss_model_load_memory(c"arm.urdf".as_ptr(), text.as_ptr().cast(), text.len(), &mut model));
    }
    // SAFETY: as above.
    unsafe { ok(percuss_system_new(model, null(), &mut compiled)) };
    // SAFETY: as above.
    unsafe { ok(percuss_assembly_new(compiled, null(), &mut assembly)) };
    // SAFETY: as above.
    unsafe { ok(percuss_workspace_new(assembly, &mut room)) };
    // As a C program has it: nothing is known of the function but its address.
    let call = black_box(
        percuss_workspace_effective_mass
            as unsafe extern "C" fn(*mut _, *const f64, usize, *const _, *mut i32, *mut f64) -> i32,
    );
    let (mut outcome, mut mass) = (0, 0.0);
    let mut by_rust = |i: usize| {
        workspace.set_positions(black_box(&positions[i % 256])).expect("positions that fit");
        black_box(workspace.effective_mass(black_box(&contact))).expect("an answer")
    };
    let mut by_c = |i: usize| {
        let q = black_box(&positions[i % 256]);
        // SAFETY: as above; q has count numbers.
        ok(unsafe { call(room, q.as_ptr(), q.len(), black_box(&in_c), &mut outcome, &mut mass) });
        black_box(mass)
    };
    // The value is asserted once: both answer the same question.
    for i in 0..256 {
        let EffectiveMass::Finite(expected) = by_rust(i) else { panic!("a finite answer") };
        assert_eq!(by_c(i), expected);
    }
    let (mut rust, mut c, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
    for block in 0..BLOCKS {
        // Each first as often as the other.
        let (r, s) = if block % 2 == 0 {
            let r = time(|i| {
                black_box(by_rust(i));
            });
            (
                r,
                time(|i| {
                    black_box(by_c(i));
                }),
            )
        } else {
            let s = time(|i| {
                black_box(by_c(i));
            });
            (
                time(|i| {
                    black_box(by_rust(i));
                }),
                s,
            )
        };
        rust.push(r);
        c.push(s);
        ratios.push(s / r);
    }
    let (rust, c, ratio) = (median(&mut rust), median(&mut c), median(&mut ratios));
    println!("{name:12} Rust {rust:8.1} ns, C {c:8.1} ns, ratio {ratio:.3}");
    // SAFETY: made above, used by nobody any more.
    unsafe { ok(percuss_workspace_free(&mut room)) };
    // SAFETY: as above.
    unsafe { ok(percuss_assembly_free(&mut assembly)) };
    // SAFETY: as above.
    unsafe { ok(percuss_system_free(&mut compiled)) };
    // SAFETY: as above.
    unsafe { ok(percuss_model_free(&mut model)) };
}

fn main() {
    compare("2 hinges", &arm(2), "link_2");
    compare("7 hinges", &arm(7), "link_7");
    compare("30 hinges", &arm(30), "link_30");
    compare("four-bar", include_str!("../../../models/four_bar.urdf"), "coupler");
}
