//! Relations between the positions of joints: a linear relation of two positions is a mimic, a relation of one is a lock; others become
//! couplings of the mechanism.

use crate::mjcf::relations::references::JointKey;
use crate::reading::document::element_tree::ElementId;
use std::collections::HashMap;

/// Position of a dependent joint, rad or m, relative to the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Relation {
    /// The joint stays at a position.
    Locked(f64),
    /// q = multiplier · q_master + offset.
    Mimic { master: JointKey, multiplier: f64, offset: f64 },
}

/// Relation of several joints, Σ coefficient · q = constant + curve, rad or m, relative to the drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct JointSum {
    pub terms: Vec<(JointKey, f64)>,
    pub constant: f64,
    pub curve: Option<JointCurve>,
}

/// Powers 2, 3 and 4 of Σ coefficient · q, with their coefficients.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct JointCurve {
    pub terms: Vec<(JointKey, f64)>,
    pub offset: f64,
    pub coefficients: [f64; 3],
}

/// Relations of all joints; a joint without one moves freely.
#[derive(Debug, Default)]
pub(crate) struct JointRelations {
    relations: HashMap<JointKey, Relation>,
    /// Relations that are neither mimics nor locks, with their elements.
    sums: Vec<(ElementId, JointSum)>,
}

/// The positions are determined already, and differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Contradiction;

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

    /// Adds a relation. The first joint becomes the dependent one if the relation is linear, of two joints, and the joint is free.
    ///
    /// # Errors
    /// [`Contradiction`].
    pub fn add(&mut self, element: ElementId, sum: JointSum) -> Result<(), Contradiction> {
        if sum.curve.is_some() {
            self.sums.push((element, sum));
            return Ok(());
        }
        let (terms, mut constant) = (&sum.terms, sum.constant);
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
            [] => Err(Contradiction),
            [(joint, coefficient)] => {
                self.relations.insert(joint, Relation::Locked(constant / coefficient));
                Ok(())
            }
            [(joint, coefficient), (master, other)] => {
                let (multiplier, offset) = (-other / coefficient, constant / coefficient);
                self.relations.insert(joint, Relation::Mimic { master, multiplier, offset });
                Ok(())
            }
            _ => {
                self.sums.push((element, sum));
                Ok(())
            }
        }
    }

    /// Relations that are neither mimics nor locks. The positions of locked joints are part of the constants.
    ///
    /// # Errors
    /// The first relation without a moving joint that is not satisfied.
    pub fn sums(&mut self) -> Result<Vec<(ElementId, JointSum)>, ElementId> {
        let mut resolved = Vec::new();
        for (element, mut sum) in std::mem::take(&mut self.sums) {
            let fixed = self.take_locked(&mut sum.terms);
            let size = sum.constant.abs().max(fixed.abs());
            sum.constant -= fixed;
            if let Some(curve) = &mut sum.curve {
                curve.offset += self.take_locked(&mut curve.terms);
                if curve.terms.is_empty() {
                    let (s, [a, b, c]) = (curve.offset, curve.coefficients);
                    sum.constant += s * s * (a + s * (b + s * c));
                    sum.curve = None;
                }
            }
            if sum.curve.is_some() || !sum.terms.is_empty() {
                resolved.push((element, sum));
            } else if sum.constant.abs() > ROUNDING * size {
                return Err(element);
            }
        }
        Ok(resolved)
    }

    /// Removes the locked joints from a sum, and returns their part.
    pub fn take_locked(&mut self, terms: &mut Vec<(JointKey, f64)>) -> f64 {
        let mut fixed = 0.0;
        terms.retain(|&(joint, coefficient)| match self.get(joint) {
            Some(Relation::Locked(position)) => {
                fixed += coefficient * position;
                false
            }
            _ => true,
        });
        fixed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: JointKey = (1, 0);
    const B: JointKey = (2, 0);
    const C: JointKey = (3, 0);

    fn add(
        relations: &mut JointRelations,
        terms: &[(JointKey, f64)],
        constant: f64,
    ) -> Result<(), Contradiction> {
        relations.add(ElementId(0), JointSum { terms: terms.to_vec(), constant, curve: None })
    }

    #[test]
    fn chains_and_repeated_relations_are_resolved() {
        let mut relations = JointRelations::default();
        // a = 2 b + 1, then a = 4 c, so that b = 2 c − 1/2.
        add(&mut relations, &[(A, 1.0), (B, -2.0)], 1.0).unwrap();
        add(&mut relations, &[(A, 1.0), (C, -4.0)], 0.0).unwrap();
        let mimic = |multiplier, offset| Some(Relation::Mimic { master: C, multiplier, offset });
        assert_eq!(relations.get(A), mimic(4.0, 0.0));
        assert_eq!(relations.get(B), mimic(2.0, -0.5));
        // The same relation again, and one that contradicts it.
        assert_eq!(add(&mut relations, &[(B, 1.0), (C, -2.0)], -0.5), Ok(()));
        assert_eq!(add(&mut relations, &[(B, 1.0), (C, -2.0)], 0.5), Err(Contradiction));
        assert_eq!(add(&mut relations, &[(B, 1.0)], 1.5), Ok(()));
        assert_eq!(relations.get(C), Some(Relation::Locked(1.0)));
        assert_eq!(relations.get(A), Some(Relation::Locked(4.0)));
    }

    #[test]
    fn locked_joints_of_sums_become_constants() {
        let mut relations = JointRelations::default();
        add(&mut relations, &[(A, 1.0), (B, 2.0), (C, 3.0)], 0.5).unwrap();
        assert_eq!(relations.get(A), None);
        add(&mut relations, &[(B, 1.0)], 0.25).unwrap();
        let [(_, sum)] = &relations.sums().unwrap()[..] else { panic!("one sum") };
        assert_eq!((&sum.terms[..], sum.constant), (&[(A, 1.0), (C, 3.0)][..], 0.0));
    }
}
