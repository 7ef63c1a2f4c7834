//! Response of a contact over frequency: apparent mass, accelerance, mobility, dynamic stiffness, and natural modes.

use crate::checks::finding_kind::FindingKind;
use crate::damper::compliance::{
    ComplianceRecord, UndampedImpactRecord, compliance, compliance_error, elastic_system, undamped_impacts,
};
use crate::evaluation::named_contact::{NamedContactRecord, named_contact};
use crate::evaluation::passed_stops::answer_findings;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::{Status, mass_unit};
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::response::ResponseQuestion;
use nalgebra::Complex;
use percuss_dynamics::{Mode, Receptance};
use percuss_mechanism::Mechanism;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;

/// Number of links and bushes that a mode names.
const NAMED_PARTS: usize = 3;

/// Stiffnesses of contacts relative to the residual stiffness.
const STIFFNESS_RATIOS: [f64; 7] = [0.001, 0.01, 0.1, 1.0, 10.0, 100.0, 1000.0];

/// Complex numbers over frequency; null where the response does not exist.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct ComplexSeries {
    /// Real parts.
    pub real: Vec<Option<f64>>,
    /// Imaginary parts.
    pub imaginary: Vec<Option<f64>>,
}

/// Natural mode of the mechanism with bushes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ModeRecord {
    /// Natural frequency, Hz; 0 for a motion without stiffness.
    pub frequency: f64,
    /// Damping ratio of dampers and loss factors, to first order.
    pub damping_ratio: f64,
    /// Participation φ² of the contact in the mass-normalised shape, 1/kg: 1/m_app = Σ φ² ω²/(ω² − ωᵢ²).
    pub participation: f64,
    /// Part of the mode in 1/m_free, from 0 to 1; null if the contact is massless with free bushes.
    pub share: Option<f64>,
    /// Links with their shares of the kinetic energy, the largest first, at most three: the first names the shape.
    pub links: Vec<ModeShareRecord>,
    /// Bushes, springs and directions with their shares of the elastic energy, the largest first, at most three.
    pub elements: Vec<ModeShareRecord>,
}

/// Share of a link or of an element in the energy of a mode.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ModeShareRecord {
    /// The link; the element with its direction.
    pub name: String,
    /// Share, from 0 to 1.
    pub share: f64,
}

/// Report of `percuss response`, as JSON. Units of a contact along a normal; N·m for N, rad for m and kg·m² for kg at a moment.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ResponseReport {
    /// `percuss.response/1`.
    #[schemars(extend("const" = "percuss.response/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Named contact; null for a contact given by link, point and normal.
    pub named_contact: Option<NamedContactRecord>,
    /// Contact link.
    pub link: String,
    /// m̄ with rigid bushes in the unit of `unit`; null unless finite.
    pub effective_mass: Option<f64>,
    /// Kind of result with rigid bushes.
    pub status: Status,
    /// Unit of masses: `kg`, or `kg·m²` for a moment about an axis.
    pub unit: &'static str,
    /// True for a moment about an axis.
    pub is_moment: bool,
    /// Free mass and residual stiffness; null for a model without bushes in place of joints.
    pub compliance: Option<ComplianceRecord>,
    /// Static stiffness of the contact, N/m; null if a motion without stiffness closes the gap.
    pub static_stiffness: Option<f64>,
    /// Frequencies, Hz.
    pub frequency: Vec<f64>,
    /// Apparent mass F/ẍ = −1/(ω²h), kg.
    pub apparent_mass: ComplexSeries,
    /// Accelerance ẍ/F, 1/kg.
    pub accelerance: ComplexSeries,
    /// Mobility ẋ/F, m/(N·s).
    pub mobility: ComplexSeries,
    /// Dynamic stiffness F/x = 1/h, N/m.
    pub dynamic_stiffness: ComplexSeries,
    /// Impacts on contacts without damping over their stiffness, with the elastic bushes and gears alone: from soft contacts, which meet the rigid
    /// mass, to stiff ones, which meet the free mass first; empty without bushes and gears.
    pub over_stiffness: Vec<UndampedImpactRecord>,
    /// Natural modes in ascending order of the frequency.
    pub modes: Vec<ModeRecord>,
    /// Findings about the file and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Response of a contact of a model with bushes, springs and dampers of the sheet included.
