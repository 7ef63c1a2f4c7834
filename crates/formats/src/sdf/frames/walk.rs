//! Collection of scopes, links, joints and frames.

use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::limits::{LONGEST_NAME, MAX_ELEMENTS_PER_KIND, MAX_MODEL_DEPTH, MAX_PLUGIN_NAMES};
use crate::reading::plugins::{joins_links, keyed_value};
use crate::reading::report::quoted;
use crate::sdf::document::check::check_children;
use crate::sdf::document::grammar::{IN_MODEL, IN_WORLD};
use crate::sdf::document::version::Version;
use crate::sdf::frames::scopes::{Frame, FrameId, FrameKind, Scope, ScopeId, Scopes, SdfPart};
use crate::sdf::values::{read_boolean_attribute, read_boolean_in, text_in};
use percuss_mechanism::Severity;
use percuss_spatial::Transform;
use std::collections::HashMap;
use std::ops::Range;

/// Name of a model, of an `<include>` where given there.
pub(crate) fn model_name(tree: &ElementTree, element: ElementId) -> &str {
    let given = text_in(tree, element, "name");
    let is_include = tree.tag(element) == "include";
    match given {
        name if is_include && !name.is_empty() => name,
        _ => {
            included_model(tree, element).and_then(|model| tree.attribute(model, "name")).unwrap_or_default()
        }
    }
}

/// `<model>` of an element: itself, or the model of the file that an `<include>` names. `None` for an included light or actor.
pub(crate) fn included_model(tree: &ElementTree, element: ElementId) -> Option<ElementId> {
    match tree.tag(element) {
        "model" => Some(element),
        _ => tree.child(tree.child(element, "sdf")?, "model"),
    }
}

/// Reads all scopes of a `<world>` or of an `<sdf>`. `main`: `<model>` or `<include>` whose elements have names without a prefix.
pub(crate) fn collect_scopes(container: ElementId, main: ElementId, findings: &mut Findings<'_>) -> Scopes {
    let mut walker = Walker { findings, scopes: Scopes::default() };
    let world = ScopeId(0);
    let frame = walker.push_frame(container, world, FrameKind::World, String::new());
    walker.scopes.scopes.push(Scope {
        parent: None,
        element: container,
        include: None,
        frame,
        names: HashMap::from([("world".to_owned(), frame)]),
        separators: 0,
        first_link: None,
        prefix: String::new(),
        is_static: true,
        version: Version::of_element(walker.findings.tree, container),
        top: world,
        depth: 0,
    });
    check_children(container, IN_WORLD, walker.findings);
    walker.read_contents(container, world, Some(main));
    let scopes = 0..walker.scopes.scopes.len();
    walker.warn_plugins(container, scopes);
    walker.scopes
}

struct Walker<'f, 'w> {
    findings: &'w mut Findings<'f>,
    scopes: Scopes,
}

impl Walker<'_, '_> {
    /// Adds a frame; its base and pose are set later.
    fn push_frame(&mut self, element: ElementId, scope: ScopeId, kind: FrameKind, name: String) -> FrameId {
        let (pose, world_pose) = (Transform::identity(), Transform::identity());
        self.scopes.frames.push(Frame { element, scope, kind, name, base: None, depth: 0, pose, world_pose });
        FrameId(self.scopes.frames.len() - 1)
    }

    /// Reads the contents of a world or model. The recursion is bounded by the depth of the models.
    fn read_contents(&mut self, element: ElementId, scope: ScopeId, main: Option<ElementId>) {
        let tree = self.findings.tree;
        // Joints come last: in older files a joint may have the name of a link, which then counts.
        for &child in tree.children(element) {
            match tree.tag(child) {
                "link" => self.read_link(child, scope),
                "frame" if scope.0 > 0 || self.scopes.scope(scope).version >= Version::WITH_FRAMES => {
                    self.read_named(child, scope, FrameKind::Frame);
                }
                "model" => self.read_model(child, None, scope, main),
                "include" => {
                    if let Some(model) = included_model(tree, child) {
                        self.read_model(model, Some(child), scope, main);
                    }
                }
                _ => {}
            }
        }
        for joint in tree.children_named(element, "joint") {
            let index = self.scopes.joints.len();
            if index >= MAX_ELEMENTS_PER_KIND {
                self.refuse_count(joint, "joints");
                return;
            }
            let frame = self.read_named(joint, scope, FrameKind::Joint(index));
            self.scopes.joints.push(SdfPart { element: joint, frame, scope });
        }
    }

