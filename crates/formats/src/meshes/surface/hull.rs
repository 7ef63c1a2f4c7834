//! Convex hull of points. Source: Barber, Dobkin and Huhdanpaa, "The Quickhull algorithm for convex hulls", ACM TOMS 22 (1996).

use percuss_spatial::Vector3;
use std::collections::{HashMap, HashSet};

/// Distance from a face, relative to the size of the hull, up to which a point lies on it: a few roundings of the products.
const ON_FACE: f64 = 1e-13;
/// Distance from the first line or plane, relative to the size of the points, below which they enclose no volume.
const FLAT: f64 = 1e-9;

/// Work of a face with its edges, as a number of distances.
const FACE_WORK: usize = 100;

/// Reason for which there is no hull.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum HullDefect {
    /// The points lie in a plane.
    Flat,
    /// The work exceeds its limit.
    TooMuchWork,
}

/// Face with its plane: unit normal (outward) and offset.
struct Face {
    corners: [usize; 3],
    normal: Vector3<f64>,
    offset: f64,
    /// Points beyond the plane that lie beyond no earlier face.
    outside: Vec<usize>,
    is_removed: bool,
}

/// Faces of the convex hull as triples of point numbers, anticlockwise from outside. `work`: number of distances that may be computed;
/// those that are computed are subtracted.
///
/// # Errors
/// [`HullDefect`].
pub(crate) fn convex_hull(points: &[Vector3<f64>], work: &mut usize) -> Result<Vec<[usize; 3]>, HullDefect> {
    let first = first_tetrahedron(points)?;
    let size = points.iter().map(|p| (p - points[first[0]]).amax()).fold(0.0, f64::max);
    let mut builder =
        HullBuilder { points, on_face: ON_FACE * size, faces: Vec::new(), edges: HashMap::new(), work };
    let [a, b, c, d] = first;
    let new: Vec<usize> = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]]
        .into_iter()
        .map(|corners| builder.add_face(corners))
        .collect();
    builder.distribute((0..points.len()).filter(|p| !first.contains(p)).collect(), &new)?;
    let mut waiting = new;
    while let Some(face) = waiting.pop() {
        if builder.faces[face].is_removed || builder.faces[face].outside.is_empty() {
            continue;
        }
        let new = builder.extend(face)?;
        waiting.extend(new);
    }
    Ok(builder.faces.iter().filter(|face| !face.is_removed).map(|face| face.corners).collect())
}

/// Four points with a volume; the fourth lies behind the plane of the first three.
fn first_tetrahedron(points: &[Vector3<f64>]) -> Result<[usize; 4], HullDefect> {
    let farthest = |distance: &dyn Fn(&Vector3<f64>) -> f64| {
        let values = points.iter().map(distance).enumerate();
        values.fold((0, 0.0), |best, (i, value)| if value > best.1 { (i, value) } else { best })
    };
    let start = *points.first().ok_or(HullDefect::Flat)?;
    let (a, _) = farthest(&|p| (p - start).norm());
    let (b, length) = farthest(&|p| (p - points[a]).norm());
    if length == 0.0 {
        return Err(HullDefect::Flat);
    }
    let along = (points[b] - points[a]) / length;
    let (c, width) = farthest(&|p| (p - points[a]).cross(&along).norm());
    if width <= FLAT * length {
        return Err(HullDefect::Flat);
    }
    let normal = (points[b] - points[a]).cross(&(points[c] - points[a])).normalize();
    let (d, height) = farthest(&|p| (p - points[a]).dot(&normal).abs());
    if height <= FLAT * length {
        return Err(HullDefect::Flat);
    }
    let is_behind = (points[d] - points[a]).dot(&normal) < 0.0;
    Ok(if is_behind { [a, b, c, d] } else { [a, c, b, d] })
}

struct HullBuilder<'p> {
    points: &'p [Vector3<f64>],
    /// Distance up to which a point lies on a face, m.
    on_face: f64,
    faces: Vec<Face>,
    /// Face to the left of each directed edge.
    edges: HashMap<(usize, usize), usize>,
    /// Number of distances that may still be computed.
    work: &'p mut usize,
}

