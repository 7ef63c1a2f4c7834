//! Local search on a self-motion: the positions within the ranges at which kept points stay in place.
//!
//! ```text
//! minimise f(x)  with  c(x) = 0,  0 ≤ x ≤ 1
//! ```
//!
//! C is the Jacobian of c over the variables that are not at an active limit. The columns of Z are an orthonormal basis of ker C, and the
//! multipliers λ solve Cᵀλ = ∇f in the least-squares sense. A step is Z d, where d is the Newton direction of the Lagrangian f − λᵀc with
//! the eigenvalues of the reduced Hessian replaced by their magnitudes. Gauss-Newton iterations then restore c = 0. The conditions c may
//! be redundant. Sources: Burdick 1989 (self-motion); Nocedal and Wright 2006, §12.5, §16.5 and §18.1 (conditions of optimality, active
//! limits, reduced Hessian).

use crate::ranges::extremes_error::ExtremesError;
use crate::ranges::quasi_newton::{AT_LIMIT, Point};
use crate::ranges::search::{IMMOVABLE, MOST_STEPS, OPTIMAL, Search};
use crate::tolerances::DIFFERENCE_STEP;
use faer::Mat;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use percuss_dynamics::Pose;

/// Singular value of the Jacobian of the kept points, relative to its largest entry, up to which it counts as zero. The rounding of the
/// difference quotients is about 1e-11.
const ZERO_SINGULAR: f64 = 1e-7;
/// Residual of the kept points, relative to the characteristic length, at which the iterations end.
const IN_PLACE: f64 = 1e-13;
/// Residual up to which a point is accepted if the iterations do not reduce it further.
const ACCEPTED: f64 = 1e-10;
/// Largest number of Gauss-Newton iterations; about ten are usual from a random point.
const MOST_ITERATIONS: usize = 40;
/// Longest step of a variable, as a part of its range.
const LONGEST_STEP: f64 = 0.25;
/// Step of the central differences of the gradient of the Lagrangian; their error is of the order of the square of this step.
const HESSIAN_STEP: f64 = 1e-4;
/// Lower bound for the magnitudes of the eigenvalues of the reduced Hessian, relative to the largest; smaller ones are replaced by it.
const LEAST_CURVATURE: f64 = 1e-6;

/// Tangent space of the self-motion at a point, over the variables that are at no active limit.
struct TangentSpace {
    /// True for variables at an active limit.
    fixed: Vec<bool>,
    /// Multipliers λ of the kept points.
    multipliers: DVector<f64>,
    /// Orthonormal tangent directions as columns; zero for fixed variables.
    basis: DMatrix<f64>,
    /// Zᵀ∇f.
    gradient: DVector<f64>,
}

impl TangentSpace {
    /// Tangent space at a point. `jacobian`: of the kept points. `blocked`: true for variables at a limit that remain fixed whatever the
    /// sign of their multiplier.
    fn new(at: &Point, jacobian: &DMatrix<f64>, blocked: &[bool]) -> Self {
        let n = at.unit.len();
        let is_lower = |k: usize| at.unit[k] <= AT_LIMIT;
        let mut fixed: Vec<bool> = (0..n).map(|k| is_lower(k) || at.unit[k] >= 1.0 - AT_LIMIT).collect();
        loop {
            let free: Vec<usize> = (0..n).filter(|k| !fixed[*k]).collect();
            let (multipliers, basis) = kernel_and_multipliers(jacobian, &free, &at.gradient);
            // Multiplier of a limit. If it is negative, the function decreases away from the limit; the variable is released.
            let of_limit = |k: usize| {
                let slope = at.gradient[k] - jacobian.column(k).dot(&multipliers);
                if is_lower(k) { slope } else { -slope }
            };
            let least = OPTIMAL * at.inverse_mass;
            let leaves = (0..n).filter(|&k| fixed[k] && !blocked[k] && of_limit(k) < -least);
            if let Some(k) = leaves.min_by(|&a, &b| of_limit(a).total_cmp(&of_limit(b))) {
                fixed[k] = false;
                continue;
            }
            let gradient = basis.tr_mul(&DVector::from_column_slice(&at.gradient));
            return Self { fixed, multipliers, basis, gradient };
        }
    }

