//! From a place with a displacement and its rate to the place where the displacement is as requested: Newton's method along
//! one driver, over the range where the displacement goes one way.
//!
//! What limits a travel is enclosed like a solution: the driver's own end, beyond which there is no pose, and the place
//! where the point turns back.

use crate::assembling::AssemblyError;
use crate::tolerances::{
    ENCLOSED_STEPS, FIRST_STEP, LONGEST_STEP, MET, MET_TO_ROUNDING, POLISHED, STATIONARY, TRAVEL_STEPS,
};

/// A place on the way of a driver.
#[derive(Clone, Debug)]
pub(crate) struct Place<P> {
    pub pose: P,
    /// Where the driver stands, rad or m.
    pub driver: f64,
    /// Displacement of the point, m.
    pub gone: f64,
    /// Its rate; none where it is not determined.
    pub rate: Option<f64>,
}

/// Why there is no place at a value of the driver.
#[derive(Clone, Debug)]
pub(crate) enum Stop {
    /// No pose stands there; the driver's end, where it was found.
    NoPose { error: AssemblyError, end: Option<f64> },
    /// The question is wrong.
    Fault(AssemblyError),
}

/// Why a displacement was not reached.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Missed {
    /// The driver came to its end, or the point turned back: the displacement nearest to the requested one, m.
    Unreachable { nearest: f64 },
    /// There were no more steps: how far the point came, m.
    TooFar { reached: f64 },
    /// No step could be made, or a pose is wrong.
    Assembly(AssemblyError),
}

/// What displacements and steps are measured on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    /// Of the mechanism, m.
    pub size: f64,
    /// Of the driver: a radian, or the size.
    pub unit: f64,
}

/// What lies on the other side of what is looked for.
enum Far<P> {
    /// A place where the point has gone too far.
    Over(Place<P>),
    /// A place where the point has turned back.
    Turned(Place<P>),
    /// The driver's end, which is short of the displacement: the point may have turned back before.
    End(Place<P>),
    /// A value of the driver without a pose, or its end, at which there may be one.
    Barred { driver: f64, is_end: bool },
}

impl<P> Far<P> {
    fn driver(&self) -> f64 {
        match self {
            Far::Over(place) | Far::Turned(place) | Far::End(place) => place.driver,
            Far::Barred { driver, .. } => *driver,
        }
    }
}

/// The place at a value of the driver, or why there is none.
type Visited<P> = Result<Place<P>, Stop>;

/// A search for one displacement.
pub(crate) struct Search<'a, P> {
    pub scale: Scale,
    /// m.
    pub requested: f64,
    /// The place at a value of the driver, followed from another pose.
    pub visit: &'a mut (dyn FnMut(&P, f64) -> Visited<P> + 'a),
}

