//! Every finding × every output of the library and of the C interface: poses, workspaces, batches, paths, maps, and reports as JSON. The
//! outputs of the command are in `crates/cli/tests/limits/findings.rs`, those of Python in `crates/python/tests/test_findings.py`.

#[path = "../../cli/tests/limits/finding_cases.rs"]
mod finding_cases;

use crate::calls::{contact, message, model, string};
use finding_cases::{Case, cases, codes};
use percuss::{
    Accept, BatchPositions, Conditions, Contact, JointId, LoadOptions, Pose, RemarkFlags, RowResults, Source,
    System, load,
};
use percuss_c::*;
use std::ffi::CString;
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};

/// Flags of the findings in results without text.
const FLAGS: [(&str, RemarkFlags); 15] = [
    ("drawn-open", RemarkFlags::DRAWN_OPEN),
    ("driver-off-zero", RemarkFlags::DRIVER_OFF_ZERO),
    ("indefinite-mass-matrix", RemarkFlags::INDEFINITE_MASS_MATRIX),
    ("inexact-loops", RemarkFlags::INEXACT_LOOPS),
    ("massless-motions", RemarkFlags::MASSLESS_MOTIONS),
    ("nearly-immovable", RemarkFlags::NEARLY_IMMOVABLE),
    ("off-target", RemarkFlags::OFF_TARGET),
    ("open-gap", RemarkFlags::OPEN_GAP),
    ("outside-limits", RemarkFlags::OUTSIDE_LIMITS),
    ("singular-pose", RemarkFlags::SINGULAR_POSE),
    ("uncertain-mass", RemarkFlags::UNCERTAIN_MASS),
    ("unclear-rank", RemarkFlags::UNCLEAR_MOBILITY),
    ("unclear-rank-here", RemarkFlags::UNCLEAR_RANK),
    ("undetermined-motion", RemarkFlags::UNDETERMINED_MOTION),
    ("weakly-constrained", RemarkFlags::WEAKLY_CONSTRAINED),
];

/// Findings without a flag, and the reason. They are in the reports of all interfaces.
const WITHOUT_FLAG: [(&str, &str); 14] = [
    ("drivers-chosen", "a note about the drivers of the assembly"),
    (
        "far-from-guess",
        "about the guess of a question; the library has its own distance, percuss_pose_positions",
    ),
    ("far-point", "about the size of the model, which a program knows"),
    ("hold-pulls", "about held contacts of a question"),
    ("hold-undetermined", "about held contacts of a question"),
    ("immovable-mechanism", "about the mass against a body; the outcome has it"),
    ("joint-springs", "a note about the file: Joint::spring"),
    ("many-turns", "a continuous joint has no limits; a number in a program is in rad"),
    ("point-converted", "about frames of a question"),
    ("point-mass-base", "about the base of a question"),
    ("reversed-axis", "a note about the file"),
    ("rigid-loops", "the outcome is immovable without a degree of freedom; the library has `RigidLoops`"),
    ("stop-passed", "about the travel of a question"),
    ("unused-guess", "about the guess of a question"),
];

/// Findings about the search of a pose, which results at given positions do not have.
const ABOUT_SEARCH: [RemarkFlags; 2] = [RemarkFlags::DRIVER_OFF_ZERO, RemarkFlags::OFF_TARGET];

/// All of some flags.
fn union(flags: &[RemarkFlags]) -> RemarkFlags {
    flags.iter().fold(RemarkFlags::NONE, |all, one| all | *one)
}

/// Flags that a workspace does not have: those of a search; of the error, which has no part by closing.
fn not_in_workspaces(code: &str) -> RemarkFlags {
    let error = if code == "uncertain-mass" { RemarkFlags::NONE } else { RemarkFlags::UNCERTAIN_MASS };
    union(&ABOUT_SEARCH) | error
}

