//! Smallest gap of stops that cannot be reached.

use crate::pose::joined_travels::{JoinedTravels, joint_unit, move_drivers, positions};
use crate::thresholds::{
    APPROACH_ROUNDS, APPROACH_STEPS, FIRST_APPROACH_STEP, LEAST_APPROACH_STEP, LEAST_TANGENT_COSINE,
    LONGEST_APPROACH_STEP, NEAREST_ACCURACY, OTHER_DRIVERS, STATIONARY_GAPS, TRAVEL_TOLERANCE,
};
use nalgebra::{DMatrix, DVector};
use percuss_dynamics::{Configuration, Pose};
use percuss_mechanism::JointId;

/// Path on which one stop, or both stops of an axle, have closed the same part of their gaps.
///
/// Gᵢ is the displacement of travel i over its gap. For one stop the path is the motion of its driver q; for two stops it is
/// G₁(q) = G₂(q). Its parameter is the arc length of q (rad, or characteristic lengths), because dG/ds = 0 at the smallest gap: with G as the
/// parameter, the equations are singular at this pose.
pub(crate) struct ClosingPath<'a> {
    pub travels: &'a JoinedTravels,
    pub configuration: &'a Configuration,
    /// Gaps at the start of the travels, m.
    pub gaps: Vec<f64>,
}

/// End of the path.
pub(crate) struct PathEnd {
    /// Closed fraction of the gaps; 1 at the touch.
    pub closed: f64,
    pub pose: Pose,
    /// True if the gap increases again after this pose: no further part can be closed.
    pub is_minimum: bool,
}

/// Point of the path.
struct PathPoint {
    pose: Pose,
    /// Positions of the drivers.
    at: Vec<f64>,
    /// Unit vector dq/ds in the direction in which the path is followed.
    tangent: DVector<f64>,
    /// dG/ds.
    rate: f64,
    /// G.
    closed: f64,
}

