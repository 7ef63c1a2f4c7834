//! The report of a study: one HTML page, with the answer as JSON and the sweep as CSV beside it.

use crate::args::{FigureArgs, RunArgs};
use crate::csv::SweepTable;
use crate::damp;
use crate::escape;
use crate::failure::Failure;
use crate::html::Page;
use crate::limits;
use crate::mass::{facts, headline};
use crate::output::{is_input, may_be_written, write_file};
use crate::report::{write_diagnostics, write_out};
use crate::sweep_figure::drawn;
use crate::table_style::TableStyle;
use crate::text::number;
use indicatif::ProgressBar;
use percuss_render::{Drawing, DrawnArrow, DrawnLine, SkinMark};
use percuss_study::{
    DiagnosticRecord, DrawnLink, MassReport, RowSource, StudyError, StudyFile, Sweep, SweepEnd,
    impact_history, mass_drawn,
};
use std::ops::ControlFlow;
use std::path::Path;

/// What a sweep came to: its table, its end, its picture where it has one.
struct Swept {
    csv: String,
    end: SweepEnd,
    svg: Result<String, String>,
    least: Option<f64>,
    greatest: Option<f64>,
}

/// Writes the report of a study.
pub fn write(study: &StudyFile, args: &RunArgs, path: &str) -> Result<(), Failure> {
    let beside = |ending: &str| Path::new(path).with_extension(ending).to_string_lossy().into_owned();
    let is_html = Path::new(path).extension().is_some_and(|e| e.eq_ignore_ascii_case("html"));
    if !is_html {
        return Err(Failure::bad_input(format!("--report {path}: its name must end in .html")));
    }
    study.model.inputs.iter().for_each(|input| is_input(&input.path));
    if let Some(RowSource::File(file)) = &study.sweep {
        is_input(&file.path);
    }
    // Before anything is computed.
    let mut files = vec![path.to_owned(), beside("json")];
    if study.sweep.is_some() {
        files.push(beside("csv"));
    }
    files.iter().try_for_each(|file| may_be_written(file))?;
    let (report, links) = mass_drawn(&study.model, &study.question, study.damping.as_ref())?;
    let swept = study.sweep.as_ref().map(|source| sweep(study, source)).transpose()?;
    let mut diagnostics = report.diagnostics.clone();
    for record in swept.iter().flat_map(|swept| &swept.end.diagnostics) {
        if !diagnostics.contains(record) {
            diagnostics.push(record.clone());
        }
    }
    write_diagnostics(&diagnostics, args.strict)?;
    let page = page(study, args, path, &report, &links, swept.as_ref(), &diagnostics)?;
    let json = serde_json::to_string_pretty(&report)
        .map_err(|error| Failure::NoAnswer(format!("the result has no JSON form: {error}")))?;
    write_file(&beside("json"), (json + "\n").as_bytes())?;
    if let Some(swept) = &swept {
        write_file(&beside("csv"), swept.csv.as_bytes())?;
    }
    write_file(path, page.as_bytes())?;
    write_out(&format!(
        "{:<20} {}\n{:<20} {}\n",
        "effective mass",
        headline(&report),
        "written",
        escape::line(&files.join(", "))
    ))
}

fn sweep(study: &StudyFile, source: &RowSource) -> Result<Swept, Failure> {
    let sweep = Sweep::new(&study.model, &study.question, source)?;
    let table = SweepTable::new(sweep.heading(), &study.model.mechanism, TableStyle::default());
    let mut csv = table.header().to_owned();
    let (mut least, mut greatest) = (None::<f64>, None::<f64>);
    let end = sweep.run(&mut |row| {
        csv += &table.row(&row);
        if let Some(m) = row.effective_mass {
            least = Some(least.map_or(m, |l| l.min(m)));
            greatest = Some(greatest.map_or(m, |g| g.max(m)));
        }
        ControlFlow::Continue(())
    })?;
    let again = Sweep::new(&study.model, &study.question, source)?;
    let svg = match drawn(again, &study.question, &FigureArgs::default(), &ProgressBar::hidden()) {
        Ok((figure, _)) => Ok(figure.to_svg()),
        // More than a picture shows; the table has it.
        Err(_) => Err("No picture: it shows one range, or a curve for each value of a first one.".to_owned()),
    };
    Ok(Swept { csv, end, svg, least, greatest })
}

