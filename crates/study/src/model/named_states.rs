//! Named poses of a model as states at rest.

use crate::model::loading::Model;
use percuss_dynamics::{Conditions, Configuration, System};
use percuss_formats::{Change, Effect, MechanismState, NamedPose};
use percuss_spatial::Twist;
use std::error::Error;
use std::sync::Arc;

/// State at rest of each named pose, and the lost poses. A pose is lost if its loops cannot be closed.
pub fn named_states(model: &Model) -> (Vec<(String, MechanismState)>, Vec<Change>) {
    let (mut states, mut lost) = (Vec::new(), Vec::new());
    for pose in model.poses.iter() {
        match state_at(model, pose) {
            Ok(state) => states.push((pose.name.clone(), state)),
            Err(error) => lost.push(Change {
                effect: Effect::Lost,
                element: format!("pose \"{}\"", pose.name),
                what: "the named pose".to_owned(),
                reason: error.to_string(),
            }),
        }
    }
    (states, lost)
}

/// State at rest at a named pose, with closed loops.
fn state_at(model: &Model, pose: &NamedPose) -> Result<MechanismState, Box<dyn Error>> {
    let mechanism = &model.mechanism;
    let configuration = Configuration::from_positions(mechanism, &pose.all_positions(mechanism))?;
    let pose = System::new(Arc::clone(mechanism), &Conditions::default())?.pose(&configuration)?;
    let of_joints = mechanism.joint_ids();
    Ok(MechanismState {
        positions: of_joints.map(|joint| pose.joint(joint).to_vec()).collect(),
        velocities: mechanism.joints().iter().map(|joint| vec![0.0; joint.kind().dofs()]).collect(),
        link_poses: mechanism.link_ids().map(|link| pose.link(link)).collect(),
        link_twists: vec![Twist::zero(); mechanism.links().len()],
    })
}
