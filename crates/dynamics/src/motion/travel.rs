//! Travel of a point: its displacement, its rate with respect to a driving joint, and the pose of a given
//! displacement.

use crate::analysis::pose::Pose;
use crate::kinematics::gap::Gap;
use crate::kinematics::rows::GroupRows;
use crate::loops::assembling::AssemblyError;
use crate::loops::closing::Directions;
use crate::mobility::Singularity;
use crate::model::configuration::Configuration;
use crate::model::input::{foreign_link, is_number};
use crate::model::{Model, VelocityCoordinate};
use crate::motion::gap::speed_along;
use crate::motion::travel_search::{Scale, Search, SearchError, TravelPoint, VisitError};
use crate::tolerances::{
    DISPLACEMENT_ACCURACY, FIRST_STEP, SAME_RATE, SHORTEST_DIRECTION, UNMOVED, WEAK_DRIVER,
};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId, Mechanism};
use percuss_spatial::Transform;
use std::sync::Arc;

/// Displacement relative to a given pose: of a point of a link along a direction, of a point towards a stop, or of a joint.
///
/// Along a direction n: s = n · (p_w − p_w at that pose), m. Towards a stop: s = g at that pose − g, m, with the gap g
/// of [`Gap`]. Of a joint: s = ± ℓ (q − q₀), m, with the positions q and, at that pose, q₀. ℓ is the characteristic length of the
/// mechanism if the joint turns, and 1 if the joint slides. ds/dq is the rate of s for the motion u with A u = 0, where u is 1 for the
/// driver and 0 for the other drivers.
#[derive(Clone, Debug)]
pub struct Travel {
    link: LinkId,
    point: Vector3<f64>,
    measure: Measure,
}

/// Measure of a displacement.
#[derive(Clone, Debug)]
enum Measure {
    /// Along a fixed direction of the world.
    Along {
        direction: Vector3<f64>,
        /// X_wr at the start.
        base: Transform<f64>,
        /// Start point in the frame of the root link, m. Root coordinates avoid a loss of digits far from the world's
        /// origin.
        origin: Vector3<f64>,
    },
    /// Closing of a gap.
    TowardStop {
        gap: Gap,
        /// Gap at the start, m.
        start: f64,
    },
    /// Motion of a joint.
    OfJoint {
        joint: JointId,
        /// ± ℓ, m/rad or 1.
        scale: f64,
        /// Position at the start, rad or m.
        start: f64,
    },
}

/// Error of a travel: invalid, or not reachable.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TravelError {
    /// A component is NaN, infinite or above 1e100 in magnitude.
    #[error("the {what} of travel has a component {value:e}; a finite number of at most 1e100 is expected")]
    NotFinite {
        /// `point`, `direction` or `displacement`.
        what: &'static str,
        /// The component.
        value: f64,
    },
    /// The direction of travel has no length.
    #[error(
        "the direction of travel has no length ({length:e}; at least {SHORTEST_DIRECTION:e} is expected)"
    )]
    NoDirection {
        /// Length of the direction.
        length: f64,
    },
    /// A link handle of another mechanism.
    #[error(
        "link number {index} is not in this mechanism, which has {links} links; look up the link by name"
    )]
    ForeignLink {
        /// Index of the handle.
        index: usize,
        /// Number of links of this mechanism.
        links: usize,
    },
    /// No joint drives the point.
    #[error(
        "no joint that is free to drive moves this point of link \"{link}\" along the direction of travel"
    )]
    NothingMoves {
        /// Link of the point.
        link: String,
    },
    /// The joint cannot be a driver: it does not have exactly one position of its own.
    #[error("joint \"{joint}\" has no single position of its own to drive by")]
    NoDriver {
        /// The joint.
        joint: String,
    },
    /// The driver reached its limit, or the point reversed, before the requested displacement.
    #[error("a travel of {requested} m cannot be reached; nearest reached: {nearest:.6} m")]
    Unreachable {
        /// Requested displacement, m.
        requested: f64,
        /// Nearest displacement within the monotonic range, m.
        nearest: f64,
    },
    /// The travel exceeds the step limit of one pose.
    #[error(
        "a travel of {requested} m is too far for one call; reached: {reached:.6} m; use intermediate poses"
    )]
    TooFar {
        /// Requested displacement, m.
        requested: f64,
        /// Reached displacement, m.
        reached: f64,
    },
    /// Loops that do not close, or a configuration that does not fit.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
}

