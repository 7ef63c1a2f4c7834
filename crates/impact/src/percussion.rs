//! Centre of percussion: the contact point with the least reaction in a bearing.

use crate::reactions::bearing::Bearing;
use crate::reactions::reaction_map::{ReactionError, ReactionMap};
use crate::tolerances::{CIRCLE_ANGLES, CIRCLE_ITERATIONS, NO_INFLUENCE};
use nalgebra::{Matrix2, Vector2, Vector3};
use percuss_dynamics::{Contact, Direction, EffectiveMass, Frame, Pose, ResponseError};
use percuss_spatial::plane_basis;

/// Error of a centre of percussion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PercussionError {
    /// A contact is invalid.
    #[error(transparent)]
    Contact(#[from] ResponseError),
    /// The reactions cannot be computed.
    #[error(transparent)]
    Reactions(#[from] ReactionError),
    /// Redundant constraints leave the reaction open.
    #[error("{bearing}: redundant loops leave components of its reaction open ({})", loops.join(", "))]
    Indeterminate {
        /// Kind and name of the bearing.
        bearing: String,
        /// Loops that leave the components open.
        loops: Vec<String>,
    },
    /// The bearing has no reaction, because it is the ground and the base floats.
    #[error("{bearing}: no reaction, because the base floats; expected a joint or a loop closure")]
    NoReaction {
        /// Kind and name of the bearing.
        bearing: String,
    },
    /// No motion closes the gap at the contact point, so that no impact occurs there.
    #[error(
        "{bearing}: no centre of percussion, because the {} [{}, {}, {}] m (frame of the contact link) is immovable along the normal; \
         expected a point that the mechanism can move along it",
        if *is_best { "point of the least reaction" } else { "contact point" }, rounded(point[0]), rounded(point[1]), rounded(point[2])
    )]
    Immovable {
        /// Kind and name of the bearing.
        bearing: String,
        /// The point, frame of the contact link, m.
        point: [f64; 3],
        /// True for the point of the least reaction, false for the given contact point.
        is_best: bool,
    },
    /// The contact is a moment about an axis.
    #[error(
        "{bearing}: no centre of percussion, because the contact is a moment about an axis; expected a contact point with a normal"
    )]
    Moment {
        /// Kind and name of the bearing.
        bearing: String,
    },
    /// The direction of the line is too short or not finite.
    #[error("the direction of the line is {direction:?}; expected a vector of length above zero")]
    Direction {
        /// Given direction.
        direction: [f64; 3],
    },
    /// The radius of the displaced points is negative or not finite.
    #[error("the contact point is displaced by up to {radius} m; expected a finite radius of at least 0")]
    Radius {
        /// Given radius, m.
        radius: f64,
    },
    /// The reaction does not depend on the position of the contact point.
    #[error("{bearing}: its reaction does not depend on the position of the contact point")]
    NoInfluence {
        /// Kind and name of the bearing.
        bearing: String,
    },
}

/// Coordinate rounded to nanometres, for messages.
fn rounded(coordinate: f64) -> f64 {
    const PER_METRE: f64 = 1e9;
    (coordinate * PER_METRE).round() / PER_METRE + 0.0
}

/// Contact point with the least impulse in a bearing, at unit impulse at the contact. Components that redundant constraints
/// leave open do not count: the least value is that of the determinate components.
#[derive(Clone, Debug, PartialEq)]
pub struct PercussionCentre {
    /// Contact point, m, in the frame of the contact link.
    pub point: Vector3<f64>,
    /// Displacement from the given contact point, m, in the axes of the contact link.
    pub displacement: Vector3<f64>,
    /// Impulse in the bearing for the given point, per unit impulse at the contact: its determinate components.
    pub given_reaction: f64,
    /// Remaining impulse in the bearing for the best point, per unit impulse at the contact: its determinate components.
    pub remaining_reaction: f64,
    /// True for each component of the impulse that redundant constraints leave open. The components are along the axes of
    /// [`Reaction::frame`](crate::Reaction::frame).
    pub is_open: [bool; 3],
    /// Loops that leave these components open; empty if all are determinate.
    pub loops: Vec<String>,
}

/// Point along a line through the contact point (direction in the axes of the contact link) with the least impulse in a
/// bearing.
///
/// With a fixed normal, the impulse R in the bearing is an affine function of the point, R(s) = R₀ + s R₁. The best point
/// is s = −R₀·R₁/|R₁|². The remaining impulse is zero in general only for planar bodies. R has the determinate components
/// only, and [`PercussionCentre::is_open`] names the others; an impulse without a determinate component is refused.
///
/// # Errors
/// [`PercussionError`].
pub fn centre_of_percussion(
    pose: &Pose,
    contact: &Contact,
    bearing: impl Into<Bearing>,
    direction: Vector3<f64>,
) -> Result<PercussionCentre, PercussionError> {
    let length = direction.norm();
    if !(length.is_finite() && length > 0.0) {
        return Err(PercussionError::Direction { direction: direction.into() });
    }
    let line = direction / length;
    let affine = AffineReaction::new(pose, contact, bearing.into(), &[line])?;
    let r1 = affine.derivatives[0];
    if r1.norm() * affine.size <= NO_INFLUENCE * affine.given.norm().max(1.0) {
        return Err(affine.no_influence(pose));
    }
    let s = -affine.given.dot(&r1) / r1.norm_squared();
    affine.centre(pose, contact, line * s, affine.given + r1 * s)
}

