//! Moved part of a travel: a point, or the wheels of a vehicle.

use crate::question::errors::question_error::{Fault, StudyError};
use crate::thresholds::MAX_WHEEL_TRAVEL;
use nalgebra::Vector3;
use percuss_mechanism::{LinkId, Mechanism};
use percuss_suspension::kinematics::wheel_centres;
use percuss_units::{Dimension, QuantityError, parse_triple};

/// Motion of the wheel centres of a vehicle, upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WheelMotion {
    /// Travel of the only wheel.
    WheelTravel,
    /// Equal travel of all wheels.
    Heave,
    /// Opposite travel: the left wheel up, the right wheel down.
    Roll,
}

impl WheelMotion {
    /// All motions.
    pub const ALL: [WheelMotion; 3] = [WheelMotion::WheelTravel, WheelMotion::Heave, WheelMotion::Roll];

    /// Name in flags and studies.
    pub fn name(self) -> &'static str {
        match self {
            WheelMotion::WheelTravel => "wheel-travel",
            WheelMotion::Heave => "heave",
            WheelMotion::Roll => "roll",
        }
    }

    /// Motion with this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|motion| motion.name() == name)
    }

    /// Checks a travel, m.
    ///
    /// # Errors
    /// [`LongTravelError`] above [`MAX_WHEEL_TRAVEL`].
    pub(crate) fn check_distance(self, distance: f64) -> Result<(), LongTravelError> {
        if distance.abs() <= MAX_WHEEL_TRAVEL {
            return Ok(());
        }
        Err(LongTravelError { motion: self, distance })
    }

    /// Wheel centres, each with its travel at a unit of the motion. `field`: origin of the travel, for messages.
    fn wheels(self, mechanism: &Mechanism, field: &'static str) -> Result<Vec<(LinkId, f64)>, Fault> {
        let wheels = wheel_centres(mechanism, "");
        let fault = |why: &str| Fault::from(format!("{}: {why}", self.name()));
        let is_right = |wheel: &LinkId| mechanism.link(*wheel).name().ends_with("_right");
        match (self, wheels.len()) {
            (_, 0) => Err(fault("the model has no link named wheel_centre, as imported suspensions have")),
            (WheelMotion::WheelTravel, 2..) if field == "sweep.vary" => Err(fault(
                "the model has two wheels: vary heave (both alike), roll (left up, right down), or the travel of one, \
                 travel:wheel_centre_left:0,0,0:0,0,1=FROM:TO:COUNT",
            )),
            (WheelMotion::WheelTravel, 2..) => Err(fault(
                "the model has two wheels: give heave (both alike), roll (left up, right down), or the travel of one, \
                 wheel_centre_left:0,0,0:0,0,1=DISTANCE",
            )),
            (WheelMotion::Roll, 1) => Err(fault("the model has one wheel; roll needs both sides")),
            (WheelMotion::WheelTravel | WheelMotion::Heave, _) => {
                Ok(wheels.into_iter().map(|wheel| (wheel, 1.0)).collect())
            }
            (WheelMotion::Roll, _) => Ok(wheels
                .into_iter()
                .map(|wheel| (wheel, if is_right(&wheel) { -1.0 } else { 1.0 }))
                .collect()),
        }
    }
}

/// Wheel travel that no suspension has: probably a number without a unit.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "{} is {distance} m; a wheel moves by at most {MAX_WHEEL_TRAVEL} m. A number without a unit is in metres: write {distance}mm for \
     millimetres",
    motion.name()
)]
pub struct LongTravelError {
    motion: WheelMotion,
    /// Travel, m.
    distance: f64,
}

/// Moved part of a travel.
#[derive(Clone, Debug, PartialEq)]
pub enum Moved {
    /// Point of a link along a direction.
    Point {
        /// The link.
        link: String,
        /// The point, m, link's frame.
        point: [f64; 3],
        /// Direction, world axes, of any length.
        direction: [f64; 3],
    },
    /// Wheel centres.
    Wheels(WheelMotion),
}

/// Point of a link with its displacement.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MovedPoint {
    pub link: LinkId,
    /// The point, m, link's frame.
    pub point: Vector3<f64>,
    /// Direction, world axes.
    pub direction: Vector3<f64>,
    /// Displacement, m.
    pub distance: f64,
}

impl Moved {
    /// Reads `LINK:X,Y,Z:DX,DY,DZ`; `None` without three parts. The text is split from the right, because link names may contain colons.
    pub(crate) fn parse_point(text: &str) -> Option<Result<Self, QuantityError>> {
        let mut parts = text.rsplitn(3, ':');
        let (direction, point, link) = (parts.next()?, parts.next()?, parts.next()?);
        let triples = || {
            Ok(Self::Point {
                link: link.to_owned(),
                point: parse_triple(point, Dimension::Length)?,
                direction: parse_triple(direction, Dimension::Plain)?,
            })
        };
        (!link.is_empty()).then(triples)
    }

    /// Name of the column of a sweep.
    pub fn name(&self) -> String {
        match self {
            Moved::Point { link, .. } => format!("travel:{link}"),
            Moved::Wheels(motion) => motion.name().to_owned(),
        }
    }

    /// True if this motion of the wheels and another one have independent travels: heave and roll.
    pub fn is_beside(&self, other: &Self) -> bool {
        use WheelMotion::{Heave, Roll};
        matches!(
            (self, other),
            (Moved::Wheels(Heave), Moved::Wheels(Roll)) | (Moved::Wheels(Roll), Moved::Wheels(Heave))
        )
    }

    /// Points that move, with their displacements.
    pub(crate) fn points(
        &self,
        mechanism: &Mechanism,
        field: &'static str,
        distance: f64,
    ) -> Result<Vec<MovedPoint>, StudyError> {
        match self {
            Moved::Point { link, point, direction } => {
                let link = mechanism.find_link(link).map_err(StudyError::about(field))?;
                let [point, direction] = [*point, *direction].map(Vector3::from);
                Ok(vec![MovedPoint { link, point, direction, distance }])
            }
            Moved::Wheels(motion) => {
                let wheels =
                    motion.wheels(mechanism, field).map_err(|fault| StudyError::input(field, fault))?;
                let moved = |(link, factor)| MovedPoint {
                    link,
                    point: Vector3::zeros(),
                    direction: Vector3::z(),
                    distance: factor * distance,
                };
                Ok(wheels.into_iter().map(moved).collect())
            }
        }
    }
}
