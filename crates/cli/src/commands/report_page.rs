//! Report of a study: one HTML page, accompanied by the result as JSON and the sweep as CSV. The report of a study
//! without a contact shows the mechanism, its contents, and the other questions of the study.

use crate::args::RunArgs;
use crate::commands::check;
use crate::commands::compare;
use crate::commands::damp;
use crate::commands::map;
use crate::commands::mass::{MassRequests, facts, headline};
use crate::commands::safe_speed;
use crate::files::csv::SweepTable;
use crate::files::html::Page;
use crate::files::output::{check_writable, record_input, write_file};
use crate::files::table_style::TableStyle;
use crate::pictures::map_files;
use crate::pictures::sweep_figure::sweep_figure;
use crate::terminal::escape;
use crate::terminal::explanation;
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::report::{write_diagnostics, write_out};
use crate::terminal::text::{number, shell_quoted, short_number};
use indicatif::ProgressBar;
use percuss_render::{Drawing, DrawnArrow, DrawnCircle, DrawnFacet, DrawnLine, SkinMark};
use percuss_study::{
    CheckReport, ComparisonReport, DampingQuestion, DampingReport, DiagnosticRecord, DrawnMechanism, Input,
    MapAnswer, MassReport, Names, PointMapReport, RowSource, SafeSpeedReport, StudyError, StudyFile,
    StudyMapQuestion, StudySweep, Sweep, SweepEnd, check as check_of, draw_mechanism, impact_history,
    map as map_of, map_point, mass_with_drawing,
};
use std::ops::ControlFlow;
use std::path::Path;

/// Result of a sweep: table, end, and picture if possible.
struct SweepSection {
    csv: String,
    end: SweepEnd,
    inputs: Vec<Input>,
    svg: Result<String, String>,
    least: Option<f64>,
    greatest: Option<f64>,
}

/// Result of a map.
enum MapResult {
    Surfaces(Box<MapAnswer>),
    Directions(Box<PointMapReport>),
}

/// Results of all questions of a study.
struct StudyResults {
    mass: Option<MassReport>,
    mechanism: DrawnMechanism,
    /// Contents of the model; only for a study without a contact.
    contents: Option<CheckReport>,
    /// Damper of a joint stop.
    stop: Option<DampingReport>,
    sweep_section: Option<SweepSection>,
    compared: Option<ComparisonReport>,
    mapped: Option<MapResult>,
    speeds: Option<Vec<SafeSpeedReport>>,
}

/// Writes the report of a study.
pub fn write(study: &StudyFile, args: &RunArgs, path: &str) -> Result<(), Failure> {
    let accompanying_file =
        |ending: &str| Path::new(path).with_extension(ending).to_string_lossy().into_owned();
    let is_html = Path::new(path).extension().is_some_and(|e| e.eq_ignore_ascii_case("html"));
    if !is_html {
        return Err(Failure::bad_input(format!("--report {path}: its name must end in .html")));
    }
    study.variants.iter().flat_map(|v| &v.model.inputs).for_each(|input| record_input(&input.path));
    if let Some(StudySweep { rows: RowSource::File(file), .. }) = &study.sweep {
        record_input(&file.path);
    }
    // The checks precede the computation.
    let mut files = vec![path.to_owned(), accompanying_file("json")];
    if study.sweep.is_some() {
        files.push(accompanying_file("csv"));
    }
    files.iter().try_for_each(|file| check_writable(file))?;
    let answers = StudyResults::from_study(study, args)?;
    let inputs = answers.inputs();
    inputs.iter().for_each(|input| record_input(&input.path));
    let diagnostics = answers.diagnostics();
    write_diagnostics(&diagnostics, args.strict)?;
    let page = answers.page(study, args, path, &inputs, &diagnostics)?;
    let json = answers.json()?;
    write_file(&accompanying_file("json"), json.as_bytes())?;
    if let Some(sweep_section) = &answers.sweep_section {
        write_file(&accompanying_file("csv"), sweep_section.csv.as_bytes())?;
    }
    write_file(path, page.as_bytes())?;
    let headline = answers.mass.as_ref().map(|mass| format!("{:<20} {}\n", "effective mass", headline(mass)));
    let written = format!("{:<20} {}\n", "written", escape::line(&files.join(", ")));
    write_out(&(headline.unwrap_or_default() + &written))?;
    answers.mass.map_or(Ok(()), |mass| MassRequests::from_study(&study.mass).check_expected(&mass))
}

