//! Tables of a question about a contact: contact, pose, conditions. The command line has a flag for each key.

#[cfg(feature = "flags")]
use super::headings::{ADDITIONAL, CONDITIONS, CONTACT, POSE};
use crate::model::loading::refuse_pipe;
use crate::question::errors::refusal::InvalidKey;
use crate::question::field::{Field, Names};
use crate::question::mass_question::{EstimateQuestion, Hold, MassQuestion, Normal, RatioPoint};
use crate::question::pose_file::GivenPose;
use crate::question::row_source::path_in;
use crate::question::travel::given_travel::GivenTravel;
use crate::values::drives::{self, GivenSpring};
#[cfg(feature = "flags")]
use crate::values::named;
use crate::values::position::GivenPosition;
use crate::values::quantities::{LinkPoint, Point, PositiveMass, Vector};
use crate::values::value::{self, NumberOrText, OneOrMany, PositionText, Words};
use percuss_dynamics::{Base, Frame};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Display;
use std::path::Path;

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
#[cfg_attr(feature = "flags", derive(clap::Args))]
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
        arg(
            long,
            value_name = "NAME",
            conflicts_with_all = ["link", "point", "along_line", "about_axis", "frame", "against"],
            help_heading = CONTACT
        )
    )]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<String>,
    /// Contact link.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK", help_heading = CONTACT))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
    /// Contact point (m).
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, help_heading = CONTACT)
    )]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point: Option<Point>,
    /// Contact normal, out of the contact link.
    ///
    /// The normal points into the other body. Its length and its sign do not affect the effective mass.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "X,Y,Z",
            allow_hyphen_values = true,
            conflicts_with = "along_line",
            help_heading = CONTACT
        )
    )]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal: Option<Vector>,
    /// Instead of a point and a normal: a moment about an axis. The result is an inertia, kg·m².
    ///
    /// The two sides act on each other by a moment about this axis (a couple), as at a rotational stop or in a clutch. The result is the
    /// effective inertia: kg·m² in place of kg, rad/s in place of m/s, N·m·s in place of N·s. The length of the axis has no effect.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "X,Y,Z",
            allow_hyphen_values = true,
            conflicts_with_all = ["point", "normal", "along_line", "against_mass", "estimate"],
            help_heading = CONTACT
        )
    )]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub about_axis: Option<Vector>,
    /// Instead of a normal: towards a point of a link.
    ///
    /// The normal points from the contact point towards this point of a link (m, in the frame of that link). Use it
    /// for the line of a spring, or for a stop near the design pose. For a stop over a travel, use a normal.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK:X,Y,Z", help_heading = CONTACT))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub along_line: Option<LinkPoint>,
    /// Allow the line to rotate: a spring, a damper or a rod.
    ///
    /// Otherwise, a pose is refused if the line has rotated by more than 5° relative to the other body since
    /// the design pose (all joints at 0), because the line is then no longer the normal of a stop. A line shorter
    /// than a tenth of its length in the design pose is always refused.
    #[cfg_attr(feature = "flags", arg(long, requires = "along_line", help_heading = CONTACT))]
    pub turning_normal: bool,
    /// The line is a cable: it resists lengthening, and may rotate.
    ///
    /// The gap closes while the cable gets longer; the impulse of an impact pulls. Without another link in contact, the other side is the
    /// link of the line.
    #[cfg_attr(
        feature = "flags",
        arg(long, requires = "along_line", conflicts_with = "turning_normal", help_heading = CONTACT)
    )]
    pub cable: bool,
    /// Frame of the point and the normal or the axis; default: link.
    ///
    /// Applies to both. A point given in another frame is converted to the link frame once, at the set pose with
    /// all varied joints at 0, and then moves with the link. A normal stays constant in the given frame.
    #[cfg_attr(feature = "flags", arg(long, value_enum, help_heading = CONTACT))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frame: Option<FrameName>,
    /// Frame of the normal, if different from the frame of the point.
    #[cfg_attr(feature = "flags", arg(long, value_enum, help_heading = CONTACT))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal_frame: Option<FrameName>,
    /// Other link in contact; default: the ground.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK", help_heading = CONTACT))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against: Option<String>,
    /// Mass (kg) of a free body as the other side of the contact.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "KG",
            allow_hyphen_values = true,
            conflicts_with = "against",
            help_heading = CONTACT
        )
    )]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against_mass: Option<PositiveMass>,
    /// Classical estimate, shown with the result.
    ///
    /// The total mass of these links is reduced to the contact by the motion ratio of point A (m, frame of the first
    /// link; default: its origin) along a direction (world axes; default: upwards in a suspension, otherwise the
    /// path of A).
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]]", help_heading = ADDITIONAL)
    )]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimate: Option<EstimateQuestion>,
    /// Motion ratio at this point (m, link frame), along a direction (world axes; default z).
    ///
    /// The ratio relates the speed of the point to the closing speed of the contact. If the model has a wheel and one
    /// degree of freedom, the ratios of the wheel centre and the contact patch are always shown.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "LINK:X,Y,Z[:DX,DY,DZ]", help_heading = ADDITIONAL)
    )]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub ratio_at: Vec<RatioPoint>,
}

