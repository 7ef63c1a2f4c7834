//! A model that was read: the mechanism, what was found, and which bytes it came from.

use crate::record::DiagnosticRecord;
use percuss_formats::{LoadError, LoadOptions, Shape, Source, load};
use percuss_mechanism::Mechanism;
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::sync::Arc;

/// Which bytes an answer stands on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Input {
    /// The file as the user named it.
    pub path: String,
    /// SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
}

impl Input {
    /// Names a source and its bytes.
    pub fn of(source: &Source) -> Self {
        Self { path: source.name.clone(), sha256: hexadecimal(&Sha256::digest(&source.bytes)) }
    }
}

/// Bytes in hexadecimal.
pub(crate) fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A mechanism read from a file.
#[derive(Clone, Debug)]
pub struct Model {
    /// The mechanism.
    pub mechanism: Arc<Mechanism>,
    /// The files it came from: the model's, and the study's that adds to it.
    pub inputs: Vec<Input>,
    /// The shapes of every link, in link order.
    pub shapes: Arc<Vec<Vec<Shape>>>,
    /// Warnings and notes found while reading.
    pub diagnostics: Vec<DiagnosticRecord>,
}

impl Model {
    /// Reads a URDF file; `-` is the standard input. At most `max_size` bytes.
    ///
    /// # Errors
    /// [`LoadError`] with everything that was found, errors with their places.
    pub fn load(path: &str, max_size: u64, options: &LoadOptions) -> Result<Self, LoadError> {
        Self::of(&Source::read(path, max_size)?, options)
    }

    /// Reads a URDF that is at hand already.
    ///
    /// # Errors
    /// [`LoadError`], as for [`load`](Self::load).
    pub fn of(source: &Source, options: &LoadOptions) -> Result<Self, LoadError> {
        let loaded = load(source, options)?;
        Ok(Self {
            mechanism: Arc::new(loaded.mechanism),
            inputs: vec![Input::of(source)],
            shapes: Arc::new(loaded.shapes),
            diagnostics: loaded.diagnostics.into_iter().map(Into::into).collect(),
        })
    }
}
