//! Drawing of a mechanism in two or three orthographic views: lines, circles, symbols, arrows and named points in space.

mod items;
mod key;
mod layout;
mod numbers;
mod shapes;
mod symbols;
mod vectors;

pub use self::shapes::{Drawing, DrawnArrow, DrawnCircle, DrawnFacet, DrawnLine, DrawnSymbol, SymbolKind};

use crate::backend::RenderError;
use crate::convert;
use crate::svg;

impl Drawing {
    /// Returns the drawing as an SVG document.
    pub fn to_svg(&self) -> String {
        svg::write(&layout::layout_drawing(self))
    }

    /// Returns the drawing as a PNG with `scale` pixels per page unit.
    ///
    /// # Errors
    /// [`RenderError::Scale`], or [`RenderError::TooLarge`] above 2^25 pixels.
    pub fn to_png(&self, scale: f32) -> Result<Vec<u8>, RenderError> {
        convert::png(&self.to_svg(), scale)
    }

    /// Returns the drawing as a PDF of one page with embedded fonts.
    ///
    /// # Errors
    /// Errors of the PDF writer.
    pub fn to_pdf(&self) -> Result<Vec<u8>, RenderError> {
        convert::pdf(&layout::layout_drawing(self))
    }
}