/// Pose of a question.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct PoseTable {
    /// Position of a driving joint (m, rad; 30deg, 5mm).
    ///
    /// Driving joints without a position are at 0. Spherical: w,x,y,z; planar: x,y,angle; floating: x,y,z,w,x,y,z.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=VALUE", value_parser = named::joint_position, help_heading = POSE)
    )]
    #[serde(
        deserialize_with = "value::positions",
        serialize_with = "value::by_name_texts",
        skip_serializing_if = "Vec::is_empty"
    )]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub set: Vec<(String, GivenPosition)>,
    /// Initial guess of a joint that depends on other joints through loops; selects the assembly mode.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=VALUE", value_parser = named::joint_position, help_heading = POSE)
    )]
    #[serde(
        deserialize_with = "value::positions",
        serialize_with = "value::by_name_texts",
        skip_serializing_if = "Vec::is_empty"
    )]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub guess: Vec<(String, GivenPosition)>,
    /// Move the mechanism until a point has this travel.
    ///
    /// The point of a link (m, link frame) moves by DISTANCE along a direction (world axes) from its position in the
    /// set pose, as in a sweep over a travel. Give one travel for each driven point.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "LINK:X,Y,Z:DX,DY,DZ=DISTANCE", help_heading = POSE)
    )]
    #[serde(
        deserialize_with = "value::words",
        serialize_with = "value::texts",
        skip_serializing_if = "Vec::is_empty"
    )]
    #[schemars(with = "Option<Words>")]
    pub travel: Vec<GivenTravel>,
    /// Complete configuration: output of --format json, JSON with a position for each joint, or the name of a pose of the model
    /// (keyframe of MJCF, listed by `percuss check`). Set positions and guesses override it.
    #[cfg_attr(feature = "flags", arg(long = "pose", id = "pose", value_name = "FILE.json|NAME", help_heading = POSE))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
}

/// Conditions of a question.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct ConditionsTable {
    /// Lock a joint at its position; all locks every joint.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT", help_heading = CONDITIONS))]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub lock: Vec<String>,
    /// Rotor inertia reflected to a joint (kg·m² or kg): a value, or RATIO:ROTOR.
    ///
    /// One value, or one per velocity, separated by commas. RATIO:ROTOR, such as 100:1e-5kg·m², is the ratio of the gear and the inertia of the
    /// rotor about its own axis: ratio² · inertia is added. --gear is the same flag.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=VALUE", value_parser = named::joint_armature, alias = "gear", help_heading = CONDITIONS)
    )]
    #[serde(
        deserialize_with = "value::armatures",
        serialize_with = "value::by_name_entries",
        skip_serializing_if = "Vec::is_empty"
    )]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub armature: Vec<(String, Vec<f64>)>,
    /// Stiffness, and damping if given, of the gear between the rotor of a joint and the joint: K or K,D.
    ///
    /// N·m/rad and N·m·s/rad (N/m and N·s/m for a slide), at the output of the gear, or with units (N·m/deg); the rotor is the armature of the
    /// joint. `percuss mass`, `percuss response` and `percuss impact --in-time --compliance` compute with elastic gears; all other results have
    /// rigid gears. A spring parallel to a joint is `--joint-spring` of an impact in time.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=K,D", value_parser = named::gear_stiffness, help_heading = CONDITIONS)
    )]
    #[serde(
        deserialize_with = "drives::by_joint",
        serialize_with = "value::by_name_texts",
        skip_serializing_if = "Vec::is_empty"
    )]
    #[schemars(with = "BTreeMap<String, OneOrMany<NumberOrText>>")]
    pub gear_stiffness: Vec<(String, GivenSpring)>,
    /// Root link fixed or floating; default: fixed.
    #[cfg_attr(feature = "flags", arg(long, value_enum, help_heading = CONDITIONS))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base: Option<BaseName>,
}

