//! Reactions of an impact as records.

use percuss_dynamics::Pose;
use percuss_impact::{Component, JointConstraint, JointConstraintReaction, Reaction, Reactions};
use percuss_mechanism::{JointId, LinkId, LoopFrame, Mechanism};
use schemars::JsonSchema;
use serde::Serialize;

/// Place of a reaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ReactionPlace {
    /// Root link on the ground.
    Ground,
    /// Joint of the tree.
    Joint,
    /// Closure of a loop.
    Closure,
    /// Held point.
    Hold,
}

/// Impulsive reaction at one place, component by component. Null marks components that redundant loops leave open.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ReactionRecord {
    /// Place.
    pub place: ReactionPlace,
    /// Name of the joint or closure; of the held link; of the root link.
    pub name: String,
    /// Link that exerts the reaction; null for the ground.
    pub from: Option<String>,
    /// Link on which the reaction acts; null for the ground.
    pub on: Option<String>,
    /// Point to which the moment refers, world frame, m.
    pub point_world: [f64; 3],
    /// Unit vectors of the components, world axes: two transverse directions, then the axis of the joint.
    pub axes_world: [[f64; 3]; 3],
    /// Impulse along the axes, N·s.
    pub force: [Option<f64>; 3],
    /// Moment impulse about the point, N·m·s.
    pub moment: [Option<f64>; 3],
    /// Loops whose redundancy leaves components open.
    pub open_by: Vec<String>,
    /// Impulse in the gear of each velocity of the joint, armature · Δq̇, N·m·s or N·s; empty without a joint.
    pub gear: Vec<f64>,
    /// Sum of the impulses of the lock, the mimics and the couplings on each velocity of the joint, N·m·s or N·s; empty without a joint.
    /// `joint_constraints` of the report contains the single impulses.
    pub constraint: Vec<Option<f64>>,
    /// Largest force along the axes in a compliant contact, N; null without a contact law.
    pub peak_force: Option<[Option<f64>; 3]>,
    /// Largest moment in a compliant contact, N·m; null without a contact law.
    pub peak_moment: Option<[Option<f64>; 3]>,
}

/// Kind of a constraint of joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum JointConstraintKind {
    /// Locked joint.
    Lock,
    /// Joint that mimics another.
    Mimic,
    /// Coupling.
    Coupling,
}

impl JointConstraintKind {
    /// Name in text.
    pub fn name(self) -> &'static str {
        match self {
            JointConstraintKind::Lock => "lock",
            JointConstraintKind::Mimic => "mimic",
            JointConstraintKind::Coupling => "coupling",
        }
    }
}

/// Impulses of a lock, a mimic or a coupling on its joints.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointConstraintRecord {
    /// Kind.
    pub kind: JointConstraintKind,
    /// Name of the locked joint, of the joint that mimics another, or of the coupling.
    pub name: String,
    /// Joint of each impulse; a locked joint occurs once for each of its velocities.
    pub joints: Vec<String>,
    /// Impulse on each velocity, N·m·s or N·s. Null if redundant constraints leave the impulse open; the sum on the joint (`constraint` of
    /// its reaction) can still be determinate.
    pub impulses: Vec<Option<f64>>,
    /// Constraints that leave impulses open: loops, couplings, mimics and locks.
    pub open_by: Vec<String>,
}

/// Records of all locks, mimics and couplings.
pub(crate) fn joint_constraint_records(
    mechanism: &Mechanism,
    reactions: &Reactions,
) -> Vec<JointConstraintRecord> {
    let joint_name = |joint: JointId| mechanism.joint(joint).name().to_owned();
    let record = |reaction: &JointConstraintReaction| {
        let (kind, name) = match reaction.constraint {
            JointConstraint::Lock(joint) => (JointConstraintKind::Lock, joint_name(joint)),
            JointConstraint::Mimic(joint) => (JointConstraintKind::Mimic, joint_name(joint)),
            JointConstraint::Coupling(i) => {
                (JointConstraintKind::Coupling, mechanism.couplings()[i].name().to_owned())
            }
        };
        JointConstraintRecord {
            kind,
            name,
            joints: reaction.impulses.iter().map(|(joint, ..)| joint_name(*joint)).collect(),
            impulses: reaction.impulses.iter().map(|(.., impulse)| impulse.value()).collect(),
            open_by: reaction.open_by.clone(),
        }
    };
    reactions.joint_constraints.iter().map(record).collect()
}