/// Findings of a case in the outputs of the library without text: all flags of each output, and those that the output cannot have.
fn library(case: &Case) -> Vec<(&'static str, RemarkFlags, RemarkFlags)> {
    let accept = Accept { indefinite_inertia: case.accepted().is_some(), ..Accept::default() };
    let options = LoadOptions { accept, ..LoadOptions::default() };
    let mechanism = load(&Source::from_text("model.urdf", &case.model), &options).expect("a model").mechanism;
    let system = System::new(mechanism, &Conditions::new()).expect("a system");
    let mechanism = system.mechanism();
    let mut configuration = system.configuration();
    let (mut link, mut point, mut normal, mut named) = (None, [0.0; 3], [0.0; 3], None);
    let mut joint = None;
    for (key, value) in case.flags() {
        match key.as_str() {
            "link" => link = Some(mechanism.find_link(value).expect("a link")),
            "point" => point = three(value),
            "normal" => normal = three(value),
            "at" => {
                named =
                    Some(Contact::named(mechanism.find_contact(value).expect("a contact"), mechanism.root()))
            }
            "set" => {
                let (name, values) = name_and_numbers(value);
                configuration.set(name, &values).expect("a joint");
                joint = mechanism
                    .find_joint(name)
                    .ok()
                    .filter(|_| values.len() == 1)
                    .zip(values.first().copied());
            }
            other => panic!("{}: {other} has no flag", case.code),
        }
    }
    let contact = named.unwrap_or_else(|| Contact::new(link.expect("a link"), point, normal));
    let pose = system.pose(&configuration).expect("a pose");
    let response = pose.respond(&contact).expect("a response");
    let none = RemarkFlags::NONE;
    let mut outputs = vec![("pose", response.remark_flags(), none)];
    let mut workspace = pose.assembly().workspace();
    workspace.set_positions(pose.positions()).expect("positions");
    let _ = workspace.effective_mass(&contact);
    let (not_in_rows, not_in_response) = (union(&ABOUT_SEARCH), not_in_workspaces(case.code));
    // The error is part of the response alone.
    outputs.push(("workspace", workspace.remarks(), not_in_rows | RemarkFlags::UNCERTAIN_MASS));
    let responded = workspace.respond(&contact, &mut Vec::new()).expect("a response").remarks;
    outputs.push(("response of a workspace", responded, not_in_response));
    let mut batch = pose.assembly().batch(&contact).expect("a batch");
    outputs.push(("row", batch.effective_mass(pose.positions()).expect("a row").remarks, not_in_rows));
    let rows = [pose.positions(); 3].concat();
    let mut results = RowResults::new(3);
    let layout = BatchPositions::Rows { values: &rows, stride: pose.positions().len() };
    batch.run(layout, results.columns(), 2).expect("rows");
    (0..3).for_each(|row| outputs.push(("batch", results.answer(row).remarks, not_in_rows)));
    if let Some(flags) = joint.and_then(|(joint, value)| on_path(&pose, &contact, joint, value)) {
        outputs.push(("path", flags, none));
    }
    outputs
}

/// Findings of a path of a joint at its present position; `None` without such a path.
fn on_path(pose: &Pose, contact: &Contact, joint: JointId, value: f64) -> Option<RemarkFlags> {
    let mut path = pose.driven_path(contact, &[joint]).expect("a contact")?;
    let (mut answers, mut positions) = (Vec::new(), Vec::new());
    path.follow(&[value], &mut answers, &mut positions);
    Some(answers.first()?.remarks)
}

/// Numbers between commas.
fn numbers(text: &str) -> Vec<f64> {
    text.split(',').map(|number| number.parse().expect("a number")).collect()
}

fn three(text: &str) -> [f64; 3] {
    numbers(text).try_into().expect("three numbers")
}

/// Joint and positions of `JOINT=NUMBERS`.
fn name_and_numbers(text: &str) -> (&str, Vec<f64>) {
    let (joint, values) = text.split_once('=').expect("a joint");
    (joint, numbers(values))
}

/// Findings about the contact, which are no findings about a pose.
const ABOUT_CONTACTS: [RemarkFlags; 7] = [
    RemarkFlags::INDEFINITE_MASS_MATRIX,
    RemarkFlags::MASSLESS_MOTIONS,
    RemarkFlags::NEARLY_IMMOVABLE,
    RemarkFlags::OPEN_GAP,
    RemarkFlags::UNCERTAIN_MASS,
    RemarkFlags::UNDETERMINED_MOTION,
    RemarkFlags::UNKNOWN_ERROR,
];

