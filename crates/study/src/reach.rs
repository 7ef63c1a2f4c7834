//! Which rows of a sweep are known to be out of reach, so that none walks a branch again to find out what is known.
//!
//! A row is reached from the last one that was, along the branch. Where that branch ended for one row, it ends for all
//! that lie beyond in the same direction, until another row is answered and the start is another.

use crate::thresholds::{AT_END, PROBABLE, UNRELATED};

/// What a row that was not reached means for others from the same start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Extent {
    /// No value beyond this one is reached: the branch ends there.
    Beyond(f64),
    /// The branch goes on beyond this value, but following it so far is as much work as is done for a row.
    TooFar(f64),
    /// No value beyond the row's own is reached, and probably none beyond this one.
    Probably(f64),
    /// What failed does not depend on the value.
    Everywhere,
    /// Nothing: other rows start otherwise.
    Nothing,
}

impl Extent {
    /// Whether poses between may help.
    pub fn is_too_far(self) -> bool {
        matches!(self, Extent::TooFar(_))
    }
}

/// A row that was not reached.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Missed {
    pub why: String,
    pub extent: Extent,
}

/// Rows that were not tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Untried {
    pub count: usize,
    /// The first of them.
    pub first: usize,
    /// The row that it was left out for.
    pub found_by: usize,
}

/// What is known of one direction.
#[derive(Clone, Copy, Debug, Default)]
struct Side {
    /// The value beyond which nothing is reached, and the row that found it.
    end: Option<(f64, usize)>,
    /// The furthest value that a search came to, and how many ended so.
    furthest: Option<(f64, usize, usize)>,
}

/// What is known about the rows that are out of reach.
#[derive(Debug, Default)]
pub(crate) struct Reach {
    /// Downwards, upwards.
    sides: [Side; 2],
    everywhere: Option<usize>,
    unrelated: usize,
    /// The value of the last row that was answered; 0 before.
    from: f64,
    /// How far a branch was followed until it was too far, and for which row: no row is followed as far again, whatever
    /// its start and direction.
    longest: Option<(f64, usize)>,
    untried: Option<Untried>,
}

impl Reach {
    /// Where a row need not be tried: the row that knows.
    pub fn excludes(&self, value: f64) -> Option<usize> {
        if self.everywhere.is_some() {
            return self.everywhere;
        }
        if let Some((length, row)) = self.longest
            && (value - self.from).abs() > length
        {
            return Some(row);
        }
        for (side, sign) in self.sides.iter().zip([-1.0, 1.0]) {
            if let Some((end, row)) = side.end
                && sign * (value - end) >= 0.0
            {
                return Some(row);
            }
            if let Some((furthest, row, searches)) = side.furthest
                && searches >= PROBABLE
                && sign * (value - furthest) > AT_END * furthest.abs().max(1.0)
            {
                return Some(row);
            }
        }
        None
    }

    /// Takes note of a row that was not tried, for what another row found.
    pub fn skip(&mut self, row: usize, found_by: usize) -> String {
        self.untried.get_or_insert(Untried { count: 0, first: row, found_by }).count += 1;
        format!("not tried: it lies at least as far out as where row {found_by} ended")
    }

    /// Takes note of a row that was not reached.
    pub fn missed(&mut self, row: usize, value: f64, extent: Extent) {
        let side = |at: f64| usize::from(value > at);
        match extent {
            Extent::Beyond(at) => {
                let sign = if value > at { 1.0 } else { -1.0 };
                // The end itself may have been found to rounding only.
                let end = at + sign * AT_END * at.abs().max(1.0);
                let end = if sign * (value - end) > 0.0 { end } else { value };
                self.sides[side(at)].end = Some((end, row));
            }
            Extent::Probably(at) => {
                let up = value > at;
                let side = &mut self.sides[side(at)];
                let nearer = |(end, _): (f64, usize)| (value < end) == up;
                if side.end.is_none_or(nearer) {
                    side.end = Some((value, row));
                }
                let furthest = side.furthest.get_or_insert((at, row, 0));
                if (at > furthest.0) == up {
                    (furthest.0, furthest.1) = (at, row);
                }
                furthest.2 += 1;
            }
            Extent::TooFar(at) => {
                self.longest = Some(((at - self.from).abs(), row));
                self.missed(row, value, Extent::Beyond(at));
            }
            Extent::Everywhere => self.everywhere = Some(row),
            Extent::Nothing => {
                self.unrelated += 1;
                if self.unrelated >= UNRELATED {
                    self.everywhere = Some(row);
                }
            }
        }
    }

    /// A row was answered at a value: what was known of the old start is not of this one.
    pub fn answered(&mut self, value: f64) {
        *self = Self { from: value, longest: self.longest, untried: self.untried, ..Self::default() };
    }

    /// The rows that were not tried since this was asked last.
    pub fn take_untried(&mut self) -> Option<Untried> {
        self.untried.take()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_beyond_an_end_are_known() {
        let mut reach = Reach::default();
        reach.missed(3, 5.0, Extent::Beyond(2.0));
        assert_eq!(
            [1.9, 2.0, 2.1, 5.0, -9.0].map(|v| reach.excludes(v)),
            [None, None, Some(3), Some(3), None]
        );
        reach.missed(7, -4.0, Extent::Beyond(-1.0));
        assert_eq!([-0.9, -1.1].map(|v| reach.excludes(v)), [None, Some(7)]);
        reach.answered(1.0);
        assert_eq!(reach.excludes(5.0), None);
    }

    /// A long walk is made once: neither again in the same direction, nor in the other.
    #[test]
    fn a_walk_that_is_too_long_is_made_once() {
        let mut reach = Reach::default();
        reach.missed(0, 1e9, Extent::TooFar(100.0));
        assert_eq!([99.0, 101.0, -99.0, -101.0].map(|v| reach.excludes(v)), [None, Some(0), None, Some(0)]);
        reach.answered(50.0);
        assert_eq!([149.0, 151.0, -51.0].map(|v| reach.excludes(v)), [None, Some(0), Some(0)]);
    }

    #[test]
    fn searches_that_end_short_are_counted() {
        let mut reach = Reach::default();
        for row in 0..PROBABLE {
            assert_eq!(reach.excludes(8.0 - 0.1 * row as f64), None);
            reach.missed(row, 8.0 - 0.1 * row as f64, Extent::Probably(1.0 + 0.01 * row as f64));
        }
        assert_eq!(reach.excludes(9.0), Some(PROBABLE - 1));
        assert_eq!(reach.excludes(1.2), Some(PROBABLE - 1));
        assert_eq!(reach.excludes(1.1), None);
    }

    #[test]
    fn rows_that_say_nothing_of_others_have_a_budget() {
        let mut reach = Reach::default();
        for row in 0..UNRELATED {
            assert_eq!(reach.excludes(1.0), None);
            reach.missed(row, 1.0, Extent::Nothing);
        }
        assert_eq!(reach.excludes(0.0), Some(UNRELATED - 1));
    }
}
