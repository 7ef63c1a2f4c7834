//! Extension module `percuss._percuss` of the Python package: conversion of arrays, names and messages between Python
//! and the Rust façade, which does all computation. User guide: docs/howto/PYTHON.md; types: `python/percuss/_percuss.pyi`.

mod analysis;
mod command;
mod conversion;
mod questions;
mod sweep;

/// Items that the package re-exports.
#[pyo3::pymodule(name = "_percuss")]
mod module {
    #[pymodule_export]
    use crate::analysis::contact::Contact;
    #[pymodule_export]
    use crate::analysis::matrices::{MatrixResponse, effective_mass, effective_masses, matrix_findings};
    #[pymodule_export]
    use crate::analysis::model::{Joint, Model, joint_of_parts, load, loads, model_of_bytes};
    #[pymodule_export]
    use crate::analysis::motion::{Accelerations, Travel};
    #[pymodule_export]
    use crate::analysis::pose::Pose;
    #[pymodule_export]
    use crate::analysis::response::Response;
    #[pymodule_export]
    use crate::analysis::suspension::{load_suspension, suspension_template, suspension_templates};
    #[pymodule_export]
    use crate::analysis::system::{Assembly, System};
    #[pymodule_export]
    use crate::analysis::system_methods::Workspace;
    #[pymodule_export]
    use crate::command::run_command;
    #[pymodule_export]
    use crate::conversion::diagnostic::{Diagnostic, diagnostic_of_parts};
    #[pymodule_export]
    use crate::conversion::threads::set_threads;
    #[pymodule_export]
    use crate::questions::damping::{damp, damp_mass, impact_history, laws, regions, safe_speeds, tools};
    #[pymodule_export]
    use crate::questions::kinematics::kinematics;
    #[pymodule_export]
    use crate::questions::reports::{
        ask, check, compare, compare_study, extremes, impact, map_point_report, map_report, mass_report,
        reflected_inertias, run_study, safe_speed, starting_study, study_schema, sweep_report,
    };
    #[pymodule_export]
    use crate::sweep::impacts::{friction_rows, impact_rows};
    #[pymodule_export]
    use crate::sweep::result::{Sweep, sweep_of_parts};
    #[pymodule_export]
    use crate::sweep::sweep;

    /// Records the id of the importing process.
    #[pymodule_init]
    fn record_process(_module: &pyo3::Bound<'_, pyo3::types::PyModule>) -> pyo3::PyResult<()> {
        crate::conversion::threads::record_process();
        Ok(())
    }
}