    fn residual(&self) -> f64 {
        self.gradient.iter().fold(0.0, |most: f64, g| most.max(g.abs()))
    }
}

/// Multipliers λ of least norm with Cᵀλ ≈ g, and an orthonormal basis of ker C, both over the variables `free`.
fn kernel_and_multipliers(
    jacobian: &DMatrix<f64>,
    free: &[usize],
    gradient: &[f64],
) -> (DVector<f64>, DMatrix<f64>) {
    let (m, f) = (jacobian.nrows(), free.len());
    let none = || (DVector::zeros(m), DMatrix::zeros(gradient.len(), 0));
    if f == 0 {
        return none();
    }
    let Ok(svd) = Mat::from_fn(m, f, |r, c| jacobian[(r, free[c])]).svd() else { return none() };
    let (u, sigma, v) = (svd.U(), svd.S().column_vector(), svd.V());
    let least = ZERO_SINGULAR * jacobian.amax();
    let mut multipliers = DVector::zeros(m);
    let mut kernel = Vec::new();
    for k in 0..f {
        if k < m.min(f) && sigma[k] > least {
            let along: f64 =
                free.iter().enumerate().map(|(c, &variable)| v[(c, k)] * gradient[variable]).sum();
            for r in 0..m {
                multipliers[r] += u[(r, k)] * along / sigma[k];
            }
        } else {
            kernel.push(k);
        }
    }
    let mut basis = DMatrix::zeros(gradient.len(), kernel.len());
    for (column, k) in kernel.into_iter().enumerate() {
        for (c, &variable) in free.iter().enumerate() {
            basis[(variable, column)] = v[(c, k)];
        }
    }
    (multipliers, basis)
}

