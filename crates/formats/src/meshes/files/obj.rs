//! Reader of Wavefront OBJ: positions and faces, without materials, normals and textures.
//!
//! The file is read line by line: memory is needed only for positions and triangles, and errors have line numbers.

use super::error::excerpt;
use super::triangles::{Triangles, check_triangle_count};
use crate::reading::limits::MAX_MESH_VERTICES;

/// Triangles of an OBJ file, and their number in its first object or group. An object or group begins with a line `o NAME` or `g NAME`
/// behind a face.
pub(super) fn read_obj(bytes: &[u8]) -> Result<(Triangles, usize), String> {
    let mut first = None;
    let mut positions: Vec<[f64; 3]> = Vec::new();
    // Corners of each triangle with the line of the face: a face may refer to later vertices.
    let mut faces: Vec<([u32; 3], u32)> = Vec::new();
    for (line, text) in (1_u32..).zip(bytes.split(|byte| *byte == b'\n')) {
        let mut words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        match words.next() {
            Some(b"v") => {
                let position: Option<Vec<f64>> = words.take(3).map(parse_number).collect();
                let position = position.and_then(|numbers| numbers.try_into().ok()).ok_or_else(|| {
                    format!("line {line}: three numbers are expected after \"v\", found {:?}", excerpt(text))
                })?;
                if positions.len() == MAX_MESH_VERTICES {
                    return Err(format!(
                        "line {line}: more than {MAX_MESH_VERTICES} vertices; simplify the mesh"
                    ));
                }
                positions.push(position);
            }
            Some(b"f") => {
                let mut corners = words.map(|word| {
                    vertex_index(word, positions.len()).ok_or_else(|| {
                        format!(
                            "line {line}: {:?} is no vertex of a face; expected v, v/vt, v//vn or v/vt/vn",
                            excerpt(word)
                        )
                    })
                });
                // Points and lines have no third corner.
                let (Some(first), Some(second)) = (corners.next(), corners.next()) else { continue };
                let (first, mut second) = (first?, second?);
                for third in corners {
                    let third = third?;
                    faces.push(([first, second, third], line));
                    check_triangle_count(faces.len()).map_err(|why| format!("line {line}: {why}"))?;
                    second = third;
                }
            }
            // As in tinyobjloader, a line without anything behind the letter is no beginning.
            Some(b"o" | b"g") if text.trim_ascii_start().get(1).is_some_and(|byte| b" \t".contains(byte)) => {
                first = first.or(Some(faces.len()).filter(|count| *count > 0));
            }
            _ => {}
        }
    }
    let first = first.unwrap_or(faces.len());
    let triangle = |&(corners, line): &([u32; 3], u32)| {
        let corner = |index: u32| {
            let vertex = || {
                format!("line {line}: a face names vertex {} of {}", u64::from(index) + 1, positions.len())
            };
            positions.get(index as usize).copied().ok_or_else(vertex)
        };
        Ok([corner(corners[0])?, corner(corners[1])?, corner(corners[2])?])
    };
    Ok((faces.iter().map(triangle).collect::<Result<_, String>>()?, first))
}

/// Infinite values and NaN are accepted here, and refused for all formats by [`read_mesh`](super::read_mesh).
fn parse_number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// Index, from 0, of the vertex in `v/vt/vn`; a negative number counts back from the last of `count` vertices.
fn vertex_index(word: &[u8], count: usize) -> Option<u32> {
    let vertex = word.split(|byte| *byte == b'/').next()?;
    let vertex: i64 = std::str::from_utf8(vertex).ok()?.parse().ok()?;
    let index = if vertex < 0 { i64::try_from(count).ok()?.checked_add(vertex)? } else { vertex - 1 };
    u32::try_from(index).ok()
}
