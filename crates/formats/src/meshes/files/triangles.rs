//! Triangles and their largest number.

use crate::reading::limits::MOST_TRIANGLES;

/// Triangles: corners in metres, in the mesh frame.
pub type Triangles = Vec<[[f64; 3]; 3]>;

/// Refuses more than `MOST_TRIANGLES` triangles.
pub(super) fn bounded(count: usize) -> Result<(), String> {
    if count > MOST_TRIANGLES {
        return Err(format!("more than {MOST_TRIANGLES} triangles; simplify the mesh"));
    }
    Ok(())
}
