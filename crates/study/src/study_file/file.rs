//! Study file: a model with queries in TOML, equivalent to flags of the commands.

use crate::checks::design_variant::DesignError;
use crate::model::loading::{Input, Model, refuse_pipe};
use crate::model::sheet::is_study;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
use crate::question::names::Names;
use crate::question::row_source::RowSource;
use crate::question::tables::contact::ContactTable;
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::damping::restitution::RestitutionQuestion;
use crate::question::tables::extremes::ExtremesQuestion;
use crate::question::tables::impact::ImpactQuestion;
use crate::question::tables::mass::MassOptions;
use crate::question::tables::safe_speed::SafeSpeedQuestion;
use crate::question::tables::sweep::SweepQuestion;
use crate::reports::compare::Design;
use crate::reports::kinematics::target_question::TargetSearch;
use crate::study_file::closure::{ClosureText, closure_fault, with_closures};
use crate::study_file::contacts::{StudyContact, expand, several_contacts};
use crate::study_file::keys::{StudyKeys, UnknownKey};
use crate::study_file::tables_of_page::PageTables;
use crate::study_file::text::StudyTables;
use crate::study_file::variant::{Variant, VariantModels};
use crate::thresholds::{
    LARGEST_STUDY, LARGEST_VARIANTS, LONGEST_LINE_SHOWN, MOST_VARIANT_LINKS, MOST_VARIANTS,
};
use crate::values::message_text::truncate_for_message;
use crate::values::value::path_in;
use percuss_contact::exports::StopMotion;
use percuss_formats::{LoadError, LoadOptions, Source};
use percuss_mechanism::BuildError;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Content of a study file.
#[derive(Clone, Debug)]
pub struct StudyFile {
    /// Model with the changes and closures of the study.
    pub model: Model,
    /// Contact and conditions; `None` if the study has no contact with a normal.
    pub question: Option<MassQuestion>,
    /// All contacts with their questions, if there are several; the first is that of `question`.
    pub contacts: Vec<StudyContact>,
    /// Pose and conditions, also without a contact.
    pub conditions: MassQuestion,
    /// Requests about the contact besides the effective mass.
    pub mass: MassOptions,
    /// Design variants.
    pub variants: Vec<Variant>,
    /// All tables as in the file, with checked keys and the name of the model. Paths of the questions are relative to the working
    /// directory.
    pub tables: StudyTables,
    /// Tables of the question, for a page.
    pub page: PageTables,
    /// Folder of the study; paths in the study are relative to this folder.
    pub folder: PathBuf,
    /// Keys with their positions.
    pub keys: StudyKeys,
}

/// Error of an invalid study file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyFileError {
    /// Unreadable study or model file.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// File that is not UTF-8 text.
    #[error("{path}: error: not UTF-8 text; a study is a TOML file")]
    NotText {
        /// Path of the study.
        path: String,
    },
    /// Invalid TOML, or a value of the wrong type. The following lines show the position in the file.
    #[error("{path}:{line}: error: {message}")]
    Toml {
        /// Path of the study.
        path: String,
        /// Line of the error, from 1.
        line: usize,
        /// Reason, and the lines of the file.
        message: String,
    },
    /// Unknown keys.
    #[error("{}", unknown_keys_message(path, keys, *more))]
    Keys {
        /// Path of the study.
        path: String,
        /// First unknown keys, in the order of the file.
        keys: Vec<UnknownKey>,
        /// Number of further unknown keys.
        more: usize,
    },
    /// Invalid value.
    #[error("{path}{}: error: {key}: {why}", line_suffix(*line))]
    Value {
        /// Path of the study.
        path: String,
        /// Line of the key, from 1; `None` if the key is not in the file.
        line: Option<usize>,
        /// Key of the value.
        key: String,
        /// Reason.
        why: String,
    },
    /// Invalid mechanism after the addition of the study's closures.
    #[error("{path}: error: {source}")]
    Build {
        /// Path of the study.
        path: String,
        /// Error of the mechanism builder.
        source: BuildError,
    },
}

