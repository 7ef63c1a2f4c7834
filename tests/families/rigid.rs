//! Linkages made rigid by one wrong axis: the report names the axis.

use percuss_dynamics::{Conditions, RigidLoops, System};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, Mechanism,
    MechanismBuilder,
};
use percuss_spatial::{Matrix3, Transform, Vector3};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::sync::Arc;

/// A four-bar or a slider-crank, drawn closed in a rotated plane. The axis of `wrong` (0–2: joints, 3: the loop's own
/// axis) is rotated by an angle in that plane's frame; `None`: all axes are right.
fn linkage(seed: u64, slides: bool, wrong: Option<(usize, f64)>) -> (Arc<Mechanism>, Vector3<f64>) {
    let mut random = StdRng::seed_from_u64(seed);
    let mut draw = |from: f64, to: f64| random.random_range(from..to);
    let plane = nalgebra::Rotation3::from_euler_angles(draw(-3.0, 3.0), draw(-1.5, 1.5), draw(-3.0, 3.0));
    let corners = [
        Vector3::new(draw(-0.2, 0.2), draw(-0.2, 0.2), 0.0),
        Vector3::new(draw(-0.3, 0.3), draw(0.5, 0.9), 0.0),
        Vector3::new(draw(0.8, 1.4), draw(0.6, 1.2), 0.0),
        Vector3::new(draw(0.9, 1.5), draw(-0.3, 0.3), 0.0),
    ];
    let about = draw(0.0, 6.0);
    let slide = Vector3::new(draw(0.6, 1.0), draw(-0.6, 0.6), 0.0);
    let axis = |which: usize, right: Vector3<f64>| {
        let tilt = Vector3::new(about.cos(), about.sin(), 0.0);
        let turn = wrong.filter(|(k, _)| *k == which).map_or(0.0, |(_, angle)| angle);
        // A slide's axis is rotated out of the plane.
        let along = if right.z == 0.0 { right.cross(&Vector3::z()).normalize() } else { tilt };
        plane * (nalgebra::Rotation3::new(along * turn) * right)
    };
    let at = |p: Vector3<f64>| plane * p;
    let body = |name: &str| LinkDescription::new(name, Inertial::point(1.0, [0.1, 0.1, 0.1]));
    let third = if slides { JointKind::Prismatic } else { JointKind::Continuous };
    let own = if slides { slide } else { Vector3::z() };
    let hinge = |name: &str, kind, parent: &str, child: &str, place: Vector3<f64>, along: Vector3<f64>| {
        JointDescription::new(name, kind, parent, child)
            .axis(<[f64; 3]>::from(along))
            .at(<[f64; 3]>::from(place))
    };
    let frame = |p: Vector3<f64>| Transform::new(Matrix3::identity(), p);
    let closing = ClosureDescription {
        predecessor_frame: frame(at(corners[2] - corners[1])),
        successor_frame: frame(at(corners[2] - corners[3])),
        axis: axis(3, Vector3::z()),
        ..ClosureDescription::new("closing", ClosureKind::Revolute, "coupler", "rocker")
    };
    let built = MechanismBuilder::new("linkage")
        .link(LinkDescription::massless("ground"))
        .link(body("crank"))
        .link(body("coupler"))
        .link(body("rocker"))
        .joint(hinge(
            "first",
            JointKind::Continuous,
            "ground",
            "crank",
            at(corners[0]),
            axis(0, Vector3::z()),
        ))
        .joint(hinge(
            "second",
            JointKind::Continuous,
            "crank",
            "coupler",
            at(corners[1] - corners[0]),
            axis(1, Vector3::z()),
        ))
        .joint(hinge("third", third, "ground", "rocker", at(corners[3]), axis(2, own)))
        .closure(closing)
        .build();
    (Arc::new(built.expect("a mechanism").mechanism), plane * Vector3::z())
}

fn rigid(mechanism: &Arc<Mechanism>) -> Vec<RigidLoops> {
    let system = System::new(Arc::clone(mechanism), &Conditions::new()).expect("a system");
    system.reference_or_open().rigid_loops()
}

#[test]
fn the_wrong_axis_is_named() {
    let mut named = 0;
    for seed in 0..40 {
        for slides in [false, true] {
            let (right, _) = linkage(seed, slides, None);
            assert_eq!(rigid(&right), [], "seed {seed}, slides {slides}");
            for wrong in 0..4 {
                for angle in [1e-3, 0.02, 0.3, -1.2] {
                    let (mechanism, normal) = linkage(seed, slides, Some((wrong, angle)));
                    let line = format!("seed {seed}, slides {slides}, axis {wrong} by {angle}");
                    let found = rigid(&mechanism);
                    let [RigidLoops { loops, joints, departing }] = &found[..] else {
                        panic!("{line}: {found:?}")
                    };
                    assert_eq!((&loops[..], joints.len()), (&["closing".to_owned()][..], 3), "{line}");
                    let [axis] = &departing[..] else { panic!("{line}: {departing:?}") };
                    let name = axis.joint.map(|id| mechanism.joint(id).name());
                    assert_eq!(name, [Some("first"), Some("second"), Some("third"), None][wrong], "{line}");
                    assert_eq!(axis.slides, slides && wrong == 2, "{line}");
                    assert!((axis.angle - f64::abs(angle)).abs() < 1e-6, "{line}: {axis:?}");
                    assert!(axis.direction.cross(&normal).norm() < 1e-6, "{line}: {axis:?}");
                    named += 1;
                }
            }
        }
    }
    assert_eq!(named, 1280);
}
