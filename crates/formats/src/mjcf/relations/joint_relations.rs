//! Linear relations between the positions of joints: a relation of two positions is a mimic, a relation of one is a lock.

use crate::mjcf::relations::references::JointKey;
use std::collections::HashMap;

/// Position of a dependent joint, rad or m, relative to the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Relation {
    /// The joint stays at a position.
    Locked(f64),
    /// q = multiplier · q_master + offset.
    Mimic { master: JointKey, multiplier: f64, offset: f64 },
}

/// Relations of all joints; a joint without one moves freely.
#[derive(Debug, Default)]
pub(crate) struct JointRelations {
    relations: HashMap<JointKey, Relation>,
}

/// Reason for which a relation cannot be expressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RelationDefect {
    /// More than two independent joints.
    TooManyJoints(usize),
    /// The positions are determined already, and differ.
    Contradiction,
}

/// A coefficient that is smaller, relative to the largest term, is the rounding error of a difference, dimensionless.
const ROUNDING: f64 = 1e-12;

impl JointRelations {
    /// Relation of a joint; `None` if it moves freely.
    pub fn get(&mut self, joint: JointKey) -> Option<Relation> {
        let (master, multiplier, offset) = self.resolve(joint);
        match master {
            None => Some(Relation::Locked(offset)),
            Some(master) if master == joint => None,
            Some(master) => Some(Relation::Mimic { master, multiplier, offset }),
        }
    }

    /// Joint without a relation on which `joint` depends, with multiplier and offset; `None` for a locked joint. Chains are shortened
    /// on the way, so that the cost of many searches is nearly linear.
    fn resolve(&mut self, joint: JointKey) -> (Option<JointKey>, f64, f64) {
        let mut chain = Vec::new();
        let mut current = joint;
        let mut end = loop {
            match self.relations.get(&current) {
                None => break (Some(current), 1.0, 0.0),
                Some(Relation::Locked(position)) => break (None, 0.0, *position),
                Some(Relation::Mimic { master, multiplier, offset }) => {
                    chain.push((current, *multiplier, *offset));
                    current = *master;
                }
            }
        };
        for (joint, multiplier, offset) in chain.into_iter().rev() {
            end = (end.0, multiplier * end.1, multiplier * end.2 + offset);
            let relation = match end.0 {
                None => Relation::Locked(end.2),
                Some(master) => Relation::Mimic { master, multiplier: end.1, offset: end.2 },
            };
            self.relations.insert(joint, relation);
        }
        end
    }

    /// Adds the relation Σ coefficient · q = constant. The first joint becomes the dependent one if it is free.
    ///
    /// # Errors
    /// [`RelationDefect`].
    pub fn add(&mut self, terms: &[(JointKey, f64)], mut constant: f64) -> Result<(), RelationDefect> {
        let mut free: Vec<(JointKey, f64)> = Vec::new();
        let mut position_of: HashMap<JointKey, usize> = HashMap::new();
        let mut largest = 0.0f64;
        let mut largest_constant = constant.abs();
        for &(joint, coefficient) in terms {
            let (master, multiplier, offset) = self.resolve(joint);
            largest_constant = largest_constant.max((coefficient * offset).abs());
            constant -= coefficient * offset;
            let Some(master) = master else { continue };
            let own = coefficient * multiplier;
            largest = largest.max(own.abs());
            let position = *position_of.entry(master).or_insert_with(|| {
                free.push((master, 0.0));
                free.len() - 1
            });
            free[position].1 += own;
        }
        free.retain(|(_, coefficient)| coefficient.abs() > ROUNDING * largest);
        match free[..] {
            [] if constant.abs() <= ROUNDING * largest_constant => Ok(()),
            [] => Err(RelationDefect::Contradiction),
            [(joint, coefficient)] => {
                self.relations.insert(joint, Relation::Locked(constant / coefficient));
                Ok(())
            }
            [(joint, coefficient), (master, other)] => {
                let (multiplier, offset) = (-other / coefficient, constant / coefficient);
                self.relations.insert(joint, Relation::Mimic { master, multiplier, offset });
                Ok(())
            }
            _ => Err(RelationDefect::TooManyJoints(free.len())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: JointKey = (1, 0);
    const B: JointKey = (2, 0);
    const C: JointKey = (3, 0);

    #[test]
    fn chains_and_repeated_relations_are_resolved() {
        let mut relations = JointRelations::default();
        // a = 2 b + 1, then a = 4 c, so that b = 2 c − 1/2.
        relations.add(&[(A, 1.0), (B, -2.0)], 1.0).unwrap();
        relations.add(&[(A, 1.0), (C, -4.0)], 0.0).unwrap();
        let mimic = |multiplier, offset| Some(Relation::Mimic { master: C, multiplier, offset });
        assert_eq!(relations.get(A), mimic(4.0, 0.0));
        assert_eq!(relations.get(B), mimic(2.0, -0.5));
        // The same relation again, and one that contradicts it.
        assert_eq!(relations.add(&[(B, 1.0), (C, -2.0)], -0.5), Ok(()));
        assert_eq!(relations.add(&[(B, 1.0), (C, -2.0)], 0.5), Err(RelationDefect::Contradiction));
        assert_eq!(relations.add(&[(B, 1.0)], 1.5), Ok(()));
        assert_eq!(relations.get(C), Some(Relation::Locked(1.0)));
        assert_eq!(relations.get(A), Some(Relation::Locked(4.0)));
    }

    #[test]
    fn three_joints_are_too_many() {
        let mut relations = JointRelations::default();
        let three = relations.add(&[(A, 1.0), (B, 1.0), (C, 1.0)], 0.0);
        assert_eq!(three, Err(RelationDefect::TooManyJoints(3)));
        assert_eq!(relations.get(A), None);
    }
}