/// `:LINE` after a file name; empty without a line.
fn line_suffix(line: Option<usize>) -> String {
    line.map_or_else(String::new, |line| format!(":{line}"))
}

/// Message with one line per unknown key. Keys are escaped, so that a line break in a key does not start a line.
fn unknown_keys_message(path: &str, keys: &[UnknownKey], more: usize) -> String {
    let line = |k: &UnknownKey| format!("{path}:{}: error: unknown key {:?}; {}", k.line, k.key, k.hint);
    let more = (more > 0).then(|| format!("{path}: error: {more} more unknown keys"));
    keys.iter().map(line).chain(more).collect::<Vec<_>>().join("\n")
}

/// Error of the TOML parser or of a value, with the line and the key; `begin`: first words of the message.
fn parse_error(
    path: &str,
    begin: &str,
    keys: &StudyKeys,
    text: &str,
    error: &toml::de::Error,
) -> StudyFileError {
    let span = error.span().unwrap_or_default();
    let key = keys.key_at(&span).map_or_else(String::new, |key| format!("{key}: "));
    // `keys` is empty if the text is not valid TOML, so lines are counted in the text.
    let line = 1 + text.bytes().take(span.start).filter(|byte| *byte == b'\n').count();
    let shown = error.to_string();
    // Lines of the file, from the parser's message "TOML parse error at …".
    let is_shown = |line: &&str| line.contains('|') && line.len() <= LONGEST_LINE_SHOWN;
    let lines: Vec<&str> = shown.trim_end().lines().skip(1).filter(is_shown).collect();
    let why = error.message().trim().replace('\n', "; ");
    // The parser names the type of the program.
    let why = match why.split_once("expected struct ") {
        Some((received, _)) => format!("{received}expected a table"),
        None => why,
    };
    let message = format!("{begin}{key}{}\n{}", truncate_for_message(&why), lines.join("\n"));
    StudyFileError::Toml { path: path.to_owned(), line, message: message.trim_end().to_owned() }
}

impl StudyFile {
    /// Question of the rows of the sweep: that of the contact, without the travel of the pose if the rows vary a travel.
    pub fn question_of_rows(&self, question: &MassQuestion) -> MassQuestion {
        match &self.tables.sweep {
            Some(sweep) => sweep.rows().question_of_rows(question),
            None => question.clone(),
        }
    }

    /// Keys and paths of the output files that the tables name.
    pub fn outputs(&self) -> impl Iterator<Item = (&'static str, String)> {
        let tables = &self.tables;
        let maps = tables.map.iter().flat_map(|asked| &asked.output).map(|file| ("map.output", file));
        macro_rules! files {
            ($($table:ident)*) => {
                [$((
                    concat!(stringify!($table), ".output"),
                    tables.$table.as_ref().and_then(|asked| asked.output.as_ref()),
                )),*]
            };
        }
        let files = files!(sweep damping identify response kinematics generate convert export);
        let files = files.into_iter().filter_map(|(key, file)| Some((key, file?)));
        files.chain(maps).map(|(key, file)| (key, file.clone()))
    }

    /// Reads a study and its model (path relative to the folder of the study). At most `max_size` bytes each.
    ///
    /// # Errors
    /// [`StudyFileError`]: unreadable files, unknown keys, invalid values, or an invalid mechanism.
    pub fn load(path: &str, max_size: u64) -> Result<Self, StudyFileError> {
        refuse_pipe(path)?;
        let source = Source::read(path, max_size.min(LARGEST_STUDY))?;
        let path = source.name.clone();
        let text = String::from_utf8(source.bytes.clone())
            .map_err(|_| StudyFileError::NotText { path: path.clone() })?;
        Self::from_text(path, &text, &source, None, max_size)
    }

