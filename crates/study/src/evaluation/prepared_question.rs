//! Evaluation of a question, shared by all commands. [`PreparedQuestion`] resolves names, checks units and compiles the
//! conditions once; the contact is then evaluated at any number of poses.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::{FindingKind, FindingScope};
use crate::checks::findings::{
    collect_pose_findings, collect_response_findings, condition_findings, contact_findings, guess_findings,
    singular_pose_finding,
};
use crate::checks::held_contact::HeldContact;
use crate::evaluation::estimate::{EstimateRecord, PreparedEstimate};
use crate::evaluation::stop_not_reached::stop_not_reached;
use crate::model::loading::{Input, Model};
use crate::pose::pose_solver;
use crate::pose::touch::StopOfJoint;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::mass_question::MassQuestion;
use crate::question::names::{Names, conditions_error_key};
use crate::question::pose_file::{GivenPose, GivenPoseError};
use crate::thresholds::LEAST_OTHER_MASS;
use crate::values::position::GivenPosition;
use nalgebra::Vector3;
use percuss_dynamics::{
    Base, BranchLimits, Conditions, Configuration, ConfigurationError, Contact, ContactError,
    ContactResponse, Direction, EffectiveMass, Frame, LowestPoint, Pose, ResponseError, System,
};
use percuss_mechanism::{Closure, JointId, JointKind, LinkId, Mechanism, UnknownName};
use percuss_suspension::kinematics::{RACK, wheel_centres, wheel_of_patch};
use std::borrow::Cow;
use std::sync::Arc;

/// Question with resolved names, numbers in SI units and compiled conditions.
#[derive(Debug)]
pub(crate) struct PreparedQuestion<'a> {
    pub model: &'a Model,
    /// Question with the named contact resolved.
    pub question: Cow<'a, MassQuestion>,
    pub system: System,
    /// Positions requested by `--set` and `--guess`.
    pub configuration: Configuration,
    link: LinkId,
    against: Option<LinkId>,
    normal: Direction,
    /// Wheel, if the contact is its patch.
    wheel: Option<LowestPoint>,
    estimate: Option<PreparedEstimate>,
    held_contacts: Vec<HeldContact>,
}

/// Result of a contact at one pose.
#[derive(Debug)]
pub(crate) struct ContactResult {
    /// Contact response, including a free body on the other side.
    pub response: ContactResponse,
    /// Response of the mechanism alone; set only if there is a free body on the other side.
    mechanism_response: Option<ContactResponse>,
    /// Limits of m̄ of the mechanism alone along the branches of a singular pose; empty at a regular pose.
    pub limits: BranchLimits,
    /// Classical estimate, if requested.
    pub estimate: Option<EstimateRecord>,
    /// Findings to report.
    pub findings: Vec<Finding>,
}

impl ContactResult {
    /// The contact response of the mechanism alone, without a free body on the other side.
    pub fn mechanism_response(&self) -> &ContactResponse {
        self.mechanism_response.as_ref().unwrap_or(&self.response)
    }

    /// Limits of m̄ along the branches, if all branches are known and their number is finite. The limits then
    /// bound every mass that a motion from the pose can have.
    pub fn complete_branch_limits(&self) -> Option<&[EffectiveMass]> {
        let limits = &self.limits;
        (limits.complete && !limits.continuous && !limits.limits.is_empty()).then_some(&limits.limits)
    }

    /// Findings of a regular pose with a finite m̄ that hold for all poses of its branch. `None` if another finding than
    /// that of the joint limits depends on the pose.
    pub fn into_branch_findings(self) -> Option<Vec<Finding>> {
        let finite = matches!(self.response.effective_mass, EffectiveMass::Finite(_));
        let scope = |finding: &Finding| finding.kind().scope();
        let of_branch = |finding: &Finding| scope(finding).covers_branch();
        let plain = |finding: &Finding| of_branch(finding) || scope(finding) == FindingScope::Positions;
        let regular = finite && !self.response.singular_pose && self.findings.iter().all(plain);
        regular.then(|| self.findings.into_iter().filter(of_branch).collect())
    }
}

