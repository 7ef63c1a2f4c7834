//! Open tree with mimic joints and an armature in place of a linkage, for simulators without loops.

use crate::ranges::reflected::{PoseMatrices, ReflectedError};
use crate::tolerances::{ARMATURE_STEPS, UNMOVED_JOINT};
use percuss_dynamics::{Base, Conditions, Configuration, EffectiveMass, Pose, System};
use percuss_mechanism::{JointId, Mechanism};
use std::sync::Arc;

/// Joint that follows another joint: q = multiplier · q_master + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MimicJoint {
    /// The joint.
    pub joint: JointId,
    /// Ratio of the positions: least-squares fit over the range.
    pub multiplier: f64,
    /// Position at the zero of the driving joint, rad or m.
    pub offset: f64,
    /// Largest difference from the position in the linkage, rad or m.
    pub position_error: f64,
}

/// Substitute of a linkage by its open tree: all dependent joints are mimic joints of the driving joint, and the driving joint has an
/// additional armature.
///
/// The armature a minimises the largest relative error of the reflected inertia, max |I_tree + a − I|/I over the range. The total armature
/// of the driving joint is not negative.
#[derive(Clone, Debug, PartialEq)]
pub struct MimicSubstitute {
    /// Mimic joints, in the order of the joints.
    pub joints: Vec<MimicJoint>,
    /// Inertia of the open tree with mimic joints at the driving joint at each position, kg·m² or kg; without the additional armature.
    pub inertias: Vec<f64>,
    /// Armature in addition to the armature of the driving joint, kg·m² or kg; negative if the inertia of the open tree is too large.
    pub armature: f64,
    /// Largest relative error of the reflected inertia over the range.
    pub largest_error: f64,
}

/// Reason for a missing substitute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoSubstitute {
    /// The joint does not drive, an inertia is not finite, or the open tree cannot be assembled.
    NotHeld,
    /// No other joint moves with the joint.
    NoDependentJoint,
    /// This joint with several velocities moves with the joint; a mimic joint has one velocity.
    SeveralVelocities(JointId),
}

/// Substitute over a range of poses. `exact`: inertia at the driving joint `driver` at each pose, with the other drivers held.
///
/// # Errors
/// [`ReflectedError`]: a mass matrix of the open tree that is not positive semi-definite.
pub(crate) fn mimic_substitute(
    poses: &[Pose],
    driver: JointId,
    exact: &[f64],
) -> Result<Result<MimicSubstitute, NoSubstitute>, ReflectedError> {
    let Some(first) = poses.first() else { return Ok(Err(NoSubstitute::NoDependentJoint)) };
    let mechanism = first.mechanism();
    let joints = match mimic_joints(poses, driver) {
        Ok(joints) if joints.is_empty() => return Ok(Err(NoSubstitute::NoDependentJoint)),
        Ok(joints) => joints,
        Err(joint) => return Ok(Err(NoSubstitute::SeveralVelocities(joint))),
    };
    // No error is expected: the builder accepted these links and joints for the mechanism.
    let Ok(tree) = mechanism.to_open_tree().build() else { return Ok(Err(NoSubstitute::NotHeld)) };
    let tree: Arc<Mechanism> = Arc::new(tree.mechanism);
    let Ok(system) = System::new(Arc::clone(&tree), &conditions(first)) else {
        return Ok(Err(NoSubstitute::NotHeld));
    };
    let mut inertias = Vec::with_capacity(poses.len());
    for pose in poses {
        let Some(pose) = tree_pose(&system, pose, driver, &joints) else {
            return Ok(Err(NoSubstitute::NotHeld));
        };
        match tree_inertia(&pose, driver, &joints)? {
            EffectiveMass::Finite(inertia) => inertias.push(inertia),
            _ => return Ok(Err(NoSubstitute::NotHeld)),
        }
    }
    let missing: Vec<(f64, f64)> =
        exact.iter().zip(&inertias).map(|(all, tree)| (all - tree, *all)).collect();
    let least = 0.0 - first.armature(driver).first().copied().unwrap_or(0.0);
    let (armature, largest_error) = best_constant(&missing, least);
    Ok(Ok(MimicSubstitute { joints, inertias, armature, largest_error }))
}

