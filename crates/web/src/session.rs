//! Session of a page: a model with its changes, and replies to requests.

use crate::request::{QuestionRequest, Request};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use percuss_formats::{DEFAULT_MAX_SIZE, LoadError, LoadOptions, MemoryFiles, Source};
use percuss_study::contact::exports::StopMotion;
use percuss_study::{
    BaseName, Changes, ConditionsTable, ContactListReport, ContactTable, DampingReport, DesignError,
    DiagnosticRecord, Explanation, Frames, GivenContact, ImpactReport, InvalidKey, KinematicTarget,
    KinematicVariable, KinematicsQuestion, KinematicsReport, MassQuestion, Model, ModelTable, Moved, Names,
    PointMapReport, PosedMass, RowSource, SafeSpeedReport, Scene, SceneShapes, StudyError, TargetReport,
    TargetSearch, Vary, WheelMotion, changed_sheet, contact_list, damp_contact, damp_stop, explain,
    given_contact_masses, impact, kinematics, link_frames, map_point, mass_with_frames, safe_speeds, scene,
    scene_shapes, search_targets, starting_contact, sweep_report,
};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;
use std::str::FromStr;

/// Directions at the contact point besides the principal ones, which alone are shown.
const DIRECTIONS: usize = 1;

/// Model of a page, as opened and with the changes of the last request.
#[derive(Debug, Default)]
pub struct Session {
    opened: Option<Model>,
    /// Model with changes; `None` without changes.
    changed: Option<(Changes, Model)>,
    /// Changes of the scene that the page has.
    shown: Changes,
}

/// Reason for a missing reply.
#[derive(Debug, Serialize)]
struct Refusal {
    /// Message.
    message: String,
    /// Key of the question at fault, if known.
    key: Option<String>,
    /// True if the question is valid, and has no result.
    no_result: bool,
    /// Findings about a file, with lines.
    diagnostics: Vec<DiagnosticRecord>,
}

impl Refusal {
    fn of_message(message: impl Into<String>) -> Self {
        Self { message: message.into(), key: None, no_result: false, diagnostics: Vec::new() }
    }
}

impl From<StudyError> for Refusal {
    fn from(error: StudyError) -> Self {
        let key = error.key();
        let no_result = error.has_no_result();
        Self { key, no_result, ..Self::of_message(error.message(Names::Fields)) }
    }
}

impl From<InvalidKey> for Refusal {
    fn from(refusal: InvalidKey) -> Self {
        Self { key: Some(refusal.key.to_owned()), ..Self::of_message(refusal.reason(Names::Fields)) }
    }
}

impl From<LoadError> for Refusal {
    fn from(error: LoadError) -> Self {
        let diagnostics: Vec<DiagnosticRecord> = error.diagnostics.into_iter().map(Into::into).collect();
        let first = diagnostics.iter().find(|found| found.severity.name() == "error");
        let message =
            first.map_or_else(|| "the model cannot be read".to_owned(), |found| found.message.clone());
        Self { diagnostics, ..Self::of_message(message) }
    }
}

impl From<DesignError> for Refusal {
    fn from(error: DesignError) -> Self {
        match error {
            DesignError::Load(error) => error.into(),
            DesignError::Change(error) => error.into(),
            other => Self::of_message(other.to_string()),
        }
    }
}

/// Result, or the reason for its absence.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
enum Outcome<T> {
    Ok(T),
    Refused(Refusal),
}

impl<T, E: Into<Refusal>> From<Result<T, E>> for Outcome<T> {
    fn from(result: Result<T, E>) -> Self {
        match result {
            Ok(value) => Self::Ok(value),
            Err(error) => Self::Refused(error.into()),
        }
    }
}

/// Reply to a request.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Reply {
    Opened(Box<Opened>),
    Shown(Box<Shown>),
    Curve(Curve),
    Contacts(Box<ContactListReport>),
    Explained(Option<Explanation>),
    Found(Box<TargetReport>),
    Sheet(String),
    Damped(Box<DampingReport>),
    Impact(Box<ImpactReport>),
    SafeSpeeds(Vec<SafeSpeedReport>),
    Kinematics(Box<KinematicsReport>),
    Masses(Vec<GivenContact>),
    Directions(Box<PointMapReport>),
}

