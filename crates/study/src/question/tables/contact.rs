//! Tables of a question about a contact: contact, pose, conditions. The command line has a flag for each key.

#[cfg(feature = "flags")]
use super::headings::{ADDITIONAL, CONDITIONS, CONTACT, POSE};
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::link_points::{EstimateQuestion, RatioPoint};
use crate::question::travel::given_travel::GivenTravel;
use crate::values::drives::{self, GivenSpring};
#[cfg(feature = "flags")]
use crate::values::named;
use crate::values::position::GivenPosition;
use crate::values::quantities::{LinkPoint, Point, PositiveMass, Vector};
use crate::values::value::{self, NumberOrText, OneOrMany, PositionText, Words};
use percuss_dynamics::{Base, Contact, Direction, Frame};
use percuss_mechanism::{LinkId, Mechanism};
use percuss_spatial::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Frame of a contact point or a normal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum FrameName {
    /// Frame of the contact link.
    #[default]
    Link,
    /// Frame of the root link at its reference pose.
    World,
    /// Frame of the other link.
    Against,
}

impl From<Frame> for FrameName {
    fn from(frame: Frame) -> Self {
        match frame {
            Frame::Link => FrameName::Link,
            Frame::World => FrameName::World,
            Frame::Against => FrameName::Against,
        }
    }
}

impl From<FrameName> for Frame {
    fn from(frame: FrameName) -> Self {
        match frame {
            FrameName::Link => Frame::Link,
            FrameName::World => Frame::World,
            FrameName::Against => Frame::Against,
        }
    }
}

/// Motion of the root link.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum BaseName {
    /// Fixed to the ground.
    #[default]
    Fixed,
    /// Free to move.
    Floating,
}

impl From<Base> for BaseName {
    fn from(base: Base) -> Self {
        match base {
            Base::Fixed => BaseName::Fixed,
            Base::Floating => BaseName::Floating,
        }
    }
}

impl From<BaseName> for Base {
    fn from(base: BaseName) -> Self {
        match base {
            BaseName::Fixed => Base::Fixed,
            BaseName::Floating => Base::Floating,
        }
    }
}

/// Contact of a question.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = CONTACT))]
#[serde(deny_unknown_fields, default)]
pub struct ContactTable {
    /// Name in tables and figures, in a study with several contacts; default: `at`, or the link.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Named contact of the model, such as bump_stop; a stop is brought to the touch. all: a table.
    ///
    /// Suspension sheets name their stops, spring and damper seats and contact patches; a URDF does so by `<contact>`, an MJCF by
    /// its sites (the normal is the z-axis as drawn). A normal replaces that of a contact that is no stop. The mechanism moves until the gap of a stop is closed, unless a travel or a file gives the pose. On a vehicle with
    /// both sides, both stops touch.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "NAME", conflicts_with_all = ["link", "point", "along_line", "about_axis", "frame", "against"])
    )]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<String>,
    /// Contact link.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK"))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
    /// Contact point (m).
    #[cfg_attr(feature = "flags", arg(long, value_name = "X,Y,Z"))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point: Option<Point>,
    /// Contact normal, out of the contact link.
    ///
    /// The normal points into the other body. Its length and its sign do not affect the effective mass.
    #[cfg_attr(feature = "flags", arg(long, value_name = "X,Y,Z", conflicts_with = "along_line"))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal: Option<Vector>,
    /// Instead of a point and a normal: a moment about an axis. The result is an inertia, kg·m².
    ///
    /// The two sides act on each other by a moment about this axis (a couple), as at a rotational stop or in a clutch. The result is the
    /// effective inertia: kg·m² in place of kg, rad/s in place of m/s, N·m·s in place of N·s. The length of the axis has no effect.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "X,Y,Z", conflicts_with_all = ["point", "normal", "along_line", "against_mass", "estimate"])
    )]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub about_axis: Option<Vector>,
    /// Instead of a normal: towards a point of a link.
    ///
    /// The normal points from the contact point towards this point of a link (m, in the frame of that link). Use it
    /// for the line of a spring, or for a stop near the design pose. For a stop over a travel, use a normal.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK:X,Y,Z"))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub along_line: Option<LinkPoint>,
    /// Allow the line to rotate: a spring, a damper or a rod.
    ///
    /// Otherwise, a pose is refused if the line has rotated by more than 5° relative to the other body since
    /// the design pose (all joints at 0), because the line is then no longer the normal of a stop. A line shorter
    /// than a tenth of its length in the design pose is always refused.
    #[cfg_attr(feature = "flags", arg(long, requires = "along_line"))]
    pub turning_normal: bool,
    /// The line is a cable: it resists lengthening, and may rotate.
    ///
    /// The gap closes while the cable gets longer; the impulse of an impact pulls. Without another link in contact, the other side is the
    /// link of the line.
    #[cfg_attr(feature = "flags", arg(long, requires = "along_line", conflicts_with = "turning_normal"))]
    pub cable: bool,
    /// Frame of the point and the normal or the axis; default: link.
    ///
    /// Applies to both. A point given in another frame is converted to the link frame once, at the set pose with
    /// all varied joints at 0, and then moves with the link. A normal stays constant in the given frame.
    #[cfg_attr(feature = "flags", arg(long, value_enum))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frame: Option<FrameName>,
    /// Frame of the normal, if different from the frame of the point.
    #[cfg_attr(feature = "flags", arg(long, value_enum))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal_frame: Option<FrameName>,
    /// Other link in contact; default: the ground.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK"))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against: Option<String>,
    /// Mass (kg) of a free body as the other side of the contact.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG", conflicts_with = "against"))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against_mass: Option<PositiveMass>,
    /// Classical estimate, shown with the result.
    ///
    /// The total mass of these links is reduced to the contact by the motion ratio of point A (m, frame of the first
    /// link; default: its origin) along a direction (world axes; default: upwards in a suspension, otherwise the
    /// path of A).
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]]", help_heading = ADDITIONAL))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimate: Option<EstimateQuestion>,
    /// Motion ratio at this point (m, link frame), along a direction (world axes; default z).
    ///
    /// The ratio relates the speed of the point to the closing speed of the contact. If the model has a wheel and one
    /// degree of freedom, the ratios of the wheel centre and the contact patch are always shown.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK:X,Y,Z[:DX,DY,DZ]", help_heading = ADDITIONAL))]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub ratio_at: Vec<RatioPoint>,
}

