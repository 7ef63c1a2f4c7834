//! Random mechanisms, positions and contacts. The caller provides the generator (`StdRng::seed_from_u64`).

use crate::alter::{CouplingForm, build, build_with_loops, describe, describe_loops};
use crate::closures::{admissible_relative_pose, complete_closure};
pub use crate::positions::{follow, zero_positions};
use nalgebra::{Rotation3, Vector3};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointId, JointKind, LinkDescription, LinkId,
    Mechanism, MimicDescription, RelationDescription,
};
use percuss_spatial::{Matrix3, Transform};
use rand::Rng;
use std::f64::consts::{PI, TAU};

/// Contact: contact link, link on the other side (`None` for the ground), point in the contact link's frame
/// (m), and unit normal in the root link's axes.
pub type Contact = (LinkId, Option<LinkId>, Vector3<f64>, Vector3<f64>);

/// Random tree of `bodies` links below a root with mass.
///
/// Half of the trees are chain-like, half bushy. All joint kinds occur (most often revolute; a chain of some
/// length has all of them), with general frames and axes. Masses span three decades, and every inertia is
/// physically possible (positive, triangle inequality). About a third of the joints have armature; some mimic
/// an earlier one.
pub fn mechanism<R: Rng + ?Sized>(rng: &mut R, bodies: usize) -> Mechanism {
    let bushy = rng.random_bool(0.5);
    let mut links = vec![body(rng, 0)];
    let mut joints: Vec<JointDescription> = Vec::new();
    for i in 1..=bodies {
        let parent = if bushy { rng.random_range(0..i) } else { rng.random_range(i.saturating_sub(2)..i) };
        links.push(body(rng, i));
        let mut joint = JointDescription::new(
            format!("joint_{i}"),
            kind(rng),
            format!("link_{parent}"),
            format!("link_{i}"),
        );
        joint.origin = frame(rng, 0.5);
        joint.axis = direction(rng);
        if rng.random_bool(0.35) {
            joint.armature = (0..joint.kind.dofs()).map(|_| log_uniform(rng, -3.0, 0.0)).collect();
        }
        if joint.kind.dofs() == 1 && rng.random_bool(0.2) {
            let masters: Vec<&JointDescription> = joints.iter().filter(|j| j.kind.dofs() == 1).collect();
            if !masters.is_empty() {
                let sign = if rng.random_bool(0.5) { 1.0 } else { -1.0 };
                joint.mimic = Some(MimicDescription {
                    joint: masters[rng.random_range(0..masters.len())].name.clone(),
                    multiplier: sign * rng.random_range(0.3..2.0),
                    offset: rng.random_range(-0.5..0.5),
                });
            }
        }
        joints.push(joint);
    }
    build("random", links, joints)
}

/// Random tree of `bodies` links with up to `closures` random closures of all kinds, and a closed position.
/// Closures connect any links or the world, with general frames. They have fewer rows than the tree has degrees
/// of freedom, but some loops may be rigid, or some rows redundant.
pub fn linkage<R: Rng + ?Sized>(rng: &mut R, bodies: usize, closures: usize) -> (Mechanism, Vec<Vec<f64>>) {
    let tree = mechanism(rng, bodies);
    let positions = positions(rng, &tree);
    let moves = tree.joints().iter().filter(|joint| joint.mimic().is_none());
    let mut freedoms: usize = moves.map(|joint| joint.kind().dofs()).sum();
    let mut made: Vec<ClosureDescription> = Vec::new();
    for i in 0..closures {
        let kind = ClosureKind::ALL[rng.random_range(0..ClosureKind::ALL.len())];
        let [before, after] = [0; 2].map(|_| rng.random_range(0..=bodies));
        if kind.rows() >= freedoms || before == after {
            continue;
        }
        freedoms -= kind.rows();
        let before = if rng.random_bool(0.15) { "world".into() } else { format!("link_{before}") };
        let axis = direction(rng);
        let turn = [0; 3].map(|_| rng.random_range(-1.5..1.5));
        let fit = admissible_relative_pose(kind, &axis, vector(rng, 0.4), turn);
        let closure = ClosureDescription {
            predecessor_frame: frame(rng, 0.4),
            axis,
            ..ClosureDescription::new(format!("closure_{i}"), kind, before, format!("link_{after}"))
        };
        made.push(complete_closure(&tree, &positions, closure, fit));
    }
    let (links, joints) = describe(&tree);
    (build_with_loops("random linkage", links, joints, made, Vec::new()), positions)
}

