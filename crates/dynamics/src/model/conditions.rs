//! Conditions of an analysis: base, locks, held contacts and armatures, imposed without rebuilding the mechanism.

use crate::model::input::is_number;
use crate::tolerances::SHORTEST_DIRECTION;
use nalgebra::Vector3;
use percuss_mechanism::{JointKind, LinkId, Mechanism, UnknownName};

/// Attachment of the root link to the world.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Base {
    /// The root link is the ground.
    #[default]
    Fixed,
    /// The root link moves freely.
    Floating,
}

/// A held contact; a constraint on velocities only.
#[derive(Clone, Debug)]
pub(crate) struct CompiledHold {
    pub link: LinkId,
    /// Held point in the frame of the link, m.
    pub point: Vector3<f64>,
    /// Held direction in root axes; `None` holds all three directions.
    pub normal: Option<Vector3<f64>>,
}

impl CompiledHold {
    /// Number of constraint rows.
    pub fn rows(&self) -> usize {
        if self.normal.is_some() { 1 } else { 3 }
    }

    /// Held directions in root axes; only the first [`rows`](Self::rows) are used.
    pub fn directions(&self) -> [Vector3<f64>; 3] {
        self.normal.map_or_else(|| [Vector3::x(), Vector3::y(), Vector3::z()], |n| [n; 3])
    }
}

/// Base, locks, held contacts and armatures of one analysis. Default: fixed base, all joints free, armatures as
/// declared.
#[derive(Clone, Debug, Default)]
pub struct Conditions {
    pub(crate) base: Base,
    pub(crate) locked: Vec<String>,
    pub(crate) armatures: Vec<(String, Vec<f64>)>,
    pub(crate) held: Vec<(String, Vector3<f64>, Option<Vector3<f64>>)>,
    pub(crate) keep_fixed_joints: bool,
}

impl Conditions {
    /// Conditions with fixed base, all joints free, and armatures as declared.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the attachment of the root link to the world.
    pub fn base(mut self, base: Base) -> Self {
        self.base = base;
        self
    }

    /// Locks a joint at its position: its velocities are zero.
    pub fn lock(mut self, joint: impl Into<String>) -> Self {
        self.locked.push(joint.into());
        self
    }

    /// Replaces a joint's armature: one value for all its velocities, or one value per velocity (kg·m² or kg).
    pub fn armature(mut self, joint: impl Into<String>, values: impl Into<Vec<f64>>) -> Self {
        self.armatures.push((joint.into(), values.into()));
        self
    }

    /// Holds a point (m, link frame) of a link to the ground, along a normal in the axes of the root link or in all
    /// three directions. Only velocities are constrained; the pose does not change.
    pub fn hold(
        mut self,
        link: impl Into<String>,
        point: impl Into<Vector3<f64>>,
        normal: Option<Vector3<f64>>,
    ) -> Self {
        self.held.push((link.into(), point.into(), normal));
        self
    }

    /// Keeps links joined by fixed joints as separate bodies. The results do not change; the cost does.
    pub fn keep_fixed_joints(mut self) -> Self {
        self.keep_fixed_joints = true;
        self
    }

    /// True if joints are locked or contacts are held. These conditions constrain velocities, not the pose.
    pub(crate) fn holds_velocities(&self) -> bool {
        !self.locked.is_empty() || !self.held.is_empty()
    }

    /// Returns the conditions without locks and held contacts.
    pub(crate) fn without_holds(self) -> Self {
        Self { locked: Vec::new(), held: Vec::new(), ..self }
    }

