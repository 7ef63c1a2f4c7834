//! Entry point of all readers of models: the root element of the file, or the ending `.adm`, selects the format.

use crate::reading::limits::LONGEST_HEAD;
use crate::reading::report::{NOT_READ, Report};
use crate::reading::tolerance::tolerant_text;
use crate::reading::xml;
use crate::sdf;
use crate::urdf::load::{LoadOptions, Loaded};
use crate::{DEFAULT_MAX_SIZE, Diagnostic, LoadError, Source, adams, mjcf, urdf};
use std::path::Path;

/// Reads a model: URDF (root `<robot>`), MJCF (root `<mujoco>`), SDFormat (root `<sdf>`) or a dataset of Adams Solver (file name ending in
/// `.adm`), closed loops and couplings included.
///
/// Units: m, kg, kg·m², rad. Inertias in a rotated frame are transformed to the link's axes, I = R I′ Rᵀ. A URDF opens no other file.
/// An MJCF opens the files of its `<include>` elements, and the meshes from which an inertia is computed; an SDF opens the files of its
/// `<include>` elements. `FILE#MODEL` is one of several models of an SDF file.
///
/// # Errors
/// [`LoadError`] with all findings if a finding is an error (at most 50 findings of each severity and file; further findings are
/// only counted).
pub fn load(source: &Source, options: &LoadOptions) -> Result<Loaded, LoadError> {
    if let Some(error) = foreign_format(source) {
        return Err(error);
    }
    let loaded = if adams::is_dataset(source) {
        adams::load_dataset(source, options)
    } else {
        load_xml(source, options)
    };
    let is_finding = |finding: &Diagnostic| finding.code != NOT_READ;
    let without_unread = |mut error: LoadError| {
        error.diagnostics.retain(is_finding);
        error
    };
    let mut loaded = loaded.map_err(without_unread)?;
    let is_unread = |finding: &&Diagnostic| UNREAD.contains(&finding.code);
    loaded.unread = loaded.diagnostics.iter().filter(is_unread).cloned().collect();
    loaded.diagnostics.retain(is_finding);
    Ok(loaded)
}

/// Reads a model in XML.
fn load_xml(source: &Source, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let mut report = Report::default();
    let Some(text) = source.text(&mut report) else {
        return Err(LoadError { diagnostics: report.finish(&source.name, "") });
    };
    let text = &*tolerant_text(&text, &mut report);
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

/// Codes of the findings about parts of a file that are no part of a mechanism.
const UNREAD: [&str; 5] = [NOT_READ, "ignored", "unknown-element", "unknown-attribute", "stray-text"];

/// Endings of file names of other formats, and their names.
const FOREIGN_ENDINGS: [(&[&str], &str); 13] = [
    (&["usd", "usda", "usdc", "usdz"], USD),
    (&["osim"], "an OpenSim model"),
    (&["rob"], "a robot of Klampt"),
    (&["lua"], "a Lua file, such as a model of RBDL"),
    (&["yaml", "yml"], "a YAML file"),
    (&["cmd", "acf"], "a file of Adams View"),
    (&["pm"], "a suspension of rFactor"),
    (&["m", "mat", "mlx", "slx", "mdl"], "a file of MATLAB"),
    (&["py"], "a Python program"),
    (&["proto", "wbt"], "a file of Webots"),
    (&["skel"], "a model of DART"),
    (&["fmu"], "a functional mock-up unit"),
    (&["stl", "obj", "ply", "step", "stp"], "a shape without masses and joints"),
];

/// Root elements of other formats in XML, and their names.
const FOREIGN_ROOTS: [(&str, &str); 7] = [
    ("OpenSimDocument", "an OpenSim model"),
    ("Robot", "a robot of OpenRAVE"),
    ("KinBody", "a body of OpenRAVE"),
    ("Environment", "an environment of OpenRAVE"),
    ("skel", "a model of DART"),
    ("world", "a world of Klampt"),
    ("SimscapeMultibodyImportXML", "an export to Simscape Multibody"),
];

const USD: &str = "a scene in USD (Python: percuss.from_usd)";

/// Error that names the format of a file that is not read, by its root element, its first bytes or the ending of its name; `None` for
/// other files.
pub fn foreign_format(source: &Source) -> Option<LoadError> {
    let bytes = source.bytes.trim_ascii_start();
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(LONGEST_HEAD)]);
    let kind = if head.starts_with("#usda") || head.starts_with("PXR-USDC") {
        USD
    } else if head.starts_with('<') {
        let root = xml::root_name(&head)?;
        FOREIGN_ROOTS.iter().find(|(name, _)| *name == root)?.1
    } else if bytes.is_empty() {
        return None;
    } else {
        let ending = Path::new(source.file()).extension()?.to_str()?.to_ascii_lowercase();
        FOREIGN_ENDINGS.iter().find(|(endings, _)| endings.contains(&&*ending))?.1
    };
    let message = format!(
        "this is {kind}, which is not read. Read are URDF (<robot>), MJCF (<mujoco>), SDFormat \
         (<sdf>) and datasets of Adams Solver (.adm), and of suspensions sheets (.toml), \
         tables of points (.csv, .xlsx), subsystems of Adams (.sub), JSON of Chrono::Vehicle, YAML of \
         Suspension Explorer and suspensions of rFactor (.pm): export one of these from the program that \
         wrote the file"
    );
    Some(LoadError::of_file(&source.name, "foreign-format", message))
}

/// Reads a model file of at most [`DEFAULT_MAX_SIZE`] bytes, with the default options. `-` is the standard input. See [`load`].
///
/// # Errors
/// [`LoadError`], also if the file cannot be read.
pub fn load_file(path: &str) -> Result<Loaded, LoadError> {
    load(&Source::read(path, DEFAULT_MAX_SIZE)?, &LoadOptions::default())
}
