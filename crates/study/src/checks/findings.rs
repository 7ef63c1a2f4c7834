//! Findings about the pose, the assembly and the contact response.

use crate::checks::far_point_check;
use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use crate::checks::joint_limits::{joint_limit_finding, many_turns_finding};
use crate::question::mass_question::MassQuestion;
use crate::question::names::Names;
use crate::thresholds::{FAR_FROM_GUESS, MOST_TURNS_SET};
use crate::values::position::{GivenPosition, position_dimension};
use percuss_dynamics::{
    Assembly, Base, BranchLimits, Configuration, Contact, ContactResponse, DrawnGap, EffectiveMass, Pose,
    Remark, RemarkFlags, RigidLoops, Singularity, System,
};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use percuss_suspension::kinematics::wheel_centres;
use percuss_units::Dimension;

/// Remainder of x modulo the period, from −period/2 to period/2.
fn remainder(x: f64, period: f64) -> f64 {
    x - period * (x / period).round()
}

/// Findings about joint limits and loop closure.
pub(crate) fn collect_pose_findings(system: &System, pose: &Pose, names: Names) -> Vec<Finding> {
    let mechanism = system.mechanism();
    let mut found: Vec<Finding> = pose
        .outside_limits()
        .map(|(joint, value, limits)| joint_limit_finding(mechanism, joint, value, limits))
        .collect();
    if let Some(bush) = mechanism.bushes().first() {
        let message = format!(
            "the bushes of the model ({} and {} more) are rigid in this result; percuss mass states their effect, percuss response their \
             vibrations",
            bush.name(),
            mechanism.bushes().len() - 1
        );
        found.push(Finding::about_result(FindingKind::BushesRigid, message));
    }
    if pose.loops().is_some() {
        add_loop_findings(system, pose, names, &mut found);
        add_rank_findings(pose.assembly(), &mut found);
        found.extend(pose.assembly().rigid_loops().iter().map(|rigid| rigid_loop_finding(mechanism, rigid)));
    }
    found
}

/// Findings about the conditions of a question: gears of joints that move and are rigid, springs that are left out, joints that turn more than once.
pub(crate) fn condition_findings(system: &System, question: &MassQuestion) -> Vec<Finding> {
    let mut found = Vec::new();
    let mechanism = system.mechanism();
    let moves = |id: &JointId| !system.is_locked(*id);
    let given = question.conditions.gear_stiffness.iter();
    let given = given.filter_map(|(name, _)| mechanism.find_joint(name).ok());
    let of_model = mechanism.joint_ids().filter(|id| mechanism.joint(*id).gear().is_some());
    if given.chain(of_model).any(|id| moves(&id)) {
        let message = "the gears are rigid in this result; percuss mass states the effect of their stiffness, percuss response the \
                       vibrations";
        found.push(Finding::about_result(FindingKind::GearsRigid, message.to_owned()));
    }
    let has_spring =
        |id: &JointId| mechanism.joint(*id).spring().is_some_and(|spring| spring.stiffness > 0.0);
    let sprung: Vec<JointId> = mechanism.joint_ids().filter(has_spring).filter(moves).collect();
    if !sprung.is_empty() {
        let message = format!(
            "springs of joints ({}) are left out of this result; percuss response and an impact in time include them",
            joint_list(mechanism, &sprung)
        );
        found.push(Finding::about_result(FindingKind::JointSprings, message));
    }
    found.extend(question.pose.set.iter().filter_map(|(joint, position)| {
        let joint = mechanism.find_joint(joint).ok()?;
        many_turns_finding(mechanism, joint, position.single()?, MOST_TURNS_SET, "is at")
    }));
    found
}

/// Names of at most three joints, and the number of all.
pub(crate) fn joint_list(mechanism: &Mechanism, joints: &[JointId]) -> String {
    let names: Vec<&str> = joints.iter().take(3).map(|joint| mechanism.joint(*joint).name()).collect();
    let more = joints.len() - names.len();
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("{}{more}", names.join(", "))
}

