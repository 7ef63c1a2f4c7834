//! Main file and included files of a model, joined to one tree.
//!
//! An `<include>` gets the root element of its file as a child. A file may be included several times, but not within itself.

use crate::SharedFiles;
use crate::reading::document::element_tree::{Element, ElementId};
use crate::reading::document::files::Files;
use crate::reading::limits::{MAX_INCLUDED_FILES, MAX_MODEL_DEPTH};
use crate::reading::report::{Place, Report, quoted, shortened};
use crate::reading::xml;
use crate::sdf::document::uri::find_model_file;
use percuss_mechanism::Severity;
use roxmltree::Node;
use std::path::{Path, PathBuf};

/// Reads the main file (`text`, named `name`) and its included files, which are in `store`. Defects are reported; after an error the tree
/// may be incomplete, or empty.
///
/// `wanted`: model that is chosen. An include in another model that cannot be read is a warning, unless joints of the world can join the models.
pub(crate) fn read_files(
    store: &SharedFiles,
    (name, wanted): (&str, Option<&str>),
    text: &str,
    report: Report,
) -> Files {
    let files = Files::new(store, name, text, report);
    let open = vec![files.canonical(Path::new(name))];
    let mut reader = FileReader { files, store, wanted, open };
    reader.append_file(0, None, 0);
    reader.files
}

struct FileReader<'a> {
    files: Files,
    store: &'a SharedFiles,
    /// Chosen model; `None` also if joints of the world can join the models.
    wanted: Option<&'a str>,
    /// Canonical paths of the files that contain the current element, from the main file on.
    open: Vec<PathBuf>,
}

