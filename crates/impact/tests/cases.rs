//! Random mechanisms under random conditions, at closed poses, with a contact each.

use percuss_dynamics::{Base, Conditions, Configuration, Contact, Direction, Frame, Pose, System};
use percuss_mechanism::{JointId, Mechanism};
use percuss_oracle::maximal::{Held, Question};
use percuss_oracle::{linkage, random};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::sync::Arc;

/// A mechanism under conditions at a closed pose, with a contact.
pub struct Case {
    pub name: String,
    pub mechanism: Arc<Mechanism>,
    pub pose: Pose,
    pub contact: Contact,
    locked: Vec<JointId>,
    armature: Vec<(JointId, Vec<f64>)>,
    held: Vec<Held>,
    is_floating: bool,
}

impl Case {
    /// Case with conditions by the bits of `variant`: 1 a floating base, 2 a lock, 4 an armature, 8 a held contact, 16 locks of one to
    /// three mimics, masters or joints of couplings, if the mechanism has any. `None` if the loops do not close at `positions`.
    pub fn new(
        name: String,
        mechanism: &Arc<Mechanism>,
        positions: &[Vec<f64>],
        variant: u64,
        rng: &mut StdRng,
    ) -> Option<Self> {
        let is_floating = variant & 1 > 0;
        let base = if is_floating { Base::Floating } else { Base::Fixed };
        let mut conditions = Conditions::new().base(base);
        let (mut locked, mut armature, mut held) = (Vec::new(), Vec::new(), Vec::new());
        let movable = |id: &JointId| mechanism.joint(*id).kind().dofs() > 0;
        let joints: Vec<JointId> = mechanism.joint_ids().filter(movable).collect();
        let any = |rng: &mut StdRng| joints[rng.random_range(0..joints.len())];
        if variant & 2 > 0 {
            let id = any(rng);
            conditions = conditions.lock(mechanism.joint(id).name());
            locked.push(id);
        }
        let coupled = coupled_joints(mechanism);
        if variant & 16 > 0 && !coupled.is_empty() {
            for _ in 0..rng.random_range(1..=3) {
                let id = coupled[rng.random_range(0..coupled.len())];
                if !locked.contains(&id) {
                    conditions = conditions.lock(mechanism.joint(id).name());
                    locked.push(id);
                }
            }
        }
        if variant & 4 > 0 {
            let id = any(rng);
            let values: Vec<f64> =
                (0..mechanism.joint(id).kind().dofs()).map(|_| rng.random_range(0.01..2.0)).collect();
            conditions = conditions.armature(mechanism.joint(id).name(), values.clone());
            armature.push((id, values));
        }
        if variant & 8 > 0 {
            let (link, _, point, normal) = random::contact(rng, mechanism);
            let normal = rng.random_bool(0.7).then_some(normal);
            conditions = conditions.hold(mechanism.link(link).name(), point, normal);
            held.push(Held { link, point, normal });
        }
        let system = System::new(Arc::clone(mechanism), &conditions).expect("conditions that fit");
        let configuration = Configuration::from_positions(mechanism, &positions.concat()).expect("positions");
        let pose = system.pose(&configuration).ok()?;
        let (link, against, point, normal) = random::contact(rng, mechanism);
        let contact = Contact { link, against, point, normal: Direction::Along(normal, Frame::World) };
        let mechanism = Arc::clone(mechanism);
        Some(Self { name, mechanism, pose, contact, locked, armature, held, is_floating })
    }

    /// The question for the oracle.
    pub fn question(&self) -> Question<'_> {
        let located = self.pose.locate(&self.contact).expect("a contact");
        let positions = self.mechanism.joint_ids().map(|id| self.pose.joint(id).to_vec()).collect();
        Question {
            floating_base: self.is_floating,
            against: located.against,
            is_moment: located.is_moment,
            locked: self.locked.clone(),
            armature: self.armature.clone(),
            held: self.held.clone(),
            ..Question::new(
                &self.mechanism,
                positions,
                located.link,
                located.point_link,
                located.normal_world,
            )
        }
    }
}

/// Mimics, their masters, and the joints of couplings.
fn coupled_joints(mechanism: &Mechanism) -> Vec<JointId> {
    let mimics = mechanism.joint_ids().filter_map(|id| Some([id, mechanism.joint(id).mimic()?.master]));
    let terms = mechanism.couplings().iter().flat_map(|coupling| coupling.terms());
    mimics.flatten().chain(terms.map(|(joint, _)| *joint)).collect()
}

/// Random linkages and trees with linear relations of joint positions and mimics, and with locks of joints in these relations and mimics.
pub fn coupled(count: u64) -> Vec<Case> {
    let mut cases = Vec::new();
    for seed in 0..count {
        let mut rng = StdRng::seed_from_u64(77_000 + seed);
        let (bodies, closures, relations) = (5 + seed as usize % 7, seed as usize % 3, 1 + seed as usize % 4);
        let (mechanism, positions) = random::coupled_linkage(&mut rng, bodies, closures, relations);
        let name = format!("coupled linkage {seed}");
        cases.extend(Case::new(name, &Arc::new(mechanism), &positions, 16 | (seed % 16), &mut rng));
    }
    for variant in [16, 17, 22, 25] {
        for (number, one) in linkage::all().into_iter().enumerate() {
            if coupled_joints(&one.mechanism).is_empty() {
                continue;
            }
            let mut rng = StdRng::seed_from_u64(9_500 + 16 * number as u64 + variant);
            let name = format!("{}, variant {variant}", one.name);
            let positions = one.closed_start();
            cases.extend(Case::new(name, &Arc::new(one.mechanism), &positions, variant, &mut rng));
        }
    }
    cases
}

/// Random linkages with closures of all kinds, random trees, all specimens of linkages, and planar linkages with three
/// or more redundant rows.
pub fn all(count: u64) -> Vec<Case> {
    let mut cases = Vec::new();
    for seed in 0..count {
        let mut rng = StdRng::seed_from_u64(9000 + seed);
        let (mechanism, positions) = random::linkage(&mut rng, 4 + seed as usize % 7, 1 + seed as usize % 3);
        let name = format!("random linkage {seed}");
        cases.extend(Case::new(name, &Arc::new(mechanism), &positions, seed % 16, &mut rng));
        let tree = random::mechanism(&mut rng, 2 + seed as usize % 8);
        let positions = random::positions(&mut rng, &tree);
        cases.extend(Case::new(format!("tree {seed}"), &Arc::new(tree), &positions, seed % 16, &mut rng));
        let drawn = linkage::family::drawn(seed);
        let zero: Vec<Vec<f64>> =
            drawn.mechanism.joints().iter().map(|j| vec![0.0; j.kind().positions()]).collect();
        let label = drawn.label();
        cases.extend(Case::new(label, &Arc::new(drawn.mechanism), &zero, seed % 16, &mut rng));
    }
    for variant in [0, 1, 4, 6, 9, 13] {
        for (number, one) in linkage::all().into_iter().enumerate() {
            let mut rng = StdRng::seed_from_u64(500 + 16 * number as u64 + variant);
            let name = format!("{}, variant {variant}", one.name);
            let positions = one.closed_start();
            cases.extend(Case::new(name, &Arc::new(one.mechanism), &positions, variant, &mut rng));
        }
    }
    cases
}
