//! A scene as pixels.

use crate::font::{Typesetter, Weight};
use crate::limits;
use crate::palette::{Colour, PAPER};
use crate::scene::{Anchor, Item, Point, Scene, Stroke, Text};
use thiserror::Error;
use tiny_skia::{
    FillRule, FilterQuality, LineJoin, Paint, Path, PathBuilder, Pixmap, PixmapPaint, Rect,
    Stroke as SkiaStroke, StrokeDash, Transform,
};
use ttf_parser::{GlyphId, OutlineBuilder};

/// Why there is no PNG.
#[derive(Debug, Error)]
pub enum RenderError {
    /// The scale was not a positive number.
    #[error("the scale of a PNG is {scale}; it must be a positive number, such as 2")]
    Scale {
        /// As given.
        scale: f32,
    },
    /// The picture would be larger than 2^25 pixels.
    #[error(
        "a PNG of {width:.0} by {height:.0} pixels was asked for, and {most:.0} pixels are the most: \
         take a scale below {fitting:.2}, or write an SVG"
    )]
    TooLarge {
        /// In pixels.
        width: f64,
        /// In pixels.
        height: f64,
        /// The limit, in pixels.
        most: f64,
        /// The scale that just fits.
        fitting: f64,
    },
    /// The encoder failed.
    #[error("the PNG encoder failed")]
    Encoder {
        /// Its error.
        #[source]
        source: Box<dyn std::error::Error + Send + Sync>,
    },
}

/// The picture with `scale` pixels to a unit.
pub(crate) fn draw(scene: &Scene, scale: f32) -> Result<Vec<u8>, RenderError> {
    let too_large = |width, height| {
        let fitting = (limits::MOST_PIXELS / (scene.width * scene.height)).sqrt();
        RenderError::TooLarge { width, height, most: limits::MOST_PIXELS, fitting }
    };
    if !(scale.is_finite() && scale > 0.0) {
        return Err(RenderError::Scale { scale });
    }
    let [width, height] = [scene.width, scene.height].map(|s| (s * f64::from(scale)).round().max(1.0));
    if width * height > limits::MOST_PIXELS {
        return Err(too_large(width, height));
    }
    let mut pixmap = Pixmap::new(width as u32, height as u32).ok_or_else(|| too_large(width, height))?;
    pixmap.fill(paper());
    let mut canvas = Canvas { pixmap, transform: Transform::from_scale(scale, scale) };
    for item in &scene.items {
        match item {
            Item::Lines { chains, stroke } => canvas.lines(chains, stroke),
            Item::Dots { centres, radius, colour } => canvas.dots(centres, *radius, *colour),
            Item::Patch { from, to, colour } => canvas.patch(*from, *to, *colour),
            Item::Image { at, side, pixels, columns } => canvas.image(*at, *side, pixels, *columns),
            Item::Text(text) => canvas.words(text),
        }
    }
    canvas.pixmap.encode_png().map_err(|source| RenderError::Encoder { source: Box::new(source) })
}

/// Pixels of three bytes as a PNG; none where they make no rectangle.
pub(crate) fn of_pixels(pixels: &[u8], columns: usize) -> Option<Vec<u8>> {
    pixmap_of(pixels, columns)?.encode_png().ok()
}

fn pixmap_of(pixels: &[u8], columns: usize) -> Option<Pixmap> {
    let rows = (pixels.len() / 3).checked_div(columns)?;
    let mut pixmap = Pixmap::new(u32::try_from(columns).ok()?, u32::try_from(rows).ok()?)?;
    for (to, from) in pixmap.data_mut().chunks_exact_mut(4).zip(pixels.chunks_exact(3)) {
        to.copy_from_slice(&[from[0], from[1], from[2], 255]);
    }
    Some(pixmap)
}

fn paper() -> tiny_skia::Color {
    tiny_skia::Color::from_rgba8(PAPER.0, PAPER.1, PAPER.2, 255)
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(colour.0, colour.1, colour.2, 255);
    paint
}

