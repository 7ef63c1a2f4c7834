//! Geoms: shapes with the mass from which the inertia of a body may follow.

use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::orientation::{read_pose, rotation_to_z};
use crate::mjcf::values::settings::Settings;
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::Findings;
use crate::shape::{Purpose, Shape, Solid};
use percuss_spatial::{Transform, Vector3};

/// Density of a geom without `density` and `mass`, kg/m³.
const DEFAULT_DENSITY: f64 = 1000.0;

/// Shape of a geom; lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum GeomShape {
    Plane,
    HeightField,
    /// Sphere, capsule, cylinder or box.
    Solid(Solid),
    Ellipsoid {
        semi_axes: [f64; 3],
    },
    /// Mesh asset with this name.
    Mesh(String),
    /// Primitive that MuJoCo fits to the mesh with this name.
    FittedToMesh,
    /// Signed distance field of a plugin.
    DistanceField,
}

/// Geom of a body.
#[derive(Clone, Debug)]
pub(crate) struct Geom {
    pub element: ElementId,
    pub shape: GeomShape,
    /// Frame of the shape in the body.
    pub frame: Transform<f64>,
    /// Declared mass, kg.
    pub mass: Option<f64>,
    /// kg/m³; kg/m² for a shell.
    pub density: f64,
    /// True if the mass is spread over the surface.
    pub is_shell: bool,
    pub group: f64,
    pub purpose: Purpose,
}

/// Keywords of `type`.
#[derive(Clone, Copy, PartialEq, Eq)]
enum GeomType {
    Plane,
    HeightField,
    Sphere,
    Capsule,
    Ellipsoid,
    Cylinder,
    Box,
    Mesh,
    DistanceField,
}

const TYPES: [(&str, GeomType); 9] = [
    ("plane", GeomType::Plane),
    ("hfield", GeomType::HeightField),
    ("sphere", GeomType::Sphere),
    ("capsule", GeomType::Capsule),
    ("ellipsoid", GeomType::Ellipsoid),
    ("cylinder", GeomType::Cylinder),
    ("box", GeomType::Box),
    ("mesh", GeomType::Mesh),
    ("sdf", GeomType::DistanceField),
];

/// Reads a geom in a frame of its body; `None`, with an error, if a size is invalid.
pub(crate) fn read_geom(
    attributes: Attributes<'_>,
    x_bf: &Transform<f64>,
    settings: &Settings,
    findings: &mut Findings<'_>,
) -> Option<Geom> {
    let kind = attributes.word("type", &TYPES, findings).unwrap_or(GeomType::Sphere);
    let line = attributes.numbers::<6>("fromto", findings);
    let half_length = line.map(line_half_length);
    let frame = match line {
        Some(line) => frame_on_line(attributes, line, findings)?,
        None => read_pose(attributes, settings, findings),
    };
    let shape = read_shape(attributes, kind, half_length, findings)?;
    let [mass, density] = ["mass", "density"].map(|name| {
        let value = attributes.number(name, findings);
        if let Some(value) = value.filter(|value| *value < 0.0) {
            findings.attribute_error("negative-mass", attributes.element, name, || {
                format!(
                    "{name} is {value} {}; expected 0 or more",
                    if name == "mass" { "kg" } else { "kg/m³" }
                )
            });
        }
        value
    });
    let is_visual = ["contype", "conaffinity"]
        .map(|name| attributes.number(name, findings).unwrap_or(1.0))
        .iter()
        .all(|mask| *mask == 0.0);
    Some(Geom {
        element: attributes.element,
        shape,
        frame: *x_bf * frame,
        mass,
        density: density.unwrap_or(DEFAULT_DENSITY),
        is_shell: attributes.flag("shellinertia", findings).unwrap_or(false),
        group: attributes.number("group", findings).unwrap_or(0.0),
        purpose: if is_visual { Purpose::Visual } else { Purpose::Collision },
    })
}

/// Half the distance of the points of a `fromto`, m.
fn line_half_length([a, b, c, d, e, f]: [f64; 6]) -> f64 {
    0.5 * Vector3::new(d - a, e - b, f - c).norm()
}

