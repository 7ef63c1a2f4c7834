//! Sensitivities and tolerances of an effective mass: tables, tornado charts and the histogram of the samples.

use crate::document::Document;
use crate::terminal::limits;
use crate::terminal::number::{number, triple, within_uncertainty};
use crate::terminal::text::{Table, TableCell};
use percuss_render::{Figure, Mark, Panel, Picture, Series, Style, Tornado, TornadoBar};
use percuss_study::{Explanation, SampleRecord, ToleranceReport};

/// Effect in both directions.
pub fn effect_text(kg: f64) -> String {
    format!("± {}", number(kg.abs()))
}

/// Rate per millimetre.
fn per_millimetre(rate: f64) -> TableCell {
    // A rate below a microgram per millimetre is rounding.
    TableCell::Part(Some(if rate.abs() < 1e-6 { 0.0 } else { rate * 1e-3 }))
}

/// Adds the changes that lower m̄ most, and its rates. `unit`: unit of m̄. The joints of a suspension (`has_sheet`) have no rotors.
pub fn add_sensitivities<'a>(
    explained: &'a Explanation,
    unit: &'static str,
    has_sheet: bool,
    out: &mut Document<'a>,
) {
    out.section("Sensitivities");
    out.note("To first order: an opposite change has the opposite effect.");
    let masses = explained.most_per_kilogram.iter();
    let masses = masses.map(|c| format!("1 kg less of {}: {} {unit} less", c.link, number(c.lowers_by)));
    let moves = explained.most_per_millimetre.iter().map(|c| {
        let direction = c.direction.map(|x| (x * 1e4).round() / 1e4);
        format!("{} 1 mm along {}: {} {unit} less", c.point, triple(&direction), number(c.lowers_by))
    });
    let named = |name: &'static str| std::iter::once(name).chain(std::iter::repeat(""));
    out.facts(named("most per kilogram").zip(masses).chain(named("most per millimetre").zip(moves)));
    let masses = explained.links.iter().map(|link| bar(link.link.clone(), link.per_kilogram));
    add_tornado("Effect of 1 kg more or less of each link", ["1 kg", unit], masses, out);
    let points = explained.points.iter().filter_map(|point| Some((point, point.per_metre?)));
    let points = points.flat_map(|(point, rates)| {
        let named = ["x", "y", "z"].into_iter().zip(rates);
        named.map(|(axis, rate)| bar(format!("{}, {axis}", point.point), 1e-3 * rate))
    });
    add_tornado("Effect of 1 mm of each hardpoint", ["1 mm", unit], points, out);
    add_rates(explained, unit, has_sheet, out);
}

/// Bar of a tornado chart; `effect` is the change of m̄, kg.
fn bar(name: String, effect: f64) -> TornadoBar {
    TornadoBar { name, effect, value: effect_text(effect) }
}

/// Adds a tornado chart of the largest effects. The caption states the number of the others. `change`: change of each number, as text;
/// `unit`: unit of m̄.
fn add_tornado(
    title: &'static str,
    [change, unit]: [&str; 2],
    bars: impl Iterator<Item = TornadoBar>,
    out: &mut Document<'_>,
) {
    let mut bars: Vec<TornadoBar> = bars.filter(|bar| bar.effect != 0.0).collect();
    if bars.is_empty() {
        return;
    }
    bars.sort_by(|a, b| b.effect.abs().total_cmp(&a.effect.abs()));
    let rest = bars.split_off(bars.len().min(limits::TORNADO_BARS));
    let caption = rest.first().map_or_else(String::new, |next| {
        let most = effect_text(next.effect);
        format!("{} smaller effects are not shown; each is at most {most} {unit}.", rest.len())
    });
    let chart = Tornado {
        title: title.to_owned(),
        x_label: format!("change of m̄ ({unit})"),
        directions: [format!("{change} more"), format!("{change} less")],
        bars,
        ..Tornado::default()
    };
    out.picture(move || chart.to_svg(), title, caption);
}

