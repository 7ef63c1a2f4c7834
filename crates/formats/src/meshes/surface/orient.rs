//! Orientation of meshes: outward normals.
//!
//! Triangles that share an edge (corners equal to the last bit) get the same sense of winding. A connected piece with
//! a negative signed volume is reversed as a whole. A piece without an inside (an open sheet) is turned away from the
//! centre of the mesh.

use crate::reading::limits::MIN_RELATIVE_VOLUME;
use nalgebra::Vector3;
use std::collections::HashMap;

/// Counts of the changes that make the normals point outward.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Orientation {
    /// Number of connected pieces.
    pub pieces: usize,
    /// Number of reversed triangles, to match their neighbours or together with their piece.
    pub turned: usize,
    /// Number of pieces that are open or have no volume; their normals point away from the centre of the mesh.
    pub open: usize,
    /// Number of pieces without a consistent orientation (a Möbius strip, an edge of three triangles with conflicting
    /// winding).
    pub conflicting: usize,
}

impl Orientation {
    /// Adds the counts of another mesh.
    pub(super) fn add(&mut self, other: &Self) {
        self.pieces += other.pieces;
        self.turned += other.turned;
        self.open += other.open;
        self.conflicting += other.conflicting;
    }
}

type Triangle = [Vector3<f64>; 3];

/// Orders the corners of each triangle anticlockwise as seen from outside; counts the changes.
pub(super) fn orient_outward(triangles: &mut [Triangle]) -> Orientation {
    let corners = number_vertices(triangles);
    // Triangles at each edge.
    let mut edges: HashMap<(u32, u32), Vec<u32>> = HashMap::with_capacity(corners.len() * 3 / 2);
    for (t, corner) in (0_u32..).zip(&corners) {
        for k in 0..3 {
            let (a, b) = (corner[k], corner[(k + 1) % 3]);
            if a != b {
                edges.entry((a.min(b), a.max(b))).or_default().push(t);
            }
        }
    }
    let centre = triangles.iter().flatten().sum::<Vector3<f64>>() / (3 * triangles.len().max(1)) as f64;
    let mut orientation = Orientation::default();
    // True for a reversed triangle; `None` for a triangle not visited yet.
    let mut turned: Vec<Option<bool>> = vec![None; corners.len()];
    let mut piece = Vec::new();
    for start in 0..corners.len() {
        if turned[start].is_some() {
            continue;
        }
        turned[start] = Some(false);
        piece.clear();
        piece.push(start);
        let (mut next, mut closed, mut conflict) = (0, true, false);
        while let Some(&t) = piece.get(next) {
            next += 1;
            let is_reversed = turned[t] == Some(true);
            for k in 0..3 {
                let (a, b) = (corners[t][k], corners[t][(k + 1) % 3]);
                if a == b {
                    continue;
                }
                let sharing = &edges[&(a.min(b), a.max(b))];
                closed &= sharing.len() == 2;
                // An edge of more than two triangles does not determine the winding of its neighbours.
                let [first, second] = sharing[..] else { continue };
                let other = if first as usize == t { second } else { first } as usize;
                if other == t {
                    continue;
                }
                // Two neighbours with the same sense of winding pass their common edge in opposite directions.
                let expected = is_reversed ^ has_directed_edge(&corners[other], a, b);
                match turned[other] {
                    None => {
                        turned[other] = Some(expected);
                        piece.push(other);
                    }
                    Some(found) => conflict |= found != expected,
                }
            }
        }
        let signed = |t: usize| {
            let [a, b, c] = triangles[t].map(|p| p - centre);
            let volume = a.dot(&b.cross(&c)) / 6.0;
            if turned[t] == Some(true) { -volume } else { volume }
        };
        let volume: f64 = piece.iter().map(|&t| signed(t)).sum();
        let area: f64 = piece.iter().map(|&t| triangle_area(&triangles[t])).sum();
        let has_inside = closed && volume.abs() > MIN_RELATIVE_VOLUME * area * area.sqrt();
        orientation.pieces += 1;
        orientation.open += usize::from(!has_inside);
        orientation.conflicting += usize::from(conflict);
        // The sign of a sheet's volume with respect to the centre gives the side of the sheet on which the centre
        // lies.
        if volume < 0.0 {
            piece.iter().for_each(|&t| turned[t] = turned[t].map(|turned| !turned));
        }
    }
    for (triangle, turned) in triangles.iter_mut().zip(turned) {
        if turned == Some(true) {
            triangle.swap(1, 2);
            orientation.turned += 1;
        }
    }
    orientation
}

