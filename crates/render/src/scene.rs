//! The drawing model between layout and the two back ends: strokes, dots, patches, images and texts, in units of the page.
//!
//! x runs to the right and y downwards, from the upper left corner.

use crate::font::Font;
use crate::palette::{Colour, PAPER};
use crate::text::width;

/// A place on the page.
pub(crate) type Point = (f64, f64);

/// A page and what is on it, from the back to the front.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub width: f64,
    pub height: f64,
    /// What the picture is of, for those who cannot see it.
    pub caption: String,
    pub items: Vec<Item>,
}

/// One thing on the page.
#[derive(Clone, Debug)]
pub(crate) enum Item {
    /// Chains of straight lines, drawn alike.
    Lines { chains: Vec<Vec<Point>>, stroke: Stroke },
    /// Filled circles.
    Dots { centres: Vec<Point>, radius: f64, colour: Colour },
    /// A filled rectangle between two opposite corners.
    Patch { from: Point, to: Point, colour: Colour },
    /// A rectangle of pixels, three bytes each (red, green, blue), row by row from the upper left corner.
    Image { at: Point, size: (f64, f64), pixels: Vec<u8>, columns: usize },
    /// One line of text.
    Text(Text),
}

/// How a chain is drawn: round joins and butt ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stroke {
    pub colour: Colour,
    pub width: f64,
    /// Lengths of a dash and of the space after it.
    pub dash: Option<(f64, f64)>,
}

/// One line of text, on its baseline.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    /// Printable characters only, see [`crate::text::fit`].
    pub words: String,
    pub at: Point,
    pub anchor: Anchor,
    pub font: Font,
    pub colour: Colour,
}

/// Which end of a text its place is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

impl Scene {
    /// Adds lines; nothing where there are none.
    pub fn lines(&mut self, chains: Vec<Vec<Point>>, stroke: Stroke) {
        if !chains.is_empty() {
            self.items.push(Item::Lines { chains, stroke });
        }
    }

    /// Adds dots; nothing where there are none.
    pub fn dots(&mut self, centres: Vec<Point>, radius: f64, colour: Colour) {
        if !centres.is_empty() {
            self.items.push(Item::Dots { centres, radius, colour });
        }
    }

    /// Adds a text in the middle of a patch of paper, so that lines below do not cross it.
    pub fn text_on_paper(&mut self, words: String, at: Point, font: Font, colour: Colour) {
        let half = 0.5 * width(&words, font) + 3.0;
        let (top, bottom) = (at.1 - 0.85 * font.size, at.1 + 0.3 * font.size);
        self.items.push(Item::Patch { from: (at.0 - half, top), to: (at.0 + half, bottom), colour: PAPER });
        self.text(words, at, Anchor::Middle, font, colour);
    }

    /// Adds a text; nothing where it has no characters.
    pub fn text(&mut self, words: String, at: Point, anchor: Anchor, font: Font, colour: Colour) {
        if !words.is_empty() {
            self.items.push(Item::Text(Text { words, at, anchor, font, colour }));
        }
    }
}

/// A solid stroke.
pub(crate) fn solid(colour: Colour, width: f64) -> Stroke {
    Stroke { colour, width, dash: None }
}

/// The middle of the unit square a place lies in, so that a line one unit wide covers whole pixels.
pub(crate) fn crisp(v: f64) -> f64 {
    v.floor() + 0.5
}
