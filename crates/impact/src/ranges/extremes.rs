//! Extreme effective masses over ranges of joint positions and along paths.

use crate::ranges::extreme_question::{
    DriverPath, ExtremeKind, ExtremeMass, ExtremeOnPath, JointRange, KeptPoint, NormalRange, SearchedContact,
    SearchedPoses, SearchedQuantity,
};
use crate::ranges::extremes_error::{ExtremesError, no_driver, variable_joints};
use crate::ranges::kept_points::KeptRows;
use crate::ranges::path::{PathEnd, PathSearch};
use crate::ranges::quasi_newton::Point;
use crate::ranges::reflected::driving_joints;
use crate::ranges::search::{IMMOVABLE, Search, Variable};
use crate::reactions::bearing::Bearing;
use nalgebra::Vector3;
use percuss_dynamics::{Base, Configuration, ConstraintSource, Direction, EffectiveMass, System};
use percuss_mechanism::JointId;
use std::cell::Cell;
use std::f64::consts::FRAC_PI_2;
use std::rc::Rc;

/// Relative difference of values up to which two searches agree.
const SAME_VALUE: f64 = 1e-6;

/// Largest or smallest effective mass of a contact over ranges of driving joints: local searches from several starts.
///
/// A range of normals extends the search to positions and normals. At each position the extreme normal is an eigenvector of the mobility
/// of the contact point. There m̄ is stationary with respect to the normal, so the gradient over the positions uses this normal as fixed.
///
/// A projected quasi-Newton method with the gradient in closed form minimises or maximises 1/m̄, which is smooth where the contact is
/// immovable. Each start has two searches: from one point of a Halton sequence, and from the best of eight points of this sequence. The
/// method is deterministic and does not prove a global extreme; the number of agreeing starts indicates the confidence. A search over many
/// joints stops at a limit of work ([`ExtremeMass::is_stopped`]).
///
/// With kept points ([`SearchedPoses::kept`]) the search covers the self-motion. Gauss-Newton iterations move each start to positions at
/// which the points are in place. Each step is a Newton step along the tangent of the self-motion, followed by the same iterations. The
/// first start has a third search, from the configuration, if the configuration is within the ranges.
///
/// # Errors
/// [`ExtremesError`].
pub fn extreme_effective_mass<'a>(
    system: &System,
    configuration: &Configuration,
    contact: SearchedContact,
    poses: impl Into<SearchedPoses<'a>>,
    extreme: ExtremeKind,
    starts: usize,
) -> Result<ExtremeMass, ExtremesError> {
    let quantity = SearchedQuantity::EffectiveMass;
    extreme_quantity(system, configuration, contact, quantity, poses, extreme, starts)
}

/// Extreme of a quantity over ranges of driving joints, by the searches of [`extreme_effective_mass`].
///
/// The gradient of an effective mass has a closed form. The gradients of the other quantities, and of an effective mass with held
/// contacts, are difference quotients of fourth order with a relative error of about 1e-12. A reflected inertia does not depend on the
/// contact.
///
/// # Errors
/// [`ExtremesError`].
pub fn extreme_quantity<'a>(
    system: &System,
    configuration: &Configuration,
    contact: SearchedContact,
    quantity: SearchedQuantity,
    poses: impl Into<SearchedPoses<'a>>,
    extreme: ExtremeKind,
    starts: usize,
) -> Result<ExtremeMass, ExtremesError> {
    let SearchedPoses { ranges, kept } = poses.into();
    if ranges.is_empty() {
        return Err(ExtremesError::NoJoint);
    }
    for range in ranges {
        let (lower, upper) = (range.lower, range.upper);
        if !(lower.is_finite() && upper.is_finite() && lower < upper) {
            let joint = system.mechanism().joint(range.joint).name().to_owned();
            return Err(ExtremesError::Range { joint, lower, upper });
        }
    }
    let mut search = prepare(system, configuration, contact, quantity, extreme)?;
    check_varied(system, configuration, ranges.iter().map(|range| range.joint))?;
    search.variables = ranges.iter().map(|range| Variable { moves: vec![*range] }).collect();
    if !kept.is_empty() {
        search.kept = KeptRows::new(&system.pose(configuration)?, checked_kept(kept)?);
        if search.self_motions() == Some(0) {
            let name = |range: &JointRange| system.mechanism().joint(range.joint).name().to_owned();
            return Err(ExtremesError::NoSelfMotion { joints: ranges.iter().map(name).collect() });
        }
    }
    if let Some((bearing, _)) = quantity.bearing_load()
        && extreme == ExtremeKind::Most
        && let Some(unbounded) = search.unbounded_load(bearing, starts)?
    {
        return Ok(unbounded);
    }
    let (found, largest, searched) = search.run_all(starts)?;
    let best = found.iter().min_by(|a, b| a.value.total_cmp(&b.value)).ok_or(ExtremesError::NoStart)?;
    let largest = largest.max(search.typical()?);
    let is_stopped = search.is_stopped();
    Ok(ExtremeMass { is_stopped, ..conclude(&search, best, &found, largest, searched) })
}