impl Search<'_> {
    /// Number of independent motions of the variables at the configuration that keep the points in place; `None` if the configuration
    /// has no pose.
    pub fn self_motions(&self) -> Option<usize> {
        let pose = self.system.pose(self.configuration).ok()?;
        let part = |variable: &super::search::Variable| {
            let range = variable.moves.first()?;
            Some((pose.joint(range.joint)[0] - range.lower) / (range.upper - range.lower))
        };
        let unit: Vec<f64> = self.variables.iter().map(part).collect::<Option<_>>()?;
        let jacobian = self.kept_jacobian(&unit, &pose)?;
        let free: Vec<usize> = (0..unit.len()).collect();
        Some(kernel_and_multipliers(&jacobian, &free, &vec![0.0; unit.len()]).1.ncols())
    }

    /// Jacobian of the residuals of the kept points over the variables, by difference quotients of fourth order.
    fn kept_jacobian(&self, unit: &[f64], pose: &Pose) -> Option<DMatrix<f64>> {
        let at = |k: usize, step: f64| {
            let mut moved = unit.to_vec();
            moved[k] += step;
            Some(self.kept.residuals(&self.pose(&moved, Some(pose)).ok()?))
        };
        let h = DIFFERENCE_STEP;
        let column = |k: usize| {
            Some(((at(k, h)? - at(k, -h)?) * 8.0 - (at(k, 2.0 * h)? - at(k, -2.0 * h)?)) / (12.0 * h))
        };
        let columns: Vec<DVector<f64>> = (0..unit.len()).map(column).collect::<Option<_>>()?;
        Some(DMatrix::from_columns(&columns))
    }

    /// Moves a point to positions within the ranges at which the kept points are in place: Gauss-Newton iterations over the variables
    /// that are not `fixed`. `None` if they do not converge.
    pub fn project(
        &self,
        mut unit: Vec<f64>,
        from: Option<&Pose>,
        fixed: &[bool],
    ) -> Option<(Vec<f64>, Pose)> {
        let n = unit.len();
        let mut pose = self.pose(&unit, from).ok()?;
        let mut residuals = self.kept.residuals(&pose);
        for _ in 0..MOST_ITERATIONS {
            let size = residuals.amax();
            if size <= IN_PLACE {
                break;
            }
            let jacobian = self.kept_jacobian(&unit, &pose)?;
            let step = step_within(&jacobian, &residuals, &unit, fixed);
            let largest = step.amax();
            let mut length = (LONGEST_STEP / largest).min(1.0);
            let mut next = None;
            for _ in 0..10 {
                let moved: Vec<f64> = (0..n).map(|k| (unit[k] + length * step[k]).clamp(0.0, 1.0)).collect();
                if let Ok(there) = self.pose(&moved, Some(&pose)) {
                    let left = self.kept.residuals(&there);
                    if left.norm() < residuals.norm() {
                        next = Some((moved, there, left));
                        break;
                    }
                }
                length *= 0.5;
            }
            let Some((moved, there, left)) = next else { break };
            (unit, pose, residuals) = (moved, there, left);
        }
        (residuals.amax() <= ACCEPTED).then_some((unit, pose))
    }

    /// Gradient of the Lagrangian f − λᵀc near a point.
    fn lagrangian_gradient(
        &self,
        unit: Vec<f64>,
        pose: &Pose,
        multipliers: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let (point, there) = self.point(unit, Some(pose)).ok()??;
        let jacobian = self.kept_jacobian(&point.unit, &there)?;
        Some(DVector::from_vec(point.gradient) - jacobian.tr_mul(multipliers))
    }

    /// Newton direction of the Lagrangian in the tangent space, with the magnitudes of the eigenvalues of the reduced Hessian, so that
    /// it descends. The direction of steepest descent if the Hessian is not available.
    fn newton_direction(&self, at: &Point, pose: &Pose, tangent: &TangentSpace) -> DVector<f64> {
        let r = tangent.gradient.len();
        if tangent.residual() == 0.0 {
            return DVector::zeros(r);
        }
        let steepest = -&tangent.gradient * (LONGEST_STEP / tangent.residual());
        let column = |k: usize| {
            let gradient = |sign: f64| {
                let step = |(x, z): (&f64, &f64)| x + sign * HESSIAN_STEP * z;
                let unit = at.unit.iter().zip(tangent.basis.column(k).iter()).map(step).collect();
                self.lagrangian_gradient(unit, pose, &tangent.multipliers)
            };
            Some(tangent.basis.tr_mul(&(gradient(1.0)? - gradient(-1.0)?)) / (2.0 * HESSIAN_STEP))
        };
        let Some(columns) = (0..r).map(column).collect::<Option<Vec<_>>>() else { return steepest };
        let hessian = DMatrix::from_columns(&columns);
        let eigen = SymmetricEigen::new((&hessian + hessian.transpose()) * 0.5);
        let largest = eigen.eigenvalues.amax();
        if !(largest.is_finite() && largest > 0.0) {
            return steepest;
        }
        let mut weights = eigen.eigenvectors.tr_mul(&tangent.gradient);
        for (weight, curvature) in weights.iter_mut().zip(eigen.eigenvalues.iter()) {
            *weight /= -curvature.abs().max(LEAST_CURVATURE * largest);
        }
        eigen.eigenvectors * weights
    }

    /// Local search as by [`run`](Search::run), on the self-motion.
    pub fn run_on_self_motion(
        &self,
        unit: Vec<f64>,
        scale: f64,
    ) -> Result<Option<(Point, f64)>, ExtremesError> {
        let n = unit.len();
        let Some((unit, near)) = self.project(unit, None, &vec![false; n]) else { return Ok(None) };
        let Some((mut at, mut pose)) = self.point(unit, Some(&near))? else { return Ok(None) };
        let at_start = at.inverse_mass;
        let scale = scale.max(at_start);
        for _ in 0..MOST_STEPS {
            let Some(jacobian) = self.kept_jacobian(&at.unit, &pose) else { break };
            let mut blocked = vec![false; n];
            let mut tangent = TangentSpace::new(&at, &jacobian, &blocked);
            at.residual = tangent.residual();
            if at.residual <= OPTIMAL * at.inverse_mass
                || at.inverse_mass <= IMMOVABLE * scale
                || self.is_stopped()
            {
                break;
            }
            // A variable at a limit is fixed if the step would move it out of its range.
            let step = loop {
                let direction = self.newton_direction(&at, &pose, &tangent);
                let step = &tangent.basis * direction;
                let leaves = |k: &usize| {
                    (at.unit[*k] <= AT_LIMIT && step[*k] < 0.0)
                        || (at.unit[*k] >= 1.0 - AT_LIMIT && step[*k] > 0.0)
                };
                let outwards: Vec<usize> = (0..n).filter(|k| !blocked[*k]).filter(leaves).collect();
                if outwards.is_empty() {
                    break step;
                }
                outwards.into_iter().for_each(|k| blocked[k] = true);
                tangent = TangentSpace::new(&at, &jacobian, &blocked);
            };
            let Some((point, there)) = self.descend(&at, &pose, &tangent, &step)? else { break };
            let stays = point.unit == at.unit;
            (at, pose) = (point, there);
            if stays {
                break;
            }
        }
        Ok(Some((at, at_start)))
    }

    /// Returns a point of lower value along `step`, moved back to the self-motion; `None` if no step length lowers the value.
    fn descend(
        &self,
        at: &Point,
        pose: &Pose,
        tangent: &TangentSpace,
        step: &DVector<f64>,
    ) -> Result<Option<(Point, Pose)>, ExtremesError> {
        let n = at.unit.len();
        let slope: f64 = step.iter().zip(&at.gradient).map(|(s, g)| s * g).sum();
        // The step ends at the first limit.
        let to_limit = |k: usize| match step[k] {
            s if s > 0.0 => (1.0 - at.unit[k]) / s,
            s if s < 0.0 => at.unit[k] / -s,
            _ => f64::INFINITY,
        };
        let mut length = (LONGEST_STEP / step.amax()).min(1.0);
        length = (0..n).map(to_limit).fold(length, f64::min);
        if !(length > 0.0 && slope < 0.0) {
            return Ok(None);
        }
        for _ in 0..50 {
            let moved: Vec<f64> = (0..n).map(|k| (at.unit[k] + length * step[k]).clamp(0.0, 1.0)).collect();
            let snap = |x: f64| {
                if x <= AT_LIMIT {
                    0.0
                } else if x >= 1.0 - AT_LIMIT {
                    1.0
                } else {
                    x
                }
            };
            let moved: Vec<f64> = moved.into_iter().map(snap).collect();
            let fixed: Vec<bool> = (0..n)
                .map(|k| tangent.fixed[k] || (step[k] != 0.0 && (moved[k] == 0.0 || moved[k] == 1.0)))
                .collect();
            if let Some((unit, near)) = self.project(moved, Some(pose), &fixed)
                && let Some((mut point, there)) = self.point(unit, Some(&near))?
            {
                if point.has_value_of(at)
                    && let Some(jacobian) = self.kept_jacobian(&point.unit, &there)
                {
                    point.residual = TangentSpace::new(&point, &jacobian, &vec![false; n]).residual();
                }
                if point.value <= at.value + 1e-4 * length * slope || at.is_equal_but_worse_than(&point) {
                    return Ok(Some((point, there)));
                }
            }
            length *= 0.5;
        }
        Ok(None)
    }
}

