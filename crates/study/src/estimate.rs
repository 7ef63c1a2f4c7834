//! The classical estimate m_K / l̄², set beside the exact value.

use crate::question::{EstimateQuestion, StudyError};
use nalgebra::Vector3;
use percuss_dynamics::{EffectiveMass, PointVelocity, Pose, Strike, System};
use serde::Serialize;

/// m_K |v_A|²: the mass of some links, as if all of it moved with point A; l̄ = 1/|v_A| is the seed's r_B/r_A.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EstimateRecord {
    /// The links whose mass it takes.
    pub links: Vec<String>,
    /// m_K, kg.
    pub mass: f64,
    /// Point A, in the first link's frame, m.
    pub point_link: [f64; 3],
    /// Speed of A (or its component, where a direction was given) per unit closing speed: the motion ratio
    /// "A over contact". Null where a massless motion leaves it open.
    pub motion_ratio: Option<f64>,
    /// Its inverse, the motion ratio "contact over A"; l̄.
    pub lever: Option<f64>,
    /// m_K / l̄², kg.
    pub estimate: Option<f64>,
    /// By how much it is off the exact value, per cent.
    pub error_percent: Option<f64>,
    /// Share of the exact value that other links and rotors carry: what it leaves out.
    pub share_left_out: Option<f64>,
}

/// Computes the estimate beside a strike. `exact` is the mechanism's own m̄, without a free body on the other side.
pub(crate) fn estimate(
    system: &System,
    pose: &Pose,
    strike: &Strike,
    question: &EstimateQuestion,
) -> Result<EstimateRecord, StudyError> {
    let mechanism = system.mechanism();
    let links = question.links.iter().map(|l| mechanism.find_link(l)).collect::<Result<Vec<_>, _>>()?;
    if let Some(i) = (1..links.len()).find(|&i| links[..i].contains(&links[i])) {
        return Err(StudyError::EstimateTwice { link: question.links[i].clone() });
    }
    if let Some(&value) = question.point.iter().find(|x| !(x.is_finite() && x.abs() <= 1e100)) {
        return Err(StudyError::EstimatePoint { value });
    }
    let direction = question.direction.map(Vector3::from);
    if let Some(length) = direction.map(|d| d.norm()).filter(|n| !(*n >= 1e-9 && n.is_finite())) {
        return Err(StudyError::EstimateDirection { length });
    }
    let mass: f64 = links.iter().map(|l| mechanism.link(*l).inertia().mass).sum();
    let velocity =
        links.first().and_then(|l| system.point_velocity(pose, strike, *l, &Vector3::from(question.point)));
    let motion_ratio = match velocity {
        Some(PointVelocity::Known(v)) => Some(match direction {
            // The velocity is in the root link's axes, the direction in the world's.
            Some(d) => pose.base().vector(&v).dot(&d.normalize()).abs(),
            None => v.norm(),
        }),
        Some(PointVelocity::Undetermined) | None => None,
    };
    let estimate = motion_ratio.map(|r| mass * r * r);
    let exact = match strike.effective_mass {
        EffectiveMass::Finite(m) => Some(m),
        EffectiveMass::Immovable | EffectiveMass::Massless => None,
    };
    let carried = strike.shares.as_ref().map(|s| links.iter().map(|l| s.links[l.index()]).sum::<f64>());
    Ok(EstimateRecord {
        links: question.links.clone(),
        mass,
        point_link: question.point,
        motion_ratio,
        lever: motion_ratio.filter(|r| *r > 0.0).map(|r| 1.0 / r),
        estimate,
        error_percent: estimate.zip(exact).map(|(e, m)| 100.0 * (e / m - 1.0)),
        share_left_out: carried.map(|c| 1.0 - c),
    })
}
