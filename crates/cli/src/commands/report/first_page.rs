//! First page of a report: a sentence, the main numbers, the drawing, the parts of m̄, its curve, and the changes that lower it.

use super::contact::uncertainty_words;
use super::results::StudyResults;
use crate::commands::damp::{self, law_name};
use crate::commands::impacts::in_time::{energy_lost, energy_name, forces_figure};
use crate::commands::impacts::rigid_impact::bearings;
use crate::commands::mass::conditions::other_base;
use crate::commands::mass::{contributions, mass_text, moving_mass};
use crate::files::html::{MainNumber, Page};
use crate::pictures::mechanism::best_view;
use crate::terminal::limits;
use crate::terminal::number::{fixed, load, number, signed, triple, with_unit};
use crate::terminal::text::{Table, TableCell};
use crate::terminal::units::ContactUnits;
use percuss_render::Picture;
use percuss_study::{DampingReport, Explanation, ImpactReport, MassReport, Status};

/// Adds the sentence and the main numbers of a contact.
pub(super) fn add(results: &StudyResults, report: &MassReport, page: &mut Page) {
    page.sentence(&sentence(report));
    page.numbers(&numbers(results, report));
}

/// Adds the quadrants below the warnings, and the foot.
pub(super) fn add_quadrants(
    results: &StudyResults,
    report: &MassReport,
    foot: &[(&str, String)],
    page: &mut Page,
) {
    page.open_quadrants();
    page.open_quadrant(if is_at_touch(report) { "At the touch" } else { "The mechanism" });
    page.picture(&best_view(report, &results.mechanism).to_svg(), "The mechanism in its main plane", "");
    page.close_quadrant();
    if let Some(table) = contributions(report, limits::PARTS_ON_FIRST_PAGE) {
        let m = report.effective_mass.unwrap_or_default();
        page.open_quadrant(&format!("Where the {} come from", with_unit(m, report.unit)));
        page.table_with_bars(&table);
        page.close_quadrant();
    }
    if let Some(svg) = results.sweep.as_ref().and_then(|sweep| sweep.half_figure.as_ref()) {
        page.open_quadrant(&format!("Over the {}", results.sweep.as_ref().map_or("", |sweep| &sweep.varied)));
        page.picture(svg, "Effective mass over the varied quantity", "");
        page.close_quadrant();
    }
    // Without a curve, the bearings of an impact.
    let impact = results.report.impact.as_ref().filter(|impact| !impact.reactions.is_empty());
    if let (Some(impact), None) =
        (impact, results.sweep.as_ref().and_then(|sweep| sweep.half_figure.as_ref()))
    {
        let (table, note) = bearings(impact);
        page.open_quadrant("Loads of the bearings");
        page.table_with_bars(&table);
        page.paragraph("soft", &note);
        page.close_quadrant();
    }
    let lower = what_lowers(results, report);
    let instead = not_instead(results, report);
    if !lower.is_empty() || !instead.is_empty() {
        page.open_quadrant("What would lower it");
        if lower.is_empty() {
            page.paragraph("soft", "The study asks for no sensitivities and no variants.");
        } else {
            page.table_with_bars(&lower);
        }
        if !instead.is_empty() {
            page.heading("Do not use instead");
            page.table_with_bars(&instead);
        }
        page.close_quadrant();
    } else if let Some((impact, found)) =
        results.report.impact.as_ref().and_then(|impact| Some((impact, impact.in_time.as_ref()?)))
    {
        page.open_quadrant("Over the time of the impact");
        page.picture(&forces_figure(impact, found).to_svg(), "Forces over the time of the impact", "");
        page.close_quadrant();
    }
    page.close_quadrants(foot);
}

fn is_at_touch(report: &MassReport) -> bool {
    report.named_contact.as_ref().is_some_and(|contact| contact.brought_to_touch)
}

/// Name of a part in words.
fn in_words(name: &str) -> String {
    name.replace('_', " ")
}