/// As [`library`], from the C interface.
fn c_interface(case: &Case, model: *const percuss_model) -> Vec<(&'static str, RemarkFlags, RemarkFlags)> {
    let (mut system, mut configuration, mut pose) = (null_mut(), null_mut(), null_mut());
    ok!(percuss_system_new(model, null(), &raw mut system));
    ok!(percuss_configuration_new(model, &raw mut configuration));
    let (mut link, mut point, mut normal, mut named, mut joint) =
        (CString::default(), [0.0; 3], [0.0; 3], None, None);
    for (key, value) in case.flags() {
        let text = |name: &str| CString::new(name).expect("a name");
        match key.as_str() {
            "link" => link = text(value),
            "point" => point = three(value),
            "normal" => normal = three(value),
            "at" => {
                let mut found = MaybeUninit::uninit();
                ok!(percuss_model_find_contact(model, text(value).as_ptr(), found.as_mut_ptr(), null_mut()));
                // SAFETY: initialised by the call.
                named = Some(unsafe { found.assume_init() });
            }
            _ => {
                let (name, values) = name_and_numbers(value);
                let name = text(name);
                ok!(percuss_configuration_set(configuration, name.as_ptr(), values.as_ptr(), values.len()));
                let mut index = 0;
                ok!(percuss_model_find_joint(model, name.as_ptr(), &raw mut index));
                joint = (values.len() == 1).then_some((index, values[0]));
            }
        }
    }
    let contact = named.unwrap_or_else(|| contact(model, &link, point, normal));
    let contact = &raw const contact;
    ok!(percuss_pose_new(system, configuration, &raw mut pose));
    let (mut links, mut joints, mut width, mut speeds) = (0, 0, 0, 0);
    ok!(percuss_model_counts(model, &raw mut links, &raw mut joints, &raw mut width, &raw mut speeds));
    let mut positions = vec![0.0; width];
    ok!(percuss_pose_positions(pose, positions.as_mut_ptr(), width));
    let flags = RemarkFlags::from_bits;
    let none = RemarkFlags::NONE;
    let mut outputs = Vec::new();

    let mut mass = MaybeUninit::<percuss_mass>::uninit();
    ok!(percuss_pose_effective_mass(pose, contact, PERCUSS_ROUTE_AUTO, mass.as_mut_ptr()));
    // SAFETY: initialised by the call.
    outputs.push(("percuss_pose_effective_mass", flags(unsafe { mass.assume_init() }.remarks), none));
    let mut response = null_mut();
    ok!(percuss_pose_respond(pose, contact, PERCUSS_ROUTE_AUTO, &raw mut response));
    ok!(percuss_response_mass(response, mass.as_mut_ptr()));
    // SAFETY: as above.
    outputs.push(("percuss_response_mass", flags(unsafe { mass.assume_init() }.remarks), none));
    ok!(percuss_response_free(&raw mut response));
    let mut state = MaybeUninit::<percuss_pose_state>::uninit();
    ok!(percuss_pose_describe(pose, state.as_mut_ptr()));
    let (not_in_rows, not_in_response) = (union(&ABOUT_SEARCH), not_in_workspaces(case.code));
    // SAFETY: as above.
    outputs.push((
        "percuss_pose_describe",
        flags(unsafe { state.assume_init() }.remarks),
        union(&ABOUT_CONTACTS),
    ));

    let (mut assembly, mut workspace, mut batch) = (null_mut(), null_mut(), null_mut());
    ok!(percuss_assembly_new(system, null(), &raw mut assembly));
    ok!(percuss_workspace_new(assembly, &raw mut workspace));
    let (at, mut outcome, mut m, mut remarks) = (positions.as_ptr(), 0, 0.0, 0);
    ok!(percuss_workspace_effective_mass(
        workspace,
        at,
        width,
        contact,
        &raw mut outcome,
        &raw mut m,
        &raw mut remarks
    ));
    outputs.push((
        "percuss_workspace_effective_mass",
        flags(remarks),
        not_in_rows | RemarkFlags::UNCERTAIN_MASS,
    ));
    let (mut own, mut velocities) = (MaybeUninit::<percuss_workspace_response>::uninit(), vec![0.0; speeds]);
    let to = velocities.as_mut_ptr();
    ok!(percuss_workspace_respond(workspace, at, width, contact, own.as_mut_ptr(), to, speeds));
    // SAFETY: as above.
    outputs.push(("percuss_workspace_respond", flags(unsafe { own.assume_init() }.remarks), not_in_response));
    ok!(percuss_batch_new(assembly, contact, 1, &raw mut batch));
    let rows = [&positions[..]; 3].concat();
    let (mut outcomes, mut masses, mut errors, mut of_rows) = ([0; 3], [0.0; 3], [0.0; 3], [0; 3]);
    ok!(percuss_batch_run(
        batch,
        rows.as_ptr(),
        rows.len(),
        PERCUSS_ROW_MAJOR,
        width,
        3,
        outcomes.as_mut_ptr(),
        masses.as_mut_ptr(),
        errors.as_mut_ptr(),
        of_rows.as_mut_ptr(),
        None,
        null_mut()
    ));
    outputs.extend(of_rows.map(|remarks| ("percuss_batch_run", flags(remarks), not_in_rows)));
    if let Some((joint, value)) = joint {
        let mut path = null_mut();
        // SAFETY: all pointers are to local values.
        let status = unsafe { percuss_path_new(pose, contact, &raw const joint, 1, &raw mut path) };
        if status == PERCUSS_OK {
            let mut done = 0;
            let (to, masses, errors) = (positions.as_mut_ptr(), masses.as_mut_ptr(), errors.as_mut_ptr());
            let of_rows = of_rows.as_mut_ptr();
            ok!(percuss_path_follow(
                path,
                &raw const value,
                1,
                1,
                to,
                width,
                masses,
                errors,
                of_rows,
                &raw mut done
            ));
            // SAFETY: the first of three numbers.
            outputs.extend((done == 1).then(|| ("percuss_path_follow", flags(unsafe { *of_rows }), none)));
            ok!(percuss_path_free(&raw mut path));
        }
    }
    ok!(percuss_batch_free(&raw mut batch));
    ok!(percuss_workspace_free(&raw mut workspace));
    ok!(percuss_assembly_free(&raw mut assembly));
    ok!(percuss_pose_free(&raw mut pose));
    ok!(percuss_configuration_free(&raw mut configuration));
    ok!(percuss_system_free(&raw mut system));
    outputs
}

