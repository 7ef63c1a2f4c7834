//! Impact in time with elastic bushes and gears, as a record.

use super::forces::{ActingForces, DirectionChangeRecord};
use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::compliance::{balanced_forces, compliance_error, gear_elements, has_elastic_joints};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::tables::impact::ImpactQuestion;
use crate::reports::impact::errors::impact_error;
use percuss_contact::{CompliantContact, Damper, StiffnessLaw};
use percuss_impact::{
    CompliantImpact, CompliantLaw, ContactEnd, ElementPeak, ImpactError, ImpactInTime, RigidImpact,
    TimeConditions, compliant_impact, compliant_impact_with_forces,
};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;

/// Damping ratio of the linear law near a contact law that is not linear.
const NEAR_RATIO: f64 = 0.1;

/// End of the contact of an impact with elastic bushes and gears.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ContactEndName {
    /// The sides separate.
    Separates,
    /// The sides separate at less than a fiftieth of the closing speed; the duration depends on details of the contact.
    Grazes,
    /// The sides do not separate.
    NoRebound,
}

/// Second touch after the separation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SecondHitRecord {
    /// Time since the first touch, s.
    pub time: f64,
    /// Closing speed, m/s.
    pub speed: f64,
}

/// Largest force of a bush, a spring, a damper, a tyre, a gear or an ideal joint.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ElementForceRecord {
    /// The bush, spring, damper, tyre, anti-roll bar or drive; the joint or loop of a gear or of an ideal bearing.
    pub element: String,
    /// Direction in the bush: `radial x`, `radial y`, `axial`, `conical x`, `conical y`, `torsional`; `motion` of a spring or damper, `twist` of a
    /// gear; null for the magnitude of the force of a bush or of an ideal joint.
    pub direction: Option<&'static str>,
    /// `N`, or `N·m` for a moment.
    pub unit: &'static str,
    /// Largest magnitude during the contact, N or N·m.
    pub peak_force: f64,
    /// Its time, s.
    pub peak_time: f64,
    /// Largest magnitude after the contact, for as long as the contact lasted or until the second touch; null without a separation.
    pub peak_force_after: Option<f64>,
    /// Force at each time, with the sign of the displacement, N or N·m.
    pub force: Vec<f64>,
}

/// Energies of an impact with elastic bushes and gears, J.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CompliantEnergyRecord {
    /// Kinetic energy at the touch.
    pub kinetic_before: f64,
    /// Kinetic energy at the end, vibrations included.
    pub kinetic_after: f64,
    /// Energy that bushes, springs and gears store at the end.
    pub stored: f64,
    /// Energy that bushes, dampers and gears take.
    pub dissipated: f64,
    /// Work that the contact takes.
    pub taken_by_contact: f64,
    /// Work of gravity, preloads, drives and of forces that are not linear.
    pub work_of_other_forces: f64,
    /// Error of the balance.
    pub residual: f64,
}

/// Impact in time with elastic bushes and gears, linear about the touch: small displacements, no geometric stiffness, whose effect
/// `with_geometric_stiffness` states. Units of a contact along a normal.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CompliantImpactRecord {
    /// Separation speed divided by closing speed; 0 without rebound.
    pub restitution: f64,
    /// End of the contact.
    pub end: ContactEndName,
    /// Duration of the contact, s; null without rebound.
    pub duration: Option<f64>,
    /// Largest penetration, m.
    pub max_penetration: f64,
    /// Largest force of the contact, N.
    pub peak_force: f64,
    /// Impulse P of the contact, N·s.
    pub impulse: f64,
    /// m_imp = P/(v⁻ + v⁺), kg: mass of a free body with the same impulse between the same speeds.
    pub impulse_mass: f64,
    /// Frequency f at which loss factors act as dampers, c = ηk/(2πf), Hz: that of the rigid mechanism on the contact.
    pub loss_frequency: f64,
    /// Size of an assumption: the same impact with the geometric stiffness of the preloads and springs, which forces on the wheels balance at the
    /// touch; null without such forces, or if they are in no balance.
    pub with_geometric_stiffness: Option<DirectionChangeRecord>,
    /// Second touch within the duration of the first contact; null if there is none.
    pub second_hit: Option<SecondHitRecord>,
    /// Energies.
    pub energy: CompliantEnergyRecord,
    /// Largest forces of bushes, springs, dampers, tyres and gears.
    pub elements: Vec<ElementForceRecord>,
    /// Times since the touch, s.
    pub times: Vec<f64>,
    /// Penetration at each time, m.
    pub penetration: Vec<f64>,
    /// Closing speed at each time, m/s.
    pub closing_speed: Vec<f64>,
    /// Force of the contact at each time, N.
    pub force: Vec<f64>,
}

