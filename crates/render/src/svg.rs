//! Writes a scene as an SVG document.

use crate::backend::{MADE_BY, png_from_pixels};
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
    let _ = write_document(scene, &mut out);
    out
}

/// Returns the document without paper and images; the PDF writer adds these below.
#[cfg(feature = "convert")]
pub(crate) fn write_over(scene: &Scene) -> String {
    let mut out = String::new();
    let _ = write_head(scene, &mut out).and_then(|()| write_items(scene, false, &mut out));
    out
}

/// Writes the document with paper and images.
fn write_document(scene: &Scene, out: &mut String) -> Result {
    write_head(scene, out)?;
    let (w, h) = (Number(scene.width), Number(scene.height));
    writeln!(out, r#"<rect width="{w}" height="{h}" fill="{PAPER}"/>"#)?;
    write_items(scene, true, out)
}

/// Writes the opening `<svg>` tag with the caption.
fn write_head(scene: &Scene, out: &mut String) -> Result {
    let (w, h) = (Number(scene.width), Number(scene.height));
    writeln!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}" role="img" font-family="{FAMILY}">"#
    )?;
    if !scene.caption.is_empty() {
        writeln!(out, "<title>{}</title>", Escaped(&scene.caption))?;
    }
    writeln!(out, "<metadata>{MADE_BY}</metadata>")
}

/// Writes the items of a scene and the closing tag; images only if `with_images`.
fn write_items(scene: &Scene, with_images: bool, out: &mut String) -> Result {
    for item in &scene.items {
        match item {
            Item::Lines { chains, stroke } => write_lines(chains, stroke, out)?,
            Item::Dots { centres, radius, colour } => write_dots(centres, *radius, *colour, out)?,
            Item::Patch { from, to, colour } => write_patch(*from, *to, *colour, out)?,
            Item::Area { corners, colour } => write_area(corners, *colour, out)?,
            Item::Image { .. } if !with_images => {}
            Item::Image { at, size, pixels, columns } => write_image(*at, *size, pixels, *columns, out)?,
            Item::Text(text) => write_text(text, out)?,
            Item::Hover { at, radius, title } => write_hover(*at, *radius, title, out)?,
        }
    }
    writeln!(out, "</svg>")
}

/// Writes polylines as one `<path>`.
fn write_lines(chains: &[Vec<Point>], stroke: &Stroke, out: &mut String) -> Result {
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
fn write_dots(centres: &[Point], radius: f64, colour: Colour, out: &mut String) -> Result {
    write!(out, r#"<path d=""#)?;
    for &(x, y) in centres {
        write!(out, "M{} {}h0", Number(x), Number(y))?;
    }
    let width = Number(2.0 * radius);
    writeln!(out, r#"" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linecap="round"/>"#)
}

/// Writes a filled rectangle.
fn write_patch(from: Point, to: Point, colour: Colour, out: &mut String) -> Result {
    write!(out, r#"<rect x="{}" y="{}""#, Number(from.0), Number(from.1))?;
    let (width, height) = (Number(to.0 - from.0), Number(to.1 - from.1));
    writeln!(out, r#" width="{width}" height="{height}" fill="{colour}"/>"#)
}

/// Writes a filled polygon.
fn write_area(corners: &[Point], colour: Colour, out: &mut String) -> Result {
    write!(out, r#"<path d=""#)?;
    for (i, &(x, y)) in corners.iter().enumerate() {
        write!(out, "{}{} {}", if i == 0 { 'M' } else { 'L' }, Number(x), Number(y))?;
    }
    writeln!(out, r#"Z" fill="{colour}"/>"#)
}

/// Writes pixels as an embedded PNG.
fn write_image(at: Point, size: (f64, f64), pixels: &[u8], columns: usize, out: &mut String) -> Result {
    let Some(bytes) = png_from_pixels(pixels, columns) else { return Ok(()) };
    write!(out, r#"<image x="{}" y="{}""#, Number(at.0), Number(at.1))?;
    write!(out, r#" width="{}" height="{}""#, Number(size.0), Number(size.1))?;
    let text = base64::engine::general_purpose::STANDARD.encode(bytes);
    writeln!(out, r#" href="data:image/png;base64,{text}"/>"#)
}

/// Writes one line of text.
fn write_text(text: &Text, out: &mut String) -> Result {
    write!(out, r#"<text x="{}" y="{}""#, Number(text.at.0), Number(text.at.1))?;
    write!(out, r#" font-size="{}" fill="{}""#, Number(text.font.size), text.colour)?;
    if text.font.weight == crate::font::Weight::Medium {
        write!(out, r#" font-weight="500""#)?;
    }
    if text.has_halo {
        write!(out, r#" stroke="{PAPER}" stroke-width="3" stroke-linejoin="round" paint-order="stroke""#)?;
    }
    match text.anchor {
        Anchor::Start => {}
        Anchor::Middle => write!(out, r#" text-anchor="middle""#)?,
        Anchor::End => write!(out, r#" text-anchor="end""#)?,
    }
    writeln!(out, ">{}</text>", Escaped(&text.content))
}

/// Writes an invisible disc with the title that a browser shows under the pointer.
fn write_hover(at: Point, radius: f64, title: &str, out: &mut String) -> Result {
    let (x, y, radius) = (Number(at.0), Number(at.1), Number(radius));
    write!(out, r#"<circle cx="{x}" cy="{y}" r="{radius}" fill="none" pointer-events="all">"#)?;
    writeln!(out, "<title>{}</title></circle>", Escaped(title))
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
                '"' => f.write_str("&quot;")?,
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
    fn markup_in_text_is_escaped() {
        assert_eq!(Escaped("a<b> & \"c\"").to_string(), "a&lt;b&gt; &amp; &quot;c&quot;");
    }
}
