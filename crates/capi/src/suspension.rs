//! Suspensions: sheets of hardpoints, and their kinematics over wheel travel.

use crate::boundary::arrays::{copy_to_caller, enumeration_value, input_slice, input_text, nan_if_unknown};
use crate::boundary::handle::{
    Handle, argument_mut, clear_handle, free_handle, object_of, read_optional_argument, write_handle,
};
use crate::boundary::names::{c_string, element_at};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_ASSEMBLY, PERCUSS_ERROR_LENGTH, PERCUSS_ERROR_LOAD,
    guard_call, percuss_status,
};
use crate::setup::model::{DiagnosticTexts, Model, input_document, percuss_model};
use percuss::study::{
    self, AxlePosition, KinematicVariable, KinematicsQuestion, KinematicsReport, PositiveMass, VehicleData,
    WheelLoads, WheelMotion, kinematics,
};
use percuss::{DEFAULT_MAX_SIZE, LoadOptions, Source};
use std::ffi::{CString, c_char};
use std::ptr::null;
use std::sync::Arc;

/// A suspension read from its sheet. Immutable, so that threads can share it.
pub struct percuss_suspension {
    _opaque: [u8; 0],
}

/// A suspension with its mechanism for other functions.
pub(crate) struct Suspension {
    mechanism: Arc<Model>,
}

impl Suspension {
    /// Reads a suspension and prepares its mechanism for C.
    fn load(source: &Source) -> Result<Self, Failure> {
        let model = study::Model::from_source(source, &LoadOptions::default());
        let model = model.map_err(Failure::with_status(PERCUSS_ERROR_LOAD))?;
        if !model.has_sheet() {
            let message = format_args!(
                "{}: this is no sheet, table or JSON file of a suspension; percuss_model_load_file reads a URDF",
                source.name
            );
            return Err(Failure::new(PERCUSS_ERROR_LOAD, message));
        }
        let findings = model.diagnostics.iter().map(DiagnosticTexts::from_record).collect();
        Ok(Self { mechanism: Model::of_study(model, None, findings) })
    }
}

impl Handle for percuss_suspension {
    type Object = Suspension;
    const TAG: u64 = 0x7063_5f73_7573_7021;
    const NAME: &'static str = "percuss_suspension";
}

/// Quantities of a suspension, one row per state. Immutable, so that threads can share it.
pub struct percuss_kinematics {
    _opaque: [u8; 0],
}

/// Rows, and the texts of columns and rows.
pub(crate) struct KinematicsTable {
    columns: Vec<ColumnTexts>,
    /// Row by row; NaN for a missing value.
    values: Vec<f64>,
    problems: Vec<Option<CString>>,
}

/// Texts of a column.
struct ColumnTexts {
    name: CString,
    unit: CString,
    missing: Option<CString>,
}

impl Handle for percuss_kinematics {
    type Object = KinematicsTable;
    const TAG: u64 = 0x7063_5f6b_696e_656d;
    const NAME: &'static str = "percuss_kinematics";
}

/// Variable of the rows.
pub type percuss_wheel_motion = i32;
/// Travel of the wheel of one side, m, upward.
pub const PERCUSS_WHEEL_TRAVEL: percuss_wheel_motion = 0;
/// Both wheels upward by the same travel, m.
pub const PERCUSS_HEAVE: percuss_wheel_motion = 1;
/// The left wheel upward and the right wheel downward, m.
pub const PERCUSS_ROLL: percuss_wheel_motion = 2;
/// Displacement of the rack to the left, m.
pub const PERCUSS_STEER: percuss_wheel_motion = 3;

/// The position of the axle is unknown: no support angles.
pub const PERCUSS_AXLE_UNKNOWN: i32 = 0;
/// Front axle.
pub const PERCUSS_AXLE_FRONT: i32 = 1;
/// Rear axle.
pub const PERCUSS_AXLE_REAR: i32 = 2;

/// No motions per load.
pub const PERCUSS_LOADS_NONE: i32 = 0;
/// Loads on a single wheel, on the right wheel the mirror image.
pub const PERCUSS_LOADS_SINGLE: i32 = 1;
/// The same load on both wheels.
pub const PERCUSS_LOADS_PARALLEL: i32 = 2;
/// Opposite loads on both wheels, positive on the left.
pub const PERCUSS_LOADS_OPPOSED: i32 = 3;
/// Added to PERCUSS_LOADS_SINGLE and the following: the heights of the wheel centres are held.
pub const PERCUSS_TRAVEL_HELD: i32 = 8;