/// Frame with its origin in the middle of a `fromto` and its z-axis along the line.
pub(crate) fn frame_on_line(
    attributes: Attributes<'_>,
    [a, b, c, d, e, f]: [f64; 6],
    findings: &mut Findings<'_>,
) -> Option<Transform<f64>> {
    if attributes.source(&["pos"]).is_some() {
        findings.error("two-poses", attributes.element, || {
            "both pos and fromto are given (a value of a class counts too); one of them is expected"
                .to_owned()
        });
        return None;
    }
    let (from, to) = (Vector3::new(a, b, c), Vector3::new(d, e, f));
    let rotation = rotation_to_z(to - from);
    if rotation.is_none() {
        findings.error("zero-length", attributes.element, || {
            "the two points of fromto coincide; two different points are expected".to_owned()
        });
    }
    Some(Transform::new(rotation?, (from + to) * 0.5))
}

/// Shape of a geom. Sizes that are missing or not positive are errors; `half_length` (m): half the distance of the points of `fromto`,
/// which replaces the length in `size`.
fn read_shape(
    attributes: Attributes<'_>,
    kind: GeomType,
    half_length: Option<f64>,
    findings: &mut Findings<'_>,
) -> Option<GeomShape> {
    let mesh = attributes.text("mesh");
    let (count, name) = match kind {
        GeomType::Plane => return Some(GeomShape::Plane),
        GeomType::HeightField => return Some(GeomShape::HeightField),
        GeomType::DistanceField => return Some(GeomShape::DistanceField),
        GeomType::Mesh => {
            if mesh.is_none() {
                findings.error("missing-attribute", attributes.element, || {
                    "a geom of type mesh has no attribute \"mesh\", the name of the asset".to_owned()
                });
            }
            return mesh.map(|name| GeomShape::Mesh(name.to_owned()));
        }
        _ if mesh.is_some() => return Some(GeomShape::FittedToMesh),
        GeomType::Sphere => (1, "sphere"),
        GeomType::Capsule => (2, "capsule"),
        GeomType::Cylinder => (2, "cylinder"),
        GeomType::Ellipsoid => (3, "ellipsoid"),
        GeomType::Box => (3, "box"),
    };
    let mut sizes = attributes.list("size", 3, findings).unwrap_or_default();
    if let Some(half_length) = half_length {
        let across = sizes.first().copied().unwrap_or(0.0);
        sizes = if count == 2 { vec![across, half_length] } else { vec![across, across, half_length] };
    }
    if sizes.len() < count || sizes.iter().take(count).any(|size| *size <= 0.0) {
        findings.error("bad-size", attributes.element, || {
            let given: Vec<String> = sizes.iter().map(f64::to_string).collect();
            format!(
                "a {name} needs {count} positive numbers in size (half lengths, m; one with fromto), given: \"{}\"",
                given.join(" ")
            )
        });
        return None;
    }
    sizes.resize(3, 0.0);
    let [a, b, c] = [sizes[0], sizes[1], sizes[2]];
    Some(GeomShape::Solid(match kind {
        GeomType::Ellipsoid => return Some(GeomShape::Ellipsoid { semi_axes: [a, b, c] }),
        GeomType::Capsule => Solid::Capsule { radius: a, length: 2.0 * b },
        GeomType::Cylinder => Solid::Cylinder { radius: a, length: 2.0 * b },
        GeomType::Box => Solid::Box { size: [a, b, c].map(|half| 2.0 * half) },
        _ => Solid::Sphere { radius: a },
    }))
}

impl Geom {
    /// Shape for drawings and maps; `None` for a kind without a counterpart. `mesh`: solid of a mesh asset, with the frame of the
    /// mesh file in the geom.
    pub fn shape(&self, mesh: impl FnOnce(&str) -> Option<(Solid, Transform<f64>)>) -> Option<Shape> {
        let mut frame = self.frame;
        let solid = match &self.shape {
            GeomShape::Solid(solid) => solid.clone(),
            GeomShape::Mesh(name) => {
                let (solid, in_geom) = mesh(name)?;
                frame = frame * in_geom;
                solid
            }
            GeomShape::Plane
            | GeomShape::HeightField
            | GeomShape::Ellipsoid { .. }
            | GeomShape::FittedToMesh
            | GeomShape::DistanceField => return None,
        };
        Some(Shape { purpose: self.purpose, solid, frame })
    }

    /// Radius, m, of a sphere about the body's origin around the shape; `None` for a mesh or an infinite shape.
    pub fn radius(&self) -> Option<f64> {
        let own = match &self.shape {
            GeomShape::Solid(solid) => solid.radius()?,
            GeomShape::Ellipsoid { semi_axes: [a, b, c] } => a.max(*b).max(*c),
            GeomShape::Plane
            | GeomShape::HeightField
            | GeomShape::Mesh(_)
            | GeomShape::FittedToMesh
            | GeomShape::DistanceField => return None,
        };
        Some(self.frame.translation.norm() + own)
    }
}
