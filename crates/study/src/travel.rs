//! The travel of a point as what a sweep varies: the joint that drives it, and what a row that is not reached says.

use crate::driver::Driver;
use crate::error::{Fault, StudyError};
use crate::field::{Field, Names, about_assembly};
use crate::reach::{Extent, Missed};
use crate::thresholds::{LEAST_ADVANCE, OTHER_DRIVERS, SHORT_OF_END, TRAVEL_STAGES, UNMOVED};
use nalgebra::Vector3;
use percuss_dynamics::{Configuration, ContactResponse, PointVelocity, Pose, System, TravelError};
use percuss_mechanism::{JointId, JointKind, LinkId};

/// The travel of a point from where it starts, and the joint that drives it.
#[derive(Debug)]
pub(crate) struct Travel {
    travel: percuss_dynamics::Travel,
    /// The pose where it starts.
    pub start: Pose,
    /// What asked for it.
    field: Field,
    /// Joints that do not drive it.
    set: Vec<JointId>,
}

/// A pose on the way of a travel, the joint that drives it there, and where the others are wanted.
struct Stage {
    joint: JointId,
    base: Configuration,
    pose: Pose,
}

/// The joints that drive the loops of a pose, in order.
fn drivers(pose: &Pose) -> Vec<JointId> {
    let mut all = pose.loops().map_or_else(Vec::new, |loops| loops.drivers.to_vec());
    all.sort_unstable();
    all
}

impl Travel {
    /// The travel of a point, and the joint that moves it most among those that are not set.
    pub fn new(
        system: &System,
        base: &Configuration,
        field: Field,
        link: LinkId,
        point: Vector3<f64>,
        direction: Vector3<f64>,
        is_set: &dyn Fn(JointId) -> bool,
    ) -> Result<(Self, Driver), StudyError> {
        let refuse = |error: TravelError| match error {
            TravelError::Assembly(error) => StudyError::Assembly(error),
            other => StudyError::input(field, Fault::Travel(other)),
        };
        let start = system.pose(base)?;
        let travel = percuss_dynamics::Travel::new(&start, link, point, direction).map_err(refuse)?;
        let joint = travel.driver(&start, is_set).map_err(refuse)?;
        let set = system.mechanism().joint_ids().filter(|joint| is_set(*joint)).collect();
        Ok((Self { travel, start, field, set }, Driver { joint, base: base.clone() }))
    }

    /// The pose where the point is displaced as requested, on the branch of the last one.
    pub fn reach(
        &self,
        driver: &Driver,
        last: &Pose,
        requested: f64,
        names: Names,
    ) -> Result<Result<Pose, Missed>, StudyError> {
        let error = match self.travel.pose(last, &driver.base, driver.joint, requested) {
            Ok(pose) => return Ok(Ok(pose)),
            Err(error) => error,
        };
        let ended = match &error {
            TravelError::Unreachable { .. } => true,
            TravelError::Assembly(error) => !error.is_bad_input(),
            _ => false,
        };
        if let Some(pose) = ended.then(|| self.by_another(driver, last, requested)).flatten() {
            return Ok(Ok(pose));
        }
        let extent = match &error {
            TravelError::Unreachable { nearest, .. } => Extent::Probably(*nearest),
            TravelError::TooFar { reached, .. } => Extent::TooFar(*reached),
            TravelError::Assembly(error) if !error.is_bad_input() => {
                Extent::Probably(self.travel.displacement(last))
            }
            TravelError::Assembly(error) => return Err(error.clone().into()),
            _ => return Err(StudyError::input(self.field, Fault::Travel(error))),
        };
        let why = match &error {
            TravelError::Assembly(error) => about_assembly(error, names),
            other => other.to_string(),
        };
        Ok(Err(Missed { why, extent }))
    }

