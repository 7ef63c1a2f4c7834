//! Rows of a table of points that state another key of the sheet: half track, static camber, tyre diameter, spring.

use super::super::entries::{Cell, parse_number};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Row of the data file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Setting {
    labels: Vec<String>,
    key: String,
    #[serde(default)]
    unit: String,
    /// Factor from the number of the table to the value of the key.
    #[serde(default = "one")]
    factor: f64,
    /// Values for texts; present for keys with a text. Without entries, the text is the value.
    words: Option<BTreeMap<String, String>>,
}

fn one() -> f64 {
    1.0
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Settings {
    setting: Vec<Setting>,
}

static SETTINGS: LazyLock<Settings> = LazyLock::new(|| {
    toml::from_str(include_str!("settings.toml")).expect("the settings of this crate are valid")
});

/// Label of a row without a colon, in lower case.
fn label_of(text: &str) -> String {
    text.trim().trim_end_matches(':').trim_end().to_lowercase().replace('_', " ")
}

/// True if a text is the label of a setting.
pub(super) fn is_label(text: &str) -> bool {
    let label = label_of(text);
    SETTINGS.setting.iter().any(|setting| setting.labels.contains(&label))
}

/// Key and value of a row with the given label; `values`: its other cells, those of the wanted side first. `None` if the row is no setting
/// or has no value for it.
pub(super) fn read(label: &str, values: &[&Cell]) -> Option<(&'static str, Cell)> {
    let label = label_of(label);
    let number = values.iter().find_map(|cell| match cell {
        Cell::Number(x) => Some((*x, String::new())),
        Cell::Text(text) => {
            let (digits, unit) = percuss_units::split(text);
            Some((parse_number(digits)?, unit.to_owned()))
        }
        Cell::Switch(_) | Cell::Unreadable(_) => None,
    });
    let texts = || {
        values.iter().filter_map(|cell| match cell {
            Cell::Text(text) if !text.trim().is_empty() => Some(text.trim()),
            _ => None,
        })
    };
    SETTINGS.setting.iter().filter(|setting| setting.labels.contains(&label)).find_map(|setting| {
        let value = match &setting.words {
            Some(words) if words.is_empty() => Cell::Text(texts().next()?.to_owned()),
            Some(words) => Cell::Text(
                texts().find_map(|text| words.get(&text.to_lowercase().replace([' ', '-'], "")))?.clone(),
            ),
            None => {
                let (number, unit) = number.as_ref()?;
                let unit = if unit.is_empty() { &setting.unit } else { unit };
                let number = number * setting.factor;
                if unit.is_empty() { Cell::Number(number) } else { Cell::Text(format!("{number} {unit}")) }
            }
        };
        Some((&*setting.key, value))
    })
}
