//! Converts pictures to PNG with resvg, and to PDF with svg2pdf, with the embedded fonts of `assets/`. Fonts installed on the machine
//! are not used.

mod pdf;
mod pdf_objects;

pub(crate) use pdf::pdf;

use crate::backend::{RenderError, encode_png};
use crate::limits;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::{Database, Language, Source};
use resvg::usvg::{Options, Tree};
use std::sync::{Arc, LazyLock};

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

/// Parses an SVG with the embedded fonts.
fn tree(svg: &str) -> Result<Tree, RenderError> {
    let options =
        Options { fontdb: FONTS.clone(), font_family: crate::font::FAMILY.into(), ..Options::default() };
    Tree::from_str(svg, &options).map_err(|source| RenderError::Svg { source: Box::new(source) })
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
