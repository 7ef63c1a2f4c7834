//! Parallel cranks of any length and spacing with their effective mass; linkages with contradicting constraints.

use super::family::{Kind, drawn_as};
use super::planar::{link, pin};
use super::plane;
use crate::alter::{build_with_loops, displaced, scaled};
use crate::closed_form::PlanarBody;
use crate::parts::{ground, joint};
use nalgebra::{Matrix3, Vector2, Vector3};
use percuss_mechanism::{JointKind::Continuous, Mechanism};
use percuss_spatial::Transform;

/// Row of equal, parallel cranks under a platform: one degree of freedom for any length and spacing.
///
/// Links `crank_1` …, `platform`; joints `hinge_1` …, `pin_1`; closures `pin_2` …. All joints are at 0 where
/// the angle between cranks and row is `angle`.
#[derive(Clone, Copy, Debug)]
pub struct CrankRow {
    /// Number of cranks.
    pub count: usize,
    /// Length of each crank, m.
    pub length: f64,
    /// Distance between neighbours, m.
    pub spacing: f64,
    /// Angle between cranks and row, rad.
    pub angle: f64,
    /// True to use the [`plane`] of the other linkages, false for the x-y plane.
    pub turned: bool,
    /// Distance of the first hinge from the ground's origin along each axis, m.
    pub distance_from_origin: f64,
    /// Mass of each crank, uniformly distributed, kg.
    pub crank_mass: f64,
    /// Mass of the platform, kg.
    pub platform_mass: f64,
}

impl CrankRow {
    /// The mechanism.
    pub fn mechanism(&self) -> Mechanism {
        const Z: [f64; 3] = [0.0, 0.0, 1.0];
        let rotation = if self.turned { plane().rotation } else { Matrix3::identity() };
        let frame = Transform::new(rotation, Vector3::from_element(self.distance_from_origin));
        let arm = self.arm();
        let crank = PlanarBody {
            mass: self.crank_mass,
            com: arm / 2.0,
            inertia: self.crank_mass * self.length * self.length / 12.0,
        };
        let reach = self.spacing * (self.count - 1) as f64;
        let platform = PlanarBody {
            mass: self.platform_mass,
            com: Vector2::new(reach / 2.0, 0.0),
            inertia: self.platform_mass * reach * reach / 12.0,
        };
        let mut links = vec![ground()];
        let (mut joints, mut closures) = (Vec::new(), Vec::new());
        for i in 0..self.count {
            let name = format!("crank_{}", i + 1);
            let foot = self.spacing * i as f64;
            links.push(link(&name, &crank));
            joints.push(
                joint(&format!("hinge_{}", i + 1), Continuous, "ground", &name)
                    .origin(frame * Transform::from_translation(Vector3::new(foot, 0.0, 0.0)))
                    .axis(Z),
            );
            if i == 0 {
                joints
                    .push(joint("pin_1", Continuous, "crank_1", "platform").at([arm.x, arm.y, 0.0]).axis(Z));
            } else {
                let ends = (("platform", [foot, 0.0]), (name.as_str(), [arm.x, arm.y]));
                closures.push(pin(&format!("pin_{}", i + 1), ends.0, ends.1));
            }
        }
        links.push(link("platform", &platform));
        build_with_loops("crank_row", links, joints, closures, Vec::new())
    }

    /// Vector along a crank in the plane, m.
    fn arm(&self) -> Vector2<f64> {
        Vector2::new(self.angle.cos(), self.angle.sin()) * self.length
    }

    /// m̄ of the platform for a contact along its direction of motion, kg: each crank contributes m/3.
    pub fn along_the_motion(&self) -> f64 {
        self.platform_mass + self.count as f64 * self.crank_mass / 3.0
    }

    /// Direction of motion of the platform, in the platform's axes.
    pub fn motion(&self) -> Vector3<f64> {
        Vector3::new(-self.angle.sin(), self.angle.cos(), 0.0)
    }
}

/// Linkage of the [`family`](super::family) whose redundant rows contradict each other by `fraction` of its
/// `size` (m, the largest distance between pins). The last closure is displaced along its axis by half of this
/// distance and tilted by half of `fraction` in radians; for parallel cranks the closure is also displaced in
/// the plane.
pub fn contradicting(seed: u64, kind: Kind, size: f64, fraction: f64) -> Mechanism {
    let drawn = drawn_as(seed, kind);
    let mechanism = scaled(&drawn.mechanism, size / drawn.size, 1.0);
    if fraction == 0.0 {
        return mechanism;
    }
    let last = mechanism.closures().len() - 1;
    let axis = *mechanism.closures()[last].axis();
    let side = axis.cross(&Vector3::ith(axis.iamin(), 1.0)).normalize();
    let mut shift = axis * (fraction * size / 2.0);
    if kind.is_overconstrained() {
        shift += side * (fraction * size / 2.0);
    }
    displaced(&mechanism, last, shift, side * (fraction / 2.0))
}
