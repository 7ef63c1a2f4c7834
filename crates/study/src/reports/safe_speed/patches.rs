//! Parts of the surface of a link, as contacts of a proof.

use crate::model::loading::Model;
use nalgebra::Vector3;
use percuss_dynamics::{Contact, Direction, Frame, RangeProof};
use percuss_formats::{DEFAULT_MAX_MESH_SIZE, Purpose, Shape, Solid, Surface};
use percuss_mechanism::LinkId;
use percuss_spatial::Transform;
use std::f64::consts::FRAC_PI_2;

/// Largest number of triangles of a surface: three parts each, with 66 boxes of a proof.
const MOST_TRIANGLES: usize = 5_000;

/// Flat part with its outward normal, or curved part with the normals at an angle from its axis; frame of the link.
///
/// m̄ depends on the line of the force alone. A normal of a sphere passes through its centre, and a normal of a cylinder through its axis: the
/// contacts on these parts are those of the centre and of the axis, along all normals. Opposite normals have the same m̄.
pub(super) struct Patch {
    pub point: Vector3<f64>,
    pub normal: Vector3<f64>,
    /// Edges from the point, m; zero without one.
    pub edges: [Vector3<f64>; 2],
    /// Angles of the normals, rad.
    pub cone: [f64; 2],
    /// True for a disc, whose radius is the first edge.
    pub is_disc: bool,
}

impl Patch {
    /// Parts of the collision shapes of a link; of the visual ones if there are none.
    ///
    /// # Errors
    /// A message: no shapes, an unreadable mesh, or too many triangles.
    pub fn of_link(model: &Model, link: LinkId) -> Result<Vec<Self>, String> {
        let all = model.shapes.get(link.index()).map_or(&[][..], Vec::as_slice);
        let of = |purpose| all.iter().filter(|shape| shape.purpose == purpose).collect::<Vec<&Shape>>();
        let shapes =
            [Purpose::Collision, Purpose::Visual].map(of).into_iter().find(|shapes| !shapes.is_empty());
        let name = model.mechanism.link(link).name();
        let shapes = shapes.ok_or_else(|| {
            format!("link \"{name}\" has no shape; expected <collision> or <visual> with a geometry")
        })?;
        let (meshes, solids): (Vec<&Shape>, Vec<&Shape>) =
            shapes.into_iter().partition(|shape| matches!(shape.solid, Solid::Mesh { .. }));
        let mut patches: Vec<Self> =
            solids.iter().flat_map(|shape| Self::of_solid(&shape.solid, &shape.frame)).collect();
        let surface = Surface::read(meshes, &model.mesh_folders(Vec::new()), DEFAULT_MAX_MESH_SIZE);
        let surface = surface.map_err(|error| format!("link \"{name}\": {error}"))?;
        let facets = surface.facets(f64::INFINITY, MOST_TRIANGLES).map_err(|_| {
            format!("the mesh of link \"{name}\" has more than {MOST_TRIANGLES} triangles; expected a simpler collision shape")
        })?;
        for facet in facets {
            // The parallelograms of half the edges at the three corners are the triangle.
            let [a, b, c] = facet.corners;
            for [p, q, r] in [[a, b, c], [b, c, a], [c, a, b]] {
                patches.push(Self::flat(p, facet.normal, [0.5 * (q - p), 0.5 * (r - p)]));
            }
        }
        Ok(patches)
    }

    fn flat(point: Vector3<f64>, normal: Vector3<f64>, edges: [Vector3<f64>; 2]) -> Self {
        Self { point, normal, edges, cone: [0.0; 2], is_disc: false }
    }

    /// Parts of a solid; none of a mesh.
    fn of_solid(solid: &Solid, frame: &Transform<f64>) -> Vec<Self> {
        let zero = Vector3::zeros();
        let e = |k: usize| frame.vector(&Vector3::ith(k % 3, 1.0));
        let along = |z: f64| frame.point(&Vector3::new(0.0, 0.0, z));
        let curved =
            |point, edge, cone| Self { point, normal: e(2), edges: [edge, zero], cone, is_disc: false };
        let ball = |z: f64| curved(along(z), zero, [0.0, FRAC_PI_2]);
        let wall = |length: f64| curved(along(-0.5 * length), e(2) * length, [FRAC_PI_2; 2]);
        match *solid {
            Solid::Box { size } => {
                let face = |(k, sign): (usize, f64)| {
                    let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                    let mut corner = Vector3::from(size) * -0.5;
                    corner[k] *= -sign;
                    Self::flat(frame.point(&corner), e(k) * sign, [e(a) * size[a], e(b) * size[b]])
                };
                (0..3).flat_map(|k| [(k, 1.0), (k, -1.0)]).map(face).collect()
            }
            Solid::Sphere { .. } => vec![ball(0.0)],
            Solid::Cylinder { radius, length } => {
                let cap = |sign: f64| Self {
                    is_disc: true,
                    ..Self::flat(along(0.5 * sign * length), e(2) * sign, [e(0) * radius, zero])
                };
                vec![wall(length), cap(1.0), cap(-1.0)]
            }
            Solid::Capsule { length, .. } => vec![wall(length), ball(0.5 * length), ball(-0.5 * length)],
            Solid::Mesh { .. } => Vec::new(),
        }
    }

    /// Contact at the first point along the normal or axis.
    pub fn contact(&self, of: &Contact) -> Contact {
        Contact { point: self.point, normal: Direction::Along(self.normal, Frame::Link), ..*of }
    }

    /// Proof over the points and the normals of the part.
    pub fn proof(&self, of: RangeProof) -> RangeProof {
        RangeProof { cone: self.cone, edges: self.edges.map(Into::into), is_disc: self.is_disc, ..of }
    }
}
