//! Search for the place at which a point has a requested displacement: Newton's method along one driver, within the
//! range of monotonic displacement.
//!
//! Limits of a travel are bracketed like solutions: the limit of the driver, beyond which no pose exists, and the
//! reversal of the point.

use crate::loops::assembling::AssemblyError;
use crate::tolerances::{
    DISPLACEMENT_ACCURACY, ENCLOSED_STEPS, FIRST_STEP, LONGEST_STEP, MET_TO_ROUNDING, POLISHED, STATIONARY,
    TRAVEL_STEPS,
};

/// A pose along the motion of a driver.
#[derive(Clone, Debug)]
pub(crate) struct TravelPoint<P> {
    pub pose: P,
    /// Position of the driver, rad or m.
    pub driver: f64,
    /// Displacement of the point, m.
    pub displacement: f64,
    /// Rate of the displacement; `None` if not determined.
    pub rate: Option<f64>,
}

/// Reason for a missing pose at a driver position.
#[derive(Clone, Debug)]
pub(crate) enum VisitError {
    /// No pose exists there; `end` is the limit of the driver, if found.
    NoPose { error: AssemblyError, end: Option<f64> },
    /// The input is invalid.
    Fault(AssemblyError),
}

/// Reason for not reaching a displacement.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SearchError {
    /// The driver reached its limit, or the point reversed. `nearest`: displacement nearest to the requested one, m.
    Unreachable { nearest: f64 },
    /// The step limit was reached. `reached`: displacement of the point, m.
    TooFar { reached: f64 },
    /// No step was possible, or a pose is invalid.
    Assembly(AssemblyError),
}

/// Reference lengths for displacements and steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    /// Size of the mechanism, m.
    pub size: f64,
    /// Unit of the driver: 1 rad, or the size.
    pub unit: f64,
}

/// Far end of the bracket around the solution.
enum BracketEnd<P> {
    /// A place beyond the requested displacement.
    Beyond(TravelPoint<P>),
    /// A place after the reversal of the point.
    Reversed(TravelPoint<P>),
    /// The limit of the driver, short of the displacement. The point may have reversed before the limit.
    DriverLimit(TravelPoint<P>),
    /// A driver position without a pose, or the limit of the driver, at which a pose may exist.
    NoPose { driver: f64, is_end: bool },
}

impl<P> BracketEnd<P> {
    /// Position of the driver at this end.
    fn driver(&self) -> f64 {
        match self {
            BracketEnd::Beyond(place) | BracketEnd::Reversed(place) | BracketEnd::DriverLimit(place) => {
                place.driver
            }
            BracketEnd::NoPose { driver, .. } => *driver,
        }
    }
}

/// Place at a driver position, or the reason for its absence.
type VisitResult<P> = Result<TravelPoint<P>, VisitError>;

/// Search for one displacement.
pub(crate) struct Search<'a, P> {
    pub scale: Scale,
    /// Requested displacement, m.
    pub requested: f64,
    /// Returns the place at a driver position, followed from another pose.
    pub visit: &'a mut (dyn FnMut(&P, f64) -> VisitResult<P> + 'a),
}

