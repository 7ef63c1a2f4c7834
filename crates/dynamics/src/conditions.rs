//! What an analysis imposes on a mechanism, without rebuilding it.

use crate::input::is_number;
use crate::tolerances::SHORTEST_DIRECTION;
use nalgebra::Vector3;
use percuss_mechanism::{JointKind, LinkId, Mechanism, UnknownName};

/// How the root link stands in the world.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Base {
    /// The root link is the ground.
    #[default]
    Fixed,
    /// The root link moves freely.
    Floating,
}

/// A held contact: velocity rows only.
#[derive(Clone, Debug)]
pub(crate) struct CompiledHold {
    pub link: LinkId,
    /// In the link's frame, m.
    pub point: Vector3<f64>,
    /// Root axes; none holds three directions.
    pub normal: Option<Vector3<f64>>,
}

impl CompiledHold {
    pub fn rows(&self) -> usize {
        if self.normal.is_some() { 1 } else { 3 }
    }

    /// Held directions in root axes: the first [`rows`](Self::rows) of them.
    pub fn directions(&self) -> [Vector3<f64>; 3] {
        self.normal.map_or_else(|| [Vector3::x(), Vector3::y(), Vector3::z()], |n| [n; 3])
    }
}

/// Base, locks and armatures of one analysis. The default: fixed base, everything free, armatures as declared.
#[derive(Clone, Debug, Default)]
pub struct Conditions {
    pub(crate) base: Base,
    pub(crate) locked: Vec<String>,
    pub(crate) armatures: Vec<(String, Vec<f64>)>,
    pub(crate) held: Vec<(String, Vector3<f64>, Option<Vector3<f64>>)>,
    pub(crate) keep_fixed_joints: bool,
}

impl Conditions {
    /// Fixed base, everything free, armatures as declared.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets how the root link stands in the world.
    pub fn base(mut self, base: Base) -> Self {
        self.base = base;
        self
    }

    /// Holds a joint at its position: its velocities are zero.
    pub fn lock(mut self, joint: impl Into<String>) -> Self {
        self.locked.push(joint.into());
        self
    }

    /// Replaces a joint's armature: one value for all its velocities, or one each (kg·m² or kg).
    pub fn armature(mut self, joint: impl Into<String>, values: impl Into<Vec<f64>>) -> Self {
        self.armatures.push((joint.into(), values.into()));
        self
    }

    /// Holds a point (m, link's frame) of a link to the ground: along a normal in the root link's axes, or in all
    /// three directions. Velocities only; the pose does not move.
    pub fn hold(
        mut self,
        link: impl Into<String>,
        point: impl Into<Vector3<f64>>,
        normal: Option<Vector3<f64>>,
    ) -> Self {
        self.held.push((link.into(), point.into(), normal));
        self
    }

    /// Keeps links joined by fixed joints as bodies of their own. The results do not change; the cost does.
    pub fn keep_fixed_joints(mut self) -> Self {
        self.keep_fixed_joints = true;
        self
    }

    /// Whether it holds velocities that the pose does not know of.
    pub(crate) fn holds_velocities(&self) -> bool {
        !self.locked.is_empty() || !self.held.is_empty()
    }

    /// The same without locks and held contacts.
    pub(crate) fn without_holds(self) -> Self {
        Self { locked: Vec::new(), held: Vec::new(), ..self }
    }

    /// Armature of every joint, one value a velocity, overrides applied.
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

    /// Held contacts, their links found and their normals made unit vectors.
    pub(crate) fn resolve_holds(&self, mechanism: &Mechanism) -> Result<Vec<CompiledHold>, ConditionsError> {
        let resolve = |(name, point, normal): &(String, Vector3<f64>, Option<Vector3<f64>>)| {
            let link = mechanism.find_link(name)?;
            let numbers = point.iter().chain(normal.iter().flat_map(|n| n.iter()));
            if let Some(&value) = numbers.into_iter().find(|x| !is_number(**x)) {
                return Err(ConditionsError::BadHold {
                    link: name.clone(),
                    why: format!("{value} is no coordinate"),
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

    /// Whether each joint is locked.
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

/// A condition that is given for a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConditionOfJoint {
    /// Its rotor's inertia.
    Armature,
    /// It cannot move.
    Lock,
}

impl ConditionOfJoint {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            ConditionOfJoint::Armature => "armature",
            ConditionOfJoint::Lock => "lock",
        }
    }
}

/// Conditions that do not fit the mechanism.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConditionsError {
    /// A joint or link that does not exist.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// A held contact that means nothing.
    #[error("the held contact of link \"{link}\": {why}")]
    BadHold {
        /// The link.
        link: String,
        /// What is wrong.
        why: String,
    },
    /// The same condition given twice for a joint.
    #[error("{} of joint \"{joint}\" is given twice", condition.name())]
    Twice {
        /// Which.
        condition: ConditionOfJoint,
        /// The joint.
        joint: String,
    },
    /// Not a number ≥ 0.
    #[error("armature of joint \"{joint}\" is {value}; expected a finite number ≥ 0 (kg·m² or kg)")]
    BadArmature {
        /// The joint.
        joint: String,
        /// What was given.
        value: f64,
    },
    /// The count fits neither one nor the joint's velocities.
    #[error(
        "armature of joint \"{joint}\" has {got} values; a {} joint takes {}", kind.name(), expected(*kind)
    )]
    ArmatureCount {
        /// The joint.
        joint: String,
        /// Its kind.
        kind: JointKind,
        /// How many were given.
        got: usize,
    },
}

fn expected(kind: JointKind) -> String {
    match (kind.dofs(), kind.is_homogeneous()) {
        (0, _) => "none: it does not move".into(),
        (1, _) => "one".into(),
        (dofs, true) => format!("one, or {dofs}"),
        (dofs, false) => format!("{dofs}, one for each velocity"),
    }
}