/// Report of a request, as JSON.
fn report(model: *const percuss_model, request: &str) -> String {
    let (request, mut report, mut json) = (CString::new(request).expect("text"), null_mut(), null());
    ok!(percuss_ask(model, request.as_ptr(), &raw mut report));
    ok!(percuss_report_json(report, &raw mut json));
    let text = string(json);
    ok!(percuss_report_free(&raw mut report));
    text
}

#[test]
fn every_finding_is_in_every_output() {
    let mut missing = Vec::new();
    for case in cases() {
        let code = case.code;
        let mut expect = |output: &str, is_found: bool| {
            if !is_found {
                missing.push(format!("{code}, {output}"));
            }
        };
        let flag = FLAGS.iter().find(|(name, _)| *name == code).map(|(_, flag)| *flag);
        assert!(
            flag.is_some() || WITHOUT_FLAG.iter().any(|(name, _)| *name == code),
            "{code}: a flag, or a reason"
        );
        let mut outputs = flag.map_or_else(Vec::new, |_| library(&case));
        // Only programs of the library accept the findings of a file.
        if case.accepted().is_none() {
            let mut model = model(&case.model);
            outputs.extend(flag.map_or_else(Vec::new, |_| c_interface(&case, model)));
            let is_in = |text: &str| text.contains(&format!("\"code\":\"{code}\""));
            expect("mass of percuss_ask", is_in(&report(model, &case.request(false))));
            if case.range().is_some() {
                let text = report(model, &case.request(true));
                expect("sweep of percuss_ask", is_in(text.split("\"sweep\":").nth(1).unwrap_or_default()));
            }
            ok!(percuss_model_free(&raw mut model));
        }
        let Some((flag, (_, of_pose, _))) = flag.zip(outputs.first().copied()) else { continue };
        expect("pose", of_pose.contains(flag));
        for (output, flags, not_in) in outputs {
            // An unknown error is no smaller one.
            let is_unknown = flags.contains(RemarkFlags::UNKNOWN_ERROR);
            let found =
                flags | not_in | if is_unknown { RemarkFlags::UNCERTAIN_MASS } else { RemarkFlags::NONE };
            expect(&format!("{output}: {flags:?} for {of_pose:?}"), found.contains(of_pose));
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
    assert!(codes().count() > 30);
}
