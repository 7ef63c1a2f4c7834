//! Command `percuss mass`.

pub(crate) mod conditions;
pub(crate) mod contact_list;
mod part_names;
pub(crate) mod sensitivity;

use crate::args::{MassArgs, MassFormat};
use crate::commands::damp;
use crate::document::Document;
use crate::files::csv;
use crate::terminal::explanation::{estimate_ratio, motion_ratio};
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::report::{note, with_findings, write_diagnostics, write_json, write_out};
use crate::terminal::text::{number, triple, within_uncertainty};
use crate::terminal::units::ContactUnits;
use percuss_study::{
    DampingQuestion, MassOptions, MassQuestion, MassReport, Model, Status, StudyAdditions, WithAdditions,
    contact_names, requested_mass,
};

/// Runs the command.
pub fn run(args: &MassArgs) -> Result<(), Failure> {
    let model = args.model.load()?;
    args.requests.check()?;
    let damping = args.damping.checked()?;
    let is_list = args.contact.contact.at.as_deref() == Some(ALL_CONTACTS);
    if is_list && model.mechanism.find_contact(ALL_CONTACTS).is_err() {
        damping.map_or(Ok(()), |damping| damping.check_units(false))?;
        return show_all_contacts(args, &model, damping);
    }
    refuse_several_contacts(&model, args.contact.contact.at.as_deref(), "this command")?;
    if let (Some("link"), Ok(names)) =
        (args.contact.contact.missing(), contact_names(ALL_CONTACTS, &model.mechanism))
    {
        return Err(Failure::bad_input(format!(
            "--at: a contact of the model is required, one of {}; or --at all; or --link LINK, --point X,Y,Z and a normal",
            names.join(", ")
        )));
    }
    let contact = args.contact.question()?;
    damping.map_or(Ok(()), |damping| damping.check_units(contact.is_moment(&model.mechanism)))?;
    show(&model, &contact, damping, args.format, &args.requests, args.model.reading.strict)
}

/// Value of --at for all named contacts of a model.
const ALL_CONTACTS: &str = "all";

/// Writes the list of all named contacts; refuses requests about a single one.
fn show_all_contacts(
    args: &MassArgs,
    model: &Model,
    damping: Option<&DampingQuestion>,
) -> Result<(), Failure> {
    let single = [
        ("--expect", args.requests.expect.is_some()),
        ("--explain", args.requests.explain),
        ("--friction-thresholds", args.requests.friction_thresholds),
        ("--tolerance", !args.requests.tolerance.is_empty()),
    ];
    if let Some((flag, _)) = single.into_iter().find(|(_, is_given)| *is_given) {
        return Err(Failure::bad_input(format!("{flag}: it is about one contact; give its name by --at")));
    }
    contact_list::show(model, &args.contact.question()?, damping, args.format, args.model.reading.strict)
}

/// Refuses several contacts, which `percuss compare` evaluates.
pub fn refuse_several_contacts(model: &Model, at: Option<&str>, command: &str) -> Result<(), Failure> {
    let Some(at) = at else { return Ok(()) };
    match contact_names(at, &model.mechanism) {
        Err(why) => Err(Failure::bad_input(format!("--at {at}: {why}"))),
        Ok(names) if matches!(&names[..], [name] if name == at) => Ok(()),
        Ok(_) => Err(Failure::bad_input(format!(
            "--at {at}: {command} has one contact; percuss compare MODEL --at {at} has all of them"
        ))),
    }
}

/// Computes a result and writes it.
fn show(
    model: &Model,
    question: &MassQuestion,
    damping: Option<&DampingQuestion>,
    format: MassFormat,
    requested: &MassOptions,
    strict: bool,
) -> Result<(), Failure> {
    let report = with_findings(requested_mass(model, question, damping, requested), model)?;
    write(&report, requested, &StudyAdditions::default(), format, strict)
}

