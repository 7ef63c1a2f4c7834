//! Extreme effective masses over ranges of joint positions and along paths.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::{FindingKind, FindingScope};
use crate::checks::joint_limits::many_turns_finding;
use crate::damper::damping::damper;
use crate::evaluation::certificate::ExtremesCertificateRecord;
use crate::evaluation::joint_ranges::{find_joint, prove, ranges, search_error};
use crate::evaluation::named_contact::findings_at_touch;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::evaluation::status::{Status, mass_unit};
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::row_source::RowSource;
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::extremes::{
    DEFAULT_STARTS, ExtremesQuestion, GivenEdge, GivenQuantity, Keep, MOST_STARTS,
};
use crate::question::travel::varied_values::PathPlace;
use crate::reports::impact::additions::find_bearing;
use crate::sweep::sweep_rows::Sweep;
use nalgebra::Vector3;
use percuss_dynamics::{Contact, Direction, Frame, Gap, Pose};
use percuss_impact::{
    DriverPath, ExtremeKind, ExtremeMass, ExtremeOnPath, JointRange, KeptPoint, NormalRange, PeakForceLaw,
    ReactionMap, SearchedContact, SearchedPoses, SearchedQuantity, driving_joints, extreme_along_path,
    extreme_quantity,
};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Message: a peak force in a bearing without a contact law, or another quantity with one.
const PEAK_AND_LAW: &str = "expected a contact law (stiffness, restitution and closing speed) for the peak force in a bearing, peak:JOINT, and for \
                            no other quantity";

/// Position of a joint at an extreme.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExtremePosition {
    /// The joint.
    pub joint: String,
    /// Position, rad or m.
    pub position: f64,
    /// `lower` or `upper` if the extreme is at an end of the range; null otherwise.
    pub limit: Option<&'static str>,
}

/// Extreme of the searched quantity.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExtremeRecord {
    /// Effective mass in the unit of the report; null if it is not finite or if another quantity is searched.
    pub effective_mass: Option<f64>,
    /// Value of the quantity in the unit of the report; null if not finite.
    pub value: Option<f64>,
    /// Kind of the value; `immovable` is a valid largest value of a mass or an inertia. The largest impulse or peak
    /// force in a bearing is `immovable` if it grows without bound towards these positions, at which the contact is immovable.
    pub status: Status,
    /// Positions of the varied joints.
    pub positions: Vec<ExtremePosition>,
    /// Gap of a stop at these positions, m: the stop is open if it is positive, and pressed if negative; null for other contacts.
    pub gap: Option<f64>,
    /// Fractional row number on the path, from 0: 2.25 is a quarter of the way from row 2 to row 3; null without a path.
    pub row: Option<f64>,
    /// Value of the varied number of the path at the extreme; null without a path, and for a path with several varied numbers.
    pub place: Option<PathPlace>,
    /// Largest error of a coordinate of a kept point, m; null without kept points.
    pub kept_error: Option<f64>,
    /// Normal (for a moment: axis) at the extreme, world axes, up to its sign; null if the search uses the normal of the contact.
    pub normal_world: Option<[f64; 3]>,
    /// Contact point at the extreme in the frame of the contact link, m; null without edges.
    pub point_link: Option<[f64; 3]>,
    /// Largest component of the projected gradient times its range, relative to the value (for a bearing, of the square of
    /// the impulse): zero at an exact optimum.
    pub residual: f64,
    /// Number of starts that reached this value to six digits.
    pub agreeing: usize,
    /// Number of starts that were searched; on a path the number of local searches.
    pub starts: usize,
    /// True if the limit of work ended the search before all starts were searched: the value is the best one found.
    pub is_stopped: bool,
}

/// Link or point that stays in place.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct KeptRecord {
    /// The link.
    pub link: String,
    /// The point in the frame of the link, m; null for the position and the orientation of the link.
    pub point: Option<[f64; 3]>,
    /// Direction (world axes) along which the coordinate of the point is kept; null for all directions.
    pub normal: Option<[f64; 3]>,
}

/// Path of a search.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PathRecord {
    /// Moved joints.
    pub joints: Vec<String>,
    /// Number of rows.
    pub rows: usize,
    /// Number of rows whose pose is not reachable; a straight line joins the rows before and after them.
    pub unreached: usize,
}

