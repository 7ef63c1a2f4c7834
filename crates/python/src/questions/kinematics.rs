//! Kinematics of suspensions.

use crate::analysis::model::Model;
use crate::conversion::errors::{self, input};
use crate::conversion::threads::{abandonable, interruptible};
use crate::questions::reports::json;
use percuss::study::{
    self, AxlePosition, KinematicVariable, KinematicsQuestion, PositiveMass, VehicleData, WheelMotion,
};
use percuss::{DEFAULT_MAX_SIZE, LoadOptions};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// Value of a variable, m: one number, or one number for each row.
#[derive(FromPyObject)]
enum Variable {
    One(f64),
    Rows(Vec<f64>),
}

/// Python class `percuss._kinematics._Question`.
#[derive(FromPyObject)]
pub struct Question {
    wheel_travel: Option<Variable>,
    heave: Option<Variable>,
    roll: Option<Variable>,
    steer: Option<Variable>,
    axle: Option<String>,
    brake_bias: Option<f64>,
    drive_share: Option<f64>,
    cg_height: Option<f64>,
    wheelbase: Option<f64>,
    inboard_brakes: bool,
    inboard_drive: bool,
    sprung_mass: Option<f64>,
    tyre_rate: Option<f64>,
}

/// A positive finite number.
fn positive(name: &str, value: Option<f64>) -> PyResult<Option<f64>> {
    match value {
        Some(x) if !(x.is_finite() && x > 0.0) => {
            Err(input(format_args!("{name} is {x}; more than 0 is expected")))
        }
        value => Ok(value),
    }
}

/// A share between 0 and 1.
fn share(name: &str, value: Option<f64>) -> PyResult<Option<f64>> {
    match value {
        Some(x) if !(0.0..=1.0).contains(&x) => {
            Err(input(format_args!("{name} is {x}; a share between 0 and 1 is expected")))
        }
        value => Ok(value),
    }
}

impl Question {
    /// Data of the vehicle.
    fn vehicle(&self) -> PyResult<VehicleData> {
        let axle = match self.axle.as_deref() {
            None => None,
            Some("front") => Some(AxlePosition::Front),
            Some("rear") => Some(AxlePosition::Rear),
            Some(other) => {
                return Err(input(format_args!("axle is \"{other}\"; expected \"front\" or \"rear\"")));
            }
        };
        Ok(VehicleData {
            axle,
            brake_bias: share("brake_bias", self.brake_bias)?.map(Into::into),
            drive_share: share("drive_share", self.drive_share)?.map(Into::into),
            cg_height: positive("cg_height", self.cg_height)?.map(Into::into),
            wheelbase: positive("wheelbase", self.wheelbase)?.map(Into::into),
            inboard_brakes: self.inboard_brakes,
            inboard_drive: self.inboard_drive,
            sprung_mass: positive("sprung_mass", self.sprung_mass)?.map(PositiveMass),
            tyre_rate: positive("tyre_rate", self.tyre_rate)?.map(Into::into),
        })
    }

    /// Question of the study crate.
    fn question(self) -> PyResult<KinematicsQuestion> {
        let vehicle = self.vehicle()?;
        let mut question = KinematicsQuestion { vehicle, ..KinematicsQuestion::default() };
        let wheels = KinematicVariable::Wheels;
        for (variable, value) in [
            (KinematicVariable::Steer, self.steer),
            (wheels(WheelMotion::WheelTravel), self.wheel_travel),
            (wheels(WheelMotion::Heave), self.heave),
            (wheels(WheelMotion::Roll), self.roll),
        ] {
            let name = variable.name().replace('-', "_");
            let numbers = match &value {
                None => continue,
                Some(Variable::One(x)) => std::slice::from_ref(x),
                Some(Variable::Rows(rows)) => rows,
            };
            if let Some(x) = numbers.iter().find(|x| !x.is_finite()) {
                return Err(input(format_args!("{name} has a value {x}; finite numbers in m are expected")));
            }
            match (value, &question.range) {
                (Some(Variable::One(x)), _) => question.state.push((variable, x)),
                (Some(Variable::Rows(rows)), None) if !rows.is_empty() => {
                    question.range = Some((variable, rows))
                }
                (Some(Variable::Rows(_)), None) => {
                    return Err(input(format_args!("{name} has no values; give at least one")));
                }
                (Some(Variable::Rows(_)), Some((other, _))) => {
                    let other = other.name().replace('-', "_");
                    return Err(input(format_args!(
                        "{name} and {other} have several values each; only one variable has rows"
                    )));
                }
                (None, _) => {}
            }
        }
        Ok(question)
    }
}

/// Suspension: a model, or the path of a file, whose masses may be missing.
#[derive(FromPyObject)]
pub enum Suspension<'py> {
    Read(Bound<'py, Model>),
    File(PathBuf),
}

/// Report on the kinematics of a suspension.
#[pyfunction]
pub fn kinematics(py: Python<'_>, model: Suspension<'_>, question: Question) -> PyResult<String> {
    let question = question.question()?;
    let read = match model {
        Suspension::Read(model) => Arc::clone(&model.get().read),
        Suspension::File(path) => {
            let path = path.to_string_lossy().into_owned();
            let options = LoadOptions::default();
            let read = move || study::Model::load_for_kinematics(&path, DEFAULT_MAX_SIZE, &options, None);
            let read = abandonable(py, true, read)?.map_err(errors::load)?;
            errors::warn(py, &read.diagnostics)?;
            Arc::new(read)
        }
    };
    let report = interruptible(py, || study::kinematics(&read, &question))?;
    json(&report.map_err(errors::kinematics)?)
}