/// Writes a report with its findings, and compares it with the expected value. `additions`: further keys of the report in JSON.
pub fn write(
    report: &MassReport,
    requested: &MassOptions,
    additions: &StudyAdditions,
    format: MassFormat,
    strict: bool,
) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    let unanswered = requested.explain && report.explanation.is_none()
        || requested.tolerance().is_some() && report.tolerance.is_none();
    if unanswered {
        note("--explain and --tolerance: sensitivities require a single finite effective mass as the result");
    }
    if requested.friction_thresholds && report.friction_thresholds.is_none() {
        note("--friction-thresholds: the thresholds require a single finite effective mass as the result");
    }
    match format {
        MassFormat::Json => write_json(&WithAdditions { report, additions })?,
        MassFormat::Csv => {
            if report.damper.is_some() {
                note("CSV does not contain the damper; use --format text or json");
            }
            write_out(&csv::mass_row(report, &report.assumptions.set))?;
        }
        MassFormat::Text => write_out(&text(report, requested.expected()))?,
    }
    check_expected(report, requested)
}

/// Compares the result with the expected value, if there is one; a mismatch gives exit code 1.
pub fn check_expected(report: &MassReport, requested: &MassOptions) -> Result<(), Failure> {
    let tolerance = requested.expected_tolerance().unwrap_or(limits::DEFAULT_TOLERANCE);
    requested.expected().map_or(Ok(()), |expected| compare(report, expected, tolerance))
}

/// Compares the result with an expected value; a mismatch gives exit code 1.
fn compare(report: &MassReport, expected: f64, tolerance: f64) -> Result<(), Failure> {
    match report.effective_mass {
        Some(m) if (m / expected - 1.0).abs() <= tolerance => Ok(()),
        Some(m) => Err(Failure::NoAnswer(format!(
            "the effective mass {m} {unit} differs from the expected {expected} {unit} (relative difference {:.1e}, \
             tolerance {tolerance:e})",
            (m / expected - 1.0).abs(),
            unit = report.unit
        ))),
        None => Err(Failure::NoAnswer(format!(
            "{expected} {} was expected; the contact is {}",
            report.unit,
            report.status.name()
        ))),
    }
}

/// Report as text.
fn text(report: &MassReport, expected: Option<f64>) -> String {
    let mut out = Document::default();
    let expected = expected.zip(report.effective_mass).map(|(expected, m)| {
        let off = (m / expected - 1.0).abs();
        ("expected", format!("{} {}   (relative difference {off:.1e})", number(expected), report.unit))
    });
    let name = ContactUnits::new(report.contact.is_moment).name;
    out.facts([(name, headline(report))].into_iter().chain(expected));
    out.facts(conditions::facts(report));
    add_estimate(report, &mut out);
    out.facts(report.damper.iter().flat_map(damp::facts));
    add_contributions(report, &mut out);
    add_explanation(report, &mut out);
    let forces = match &report.damper {
        None => {
            "Gravity, springs, dampers and speed have no effect: a finite force does no work in an instantaneous impact."
        }
        Some(_) => {
            "Gravity, springs, dampers and speed have no effect on the effective mass; the damper is that of the contact alone."
        }
    };
    out.paragraph(format!(
        "Not included: friction, compliance of the links, several impacts at once.\n{forces} See docs/explanation/LIMITS.md."
    ));
    report.damper.iter().for_each(|damper| damp::add_exports(damper, &mut out));
    out.text()
}

/// Sections of a page about a contact: conditions, contributions, estimate, motion ratios, sensitivities, tolerances.
pub fn document(report: &MassReport) -> Document<'_> {
    let mut out = Document::default();
    out.section("Contact and conditions");
    match report.point_in_sheet.as_ref().filter(|_| !report.contact.is_moment) {
        Some(contact) => out.facts(part_names::facts(report, contact)),
        None => out.facts(conditions::conditions(report).into_iter().chain([conditions::method(report)])),
    }
    add_contributions(report, &mut out);
    add_estimate(report, &mut out);
    if !report.motion_ratios.is_empty() {
        out.section("Motion ratios");
        out.facts(report.motion_ratios.iter().map(|ratio| (ratio.link.clone(), motion_ratio(ratio))));
    }
    add_explanation(report, &mut out);
    out
}

