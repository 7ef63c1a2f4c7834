//! Contacts and their results.

use crate::boundary::arrays::{enumeration_value, input_text, nan_if_unknown};
use crate::boundary::handle::{argument_mut, object_of};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_NAME, guard_call, percuss_status,
};
use crate::setup::model::{Model, percuss_model};
use percuss::nalgebra::Vector3;
use percuss::{
    Contact, ContactResponse, ContactStatus, Direction, EffectiveMass, ErrorBudget, Frame, LinkId, Remark,
    RemarkFlags, Route, RouteChoice,
};
use std::ffi::c_char;

/// No link: the ground.
pub const PERCUSS_GROUND: usize = usize::MAX;

/// No link is given: the link of a contact before it is set.
pub const PERCUSS_NO_LINK: usize = usize::MAX - 1;

/// Frame or kind of a normal.
pub type percuss_normal = i32;
/// A vector in the contact link's frame: it turns with the link.
pub const PERCUSS_NORMAL_LINK: percuss_normal = 0;
/// A vector in the world's frame.
pub const PERCUSS_NORMAL_WORLD: percuss_normal = 1;
/// A vector in the other link's frame (the world's frame if the other side is the ground).
pub const PERCUSS_NORMAL_AGAINST: percuss_normal = 2;
/// From the contact point towards a point (m) of another link, in that link's frame.
/// Refused if that line has turned by more than 5° from the line as drawn, or is shorter than a tenth of its drawn
/// length.
pub const PERCUSS_NORMAL_TOWARD: percuss_normal = 3;
/// The same line, which may turn: a spring, a damper or a rod. Refused if shorter than a tenth of its drawn length.
pub const PERCUSS_NORMAL_TURNING_TOWARD: percuss_normal = 4;
/// The opposite direction of that line: a stop that limits the extension of a damper.
pub const PERCUSS_NORMAL_TURNING_AWAY: percuss_normal = 5;

/// The axis of a moment in the contact link's frame. The contact is a moment about the axis (a couple): effective masses are inertias
/// in kg·m², speeds are in rad/s, and the point has no effect.
pub const PERCUSS_AXIS_LINK: percuss_normal = 6;
/// The axis of a moment in the world's frame.
pub const PERCUSS_AXIS_WORLD: percuss_normal = 7;
/// The axis of a moment in the other link's frame (the world's frame if the other side is the ground).
pub const PERCUSS_AXIS_AGAINST: percuss_normal = 8;

/// A contact between a point of a link and another link, or the ground. Initialise it with percuss_contact_init.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct percuss_contact {
    /// The contact link: a number of percuss_model_find_link. PERCUSS_NO_LINK, from percuss_contact_init, is an error.
    pub link: usize,
    /// The other side: a link, or PERCUSS_GROUND.
    pub against: usize,
    /// The contact point in the contact link's frame, m.
    pub point: [f64; 3],
    /// The normal, out of the contact link into the other side; its length does not matter. For PERCUSS_NORMAL_TOWARD,
    /// PERCUSS_NORMAL_TURNING_TOWARD and PERCUSS_NORMAL_TURNING_AWAY: a point of the line, m.
    pub normal: [f64; 3],
    /// Kind of the normal: PERCUSS_NORMAL_LINK to PERCUSS_NORMAL_TURNING_AWAY; or PERCUSS_AXIS_LINK to PERCUSS_AXIS_AGAINST.
    pub normal_given: percuss_normal,
    /// Link of that point; not read if the normal is a vector.
    pub toward: usize,
}

/// Contact with the ground at the origin of a link. The caller must set the link (initially PERCUSS_NO_LINK) and the
/// normal (initially 0, 0, 0, in the link's frame).
///
/// # Safety
/// contact is null or points to storage for a percuss_contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_contact_init(contact: *mut percuss_contact) -> percuss_status {
    guard_call(|| {
        *argument_mut(contact, "contact")? = percuss_contact {
            link: PERCUSS_NO_LINK,
            against: PERCUSS_GROUND,
            point: [0.0; 3],
            normal: [0.0; 3],
            normal_given: PERCUSS_NORMAL_LINK,
            toward: PERCUSS_NO_LINK,
        };
        Ok(())
    })
}

