//! Places of the cells of a row in the text of a table.

use crate::sheet::entries::Place;

/// Places of the cells of the first row from the byte `start`, below comments and empty lines.
pub(super) fn cell_places(text: &str, start: usize, separator: char) -> Vec<Place> {
    let lines = text.get(start..).unwrap_or_default().split_inclusive('\n');
    let above = lines.take_while(|line| line.trim().is_empty() || line.starts_with('#'));
    let first = start + above.map(str::len).sum::<usize>();
    let (mut places, mut begin, mut is_quoted) = (Vec::new(), first, false);
    for (i, c) in text.get(first..).unwrap_or_default().char_indices() {
        let at = first + i;
        if c == '"' {
            is_quoted = !is_quoted;
        } else if !is_quoted && [separator, '\n', '\r'].contains(&c) {
            places.push(Place::Text(begin..at));
            begin = at + c.len_utf8();
            if c != separator {
                return places;
            }
        }
    }
    places.push(Place::Text(begin..text.len()));
    places
}
