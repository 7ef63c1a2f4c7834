//! Command `percuss run`.

use crate::args::{CheckFormat, MassFormat, RunArgs};
use crate::commands::check;
use crate::commands::compare::{self, ComparisonOutput};
use crate::commands::damp;
use crate::commands::exports::{convert, export, generate};
use crate::commands::impacts::rigid_impact::{self, ImpactView};
use crate::commands::impacts::{extremes, identify, restitution, safe_speed};
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
    Design, DiagnosticRecord, MapQuestion, MassOptions, MassQuestion, MassReport, Names, RowSource,
    StudyAdditions, StudyFile, SweepQuestion,
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
    check_distinct_outputs(outputs.iter().cloned())?;
    for (key, path) in outputs {
        match *key {
            "damping.output" => drop(ending_of(path, &TABLES_AND_PICTURES)?),
            "sweep.output" if !(study.variants.is_empty() && study.contacts.is_empty()) => {
                ending_of(path, &contents::ALL)?;
            }
            "kinematics.output" => drop(kinematics::file_ending(path)?),
            "map.output" => drop(map::formats(std::slice::from_ref(path))?),
            "convert.output" | "export.output" => check_writable(path)?,
            _ => {}
        }
    }
    if !args.allow_outside {
        outputs.iter().try_for_each(|(name, path)| check_inside_folder(path, &study.folder, name))?;
    }
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
    let poses = study.conditions.pose.iter().map(|pose| pose.input.path.clone());
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

/// Output of one table, after its computation.
type Print<'a> = Box<dyn FnOnce() -> Result<(), Failure> + 'a>;

/// Computes all tables of the study, then prints them in their order: an error of a table precedes the first result. The rows of a sweep
/// are computed while they are printed, after their check.
fn run_all(study: &StudyFile, args: &RunArgs) -> Result<(), Failure> {
    let strict = args.strict;
    let of_rows = study.question.as_ref().map(|question| study.question_of_rows(question));
    let designs = study.designs();
    let mut prints: Vec<Print> = Vec::new();
    let first = study.question.as_ref();
    if let (Some(question), Some(of_rows)) = (&study.question, &of_rows) {
        prints.push(contact_print(study, question, of_rows, &designs, strict)?);
    }
    if let Some(damping) = &study.tables.damping
        && (damping.limit.is_some() || damping.output.is_some())
        && let Some(report) = with_findings(study.damper(), &study.model)?
    {
        prints.push(Box::new(move || {
            if damping.limit.is_some() {
                write_diagnostics(&report.diagnostics, strict)?;
                damp::print(&report, CheckFormat::Text)?;
            }
            match &damping.output {
                Some(path) => damp::write_history(&report, path),
                None => Ok(()),
            }
        }));
    }
    if let Some(report) = with_findings(study.restitution_report(first), &study.model)? {
        prints.push(Box::new(move || restitution::show(&report, CheckFormat::Text, strict)));
    }
    if let Some(report) = with_findings(study.identification_report(first), &study.model)? {
        let output = study.tables.identify.as_ref().and_then(|asked| asked.output.as_deref());
        prints.push(Box::new(move || identify::show(&report, output, CheckFormat::Text, strict)));
    }
    if let Some(report) = with_findings(study.impact_report(first), &study.model)? {
        prints.push(Box::new(move || {
            write_diagnostics(&report.diagnostics, strict)?;
            rigid_impact::write(&report, CheckFormat::Text, ImpactView::default())
        }));
    }
    if let Some(report) = with_findings(study.extremes_report(first), &study.model)? {
        prints.push(Box::new(move || extremes::write(&report, CheckFormat::Text, strict)));
    }
    let of_kinematics = with_findings(study.kinematics_report(), &study.model)?;
    if let (Some(requested), Some(report)) = (&study.tables.kinematics, of_kinematics) {
        prints.push(Box::new(move || kinematics::show_of_study(&report, requested, strict)));
    }
    if let Some(requested) = &study.tables.map {
        let output = map_output(requested, MassFormat::Text, strict)?;
        output.formats.iter().try_for_each(|(path, _)| check_writable(path))?;
        let Some(result) = with_findings(study.map_result(), &study.model)? else { return Ok(()) };
        prints.push(Box::new(move || map::write(&result, &output)));
    }
    if let Some(reports) = with_findings(study.safe_speeds(), &study.model)? {
        prints.push(Box::new(move || safe_speed::show(&reports, CheckFormat::Text, strict)));
    }
    if let Some(report) = with_findings(study.check_report(), &study.model)? {
        prints.push(Box::new(move || check::write(&report, CheckFormat::Text, strict)));
    }
    let code = with_findings(study.generated_code(), &study.model)?;
    if let (Some(report), Some(requested)) = (code, &study.tables.generate) {
        let folder = requested.output.as_deref().unwrap_or_default();
        prints.push(Box::new(move || {
            generate::write_files(&report, folder)?;
            write_text(&generate::summary(&report, folder))
        }));
    }
    if let Some(mut report) = with_findings(study.conversion(), &study.model)? {
        prints.push(Box::new(move || {
            write_diagnostics(&report.diagnostics, strict)?;
            convert::write_files(&mut report)?;
            write_text(&convert::summary(&report))
        }));
    }
    if let Some(mut report) = with_findings(study.exported_impact(), &study.model)? {
        prints.push(Box::new(move || {
            write_diagnostics(&report.diagnostics, strict)?;
            export::write_files(&mut report)?;
            write_text(&export::summary(&report))
        }));
    }
    prints.into_iter().try_for_each(|print| print())
}