/// Effect of a joint on the point.
enum DriveEffect {
    /// The joint cannot be set: it depends on other joints that are declared or set.
    None,
    /// Not determined to first order: the pose is a change point, or a dead centre of the joint.
    Undetermined { weak: bool },
    /// Determined rate; `weak`: near a dead centre of the joint.
    Determined { rate: f64, motion: f64, weak: bool },
}

/// Joint that may drive the point.
struct Candidate {
    joint: JointId,
    /// ds/dq, m/rad or m/m.
    rate: f64,
    /// Σ u² of all moving joints (radians, and translations relative to the mechanism's size), at unit rate of this
    /// joint.
    motion: f64,
    weak: bool,
}

impl Travel {
    /// Travel of a point (m, link frame) along a direction (world axes, any length), relative to the point's position
    /// at a pose.
    ///
    /// # Errors
    /// [`TravelError`]: a number that is not finite, no direction, a link of another mechanism.
    pub fn new(
        pose: &Pose,
        link: LinkId,
        point: Vector3<f64>,
        direction: Vector3<f64>,
    ) -> Result<Self, TravelError> {
        let links = pose.mechanism().links().len();
        if let Some(index) = foreign_link(pose.mechanism(), [link]) {
            return Err(TravelError::ForeignLink { index, links });
        }
        for (what, vector) in [("point", &point), ("direction", &direction)] {
            if let Some(&value) = vector.iter().find(|x| !is_number(**x)) {
                return Err(TravelError::NotFinite { what, value });
            }
        }
        let length = direction.norm();
        if length < SHORTEST_DIRECTION {
            return Err(TravelError::NoDirection { length });
        }
        let origin = pose.kinematics.link_frame(pose.assembly.pose_model(), link).point(&point);
        let measure = Measure::Along { direction: direction / length, base: pose.base, origin };
        Ok(Self { link, point, measure })
    }

    /// Travel towards a stop, relative to a pose. The stop touches at a displacement of the gap at this pose.
    pub fn toward_stop(pose: &Pose, gap: Gap) -> Self {
        let start = gap.at(pose);
        Self { link: gap.link, point: gap.point, measure: Measure::TowardStop { gap, start } }
    }

    /// Travel of a joint with one position, relative to a pose: positive towards the upper limit if `is_upper`, otherwise towards the
    /// lower limit. `None` for a joint of another mechanism, and for a joint with no position or several positions.
    pub fn of_joint(pose: &Pose, joint: JointId, is_upper: bool) -> Option<Self> {
        let mechanism = pose.mechanism();
        let declared = mechanism.joints().get(joint.index()).filter(|_| mechanism.has_joint(joint))?;
        let [start] = *pose.joint(joint) else { return None };
        let length = mechanism.characteristic_length() / unit(mechanism, joint);
        let scale = if is_upper { length } else { -length };
        let measure = Measure::OfJoint { joint, scale, start };
        Some(Self { link: declared.child(), point: Vector3::zeros(), measure })
    }

    /// Link of the point.
    pub fn link(&self) -> LinkId {
        self.link
    }

    /// The point in the link frame, m.
    pub fn point(&self) -> &Vector3<f64> {
        &self.point
    }

