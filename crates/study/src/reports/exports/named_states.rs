//! Named poses of a model as states at rest.

use crate::model::loading::Model;
use percuss_dynamics::{Conditions, Configuration, System};
use percuss_formats::{Change, MechanismState, NamedPose, lost_pose};
use percuss_spatial::Twist;
use std::error::Error;
use std::sync::Arc;

/// States of the named poses with zero velocity and closed loops, and the lost poses: those that cannot be evaluated, for example because
/// the loops do not close.
pub(super) fn named_states(model: &Model) -> (Vec<(String, MechanismState)>, Vec<Change>) {
    let (mut states, mut lost) = (Vec::new(), Vec::new());
    if model.poses.is_empty() {
        return (states, lost);
    }
    let system = System::new(Arc::clone(&model.mechanism), &Conditions::default());
    for pose in model.poses.iter() {
        let state = match &system {
            Ok(system) => state_at(system, model, pose).map_err(|error| error.to_string()),
            Err(error) => Err(error.to_string()),
        };
        match state {
            Ok(state) => states.push((pose.name.clone(), state)),
            Err(reason) => lost.push(lost_pose(&pose.name, reason)),
        }
    }
    (states, lost)
}

/// State at a named pose with zero velocity and closed loops.
fn state_at(system: &System, model: &Model, pose: &NamedPose) -> Result<MechanismState, Box<dyn Error>> {
    let mechanism = &model.mechanism;
    let configuration = Configuration::from_positions(mechanism, &pose.all_positions(mechanism))?;
    let pose = system.pose(&configuration)?;
    Ok(MechanismState {
        positions: mechanism.joint_ids().map(|joint| pose.joint(joint).to_vec()).collect(),
        velocities: mechanism.joints().iter().map(|joint| vec![0.0; joint.kind().dofs()]).collect(),
        link_poses: mechanism.link_ids().map(|link| pose.link(link)).collect(),
        link_twists: vec![Twist::zero(); mechanism.links().len()],
    })
}
