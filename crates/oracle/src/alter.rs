//! Modified copies of a mechanism: as descriptions, in other units, on another ground, or rounded.

use percuss_mechanism::{
    Accept, ClosureDescription, CouplingDescription, CurveDescription, Geometry, Joint, JointDescription,
    JointId, JointKind, Limits, Link, LinkDescription, LinkId, LinkRatio, LoopFrame, Mechanism,
    MechanismBuilder, Mimic, MimicDescription, RelationDescription,
};
use percuss_spatial::{Transform, Vector3, rotation_from_rpy, rpy_from_rotation};

/// Descriptions of the links and joints of a mechanism, in the same order.
pub fn describe(mechanism: &Mechanism) -> (Vec<LinkDescription>, Vec<JointDescription>) {
    let links = mechanism.links().iter().map(describe_link).collect();
    let joints = mechanism.joints().iter().map(|joint| describe_joint(mechanism, joint)).collect();
    (links, joints)
}

/// Description of a link.
fn describe_link(link: &Link) -> LinkDescription {
    LinkDescription {
        name: link.name().to_owned(),
        inertial: link.inertial().copied(),
        geometry: link.geometry(),
    }
}

/// Description of a joint with its limits, armature and mimic.
fn describe_joint(mechanism: &Mechanism, joint: &Joint) -> JointDescription {
    JointDescription {
        name: joint.name().to_owned(),
        kind: joint.kind(),
        parent: mechanism.link(joint.parent()).name().to_owned(),
        child: mechanism.link(joint.child()).name().to_owned(),
        origin: *joint.origin(),
        axis: *joint.axis(),
        limits: joint.limits(),
        rate_limit: joint.rate_limit(),
        armature: joint.armature().to_vec(),
        mimic: joint.mimic().map(|mimic| MimicDescription {
            joint: mechanism.joint(mimic.master).name().to_owned(),
            multiplier: mimic.multiplier,
            offset: mimic.offset,
        }),
        independent: joint.independent(),
        spring: joint.spring(),
        gear: joint.gear(),
    }
}

/// Description of a coupling.
#[derive(Clone, Debug, PartialEq)]
pub enum CouplingForm {
    /// Ratio of links.
    Ratio(CouplingDescription),
    /// Relation of joint positions.
    Relation(RelationDescription),
}

/// Descriptions of the closures and couplings of a mechanism, in the same order.
pub fn describe_loops(mechanism: &Mechanism) -> (Vec<ClosureDescription>, Vec<CouplingForm>) {
    let name = |frame: &LoopFrame| frame.link.map_or("world", |link| mechanism.link(link).name()).to_owned();
    let closures = mechanism.closures().iter().map(|closure| ClosureDescription {
        name: closure.name().to_owned(),
        kind: closure.kind(),
        predecessor: name(closure.predecessor()),
        predecessor_frame: closure.predecessor().frame,
        successor: name(closure.successor()),
        successor_frame: closure.successor().frame,
        axis: *closure.axis(),
        axis2: *closure.axis2(),
        distance: closure.distance(),
    });
    let mut couplings = Vec::new();
    for coupling in mechanism.couplings() {
        let name = coupling.name().to_owned();
        let Some(LinkRatio { predecessor, successor, ratio }) = coupling.ratio() else {
            couplings.push(CouplingForm::Relation(mechanism.describe_relation(coupling)));
            continue;
        };
        let [predecessor, successor] =
            [predecessor, successor].map(|id| mechanism.link(id).name().to_owned());
        couplings.push(CouplingForm::Ratio(CouplingDescription { name, predecessor, successor, ratio }));
    }
    (closures.collect(), couplings)
}

/// Builds a mechanism without loops; inertias are accepted without check.
///
/// # Panics
/// If the builder refuses the descriptions.
pub fn build(name: &str, links: Vec<LinkDescription>, joints: Vec<JointDescription>) -> Mechanism {
    build_with_loops(name, links, joints, Vec::new(), Vec::new())
}