/// Findings about closure of the loops and about the driving joints.
fn add_loop_findings(system: &System, pose: &Pose, names: Names, found: &mut Vec<Finding>) {
    let mechanism = system.mechanism();
    let Some(loops) = pose.loops() else { return };
    let set = names.hint("pose.set");
    for name in system.reversed_axes() {
        let message = format!(
            "the axis of loop \"{name}\" has opposite directions in its two frames with all joints at 0; the \
             axis of the successor was reversed"
        );
        found.push(Finding::new(
            FindingKind::ReversedAxis,
            FindingSubject::Closure(name.to_string()),
            message,
        ));
    }
    if loops.inexactness > 0.0 {
        let part = loops.inexactness / mechanism.characteristic_length();
        let message = format!(
            "the file's loops are inexact: the best fit leaves a gap of {:.2e} m ({part:.1e} of the size), \
             closed in the least-squares sense; check for rounded angles (1.5708)",
            loops.inexactness
        );
        found.push(Finding::about_result(FindingKind::InexactLoops, message));
    }
    for (joint, value) in &loops.off_zero {
        let message = format!(
            "joint \"{}\" is a driving joint without a given position; 0 cannot be reached, so it is at \
             {value:.9}; set it{set}",
            mechanism.joint(*joint).name()
        );
        found.push(Finding::new(FindingKind::DriverOffZero, FindingSubject::Joint(*joint), message));
    }
    for (joint, far) in &loops.off_target {
        let message = format!(
            "joint \"{}\" was set{set} to more values than the loops leave degrees of freedom: the nearest \
             reachable position is used, {far:.6} rad or m away",
            mechanism.joint(*joint).name()
        );
        found.push(Finding::new(FindingKind::OffTarget, FindingSubject::Joint(*joint), message));
    }
    if let Some(starts) = loops.starts_tried {
        let message = format!(
            "the pose is on a different assembly mode than the first closed pose: the branch of that pose ends \
             before these positions; this pose was found from {starts} other start(s)"
        );
        found.push(Finding::about_result(FindingKind::OtherAssembly, message));
    }
    for gap in pose.assembly().drawn_gaps() {
        found.push(drawn_gap_finding(mechanism, &gap));
    }
    // The choice of the driving joints has no influence on the results of a suspension.
    let is_suspension = || !wheel_centres(mechanism, "").is_empty();
    if !loops.declared && !loops.drivers.is_empty() && !is_suspension() {
        let drivers: Vec<String> =
            loops.drivers.iter().map(|j| format!("\"{}\"", mechanism.joint(*j).name())).collect();
        let message = format!(
            "the loops are driven by {}: chosen by the rank of the constraints and by joint limits and efforts, \
             because the model declares none",
            format_names(&drivers)
        );
        found.push(Finding::about_result(FindingKind::DriversChosen, message));
    }
}

/// Finding for a loop that is open as drawn: the gap, and the joint that moved most to close the loop.
fn drawn_gap_finding(mechanism: &Mechanism, gap: &DrawnGap) -> Finding {
    let closed = gap.moved.map_or_else(String::new, |(joint, by)| {
        let joint = mechanism.joint(joint);
        let by = match joint.kind() {
            JointKind::Prismatic | JointKind::Planar | JointKind::Floating => format!("{:+.3} mm", 1e3 * by),
            JointKind::Fixed | JointKind::Revolute | JointKind::Continuous | JointKind::Spherical => {
                format!("{:+.3}°", by.to_degrees())
            }
        };
        format!("; closed by {} {by}", joint.name())
    });
    let message =
        format!("loop \"{}\" is {} open in the design pose{closed}", gap.constraint, format_length(gap.gap));
    let subject = FindingSubject::Closure(gap.constraint.clone());
    if gap.is_wide {
        let part = 100.0 * gap.gap / gap.size;
        let message = format!("{message}: {part:.1} % of its size; check the points for typing errors");
        Finding::new(FindingKind::DrawnOpen, subject, message)
    } else {
        Finding::new(FindingKind::DrawnOpen, subject, message).into_note()
    }
}

/// Length in mm; in m if below 1 µm or from 1 m.
fn format_length(length: f64) -> String {
    if (1e-6..1.0).contains(&length) { format!("{:.4} mm", 1e3 * length) } else { format!("{length:.3e} m") }
}

