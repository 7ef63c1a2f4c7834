//! Contact damping from the coefficient of restitution, and back.
//!
//! A mass m̄ in kilograms meets a surface at some speed and leaves it with e times that speed. The surface is a spring
//! and a damper; which damper gives e is a matter of the law of the damper, and several are in use. This crate does
//! not depend on where the mass comes from.
//!
//! | question                                   | answer                                                  |
//! |--------------------------------------------|---------------------------------------------------------|
//! | which damper gives this restitution        | [`Law::damper`]                                         |
//! | which restitution this damper gives        | [`Damper::restitution`]                                 |
//! | how long, how deep, how hard, what is lost | [`Damper::impact`], [`Damper::history`]                   |
//! | how far a formula of the literature is wrong | [`Law::approximation_error`]                            |
//! | what to type into a simulator              | [`exports`]                                             |
//! | how fast a robot may hit a person       | [`TransientContact`]                                    |
//!
//! Two laws are solved exactly, [`kelvin_voigt`] and [`hunt_crossley`]; the others are formulas of the literature for
//! the damping of the second, which are approximations with known errors. Units are SI throughout. Nothing panics on input, and no NaN or infinity
//! comes out: what a 64-bit float cannot hold is an error.
//!
//! ```
//! use percuss_contact::{CompliantContact, Damper, Law, Separation};
//!
//! let contact = CompliantContact::new(2.281, 1e5)?;
//! let damper = Law::KelvinVoigt.damper(contact, 0.5, None, Separation::ForceVanishes)?;
//! let impact = damper.impact(contact, 0.4)?;
//! assert!((impact.rebound_speed - 0.2).abs() < 1e-15);
//! // The half period of the textbooks gives too much rebound where nothing pulls.
//! let textbook = Law::KelvinVoigt.damper(contact, 0.5, None, Separation::GapCloses)?;
//! let Damper::KelvinVoigt { ratio, .. } = textbook else { unreachable!() };
//! let damper = Damper::kelvin_voigt(contact, ratio, Separation::ForceVanishes)?;
//! assert!((damper.restitution(contact, 0.4)? - 0.5503).abs() < 1e-4);
//! # Ok::<(), percuss_contact::ContactLawError>(())
//! ```

mod body_region;
mod contact;
mod damper;
mod error;
pub mod exports;
mod impact;
mod laws;
mod limits;
mod quadrature;
mod separation;
mod solutions;
mod trajectory;
mod transient_contact;

pub use body_region::BodyRegion;
pub use contact::CompliantContact;
pub use damper::Damper;
pub use error::ContactLawError;
pub use impact::{Impact, Sample};
pub use laws::{Alias, ApproximationError, Law};
pub use separation::Separation;
pub use solutions::{hunt_crossley, kelvin_voigt};
pub use transient_contact::{SafeSpeed, TransientContact, standard_robot_mass};
