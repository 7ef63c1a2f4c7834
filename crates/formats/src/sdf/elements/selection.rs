//! Choice of one model of a file.

use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::{quoted, shortened};
use crate::sdf::document::version::check_version;
use crate::sdf::frames::walk::{included_model, model_name};
use crate::sdf::values::text_in;
use crate::urdf::elements::sdf_values::parse_boolean;

/// Chosen model.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Selected {
    /// `<world>` or `<sdf>` that contains the model.
    pub container: ElementId,
    /// `<model>` or `<include>`.
    pub model: ElementId,
}

/// Chooses the model with the name `wanted`; without a name, the only model, or the only one that is not static. `None`, with an error
/// that lists the models, if none or several are left.
pub(crate) fn select_model(wanted: Option<&str>, findings: &mut Findings<'_>) -> Option<Selected> {
    let tree = findings.tree;
    let sdf = tree.root();
    for index in 0..tree.elements.len() {
        let element = ElementId(index as u32);
        // Plugins may contain elements of any name.
        let holder = tree.element(element).parent.map(|holder| tree.tag(holder));
        if tree.tag(element) == "sdf" && matches!(holder, None | Some("include")) {
            check_version(element, findings);
        }
    }
    let worlds = tree.children_named(sdf, "world");
    let containers: Vec<ElementId> = [sdf].into_iter().chain(worlds).collect();
    let models = containers.iter().flat_map(|container| {
        let models = tree.children(*container).iter().copied();
        let models = models.filter(|child| matches!(tree.tag(*child), "model" | "include"));
        models
            .filter(|model| included_model(tree, *model).is_some())
            .map(|model| Selected { container: *container, model })
    });
    let models: Vec<Selected> = models.collect();
    // A model of a world has a second name with that of the world.
    let names = |selected: &Selected| {
        let name = model_name(tree, selected.model).to_owned();
        let world = tree.attribute(selected.container, "name").unwrap_or_default();
        let full = format!("{world}::{name}");
        [name, full]
    };
    let is_static = |selected: &Selected| {
        let model = included_model(tree, selected.model).unwrap_or(selected.model);
        let given =
            [selected.model, model].into_iter().find(|element| tree.child(*element, "static").is_some());
        given.is_some_and(|element| parse_boolean(text_in(tree, element, "static")) == Some(true))
    };
    let list = |models: &[Selected]| {
        let shown: Vec<String> = models.iter().take(20).map(|model| names(model)[0].clone()).collect();
        let more = if models.len() > shown.len() { ", …" } else { "" };
        format!("{}{more}", shown.iter().map(|name| shortened(name)).collect::<Vec<_>>().join(", "))
    };
    let candidates: Vec<Selected> = match wanted {
        Some(wanted) => {
            let of_name = |model: &&Selected| names(model).iter().any(|name| name == wanted);
            models.iter().filter(of_name).copied().collect()
        }
        None if models.len() == 1 => models.clone(),
        None => models.iter().filter(|model| !is_static(model)).copied().collect(),
    };
    match (candidates[..].first(), candidates.len(), wanted) {
        (Some(chosen), 1, _) => {
            if wanted.is_none() && models.len() > 1 {
                findings.note("other-models", chosen.model, || {
                    format!("the only model that is not static is read; the file has {}", list(&models))
                });
            }
            return Some(*chosen);
        }
        (_, _, Some(wanted)) => findings.error("unknown-model", sdf, || {
            let all: Vec<String> = models.iter().map(|model| names(model)[0].clone()).collect();
            let guess = similar_name(wanted, all.iter().map(String::as_str));
            let several = if candidates.is_empty() { "no model" } else { "several models" };
            format!("{several} of the name {}{guess}; the file has {}", quoted(wanted), list(&models))
        }),
        (None, ..) if models.is_empty() => {
            findings
                .error("no-model", sdf, || "the file has no <model>, in <sdf> or in a <world>".to_owned());
        }
        _ => findings.error("several-models", sdf, || {
            format!("the file has several models: {}. Name one behind the file, FILE#MODEL", list(&models))
        }),
    }
    None
}
