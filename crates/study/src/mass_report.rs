//! The answer to one contact of a model, as it stands in JSON.

use crate::answer::{Answer, Answered};
use crate::assumptions::Assumptions;
use crate::damping::DampingReport;
use crate::estimate::EstimateRecord;
use crate::explain::Explanation;
use crate::given_travel::GivenTravel;
use crate::model::Input;
use crate::motion_ratio::MotionRatioRecord;
use crate::positions::{PoseLayout, Positions};
use crate::question::{Hold, MassQuestion};
use crate::record::DiagnosticRecord;
use crate::tolerance::ToleranceReport;
use percuss_dynamics::{Base, EffectiveMass, Route};
use percuss_mechanism::{JointId, LinkId};
use serde::Serialize;
use std::collections::BTreeMap;

/// Kind of answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// m̄ is a number.
    Finite,
    /// No admissible motion closes the gap.
    Immovable,
    /// A motion without energy closes the gap.
    Massless,
}

impl Status {
    /// What a contact response comes to, and its m̄ (kg) where it is finite.
    pub(crate) fn of(mass: EffectiveMass) -> (Self, Option<f64>) {
        match mass {
            EffectiveMass::Finite(m) => (Status::Finite, Some(m)),
            EffectiveMass::Immovable => (Status::Immovable, None),
            EffectiveMass::Massless => (Status::Massless, None),
        }
    }

    /// As it stands in JSON and CSV.
    pub fn name(self) -> &'static str {
        match self {
            Status::Finite => "finite",
            Status::Immovable => "immovable",
            Status::Massless => "massless",
        }
    }
}

/// The contribution of a link to m̄.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyShare {
    /// The link.
    pub link: String,
    /// Its share of the kinetic energy at unit closing speed; null unless the mass is finite.
    pub share: Option<f64>,
}

/// The contribution of a rotor to m̄.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RotorShare {
    /// The joint it drives.
    pub joint: String,
    /// Its share of the kinetic energy at unit closing speed; null unless the mass is finite.
    pub share: Option<f64>,
}

/// The contact, in the world and in the struck link.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ContactRecord {
    /// The struck link.
    pub link: String,
    /// The other link; null: the ground.
    pub against: Option<String>,
    /// m.
    pub point_world: [f64; 3],
    /// Unit vector out of the struck link.
    pub normal_world: [f64; 3],
    /// m.
    pub point_link: [f64; 3],
    /// Unit vector out of the struck link.
    pub normal_link: [f64; 3],
}

/// What an answer was asked under, so that it can be asked again.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ConditionsRecord {
    /// `fixed` or `floating`.
    pub base: &'static str,
    /// Joints held by the question.
    pub lock: Vec<String>,
    /// Points held by the question.
    pub hold: Vec<HoldRecord>,
    /// Armatures that replace those of the model.
    pub armature: BTreeMap<String, Vec<f64>>,
    /// Mass of a free body on the other side, kg.
    pub against_mass: Option<f64>,
    /// Where joints were looked for, as typed.
    pub guess: BTreeMap<String, String>,
    /// Travels that drove the pose.
    pub travel: Vec<TravelRecord>,
}

/// A travel that drove the pose.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TravelRecord {
    /// The link.
    pub link: String,
    /// The point in the link's frame, m.
    pub point: [f64; 3],
    /// The direction in world axes, as given.
    pub direction: [f64; 3],
    /// How far the point was displaced, m.
    pub distance: f64,
}

/// A held point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HoldRecord {
    /// The link.
    pub link: String,
    /// The point in the link's frame, m.
    pub point: [f64; 3],
    /// The normal in world axes; null holds three directions.
    pub normal: Option<[f64; 3]>,
}

impl From<GivenTravel> for TravelRecord {
    fn from(given: GivenTravel) -> Self {
        let GivenTravel { link, point, direction, distance } = given;
        Self { link, point, direction, distance }
    }
}

