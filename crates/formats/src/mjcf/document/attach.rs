//! Attached models: every `<attach>` gets a copy of a body, a frame or the world of a model as its children, and the main model gets
//! copies of the constraints, tendons, actuators and meshes that belong to the copy. All names of a copy have a prefix.

use crate::mjcf::document::files::AttachedModel;
use crate::reading::document::element_tree::{Attribute, Element, ElementId, ElementTree};
use crate::reading::document::files::Files;
use crate::reading::limits::{
    LONGEST_NAME, MAX_ATTACH_STEPS, MAX_COPIED_BYTES, MAX_ELEMENT_DEPTH, MAX_ELEMENTS,
};
use crate::reading::report::{Place, Report, quoted, shortened};
use percuss_mechanism::Severity;
use std::collections::HashSet;

/// Kinds of elements that others refer to by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Kind {
    Body,
    Joint,
    Site,
    Geom,
    Tendon,
    Asset,
}

/// Attributes that refer to elements, separated by blanks, by the kind of these elements.
const REFERENCES: [(&str, Kind); 6] = [
    ("body body1 body2", Kind::Body),
    ("joint joint1 joint2 jointinparent", Kind::Joint),
    ("site site1 site2 refsite cranksite slidersite sidesite", Kind::Site),
    ("geom", Kind::Geom),
    ("tendon tendon1 tendon2", Kind::Tendon),
    ("mesh hfield", Kind::Asset),
];

/// Kind of the elements to which an attribute refers; `None` for other attributes.
fn referred_kind(attribute: &str) -> Option<Kind> {
    let has_name = |names: &str| names.split(' ').any(|name| name == attribute);
    REFERENCES.iter().find(|(names, _)| has_name(names)).map(|(_, kind)| *kind)
}

/// Sections of which elements are copied, in an order in which every section refers to earlier ones only.
const SECTIONS: [&str; 4] = ["asset", "tendon", "equality", "actuator"];

/// Names by kind.
type Names = HashSet<(Kind, String)>;

/// Progress of the attachments within a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Waiting,
    Started,
    Done,
}

/// Carries out all attachments. Defects are reported; after an error the tree may be incomplete.
pub(crate) fn attach_models(files: &mut Files, models: &[AttachedModel]) {
    let Files { tree, reports, .. } = files;
    let states = vec![State::Waiting; models.len()];
    Attacher { tree, reports, models, states, steps: 0, bytes: 0, expanded: HashSet::new() }.complete(0);
}

struct Attacher<'f> {
    tree: &'f mut ElementTree,
    reports: &'f mut [Report],
    models: &'f [AttachedModel],
    states: Vec<State>,
    /// Elements searched for names.
    steps: usize,
    /// Size of the copies, bytes.
    bytes: usize,
    /// Elements `<attach>` with contents.
    expanded: HashSet<ElementId>,
}