/// Report of `percuss extremes`, as JSON.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExtremesReport {
    /// `percuss.extremes/1`.
    #[schemars(extend("const" = "percuss.extremes/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Quantity: `effective_mass`, `reflected_inertia`, `held_inertia`, `bearing_impulse` (impulse in the bearing per closing speed of a
    /// plastic impact) or `bearing_peak_force` (peak force in the bearing with the contact law).
    pub quantity: &'static str,
    /// True for a moment about an axis, and for the stop of a revolute joint: closing speeds in rad/s.
    pub is_moment: bool,
    /// Joint or bearing of the quantity: name of a joint or of a closure, or `ground`; null for the effective mass.
    pub joint: Option<String>,
    /// Unit of the values: `kg` or `kg·m²`; `kg·m` for the impulse in a bearing per closing speed of a moment; `N` for a peak force.
    pub unit: &'static str,
    /// Ranges of the varied joints: joint, lower and upper end, rad or m; empty for a path.
    pub ranges: Vec<(String, f64, f64)>,
    /// Largest angle between the normals and that of the contact, rad; null without a cone.
    pub cone: Option<f64>,
    /// Edges of the patch of contact points, in the frame of the contact link, m.
    pub edges: Vec<[f64; 3]>,
    /// Links and points that stay in place over the ranges.
    pub kept: Vec<KeptRecord>,
    /// Path; null for ranges.
    pub path: Option<PathRecord>,
    /// Driving joints that do not vary, with their positions, rad or m.
    pub held: Vec<(String, Vec<f64>)>,
    /// Number of starts; on a path the number of local searches, the larger one of both extremes.
    pub starts: usize,
    /// Smallest value of the quantity.
    pub least: ExtremeRecord,
    /// Largest value of the quantity.
    pub most: ExtremeRecord,
    /// Proved bounds of the extremes; null without `certify`.
    pub certificate: Option<ExtremesCertificateRecord>,
    /// Findings about the ranges, or about the rows of the path.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Extreme, with its row and its place on a path.
type OnPath = (ExtremeMass, Option<(f64, Option<PathPlace>)>);

/// Found extremes with the joints of their positions.
struct Found {
    /// Ranges; empty for a path.
    ranges: Vec<JointRange>,
    joints: Vec<JointId>,
    path: Option<PathRecord>,
    /// Number of starts of a search over ranges.
    starts: Option<usize>,
    /// Smallest and largest value, with the place on the path.
    extremes: [OnPath; 2],
    diagnostics: Vec<DiagnosticRecord>,
}

/// Search for the extremes of a question.
struct ExtremesSearch<'a> {
    prepared: &'a PreparedQuestion<'a>,
    pose: &'a Pose,
    contact: SearchedContact<'a>,
    quantity: SearchedQuantity,
    question: &'a ExtremesQuestion,
}

