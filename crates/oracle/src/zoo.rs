//! One mechanism per tested property.

use crate::alter::build;
use crate::closed_form::PlanarLink;
use crate::parts::{frame, ground, joint, lump};
use percuss_mechanism::{Inertial, JointDescription, JointKind, LinkDescription, Mechanism};

use JointKind::{Continuous, Fixed, Floating, Planar, Prismatic, Revolute, Spherical};

/// All mechanisms of the zoo without loops, by name.
pub fn all() -> Vec<(&'static str, Mechanism)> {
    vec![
        ("every_joint", every_joint()),
        ("point_mass_pendulum", point_mass_pendulum(1.5, 0.8)),
        ("physical_pendulum", physical_pendulum(2.3, 0.35, 0.04)),
        ("two_free_bodies", two_free_bodies()),
        ("double_pendulum", double_pendulum()),
        ("planar_2r", planar_2r([PlanarLink::rod(1.4, 0.6), PlanarLink::rod(0.9, 0.5)], [0.05, 0.02])),
        ("needle_on_heavy_base", needle_on_heavy_base()),
        ("mimic_gripper", mimic_gripper()),
        ("massless_chain", massless_chain()),
        ("ball_joint", ball_joint()),
        ("massless_tip", massless_tip()),
        ("six_r_arm", six_r_arm()),
        ("fixed_frames", fixed_frames()),
        ("prismatic_stage", prismatic_stage()),
        ("single_body", single_body()),
    ]
}

/// All [`Linkage`](crate::linkage::Linkage) mechanisms with closed loops and couplings, by name.
pub fn linkages() -> Vec<(&'static str, Mechanism)> {
    crate::linkage::all().into_iter().map(|linkage| (linkage.name, linkage.mechanism)).collect()
}

/// Branched tree with a joint of every kind, general frames, axes and inertias, armature on every kind that
/// allows it, and a mimic. The root has mass, so that it can float.
pub fn every_joint() -> Mechanism {
    let links = vec![
        lump("base", 6.0, [0.05, -0.1, 0.2], 0.9),
        lump("turret", 3.2, [0.1, 0.05, 0.15], 0.6),
        lump("wheel", 0.7, [0.0, 0.02, 0.01], 0.3),
        lump("slider", 1.1, [-0.1, 0.2, 0.05], 0.4),
        lump("bracket", 0.4, [0.03, 0.04, -0.05], 0.2),
        lump("puck", 0.9, [0.02, -0.06, 0.03], 0.25),
        lump("ball", 1.6, [0.0, 0.1, -0.2], 0.5),
        lump("flyer", 2.1, [0.15, -0.05, 0.1], 0.4),
        lump("finger", 0.3, [0.05, 0.0, 0.08], 0.2),
        lump("follower", 0.25, [-0.02, 0.06, 0.04], 0.2),
    ];
    let values =
        |joint: JointDescription, armature: &[f64]| JointDescription { armature: armature.to_vec(), ..joint };
    let joints = vec![
        joint("yaw", Revolute, "base", "turret")
            .origin(frame([0.2, -0.1, 0.7], [0.1, 0.2, 0.4]))
            .axis([0.1, -0.3, 1.0])
            .armature(0.08),
        joint("spin", Continuous, "turret", "wheel")
            .origin(frame([1.2, 0.3, -0.4], [0.3, -0.25, 0.1]))
            .axis([0.0, 1.0, 0.2])
            .armature(0.003),
        joint("slide", Prismatic, "turret", "slider")
            .origin(frame([-0.5, 0.8, 0.1], [-0.1, 0.3, 0.35]))
            .axis([1.0, 0.5, -0.2])
            .armature(0.6),
        joint("weld", Fixed, "slider", "bracket").origin(frame([0.3, 0.3, -1.0], [0.2, 0.0, -0.1])),
        values(
            joint("glide", Planar, "bracket", "puck")
                .origin(frame([0.1, 0.6, 0.4], [0.05, 0.1, 0.12]))
                .axis([0.3, 0.2, 0.9]),
            &[0.2, 0.3, 0.004],
        ),
        values(
            joint("socket", Spherical, "turret", "ball").origin(frame([0.9, -0.7, 0.2], [0.15, 0.1, 0.5])),
            &[0.01, 0.02, 0.015],
        ),
        values(
            joint("free", Floating, "ball", "flyer").origin(frame([-0.3, 0.5, 1.1], [0.2, 0.4, -0.3])),
            &[0.01, 0.0, 0.02, 0.3, 0.0, 0.1],
        ),
        joint("knuckle", Revolute, "bracket", "finger")
            .origin(frame([0.0, 1.0, -0.6], [0.1, -0.05, 0.2]))
            .axis([-0.4, 0.9, 0.1]),
        joint("follow", Prismatic, "finger", "follower")
            .origin(frame([0.7, 0.0, 0.3], [0.02, 0.15, 0.0]))
            .axis([0.2, -0.1, 1.0])
            .mimic("knuckle", -0.35, 0.04)
            .armature(0.05),
    ];
    build("every_joint", links, joints)
}

