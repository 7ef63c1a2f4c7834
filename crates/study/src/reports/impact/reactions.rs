//! Reactions of an impact as records.

use percuss_dynamics::Pose;
use percuss_impact::{Component, Reaction, Reactions};
use percuss_mechanism::{LinkId, LoopFrame, Mechanism};
use serde::Serialize;

/// Place of a reaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
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
#[derive(Clone, Debug, PartialEq, Serialize)]
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
    /// Impulse of a lock, mimic or coupling on each velocity of the joint, N·m·s or N·s; empty without a joint.
    pub constraint: Vec<Option<f64>>,
    /// Largest force along the axes in a compliant contact, N; null without a contact law.
    pub peak_force: Option<[Option<f64>; 3]>,
    /// Largest moment in a compliant contact, N·m; null without a contact law.
    pub peak_moment: Option<[Option<f64>; 3]>,
}

/// Records of all reactions. `peak_per_impulse`: largest contact force per impulse of the contact, 1/s.
pub(crate) fn records(
    pose: &Pose,
    reactions: &Reactions,
    holds: &[String],
    peak_per_impulse: Option<f64>,
) -> Vec<ReactionRecord> {
    let mechanism = pose.mechanism();
    let link = |id: LinkId| Some(mechanism.link(id).name().to_owned());
    let record =
        |place, name: &str, reaction: &Reaction| record(pose, place, name, reaction, peak_per_impulse);
    let mut all = Vec::new();
    for joint in &reactions.joints {
        let declared = mechanism.joint(joint.joint);
        all.push(ReactionRecord {
            from: link(declared.parent()),
            on: link(declared.child()),
            gear: joint.drives.iter().map(|drive| drive.gear).collect(),
            constraint: joint.drives.iter().map(|drive| drive.constraint.value()).collect(),
            ..record(ReactionPlace::Joint, declared.name(), &joint.reaction)
        });
    }
    for (closure, reaction) in mechanism.closures().iter().zip(&reactions.closures) {
        let name = |end: &LoopFrame| end.link.and_then(link);
        all.push(ReactionRecord {
            from: name(closure.predecessor()),
            on: name(closure.successor()),
            ..record(ReactionPlace::Closure, closure.name(), reaction)
        });
    }
    for (name, reaction) in holds.iter().zip(&reactions.holds) {
        let held = record(ReactionPlace::Hold, name, reaction);
        all.push(ReactionRecord { on: Some(name.clone()), ..held });
    }
    if let Some(ground) = &reactions.ground {
        let root = root_name(mechanism);
        let on_root = record(ReactionPlace::Ground, &root, ground);
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
    peak_per_impulse: Option<f64>,
) -> ReactionRecord {
    let values = |components: [Component; 3]| components.map(Component::value);
    let peak = |components: [Component; 3]| {
        peak_per_impulse.map(|factor| values(components.map(|c| c.scaled(factor))))
    };
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
        peak_force: peak(reaction.force),
        peak_moment: peak(reaction.moment),
    }
}
