//! Rows of elastic elements: bushes, and springs or dampers between two points.

use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use nalgebra::{DVector, Vector3};
use percuss_mechanism::{Bush, JointId, JointKind, LinkId};

/// Spring, damper or gear that acts beside the bushes: force −(k + c d/dt) per displacement of its motion.
///
/// An infinite stiffness holds the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearElement {
    /// Name for results.
    pub name: String,
    /// Motion that it resists.
    pub motion: ElementMotion,
    /// Stiffness, N/m or N·m/rad.
    pub stiffness: f64,
    /// Damping, N·s/m or N·m·s/rad.
    pub damping: f64,
    /// Force at the pose along the motion, N or N·m: that of a compressed spring is positive. Its geometric stiffness acts in static displacements
    /// and after [`ElasticSystem::with_geometric_stiffness`](super::system::ElasticSystem::with_geometric_stiffness).
    pub force: f64,
}

impl LinearElement {
    /// Element without damping and without a force at the pose.
    pub fn spring(name: impl Into<String>, motion: ElementMotion, stiffness: f64) -> Self {
        Self { name: name.into(), motion, stiffness, damping: 0.0, force: 0.0 }
    }
}

/// Motion that a spring or damper resists.
#[derive(Clone, Debug, PartialEq)]
pub enum ElementMotion {
    /// Change of the distance of two points, each of a link, in the frame of the link (m).
    Length([(LinkId, Vector3<f64>); 2]),
    /// Displacement of a point of a link (m, link frame) over the ground along a direction in root axes.
    Along(LinkId, Vector3<f64>, Vector3<f64>),
    /// Motion of a joint with one velocity, less that of a second joint.
    Twist(JointId, Option<JointId>),
    /// Motion of a joint with one velocity, less that of its rotor, whose inertia is the armature of the joint: elasticity of the gear. The rigid
    /// mechanism holds it.
    Gear(JointId),
}

/// Direction of a row of an elastic element. The z-axis of a bush is its axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElasticDirection {
    /// Rotation of a bush about its x-axis.
    ConicalX,
    /// Rotation of a bush about its y-axis.
    ConicalY,
    /// Rotation of a bush about its axis.
    Torsional,
    /// Translation of a bush along its x-axis.
    RadialX,
    /// Translation of a bush along its y-axis.
    RadialY,
    /// Translation of a bush along its axis.
    Axial,
    /// Motion of a spring or damper.
    Element,
    /// Twist of a gear.
    Gear,
    /// Motion in which forces at the pose act by their change of direction: see [`ElasticSystem::with_geometric_stiffness`](super::system::ElasticSystem::with_geometric_stiffness).
    Geometric,
}

impl ElasticDirection {
    /// Directions of the rows of a bush, in the order of its stiffness.
    pub const OF_BUSH: [Self; 6] =
        [Self::ConicalX, Self::ConicalY, Self::Torsional, Self::RadialX, Self::RadialY, Self::Axial];

    /// Name for results.
    pub fn name(self) -> &'static str {
        match self {
            Self::ConicalX => "conical x",
            Self::ConicalY => "conical y",
            Self::Torsional => "torsional",
            Self::RadialX => "radial x",
            Self::RadialY => "radial y",
            Self::Axial => "axial",
            Self::Element => "motion",
            Self::Gear => "twist",
            Self::Geometric => "change of direction",
        }
    }
}

/// Row of an elastic element.
#[derive(Clone, Debug)]
pub(crate) struct ElasticRow {
    pub element: String,
    pub direction: ElasticDirection,
    /// Number of a spring, damper or gear in the list of elements; `None` for a bush.
    pub number: Option<usize>,
    /// Stiffness in motion, N/m or N·m/rad; infinite for an ideal row.
    pub stiffness: f64,
    /// Stiffness under loads at rest: without the dynamic factor.
    pub static_stiffness: f64,
    pub damping: f64,
    pub loss_factor: f64,
    /// True for a rotation: the row resists it by a moment.
    pub is_moment: bool,
    /// True if the rigid mechanism holds the row.
    pub is_rigid: bool,
    /// Force of an element or preload of a bush at the pose along its motion, N or N·m.
    pub force: f64,
    /// Relative velocity per velocity of each coordinate.
    pub row: DVector<f64>,
}

impl ElasticRow {
    /// True if the row has a stiffness or a damping.
    pub fn acts(&self) -> bool {
        self.is_elastic() || self.damping > 0.0
    }

