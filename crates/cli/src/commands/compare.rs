//! Command `percuss compare`, and the variants of a study.

use crate::args::{CompareArgs, MassFormat};
use crate::commands::mass::contact_list::NO_MOTION_RATIO;
use crate::document::Document;
use crate::files::contents::{self, Contents};
use crate::files::csv::{self, Cell};
use crate::files::output::record_input;
use crate::files::table_style::{ColumnUnit, TableStyle};
use crate::pictures::clipping::note_clipping;
use crate::pictures::sweep_figure::{axis_unit, motion_ratio_name, requested_figure};
use crate::terminal::design_changes;
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::number::{number, signed};
use crate::terminal::report::{write_diagnostics, write_json, write_out, write_text};
use crate::terminal::text::{Table, TableCell};
use crate::terminal::units::varied_name;
use percuss_render::{Figure, Mark, Panel, Picture, Series, Style};
use percuss_study::{
    AxisLimits, CompareError, ComparisonReport, ComparisonRow, ContactTable, Design, DesignRecord,
    MassQuestion, Model, Names, RowSource, StudyFigure, StudyFile, WheelMotion, compare, contact_names,
};
use percuss_suspension::LengthUnit;
use std::fmt::Display;
use std::path::Path;

/// Runs the command.
pub fn run(args: &CompareArgs) -> Result<(), Failure> {
    args.writing.apply();
    args.output.as_deref().map_or(Ok(()), |path| contents::check(path, &contents::ALL))?;
    let studies: Vec<bool> =
        args.designs.iter().map(|path| StudyFile::is_study(path, args.reading.max_size)).collect();
    let (designs, studies) = if studies.iter().all(|is_study| *is_study) {
        designs_of_studies(args)?
    } else if let Some(study) = studies.iter().position(|is_study| *is_study) {
        return Err(Failure::bad_input(format!(
            "{} is a study and has its own contact, the others are models or sheets; give only studies, or only \
             models and sheets",
            args.designs[study]
        )));
    } else {
        (designs_of_models(args)?, Vec::new())
    };
    let output = ComparisonOutput {
        output: args.output.as_deref(),
        table: TableStyle::from_study(&args.table),
        figure: &args.figure,
        format: args.format,
        strict: args.reading.strict,
    };
    let report = compare(&designs).map_err(|error| failure_in_file(error, &studies, &args.designs))?;
    write(&report, &output)
}

/// Study, and the number of its first design in the comparison.
type ComparedStudy = (usize, StudyFile);

/// Failure of the comparison of models, or of studies, with the file and the line at fault. `paths`: files of the studies.
fn failure_in_file(error: CompareError, studies: &[ComparedStudy], paths: &[String]) -> Failure {
    let number = if let CompareError::Question { number, .. } = error { Some(number) } else { None };
    match studies.iter().zip(paths).rfind(|((first, _), _)| Some(*first) <= number) {
        Some(((first, study), path)) => {
            failure(&study.with_key(error, *first), Names::KEYS).in_study(path, &study.keys, &[])
        }
        None => failure(&error, Names::Flags),
    }
}

/// Designs of studies, with their variants.
fn designs_of_studies(args: &CompareArgs) -> Result<(Vec<Design>, Vec<ComparedStudy>), Failure> {
    if args.contact.contact.link.is_some() || args.contact.contact.at.is_some() || !args.vary.is_empty() {
        return Err(Failure::bad_input(
            "--link, --point, --vary and similar flags apply to models and sheets; a study contains its own \
             contact and range",
        ));
    }
    let changes = args.reading.changes();
    if !changes.is_empty() {
        return Err(Failure::bad_input(
            "--link-mass, --link-com, --link-inertia and --move would change every design in the same way; use [[variant]] in a \
             study",
        ));
    }
    let (mut designs, mut studies) = (Vec::new(), Vec::new());
    let read = args.designs.iter().map(|path| StudyFile::load(path, args.reading.max_size));
    let read = read.collect::<Result<Vec<_>, _>>()?;
    let names = distinct_names(
        read.iter().map(|study| study.tables.model.name.clone().unwrap_or_default()),
        &args.designs,
    );
    for ((mut study, name), path) in read.into_iter().zip(names).zip(&args.designs) {
        study.tables.model.name = Some(name);
        let of_study = study.designs();
        if of_study.is_empty() {
            return Err(Failure::bad_input(format!(
                "{path}: the study has no [contact]; a comparison needs a contact"
            )));
        }
        studies.push((designs.len(), study));
        designs.extend(of_study);
    }
    Ok((designs, studies))
}

