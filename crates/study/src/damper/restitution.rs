//! Restitution of a given spring and damper, or of given parameters of a simulator.

use crate::damper::damped_contact::{drift, drift_diagnostic, finite_mass};
use crate::damper::damping::beyond_curve;
use crate::damper::sheet_forces::{sheet_curve, springs_finding};
use crate::evaluation::named_contact::{NamedContactRecord, named_contact};
use crate::evaluation::passed_stops::answer_findings;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::restitution::RestitutionQuestion;
use crate::values::force_curve::ForceCurveRecord;
use percuss_contact::exports::{ContactModel, SimulatedContact};
use schemars::JsonSchema;
use serde::Serialize;

/// Impact at one approach speed.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ReboundRecord {
    /// Solver or mode of the simulator; empty if there is only one.
    pub solver: &'static str,
    /// Approach speed, m/s.
    pub speed: f64,
    /// Rebound speed divided by approach speed.
    pub restitution: f64,
    /// Error bound of the restitution at the time step of the simulator; null if unknown, and without a simulator.
    pub error_bound: Option<f64>,
    /// Rebound speed, m/s.
    pub rebound_speed: f64,
    /// Duration of the contact, s; null for a rigid contact, for Adams, and if the gap never closes.
    pub contact_duration: Option<f64>,
    /// Largest penetration, m; null for a rigid contact.
    pub max_penetration: Option<f64>,
    /// Largest force, N; null for a rigid contact and for Adams.
    pub peak_force: Option<f64>,
    /// Lost energy, J.
    pub energy_lost: f64,
}

/// Penetration at rest.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RestRecord {
    /// Solver or mode of the simulator; empty if there is only one.
    pub solver: &'static str,
    /// Force along the normal, N.
    pub load: f64,
    /// Penetration, m; null for a rigid contact.
    pub penetration: Option<f64>,
}

/// Report of `percuss restitution`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct RestitutionReport {
    /// `percuss.restitution/1`.
    #[schemars(extend("const" = "percuss.restitution/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files; empty if the mass is given directly.
    pub inputs: Vec<Input>,
    /// m̄, kg.
    pub effective_mass: f64,
    /// Named contact; null for a contact given by link, point and normal.
    pub named_contact: Option<NamedContactRecord>,
    /// Simulator; null for a given spring and damper.
    pub tool: Option<String>,
    /// Force curve of the contact; null for a stiffness or a simulator.
    pub stiffness_curve: Option<ForceCurveRecord>,
    /// Impacts, for each solver in the order of the speeds.
    pub impacts: Vec<ReboundRecord>,
    /// Penetration at rest in each solver; empty without a load.
    pub at_rest: Vec<RestRecord>,
    /// Findings about the file and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Restitution for an effective mass, kg.
///
/// # Errors
/// [`StudyError`]: invalid keys, numbers out of range, overflow.
pub fn restitution(asked: &RestitutionQuestion, mass: f64) -> Result<RestitutionReport, StudyError> {
    asked.check()?;
    let contacts = asked.contacts(mass)?;
    let mut impacts = Vec::new();
    for contact in &contacts {
        for speed in &asked.speed {
            impacts.push(rebound(contact, mass, speed.0.value)?);
        }
    }
    let mut at_rest = Vec::new();
    if let Some(load) = asked.load {
        for contact in &contacts {
            let penetration = contact.penetration_at_rest(load.0)?;
            at_rest.push(RestRecord { solver: contact.solver, load: load.0, penetration });
        }
    }
    let curve = asked.stiffness_curve.as_ref();
    Ok(RestitutionReport {
        schema: "percuss.restitution/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: Vec::new(),
        effective_mass: mass,
        named_contact: None,
        tool: asked.tool.clone(),
        stiffness_curve: curve.map(Into::into),
        diagnostics: beyond_curve(curve, deepest(&impacts)).into_iter().collect(),
        impacts,
        at_rest,
    })
}

/// Largest penetration of several impacts, m; `None` for rigid contacts.
fn deepest(impacts: &[ReboundRecord]) -> Option<f64> {
    impacts.iter().filter_map(|impact| impact.max_penetration).reduce(f64::max)
}

/// Restitution at a contact of a model.
///
/// # Errors
/// [`StudyError`], as for `mass` and [`restitution`]; a contact without a finite mass, or with different masses on different branches; a
/// moment.
pub fn restitution_at(
    model: &Model,
    question: &MassQuestion,
    asked: &RestitutionQuestion,
) -> Result<RestitutionReport, StudyError> {
    asked.check()?;
    let question = &*question.resolve_contact(&model.mechanism)?;
    question.refuse_moment("restitution")?;
    let evaluated = EvaluatedQuestion::new(model, question)?;
    let EvaluatedQuestion { prepared, .. } = &evaluated;
    let mass = finite_mass(&evaluated)?;
    let stiffness_curve = if asked.has_law() { None } else { sheet_curve(model, question)? };
    let asked = &RestitutionQuestion {
        stiffness_curve: stiffness_curve.or(asked.stiffness_curve.clone()),
        ..asked.clone()
    };
    let mut report = restitution(asked, mass)?;
    let depth = deepest(&report.impacts);
    let (drift, ended) = drift(&evaluated, mass, depth);
    let consequence = "the result is for the mass at the touch: an impact in time includes the change";
    let names = prepared.question.names;
    report.diagnostics.extend(drift_diagnostic(&drift, ended.zip(depth), consequence, "mm", names));
    let contacts = asked.contacts(mass)?;
    let compliant = contacts.iter().find_map(|contact| match contact.model {
        ContactModel::Compliant(compliant, damper) => Some((contact.solver, (compliant, damper))),
        _ => None,
    });
    // The springs change the slowest impact most.
    let slowest = compliant.and_then(|(solver, law)| {
        let rows = report.impacts.iter().filter(|row| row.solver == solver);
        rows.min_by(|a, b| a.speed.total_cmp(&b.speed)).map(|row| (law, row))
    });
    let springs =
        slowest.and_then(|(law, row)| Some((law, row.speed, (row.contact_duration?, row.restitution))));
    let springs =
        springs.map(|(law, speed, alone)| springs_finding(&evaluated, law, speed, alone)).transpose()?;
    let named_contact = named_contact(&evaluated)?;
    let findings = answer_findings(&evaluated, named_contact.as_ref()).into_iter();
    let findings = findings.chain(springs.flatten()).map(DiagnosticRecord::from);
    Ok(RestitutionReport {
        inputs: prepared.inputs(),
        named_contact,
        diagnostics: model.diagnostics.iter().cloned().chain(report.diagnostics).chain(findings).collect(),
        ..report
    })
}

/// Impact of a contact at a speed.
fn rebound(contact: &SimulatedContact, mass: f64, speed: f64) -> Result<ReboundRecord, StudyError> {
    let impact = contact.impact(mass, speed)?;
    Ok(ReboundRecord {
        solver: contact.solver,
        speed,
        restitution: impact.restitution,
        error_bound: impact.error_bound,
        rebound_speed: impact.restitution * speed,
        contact_duration: impact.duration,
        max_penetration: impact.max_penetration,
        peak_force: impact.peak_force,
        energy_lost: impact.energy_lost,
    })
}
