//! `percuss mass --at all`: the named contacts of a model in one table.

use crate::args::MassFormat;
use crate::document::Document;
use crate::files::csv;
use crate::terminal::explanation::body_of;
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_json, write_out, write_text};
use crate::terminal::text::{Table, TableCell};
use percuss_study::{
    ContactListReport, DampingQuestion, ListedContact, MassQuestion, MassReport, Model, NamedContactRecord,
    contact_list,
};
use percuss_suspension::LengthUnit;

/// Evaluates all named contacts and writes the result.
pub fn show(
    model: &Model,
    conditions: &MassQuestion,
    damping: Option<&DampingQuestion>,
    format: MassFormat,
    strict: bool,
) -> Result<(), Failure> {
    write(&contact_list(model, conditions, damping)?, format, strict)
}

/// Writes a list of contacts.
pub fn write(report: &ContactListReport, format: MassFormat, strict: bool) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    match format {
        MassFormat::Json => write_json(report),
        MassFormat::Csv => write_out(&table_as_csv(report)),
        MassFormat::Text => write_text(&document(report).text()),
    }
}

/// Named contact of a result.
fn named(contact: &ListedContact) -> Option<&NamedContactRecord> {
    contact.report.as_ref()?.named_contact.as_ref()
}

/// Numbers of a contact: m̄ (kg), gap (m; as drawn for a stop that was brought to the touch), wheel
/// travel at the pose of the result (m), closing of the contact per wheel travel, damping coefficient (N·s/m).
fn numbers(contact: &ListedContact) -> [Option<f64>; 5] {
    let report = contact.report.as_ref();
    let named = named(contact);
    // A contact without a gap is evaluated at the pose of the question, which has its own travel.
    let travel = named.filter(|named| named.gap.is_some()).and_then(|named| named.wheel_travel.first());
    let ratio = |report: &MassReport| report.motion_ratios.first()?.contact_per_wheel;
    [
        report.and_then(|report| report.effective_mass),
        named.and_then(|named| if named.brought_to_touch { named.gap_as_drawn } else { named.gap }),
        travel.map(|wheel| wheel.travel),
        report.and_then(ratio),
        report.and_then(|report| report.damper.as_ref()?.damper.damping),
    ]
}

/// Table of masses, gaps, wheel travels and motion ratios.
fn mass_table(report: &ContactListReport) -> Table {
    let unit = report.contacts.iter().find_map(named).map_or(LengthUnit::Millimetre, |named| named.unit);
    let [gap, travel] = ["gap", "wheel travel"].map(|name| format!("{name}, {}", unit.name()));
    let mut table = Table::new(["contact", "m̄, kg", &gap, &travel, "motion ratio", "on"]);
    // The unit is in the header.
    let length =
        |x: Option<f64>| x.map_or("–".to_owned(), |x| format!("{:.*}", unit.decimals(), unit.of_metres(x)));
    for contact in &report.contacts {
        let [mass, gap, travel, ratio, _] = numbers(contact);
        let mass = match (&contact.report, mass) {
            (_, Some(mass)) => TableCell::from(mass),
            (Some(report), None) => report.status.name().into(),
            (None, None) => "none".into(),
        };
        let on = named(contact).map_or_else(|| "–".to_owned(), body_of);
        let ratio = TableCell::from(ratio);
        table.row([
            contact.name.clone().into(),
            mass,
            length(gap).into(),
            length(travel).into(),
            ratio,
            on.into(),
        ]);
    }
    table
}

/// Table of dampers, with the reason for a missing one; empty without dampers. No damper is chosen for an impact at parts that always
/// touch.
fn damper_table(report: &ContactListReport) -> Table {
    let is_requested = report.contacts.iter().any(|contact| numbers(contact)[4].is_some());
    let mut dampers = Table::new(["contact", "damping, N·s/m"]);
    for contact in report.contacts.iter().filter(|_| is_requested) {
        let cell = match (named(contact), numbers(contact)) {
            (Some(named), _) if named.always_touches() => "none: its parts always touch".into(),
            (_, [.., Some(damping)]) => TableCell::from(damping),
            (_, [None, ..]) => "none: no effective mass".into(),
            _ => "none".into(),
        };
        dampers.row([contact.name.clone().into(), cell]);
    }
    dampers
}

