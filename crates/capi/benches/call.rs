//! Cost of the C interface: m̄ from a warm workspace by a C call, relative to the same call in Rust. CPU time of the
//! thread, alternating calls, the least of many blocks each.
//!
//!     packaging/install.sh --prefix PREFIX
//!     PERCUSS_LIBRARY=PREFIX/lib/libpercuss.so cargo bench -p percuss-capi --bench call
//!
//! Without PERCUSS_LIBRARY the functions linked into this program are called: the cost of the interface without the
//! cost of a separate library.

use cpu_time::ThreadTime;
use percuss::{Conditions, Contact, EffectiveMass, LoadOptions, Source, System, load};
use percuss_c::*;
use std::ffi::{CString, c_char, c_int, c_void};
use std::fmt::Write;
use std::hint::black_box;
use std::ptr::{null, null_mut};

/// Calls per block, and blocks of each kind.
const CALLS: usize = 4096;
const BLOCKS: usize = 120;

/// Serial arm with a number of hinges, their axes in turn along z, y and x.
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

/// Nanoseconds per call.
fn time(mut call: impl FnMut(usize)) -> f64 {
    let start = ThreadTime::now();
    (0..CALLS).for_each(&mut call);
    start.elapsed().as_nanos() as f64 / CALLS as f64
}

fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

