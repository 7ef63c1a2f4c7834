//! A mechanism on the bench: posed by joint names, struck by link names, weighed by both routes.

use percuss_dynamics::{
    Conditions, Configuration, Contact, Direction, EffectiveMass, Frame, Route, RouteChoice,
};
use percuss_dynamics::{Strike, System};
use percuss_mechanism::Mechanism;
use percuss_spatial::Vector3;
use std::sync::Arc;

/// A few thousand roundings; the mechanisms of closed forms are well conditioned, or exact by structure.
pub const TOL: f64 = 1e-12;

/// A system with its configuration.
pub struct Bench {
    /// The system.
    pub system: System,
    /// Where its joints stand.
    pub configuration: Configuration,
}

/// Everything panics that does not fit or is not as expected.
impl Bench {
    /// With a fixed base, everything free.
    pub fn new(mechanism: impl Into<Arc<Mechanism>>) -> Self {
        Self::under(mechanism, &Conditions::new())
    }

    /// Under conditions.
    pub fn under(mechanism: impl Into<Arc<Mechanism>>, conditions: &Conditions) -> Self {
        let system = System::new(mechanism, conditions).expect("conditions that fit");
        let configuration = system.configuration();
        Self { system, configuration }
    }

    /// Puts a joint at a position.
    pub fn set(mut self, joint: &str, values: &[f64]) -> Self {
        self.configuration.set(joint, values).expect("a position that fits");
        self
    }

    /// A point (m) of a link against the ground, the normal in the world's axes.
    pub fn contact(&self, link: &str, point: [f64; 3], normal: Vector3<f64>) -> Contact {
        let link = self.system.mechanism().find_link(link).expect("a link");
        Contact::new(link, point, normal).normal(Direction::Along(normal, Frame::World))
    }

    /// The strike by a route.
    pub fn strike(&self, contact: &Contact, choice: RouteChoice) -> Strike {
        let pose = self.system.pose(&self.configuration).expect("a tree poses");
        self.system.strike(&pose, contact, choice).expect("an answer")
    }

    /// The outcome, which both routes must give.
    pub fn outcome(&self, contact: &Contact) -> EffectiveMass {
        let by = |route| self.strike(contact, RouteChoice::Only(route)).effective_mass;
        assert_eq!(by(Route::Dense), by(Route::Articulated));
        by(Route::Dense)
    }

    /// Both routes give the mass (kg).
    pub fn weighs(&self, contact: &Contact, expected: f64) {
        self.weighs_by(contact, expected, &[Route::Dense, Route::Articulated]);
    }

    /// These routes give the mass (kg), and the automatic choice does.
    pub fn weighs_by(&self, contact: &Contact, expected: f64, routes: &[Route]) {
        for &route in routes {
            let strike = self.strike(contact, RouteChoice::Only(route));
            let m = mass(&strike);
            assert!((m / expected - 1.0).abs() <= TOL, "{route:?}: {m} kg, expected {expected} kg");
        }
        assert_close(mass(&self.strike(contact, RouteChoice::Auto)), expected);
    }
}

/// m̄ of a strike (kg), which must be finite.
pub fn mass(strike: &Strike) -> f64 {
    match strike.effective_mass {
        EffectiveMass::Finite(m) => m,
        other => panic!("{other:?}"),
    }
}

/// Equal to [`TOL`].
#[track_caller]
pub fn assert_close(got: f64, expected: f64) {
    assert!((got / expected - 1.0).abs() <= TOL, "{got}, expected {expected}");
}

/// The direction at an angle (rad) in the plane of x and y.
pub fn along(angle: f64) -> Vector3<f64> {
    Vector3::new(angle.cos(), angle.sin(), 0.0)
}
