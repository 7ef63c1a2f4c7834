//! Random conditions of an analysis, in the forms of the library and of the oracle.

use percuss_dynamics::{Base, Conditions};
use percuss_mechanism::{JointId, Mechanism};
use percuss_oracle::maximal::{Held, Question};
use percuss_oracle::random;
use rand::{Rng, rngs::StdRng};

/// Conditions for the library and for the oracle.
#[derive(Clone, Debug)]
pub struct Imposed {
    /// For the library.
    pub conditions: Conditions,
    /// Name for failure messages.
    pub name: String,
    locked: Vec<JointId>,
    armature: Vec<(JointId, Vec<f64>)>,
    held: Vec<Held>,
}

/// Number of variants: with or without a floating base, a lock, an armature and a held contact.
pub const VARIANTS: usize = 16;

impl Imposed {
    /// Combination of conditions: bit 0 a floating base, bit 1 a lock, bit 2 an armature, bit 3 a held contact.
    pub fn at_random(rng: &mut StdRng, mechanism: &Mechanism, variant: usize) -> Self {
        let base = if variant % 2 == 1 { Base::Floating } else { Base::Fixed };
        let mut all = Self {
            conditions: Conditions::new().base(base),
            name: format!("{base:?}"),
            locked: vec![],
            armature: vec![],
            held: vec![],
        };
        let movable = |id: &JointId| mechanism.joint(*id).kind().dofs() > 0;
        let joints: Vec<_> = mechanism.joint_ids().filter(movable).collect();
        if variant / 2 % 2 == 1 && !joints.is_empty() {
            let id = joints[rng.random_range(0..joints.len())];
            all.conditions = all.conditions.lock(mechanism.joint(id).name());
            all.name += &format!(", {} locked", mechanism.joint(id).name());
            all.locked.push(id);
        }
        if variant / 4 % 2 == 1 && !joints.is_empty() {
            let id = joints[rng.random_range(0..joints.len())];
            let values: Vec<f64> =
                (0..mechanism.joint(id).kind().dofs()).map(|_| rng.random_range(0.01..2.0)).collect();
            all.conditions = all.conditions.armature(mechanism.joint(id).name(), values.clone());
            all.name += ", armature";
            all.armature.push((id, values));
        }
        if variant / 8 % 2 == 1 {
            let (link, _, point, normal) = random::contact(rng, mechanism);
            let normal = rng.random_bool(0.7).then_some(normal);
            all.conditions = all.conditions.hold(mechanism.link(link).name(), point, normal);
            all.name += ", held";
            all.held.push(Held { link, point, normal });
        }
        all
    }

    /// Adds these conditions to a question for the oracle.
    pub fn ask<'a>(&self, question: Question<'a>) -> Question<'a> {
        Question {
            locked: self.locked.clone(),
            armature: self.armature.clone(),
            held: self.held.clone(),
            ..question
        }
    }
}
