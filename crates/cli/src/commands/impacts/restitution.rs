//! Command `percuss restitution`.

use crate::args::{CheckFormat, RestitutionArgs};
use crate::commands::damp::stiffness_text;
use crate::document::{self, Document};
use crate::terminal::explanation::named_contact;
use crate::terminal::failure::Failure;
use crate::terminal::number::{number, upper_bound};
use crate::terminal::report::{with_findings, write_diagnostics};
use crate::terminal::text::Table;
use crate::terminal::units::ContactUnits;
use percuss_study::{ReboundRecord, RestitutionReport, restitution, restitution_at};

/// Runs the command.
pub fn run(args: &RestitutionArgs) -> Result<(), Failure> {
    args.restitution.check()?;
    let report = match (args.mass, &args.model) {
        (Some(_), _) if args.contact.is_given() => {
            return Err(Failure::bad_input("--mass: the contact of a model is given too; remove one"));
        }
        (Some(mass), _) => restitution(&args.restitution, mass.0)?,
        (None, path) => {
            let (question, model) =
                (args.contact.question()?, args.reading.load(path.as_deref().unwrap_or_default())?);
            with_findings(restitution_at(&model, &question, &args.restitution), &model)?
        }
    };
    show(&report, args.format, args.reading.strict)
}

/// Writes the warnings and the report.
pub fn show(report: &RestitutionReport, format: CheckFormat, strict: bool) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    document::print(report, format, || document(report))
}

/// Effective mass, penetrations at rest, and the table of the impacts.
pub fn document(report: &RestitutionReport) -> Document<'_> {
    let mut out = Document::default();
    let contact = report.named_contact.as_ref().map_or_else(Vec::new, named_contact);
    let mut facts = vec![("effective mass", format!("{} kg", number(report.effective_mass)))];
    facts.extend(contact);
    facts.extend(
        report
            .stiffness_curve
            .as_ref()
            .map(|curve| ("stiffness", stiffness_text(None, None, Some(curve), &ContactUnits::new(false)))),
    );
    facts.extend(report.tool.iter().map(|tool| ("simulator", tool.clone())));
    for rest in &report.at_rest {
        let depth = rest
            .penetration
            .map_or("none, the contact is rigid".to_owned(), |x| format!("{} mm", number(1e3 * x)));
        let solver = if rest.solver.is_empty() { String::new() } else { format!(" ({})", rest.solver) };
        facts.push(("at rest", format!("{depth} under {} N{solver}", number(rest.load))));
    }
    out.facts(facts);
    out.table(table(report));
    out
}

/// Table of the impacts, without columns that have no value.
fn table(report: &RestitutionReport) -> Table {
    type Column = (&'static str, fn(&ReboundRecord) -> Option<String>);
    let columns: [Column; 8] = [
        ("solver", |row| Some(row.solver.to_owned()).filter(|name| !name.is_empty())),
        ("speed m/s", |row| Some(number(row.speed))),
        ("restitution", |row| Some(number(row.restitution))),
        ("within", |row| row.error_bound.map(upper_bound)),
        ("lasts ms", |row| row.contact_duration.map(|t| number(1e3 * t))),
        ("compression mm", |row| row.max_penetration.map(|x| number(1e3 * x))),
        ("peak N", |row| row.peak_force.map(number)),
        ("energy lost J", |row| Some(number(row.energy_lost))),
    ];
    let filled = columns.into_iter().filter(|(_, text)| report.impacts.iter().any(|row| text(row).is_some()));
    let filled: Vec<Column> = filled.collect();
    let header = filled.iter().map(|(name, _)| (*name).to_owned()).collect::<Vec<_>>();
    let row = |row| filled.iter().map(|(_, text)| text(row).unwrap_or_else(|| "–".to_owned())).collect();
    Table::from_rows([header].into_iter().chain(report.impacts.iter().map(row)))
}
