//! Converts the constraints of a model to the input of the crate `kernel`.

use super::mechanism::mechanism;
use crate::analysis::assembly::Assembly;
use crate::model::{CompiledClosure, CompiledCoupling, Constraint, ConstraintRows, LinkFrame, Model};
use crate::tolerances::EXACT_AS_DRAWN;
use nalgebra::Vector3;
use percuss_kernel::{
    BodyDirection, BodyPoint, Linkage, Relation, RelationJoint, RowBlock, RowForm, RowTerm,
};
use percuss_mechanism::ClosureKind;

/// Bodies and constraints of an assembly. `None` if redundant rows contradict each other as drawn.
pub(crate) fn linkage(assembly: &Assembly) -> Option<Linkage> {
    let model = assembly.model();
    let groups = 0..model.groups.len();
    let rank: usize = groups.clone().map(|g| assembly.expected_rank(g)).sum();
    let length = model.mechanism.characteristic_length();
    // The kernel omits redundant rows. With rounded numbers in the file, closed loops would violate the omitted rows.
    let is_redundant = model.groups.iter().map(|group| group.rows).sum::<usize>() != rank;
    if is_redundant && assembly.misfits().iter().any(|misfit| *misfit > EXACT_AS_DRAWN * length) {
        return None;
    }
    let constraints =
        model.groups.iter().flat_map(|group| group.constraints.iter().map(move |c| (c, group.size)));
    let lengths = lengths(model);
    let depth = model.coordinates.iter().map(|c| c.depth).max().unwrap_or(0) + 1;
    Some(Linkage {
        mechanism: mechanism(model),
        blocks: constraints.map(|(constraint, size)| block(model, constraint, size)).collect(),
        rank,
        shortest_length: shortest(model, &lengths),
        lengths,
        depth,
        redundancy_threshold: groups.map(|g| assembly.floor(g)).fold(f64::INFINITY, f64::min),
        smallest_loop_size: model.groups.iter().map(|group| group.size).fold(f64::INFINITY, f64::min),
    })
}

/// Rows of one constraint. `size` (m) scales the rows of directions.
fn block(model: &Model, constraint: &ConstraintRows, size: f64) -> RowBlock {
    let terms = |scale: f64| {
        let term = |term: &crate::model::ConstraintTerm| RowTerm {
            body: term.body,
            component: term.component,
            factor: scale * term.factor,
            argument: scale * term.argument,
        };
        constraint.terms.iter().map(term).collect()
    };
    match constraint.constraint {
        Constraint::Closure(i) => {
            let closure = &model.closures[i];
            let origin = |end: &LinkFrame| BodyPoint { body: end.body, at: end.frame.translation.into() };
            RowBlock {
                predecessor: Some(origin(&closure.predecessor)),
                successor: origin(&closure.successor),
                forms: forms(closure, size),
                terms: terms(1.0),
                relation: None,
            }
        }
        Constraint::Coupling(i) => {
            let coupling = &model.couplings[i];
            let length = if coupling.turns { size } else { 1.0 };
            RowBlock {
                predecessor: None,
                successor: BodyPoint { body: None, at: [0.0; 3] },
                forms: vec![RowForm::Relation],
                terms: terms(length),
                relation: Some(relation(model, coupling, length)),
            }
        }
        Constraint::Hold(i) => {
            let hold = &model.holds[i];
            let on = &model.link_frames[hold.link.index()];
            let directions = hold.directions().into_iter().take(constraint.count);
            RowBlock {
                predecessor: None,
                successor: BodyPoint { body: on.body, at: on.frame.point(&hold.point).into() },
                forms: directions
                    .map(|d| RowForm::Along(BodyDirection { body: None, e: d.into() }))
                    .collect(),
                terms: terms(1.0),
                relation: None,
            }
        }
    }
}

/// Relation of the positions of a coupling; a mimic joint is replaced by its master. `length` (m) scales the residual.
fn relation(model: &Model, coupling: &CompiledCoupling, length: f64) -> Relation {
    let (mut constant, mut offset) = (coupling.constant, coupling.offset);
    let joints = coupling.terms.iter().map(|term| {
        let Some(mimic) = &model.bodies[term.body].mimic else {
            return RelationJoint { q: term.q, factor: term.factor, argument: term.argument };
        };
        constant -= term.factor * mimic.offset;
        offset += term.argument * mimic.offset;
        let [factor, argument] = [term.factor, term.argument].map(|own| own * mimic.multiplier);
        RelationJoint { q: mimic.master, factor, argument }
    });
    let joints = joints.collect();
    Relation { joints, constant, offset, curve: coupling.curve.unwrap_or_default(), length }
}

/// Rows of a closure, as in [`crate::kinematics::rows::closure_wrenches`], but the rows of coinciding points are in root
/// axes. `size` (m) scales the rows of directions.
fn forms(closure: &CompiledClosure, size: f64) -> Vec<RowForm> {
    let direction =
        |end: &LinkFrame, e: &Vector3<f64>| BodyDirection { body: end.body, e: end.frame.vector(e).into() };
    let (p, s) = (&closure.predecessor, &closure.successor);
    let along = |e: &Vector3<f64>| RowForm::Along(direction(p, e));
    let cosine = |e: &Vector3<f64>, b: &Vector3<f64>| RowForm::Cosine(direction(p, e), direction(s, b), size);
    let [n1, n2] = &closure.normals;
    let [first, second] = [n1, n2].map(|n| cosine(n, &closure.successor_axis));
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let orientation =
        RowForm::Orientation(axes.map(|e| direction(p, &e)), axes.map(|e| direction(s, &e)), size);
    match closure.kind {
        ClosureKind::Fixed => vec![RowForm::Point, orientation],
        ClosureKind::Prismatic => vec![along(n1), along(n2), orientation],
        ClosureKind::Revolute => vec![RowForm::Point, first, second],
        ClosureKind::Cylindrical => vec![along(n1), along(n2), first, second],
        ClosureKind::Universal => vec![RowForm::Point, cosine(&closure.axis, &closure.axis2)],
        ClosureKind::Planar => vec![along(&closure.axis), first, second],
        ClosureKind::Spherical => vec![RowForm::Point],
        ClosureKind::Distance => vec![RowForm::Distance(closure.distance)],
    }
}

/// Length of each coordinate, m: from its group, otherwise from the mechanism.
fn lengths(model: &Model) -> Vec<f64> {
    let size = model.mechanism.characteristic_length();
    let mut lengths: Vec<f64> =
        model.coordinates.iter().map(|c| if c.turns && size > 0.0 { size } else { 1.0 }).collect();
    for group in &model.groups {
        group.coordinates.iter().zip(&group.lengths).for_each(|(&c, length)| lengths[c] = *length);
    }
    lengths
}

/// Smallest length (m) of the coordinates that are rotations; infinite if there is none.
fn shortest(model: &Model, lengths: &[f64]) -> f64 {
    let turns = model.coordinates.iter().zip(lengths).filter(|(c, _)| c.turns).map(|(_, length)| *length);
    turns.fold(f64::INFINITY, f64::min)
}
