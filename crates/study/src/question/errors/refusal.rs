//! Invalid value of a table of a question.

use crate::question::names::{Names, flag};

/// Invalid value of a table: key and reason.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", self.message(Names::Fields))]
pub struct InvalidKey {
    /// Key with the name of its table, such as `damping.law`, or the name of the table.
    pub key: &'static str,
    /// Reason and remedy.
    reason: Reason,
}

/// Reason and remedy: a text, in which names of other keys of the table are in backquotes if `has_names`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Reason {
    text: String,
    has_names: bool,
}

impl From<&'static str> for Reason {
    fn from(text: &'static str) -> Self {
        Self { text: text.to_owned(), has_names: true }
    }
}

/// A text with parts of the input, whose backquotes are kept.
impl From<String> for Reason {
    fn from(text: String) -> Self {
        Self { text, has_names: false }
    }
}

impl InvalidKey {
    /// Refusal of a key with its reason.
    pub(crate) fn new(key: &'static str, why: impl Into<Reason>) -> Self {
        Self { key, reason: why.into() }
    }

    /// Refusal with names of other keys in backquotes in a text that has no backquotes of the input.
    pub(crate) fn with_names(key: &'static str, text: String) -> Self {
        Self { key, reason: Reason { text, has_names: true } }
    }

    /// Reason with the names of flags, or with the names of keys.
    pub fn reason(&self, names: Names) -> String {
        if !self.reason.has_names {
            return self.reason.text.clone();
        }
        let name = |(i, part): (usize, &str)| match names {
            Names::Flags if i % 2 == 1 => flag(part),
            _ => part.to_owned(),
        };
        self.reason.text.split('`').enumerate().map(name).collect()
    }

    /// Message with the name of the flag, the key or the field.
    pub fn message(&self, names: Names) -> String {
        let reason = self.reason(names);
        match names {
            Names::Keys(_) => format!("{}: {reason}", self.key),
            Names::Flags | Names::Fields if self.key.contains('.') => {
                format!("{}: {reason}", names.name_of(self.key))
            }
            Names::Flags | Names::Fields => reason,
        }
    }
}
