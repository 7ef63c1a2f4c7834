//! Impact of several contacts at once.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::checks::findings::collect_response_findings;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::question::errors::question_error::StudyError;
use crate::question::spelled_contact::FurtherContact;
use crate::question::tables::impact::ImpactQuestion;
use crate::reports::impact::errors::impact_error;
use crate::reports::impact::further_contacts::TouchingContact;
use crate::thresholds::SAME_FRICTION;
use nalgebra::DVector;
use percuss_dynamics::LocatedContact;
use percuss_impact::{
    ContactStiffness, Delassus, ImpactError, JointRates, RigidImpact, SimultaneousLaw, StickingImpact,
    simultaneous_impact, sticking_impact,
};
use percuss_spatial::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

/// One of several contacts.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TouchingRecord {
    /// Name of the contact, or its link and number.
    pub name: String,
    /// True for the stop of a joint.
    pub is_joint_stop: bool,
    /// True for a moment about an axis, and for the stop of a revolute joint: masses in kg·m², speeds in rad/s, impulses in N·m·s.
    pub is_moment: bool,
    /// Contact link.
    pub link: String,
    /// Point, world frame, m.
    pub point_world: [f64; 3],
    /// Normal out of the contact link, world axes.
    pub normal_world: [f64; 3],
    /// Gap at the pose: of a named contact, m; of the stop of a joint with limits, the distance of the joint from the stop, rad or m. The
    /// results assume a gap of zero. Null for other contacts, and for the first contact.
    pub gap: Option<f64>,
    /// Closing speed before the impact, m/s (rad/s for a moment, whose masses below are in kg·m²); negative if the gap opens.
    pub closing_speed: f64,
    /// Effective mass of the contact alone, kg; null if immovable.
    pub effective_mass: Option<f64>,
    /// Principal masses of the point, kg, ascending; null for a direction in which it cannot move. For a moment: principal inertias, kg·m².
    pub principal_masses: [Option<f64>; 3],
    /// Directions of the principal masses, world axes.
    pub principal_directions_world: [[f64; 3]; 3],
}

/// Rates of a joint after an impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RatesAfterRecord {
    /// The joint.
    pub joint: String,
    /// Velocities after the impact, rad/s or m/s.
    pub after: Vec<f64>,
}

/// Result of one law for several contacts without friction.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SimultaneousLawRecord {
    /// `newton`, `poisson` or `energetic`.
    pub law: &'static str,
    /// Normal impulse of each contact, N·s; null if redundant contacts leave it open, or if the contact cannot move.
    pub impulses: Vec<Option<f64>>,
    /// Opening speed of each contact after the impact, m/s; empty if the law has no solution.
    pub opening_speeds: Vec<f64>,
    /// Lost kinetic energy, J; null if the law has no solution.
    pub energy_loss: Option<f64>,
    /// True if the law creates energy: its result is not valid.
    pub creates_energy: bool,
    /// Rates of all movable joints after the impact.
    pub rates: Vec<RatesAfterRecord>,
    /// Reason why the law has no solution; null otherwise.
    pub refusal: Option<String>,
}

/// Plastic impact with sticking points.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StickingRecord {
    /// For each contact: true if it sticks, false if it lets go.
    pub sticks: Vec<bool>,
    /// Normal impulse of each contact, N·s; null if open.
    pub normal_impulses: Vec<Option<f64>>,
    /// Magnitude of the tangential impulse, N·s; null if open.
    pub tangential_impulses: Vec<Option<f64>>,
    /// Coefficient of friction that the sticking needs; null if open, and for contacts that let go.
    pub required_friction: Vec<Option<f64>>,
    /// Least coefficient of friction for which all these contacts can stick: with redundant contacts, over all distributions of the open
    /// impulses. Null if none suffices: a contact has a tangential impulse without a normal one.
    pub least_friction: Option<f64>,
    /// True if the given friction suffices for all contacts to stick; null without a given friction.
    pub friction_suffices: Option<bool>,
    /// Opening speed of each contact after the impact, m/s.
    pub opening_speeds: Vec<f64>,
    /// Lost kinetic energy, J.
    pub energy_loss: f64,
    /// Number of subsets of sticking contacts without pulling and closing contacts; that with the most contacts is given.
    pub consistent_subsets: usize,
    /// Names of the rates of the impact map: joints, with the number of the velocity, and `base`.
    pub coordinates: Vec<String>,
    /// Impact map Δ: q̇⁺ = Δ q̇⁻ over these rates.
    pub impact_map: Vec<Vec<f64>>,
    /// Rates of all movable joints after the impact.
    pub rates: Vec<RatesAfterRecord>,
}