/// Findings about the rank decision of the constraint rows.
fn add_rank_findings(assembly: &Assembly, found: &mut Vec<Finding>) {
    if !assembly.rank_is_clear() {
        let gap = assembly.rank_gap().unwrap_or_default();
        let message =
            format!("the rank of the constraints is unclear (gap {gap:.1e}): the mobility may differ");
        found.push(Finding::about_result(FindingKind::UnclearRank, message));
    }
    let least = assembly.least_singular_value();
    if assembly.is_weakly_constrained() {
        let message = format!(
            "the mechanism is weakly constrained: the least singular value of the loops' rows counted as \
             nonzero is {least:.1e} of the largest; if the numbers in the file are rounded by as much, there is \
             one more degree of freedom than the {} counted",
            assembly.degrees_of_freedom()
        );
        found.push(Finding::about_result(FindingKind::WeaklyConstrained, message));
    }
}

/// Finding for loops that leave no motion, with the joint axis to correct.
fn rigid_loop_finding(mechanism: &Mechanism, rigid: &RigidLoops) -> Finding {
    let joint = |id: JointId| format!("\"{}\"", mechanism.joint(id).name());
    let loops: Vec<String> = rigid.loops.iter().map(|name| format!("\"{name}\"")).collect();
    let joints: Vec<String> = rigid.joints.iter().copied().map(joint).collect();
    let mut message = format!(
        "the loops {} are rigid: their joints {} have no motion, with nothing locked or held",
        format_names(&loops),
        format_names(&joints)
    );
    let mut subject = FindingSubject::Closure(rigid.loops.first().cloned().unwrap_or_default());
    for axis in &rigid.departing {
        let whose =
            axis.joint.map_or_else(|| "the loop itself".to_owned(), |id| format!("joint {}", joint(id)));
        let required = if axis.slides { "normal to" } else { "along" };
        let [x, y, z] = axis.direction.map(|c| if c.abs() < 5e-5 { 0.0 } else { c }).into();
        message += &format!(
            "; in loop \"{}\" the axis of {whose} deviates by {:.4}° from the common direction of the others: \
             it should be {required} \
             ({x:.4}, {y:.4}, {z:.4}) in the root link's axes; correct its <axis>, or the rpy of the frames it is given in",
            axis.closure,
            axis.angle.to_degrees()
        );
        if let Some(id) = axis.joint {
            subject = FindingSubject::Joint(id);
        }
    }
    if rigid.departing.is_empty() {
        message += "; if the linkage should move, check its lengths, the directions of its axes, and whether a loop \
                    should leave more motions (spherical instead of revolute)";
    }
    Finding::new(FindingKind::RigidLoops, subject, message)
}

/// First six names and the number of further names.
fn format_names(names: &[String]) -> String {
    let more = names.len().saturating_sub(6);
    let some = names.iter().take(6).cloned().collect::<Vec<_>>().join(", ");
    if more > 0 { format!("{some} and {more} more") } else { some }
}

/// Findings about unused guesses, and about guesses far from the assembly found.
pub(crate) fn guess_findings(
    system: &System,
    pose: &Pose,
    configuration: &Configuration,
    explicit_guesses: &[(String, GivenPosition)],
    names: Names,
) -> Vec<Finding> {
    let (set, given) = (names.name_of("pose.set"), names.hint("pose.guess"));
    let drives = |joint| pose.loops().is_some_and(|loops| loops.drivers.contains(&joint));
    let mut found = Vec::new();
    for (joint, guess) in configuration.guesses() {
        let name = system.mechanism().joint(joint).name();
        // A complete configuration holds a guess for every joint; only explicit guesses are reported.
        if !explicit_guesses.iter().any(|(guessed, _)| guessed == name) {
            continue;
        }
        let mut add = |kind, message| found.push(Finding::new(kind, FindingSubject::Joint(joint), message));
        if !system.is_bound(joint) {
            let message = format!(
                "the guess{given} for joint \"{name}\" is not used: the joint is in no loop; use {set} instead"
            );
            add(FindingKind::UnusedGuess, message);
        } else if drives(joint) {
            let message = format!(
                "the guess{given} for joint \"{name}\" is not used: the joint is a driving joint; use {set} instead"
            );
            add(FindingKind::UnusedGuess, message);
        } else if let (&[at], &[guess]) = (pose.joint(joint), guess) {
            let size = system.mechanism().characteristic_length();
            let kind = system.mechanism().joint(joint).kind();
            let off = if position_dimension(kind, 0) == Dimension::Angle {
                remainder(at - guess, std::f64::consts::TAU).abs()
            } else {
                (at - guess).abs() / size
            };
            if off > FAR_FROM_GUESS {
                let message = format!(
                    "joint \"{name}\" was guessed at {guess}{given} and is at {at:.9}: no closer solution of \
                     its loops was found"
                );
                add(FindingKind::FarFromGuess, message);
            }
        }
    }
    found
}

