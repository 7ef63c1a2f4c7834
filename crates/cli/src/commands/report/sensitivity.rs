//! Sensitivities and tolerances of an effective mass: tables, tornado charts and the histogram of the samples.

use crate::files::html::Page;
use crate::terminal::limits;
use crate::terminal::text::{number, short_number, triple, within_uncertainty};
use percuss_render::{Figure, Mark, Panel, Series, Style, Tornado, TornadoBar};
use percuss_study::{Explanation, MassReport, SampleRecord, ToleranceReport};

/// Effect in both directions with three significant digits.
pub(super) fn effect_text(kg: f64) -> String {
    let rounded: f64 = format!("{:.2e}", kg.abs()).parse().unwrap_or(kg);
    format!("± {}", number(rounded))
}

/// Rate per millimetre with four significant digits.
fn per_millimetre(rate: f64) -> String {
    // A rate below a microgram per millimetre is rounding.
    let rate = if rate.abs() < 1e-6 { 0.0 } else { rate };
    number(format!("{:.3e}", rate * 1e-3).parse().unwrap_or(rate * 1e-3))
}

/// Section with the sensitivities.
pub(super) fn add_sensitivities(report: &MassReport, page: &mut Page) {
    let Some(explained) = &report.explanation else { return };
    page.section("Sensitivities");
    page.paragraph("soft", "To first order: an opposite change has the opposite effect.");
    add_most_effective(explained, report.unit, page);
    let masses: Vec<TornadoBar> =
        explained.links.iter().map(|link| bar(link.link.clone(), link.per_kilogram)).collect();
    add_tornado("Effect of 1 kg more or less of each link", ["1 kg", report.unit], masses, page);
    let points: Vec<TornadoBar> = explained
        .points
        .iter()
        .filter_map(|point| Some((point, point.per_metre?)))
        .flat_map(|(point, rates)| {
            ["x", "y", "z"]
                .into_iter()
                .zip(rates)
                .map(|(axis, rate)| bar(format!("{}, {axis}", point.point), 1e-3 * rate))
        })
        .collect();
    add_tornado("Effect of 1 mm of each hardpoint", ["1 mm", report.unit], points, page);
    add_rates(explained, report.unit, report.point_in_sheet.is_some(), page);
}

/// Bar of a tornado chart; `effect` is the change of m̄, kg.
fn bar(name: String, effect: f64) -> TornadoBar {
    TornadoBar { name, effect, value: effect_text(effect) }
}

/// Tornado chart of the largest effects. The caption states the number of the others. `change`: change of each number, as text; `unit`:
/// unit of m̄.
fn add_tornado(title: &str, [change, unit]: [&str; 2], mut bars: Vec<TornadoBar>, page: &mut Page) {
    bars.retain(|bar| bar.effect != 0.0);
    if bars.is_empty() {
        return;
    }
    bars.sort_by(|a, b| b.effect.abs().total_cmp(&a.effect.abs()));
    let rest = bars.split_off(bars.len().min(limits::TORNADO_BARS));
    let caption = rest.first().map_or_else(String::new, |next| {
        format!(
            "{} smaller effects are not shown; each is at most {} {unit}.",
            rest.len(),
            effect_text(next.effect)
        )
    });
    let chart = Tornado {
        title: title.to_owned(),
        x_label: format!("change of m̄ ({unit})"),
        directions: [format!("{change} more"), format!("{change} less")],
        bars,
        ..Tornado::default()
    };
    page.picture(&chart.to_svg(), title, &caption);
}

/// Table of the changes that lower m̄ most.
fn add_most_effective(explained: &Explanation, unit: &str, page: &mut Page) {
    let masses = explained
        .most_per_kilogram
        .iter()
        .map(|change| [format!("1 kg less of {}", change.link), short_number(change.lowers_by)]);
    let moves = explained.most_per_millimetre.iter().map(|change| {
        let direction = change.direction.map(|x| (x * 1e4).round() / 1e4);
        [format!("{} 1 mm along {}", change.point, triple(&direction)), short_number(change.lowers_by)]
    });
    let mut rows = vec![["most effective change".to_owned(), format!("lowers m̄ by ({unit})")]];
    rows.extend(masses.chain(moves));
    if rows.len() > 1 {
        page.table(&rows);
    }
}

/// Tables of all rates; `unit`: unit of m̄. The joints of a suspension (`has_sheet`) have no rotors.
fn add_rates(explained: &Explanation, unit: &str, has_sheet: bool, page: &mut Page) {
    page.heading("Rates of each link");
    let (per_kg, per_mm) = (format!("{unit} per kg"), format!("{unit} per mm: x"));
    let header = ["link", "mass (kg)", "share (%)", &per_kg, &per_mm, "y", "z"];
    let mut rows = vec![header.map(str::to_owned)];
    rows.extend(explained.links.iter().map(|link| {
        let [x, y, z] = link
            .per_metre_of_com
            .map_or_else(|| [(); 3].map(|()| "–".to_owned()), |rates| rates.map(per_millimetre));
        let share = format!("{:.2}", 100.0 * link.share);
        [link.link.clone(), short_number(link.mass), share, short_number(link.per_kilogram), x, y, z]
    }));
    page.table(&rows);
    page.paragraph(
        "soft",
        "The last columns are for a displacement of the centre of mass in the axes of the link.",
    );
    if !explained.rotors.is_empty() && !has_sheet {
        page.heading("Rates of the armatures");
        let per_armature = format!("{unit} per kg·m² (or kg) of armature");
        let mut rows = vec![["joint", &per_armature].map(str::to_owned)];
        rows.extend(explained.rotors.iter().map(|rotor| {
            let rates: Vec<String> = rotor.per_armature.iter().map(|rate| short_number(*rate)).collect();
            [rotor.joint.clone(), rates.join(", ")]
        }));
        page.table(&rows);
    }
    if !explained.points.is_empty() {
        page.heading("Rates of the hardpoints");
        let mut rows = vec![["hardpoint", &per_mm, "y", "z"].map(str::to_owned)];
        rows.extend(explained.points.iter().map(|point| {
            let none = || [(); 3].map(|()| "–".to_owned());
            let [x, y, z] = point.per_metre.map_or_else(none, |rates| rates.map(per_millimetre));
            [point.point.clone(), x, y, z]
        }));
        page.table(&rows);
        if explained.points.iter().any(|point| point.per_metre.is_none()) {
            page.paragraph("soft", "–: no result at a nearby pose.");
        }
    }
}