impl FileReader<'_> {
    /// Parses file number `file` and appends its root element below `parent`.
    fn append_file(&mut self, file: usize, parent: Option<ElementId>, depth: usize) {
        let text = self.files.tree.files[file].text.clone();
        let Some(document) = xml::parse(&text, &mut self.files.reports[file]) else { return };
        let root = document.root_element();
        let tag = root.tag_name().name();
        if tag != "sdf" {
            let remedy = match tag {
                "robot" => {
                    "a URDF is not included; convert it with \"percuss convert FILE.urdf -o FILE.sdf\""
                }
                "gazebo" => "this is an old SDF file; convert it with \"gz sdf -p FILE\"",
                _ => "the root of an SDF file is <sdf>",
            };
            self.files.reports[file].error("wrong-root", Place::Element(root), || {
                format!("the root element is <{}>: {remedy}", shortened(tag))
            });
            return;
        }
        if parent.is_none() {
            let holders = root.children().filter(|child| child.has_tag_name("world")).chain([root]);
            let joins = holders.flat_map(|holder| holder.children()).any(|child| child.has_tag_name("joint"));
            self.wanted = self.wanted.filter(|_| !joins);
        }
        self.append_element(root, file, parent, depth);
    }

    /// Appends an element and its descendants. The recursion is bounded by the nesting of the elements.
    fn append_element(&mut self, node: Node<'_, '_>, file: usize, parent: Option<ElementId>, depth: usize) {
        if self.files.is_full(file, node.range().start, depth) {
            return;
        }
        let id = self.files.tree.append(element(node, file, parent));
        for child in node.children().filter(Node::is_element) {
            self.append_element(child, file, Some(id), depth + 1);
        }
        let holder = parent.map(|parent| self.files.tree.tag(parent));
        if node.tag_name().name() == "include"
            && matches!(holder, Some("sdf" | "world" | "model"))
            && !self.is_unread(id)
        {
            self.include(node, file, id, depth);
        }
    }

    /// True below an element whose contents are no part of the model.
    fn is_unread(&self, id: ElementId) -> bool {
        let tree = &self.files.tree;
        let mut holders = std::iter::successors(tree.element(id).parent, |id| tree.element(*id).parent);
        holders.any(|holder| matches!(tree.tag(holder), "plugin" | "population" | "state"))
    }

    /// Appends the root element of an included file below its `<include>`.
    fn include(&mut self, node: Node<'_, '_>, file: usize, include: ElementId, depth: usize) {
        let place = Place::Element(node);
        let tree = &self.files.tree;
        let uri = tree.child(include, "uri").map(|uri| tree.text(uri).to_owned()).unwrap_or_default();
        if uri.is_empty() {
            self.files.reports[file]
                .error("missing-element", place, || "<include> has no <uri>, the path of a model".to_owned());
            return;
        }
        if tree.files.len() > MAX_INCLUDED_FILES || self.open.len() > MAX_MODEL_DEPTH {
            self.files.reports[file].error("too-complex", place, || {
                format!(
                    "more than {MAX_INCLUDED_FILES} included files, or files included more than {MAX_MODEL_DEPTH} levels deep"
                )
            });
            return;
        }
        let is_in_other_model = self.is_in_other_model(include);
        let severity = if is_in_other_model { Severity::Warning } else { Severity::Error };
        let path = match find_model_file(self.store, &uri, Path::new(&tree.files[file].name)) {
            Ok(path) => path,
            Err(message) => {
                // A world may include lights and scenery that are not at hand; its models are chosen later.
                let holder = tree.element(include).parent.map(|parent| tree.tag(parent));
                let is_part = holder == Some("model") && !is_in_other_model;
                let severity = if is_part { Severity::Error } else { Severity::Warning };
                self.files.reports[file].add(severity, "no-such-file", place, || message);
                return;
            }
        };
        let canonical = self.files.canonical(&path);
        if self.open.contains(&canonical) {
            self.files.reports[file].add(severity, "include-cycle", place, || {
                format!(
                    "the model {} is included within itself, without end; remove one of the includes",
                    quoted(&uri)
                )
            });
            return;
        }
        let index = match self.files.open(&path, 0) {
            Ok(index) => index,
            Err(reason) => {
                self.files.reports[file].add(severity, "unreadable", place, || {
                    format!("the included model {} cannot be read: {reason}", quoted(&uri))
                });
                return;
            }
        };
        if !self.files.reports[index].has_errors() {
            self.open.push(canonical);
            self.append_file(index, Some(include), depth + 1);
            self.open.pop();
        }
        if is_in_other_model && self.files.reports[index].has_errors() {
            let report = std::mem::take(&mut self.files.reports[index]);
            let read = &self.files.tree.files[index];
            let first = report
                .finish(&read.name, &read.text)
                .into_iter()
                .find(|found| found.severity == Severity::Error);
            self.files.reports[file].warning("unreadable", place, || {
                let reason = first.map(|found| found.message).unwrap_or_default();
                format!("another model includes {}, which is not read: {reason}", quoted(&uri))
            });
        }
    }

    /// True if an `<include>` belongs to another model of the main file than the wanted one.
    fn is_in_other_model(&self, include: ElementId) -> bool {
        let Some(wanted) = self.wanted else { return false };
        let tree = &self.files.tree;
        let above = |id: &ElementId| tree.element(*id).parent;
        let is_holder = |id: ElementId| tree.element(id).file == 0 && matches!(tree.tag(id), "sdf" | "world");
        let mut chain = std::iter::successors(Some(include), above);
        let Some(outer) = chain.find(|id| above(id).is_some_and(is_holder)) else { return false };
        let name = match tree.tag(outer) {
            "model" => tree.attribute(outer, "name"),
            _ => tree.child(outer, "name").map(|name| tree.text(name)),
        };
        let is_wanted = |name: &str| wanted == name || wanted.ends_with(&format!("::{name}"));
        name.is_some_and(|name| !is_wanted(name))
    }
}

/// Element without its children. The prefix of a namespace stays in the tag; attributes in a namespace have no meaning.
fn element(node: Node<'_, '_>, file: usize, parent: Option<ElementId>) -> Element {
    let name = node.tag_name();
    let prefix = name.namespace().and_then(|uri| node.lookup_prefix(uri)).filter(|prefix| !prefix.is_empty());
    let tag = match prefix {
        Some(prefix) => format!("{prefix}:{}", name.name()),
        None => name.name().to_owned(),
    };
    let text = xml::text_of(node).unwrap_or_default();
    let own = Element::new(node, file, parent, |attribute| attribute.namespace().is_none());
    Element { tag, text: text.trim_ascii().to_owned(), ..own }
}