/// Runs the sweep of a study: its table, its end, and its picture.
fn run_sweep(study: &StudyFile, requested: &StudySweep) -> Result<SweepSection, Failure> {
    let question = &study.question_of_rows(study.question.as_ref().unwrap_or(&study.conditions));
    let sweep = Sweep::new(&study.model, question, &requested.rows)?;
    let table =
        SweepTable::new(sweep.heading(), &study.model.mechanism, TableStyle::from_study(&requested.table));
    let inputs = sweep.heading().inputs.clone();
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
    let again = Sweep::new(&study.model, question, &requested.rows)?;
    let svg = match sweep_figure(again, question, &requested.figure, &ProgressBar::hidden()) {
        Ok((figure, _)) => Ok(figure.to_svg()),
        // The picture cannot show this sweep; the table contains it.
        Err(_) => {
            Err("No picture: a picture shows one range, or one curve for each value of the first of two \
            ranges."
                .to_owned())
        }
    };
    Ok(SweepSection { csv, end, inputs, svg, least, greatest })
}

/// File name without its folder.
fn file_name(path: &str) -> String {
    Path::new(path).file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned())
}

impl StudyResults {
    /// Computes the results of all questions of a study.
    fn from_study(study: &StudyFile, args: &RunArgs) -> Result<Self, Failure> {
        let damping = study.damping.as_ref();
        let (mass, mechanism, contents) = match &study.question {
            Some(question) => {
                let damping = damping.map(|damping| &damping.question);
                let (mut mass, mechanism) = mass_with_drawing(&study.model, question, damping)?;
                MassRequests::from_study(&study.mass).add_to(&mut mass, &study.model, question)?;
                (Some(mass), mechanism, None)
            }
            None => (None, draw_mechanism(&study.model, &study.conditions)?, Some(check_of(&study.model)?)),
        };
        let stop = damping.filter(|damping| damping.stop.is_some());
        let stop = stop.map(|damping| damp::study_report(study, damping)).transpose()?;
        let compared = if study.variants.is_empty() {
            None
        } else {
            let compared = percuss_study::compare(&study.designs(&compare::study_name(&args.study)));
            Some(compared.map_err(|error| compare::failure(&error, Names::Keys))?)
        };
        let mapped = match study.map.as_ref().map(|map| &map.question) {
            None => None,
            Some(StudyMapQuestion::Surfaces(requested)) => {
                Some(MapResult::Surfaces(Box::new(map_of(&study.model, requested)?)))
            }
            Some(StudyMapQuestion::Directions(requested, count)) => {
                Some(MapResult::Directions(Box::new(map_point(&study.model, requested, *count)?)))
            }
        };
        let speeds =
            study.safe_speed.as_ref().map(|requested| requested.reports(&study.model)).transpose()?;
        let sweep_section = study.sweep.as_ref().map(|requested| run_sweep(study, requested)).transpose()?;
        Ok(Self { mass, mechanism, contents, stop, sweep_section, compared, mapped, speeds })
    }

    /// Input files of all results, without duplicates.
    fn inputs(&self) -> Vec<Input> {
        let sweep_section = self.sweep_section.iter().flat_map(|sweep_section| &sweep_section.inputs);
        let compared = self.compared.iter().flat_map(|c| c.designs.iter().flat_map(|design| &design.inputs));
        let mapped = self.mapped.iter().flat_map(|mapped| match mapped {
            MapResult::Surfaces(answer) => &answer.report.inputs,
            MapResult::Directions(report) => &report.inputs,
        });
        let speeds = self.speeds.iter().flatten().flat_map(|report| &report.inputs);
        let own = self.mass.iter().flat_map(|mass| &mass.inputs);
        let own = own.chain(self.contents.iter().flat_map(|contents| &contents.inputs));
        let own = own.chain(self.stop.iter().flat_map(|stop| &stop.inputs));
        let all = own.chain(&self.mechanism.meshes).chain(sweep_section).chain(compared);
        let mut each: Vec<Input> = Vec::new();
        for input in all.chain(mapped).chain(speeds) {
            if !each.contains(input) {
                each.push(input.clone());
            }
        }
        each
    }

