//! Extreme of 1/m̄ at a pose over normals in a cone and points of a patch.

use crate::mobility::delassus::Delassus;
use crate::ranges::extreme_question::ExtremeKind;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use percuss_dynamics::{Contact, Direction, Frame, Pose};
use percuss_spatial::plane_basis;
use std::f64::consts::TAU;

/// Steps of the alternation between the best normal and the best point.
const ALTERNATIONS: usize = 30;
/// Normals on the border of a cone at which a search for the best one starts: 1/m̄ is a trigonometric polynomial of degree 2 there.
const BORDER_STARTS: usize = 24;

/// Normals around that of the contact, and points p + Σ xᵢ eᵢ, 0 ≤ xᵢ ≤ 1.
#[derive(Clone, Copy)]
pub(super) struct VariedContact<'a> {
    /// Largest angle between the normals and that of the contact, rad.
    pub cone: f64,
    /// Edges eᵢ of the patch, in the frame of the contact link, m; two at most.
    pub edges: &'a [Vector3<f64>],
}

impl VariedContact<'_> {
    /// Contact with the extreme m̄ at a pose, with its unit normal in the world; `None` if a massless motion moves a point.
    ///
    /// For a normal, 1/m̄ = cᵀGc with the weights c = (1 − Σx, x) of the points p, p + e₁, p + e₂ and G = n·W n of their Delassus matrix;
    /// for a point it is nᵀBn. The smallest m̄ is at a corner of the patch, because cᵀGc is convex in x. The largest one is the best of
    /// alternating minimisations from all corners and the centre.
    pub fn extreme(
        &self,
        pose: &Pose,
        contact: &Contact,
        kind: ExtremeKind,
    ) -> Option<(Contact, Vector3<f64>)> {
        let points = std::iter::once(Vector3::zeros()).chain(self.edges.iter().copied());
        let at =
            |offset: Vector3<f64>| pose.locate(&Contact { point: contact.point + offset, ..*contact }).ok();
        let located = points.map(at).collect::<Option<Vec<_>>>()?;
        let mobility = Delassus::new(pose, &located).ok()?;
        let axes = mobility.axes(0);
        let block =
            |i: usize, j: usize| axes * mobility.matrix().fixed_view::<3, 3>(3 * i, 3 * j) * axes.transpose();
        let given = -axes.column(0).into_owned();
        let (count, most) = (located.len(), kind == ExtremeKind::Most);
        let weights = |x: &[f64]| {
            std::iter::once(1.0 - x.iter().sum::<f64>()).chain(x.iter().copied()).collect::<Vec<f64>>()
        };
        let of_point = |x: &[f64]| {
            let c = weights(x);
            let pairs = (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
            pairs.fold(Matrix3::zeros(), |sum, (i, j)| sum + block(i, j) * (c[i] * c[j]))
        };
        let of_normal = |n: &Vector3<f64>| DMatrix::from_fn(count, count, |i, j| n.dot(&(block(i, j) * n)));
        let sign = if most { 1.0 } else { -1.0 };
        let corner =
            |k: usize| (0..count - 1).map(|i| f64::from(u8::from(k >> i & 1 == 1))).collect::<Vec<f64>>();
        let mut starts: Vec<Vec<f64>> = (0..1 << (count - 1)).map(corner).collect();
        if most {
            starts.push(vec![0.5; count - 1]);
        }
        let mut best: Option<(f64, Vec<f64>, Vector3<f64>)> = None;
        for mut x in starts {
            let mut normal = best_in_cone(&of_point(&x), &given, self.cone, sign);
            for _ in 0..if most && count > 1 { ALTERNATIONS } else { 0 } {
                let next = lowest_on_patch(&of_normal(&normal));
                let is_same = next.iter().zip(&x).all(|(a, b)| (a - b).abs() < 1e-12);
                x = next;
                normal = best_in_cone(&of_point(&x), &given, self.cone, sign);
                if is_same {
                    break;
                }
            }
            let value = sign * normal.dot(&(of_point(&x) * normal));
            if best.as_ref().is_none_or(|(least, ..)| value < *least) {
                best = Some((value, x, normal));
            }
        }
        let (_, x, normal) = best?;
        let point = x.iter().zip(self.edges).fold(contact.point, |sum, (x, edge)| sum + edge * *x);
        let normal_world = pose.base().vector(&normal);
        // The cone moves with the frame in which the normal is given.
        let frame = match contact.normal {
            Direction::Along(_, frame) | Direction::About(_, frame) => frame,
            _ => Frame::World,
        };
        let turned = match (frame, contact.against) {
            (Frame::Link, _) => pose.link(contact.link).inverse_vector(&normal_world),
            (Frame::Against, Some(other)) => pose.link(other).inverse_vector(&normal_world),
            _ => normal_world,
        };
        let direction = match contact.normal.is_moment() {
            true => Direction::About(turned, frame),
            false => Direction::Along(turned, frame),
        };
        Some((Contact { point, normal: direction, ..*contact }, normal_world))
    }
}