    /// Reads the text of a study; `path`: its name in messages. `given`: the model, in place of the file that the study names.
    pub(crate) fn from_text(
        path: String,
        text: &str,
        source: &Source,
        given: Option<&Model>,
        max_size: u64,
    ) -> Result<Self, StudyFileError> {
        let (keys, unknown) = StudyKeys::from_text(text)
            .map_err(|error| parse_error(&path, "not TOML: ", &StudyKeys::default(), text, &error))?;
        if !unknown.first.is_empty() {
            return Err(StudyFileError::Keys { path, keys: unknown.first, more: unknown.omitted });
        }
        let study: StudyTables =
            toml::from_str(text).map_err(|error| parse_error(&path, "", &keys, text, &error))?;
        StudyReader { path: &path, keys: &keys, given, max_size }.study(study, source)
    }

    /// True if a file is a study: TOML with a table `model`.
    pub fn is_study(path: &str, max_size: u64) -> bool {
        // A pipe can be read only once; the model reader reads its content.
        std::fs::metadata(path).is_ok_and(|found| found.is_file())
            && Source::read(path, max_size).is_ok_and(|source| is_study(&source))
    }

    /// Designs of the study: first the model of the study, then the variants, each at all contacts of the study. Empty without a contact.
    pub fn designs(&self) -> Vec<Design> {
        let Some(question) = &self.question else { return Vec::new() };
        let own = (self.tables.model.name.as_deref().unwrap_or_default(), &self.model, question, None);
        let variants = self.variants.iter().map(|variant| {
            (variant.name.as_str(), &variant.model, &variant.question, variant.contact.as_ref())
        });
        let rows = self.tables.sweep.as_ref().map(SweepQuestion::rows);
        let mut designs = Vec::new();
        for (name, model, question, own_contact) in [own].into_iter().chain(variants) {
            let design = |name: String, question: MassQuestion, contact: Option<&ContactTable>| Design {
                name,
                model: model.clone(),
                question,
                contact: contact
                    .map(|contact| format!("{:?}", ContactTable { name: None, ..contact.clone() })),
                rows: rows.clone(),
            };
            if self.contacts.is_empty() || own_contact.is_some() {
                designs.push(design(name.to_owned(), question.clone(), own_contact));
                continue;
            }
            for contact in &self.contacts {
                let name = match self.variants.is_empty() {
                    true => contact.name.clone(),
                    false => format!("{name}: {}", contact.name),
                };
                let contact = &contact.question.contact;
                let question = MassQuestion { contact: contact.clone(), ..question.clone() };
                designs.push(design(name, question, Some(contact)));
            }
        }
        designs
    }

    /// Number of the variant of a design, as [`designs`](Self::designs) orders them; `None` for the model of the study.
    pub(super) fn variant_of_design(&self, number: usize) -> Option<usize> {
        let contacts = self.contacts.len().max(1);
        let mut end = contacts;
        if number < end {
            return None;
        }
        self.variants.iter().position(|variant| {
            end += if variant.contact.is_some() { 1 } else { contacts };
            number < end
        })
    }
}

/// Context for reading a study.
struct StudyReader<'a> {
    path: &'a str,
    keys: &'a StudyKeys,
    /// Model of a request; `None` for the file that the study names.
    given: Option<&'a Model>,
    max_size: u64,
}