fn triangle_area([a, b, c]: &Triangle) -> f64 {
    0.5 * (b - a).cross(&(c - a)).norm()
}

/// True if the triangle has the edge `from` → `to` in this direction.
fn has_directed_edge(vertices: &[u32; 3], from: u32, to: u32) -> bool {
    (0..3).any(|k| vertices[k] == from && vertices[(k + 1) % 3] == to)
}

/// Vertex index of each corner; equal corners share an index.
fn number_vertices(triangles: &[Triangle]) -> Vec<[u32; 3]> {
    let mut known: HashMap<[u64; 3], u32> = HashMap::with_capacity(triangles.len() / 2 + 3);
    let mut number = |p: &Vector3<f64>| {
        // Maps −0 to 0.
        let key = [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits());
        let next = known.len() as u32;
        *known.entry(key).or_insert(next)
    };
    triangles.iter().map(|t| [number(&t[0]), number(&t[1]), number(&t[2])]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> Vec<Triangle> {
        let at = |i: usize| {
            let bit = |k: usize| if i >> k & 1 == 1 { 1.0 } else { 0.0 };
            Vector3::new(bit(0), bit(1), bit(2))
        };
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let halves = |f: [usize; 4]| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]];
        faces.into_iter().flat_map(halves).map(|t| t.map(at)).collect()
    }

    fn is_outward(triangles: &[Triangle], centre: Vector3<f64>) -> bool {
        triangles.iter().all(|[a, b, c]| (b - a).cross(&(c - a)).dot(&(a - centre)) > 0.0)
    }

    #[test]
    fn every_mixture_of_windings_comes_out_outward() {
        for mask in 0..4096_u32 {
            let mut triangles = cube();
            for (i, t) in triangles.iter_mut().enumerate().filter(|(i, _)| mask >> i & 1 == 1) {
                let _ = i;
                t.swap(0, 1);
            }
            let done = orient_outward(&mut triangles);
            assert!(is_outward(&triangles, Vector3::repeat(0.5)), "{mask:b}");
            assert_eq!((done.pieces, done.open, done.conflicting), (1, 0, 0));
            assert_eq!(done.turned, mask.count_ones() as usize);
        }
    }

    #[test]
    fn pieces_are_turned_by_themselves() {
        let mut triangles = cube();
        let mut second = cube();
        second.iter_mut().for_each(|t| {
            *t = t.map(|p| p + Vector3::new(5.0, 0.0, 0.0));
            t.swap(0, 1);
        });
        triangles.extend(second);
        let done = orient_outward(&mut triangles);
        assert_eq!((done.pieces, done.turned, done.open), (2, 12, 0));
        assert!(is_outward(&triangles[..12], Vector3::repeat(0.5)));
        assert!(is_outward(&triangles[12..], Vector3::new(5.5, 0.5, 0.5)));
    }

    #[test]
    fn an_open_sheet_is_turned_away_from_the_centre() {
        let mut triangles = cube();
        // The lid is removed, and all triangles are wound inward.
        triangles.drain(2..4);
        triangles.iter_mut().for_each(|t| t.swap(0, 1));
        let done = orient_outward(&mut triangles);
        assert_eq!((done.pieces, done.open), (1, 1));
        assert!(is_outward(&triangles, Vector3::new(0.5, 0.5, 0.4)));
    }

    #[test]
    fn a_strip_with_a_twist_is_in_conflict_and_no_more() {
        let count = 12;
        let at = |i: usize, side: f64| {
            let turn = std::f64::consts::TAU * (i % count) as f64 / count as f64;
            let twist = if i == count { -side } else { side };
            let half = 0.5 * turn;
            let out = 2.0 + twist * 0.5 * half.cos();
            Vector3::new(out * turn.cos(), out * turn.sin(), twist * 0.5 * half.sin())
        };
        let mut triangles = Vec::new();
        for i in 0..count {
            triangles.push([at(i, 1.0), at(i, -1.0), at(i + 1, 1.0)]);
            triangles.push([at(i, -1.0), at(i + 1, -1.0), at(i + 1, 1.0)]);
        }
        let done = orient_outward(&mut triangles);
        assert_eq!((done.pieces, done.conflicting), (1, 1));
    }
}
