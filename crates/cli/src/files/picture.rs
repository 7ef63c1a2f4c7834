//! Pictures as files.

use crate::terminal::failure::Failure;
use percuss_render::{Drawing, RenderError};
use std::path::Path;

/// Encodes a drawing in the format given by the file extension.
pub fn bytes(drawing: &Drawing, flag: &str, path: &str) -> Result<Vec<u8>, Failure> {
    let ending = Path::new(path).extension().and_then(|e| e.to_str()).unwrap_or("");
    let failed = |error: RenderError| Failure::NoAnswer(error.to_string());
    match ending.to_ascii_lowercase().as_str() {
        "svg" => Ok(drawing.to_svg().into_bytes()),
        "png" => drawing.to_png(2.0).map_err(failed),
        "pdf" => drawing.to_pdf().map_err(failed),
        _ => Err(Failure::bad_input(format!("{flag} {path}: its name must end in .svg, .png or .pdf"))),
    }
}