/// Reply to an opened model.
#[derive(Debug, Serialize)]
struct Opened {
    scene: Scene,
    /// Shapes of the links, if requested.
    shapes: Option<SceneShapes>,
    contact: ContactTable,
    conditions: ConditionsTable,
    /// Results at all named contacts; `None` without named contacts.
    contacts: Option<ContactListReport>,
    /// Names of the poses that the model file defines (keyframes of MJCF).
    poses: Vec<String>,
    diagnostics: Vec<DiagnosticRecord>,
}

/// Reply to a question.
#[derive(Debug, Serialize)]
struct Shown {
    /// Scene, if the changes of the model are others than before.
    scene: Option<Scene>,
    result: Outcome<PosedMass>,
    /// Frames at the pose of a question without a result, if the pose exists.
    frames: Option<Frames>,
}

/// Curve of m̄ over a range.
#[derive(Debug, Serialize)]
struct Curve {
    name: String,
    /// `m` or `rad`.
    unit: &'static str,
    rows: Vec<CurveRow>,
    diagnostics: Vec<DiagnosticRecord>,
}

/// Row of a curve.
#[derive(Debug, Serialize)]
struct CurveRow {
    /// Varied number, m or rad.
    at: f64,
    status: &'static str,
    /// m̄, kg; `None` unless finite.
    mass: Option<f64>,
    /// Error bound of m̄, kg.
    error: Option<f64>,
    /// Gap of a stop, m.
    gap: Option<f64>,
    singular: bool,
    /// Reason for a missing result.
    why: Option<String>,
}

impl Session {
    /// Session without a model.
    pub const fn new() -> Self {
        let shown = Changes {
            shape_density: None,
            total_mass: None,
            link_mass: Vec::new(),
            link_com: Vec::new(),
            link_inertia: Vec::new(),
            moves: Vec::new(),
        };
        Self { opened: None, changed: None, shown }
    }

    /// Answers a request in JSON by a reply in JSON: `{"ok": …}` or `{"refused": {"message": …}}`.
    pub fn answer(&mut self, request: &[u8]) -> Vec<u8> {
        let reply = match serde_json::from_slice::<Request>(request) {
            Ok(request) => self.reply(request),
            Err(error) => Err(Refusal::of_message(format!("the request is invalid: {error}"))),
        };
        // Every part of a reply serialises: keys are texts, and JSON has null for numbers that are not finite.
        serde_json::to_vec(&Outcome::from(reply)).unwrap_or_default()
    }