impl<P> Search<'_, P> {
    fn miss(&self, place: &Place<P>) -> f64 {
        self.requested - place.gone
    }

    fn is_met(&self, place: &Place<P>) -> bool {
        self.miss(place).abs() <= MET * self.scale.size
    }

    /// The rate, where it has a sign.
    fn rate(&self, place: &Place<P>) -> Option<f64> {
        let Scale { size, unit } = self.scale;
        place.rate.filter(|rate| rate.is_finite() && (rate * unit).abs() > STATIONARY * size)
    }

    /// Goes to the displacement that is requested, from a place that was visited.
    pub fn go(mut self, start: Place<P>) -> Result<Place<P>, Missed> {
        if self.is_met(&start) {
            return Ok(start);
        }
        let start = if self.rate(&start).is_some() { start } else { self.leave(&start)? };
        if self.is_met(&start) {
            return Ok(start);
        }
        let Some(rate) = self.rate(&start) else {
            return Err(Missed::Unreachable { nearest: start.gone });
        };
        // Of the driver, towards the displacement that is requested.
        let ahead = self.miss(&start).signum() * rate.signum();
        let found = self.march(start, ahead)?;
        Ok(self.polished(found))
    }

    /// One more step, where what is left of the last one shows in the digits.
    fn polished(&mut self, found: Place<P>) -> Place<P> {
        let miss = self.miss(&found);
        let Some(rate) = self.rate(&found).filter(|_| miss.abs() > POLISHED * self.scale.size) else {
            return found;
        };
        match (self.visit)(&found.pose, found.driver + miss / rate) {
            Ok(place)
                if self.miss(&place).abs() < miss.abs()
                    && self.rate(&place).is_some_and(|other| other * rate > 0.0) =>
            {
                place
            }
            _ => found,
        }
    }

    /// A step off a place where the rate says nothing.
    fn leave(&mut self, start: &Place<P>) -> Result<Place<P>, Missed> {
        let step = FIRST_STEP * self.scale.unit;
        let mut first = None;
        for step in [step, -step] {
            match (self.visit)(&start.pose, start.driver + step) {
                Ok(place) => return Ok(place),
                Err(Stop::Fault(error)) => return Err(Missed::Assembly(error)),
                Err(Stop::NoPose { error, .. }) => {
                    first.get_or_insert(error);
                }
            }
        }
        Err(first.map_or(Missed::Unreachable { nearest: start.gone }, Missed::Assembly))
    }

    /// Steps of the tangent, none of which is long, until the displacement is met or something is enclosed.
    fn march(&mut self, mut near: Place<P>, ahead: f64) -> Result<Place<P>, Missed> {
        let longest = LONGEST_STEP * self.scale.unit;
        for _ in 0..TRAVEL_STEPS {
            let step = match self.rate(&near) {
                Some(rate) => (self.miss(&near) / rate).abs().min(longest),
                None => FIRST_STEP * self.scale.unit,
            };
            match self.next(&near, near.driver + ahead * step, ahead)? {
                Next::Met(place) => return Ok(place),
                Next::Nearer(place) => near = place,
                Next::Enclosed(far) => return self.enclosed(near, far, ahead),
            }
        }
        Err(Missed::TooFar { reached: near.gone })
    }

    /// What a value of the driver is, seen from a place that is short of the displacement.
    fn next(&mut self, near: &Place<P>, driver: f64, ahead: f64) -> Result<Next<P>, Missed> {
        let place = match (self.visit)(&near.pose, driver) {
            Ok(place) => place,
            Err(Stop::Fault(error)) => return Err(Missed::Assembly(error)),
            Err(Stop::NoPose { end, .. }) => {
                let between = |end: &f64| ahead * (end - near.driver) > 0.0 && ahead * (driver - end) > 0.0;
                return Ok(Next::Enclosed(match end.filter(between) {
                    Some(end) => Far::Barred { driver: end, is_end: true },
                    None => Far::Barred { driver, is_end: false },
                }));
            }
        };
        let (miss, left) = (self.miss(near), self.miss(&place));
        let over = left * miss < 0.0;
        let turned = match (self.rate(&place), place.rate) {
            (Some(rate), _) => rate * ahead * miss < 0.0,
            // At the turn itself: a place before it has a rate, which leads back.
            (None, Some(_)) => true,
            (None, None) => (place.gone - near.gone) * miss < 0.0,
        };
        // The other side of a turn is another pose, though as near.
        Ok(match (turned, self.is_met(&place)) {
            (false, true) => Next::Met(place),
            _ if over => Next::Enclosed(Far::Over(place)),
            (true, _) => Next::Enclosed(Far::Turned(place)),
            (false, false) => Next::Nearer(place),
        })
    }

    /// Between a place that is short of the displacement and what lies on the other side.
    fn enclosed(&mut self, mut near: Place<P>, mut far: Far<P>, ahead: f64) -> Result<Place<P>, Missed> {
        let mut last = f64::INFINITY;
        for _ in 0..ENCLOSED_STEPS {
            let gap = (far.driver() - near.driver).abs();
            let rounding = 2.0 * f64::EPSILON * near.driver.abs().max(f64::EPSILON * self.scale.unit);
            if gap <= rounding || self.is_turn(&near, &far, gap) {
                break;
            }
            if let Far::Barred { driver, is_end: true } = far {
                match self.end(&near, driver)? {
                    Ok(place) => return Ok(place),
                    Err(end) => far = end,
                }
                continue;
            }
            let (from, step) = self.step(&near, &far, gap, last, ahead);
            last = step.abs();
            match self.next(&near, from + ahead * step, ahead)? {
                Next::Met(place) => return Ok(place),
                Next::Nearer(place) => near = place,
                Next::Enclosed(enclosed) => far = enclosed,
            }
        }
        self.ended(near, far)
    }

    /// What the end of the driver is, where it was found to the last digit. Its rate there has either sign.
    fn end(&mut self, near: &Place<P>, driver: f64) -> Result<Result<Place<P>, Far<P>>, Missed> {
        match (self.visit)(&near.pose, driver) {
            Ok(place) if self.is_met(&place) => Ok(Ok(place)),
            Ok(mut place) => {
                place.rate = None;
                let over = self.miss(&place) * self.miss(near) < 0.0;
                Ok(Err(if over { Far::Over(place) } else { Far::End(place) }))
            }
            Err(Stop::NoPose { .. }) => Ok(Err(Far::Barred { driver, is_end: false })),
            Err(Stop::Fault(error)) => Err(Missed::Assembly(error)),
        }
    }

    /// From where to go how far, inside of the gap: by the tangent at one end, to where the rate would vanish, or to the
    /// middle where these do not help.
    fn step(&self, near: &Place<P>, far: &Far<P>, gap: f64, last: f64, ahead: f64) -> (f64, f64) {
        let tangent = |place: &Place<P>| {
            let step = ahead * self.miss(place) / self.rate(place)?;
            // As fast as halving at least.
            (step.abs() < gap && step.abs() <= 0.5 * last).then_some((place.driver, step))
        };
        let forwards = || tangent(near).filter(|(_, step)| *step > 0.0);
        let guess = match far {
            Far::Over(place) if self.miss(place).abs() < self.miss(near).abs() => {
                tangent(place).filter(|(_, step)| *step < 0.0).or_else(forwards)
            }
            Far::Over(_) | Far::End(_) | Far::Barred { .. } => forwards(),
            Far::Turned(place) => forwards().or_else(|| {
                let (here, there) = (self.rate(near)?, self.rate(place)?);
                let step = gap * here / (here - there);
                (step > 0.0 && step < gap && step <= 0.5 * last).then_some((near.driver, step))
            }),
        };
        guess.unwrap_or((near.driver, 0.5 * gap))
    }

    /// Whether the point turns back between two places, so near to one of them that no displacement is met between that
    /// is not met there: to first order, the rate there falls to zero over its part of the gap.
    fn is_turn(&self, near: &Place<P>, far: &Far<P>, gap: f64) -> bool {
        let Far::Turned(place) = far else { return false };
        let (Some(here), Some(there)) = (near.rate, place.rate) else { return false };
        let (here, there) = (here.abs(), there.abs());
        let gain = |rate: f64| rate * gap * rate / (here + there);
        let met = MET * self.scale.size;
        // Where the place beyond the turn is near enough, so is one before it.
        gain(here) <= met || gain(there) <= met && self.miss(place).abs() > MET_TO_ROUNDING * self.scale.size
    }

    /// What is left between two values of the driver that are the same to rounding.
    fn ended(&self, near: Place<P>, far: Far<P>) -> Result<Place<P>, Missed> {
        let is_close = |place: &Place<P>| self.miss(place).abs() <= MET_TO_ROUNDING * self.scale.size;
        let best = match far {
            Far::Over(place) if self.miss(&place).abs() < self.miss(&near).abs() => place,
            Far::Turned(place) | Far::End(place)
                if !is_close(&near) && (place.gone - near.gone) * self.miss(&near) > 0.0 =>
            {
                place
            }
            _ => near,
        };
        if is_close(&best) {
            return Ok(best);
        }
        Err(Missed::Unreachable { nearest: best.gone })
    }
}