    /// Diagnostics of all results, without duplicates.
    fn diagnostics(&self) -> Vec<DiagnosticRecord> {
        let sweep_section =
            self.sweep_section.iter().flat_map(|sweep_section| &sweep_section.end.diagnostics);
        let compared = self.compared.iter().flat_map(|compared| &compared.diagnostics);
        let mapped = self.mapped.iter().flat_map(|mapped| match mapped {
            MapResult::Surfaces(answer) => &answer.report.diagnostics,
            MapResult::Directions(report) => &report.diagnostics,
        });
        let speeds = self.speeds.iter().flatten().flat_map(|report| &report.diagnostics);
        let own = self.mass.iter().flat_map(|mass| &mass.diagnostics);
        let own = own.chain(self.contents.iter().flat_map(|contents| &contents.diagnostics));
        let own = own.chain(self.stop.iter().flat_map(|stop| &stop.diagnostics));
        let all = own.chain(&self.mechanism.diagnostics).chain(sweep_section);
        let mut each: Vec<DiagnosticRecord> = Vec::new();
        for record in all.chain(compared).chain(mapped).chain(speeds) {
            if !each.contains(record) {
                each.push(record.clone());
            }
        }
        each
    }

    /// Text of the HTML page.
    fn page(
        &self,
        study: &StudyFile,
        args: &RunArgs,
        path: &str,
        inputs: &[Input],
        diagnostics: &[DiagnosticRecord],
    ) -> Result<String, Failure> {
        let mut page = Page::new(&match &self.mass {
            Some(report) => format!("Effective mass at {}", report.contact.link),
            None => format!("Model {}", study.model.mechanism.name()),
        });
        let version = env!("CARGO_PKG_VERSION");
        page.paragraph("soft", &format!("Study {}, percuss {version}", file_name(&args.study)));
        if let Some(report) = &self.mass {
            self.add_contact(report, &mut page);
        }
        if let Some(contents) = &self.contents {
            self.add_model(contents, &mut page);
        }
        if let Some(sweep_section) = &self.sweep_section {
            sweep_section.on(&mut page, &file_name(&Path::new(path).with_extension("csv").to_string_lossy()));
        }
        if let Some(compared) = &self.compared {
            page.heading("Variants");
            page.table(compare::design_table(compared).rows());
            for design in &compared.designs {
                if let Some(error) = &design.error {
                    page.paragraph("soft", &format!("{}: {error}", design.name));
                }
            }
            // A comparison without a figure is covered by the sweep's table.
            let figure = study.sweep.as_ref().map(|sweep| sweep.figure.clone()).unwrap_or_default();
            if let Ok(figure) = compare::figure(compared, &figure) {
                page.picture(&figure.to_svg(), "Effective mass of the variants over the varied quantity");
            }
        }
        let damper = self.mass.as_ref().and_then(|report| report.damper.as_ref()).or(self.stop.as_ref());
        if let (Some(damper), Some(damping)) = (damper, &study.damping) {
            add_damping(damper, &damping.question, &mut page)?;
        }
        match &self.mapped {
            None => {}
            Some(MapResult::Surfaces(answer)) => {
                page.heading("Over the surface");
                page.picture(&map_files::skin(answer).to_svg(), "Effective mass over the surface");
                page.table(map::links(&answer.report).rows());
                page.paragraph("soft", &map::LINKS_EXPLANATION.replace('\n', " "));
                for left in &answer.report.left_out {
                    page.paragraph("soft", &format!("left out: {}", left.reason));
                }
            }
            Some(MapResult::Directions(directions)) => {
                page.heading("In all directions at a point");
                page.code(&map::point_text(directions));
            }
        }
        if let Some(reports) = &self.speeds {
            page.heading("Safe speed");
            page.facts(safe_speed::facts(safe_speed::slowest(reports)));
            let others = safe_speed::directions(reports);
            if !others.is_empty() {
                page.code(others.trim());
            }
            page.paragraph("soft", &safe_speed::DISCLAIMER.trim().replace('\n', " "));
        }
        page.heading("What it rests on");
        let names: Vec<String> = inputs.iter().map(|input| file_name(&input.path)).collect();
        let hashes = inputs.iter().map(|input| format!("SHA-256 {}", input.sha256));
        page.facts(names.iter().map(String::as_str).zip(hashes));
        if diagnostics.is_empty() {
            page.paragraph("soft", "No diagnostics.");
        } else {
            let lines: Vec<String> =
                diagnostics.iter().map(|d| escape::line(&d.line()).into_owned()).collect();
            page.code(&lines.join("\n"));
        }
        page.paragraph("", "To repeat this run, in the study's folder:");
        page.code(&format!(
            "percuss run {} --report {}",
            shell_quoted(&file_name(&args.study)),
            shell_quoted(&file_name(path))
        ));
        page.paragraph(
            "soft",
            "Not included: friction, compliance of the links, several impacts at once. Gravity, springs, \
             dampers and speed have no effect: a finite force does no work in an instantaneous impact.",
        );
        Ok(page.finish())
    }

