//! Command `percuss kinematics`.

use crate::args::{KinematicsArgs, KinematicsFormat};
use crate::files::contents::{Cells, Contents};
use crate::files::csv::{self, Cell};
use crate::files::output::{check_writable, ending_of, record_input, write_file};
use crate::files::own_files::KINEMATIC_AXES;
use crate::files::table_style::TableStyle;
use crate::pictures::clipping::note_clipping;
use crate::pictures::kinematics_figure::kinematics_figure;
use crate::terminal::failure::Failure;
use crate::terminal::number::{fixed, number};
use crate::terminal::report::{notes_are_shown, write_diagnostics, write_json, write_out, write_text};
use crate::terminal::text::Table;
use crate::terminal::wrap::{columns, width, wrap_hanging};
use percuss_render::Picture;
use percuss_study::{
    KinematicColumn, KinematicLoads, KinematicsError, KinematicsQuestion, KinematicsReport, KinematicsRow,
    Model, SearchUnknown, TargetReport, TargetSearch, changed_sheet, kinematics, search_targets,
};
use percuss_suspension::LengthUnit;
use percuss_suspension::kinematics::KinematicUnit;
use std::fmt::Write;
use std::path::Path;

/// Runs the command.
pub fn run(args: &KinematicsArgs) -> Result<(), Failure> {
    args.writing.apply();
    let question = args.question()?;
    let model = args.model.load_for_kinematics()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    args.output.as_deref().map_or(Ok(()), check_writable)?;
    let is_search = !args.solve.is_empty();
    if let (Some(path), None, false) = (&args.output, args.format, is_search) {
        file_ending(path)?;
    }
    if let Some(search) = args.search()? {
        return show_search(args, &model, &question, &search);
    }
    let report = kinematics(&model, &question)?;
    write_diagnostics(&report.diagnostics, args.model.reading.strict)?;
    let format = args.format.unwrap_or(KinematicsFormat::Table);
    match &args.output {
        Some(path) if args.format.is_none() => write_output(&report, !args.columns.is_empty(), path)?,
        Some(path) => write_file(path, text_of(&report, format).as_bytes())?,
        None if format == KinematicsFormat::Table => write_text(&text_of(&report, format))?,
        None => write_out(&text_of(&report, format))?,
    }
    check_rows(&report)
}

/// Report as text in a format.
fn text_of(report: &KinematicsReport, format: KinematicsFormat) -> String {
    match format {
        KinematicsFormat::Table => tables(report),
        KinematicsFormat::Csv => {
            let (columns, rows) = cells(report);
            csv::styled_table(&columns, &rows, TableStyle::default())
        }
        KinematicsFormat::Json => serde_json::to_string_pretty(report).unwrap_or_default() + "\n",
    }
}

/// Shows the kinematics of a study: the table on stdout, or the file that the study names.
pub fn show_of_study(
    report: &KinematicsReport,
    requested: &KinematicsQuestion,
    strict: bool,
) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    match &requested.output {
        Some(path) => write_output(report, !requested.columns.is_empty(), path)?,
        None => write_text(&tables(report))?,
    }
    check_rows(report)
}

/// Ending of a file of kinematics; a name without an ending is that of a text.
pub fn file_ending(path: &str) -> Result<&'static str, Failure> {
    match Path::new(path).extension() {
        None => Ok("txt"),
        Some(_) => ending_of(path, &["csv", "xlsx", "parquet", "json", "txt", "svg", "png", "pdf"]),
    }
}

/// Writes a text, table, figure or JSON, by the ending of the file; `selected`: true if the columns were selected.
pub fn write_output(report: &KinematicsReport, selected: bool, path: &str) -> Result<(), Failure> {
    report.inputs.iter().for_each(|input| record_input(&input.path));
    if file_ending(path)? == "txt" {
        return write_file(path, tables(report).as_bytes());
    }
    let picture = || {
        let mut figure = kinematics_figure(report, selected)?;
        note_clipping(&mut figure);
        Ok(Box::new(figure) as Box<dyn Picture>)
    };
    let (table, json) = (|| cells(report), || text_of(report, KinematicsFormat::Json));
    let (table, picture, json) = (Some(&table as _), Some(&picture as _), Some(&json as _));
    Contents { name: "kinematics", table, picture, json, ..Contents::default() }.write(path)
}

