//! Range and tick marks of an axis.

use crate::limits;

/// Value as drawn: `None` for NaN, infinities and magnitudes above 1e300; zero for magnitudes below 1e-300.
/// Within these bounds no difference, step or label overflows.
pub(crate) fn drawable(value: f64) -> Option<f64> {
    match value.abs() {
        size if size < limits::SMALLEST_VALUE => Some(0.0),
        size if size <= limits::LARGEST_VALUE => Some(value),
        _ => None,
    }
}

/// Step of `mantissa` × 10^`exponent`; the mantissa is 1, 2 or 5.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Step {
    mantissa: i64,
    exponent: i32,
}

/// A linear axis, or one whose values are logarithms to the base 10.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    low: f64,
    high: f64,
    step: Step,
    is_logarithmic: bool,
}

/// Tick mark of an axis.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    /// Position along the axis, from 0 to 1.
    pub fraction: f64,
    pub label: String,
}

/// Smallest and largest drawable value.
pub(crate) fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.filter_map(drawable).fold(None, |range, v| match range {
        None => Some((v, v)),
        Some((low, high)) => Some((v.min(low), v.max(high))),
    })
}

impl Axis {
    /// Axis from the smallest to the largest value, with at most `max_intervals` + 1 ticks.
    pub fn without_margin(range: Option<(f64, f64)>, max_intervals: u32) -> Axis {
        let (low, high) = nonempty_range(range);
        Axis::with_coarsest_step(low, high, max_intervals)
    }

    /// Axis with a margin of 4 % at both ends, extended to the next minor grid line.
    pub fn with_margin(range: Option<(f64, f64)>, max_intervals: u32) -> Axis {
        let (low, high) = nonempty_range(range);
        let margin = 0.04 * (high - low);
        let axis = Axis::with_coarsest_step(low - margin, high + margin, max_intervals);
        let minor = axis.step.minor();
        let count = |v: f64| v / minor.value(1);
        let low = minor.value(count(axis.low).floor() as i64);
        let high = minor.value(count(axis.high).ceil() as i64);
        Axis { low, high, ..axis }
    }

    /// Takes the coarsest step with at most `max_intervals` intervals and at least two ticks.
    fn with_coarsest_step(low: f64, high: f64, max_intervals: u32) -> Axis {
        let with = |max_intervals| Axis {
            low,
            high,
            step: Step::for_span(high - low, max_intervals),
            is_logarithmic: false,
        };
        let found =
            (max_intervals..max_intervals + 8).map(with).find(|axis| axis.multiples(axis.step).len() >= 2);
        found.unwrap_or_else(|| with(max_intervals + 8))
    }

    /// The axis with its values as logarithms: ticks at whole decades, if the axis has two of them.
    pub fn of_logarithms(self) -> Axis {
        let decades = Step { mantissa: 1, exponent: 0 };
        let is_wide = self.multiples(decades).len() >= 2;
        let step = if is_wide && self.step.exponent < 0 { decades } else { self.step };
        Axis { step, is_logarithmic: true, ..self }
    }