/// Output of the contact: with its variants, over the rows of a sweep, or at its pose. `of_rows`: question of the rows.
fn contact_print<'a>(
    study: &'a StudyFile,
    question: &'a MassQuestion,
    of_rows: &'a MassQuestion,
    designs: &'a [Design],
    strict: bool,
) -> Result<Print<'a>, Failure> {
    let of_pose = study.tables.damping.is_some() || study.mass != MassOptions::default();
    if !study.contacts.is_empty() {
        note_single_contact(study);
    }
    if of_pose && (study.tables.sweep.is_some() || !study.variants.is_empty()) {
        note(
            "[damping] and [mass] apply to the contact at its pose, not to rows and variants: --format text \
             shows them",
        );
    }
    let output = study.tables.sweep.as_ref().and_then(|sweep| sweep.output.as_deref());
    let table = study
        .tables
        .sweep
        .as_ref()
        .map_or_else(TableStyle::default, |sweep| TableStyle::from_study(&sweep.table()));
    if study.tables.sweep.is_none()
        && study.variants.is_empty()
        && let Some(list) = study.contact_list()?
    {
        return Ok(Box::new(move || contact_list::write(&list, MassFormat::Text, strict)));
    }
    if !study.variants.is_empty() || !study.contacts.is_empty() {
        let report = study.compare(designs).map_err(|error| compare::failure(&error, Names::KEYS))?;
        return Ok(Box::new(move || {
            let figure = study.tables.sweep.as_ref().map(SweepQuestion::figure).unwrap_or_default();
            let format = MassFormat::Text;
            let written = ComparisonOutput { output, table, figure: &figure, format, strict };
            compare::write(&report, designs, &written)
        }));
    }
    let Some(sweep) = &study.tables.sweep else {
        let report = with_findings(study.mass_report(), &study.model)?;
        return Ok(Box::new(move || {
            write_mass(study, report, &StudyAdditions::default(), MassFormat::Text, strict)
        }));
    };
    let left_out: Vec<String> = question
        .travel
        .iter()
        .filter(|travel| !of_rows.travel.contains(travel))
        .map(ToString::to_string)
        .collect();
    if !left_out.is_empty() {
        note(&format!(
            "[pose] travel = {} applies to the contact at its pose; the rows vary the travel themselves",
            left_out.join(", ")
        ));
    }
    let destination = SweepOutput { output, table, figure: sweep.figure(), strict };
    let prepared = study.prepared_sweep(sweep, of_rows);
    let ready = ReadySweep::new(&study.model, of_rows, &sweep.rows(), prepared, destination)?;
    Ok(Box::new(move || {
        ready.run()?;
        // Without a file the rows are on the standard output, which is one table.
        if output.is_some() { write_main_number(study, question) } else { Ok(()) }
    }))
}