/// Extreme of a quantity along a path of driving joints.
///
/// The path is sampled at all rows and at equal distances between them. Each pose is solved from the previous one, so loops stay on their
/// branch. Local searches as in [`extreme_quantity`] start at the best 32 samples that are at least as good as both neighbours. An extreme
/// can be missed if two extremes lie between neighbouring samples, or if more than 32 samples qualify.
///
/// # Errors
/// [`ExtremesError`].
pub fn extreme_along_path(
    system: &System,
    configuration: &Configuration,
    contact: SearchedContact,
    quantity: SearchedQuantity,
    path: &DriverPath,
    extreme: ExtremeKind,
) -> Result<ExtremeOnPath, ExtremesError> {
    let (joints, expected) = (path.joints, path.joints.len());
    if joints.is_empty() {
        return Err(ExtremesError::NoJoint);
    }
    if path.rows.is_empty() {
        return Err(ExtremesError::NoRows);
    }
    let is_invalid = |row: &Vec<f64>| row.len() != expected || row.iter().any(|x| !x.is_finite());
    if let Some((row, values)) = path.rows.iter().enumerate().find(|(_, values)| is_invalid(values)) {
        return Err(ExtremesError::PathRow { row, got: values.len(), expected });
    }
    let search = prepare(system, configuration, contact, quantity, extreme)?;
    check_varied(system, configuration, joints.iter().copied())?;
    let path = PathSearch::new(search, path);
    if let Some((bearing, _)) = quantity.bearing_load()
        && extreme == ExtremeKind::Most
    {
        let masses = path.of_masses();
        let (ends, largest) = masses.run()?;
        let unbounded: Vec<&PathEnd> = ends
            .iter()
            .filter(|end| path.segment(end.segment).is_unbounded(&end.point, largest, bearing))
            .collect();
        if let Some(end) = unbounded.first() {
            let search = path.segment(end.segment);
            let mut extreme = conclude(&search, &end.point, &[], largest, ends.len());
            extreme.effective_mass = EffectiveMass::Immovable;
            (extreme.residual, extreme.agreeing) = (0.0, unbounded.len());
            extreme.active_limits.clear();
            return Ok(ExtremeOnPath { extreme, row: end.row() });
        }
    }
    let (ends, largest) = path.run()?;
    // A row belongs to two segments and gives equal values; the end with the smaller residual is used.
    let order = |a: &&PathEnd, b: &&PathEnd| {
        let same = a.point.has_value_of(&b.point);
        if same {
            a.point.residual.total_cmp(&b.point.residual)
        } else {
            a.point.value.total_cmp(&b.point.value)
        }
    };
    let best = ends.iter().min_by(order).ok_or(ExtremesError::NoStart)?;
    let found: Vec<Point> = ends.iter().map(|end| end.point.clone()).collect();
    let search = path.segment(best.segment);
    let mut extreme = conclude(&search, &best.point, &found, largest, ends.len());
    // The ends of a segment are no limits of the joints.
    extreme.active_limits.clear();
    Ok(ExtremeOnPath { extreme, row: best.row() })
}

