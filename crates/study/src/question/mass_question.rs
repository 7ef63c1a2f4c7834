//! Question about a contact of a model, in terms of names. The fields correspond to the flags of `percuss
//! mass`.

use crate::question::errors::question_error::StudyError;
use crate::question::field::{Field, Names};
use crate::question::pose_file::GivenPose;
use crate::question::travel::given_travel::GivenTravel;
use crate::values::position::GivenPosition;
use percuss_dynamics::{Base, Contact, Direction, Frame};
use percuss_mechanism::{LinkId, Mechanism, NamedContact};
use std::borrow::Cow;

/// Direction of the contact normal.
#[derive(Clone, Debug, PartialEq)]
pub enum Normal {
    /// Vector in the normal's frame.
    Along([f64; 3]),
    /// Direction from the contact point towards a point (m) of a link, in the frame of that link. The line may
    /// turn by at most 5° from the line as drawn.
    Toward(String, [f64; 3]),
    /// Same as `Toward`, for a line that may turn freely: of a spring, a damper or a rod.
    TurningToward(String, [f64; 3]),
    /// Opposite direction of this line: a stop that limits the extension of a damper.
    TurningAwayFrom(String, [f64; 3]),
}

impl Normal {
    /// Normal with names in place of links, and the frame of a normal that is a vector.
    pub fn of_direction(direction: Direction, name: impl Fn(LinkId) -> String) -> (Self, Frame) {
        match direction {
            Direction::Along(normal, frame) => (Normal::Along(normal.into()), frame),
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
#[derive(Clone, Debug, PartialEq)]
pub struct Hold {
    /// The link.
    pub link: String,
    /// The point, m.
    pub point: [f64; 3],
    /// The normal; `None` to hold all three directions.
    pub normal: Option<[f64; 3]>,
}

/// Request for the classical estimate: mass of some links, moving with a point of the first link.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateQuestion {
    /// Links with a mass counted in the estimate.
    pub links: Vec<String>,
    /// Point A in the first link's frame, m.
    pub point: [f64; 3],
    /// Direction (world axes) of the counted component of A's velocity; `None` for the full speed.
    pub direction: Option<[f64; 3]>,
}

/// Default direction of a motion ratio: upwards, as for wheel travel.
pub const UPWARDS: [f64; 3] = [0.0, 0.0, 1.0];

/// Point of a motion ratio relative to the contact.
#[derive(Clone, Debug, PartialEq)]
pub struct RatioPoint {
    /// The link.
    pub link: String,
    /// The point, m, link's frame.
    pub point: [f64; 3],
    /// Direction of the speed, world axes, of any length.
    pub direction: [f64; 3],
}

impl MassQuestion {
    /// Question with the link, point, normal and other side of its named contact; the name remains, so that a stop is
    /// still brought to the touch. A question that has a link is resolved already.
    ///
    /// # Errors
    /// Unknown contact.
    pub(crate) fn resolve_contact(&self, mechanism: &Mechanism) -> Result<Cow<'_, Self>, StudyError> {
        let contact = self.named_contact(mechanism)?.filter(|_| self.link.is_empty());
        let Some(contact) = contact else { return Ok(Cow::Borrowed(self)) };
        let name = |link: LinkId| mechanism.link(link).name().to_owned();
        let (normal, normal_frame) =
            Normal::of_direction(Contact::named(contact, mechanism.root()).normal, name);
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

    /// Named contact of the question.
    pub(crate) fn named_contact<'m>(
        &self,
        mechanism: &'m Mechanism,
    ) -> Result<Option<&'m NamedContact>, StudyError> {
        let find = |name: &String| mechanism.find_contact(name).map_err(|e| StudyError::input(Field::At, e));
        self.at.as_ref().map(find).transpose()
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
            base: Base::Fixed,
            estimate: None,
            ratio_at: Vec::new(),
        }
    }
}

/// Question about a contact of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct MassQuestion {
    /// Named contact of the model; replaces `link`, `point`, `normal`, the frames and `against`. A stop is brought to
    /// the touch, unless `travel` or `pose` gives the pose, or all joints that move it are set.
    pub at: Option<String>,
    /// Contact link.
    pub link: String,
    /// The contact point, m, in `frame`.
    pub point: [f64; 3],
    /// Contact normal, out of the contact link.
    pub normal: Normal,
    /// Frame of `point`.
    pub frame: Frame,
    /// Frame of a normal given as a vector.
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
    /// Base: fixed or floating root link.
    pub base: Base,
    /// Classical estimate to report with the result.
    pub estimate: Option<EstimateQuestion>,
    /// Points of motion ratios to report.
    pub ratio_at: Vec<RatioPoint>,
    /// Set of names used in messages for the parts of the question.
    pub names: Names,
}
