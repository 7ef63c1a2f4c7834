//! Double wishbone suspension, with hinged arms or two ball joints per arm.

use super::Linkage;
use crate::alter::build_with_loops;
use crate::parts::{ground, joint};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription,
};
use percuss_spatial::{Matrix3, Vector3};

use JointKind::{Continuous, Prismatic, Revolute, Spherical};

/// Control arm; positions in the chassis frame in the design position, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arm {
    /// Two points on the hinge axis.
    pub hinge: [[f64; 3]; 2],
    /// Ball joint to the upright.
    pub ball: [f64; 3],
    /// Inertia, with the centre of mass in the chassis frame.
    pub body: Inertial,
}

/// Corner of a vehicle; positions in the chassis frame (x to the front, y to the left, z up) in the design
/// position, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// The lower arm.
    pub lower: Arm,
    /// The upper arm.
    pub upper: Arm,
    /// The upright.
    pub upright: Inertial,
    /// Parts that rotate with the wheel.
    pub spindle: Inertial,
    /// Rotation axis of the wheel.
    pub spin_axis: [f64; 3],
    /// Tie rod, massless: points on the chassis and on the upright.
    pub tie_rod: [[f64; 3]; 2],
    /// Spring or damper: points on the chassis and on the lower arm. Contact points only, without mass and force.
    pub spring: [[f64; 3]; 2],
}

/// Inertia from moments (xx, yy, zz) and products (xy, xz, yz) of inertia about the centre of mass.
const fn body(mass: f64, com: [f64; 3], [xx, yy, zz]: [f64; 3], [xy, xz, yz]: [f64; 3]) -> Inertial {
    Inertial {
        mass,
        com: Vector3::new(com[0], com[1], com[2]),
        about_com: Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
    }
}

/// Typical front left corner.
pub const GENERIC_CORNER: Corner = Corner {
    lower: Arm {
        hinge: [[0.18, 0.36, 0.21], [-0.20, 0.38, 0.225]],
        ball: [0.01, 0.71, 0.18],
        body: body(3.9, [0.0, 0.53, 0.2], [0.045, 0.038, 0.078], [0.001, -0.002, 0.0015]),
    },
    upper: Arm {
        hinge: [[0.11, 0.42, 0.47], [-0.16, 0.44, 0.455]],
        ball: [-0.02, 0.67, 0.49],
        body: body(1.6, [-0.02, 0.55, 0.475], [0.009, 0.011, 0.018], [-0.0004, 0.0, 0.0003]),
    },
    upright: body(4.7, [-0.01, 0.69, 0.33], [0.041, 0.036, 0.017], [0.0, 0.001, -0.0012]),
    spindle: body(21.0, [0.0, 0.765, 0.335], [0.43, 0.71, 0.43], [0.0, 0.0, 0.0]),
    spin_axis: [0.012, 1.0, -0.021],
    tie_rod: [[-0.13, 0.40, 0.26], [-0.15, 0.70, 0.25]],
    spring: [[-0.02, 0.50, 0.60], [0.01, 0.56, 0.20]],
};

/// Point p relative to the point `to`.
fn relative(to: [f64; 3], p: [f64; 3]) -> [f64; 3] {
    (Vector3::from(p) - Vector3::from(to)).into()
}

/// Link with its frame at `origin`, parallel to the chassis frame.
fn link_at(name: &str, body: &Inertial, origin: [f64; 3]) -> LinkDescription {
    LinkDescription::new(name, Inertial { com: body.com - Vector3::from(origin), ..*body })
}

