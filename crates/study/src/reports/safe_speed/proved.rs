//! Speed that is proved over ranges of joints, along rows of positions, and over the surface of a link.

use super::patches::Patch;
use super::speed::{SpeedRecord, mass_unknown};
use crate::evaluation::certificate::ExtremesCertificateRecord;
use crate::evaluation::joint_ranges::{prove_over, range_proof, wide_ranges};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::question::errors::question_error::StudyError;
use crate::question::tables::extremes::{DEFAULT_BOXES, ExtremesQuestion};
use crate::question::tables::safe_speed::SafeSpeedQuestion;
use percuss_contact::{ContactLawError, SafeSpeed};
use percuss_dynamics::{Contact, EffectiveMass, RangeProof};
use percuss_impact::JointRange;
use percuss_mechanism::{JointId, JointKind};
use schemars::JsonSchema;
use serde::Serialize;

/// Positions at which the standard's mass is compared with m̄.
const SAMPLES: usize = 500;
/// Largest number of segments times parts of a proof, which takes minutes.
const MOST_PROOFS: usize = 100_000;
/// Boxes of all segments and parts of a proof: about a minute.
const ALL_BOXES: u32 = 1_000_000;
/// Fewest boxes of a part in a segment.
const LEAST_BOXES: u32 = 64;

/// Speed that holds for all positions in ranges of joints, for rigid links, ideal joints, and the numbers of the model as read.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProvedSpeedRecord {
    /// Speed for the upper bound of m̄, and for an immovable robot if no bound is proved; null without a certificate.
    pub speed: Option<SpeedRecord>,
    /// True if the bounds of the largest m̄ agree within the tolerance; otherwise the speed is lower than necessary.
    pub is_sharp: bool,
    /// Part of the surface with the largest bound, of the shapes that are read: boxes, spheres, cylinders, capsules and meshes; null for the
    /// contact of the question.
    pub surface: Option<ProvedPatchRecord>,
    /// Number of segments between rows of positions; null for ranges.
    pub segments: Option<usize>,
    /// Segment with the largest bound, from 0, from the row of this number to the next one; null for ranges.
    pub slowest_segment: Option<usize>,
    /// Share of the positions at which the standard's mass is too small: m̄ of the given normal and point at sampled positions of the ranges, or
    /// segments with a proved larger m̄. From 0 to 1; null without an answer.
    pub share_above_standard: Option<f64>,
    /// Proved bounds of the largest m̄ over the ranges, or over the segment and the part of the surface with the largest bound.
    pub certificate: ExtremesCertificateRecord,
}

/// Part of the surface of a link with the largest bound of m̄.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProvedPatchRecord {
    /// The link.
    pub link: String,
    /// Number of parts of the surface.
    pub patches: usize,
    /// First point of the part in the frame of the link, m: on the axis of a curved part.
    pub point: [f64; 3],
    /// Outward normal of a flat part; axis of a curved part.
    pub normal: [f64; 3],
    /// Edges of the part from the point, m; the radius of a disc, the length of a cylinder.
    pub edges: Vec<[f64; 3]>,
    /// True for a part of a sphere or a cylinder.
    pub is_curved: bool,
}

/// Speed for the upper bound of the largest m̄ over the ranges.
pub(super) fn proved_speed(
    evaluated: &EvaluatedQuestion,
    asked: &SafeSpeedQuestion,
    by_standard: f64,
    speed: &impl Fn(Option<f64>) -> Result<(SpeedRecord, Option<SafeSpeed>), ContactLawError>,
) -> Result<ProvedSpeedRecord, StudyError> {
    let (prepared, pose) = (&evaluated.prepared, &evaluated.pose);
    let patches = surface_patches(evaluated, asked)?;
    let question = proof_question(asked, 1, patches.len())?;
    let of_field = |field| if field == "extremes.range" { "safe_speed.range" } else { field };
    let ranges = wide_ranges(prepared, pose, &question).map_err(|error| error.with_field(of_field))?;
    let largest = prove_largest(evaluated, &ranges, &question, &patches)?;
    let share = share_above(evaluated, &ranges, by_standard);
    proved_record(largest, None, share, speed)
}

