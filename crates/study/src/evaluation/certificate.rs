//! Proved bounds of m̄ at a pose and over ranges.

use crate::evaluation::prepared_question::EvaluatedQuestion;
use percuss_dynamics::{Contact, ExtremeBracket, ExtremesCertificate, NoCertificate, Pose, RangeProof};
use percuss_impact::JointRange;
use schemars::JsonSchema;
use serde::Serialize;

/// Rows of a constraint that the proof leaves out, without a proof that the other rows imply them.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OmittedRowRecord {
    /// Name of the closure or coupling.
    pub constraint: String,
    /// Largest error of the row at the proved assembly, m or rad.
    pub residual: f64,
}

/// Proved bounds of m̄ at a pose, for rigid links, ideal joints, and the numbers of the model as read.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct MassCertificateRecord {
    /// Proved lower bound of m̄ in the unit of the report; null without a proof.
    pub lower: Option<f64>,
    /// Proved upper bound of m̄ in the unit of the report; null without a proof.
    pub upper: Option<f64>,
    /// Distance of each dependent position, rad or m, within which no other assembly exists; null for a tree.
    pub uniqueness: Option<f64>,
    /// Number of rows of the loops.
    pub rows: usize,
    /// Number of rows that are proved to be zero at all positions.
    pub implied: usize,
    /// Rows that are left out without a proof. `upper` then assumes that the loops have the mobility of the pose; `lower` holds without it.
    pub omitted: Vec<OmittedRowRecord>,
    /// Reason for no proof; null with a proof.
    pub reason: Option<String>,
}

/// Proved bounds of an extreme.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BracketRecord {
    /// Proved lower bound of the extreme, in the unit of the report; null without a proof.
    pub lower: Option<f64>,
    /// Proved upper bound of the extreme, in the unit of the report; null without a proof.
    pub upper: Option<f64>,
    /// True if the bounds agree within the tolerance.
    pub is_proved: bool,
    /// Number of evaluated boxes.
    pub boxes: usize,
    /// Positions of the ranges with the best value, rad or m; then those on the edges, m, and the angles ψ about the normal and θ from the
    /// normal of a cone, rad.
    pub positions: Vec<f64>,
    /// Division of the ranges in preorder: −1 for a box with a sufficient bound, otherwise the index of the range that is halved, then its
    /// lower half and its upper half. Empty for linkages.
    pub divisions: Vec<i32>,
}

/// Proved bounds of the extremes of m̄ over ranges, for rigid links, ideal joints, and the numbers of the model as read.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct ExtremesCertificateRecord {
    /// Wanted relative distance of the bounds.
    pub tolerance: f64,
    /// Relative tolerance t of all masses, moments of inertia and rotor inertias, each by its own factor from 1 − t to 1 + t.
    pub mass_tolerance: f64,
    /// Smallest m̄; null without a proof.
    pub least: Option<BracketRecord>,
    /// Largest m̄; null without a proof.
    pub most: Option<BracketRecord>,
    /// Upper bound of the peak force v √(k m̄) of a linear spring without damping, N; null without stiffness and speed.
    pub peak_force: Option<f64>,
    /// Number of boxes with a proved assembly; null for a tree.
    pub pieces: Option<usize>,
    /// Rows of loops that are left out without a proof.
    pub omitted: Vec<OmittedRowRecord>,
    /// Reason for no proof; null with a proof.
    pub reason: Option<String>,
    /// Numbers for an independent check; null for linkages, and for contacts or joints that the checker does not know.
    pub tree: Option<TreeRecord>,
}

/// Bodies, contact and ranges of a proof, as enclosures: pairs of a lower and an upper bound.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TreeRecord {
    /// One row per body, parents first: parent (−1: ground), motion (0 fixed, 1 hinge about z, 2 slider along z), index of the position,
    /// coordinate (−1: none), then pairs: factor and offset of the position, factor and armature of the rate, rotation (9, by rows) and
    /// translation (3) of the joint frame in the parent, mass, first moment (3), moments of inertia (9) in the body's frame.
    pub bodies: Vec<Vec<f64>>,
    /// Body, 1 for a moment, 1 for a normal fixed in the root link; then pairs: point (3), normal (3).
    pub contact: Vec<f64>,
    /// Positions of all joints.
    pub positions: Vec<[f64; 2]>,
    /// Index of the position, lower and upper end of each range, rad or m.
    pub ranges: Vec<(usize, f64, f64)>,
}

