//! PNG and PDF in a build without the feature `convert`.

use crate::backend::RenderError;
use crate::scene::Scene;

pub(crate) fn png(_svg: &str, _scale: f32) -> Result<Vec<u8>, RenderError> {
    Err(RenderError::NotBuilt)
}

pub(crate) fn pdf(_scene: &Scene) -> Result<Vec<u8>, RenderError> {
    Err(RenderError::NotBuilt)
}