/// Impact with elastic bushes and gears beside the impact in time of the rigid mechanism, `found`; `None` unless requested. A finding if the
/// geometric stiffness of forces at the touch has an unknown effect.
pub(super) fn compliant(
    evaluated: &EvaluatedQuestion,
    impact: &ImpactQuestion,
    rigid: &RigidImpact,
    (damper, contact): (Damper, CompliantContact),
    (conditions, acting): (&TimeConditions, &ActingForces),
    found: &ImpactInTime,
) -> Result<(Option<CompliantImpactRecord>, Option<Finding>), StudyError> {
    if !impact.compliance {
        return Ok((None, None));
    }
    let EvaluatedQuestion { pose, result, .. } = evaluated;
    if !has_elastic_joints(evaluated) {
        let why = "the model has no elastic bushes and gears: give bushes in the suspension sheet, <bushing> or <elastic> in the URDF, or gear_stiffness";
        return Err(InvalidKey::with_names("impact.compliance", why.to_owned()).into());
    }
    if damper.jumps_at_reversal() {
        let why = "it has no contact with a loss factor, whose force jumps; expected another law";
        return Err(InvalidKey::new("impact.compliance", why).into());
    }
    let force = |penetration: f64, rate: f64| damper.force(contact, penetration, rate);
    let law = match (contact.stiffness(), damper) {
        (
            StiffnessLaw::Power { coefficient: k, exponent: 1.0 },
            Damper::KelvinVoigt { coefficient: c, .. },
        ) => CompliantLaw { linear: [k, c], force: None },
        _ => {
            let stiffness = found.peak_force / found.max_penetration;
            let damping = 2.0 * NEAR_RATIO * (stiffness * contact.mass()).sqrt();
            CompliantLaw { linear: [stiffness, damping], force: Some(&force) }
        }
    };
    let gears = gear_elements(evaluated)?;
    let motion = (rigid.closing_speed, &rigid.before);
    let elements = acting.at_touch(evaluated);
    let with_forces = balanced_forces(evaluated, elements).map(|forces| {
        let touch = &result.response.contact;
        let found = compliant_impact_with_forces(pose, touch, motion, law, &gears, conditions, &forces?);
        found.map_err(|error| error.to_string())
    });
    let (with_forces, left_out) = match with_forces.transpose() {
        Ok(found) => (found, None),
        Err(why) => {
            let message =
                format!("the effect of the geometric stiffness of preloads and springs is unknown: {why}");
            (None, Some(Finding::about_result(FindingKind::NoGeometricStiffness, message)))
        }
    };
    let found = compliant_impact(pose, &result.response.contact, motion, law, &gears, conditions);
    let found = found.map_err(|error| match error {
        ImpactError::Compliance(error) => compliance_error(error),
        error => impact_error(error, impact),
    })?;
    let mut names: Vec<String> = acting.lines.iter().map(|(name, _)| name.clone()).collect();
    names.extend(conditions.springs.iter().map(|spring| {
        let is_bar = spring.other.is_some() && !acting.bars.is_empty();
        let joint = pose.mechanism().joint(spring.joint).name();
        if is_bar { "anti-roll bar".to_owned() } else { joint.to_owned() }
    }));
    names.extend(acting.tyres.iter().map(|(name, _)| format!("tyre at {name}")));
    let with_geometric_stiffness = with_forces
        .map(|found| DirectionChangeRecord { restitution: found.restitution, peak_force: found.peak_force });
    Ok((Some(CompliantImpactRecord { with_geometric_stiffness, ..record(&found, &names) }), left_out))
}

/// Record of an impact. `names`: names of the first elements.
fn record(found: &CompliantImpact, names: &[String]) -> CompliantImpactRecord {
    let element = |(i, peak): (usize, &ElementPeak)| {
        let name = peak.number.and_then(|number| names.get(number));
        ElementForceRecord {
            element: name.unwrap_or(&peak.element).clone(),
            direction: peak.direction.map(|direction| direction.name()),
            unit: if peak.is_moment { "N·m" } else { "N" },
            peak_force: peak.force,
            peak_time: peak.time,
            peak_force_after: peak.force_after,
            force: found.samples.iter().map(|sample| sample.elements[i]).collect(),
        }
    };
    let energy = found.energy;
    let samples = &found.samples;
    CompliantImpactRecord {
        restitution: found.restitution,
        end: match found.end {
            ContactEnd::Separates => ContactEndName::Separates,
            ContactEnd::Grazes => ContactEndName::Grazes,
            ContactEnd::NoRebound => ContactEndName::NoRebound,
        },
        duration: (found.end != ContactEnd::NoRebound).then_some(found.duration),
        max_penetration: found.max_penetration,
        peak_force: found.peak_force,
        impulse: found.impulse,
        impulse_mass: found.impulse_mass,
        loss_frequency: found.loss_frequency / TAU,
        with_geometric_stiffness: None,
        second_hit: found.second_hit.map(|hit| SecondHitRecord { time: hit.time, speed: hit.speed }),
        energy: CompliantEnergyRecord {
            kinetic_before: energy.kinetic_before,
            kinetic_after: energy.kinetic_after,
            stored: energy.stored,
            dissipated: energy.dissipated,
            taken_by_contact: energy.taken_by_contact,
            work_of_other_forces: energy.work_of_other_forces,
            residual: energy.residual(),
        },
        elements: found.elements.iter().enumerate().map(element).collect(),
        times: samples.iter().map(|sample| sample.time).collect(),
        penetration: samples.iter().map(|sample| sample.penetration).collect(),
        closing_speed: samples.iter().map(|sample| sample.rate).collect(),
        force: samples.iter().map(|sample| sample.force).collect(),
    }
}
