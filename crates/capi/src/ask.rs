//! Questions as text: the tables of a study.

use crate::boundary::arrays::input_text;
use crate::boundary::handle::{Handle, argument_mut, clear_handle, free_handle, object_of, write_handle};
use crate::boundary::names::c_string;
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_CONTACT, guard_call, percuss_status,
};
use crate::setup::model::percuss_model;
use percuss::study::ask;
use std::ffi::{CString, c_char};
use std::ptr::null;

/// The results of a request, as JSON. Immutable, so that threads can share it.
pub struct percuss_report {
    _opaque: [u8; 0],
}

impl Handle for percuss_report {
    type Object = CString;
    const TAG: u64 = 0x7063_5f72_6570_6f72;
    const NAME: &'static str = "percuss_report";
}

/// Results of the tables of a request: effective mass, damper and parameters of simulators, impact, extremes, sweep, comparison,
/// kinematics, map, safe speed, contents of the model (table check), source code (table generate), the model in another
/// format (convert) or with an impact for MuJoCo (export): files as text. request: JSON object with the tables of a study (docs/study.schema.json), without the path of a model and
/// without output files; the table "model" may have changes of the model. The keys of the report are the tables: {"mass": …,
/// "impact": …}, each with the report of the command in docs/reference/OUTPUTS.md. SI units. Paths in the request are relative to the working directory.
/// Free the report with percuss_report_free.
///
/// Errors: PERCUSS_ERROR_ARGUMENT: invalid JSON, an unknown key, or an invalid value; the message contains the key.
/// PERCUSS_ERROR_CONTACT: a valid question without a result.
///
/// # Safety
/// model is a handle; request ends with a zero byte; report is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_ask(
    model: *const percuss_model,
    request: *const c_char,
    report: *mut *mut percuss_report,
) -> percuss_status {
    guard_call(|| {
        clear_handle(report)?;
        let model = object_of(model)?;
        let found = ask(&model.study, input_text(request, "request")?).map_err(|error| {
            let status = if error.has_no_result() { PERCUSS_ERROR_CONTACT } else { PERCUSS_ERROR_ARGUMENT };
            Failure::new(status, error.message())
        })?;
        write_handle(c_string(&found.to_json()), report)
    })
}

/// The JSON text of a report, UTF-8. Valid as long as the report; null if the call fails.
///
/// # Safety
/// report is a handle; json is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_report_json(
    report: *const percuss_report,
    json: *mut *const c_char,
) -> percuss_status {
    guard_call(|| {
        let json = argument_mut(json, "json")?;
        *json = null();
        *json = object_of(report)?.as_ptr();
        Ok(())
    })
}

/// Frees a report and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// report is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_report_free(report: *mut *mut percuss_report) -> percuss_status {
    guard_call(|| free_handle(report))
}
