//! Designs of a study file: changes of the model, and variants.

use crate::checks::design_variant::DesignError;
use crate::model::changes::Changes;
use crate::model::loading::{Input, Model};
use crate::question::mass_question::MassQuestion;
use crate::values::position::GivenPosition;
use crate::values::value::{self, NumberOrText, OneOrMany, PositionText, Triple};
use percuss_formats::{LoadError, LoadOptions};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// A design variant: changes of the model and of the query.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct VariantText {
    /// Name of the variant in tables and figures.
    pub name: String,
    /// File of another model in place of the study's model.
    pub model: Option<String>,
    /// Masses by link, kg, in place of those in [model].
    #[serde(default, deserialize_with = "value::masses")]
    #[schemars(with = "BTreeMap<String, NumberOrText>")]
    pub link_mass: BTreeMap<String, f64>,
    /// Centres of mass by link, m.
    #[serde(default, deserialize_with = "value::places")]
    #[schemars(with = "BTreeMap<String, Triple>")]
    pub link_com: BTreeMap<String, [f64; 3]>,
    /// Displacements of hardpoints of a sheet, m.
    #[serde(default, rename = "move", deserialize_with = "value::places")]
    #[schemars(with = "BTreeMap<String, Triple>")]
    pub moves: BTreeMap<String, [f64; 3]>,
    /// Armatures by joint.
    #[serde(default, deserialize_with = "value::armatures")]
    #[schemars(with = "BTreeMap<String, OneOrMany>")]
    pub armature: BTreeMap<String, Vec<f64>>,
    /// Positions of driving joints.
    #[serde(default, deserialize_with = "value::positions")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub set: BTreeMap<String, GivenPosition>,
}

/// Variant of a study.
#[derive(Clone, Debug)]
pub struct Variant {
    /// Name of the variant.
    pub name: String,
    /// Model of the variant.
    pub model: Model,
    /// Query of the variant.
    pub question: MassQuestion,
}

/// Models of variants; each file is read once.
pub(crate) struct VariantModels<'a> {
    max_size: u64,
    options: &'a LoadOptions,
    by_path: BTreeMap<String, Model>,
}

impl<'a> VariantModels<'a> {
    /// Empty set of models. A model file has at most `max_size` bytes.
    pub fn new(max_size: u64, options: &'a LoadOptions) -> Self {
        Self { max_size, options, by_path: BTreeMap::new() }
    }

    /// Loads a model, or returns the model loaded before from the same path.
    fn load(&mut self, path: &str) -> Result<Model, LoadError> {
        if let Some(model) = self.by_path.get(path) {
            return Ok(model.clone());
        }
        let model = Model::load(path, self.max_size, self.options)?;
        self.by_path.insert(path.to_owned(), model.clone());
        Ok(model)
    }
}

/// Changes of a model from the entries of a study.
pub(crate) fn changes(
    link_mass: &BTreeMap<String, f64>,
    link_com: &BTreeMap<String, [f64; 3]>,
    moves: &BTreeMap<String, [f64; 3]>,
) -> Changes {
    /// Entries of a map in the order of their names.
    fn list<T: Clone>(map: &BTreeMap<String, T>) -> Vec<(String, T)> {
        map.iter().map(|(name, value)| (name.clone(), value.clone())).collect()
    }
    Changes { link_mass: list(link_mass), link_com: list(link_com), moves: list(moves) }
}

impl VariantText {
    /// Applies the changes to the model and query of a study; paths are relative to `folder`, the folder of the study.
    pub fn apply(
        &self,
        base: &Model,
        question: &MassQuestion,
        folder: &Path,
        loaded: &mut VariantModels<'_>,
    ) -> Result<Variant, DesignError> {
        let other = match &self.model {
            None => base.clone(),
            Some(path) => {
                let other = loaded.load(&folder.join(path).to_string_lossy())?;
                // Changes and additions of the study apply to its variants too.
                let mut other = other.with_closures_of(base)?.with_changes(&base.origin.changes)?;
                other.inputs.extend(base.inputs.iter().skip(1).cloned().collect::<Vec<Input>>());
                other
            }
        };
        let model = other.with_changes(&changes(&self.link_mass, &self.link_com, &self.moves))?;
        let mut question = question.clone();
        question.armature.retain(|(joint, _)| !self.armature.contains_key(joint));
        question.armature.extend(self.armature.iter().map(|(joint, values)| (joint.clone(), values.clone())));
        question.set.retain(|(joint, _)| !self.set.contains_key(joint));
        question.set.extend(self.set.iter().map(|(joint, position)| (joint.clone(), position.clone())));
        Ok(Variant { name: self.name.clone(), model, question })
    }
}
