//! Extreme effective masses over ranges of joint positions.

use crate::mobility::delassus::Delassus;
use crate::motion::driver_rates::{DriverRate, rates_from_drivers};
use crate::ranges::extremes_error::ExtremesError;
use crate::ranges::reflected::{driving_velocities, reflected_inertia};
use crate::reactions::reaction_map::ReactionMap;
use crate::tolerances::DIFFERENCE_STEP;
use nalgebra::{Matrix3xX, Vector3};
use percuss_dynamics::{
    Configuration, Contact, ContactResponse, Direction, EffectiveMass, Frame, LowestPoint, Pose, System,
};
use percuss_mechanism::JointId;
use percuss_spatial::{Twist, plane_basis};

/// Largest number of steps of one search.
const MOST_STEPS: usize = 200;
/// Projected gradient over the ranges, relative to the value, at which a search ends.
const OPTIMAL: f64 = 1e-9;
/// Relative difference of values up to which two searches agree.
const SAME_VALUE: f64 = 1e-6;
/// 1/m̄ relative to its largest value at which a contact is immovable.
const IMMOVABLE: f64 = 1e-12;
/// Relative difference of values that is rounding.
const SAME_TO_ROUNDING: f64 = 1e-13;
/// Reaction per impulse at the contact that is rounding of zero: the search finds the position of a zero to the square root of the
/// rounding, about 1e-8, and the reaction changes by a small multiple of it there.
const NO_REACTION: f64 = 1e-6;
/// Distance from a limit, relative to the range, at which the limit is active.
const AT_LIMIT: f64 = 1e-9;

/// Range of a driving joint with one velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointRange {
    /// The joint.
    pub joint: JointId,
    /// Lower end, rad or m.
    pub lower: f64,
    /// Upper end, rad or m.
    pub upper: f64,
}

/// Extreme to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExtremeKind {
    /// Smallest value.
    Least,
    /// Largest value. A mass or an inertia is `Immovable` if at some pose no motion closes the gap or moves the joint. A bearing
    /// impulse is `Immovable` if it grows without bound towards a pose with an immovable contact.
    Most,
}

/// Normals of the contact among which the extreme is searched.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum NormalRange {
    /// The normal of the contact.
    #[default]
    Given,
    /// All normals.
    Any,
    /// All normals across an axis (world axes).
    Across(Vector3<f64>),
}

/// Quantity whose extremes are searched.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum SearchedQuantity {
    /// Effective mass of the contact, kg.
    #[default]
    EffectiveMass,
    /// Inertia reflected to a joint with one velocity, kg·m² or kg. With `held` the other drivers are at rest; otherwise they are free.
    ReflectedInertia {
        /// The joint.
        joint: JointId,
        /// True if the other drivers are at rest.
        held: bool,
    },
    /// Impulse in a bearing per closing speed of a plastic impact at the contact (e = 0): m̄ |R|, kg. R has the determinate components of
    /// the reaction force in the joint per impulse at the contact, without its moment. An impact with the closing speed c and the
    /// coefficient of restitution e has (1+e) c times this impulse; a contact of stiffness k has about the peak force m̄ |R| c √(k/m̄).
    BearingImpulse {
        /// The joint.
        joint: JointId,
    },
}

/// Contact of a search for extremes.
#[derive(Clone, Copy, Debug)]
pub struct SearchedContact<'a> {
    /// The contact.
    pub contact: &'a Contact,
    /// Wheel of a contact patch; the contact point is then its lowest point at every pose.
    pub wheel: Option<&'a LowestPoint>,
    /// Range of the normals.
    pub normals: NormalRange,
}

impl<'a> From<&'a Contact> for SearchedContact<'a> {
    fn from(contact: &'a Contact) -> Self {
        Self { contact, wheel: None, normals: NormalRange::Given }
    }
}