impl<P> Search<'_, P> {
    /// Remaining displacement to the requested one, m.
    fn remaining_displacement(&self, place: &TravelPoint<P>) -> f64 {
        self.requested - place.displacement
    }

    /// True if the requested displacement is reached.
    fn is_reached(&self, place: &TravelPoint<P>) -> bool {
        self.remaining_displacement(place).abs() <= DISPLACEMENT_ACCURACY * self.scale.size
    }

    /// The rate, if its sign is determined.
    fn rate(&self, place: &TravelPoint<P>) -> Option<f64> {
        let Scale { size, unit } = self.scale;
        place.rate.filter(|rate| rate.is_finite() && (rate * unit).abs() > STATIONARY * size)
    }

    /// Searches the requested displacement, starting at a known place.
    pub fn run(mut self, start: TravelPoint<P>) -> Result<TravelPoint<P>, SearchError> {
        if self.is_reached(&start) {
            return Ok(start);
        }
        let start = if self.rate(&start).is_some() { start } else { self.step_from_undetermined(&start)? };
        if self.is_reached(&start) {
            return Ok(start);
        }
        let Some(rate) = self.rate(&start) else {
            return Err(SearchError::Unreachable { nearest: start.displacement });
        };
        // Direction of the driver towards the requested displacement.
        let ahead = self.remaining_displacement(&start).signum() * rate.signum();
        let found = self.step_until_bracketed(start, ahead)?;
        Ok(self.polish(found))
    }

    /// One more Newton step, if the remaining error is above rounding.
    fn polish(&mut self, found: TravelPoint<P>) -> TravelPoint<P> {
        let miss = self.remaining_displacement(&found);
        let Some(rate) = self.rate(&found).filter(|_| miss.abs() > POLISHED * self.scale.size) else {
            return found;
        };
        match (self.visit)(&found.pose, found.driver + miss / rate) {
            Ok(place)
                if self.remaining_displacement(&place).abs() < miss.abs()
                    && self.rate(&place).is_some_and(|other| other * rate > 0.0) =>
            {
                place
            }
            _ => found,
        }
    }

    /// Takes a small step of the driver, in either direction, from a pose at which the rate is undetermined.
    fn step_from_undetermined(&mut self, start: &TravelPoint<P>) -> Result<TravelPoint<P>, SearchError> {
        let step = FIRST_STEP * self.scale.unit;
        let mut first = None;
        for step in [step, -step] {
            match (self.visit)(&start.pose, start.driver + step) {
                Ok(place) => return Ok(place),
                Err(VisitError::Fault(error)) => return Err(SearchError::Assembly(error)),
                Err(VisitError::NoPose { error, .. }) => {
                    first.get_or_insert(error);
                }
            }
        }
        Err(first.map_or(SearchError::Unreachable { nearest: start.displacement }, SearchError::Assembly))
    }

    /// Newton steps of limited length, until the displacement is reached or bracketed.
    fn step_until_bracketed(
        &mut self,
        mut near: TravelPoint<P>,
        ahead: f64,
    ) -> Result<TravelPoint<P>, SearchError> {
        let longest = LONGEST_STEP * self.scale.unit;
        for _ in 0..TRAVEL_STEPS {
            let step = match self.rate(&near) {
                Some(rate) => (self.remaining_displacement(&near) / rate).abs().min(longest),
                None => FIRST_STEP * self.scale.unit,
            };
            match self.classify_position(&near, near.driver + ahead * step, ahead)? {
                PositionClass::Reached(place) => return Ok(place),
                PositionClass::Nearer(place) => near = place,
                PositionClass::Bracketed(far) => return self.narrow_bracket(near, far, ahead),
            }
        }
        Err(SearchError::TooFar { reached: near.displacement })
    }

    /// Visits a driver position and classifies it: displacement reached, nearer than `near`, or far end of a bracket.
    /// `near`: a pose before the requested displacement; `ahead`: sign of the driver's motion from there.
    fn classify_position(
        &mut self,
        near: &TravelPoint<P>,
        driver: f64,
        ahead: f64,
    ) -> Result<PositionClass<P>, SearchError> {
        let place = match (self.visit)(&near.pose, driver) {
            Ok(place) => place,
            Err(VisitError::Fault(error)) => return Err(SearchError::Assembly(error)),
            Err(VisitError::NoPose { end, .. }) => {
                let between = |end: &f64| ahead * (end - near.driver) > 0.0 && ahead * (driver - end) > 0.0;
                return Ok(PositionClass::Bracketed(match end.filter(between) {
                    Some(end) => BracketEnd::NoPose { driver: end, is_end: true },
                    None => BracketEnd::NoPose { driver, is_end: false },
                }));
            }
        };
        let (miss, left) = (self.remaining_displacement(near), self.remaining_displacement(&place));
        let over = left * miss < 0.0;
        let turned = match (self.rate(&place), place.rate) {
            (Some(rate), _) => rate * ahead * miss < 0.0,
            // At the reversal itself. A place before the reversal has a rate that leads back.
            (None, Some(_)) => true,
            (None, None) => (place.displacement - near.displacement) * miss < 0.0,
        };
        // A place beyond the reversal is a different pose, even if close.
        Ok(match (turned, self.is_reached(&place)) {
            (false, true) => PositionClass::Reached(place),
            _ if over => PositionClass::Bracketed(BracketEnd::Beyond(place)),
            (true, _) => PositionClass::Bracketed(BracketEnd::Reversed(place)),
            (false, false) => PositionClass::Nearer(place),
        })
    }

    /// Narrows the bracket between a place short of the displacement and its far end.
    fn narrow_bracket(
        &mut self,
        mut near: TravelPoint<P>,
        mut far: BracketEnd<P>,
        ahead: f64,
    ) -> Result<TravelPoint<P>, SearchError> {
        let mut last = f64::INFINITY;
        for _ in 0..ENCLOSED_STEPS {
            let gap = (far.driver() - near.driver).abs();
            let rounding = 2.0 * f64::EPSILON * near.driver.abs().max(f64::EPSILON * self.scale.unit);
            if gap <= rounding || self.is_reversal(&near, &far, gap) {
                break;
            }
            if let BracketEnd::NoPose { driver, is_end: true } = far {
                match self.visit_limit(&near, driver)? {
                    Ok(place) => return Ok(place),
                    Err(end) => far = end,
                }
                continue;
            }
            let (from, step) = self.bracket_step(&near, &far, gap, last, ahead);
            last = step.abs();
            match self.classify_position(&near, from + ahead * step, ahead)? {
                PositionClass::Reached(place) => return Ok(place),
                PositionClass::Nearer(place) => near = place,
                PositionClass::Bracketed(enclosed) => far = enclosed,
            }
        }
        self.bracket_result(near, far)
    }

    /// Visits the exact limit of the driver. `Ok(Ok)`: the limit has the requested displacement; `Ok(Err)`: the limit is the
    /// far end of a bracket. The rate at the limit is not used, since it may have either sign.
    fn visit_limit(
        &mut self,
        near: &TravelPoint<P>,
        driver: f64,
    ) -> Result<Result<TravelPoint<P>, BracketEnd<P>>, SearchError> {
        match (self.visit)(&near.pose, driver) {
            Ok(place) if self.is_reached(&place) => Ok(Ok(place)),
            Ok(mut place) => {
                place.rate = None;
                let over = self.remaining_displacement(&place) * self.remaining_displacement(near) < 0.0;
                Ok(Err(if over { BracketEnd::Beyond(place) } else { BracketEnd::DriverLimit(place) }))
            }
            Err(VisitError::NoPose { .. }) => Ok(Err(BracketEnd::NoPose { driver, is_end: false })),
            Err(VisitError::Fault(error)) => Err(SearchError::Assembly(error)),
        }
    }

    /// Start and length of the next step inside the bracket: a Newton step from one end, the estimated zero of the
    /// rate, or bisection.
    fn bracket_step(
        &self,
        near: &TravelPoint<P>,
        far: &BracketEnd<P>,
        gap: f64,
        last: f64,
        ahead: f64,
    ) -> (f64, f64) {
        let tangent = |place: &TravelPoint<P>| {
            let step = ahead * self.remaining_displacement(place) / self.rate(place)?;
            // Accept only steps that converge at least as fast as bisection.
            (step.abs() < gap && step.abs() <= 0.5 * last).then_some((place.driver, step))
        };
        let forwards = || tangent(near).filter(|(_, step)| *step > 0.0);
        let guess = match far {
            BracketEnd::Beyond(place)
                if self.remaining_displacement(place).abs() < self.remaining_displacement(near).abs() =>
            {
                tangent(place).filter(|(_, step)| *step < 0.0).or_else(forwards)
            }
            BracketEnd::Beyond(_) | BracketEnd::DriverLimit(_) | BracketEnd::NoPose { .. } => forwards(),
            BracketEnd::Reversed(place) => forwards().or_else(|| {
                let (here, there) = (self.rate(near)?, self.rate(place)?);
                let step = gap * here / (here - there);
                (step > 0.0 && step < gap && step <= 0.5 * last).then_some((near.driver, step))
            }),
        };
        guess.unwrap_or((near.driver, 0.5 * gap))
    }

    /// True if the point reverses between two places so close to one of them that the displacement cannot improve in
    /// between. To first order, the rate at that place falls to zero over its part of the bracket.
    fn is_reversal(&self, near: &TravelPoint<P>, far: &BracketEnd<P>, gap: f64) -> bool {
        let BracketEnd::Reversed(place) = far else { return false };
        let (Some(here), Some(there)) = (near.rate, place.rate) else { return false };
        let (here, there) = (here.abs(), there.abs());
        let gain = |rate: f64| rate * gap * rate / (here + there);
        let tolerance = DISPLACEMENT_ACCURACY * self.scale.size;
        // If a place beyond the reversal is close enough, so is a place before the reversal.
        gain(here) <= tolerance
            || gain(there) <= tolerance
                && self.remaining_displacement(place).abs() > MET_TO_ROUNDING * self.scale.size
    }

    /// Result for a bracket reduced to rounding.
    fn bracket_result(
        &self,
        near: TravelPoint<P>,
        far: BracketEnd<P>,
    ) -> Result<TravelPoint<P>, SearchError> {
        let is_close = |place: &TravelPoint<P>| {
            self.remaining_displacement(place).abs() <= MET_TO_ROUNDING * self.scale.size
        };
        let best = match far {
            BracketEnd::Beyond(place)
                if self.remaining_displacement(&place).abs() < self.remaining_displacement(&near).abs() =>
            {
                place
            }
            BracketEnd::Reversed(place) | BracketEnd::DriverLimit(place)
                if !is_close(&near)
                    && (place.displacement - near.displacement) * self.remaining_displacement(&near)
                        > 0.0 =>
            {
                place
            }
            _ => near,
        };
        if is_close(&best) {
            return Ok(best);
        }
        Err(SearchError::Unreachable { nearest: best.displacement })
    }
}