/// Section with the effects of the tolerances.
pub(super) fn add_tolerances(report: &MassReport, page: &mut Page) {
    let Some(tolerances) = &report.tolerance else { return };
    page.section("Tolerances");
    page.table(&part_rows(tolerances, report.unit));
    let bars = tolerances.effects.iter().map(|effect| bar(effect.number.clone(), effect.change)).collect();
    let title = "Effect of each number at the limit of its tolerance";
    add_tornado(title, ["one tolerance", report.unit], bars, page);
    if let Some(samples) = &tolerances.samples {
        add_samples(samples, tolerances, report.unit, page);
    }
}

/// Rows of the kinds of numbers with their tolerance and effect, then of the sums.
fn part_rows(report: &ToleranceReport, unit: &str) -> Vec<[String; 4]> {
    let given = &report.tolerance;
    let percent = |x: f64| format!("{} %", short_number(100.0 * x));
    let millimetres = |x: f64| format!("{} mm", short_number(1e3 * x));
    let row = |name: &str, tolerance: String, kg: f64| {
        let relative = short_number(100.0 * kg / report.effective_mass);
        [name.to_owned(), tolerance, short_number(kg), relative]
    };
    let effect = format!("± {unit}");
    let mut rows = vec![["numbers", "tolerance", &effect, "± % of m̄"].map(str::to_owned)];
    for (name, part, kg) in
        [("masses", given.mass, report.parts.mass), ("armatures", given.armature, report.parts.armature)]
    {
        if part > 0.0 {
            rows.push(row(name, percent(part), kg));
        }
    }
    for (name, part, kg) in
        [("centres of mass", given.com, report.parts.com), ("hardpoints", given.point, report.parts.point)]
    {
        if part > 0.0 {
            rows.push(row(name, millimetres(part), kg));
        }
    }
    rows.push(row("root sum square of all", String::new(), report.root_sum_square));
    rows.push(row("all at the limit", String::new(), report.worst_case));
    rows
}

/// Histogram and statistics of the random samples.
fn add_samples(samples: &SampleRecord, tolerances: &ToleranceReport, unit: &str, page: &mut Page) {
    page.heading("Random samples");
    page.picture(
        &histogram(samples, tolerances.effective_mass, unit).to_svg(),
        "Histogram of the effective mass of random designs within the tolerances",
        "Every number is uniform between its limits. Dotted: the nominal m̄, and the limits of 95 % of the samples.",
    );
    let rounded = |x: f64| within_uncertainty(x, samples.standard_deviation);
    let mut facts = vec![
        ("samples", format!("{}, seed {}", samples.count, samples.seed)),
        ("mean", format!("{} {unit}", rounded(samples.mean))),
        ("standard deviation", format!("{} {unit}", rounded(samples.standard_deviation))),
        (
            "95 % within",
            format!("{} to {} {unit}", rounded(samples.percentile_2_5), rounded(samples.percentile_97_5)),
        ),
        ("all within", format!("{} to {} {unit}", rounded(samples.least), rounded(samples.greatest))),
    ];
    if samples.unanswered > 0 {
        facts.push(("without a result", samples.unanswered.to_string()));
    }
    page.facts(facts);
}

/// Histogram of the samples. The number of bins is about the square root of the number of samples.
fn histogram(samples: &SampleRecord, nominal: f64, unit: &str) -> Figure {
    let span = samples.greatest - samples.least;
    let bins = ((samples.count as f64).sqrt().ceil() as usize).clamp(1, limits::HISTOGRAM_BINS);
    let width = span / bins as f64;
    let mut counts = vec![0_usize; bins];
    for mass in &samples.masses {
        let bin = ((mass - samples.least) / width) as usize;
        counts[bin.min(bins - 1)] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(0) as f64;
    let edge = |i: usize| samples.least + width * i as f64;
    let mut points: Vec<(f64, Option<f64>)> =
        counts.iter().enumerate().map(|(i, count)| (edge(i), Some(*count as f64))).collect();
    points.push((edge(bins), None));
    let mark = |x: f64, label: &str| Mark { x, label: label.into() };
    Figure {
        title: "Effective mass within the tolerances".into(),
        x_label: format!("m̄ ({unit})"),
        panels: vec![Panel {
            y_label: "samples".into(),
            series: vec![Series { name: "samples".into(), style: Style::Bars, points }],
            y_limits: Some((0.0, 1.06 * most)),
        }],
        marks: vec![
            mark(nominal, "nominal"),
            mark(samples.percentile_2_5, "2.5 %"),
            mark(samples.percentile_97_5, "97.5 %"),
        ],
        ..Figure::default()
    }
}
