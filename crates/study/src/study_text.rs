//! The text of a study file: its keys, and what they mean.

use crate::closure_text::ClosureText;
use crate::damping_question::DampingQuestion;
use crate::field::Names;
use crate::given_pose::GivenPose;
use crate::given_travel::GivenTravel;
use crate::position::GivenPosition;
use crate::question::{EstimateQuestion, Hold, MassQuestion, Normal, RatioPoint, UPWARDS};
use crate::refusal::Refusal;
use crate::row_source::{PositionFile, RowSource};
use crate::study_value;
use crate::variant::VariantText;
use crate::vary::Vary;
use percuss_contact::exports::Tool;
use percuss_contact::{Law, Separation};
use percuss_dynamics::{Base, Frame};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StudyText {
    pub model: ModelText,
    #[serde(default)]
    pub conditions: ConditionsText,
    #[serde(default)]
    pub pose: PoseText,
    pub contact: ContactText,
    #[serde(default)]
    pub closure: Vec<ClosureText>,
    #[serde(default)]
    pub hold: Vec<HoldText>,
    #[serde(default)]
    pub variant: Vec<VariantText>,
    pub damping: Option<DampingText>,
    pub sweep: Option<SweepText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ModelText {
    pub path: String,
    #[serde(default)]
    pub accept: Vec<String>,
    #[serde(default, deserialize_with = "study_value::masses")]
    pub link_mass: BTreeMap<String, f64>,
    #[serde(default, deserialize_with = "study_value::places")]
    pub link_com: BTreeMap<String, [f64; 3]>,
    #[serde(default, rename = "move", deserialize_with = "study_value::places")]
    pub moves: BTreeMap<String, [f64; 3]>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConditionsText {
    pub base: Option<String>,
    #[serde(default)]
    pub lock: Vec<String>,
    #[serde(default, deserialize_with = "study_value::armatures")]
    pub armature: BTreeMap<String, Vec<f64>>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PoseText {
    #[serde(default, deserialize_with = "study_value::positions")]
    pub set: BTreeMap<String, GivenPosition>,
    #[serde(default, deserialize_with = "study_value::positions")]
    pub guess: BTreeMap<String, GivenPosition>,
    #[serde(default, deserialize_with = "study_value::words")]
    pub travel: Vec<String>,
    pub file: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ContactText {
    pub link: String,
    #[serde(deserialize_with = "study_value::lengths")]
    pub point: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    pub normal: Option<[f64; 3]>,
    pub along_line: Option<LineText>,
    pub frame: Option<String>,
    pub normal_frame: Option<String>,
    pub against: Option<String>,
    #[serde(default, deserialize_with = "study_value::mass")]
    pub against_mass: Option<f64>,
    pub estimate: Option<EstimateText>,
    #[serde(default)]
    pub ratio_at: Vec<RatioText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LineText {
    pub link: String,
    #[serde(deserialize_with = "study_value::lengths")]
    pub point: [f64; 3],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct EstimateText {
    pub links: Vec<String>,
    #[serde(default, deserialize_with = "study_value::lengths")]
    pub point: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    pub direction: Option<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RatioText {
    pub link: String,
    #[serde(default, deserialize_with = "study_value::lengths")]
    pub point: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    pub direction: Option<[f64; 3]>,
}

impl RatioText {
    fn point(&self) -> RatioPoint {
        let direction = self.direction.unwrap_or(UPWARDS);
        RatioPoint { link: self.link.clone(), point: self.point, direction }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DampingText {
    #[serde(deserialize_with = "study_value::ratio")]
    pub restitution: f64,
    #[serde(deserialize_with = "study_value::stiffness")]
    pub stiffness: f64,
    pub exponent: Option<f64>,
    #[serde(default, deserialize_with = "study_value::speed")]
    pub speed: Option<f64>,
    #[serde(default = "kelvin_voigt")]
    pub law: String,
    pub separation: Option<String>,
    #[serde(default, rename = "for", deserialize_with = "study_value::words")]
    pub tools: Vec<String>,
    pub accuracy: Option<f64>,
    #[serde(default, deserialize_with = "study_value::time")]
    pub time_step: Option<f64>,
    #[serde(default, deserialize_with = "study_value::mass")]
    pub own_mass: Option<f64>,
}

fn kelvin_voigt() -> String {
    Law::KelvinVoigt.name().to_owned()
}

impl DampingText {
    /// As a question.
    pub fn question(&self) -> Result<DampingQuestion, Refusal> {
        let mut question = DampingQuestion::new(self.restitution, self.stiffness);
        let end = |word: &String| {
            let known = Separation::ALL.into_iter().find(|s| s.name() == word);
            known.ok_or_else(|| {
                Refusal::new("damping.separation", format!("\"{word}\"; expected force or gap"))
            })
        };
        let separation = self.separation.as_ref().map(end).transpose()?;
        question
            .choose(&self.law, self.exponent, separation)
            .map_err(|e| Refusal::new("damping.law", e.to_string()))?;
        question.speed = self.speed;
        question.options.accuracy = self.accuracy.unwrap_or(question.options.accuracy);
        question.options.time_step = self.time_step;
        question.options.own_mass = self.own_mass;
        for tool in &self.tools {
            match tool.as_str() {
                "all" => question.tools.extend(Tool::ALL),
                name => question
                    .tools
                    .push(Tool::from_name(name).map_err(|e| Refusal::new("damping.for", e.to_string()))?),
            }
        }
        Ok(question)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct HoldText {
    pub link: String,
    #[serde(deserialize_with = "study_value::lengths")]
    pub point: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    pub normal: Option<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SweepText {
    #[serde(default, deserialize_with = "study_value::words")]
    pub vary: Vec<String>,
    pub input: Option<String>,
    #[serde(default, deserialize_with = "study_value::words")]
    pub ignore: Vec<String>,
    pub random: Option<usize>,
    pub seed: Option<u64>,
    pub output: Option<String>,
}

impl SweepText {
    /// Where the rows come from. Paths are relative to the study's folder.
    pub fn source(&self, folder: &Path, max_size: u64) -> Result<RowSource, Refusal> {
        let refuse = |why: &str| Err(Refusal::new("sweep", why));
        if self.input.is_none() && !self.ignore.is_empty() {
            return refuse("ignore leaves out columns of input; give input");
        }
        if self.random.is_none() && self.seed.is_some() {
            return refuse("seed is that of random; give random");
        }
        match (&self.vary[..], &self.input, self.random) {
            ([_, ..], None, None) => {
                let range = |text: &String| {
                    Vary::parse(text).map_err(|error| Refusal::new("sweep.vary", error.to_string()))
                };
                self.vary.iter().map(range).collect::<Result<_, _>>().map(RowSource::Grid)
            }
            ([], Some(path), None) => {
                let path = folder.join(path).to_string_lossy().into_owned();
                Ok(RowSource::File(PositionFile { path, ignore: self.ignore.clone(), max_size }))
            }
            ([], None, Some(count)) => Ok(RowSource::Random { count, seed: self.seed.unwrap_or_default() }),
            _ => refuse("give one of vary, input and random"),
        }
    }
}

impl StudyText {
    /// The question. Paths are relative to the study's folder.
    pub fn question(&self, folder: &Path, max_size: u64) -> Result<MassQuestion, Refusal> {
        let contact = &self.contact;
        let travel = |text: &String| {
            GivenTravel::parse(text)
                .map_err(|error| Refusal::new("pose.travel", format!("\"{text}\": {error}")))
        };
        let pose = |file: &String| {
            let path = folder.join(file);
            GivenPose::read(&path.to_string_lossy(), max_size)
                .map_err(|error| Refusal::new("pose.file", error.to_string()))
        };
        let normal = match (&contact.along_line, contact.normal) {
            (Some(line), None) => Normal::Toward(line.link.clone(), line.point),
            (None, Some(normal)) => Normal::Along(normal),
            _ => return Err(Refusal::new("contact", "give either normal or along_line")),
        };
        let frame_of = |key: &'static str, name: &Option<String>, default: Frame| match name.as_deref() {
            None => Ok(default),
            Some("link") => Ok(Frame::Link),
            Some("world") => Ok(Frame::World),
            Some("against") => Ok(Frame::Against),
            Some(other) => Err(Refusal::new(key, format!("\"{other}\"; expected link, world or against"))),
        };
        let frame = frame_of("contact.frame", &contact.frame, Frame::Link)?;
        let normal_frame = frame_of("contact.normal_frame", &contact.normal_frame, frame)?;
        let base = match self.conditions.base.as_deref() {
            None | Some("fixed") => Base::Fixed,
            Some("floating") => Base::Floating,
            Some(other) => {
                return Err(Refusal::new(
                    "conditions.base",
                    format!("\"{other}\"; expected fixed or floating"),
                ));
            }
        };
        if contact.against.is_some() && contact.against_mass.is_some() {
            return Err(Refusal::new("contact", "give either against or against_mass"));
        }
        let given = |map: &BTreeMap<String, GivenPosition>| {
            map.iter().map(|(joint, position)| (joint.clone(), position.clone())).collect()
        };
        Ok(MassQuestion {
            link: contact.link.clone(),
            point: contact.point,
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
            hold: self
                .hold
                .iter()
                .map(|h| Hold { link: h.link.clone(), point: h.point, normal: h.normal })
                .collect(),
            armature: self
                .conditions
                .armature
                .iter()
                .map(|(joint, values)| (joint.clone(), values.clone()))
                .collect(),
            base,
            estimate: match &contact.estimate {
                Some(e) if e.links.is_empty() => {
                    return Err(Refusal::new(
                        "contact.estimate.links",
                        "it is empty; name at least one link",
                    ));
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