    /// Replies to a parsed request.
    fn reply(&mut self, request: Request) -> Result<Reply, Refusal> {
        match request {
            Request::Open { model, text, files, shapes } => {
                let source = source(&model.path, text, files)?;
                Ok(Reply::Opened(Box::new(self.open(&model, &source, shapes)?)))
            }
            Request::Show { question } => Ok(Reply::Shown(Box::new(self.show(&question)?))),
            Request::Curve { question, vary } => {
                let (model, question) = self.model_and_question(&question)?;
                Ok(Reply::Curve(curve(model, &question, &vary)?))
            }
            Request::Contacts { question } => {
                let conditions = question.conditions().map_err(Refusal::of_message)?;
                let model = self.model(&question.model.changes())?;
                Ok(Reply::Contacts(Box::new(contact_list(model, &conditions, None)?)))
            }
            Request::Explain { question } => {
                let (model, question) = self.model_and_question(&question)?;
                Ok(Reply::Explained(explain(model, &question)?))
            }
            Request::Solve { question, unknown, mass, within } => {
                let (model, question) = self.model_and_question(&question)?;
                let unknown = unknown.parse().map_err(|error: String| Refusal::of_message(error))?;
                let target = KinematicTarget::from_str(&format!("effective_mass={mass}kg"));
                let targets = vec![target.map_err(Refusal::of_message)?];
                let unknowns = vec![unknown];
                let search = TargetSearch { unknowns, targets, within, mass: Some(question), impact: None };
                let found = search_targets(model, &KinematicsQuestion::default(), &search);
                Ok(Reply::Found(Box::new(found.map_err(|error| Refusal::of_message(error.to_string()))?)))
            }
            Request::Damp { question, damping } => {
                let wanted = damping
                    .checked()?
                    .ok_or_else(|| Refusal::of_message("the damper needs a restitution and a stiffness"))?;
                let Some(stop) = &damping.limit else {
                    let (model, question) = self.model_and_question(&question)?;
                    wanted.check_units(question.is_moment(&model.mechanism))?;
                    return Ok(Reply::Damped(Box::new(damp_contact(model, &question, wanted)?)));
                };
                let conditions = question.conditions().map_err(Refusal::of_message)?;
                let model = self.model(&question.model.changes())?;
                wanted.check_units(stop.motion(model)? == StopMotion::Turn)?;
                Ok(Reply::Damped(Box::new(damp_stop(model, stop, conditions, wanted)?)))
            }
            Request::Impact { question, impact: wanted } => {
                wanted.check()?;
                let (model, question) = self.model_and_question(&question)?;
                Ok(Reply::Impact(Box::new(impact(model, &question, &wanted)?)))
            }
            Request::SafeSpeed { question, safe_speed } => {
                let (model, question) = self.model_and_question(&question)?;
                let wanted = safe_speed.checked(Path::new(""), DEFAULT_MAX_SIZE)?;
                Ok(Reply::SafeSpeeds(safe_speeds(model, &question, &wanted)?))
            }
            Request::Kinematics { model, state, range } => {
                let question = kinematics_question(&state, range)?;
                let model = self.model(&model.changes())?;
                let report =
                    kinematics(model, &question).map_err(|error| Refusal::of_message(error.to_string()))?;
                Ok(Reply::Kinematics(Box::new(report)))
            }
            Request::Map { question, link, contacts } => {
                let (model, question) = self.model_and_question(&question)?;
                Ok(Reply::Masses(given_contact_masses(model, &question, &link, &contacts)?))
            }
            Request::Directions { question } => {
                let (model, question) = self.model_and_question(&question)?;
                Ok(Reply::Directions(Box::new(map_point(model, &question, DIRECTIONS)?)))
            }
            Request::Sheet { model } => {
                let opened = self.opened()?;
                let changed = changed_sheet(opened, &model.changes().moves);
                let changed = changed.map_err(|error| Refusal::of_message(error.to_string()))?;
                // The page saves a sheet in TOML.
                let is_toml = changed.name.to_ascii_lowercase().ends_with(".toml");
                let text = String::from_utf8(changed.bytes).ok().filter(|_| is_toml);
                let refusal = || {
                    let command = "percuss kinematics --solve … -o";
                    Refusal::of_message(format!(
                        "the points are in {}: {command} writes this file",
                        changed.name
                    ))
                };
                Ok(Reply::Sheet(text.ok_or_else(refusal)?))
            }
        }
    }

    /// Model as opened, without changes.
    fn opened(&self) -> Result<&Model, Refusal> {
        self.opened.as_ref().ok_or_else(|| Refusal::of_message("no model is open"))
    }

    /// Opens a model with the changes of its table, and proposes a contact.
    fn open(&mut self, table: &ModelTable, source: &Source, with_shapes: bool) -> Result<Opened, Refusal> {
        let options = LoadOptions { accept: table.accepted(), ..LoadOptions::default() };
        let opened = Model::from_source(source, &options)?;
        let changes = table.changes();
        let model = if changes.is_empty() { opened.clone() } else { opened.with_changes(&changes)? };
        let scene = scene(&model)?;
        let (contact, base) = starting_contact(&model)?;
        let conditions = ConditionsTable {
            base: (base == BaseName::Floating).then_some(base),
            ..ConditionsTable::default()
        };
        let contacts = (!model.mechanism.contacts().is_empty())
            .then(|| contact_list(&model, &MassQuestion::default(), None))
            .transpose()?;
        let shapes = with_shapes.then(|| scene_shapes(&model));
        let diagnostics = model.diagnostics.clone();
        let poses = model.poses.iter().map(|pose| pose.name.clone()).collect();
        self.opened = Some(opened);
        self.changed = (!changes.is_empty()).then(|| (changes.clone(), model));
        self.shown = changes;
        Ok(Opened { scene, shapes, contact, conditions, contacts, poses, diagnostics })
    }

    /// Model with changes; the model of the last changes is kept.
    fn model(&mut self, changes: &Changes) -> Result<&Model, Refusal> {
        if !changes.is_empty() && self.changed.as_ref().is_none_or(|(known, _)| known != changes) {
            let model = self.opened()?.with_changes(changes)?;
            self.changed = Some((changes.clone(), model));
        }
        match &self.changed {
            Some((_, model)) if !changes.is_empty() => Ok(model),
            _ => self.opened(),
        }
    }

