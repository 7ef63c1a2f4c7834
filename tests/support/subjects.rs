//! Trees and linkages at closed poses, each with a contact.

use crate::cases::Case;
use crate::imposed::{Imposed, VARIANTS};
use crate::motion::Motion;
use crate::rig::{Rig, positions};
use nalgebra::{DMatrix, DVector};
use percuss_dynamics::{Conditions, Contact, Direction, Frame, Pose, System};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use percuss_oracle::linkage;
use percuss_oracle::maximal::{Question, close};
use percuss_oracle::random;
use percuss_spatial::Twist;
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::sync::Arc;

/// A system at a closed pose with a contact. The root link is at the world's origin.
#[derive(Debug)]
pub struct Subject {
    /// Name for failure messages.
    pub name: String,
    /// System under conditions.
    pub system: System,
    /// Closed pose.
    pub pose: Pose,
    /// Contact at this pose.
    pub contact: Contact,
    /// Joints that the oracle may move to close the loops.
    pub free: Vec<JointId>,
    given: Option<Imposed>,
    case: Option<Case>,
}

/// Limits relative to the largest singular value of A: smaller values count as zero, larger values count.
const RANK: [f64; 2] = [1e-8, 1e-3];

impl Subject {
    /// Subject from a tree.
    pub fn of_case(case: &Case) -> Self {
        let system = case.system();
        let pose = case.pose(&system);
        let (name, contact) = (case.name.clone(), case.contact());
        Self { name, system, pose, contact, free: vec![], given: None, case: Some(case.clone()) }
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Arc<Mechanism> {
        self.system.mechanism()
    }

    /// Conditions of the system.
    pub fn conditions(&self) -> Conditions {
        match (&self.given, &self.case) {
            (Some(given), _) => given.conditions.clone(),
            (None, Some(case)) => case.conditions(),
            (None, None) => unreachable!("a subject is a case or a linkage"),
        }
    }

    /// The question for the oracle.
    pub fn question(&self) -> Question<'_> {
        match (&self.given, &self.case) {
            (Some(given), _) => {
                given.ask(crate::rig::question(&self.system, self.mechanism(), &self.pose, &self.contact))
            }
            (None, Some(case)) => case.question(),
            (None, None) => unreachable!("a subject is a case or a linkage"),
        }
    }

    /// Random admissible motion, with the root link at rest; `None` if nothing moves, or if the rank of A is unclear.
    pub fn motion(&self, rng: &mut StdRng) -> Option<Motion> {
        let a = self.pose.constraint_matrix();
        let joints = self.system.coordinate_joints();
        let still = joints.iter().filter(|(joint, _)| joint.is_none()).count();
        let mut rows = DMatrix::zeros(a.nrows() + still, joints.len());
        rows.rows_mut(0, a.nrows()).copy_from(&a);
        (0..still).for_each(|k| rows[(a.nrows() + k, k)] = 1.0);
        let mut u = DVector::from_fn(joints.len(), |_, _| rng.random_range(-1.0..1.0));
        if rows.nrows() > 0 {
            let gram = (&rows * rows.transpose()).symmetric_eigen();
            let most = gram.eigenvalues.amax();
            let unclear = |l: &f64| (RANK[0].powi(2)..RANK[1].powi(2)).contains(&(l / most));
            if gram.eigenvalues.iter().any(unclear) {
                return None;
            }
            let counted = |l: f64| if l > RANK[1].powi(2) * most { 1.0 / l } else { 0.0 };
            let inverse = DVector::from_iterator(rows.nrows(), gram.eigenvalues.iter().map(|l| counted(*l)));
            // Repeated: each pass removes the rounding of the pass before.
            for _ in 0..3 {
                let along = gram.eigenvectors.tr_mul(&(&rows * &u));
                u -= rows.tr_mul(&(&gram.eigenvectors * along.component_mul(&inverse)));
            }
        }
        let motion = Motion::from_coordinates(&self.system, &u);
        (motion.size() > 1e-6).then_some(motion)
    }

    /// All positions after the motion for a time `h`, with the loops closed again by the oracle.
    pub fn positions_after(&self, motion: &Motion, h: f64) -> Vec<f64> {
        let later = self.pose.advanced(&motion.joints, &Twist::zero(), h).expect("velocities that fit");
        if self.free.is_empty() {
            return later.positions().to_vec();
        }
        let open = positions(self.mechanism(), &later);
        close(self.mechanism(), &open, &self.free).expect("beside a closed pose").concat()
    }
}

/// Trees of the zoo and random trees.
pub fn of_trees(seed: u64, repeats: usize, count: usize) -> Vec<Subject> {
    let cases = [crate::cases::of_the_zoo(seed, repeats), crate::cases::at_random(1000 * seed, count, 30)];
    cases.concat().iter().map(Subject::of_case).collect()
}

/// Every linkage of the oracle at a number of poses of its range, under every combination of conditions in turn.
pub fn of_linkages(seed: u64, poses: usize) -> Vec<Subject> {
    let mut all = Vec::new();
    for (number, linkage) in linkage::all().into_iter().enumerate() {
        let rig = Rig::new(linkage);
        let mut rng = StdRng::seed_from_u64(seed + number as u64);
        let mut pose = rig.closed();
        for i in 0..poses {
            let drivers = rig.at((i as f64 + 0.5) / poses as f64);
            pose = rig.reach(&pose, &drivers);
            let given = Imposed::at_random(&mut rng, &rig.mechanism, (i + number) % VARIANTS);
            let system = rig.with(&given.conditions);
            let there =
                system.pose(&rig.guessed(&drivers, &positions(&rig.mechanism, &pose))).expect("closed");
            let (on, against, point, normal) = random::contact(&mut rng, &rig.mechanism);
            let contact = Contact::new(on, point, normal).normal(Direction::Along(normal, Frame::World));
            let moves = |id: &JointId| {
                let joint = rig.mechanism.joint(*id);
                joint.kind() != JointKind::Fixed && joint.mimic().is_none()
            };
            all.push(Subject {
                name: format!("{} at {drivers:.3?}, {}", rig.name, given.name),
                system,
                pose: there,
                contact: against.map_or(contact, |other| contact.against(other)),
                free: rig.mechanism.joint_ids().filter(moves).collect(),
                given: Some(given),
                case: None,
            });
        }
    }
    all
}
