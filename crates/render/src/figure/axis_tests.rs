//! Ticks of axes, against values computed by hand and at the limits of the drawable range.

use super::*;

fn labels(axis: &Axis) -> Vec<String> {
    axis.ticks().into_iter().map(|t| t.label).collect()
}

fn tick_labels(low: f64, high: f64, most: u32) -> Vec<String> {
    labels(&Axis::without_margin(Some((low, high)), most))
}

#[test]
fn steps_are_one_two_or_five() {
    assert_eq!(tick_labels(0.0, 10.0, 5), ["0", "2", "4", "6", "8", "10"]);
    assert_eq!(tick_labels(-80.0, 80.0, 9), ["−80", "−60", "−40", "−20", "0", "20", "40", "60", "80"]);
    assert_eq!(tick_labels(0.0, 1.0, 4), ["0.0", "0.5", "1.0"].map(|s| if s == "0.0" { "0" } else { s }));
    assert_eq!(tick_labels(-0.3, 0.3, 6), ["−0.3", "−0.2", "−0.1", "0", "0.1", "0.2", "0.3"]);
    assert_eq!(tick_labels(199.8, 200.1, 3), ["199.8", "199.9", "200.0", "200.1"]);
}

#[test]
fn large_and_small_numbers_have_powers_of_a_thousand() {
    assert_eq!(tick_labels(0.0, 4e5, 4), ["0", "100×10³", "200×10³", "300×10³", "400×10³"]);
    assert_eq!(tick_labels(0.0, 2.5e6, 5), ["0", "0.5×10⁶", "1.0×10⁶", "1.5×10⁶", "2.0×10⁶", "2.5×10⁶"]);
    assert_eq!(tick_labels(-2e-3, 2e-3, 4), ["−2×10⁻³", "−1×10⁻³", "0", "1×10⁻³", "2×10⁻³"]);
    assert_eq!(tick_labels(0.0, 90_000.0, 3), ["0", "50000"]);
    assert_eq!(tick_labels(1e-300, 3e-300, 2), ["1×10⁻³⁰⁰", "2×10⁻³⁰⁰", "3×10⁻³⁰⁰"]);
}

#[test]
fn an_axis_with_margin_ends_on_the_minor_grid() {
    let axis = Axis::with_margin(Some((200.3, 209.6)), 6);
    assert_eq!(labels(&axis), ["200", "202", "204", "206", "208", "210"]);
    assert_eq!((axis.low, axis.high), (199.5, 210.0));
    assert!(axis.contains(200.3) && axis.contains(209.6));
    let minor = axis.minor();
    assert_eq!(minor.len(), 22 - 6, "three between two numbers, one below the first");
    assert!(minor.iter().all(|f| (0.0..=1.0).contains(f)));
}

#[test]
fn an_empty_range_is_extended() {
    for (range, expected) in [
        (None, (0.0, 1.0)),
        (Some((0.0, 0.0)), (-1.0, 1.0)),
        (Some((200.0, 200.0)), (190.0, 210.0)),
        (Some((-5.0, -5.0)), (-5.25, -4.75)),
        // A spread of rounding errors counts as a single value.
        (Some((200.0, 200.0 + 1e-10)), (190.0, 210.0)),
    ] {
        let axis = Axis::without_margin(range, 5);
        assert!(
            (axis.low - expected.0).abs() < 1e-9 && (axis.high - expected.1).abs() < 1e-9,
            "{range:?}: {axis:?}"
        );
    }
}

#[test]
fn undrawable_values_do_not_affect_the_range() {
    let values = [f64::NAN, f64::INFINITY, 3.0, f64::NEG_INFINITY, 1e301, -2.0, 1e-310];
    assert_eq!(extent(values.into_iter()), Some((-2.0, 3.0)));
    assert_eq!(extent([f64::NAN].into_iter()), None);
    assert_eq!(drawable(1e-310), Some(0.0));
}

#[test]
fn every_axis_has_two_numbers_and_they_ascend() {
    let sizes = [0.0_f64, 1e-300, 7e-300, 1e-12, 0.1 + 0.2, 1.0, 1.0 + 2e-9, 207.3, 1e9, 9.9e299, 1e300];
    for a in sizes.into_iter().flat_map(|a| [a, -a]) {
        for b in sizes.into_iter().flat_map(|b| [b, -b]) {
            for most in [2, 3, 5, 9, 12] {
                for axis in [Axis::without_margin, Axis::with_margin]
                    .map(|make| make(Some((a.min(b), a.max(b))), most))
                {
                    let ticks = axis.ticks();
                    assert!((2..=14).contains(&ticks.len()), "{a:e} {b:e} {most}: {ticks:?}");
                    assert!(
                        ticks.windows(2).all(|w| w[0].fraction < w[1].fraction && w[0].label != w[1].label)
                    );
                    assert!(
                        ticks
                            .iter()
                            .all(|t| (-1e-6..=1.0 + 1e-6).contains(&t.fraction) && t.label.len() < 40)
                    );
                    assert!(axis.minor().len() < 80);
                    assert!(axis.fraction(a).is_finite() && axis.contains(a) && axis.contains(b));
                }
            }
        }
    }
}
