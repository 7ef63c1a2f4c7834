//! Texts of a file in messages.

use std::borrow::Cow;

/// Characters of a text in a message.
const LONGEST_SHOWN: usize = 200;

/// A text for a message, cut if it is long.
pub(crate) fn cut(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(LONGEST_SHOWN) {
        Some((end, _)) => format!("{}…", &text[..end]).into(),
        None => text.into(),
    }
}
