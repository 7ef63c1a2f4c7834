//! Impact computed by integration of the equation of motion, independent of the closed forms.

use differential_equations::prelude::*;

/// Key figures from the integration.
#[derive(Clone, Copy, Debug, Default)]
pub struct Measured {
    pub restitution: f64,
    pub duration: f64,
    pub max_penetration: f64,
    pub time_of_max_penetration: f64,
    pub peak_force: f64,
    pub time_of_peak_force: f64,
    /// Area enclosed by the loop of force over penetration, J.
    pub work: f64,
}

/// Mass that hits a contact with a given force law.
pub struct IntegratedImpact<'a> {
    pub mass: f64,
    pub speed: f64,
    /// Unit of length of the integration, of the order of the penetration, m.
    pub length: f64,
    /// Compressive force in N as a function of the penetration in m and its rate in m/s.
    pub force: &'a dyn Fn(f64, f64) -> f64,
    /// True if the contact ends when the force vanishes, false if it ends when the gap closes.
    pub ends_with_the_force: bool,
}

/// Penetration, rate and work, in units of length, speed and m̄ v².
type State = [f64; 3];

impl IntegratedImpact<'_> {
    fn force(&self, state: &State) -> f64 {
        (self.force)(state[0].max(0.0) * self.length, state[1] * self.speed)
    }

    fn dimensionless_force(&self, state: &State) -> f64 {
        self.force(state) * self.length / (self.mass * self.speed * self.speed)
    }

    /// Event function of the end of the contact: positive during the contact, negative afterwards.
    fn contact_function(&self, state: &State) -> f64 {
        if self.ends_with_the_force && state[1] < 0.0 {
            self.dimensionless_force(state).min(state[0])
        } else {
            state[0]
        }
    }

    fn rates(&self, state: &State, out: &mut State) {
        let push = self.dimensionless_force(state);
        *out = [state[1], -push, push * state[1]];
    }

    /// State after a time shorter than a step, by integration, which is more accurate than the interpolation within
    /// a step.
    fn advance(&self, state: &State, time: f64) -> State {
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
        let (mut measured, mut ended) = (Measured::default(), false);
        let recorder = EventRecorder { impact: self, measured: &mut measured, ended: &mut ended };
        let solver = ExplicitRungeKutta::dop853().rtol(1e-12).atol(1e-15).h_max(0.02).max_steps(1_000_000);
        let rates = |_: f64, state: &State, out: &mut State| self.rates(state, out);
        let start = [0.0, 1.0, 0.0];
        IVP::ode_from_fn(rates, 0.0, 1e6, start)
            .solout(recorder)
            .method(solver)
            .solve()
            .expect("it integrates");
        assert!(ended, "the contact did not end");
        assert!(measured.restitution > 0.0 && measured.work > 0.0);
        measured
    }
}

struct EventRecorder<'a> {
    impact: &'a IntegratedImpact<'a>,
    measured: &'a mut Measured,
    ended: &'a mut bool,
}

impl Solout<f64, State> for EventRecorder<'_> {
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
            self.measured.peak_force = impact.force(state);
            return ControlFlag::Continue;
        }
        let at = |t: f64| impact.advance(last, t - before);
        let ends = impact.contact_function(state) <= 0.0;
        let end = if ends { bisect(before, now, |t| impact.contact_function(&at(t))) } else { now };
        if last[1] > 0.0 && state[1] <= 0.0 {
            let t = bisect(before, now, |t| at(t)[1]);
            self.measured.time_of_max_penetration = t * time;
            self.measured.max_penetration = at(t)[0] * impact.length;
        }
        let mut near = |t: f64| interpolator.interpolate(t).expect("within the step");
        let t = argmax(before, end, |t| impact.force(&near(t)));
        let force = impact.force(&at(t));
        if force > self.measured.peak_force {
            self.measured.peak_force = force;
            self.measured.time_of_peak_force = t * time;
        }
        if !ends {
            return ControlFlag::Continue;
        }
        let last = at(end);
        *self.ended = true;
        self.measured.duration = end * time;
        self.measured.restitution = -last[1];
        self.measured.work = last[2] * impact.mass * impact.speed * impact.speed;
        ControlFlag::Terminate
    }
}

/// Zero of a decreasing function, by bisection.
fn bisect(mut low: f64, mut high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Position of the maximum of f, by golden-section search.
fn argmax(mut low: f64, mut high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..40 {
        let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
        if f(left) < f(right) { low = left } else { high = right }
    }
    0.5 * (low + high)
}
