//! Poses of all frames as drawn.
//!
//! Every frame has a base and a pose in the base. Default bases: the model frame; of a joint its child; of a model the enclosing model
//! or the world. Source: SDFormat, "Pose frame semantics", and its converters of versions 1.4 and 1.6.

use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::{Findings, similar_name};
use crate::reading::limits::MAX_FRAME_CHAIN;
use crate::reading::report::quoted;
use crate::sdf::document::version::Version;
use crate::sdf::frames::scopes::{FrameId, FrameKind, ScopeId, Scopes};
use crate::sdf::values::{read_pose, text_in};
use percuss_mechanism::Severity;
use percuss_spatial::Transform;

/// Computes the bases and poses of all frames. Unknown names and circles are errors.
pub(crate) fn resolve_poses(scopes: &mut Scopes, findings: &mut Findings<'_>) {
    for index in 0..scopes.frames.len() {
        let (base, pose) = read_frame(scopes, FrameId(index), findings);
        scopes.frames[index].base = base;
        scopes.frames[index].pose = pose;
    }
    if refuse_circles(scopes, findings) {
        return;
    }
    for_each_from_the_root(scopes, |scopes, frame, base| {
        scopes.frames[frame.0].depth = base.map_or(0, |base| scopes.frame(base).depth + 1);
    });
    // Nested models have higher indices than the models that contain them.
    for index in (1..scopes.scopes.len()).rev() {
        place_model(scopes, ScopeId(index), findings);
    }
    for_each_from_the_root(scopes, |scopes, frame, base| {
        let x_wb = base.map_or_else(Transform::identity, |base| scopes.frame(base).world_pose);
        scopes.frames[frame.0].world_pose = x_wb * scopes.frame(frame).pose;
    });
}

/// Base and pose of a frame. A model is placed later by its placement frame.
fn read_frame(
    scopes: &Scopes,
    id: FrameId,
    findings: &mut Findings<'_>,
) -> (Option<FrameId>, Transform<f64>) {
    let tree = findings.tree;
    let frame = scopes.frame(id);
    let model_frame = scopes.scope(frame.scope).frame;
    let (holder, default) = match frame.kind {
        FrameKind::World => return (None, Transform::identity()),
        // The pose of an <include> replaces that of its model.
        FrameKind::Model(scope) => {
            let scope = scopes.scope(scope);
            let own = scope.include.filter(|include| tree.child(*include, "pose").is_some());
            (own.unwrap_or(scope.element), model_frame)
        }
        FrameKind::Link(_) => (frame.element, model_frame),
        FrameKind::Frame => {
            let attached = tree.attribute(frame.element, "attached_to").filter(|name| !name.is_empty());
            let attached = attached.and_then(|name| find_frame(scopes, id, frame.element, name, findings));
            (frame.element, attached.unwrap_or(model_frame))
        }
        FrameKind::Joint(_) => {
            let child = scopes.find(frame.scope, text_in(tree, frame.element, "child"));
            (frame.element, child.unwrap_or(model_frame))
        }
    };
    let Some(pose) = tree.child(holder, "pose") else { return (Some(default), Transform::identity()) };
    let [relative_to, frame] =
        ["relative_to", "frame"].map(|name| tree.attribute(pose, name).filter(|name| !name.is_empty()));
    let named = if Version::of_element(tree, pose) < Version::WITH_FRAMES {
        frame.or(relative_to)
    } else {
        if frame.is_some() {
            findings.add_once(Severity::Warning, "ignored", "frame of pose", pose, || {
                "the attribute \"frame\" ended with version 1.6 and is ignored; write relative_to".to_owned()
            });
        }
        relative_to
    };
    let base = named.and_then(|name| find_frame(scopes, id, pose, name, findings));
    (Some(base.unwrap_or(default)), read_pose(pose, findings))
}

/// Frame that an element names; an unknown name is an error.
fn find_frame(
    scopes: &Scopes,
    of: FrameId,
    element: ElementId,
    name: &str,
    findings: &mut Findings<'_>,
) -> Option<FrameId> {
    let scope = scopes.frame(of).scope;
    let found = scopes.find(scope, name);
    if found.is_none() {
        report_unknown_frame(scopes, scope, element, name, findings);
    }
    found
}

/// Reports a name that is no frame of a scope.
pub(crate) fn report_unknown_frame(
    scopes: &Scopes,
    scope: ScopeId,
    element: ElementId,
    name: &str,
    findings: &mut Findings<'_>,
) {
    findings.error("unknown-frame", element, || {
        let guess = similar_name(name, scopes.scope(scope).names.keys().map(String::as_str));
        format!(
            "the frame {} is not known{guess}; expected the name of a link, joint, frame or nested model of the same model, or __model__",
            quoted(name)
        )
    });
}

