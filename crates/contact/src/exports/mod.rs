//! Simulator parameters for a contact with a required restitution.
//!
//! A [`Request`] is a contact, a restitution and options of some tools; [`Tool::export`] returns an [`Export`]: the
//! tool's parameters, snippets for its files, the time step for the accuracy, assumptions and limitations. Most tools
//! clamp a force that would pull, so linear springs and dampers get the ratio ζ of a contact that ends when the force
//! vanishes; the half-period formula of textbooks would give too much restitution. [`Penetration`] follows from the
//! law of each tool.
//!
//! [`Options::stop`] selects the stop of a joint instead of a contact between bodies.
//!
//! A force curve is replaced by the spring of the tool that has the penetration of the curve; an assumption has the error of the peak force.
//!
//! One file per tool in `simulators`. This module neither reads files of simulators nor runs simulators.

mod drift;
mod error;
mod export;
mod gravity;
mod impact_function;
mod linear;
mod loops;
mod request;
mod rigid;
mod simulators;
mod single_precision;
mod stops;
mod tool;

pub use error::ExportError;
pub use export::{Export, Parameter, Penetration, Snippet, Value};
pub use impact_function::ImpactFunction;
pub use request::{MassDrift, Options, Request, StopMotion};
pub use simulators::simulated::{ContactModel, Impedance, SimulatedContact, SimulatedImpact};
pub use tool::{Facts, Measurement, Tool};

use crate::error::nearest;
use simulators::simulated::Given;

/// One line per tool: the constant and the module with `FACTS` and `export`.
macro_rules! tools {
    ($($constant:ident: $module:ident,)*) => {
        impl Tool {
            $(
                #[doc = concat!("The tool of [`name`](Tool::name) ", stringify!($module), ".")]
                pub const $constant: Self = Self::of(&simulators::$module::FACTS);
            )*
            /// All tools.
            pub const ALL: [Self; [$(stringify!($module)),*].len()] = [$(Self::$constant),*];
        }

        /// Export functions in the order of [`Tool::ALL`].
        const EXPORTS: [fn(&Request) -> Result<Export, ExportError>; Tool::ALL.len()] = [$(simulators::$module::export),*];

        /// Contacts of given parameters in the order of [`Tool::ALL`].
        const SIMULATED: [fn(&mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError>; Tool::ALL.len()] =
            [$(simulators::$module::simulated),*];
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
    /// Tool with this name or alias; upper and lower case are equal.
    pub fn from_name(name: &str) -> Result<Self, ExportError> {
        let normalised = name.trim().to_lowercase().replace([' ', '_'], "-");
        let found = Self::ALL
            .into_iter()
            .find(|t| t.name() == normalised || t.aliases().contains(&normalised.as_str()));
        found.ok_or_else(|| {
            let known = Self::ALL.map(Self::name);
            let all = Self::ALL.into_iter().flat_map(|t| t.aliases().iter().copied().chain([t.name()]));
            ExportError::UnknownTool {
                name: name.to_owned(),
                nearest: nearest(&normalised, all),
                known: known.join(", "),
            }
        })
    }

    /// Parameters of the tool for the required restitution.
    ///
    /// If an optional number is missing, the other parameters are exported and the number is listed in
    /// [`Export::missing`]. Errors: a number of the request is out of range; the tool does not support the restitution,
    /// the exponent or the time step; a required number is missing; a parameter does not fit in a 64-bit float; the
    /// error bound is larger than the restitution.
    pub fn export(self, request: &Request) -> Result<Export, ExportError> {
        request.check()?;
        if request.contact.power_law().is_none() {
            return simulators::equivalent::export(self, request);
        }
        if let Some(motion) = request.options.stop {
            let mut export = loops::add_loop_finding(self, request, stops::export(self, request, motion)?)?;
            export.penetrations.iter_mut().for_each(|p| p.unit = motion.units().coordinate);
            let (export, drift_error) = drift::add_drift_error(request, export);
            return export.check_finite()?.check_error_bound(request, drift_error);
        }
        let (_, export) =
            Self::ALL.into_iter().zip(EXPORTS).find(|(tool, _)| *tool == self).expect("a tool is one of all");
        let mut export = loops::add_loop_finding(self, request, export(request)?)?;
        gravity::add_assumption(request, &mut export);
        let (export, drift_error) = drift::add_drift_error(request, export);
        export.check_finite()?.check_error_bound(request, drift_error)
    }

    /// Contact with given parameters of the tool, in each of its solvers that they describe: the inverse of [`export`](Self::export).
    ///
    /// `mass`: m̄, kg. `parameters`: numbers by the names of an [`Export`]; optional are numbers that only determine an error of the tool.
    /// The law holds in the limit of small time steps; the damping that implicit Euler adds at the given step is included.
    ///
    /// # Errors
    /// [`ExportError`]: a parameter is missing, unknown or out of range, or has a value for which the impact is not known (friction).
    pub fn simulated(
        self,
        mass: f64,
        parameters: &[(String, Vec<f64>)],
    ) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
        let mut given = Given::new(self, mass, parameters)?;
        let (_, simulated) = Self::ALL
            .into_iter()
            .zip(SIMULATED)
            .find(|(tool, _)| *tool == self)
            .expect("a tool is one of all");
        let found = simulated(&mut given)?;
        given.finish()?;
        Ok(found)
    }
}