/// Designs of models with the contact given by flags.
fn designs_of_models(args: &CompareArgs) -> Result<Vec<Design>, Failure> {
    let question = args.contact.question_of_rows();
    if question.is_err() {
        // An error in a file precedes an error of the flags: a study that cannot be parsed is not recognized as a study. A pipe is not read.
        let files = args.designs.iter().filter(|path| Path::new(path).is_file());
        files.map(|path| args.reading.load(path)).collect::<Result<Vec<_>, _>>()?;
    }
    let (question, mut ranges) = (question?, args.vary.clone());
    let models = args.designs.iter().map(|path| args.reading.load(path)).collect::<Result<Vec<_>, _>>()?;
    ranges.extend(args.contact.ranges()?);
    let rows = (!ranges.is_empty()).then_some(RowSource::Grid(ranges));
    let mut designs = Vec::new();
    let stem = |path: &String| Path::new(path).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let names = args.designs.iter().map(|path| stem(path).unwrap_or_else(|| path.clone()));
    for (model, name) in models.iter().zip(distinct_names(names, &args.designs)) {
        let contacts = contacts(question.contact.at.as_deref(), model)?;
        let several = contacts.len() > 1;
        for at in contacts {
            let name = match &at {
                Some(contact) if several && args.designs.len() == 1 => contact.clone(),
                Some(contact) if several => format!("{name}: {contact}"),
                _ => name.clone(),
            };
            let contact = at.clone().filter(|_| several);
            let table = ContactTable { at, ..question.contact.clone() };
            let question = MassQuestion { contact: table, ..question.clone() };
            designs.push(Design { name, model: model.clone(), question, contact, rows: rows.clone() });
        }
    }
    Ok(designs)
}

/// Named contacts of `--at`: one name, several with commas, or `all`; a single `None` if the contact is given by link and point.
fn contacts(at: Option<&str>, model: &Model) -> Result<Vec<Option<String>>, Failure> {
    let Some(at) = at else { return Ok(vec![None]) };
    let names =
        contact_names(at, &model.mechanism).map_err(|why| Failure::bad_input(format!("--at {at}: {why}")))?;
    Ok(names.into_iter().map(Some).collect())
}

/// Names of the designs, with the path of the file in place of a name that is not unique.
fn distinct_names(names: impl Iterator<Item = String>, paths: &[String]) -> Vec<String> {
    let names: Vec<String> = names.collect();
    let is_unique = |name: &String| names.iter().filter(|other| *other == name).count() == 1;
    names.iter().zip(paths).map(|(name, path)| if is_unique(name) { name } else { path }.clone()).collect()
}

/// Output options of a comparison.
#[derive(Clone, Copy)]
pub struct ComparisonOutput<'a> {
    pub output: Option<&'a str>,
    pub table: TableStyle,
    pub figure: &'a StudyFigure,
    pub format: MassFormat,
    pub strict: bool,
}

/// Writes a comparison with its findings and its file.
pub fn write(report: &ComparisonReport, output: &ComparisonOutput) -> Result<(), Failure> {
    let ComparisonOutput { output, table: style, format, strict, figure: requested } = *output;
    write_diagnostics(&report.diagnostics, strict)?;
    if let Some(path) = output {
        report.designs.iter().flat_map(|design| &design.inputs).for_each(|input| record_input(&input.path));
        write_contents(report, path, style, requested)?;
    }
    match format {
        MassFormat::Json => write_json(report)?,
        MassFormat::Csv => {
            let (columns, rows) = table_cells(report, style);
            write_out(&csv::styled_table(&columns, &rows, style))?;
        }
        MassFormat::Text => {
            let title = of_designs(report, report.designs.len());
            write_text(&format!("effective mass of {title}\n\n{}", document(report).text()))?;
        }
    }
    if report.designs.iter().all(|design| design.status.is_none()) {
        return Err(Failure::NoAnswer("no design has a result".into()));
    }
    Ok(())
}

/// Writes the file of a comparison, without text and findings.
pub fn write_output(report: &ComparisonReport, output: &ComparisonOutput) -> Result<(), Failure> {
    let ComparisonOutput { output, table, figure, .. } = *output;
    output.map_or(Ok(()), |path| write_contents(report, path, table, figure))
}

/// Failure of a comparison; the names of fields are flags or keys.
pub fn failure(error: &CompareError, names: Names) -> Failure {
    match error {
        CompareError::Question { source, .. } if source.has_no_result() => {
            Failure::NoAnswer(error.message(names))
        }
        _ => Failure::bad_input(error.message(names)),
    }
}

