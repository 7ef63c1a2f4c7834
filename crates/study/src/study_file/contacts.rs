//! Contacts of a study: one table, or a list of tables.

use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::ContactTable;
use crate::reports::contact_list::contacts_by_kind;
use crate::thresholds::MOST_VARIANTS;
use crate::values::message_text::truncate_for_message;
use percuss_mechanism::Mechanism;
use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

/// Name of `at` for all contacts of the model.
const ALL: &str = "all";

/// One contact, or a list of contacts.
#[derive(JsonSchema)]
#[schemars(untagged)]
#[allow(dead_code, reason = "the schema of a contact or a list of contacts")]
pub(crate) enum ContactsSchema {
    /// One contact.
    One(Box<ContactTable>),
    /// Several contacts, `[[contact]]`.
    Several(Vec<ContactTable>),
}

/// Contact of a study with several contacts.
#[derive(Clone, Debug)]
pub struct StudyContact {
    /// Name in tables and figures.
    pub name: String,
    /// The question at this contact.
    pub question: MassQuestion,
}

/// Deserializes one table or a list of tables. Errors keep their position in the file.
pub(crate) fn contacts<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<ContactTable>, D::Error> {
    struct OneOrSeveral;
    impl<'de> Visitor<'de> for OneOrSeveral {
        type Value = Vec<ContactTable>;
        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str("a table [contact], or tables [[contact]]")
        }
        fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
            Ok(vec![ContactTable::deserialize(MapAccessDeserializer::new(map))?])
        }
        fn visit_seq<A: SeqAccess<'de>>(self, mut tables: A) -> Result<Self::Value, A::Error> {
            let mut all = Vec::new();
            while let Some(table) = tables.next_element()? {
                all.push(table);
            }
            Ok(all)
        }
    }
    from.deserialize_any(OneOrSeveral)
}

/// Names of the contacts that the text of `at` names: one name, several with commas, or `all`. A contact may itself have a comma in
/// its name or the name `all`.
///
/// # Errors
/// `all` for a model without named contacts.
pub fn contact_names(at: &str, mechanism: &Mechanism) -> Result<Vec<String>, String> {
    let all = mechanism.contacts();
    let names: Vec<String> = match at {
        name if all.iter().any(|contact| contact.name() == name) => vec![name.to_owned()],
        ALL => contacts_by_kind(mechanism).iter().map(|contact| contact.name().to_owned()).collect(),
        // A number after a comma marks a contact with coordinates, such as foot:0,0,0:0,0,-1, not a list of names.
        text if text.contains(':') && text.split(',').skip(1).any(begins_with_number) => {
            vec![text.to_owned()]
        }
        list => list.split(',').map(|name| name.trim().to_owned()).collect(),
    };
    if names.is_empty() {
        return Err("the model has no named contacts; give a link, a point and a normal".to_owned());
    }
    Ok(names)
}

/// True if a text begins with a number.
fn begins_with_number(text: &str) -> bool {
    text.trim_start().starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
}

/// Tables of single contacts: `all` and lists of names are replaced by one table per name.
pub(crate) fn expand(
    tables: &[ContactTable],
    mechanism: &Mechanism,
) -> Result<Vec<ContactTable>, InvalidKey> {
    let mut all = Vec::new();
    for table in tables {
        let Some(at) = &table.at else {
            all.push(table.clone());
            continue;
        };
        let names = contact_names(at, mechanism)
            .map_err(|why| InvalidKey::new("contact.at", format!("\"{ALL}\": {why}")))?;
        if names.len() > 1 && table.name.is_some() {
            return Err(InvalidKey::new("contact.name", "it names one contact, and `at` names several"));
        }
        all.extend(names.into_iter().map(|name| ContactTable { at: Some(name), ..table.clone() }));
    }
    if let ([one], false) = (&all[..], tables.len() > 1)
        && one.name.is_some()
    {
        return Err(InvalidKey::new(
            "contact.name",
            "it names one of several contacts: write them as [[contact]]",
        ));
    }
    Ok(all)
}

/// Several contacts with their questions; `conditions`: pose and conditions of the study. Empty for a single contact.
pub(crate) fn several_contacts(
    tables: &[ContactTable],
    conditions: &MassQuestion,
    variants: usize,
) -> Result<Vec<StudyContact>, InvalidKey> {
    if tables.len() < 2 {
        return Ok(Vec::new());
    }
    if tables.len() * (variants + 1) > MOST_VARIANTS {
        let why = format!(
            "{} contacts of {} designs; at most {MOST_VARIANTS} results are computed: divide the study",
            tables.len(),
            variants + 1
        );
        return Err(InvalidKey::new("contact", why));
    }
    let mut all: Vec<StudyContact> = Vec::new();
    for table in tables {
        if let Some(part) = table.missing() {
            return Err(InvalidKey::new("contact", format!("{part} is missing")));
        }
        let question = MassQuestion { contact: table.checked()?, ..conditions.clone() };
        let name =
            table.name.as_ref().or(table.at.as_ref()).or(table.link.as_ref()).cloned().unwrap_or_default();
        if all.iter().any(|other| other.name == name) {
            let why = format!(
                "\"{}\" is given twice; give each contact a name by the key name",
                truncate_for_message(&name)
            );
            return Err(InvalidKey::new("contact.name", why));
        }
        all.push(StudyContact { name, question });
    }
    Ok(all)
}
