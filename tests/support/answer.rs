//! Results of the library as plain values: the interface to percuss for the family tests.

use percuss_dynamics::{
    Batch, BatchAnswer, BatchError, BatchRows, Conditions, Contact, ContactResponse, EffectiveMass, Pose,
    Remark, RouteChoice, RowResults, System,
};
use percuss_mechanism::{JointId, LinkId, Mechanism};
use percuss_spatial::Vector3;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// A mechanism on the ground with all joints free.
pub struct Model {
    system: System,
}

/// A mechanism at a configuration.
pub struct PosedModel {
    pose: Pose,
}

/// Result for a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Kind of the result.
    pub status: Status,
    /// m̄, kg; NaN unless finite.
    pub mass: f64,
    /// The stated error, kg; NaN if none is stated.
    pub error: f64,
    /// Degrees of freedom at this pose.
    pub degrees_of_freedom: usize,
    /// True if branches cross at this pose.
    pub singular: bool,
    /// True if the result has a warning that digits or the number of freedoms are uncertain.
    pub warned: bool,
    /// True if the result has a warning that the gap hardly closes.
    pub nearly_immovable: bool,
}

/// Kind of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// m̄ is a number.
    Finite,
    /// No motion closes the gap.
    Immovable,
    /// A motion without mass closes the gap.
    Massless,
}

/// The value, or one line with the reason of failure: an error or a panic.
pub type Answered<T> = Result<T, String>;

fn caught<T, E: std::fmt::Display>(ask: impl FnOnce() -> Result<T, E>) -> Answered<T> {
    match catch_unwind(AssertUnwindSafe(ask)) {
        Ok(answer) => answer.map_err(|error| error.to_string().replace('\n', " ")),
        Err(_) => Err("panicked".into()),
    }
}

impl Model {
    /// Compiles the mechanism.
    ///
    /// # Errors
    /// The error of the library, in a line.
    pub fn new(mechanism: impl Into<Arc<Mechanism>>) -> Answered<Self> {
        let mechanism = mechanism.into();
        caught(|| System::new(mechanism, &Conditions::new())).map(|system| Self { system })
    }

    /// True if the rank at a generic pose is clear.
    pub fn rank_is_clear(&self) -> bool {
        self.system.reference_or_open().rank_is_clear()
    }

    /// Degrees of freedom and redundant rows at a generic pose.
    ///
    /// # Errors
    /// A panic of the library.
    pub fn generic(&self) -> Answered<(usize, usize)> {
        caught(|| {
            let system = &self.system;
            Ok::<_, String>((system.degrees_of_freedom(), system.reference_or_open().redundant_constraints()))
        })
    }

    /// Pose with some joints set; other joints are at 0 or dependent.
    ///
    /// # Errors
    /// The error of the library, in a line.
    pub fn at(&self, set: &[(JointId, f64)]) -> Answered<PosedModel> {
        let mut configuration = self.system.configuration();
        for (joint, value) in set {
            let name = self.system.mechanism().joint(*joint).name();
            caught(|| configuration.set(name, &[*value]).map(|_| ()))?;
        }
        caught(|| self.system.pose(&configuration)).map(|pose| PosedModel { pose })
    }
}

impl PosedModel {
    fn is_warned(&self, response: &ContactResponse) -> bool {
        let uncertain = match (response.effective_mass, response.effective_mass_error()) {
            (EffectiveMass::Finite(mass), Some(error)) => error > 1e-6 * mass,
            (EffectiveMass::Finite(_), None) => true,
            (EffectiveMass::Immovable | EffectiveMass::Massless, _) => false,
        };
        let remark = |r: &Remark| matches!(r, Remark::MasslessToRounding { .. } | Remark::UnclearRank { .. });
        uncertain || response.remarks.iter().any(remark) || !self.pose.assembly().rank_is_clear()
    }

    /// The position of a joint.
    pub fn joint(&self, joint: JointId) -> &[f64] {
        self.pose.joint(joint)
    }

    /// The joints that drive loops.
    pub fn drivers(&self) -> Vec<JointId> {
        self.pose.loops().map(|loops| loops.drivers.clone()).unwrap_or_default()
    }

    /// Response to a contact of a point (m) of a link with the ground, with the normal in the link's axes.
    ///
    /// # Errors
    /// The error of the library, in a line.
    pub fn respond(&self, link: LinkId, point: Vector3<f64>, normal: Vector3<f64>) -> Answered<Answer> {
        self.respond_by(RouteChoice::Auto, &Contact::new(link, point, normal))
    }

    /// Response by a given route.
    ///
    /// # Errors
    /// The error of the library, in a line.
    pub fn respond_by(&self, choice: RouteChoice, contact: &Contact) -> Answered<Answer> {
        let response = caught(|| self.pose.respond_by_route(contact, choice))?;
        let (status, mass) = match response.effective_mass {
            EffectiveMass::Finite(mass) => (Status::Finite, mass),
            EffectiveMass::Immovable => (Status::Immovable, f64::NAN),
            EffectiveMass::Massless => (Status::Massless, f64::NAN),
        };
        Ok(Answer {
            status,
            mass,
            error: response.effective_mass_error().unwrap_or(f64::NAN),
            degrees_of_freedom: response.degrees_of_freedom,
            singular: response.singular_pose,
            warned: self.is_warned(&response),
            nearly_immovable: response
                .remarks
                .iter()
                .any(|r| matches!(r, Remark::NearlyImmovable { uncertainty, .. } if *uncertainty >= 1.0)),
        })
    }

    /// Limits along the branches that cross at this pose, kg; true if the list is complete.
    ///
    /// # Errors
    /// A panic of the library.
    pub fn limits(&self, contact: &Contact) -> Answered<(Vec<EffectiveMass>, bool)> {
        let limits = caught(|| Ok::<_, String>(self.pose.branch_limits(contact)))?;
        Ok((limits.limits, limits.complete))
    }
}

/// Results of `count` rows, computed in blocks.
///
/// # Errors
/// [`BatchError`] of the batch.
pub fn answers<'a>(
    batch: &Batch,
    rows: impl Into<BatchRows<'a>>,
    count: usize,
    block: usize,
) -> Result<Vec<BatchAnswer>, BatchError> {
    let mut results = RowResults::new(count);
    batch.run(rows, results.columns(), block)?;
    Ok((0..count).map(|row| results.answer(row)).collect())
}