/// Point mass (kg) at `r_a` (m) along x on a massless rod, hinged about z at the origin.
pub fn point_mass_pendulum(mass: f64, r_a: f64) -> Mechanism {
    let links = vec![
        ground(),
        LinkDescription::massless("rod"),
        LinkDescription::new("bob", Inertial::point(mass, [0.0; 3])),
    ];
    let joints = vec![
        joint("hinge", Revolute, "ground", "rod").axis([0.0, 0.0, 1.0]),
        joint("weld", Fixed, "rod", "bob").at([r_a, 0.0, 0.0]),
    ];
    build("point_mass_pendulum", links, joints)
}

/// Body on a hinge about z: centre of mass at `h` (m) along x, moment of inertia about z `inertia` (kg·m²).
pub fn physical_pendulum(mass: f64, h: f64, inertia: f64) -> Mechanism {
    let body = Inertial::diagonal(mass, [h, 0.0, 0.0], [0.3 * inertia, 0.8 * inertia, inertia]);
    let joints = vec![joint("hinge", Revolute, "ground", "body").axis([0.0, 0.0, 1.0])];
    build("physical_pendulum", vec![ground(), LinkDescription::new("body", body)], joints)
}

/// Two free bodies (`first` 1.2 kg, `second` 3.4 kg) without symmetry, on floating joints from the ground.
pub fn two_free_bodies() -> Mechanism {
    let links = vec![
        ground(),
        lump("first", 1.2, [0.1, -0.2, 0.05], 0.7),
        lump("second", 3.4, [-0.15, 0.1, 0.2], 1.1),
    ];
    let joints = vec![
        joint("free_first", Floating, "ground", "first"),
        joint("free_second", Floating, "ground", "second").origin(frame([0.4, 0.2, -1.3], [2.0, 0.5, 0.1])),
    ];
    build("two_free_bodies", links, joints)
}

/// Double pendulum of uniform rods 1.4 kg × 0.6 m and 0.9 kg × 0.5 m, without armature.
pub fn double_pendulum() -> Mechanism {
    planar_2r([PlanarLink::rod(1.4, 0.6), PlanarLink::rod(0.9, 0.5)], [0.0; 2])
}

/// Two links `upper`, `lower` along their x-axes, hinges `shoulder`, `elbow` about z; `armature` at the hinges.
///
/// Positions: angle of the first link, and angle of the second relative to the first.
pub fn planar_2r(links: [PlanarLink; 2], armature: [f64; 2]) -> Mechanism {
    let body = |name: &str, link: PlanarLink| {
        let moments = [0.0, link.inertia, link.inertia];
        LinkDescription::new(name, Inertial::diagonal(link.mass, [link.com, 0.0, 0.0], moments))
    };
    let joints = vec![
        joint("shoulder", Revolute, "ground", "upper").axis([0.0, 0.0, 1.0]).armature(armature[0]),
        joint("elbow", Revolute, "upper", "lower")
            .at([links[0].length, 0.0, 0.0])
            .axis([0.0, 0.0, 1.0])
            .armature(armature[1]),
    ];
    build("planar_2r", vec![ground(), body("upper", links[0]), body("lower", links[1])], joints)
}

/// Base of 10 t on a slider along y with a hinged needle (about z) of 1 mg and 40 mm along x.
pub fn needle_on_heavy_base() -> Mechanism {
    let moment = 1e-6 * 0.04 * 0.04 / 12.0;
    let links = vec![
        ground(),
        LinkDescription::new("base", Inertial::diagonal(1e4, [0.0; 3], [4e3, 5e3, 6e3])),
        LinkDescription::new("needle", Inertial::diagonal(1e-6, [0.02, 0.0, 0.0], [0.0, moment, moment])),
    ];
    let joints = vec![
        joint("slide", Prismatic, "ground", "base").axis([0.0, 1.0, 0.0]),
        joint("pin", Revolute, "base", "needle").at([0.3, 0.1, 0.2]).axis([0.0, 0.0, 1.0]),
    ];
    build("needle_on_heavy_base", links, joints)
}

