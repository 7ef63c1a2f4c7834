//! Files that are written from the JSON schemas of studies and reports.

use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_study::{
    CheckReport, ContactListReport, DampingReport, Explanation, GivenContact, ImpactReport, KinematicsReport,
    MassReport, Model, PointMapReport, PosedMass, ReflectedReport, RequestReport, SafeSpeedReport, Scene,
    SceneShapes, check, report_schema, study_key_page, study_keys, study_schema,
};
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Types of values in a language.
struct Language {
    /// Names of the types `string`, `number`, `integer`, `boolean` and `null`.
    plain: [&'static str; 5],
    /// Separator of alternatives.
    or: &'static str,
    /// Type of some words, each in quotation marks.
    words: fn(&[String]) -> String,
    /// Quotation mark.
    quote: char,
    list: fn(&str) -> String,
    /// List with a fixed number of values.
    tuple: fn(&[String]) -> String,
    /// Values by name.
    table: fn(&str) -> String,
    record: fn(&str) -> String,
}

const PYTHON: Language = Language {
    plain: ["str", "float", "int", "bool", "None"],
    or: " | ",
    words: |words| format!("Literal[{}]", words.join(", ")),
    quote: '"',
    list: |item| format!("list[{item}]"),
    tuple: |items| {
        let kinds: BTreeSet<&String> = items.iter().collect();
        format!("list[{}]", kinds.into_iter().map(String::as_str).collect::<Vec<_>>().join(" | "))
    },
    table: |item| format!("dict[str, {item}]"),
    record: |name| python_class(name).to_owned(),
};

const TYPESCRIPT: Language = Language {
    plain: ["string", "number", "number", "boolean", "null"],
    or: " | ",
    words: |words| words.join(" | "),
    quote: '\'',
    list: |item| if item.contains(' ') { format!("({item})[]") } else { format!("{item}[]") },
    tuple: |items| format!("[{}]", items.join(", ")),
    table: |item| format!("Record<string, {item}>"),
    record: str::to_owned,
};

const PAGE: Language = Language {
    plain: ["text", "number", "whole number", "true or false", "null"],
    or: " or ",
    words: |words| words.join(", "),
    quote: '`',
    list: |item| format!("list of: {item}"),
    tuple: |items| format!("({})", items.join(", ")),
    table: |item| format!("by name: {item}"),
    record: |name| format!("[{name}](#{})", name.to_lowercase()),
};

/// Records of all reports by name.
struct Records(Map<String, Value>);

/// Field of a record.
struct Field<'a> {
    key: &'a str,
    schema: &'a Value,
    /// True if the key is always present.
    is_present: bool,
}

/// Records of some reports.
macro_rules! records {
    ($($report:ty),*) => {{
        let mut generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
        $(generator.subschema_for::<$report>();)*
        Records(generator.take_definitions(true))
    }};
}

impl Records {
    /// Records of all reports.
    fn all() -> Self {
        let Value::Object(records) = report_schema()["$defs"].take() else { panic!("no records") };
        Self(records)
    }

    /// Names and schemas.
    fn iter(&self) -> impl Iterator<Item = (&String, &Value)> {
        self.0.iter().filter(|(_, record)| record.get("properties").is_some())
    }