/// Smallest and largest effective mass of a contact, or another quantity, over ranges of its driving joints, over the self-motion with kept
/// links or points, or along a path.
///
/// # Errors
/// [`StudyError`], as for [`mass`](crate::mass()); an invalid range; a joint that does not drive; a joint with a position and a
/// range; kept points that leave no motion; a path together with ranges or kept points, and errors of its rows as for
/// [`sweep`](crate::sweep()).
pub fn extremes(
    model: &Model,
    question: &MassQuestion,
    extremes: &ExtremesQuestion,
) -> Result<ExtremesReport, StudyError> {
    extremes.check_ignored()?;
    let path = extremes.rows();
    let of_rows = path.as_ref().map(|path| path.question_of_rows(question));
    let question = of_rows.as_ref().unwrap_or(question);
    let prepared = PreparedQuestion::new(model, question)?;
    if prepared.other_mass().is_some() {
        let why = "extremes are those of the mechanism alone; expected no free body on the other side";
        return Err(StudyError::input("contact.against_mass", why));
    }
    let pose = prepared.pose()?;
    let contact = prepared.contact_at(&pose);
    let is_moment = contact.normal.is_moment();
    let law = extremes.contact_law().filter(|_| extremes.certify.is_none());
    if let Some(law) = &law {
        law.check_dimensions("extremes.stiffness", "extremes.speed", is_moment)?;
    }
    let requested = extremes.quantity();
    let (quantity, unit) = searched_quantity(requested, &model.mechanism, is_moment, law.as_ref())?;
    let edges: Vec<Vector3<f64>> = extremes.edge.iter().map(|GivenEdge(edge)| (*edge).into()).collect();
    let search = ExtremesSearch {
        prepared: &prepared,
        pose: &pose,
        contact: SearchedContact {
            contact: &contact,
            wheel: prepared.wheel(),
            normals: extremes.normals.unwrap_or_default().0,
            edges: &edges,
        },
        quantity,
        question: extremes,
    };
    let found = match &path {
        None => search.over_ranges()?,
        Some(path) => search.along_path(question, path)?,
    };
    let mechanism = &model.mechanism;
    let named = prepared.question.named_contact(mechanism)?;
    let gap = named.and_then(|named| Gap::new(&pose, named));
    let pose_at = |extreme: &ExtremeMass| {
        let mut configuration = prepared.configuration.clone();
        for (joint, position) in found.joints.iter().zip(&extreme.positions) {
            configuration.replace(mechanism.joint(*joint).name(), &[*position]).ok()?;
        }
        prepared.system.pose_from(&pose, &configuration).ok()
    };
    let gap_at = |extreme: &ExtremeMass| Some(gap.as_ref()?.at(&pose_at(extreme)?));
    // Positions of the varied joints at the start are no result.
    let of_range = |finding: &Finding| {
        matches!(finding.subject(), FindingSubject::Joint(joint) if found.joints.contains(joint))
            && finding.kind().scope() == FindingScope::Positions
    };
    let mut findings = prepared.start_findings(&pose, &contact);
    findings.extend(findings_at_touch(model, question));
    findings.retain(|finding| !of_range(finding));
    for (value, (extreme, _)) in ["smallest", "largest"].into_iter().zip(&found.extremes) {
        let is_of_contact =
            matches!(quantity, SearchedQuantity::EffectiveMass | SearchedQuantity::BearingImpulse { .. });
        let there = pose_at(extreme).filter(|_| is_of_contact);
        let result = there.and_then(|there| {
            let own = prepared.contact_of_row(&contact, &there);
            let normal = match extreme.normal_world {
                Some(axis) if is_moment => Direction::About(axis, Frame::World),
                Some(normal) => Direction::Along(normal, Frame::World),
                None => own.normal,
            };
            let point = extreme.point_link.unwrap_or(own.point);
            prepared.evaluate(&there, &Contact { point, normal, ..own }).ok()
        });
        let of_pose = result.into_iter().flat_map(|result| result.findings);
        let of_pose = of_pose.filter(|finding| finding.kind().scope() == FindingScope::Pose);
        findings.extend(of_pose.map(|finding| finding.with_place(&format!("at the {value} value"))));
    }
    let name = |joint: JointId| mechanism.joint(joint).name().to_owned();
    let record = |(extreme, at): &OnPath| {
        let (status, value) = Status::classify(extreme.effective_mass);
        let position = |(joint, position): (&JointId, &f64)| {
            let limit = extreme.active_limits.iter().find(|(limited, _)| limited == joint);
            ExtremePosition {
                joint: name(*joint),
                position: *position,
                limit: limit.map(|(_, is_upper)| if *is_upper { "upper" } else { "lower" }),
            }
        };
        ExtremeRecord {
            effective_mass: value.filter(|_| quantity == SearchedQuantity::EffectiveMass),
            value,
            status,
            positions: found.joints.iter().zip(&extreme.positions).map(position).collect(),
            gap: gap_at(extreme),
            row: at.as_ref().map(|(row, _)| *row),
            place: at.as_ref().and_then(|(_, place)| place.clone()),
            kept_error: (!extremes.keep.is_empty()).then_some(extreme.kept_error),
            normal_world: extreme.normal_world.map(Into::into),
            point_link: extreme.point_link.map(Into::into),
            residual: extreme.residual,
            agreeing: extreme.agreeing,
            starts: extreme.starts,
            is_stopped: extreme.is_stopped,
        }
    };
    let [least, most] = &found.extremes;
    let bearing = requested.joint().unwrap_or_default();
    let is_told = |record: &DiagnosticRecord| found.diagnostics.iter().any(|told| told.code == record.code);
    let of_start = findings.into_iter().map(DiagnosticRecord::from).filter(|record| !is_told(record));
    let of_start = of_start.collect::<Vec<_>>();
    let open_components = open_components(&pose, &contact, quantity, bearing).map(DiagnosticRecord::from);
    Ok(ExtremesReport {
        schema: "percuss.extremes/1",
        percuss: env!("CARGO_PKG_VERSION"),
        quantity: requested.name(),
        is_moment: contact.normal.is_moment(),
        joint: requested.joint().map(str::to_owned),
        unit,
        ranges: found.ranges.iter().map(|range| (name(range.joint), range.lower, range.upper)).collect(),
        cone: match extremes.normals.unwrap_or_default().0 {
            NormalRange::Cone(angle) => Some(angle),
            _ => None,
        },
        edges: extremes.edge.iter().map(|GivenEdge(edge)| *edge).collect(),
        kept: extremes.keep.iter().map(kept_record).collect(),
        held: held_joints(&pose, &found.joints),
        starts: found.starts.unwrap_or(least.0.starts.max(most.0.starts)),
        least: record(least),
        most: record(most),
        certificate: extremes.certify.map(|_| prove(&prepared, &pose, &contact, extremes)).transpose()?,
        path: found.path,
        diagnostics: model
            .diagnostics
            .iter()
            .cloned()
            .chain(of_start)
            .chain(found.diagnostics)
            .chain(open_components)
            .collect(),
    })
}

