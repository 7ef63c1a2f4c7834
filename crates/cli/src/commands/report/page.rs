//! Text of the report: head, result, sections.

use super::findings::add_warnings;
use super::results::StudyResults;
use super::{answers, contact, first_page, mechanism};
use crate::args::RunArgs;
use crate::commands::impacts::in_time::forces_sentence;
use crate::commands::impacts::{extremes, identify, response, restitution, rigid_impact, safe_speed};
use crate::commands::suspension::kinematics;
use crate::commands::{damp, map, mass};
use crate::files::html::{Head, Page};
use crate::terminal::failure::Failure;
use crate::terminal::text::shell_quoted;
use percuss_mechanism::Severity;
use percuss_study::{DiagnosticRecord, Input, MapResult, StudyFile};
use std::path::Path;

/// Text of the page of a study; `path` is the page's file.
pub(super) fn text(
    results: &StudyResults,
    study: &StudyFile,
    args: &RunArgs,
    path: &str,
    inputs: &[Input],
) -> Result<String, Failure> {
    let mut page = Page::new(&head(results, study, args));
    if let Some(listed) = &results.report.contacts {
        contact::add_contact_list(listed, &mut page);
    }
    if let Some(report) = &results.report.mass {
        first_page::add(results, report, &mut page);
        contact::add_findings(report, &results.unlisted(report), &mut page);
        first_page::add_quadrants(results, report, &foot(results, args, path, inputs), &mut page);
    }
    mechanism::add_mechanism(results, &mut page);
    if let Some(explorer) = &args.explorer {
        page.link("Move the mechanism and change the design in the explorer.", &relative(explorer, path));
    }
    if let Some(report) = &results.report.mass {
        mass::document(report).show(&mut page);
        page.facts(contact::accuracy(report, &study.mass));
    }
    if let Some(contents) = &results.report.check {
        mechanism::add_model(contents, &mut page);
    }
    if let Some(sweep) = &results.sweep {
        let table = file_name(&Path::new(path).with_extension("csv").to_string_lossy());
        let first = study.contacts.first().filter(|_| results.has_several_contacts());
        sweep.add_to(&mut page, &table, first.map(|contact| contact.name.as_str()));
    }
    if let Some(compared) = &results.report.comparison {
        answers::add_variants(compared, &results.tolerances, study, &mut page);
    }
    if let Some(report) = &results.report.kinematics {
        answers::add_kinematics(report, study, &mut page);
    }
    if let Some(report) = &results.report.targets {
        page.section("Targets");
        if !report.is_reached {
            page.warning("the required values are not reached; the nearest values found follow");
        }
        page.table(&kinematics::search_table(report).rows());
        add_warnings(&report.diagnostics, &mut page);
    }
    let damper = results
        .report
        .mass
        .as_ref()
        .and_then(|report| report.damper.as_ref())
        .or(results.report.damping.as_ref());
    if let Some(damper) = damper.filter(|_| study.tables.damping.is_some()) {
        page.section("The damper");
        damp::document(damper)?.show(&mut page);
        add_warnings(&damper.diagnostics, &mut page);
    }
    if let Some(report) = &results.report.restitution {
        page.section("Restitution");
        restitution::document(report).show(&mut page);
        add_warnings(&report.diagnostics, &mut page);
    }
    if let Some(report) = &results.report.identify {
        page.section("Measured impacts");
        identify::document(report).show(&mut page);
        add_warnings(&report.diagnostics, &mut page);
    }
    if let Some(report) = &results.report.response {
        page.section("Response over frequency");
        response::document(report).show(&mut page);
        add_warnings(&report.diagnostics, &mut page);
    }
    if let Some(report) = &results.report.impact {
        page.section("Impact");
        rigid_impact::document(report, &results.mechanism).show(&mut page);
        add_warnings(&report.diagnostics, &mut page);
    }
    if let Some(report) = &results.report.extremes {
        page.section("Extremes");
        extremes::document(report).show(&mut page);
        add_warnings(&report.diagnostics, &mut page);
    }
    if let Some(mapped) = &results.report.map {
        page.section(map::title(mapped));
        map::document(mapped).show(&mut page);
        add_warnings(mapped.diagnostics(), &mut page);
        if let MapResult::Surfaces(answer) = mapped {
            answer.report.left_out.iter().for_each(|left| page.note(&format!("left out: {}", left.reason)));
        }
    }
    if let Some(reports) = &results.report.safe_speed {
        page.section("Safe speed");
        safe_speed::document(reports).show(&mut page);
        add_warnings(&safe_speed::slowest(reports).diagnostics, &mut page);
    }
    add_basis(results, args, path, inputs, &mut page);
    Ok(page.finish())
}