impl<'a> PreparedQuestion<'a> {
    /// Resolves a question.
    pub fn new(model: &'a Model, question: &'a MassQuestion) -> Result<Self, StudyError> {
        let mechanism = &model.mechanism;
        let mut resolved = question.resolve_contact(mechanism)?;
        let refuse = |error: GivenPoseError| StudyError::input("pose.file", error);
        let pose = question.positions.as_ref().map(|pose| pose.resolve(model)).transpose().map_err(refuse)?;
        if let Some(pose) = pose.flatten() {
            resolved.to_mut().positions = Some(pose);
        }
        let question = &*resolved;
        let find =
            |field: &'static str, name: &str| mechanism.find_link(name).map_err(StudyError::about(field));
        let link = find("contact.link", question.contact.link())?;
        let against = match &question.contact.against {
            Some(name) => other_side(mechanism, name).map_err(StudyError::about("contact.against"))?,
            None => None,
        };
        let normal = question.contact.direction(mechanism)?;
        if let Some(mass) =
            question.contact.against_mass().filter(|m| !(m.is_finite() && *m > LEAST_OTHER_MASS))
        {
            let why = format!(
                "the other body's mass is {mass:e} kg; expected a finite number above 0 ({LEAST_OTHER_MASS:e} at least)"
            );
            return Err(StudyError::input("contact.against_mass", why));
        }
        if let Some(mass) = question.contact.against_mass().filter(|_| normal.is_moment()) {
            return Err(StudyError::input("contact.against_mass", ContactError::MassOfMoment { mass }));
        }
        if question.contact.estimate.is_some() {
            question.refuse_moment("classical estimate")?;
        }
        let compile = |skipped| compile(mechanism, question, skipped);
        let system = compile(None)?;
        let estimate =
            question.contact.estimate.as_ref().map(|e| PreparedEstimate::new(mechanism, e)).transpose()?;
        let mut held = Vec::new();
        for (number, hold) in question.hold.iter().enumerate() {
            if let Some(normal) = hold.normal {
                held.push(HeldContact {
                    number,
                    link: find("hold", &hold.link)?,
                    point: hold.point.into(),
                    normal: Vector3::from(normal).normalize(),
                    without: compile(Some(number))?,
                });
            }
        }
        let configuration = configuration(mechanism, question)?;
        let named = question.named_contact(mechanism)?;
        let wheel = named.and_then(|contact| wheel_of_patch(mechanism, contact));
        Ok(Self {
            model,
            question: resolved,
            system,
            configuration,
            link,
            against,
            normal,
            wheel,
            estimate,
            held_contacts: held,
        })
    }

    /// Link on the other side; `None` for the ground.
    pub fn other_link(&self) -> Option<LinkId> {
        self.against
    }

    /// Mass of a free body on the other side, kg.
    pub fn other_mass(&self) -> Option<f64> {
        self.question.contact.against_mass()
    }

    /// True if only m̄ of the mechanism alone is required, at a point of the link: no estimate, no held contact, no free
    /// body, no wheel whose lowest point moves.
    pub fn needs_only_mass(&self) -> bool {
        self.wheel.is_none()
            && self.estimate.is_none()
            && self.question.hold.is_empty()
            && self.other_mass().is_none()
    }

    /// True if a held contact can only push, so that each contact has a finding of its own about its force.
    pub fn holds_by_pushing(&self) -> bool {
        !self.held_contacts.is_empty()
    }

    /// True if the contact point is given in the frame of the contact link; the conversion then needs no pose.
    pub fn point_is_in_link(&self) -> bool {
        self.question.contact.frame() == Frame::Link
    }

