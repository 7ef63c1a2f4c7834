//! Report of one contact of a model, as JSON.

use crate::damper::compliance::ComplianceRecord;
use crate::damper::damping::DampingReport;
use crate::evaluation::certificate::MassCertificateRecord;
use crate::evaluation::estimate::EstimateRecord;
use crate::evaluation::friction_thresholds::FrictionThresholdsRecord;
use crate::evaluation::motion_ratio::MotionRatioRecord;
use crate::evaluation::named_contact::NamedContactRecord;
use crate::evaluation::passed_stops::findings_with_ratios;
use crate::evaluation::prepared_question::{ContactResult, EvaluatedQuestion};
use crate::evaluation::status::{Status, mass_unit};
use crate::model::loading::Input;
use crate::model::loading::SheetPoint;
use crate::model::record::DiagnosticRecord;
use crate::pose::positions::{PoseLayout, Positions};
use crate::question::link_points::Hold;
use crate::question::mass_question::MassQuestion;
use crate::question::spelled_contact::StopRecord;
use crate::question::travel::given_travel::GivenTravel;
use crate::question::travel::moved::Moved;
use crate::reports::assumptions::Assumptions;
use crate::reports::explain::Explanation;
use crate::reports::tolerance::ToleranceReport;
use nalgebra::{Rotation3, UnitQuaternion};
use percuss_dynamics::{Base, EffectiveMass, Route};
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::Transform;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Share of a link in m̄.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BodyShare {
    /// The link.
    pub link: String,
    /// Mass of the link, kg; 0 for a link without inertia.
    pub mass: f64,
    /// Share of the kinetic energy at unit closing speed; null unless m̄ is finite.
    pub share: Option<f64>,
}

/// Share of a rotor in m̄.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RotorShare {
    /// Joint driven by the rotor.
    pub joint: String,
    /// Share of the kinetic energy at unit closing speed; null unless m̄ is finite.
    pub share: Option<f64>,
}

/// Contact, in the world frame and in the frame of the contact link.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ContactRecord {
    /// Contact link.
    pub link: String,
    /// Other link; null for the ground.
    pub against: Option<String>,
    /// Contact point, world frame, m.
    pub point_world: [f64; 3],
    /// Unit normal out of the contact link, world axes; the unit axis of a moment.
    pub normal_world: [f64; 3],
    /// Contact point, link's frame, m; the origin of the link for a moment, which has no point.
    pub point_link: [f64; 3],
    /// Unit normal out of the contact link, link's axes; the unit axis of a moment.
    pub normal_link: [f64; 3],
    /// True for a moment about an axis, and for the stop of a revolute joint: masses in kg·m², speeds in rad/s, impulses in N·m·s,
    /// forces in N·m.
    pub is_moment: bool,
}

/// Conditions of a result, sufficient to repeat the question.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct ConditionsRecord {
    /// `fixed` or `floating`.
    pub base: &'static str,
    /// Pose of the root link in the world, x, y, z (m), w, x, y, z; null at the origin of the world.
    pub base_pose: Option<[f64; 7]>,
    /// Joints locked by the question.
    pub lock: Vec<String>,
    /// Points held by the question.
    pub hold: Vec<HoldRecord>,
    /// Armatures that replace those of the model.
    pub armature: BTreeMap<String, Vec<f64>>,
    /// Mass of a free body on the other side, kg.
    pub against_mass: Option<f64>,
    /// Initial guesses of joint positions, as typed.
    pub guess: BTreeMap<String, String>,
    /// Travels that drove the pose.
    pub travel: Vec<TravelRecord>,
}

/// A travel that drove the pose.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TravelRecord {
    /// `point`, or the motion of the wheels: `wheel-travel`, `heave`, `roll`.
    pub motion: &'static str,
    /// The link; null for a motion of the wheels, as are the next two.
    pub link: Option<String>,
    /// The point, m, link's frame.
    pub point: Option<[f64; 3]>,
    /// Direction, world axes.
    pub direction: Option<[f64; 3]>,
    /// Displacement, m.
    pub distance: f64,
}

/// A held point.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct HoldRecord {
    /// The link.
    pub link: String,
    /// The point in the link's frame, m.
    pub point: [f64; 3],
    /// The normal in world axes; null if all three directions are held.
    pub normal: Option<[f64; 3]>,
}

impl From<GivenTravel> for TravelRecord {
    fn from(given: GivenTravel) -> Self {
        let distance = given.distance;
        match given.moved {
            Moved::Point { link, point, direction } => Self {
                motion: "point",
                link: Some(link),
                point: Some(point),
                direction: Some(direction),
                distance,
            },
            Moved::Wheels(motion) => {
                Self { motion: motion.name(), link: None, point: None, direction: None, distance }
            }
        }
    }
}

