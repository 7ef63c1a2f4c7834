//! Bushes: elastic connections of two links.

use crate::{ClosureId, JointId, LinkId};
use percuss_spatial::Transform;

/// Description of a bush for the builder.
///
/// A bush resists the motion of its frame, fixed to `link`, relative to `against`, with one row for each direction of
/// the frame:
///
/// ```text
/// force of row i = −(kᵢ (1 + iη) + cᵢ d/dt) xᵢ
/// ```
///
/// The z-axis is the axis of the bush. Rows 0 to 2 are small rotations about x, y (conical) and z (torsional), rows 3 to 5
/// translations along x, y (radial) and z (axial). All bush data of other programs agree with this to first order without preload.
///
/// A bush has no influence on the rigid mechanism, which keeps the joints and closures that the bush `replaces`.
#[derive(Clone, Debug, PartialEq)]
pub struct BushDescription {
    /// Unique name among bushes.
    pub name: String,
    /// Name of the link that carries the frame.
    pub link: String,
    /// X_lf: bush frame in the link.
    pub frame: Transform<f64>,
    /// Name of the link on the other side; `world` is the ground, unless a link has this name.
    pub against: String,
    /// Stiffness k of each row, N·m/rad and N/m; infinite for an ideal row, which allows no motion.
    pub stiffness: [f64; 6],
    /// Damping c of each row, N·m·s/rad and N·s/m.
    pub damping: [f64; 6],
    /// Loss factor η of all rows; in time a damper c = ηk/ω at one frequency.
    pub loss_factor: f64,
    /// Factor of the stiffness in motions: stiffness in motion divided by the static stiffness.
    pub dynamic_factor: f64,
    /// Force of each row on `link` at all poses of the rigid mechanism, N·m and N, along the axes of the bush, which move with the link. Static
    /// displacements and vibrations have its geometric stiffness, which impacts in time leave out.
    pub preload: [f64; 6],
    /// Rows that the rigid mechanism holds. A torsional rate, a spring or a tyre is no such row.
    pub rigid: [bool; 6],
    /// Names of the tree joints and closures between the two links whose place the bush takes. Of several tree joints the last becomes free.
    pub replaces: Vec<String>,
}

impl BushDescription {
    /// Bush between the origin of a link and another link, without stiffness, in place of no joint.
    pub fn new(name: impl Into<String>, link: impl Into<String>, against: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            link: link.into(),
            frame: Transform::identity(),
            against: against.into(),
            stiffness: [0.0; 6],
            damping: [0.0; 6],
            loss_factor: 0.0,
            dynamic_factor: 1.0,
            preload: [0.0; 6],
            rigid: [false; 6],
            replaces: Vec::new(),
        }
    }

    /// Sets the place of a joint that the bush takes: the bush then holds the three translations of the rigid mechanism.
    pub fn replacing(mut self, joint: impl Into<String>) -> Self {
        self.replaces.push(joint.into());
        self.rigid = [false, false, false, true, true, true];
        self
    }

    /// Sets the bush frame in the link.
    pub fn frame(mut self, x_lf: Transform<f64>) -> Self {
        self.frame = x_lf;
        self
    }

    /// Sets radial and axial stiffness, N/m.
    pub fn translational(mut self, radial: f64, axial: f64) -> Self {
        self.stiffness[3..].copy_from_slice(&[radial, radial, axial]);
        self
    }

    /// Sets conical and torsional stiffness, N·m/rad.
    pub fn rotational(mut self, conical: f64, torsional: f64) -> Self {
        self.stiffness[..3].copy_from_slice(&[conical, conical, torsional]);
        self
    }
}

/// Bush of a mechanism: see [`BushDescription`].
#[derive(Clone, Debug, PartialEq)]
pub struct Bush {
    pub(crate) description: BushDescription,
    pub(crate) link: LinkId,
    pub(crate) against: Option<LinkId>,
    pub(crate) joints: Vec<JointId>,
    pub(crate) closures: Vec<ClosureId>,
}

impl Bush {
    /// Name, unique among the bushes.
    pub fn name(&self) -> &str {
        &self.description.name
    }

    /// Frame, stiffness and damping.
    pub fn description(&self) -> &BushDescription {
        &self.description
    }

    /// Link that carries the frame.
    pub fn link(&self) -> LinkId {
        self.link
    }

    /// Link on the other side; `None` for the ground.
    pub fn against(&self) -> Option<LinkId> {
        self.against
    }

    /// Tree joints whose place the bush takes; the last becomes free, the others fixed.
    pub fn joints(&self) -> &[JointId] {
        &self.joints
    }

    /// Closures whose place the bush takes.
    pub fn closures(&self) -> &[ClosureId] {
        &self.closures
    }
}
