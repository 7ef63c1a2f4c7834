//! Impact at a contact of a model as an MJCF file: the mechanism, the contact with its parameters, and the state at the touch.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::curvature::gap_acceleration;
use crate::damper::damped_contact::damping_report;
use crate::damper::damping::{self, DampingReport};
use crate::damper::penetration::{PathPoint, PenetrationPath};
use crate::damper::simulators::ExportRecord;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::spelled_contact::{JointStop, StopEnd};
use crate::question::tables::damping::{DampingQuestion, Tools};
use crate::question::tables::exports::{ExportQuestion, ModelFormat};
use crate::reports::exports::balanced::balanced;
use crate::reports::exports::code::TextFile;
use crate::reports::exports::conversion::{changes, heading};
use crate::reports::exports::impact_report::ExportReport;
use crate::reports::exports::mesh_names::MeshNames;
use crate::thresholds::{
    BEFORE_END, FAR_LIMIT, IMPACT_RADIUS, LEAST_ACCURACY, LEAST_RADIUS_OVER_PENETRATION, NEGLIGIBLE_SHIFT,
    SHIFT_UNCERTAINTY, SLOW_IMPACT, STROKES,
};
use nalgebra::{Rotation3, UnitQuaternion};
use percuss_contact::exports::{MassDrift, StopMotion, Tool, Value};
use percuss_contact::restitution_with_prescribed_acceleration;
use percuss_dynamics::{Base, Contact, Direction, Frame, PointVelocity};
use percuss_formats::{
    ImpactContact, ImpactSurfaces, MechanismState, MjcfError, MjcfImpact, ModelParts, ModelText, lost_pose,
    write_mjcf_impact,
};
use percuss_mechanism::{Built, JointDescription, JointKind, LinkDescription, LinkId, Mechanism};
use percuss_spatial::{Transform, Twist, Vector3};

/// Name of the ground of MJCF.
const WORLD: &str = "world";

/// Error of an exported impact.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ImpactExportError {
    /// Invalid question, no pose, or no damper.
    #[error(transparent)]
    Question(#[from] StudyError),
    /// The mechanism or the contact has no form in MJCF.
    #[error("the model cannot be written as MJCF: {0}")]
    Mjcf(#[from] MjcfError),
    /// The motion of the impact is not determined, because of a motion without mass.
    #[error(
        "link \"{link}\": its velocity is not determined, because of a motion without mass; give the link a mass"
    )]
    Undetermined {
        /// Name of the link.
        link: String,
    },
    /// A parameter of the simulator is missing.
    #[error("MuJoCo's parameter {name} is missing")]
    Parameter {
        /// Name of the parameter.
        name: &'static str,
    },
}

/// An impact as a file of MuJoCo.
#[derive(Debug)]
struct ExportedImpact {
    /// The file, and notes about parts that have another form.
    model: ModelText,
    /// Damper and parameters.
    damping: DampingReport,
    /// Approach speed, m/s.
    speed: f64,
    /// Time step, s.
    time_step: f64,
    /// Restitution with the mass as it changes over the penetration, for an infinitely short time step; `None` if the mechanism cannot
    /// follow the impact.
    predicted: Option<f64>,
    /// Bound of the difference from the required restitution at this time step; `None` if unknown.
    error_bound: Option<f64>,
}

/// Script that runs an exported impact. It finds the model by its own name.
const SCRIPT: &str = include_str!("impact_script.py");