impl ConditionsRecord {
    /// Conditions of a question.
    pub(crate) fn of(question: &MassQuestion) -> Self {
        let hold = |h: &Hold| HoldRecord { link: h.link.clone(), point: h.point, normal: h.normal };
        Self {
            base: base_name(question.conditions.base()),
            base_pose: question.base_pose().map(seven_numbers),
            lock: question.conditions.lock.clone(),
            hold: question.hold.iter().map(hold).collect(),
            armature: question.conditions.armature.iter().cloned().collect(),
            against_mass: question.contact.against_mass(),
            guess: question
                .pose
                .guess
                .iter()
                .map(|(j, given)| (j.clone(), given.text().to_owned()))
                .collect(),
            travel: question.pose.travel.iter().cloned().map(TravelRecord::from).collect(),
        }
    }
}

/// Pose of the root link: x, y, z, then the quaternion w, x, y, z.
fn seven_numbers(base: &Transform<f64>) -> [f64; 7] {
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(base.rotation));
    let [x, y, z] = base.translation.into();
    [x, y, z, turn.w, turn.i, turn.j, turn.k]
}

/// Effective mass with the other kind of base, all else equal.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OtherBaseRecord {
    /// `fixed` or `floating`.
    pub base: &'static str,
    /// Root link, which this base holds or sets free.
    pub link: String,
    /// m̄ in the unit of the report; null unless finite.
    pub effective_mass: Option<f64>,
    /// Error bound of m̄, as `effective_mass_error`.
    pub effective_mass_error: Option<f64>,
    /// Kind of result.
    pub status: Status,
}

/// Name of a base in reports.
pub(crate) fn base_name(base: Base) -> &'static str {
    match base {
        Base::Fixed => "fixed",
        Base::Floating => "floating",
    }
}

/// Report of `percuss mass`, as JSON. All keys are always present; a value is null if not applicable.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct MassReport {
    /// `percuss.mass/1`.
    #[schemars(extend("const" = "percuss.mass/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// m̄ in the unit of `unit`; null unless finite.
    pub effective_mass: Option<f64>,
    /// Unit of all effective masses: `kg`; `kg·m²` for a moment about an axis, and for the stop of a revolute joint.
    pub unit: &'static str,
    /// Kind of result.
    pub status: Status,
    /// True if the pose is singular: A has a lower rank than at a generic pose.
    pub singular_pose: bool,
    /// dim ker A at the pose, including the 6 of a floating base.
    pub degrees_of_freedom: usize,
    /// dim ker A at a generic pose, including the 6 of a floating base.
    pub generic_degrees_of_freedom: usize,
    /// Number of linearly dependent constraint rows.
    pub redundant_constraints: usize,
    /// Gap between the singular values of A above and below the rank; null without loops.
    pub rank_gap: Option<f64>,
    /// Method: `dense` or `articulated`.
    pub route: &'static str,
    /// Condition number of the mass matrix scaled to unit diagonal; null if the matrix is singular or has more
    /// than 300 coordinates.
    pub condition: Option<f64>,
    /// Error bound of m̄, kg: sum of the known parts of the budget; null if the part of rounding or of loop
    /// closure is unknown.
    pub effective_mass_error: Option<f64>,
    /// Parts of the error bound.
    pub error_budget: ErrorBudgetRecord,
    /// Shares of the links, in file order.
    pub bodies: Vec<BodyShare>,
    /// Shares of the rotors.
    pub rotors: Vec<RotorShare>,
    /// Share of the other body, if given by its mass.
    pub other_mass_share: Option<f64>,
    /// Position of every movable joint, in the layout of `--set`.
    pub pose: Positions,
    /// Closure residual of the loops, m; null without loops.
    pub closure_residual: Option<f64>,
    /// Closure error of the loops as given in the file, m; null without loops.
    pub closure_inexactness: Option<f64>,
    /// Length that scales the rank decisions, m.
    pub characteristic_length: f64,
    /// The contact.
    pub contact: ContactRecord,
    /// Named contact; null for a contact given by link, point and normal.
    pub named_contact: Option<NamedContactRecord>,
    /// Stop of a joint as the contact; null for other contacts.
    pub joint_stop: Option<StopRecord>,
    /// Contact point in the unit and the axes of the suspension sheet, for text; `None` for a URDF.
    #[serde(skip)]
    pub point_in_sheet: Option<SheetPoint>,
    /// Conditions of the question.
    pub conditions: ConditionsRecord,
    /// m̄ with the chassis free, or held if the base floats; null unless the model is a suspension whose chassis has a mass.
    pub other_base: Option<OtherBaseRecord>,
    /// Joints that drive the loops.
    pub drivers: Vec<String>,
    /// Assembly mode of each group of loops: 1 or -1; 0 at a dead centre or a change point.
    pub assembly_modes: Vec<i8>,
    /// Loops and couplings with redundant rows; entries that cannot be separated form one group.
    pub redundant_loops: Vec<Vec<String>>,
    /// Limits of m̄ along the branches that cross at a singular pose, kg; null for a branch along which the gap
    /// does not close.
    pub branch_limits: Vec<Option<f64>>,
    /// Compliance of the bushes; null for a model without bushes.
    pub compliance: Option<ComplianceRecord>,
    /// Classical estimate, if requested.
    pub estimate: Option<EstimateRecord>,
    /// Motion ratios relative to the contact: of the wheel, if the mechanism has named wheel points and the
    /// ratio holds for every motion, and of requested points.
    pub motion_ratios: Vec<MotionRatioRecord>,
    /// Coefficients of friction for sticking, jamming and wedging, if requested; null without a single finite effective mass.
    pub friction_thresholds: Option<FrictionThresholdsRecord>,
    /// Sensitivities of m̄, if requested.
    pub explanation: Option<Explanation>,
    /// Proved bounds of m̄, if requested.
    pub certificate: Option<MassCertificateRecord>,
    /// Variation of m̄ within tolerances, if given.
    pub tolerance: Option<ToleranceReport>,
    /// Damper for a restitution, if requested.
    pub damper: Option<DampingReport>,
    /// Findings about the file and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// Assumptions of the result.
    #[serde(skip)]
    pub assumptions: Assumptions,
}

