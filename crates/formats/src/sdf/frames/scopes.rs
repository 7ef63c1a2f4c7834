//! Scopes of names: the world, and models within models.

use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::limits::LONGEST_NAME;
use crate::sdf::document::version::Version;
use percuss_spatial::Transform;
use std::collections::HashMap;

/// Index of a frame in [`Scopes::frames`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct FrameId(pub usize);

/// Index of a scope in [`Scopes::scopes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ScopeId(pub usize);

/// Object to which a frame belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FrameKind {
    World,
    /// Model frame of a scope.
    Model(ScopeId),
    /// Index in [`Scopes::links`].
    Link(usize),
    /// Index in [`Scopes::joints`].
    Joint(usize),
    Frame,
}

/// Frame with its pose as drawn.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    pub element: ElementId,
    /// Scope that contains the name of the frame.
    pub scope: ScopeId,
    pub kind: FrameKind,
    /// Name with the names of the enclosing models.
    pub name: String,
    /// Frame in which the frame is placed; `None` for the world.
    pub base: Option<FrameId>,
    /// Number of frames from the base to the world.
    pub depth: usize,
    /// Pose in the base.
    pub pose: Transform<f64>,
    pub world_pose: Transform<f64>,
}

/// Scope of names: the world, or a model.
#[derive(Clone, Debug)]
pub(crate) struct Scope {
    pub parent: Option<ScopeId>,
    /// `<world>`, `<sdf>` or `<model>`.
    pub element: ElementId,
    /// `<include>` by which the model is read.
    pub include: Option<ElementId>,
    pub frame: FrameId,
    pub names: HashMap<String, FrameId>,
    /// Largest number of separators `::` in the name of a nested model: 0 in files of current versions.
    pub separators: usize,
    /// First link or nested model of the model.
    pub first_link: Option<FrameId>,
    /// Text before the names of the model's elements: names of the enclosing models.
    pub prefix: String,
    pub is_static: bool,
    pub version: Version,
    /// Model directly in the world that contains the scope; itself for such a model.
    pub top: ScopeId,
    pub depth: usize,
}

/// Link of a model, or joint of a model or of the world.
#[derive(Clone, Debug)]
pub(crate) struct SdfPart {
    pub element: ElementId,
    pub frame: FrameId,
    pub scope: ScopeId,
}

/// Body to which a frame is attached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Attached {
    Ground,
    /// Index in [`Scopes::links`].
    Link(usize),
}

/// Next frame, or the body, to which a frame is attached.
enum Attachment {
    Body(Attached),
    Frame(FrameId),
}

/// All scopes of a world or file, the world first.
#[derive(Debug, Default)]
pub(crate) struct Scopes {
    pub scopes: Vec<Scope>,
    pub frames: Vec<Frame>,
    pub links: Vec<SdfPart>,
    pub joints: Vec<SdfPart>,
    /// Body of each frame; empty before [`resolve_attachments`](Self::resolve_attachments).
    attachments: Vec<Option<Attached>>,
}

impl Scopes {
    /// The scope with this index.
    pub fn scope(&self, id: ScopeId) -> &Scope {
        &self.scopes[id.0]
    }

    /// The frame with this index.
    pub fn frame(&self, id: FrameId) -> &Frame {
        &self.frames[id.0]
    }

    /// Full name of a link.
    pub fn link_name(&self, link: usize) -> &str {
        &self.frame(self.links[link].frame).name
    }

    /// Frame with a name in a scope; `a::b` is frame b of the nested model a. A name of a frame contains the names of its models, so
    /// that no frame has a longer name than `LONGEST_NAME`, after the name of the main model.
    pub fn find(&self, scope: ScopeId, name: &str) -> Option<FrameId> {
        if name.len() > 2 * LONGEST_NAME {
            return None;
        }
        let (mut scope, mut name) = (scope, name);
        loop {
            let own = self.scope(scope);
            if name == "__model__" && own.parent.is_some() {
                return Some(own.frame);
            }
            if let Some(found) = own.names.get(name) {
                return Some(*found);
            }
            // Names of models may contain the separator: the shortest one that exists counts.
            let model = name.match_indices("::").take(own.separators + 1).find_map(|(at, _)| {
                let frame = own.names.get(&name[..at])?;
                match self.frame(*frame).kind {
                    FrameKind::Model(nested) => Some((nested, at + 2)),
                    _ => None,
                }
            });
            let (nested, rest) = model?;
            (scope, name) = (nested, &name[rest..]);
        }
    }

    /// Body to which a frame is attached; `None` if a name is unknown, a model has no link, or the attachments are a circle.
    pub fn attached(&self, frame: FrameId) -> Option<Attached> {
        self.attachments.get(frame.0).copied().flatten()
    }

    /// Finds the bodies to which the frames are attached; each frame once.
    pub fn resolve_attachments(&mut self, tree: &ElementTree) {
        let mut is_known = vec![false; self.frames.len()];
        self.attachments = vec![None; self.frames.len()];
        for start in 0..self.frames.len() {
            let mut path = Vec::new();
            let mut current = FrameId(start);
            let body = loop {
                if is_known[current.0] {
                    break self.attachments[current.0];
                }
                // A frame of the path is known from now on: its value is `None` if the attachments return to it.
                is_known[current.0] = true;
                path.push(current);
                match self.attachment(tree, current) {
                    Some(Attachment::Body(body)) => break Some(body),
                    Some(Attachment::Frame(next)) => current = next,
                    None => break None,
                }
            };
            path.into_iter().for_each(|frame| self.attachments[frame.0] = body);
        }
    }

    /// Frame or body to which a frame is attached directly.
    fn attachment(&self, tree: &ElementTree, id: FrameId) -> Option<Attachment> {
        let frame = self.frame(id);
        Some(match frame.kind {
            FrameKind::World => Attachment::Body(Attached::Ground),
            FrameKind::Link(link) => Attachment::Body(Attached::Link(link)),
            FrameKind::Model(scope) => Attachment::Frame(self.canonical_frame(tree, scope)?),
            FrameKind::Joint(_) => {
                let child = tree.child(frame.element, "child")?;
                Attachment::Frame(self.find(frame.scope, tree.text(child))?)
            }
            FrameKind::Frame => match tree.attribute(frame.element, "attached_to") {
                Some(name) if !name.is_empty() => Attachment::Frame(self.find(frame.scope, name)?),
                _ => Attachment::Frame(self.scope(frame.scope).frame),
            },
        })
    }

    /// Canonical link of a model, or a frame that leads to it.
    fn canonical_frame(&self, tree: &ElementTree, scope: ScopeId) -> Option<FrameId> {
        let own = self.scope(scope);
        match tree.attribute(own.element, "canonical_link") {
            Some(name) if !name.is_empty() => self.find(scope, name),
            _ => own.first_link,
        }
    }
}