/// Question of the proof of a speed over segments and parts of a surface.
///
/// # Errors
/// [`StudyError`]: too many proofs.
fn proof_question(
    asked: &SafeSpeedQuestion,
    segments: usize,
    patches: usize,
) -> Result<ExtremesQuestion, StudyError> {
    let proofs = segments.saturating_mul(patches.max(1));
    if proofs > MOST_PROOFS {
        let parts =
            if patches > 0 { format!(" of {patches} parts of a surface each") } else { String::new() };
        let why = format!(
            "expected at most {MOST_PROOFS} proofs; {segments} segments{parts} are given: give fewer rows, or a simpler shape"
        );
        return Err(StudyError::input("safe_speed.certify", why));
    }
    Ok(ExtremesQuestion {
        range: asked.range.clone(),
        certify: asked.certify,
        normals: asked.normals,
        edge: asked.edge.clone(),
        boxes: Some((ALL_BOXES / proofs as u32).clamp(LEAST_BOXES, DEFAULT_BOXES)),
        ..ExtremesQuestion::default()
    })
}

/// Largest m̄ over ranges, and over the parts of a surface.
struct Largest {
    /// Upper bound, kg; infinite without one.
    upper: f64,
    /// Largest proved value, kg.
    lower: f64,
    /// Certificate of the part with the largest bound.
    certificate: ExtremesCertificateRecord,
    surface: Option<ProvedPatchRecord>,
}

impl Largest {
    /// True if the bounds agree within the tolerance and the roundings of both.
    fn is_sharp(&self) -> bool {
        self.upper <= self.lower * (1.0 + 1.01 * self.certificate.tolerance)
    }
}

/// Proves the largest m̄ over ranges: of the contact of the question, or of all parts of a surface. A part whose m̄ is proved to be below the
/// value of another part is not divided further. The upper bound is the largest of all parts.
fn prove_largest(
    evaluated: &EvaluatedQuestion,
    ranges: &[JointRange],
    question: &ExtremesQuestion,
    patches: &[Patch],
) -> Result<Largest, StudyError> {
    let (prepared, pose, contact) = (&evaluated.prepared, &evaluated.pose, &evaluated.contact);
    let proof = RangeProof { only_largest: true, ..range_proof(question) };
    let prove = |contact: &Contact, proof| prove_over(prepared, pose, contact, ranges, question, proof);
    let ends = |found: &ExtremesCertificateRecord| {
        let (lower, upper) = found.most.as_ref().map_or((None, None), |most| (most.lower, most.upper));
        (lower.unwrap_or(0.0), upper.unwrap_or(f64::INFINITY))
    };
    if patches.is_empty() {
        let certificate = prove(contact, proof)?;
        let (lower, upper) = ends(&certificate);
        return Ok(Largest { upper, lower, certificate, surface: None });
    }
    let (mut known, mut worst, mut others) = (0.0_f64, (f64::NEG_INFINITY, &patches[0]), 0.0_f64);
    for patch in patches {
        let found = prove(&patch.contact(contact), patch.proof(RangeProof { known, ..proof }))?;
        let (lower, upper) = ends(&found);
        known = known.max(lower);
        others = others.max(upper.min(worst.0));
        if upper > worst.0 {
            worst = (upper, patch);
        }
        // No part has a larger bound.
        if upper.is_infinite() {
            break;
        }
    }
    // The certificate of the part does not depend on other parts.
    let (bound, patch) = worst;
    let certificate = prove(&patch.contact(contact), patch.proof(proof))?;
    let upper = if bound.is_infinite() { bound } else { others.max(ends(&certificate).1) };
    let surface = ProvedPatchRecord {
        link: prepared.model.mechanism.link(contact.link).name().to_owned(),
        patches: patches.len(),
        point: patch.point.into(),
        normal: patch.normal.into(),
        edges: patch.edges.iter().filter(|edge| edge.norm() > 0.0).map(|edge| (*edge).into()).collect(),
        is_curved: patch.cone[1] > 0.0,
    };
    Ok(Largest { upper, lower: known.max(ends(&certificate).0), certificate, surface: Some(surface) })
}

/// Parts of the surface of the question; none without a surface.
fn surface_patches(
    evaluated: &EvaluatedQuestion,
    asked: &SafeSpeedQuestion,
) -> Result<Vec<Patch>, StudyError> {
    if !asked.surface {
        return Ok(Vec::new());
    }
    let (model, pose, contact) = (evaluated.prepared.model, &evaluated.pose, &evaluated.contact);
    let mut patches =
        Patch::of_link(model, contact.link).map_err(|why| StudyError::input("safe_speed.surface", why))?;
    // A large m̄ first: the other parts then need few boxes.
    let mass = |patch: &Patch| {
        let found = pose.respond(&patch.contact(contact)).map(|response| response.effective_mass);
        found.map_or(0.0, |mass| mass.kilograms().unwrap_or(f64::INFINITY))
    };
    patches.sort_by_cached_key(|patch| std::cmp::Reverse(mass(patch).to_bits()));
    Ok(patches)
}

