//! Classes of defaults. A class inherits the values of the class that contains it.

use crate::mjcf::document::grammar::ACTUATOR_TAGS;
use crate::reading::element_tree::{ElementId, ElementTree};
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::quoted;
use std::collections::HashMap;

/// Index of a class in [`Classes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ClassId(usize);

/// Kind of element with defaults.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum DefaultKind {
    Mesh,
    Joint,
    Geom,
    Site,
    Equality,
    Tendon,
    /// All actuators share one set of defaults.
    Actuator,
}

impl DefaultKind {
    /// Kind of an element in a class of defaults, by its tag; `None` if no default of this kind has an effect.
    fn of_tag(tag: &str) -> Option<Self> {
        Some(match tag {
            "mesh" => DefaultKind::Mesh,
            "joint" => DefaultKind::Joint,
            "geom" => DefaultKind::Geom,
            "site" => DefaultKind::Site,
            "equality" => DefaultKind::Equality,
            "tendon" => DefaultKind::Tendon,
            _ if ACTUATOR_TAGS.contains(&tag) => DefaultKind::Actuator,
            _ => return None,
        })
    }
}

/// Class of defaults.
#[derive(Debug, Default)]
struct Class {
    parent: Option<ClassId>,
    /// Elements that give values; the last one with an attribute counts.
    settings: Vec<(DefaultKind, ElementId)>,
}

/// All classes of a model; the first is the class `main`.
#[derive(Debug)]
pub(crate) struct Classes {
    classes: Vec<Class>,
    by_name: HashMap<String, ClassId>,
}

/// Name of the top class.
const MAIN: &str = "main";

impl Classes {
    /// The class `main`, which exists without a declaration.
    pub const MAIN: ClassId = ClassId(0);

    /// Reads the `<default>` sections below a root.
    pub fn read(tree: &ElementTree, root: ElementId, findings: &mut Findings<'_>) -> Self {
        let mut classes =
            Self { classes: vec![Class::default()], by_name: HashMap::from([(MAIN.to_owned(), Self::MAIN)]) };
        for section in tree.children_named(root, "default") {
            if let Some(name) = tree.attribute(section, "class").filter(|name| *name != MAIN) {
                findings.attribute_error("bad-class", section, "class", || {
                    format!("the top class is {}; its only name is \"main\", or none", quoted(name))
                });
            }
            classes.read_class(tree, section, Self::MAIN, findings);
        }
        classes
    }

    /// Reads the contents of a class. The recursion is bounded by the nesting of the elements.
    fn read_class(
        &mut self,
        tree: &ElementTree,
        element: ElementId,
        class: ClassId,
        findings: &mut Findings<'_>,
    ) {
        for &child in tree.children(element) {
            if let Some(kind) = DefaultKind::of_tag(tree.tag(child)) {
                self.classes[class.0].settings.push((kind, child));
            }
            if tree.tag(child) != "default" {
                continue;
            }
            let name = tree.attribute(child, "class").unwrap_or_default();
            if name.is_empty() {
                findings.error("bad-class", child, || {
                    "a <default> within another has no attribute \"class\", by which elements name it"
                        .to_owned()
                });
                continue;
            }
            let id = ClassId(self.classes.len());
            if self.by_name.contains_key(name) {
                findings.attribute_error("duplicate-name", child, "class", || {
                    format!("the class {} was given before; names of classes are unique", quoted(name))
                });
                continue;
            }
            self.by_name.insert(name.to_owned(), id);
            self.classes.push(Class { parent: Some(class), settings: Vec::new() });
            self.read_class(tree, child, id, findings);
        }
    }

    /// Class that an attribute names (`class` or `childclass`); `None` without the attribute, or, with an error, if the class is
    /// unknown.
    pub fn named(
        &self,
        tree: &ElementTree,
        element: ElementId,
        attribute: &'static str,
        findings: &mut Findings<'_>,
    ) -> Option<ClassId> {
        let name = tree.attribute(element, attribute)?;
        let found = self.by_name.get(name).copied();
        if found.is_none() {
            findings.attribute_error("unknown-class", element, attribute, || {
                let guess = similar_name(name, self.by_name.keys().map(String::as_str));
                format!("the class {} does not exist{guess}", quoted(name))
            });
        }
        found
    }

    /// Nearest element with one of the attributes among the defaults of a class and of the classes that contain it.
    pub fn find(
        &self,
        tree: &ElementTree,
        class: ClassId,
        kind: DefaultKind,
        attributes: &[&str],
    ) -> Option<ElementId> {
        let mut current = Some(class);
        while let Some(id) = current {
            let class = &self.classes[id.0];
            let of_kind = class.settings.iter().rev().filter(|(found, _)| *found == kind);
            let mut with_attribute = of_kind.filter(|(_, element)| {
                attributes.iter().any(|name| tree.attribute(*element, name).is_some())
            });
            if let Some((_, element)) = with_attribute.next() {
                return Some(*element);
            }
            current = class.parent;
        }
        None
    }
}
