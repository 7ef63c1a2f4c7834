//! Sensitivities of an effective mass, effects of tolerances, motion ratios and named contacts, as text.

use crate::terminal::escape::line;
use crate::terminal::text::{Table, number, short_number, triple, within_uncertainty};
use crate::terminal::wrap::fact_line;
use percuss_study::{
    EstimateRecord, Explanation, FrictionThresholdsRecord, MotionRatioRecord, NamedContactRecord,
    ToleranceReport, UPWARDS, WheelTravelRecord,
};
use std::fmt::Write;

/// Rates with respect to masses, rotors and hardpoints, and the changes that lower m̄ most. `unit`: unit of m̄.
pub fn explanation(explained: &Explanation, unit: &str) -> String {
    let mut out = String::from("\nsensitivities (first order; an opposite change has the opposite effect)\n");
    let list = |name: &str, items: Vec<String>| {
        let names = std::iter::once(name).chain(std::iter::repeat(""));
        names.zip(items).map(|(name, item)| fact_line(name, &line(&item))).collect::<String>()
    };
    let masses = explained.most_per_kilogram.iter();
    let masses: Vec<String> = masses
        .map(|c| format!("1 kg less of {}: {} {unit} less", c.link, short_number(c.lowers_by)))
        .collect();
    if !masses.is_empty() {
        out += &list("most per kilogram", masses);
    }
    let moves = explained.most_per_millimetre.iter().map(|c| {
        let direction = c.direction.map(|x| (x * 1e4).round() / 1e4);
        format!("{} 1 mm along {}: {} {unit} less", c.point, triple(&direction), short_number(c.lowers_by))
    });
    let moves: Vec<String> = moves.collect();
    if !moves.is_empty() {
        out += &list("most per millimetre", moves);
    }
    let mut table =
        Table::new(["link", "kg", "share %", "per kg", "per mm of its centre of mass (x, y, z of the link)"]);
    for link in &explained.links {
        let com = link.per_metre_of_com.map_or_else(|| "–".to_owned(), |rates| per_millimetre(&rates));
        let share = format!("{:.2}", 100.0 * link.share);
        table.row([link.link.clone(), short_number(link.mass), share, short_number(link.per_kilogram), com]);
    }
    let _ = write!(out, "\n{table}");
    if !explained.rotors.is_empty() {
        let mut table = Table::new(["joint", "per kg·m² (kg) of armature"]);
        for rotor in &explained.rotors {
            let rates: Vec<String> = rotor.per_armature.iter().map(|rate| short_number(*rate)).collect();
            table.row([rotor.joint.clone(), rates.join(", ")]);
        }
        let _ = write!(out, "\n{table}");
    }
    if !explained.points.is_empty() {
        let rates = format!("{unit} per mm along x, y, z of the sheet");
        let mut table = Table::new(["hardpoint", &rates]);
        for point in &explained.points {
            let rates = point
                .per_metre
                .map_or_else(|| "no result at a nearby pose".to_owned(), |r| per_millimetre(&r));
            table.row([point.point.clone(), rates]);
        }
        let _ = write!(out, "\n{table}");
    }
    out
}

/// Converts rates per metre to rates per millimetre.
fn per_millimetre(rates: &[f64; 3]) -> String {
    triple(&rates.map(|rate| format!("{:.3e}", rate * 1e-3).parse().unwrap_or(rate * 1e-3)))
}

/// Effects of the tolerances. `unit`: unit of m̄.
pub fn tolerances(report: &ToleranceReport, unit: &str) -> String {
    let given = &report.tolerance;
    let mut words = Vec::new();
    for (name, part, of) in
        [("mass", given.mass, &report.parts.mass), ("armature", given.armature, &report.parts.armature)]
    {
        if part > 0.0 {
            words.push(format!("{name} {} %: {} {unit}", short_number(100.0 * part), short_number(*of)));
        }
    }
    for (name, part, of) in
        [("com", given.com, &report.parts.com), ("point", given.point, &report.parts.point)]
    {
        if part > 0.0 {
            words.push(format!("{name} {} mm: {} {unit}", short_number(1e3 * part), short_number(*of)));
        }
    }
    let percent = |m: f64| {
        format!("{} {unit} ({} %)", short_number(m), short_number(100.0 * m / report.effective_mass))
    };
    let mut out = String::from("\neffect of the tolerances\n");
    let _ = writeln!(out, "  nominal value      {} {unit}", number(report.effective_mass));
    let _ = writeln!(out, "  root sum square    ± {}", percent(report.root_sum_square));
    let _ = writeln!(out, "  all at the limit   ± {}", percent(report.worst_case));
    out += &fact_line("  of which", &words.join("; "));
    if let Some(samples) = &report.samples {
        let spread = samples.standard_deviation;
        let text = format!(
            "{} ± {} {unit} (mean, standard deviation), 95 % within {} to {} {unit}, seed {}",
            within_uncertainty(samples.mean, spread),
            within_uncertainty(spread, spread),
            within_uncertainty(samples.percentile_2_5, spread),
            within_uncertainty(samples.percentile_97_5, spread),
            samples.seed
        );
        out += &fact_line(&format!("  {} samples", samples.count), &text);
        if samples.unanswered > 0 {
            out += &fact_line("", &format!("{} more have no result", samples.unanswered));
        }
    }
    out
}

