//! Pictures as files.

use crate::terminal::failure::Failure;
use percuss_render::Drawing;
use std::path::Path;

/// Encodes a drawing in the format given by the file extension.
pub fn bytes(drawing: &Drawing, flag: &str, path: &str) -> Result<Vec<u8>, Failure> {
    let ending = Path::new(path).extension().and_then(|e| e.to_str()).unwrap_or("");
    match ending.to_ascii_lowercase().as_str() {
        "svg" => Ok(drawing.to_svg().into_bytes()),
        "png" => drawing.to_png(2.0).map_err(Failure::from),
        "pdf" => drawing.to_pdf().map_err(Failure::from),
        _ => Err(Failure::bad_input(format!("{flag} {path}: its name must end in .svg, .png or .pdf"))),
    }
}
