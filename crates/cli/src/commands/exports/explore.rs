//! Command `percuss explore`.

use crate::args::ExploreArgs;
use crate::files::output::{check_writable, record_input, write_file};
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_out};
use crate::terminal::wrap::fact_line;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use percuss_explorer::{ENGINE, PageContent, page};
use percuss_formats::{Source, root_name};
use percuss_render::MADE_BY;
use percuss_study::{Model, ModelTable, PoseTable, mass, scene_shapes};
use serde_json::{Value, json};
use std::path::Path;
use std::process::{Command, Stdio};

/// Message of a build without the engine.
const NOT_BUILT: &str = "this build of percuss has no explorer: run crates/explorer/build.sh engine and build with \
    `cargo build --release --features explorer`, or take a package, which has everything";

/// Runs the command.
pub fn run(args: &ExploreArgs) -> Result<(), Failure> {
    let engine = ENGINE.ok_or_else(|| Failure::bad_input(NOT_BUILT))?;
    args.writing.apply();
    let path = &args.model.model;
    let reading = &args.model.reading;
    if reading.changes.worksheet.is_some() {
        return Err(Failure::bad_input(
            "--worksheet: the explorer reads no workbooks; save the sheet as CSV",
        ));
    }
    if args.contact.pose.file.is_some() {
        return Err(Failure::bad_input("--pose: the page has no other files; give the positions by --set"));
    }
    let source = Source::read(path, reading.max_size)?;
    let opened = Model::from_source(&source, &reading.options())?;
    opened.inputs.iter().for_each(|input| record_input(&input.path));
    if let Some(other) = opened.inputs.get(1) {
        return Err(Failure::bad_input(format!(
            "{path} reads {} as well; the page contains one file: write the points into the sheet, or convert the model \
             by percuss convert",
            other.path
        )));
    }
    let text = std::str::from_utf8(&source.bytes)
        .map_err(|_| Failure::bad_input(format!("{path}: the page contains text; this file is not UTF-8")))?;
    if root_name(text) == Some("sdf") {
        return Err(Failure::bad_input(format!(
            "{path}: the page does not read SDFormat; convert the model: percuss convert {path} -o MODEL.urdf"
        )));
    }
    let changes = reading.changes();
    let model = if changes.is_empty() { opened } else { opened.with_changes(&changes)? };
    write_diagnostics(&model.diagnostics, reading.strict)?;
    let study = study(args, &model)?;
    let start = json!({
        "model": { "name": source.name, "text": text, "shapes": shapes(&model) },
        "study": study,
    });
    let output = args.output.clone().unwrap_or_else(|| default_output(&source.name));
    check_writable(&output)?;
    let title = format!("percuss explorer: {}", model.mechanism.name());
    let html = page(&PageContent { title: &title, generator: MADE_BY, start: &start, engine });
    write_file(&output, html.as_bytes())?;
    write_out(&fact_line("written", &line(&output)))?;
    if args.open { open(&output) } else { Ok(()) }
}

/// Tables of the question at first sight. Without a contact, the page chooses the first one with a result.
fn study(args: &ExploreArgs, model: &Model) -> Result<Value, Failure> {
    let given = &args.contact;
    if !given.contact.is_empty() {
        // A question without a result is explained by the page; an invalid one is refused here.
        match mass(model, &given.question()?) {
            Err(error) if !error.has_no_result() => return Err(error.into()),
            Ok(_) | Err(_) => {}
        }
    }
    let conditions = given.conditions()?;
    let pose =
        PoseTable { set: conditions.set, guess: conditions.guess, travel: conditions.travel, file: None };
    let table = ModelTable { path: args.model.model.clone(), ..args.model.reading.changes.clone() };
    Ok(json!({
        "model": table,
        "contact": given.contact,
        "pose": pose,
        "conditions": given.conditions,
        "hold": given.hold,
    }))
}

/// Triangles of each link as base64 of 32-bit floats, which drawing needs; null for a link without shapes.
fn shapes(model: &Model) -> Vec<Option<String>> {
    let encode = |facets: Vec<[[f64; 3]; 3]>| {
        let numbers = facets.iter().flatten().flatten();
        let bytes: Vec<u8> = numbers.flat_map(|x| (*x as f32).to_le_bytes()).collect();
        (!bytes.is_empty()).then(|| STANDARD.encode(bytes))
    };
    scene_shapes(model).into_iter().map(encode).collect()
}

/// Name of the model with `.html`, in the current folder.
fn default_output(model: &str) -> String {
    let stem = Path::new(model).file_stem().map_or_else(|| "model".into(), |stem| stem.to_string_lossy());
    format!("{stem}.html")
}

/// Opens a file by the program of the operating system.
fn open(path: &str) -> Result<(), Failure> {
    let program = match std::env::consts::OS {
        "windows" => "explorer",
        "macos" => "open",
        _ => "xdg-open",
    };
    let started = Command::new(program)
        .arg(path)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    match started {
        Ok(_) => Ok(()),
        Err(error) => {
            Err(Failure::NoAnswer(format!("--open: {program} {path}: {error}; open the file in a browser")))
        }
    }
}