/// Extreme of an effective mass, or of another quantity, over ranges of positions.
#[derive(Clone, Debug, PartialEq)]
pub struct ExtremeMass {
    /// Value of the quantity at the extreme, kg or kg·m²; `Immovable` is a valid largest value of a mass or an inertia. The largest
    /// impulse of a bearing is `Immovable` if it has no bound; the positions are those that it grows towards.
    pub effective_mass: EffectiveMass,
    /// Positions of the varied joints, in the order of the ranges.
    pub positions: Vec<f64>,
    /// Normal at the extreme, world axes, up to its sign; `None` for the normal of the contact.
    pub normal_world: Option<Vector3<f64>>,
    /// Joints at a limit, true for the upper one.
    pub active_limits: Vec<(JointId, bool)>,
    /// Optimality: largest component of the projected gradient, times its range, relative to the value; 0 at an exact stationary point
    /// of the constrained problem. The value is 1/m̄ or the reciprocal inertia; for a bearing, the squared impulse. Zero for an immovable
    /// contact. If the squared impulse is rounding of zero, the residual is relative to the largest squared impulse of the search.
    pub residual: f64,
    /// Number of starts.
    pub starts: usize,
    /// Number of starts that reached this value to six digits.
    pub agreeing: usize,
}

/// Largest or smallest effective mass of a contact over ranges of driving joints: local searches from several starts.
///
/// With a range of normals the extreme is that over positions and normals. At each position the extreme normal is an eigenvector of
/// the mobility of the contact point; the mass does not change to first order with the normal there, so that the gradient over
/// the positions is that of this normal.
///
/// 1/m̄ is minimised or maximised, since it is smooth where the contact is immovable, by a projected quasi-Newton method with the
/// gradient in closed form. The starts are the points of a Halton sequence; the same call has the same result. No method of this kind
/// proves a global extreme: the number of agreeing starts shows the confidence.
///
/// # Errors
/// [`ExtremesError`].
pub fn extreme_effective_mass(
    system: &System,
    configuration: &Configuration,
    contact: SearchedContact,
    ranges: &[JointRange],
    extreme: ExtremeKind,
    starts: usize,
) -> Result<ExtremeMass, ExtremesError> {
    let quantity = SearchedQuantity::EffectiveMass;
    extreme_quantity(system, configuration, contact, quantity, ranges, extreme, starts)
}

/// Extreme of a quantity over ranges of driving joints, by the searches of [`extreme_effective_mass`].
///
/// The gradient of an effective mass has a closed form. That of the other quantities is a difference quotient of fourth order, with a
/// relative error of about 1e-12. A reflected inertia does not depend on the contact. A range of normals applies to effective masses
/// only.
///
/// # Errors
/// [`ExtremesError`].
pub fn extreme_quantity(
    system: &System,
    configuration: &Configuration,
    contact: SearchedContact,
    quantity: SearchedQuantity,
    ranges: &[JointRange],
    extreme: ExtremeKind,
    starts: usize,
) -> Result<ExtremeMass, ExtremesError> {
    let of_mass = quantity == SearchedQuantity::EffectiveMass;
    if !of_mass && contact.normals != NormalRange::Given {
        return Err(ExtremesError::NormalsOfMass);
    }
    if let SearchedQuantity::ReflectedInertia { joint, .. } = quantity
        && system.mechanism().joint(joint).kind().dofs() != 1
    {
        return Err(ExtremesError::NoDriver { joint: system.mechanism().joint(joint).name().to_owned() });
    }
    if ranges.is_empty() {
        return Err(ExtremesError::NoJoint);
    }
    let mechanism = system.mechanism();
    for range in ranges {
        let joint = mechanism.joint(range.joint);
        let name = || joint.name().to_owned();
        let (lower, upper) = (range.lower, range.upper);
        if !(lower.is_finite() && upper.is_finite() && lower < upper) {
            return Err(ExtremesError::Range { joint: name(), lower, upper });
        }
        if joint.kind().dofs() != 1 {
            return Err(ExtremesError::NoDriver { joint: name() });
        }
    }
    let SearchedContact { contact, wheel, normals } = contact;
    if let NormalRange::Across(axis) = normals
        && !(axis.norm().is_finite() && axis.norm() > 0.0)
    {
        return Err(ExtremesError::NoAxis);
    }
    let search = Search { system, configuration, contact, wheel, quantity, ranges, normals, extreme };
    if let SearchedQuantity::BearingImpulse { joint } = quantity
        && extreme == ExtremeKind::Most
        && let Some(unbounded) = search.unbounded_impulse(joint, starts)?
    {
        return Ok(unbounded);
    }
    let (found, largest) = search.run_all(starts)?;
    let best = found.iter().min_by(|a, b| a.value.total_cmp(&b.value)).ok_or(ExtremesError::NoStart)?.clone();
    let largest = largest.max(search.typical()?);
    let is_immovable =
        search.is_reciprocal() && extreme == ExtremeKind::Most && best.inverse_mass <= IMMOVABLE * largest;
    // A squared impulse that is rounding of zero has no relative accuracy: the residual is then relative to the largest one.
    let vanishes = !search.is_reciprocal() && best.inverse_mass <= IMMOVABLE * largest;
    let size = best.inverse_mass.max(IMMOVABLE * largest);
    let close =
        if search.is_reciprocal() { SAME_VALUE * size } else { (SAME_VALUE * size).max(IMMOVABLE * largest) };
    let same = |point: &&Point| (point.inverse_mass - best.inverse_mass).abs() <= close;
    let is_zero = match quantity {
        SearchedQuantity::BearingImpulse { joint } => search.transmits_nothing(&best.unit, joint),
        _ => false,
    };
    Ok(ExtremeMass {
        effective_mass: if is_immovable {
            EffectiveMass::Immovable
        } else if is_zero {
            EffectiveMass::Finite(0.0)
        } else {
            let value = best.inverse_mass;
            EffectiveMass::Finite(if search.is_reciprocal() { 1.0 / value } else { value.sqrt() })
        },
        positions: search.positions(&best.unit),
        normal_world: best.normal_world,
        active_limits: search.active_limits(&best.unit),
        residual: if is_immovable { 0.0 } else { best.residual() / if vanishes { largest } else { size } },
        starts: starts.max(1),
        agreeing: found.iter().filter(same).count(),
    })
}

