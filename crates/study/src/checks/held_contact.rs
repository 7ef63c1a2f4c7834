//! Check of held contacts for tension: a held contact can push but not pull.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use crate::question::errors::question_error::StudyError;
use crate::question::names::Names;
use crate::thresholds::LIFT_OFF_SPEED;
use nalgebra::Vector3;
use percuss_dynamics::{Contact, ContactResponse, EffectiveMass, PointVelocity, Pose, ResponseError, System};
use percuss_mechanism::LinkId;

/// Contact held along a normal, and the mechanism without this contact.
#[derive(Debug)]
pub(crate) struct HeldContact {
    /// Number of the held contact in the question.
    pub number: usize,
    pub link: LinkId,
    /// Point, m, link's frame.
    pub point: Vector3<f64>,
    /// Normal, unit vector, world axes, out of the link.
    pub normal: Vector3<f64>,
    pub without: System,
}

impl HeldContact {
    /// Warning if the impact at a pose lifts the point off, so that the held contact would have to pull.
    /// `other`: mass of a free body on the other side, kg.
    pub fn lift_off_finding(
        &self,
        pose: &Pose,
        contact: &Contact,
        other: Option<f64>,
        names: Names,
    ) -> Result<Option<Finding>, StudyError> {
        let free = self.without.pose_like(pose)?;
        let response = free.respond(contact)?;
        let velocity = free.point_velocity_over_ground(&response, self.link, &self.point);
        // The impact changes the velocities by −v*: the point moves into the held surface if −v*·n > 0, and
        // lifts off if v*·n > 0.
        let lifts = match velocity {
            Some(PointVelocity::Known(v)) => pose.base().vector(&v).dot(&self.normal) > LIFT_OFF_SPEED,
            Some(PointVelocity::Undetermined) | None => false,
        };
        let name = self.without.mechanism().link(self.link).name();
        let subject = FindingSubject::Hold(self.number);
        let hold = names.hint("hold");
        if lifts {
            let message = format!(
                "the held contact of link \"{name}\"{hold} would need a pulling force: the impact separates it; \
                 without this held contact {}",
                mass_text(response, other)?
            );
            return Ok(Some(Finding::new(FindingKind::HoldPulls, subject, message)));
        }
        let finite = matches!(response.effective_mass, EffectiveMass::Finite(_));
        Ok((!finite || velocity == Some(PointVelocity::Undetermined)).then(|| {
            let message = format!(
                "without the held contact of link \"{name}\"{hold} the contact response is undetermined, so the \
                 sign of its force is unknown"
            );
            Finding::new(FindingKind::HoldUndetermined, subject, message)
        }))
    }
}

/// Effective mass, as text.
fn mass_text(response: ContactResponse, other: Option<f64>) -> Result<String, StudyError> {
    let with_other = match other {
        Some(other) => response.against_mass(other).map_err(ResponseError::from)?.effective_mass,
        None => response.effective_mass,
    };
    Ok(match with_other {
        EffectiveMass::Finite(m) => format!("the effective mass is {m} kg"),
        EffectiveMass::Immovable => "the contact is immovable".into(),
        EffectiveMass::Massless => "the contact is massless".into(),
    })
}
