//! The two embedded faces: the width of a text, and where each of its glyphs goes.
//!
//! No shaping: one glyph after the other, accents centred over the letter before them. That serves every script
//! the faces hold (Latin, Greek, Cyrillic); a character they lack is written in others (`→` as `->`) or as a box.

use std::sync::LazyLock;
use ttf_parser::{Face, GlyphId};

/// A face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Weight {
    Regular,
    Medium,
}

static REGULAR: LazyLock<Face<'static>> =
    LazyLock::new(|| embedded(include_bytes!("../assets/Roboto-Regular.subset.ttf")));
static MEDIUM: LazyLock<Face<'static>> =
    LazyLock::new(|| embedded(include_bytes!("../assets/Roboto-Medium.subset.ttf")));

fn embedded(bytes: &'static [u8]) -> Face<'static> {
    Face::parse(bytes, 0).expect("the embedded face is a font")
}

impl Weight {
    /// Its outlines.
    pub fn face(self) -> &'static Face<'static> {
        match self {
            Weight::Regular => &REGULAR,
            Weight::Medium => &MEDIUM,
        }
    }
}

/// A face at a size, in units of the page to the em.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Font {
    pub weight: Weight,
    pub size: f64,
}

/// A glyph and the place of its origin, in ems; y upwards.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed {
    pub glyph: GlyphId,
    pub x: f64,
    pub y: f64,
}

/// Sets a text from left to right, a character at a time.
pub(crate) struct Typesetter {
    face: &'static Face<'static>,
    /// Length of the line so far, in ems.
    pub advance: f64,
    /// The glyphs so far.
    pub glyphs: Vec<Placed>,
    /// The letter that an accent would go on: its middle and its top, in font units.
    base: Option<(f64, f64)>,
}

impl Typesetter {
    pub fn new(weight: Weight) -> Self {
        Typesetter { face: weight.face(), advance: 0.0, glyphs: Vec::new(), base: None }
    }

    /// Sets one more character.
    pub fn push(&mut self, character: char) {
        if is_invisible(character) {
            return;
        }
        let accent = is_accent(character);
        match (self.face.glyph_index(character), accent) {
            (Some(glyph), true) => self.push_accent(glyph, character),
            (Some(glyph), false) => self.push_glyph(glyph),
            (None, true) => {}
            (None, false) => match stand_in(character) {
                Some(others) => others.chars().for_each(|c| self.push(c)),
                None => self.push_glyph(GlyphId(0)),
            },
        }
    }

    fn push_glyph(&mut self, glyph: GlyphId) {
        let em = f64::from(self.face.units_per_em());
        let width = f64::from(self.face.glyph_hor_advance(glyph).unwrap_or(0));
        let top = self.face.glyph_bounding_box(glyph).map_or(0.0, |b| f64::from(b.y_max));
        self.glyphs.push(Placed { glyph, x: self.advance, y: 0.0 });
        self.base = Some((self.advance * em + 0.5 * width, top));
        self.advance += width / em;
    }

    /// Above the letter, higher where it is taller than an x; below it as the face has it.
    fn push_accent(&mut self, glyph: GlyphId, accent: char) {
        let Some(bounds) = self.face.glyph_bounding_box(glyph) else { return };
        let em = f64::from(self.face.units_per_em());
        let (middle, top) = self.base.unwrap_or((self.advance * em, 0.0));
        let x = middle - 0.5 * (f64::from(bounds.x_min) + f64::from(bounds.x_max));
        let below = matches!(accent, '\u{0316}'..='\u{0333}');
        let x_height = f64::from(self.face.x_height().unwrap_or(0));
        // A round letter overshoots the x-height by a little; its accent stays level with the others.
        let lift = if below || top < 1.05 * x_height { 0.0 } else { top - x_height };
        self.glyphs.push(Placed { glyph, x: x / em, y: lift / em });
        if !below {
            let height = f64::from(bounds.y_max) - f64::from(bounds.y_min);
            self.base = Some((middle, top.max(x_height) + height + 0.05 * em));
        }
    }
}

/// Characters without width and outline: joiners, direction marks, variation selectors.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200B}'..='\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2060}'..='\u{206F}'
        | '\u{FE00}'..='\u{FE0F}' | '\u{FEFF}' | '\u{00AD}')
}

fn is_accent(c: char) -> bool {
    matches!(c, '\u{0300}'..='\u{036F}' | '\u{1AB0}'..='\u{1AFF}' | '\u{1DC0}'..='\u{1DFF}'
        | '\u{20D0}'..='\u{20FF}')
}

/// Signs that the faces lack, in other characters.
fn stand_in(c: char) -> Option<&'static str> {
    Some(match c {
        '→' | '⟶' => "->",
        '←' | '⟵' => "<-",
        '↔' => "<->",
        '⇒' => "=>",
        '∥' => "||",
        '⋅' => "·",
        '‑' => "-",
        '\u{2000}'..='\u{200A}' | '\u{202F}' | '\u{205F}' | '\u{3000}' => " ",
        _ => return None,
    })
}
