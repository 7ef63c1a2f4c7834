//! Key of the numbered points.

use crate::figure::legend::WIDTH_RESERVE;
use crate::font::Font;
use crate::palette::{INK, SOFT_INK};
use crate::scene::{Anchor, Scene};
use crate::text::{fit_to_width, medium, regular};

/// Height of a row of the key.
pub(super) const KEY_ROW: f64 = 17.0;
/// Smallest width of a column: about 25 letters.
pub(super) const KEY_COLUMN: f64 = 200.0;
/// Width of the number before a name.
const NUMBER_WIDTH: f64 = 26.0;
const NUMBER: Font = medium(12.0);
const NAME: Font = regular(12.0);

/// Rows and columns of a key with `count` names: one column if all names fit in `rows_available` rows.
pub(super) fn key_rows(count: usize, rows_available: usize, most_columns: usize) -> (usize, usize) {
    if count <= rows_available {
        return (count, 1);
    }
    (count.div_ceil(most_columns), most_columns)
}

/// Draws the numbered names, column by column, in columns of equal width; returns the y of the lower end.
pub(super) fn draw_key(
    scene: &mut Scene,
    names: &[&str],
    (left, width): (f64, f64),
    top: f64,
    (rows, columns): (usize, usize),
) -> f64 {
    let column_width = width / columns as f64;
    for (i, name) in names.iter().enumerate() {
        let x = left + column_width * (i / rows.max(1)) as f64;
        let y = top + KEY_ROW * (i % rows.max(1)) as f64 + 10.0;
        // The reader's font may be wider than the embedded one.
        let name = fit_to_width(name, NAME, (column_width - NUMBER_WIDTH - 8.0) / WIDTH_RESERVE);
        scene.text((i + 1).to_string(), (x + NUMBER_WIDTH - 8.0, y), Anchor::End, NUMBER, INK);
        scene.text(name, (x + NUMBER_WIDTH, y), Anchor::Start, NAME, SOFT_INK);
    }
    top + KEY_ROW * rows as f64
}
