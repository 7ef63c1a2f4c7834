//! The calls, the structure and the constant of the example in Julia agree with the header. Few machines that run the tests have Julia.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

fn text(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect("a readable file")
}

/// Text without the comments of C.
fn without_comments(source: &str) -> String {
    let mut parts = source.split("/*");
    let mut kept = parts.next().unwrap_or_default().to_owned();
    parts.for_each(|part| kept += part.split_once("*/").map_or("", |(_, after)| after));
    kept
}

/// Text between the bracket at the start of `source` and the bracket that closes it.
fn in_brackets(source: &str) -> &str {
    let mut depth = 0;
    for (at, character) in source.char_indices() {
        match character {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return &source[1..at];
        }
    }
    panic!("a bracket is not closed: {source}")
}

/// Items between the commas that are not in brackets.
fn items(list: &str) -> Vec<String> {
    let (mut depth, mut found) = (0, vec![String::new()]);
    for character in list.chars() {
        match character {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 0 => {
                found.push(String::new());
                continue;
            }
            _ => {}
        }
        found.last_mut().expect("an item").push(character);
    }
    found
        .into_iter()
        .map(|item| item.trim().to_owned())
        .filter(|item| !item.is_empty() && item != "void")
        .collect()
}

/// The types of the header that are names of other types: `typedef int32_t percuss_status;`.
fn aliases(header: &str) -> BTreeMap<String, String> {
    let lines = header.lines().filter_map(|line| line.strip_prefix("typedef ")?.strip_suffix(';'));
    let plain = lines.filter(|line| !line.contains(['(', '{']) && !line.starts_with("struct "));
    plain.filter_map(|line| line.rsplit_once(' ')).map(|(old, new)| (new.into(), old.into())).collect()
}

/// Type of a C declaration (`const double *positions`) without name and const; a function pointer is `void *`.
fn type_of(declaration: &str, aliases: &BTreeMap<String, String>) -> String {
    let stars = "*".repeat(declaration.matches('*').count());
    let words: Vec<&str> = declaration
        .split([' ', '*'])
        .filter(|word| !word.is_empty() && !["const", "struct"].contains(word))
        .collect();
    let name = words.first().expect("a type");
    if *name == "percuss_watch" {
        return "void*".into();
    }
    aliases.get(*name).map_or(*name, String::as_str).to_owned() + &stars
}

/// C types that a type of Julia passes.
fn types_in_c(julia: &str) -> &'static [&'static str] {
    match julia {
        "Cstring" => &["char*"],
        "Csize_t" => &["size_t"],
        "Cdouble" => &["double"],
        "Int32" => &["int32_t"],
        "Ptr{Cdouble}" => &["double*"],
        "Ptr{Csize_t}" => &["size_t*"],
        "Ptr{Int32}" => &["int32_t*"],
        "Ptr{UInt32}" => &["uint32_t*"],
        "Ref{Contact}" => &["percuss_contact*"],
        // Handles, null pointers to them, and the function and its data that a batch calls.
        "Ptr{Cvoid}" => &[
            "percuss_model*",
            "percuss_conditions*",
            "percuss_configuration*",
            "percuss_system*",
            "percuss_assembly*",
            "percuss_batch*",
            "void*",
        ],
        "Ptr{Ptr{Cvoid}}" => {
            &["percuss_model**", "percuss_system**", "percuss_assembly**", "percuss_batch**"]
        }
        other => panic!("the type {other} of Julia has no type of C in this test"),
    }
}

#[test]
fn calls_agree_with_the_header() {
    let (header, julia) = (
        without_comments(&text("include/percuss.h").replace("PERCUSS_NODISCARD ", "")),
        text("examples/two_links.jl"),
    );
    let aliases = aliases(&header);
    let mut compared = 0;
    for call in julia.split("@ccall percuss.").skip(1) {
        let (name, rest) = call.split_at(call.find('(').expect("a call"));
        let arguments = in_brackets(rest);
        let result = rest[arguments.len() + 2..].strip_prefix("::").expect("a type of the result");
        let result: String = result.chars().take_while(char::is_ascii_alphanumeric).collect();
        let start = [format!(" {name}("), format!("*{name}(")].iter().find_map(|text| header.find(text));
        let start = start.unwrap_or_else(|| panic!("the header has no function {name}"));
        let line = header[..start].rfind('\n').map_or(0, |at| at + 1);
        let returned = type_of(&header[line..=start], &aliases);
        assert!(types_in_c(&result).contains(&returned.as_str()), "{name} returns {returned}, not {result}");
        let declared = items(in_brackets(&header[start + 1 + name.len()..]));
        let passed = items(arguments);
        assert_eq!(passed.len(), declared.len(), "arguments of {name}: {passed:?}, {declared:?}");
        for (passed, declared) in passed.iter().zip(&declared) {
            let (_, julia_type) = passed.rsplit_once("::").expect("a type of the argument");
            let expected = type_of(declared, &aliases);
            assert!(types_in_c(julia_type).contains(&expected.as_str()), "{name}: {passed} for {declared}");
            compared += 1;
        }
    }
    assert!(compared > 30, "only {compared} arguments were found");
}

#[test]
fn structure_and_constant_agree_with_the_header() {
    let (header, julia) = (
        without_comments(&text("include/percuss.h").replace("PERCUSS_NODISCARD ", "")),
        text("examples/two_links.jl"),
    );
    let aliases = aliases(&header);
    let at = header.find("typedef struct percuss_contact {").expect("the structure");
    let members = in_brackets(&header[at + header[at..].find('{').expect("a bracket")..]);
    let declared: Vec<(String, String)> = members
        .split(';')
        .filter_map(|member| {
            let (kind, name) = member.trim().rsplit_once(' ')?;
            let kind = aliases.get(kind).map_or(kind, String::as_str);
            Some(match name.split_once('[') {
                Some((name, count)) => (name.into(), format!("{kind}[{count}")),
                None => (name.into(), kind.into()),
            })
        })
        .collect();
    let fields = julia.split("mutable struct Contact\n").nth(1).expect("the structure in Julia");
    let fields: Vec<(String, String)> = fields
        .lines()
        .map_while(|line| line.trim().split_once("::"))
        .map(|(name, kind)| {
            let kind = match kind {
                "Csize_t" => "size_t",
                "NTuple{3,Cdouble}" => "double[3]",
                "Int32" => "int32_t",
                other => panic!("the type {other} of Julia has no type of C in this test"),
            };
            (name.into(), kind.into())
        })
        .collect();
    assert_eq!(fields, declared);
    assert!(
        header.contains("#define PERCUSS_COLUMN_MAJOR 1\n") && julia.contains("const COLUMN_MAJOR = 1\n")
    );
}