/// Result as a sentence that can be read aloud.
fn sentence(report: &MassReport) -> String {
    let contact = report.named_contact.as_ref();
    let name = contact.map_or_else(|| in_words(&report.contact.link), |contact| in_words(&contact.name));
    let travel = contact.and_then(|contact| {
        let wheel = contact.wheel_travel.first().filter(|_| contact.gap.is_some())?;
        let side = if wheel.travel < 0.0 { "below" } else { "above" };
        let unit = contact.unit;
        Some(format!(
            "{} {} {side} the design position",
            number_of_length(unit.of_metres(wheel.travel.abs())),
            unit.name()
        ))
    });
    let place = match (is_at_touch(report), travel) {
        (true, Some(travel)) => format!("When the {name} touches, {travel}, the mechanism"),
        (true, None) => format!("When the {name} touches, the mechanism"),
        (false, Some(travel)) => format!("At the {name}, {travel}, the mechanism"),
        (false, None) => format!("At the {name}, the mechanism"),
    };
    let what = if report.contact.is_moment { "an inertia" } else { "a mass" };
    let m = match (report.status, report.effective_mass) {
        (Status::Finite, Some(m)) => m,
        (Status::Immovable, _) => {
            return format!("{place} gives way by no motion: **the contact is immovable**.");
        }
        _ => return format!("{place} moves without resistance: **the contact is massless**."),
    };
    let mut text = format!("{place} strikes like {what} of **{}**.", mass_text(report, m));
    let own = moving_mass(report).filter(|_| !report.contact.is_moment);
    let own = own.map(|own| format!("Its own mass is {} kg", number(own)));
    let ratio = report.motion_ratios.first().filter(|ratio| ratio.one_travel && ratio.held.is_none());
    let ratio = ratio.and_then(|ratio| ratio.contact_per_wheel).filter(|_| contact.is_some()).map(|r| {
        let only = if r.abs() < 1.0 { "only " } else { "" };
        format!("the contact moves {only}{} as far as the wheel", fixed(r.abs(), 3))
    });
    let rest: Vec<String> = own.into_iter().chain(ratio).collect();
    if !rest.is_empty() {
        text += &format!(" {}.", rest.join("; "));
    }
    if let Some((state, value)) = other_base(report) {
        text += &format!(" With the {}: {value}.", in_words(&state));
    }
    text
}

/// Length in a sentence: without decimals from ten on.
fn number_of_length(x: f64) -> String {
    if x >= 10.0 { fixed(x, 0) } else { fixed(x, 1) }
}

/// At most four main numbers of the questions of the study.
fn numbers(results: &StudyResults, report: &MassReport) -> Vec<MainNumber> {
    let mass = report.effective_mass.map(|m| MainNumber {
        label: format!(
            "{} m̄{}",
            ContactUnits::new(report.contact.is_moment).name,
            if is_at_touch(report) { " at the touch" } else { "" }
        ),
        value: mass_text(report, m),
        note: uncertainty_words(report),
    });
    let of_impact = results.report.impact.as_ref().map_or_else(Vec::new, impact_numbers);
    let damper = report.damper.as_ref().or(results.report.damping.as_ref());
    let of_damper = damper.map_or_else(Vec::new, |damper| damper_numbers(damper, of_impact.is_empty()));
    let mut numbers = Vec::new();
    // An impact begins with its peak force.
    let mut rest = of_impact.into_iter();
    numbers.extend(rest.next());
    numbers.extend(mass);
    numbers.extend(of_damper);
    numbers.extend(rest);
    if let Some(speeds) = &results.report.safe_speed {
        let slowest = crate::commands::impacts::safe_speed::slowest(speeds);
        numbers.push(MainNumber {
            label: "greatest safe speed".to_owned(),
            value: with_unit(slowest.reflected.speed, "m/s"),
            note: String::new(),
        });
    }
    numbers.truncate(limits::MAIN_NUMBERS);
    numbers
}

/// Peak force, then energy lost and impulse of an impact.
fn impact_numbers(report: &ImpactReport) -> Vec<MainNumber> {
    let ContactUnits { impulse, speed, force, small_length, .. } =
        ContactUnits::new(report.mass.contact.is_moment);
    let at = format!("at {} {speed}", number(report.closing_speed));
    let what = if report.mass.contact.is_moment { "moment" } else { "force" };
    let time = report.in_time.as_ref();
    let peak = time.map(|found| found.peak_force).or(report.contact_law.as_ref().map(|law| law.peak_force));
    let note = time.map_or_else(String::new, |found| {
        format!(
            "compression {} {small_length}, {}",
            number(1e3 * found.max_penetration),
            found
                .duration
                .map_or("no rebound".to_owned(), |t| format!("contact time {} ms", number(1e3 * t)))
        )
    });
    let peak =
        peak.map(|peak| MainNumber { label: format!("peak {what} {at}"), value: load(peak, force), note });
    let of_impulse = MainNumber {
        label: format!("impulse {at}"),
        value: with_unit(report.impulse, impulse),
        note: format!("restitution {}", number(report.restitution)),
    };
    let lost = MainNumber {
        label: format!("{} {at}", energy_name(report)),
        value: with_unit(energy_lost(report), "J"),
        note: String::new(),
    };
    peak.into_iter().chain([of_impulse, lost]).collect()
}