/// Warns about rows without a result; exit code 1 if no row has one.
fn check_rows(report: &KinematicsReport) -> Result<(), Failure> {
    match report.rows.iter().find_map(|row| row.problem.as_ref()) {
        Some(problem) if report.rows.iter().all(|row| row.problem.is_some()) => {
            Err(Failure::NoAnswer(problem.clone()))
        }
        Some(problem) => {
            crate::terminal::report::warn(&format!("some rows have no result; the first: {problem}"));
            Ok(())
        }
        None => Ok(()),
    }
}

/// Searches coordinates and writes them; exit code 1 if a value is not reached.
fn show_search(
    args: &KinematicsArgs,
    model: &Model,
    question: &KinematicsQuestion,
    search: &TargetSearch,
) -> Result<(), Failure> {
    if let Some((variable, _)) = &question.range {
        return Err(Failure::bad_input(format!(
            "--{}: a search is at one state; give one length",
            variable.name()
        )));
    }
    if args.output.is_some()
        && search.unknowns.iter().any(|unknown| !matches!(unknown, SearchUnknown::Coordinate(..)))
    {
        let why = "--output: the changed sheet has coordinates only; omit --output, and write the masses, curves and dampers found into the sheet";
        return Err(Failure::bad_input(why));
    }
    let report = search_targets(model, question, search)?;
    write_diagnostics(&report.diagnostics, args.model.reading.strict)?;
    match args.format.unwrap_or(KinematicsFormat::Table) {
        KinematicsFormat::Table => write_text(&search_text(&report))?,
        KinematicsFormat::Csv => write_out(&search_as_csv(&report))?,
        KinematicsFormat::Json => write_json(&report)?,
    }
    check_reached(&report)?;
    match &args.output {
        Some(path) => {
            let changed = changed_sheet(model, &report.moves)?;
            check_format(path, &changed.name)?;
            write_file(path, &changed.bytes)
        }
        None => Ok(()),
    }
}

/// Exit code 1 for a search that does not reach its values.
fn check_reached(report: &TargetReport) -> Result<(), Failure> {
    match report.is_reached {
        true => Ok(()),
        false => Err(Failure::NoAnswer(format!(
            "the required values are not reached within {}; above are the nearest values found and their coordinates",
            report.length_unit.text(report.within)
        ))),
    }
}

/// Shows the search of a study on stdout.
pub fn show_targets(report: &TargetReport, strict: bool) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    write_text(&search_text(report))?;
    check_reached(report)
}

/// Table of a search: unknowns, then quantities, each with its old, new and required value.
pub fn search_table(report: &TargetReport) -> Table {
    let mut table = Table::new(["", "old", "new", "required"]);
    let with_unit =
        |name: &str, unit: &str| if unit.is_empty() { name.to_owned() } else { format!("{name}, {unit}") };
    for found in &report.coordinates {
        let label = with_unit(&found.coordinate, found.unit);
        table.row([label, number(found.old), number(found.new), String::new()]);
    }
    for target in &report.targets {
        let (unit, factor, _) = target.unit.of_table(report.length_unit);
        let [old, new, required] = [target.old, target.reached, target.required].map(|x| number(x * factor));
        table.row([with_unit(&target.quantity, unit), old, new, required]);
    }
    table
}

/// Refuses a name of the changed file with another ending than the file that was read.
fn check_format(path: &str, read: &str) -> Result<(), Failure> {
    let [written, expected] = [path, read]
        .map(|name| Path::new(name).extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase());
    if written == expected {
        return Ok(());
    }
    Err(Failure::bad_input(format!(
        "--output {path}: the coordinates are in {read}, and the changed file has the same format: give a name that ends in .{expected}"
    )))
}

