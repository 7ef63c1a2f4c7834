//! Classes of defaults. A class inherits the values of the class that contains it.

use crate::mjcf::document::grammar::is_actuator;
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::{Findings, similar_name};
use crate::reading::report::quoted;
use std::cell::RefCell;
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
            _ if is_actuator(tag) => DefaultKind::Actuator,
            _ => return None,
        })
    }
}

/// Class of defaults.
#[derive(Debug, Default)]
struct Class {
    parent: Option<ClassId>,
    /// Number of classes that contain the class.
    level: usize,
    /// Last element that gives an attribute of a kind.
    settings: HashMap<(DefaultKind, String), ElementId>,
}

/// All classes of a model; the first is the class `main`.
#[derive(Debug)]
pub(crate) struct Classes {
    classes: Vec<Class>,
    by_name: HashMap<String, ClassId>,
    /// Results of [`find_attribute`](Self::find_attribute): a chain of classes is followed once for each attribute.
    found: RefCell<HashMap<SettingKey, Option<Setting>>>,
}

/// Level of a class, and the element there that gives an attribute.
type Setting = (usize, ElementId);

/// Class, kind of element, and attribute.
type SettingKey = (usize, DefaultKind, &'static str);

/// Name of the top class.
const MAIN: &str = "main";

impl Classes {
    /// The class `main`, which exists without a declaration.
    pub const MAIN: ClassId = ClassId(0);

    /// Reads the `<default>` sections below a root.
    pub fn read(root: ElementId, findings: &mut Findings<'_>) -> Self {
        let mut classes = Self {
            classes: vec![Class::default()],
            by_name: HashMap::from([(MAIN.to_owned(), Self::MAIN)]),
            found: RefCell::default(),
        };
        for section in findings.tree.children_named(root, "default") {
            if let Some(name) = findings.tree.attribute(section, "class").filter(|name| *name != MAIN) {
                findings.attribute_error("bad-class", section, "class", || {
                    format!("the top class is {}; its only name is \"main\", or none", quoted(name))
                });
            }
            classes.read_class(section, Self::MAIN, findings);
        }
        classes
    }

    /// Reads the contents of a class. The recursion is bounded by the nesting of the elements.
    fn read_class(&mut self, element: ElementId, class: ClassId, findings: &mut Findings<'_>) {
        let tree = findings.tree;
        for &child in tree.children(element) {
            if let Some(kind) = DefaultKind::of_tag(tree.tag(child)) {
                for attribute in &tree.element(child).attributes {
                    let key = (kind, attribute.name.clone());
                    self.classes[class.0].settings.insert(key, child);
                }
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
            let level = self.classes[class.0].level + 1;
            self.classes.push(Class { parent: Some(class), level, ..Class::default() });
            self.read_class(child, id, findings);
        }
    }

    /// Class that an attribute names (`class` or `childclass`); `None` without the attribute, or, with an error, if the class is
    /// unknown.
    pub fn named(
        &self,
        element: ElementId,
        attribute: &'static str,
        findings: &mut Findings<'_>,
    ) -> Option<ClassId> {
        let name = findings.tree.attribute(element, attribute)?;
        let found = self.by_name.get(name).copied();
        if found.is_none() {
            findings.attribute_error("unknown-class", element, attribute, || {
                let guess = similar_name(name, self.by_name.keys().map(String::as_str));
                format!("the class {} does not exist{guess}", quoted(name))
            });
        }
        found
    }

    /// Nearest element with one of the attributes among the defaults of a class and of the classes that contain it; the last one of a
    /// class counts.
    pub fn find(&self, class: ClassId, kind: DefaultKind, attributes: &[&'static str]) -> Option<ElementId> {
        let found = attributes.iter().filter_map(|name| self.find_attribute(class, kind, name));
        // Later elements have higher numbers.
        found.max_by_key(|(level, element)| (*level, element.0)).map(|(_, element)| element)
    }

    /// Element that gives an attribute to a class; constant time on average.
    fn find_attribute(&self, class: ClassId, kind: DefaultKind, name: &'static str) -> Option<Setting> {
        let mut known = self.found.borrow_mut();
        let mut path = Vec::new();
        let mut current = Some(class);
        let mut result = None;
        while let Some(id) = current {
            if let Some(found) = known.get(&(id.0, kind, name)) {
                result = *found;
                break;
            }
            let class = &self.classes[id.0];
            path.push(id);
            if let Some(element) = class.settings.get(&(kind, name.to_owned())) {
                result = Some((class.level, *element));
                break;
            }
            current = class.parent;
        }
        known.extend(path.into_iter().map(|id| ((id.0, kind, name), result)));
        result
    }
}