/// m̄ of a design, or its outcome; "no answer" without either.
fn answer_cell(design: &DesignRecord) -> TableCell {
    match (design.effective_mass, design.status) {
        (Some(mass), _) => mass.into(),
        (None, Some(status)) => status.name().into(),
        (None, None) => "no answer".into(),
    }
}

/// Percentage with its sign and two decimals.
fn percent(x: f64) -> String {
    format!("{} %", signed(x, 2))
}

/// Table with one row per design: m̄, its difference to the reference, the range of the difference, and the links with the largest
/// shares. For several contacts of one design, motion ratios and ranges of m̄ replace the differences.
fn design_table(report: &ComparisonReport) -> Table {
    let most = |design: &DesignRecord| {
        let most = design.most.iter().map(|(link, share)| format!("{link} {:.0} %", 100.0 * share));
        most.collect::<Vec<_>>().join(", ")
    };
    if report.designs.iter().all(|design| design.reference.is_none()) {
        let unit = mass_unit(report);
        let over = format!("{unit} over the range");
        let mut table = Table::new(["contact", unit, "motion ratio", &over, "largest shares of m̄"]);
        for (i, design) in report.designs.iter().enumerate() {
            let ratio = TableCell::from(design.motion_ratio);
            let masses = report.rows.iter().filter_map(|row| row.effective_mass[i]);
            let range = masses.fold(None, |range: Option<[f64; 2]>, x| {
                Some(range.map_or([x, x], |[least, greatest]| [least.min(x), greatest.max(x)]))
            });
            let range = range.map_or_else(String::new, |[a, b]| format!("{} to {}", number(a), number(b)));
            table.row([
                design.name.clone().into(),
                answer_cell(design),
                ratio,
                range.into(),
                most(design).into(),
            ]);
        }
        return table;
    }
    let has_range = report.designs.iter().any(|design| design.difference_range_percent.is_some());
    let mut header = vec!["design", mass_unit(report), "difference", "over the range", "largest shares of m̄"];
    header.retain(|name| has_range || *name != "over the range");
    let mut rows: Vec<Vec<TableCell>> = vec![header.into_iter().map(TableCell::from).collect()];
    for design in &report.designs {
        let difference = match design.difference_percent {
            Some(x) => percent(x),
            None if design.reference.is_none() => "–".into(),
            None => String::new(),
        };
        let range = design.difference_range_percent;
        let range = range.map_or_else(String::new, |[a, b]| format!("{} to {}", percent(a), percent(b)));
        let mut row = vec![design.name.clone().into(), answer_cell(design), difference.into()];
        row.extend(has_range.then(|| range.into()));
        row.push(most(design).into());
        rows.push(row);
    }
    Table::from_rows(rows)
}

/// Unit of all effective masses; both units if some designs have contact points and others moments.
fn mass_unit(report: &ComparisonReport) -> &'static str {
    let unit = report.designs.first().map_or("kg", |design| design.mass_unit);
    if report.designs.iter().all(|design| design.mass_unit == unit) { unit } else { "kg, kg·m²" }
}

/// "COUNT designs", or "COUNT contacts" of one design.
fn of_designs(report: &ComparisonReport, count: impl Display) -> String {
    let has_designs = report.designs.iter().any(|design| design.reference.is_some());
    format!("{count} {}", if has_designs { "designs" } else { "contacts" }).trim_start().to_owned()
}

/// Table of the designs, their differences in words, remarks, and reasons of missing results.
pub fn document(report: &ComparisonReport) -> Document<'_> {
    let mut out = Document::default();
    out.table(design_table(report));
    design_changes::sentences(report).into_iter().chain(remarks(report)).for_each(|text| out.paragraph(text));
    for design in &report.designs {
        if let Some(error) = &design.error {
            out.problem(format!("{}: {error}", design.name));
        }
    }
    out
}

/// Remarks about the table: designs whose stops touch at different travels of the wheel, and missing motion ratios.
fn remarks(report: &ComparisonReport) -> Vec<String> {
    let mut remarks = Vec::new();
    for design in &report.designs {
        let Some(reference) = design.reference.map(|at| &report.designs[at]) else { continue };
        if let (Some(travel), Some(of_reference)) = (design.travel_at_touch, reference.travel_at_touch)
            && (travel - of_reference).abs() > limits::SAME_TRAVEL
        {
            remarks.push(format!(
                "each at its own touch: {} after {} of wheel travel, {} after {}; --wheel-travel compares both at one travel",
                reference.name,
                reference.unit.text(of_reference),
                design.name,
                reference.unit.text(travel)
            ));
        }
    }
    let lacks_ratio =
        |design: &DesignRecord| design.effective_mass.is_some() && design.motion_ratio.is_none();
    if has_several_contacts(report) && report.designs.iter().any(lacks_ratio) {
        remarks.push(NO_MOTION_RATIO.to_owned());
    }
    remarks
}

