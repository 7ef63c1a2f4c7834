//! Shapes of links.

use crate::mjcf::bodies::solids::{self, UnitInertia};
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::limits::MAX_SHAPE_SIZE;
use crate::shape::Solid;
use crate::urdf::elements::numbers::parse_numbers;
use percuss_spatial::Transform;
use std::f64::consts::PI;

/// Shape in its own frame.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SdfShape {
    Solid(Solid),
    /// Cone about z with its apex at +length/2.
    Cone {
        radius: f64,
        length: f64,
    },
    Ellipsoid {
        radii: [f64; 3],
    },
    /// Plane, height map, image or polyline.
    Other(String),
}

/// Collision or visual of a link.
#[derive(Clone, Debug)]
pub(crate) struct Collision {
    pub element: ElementId,
    pub shape: SdfShape,
    /// Frame of the shape in the link.
    pub frame: Transform<f64>,
}

/// Shape of a `<geometry>`; `None` if it is empty. The error names the defect.
pub(crate) fn read_shape(tree: &ElementTree, geometry: ElementId) -> Result<Option<SdfShape>, String> {
    let known = |child: &&ElementId| !tree.tag(**child).contains(':');
    let Some(&shape) = tree.children(geometry).iter().find(known) else { return Ok(None) };
    let length = |tag| number_in::<1>(tree, shape, tag).map(|[value]| value);
    Ok(Some(match tree.tag(shape) {
        "empty" => return Ok(None),
        "box" => SdfShape::Solid(Solid::Box { size: number_in(tree, shape, "size")? }),
        "sphere" => SdfShape::Solid(Solid::Sphere { radius: length("radius")? }),
        "cylinder" => {
            SdfShape::Solid(Solid::Cylinder { radius: length("radius")?, length: length("length")? })
        }
        "capsule" => SdfShape::Solid(Solid::Capsule { radius: length("radius")?, length: length("length")? }),
        "cone" => SdfShape::Cone { radius: length("radius")?, length: length("length")? },
        "ellipsoid" => SdfShape::Ellipsoid { radii: number_in(tree, shape, "radii")? },
        "mesh" => {
            let uri = tree.child(shape, "uri").map(|uri| tree.text(uri)).unwrap_or_default();
            let scale = match tree.child(shape, "scale") {
                Some(scale) => parse_numbers::<3>(tree.text(scale))?,
                None => [1.0; 3],
            };
            SdfShape::Solid(Solid::Mesh { file: uri.to_owned(), scale })
        }
        other => SdfShape::Other(other.to_owned()),
    }))
}

/// Positive numbers in a child element, m.
fn number_in<const N: usize>(tree: &ElementTree, shape: ElementId, tag: &str) -> Result<[f64; N], String> {
    let element = tree.child(shape, tag).ok_or_else(|| format!("the shape has no <{tag}>"))?;
    let values = parse_numbers::<N>(tree.text(element)).map_err(|defect| format!("<{tag}>: {defect}"))?;
    if values.iter().all(|value| *value > 0.0 && *value <= MAX_SHAPE_SIZE) {
        Ok(values)
    } else {
        Err(format!("<{tag}>: positive lengths in m are expected"))
    }
}

impl SdfShape {
    /// Solid for drawings and maps; `None` for a kind without a counterpart.
    pub fn solid(&self) -> Option<&Solid> {
        match self {
            SdfShape::Solid(solid) => Some(solid),
            SdfShape::Cone { .. } | SdfShape::Ellipsoid { .. } | SdfShape::Other(_) => None,
        }
    }

    /// Radius of the sphere about the origin of the shape that contains the shape, m; `None` for meshes and infinite shapes.
    pub fn radius(&self) -> Option<f64> {
        Some(match self {
            SdfShape::Solid(solid) => solid.radius()?,
            SdfShape::Cone { radius, length } => radius.hypot(length / 2.0),
            SdfShape::Ellipsoid { radii: [a, b, c] } => a.max(*b).max(*c),
            SdfShape::Other(_) => return None,
        })
    }

    /// Volume and moments of the solid shape, and the position of its centroid along z, m; `None` for meshes and infinite shapes.
    pub fn unit_inertia(&self) -> Option<(UnitInertia, f64)> {
        let centred = match self {
            SdfShape::Solid(solid) => solids::unit_inertia(solid, false)?,
            SdfShape::Ellipsoid { radii } => solids::ellipsoid(*radii),
            SdfShape::Cone { radius, length } => {
                let (r2, h2) = (radius * radius, length * length);
                let across = 3.0 / 20.0 * r2 + 3.0 / 80.0 * h2;
                let moments = [across, across, 3.0 / 10.0 * r2];
                // The centroid of a cone is a quarter of its height above the base.
                return Some((UnitInertia { volume: PI * r2 * length / 3.0, moments }, -length / 4.0));
            }
            SdfShape::Other(_) => return None,
        };
        Some((centred, 0.0))
    }
}