    /// Reports that a file has too many elements of a kind.
    fn refuse_count(&mut self, element: ElementId, kind: &'static str) {
        self.findings.add_once(Severity::Error, "too-complex", kind, element, || {
            format!("more than {MAX_ELEMENTS_PER_KIND} {kind}, those of included models counted")
        });
    }

    fn read_link(&mut self, element: ElementId, scope: ScopeId) {
        let index = self.scopes.links.len();
        if index >= MAX_ELEMENTS_PER_KIND {
            self.refuse_count(element, "links");
            return;
        }
        let frame = self.read_named(element, scope, FrameKind::Link(index));
        self.scopes.scopes[scope.0].first_link.get_or_insert(frame);
        self.scopes.links.push(SdfPart { element, frame, scope });
    }

    /// Adds a frame under the name of its element.
    fn read_named(&mut self, element: ElementId, scope: ScopeId, kind: FrameKind) -> FrameId {
        let name = self.findings.tree.attribute(element, "name").unwrap_or_default();
        self.add_named(element, name, scope, kind)
    }

    /// Adds a frame and its name; empty, long, reserved and repeated names are errors.
    fn add_named(&mut self, element: ElementId, name: &str, scope: ScopeId, kind: FrameKind) -> FrameId {
        let tag = self.findings.tree.tag(element);
        let own = self.scopes.scope(scope);
        let full = format!("{}{name}", own.prefix);
        if name.is_empty() {
            self.findings.error("missing-attribute", element, || format!("<{tag}> has no name"));
        } else if full.len() > LONGEST_NAME {
            let length = full.len();
            self.findings.error("long-name", element, || {
                format!("the name is {length} bytes long, with the names of its models; at most {LONGEST_NAME} are read")
            });
        } else if name == "world" && kind != FrameKind::World || name == "__model__" {
            self.findings.error("reserved-name", element, || {
                format!("the name {} is reserved in SDFormat; rename the element", quoted(name))
            });
        }
        let earlier = own.names.get(name).map(|earlier| self.scopes.frame(*earlier).element);
        let frame = self.push_frame(element, scope, kind, full);
        match earlier {
            Some(earlier) if !name.is_empty() => {
                let is_same_kind = self.findings.tree.tag(earlier) == tag;
                let severity = if is_same_kind { Severity::Error } else { Severity::Note };
                let first = self.findings.tree.tag(earlier);
                self.findings.add(severity, "duplicate-name", element, || {
                    format!(
                        "the name {} was given before, to a <{first}>; names must be unique in a model",
                        quoted(name)
                    )
                });
            }
            _ => {
                let own = &mut self.scopes.scopes[scope.0];
                own.names.insert(name.to_owned(), frame);
                if let FrameKind::Model(_) = kind {
                    own.separators = own.separators.max(name.matches("::").count());
                }
            }
        }
        frame
    }

    /// Reads a model, which an `<include>` may change.
    fn read_model(
        &mut self,
        model: ElementId,
        include: Option<ElementId>,
        scope: ScopeId,
        main: Option<ElementId>,
    ) {
        let tree = self.findings.tree;
        let source = include.unwrap_or(model);
        let depth = self.scopes.scope(scope).depth + 1;
        if depth > MAX_MODEL_DEPTH {
            self.findings.error("too-complex", source, || {
                format!("models are nested more than {MAX_MODEL_DEPTH} levels deep")
            });
            return;
        }
        let name = model_name(tree, source);
        let id = ScopeId(self.scopes.scopes.len());
        let is_merged =
            include.is_some_and(|include| read_boolean_attribute(include, "merge", self.findings));
        if is_merged && scope.0 == 0 && tree.children_named(model, "link").next().is_some() {
            self.findings.error("merged-links", source, || {
                "a model with links of its own is merged into a world, which has models and joints, but \
                 no links; remove merge=\"true\""
                    .to_owned()
            });
        }
        // The frame of a merged model has a name that no file can refer to.
        let frame_name = if is_merged { format!("_merged__{name}__model__") } else { name.to_owned() };
        let frame = self.add_named(source, &frame_name, scope, FrameKind::Model(id));
        if !is_merged {
            self.scopes.scopes[scope.0].first_link.get_or_insert(frame);
        }
        let prefix = match main {
            Some(main) if main == source => String::new(),
            _ if is_merged => self.scopes.scope(scope).prefix.clone(),
            _ => format!("{}{name}::", self.scopes.scope(scope).prefix),
        };
        let with_static = include.filter(|include| tree.child(*include, "static").is_some()).unwrap_or(model);
        let is_static = read_boolean_in(with_static, "static", self.findings);
        // All models are placed in the world, which is static itself.
        let is_static = is_static || scope.0 > 0 && self.scopes.scope(scope).is_static;
        let top = if scope.0 == 0 { id } else { self.scopes.scope(scope).top };
        self.scopes.scopes.push(Scope {
            parent: Some(scope),
            element: model,
            include,
            frame,
            names: HashMap::new(),
            separators: 0,
            first_link: None,
            prefix,
            is_static,
            version: Version::of_element(tree, model),
            top,
            depth,
        });
        check_children(model, IN_MODEL, self.findings);
        self.read_contents(model, id, None);
        for holder in [Some(model), include].into_iter().flatten() {
            self.warn_plugins(holder, id.0..id.0 + 1);
        }
        if is_merged {
            self.merge_names(id, scope);
        }
    }

