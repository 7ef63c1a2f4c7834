//! Mechanisms at random positions with random contacts, with and without locks, armatures and a floating base.

use crate::judge::near_at;
use nalgebra::Vector3;
use percuss_dynamics::{
    Base, Conditions, Configuration, Contact, ContactResponse, Direction, Frame, Pose, System,
};
use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use percuss_oracle::{alter, maximal::Question, random, zoo};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::sync::Arc;

/// A mechanism under conditions, at a position, with a contact.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name for failure messages.
    pub name: String,
    /// The mechanism.
    pub mechanism: Arc<Mechanism>,
    /// Fixed or floating root.
    pub base: Base,
    /// Locked joints.
    pub locks: Vec<JointId>,
    /// Armatures that replace those of the mechanism.
    pub armatures: Vec<(JointId, Vec<f64>)>,
    /// One list per joint, with the positions of mimics.
    pub positions: Vec<Vec<f64>>,
    /// The contact link.
    pub on: LinkId,
    /// The other side; `None`: the ground.
    pub against: Option<LinkId>,
    /// The contact point in the contact link, m.
    pub point: Vector3<f64>,
    /// n̂ in the root link's axes.
    pub normal: Vector3<f64>,
}

impl Case {
    /// Random position and random contact, without conditions.
    pub fn plain(rng: &mut StdRng, name: String, mechanism: Arc<Mechanism>, base: Base) -> Self {
        let positions = random::positions(rng, &mechanism);
        let (mut on, mut against, point, normal) = random::contact(rng, &mechanism);
        // The contact may be on the floating base itself.
        if base == Base::Floating && rng.random_bool(0.15) {
            (on, against) = (mechanism.root(), None);
        }
        Self {
            name,
            mechanism,
            base,
            locks: vec![],
            armatures: vec![],
            positions,
            on,
            against,
            point,
            normal,
        }
    }

    /// Locks a third of the joints, at least one if there are joints; mimics and fixed joints too.
    pub fn with_locks(mut self, rng: &mut StdRng) -> Self {
        self.locks = self.mechanism.joint_ids().filter(|_| rng.random_bool(0.3)).collect();
        if self.locks.is_empty() {
            self.locks.extend(self.mechanism.joint_ids().next());
        }
        self.name += ", locked";
        self
    }

    /// Replaces the armature of half of the moving joints, in some cases by zero.
    pub fn with_armatures(mut self, rng: &mut StdRng) -> Self {
        for id in self.mechanism.joint_ids() {
            let kind = self.mechanism.joint(id).kind();
            if kind.dofs() == 0 || rng.random_bool(0.5) {
                continue;
            }
            let one_for_all = kind.is_homogeneous() && rng.random_bool(0.5);
            let count = if one_for_all { 1 } else { kind.dofs() };
            let value = |rng: &mut StdRng| match rng.random_range(0..4) {
                0 => 0.0,
                _ => 10f64.powf(rng.random_range(-3.0..0.5)),
            };
            let values = (0..count).map(|_| value(rng)).collect();
            self.armatures.push((id, values));
        }
        self.name += ", armatures";
        self
    }

    /// Conditions for routes A and B.
    pub fn conditions(&self) -> Conditions {
        let name = |id: JointId| self.mechanism.joint(id).name();
        let start = Conditions::new().base(self.base);
        let locked = self.locks.iter().fold(start, |c, &id| c.lock(name(id)));
        self.armatures.iter().fold(locked, |c, (id, values)| c.armature(name(*id), values.clone()))
    }

    /// The system under test.
    pub fn system(&self) -> System {
        System::new(Arc::clone(&self.mechanism), &self.conditions()).expect("conditions that fit")
    }

    /// The positions as a user would set them, joint by joint.
    pub fn configuration(&self, system: &System) -> Configuration {
        let mut configuration = system.configuration();
        for (joint, q) in self.mechanism.joints().iter().zip(&self.positions) {
            if joint.mimic().is_none() && joint.kind() != JointKind::Fixed {
                configuration.set(joint.name(), q).expect("a position that fits");
            }
        }
        configuration
    }

    /// The pose with the root link at the world's origin.
    pub fn pose(&self, system: &System) -> Pose {
        system.pose(&self.configuration(system)).expect("a tree poses")
    }

