//! Names of most programs: a model, its conditions, a pose, m̄ at a contact.
//!
//! ```
//! use percuss::prelude::*;
//!
//! let mechanism = load_file("../../models/four_bar.urdf")?.mechanism;
//! let contact = Contact::new(mechanism.find_link("coupler")?, [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
//! let system = System::new(mechanism, &Conditions::new())?;
//! let mut configuration = system.configuration();
//! configuration.set("crank_hinge", &[0.4])?;
//! let response = system.pose(&configuration)?.respond(&contact)?;
//! println!("{:?} {}", response.effective_mass.value(), response.unit());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[doc(no_inline)]
pub use crate::{
    Assembly, Base, Batch, Conditions, Configuration, Contact, Direction, EffectiveMass, Frame, LoadOptions,
    Mechanism, MechanismBuilder, Pose, Source, System, Workspace, load, load_file,
};