/// Joints that move with the driving joint, as mimic joints. `Err`: a moving joint with several velocities.
fn mimic_joints(poses: &[Pose], driver: JointId) -> Result<Vec<MimicJoint>, JointId> {
    let mechanism = poses[0].mechanism();
    let count = poses.len() as f64;
    let values = |at: usize| poses.iter().map(move |pose| pose.positions()[at]);
    let range = |at: usize| {
        let (least, most) =
            values(at).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        most - least
    };
    let own = first_position(mechanism, driver);
    let mean = values(own).sum::<f64>() / count;
    let square: f64 = values(own).map(|x| (x - mean).powi(2)).sum();
    let mut found = Vec::new();
    for joint in mechanism.joint_ids().filter(|joint| *joint != driver) {
        let (at, kind) = (first_position(mechanism, joint), mechanism.joint(joint).kind());
        if (at..at + kind.positions()).all(|at| range(at) <= UNMOVED_JOINT) {
            continue;
        }
        if kind.dofs() != 1 {
            return Err(joint);
        }
        let mean_of_joint = values(at).sum::<f64>() / count;
        let product: f64 = values(own).zip(values(at)).map(|(x, y)| (x - mean) * (y - mean_of_joint)).sum();
        let multiplier = product / square;
        let offset = mean_of_joint - multiplier * mean;
        let error = values(own).zip(values(at)).map(|(x, y)| (multiplier * x + offset - y).abs());
        let position_error = error.fold(0.0, f64::max);
        found.push(MimicJoint { joint, multiplier, offset, position_error });
    }
    Ok(found)
}

/// Index of the first position of a joint.
fn first_position(mechanism: &Mechanism, joint: JointId) -> usize {
    mechanism.position_ranges().nth(joint.index()).map_or(0, |range| range.start)
}

/// Base and armatures of a pose, without locks and held points: the substitute prescribes all other joints.
fn conditions(pose: &Pose) -> Conditions {
    let mechanism = pose.mechanism();
    let is_floating = pose.coordinate_joints().first().is_some_and(|(joint, _)| joint.is_none());
    let base = if is_floating { Base::Floating } else { Base::Fixed };
    mechanism.joint_ids().fold(Conditions::new().base(base), |conditions, joint| match pose.armature(joint) {
        [] => conditions,
        armature => conditions.armature(mechanism.joint(joint).name(), armature.to_vec()),
    })
}

/// Pose of the open tree with the mimic joints at their fitted positions, and the other joints at those of `pose`.
fn tree_pose(system: &System, pose: &Pose, driver: JointId, joints: &[MimicJoint]) -> Option<Pose> {
    let mechanism = pose.mechanism();
    let mut positions = pose.positions().to_vec();
    let of_driver = positions[first_position(mechanism, driver)];
    for mimic in joints {
        positions[first_position(mechanism, mimic.joint)] = mimic.multiplier * of_driver + mimic.offset;
    }
    system.pose(&Configuration::from_positions(system.mechanism(), &positions).ok()?).ok()
}

/// Inertia of the open tree at the driving joint: the mimic joints follow, all other joints are at rest, and a floating base is free.
fn tree_inertia(
    pose: &Pose,
    driver: JointId,
    joints: &[MimicJoint],
) -> Result<EffectiveMass, ReflectedError> {
    let system = PoseMatrices::new(pose);
    let coordinates = pose.coordinate_joints();
    let row = |joint: JointId, k: usize, multiplier: f64| -> Vec<f64> {
        let entry = |&(of, at): &(Option<JointId>, usize)| match of {
            Some(of) if of == joint && at == k => 1.0,
            Some(of) if of == driver => -multiplier,
            _ => 0.0,
        };
        coordinates.iter().map(entry).collect()
    };
    let multiplier = |joint: JointId| {
        joints.iter().find(|mimic| mimic.joint == joint).map_or(0.0, |mimic| mimic.multiplier)
    };
    let others =
        coordinates.iter().filter_map(|&(joint, k)| Some((joint?, k))).filter(|(joint, _)| *joint != driver);
    let prescribed: Vec<Vec<f64>> = others.map(|(joint, k)| row(joint, k, multiplier(joint))).collect();
    let own: Vec<f64> =
        coordinates.iter().map(|(joint, _)| if *joint == Some(driver) { 1.0 } else { 0.0 }).collect();
    Ok(system.least_mass(&own, &prescribed)?)
}

/// Constant a ≥ `least` with the smallest max |a − d|/s over the pairs (d, s), and this value.
///
/// The maximum is convex in a: at each step the pair with the largest value shows the side of the optimum.
fn best_constant(pairs: &[(f64, f64)], least: f64) -> (f64, f64) {
    let error = |a: f64, (d, s): &(f64, f64)| (a - d).abs() / s;
    let worst = |a: f64| pairs.iter().max_by(|x, y| error(a, x).total_cmp(&error(a, y)));
    let low = pairs.iter().map(|(d, _)| *d).fold(f64::INFINITY, f64::min).max(least);
    let high = pairs.iter().map(|(d, _)| *d).fold(f64::NEG_INFINITY, f64::max).max(least);
    if worst(low).is_some_and(|(d, _)| *d <= low) {
        return (low, worst(low).map_or(0.0, |pair| error(low, pair)));
    }
    let (mut low, mut high) = (low, high);
    for _ in 0..ARMATURE_STEPS {
        let middle = 0.5 * (low + high);
        match worst(middle) {
            Some((d, _)) if *d < middle => high = middle,
            _ => low = middle,
        }
    }
    let a = 0.5 * (low + high);
    (a, worst(a).map_or(0.0, |pair| error(a, pair)))
}
