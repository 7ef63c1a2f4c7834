//! Errors of pictures, and the PNG encoder.

use thiserror::Error;

/// Producer comment of every written file whose format has a field for comments.
pub const MADE_BY: &str = "made by percuss";

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
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// The encoder failed.
    #[error("the PNG encoder failed")]
    Encoder {
        /// Error of the encoder.
        #[source]
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// PNG and PDF need the feature `convert`.
    #[error(
        "this build of percuss writes no PNG and no PDF; write .svg, or build it with `cargo build --release --features pictures`"
    )]
    NotBuilt,
    /// The PDF could not be made.
    #[error("the PDF could not be made: {message}")]
    Pdf {
        /// Message of svg2pdf.
        message: String,
    },
}

/// Encodes RGB pixels as PNG; `None` if they do not form a rectangle.
pub(crate) fn png_from_pixels(pixels: &[u8], columns: usize) -> Option<Vec<u8>> {
    let rows = (pixels.len() / 3).checked_div(columns)?;
    encode_png(&pixels[..3 * columns * rows], u32::try_from(columns).ok()?, u32::try_from(rows).ok()?).ok()
}

/// Encodes RGB pixels as PNG, with the producer comment.
pub(crate) fn encode_png(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, png::EncodingError> {
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