/// Exports the impact at a contact, or of a joint on its stop, as MJCF with a script that runs it. `question`: pose and held parts; its
/// contact is ignored for the stop `damping.limit`, and a contact `JOINT:lower` or `JOINT:upper` is the stop of the joint. Without a speed
/// in `damping`, the impact has 0.01 rad/s or 10 mm/s.
///
/// # Errors
/// [`ImpactExportError`]: an invalid question, a contact without a finite mass, a condition or a mechanism without a form in MJCF.
pub fn export(
    model: &Model,
    question: &MassQuestion,
    damping: &DampingQuestion,
    asked: &ExportQuestion,
) -> Result<ExportReport, ImpactExportError> {
    let balanced = asked.balance_inertia.then(|| balanced(model));
    let model = balanced.as_ref().map_or(model, |balanced| &balanced.model);
    let turns = match &damping.limit {
        Some(stop) => stop.motion(model)? == StopMotion::Turn,
        None => question.is_moment(&model.mechanism),
    };
    damping.check_units(turns)?;
    let files = asked.files();
    let of_stop = match &damping.limit {
        Some(stop) => Some((stop.clone(), question.clone())),
        None => JointStop::of_question(question, &model.mechanism),
    };
    let exported = match of_stop {
        None => exported_impact(model, question, damping, None, &files[0])?,
        Some((stop, conditions)) => {
            let (question, record) = stop.question(model, conditions)?;
            let mut damping = damping.clone();
            damping.options.stop = Some(record.motion);
            let mut exported = exported_impact(model, &question, &damping, Some(&stop), &files[0])?;
            exported.damping.stop = Some(record);
            exported
        }
    };
    let (mut changes, of_file) = changes(model, exported.model.changes);
    changes.extend(balanced.iter().flat_map(|balanced| balanced.changes.iter().cloned()));
    // The findings of the damper begin with those of the file.
    let of_result =
        exported.damping.diagnostics.iter().filter(|finding| !model.diagnostics.contains(finding));
    let texts = [exported.model.text, SCRIPT.to_owned()];
    let [output, script] = files.clone();
    Ok(ExportReport {
        schema: "percuss.export/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        output,
        script,
        format: "mjcf",
        stop: exported.damping.stop.clone(),
        effective_mass: exported.damping.effective_mass,
        approach_speed: exported.speed,
        restitution: exported.damping.damper.restitution,
        predicted_restitution: exported.predicted,
        error_bound: exported.error_bound,
        time_step: exported.time_step,
        changes,
        mass_change: balanced.as_ref().and_then(|balanced| balanced.mass_change),
        diagnostics: of_file.into_iter().chain(of_result.cloned()).collect(),
        files: files.into_iter().zip(texts).map(|(name, text)| TextFile { name, text }).collect(),
    })
}

