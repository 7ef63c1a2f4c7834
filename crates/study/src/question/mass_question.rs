//! Question about a contact of a model, in terms of names. The fields correspond to the flags of `percuss
//! mass`.

use crate::question::errors::question_error::StudyError;
use crate::question::field::{Field, Names};
use crate::question::pose_file::GivenPose;
use crate::question::travel::given_travel::GivenTravel;
use crate::values::drives::GivenSpring;
use crate::values::position::GivenPosition;
use crate::values::quantities::{self, Point, Vector};
use percuss_dynamics::{Base, Contact, Direction, Frame};
use percuss_mechanism::{LinkId, Mechanism, NamedContact};
use percuss_spatial::Transform;
use percuss_units::QuantityError;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::str::FromStr;

/// Direction of the contact normal, or axis of a moment.
#[derive(Clone, Debug, PartialEq)]
pub enum Normal {
    /// Vector in the normal's frame.
    Along([f64; 3]),
    /// Axis of a moment in the normal's frame; the contact point has no effect.
    About([f64; 3]),
    /// Direction from the contact point towards a point (m) of a link, in the frame of that link. The line may
    /// turn by at most 5° from the line as drawn.
    Toward(String, [f64; 3]),
    /// Same as `Toward`, for a line that may turn freely: of a spring, a damper or a rod.
    TurningToward(String, [f64; 3]),
    /// Opposite direction of this line: a stop that limits the extension of a damper.
    TurningAwayFrom(String, [f64; 3]),
}

impl Normal {
    /// Normal with the names of links, and its frame if it is a vector (normal or axis).
    pub fn of_direction(direction: Direction, name: impl Fn(LinkId) -> String) -> (Self, Frame) {
        match direction {
            Direction::Along(normal, frame) => (Normal::Along(normal.into()), frame),
            Direction::About(axis, frame) => (Normal::About(axis.into()), frame),
            Direction::Toward(link, point) => (Normal::Toward(name(link), point.into()), Frame::Link),
            Direction::TurningToward(link, point) => {
                (Normal::TurningToward(name(link), point.into()), Frame::Link)
            }
            Direction::TurningAwayFrom(link, point) => {
                (Normal::TurningAwayFrom(name(link), point.into()), Frame::Link)
            }
        }
    }
}

/// Held contact: a point (m, link's frame) of a link that stays in place along a normal (world axes, out of the
/// link) or in all directions.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hold {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    #[serde(deserialize_with = "quantities::point")]
    #[schemars(with = "Point")]
    pub point: [f64; 3],
    /// The normal, world axes, out of the link; without a normal all directions are held.
    #[serde(default, deserialize_with = "quantities::some_vector", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vector>")]
    pub normal: Option<[f64; 3]>,
}

/// Splits `NAME[:X,Y,Z[:X,Y,Z]]` into the name, which may contain colons, and the texts of the triples.
pub(crate) fn triples(text: &str) -> (&str, Vec<&str>) {
    let (mut name, mut found) = (text, Vec::new());
    while found.len() < 2
        && let Some((rest, last)) = name.rsplit_once(':')
        && last.contains(',')
        && last.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
    {
        found.insert(0, last);
        name = rest;
    }
    (name, found)
}

/// Point of a flag.
fn parse_point(text: &str) -> Result<[f64; 3], String> {
    text.parse().map(|Point(point)| point).map_err(|error: QuantityError| error.to_string())
}

/// Vector of a flag.
fn parse_vector(text: &str) -> Result<[f64; 3], String> {
    text.parse().map(|Vector(vector)| vector).map_err(|error: QuantityError| error.to_string())
}

impl FromStr for Hold {
    type Err = String;
    /// Reads `LINK:X,Y,Z[:NX,NY,NZ]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (link, found) = triples(text);
        let (point, normal) = match found[..] {
            [point] => (point, None),
            [point, normal] => (point, Some(parse_vector(normal)?)),
            _ => return Err("expected LINK:X,Y,Z or LINK:X,Y,Z:NX,NY,NZ, such as foot:0,0,0:0,0,-1".into()),
        };
        Ok(Self { link: link.to_owned(), point: parse_point(point)?, normal })
    }
}

