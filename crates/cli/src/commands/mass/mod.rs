//! Command `percuss mass`.

pub(crate) mod certificate;
pub(crate) mod compliance;
pub(crate) mod conditions;
pub(crate) mod contact_list;
pub(crate) mod sensitivity;

use crate::args::{MassArgs, MassFormat};
use crate::commands::damp;
use crate::document::Document;
use crate::files::csv;
use crate::terminal::console;
use crate::terminal::explanation::{both_stops, estimate_ratio, motion_ratio};
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::number::{fixed, number, signed, triple, with_unit, within_uncertainty};
use crate::terminal::report::{
    details_are_shown, note, with_findings, write_diagnostics, write_json, write_out, write_text,
};
use crate::terminal::text::{Table, TableCell};
use percuss_study::{
    DampingQuestion, MassOptions, MassQuestion, MassReport, Model, Status, StudyAdditions, WithAdditions,
    contact_names, requested_mass,
};

/// Runs the command.
pub fn run(args: &MassArgs) -> Result<(), Failure> {
    let model = args.model.load()?;
    args.requests.check()?;
    let damping = args.damping.checked_for_mass()?;
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
        ("--normal", args.contact.contact.normal.is_some()),
        ("--expect", args.requests.expect.is_some()),
        ("--certify", args.requests.certify),
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
    write(&report, requested, &StudyAdditions::default(), (format, strict), &hints(&report, requested))
}

/// Writes a report with its findings, and compares it with the expected value. `additions`: further keys of the report in JSON; `hints`:
/// last line of the text.
pub fn write(
    report: &MassReport,
    requested: &MassOptions,
    additions: &StudyAdditions,
    (format, strict): (MassFormat, bool),
    hints: &str,
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
            if report.certificate.is_some() {
                note("CSV does not contain the proved bounds; use --format text or json");
            }
            write_out(&csv::mass_row(report, &report.assumptions.set))?;
        }
        MassFormat::Text => write_text(&text(report, requested, hints))?,
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

/// Report as text: m̄ with its place, its parts, further results, and one line of conditions. `hints`: flags of `percuss mass`.
fn text(report: &MassReport, requested: &MassOptions, hints: &str) -> String {
    let mut out = Document::default();
    let (value, meaning) = main_result(report);
    out.results([(value, meaning + &conditions::place(report))]);
    let expected = requested.expected().zip(report.effective_mass).map(|(expected, m)| {
        let off = (m / expected - 1.0).abs();
        ("expected", format!("{} {}   (relative difference {off:.1e})", number(expected), report.unit))
    });
    let together = report.named_contact.as_ref().and_then(both_stops);
    let thresholds = report.friction_thresholds.as_ref();
    let thresholds = thresholds.map(|found| ("friction", conditions::thresholds_text(found)));
    out.facts(expected.into_iter().chain(together).chain(thresholds));
    out.facts(certificate::facts(report));
    out.facts(conditions::other_base(report));
    out.facts(compliance::facts(report));
    contributions(report, usize::MAX).into_iter().for_each(|table| out.table(table));
    add_estimate(report, &mut out);
    report.damper.iter().for_each(|damper| damp::add_results(damper, &mut out));
    add_explanation(report, &mut out);
    if details_are_shown() {
        out.facts(conditions::facts(report));
        out.remark(
            "Gravity, springs, dampers and speed have no effect on the effective mass: a finite force does no work in an instantaneous impact. See \
             docs/explanation/EFFECTIVE_MASS.md.",
        );
    } else {
        out.remark(conditions::summary(report));
    }
    out.note(hints);
    report.damper.iter().for_each(|damper| damp::add_exports(damper, &mut out));
    out.text()
}

/// Flags of `percuss mass` that show more about a result, in at most two lines; only on a terminal.
fn hints(report: &MassReport, requested: &MassOptions) -> String {
    if !console::stdout().is_terminal() {
        return String::new();
    }
    let is_finite = report.effective_mass.is_some();
    let tolerance = if report.point_in_sheet.is_some() { "mass=2%,point=0.5mm" } else { "mass=2%,com=1mm" };
    let mut flags = Vec::new();
    if is_finite && !requested.explain {
        flags.push("--explain (what changes it)".to_owned());
    }
    if !details_are_shown() {
        flags.push("--details (points, axes, joints)".to_owned());
    }
    if is_finite && requested.tolerance().is_none() {
        flags.push(format!("--tolerance {tolerance} (how sure it is)"));
    }
    let [first @ .., last] = &flags[..] else { return String::new() };
    match first {
        [] => format!("next: {last}"),
        first => format!("next: {}\n      {last}", first.join("   ")),
    }
}

/// Sections of a page about a contact: conditions, contributions, estimate, motion ratios, sensitivities, tolerances.
pub fn document(report: &MassReport) -> Document<'_> {
    let mut out = Document::default();
    out.section("Contact and conditions");
    match report.point_in_sheet.as_ref().filter(|_| !report.contact.is_moment) {
        Some(contact) => out.facts(conditions::facts_in_sheet(report, contact)),
        None => out.facts(conditions::conditions(report).into_iter().chain([conditions::method(report)])),
    }
    out.facts(certificate::facts(report));
    out.facts(conditions::other_base(report));
    if report.compliance.is_some() {
        out.section("Bushes");
        out.facts(compliance::facts(report));
    }
    if let Some(table) = contributions(report, usize::MAX) {
        out.section("Share of m̄");
        out.table(table);
    }
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

