//! Travel of a point as the varied quantity of a sweep: the driving joint, and the consequence of an
//! unreachable row.

use crate::pose::driver::Driver;
use crate::pose::joined_motion::closing_speed;
use crate::pose::joined_travels::JoinedTravels;
use crate::pose::touch::Stop;
use crate::pose::unreachable_range::{UnreachableExtent, UnreachedRow};
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::names::{Names, assembly_error_message};
use crate::question::travel::moved::MovedPoint;
use crate::thresholds::{
    DEAD_CENTRE_APPROACH, LEAST_ADVANCE, LEAST_PART, LEAST_POINT_RATE, OTHER_DRIVERS, TRAVEL_STAGES,
};
use percuss_dynamics::{Configuration, Contact, ContactResponse, PointVelocity, Pose, System, TravelError};
use percuss_mechanism::{JointId, JointKind, LinkId};
use percuss_suspension::kinematics::{is_on_wheel, sliding_rack, wheel_centres};

/// Travel of a point from its starting pose.
#[derive(Clone, Debug)]
pub(crate) struct PointTravel {
    travel: percuss_dynamics::Travel,
    /// Starting pose.
    pub start: Pose,
    /// Key that defines the travel.
    field: &'static str,
    /// Set joints; these cannot drive the travel.
    set: Vec<JointId>,
    /// Travels that are solved with this one; `None` for a single point.
    joined: Option<Joined>,
}

/// Travels of several points, the first point first.
#[derive(Clone, Debug)]
struct Joined {
    travels: JoinedTravels,
    /// Displacement of each point at a unit of the travel.
    ratios: Vec<f64>,
    /// Displacement of each point at travel 0, m, such as by a constant roll.
    offsets: Vec<f64>,
}

impl Joined {
    /// Displacements of the points at a travel, m.
    fn requested(&self, travel: f64) -> Vec<f64> {
        self.ratios.iter().zip(&self.offsets).map(|(ratio, offset)| ratio * travel + offset).collect()
    }
}

/// Stage of a travel: pose, driving joint, and requested configuration of the other joints.
struct TravelStage {
    driver: JointId,
    configuration: Configuration,
    pose: Pose,
}

/// Error of an invalid travel, given by a field of the question.
fn refuse(field: &'static str, error: TravelError) -> StudyError {
    match error {
        TravelError::Assembly(error) => StudyError::Assembly(error),
        other => StudyError::input(field, Fault::Travel(other)),
    }
}

/// Joints that drive the loops of a pose, in increasing order.
fn drivers(pose: &Pose) -> Vec<JointId> {
    let mut all = pose.loops().map_or_else(Vec::new, |loops| loops.drivers.to_vec());
    all.sort_unstable();
    all
}

impl PointTravel {
    /// Travel of a point, and the driver: among joints that are not set, the joint with the largest
    /// displacement of the point relative to the resulting motion of all joints.
    pub fn new(
        system: &System,
        base: &Configuration,
        field: &'static str,
        moved: &MovedPoint,
        is_set: &dyn Fn(JointId) -> bool,
    ) -> Result<(Self, Driver), StudyError> {
        let start = system.pose(base)?;
        let travel = percuss_dynamics::Travel::new(&start, moved.link, moved.point, moved.direction);
        let travel = travel.map_err(|error| refuse(field, error))?;
        Self::with_driver(system, base, field, (start, travel), is_set)
    }

    /// Travel of several points that move together, in the ratio of their distances, and the driver of the first. `offsets`:
    /// displacement of each point at travel 0, m.
    pub fn joined(
        system: &System,
        base: &Configuration,
        field: &'static str,
        moved: &[MovedPoint],
        offsets: &[f64],
        is_set: &dyn Fn(JointId) -> bool,
    ) -> Result<(Self, Driver), StudyError> {
        let (mut first, driver) = Self::new(system, base, field, &moved[0], is_set)?;
        if moved.len() > 1 {
            let (mut travels, mut drivers) = (vec![first.travel.clone()], vec![driver.joint]);
            for other in &moved[1..] {
                let is_taken = |joint| is_set(joint) || drivers.contains(&joint);
                let (travel, driver) = Self::new(system, base, field, other, &is_taken)?;
                travels.push(travel.travel);
                drivers.push(driver.joint);
            }
            let ratios = moved.iter().map(|point| point.distance / moved[0].distance).collect();
            let set = first.set.clone();
            let travels =
                JoinedTravels { travels, drivers, set, least_part: LEAST_PART, selects_drivers: false };
            first.joined = Some(Joined { travels, ratios, offsets: offsets.to_vec() });
        }
        Ok((first, driver))
    }

