//! Deviations, their bounds, and the worst of them.

/// Keeps the worst of many deviations and fails on the first that passes its bound.
#[derive(Clone, Debug)]
pub struct Gauge {
    what: &'static str,
    count: usize,
    worst: f64,
    worst_case: String,
    fullest: f64,
}

impl Gauge {
    /// A gauge of one quantity.
    pub fn new(what: &'static str) -> Self {
        Self { what, count: 0, worst: 0.0, worst_case: String::new(), fullest: 0.0 }
    }

    /// Notes a deviation.
    ///
    /// # Panics
    /// Where it passes its bound, or is NaN.
    pub fn note(&mut self, case: &str, deviation: f64, bound: f64) {
        assert!(deviation <= bound, "{}: {case}: deviation {deviation:e}, bound {bound:e}", self.what);
        self.count += 1;
        if deviation > self.worst {
            self.worst = deviation;
            case.clone_into(&mut self.worst_case);
        }
        self.fullest = self.fullest.max(deviation / bound);
    }

    /// Notes how far `got` is from `expected`, relative to `expected`.
    ///
    /// # Panics
    /// Where that passes the bound, or is NaN.
    pub fn relative(&mut self, case: &str, got: f64, expected: f64, bound: f64) {
        self.note(case, ((got - expected) / expected).abs(), bound);
    }

    /// How many deviations were noted.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Says the worst deviation, and how much of its bound was ever used (`--nocapture` shows it).
    ///
    /// # Panics
    /// Where nothing was measured: a comparison that never ran proves nothing.
    pub fn report(&self) {
        assert!(self.count > 0, "{}: nothing was compared", self.what);
        let Self { what, count, worst, worst_case, fullest } = self;
        println!(
            "{what}: {count} compared, worst {worst:.1e} ({worst_case}), at most {fullest:.2} of its bound"
        );
    }
}