/// Random linkage of [`linkage`] with `relations` additional linear relations of joint positions, which hold at the returned positions. A
/// relation has two or three terms. From the third relation on, with probability 1/2, a relation is instead a linear combination of the two
/// previous relations, and redundant. A linkage with fewer than three joints of one degree of freedom has no relations.
pub fn coupled_linkage<R: Rng + ?Sized>(
    rng: &mut R,
    bodies: usize,
    closures: usize,
    relations: usize,
) -> (Mechanism, Vec<Vec<f64>>) {
    let (plain, positions) = linkage(rng, bodies, closures);
    let single: Vec<JointId> =
        plain.joint_ids().filter(|joint| plain.joint(*joint).kind().dofs() == 1).collect();
    if single.len() < 3 {
        return (plain, positions);
    }
    let mut made: Vec<Vec<(JointId, f64)>> = Vec::new();
    for i in 0..relations {
        let mut terms: Vec<(JointId, f64)> = Vec::new();
        if i >= 2 && rng.random_bool(0.5) {
            let weights = [0; 2].map(|_| rng.random_range(0.4..1.5));
            let of_relation = |(relation, weight): (&Vec<(JointId, f64)>, f64)| {
                relation.iter().map(|&(joint, factor)| (joint, weight * factor)).collect::<Vec<_>>()
            };
            terms.extend(made[i - 2..i].iter().zip(weights).flat_map(of_relation));
        } else {
            for _ in 0..rng.random_range(2..=3) {
                let sign = if rng.random_bool(0.5) { 1.0 } else { -1.0 };
                terms.push((single[rng.random_range(0..single.len())], sign * rng.random_range(0.3..2.0)));
            }
        }
        made.push(terms);
    }
    let relation = |(i, terms): (usize, Vec<(JointId, f64)>)| {
        let constant = terms.iter().map(|(joint, factor)| factor * positions[joint.index()][0]).sum();
        let named = |(joint, factor): (JointId, f64)| (plain.joint(joint).name().to_owned(), factor);
        let terms = terms.into_iter().map(named).collect();
        let name = format!("relation_{i}");
        CouplingForm::Relation(RelationDescription { name, terms, constant, curve: None })
    };
    let couplings = made.into_iter().enumerate().map(relation).collect();
    let ((links, joints), (closures, _)) = (describe(&plain), describe_loops(&plain));
    (build_with_loops("random coupled linkage", links, joints, closures, couplings), positions)
}

/// Random positions of all joints: angles within ±π, lengths within ±0.5 m, unit quaternions; mimics follow.
pub fn positions<R: Rng + ?Sized>(rng: &mut R, mechanism: &Mechanism) -> Vec<Vec<f64>> {
    let length = |rng: &mut R| rng.random_range(-0.5..0.5);
    let mut all: Vec<Vec<f64>> = Vec::with_capacity(mechanism.joints().len());
    for joint in mechanism.joints() {
        all.push(match joint.kind() {
            JointKind::Fixed => Vec::new(),
            JointKind::Revolute | JointKind::Continuous => vec![rng.random_range(-PI..PI)],
            JointKind::Prismatic => vec![length(rng)],
            JointKind::Planar => vec![length(rng), length(rng), rng.random_range(-PI..PI)],
            JointKind::Spherical => quaternion(rng).to_vec(),
            JointKind::Floating => {
                let mut q = vec![length(rng), length(rng), length(rng)];
                q.extend(quaternion(rng));
                q
            }
        });
    }
    follow(mechanism, &mut all);
    all
}

/// Random contact that a motion can close in general: no chain of fixed joints connects the two sides. Half of
/// the contacts are against the ground, half against another link.
///
/// In a rigid mechanism: any link against the ground.
pub fn contact<R: Rng + ?Sized>(rng: &mut R, mechanism: &Mechanism) -> Contact {
    let group = rigid_groups(mechanism);
    let movable =
        |held: usize| mechanism.link_ids().filter(|l| group[l.index()] != held).collect::<Vec<LinkId>>();
    let pick = |rng: &mut R, links: &[LinkId]| {
        if links.is_empty() { mechanism.root() } else { links[rng.random_range(0..links.len())] }
    };
    let on = pick(rng, &movable(group[mechanism.root().index()]));
    let others = movable(group[on.index()]);
    let against = (rng.random_bool(0.5) && !others.is_empty()).then(|| pick(rng, &others));
    (on, against, vector(rng, 0.5), direction(rng))
}

/// Index of the first link in the chain of fixed joints above each link.
fn rigid_groups(mechanism: &Mechanism) -> Vec<usize> {
    let mut group: Vec<usize> = (0..mechanism.links().len()).collect();
    for &link in mechanism.order() {
        let above: Option<JointId> = mechanism.parent_joint(link);
        if let Some(joint) = above.map(|id| mechanism.joint(id)).filter(|j| j.kind() == JointKind::Fixed) {
            group[link.index()] = group[joint.parent().index()];
        }
    }
    group
}

