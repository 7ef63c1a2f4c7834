//! What an answer assumes, for people: base, locks, mimics, drivers.

use crate::answer::Prepared;
use percuss_dynamics::{Base, Pose};

/// What an answer assumes; for people, not in the JSON.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assumptions {
    /// `fixed` or `floating`, and the root link.
    pub base: String,
    /// Joints that are neither locked nor mimics.
    pub free: Vec<String>,
    /// Joints that are locked, or follow a joint that is.
    pub locked: Vec<String>,
    /// Joints that follow others.
    pub mimics: Vec<String>,
    /// Joints that were set.
    pub set: Vec<String>,
    /// Joints that drive loops.
    pub drivers: Vec<String>,
}

impl Assumptions {
    /// What the answer at a pose assumes.
    pub(crate) fn of(prepared: &Prepared, pose: &Pose) -> Self {
        let (system, question) = (&prepared.system, prepared.question);
        let mechanism = system.mechanism();
        let root = mechanism.link(mechanism.root()).name();
        let mut assumptions = Assumptions {
            base: match question.base {
                Base::Fixed => format!("fixed (root link \"{root}\" is the ground)"),
                Base::Floating => format!("floating (root link \"{root}\" moves freely)"),
            },
            set: question.set.iter().map(|(joint, _)| joint.clone()).collect(),
            drivers: pose.loops().map_or_else(Vec::new, |l| {
                l.drivers.iter().map(|id| mechanism.joint(*id).name().to_owned()).collect()
            }),
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
