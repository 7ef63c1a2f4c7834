//! Numbers in texts for people: one number of digits, a true minus sign, and one form of the unit of each quantity. JSON and CSV do not use
//! this module.

use crate::terminal::limits;
use std::borrow::Cow;
use std::cell::Cell;

thread_local! {
    /// Significant digits of the texts of the run on this thread.
    static DIGITS: Cell<usize> = const { Cell::new(limits::DIGITS) };
}

/// Selects the number of significant digits of all texts; `None`: the default.
pub fn use_digits(count: Option<u8>) {
    DIGITS.set(count.map_or(limits::DIGITS, usize::from));
}

/// Number of significant digits.
pub fn digits() -> usize {
    DIGITS.get()
}

/// Value that is rounding relative to `size`, as 0.
pub fn rounded(value: f64, size: f64) -> f64 {
    if value.abs() < limits::COMPONENT_ROUNDING * size { 0.0 } else { value }
}

/// Formats the significant digits without trailing zeros. Digits before the decimal point are never rounded; very small and very large
/// numbers have an exponent.
pub fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let scientific = format!("{x:.*e}", digits() - 1);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let magnitude: i32 = exponent.parse().unwrap_or_default();
    if !(-4..9).contains(&magnitude) {
        return true_minus(&format!("{}e{exponent}", trim_zeros(mantissa))).into_owned();
    }
    true_minus(trim_zeros(&format!("{x:.*}", decimals_of(x)))).into_owned()
}

/// Number of decimals for the significant digits of a number.
pub fn decimals_of(x: f64) -> usize {
    let scientific = format!("{x:.*e}", digits() - 1);
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    exponent.map_or(0, |exponent| (digits() as i32 - 1 - exponent).max(0) as usize)
}

/// Formats a number of decimals; a value that rounds to zero has no sign.
pub fn fixed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.trim_start_matches(['0', '.']).is_empty() => zero.to_owned(),
        Some(size) => format!("−{size}"),
        None => text,
    }
}

/// Formats a change with its sign; a value that rounds to zero has none.
pub fn signed(x: f64, decimals: usize) -> String {
    let text = fixed(x, decimals);
    let is_zero = text.trim_start_matches(['0', '.']).is_empty();
    if x > 0.0 && !is_zero { format!("+{text}") } else { text }
}

/// Force (N) or moment (N·m) with its unit: from 1000 on in kN.
pub fn load(value: f64, unit: &str) -> String {
    if value.abs() >= limits::KILO {
        format!("{} k{unit}", number(value / limits::KILO))
    } else {
        with_unit(value, unit)
    }
}

/// Stiffness (SI) of a contact with its unit: N/mm for a linear contact at a point.
pub fn stiffness(value: f64, force: &str, length: &str, exponent: f64) -> String {
    match (exponent == 1.0, length) {
        (true, "m") => with_unit(value / limits::KILO, &format!("{force}/mm")),
        (true, _) => with_unit(value, &format!("{force}/{length}")),
        (false, _) => with_unit(value, &format!("{force}/{length}^{}", number(exponent))),
    }
}

/// Number with a unit.
pub fn with_unit(value: f64, unit: &str) -> String {
    format!("{} {unit}", number(value))
}

/// Formats a number with the digits that its uncertainty supports: to the second significant digit of the uncertainty.
pub fn within_uncertainty(x: f64, uncertainty: f64) -> String {
    let place = uncertainty.log10().floor();
    if !(-12.0..9.0).contains(&place) {
        return number(x);
    }
    let decimals = 1 - place as i32;
    if decimals >= 0 {
        return fixed(x, decimals as usize);
    }
    let unit = 10_f64.powi(-decimals);
    fixed((x / unit).round() * unit, 0)
}

/// Formats at most the significant digits that an uncertainty supports, to its second one; a bound for a number below its uncertainty.
pub fn supported(x: f64, uncertainty: f64) -> String {
    if x == 0.0 {
        return number(x);
    }
    if x.abs() <= uncertainty {
        return format!("less than {}", upper_bound(uncertainty));
    }
    let figures = x.abs().log10().floor() - uncertainty.log10().floor() + 2.0;
    if figures < digits() as f64 {
        return format!("{x:.*e}", figures as usize - 1).parse().map_or_else(|_| number(x), number);
    }
    number(x)
}

/// Formats one digit, rounded up: for upper bounds. Two digits for a number slightly above a power of ten: 1.1e-3, not 2e-3.
pub fn upper_bound(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let nearest = format!("{x:.0e}");
    let above = || {
        let (digit, exponent) = nearest.split_once('e')?;
        let two_digits = format!("1.1e{exponent}");
        if digit == "1" && two_digits.parse().is_ok_and(|bound: f64| x <= bound) {
            return Some(two_digits);
        }
        let above: f64 = format!("{}e{exponent}", digit.parse::<u8>().ok()? + 1).parse().ok()?;
        Some(format!("{above:.0e}"))
    };
    match nearest.parse::<f64>() {
        Ok(shown) if shown < x => above().unwrap_or(nearest),
        _ => nearest,
    }
}

