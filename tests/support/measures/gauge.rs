//! Deviations with bounds, and the worst deviation.

/// Records the worst of many deviations and fails on the first deviation above its bound.
#[derive(Clone, Debug)]
pub struct Gauge {
    what: &'static str,
    count: usize,
    worst: f64,
    worst_case: String,
    fullest: f64,
}

impl Gauge {
    /// New gauge of one quantity.
    pub fn new(what: &'static str) -> Self {
        Self { what, count: 0, worst: 0.0, worst_case: String::new(), fullest: 0.0 }
    }

    /// Records a deviation.
    ///
    /// # Panics
    /// If the deviation exceeds its bound or is NaN.
    pub fn note(&mut self, case: &str, deviation: f64, bound: f64) {
        assert!(deviation <= bound, "{}: {case}: deviation {deviation:e}, bound {bound:e}", self.what);
        self.count += 1;
        if deviation > self.worst {
            self.worst = deviation;
            case.clone_into(&mut self.worst_case);
        }
        self.fullest = self.fullest.max(deviation / bound);
    }

    /// Records the deviation of `got` from `expected`, relative to `expected`.
    ///
    /// # Panics
    /// If the deviation exceeds its bound or is NaN.
    pub fn relative(&mut self, case: &str, got: f64, expected: f64, bound: f64) {
        self.note(case, ((got - expected) / expected).abs(), bound);
    }

    /// Number of recorded deviations.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Prints the worst deviation and the largest used fraction of a bound (visible with `--nocapture`).
    ///
    /// # Panics
    /// If no deviation was recorded: a comparison that never ran proves nothing.
    pub fn report(&self) {
        assert!(self.count > 0, "{}: nothing was compared", self.what);
        let Self { what, count, worst, worst_case, fullest } = self;
        println!(
            "{what}: {count} compared, worst {worst:.1e} ({worst_case}), at most {fullest:.2} of its bound"
        );
    }
}
