//! Wavefront OBJ: positions and faces; materials, normals and textures are left out.

use super::triangles::{Triangles, bounded};

pub(super) fn read(bytes: &[u8]) -> Result<Triangles, String> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..Default::default()
    };
    let no_materials = |_: &std::path::Path| Ok((Vec::new(), Default::default()));
    let (models, _) =
        tobj::load_obj_buf(&mut &bytes[..], &options, no_materials).map_err(|e| e.to_string())?;
    let mut triangles = Triangles::new();
    for mesh in models.iter().map(|model| &model.mesh) {
        bounded(triangles.len() + mesh.indices.len() / 3)?;
        for face in mesh.indices.chunks_exact(3) {
            let corner = |i: u32| -> Option<[f64; 3]> {
                let first = 3 * usize::try_from(i).ok()?;
                mesh.positions.get(first..first + 3)?.try_into().ok()
            };
            match (corner(face[0]), corner(face[1]), corner(face[2])) {
                (Some(a), Some(b), Some(c)) => triangles.push([a, b, c]),
                _ => return Err("a face names a vertex that there is not".to_owned()),
            }
        }
    }
    Ok(triangles)
}