/// Impact of several contacts at once.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SimultaneousRecord {
    /// The contacts; the first is that of all other results.
    pub contacts: Vec<TouchingRecord>,
    /// Delassus matrix W, 1/kg: three rows for each contact, the opening direction and two tangents. For a moment: angular velocities about
    /// these axes; its block is in 1/(kg·m²).
    pub delassus: Vec<Vec<f64>>,
    /// Axes of the rows: for each contact the opening direction and the two tangents, world axes.
    pub delassus_axes_world: Vec<[[f64; 3]; 3]>,
    /// Stiffness of each contact relative to the first, in the energetic law.
    pub stiffness_ratios: Vec<f64>,
    /// Exponent of the contact forces in the energetic law.
    pub contact_exponent: f64,
    /// Results of the laws without friction; empty for one contact.
    pub laws: Vec<SimultaneousLawRecord>,
    /// Largest difference of an opening speed between two laws, divided by the largest closing speed; null for one contact. If some
    /// contacts are moments and others forces, each speed is first multiplied by the square root of the effective mass (kg, or kg·m² for a
    /// moment) of its contact.
    pub spread: Option<f64>,
    /// Plastic impact with sticking points, if requested.
    pub sticking: Option<StickingRecord>,
}

/// Findings about the mass of a further contact: its impulse by the laws is as uncertain.
const ABOUT_MASS: [FindingKind; 4] = [
    FindingKind::NearlyImmovable,
    FindingKind::UncertainMass,
    FindingKind::UnknownError,
    FindingKind::MasslessToRounding,
];

