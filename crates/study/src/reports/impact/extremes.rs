//! Extreme effective masses over ranges of joint positions.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use crate::checks::joint_limits::many_turns_finding;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::evaluation::status::Status;
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::field::Field;
use crate::question::mass_question::MassQuestion;
use crate::reports::impact::additions::find_joint;
use percuss_dynamics::{Gap, Pose};
use percuss_impact::{
    ExtremeKind, ExtremeMass, ExtremesError, JointRange, NormalRange, SearchedContact, SearchedQuantity,
    extreme_quantity,
};
use percuss_mechanism::{JointKind, Mechanism};
use percuss_units::{Dimension, Quantity};
use serde::Serialize;

/// Number of starts without a given one.
pub const DEFAULT_STARTS: usize = 32;
/// Largest number of starts.
pub const MOST_STARTS: usize = 10_000;

/// Ranges of the joints, and number of starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExtremesQuestion {
    /// Ranges of joints: only these joints vary. Empty for the limits of all driving joints with limits, except those with a given
    /// position.
    pub ranges: Vec<GivenRange>,
    /// Quantity whose extremes are searched.
    pub quantity: GivenQuantity,
    /// Normals among which the extremes are searched.
    pub normals: GivenNormals,
    /// Number of starts of the search; 0 for the default.
    pub starts: usize,
}

/// Normals of the contact among which extremes are searched.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenNormals(pub NormalRange);

impl std::str::FromStr for GivenNormals {
    type Err = String;
    /// Reads `given`, `any` or `across:X,Y,Z`.
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "given" => return Ok(Self(NormalRange::Given)),
            "any" => return Ok(Self(NormalRange::Any)),
            _ => {}
        }
        let wrong = || "expected given, any or across:X,Y,Z (world axes), such as across:0,0,1".to_owned();
        let axis = text.strip_prefix("across:").ok_or_else(wrong)?;
        let axis = percuss_units::parse_triple(axis, Dimension::Plain)
            .map_err(|error| format!("across:X,Y,Z is expected: {error}"))?;
        Ok(Self(NormalRange::Across(axis.into())))
    }
}

/// Quantity whose extremes are searched.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum GivenQuantity {
    /// Effective mass of the contact.
    #[default]
    Mass,
    /// Inertia reflected to a joint, with the other drivers free.
    Reflected(String),
    /// Inertia reflected to a joint, with the other drivers at rest.
    Held(String),
    /// Impulse in the bearing of a joint per closing speed, of a plastic impact.
    Bearing(String),
}

impl std::str::FromStr for GivenQuantity {
    type Err = String;
    /// Reads `mass`, `reflected:JOINT`, `held:JOINT` or `bearing:JOINT`.
    fn from_str(text: &str) -> Result<Self, String> {
        if text == "mass" {
            return Ok(Self::Mass);
        }
        match text.split_once(':') {
            Some(("reflected", joint)) => Ok(Self::Reflected(joint.to_owned())),
            Some(("held", joint)) => Ok(Self::Held(joint.to_owned())),
            Some(("bearing", joint)) => Ok(Self::Bearing(joint.to_owned())),
            _ => Err("expected mass, reflected:JOINT, held:JOINT or bearing:JOINT".to_owned()),
        }
    }
}

impl GivenQuantity {
    /// Name of the quantity in reports: `effective_mass`, `reflected_inertia`, `held_inertia` or `bearing_impulse`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Mass => "effective_mass",
            Self::Reflected(_) => "reflected_inertia",
            Self::Held(_) => "held_inertia",
            Self::Bearing(_) => "bearing_impulse",
        }
    }

    /// Joint of the quantity; `None` for the effective mass.
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::Mass => None,
            Self::Reflected(joint) | Self::Held(joint) | Self::Bearing(joint) => Some(joint),
        }
    }

    /// Quantity of the search, and its unit.
    fn searched(&self, mechanism: &Mechanism) -> Result<(SearchedQuantity, &'static str), StudyError> {
        let Some(name) = self.joint() else { return Ok((SearchedQuantity::EffectiveMass, "kg")) };
        let joint = find_joint(mechanism, Field::Quantity, name)?;
        let held = matches!(self, Self::Held(_));
        Ok(match (self, mechanism.joint(joint).kind()) {
            (Self::Bearing(_), _) => (SearchedQuantity::BearingImpulse { joint }, "kg"),
            (_, JointKind::Prismatic) => (SearchedQuantity::ReflectedInertia { joint, held }, "kg"),
            _ => (SearchedQuantity::ReflectedInertia { joint, held }, "kg·m²"),
        })
    }
}

/// Range of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenRange {
    /// The joint.
    pub joint: String,
    /// Lower end.
    pub lower: Quantity,
    /// Upper end.
    pub upper: Quantity,
}

