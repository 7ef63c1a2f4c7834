//! Converts the bodies of a model to the input of the crate `kernel`.

use super::massless_root::massless_root;
use crate::model::{Body, Model};
use percuss_kernel::{Cluster, ClusterVelocity, JointMotion, JointPosition, Mechanism, Velocity};
use percuss_mechanism::{Joint, JointKind};

/// Bodies and clusters of a model.
pub(crate) fn mechanism(model: &Model) -> Mechanism {
    let massless = massless_root(model);
    let count = |before: &mut usize, joint: &Joint| {
        let first = *before;
        *before += joint.kind().dofs();
        Some(first)
    };
    let first_velocities: Vec<usize> = model.mechanism.joints().iter().scan(0, count).collect();
    let body = |body: &Body| percuss_kernel::Body {
        parent: body.parent,
        motion: motion(body),
        axis: body.motion.axis(),
        origin: body.origin,
        inertia: body.inertia,
        q: body.q.start,
        mimic: body.mimic.map(|mimic| JointPosition {
            q: mimic.master,
            multiplier: mimic.multiplier,
            offset: mimic.offset,
        }),
        velocities: velocities(model, body),
        output: body.joint.map(|joint| first_velocities[joint.index()]),
        floats: body.parent.is_some_and(|parent| massless.contains(&parent)),
    };
    let velocity = |own: &crate::model::ClusterVelocity| ClusterVelocity {
        body: own.body,
        coordinate: own.coordinate,
        multiplier: own.multiplier,
        armature: own.armature,
    };
    let clusters = model.clusters.iter().filter(|cluster| cluster.is_bound).map(|cluster| Cluster {
        bodies: cluster.bodies.clone(),
        parents: cluster.parents.clone(),
        parent: cluster.parent,
        coordinates: cluster.coordinates.len(),
        velocities: cluster.velocities.iter().map(velocity).collect(),
    });
    Mechanism {
        bodies: model.bodies.iter().map(body).collect(),
        coordinates: model.coordinates.len(),
        clusters: clusters.collect(),
        characteristic_length: model.mechanism.characteristic_length(),
    }
}

fn motion(body: &Body) -> JointMotion {
    match body.motion.kind {
        JointKind::Fixed => JointMotion::Fixed,
        JointKind::Revolute | JointKind::Continuous => JointMotion::Revolute,
        JointKind::Prismatic => JointMotion::Prismatic,
        JointKind::Planar => JointMotion::Planar,
        JointKind::Spherical => JointMotion::Spherical,
        JointKind::Floating if body.joint.is_none() => JointMotion::Base,
        JointKind::Floating => JointMotion::Floating,
    }
}

/// Velocities of a joint; none if the joint is locked.
fn velocities(model: &Model, body: &Body) -> Vec<Velocity> {
    let velocity = |(v, armature): (usize, &f64)| {
        let follows = model.velocity_coordinates[v];
        Velocity {
            coordinate: follows.map(|follows| follows.index),
            multiplier: follows.map_or(0.0, |follows| follows.multiplier),
            armature: *armature,
        }
    };
    body.v.clone().zip(&body.armature).map(velocity).collect()
}