    /// Contact at a pose. A point given in another frame is converted to the frame of the contact link at this
    /// pose and is fixed to the link from then on. A contact patch is the lowest point of its wheel.
    pub fn contact_at(&self, pose: &Pose) -> Contact {
        let given = Vector3::from(self.question.contact.point());
        let lowest = self.wheel.as_ref().and_then(|wheel| wheel.at(pose));
        let point = lowest.unwrap_or_else(|| {
            pose.point_in_link(self.link, self.against, self.question.contact.frame(), given)
        });
        Contact { link: self.link, against: self.against, point, normal: self.normal }
    }

    /// Wheel, if the contact is its patch: the contact point then moves on its link.
    pub fn wheel(&self) -> Option<&LowestPoint> {
        self.wheel.as_ref()
    }

    /// Contact of a row of a sweep with the contact `fixed` to its link, as [`contact_at`](Self::contact_at).
    pub fn contact_of_row(&self, fixed: &Contact, pose: &Pose) -> Contact {
        if self.wheel.is_some() { self.contact_at(pose) } else { *fixed }
    }

    /// Contact with its point as given, in the frame of the contact link.
    pub fn contact_in_link(&self) -> Contact {
        let point = Vector3::from(self.question.contact.point());
        Contact { link: self.link, against: self.against, point, normal: self.normal }
    }

    /// Contact, if the point is given in the frame of the contact link.
    pub fn pose_independent_contact(&self) -> Option<Contact> {
        self.point_is_in_link().then(|| self.contact_in_link())
    }

    /// Finding that reports the converted coordinates of a point given in another frame; `condition` names the pose
    /// of the conversion.
    pub fn converted_point_finding(&self, contact: &Contact, condition: &str) -> Option<Finding> {
        let frame = match self.question.contact.frame() {
            Frame::Link => return None,
            Frame::World => "world",
            Frame::Against => "against",
        };
        let given = match self.question.names {
            Names::Fields => frame.to_owned(),
            Names::Flags => format!("--frame {frame}"),
            Names::Keys(_) => format!("contact.frame = \"{frame}\""),
        };
        let [x, y, z]: [f64; 3] = contact.point.into();
        let link = self.system.mechanism().link(contact.link).name();
        let message = format!(
            "the contact point given in another frame ({given}) is {x},{y},{z} m in the frame of link \"{link}\", converted \
             {condition}; it moves with the link"
        );
        Some(Finding::new(FindingKind::PointConverted, FindingSubject::Link(contact.link), message))
    }

    /// Findings about unused or distant guesses, and about a pose file that belongs to another model.
    pub fn guess_findings(&self, pose: &Pose) -> Vec<Finding> {
        let question = &self.question;
        let mut found =
            guess_findings(&self.system, pose, &self.configuration, &question.pose.guess, question.names);
        let other = question
            .positions
            .as_ref()
            .and_then(|file| file.model_mismatch_message(self.model, question.names));
        found.extend(other.map(|message| Finding::about_result(FindingKind::PoseOfAnotherFile, message)));
        found
    }

    /// Findings about a pose and the conditions, without those of a contact.
    pub fn pose_findings(&self, pose: &Pose) -> Vec<Finding> {
        let mut found = collect_pose_findings(&self.system, pose, self.question.names);
        found.extend(condition_findings(&self.system, &self.question));
        found.extend(self.guess_findings(pose));
        found
    }

    /// Findings about a pose and its contact, for results that begin at this pose and hold for others.
    pub fn start_findings(&self, pose: &Pose, contact: &Contact) -> Vec<Finding> {
        let mut found = self.pose_findings(pose);
        found.extend(contact_findings(&self.system, contact, self.question.names));
        found.extend(self.converted_point_finding(contact, "at the given pose"));
        found
    }

    /// Input files: model, study and pose.
    pub fn inputs(&self) -> Vec<Input> {
        let pose = self.question.positions.iter().filter_map(GivenPose::file);
        self.model.inputs.iter().chain(pose).cloned().collect()
    }

