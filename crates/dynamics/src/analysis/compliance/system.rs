//! Matrices of a mechanism at a pose with elastic bushes.

use super::elements::{ElasticRow, ElementMotion, LinearElement};
use super::subspace::split;
use crate::analysis::pose::Pose;
use crate::dense::matrices::MatrixError;
use crate::kinematics::contact::LocatedContact;
use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use crate::model::conditions::Conditions;
use crate::tolerances::{
    COMPLIANT_COORDINATES, IMMOVABLE, INEXACT_RANK_FACTOR, LARGEST_RANK_FLOOR, RANK_FLOOR,
};
use nalgebra::{DMatrix, DVector};
use percuss_mechanism::{JointId, JointKind};
use percuss_spatial::Transform;
use std::sync::Arc;

/// Mechanism at a pose whose bushes are elastic, with a contact.
///
/// | symbol | meaning                                             | shape | unit                 |
/// |--------|-----------------------------------------------------|-------|----------------------|
/// | M      | mass matrix over the null space of the ideal rows   | m×m   | kg                   |
/// | K, C   | Σ kᵢ bᵢᵀbᵢ and Σ cᵢ bᵢᵀbᵢ over the rows of the elements | m×m   | N/m, N·s/m           |
/// | j      | closing speed of the contact                        | 1×m   | 1                    |
///
/// The positions of the rigid mechanism are those of the pose. Forces of springs and preloads at the pose act by their geometric stiffness in static
/// displacements, and after [`with_geometric_stiffness`](Self::with_geometric_stiffness).
#[derive(Clone, Debug)]
pub struct ElasticSystem {
    pub(super) model: Model,
    pub(super) kinematics: Kinematics,
    /// N: velocities of the released mechanism per coordinate z.
    pub(super) basis: DMatrix<f64>,
    pub(super) mass: DMatrix<f64>,
    pub(super) contact: DVector<f64>,
    /// True if no motion closes the gap, with all elements free.
    pub(super) is_immovable: bool,
    pub(super) located: LocatedContact,
    /// Rows of the elements over z, without ideal rows.
    pub(super) rows: Vec<ElasticRow>,
    /// Springs and dampers beside the bushes.
    pub(super) elements: Vec<LinearElement>,
    /// Threshold for singular values relative to the largest.
    pub(super) floor: f64,
}

/// Error of a mechanism with bushes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ComplianceError {
    /// A joint in place of which a bush acts is locked.
    #[error("joint \"{joint}\" is locked, and a bush acts in its place: leave out one of them")]
    LockedBush {
        /// The joint.
        joint: String,
    },
    /// A gear whose joint has no rotor, is locked, or is replaced by a bush.
    #[error("joint \"{joint}\": {why}")]
    Gear {
        /// The joint.
        joint: String,
        /// Reason and remedy.
        why: &'static str,
    },
    /// Too many coordinates.
    #[error("the mechanism with free bushes and gears has {got} coordinates; at most {most} are computed")]
    Size {
        /// Number of coordinates.
        got: usize,
        /// Largest number.
        most: usize,
    },
    /// A decomposition did not converge.
    #[error(
        "the decomposition of the constraint rows does not converge: check the masses and the stiffness of the bushes"
    )]
    Decomposition,
    /// Forces at the pose that the bushes do not carry.
    #[error(
        "the forces at the pose are not in balance: a motion without the stiffness of a bush gives way to them"
    )]
    Unbalanced,
    /// The forces at the pose make the equilibrium unstable.
    #[error(
        "the equilibrium is unstable: the forces at the pose are too large for the stiffness of the springs and bushes"
    )]
    Unstable,
    /// Invalid matrices.
    #[error(transparent)]
    Matrix(#[from] MatrixError),
}