/// State of a suspension apart from the variable of the rows, and data of the vehicle.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_vehicle {
    /// Travels with one value for all rows, m; 0: none.
    pub wheel_travel: f64,
    /// See wheel_travel.
    pub heave: f64,
    /// See wheel_travel.
    pub roll: f64,
    /// Displacement of the rack for all rows, m.
    pub steer: f64,
    /// PERCUSS_AXLE_….
    pub axle: i32,
    /// 1 for brakes whose torque acts on the vehicle body.
    pub inboard_brakes: i32,
    /// 1 for a drive whose torque acts on the vehicle body.
    pub inboard_drive: i32,
    /// PERCUSS_LOADS_…, plus PERCUSS_TRAVEL_HELD to hold the heights of the wheel centres: columns of the motions per load (rad/N, m/N, rad/(N·m),
    /// m/(N·m)) with the bushes of the sheet, such as toe_per_lateral_force.
    pub loads: i32,
    /// Share of the front axle in the braking force, 0 to 1; NaN if unknown.
    pub brake_bias: f64,
    /// Share of this axle in the driving force, 0 to 1; NaN if unknown.
    pub drive_share: f64,
    /// Height of the centre of mass above the ground, m; NaN if unknown.
    pub cg_height: f64,
    /// Wheelbase, m; NaN if unknown.
    pub wheelbase: f64,
    /// Sprung mass above one wheel, kg; NaN if unknown.
    pub sprung_mass: f64,
    /// Vertical rate of the tyre, N/m; NaN if unknown.
    pub tyre_rate: f64,
}

/// Column of a table. The texts are valid as long as the table.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_column {
    /// The quantity, with _left or _right for one of two wheels: camber, toe_left, motion_ratio_spring, …
    pub name: *const c_char,
    /// SI unit; "" for a plain number.
    pub unit: *const c_char,
    /// Reason for the absence of all values; null if a row has a value.
    pub missing: *const c_char,
}

const UNKNOWN: percuss_vehicle = percuss_vehicle {
    wheel_travel: 0.0,
    heave: 0.0,
    roll: 0.0,
    steer: 0.0,
    axle: PERCUSS_AXLE_UNKNOWN,
    inboard_brakes: 0,
    inboard_drive: 0,
    loads: PERCUSS_LOADS_NONE,
    brake_bias: f64::NAN,
    drive_share: f64::NAN,
    cg_height: f64::NAN,
    wheelbase: f64::NAN,
    sprung_mass: f64::NAN,
    tyre_rate: f64::NAN,
};

/// Variables in the order of PERCUSS_WHEEL_TRAVEL and the following constants.
const VARIABLES: [KinematicVariable; 4] = [
    KinematicVariable::Wheels(WheelMotion::WheelTravel),
    KinematicVariable::Wheels(WheelMotion::Heave),
    KinematicVariable::Wheels(WheelMotion::Roll),
    KinematicVariable::Steer,
];

/// A number, unless it is NaN, which means unknown; `is_valid`: the condition that `expected` describes.
fn known(value: f64, name: &str, is_valid: fn(f64) -> bool, expected: &str) -> Result<Option<f64>, Failure> {
    if value.is_nan() {
        return Ok(None);
    }
    if value.is_finite() && is_valid(value) {
        return Ok(Some(value));
    }
    let message = format_args!("{name} is {value}; expected {expected}, or NaN if unknown");
    Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message))
}

impl percuss_vehicle {
    /// Data of the vehicle; checks the numbers.
    fn data(&self) -> Result<VehicleData, Failure> {
        let positive = |value, name| known(value, name, |x| x > 0.0, "more than 0");
        let share = |value, name| known(value, name, |x| (0.0..=1.0).contains(&x), "a share from 0 to 1");
        let travel_held = self.loads & PERCUSS_TRAVEL_HELD != 0;
        let wheels = [None, Some(WheelLoads::Single), Some(WheelLoads::Parallel), Some(WheelLoads::Opposed)];
        let compliance = enumeration_value(&wheels, self.loads & !PERCUSS_TRAVEL_HELD, "loads")?;
        if travel_held && compliance.is_none() {
            let message = "loads is PERCUSS_TRAVEL_HELD alone; expected PERCUSS_LOADS_SINGLE or a following one with it";
            return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
        }
        let axles = [None, Some(AxlePosition::Front), Some(AxlePosition::Rear)];
        Ok(VehicleData {
            axle: enumeration_value(&axles, self.axle, "axle")?,
            brake_bias: share(self.brake_bias, "brake_bias")?.map(Into::into),
            drive_share: share(self.drive_share, "drive_share")?.map(Into::into),
            cg_height: positive(self.cg_height, "cg_height")?.map(Into::into),
            wheelbase: positive(self.wheelbase, "wheelbase")?.map(Into::into),
            inboard_brakes: self.inboard_brakes != 0,
            inboard_drive: self.inboard_drive != 0,
            sprung_mass: positive(self.sprung_mass, "sprung_mass")?.map(PositiveMass),
            tyre_rate: positive(self.tyre_rate, "tyre_rate")?.map(Into::into),
            compliance,
            travel_held,
        })
    }

