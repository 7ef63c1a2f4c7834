//! Main file and included files of a model, joined to one tree.
//!
//! An `<include>` is replaced by the elements below the root of its file. MuJoCo searches the file relative to the folder of the main
//! file, then relative to the folder of the including file, and accepts each file once.

use crate::reading::document::element_tree::{Element, ElementId};
use crate::reading::document::files::Files;
use crate::reading::limits::{MAX_INCLUDED_FILES, MAX_MODEL_DEPTH};
use crate::reading::report::{Place, Report, quoted, shortened};
use crate::reading::xml;
use crate::{SharedFiles, Source};
use roxmltree::Node;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// Model of which parts can be attached.
#[derive(Debug)]
pub(crate) struct AttachedModel {
    pub root: ElementId,
    /// Names and indices of the models in its assets.
    pub attachable: Vec<(String, usize)>,
}

/// Reads the main file `source`, decoded as `text`, and its included files: the files, and the main model with the models that it and they
/// can attach. Defects are reported; after an error the tree may be incomplete.
pub(crate) fn read_files(source: &Source, text: &str, report: Report) -> (Files, Vec<AttachedModel>) {
    let path = Path::new(&source.name);
    let canonical = source.files.canonical(path).ok();
    let mut reader = FileReader {
        files: Files::new(&source.files, &source.name, text, report),
        models: Vec::new(),
        store: &source.files,
        folder: path.parent().map(Path::to_owned).unwrap_or_default(),
        model: 0,
        included: canonical.iter().cloned().collect(),
        open: canonical.into_iter().collect(),
    };
    reader.append_file(0, None, 0);
    if !reader.files.tree.elements.is_empty() {
        reader.models.push(AttachedModel { root: ElementId(0), attachable: Vec::new() });
        reader.read_models(0, 0);
    }
    (reader.files, reader.models)
}

struct FileReader<'a> {
    files: Files,
    models: Vec<AttachedModel>,
    store: &'a SharedFiles,
    /// Folder of the main file of the current model.
    folder: PathBuf,
    /// Index of the current model.
    model: usize,
    /// Canonical paths of all files of the current model.
    included: HashSet<PathBuf>,
    /// Canonical paths of the main files of the models that contain the current one, and of itself.
    open: Vec<PathBuf>,
}