/// Pixels, and how a unit of the page becomes them.
struct Canvas {
    pixmap: Pixmap,
    transform: Transform,
}

impl Canvas {
    fn lines(&mut self, chains: &[Vec<Point>], stroke: &Stroke) {
        let mut builder = PathBuilder::new();
        for chain in chains {
            for (i, &(x, y)) in chain.iter().enumerate() {
                match i {
                    0 => builder.move_to(x as f32, y as f32),
                    _ => builder.line_to(x as f32, y as f32),
                }
            }
        }
        let Some(path) = builder.finish() else { return };
        let dash = stroke.dash.and_then(|(on, off)| StrokeDash::new(vec![on as f32, off as f32], 0.0));
        let width = stroke.width as f32;
        let stroke_like = SkiaStroke { width, dash, line_join: LineJoin::Round, ..SkiaStroke::default() };
        self.pixmap.stroke_path(&path, &paint(stroke.colour), &stroke_like, self.transform, None);
    }

    fn dots(&mut self, centres: &[Point], radius: f64, colour: Colour) {
        let mut builder = PathBuilder::new();
        for &(x, y) in centres {
            builder.push_circle(x as f32, y as f32, radius as f32);
        }
        self.fill(builder.finish(), colour);
    }

    fn patch(&mut self, from: Point, to: Point, colour: Colour) {
        let rect = Rect::from_ltrb(from.0 as f32, from.1 as f32, to.0 as f32, to.1 as f32);
        self.fill(rect.map(PathBuilder::from_rect), colour);
    }

    fn image(&mut self, at: Point, side: f64, pixels: &[u8], columns: usize) {
        let Some(image) = pixmap_of(pixels, columns) else { return };
        let scale = (side / columns as f64) as f32;
        let place = self.transform.pre_translate(at.0 as f32, at.1 as f32).pre_scale(scale, scale);
        let paint = PixmapPaint { quality: FilterQuality::Bilinear, ..PixmapPaint::default() };
        self.pixmap.draw_pixmap(0, 0, image.as_ref(), &paint, place, None);
    }

    fn words(&mut self, text: &Text) {
        let mut typesetter = Typesetter::new(text.font.weight);
        text.words.chars().for_each(|c| typesetter.push(c));
        let size = text.font.size;
        let before = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * typesetter.advance * size,
            Anchor::End => typesetter.advance * size,
        };
        let mut builder = PathBuilder::new();
        for placed in &typesetter.glyphs {
            let origin = (text.at.0 - before + placed.x * size, text.at.1 - placed.y * size);
            Outline::draw(text.font.weight, placed.glyph, origin, size, &mut builder);
        }
        self.fill(builder.finish(), text.colour);
    }

    fn fill(&mut self, path: Option<Path>, colour: Colour) {
        if let Some(path) = path {
            self.pixmap.fill_path(&path, &paint(colour), FillRule::Winding, self.transform, None);
        }
    }
}

/// Takes a glyph's outline to the page.
struct Outline<'a> {
    builder: &'a mut PathBuilder,
    origin: (f32, f32),
    scale: f32,
}

impl Outline<'_> {
    fn draw(weight: Weight, glyph: GlyphId, origin: Point, size: f64, builder: &mut PathBuilder) {
        let face = weight.face();
        let scale = (size / f64::from(face.units_per_em())) as f32;
        let mut outline = Outline { builder, origin: (origin.0 as f32, origin.1 as f32), scale };
        // A glyph without an outline is a space.
        let _ = face.outline_glyph(glyph, &mut outline);
    }

    fn place(&self, x: f32, y: f32) -> (f32, f32) {
        (self.origin.0 + x * self.scale, self.origin.1 - y * self.scale)
    }
}

impl OutlineBuilder for Outline<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.builder.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.builder.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.place(x1, y1), self.place(x, y));
        self.builder.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.place(x1, y1), self.place(x2, y2), self.place(x, y));
        self.builder.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}
