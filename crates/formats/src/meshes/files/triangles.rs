//! Triangles and their largest number.

use crate::reading::limits::MAX_TRIANGLES;

/// Triangles: corners in metres, in the mesh frame.
pub type Triangles = Vec<[[f64; 3]; 3]>;

/// Error if `count` exceeds `MAX_TRIANGLES`.
pub(super) fn check_triangle_count(count: usize) -> Result<(), String> {
    if count > MAX_TRIANGLES {
        return Err(format!("more than {MAX_TRIANGLES} triangles; simplify the mesh"));
    }
    Ok(())
}