///
/// # Errors
/// [`StudyError`]: as for [`mass`](crate::mass()); a mechanism that is too large; a gap that no motion closes.
pub fn response(
    model: &Model,
    question: &MassQuestion,
    asked: &ResponseQuestion,
) -> Result<ResponseReport, StudyError> {
    asked.check()?;
    let evaluated = EvaluatedQuestion::new(model, question)?;
    let (system, left_out) = elastic_system(&evaluated)?;
    if system.is_immovable() {
        let why = "no motion of the mechanism closes the gap, also with elastic bushes and gears: the contact has no response";
        return Err(StudyError::NoResult(why.to_owned()));
    }
    let frequency = asked.frequency.unwrap_or_default().values();
    let omega: Vec<f64> = frequency.iter().map(|f| TAU * f).collect();
    let found = system.receptance(&omega).map_err(compliance_error)?;
    let modes = system.modes().map_err(compliance_error)?;
    let (compliance, _) = compliance(&evaluated, None)?;
    let EvaluatedQuestion { prepared, result, .. } = &evaluated;
    let located = &result.response.contact;
    let (status, effective_mass) = Status::classify(result.response.effective_mass);
    let series = |of: fn(&Receptance) -> Complex<f64>| {
        let values = || found.iter().map(|at| at.as_ref().map(of));
        ComplexSeries {
            real: values().map(|value| Some(value?.re)).collect(),
            imaginary: values().map(|value| Some(value?.im)).collect(),
        }
    };
    let free = compliance.as_ref().and_then(|found| found.free_mass);
    let mut diagnostics = prepared.model.diagnostics.clone();
    let named_contact = named_contact(&evaluated)?;
    let mut findings = answer_findings(&evaluated, named_contact.as_ref());
    findings.retain(|finding| {
        !FindingKind::ELASTIC.contains(&finding.kind()) && finding.kind() != FindingKind::JointSprings
    });
    diagnostics.extend(findings.into_iter().chain(left_out).map(DiagnosticRecord::from));
    Ok(ResponseReport {
        schema: "percuss.response/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: prepared.inputs(),
        named_contact,
        link: model.mechanism.link(located.link).name().to_owned(),
        effective_mass,
        status,
        unit: mass_unit(located.is_moment),
        is_moment: located.is_moment,
        static_stiffness: system
            .static_compliance()
            .map_err(compliance_error)?
            .map(|h| 1.0 / h)
            .filter(|k| k.is_finite()),
        apparent_mass: series(Receptance::apparent_mass),
        accelerance: series(Receptance::accelerance),
        mobility: series(Receptance::mobility),
        dynamic_stiffness: series(Receptance::dynamic_stiffness),
        frequency,
        over_stiffness: match compliance.as_ref().and_then(|found| found.residual_stiffness) {
            Some(residual) => undamped_impacts(&evaluated, &STIFFNESS_RATIOS.map(|ratio| ratio * residual))?,
            None => Vec::new(),
        },
        modes: modes.iter().map(|mode| mode_record(&model.mechanism, mode, free)).collect(),
        compliance,
        diagnostics,
    })
}

/// Record of a mode. `free`: m̄ with free bushes, kg.
fn mode_record(mechanism: &Mechanism, mode: &Mode, free: Option<f64>) -> ModeRecord {
    let participation = mode.participation.powi(2);
    let links = mode.links.iter().take(NAMED_PARTS);
    let elements = mode.rows.iter().take(NAMED_PARTS);
    ModeRecord {
        frequency: mode.angular_frequency / TAU,
        damping_ratio: mode.damping_ratio,
        participation,
        share: free.map(|free| participation * free),
        links: links
            .map(|(link, share)| ModeShareRecord {
                name: mechanism.link(*link).name().to_owned(),
                share: *share,
            })
            .collect(),
        elements: elements
            .map(|(element, direction, share)| ModeShareRecord {
                name: format!("{element} {}", direction.name()),
                share: *share,
            })
            .collect(),
    }
}