/// Point of the tangent plane with the least impulse in a bearing. See [`centre_of_percussion`]. If a line of points has
/// the least impulse, the point nearest to the given contact point.
///
/// # Errors
/// [`PercussionError`].
pub fn centre_of_percussion_in_plane(
    pose: &Pose,
    contact: &Contact,
    bearing: impl Into<Bearing>,
) -> Result<PercussionCentre, PercussionError> {
    let normal = pose.locate(contact).map_err(ResponseError::from)?.normal_link;
    let (t1, t2) = plane_basis(&normal);
    let affine = AffineReaction::new(pose, contact, bearing.into(), &[t1, t2])?;
    let [r1, r2] = [affine.derivatives[0], affine.derivatives[1]];
    let gram = Matrix2::new(r1.norm_squared(), r1.dot(&r2), r1.dot(&r2), r2.norm_squared());
    let right = -Vector2::new(r1.dot(&affine.given), r2.dot(&affine.given));
    // Least squares of least norm by the eigenvectors of the 2×2 matrix.
    let eigen = gram.symmetric_eigen();
    let largest = eigen.eigenvalues.amax();
    if largest.sqrt() * affine.size <= NO_INFLUENCE * affine.given.norm().max(1.0) {
        return Err(affine.no_influence(pose));
    }
    let mut x = Vector2::zeros();
    for k in 0..2 {
        if eigen.eigenvalues[k] > NO_INFLUENCE * largest {
            let axis = eigen.eigenvectors.column(k);
            x += axis * (axis.dot(&right) / eigen.eigenvalues[k]);
        }
    }
    affine.centre(pose, contact, t1 * x[0] + t2 * x[1], affine.given + r1 * x[0] + r2 * x[1])
}

/// Largest impulse in a bearing for contact points near the given one.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstReaction {
    /// Contact point with the largest impulse, in the frame of the contact link, m.
    pub point: Vector3<f64>,
    /// Displacement from the given contact point, m, in the axes of the contact link.
    pub displacement: Vector3<f64>,
    /// Magnitude of the impulse in the bearing for the given point, per impulse at the contact.
    pub given_reaction: f64,
    /// Largest magnitude, at [`point`](Self::point).
    pub worst_reaction: f64,
    /// True for each component of the impulse (along the axes of [`Reaction::frame`](crate::Reaction::frame)) that redundant loops leave
    /// open. The magnitudes omit these components.
    pub is_open: [bool; 3],
    /// Loops that leave these components open.
    pub loops: Vec<String>,
}

/// Largest impulse in a bearing, per impulse at the contact, if the contact point is displaced in the tangent plane by at most `radius`
/// (m).
///
/// The impulse is an affine function of the point, R = R₀ + x R₁ + y R₂, so its magnitude is largest on the circle. |R|² over the angle
/// is a trigonometric polynomial of degree 2; Newton's method finds its maximum to rounding, starting at the best of 64 angles.
///
/// # Errors
/// [`PercussionError`]; a radius that is negative or not finite is [`PercussionError::Radius`].
pub fn worst_reaction_within(
    pose: &Pose,
    contact: &Contact,
    bearing: impl Into<Bearing>,
    radius: f64,
) -> Result<WorstReaction, PercussionError> {
    if !(radius.is_finite() && radius >= 0.0) {
        return Err(PercussionError::Radius { radius });
    }
    let normal = pose.locate(contact).map_err(ResponseError::from)?.normal_link;
    let (t1, t2) = plane_basis(&normal);
    let affine = AffineReaction::new(pose, contact, bearing.into(), &[t1, t2])?;
    let [r1, r2] = [affine.derivatives[0] * radius, affine.derivatives[1] * radius];
    let at = |angle: f64| affine.given + r1 * angle.cos() + r2 * angle.sin();
    let step = std::f64::consts::TAU / f64::from(CIRCLE_ANGLES);
    let angles = (0..CIRCLE_ANGLES).map(|k| f64::from(k) * step);
    let mut best =
        angles.max_by(|a, b| at(*a).norm_squared().total_cmp(&at(*b).norm_squared())).unwrap_or(0.0);
    for _ in 0..CIRCLE_ITERATIONS {
        let (r, d) = (at(best), r2 * best.cos() - r1 * best.sin());
        let curvature = d.norm_squared() - r.dot(&(r - affine.given));
        if curvature >= 0.0 {
            break;
        }
        best -= (r.dot(&d) / curvature).clamp(-step, step);
    }
    let displacement = (t1 * best.cos() + t2 * best.sin()) * radius;
    Ok(WorstReaction {
        point: contact.point + displacement,
        displacement,
        given_reaction: affine.given.norm(),
        worst_reaction: at(best).norm(),
        is_open: affine.is_open,
        loops: affine.loops,
    })
}