    /// Fields of a record in the order of its declaration; keys that may be absent are last.
    fn fields<'a>(&'a self, name: &str) -> Vec<Field<'a>> {
        let record = &self.0[name];
        let present: Vec<&str> = list(record, "required").filter_map(Value::as_str).collect();
        let all = record["properties"].as_object().expect("fields").keys().map(String::as_str);
        let absent = all.filter(|key| !present.contains(key)).map(|key| (key, false));
        let keys = present.iter().map(|key| (*key, true)).chain(absent);
        keys.map(|(key, is_present)| Field { key, schema: &record["properties"][key], is_present }).collect()
    }

    /// Alternative types of a value, null last.
    fn types(&self, schema: &Value, language: &Language) -> Vec<String> {
        if let Some(path) = schema.get("$ref").and_then(Value::as_str) {
            let name = path.trim_start_matches("#/$defs/");
            return match self.0[name].get("properties") {
                Some(_) => vec![(language.record)(name)],
                None => self.types(&self.0[name], language),
            };
        }
        let quoted = |word: &Value| {
            let quote = language.quote;
            word.as_str().map(|word| format!("{quote}{word}{quote}"))
        };
        let alternatives: Vec<&Value> = list(schema, "anyOf").chain(list(schema, "oneOf")).collect();
        let words = list(schema, "enum").chain(schema.get("const"));
        let words = words.chain(alternatives.iter().filter_map(|one| one.get("const")));
        let words: Vec<String> = words.filter_map(quoted).collect();
        if !words.is_empty() {
            return vec![(language.words)(&words)];
        }
        let mut found: Vec<String> = alternatives.iter().flat_map(|one| self.types(one, language)).collect();
        let single = schema.get("type").filter(|kind| kind.is_string());
        for kind in single.into_iter().chain(list(schema, "type")).filter_map(Value::as_str) {
            found.push(match kind {
                "array" => {
                    let item = self.name(&schema["items"], language);
                    let is_fixed = schema["minItems"] == schema["maxItems"];
                    let count = schema["minItems"].as_u64().filter(|_| is_fixed).unwrap_or_default();
                    let mut items: Vec<_> =
                        list(schema, "prefixItems").map(|item| self.name(item, language)).collect();
                    items.resize(usize::try_from(count).expect("a few").max(items.len()), item.clone());
                    if items.is_empty() { (language.list)(&item) } else { (language.tuple)(&items) }
                }
                "object" => (language.table)(&self.name(&schema["additionalProperties"], language)),
                plain => {
                    let known = ["string", "number", "integer", "boolean", "null"];
                    let known = known.iter().position(|known| *known == plain).expect("a known type");
                    language.plain[known].to_owned()
                }
            });
        }
        found.sort_by_key(|name| name == language.plain[4]);
        found.dedup();
        found
    }

    /// Type of a value.
    fn name(&self, schema: &Value, language: &Language) -> String {
        self.types(schema, language).join(language.or)
    }
}

/// Values of a keyword of a schema.
fn list<'a>(schema: &'a Value, keyword: &str) -> impl Iterator<Item = &'a Value> {
    schema.get(keyword).and_then(Value::as_array).into_iter().flatten()
}

/// Description in one line, without links of Rust.
fn description(schema: &Value) -> String {
    let text = schema["description"].as_str().unwrap_or_default();
    let mut text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    while let Some((before, rest)) = text.split_once("[`") {
        let (name, after) = rest.split_once("`]").expect("the end of a link");
        let after =
            after.strip_prefix('(').and_then(|path| path.split_once(')')).map_or(after, |(_, rest)| rest);
        text = format!("{before}`{name}`{after}");
    }
    text
}

