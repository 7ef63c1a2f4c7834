//! Local searches for an extreme from several starts.

use crate::mobility::delassus::Delassus;
use crate::motion::driver_rates::{DriverRate, RatesError, rates_from_drivers};
use crate::ranges::bearing_load::{best_normal, determinate_force};
use crate::ranges::extreme_question::{ExtremeKind, ExtremeMass, JointRange, NormalRange, SearchedQuantity};
use crate::ranges::extremes_error::{ExtremesError, no_driver};
use crate::ranges::kept_points::KeptRows;
use crate::ranges::quasi_newton::{AT_LIMIT, Point, identity, update};
use crate::ranges::reflected::{driving_velocities, reflected_inertia};
use crate::ranges::varied_contact::VariedContact;
use crate::reactions::bearing::Bearing;
use crate::reactions::reaction_map::ReactionMap;
use crate::tolerances::DIFFERENCE_STEP;
use nalgebra::{Matrix3xX, Vector3};
use percuss_dynamics::{Configuration, Contact, Direction, EffectiveMass, Frame, LowestPoint, Pose, System};
use percuss_mechanism::JointId;
use percuss_spatial::{Twist, plane_basis};
use std::cell::Cell;
use std::rc::Rc;

/// Largest work of the search for one extreme: number of joints of all poses and motions that are computed. Seconds; a search over twelve
/// joints needs a sixth of it.
pub(super) const SEARCH_WORK: usize = 25_000_000;
/// Largest number of steps of one search.
pub(super) const MOST_STEPS: usize = 200;
/// Projected gradient over the ranges, relative to the value, at which a search ends.
pub(super) const OPTIMAL: f64 = 1e-9;
/// 1/m̄ relative to its largest value at which a contact is immovable.
pub(super) const IMMOVABLE: f64 = 1e-12;
/// Reaction per impulse at the contact that is rounding of zero. The search locates a zero to the square root of the rounding, about
/// 1e-8, and the reaction at this distance is a small multiple of 1e-8.
const NO_REACTION: f64 = 1e-6;
/// Samples of each start. One search begins at a single point, the other at the best sample. Searches from single points alone missed
/// 8 % of the planted extremes; the best sample alone is often in the widest region, which need not contain the extreme.
const SAMPLES: usize = 8;

/// Search for an extreme: question and ranges.
#[derive(Clone)]
pub(super) struct Search<'a> {
    pub system: &'a System,
    pub configuration: &'a Configuration,
    pub contact: &'a Contact,
    pub wheel: Option<&'a LowestPoint>,
    pub quantity: SearchedQuantity,
    /// True if contacts are held.
    pub has_holds: bool,
    pub variables: Vec<Variable>,
    pub kept: KeptRows,
    pub normals: NormalRange,
    pub edges: &'a [Vector3<f64>],
    pub extreme: ExtremeKind,
    /// Work that is left: joints of the poses and of the motions that are still computed.
    pub work: Rc<Cell<usize>>,
}

/// Variable of a search, from 0 to 1: its joints move together, each linearly from `lower` to `upper`.
#[derive(Clone, Debug)]
pub(super) struct Variable {
    pub moves: Vec<JointRange>,
}

