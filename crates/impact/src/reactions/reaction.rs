//! Impulsive reactions, component by component.

use percuss_mechanism::JointId;
use percuss_spatial::Transform;

/// Component of a reaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Component {
    /// The value, which every solution of the constraint equations shares.
    Determinate(f64),
    /// Redundant constraints leave the value open: it depends on the stiffnesses of the parts.
    Indeterminate,
}

impl Component {
    /// The value; `None` if indeterminate.
    pub fn value(self) -> Option<f64> {
        match self {
            Component::Determinate(value) => Some(value),
            Component::Indeterminate => None,
        }
    }

    /// The component times a factor.
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            Component::Determinate(value) => Component::Determinate(factor * value),
            Component::Indeterminate => Component::Indeterminate,
        }
    }
}

/// Impulsive reaction: action of the parent on the child link (joint), of the predecessor on the successor (closure), or
/// of the ground on the link (held contact, root link).
#[derive(Clone, Debug, PartialEq)]
pub struct Reaction {
    /// X_rf: frame of the components, in the frame of the root link. The moment refers to its origin: the origin of
    /// the child link, of the successor's loop frame, or the held point. The axes are two transverse directions and
    /// the axis of the joint or closure, or those of the link without an axis.
    pub frame: Transform<f64>,
    /// Impulse along the axes of the frame, N·s.
    pub force: [Component; 3],
    /// Moment impulse about the origin of the frame, along its axes, N·m·s.
    pub moment: [Component; 3],
    /// Names of the loops whose redundancy leaves components open; empty if all are determinate.
    pub loops: Vec<String>,
}

impl Reaction {
    /// Zero reaction.
    pub(crate) fn zero() -> Self {
        let none = [Component::Determinate(0.0); 3];
        Self { frame: Transform::identity(), force: none, moment: none, loops: Vec::new() }
    }

    /// The reaction times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let scale = |components: [Component; 3]| components.map(|c| c.scaled(factor));
        Self {
            frame: self.frame,
            force: scale(self.force),
            moment: scale(self.moment),
            loops: self.loops.clone(),
        }
    }

    /// Magnitude of the impulse, N·s; `None` if a component is indeterminate.
    pub fn force_magnitude(&self) -> Option<f64> {
        magnitude(&self.force)
    }

    /// Magnitude of the moment impulse, N·m·s; `None` if a component is indeterminate.
    pub fn moment_magnitude(&self) -> Option<f64> {
        magnitude(&self.moment)
    }
}

/// Euclidean norm of three components; `None` if a component is indeterminate.
fn magnitude(components: &[Component; 3]) -> Option<f64> {
    let values: Option<Vec<f64>> = components.iter().map(|c| c.value()).collect();
    values.map(|values| values.iter().map(|x| x * x).sum::<f64>().sqrt())
}

/// Impulses on one velocity of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriveImpulse {
    /// Impulse in the gear between rotor and joint: armature · Δq̇, N·m·s or N·s. The rotor receives it, the joint the
    /// opposite.
    pub gear: f64,
    /// Sum of the impulses of the lock, the mimics and the couplings on the joint, N·m·s or N·s; zero for a free joint. The sum can be
    /// determinate if the single impulses ([`Reactions::joint_constraints`]) are not.
    pub constraint: Component,
}

/// Lock, mimic or coupling of joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointConstraint {
    /// Lock of this joint.
    Lock(JointId),
    /// Mimic: this joint mimics a master.
    Mimic(JointId),
    /// Coupling: index into [`Mechanism::couplings`](percuss_mechanism::Mechanism::couplings).
    Coupling(usize),
}

/// Reaction of a lock, a mimic or a coupling.
#[derive(Clone, Debug, PartialEq)]
pub struct JointConstraintReaction {
    /// The lock, the mimic or the coupling.
    pub constraint: JointConstraint,
    /// Impulse on each velocity of its joints, N·m·s or N·s: joint, index of the velocity within the joint, impulse.
    pub impulses: Vec<(JointId, usize, Component)>,
    /// Names of the constraints whose redundancy leaves impulses open; empty if they are determinate.
    pub open_by: Vec<String>,
}

/// Reaction in a joint of the tree.
#[derive(Clone, Debug, PartialEq)]
pub struct JointReaction {
    /// The joint.
    pub joint: JointId,
    /// Wrench of the parent on the child link. Along free axes it is the impulse of gear, mimic and coupling.
    pub reaction: Reaction,
    /// Impulses on each velocity of the joint.
    pub drives: Vec<DriveImpulse>,
}

/// Reactions in all joints, closures and held contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct Reactions {
    /// Action of the ground on the root link, in root axes at the root origin; `None` for a floating base.
    pub ground: Option<Reaction>,
    /// Reactions in the joints, in joint order. Fixed joints are included.
    pub joints: Vec<JointReaction>,
    /// Reactions in the closures, in the order of the mechanism.
    pub closures: Vec<Reaction>,
    /// Reactions at the held contacts, in the order of the conditions.
    pub holds: Vec<Reaction>,
    /// Reactions of the locks and of the mimics, in joint order, then of the couplings, in the order of the mechanism.
    pub joint_constraints: Vec<JointConstraintReaction>,
    /// Largest unbalanced generalised impulse over scaled coordinates, relative to the impulse at the contact: the
    /// error of the motion and of the multipliers.
    pub residual: f64,
}

impl Reactions {
    /// Empty reactions, without allocated memory.
    pub(crate) fn none() -> Self {
        Self {
            ground: None,
            joints: Vec::new(),
            closures: Vec::new(),
            holds: Vec::new(),
            joint_constraints: Vec::new(),
            residual: 0.0,
        }
    }

    /// Magnitudes of the forces of all reactions, N·s for impulses, of the components that are determinate: joints, closures, held contacts, then
    /// the ground.
    pub fn determinate_forces(&self) -> Vec<f64> {
        let joints = self.joints.iter().map(|joint| &joint.reaction);
        let all = joints.chain(&self.closures).chain(&self.holds).chain(&self.ground);
        let size =
            |force: &[Component; 3]| force.iter().filter_map(|c| c.value()).map(|x| x * x).sum::<f64>();
        all.map(|reaction| size(&reaction.force).sqrt()).collect()
    }

    /// All reactions times a factor; the relative residual is kept.
    pub fn scaled(&self, factor: f64) -> Self {
        let joint = |j: &JointReaction| JointReaction {
            joint: j.joint,
            reaction: j.reaction.scaled(factor),
            drives: j
                .drives
                .iter()
                .map(|d| DriveImpulse { gear: factor * d.gear, constraint: d.constraint.scaled(factor) })
                .collect(),
        };
        let constraint = |c: &JointConstraintReaction| JointConstraintReaction {
            impulses: c.impulses.iter().map(|(joint, k, value)| (*joint, *k, value.scaled(factor))).collect(),
            ..c.clone()
        };
        Self {
            ground: self.ground.as_ref().map(|r| r.scaled(factor)),
            joints: self.joints.iter().map(joint).collect(),
            closures: self.closures.iter().map(|r| r.scaled(factor)).collect(),
            holds: self.holds.iter().map(|r| r.scaled(factor)).collect(),
            joint_constraints: self.joint_constraints.iter().map(constraint).collect(),
            residual: self.residual,
        }
    }
}
