//! Output of pictures as SVG, PNG and PDF.

use crate::backend::RenderError;
use crate::scene::Scene;
use crate::{convert, svg};

/// Picture with a layout on a page.
pub trait Laid {
    /// Strokes, dots, patches and texts on the page.
    fn layout_scene(&self) -> Scene;
}

/// Output of a figure, sheet, drawing, chart or skin.
pub trait Picture {
    /// Returns the picture as an SVG document. Cost: linear in the number of points.
    fn to_svg(&self) -> String;

    /// Returns the picture as a PNG with `scale` pixels per page unit: 1 for a small screen, 2 for a sharp screen or for print.
    ///
    /// # Errors
    /// [`RenderError::Scale`], or [`RenderError::TooLarge`] above 2^25 pixels.
    fn to_png(&self, scale: f32) -> Result<Vec<u8>, RenderError>;

    /// Returns the picture as a PDF of one page with embedded fonts.
    ///
    /// # Errors
    /// Errors of the PDF writer.
    fn to_pdf(&self) -> Result<Vec<u8>, RenderError>;
}

impl<P: Laid> Picture for P {
    fn to_svg(&self) -> String {
        svg::write(&self.layout_scene())
    }

    fn to_png(&self, scale: f32) -> Result<Vec<u8>, RenderError> {
        convert::png(&self.to_svg(), scale)
    }

    fn to_pdf(&self) -> Result<Vec<u8>, RenderError> {
        convert::pdf(&self.layout_scene())
    }
}
