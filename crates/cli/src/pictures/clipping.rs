//! Ends of the axes of curves that grow without bound near an immovable pose or a limit of the travel.

use crate::terminal::limits;
use crate::terminal::number::number;
use crate::terminal::report::note;
use percuss_render::{Figure, Series, Style};

/// Ends each axis without given limits before a few values that would take most of it. Returns the caption: the end of the
/// axis, and the number and the extreme of the values beyond; empty if nothing is clipped.
pub fn clip_outliers(figure: &mut Figure) -> String {
    let mut captions = Vec::new();
    for panel in figure.panels.iter_mut().filter(|panel| panel.y_limits.is_none()) {
        let points = panel.series.iter().flat_map(|series| &series.points);
        let drawn: Vec<(f64, f64)> =
            points.filter_map(|&(x, y)| Some((x, y?))).filter(|(_, y)| y.is_finite()).collect();
        let mut values: Vec<f64> = drawn.iter().map(|(_, y)| *y).collect();
        if values.len() < limits::LEAST_CLIPPED {
            continue;
        }
        values.sort_by(f64::total_cmp);
        let last = values.len() - 1;
        let at = |part: f64| values[(part * last as f64).round() as usize];
        let (low, high) = (at(limits::OUTLIERS), at(1.0 - limits::OUTLIERS));
        let spread = high - low;
        let (least, greatest) = (values[0], values[last]);
        if spread <= 0.0 || !spread.is_finite() {
            continue;
        }
        let beyond = limits::OUTLIER_DISTANCE * spread;
        let top = if greatest - high > beyond { high + spread } else { greatest };
        let bottom = if low - least > beyond { low - spread } else { least };
        let name = panel.y_label.clone();
        let mut describe = |end: f64, is_beyond: &dyn Fn(f64) -> bool, extreme: f64, sense: &str| {
            let count = values.iter().filter(|value| is_beyond(**value)).count();
            let place = drawn.iter().find(|(_, y)| *y == extreme).map_or(0.0, |(x, _)| *x);
            captions.push(format!(
                "{name}: the axis ends at {}; {count} of {} values are {sense}, the extreme {} at {} {}.",
                number(end),
                values.len(),
                number(extreme),
                figure.x_label,
                number(place)
            ));
        };
        if top < greatest {
            describe(top, &|value| value > top, greatest, "larger");
        }
        if bottom > least {
            describe(bottom, &|value| value < bottom, least, "smaller");
        }
        if top < greatest || bottom > least {
            let margin = 0.04 * (top - bottom);
            let low_end = if bottom > least { bottom } else { bottom - margin };
            panel.y_limits = Some((low_end, if top < greatest { top } else { top + margin }));
            panel.series.iter_mut().for_each(|series| break_at_poles(series, bottom, top));
        }
    }
    captions.join(" ")
}

/// Removes the panels of which every curve is constant to [`limits::FLAT_CURVE`], and returns a sentence with the constants; empty if
/// none is removed. A panel with a band or with given limits stays.
pub fn remove_flat_panels(figure: &mut Figure) -> String {
    let mut sentences = Vec::new();
    figure.panels.retain(|panel| {
        let constants: Option<Vec<f64>> = panel.series.iter().map(constant).collect();
        let Some(constants) = constants.filter(|all| !all.is_empty() && panel.y_limits.is_none()) else {
            return true;
        };
        let is_alone = constants.len() == 1;
        let value = |(series, constant): (&Series, &f64)| {
            let constant = number(*constant);
            if is_alone { constant } else { format!("{constant} ({})", series.name) }
        };
        let values: Vec<String> = panel.series.iter().zip(&constants).map(value).collect();
        sentences.push(format!("{} is constant over the range: {}.", panel.y_label, values.join(", ")));
        false
    });
    sentences.join(" ")
}

/// Mean of the smallest and the largest value of a curve that is constant; `None` for any other curve.
fn constant(series: &Series) -> Option<f64> {
    let values: Vec<f64> = series.points.iter().filter_map(|(_, y)| *y).filter(|y| y.is_finite()).collect();
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let is_flat = high - low <= limits::FLAT_CURVE * low.abs().max(high.abs());
    (values.len() > 1 && is_flat && series.style != Style::Band).then_some(0.5 * (low + high))
}

/// Interrupts a curve between two values beyond opposite ends of the axis, because a pole lies between them.
fn break_at_poles(series: &mut Series, bottom: f64, top: f64) {
    let side = |y: Option<f64>| y.map_or(0, |y| i32::from(y > top) - i32::from(y < bottom));
    let mut points: Vec<(f64, Option<f64>)> = Vec::with_capacity(series.points.len());
    for (x, y) in std::mem::take(&mut series.points) {
        if let Some(&(last, before)) = points.last()
            && side(before) * side(y) < 0
        {
            points.push((0.5 * (last + x), None));
        }
        points.push((x, y));
    }
    series.points = points;
}

/// Clips a figure that is written to a file, and prints the caption on the terminal.
pub fn note_clipping(figure: &mut Figure) {
    let caption = clip_outliers(figure);
    if !caption.is_empty() {
        note(&caption);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use percuss_render::Panel;

    fn figure(of: impl Fn(f64) -> f64) -> Figure {
        let points = (0..50).map(|i| 0.02 * f64::from(i)).map(|x| (x, Some(of(x)))).collect();
        let series = vec![Series { points, ..Series::default() }];
        let panel = Panel { y_label: "m̄ (kg)".into(), series, ..Panel::default() };
        Figure { x_label: "angle".into(), panels: vec![panel], ..Figure::default() }
    }

    #[test]
    fn constants_are_stated_instead_of_drawn() {
        let mut flat = figure(|x| 2.5 + 1e-5 * x);
        assert_eq!(remove_flat_panels(&mut flat), "m̄ (kg) is constant over the range: 2.5.");
        assert!(flat.panels.is_empty());
        let mut slope = figure(|x| 2.5 + 1e-3 * x);
        assert_eq!(remove_flat_panels(&mut slope), "");
        assert_eq!(slope.panels.len(), 1);
    }

    #[test]
    fn a_pole_is_clipped_and_a_smooth_curve_is_not() {
        let mut pole = figure(|x| 1.0 / (0.981 - x).powi(2));
        let caption = clip_outliers(&mut pole);
        let (low, high) = pole.panels[0].y_limits.expect("clipped");
        assert!(low < 1.1 && high < 1e3, "{low} {high}");
        assert!(
            caption.starts_with("m̄ (kg): the axis ends at") && caption.contains("at angle 0.98"),
            "{caption}"
        );
        let mut odd = figure(|x| 1.0 / (0.51 - x));
        clip_outliers(&mut odd);
        let gap = odd.panels[0].series[0].points.iter().position(|(_, y)| y.is_none());
        assert_eq!(gap, Some(26), "between the values at 0.50 and 0.52");
        let mut smooth = figure(|x| 3.0 + (5.0 * x).sin());
        assert_eq!(clip_outliers(&mut smooth), "");
        assert_eq!(smooth.panels[0].y_limits, None);
        let mut constant = figure(|_| 2.0);
        assert_eq!(clip_outliers(&mut constant), "");
    }
}
