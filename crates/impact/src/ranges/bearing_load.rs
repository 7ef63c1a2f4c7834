//! Load of a bearing at a pose, and the normal of the contact with the smallest or largest load.

use crate::ranges::extreme_question::{ExtremeKind, PeakForceLaw};
use crate::reactions::bearing::Bearing;
use crate::reactions::reaction_map::ReactionMap;
use nalgebra::{DMatrix, Matrix3xX, SMatrix, SVector, Vector3};
use percuss_dynamics::{Contact, ContactResponse, Direction, Frame, Pose};
use std::f64::consts::PI;

/// Number of sampled directions on half a circle. The load is a ratio of powers of two quadratic forms, so it has only a few extremes.
const ON_CIRCLE: u32 = 32;
/// Number of sampled directions on half a sphere.
const ON_SPHERE: u32 = 128;
/// Number of best samples from which Newton's method starts.
const NEWTON_STARTS: usize = 4;
/// Largest number of Newton iterations. An iteration squares the error, from about 0.1 rad to rounding; damped steps need a few more.
const NEWTON_STEPS: usize = 30;
/// Largest number of halvings of a step that does not improve the load.
const NEWTON_HALVINGS: i32 = 30;
/// Norm of the gradient of ln(load²) at which the iteration ends. The relative error of the load is of the order of its square.
const STATIONARY_NORMAL: f64 = 1e-9;
/// Largest eigenvalue of a quadratic form, relative to its trace, that counts as zero.
const NO_EIGENVALUE: f64 = 1e-14;

/// Determinate components of the reaction force in a bearing to `impulse` at the contact of a response; open components are 0. `None` if
/// all components are open, if the bearing has no reaction, and if the contact is massless.
pub(super) fn determinate_force(
    map: &ReactionMap,
    response: &ContactResponse,
    bearing: Bearing,
    impulse: f64,
) -> Option<Vector3<f64>> {
    let reactions = map.reactions(response, impulse).ok()?;
    let force = bearing.reaction(&reactions)?.force.map(|component| component.value());
    force.iter().any(Option::is_some).then(|| force.map(Option::unwrap_or_default).into())
}

/// Unit normal (root axes) in the span of `directions` with the extreme load |R| m̄^α of a bearing at a pose. `block`: inverse mass W of
/// the contact point in these directions. `None` if a massless motion moves the point, or if all components of R are open.
///
/// For the normal x in these directions, R = B x is the reaction per impulse, and 1/m̄ = xᵀW x. At the extreme,
/// ln(|R|² m̄^2α) = ln xᵀBᵀB x − 2α ln xᵀW x is stationary on the unit sphere. Newton's method starts at the best samples.
pub(super) fn best_normal(
    pose: &Pose,
    contact: &Contact,
    directions: &Matrix3xX<f64>,
    block: &DMatrix<f64>,
    (bearing, law): (Bearing, PeakForceLaw),
    extreme: ExtremeKind,
) -> Option<Vector3<f64>> {
    let map = ReactionMap::new(pose);
    let reaction = |direction: Vector3<f64>| {
        let direction = pose.base().vector(&direction);
        let normal = match contact.normal.is_moment() {
            true => Direction::About(direction, Frame::World),
            false => Direction::Along(direction, Frame::World),
        };
        let response = pose.respond(&Contact { normal, ..*contact }).ok()?;
        determinate_force(&map, &response, bearing, 1.0)
    };
    let columns = directions.column_iter().map(|direction| reaction(direction.into_owned()));
    let reactions = Matrix3xX::from_columns(&columns.collect::<Option<Vec<_>>>()?);
    let (above, sign) =
        (reactions.transpose() * &reactions, if extreme == ExtremeKind::Most { 1.0 } else { -1.0 });
    let vanishing = if extreme == ExtremeKind::Most { block } else { &above };
    // xᵀW x = 0: unbounded load, the largest. xᵀBᵀB x = 0: load zero, the smallest. No iteration is needed.
    let eigen = vanishing.clone().symmetric_eigen();
    let least = eigen.eigenvalues.imin();
    if eigen.eigenvalues[least] <= NO_EIGENVALUE * vanishing.trace() {
        return Some(directions * eigen.eigenvectors.column(least));
    }
    Some(match directions.ncols() {
        2 => directions * FormRatio::<2>::new(&above, block, law.power, sign).best(&half_circle()),
        _ => directions * FormRatio::<3>::new(&above, block, law.power, sign).best(&half_sphere()),
    })
}