impl ContactTable {
    /// Question at this contact, which may be incomplete, with its pose, conditions and held points. Paths are relative to `folder`; a pose
    /// file has at most `max_size` bytes.
    ///
    /// # Errors
    /// [`InvalidKey`]: keys that exclude each other, or an unreadable file of positions.
    pub fn question(
        &self,
        pose: &PoseTable,
        conditions: &ConditionsTable,
        hold: &[Hold],
        folder: &Path,
        max_size: u64,
        names: Names,
    ) -> Result<MassQuestion, InvalidKey> {
        let read = |file: &String| {
            // The standard input and absolute paths are kept.
            let path = path_in(folder, file);
            let refuse = |error: &dyn Display| InvalidKey::new(Field::Pose.key(), error.to_string());
            if matches!(names, Names::Keys(_)) {
                refuse_pipe(&path).map_err(|error| refuse(&error))?;
            }
            GivenPose::read_as(&path, file, max_size).map_err(|error| refuse(&error))
        };
        let mut question = MassQuestion {
            set: pose.set.clone(),
            guess: pose.guess.clone(),
            pose: pose.file.as_ref().map(read).transpose()?,
            travel: pose.travel.clone(),
            lock: conditions.lock.clone(),
            hold: hold.to_vec(),
            armature: conditions.armature.clone(),
            gear_stiffness: conditions.gear_stiffness.clone(),
            base: conditions.base.unwrap_or_default().into(),
            names,
            ..MassQuestion::without_contact()
        };
        self.apply_to(&mut question)?;
        Ok(question)
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

    /// Replaces the contact of a question; the contact may be incomplete.
    ///
    /// # Errors
    /// [`InvalidKey`]: keys that exclude each other.
    pub(crate) fn apply_to(&self, question: &mut MassQuestion) -> Result<(), InvalidKey> {
        self.check_axis()?;
        let normal = match (&self.along_line, self.normal) {
            (None, None) if self.about_axis.is_some() => Normal::About(self.about_axis.unwrap_or_default().0),
            (None, _) if self.turning_normal => {
                return Err(InvalidKey::new("contact.turning_normal", "it requires `along_line`"));
            }
            (None, _) if self.cable => {
                return Err(InvalidKey::new("contact.cable", "it requires `along_line`"));
            }
            (Some(_), _) if self.cable && self.turning_normal => {
                return Err(InvalidKey::new("contact", "give either `cable` or `turning_normal`"));
            }
            (Some(line), None) if self.cable => Normal::TurningAwayFrom(line.link.clone(), line.point.0),
            (Some(line), None) if self.turning_normal => {
                Normal::TurningToward(line.link.clone(), line.point.0)
            }
            (Some(line), None) => Normal::Toward(line.link.clone(), line.point.0),
            (None, normal) => Normal::Along(normal.unwrap_or_default().0),
            (Some(_), Some(_)) => {
                return Err(InvalidKey::new("contact", "give either `normal` or `along_line`"));
            }
        };
        let with_normal = Self { normal: None, normal_frame: None, ..self.clone() };
        if self.at.is_some() && (!with_normal.has_no_geometry() || self.against.is_some()) {
            let why = "it names a contact of the model: remove `link`, `point`, `along_line`, `about_axis`, `frame` and `against`";
            return Err(InvalidKey::new("contact.at", why));
        }
        if self.against.is_some() && self.against_mass.is_some() {
            return Err(InvalidKey::new("contact", "give either `against` or `against_mass`"));
        }
        if self.estimate.as_ref().is_some_and(|estimate| estimate.links.is_empty()) {
            return Err(InvalidKey::new("contact.estimate.links", "it is empty; name at least one link"));
        }
        let frame = self.frame.unwrap_or_default();
        // For a moment, `frame` is the frame of the axis; the unused point has the link frame.
        let point_frame = if self.about_axis.is_some() { FrameName::Link } else { frame };
        question.at.clone_from(&self.at);
        question.link = self.link.clone().unwrap_or_default();
        question.point = self.point.unwrap_or_default().0;
        question.normal = normal;
        question.frame = point_frame.into();
        question.normal_frame = self.normal_frame.unwrap_or(frame).into();
        let far_end = self.along_line.iter().filter(|_| self.cable && self.against_mass.is_none());
        let far_end = far_end.map(|line| line.link.clone()).next();
        question.against = self.against.clone().or(far_end);
        question.against_mass = self.against_mass.map(|mass| mass.0);
        question.estimate.clone_from(&self.estimate);
        question.ratio_at.clone_from(&self.ratio_at);
        Ok(())
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
        let Self {
            link,
            point,
            normal,
            along_line,
            about_axis,
            turning_normal,
            cable,
            frame,
            normal_frame,
            ..
        } = self;
        link.is_none()
            && point.is_none()
            && normal.is_none()
            && along_line.is_none()
            && about_axis.is_none()
            && !turning_normal
            && !cable
            && frame.is_none()
            && normal_frame.is_none()
    }
}
