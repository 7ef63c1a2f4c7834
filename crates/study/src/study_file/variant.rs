//! Designs of a study file: changes of the model, and variants.

use crate::checks::design_variant::DesignError;
use crate::model::changes::Changes;
use crate::model::loading::{Input, Model};
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::ContactTable;
use crate::question::tables::model::{masses, moments, points};
use crate::values::position::GivenPosition;
use crate::values::quantities::{Mass, Moments, Point};
use crate::values::value::{self, OneOrMany, PositionText};
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
    /// Contact in place of that of the study, such as contact.at = "spring".
    pub contact: Option<ContactTable>,
    /// Masses by link, kg, in place of those in [model].
    #[serde(default, deserialize_with = "value::by_name")]
    #[schemars(with = "BTreeMap<String, Mass>")]
    pub link_mass: Vec<(String, Mass)>,
    /// Centres of mass by link, m.
    #[serde(default, deserialize_with = "value::by_name")]
    #[schemars(with = "BTreeMap<String, Point>")]
    pub link_com: Vec<(String, Point)>,
    /// Moments of inertia of links about their centres of mass, kg·m².
    #[serde(default, deserialize_with = "value::by_name")]
    #[schemars(with = "BTreeMap<String, Moments>")]
    pub link_inertia: Vec<(String, Moments)>,
    /// Displacements of hardpoints of a sheet, m.
    #[serde(default, rename = "move", deserialize_with = "value::by_name")]
    #[schemars(with = "BTreeMap<String, Point>")]
    pub moves: Vec<(String, Point)>,
    /// Armatures by joint.
    #[serde(default, deserialize_with = "value::armatures")]
    #[schemars(with = "BTreeMap<String, OneOrMany<f64>>")]
    pub armature: Vec<(String, Vec<f64>)>,
    /// Positions of driving joints.
    #[serde(default, deserialize_with = "value::positions")]
    #[schemars(with = "BTreeMap<String, PositionText>")]
    pub set: Vec<(String, GivenPosition)>,
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
    /// Contact of the variant, if it is not that of the study.
    pub contact: Option<ContactTable>,
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
        let model = Model::load_named(path, self.max_size, self.options, None, false)?;
        self.by_path.insert(path.to_owned(), model.clone());
        Ok(model)
    }
}

/// Replaces the entries of a list that have the same name, and adds the others.
pub(crate) fn replace_by_name<T: Clone>(list: &mut Vec<(String, T)>, entries: &[(String, T)]) {
    list.retain(|(name, _)| !entries.iter().any(|(other, _)| other == name));
    list.extend_from_slice(entries);
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
        let model = other.with_changes(&Changes {
            shape_density: None,
            total_mass: None,
            link_mass: masses(&self.link_mass),
            link_com: points(&self.link_com),
            link_inertia: moments(&self.link_inertia),
            moves: points(&self.moves),
        })?;
        let mut question = question.clone();
        replace_by_name(&mut question.conditions.armature, &self.armature);
        replace_by_name(&mut question.pose.set, &self.set);
        Ok(Variant { name: self.name.clone(), model, question, contact: self.contact.clone() })
    }
}