/// Pose of a question.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = POSE))]
#[serde(deny_unknown_fields, default)]
pub struct PoseTable {
    /// Position of a driving joint (m, rad; 30deg, 5mm).
    ///
    /// Driving joints without a position are at 0. Spherical: w,x,y,z; planar: x,y,angle; floating: x,y,z,w,x,y,z.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT=VALUE", value_parser = named::joint_position))]
    #[serde(with = "value::named_positions", skip_serializing_if = "Vec::is_empty")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub set: Vec<(String, GivenPosition)>,
    /// Initial guess of a joint that depends on other joints through loops; selects the assembly mode.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT=VALUE", value_parser = named::joint_position))]
    #[serde(with = "value::named_positions", skip_serializing_if = "Vec::is_empty")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub guess: Vec<(String, GivenPosition)>,
    /// Move the mechanism until a point has this travel.
    ///
    /// The point of a link (m, link frame) moves by DISTANCE along a direction (world axes) from its position in the
    /// set pose, as in a sweep over a travel. Give one travel for each driven point.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK:X,Y,Z:DX,DY,DZ=DISTANCE"))]
    #[serde(with = "value::text_list", skip_serializing_if = "Vec::is_empty")]
    #[schemars(with = "Option<Words>")]
    pub travel: Vec<GivenTravel>,
    /// Complete configuration: output of --format json, JSON with a position for each joint, or the name of a pose of the model
    /// (keyframe of MJCF, listed by `percuss check`). Set positions and guesses override it.
    #[cfg_attr(feature = "flags", arg(long = "pose", id = "pose", value_name = "FILE.json|NAME"))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
}

/// Conditions of a question.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = CONDITIONS))]
#[serde(deny_unknown_fields, default)]
pub struct ConditionsTable {
    /// Lock a joint at its position; all locks every joint.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT"))]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub lock: Vec<String>,
    /// Rotor inertia reflected to a joint (kg·m² or kg): a value, or RATIO:ROTOR.
    ///
    /// One value, or one per velocity, separated by commas. RATIO:ROTOR, such as 100:1e-5kg·m², is the ratio of the gear and the inertia of the
    /// rotor about its own axis: ratio² · inertia is added. --gear is the same flag.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT=VALUE", value_parser = named::joint_armature, alias = "gear"))]
    #[serde(with = "value::named_armatures", skip_serializing_if = "Vec::is_empty")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub armature: Vec<(String, Vec<f64>)>,
    /// Stiffness, and damping if given, of the gear between the rotor of a joint and the joint: K or K,D.
    ///
    /// N·m/rad and N·m·s/rad (N/m and N·s/m for a slide), at the output of the gear, or with units (N·m/deg); the rotor is the armature of the
    /// joint. `percuss mass`, `percuss response` and `percuss impact --in-time --compliance` compute with elastic gears; all other results have
    /// rigid gears. A spring parallel to a joint is `--joint-spring` of an impact in time.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT=K,D", value_parser = named::gear_stiffness))]
    #[serde(
        deserialize_with = "drives::by_joint",
        serialize_with = "value::by_name_texts",
        skip_serializing_if = "Vec::is_empty"
    )]
    #[schemars(with = "BTreeMap<String, OneOrMany<NumberOrText>>")]
    pub gear_stiffness: Vec<(String, GivenSpring)>,
    /// Root link fixed or floating; default: fixed.
    #[cfg_attr(feature = "flags", arg(long, value_enum))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base: Option<BaseName>,
}