/// Coefficients of friction for sticking, jamming and wedging as text; `None` for a contact point that does not slide while the gap closes.
pub fn friction_thresholds(found: &FrictionThresholdsRecord) -> Option<String> {
    match found.slope {
        None => Some(match (found.sticking.map(short_number), found.jamming.map(short_number)) {
            (Some(sticks), Some(jams)) => {
                format!("the contact can stick from a coefficient of {sticks}, and jam from {jams}")
            }
            (Some(sticks), None) => {
                format!("the contact can stick from a coefficient of {sticks}; it cannot jam")
            }
            (None, Some(jams)) => {
                format!("the contact cannot stick; it can jam from a coefficient of {jams}")
            }
            (None, None) => "the contact can neither stick nor jam".to_owned(),
        }),
        Some(_) => found
            .jamming
            .map(|wedges| format!("the contact wedges from a coefficient of {}", short_number(wedges))),
    }
}

/// Motion ratio with its definition.
pub fn motion_ratio(ratio: &MotionRatioRecord) -> String {
    let whole = match &ratio.held {
        Some(joint) => format!("; with the joint {joint} held"),
        None if ratio.one_travel => String::new(),
        None => "; for the motion of this impact only".to_owned(),
    };
    format!("{}{whole}", ratio_per_travel(ratio.contact_per_wheel, &ratio.link, Some(ratio.direction)))
}

/// Motion ratio of the estimate with its definition.
pub fn estimate_ratio(estimate: &EstimateRecord) -> String {
    let point = if estimate.point_link == [0.0; 3] {
        estimate.links[0].clone()
    } else {
        format!("{} m of {}", triple(&estimate.point_link), estimate.links[0])
    };
    ratio_per_travel(estimate.motion_ratio, &point, estimate.direction)
}

/// Motion ratio per travel of a point along a direction, or along its path.
fn ratio_per_travel(ratio: Option<f64>, point: &str, direction: Option<[f64; 3]>) -> String {
    let travel = match direction {
        Some(UPWARDS) => format!("upward travel of {point}"),
        Some(direction) => format!("travel of {point} along {} (world axes)", triple(&direction)),
        None => format!("length of the path of {point}"),
    };
    let ratio = ratio.map_or_else(|| "infinite".to_owned(), number);
    format!("{ratio}, closing of the contact per {travel}")
}

/// Name, gap and wheel travel of a named contact.
pub fn named_contact(contact: &NamedContactRecord) -> Vec<(&'static str, String)> {
    let mut facts =
        vec![("contact", format!("{} ({}), on {}", contact.name, contact.kind, body_of(contact)))];
    if let (Some(drawn), Some(gap)) = (contact.gap_as_drawn, contact.gap) {
        let drawn = format!("{} as drawn", contact.unit.text(drawn));
        facts.push(match (contact.brought_to_touch, gap) {
            (true, _) if contact.touching.is_empty() => ("gap", format!("0, at the touch; {drawn}")),
            (true, _) => {
                let others = contact.touching.join(", ");
                ("gap", format!("0, at the touch, as that of {others}; {drawn}"))
            }
            (false, gap) if gap < 0.0 => {
                ("gap", format!("{}: a penetration at this pose; {drawn}", contact.unit.text(gap)))
            }
            (false, gap) => ("gap", format!("{} at this pose: no touch; {drawn}", contact.unit.text(gap))),
        });
    }
    if let Some(together) = contact.effective_mass_together {
        let others = contact.touching.join(", ");
        let text =
            format!("{} kg if {others} closes at the same speed; above: this stop alone", number(together));
        facts.push(("both stops", text));
    }
    let travel = |wheel: &WheelTravelRecord| {
        let sense = if wheel.travel < 0.0 { "down" } else { "up" };
        format!("{} {sense} from the pose as drawn, at {}", contact.unit.text(wheel.travel.abs()), wheel.link)
    };
    // The travel of a contact without a gap is that of the question.
    if contact.gap.is_some() {
        facts.extend(contact.wheel_travel.iter().map(|wheel| ("wheel travel", travel(wheel))));
    }
    facts
}

/// Body of a named contact, with the damper of a stop on its rod.
pub fn body_of(contact: &NamedContactRecord) -> String {
    match &contact.element {
        Some(element) => format!("{element} of {}", contact.on),
        None => contact.on.clone(),
    }
}
