//! Tables of a study for a page that shows and changes its question.

use super::text::StudyTables;
use super::variant::{VariantText, replace_by_name};
use crate::question::link_points::Hold;
use crate::question::tables::contact::{ConditionsTable, ContactTable, PoseTable};
use crate::question::tables::model::ModelTable;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Tables of a study as its file has them. The path of the model starts at the current folder.
#[derive(Clone, Debug, Default, Serialize)]
pub struct PageTables {
    /// Model with its changes.
    pub model: ModelTable,
    /// Contact; empty if the study has none.
    pub contact: ContactTable,
    /// Pose.
    pub pose: PoseTable,
    /// Conditions.
    pub conditions: ConditionsTable,
    /// Held points.
    pub hold: Vec<Hold>,
    /// Tables `damping`, `impact` and `safe_speed` as in the file; null if absent.
    pub panels: PanelTables,
    /// Quantity that the first range of the sweep varies.
    pub varied: Option<String>,
    /// Variants of the same model file.
    pub variants: Vec<VariantTables>,
    /// Names of the variants of another model file, which are left out.
    pub other_models: Vec<String>,
    /// Number of additional loops, which no table above contains.
    pub closures: usize,
}

/// Tables of a study with the initial values of the panels of a page.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct PanelTables {
    /// Damper.
    pub damping: Option<toml::Table>,
    /// Impact.
    pub impact: Option<toml::Table>,
    /// Safe speed.
    pub safe_speed: Option<toml::Table>,
}

/// Tables of a variant.
#[derive(Clone, Debug, Serialize)]
pub struct VariantTables {
    /// Name.
    pub name: String,
    /// Model with the changes of the study and of the variant.
    pub model: ModelTable,
    /// Contact.
    pub contact: ContactTable,
    /// Pose.
    pub pose: PoseTable,
    /// Conditions.
    pub conditions: ConditionsTable,
}

impl PageTables {
    /// Tables of the text of a study in the given folder, at one of its contacts.
    pub(crate) fn from_text(text: &StudyTables, contact: &ContactTable, folder: &Path) -> Self {
        let path = folder.join(&text.model.path).to_string_lossy().into_owned();
        let mut tables = Self {
            model: ModelTable { path, ..text.model.clone() },
            contact: ContactTable { name: None, ..contact.clone() },
            pose: text.pose.clone(),
            conditions: text.conditions.clone(),
            hold: text.hold.clone(),
            varied: text.sweep.as_ref().and_then(|sweep| sweep.vary.first()).map(|vary| vary.name()),
            closures: text.closure.len(),
            ..Self::default()
        };
        for variant in &text.variant {
            if variant.model.is_some() {
                tables.other_models.push(variant.name.clone());
            } else {
                let shown = tables.variant(variant);
                tables.variants.push(shown);
            }
        }
        tables
    }

    /// Tables of the study with the changes of a variant.
    fn variant(&self, variant: &VariantText) -> VariantTables {
        let (mut model, mut pose, mut conditions) =
            (self.model.clone(), self.pose.clone(), self.conditions.clone());
        replace_by_name(&mut model.link_mass, &variant.link_mass);
        replace_by_name(&mut model.link_com, &variant.link_com);
        replace_by_name(&mut model.link_inertia, &variant.link_inertia);
        replace_by_name(&mut model.moves, &variant.moves);
        replace_by_name(&mut pose.set, &variant.set);
        replace_by_name(&mut conditions.armature, &variant.armature);
        VariantTables {
            name: variant.name.clone(),
            model,
            contact: variant.contact.clone().unwrap_or_else(|| self.contact.clone()),
            pose,
            conditions,
        }
    }
}
