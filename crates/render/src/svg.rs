//! Writes a scene as an SVG document.

use crate::backend::{MADE_BY, of_pixels};
use crate::palette::{Colour, PAPER};
use crate::scene::{Anchor, Item, Point, Scene, Stroke, Text};
use base64::Engine;
use std::fmt::{Display, Formatter, Result, Write};

/// Roboto if installed, otherwise fonts of about the same width.
const FAMILY: &str = "Roboto, 'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif";

/// Returns the document; coordinates are rounded to 0.01.
pub(crate) fn write(scene: &Scene) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = document(scene, &mut out);
    out
}

/// Returns the document without paper and images; the PDF writer adds these below.
pub(crate) fn write_over(scene: &Scene) -> String {
    let mut out = String::new();
    let _ = head(scene, &mut out).and_then(|()| items(scene, false, &mut out));
    out
}

fn document(scene: &Scene, out: &mut String) -> Result {
    head(scene, out)?;
    let (w, h) = (Number(scene.width), Number(scene.height));
    writeln!(out, r#"<rect width="{w}" height="{h}" fill="{PAPER}"/>"#)?;
    items(scene, true, out)
}

fn head(scene: &Scene, out: &mut String) -> Result {
    let (w, h) = (Number(scene.width), Number(scene.height));
    writeln!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}" role="img" font-family="{FAMILY}">"#
    )?;
    writeln!(out, "<title>{}</title>", Escaped(&scene.caption))?;
    writeln!(out, "<metadata>{MADE_BY}</metadata>")
}

fn items(scene: &Scene, with_images: bool, out: &mut String) -> Result {
    for item in &scene.items {
        match item {
            Item::Lines { chains, stroke } => lines(chains, stroke, out)?,
            Item::Dots { centres, radius, colour } => dots(centres, *radius, *colour, out)?,
            Item::Patch { from, to, colour } => patch(*from, *to, *colour, out)?,
            Item::Image { .. } if !with_images => {}
            Item::Image { at, size, pixels, columns } => image(*at, *size, pixels, *columns, out)?,
            Item::Text(text) => words(text, out)?,
        }
    }
    writeln!(out, "</svg>")
}

fn lines(chains: &[Vec<Point>], stroke: &Stroke, out: &mut String) -> Result {
    write!(out, r#"<path d=""#)?;
    for chain in chains {
        let mut command = 'M';
        for &(x, y) in chain {
            write!(out, "{command}{} {}", Number(x), Number(y))?;
            command = 'L';
        }
    }
    write!(out, r#"" fill="none" stroke="{}" stroke-width="{}""#, stroke.colour, Number(stroke.width))?;
    if let Some((on, off)) = stroke.dash {
        write!(out, r#" stroke-dasharray="{} {}""#, Number(on), Number(off))?;
    }
    writeln!(out, r#" stroke-linejoin="round"/>"#)
}

/// Writes dots as lines of zero length with round ends: a third of the bytes of circles.
fn dots(centres: &[Point], radius: f64, colour: Colour, out: &mut String) -> Result {
    write!(out, r#"<path d=""#)?;
    for &(x, y) in centres {
        write!(out, "M{} {}h0", Number(x), Number(y))?;
    }
    let width = Number(2.0 * radius);
    writeln!(out, r#"" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linecap="round"/>"#)
}

fn patch(from: Point, to: Point, colour: Colour, out: &mut String) -> Result {
    write!(out, r#"<rect x="{}" y="{}""#, Number(from.0), Number(from.1))?;
    let (width, height) = (Number(to.0 - from.0), Number(to.1 - from.1));
    writeln!(out, r#" width="{width}" height="{height}" fill="{colour}"/>"#)
}

/// Writes pixels as an embedded PNG.
fn image(at: Point, size: (f64, f64), pixels: &[u8], columns: usize, out: &mut String) -> Result {
    let Some(bytes) = of_pixels(pixels, columns) else { return Ok(()) };
    write!(out, r#"<image x="{}" y="{}""#, Number(at.0), Number(at.1))?;
    write!(out, r#" width="{}" height="{}""#, Number(size.0), Number(size.1))?;
    let text = base64::engine::general_purpose::STANDARD.encode(bytes);
    writeln!(out, r#" href="data:image/png;base64,{text}"/>"#)
}

fn words(text: &Text, out: &mut String) -> Result {
    write!(out, r#"<text x="{}" y="{}""#, Number(text.at.0), Number(text.at.1))?;
    write!(out, r#" font-size="{}" fill="{}""#, Number(text.font.size), text.colour)?;
    if text.font.weight == crate::font::Weight::Medium {
        write!(out, r#" font-weight="500""#)?;
    }
    match text.anchor {
        Anchor::Start => {}
        Anchor::Middle => write!(out, r#" text-anchor="middle""#)?,
        Anchor::End => write!(out, r#" text-anchor="end""#)?,
    }
    writeln!(out, ">{}</text>", Escaped(&text.words))
}

/// Coordinate rounded to 0.01, without trailing zeros.
struct Number(f64);

impl Display for Number {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let hundredths = (self.0 * 100.0).round() as i64;
        let (whole, part) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
        f.write_str(if hundredths < 0 { "-" } else { "" })?;
        match (part, part % 10) {
            (0, _) => write!(f, "{whole}"),
            (_, 0) => write!(f, "{whole}.{}", part / 10),
            _ => write!(f, "{whole}.{part:02}"),
        }
    }
}

impl Display for Colour {
    fn fmt(&self, f: &mut Formatter) -> Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

/// Text with XML markup characters escaped.
struct Escaped<'a>(&'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                c => f.write_char(c)?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [(1.0, "1"), (0.5, "0.5"), (-0.001, "0"), (-12.345, "-12.35"), (3.049, "3.05")] {
            assert_eq!(Number(value).to_string(), text);
        }
    }

    #[test]
    fn markup_in_words_stays_words() {
        assert_eq!(Escaped("a<b> & \"c\"").to_string(), "a&lt;b&gt; &amp; \"c\"");
    }
}