/// Result of a search as text.
fn search_text(report: &TargetReport) -> String {
    let table = search_table(report);
    let moves: Vec<String> = report
        .moves
        .iter()
        .map(|(point, [x, y, z])| {
            format!("--move {point}={},{},{}", csv::number(*x), csv::number(*y), csv::number(*z))
        })
        .chain(
            report
                .link_masses
                .iter()
                .map(|(link, mass)| format!("--link-mass {link}={}kg", csv::number(*mass))),
        )
        .collect();
    let count =
        if notes_are_shown() { format!("{} designs evaluated; ", report.evaluations) } else { String::new() };
    let loads = report.loads.as_ref().map_or_else(String::new, |loads| loads_line(loads) + "\n");
    if moves.is_empty() {
        return format!("{table}\n{loads}{count}×: factor on the forces of the curve or on the stiffness\n");
    }
    format!("{table}\n{loads}{count}as flags, in m and the axes of the sheet:\n  {}\n", moves.join("\n  "))
}

/// Result of a search as CSV.
fn search_as_csv(report: &TargetReport) -> String {
    let mut out = csv::line(&["name", "unit", "old", "new", "required"].map(str::to_owned));
    for found in &report.coordinates {
        let numbers = [found.old, found.new].map(csv::number);
        let [old, new] = numbers;
        out += &csv::line(&[found.coordinate.clone(), found.unit.to_owned(), old, new, String::new()]);
    }
    for target in &report.targets {
        let (unit, factor, _) = target.unit.of_table(report.length_unit);
        let [old, new, required] =
            [target.old, target.reached, target.required].map(|x| csv::number(x * factor));
        out += &csv::line(&[target.quantity.clone(), unit.to_owned(), old, new, required]);
    }
    out
}

impl From<KinematicsError> for Failure {
    fn from(error: KinematicsError) -> Self {
        match error {
            KinematicsError::Study(error) => error.into(),
            KinematicsError::Design(error) => (*error).into(),
            other => Failure::bad_input(other.to_string()),
        }
    }
}

/// Columns and rows of a report in the units of tables, as text: the variable first; quantities without values are left out.
pub fn table_rows(report: &KinematicsReport) -> Vec<Vec<String>> {
    let given: Vec<usize> =
        (0..report.columns.len()).filter(|i| report.columns[*i].missing.is_none()).collect();
    let unit = report.length_unit;
    let head = |i: &usize| {
        let column = &report.columns[*i];
        let side = if column.side.is_empty() { String::new() } else { format!(", {}", column.side) };
        words(column, unit) + &side
    };
    let first = format!("{} ({})", report.variable.unwrap_or_default(), unit.name());
    let mut rows = vec![[first].into_iter().chain(given.iter().map(head)).collect::<Vec<_>>()];
    for row in &report.rows {
        let value = |i: &usize| shown(report.columns[*i].unit, unit, row.values.get(*i).copied().flatten());
        let variable = shown(KinematicUnit::Length, unit, row.variable);
        rows.push([variable].into_iter().chain(given.iter().map(value)).collect());
    }
    rows
}

/// Name of a column with its unit in tables.
fn heading(column: &KinematicColumn, length_unit: LengthUnit) -> String {
    match column.unit.of_table(length_unit).0 {
        "" => column.name(),
        "%" => format!("{}_percent", column.name()),
        unit => format!("{}_{}", column.name(), unit.replace('/', "_per_")),
    }
}