    /// The contact, with its normal in the world's axes; the root link is at the origin, so its axes are the world's.
    pub fn contact(&self) -> Contact {
        let contact = Contact::new(self.on, self.point, Vector3::z())
            .normal(Direction::Along(self.normal, Frame::World));
        match self.against {
            Some(other) => contact.against(other),
            None => contact,
        }
    }

    /// Relative tolerance for two computations of the case's result, from the condition of M.
    pub fn near(&self) -> f64 {
        near_at(&self.pose(&self.system()))
    }

    /// The response by the automatic route.
    pub fn response(&self) -> ContactResponse {
        let system = self.system();
        self.pose(&system).respond(&self.contact()).expect("an answer")
    }

    /// The question for the oracle.
    pub fn question(&self) -> Question<'_> {
        Question {
            floating_base: self.base == Base::Floating,
            locked: self.locks.clone(),
            armature: self.armatures.clone(),
            against: self.against,
            ..Question::new(&self.mechanism, self.positions.clone(), self.on, self.point, self.normal)
        }
    }

    /// The effective armature of a joint, one value per velocity.
    pub fn armature(&self, joint: JointId) -> Vec<f64> {
        let own = self.mechanism.joint(joint);
        match self.armatures.iter().find(|(id, _)| *id == joint) {
            None => own.armature().to_vec(),
            Some((_, values)) if values.len() == 1 => vec![values[0]; own.kind().dofs()],
            Some((_, values)) => values.clone(),
        }
    }

    /// True if a mimic moves.
    pub fn has_moving_mimics(&self, system: &System) -> bool {
        let moves = |id| self.mechanism.joint(id).mimic().is_some() && !system.is_locked(id);
        self.mechanism.joint_ids().any(moves)
    }
}

/// All mechanisms of the zoo, with fixed and floating base; plain, with locks, with armatures, with both, with
/// everything locked; `repeats` random positions and contacts each.
pub fn of_the_zoo(seed: u64, repeats: usize) -> Vec<Case> {
    let mut rng = StdRng::seed_from_u64(seed);
    let mut cases = Vec::new();
    for (name, mechanism) in zoo::all() {
        let mechanism = Arc::new(mechanism);
        for base in [Base::Fixed, Base::Floating] {
            for variant in 0..4 {
                for _ in 0..repeats {
                    let label = format!("{name} {}, {base:?}", cases.len());
                    let plain = Case::plain(&mut rng, label, Arc::clone(&mechanism), base);
                    cases.push(varied(&mut rng, plain, variant));
                }
            }
            let label = format!("{name} {}, {base:?}, everything locked", cases.len());
            let mut still = Case::plain(&mut rng, label, Arc::clone(&mechanism), base);
            still.locks = mechanism.joint_ids().collect();
            cases.push(still);
        }
    }
    cases
}

/// `count` random mechanisms of 1 to `largest` bodies, more small than large; half of them without mimics, so that
/// every route solves them. Bases, locks and armatures vary in turn.
pub fn at_random(seed: u64, count: usize, largest: usize) -> Vec<Case> {
    let case = |i: usize| {
        let mut rng = StdRng::seed_from_u64(seed + i as u64);
        let part = i as f64 / (count.max(2) - 1) as f64;
        let bodies = 1 + (part * part * (largest - 1) as f64).round() as usize;
        let mut mechanism = random::mechanism(&mut rng, bodies);
        if i % 2 == 1 {
            mechanism = without_mimics(&mechanism);
        }
        let base = if i % 4 < 2 { Base::Fixed } else { Base::Floating };
        let label = format!("random {i} of {bodies}, {base:?}");
        let plain = Case::plain(&mut rng, label, Arc::new(mechanism), base);
        varied(&mut rng, plain, i / 4)
    };
    (0..count).map(case).collect()
}

fn varied(rng: &mut StdRng, mut case: Case, variant: usize) -> Case {
    if variant % 2 == 1 {
        case = case.with_locks(rng);
    }
    if variant / 2 % 2 == 1 {
        case = case.with_armatures(rng);
    }
    case
}

/// The mechanism with all mimics replaced by free joints.
pub fn without_mimics(mechanism: &Mechanism) -> Mechanism {
    let (links, mut joints) = alter::describe(mechanism);
    joints.iter_mut().for_each(|joint| joint.mimic = None);
    alter::build(mechanism.name(), links, joints)
}