impl Attacher<'_> {
    /// Carries out the attachments of a model. The recursion is bounded by the nesting of the models.
    fn complete(&mut self, model: usize) {
        self.states[model] = State::Started;
        let worlds: Vec<ElementId> = self.tree.children_named(self.models[model].root, "worldbody").collect();
        let waiting: Vec<ElementId> = worlds.into_iter().flat_map(|world| self.unexpanded(world)).collect();
        for element in waiting {
            if self.attach(model, element).is_none() {
                return;
            }
        }
        self.states[model] = State::Done;
    }

    /// Elements `<attach>` below an element that wait for their contents, in the order of the file.
    fn unexpanded(&self, element: ElementId) -> Vec<ElementId> {
        let mut found = Vec::new();
        let mut stack = vec![element];
        while let Some(id) = stack.pop() {
            if self.tree.tag(id) == "attach" && !self.expanded.contains(&id) {
                found.push(id);
            }
            stack.extend(self.tree.children(id).iter().rev());
        }
        found
    }

    /// Reports an error at an attribute; returns `None`.
    fn refuse<T>(
        &mut self,
        code: &'static str,
        element: ElementId,
        attribute: &str,
        message: impl Into<String>,
    ) -> Option<T> {
        let offset = self.tree.attribute_offset(element, attribute);
        let file = self.tree.element(element).file;
        self.reports[file].error(code, Place::Named(offset, "attach"), || message.into());
        None
    }

    /// Carries out one attachment; `None` after an error.
    fn attach(&mut self, own: usize, element: ElementId) -> Option<()> {
        let text = |name: &str| self.tree.attribute(element, name).map(str::to_owned);
        let (name, body, frame, prefix) = (text("model"), text("body"), text("frame"), text("prefix"));
        let model = match &name {
            None => own,
            Some(name) => match self.models[own].attachable.iter().find(|(known, _)| known == name) {
                Some((_, model)) => *model,
                None => {
                    let message = format!(
                        "the model {} does not exist; an <asset> names it: <model name=\"...\" file=\"...\"/>",
                        quoted(name)
                    );
                    return self.refuse("unknown-reference", element, "model", message);
                }
            },
        };
        if model != own {
            match self.states[model] {
                State::Waiting => self.complete(model),
                State::Started => {
                    let message = "the attached model attaches this one: a circle of models has no end";
                    return self.refuse("attach-circle", element, "model", message);
                }
                State::Done => {}
            }
            if self.states[model] != State::Done {
                return None;
            }
        }
        let sources = match (&body, &frame) {
            (Some(_), Some(_)) => {
                let message = "both body and frame are given; one of them, or none, is expected";
                return self.refuse("two-notations", element, "frame", message);
            }
            (Some(wanted), None) => self.find(element, model, "body", wanted)?,
            (None, Some(wanted)) => self.find(element, model, "frame", wanted)?,
            (None, None) if model == own => {
                let message = "without a model, body or frame names the part of this model to attach";
                return self.refuse("missing-attribute", element, "prefix", message);
            }
            (None, None) => self.tree.children_named(self.models[model].root, "worldbody").collect(),
        };
        let holds_itself = sources.iter().any(|source| !self.unexpanded(*source).is_empty());
        if holds_itself {
            let message = "the attached part contains an <attach> that comes later, or this one";
            return self.refuse("attach-circle", element, "body", message);
        }
        self.expanded.insert(element);
        let prefix = prefix.unwrap_or_default();
        let within = self.names(&sources);
        for source in sources {
            let class = self.inherited_class(source);
            let copy = self.copy(source, element, &prefix, element)?;
            let copied = &mut self.tree.elements[copy.0 as usize];
            if copied.tag == "worldbody" {
                copied.tag = "frame".to_owned();
            }
            if let Some(class) = class.filter(|_| copied.attributes.iter().all(|a| a.name != "childclass")) {
                let offset = copied.offset;
                copied.attributes.push(Attribute { name: "childclass".to_owned(), value: class, offset });
            }
        }
        self.copy_sections(element, own, model, within, &prefix)
    }

    /// Body or frame with a name in the tree of a model, as a list of one element.
    fn find(&mut self, element: ElementId, model: usize, tag: &str, name: &str) -> Option<Vec<ElementId>> {
        let mut stack: Vec<ElementId> =
            self.tree.children_named(self.models[model].root, "worldbody").collect();
        while let Some(id) = stack.pop() {
            if self.tree.tag(id) == tag && self.tree.attribute(id, "name") == Some(name) {
                return Some(vec![id]);
            }
            stack.extend(self.tree.children(id));
        }
        let message = format!("the attached model has no {tag} {}", quoted(name));
        self.refuse("unknown-reference", element, tag, message)
    }

    /// Nearest `childclass` above an element.
    fn inherited_class(&self, element: ElementId) -> Option<String> {
        let above = |id: &ElementId| self.tree.element(*id).parent;
        let mut ancestors = std::iter::successors(above(&element), above);
        ancestors.find_map(|id| self.tree.attribute(id, "childclass")).map(str::to_owned)
    }

    /// Names of the bodies, joints, sites and geoms below elements, and of the elements themselves.
    fn names(&mut self, sources: &[ElementId]) -> Names {
        let mut names = Names::new();
        let mut stack = sources.to_vec();
        while let Some(id) = stack.pop() {
            self.steps += 1;
            let kind = match self.tree.tag(id) {
                "body" => Some(Kind::Body),
                "joint" | "freejoint" => Some(Kind::Joint),
                "site" => Some(Kind::Site),
                "geom" => Some(Kind::Geom),
                "fixed" | "spatial" => Some(Kind::Tendon),
                _ => None,
            };
            if let (Some(kind), Some(name)) = (kind, self.tree.attribute(id, "name")) {
                names.insert((kind, name.to_owned()));
            }
            stack.extend(self.tree.children(id));
        }
        names
    }

    /// Copies an element and its descendants below `parent`; `None`, with an error at `cause`, beyond a limit.
    fn copy(
        &mut self,
        source: ElementId,
        parent: ElementId,
        prefix: &str,
        cause: ElementId,
    ) -> Option<ElementId> {
        let mut first = None;
        let above = |id: &ElementId| self.tree.element(*id).parent;
        let depth = std::iter::successors(Some(parent), above).count();
        let mut stack = vec![(source, parent, depth)];
        while let Some((source, parent, depth)) = stack.pop() {
            let element = self.tree.element(source);
            self.bytes += size_of::<Element>();
            for attribute in &element.attributes {
                let lead = if is_prefixed(&attribute.name, &attribute.value) { prefix.len() } else { 0 };
                if lead > 0 && lead + attribute.value.len() > LONGEST_NAME {
                    let message = format!(
                        "with the prefix a name is {} bytes long; at most {LONGEST_NAME} are read",
                        lead + attribute.value.len()
                    );
                    return self.refuse("long-name", cause, "prefix", message);
                }
                let text = attribute.name.len() + attribute.value.len() + lead;
                self.bytes = self.bytes.saturating_add(size_of::<Attribute>() + text);
            }
            let limit = if self.tree.elements.len() >= MAX_ELEMENTS {
                format!("more than {MAX_ELEMENTS} elements")
            } else if depth > MAX_ELEMENT_DEPTH {
                format!("elements nested deeper than {MAX_ELEMENT_DEPTH} levels")
            } else if self.bytes > MAX_COPIED_BYTES {
                format!("more than {} MiB of copies", MAX_COPIED_BYTES >> 20)
            } else {
                String::new()
            };
            if !limit.is_empty() {
                let message = format!("with all attached models, the model has {limit}");
                return self.refuse("too-complex", cause, "model", message);
            }
            let attributes = element.attributes.iter().map(|attribute| Attribute {
                name: attribute.name.clone(),
                value: match is_prefixed(&attribute.name, &attribute.value) {
                    true => format!("{prefix}{}", attribute.value),
                    false => attribute.value.clone(),
                },
                offset: attribute.offset,
            });
            let copied = Element::empty(element.tag.clone(), Some(parent), element.file, element.offset);
            let copied = Element { attributes: attributes.collect(), ..copied };
            let children = element.children.clone();
            let id = self.tree.append(copied);
            if self.expanded.contains(&source) {
                self.expanded.insert(id);
            }
            first.get_or_insert(id);
            stack.extend(children.into_iter().rev().map(|child| (child, id, depth + 1)));
        }
        first
    }

    /// Copies the meshes of a model, and those of its tendons, constraints and actuators that refer only to the names `within` the
    /// copy. A name that the model does not have is copied too: it is an error.
    fn copy_sections(
        &mut self,
        cause: ElementId,
        own: usize,
        model: usize,
        mut within: Names,
        prefix: &str,
    ) -> Option<()> {
        let (root, target) = (self.models[model].root, self.models[own].root);
        let all = self.names(&[root]);
        if self.steps > MAX_ATTACH_STEPS {
            let message = "too many attachments of a large model";
            return self.refuse("too-complex", cause, "model", message);
        }
        for section in SECTIONS {
            // Meshes of the same model have their names already, but without the prefix.
            let elements: Vec<ElementId> = self.tree.in_sections_of(root, section).collect();
            let mut chosen = Vec::new();
            for element in elements {
                let names = self.references(element);
                let is_inside = |name: &(Kind, String)| within.contains(name) || !all.contains(name);
                match section {
                    "asset" if self.tree.tag(element) != "mesh" => {}
                    "asset" => chosen.push(element),
                    _ if names.iter().all(is_inside) => chosen.push(element),
                    _ if names.iter().any(|name| within.contains(name)) => self.warn_of_omission(element),
                    _ => {}
                }
            }
            if section == "tendon" {
                let tendons = self.names(&chosen);
                within.extend(tendons);
            }
            if chosen.is_empty() {
                continue;
            }
            let (file, offset) = (self.tree.element(cause).file, self.tree.element(cause).offset);
            let holder = self.tree.append(Element::empty(section.to_owned(), Some(target), file, offset));
            for element in chosen {
                let copy = self.copy(element, holder, prefix, cause)?;
                if section == "asset" {
                    self.name_mesh(copy, prefix);
                }
            }
        }
        Some(())
    }

    /// Warns about an element that refers to the attached part and to another part of its model.
    fn warn_of_omission(&mut self, element: ElementId) {
        let (file, offset) = (self.tree.element(element).file, self.tree.element(element).offset);
        let place = Place::Named(offset, self.tree.tag(element));
        self.reports[file].add_once(Severity::Warning, "attached-part", "reference".to_owned(), place, || {
            "not attached: the element refers to a part of its model that is not attached; MuJoCo leaves it out too, unless the \
             surrounding model has a part of that name"
                .to_owned()
        });
    }

    /// Gives a mesh without a name that of its file, with the prefix.
    fn name_mesh(&mut self, mesh: ElementId, prefix: &str) {
        let element = &mut self.tree.elements[mesh.0 as usize];
        let value = |name: &str| element.attributes.iter().find(|a| a.name == name).map(|a| a.value.clone());
        if let (None, Some(file)) = (value("name"), value("file")) {
            let base = file.rsplit(['/', '\\']).next().unwrap_or(&file);
            let stem = base.rsplit_once('.').map_or(base, |(stem, _)| stem);
            let value = format!("{prefix}{}", shortened(stem.trim()));
            element.attributes.push(Attribute { name: "name".to_owned(), value, offset: element.offset });
        }
    }

    /// Names to which an element and its descendants refer, without meshes and without the world.
    fn references(&self, element: ElementId) -> Vec<(Kind, String)> {
        let mut found = Vec::new();
        let mut stack = vec![element];
        while let Some(id) = stack.pop() {
            for attribute in &self.tree.element(id).attributes {
                let kind = referred_kind(&attribute.name);
                if let Some(kind) = kind.filter(|kind| *kind != Kind::Asset && attribute.value != "world") {
                    found.push((kind, attribute.value.clone()));
                }
            }
            stack.extend(self.tree.children(id));
        }
        found
    }
}

/// True if the value of an attribute has the prefix in a copy: names and references.
fn is_prefixed(attribute: &str, value: &str) -> bool {
    let is_name = attribute == "name" || referred_kind(attribute).is_some();
    let is_world = value == "world" && ["body", "body1", "body2"].contains(&attribute);
    is_name && !value.is_empty() && !is_world
}
