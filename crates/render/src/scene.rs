//! Drawing model between layout and the two back ends: strokes, dots, patches, images and texts, in page units.
//!
//! x points to the right and y downwards, from the upper left corner.

use crate::font::Font;
use crate::palette::Colour;

/// Position on the page.
pub(crate) type Point = (f64, f64);

/// Page with its items, from back to front.
#[derive(Clone, Debug)]
pub struct Scene {
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// Description of the picture for screen readers.
    pub(crate) caption: String,
    pub(crate) items: Vec<Item>,
}

/// Item of a page.
#[derive(Clone, Debug)]
pub(crate) enum Item {
    /// Polylines with the same stroke.
    Lines { chains: Vec<Vec<Point>>, stroke: Stroke },
    /// Filled circles.
    Dots { centres: Vec<Point>, radius: f64, colour: Colour },
    /// A filled rectangle between two opposite corners.
    Patch { from: Point, to: Point, colour: Colour },
    /// A filled polygon.
    Area { corners: Vec<Point>, colour: Colour },
    /// Rectangle of RGB pixels, row by row from the upper left corner.
    Image { at: Point, size: (f64, f64), pixels: Vec<u8>, columns: usize },
    /// One line of text.
    Text(Text),
    /// Invisible disc with a text that viewers show while the pointer is over the disc.
    Hover { at: Point, radius: f64, title: String },
}

/// Stroke of a polyline, with round joins and butt ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stroke {
    pub colour: Colour,
    pub width: f64,
    /// Lengths of a dash and of the gap after it.
    pub dash: Option<(f64, f64)>,
}

/// One line of text; `at` is on its baseline.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    /// Printable characters only, see [`crate::text::fit`].
    pub content: String,
    pub at: Point,
    pub anchor: Anchor,
    pub font: Font,
    pub colour: Colour,
    /// True for an edge of paper colour about the glyphs, so that lines below stay apart.
    pub has_halo: bool,
}

/// Alignment of a text relative to its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

impl Scene {
    /// Adds polylines, if there are any.
    pub(crate) fn lines(&mut self, chains: Vec<Vec<Point>>, stroke: Stroke) {
        if !chains.is_empty() {
            self.items.push(Item::Lines { chains, stroke });
        }
    }

    /// Adds dots, if there are any.
    pub(crate) fn dots(&mut self, centres: Vec<Point>, radius: f64, colour: Colour) {
        if !centres.is_empty() {
            self.items.push(Item::Dots { centres, radius, colour });
        }
    }

    /// Adds an invisible disc with a text for the pointer.
    pub(crate) fn hover(&mut self, at: Point, radius: f64, title: String) {
        self.items.push(Item::Hover { at, radius, title });
    }

    /// Adds a text whose glyphs have an edge of paper colour, unless it is empty.
    pub(crate) fn text_with_halo(
        &mut self,
        content: String,
        at: Point,
        anchor: Anchor,
        font: Font,
        colour: Colour,
    ) {
        if !content.is_empty() {
            self.items.push(Item::Text(Text { content, at, anchor, font, colour, has_halo: true }));
        }
    }

    /// Adds a text, unless it is empty.
    pub(crate) fn text(&mut self, content: String, at: Point, anchor: Anchor, font: Font, colour: Colour) {
        if !content.is_empty() {
            self.items.push(Item::Text(Text { content, at, anchor, font, colour, has_halo: false }));
        }
    }
}

/// A solid stroke.
pub(crate) fn solid(colour: Colour, width: f64) -> Stroke {
    Stroke { colour, width, dash: None }
}

/// Centre of the unit square that contains `v`, so that a line one unit wide covers whole pixels.
pub(crate) fn pixel_centre(v: f64) -> f64 {
    v.floor() + 0.5
}