/// Impact of several contacts, and findings about the masses of the further ones; `None` unless further contacts or sticking points are
/// requested.
pub(crate) fn simultaneous(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
    rigid: &RigidImpact,
) -> Result<Option<(SimultaneousRecord, Vec<Finding>)>, StudyError> {
    if question.also.is_empty() && !question.sticking {
        return Ok(None);
    }
    let EvaluatedQuestion { prepared, pose, result, .. } = evaluated;
    let refuse = |error: ImpactError| several_error(error, question);
    let mut located = vec![result.response.contact];
    let mut masses = vec![result.response.effective_mass.kilograms()];
    let mut names = vec![
        prepared.question.contact.at.clone().unwrap_or_else(|| prepared.question.contact.link().to_owned()),
    ];
    let (mut gaps, mut findings) = (vec![None], Vec::new());
    for contact in &question.also {
        let touching = TouchingContact::new(evaluated, contact)?;
        if question.sticking {
            touching.refuse_sticking()?;
        }
        let place = pose.locate(&touching.contact);
        located.push(place.map_err(StudyError::about("impact.also"))?);
        let response = pose.respond(&touching.contact)?;
        masses.push(response.effective_mass.kilograms());
        let found = collect_response_findings(
            &prepared.system,
            &touching.contact,
            &response,
            prepared.question.names,
        );
        let place = format!("at the further contact {}", touching.name);
        let about_mass = found.into_iter().filter(|finding| ABOUT_MASS.contains(&finding.kind()));
        findings.extend(about_mass.map(|finding| finding.with_place(&place)));
        names.push(touching.name);
        gaps.push(touching.gap);
    }
    let k = located.len();
    let mut delassus = Delassus::new(pose, &located).map_err(|error| refuse(error.into()))?;
    let mut velocities = delassus.velocities(pose, &rigid.before);
    if let Some(mass) = prepared.other_mass() {
        delassus.add_free_body(0, mass);
        velocities[0] = -rigid.closing_speed;
    }
    let ratios = match question.stiffness_ratio.len() {
        0 => vec![1.0; k],
        _ => question.stiffness_ratio.clone(),
    };
    let stiffness =
        ContactStiffness { ratios, exponent: question.contact_exponent.map_or(1.0, |exponent| exponent.0) };
    let speeds = DVector::from_fn(k, |i, _| velocities[3 * i]);
    // If the units differ (rad/s and m/s), each speed is divided by √W_ii = 1/√m̄: the squares are comparable energies.
    let is_mixed = located.iter().any(|contact| contact.is_moment != located[0].is_moment);
    let weight = |i: usize| if is_mixed { delassus.matrix()[(3 * i, 3 * i)].max(0.0).sqrt() } else { 1.0 };
    let weights: Vec<f64> = (0..k).map(weight).collect();
    let scaled = |speed: f64, i: usize| if weights[i] > 0.0 { speed / weights[i] } else { 0.0 };
    let closing = (0..k).map(|i| scaled(-velocities[3 * i], i)).fold(0.0, f64::max);
    let restitution: Vec<f64> = match question.also_restitution.len() {
        0 => vec![question.restitution(); k],
        _ => [question.restitution()].iter().chain(&question.also_restitution).copied().collect(),
    };
    let mut laws = Vec::new();
    if k > 1 {
        for law in SimultaneousLaw::ALL {
            let found = simultaneous_impact(&delassus, &speeds, &restitution, law, &stiffness);
            laws.push(match found {
                Ok(found) => {
                    let own = |row: usize| if row.is_multiple_of(3) { found.solution[row / 3] } else { 0.0 };
                    let impulses = DVector::from_fn(3 * k, |row, _| own(row));
                    let change = delassus.rate_change(pose, &impulses);
                    SimultaneousLawRecord {
                        law: law.name(),
                        impulses: found.impulses,
                        opening_speeds: found.after,
                        energy_loss: Some(found.energy_loss),
                        creates_energy: found.creates_energy,
                        rates: rates_after(evaluated, &rigid.before.plus_scaled(&change, 1.0)),
                        refusal: None,
                    }
                }
                // The other laws have results.
                Err(error) if has_other_laws(&error, &restitution) => SimultaneousLawRecord {
                    law: law.name(),
                    impulses: vec![None; k],
                    opening_speeds: Vec::new(),
                    energy_loss: None,
                    creates_energy: false,
                    rates: Vec::new(),
                    refusal: Some(error.to_string()),
                },
                Err(error) => return Err(refuse(error)),
            });
        }
    }
    let sticking = question
        .sticking
        .then(|| sticking_impact(&delassus, &velocities).map_err(refuse))
        .transpose()?
        .map(|found| sticking_record(evaluated, question, rigid, &delassus, &found));
    let base = pose.base();
    let world = |v: &Vector3<f64>| -> [f64; 3] { base.vector(v).into() };
    let contacts = (0..k).map(|i| {
        let principal = delassus.principal_masses(i);
        TouchingRecord {
            name: names[i].clone(),
            is_joint_stop: match i.checked_sub(1) {
                Some(further) => matches!(question.also[further], FurtherContact::JointStop { .. }),
                None => prepared.question.stop_of_joint(pose.mechanism()).is_some(),
            },
            is_moment: located[i].is_moment,
            link: pose.mechanism().link(located[i].link).name().to_owned(),
            point_world: point_world(evaluated, &located[i]),
            normal_world: located[i].normal_world.into(),
            gap: gaps[i],
            closing_speed: -velocities[3 * i],
            effective_mass: masses[i],
            principal_masses: [0, 1, 2].map(|c| Some(principal[c].0).filter(|mass| mass.is_finite())),
            principal_directions_world: [0, 1, 2].map(|c| world(&principal[c].1)),
        }
    });
    let axes = |i: usize| [0, 1, 2].map(|c| world(&delassus.axes(i).column(c).into_owned()));
    let w = delassus.matrix();
    let record = SimultaneousRecord {
        contacts: contacts.collect(),
        delassus: w.row_iter().map(|row| row.iter().copied().collect()).collect(),
        delassus_axes_world: (0..k).map(axes).collect(),
        stiffness_ratios: stiffness.ratios,
        contact_exponent: stiffness.exponent,
        spread: (k > 1).then(|| (0..k).map(|i| scaled(spread(&laws, i), i)).fold(0.0, f64::max) / closing),
        laws,
        sticking,
    };
    Ok(Some((record, findings)))
}

/// True if an error concerns one law only.
fn has_other_laws(error: &ImpactError, restitution: &[f64]) -> bool {
    match error {
        ImpactError::NoEnd { .. } | ImpactError::SlowContact { .. } => true,
        ImpactError::OutOfRange { got, .. } => restitution.contains(got),
        _ => false,
    }
}

/// Error of several contacts, about the part of the question at fault.
fn several_error(error: ImpactError, question: &ImpactQuestion) -> StudyError {
    match error {
        ImpactError::TooManyContacts { .. } | ImpactError::Mobility(_) if question.also.is_empty() => {
            StudyError::input("impact.sticking", error)
        }
        ImpactError::TooManyContacts { .. } | ImpactError::Mobility(_) => {
            StudyError::input("impact.also", error)
        }
        ImpactError::NoConsistentSubset => StudyError::input("impact.sticking", error),
        ImpactError::OutOfRange { got, .. } if question.contact_exponent == Some(got.into()) => {
            StudyError::input("impact.contact_exponent", error)
        }
        ImpactError::ContactValues { .. } | ImpactError::OutOfRange { .. } => {
            StudyError::input("impact.stiffness_ratio", error)
        }
        error => impact_error(error, question),
    }
}