fn omitted_rows(rows: Vec<(String, f64)>) -> Vec<OmittedRowRecord> {
    let mut all: Vec<OmittedRowRecord> = Vec::new();
    for (constraint, residual) in rows {
        match all.iter_mut().find(|row| row.constraint == constraint) {
            Some(row) => row.residual = row.residual.max(residual),
            None => all.push(OmittedRowRecord { constraint, residual }),
        }
    }
    all
}

/// Proved bounds of m̄ of an evaluated contact.
pub(crate) fn mass_certificate(evaluated: &EvaluatedQuestion) -> MassCertificateRecord {
    if evaluated.prepared.other_mass().is_some() {
        let reason = "a free body on the other side is not supported by the proof".to_owned();
        return MassCertificateRecord { reason: Some(reason), ..MassCertificateRecord::default() };
    }
    match evaluated.pose.certify(&evaluated.contact) {
        Ok(proved) => MassCertificateRecord {
            lower: Some(proved.lower),
            upper: Some(proved.upper),
            uniqueness: proved.uniqueness,
            rows: proved.rows,
            implied: proved.implied,
            omitted: omitted_rows(proved.omitted),
            reason: None,
        },
        Err(why) => {
            MassCertificateRecord { reason: Some(why.to_string()), ..MassCertificateRecord::default() }
        }
    }
}

/// True for a WebAssembly module of a page, which has no proofs: they would enlarge it by a twentieth.
const IS_MODULE_OF_PAGE: bool = cfg!(all(target_arch = "wasm32", target_os = "unknown"));

/// Proved bounds of the extremes over ranges, at a pose of the branch.
pub(crate) fn extremes_certificate(
    pose: &Pose,
    contact: &Contact,
    ranges: &[JointRange],
    proof: RangeProof,
) -> ExtremesCertificateRecord {
    let given: Vec<_> = ranges.iter().map(|range| (range.joint, range.lower, range.upper)).collect();
    let none = ExtremesCertificateRecord {
        tolerance: proof.tolerance,
        mass_tolerance: proof.mass_tolerance,
        ..ExtremesCertificateRecord::default()
    };
    if IS_MODULE_OF_PAGE {
        let reason = "the module of a page has no proofs; the command has".to_owned();
        return ExtremesCertificateRecord { reason: Some(reason), ..none };
    }
    let without =
        |why: NoCertificate| ExtremesCertificateRecord { reason: Some(why.to_string()), ..none.clone() };
    let bracket = |found: ExtremeBracket| BracketRecord {
        lower: (found.lower > 0.0).then_some(found.lower),
        upper: found.upper.is_finite().then_some(found.upper),
        is_proved: found.is_proved,
        boxes: found.boxes,
        positions: found.positions,
        divisions: found.divisions,
    };
    match pose.certify_extremes(contact, &given, proof) {
        Err(why) => without(why),
        Ok(ExtremesCertificate { branch: Some(branch), .. }) if !branch.is_one_branch => {
            without(NoCertificate::NotClosed)
        }
        Ok(ExtremesCertificate { least, most, branch, tree }) => ExtremesCertificateRecord {
            least: least.map(bracket),
            most: Some(bracket(most)),
            pieces: branch.as_ref().map(|branch| branch.pieces),
            omitted: branch.map_or_else(Vec::new, |branch| omitted_rows(branch.omitted)),
            tree: tree.map(|tree| TreeRecord {
                bodies: tree.bodies,
                contact: tree.contact,
                positions: tree.positions,
                ranges: tree.ranges,
            }),
            ..none
        },
    }
}
