//! The travel of a point: the joint that drives it, and how far it must be driven for a displacement.

use crate::driver::Driver;
use crate::error::{Fault, Field, StudyError};
use crate::reach::{Extent, Missed};
use crate::thresholds::{FIRST_STEP, LONGEST_STEP, MET, ROUNDED, SHORTEST_DIRECTION, STEPS, UNMOVED};
use nalgebra::Vector3;
use percuss_dynamics::{Configuration, ContactResponse, PointVelocity, Pose, System};
use percuss_mechanism::{JointId, JointKind, LinkId};
use std::sync::Arc;

/// A point of a link, and the direction in which it travels.
#[derive(Debug)]
pub(crate) struct Travel {
    link: LinkId,
    /// m, link's frame.
    point: Vector3<f64>,
    /// Unit vector, world axes.
    direction: Vector3<f64>,
    /// Where it starts, m, in the world.
    origin: Vector3<f64>,
    /// The pose where it starts.
    pub start: Pose,
}

impl Travel {
    /// The travel of a point, and the joint that moves it most among those that are not set.
    pub fn new(
        system: &System,
        base: &Configuration,
        link: LinkId,
        point: Vector3<f64>,
        direction: Vector3<f64>,
        is_set: &dyn Fn(JointId) -> bool,
    ) -> Result<(Self, Driver), StudyError> {
        let length = direction.norm();
        if !(length >= SHORTEST_DIRECTION && length.is_finite()) {
            return Err(StudyError::input(Field::Vary, Fault::TravelDirection { length }));
        }
        let start = system.pose(base)?;
        let origin = start.link(link).point(&point);
        let travel = Self { link, point, direction: direction / length, origin, start };
        let driver = travel.driver(system, base, is_set).ok_or_else(|| {
            let link = system.mechanism().link(link).name().to_owned();
            StudyError::input(Field::Vary, Fault::NothingMoves { link })
        })?;
        Ok((travel, driver))
    }

    /// Displacement of the point at a pose, m.
    fn gone(&self, pose: &Pose) -> f64 {
        self.direction.dot(&(pose.link(self.link).point(&self.point) - self.origin))
    }

    /// The free joint that moves the point most along its direction.
    fn driver(
        &self,
        system: &System,
        base: &Configuration,
        is_set: &dyn Fn(JointId) -> bool,
    ) -> Option<Driver> {
        let mechanism = Arc::clone(system.mechanism());
        let size = mechanism.characteristic_length();
        let mut best: Option<(f64, Driver)> = None;
        for joint in mechanism.joint_ids() {
            let found = mechanism.joint(joint);
            if found.kind().positions() != 1 || found.mimic().is_some() || is_set(joint) {
                continue;
            }
            let driver = Driver { joint, base: base.clone() };
            let small = FIRST_STEP * unit(&driver, size);
            // A joint that follows from loops cannot be set, or only with others: then it drives nothing here.
            let Ok(moved) = driver.pose(system, Some(&self.start), driver.value(&self.start) + small) else {
                continue;
            };
            let speed = (self.gone(&moved) / small).abs();
            if speed > UNMOVED * size && best.as_ref().is_none_or(|(most, _)| speed > *most) {
                best = Some((speed, driver));
            }
        }
        best.map(|(_, driver)| driver)
    }

    /// Moves the driver until the point is displaced as wanted: secant steps. A step beyond the end of the mechanism's
    /// range is halved until it is none.
    pub fn reach(
        &self,
        system: &System,
        driver: &Driver,
        last: &Pose,
        wanted: f64,
    ) -> Result<Result<Pose, Missed>, StudyError> {
        let size = system.mechanism().characteristic_length();
        let gone = |pose: &Pose| self.gone(pose);
        let small = FIRST_STEP * unit(driver, size);
        let limit = LONGEST_STEP * unit(driver, size);
        let mut from = last.clone();
        let first = |step: f64| driver.pose(system, Some(last), driver.value(last) + step);
        let mut to = match first(small).or_else(|_| first(-small)) {
            Ok(pose) => pose,
            Err(error) if error.is_no_answer() => {
                return Ok(Err(Missed { why: error.to_string(), extent: Extent::Probably(gone(last)) }));
            }
            Err(error) => return Err(error),
        };
        let mut nearest = gone(&from);
        for _ in 0..STEPS {
            let (miss, before) = (gone(&to) - wanted, gone(&from) - wanted);
            if miss.abs() < (nearest - wanted).abs() {
                nearest = gone(&to);
            }
            let slope = (miss - before) / (driver.value(&to) - driver.value(&from));
            let step = (-miss / slope).clamp(-limit, limit);
            let met = miss.abs() <= MET * size;
            let next = advance(system, driver, &to, step)?;
            if met {
                // One more step takes what is left to rounding, whatever the steps before were.
                let closer = next.filter(|next| (gone(next) - wanted).abs() <= miss.abs());
                return Ok(Ok(closer.unwrap_or(to)));
            }
            let Some(next) = next else { break };
            from = std::mem::replace(&mut to, next);
        }
        if (gone(&to) - wanted).abs() <= ROUNDED * size {
            return Ok(Ok(to));
        }
        let why = format!("a travel of {wanted} m cannot be reached; nearest reached: {nearest:.6} m");
        Ok(Err(Missed { why, extent: Extent::Probably(nearest) }))
    }

    /// Speed of the point along its direction per unit closing speed of the contact.
    pub fn motion_ratio(&self, pose: &Pose, response: &ContactResponse) -> Option<f64> {
        match pose.point_velocity(response, self.link, &self.point)? {
            PointVelocity::Known(v) => Some(pose.base().vector(&v).dot(&self.direction).abs()),
            PointVelocity::Undetermined => None,
        }
    }
}

/// Steps of a driver are in radians, or in sizes of the mechanism.
fn unit(driver: &Driver, size: f64) -> f64 {
    if driver.kind() == JointKind::Prismatic { size } else { 1.0 }
}

/// A step of the driver, halved until it can be made; none where it can not.
fn advance(system: &System, driver: &Driver, from: &Pose, mut step: f64) -> Result<Option<Pose>, StudyError> {
    let value = driver.value(from);
    while step.is_finite() && value + step != value {
        match driver.pose(system, Some(from), value + step) {
            Ok(next) => return Ok(Some(next)),
            Err(error) if error.is_no_answer() => step *= 0.5,
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}