    /// Travel towards a stop, and the driver.
    pub fn toward_stop(
        system: &System,
        base: &Configuration,
        stop: &Stop,
        is_set: &dyn Fn(JointId) -> bool,
    ) -> Result<(Self, Driver), StudyError> {
        let start = system.pose(base)?;
        let travel = match stop {
            Stop::Contact(gap) => percuss_dynamics::Travel::toward_stop(&start, gap.clone()),
            Stop::Joint(stop) => {
                let travel = percuss_dynamics::Travel::of_joint(&start, stop.joint, stop.is_upper);
                let name = || system.mechanism().joint(stop.joint).name().to_owned();
                let refuse = || refuse("contact.at", TravelError::NoDriver { joint: name() });
                travel.ok_or_else(refuse)?
            }
        };
        Self::with_driver(system, base, "contact.at", (start, travel), is_set)
    }

    /// Travel from its starting pose, and the driver. The rack of a suspension stays where it is, unless nothing else moves
    /// the point.
    fn with_driver(
        system: &System,
        base: &Configuration,
        field: &'static str,
        (start, travel): (Pose, percuss_dynamics::Travel),
        is_set: &dyn Fn(JointId) -> bool,
    ) -> Result<(Self, Driver), StudyError> {
        let mechanism = system.mechanism();
        let set: Vec<JointId> = mechanism.joint_ids().filter(|joint| is_set(*joint)).collect();
        let with_rack_held = || {
            let rack = sliding_rack(mechanism).filter(|rack| !set.contains(rack))?;
            let joint = travel.driver(&start, &|joint| joint == rack || is_set(joint)).ok()?;
            let mut configuration = base.clone();
            configuration.set(mechanism.joint(rack).name(), start.joint(rack)).ok()?;
            let set = set.iter().copied().chain([rack]).collect();
            Some((set, Driver { joint, configuration }))
        };
        let (set, driver) = match with_rack_held() {
            Some(held) => held,
            None => {
                let joint = travel.driver(&start, is_set).map_err(|error| refuse(field, error))?;
                (set, Driver { joint, configuration: base.clone() })
            }
        };
        Ok((Self { travel, start, field, set, joined: None }, driver))
    }

    /// Pose with the requested displacement of the point (m), on the branch of the last pose.
    pub fn pose_at_displacement(
        &self,
        driver: &Driver,
        last: &Pose,
        requested: f64,
        names: Names,
    ) -> Result<Result<Pose, UnreachedRow>, StudyError> {
        if let Some(joined) = &self.joined {
            let points = joined.requested(requested);
            return match joined.travels.pose(&driver.configuration, last, &points, names) {
                Ok(pose) => Ok(Ok(pose)),
                Err(StudyError::TravelNotReached { why, .. }) => {
                    let of_first = self.travel.displacement(last) - joined.offsets[0];
                    let extent = UnreachableExtent::ProbablyBeyond(of_first / joined.ratios[0]);
                    Ok(Err(UnreachedRow { reason: why, extent }))
                }
                Err(error) => Err(error),
            };
        }
        let error = match self.travel.pose(last, &driver.configuration, driver.joint, requested) {
            Ok(pose) => return Ok(Ok(pose)),
            Err(error) => error,
        };
        let ended = match &error {
            TravelError::Unreachable { .. } => true,
            TravelError::Assembly(error) => !error.is_bad_input(),
            _ => false,
        };
        if let Some(pose) = ended.then(|| self.pose_with_other_drivers(driver, last, requested)).flatten() {
            return Ok(Ok(pose));
        }
        let extent = match &error {
            TravelError::Unreachable { nearest, .. } => UnreachableExtent::ProbablyBeyond(*nearest),
            TravelError::TooFar { reached, .. } => UnreachableExtent::BeyondWorkLimit(*reached),
            TravelError::Assembly(error) if !error.is_bad_input() => {
                UnreachableExtent::ProbablyBeyond(self.travel.displacement(last))
            }
            TravelError::Assembly(error) => return Err(error.clone().into()),
            _ => return Err(StudyError::input(self.field, Fault::Travel(error))),
        };
        let why = match (&error, self.kept_joint(&[driver.joint])) {
            (TravelError::Assembly(error), _) => assembly_error_message(error, names),
            (TravelError::Unreachable { requested, nearest }, Some(kept)) => {
                let name = |joint| last.mechanism().joint(joint).name();
                format!(
                    "a travel of {requested} m is not reached by a motion of joint \"{}\" alone; nearest reached: {nearest:.6} m; joint \
                     \"{}\" moves the point too and keeps its position: set it{}",
                    name(driver.joint),
                    name(kept),
                    names.hint("pose.set")
                )
            }
            (other, _) => other.to_string(),
        };
        Ok(Err(UnreachedRow { reason: why, extent }))
    }