/// Damping, and with `has_impact` peak force and energy lost of the impact that the damper is designed for.
fn damper_numbers(report: &DampingReport, has_impact: bool) -> Vec<MainNumber> {
    let damper = &report.damper;
    let ContactUnits { length, force, speed, small_length, .. } = ContactUnits::new(report.is_moment);
    let k = if damper.stiffness.is_some() { "k = " } else { "" };
    let label = format!("damper for e = {}, {k}{}", number(damper.restitution), damp::stiffness(report));
    let d = damper.dissipation.map(|d| format!("{} s/{length}", number(d)));
    let first = match (damper.damping, d) {
        (Some(c), d) => {
            let hunt = d.map_or_else(String::new, |d| format!("; Hunt–Crossley {d}"));
            let power = damper.exponent.map_or(1.0, |p| 0.5 * (p + 1.0));
            let power = if power == 1.0 { String::new() } else { format!("^{}", number(power)) };
            let unit = format!("{force}·s/{length}{power}");
            MainNumber { label, value: load(c, &unit), note: format!("{}{hunt}", law_name(damper.law)) }
        }
        (None, Some(d)) => MainNumber { label, value: d, note: law_name(damper.law).to_owned() },
        (None, None) => match damper.loss_factor {
            Some(loss) => MainNumber { label, value: number(loss), note: law_name(damper.law).to_owned() },
            None => return Vec::new(),
        },
    };
    let mut numbers = vec![first];
    let Some(v) = damper.speed.filter(|_| has_impact) else { return numbers };
    let at = format!("at {} {speed}", number(v));
    let note = |x: Option<f64>, text: &dyn Fn(f64) -> String| x.map(text);
    if let Some(peak) = damper.peak_force {
        let parts = [
            note(damper.max_penetration, &|x| format!("compression {} {small_length}", number(1e3 * x))),
            note(damper.contact_duration, &|t| format!("contact time {} ms", number(1e3 * t))),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        numbers.push(MainNumber {
            label: format!("peak force {at}"),
            value: load(peak, force),
            note: parts.join(", "),
        });
    }
    if let Some(lost) = damper.energy_lost {
        let rebound = note(damper.rebound_speed, &|v| format!("rebound {} {speed}", number(v)));
        numbers.push(MainNumber {
            label: format!("energy lost {at}"),
            value: with_unit(lost, "J"),
            note: rebound.unwrap_or_default(),
        });
    }
    numbers
}

/// Changes that lower m̄: variants, then the largest rates.
fn what_lowers(results: &StudyResults, report: &MassReport) -> Table {
    let unit = report.unit;
    let mut table = Table::new(["change", &format!("m̄ {unit}"), "change", "%"]);
    let Some(m) = report.effective_mass else { return table };
    let mut row = |name: String, mass: f64| {
        let change = mass - m;
        let cells = [TableCell::Part(Some(mass)), TableCell::Part(Some(change))];
        let [mass, change_cell] = cells;
        table.row([name.into(), mass, change_cell, signed(100.0 * change / m, 1).into()]);
    };
    let compared = results.report.comparison.iter().flat_map(|compared| &compared.designs);
    let variants = compared.filter(|design| design.reference.is_some());
    let variants = variants.filter_map(|design| Some((design.name.clone(), design.effective_mass?)));
    for (name, mass) in variants.take(limits::VARIANTS_ON_FIRST_PAGE) {
        row(format!("{name} (variant)"), mass);
    }
    for (name, lowers_by) in report.explanation.iter().flat_map(largest_rates) {
        row(name, m - lowers_by);
    }
    table
}

/// The largest decreases of m̄ by one kilogram or one millimetre.
fn largest_rates(explained: &Explanation) -> Vec<(String, f64)> {
    let masses = explained
        .most_per_kilogram
        .iter()
        .map(|change| (format!("{} 1 kg lighter", in_words(&change.link)), change.lowers_by));
    let moves = explained.most_per_millimetre.iter().map(|change| {
        (format!("{} 1 mm along {}", in_words(&change.point), along(&change.direction)), change.lowers_by)
    });
    let mut all: Vec<(String, f64)> = masses.chain(moves).collect();
    all.sort_by(|a, b| b.1.total_cmp(&a.1));
    all.truncate(limits::RATES_ON_FIRST_PAGE);
    all
}

/// Direction in words: an axis, if the direction is nearly along it.
fn along(direction: &[f64; 3]) -> String {
    let axis = ["x", "y", "z"].into_iter().zip(direction).find(|(_, part)| part.abs() > limits::ALONG_AXIS);
    match axis {
        Some((axis, part)) => format!("{}{axis}", if *part < 0.0 { "−" } else { "+" }),
        None => triple(&direction.map(|x| (x * 1e2).round() / 1e2 + 0.0)),
    }
}

/// Simpler values that are wrong here, with their error.
fn not_instead(results: &StudyResults, report: &MassReport) -> Table {
    let mut table = Table::new(["instead", "error"]);
    let damper = report.damper.as_ref().or(results.report.damping.as_ref());
    if let Some((alone, damper)) = damper.and_then(|d| Some((d.body_alone?, d))) {
        let wrong = alone.restitution.map_or_else(String::new, |e| {
            format!("rebound {} for {}", fixed(e, 2), fixed(damper.damper.restitution, 2))
        });
        let name =
            in_words(&report.named_contact.as_ref().map_or(report.contact.link.clone(), |c| c.on.clone()));
        table.row([format!("mass of the {name}, {} kg", number(alone.mass)), wrong]);
    }
    if let Some((estimate, error)) =
        report.estimate.as_ref().and_then(|e| Some((e.estimate?, e.error_percent?)))
    {
        let mass = report.estimate.as_ref().map_or(0.0, |e| e.mass);
        table.row([
            format!("{} kg / (motion ratio)²", number(mass)),
            format!("{} kg, {} %", number(estimate), signed(error, 1)),
        ]);
    }
    table
}
