//! Tables as a workbook (ECMA-376): the table of the CSV on one sheet.

use crate::files::csv::{Cell, SweepTable};
use crate::files::output::write_file;
use crate::files::table_style::TableStyle;
use crate::terminal::failure::Failure;
use indicatif::ProgressBar;
use percuss_render::MADE_BY;
use percuss_study::{Model, Sweep, SweepEnd};
use rust_xlsxwriter::{DocProperties, Format, Workbook, Worksheet, XlsxError};
use std::ops::ControlFlow;

/// Largest number of rows of a sheet, including the row of column names.
const MAX_ROWS: usize = 1 << 20;
/// Largest number of columns of a sheet.
const MAX_COLUMNS: usize = 1 << 14;
/// Largest number of cells of a workbook; a cell takes some 160 bytes of memory.
const MAX_CELLS: usize = 5_000_000;

/// Writes the rows of a sweep as XLSX. All rows stay in memory until the workbook is saved.
pub fn write(
    sweep: Sweep,
    model: &Model,
    style: TableStyle,
    path: &str,
    bar: &ProgressBar,
) -> Result<SweepEnd, Failure> {
    let table = SweepTable::new(sweep.heading(), &model.mechanism, style);
    let (columns, rows) = (table.names().len(), sweep.count());
    if columns > MAX_COLUMNS || rows.is_some_and(|rows| rows >= MAX_ROWS) {
        let rows = rows.map_or_else(String::new, |rows| format!("{rows} rows, "));
        return Err(Failure::output(
            path,
            format!(
                "{rows}{columns} columns; a sheet has at most {} rows and {MAX_COLUMNS} columns; write .csv or \
             .parquet",
                MAX_ROWS - 1
            ),
        ));
    }
    check_cells(path, rows.unwrap_or(0), columns)?;
    let unwritten = |error: XlsxError| xlsx_failure(path, &error);
    let mut workbook = new_workbook("sweep", table.names()).map_err(unwritten)?;
    let sheet = workbook.worksheet_from_index(0).map_err(unwritten)?;
    let mut written = Ok(());
    let end = sweep.run(&mut |row| {
        bar.inc(1);
        let line = row.row as u32 + 1;
        written = write_cells(sheet, line, table.cells(&row));
        if written.is_err() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    written.map_err(unwritten)?;
    write_file(path, &workbook.save_to_buffer().map_err(unwritten)?)?;
    Ok(end)
}

/// Workbook with one sheet that contains a table.
pub fn workbook(
    path: &str,
    name: &str,
    columns: &[String],
    rows: Vec<Vec<Cell>>,
) -> Result<Vec<u8>, Failure> {
    if columns.len() > MAX_COLUMNS || rows.len() >= MAX_ROWS {
        return Err(Failure::output(
            path,
            format!(
                "{} rows, {} columns; a sheet has at most {} rows and {MAX_COLUMNS} columns; write .csv",
                rows.len(),
                columns.len(),
                MAX_ROWS - 1
            ),
        ));
    }
    check_cells(path, rows.len(), columns.len())?;
    let unwritten = |error: XlsxError| xlsx_failure(path, &error);
    let mut workbook = new_workbook(name, columns).map_err(unwritten)?;
    let sheet = workbook.worksheet_from_index(0).map_err(unwritten)?;
    for (line, cells) in (1..).zip(rows) {
        write_cells(sheet, line, cells).map_err(unwritten)?;
    }
    workbook.save_to_buffer().map_err(unwritten)
}

/// Refuses a table that would not fit into memory: a workbook stays in memory until the last row is written.
fn check_cells(path: &str, rows: usize, columns: usize) -> Result<(), Failure> {
    let cells = rows.saturating_mul(columns);
    if cells <= MAX_CELLS {
        return Ok(());
    }
    Err(Failure::output(
        path,
        format!(
            "{rows} rows of {columns} columns are {cells} cells; a workbook is written with at most {MAX_CELLS}; \
         write .csv or .parquet"
        ),
    ))
}

/// Failure of writing a workbook.
fn xlsx_failure(path: &str, error: &XlsxError) -> Failure {
    Failure::bad_input(format!("{path} cannot be written: {error}"))
}

/// New workbook with one sheet and its row of column names.
fn new_workbook(name: &str, columns: &[String]) -> Result<Workbook, XlsxError> {
    let mut workbook = Workbook::new();
    // Fixed date: the same query gives the same file.
    let dated = rust_xlsxwriter::ExcelDateTime::from_ymd(2000, 1, 1)?;
    workbook.set_properties(&DocProperties::new().set_author(MADE_BY).set_creation_datetime(&dated));
    let sheet = workbook.add_worksheet();
    sheet.set_name(name)?;
    let heading = Format::new().set_bold();
    for (column, name) in (0..).zip(columns) {
        // Written as text, even if the name begins like a formula.
        sheet.write_string_with_format(0, column, name, &heading)?;
    }
    sheet.set_freeze_panes(1, 0)?;
    Ok(workbook)
}

/// Writes the cells of a row.
fn write_cells(sheet: &mut Worksheet, line: u32, cells: Vec<Cell>) -> Result<(), XlsxError> {
    for (column, cell) in (0..).zip(cells) {
        match cell {
            Cell::Number(x) => sheet.write_number(line, column, x)?,
            Cell::Text(text) => sheet.write_string(line, column, text)?,
            Cell::Logical(value) => sheet.write_boolean(line, column, value)?,
            Cell::Empty => continue,
        };
    }
    Ok(())
}
