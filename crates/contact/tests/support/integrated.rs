//! An impact by integration of its equation of motion, which knows no closed form.

use differential_equations::prelude::*;

/// What the integration saw.
#[derive(Clone, Copy, Debug, Default)]
pub struct Measured {
    pub restitution: f64,
    pub duration: f64,
    pub max_penetration: f64,
    pub time_of_max_penetration: f64,
    pub peak_force: f64,
    pub time_of_peak_force: f64,
    /// The area within the loop of the force over the penetration.
    pub work: f64,
}

/// A mass that meets a force.
pub struct IntegratedImpact<'a> {
    pub mass: f64,
    pub speed: f64,
    /// A length of the right size; the integration is in units of it.
    pub length: f64,
    /// The push in N at a penetration in m and its rate in m/s.
    pub force: &'a dyn Fn(f64, f64) -> f64,
    /// Whether the contact ends where the force vanishes, and not where the gap closes.
    pub ends_with_the_force: bool,
}

/// Penetration, rate and work, in units of length, speed and m̄ v².
type State = [f64; 3];

impl IntegratedImpact<'_> {
    fn force(&self, state: &State) -> f64 {
        (self.force)(state[0].max(0.0) * self.length, state[1] * self.speed)
    }

    fn per_mass(&self, state: &State) -> f64 {
        self.force(state) * self.length / (self.mass * self.speed * self.speed)
    }

    /// Above zero during the contact, below it after.
    fn end(&self, state: &State) -> f64 {
        if self.ends_with_the_force && state[1] < 0.0 { self.per_mass(state).min(state[0]) } else { state[0] }
    }

    fn rates(&self, state: &State, out: &mut State) {
        let push = self.per_mass(state);
        *out = [state[1], -push, push * state[1]];
    }

    /// The state after some time less than a step: by integration, to more digits than the interpolation within a
    /// step has.
    fn after(&self, state: &State, time: f64) -> State {
        if time <= 0.0 {
            return *state;
        }
        let solver = ExplicitRungeKutta::dop853().rtol(1e-13).atol(1e-16).h0(time);
        let rates = |_: f64, state: &State, out: &mut State| self.rates(state, out);
        let solution =
            IVP::ode_from_fn(rates, 0.0, time, *state).method(solver).solve().expect("it integrates");
        *solution.y.last().expect("a last state")
    }

    /// Integrates to the end of the contact: order 8, relative tolerance 1e-12.
    pub fn measure(&self) -> Measured {
        let (mut seen, mut ended) = (Measured::default(), false);
        let watcher = Watcher { impact: self, seen: &mut seen, ended: &mut ended };
        let solver = ExplicitRungeKutta::dop853().rtol(1e-12).atol(1e-15).h_max(0.02).max_steps(1_000_000);
        let rates = |_: f64, state: &State, out: &mut State| self.rates(state, out);
        let start = [0.0, 1.0, 0.0];
        IVP::ode_from_fn(rates, 0.0, 1e6, start)
            .solout(watcher)
            .method(solver)
            .solve()
            .expect("it integrates");
        assert!(ended, "the contact did not end");
        assert!(seen.restitution > 0.0 && seen.work > 0.0);
        seen
    }
}

struct Watcher<'a> {
    impact: &'a IntegratedImpact<'a>,
    seen: &'a mut Measured,
    ended: &'a mut bool,
}

impl Solout<f64, State> for Watcher<'_> {
    fn solout<I>(
        &mut self,
        now: f64,
        before: f64,
        state: &State,
        last: &State,
        interpolator: &mut I,
        _: &mut Solution<f64, State>,
    ) -> ControlFlag<f64, State>
    where
        I: Interpolation<f64, State> + ?Sized,
    {
        let impact = self.impact;
        let time = impact.length / impact.speed;
        if now == before {
            self.seen.peak_force = impact.force(state);
            return ControlFlag::Continue;
        }
        let at = |t: f64| impact.after(last, t - before);
        let ends = impact.end(state) <= 0.0;
        let end = if ends { root(before, now, |t| impact.end(&at(t))) } else { now };
        if last[1] > 0.0 && state[1] <= 0.0 {
            let t = root(before, now, |t| at(t)[1]);
            self.seen.time_of_max_penetration = t * time;
            self.seen.max_penetration = at(t)[0] * impact.length;
        }
        let mut near = |t: f64| interpolator.interpolate(t).expect("within the step");
        let t = greatest(before, end, |t| impact.force(&near(t)));
        let force = impact.force(&at(t));
        if force > self.seen.peak_force {
            self.seen.peak_force = force;
            self.seen.time_of_peak_force = t * time;
        }
        if !ends {
            return ControlFlag::Continue;
        }
        let last = at(end);
        *self.ended = true;
        self.seen.duration = end * time;
        self.seen.restitution = -last[1];
        self.seen.work = last[2] * impact.mass * impact.speed * impact.speed;
        ControlFlag::Terminate
    }
}

/// Where f falls through zero, by bisection.
fn root(mut low: f64, mut high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Where f is greatest, by the golden section.
fn greatest(mut low: f64, mut high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..40 {
        let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
        if f(left) < f(right) { low = left } else { high = right }
    }
    0.5 * (low + high)
}
