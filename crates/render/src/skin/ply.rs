//! PLY, binary: three vertices per facet, with colour and value on vertices and facets.

use super::Skin;
use super::colour::Scale;
use crate::backend::MADE_BY;
use std::io::{self, Write};

impl Skin {
    /// Writes the skin as PLY 1.0, binary little-endian. Each facet has its own vertices, since the value is
    /// discontinuous at edges. `status` is a property of the facet. The value is −1 if there is none.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn write_ply(&self, out: &mut impl Write) -> io::Result<()> {
        let count = self.facets().count();
        let name = if self.property.is_empty() { "value" } else { &self.property };
        writeln!(out, "ply\nformat binary_little_endian 1.0\ncomment {MADE_BY}")?;
        for piece in &self.pieces {
            writeln!(out, "comment {} facets of {}", piece.facets.len(), one_line(&piece.name))?;
        }
        writeln!(out, "comment {}; -1: none", one_line(&self.quantity))?;
        writeln!(out, "element vertex {}", 3 * count)?;
        for property in ["x", "y", "z", "nx", "ny", "nz"] {
            writeln!(out, "property float {property}")?;
        }
        write_property_header(out, name)?;
        writeln!(out, "element face {count}\nproperty list uchar int vertex_indices")?;
        write_property_header(out, name)?;
        writeln!(out, "property uchar status\nend_header")?;
        let scale = Scale::of(self);
        for facet in self.facets() {
            for corner in facet.corners {
                for x in corner.into_iter().chain(facet.normal) {
                    out.write_all(&(x as f32).to_le_bytes())?;
                }
                write_colour_and_value(out, &scale, facet.value)?;
            }
        }
        for (i, facet) in self.facets().enumerate() {
            out.write_all(&[3])?;
            for corner in 0..3 {
                out.write_all(&((3 * i + corner) as i32).to_le_bytes())?;
            }
            write_colour_and_value(out, &scale, facet.value)?;
            out.write_all(&[facet.status])?;
        }
        Ok(())
    }
}

/// Writes the header lines of the colour and the value of an element.
fn write_property_header(out: &mut impl Write, name: &str) -> io::Result<()> {
    for colour in ["red", "green", "blue"] {
        writeln!(out, "property uchar {colour}")?;
    }
    writeln!(out, "property double {name}")
}

/// Writes the colour and the value of a vertex or facet.
fn write_colour_and_value(out: &mut impl Write, scale: &Scale, value: Option<f64>) -> io::Result<()> {
    let colour = scale.colour(value);
    out.write_all(&[colour.0, colour.1, colour.2])?;
    out.write_all(&value.unwrap_or(-1.0).to_le_bytes())
}

/// Removes line breaks, which would end a comment of the header.
fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
