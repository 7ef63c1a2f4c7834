//! Input and result of a search for extremes.

use crate::reactions::bearing::Bearing;
use nalgebra::Vector3;
use percuss_dynamics::{Contact, EffectiveMass, LowestPoint};
use percuss_mechanism::{JointId, LinkId};

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

/// Point of a link that keeps its world position during a search, such as the tool point of a redundant arm: the search covers the
/// self-motion of the mechanism. The point is free in the impact; a held contact
/// ([`Conditions::hold`](percuss_dynamics::Conditions::hold)), in contrast, constrains the impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeptPoint {
    /// The link.
    pub link: LinkId,
    /// Point in the frame of the link, m.
    pub point: Vector3<f64>,
    /// Direction (world axes) along which the coordinate of the point is kept; `None` for all directions.
    pub normal: Option<Vector3<f64>>,
}

impl KeptPoint {
    /// Three points that keep the position and the orientation of a link: its origin, and points at the distance `arm` (m) along its
    /// x-axis and its y-axis.
    pub fn of_link(link: LinkId, arm: f64) -> [Self; 3] {
        [Vector3::zeros(), Vector3::x() * arm, Vector3::y() * arm].map(|point| Self {
            link,
            point,
            normal: None,
        })
    }
}

/// Positions over which an extreme is searched: ranges of driving joints, and points that stay in place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchedPoses<'a> {
    /// Ranges of the driving joints that vary.
    pub ranges: &'a [JointRange],
    /// Points that keep their world positions in the pose of the configuration; empty for all positions within the ranges.
    pub kept: &'a [KeptPoint],
}

impl<'a> From<&'a [JointRange]> for SearchedPoses<'a> {
    fn from(ranges: &'a [JointRange]) -> Self {
        Self { ranges, kept: &[] }
    }
}

impl<'a> From<&'a Vec<JointRange>> for SearchedPoses<'a> {
    fn from(ranges: &'a Vec<JointRange>) -> Self {
        ranges.as_slice().into()
    }
}

impl<'a, const N: usize> From<&'a [JointRange; N]> for SearchedPoses<'a> {
    fn from(ranges: &'a [JointRange; N]) -> Self {
        ranges.as_slice().into()
    }
}

/// Path of driving joints with one velocity: straight lines between given rows of positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriverPath<'a> {
    /// The joints.
    pub joints: &'a [JointId],
    /// Rows of positions, one number (rad or m) per joint.
    pub rows: &'a [Vec<f64>],
}

/// Extreme to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExtremeKind {
    /// Smallest value.
    Least,
    /// Largest value. A mass or an inertia is `Immovable` if at some pose no motion closes the gap or moves the joint. The load of a
    /// bearing is `Immovable` if it grows without bound towards a pose with an immovable contact.
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
    /// All normals within an angle (rad, from 0 to π/2) of the normal of the contact.
    Cone(f64),
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
    /// the reaction force in the bearing per impulse at the contact, without its moment. An impact with the closing speed c and the
    /// coefficient of restitution e has (1+e) c times this impulse.
    BearingImpulse {
        /// The bearing.
        bearing: Bearing,
    },
    /// Peak force in a bearing at a compliant contact, N: |R| times the peak force of the contact.
    BearingPeakForce {
        /// The bearing.
        bearing: Bearing,
        /// Peak force of the contact as a function of the effective mass.
        law: PeakForceLaw,
    },
}

/// Peak force of a compliant contact as a function of the effective mass: force · m̄^power.
///
/// A contact law with the stiffness k, the exponent p, the closing speed c and a given restitution has the peak force C kᵃ (m̄ c²)ᵇ with
/// a = 1/(p+1) and b = p/(p+1). The reason is dimensional: k, c and m̄ define the units of mass, length and time, so the number C depends
/// only on the law, its exponent and the restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeakForceLaw {
    /// Peak force at m̄ = 1 kg, N; for a moment, peak moment at m̄ = 1 kg·m², N·m.
    pub force: f64,
    /// Power of the effective mass: b = p/(p+1).
    pub power: f64,
}

impl SearchedQuantity {
    /// Bearing, and the load of the contact (impulse per closing speed, or peak force) as a function of the effective mass; `None` for a
    /// mass or an inertia.
    pub(crate) fn bearing_load(self) -> Option<(Bearing, PeakForceLaw)> {
        match self {
            Self::EffectiveMass | Self::ReflectedInertia { .. } => None,
            Self::BearingImpulse { bearing } => Some((bearing, PeakForceLaw { force: 1.0, power: 1.0 })),
            Self::BearingPeakForce { bearing, law } => Some((bearing, law)),
        }
    }
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
    /// Edges eᵢ (m, in the frame of the contact link; two at most) of a patch of contact points p + Σ xᵢ eᵢ, 0 ≤ xᵢ ≤ 1.
    pub edges: &'a [Vector3<f64>],
}

impl<'a> From<&'a Contact> for SearchedContact<'a> {
    fn from(contact: &'a Contact) -> Self {
        Self { contact, wheel: None, normals: NormalRange::Given, edges: &[] }
    }
}

/// Extreme of an effective mass, or of another quantity, over ranges of positions.
#[derive(Clone, Debug, PartialEq)]
pub struct ExtremeMass {
    /// Value of the quantity at the extreme, kg, kg·m² or N. `Immovable` is a valid largest value of a mass or an inertia. For the load of
    /// a bearing, `Immovable` means an unbounded load; the contact is immovable at `positions`.
    pub effective_mass: EffectiveMass,
    /// Positions of the varied joints, in the order of the ranges.
    pub positions: Vec<f64>,
    /// Normal at the extreme, world axes, up to its sign; `None` for the normal of the contact.
    pub normal_world: Option<Vector3<f64>>,
    /// Contact point at the extreme in the frame of the contact link, m; `None` without edges.
    pub point_link: Option<Vector3<f64>>,
    /// Joints at a limit, true for the upper one.
    pub active_limits: Vec<(JointId, bool)>,
    /// Optimality: largest component of the projected gradient, times its range, relative to the value; 0 at an exact stationary point
    /// of the constrained problem, and for an immovable contact. The value is 1/m̄ or the reciprocal inertia; for a bearing, the squared
    /// load. If the squared load is rounding of zero, the residual is relative to the largest squared load of the search.
    pub residual: f64,
    /// Largest error of a coordinate of a kept point, m; 0 without kept points.
    pub kept_error: f64,
    /// Number of starts; on a path the number of local searches.
    pub starts: usize,
    /// Number of starts that reached this value to six digits.
    pub agreeing: usize,
    /// True if the limit of work ended the search: `starts` counts the starts that were searched, and the value is the best one found.
    pub is_stopped: bool,
}

/// Extreme along a path.
#[derive(Clone, Debug, PartialEq)]
pub struct ExtremeOnPath {
    /// The extreme. `positions` are those of the joints of the path. `active_limits` is empty: the ends of a path are no limits.
    pub extreme: ExtremeMass,
    /// Fractional row number on the path, from 0: 2.25 is a quarter of the way from row 2 to row 3.
    pub row: f64,
}