impl ElasticSystem {
    /// Matrices at a pose. `elements`: springs and dampers that act beside the bushes; `other_mass`: mass of a free body on the other side of the
    /// contact, kg.
    ///
    /// # Errors
    /// [`ComplianceError`]: a locked joint with a bush, a mechanism that is too large.
    pub fn new(
        pose: &Pose,
        contact: &LocatedContact,
        elements: &[LinearElement],
        other_mass: Option<f64>,
    ) -> Result<Self, ComplianceError> {
        let gears = gears(pose, elements)?;
        let (model, kinematics) = released(pose, &gears)?;
        let mechanism = Arc::clone(&model.mechanism);
        let own = model.coordinates.len();
        // The rotors of the gears follow, then the body on the other side.
        let other = own + gears.len();
        let n = other + usize::from(other_mass.is_some());
        if n > COMPLIANT_COORDINATES {
            return Err(ComplianceError::Size { got: n, most: COMPLIANT_COORDINATES });
        }
        // A coordinate of unit value moves points by about 1 m.
        let length = mechanism.characteristic_length();
        let turns = |c: usize| match c.checked_sub(own) {
            None => model.coordinates[c].turns,
            Some(i) => gears.get(i).is_some_and(|gear| gear.turns),
        };
        let scale = DVector::from_fn(n, |c, _| if turns(c) { 1.0 / length } else { 1.0 });
        let extended =
            |row: &DVector<f64>| DVector::from_fn(n, |c, _| if c < own { row[c] * scale[c] } else { 0.0 });
        let mut mass = DMatrix::zeros(n, n);
        mass.view_mut((0, 0), (own, own)).copy_from(&model.mass_matrix(&kinematics));
        let mut closing = extended(&closing_row(&model, &kinematics, contact));
        if let Some(other_mass) = other_mass {
            mass[(other, other)] = other_mass;
            closing[other] = 1.0;
        }
        for (i, gear) in gears.iter().enumerate() {
            mass[(own + i, own + i)] = gear.inertia;
        }
        let mass = DMatrix::from_fn(n, n, |r, c| scale[r] * mass[(r, c)] * scale[c]);
        let mut elastic = elastic_rows(&model, &kinematics, None, elements);
        for row in &mut elastic {
            row.row = extended(&row.row);
            if let Some(i) = gears.iter().position(|gear| row.number == Some(gear.number)) {
                row.row[own + i] = -scale[own + i];
            }
        }
        let inexactness = pose.loops().map_or(0.0, |loops| loops.inexactness) / length;
        let floor = RANK_FLOOR.max(INEXACT_RANK_FACTOR * inexactness).min(LARGEST_RANK_FLOOR);
        let loops = model.constraint_matrix(&kinematics);
        let is_ideal = |row: &&ElasticRow| row.stiffness == f64::INFINITY;
        let mut ideal: Vec<DVector<f64>> =
            (0..loops.nrows()).map(|r| extended(&loops.row(r).transpose())).collect();
        ideal.extend(elastic.iter().filter(is_ideal).map(|row| row.row.clone()));
        elastic.retain(|row| !is_ideal(&row));
        let basis = split(&stacked(&ideal, n), n, floor).ok_or(ComplianceError::Decomposition)?.null;
        for row in &mut elastic {
            let before = row.row.norm();
            row.row = basis.tr_mul(&row.row);
            // A row on ideal rows alone is rounding.
            if row.row.norm() <= floor * before {
                row.row.fill(0.0);
            }
        }
        let reduced = basis.tr_mul(&closing);
        Ok(Self {
            mass: basis.tr_mul(&mass) * &basis,
            is_immovable: reduced.norm() <= IMMOVABLE * closing.norm(),
            contact: reduced,
            located: *contact,
            basis: DMatrix::from_fn(own, basis.ncols(), |r, c| scale[r] * basis[(r, c)]),
            rows: elastic,
            elements: elements.to_vec(),
            model,
            kinematics,
            floor,
        })
    }

    /// True if no motion closes the gap, with all elements free.
    pub fn is_immovable(&self) -> bool {
        self.is_immovable
    }

    /// Σ f(row) bᵀb over the rows of the elements.
    pub(super) fn sum_of_rows(&self, factor: impl Fn(&ElasticRow) -> f64) -> DMatrix<f64> {
        let m = self.contact.len();
        let mut sum = DMatrix::zeros(m, m);
        for row in &self.rows {
            let factor = factor(row);
            if factor != 0.0 {
                sum.ger(factor, &row.row, &row.row, 1.0);
            }
        }
        sum
    }

    /// Rows of the elements for which `is_wanted` is true, one below the other.
    pub(super) fn rows_where(&self, is_wanted: impl Fn(&ElasticRow) -> bool) -> DMatrix<f64> {
        let rows: Vec<DVector<f64>> =
            self.rows.iter().filter(|row| is_wanted(row)).map(|row| row.row.clone()).collect();
        stacked(&rows, self.contact.len())
    }
}

/// Closing speed of a contact per velocity of each coordinate.
pub(super) fn closing_row(model: &Model, kinematics: &Kinematics, contact: &LocatedContact) -> DVector<f64> {
    let mut row = vec![0.0; model.velocity_coordinates.len()];
    for entry in model.contact_row(kinematics, contact).entries {
        row[entry.velocity] = entry.value;
    }
    DVector::from_vec(model.reduce_vector(&row, |multiplier| multiplier))
}

