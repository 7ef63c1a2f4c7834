//! Command `percuss map`.

use crate::args::{MapArgs, MassFormat};
use crate::commands::mass::conditions::base_text;
use crate::commands::sweep::use_threads;
use crate::document::Document;
use crate::files::output::{Output, check_writable, record_input};
use crate::files::table_style::TableStyle;
use crate::pictures::map_files::{self, MapFormat};
use crate::terminal::failure::Failure;
use crate::terminal::number::{number, triple, upper_bound};
use crate::terminal::report::{note, with_findings, write_diagnostics, write_json, write_out, write_text};
use crate::terminal::text::Table;
use percuss_render::Picture;
use percuss_study::{
    DirectionMass, Extreme, LinkMap, MapAnswer, MapReport, MapResult, PointMapReport, requested_map,
};

/// Runs the command.
pub fn run(args: &MapArgs) -> Result<(), Failure> {
    let (contact, question) = args.questions()?;
    let (formats, strict) = (formats(&question.output)?, args.model.reading.strict);
    use_threads(args.threads);
    args.writing.apply();
    let model = args.model.load()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    // The check precedes the computation.
    formats.iter().try_for_each(|(path, _)| check_writable(path))?;
    let table = TableStyle::from_study(&question.table());
    let result = with_findings(requested_map(&model, &contact, &question), &model)?;
    write(&result, &MapOutput { formats, table, format: args.format, strict })
}

/// Output options of a map.
pub struct MapOutput {
    pub formats: Vec<(String, MapFormat)>,
    pub table: TableStyle,
    pub format: MassFormat,
    pub strict: bool,
}

/// Output files with their formats, determined by the file extensions.
pub fn formats(outputs: &[String]) -> Result<Vec<(String, MapFormat)>, Failure> {
    outputs.iter().map(|path| Ok((path.clone(), MapFormat::from_path(path)?))).collect()
}

/// Writes a map with its findings and its files.
pub fn write(result: &MapResult, output: &MapOutput) -> Result<(), Failure> {
    // The mesh files are known only after the computation.
    result.inputs().iter().for_each(|input| record_input(&input.path));
    write_diagnostics(result.diagnostics(), output.strict)?;
    if let MapResult::Surfaces(answer) = result {
        answer.report.left_out.iter().for_each(|left| note(&format!("left out: {}", left.reason)));
    }
    write_files(result, &output.formats, output.table)?;
    match (output.format, result) {
        (MassFormat::Text, _) => write_text(&document(result).text()),
        (MassFormat::Json, _) => write_json(result),
        (MassFormat::Csv, MapResult::Surfaces(answer)) => {
            let mut out = Output::open(None)?;
            map_files::csv(answer, output.table, &mut out).map_err(|error| out.failure(error))?;
            out.finish()
        }
        (MassFormat::Csv, MapResult::Directions(report)) => {
            let mut bytes = Vec::new();
            map_files::point_csv(report, output.table, &mut bytes)?;
            write_out(&String::from_utf8_lossy(&bytes))
        }
    }
}

/// Writes the files of a map, without text and findings.
pub fn write_files(
    result: &MapResult,
    formats: &[(String, MapFormat)],
    table: TableStyle,
) -> Result<(), Failure> {
    for (path, format) in formats {
        let mut out = Output::open(Some(path))?;
        let written = match result {
            MapResult::Surfaces(answer) => map_files::write(answer, *format, table, &mut out),
            MapResult::Directions(report) => map_files::write_point(report, *format, table, &mut out),
        };
        written.map_err(|error| error.failure(path, &out))?;
        out.finish()?;
    }
    Ok(())
}

/// Table of links, one row each.
fn links(report: &MapReport) -> Table {
    let mut table = Table::new([
        "link",
        "contacts",
        "smallest kg",
        "largest kg",
        "mean kg",
        "other",
        "smallest at (m)",
        "largest at (m)",
    ]);
    for link in &report.links {
        let mass = |e: &Option<Extreme>| e.as_ref().map_or_else(|| "–".into(), |e| number(e.effective_mass));
        let point_of =
            |e: &Option<Extreme>| e.as_ref().map_or_else(String::new, |e| round_point(&e.point_link));
        table.row([
            link.link.clone(),
            link.contacts.to_string(),
            mass(&link.smallest),
            mass(&link.largest),
            link.area_mean.map_or_else(|| "–".into(), number),
            counts_without_finite_mass(link),
            point_of(&link.smallest),
            point_of(&link.largest),
        ]);
    }
    table
}

/// Title of the section of a map.
pub fn title(result: &MapResult) -> &'static str {
    match result {
        MapResult::Surfaces(_) => "Over the surface",
        MapResult::Directions(_) => "In all directions at a point",
    }
}

/// Map with its picture, table and conditions.
pub fn document(result: &MapResult) -> Document<'_> {
    match result {
        MapResult::Surfaces(answer) => surfaces_document(answer),
        MapResult::Directions(report) => directions_document(report),
    }
}

