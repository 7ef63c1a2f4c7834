//! Designs of a study file: the changes of its model, and its variants.

use crate::changes::Changes;
use crate::design::DesignError;
use crate::model::{Input, Model};
use crate::position::GivenPosition;
use crate::question::MassQuestion;
use crate::study_value::{self, NumberOrText, OneOrMany, PositionText, Triple};
use percuss_formats::{LoadError, LoadOptions};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// What is changed of a model, as a study says it.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct VariantText {
    /// Its name, in tables and figures.
    pub name: String,
    /// Another model's file.
    pub model: Option<String>,
    /// Masses by link, kg, over those of [model].
    #[serde(default, deserialize_with = "study_value::masses")]
    #[schemars(with = "BTreeMap<String, NumberOrText>")]
    pub link_mass: BTreeMap<String, f64>,
    /// Centres of mass by link, m.
    #[serde(default, deserialize_with = "study_value::places")]
    #[schemars(with = "BTreeMap<String, Triple>")]
    pub link_com: BTreeMap<String, [f64; 3]>,
    /// Hardpoints of a sheet that are moved, m.
    #[serde(default, rename = "move", deserialize_with = "study_value::places")]
    #[schemars(with = "BTreeMap<String, Triple>")]
    pub moves: BTreeMap<String, [f64; 3]>,
    /// Armatures by joint.
    #[serde(default, deserialize_with = "study_value::armatures")]
    #[schemars(with = "BTreeMap<String, OneOrMany>")]
    pub armature: BTreeMap<String, Vec<f64>>,
    /// Positions of driving joints.
    #[serde(default, deserialize_with = "study_value::positions")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub set: BTreeMap<String, GivenPosition>,
}

/// A variant of a study.
#[derive(Clone, Debug)]
pub struct Variant {
    /// What it is called.
    pub name: String,
    /// The model as the variant has it.
    pub model: Model,
    /// The question as the variant has it.
    pub question: MassQuestion,
}

/// Models that variants name, each read once.
pub(crate) struct OtherModels<'a> {
    max_size: u64,
    options: &'a LoadOptions,
    by_path: BTreeMap<String, Model>,
}

impl<'a> OtherModels<'a> {
    /// None read yet; each has at most `max_size` bytes.
    pub fn new(max_size: u64, options: &'a LoadOptions) -> Self {
        Self { max_size, options, by_path: BTreeMap::new() }
    }

    fn load(&mut self, path: &str) -> Result<Model, LoadError> {
        if let Some(model) = self.by_path.get(path) {
            return Ok(model.clone());
        }
        let model = Model::load(path, self.max_size, self.options)?;
        self.by_path.insert(path.to_owned(), model.clone());
        Ok(model)
    }
}

/// Changes as a study says them.
pub(crate) fn changes(
    link_mass: &BTreeMap<String, f64>,
    link_com: &BTreeMap<String, [f64; 3]>,
    moves: &BTreeMap<String, [f64; 3]>,
) -> Changes {
    fn list<T: Clone>(map: &BTreeMap<String, T>) -> Vec<(String, T)> {
        map.iter().map(|(name, value)| (name.clone(), value.clone())).collect()
    }
    Changes { link_mass: list(link_mass), link_com: list(link_com), moves: list(moves) }
}

impl VariantText {
    /// The variant of a study's model and question; paths are relative to the study's folder.
    pub fn variant(
        &self,
        base: &Model,
        question: &MassQuestion,
        folder: &Path,
        loaded: &mut OtherModels<'_>,
    ) -> Result<Variant, DesignError> {
        let other = match &self.model {
            None => base.clone(),
            Some(path) => {
                let other = loaded.load(&folder.join(path).to_string_lossy())?;
                // Changes and additions of the study apply to its variants too.
                let mut other = other.with_closures_of(base)?.changed(&base.origin.changes)?;
                other.inputs.extend(base.inputs.iter().skip(1).cloned().collect::<Vec<Input>>());
                other
            }
        };
        let model = other.changed(&changes(&self.link_mass, &self.link_com, &self.moves))?;
        let mut question = question.clone();
        question.armature.retain(|(joint, _)| !self.armature.contains_key(joint));
        question.armature.extend(self.armature.iter().map(|(joint, values)| (joint.clone(), values.clone())));
        question.set.retain(|(joint, _)| !self.set.contains_key(joint));
        question.set.extend(self.set.iter().map(|(joint, position)| (joint.clone(), position.clone())));
        Ok(Variant { name: self.name.clone(), model, question })
    }
}