/// Quantity of the search, and its unit. `is_moment`: true if the contact is a moment; `law`: contact law of a peak force.
fn searched_quantity(
    requested: &GivenQuantity,
    mechanism: &Mechanism,
    is_moment: bool,
    law: Option<&DampingQuestion>,
) -> Result<(SearchedQuantity, &'static str), StudyError> {
    if law.is_some() && !matches!(requested, GivenQuantity::Peak(_)) {
        return Err(StudyError::input("extremes.quantity", PEAK_AND_LAW));
    }
    let Some(name) = requested.joint() else {
        return Ok((SearchedQuantity::EffectiveMass, mass_unit(is_moment)));
    };
    let bearing = || find_bearing(mechanism, "extremes.quantity", name);
    let held = match requested {
        GivenQuantity::Bearing(_) => {
            let quantity = SearchedQuantity::BearingImpulse { bearing: bearing()? };
            return Ok((quantity, if is_moment { "kg·m" } else { "kg" }));
        }
        GivenQuantity::Peak(_) => {
            let law = law.ok_or_else(|| StudyError::input("extremes.quantity", PEAK_AND_LAW))?;
            let law = peak_force_law(law)?;
            return Ok((SearchedQuantity::BearingPeakForce { bearing: bearing()?, law }, "N"));
        }
        GivenQuantity::Mass | GivenQuantity::Reflected(_) => false,
        GivenQuantity::Held(_) => true,
    };
    let joint = find_joint(mechanism, "extremes.quantity", name)?;
    let quantity = SearchedQuantity::ReflectedInertia { joint, held };
    let slides = mechanism.joint(joint).kind() == JointKind::Prismatic;
    Ok((quantity, if slides { "kg" } else { "kg·m²" }))
}
/// Peak force of a contact law at its closing speed, as a function force · m̄^power of the effective mass.
fn peak_force_law(law: &DampingQuestion) -> Result<PeakForceLaw, StudyError> {
    let force = damper(law, 1.0)?.peak_force;
    let force = force.ok_or_else(|| StudyError::input("extremes.quantity", PEAK_AND_LAW))?;
    Ok(PeakForceLaw { force, power: law.exponent() / (law.exponent() + 1.0) })
}

/// Warning that redundant constraints leave components of the force in a searched bearing open at a pose; `None` for another quantity.
fn open_components(
    pose: &Pose,
    contact: &Contact,
    quantity: SearchedQuantity,
    name: &str,
) -> Option<Finding> {
    let bearing = match quantity {
        SearchedQuantity::BearingImpulse { bearing } | SearchedQuantity::BearingPeakForce { bearing, .. } => {
            bearing
        }
        SearchedQuantity::EffectiveMass | SearchedQuantity::ReflectedInertia { .. } => return None,
    };
    let response = pose.respond(contact).ok()?;
    let reactions = ReactionMap::new(pose).reactions(&response, 1.0).ok()?;
    let force = bearing.reaction(&reactions)?.force;
    let open = force.iter().filter(|component| component.value().is_none()).count();
    (open > 0).then(|| {
        let message = format!(
            "redundant constraints leave {open} of 3 components of the force in \"{name}\" open: the values contain only the other \
             components; percuss impact names the loops"
        );
        Finding::about_result(FindingKind::OpenComponents, message)
    })
}