/// Adds tables of all rates; `unit`: unit of m̄.
fn add_rates(explained: &Explanation, unit: &str, has_sheet: bool, out: &mut Document<'_>) {
    let (per_kg, per_mm) = (format!("{unit} per kg"), format!("{unit} per mm: x"));
    let rates = |rates: Option<[f64; 3]>| {
        rates.map_or_else(|| [(); 3].map(|()| TableCell::Part(None)), |rates| rates.map(per_millimetre))
    };
    let mut links = Table::new(["link", "mass kg", "% of m̄", &per_kg, &per_mm, "y", "z"]);
    for link in &explained.links {
        let [x, y, z] = rates(link.per_metre_of_com);
        let [mass, share, per_kg] =
            [link.mass, 100.0 * link.share, link.per_kilogram].map(|x| TableCell::Part(Some(x)));
        links.row([link.link.clone().into(), mass, share, per_kg, x, y, z]);
    }
    out.table(links);
    out.note("The last columns are for a displacement of the centre of mass in the axes of the link.");
    let mut rotors = Table::new(["joint", &format!("{unit} per kg·m² (or kg) of armature")]);
    for rotor in explained.rotors.iter().filter(|_| !has_sheet) {
        let rates: Vec<String> = rotor.per_armature.iter().map(|rate| number(*rate)).collect();
        rotors.row([rotor.joint.clone(), rates.join(", ")]);
    }
    out.table(rotors);
    let mut points = Table::new(["hardpoint", &per_mm, "y", "z"]);
    for point in &explained.points {
        let [x, y, z] = rates(point.per_metre);
        points.row([TableCell::from(point.point.clone()), x, y, z]);
    }
    out.table(points);
    if explained.points.iter().any(|point| point.per_metre.is_none()) {
        out.note("–: no result at a nearby pose.");
    }
}

/// Adds the effects of the tolerances. `unit`: unit of m̄.
pub fn add_tolerances<'a>(report: &'a ToleranceReport, unit: &'static str, out: &mut Document<'a>) {
    let given = &report.tolerance;
    let mut words = Vec::new();
    for (name, part, of) in
        [("mass", given.mass, report.parts.mass), ("armature", given.armature, report.parts.armature)]
    {
        if part > 0.0 {
            words.push(format!("{name} {} %: {} {unit}", number(100.0 * part), number(of)));
        }
    }
    for (name, part, of) in [("com", given.com, report.parts.com), ("point", given.point, report.parts.point)]
    {
        if part > 0.0 {
            words.push(format!("{name} {} mm: {} {unit}", number(1e3 * part), number(of)));
        }
    }
    let effect = |m: f64| format!("± {} {unit} ({} %)", number(m), number(100.0 * m / report.effective_mass));
    out.section("Tolerances");
    out.facts([
        ("nominal value", format!("{} {unit}", number(report.effective_mass))),
        ("root sum square", effect(report.root_sum_square)),
        ("all at the limit", effect(report.worst_case)),
        ("of which", words.join("; ")),
    ]);
    let bars = report.effects.iter().map(|effect| bar(effect.number.clone(), effect.change));
    add_tornado("Effect of each number at the limit of its tolerance", ["one tolerance", unit], bars, out);
    let Some(samples) = &report.samples else { return };
    let nominal = report.effective_mass;
    out.picture(
        move || histogram(samples, nominal, unit).to_svg(),
        "Histogram of the effective mass of random designs within the tolerances",
        "Every number is uniform between its limits. Dotted: the nominal m̄, and the limits of 95 % of the samples.",
    );
    let shown = |x: f64| within_uncertainty(x, samples.standard_deviation);
    let both = |from: f64, to: f64| format!("{} to {} {unit}", shown(from), shown(to));
    let spread = format!(
        "{} ± {} {unit} (mean, standard deviation)",
        shown(samples.mean),
        shown(samples.standard_deviation)
    );
    let facts = [
        ("samples", format!("{}, seed {}", samples.count, samples.seed)),
        ("  all", spread),
        ("  95 % within", both(samples.percentile_2_5, samples.percentile_97_5)),
        ("  all within", both(samples.least, samples.greatest)),
    ];
    let unanswered = (samples.unanswered > 0).then(|| ("  without a result", samples.unanswered.to_string()));
    out.facts(facts.into_iter().chain(unanswered));
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
            ..Panel::default()
        }],
        marks: vec![
            mark(nominal, "nominal"),
            mark(samples.percentile_2_5, "2.5 %"),
            mark(samples.percentile_97_5, "97.5 %"),
        ],
        ..Figure::default()
    }
}