    /// Result at the pose of a question, with the scene if the changes of the model are new.
    fn show(&mut self, request: &QuestionRequest) -> Result<Shown, Refusal> {
        let changes = request.model.changes();
        let is_new = changes != self.shown;
        let model = self.model(&changes)?;
        let scene = if is_new { Some(scene(model)?) } else { None };
        let question = request.question().map_err(Refusal::of_message)?;
        let result = mass_with_frames(model, &question);
        let frames = if result.is_err() { link_frames(model, &question).ok() } else { None };
        if is_new {
            self.shown = changes;
        }
        Ok(Shown { scene, result: result.into(), frames })
    }

    /// Model and question of a request.
    fn model_and_question(&mut self, request: &QuestionRequest) -> Result<(&Model, MassQuestion), Refusal> {
        let question = request.question().map_err(Refusal::of_message)?;
        Ok((self.model(&request.model.changes())?, question))
    }
}

/// Source of a model. `files`: base64 of the files to which the model may refer.
fn source(path: &str, text: String, files: BTreeMap<String, String>) -> Result<Source, Refusal> {
    let mut store = Vec::with_capacity(files.len() + 1);
    for (name, packed) in files {
        let bytes = STANDARD.decode(packed);
        let bytes = bytes.map_err(|error| Refusal::of_message(format!("{name}: invalid base64: {error}")))?;
        store.push((name, bytes));
    }
    // The path of a model in an SDFormat file is FILE#MODEL. In `robot#2.urdf` the # belongs to the name: no ending comes before it.
    let split = path.rsplit_once('#').filter(|(file, _)| Path::new(file).extension().is_some());
    let file = split.map_or(path, |(file, _)| file);
    store.push((file.to_owned(), text.clone().into_bytes()));
    Ok(Source { files: MemoryFiles::new(store).into(), ..Source::from_text(path, text) })
}

/// Question about kinematics with variables by name.
fn kinematics_question(
    state: &BTreeMap<String, f64>,
    range: Option<(String, Vec<f64>)>,
) -> Result<KinematicsQuestion, Refusal> {
    let variable = |name: &str| match WheelMotion::from_name(name) {
        Some(motion) => Ok(KinematicVariable::Wheels(motion)),
        None if name == KinematicVariable::Steer.name() => Ok(KinematicVariable::Steer),
        None => Err(Refusal::of_message(format!(
            "kinematics: \"{name}\" is no variable; expected wheel-travel, heave, roll or steer"
        ))),
    };
    let state =
        state.iter().map(|(name, value)| Ok((variable(name)?, *value))).collect::<Result<_, Refusal>>()?;
    let range = range.map(|(name, values)| Ok::<_, Refusal>((variable(&name)?, values))).transpose()?;
    Ok(KinematicsQuestion { state, range, ..KinematicsQuestion::default() })
}

/// m̄ over the range `vary`, which replaces the position of the same joint, and the travels of the question except an independent one, such
/// as a roll beside the varied heave.
fn curve(model: &Model, question: &MassQuestion, vary: &str) -> Result<Curve, Refusal> {
    let vary = Vary::parse(vary).map_err(|error| Refusal::of_message(error.to_string()))?;
    let name = vary.name();
    let mut question = question.clone();
    question.pose.set.retain(|(joint, _)| *joint != name);
    let varied = WheelMotion::from_name(&name).map(Moved::Wheels);
    question
        .pose
        .travel
        .retain(|travel| varied.as_ref().is_some_and(|varied| travel.moved.is_beside(varied)));
    let report = sweep_report(model, &question, RowSource::Grid(vec![vary]))?;
    let unit = report.heading.varied.first().map_or("", |column| column.unit.si_unit());
    let row = |row: percuss_study::SweepRow| CurveRow {
        at: row.varied.values().first().copied().unwrap_or_default(),
        status: row.status,
        mass: row.effective_mass,
        error: row.effective_mass_error,
        gap: row.gap.flatten(),
        singular: row.singular_pose == Some(true),
        why: row.error,
    };
    Ok(Curve {
        name,
        unit,
        rows: report.rows.into_iter().map(row).collect(),
        diagnostics: report.diagnostics,
    })
}