/// Lines of at most `width` characters, with whole words.
fn wrapped<'a>(words: impl Iterator<Item = &'a str>, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in words {
        let last = lines.last_mut().expect("a line");
        if last.is_empty() {
            *last = word.to_owned();
        } else if last.chars().count() + 1 + word.chars().count() <= width {
            *last = format!("{last} {word}");
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

/// Page of all records.
fn page() -> String {
    let records = Records::all();
    let schema = report_schema();
    let reports: Vec<String> = list(&schema, "anyOf").map(|report| records.name(report, &PAGE)).collect();
    let mut page = format!(
        "# Keys of reports\n\nEach key of the JSON that commands print with `--format json`, written from the schema that `percuss schema \
         --format report` prints.\nNumbers are in SI units. A number without a finite value is null.\n\nReports: {}.\n",
        reports.join(", "),
    );
    for (name, record) in records.iter() {
        page +=
            &format!("\n## {name}\n\n{}\n\n| key | value | meaning |\n|---|---|---|\n", description(record));
        for Field { key, schema, is_present } in records.fields(name) {
            let kind = records.name(schema, &PAGE);
            let absent = if is_present { "" } else { " or absent" };
            page += &format!("| `{key}` | {kind}{absent} | {} |\n", description(schema).replace('|', "\\|"));
        }
    }
    page
}

/// Class of a record in Python. `percuss.reports.MapReport` has arrays also.
fn python_class(name: &str) -> &str {
    if name == "MapReport" { "MapRecord" } else { name }
}

/// Docstring of Python.
fn docstring(schema: &Value, indent: &str) -> String {
    let text =
        description(schema).replace("`null`", "None").replace("Null ", "None ").replace(" null", " None");
    let text = text.replace('`', "\"");
    let mut text = wrapped(text.split(' '), 125 - indent.len()).join(&format!("\n{indent}"));
    if text.ends_with('"') {
        text.push(' ');
    }
    format!("{indent}\"\"\"{text}\"\"\"\n")
}

/// Module `percuss.records`.
fn python() -> String {
    let records = records!(RequestReport, ReflectedReport, CheckReport);
    let mut module = String::from(
        "\"\"\"Types of the reports and of their parts. Written from the JSON schema of the reports: CONTRIBUTING.md.\"\"\"\n\n\
         from __future__ import annotations\n\nfrom typing import Literal\n\nfrom ._record import AnyRecord as AnyRecord\n\
         from ._record import Record as Record\n",
    );
    for (name, record) in records.iter() {
        module += &format!("\n\nclass {}(Record):\n{}\n", python_class(name), docstring(record, "    "));
        // `from` is a keyword of Python: the key has no attribute.
        for Field { key, schema, is_present } in
            records.fields(name).iter().filter(|field| field.key != "from")
        {
            let mut kinds = records.types(schema, &PYTHON);
            if !is_present && kinds.last().is_none_or(|kind| kind != "None") {
                kinds.push("None".to_owned());
            }
            module += &format!("    {key}: {}\n{}", kinds.join(" | "), docstring(schema, "    "));
        }
    }
    module
}

/// Reports of the page of `percuss explore`.
fn typescript() -> String {
    let records = records!(
        MassReport,
        PosedMass,
        ContactListReport,
        Explanation,
        DampingReport,
        ImpactReport,
        SafeSpeedReport,
        KinematicsReport,
        PointMapReport,
        GivenContact,
        Scene,
        SceneShapes
    );
    let mut module = String::from(
        "// Reports. Written from their JSON schema: CONTRIBUTING.md. SI units; docs/reference/REPORT_KEYS.md.\n\n\
         export type Triple = [number, number, number];\n",
    );
    for (name, _) in records.iter() {
        let fields = records.fields(name).into_iter().map(|Field { key, schema, is_present }| {
            let optional = if is_present { "" } else { "?" };
            format!("{key}{optional}: {};", records.name(schema, &TYPESCRIPT))
        });
        let fields: Vec<String> = fields.collect();
        let lines = wrapped(fields.iter().map(String::as_str), 138).join("\n  ");
        module += &format!("\nexport interface {name} {{\n  {lines}\n}}\n")
            .replace("[number, number, number]", "Triple");
    }
    module
}

#[test]
fn generated_files_are_fresh() {
    let schema = serde_json::to_string_pretty(study_schema()).unwrap() + "\n";
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for (file, text) in [
        ("docs/study.schema.json", schema),
        ("docs/reference/STUDY_KEYS.md", study_key_page()),
        ("docs/reference/REPORT_KEYS.md", page()),
        ("crates/python/python/percuss/records.py", python()),
        ("crates/explorer/page/src/engine/reports.ts", typescript()),
    ] {
        if std::env::var_os("PERCUSS_UPDATE").is_some() {
            fs::write(root.join(file), text).unwrap();
        } else {
            let kept = fs::read_to_string(root.join(file)).unwrap_or_default();
            let update = "PERCUSS_UPDATE=1 cargo test --workspace --test study -- generated";
            assert!(kept == text, "{file} differs from the schema; write it: {update}");
        }
    }
}

/// True if a document agrees with a schema: types, constants, words, required keys and the schemas of keys and items.
fn agrees(document: &Value, schema: &Value, definitions: &Value) -> bool {
    if let Some(path) = schema.get("$ref").and_then(Value::as_str) {
        return agrees(document, &definitions[path.trim_start_matches("#/$defs/")], definitions);
    }
    let is_kind = |kind: &Value| match kind.as_str().expect("a type") {
        "object" => document.is_object(),
        "array" => document.is_array(),
        "string" => document.is_string(),
        "number" => document.is_number(),
        "integer" => document.is_i64() || document.is_u64(),
        "boolean" => document.is_boolean(),
        "null" => document.is_null(),
        other => panic!("unknown type {other}"),
    };
    let kinds: Vec<&Value> =
        schema.get("type").into_iter().filter(|kind| kind.is_string()).chain(list(schema, "type")).collect();
    let alternatives: Vec<&Value> = list(schema, "anyOf").chain(list(schema, "oneOf")).collect();
    let of_key = |(key, of_key): (&String, &Value)| {
        document.get(key).is_none_or(|value| agrees(value, of_key, definitions))
    };
    let items = schema.get("items").zip(document.as_array());
    let words: Vec<&Value> = list(schema, "enum").collect();
    (kinds.is_empty() || kinds.into_iter().any(is_kind))
        && schema.get("const").is_none_or(|word| word == document)
        && (words.is_empty() || words.contains(&document))
        && list(schema, "required").all(|key| document.get(key.as_str().expect("a key")).is_some())
        && schema.get("properties").and_then(Value::as_object).is_none_or(|keys| keys.iter().all(of_key))
        && items.is_none_or(|(schema, items)| items.iter().all(|item| agrees(item, schema, definitions)))
        && (alternatives.is_empty() || alternatives.iter().any(|one| agrees(document, one, definitions)))
}

#[test]
fn the_schema_of_reports_refuses_wrong_documents() {
    let schema = report_schema();
    let is_valid = |document: &Value| agrees(document, &schema, &schema["$defs"]);
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/point_mass_pendulum.urdf");
    let model = Model::load(path, DEFAULT_MAX_SIZE, &LoadOptions::default()).expect("a model");
    let report = serde_json::to_value(check(&model).expect("contents")).expect("JSON");
    assert!(is_valid(&report));
    let changed = |key: &str, value: Value| {
        let mut report = report.clone();
        report[key] = value;
        report
    };
    let mut wrong = vec![json!({}), json!([{}]), json!(1), json!({"schema": "percuss.report/1"})];
    for (key, value) in [
        ("schema", json!("percuss.mass/1")),
        ("schema", json!("percuss.report/2")),
        ("schema", Value::Null),
        ("total_mass", json!("1 kg")),
        ("links", json!([{"name": "rod"}])),
        ("degrees_of_freedom", json!(1.5)),
    ] {
        wrong.push(changed(key, value));
    }
    for key in report.as_object().expect("keys").keys() {
        let mut report = report.clone();
        report.as_object_mut().expect("keys").remove(key);
        wrong.push(report);
    }
    for document in wrong {
        assert!(!is_valid(&document), "{document}");
    }
    // A member of the list without its name would agree with other reports.
    let names: BTreeSet<String> = list(&schema, "anyOf")
        .filter_map(|report| report.get("$ref")?.as_str())
        .map(|path| &schema["$defs"][path.trim_start_matches("#/$defs/")])
        .map(|record| record["properties"]["schema"]["const"].to_string())
        .collect();
    assert!(names.len() > 15 && !names.contains("null"), "{names:?}");
}

#[test]
fn the_pages_name_every_key_with_its_meaning() {
    let page_of_studies = study_key_page();
    for key in study_keys().iter().filter(|key| key.matches('.').count() == 1) {
        let (_, name) = key.split_once('.').expect("one dot");
        assert!(page_of_studies.contains(&format!("| `{name}` |")), "{key}");
    }
    let records = Records::all();
    let fields: Vec<_> = records
        .iter()
        .flat_map(|(name, _)| records.fields(name).into_iter().map(move |field| (name, field)))
        .collect();
    assert!(fields.len() > 500, "only {} keys", fields.len());
    for (name, field) in fields {
        assert!(description(field.schema).len() > 3, "{name}.{} has no meaning", field.key);
    }
}