/// Square of the determinate part of the reaction force in a joint; `None` if all components are open.
fn squared_force(pose: &Pose, response: &ContactResponse, joint: JointId, impulse: f64) -> Option<f64> {
    let reactions = ReactionMap::new(pose).reactions(response, impulse).ok()?;
    let force = reactions.joints[joint.index()].reaction.force;
    let known: Vec<f64> = force.iter().filter_map(|component| component.value()).collect();
    (!known.is_empty()).then(|| known.iter().map(|x| x * x).sum())
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

/// Point of a search.
#[derive(Clone, Debug)]
struct Point {
    /// Positions as parts of their ranges.
    unit: Vec<f64>,
    /// 1/m̄, 1/kg; for an inertia its reciprocal; for a bearing the square of the impulse per closing speed, kg².
    inverse_mass: f64,
    /// Function to be minimised: plus or minus `inverse_mass`.
    value: f64,
    /// Its gradient over the ranges.
    gradient: Vec<f64>,
    /// Normal, world axes; `None` for that of the contact.
    normal_world: Option<Vector3<f64>>,
}

impl Point {
    /// Largest component of the projected gradient.
    fn residual(&self) -> f64 {
        let component = |k: usize| {
            let blocked = (self.unit[k] <= AT_LIMIT && self.gradient[k] > 0.0)
                || (self.unit[k] >= 1.0 - AT_LIMIT && self.gradient[k] < 0.0);
            if blocked { 0.0 } else { self.gradient[k].abs() }
        };
        (0..self.unit.len()).map(component).fold(0.0, f64::max)
    }
}

impl Point {
    /// True if another point has the same value to rounding and a smaller residual: values resolve positions to the square root
    /// of rounding only.
    fn is_equal_but_worse_than(&self, other: &Self) -> bool {
        (other.value - self.value).abs() <= SAME_TO_ROUNDING * self.value.abs()
            && other.residual() < self.residual()
    }
}

struct Search<'a> {
    system: &'a System,
    configuration: &'a Configuration,
    contact: &'a Contact,
    wheel: Option<&'a LowestPoint>,
    quantity: SearchedQuantity,
    ranges: &'a [JointRange],
    normals: NormalRange,
    extreme: ExtremeKind,
}

