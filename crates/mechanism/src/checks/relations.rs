//! Validation of relations between joint positions.

use crate::checks::check::Check;
use crate::checks::closures::coupling_subject;
use crate::elements::coupling::{Coupling, Curve};
use crate::problem::Problem;
use crate::{JointId, Mechanism, RelationDescription};
use std::collections::{HashMap, HashSet};

/// Checks names and numbers of relations; needs no tree. `first`: number of the couplings before them.
pub(crate) fn check(relations: &[RelationDescription], first: usize, check: &mut Check) {
    check.unique(relations.iter().map(|r| &r.name), |index, name| coupling_subject(first + index, name));
    for (i, relation) in relations.iter().enumerate() {
        let subject = coupling_subject(first + i, &relation.name);
        check.is_valid(&subject, "factor", relation.terms.iter().map(|term| &term.1));
        check.is_valid(&subject, "constant", [&relation.constant]);
        if let Some(curve) = &relation.curve {
            check.is_valid(&subject, "factor", curve.terms.iter().map(|term| &term.1));
            check.is_valid(&subject, "offset", [&curve.offset]);
            check.is_valid(&subject, "coefficient", &curve.coefficients);
        }
    }
}

/// Adds the valid relations to the couplings of the mechanism, with joint names resolved. Adds an error for an unknown joint, a joint
/// with several degrees of freedom, and a relation without a moving joint.
pub(crate) fn attach(
    mechanism: &mut Mechanism,
    relations: &[RelationDescription],
    first: usize,
    check: &mut Check,
) {
    for (i, relation) in relations.iter().enumerate() {
        match coupling(mechanism, relation, check) {
            Ok(coupling) => mechanism.couplings.push(coupling),
            Err(problem) => check.add(coupling_subject(first + i, &relation.name), problem),
        }
    }
}

/// Coupling of a relation.
fn coupling(
    mechanism: &Mechanism,
    relation: &RelationDescription,
    check: &mut Check,
) -> Result<Coupling, Problem> {
    let mut terms = resolve(mechanism, &relation.terms, check)?;
    let curve = match &relation.curve {
        Some(curve) if curve.coefficients != [0.0; 3] => {
            let own = resolve(mechanism, &curve.terms, check)?;
            Some(Curve { terms: own, offset: curve.offset, coefficients: curve.coefficients })
        }
        _ => None,
    };
    let linear: HashSet<JointId> = terms.iter().map(|(joint, _)| *joint).collect();
    let others = curve.iter().flat_map(|curve| &curve.terms).filter(|(joint, _)| !linear.contains(joint));
    terms.extend(others.map(|(joint, _)| (*joint, 0.0)));
    if terms.is_empty() {
        return Err(Problem::CouplingOfNothing);
    }
    Ok(Coupling { name: relation.name.clone(), ratio: None, terms, constant: relation.constant, curve })
}

/// Joints with one degree of freedom, each once, with the sums of their factors; fixed joints are left out.
fn resolve(
    mechanism: &Mechanism,
    terms: &[(String, f64)],
    check: &mut Check,
) -> Result<Vec<(JointId, f64)>, Problem> {
    let mut resolved: Vec<(JointId, f64)> = Vec::with_capacity(terms.len());
    let mut position_of = HashMap::new();
    for (name, factor) in terms {
        let Some(&id) = mechanism.joint_by_name.get(name) else {
            let near = check.near(name, mechanism.joints.iter().map(|joint| joint.name.as_str()));
            return Err(Problem::UnknownJoint { joint: name.clone(), near });
        };
        let joint = mechanism.joint(id);
        match joint.kind().dofs() {
            0 => continue,
            1 => {}
            _ => {
                let kind = joint.kind().name();
                return Err(Problem::CouplingKind { joint: name.clone(), kind });
            }
        }
        let position = *position_of.entry(id).or_insert_with(|| {
            resolved.push((id, 0.0));
            resolved.len() - 1
        });
        resolved[position].1 += factor;
    }
    Ok(resolved)
}