/// Columns and rows in the units of tables; numbers read back unchanged.
fn cells(report: &KinematicsReport) -> Cells {
    let unit = report.length_unit;
    let mut header: Vec<String> =
        report.variable.iter().map(|name| format!("{name}_{}", unit.name())).collect();
    header.extend(report.columns.iter().map(|column| heading(column, unit)));
    let loads = report.loads.as_ref().map(KinematicLoads::text);
    let matrices: &[_] = if report.is_selected { &[] } else { &report.compliance_matrices };
    let size = matrices.iter().flatten().map(Vec::len).next().unwrap_or(0);
    let entries: Vec<(usize, usize)> = (0..size).flat_map(|r| (0..size).map(move |c| (r, c))).collect();
    let entry_unit = |(r, c): (usize, usize)| matrix_unit(r, c).of_table(unit);
    header.extend(entries.iter().map(|&(r, c)| {
        let [motion, load] = [matrix_motion(r, size), matrix_load(c, size)];
        format!("compliance_{motion}_per_{load}_{}", entry_unit((r, c)).0.replace('/', "_per_"))
            .replace(' ', "_")
    }));
    let has_problem = report.rows.iter().any(|row| row.problem.is_some());
    header.extend(loads.iter().map(|_| "loads".to_owned()));
    header.extend(has_problem.then(|| "problem".to_owned()));
    let row = |(k, row): (usize, &KinematicsRow)| {
        let mut cells: Vec<Cell> = row.variable.iter().map(|x| Cell::Number(unit.of_metres(*x))).collect();
        let values = report.columns.iter().zip(&row.values);
        cells.extend(
            values.map(|(column, value)| Cell::from_value(value.map(|x| x * column.unit.of_table(unit).1))),
        );
        let matrix = matrices.get(k).and_then(Option::as_ref);
        let entry = |&(r, c): &(usize, usize)| {
            Cell::from_value(matrix.map(|matrix| matrix[r][c] * entry_unit((r, c)).1))
        };
        cells.extend(entries.iter().map(entry));
        cells.extend(loads.iter().map(|loads| Cell::Text(loads.clone().into())));
        cells.extend(has_problem.then(|| Cell::Text(row.problem.clone().unwrap_or_default().into())));
        cells
    };
    (header, report.rows.iter().enumerate().map(row).collect())
}

/// Text of a value in the unit of tables; – without a value.
fn shown(unit: KinematicUnit, length_unit: LengthUnit, value: Option<f64>) -> String {
    let (_, factor, decimals) = unit.of_table(length_unit);
    value.map_or_else(|| "–".to_owned(), |x| fixed(x * factor, decimals))
}

/// Name of a quantity in words; a motion ratio is written `motion ratio CONTACT/wheel`.
fn named_in_words(quantity: &str) -> String {
    let is_ratio = quantity.starts_with("motion_ratio_");
    quantity.replace('_', " ") + if is_ratio { "/wheel" } else { "" }
}

/// Name of a quantity in words, with its unit.
fn words(column: &KinematicColumn, length_unit: LengthUnit) -> String {
    let unit = column.unit.of_table(length_unit).0;
    let name = named_in_words(&column.quantity);
    if unit.is_empty() { name } else { format!("{name}, {unit}") }
}

/// Report as text: a list for one row, tables for several rows; below, the reasons for missing values.
fn tables(report: &KinematicsReport) -> String {
    let mut out = if report.rows.len() == 1 { list(report) } else { blocks(report) };
    let mut reasons: Vec<(&str, Vec<String>)> = Vec::new();
    for column in &report.columns {
        let Some(why) = &column.missing else { continue };
        let name =
            under_load(column).map_or(column.quantity.clone(), |(_, load)| format!("motions per {load}"));
        match reasons.iter_mut().find(|(known, _)| known == why) {
            Some((_, names)) if names.contains(&name) => {}
            Some((_, names)) => names.push(name),
            None => reasons.push((why, vec![name])),
        }
    }
    let _ = writeln!(
        out,
        "\nderivatives along {}, per travel of the wheel\n{KINEMATIC_AXES}",
        report.derivatives
    );
    if let Some(loads) = &report.loads {
        let _ = writeln!(out, "{}", loads_line(loads));
        if report.rows.len() > 1 && !report.is_selected {
            out += "compliance matrix of the wheel centres at each row: --format csv or json\n";
        }
    }
    for (why, names) in reasons {
        let _ = writeln!(out, "{}", wrap_hanging(&format!("not given: {}: {why}", names.join(", ")), 2));
    }
    for row in &report.rows {
        if let (Some(problem), Some(x)) = (&row.problem, row.variable) {
            let at = report.length_unit.text(x);
            let text = format!("{} {at}: {problem}", report.variable.unwrap_or_default());
            let _ = writeln!(out, "{}", wrap_hanging(&text, 2));
        }
    }
    out
}

