//! Command `percuss explore`.

use crate::args::ExploreArgs;
use crate::files::output::{check_writable, record_input, write_file};
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::report::{note, write_diagnostics, write_text};
use crate::terminal::wrap::fact_line;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use percuss_explorer::{ENGINE, PageContent, page};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadError, LoadOptions, Source};
use percuss_render::MADE_BY;
use percuss_study::{
    MassQuestion, Model, ModelTable, Names, PageTables, SceneShapes, StudyFile, mass, scene_shapes,
};
use serde_json::json;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};

/// Message of a build without the engine.
const NOT_BUILT: &str = "this build of percuss has no explorer: run, in the sources, \
    `cargo run --release --features explorer -- explore models/four_bar.urdf`, or take a package, which has everything";

/// First bytes of a workbook (a ZIP archive).
const WORKBOOK: &[u8] = b"PK\x03\x04";

/// Largest total size of the further files of a model in a page, bytes.
const LARGEST_FILES: u64 = 16 << 20;

/// Largest total size of the shapes in a page, bytes of base64: about 900,000 triangles. Browsers store the text of a page in memory twice.
const LARGEST_SHAPES: usize = 40 << 20;

/// Question at first sight, from flags or from a study.
struct FirstQuestion {
    tables: PageTables,
    max_size: u64,
    strict: bool,
}

/// Runs the command.
pub fn run(args: &ExploreArgs) -> Result<(), Failure> {
    args.writing.apply();
    let path = &args.model.model;
    let reading = &args.model.reading;
    let (max_size, strict) = (reading.max_size, reading.strict);
    let is_study = StudyFile::is_study(path, max_size);
    let tables = if is_study { of_study(args)? } else { of_flags(args)? };
    let output = args.output.clone().unwrap_or_else(|| default_output(path));
    if is_study {
        record_input(path);
    }
    check_writable(&output)?;
    let html = page_text(&FirstQuestion { tables, max_size, strict })?;
    write_file(&output, html.as_bytes())?;
    write_text(&fact_line("written", &line(&output)))?;
    if args.open { open(&output) } else { Ok(()) }
}

/// Text of the page of a study.
pub fn study_page(study: &StudyFile, max_size: u64, strict: bool) -> Result<String, Failure> {
    page_text(&FirstQuestion { tables: study.page.clone(), max_size, strict })
}

/// Text of the page, which contains the model and the question.
fn page_text(first: &FirstQuestion) -> Result<String, Failure> {
    let engine = ENGINE.ok_or_else(|| Failure::bad_input(NOT_BUILT))?;
    let FirstQuestion { tables, max_size, strict } = first;
    let path = &tables.model.path;
    if tables.model.worksheet.is_some() {
        return Err(Failure::bad_input("worksheet: the explorer reads no workbooks; save the sheet as CSV"));
    }
    if tables.closures > 0 {
        return Err(Failure::bad_input(
            "closure: the page cannot add loops to a model; write them into the model file (percuss convert)",
        ));
    }
    if tables.contact.about_axis.is_some() {
        return Err(Failure::bad_input(
            "about_axis: the page shows contacts at points and stops of joints; percuss mass computes the effective inertia about an axis",
        ));
    }
    let source = Source::read(path, *max_size)?;
    let options = LoadOptions { accept: tables.model.accepted(), ..LoadOptions::default() };
    let opened = Model::from_source(&source, &options)?;
    opened.inputs.iter().for_each(|input| record_input(&input.path));
    let files = further_files(&opened)?;
    let text = std::str::from_utf8(&source.bytes)
        .map_err(|_| Failure::bad_input(format!("{path}: the page contains text; this file is not UTF-8")))?;
    if let Some(file) =
        tables.pose.file.as_ref().filter(|file| !opened.poses.iter().any(|pose| pose.name == **file))
    {
        return Err(Failure::bad_input(format!(
            "pose: the model has no pose {file:?}, and the page reads no other file; give the positions by --set, or by [pose] set"
        )));
    }
    let changes = tables.model.changes();
    let model = if changes.is_empty() { opened } else { opened.with_changes(&changes)? };
    write_diagnostics(&model.diagnostics, *strict)?;
    check_question(tables, &model)?;
    if !tables.other_models.is_empty() {
        note(&format!(
            "the page contains one model file; variants of other files are left out: {}",
            tables.other_models.join(", ")
        ));
    }
    let start = json!({
        "model": { "name": path_in_page(&source.name), "text": text, "files": files, "shapes": shapes(&model, *strict)? },
        "study": tables,
        "driver": tables.varied,
        "variants": tables.variants,
    });
    let title = format!("percuss explorer: {}", model.mechanism.name());
    Ok(page(&PageContent { title: &title, generator: MADE_BY, start: &start, engine }))
}