/// Gripper on a lift, driven by `left`: `right` rotates in the opposite direction, `left_tip` mimics `right`
/// with −0.5 (a chain of mimics), and `plunger` slides with `left_tip`.
pub fn mimic_gripper() -> Mechanism {
    let links = vec![
        ground(),
        lump("palm", 1.5, [0.0, 0.02, 0.05], 0.2),
        lump("left_finger", 0.2, [0.04, 0.0, 0.03], 0.1),
        lump("right_finger", 0.22, [0.04, 0.01, -0.03], 0.1),
        lump("left_pad", 0.05, [0.02, 0.0, 0.0], 0.03),
        lump("plunger_rod", 0.3, [0.0, 0.0, 0.06], 0.1),
    ];
    let y = [0.0, 1.0, 0.0];
    let joints = vec![
        joint("lift", Prismatic, "ground", "palm").axis([0.0, 0.0, 1.0]).armature(0.4),
        joint("left", Revolute, "palm", "left_finger").at([0.05, 0.0, 0.04]).axis(y).armature(0.002),
        joint("right", Revolute, "palm", "right_finger")
            .at([0.05, 0.0, -0.04])
            .axis(y)
            .mimic("left", -1.0, 0.0)
            .armature(0.001),
        joint("left_tip", Revolute, "left_finger", "left_pad")
            .at([0.08, 0.0, 0.02])
            .axis(y)
            .mimic("right", 0.5, 0.1),
        joint("plunger", Prismatic, "palm", "plunger_rod")
            .at([0.0, 0.03, 0.0])
            .axis([0.2, 0.0, 1.0])
            .mimic("left_tip", 0.06, -0.01)
            .armature(0.1),
    ];
    build("mimic_gripper", links, joints)
}

const BALL: [f64; 3] = [0.1, -0.2, 0.3];

/// Spherical joint made of three hinges about x, y and z with massless links between, and a `body`.
pub fn massless_chain() -> Mechanism {
    let links = vec![
        ground(),
        LinkDescription::massless("fork"),
        LinkDescription::massless("cross"),
        lump("body", 2.4, [0.1, 0.3, -0.2], 0.5),
    ];
    let joints = vec![
        joint("about_x", Revolute, "ground", "fork").at(BALL).axis([1.0, 0.0, 0.0]),
        joint("about_y", Revolute, "fork", "cross").axis([0.0, 1.0, 0.0]),
        joint("about_z", Revolute, "cross", "body").axis([0.0, 0.0, 1.0]),
    ];
    build("massless_chain", links, joints)
}

/// The `body` of [`massless_chain`] on one spherical joint.
pub fn ball_joint() -> Mechanism {
    let joints = vec![joint("ball", Spherical, "ground", "body").at(BALL)];
    build("ball_joint", vec![ground(), lump("body", 2.4, [0.1, 0.3, -0.2], 0.5)], joints)
}

/// Heavy arm with a massless feeler hinged to its end: a contact normal to the feeler has no effective mass.
pub fn massless_tip() -> Mechanism {
    let z = [0.0, 0.0, 1.0];
    let links = vec![ground(), lump("arm", 5.0, [0.3, 0.0, 0.0], 0.6), LinkDescription::massless("feeler")];
    let joints = vec![
        joint("shoulder", Revolute, "ground", "arm").axis(z),
        joint("feeler_hinge", Revolute, "arm", "feeler").at([0.6, 0.0, 0.0]).axis(z),
    ];
    build("massless_tip", links, joints)
}

/// Industrial arm of six hinges with reflected rotor inertias of geared motors.
pub fn six_r_arm() -> Mechanism {
    let links = vec![
        LinkDescription::new("pedestal", Inertial::diagonal(60.0, [0.0, 0.0, 0.2], [2.0, 2.0, 1.5])),
        lump("column", 35.0, [0.1, 0.02, 0.2], 0.6),
        lump("upper_arm", 22.0, [0.02, 0.05, 0.35], 0.8),
        lump("elbow_housing", 14.0, [0.1, -0.03, 0.06], 0.4),
        lump("forearm", 9.0, [0.25, 0.0, 0.01], 0.6),
        lump("wrist", 3.5, [0.03, 0.01, 0.0], 0.2),
        lump("flange", 0.8, [0.02, 0.0, 0.01], 0.1),
    ];
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let joints = vec![
        joint("a1", Revolute, "pedestal", "column").at([0.0, 0.0, 0.4]).axis(z).armature(12.0),
        joint("a2", Revolute, "column", "upper_arm").at([0.18, 0.0, 0.3]).axis(y).armature(15.0),
        joint("a3", Revolute, "upper_arm", "elbow_housing").at([0.0, 0.0, 0.7]).axis(y).armature(6.0),
        joint("a4", Revolute, "elbow_housing", "forearm").at([0.15, 0.0, 0.12]).axis(x).armature(1.1),
        joint("a5", Revolute, "forearm", "wrist").at([0.6, 0.0, 0.0]).axis(y).armature(0.7),
        joint("a6", Revolute, "wrist", "flange").at([0.12, 0.0, 0.0]).axis(x).armature(0.3),
    ];
    build("six_r_arm", links, joints)
}