/// Map of surfaces.
fn surfaces_document(answer: &MapAnswer) -> Document<'_> {
    let report = &answer.report;
    let mut out = Document::default();
    out.picture(|| map_files::skin(answer).to_svg(), "Effective mass over the surface", "");
    out.table(links(report));
    out.paragraph(
        "One contact in each facet, along its outward normal; points in the link frame.\n\
         The mean is the reciprocal of the area mean of 1/m.",
    );
    report.links.iter().filter_map(winding_changes).for_each(|text| out.note(text));
    let against = report.against.clone().unwrap_or_else(|| match report.conditions.against_mass {
        Some(mass) => format!("a free body of {} kg", number(mass)),
        None => "the ground".into(),
    });
    let worst = report.links.iter().filter_map(|l| l.worst_relative_error).reduce(f64::max);
    let worst = worst.map(|worst| ("relative errors", format!("below {}", upper_bound(worst))));
    out.facts([("against", against), ("base", base_text(&report.conditions))].into_iter().chain(worst));
    out.paragraph(
        "Not included: friction, compliance of the links, several impacts at once.\n\
         See docs/explanation/EFFECTIVE_MASS.md and docs/howto/MAPS.md.",
    );
    out
}

/// Number of contacts without a finite mass, by status.
fn counts_without_finite_mass(link: &LinkMap) -> String {
    let counts =
        [(link.immovable, "immovable"), (link.massless, "massless"), (link.unanswered, "without a result")];
    let some = counts.into_iter().filter(|(count, _)| *count > 0);
    some.map(|(count, what)| format!("{count} {what}")).collect::<Vec<_>>().join(", ")
}

/// Changes made to the orientation of the mesh of a link, if any.
fn winding_changes(link: &LinkMap) -> Option<String> {
    let o = link.orientation.as_ref().filter(|o| o.turned + o.open + o.conflicting > 0)?;
    let mut done = Vec::new();
    if o.turned > 0 {
        done.push(format!("{} triangles were reversed", o.turned));
    }
    if o.open > 0 {
        done.push(format!(
            "{} of {} pieces are open; their normals point away from the centre of the mesh",
            o.open, o.pieces
        ));
    }
    if o.conflicting > 0 {
        done.push(format!("{} pieces cannot be oriented consistently", o.conflicting));
    }
    Some(format!("{}: {}; the sign of a normal does not change the mass.", link.link, done.join("; ")))
}

/// Rounds to 0.1 mm.
fn round_point(p: &[f64; 3]) -> String {
    triple(&p.map(|x| (x * 1e4).round() / 1e4))
}

/// Map of the directions at a point.
fn directions_document(report: &PointMapReport) -> Document<'_> {
    let mut out = Document::default();
    let point = format!("{} at {} m, in the link frame", report.link, triple(&report.point_link));
    out.facts([("point", point), ("in the world", format!("{} m", triple(&report.point_world)))]);
    out.heading("Principal effective masses (the belted ellipsoid)");
    if report.principal.is_empty() {
        out.note("  none: a direction has no result");
    }
    let mut table = Table::new(["  mass", "direction (link)", "direction (world)"]);
    report.principal.iter().for_each(|principal| table.row(principal_row(principal)));
    out.table(table);
    out.facts(extreme_facts(report));
    out.paragraph(
        "1/m = n·Λ⁻¹n over unit normals n; the principal directions are the axes of Λ⁻¹.\n\
         See docs/howto/MAPS.md.",
    );
    out
}

/// Principal effective mass, with its direction in the link and in the world.
fn principal_row(p: &DirectionMass) -> [String; 3] {
    let [link, world] =
        [p.direction_link, p.direction_world].map(|direction| triple(&direction.map(round_component)));
    [format!("  {}", mass(p)), link, world]
}

/// Number of directions, then the smallest and the largest mass.
fn extreme_facts(report: &PointMapReport) -> Vec<(&'static str, String)> {
    let finite = report.directions.iter().filter_map(|d| Some((d.effective_mass?, d)));
    let (mut least, mut most) = (None::<(f64, &DirectionMass)>, None::<(f64, &DirectionMass)>);
    for (m, d) in finite {
        least = least.filter(|(l, _)| *l <= m).or(Some((m, d)));
        most = most.filter(|(l, _)| *l >= m).or(Some((m, d)));
    }
    let mut facts = vec![("directions", format!("{} uniform over the sphere", report.directions.len()))];
    for (name, found) in [("smallest of them", least), ("largest of them", most)] {
        if let Some((m, d)) = found {
            let along = triple(&d.direction_link.map(round_component));
            facts.push((name, format!("{} kg along {along} (link)", number(m))));
        }
    }
    facts
}

/// m̄ of a direction, or its status.
fn mass(d: &DirectionMass) -> String {
    d.effective_mass.map_or_else(|| d.status.to_owned(), |m| format!("{} kg", number(m)))
}

/// Rounds a component of a unit vector to nine decimals.
fn round_component(x: f64) -> f64 {
    (x * 1e9).round() / 1e9
}
