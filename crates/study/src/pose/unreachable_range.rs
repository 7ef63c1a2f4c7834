//! Unreachable range of a line of rows, so that no branch is followed again to find a known limit.
//!
//! Each row starts from the last row reached, along the branch. An end of the branch found for one row holds
//! for all rows beyond in the same direction, until another row is reached and the start changes.

use crate::thresholds::{MOST_UNREACHED_ROWS, RANGE_END_TOLERANCE, SEARCHES_BEFORE_EXCLUSION};

/// Consequence of a row that is not reached, for other rows with the same start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum UnreachableExtent {
    /// Branch ends at this value; no value beyond is reachable.
    BeyondEnd(f64),
    /// Branch continues beyond this value, but following the branch farther exceeds the work limit of a row.
    BeyondWorkLimit(f64),
    /// No value beyond the row's own value is reachable, and probably none beyond this value.
    ProbablyBeyond(f64),
    /// Failure is independent of the value.
    Everywhere,
    /// No consequence: other rows have other starts.
    ThisRowOnly,
}

impl UnreachableExtent {
    /// True if the search stopped at the work limit: a row between the last row and this one may help.
    pub fn exceeds_work_limit(self) -> bool {
        matches!(self, UnreachableExtent::BeyondWorkLimit(_))
    }

    /// Limit found: the reachable value nearest to the value of the row. `None` if no limit was found.
    pub fn nearest(self) -> Option<f64> {
        match self {
            UnreachableExtent::BeyondEnd(nearest)
            | UnreachableExtent::BeyondWorkLimit(nearest)
            | UnreachableExtent::ProbablyBeyond(nearest) => Some(nearest),
            UnreachableExtent::Everywhere | UnreachableExtent::ThisRowOnly => None,
        }
    }
}

/// Row that was not reached.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct UnreachedRow {
    pub reason: String,
    pub extent: UnreachableExtent,
}

/// Rows that were not tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SkippedRows {
    pub count: usize,
    /// First row not tried.
    pub first: usize,
    /// Row that found the limit.
    pub found_by: usize,
}

/// Limits in one direction.
#[derive(Clone, Copy, Debug, Default)]
struct DirectionLimits {
    /// Value beyond which nothing is reachable, and the row that found the value.
    end: Option<(f64, usize)>,
    /// Farthest value of all failed searches, the row of this search, and the number of searches.
    farthest_search: Option<(f64, usize, usize)>,
}

/// Unreachable range of the rows from the current start.
#[derive(Debug, Default)]
pub(crate) struct UnreachableRange {
    /// Limits downwards and upwards.
    directions: [DirectionLimits; 2],
    all_excluded_by: Option<usize>,
    unrelated: usize,
    /// Value of the last row reached; 0 before the first.
    last_reached: f64,
    /// Distance followed when the work limit was exceeded, and the row. No row at a larger distance is tried,
    /// for any start and direction.
    step_limit: Option<(f64, usize)>,
    skipped: Option<SkippedRows>,
}

impl UnreachableRange {
    /// Row that excludes `value`; `None` if the value should be tried.
    pub fn excluding_row(&self, value: f64) -> Option<usize> {
        if self.all_excluded_by.is_some() {
            return self.all_excluded_by;
        }
        if let Some((length, row)) = self.step_limit
            && (value - self.last_reached).abs() > length
        {
            return Some(row);
        }
        for (side, sign) in self.directions.iter().zip([-1.0, 1.0]) {
            if let Some((end, row)) = side.end
                && sign * (value - end) >= 0.0
            {
                return Some(row);
            }
            if let Some((furthest, row, searches)) = side.farthest_search
                && searches >= SEARCHES_BEFORE_EXCLUSION
                && sign * (value - furthest) > RANGE_END_TOLERANCE * furthest.abs().max(1.0)
            {
                return Some(row);
            }
        }
        None
    }

    /// Counts a row that was not tried because of row `found_by`. Returns the message for the row.
    pub fn skip(&mut self, row: usize, found_by: usize) -> String {
        self.skipped.get_or_insert(SkippedRows { count: 0, first: row, found_by }).count += 1;
        format!(
            "not tried: it is at least as far away as the end of the reachable range found by row {found_by}"
        )
    }