impl std::str::FromStr for GivenRange {
    type Err = String;
    /// Reads `JOINT=FROM:TO`.
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "expected JOINT=FROM:TO, such as elbow=10deg:170deg".to_owned();
        let (joint, range) =
            text.rsplit_once('=').filter(|(joint, _)| !joint.is_empty()).ok_or_else(wrong)?;
        let (lower, upper) = range.split_once(':').ok_or_else(wrong)?;
        let end = |text: &str| Quantity::parse(text).map_err(|error| error.to_string());
        Ok(Self { joint: joint.to_owned(), lower: end(lower)?, upper: end(upper)? })
    }
}

/// Position of a joint at an extreme.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExtremePosition {
    /// The joint.
    pub joint: String,
    /// Position, rad or m.
    pub position: f64,
    /// `lower` or `upper` if the extreme is at an end of the range; null otherwise.
    pub limit: Option<&'static str>,
}

/// Extreme of the searched quantity.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExtremeRecord {
    /// Effective mass, kg; null if it is not finite or if another quantity is searched.
    pub effective_mass: Option<f64>,
    /// Value of the quantity in the unit of the report; null if not finite.
    pub value: Option<f64>,
    /// Kind of the value; `immovable` is a valid largest value of a mass or an inertia. The largest impulse in a bearing is `immovable`
    /// if it has no bound: it grows towards these positions, at which the contact is immovable.
    pub status: Status,
    /// Positions of the varied joints.
    pub positions: Vec<ExtremePosition>,
    /// Gap of a stop at these positions, m: the stop is open if it is positive, and pressed if negative; null for other contacts.
    pub gap: Option<f64>,
    /// Normal at the extreme, world axes, up to its sign; null for the normal of the contact.
    pub normal_world: Option<[f64; 3]>,
    /// Largest component of the projected gradient times its range, relative to the value (for a bearing, of the square of
    /// the impulse): zero at an exact optimum.
    pub residual: f64,
    /// Number of starts that reached this value to six digits.
    pub agreeing: usize,
}

/// Report of `percuss extremes`, as JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExtremesReport {
    /// `percuss.extremes/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Quantity: `effective_mass`, `reflected_inertia`, `held_inertia` or `bearing_impulse` (impulse in the bearing per closing speed, of
    /// a plastic impact).
    pub quantity: &'static str,
    /// Joint of the quantity; null for the effective mass.
    pub joint: Option<String>,
    /// Unit of the values: `kg` or `kg·m²`.
    pub unit: &'static str,
    /// Ranges of the varied joints: joint, lower and upper end, rad or m.
    pub ranges: Vec<(String, f64, f64)>,
    /// Driving joints that do not vary, with their positions, rad or m.
    pub held: Vec<(String, Vec<f64>)>,
    /// Number of starts.
    pub starts: usize,
    /// Smallest value of the quantity.
    pub least: ExtremeRecord,
    /// Largest value of the quantity.
    pub most: ExtremeRecord,
    /// Findings about the ranges.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Smallest and largest effective mass of a contact, or another quantity, over ranges of its driving joints.
