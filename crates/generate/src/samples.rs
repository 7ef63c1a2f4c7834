//! Assembled configurations: for the choice of the independent rows, and as reference values.

use crate::mechanics::tree::Tree;
use crate::request::Request;
use percuss_dynamics::{Configuration, EffectiveMass, Pose};
use percuss_mechanism::{JointId, JointKind};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use std::f64::consts::PI;

/// Largest change of a driving joint of loops from the design pose, rad or characteristic lengths.
const DRIVER_RANGE: f64 = 0.35;
/// Attempts for each sample; each halves the range.
const ATTEMPTS: usize = 6;
/// Largest relative error of a result that becomes a reference value.
const LARGEST_ERROR: f64 = 1e-9;

/// Configuration with the result of the library.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    /// Inputs of the function.
    pub inputs: Vec<f64>,
    pub outcome: EffectiveMass,
    /// Stated error relative to m̄.
    pub error: f64,
}

/// Uniform random number in −1…1.
fn symmetric(rng: &mut ChaCha8Rng) -> f64 {
    let unit = (rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
    2.0 * unit - 1.0
}

/// Inputs of a pose.
pub(crate) fn inputs_of(tree: &Tree, pose: &Pose) -> Vec<f64> {
    tree.input_joints.iter().flat_map(|input| pose.joint(input.joint).iter().copied()).collect()
}

/// The design pose and random assembled poses.
pub(crate) fn samples(request: &Request, tree: &Tree, count: usize) -> Vec<Sample> {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut found: Vec<Sample> = sample(request, tree, request.pose.clone()).into_iter().collect();
    for _ in 0..count {
        let mut range = 1.0;
        for _ in 0..ATTEMPTS {
            if let Some(sample) = random_pose(request, &mut rng, range).and_then(|p| sample(request, tree, p))
            {
                found.push(sample);
                break;
            }
            range *= 0.5;
        }
    }
    found
}

/// Result at a pose; `None` at a singular pose, and without a result.
fn sample(request: &Request, tree: &Tree, pose: Pose) -> Option<Sample> {
    let response = pose.respond(&request.contact_at(&pose)).ok()?;
    if response.singular_pose {
        return None;
    }
    let response = match request.other_mass {
        Some(mass) => response.against_mass(mass).ok()?,
        None => response,
    };
    let outcome = response.effective_mass;
    let error = match outcome {
        EffectiveMass::Finite(m) => response.effective_mass_error().unwrap_or(0.0) / m,
        EffectiveMass::Immovable | EffectiveMass::Massless => 0.0,
    };
    (error < LARGEST_ERROR).then(|| Sample { inputs: inputs_of(tree, &pose), outcome, error })
}

/// Pose with random positions: the joints outside loops anywhere within their limits, the driving joints of loops near
/// the design pose.
fn random_pose(request: &Request, rng: &mut ChaCha8Rng, range: f64) -> Option<Pose> {
    let mechanism = request.system.mechanism();
    let drivers: Vec<JointId> = request.pose.assembly().drivers();
    let mut positions = request.pose.positions().to_vec();
    let mut first = 0;
    for id in mechanism.joint_ids() {
        let joint = mechanism.joint(id);
        let q = &mut positions[first..first + joint.kind().positions()];
        first += q.len();
        let bound = request.system.is_bound(id);
        if joint.mimic().is_some() || bound && !drivers.contains(&id) {
            continue;
        }
        let (size, length) = match bound {
            true => (DRIVER_RANGE * range, DRIVER_RANGE * range * request.scale()),
            false => (PI * range, 0.5 * request.scale() * range),
        };
        let center = q.to_vec();
        match joint.kind() {
            JointKind::Fixed => {}
            JointKind::Revolute | JointKind::Continuous => q[0] = center[0] + size * symmetric(rng),
            JointKind::Prismatic => q[0] = center[0] + length * symmetric(rng),
            JointKind::Planar => {
                q[0] += length * symmetric(rng);
                q[1] += length * symmetric(rng);
                q[2] += size * symmetric(rng);
            }
            JointKind::Spherical => turn_quaternion(q, size, rng),
            JointKind::Floating => {
                q[..3].iter_mut().for_each(|x| *x += length * symmetric(rng));
                turn_quaternion(&mut q[3..], size, rng);
            }
        }
        if let (Some(limits), [value]) = (joint.limits(), q) {
            *value = value.clamp(limits.lower, limits.upper);
        }
    }
    let configuration = Configuration::from_positions(mechanism, &positions).ok()?;
    let pose = request.system.pose_from(&request.pose, &configuration);
    pose.ok()
}

/// Changes a quaternion at random and normalises it.
fn turn_quaternion(q: &mut [f64], size: f64, rng: &mut ChaCha8Rng) {
    q.iter_mut().for_each(|x| *x += size * symmetric(rng));
    let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.iter_mut().for_each(|x| *x /= norm);
}