/// Search without variables, after checks of the contact and the quantity.
fn prepare<'a>(
    system: &'a System,
    configuration: &'a Configuration,
    contact: SearchedContact<'a>,
    quantity: SearchedQuantity,
    extreme: ExtremeKind,
) -> Result<Search<'a>, ExtremesError> {
    let is_reflected = matches!(quantity, SearchedQuantity::ReflectedInertia { .. });
    if is_reflected && contact.normals != NormalRange::Given {
        return Err(ExtremesError::NormalsOfContact);
    }
    let start = system.pose(configuration).ok();
    if let (Some((Bearing::Ground, _)), Base::Floating) = (quantity.bearing_load(), system.base()) {
        return Err(ExtremesError::FloatingBase);
    }
    if let SearchedQuantity::ReflectedInertia { joint, .. } = quantity
        && system.mechanism().joint(joint).kind().dofs() != 1
    {
        return Err(no_driver(start.as_ref(), system, joint));
    }
    if let (SearchedQuantity::ReflectedInertia { joint, held: true }, Some(start)) = (quantity, &start) {
        let mechanism = system.mechanism();
        let drivers = driving_joints(start);
        let master = mechanism.joint(joint).mimic().map_or(joint, |mimic| mimic.master);
        if !drivers.contains(&master) {
            let name = |joint: JointId| mechanism.joint(joint).name().to_owned();
            let drivers = drivers.into_iter().map(name).collect();
            return Err(ExtremesError::NotHeld { joint: name(joint), drivers });
        }
    }
    // Held contacts constrain the impact, not the pose: the pose moves along motions outside ker A, and the closed form does not apply.
    let has_holds = start.iter().flat_map(|start| start.constraint_groups()).any(|group| {
        group.constraints.iter().any(|action| matches!(action.source, ConstraintSource::Hold(_)))
    });
    let SearchedContact { contact, wheel, normals, edges } = contact;
    let is_varied = matches!(normals, NormalRange::Cone(_)) || !edges.is_empty();
    let is_line = !matches!(contact.normal, Direction::Along(..) | Direction::About(..));
    let angle = if let NormalRange::Cone(angle) = normals { angle } else { 0.0 };
    let is_outside = !(0.0..=FRAC_PI_2).contains(&angle)
        || edges.len() > 2
        || edges.iter().flat_map(|edge| edge.iter()).any(|x| !x.is_finite());
    let has_all_normals = matches!(normals, NormalRange::Any | NormalRange::Across(_));
    if is_varied
        && (quantity != SearchedQuantity::EffectiveMass
            || is_line
            || wheel.is_some()
            || is_outside
            || (!edges.is_empty() && (has_all_normals || contact.normal.is_moment())))
    {
        return Err(ExtremesError::VariedContact);
    }
    if let NormalRange::Across(axis) = normals
        && !(axis.norm().is_finite() && axis.norm() > 0.0)
    {
        return Err(ExtremesError::NoAxis);
    }
    let (variables, kept) = (Vec::new(), KeptRows::default());
    // Work along a path is limited by the number of samples.
    let work = Rc::new(Cell::new(usize::MAX));
    Ok(Search {
        system,
        configuration,
        contact,
        wheel,
        quantity,
        has_holds,
        variables,
        kept,
        normals,
        edges,
        extreme,
        work,
    })
}

/// Refuses joints that cannot be varied.
fn check_varied(
    system: &System,
    configuration: &Configuration,
    joints: impl Iterator<Item = JointId>,
) -> Result<(), ExtremesError> {
    let start = system.pose(configuration).ok();
    let variable = start.as_ref().map(|start| variable_joints(system, start));
    for joint in joints {
        let varies = variable.as_ref().is_none_or(|variable| variable.contains(&joint));
        if system.mechanism().joint(joint).kind().dofs() != 1 || !varies {
            return Err(no_driver(start.as_ref(), system, joint));
        }
    }
    Ok(())
}

/// Kept points with usable normals.
fn checked_kept(kept: &[KeptPoint]) -> Result<&[KeptPoint], ExtremesError> {
    let has_direction = |normal: Vector3<f64>| normal.norm().is_finite() && normal.norm() > 0.0;
    match kept.iter().position(|point| !point.normal.is_none_or(has_direction)) {
        Some(number) => Err(ExtremesError::NoKeptNormal { number: number + 1 }),
        None => Ok(kept),
    }
}

/// Result of a search. `found`: ends of all starts; `largest`: largest measure of the search.
fn conclude(search: &Search, best: &Point, found: &[Point], largest: f64, starts: usize) -> ExtremeMass {
    // A smallest value that is immovable: the contact is immovable at every pose of the search.
    let is_immovable = search.is_reciprocal() && best.inverse_mass <= IMMOVABLE * largest;
    // A squared load that is rounding of zero has no relative accuracy: its residual is relative to the largest squared load.
    let vanishes = !search.is_reciprocal() && best.inverse_mass <= IMMOVABLE * largest;
    let size = best.inverse_mass.max(IMMOVABLE * largest);
    let close =
        if search.is_reciprocal() { SAME_VALUE * size } else { (SAME_VALUE * size).max(IMMOVABLE * largest) };
    let same = |point: &&Point| (point.inverse_mass - best.inverse_mass).abs() <= close;
    let is_zero = search
        .quantity
        .bearing_load()
        .is_some_and(|(bearing, _)| search.transmits_nothing(&best.unit, bearing));
    ExtremeMass {
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
        point_link: search.point_link(&best.unit),
        active_limits: search.active_limits(&best.unit),
        residual: if is_immovable { 0.0 } else { best.residual / if vanishes { largest } else { size } },
        kept_error: search.kept_error(&best.unit),
        starts,
        agreeing: found.iter().filter(same).count(),
        is_stopped: false,
    }
}