impl ExtremesSearch<'_> {
    /// Extremes over the ranges.
    fn over_ranges(&self) -> Result<Found, StudyError> {
        let Self { prepared, pose, question, .. } = self;
        let ranges = ranges(prepared, pose, question)?;
        let starts = question.starts.map_or(DEFAULT_STARTS, usize::from).min(MOST_STARTS);
        let kept = self.kept_points()?;
        let search = |extreme| {
            let poses = SearchedPoses { ranges: &ranges, kept: &kept };
            let (system, start) = (&prepared.system, &prepared.configuration);
            let found = extreme_quantity(system, start, self.contact, self.quantity, poses, extreme, starts);
            found.map(|found| (found, None)).map_err(|error| search_error(error, "extremes.range"))
        };
        let mechanism = &prepared.model.mechanism;
        Ok(Found {
            joints: ranges.iter().map(|range| range.joint).collect(),
            path: None,
            starts: Some(starts),
            extremes: [search(ExtremeKind::Least)?, search(ExtremeKind::Most)?],
            diagnostics: range_findings(mechanism, question, &ranges).map(DiagnosticRecord::from).collect(),
            ranges,
        })
    }

    /// Kept points of the search: three of each link that keeps its orientation.
    fn kept_points(&self) -> Result<Vec<KeptPoint>, StudyError> {
        let mechanism = &self.prepared.model.mechanism;
        let mut points = Vec::new();
        for keep in &self.question.keep {
            let link = mechanism.find_link(&keep.link).map_err(StudyError::about("extremes.keep"))?;
            match keep.point {
                None => points.extend(KeptPoint::of_link(link, mechanism.characteristic_length())),
                Some(point) => {
                    let normal = keep.normal.map(Into::into);
                    points.push(KeptPoint { link, point: point.into(), normal });
                }
            }
        }
        Ok(points)
    }

    /// Extremes along a path: the rows of a sweep give the positions of the drivers.
    fn along_path(&self, question: &MassQuestion, source: &RowSource) -> Result<Found, StudyError> {
        let Self { prepared, pose, .. } = self;
        if !self.question.range.is_empty() || !self.question.keep.is_empty() {
            let why =
                "a path gives all positions of the search; expected neither ranges nor kept points with it";
            return Err(StudyError::input("extremes.path", why));
        }
        let is_path = match source {
            RowSource::Grid(ranges) => ranges.len() == 1,
            RowSource::File(_) => true,
            RowSource::Random { .. } => false,
        };
        if !is_path {
            let why = "a path is a file of positions, or one range; expected neither several ranges nor random rows";
            return Err(StudyError::input("extremes.path", why));
        }
        let sweep = Sweep::new(prepared.model, question, source)?;
        let mechanism = &prepared.model.mechanism;
        let varied = sweep.heading().varied.iter().map(|column| column.joint.as_deref());
        let of_column = |name: Option<&str>| mechanism.find_joint(name?).ok();
        let columns: Vec<Option<JointId>> = varied.map(of_column).collect();
        let mut joints: Vec<JointId> = columns.iter().flatten().copied().collect();
        joints.dedup();
        // The rows of a travel, or of a joint that is no driver of this pose, give the positions of all drivers.
        let drivers = driving_joints(pose);
        let is_travel = columns.iter().any(|joint| joint.is_none_or(|joint| !drivers.contains(&joint)));
        if is_travel {
            let single = |joint: &JointId| mechanism.joint(*joint).kind().dofs() == 1;
            joints = drivers.into_iter().filter(single).collect();
        }
        let names: Vec<String> =
            joints.iter().map(|joint| mechanism.joint(*joint).name().to_owned()).collect();
        let column = match &sweep.heading().varied[..] {
            [column] => Some(column.clone()),
            _ => None,
        };
        let (mut rows, mut numbers, mut values) = (Vec::new(), Vec::new(), Vec::new());
        let end = sweep.run(&mut |row| {
            let position = |name: &String| row.pose.get(name).and_then(|values| values.first()).copied();
            if let Some(positions) = names.iter().map(position).collect::<Option<Vec<f64>>>() {
                rows.push(positions);
                numbers.push(row.row as f64);
                values.extend(row.varied.values().first().filter(|_| column.is_some()).copied());
            }
            ControlFlow::Continue(())
        })?;
        // Joints that do not move, such as those of the other side of a vehicle, are left out of the path.
        if is_travel && rows.len() > 1 {
            let moves = |k: &usize| rows.iter().any(|row: &Vec<f64>| row[*k] != rows[0][*k]);
            let moving: Vec<usize> = (0..joints.len()).filter(moves).collect();
            joints = moving.iter().map(|&k| joints[k]).collect();
            rows = rows.iter().map(|row| moving.iter().map(|&k| row[k]).collect()).collect();
        }
        let path = DriverPath { joints: &joints, rows: &rows };
        let search = |extreme| -> Result<OnPath, StudyError> {
            let (system, start) = (&prepared.system, &prepared.configuration);
            let found = extreme_along_path(system, start, self.contact, self.quantity, &path, extreme);
            let ExtremeOnPath { extreme, row } =
                found.map_err(|error| search_error(error, "extremes.path"))?;
            // The search counts reachable rows only; `numbers` maps them to the rows of the input.
            let (first, part) = (row.floor(), row - row.floor());
            let between = |of: &dyn Fn(usize) -> f64| {
                let from = of(first as usize);
                if part > 0.0 { from + part * (of(first as usize + 1) - from) } else { from }
            };
            let row = between(&|at| numbers.get(at).copied().unwrap_or(at as f64));
            let place = column.as_ref().map(|column| PathPlace {
                name: column.name.clone(),
                value: between(&|at| values.get(at).copied().unwrap_or(f64::NAN)),
                unit: column.unit,
            });
            Ok((extreme, Some((row, place.filter(|place| place.value.is_finite())))))
        };
        let extremes = [search(ExtremeKind::Least)?, search(ExtremeKind::Most)?];
        let path = PathRecord {
            joints: joints.iter().map(|joint| mechanism.joint(*joint).name().to_owned()).collect(),
            rows: end.rows,
            unreached: end.rows - rows.len(),
        };
        let (path, starts) = (Some(path), None);
        Ok(Found { ranges: Vec::new(), joints, path, starts, extremes, diagnostics: end.diagnostics })
    }
}