    /// Unit vector of the direction, in world axes; `None` for a travel towards a stop and for a travel of a joint.
    pub fn direction(&self) -> Option<&Vector3<f64>> {
        match &self.measure {
            Measure::Along { direction, .. } => Some(direction),
            Measure::TowardStop { .. } | Measure::OfJoint { .. } => None,
        }
    }

    /// Displacement of the point at a pose of the same mechanism, m.
    pub fn displacement(&self, pose: &Pose) -> f64 {
        let (direction, base, origin) = match &self.measure {
            Measure::Along { direction, base, origin } => (direction, base, origin),
            Measure::TowardStop { gap, start } => return start - gap.at(pose),
            Measure::OfJoint { joint, scale, start } => return scale * (pose.joint(*joint)[0] - start),
        };
        let at = pose.kinematics.link_frame(pose.assembly.pose_model(), self.link).point(&self.point);
        let mut moved = pose.base.vector(&(at - origin));
        if pose.base != *base {
            moved += pose.base.point(origin) - base.point(origin);
        }
        direction.dot(&moved)
    }

    /// ds/dq: displacement per unit motion of a joint (m/rad, or m/m). The dependent coordinates of its loops follow,
    /// and the other drivers of the pose do not move. A joint that is dependent at the pose is treated as if only
    /// this joint were set.
    ///
    /// `None` at a change point or at a dead centre of the joint, where the rate is not determined. `None` also for a
    /// joint that cannot drive: with no position or several positions, a mimic, or dependent on declared drivers.
    /// Exact within rounding. Cost: one factorisation of the dependent coordinates' Jacobian of its loops.
    pub fn rate(&self, pose: &Pose, driver: JointId) -> Option<f64> {
        if !is_driver(pose.mechanism(), driver) {
            return None;
        }
        let drive = match (is_independent_at(pose, driver), group_of(pose, driver), &pose.loops) {
            (true, Some(number), Some(loops)) => {
                self.effect_through_loops(pose, driver, number, &loops.dependent[number], 0.0)
            }
            _ => self.joint_effect(pose, driver, &|_| false),
        };
        match drive {
            DriveEffect::Determined { rate, .. } => Some(rate),
            DriveEffect::None | DriveEffect::Undetermined { .. } => None,
        }
    }

    /// Joint that moves the point most, relative to the motion of all joints. Candidates have one position, are not
    /// set, are not mimics, and can drive their loops together with the set joints. `is_set`: true for joints set at
    /// the pose.
    ///
    /// The criterion is the largest |ds/dq| / Σ u², with u as in [`rate`](Self::rate), and translations relative to
    /// the mechanism's size. Of joints that move together, this selects the joint that turns furthest over the
    /// travel, not a joint that hardly turns and stops before the others. If the rates are not determined, or all
    /// zero (a change point, the end of a travel), a small step is used instead. A joint near its dead centre, with
    /// large velocities of all other joints, drives only if no other joint does.
    ///
    /// # Errors
    /// [`TravelError::NothingMoves`].
    pub fn driver(&self, pose: &Pose, is_set: &dyn Fn(JointId) -> bool) -> Result<JointId, TravelError> {
        let mechanism = pose.mechanism();
        let (mut known, mut resting) = (Vec::new(), Vec::new());
        for joint in mechanism.joint_ids().filter(|id| is_driver(mechanism, *id) && !is_set(*id)) {
            match self.joint_effect(pose, joint, is_set) {
                DriveEffect::None => {}
                DriveEffect::Undetermined { weak } => {
                    known.extend(self.effect_by_step(pose, joint, is_set, weak));
                }
                DriveEffect::Determined { rate, motion, weak } => {
                    known.push(Candidate { joint, rate, motion, weak });
                    resting.push((joint, weak));
                }
            }
        }
        let stepped = || {
            let stepped = |(joint, weak)| self.effect_by_step(pose, joint, is_set, weak);
            best(mechanism, resting.into_iter().filter_map(stepped))
        };
        best(mechanism, known)
            .or_else(stepped)
            .ok_or_else(|| TravelError::NothingMoves { link: mechanism.link(self.link).name().to_owned() })
    }