    /// Section of a contact: result, mechanism, sensitivities.
    fn add_contact(&self, report: &MassReport, page: &mut Page) {
        page.paragraph("lead", &format!("m̄ = {}", headline(report)));
        page.facts(facts(report));
        page.heading("The mechanism at this pose");
        page.picture(
            &drawing(Some(report), &self.mechanism).to_svg(),
            "The mechanism from the front and from the left",
        );
        page.paragraph(
            "soft",
            &format!(
                "{DRAWING_LEGEND} The dot is the contact point. Blue arrows are the velocities v* of the centres of mass per unit \
                 closing speed, the longest as long as the normal n."
            ),
        );
        add_contributions(report, page);
        add_estimate(report, page);
        if let Some(explained) = &report.explanation {
            page.heading("What it depends on");
            page.code(explanation::explanation(explained).trim_start());
        }
        if let Some(tolerances) = &report.tolerance {
            page.heading("Tolerances");
            page.code(explanation::tolerances(tolerances).trim_start());
        }
    }

    /// Section of a model without a contact: mechanism, contents, possible questions.
    fn add_model(&self, contents: &CheckReport, page: &mut Page) {
        page.facts(check::facts(contents));
        page.heading("The mechanism at this pose");
        page.picture(
            &drawing(None, &self.mechanism).to_svg(),
            "The mechanism from the front and from the left",
        );
        page.paragraph("soft", DRAWING_LEGEND);
        let tables = check::tables(contents);
        page.heading("Links");
        page.table(tables.links.rows());
        if !contents.joints.is_empty() {
            page.heading("Joints");
            page.table(tables.joints.rows());
        }
        if !contents.closures.is_empty() {
            page.heading("Loops");
            page.table(tables.loops.rows());
        }
        page.heading("Possible contacts");
        page.paragraph(
            "",
            "The study has no [contact] with a normal, so this page shows no effective mass. A contact is a \
             link, a point of it and a \
             normal (or a line towards a point of another link); this command writes a study with a contact of \
             this model that has a result, and with sweeps, variants and dampers as options:",
        );
        let model = contents.inputs.first().map_or_else(String::new, |input| file_name(&input.path));
        page.code(&format!("percuss init {} -o contact.toml", shell_quoted(&model)));
    }

    /// JSON of the accompanying file, as with --format json: the result of the contact, otherwise of the stop, map or
    /// safe speed.
    fn json(&self) -> Result<String, Failure> {
        let text = match (&self.mass, &self.stop, &self.mapped, &self.speeds) {
            (Some(mass), ..) => serde_json::to_string_pretty(mass),
            (None, Some(stop), ..) => serde_json::to_string_pretty(stop),
            (None, None, Some(MapResult::Surfaces(answer)), _) => {
                serde_json::to_string_pretty(&answer.report)
            }
            (None, None, Some(MapResult::Directions(report)), _) => serde_json::to_string_pretty(report),
            (None, None, None, Some(reports)) if reports.len() > 1 => serde_json::to_string_pretty(reports),
            (None, None, None, Some(reports)) => serde_json::to_string_pretty(safe_speed::slowest(reports)),
            // The parser of studies refuses a study without any question.
            (None, None, None, None) => serde_json::to_string_pretty(&self.contents),
        };
        let text = text.map_err(|error| Failure::NoAnswer(format!("the result has no JSON form: {error}")));
        text.map(|text| text + "\n")
    }
}

/// Legend of the picture.
const DRAWING_LEGEND: &str = "A line joins the joints, the loops' ends and the centre of mass of each link, over its \
    shapes if the model contains shapes; a wheel of an imported suspension is drawn as a circle.";