/// Classification of a driver position.
enum PositionClass<P> {
    Reached(TravelPoint<P>),
    /// Short of the displacement, and closer.
    Nearer(TravelPoint<P>),
    Bracketed(BracketEnd<P>),
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    const SCALE: Scale = Scale { size: 1.0, unit: 1.0 };

    /// A point that moves along a given function, between two limits of its driver.
    struct Motion {
        of: fn(f64) -> (f64, f64),
        ends: [f64; 2],
        says_ends: bool,
    }

    impl Motion {
        fn place(&self, driver: f64) -> TravelPoint<()> {
            let (gone, rate) = (self.of)(driver);
            TravelPoint { pose: (), driver, displacement: gone, rate: rate.is_finite().then_some(rate) }
        }

        /// The result, and the number of places visited.
        fn move_drivers(&self, start: f64, requested: f64) -> (Result<TravelPoint<()>, SearchError>, usize) {
            let mut visits = 0;
            let mut visit = |_: &(), driver: f64| {
                visits += 1;
                let [low, high] = self.ends;
                if (low..=high).contains(&driver) {
                    return Ok(self.place(driver));
                }
                let end = if driver > high { high } else { low };
                Err(VisitError::NoPose {
                    error: AssemblyError::ForeignPose,
                    end: self.says_ends.then_some(end),
                })
            };
            let found = Search { scale: SCALE, requested, visit: &mut visit }.run(self.place(start));
            (found, visits)
        }
    }