    /// Records a row that was not reached.
    pub fn record_unreached(&mut self, row: usize, value: f64, extent: UnreachableExtent) {
        let side = |at: f64| usize::from(value > at);
        match extent {
            UnreachableExtent::BeyondEnd(at) => {
                let sign = if value > at { 1.0 } else { -1.0 };
                // The end may be accurate to rounding only.
                let end = at + sign * RANGE_END_TOLERANCE * at.abs().max(1.0);
                let end = if sign * (value - end) > 0.0 { end } else { value };
                self.directions[side(at)].end = Some((end, row));
            }
            UnreachableExtent::ProbablyBeyond(at) => {
                let up = value > at;
                let side = &mut self.directions[side(at)];
                let nearer = |(end, _): (f64, usize)| (value < end) == up;
                if side.end.is_none_or(nearer) {
                    side.end = Some((value, row));
                }
                let furthest = side.farthest_search.get_or_insert((at, row, 0));
                if (at > furthest.0) == up {
                    (furthest.0, furthest.1) = (at, row);
                }
                furthest.2 += 1;
            }
            UnreachableExtent::BeyondWorkLimit(at) => {
                self.step_limit = Some(((at - self.last_reached).abs(), row));
                self.record_unreached(row, value, UnreachableExtent::BeyondEnd(at));
            }
            UnreachableExtent::Everywhere => self.all_excluded_by = Some(row),
            UnreachableExtent::ThisRowOnly => {
                self.unrelated += 1;
                if self.unrelated >= MOST_UNREACHED_ROWS {
                    self.all_excluded_by = Some(row);
                }
            }
        }
    }

    /// Records a row that was reached. The limits of the old start are cleared.
    pub fn record_reached(&mut self, value: f64) {
        *self = Self {
            last_reached: value,
            step_limit: self.step_limit,
            skipped: self.skipped,
            ..Self::default()
        };
    }

    /// Rows not tried since the last call.
    pub fn drain_skipped(&mut self) -> Option<SkippedRows> {
        self.skipped.take()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_beyond_an_end_are_known() {
        let mut reach = UnreachableRange::default();
        reach.record_unreached(3, 5.0, UnreachableExtent::BeyondEnd(2.0));
        assert_eq!(
            [1.9, 2.0, 2.1, 5.0, -9.0].map(|v| reach.excluding_row(v)),
            [None, None, Some(3), Some(3), None]
        );
        reach.record_unreached(7, -4.0, UnreachableExtent::BeyondEnd(-1.0));
        assert_eq!([-0.9, -1.1].map(|v| reach.excluding_row(v)), [None, Some(7)]);
        reach.record_reached(1.0);
        assert_eq!(reach.excluding_row(5.0), None);
    }

    /// A search beyond the work limit happens once: no second search in the same or the opposite direction.
    #[test]
    fn a_search_that_is_too_long_is_made_once() {
        let mut reach = UnreachableRange::default();
        reach.record_unreached(0, 1e9, UnreachableExtent::BeyondWorkLimit(100.0));
        assert_eq!(
            [99.0, 101.0, -99.0, -101.0].map(|v| reach.excluding_row(v)),
            [None, Some(0), None, Some(0)]
        );
        reach.record_reached(50.0);
        assert_eq!([149.0, 151.0, -51.0].map(|v| reach.excluding_row(v)), [None, Some(0), Some(0)]);
    }

    #[test]
    fn searches_that_end_short_are_counted() {
        let mut reach = UnreachableRange::default();
        for row in 0..SEARCHES_BEFORE_EXCLUSION {
            assert_eq!(reach.excluding_row(8.0 - 0.1 * row as f64), None);
            reach.record_unreached(
                row,
                8.0 - 0.1 * row as f64,
                UnreachableExtent::ProbablyBeyond(1.0 + 0.01 * row as f64),
            );
        }
        assert_eq!(reach.excluding_row(9.0), Some(SEARCHES_BEFORE_EXCLUSION - 1));
        assert_eq!(reach.excluding_row(1.2), Some(SEARCHES_BEFORE_EXCLUSION - 1));
        assert_eq!(reach.excluding_row(1.1), None);
    }

    #[test]
    fn rows_that_say_nothing_of_others_have_a_budget() {
        let mut reach = UnreachableRange::default();
        for row in 0..MOST_UNREACHED_ROWS {
            assert_eq!(reach.excluding_row(1.0), None);
            reach.record_unreached(row, 1.0, UnreachableExtent::ThisRowOnly);
        }
        assert_eq!(reach.excluding_row(0.0), Some(MOST_UNREACHED_ROWS - 1));
    }
}