/// Warning for a floating base with mass and without moments of inertia, such as a chassis of which only the mass is given.
pub(crate) fn point_mass_base_finding(system: &System) -> Option<Finding> {
    let root = system.mechanism().root();
    let link = system.mechanism().link(root);
    let own = link.inertial().filter(|own| own.mass > 0.0 && own.about_com.norm() == 0.0)?;
    // Links fixed to the root link may have the inertia.
    let is_alone = system.rigid_body_mass(root).is_some_and(|mass| mass <= own.mass);
    (system.base() == Base::Floating && is_alone).then(|| {
        let message = format!(
            "the floating root link \"{}\" has a mass and no moments of inertia: it turns without resistance, and the effective mass is \
             too small; give mass, com and inertia in the model, or in a section [{}] of a suspension sheet",
            link.name(),
            link.name()
        );
        Finding::new(FindingKind::PointMassBase, FindingSubject::Link(root), message)
    })
}

/// Findings about the contact point and the base, for all poses.
pub(crate) fn contact_findings(system: &System, contact: &Contact, names: Names) -> Vec<Finding> {
    let far = far_point_check::far_point_finding(system.mechanism(), contact.link, &contact.point, names);
    far.into_iter().chain(point_mass_base_finding(system)).collect()
}

/// Findings about the contact point and remarks of the contact response.
pub(crate) fn collect_response_findings(
    system: &System,
    contact: &Contact,
    response: &ContactResponse,
    names: Names,
) -> Vec<Finding> {
    let mut found = contact_findings(system, contact, names);
    let finite = matches!(response.effective_mass, EffectiveMass::Finite(_));
    // The status of a massless result already reports massless motions.
    let reported = |r: &&Remark| finite || !matches!(r, Remark::MasslessMotions { .. });
    found.extend(response.remarks.iter().filter(reported).filter_map(remark));
    let (mass, error) = (response.effective_mass, response.effective_mass_error());
    let flags = RemarkFlags::of_error(mass, error);
    if flags.contains(RemarkFlags::UNKNOWN_ERROR) {
        let message = "the error of the effective mass is unknown: near this pose the effective mass is not \
            finite; do not rely on its digits";
        found.push(Finding::about_result(FindingKind::UnknownError, message));
    }
    if let (true, EffectiveMass::Finite(m), Some(error)) =
        (flags.contains(RemarkFlags::UNCERTAIN_MASS), mass, error)
    {
        let message = format!(
            "the effective mass has a relative error of up to {:.1e}: the pose is close to a singular one, or \
             the mass matrix is nearly singular; do not rely on further digits",
            error / m
        );
        found.push(Finding::about_result(FindingKind::UncertainMass, message));
    }
    found
}

/// Finding about a map at a singular pose.
pub(crate) fn singular_map_finding(pose: &Pose) -> Option<Finding> {
    let message = "branches cross at this pose: every effective mass is a lower bound here, and the limits \
        along the branches may be much larger; use a nearby pose, or percuss mass, which shows the limits";
    pose.rank().singular.then(|| Finding::about_result(FindingKind::SingularPose, message))
}