/// Tables of the flags. Without a contact, the page chooses the first one with a result.
fn of_flags(args: &ExploreArgs) -> Result<PageTables, Failure> {
    let given = &args.contact;
    Ok(PageTables {
        model: ModelTable { path: args.model.model.clone(), ..args.model.reading.changes.clone() },
        contact: given.contact.clone(),
        pose: given.conditions()?.pose,
        conditions: given.conditions.clone(),
        hold: given.hold.clone(),
        ..PageTables::default()
    })
}

/// Tables of a study. Flags of the question would exclude those of the study.
fn of_study(args: &ExploreArgs) -> Result<PageTables, Failure> {
    let path = &args.model.model;
    if args.contact.is_given() || !args.model.reading.changes().is_empty() {
        return Err(Failure::bad_input(format!(
            "{path} is a study with its own question: remove the flags of contact, pose, conditions and changes, or write them \
             into the study"
        )));
    }
    Ok(StudyFile::load(path, args.model.reading.max_size)?.page)
}

/// Refuses an invalid question. A question without a result is explained by the page.
fn check_question(tables: &PageTables, model: &Model) -> Result<(), Failure> {
    let PageTables { contact, pose, conditions, hold, .. } = tables;
    if contact.is_empty() {
        return Ok(());
    }
    let question = MassQuestion::of_tables(contact, pose, conditions, hold, Names::Flags)
        .checked(Path::new(""), DEFAULT_MAX_SIZE)
        .map_err(|error| Failure::bad_input(error.message(Names::Flags)))?;
    match mass(model, &question) {
        Err(error) if !error.has_no_result() => Err(error.into()),
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Files that a model reads in addition to the model file, in base64 by path: included files, meshes of inertias, the table of a sheet.
fn further_files(model: &Model) -> Result<BTreeMap<String, String>, Failure> {
    let mut files = BTreeMap::new();
    let mut left = LARGEST_FILES;
    for input in model.inputs.iter().skip(1) {
        let path = &*input.path;
        let too_large = |error: LoadError| match &error.diagnostics[..] {
            [found] if found.code == "too-large-file" => Failure::bad_input(format!(
                "{path}: the files that the model reads have more than {} MiB in total, the limit of a page; give the bodies an \
                 <inertial> element, so that their inertias need no meshes",
                LARGEST_FILES >> 20
            )),
            _ => Failure::from(error),
        };
        let Source { bytes, .. } = Source::read(path, left).map_err(too_large)?;
        if bytes.starts_with(WORKBOOK) {
            return Err(Failure::bad_input(format!(
                "{path}: the explorer reads no workbooks; save the table as CSV"
            )));
        }
        left -= bytes.len() as u64;
        files.insert(path_in_page(path), STANDARD.encode(bytes));
    }
    Ok(files)
}

/// Path with the separator of the engine, which is that of Unix on every system.
fn path_in_page(path: &str) -> String {
    if cfg!(windows) { path.replace('\\', "/") } else { path.to_owned() }
}

/// Triangles of each link; `None` for a link without shapes. Reports the omitted shapes.
fn shapes(model: &Model, strict: bool) -> Result<Vec<Option<String>>, Failure> {
    let SceneShapes { mut links, diagnostics } = scene_shapes(model);
    write_diagnostics(&diagnostics, strict)?;
    let mut left = LARGEST_SHAPES;
    for (link, shape) in model.mechanism.links().iter().zip(&mut links) {
        let size = shape.as_ref().map_or(0, String::len);
        if size > left {
            note(&format!(
                "link \"{}\" is drawn without its shape of {} MiB: the limit for all shapes of a page is {} MiB",
                link.name(),
                size >> 20,
                LARGEST_SHAPES >> 20
            ));
            *shape = None;
        } else {
            left -= size;
        }
    }
    Ok(links)
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