/// Impulse in a bearing as an affine function of the contact point.
struct AffineReaction {
    bearing: Bearing,
    /// Normal at the given contact point, axes of the contact link.
    normal: Vector3<f64>,
    given: Vector3<f64>,
    /// Derivatives by displacements along the given directions, 1/m.
    derivatives: Vec<Vector3<f64>>,
    /// Length of the displacements, m.
    size: f64,
    is_open: [bool; 3],
    loops: Vec<String>,
}

impl AffineReaction {
    /// Reactions at the contact point and at points displaced along `directions` (axes of the contact link).
    fn new(
        pose: &Pose,
        contact: &Contact,
        bearing: Bearing,
        directions: &[Vector3<f64>],
    ) -> Result<Self, PercussionError> {
        // The normal stays fixed while the point moves, also for normals along a line.
        let normal = pose.locate(contact).map_err(ResponseError::from)?.normal_link;
        let size = pose.mechanism().characteristic_length();
        let map = ReactionMap::new(pose);
        let displaced = |displacement: Vector3<f64>| Contact {
            point: contact.point + displacement,
            normal: Direction::Along(normal, Frame::Link),
            ..*contact
        };
        let at =
            |displacement: Vector3<f64>| impulse_in_bearing(pose, &map, &displaced(displacement), bearing);
        require_movable(pose, contact, bearing, false)?;
        let first = at(Vector3::zeros())?;
        let mut is_open = first.is_open;
        let mut derivatives = Vec::new();
        for direction in directions {
            let other = at(direction * size)?;
            is_open = [0, 1, 2].map(|k| is_open[k] || other.is_open[k]);
            derivatives.push((other.values - first.values) / size);
        }
        // A component that is open at one of the points does not count at any.
        let determinate = |v: Vector3<f64>| Vector3::from_fn(|k, _| if is_open[k] { 0.0 } else { v[k] });
        Ok(Self {
            bearing,
            normal,
            given: determinate(first.values),
            derivatives: derivatives.into_iter().map(determinate).collect(),
            size,
            is_open,
            loops: first.loops,
        })
    }

    /// Centre of percussion at a displacement; an error if the point is immovable there.
    fn centre(
        &self,
        pose: &Pose,
        contact: &Contact,
        displacement: Vector3<f64>,
        rest: Vector3<f64>,
    ) -> Result<PercussionCentre, PercussionError> {
        let normal = Direction::Along(self.normal, Frame::Link);
        let best = Contact { point: contact.point + displacement, normal, ..*contact };
        require_movable(pose, &best, self.bearing, true)?;
        Ok(PercussionCentre {
            point: best.point,
            displacement,
            given_reaction: self.given.norm(),
            remaining_reaction: rest.norm(),
            is_open: self.is_open,
            loops: self.loops.clone(),
        })
    }

    fn no_influence(&self, pose: &Pose) -> PercussionError {
        PercussionError::NoInfluence { bearing: self.bearing.describe(pose.mechanism()) }
    }
}

/// Error if no motion closes the gap at a contact.
fn require_movable(
    pose: &Pose,
    contact: &Contact,
    bearing: Bearing,
    is_best: bool,
) -> Result<(), PercussionError> {
    let immovable = pose.respond(contact)?.effective_mass == EffectiveMass::Immovable;
    if !immovable && !contact.normal.is_moment() {
        return Ok(());
    }
    let bearing = bearing.describe(pose.mechanism());
    if contact.normal.is_moment() {
        return Err(PercussionError::Moment { bearing });
    }
    Err(PercussionError::Immovable { bearing, point: contact.point.into(), is_best })
}

/// Impulse in a bearing per unit impulse at the contact.
struct BearingImpulse {
    /// Components; 0 for open ones.
    values: Vector3<f64>,
    is_open: [bool; 3],
    loops: Vec<String>,
}

/// Impulse in a bearing for a unit impulse at `contact`.
fn impulse_in_bearing(
    pose: &Pose,
    map: &ReactionMap,
    contact: &Contact,
    bearing: Bearing,
) -> Result<BearingImpulse, PercussionError> {
    let reactions = map.reactions(&pose.respond(contact)?, 1.0)?;
    let describe = || bearing.describe(pose.mechanism());
    let reaction =
        bearing.reaction(&reactions).ok_or_else(|| PercussionError::NoReaction { bearing: describe() })?;
    let values = reaction.force.map(|component| component.value());
    if values.iter().all(Option::is_none) {
        let loops = reaction.loops.clone();
        return Err(PercussionError::Indeterminate { bearing: describe(), loops });
    }
    Ok(BearingImpulse {
        values: Vector3::from(values.map(Option::unwrap_or_default)),
        is_open: values.map(|value| value.is_none()),
        loops: if values.iter().any(Option::is_none) { reaction.loops.clone() } else { Vec::new() },
    })
}
