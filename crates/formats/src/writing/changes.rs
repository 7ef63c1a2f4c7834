//! Changes by a conversion: parts of a mechanism that have another form in the written file, or none.

use crate::shape::Shape;
use crate::writing::parts::ModelParts;
use percuss_mechanism::{Bush, Joint, LinkId, Mechanism};
use std::fmt;

/// Effect of a conversion on a part of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// The part has another form in the file.
    Changed,
    /// The file does not have the part.
    Lost,
}

impl Effect {
    /// `changed` or `lost`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Changed => "changed",
            Self::Lost => "lost",
        }
    }
}

/// Part of a mechanism that has another form in a written file, or none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// Effect on the part.
    pub effect: Effect,
    /// The part: `link "arm"`.
    pub element: String,
    /// Form of the part in the file; for a loss, the property that the file lacks.
    pub what: String,
    /// Reason.
    pub reason: String,
}

impl Change {
    /// Part with another form: kind, name, form in the file, reason.
    pub(crate) fn changed(
        kind: &str,
        name: &str,
        what: impl Into<String>,
        reason: impl Into<String>,
    ) -> Self {
        Self::new(Effect::Changed, kind, name, what, reason)
    }

    /// Part without a form: kind, name, lost property, reason.
    pub(crate) fn lost(kind: &str, name: &str, what: impl Into<String>, reason: impl Into<String>) -> Self {
        Self::new(Effect::Lost, kind, name, what, reason)
    }

    fn new(
        effect: Effect,
        kind: &str,
        name: &str,
        what: impl Into<String>,
        reason: impl Into<String>,
    ) -> Self {
        Self { effect, element: format!("{kind} \"{name}\""), what: what.into(), reason: reason.into() }
    }
}

/// `link "arm": changed: what (reason)`.
impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: {} ({})", self.element, self.effect.name(), self.what, self.reason)
    }
}

/// Model as the text of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModelText {
    /// The file.
    pub text: String,
    /// Parts of the mechanism that have another form in the file, or none.
    pub changes: Vec<Change>,
}

/// Lost recommendations of driving joints, for which no format of a simulator has an attribute.
pub(crate) fn lost_roles(mechanism: &Mechanism, format: &str) -> Vec<Change> {
    let with_role = mechanism.joints().iter().filter(|joint| joint.independent().is_some());
    let loss = |joint: &Joint| {
        Change::lost(
            "joint",
            joint.name(),
            "recommendation as a driving joint",
            format!("{format} has no such attribute"),
        )
    };
    with_role.map(loss).collect()
}

/// Loss of a named pose, with its reason.
pub fn lost_pose(name: &str, reason: impl Into<String>) -> Change {
    Change::lost("pose", name, "the named pose", reason)
}

/// Losses of all named poses, for a format without named poses.
pub(crate) fn lost_poses<'a>(
    parts: &'a ModelParts<'_>,
    format: &'a str,
) -> impl Iterator<Item = Change> + 'a {
    parts.poses.iter().map(move |(name, _)| lost_pose(name, format!("{format} has no named poses")))
}

/// Loss of a shape of a link, with its reason.
pub(crate) fn lost_shape(mechanism: &Mechanism, link: LinkId, shape: &Shape, reason: String) -> Change {
    let what = format!("a shape ({})", shape.purpose.name());
    Change::lost("link", mechanism.link(link).name(), what, reason)
}

/// Changes that every format has: names with characters that XML forbids, bushes for which `is_written` is false, and elastic gears unless the format
/// has them.
pub(crate) fn common_changes(
    mechanism: &Mechanism,
    is_written: impl Fn(&Bush) -> bool,
    has_gears: bool,
) -> Vec<Change> {
    let links = mechanism.links().iter().map(|link| ("link", link.name()));
    let joints = mechanism.joints().iter().map(|joint| ("joint", joint.name()));
    let closures = mechanism.closures().iter().map(|closure| ("loop", closure.name()));
    let couplings = mechanism.couplings().iter().map(|coupling| ("coupling", coupling.name()));
    let contacts = mechanism.contacts().iter().map(|contact| ("contact", contact.name()));
    let names = links.chain(joints).chain(closures).chain(couplings).chain(contacts);
    let is_changed = |(_, name): &(&str, &str)| name.chars().any(crate::writing::xml_text::is_forbidden);
    let change = |(kind, name)| {
        Change::changed(kind, name, "characters of its name become U+FFFD", "XML forbids control characters")
    };
    let lost = |bush: &Bush| {
        let reason = "the file has the ideal joint in its place";
        Change::lost("bush", bush.name(), "stiffness and damping", reason)
    };
    let bushes = mechanism.bushes().iter().filter(|bush| !is_written(bush));
    let gears = mechanism.joints().iter().filter(|joint| !has_gears && joint.gear().is_some());
    let lost_gear = |joint: &Joint| {
        Change::lost(
            "joint",
            joint.name(),
            "elasticity of its gear",
            "the file has a rigid gear in its place",
        )
    };
    names.filter(is_changed).map(change).chain(bushes.map(lost)).chain(gears.map(lost_gear)).collect()
}
