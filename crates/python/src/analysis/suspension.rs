//! Suspensions from sheets, tables and files of hardpoints.

use crate::analysis::model::Model;
use crate::conversion::errors::{self, input};
use crate::conversion::threads::abandonable;
use percuss::mechanism::near_names;
use percuss::study::Model as Read;
use percuss::suspension::{
    ImportOptions, LengthUnit, Rack, Side, TemplateOptions, VehicleAxes, Wheel, template_names,
    template_sheet,
};
use percuss::{DEFAULT_MAX_SIZE, Source};
use pyo3::prelude::*;
use std::path::PathBuf;

/// Parses the name of a length unit.
fn unit(name: &str) -> PyResult<LengthUnit> {
    let error = || input(format_args!("unit is \"{name}\"; expected \"m\", \"cm\", \"mm\" or \"in\""));
    LengthUnit::from_name(name).ok_or_else(error)
}

/// Parses the name of vehicle axes.
fn axes(name: &str) -> PyResult<VehicleAxes> {
    let error = || input(format_args!("axes is \"{name}\"; expected {}", VehicleAxes::CHOICES));
    VehicleAxes::from_name(name).ok_or_else(error)
}

/// Parses the name of a side.
fn side(name: &str) -> PyResult<Side> {
    match name {
        "left" => Ok(Side::Left),
        "right" => Ok(Side::Right),
        "both" => Ok(Side::Both),
        _ => Err(input(format_args!("side is \"{name}\"; expected \"left\", \"right\" or \"both\""))),
    }
}

/// Reads a sheet (TOML), a table of hardpoints (CSV, XLSX) or a suspension file of Chrono::Vehicle (JSON).
///
/// side: "left", "right" or "both". unit: "m", "cm", "mm", "in"; axes: "iso", "adams", "sae", "rfactor", or such as "-z x y" (the axes that point forward, left and up); template: values that the file
/// does not state. wheel: (mass kg, (Ixx, Iyy, Izz) kg·m² about its centre, radius m or None). rack_mass: mass of a
/// sliding rack, kg. move: hardpoints of a sheet that are moved: name to (3,) m, in the sheet's own axes. allow_outside:
/// the sheet may name a table of points outside its folder. worksheet: worksheet of a workbook, by default the first.
/// names: file of the names of a table's points, lower_ball = "LBJ". Warnings and errors as for load.
///
///     >>> percuss.suspension.load("models/suspensions/double-wishbone.toml").contacts
#[pyfunction]
#[pyo3(signature = (path, *, side=None, unit=None, axes=None, template=None, wheel=None, rack_mass=None, r#move=None, allow_outside=false, worksheet=None, names=None))]
#[allow(clippy::too_many_arguments, clippy::type_complexity, reason = "the options of the command")]
pub fn load_suspension(
    py: Python<'_>,
    path: PathBuf,
    side: Option<&str>,
    unit: Option<&str>,
    axes: Option<&str>,
    template: Option<String>,
    wheel: Option<(f64, [f64; 3], Option<f64>)>,
    rack_mass: Option<f64>,
    r#move: Option<std::collections::BTreeMap<String, [f64; 3]>>,
    allow_outside: bool,
    worksheet: Option<String>,
    names: Option<String>,
) -> PyResult<Model> {
    let options = ImportOptions {
        unit: unit.map(self::unit).transpose()?,
        axes: axes.map(self::axes).transpose()?,
        side: side.map(self::side).transpose()?,
        template,
        moves: r#move.unwrap_or_default().into_iter().collect(),
        wheel: wheel.map(|(mass, inertia, radius)| Wheel { mass, inertia, radius }),
        rack: rack_mass.map(|mass| Rack::Sliding { mass }),
        allow_outside,
        worksheet,
        names,
        ..ImportOptions::default()
    };
    let source = Source::read(&path.to_string_lossy(), DEFAULT_MAX_SIZE).map_err(errors::load)?;
    // Tables of the sheet may be large.
    let read = abandonable(py, true, move || Read::from_suspension(&source, &options))?;
    Model::new(py, read.map_err(errors::load)?)
}

/// Templates of sheets: name, title.
///
///     >>> [name for name, title in percuss.suspension.templates()]
#[pyfunction]
pub fn suspension_templates() -> Vec<(&'static str, &'static str)> {
    template_names()
}

/// Empty sheet of a template, to fill in: TOML text.
///
///     >>> percuss.suspension.template("macpherson-strut", unit="mm")
#[pyfunction]
#[pyo3(signature = (name, *, unit="mm", axes="iso"))]
pub fn suspension_template(name: &str, unit: &str, axes: &str) -> PyResult<String> {
    let options = TemplateOptions { unit: self::unit(unit)?, axes: self::axes(axes)? };
    template_sheet(name, &options).ok_or_else(|| {
        let names = template_names();
        let near = near_names(name, names.iter().map(|(name, _)| *name));
        let near = near.first().map_or_else(|| ".".to_owned(), |near| format!("; did you mean {near}?"));
        let known: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
        input(format_args!("no template is named \"{name}\"{near} There are: {}", known.join(", ")))
    })
}