/// Builds a mechanism; inertias are accepted without check.
///
/// # Panics
/// If the builder refuses the descriptions.
pub fn build_with_loops(
    name: &str,
    links: Vec<LinkDescription>,
    joints: Vec<JointDescription>,
    closures: Vec<ClosureDescription>,
    couplings: Vec<CouplingForm>,
) -> Mechanism {
    let builder =
        MechanismBuilder::new(name).accept(Accept { indefinite_inertia: true, ..Accept::default() });
    let builder = links.into_iter().fold(builder, MechanismBuilder::link);
    let builder = joints.into_iter().fold(builder, MechanismBuilder::joint);
    let builder = closures.into_iter().fold(builder, MechanismBuilder::closure);
    let builder = couplings.into_iter().fold(builder, |builder, coupling| match coupling {
        CouplingForm::Ratio(ratio) => builder.coupling(ratio),
        CouplingForm::Relation(relation) => builder.relation(relation),
    });
    match builder.build() {
        Ok(built) => built.mechanism,
        Err(error) => panic!("{name}: {error}"),
    }
}

/// Converts the mechanism to other units: lengths times `length`, masses times `mass`. The effective mass is
/// then multiplied by `mass`.
///
/// Inertias and armatures of rotational velocities scale with length²·mass, those of translational velocities
/// with mass. The ratio of a mimic or coupling between a translational and a rotational joint has the unit 1/m
/// or m and scales too.
///
/// # Panics
/// If one side of a coupling is a sum of translational and rotational joints: no ratio scales such a sum.
pub fn scaled(mechanism: &Mechanism, length: f64, mass: f64) -> Mechanism {
    let (mut links, mut joints) = describe(mechanism);
    for link in &mut links {
        if let Some(inertial) = &mut link.inertial {
            inertial.mass *= mass;
            inertial.com *= length;
            inertial.about_com *= mass * length * length;
        }
        if let Geometry::Within(radius) = &mut link.geometry {
            *radius *= length;
        }
    }
    for (joint, own) in joints.iter_mut().zip(mechanism.joints()) {
        joint.origin.translation *= length;
        let (turning, sliding) = (mass * length * length, mass);
        let factors: Vec<f64> = match joint.kind {
            JointKind::Fixed => Vec::new(),
            JointKind::Revolute | JointKind::Continuous => vec![turning],
            JointKind::Prismatic => vec![sliding],
            JointKind::Planar => vec![sliding, sliding, turning],
            JointKind::Spherical => vec![turning; 3],
            JointKind::Floating => [[turning; 3], [sliding; 3]].concat(),
        };
        joint.armature.iter_mut().zip(factors).for_each(|(value, factor)| *value *= factor);
        let scale = |kind| position_scale(kind, length);
        if let Some(Limits { lower, upper }) = &mut joint.limits {
            *lower *= scale(joint.kind);
            *upper *= scale(joint.kind);
        }
        if let (Some(mimic), Some(Mimic { master, .. })) = (&mut joint.mimic, own.mimic()) {
            mimic.multiplier *= scale(joint.kind) / scale(mechanism.joint(master).kind());
            mimic.offset *= scale(joint.kind);
        }
    }
    let (mut closures, mut couplings) = describe_loops(mechanism);
    for closure in &mut closures {
        closure.predecessor_frame.translation *= length;
        closure.successor_frame.translation *= length;
        closure.distance = closure.distance.map(|distance| distance * length);
    }
    let scale_of = |id: JointId| position_scale(mechanism.joint(id).kind(), length);
    for (coupling, own) in couplings.iter_mut().zip(mechanism.couplings()) {
        match (coupling, own.ratio()) {
            (CouplingForm::Ratio(coupling), Some(links)) => {
                let below = |id: JointId| is_below(mechanism, links.successor, id);
                let (on, against): (Vec<_>, Vec<_>) =
                    own.terms().iter().map(|term| term.0).partition(|&id| below(id));
                let side = |joints: &[JointId]| {
                    let units = joints.iter().map(|&id| scale_of(id));
                    let first = units.clone().next();
                    let is_sum = units.clone().all(|u| Some(u) == first);
                    assert!(is_sum, "coupling {}: a sum of rad and m", own.name());
                    first
                };
                if let (Some(on), Some(against)) = (side(&on), side(&against)) {
                    coupling.ratio *= on / against;
                }
            }
            (CouplingForm::Relation(relation), _) => {
                // The factors change with the units of the positions; the terms, the constant and the curve stay.
                let of_name = |name: &str| mechanism.find_joint(name).map_or(1.0, scale_of);
                let curve = relation.curve.iter_mut().flat_map(|curve| &mut curve.terms);
                relation.terms.iter_mut().chain(curve).for_each(|(name, factor)| *factor /= of_name(name));
            }
            (CouplingForm::Ratio(_), None) => {}
        }
    }
    build_with_loops(mechanism.name(), links, joints, closures, couplings)
}

