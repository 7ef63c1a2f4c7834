//! Joints between a floating base without mass and the first body with mass.
//!
//! The only child of such a base moves as a floating body. For a contact on the child or on its subtree, the rate of the joint between the
//! base and the child is arbitrary; the kernels use zero.

use crate::model::Model;
use percuss_mechanism::JointKind;

/// Bodies without inertia from the floating base on, each with one child. Empty if the base is fixed, has inertia, or takes part in a
/// constraint.
pub(crate) fn massless_root(model: &Model) -> Vec<usize> {
    let mut chain = Vec::new();
    let floats = |body: usize| {
        model.bodies[body].motion.kind == JointKind::Floating && model.bodies[body].joint.is_none()
    };
    let mut next = (!model.bodies.is_empty() && floats(0)).then_some(0);
    while let Some(body) = next {
        let own = &model.bodies[body];
        let mut children = (body + 1..model.bodies.len()).filter(|&b| model.bodies[b].parent == Some(body));
        let (Some(child), None) = (children.next(), children.next()) else { break };
        let is_massless = own.inertia.mass == 0.0 && own.inertia.rotational.norm() == 0.0;
        let rotors =
            own.armature.iter().chain(&model.bodies[child].armature).any(|armature| *armature != 0.0);
        if !is_massless
            || rotors
            || model.bodies[child].mimic.is_some()
            || [body, child].iter().any(|&b| is_constrained(model, b))
        {
            break;
        }
        chain.push(body);
        next = Some(child);
    }
    chain
}

/// True if the joint of a body occurs in a constraint, or in a mimic.
fn is_constrained(model: &Model, body: usize) -> bool {
    let mut constraints = model.groups.iter().flat_map(|group| &group.constraints);
    constraints.any(|constraint| constraint.terms.iter().any(|term| term.body == body))
        || model.clusters.iter().any(|cluster| cluster.is_bound && cluster.bodies.contains(&body))
}