impl<'a> Search<'a> {
    /// Best end of the local searches of each start, the largest measure of all points, and the number of starts. With kept points the
    /// first start has a third search, from the configuration, if the configuration is within the ranges. The limit of work may end the
    /// last search early and leave out further starts.
    pub fn run_all(&self, starts: usize) -> Result<(Vec<Point>, f64, usize), ExtremesError> {
        let (mut found, mut largest): (Vec<Point>, f64) = (Vec::new(), 0.0);
        self.work.set(SEARCH_WORK);
        for start in 0..starts.max(1) {
            if self.is_stopped() {
                return Ok((found, largest, start));
            }
            let samples: Vec<(Vec<f64>, f64)> =
                (0..SAMPLES).filter_map(|k| self.sample(start * SAMPLES + k + 1)).collect();
            let scale = samples.iter().map(|(_, measure)| *measure).fold(0.0, f64::max);
            let best = samples.iter().min_by(|a, b| (self.sign() * a.1).total_cmp(&(self.sign() * b.1)));
            let mut ends: Vec<Point> = Vec::new();
            let own = self.own_point().filter(|_| start == 0 && !self.kept.is_empty());
            let begin = [Some(self.halton_point(start + 1)), best.map(|(unit, _)| unit.clone()), own];
            for unit in begin.into_iter().flatten() {
                if let Some((point, at_start)) = self.run(unit, scale, None)? {
                    largest = largest.max(scale).max(at_start).max(point.inverse_mass);
                    ends.push(point);
                }
            }
            found.extend(ends.into_iter().min_by(|a, b| a.value.total_cmp(&b.value)));
        }
        Ok((found, largest, starts.max(1)))
    }

    /// True if no work is left.
    pub fn is_stopped(&self) -> bool {
        self.work.get() == 0
    }

    /// Subtracts the work of a pose or a motion of the mechanism, as often as stated.
    fn count_work(&self, times: usize) {
        let joints = self.system.mechanism().joints().len();
        self.work.set(self.work.get().saturating_sub(times.saturating_mul(joints)));
    }

    /// Point of the Halton sequence, as parts of the ranges.
    fn halton_point(&self, index: usize) -> Vec<f64> {
        (0..self.variables.len()).map(|k| halton(index, PRIMES[k % PRIMES.len()])).collect()
    }

    /// Positions of the configuration as parts of the ranges; `None` if one is outside its range.
    fn own_point(&self) -> Option<Vec<f64>> {
        let pose = self.system.pose(self.configuration).ok()?;
        let part = |variable: &Variable| {
            let range = variable.moves.first()?;
            let part = (pose.joint(range.joint)[0] - range.lower) / (range.upper - range.lower);
            (-AT_LIMIT..=1.0 + AT_LIMIT).contains(&part).then_some(part.clamp(0.0, 1.0))
        };
        self.variables.iter().map(part).collect()
    }

    /// Point of the Halton sequence with its measure; `None` if the measure is not finite. With kept points the point is moved onto the
    /// self-motion.
    fn sample(&self, index: usize) -> Option<(Vec<f64>, f64)> {
        let unit = self.halton_point(index);
        let (unit, pose) = if self.kept.is_empty() {
            let pose = self.pose(&unit, None).ok()?;
            (unit, pose)
        } else {
            self.project(unit, None, &vec![false; self.variables.len()])?
        };
        let measure = self.measure(&pose)?;
        Some((unit, measure))
    }

    /// Sign of the measure in the function to be minimised.
    pub fn sign(&self) -> f64 {
        let increases = (self.extreme == ExtremeKind::Most) == self.is_reciprocal();
        if increases { 1.0 } else { -1.0 }
    }