/// The named contact of a model: a stop, the seat of a spring or damper, a contact patch. gap (may be null): the gap with all
/// joints at 0, m; 0 if the parts always touch. Errors: PERCUSS_ERROR_NAME, with the most similar name.
///
/// # Safety
/// name ends with a zero byte; contact is null or points to storage for a percuss_contact, gap to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_model_find_contact(
    model: *const percuss_model,
    name: *const c_char,
    contact: *mut percuss_contact,
    gap: *mut f64,
) -> percuss_status {
    guard_call(|| {
        let mechanism = &object_of(model)?.mechanism;
        let found = mechanism.find_contact(input_text(name, "name")?);
        let found = found.map_err(Failure::with_status(PERCUSS_ERROR_NAME))?;
        *argument_mut(contact, "contact")? = percuss_contact::of(&Contact::named(found, mechanism.root()));
        if !gap.is_null() {
            *argument_mut(gap, "gap")? = found.gap().unwrap_or(0.0);
        }
        Ok(())
    })
}

impl percuss_contact {
    /// Contact of the library with the numbers of its links.
    pub(crate) fn of(contact: &Contact) -> Self {
        let (normal_given, toward, vector) = match contact.normal {
            Direction::Along(vector, Frame::Link) => (PERCUSS_NORMAL_LINK, None, vector),
            Direction::Along(vector, Frame::World) => (PERCUSS_NORMAL_WORLD, None, vector),
            Direction::Along(vector, Frame::Against) => (PERCUSS_NORMAL_AGAINST, None, vector),
            Direction::About(vector, Frame::Link) => (PERCUSS_AXIS_LINK, None, vector),
            Direction::About(vector, Frame::World) => (PERCUSS_AXIS_WORLD, None, vector),
            Direction::About(vector, Frame::Against) => (PERCUSS_AXIS_AGAINST, None, vector),
            Direction::Toward(link, point) => (PERCUSS_NORMAL_TOWARD, Some(link), point),
            Direction::TurningToward(link, point) => (PERCUSS_NORMAL_TURNING_TOWARD, Some(link), point),
            Direction::TurningAwayFrom(link, point) => (PERCUSS_NORMAL_TURNING_AWAY, Some(link), point),
        };
        Self {
            link: contact.link.index(),
            against: contact.against.map_or(PERCUSS_GROUND, LinkId::index),
            point: contact.point.into(),
            normal: vector.into(),
            normal_given,
            toward: toward.map_or(PERCUSS_NO_LINK, LinkId::index),
        }
    }

    /// Contact on a model; refuses links that are not set or do not exist.
    #[inline]
    pub(crate) fn resolve(&self, model: &Model) -> Result<Contact, Failure> {
        let vector = Vector3::from(self.normal);
        // In the order of the values: PERCUSS_NORMAL_LINK to PERCUSS_NORMAL_TURNING_AWAY, then PERCUSS_AXIS_LINK to PERCUSS_AXIS_AGAINST.
        let vectors = [Frame::Link, Frame::World, Frame::Against].map(Some);
        let [link, world, against] = vectors;
        let frames = [link, world, against, None, None, None, link, world, against];
        let normal = match enumeration_value(&frames, self.normal_given, "normal_given")? {
            Some(frame) if self.normal_given >= PERCUSS_AXIS_LINK => Direction::About(vector, frame),
            Some(frame) => Direction::Along(vector, frame),
            None if self.normal_given == PERCUSS_NORMAL_TOWARD => {
                Direction::Toward(contact_link(model, self.toward, "toward")?, vector)
            }
            None if self.normal_given == PERCUSS_NORMAL_TURNING_TOWARD => {
                Direction::TurningToward(contact_link(model, self.toward, "toward")?, vector)
            }
            None => Direction::TurningAwayFrom(contact_link(model, self.toward, "toward")?, vector),
        };
        Ok(Contact {
            link: contact_link(model, self.link, "link")?,
            against: if self.against == PERCUSS_GROUND {
                None
            } else {
                Some(contact_link(model, self.against, "against")?)
            },
            point: self.point.into(),
            normal,
        })
    }
}

/// Link with this number; `field` names it in messages.
#[inline]
fn contact_link(model: &Model, number: usize, field: &str) -> Result<LinkId, Failure> {
    if number == PERCUSS_NO_LINK { Err(unset_link_failure(field)) } else { model.link_id(number) }
}

/// Error of a contact whose link was not set.
#[cold]
fn unset_link_failure(field: &str) -> Failure {
    let message =
        format_args!("the contact's {field} is not set; expected a number of percuss_model_find_link");
    Failure::new(PERCUSS_ERROR_CONTACT, message)
}