    /// Variables with one value for all rows.
    fn state(&self, variable: KinematicVariable) -> Result<Vec<(KinematicVariable, f64)>, Failure> {
        let mut state = Vec::new();
        let values = [self.wheel_travel, self.heave, self.roll, self.steer];
        // The rack is placed before the wheels travel.
        for (other, value) in VARIABLES.into_iter().zip(values).rev() {
            if value == 0.0 {
                continue;
            }
            let name = other.name().replace('-', "_");
            if !value.is_finite() || other == variable {
                let expected =
                    if other == variable { "0: it varies over the rows" } else { "a finite number" };
                let message = format_args!("{name} is {value}; expected {expected}");
                return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
            }
            state.push((other, value));
        }
        Ok(state)
    }
}

impl KinematicsTable {
    /// Table of a report.
    fn of(report: &KinematicsReport) -> Self {
        let texts = |column: &study::KinematicColumn| ColumnTexts {
            name: c_string(&column.name()),
            unit: c_string(column.unit.si()),
            missing: column.missing.as_deref().map(c_string),
        };
        let width = report.columns.len();
        let row = |row: &study::KinematicsRow| -> Vec<f64> {
            let mut values: Vec<f64> = row.values.iter().copied().map(nan_if_unknown).collect();
            values.resize(width, f64::NAN);
            values
        };
        Self {
            columns: report.columns.iter().map(texts).collect(),
            values: report.rows.iter().flat_map(row).collect(),
            problems: report.rows.iter().map(|row| row.problem.as_deref().map(c_string)).collect(),
        }
    }
}

/// Reads a suspension: a sheet (TOML), a table of hardpoints (CSV) or a file of Chrono::Vehicle (JSON), as the command
/// percuss does. path: UTF-8. Free it with percuss_suspension_free.
///
/// Errors: PERCUSS_ERROR_LOAD, with every error of the file in the message.
///
/// # Safety
/// path ends with a zero byte; suspension is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_suspension_load_file(
    path: *const c_char,
    suspension: *mut *mut percuss_suspension,
) -> percuss_status {
    guard_call(|| {
        clear_handle(suspension)?;
        let path = input_text(path, "path")?;
        if path == "-" {
            return Err(Failure::new(PERCUSS_ERROR_LOAD, "path is \"-\"; expected the name of a file"));
        }
        let source =
            Source::read(path, DEFAULT_MAX_SIZE).map_err(Failure::with_status(PERCUSS_ERROR_LOAD))?;
        write_handle(Suspension::load(&source)?, suspension)
    })
}

/// Reads a suspension from memory: length bytes of UTF-8 without a terminating zero byte. name replaces the file name in
/// messages; its ending (.toml, .csv, .json) determines the format, and its folder is that of a table named in a sheet.
///
/// Errors: as percuss_suspension_load_file; PERCUSS_ERROR_TEXT.
///
/// # Safety
/// name ends with a zero byte; bytes has length bytes; suspension is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_suspension_load_memory(
    name: *const c_char,
    bytes: *const c_char,
    length: usize,
    suspension: *mut *mut percuss_suspension,
) -> percuss_status {
    guard_call(|| {
        clear_handle(suspension)?;
        let name = input_text(name, "name")?;
        let text = input_document(name, bytes, length)?;
        write_handle(Suspension::load(&Source::from_text(name, text))?, suspension)
    })
}

/// Frees a suspension and sets the handle to null; a null handle is ignored. Objects made from it stay valid.
///
/// # Safety
/// suspension is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_suspension_free(suspension: *mut *mut percuss_suspension) -> percuss_status {
    guard_call(|| free_handle(suspension))
}

/// The mechanism of a suspension, for effective masses at its named contacts (percuss_pose_touch). Its diagnostics are
/// those of the sheet. Free the model with percuss_model_free.
///
/// # Safety
/// suspension is a handle; model is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_suspension_model(
    suspension: *const percuss_suspension,
    model: *mut *mut percuss_model,
) -> percuss_status {
    guard_call(|| {
        clear_handle(model)?;
        write_handle(Arc::clone(&object_of(suspension)?.mechanism), model)
    })
}

