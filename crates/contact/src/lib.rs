//! Contact damping from the coefficient of restitution, and back.
//!
//! A mass m̄ in kilograms meets a surface at some speed and leaves it with e times that speed. The surface is a spring
//! and a damper; which damper gives e is a matter of the law of the damper, and several are in use. Nothing here knows
//! what the mass is the effective mass of.
//!
//! ```
//! use percuss_contact::{Separation, kelvin_voigt};
//!
//! let ratio = kelvin_voigt::ratio(0.5, Separation::ForceVanishes)?;
//! assert!((ratio - 0.25527563764865).abs() < 1e-13);
//! # Ok::<(), percuss_contact::ContactError>(())
//! ```

mod blow;
mod body_region;
mod contact;
mod damper;
mod error;
mod laws;
mod orbit;
mod quadrature;
mod separation;
mod transient_contact;

pub use blow::{Blow, Sample};
pub use body_region::BodyRegion;
pub use contact::Contact;
pub use damper::Damper;
pub use error::ContactError;
pub use laws::{Alias, ApproximationError, Law, hunt_crossley, kelvin_voigt};
pub use separation::Separation;
pub use transient_contact::{SafeSpeed, TransientContact, standard_robot_mass};