/// Records of all reactions. `peak`: reactions to a normal impulse p at the contact, and the peak normal force divided by p, 1/s; the peak
/// of a reaction is their product.
pub(crate) fn records(
    pose: &Pose,
    reactions: &Reactions,
    holds: &[String],
    peak: Option<(&Reactions, f64)>,
) -> Vec<ReactionRecord> {
    let mechanism = pose.mechanism();
    let link = |id: LinkId| Some(mechanism.link(id).name().to_owned());
    let peaks = peak.map(|(reactions, factor)| reactions.scaled(factor));
    let mut all = Vec::new();
    for (k, joint) in reactions.joints.iter().enumerate() {
        let peak = peaks.as_ref().map(|peaks| &peaks.joints[k].reaction);
        let declared = mechanism.joint(joint.joint);
        all.push(ReactionRecord {
            from: link(declared.parent()),
            on: link(declared.child()),
            gear: joint.drives.iter().map(|drive| drive.gear).collect(),
            constraint: joint.drives.iter().map(|drive| drive.constraint.value()).collect(),
            ..record(pose, ReactionPlace::Joint, declared.name(), &joint.reaction, peak)
        });
    }
    for (k, (closure, reaction)) in mechanism.closures().iter().zip(&reactions.closures).enumerate() {
        let peak = peaks.as_ref().map(|peaks| &peaks.closures[k]);
        let name = |end: &LoopFrame| end.link.and_then(link);
        all.push(ReactionRecord {
            from: name(closure.predecessor()),
            on: name(closure.successor()),
            ..record(pose, ReactionPlace::Closure, closure.name(), reaction, peak)
        });
    }
    for (k, (name, reaction)) in holds.iter().zip(&reactions.holds).enumerate() {
        let peak = peaks.as_ref().map(|peaks| &peaks.holds[k]);
        let held = record(pose, ReactionPlace::Hold, name, reaction, peak);
        all.push(ReactionRecord { on: Some(name.clone()), ..held });
    }
    if let Some(ground) = &reactions.ground {
        let root = root_name(mechanism);
        let peak = peaks.as_ref().and_then(|peaks| peaks.ground.as_ref());
        let on_root = record(pose, ReactionPlace::Ground, &root, ground, peak);
        all.push(ReactionRecord { on: Some(root.clone()), ..on_root });
    }
    all
}

/// Name of the root link.
fn root_name(mechanism: &Mechanism) -> String {
    mechanism.link(mechanism.root()).name().to_owned()
}

/// Record of one reaction, without its links.
fn record(
    pose: &Pose,
    place: ReactionPlace,
    name: &str,
    reaction: &Reaction,
    peak: Option<&Reaction>,
) -> ReactionRecord {
    let values = |components: [Component; 3]| components.map(Component::value);
    let axes = pose.base().rotation * reaction.frame.rotation;
    ReactionRecord {
        place,
        name: name.to_owned(),
        from: None,
        on: None,
        point_world: pose.base().point(&reaction.frame.translation).into(),
        axes_world: [0, 1, 2].map(|k| axes.column(k).into_owned().into()),
        force: values(reaction.force),
        moment: values(reaction.moment),
        open_by: reaction.loops.clone(),
        gear: Vec::new(),
        constraint: Vec::new(),
        peak_force: peak.map(|peak| values(peak.force)),
        peak_moment: peak.map(|peak| values(peak.moment)),
    }
}
