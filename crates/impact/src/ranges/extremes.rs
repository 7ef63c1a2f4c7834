//! Extreme effective masses over ranges of joint positions.

use crate::ranges::extreme_question::{
    ExtremeKind, ExtremeMass, JointRange, NormalRange, SearchedContact, SearchedQuantity,
};
use crate::ranges::extremes_error::{ExtremesError, no_driver, variable_joints};
use crate::ranges::quasi_newton::Point;
use crate::ranges::search::{IMMOVABLE, Search};
use percuss_dynamics::{Configuration, ConstraintSource, EffectiveMass, System};

/// Relative difference of values up to which two searches agree.
const SAME_VALUE: f64 = 1e-6;

/// Largest or smallest effective mass of a contact over ranges of driving joints: local searches from several starts.
///
/// A range of normals extends the search to positions and normals. At each position the extreme normal is an eigenvector of the mobility
/// of the contact point. There m̄ is stationary with respect to the normal, so the gradient over the positions uses this normal as fixed.
///
/// A projected quasi-Newton method with the gradient in closed form minimises or maximises 1/m̄, which is smooth where the contact is
/// immovable. Each start has two searches: from one point of a Halton sequence, and from the best of eight points of this sequence. The
/// method is deterministic and does not prove a global extreme; the number of agreeing starts indicates the confidence.
///
/// # Errors
/// [`ExtremesError`].
pub fn extreme_effective_mass(
    system: &System,
    configuration: &Configuration,
    contact: SearchedContact,
    ranges: &[JointRange],
    extreme: ExtremeKind,
    starts: usize,
) -> Result<ExtremeMass, ExtremesError> {
    let quantity = SearchedQuantity::EffectiveMass;
    extreme_quantity(system, configuration, contact, quantity, ranges, extreme, starts)
}

/// Extreme of a quantity over ranges of driving joints, by the searches of [`extreme_effective_mass`].
///
/// The gradient of an effective mass has a closed form. The gradients of the other quantities, and of an effective mass with held
/// contacts, are difference quotients of fourth order with a relative error of about 1e-12. A reflected inertia does not depend on the
/// contact. A range of normals applies to effective masses only.
///
/// # Errors
/// [`ExtremesError`].
pub fn extreme_quantity(
    system: &System,
    configuration: &Configuration,
    contact: SearchedContact,
    quantity: SearchedQuantity,
    ranges: &[JointRange],
    extreme: ExtremeKind,
    starts: usize,
) -> Result<ExtremeMass, ExtremesError> {
    let of_mass = quantity == SearchedQuantity::EffectiveMass;
    if !of_mass && contact.normals != NormalRange::Given {
        return Err(ExtremesError::NormalsOfMass);
    }
    if let SearchedQuantity::ReflectedInertia { joint, .. } = quantity
        && system.mechanism().joint(joint).kind().dofs() != 1
    {
        return Err(no_driver(system.pose(configuration).ok().as_ref(), system, joint));
    }
    if ranges.is_empty() {
        return Err(ExtremesError::NoJoint);
    }
    let mechanism = system.mechanism();
    let start = system.pose(configuration).ok();
    let variable = start.as_ref().map(|start| variable_joints(system, start));
    // Held contacts constrain the impact, not the pose: the pose moves along motions outside ker A, and the closed form does not apply.
    let has_holds = start.iter().flat_map(|start| start.constraint_groups()).any(|group| {
        group.constraints.iter().any(|action| matches!(action.source, ConstraintSource::Hold(_)))
    });
    for range in ranges {
        let joint = mechanism.joint(range.joint);
        let name = || joint.name().to_owned();
        let (lower, upper) = (range.lower, range.upper);
        if !(lower.is_finite() && upper.is_finite() && lower < upper) {
            return Err(ExtremesError::Range { joint: name(), lower, upper });
        }
        let varies = variable.as_ref().is_none_or(|variable| variable.contains(&range.joint));
        if joint.kind().dofs() != 1 || !varies {
            return Err(no_driver(start.as_ref(), system, range.joint));
        }
    }
    let SearchedContact { contact, wheel, normals } = contact;
    if let NormalRange::Across(axis) = normals
        && !(axis.norm().is_finite() && axis.norm() > 0.0)
    {
        return Err(ExtremesError::NoAxis);
    }
    let search =
        Search { system, configuration, contact, wheel, quantity, has_holds, ranges, normals, extreme };
    if let SearchedQuantity::BearingImpulse { joint } = quantity
        && extreme == ExtremeKind::Most
        && let Some(unbounded) = search.unbounded_impulse(joint, starts)?
    {
        return Ok(unbounded);
    }
    let (found, largest) = search.run_all(starts)?;
    let best = found.iter().min_by(|a, b| a.value.total_cmp(&b.value)).ok_or(ExtremesError::NoStart)?.clone();
    let largest = largest.max(search.typical()?);
    // A smallest value that is immovable: the contact is immovable at every pose of the search.
    let is_immovable = search.is_reciprocal() && best.inverse_mass <= IMMOVABLE * largest;
    // A squared impulse that is rounding of zero has no relative accuracy: its residual is relative to the largest squared impulse.
    let vanishes = !search.is_reciprocal() && best.inverse_mass <= IMMOVABLE * largest;
    let size = best.inverse_mass.max(IMMOVABLE * largest);
    let close =
        if search.is_reciprocal() { SAME_VALUE * size } else { (SAME_VALUE * size).max(IMMOVABLE * largest) };
    let same = |point: &&Point| (point.inverse_mass - best.inverse_mass).abs() <= close;
    let is_zero = match quantity {
        SearchedQuantity::BearingImpulse { joint } => search.transmits_nothing(&best.unit, joint),
        _ => false,
    };
    Ok(ExtremeMass {
        effective_mass: if is_immovable {
            EffectiveMass::Immovable
        } else if is_zero {
            EffectiveMass::Finite(0.0)
        } else {
            let value = best.inverse_mass;
            EffectiveMass::Finite(if search.is_reciprocal() { 1.0 / value } else { value.sqrt() })
        },
        positions: search.positions(&best.unit),
        normal_world: best.normal_world,
        active_limits: search.active_limits(&best.unit),
        residual: if is_immovable { 0.0 } else { best.residual() / if vanishes { largest } else { size } },
        starts: starts.max(1),
        agreeing: found.iter().filter(same).count(),
    })
}