/// Function ± (ln xᵀA x − 2α ln xᵀW x) on the unit sphere, which is maximised. A = BᵀB is `above`, W is `below`.
struct FormRatio<const N: usize> {
    above: SMatrix<f64, N, N>,
    below: SMatrix<f64, N, N>,
    /// α.
    power: f64,
    sign: f64,
}

impl<const N: usize> FormRatio<N> {
    fn new(above: &DMatrix<f64>, below: &DMatrix<f64>, power: f64, sign: f64) -> Self {
        let fixed = |matrix: &DMatrix<f64>| SMatrix::from_fn(|row, column| matrix[(row, column)]);
        Self { above: fixed(above), below: fixed(below), power, sign }
    }

    /// Unit vector with the largest value: the best local maximum from the best samples.
    fn best(&self, samples: &[SVector<f64, N>]) -> SVector<f64, N> {
        let mut samples: Vec<(f64, SVector<f64, N>)> = samples.iter().map(|x| (self.value(x), *x)).collect();
        samples.sort_by(|a, b| b.0.total_cmp(&a.0));
        let ends = samples.iter().take(NEWTON_STARTS).map(|(_, sample)| self.ascend(*sample));
        let best = ends.max_by(|a, b| self.value(a).total_cmp(&self.value(b)));
        best.unwrap_or_else(SVector::zeros)
    }

    fn value(&self, x: &SVector<f64, N>) -> f64 {
        let form = |matrix: &SMatrix<f64, N, N>| x.dot(&(matrix * x)).max(f64::MIN_POSITIVE);
        self.sign * (form(&self.above).ln() - 2.0 * self.power * form(&self.below).ln())
    }

    /// Local maximum from a unit vector, by damped Newton steps in the tangent plane.
    fn ascend(&self, start: SVector<f64, N>) -> SVector<f64, N> {
        let mut x = start;
        for _ in 0..NEWTON_STEPS {
            let (mut gradient, mut hessian) = (SVector::<f64, N>::zeros(), SMatrix::<f64, N, N>::zeros());
            for (matrix, factor) in [(&self.above, 1.0), (&self.below, -2.0 * self.power)] {
                let mapped = matrix * x;
                let form = x.dot(&mapped).max(f64::MIN_POSITIVE);
                let scale = 2.0 * self.sign * factor / form;
                gradient += mapped * scale;
                hessian += (matrix - mapped * mapped.transpose() * (2.0 / form)) * scale;
            }
            let tangent = SMatrix::<f64, N, N>::identity() - x * x.transpose();
            let slope = tangent * gradient;
            if slope.norm() <= STATIONARY_NORMAL {
                break;
            }
            // Minus the curvature in the tangent plane, and 1 along x. A Newton step ascends if it is positive definite.
            let shifted = SMatrix::<f64, N, N>::identity() * gradient.dot(&x) - hessian;
            let negative = tangent * shifted * tangent + x * x.transpose();
            let newton = negative.cholesky().map(|negative| negative.solve(&slope));
            let step = newton.unwrap_or_else(|| slope / slope.norm().max(1.0));
            let here = self.value(&x);
            let moved = |length: f64| (x + step * length).normalize();
            let lengths = (0..NEWTON_HALVINGS).map(|halvings| 0.5f64.powi(halvings));
            let Some(next) = lengths.map(moved).find(|next| self.value(next) > here) else { break };
            x = next;
        }
        x
    }
}

/// Unit vectors on half a circle at equal angles. Opposite vectors have the same value, so half a circle is sufficient.
fn half_circle() -> Vec<SVector<f64, 2>> {
    let angles = (0..ON_CIRCLE).map(|k| PI * f64::from(k) / f64::from(ON_CIRCLE));
    angles.map(|angle| SVector::from([angle.cos(), angle.sin()])).collect()
}

/// Unit vectors on half a sphere on a Fibonacci spiral: equal areas, with the golden angle between neighbours.
fn half_sphere() -> Vec<SVector<f64, 3>> {
    let golden = PI * (3.0 - 5f64.sqrt());
    let vector = |k: u32| {
        let z = (f64::from(k) + 0.5) / f64::from(ON_SPHERE);
        let (sin, cos) = (golden * f64::from(k)).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        SVector::from([radius * cos, radius * sin, z])
    };
    (0..ON_SPHERE).map(vector).collect()
}