/// What was found at a value of the driver.
enum Next<P> {
    Met(Place<P>),
    /// Short of the displacement, and nearer to it.
    Nearer(Place<P>),
    Enclosed(Far<P>),
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    const SCALE: Scale = Scale { size: 1.0, unit: 1.0 };

    /// A point that goes as a function says, between two ends of its driver.
    struct Motion {
        of: fn(f64) -> (f64, f64),
        ends: [f64; 2],
        says_ends: bool,
    }

    impl Motion {
        fn place(&self, driver: f64) -> Place<()> {
            let (gone, rate) = (self.of)(driver);
            Place { pose: (), driver, gone, rate: rate.is_finite().then_some(rate) }
        }

        /// The answer, and how many places were visited.
        fn go(&self, start: f64, requested: f64) -> (Result<Place<()>, Missed>, usize) {
            let mut visits = 0;
            let mut visit = |_: &(), driver: f64| {
                visits += 1;
                let [low, high] = self.ends;
                if (low..=high).contains(&driver) {
                    return Ok(self.place(driver));
                }
                let end = if driver > high { high } else { low };
                Err(Stop::NoPose { error: AssemblyError::ForeignPose, end: self.says_ends.then_some(end) })
            };
            let found = Search { scale: SCALE, requested, visit: &mut visit }.go(self.place(start));
            (found, visits)
        }
    }

    const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
    const CRANK: Motion = Motion { of: |t| (t.sin(), t.cos()), ends: FREE, says_ends: true };