/// Impact at a contact, or of a joint on its stop, as the file `output`.
fn exported_impact(
    model: &Model,
    question: &MassQuestion,
    damping: &DampingQuestion,
    stop: Option<&JointStop>,
    output: &str,
) -> Result<ExportedImpact, ImpactExportError> {
    refuse_conditions(question)?;
    let speed = damping.speed().unwrap_or(SLOW_IMPACT);
    let mut damping = DampingQuestion {
        speed: Some(speed.into()),
        tools: vec![Tools(vec![Tool::MUJOCO])],
        ..damping.clone()
    };
    // MuJoCo prescribes accelerations: the bound for laws that prescribe forces does not hold.
    damping.options.drift = Some(MassDrift { relative: 0.0, penetration: 1.0 });
    let evaluated = EvaluatedQuestion::new(model, question)?;
    let mut report = damping_report(&evaluated, &damping)?;
    let accuracy = damping.export_options().accuracy;
    let predicted = predicted_restitution(&evaluated, &damping, report.effective_mass);
    let shift = predicted.map_or(0.0, |predicted| predicted.shift(damping.restitution()));
    if shift > NEGLIGIBLE_SHIFT * accuracy && damping.export_options().time_step.is_none() {
        // The sum of the shift and the error of the time step is within the accuracy, if possible.
        damping.accuracy = Some((accuracy - shift).max(LEAST_ACCURACY * accuracy).into());
        report = damping_report(&evaluated, &damping)?;
    }
    let record = &report.exports[Tool::MUJOCO.name()];
    let time_step = record.time_step.ok_or(ImpactExportError::Parameter { name: "timestep" })?;
    let error_bound = record.error_bound.filter(|_| predicted.is_some()).map(|bound| bound + shift);
    if let Some(finding) = unreached_finding(damping.restitution(), predicted, error_bound, accuracy) {
        report.diagnostics.push(finding.into());
    }
    let record = &report.exports[Tool::MUJOCO.name()];
    let predicted = predicted.map(|predicted| predicted.restitution);
    let contact = &evaluated.result.response.contact;
    let size = model.mechanism.characteristic_length();
    let penetration = report.damper.max_penetration.unwrap_or_default();
    let equality = match record.parameters.contains_key("equality_solref") {
        true => Some([numbers(record, "equality_solref")?, numbers(record, "equality_solimp")?]),
        false => None,
    };
    let mechanism = &model.mechanism;
    let (state, floating) = match question.conditions.base() {
        Base::Fixed => (state(&evaluated, speed)?, None),
        Base::Floating => {
            let (mechanism, state) = with_floating_root(mechanism, state(&evaluated, speed)?)?;
            (state, Some(mechanism))
        }
    };
    let impact = MjcfImpact {
        state,
        contact: match stop {
            Some(stop) => limit(&evaluated, stop)?,
            None => ImpactContact::Surfaces(ImpactSurfaces {
                link: contact.link,
                against: contact.against,
                point: contact.point_link,
                normal: contact.normal_world,
                radius: (IMPACT_RADIUS * size).max(LEAST_RADIUS_OVER_PENETRATION * penetration),
                extent: size,
            }),
        },
        solref: numbers(record, if stop.is_some() { "solreflimit" } else { "solref" })?,
        solimp: numbers(record, if stop.is_some() { "solimplimit" } else { "solimp" })?,
        equality,
        time_step,
        restitution: damping.restitution(),
    };
    let meshes = MeshNames::new(model, output, ModelFormat::Mjcf);
    let find_mesh = |name: &str| meshes.find(name);
    // The floating mechanism has the links of the model, in the same order, and then the world.
    let parts = ModelParts {
        mechanism: floating.as_ref().unwrap_or(mechanism),
        shapes: &model.shapes,
        find_mesh: &find_mesh,
        poses: &[],
    };
    let mut written = write_mjcf_impact(parts, &impact, &heading(model))?;
    let only_impact = "the only keyframe of the file is the impact";
    written.changes.extend(model.poses.iter().map(|pose| lost_pose(&pose.name, only_impact)));
    Ok(ExportedImpact { model: written, speed, time_step, predicted, error_bound, damping: report })
}

/// Restitution of an impact with the mass as it changes over the penetration.
#[derive(Clone, Copy, Debug)]
struct Prediction {
    restitution: f64,
    /// Bound of the error of `restitution`: motions off the path of v*, and the uncertainty of the time step.
    uncertainty: f64,
}

impl Prediction {
    /// Bound of the difference from a required restitution.
    fn shift(self, required: f64) -> f64 {
        (self.restitution - required).abs() + self.uncertainty
    }
}