    /// True if the row has a stiffness of an element: the geometric stiffness of forces at the pose is none.
    pub fn is_elastic(&self) -> bool {
        self.stiffness > 0.0 && !self.is_geometric()
    }

    /// True for a row of the geometric stiffness.
    pub fn is_geometric(&self) -> bool {
        self.direction == ElasticDirection::Geometric
    }
}

impl Model {
    /// Rows of a bush over the coordinates: velocities of the point of the other link that is in the middle of the bush at `drawn`, relative to the
    /// frame of the bush, which moves with its link. `drawn`: the pose as drawn, `None` if it is that of `kinematics`.
    pub(super) fn bush_rows(
        &self,
        kinematics: &Kinematics,
        drawn: Option<&Kinematics>,
        bush: &Bush,
    ) -> Vec<ElasticRow> {
        let description = bush.description();
        let frame = |kinematics: &Kinematics| kinematics.link_frame(self, bush.link()) * description.frame;
        let x_rf = frame(kinematics);
        let at = drawn.map_or(x_rf.translation, |drawn| {
            let other = bush.against().unwrap_or_else(|| self.mechanism.root());
            let point = drawn.link_frame(self, other).inverse_point(&frame(drawn).translation);
            kinematics.link_frame(self, other).point(&point)
        });
        let jacobians = |link: LinkId| {
            let point = kinematics.link_frame(self, link).inverse_point(&at);
            [self.angular_jacobian(kinematics, link), self.point_jacobian(kinematics, link, &point)]
        };
        let mut relative = jacobians(bush.link());
        if let Some(against) = bush.against() {
            relative.iter_mut().zip(jacobians(against)).for_each(|(own, other)| *own -= other);
        }
        let row = |(i, direction): (usize, ElasticDirection)| ElasticRow {
            element: bush.name().to_owned(),
            direction,
            number: None,
            stiffness: description.stiffness[i] * description.dynamic_factor,
            static_stiffness: description.stiffness[i],
            damping: description.damping[i],
            loss_factor: description.loss_factor,
            is_moment: i < 3,
            is_rigid: description.rigid[i],
            force: description.preload[i],
            row: relative[i / 3].tr_mul(&x_rf.rotation.column(i % 3)),
        };
        ElasticDirection::OF_BUSH.into_iter().enumerate().map(row).collect()
    }

    /// Row of a spring, damper or gear with its number; `None` for a line without length. The row of a gear is without its rotor.
    pub(super) fn element_row(
        &self,
        kinematics: &Kinematics,
        (number, element): (usize, &LinearElement),
    ) -> Option<ElasticRow> {
        let frame = |link: LinkId| kinematics.link_frame(self, link);
        let velocity = |link: LinkId, point: &Vector3<f64>| self.point_jacobian(kinematics, link, point);
        let turns = |id: JointId| self.mechanism.joint(id).kind() != JointKind::Prismatic;
        let joint_row = |id: JointId| {
            let joint = self.mechanism.joint(id);
            let child = frame(joint.child());
            let axis = child.vector(joint.axis());
            let of_link = |link: LinkId| match turns(id) {
                true => self.angular_jacobian(kinematics, link),
                false => velocity(link, &frame(link).inverse_point(&child.translation)),
            };
            (of_link(joint.child()) - of_link(joint.parent())).tr_mul(&axis)
        };
        let row = match &element.motion {
            ElementMotion::Length([(a, at_a), (b, at_b)]) => {
                let line = (frame(*b).point(at_b) - frame(*a).point(at_a)).try_normalize(0.0)?;
                (velocity(*b, at_b) - velocity(*a, at_a)).tr_mul(&line)
            }
            ElementMotion::Along(link, point, direction) => velocity(*link, point).tr_mul(direction),
            ElementMotion::Twist(joint, None) | ElementMotion::Gear(joint) => joint_row(*joint),
            ElementMotion::Twist(joint, Some(other)) => joint_row(*joint) - joint_row(*other),
        };
        let is_gear = matches!(element.motion, ElementMotion::Gear(_));
        Some(ElasticRow {
            element: element.name.clone(),
            direction: if is_gear { ElasticDirection::Gear } else { ElasticDirection::Element },
            number: Some(number),
            stiffness: element.stiffness,
            static_stiffness: element.stiffness,
            damping: element.damping,
            loss_factor: 0.0,
            is_moment: matches!(element.motion, ElementMotion::Twist(joint, _) | ElementMotion::Gear(joint) if turns(joint)),
            is_rigid: is_gear,
            force: element.force,
            row,
        })
    }
}
