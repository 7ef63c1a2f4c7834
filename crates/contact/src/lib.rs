#![doc = include_str!("../README.md")]
//!
//! | question                                   | answer                                                  |
//! |--------------------------------------------|---------------------------------------------------------|
//! | damper for a required restitution          | [`Law::damper`]                                         |
//! | restitution of a damper                    | [`Damper::restitution`]                                 |
//! | duration, penetration, force, lost energy  | [`Damper::impact`], [`Damper::history`]                 |
//! | error of a formula of the literature       | [`Law::approximation_error`]                            |
//! | parameters for simulators                  | [`exports`]                                             |
//! | contact of a measured impact               | [`identification`]                                      |
//! | safe speed of a robot near a person        | [`TransientContact`]                                    |
//!
//! The stiffness is k xᵖ or a force curve ([`StiffnessLaw`]).
//! Three laws are solved exactly, [`kelvin_voigt`], [`hunt_crossley`] and a loss factor ([`Damper::LossFactor`]). The other laws are published approximations
//! of the Hunt–Crossley damping, with known errors. All units are SI. No input causes a panic, a NaN or an infinity:
//! overflow is an error.

mod contact;
mod damper;
mod error;
pub mod exports;
pub mod identification;
mod impact;
mod laws;
mod limits;
mod solutions;
mod stepping;
mod trajectory;
mod transient_contact;
mod varying_mass;

pub use contact::{CompliantContact, DamperCurve, ForceCurve, Separation, StiffnessLaw};
pub use damper::Damper;
pub use error::{ContactLawError, LawParameter};
pub use impact::{Impact, Sample};
pub use laws::{Alias, ApproximationError, Law};
pub use solutions::{hunt_crossley, kelvin_voigt};
pub use stepping::VaryingMassImpact;
pub use transient_contact::{BodyRegion, SafeSpeed, TransientContact, standard_robot_mass};
pub use varying_mass::{
    history_with_varying_mass, impact_with_varying_mass, restitution_with_parallel_forces,
    restitution_with_prescribed_acceleration,
};