/// Value of m̄ with its tolerance, or the outcome, and the begin of its meaning.
fn main_result(report: &MassReport) -> (String, String) {
    let is_moment = report.contact.is_moment;
    let (does, gap) = if is_moment { ("turns the link", "about this axis") } else { ("closes", "this gap") };
    match (report.status, report.effective_mass) {
        (Status::Immovable, _) => {
            ("immovable".to_owned(), format!("no motion of the mechanism {does} {gap}\n"))
        }
        (Status::Massless, _) => {
            (format!("massless (0 {})", report.unit), format!("a motion without mass {does} {gap}\n"))
        }
        (Status::Finite, m) => (mass_text(report, m.unwrap_or_default()), String::new()),
    }
}

/// m̄ with its unit, and with the effect of the tolerances.
pub fn mass_text(report: &MassReport, mass: f64) -> String {
    match &report.tolerance {
        Some(tolerance) if tolerance.root_sum_square > 0.0 => {
            let spread = tolerance.root_sum_square;
            let [mass, spread] = [mass, spread].map(|x| within_uncertainty(x, spread));
            format!("{mass} ± {spread} {}", report.unit)
        }
        _ => with_unit(mass, report.unit),
    }
}

/// First line of the text: m̄, or the outcome, with its place.
pub fn first_line(report: &MassReport) -> String {
    let (value, meaning) = main_result(report);
    let meaning = meaning + &conditions::place(report);
    format!("{value}  {}", meaning.lines().next().unwrap_or_default())
}

/// m̄, or the outcome in words.
pub fn headline(report: &MassReport) -> String {
    match main_result(report) {
        (value, meaning) if meaning.is_empty() => value,
        (value, meaning) => format!("{value}: {}", meaning.trim_end()),
    }
}

/// Adds the classical estimate, its error, and the contributions that it leaves out.
pub fn add_estimate(report: &MassReport, out: &mut Document<'_>) {
    let Some(record) = &report.estimate else { return };
    out.section("The classical estimate");
    let first = &record.links[0];
    let Some(estimate) = record.estimate else {
        let none = format!("none: the speed of the point on {first} is undetermined");
        return out.facts([("estimate", none)]);
    };
    let off = record.error_percent.map_or_else(String::new, |p| format!("   ({} %)", signed(p, 2)));
    let links = record.links.join(", ");
    let share = record.share_left_out.map(|share| {
        (
            "  leaves out",
            format!("{} % of the effective mass: the share of other links", fixed(100.0 * share, 2)),
        )
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

/// Mass of all links that move in the impact, kg; `None` without shares.
pub fn moving_mass(report: &MassReport) -> Option<f64> {
    let moves = |share: Option<f64>| share.is_some_and(|share| share != 0.0);
    let masses = report.bodies.iter().filter(|body| moves(body.share)).map(|body| body.mass);
    report.effective_mass.map(|_| masses.sum())
}

/// Table of the parts of m̄: mass, part and share of each link, rotor and other body, at most `most`. The others, and parts of less than
/// [`limits::MIN_CONTRIBUTION`], are one row. `None` without a finite m̄.
pub fn contributions(report: &MassReport, most: usize) -> Option<Table> {
    let m = report.effective_mass?;
    let links = report.bodies.iter().filter_map(|b| Some((b.link.clone(), Some(b.mass), b.share?)));
    let rotors = report.rotors.iter().filter_map(|r| Some((format!("rotor of {}", r.joint), None, r.share?)));
    let other = report.other_mass_share;
    let other = other.map(|share| ("the other body".to_owned(), report.conditions.against_mass, share));
    let mut parts: Vec<(String, Option<f64>, f64)> =
        links.chain(rotors).chain(other).filter(|(.., share)| *share != 0.0).collect();
    parts.sort_by(|a, b| b.2.total_cmp(&a.2));
    let sum = |parts: &[(String, Option<f64>, f64)]| {
        let masses = parts.iter().filter_map(|(_, mass, _)| *mass);
        let mass = parts.iter().any(|(_, mass, _)| mass.is_some()).then(|| masses.sum());
        (mass, parts.iter().map(|(.., share)| share).sum::<f64>())
    };
    let all = sum(&parts);
    let is_shown = |(.., share): &(String, Option<f64>, f64)| share.abs() >= limits::MIN_CONTRIBUTION;
    let count = parts.iter().take_while(|part| is_shown(part)).count().min(most);
    let rest = parts.split_off(count);
    let mut shown = parts;
    if !rest.is_empty() {
        let (mass, share) = sum(&rest);
        shown.push((format!("{} others", rest.len()), mass, share));
    }
    let bars: Vec<f64> = shown.iter().map(|(.., share)| *share).collect();
    let mut table = Table::new(["link", "mass kg", &format!("m̄ {}", report.unit), "%"]);
    let mut row = |name: String, mass: Option<f64>, share: f64| {
        let numbers = [mass, Some(share * m), Some(100.0 * share)].map(TableCell::Part);
        let [mass, part, share] = numbers;
        table.row([name.into(), mass, part, share]);
    };
    let is_single = shown.len() < 2;
    shown.into_iter().for_each(|(name, mass, share)| row(name, mass, share));
    if is_single {
        return Some(table);
    }
    row("sum".to_owned(), all.0, all.1);
    Some(table.with_sum().with_bars(&bars))
}