impl HullBuilder<'_> {
    fn add_face(&mut self, corners: [usize; 3]) -> usize {
        *self.work = self.work.saturating_sub(FACE_WORK);
        let [a, b, c] = corners.map(|corner| self.points[corner]);
        let normal = (b - a).cross(&(c - a));
        let length = normal.norm();
        // The plane of a face without area is unknown; no point lies beyond it.
        let normal = if length > 0.0 { normal / length } else { Vector3::zeros() };
        let index = self.faces.len();
        for k in 0..3 {
            self.edges.insert((corners[k], corners[(k + 1) % 3]), index);
        }
        self.faces.push(Face {
            corners,
            normal,
            offset: normal.dot(&a),
            outside: Vec::new(),
            is_removed: false,
        });
        index
    }

    /// Distance of a point from the plane of a face, positive outside, m.
    fn distance(&mut self, face: usize, point: usize) -> f64 {
        *self.work = self.work.saturating_sub(1);
        let Face { normal, offset, .. } = &self.faces[face];
        normal.dot(&self.points[point]) - offset
    }

    /// Gives each point to the first of the faces beyond which it lies.
    fn distribute(&mut self, points: Vec<usize>, faces: &[usize]) -> Result<(), HullDefect> {
        for point in points {
            let beyond = faces.iter().copied().find(|face| self.distance(*face, point) > self.on_face);
            if let Some(face) = beyond {
                self.faces[face].outside.push(point);
            }
        }
        if *self.work == 0 { Err(HullDefect::TooMuchWork) } else { Ok(()) }
    }

    /// Adds the farthest point beyond a face, with a cone of faces to the horizon. Returns the new faces.
    fn extend(&mut self, face: usize) -> Result<Vec<usize>, HullDefect> {
        let outside = std::mem::take(&mut self.faces[face].outside);
        let mut farthest = (outside[0], f64::NEG_INFINITY);
        for &point in &outside {
            let distance = self.distance(face, point);
            if distance > farthest.1 {
                farthest = (point, distance);
            }
        }
        let (apex, _) = farthest;
        let mut visible = vec![face];
        let mut seen = HashSet::from([face]);
        let mut horizon = Vec::new();
        let mut next = 0;
        while let Some(&face) = visible.get(next) {
            next += 1;
            let corners = self.faces[face].corners;
            for k in 0..3 {
                let edge = (corners[k], corners[(k + 1) % 3]);
                let Some(&neighbour) = self.edges.get(&(edge.1, edge.0)) else { continue };
                if seen.contains(&neighbour) {
                    continue;
                }
                if self.distance(neighbour, apex) > self.on_face {
                    seen.insert(neighbour);
                    visible.push(neighbour);
                } else {
                    horizon.push(edge);
                }
            }
        }
        // An edge found before its neighbour became visible is no part of the horizon.
        horizon.retain(|edge| self.edges.get(&(edge.1, edge.0)).is_some_and(|face| !seen.contains(face)));
        let mut points = outside;
        for face in visible {
            self.faces[face].is_removed = true;
            let corners = self.faces[face].corners;
            for k in 0..3 {
                let edge = (corners[k], corners[(k + 1) % 3]);
                if self.edges.get(&edge) == Some(&face) {
                    self.edges.remove(&edge);
                }
            }
            points.append(&mut self.faces[face].outside);
        }
        points.retain(|point| *point != apex);
        let new: Vec<usize> = horizon.into_iter().map(|(a, b)| self.add_face([a, b, apex])).collect();
        self.distribute(points, &new)?;
        Ok(new)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reading::limits::MAX_HULL_WORK;
    use approx::assert_relative_eq;

    fn volume(points: &[Vector3<f64>], faces: &[[usize; 3]]) -> f64 {
        let pyramid = |face: &[usize; 3]| {
            let [a, b, c] = face.map(|corner| points[corner] - points[0]);
            a.cross(&b).dot(&c) / 6.0
        };
        faces.iter().map(pyramid).sum()
    }

    #[test]
    fn a_cube_of_many_points_has_its_volume() {
        // All points of a grid: most lie on faces or inside.
        let steps = || (0..6).map(|i| f64::from(i) * 0.2);
        let points: Vec<Vector3<f64>> = steps()
            .flat_map(|x| steps().flat_map(move |y| steps().map(move |z| Vector3::new(x, y, z))))
            .collect();
        let faces = convex_hull(&points, &mut MAX_HULL_WORK.clone()).unwrap();
        assert_relative_eq!(volume(&points, &faces), 1.0, epsilon = 1e-12);
    }

    #[test]
    fn every_point_of_a_cloud_is_inside_or_on_the_hull() {
        // Points from a linear congruential generator, on a sphere and inside.
        let mut state = 1u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
        };
        let mut points: Vec<Vector3<f64>> =
            (0..500).map(|_| Vector3::new(number(), number(), number())).collect();
        for point in points.iter_mut().step_by(2) {
            *point = point.normalize() * 1.5;
        }
        let faces = convex_hull(&points, &mut MAX_HULL_WORK.clone()).unwrap();
        for face in &faces {
            let [a, b, c] = face.map(|corner| points[corner]);
            let normal = (b - a).cross(&(c - a)).normalize();
            let highest = points.iter().map(|p| normal.dot(&(p - a))).fold(0.0, f64::max);
            assert!(highest < 1e-12, "{highest}");
        }
        // Euler: a closed surface of triangles has 2 v − 4 faces.
        let corners: std::collections::HashSet<usize> = faces.iter().flatten().copied().collect();
        assert_eq!(faces.len(), 2 * corners.len() - 4);
    }

    #[test]
    fn flat_points_have_no_hull() {
        let points: Vec<Vector3<f64>> =
            (0..9).map(|i| Vector3::new(f64::from(i % 3), f64::from(i / 3), 1.0)).collect();
        let mut work = MAX_HULL_WORK;
        assert_eq!(convex_hull(&points, &mut work), Err(HullDefect::Flat));
        assert_eq!(convex_hull(&points[..1], &mut work), Err(HullDefect::Flat));
        assert_eq!(convex_hull(&[], &mut work), Err(HullDefect::Flat));
    }
}