/// One row as a list: a line per quantity, a column per side.
fn list(report: &KinematicsReport) -> String {
    let Some(row) = report.rows.first() else { return String::new() };
    let mut lines: Vec<Vec<String>> = Vec::new();
    let mut sides: Vec<&str> =
        report.columns.iter().map(|c| c.side).filter(|side| !side.is_empty()).collect();
    sides.sort_unstable();
    sides.dedup();
    if !sides.is_empty() {
        lines.push([""].into_iter().chain(sides.iter().copied()).map(str::to_owned).collect());
    }
    let is_listed = |column: &KinematicColumn| column.missing.is_none() && under_load(column).is_none();
    for (column, value) in report.columns.iter().zip(&row.values).filter(|(column, _)| is_listed(column)) {
        let name = words(column, report.length_unit);
        let place = sides.iter().position(|side| *side == column.side).unwrap_or(0);
        let known = lines.iter().position(|line| line[0] == name);
        let line = known.unwrap_or_else(|| {
            lines.push(vec![name]);
            lines.len() - 1
        });
        let line = &mut lines[line];
        line.resize(line.len().max(place + 2), String::new());
        line[place + 1] = shown(column.unit, report.length_unit, *value);
    }
    aligned(&lines) + &loads_table(report, row) + &matrix_table(report)
}

/// Loads of the motions per load, as text.
fn loads_line(loads: &KinematicLoads) -> String {
    wrap_hanging(&format!("loads: {}", loads.text()), 2)
}

/// Side of a wheel with 6 rows and columns of a compliance matrix, with a space before it; empty for one wheel.
fn matrix_side(k: usize, size: usize) -> &'static str {
    match (size, k) {
        (6, _) => "",
        (_, 0..6) => " left",
        _ => " right",
    }
}

/// Name of the motion of a row of a compliance matrix with `size` rows.
fn matrix_motion(row: usize, size: usize) -> String {
    let name = ["x", "y", "z", "rotation x", "rotation y", "rotation z"][row % 6];
    format!("{name}{}", matrix_side(row, size))
}

/// Name of the load of a column of a compliance matrix with `size` columns.
fn matrix_load(column: usize, size: usize) -> String {
    let name = ["force x", "force y", "force z", "moment x", "moment y", "moment z"][column % 6];
    format!("{name}{}", matrix_side(column, size))
}

/// Unit of an entry of a compliance matrix.
fn matrix_unit(row: usize, column: usize) -> KinematicUnit {
    match (row % 6 < 3, column % 6 < 3) {
        (true, true) => KinematicUnit::LengthPerForce,
        (true, false) => KinematicUnit::LengthPerMoment,
        (false, true) => KinematicUnit::AnglePerForce,
        (false, false) => KinematicUnit::AnglePerMoment,
    }
}

/// Compliance matrix of the wheel centres of a single row as tables, one for each loaded wheel.
fn matrix_table(report: &KinematicsReport) -> String {
    let ([Some(matrix)], false) = (&report.compliance_matrices[..], report.is_selected) else {
        return String::new();
    };
    let size = matrix.len();
    let mut out = String::new();
    for first in (0..size).step_by(6) {
        let head = ["force x", "y", "z", "moment x", "y", "z"].map(str::to_owned);
        let head = [format!("per kN, kN·m{}", matrix_side(first, size))].into_iter().chain(head);
        let mut lines = vec![head.collect::<Vec<_>>()];
        for (r, row) in matrix.iter().enumerate() {
            let unit = if r % 6 < 3 { "mm" } else { "deg" };
            let cell = |c: usize| shown(matrix_unit(r, c), report.length_unit, row.get(c).copied());
            let name = [format!("{}, {unit}", matrix_motion(r, size))].into_iter();
            lines.push(name.chain((first..first + 6).map(cell)).collect());
        }
        out += "\ncompliance matrix of the wheel centre\n";
        out += &aligned(&lines);
    }
    out
}

/// Quantity and load of a column of a motion per load.
fn under_load(column: &KinematicColumn) -> Option<(&str, &str)> {
    use KinematicUnit::{AnglePerForce, AnglePerMoment, LengthPerForce, LengthPerMoment};
    let is_per_load =
        matches!(column.unit, AnglePerForce | AnglePerMoment | LengthPerForce | LengthPerMoment);
    column.quantity.split_once("_per_").filter(|_| is_per_load)
}