    const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
    const CRANK: Motion = Motion { of: |t| (t.sin(), t.cos()), ends: FREE, says_ends: true };

    #[test]
    fn displacements_between_the_turns_are_met() {
        for k in -99..=99 {
            let requested = f64::from(k) / 100.0;
            let (found, visits) = CRANK.move_drivers(0.3, requested);
            let place = found.expect("in reach");
            assert!(
                (place.displacement - requested).abs() <= DISPLACEMENT_ACCURACY
                    && (place.driver - requested.asin()).abs() < 1e-10,
                "{requested}"
            );
            assert!(visits <= 20, "{requested}: {visits}");
        }
        // Close to the solution, two visits are enough.
        let (found, visits) = CRANK.move_drivers(0.3, 0.3f64.sin() + 1e-4);
        assert!(found.is_ok() && visits <= 2, "{visits}");
    }

    /// The reversal is approached from the side of the start, with a rate that leads back to the start.
    #[test]
    fn the_turn_is_met_before_it() {
        for start in [0.3, 1.5, FRAC_PI_2 - 1e-5] {
            let (found, visits) = CRANK.move_drivers(start, 1.0);
            let place = found.expect("in reach");
            assert!(place.driver < FRAC_PI_2 && place.rate.expect("a rate") > STATIONARY, "{place:?}");
            assert!(visits <= 60, "{visits}");
            let (back, _) = CRANK.move_drivers(place.driver, 0.9);
            assert!((back.expect("in reach").driver - 0.9f64.asin()).abs() < 1e-11);
        }
    }