    /// Pose with the requested displacement of the point, followed from another pose along the branch. Newton's
    /// method on the driver, to 1e-12 of the mechanism's size, within the range of monotonic displacement. The other
    /// joints take their positions from `configuration`; its value for the driver is not read.
    ///
    /// # Errors
    /// [`TravelError`]: a displacement beyond the ends of that range (with the nearest displacement), a joint that
    /// cannot drive, loops that do not close.
    pub fn pose(
        &self,
        from: &Pose,
        configuration: &Configuration,
        driver: JointId,
        requested: f64,
    ) -> Result<Pose, TravelError> {
        let mechanism = from.mechanism();
        let name = mechanism.joints().get(driver.index()).map_or("", |joint| joint.name());
        if !is_driver(mechanism, driver) {
            return Err(TravelError::NoDriver { joint: name.to_owned() });
        }
        if !requested.is_finite() {
            return Err(TravelError::NotFinite { what: "displacement", value: requested });
        }
        if !Arc::ptr_eq(configuration.mechanism(), mechanism) {
            let [got, expected] = [configuration.mechanism(), mechanism].map(|m| m.name().to_owned());
            return Err(AssemblyError::ForeignConfiguration { got, expected }.into());
        }
        let mut configuration = configuration.clone().without_guesses();
        configuration.given[driver.index()] = true;
        // The start pose may belong to another configuration, with other drivers: its rates hold other joints.
        let is_dependent =
            |joint: JointId| configuration.given[joint.index()] && !is_independent_at(from, joint);
        let has_other_drivers = mechanism.joint_ids().any(is_dependent);
        let mut visit = |from: &Pose, value: f64| {
            configuration.values[driver.index()] = vec![value];
            match from.assembly.pose_from(from, &configuration) {
                Ok(pose) => Ok(self.travel_point(pose, driver)),
                Err(error) if error.is_bad_input() => Err(VisitError::Fault(error)),
                Err(error) => Err(VisitError::NoPose { end: driver_limit(&error, name), error }),
            }
        };
        let scale = Scale { size: mechanism.characteristic_length(), unit: unit(mechanism, driver) };
        let mut start = self.travel_point(from.clone(), driver);
        if has_other_drivers || (requested - start.displacement).abs() <= DISPLACEMENT_ACCURACY * scale.size {
            start = visit(from, start.driver).map_err(|stop| match stop {
                VisitError::Fault(error) | VisitError::NoPose { error, .. } => error,
            })?;
        }
        let found = Search { scale, requested, visit: &mut visit }.run(start);
        found.map(|place| place.pose).map_err(|missed| match missed {
            SearchError::Unreachable { nearest } => TravelError::Unreachable { requested, nearest },
            SearchError::TooFar { reached } => TravelError::TooFar { requested, reached },
            SearchError::Assembly(error) => TravelError::Assembly(error),
        })
    }

    /// Displacement and rate at a pose.
    fn travel_point(&self, pose: Pose, driver: JointId) -> TravelPoint<Pose> {
        let (gone, rate) = (self.displacement(&pose), self.rate(&pose, driver));
        TravelPoint { driver: pose.joint(driver)[0], displacement: gone, rate, pose }
    }

    /// Effect of a joint on the point, if the joint is set in addition to other joints.
    fn joint_effect(&self, pose: &Pose, joint: JointId, is_set: &dyn Fn(JointId) -> bool) -> DriveEffect {
        let Some(number) = group_of(pose, joint) else {
            let model = pose.assembly.pose_model();
            let mut u = vec![0.0; model.coordinates.len()];
            return match coordinate(model, joint) {
                None => DriveEffect::None,
                Some(c) => {
                    u[c] = 1.0;
                    DriveEffect::Determined {
                        rate: self.speed(pose, &u),
                        motion: motion(pose, &u),
                        weak: false,
                    }
                }
            };
        };
        let (model, facts) = (pose.assembly.pose_model(), pose.assembly.group_facts(number));
        let group = &model.groups[number];
        let given = |at: usize| group.joints[at].is_some_and(|id| id == joint || is_set(id));
        match facts.choose_drivers(model, group, || pose.kinematics.clone(), given) {
            Ok(divided) => {
                self.effect_through_loops(pose, joint, number, &divided.dependent, divided.conditioning)
            }
            Err(_) => DriveEffect::None,
        }
    }

