//! Findings about poses and responses for programs that use the library directly; the reports list the same
//! findings.

use crate::checks::finding::{Finding, FindingTally};
use crate::checks::finding_kind::FindingKind;
use crate::checks::findings::{collect_pose_findings, collect_response_findings, singular_pose_finding};
use crate::model::record::DiagnosticRecord;
use crate::question::names::Names;
use percuss_dynamics::{Contact, ContactResponse, Pose, RemarkFlags, System};

/// Findings about a pose: joints outside their limits, closure of the loops, rank of the constraint rows.
pub fn pose_findings(system: &System, pose: &Pose) -> Vec<DiagnosticRecord> {
    collect_pose_findings(system, pose, Names::Fields).into_iter().map(DiagnosticRecord::from).collect()
}

/// Findings about a contact response and its [pose](pose_findings). At a singular pose the branches are
/// followed to find the limits of m̄.
pub fn response_findings(
    system: &System,
    pose: &Pose,
    contact: &Contact,
    response: &ContactResponse,
) -> Vec<DiagnosticRecord> {
    let mut findings = collect_pose_findings(system, pose, Names::Fields);
    findings.extend(collect_response_findings(system, contact, response, Names::Fields));
    if response.singular_pose {
        findings.extend(singular_pose_finding(pose, response, &pose.branch_limits(contact)));
    }
    findings.into_iter().map(DiagnosticRecord::from).collect()
}

/// Kind of the finding and text for every kind of remark about a row.
const REMARKS: [(RemarkFlags, FindingKind, &str); 24] = {
    use FindingKind as Kind;
    use RemarkFlags as Flags;
    [
        (
            Flags::NEARLY_IMMOVABLE,
            Kind::NearlyImmovable,
            "the gap hardly closes: the effective mass is large and uncertain",
        ),
        (
            Flags::MASSLESS_MOTIONS,
            Kind::MasslessMotions,
            "motions of the mechanism move no mass; they do not affect the result",
        ),
        (
            Flags::MASSLESS_TO_ROUNDING,
            Kind::MasslessToRounding,
            "massless to rounding only: the error of the row is the largest possible effective mass",
        ),
        (
            Flags::UNDETERMINED_MOTION,
            Kind::UndeterminedMotion,
            "a motion without mass leaves some velocities of the contact response undetermined",
        ),
        (
            Flags::UNCLEAR_RANK,
            Kind::UnclearRankHere,
            "the rank of the constraints is unclear at this pose: it is close to a change point",
        ),
        (
            Flags::INDEFINITE_MASS_MATRIX,
            Kind::IndefiniteMassMatrix,
            "the mass matrix has negative directions: the value is stationary, not a minimum",
        ),
        (
            Flags::SINGULAR_POSE,
            Kind::SingularPose,
            "branches cross at this pose, and the value is a lower bound",
        ),
        (
            Flags::OTHER_ASSEMBLY,
            Kind::OtherAssembly,
            "the pose is on another assembly mode than the first closed pose",
        ),
        (
            Flags::DRAWN_OPEN,
            Kind::DrawnOpen,
            "a loop is open in the design position by more than a hundredth of its size: is a point mistyped?",
        ),
        (
            Flags::INEXACT_LOOPS,
            Kind::InexactLoops,
            "the file's loops are inexact and closed in least squares: are its angles rounded (1.5708)?",
        ),
        (
            Flags::DRIVER_OFF_ZERO,
            Kind::DriverOffZero,
            "a driving joint was not set, and its position 0 is out of reach",
        ),
        (
            Flags::OFF_TARGET,
            Kind::OffTarget,
            "a joint was set to more numbers than its loops leave degrees of freedom",
        ),
        (Flags::OUTSIDE_LIMITS, Kind::OutsideLimits, "a joint is outside its limits"),
        (
            Flags::WEAKLY_CONSTRAINED,
            Kind::WeaklyConstrained,
            "the mechanism is weakly constrained: rounded figures of the file can free one more motion",
        ),
        (
            Flags::UNCLEAR_MOBILITY,
            Kind::UnclearRank,
            "the rank of the constraints is unclear: the mobility may differ",
        ),
        (
            Flags::BASE_NOT_GIVEN,
            Kind::BaseNotGiven,
            "the normal is given in the world and the base floats, but the pose of the base was not given: the root link \
             is taken to be at the world's origin",
        ),
        (Flags::NOT_FINITE, Kind::NotFinite, "no result: a position is not a finite number"),
        (
            Flags::NOT_UNIT_QUATERNION,
            Kind::NotUnitQuaternion,
            "no result: a quaternion is not of unit length",
        ),
        (
            Flags::OPEN_LOOPS,
            Kind::OpenLoops,
            "no result: the loops are open at the given positions; expected the positions of a pose",
        ),
        (Flags::NO_ANSWER, Kind::NoAnswer, "no result: the pose does not exist, or no route solves it"),
        (
            Flags::UNCERTAIN_MASS,
            Kind::UncertainMass,
            "the effective mass has a relative error above 1e-6, and no gradient: the pose is close to a singular one, or the \
             mass matrix is nearly singular",
        ),
        (
            Flags::UNKNOWN_ERROR,
            Kind::UnknownError,
            "the error of the effective mass is not computed for this row; the result at a pose states it",
        ),
        (
            Flags::OPEN_GAP,
            Kind::OpenGap,
            "the contact does not touch at this pose: an impact occurs at the touch, where the effective mass may differ",
        ),
        (
            Flags::MANY_TURNS,
            Kind::ManyTurns,
            "a joint outside its limits is more than a turn from 0; positions are in rad: are these numbers degrees?",
        ),
    ]
};