    /// Armature of every joint, one value per velocity, with overrides applied.
    pub(crate) fn resolve_armatures(&self, mechanism: &Mechanism) -> Result<Vec<Vec<f64>>, ConditionsError> {
        let mut all: Vec<Vec<f64>> = mechanism.joints().iter().map(|j| j.armature().to_vec()).collect();
        let mut seen = vec![false; all.len()];
        for (name, values) in &self.armatures {
            let id = mechanism.find_joint(name)?;
            let joint = mechanism.joint(id);
            if std::mem::replace(&mut seen[id.index()], true) {
                return Err(ConditionsError::Twice {
                    condition: ConditionOfJoint::Armature,
                    joint: name.clone(),
                });
            }
            if let Some(&value) = values.iter().find(|v| !(v.is_finite() && **v >= 0.0)) {
                return Err(ConditionsError::BadArmature { joint: name.clone(), value });
            }
            let (dofs, one_fits) = (joint.kind().dofs(), joint.kind().is_homogeneous());
            all[id.index()] = match values[..] {
                [value] if one_fits && dofs > 0 => vec![value; dofs],
                _ if values.len() == dofs && dofs > 0 => values.clone(),
                _ => {
                    return Err(ConditionsError::ArmatureCount {
                        joint: name.clone(),
                        kind: joint.kind(),
                        got: values.len(),
                    });
                }
            };
        }
        Ok(all)
    }

    /// Resolves the links of the held contacts and normalises the normals.
    pub(crate) fn resolve_holds(&self, mechanism: &Mechanism) -> Result<Vec<CompiledHold>, ConditionsError> {
        let resolve = |(name, point, normal): &(String, Vector3<f64>, Option<Vector3<f64>>)| {
            let link = mechanism.find_link(name)?;
            let numbers = point.iter().chain(normal.iter().flat_map(|n| n.iter()));
            if let Some(&value) = numbers.into_iter().find(|x| !is_number(**x)) {
                return Err(ConditionsError::BadHold {
                    link: name.clone(),
                    why: format!("{value} is not a coordinate"),
                });
            }
            if normal.is_some_and(|n| n.norm() < SHORTEST_DIRECTION) {
                return Err(ConditionsError::BadHold {
                    link: name.clone(),
                    why: "its normal has no length".into(),
                });
            }
            Ok(CompiledHold { link, point: *point, normal: normal.map(|n| n.normalize()) })
        };
        self.held.iter().map(resolve).collect()
    }

    /// Lock flag of every joint.
    pub(crate) fn resolve_locks(&self, mechanism: &Mechanism) -> Result<Vec<bool>, ConditionsError> {
        let mut locked = vec![false; mechanism.joints().len()];
        for name in &self.locked {
            let id = mechanism.find_joint(name)?;
            if std::mem::replace(&mut locked[id.index()], true) {
                return Err(ConditionsError::Twice {
                    condition: ConditionOfJoint::Lock,
                    joint: name.clone(),
                });
            }
        }
        Ok(locked)
    }
}

/// Condition of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConditionOfJoint {
    /// Rotor inertia.
    Armature,
    /// Lock.
    Lock,
}

impl ConditionOfJoint {
    /// Name for messages.
    pub fn name(self) -> &'static str {
        match self {
            ConditionOfJoint::Armature => "armature",
            ConditionOfJoint::Lock => "lock",
        }
    }
}

/// Error of conditions that do not fit the mechanism.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConditionsError {
    /// A joint or link does not exist.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// A held contact is invalid.
    #[error("the held contact of link \"{link}\": {why}")]
    BadHold {
        /// The link.
        link: String,
        /// Description of the defect.
        why: String,
    },
    /// A condition is given twice for a joint.
    #[error("{} of joint \"{joint}\" is given twice", condition.name())]
    Twice {
        /// The condition.
        condition: ConditionOfJoint,
        /// The joint.
        joint: String,
    },
    /// An armature is negative or not finite.
    #[error("armature of joint \"{joint}\" is {value}; expected a finite number ≥ 0 (kg·m² or kg)")]
    BadArmature {
        /// The joint.
        joint: String,
        /// The given value.
        value: f64,
    },
    /// The number of armatures is neither one nor the number of the joint's velocities.
    #[error(
        "armature of joint \"{joint}\" has {got} values; a {} joint takes {}", kind.name(), expected(*kind)
    )]
    ArmatureCount {
        /// The joint.
        joint: String,
        /// Kind of the joint.
        kind: JointKind,
        /// Number of given values.
        got: usize,
    },
}

/// Accepted numbers of armatures, for messages.
fn expected(kind: JointKind) -> String {
    match (kind.dofs(), kind.is_homogeneous()) {
        (0, _) => "none: it does not move".into(),
        (1, _) => "one".into(),
        (dofs, true) => format!("one, or {dofs}"),
        (dofs, false) => format!("{dofs}, one for each velocity"),
    }
}