/// Scale factor of the joint position for a scale factor of length.
fn position_scale(kind: JointKind, length: f64) -> f64 {
    if kind == JointKind::Prismatic { length } else { 1.0 }
}

/// True if the link is a descendant of the joint.
fn is_below(mechanism: &Mechanism, link: LinkId, joint: JointId) -> bool {
    let above = |link: &LinkId| mechanism.parent_joint(*link).map(|id| mechanism.joint(id).parent());
    std::iter::successors(Some(link), above).any(|link| mechanism.parent_joint(link) == Some(joint))
}

/// Positions of a mechanism [`scaled`] by `length`.
pub fn scaled_positions(mechanism: &Mechanism, positions: &[Vec<f64>], length: f64) -> Vec<Vec<f64>> {
    let lengths = |kind: JointKind| match kind {
        JointKind::Fixed | JointKind::Revolute | JointKind::Continuous | JointKind::Spherical => 0,
        JointKind::Prismatic => 1,
        JointKind::Planar => 2,
        JointKind::Floating => 3,
    };
    let mut scaled = positions.to_vec();
    for (q, joint) in scaled.iter_mut().zip(mechanism.joints()) {
        q.iter_mut().take(lengths(joint.kind())).for_each(|value| *value *= length);
    }
    scaled
}

/// Adds a new massless ground link; a fixed joint with the origin `x_gr` connects the old root to the ground.
///
/// The ground and the fixed joint come last, so that the ids of links and joints do not change. With a floating
/// base the new ground is the base.
pub fn rebased(mechanism: &Mechanism, x_gr: Transform<f64>) -> Mechanism {
    let (mut links, mut joints) = describe(mechanism);
    let unused = |taken: &dyn Fn(&str) -> bool| {
        let mut name = "new_ground".to_owned();
        while taken(&name) {
            name.push('_');
        }
        name
    };
    let ground = unused(&|name| mechanism.find_link(name).is_ok());
    let hold = unused(&|name| mechanism.find_joint(name).is_ok());
    let root = mechanism.link(mechanism.root()).name();
    joints.push(JointDescription::new(hold, JointKind::Fixed, ground.as_str(), root).origin(x_gr));
    links.push(LinkDescription::massless(ground));
    // The world is now the new ground, so closures to the world need a new frame.
    let (mut closures, couplings) = describe_loops(mechanism);
    for (closure, own) in closures.iter_mut().zip(mechanism.closures()) {
        if own.predecessor().link.is_none() {
            closure.predecessor_frame = x_gr * closure.predecessor_frame;
        }
        if own.successor().link.is_none() {
            closure.successor_frame = x_gr * closure.successor_frame;
        }
    }
    build_with_loops(mechanism.name(), links, joints, closures, couplings)
}

/// Rounds origins (translation, and roll, pitch and yaw) and axes to the given number of decimals, as a file
/// would. Masses, centres of mass and inertias stay exact.
///
/// # Panics
/// If an axis is rounded to zero.
pub fn written(mechanism: &Mechanism, decimals: usize) -> Mechanism {
    let (links, mut joints) = describe(mechanism);
    for joint in &mut joints {
        joint.origin = rounded_frame(&joint.origin, decimals);
        joint.axis = rounded_vector(&joint.axis, decimals);
    }
    let (mut closures, couplings) = describe_loops(mechanism);
    for closure in &mut closures {
        closure.predecessor_frame = rounded_frame(&closure.predecessor_frame, decimals);
        closure.successor_frame = rounded_frame(&closure.successor_frame, decimals);
        closure.axis = rounded_vector(&closure.axis, decimals);
        closure.axis2 = rounded_vector(&closure.axis2, decimals);
    }
    build_with_loops(mechanism.name(), links, joints, closures, couplings)
}

/// Frame with rounded translation and rounded roll, pitch and yaw.
fn rounded_frame(frame: &Transform<f64>, decimals: usize) -> Transform<f64> {
    let rpy = rpy_from_rotation(&frame.rotation).map(|angle| rounded_number(angle, decimals));
    Transform::new(rotation_from_rpy(rpy), rounded_vector(&frame.translation, decimals))
}

/// Vector with rounded components.
fn rounded_vector(vector: &Vector3<f64>, decimals: usize) -> Vector3<f64> {
    vector.map(|x| rounded_number(x, decimals))
}

/// Number rounded to the given decimals.
fn rounded_number(x: f64, decimals: usize) -> f64 {
    format!("{x:.decimals$}").parse().expect("a number that was printed")
}