/// Findings about the rows of a batch or a path, one per kind of remark, with the first row (from 0) and the number of
/// further rows. `no_answer`: reason of the first row without a result, if known.
pub fn row_findings(
    rows: impl IntoIterator<Item = RemarkFlags>,
    no_answer: Option<&str>,
) -> Vec<DiagnosticRecord> {
    let (tally, count) = tally_remarks(rows, |flag, text| match no_answer {
        Some(reason) if flag == RemarkFlags::NO_ANSWER => format!("no result: {reason}"),
        _ => text.to_owned(),
    });
    tally.into_records(count).collect()
}

/// Findings about a batch of results of [`effective_mass`](percuss_dynamics::effective_mass), one per kind of remark,
/// with the number of the first problem (from 0) and of further problems. `small_rows`: numbers of the problems with
/// [small rows](percuss_dynamics::ConstraintRank::small_rows), ascending.
pub fn matrix_findings(
    problems: impl IntoIterator<Item = RemarkFlags>,
    small_rows: &[usize],
) -> Vec<DiagnosticRecord> {
    let (mut tally, count) = tally_remarks(problems, |flag, usual| {
        let text = match flag {
            RemarkFlags::MASSLESS_TO_ROUNDING => {
                "massless to rounding only: M may contain a mass below the rounding of larger masses"
            }
            RemarkFlags::UNCLEAR_RANK => {
                "the rank of A is unclear, so no error is stated: a singular value of A is close to the limit of rank_floor"
            }
            _ => usual,
        };
        text.to_owned()
    });
    if let Some(first) = small_rows.first() {
        let text = "rows of A count and are below the rounding of others: small units, or rounding to be excluded \
                    by row_noise";
        let finding = Finding::about_result(FindingKind::SmallRows, text);
        tally.add_repeated(*first, small_rows.len(), &[finding]);
    }
    tally.into_records_of(count, "number").collect()
}

/// Findings of all rows and the number of rows. `text` gets the flag and the usual text of each kind of remark.
fn tally_remarks(
    rows: impl IntoIterator<Item = RemarkFlags>,
    text: impl Fn(RemarkFlags, &str) -> String,
) -> (FindingTally, usize) {
    let mut occurrences = [(0, 0); REMARKS.len()];
    let mut count = 0;
    for (row, flags) in rows.into_iter().enumerate() {
        count = row + 1;
        if flags.is_empty() {
            continue;
        }
        for ((flag, ..), (first, rows)) in REMARKS.iter().zip(&mut occurrences) {
            if flags.contains(*flag) {
                *first = if *rows == 0 { row } else { *first };
                *rows += 1;
            }
        }
    }
    let mut tally = FindingTally::default();
    for ((flag, kind, usual), (first, rows)) in REMARKS.iter().zip(occurrences) {
        if rows == 0 {
            continue;
        }
        let text = text(*flag, usual);
        let finding = Finding::about_result(*kind, text);
        tally.add_repeated(first, rows, &[finding]);
    }
    (tally, count)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every flag has a finding of its own, which names its first row and counts the others.
    #[test]
    fn every_flag_is_a_finding() {
        let all: u32 = REMARKS.iter().fold(0, |all, (flag, ..)| {
            assert_eq!(flag.bits().count_ones(), 1);
            assert_eq!(all & flag.bits(), 0);
            all | flag.bits()
        });
        assert_eq!(all, (1 << REMARKS.len()) - 1);
        let rows = [0, all, 0, all].map(RemarkFlags::from_bits);
        let found = row_findings(rows, Some("out of reach"));
        assert_eq!(found.len(), REMARKS.len());
        assert!(found.iter().all(|record| record.message.ends_with(" (row 1, and 1 more)")));
        let no_answer = found.iter().find(|record| record.code == FindingKind::NoAnswer.code());
        assert!(no_answer.is_some_and(|r| r.message == "no result: out of reach (row 1, and 1 more)"));
        assert!(row_findings([RemarkFlags::NONE; 3], None).is_empty());
    }

    /// Findings of a batch of matrices count problems, and do not refer to the pose or to the error of a row.
    #[test]
    fn matrices_have_texts_of_their_own() {
        let problems = [RemarkFlags::NONE, RemarkFlags::MASSLESS_TO_ROUNDING, RemarkFlags::MASSLESS_MOTIONS];
        let found = matrix_findings(problems, &[0, 2]);
        let lines: Vec<String> = found.iter().map(DiagnosticRecord::line).collect();
        assert_eq!(
            found.iter().map(|record| record.code).collect::<Vec<_>>(),
            ["massless-motions", "massless-to-rounding", "small-rows"]
        );
        assert!(lines[0].starts_with("note: ") && lines[0].ends_with(" (number 2)"), "{lines:?}");
        assert!(lines[1].contains("M may contain a mass") && lines[1].ends_with(" (number 1)"), "{lines:?}");
        assert!(lines[2].ends_with(" (number 0, and 1 more)"), "{lines:?}");
        assert!(matrix_findings([RemarkFlags::NONE; 3], &[]).is_empty());
    }
}
