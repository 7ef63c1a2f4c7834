//! A mechanism with its configuration: joints and links by name, both routes compared.

use crate::judge::states_enough;
use percuss_dynamics::{
    Conditions, Configuration, Contact, Direction, EffectiveMass, Frame, Route, RouteChoice,
};
use percuss_dynamics::{ContactResponse, System};
use percuss_mechanism::Mechanism;
use percuss_spatial::Vector3;
use std::sync::Arc;

/// Some thousand roundings; the mechanisms with closed forms are well conditioned, or exact by structure.
pub const TOL: f64 = 1e-12;

/// Relative rounding error of a closed form.
pub const CLOSED_FORM: f64 = 8.0 * f64::EPSILON;

/// A system with its configuration.
pub struct Bench {
    /// The system.
    pub system: System,
    /// Its configuration.
    pub configuration: Configuration,
}

/// Methods panic on invalid arguments and unexpected results.
impl Bench {
    /// Fixed base, all joints free.
    pub fn new(mechanism: impl Into<Arc<Mechanism>>) -> Self {
        Self::under(mechanism, &Conditions::new())
    }

    /// Under conditions.
    pub fn under(mechanism: impl Into<Arc<Mechanism>>, conditions: &Conditions) -> Self {
        let system = System::new(mechanism, conditions).expect("conditions that fit");
        let configuration = system.configuration();
        Self { system, configuration }
    }

    /// Sets the position of a joint.
    pub fn set(mut self, joint: &str, values: &[f64]) -> Self {
        self.configuration.set(joint, values).expect("a position that fits");
        self
    }

    /// Contact of a point (m) of a link with the ground, with the normal in the world's axes.
    pub fn contact(&self, link: &str, point: [f64; 3], normal: Vector3<f64>) -> Contact {
        let link = self.system.mechanism().find_link(link).expect("a link");
        Contact::new(link, point, normal).normal(Direction::Along(normal, Frame::World))
    }

    /// The response by the automatic choice of the route.
    pub fn respond(&self, contact: &Contact) -> ContactResponse {
        self.respond_by_route(contact, RouteChoice::Auto)
    }

    /// The response by a route.
    pub fn respond_by_route(&self, contact: &Contact, choice: RouteChoice) -> ContactResponse {
        let pose = self.system.pose(&self.configuration).expect("a tree poses");
        pose.respond_by_route(contact, choice).expect("an answer")
    }

    /// The outcome, equal for both routes.
    pub fn outcome(&self, contact: &Contact) -> EffectiveMass {
        let by = |route| self.respond_by_route(contact, RouteChoice::Only(route)).effective_mass;
        assert_eq!(by(Route::Dense), by(Route::Articulated));
        by(Route::Dense)
    }

    /// Asserts that both routes give the mass (kg).
    pub fn check_mass(&self, contact: &Contact, expected: f64) {
        self.check_mass_by(contact, expected, &[Route::Dense, Route::Articulated]);
    }

    /// Asserts that these routes and the automatic choice give the mass (kg).
    pub fn check_mass_by(&self, contact: &Contact, expected: f64, routes: &[Route]) {
        for &route in routes {
            let response = self.respond_by_route(contact, RouteChoice::Only(route));
            let m = mass(&response);
            assert!((m / expected - 1.0).abs() <= TOL, "{route:?}: {m} kg, expected {expected} kg");
            let enough = states_enough(&response, expected, CLOSED_FORM);
            let error = response.error;
            assert!(
                enough,
                "{route:?}: {m} kg, expected {expected} kg, off by {:e} kg, {error:?}",
                m - expected
            );
        }
        assert_close(mass(&self.respond(contact)), expected);
    }
}

/// m̄ of a response (kg), which must be finite.
pub fn mass(response: &ContactResponse) -> f64 {
    match response.effective_mass {
        EffectiveMass::Finite(m) => m,
        other => panic!("{other:?}"),
    }
}

/// Asserts equality within [`TOL`].
#[track_caller]
pub fn assert_close(got: f64, expected: f64) {
    assert!((got / expected - 1.0).abs() <= TOL, "{got}, expected {expected}");
}

/// Unit vector at an angle (rad) in the xy plane.
pub fn along(angle: f64) -> Vector3<f64> {
    Vector3::new(angle.cos(), angle.sin(), 0.0)
}