/// Unit vector n within an angle of `given` with the smallest sign · nᵀBn: an eigenvector, or on the border of the cone.
fn best_in_cone(b: &Matrix3<f64>, given: &Vector3<f64>, angle: f64, sign: f64) -> Vector3<f64> {
    if angle == 0.0 {
        return *given;
    }
    let value = |n: &Vector3<f64>| sign * n.dot(&(b * n));
    let (e1, e2) = plane_basis(given);
    let border = |psi: f64| given * angle.cos() + (e1 * psi.cos() + e2 * psi.sin()) * angle.sin();
    let eigen = b.symmetric_eigen();
    let inside = (0..3).map(|k| eigen.eigenvectors.column(k).into_owned());
    let inside = inside.map(|n| n * n.dot(given).signum()).filter(|n| n.dot(given) >= angle.cos());
    let starts = (0..BORDER_STARTS).map(|k| TAU * k as f64 / BORDER_STARTS as f64);
    let start = starts.min_by(|a, b| value(&border(*a)).total_cmp(&value(&border(*b)))).unwrap_or(0.0);
    // Newton steps; f′ and f″ along the border.
    let mut psi = start;
    for _ in 0..8 {
        let (n, d) = (border(psi), (e2 * psi.cos() - e1 * psi.sin()) * angle.sin());
        let dd = given * angle.cos() - n;
        let (first, second) = (2.0 * d.dot(&(b * n)), 2.0 * (d.dot(&(b * d)) + dd.dot(&(b * n))));
        if sign * second <= 0.0 {
            break;
        }
        psi -= first / second;
    }
    let ends = [border(start), border(psi)];
    let all = inside.chain(ends);
    all.min_by(|a, b| value(a).total_cmp(&value(b))).unwrap_or(*given)
}

/// Point x of [0, 1]ᵏ with the smallest cᵀGc, c = (1 − Σx, x): the lowest of the stationary points inside, on the edges and the corners.
fn lowest_on_patch(g: &DMatrix<f64>) -> Vec<f64> {
    let k = g.nrows() - 1;
    // cᵀGc = g₀₀ + 2 h·x + xᵀHx.
    let h = DVector::from_fn(k, |i, _| g[(0, i + 1)] - g[(0, 0)]);
    let hessian =
        DMatrix::from_fn(k, k, |i, j| g[(i + 1, j + 1)] - g[(0, i + 1)] - g[(0, j + 1)] + g[(0, 0)]);
    let value = |x: &[f64]| {
        let x = DVector::from_column_slice(x);
        2.0 * h.dot(&x) + x.dot(&(&hessian * &x))
    };
    // Each number is 0, 1, or free.
    let mut found: Vec<Vec<f64>> = Vec::new();
    for choice in 0..3_usize.pow(k as u32) {
        let held: Vec<Option<f64>> =
            (0..k as u32).map(|i| [Some(0.0), Some(1.0), None][choice / 3_usize.pow(i) % 3]).collect();
        let free: Vec<usize> = (0..k).filter(|i| held[*i].is_none()).collect();
        let mut x: Vec<f64> = held.iter().map(|x| x.unwrap_or(0.0)).collect();
        if !free.is_empty() {
            let at = DVector::from_column_slice(&x);
            let gradient = &hessian * &at + &h;
            let right = DVector::from_fn(free.len(), |i, _| -gradient[free[i]]);
            let square = DMatrix::from_fn(free.len(), free.len(), |i, j| hessian[(free[i], free[j])]);
            let Some(step) = square.lu().solve(&right) else { continue };
            if step.iter().any(|x| !(0.0..=1.0).contains(x)) {
                continue;
            }
            free.iter().zip(step.iter()).for_each(|(i, step)| x[*i] = *step);
        }
        found.push(x);
    }
    found.into_iter().min_by(|a, b| value(a).total_cmp(&value(b))).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The best direction is a unit vector within the cone, and no direction of a grid over the cone is better.
    #[test]
    fn the_best_direction_in_a_cone_is_as_good_as_those_of_a_grid() {
        for k in 0..24 {
            let at = |i: usize| f64::from(7 * k + 3 * i as i32 + 1).sin();
            let b = Matrix3::new(at(0), at(1), at(2), at(1), at(3), at(4), at(2), at(4), at(5));
            let (given, angle) = (Vector3::new(at(6), at(7), at(8)).normalize(), 0.05 + 0.04 * f64::from(k));
            let (e1, e2) = plane_basis(&given);
            for sign in [1.0, -1.0] {
                let value = |n: &Vector3<f64>| sign * n.dot(&(b * n));
                let best = best_in_cone(&b, &given, angle, sign);
                assert!(
                    (best.norm() - 1.0).abs() < 1e-12 && best.dot(&given) > angle.cos() - 1e-12,
                    "{best}"
                );
                for (i, j) in (0..=8).flat_map(|i| (0..64).map(move |j| (i, j))) {
                    let (tilt, psi) = (angle * f64::from(i) / 8.0, TAU * f64::from(j) / 64.0);
                    let n = given * tilt.cos() + (e1 * psi.cos() + e2 * psi.sin()) * tilt.sin();
                    assert!(value(&best) < value(&n) + 1e-12, "{k} {sign}: {best} {n}");
                }
            }
        }
    }
}