/// True if the designs have different contacts; their motion ratios are then shown as well.
pub fn has_several_contacts(report: &ComparisonReport) -> bool {
    report.designs.iter().filter(|design| design.reference.is_none()).count() > 1
}

/// Column names and rows of the table: over the ranges if any, otherwise over the designs.
fn table_cells(report: &ComparisonReport, style: TableStyle) -> (Vec<String>, Vec<Vec<Cell>>) {
    let rounded = |x: Option<f64>, error| Cell::from_value(x.map(|x| style.number(x, error)));
    if report.varied.is_empty() {
        let mass = style.name_with_unit("effective_mass", mass_unit(report));
        let names = ["design", "status", &mass, "difference_percent"].map(str::to_owned).to_vec();
        let row = |design: &DesignRecord| {
            let status = design.status.map_or("no answer", |status| status.name());
            vec![
                Cell::Text(design.name.clone().into()),
                Cell::Text(status.into()),
                rounded(design.effective_mass, design.effective_mass_error),
                rounded(design.difference_percent, None),
            ]
        };
        return (names, report.designs.iter().map(row).collect());
    }
    let mut header = vec!["row".to_owned()];
    let units: Vec<ColumnUnit> =
        report.varied.iter().map(|column| style.unit(column.unit.si_unit())).collect();
    header.extend(report.varied.iter().zip(&units).map(|(column, unit)| match &column.joint {
        _ if !style.names_units => column.name.clone(),
        Some(_) => csv::with_unit(&column.name, unit),
        None => format!("travel_{}", unit.name),
    }));
    header.extend(report.designs.iter().map(|design| style.name_with_unit(&design.name, design.mass_unit)));
    let compared: Vec<usize> =
        (0..report.designs.len()).filter(|i| report.designs[*i].reference.is_some()).collect();
    header.extend(compared.iter().map(|i| format!("{} difference_percent", report.designs[*i].name)));
    let ratios = has_several_contacts(report);
    if ratios {
        header.extend(report.designs.iter().map(|design| format!("{} motion_ratio", design.name)));
    }
    let row = |row: &ComparisonRow| {
        let mut cells = vec![Cell::Number(row.row as f64)];
        let varied = row.varied.iter().zip(&units);
        cells.extend(varied.map(|(value, unit)| rounded(Some(value * unit.factor), None)));
        cells.extend(row.effective_mass.iter().map(|mass| rounded(*mass, None)));
        cells.extend(compared.iter().map(|i| rounded(row.difference_percent[*i], None)));
        if ratios {
            cells.extend(row.motion_ratio.iter().map(|ratio| rounded(*ratio, None)));
        }
        cells
    };
    (header, report.rows.iter().map(row).collect())
}

/// Writes a file with the table or the figure of a comparison.
fn write_contents(
    report: &ComparisonReport,
    path: &str,
    style: TableStyle,
    requested: &StudyFigure,
) -> Result<(), Failure> {
    let table = || table_cells(report, style);
    let picture = || {
        let mut figure = figure(report, requested)?;
        note_clipping(&mut figure);
        Ok(Box::new(figure) as Box<dyn Picture>)
    };
    // Records have text keys and no other source of errors.
    let json = || serde_json::to_string_pretty(report).unwrap_or_default() + "\n";
    let (table, picture, json) = (Some(&table as _), Some(&picture as _), Some(&json as _));
    Contents { name: "comparison", style, table, picture, json }.write(path)
}

/// Figure of each contact, if there are several: m̄ of all designs at this contact over the range, with the motion ratio below.
pub fn contact_figures(report: &ComparisonReport, requested: &StudyFigure) -> Vec<Figure> {
    let firsts = (0..report.designs.len()).filter(|i| report.designs[*i].reference.is_none());
    let figure = |first: usize| {
        let of_contact = |i: &usize| *i == first || report.designs[*i].reference == Some(first);
        let designs: Vec<usize> = (0..report.designs.len()).filter(of_contact).collect();
        let contact = report.designs[first].contact.as_ref().unwrap_or(&report.designs[first].name);
        let title = match &requested.title {
            Some(title) => format!("{title}: {contact}"),
            None => format!("Effective mass at {contact}"),
        };
        figure_of(report, &StudyFigure { title: Some(title), y_limits: None, ..requested.clone() }, &designs)
            .ok()
    };
    firsts.filter_map(figure).collect()
}

