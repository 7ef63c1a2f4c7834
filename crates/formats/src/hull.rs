//! Inertias that no mass inside the shapes of a link has.

use crate::shape::{Purpose, Shape, Solid};
use nalgebra::Vector3;
use percuss_mechanism::{Mechanism, Problem, Subject};

/// Factor on the largest half trace, dimensionless: shapes for collisions are simplified, and may be 1.4 times too small.
const HULL_SLACK: f64 = 2.0;

/// Distance of a centre of mass outside the shapes, relative to their size, for the same reason.
const COM_SLACK: f64 = 0.5;

/// Number of steps of the search for a separating plane; each brings the point of the hull nearer to the centre of mass.
const HULL_STEPS: usize = 100;

/// Warnings for inertias that no mass in the convex hull of the collision shapes (visual shapes if there is none) has: with the centre of
/// mass c, tr(I)/2 = ∫ |x − c|² dm ≤ m·max |x − c|², and c is in the hull. Links with a mesh among these shapes are left out: meshes are not
/// opened. `shapes`: shapes of every link.
pub(crate) fn inertias_beyond_shapes(
    mechanism: &Mechanism,
    shapes: &[Vec<Shape>],
) -> Vec<(Subject, Problem)> {
    let mut found = Vec::new();
    for (index, (link, shapes)) in mechanism.links().iter().zip(shapes).enumerate() {
        let Some(inertial) = link.inertial().filter(|inertial| inertial.mass > 0.0) else { continue };
        let has = |purpose: &Purpose| shapes.iter().any(|shape| shape.purpose == *purpose);
        let purpose = [Purpose::Collision, Purpose::Visual].into_iter().find(has);
        let hull: Vec<&Shape> = shapes.iter().filter(|shape| Some(shape.purpose) == purpose).collect();
        let is_unknown = |shape: &&Shape| {
            matches!(shape.solid, Solid::Mesh { .. }) || farthest(shape, &inertial.com) == 0.0
        };
        if hull.is_empty() || hull.iter().any(is_unknown) {
            continue;
        }
        let (mass, half_trace) = (inertial.mass, inertial.about_com.trace() / 2.0);
        let bound = mass * largest(&hull, &inertial.com).powi(2);
        let middle =
            hull.iter().map(|shape| shape.frame.translation).sum::<Vector3<f64>>() / hull.len() as f64;
        let size = largest(&hull, &middle);
        let distance = distance_from_hull(&hull, &inertial.com, &middle);
        let problem = if distance > COM_SLACK * size {
            Problem::ComBeyondShape { distance, size }
        } else if half_trace > HULL_SLACK * bound {
            Problem::InertiaBeyondShape { mass, half_trace, bound }
        } else {
            continue;
        };
        found.push((Subject::Link { index, name: link.name().to_owned() }, problem));
    }
    found
}

/// Largest distance of a point of the shapes from x, m.
fn largest(shapes: &[&Shape], x: &Vector3<f64>) -> f64 {
    shapes.iter().map(|shape| farthest(shape, x)).fold(0.0, f64::max)
}

/// Largest distance of a point of a solid from x, m.
fn farthest(shape: &Shape, x: &Vector3<f64>) -> f64 {
    let local = shape.frame.rotation.transpose() * (x - shape.frame.translation);
    let [x, y, z] = local.map(f64::abs).into();
    match shape.solid {
        Solid::Box { size: [a, b, c] } => Vector3::new(x + a / 2.0, y + b / 2.0, z + c / 2.0).norm(),
        Solid::Sphere { radius } => local.norm() + radius,
        Solid::Cylinder { radius, length } => (x.hypot(y) + radius).hypot(z + length / 2.0),
        Solid::Capsule { radius, length } => x.hypot(y).hypot(z + length / 2.0) + radius,
        Solid::Mesh { .. } => 0.0,
    }
}

/// Point of the shapes that is farthest in a direction.
fn support(shapes: &[&Shape], direction: &Vector3<f64>) -> Vector3<f64> {
    let of_shape = |shape: &&Shape| {
        let local = shape.frame.rotation.transpose() * direction;
        let along = local.map(f64::signum);
        let radial = |radius: f64| {
            let norm = local.x.hypot(local.y);
            if norm > 0.0 { Vector3::new(local.x, local.y, 0.0) * (radius / norm) } else { Vector3::zeros() }
        };
        let ball = |radius: f64| local.try_normalize(0.0).unwrap_or_else(Vector3::x) * radius;
        let end = |length: f64| Vector3::z() * (along.z * length / 2.0);
        let point = match shape.solid {
            Solid::Box { size } => Vector3::from(size).component_mul(&along) / 2.0,
            Solid::Sphere { radius } => ball(radius),
            Solid::Cylinder { radius, length } => radial(radius) + end(length),
            Solid::Capsule { radius, length } => ball(radius) + end(length),
            Solid::Mesh { .. } => Vector3::zeros(),
        };
        shape.frame.rotation * point + shape.frame.translation
    };
    let points = shapes.iter().map(of_shape);
    points.max_by(|a, b| a.dot(direction).total_cmp(&b.dot(direction))).unwrap_or_else(Vector3::zeros)
}

/// Lower bound of the distance of x from the convex hull of the shapes, m: the distance of the best separating plane found. 0 inside.
/// `inside`: a point of the hull. Source: Gilbert, SIAM J. Control 4 (1966), 61–80.
fn distance_from_hull(shapes: &[&Shape], x: &Vector3<f64>, inside: &Vector3<f64>) -> f64 {
    let (mut nearest, mut distance) = (*inside, 0.0f64);
    for _ in 0..HULL_STEPS {
        let Some(direction) = (x - nearest).try_normalize(0.0) else { break };
        let point = support(shapes, &direction);
        distance = distance.max(direction.dot(&(x - point)));
        // Nearest point to x on the segment from `nearest` to `point`.
        let segment = point - nearest;
        let Some(part) = Some(segment.norm_squared()).filter(|length| *length > 0.0) else { break };
        nearest += segment * (segment.dot(&(x - nearest)) / part).clamp(0.0, 1.0);
    }
    distance
}
