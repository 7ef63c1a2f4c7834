//! Extension module `percuss._percuss` of the Python package: conversion of arrays, names and messages between Python
//! and the Rust façade, which does all computation. User guide: docs/howto/PYTHON.md; types: `python/percuss/_percuss.pyi`.

mod arrays;
mod command;
mod contact;
mod damping;
mod diagnostic;
mod errors;
mod labels;
mod maps;
mod matrices;
mod model;
mod model_methods;
mod motion;
mod pose;
mod pose_methods;
mod question;
mod reports;
mod response;
mod suspension;
mod sweep;
mod system;
mod threads;

/// Items that the package re-exports.
#[pyo3::pymodule(name = "_percuss")]
mod module {
    #[pymodule_export]
    use crate::command::run_command;
    #[pymodule_export]
    use crate::contact::Contact;
    #[pymodule_export]
    use crate::damping::{damp, damp_mass, impact_history, laws, regions, tools};
    #[pymodule_export]
    use crate::diagnostic::Diagnostic;
    #[pymodule_export]
    use crate::matrices::{MatrixResponse, effective_mass, effective_masses, matrix_findings};
    #[pymodule_export]
    use crate::model::{Joint, Model, load, loads, model_of_bytes};
    #[pymodule_export]
    use crate::motion::{Accelerations, Travel};
    #[pymodule_export]
    use crate::pose::Pose;
    #[pymodule_export]
    use crate::reports::{
        check, compare, compare_study, explain, map_point_report, map_report, mass_report, run_study,
        safe_speed, starting_study, study_schema, sweep_report, tolerate,
    };
    #[pymodule_export]
    use crate::response::Response;
    #[pymodule_export]
    use crate::suspension::{load_suspension, suspension_template, suspension_templates};
    #[pymodule_export]
    use crate::sweep::{Sweep, sweep, sweep_of_arrays};
    #[pymodule_export]
    use crate::system::{Assembly, System, Workspace};

    /// Records the id of the importing process.
    #[pymodule_init]
    fn record_process(_module: &pyo3::Bound<'_, pyo3::types::PyModule>) -> pyo3::PyResult<()> {
        crate::threads::record_process();
        Ok(())
    }
}