    /// The same search for the effective mass of the contact.
    pub fn of_masses(&self) -> Search<'a> {
        Search { quantity: SearchedQuantity::EffectiveMass, work: Rc::default(), ..self.clone() }
    }

    /// Result for a bearing whose load grows without bound towards a pose with an immovable contact and R ≠ 0. `None` if no start finds
    /// such a pose.
    pub fn unbounded_load(
        &self,
        bearing: Bearing,
        starts: usize,
    ) -> Result<Option<ExtremeMass>, ExtremesError> {
        let masses = self.of_masses();
        let (found, largest, searched) = masses.run_all(starts)?;
        let largest = largest.max(masses.typical()?);
        let unbounded: Vec<&Point> =
            found.iter().filter(|point| self.is_unbounded(point, largest, bearing)).collect();
        Ok(unbounded.first().map(|point| ExtremeMass {
            effective_mass: EffectiveMass::Immovable,
            positions: self.positions(&point.unit),
            normal_world: point.normal_world,
            point_link: None,
            active_limits: self.active_limits(&point.unit),
            residual: 0.0,
            kept_error: self.kept_error(&point.unit),
            starts: searched,
            agreeing: unbounded.len(),
            is_stopped: masses.is_stopped(),
        }))
    }

    /// True if the load of a bearing grows without bound towards a point of a search for the mass: an immovable contact with a reaction.
    /// `largest`: the largest 1/m̄ of this search.
    pub fn is_unbounded(&self, point: &Point, largest: f64, bearing: Bearing) -> bool {
        point.inverse_mass <= IMMOVABLE * largest
            && self.of_masses().reaction(&point.unit, bearing).is_some_and(|r| r > NO_REACTION)
    }

    /// Magnitude of the determinate components of the reaction force in a bearing, per impulse at the contact; `None` if all are open.
    fn reaction(&self, unit: &[f64], bearing: Bearing) -> Option<f64> {
        let pose = self.pose(unit, None).ok()?;
        let response = pose.respond(&self.contact_at(&pose)?.0).ok()?;
        Some(determinate_force(&ReactionMap::new(&pose), &response, bearing, 1.0)?.norm())
    }

    /// True if the bearing transmits no force beyond rounding.
    pub fn transmits_nothing(&self, unit: &[f64], bearing: Bearing) -> bool {
        self.reaction(unit, bearing).is_some_and(|reaction| reaction <= NO_REACTION)
    }

    /// Joints at a limit of their range, true for the upper one. A variable that moves several joints has no limits.
    pub fn active_limits(&self, unit: &[f64]) -> Vec<(JointId, bool)> {
        let at_limit = |(variable, x): (&Variable, &f64)| match (&variable.moves[..], *x) {
            ([range], x) if x <= AT_LIMIT => Some((range.joint, false)),
            ([range], x) if x >= 1.0 - AT_LIMIT => Some((range.joint, true)),
            _ => None,
        };
        self.variables.iter().zip(unit).filter_map(at_limit).collect()
    }

    /// Largest error of a coordinate of a kept point, m.
    pub fn kept_error(&self, unit: &[f64]) -> f64 {
        self.pose(unit, None).map_or(0.0, |pose| self.kept.largest_error(&pose))
    }

    /// True if the search uses the reciprocal of the quantity, which is smooth where a mass or an inertia is infinite.
    pub fn is_reciprocal(&self) -> bool {
        self.quantity.bearing_load().is_none()
    }

    /// Reciprocal of a mass or an inertia, or square of the load of a bearing, at a pose; `None` if this value is not finite. The square is
    /// smooth at a pose where the load is zero.
    pub fn measure(&self, pose: &Pose) -> Option<f64> {
        match self.quantity {
            SearchedQuantity::EffectiveMass => {
                reciprocal(pose.respond(&self.contact_at(pose)?.0).ok()?.effective_mass)
            }
            SearchedQuantity::ReflectedInertia { joint, held } => {
                let found = reflected_inertia(pose, joint, 0).ok()?;
                reciprocal(if held { found.held? } else { found.free })
            }
            SearchedQuantity::BearingImpulse { .. } | SearchedQuantity::BearingPeakForce { .. } => {
                let (bearing, law) = self.quantity.bearing_load()?;
                let response = pose.respond(&self.contact_at(pose)?.0).ok()?;
                let load = law.force * response.effective_mass.kilograms()?.powf(law.power);
                let force = determinate_force(&ReactionMap::new(pose), &response, bearing, load)?;
                Some(force.norm_squared())
            }
        }
    }

    /// Value and gradient by difference quotients of fourth order. `None` if a pose is not reachable or has no finite value.
    fn point_by_differences(&self, unit: Vec<f64>, from: Option<&Pose>) -> Option<(Point, Pose)> {
        let pose = self.pose(&unit, from).ok()?;
        let inverse_mass = self.measure(&pose)?;
        let sign = self.sign();
        let at = |k: usize, step: f64| {
            let mut moved = unit.clone();
            moved[k] += step;
            self.measure(&self.pose(&moved, Some(&pose)).ok()?)
        };
        let h = DIFFERENCE_STEP;
        let slope = |k: usize| {
            Some((8.0 * (at(k, h)? - at(k, -h)?) - (at(k, 2.0 * h)? - at(k, -2.0 * h)?)) / (12.0 * h))
        };
        let slopes = (0..unit.len()).map(slope).collect::<Option<Vec<f64>>>()?;
        let normal_world = match self.normals {
            NormalRange::Given => None,
            _ => self.contact_at(&pose)?.1,
        };
        Some((Point::new(unit, inverse_mass, sign, &slopes, normal_world), pose))
    }

    /// Positions of the moved joints, in the order of the variables.
    pub fn positions(&self, unit: &[f64]) -> Vec<f64> {
        let position = |range: &JointRange, x: f64| range.lower + x * (range.upper - range.lower);
        let of_variable = |(variable, x): (&'_ Variable, &f64)| -> Vec<f64> {
            variable.moves.iter().map(|range| position(range, *x)).collect()
        };
        self.variables.iter().zip(unit).flat_map(of_variable).collect()
    }

    pub fn pose(&self, unit: &[f64], from: Option<&Pose>) -> Result<Pose, ExtremesError> {
        self.count_work(1);
        let mut wanted = self.configuration.clone();
        let moves = self.variables.iter().flat_map(|variable| &variable.moves);
        for (range, position) in moves.zip(self.positions(unit)) {
            wanted.replace(self.system.mechanism().joint(range.joint).name(), &[position])?;
        }
        Ok(match from {
            None => self.system.pose(&wanted)?,
            Some(from) => self.system.pose_from(from, &wanted)?,
        })
    }

    /// Contact with the extreme normal at a pose, and this normal in world axes (`None` for the normal of the contact). No result if a
    /// massless motion moves the point.
    fn contact_at(&self, pose: &Pose) -> Option<(Contact, Option<Vector3<f64>>)> {
        let base = pose.base();
        let contact = self.wheel.map_or(*self.contact, |wheel| wheel.contact_at(pose, self.contact));
        let varied = |cone| {
            let varied = VariedContact { cone, edges: self.edges };
            let (contact, normal) = varied.extreme(pose, &contact, self.extreme)?;
            Some((contact, Some(normal).filter(|_| cone > 0.0)))
        };
        let directions = match self.normals {
            NormalRange::Given if self.edges.is_empty() => return Some((contact, None)),
            NormalRange::Given => return varied(0.0),
            NormalRange::Cone(angle) => return varied(angle),
            NormalRange::Any => Matrix3xX::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z()]),
            NormalRange::Across(axis) => {
                let (e1, e2) = plane_basis(&base.inverse_vector(&axis.normalize()));
                Matrix3xX::from_columns(&[e1, e2])
            }
        };
        let mobility = Delassus::new(pose, &[pose.locate(&contact).ok()?]).ok()?;
        let axes = mobility.axes(0);
        let block = directions.transpose() * (axes * mobility.block(0) * axes.transpose()) * &directions;
        let normal = match self.quantity.bearing_load() {
            Some(load) => best_normal(pose, &contact, &directions, &block, load, self.extreme)?,
            None => {
                let eigen = block.symmetric_eigen();
                let best = match self.extreme {
                    ExtremeKind::Least => eigen.eigenvalues.imax(),
                    ExtremeKind::Most => eigen.eigenvalues.imin(),
                };
                &directions * eigen.eigenvectors.column(best)
            }
        };
        let normal: Vector3<f64> = base.vector(&normal);
        let normal = normal * normal[normal.iamax()].signum();
        let direction = match contact.normal.is_moment() {
            true => Direction::About(normal, Frame::World),
            false => Direction::Along(normal, Frame::World),
        };
        Some((Contact { normal: direction, ..contact }, Some(normal)))
    }

    /// Contact point at the extreme, in the frame of the contact link; `None` without edges.
    pub fn point_link(&self, unit: &[f64]) -> Option<Vector3<f64>> {
        let pose = self.pose(unit, None).ok().filter(|_| !self.edges.is_empty())?;
        Some(self.contact_at(&pose)?.0.point)
    }

    /// Measure at the middle of the ranges (with kept points at the configuration), a scale for the thresholds; 0 if it is not finite.
    pub fn typical(&self) -> Result<f64, ExtremesError> {
        let pose = match self.kept.is_empty() {
            true => self.pose(&vec![0.5; self.variables.len()], None)?,
            false => self.system.pose(self.configuration)?,
        };
        if self.quantity != SearchedQuantity::EffectiveMass {
            return Ok(self.measure(&pose).unwrap_or(0.0));
        }
        let Some((contact, _)) = self.contact_at(&pose) else { return Ok(0.0) };
        let response = pose.respond(&contact)?;
        Ok(response.effective_mass.kilograms().map_or(0.0, |mass| 1.0 / mass))
    }

    /// Value and gradient. `None` if the pose is not reachable, or the contact is massless.
    pub fn point(&self, unit: Vec<f64>, from: Option<&Pose>) -> Result<Option<(Point, Pose)>, ExtremesError> {
        if self.has_holds || self.quantity != SearchedQuantity::EffectiveMass {
            return Ok(self.point_by_differences(unit, from));
        }
        let Ok(pose) = self.pose(&unit, from) else { return Ok(None) };
        let sign = self.sign();
        let Some((contact, normal_world)) = self.contact_at(&pose) else { return Ok(None) };
        let Some(gradient) = pose.effective_mass_gradient(&contact)? else {
            return Ok(match pose.respond(&contact)?.effective_mass {
                EffectiveMass::Immovable => {
                    let slopes = vec![0.0; unit.len()];
                    Some((Point::new(unit, 0.0, sign, &slopes, normal_world), pose))
                }
                _ => None,
            });
        };
        let inverse_mass = 1.0 / gradient.effective_mass;
        self.count_work(self.variables.len());
        let drivers = driving_velocities(&pose);
        let mut slopes = Vec::with_capacity(unit.len());
        for variable in &self.variables {
            if let Some(range) = variable.moves.iter().find(|range| !drivers.contains(&(range.joint, 0))) {
                return Err(no_driver(Some(&pose), self.system, range.joint));
            }
            let mut rates: Vec<DriverRate> = Vec::new();
            for &(joint, k) in &drivers {
                let moved = variable.moves.iter().find(|range| range.joint == joint);
                let rate = moved.map_or(0.0, |range| range.upper - range.lower);
                match rates.last_mut() {
                    Some(last) if last.joint == joint => last.rates.push(0.0),
                    _ if k == 0 => rates.push(DriverRate { joint, rates: vec![rate] }),
                    _ => {}
                }
            }
            let motion = match rates_from_drivers(&pose, &rates, Twist::zero()) {
                Ok(motion) => motion,
                // Dead centre: an end of the reachable range of the joint.
                Err(RatesError::Inadmissible { .. }) => return Ok(None),
                Err(error) => return Err(error.into()),
            };
            let mut slope = gradient.rate(&motion.joints);
            if let Some(wheel) = self.wheel {
                slope += wheel.mass_rate(&pose, &contact, &motion.coordinates(&pose))?;
            }
            slopes.push(-slope * inverse_mass * inverse_mass);
        }
        Ok(Some((Point::new(unit, inverse_mass, sign, &slopes, normal_world), pose)))
    }

    /// Local search from one point: its end, and `inverse_mass` at its beginning; `None` if the value is not finite at the beginning.
    /// `scale`: a typical `inverse_mass`; `from`: a pose near the beginning.
    pub fn run(
        &self,
        unit: Vec<f64>,
        scale: f64,
        from: Option<&Pose>,
    ) -> Result<Option<(Point, f64)>, ExtremesError> {
        if !self.kept.is_empty() {
            return self.run_on_self_motion(unit, scale);
        }
        let n = unit.len();
        let Some((mut at, mut pose)) = self.point(unit, from)? else { return Ok(None) };
        let at_start = at.inverse_mass;
        let scale = scale.max(at_start);
        let mut inverse_hessian = identity(n);
        // Before the first update of the Hessian the step is a quarter of the range: the gradient alone determines no length.
        let mut has_curvature = false;
        for _ in 0..MOST_STEPS {
            if at.residual <= OPTIMAL * at.inverse_mass
                || at.inverse_mass <= IMMOVABLE * scale
                || self.is_stopped()
            {
                break;
            }
            let is_free: Vec<bool> = (0..n)
                .map(|k| {
                    let lower = at.unit[k] <= AT_LIMIT && at.gradient[k] > 0.0;
                    let upper = at.unit[k] >= 1.0 - AT_LIMIT && at.gradient[k] < 0.0;
                    !(lower || upper)
                })
                .collect();
            let direction = |inverse: &[Vec<f64>]| -> Vec<f64> {
                let row = |r: usize| -> f64 {
                    (0..n).filter(|&c| is_free[c]).map(|c| -inverse[r][c] * at.gradient[c]).sum()
                };
                (0..n).map(|r| if is_free[r] { row(r) } else { 0.0 }).collect()
            };
            let mut step = direction(&inverse_hessian);
            let slope = |step: &[f64]| step.iter().zip(&at.gradient).map(|(s, g)| s * g).sum::<f64>();
            if slope(&step) >= 0.0 {
                inverse_hessian = identity(n);
                has_curvature = false;
                step = direction(&inverse_hessian);
            }
            let largest = step.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
            let mut length = if has_curvature { (0.25 / largest).min(1.0) } else { 0.25 / largest };
            let mut next = None;
            for _ in 0..50 {
                let moved: Vec<f64> =
                    at.unit.iter().zip(&step).map(|(x, s)| (x + length * s).clamp(0.0, 1.0)).collect();
                let gain: f64 =
                    moved.iter().zip(&at.unit).zip(&at.gradient).map(|((b, a), g)| (b - a) * g).sum();
                if let Some((point, pose)) = self.point(moved, Some(&pose))?
                    && (point.value <= at.value + 1e-4 * gain || at.is_equal_but_worse_than(&point))
                {
                    next = Some((point, pose));
                    break;
                }
                if self.is_stopped() {
                    break;
                }
                length *= 0.5;
            }
            let Some((point, new_pose)) = next else { break };
            has_curvature |= update(&mut inverse_hessian, &at, &point, !has_curvature);
            let stays = point.unit == at.unit;
            (at, pose) = (point, new_pose);
            if stays {
                break;
            }
        }
        Ok(Some((at, at_start)))
    }
}

/// Reciprocal of a mass or an inertia; `None` for a massless motion.
fn reciprocal(mass: EffectiveMass) -> Option<f64> {
    match mass {
        EffectiveMass::Finite(mass) => Some(1.0 / mass),
        EffectiveMass::Immovable => Some(0.0),
        EffectiveMass::Massless => None,
    }
}

const PRIMES: [usize; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];

/// Element of the Halton sequence.
fn halton(mut index: usize, base: usize) -> f64 {
    let (mut value, mut part) = (0.0, 1.0);
    while index > 0 {
        part /= base as f64;
        value += part * (index % base) as f64;
        index /= base;
    }
    value
}