/// Title, object, author and date of a study, and the file.
fn head(results: &StudyResults, study: &StudyFile, args: &RunArgs) -> Head {
    let given = &study.tables.report;
    let default = || match &results.report.mass {
        Some(_) if results.report.contacts.is_some() => {
            format!("Effective mass at {} contacts of {}", study.contacts.len(), study.model.mechanism.name())
        }
        Some(report) => match &report.named_contact {
            Some(contact) => format!("Effective mass at {}", contact.name),
            None => format!("Effective mass at {}", report.contact.link),
        },
        None => format!("Model {}", study.model.mechanism.name()),
    };
    let is_given = |text: &&String| !text.trim().is_empty();
    let by: Vec<&str> =
        [&given.author, &given.date].into_iter().flatten().filter(is_given).map(String::as_str).collect();
    Head {
        title: given.title.as_ref().filter(is_given).cloned().unwrap_or_else(default),
        lines: vec![
            given.object.clone().unwrap_or_default(),
            by.join(", "),
            format!("Study {}, percuss {}", file_name(&args.study), env!("CARGO_PKG_VERSION")),
        ],
    }
}

/// Command that makes the report again, in the folder of the study.
fn command(args: &RunArgs, path: &str) -> String {
    format!(
        "percuss run {} --report {}{}{}",
        shell_quoted(&file_name(&args.study)),
        shell_quoted(&file_name(path)),
        if args.allow_outside { " --allow-outside" } else { "" },
        args.explorer.as_ref().map_or_else(String::new, |explorer| format!(
            " --explorer {}",
            shell_quoted(&relative(explorer, path))
        ))
    )
}

/// Foot of the first page: validity, and the inputs with the first digits of their hashes.
fn foot(results: &StudyResults, args: &RunArgs, path: &str, inputs: &[Input]) -> Vec<(&'static str, String)> {
    let short =
        |input: &Input| format!("{} {}", file_name(&input.path), &input.sha256[..input.sha256.len().min(8)]);
    let files: Vec<String> = inputs.iter().map(short).collect();
    vec![
        ("Holds for", validity(results)),
        ("Made by", format!("{}; inputs {}", command(args, path), files.join(", "))),
    ]
}

/// Assumptions of the results.
fn validity(results: &StudyResults) -> String {
    let impact = results.report.impact.as_ref();
    let friction = if impact.is_some_and(|impact| impact.friction.is_some()) { "" } else { "no friction, " };
    let is_several = impact.is_some_and(|impact| impact.simultaneous.is_some());
    let several = if is_several { "" } else { ", one contact at a time" };
    let in_time = impact.and_then(|impact| Some((impact, impact.in_time.as_ref()?)));
    let in_time = in_time.map_or_else(String::new, |(_, found)| format!(" {}", forces_sentence(found)));
    format!(
        "{friction}rigid links{several}. Gravity, springs and dampers have no effect: a finite force does no work in an instantaneous \
         impact. The effective mass does not depend on the speed.{in_time}"
    )
}

/// Section of the inputs, with the findings about them, the command, and the limits of validity.
fn add_basis(results: &StudyResults, args: &RunArgs, path: &str, inputs: &[Input], page: &mut Page) {
    page.section("Inputs and validity");
    page.hashes(inputs.iter().map(|input| (file_name(&input.path), format!("SHA-256 {}", input.sha256))));
    let diagnostics = results.diagnostics();
    // Warnings about results are beside their number.
    let of_variants = results.report.comparison.iter().flat_map(|compared| &compared.diagnostics);
    let of_variants: Vec<&DiagnosticRecord> =
        of_variants.filter(|d| d.path.is_none() && d.severity == Severity::Note).collect();
    let is_listed =
        |d: &&DiagnosticRecord| d.path.is_some() || d.severity == Severity::Note && !of_variants.contains(d);
    let listed: Vec<&DiagnosticRecord> = diagnostics.iter().filter(is_listed).collect();
    if !listed.is_empty() {
        page.heading("Notes, and findings about the files");
        let mut rows = vec![["kind", "place", "finding"].map(str::to_owned)];
        rows.extend(listed.into_iter().map(|finding| {
            let file = finding.path.as_deref().map_or_else(|| "result".to_owned(), file_name);
            let line = finding.line.map_or_else(String::new, |line| format!(":{line}"));
            let element = finding.element.as_ref().map_or_else(String::new, |element| format!("{element}: "));
            [finding.severity.name().to_owned(), file + &line, element + &finding.message]
        }));
        page.table(&rows);
    }
    if !of_variants.is_empty() {
        page.paragraph("soft", &format!("{} notes about the variants are not shown.", of_variants.len()));
    }
    if diagnostics.is_empty() {
        page.paragraph("soft", "No warnings and no notes.");
    }
    page.heading("Command");
    page.paragraph("soft", "In the folder of the study, this command makes the report again:");
    page.code(&command(args, path));
    page.heading("Validity");
    page.paragraph("", &validity(results));
}

/// File name without its folder.
fn file_name(path: &str) -> String {
    Path::new(path).file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned())
}

/// Path of a file from the folder of another file; as given if the folders have nothing in common.
fn relative(file: &str, from: &str) -> String {
    let folder = Path::new(from).parent().unwrap_or(Path::new(""));
    match Path::new(file).strip_prefix(folder) {
        Ok(inside) => inside.to_string_lossy().into_owned(),
        Err(_) => std::path::absolute(file).unwrap_or_else(|_| file.into()).to_string_lossy().into_owned(),
    }
}
