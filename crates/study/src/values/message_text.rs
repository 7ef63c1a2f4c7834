//! Texts of a file in messages.

use std::borrow::Cow;

/// Largest number of characters of a file's text in a message.
const LONGEST_SHOWN: usize = 200;

/// Text for a message, cut if long.
pub(crate) fn truncate_for_message(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(LONGEST_SHOWN) {
        Some((end, _)) => format!("{}…", &text[..end]).into(),
        None => text.into(),
    }
}