impl<'a> Search<'a> {
    /// Ends of the local searches from all starts, and the largest measure that occurs.
    fn run_all(&self, starts: usize) -> Result<(Vec<Point>, f64), ExtremesError> {
        let (mut found, mut largest): (Vec<Point>, f64) = (Vec::new(), 0.0);
        for start in 0..starts.max(1) {
            let unit = (0..self.ranges.len()).map(|k| halton(start + 1, PRIMES[k % PRIMES.len()])).collect();
            if let Some((point, at_start)) = self.run(unit)? {
                largest = largest.max(at_start).max(point.inverse_mass);
                found.push(point);
            }
        }
        Ok((found, largest))
    }

    /// Result of a bearing impulse without bound: m̄ |R| grows without bound towards a pose with an immovable contact and R ≠ 0.
    /// `None` if no start finds such a pose.
    fn unbounded_impulse(&self, joint: JointId, starts: usize) -> Result<Option<ExtremeMass>, ExtremesError> {
        let masses: Search<'a> = Search { quantity: SearchedQuantity::EffectiveMass, ..*self };
        let (found, largest) = masses.run_all(starts)?;
        let largest = largest.max(masses.typical()?);
        let is_unbounded = |point: &&Point| {
            point.inverse_mass <= IMMOVABLE * largest
                && self.reaction(&point.unit, joint).is_some_and(|r| r > NO_REACTION)
        };
        let unbounded: Vec<&Point> = found.iter().filter(is_unbounded).collect();
        Ok(unbounded.first().map(|point| ExtremeMass {
            effective_mass: EffectiveMass::Immovable,
            positions: self.positions(&point.unit),
            normal_world: None,
            active_limits: self.active_limits(&point.unit),
            residual: 0.0,
            starts: starts.max(1),
            agreeing: unbounded.len(),
        }))
    }

    /// Reaction force in a joint per impulse at the contact, its determinate components; `None` if all are open.
    fn reaction(&self, unit: &[f64], joint: JointId) -> Option<f64> {
        let pose = self.pose(unit, None).ok()?;
        let response = pose.respond(&self.contact_at(&pose)?.0).ok()?;
        Some(squared_force(&pose, &response, joint, 1.0)?.sqrt())
    }

    /// True if the joint transmits no force beyond rounding.
    fn transmits_nothing(&self, unit: &[f64], joint: JointId) -> bool {
        self.reaction(unit, joint).is_some_and(|reaction| reaction <= NO_REACTION)
    }

    /// Joints at a limit, true for the upper one.
    fn active_limits(&self, unit: &[f64]) -> Vec<(JointId, bool)> {
        let at_limit = |(range, x): (&JointRange, &f64)| match *x {
            x if x <= AT_LIMIT => Some((range.joint, false)),
            x if x >= 1.0 - AT_LIMIT => Some((range.joint, true)),
            _ => None,
        };
        self.ranges.iter().zip(unit).filter_map(at_limit).collect()
    }

    /// True if the search uses the reciprocal of the quantity, which is smooth where a mass or an inertia is infinite.
    fn is_reciprocal(&self) -> bool {
        !matches!(self.quantity, SearchedQuantity::BearingImpulse { .. })
    }

    /// Reciprocal of a mass or an inertia, or square of a bearing impulse, at a pose; `None` if it is not finite. The square is smooth
    /// where the impulse vanishes.
    fn measure(&self, pose: &Pose) -> Option<f64> {
        match self.quantity {
            SearchedQuantity::EffectiveMass => {
                reciprocal(pose.respond(&self.contact_at(pose)?.0).ok()?.effective_mass)
            }
            SearchedQuantity::ReflectedInertia { joint, held } => {
                let found = reflected_inertia(pose, joint, 0).ok()?;
                reciprocal(if held { found.held? } else { found.free })
            }
            SearchedQuantity::BearingImpulse { joint } => {
                let response = pose.respond(&self.contact_at(pose)?.0).ok()?;
                let mass = response.effective_mass.kilograms()?;
                squared_force(pose, &response, joint, mass)
            }
        }
    }