/// Outcome of a contact: resistance of the mechanism to the closing motion.
pub type percuss_outcome = i32;
/// A finite effective mass.
pub const PERCUSS_FINITE: percuss_outcome = 0;
/// No admissible motion closes the gap.
pub const PERCUSS_IMMOVABLE: percuss_outcome = 1;
/// A motion without energy closes the gap.
pub const PERCUSS_MASSLESS: percuss_outcome = 2;
/// In batches: no answer. The remarks hold the reason; the error message of percuss_workspace_effective_mass at that
/// configuration states it.
pub const PERCUSS_NO_ANSWER: percuss_outcome = 3;
/// In batches: massless to rounding only; the error is the largest possible m̄ of the contact, kg.
pub const PERCUSS_MASSLESS_TO_ROUNDING: percuss_outcome = 4;

const _: () = assert!(
    PERCUSS_FINITE == ContactStatus::Finite as i32
        && PERCUSS_IMMOVABLE == ContactStatus::Immovable as i32
        && PERCUSS_MASSLESS == ContactStatus::Massless as i32
        && PERCUSS_NO_ANSWER == ContactStatus::Unanswered as i32
        && PERCUSS_MASSLESS_TO_ROUNDING == ContactStatus::MasslessToRounding as i32,
    "the numbers of the outcomes are those of ContactStatus"
);

/// Method of computing m̄.
pub type percuss_route = i32;
/// The recursion if it is accurate enough, else the dense method.
pub const PERCUSS_ROUTE_AUTO: percuss_route = 0;
/// Mass matrix, kernel of the constraints, least energy: O(n³).
pub const PERCUSS_ROUTE_DENSE: percuss_route = 1;
/// Articulated recursion over clusters: O(n).
pub const PERCUSS_ROUTE_ARTICULATED: percuss_route = 2;

/// The gap hardly closes: m̄ is large and uncertain.
pub const PERCUSS_REMARK_NEARLY_IMMOVABLE: u32 = 1;
/// Some motions have no mass. They do not affect a finite m̄.
pub const PERCUSS_REMARK_MASSLESS_MOTIONS: u32 = 2;
/// The contact is massless to rounding only.
pub const PERCUSS_REMARK_MASSLESS_TO_ROUNDING: u32 = 4;
/// A massless motion leaves v* undetermined; m̄ and the contributions are determined.
pub const PERCUSS_REMARK_UNDETERMINED_MOTION: u32 = 8;
/// The rank of the constraints is unclear.
pub const PERCUSS_REMARK_UNCLEAR_RANK: u32 = 16;
/// The mass matrix has negative directions: m̄ is a stationary value, not a minimum.
pub const PERCUSS_REMARK_INDEFINITE: u32 = 32;
/// Branches cross at this pose: m̄ is a lower bound that no branch attains.
pub const PERCUSS_REMARK_SINGULAR_POSE: u32 = 64;
/// The pose is on another assembly mode than the first closed pose (percuss_configuration_allow_other_assembly).
pub const PERCUSS_REMARK_OTHER_ASSEMBLY: u32 = 128;
/// A loop is open as drawn by more than a hundredth of its size: a point may be mistyped.
pub const PERCUSS_REMARK_DRAWN_OPEN: u32 = 256;
/// The loops contradict one another within rounding: closed in least squares.
pub const PERCUSS_REMARK_INEXACT_LOOPS: u32 = 512;
/// A driving joint was not set, and 0 is out of reach.
pub const PERCUSS_REMARK_DRIVER_OFF_ZERO: u32 = 1024;
/// A joint was set to more numbers than its loops leave degrees of freedom: the nearest position is used.
pub const PERCUSS_REMARK_OFF_TARGET: u32 = 2048;
/// A joint is outside its limits. Workspaces do not check limits.
pub const PERCUSS_REMARK_OUTSIDE_LIMITS: u32 = 4096;
/// A small error in the file's numbers would leave the loops one more degree of freedom.
pub const PERCUSS_REMARK_WEAKLY_CONSTRAINED: u32 = 8192;
/// The generic rank of the constraints is unclear: the mobility may differ.
pub const PERCUSS_REMARK_UNCLEAR_MOBILITY: u32 = 16384;
/// The normal is given in the world and the base floats, but the base pose was not given: the root link is taken at the
/// world's origin (percuss_configuration_set_base, percuss_workspace_set_base).
pub const PERCUSS_REMARK_BASE_NOT_GIVEN: u32 = 32768;
/// In batches, a row without an answer: a position is not finite.
pub const PERCUSS_REMARK_NOT_FINITE: u32 = 65536;
/// In batches, a row without an answer: a quaternion is not of unit length.
pub const PERCUSS_REMARK_NOT_UNIT_QUATERNION: u32 = 131072;
/// In batches, a row without an answer: a loop is open.
pub const PERCUSS_REMARK_OPEN_LOOPS: u32 = 262144;
/// In batches, a row without an answer for another reason.
pub const PERCUSS_REMARK_NO_ANSWER: u32 = 524288;
/// The error of m̄ is above 1e-6 m̄; the gradient is not computed.
pub const PERCUSS_REMARK_UNCERTAIN_MASS: u32 = 1048576;
/// The error of m̄ is unknown.
pub const PERCUSS_REMARK_UNKNOWN_ERROR: u32 = 2097152;
/// The contact is a named contact whose gap is open at this pose: an impact occurs at the touch, with the m̄ there (percuss_pose_touch).
pub const PERCUSS_REMARK_OPEN_GAP: u32 = 4194304;
/// A joint outside its limits is more than a turn from 0: its position, in rad, is probably a number of degrees.
pub const PERCUSS_REMARK_MANY_TURNS: u32 = 8388608;