/// Request for the classical estimate: mass of some links, moving with a point of the first link.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EstimateQuestion {
    /// Links with a mass counted in the estimate.
    pub links: Vec<String>,
    /// Point A, m, in the first link's frame; default origin.
    #[serde(default, deserialize_with = "quantities::point")]
    #[schemars(with = "Option<Point>")]
    pub point: [f64; 3],
    /// Direction of the counted component of A's velocity, world axes; default: upwards in a suspension, otherwise the full speed.
    #[serde(default, deserialize_with = "quantities::some_vector", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vector>")]
    pub direction: Option<[f64; 3]>,
}

impl FromStr for EstimateQuestion {
    type Err = String;
    /// Reads `LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (links, found) = triples(text);
        let links: Vec<String> = links.split(',').map(str::to_owned).collect();
        if links.iter().any(String::is_empty) {
            return Err(
                "expected LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]], such as spindle,upright:0,0,0:0,0,1".into()
            );
        }
        let point = found.first().map_or(Ok([0.0; 3]), |text| parse_point(text))?;
        let direction = found.get(1).map(|text| parse_vector(text)).transpose()?;
        Ok(Self { links, point, direction })
    }
}

/// Default direction of a motion ratio: upwards, as for wheel travel.
pub const UPWARDS: [f64; 3] = [0.0, 0.0, 1.0];

/// Point of a motion ratio relative to the contact.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RatioPoint {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    #[serde(default, deserialize_with = "quantities::point")]
    #[schemars(with = "Option<Point>")]
    pub point: [f64; 3],
    /// Direction of the speed, world axes, of any length; default z.
    #[serde(default = "upwards", deserialize_with = "quantities::vector")]
    #[schemars(with = "Option<Vector>")]
    pub direction: [f64; 3],
}

/// Default of the `direction` key.
fn upwards() -> [f64; 3] {
    UPWARDS
}

impl FromStr for RatioPoint {
    type Err = String;
    /// Reads `LINK:X,Y,Z[:DX,DY,DZ]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (link, found) = triples(text);
        let (point, direction) = match found[..] {
            [point] => (point, UPWARDS),
            [point, direction] => (point, parse_vector(direction)?),
            _ => return Err("expected LINK:X,Y,Z or LINK:X,Y,Z:DX,DY,DZ, such as wheel:0,0,0:0,0,1".into()),
        };
        Ok(Self { link: link.to_owned(), point: parse_point(point)?, direction })
    }
}