/// Parts of the error bound of m̄, kg; null if a part is unknown or m̄ is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ErrorBudgetRecord {
    /// Rounding of positions, frames and constraint rows, and of the computation.
    pub rounding: Option<f64>,
    /// Part due to the closure residual of the loops.
    pub closing: Option<f64>,
    /// Part due to inexact loops in the file.
    pub file: Option<f64>,
}

impl ErrorBudgetRecord {
    /// Error budget of a result.
    fn of(answer: &ContactResult) -> Self {
        let budget = answer.response.error.unwrap_or_default();
        Self { rounding: budget.rounding, closing: budget.closing, file: budget.file }
    }
}

impl MassReport {
    /// Report of an evaluated question. `of_wheels`: motion ratios of the wheels.
    pub(crate) fn of(
        evaluated: &EvaluatedQuestion,
        named_contact: Option<NamedContactRecord>,
        of_wheels: &[MotionRatioRecord],
    ) -> Self {
        let EvaluatedQuestion { prepared, pose, result: answer, .. } = evaluated;
        let (model, assembly) = (prepared.model, pose.assembly());
        let (mechanism, response) = (&model.mechanism, &answer.response);
        let link_name = |link: LinkId| mechanism.link(link).name().to_owned();
        let joint_name = |joint: JointId| mechanism.joint(joint).name().to_owned();
        let (status, effective_mass) = Status::classify(response.effective_mass);
        let shares = response.contributions.as_ref();
        let share_of = |i: usize| shares.map(|s| s.links.get(i).copied().unwrap_or(0.0));
        let rotors = shares.map_or(&[][..], |s| &s.rotors[..]);
        let assumptions = Assumptions::of(prepared, pose);
        let of_answer = findings_with_ratios(evaluated, named_contact.as_ref(), of_wheels);
        let of_answer = of_answer.into_iter().map(DiagnosticRecord::from);
        let limit_of = |l: &EffectiveMass| limit(l.against_mass(prepared.other_mass()));
        MassReport {
            schema: "percuss.mass/1",
            percuss: env!("CARGO_PKG_VERSION"),
            inputs: prepared.inputs(),
            effective_mass,
            unit: mass_unit(response.contact.is_moment),
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
                .map(|link| BodyShare {
                    link: link_name(link),
                    mass: mechanism.link(link).inertial().map_or(0.0, |inertial| inertial.mass),
                    share: share_of(link.index()),
                })
                .collect(),
            rotors: rotors
                .iter()
                .map(|&(joint, share)| RotorShare { joint: joint_name(joint), share: Some(share) })
                .collect(),
            other_mass_share: shares.and_then(|s| s.other_mass),
            pose: Positions::from_pose(&PoseLayout::new(mechanism), pose),
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
                is_moment: response.contact.is_moment,
            },
            named_contact,
            joint_stop: prepared
                .question
                .stop_of_joint(mechanism)
                .map(|(joint, motion)| StopRecord { joint: joint_name(joint), motion }),
            point_in_sheet: model.contact_in_sheet(
                &response.contact.point_world.into(),
                &response.contact.normal_world.into(),
            ),
            conditions: ConditionsRecord::of(&prepared.question),
            other_base: None,
            drivers: assumptions.drivers.clone(),
            assembly_modes: pose.loops().map_or_else(Vec::new, |l| l.modes.clone()),
            redundant_loops: assembly.redundant_loops().to_vec(),
            branch_limits: answer.limits.limits.iter().map(limit_of).collect(),
            compliance: None,
            estimate: answer.estimate.clone(),
            motion_ratios: Vec::new(),
            friction_thresholds: None,
            explanation: None,
            certificate: None,
            tolerance: None,
            damper: None,
            diagnostics: model.diagnostics.iter().cloned().chain(of_answer).collect(),
            assumptions,
        }
    }
}

/// Limit of m̄, kg, 0 for a massless branch; `None` if the gap does not close along the branch.
fn limit(limit: EffectiveMass) -> Option<f64> {
    match limit {
        EffectiveMass::Finite(m) => Some(m),
        EffectiveMass::Immovable => None,
        EffectiveMass::Massless => Some(0.0),
    }
}