/// Link or point that stays in place, as a record.
fn kept_record(keep: &Keep) -> KeptRecord {
    KeptRecord { link: keep.link.clone(), point: keep.point, normal: keep.normal }
}

/// Driving joints that do not move, with their positions.
fn held_joints(pose: &Pose, moved: &[JointId]) -> Vec<(String, Vec<f64>)> {
    let mut drivers = driving_joints(pose);
    drivers.retain(|joint| !moved.contains(joint));
    let held = |&joint| (pose.mechanism().joint(joint).name().to_owned(), pose.joint(joint).to_vec());
    drivers.iter().map(held).collect()
}

/// Findings about given ranges outside the limits of their joints, or over many turns.
fn range_findings<'a>(
    mechanism: &'a Mechanism,
    question: &'a ExtremesQuestion,
    ranges: &'a [JointRange],
) -> impl Iterator<Item = Finding> + 'a {
    question.range.iter().zip(ranges).filter_map(|(given, range)| {
        let joint = mechanism.joint(range.joint);
        let limits = joint.limits().filter(|limits| {
            Pose::is_outside(range.lower, *limits) || Pose::is_outside(range.upper, *limits)
        });
        let Some(limits) = limits else {
            let end = if given.lower.value.abs() > given.upper.value.abs() { given.lower } else { given.upper };
            return many_turns_finding(mechanism, range.joint, end, 1.0, "has a range to");
        };
        let message = format!(
            "joint \"{}\": the range {} to {} leaves the limits {} to {} of the joint; the extremes may be outside these limits",
            joint.name(),
            range.lower,
            range.upper,
            limits.lower,
            limits.upper
        );
        Some(Finding::new(FindingKind::OutsideLimits, FindingSubject::Joint(range.joint), message))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use percuss_contact::Law;

    /// For every law, exponent and restitution, the peak force is proportional to the same power p/(p+1) of the mass.
    #[test]
    fn peak_forces_are_powers_of_the_mass() {
        let mut count = 0;
        for law in Law::ALL {
            for (exponent, restitution) in [(1.0, 0.0), (1.0, 0.4), (1.5, 0.4), (1.5, 1.0), (2.2, 0.7)] {
                let question = DampingQuestion {
                    law: Some(law.into()),
                    exponent: Some(exponent.into()),
                    speed: Some(1.7.into()),
                    ..DampingQuestion::new(restitution, 3e4)
                };
                let Ok(power_law) = peak_force_law(&question) else { continue };
                for mass in [0.03, 2.0, 700.0] {
                    let force = damper(&question, mass).expect("a damper").peak_force.expect("a force");
                    let expected = power_law.force * mass.powf(power_law.power);
                    assert!(
                        (force / expected - 1.0).abs() < 1e-8,
                        "{law:?} {exponent} {restitution} {mass}: {force} {expected}"
                    );
                    count += 1;
                }
            }
        }
        assert!(count >= 15, "{count}");
    }
}