    /// Pose reached with other driving joints, past the dead centres of the driver; all other drivers stay the
    /// same.
    ///
    /// Let s be the displacement of the point. Every candidate joint has its own rate ds/dq. The joint with the
    /// smallest rate turns farthest and reaches its dead centre last. A joint that reaches a dead centre
    /// earlier drives the point close to this dead centre, and then the next joint takes over.
    fn pose_with_other_drivers(&self, driver: &Driver, last: &Pose, requested: f64) -> Option<Pose> {
        let mut stage = TravelStage {
            driver: driver.joint,
            configuration: driver.configuration.clone(),
            pose: last.clone(),
        };
        let least = LEAST_ADVANCE * last.mechanism().characteristic_length();
        for _ in 0..TRAVEL_STAGES {
            let here = self.travel.displacement(&stage.pose);
            stage.pose = self.travel.pose(&stage.pose, &stage.configuration, stage.driver, here).ok()?;
            let mut furthest: Option<(f64, TravelStage)> = None;
            for (joint, base) in self.candidate_drivers(&stage)? {
                let end = match self.driven_by(&stage, joint, &base, requested) {
                    Ok(pose) => return Some(pose),
                    Err(end) => end,
                };
                if furthest
                    .as_ref()
                    .is_none_or(|(best, _)| (requested - end).abs() < (requested - best).abs())
                {
                    furthest = Some((
                        end,
                        TravelStage { driver: joint, configuration: base, pose: stage.pose.clone() },
                    ));
                }
            }
            let (end, next) = furthest?;
            let advance = DEAD_CENTRE_APPROACH * (end - here);
            if advance * (requested - here).signum() < least {
                return None;
            }
            let pose = self.driven_by(&stage, next.driver, &next.configuration, here + advance).ok()?;
            stage = TravelStage { pose, ..next };
        }
        None
    }

    /// Candidate drivers of a stage with the requested configuration of the other joints; the stage's own joint
    /// is last. `None` if the stage's joint drives no loop.
    fn candidate_drivers(&self, stage: &TravelStage) -> Option<Vec<(JointId, Configuration)>> {
        let mechanism = stage.pose.mechanism();
        let size = mechanism.characteristic_length();
        let driven = drivers(&stage.pose);
        if !driven.contains(&stage.driver) {
            return None;
        }
        let rate = |joint: JointId| {
            let unit = if mechanism.joint(joint).kind() == JointKind::Prismatic { size } else { 1.0 };
            let rate = (self.travel.rate(&stage.pose, joint)? * unit).abs();
            let is_free = !driven.contains(&joint) && !self.set.contains(&joint);
            (is_free && rate > LEAST_POINT_RATE * size).then_some((joint, rate))
        };
        let mut rates: Vec<(JointId, f64)> = mechanism.joint_ids().filter_map(rate).collect();
        rates.sort_by(|a, b| a.1.total_cmp(&b.1));
        // The other drivers keep their positions.
        let mut base = stage.configuration.clone();
        for held in driven.iter().filter(|joint| **joint != stage.driver) {
            base.set(mechanism.joint(*held).name(), stage.pose.joint(*held)).ok()?;
        }
        let mut others: Vec<_> =
            rates.into_iter().take(OTHER_DRIVERS).map(|(joint, _)| (joint, base.clone())).collect();
        others.push((stage.driver, stage.configuration.clone()));
        Some(others)
    }