    #[test]
    fn beyond_the_turns_the_nearest_is_told() {
        for (start, requested, nearest) in [(0.3, 1.2, 1.0), (0.3, -1e12, -1.0), (2.0, 1.0 + 1e-6, 1.0)] {
            let (found, visits) = CRANK.move_drivers(start, requested);
            let Err(SearchError::Unreachable { nearest: got }) = found else { panic!("{found:?}") };
            assert!((got - nearest).abs() < 1e-11 && visits <= 40, "{requested}: {got} {visits}");
        }
        // From the reversal itself to one side.
        let (found, _) = CRANK.move_drivers(FRAC_PI_2, 0.5);
        assert!((found.expect("in reach").driver - PI * 5.0 / 6.0).abs() < 1e-11);
        let Err(SearchError::Unreachable { nearest }) = CRANK.move_drivers(FRAC_PI_2, 1.5).0 else {
            panic!()
        };
        assert!((nearest - 1.0).abs() < 1e-11);
    }

    /// At the limit of its range, the driver has a singular rate: the displacement is a square root of the remaining
    /// distance.
    #[test]
    fn ends_of_the_driver_are_displacements_too() {
        let of = |t: f64| (-(1.0 - t).max(0.0).sqrt(), 0.5 / (1.0 - t).max(0.0).sqrt());
        for says_ends in [true, false] {
            let motion = Motion { of, ends: [-9.0, 1.0], says_ends };
            for (requested, within) in [(-0.5, 1e-12), (-1e-3, 1e-12), (-1e-7, 1e-9), (0.0, 1e-9)] {
                let place = motion.move_drivers(0.0, requested).0.expect("in reach");
                assert!(
                    (place.displacement - requested).abs() <= within,
                    "{requested}: {}",
                    place.displacement
                );
            }
            let Err(SearchError::Unreachable { nearest }) = motion.move_drivers(0.0, 0.1).0 else { panic!() };
            assert!(nearest.abs() < 2e-8, "{nearest}");
        }
    }

    /// The point may reverse before the limit of the driver, although the displacement at the limit exceeds that at
    /// the start.
    #[test]
    fn a_turn_before_the_end_is_found() {
        // 1 − x², x = ½ − √(1 − t): the point reverses at t = ¾.
        let of = |t: f64| {
            let root = (1.0 - t).max(0.0).sqrt();
            (1.0 - (0.5 - root).powi(2), -(0.5 - root) / root)
        };
        for says_ends in [true, false] {
            let motion = Motion { of, ends: [-9.0, 1.0], says_ends };
            for requested in [0.5, 0.74, 0.9, 0.999, 1.0] {
                let place = motion.move_drivers(0.0, requested).0.expect("in reach");
                assert!(
                    (place.displacement - requested).abs() <= DISPLACEMENT_ACCURACY && place.driver < 0.75,
                    "{requested}: {place:?}"
                );
            }
            let Err(SearchError::Unreachable { nearest }) = motion.move_drivers(0.0, 1.1).0 else { panic!() };
            assert!((nearest - 1.0).abs() < 1e-11, "{nearest}");
        }
    }

    #[test]
    fn a_long_travel_has_a_budget() {
        let line = Motion { of: |t| (t, 1.0), ends: FREE, says_ends: true };
        let (found, visits) = line.move_drivers(0.0, 1e12);
        assert!(
            matches!(found, Err(SearchError::TooFar { reached }) if (reached - 12.0).abs() < 1e-9),
            "{found:?}"
        );
        assert_eq!(visits, TRAVEL_STEPS);
        let rests = Motion { of: |_| (0.0, 0.0), ends: FREE, says_ends: true };
        assert_eq!(rests.move_drivers(0.0, 1.0).0.err(), Some(SearchError::Unreachable { nearest: 0.0 }));
    }
}