/// Reports the tables whose results are omitted: an output with `--format` contains only the contact at its pose, and in JSON also the
/// impact and the extremes.
fn note_left_out(study: &StudyFile, format: MassFormat) {
    let is_json = format == MassFormat::Json;
    let tables = [
        ("[restitution]", study.tables.restitution.is_some()),
        ("[identify]", study.tables.identify.is_some()),
        ("[impact]", study.tables.impact.is_some() && !is_json),
        ("[extremes]", study.tables.extremes.is_some() && !is_json),
        ("[kinematics]", study.tables.kinematics.is_some()),
        ("[map]", study.tables.map.is_some()),
        ("[safe_speed]", study.tables.safe_speed.is_some()),
        ("[check]", study.tables.check.is_some()),
        ("[generate]", study.tables.generate.is_some()),
        ("[convert]", study.tables.convert.is_some()),
        ("[export]", study.tables.export.is_some()),
    ];
    let left_out: Vec<&str> =
        tables.into_iter().filter(|(_, is_given)| *is_given).map(|(name, _)| name).collect();
    if !left_out.is_empty() {
        note(&format!(
            "--format {} prints the contact at its pose, without {}; omit --format, or run the commands for these tables",
            format.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned()),
            left_out.join(", ")
        ));
    }
}

/// Reports the tables whose results are omitted for a study without a contact: an output with `--format` contains the first of them.
fn note_further_tables(study: &StudyFile) {
    let tables = [
        ("[damping]", study.tables.damping.is_some()),
        ("[map]", study.tables.map.is_some()),
        ("[safe_speed]", study.tables.safe_speed.is_some()),
        ("[kinematics]", study.tables.kinematics.is_some()),
        ("[check]", study.tables.check.is_some()),
        ("[convert]", study.tables.convert.is_some()),
        ("[export]", study.tables.export.is_some()),
    ];
    let given: Vec<&str> =
        tables.into_iter().filter(|(_, is_given)| *is_given).map(|(name, _)| name).collect();
    if let [first, others @ ..] = &given[..]
        && !others.is_empty()
    {
        note(&format!(
            "--format prints {first}, without {}; omit --format, or run the commands for these tables",
            others.join(", ")
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

/// Notes the tables that apply to the first of several contacts only.
fn note_single_contact(study: &StudyFile) {
    let tables = [
        ("[mass]", study.mass != MassOptions::default()),
        ("[restitution]", study.tables.restitution.is_some()),
        ("[identify]", study.tables.identify.is_some()),
        ("[impact]", study.tables.impact.is_some()),
        ("[extremes]", study.tables.extremes.is_some()),
        ("[safe_speed]", study.tables.safe_speed.is_some()),
    ];
    let single: Vec<&str> =
        tables.into_iter().filter(|(_, is_given)| *is_given).map(|(name, _)| name).collect();
    if let [first, ..] = &study.contacts[..]
        && !single.is_empty()
    {
        note(&format!("for the first contact ({}) only: {}", first.name, single.join(", ")));
    }
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

/// Writes the contact at the pose of the study.
fn write_mass(
    study: &StudyFile,
    report: Option<MassReport>,
    additions: &StudyAdditions,
    format: MassFormat,
    strict: bool,
) -> Result<(), Failure> {
    report.map_or(Ok(()), |report| mass::write(&report, &study.mass, additions, (format, strict), ""))
}

/// Writes the main result in a format: m̄ of the contact, otherwise the damper of the stop, the map or the safe speed.
fn show_in_format(study: &StudyFile, format: MassFormat, strict: bool) -> Result<(), Failure> {
    if let Some(list) = study.contact_list()? {
        return contact_list::write(&list, format, strict);
    }
    if study.question.is_some() {
        note_left_out(study, format);
        let additions = match format {
            MassFormat::Json => study.additions()?,
            MassFormat::Text | MassFormat::Csv => StudyAdditions::default(),
        };
        let report = with_findings(study.mass_report(), &study.model)?;
        write_additional_findings(study, &additions, strict)?;
        return write_mass(study, report, &additions, format, strict);
    }
    note_further_tables(study);
    let plain = match format {
        MassFormat::Text => Ok(CheckFormat::Text),
        MassFormat::Json => Ok(CheckFormat::Json),
        MassFormat::Csv => Err(Failure::bad_input(
            "--format csv: only a contact and a map have a table; the study contains neither",
        )),
    };
    if let Some(report) = study.damper()? {
        let plain = plain?;
        write_diagnostics(&report.diagnostics, strict)?;
        return damp::print(&report, plain);
    }
    if let (Some(requested), Some(result)) = (&study.tables.map, study.map_result()?) {
        let output = map::MapOutput { formats: Vec::new(), ..map_output(requested, format, strict)? };
        return map::write(&result, &output);
    }
    match (study.safe_speeds()?, study.check_report()?) {
        (Some(reports), _) => safe_speed::show(&reports, plain?, strict),
        (None, Some(report)) => check::write(&report, plain?, strict),
        (None, None) => {
            let only = if study.tables.kinematics.is_some() { "kinematics" } else { "convert" };
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
