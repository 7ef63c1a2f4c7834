//! Pose at which several travels have requested displacements at once.

use crate::question::errors::question_error::StudyError;
use crate::question::names::Names;
use crate::thresholds::{
    DEAD_CENTRE_GROWTH, LARGEST_RETREAT, LONGEST_DRIVER_STEP, OTHER_DRIVERS, TRAVEL_PARTS, TRAVEL_ROUNDS,
    TRAVEL_TOLERANCE,
};
use nalgebra::{DMatrix, DVector};
use percuss_dynamics::{Configuration, Pose, Travel};
use percuss_mechanism::{JointId, JointKind};

/// Travels that are solved together.
#[derive(Clone, Debug)]
pub(crate) struct JoinedTravels {
    pub travels: Vec<Travel>,
    /// A driver for each travel, at the starting pose.
    pub drivers: Vec<JointId>,
    /// Set joints; these cannot drive.
    pub set: Vec<JointId>,
    /// Smallest step, as a fraction of the path.
    pub least_part: f64,
    /// True if the path starts at another pose, at which the drivers may be at a dead centre: drivers are selected again there.
    pub selects_drivers: bool,
}

/// Poses between a start and the requested displacements.
struct Progress {
    drivers: Vec<JointId>,
    /// Positions of the drivers.
    at: Vec<f64>,
    pose: Pose,
}

impl JoinedTravels {
    /// Pose with the requested displacements (m), on the branch of `start`. Newton's method on all drivers, with
    /// intermediate targets.
    ///
    /// # Errors
    /// [`StudyError::TravelNotReached`] with the percentage reached.
    pub fn pose(
        &self,
        configuration: &Configuration,
        start: &Pose,
        requested: &[f64],
        names: Names,
    ) -> Result<Pose, StudyError> {
        let begin: Vec<f64> = self.travels.iter().map(|travel| travel.displacement(start)).collect();
        let selected = self.selects_drivers.then(|| self.with_selected_drivers(configuration, start));
        let mut progress = match selected.flatten() {
            Some(progress) => progress,
            None => {
                let drivers = self.drivers.clone();
                let at = positions(start, &drivers);
                let pose = move_drivers(configuration, &drivers, start, &at)?;
                Progress { drivers, at, pose }
            }
        };
        let mut early_changes = 0;
        let (mut reached, mut part, mut changes) = (0.0, 1.0 / TRAVEL_PARTS, 0);
        let mut joint_rates: Option<[Vec<JointRate>; 2]> = None;
        while reached < 1.0 {
            let to = f64::min(reached + part, 1.0);
            let between = |(begin, end): (&f64, &f64)| begin + to * (end - begin);
            let targets: Vec<f64> = begin.iter().zip(requested).map(between).collect();
            match self.solve(configuration, &progress, &targets) {
                Ok((pose, at)) => {
                    let last = mean_rates(&progress.pose, &pose, to - reached);
                    let first = joint_rates.take().map_or_else(|| last.clone(), |[first, _]| first);
                    joint_rates = Some([first, last]);
                    (progress.pose, progress.at, reached) = (pose, at, to);
                    part *= 2.0;
                }
                Err(_) if part < self.least_part && changes < OTHER_DRIVERS => {
                    // A driver may be at a dead centre; other drivers continue from this pose.
                    changes = if reached > 0.0 { changes + 1 } else { OTHER_DRIVERS };
                    if let Some(other) = self.with_selected_drivers(configuration, &progress.pose) {
                        progress = other;
                        part = 1.0 / TRAVEL_PARTS;
                    }
                }
                Err(error) if part < self.least_part => {
                    let why = match error {
                        Some(StudyError::Assembly(error)) if error.is_bad_input() => return Err(error.into()),
                        Some(error) => format!(" ({})", error.message(names)),
                        None => String::new(),
                    };
                    let percent = (100.0 * reached).floor();
                    return Err(StudyError::TravelNotReached {
                        why: format!(
                            "the travels cannot be reached together; reached: {percent} %{}{why}",
                            joint_rates.map_or_else(String::new, |rates| dead_centre_text(start, &rates))
                        ),
                        nearest: None,
                        motion: None,
                    });
                }
                Err(error) => {
                    // Loops that do not close show a dead centre of a driver. A search with shorter parts is slow there.
                    let other = (error.is_some() && reached > 0.0 && early_changes < OTHER_DRIVERS)
                        .then(|| self.with_selected_drivers(configuration, &progress.pose))
                        .flatten()
                        .filter(|other| other.drivers != progress.drivers);
                    match other {
                        Some(other) => (progress, early_changes) = (other, early_changes + 1),
                        None => part *= 0.5,
                    }
                }
            }
        }
        Ok(progress.pose)
    }