    /// Pose requested by the question.
    pub fn pose(&self) -> Result<Pose, StudyError> {
        let posed = pose_solver::pose(&self.system, &self.configuration, &self.question);
        posed.map_err(|error| error.in_unit(self.model.length_unit()))
    }

    /// Contact response, branch limits, estimate and findings at a pose.
    pub fn evaluate(&self, pose: &Pose, contact: &Contact) -> Result<ContactResult, StudyError> {
        let (system, names) = (&self.system, self.question.names);
        let response = pose.respond(contact)?;
        let mut findings = collect_pose_findings(system, pose, names);
        findings.extend(condition_findings(system, &self.question));
        findings.extend(self.findings_of_response(pose, contact, &response)?);
        let limits =
            if response.singular_pose { pose.branch_limits(contact) } else { BranchLimits::default() };
        findings.extend(singular_pose_finding(pose, &response, &limits));
        let estimate = self.estimate.as_ref().map(|e| e.evaluate(pose, &response));
        let Some(other) = self.other_mass() else {
            return Ok(ContactResult { response, mechanism_response: None, limits, estimate, findings });
        };
        let with_other = response.clone().against_mass(other).map_err(ResponseError::from)?;
        Ok(ContactResult {
            response: with_other,
            mechanism_response: Some(response),
            limits,
            estimate,
            findings,
        })
    }

    /// Findings about the response of a contact, without those of its pose. `response`: that of the mechanism alone.
    pub fn findings_of_response(
        &self,
        pose: &Pose,
        contact: &Contact,
        response: &ContactResponse,
    ) -> Result<Vec<Finding>, StudyError> {
        let names = self.question.names;
        // A question about a stop states its gap as a result.
        let is_stated =
            |finding: &Finding| finding.kind() == FindingKind::OpenGap && self.question.contact.at.is_some();
        let as_note = |finding| if is_stated(&finding) { finding.into_note() } else { finding };
        let of_response = collect_response_findings(&self.system, contact, response, names);
        let mut findings: Vec<Finding> = of_response.into_iter().map(as_note).collect();
        for held in &self.held_contacts {
            findings.extend(held.lift_off_finding(pose, contact, self.other_mass(), names)?);
        }
        if self.other_mass().is_some() && response.effective_mass == EffectiveMass::Immovable {
            let message = format!(
                "the mechanism is immovable at this contact: the result is the mass of the other body alone{}",
                names.hint("contact.against_mass")
            );
            findings.push(Finding::about_result(FindingKind::ImmovableMechanism, message));
        }
        Ok(findings)
    }

    /// Contact response at a pose, including a free body on the other side, without findings or limits.
    pub fn response(&self, pose: &Pose, contact: &Contact) -> Result<ContactResponse, StudyError> {
        let response = pose.respond(contact)?;
        Ok(match self.other_mass() {
            Some(other) => response.against_mass(other).map_err(ResponseError::from)?,
            None => response,
        })
    }

    /// Effective mass at a pose, including a free body on the other side, without findings or limits.
    pub fn effective_mass(&self, pose: &Pose, contact: &Contact) -> Result<EffectiveMass, StudyError> {
        Ok(self.response(pose, contact)?.effective_mass)
    }
}

/// Result of a question at its own pose.
#[derive(Debug)]
pub(crate) struct EvaluatedQuestion<'a> {
    pub prepared: PreparedQuestion<'a>,
    pub pose: Pose,
    pub contact: Contact,
    pub result: ContactResult,
}

impl<'a> EvaluatedQuestion<'a> {
    /// Evaluates a question at its own pose.
    pub fn new(model: &'a Model, question: &'a MassQuestion) -> Result<Self, StudyError> {
        let prepared = PreparedQuestion::new(model, question)?;
        let pose = prepared.pose()?;
        let contact = prepared.contact_at(&pose);
        let mut answer = prepared.evaluate(&pose, &contact)?;
        answer.findings.extend(prepared.converted_point_finding(&contact, "at the pose of the answer"));
        answer.findings.extend(prepared.guess_findings(&pose));
        let mechanism = &model.mechanism;
        let stop = StopOfJoint::of_question(mechanism, &prepared.question)?;
        answer.findings.extend(stop.and_then(|stop| stop_not_reached(&pose, &stop, prepared.question.names)));
        Ok(Self { prepared, pose, contact, result: answer })
    }
}