    /// Value and gradient by difference quotients of fourth order. `None` if a pose is not reachable or has no finite value.
    fn point_by_differences(&self, unit: Vec<f64>, from: Option<&Pose>) -> Option<(Point, Pose)> {
        let pose = self.pose(&unit, from).ok()?;
        let inverse_mass = self.measure(&pose)?;
        let increases = (self.extreme == ExtremeKind::Most) == self.is_reciprocal();
        let sign = if increases { 1.0 } else { -1.0 };
        let at = |k: usize, step: f64| {
            let mut moved = unit.clone();
            moved[k] += step;
            self.measure(&self.pose(&moved, Some(&pose)).ok()?)
        };
        let h = DIFFERENCE_STEP;
        let slope = |k: usize| {
            Some((8.0 * (at(k, h)? - at(k, -h)?) - (at(k, 2.0 * h)? - at(k, -2.0 * h)?)) / (12.0 * h))
        };
        let gradient = (0..unit.len()).map(|k| Some(sign * slope(k)?)).collect::<Option<Vec<f64>>>()?;
        Some((Point { unit, inverse_mass, value: sign * inverse_mass, gradient, normal_world: None }, pose))
    }

    fn positions(&self, unit: &[f64]) -> Vec<f64> {
        self.ranges.iter().zip(unit).map(|(r, x)| r.lower + x * (r.upper - r.lower)).collect()
    }

    fn pose(&self, unit: &[f64], from: Option<&Pose>) -> Result<Pose, ExtremesError> {
        let mut wanted = self.configuration.clone();
        for (range, position) in self.ranges.iter().zip(self.positions(unit)) {
            wanted.set(self.system.mechanism().joint(range.joint).name(), &[position])?;
        }
        Ok(match from {
            None => self.system.pose(&wanted)?,
            Some(from) => self.system.pose_from(from, &wanted)?,
        })
    }

