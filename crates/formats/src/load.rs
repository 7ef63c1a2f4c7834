//! Entry point of all readers of models: the root element of the file selects the format.

use crate::reading::report::Report;
use crate::reading::tolerance::tolerant_text;
use crate::reading::xml;
use crate::sdf;
use crate::urdf::load::{LoadOptions, Loaded};
use crate::{DEFAULT_MAX_SIZE, LoadError, Source, mjcf, urdf};

/// Reads a model: URDF (root `<robot>`), MJCF (root `<mujoco>`) or SDFormat (root `<sdf>`), closed loops and couplings included.
///
/// Units: m, kg, kg·m², rad. Inertias in a rotated frame are transformed to the link's axes, I = R I′ Rᵀ. A URDF opens no other file.
/// An MJCF opens the files of its `<include>` elements, and the meshes from which an inertia is computed; an SDF opens the files of its
/// `<include>` elements. `FILE#MODEL` is one of several models of an SDF file.
///
/// # Errors
/// [`LoadError`] with all findings if a finding is an error (at most 50 findings of each severity and file; further findings are
/// only counted).
pub fn load(source: &Source, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let mut report = Report::default();
    let Some(text) = source.text(&mut report) else {
        return Err(LoadError { diagnostics: report.finish(&source.name, "") });
    };
    let text = &*tolerant_text(text);
    match xml::root_name(text) {
        Some("sdf") => sdf::load::load_text(source, text, options, report),
        Some("mujoco") => {
            source.refuse_model("an MJCF", &mut report);
            mjcf::load::load_text(source, text, options, report)
        }
        _ => {
            source.refuse_model("a URDF", &mut report);
            urdf::load::load_text(&source.name, text, options, report)
        }
    }
}

/// Reads a model file of at most [`DEFAULT_MAX_SIZE`] bytes, with the default options. `-` is the standard input. See [`load`].
///
/// # Errors
/// [`LoadError`], also if the file cannot be read.
pub fn load_file(path: &str) -> Result<Loaded, LoadError> {
    load(&Source::read(path, DEFAULT_MAX_SIZE)?, &LoadOptions::default())
}