fn proved_record(
    largest: Largest,
    segment: Option<(usize, usize)>,
    share_above_standard: Option<f64>,
    speed: &impl Fn(Option<f64>) -> Result<(SpeedRecord, Option<SafeSpeed>), ContactLawError>,
) -> Result<ProvedSpeedRecord, StudyError> {
    let is_sharp = largest.is_sharp();
    let Largest { upper, certificate, surface, .. } = largest;
    let mass = Some(upper).filter(|upper| upper.is_finite());
    let record = certificate.reason.is_none().then(|| speed(mass).map(|(speed, _)| speed)).transpose()?;
    Ok(ProvedSpeedRecord {
        speed: record,
        is_sharp,
        surface,
        segments: segment.map(|(count, _)| count),
        slowest_segment: segment.map(|(_, slowest)| slowest),
        share_above_standard,
        certificate,
    })
}

/// Share of sampled positions in the ranges at which m̄ along the given normal is larger than a mass; `None` without an answer.
fn share_above(evaluated: &EvaluatedQuestion, ranges: &[JointRange], mass: f64) -> Option<f64> {
    let prepared = &evaluated.prepared;
    let (mut count, mut above) = (0, 0);
    // Additive recurrence with the powers of the root of x^(n+1) = x + 1, evenly distributed.
    let n = ranges.len() as f64;
    let root = (0..40).fold(1.5_f64, |x, _| (1.0 + x).powf(1.0 / (n + 1.0)));
    for sample in 1..=SAMPLES {
        let mut configuration = prepared.configuration.clone();
        for (k, range) in ranges.iter().enumerate() {
            let part = (sample as f64 * root.powi(-(k as i32) - 1)).fract();
            let name = prepared.model.mechanism.joint(range.joint).name();
            configuration.replace(name, &[range.lower + part * (range.upper - range.lower)]).ok()?;
        }
        let Ok(pose) = prepared.system.pose_from(&evaluated.pose, &configuration) else { continue };
        let Ok(response) = pose.respond(&prepared.contact_of_row(&evaluated.contact, &pose)) else {
            continue;
        };
        count += 1;
        above += usize::from(match response.effective_mass {
            EffectiveMass::Finite(found) => found > mass,
            EffectiveMass::Immovable => true,
            EffectiveMass::Massless => false,
        });
    }
    (count > 0).then(|| above as f64 / count as f64)
}

/// Speed for the upper bound of m̄ along rows of positions: between neighbouring rows all joints are within the box of both, widened by the
/// tracking error. The certificate is that of the segment with the largest bound.
pub(super) fn proved_along(
    evaluated: &EvaluatedQuestion,
    asked: &SafeSpeedQuestion,
    (joints, rows): (&[JointId], &[Vec<f64>]),
    by_standard: f64,
    speed: &impl Fn(Option<f64>) -> Result<(SpeedRecord, Option<SafeSpeed>), ContactLawError>,
) -> Result<ProvedSpeedRecord, StudyError> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let errors: Vec<f64> = joints
        .iter()
        .map(|joint| {
            let is_angle = mechanism.joint(*joint).kind() != JointKind::Prismatic;
            let own = asked.tracking.iter().filter(|tracking| tracking.is_angle == is_angle);
            own.map(|tracking| tracking.error).fold(0.0, f64::max)
        })
        .collect();
    let count = rows.len().saturating_sub(1).max(1);
    let patches = surface_patches(evaluated, asked)?;
    let question = proof_question(asked, count, patches.len())?;
    let (mut worst, mut above): (Option<(usize, Largest)>, usize) = (None, 0);
    let mut is_sharp = true;
    for segment in 0..count {
        let ends = [&rows[segment], rows.get(segment + 1).unwrap_or(&rows[segment])];
        let range = |(k, joint): (usize, &JointId)| {
            let (a, b) = (ends[0][k], ends[1][k]);
            JointRange { joint: *joint, lower: a.min(b) - errors[k], upper: a.max(b) + errors[k] }
        };
        let ranges: Vec<JointRange> = joints.iter().enumerate().map(range).collect();
        let found = prove_largest(evaluated, &ranges, &question, &patches)?;
        is_sharp &= found.is_sharp();
        above += usize::from(found.lower > by_standard);
        if worst.as_ref().is_none_or(|(_, largest)| found.upper > largest.upper) {
            worst = Some((segment, found));
        }
    }
    let (slowest, largest) = worst.ok_or_else(mass_unknown)?;
    let share = Some(above as f64 / count as f64);
    let record = proved_record(largest, Some((count, slowest)), share, speed)?;
    Ok(ProvedSpeedRecord { is_sharp, ..record })
}