impl ContactTable {
    /// Contact of a point (m) of a link along a normal, both in the frame of the link.
    pub fn at_point(link: impl Into<String>, point: [f64; 3], normal: [f64; 3]) -> Self {
        let (point, normal) = (Some(Point(point)), Some(Vector(normal)));
        Self { link: Some(link.into()), point, normal, ..Self::default() }
    }

    /// First missing part of the contact.
    pub fn missing(&self) -> Option<&'static str> {
        if self.at.is_some() {
            return None;
        }
        let is_moment = self.about_axis.is_some();
        let normal = self.normal.is_some() || self.along_line.is_some();
        let parts = [
            ("link", self.link.is_some()),
            ("point", self.point.is_some() || is_moment),
            ("normal or along_line", normal || is_moment),
        ];
        parts.into_iter().find(|(_, is_there)| !is_there).map(|(part, _)| part)
    }

    /// Table with checked keys, which may be incomplete. Without a free body, the other side of a cable is the link of its end.
    ///
    /// # Errors
    /// [`InvalidKey`]: keys that exclude each other.
    pub(crate) fn checked(&self) -> Result<Self, InvalidKey> {
        self.check_axis()?;
        let refuse = |key, why| Err(InvalidKey::new(key, why));
        let has_line = self.along_line.is_some();
        if self.turning_normal && !has_line {
            return refuse("contact.turning_normal", "it requires `along_line`");
        }
        if self.cable && !has_line {
            return refuse("contact.cable", "it requires `along_line`");
        }
        if self.cable && self.turning_normal {
            return refuse("contact", "give either `cable` or `turning_normal`");
        }
        if has_line && self.normal.is_some() {
            return refuse("contact", "give either `normal` or `along_line`");
        }
        let with_normal = Self { normal: None, normal_frame: None, ..self.clone() };
        if self.at.is_some() && (!with_normal.has_no_geometry() || self.against.is_some()) {
            let why = "it names a contact of the model: remove `link`, `point`, `along_line`, `about_axis`, `frame` and `against`";
            return refuse("contact.at", why);
        }
        if self.against.is_some() && self.against_mass.is_some() {
            return refuse("contact", "give either `against` or `against_mass`");
        }
        if self.estimate.as_ref().is_some_and(|estimate| estimate.links.is_empty()) {
            return refuse("contact.estimate.links", "it is empty; name at least one link");
        }
        let end = self.along_line.as_ref().filter(|_| self.cable && self.against_mass.is_none());
        let against = self.against.clone().or(end.map(|line| line.link.clone()));
        Ok(Self { against, ..self.clone() })
    }

    /// Refuses keys that exclude a moment about an axis.
    fn check_axis(&self) -> Result<(), InvalidKey> {
        let others = [
            ("point", self.point.is_some()),
            ("normal", self.normal.is_some()),
            ("along_line", self.along_line.is_some()),
            ("turning_normal", self.turning_normal),
            ("cable", self.cable),
            ("against_mass", self.against_mass.is_some()),
            ("estimate", self.estimate.is_some()),
        ];
        match others.into_iter().find(|(_, is_given)| *is_given && self.about_axis.is_some()) {
            Some((key, _)) => {
                let why = format!(
                    "the contact is a moment about an axis: remove `{key}`, or give a point and a normal instead of `about_axis`"
                );
                Err(InvalidKey::with_names("contact.about_axis", why))
            }
            None => Ok(()),
        }
    }

    /// True if the contact has no own data: no name, link, point, normal or frame.
    pub fn is_empty(&self) -> bool {
        self.at.is_none() && self.has_no_geometry()
    }

    /// True without link, point, normal and frame.
    fn has_no_geometry(&self) -> bool {
        let other = Self {
            at: self.at.clone(),
            against: self.against.clone(),
            name: self.name.clone(),
            ..self.without_geometry()
        };
        *self == other
    }

    /// Table without a contact: the free body on the other side, the estimate and the motion ratios.
    pub(crate) fn without_geometry(&self) -> Self {
        let (against_mass, estimate, ratio_at) =
            (self.against_mass, self.estimate.clone(), self.ratio_at.clone());
        Self { against_mass, estimate, ratio_at, ..Self::default() }
    }

    /// Name of the contact link; empty without a link.
    pub(crate) fn link(&self) -> &str {
        self.link.as_deref().unwrap_or_default()
    }

    /// The contact point, m, in its frame.
    pub(crate) fn point(&self) -> [f64; 3] {
        self.point.unwrap_or_default().0
    }

    /// Frame of the point. For a moment, `frame` is the frame of the axis, and the unused point has the link frame.
    pub(crate) fn frame(&self) -> Frame {
        if self.about_axis.is_some() { Frame::Link } else { self.frame.unwrap_or_default().into() }
    }

    /// Frame of a normal or an axis.
    pub(crate) fn normal_frame(&self) -> Frame {
        self.normal_frame.or(self.frame).unwrap_or_default().into()
    }

    /// True if the table has a normal of its own, an axis or a line.
    pub(crate) fn has_normal(&self) -> bool {
        let is_given = self.normal.is_some_and(|normal| normal.0 != [0.0; 3]);
        is_given || self.about_axis.is_some() || self.along_line.is_some()
    }

    /// Mass of the free body on the other side, kg.
    pub(crate) fn against_mass(&self) -> Option<f64> {
        self.against_mass.map(|mass| mass.0)
    }

    /// Normal, or axis of a moment.
    ///
    /// # Errors
    /// Unknown link of a line.
    pub(crate) fn direction(&self, mechanism: &Mechanism) -> Result<Direction, StudyError> {
        let Some(line) = &self.along_line else {
            return Ok(match self.about_axis {
                Some(axis) => Direction::About(axis.0.into(), self.normal_frame()),
                None => Direction::Along(self.normal.unwrap_or_default().0.into(), self.normal_frame()),
            });
        };
        let link = mechanism.find_link(&line.link).map_err(StudyError::about("contact.along_line"))?;
        let direction = match (self.cable, self.turning_normal) {
            (true, _) => Direction::TurningAwayFrom,
            (_, true) => Direction::TurningToward,
            _ => Direction::Toward,
        };
        Ok(direction(link, line.point.0.into()))
    }

    /// The table with another normal or axis; the other side remains.
    pub(crate) fn with_direction(&self, direction: Direction, name: impl Fn(LinkId) -> String) -> Self {
        let mut table = Self {
            point: self.point,
            link: self.link.clone(),
            at: self.at.clone(),
            name: self.name.clone(),
            frame: Some(self.frame().into()),
            against: self.against.clone(),
            ..self.without_geometry()
        };
        let line =
            |link, point: Vector3<f64>| Some(LinkPoint { link: name(link), point: Point(point.into()) });
        match direction {
            Direction::Along(normal, frame) => {
                (table.normal, table.normal_frame) = (Some(Vector(normal.into())), Some(frame.into()));
            }
            Direction::About(axis, frame) => {
                (table.about_axis, table.normal_frame) = (Some(Vector(axis.into())), Some(frame.into()));
            }
            Direction::Toward(link, point) => table.along_line = line(link, point),
            Direction::TurningToward(link, point) => {
                (table.along_line, table.turning_normal) = (line(link, point), true);
            }
            Direction::TurningAwayFrom(link, point) => {
                (table.along_line, table.cable) = (line(link, point), true);
            }
        }
        table
    }

    /// The table with another normal; the other side remains.
    pub(crate) fn with_normal(&self, normal: [f64; 3], frame: Frame) -> Self {
        self.with_direction(Direction::Along(normal.into(), frame), |_| String::new())
    }

    /// The table with the link, point, normal and other side of a contact of a mechanism.
    pub fn with_contact(&self, contact: &Contact, mechanism: &Mechanism) -> Self {
        let name = |link| mechanism.link(link).name().to_owned();
        Self {
            link: Some(name(contact.link)),
            point: Some(Point(contact.point.into())),
            frame: None,
            against: contact.against.map(name),
            ..self.with_direction(contact.normal, name)
        }
    }
}

impl ConditionsTable {
    /// Root link fixed or floating.
    pub(crate) fn base(&self) -> Base {
        self.base.unwrap_or_default().into()
    }
}
