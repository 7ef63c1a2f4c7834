//! Classical estimate m_K / l̄² for comparison with the exact value.

use crate::pose::point_travel::reference_link;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::link_points::{EstimateQuestion, UPWARDS};
use crate::thresholds::{LARGEST_COORDINATE, SHORTEST_DIRECTION};
use nalgebra::Vector3;
use percuss_dynamics::{ContactResponse, EffectiveMass, PointVelocity, Pose};
use percuss_mechanism::{LinkId, Mechanism};
use percuss_suspension::kinematics::wheel_centres;
use schemars::JsonSchema;
use serde::Serialize;

/// Classical estimate m_K v_A²: mass of some links, all moving with the speed of point A. l̄ = 1/v_A is r_B/r_A of Euler's note
/// (Fayzullin 2018). v_A is the component of the velocity along a direction: the given one, or upwards in a suspension, as for
/// all motion ratios of a wheel. In other models without a direction, v_A is the magnitude of the velocity.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EstimateRecord {
    /// Links with a mass counted in m_K.
    pub links: Vec<String>,
    /// m_K, kg.
    pub mass: f64,
    /// Point A, in the first link's frame, m.
    pub point_link: [f64; 3],
    /// Direction of the speed of A, a unit vector in world axes; null for the magnitude of the velocity.
    pub direction: Option<[f64; 3]>,
    /// Motion ratio l̄: closing speed of the contact per speed of A, negative for a motion against the direction. Null if A does not
    /// move, or if a massless motion leaves its speed undetermined.
    pub motion_ratio: Option<f64>,
    /// m_K / l̄², kg.
    pub estimate: Option<f64>,
    /// Difference from the exact value, per cent.
    pub error_percent: Option<f64>,
    /// Share of the other links and of the rotors in the exact value; the estimate omits this share.
    pub share_left_out: Option<f64>,
}

/// Estimate with resolved names and checked numbers.
#[derive(Clone, Debug)]
pub(crate) struct PreparedEstimate {
    names: Vec<String>,
    links: Vec<LinkId>,
    /// m_K, kg.
    mass: f64,
    /// Point A, m, in the first link's frame.
    point: Vector3<f64>,
    /// Unit vector, world axes.
    direction: Option<Vector3<f64>>,
}

impl PreparedEstimate {
    /// Resolves the names and checks the numbers.
    pub fn new(mechanism: &Mechanism, question: &EstimateQuestion) -> Result<Self, StudyError> {
        let refuse = |fault: Fault| StudyError::input("contact.estimate", fault);
        let find = |name: &String| mechanism.find_link(name).map_err(|e| refuse(e.into()));
        let links = question.links.iter().map(find).collect::<Result<Vec<_>, _>>()?;
        if let Some(i) = (1..links.len()).find(|&i| links[..i].contains(&links[i])) {
            let link = &question.links[i];
            return Err(refuse(format!("the estimate names link \"{link}\" twice; name it once").into()));
        }
        if let Some(&value) =
            question.point.iter().find(|x| !(x.is_finite() && x.abs() <= LARGEST_COORDINATE))
        {
            let why = format!(
                "the estimate's point has a component {value:e}; expected a finite number of at most {LARGEST_COORDINATE:e}"
            );
            return Err(refuse(why.into()));
        }
        let is_suspension = !wheel_centres(mechanism, "").is_empty();
        let direction = question.direction.or(is_suspension.then_some(UPWARDS)).map(Vector3::from);
        if let Some(length) =
            direction.map(|d| d.norm()).filter(|n| !(*n >= SHORTEST_DIRECTION && n.is_finite()))
        {
            let why = format!(
                "the estimate's direction has length {length:e}; expected at least {SHORTEST_DIRECTION:e}"
            );
            return Err(refuse(why.into()));
        }
        Ok(Self {
            names: question.links.clone(),
            mass: links.iter().map(|l| mechanism.link(*l).inertia().mass).sum(),
            links,
            point: question.point.into(),
            direction: direction.map(|d| d.normalize()),
        })
    }

    /// Estimate for a contact response of the mechanism alone, without a free body on the other side.
    pub fn evaluate(&self, pose: &Pose, response: &ContactResponse) -> EstimateRecord {
        let reference = reference_link(pose, response);
        let velocity = |link: &LinkId| pose.point_velocity_against(response, *link, &self.point, reference);
        let velocity = self.links.first().and_then(velocity);
        let speed = match velocity {
            Some(PointVelocity::Known(v)) => Some(match &self.direction {
                // The velocity is in the axes of the root link, the direction in world axes.
                Some(d) => pose.base().vector(&v).dot(d),
                None => v.norm(),
            }),
            Some(PointVelocity::Undetermined) | None => None,
        };
        let estimate = speed.map(|speed| self.mass * speed * speed);
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
            direction: self.direction.map(Into::into),
            motion_ratio: speed.filter(|speed| *speed != 0.0).map(f64::recip),
            estimate,
            error_percent: estimate.zip(exact).map(|(e, m)| 100.0 * (e / m - 1.0)),
            share_left_out: taken.map(|t| 1.0 - t),
        }
    }
}