fn page(
    study: &StudyFile,
    args: &RunArgs,
    path: &str,
    report: &MassReport,
    links: &[DrawnLink],
    swept: Option<&Swept>,
    diagnostics: &[DiagnosticRecord],
) -> Result<String, Failure> {
    let name = |path: &str| {
        Path::new(path).file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned())
    };
    let mut page = Page::new(&format!("Effective mass at {}", report.contact.link));
    page.paragraph("soft", &format!("Study {}, percuss {}", name(&args.study), report.percuss));
    page.paragraph("lead", &format!("m̄ = {}", headline(report)));
    page.facts(facts(report));
    page.heading("The mechanism at this pose");
    page.picture(&drawing(report, links).to_svg(), "The mechanism from the front and from the left");
    page.paragraph(
        "soft",
        "A line joins the joints, the loops' ends and the centre of mass of each link. Blue arrows are the velocities of the centres \
         of mass per unit closing speed, the longest as long as the normal n.",
    );
    if report.effective_mass.is_some() {
        page.heading("Contribution of each link");
        let links = report.bodies.iter().filter_map(|b| Some((b.link.clone(), b.share?)));
        let rotors = report.rotors.iter().filter_map(|r| Some((format!("rotor of {}", r.joint), r.share?)));
        let other = report.other_mass_share.map(|share| ("the other body".to_owned(), share));
        let mut parts: Vec<(String, f64)> = links.chain(rotors).chain(other).collect();
        parts.sort_by(|a, b| b.1.total_cmp(&a.1));
        let all = parts.len();
        parts.retain(|(_, share)| share.abs() >= limits::LEAST_CONTRIBUTION);
        page.parts("share of the kinetic energy", &parts);
        if parts.len() < all {
            let least = 100.0 * limits::LEAST_CONTRIBUTION;
            page.paragraph("soft", &format!("and {} of less than {least} %", all - parts.len()));
        }
    }
    if let Some(estimate) = &report.estimate {
        page.heading("The classical estimate");
        let value =
            |x: Option<f64>, unit: &str| x.map_or("–".to_owned(), |x| format!("{} {unit}", number(x)));
        page.facts([
            ("takes", format!("{} kg of {}", number(estimate.mass), estimate.links.join(", "))),
            ("motion ratio", value(estimate.motion_ratio, "(A over contact)")),
            ("estimate", value(estimate.estimate, "kg")),
            ("off by", value(estimate.error_percent, "%")),
        ]);
    }
    if let Some(swept) = swept {
        page.heading("The sweep");
        match &swept.svg {
            Ok(svg) => page.picture(svg, "Effective mass over what is varied"),
            Err(why) => page.paragraph("soft", why),
        }
        let mass = |m: Option<f64>| m.map_or("–".to_owned(), |m| format!("{} kg", number(m)));
        page.facts([
            ("rows", format!("{}, of which {} have no answer", swept.end.rows, swept.end.unanswered)),
            ("smallest", mass(swept.least)),
            ("largest", mass(swept.greatest)),
            ("all rows", name(&Path::new(path).with_extension("csv").to_string_lossy())),
        ]);
    }
    if !study.variants.is_empty() {
        let name =
            Path::new(&args.study).file_stem().map_or_else(String::new, |n| n.to_string_lossy().into());
        let compared = percuss_study::compare(&study.designs(&name))
            .map_err(|error| crate::compare::failure(&error, percuss_study::Names::Keys))?;
        page.heading("Variants");
        page.code(&crate::compare::text(&compared));
    }
    if let (Some(damper), Some(question)) = (&report.damper, &study.damping) {
        page.heading("The damper");
        page.facts(damp::facts(damper));
        if damper.damper.speed.is_some() {
            let samples = impact_history(question, damper.effective_mass, limits::HISTORY_SAMPLES)
                .map_err(StudyError::from)?;
            page.picture(&damp::sheet(damper, &samples).to_svg(), "Force over time and over penetration");
        }
        for (name, export) in &damper.exports {
            page.code(damp::exported(name, export).trim_start());
        }
    }
    page.heading("What it rests on");
    page.facts(
        report.inputs.iter().map(|input| ("SHA-256", format!("{}  {}", input.sha256, name(&input.path)))),
    );
    if diagnostics.is_empty() {
        page.paragraph("soft", "No diagnostics.");
    } else {
        let lines: Vec<String> = diagnostics.iter().map(|d| escape::line(&d.line()).into_owned()).collect();
        page.code(&lines.join("\n"));
    }
    page.paragraph("", "The same again, in the study's folder:");
    page.code(&format!("percuss run {} --report {}", name(&args.study), name(path)));
    page.paragraph(
        "soft",
        "Not included: friction, compliance of the links, several impacts at once. Gravity, springs, dampers and speed do not \
         enter: a finite force does no work in an instantaneous impact.",
    );
    Ok(page.finish())
}

/// The mechanism, the contact, its normal, and how the centres of mass move.
fn drawing(report: &MassReport, links: &[DrawnLink]) -> Drawing {
    let contact = &report.contact;
    let lines = links.iter().flat_map(|link| {
        link.lines.iter().map(|ends| DrawnLine { ends: *ends, part: Some(link.share.unwrap_or(0.0)) })
    });
    let moving = links.iter().filter_map(|link| {
        Some(DrawnArrow { from: link.com?, vector: link.velocity?, label: String::new() })
    });
    let normal = DrawnArrow { from: contact.point_world, vector: contact.normal_world, label: "n".into() };
    Drawing {
        shading: "contribution to the effective mass".into(),
        lines: lines.collect(),
        arrows: moving.chain([normal]).collect(),
        marks: vec![SkinMark { at: contact.point_world, label: String::new() }],
        ..Drawing::default()
    }
}
