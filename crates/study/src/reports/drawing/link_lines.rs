//! Lines that stand for the links of a mechanism, in the frames of the links.

use crate::model::loading::Model;
use crate::thresholds::TOUCH_TOLERANCE;
use percuss_mechanism::{LinkId, Mechanism};
use percuss_spatial::Vector3;
use percuss_suspension::Line;
use percuss_suspension::kinematics::SIDES;

/// Characteristic points of every link, m, in its frame: its joints and the ends of loops.
pub(super) fn characteristic_points(mechanism: &Mechanism) -> Vec<Vec<Vector3<f64>>> {
    let mut points: Vec<Vec<Vector3<f64>>> = vec![Vec::new(); mechanism.links().len()];
    for joint in mechanism.joints() {
        // The joint frame coincides with the child's frame.
        points[joint.child().index()].push(Vector3::zeros());
        points[joint.parent().index()].push(joint.origin().translation);
    }
    for closure in mechanism.closures() {
        for end in [closure.predecessor(), closure.successor()] {
            if let Some(link) = end.link {
                points[link.index()].push(end.frame.translation);
            }
        }
    }
    points
}

/// Centre of mass of a link, m, in its frame; `None` without mass.
pub(super) fn centre_of_mass(mechanism: &Mechanism, link: LinkId) -> Option<Vector3<f64>> {
    mechanism.link(link).inertial().filter(|inertial| inertial.mass > 0.0).map(|inertial| inertial.com)
}

/// Lines of a link through its characteristic points, m, in its frame. Arm of a suspension: from each bush to the outer
/// point, with all other points joined to these lines. Other links: from the mean of the points and the centre of mass to
/// each of them; two points give one line.
pub(super) fn link_lines(model: &Model, link: LinkId, points: &[Vector3<f64>]) -> Vec<[Vector3<f64>; 2]> {
    let arms = arm_lines(model, link);
    let mut ends = points.to_vec();
    ends.extend(centre_of_mass(&model.mechanism, link));
    let middle = ends.iter().sum::<Vector3<f64>>() / ends.len().max(1) as f64;
    let mut lines: Vec<[Vector3<f64>; 2]> = match ends[..] {
        _ if !arms.is_empty() => {
            // The centre of mass of an arm is not drawn.
            let joined = points.iter().map(|at| [nearest_point(&arms, at), *at]);
            arms.iter().copied().chain(joined).collect()
        }
        [a, b] => vec![[a, b]],
        _ => ends.iter().map(|end| [middle, *end]).collect(),
    };
    lines.retain(|[a, b]| a != b);
    lines
}

/// Lines of an arm or rod of a sheet, in the frame of its link: from each bush to the outer point. Empty for other links.
fn arm_lines(model: &Model, id: LinkId) -> Vec<[Vector3<f64>; 2]> {
    let Some(sheet) = &model.origin.sheet else { return Vec::new() };
    let mechanism = &model.mechanism;
    let name = mechanism.link(id).name();
    let side = SIDES.into_iter().find(|side| name.ends_with(side));
    let is_of_link = |line: &&Line| {
        let is_left = line.ends.iter().map(|end| end[1]).sum::<f64>() > 0.0;
        line.name == name
            || side.is_some_and(|side| {
                name.strip_suffix(side) == Some(&line.name) && is_left == (side == SIDES[0])
            })
    };
    let lines = sheet.understood.lines.iter().filter(is_of_link);
    lines.map(|line| line.ends.map(|end| design_point_in_link(mechanism, id, end.into()))).collect()
}

/// Point of the world with all joints at 0, in the frame of a link.
pub(super) fn design_point_in_link(mechanism: &Mechanism, link: LinkId, at: Vector3<f64>) -> Vector3<f64> {
    let mut joints = Vec::new();
    let mut above = link;
    while let Some(joint) = mechanism.parent_joint(above) {
        joints.push(joint);
        above = mechanism.joint(joint).parent();
    }
    joints.into_iter().rev().fold(at, |at, joint| mechanism.joint(joint).origin().inverse_point(&at))
}

/// Name of the hardpoint of the sheet at a point of a link (link frame, m) as drawn; `None` for a model without a sheet, and away from
/// the hardpoints. `part`: name of a part at the point; its side is added to the name.
pub(super) fn hardpoint_name(
    model: &Model,
    part: &str,
    link: LinkId,
    point: &Vector3<f64>,
) -> Option<String> {
    let origin = model.origin.sheet.as_deref()?;
    let side = SIDES.into_iter().find(|side| part.ends_with(side)).unwrap_or_default();
    let tolerance = TOUCH_TOLERANCE * model.mechanism.characteristic_length();
    let is_here = |(_, coordinates): &&(String, [f64; 3])| {
        let left = origin.understood.axes.to_iso(Vector3::from(*coordinates));
        [1.0, -1.0].into_iter().any(|mirror| {
            let world = Vector3::new(left.x, mirror * left.y, left.z);
            (design_point_in_link(&model.mechanism, link, world) - point).norm() <= tolerance
        })
    };
    // If several hardpoints are at one point, the name that begins with the first word of the part's name is used.
    let stem = part.split('_').next().unwrap_or(part);
    let here = origin.understood.coordinates.iter().filter(is_here);
    // Points of the other side begin with its word, and the name of the part ends in its side.
    let mut here = here.map(|(name, _)| name.rsplit_once('.').map_or(name.as_str(), |(_, name)| name));
    let first = here.clone().next()?;
    let name = here.find(|name| name.starts_with(stem)).unwrap_or(first);
    Some(format!("{name}{side}"))
}

/// Point of some lines that is nearest to a point.
fn nearest_point(lines: &[[Vector3<f64>; 2]], to: &Vector3<f64>) -> Vector3<f64> {
    let on_line = |[a, b]: &[Vector3<f64>; 2]| {
        let along = b - a;
        let part = (to - a).dot(&along) / along.norm_squared();
        a + along * if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.0 }
    };
    let nearest = lines.iter().map(on_line).min_by(|a, b| (a - to).norm().total_cmp(&(b - to).norm()));
    nearest.unwrap_or(*to)
}