/// Section with the contribution of each link and rotor.
fn add_contributions(report: &MassReport, page: &mut Page) {
    if report.effective_mass.is_none() {
        return;
    }
    page.heading("Contribution of each link");
    let links = report.bodies.iter().filter_map(|b| Some((b.link.clone(), b.share?)));
    let rotors = report.rotors.iter().filter_map(|r| Some((format!("rotor of {}", r.joint), r.share?)));
    let other = report.other_mass_share.map(|share| ("the other body".to_owned(), share));
    let mut parts: Vec<(String, f64)> = links.chain(rotors).chain(other).collect();
    parts.sort_by(|a, b| b.1.total_cmp(&a.1));
    let all = parts.len();
    parts.retain(|(_, share)| share.abs() >= limits::MIN_CONTRIBUTION);
    page.table_of_shares("share of the kinetic energy", &parts);
    if parts.len() < all {
        let least = 100.0 * limits::MIN_CONTRIBUTION;
        page.paragraph("soft", &format!("and {} of less than {least} %", all - parts.len()));
    }
}

/// Section with the classical estimate.
fn add_estimate(report: &MassReport, page: &mut Page) {
    let Some(estimate) = &report.estimate else { return };
    page.heading("The classical estimate");
    let value = |x: Option<f64>, unit: &str| x.map_or("–".to_owned(), |x| format!("{} {unit}", number(x)));
    page.facts([
        ("takes", format!("{} kg of {}", number(estimate.mass), estimate.links.join(", "))),
        ("motion ratio", value(estimate.motion_ratio, "(A over contact)")),
        ("estimate", value(estimate.estimate, "kg")),
        ("off by", estimate.error_percent.map_or("–".to_owned(), |x| format!("{} %", short_number(x)))),
    ]);
}

impl SweepSection {
    /// Adds the section of the sweep; `table` is the name of the CSV file.
    fn on(&self, page: &mut Page, table: &str) {
        page.heading("The sweep");
        match &self.svg {
            Ok(svg) => page.picture(svg, "Effective mass over the varied quantity"),
            Err(why) => page.paragraph("soft", why),
        }
        let mass = |m: Option<f64>| m.map_or("–".to_owned(), |m| format!("{} kg", number(m)));
        page.facts([
            ("rows", format!("{}, {} without a result", self.end.rows, self.end.rows_without_result)),
            ("smallest", mass(self.least)),
            ("largest", mass(self.greatest)),
            ("all rows", table.to_owned()),
        ]);
    }
}

/// Section of a damper, with the history of the impact.
fn add_damping(damper: &DampingReport, question: &DampingQuestion, page: &mut Page) -> Result<(), Failure> {
    page.heading("The damper");
    if damper.stop.is_some() {
        page.facts([damp::headline(damper)]);
    }
    page.facts(damp::facts(damper));
    if damper.damper.speed.is_some() {
        let samples = impact_history(question, damper.effective_mass, limits::HISTORY_SAMPLES)
            .map_err(StudyError::from)?;
        page.picture(&damp::history_sheet(damper, &samples).to_svg(), "Force over time and over penetration");
    } else {
        page.paragraph("soft", "Without damping.speed there is no force to draw.");
    }
    for (name, export) in &damper.exports {
        page.code(damp::export_text(name, export).trim_start());
    }
    Ok(())
}

/// Drawing of the mechanism; with a contact, also the normal and the velocities of the centres of mass.
fn drawing(report: Option<&MassReport>, mechanism: &DrawnMechanism) -> Drawing {
    let links = &mechanism.links;
    let contact = report.map(|report| &report.contact);
    let lines = links.iter().flat_map(|link| {
        link.lines
            .iter()
            .map(|ends| DrawnLine { ends: *ends, intensity: report.map(|_| link.share.unwrap_or(0.0)) })
    });
    let facets = links.iter().flat_map(|link| {
        link.facets.iter().map(|corners| DrawnFacet { corners: *corners, intensity: link.share })
    });
    let moving = links.iter().filter_map(|link| {
        Some(DrawnArrow { from: link.com?, vector: link.velocity?, label: String::new() })
    });
    let circles = mechanism.wheels.iter().map(|wheel| DrawnCircle {
        centre: wheel.centre,
        axis: wheel.axis,
        radius: wheel.radius.unwrap_or_default(),
    });
    let normal = contact.map(|contact| DrawnArrow {
        from: contact.point_world,
        vector: contact.normal_world,
        label: "n".into(),
    });
    let mark = contact.map(|contact| SkinMark { at: contact.point_world, label: String::new() });
    Drawing {
        shading: report.map_or("", |_| "contribution to the effective mass").into(),
        circles: circles.collect(),
        facets: facets.collect(),
        lines: lines.collect(),
        arrows: moving.chain(normal).collect(),
        marks: mark.into_iter().collect(),
        ..Drawing::default()
    }
}