    /// Effect of a joint on the point through its group of loops: u_d = −K⁻¹ a. K are the columns of A of the
    /// dependent coordinates, a is the column of the joint. `conditioning`: ratio of the smallest to the largest
    /// pivot of K at the generic pose.
    fn effect_through_loops(
        &self,
        pose: &Pose,
        joint: JointId,
        number: usize,
        dependent: &[usize],
        conditioning: f64,
    ) -> DriveEffect {
        let (model, floor) = (pose.assembly.pose_model(), pose.assembly.group_facts(number).floor);
        let group = &model.groups[number];
        let Some(at) = coordinate(model, joint).and_then(|c| group.column(c)) else {
            return DriveEffect::None;
        };
        let mut rows = GroupRows::default();
        rows.fill(model, group, &pose.kinematics);
        let directions = Directions::of(dependent);
        let jacobian = directions.jacobian(group, &rows);
        let pivots = jacobian.pivot_ratio();
        let singularity = pose.loops.as_ref().map(|loops| loops.singularities[number]);
        let weak = pivots < WEAK_DRIVER * conditioning && singularity != Some(Singularity::ChangePoint);
        if pivots <= floor {
            return DriveEffect::Undetermined { weak };
        }
        let mut target = vec![0.0; group.rows];
        rows.for_each(group, |row, column, value| {
            if column == at {
                target[row] -= value;
            }
        });
        let follow = jacobian.shortest(&target, floor);
        let mut u = vec![0.0; model.coordinates.len()];
        for (c, rate) in group.coordinates.iter().zip(directions.expand(group, |k| follow[k])) {
            u[*c] = rate;
        }
        u[group.coordinates[at]] = 1.0;
        DriveEffect::Determined { rate: self.speed(pose, &u), motion: motion(pose, &u), weak }
    }

    /// ds/dt at given rates of the coordinates, m/s.
    fn speed(&self, pose: &Pose, u: &[f64]) -> f64 {
        match &self.measure {
            Measure::Along { direction, .. } => {
                let along = pose.base.inverse_vector(direction);
                speed_along(pose.assembly.pose_model(), pose, (self.link, &self.point), &along, u)
            }
            Measure::TowardStop { gap, .. } => gap.closing_speed(pose, u),
            Measure::OfJoint { joint, scale, .. } => {
                let rate = velocity_coordinate(pose.assembly.pose_model(), *joint);
                rate.map_or(0.0, |follows| scale * follows.multiplier * u[follows.index])
            }
        }
    }

    /// Effect of a joint on the point from a small step, with all other drivers fixed; `None` if no pose is found.
    fn effect_by_step(
        &self,
        pose: &Pose,
        joint: JointId,
        is_set: &dyn Fn(JointId) -> bool,
        weak: bool,
    ) -> Option<Candidate> {
        let mechanism = pose.mechanism();
        let mut configuration = Configuration::zero(mechanism);
        configuration.base = pose.base;
        configuration.base_is_given = pose.base_is_given;
        for id in mechanism.joint_ids() {
            configuration.values[id.index()] = pose.joint(id).to_vec();
            configuration.given[id.index()] = is_set(id) || id == joint;
        }
        let step = FIRST_STEP * unit(mechanism, joint);
        [step, -step].into_iter().find_map(|step| {
            configuration.values[joint.index()] = vec![pose.joint(joint)[0] + step];
            let moved = pose.assembly.pose_from(pose, &configuration).ok()?;
            let single = mechanism.joint_ids().filter(|id| mechanism.joint(*id).kind().positions() == 1);
            let turned = single.map(|id| {
                let change = (moved.joint(id)[0] - pose.joint(id)[0]) / step;
                (change / unit(mechanism, id)).powi(2)
            });
            let rate = (self.displacement(&moved) - self.displacement(pose)) / step;
            Some(Candidate { joint, rate, motion: turned.sum(), weak })
        })
    }
}