    /// The pose where other joints drive the point past the dead centres of its driver and of each other, all other drivers being
    /// the same.
    ///
    /// Joints that move together have one ds/dq each: the least is that of the one that turns furthest, which comes to a dead
    /// centre of its own last. A joint whose own end comes first goes near to it, and the next one takes over there.
    fn by_another(&self, driver: &Driver, last: &Pose, requested: f64) -> Option<Pose> {
        let mut stage = Stage { joint: driver.joint, base: driver.base.clone(), pose: last.clone() };
        let least = LEAST_ADVANCE * last.mechanism().characteristic_length();
        for _ in 0..TRAVEL_STAGES {
            let here = self.travel.displacement(&stage.pose);
            stage.pose = self.travel.pose(&stage.pose, &stage.base, stage.joint, here).ok()?;
            let mut furthest: Option<(f64, Stage)> = None;
            for (joint, base) in self.others(&stage)? {
                let end = match self.driven_by(&stage, joint, &base, requested) {
                    Ok(pose) => return Some(pose),
                    Err(end) => end,
                };
                if furthest
                    .as_ref()
                    .is_none_or(|(best, _)| (requested - end).abs() < (requested - best).abs())
                {
                    furthest = Some((end, Stage { joint, base, pose: stage.pose.clone() }));
                }
            }
            let (end, next) = furthest?;
            let advance = SHORT_OF_END * (end - here);
            if advance * (requested - here).signum() < least {
                return None;
            }
            let pose = self.driven_by(&stage, next.joint, &next.base, here + advance).ok()?;
            stage = Stage { pose, ..next };
        }
        None
    }

    /// Joints that may drive a stage, its own last: each with where the others are wanted. `None` if its joint does not drive it.
    fn others(&self, stage: &Stage) -> Option<Vec<(JointId, Configuration)>> {
        let mechanism = stage.pose.mechanism();
        let size = mechanism.characteristic_length();
        let driven = drivers(&stage.pose);
        if !driven.contains(&stage.joint) {
            return None;
        }
        let rate = |joint: JointId| {
            let unit = if mechanism.joint(joint).kind() == JointKind::Prismatic { size } else { 1.0 };
            let rate = (self.travel.rate(&stage.pose, joint)? * unit).abs();
            let is_free = !driven.contains(&joint) && !self.set.contains(&joint);
            (is_free && rate > UNMOVED * size).then_some((joint, rate))
        };
        let mut rates: Vec<(JointId, f64)> = mechanism.joint_ids().filter_map(rate).collect();
        rates.sort_by(|a, b| a.1.total_cmp(&b.1));
        // What drove beside it stays where it is.
        let mut base = stage.base.clone();
        for held in driven.iter().filter(|joint| **joint != stage.joint) {
            base.set(mechanism.joint(*held).name(), stage.pose.joint(*held)).ok()?;
        }
        let mut others: Vec<_> =
            rates.into_iter().take(OTHER_DRIVERS).map(|(joint, _)| (joint, base.clone())).collect();
        others.push((stage.joint, stage.base.clone()));
        Some(others)
    }

    /// The pose where a joint drives the point from a stage, in the place of its joint; else the displacement that it comes to.
    fn driven_by(
        &self,
        stage: &Stage,
        joint: JointId,
        base: &Configuration,
        requested: f64,
    ) -> Result<Pose, f64> {
        let pose = match self.travel.pose(&stage.pose, base, joint, requested) {
            Ok(pose) => pose,
            Err(TravelError::Unreachable { nearest, .. }) => return Err(nearest),
            // Not the end of the others.
            Err(_) => return Err(self.travel.displacement(&stage.pose)),
        };
        let mut expected: Vec<JointId> = drivers(&stage.pose)
            .into_iter()
            .map(|own| if own == stage.joint { joint } else { own })
            .collect();
        expected.sort_unstable();
        if drivers(&pose) == expected { Ok(pose) } else { Err(self.travel.displacement(&stage.pose)) }
    }

    /// The joint that would drive it at a pose beside others.
    pub fn driver_at(&self, pose: &Pose, others: &[JointId]) -> Option<JointId> {
        self.travel.driver(pose, &|joint| others.contains(&joint)).ok()
    }

    /// Joints that do not drive it.
    pub fn set(&self) -> &[JointId] {
        &self.set
    }

    /// How fast a joint displaces the point, m/rad or m/m; none where that is not determined.
    pub fn rate(&self, pose: &Pose, driver: JointId) -> Option<f64> {
        self.travel.rate(pose, driver)
    }

    /// How far the point is displaced at a pose, m.
    pub fn displacement(&self, pose: &Pose) -> f64 {
        self.travel.displacement(pose)
    }

    /// Speed of the point along its direction per unit closing speed of the contact.
    pub fn motion_ratio(&self, pose: &Pose, response: &ContactResponse) -> Option<f64> {
        match pose.point_velocity(response, self.travel.link(), self.travel.point())? {
            PointVelocity::Known(v) => Some(pose.base().vector(&v).dot(self.travel.direction()).abs()),
            PointVelocity::Undetermined => None,
        }
    }
}