/// Adds the sensitivities and the effects of the tolerances.
fn add_explanation<'a>(report: &'a MassReport, out: &mut Document<'a>) {
    if let Some(explained) = &report.explanation {
        sensitivity::add_sensitivities(explained, report.unit, report.point_in_sheet.is_some(), out);
    }
    if let Some(tolerances) = &report.tolerance {
        sensitivity::add_tolerances(tolerances, report.unit, out);
    }
}

/// m̄, or the outcome in words.
pub fn headline(report: &MassReport) -> String {
    match (report.status, report.effective_mass) {
        (Status::Immovable, _) if report.contact.is_moment => {
            "immovable: no motion of the mechanism turns the link about this axis".into()
        }
        (Status::Massless, _) if report.contact.is_moment => {
            "massless (0 kg·m²): a motion without mass turns the link about this axis".into()
        }
        (Status::Immovable, _) => "immovable: no motion of the mechanism closes this gap".into(),
        (Status::Massless, _) => "massless (0 kg): a motion without mass closes this gap".into(),
        (Status::Finite, m) => {
            let mass = m.unwrap_or_default();
            match &report.tolerance {
                Some(tolerance) if tolerance.root_sum_square > 0.0 => {
                    let spread = tolerance.root_sum_square;
                    let [mass, spread] = [mass, spread].map(|x| within_uncertainty(x, spread));
                    format!("{mass} ± {spread} {} (tolerances, root sum square)", report.unit)
                }
                _ => format!("{} {}", number(mass), report.unit),
            }
        }
    }
}

/// Adds the classical estimate, its error, and the contributions that it leaves out.
fn add_estimate(report: &MassReport, out: &mut Document<'_>) {
    let Some(record) = &report.estimate else { return };
    out.section("The classical estimate");
    let first = &record.links[0];
    let Some(estimate) = record.estimate else {
        let none = format!("none: the speed of the point on {first} is undetermined");
        return out.facts([("estimate", none)]);
    };
    let off =
        record.error_percent.map_or_else(String::new, |p| format!("   ({:+.2} %)", without_rounding(p)));
    let links = record.links.join(", ");
    let share = record.share_left_out.map(|share| {
        let percent = without_rounding(100.0 * share);
        ("  leaves out", format!("{percent:.2} % of the effective mass, contributed by other links"))
    });
    let facts = [
        ("estimate m_K/l²", format!("{} kg{off}", number(estimate))),
        (
            "  takes",
            format!("{} kg of {links}, at {} m of {first}", number(record.mass), triple(&record.point_link)),
        ),
        ("  motion ratio", estimate_ratio(record)),
    ];
    out.facts(facts.into_iter().chain(share));
}

/// Percentage in which a value that rounds to zero has no sign.
fn without_rounding(percent: f64) -> f64 {
    if percent.abs() < limits::ESTIMATE_ROUNDING { 0.0 } else { percent }
}

/// Adds the contribution of each link, largest first; negligible ones are counted.
fn add_contributions(report: &MassReport, out: &mut Document<'_>) {
    if report.effective_mass.is_none() {
        return;
    }
    let links = report.bodies.iter().filter_map(|b| Some((b.link.clone(), b.share?)));
    let rotors = report.rotors.iter().filter_map(|r| Some((format!("rotor of {}", r.joint), r.share?)));
    let other = report.other_mass_share.map(|share| ("the other body".to_owned(), share));
    let mut shown: Vec<(String, f64)> = links.chain(rotors).chain(other).collect();
    shown.sort_by(|a, b| b.1.total_cmp(&a.1));
    let all = shown.len();
    shown.retain(|(_, share)| share.abs() >= limits::MIN_CONTRIBUTION);
    out.section("Contribution of each link");
    let rest = all - shown.len();
    out.shares(shown);
    if rest > 0 {
        out.note(format!("  and {rest} of less than {} %", 100.0 * limits::MIN_CONTRIBUTION));
    }
}