/// Finding for a singular pose: branches cross, or the constraints have lower rank than at neighbouring poses.
pub(crate) fn singular_pose_finding(
    pose: &Pose,
    response: &ContactResponse,
    limits: &BranchLimits,
) -> Option<Finding> {
    if !response.singular_pose {
        return None;
    }
    let (at_pose, generic) = (response.degrees_of_freedom, pose.assembly().degrees_of_freedom());
    let loops = pose.loops().is_some_and(|l| l.singularities.contains(&Singularity::ChangePoint));
    let kind = if loops { "singular pose (change point)" } else { "singular pose" };
    let mut message = format!("{kind}: {at_pose} degrees of freedom here, {generic} at a generic pose; ");
    message += match (limits.limits.is_empty(), limits.continuous, limits.complete) {
        (true, ..) if !loops => {
            "held points or locked joints constrain less here than at nearby poses, and the value is a lower bound"
        }
        (true, _, false) => {
            "its branches were not followed, since there are too many or its loops are too large, and the value is a lower \
             bound"
        }
        (true, ..) => {
            "no branch through this pose was found, and the value is a lower bound that a finite motion may not reach"
        }
        (false, true, _) => {
            "a continuum of branches meets here, the limit depends on the direction of approach, and the value is a lower \
             bound: see the smallest and the largest of the limits found"
        }
        (false, false, true) => {
            "branches cross, and the value is a lower bound that no branch may reach: see the limits along the \
             branches"
        }
        (false, false, false) => {
            "many branches cross, and the value is a lower bound that no branch may reach: see the limits along \
             the branches found; there may be more branches"
        }
    };
    Some(Finding::about_result(FindingKind::SingularPose, message))
}

/// Finding for a remark on the response. Remarks about the pose give `None`; [`about_pose`] reports them.
fn remark(remark: &Remark) -> Option<Finding> {
    let (kind, message) = match remark {
        Remark::NearlyImmovable { closing_speed, uncertainty } => (
            FindingKind::NearlyImmovable,
            format!(
                "the gap is nearly constant (closing speed {closing_speed:.1e} of its terms): the relative \
                 uncertainty of the \
                 effective mass is {uncertainty:.1e}"
            ),
        ),
        Remark::MasslessMotions { directions } => (
            FindingKind::MasslessMotions,
            format!("{directions} motion(s) of the mechanism have no mass; they do not affect the result"),
        ),
        Remark::MasslessToRounding { up_to } => (
            FindingKind::MasslessToRounding,
            format!(
                "massless within rounding: the masses differ by so many decades that an effective mass of up to \
                 {up_to:.1e} kg cannot be distinguished from 0"
            ),
        ),
        Remark::UndeterminedMotion => (
            FindingKind::UndeterminedMotion,
            "a motion without mass leaves some velocities of the contact response undetermined; the mass and the \
             contributions are not affected"
                .into(),
        ),
        Remark::IndefiniteMassMatrix => (
            FindingKind::IndefiniteMassMatrix,
            "the mass matrix has negative directions: the value is stationary, not a minimum".into(),
        ),
        Remark::UnclearRank { gap } => (
            FindingKind::UnclearRankHere,
            format!(
                "the rank of the constraints is unclear at this pose (gap {gap:.1e}): it is close to a change point, \
                 where the mobility differs"
            ),
        ),
        Remark::OpenGap { gap } => return Some(open_gap_finding(*gap)),
        Remark::OtherAssembly { .. }
        | Remark::DrawnOpen { .. }
        | Remark::InexactLoops { .. }
        | Remark::DriverOffZero { .. }
        | Remark::OffTarget { .. }
        | Remark::OutsideLimits { .. }
        | Remark::WeaklyConstrained { .. }
        | Remark::UnclearMobility { .. }
        // The world of a question is the frame of its root link.
        | Remark::BaseNotGiven => return None,
    };
    Some(Finding::about_result(kind, message))
}

/// Finding for a stop that does not touch at the pose; `gap` in m.
pub(crate) fn open_gap_finding(gap: f64) -> Finding {
    let message = format!(
        "the contact is {} open at this pose: an impact occurs at the touch, where the effective mass may differ",
        format_length(gap)
    );
    Finding::about_result(FindingKind::OpenGap, message)
}