    /// Contact with the extreme normal at a pose. `None`: a massless motion moves the point.
    fn contact_at(&self, pose: &Pose) -> Option<(Contact, Option<Vector3<f64>>)> {
        let base = pose.base();
        let contact = self.wheel.map_or(*self.contact, |wheel| wheel.contact_at(pose, self.contact));
        let directions = match self.normals {
            NormalRange::Given => return Some((contact, None)),
            NormalRange::Any => Matrix3xX::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z()]),
            NormalRange::Across(axis) => {
                let (e1, e2) = plane_basis(&base.inverse_vector(&axis.normalize()));
                Matrix3xX::from_columns(&[e1, e2])
            }
        };
        let mobility = Delassus::new(pose, &[pose.locate(&contact).ok()?]).ok()?;
        let axes = mobility.axes(0);
        let block = directions.transpose() * (axes * mobility.block(0) * axes.transpose()) * &directions;
        let eigen = block.symmetric_eigen();
        let best = match self.extreme {
            ExtremeKind::Least => eigen.eigenvalues.imax(),
            ExtremeKind::Most => eigen.eigenvalues.imin(),
        };
        let normal: Vector3<f64> = base.vector(&(&directions * eigen.eigenvectors.column(best)));
        let normal = normal * normal[normal.iamax()].signum();
        Some((Contact { normal: Direction::Along(normal, Frame::World), ..contact }, Some(normal)))
    }

    /// 1/m̄ at the middle of the ranges: a size for comparisons.
    fn typical(&self) -> Result<f64, ExtremesError> {
        let pose = self.pose(&vec![0.5; self.ranges.len()], None)?;
        if self.quantity != SearchedQuantity::EffectiveMass {
            return Ok(self.measure(&pose).unwrap_or(0.0));
        }
        let Some((contact, _)) = self.contact_at(&pose) else { return Ok(0.0) };
        let response = pose.respond(&contact)?;
        Ok(response.effective_mass.kilograms().map_or(0.0, |mass| 1.0 / mass))
    }

    /// Value and gradient. `None`: a pose that is not reachable, or a massless contact.
    fn point(&self, unit: Vec<f64>, from: Option<&Pose>) -> Result<Option<(Point, Pose)>, ExtremesError> {
        if self.quantity != SearchedQuantity::EffectiveMass {
            return Ok(self.point_by_differences(unit, from));
        }
        let Ok(pose) = self.pose(&unit, from) else { return Ok(None) };
        let sign = if self.extreme == ExtremeKind::Most { 1.0 } else { -1.0 };
        let Some((contact, normal_world)) = self.contact_at(&pose) else { return Ok(None) };
        let Some(gradient) = pose.effective_mass_gradient(&contact)? else {
            return Ok(match pose.respond(&contact)?.effective_mass {
                EffectiveMass::Immovable => {
                    let gradient = vec![0.0; unit.len()];
                    Some((Point { unit, inverse_mass: 0.0, value: 0.0, gradient, normal_world }, pose))
                }
                _ => None,
            });
        };
        let inverse_mass = 1.0 / gradient.effective_mass;
        let drivers = driving_velocities(&pose);
        let mut derivatives = Vec::with_capacity(unit.len());
        for range in self.ranges {
            if !drivers.contains(&(range.joint, 0)) {
                let joint = self.system.mechanism().joint(range.joint).name().to_owned();
                return Err(ExtremesError::NoDriver { joint });
            }
            let mut rates: Vec<DriverRate> = Vec::new();
            for &(joint, k) in &drivers {
                let rate = f64::from(u8::from(joint == range.joint));
                match rates.last_mut() {
                    Some(last) if last.joint == joint => last.rates.push(0.0),
                    _ if k == 0 => rates.push(DriverRate { joint, rates: vec![rate] }),
                    _ => {}
                }
            }
            let motion = rates_from_drivers(&pose, &rates, Twist::zero())?;
            let mut slope = gradient.rate(&motion.joints);
            if let Some(wheel) = self.wheel {
                slope += wheel.mass_rate(&pose, &contact, &motion.coordinates(&pose))?;
            }
            derivatives.push(-sign * slope * inverse_mass * inverse_mass * (range.upper - range.lower));
        }
        let value = sign * inverse_mass;
        Ok(Some((Point { unit, inverse_mass, value, gradient: derivatives, normal_world }, pose)))
    }

    /// Local search from one start: the point at its end, and `inverse_mass` at the start; `None` if the start has no finite value.
    fn run(&self, unit: Vec<f64>) -> Result<Option<(Point, f64)>, ExtremesError> {
        let n = unit.len();
        let Some((mut at, mut pose)) = self.point(unit, None)? else { return Ok(None) };
        let scale = at.inverse_mass;
        let mut inverse_hessian = identity(n);
        // Without a measured curvature the length of the gradient has no meaning: it depends on the size of 1/m̄.
        let mut has_curvature = false;
        for _ in 0..MOST_STEPS {
            let residual = at.residual();
            if residual <= OPTIMAL * at.inverse_mass || at.inverse_mass <= IMMOVABLE * scale {
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
        Ok(Some((at, scale)))
    }
}

fn identity(n: usize) -> Vec<Vec<f64>> {
    (0..n).map(|r| (0..n).map(|c| f64::from(u8::from(r == c))).collect()).collect()
}

/// BFGS update of the inverse Hessian; left out without positive curvature. `is_first`: the matrix is the identity, and is scaled to the
/// curvature of this step before the update (Nocedal and Wright 2006, equation 6.20). Returns true if the matrix is updated.
fn update(inverse: &mut [Vec<f64>], from: &Point, to: &Point, is_first: bool) -> bool {
    let n = from.unit.len();
    let s: Vec<f64> = (0..n).map(|k| to.unit[k] - from.unit[k]).collect();
    let y: Vec<f64> = (0..n).map(|k| to.gradient[k] - from.gradient[k]).collect();
    let sy: f64 = s.iter().zip(&y).map(|(a, b)| a * b).sum();
    let size = s.iter().map(|x| x * x).sum::<f64>().sqrt() * y.iter().map(|x| x * x).sum::<f64>().sqrt();
    if sy <= 1e-10 * size {
        return false;
    }
    if is_first {
        let scale = sy / y.iter().map(|x| x * x).sum::<f64>();
        inverse.iter_mut().flatten().for_each(|entry| *entry *= scale);
    }
    let hy: Vec<f64> = (0..n).map(|r| (0..n).map(|c| inverse[r][c] * y[c]).sum()).collect();
    let yhy: f64 = y.iter().zip(&hy).map(|(a, b)| a * b).sum();
    for r in 0..n {
        for c in 0..n {
            inverse[r][c] += (1.0 + yhy / sy) * s[r] * s[c] / sy - (hy[r] * s[c] + s[r] * hy[c]) / sy;
        }
    }
    true
}
