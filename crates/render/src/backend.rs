//! Rasterises SVG with resvg and the embedded fonts of `assets/`. Fonts installed on the machine are not used.

use crate::limits;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::{Database, Language, Source};
use resvg::usvg::{Options, Tree};
use std::sync::{Arc, LazyLock};
use thiserror::Error;

/// Producer comment of every written file whose format has a field for comments.
pub const MADE_BY: &str = "made by percuss";

/// The two embedded faces, registered as one family.
static FONTS: LazyLock<Arc<Database>> = LazyLock::new(|| {
    let mut all = Database::new();
    for (bytes, _) in crate::font::FACES {
        all.load_font_source(Source::Binary(Arc::new(bytes)));
    }
    // The medium face declares a family name of its own; replace the name.
    let mut fonts = Database::new();
    for face in all.faces() {
        let mut face = face.clone();
        face.families = vec![(crate::font::FAMILY.into(), Language::English_UnitedStates)];
        fonts.push_face_info(face);
    }
    fonts.set_sans_serif_family(crate::font::FAMILY);
    Arc::new(fonts)
});

/// Error of writing a PNG or PDF.
#[derive(Debug, Error)]
pub enum RenderError {
    /// The scale is not a positive number.
    #[error("the scale of a PNG is {scale}; it must be a positive number, such as 2")]
    Scale {
        /// The given scale.
        scale: f32,
    },
    /// The picture would be larger than 2^25 pixels.
    #[error(
        "a PNG of {width:.0} by {height:.0} pixels was asked for, and {max_pixels:.0} pixels are the most: \
         take a scale below {max_scale:.2}, or write an SVG"
    )]
    TooLarge {
        /// Width, pixels.
        width: f64,
        /// Height, pixels.
        height: f64,
        /// Limit of the number of pixels.
        max_pixels: f64,
        /// Largest scale within the limit.
        max_scale: f64,
    },
    /// The SVG could not be read back.
    #[error("the SVG could not be read back")]
    Svg {
        /// Error of the SVG parser.
        #[source]
        source: resvg::usvg::Error,
    },
    /// The encoder failed.
    #[error("the PNG encoder failed")]
    Encoder {
        /// Error of the encoder.
        #[source]
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// The PDF could not be made.
    #[error("the PDF could not be made: {message}")]
    Pdf {
        /// Message of svg2pdf.
        message: String,
    },
}

/// Parses an SVG with the embedded fonts.
pub(crate) fn tree(svg: &str) -> Result<Tree, RenderError> {
    let options =
        Options { fontdb: FONTS.clone(), font_family: crate::font::FAMILY.into(), ..Options::default() };
    Tree::from_str(svg, &options).map_err(|source| RenderError::Svg { source })
}

/// Renders the SVG with `scale` pixels per page unit.
pub(crate) fn png(svg: &str, scale: f32) -> Result<Vec<u8>, RenderError> {
    if !(scale.is_finite() && scale > 0.0) {
        return Err(RenderError::Scale { scale });
    }
    let tree = tree(svg)?;
    let size = [tree.size().width(), tree.size().height()].map(f64::from);
    let [width, height] = size.map(|s| (s * f64::from(scale)).round().max(1.0));
    let too_large = || {
        let max_scale = (limits::MAX_PIXELS / (size[0] * size[1])).sqrt();
        RenderError::TooLarge { width, height, max_pixels: limits::MAX_PIXELS, max_scale }
    };
    if width * height > limits::MAX_PIXELS {
        return Err(too_large());
    }
    let mut pixmap = Pixmap::new(width as u32, height as u32).ok_or_else(too_large)?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    // The page is opaque, so the alpha channel is dropped.
    let pixels: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    encode_png(&pixels, pixmap.width(), pixmap.height())
        .map_err(|source| RenderError::Encoder { source: Box::new(source) })
}

/// Encodes RGB pixels as PNG; `None` if they do not form a rectangle.
pub(crate) fn png_from_pixels(pixels: &[u8], columns: usize) -> Option<Vec<u8>> {
    let rows = (pixels.len() / 3).checked_div(columns)?;
    encode_png(&pixels[..3 * columns * rows], u32::try_from(columns).ok()?, u32::try_from(rows).ok()?).ok()
}

/// Encodes RGB pixels as PNG, with the producer comment.
fn encode_png(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.add_text_chunk("Comment".into(), MADE_BY.into())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}
