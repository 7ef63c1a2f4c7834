//! The contact in the numbers of a simulator: which parameters give it the required restitution.
//!
//! A [`Request`] is a contact, a restitution and what some tools need in addition; [`Tool::export`] answers with an
//! [`Export`]: the tool's parameters, snippets for its files, the time step that holds the accuracy, what was assumed,
//! and what the tool cannot do. Every tool here clamps a force that would pull, so linear springs and dampers get the
//! ratio ζ of a contact that ends when the force vanishes; the half-period formula of textbooks would give too much restitution.
//!
//! [`Options::stop`] asks for the stop of a joint in place of a contact between bodies.
//!
//! One file per tool. Nothing here reads a simulator's files or runs one.

mod adams;
mod bullet;
mod chrono;
mod dart;
mod drake;
mod drift;
mod error;
mod export;
mod exudyn;
mod gazebo;
mod gazebo_classic;
mod gravity;
mod impact_function;
mod jolt;
mod linear;
mod loops;
mod mujoco;
mod newton;
mod ode;
mod opensim;
mod physx;
mod rapier;
mod request;
mod rigid;
mod simscape;
mod single_precision;
mod stops;
mod tool;

pub use error::ExportError;
pub use export::{Export, Parameter, Penetration, Snippet, Value};
pub use impact_function::ImpactFunction;
pub use request::{MassDrift, Options, Request, StopMotion};
pub use tool::{Facts, Measurement, Tool};

use crate::error::nearest;

/// One line a tool: the constant and its module, which has its `FACTS` and its `export`.
macro_rules! tools {
    ($($constant:ident: $module:ident,)*) => {
        impl Tool {
            $(
                #[doc = concat!("The tool of [`name`](Tool::name) ", stringify!($module), ".")]
                pub const $constant: Self = Self::of(&$module::FACTS);
            )*
            /// All of them.
            pub const ALL: [Self; [$(stringify!($module)),*].len()] = [$(Self::$constant),*];
        }

        /// In the order of [`Tool::ALL`].
        const EXPORTS: [fn(&Request) -> Result<Export, ExportError>; Tool::ALL.len()] = [$($module::export),*];
    };
}

tools! {
    MUJOCO: mujoco,
    DRAKE: drake,
    GAZEBO: gazebo,
    GAZEBO_CLASSIC: gazebo_classic,
    ODE: ode,
    BULLET: bullet,
    PHYSX: physx,
    RAPIER: rapier,
    CHRONO: chrono,
    ADAMS: adams,
    SIMSCAPE: simscape,
    DART: dart,
    OPENSIM: opensim,
    EXUDYN: exudyn,
    NEWTON: newton,
    JOLT: jolt,
}

impl Tool {
    /// The tool of this name or alias, in either case.
    pub fn from_name(name: &str) -> Result<Self, ExportError> {
        let wanted = name.trim().to_lowercase().replace([' ', '_'], "-");
        let found =
            Self::ALL.into_iter().find(|t| t.name() == wanted || t.aliases().contains(&wanted.as_str()));
        found.ok_or_else(|| {
            let known = Self::ALL.map(Self::name);
            let all = Self::ALL.into_iter().flat_map(|t| t.aliases().iter().copied().chain([t.name()]));
            ExportError::UnknownTool {
                name: name.to_owned(),
                nearest: nearest(&wanted, all),
                known: known.join(", "),
            }
        })
    }

    /// The parameters with which the tool gives the contact the required restitution.
    ///
    /// A tool for which one number is missing still gives the others, and lists it in [`Export::missing`]. Errors: a
    /// number of the request is out of its range; the tool cannot have this restitution, this exponent or this time
    /// step; a number it cannot do without is missing; a parameter does not fit in a 64-bit float.
    pub fn export(self, request: &Request) -> Result<Export, ExportError> {
        request.check()?;
        if let Some(motion) = request.options.stop {
            let mut export = loops::apply(self, request, stops::export(self, request, motion)?)?;
            export.penetrations.iter_mut().for_each(|p| p.unit = motion.units().coordinate);
            return drift::apply(request, export).finite();
        }
        let (_, export) =
            Self::ALL.into_iter().zip(EXPORTS).find(|(tool, _)| *tool == self).expect("a tool is one of all");
        let mut export = loops::apply(self, request, export(request)?)?;
        gravity::assume(request, &mut export);
        drift::apply(request, export).finite()
    }
}
