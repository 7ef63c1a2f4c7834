//! Colour scale: viridis, perceptually uniform and readable with colour vision deficiencies (S. van der Walt
//! and N. Smith, Matplotlib 1.5, 2015; CC0).

use super::Skin;
use crate::limits::{LARGEST_VALUE, LOGARITHMIC, SHOWN_QUANTILE, SMALLEST_VALUE};
use crate::palette::{Colour, ZERO};

/// Colour scale of a skin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Scale {
    pub low: f64,
    pub high: f64,
    /// True if equal steps of colour are equal factors of the value.
    pub logarithmic: bool,
    /// True if some values exceed the high end; they get the colour of the end.
    pub is_capped: bool,
}

impl Scale {
    /// Scale over all drawable values.
    pub fn of(skin: &Skin) -> Self {
        let values = skin.facets().filter_map(|facet| facet.value);
        let mut shown: Vec<f64> = values.filter(|v| v.is_finite() && v.abs() <= LARGEST_VALUE).collect();
        let (mut low, mut high, mut least) = (f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY);
        for &value in &shown {
            (low, high) = (low.min(value), high.max(value));
            if value > SMALLEST_VALUE {
                least = least.min(value);
            }
        }
        let mut is_capped = false;
        if !shown.is_empty() {
            let index = (SHOWN_QUANTILE * shown.len() as f64).ceil() as usize;
            let index = index.clamp(1, shown.len()) - 1;
            let quantile = *shown.select_nth_unstable_by(index, f64::total_cmp).1;
            // Limit the scale at a quantile, so that a few outliers do not take most of the colours.
            is_capped = quantile > 0.0 && high > LOGARITHMIC * quantile;
            high = if is_capped { quantile } else { high };
        }
        if low > high {
            return Self { low: 0.0, high: 1.0, logarithmic: false, is_capped };
        }
        // Zeros get the colour of the smallest positive value.
        let logarithmic = low >= 0.0 && least.is_finite() && high > LOGARITHMIC * least;
        Self { low: if logarithmic { least } else { low }, high, logarithmic, is_capped }
    }

    /// Position of a value on the scale, 0 to 1.
    pub fn position(&self, value: f64) -> f64 {
        if self.high <= self.low {
            return 0.5;
        }
        let position = if self.logarithmic {
            (value.max(self.low) / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        };
        position.clamp(0.0, 1.0)
    }

    /// Colour of a value; grey without a value.
    pub fn colour(&self, value: Option<f64>) -> Colour {
        value.filter(|v| v.is_finite()).map_or(ZERO, |value| viridis(self.position(value)))
    }

    /// Labelled values of the scale.
    pub fn ticks(&self) -> Vec<f64> {
        if self.high <= self.low {
            return vec![self.low];
        }
        if !self.logarithmic {
            return (0..=4).map(|i| self.low + (self.high - self.low) * f64::from(i) / 4.0).collect();
        }
        let steps: &[f64] = if self.high > 1e3 * self.low { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let decades = self.low.log10().floor() as i32..=self.high.log10().ceil() as i32;
        let all = decades.flat_map(|d| steps.iter().map(move |step| step * 10f64.powi(d)));
        let inner = all.filter(|v| (0.06..=0.94).contains(&self.position(*v)));
        [self.low].into_iter().chain(inner).chain([self.high]).collect()
    }
}

/// Viridis colour at 0 to 1.
pub(super) fn viridis(position: f64) -> Colour {
    let c = colorous::VIRIDIS.eval_continuous(position);
    Colour(c.r, c.g, c.b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{SkinFacet, SkinPiece};

    fn of(values: &[Option<f64>]) -> Scale {
        let facet = |value: &Option<f64>| SkinFacet {
            corners: [[0.0; 3]; 3],
            normal: [0.0; 3],
            value: *value,
            status: 0,
        };
        let piece = SkinPiece { facets: values.iter().map(facet).collect(), ..SkinPiece::default() };
        Scale::of(&Skin { pieces: vec![piece], ..Skin::default() })
    }

    #[test]
    fn a_wide_range_is_logarithmic() {
        let wide = of(&[Some(0.0), Some(0.1), None, Some(f64::NAN), Some(100.0)]);
        assert_eq!((wide.low, wide.high, wide.logarithmic), (0.1, 100.0, true));
        assert!((wide.position(10.0 / 10f64.sqrt()) - 0.5).abs() < 1e-12);
        assert_eq!(wide.position(0.0), 0.0);
        let narrow = of(&[Some(2.0), Some(4.0)]);
        assert!(!narrow.logarithmic && narrow.position(3.0) == 0.5);
        assert_eq!(of(&[]).colour(None), ZERO);
        assert_eq!(of(&[Some(3.0)]).position(3.0), 0.5);
    }

    #[test]
    fn a_few_huge_values_do_not_take_the_scale() {
        let mut values: Vec<Option<f64>> = (1..=99).map(|i| Some(f64::from(i))).collect();
        values.push(Some(1e19));
        let scale = of(&values);
        assert!(scale.is_capped && scale.high < 100.0, "{scale:?}");
        assert_eq!(scale.position(1e19), 1.0);
        assert!(!of(&values[..99]).is_capped);
    }

    /// Ends of viridis as in Matplotlib, and monotonically increasing lightness.
    #[test]
    fn colours_are_viridis() {
        assert_eq!((viridis(0.0), viridis(1.0)), (Colour(68, 1, 84), Colour(253, 231, 37)));
        let light = |c: Colour| 0.2126 * f64::from(c.0) + 0.7152 * f64::from(c.1) + 0.0722 * f64::from(c.2);
        assert!(
            (1..=100).all(
                |i| light(viridis(f64::from(i) / 100.0)) > light(viridis(f64::from(i - 1) / 100.0)) - 1.0
            )
        );
    }
}
