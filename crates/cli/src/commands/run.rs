//! Command `percuss run`.

use crate::args::{CheckFormat, MassFormat, RunArgs};
use crate::commands::check;
use crate::commands::compare::{self, ComparisonOutput};
use crate::commands::damp;
use crate::commands::exports::{convert, export, generate};
use crate::commands::impacts::rigid_impact::{self, ImpactView};
use crate::commands::impacts::{extremes, identify, response, restitution, safe_speed};
use crate::commands::map;
use crate::commands::mass::{self, contact_list};
use crate::commands::report;
use crate::commands::suspension::kinematics;
use crate::commands::sweep;
use crate::commands::sweep::{ReadySweep, SweepOutput};
use crate::files::contents::{self, TABLES_AND_PICTURES};
use crate::files::output::{check_writable, ending_of, record_input};
use crate::files::table_style::TableStyle;
use crate::terminal::failure::Failure;
use crate::terminal::report::{note, with_findings, write_diagnostics, write_text};
use crate::terminal::wrap::wrap_hanging;
use clap::ValueEnum;
use percuss_study::{
    ContactListReport, DiagnosticRecord, MapQuestion, MassOptions, MassQuestion, Names, RequestReport,
    RowSource, StudyAdditions, StudyFile, SweepQuestion,
};
use std::fs;
use std::path::{Path, PathBuf};

/// Runs the command: all questions of the study.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    let study = StudyFile::load(&args.study, args.max_size)?;
    args.writing.apply();
    input_files(&study).for_each(|path| record_input(&path));
    let outputs: Vec<(&'static str, String)> = output_files(&study, args).collect();
    run_study(&study, args, &outputs).map_err(|failure| failure.in_study(&args.study, &study.keys, &outputs))
}