/// Restitution of MuJoCo's contact with the changes of m̄ and β over the penetration. The normal moves with the other side, like the face in
/// the file. `None` if the mechanism cannot follow the impact to its end. `mass`: m̄ at the touch, kg.
fn predicted_restitution(
    evaluated: &EvaluatedQuestion<'_>,
    damping: &DampingQuestion,
    mass: f64,
) -> Option<Prediction> {
    let EvaluatedQuestion { prepared, pose, contact, result } = evaluated;
    if result.response.singular_pose {
        return None;
    }
    if !result.response.mechanism_moves() {
        return Some(Prediction { restitution: damping.restitution(), uncertainty: 0.0 });
    }
    // The normal of a stop turns with the joint, and its gap is linear in the position.
    let is_stop = damping.options.stop.is_some();
    let normal = match contact.against {
        Some(other) => pose.link(other).inverse_vector(&result.response.contact.normal_world),
        None => result.response.contact.normal_world,
    };
    let contact = match is_stop {
        true => *contact,
        false => Contact { normal: Direction::Along(normal, Frame::Against), ..*contact },
    };
    let path = PenetrationPath { prepared, contact: &contact };
    let law = damping::contact(damping, mass).ok()?;
    let speed = damping.speed()?;
    let (stiffness, _) = law.power_law()?;
    let depth = speed * (law.mass() / stiffness).sqrt();
    STROKES.into_iter().find_map(|factor| {
        let mut stroke = factor * depth;
        let value = |at: &PathPoint| match is_stop {
            true => (at.mass, Some(0.0)),
            false => (at.mass, gap_acceleration(&at.pose, &at.response, &contact)),
        };
        let values = path.values_to(pose, stroke, value).or_else(|end| {
            stroke = BEFORE_END * end.depth;
            path.values_to(pose, stroke, value)
        });
        let values = values.ok()?;
        let masses: Vec<(f64, f64)> = values.iter().map(|(depth, (mass, _))| (*depth, *mass)).collect();
        let accelerations: Option<Vec<(f64, f64)>> =
            values.iter().map(|(depth, (_, acceleration))| Some((*depth, (*acceleration)?))).collect();
        let required = damping.restitution();
        let (restitution, deepest) =
            restitution_with_prescribed_acceleration(law, required, &masses, &accelerations?, speed)
                .ok()??;
        let change = |mass: &f64| (mass / law.mass() - 1.0).abs();
        let largest = masses.iter().map(|(_, mass)| change(mass)).fold(0.0, f64::max);
        // With several degrees of freedom the motion deviates from the path of v*, by an effect of the order of the squared change of m̄.
        let across = if pose.degrees_of_freedom() > 1 { largest * largest } else { 0.0 };
        let uncertainty = across + SHIFT_UNCERTAINTY * (restitution - required).abs();
        (deepest <= stroke).then_some(Prediction { restitution, uncertainty })
    })
}

/// Warning about a restitution that constant parameters do not reach. `accuracy`: permitted difference.
fn unreached_finding(
    required: f64,
    predicted: Option<Prediction>,
    error_bound: Option<f64>,
    accuracy: f64,
) -> Option<Finding> {
    let Some((predicted, bound)) = predicted.zip(error_bound) else {
        let message = "the restitution of the exported impact is not known: the mechanism does not follow the impact to its end; use a slower \
                       impact or a stiffer contact";
        return Some(Finding::about_result(FindingKind::RestitutionNotReached, message));
    };
    // The factor covers the rounding of the accuracy minus the shift.
    (bound > accuracy * (1.0 + NEGLIGIBLE_SHIFT)).then(|| {
        let message = format!(
            "the exported impact reaches the restitution {:.4} ± {:.1e} instead of {required}, because the mechanism moves during the \
             contact: the effective mass changes, and the contact point accelerates along the normal; a slower impact or a stiffer contact \
             reduces the difference",
            predicted.restitution,
            bound - (predicted.restitution - required).abs()
        );
        Finding::about_result(FindingKind::RestitutionNotReached, message)
    })
}

/// Refuses conditions that hold for an answer and are no part of the model.
fn refuse_conditions(question: &MassQuestion) -> Result<(), StudyError> {
    let in_model = "write it into the model file";
    let conditions = [
        (
            !question.conditions.lock.is_empty(),
            "conditions.lock",
            "replace the joint by a fixed joint in the model file",
        ),
        (!question.hold.is_empty(), "hold", "add a loop to the model file"),
        (!question.conditions.armature.is_empty(), "conditions.armature", in_model),
        (
            question.contact.against_mass().is_some(),
            "contact.against_mass",
            "add the body to the model file and name it by --against",
        ),
        (question.contact.estimate.is_some(), "contact.estimate", "use percuss mass"),
    ];
    match conditions.into_iter().find(|(is_given, ..)| *is_given) {
        Some((_, condition, remedy)) => Err(not_written(condition, remedy)),
        None => Ok(()),
    }
}

/// Refusal of a condition that has no form in the file.
fn not_written(condition: &'static str, remedy: &str) -> StudyError {
    StudyError::input(condition, format!("not written to a model of a simulator; {remedy}"))
}