/// Gauss-Newton step −C⁺c over the variables that are not fixed; a variable at a limit is fixed too if the step would move it out of
/// its range.
fn step_within(
    jacobian: &DMatrix<f64>,
    residuals: &DVector<f64>,
    unit: &[f64],
    fixed: &[bool],
) -> DVector<f64> {
    let n = unit.len();
    let mut fixed = fixed.to_vec();
    loop {
        let free: Vec<usize> = (0..n).filter(|k| !fixed[*k]).collect();
        let mut step = DVector::zeros(n);
        let reduced = Mat::from_fn(jacobian.nrows(), free.len(), |r, c| jacobian[(r, free[c])]);
        if let Ok(svd) = reduced.thin_svd() {
            let (u, sigma, v) = (svd.U(), svd.S().column_vector(), svd.V());
            let least = ZERO_SINGULAR * jacobian.amax();
            for k in (0..sigma.nrows()).filter(|k| sigma[*k] > least) {
                let along: f64 = (0..residuals.len()).map(|r| u[(r, k)] * residuals[r]).sum();
                free.iter()
                    .enumerate()
                    .for_each(|(c, &variable)| step[variable] -= v[(c, k)] * along / sigma[k]);
            }
        }
        let leaves = |k: &usize| (unit[*k] <= 0.0 && step[*k] < 0.0) || (unit[*k] >= 1.0 && step[*k] > 0.0);
        let outwards: Vec<usize> = free.into_iter().filter(leaves).collect();
        if outwards.is_empty() {
            return step;
        }
        outwards.into_iter().for_each(|k| fixed[k] = true);
    }
}
