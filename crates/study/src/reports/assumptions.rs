//! Assumptions of a result in readable form: base, locks, mimics, drivers.

use crate::evaluation::prepared_question::PreparedQuestion;
use crate::thresholds::ROBOT_JOINTS;
use percuss_dynamics::{Base, Pose};
use percuss_mechanism::JointKind;

/// Assumptions of a result, for text output; not part of the JSON.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assumptions {
    /// `fixed` or `floating`, and the root link.
    pub base: String,
    /// Joints that are neither locked nor mimics.
    pub free: Vec<String>,
    /// Joints that are locked, directly or through the joint they mimic.
    pub locked: Vec<String>,
    /// Joints that mimic another joint.
    pub mimics: Vec<String>,
    /// Joints set by the question.
    pub set: Vec<String>,
    /// Joints that drive loops.
    pub drivers: Vec<String>,
    /// True for a robot arm without any rotor inertia: geared drives would make it heavier.
    pub lacks_rotors: bool,
}

/// True if a mechanism without loops has several turning joints and neither the model nor the question gives an armature.
pub(crate) fn lacks_rotors(prepared: &PreparedQuestion) -> bool {
    let mechanism = prepared.system.mechanism();
    let turning = mechanism.joints().iter().filter(|joint| {
        matches!(joint.kind(), JointKind::Revolute | JointKind::Continuous) && joint.mimic().is_none()
    });
    let has_armature = mechanism.joints().iter().any(|joint| joint.armature().iter().any(|x| *x != 0.0));
    mechanism.closures().is_empty()
        && turning.count() >= ROBOT_JOINTS
        && !has_armature
        && prepared.question.conditions.armature.is_empty()
}

impl Assumptions {
    /// Assumptions of the result at a pose.
    pub(crate) fn of(prepared: &PreparedQuestion, pose: &Pose) -> Self {
        let (system, question) = (&prepared.system, &*prepared.question);
        let mechanism = system.mechanism();
        let root = mechanism.link(mechanism.root()).name();
        let mut assumptions = Assumptions {
            base: match question.conditions.base() {
                Base::Fixed => format!("fixed (root link \"{root}\" is the ground)"),
                Base::Floating => format!("floating (root link \"{root}\" moves freely)"),
            },
            set: question.pose.set.iter().map(|(joint, _)| joint.clone()).collect(),
            drivers: pose.loops().map_or_else(Vec::new, |l| {
                l.drivers.iter().map(|id| mechanism.joint(*id).name().to_owned()).collect()
            }),
            lacks_rotors: lacks_rotors(prepared),
            ..Assumptions::default()
        };
        for id in mechanism.joint_ids() {
            let joint = mechanism.joint(id);
            let list = match joint.mimic() {
                _ if joint.kind().dofs() == 0 => continue,
                _ if system.is_locked(id) => &mut assumptions.locked,
                Some(_) => &mut assumptions.mimics,
                None => &mut assumptions.free,
            };
            list.push(joint.name().to_owned());
        }
        assumptions
    }
}