/// Masses connected by fixed joints, in chains and branches, below two hinges, with massless frames between.
pub fn fixed_frames() -> Mechanism {
    let links = vec![
        ground(),
        LinkDescription::massless("mount"),
        lump("motor", 1.8, [0.0, 0.05, 0.1], 0.2),
        LinkDescription::massless("output"),
        lump("beam", 2.5, [0.4, 0.0, 0.0], 0.9),
        LinkDescription::massless("beam_end"),
        lump("sensor", 0.15, [0.01, 0.02, 0.0], 0.05),
        lump("ballast", 4.0, [0.0, -0.1, 0.0], 0.3),
        lump("second_beam", 1.2, [0.3, 0.1, 0.0], 0.7),
        LinkDescription::massless("tool_frame"),
    ];
    let joints = vec![
        joint("mounting", Fixed, "ground", "mount").origin(frame([0.5, -0.2, 0.3], [0.0, 0.1, 0.6])),
        joint("motor_bolts", Fixed, "mount", "motor").at([0.0, -0.1, 0.0]),
        joint("drive", Revolute, "motor", "output").at([0.0, 0.1, 0.1]).axis([0.1, 1.0, 0.0]).armature(0.02),
        joint("coupling", Fixed, "output", "beam").origin(frame([0.0, 0.6, 0.0], [0.02, 0.03, 0.0])),
        joint("end", Fixed, "beam", "beam_end").at([0.9, 0.0, 0.0]),
        joint("glue", Fixed, "beam_end", "sensor").origin(frame([1.5, 0.0, 0.2], [0.0, 0.0, 0.04])),
        joint("bolts", Fixed, "beam", "ballast").origin(frame([0.0, 0.0, -0.4], [-0.3, 0.0, 0.1])),
        joint("second_drive", Continuous, "beam_end", "second_beam")
            .origin(frame([0.2, 0.1, 0.9], [0.05, 0.0, 0.0]))
            .axis([0.0, 0.2, 1.0]),
        joint("tool", Fixed, "second_beam", "tool_frame").origin(frame([0.0, 0.3, 0.0], [0.7, 0.0, 0.1])),
    ];
    build("fixed_frames", links, joints)
}

/// Three prismatic joints in series at general angles, with a hinged tool at the end.
pub fn prismatic_stage() -> Mechanism {
    let links = vec![
        ground(),
        lump("saddle", 40.0, [0.0, 0.1, 0.1], 0.8),
        lump("table", 25.0, [0.1, 0.0, 0.2], 0.7),
        lump("quill", 8.0, [0.0, 0.0, -0.2], 0.4),
        lump("tool", 0.9, [0.03, 0.0, -0.1], 0.2),
    ];
    let joints = vec![
        joint("x_slide", Prismatic, "ground", "saddle").axis([1.0, 0.0, 0.0]).armature(30.0),
        joint("y_slide", Prismatic, "saddle", "table")
            .origin(frame([0.0, 0.0, 0.05], [0.0, 0.0, 0.3]))
            .axis([0.1, 1.0, 0.0])
            .armature(12.0),
        joint("z_slide", Prismatic, "table", "quill")
            .origin(frame([0.1, -0.05, 0.0], [0.0, 0.2, 0.6]))
            .axis([0.0, 0.3, 1.0]),
        joint("swivel", Revolute, "quill", "tool").at([0.0, 0.0, -0.4]).axis([1.0, 0.2, 0.0]).armature(0.01),
    ];
    build("prismatic_stage", links, joints)
}

/// One body without joints: immovable on the ground, or free with a floating base.
pub fn single_body() -> Mechanism {
    build("single_body", vec![lump("body", 1.7, [0.2, -0.1, 0.4], 0.6)], Vec::new())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_joint_kind_is_in_it() {
        let mechanism = every_joint();
        for kind in JointKind::ALL {
            assert!(mechanism.joints().iter().any(|j| j.kind() == kind), "{kind:?} is missing");
        }
        assert!(mechanism.link_ids().any(|link| mechanism.child_joints(link).len() > 1), "nothing branches");
        assert!(mechanism.joints().iter().any(|j| j.mimic().is_some()), "nothing mimics");
    }

    #[test]
    fn names_are_those_of_the_mechanisms_and_unique() {
        let all = all();
        for (i, (name, _)) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|(other, _)| other != name), "{name} comes twice");
        }
    }

    #[test]
    fn chained_mimics_multiply() {
        let mechanism = mimic_gripper();
        let ratio = |name| mechanism.joint(mechanism.find_joint(name).unwrap()).mimic().unwrap().multiplier;
        assert_eq!(ratio("left_tip"), -0.5);
        assert_eq!(ratio("plunger"), -0.03);
    }
}