impl StudyReader<'_> {
    /// True if the study has one of the tables.
    fn has_table(&self, tables: &[&str]) -> bool {
        tables.iter().any(|table| self.keys.contains(table))
    }

    /// Error of the study file for an invalid key.
    fn invalid_key_error(&self, refusal: InvalidKey) -> StudyFileError {
        self.value(refusal.key, refusal.key, refusal.reason(Names::KEYS))
    }

    /// Error of an invalid value; `place`: path of the key that gives the line.
    fn value(&self, key: &str, place: &str, why: String) -> StudyFileError {
        StudyFileError::Value {
            path: self.path.to_owned(),
            line: self.keys.line_of(place),
            key: key.to_owned(),
            why,
        }
    }

    /// Error of an invalid query, with the key of the invalid field.
    fn study_error(&self, error: &StudyError) -> StudyFileError {
        let (key, why) = self.key_and_reason(error);
        self.value(&key, &key, why)
    }

    /// Key of the invalid field, and the message without it.
    fn key_and_reason(&self, error: &StudyError) -> (String, String) {
        let key = error.key().unwrap_or_else(|| "model".to_owned());
        let why = error.message(Names::KEYS);
        let why = why.strip_prefix(&format!("{key}: ")).unwrap_or(&why).to_owned();
        (key, why)
    }

    /// Error of an invalid design; `variant`: index and name of the variant, `None` for the model of the study.
    fn design(&self, variant: Option<(usize, &str)>, error: DesignError) -> StudyFileError {
        let (number, of) =
            variant.map_or((None, String::new()), |(i, name)| (Some(i), format!("\"{name}\": ")));
        let (key, why) = match error {
            // One message for all findings about the model.
            DesignError::Load(error) => ("model".to_owned(), error.to_string().replace('\n', "; ")),
            DesignError::Change(error) => self.key_and_reason(&error),
        };
        let key = self.keys.of_variant(number, &key);
        self.value(&key, &key, format!("{of}{why}"))
    }

    /// Converts the parsed text to a study: loads the model and checks every part.
    fn study(&self, mut study: StudyTables, source: &Source) -> Result<StudyFile, StudyFileError> {
        let max_size = self.max_size;
        let folder = Path::new(self.path).parent().unwrap_or(Path::new(""));
        let refused = |refusal| self.invalid_key_error(refusal);
        let damping = study.damping.as_ref().filter(|damping| !damping.judges_compliance());
        if let Some(missing) = damping.and_then(DampingQuestion::missing) {
            return Err(self.value("damping", "damping", format!("{missing} is missing")));
        }
        // The study closes the loops that the file only marks.
        let options = LoadOptions { accept: study.model.accepted(), open_pairs: !study.closure.is_empty() };
        let model = self.model(&study, source, folder, &options)?;
        if let Some((key, why)) = study.hold_fault(&model.mechanism) {
            return Err(self.value(&key, &key, why));
        }
        let contacts = expand(&study.contact, &model.mechanism).map_err(refused)?;
        let contact = &contacts.first().cloned().unwrap_or_default();
        let question = study.question(contact, folder, max_size).map_err(refused)?;
        let variants = self.variants(&study, &model, &question, folder, &options)?;
        // Parsing cannot fail here: the same text has been parsed before.
        let panels = toml::from_slice(&source.bytes).unwrap_or_default();
        let page = PageTables { panels, ..PageTables::from_text(&study, contact, folder) };
        macro_rules! check {
            ($table:ident, $($argument:expr),*) => {
                let checked = study.$table.take().map(|asked| asked.checked($($argument),*));
                study.$table = checked.transpose().map_err(refused)?;
            };
        }
        check!(sweep, Vec::new(), folder, max_size);
        study.damping = self.damping(&study, &model, &question, folder)?;
        check!(map, &question, folder);
        study.restitution.as_ref().map_or(Ok(()), RestitutionQuestion::check).map_err(refused)?;
        check!(identify, folder);
        check!(response, folder);
        study.impact.as_ref().map_or(Ok(()), ImpactQuestion::check).map_err(refused)?;
        check!(extremes, Vec::new(), folder, max_size);
        check!(kinematics, &question, folder);
        if let Some(asked) = &mut study.targets {
            TargetSearch::of_table(asked, None).map_err(refused)?;
            asked.question.vehicle = study.kinematics.as_ref().map(|asked| asked.vehicle).unwrap_or_default();
            asked.question.set_state(&question, None);
        }
        check!(generate, folder);
        check!(convert, folder);
        check!(export, folder);
        let without_file = [
            ("convert.output", study.convert.as_ref().is_some_and(|asked| asked.output.is_none())),
            ("export.output", study.export.as_ref().is_some_and(|asked| asked.output.is_none())),
        ];
        if let Some((key, _)) = without_file.into_iter().find(|(_, is_missing)| *is_missing)
            && self.given.is_none()
        {
            return Err(self.value(key, key, "the file is missing".to_owned()));
        }
        if study.export.is_some()
            && study.damping.as_ref().is_none_or(|damping| damping.restitution.is_none())
        {
            let why = "the impact requires a damper: give [damping] with restitution and stiffness, or use [convert] for the mechanism alone";
            return Err(self.value("export", "export", why.to_owned()));
        }
        if let Some(asked) = &study.safe_speed {
            let missing = contact.missing();
            if let Some(part) = missing.filter(|part| !(asked.has_directions() && part.contains("normal"))) {
                return Err(self.value("contact", "contact", format!("{part} is missing")));
            }
            study.safe_speed = Some(asked.checked(folder, max_size).map_err(refused)?);
        }
        for (key, rows) in [
            ("sweep.input", study.sweep.as_ref().map(SweepQuestion::rows)),
            ("extremes.path", study.extremes.as_ref().and_then(ExtremesQuestion::rows)),
            ("safe_speed.input", study.safe_speed.as_ref().and_then(SafeSpeedQuestion::rows)),
        ] {
            if let Some(RowSource::File(file)) = rows {
                refuse_pipe(&file.path).map_err(|error| refused(InvalidKey::new(key, error.to_string())))?;
            }
        }
        // A study without a contact needs another query.
        let stops = study.damping.as_ref().is_some_and(|damping| damping.limit.is_some());
        let without_contact =
            stops || self.has_table(&["map", "safe_speed", "kinematics", "targets", "check", "convert"]);
        let of_contact = !without_contact
            || study.damping.is_some() && !stops
            || self.has_table(&[
                "variant",
                "restitution",
                "identify",
                "response",
                "impact",
                "extremes",
                "generate",
            ])
            || self.has_table(&["mass", "sweep"]);
        let asks = match contact.missing() {
            None => !stops,
            Some(part) if of_contact => {
                let why = match (contact.is_empty(), part) {
                    (false, "normal or along_line") => "give either normal or along_line".to_owned(),
                    (false, part) => format!("{part} is missing"),
                    (true, _) => "it is missing; expected link, point, and normal or along_line (or a study of [map] or \
                                  damping.limit alone)"
                        .to_owned(),
                };
                return Err(self.value("contact", "contact", why));
            }
            Some(_) => false,
        };
        if stops && (!contact.is_empty() || of_contact) {
            let why = "a joint stop replaces the contact: remove [contact], [sweep], [mass] and [[variant]]";
            return Err(self.value("damping.limit", "damping.limit", why.to_owned()));
        }
        let contacts = several_contacts(&contacts, &question, variants.len()).map_err(refused)?;
        let mass = study.mass.take().unwrap_or_default();
        mass.check().map_err(refused)?;
        if study.model.name.is_none() {
            study.model.name =
                Path::new(self.path).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        }
        Ok(StudyFile {
            model,
            question: asks.then(|| question.clone()),
            contacts,
            conditions: question,
            mass,
            variants,
            tables: study,
            page,
            folder: folder.to_owned(),
            keys: self.keys.clone(),
        })
    }

    /// Variants of the study, limited in number and memory.
    fn variants(
        &self,
        study: &StudyTables,
        model: &Model,
        question: &MassQuestion,
        folder: &Path,
        options: &LoadOptions,
    ) -> Result<Vec<Variant>, StudyFileError> {
        if study.variant.is_empty() {
            return Ok(Vec::new());
        }
        let refuse = |i: usize, key, why| Err(self.value(key, &format!("variant[{i}].name"), why));
        // Each variant holds a copy of the query and of the changes. The length of their text approximates their memory.
        let copied = format!("{question:?}{:?}", model.origin.changes).len();
        let most = MOST_VARIANTS.min(LARGEST_VARIANTS / copied.max(1));
        if study.variant.len() > most {
            let why = format!(
                "{} variants; at most {most} are read (of questions as long as this one): divide the study",
                study.variant.len()
            );
            return refuse(most, "variant", why);
        }
        let mut loaded = VariantModels::new(self.max_size, options);
        let mut names: BTreeSet<&String> = study.model.name.iter().collect();
        let (mut links, mut variants) = (0, Vec::new());
        for (i, text) in study.variant.iter().enumerate() {
            if !names.insert(&text.name) {
                return refuse(
                    i,
                    "variant.name",
                    format!("\"{}\" is given twice", truncate_for_message(&text.name)),
                );
            }
            let mut question = question.clone();
            if let Some(contact) = &text.contact {
                let of_variant = |key: &str| format!("variant[{i}].{key}");
                if let Some(part) = contact.missing() {
                    let key = of_variant("contact");
                    return Err(self.value(&key, &key, format!("{part} is missing")));
                }
                question.contact = contact.checked().map_err(|refusal| {
                    let key = of_variant(refusal.key);
                    self.value(&key, &key, refusal.reason(Names::KEYS))
                })?;
            }
            let variant = text
                .apply(model, &question, folder, &mut loaded)
                .map_err(|error| self.design(Some((i, &text.name)), error))?;
            if !Arc::ptr_eq(&variant.model.mechanism, &model.mechanism) {
                links += variant.model.mechanism.links().len();
            }
            if links > MOST_VARIANT_LINKS {
                let why = format!(
                    "\"{}\": the models of the variants up to this one have {links} links together; at most \
                     {MOST_VARIANT_LINKS} are read: divide the study",
                    truncate_for_message(&text.name)
                );
                return refuse(i, "variant", why);
            }
            variants.push(variant);
        }
        Ok(variants)
    }

    /// Model with the changes and closures of the study.
    fn model(
        &self,
        study: &StudyTables,
        source: &Source,
        folder: &Path,
        options: &LoadOptions,
    ) -> Result<Model, StudyFileError> {
        let model = match self.given {
            Some(given) => given.clone(),
            None => {
                let path = folder.join(&study.model.path);
                let (path, worksheet) = (path.to_string_lossy(), study.model.worksheet.as_deref());
                // For kinematics alone, the masses of a sheet may be missing.
                let has_contact = study.contact.iter().any(|contact| !contact.is_empty());
                let others = StudyFile::TABLES.into_iter().filter(|table| *table != "kinematics");
                let others: Vec<&str> = others.chain(["mass", "sweep", "variant"]).collect();
                let kinematics_only = study.kinematics.is_some() && !has_contact && !self.has_table(&others);
                let mut model = Model::load_named(&path, self.max_size, options, worksheet, kinematics_only)?;
                model.inputs.push(Input::from_source(source));
                model
            }
        };
        let model = model.with_changes(&study.model.changes()).map_err(|error| self.design(None, error))?;
        if study.closure.is_empty() {
            return Ok(model);
        }
        let closures = study.closure.iter().map(ClosureText::closure_description);
        let closures =
            closures.collect::<Result<Vec<_>, _>>().map_err(|refusal| self.invalid_key_error(refusal))?;
        let of_file = model.mechanism.closures().len();
        with_closures(model, self.path, closures).map_err(|source| {
            match closure_fault(&study.closure, of_file, &source) {
                Some((key, why)) => self.value(&key, &key, why),
                None => StudyFileError::Build { path: self.path.to_owned(), source },
            }
        })
    }

    /// Damper of a study; `None` without a `damping` table.
    fn damping(
        &self,
        study: &StudyTables,
        model: &Model,
        conditions: &MassQuestion,
        folder: &Path,
    ) -> Result<Option<DampingQuestion>, StudyFileError> {
        let Some(given) = &study.damping else { return Ok(None) };
        let given = given.checked_for_mass().map_err(|refusal| self.invalid_key_error(refusal))?;
        let Some(given) = given else { return Ok(None) };
        let turns = match &given.limit {
            Some(stop) => stop.motion(model).map_err(|error| self.study_error(&error))? == StopMotion::Turn,
            None => conditions.is_moment(&model.mechanism),
        };
        given.check_units(turns).map_err(|error| self.study_error(&error))?;
        let output = given.output.as_ref().map(|output| path_in(folder, output));
        Ok(Some(DampingQuestion { output, ..given.clone() }))
    }
}