/// Effective mass with its error and remarks. An unknown or inapplicable number is NaN.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_mass {
    /// A percuss_outcome.
    pub outcome: percuss_outcome,
    /// PERCUSS_ROUTE_DENSE or PERCUSS_ROUTE_ARTICULATED.
    pub route: percuss_route,
    /// PERCUSS_REMARK_… added together.
    pub remarks: u32,
    /// 0.
    pub reserved: u32,
    /// Degrees of freedom left by the constraints; a floating base's 6 included.
    pub degrees_of_freedom: usize,
    /// m̄, kg; NaN unless the outcome is PERCUSS_FINITE.
    pub effective_mass: f64,
    /// Error of m̄, kg: the sum of the known parts. NaN if the rounding or the closing part is unknown.
    pub error: f64,
    /// Part by rounding, kg.
    pub error_rounding: f64,
    /// Part by the residual of the loops, kg.
    pub error_closing: f64,
    /// Part by the misfit of the loops in the file, kg; NaN without redundant rows to measure it.
    pub error_file: f64,
}

/// Outcome, and m̄ in kg, or NaN.
#[inline]
pub(crate) fn outcome_and_value(mass: EffectiveMass) -> (percuss_outcome, f64) {
    match mass {
        EffectiveMass::Finite(m) => (PERCUSS_FINITE, m),
        EffectiveMass::Immovable => (PERCUSS_IMMOVABLE, f64::NAN),
        EffectiveMass::Massless => (PERCUSS_MASSLESS, f64::NAN),
    }
}

/// The remarks as bits PERCUSS_REMARK_….
pub(crate) fn remark_bits(remarks: &[Remark]) -> u32 {
    remarks.iter().collect::<RemarkFlags>().bits()
}

/// m̄, its error and the remarks, for C.
pub(crate) fn mass_summary(response: &ContactResponse) -> percuss_mass {
    let (outcome, effective_mass) = outcome_and_value(response.effective_mass);
    let budget = response.error.unwrap_or(ErrorBudget { rounding: None, closing: None, file: None });
    percuss_mass {
        outcome,
        route: match response.route {
            Route::Dense => PERCUSS_ROUTE_DENSE,
            Route::Articulated => PERCUSS_ROUTE_ARTICULATED,
        },
        remarks: response.remark_flags().bits(),
        reserved: 0,
        degrees_of_freedom: response.degrees_of_freedom,
        effective_mass,
        error: nan_if_unknown(budget.known()),
        error_rounding: nan_if_unknown(budget.rounding),
        error_closing: nan_if_unknown(budget.closing),
        error_file: nan_if_unknown(budget.file),
    }
}

/// Route of a constant PERCUSS_ROUTE_….
pub(crate) fn parse_route(route: percuss_route) -> Result<RouteChoice, Failure> {
    let choices = [RouteChoice::Auto, RouteChoice::Only(Route::Dense), RouteChoice::Only(Route::Articulated)];
    enumeration_value(&choices, route, "route")
}
