//! Tendons: linear combinations of joint positions, and lines through sites.

use crate::mjcf::bodies::body::{Bodies, Site};
use crate::mjcf::relations::references::JointKey;
use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::classes::DefaultKind;
use crate::mjcf::values::models::Models;
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::Findings;
use crate::reading::report::quoted;
use std::collections::{HashMap, HashSet};

/// Path of a tendon.
#[derive(Clone, Debug)]
pub(crate) enum TendonPath {
    /// Length Σ coefficient · q of hinges and slides.
    Fixed(Vec<(JointKey, f64)>),
    /// Straight line between two sites.
    Line([Site; 2]),
    /// Line through more sites, around geoms or over pulleys.
    Wrapped,
    /// Tendon of a `<replicate>`, of which MuJoCo makes copies.
    Replicated,
}

/// Tendon.
#[derive(Clone, Debug)]
pub(crate) struct Tendon {
    pub element: ElementId,
    /// Empty if absent.
    pub name: String,
    pub path: TendonPath,
    /// Armature per rate of the length, kg or kg·m².
    pub armature: f64,
}

/// Reads all tendons, by name. Unnamed tendons are kept for their armature, with a key that no reference has.
pub(crate) fn read_tendons(
    models: &Models<'_>,
    bodies: &Bodies,
    findings: &mut Findings<'_>,
) -> HashMap<String, Tendon> {
    let tree = findings.tree;
    let mut tendons = HashMap::new();
    let related: HashSet<&str> = ["equality", "actuator"]
        .into_iter()
        .flat_map(|section| tree.in_sections(section))
        .flat_map(|id| {
            ["tendon", "tendon1", "tendon2"].into_iter().filter_map(move |name| tree.attribute(id, name))
        })
        .collect();
    for (number, element) in tree.in_sections("tendon").enumerate() {
        let attributes = models.attributes(element, DefaultKind::Tendon, None, findings);
        let is_replicated = tree.children(element).iter().any(|child| {
            ["joint", "site"]
                .into_iter()
                .filter_map(|name| tree.attribute(*child, name))
                .any(|name| bodies.is_replicated(name))
        });
        let path = match tree.tag(element) {
            // Without a constraint and an armature the tendon has no effect.
            _ if is_replicated => TendonPath::Replicated,
            "fixed" => fixed_path(element, bodies, findings),
            "spatial" => spatial_path(element, bodies, findings),
            // The grammar reports other elements.
            _ => continue,
        };
        let armature = attributes.number("armature", findings).unwrap_or(0.0);
        let name = tree.attribute(element, "name").unwrap_or_default().to_owned();
        if armature == 0.0 && !related.contains(name.as_str()) {
            findings.add_unread(element, || format!("tendon <{}> without a constraint", tree.tag(element)));
        }
        let key = if name.is_empty() { format!("\u{0}{number}") } else { name.clone() };
        if tendons.insert(key, Tendon { element, name, path, armature }).is_some() {
            findings.error("duplicate-name", element, || {
                "the name of the tendon was given before; names must be unique".to_owned()
            });
        }
    }
    tendons
}

/// Path of a `<fixed>` tendon, whose length is Σ coefficient · joint position.
fn fixed_path(element: ElementId, bodies: &Bodies, findings: &mut Findings<'_>) -> TendonPath {
    let mut terms: Vec<(JointKey, f64)> = Vec::new();
    for child in findings.tree.children_named(element, "joint") {
        let attributes = Attributes::new(findings.tree, child);
        let Some(coefficient) = attributes.number("coef", findings) else {
            if attributes.text("coef").is_none() {
                findings.error("missing-attribute", child, || {
                    "the <joint> of a fixed tendon has no attribute \"coef\"".to_owned()
                });
            }
            continue;
        };
        let name = attributes.text("joint").unwrap_or_default();
        if let Some(joint) = bodies.scalar_joint_named(name, (child, "joint"), findings) {
            if terms.iter().any(|(other, _)| *other == joint) {
                findings.attribute_error("duplicate-name", child, "joint", || {
                    format!("the joint {} occurs twice in the tendon; add its coefficients", quoted(name))
                });
            }
            terms.push((joint, coefficient));
        }
    }
    TendonPath::Fixed(terms)
}

/// Path of a `<spatial>` tendon: a straight line if it has only two sites, otherwise `Wrapped`.
fn spatial_path(element: ElementId, bodies: &Bodies, findings: &mut Findings<'_>) -> TendonPath {
    let tree = findings.tree;
    let children = tree.children(element);
    let (&[first, second], true) = (children, children.iter().all(|child| tree.tag(*child) == "site")) else {
        return TendonPath::Wrapped;
    };
    let mut site = |child| {
        let name = tree.attribute(child, "site").unwrap_or_default();
        bodies.site_named(name, (child, "site"), findings).cloned()
    };
    match (site(first), site(second)) {
        (Some(first), Some(second)) => TendonPath::Line([first, second]),
        _ => TendonPath::Wrapped,
    }
}