    /// Pose with the displacements `targets`, and the positions of the drivers. `Err(None)` if Newton's method does not
    /// converge.
    fn solve(
        &self,
        configuration: &Configuration,
        from: &Progress,
        targets: &[f64],
    ) -> Result<(Pose, Vec<f64>), Option<StudyError>> {
        let within = TRAVEL_TOLERANCE * from.pose.mechanism().characteristic_length();
        let (mut pose, mut at, count) = (from.pose.clone(), from.at.clone(), targets.len());
        let (mut reached, mut largest) = (None, f64::INFINITY);
        for _ in 0..TRAVEL_ROUNDS {
            let missing = self.travels.iter().zip(targets).map(|(t, target)| target - t.displacement(&pose));
            let missing = DVector::from_iterator(count, missing);
            // Newton's method ends if it moves away from the targets.
            if missing.amax() > largest {
                return reached.ok_or(None);
            }
            largest = LARGEST_RETREAT * missing.amax().max(within);
            // One more step removes the error that the tolerance permits.
            if missing.amax() <= within && (reached.is_some() || missing.amax() == 0.0) {
                return Ok((pose, at));
            }
            if missing.amax() <= within {
                reached = Some((pose.clone(), at.clone()));
            }
            let mut rates = DMatrix::zeros(count, count);
            for (i, travel) in self.travels.iter().enumerate() {
                for (j, driver) in from.drivers.iter().enumerate() {
                    let Some(rate) = travel.rate(&pose, *driver) else { return reached.ok_or(None) };
                    rates[(i, j)] = rate;
                }
            }
            let step = rates.lu().solve(&missing).filter(|step| step.iter().all(|x| x.is_finite()));
            let Some(step) = step else { return reached.ok_or(None) };
            // Near a dead centre of a driver the step is long, and the loops would be followed over several turns.
            let is_long = |(driver, step): (&JointId, &f64)| {
                (step / joint_unit(&pose, *driver)).abs() > LONGEST_DRIVER_STEP
            };
            if from.drivers.iter().zip(step.iter()).any(is_long) {
                return reached.ok_or(None);
            }
            at.iter_mut().zip(step.iter()).for_each(|(at, step)| *at += step);
            pose = match (move_drivers(configuration, &from.drivers, &pose, &at), &mut reached) {
                (Ok(pose), _) => pose,
                (Err(_), Some(_)) => break,
                (Err(error), None) => return Err(Some(error)),
            };
        }
        reached.ok_or(None)
    }

    /// Start of a path at a pose, with the drivers selected there.
    fn with_selected_drivers(&self, configuration: &Configuration, pose: &Pose) -> Option<Progress> {
        let drivers = self.select_drivers(pose)?;
        let at = positions(pose, &drivers);
        let pose = move_drivers(configuration, &drivers, pose, &at).ok()?;
        Some(Progress { drivers, at, pose })
    }

    /// Drivers of the travels at a pose; a joint drives one travel at most, and set joints drive none.
    pub fn select_drivers(&self, pose: &Pose) -> Option<Vec<JointId>> {
        let mut drivers = Vec::new();
        for travel in &self.travels {
            let taken = [&self.set[..], &drivers].concat();
            drivers.push(travel.driver(pose, &|joint| taken.contains(&joint)).ok()?);
        }
        Some(drivers)
    }
}

/// Joint with one position, and its mean rate over a part of the path: rad, or characteristic lengths, per length of the path.
type JointRate = (JointId, f64);

/// Mean rates of the joints with one position between two poses; `part` is the fraction of the path between the poses.
fn mean_rates(from: &Pose, to: &Pose, part: f64) -> Vec<JointRate> {
    let mechanism = from.mechanism();
    let is_single = |joint: &JointId| mechanism.joint(*joint).kind().positions() == 1;
    let rate = |joint: JointId| {
        (joint, (to.joint(joint)[0] - from.joint(joint)[0]) / (joint_unit(from, joint) * part))
    };
    mechanism.joint_ids().filter(is_single).map(rate).collect()
}

/// Unit of the motion of a joint: 1 rad, or the characteristic length of the mechanism.
pub(crate) fn joint_unit(pose: &Pose, joint: JointId) -> f64 {
    let mechanism = pose.mechanism();
    let is_prismatic = mechanism.joint(joint).kind() == JointKind::Prismatic;
    if is_prismatic { mechanism.characteristic_length() } else { 1.0 }
}

/// Text with the joints whose rates grow without bound along the path; empty if no joint is near a dead centre. `first`, `last`: mean
/// rates over the first and the last part of the path.
fn dead_centre_text(pose: &Pose, [first, last]: &[Vec<JointRate>; 2]) -> String {
    let largest = last.iter().fold(0.0f64, |most, (_, rate)| most.max(rate.abs()));
    let near = first.iter().zip(last).filter(|((_, first), (_, last))| {
        last.abs() >= 0.1 * largest && last.abs() > DEAD_CENTRE_GROWTH * first.abs()
    });
    let names: Vec<String> =
        near.map(|(_, (joint, _))| format!("{:?}", pose.mechanism().joint(*joint).name())).collect();
    if names.is_empty() {
        return String::new();
    }
    format!(": dead centre of {} (the links that they join are in line)", names.join(", "))
}

/// Pose with the drivers at given positions, on the branch of the pose `from`.
pub(crate) fn move_drivers(
    configuration: &Configuration,
    drivers: &[JointId],
    from: &Pose,
    at: &[f64],
) -> Result<Pose, StudyError> {
    let mut set = configuration.clone().without_guesses();
    for (driver, value) in drivers.iter().zip(at) {
        set.set(from.mechanism().joint(*driver).name(), &[*value])
            .map_err(StudyError::about("pose.travel"))?;
    }
    Ok(from.assembly().pose_from(from, &set)?)
}

/// Positions of joints with one position each.
pub(crate) fn positions(pose: &Pose, joints: &[JointId]) -> Vec<f64> {
    joints.iter().map(|joint| pose.joint(*joint)[0]).collect()
}