impl ConditionsRecord {
    pub(crate) fn of(question: &MassQuestion) -> Self {
        let hold = |h: &Hold| HoldRecord { link: h.link.clone(), point: h.point, normal: h.normal };
        Self {
            base: match question.base {
                Base::Fixed => "fixed",
                Base::Floating => "floating",
            },
            lock: question.lock.clone(),
            hold: question.hold.iter().map(hold).collect(),
            armature: question.armature.iter().cloned().collect(),
            against_mass: question.against_mass,
            guess: question.guess.iter().map(|(j, given)| (j.clone(), given.text().to_owned())).collect(),
            travel: question.travel.iter().cloned().map(TravelRecord::from).collect(),
        }
    }
}

/// `percuss mass`, as JSON. Keys are always present, null where they do not apply.
#[derive(Clone, Debug, Serialize)]
pub struct MassReport {
    /// `percuss.mass/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The files.
    pub inputs: Vec<Input>,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// Kind of answer.
    pub status: Status,
    /// Whether the pose is singular: fewer independent constraints than at a generic pose.
    pub singular_pose: bool,
    /// dim ker A at the pose, a floating base's 6 included.
    pub degrees_of_freedom: usize,
    /// The same at a generic pose.
    pub generic_degrees_of_freedom: usize,
    /// Constraint rows that add nothing.
    pub redundant_constraints: usize,
    /// Gap between the singular values of A that count and those that do not; null without loops.
    pub rank_gap: Option<f64>,
    /// `dense` or `articulated`.
    pub route: &'static str,
    /// Condition of the mass matrix scaled to unit diagonal; null where it is singular, or
    /// where there are more than 300 coordinates.
    pub condition: Option<f64>,
    /// What m̄ may be off by, kg: the sum of the budget's known parts; null where rounding or closing is unknown.
    pub effective_mass_error: Option<f64>,
    /// Its parts.
    pub error_budget: ErrorBudgetRecord,
    /// Contributions of the links, in file order.
    pub bodies: Vec<BodyShare>,
    /// Contributions of the rotors.
    pub rotors: Vec<RotorShare>,
    /// Share of the other body, where it was given as a number.
    pub other_mass_share: Option<f64>,
    /// Position of every movable joint, in the layout of `--set`.
    pub pose: Positions,
    /// How far loops are from closed, m; null without loops.
    pub closure_residual: Option<f64>,
    /// How inexact the file's loops are, m; null without loops.
    pub closure_inexactness: Option<f64>,
    /// The length that scales rank decisions, m.
    pub characteristic_length: f64,
    /// The contact.
    pub contact: ContactRecord,
    /// What the answer was asked under.
    pub conditions: ConditionsRecord,
    /// Joints that drive the loops.
    pub drivers: Vec<String>,
    /// For each group of loops, its assembly mode: 1, -1, or 0 at a dead centre or a change
    /// point.
    pub assembly_modes: Vec<i8>,
    /// Loops and couplings on which redundant rows lie, those that cannot be separated together.
    pub redundant_loops: Vec<Vec<String>>,
    /// At a singular pose, the limits of m̄ along the branches that cross, kg; null for one along which the gap does not
    /// close.
    pub branch_limits: Vec<Option<f64>>,
    /// The classical estimate, where it was asked for.
    pub estimate: Option<EstimateRecord>,
    /// Speeds of the wheel, where the mechanism knows it and has one travel, and of points asked for, beside the contact's.
    pub motion_ratios: Vec<MotionRatioRecord>,
    /// What m̄ depends on, where that was asked for.
    pub explanation: Option<Explanation>,
    /// What tolerances leave of m̄, where they were given.
    pub tolerance: Option<ToleranceReport>,
    /// The damper that gives the contact a restitution, where one was asked for.
    pub damper: Option<DampingReport>,
    /// What was found, in the file and in the answer.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// What the answer assumes.
    #[serde(skip)]
    pub assumptions: Assumptions,
}