unsafe extern "C" {
    fn dlopen(path: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
}

/// Resolve everything at once.
const RTLD_NOW: c_int = 2;

/// Constructor of a handle from another handle and an argument that is null here.
type Make<From, To> = unsafe extern "C" fn(*const From, *const c_void, *mut *mut To) -> percuss_status;
type Load =
    unsafe extern "C" fn(*const c_char, *const c_char, usize, *mut *mut percuss_model) -> percuss_status;
type MakeWorkspace =
    unsafe extern "C" fn(*const percuss_assembly, *mut *mut percuss_workspace) -> percuss_status;
type Ask = unsafe extern "C" fn(
    *mut percuss_workspace,
    *const f64,
    usize,
    *const percuss_contact,
    *mut percuss_outcome,
    *mut f64,
    *mut u32,
) -> percuss_status;

/// Functions under test, of the library or of this program.
struct Interface {
    load: Load,
    system: Make<percuss_model, percuss_system>,
    assembly: Make<percuss_system, percuss_assembly>,
    workspace: MakeWorkspace,
    effective_mass: Ask,
}

/// Address of a function in the library; without a library, the linked function.
fn address(library: *mut c_void, name: &str, linked: *const c_void) -> *const c_void {
    if library.is_null() {
        return linked;
    }
    let text = CString::new(name).expect("a name");
    // SAFETY: the library was opened and is never closed; the name ends with a zero byte.
    let found = unsafe { dlsym(library, text.as_ptr()) };
    assert!(!found.is_null(), "the library has no {name}");
    found
}

macro_rules! function {
    ($library:expr, $name:ident as $kind:ty) => {{
        let linked = $name as *const c_void;
        let found = black_box(address($library, stringify!($name), linked));
        // SAFETY: both are the function of this name in one version of the interface; only the types of the pointers to
        // conditions and guesses differ, and these pointers are null here.
        unsafe { std::mem::transmute::<*const c_void, $kind>(found) }
    }};
}

impl Interface {
    fn new() -> Self {
        let mut library = std::ptr::null_mut();
        if let Ok(path) = std::env::var("PERCUSS_LIBRARY") {
            let text = CString::new(path.clone()).expect("a path");
            // SAFETY: the path ends with a zero byte.
            library = unsafe { dlopen(text.as_ptr(), RTLD_NOW) };
            assert!(!library.is_null(), "{path} cannot be opened");
        }
        Self {
            load: function!(library, percuss_model_load_memory as Load),
            system: function!(library, percuss_system_new as Make<percuss_model, percuss_system>),
            assembly: function!(library, percuss_assembly_new as Make<percuss_system, percuss_assembly>),
            workspace: function!(library, percuss_workspace_new as MakeWorkspace),
            effective_mass: function!(library, percuss_workspace_effective_mass as Ask),
        }
    }
}

fn ok(status: percuss_status) {
    assert_eq!(status, PERCUSS_OK);
}

fn compare(c: &Interface, name: &str, text: &str, link: &str) {
    let mechanism = load(&Source::from_text(name, text), &LoadOptions::default()).expect("a model").mechanism;
    let count: usize = mechanism.joints().iter().map(|joint| joint.kind().positions()).sum();
    let on = mechanism.find_link(link).expect("a link");
    let contact = Contact::new(on, [0.05, -0.02, 0.03], [0.3, -0.5, 0.8]);
    let system = System::new(mechanism, &Conditions::new()).expect("a system");
    let reference = system.reference().expect("it closes");
    let mut workspace = reference.workspace();
    // A linkage is tested at its closed pose only, a tree at varied positions.
    let closed = system.pose(&system.configuration()).expect("a pose").positions().to_vec();
    let spread = if reference.groups().is_empty() { 1.0 } else { 0.0 };
    let positions: Vec<Vec<f64>> = (0..256)
        .map(|i| (0..count).map(|q| closed[q] + spread * ((i * 7 + q * 13) as f64).sin()).collect())
        .collect();

    let (mut model, mut compiled, mut assembly, mut workspace_handle) =
        (null_mut(), null_mut(), null_mut(), null_mut());
    let in_c = percuss_contact {
        link: on.index(),
        against: PERCUSS_GROUND,
        point: contact.point.into(),
        normal: [0.3, -0.5, 0.8],
        normal_given: PERCUSS_NORMAL_LINK,
        toward: 0,
    };
    // SAFETY: every pointer is to a value of this function, or a handle from these calls; the handles stay valid until
    // the program ends.
    unsafe { ok((c.load)(c"arm.urdf".as_ptr(), text.as_ptr().cast(), text.len(), &mut model)) };
    // SAFETY: as above.
    unsafe { ok((c.system)(model, null(), &mut compiled)) };
    // SAFETY: as above.
    unsafe { ok((c.assembly)(compiled, null(), &mut assembly)) };
    // SAFETY: as above.
    unsafe { ok((c.workspace)(assembly, &mut workspace_handle)) };
    let call = c.effective_mass;
    let (mut outcome, mut mass) = (0, 0.0);
    let mut by_rust = |i: usize| {
        workspace.set_positions(black_box(&positions[i % 256])).expect("positions that fit");
        black_box(workspace.effective_mass(black_box(&contact))).expect("an answer")
    };
    let mut by_c = |i: usize| {
        let q = black_box(&positions[i % 256]);
        // SAFETY: as above; q has count numbers.
        ok(unsafe {
            call(
                workspace_handle,
                q.as_ptr(),
                q.len(),
                black_box(&in_c),
                &mut outcome,
                &mut mass,
                std::ptr::null_mut(),
            )
        });
        black_box(mass)
    };
    // The values are compared once before timing.
    for i in 0..256 {
        let EffectiveMass::Finite(expected) = by_rust(i) else { panic!("a finite answer") };
        assert_eq!(by_c(i), expected);
    }
    let (mut rust, mut c) = (Vec::new(), Vec::new());
    for block in 0..BLOCKS {
        // Each kind runs first in half of the blocks.
        let (r, s) = if block % 2 == 0 {
            let r = time(|i| {
                let _ = black_box(by_rust(i));
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
                    let _ = black_box(by_rust(i));
                }),
                s,
            )
        };
        rust.push(r);
        c.push(s);
    }
    let (rust, c) = (least(&rust), least(&c));
    println!("{name:12} Rust {rust:8.1} ns, C {c:8.1} ns, ratio {:.3}", c / rust);
}

fn main() {
    let c = Interface::new();
    compare(&c, "2 hinges", &arm(2), "link_2");
    compare(&c, "7 hinges", &arm(7), "link_7");
    compare(&c, "30 hinges", &arm(30), "link_30");
    compare(&c, "four-bar", include_str!("../../../models/four_bar.urdf"), "coupler");
    compare(&c, "double wishbone", include_str!("../../../models/double_wishbone.urdf"), "wheel_centre");
}