/// Motions per load as a table: a line per wheel and load, a column per quantity.
fn loads_table(report: &KinematicsReport, row: &KinematicsRow) -> String {
    let mut quantities = Vec::new();
    let mut lines: Vec<(String, Vec<String>)> = Vec::new();
    for (column, value) in report.columns.iter().zip(&row.values) {
        let Some((quantity, load)) = under_load(column).filter(|_| column.missing.is_none()) else {
            continue;
        };
        let at = quantities.iter().position(|known| *known == quantity).unwrap_or_else(|| {
            quantities.push(quantity);
            quantities.len() - 1
        });
        let side = if column.side.is_empty() { String::new() } else { format!(" {}", column.side) };
        let name = load.replace('_', " ") + &side;
        let line = lines.iter().position(|(known, _)| *known == name).unwrap_or_else(|| {
            lines.push((name, Vec::new()));
            lines.len() - 1
        });
        let cells = &mut lines[line].1;
        cells.resize(cells.len().max(at + 1), "–".to_owned());
        cells[at] = shown(column.unit, report.length_unit, *value);
    }
    if lines.is_empty() {
        return String::new();
    }
    let heads: Vec<[String; 2]> = quantities
        .iter()
        .map(|quantity| match quantity.rsplit_once('_') {
            Some((point, axis)) => {
                [point.rsplit('_').next().unwrap_or_default().to_owned(), format!("{axis} mm")]
            }
            None => [(*quantity).to_owned(), "deg".to_owned()],
        })
        .collect();
    let head = |first: &str, k: usize| {
        [first.to_owned()].into_iter().chain(heads.iter().map(|head| head[k].clone())).collect::<Vec<_>>()
    };
    let mut table = vec![head("", 0), head("per kN or kN·m", 1)];
    table.extend(lines.into_iter().map(|(name, cells)| [name].into_iter().chain(cells).collect()));
    format!("\n{}", aligned(&table))
}

/// Several rows as tables, each with the variable first and as many quantities as fit on a line.
fn blocks(report: &KinematicsReport) -> String {
    let unit = report.length_unit;
    let variable = |row: usize| shown(KinematicUnit::Length, unit, report.rows[row].variable);
    let first: Vec<String> = [report.variable.unwrap_or_default().to_owned(), unit.name().to_owned()]
        .into_iter()
        .chain((0..report.rows.len()).map(variable))
        .collect();
    let given = report.columns.iter().enumerate().filter(|(_, column)| column.missing.is_none());
    let shown_columns = given.map(|(i, column)| {
        let head = [column.name().replace('_', " "), column.unit.of_table(unit).0.to_owned()];
        let values =
            report.rows.iter().map(|row| shown(column.unit, unit, row.values.get(i).copied().flatten()));
        head.into_iter().chain(values).collect::<Vec<String>>()
    });
    let wide = |column: &[String]| column.iter().map(|cell| width(cell)).max().unwrap_or(0) + 2;
    let (mut out, mut block, mut used) = (String::new(), vec![first.clone()], wide(&first));
    let mut flush = |block: &[Vec<String>]| {
        let lines: Vec<Vec<String>> =
            (0..first.len()).map(|line| block.iter().map(|column| column[line].clone()).collect()).collect();
        if !out.is_empty() {
            out.push('\n');
        }
        out += &aligned(&lines);
    };
    for column in shown_columns {
        if block.len() > 1 && used + wide(&column) > columns() {
            flush(&block);
            (block, used) = (vec![first.clone()], wide(&first));
        }
        used += wide(&column);
        block.push(column);
    }
    flush(&block);
    out
}

/// Lines of cells in columns; numbers are aligned to the right.
fn aligned(lines: &[Vec<String>]) -> String {
    let count = lines.iter().map(Vec::len).max().unwrap_or(0);
    let cell = |line: &[String], i: usize| line.get(i).cloned().unwrap_or_default();
    let widths: Vec<usize> =
        (0..count).map(|i| lines.iter().map(|line| width(&cell(line, i))).max().unwrap_or(0)).collect();
    let mut out = String::new();
    for line in lines {
        let mut text = String::new();
        for (i, wide) in widths.iter().enumerate() {
            let cell = cell(line, i);
            let padding = " ".repeat(wide - width(&cell));
            text += &if i == 0 { cell + &padding } else { format!("  {padding}{cell}") };
        }
        out += text.trim_end();
        out.push('\n');
    }
    out
}
