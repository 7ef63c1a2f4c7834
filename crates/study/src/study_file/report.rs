//! Report table of a study file: the text at the head of the report.

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};

/// Text at the head of a report. Every key is optional.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct StudyReport {
    /// Title; default: the contact of the study.
    pub title: Option<String>,
    /// Author or authors.
    pub author: Option<String>,
    /// Date, as text or as a date of TOML (2026-11-26). No date is added by percuss, so that a repeated run writes the
    /// same page.
    #[serde(deserialize_with = "date_text")]
    pub date: Option<String>,
    /// Object of the study, such as the vehicle and the axle.
    pub object: Option<String>,
}

/// Deserializes a text or a TOML date as text.
fn date_text<'de, D: Deserializer<'de>>(from: D) -> Result<Option<String>, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged, expecting = "expected a text or a date such as 2026-11-26")]
    enum Date {
        Text(String),
        Toml(toml::value::Datetime),
    }
    Ok(Some(match Date::deserialize(from)? {
        Date::Text(text) => text,
        Date::Toml(date) => date.to_string(),
    }))
}