/// Warning about results that depend on the units of forces and moments; `None` unless some contacts are moments and others forces.
///
/// A change of a unit scales rows and columns of W. Without redundant contacts, the laws of Newton and Poisson do not change.
pub(crate) fn unit_finding(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
    record: &SimultaneousRecord,
) -> Option<Finding> {
    let moments = record.contacts.iter().filter(|contact| contact.is_moment).count();
    if moments == 0 || moments == record.contacts.len() || record.laws.is_empty() {
        return None;
    }
    let names = evaluated.prepared.question.names;
    let mut reasons = Vec::new();
    if question.stiffness_ratio.is_empty() {
        reasons.push(format!(
            "the energetic law uses equal stiffnesses by default, 1 N·m/rad for each 1 N/m; expected their ratios{}",
            names.hint("impact.stiffness_ratio")
        ));
    }
    // Poisson's law multiplies the impulses p of compression by the coefficients of restitution. Redundant contacts leave the distribution
    // of p open. With equal coefficients, the speeds depend only on W p, which is determinate. A distribution among forces only, or among
    // moments only, does not depend on the units.
    let is_open = |is_moment: bool| {
        let of_kind = |law: &SimultaneousLawRecord| {
            let mut impulses = record.contacts.iter().zip(&law.impulses);
            impulses.any(|(contact, impulse)| contact.is_moment == is_moment && impulse.is_none())
        };
        record.laws.iter().filter(|law| law.refusal.is_none()).any(of_kind)
    };
    let differ = question.also_restitution.iter().any(|e| *e != question.restitution());
    if is_open(true) && is_open(false) && differ {
        reasons.push(format!(
            "Poisson's law distributes the impulses of redundant contacts by the least sum of squares of N·s and N·m·s; leave out a redundant contact{}",
            names.hint("impact.also")
        ));
    }
    (!reasons.is_empty()).then(|| {
        let message = format!(
            "some contacts are forces and others moments, and some results depend on the units N and N·m: {}",
            reasons.join("; ")
        );
        Finding::about_result(FindingKind::UnitOfContacts, message)
    })
}

/// Contact point in the world.
fn point_world(evaluated: &EvaluatedQuestion, contact: &LocatedContact) -> [f64; 3] {
    evaluated.pose.link(contact.link).point(&contact.point_link).into()
}

/// Rates of all movable joints.
fn rates_after(evaluated: &EvaluatedQuestion, rates: &JointRates) -> Vec<RatesAfterRecord> {
    let mechanism = evaluated.pose.mechanism();
    let movable = mechanism.joint_ids().filter(|id| mechanism.joint(*id).kind().dofs() > 0);
    movable
        .map(|id| RatesAfterRecord {
            joint: mechanism.joint(id).name().to_owned(),
            after: rates.joint(id).to_vec(),
        })
        .collect()
}

/// Largest difference between two laws in the opening speed of one contact.
fn spread(laws: &[SimultaneousLawRecord], contact: usize) -> f64 {
    let speeds = laws.iter().filter_map(|law| law.opening_speeds.get(contact).copied());
    let (least, most) = speeds.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), u| (a.min(u), b.max(u)));
    (most - least).max(0.0)
}

/// Record of a plastic impact.
fn sticking_record(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
    rigid: &RigidImpact,
    delassus: &Delassus,
    found: &StickingImpact,
) -> StickingRecord {
    let pose = &evaluated.pose;
    let required: Vec<Option<f64>> = found.contacts.iter().map(|c| c.required_friction).collect();
    let change = delassus.rate_change(pose, &found.impulses);
    let name = |(joint, k): (Option<percuss_mechanism::JointId>, usize)| {
        let name = joint.map_or("base", |joint| pose.mechanism().joint(joint).name());
        let single = joint.is_some_and(|joint| pose.mechanism().joint(joint).kind().dofs() == 1);
        if single { name.to_owned() } else { format!("{name}[{k}]") }
    };
    StickingRecord {
        sticks: found.contacts.iter().map(|c| c.sticks).collect(),
        normal_impulses: found.contacts.iter().map(|c| c.normal_impulse).collect(),
        tangential_impulses: found.contacts.iter().map(|c| c.tangential_impulse).collect(),
        friction_suffices: question
            .friction()
            .map(|mu| found.least_friction.is_some_and(|least| least <= mu * (1.0 + SAME_FRICTION))),
        least_friction: found.least_friction,
        required_friction: required,
        opening_speeds: found.contacts.iter().map(|c| c.opening_speed).collect(),
        energy_loss: found.energy_loss,
        consistent_subsets: found.consistent_subsets,
        coordinates: pose.coordinate_joints().into_iter().map(name).collect(),
        impact_map: found.map.row_iter().map(|row| row.iter().copied().collect()).collect(),
        rates: rates_after(evaluated, &rigid.before.plus_scaled(&change, 1.0)),
    }
}