/// Places mechanisms on a common ground, in the given order; names get the given prefixes.
///
/// # Panics
/// If a root has mass, which would be lost in the ground.
pub fn on_common_ground(parts: &[(&str, &Mechanism)]) -> Mechanism {
    const GROUND: &str = "ground";
    let mut links = vec![LinkDescription::massless(GROUND)];
    let (mut joints, mut closures, mut couplings) = (Vec::new(), Vec::new(), Vec::new());
    for (prefix, mechanism) in parts {
        assert!(mechanism.link(mechanism.root()).inertia().mass == 0.0, "{prefix}: a heavy root");
        let root = mechanism.link(mechanism.root()).name().to_owned();
        let name = |own: &str| if own == root { GROUND.to_owned() } else { format!("{prefix}{own}") };
        let (own_links, own_joints) = describe(mechanism);
        let (own_closures, own_couplings) = describe_loops(mechanism);
        links.extend(
            own_links
                .into_iter()
                .filter(|l| l.name != root)
                .map(|l| LinkDescription { name: name(&l.name), ..l }),
        );
        joints.extend(own_joints.into_iter().map(|joint| JointDescription {
            name: format!("{prefix}{}", joint.name),
            parent: name(&joint.parent),
            child: name(&joint.child),
            mimic:
                joint.mimic.clone().map(|m| MimicDescription { joint: format!("{prefix}{}", m.joint), ..m }),
            ..joint
        }));
        closures.extend(own_closures.into_iter().map(|closure| ClosureDescription {
            name: format!("{prefix}{}", closure.name),
            predecessor: name(&closure.predecessor),
            successor: name(&closure.successor),
            ..closure
        }));
        let joints_of = |terms: Vec<(String, f64)>| {
            terms.into_iter().map(|(joint, factor)| (format!("{prefix}{joint}"), factor)).collect()
        };
        couplings.extend(own_couplings.into_iter().map(|coupling| match coupling {
            CouplingForm::Ratio(coupling) => CouplingForm::Ratio(CouplingDescription {
                name: format!("{prefix}{}", coupling.name),
                predecessor: name(&coupling.predecessor),
                successor: name(&coupling.successor),
                ..coupling
            }),
            CouplingForm::Relation(relation) => CouplingForm::Relation(RelationDescription {
                name: format!("{prefix}{}", relation.name),
                terms: joints_of(relation.terms),
                curve:
                    relation.curve.map(|curve| CurveDescription { terms: joints_of(curve.terms), ..curve }),
                ..relation
            }),
        }));
    }
    build_with_loops("beside", links, joints, closures, couplings)
}

/// Displaces the successor's loop frame of a closure by `shift` (m) and rotates the frame by the rotation
/// vector `turn` (rad), both in the loop frame. The rows of a redundant closure then contradict each other.
pub fn displaced(
    mechanism: &Mechanism,
    closure: usize,
    shift: Vector3<f64>,
    turn: Vector3<f64>,
) -> Mechanism {
    let (links, joints) = describe(mechanism);
    let (mut closures, couplings) = describe_loops(mechanism);
    let by = Transform::new(nalgebra::Rotation3::new(turn).into_inner(), shift);
    let frame = &mut closures[closure].successor_frame;
    *frame = *frame * by;
    build_with_loops(mechanism.name(), links, joints, closures, couplings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zoo;
    use percuss_mechanism::Inertial;

    #[test]
    fn descriptions_rebuild_the_same_mechanism() {
        for (name, mechanism) in zoo::all() {
            let (links, joints) = describe(&mechanism);
            let again = build(name, links.clone(), joints.clone());
            let (links_again, joints_again) = describe(&again);
            for (a, b) in joints.iter().zip(joints_again) {
                // The builder normalises a unit axis again: two roundings.
                assert!((a.axis - b.axis).amax() <= 2.0 * f64::EPSILON, "{name}");
                assert_eq!(*a, JointDescription { axis: a.axis, ..b }, "{name}");
            }
            for (a, b) in links.iter().zip(&links_again) {
                assert_eq!((&a.name, a.inertial.is_some()), (&b.name, b.inertial.is_some()), "{name}");
                let (a, b) = (a.inertial.unwrap_or(Inertial::point(0.0, [0.0; 3])), b.inertial);
                let b = b.unwrap_or(Inertial::point(0.0, [0.0; 3]));
                // Parallel-axis theorem forwards and backwards, for bodies within a few metres.
                assert!((a.about_com - b.about_com).amax() <= 1e-14 * (1.0 + a.mass), "{name}");
            }
        }
    }
}
