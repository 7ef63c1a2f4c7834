//! JSON schema of a study file, generated from the types that read the file, and the keys of the schema.

use crate::question::names::TableKeys;
use crate::study_file::text::StudyTables;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Generated once.
static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
    let settings = SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true);
    let mut schema = settings.into_generator().into_root_schema_for::<StudyTables>().to_value();
    remove_null(&mut schema);
    schema
});

/// JSON schema (draft 2020-12) of a study file: all keys with descriptions. Keys outside of the schema are
/// errors.
pub fn study_schema() -> &'static Value {
    &SCHEMA
}

/// Keys of a table of a study; empty for an unknown table.
pub(crate) fn table_keys(table: &str) -> &'static TableKeys {
    static TABLES: LazyLock<BTreeMap<String, TableKeys>> = LazyLock::new(|| {
        let mut tables = BTreeMap::<String, TableKeys>::new();
        for key in study_keys() {
            if let Some((table, last)) = key.split_once('.')
                && !last.contains('.')
            {
                tables.entry(table.to_owned()).or_default().0.push(key);
            }
        }
        tables
    });
    static NONE: TableKeys = TableKeys(Vec::new());
    TABLES.get(table).unwrap_or(&NONE)
}

/// Keys of a study file with the names of their tables: `contact.along_line.link`. Entries of a table of names,
/// such as the links of `model.link_mass`, are not keys.
pub fn study_keys() -> Vec<String> {
    fn collect(schema: &Value, path: &str, found: &mut Vec<String>) {
        for known in alternatives(schema).into_iter().filter_map(properties) {
            for (key, of_key) in known {
                let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
                collect(of_key, &path, found);
                found.push(path);
            }
        }
        for items in alternatives(schema).into_iter().filter_map(|one| one.get("items")) {
            collect(items, path, found);
        }
    }
    let mut found = Vec::new();
    collect(study_schema(), "", &mut found);
    found.sort();
    // A table and a list of such tables have the same keys.
    found.dedup();
    found
}

/// Page of all keys in Markdown: a table for each table of a study, with the kind of each value and its meaning.
pub fn study_key_page() -> String {
    let mut page = String::from(
        "# Keys of studies\n\nEach key of a study file, as `percuss schema --format markdown` prints it. Lengths are in m, angles in \
         rad, masses in kg, or text\nwith a unit (`\"350 mm\"`). [Studies](STUDIES.md) has an example.\n",
    );
    let tables = properties(study_schema()).into_iter().flatten();
    for (table, of_table) in tables {
        let name = if kind(of_table) == "list" { format!("[[{table}]]") } else { format!("[{table}]") };
        page +=
            &format!("\n## {name}\n\n{}\n\n| key | value | meaning |\n|---|---|---|\n", meaning(of_table));
        // A table and a list of such tables have the same keys.
        if let Some(known) = alternatives(of_table).into_iter().find_map(entries) {
            for (key, of_key) in known {
                page += &format!("| `{key}` | {} | {} |\n", kind(of_key), meaning(of_key));
            }
        }
    }
    page
}

/// Keys of a table, or of the tables of a list.
fn entries(schema: &Value) -> Option<&Map<String, Value>> {
    properties(schema).or_else(|| properties(schema.get("items")?))
}

/// Description of a key without line breaks, escaped for a table.
fn meaning(schema: &Value) -> String {
    let words = schema.get("description").and_then(Value::as_str).unwrap_or_default();
    let one_line = words.split_whitespace().collect::<Vec<_>>().join(" ");
    one_line.replace('|', "\\|")
}

/// Kind of a value: the possible words, or its type.
fn kind(schema: &Value) -> String {
    let words: Vec<String> = alternatives(schema)
        .into_iter()
        .flat_map(|one| {
            let words = one.get("enum").and_then(Value::as_array).into_iter().flatten();
            words.chain(one.get("const"))
        })
        .filter_map(|word| Some(format!("`{}`", word.as_str()?)))
        .collect();
    if !words.is_empty() {
        return words.join(", ");
    }
    let mut kinds: Vec<&str> = alternatives(schema)
        .into_iter()
        .filter_map(|one| match one.get("type")?.as_str()? {
            "array" => Some("list"),
            "object" => Some("table"),
            "string" => Some("text"),
            "boolean" => Some("true or false"),
            "integer" => Some("whole number"),
            other => Some(other),
        })
        .collect();
    kinds.dedup();
    kinds.join(" or ")
}

/// Schema and its alternatives.
pub(crate) fn alternatives(schema: &Value) -> Vec<&Value> {
    let of = |word: &str| schema.get(word).and_then(Value::as_array).into_iter().flatten();
    [schema].into_iter().chain(of("anyOf")).chain(of("oneOf")).collect()
}

/// Keys of a table; `None` for other types and for a table of names.
pub(crate) fn properties(schema: &Value) -> Option<&Map<String, Value>> {
    schema.get("properties").and_then(Value::as_object)
}

/// True for null, an empty list or an empty table.
fn is_empty(value: &Value) -> bool {
    value.is_null()
        || value.as_array().is_some_and(Vec::is_empty)
        || value.as_object().is_some_and(Map::is_empty)
}

/// Removes null, which TOML lacks: an optional key is simply absent. Empty defaults say no more.
fn remove_null(schema: &mut Value) {
    let is_null = |value: &Value| value.get("type").is_some_and(|t| t == "null") || value == "null";
    match schema {
        Value::Object(map) => {
            for word in ["anyOf", "type"] {
                let Some(Value::Array(list)) = map.get_mut(word) else { continue };
                list.retain(|one| !is_null(one));
                if let [one] = &list[..] {
                    let one = one.clone();
                    map.remove(word);
                    match one {
                        Value::Object(inner) => inner.into_iter().for_each(|(key, value)| {
                            map.entry(key).or_insert(value);
                        }),
                        other => drop(map.insert(word.to_owned(), other)),
                    }
                }
            }
            map.retain(|key, value| key != "default" || !is_empty(value));
            map.values_mut().for_each(remove_null);
        }
        Value::Array(list) => list.iter_mut().for_each(remove_null),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_table_refuses_unknown_keys_and_every_key_says_what_it_means() {
        fn walk(schema: &Value, path: &str, keys: &mut BTreeSet<String>) {
            for one in alternatives(schema) {
                if let Some(known) = properties(one) {
                    assert_eq!(one.get("additionalProperties"), Some(&Value::Bool(false)), "{path}");
                    for (key, of_key) in known {
                        let path = format!("{path}.{key}");
                        let words = of_key.get("description").and_then(Value::as_str).unwrap_or_default();
                        assert!(words.len() > 8, "{path} does not say what it means");
                        walk(of_key, &path, keys);
                        keys.insert(path);
                    }
                }
                if let Some(items) = one.get("items") {
                    walk(items, path, keys);
                }
            }
        }
        let mut keys = BTreeSet::new();
        walk(study_schema(), "", &mut keys);
        assert!(keys.len() > 100, "only {} keys", keys.len());
        assert_eq!(keys.len(), study_keys().len());
        assert!(!study_schema().to_string().contains("\"null\""));
    }
}
