//! A study in a file: the flags of `percuss mass` and `percuss sweep`, kept.

use crate::damping::DampingQuestion;
use crate::question::{EstimateQuestion, Hold, MassQuestion, Normal};
use crate::sweep::Vary;
use crate::{DiagnosticRecord, Input, Model, study_value};
use nalgebra::Vector3;
use percuss_contact::exports::Tool;
use percuss_contact::{Law, Separation};
use percuss_dynamics::{Base, Frame};
use percuss_formats::{LoadError, LoadOptions, Source};
use percuss_mechanism::{Accept, BuildError, ClosureDescription, ClosureKind, Severity, Subject};
use percuss_spatial::{Transform, rotation_from_rpy};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// A study, read but not yet run.
#[derive(Clone, Debug)]
pub struct StudyFile {
    /// The model with the study's closures.
    pub model: Model,
    /// The contact and the conditions.
    pub question: MassQuestion,
    /// The damper to give, if a restitution is asked for.
    pub damping: Option<DampingQuestion>,
    /// The range to go through, if any.
    pub sweep: Option<Vary>,
    /// Where the sweep's rows go, relative to the study file; none: stdout.
    pub output: Option<String>,
}

/// A study that cannot be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyFileError {
    /// The study, or the model it names, cannot be read.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// It is not UTF-8 text.
    #[error("{path}: error: not UTF-8 text; a study is a TOML file")]
    NotText {
        /// The file.
        path: String,
    },
    /// It is no TOML, or has keys that mean nothing; the message says where.
    #[error("{path}: error: {message}")]
    Toml {
        /// The file.
        path: String,
        /// What and where.
        message: String,
    },
    /// A value that cannot be.
    #[error("{path}: error: {key}: {why}")]
    Value {
        /// The file.
        path: String,
        /// The key.
        key: &'static str,
        /// What is wrong.
        why: String,
    },
    /// The model with the study's closures is none.
    #[error("{path}: error: {source}")]
    Build {
        /// The file.
        path: String,
        /// What the builder found.
        source: BuildError,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Text {
    model: ModelText,
    #[serde(default)]
    conditions: ConditionsText,
    #[serde(default)]
    pose: PoseText,
    contact: ContactText,
    #[serde(default)]
    closure: Vec<ClosureText>,
    #[serde(default)]
    hold: Vec<HoldText>,
    damping: Option<DampingText>,
    sweep: Option<SweepText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ModelText {
    path: String,
    #[serde(default)]
    accept: Vec<String>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct ConditionsText {
    base: Option<String>,
    #[serde(default)]
    lock: Vec<String>,
    #[serde(default)]
    armature: BTreeMap<String, OneOrMany>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct PoseText {
    #[serde(default)]
    set: BTreeMap<String, Typed>,
    #[serde(default)]
    guess: BTreeMap<String, Typed>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ContactText {
    link: String,
    #[serde(deserialize_with = "study_value::lengths")]
    point: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    normal: Option<[f64; 3]>,
    along_line: Option<LineText>,
    frame: Option<String>,
    normal_frame: Option<String>,
    against: Option<String>,
    #[serde(default, deserialize_with = "study_value::mass")]
    against_mass: Option<f64>,
    estimate: Option<EstimateText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LineText {
    link: String,
    #[serde(deserialize_with = "study_value::lengths")]
    point: [f64; 3],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EstimateText {
    links: Vec<String>,
    #[serde(default, deserialize_with = "study_value::lengths")]
    point: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    direction: Option<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DampingText {
    #[serde(deserialize_with = "study_value::ratio")]
    restitution: f64,
    #[serde(deserialize_with = "study_value::stiffness")]
    stiffness: f64,
    exponent: Option<f64>,
    #[serde(default, deserialize_with = "study_value::speed")]
    speed: Option<f64>,
    #[serde(default = "kelvin_voigt")]
    law: String,
    separation: Option<String>,
    #[serde(default, rename = "for", deserialize_with = "study_value::words")]
    tools: Vec<String>,
    accuracy: Option<f64>,
    #[serde(default, deserialize_with = "study_value::time")]
    time_step: Option<f64>,
    #[serde(default, deserialize_with = "study_value::mass")]
    own_mass: Option<f64>,
}

fn kelvin_voigt() -> String {
    Law::KelvinVoigt.name().to_owned()
}

impl DampingText {
    /// As a question, or the key that is wrong and why.
    fn question(&self) -> Result<DampingQuestion, (&'static str, String)> {
        let mut question = DampingQuestion::new(self.restitution, self.stiffness);
        let end = |word: &String| {
            let known = Separation::ALL.into_iter().find(|s| s.name() == word);
            known.ok_or_else(|| ("damping.separation", format!("\"{word}\"; wanted force or gap")))
        };
        let separation = self.separation.as_ref().map(end).transpose()?;
        question.choose(&self.law, self.exponent, separation).map_err(|e| ("damping.law", e.to_string()))?;
        question.speed = self.speed;
        question.options.accuracy = self.accuracy.unwrap_or(question.options.accuracy);
        question.options.time_step = self.time_step;
        question.options.own_mass = self.own_mass;
        for tool in &self.tools {
            match tool.as_str() {
                "all" => question.tools.extend(Tool::ALL),
                name => {
                    question.tools.push(Tool::from_name(name).map_err(|e| ("damping.for", e.to_string()))?)
                }
            }
        }
        Ok(question)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct HoldText {
    link: String,
    #[serde(deserialize_with = "study_value::lengths")]
    point: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    normal: Option<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ClosureText {
    name: String,
    #[serde(rename = "type")]
    kind: String,
    predecessor: String,
    #[serde(default, deserialize_with = "study_value::lengths")]
    predecessor_xyz: [f64; 3],
    #[serde(default, deserialize_with = "study_value::angles")]
    predecessor_rpy: [f64; 3],
    successor: String,
    #[serde(default, deserialize_with = "study_value::lengths")]
    successor_xyz: [f64; 3],
    #[serde(default, deserialize_with = "study_value::angles")]
    successor_rpy: [f64; 3],
    #[serde(default, deserialize_with = "study_value::plain")]
    axis: Option<[f64; 3]>,
    #[serde(default, deserialize_with = "study_value::plain")]
    axis2: Option<[f64; 3]>,
    #[serde(default, deserialize_with = "study_value::length")]
    distance: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SweepText {
    vary: String,
    output: Option<String>,
}

/// A position: a number, numbers, or text with units.
#[derive(Deserialize)]
#[serde(untagged, expecting = "a number, a list of numbers, or text with units")]
enum Typed {
    Text(String),
    One(f64),
    Many(Vec<f64>),
}

#[derive(Deserialize)]
#[serde(untagged, expecting = "a number, or a list of numbers")]
enum OneOrMany {
    One(f64),
    Many(Vec<f64>),
}

impl Typed {
    fn text(&self) -> String {
        match self {
            Typed::Text(text) => text.clone(),
            Typed::One(x) => x.to_string(),
            Typed::Many(xs) => xs.iter().map(f64::to_string).collect::<Vec<_>>().join(","),
        }
    }
}

impl StudyFile {
    /// Reads a study and the model it names (relative to the study's folder). At most `max_size` bytes each.
    ///
    /// # Errors
    /// [`StudyFileError`]: files that cannot be read, keys that mean nothing, values that cannot be.
    pub fn load(path: &str, max_size: u64) -> Result<Self, StudyFileError> {
        let source = Source::read(path, max_size)?;
        let path = source.name.clone();
        let text = String::from_utf8(source.bytes.clone())
            .map_err(|_| StudyFileError::NotText { path: path.clone() })?;
        let study: Text = toml::from_str(&text).map_err(|e| StudyFileError::Toml {
            path: path.clone(),
            message: e.to_string().trim().to_owned(),
        })?;
        let value = |key: &'static str, why: String| StudyFileError::Value { path: path.clone(), key, why };
        let mut accept = Accept::default();
        for word in &study.model.accept {
            match word.as_str() {
                "indefinite-inertia" => accept.indefinite_inertia = true,
                _ => {
                    return Err(value(
                        "model.accept",
                        format!("\"{word}\"; known is \"indefinite-inertia\""),
                    ));
                }
            }
        }
        let folder = Path::new(&path).parent().unwrap_or(Path::new(""));
        let model_path = folder.join(&study.model.path);
        let mut model = Model::load(&model_path.to_string_lossy(), max_size, &LoadOptions { accept })?;
        model.inputs.push(Input::of(&source));
        if !study.closure.is_empty() {
            let closures = study.closure.iter().map(|c| c.describe(&value)).collect::<Result<Vec<_>, _>>()?;
            model = with_closures(model, &path, closures)
                .map_err(|source| StudyFileError::Build { path: path.clone(), source })?;
        }
        let question = study.question(&value)?;
        let damping = study.damping.as_ref().map(DampingText::question).transpose();
        let damping = damping.map_err(|(key, why)| value(key, why))?;
        let sweep = study
            .sweep
            .as_ref()
            .map(|s| Vary::parse(&s.vary))
            .transpose()
            .map_err(|why| value("sweep.vary", why))?;
        let output =
            study.sweep.and_then(|s| s.output).map(|o| folder.join(o).to_string_lossy().into_owned());
        Ok(Self { model, question, damping, sweep, output })
    }
}

type Refuse<'a> = dyn Fn(&'static str, String) -> StudyFileError + 'a;

impl Text {
    fn question(&self, value: &Refuse) -> Result<MassQuestion, StudyFileError> {
        let contact = &self.contact;
        let normal = match (&contact.along_line, contact.normal) {
            (Some(line), None) => Normal::Toward(line.link.clone(), line.point),
            (None, Some(normal)) => Normal::Along(normal),
            _ => return Err(value("contact", "give either normal or along_line".into())),
        };
        let frame_of = |key: &'static str, name: &Option<String>, default: Frame| match name.as_deref() {
            None => Ok(default),
            Some("link") => Ok(Frame::Link),
            Some("world") => Ok(Frame::World),
            Some("against") => Ok(Frame::Against),
            Some(other) => Err(value(key, format!("\"{other}\"; wanted link, world or against"))),
        };
        let frame = frame_of("contact.frame", &contact.frame, Frame::Link)?;
        let normal_frame = frame_of("contact.normal_frame", &contact.normal_frame, frame)?;
        let base = match self.conditions.base.as_deref() {
            None | Some("fixed") => Base::Fixed,
            Some("floating") => Base::Floating,
            Some(other) => {
                return Err(value("conditions.base", format!("\"{other}\"; wanted fixed or floating")));
            }
        };
        if contact.against.is_some() && contact.against_mass.is_some() {
            return Err(value("contact", "give either against or against_mass".into()));
        }
        let typed = |map: &BTreeMap<String, Typed>| map.iter().map(|(j, v)| (j.clone(), v.text())).collect();
        Ok(MassQuestion {
            link: contact.link.clone(),
            point: contact.point,
            normal,
            frame,
            normal_frame,
            against: contact.against.clone(),
            against_mass: contact.against_mass,
            set: typed(&self.pose.set),
            guess: typed(&self.pose.guess),
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
                .map(|(joint, values)| match values {
                    OneOrMany::One(x) => (joint.clone(), vec![*x]),
                    OneOrMany::Many(xs) => (joint.clone(), xs.clone()),
                })
                .collect(),
            base,
            estimate: match &contact.estimate {
                Some(e) if e.links.is_empty() => {
                    return Err(value(
                        "contact.estimate.links",
                        "it is empty; name at least one link".into(),
                    ));
                }
                Some(e) => {
                    Some(EstimateQuestion { links: e.links.clone(), point: e.point, direction: e.direction })
                }
                None => None,
            },
        })
    }
}

impl ClosureText {
    fn describe(&self, value: &Refuse) -> Result<ClosureDescription, StudyFileError> {
        let named = if self.kind == "continuous" { "revolute" } else { &self.kind };
        let Some(kind) = ClosureKind::ALL.into_iter().find(|k| k.name() == named) else {
            let known: Vec<&str> = ClosureKind::ALL.iter().map(|k| k.name()).collect();
            return Err(value("closure.type", format!("\"{}\"; known are {}", self.kind, known.join(", "))));
        };
        let frame = |xyz: [f64; 3], rpy| Transform::new(rotation_from_rpy(rpy), xyz.into());
        let mut closure = ClosureDescription::new(&self.name, kind, &self.predecessor, &self.successor);
        closure.predecessor_frame = frame(self.predecessor_xyz, self.predecessor_rpy);
        closure.successor_frame = frame(self.successor_xyz, self.successor_rpy);
        closure.axis = self.axis.map_or(closure.axis, Vector3::from);
        closure.axis2 = self.axis2.map_or(closure.axis2, Vector3::from);
        closure.distance = self.distance;
        Ok(closure)
    }
}

/// The model with more closures than its file has, and what is to be said of them.
fn with_closures(model: Model, path: &str, closures: Vec<ClosureDescription>) -> Result<Model, BuildError> {
    let of_file = model.mechanism.closures().len();
    let mut diagnostics = model.diagnostics;
    for closure in closures.iter().filter(|c| c.kind == ClosureKind::Distance && c.distance.is_none()) {
        let message =
            format!("loop \"{}\" has no distance: the distance with all joints at 0 is taken", closure.name);
        let record = DiagnosticRecord::about_answer(Severity::Note, "default-distance", message);
        diagnostics.push(DiagnosticRecord { path: Some(path.to_owned()), ..record });
    }
    // Nothing in the file bound these; the study's closures may.
    diagnostics.retain(|d| d.code != "unbound-joint");
    let builder = closures.into_iter().fold(model.mechanism.to_builder(), |b, closure| b.closure(closure));
    let built = builder.build()?;
    // What the builder finds about the rest was told with its place when the file was read.
    for (subject, problem) in built.findings {
        if matches!(subject, Subject::Closure { index, .. } if index >= of_file) {
            let message = format!("{subject}: {problem}");
            let record = DiagnosticRecord::about_answer(problem.severity(), problem.code(), message);
            diagnostics.push(DiagnosticRecord { path: Some(path.to_owned()), ..record });
        }
    }
    Ok(Model { mechanism: std::sync::Arc::new(built.mechanism), diagnostics, ..model })
}