/// Random joint kind.
fn kind<R: Rng + ?Sized>(rng: &mut R) -> JointKind {
    match rng.random_range(0..16) {
        0..=5 => JointKind::Revolute,
        6 | 7 => JointKind::Continuous,
        8..=10 => JointKind::Prismatic,
        11 => JointKind::Planar,
        12 => JointKind::Spherical,
        13 => JointKind::Floating,
        _ => JointKind::Fixed,
    }
}

/// Body of 0.03 to 30 kg with principal moments from radii of gyration about three axes, which satisfy the
/// triangle inequality.
pub(crate) fn body<R: Rng + ?Sized>(rng: &mut R, index: usize) -> LinkDescription {
    let mass = log_uniform(rng, -1.5, 1.5);
    let [a, b, c] = [0; 3].map(|_| mass * rng.random_range(0.03f64..0.3).powi(2));
    let turn = Rotation3::new(direction(rng) * rng.random_range(0.0..PI)).into_inner();
    let moments = Matrix3::from_diagonal(&Vector3::new(b + c, a + c, a + b));
    let about_com = turn * moments * turn.transpose();
    let about_com = (about_com + about_com.transpose()) / 2.0;
    LinkDescription::new(format!("link_{index}"), Inertial { mass, com: vector(rng, 0.3), about_com })
}

/// 10 to the power of a uniform random number.
pub(crate) fn log_uniform<R: Rng + ?Sized>(rng: &mut R, from: f64, to: f64) -> f64 {
    10f64.powf(rng.random_range(from..to))
}

/// Random frame with an origin in a cube of half side `reach`, m.
pub(crate) fn frame<R: Rng + ?Sized>(rng: &mut R, reach: f64) -> Transform<f64> {
    let turn = Rotation3::new(direction(rng) * rng.random_range(0.0..PI)).into_inner();
    Transform::new(turn, vector(rng, reach))
}

/// Uniformly distributed in a cube.
pub(crate) fn vector<R: Rng + ?Sized>(rng: &mut R, reach: f64) -> Vector3<f64> {
    Vector3::from_fn(|_, _| rng.random_range(-reach..reach))
}

/// Uniformly distributed on the sphere (Archimedes).
pub(crate) fn direction<R: Rng + ?Sized>(rng: &mut R) -> Vector3<f64> {
    let z: f64 = rng.random_range(-1.0..1.0);
    let (sin, cos) = rng.random_range(0.0..TAU).sin_cos();
    let radius = (1.0 - z * z).sqrt();
    Vector3::new(radius * cos, radius * sin, z).normalize()
}

/// Random unit quaternion w,x,y,z.
fn quaternion<R: Rng + ?Sized>(rng: &mut R) -> [f64; 4] {
    let axis = direction(rng);
    let (sin, cos) = (rng.random_range(-PI..PI) / 2.0).sin_cos();
    [cos, sin * axis.x, sin * axis.y, sin * axis.z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{SeedableRng, rngs::StdRng};

    #[test]
    fn seeds_are_reproducible_and_give_all_kinds() {
        let make = || mechanism(&mut StdRng::seed_from_u64(7), 60);
        let (one, two) = (make(), make());
        assert_eq!(crate::alter::describe(&one), crate::alter::describe(&two));
        for kind in JointKind::ALL {
            assert!(one.joints().iter().any(|j| j.kind() == kind), "{kind:?} is missing");
        }
        assert!(one.joints().iter().any(|j| j.mimic().is_some()));
        assert!(one.joints().iter().any(|j| j.armature().iter().any(|a| *a > 0.0)));
    }

    #[test]
    fn mimics_follow_their_masters() {
        let mut rng = StdRng::seed_from_u64(11);
        let mechanism = mechanism(&mut rng, 40);
        let q = positions(&mut rng, &mechanism);
        let mut count = 0;
        for (joint, q_joint) in mechanism.joints().iter().zip(&q) {
            if let Some(mimic) = joint.mimic() {
                assert_eq!(q_joint[0], mimic.multiplier * q[mimic.master.index()][0] + mimic.offset);
                count += 1;
            }
        }
        assert!(count > 0, "no mimic in this seed");
    }

    #[test]
    fn contacts_are_between_links_that_move_apart() {
        let mut rng = StdRng::seed_from_u64(3);
        for _ in 0..50 {
            let mechanism = mechanism(&mut rng, 8);
            let group = rigid_groups(&mechanism);
            let (on, against, _, normal) = contact(&mut rng, &mechanism);
            let held = against.unwrap_or(mechanism.root());
            assert!((normal.norm() - 1.0).abs() < 1e-15);
            assert!(group[on.index()] != group[held.index()] || group.iter().all(|&g| g == group[0]));
        }
    }
}