/// Size of a motion: Σ u², with rates of translations divided by the characteristic length of the mechanism.
fn motion(pose: &Pose, u: &[f64]) -> f64 {
    let size = pose.mechanism().characteristic_length();
    let coordinates = &pose.assembly.pose_model().coordinates;
    let scaled = coordinates.iter().zip(u).map(|(c, u)| if c.turns { *u } else { *u / size });
    scaled.map(|u| u * u).sum()
}

/// True if a joint has exactly one position and is not a mimic.
fn is_driver(mechanism: &Mechanism, joint: JointId) -> bool {
    let found = mechanism.joints().get(joint.index());
    found.is_some_and(|joint| joint.kind().positions() == 1 && joint.mimic().is_none())
}

/// Unit of a joint's steps: 1 rad, or the size of the mechanism.
fn unit(mechanism: &Mechanism, joint: JointId) -> f64 {
    if mechanism.joint(joint).kind().turns(0) { 1.0 } else { mechanism.characteristic_length() }
}

/// Group of loops that contains a joint.
fn group_of(pose: &Pose, joint: JointId) -> Option<usize> {
    pose.assembly.pose_model().groups.iter().position(|group| group.joints.contains(&Some(joint)))
}

/// True if a joint does not depend on other joints at a pose.
fn is_independent_at(pose: &Pose, joint: JointId) -> bool {
    let Some((number, loops)) = group_of(pose, joint).zip(pose.loops.as_ref()) else { return true };
    let group = &pose.assembly.pose_model().groups[number];
    loops.dependent[number].iter().all(|&at| group.joints[at] != Some(joint))
}

/// Coordinate of the first velocity of a joint.
fn coordinate(model: &Model, joint: JointId) -> Option<usize> {
    velocity_coordinate(model, joint).map(|follows| follows.index)
}

/// Coordinate and multiplier of the first velocity of a joint.
fn velocity_coordinate(model: &Model, joint: JointId) -> Option<VelocityCoordinate> {
    let body = &model.bodies[model.body_of_joint[joint.index()]?];
    model.velocity_coordinates[body.v.clone().next()?]
}

/// Candidate that moves the point most relative to all motion, and fast enough to drive the point.
fn best(mechanism: &Mechanism, candidates: impl IntoIterator<Item = Candidate>) -> Option<JointId> {
    let least = UNMOVED * mechanism.characteristic_length();
    let mut best: Option<(JointId, f64, bool)> = None;
    for Candidate { joint, rate, motion, weak } in candidates {
        let own = unit(mechanism, joint);
        let speed = (rate * own).abs();
        // Sum of all motion at unit motion of the joint itself: at least 1.
        let merit = speed / (motion * own * own).max(1.0);
        let is_better = best.is_none_or(|(_, most, other_is_weak)| match weak == other_is_weak {
            true => merit > most * (1.0 + SAME_RATE),
            false => other_is_weak,
        });
        if speed > least && is_better {
            best = Some((joint, merit, weak));
        }
    }
    best.map(|(joint, ..)| joint)
}

/// Position at which the driver reached its limit.
fn driver_limit(error: &AssemblyError, driver: &str) -> Option<f64> {
    let AssemblyError::Unreachable { nearest, .. } = error else { return None };
    nearest.iter().find(|(name, _)| name == driver).map(|(_, value)| *value)
}