/// The parts of the error of m̄, kg; null where nothing measures one, or m̄ is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ErrorBudgetRecord {
    /// Rounding of positions, frames, rows and of the computation.
    pub rounding: Option<f64>,
    /// What the loops' residual leaves open.
    pub closing: Option<f64>,
    /// How far the file's loops are from fitting.
    pub file: Option<f64>,
}

impl ErrorBudgetRecord {
    fn of(answer: &Answer) -> Self {
        let budget = answer.response.error.unwrap_or_default();
        Self { rounding: budget.rounding, closing: budget.closing, file: budget.file }
    }
}

impl MassReport {
    /// The report of an answer.
    pub(crate) fn of(answered: &Answered) -> Self {
        let Answered { prepared, pose, answer, .. } = answered;
        let (model, assembly) = (prepared.model, pose.assembly());
        let (mechanism, response) = (&model.mechanism, &answer.response);
        let link_name = |link: LinkId| mechanism.link(link).name().to_owned();
        let joint_name = |joint: JointId| mechanism.joint(joint).name().to_owned();
        let (status, effective_mass) = Status::of(response.effective_mass);
        let shares = response.contributions.as_ref();
        let share_of = |i: usize| shares.map(|s| s.links.get(i).copied().unwrap_or(0.0));
        let rotors = shares.map_or(&[][..], |s| &s.rotors[..]);
        let assumptions = Assumptions::of(prepared, pose);
        let of_answer = answer.findings.iter().cloned().map(DiagnosticRecord::from);
        let limit_of = |l: &EffectiveMass| limit(l.against_mass(prepared.other_mass()));
        MassReport {
            schema: "percuss.mass/1",
            percuss: env!("CARGO_PKG_VERSION"),
            inputs: prepared.inputs(),
            effective_mass,
            status,
            singular_pose: response.singular_pose,
            degrees_of_freedom: response.degrees_of_freedom,
            generic_degrees_of_freedom: assembly.degrees_of_freedom(),
            redundant_constraints: assembly.redundant_constraints(),
            rank_gap: assembly.rank_gap(),
            route: match response.route {
                Route::Dense => "dense",
                Route::Articulated => "articulated",
            },
            condition: pose.condition(),
            effective_mass_error: response.effective_mass_error(),
            error_budget: ErrorBudgetRecord::of(answer),
            bodies: mechanism
                .link_ids()
                .map(|link| BodyShare { link: link_name(link), share: share_of(link.index()) })
                .collect(),
            rotors: rotors
                .iter()
                .map(|&(joint, share)| RotorShare { joint: joint_name(joint), share: Some(share) })
                .collect(),
            other_mass_share: shares.and_then(|s| s.other_mass),
            pose: Positions::of(&PoseLayout::new(mechanism), pose),
            closure_residual: pose.loops().map(|l| l.residual),
            closure_inexactness: pose.loops().map(|l| l.inexactness),
            characteristic_length: mechanism.characteristic_length(),
            contact: ContactRecord {
                link: link_name(response.contact.link),
                against: response.contact.against.map(link_name),
                point_world: response.contact.point_world.into(),
                normal_world: response.contact.normal_world.into(),
                point_link: response.contact.point_link.into(),
                normal_link: response.contact.normal_link.into(),
            },
            conditions: ConditionsRecord::of(prepared.question),
            drivers: assumptions.drivers.clone(),
            assembly_modes: pose.loops().map_or_else(Vec::new, |l| l.modes.clone()),
            redundant_loops: assembly.redundant_loops().to_vec(),
            branch_limits: answer.limits.limits.iter().map(limit_of).collect(),
            estimate: answer.estimate.clone(),
            motion_ratios: Vec::new(),
            explanation: None,
            tolerance: None,
            damper: None,
            diagnostics: model.diagnostics.iter().cloned().chain(of_answer).collect(),
            assumptions,
        }
    }
}

/// A limit of m̄, kg; none for one along which the gap does not close.
fn limit(limit: EffectiveMass) -> Option<f64> {
    match limit {
        EffectiveMass::Finite(m) => Some(m),
        EffectiveMass::Immovable => None,
        EffectiveMass::Massless => Some(0.0),
    }
}