/// Table of the effect of bushes and gears; empty for a model without them.
fn compliance_table(report: &ContactListReport) -> Table {
    let found = |contact: &ListedContact| contact.report.as_ref()?.compliance.clone();
    let judges = report.contacts.iter().filter_map(found).any(|found| found.contact.is_some());
    let last = if judges { "m_imp, kg" } else { "rigid within 1 % up to, N/mm" };
    let mut table = Table::new(["contact", "bushes free, kg", "residual stiffness, N/mm", last]);
    for contact in &report.contacts {
        let Some(found) = found(contact) else { continue };
        let free = found.free_mass.map_or_else(|| found.free_status.name().into(), TableCell::from);
        let up_to = found.rigid_up_to.map(|[one, _]| 1e-3 * one);
        let impact = found.contact.and_then(|contact| contact.impact);
        table.row([
            contact.name.clone().into(),
            free,
            TableCell::from(found.residual_stiffness.map(|stiffness| 1e-3 * stiffness)),
            TableCell::from(if judges { impact.map(|impact| impact.impulse_mass) } else { up_to }),
        ]);
    }
    table
}

/// Tables of masses, dampers and compliance, the meaning of their columns, and the reasons of missing results.
pub fn document(report: &ContactListReport) -> Document<'_> {
    let mut out = Document::default();
    out.table(mass_table(report));
    out.table(damper_table(report));
    out.table(compliance_table(report));
    out.paragraph(explanation(report));
    for contact in &report.contacts {
        if let Some(problem) = &contact.problem {
            out.problem(format!("{}: {problem}", contact.name));
        }
    }
    out
}

/// Reason for a missing motion ratio.
pub const NO_MOTION_RATIO: &str = "No motion ratio is given if more than the wheel can move, such as the other wheel of an axle: \
                                   percuss sweep --heave or --roll gives the ratio per travel of both wheels, \
                                   percuss kinematics all ratios.";

/// Meaning of the columns.
fn explanation(report: &ContactListReport) -> String {
    let mut out = String::new();
    let all = || report.contacts.iter().filter_map(named);
    out += if all().any(|named| named.brought_to_touch) || all().all(|named| named.gap.is_none()) {
        "A stop is evaluated at the touch: \"gap\" is the gap in the design position, \"wheel travel\" the upward travel of the wheel at the \
         touch. A contact without a gap is evaluated in the design position, unless a pose is given."
    } else {
        "All contacts are evaluated at the given pose: \"gap\" is the gap there, negative for parts that overlap."
    };
    out += "\nMotion ratio: contact per wheel travel (upward), negative for a contact that closes while the wheel moves down.";
    let has_no_ratio = |contact: &ListedContact| {
        contact.report.as_ref().and_then(|report| report.effective_mass).is_some()
            && numbers(contact)[3].is_none()
    };
    let ratios = report.contacts.iter().filter_map(|contact| contact.report.as_ref());
    let held = ratios.flat_map(|report| &report.motion_ratios).find_map(|ratio| ratio.held.as_ref());
    if let Some(joint) = held {
        out += &format!("\nThe ratio is given with the joint {joint} held, which moves in the impact.");
    }
    if report.contacts.iter().any(has_no_ratio) && all().any(|named| !named.wheel_travel.is_empty()) {
        out += &format!("\n{NO_MOTION_RATIO}");
    }
    out
}

/// The list as CSV.
fn table_as_csv(report: &ContactListReport) -> String {
    let header = [
        "contact",
        "kind",
        "status",
        "effective_mass",
        "gap_as_drawn_mm",
        "wheel_travel_mm",
        "motion_ratio",
        "damping",
        "on",
    ];
    let compliance = |contact: &ListedContact| contact.report.as_ref()?.compliance.clone();
    let is_elastic = report.contacts.iter().any(|contact| compliance(contact).is_some());
    let further = ["free_mass", "residual_stiffness"].into_iter().filter(|_| is_elastic);
    let header: Vec<String> = header.into_iter().chain(further).map(str::to_owned).collect();
    let mut out = csv::line(&header);
    for contact in &report.contacts {
        let status = contact.report.as_ref().map_or("none", |report| report.status.name());
        let mut cells = vec![contact.name.clone(), contact.kind.to_owned(), status.to_owned()];
        let [mass, gap, travel, ratio, damping] = numbers(contact);
        let [gap, travel] = [gap, travel].map(|length| length.map(|x| 1e3 * x));
        cells.extend([mass, gap, travel, ratio, damping].map(csv::cell));
        cells.push(named(contact).map_or_else(String::new, body_of));
        if is_elastic {
            let found = compliance(contact);
            let free = found.as_ref().and_then(|found| found.free_mass);
            cells.extend([free, found.and_then(|found| found.residual_stiffness)].map(csv::cell));
        }
        out += &csv::line(&cells);
    }
    out
}