/// Range of a joint whose end is its position at the stop. The other end is the other limit, or far away.
fn limit(evaluated: &EvaluatedQuestion<'_>, stop: &JointStop) -> Result<ImpactContact, ImpactExportError> {
    let mechanism = evaluated.pose.mechanism();
    let joint = mechanism.find_joint(&stop.joint).map_err(StudyError::about("damping.limit"))?;
    let at = evaluated.pose.joint(joint)[0];
    let limits = mechanism.joint(joint).limits();
    let far = |limit: Option<f64>, toward: f64| {
        limit.filter(|limit| (limit - at) * toward > 0.0).unwrap_or(at + toward * FAR_LIMIT)
    };
    let range = match stop.end {
        Some(StopEnd::Lower) => [at, far(limits.map(|limits| limits.upper), 1.0)],
        Some(StopEnd::Upper) | None => [far(limits.map(|limits| limits.lower), -1.0), at],
    };
    Ok(ImpactContact::Limit { joint, range })
}

/// Mechanism whose root link floats in the world by a joint, and its state. Links and joints keep their numbers.
fn with_floating_root(
    mechanism: &Mechanism,
    mut state: MechanismState,
) -> Result<(Mechanism, MechanismState), ImpactExportError> {
    let root = mechanism.root();
    let name = mechanism.link(root).name();
    let joint = JointDescription::new(format!("{name}_floating"), JointKind::Floating, WORLD, name);
    let builder = mechanism.to_builder().link(LinkDescription::massless(WORLD)).joint(joint);
    let Built { mechanism, .. } = builder.build().map_err(|_| {
        let remedy = "add a floating joint to the model file; its root link cannot have the name \"world\", nor a joint the name ROOT_floating";
        not_written("conditions.base", remedy)
    })?;
    let (pose, twist) = (state.link_poses[root.index()], state.link_twists[root.index()]);
    let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(pose.rotation));
    state.positions.push(pose.translation.iter().copied().chain([q.w, q.i, q.j, q.k]).collect());
    let (angular, linear) = (pose.inverse_vector(&twist.angular), pose.inverse_vector(&twist.linear));
    state.velocities.push(angular.iter().chain(linear.iter()).copied().collect());
    state.link_poses.push(Transform::identity());
    state.link_twists.push(Twist::zero());
    Ok((mechanism, state))
}

/// Numbers of a parameter.
fn numbers(record: &ExportRecord, name: &'static str) -> Result<Vec<f64>, ImpactExportError> {
    match record.parameters.get(name) {
        Some(Value::Numbers(numbers)) => Ok(numbers.clone()),
        _ => Err(ImpactExportError::Parameter { name }),
    }
}

/// Pose at the touch, and the velocities of the impact at a closing speed, m/s.
fn state(evaluated: &EvaluatedQuestion<'_>, speed: f64) -> Result<MechanismState, ImpactExportError> {
    let EvaluatedQuestion { pose, result, .. } = evaluated;
    let (mechanism, response) = (pose.mechanism(), &result.response);
    let twist = |link: LinkId| {
        let velocity = |point: Vector3<f64>| match pose.point_velocity_over_ground(response, link, &point) {
            Some(PointVelocity::Known(velocity)) => Ok(velocity * speed),
            Some(PointVelocity::Undetermined) | None => {
                Err(ImpactExportError::Undetermined { link: mechanism.link(link).name().to_owned() })
            }
        };
        let linear = velocity(Vector3::zeros())?;
        let mut angular = Vector3::zeros();
        let axes = pose.link(link).rotation;
        for unit in [Vector3::x(), Vector3::y(), Vector3::z()] {
            // Σ e × (ω × e) = 2 ω over an orthonormal basis.
            angular += (axes * unit).cross(&(velocity(unit)? - linear)) * 0.5;
        }
        Ok(Twist::new(angular, linear))
    };
    Ok(MechanismState {
        positions: mechanism.joint_ids().map(|joint| pose.joint(joint).to_vec()).collect(),
        velocities: response
            .joint_velocities
            .iter()
            .map(|rates| rates.iter().map(|rate| rate * speed).collect())
            .collect(),
        link_poses: mechanism.link_ids().map(|link| pose.link(link)).collect(),
        link_twists: mechanism.link_ids().map(twist).collect::<Result<_, ImpactExportError>>()?,
    })
}