/// Links and joints below the ground, and the closures of upper ball joint and tie rod.
fn corner_parts(
    corner: &Corner,
    hinge: JointKind,
) -> (Vec<LinkDescription>, Vec<JointDescription>, Vec<ClosureDescription>) {
    let Corner { lower, upper, upright, spindle, spin_axis, tie_rod, .. } = corner;
    let wheel = spindle.com.into();
    let links = vec![
        ground(),
        link_at("lower_arm", &lower.body, lower.hinge[0]),
        link_at("upper_arm", &upper.body, upper.hinge[0]),
        link_at("upright", upright, lower.ball),
        link_at("spindle", spindle, wheel),
    ];
    let axis = |arm: &Arm| relative(arm.hinge[0], arm.hinge[1]);
    let joints = vec![
        joint("lower_hinge", hinge, "ground", "lower_arm").at(lower.hinge[0]).axis(axis(lower)),
        joint("upper_hinge", hinge, "ground", "upper_arm").at(upper.hinge[0]).axis(axis(upper)),
        joint("lower_ball", Spherical, "lower_arm", "upright").at(relative(lower.hinge[0], lower.ball)),
        joint("spin", Continuous, "upright", "spindle").at(relative(lower.ball, wheel)).axis(*spin_axis),
    ];
    let closures = vec![
        ClosureDescription::new("upper_ball", ClosureKind::Spherical, "upper_arm", "upright")
            .at(relative(upper.hinge[0], upper.ball), relative(lower.ball, upper.ball)),
        // The length is the distance in the design position.
        ClosureDescription::new("tie_rod", ClosureKind::Distance, "ground", "upright")
            .at(tie_rod[0], relative(lower.ball, tie_rod[1])),
    ];
    (links, joints, closures)
}

/// Corner with hinged arms, in the design position at zero: links `lower_arm` and `upper_arm` (origins at their
/// first hinge point), `upright` (at the lower ball joint), `spindle` (at its centre of mass). Mobility 2, no
/// redundancy. Drivers `lower_hinge`, ±0.25 rad, and `spin`.
pub fn double_wishbone_of(corner: &Corner) -> Linkage {
    let (links, joints, closures) = corner_parts(corner, Revolute);
    let mechanism = build_with_loops("double_wishbone", links, joints, closures, Vec::new());
    let drivers = [("lower_hinge", [-0.25, 0.25]), ("spin", [-1.0, 1.0])];
    Linkage::new(mechanism, "double_wishbone", drivers, [("spin", 0.3)])
}

/// [`GENERIC_CORNER`] with hinged arms; see [`double_wishbone_of`].
pub fn double_wishbone() -> Linkage {
    double_wishbone_of(&GENERIC_CORNER)
}

/// The same corner in the usual form of multibody programs: each arm has two ball joints to the chassis, one of
/// them in the tree, which gives one redundant row of six per arm. A massless strut replaces the spring as
/// driver: spherical joint at the chassis, prismatic joint, universal closure at the lower arm. Mobility 2, two
/// redundant rows, the same m̄ as [`double_wishbone`]. Drivers `strut`, −30 to 40 mm, and `spin`.
pub fn two_point_wishbone() -> Linkage {
    let corner = &GENERIC_CORNER;
    let (mut links, mut joints, mut closures) = corner_parts(corner, Spherical);
    for (name, arm) in [("lower", &corner.lower), ("upper", &corner.upper)] {
        closures.push(
            ClosureDescription::new(
                format!("{name}_back"),
                ClosureKind::Spherical,
                "ground",
                format!("{name}_arm"),
            )
            .at(arm.hinge[1], relative(arm.hinge[0], arm.hinge[1])),
        );
    }
    links.extend(["cylinder", "piston"].map(LinkDescription::massless));
    let [top, seat] = corner.spring;
    let along = Vector3::from(relative(top, seat));
    let pin = along.cross(&Vector3::y());
    joints.extend([
        joint("strut_top", Spherical, "ground", "cylinder").at(top),
        joint("strut", Prismatic, "cylinder", "piston").axis(along.into()),
    ]);
    closures.push(
        ClosureDescription::new("strut_eye", ClosureKind::Universal, "piston", "lower_arm")
            .at(along.into(), relative(corner.lower.hinge[0], seat))
            .axis(pin.into())
            .axis2(along.cross(&pin).into()),
    );
    let mechanism = build_with_loops("two_point_wishbone", links, joints, closures, Vec::new());
    let drivers = [("strut", [-0.03, 0.04]), ("spin", [-1.0, 1.0])];
    Linkage::new(mechanism, "two_point_wishbone", drivers, [("spin", 0.3)])
}
