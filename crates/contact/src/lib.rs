//! Contact damping from the coefficient of restitution, and back.
//!
//! A mass m̄ (kg) hits a surface at an approach speed v and leaves it with the speed e v. The surface is a
//! spring with a damper. The damper for a restitution e depends on the damper law, and several laws are in use. The
//! mass is an input: this crate does not compute effective masses.
//!
//! | question                                   | answer                                                  |
//! |--------------------------------------------|---------------------------------------------------------|
//! | damper for a required restitution          | [`Law::damper`]                                         |
//! | restitution of a damper                    | [`Damper::restitution`]                                 |
//! | duration, penetration, force, lost energy  | [`Damper::impact`], [`Damper::history`]                 |
//! | error of a formula of the literature       | [`Law::approximation_error`]                            |
//! | parameters for simulators                  | [`exports`]                                             |
//! | safe speed of a robot near a person        | [`TransientContact`]                                    |
//!
//! Two laws are solved exactly, [`kelvin_voigt`] and [`hunt_crossley`]. The other laws are published approximations
//! of the Hunt–Crossley damping, with known errors. All units are SI. No input causes a panic, a NaN or an infinity:
//! overflow is an error.
//!
//! ```
//! use percuss_contact::{CompliantContact, Damper, Law, Separation};
//!
//! let contact = CompliantContact::new(2.281, 1e5)?;
//! let damper = Law::KelvinVoigt.damper(contact, 0.5, None, Separation::ForceVanishes)?;
//! let impact = damper.impact(contact, 0.4)?;
//! assert!((impact.rebound_speed - 0.2).abs() < 1e-15);
//! // The half-period formula of textbooks gives too much rebound if the contact cannot pull.
//! let textbook = Law::KelvinVoigt.damper(contact, 0.5, None, Separation::GapCloses)?;
//! let Damper::KelvinVoigt { ratio, .. } = textbook else { unreachable!() };
//! let damper = Damper::kelvin_voigt(contact, ratio, Separation::ForceVanishes)?;
//! assert!((damper.restitution(contact, 0.4)? - 0.5503).abs() < 1e-4);
//! # Ok::<(), percuss_contact::ContactLawError>(())
//! ```

mod contact;
mod damper;
mod error;
pub mod exports;
mod impact;
mod laws;
mod limits;
mod separation;
mod solutions;
mod trajectory;
mod transient_contact;
mod varying_mass;

pub use contact::CompliantContact;
pub use damper::Damper;
pub use error::ContactLawError;
pub use impact::{Impact, Sample};
pub use laws::{Alias, ApproximationError, Law};
pub use separation::Separation;
pub use solutions::{hunt_crossley, kelvin_voigt};
pub use transient_contact::{BodyRegion, SafeSpeed, TransientContact, standard_robot_mass};
pub use varying_mass::{
    VaryingMassImpact, history_with_varying_mass, impact_with_varying_mass,
    restitution_with_prescribed_acceleration,
};
