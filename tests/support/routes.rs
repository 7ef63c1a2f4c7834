//! Statistics of the routes: the recursion or the dense route, with the reasons.

use percuss_dynamics::{ContactResponse, DenseReason, EffectiveMass, Route};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Finite contacts by route.
#[derive(Clone, Debug, Default)]
pub struct Routes {
    /// By the recursion alone.
    pub recursion: usize,
    /// By the recursion after the dense route gave no better result.
    pub kept: usize,
    /// By the dense route.
    pub dense: usize,
    /// Reasons for the dense route, by [`reason`].
    pub reasons: BTreeMap<String, usize>,
}

/// Reason for the dense route as text; errors by their decade.
pub fn reason(reason: &DenseReason) -> String {
    match reason {
        DenseReason::NegativeMass => "negative mass".into(),
        DenseReason::Massless => "massless".into(),
        DenseReason::Error { relative } => format!("error 1e{:.0}", relative.log10().floor()),
    }
}

impl Routes {
    /// Counts a finite result of the automatic choice.
    pub fn count(&mut self, response: &ContactResponse) {
        if !matches!(response.effective_mass, EffectiveMass::Finite(_)) {
            return;
        }
        match (response.route, response.dense_reason) {
            (Route::Dense, _) => self.dense += 1,
            (Route::Articulated, Some(_)) => self.kept += 1,
            (Route::Articulated, None) => self.recursion += 1,
        }
        if let Some(why) = &response.dense_reason {
            *self.reasons.entry(reason(why)).or_default() += 1;
        }
    }

    /// Adds other counts.
    pub fn add(&mut self, other: &Self) {
        self.recursion += other.recursion;
        self.kept += other.kept;
        self.dense += other.dense;
        for (why, n) in &other.reasons {
            *self.reasons.entry(why.clone()).or_default() += n;
        }
    }

    /// Column headings of [`Self::line`].
    pub const HEADER: &str =
        "finite contacts         recursion    dense     kept  reasons for the dense route";

    /// A line of the table.
    pub fn line(&self, suite: &str) -> String {
        let mut reasons: Vec<_> = self.reasons.iter().collect();
        reasons.sort_by_key(|(_, n)| Reverse(**n));
        let reasons: Vec<String> = reasons.into_iter().map(|(why, n)| format!("{why}: {n}")).collect();
        let Self { recursion, dense, kept, .. } = self;
        format!("{suite:22}{recursion:11}{dense:9}{kept:9}  {}", reasons.join(", ")).trim_end().to_owned()
    }
}
