//! Settings and classes of the main model and of the attached models. An element has those of the model whose file contains it.

use crate::mjcf::document::files::AttachedModel;
use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::classes::{ClassId, Classes, DefaultKind};
use crate::mjcf::values::settings::Settings;
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;

/// Settings and classes of all models; the main model is the first.
pub(crate) struct Models<'t> {
    tree: &'t ElementTree,
    models: Vec<(Settings, Classes)>,
}

impl<'t> Models<'t> {
    /// Reads the settings and classes of all models.
    pub fn read(models: &[AttachedModel], findings: &mut Findings<'t>) -> Self {
        let tree = findings.tree;
        let read = |model: &AttachedModel| {
            (Settings::read(model.root, findings), Classes::read(model.root, findings))
        };
        Self { tree, models: models.iter().map(read).collect() }
    }

    /// Settings of the main model.
    pub fn main(&self) -> &Settings {
        &self.models[0].0
    }

    /// Settings for an element.
    pub fn settings(&self, element: ElementId) -> &Settings {
        &self.models[self.tree.model_of(element)].0
    }

    /// Attributes of an element with the defaults of its own class; else of `inherited`.
    pub fn attributes(
        &'t self,
        element: ElementId,
        kind: DefaultKind,
        inherited: Option<ClassId>,
        findings: &mut Findings<'_>,
    ) -> Attributes<'t> {
        let classes = self.classes(element);
        let own = classes.named(element, "class", findings);
        let class = own.or(inherited).unwrap_or(Classes::MAIN);
        Attributes::with_defaults(self.tree, element, (classes, class, kind))
    }

    /// Classes for an element.
    pub fn classes(&self, element: ElementId) -> &Classes {
        &self.models[self.tree.model_of(element)].1
    }
}