/// Name of all joints in `lock`, unless a joint has this name.
const EVERY_JOINT: &str = "all";

/// Compiles the mechanism with the conditions of the question, except the held contact number `skipped`.
pub(crate) fn compile(
    mechanism: &Arc<Mechanism>,
    question: &MassQuestion,
    skipped: Option<usize>,
) -> Result<System, StudyError> {
    let joint = |field: &'static str, name: &str| -> Result<JointId, StudyError> {
        mechanism.find_joint(name).map_err(StudyError::about(field))
    };
    let base = if floats_already(mechanism) { Base::Fixed } else { question.conditions.base() };
    let mut conditions = Conditions::new().base(base);
    for name in &question.conditions.lock {
        if name == EVERY_JOINT && mechanism.find_joint(name).is_err() {
            let moving = mechanism
                .joints()
                .iter()
                .filter(|joint| joint.kind() != JointKind::Fixed && joint.mimic().is_none());
            conditions = moving.fold(conditions, |conditions, joint| conditions.lock(joint.name()));
            continue;
        }
        joint("conditions.lock", name)?;
        conditions = conditions.lock(name);
    }
    for (name, values) in &question.conditions.armature {
        joint("conditions.armature", name)?;
        conditions = conditions.armature(name, values.clone());
    }
    for (name, _) in &question.conditions.gear_stiffness {
        joint("conditions.gear_stiffness", name)?;
    }
    for (_, hold) in question.hold.iter().enumerate().filter(|(i, _)| Some(*i) != skipped) {
        mechanism.find_link(&hold.link).map_err(StudyError::about("hold"))?;
        let normal = hold.normal.map(Vector3::from);
        let in_root = |normal| question.base_pose().map_or(normal, |base| base.inverse_vector(&normal));
        conditions = conditions.hold(&hold.link, hold.point, normal.map(in_root));
    }
    let system = System::new(Arc::clone(mechanism), &conditions)
        .map_err(|error| StudyError::input(conditions_error_key(&error), error))?;
    let root = mechanism.root();
    if base == Base::Floating && system.rigid_body_mass(root).is_some_and(|mass| mass <= 0.0) {
        let link = mechanism.link(root).name();
        let why = format!(
            "the root link \"{link}\" has no mass; a floating root link needs mass and inertia: write mass, com and inertia in the \
             model, or in a section [{link}] of a suspension sheet, or use a fixed base"
        );
        return Err(StudyError::input("conditions.base", why));
    }
    Ok(system)
}

/// True if all parts of a mechanism float on a root link without mass, the ground of SDFormat and MJCF: a floating base is no change.
fn floats_already(mechanism: &Mechanism) -> bool {
    let root = mechanism.root();
    let joints = mechanism.child_joints(root);
    let holds_root = |closure: &Closure| {
        [closure.predecessor(), closure.successor()]
            .iter()
            .any(|end| end.link.is_none_or(|link| link == root))
    };
    mechanism.link(root).inertial().is_none_or(|inertial| inertial.mass == 0.0)
        && !joints.is_empty()
        && joints.iter().all(|joint| mechanism.joint(*joint).kind() == JointKind::Floating)
        && !mechanism.closures().iter().any(holds_root)
}