/// Formats `(x, y, z)`; a component that is rounding noise relative to the largest is shown as 0.
pub fn triple(v: &[f64; 3]) -> String {
    let largest = v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let [x, y, z] = v.map(|x| number(rounded(x, largest)));
    format!("({x}, {y}, {z})")
}

/// Removes trailing zeros after the decimal point.
pub fn trim_zeros(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

/// True if the characters begin with a number without a unit directly behind it.
fn is_plain_number(mut rest: impl Iterator<Item = char>) -> bool {
    let begins = rest.next().is_some_and(|c| c.is_ascii_digit() || c == '.');
    let end = rest.find(|c| !(c.is_ascii_digit() || *c == '.'));
    begins && end.is_none_or(|c| c == 'e' || !c.is_alphabetic())
}

/// Text with a minus sign in place of the hyphen of a negative number. Values of flags, exponents and values with their unit such as -40deg
/// keep the hyphen, because they are copied.
pub fn true_minus(text: &str) -> Cow<'_, str> {
    if !text.contains('-') {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 8);
    // The word before the number, and the character before the hyphen.
    let (mut word, mut last) = (String::new(), ' ');
    let mut is_flag = false;
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let begins = last.is_whitespace() || matches!(last, '(' | '[' | '±' | '\u{2007}');
        let is_negative = c == '-' && begins && !is_flag && is_plain_number(rest.clone());
        out.push(if is_negative { '−' } else { c });
        if c.is_whitespace() {
            if !word.is_empty() {
                is_flag = word.starts_with("--");
            }
            word.clear();
        } else {
            word.push(c);
        }
        last = c;
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_is_never_less_than_what_it_bounds() {
        let cases = [
            (1e-13, "1e-13"),
            (1.4e-13, "2e-13"),
            (1.6e-13, "2e-13"),
            (9.4e-14, "1e-13"),
            (0.0, "0"),
            (1.0000000000000937e-3, "1.1e-3"),
        ];
        for (x, shown) in cases {
            assert_eq!(upper_bound(x), shown);
        }
        for k in -3000..3000 {
            let x = (0.1 * f64::from(k)).exp();
            let shown: f64 = upper_bound(x).parse().expect("a number");
            assert!(x <= shown && shown <= 2.0 * x, "{x} by {shown}");
        }
        assert_eq!(upper_bound(f64::NAN), "NaN");
        assert_eq!(upper_bound(f64::INFINITY), "inf");
    }

    #[test]
    fn a_number_has_the_digits_of_its_uncertainty() {
        let cases =
            [(137.800409, 1.1782, "137.8"), (0.0123456, 3.4e-4, "0.01235"), (-98765.4, 1234.0, "−98800")];
        for (x, uncertainty, text) in cases {
            assert_eq!(within_uncertainty(x, uncertainty), text);
        }
        let cases = [
            (0.44721359, 2e-7, "0.4472"),
            (0.44721359, 3e-2, "0.447"),
            (-5.2e-10, 2e-7, "less than 2e-7"),
            (-2.34e-7, 2e-7, "−2.3e-7"),
            (0.75, 0.0, "0.75"),
            (0.0, 1e-9, "0"),
        ];
        for (x, uncertainty, text) in cases {
            assert_eq!(supported(x, uncertainty), text);
        }
        // Without an uncertainty, all digits.
        assert_eq!(within_uncertainty(0.75, 0.0), "0.75");
    }

    #[test]
    fn numbers_have_the_selected_digits_and_a_minus_sign() {
        let cases = [
            (0.75, "0.75", "0.75"),
            (207.342164123, "207.3", "207.342164"),
            (-3.3333333333e-7, "−3.333e-7", "−3.33333333e-7"),
            (-0.5, "−0.5", "−0.5"),
            (1e12, "1e12", "1e12"),
            (123456789.4, "123456789", "123456789"),
            (0.0, "0", "0"),
            (999.96, "1000", "999.96"),
            (0.00099999, "0.001", "0.00099999"),
        ];
        for (x, short, long) in cases {
            assert_eq!(number(x), short);
            use_digits(Some(9));
            assert_eq!(number(x), long);
            use_digits(None);
        }
        assert_eq!(load(7731.37, "N"), "7.731 kN");
        assert_eq!(stiffness(4e5, "N", "m", 1.0), "400 N/mm");
        assert_eq!([signed(-0.004, 2), signed(0.126, 2), signed(-0.126, 2)], ["0.00", "+0.13", "−0.13"]);
    }

    #[test]
    fn hyphens_of_flags_names_and_exponents_are_kept() {
        for (text, shown) in [
            ("-1.5 and (-2, -.5)", "−1.5 and (−2, −.5)"),
            ("--normal -1,0,0 is -1", "--normal -1,0,0 is −1"),
            ("--set a=-40deg", "--set a=-40deg"),
            ("write -40deg for -1e-7 and -40 deg", "write -40deg for −1e-7 and −40 deg"),
            ("link-2 at 1e-7 on 2026-11-26", "link-2 at 1e-7 on 2026-11-26"),
        ] {
            assert_eq!(true_minus(text), shown);
        }
    }
}