/// Reports circles of frames, each placed in the next. Returns true if one exists.
fn refuse_circles(scopes: &Scopes, findings: &mut Findings<'_>) -> bool {
    #[derive(Clone, Copy, PartialEq)]
    enum Mark {
        New,
        OnPath,
        Done,
    }
    let mut marks = vec![Mark::New; scopes.frames.len()];
    let mut found = false;
    for start in 0..scopes.frames.len() {
        let mut path = Vec::new();
        let mut current = Some(FrameId(start));
        while let Some(frame) = current.filter(|frame| marks[frame.0] == Mark::New) {
            marks[frame.0] = Mark::OnPath;
            path.push(frame);
            current = scopes.frame(frame).base;
        }
        if let Some(frame) = current.filter(|frame| marks[frame.0] == Mark::OnPath) {
            found = true;
            let circle = path.iter().skip_while(|on_path| **on_path != frame).take(5);
            let names: Vec<String> = circle.map(|frame| quoted(&scopes.frame(*frame).name)).collect();
            findings.error("frame-circle", scopes.frame(frame).element, || {
                format!("the poses of {} are relative to each other in a circle", names.join(", "))
            });
        }
        path.into_iter().for_each(|frame| marks[frame.0] = Mark::Done);
    }
    found
}

/// Moves a model so that its frame named by `placement_frame` has the stated pose of the model.
fn place_model(scopes: &mut Scopes, id: ScopeId, findings: &mut Findings<'_>) {
    let tree = findings.tree;
    let scope = scopes.scope(id);
    let of_include = scope.include.and_then(|include| tree.child(include, "placement_frame"));
    let name = match of_include {
        Some(element) => tree.text(element),
        None => tree.attribute(scope.element, "placement_frame").unwrap_or_default(),
    };
    if name.is_empty() {
        return;
    }
    let (model_frame, element) = (scope.frame, of_include.unwrap_or(scope.element));
    match scopes.find(id, name) {
        Some(placement) => {
            if let Some(in_model) = scopes.pose_between(model_frame, placement, usize::MAX) {
                let frame = &mut scopes.frames[model_frame.0];
                frame.pose = frame.pose * in_model.inverse();
            }
        }
        None => report_unknown_frame(scopes, id, element, name, findings),
    }
}

/// Calls a function for each frame and its base, once each, the base first.
fn for_each_from_the_root(scopes: &mut Scopes, mut act: impl FnMut(&mut Scopes, FrameId, Option<FrameId>)) {
    let mut is_done = vec![false; scopes.frames.len()];
    for start in 0..scopes.frames.len() {
        let mut path = Vec::new();
        let mut current = Some(FrameId(start));
        while let Some(frame) = current.filter(|frame| !is_done[frame.0]) {
            path.push(frame);
            current = scopes.frame(frame).base;
        }
        for frame in path.into_iter().rev() {
            act(scopes, frame, scopes.frame(frame).base);
            is_done[frame.0] = true;
        }
    }
}

impl Scopes {
    /// X_ab, frame b in frame a, as drawn. The poses between the frames are multiplied directly, so that a pose that is written in the
    /// file is reproduced exactly.
    pub fn relative_pose(&self, a: FrameId, b: FrameId) -> Transform<f64> {
        self.pose_between(a, b, MAX_FRAME_CHAIN)
            .unwrap_or_else(|| self.frame(a).world_pose.inverse() * self.frame(b).world_pose)
    }

    /// X_ab by the chains of bases from both frames to their first common one; `None` if a chain is longer than `longest`.
    fn pose_between(&self, mut a: FrameId, mut b: FrameId, longest: usize) -> Option<Transform<f64>> {
        let (mut x_ca, mut x_cb) = (Transform::identity(), Transform::identity());
        let mut steps = [0, 0];
        while a != b {
            let [of_a, of_b] = [self.frame(a), self.frame(b)];
            if of_a.depth >= of_b.depth {
                x_ca = of_a.pose * x_ca;
                (a, steps[0]) = (of_a.base?, steps[0] + 1);
            }
            if of_b.depth >= of_a.depth {
                x_cb = of_b.pose * x_cb;
                (b, steps[1]) = (of_b.base?, steps[1] + 1);
            }
            if steps.iter().any(|count| *count > longest) {
                return None;
            }
        }
        Some(x_ca.inverse() * x_cb)
    }
}