/// Checks the output files, and runs all questions of a study.
fn run_study(study: &StudyFile, args: &RunArgs, outputs: &[(&'static str, String)]) -> Result<(), Failure> {
    if let Some(path) = args.report.as_ref().filter(|path| !path.to_lowercase().ends_with(".html")) {
        return Err(Failure::bad_input(format!("--report {path}: its name must end in .html")));
    }
    check_distinct_outputs(outputs.iter().cloned())?;
    for (key, path) in outputs {
        match *key {
            "damping.output" | "identify.output" | "response.output" => {
                ending_of(path, &TABLES_AND_PICTURES)?;
            }
            "sweep.output" if !(study.variants.is_empty() && study.contacts.is_empty()) => {
                ending_of(path, &contents::ALL)?;
            }
            "kinematics.output" => drop(kinematics::file_ending(path)?),
            "map.output" => drop(map::formats(std::slice::from_ref(path))?),
            _ => {}
        }
    }
    if !args.allow_outside {
        outputs.iter().try_for_each(|(name, path)| check_inside_folder(path, &study.folder, name))?;
    }
    // The files of generated code follow from the model; the output is their folder.
    let files = outputs.iter().filter(|(name, _)| *name != "generate.output");
    files.map(|(_, path)| path).try_for_each(|path| check_writable(path))?;
    sweep::use_threads(args.threads);
    match (&args.report, args.format) {
        (Some(path), _) => report::write(study, args, path),
        (None, Some(format)) => show_in_format(study, format, args.strict),
        (None, None) => run_all(study, args),
    }
}

/// Input files named by any part of the study.
fn input_files(study: &StudyFile) -> impl Iterator<Item = String> + '_ {
    let models = [&study.model].into_iter().chain(study.variants.iter().map(|variant| &variant.model));
    let of_models = models.flat_map(|model| &model.inputs).map(|input| input.path.clone());
    let poses = study.conditions.positions.iter().map(|pose| pose.input.path.clone());
    let rows = study.tables.sweep.iter().map(SweepQuestion::rows);
    let rows = rows.chain(study.tables.safe_speed.iter().filter_map(|requested| requested.rows()));
    let rows = rows.chain(study.tables.extremes.iter().filter_map(|requested| requested.rows()));
    let of_rows =
        rows.filter_map(|rows| if let RowSource::File(file) = rows { Some(file.path) } else { None });
    of_models.chain(poses).chain(of_rows)
}

/// Refuses two outputs with the same name, because the second would overwrite the first.
fn check_distinct_outputs(outputs: impl Iterator<Item = (&'static str, String)>) -> Result<(), Failure> {
    let mut targets: Vec<(&str, PathBuf)> = Vec::new();
    for (name, path) in outputs {
        // For a file that does not exist yet, the folder is resolved.
        let target = Path::new(&path);
        let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = fs::canonicalize(folder.unwrap_or(Path::new(".")));
        let at = match (folder, target.file_name()) {
            (Ok(folder), Some(file)) => folder.join(file),
            _ => target.to_owned(),
        };
        if let Some((other, _)) = targets.iter().find(|(_, known)| *known == at) {
            let other = if *other == name { "is given twice".into() } else { format!("is {other} too") };
            return Err(Failure::bad_input(format!("{name}: {path} {other}; give each its own file")));
        }
        targets.push((name, at));
    }
    Ok(())
}

/// Output files of this run, with the keys and flags that name them.
fn output_files<'a>(
    study: &'a StudyFile,
    args: &'a RunArgs,
) -> Box<dyn Iterator<Item = (&'static str, String)> + 'a> {
    if args.format.is_some() && args.report.is_none() {
        return Box::new(std::iter::empty());
    }
    let page = args.report.iter().flat_map(|path| report::files_of_page(study, path));
    let page = page.map(|path| ("--report", path));
    let explorer = args.explorer.iter().map(|path| ("--explorer", path.clone()));
    Box::new(page.chain(explorer).chain(study.outputs()))
}

/// Computes all tables of the study, then prints them in their order: an error of a table precedes the first result. The rows of a sweep
/// are computed while they are printed, after their check.
fn run_all(study: &StudyFile, args: &RunArgs) -> Result<(), Failure> {
    let (strict, tables, model) = (args.strict, &study.tables, &study.model);
    let has_designs = !(study.variants.is_empty() && study.contacts.is_empty());
    let has_rows = tables.sweep.is_some() || !study.variants.is_empty();
    let contacts = if has_rows { None } else { study.contact_list()? };
    // The list has the results of the comparison.
    let names = if contacts.is_some() { study.given_tables() } else { StudyFile::TABLES.to_vec() };
    let mass = if has_rows || has_designs { None } else { with_findings(study.mass_report(), model)? };
    note_left_out_of_rows(study, has_rows, contacts.as_ref());
    let report = with_findings(study.results(contacts, mass, &names), model)?;
    let history = tables.damping.as_ref().and_then(|damping| damping.output.as_deref());
    let history = match history {
        Some(path) => with_findings(study.damper(), model)?.map(|damper| (path, damper)),
        None => None,
    };
    let output = tables.sweep.as_ref().and_then(|sweep| sweep.output.as_deref());
    let table = tables
        .sweep
        .as_ref()
        .map_or_else(TableStyle::default, |sweep| TableStyle::from_study(&sweep.table()));
    let figure = tables.sweep.as_ref().map(SweepQuestion::figure).unwrap_or_default();
    let of_rows = study.question.as_ref().map(|question| study.question_of_rows(question));
    let sweep = match (&tables.sweep, &of_rows) {
        (Some(sweep), Some(question)) if !has_designs => {
            let destination = SweepOutput { output, table, figure: figure.clone(), strict };
            let prepared = study.prepared_sweep(sweep, question);
            Some(ReadySweep::new(model, question, &sweep.rows(), prepared, destination)?)
        }
        _ => None,
    };
    if let Some(list) = &report.contacts {
        contact_list::write(list, MassFormat::Text, strict)?;
    }
    if let Some(comparison) = &report.comparison {
        let written = ComparisonOutput { output, table, figure: &figure, format: MassFormat::Text, strict };
        compare::write(comparison, &written)?;
    }
    if let Some(mass) = &report.mass {
        mass::write(mass, &study.mass, &StudyAdditions::default(), (MassFormat::Text, strict), "")?;
    }
    if let Some(sweep) = sweep {
        sweep.run()?;
        // Without a file the rows are on the standard output, which is one table.
        if let Some(question) = study.question.as_ref().filter(|_| output.is_some()) {
            write_main_number(study, question)?;
        }
    }
    if let Some(damping) = &report.damping {
        write_diagnostics(&damping.diagnostics, strict)?;
        damp::print(damping, CheckFormat::Text)?;
    }
    if let Some((path, damper)) = history {
        damp::write_history(&damper, path)?;
    }
    if let Some(report) = &report.restitution {
        restitution::show(report, CheckFormat::Text, strict)?;
    }
    if let Some(report) = &report.identify {
        let output = tables.identify.as_ref().and_then(|asked| asked.output.as_deref());
        identify::show(report, output, CheckFormat::Text, strict)?;
    }
    if let Some(report) = &report.response {
        let output = tables.response.as_ref().and_then(|asked| asked.output.as_deref());
        response::show(report, output, CheckFormat::Text, strict)?;
    }
    if let Some(report) = &report.impact {
        write_diagnostics(&report.diagnostics, strict)?;
        rigid_impact::write(report, CheckFormat::Text, ImpactView::default())?;
    }
    if let Some(report) = &report.extremes {
        extremes::write(report, CheckFormat::Text, strict)?;
    }
    if let (Some(requested), Some(report)) = (&tables.kinematics, &report.kinematics) {
        kinematics::show_of_study(report, requested, strict)?;
    }
    // A search without success ends the run with its exit code, after all other results.
    let searched = report.targets.as_ref().map_or(Ok(()), |found| kinematics::show_targets(found, strict));
    if let (Some(requested), Some(result)) = (&tables.map, &report.map) {
        map::write(result, &map_output(requested, MassFormat::Text, strict)?)?;
    }
    if let Some(reports) = &report.safe_speed {
        safe_speed::show(reports, CheckFormat::Text, strict)?;
    }
    if let Some(report) = &report.check {
        check::write(report, CheckFormat::Text, strict)?;
    }
    if let (Some(report), Some(requested)) = (&report.generate, &tables.generate) {
        let folder = requested.output.as_deref().unwrap_or_default();
        generate::write_files(report, folder)?;
        write_text(&generate::summary(report, folder))?;
    }
    if let Some(mut report) = report.convert {
        write_diagnostics(&report.diagnostics, strict)?;
        convert::write_files(&mut report)?;
        write_text(&convert::summary(&report))?;
    }
    if let Some(mut report) = report.export {
        write_diagnostics(&report.diagnostics, strict)?;
        export::write_files(&mut report)?;
        write_text(&export::summary(&report))?;
    }
    searched
}

/// Notes the tables and keys that do not apply to rows, to variants, or to all of several contacts.
fn note_left_out_of_rows(study: &StudyFile, has_rows: bool, contacts: Option<&ContactListReport>) {
    let first = contacts.and_then(ContactListReport::first_with_result).map(|first| &first.name);
    let first = first.or(study.contacts.first().map(|first| &first.name));
    let of_first = ["mass", "restitution", "identify", "response", "impact", "extremes", "safe_speed"];
    let of_first: Vec<String> =
        of_first.into_iter().filter(|table| study.keys.contains(table)).map(in_brackets).collect();
    if let Some(first) = first.filter(|_| !of_first.is_empty()) {
        note(&format!("for the first contact ({first}) only: {}", of_first.join(", ")));
    }
    let Some(question) = &study.question else { return };
    if has_rows && (study.tables.damping.is_some() || study.mass != MassOptions::default()) {
        note(
            "[damping] and [mass] apply to the contact at its pose, not to rows and variants: --format text \
             shows them",
        );
    }
    if study.tables.sweep.is_some() && study.variants.is_empty() && study.contacts.is_empty() {
        let of_rows = study.question_of_rows(question).pose.travel;
        let left_out: Vec<String> = question
            .pose
            .travel
            .iter()
            .filter(|travel| !of_rows.contains(travel))
            .map(ToString::to_string)
            .collect();
        if !left_out.is_empty() {
            note(&format!(
                "[pose] travel = {} applies to the contact at its pose; the rows vary the travel themselves",
                left_out.join(", ")
            ));
        }
    }
}

/// Name of a table as in a file.
fn in_brackets(table: &str) -> String {
    format!("[{table}]")
}

/// Notes the tables whose results an output in a format leaves out. `printed`: the others.
fn note_left_out(study: &StudyFile, format: MassFormat, printed: &[&str]) {
    let is_left_out = |table: &&str| !printed.contains(table);
    let left_out: Vec<String> =
        study.given_tables().into_iter().filter(is_left_out).map(in_brackets).collect();
    let main = match (&study.question, printed) {
        (None, [table]) => in_brackets(table),
        _ => "the contact at its pose".to_owned(),
    };
    if !left_out.is_empty() {
        note(&format!(
            "--format {} prints {main}, without {}; omit --format, or run the commands for these tables",
            format.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned()),
            left_out.join(", ")
        ));
    }
}

/// Writes the findings of the impact and the extremes, except findings about the model.
fn write_additional_findings(
    study: &StudyFile,
    additions: &StudyAdditions,
    strict: bool,
) -> Result<(), Failure> {
    let of_impact = additions.impact.iter().flat_map(|report| &report.diagnostics);
    let all = of_impact.chain(additions.extremes.iter().flat_map(|report| &report.diagnostics));
    let own: Vec<DiagnosticRecord> =
        all.filter(|found| !study.model.diagnostics.contains(found)).cloned().collect();
    write_diagnostics(&own, strict)
}

/// Writes the effective mass at the pose of the study, below a sweep that is written to a file.
fn write_main_number(study: &StudyFile, question: &MassQuestion) -> Result<(), Failure> {
    match percuss_study::mass(&study.model, question) {
        Ok(report) => {
            let text = format!("{}, at the pose of the study", mass::first_line(&report));
            write_text(&(wrap_hanging(&text, 2) + "\n"))
        }
        Err(error) => {
            note(&format!("no effective mass at the pose of the study: {}", error.message(Names::KEYS)));
            Ok(())
        }
    }
}

/// Writes the main result in a format: m̄ of the contact, in JSON with the impact and the extremes; otherwise the first of the damper of the stop,
/// the map, the safe speed and the contents.
fn show_in_format(study: &StudyFile, format: MassFormat, strict: bool) -> Result<(), Failure> {
    if let Some(list) = study.contact_list()? {
        return contact_list::write(&list, format, strict);
    }
    let mut printed = study.given_tables();
    match (&study.question, format) {
        // The damper of [damping] is part of the result of the contact.
        (Some(_), MassFormat::Json) => {
            printed.retain(|table| ["damping", "impact", "extremes"].contains(table))
        }
        (Some(_), _) => printed.retain(|table| *table == "damping"),
        (None, _) => printed.truncate(1),
    }
    note_left_out(study, format, &printed);
    let mass = with_findings(study.mass_report(), &study.model)?;
    let report = with_findings(study.results(None, mass, &printed), &study.model)?;
    let plain = if format == MassFormat::Json { CheckFormat::Json } else { CheckFormat::Text };
    match report {
        RequestReport { mass: Some(mass), impact, extremes, .. } => {
            let additions = StudyAdditions { impact, extremes };
            write_additional_findings(study, &additions, strict)?;
            mass::write(&mass, &study.mass, &additions, (format, strict), "")
        }
        RequestReport { map: Some(result), .. } => {
            let table = study.tables.map.as_ref().map(MapQuestion::table);
            let table = TableStyle::from_study(&table.unwrap_or_default());
            map::write(&result, &map::MapOutput { formats: Vec::new(), table, format, strict })
        }
        _ if format == MassFormat::Csv => Err(Failure::bad_input(
            "--format csv: only a contact and a map have a table; the study contains neither",
        )),
        RequestReport { damping: Some(report), .. } => {
            write_diagnostics(&report.diagnostics, strict)?;
            damp::print(&report, plain)
        }
        RequestReport { safe_speed: Some(reports), .. } => safe_speed::show(&reports, plain, strict),
        RequestReport { check: Some(report), .. } => check::write(&report, plain, strict),
        _ => {
            let only = printed.first().copied().unwrap_or_default();
            Err(Failure::bad_input(format!(
                "--format: only [{only}] is given, which has no such output; omit --format, or use percuss {only}"
            )))
        }
    }
}

/// Output options of the map of a study.
fn map_output(requested: &MapQuestion, format: MassFormat, strict: bool) -> Result<map::MapOutput, Failure> {
    let formats = map::formats(&requested.output)?;
    Ok(map::MapOutput { formats, table: TableStyle::from_study(&requested.table()), format, strict })
}

/// Refuses an output outside the study's folder, with symbolic links resolved.
fn check_inside_folder(path: &str, folder: &Path, name: &str) -> Result<(), Failure> {
    let whole = |path: &Path| {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        fs::canonicalize(path).ok()
    };
    let target = Path::new(path);
    // A file that does not exist yet has an existing folder.
    let parent = || whole(target.parent()?)?.join(target.file_name()?).into();
    let at: Option<PathBuf> = whole(target).or_else(parent);
    match (at, whole(folder)) {
        (Some(at), Some(folder)) if at.starts_with(&folder) => Ok(()),
        // The writer reports a missing folder.
        (None, _) => Ok(()),
        _ => Err(Failure::bad_input(format!(
            "{name}: {path} is outside the study's folder; --allow-outside permits this"
        ))),
    }
}
