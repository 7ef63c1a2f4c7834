//! Text of a study file: all keys. The doc comments are the descriptions in the JSON schema.

use crate::question::errors::refusal::InvalidKey;
use crate::question::field::Names;
use crate::question::mass_question::{EstimateQuestion, Hold, MassQuestion, Normal, RatioPoint, UPWARDS};
use crate::question::pose_file::GivenPose;
use crate::question::travel::given_travel::GivenTravel;
use crate::study_file::closure::ClosureText;
use crate::study_file::damping::DampingText;
use crate::study_file::map::MapText;
use crate::study_file::mass::MassText;
use crate::study_file::safe_speed::SafeSpeedText;
use crate::study_file::sweep::SweepText;
use crate::study_file::variant::VariantText;
use crate::values::position::GivenPosition;
use crate::values::value::{self, NumberOrText, OneOrMany, PositionText, Triple, Words};
use percuss_dynamics::{Base, Frame};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// A study of percuss: questions about a mechanism, kept in a TOML file. Numbers are in SI units; text with a
/// unit is allowed ("350 mm", "30 deg"). Paths are relative to the study.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "percuss study")]
pub(crate) struct StudyText {
    /// The mechanism.
    pub model: ModelText,
    /// The base of the mechanism, locked joints, and armatures.
    #[serde(default)]
    pub conditions: ConditionsText,
    /// The joint positions.
    #[serde(default)]
    pub pose: PoseText,
    /// The contact of the study.
    #[serde(default)]
    pub contact: ContactText,
    /// Options of percuss mass.
    pub mass: Option<MassText>,
    /// Additional loops that are not part of the model.
    #[serde(default)]
    pub closure: Vec<ClosureText>,
    /// Held points.
    #[serde(default)]
    pub hold: Vec<HoldText>,
    /// Design variants of the same question: percuss compare.
    #[serde(default)]
    pub variant: Vec<VariantText>,
    /// The damper that gives a restitution: percuss damp.
    pub damping: Option<DampingText>,
    /// The contact over rows of positions: percuss sweep.
    pub sweep: Option<SweepText>,
    /// The surface of links, or all directions at a point: percuss map.
    pub map: Option<MapText>,
    /// Safe speed of the contact if it may hit a person: percuss safe-speed.
    pub safe_speed: Option<SafeSpeedText>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ModelText {
    /// A URDF, or a suspension's sheet or table.
    pub path: String,
    /// Findings to accept in the model.
    #[serde(default)]
    #[schemars(extend("items" = { "type": "string", "enum": ["indefinite-inertia", "implausible-inertia"] }))]
    pub accept: Vec<String>,
    /// Masses by link in place of the model's, kg; moments about the centre of mass change in proportion.
    #[serde(default, deserialize_with = "value::masses")]
    #[schemars(with = "BTreeMap<String, NumberOrText>")]
    pub link_mass: BTreeMap<String, f64>,
    /// Centres of mass by link in place of the model's, m, in the link's frame.
    #[serde(default, deserialize_with = "value::places")]
    #[schemars(with = "BTreeMap<String, Triple>")]
    pub link_com: BTreeMap<String, [f64; 3]>,
    /// Displacements of hardpoints of a sheet, m, in the sheet's axes.
    #[serde(default, rename = "move", deserialize_with = "value::places")]
    #[schemars(with = "BTreeMap<String, Triple>")]
    pub moves: BTreeMap<String, [f64; 3]>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConditionsText {
    /// The base: fixed or floating root link; default fixed.
    #[schemars(extend("enum" = ["fixed", "floating"]))]
    pub base: Option<String>,
    /// Locked joints.
    #[serde(default)]
    pub lock: Vec<String>,
    /// Rotor inertia reflected to joints, kg·m² or kg; a list for joints with several velocities.
    #[serde(default, deserialize_with = "value::armatures")]
    #[schemars(with = "BTreeMap<String, OneOrMany>")]
    pub armature: BTreeMap<String, Vec<f64>>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PoseText {
    /// Driving joints and their positions, rad or m.
    #[serde(default, deserialize_with = "value::positions")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub set: BTreeMap<String, GivenPosition>,
    /// Initial guesses for joints determined by loops.
    #[serde(default, deserialize_with = "value::positions")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub guess: BTreeMap<String, GivenPosition>,
    /// Travels that drive the pose from the set joint positions: LINK:X,Y,Z:DX,DY,DZ=DISTANCE.
    #[serde(default, deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub travel: Vec<String>,
    /// A file with the positions of all joints, as written by --format json; set and guess take precedence.
    pub file: Option<String>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ContactText {
    /// A named contact of the model, in place of link, point, normal and against; a stop is brought to the touch.
    pub at: Option<String>,
    /// The contact link.
    pub link: Option<String>,
    /// The contact point, m.
    #[serde(default, deserialize_with = "value::some_lengths")]
    #[schemars(with = "Option<Triple>")]
    pub point: Option<[f64; 3]>,
    /// The normal, out of the contact link into the other side, of any length.
    #[serde(default, deserialize_with = "value::plain")]
    #[schemars(with = "Option<Triple>")]
    pub normal: Option<[f64; 3]>,
    /// In place of normal: the normal points from the contact point towards this point.
    pub along_line: Option<LineText>,
    /// Allows the line of along_line to turn by more than 5° from the line as drawn: for a spring, a damper or
    /// a rod.
    #[serde(default)]
    pub turning_normal: bool,
    /// The frame of point and normal; default link.
    #[schemars(extend("enum" = ["link", "world", "against"]))]
    pub frame: Option<String>,
    /// The frame of the normal, if different from frame.
    #[schemars(extend("enum" = ["link", "world", "against"]))]
    pub normal_frame: Option<String>,
    /// The other link; default ground.
    pub against: Option<String>,
    /// In place of against: a free body of this mass, kg.
    #[serde(default, deserialize_with = "value::mass")]
    #[schemars(with = "Option<NumberOrText>")]
    pub against_mass: Option<f64>,
    /// The classical estimate, reported with the result.
    pub estimate: Option<EstimateText>,
    /// Points of motion ratios relative to the contact.
    #[serde(default)]
    pub ratio_at: Vec<RatioText>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LineText {
    /// The link of the point's frame.
    pub link: String,
    /// The point, m.
    #[serde(deserialize_with = "value::lengths")]
    #[schemars(with = "Triple")]
    pub point: [f64; 3],
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct EstimateText {
    /// Links with a mass counted in the estimate.
    pub links: Vec<String>,
    /// Point A, m, in the first link's frame; default origin.
    #[serde(default, deserialize_with = "value::lengths")]
    #[schemars(with = "Option<Triple>")]
    pub point: [f64; 3],
    /// Direction of the counted component of A's velocity, world axes; default full speed.
    #[serde(default, deserialize_with = "value::plain")]
    #[schemars(with = "Option<Triple>")]
    pub direction: Option<[f64; 3]>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RatioText {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    #[serde(default, deserialize_with = "value::lengths")]
    #[schemars(with = "Option<Triple>")]
    pub point: [f64; 3],
    /// Direction of the speed, world axes; default z.
    #[serde(default, deserialize_with = "value::plain")]
    #[schemars(with = "Option<Triple>")]
    pub direction: Option<[f64; 3]>,
}

impl RatioText {
    /// Converts the keys to a point for a motion ratio.
    fn point(&self) -> RatioPoint {
        let direction = self.direction.unwrap_or(UPWARDS);
        RatioPoint { link: self.link.clone(), point: self.point, direction }
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct HoldText {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    #[serde(deserialize_with = "value::lengths")]
    #[schemars(with = "Triple")]
    pub point: [f64; 3],
    /// The normal, world axes, out of the link; without a normal all directions are held.
    #[serde(default, deserialize_with = "value::plain")]
    #[schemars(with = "Option<Triple>")]
    pub normal: Option<[f64; 3]>,
}

impl ContactText {
    /// First missing part of the contact.
    pub fn missing(&self) -> Option<&'static str> {
        if self.at.is_some() {
            return None;
        }
        let normal = self.normal.is_some() || self.along_line.is_some();
        let parts = [
            ("link", self.link.is_some()),
            ("point", self.point.is_some()),
            ("normal or along_line", normal),
        ];
        parts.into_iter().find(|(_, is_there)| !is_there).map(|(part, _)| part)
    }

    /// True if the contact has no own data: no name, link, point, normal or frame.
    pub fn is_empty(&self) -> bool {
        self.at.is_none() && self.has_no_geometry()
    }

    /// True without link, point, normal and frame.
    fn has_no_geometry(&self) -> bool {
        let Self { link, point, normal, along_line, turning_normal, frame, normal_frame, .. } = self;
        link.is_none()
            && point.is_none()
            && normal.is_none()
            && along_line.is_none()
            && !turning_normal
            && frame.is_none()
            && normal_frame.is_none()
    }
}

/// Parses the name of a frame; the default if absent.
fn frame_of(key: &'static str, name: Option<&str>, default: Frame) -> Result<Frame, InvalidKey> {
    match name {
        None => Ok(default),
        Some("link") => Ok(Frame::Link),
        Some("world") => Ok(Frame::World),
        Some("against") => Ok(Frame::Against),
        Some(other) => Err(InvalidKey::new(key, format!("\"{other}\"; expected link, world or against"))),
    }
}

impl StudyText {
    /// Converts the study to a question; the contact may be incomplete. Paths are relative to the study's
    /// folder.
    pub fn question(&self, folder: &Path, max_size: u64) -> Result<MassQuestion, InvalidKey> {
        let contact = &self.contact;
        let travel = |text: &String| {
            GivenTravel::parse(text)
                .map_err(|error| InvalidKey::new("pose.travel", format!("\"{text}\": {error}")))
        };
        let pose = |file: &String| {
            let path = folder.join(file);
            GivenPose::read(&path.to_string_lossy(), max_size)
                .map_err(|error| InvalidKey::new("pose.file", error.to_string()))
        };
        let normal = match (&contact.along_line, contact.normal) {
            (None, _) if contact.turning_normal => {
                return Err(InvalidKey::new("contact.turning_normal", "turning_normal requires along_line"));
            }
            (Some(line), None) if contact.turning_normal => {
                Normal::TurningToward(line.link.clone(), line.point)
            }
            (Some(line), None) => Normal::Toward(line.link.clone(), line.point),
            (None, normal) => Normal::Along(normal.unwrap_or_default()),
            (Some(_), Some(_)) => return Err(InvalidKey::new("contact", "give either normal or along_line")),
        };
        if contact.at.is_some() && (!contact.has_no_geometry() || contact.against.is_some()) {
            let why =
                "at names a contact of the model: remove link, point, normal, along_line, frame and against";
            return Err(InvalidKey::new("contact.at", why));
        }
        let frame = frame_of("contact.frame", contact.frame.as_deref(), Frame::Link)?;
        let normal_frame = frame_of("contact.normal_frame", contact.normal_frame.as_deref(), frame)?;
        let base = match self.conditions.base.as_deref() {
            None | Some("fixed") => Base::Fixed,
            Some("floating") => Base::Floating,
            Some(other) => {
                let why = format!("\"{other}\"; expected fixed or floating");
                return Err(InvalidKey::new("conditions.base", why));
            }
        };
        if contact.against.is_some() && contact.against_mass.is_some() {
            return Err(InvalidKey::new("contact", "give either against or against_mass"));
        }
        let given = |map: &BTreeMap<String, GivenPosition>| {
            map.iter().map(|(joint, position)| (joint.clone(), position.clone())).collect()
        };
        let hold = |h: &HoldText| Hold { link: h.link.clone(), point: h.point, normal: h.normal };
        let armature = |(joint, values): (&String, &Vec<f64>)| (joint.clone(), values.clone());
        Ok(MassQuestion {
            at: contact.at.clone(),
            link: contact.link.clone().unwrap_or_default(),
            point: contact.point.unwrap_or_default(),
            normal,
            frame,
            normal_frame,
            against: contact.against.clone(),
            against_mass: contact.against_mass,
            set: given(&self.pose.set),
            guess: given(&self.pose.guess),
            pose: self.pose.file.as_ref().map(pose).transpose()?,
            travel: self.pose.travel.iter().map(travel).collect::<Result<_, _>>()?,
            lock: self.conditions.lock.clone(),
            hold: self.hold.iter().map(hold).collect(),
            armature: self.conditions.armature.iter().map(armature).collect(),
            base,
            estimate: match &contact.estimate {
                Some(e) if e.links.is_empty() => {
                    let why = "it is empty; name at least one link";
                    return Err(InvalidKey::new("contact.estimate.links", why));
                }
                Some(e) => {
                    Some(EstimateQuestion { links: e.links.clone(), point: e.point, direction: e.direction })
                }
                None => None,
            },
            ratio_at: contact.ratio_at.iter().map(RatioText::point).collect(),
            names: Names::Keys,
        })
    }
}