    /// Position of a value along the axis: 0 to 1 inside the range.
    pub fn fraction(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    /// True if the value is in the range of the axis.
    pub fn contains(&self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }

    /// Major ticks in ascending order.
    pub fn ticks(&self) -> Vec<Tick> {
        let counts = self.multiples(self.step);
        let max_intervals = counts.iter().map(|n| n.abs()).max().unwrap_or(0);
        let exponent = self.step.engineering_exponent(max_intervals);
        let tick = |&n: &i64| Tick {
            fraction: self.fraction(self.step.value(n)),
            label: if self.is_logarithmic {
                power_label(self.step.value(n))
            } else {
                self.step.label(n, exponent)
            },
        };
        counts.iter().map(tick).collect()
    }

    /// Positions of the minor grid lines, without the major ones.
    pub fn minor(&self) -> Vec<f64> {
        if self.is_logarithmic {
            let decades = self.low.floor() as i64..=self.high.floor() as i64;
            let within = decades.flat_map(|n| (2..10).map(move |m| n as f64 + f64::from(m).log10()));
            return within.filter(|x| self.contains(*x)).map(|x| self.fraction(x)).collect();
        }
        let minor = self.step.minor();
        let each = self.step.minor_divisions();
        let between = self.multiples(minor).into_iter().filter(|n| n % each != 0);
        between.map(|n| self.fraction(minor.value(n))).collect()
    }

    /// Multiples of the step on the axis. The slack keeps the end points in spite of rounding.
    fn multiples(&self, step: Step) -> Vec<i64> {
        let unit = step.value(1);
        let first = (self.low / unit - limits::TICK_SLACK).ceil() as i64;
        let last = (self.high / unit + limits::TICK_SLACK).floor() as i64;
        (first..=last).collect()
    }
}

/// Text of 10 to the power `exponent`: `100`, `10⁶`, and for parts of a decade three digits.
fn power_label(exponent: f64) -> String {
    let value = 10_f64.powf(exponent);
    match exponent {
        n if n != n.round() => format!("{value:.*}", (2.0 - n.floor()).clamp(0.0, 12.0) as usize),
        n if (-3.0..5.0).contains(&n) => format!("{value:.*}", (-n).max(0.0) as usize),
        n => format!("10{}", superscript(n as i32)),
    }
}

/// Replaces an empty range by 0 to 1, and a single value by its neighbourhood.
fn nonempty_range(range: Option<(f64, f64)>) -> (f64, f64) {
    let Some((low, high)) = range else { return (0.0, 1.0) };
    let size = low.abs().max(high.abs());
    if high - low > limits::FLAT * size {
        return (low, high);
    }
    let middle = low + 0.5 * (high - low);
    let margin = if size == 0.0 { 1.0 } else { 0.05 * size };
    (middle - margin, middle + margin)
}

impl Step {
    /// Smallest 1-2-5 step with at most `max_intervals` intervals in the span.
    fn for_span(span: f64, max_intervals: u32) -> Step {
        let raw = span / f64::from(max_intervals.max(1));
        let exponent = raw.log10().floor() as i32;
        let leading = raw / 10f64.powi(exponent);
        match [1, 2, 5].into_iter().find(|&m| leading <= m as f64 * (1.0 + limits::STEP_SLACK)) {
            Some(mantissa) => Step { mantissa, exponent },
            None => Step { mantissa: 1, exponent: exponent + 1 },
        }
    }

    /// `count` times the step, rounded once.
    fn value(self, count: i64) -> f64 {
        let digits = (count * self.mantissa) as f64;
        match self.exponent {
            e if e >= 0 => digits * 10f64.powi(e),
            e => digits / 10f64.powi(-e),
        }
    }

    /// Number of minor steps per major step.
    fn minor_divisions(self) -> i64 {
        if self.mantissa == 2 { 4 } else { 5 }
    }

    /// Step of the minor grid.
    fn minor(self) -> Step {
        match self.mantissa {
            1 => Step { mantissa: 2, exponent: self.exponent - 1 },
            2 => Step { mantissa: 5, exponent: self.exponent - 1 },
            _ => Step { mantissa: 1, exponent: self.exponent },
        }
    }

    /// Power of ten for the labels, a multiple of three; `count` is the largest tick in steps. Values from 0.01
    /// to below 100 000 are written without a power.
    fn engineering_exponent(self, count: i64) -> i32 {
        if count == 0 {
            return 0;
        }
        // Decade of the leading digit, computed in integers.
        let decade = (count * self.mantissa).ilog10() as i32 + self.exponent;
        if (-2..5).contains(&decade) { 0 } else { 3 * decade.div_euclid(3) }
    }

    /// Exact decimal text of `count` steps: `−0.25`, `150×10³`.
    fn label(self, count: i64, exponent: i32) -> String {
        if count == 0 {
            return "0".into();
        }
        let digits = (count * self.mantissa).unsigned_abs().to_string();
        let shift = self.exponent - exponent;
        let number = match usize::try_from(-shift) {
            Err(_) | Ok(0) => digits + &"0".repeat(shift.max(0) as usize),
            Ok(decimals) => {
                let padded = format!("{digits:0>width$}", width = decimals + 1);
                let (whole, part) = padded.split_at(padded.len() - decimals);
                format!("{whole}.{part}")
            }
        };
        let sign = if count < 0 { "−" } else { "" };
        let power = if exponent == 0 { String::new() } else { format!("×10{}", superscript(exponent)) };
        format!("{sign}{number}{power}")
    }
}

/// Number in superscript digits.
fn superscript(n: i32) -> String {
    let raised = |c: char| match c.to_digit(10) {
        Some(d) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][d as usize],
        None => '⁻',
    };
    n.to_string().chars().map(raised).collect()
}

#[cfg(test)]
#[path = "axis_tests.rs"]
mod tests;