impl MassQuestion {
    /// Question with the link, point, normal and other side of its named contact; the name remains, so that a stop is
    /// still brought to the touch. A question that has a link is resolved already.
    ///
    /// # Errors
    /// Unknown contact.
    pub(crate) fn resolve_contact(&self, mechanism: &Mechanism) -> Result<Cow<'_, Self>, StudyError> {
        if self.link.is_empty()
            && let Some(spelled) = self.spelled_contact(mechanism)?
        {
            return Ok(Cow::Owned(self.with_spelled(&spelled, mechanism)?));
        }
        let contact = self.named_contact(mechanism)?.filter(|_| self.link.is_empty());
        let Some(contact) = contact else { return Ok(Cow::Borrowed(self)) };
        let name = |link: LinkId| mechanism.link(link).name().to_owned();
        let (normal, normal_frame) = match &self.normal {
            Normal::Along(zero) if *zero == [0.0; 3] => {
                Normal::of_direction(Contact::named(contact, mechanism.root()).normal, name)
            }
            _ if contact.gap().is_some() => {
                let why = "the named contact is a stop, whose normal belongs to its gap; remove the normal, or give link, point and normal";
                return Err(StudyError::input(Field::Normal, why));
            }
            given => (given.clone(), self.normal_frame),
        };
        Ok(Cow::Owned(Self {
            link: name(contact.link()),
            point: (*contact.point()).into(),
            normal,
            frame: Frame::Link,
            normal_frame,
            against: contact.against().map(name),
            ..self.clone()
        }))
    }

    /// True if a travel or a file of positions gives the pose.
    pub(crate) fn gives_pose(&self) -> bool {
        !self.travel.is_empty() || self.pose.is_some()
    }

    /// X_wr of the pose of the question; `None` if the root link is at the origin of the world.
    pub(crate) fn base_pose(&self) -> Option<&Transform<f64>> {
        self.pose.as_ref().map(|pose| &pose.base).filter(|base| **base != Transform::identity())
    }

    /// Named contact of the question; `None` if `at` is empty, or describes a contact in one of the other forms of
    /// [`FurtherContact`](crate::FurtherContact).
    pub(crate) fn named_contact<'m>(
        &self,
        mechanism: &'m Mechanism,
    ) -> Result<Option<&'m NamedContact>, StudyError> {
        if self.spelled_contact(mechanism)?.is_some() {
            return Ok(None);
        }
        let find = |name: &String| mechanism.find_contact(name).map_err(|e| StudyError::input(Field::At, e));
        self.at.as_ref().map(find).transpose()
    }

    /// Question at a named contact of the model in place of its own contact.
    pub(crate) fn at_contact(&self, name: &str) -> Self {
        Self {
            at: Some(name.to_owned()),
            link: String::new(),
            point: [0.0; 3],
            normal: Normal::Along([0.0; 3]),
            frame: Frame::Link,
            normal_frame: Frame::Link,
            against: None,
            ..self.clone()
        }
    }

    /// Question at the contact of another question, with its own pose and conditions.
    pub(crate) fn with_contact_of(&self, other: &Self) -> Self {
        Self {
            at: other.at.clone(),
            link: other.link.clone(),
            point: other.point,
            normal: other.normal.clone(),
            frame: other.frame,
            normal_frame: other.normal_frame,
            against: other.against.clone(),
            against_mass: other.against_mass,
            estimate: other.estimate.clone(),
            ratio_at: other.ratio_at.clone(),
            ..self.clone()
        }
    }

    /// Question without a contact, for commands that define the contact by other data: all joints at 0, nothing
    /// held.
    pub fn without_contact() -> Self {
        Self {
            names: Names::default(),
            at: None,
            link: String::new(),
            point: [0.0; 3],
            normal: Normal::Along([0.0; 3]),
            frame: Frame::Link,
            normal_frame: Frame::Link,
            against: None,
            against_mass: None,
            set: Vec::new(),
            guess: Vec::new(),
            pose: None,
            travel: Vec::new(),
            lock: Vec::new(),
            hold: Vec::new(),
            armature: Vec::new(),
            gear_stiffness: Vec::new(),
            base: Base::Fixed,
            estimate: None,
            ratio_at: Vec::new(),
        }
    }
}

/// Question about a contact of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct MassQuestion {
    /// Named contact of the model, or a contact as text in a form of [`FurtherContact`](crate::FurtherContact); replaces `link`, `point`,
    /// the frames, `against` and a zero normal. The mechanism moves to the touch of a named stop, unless `travel` or `pose` gives the pose,
    /// or all joints that move the stop are set. The joint of a joint stop moves to its limit, unless its position is given.
    pub at: Option<String>,
    /// Contact link.
    pub link: String,
    /// The contact point, m, in `frame`.
    pub point: [f64; 3],
    /// Contact normal, out of the contact link; or the axis of a moment.
    pub normal: Normal,
    /// Frame of `point`.
    pub frame: Frame,
    /// Frame of a normal or an axis given as a vector.
    pub normal_frame: Frame,
    /// Other link; `None` for the ground.
    pub against: Option<String>,
    /// Mass of a free body on the other side, kg.
    pub against_mass: Option<f64>,
    /// Driving joints and their positions.
    pub set: Vec<(String, GivenPosition)>,
    /// Initial guesses for joints determined by loops.
    pub guess: Vec<(String, GivenPosition)>,
    /// Positions of all joints, from a file; `set` and `guess` take precedence.
    pub pose: Option<GivenPose>,
    /// Travels that drive the pose, starting from the set joint positions.
    pub travel: Vec<GivenTravel>,
    /// Locked joints.
    pub lock: Vec<String>,
    /// Held contacts.
    pub hold: Vec<Hold>,
    /// Joints with replaced armature: one value, or one value per velocity.
    pub armature: Vec<(String, Vec<f64>)>,
    /// Joints with elastic gears between the rotor (the armature) and the joint: stiffness, and damping if given.
    pub gear_stiffness: Vec<(String, GivenSpring)>,
    /// Base: fixed or floating root link.
    pub base: Base,
    /// Classical estimate to report with the result.
    pub estimate: Option<EstimateQuestion>,
    /// Points of motion ratios to report.
    pub ratio_at: Vec<RatioPoint>,
    /// Set of names used in messages for the parts of the question.
    pub names: Names,
}
