//! Shapes of links.

use percuss_spatial::Transform;

/// Purpose of a declared shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Purpose {
    /// `<collision>`.
    Collision,
    /// `<visual>`.
    Visual,
}

impl Purpose {
    /// Name of the XML element.
    pub fn name(self) -> &'static str {
        match self {
            Purpose::Collision => "collision",
            Purpose::Visual => "visual",
        }
    }
}

/// Solid in its own frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Solid {
    /// Box centred at the origin; edge lengths in m.
    Box {
        /// Edge lengths along x, y and z.
        size: [f64; 3],
    },
    /// Sphere centred at the origin, m.
    Sphere {
        /// Radius.
        radius: f64,
    },
    /// Cylinder about the z axis, centred at the origin, m.
    Cylinder {
        /// Radius.
        radius: f64,
        /// Length from end to end.
        length: f64,
    },
    /// Cylinder about the z axis with hemispherical ends, centred at the origin, m.
    Capsule {
        /// Radius.
        radius: f64,
        /// Length of the cylinder without the hemispheres.
        length: f64,
    },
    /// Triangle mesh.
    Mesh {
        /// File name in the URDF.
        file: String,
        /// Scale factors of x, y and z.
        scale: [f64; 3],
    },
}

impl Solid {
    /// Radius of the sphere about the origin that contains the solid, m; `None` for a mesh.
    pub(crate) fn radius(&self) -> Option<f64> {
        Some(match self {
            Solid::Box { size: [a, b, c] } => a.hypot(*b).hypot(*c) / 2.0,
            Solid::Sphere { radius } => *radius,
            Solid::Cylinder { radius, length } => radius.hypot(length / 2.0),
            Solid::Capsule { radius, length } => radius + length / 2.0,
            Solid::Mesh { .. } => return None,
        })
    }
}

/// Shape of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Declared purpose.
    pub purpose: Purpose,
    /// Solid in its own frame.
    pub solid: Solid,
    /// Pose of the solid's frame in the link frame.
    pub frame: Transform<f64>,
}
