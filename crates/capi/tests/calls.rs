//! The C functions called from Rust, for Miri, which checks every access to the caller's memory
//! (docs/reference/BOUNDS.md) and cannot run the C programs of `programs.rs`.

use percuss_c::*;
use std::ffi::{CStr, c_void};
use std::ptr::{null, null_mut};

const ARM: &str = include_str!("../../../models/planar_2r.urdf");
const FOUR_BAR: &str = include_str!("../../../models/four_bar.urdf");

/// Calls a function, which succeeds.
macro_rules! ok {
    ($call:expr) => {{
        // SAFETY: every pointer is null, or points to a local value or to an array of the stated length.
        let status = unsafe { $call };
        assert_eq!(status, PERCUSS_OK, "{}: {}", stringify!($call), message());
    }};
}

/// Calls a function, which fails with this status and a message that contains this text.
macro_rules! fails {
    ($call:expr, $status:expr, $text:expr) => {{
        // SAFETY: as for `ok`.
        let status = unsafe { $call };
        assert_eq!(status, $status, "{}: {}", stringify!($call), message());
        assert!(message().contains($text), "{}: {}", stringify!($call), message());
    }};
}

pub(crate) fn message() -> String {
    string(percuss_error_message())
}

pub(crate) fn string(text: *const std::ffi::c_char) -> String {
    // SAFETY: a text of the library, which ends with a zero byte.
    unsafe { CStr::from_ptr(text) }.to_str().expect("UTF-8").to_owned()
}

pub(crate) fn model(text: &str) -> *mut percuss_model {
    let mut model = null_mut();
    ok!(percuss_model_load_memory(c"model".as_ptr(), text.as_ptr().cast(), text.len(), &raw mut model));
    model
}

pub(crate) fn contact(
    model: *const percuss_model,
    link: &CStr,
    point: [f64; 3],
    normal: [f64; 3],
) -> percuss_contact {
    let mut contact = std::mem::MaybeUninit::uninit();
    ok!(percuss_contact_init(contact.as_mut_ptr()));
    // SAFETY: initialised by the call.
    let mut contact = unsafe { contact.assume_init() };
    ok!(percuss_model_find_link(model, link.as_ptr(), &raw mut contact.link));
    (contact.point, contact.normal) = (point, normal);
    contact
}

fn mass_of(pose: *const percuss_pose, contact: &percuss_contact, route: percuss_route) -> percuss_mass {
    let mut mass = std::mem::MaybeUninit::uninit();
    ok!(percuss_pose_effective_mass(pose, contact, route, mass.as_mut_ptr()));
    // SAFETY: initialised by the call.
    unsafe { mass.assume_init() }
}

fn assert_close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} {b}");
}

#[test]
fn names_and_joints_of_a_model() {
    let mut model = model(ARM);
    let (mut links, mut joints, mut positions, mut found) = (0, 0, 0, 0);
    ok!(percuss_model_counts(model, &raw mut links, &raw mut joints, &raw mut positions, null_mut()));
    assert_eq!((links, joints, positions), (3, 2, 2));
    let mut name = null();
    ok!(percuss_model_link_name(model, 2, &raw mut name));
    assert_eq!(string(name), "outer");
    fails!(percuss_model_link_name(model, 3, &raw mut name), PERCUSS_ERROR_NAME, "3");
    assert!(name.is_null());
    ok!(percuss_model_find_joint(model, c"elbow".as_ptr(), &raw mut found));
    fails!(percuss_model_find_joint(model, c"ellbow".as_ptr(), &raw mut found), PERCUSS_ERROR_NAME, "elbow");
    let mut joint = std::mem::MaybeUninit::<percuss_joint>::uninit();
    ok!(percuss_model_joint(model, found, joint.as_mut_ptr()));
    // SAFETY: initialised by the call.
    let joint = unsafe { joint.assume_init() };
    assert_eq!(
        (string(joint.name), joint.kind, joint.first_position),
        ("elbow".into(), PERCUSS_CONTINUOUS, 1)
    );
    ok!(percuss_model_diagnostic_count(model, &raw mut found));
    for index in 0..found {
        let mut diagnostic = std::mem::MaybeUninit::<percuss_diagnostic>::uninit();
        ok!(percuss_model_diagnostic(model, index, diagnostic.as_mut_ptr()));
        // SAFETY: initialised by the call.
        assert!(!string(unsafe { diagnostic.assume_init() }.message).is_empty());
    }
    ok!(percuss_model_free(&raw mut model));
    assert!(model.is_null());
    ok!(percuss_model_free(&raw mut model));
    let bytes = b"<robot\xff".as_ptr().cast();
    fails!(percuss_model_load_memory(c"x".as_ptr(), bytes, 7, &raw mut model), PERCUSS_ERROR_TEXT, "byte 6");
    fails!(percuss_model_load_memory(c"x".as_ptr(), bytes, 6, &raw mut model), PERCUSS_ERROR_LOAD, "x:");
    assert!(model.is_null());
}