impl ClosingPath<'_> {
    /// Pose with the largest closed part of the gaps on the path from `near`. The gap of a minimum is accurate to
    /// [`NEAREST_ACCURACY`]; `None` if the path cannot be followed from `near`.
    ///
    /// The path is followed in the direction of closing, until dG/ds changes its sign; the zero of dG/ds is found by linear
    /// interpolation. A touch (G = 1) ends the search.
    pub fn nearest(&self, near: &Pose) -> Option<PathEnd> {
        let mut drivers = self.travels.select_drivers(near)?;
        let mut here = self.point(&drivers, near, &positions(near, &drivers), None)?;
        let gap = self.gaps.iter().fold(0.0f64, |most, gap| most.max(gap.abs()));
        let (mut step, mut changes) = (FIRST_APPROACH_STEP, 0);
        // Distance to a point behind the smallest gap, and dG/ds there.
        let mut behind: Option<(f64, f64)> = None;
        let mut is_minimum = false;
        for _ in 0..APPROACH_STEPS {
            // dG/ds decreases to zero within the step: the gain is at most rate times step.
            let is_bounded = behind.is_some() || here.rate == 0.0;
            let is_near = is_bounded && here.rate * step * gap <= NEAREST_ACCURACY;
            is_minimum = is_near && here.closed < 1.0;
            if is_near || here.closed >= 1.0 {
                break;
            }
            match self.advanced(&drivers, &here, step) {
                Some(next) if next.rate >= 0.0 => {
                    here = next;
                    behind = behind.map(|(distance, rate)| (distance - step, rate));
                    step = f64::min(2.0 * step, LONGEST_APPROACH_STEP);
                }
                Some(next) => behind = Some((step, next.rate)),
                None => {
                    // A driver may be near its dead centre: the path continues with other drivers.
                    let others =
                        if changes < OTHER_DRIVERS { self.selected(&drivers, &here.pose) } else { None };
                    if let Some((others, next)) = others {
                        changes += 1;
                        (here, drivers, step, behind) = (next, others, FIRST_APPROACH_STEP, None);
                    } else if step > LEAST_APPROACH_STEP {
                        (step, behind) = (0.5 * step, None);
                    } else {
                        break;
                    }
                }
            }
            if let Some((distance, rate)) = behind {
                step = distance * here.rate / (here.rate - rate);
            }
        }
        Some(PathEnd { closed: here.closed, pose: here.pose, is_minimum })
    }

    /// Drivers selected at a pose, and the point of the path there; `None` if the same drivers are selected again.
    fn selected(&self, drivers: &[JointId], pose: &Pose) -> Option<(Vec<JointId>, PathPoint)> {
        let others = self.travels.select_drivers(pose).filter(|others| others != drivers)?;
        let point = self.point(&others, pose, &positions(pose, &others), None)?;
        Some((others, point))
    }

    /// Point of the path after a step along the tangent; `None` if the path turns too far or is not reached: a shorter step
    /// is needed.
    fn advanced(&self, drivers: &[JointId], from: &PathPoint, step: f64) -> Option<PathPoint> {
        let moved = |((at, tangent), driver): ((&f64, &f64), &JointId)| {
            at + step * tangent * joint_unit(&from.pose, *driver)
        };
        let at: Vec<f64> = from.at.iter().zip(from.tangent.iter()).zip(drivers).map(moved).collect();
        let next = self.point(drivers, &from.pose, &at, Some(&from.tangent))?;
        (next.tangent.dot(&from.tangent) > LEAST_TANGENT_COSINE).then_some(next)
    }

    /// Point of the path next to given positions of the drivers. `last`: tangent at the previous point; `None` for the
    /// direction in which the gaps close.
    fn point(
        &self,
        drivers: &[JointId],
        from: &Pose,
        at: &[f64],
        last: Option<&DVector<f64>>,
    ) -> Option<PathPoint> {
        let least_gap = self.gaps.iter().fold(f64::INFINITY, |least, gap| least.min(gap.abs()));
        let within = TRAVEL_TOLERANCE * from.mechanism().characteristic_length() / least_gap;
        let mut at = at.to_vec();
        let mut pose = move_drivers(self.configuration, drivers, from, &at).ok()?;
        for _ in 0..APPROACH_ROUNDS {
            let (closed, rates) = (self.closed_parts(&pose), self.rates(&pose, drivers)?);
            let (across, difference) = match closed[..] {
                [first, second] => (rates.row(1) - rates.row(0), second - first),
                _ => (rates.row(0).map(|_| 0.0), 0.0),
            };
            if difference.abs() <= within {
                let rates = rates.row(0).transpose();
                let tangent = tangent(&across.transpose(), &rates, last)?;
                let (rate, closed) = (rates.dot(&tangent), closed[0]);
                return Some(PathPoint { pose, at, tangent, rate, closed });
            }
            let factor = -difference / across.norm_squared();
            let correction = across * factor;
            for ((at, step), driver) in at.iter_mut().zip(correction.iter()).zip(drivers) {
                if !step.is_finite() || step.abs() > LONGEST_APPROACH_STEP {
                    return None;
                }
                *at += step * joint_unit(&pose, *driver);
            }
            pose = move_drivers(self.configuration, drivers, &pose, &at).ok()?;
        }
        None
    }

    /// Closed part of each gap.
    fn closed_parts(&self, pose: &Pose) -> Vec<f64> {
        let parts = self.travels.travels.iter().zip(&self.gaps);
        parts.map(|(travel, gap)| travel.displacement(pose) / gap).collect()
    }

    /// ∂Gᵢ/∂qⱼ, per radian or characteristic length.
    fn rates(&self, pose: &Pose, drivers: &[JointId]) -> Option<DMatrix<f64>> {
        let mut rates = DMatrix::zeros(self.gaps.len(), drivers.len());
        for (i, (travel, gap)) in self.travels.travels.iter().zip(&self.gaps).enumerate() {
            for (j, driver) in drivers.iter().enumerate() {
                rates[(i, j)] = travel.rate(pose, *driver)? * joint_unit(pose, *driver) / gap;
            }
        }
        Some(rates)
    }
}

/// Unit tangent of the path G₂ − G₁ = 0 in the plane of two drivers, normal to the gradient `across`; ±1 for one driver. At a
/// pose at which both gaps are stationary the gradient is zero, and the tangent is the last one.
fn tangent(across: &DVector<f64>, rates: &DVector<f64>, last: Option<&DVector<f64>>) -> Option<DVector<f64>> {
    let length = across.norm();
    let line = match across.as_slice() {
        [_] => DVector::from_element(1, 1.0),
        [x, y] if length > STATIONARY_GAPS => DVector::from_vec(vec![-y / length, *x / length]),
        _ => return last.cloned(),
    };
    let sense = last.map_or_else(|| rates.dot(&line), |last| last.dot(&line));
    Some(if sense < 0.0 { -line } else { line })
}
