//! STL, binary or ASCII.

use super::triangles::{Triangles, bounded};
use std::io::Cursor;

/// Bytes before the first facet of a binary file, and of each facet.
const HEADER: usize = 84;
const FACET: usize = 50;

pub(super) fn read(bytes: &[u8]) -> Result<Triangles, String> {
    // Binary files may begin with "solid" too: their length decides.
    match binary_count(bytes) {
        Some(count) if bytes.len() >= HEADER + FACET * count && (count > 0 || !is_ascii(bytes)) => {
            bounded(count)?;
            let facets = bytes[HEADER..].chunks_exact(FACET).take(count);
            Ok(facets.map(corners).collect())
        }
        _ if is_ascii(bytes) => ascii(bytes),
        Some(count) => Err(format!(
            "it announces {count} triangles and has bytes for {}; was it cut off?",
            (bytes.len() - HEADER) / FACET
        )),
        None => Err(format!("{} bytes are no STL", bytes.len())),
    }
}

fn binary_count(bytes: &[u8]) -> Option<usize> {
    let count: [u8; 4] = bytes.get(HEADER - 4..HEADER)?.try_into().ok()?;
    usize::try_from(u32::from_le_bytes(count)).ok()
}

fn is_ascii(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    text.len() >= 5 && text[..5].eq_ignore_ascii_case(b"solid") && !bytes.contains(&0)
}

fn corners(facet: &[u8]) -> [[f64; 3]; 3] {
    let number = |at: usize| {
        let bytes = [facet[at], facet[at + 1], facet[at + 2], facet[at + 3]];
        f64::from(f32::from_le_bytes(bytes))
    };
    // The normal comes first, and is not read: many writers leave it at zero.
    std::array::from_fn(|corner| std::array::from_fn(|axis| number(12 + 12 * corner + 4 * axis)))
}

fn ascii(bytes: &[u8]) -> Result<Triangles, String> {
    let mut cursor = Cursor::new(bytes);
    let reader = stl_io::create_stl_reader(&mut cursor).map_err(|e| e.to_string())?;
    let mut triangles = Triangles::new();
    for facet in reader {
        let facet = facet.map_err(|e| format!("facet {}: {e}", triangles.len() + 1))?;
        triangles.push(facet.vertices.map(|v| [f64::from(v[0]), f64::from(v[1]), f64::from(v[2])]));
        bounded(triangles.len())?;
    }
    Ok(triangles)
}
