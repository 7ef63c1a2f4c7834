//! The classical estimate m_K / l̄², set beside the exact value.

use crate::error::{Fault, StudyError};
use crate::field::Field;
use crate::question::EstimateQuestion;
use crate::thresholds::{LARGEST_COORDINATE, SHORTEST_DIRECTION};
use nalgebra::Vector3;
use percuss_dynamics::{ContactResponse, EffectiveMass, PointVelocity, Pose};
use percuss_mechanism::{LinkId, Mechanism};
use serde::Serialize;

/// m_K |v_A|²: the mass of some links, as if all of it moved with point A; l̄ = 1/|v_A| is r_B/r_A of Euler's note
/// (Fayzullin 2018).
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
    /// Contribution of the other links and the rotors to the exact value: what the estimate leaves out.
    pub share_left_out: Option<f64>,
}

/// An estimate with its names resolved and its numbers checked.
#[derive(Clone, Debug)]
pub(crate) struct Estimate {
    names: Vec<String>,
    links: Vec<LinkId>,
    /// m_K, kg.
    mass: f64,
    /// Point A, m, in the first link's frame.
    point: Vector3<f64>,
    /// Unit vector, world axes.
    direction: Option<Vector3<f64>>,
}

impl Estimate {
    /// Resolves what is asked for.
    pub fn new(mechanism: &Mechanism, question: &EstimateQuestion) -> Result<Self, StudyError> {
        let refuse = |fault: Fault| StudyError::input(Field::Estimate, fault);
        let find = |name: &String| mechanism.find_link(name).map_err(|e| refuse(e.into()));
        let links = question.links.iter().map(find).collect::<Result<Vec<_>, _>>()?;
        if let Some(i) = (1..links.len()).find(|&i| links[..i].contains(&links[i])) {
            return Err(refuse(Fault::EstimateTwice { link: question.links[i].clone() }));
        }
        if let Some(&value) =
            question.point.iter().find(|x| !(x.is_finite() && x.abs() <= LARGEST_COORDINATE))
        {
            return Err(refuse(Fault::EstimatePoint { value }));
        }
        let direction = question.direction.map(Vector3::from);
        if let Some(length) =
            direction.map(|d| d.norm()).filter(|n| !(*n >= SHORTEST_DIRECTION && n.is_finite()))
        {
            return Err(refuse(Fault::EstimateDirection { length }));
        }
        Ok(Self {
            names: question.links.clone(),
            mass: links.iter().map(|l| mechanism.link(*l).inertia().mass).sum(),
            links,
            point: question.point.into(),
            direction: direction.map(|d| d.normalize()),
        })
    }

    /// The estimate beside a contact response: of the mechanism alone, without a free body on the other side.
    pub fn beside(&self, pose: &Pose, response: &ContactResponse) -> EstimateRecord {
        let velocity = self.links.first().and_then(|l| pose.point_velocity(response, *l, &self.point));
        let motion_ratio = match velocity {
            Some(PointVelocity::Known(v)) => Some(match &self.direction {
                // The velocity is in the root link's axes, the direction in the world's.
                Some(d) => pose.base().vector(&v).dot(d).abs(),
                None => v.norm(),
            }),
            Some(PointVelocity::Undetermined) | None => None,
        };
        let estimate = motion_ratio.map(|r| self.mass * r * r);
        let exact = match response.effective_mass {
            EffectiveMass::Finite(m) => Some(m),
            EffectiveMass::Immovable | EffectiveMass::Massless => None,
        };
        let shares = response.contributions.as_ref();
        let taken = shares.map(|s| self.links.iter().map(|l| s.links[l.index()]).sum::<f64>());
        EstimateRecord {
            links: self.names.clone(),
            mass: self.mass,
            point_link: self.point.into(),
            motion_ratio,
            lever: motion_ratio.filter(|r| *r > 0.0).map(|r| 1.0 / r),
            estimate,
            error_percent: estimate.zip(exact).map(|(e, m)| 100.0 * (e / m - 1.0)),
            share_left_out: taken.map(|t| 1.0 - t),
        }
    }
}
