//! The same mechanism changed: taken apart, in other units, on another ground.

use percuss_mechanism::{
    Accept, Geometry, Joint, JointDescription, JointKind, Limits, Link, LinkDescription, Mechanism,
    MechanismBuilder, Mimic, MimicDescription,
};
use percuss_spatial::Transform;

/// The descriptions a mechanism could have been built from, in its order of links and joints.
pub fn describe(mechanism: &Mechanism) -> (Vec<LinkDescription>, Vec<JointDescription>) {
    let links = mechanism.links().iter().map(describe_link).collect();
    let joints = mechanism.joints().iter().map(|joint| describe_joint(mechanism, joint)).collect();
    (links, joints)
}

fn describe_link(link: &Link) -> LinkDescription {
    LinkDescription {
        name: link.name().to_owned(),
        inertial: link.inertial().copied(),
        geometry: link.geometry(),
    }
}

fn describe_joint(mechanism: &Mechanism, joint: &Joint) -> JointDescription {
    JointDescription {
        name: joint.name().to_owned(),
        kind: joint.kind(),
        parent: mechanism.link(joint.parent()).name().to_owned(),
        child: mechanism.link(joint.child()).name().to_owned(),
        origin: *joint.origin(),
        axis: *joint.axis(),
        limits: joint.limits(),
        armature: joint.armature().to_vec(),
        mimic: joint.mimic().map(|mimic| MimicDescription {
            joint: mechanism.joint(mimic.master).name().to_owned(),
            multiplier: mimic.multiplier,
            offset: mimic.offset,
        }),
    }
}

/// Builds a mechanism, its inertias taken as they are.
///
/// # Panics
/// Where the descriptions make no mechanism, with the builder's words.
pub fn build(name: &str, links: Vec<LinkDescription>, joints: Vec<JointDescription>) -> Mechanism {
    let builder = MechanismBuilder::new(name).accept(Accept { indefinite_inertia: true });
    let builder = links.into_iter().fold(builder, MechanismBuilder::link);
    match joints.into_iter().fold(builder, MechanismBuilder::joint).build() {
        Ok(built) => built.mechanism,
        Err(error) => panic!("{name}: {error}"),
    }
}

/// The mechanism in other units: lengths times `length`, masses times `mass`; m̄ becomes `mass` times as large.
///
/// Inertias and armatures of turning velocities take length²·mass, those of sliding ones mass; a mimic between a
/// sliding and a turning joint has a ratio in 1/m or m, which changes too.
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
        let unit = |kind| if kind == JointKind::Prismatic { length } else { 1.0 };
        if let Some(Limits { lower, upper }) = &mut joint.limits {
            *lower *= unit(joint.kind);
            *upper *= unit(joint.kind);
        }
        if let (Some(mimic), Some(Mimic { master, .. })) = (&mut joint.mimic, own.mimic()) {
            mimic.multiplier *= unit(joint.kind) / unit(mechanism.joint(master).kind());
            mimic.offset *= unit(joint.kind);
        }
    }
    build(mechanism.name(), links, joints)
}

/// Positions of a mechanism that was [`scaled`] by `length`.
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

/// The mechanism under a new, massless ground link, held to it by a fixed joint with the origin `x_gr`.
///
/// The ground and its joint come last, so that ids of links and joints stay what they were; with a floating base
/// the new ground flies along.
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
    build(mechanism.name(), links, joints)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zoo;

    #[test]
    fn a_mechanism_survives_being_described() {
        for (name, mechanism) in zoo::all() {
            let (links, joints) = describe(&mechanism);
            let again = build(name, links.clone(), joints.clone());
            let (links_again, joints_again) = describe(&again);
            for (a, b) in joints.iter().zip(joints_again) {
                // A unit axis is normalised again: two roundings.
                assert!((a.axis - b.axis).amax() <= 2.0 * f64::EPSILON, "{name}");
                assert_eq!(*a, JointDescription { axis: a.axis, ..b }, "{name}");
            }
            for (a, b) in links.iter().zip(&links_again) {
                assert_eq!((&a.name, a.inertial.is_some()), (&b.name, b.inertial.is_some()), "{name}");
                let (a, b) = (a.inertial.unwrap_or(Inertial::point(0.0, [0.0; 3])), b.inertial);
                let b = b.unwrap_or(Inertial::point(0.0, [0.0; 3]));
                // The parallel-axis theorem there and back, of bodies within a few metres.
                assert!((a.about_com - b.about_com).amax() <= 1e-14 * (1.0 + a.mass), "{name}");
            }
        }
    }
}