    /// Adds the names of a merged model to the model that includes it.
    fn merge_names(&mut self, merged: ScopeId, into: ScopeId) {
        let mut names: Vec<(String, FrameId)> =
            self.scopes.scope(merged).names.iter().map(|(name, frame)| (name.clone(), *frame)).collect();
        names.sort_by_key(|(_, frame)| frame.0);
        if let Some(first) = self.scopes.scope(merged).first_link {
            self.scopes.scopes[into.0].first_link.get_or_insert(first);
        }
        let separators = self.scopes.scope(merged).separators;
        self.scopes.scopes[into.0].separators = separators.max(self.scopes.scope(into).separators);
        for (name, frame) in names {
            let earlier = self.scopes.scopes[into.0].names.insert(name.clone(), frame);
            if earlier.is_some() {
                let element = self.scopes.frame(frame).element;
                self.findings.error("duplicate-name", element, || {
                    format!(
                        "the merged model gives the name {} a second time; names must be unique",
                        quoted(&name)
                    )
                });
            }
        }
    }

    /// Warns about plugins of a model or world, and of its links and joints, that join or couple links. `scopes`: scopes of their names.
    fn warn_plugins(&mut self, holder: ElementId, scopes: Range<usize>) {
        let tree = self.findings.tree;
        let parts = tree.children(holder).iter().filter(|part| ["link", "joint"].contains(&tree.tag(**part)));
        for plugin in parts.chain([&holder]).flat_map(|holder| tree.children_named(*holder, "plugin")) {
            let name = ["name", "filename"].map(|name| tree.attribute(plugin, name).unwrap_or_default());
            let of_scopes =
                &self.scopes.scopes[scopes.start..scopes.end.min(scopes.start + MAX_PLUGIN_NAMES)];
            let is_known = |name: &str| {
                let frames = || of_scopes.iter().filter_map(|scope| scope.names.get(name));
                let kinds = || frames().map(|frame| self.scopes.frame(*frame).kind);
                [
                    kinds().any(|kind| matches!(kind, FrameKind::Link(_))),
                    kinds().any(|kind| matches!(kind, FrameKind::Joint(_))),
                ]
            };
            if joins_links(&name.join(" "), &plugin_values(tree, plugin), is_known) {
                let shown = name.into_iter().find(|name| !name.is_empty()).unwrap_or_default();
                self.findings.add_once(Severity::Warning, "plugin", shown, plugin, || {
                    format!(
                        "plugins are not read, and {} joins links or couples joints, by its name or its \
                         elements: the loop or coupling \
                         is missing here. Write a <joint> or a <mimic> for it",
                        quoted(shown)
                    )
                });
            }
        }
    }
}

/// Names and texts of the elements and attributes below a plugin.
fn plugin_values(tree: &ElementTree, plugin: ElementId) -> Vec<(&str, &str)> {
    let mut values = Vec::new();
    let mut open = tree.children(plugin).to_vec();
    while let Some(id) = open.pop() {
        values.push((tree.tag(id), tree.text(id)));
        values.extend(keyed_value(tree.tag(id), |name| tree.attribute(id, name), tree.text(id)));
        values.extend(tree.element(id).attributes.iter().map(|a| (a.name.as_str(), a.value.as_str())));
        open.extend(tree.children(id));
    }
    values
}