/// Requested positions: pose file first, then `--set` and `--guess`.
pub(crate) fn configuration(
    mechanism: &Arc<Mechanism>,
    question: &MassQuestion,
) -> Result<Configuration, StudyError> {
    let values = |field: &'static str, joint: &String, given: &GivenPosition| {
        let id = mechanism.find_joint(joint).map_err(StudyError::about(field))?;
        let wrong = |source| StudyError::input(field, Fault::Position { joint: joint.clone(), source });
        let kind = mechanism.joint(id).kind();
        if joint == RACK && kind == JointKind::Fixed && !wheel_centres(mechanism, "").is_empty() {
            let why = "the rack is fixed in this suspension; write rack.slides = true in the sheet, or use percuss kinematics --steer";
            return Err(StudyError::input(field, why));
        }
        given.values_for_joint(kind).map_err(wrong)
    };
    let mut configuration = match &question.positions {
        None => Configuration::zero(mechanism),
        Some(file) => {
            let refuse = |error: GivenPoseError| StudyError::input("pose.file", error);
            file.check(mechanism).map_err(refuse)?;
            from_file(mechanism, question, file, values)?
        }
    };
    for (joint, given) in &question.pose.set {
        let values = values("pose.set", joint, given)?;
        configuration.set(joint, &values).map_err(StudyError::about("pose.set"))?;
    }
    let whole = question.positions.as_ref().is_some_and(|file| file.is_complete(mechanism));
    for (joint, given) in question.pose.guess.iter().filter(|_| !whole) {
        let values = values("pose.guess", joint, given)?;
        configuration.guess(joint, &values).map_err(StudyError::about("pose.guess"))?;
    }
    if let Some(base) = question.base_pose() {
        configuration.set_base(*base);
    }
    Ok(configuration)
}

/// Positions from a pose file. A file with all joints gives the full configuration, in which `--set` and
/// `--guess` replace single joints. A file with some joints sets these joints, except those of `--set`.
fn from_file(
    mechanism: &Arc<Mechanism>,
    question: &MassQuestion,
    file: &GivenPose,
    values: impl Fn(&'static str, &String, &GivenPosition) -> Result<Vec<f64>, StudyError>,
) -> Result<Configuration, StudyError> {
    let refuse = |error: ConfigurationError| StudyError::input("pose.file", error);
    if !file.is_complete(mechanism) {
        let mut configuration = Configuration::zero(mechanism);
        let is_set = |joint: &String| question.pose.set.iter().any(|(set, _)| set == joint);
        for (joint, given) in file.positions.iter().filter(|(joint, _)| !is_set(joint)) {
            configuration.set(joint, &values("pose.file", joint, given)?).map_err(refuse)?;
        }
        return Ok(configuration);
    }
    for joint in file.positions.keys() {
        mechanism.find_joint(joint).map_err(StudyError::about("pose.file"))?;
    }
    let mut positions = Vec::new();
    for joint in mechanism.joints() {
        let name = joint.name().to_owned();
        let over = |given: &[(String, GivenPosition)]| {
            given.iter().find(|(of, _)| *of == name).map(|(_, position)| position.clone())
        };
        let given = [("pose.guess", over(&question.pose.guess)), ("pose.set", over(&question.pose.set))];
        let given = given.into_iter().chain([("pose.file", file.positions.get(&name).cloned())]);
        let given = given.into_iter().find_map(|(field, position)| Some((field, position?)));
        match given {
            Some((field, position)) if joint.mimic().is_none() && joint.kind().positions() > 0 => {
                let position = values(field, &name, &position)?;
                // `set` rejects a wrong number of values and names the joint.
                Configuration::zero(mechanism).set(&name, &position).map_err(StudyError::about(field))?;
                positions.extend(position);
            }
            _ => positions.extend(std::iter::repeat_n(0.0, joint.kind().positions())),
        }
    }
    Configuration::from_positions(mechanism, &positions).map_err(refuse)
}

/// Link with this name. Without such a link, `world` is the ground (`None`).
fn other_side(mechanism: &Mechanism, name: &str) -> Result<Option<LinkId>, UnknownName> {
    match mechanism.find_link(name) {
        Ok(link) => Ok(Some(link)),
        Err(_) if name == "world" => Ok(None),
        Err(unknown) => Err(unknown),
    }
}