/// Sets all travels to 0 and all data of the vehicle to unknown.
///
/// # Safety
/// vehicle is null or points to storage for one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_vehicle_init(vehicle: *mut percuss_vehicle) -> percuss_status {
    guard_call(|| {
        *argument_mut(vehicle, "vehicle")? = UNKNOWN;
        Ok(())
    })
}

/// Camber, toe, roll centre, motion ratios, wheel rates and all other quantities of docs/howto/KINEMATICS.md at the given
/// values of a variable (m), one row each. A row whose pose cannot be reached has NaN and a problem. vehicle may be
/// null. Derivatives of an axle are those of heave; for the variable PERCUSS_ROLL those of roll. Free the table with
/// percuss_kinematics_free.
///
/// Errors: PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_LENGTH; PERCUSS_ERROR_ASSEMBLY: a suspension without a wheel or, to be
/// steered, without a rack; travels that do not fit.
///
/// # Safety
/// values has count numbers; vehicle is null or points to one; table is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_suspension_kinematics(
    suspension: *const percuss_suspension,
    variable: percuss_wheel_motion,
    values: *const f64,
    count: usize,
    vehicle: *const percuss_vehicle,
    table: *mut *mut percuss_kinematics,
) -> percuss_status {
    guard_call(|| {
        clear_handle(table)?;
        let suspension = object_of(suspension)?;
        let variable = enumeration_value(&VARIABLES, variable, "variable")?;
        let values = input_slice(values, count, "values")?.to_vec();
        if values.is_empty() {
            return Err(Failure::new(
                PERCUSS_ERROR_LENGTH,
                "values: 0 values are given; expected at least 1",
            ));
        }
        if let Some(at) = values.iter().position(|value| !value.is_finite()) {
            let message = format_args!("value {at} is {}; expected a finite number, m", values[at]);
            return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
        }
        let vehicle = read_optional_argument(vehicle, "vehicle")?.unwrap_or(UNKNOWN);
        let question = KinematicsQuestion {
            state: vehicle.state(variable)?,
            range: Some((variable, values)),
            vehicle: vehicle.data()?,
            ..KinematicsQuestion::default()
        };
        let report = kinematics(&suspension.mechanism.study, &question);
        let report = report.map_err(Failure::with_status(PERCUSS_ERROR_ASSEMBLY))?;
        write_handle(KinematicsTable::of(&report), table)
    })
}

/// Frees a table and sets the handle to null; a null handle is ignored.
///
/// # Safety
/// table is null or points to a handle that no other call uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_kinematics_free(table: *mut *mut percuss_kinematics) -> percuss_status {
    guard_call(|| free_handle(table))
}

/// Numbers of rows and columns of a table. Each pointer may be null.
///
/// # Safety
/// Every pointer is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_kinematics_counts(
    table: *const percuss_kinematics,
    rows: *mut usize,
    columns: *mut usize,
) -> percuss_status {
    guard_call(|| {
        let table = object_of(table)?;
        for (to, count) in [(rows, table.problems.len()), (columns, table.columns.len())] {
            if !to.is_null() {
                *argument_mut(to, "a count")? = count;
            }
        }
        Ok(())
    })
}

/// Column number index, from 0.
///
/// # Safety
/// column is null or points to storage for one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_kinematics_column(
    table: *const percuss_kinematics,
    index: usize,
    column: *mut percuss_column,
) -> percuss_status {
    guard_call(|| {
        let texts = element_at(&object_of(table)?.columns, index, "column")?;
        *argument_mut(column, "column")? = percuss_column {
            name: texts.name.as_ptr(),
            unit: texts.unit.as_ptr(),
            missing: texts.missing.as_ref().map_or(null(), |text| text.as_ptr()),
        };
        Ok(())
    })
}

/// All values, SI units, row by row; NaN where a value is missing. length is rows times columns.
///
/// # Safety
/// values has space for length numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_kinematics_values(
    table: *const percuss_kinematics,
    values: *mut f64,
    length: usize,
) -> percuss_status {
    guard_call(|| copy_to_caller(&object_of(table)?.values, values, length, "values"))
}

/// The reason why row number row, from 0, has no pose; null for a row with a pose. Valid as long as the table.
///
/// # Safety
/// problem is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_kinematics_problem(
    table: *const percuss_kinematics,
    row: usize,
    problem: *mut *const c_char,
) -> percuss_status {
    guard_call(|| {
        let problem = argument_mut(problem, "problem")?;
        *problem = null();
        let text = element_at(&object_of(table)?.problems, row, "row")?;
        *problem = text.as_ref().map_or(null(), |text| text.as_ptr());
        Ok(())
    })
}
