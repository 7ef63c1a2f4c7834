//! The two embedded font faces, and text widths in them.
//!
//! Text width is the sum of the glyph advances; combining accents have zero width. This is valid for the
//! scripts of the faces (Latin, Greek, Cyrillic). A missing character is replaced by others (`→` by `->`) or
//! shown as a box.

use std::sync::LazyLock;
use ttf_parser::{Face, GlyphId};

/// Font face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Weight {
    Regular,
    Medium,
}

/// Family name of both faces.
#[cfg(feature = "convert")]
pub(crate) const FAMILY: &str = "Roboto";

/// Font files.
pub(crate) const FACES: [(&[u8], Weight); 2] = [
    (include_bytes!("../assets/Roboto-Regular.subset.ttf"), Weight::Regular),
    (include_bytes!("../assets/Roboto-Medium.subset.ttf"), Weight::Medium),
];

static REGULAR: LazyLock<Face<'static>> = LazyLock::new(|| parse_face(FACES[0].0));
static MEDIUM: LazyLock<Face<'static>> = LazyLock::new(|| parse_face(FACES[1].0));

/// Parses an embedded font file.
fn parse_face(bytes: &'static [u8]) -> Face<'static> {
    Face::parse(bytes, 0).expect("the embedded face is a font")
}

impl Weight {
    /// Parsed face.
    pub fn face(self) -> &'static Face<'static> {
        match self {
            Weight::Regular => &REGULAR,
            Weight::Medium => &MEDIUM,
        }
    }
}

/// Face and size; the size is page units per em.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Font {
    pub weight: Weight,
    pub size: f64,
}

/// Advance width of a character, in em.
pub(crate) fn advance(weight: Weight, character: char) -> f64 {
    if is_invisible(character) || is_accent(character) {
        return 0.0;
    }
    let face = weight.face();
    let of = |glyph| {
        let width = f64::from(face.glyph_hor_advance(glyph).unwrap_or(0));
        width / f64::from(face.units_per_em())
    };
    match (face.glyph_index(character), substitute(character)) {
        (Some(glyph), _) => of(glyph),
        (None, Some(others)) => others.chars().filter_map(|c| face.glyph_index(c)).map(of).sum(),
        (None, None) => of(GlyphId(0)),
    }
}

/// Replaces characters that the faces lack, if a substitute exists.
pub(crate) fn substitute_missing(text: &str) -> String {
    let has = |c| Weight::Regular.face().glyph_index(c).is_some();
    let mut out = String::with_capacity(text.len());
    for c in text.chars().filter(|c| !is_invisible(*c)) {
        match substitute(c).filter(|_| !has(c)) {
            Some(others) => out += others,
            None => out.push(c),
        }
    }
    out
}

/// True for characters without width and outline: joiners, direction marks, variation selectors.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200B}'..='\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2060}'..='\u{206F}'
        | '\u{FE00}'..='\u{FE0F}' | '\u{FEFF}' | '\u{00AD}')
}

/// True for combining accents, which have zero width.
fn is_accent(c: char) -> bool {
    matches!(c, '\u{0300}'..='\u{036F}' | '\u{1AB0}'..='\u{1AFF}' | '\u{1DC0}'..='\u{1DFF}'
        | '\u{20D0}'..='\u{20FF}')
}

/// Substitute of a character that the faces lack.
fn substitute(c: char) -> Option<&'static str> {
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
