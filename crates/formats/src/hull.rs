//! Inertias and centres of mass that are impossible inside the shapes of a link.

use crate::meshes::files::MeshFolders;
use crate::meshes::surface::bounding_box;
use crate::shape::{Purpose, Shape, Solid};
use nalgebra::Vector3;
use percuss_mechanism::{Accept, Built, Inertial, Mechanism, MechanismBuilder, Problem, Subject};

/// Factor on the largest half trace, dimensionless: shapes for collisions are simplified, and may be 1.4 times too small.
const HULL_SLACK: f64 = 2.0;

/// Distance of a centre of mass outside the shapes, relative to their size, for the same reason.
const COM_SLACK: f64 = 0.5;

/// Same distance for the box of a mesh, which may show the cover of a link without its motor.
const MESH_COM_SLACK: f64 = 1.0;

/// Number of steps of the search for a separating plane; each brings the point of the hull nearer to the centre of mass.
const HULL_STEPS: usize = 100;

/// Mechanism of a builder, `None` after an error, and all findings. They include implausible inertias, and inertias and centres of mass
/// that are impossible inside the convex hull of some shapes of a link: with the centre of mass c, tr(I)/2 = ∫ |x − c|² dm ≤ m·max |x − c|²,
/// and c is in the hull. `shapes`: shapes of every link. `hull_of`: the shapes of the hull of a link; without shapes, or with a mesh among
/// them, the link is left out.
pub(crate) fn build_with_shapes<'s>(
    builder: MechanismBuilder,
    accept: Accept,
    shapes: &'s [Vec<Shape>],
    hull_of: impl Fn(usize, &'s [Shape]) -> Vec<&'s Shape>,
) -> (Option<Mechanism>, Vec<(Subject, Problem)>) {
    match builder.accept(accept).build() {
        Ok(Built { mechanism, mut findings }) => {
            findings.extend(mechanism.implausible_inertias(accept));
            findings.extend(beyond_hulls(&mechanism, shapes, hull_of, COM_SLACK));
            (Some(mechanism), findings)
        }
        Err(error) => (None, error.findings),
    }
}

/// Warnings for links whose inertia or centre of mass is impossible inside the hull. `com_slack`: accepted distance of the centre of mass
/// outside the hull, relative to its size.
fn beyond_hulls<'s>(
    mechanism: &Mechanism,
    shapes: &'s [Vec<Shape>],
    hull_of: impl Fn(usize, &'s [Shape]) -> Vec<&'s Shape>,
    com_slack: f64,
) -> Vec<(Subject, Problem)> {
    let found = mechanism.links().iter().zip(shapes).enumerate().filter_map(|(index, (link, shapes))| {
        let problem = beyond_hull(link.inertial()?, &hull_of(index, shapes), com_slack)?;
        Some((Subject::Link { index, name: link.name().to_owned() }, problem))
    });
    found.collect()
}

/// Collision shapes; visual shapes if there is none.
pub(crate) fn collision_shapes(shapes: &[Shape]) -> Vec<&Shape> {
    let has = |purpose: &Purpose| shapes.iter().any(|shape| shape.purpose == *purpose);
    let purpose = [Purpose::Collision, Purpose::Visual].into_iter().find(has);
    shapes.iter().filter(|shape| Some(shape.purpose) == purpose).collect()
}

/// Warnings of the same kind for links with meshes among their collision shapes; the hull is the bounding box of all shapes. Reads meshes of
/// at most `max_size` bytes in total, and leaves out links with further or unreadable meshes.
pub fn inertias_beyond_meshes(
    mechanism: &Mechanism,
    shapes: &[Vec<Shape>],
    folders: &MeshFolders,
    mut max_size: u64,
) -> Vec<(Subject, Problem)> {
    let is_mesh = |shape: &&Shape| matches!(shape.solid, Solid::Mesh { .. });
    let boxes = mechanism.links().iter().zip(shapes).map(|(link, shapes)| {
        let has_meshes = link.inertial().is_some() && collision_shapes(shapes).iter().any(is_mesh);
        let read =
            if has_meshes { bounding_box(shapes, folders, &mut max_size).ok().flatten() } else { None };
        Vec::from_iter(read)
    });
    let boxes: Vec<Vec<Shape>> = boxes.collect();
    beyond_hulls(mechanism, &boxes, |_, shapes| shapes.iter().collect(), MESH_COM_SLACK)
}

/// Problem of a link whose inertia no mass in the hull of shapes has.
fn beyond_hull(inertial: &Inertial, hull: &[&Shape], com_slack: f64) -> Option<Problem> {
    let is_unknown =
        |shape: &&Shape| matches!(shape.solid, Solid::Mesh { .. }) || farthest(shape, &inertial.com) == 0.0;
    if inertial.mass <= 0.0 || hull.is_empty() || hull.iter().any(is_unknown) {
        return None;
    }
    let (mass, half_trace) = (inertial.mass, inertial.about_com.trace() / 2.0);
    let bound = mass * largest(hull, &inertial.com).powi(2);
    let middle = hull.iter().map(|shape| shape.frame.translation).sum::<Vector3<f64>>() / hull.len() as f64;
    let size = largest(hull, &middle);
    let distance = distance_from_hull(hull, &inertial.com, &middle);
    if distance > com_slack * size {
        Some(Problem::ComBeyondShape { distance, size })
    } else if half_trace > HULL_SLACK * bound {
        Some(Problem::InertiaBeyondShape { mass, half_trace, bound })
    } else {
        None
    }
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
