//! Reflected inertia over the range of a driving joint, and the best constant armature.

use crate::ranges::mimic_substitute::{MimicSubstitute, NoSubstitute, mimic_substitute};
use crate::ranges::reflected::{ReflectedError, ReflectedInertia, reflected_inertia_with};
use percuss_dynamics::{AssemblyError, Configuration, ConfigurationError, EffectiveMass, Pose, System};
use percuss_mechanism::JointId;

/// Error of a reflected inertia over a range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RangeError {
    /// A position of the range is not reachable.
    #[error("joint \"{joint}\" at {position}: {error}")]
    Position {
        /// The joint.
        joint: String,
        /// Position, rad or m.
        position: f64,
        /// Reason.
        error: AssemblyError,
    },
    /// The joint cannot be set.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// The inertia cannot be computed.
    #[error(transparent)]
    Reflected(#[from] ReflectedError),
}

/// Reflected inertia at one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReflectedSample {
    /// Position of the joint, rad or m.
    pub position: f64,
    /// Inertia at the joint, free and held.
    pub inertia: ReflectedInertia,
}

/// Reflected inertia over a range of positions.
#[derive(Clone, Debug, PartialEq)]
pub struct ReflectedRange {
    /// Inertia at each position, in the given order.
    pub samples: Vec<ReflectedSample>,
    /// Smallest finite held inertia, kg·m² or kg (free for a joint that does not drive); `None` if no inertia is finite.
    pub least: Option<f64>,
    /// Largest finite held inertia.
    pub most: Option<f64>,
    /// Constant that minimises the largest relative error: the harmonic mean 2ab/(a+b) of the extremes a and b; `None` unless the inertia is
    /// finite at all positions.
    pub best_constant: Option<f64>,
    /// Largest relative error of this constant, (b−a)/(b+a).
    pub largest_error: Option<f64>,
    /// Open tree with mimic joints and an armature, for simulators without loops.
    pub substitute: Result<MimicSubstitute, NoSubstitute>,
}

/// Reflected inertia of a joint with one velocity at `positions` (rad or m).
///
/// The other joints have the positions of `configuration`, whose position of this joint has no effect. Each pose is the start of the
/// solution of the next pose. Simulators without loops approximate a linkage by a constant armature: the error of the best constant shows
/// the quality of this approximation. The substitute with mimic joints contains the links of the linkage.
///
/// # Errors
/// [`RangeError`].
pub fn reflected_inertia_over(
    system: &System,
    configuration: &Configuration,
    joint: JointId,
    positions: &[f64],
) -> Result<ReflectedRange, RangeError> {
    reflected_inertia_over_with(system, configuration, joint, positions, &[])
}

/// As [`reflected_inertia_over`], with the drivers of [`driving_joints_with`](crate::driving_joints_with): first the joint of the range, then
/// the `preferred` joints.
///
/// # Errors
/// [`RangeError`].
pub fn reflected_inertia_over_with(
    system: &System,
    configuration: &Configuration,
    joint: JointId,
    positions: &[f64],
    preferred: &[JointId],
) -> Result<ReflectedRange, RangeError> {
    let preferred = [&[joint], preferred].concat();
    let name = system.mechanism().joint(joint).name().to_owned();
    let mut poses: Vec<Pose> = Vec::with_capacity(positions.len());
    let mut samples = Vec::with_capacity(positions.len());
    for &position in positions {
        let mut wanted = configuration.clone();
        wanted.replace(&name, &[position])?;
        let next = match poses.last() {
            None => system.pose(&wanted),
            Some(last) => system.pose_from(last, &wanted),
        };
        let next = next.map_err(|error| RangeError::Position { joint: name.clone(), position, error })?;
        samples.push(ReflectedSample {
            position,
            inertia: reflected_inertia_with(&next, joint, 0, &preferred)?,
        });
        poses.push(next);
    }
    let value = |sample: &ReflectedSample| match sample.inertia.held.unwrap_or(sample.inertia.free) {
        EffectiveMass::Finite(value) => Some(value),
        _ => None,
    };
    let least = samples.iter().filter_map(value).min_by(f64::total_cmp);
    let most = samples.iter().filter_map(value).max_by(f64::total_cmp);
    let both = least.zip(most).filter(|_| samples.iter().all(|sample| value(sample).is_some()));
    let held: Option<Vec<f64>> = samples.iter().map(|s| s.inertia.held?.kilograms()).collect();
    let substitute = match held {
        Some(held) => mimic_substitute(&poses, joint, &held)?,
        None => Err(NoSubstitute::NotHeld),
    };
    Ok(ReflectedRange {
        samples,
        least,
        most,
        best_constant: both.map(|(a, b)| 2.0 * a * (b / (a + b))),
        largest_error: both.map(|(a, b)| (b - a) / (b + a)),
        substitute,
    })
}
