//! Links: inertia and shapes.

use crate::reading::findings::Findings;
use crate::sdf::elements::geometry::{Collision, read_shape};
use crate::sdf::elements::inertia::{LinkInertia, read_inertia};
use crate::sdf::frames::scopes::Scopes;
use crate::sdf::values::read_pose;
use crate::shape::{Purpose, Shape};
use percuss_mechanism::{Geometry, Severity};
use percuss_spatial::Transform;

/// Values of a link.
#[derive(Clone, Debug)]
pub(crate) struct LinkBody {
    pub inertia: LinkInertia,
    pub shapes: Vec<Shape>,
    pub extent: Geometry,
}

/// Reads the inertia and the shapes of a link. `is_fixed`: the link cannot move.
pub(crate) fn read_body(
    scopes: &Scopes,
    link: usize,
    is_fixed: bool,
    findings: &mut Findings<'_>,
) -> LinkBody {
    let element = scopes.links[link].element;
    let collisions = read_shapes(scopes, link, "collision", findings);
    let visuals = read_shapes(scopes, link, "visual", findings);
    let inertia = read_inertia(element, &collisions, is_fixed, findings);
    let mut extent = Geometry::None;
    for part in collisions.iter().chain(&visuals) {
        extent = match (extent, part.shape.radius()) {
            (Geometry::Mesh, _) | (_, None) => Geometry::Mesh,
            (Geometry::None, Some(radius)) => Geometry::Within(part.frame.translation.norm() + radius),
            (Geometry::Within(other), Some(radius)) => {
                Geometry::Within(other.max(part.frame.translation.norm() + radius))
            }
        };
    }
    for part in collisions.iter().chain(&visuals).filter(|part| part.shape.solid().is_none()) {
        findings.add_unread(part.element, || "<geometry> of an unsupported kind".to_owned());
    }
    let of_purpose = |parts: &[Collision], purpose| {
        let shapes = parts.iter().filter_map(|part| Some((part.shape.solid()?, part.frame)));
        shapes.map(|(solid, frame)| Shape { purpose, solid: solid.clone(), frame }).collect::<Vec<_>>()
    };
    let mut shapes = of_purpose(&collisions, Purpose::Collision);
    shapes.extend(of_purpose(&visuals, Purpose::Visual));
    LinkBody { inertia, shapes, extent }
}

/// Shapes in elements with a tag. A shape with invalid numbers is left out, with a warning.
fn read_shapes(scopes: &Scopes, link: usize, tag: &str, findings: &mut Findings<'_>) -> Vec<Collision> {
    let tree = findings.tree;
    let link = &scopes.links[link];
    let mut found = Vec::new();
    for element in tree.children_named(link.element, tag) {
        let Some(geometry) = tree.child(element, "geometry") else { continue };
        let shape = match read_shape(tree, geometry) {
            Ok(Some(shape)) => shape,
            Ok(None) => continue,
            Err(defect) => {
                findings.add_once(Severity::Warning, "bad-shape", tag, geometry, || {
                    format!("{defect}; the shape is ignored")
                });
                continue;
            }
        };
        let mut frame = Transform::identity();
        if let Some(pose) = tree.child(element, "pose") {
            let named = tree.attribute(pose, "relative_to").filter(|name| !name.is_empty());
            let base = named.and_then(|name| scopes.find(link.scope, name));
            let base = base.map_or_else(Transform::identity, |base| scopes.relative_pose(link.frame, base));
            frame = base * read_pose(pose, findings);
        }
        found.push(Collision { element, shape, frame });
    }
    found
}