    #[test]
    fn displacements_between_the_turns_are_met() {
        for k in -99..=99 {
            let requested = f64::from(k) / 100.0;
            let (found, visits) = CRANK.go(0.3, requested);
            let place = found.expect("in reach");
            assert!(
                (place.gone - requested).abs() <= MET && (place.driver - requested.asin()).abs() < 1e-10,
                "{requested}"
            );
            assert!(visits <= 20, "{requested}: {visits}");
        }
        // Beside the last row two places are enough.
        let (found, visits) = CRANK.go(0.3, 0.3f64.sin() + 1e-4);
        assert!(found.is_ok() && visits <= 2, "{visits}");
    }

    /// The turn itself is met from the side where the search began, with a rate that leads back there.
    #[test]
    fn the_turn_is_met_before_it() {
        for start in [0.3, 1.5, FRAC_PI_2 - 1e-5] {
            let (found, visits) = CRANK.go(start, 1.0);
            let place = found.expect("in reach");
            assert!(place.driver < FRAC_PI_2 && place.rate.expect("a rate") > STATIONARY, "{place:?}");
            assert!(visits <= 60, "{visits}");
            let (back, _) = CRANK.go(place.driver, 0.9);
            assert!((back.expect("in reach").driver - 0.9f64.asin()).abs() < 1e-11);
        }
    }

    #[test]
    fn beyond_the_turns_the_nearest_is_told() {
        for (start, requested, nearest) in [(0.3, 1.2, 1.0), (0.3, -1e12, -1.0), (2.0, 1.0 + 1e-6, 1.0)] {
            let (found, visits) = CRANK.go(start, requested);
            let Err(Missed::Unreachable { nearest: got }) = found else { panic!("{found:?}") };
            assert!((got - nearest).abs() < 1e-11 && visits <= 40, "{requested}: {got} {visits}");
        }
        // From the turn itself, to one side.
        let (found, _) = CRANK.go(FRAC_PI_2, 0.5);
        assert!((found.expect("in reach").driver - PI * 5.0 / 6.0).abs() < 1e-11);
        let Err(Missed::Unreachable { nearest }) = CRANK.go(FRAC_PI_2, 1.5).0 else { panic!() };
        assert!((nearest - 1.0).abs() < 1e-11);
    }

    /// At the end of its range a driver has no say: the point goes as the root of what is left.
    #[test]
    fn ends_of_the_driver_are_displacements_too() {
        let of = |t: f64| (-(1.0 - t).max(0.0).sqrt(), 0.5 / (1.0 - t).max(0.0).sqrt());
        for says_ends in [true, false] {
            let motion = Motion { of, ends: [-9.0, 1.0], says_ends };
            for (requested, within) in [(-0.5, 1e-12), (-1e-3, 1e-12), (-1e-7, 1e-9), (0.0, 1e-9)] {
                let place = motion.go(0.0, requested).0.expect("in reach");
                assert!((place.gone - requested).abs() <= within, "{requested}: {}", place.gone);
            }
            let Err(Missed::Unreachable { nearest }) = motion.go(0.0, 0.1).0 else { panic!() };
            assert!(nearest.abs() < 2e-8, "{nearest}");
        }
    }

    /// The point may turn back before the driver's end, though the end is further than where the search stands.
    #[test]
    fn a_turn_before_the_end_is_found() {
        // 1 − x², x = ½ − √(1 − t): at the turn where t is ¾.
        let of = |t: f64| {
            let root = (1.0 - t).max(0.0).sqrt();
            (1.0 - (0.5 - root).powi(2), -(0.5 - root) / root)
        };
        for says_ends in [true, false] {
            let motion = Motion { of, ends: [-9.0, 1.0], says_ends };
            for requested in [0.5, 0.74, 0.9, 0.999, 1.0] {
                let place = motion.go(0.0, requested).0.expect("in reach");
                assert!(
                    (place.gone - requested).abs() <= MET && place.driver < 0.75,
                    "{requested}: {place:?}"
                );
            }
            let Err(Missed::Unreachable { nearest }) = motion.go(0.0, 1.1).0 else { panic!() };
            assert!((nearest - 1.0).abs() < 1e-11, "{nearest}");
        }
    }

    #[test]
    fn a_long_travel_has_a_budget() {
        let line = Motion { of: |t| (t, 1.0), ends: FREE, says_ends: true };
        let (found, visits) = line.go(0.0, 1e12);
        assert!(
            matches!(found, Err(Missed::TooFar { reached }) if (reached - 12.0).abs() < 1e-9),
            "{found:?}"
        );
        assert_eq!(visits, TRAVEL_STEPS);
        let rests = Motion { of: |_| (0.0, 0.0), ends: FREE, says_ends: true };
        assert_eq!(rests.go(0.0, 1.0).0.err(), Some(Missed::Unreachable { nearest: 0.0 }));
    }
}