///
/// # Errors
/// [`StudyError`], as for [`mass`](crate::mass()); an invalid range; a joint that does not drive; a joint with a position and a
/// range.
pub fn extremes(
    model: &Model,
    question: &MassQuestion,
    extremes: &ExtremesQuestion,
) -> Result<ExtremesReport, StudyError> {
    let prepared = PreparedQuestion::new(model, question)?;
    if prepared.other_mass().is_some() {
        return Err(StudyError::input(Field::AgainstMass, Fault::ExtremesOfMechanism));
    }
    let pose = prepared.pose()?;
    let contact = prepared.contact_at(&pose);
    let ranges = ranges(&prepared, &pose, extremes)?;
    let starts = if extremes.starts == 0 { DEFAULT_STARTS } else { extremes.starts.min(MOST_STARTS) };
    let (quantity, unit) = extremes.quantity.searched(&model.mechanism)?;
    let search = |extreme| {
        let (system, start) = (&prepared.system, &prepared.configuration);
        let contact =
            SearchedContact { contact: &contact, wheel: prepared.wheel(), normals: extremes.normals.0 };
        extreme_quantity(system, start, contact, quantity, &ranges, extreme, starts).map_err(|error| {
            match error {
                ExtremesError::Assembly(error) => StudyError::from(error),
                ExtremesError::Contact(error) => StudyError::from(error),
                error => StudyError::input(Field::Range, error),
            }
        })
    };
    let (least, most) = (search(ExtremeKind::Least)?, search(ExtremeKind::Most)?);
    let mechanism = &model.mechanism;
    let named = prepared.question.named_contact(mechanism)?;
    let gap = named.and_then(|named| Gap::new(&pose, named));
    let gap_at = |found: &ExtremeMass| {
        let mut configuration = prepared.configuration.clone();
        for (range, position) in ranges.iter().zip(&found.positions) {
            configuration.set(mechanism.joint(range.joint).name(), &[*position]).ok()?;
        }
        let there = prepared.system.pose_from(&pose, &configuration).ok()?;
        Some(gap.as_ref()?.at(&there))
    };
    let name = |range: &JointRange| mechanism.joint(range.joint).name().to_owned();
    let record = |found: &ExtremeMass| {
        let (status, value) = Status::classify(found.effective_mass);
        let position = |(range, position): (&JointRange, &f64)| {
            let limit = found.active_limits.iter().find(|(joint, _)| *joint == range.joint);
            ExtremePosition {
                joint: name(range),
                position: *position,
                limit: limit.map(|(_, is_upper)| if *is_upper { "upper" } else { "lower" }),
            }
        };
        ExtremeRecord {
            effective_mass: value.filter(|_| quantity == SearchedQuantity::EffectiveMass),
            value,
            status,
            positions: ranges.iter().zip(&found.positions).map(position).collect(),
            gap: gap_at(found),
            normal_world: found.normal_world.map(Into::into),
            residual: found.residual,
            agreeing: found.agreeing,
        }
    };
    Ok(ExtremesReport {
        schema: "percuss.extremes/1",
        percuss: env!("CARGO_PKG_VERSION"),
        quantity: extremes.quantity.name(),
        joint: extremes.quantity.joint().map(str::to_owned),
        unit,
        ranges: ranges.iter().map(|range| (name(range), range.lower, range.upper)).collect(),
        held: held_joints(&pose, &ranges),
        starts,
        least: record(&least),
        most: record(&most),
        diagnostics: range_findings(mechanism, extremes, &ranges).map(DiagnosticRecord::from).collect(),
    })
}

/// Driving joints without a range, with their positions.
fn held_joints(pose: &Pose, ranges: &[JointRange]) -> Vec<(String, Vec<f64>)> {
    let mut drivers = percuss_impact::driving_joints(pose);
    drivers.retain(|joint| ranges.iter().all(|range| range.joint != *joint));
    let held = |&joint| (pose.mechanism().joint(joint).name().to_owned(), pose.joint(joint).to_vec());
    drivers.iter().map(held).collect()
}

/// Findings about given ranges outside the limits of their joints, or over many turns.
fn range_findings<'a>(
    mechanism: &'a Mechanism,
    question: &'a ExtremesQuestion,
    ranges: &'a [JointRange],
) -> impl Iterator<Item = Finding> + 'a {
    question.ranges.iter().zip(ranges).filter_map(|(given, range)| {
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

/// Ranges in SI units; without given ones, the limits of all driving joints with limits and without a given position.
fn ranges(
    prepared: &PreparedQuestion,
    pose: &Pose,
    question: &ExtremesQuestion,
) -> Result<Vec<JointRange>, StudyError> {
    let mechanism = &prepared.model.mechanism;
    let is_set = |name: &str| prepared.question.set.iter().any(|(joint, _)| joint == name);
    if question.ranges.is_empty() {
        let mut drivers = percuss_impact::driving_joints(pose);
        drivers.retain(|joint| !is_set(mechanism.joint(*joint).name()));
        let limited = drivers.into_iter().filter_map(|joint| {
            let limits = mechanism.joint(joint).limits()?;
            let is_single = mechanism.joint(joint).kind().dofs() == 1;
            (is_single && limits.lower < limits.upper).then_some(JointRange {
                joint,
                lower: limits.lower,
                upper: limits.upper,
            })
        });
        return Ok(limited.collect());
    }
    let range = |given: &GivenRange| {
        let joint = find_joint(mechanism, Field::Range, &given.joint)?;
        if is_set(&given.joint) {
            return Err(StudyError::input(Field::Range, Fault::SetAndRanged { joint: given.joint.clone() }));
        }
        let dimension = match mechanism.joint(joint).kind() {
            JointKind::Revolute | JointKind::Continuous => Dimension::Angle,
            JointKind::Prismatic => Dimension::Length,
            _ => {
                return Err(StudyError::input(Field::Range, Fault::NoMotion { joint: given.joint.clone() }));
            }
        };
        let end = |end: Quantity| {
            end.in_dimension(dimension, &end.to_string())
                .map_err(|error| StudyError::input(Field::Range, Fault::Range(error)))
        };
        Ok(JointRange { joint, lower: end(given.lower)?, upper: end(given.upper)? })
    };
    question.ranges.iter().map(range).collect()
}