/// A tree under conditions: poses with their matrices, responses, a workspace, batches in both layouts.
#[test]
fn an_arm_in_every_form() {
    let mut model = model(ARM);
    let tip = contact(model, c"outer", [0.4, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let (mut conditions, mut system, mut configuration, mut pose) =
        (null_mut(), null_mut(), null_mut(), null_mut());
    ok!(percuss_conditions_new(&raw mut conditions));
    ok!(percuss_conditions_base(conditions, PERCUSS_BASE_FIXED));
    ok!(percuss_conditions_armature(conditions, c"shoulder".as_ptr(), [0.3].as_ptr(), 1));
    ok!(percuss_system_new(model, conditions, &raw mut system));
    ok!(percuss_conditions_free(&raw mut conditions));
    ok!(percuss_configuration_new(model, &raw mut configuration));
    let right_angle = std::f64::consts::FRAC_PI_2;
    ok!(percuss_configuration_set(configuration, c"elbow".as_ptr(), &raw const right_angle, 1));
    ok!(percuss_pose_new(system, configuration, &raw mut pose));
    ok!(percuss_model_free(&raw mut model));
    let expected = 4.739_784_946_236_559;
    assert_close(mass_of(pose, &tip, PERCUSS_ROUTE_ARTICULATED).effective_mass, expected);
    assert_close(mass_of(pose, &tip, PERCUSS_ROUTE_DENSE).effective_mass, expected);

    let (mut by_rows, mut by_columns, mut row) = ([f64::NAN; 7], [f64::NAN; 7], [0.0; 2]);
    ok!(percuss_pose_mass_matrix(pose, by_rows.as_mut_ptr(), 6, PERCUSS_ROW_MAJOR, 4));
    ok!(percuss_pose_mass_matrix(pose, by_columns.as_mut_ptr(), 5, PERCUSS_COLUMN_MAJOR, 3));
    assert_eq!([by_rows[1], by_rows[4]], [by_columns[3], by_columns[1]]);
    assert!(by_rows[6].is_nan() && by_rows[2].is_nan() && by_columns[2].is_nan());
    let short = percuss_pose_mass_matrix;
    fails!(short(pose, by_rows.as_mut_ptr(), 5, PERCUSS_ROW_MAJOR, 4), PERCUSS_ERROR_LENGTH, "needs more");
    ok!(percuss_pose_contact_row(pose, &raw const tip, row.as_mut_ptr(), 2));

    let mut response = null_mut();
    ok!(percuss_pose_respond(pose, &raw const tip, PERCUSS_ROUTE_AUTO, &raw mut response));
    let (mut velocities, mut twist, mut links, mut rotors) = ([0.0; 2], [1.0; 6], [0.0; 3], [0.0; 2]);
    ok!(percuss_response_velocities(response, velocities.as_mut_ptr(), 2));
    assert_close(row[0] * velocities[0] + row[1] * velocities[1], 1.0);
    ok!(percuss_response_base_velocity(response, twist.as_mut_ptr()));
    assert_eq!(twist, [0.0; 6]);
    ok!(percuss_response_contributions(response, links.as_mut_ptr(), 3, rotors.as_mut_ptr(), 2));
    assert_close(links.iter().chain(&rotors).sum(), 1.0);
    let same = percuss_response_contributions;
    let both = links.as_mut_ptr();
    fails!(same(response, both, 3, both.wrapping_add(1), 2), PERCUSS_ERROR_OVERLAP, "links overlaps rotors");
    let mut against = std::mem::MaybeUninit::<percuss_mass>::uninit();
    ok!(percuss_response_against_mass(response, expected, against.as_mut_ptr()));
    // SAFETY: initialised by the call.
    assert_close(unsafe { against.assume_init() }.effective_mass, expected / 2.0);
    ok!(percuss_response_free(&raw mut response));

    let (mut assembly, mut workspace) = (null_mut(), null_mut());
    ok!(percuss_assembly_new(system, null(), &raw mut assembly));
    ok!(percuss_workspace_new(assembly, &raw mut workspace));
    let (mut outcome, mut m, mut remarks) = (-1, 0.0, 1);
    let at = [0.3, right_angle];
    let ask = percuss_workspace_effective_mass;
    ok!(ask(workspace, at.as_ptr(), 2, &raw const tip, &raw mut outcome, &raw mut m, &raw mut remarks));
    assert_eq!((outcome, remarks), (PERCUSS_FINITE, 0));
    assert_close(m, expected);
    let again = percuss_workspace_effective_mass_again;
    ok!(again(workspace, &raw const tip, &raw mut outcome, &raw mut m, null_mut()));
    assert_close(m, expected);
    ok!(percuss_workspace_set_base(workspace, [0.0, 0.0, 1.0].as_ptr(), [1.0, 0.0, 0.0, 0.0].as_ptr()));
    batches(assembly, workspace, &tip, expected);
    ok!(percuss_workspace_free(&raw mut workspace));
    ok!(percuss_assembly_free(&raw mut assembly));
    ok!(percuss_pose_free(&raw mut pose));
    ok!(percuss_configuration_free(&raw mut configuration));
    ok!(percuss_system_free(&raw mut system));
}

/// Counts its calls in `user`, and stops at the third.
unsafe extern "C" fn count_calls(_done: usize, user: *mut c_void) -> i32 {
    let calls: *mut i32 = user.cast();
    // SAFETY: `user` points to the number of the calling test.
    unsafe { *calls += 1 };
    // SAFETY: as above.
    i32::from(unsafe { *calls } > 2)
}

fn batches(
    assembly: *const percuss_assembly,
    workspace: *mut percuss_workspace,
    contact: &percuss_contact,
    expected: f64,
) {
    let (mut batch, mut of_workspace) = (null_mut(), null_mut());
    ok!(percuss_batch_new(assembly, contact, 1, &raw mut batch));
    ok!(percuss_workspace_batch(workspace, contact, 1, &raw mut of_workspace));
    let right_angle = std::f64::consts::FRAC_PI_2;
    // Five configurations in rows of three numbers, of which the last is not read, and in columns; one is not finite.
    let mut rows = [[0.1, right_angle, f64::INFINITY]; 5];
    rows[3][0] = f64::NAN;
    let rows = &rows.concat()[..14];
    let columns: Vec<f64> = (0..2).flat_map(|q| (0..6).map(move |c| rows[c.min(4) * 3 + q])).collect();
    let (mut outcomes, mut masses, mut errors, mut remarks) = ([9; 5], [0.0; 5], [0.0; 5], [9; 5]);
    let mut calls = 0_i32;
    let user = (&raw mut calls).cast();
    for (batch, values, layout, stride) in
        [(batch, rows, PERCUSS_ROW_MAJOR, 3), (of_workspace, &columns[..], PERCUSS_COLUMN_MAJOR, 6)]
    {
        let (to, m) = (outcomes.as_mut_ptr(), masses.as_mut_ptr());
        let (e, r) = (errors.as_mut_ptr(), remarks.as_mut_ptr());
        let (from, length) = (values.as_ptr(), values.len());
        let watch = Some(count_calls as unsafe extern "C" fn(usize, *mut c_void) -> i32);
        ok!(percuss_batch_run(batch, from, length, layout, stride, 5, to, m, e, r, watch, user));
        for at in [0, 1, 2, 4] {
            assert_close(masses[at], expected);
            assert!(errors[at] < 1e-12 && outcomes[at] == PERCUSS_FINITE && remarks[at] == 0);
        }
        // The result does not depend on the first joint; a position that is not finite has no answer.
        assert_eq!((outcomes[3], remarks[3]), (PERCUSS_NO_ANSWER, PERCUSS_REMARK_NOT_FINITE));
        assert!(masses[3].is_nan() && errors[3].is_nan());
    }
    assert_eq!(calls, 2);
    let (from, to, m, n) = (rows.as_ptr(), outcomes.as_mut_ptr(), masses.as_mut_ptr(), null_mut());
    let run = percuss_batch_run;
    fails!(
        run(batch, from, 13, PERCUSS_ROW_MAJOR, 3, 5, to, m, n, null_mut(), None, null_mut()),
        PERCUSS_ERROR_LENGTH,
        "positions"
    );
    fails!(
        run(batch, m, 5, PERCUSS_COLUMN_MAJOR, 3, 3, to, m, n, null_mut(), None, null_mut()),
        PERCUSS_ERROR_OVERLAP,
        "positions"
    );
    ok!(percuss_batch_free(&raw mut batch));
    ok!(percuss_batch_free(&raw mut of_workspace));
}

/// A linkage: closing of the loop, the rows of A, the positions of dependent joints.
#[test]
fn a_linkage() {
    let mut model = model(FOUR_BAR);
    let coupler = contact(model, c"coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
    let (mut system, mut configuration, mut pose, mut next) =
        (null_mut(), null_mut(), null_mut(), null_mut());
    ok!(percuss_system_new(model, null(), &raw mut system));
    ok!(percuss_configuration_new(model, &raw mut configuration));
    ok!(percuss_pose_new(system, configuration, &raw mut pose));
    assert_close(mass_of(pose, &coupler, PERCUSS_ROUTE_AUTO).effective_mass, 417_304.0 / 6125.0);
    let angle = 0.05;
    ok!(percuss_configuration_set(configuration, c"crank_hinge".as_ptr(), &raw const angle, 1));
    ok!(percuss_pose_follow(pose, configuration, &raw mut next));
    let (mut positions, mut rows) = ([0.0; 3], 0);
    ok!(percuss_pose_positions(next, positions.as_mut_ptr(), 3));
    assert!((positions[0] - angle).abs() < 1e-14 && positions[1] != 0.0);
    ok!(percuss_pose_constraint_rows(next, &raw mut rows));
    let mut entries = vec![0.0; rows * 3];
    ok!(percuss_pose_constraint_matrix(next, entries.as_mut_ptr(), rows * 3, PERCUSS_ROW_MAJOR, 3));
    assert_eq!(rows, 5);
    let mut open = [0.05, 0.0, 0.0];
    let (mut assembly, mut workspace, mut outcome, mut m) = (null_mut(), null_mut(), 0, 0.0);
    ok!(percuss_assembly_new(system, null(), &raw mut assembly));
    ok!(percuss_workspace_new(assembly, &raw mut workspace));
    let ask = percuss_workspace_effective_mass;
    let remarks = null_mut();
    fails!(
        ask(workspace, open.as_ptr(), 3, &raw const coupler, &raw mut outcome, &raw mut m, remarks),
        PERCUSS_ERROR_ASSEMBLY,
        "open"
    );
    open = positions;
    ok!(ask(workspace, open.as_ptr(), 3, &raw const coupler, &raw mut outcome, &raw mut m, remarks));
    let expected = mass_of(next, &coupler, PERCUSS_ROUTE_AUTO).effective_mass;
    assert!((m - expected).abs() < 1e-9 * expected, "{m} {expected}");
    ok!(percuss_workspace_free(&raw mut workspace));
    ok!(percuss_assembly_free(&raw mut assembly));
    ok!(percuss_pose_free(&raw mut next));
    ok!(percuss_pose_free(&raw mut pose));
    ok!(percuss_configuration_free(&raw mut configuration));
    ok!(percuss_system_free(&raw mut system));
    ok!(percuss_model_free(&raw mut model));
}

/// Two carts on rails, bound to one another twice.
#[test]
fn matrices_of_the_caller() {
    let (values, rows) = ([2.0, 0.0, f64::NAN, 0.0, 3.0], [1.0, 2.0, -1.0, -2.0]);
    let matrix = |values: &[f64], leading_dimension, layout| percuss_matrix {
        values: values.as_ptr(),
        length: values.len(),
        rows: 2,
        columns: 2,
        leading_dimension,
        layout,
        reserved: 0,
    };
    let (mass, a) = (matrix(&values, 3, PERCUSS_ROW_MAJOR), matrix(&rows, 2, PERCUSS_COLUMN_MAJOR));
    let mut options = std::mem::MaybeUninit::<percuss_matrix_options>::uninit();
    ok!(percuss_matrix_options_init(options.as_mut_ptr()));
    // SAFETY: initialised by the call.
    let mut options = unsafe { options.assume_init() };
    let lengths = [1.0, 1.0];
    (options.lengths, options.length_count) = (lengths.as_ptr(), 2);
    let (mut found, mut rank) = (std::mem::MaybeUninit::uninit(), std::mem::MaybeUninit::uninit());
    let (row, mut velocities, mut redundant) = ([1.0, 0.0], [0.0; 2], [7_u8; 2]);
    let (j, v, r) = (row.as_ptr(), velocities.as_mut_ptr(), redundant.as_mut_ptr());
    let ask = percuss_effective_mass;
    ok!(ask(
        &raw const mass,
        j,
        2,
        &raw const a,
        &raw const options,
        found.as_mut_ptr(),
        v,
        rank.as_mut_ptr(),
        r
    ));
    // SAFETY: initialised by the call.
    let found: percuss_mass = unsafe { found.assume_init() };
    // SAFETY: as above.
    let rank: percuss_rank = unsafe { rank.assume_init() };
    assert_close(found.effective_mass, 5.0);
    assert_eq!((rank.rank, rank.redundant, redundant.iter().sum::<u8>()), (1, 1, 1));
    assert_close(velocities[0], velocities[1]);
    let mut to = found;
    fails!(
        ask(&raw const mass, v, 2, null(), null(), &raw mut to, v, null_mut(), null_mut()),
        PERCUSS_ERROR_OVERLAP,
        "velocities overlaps contact_row"
    );
    let short = percuss_matrix { length: 4, ..mass };
    fails!(
        ask(&raw const short, j, 2, null(), null(), &raw mut to, null_mut(), null_mut(), null_mut()),
        PERCUSS_ERROR_LENGTH,
        "mass"
    );
}

#[test]
fn dampers_of_the_laws() {
    let spring = percuss_spring { effective_mass: 2.0, stiffness: 1e5, exponent: 1.0 };
    for law in 0..percuss_law_count() as percuss_law {
        let (mut name, mut found) = (null(), -1);
        ok!(percuss_law_name(law, &raw mut name));
        ok!(percuss_law_find(name, &raw mut found));
        assert_eq!(found, law);
    }
    let (mut damper, mut impact) = (std::mem::MaybeUninit::uninit(), std::mem::MaybeUninit::uninit());
    let (law, separation, mut e) = (PERCUSS_LAW_KELVIN_VOIGT, PERCUSS_FORCE_VANISHES, 0.0);
    ok!(percuss_law_damper(law, &raw const spring, 0.5, 1.0, separation, damper.as_mut_ptr()));
    // SAFETY: initialised by the call.
    let damper: percuss_damper = unsafe { damper.assume_init() };
    ok!(percuss_damper_restitution(&raw const damper, &raw const spring, 1.0, &raw mut e));
    assert!((e - 0.5).abs() < 1e-9);
    ok!(percuss_damper_impact(&raw const damper, &raw const spring, 1.0, impact.as_mut_ptr()));
    // SAFETY: initialised by the call.
    let impact: percuss_impact = unsafe { impact.assume_init() };
    assert!((impact.rebound_speed - 0.5).abs() < 1e-9);
}

/// Null, misaligned and foreign pointers.
#[test]
fn pointers_that_are_none() {
    let mut model = model(ARM);
    let (mut system, mut count) = (null_mut(), 0);
    fails!(percuss_system_new(null(), null(), &raw mut system), PERCUSS_ERROR_NULL, "percuss_model is null");
    fails!(percuss_system_new(model.cast_const(), null(), null_mut()), PERCUSS_ERROR_NULL, "handle");
    fails!(percuss_model_find_link(model, null(), &raw mut count), PERCUSS_ERROR_NULL, "name");
    fails!(percuss_system_coordinates(null(), &raw mut count), PERCUSS_ERROR_NULL, "percuss_system");
    fails!(percuss_system_coordinates(model.cast(), &raw mut count), PERCUSS_ERROR_HANDLE, "no handle");
    let numbers = [0_u64; 4];
    let inside = numbers.as_ptr().cast::<u8>().wrapping_add(1);
    fails!(percuss_system_coordinates(inside.cast(), &raw mut count), PERCUSS_ERROR_NULL, "not aligned");
    let (mut configuration, values) = (null_mut(), [0.0; 2]);
    ok!(percuss_configuration_new(model, &raw mut configuration));
    let misaligned = values.as_ptr().cast::<u8>().wrapping_add(4).cast();
    let set = percuss_configuration_set_positions;
    fails!(set(configuration, misaligned, 1), PERCUSS_ERROR_NULL, "not aligned");
    fails!(set(configuration, values.as_ptr(), usize::MAX), PERCUSS_ERROR_LENGTH, "memory");
    ok!(percuss_configuration_free(&raw mut configuration));
    ok!(percuss_model_free(&raw mut model));
}