/// Figure of m̄ of all designs over the range, with the differences from the first design below.
pub fn figure(report: &ComparisonReport, requested: &StudyFigure) -> Result<Figure, Failure> {
    figure_of(report, requested, &(0..report.designs.len()).collect::<Vec<_>>())
}

/// File names of the models of some designs, each once.
fn model_names(report: &ComparisonReport, designs: &[usize]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for input in designs.iter().filter_map(|i| report.designs[*i].inputs.first()) {
        let name = Path::new(&input.path).file_name().unwrap_or_default().to_string_lossy().into_owned();
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// Marks at the wheel travels at which the stops of some designs touch, for rows over the travel of the wheels.
fn touches(report: &ComparisonReport, designs: &[usize]) -> Vec<Mark> {
    let motions = [WheelMotion::WheelTravel, WheelMotion::Heave].map(WheelMotion::name);
    let is_travel = report.varied.first().is_some_and(|varied| motions.contains(&varied.name.as_str()));
    let at_touch =
        |i: &usize| report.designs[*i].travel_at_touch.map(|travel| (&report.designs[*i].name, travel));
    let touching: Vec<_> = designs.iter().filter(|_| is_travel).filter_map(at_touch).collect();
    let same = length_unit(report).of_metres(limits::SAME_TRAVEL);
    let mut marks: Vec<Mark> = Vec::new();
    for (name, travel) in &touching {
        let x = length_unit(report).of_metres(*travel);
        match marks.iter_mut().find(|mark| (mark.x - x).abs() <= same) {
            Some(mark) => mark.label += &format!(", {name}"),
            None => marks.push(Mark { x, label: format!("touch: {name}") }),
        }
    }
    // One mark concerns all designs.
    if let ([mark], true) = (&mut marks[..], touching.len() == designs.len()) {
        mark.label = "touch".into();
    }
    marks
}

/// Unit of lengths: that of the first design.
fn length_unit(report: &ComparisonReport) -> LengthUnit {
    report.designs.first().map_or(LengthUnit::Millimetre, |design| design.unit)
}

/// Figure of some designs.
fn figure_of(
    report: &ComparisonReport,
    requested: &StudyFigure,
    designs: &[usize],
) -> Result<Figure, Failure> {
    let [varied] = &report.varied[..] else {
        return Err(Failure::bad_input(
            "--output: a figure shows designs over one range; give --vary once (a study: [sweep] with one range), or a file \
             that ends in .csv, .xlsx or .json",
        ));
    };
    let (scale, unit) = axis_unit(varied, length_unit(report));
    let series = |i: usize, values: &dyn Fn(usize) -> Option<f64>| Series {
        name: report.designs[i].name.clone(),
        style: if report.designs[i].reference.is_none() { Style::Line } else { Style::Dashed },
        points: report
            .rows
            .iter()
            .enumerate()
            .map(|(row, r)| (scale * r.varied.first().copied().unwrap_or_default(), values(row)))
            .collect(),
    };
    let all = designs.iter().copied();
    let masses = all.clone().map(|i| series(i, &|row| report.rows[row].effective_mass[i])).collect();
    let mut panels = vec![Panel {
        y_label: format!("m̄ ({})", mass_unit(report)),
        series: masses,
        y_limits: requested.y_limits.map(AxisLimits::ends),
        ..Panel::default()
    }];
    if has_several_contacts(report) {
        let ratios = all.clone().map(|i| series(i, &|row| report.rows[row].motion_ratio[i]));
        let varied = report.varied.first().map(|column| column.name.as_str());
        let y_label = format!("motion ratio, {}", motion_ratio_name(varied));
        panels.push(Panel { y_label, series: ratios.collect(), ..Panel::default() });
    }
    let compared = all.filter(|i| report.designs[*i].reference.is_some());
    let differences: Vec<Series> =
        compared.map(|i| series(i, &|row| report.rows[row].difference_percent[i])).collect();
    if !differences.is_empty() {
        let is_of_several = designs.len() == report.designs.len() && has_several_contacts(report);
        let first = if is_of_several { "the first design" } else { &report.designs[designs[0]].name };
        let y_label = format!("difference from {first} (%)");
        panels.push(Panel { y_label, series: differences, ..Panel::default() });
    }
    Ok(Figure {
        subtitle: model_names(report, designs).join(", "),
        x_label: format!("{} ({unit})", varied_name(&varied.name)),
        panels,
        marks: touches(report, designs),
        ..requested_figure(requested, &format!("Effective mass of {}", of_designs(report, "")))
    })
}