impl FileReader<'_> {
    /// Parses file number `file` and appends its elements below `parent`, which is at nesting depth `depth`. The root element is
    /// appended only for the main file.
    fn append_file(&mut self, file: usize, parent: Option<ElementId>, depth: usize) {
        let text = self.files.tree.files[file].text.clone();
        let Some(document) = xml::parse(&text, &mut self.files.reports[file]) else { return };
        let root = document.root_element();
        match parent {
            None => self.append_element(root, file, None, depth),
            Some(_) => {
                let children: Vec<_> = root.children().filter(Node::is_element).collect();
                children.into_iter().for_each(|child| self.append_element(child, file, parent, depth));
            }
        }
    }

    /// Appends an element and its descendants; an `<include>` is replaced by the contents of its file.
    fn append_element(&mut self, node: Node<'_, '_>, file: usize, parent: Option<ElementId>, depth: usize) {
        if self.files.is_full(file, node.range().start, depth) {
            return;
        }
        if node.tag_name().name() == "include" && parent.is_some() {
            self.include(node, file, parent, depth);
            return;
        }
        let id = self.files.tree.append(Element::new(node, file, parent, |_| true));
        for child in node.children().filter(Node::is_element) {
            self.append_element(child, file, Some(id), depth + 1);
        }
    }

    /// Appends the contents of an included file below `parent`.
    fn include(&mut self, node: Node<'_, '_>, file: usize, parent: Option<ElementId>, depth: usize) {
        let place = Place::Element(node);
        let Some(name) = node.attribute("file").filter(|name| !name.trim().is_empty()) else {
            self.files.reports[file].error("missing-attribute", place, || {
                "<include> has no attribute \"file\"; it names an MJCF file".to_owned()
            });
            return;
        };
        let of_including = Path::new(&self.files.tree.files[file].name).parent().map(Path::to_owned);
        let candidates = [Some(self.folder.join(name)), of_including.map(|folder| folder.join(name))];
        let candidates: Vec<PathBuf> = candidates.into_iter().flatten().collect();
        let Some(path) = candidates.iter().find(|path| self.store.is_file(path)) else {
            self.files.reports[file].error("no-such-file", Place::Attribute(node, "file"), || {
                let tried = candidates.first().map_or(Path::new(name), PathBuf::as_path).display();
                format!(
                    "the included file {} does not exist; it is searched in the folder of the main file ({})",
                    quoted(name),
                    shortened(&tried.to_string())
                )
            });
            return;
        };
        let canonical = self.files.canonical(path);
        if !self.included.insert(canonical) {
            self.files.reports[file].error("included-twice", Place::Attribute(node, "file"), || {
                format!(
                    "the file {} is part of the model already; MuJoCo accepts each file once, and a circle of files has no end",
                    quoted(name)
                )
            });
            return;
        }
        if let Some(index) = self.open_file(path, file, Place::Attribute(node, "file")) {
            self.append_file(index, parent, depth);
        }
    }

    /// Reads a file into the list of files; `None`, with an error at `place` in file number `file`, if this is impossible.
    fn open_file(&mut self, path: &Path, file: usize, place: Place<'_, '_>) -> Option<usize> {
        if self.files.tree.files.len() > MAX_INCLUDED_FILES {
            self.files.reports[file]
                .error("too-complex", place, || format!("more than {MAX_INCLUDED_FILES} included files"));
            return None;
        }
        match self.files.open(path, self.model) {
            Ok(index) => Some(index).filter(|index| !self.files.reports[*index].has_errors()),
            Err(reason) => {
                self.files.reports[file].error("unreadable", place, || {
                    format!("the included file {} cannot be read: {reason}", quoted(&path.to_string_lossy()))
                });
                None
            }
        }
    }

    /// Reads the models in the assets of model number `own`, and the models in their assets.
    fn read_models(&mut self, own: usize, depth: usize) {
        let root = self.models[own].root;
        let tree = &self.files.tree;
        let assets: Vec<ElementId> =
            tree.in_sections_of(root, "asset").filter(|id| tree.tag(*id) == "model").collect();
        let folder = self.folder.clone();
        for asset in assets {
            let tree = &self.files.tree;
            let file = tree.element(asset).file;
            let offset = tree.attribute_offset(asset, "file");
            let Some(name) = tree.attribute(asset, "file").map(str::to_owned) else {
                self.files.reports[file].error("missing-attribute", Place::Offset(offset), || {
                    "<model> has no attribute \"file\"; it names an MJCF file".to_owned()
                });
                continue;
            };
            let given = tree.attribute(asset, "name").map(str::to_owned);
            if depth >= MAX_MODEL_DEPTH {
                self.files.reports[file].error("too-complex", Place::Offset(offset), || {
                    format!(
                        "models in the assets of models, nested deeper than {MAX_MODEL_DEPTH} levels; a circle of models has no end"
                    )
                });
                return;
            }
            let path = folder.join(&name);
            if !self.store.is_file(&path) {
                self.files.reports[file].error("no-such-file", Place::Offset(offset), || {
                    format!(
                        "the model {} does not exist; it is searched in the folder of the main file ({})",
                        quoted(&name),
                        shortened(&path.display().to_string())
                    )
                });
                continue;
            }
            let canonical = self.files.canonical(&path);
            if self.open.contains(&canonical) {
                self.files.reports[file].error("attach-circle", Place::Offset(offset), || {
                    format!(
                        "the model {} is an asset of itself: a circle of models has no end",
                        quoted(&name)
                    )
                });
                continue;
            }
            let model = self.models.len();
            self.model = model;
            self.folder = path.parent().map(Path::to_owned).unwrap_or_default();
            self.included = HashSet::from([canonical.clone()]);
            let Some(index) = self.open_file(&path, file, Place::Offset(offset)) else { return };
            let root = ElementId(self.files.tree.elements.len() as u32);
            self.append_file(index, None, 0);
            if self.files.tree.elements.len() <= root.0 as usize {
                return;
            }
            if self.files.tree.tag(root) != "mujoco" {
                let tag = shortened(self.files.tree.tag(root));
                self.files.reports[file].error("wrong-root", Place::Offset(offset), || {
                    format!(
                        "the root element of the model is <{tag}>; MJCF models (<mujoco>) can be attached"
                    )
                });
                return;
            }
            let own_name = self.files.tree.attribute(root, "model").map(str::to_owned);
            let attached = given.or(own_name).unwrap_or_default();
            self.models.push(AttachedModel { root, attachable: Vec::new() });
            self.models[own].attachable.push((attached, model));
            self.open.push(canonical);
            self.read_models(model, depth + 1);
            self.open.pop();
        }
    }
}