/// Rows of the bushes and elements over the coordinates of the released model; `drawn`: its pose as drawn.
pub(super) fn elastic_rows(
    model: &Model,
    kinematics: &Kinematics,
    drawn: Option<&Kinematics>,
    elements: &[LinearElement],
) -> Vec<ElasticRow> {
    let bushes = model.mechanism.bushes().iter().flat_map(|bush| model.bush_rows(kinematics, drawn, bush));
    let elements = elements.iter().enumerate();
    let elements = elements.filter_map(|element| model.element_row(kinematics, element));
    bushes.chain(elements).collect()
}

/// Matrix with the given rows of length `n`.
pub(super) fn stacked(rows: &[DVector<f64>], n: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), n, |r, c| rows[r][c])
}

/// Elastic gear with its rotor.
struct Gear {
    /// Number of the element.
    number: usize,
    joint: JointId,
    /// Inertia of the rotor at the joint, kg·m² or kg.
    inertia: f64,
    /// True for a joint that turns.
    turns: bool,
}

/// Gears among the elements.
fn gears(pose: &Pose, elements: &[LinearElement]) -> Result<Vec<Gear>, ComplianceError> {
    let rigid = pose.assembly.model();
    let mechanism = &rigid.mechanism;
    let gear = |(number, element): (usize, &LinearElement)| {
        let ElementMotion::Gear(joint) = element.motion else { return None };
        let declared = mechanism.joint(joint);
        let inertia = pose.armature(joint).first().copied().unwrap_or(0.0);
        let why = if declared.kind().dofs() != 1 {
            "a gear requires a joint with one velocity"
        } else if rigid.own_locks[joint.index()] {
            "the joint is locked, so its gear has no effect: leave out one of both"
        } else if mechanism.bushes().iter().any(|bush| bush.joints().contains(&joint)) {
            "a bush acts in place of the joint: leave out its gear"
        } else if inertia <= 0.0 {
            "the joint has no rotor, so the stiffness of its gear has no effect: give the rotor inertia (armature)"
        } else {
            let turns = declared.kind() != JointKind::Prismatic;
            return Some(Ok(Gear { number, joint, inertia, turns }));
        };
        Some(Err(ComplianceError::Gear { joint: declared.name().to_owned(), why }))
    };
    elements.iter().enumerate().filter_map(gear).collect()
}

/// Model of the mechanism with free bushes and gears, under the conditions of the pose and drawn at it: without the rotors of the gears.
fn released(pose: &Pose, gears: &[Gear]) -> Result<(Model, Kinematics), ComplianceError> {
    let rigid = pose.assembly.model();
    let mechanism = &rigid.mechanism;
    let replaced = || mechanism.bushes().iter().flat_map(|bush| bush.joints());
    if let Some(joint) = replaced().find(|joint| rigid.own_locks[joint.index()]) {
        return Err(ComplianceError::LockedBush { joint: mechanism.joint(*joint).name().to_owned() });
    }
    let frame = |link| pose.kinematics.link_frame(rigid, link);
    let frames: Vec<Transform<f64>> = mechanism
        .joints()
        .iter()
        .map(|joint| frame(joint.parent()).inverse() * frame(joint.child()))
        .collect();
    let first = |joint| pose.joint(joint).first().copied().unwrap_or(0.0);
    let positions: Vec<f64> = mechanism.joint_ids().map(first).collect();
    let drawn = Arc::new(mechanism.released(&frames, &positions));
    let mut conditions = Conditions::new().base(rigid.base);
    for id in mechanism.joint_ids() {
        let joint = mechanism.joint(id);
        if rigid.own_locks[id.index()] {
            conditions = conditions.lock(joint.name());
        }
        let body = rigid.body_of_joint[id.index()].map(|body| &rigid.bodies[body]);
        let is_replaced = replaced().any(|other| *other == id);
        let has_gear = gears.iter().any(|gear| gear.joint == id);
        if let Some(body) = body.filter(|body| !is_replaced && !body.armature.is_empty()) {
            let armature = if has_gear { vec![0.0] } else { body.armature.clone() };
            conditions = conditions.armature(joint.name(), armature);
        }
    }
    for hold in &rigid.holds {
        conditions = conditions.hold(mechanism.link(hold.link).name(), hold.point, hold.normal);
    }
    // The conditions are those of a compiled model with the same names.
    let model = Model::compile(&drawn, &conditions).map_err(|_| ComplianceError::Decomposition)?;
    let kinematics = Kinematics::zero(&model);
    Ok((model, kinematics))
}