    /// Pose with the requested displacement, driven by `joint` instead of the stage's joint; otherwise the
    /// displacement reached.
    fn driven_by(
        &self,
        stage: &TravelStage,
        joint: JointId,
        base: &Configuration,
        requested: f64,
    ) -> Result<Pose, f64> {
        let pose = match self.travel.pose(&stage.pose, base, joint, requested) {
            Ok(pose) => pose,
            Err(TravelError::Unreachable { nearest, .. }) => return Err(nearest),
            // Other errors do not show the end of a branch.
            Err(_) => return Err(self.travel.displacement(&stage.pose)),
        };
        let mut expected: Vec<JointId> = drivers(&stage.pose)
            .into_iter()
            .map(|own| if own == stage.driver { joint } else { own })
            .collect();
        expected.sort_unstable();
        if drivers(&pose) == expected { Ok(pose) } else { Err(self.travel.displacement(&stage.pose)) }
    }

    /// Travel of the point.
    pub fn travel(&self) -> &percuss_dynamics::Travel {
        &self.travel
    }

    /// Joint besides the `drivers` that moves the point, and that a search along these drivers keeps in place.
    pub fn kept_joint(&self, drivers: &[JointId]) -> Option<JointId> {
        let is_taken = |joint| drivers.contains(&joint) || self.set.contains(&joint);
        self.travel.driver(&self.start, &is_taken).ok()
    }

    /// Joints that cannot drive the travel.
    pub fn set(&self) -> &[JointId] {
        &self.set
    }

    /// Displacement of the point at a pose, m.
    pub fn displacement(&self, pose: &Pose) -> f64 {
        self.travel.displacement(pose)
    }

    /// Closing speed of the contact per speed of the point along its direction; negative if the contact closes while the point
    /// moves against its direction. Travels that are solved together and a suspension with a held rack define the motion; a single point
    /// has the motion of the impact. A wheel with the contact on it does not spin. In a roll, the ratio is per upward travel of the wheel on
    /// the side of the contact. A contact on the other side than the single moved wheel has no ratio.
    pub fn motion_ratio(&self, pose: &Pose, contact: &Contact, response: &ContactResponse) -> Option<f64> {
        // The motion of the impact is no motion of several points together.
        let mechanism = pose.mechanism();
        let wheels = wheel_centres(mechanism, mechanism.link(contact.link).name());
        if let Some(Joined { travels, ratios, .. }) = &self.joined {
            let own = travels.travels.iter().position(|travel| wheels == [travel.link()]);
            let of_own_wheel = own.and_then(|own| ratios.get(own)).map_or(1.0, |ratio| ratio.signum());
            let travels: Vec<_> =
                travels.travels.iter().zip(ratios.iter().map(|ratio| of_own_wheel * ratio)).collect();
            return closing_speed(pose, &travels, &self.set, contact);
        }
        let is_wheel = wheel_centres(mechanism, "").contains(&self.travel.link());
        if is_wheel && !wheels.contains(&self.travel.link()) {
            return None;
        }
        // The wheel does not spin while it travels.
        if is_wheel && is_on_wheel(mechanism, contact.link) {
            return closing_speed(pose, &[(&self.travel, 1.0)], &self.set, contact);
        }
        if sliding_rack(pose.mechanism()).is_some_and(|rack| self.set.contains(&rack)) {
            return closing_speed(pose, &[(&self.travel, 1.0)], &self.set, contact);
        }
        let reference = reference_link(pose, response);
        match pose.point_velocity_against(response, self.travel.link(), self.travel.point(), reference)? {
            PointVelocity::Known(v) => {
                let speed = pose.base().vector(&v).dot(self.travel.direction()?);
                (speed != 0.0).then(|| speed.recip())
            }
            PointVelocity::Undetermined => None,
        }
    }
}

/// Link relative to which a point of the mechanism moves: the root link, such as the chassis, for a contact against a link; the ground
/// (`None`) for a contact against the ground.
pub(crate) fn reference_link(pose: &Pose, response: &ContactResponse) -> Option<LinkId> {
    response.contact.against.map(|_| pose.mechanism().root())
}
