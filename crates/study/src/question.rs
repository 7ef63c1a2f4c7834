//! The question: a contact of a model, by names. The same words as the flags of `percuss mass`.

use crate::field::Names;
use crate::given_pose::GivenPose;
use crate::given_travel::GivenTravel;
use crate::position::GivenPosition;
use percuss_dynamics::{Base, Frame};

/// Where the normal of a question points.
#[derive(Clone, Debug, PartialEq)]
pub enum Normal {
    /// Along a vector in the normal's frame.
    Along([f64; 3]),
    /// From the contact point towards a point (m) of a link, in that link's frame: a line near the line as drawn.
    Toward(String, [f64; 3]),
    /// The same, along a line that may turn: of a spring, a damper or a rod.
    TurningToward(String, [f64; 3]),
}

/// A held contact: a point (m, link's frame) of a link that stays where it is, along a normal (world axes, out of the
/// link) or in all directions.
#[derive(Clone, Debug, PartialEq)]
pub struct Hold {
    /// The link.
    pub link: String,
    /// The point, m.
    pub point: [f64; 3],
    /// The normal; none holds three directions.
    pub normal: Option<[f64; 3]>,
}

/// The classical estimate asked for: the mass of some links, moved with a point of the first.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateQuestion {
    /// The links whose mass it takes.
    pub links: Vec<String>,
    /// Point A in the first link's frame, m.
    pub point: [f64; 3],
    /// Takes the component of A's velocity along this direction (world axes); none: its full speed.
    pub direction: Option<[f64; 3]>,
}

/// The direction of a motion ratio, where none is given: that of a wheel.
pub const UPWARDS: [f64; 3] = [0.0, 0.0, 1.0];

/// A point whose speed is set beside that of the contact.
#[derive(Clone, Debug, PartialEq)]
pub struct RatioPoint {
    /// The link.
    pub link: String,
    /// The point, m, link's frame.
    pub point: [f64; 3],
    /// Along which direction, world axes; its length does not matter.
    pub direction: [f64; 3],
}

impl MassQuestion {
    /// A question without a contact, for whom the contact follows from something else: every joint at 0, nothing held.
    pub fn anywhere() -> Self {
        Self {
            names: Names::default(),
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

/// A contact of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct MassQuestion {
    /// The struck link.
    pub link: String,
    /// The contact point, m, in `frame`.
    pub point: [f64; 3],
    /// The normal, out of the struck link.
    pub normal: Normal,
    /// In which frame `point` is given.
    pub frame: Frame,
    /// In which frame a normal along a vector is given.
    pub normal_frame: Frame,
    /// The other link; none: the ground.
    pub against: Option<String>,
    /// Mass of a free body on the other side, kg.
    pub against_mass: Option<f64>,
    /// Driving joints and what they are set to.
    pub set: Vec<(String, GivenPosition)>,
    /// Where to look for joints that follow from loops.
    pub guess: Vec<(String, GivenPosition)>,
    /// Where all joints stand, from a file; `set` and `guess` are put over it.
    pub pose: Option<GivenPose>,
    /// Travels that drive the pose from where the joints are set.
    pub travel: Vec<GivenTravel>,
    /// Joints that are held.
    pub lock: Vec<String>,
    /// Contacts that are held.
    pub hold: Vec<Hold>,
    /// Joints whose armature is replaced: one value, or one for each velocity.
    pub armature: Vec<(String, Vec<f64>)>,
    /// How the root stands.
    pub base: Base,
    /// The estimate to set beside the answer.
    pub estimate: Option<EstimateQuestion>,
    /// Points whose speed is set beside the contact's.
    pub ratio_at: Vec<RatioPoint>,
    /// By what names messages call the parts of the question.
    pub names: Names,
}
