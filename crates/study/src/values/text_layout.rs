//! Texts of tables: separator of the cells, decimal mark, and the words of headers.

use percuss_contact::identification::Measured;
use percuss_units::{Dimension, Unit};
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Characters between the words of a head.
const SEPARATORS: &str = " \u{a0}\t_-.,:;/()[]{}<>|#";

/// Words of heads and units, from the data file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Words {
    quantities: BTreeMap<ColumnKind, Vec<String>>,
    units: BTreeMap<String, Vec<String>>,
}

static WORDS: LazyLock<Words> = LazyLock::new(|| {
    toml::from_str(include_str!("record-words.toml")).expect("the words of this crate are valid")
});

/// Kind of a column of a measured impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum ColumnKind {
    Time,
    Force,
    Acceleration,
    Velocity,
    Displacement,
    /// Number of the row.
    Counter,
    /// A column without influence.
    None,
    /// A word beside another.
    Other,
}

impl ColumnKind {
    /// Measured quantity.
    pub fn measured(self) -> Option<Measured> {
        match self {
            Self::Force => Some(Measured::Force),
            Self::Acceleration => Some(Measured::Acceleration),
            Self::Velocity => Some(Measured::Velocity),
            Self::Displacement => Some(Measured::Displacement),
            Self::Time | Self::Counter | Self::None | Self::Other => None,
        }
    }

    /// Dimension; `None` for a column without a unit.
    pub fn dimension(self) -> Option<Dimension> {
        match self {
            Self::Time => Some(Dimension::Time),
            Self::Force => Some(Dimension::Force),
            Self::Acceleration => Some(Dimension::Acceleration),
            Self::Velocity => Some(Dimension::Speed),
            Self::Displacement => Some(Dimension::Length),
            Self::Counter | Self::None | Self::Other => None,
        }
    }

    /// Kind that all words of a text name.
    fn of(text: &str) -> Option<Self> {
        let (mut named, mut beside) = (Vec::new(), Vec::new());
        for word in text.split(|c| SEPARATORS.contains(c)).filter(|word| !word.is_empty()) {
            let word = word.to_lowercase();
            let word = word.trim_end_matches(|c: char| c.is_ascii_digit());
            let kinds = WORDS.quantities.iter().filter(|(_, words)| words.iter().any(|known| known == word));
            let kinds: Vec<Self> = kinds.map(|(kind, _)| *kind).collect();
            match kinds[..] {
                // A number of a channel.
                [] if word.is_empty() => {}
                [] => return None,
                [kind] if kind != Self::Other => named.push(kind),
                _ => beside.extend(kinds.into_iter().filter(|kind| *kind != Self::Other)),
            }
        }
        // An x beside a quantity is a direction, an x alone a displacement.
        let found = if named.is_empty() { beside } else { named };
        let first = *found.first()?;
        found.iter().all(|kind| *kind == first).then_some(first)
    }

    /// Kind and unit of a head such as `force [kN]`, `Force_Z`, `t/s`, `Weg in mm`. Error: the reason.
    pub fn of_head(head: &str) -> Result<(Self, Option<&'static Unit>), String> {
        let ends = head.char_indices().filter(|(_, c)| SEPARATORS.contains(*c)).map(|(at, _)| at);
        let mut wrong = None;
        for end in ends {
            let Some(kind) = Self::of(&head[..end]) else { continue };
            let text = trimmed(&head[end..]);
            match kind.dimension().and_then(|dimension| unit(text, dimension)) {
                Some(unit) => return Ok((kind, Some(unit))),
                None if wrong.is_none() && !text.is_empty() => wrong = Some((text, kind)),
                None => {}
            }
        }
        match (Self::of(head), wrong) {
            (Some(kind), _) => Ok((kind, None)),
            (None, Some((text, kind))) => Err(match kind.dimension() {
                Some(dimension) => no_unit(text, dimension),
                None => format!("\"{text}\" is not understood"),
            }),
            (None, None) => {
                let names = "time, force, acceleration, velocity, displacement";
                Err(format!("\"{head}\" is no measured quantity; expected one of {names}"))
            }
        }
    }
}

/// Text of a unit without brackets.
fn trimmed(text: &str) -> &str {
    let text = text.trim_matches(|c| " \u{a0}\t_-:|/".contains(c));
    text.trim_matches(|c| "()[]{}<> ".contains(c))
}

/// Unit of a dimension, also with another name or in brackets.
pub(crate) fn unit(text: &str, dimension: Dimension) -> Option<&'static Unit> {
    let text = trimmed(text);
    let named = |name: &str| Unit::named(name, &[dimension]);
    let lower = text.to_lowercase();
    let aliases = || WORDS.units.iter().filter(|(_, names)| names.contains(&lower));
    named(text).or_else(|| aliases().find_map(|(name, _)| named(name)))
}

/// Message about a text that is no unit.
pub(crate) fn no_unit(text: &str, dimension: Dimension) -> String {
    let units: Vec<&str> = dimension.units().map(|unit| unit.name).collect();
    format!("\"{text}\" is no unit of {dimension}; expected one of {}", units.join(", "))
}

/// Separator of the cells of a line.
pub(crate) fn separator(line: &str) -> char {
    [';', '\t', ','].into_iter().find(|c| line.contains(*c)).unwrap_or(' ')
}

/// Decimal mark of a table: that of the first number with a mark.
#[derive(Debug, Default)]
pub(crate) struct DecimalMark(Option<char>);

impl DecimalMark {
    /// The text of a number with a decimal point. Error: the reason.
    pub fn with_point<'t>(&mut self, text: &'t str) -> Result<Cow<'t, str>, String> {
        let mut marks = text.chars().filter(|c| matches!(c, ',' | '.'));
        let Some(mark) = marks.next() else { return Ok(Cow::Borrowed(text)) };
        if marks.next().is_some() {
            return Err(format!(
                "\"{text}\" has two decimal marks; expected a number without separators of thousands"
            ));
        }
        if *self.0.get_or_insert(mark) != mark {
            return Err(format!(
                "\"{text}\" after numbers with a decimal {}; expected one decimal mark",
                if mark == ',' { "point" } else { "comma" }
            ));
        }
        Ok(if mark == ',' { Cow::Owned(text.replace(',', ".")) } else { Cow::Borrowed(text) })
    }
}
