//! Drawing of a mechanism at the pose of a result: position, share of m̄ and velocity of each link.

use crate::evaluation::prepared_question::{EvaluatedQuestion, compile, configuration};
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::pose::pose_solver;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::reports::drawing::link_lines::{
    centre_of_mass, characteristic_points, hardpoint_name, link_lines,
};
use crate::reports::drawing::shape_reader::ShapeReader;
use crate::thresholds::{BUMP_PAD, REBOUND_PAD, TOUCH_TOLERANCE};
use percuss_dynamics::{ContactResponse, Gap, PointVelocity, Pose};
use percuss_mechanism::{ContactKind, ContactNormal, JointKind, LinkId, Mechanism, NamedContact};
use percuss_spatial::Vector3;
use percuss_suspension::WheelCircle;

/// Drawing of a link; coordinates in the world frame, m.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnLink {
    /// Name of the link.
    pub name: String,
    /// Share of the effective mass; `None` unless the mass is finite.
    pub share: Option<f64>,
    /// Arm of a suspension: from each bush to the outer point. Otherwise lines from the mean of the link's characteristic points
    /// to each of the points: joints, loop frames, centre of mass, and contact point if the link is in contact. Two points give
    /// one line.
    pub lines: Vec<[[f64; 3]; 2]>,
    /// Centre of mass; `None` without mass.
    pub com: Option<[f64; 3]>,
    /// Triangles of the shapes, world frame, m; empty if the model has no shape or the shape is unreadable.
    pub facets: Vec<[[f64; 3]; 3]>,
    /// Velocity v* of the centre of mass relative to the ground, m/s per unit closing speed; `None` if not
    /// determined.
    pub velocity: Option<[f64; 3]>,
}

/// Named point of a mechanism: a movable joint or the end of a loop.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnPoint {
    /// Name of a hardpoint of a sheet or of a part, or several names at one position.
    pub name: String,
    /// Position in the world frame, m.
    pub at: [f64; 3],
}

/// Named contact as an element of the drawing: spring, damper, stop or contact patch.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnElement {
    /// Name.
    pub name: String,
    /// Kind.
    pub kind: ContactKind,
    /// Contact point, and the seat on the other side, world frame, m. If the other side is given by a direction only,
    /// the second end is at the distance of the gap along the normal.
    pub ends: [[f64; 3]; 2],
    /// Unit normal out of the contact link, world axes.
    pub normal: [f64; 3],
    /// Gap at this pose, m; 0 at the touch, `None` if the parts always touch.
    pub gap: Option<f64>,
}

/// Drawing of a mechanism at the pose of a result, and findings about the shapes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnMechanism {
    /// Links with lines, triangles or a mass.
    pub links: Vec<DrawnLink>,
    /// Wheels of an imported suspension, world frame, m.
    pub wheels: Vec<WheelCircle>,
    /// Named points: movable joints, then ends of loops.
    pub points: Vec<DrawnPoint>,
    /// Named contacts.
    pub elements: Vec<DrawnElement>,
    /// Mesh files.
    pub meshes: Vec<Input>,
    /// Shapes that are not drawn, with the reason.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Drawing of an evaluated question: every link with lines, triangles or a mass.
pub(crate) fn draw_evaluated(evaluated: &EvaluatedQuestion) -> DrawnMechanism {
    let EvaluatedQuestion { prepared, pose, result: answer, .. } = evaluated;
    draw_pose(prepared.model, pose, Some(&answer.response))
}

/// Drawing of the mechanism at the pose of a question; the contact is ignored.
///
/// # Errors
/// [`StudyError`]: unknown names, loops that do not close, a travel that is not reachable.
pub fn draw_mechanism(model: &Model, question: &MassQuestion) -> Result<DrawnMechanism, StudyError> {
    let system = compile(&model.mechanism, question, None)?;
    let question = &*question.resolve_contact(&model.mechanism)?;
    let pose = pose_solver::pose(&system, &configuration(&model.mechanism, question)?, question)?;
    Ok(draw_pose(model, &pose, None))
}

/// Drawing of a mechanism at a pose; with a response, also velocities and shares.
fn draw_pose(model: &Model, pose: &Pose, response: Option<&ContactResponse>) -> DrawnMechanism {
    let mechanism = &model.mechanism;
    let shares = response.and_then(|response| response.contributions.as_ref());
    let mut points = characteristic_points(mechanism);
    if let Some(contact) = response.map(|response| &response.contact) {
        for link in [Some(contact.link), contact.against].into_iter().flatten() {
            points[link.index()].push(pose.link(link).inverse_point(&contact.point_world));
        }
    }
    let of_link = |id: LinkId| {
        let link = mechanism.link(id);
        let (com, frame) = (centre_of_mass(mechanism, id), pose.link(id));
        let lines = link_lines(model, id, &points[id.index()]);
        let velocity = response.zip(com).and_then(|(response, com)| {
            match pose.point_velocity_over_ground(response, id, &com)? {
                PointVelocity::Known(v) => Some(pose.base().vector(&v).into()),
                PointVelocity::Undetermined => None,
            }
        });
        DrawnLink {
            name: link.name().to_owned(),
            share: shares.and_then(|s| s.links.get(id.index()).copied()),
            lines: lines.iter().map(|line| line.map(|end| frame.point(&end).into())).collect(),
            facets: Vec::new(),
            com: com.map(|com| frame.point(&com).into()),
            velocity,
        }
    };
    // A fixed root link is the ground.
    let share = |id: &LinkId| shares.and_then(|shares| shares.links.get(id.index()));
    let is_drawn = |id: &LinkId| *id != mechanism.root() || share(id).is_some_and(|share| *share > 0.0);
    let mut shapes = ShapeReader::new(model);
    let mut drawing = DrawnMechanism {
        wheels: mechanism.link_ids().filter_map(|id| wheel(mechanism, pose, id)).collect(),
        points: named_points(model, pose),
        elements: mechanism
            .contacts()
            .iter()
            .filter_map(|contact| element(mechanism, pose, contact))
            .collect(),
        ..DrawnMechanism::default()
    };
    for id in mechanism.link_ids() {
        let frame = pose.link(id);
        let in_world = |corner: [f64; 3]| frame.point(&corner.into()).into();
        let facets: Vec<_> =
            shapes.link_triangles(id).into_iter().map(|corners| corners.map(in_world)).collect();
        let mut link = of_link(id);
        let is_drawn = is_drawn(&id);
        if !is_drawn {
            link.lines.clear();
        }
        // A wheel has a mass and neither lines nor shapes.
        if !(link.lines.is_empty() && facets.is_empty()) || is_drawn && link.com.is_some() {
            drawing.links.push(DrawnLink { facets, ..link });
        }
    }
    (drawing.meshes, drawing.diagnostics) = (shapes.meshes, shapes.diagnostics);
    drawing
}

/// Movable joints and ends of loops, by the name of the hardpoint of a sheet at the place, if any. A loop with both ends at one point is
/// one point.
fn named_points(model: &Model, pose: &Pose) -> Vec<DrawnPoint> {
    let mechanism = &*model.mechanism;
    let moves = |joint: &&percuss_mechanism::Joint| !matches!(joint.kind(), JointKind::Fixed);
    let joints = mechanism.joints().iter().filter(moves).map(|joint| {
        let (parent, origin) = (joint.parent(), joint.origin().point(&Vector3::zeros()));
        let hardpoint = hardpoint_name(model, joint.name(), parent, &origin);
        DrawnPoint {
            name: hardpoint.unwrap_or_else(|| joint.name().to_owned()),
            at: pose.link(parent).point(&origin).into(),
        }
    });
    let of_loop = |closure: &percuss_mechanism::Closure| {
        let ends = [closure.predecessor(), closure.successor()];
        let at = |end: &percuss_mechanism::LoopFrame| {
            let point = end.frame.point(&Vector3::zeros());
            let hardpoint = hardpoint_name(model, closure.name(), end.link?, &point);
            Some((mechanism.link(end.link?).name(), pose.link(end.link?).point(&point), hardpoint))
        };
        let ends: Vec<(&str, Vector3<f64>, Option<String>)> = ends.into_iter().filter_map(at).collect();
        let is_one = match ends[..] {
            [(_, a, _), (_, b, _)] => (a - b).norm() <= TOUCH_TOLERANCE * mechanism.characteristic_length(),
            _ => true,
        };
        // The ends of a sliding closure are two points; if both have the same name, the names of their links distinguish them.
        let name = |link: &str, hardpoint: &Option<String>| {
            let name = hardpoint.as_deref().unwrap_or(closure.name());
            let is_shared = ends.iter().filter(|(_, _, other)| other == hardpoint).count() > 1;
            if is_one || !is_shared { name.to_owned() } else { format!("{name} on {link}") }
        };
        let points = ends
            .iter()
            .map(|(link, at, hardpoint)| DrawnPoint { name: name(link, hardpoint), at: (*at).into() });
        points.take(if is_one { 1 } else { 2 }).collect::<Vec<_>>()
    };
    let all = joints.chain(mechanism.closures().iter().flat_map(of_loop));
    merge_points(all, TOUCH_TOLERANCE * mechanism.characteristic_length())
}

/// Merges points at one position, such as both pins of a universal joint, into one point with both names.
fn merge_points(points: impl Iterator<Item = DrawnPoint>, tolerance: f64) -> Vec<DrawnPoint> {
    let mut merged: Vec<DrawnPoint> = Vec::new();
    for point in points {
        let at = Vector3::from(point.at);
        match merged.iter_mut().find(|other| (Vector3::from(other.at) - at).norm() <= tolerance) {
            Some(other) if other.name == point.name => {}
            Some(other) => {
                // The prefix up to the last underscore that both names share is written once.
                let shared = other.name.bytes().zip(point.name.bytes()).take_while(|(a, b)| a == b).count();
                let start =
                    point.name.bytes().take(shared).rposition(|byte| byte == b'_').map_or(0, |i| i + 1);
                other.name += &format!(", {}", &point.name[start..]);
            }
            None => merged.push(point),
        }
    }
    merged
}

/// Drawing element of a stop on the rod of a damper with the ends `ends` (contact point first). The pad is at a fixed fraction of the
/// length; the face is at the distance `gap` (m) from the pad. `None` if the ends coincide.
fn stop_on_rod(
    name: &str,
    normal: &ContactNormal,
    ends: [Vector3<f64>; 2],
    gap: f64,
) -> Option<DrawnElement> {
    let along = (ends[1] - ends[0]).try_normalize(0.0)?;
    let (part, normal) = match normal {
        ContactNormal::Away(_) => (REBOUND_PAD, -along),
        ContactNormal::Toward(_) | ContactNormal::Fixed(_) => (BUMP_PAD, along),
    };
    let pad = ends[0] + part * (ends[1] - ends[0]);
    Some(DrawnElement {
        name: name.to_owned(),
        kind: ContactKind::Stop,
        ends: [pad.into(), (pad + normal * gap).into()],
        normal: normal.into(),
        gap: Some(gap),
    })
}

/// Element of a named contact; `None` if its ends coincide and it has no direction.
fn element(mechanism: &Mechanism, pose: &Pose, contact: &NamedContact) -> Option<DrawnElement> {
    let other = pose.link(contact.against().unwrap_or(mechanism.root()));
    let point = pose.link(contact.link()).point(contact.point());
    let gap = Gap::new(pose, contact).map(|gap| gap.at(pose));
    let is_stop = contact.kind() == ContactKind::Stop;
    let (end, normal) = match contact.normal() {
        ContactNormal::Toward(seat) | ContactNormal::Away(seat) if is_stop => {
            return stop_on_rod(
                contact.name(),
                contact.normal(),
                [point, other.point(seat)],
                gap.unwrap_or_default(),
            );
        }
        ContactNormal::Fixed(direction) => {
            let normal = other.vector(direction);
            (point + normal * gap.unwrap_or_default(), normal)
        }
        ContactNormal::Toward(seat) => {
            let seat = other.point(seat);
            (seat, seat - point)
        }
        ContactNormal::Away(seat) => {
            let seat = other.point(seat);
            (seat, point - seat)
        }
    };
    let normal = normal.try_normalize(0.0)?;
    Some(DrawnElement {
        name: contact.name().to_owned(),
        kind: contact.kind(),
        ends: [point.into(), end.into()],
        normal: normal.into(),
        gap,
    })
}

/// Circle of a wheel, if the link has the name that the suspension importer gives to wheels. The circle lies
/// about the bearing axis and passes through the lowest point at the design position.
fn wheel(mechanism: &Mechanism, pose: &Pose, link: LinkId) -> Option<WheelCircle> {
    let side = mechanism.link(link).name().strip_prefix("wheel_centre")?;
    let patch = mechanism.find_link(&format!("contact_patch{side}")).ok()?;
    let bearing = mechanism.joint(mechanism.find_joint(&format!("spin{side}")).ok()?);
    let at = |link: LinkId| pose.link(link).point(&Vector3::zeros());
    let axis = pose.link(bearing.child()).vector(bearing.axis());
    let spoke = at(patch) - at(link);
    let radius = (spoke - axis * axis.dot(&spoke)).norm();
    let is_one = radius > 0.0 && radius.is_finite();
    is_one.then(|| WheelCircle { centre: at(link).into(), axis: axis.into(), radius: Some(radius) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_at_one_position_have_both_names() {
        let point = |name: &str, x: f64| DrawnPoint { name: name.into(), at: [x, 0.0, 0.0] };
        let all = [
            point("rod_first_pin", 0.0),
            point("é_a", 1.0),
            point("rod_second_pin", 1e-15),
            point("ü_a", 1.0),
        ];
        let merged = merge_points(all.into_iter(), 1e-9);
        let names: Vec<&str> = merged.iter().map(|point| point.name.as_str()).collect();
        assert_eq!(names, ["rod_first_pin, second_pin", "é_a, ü_a"]);
    }

    #[test]
    fn stops_on_a_rod_are_drawn_between_its_ends() {
        let end = Vector3::new(0.0, 0.0, 0.4);
        for (normal, part, sign) in [
            (ContactNormal::Toward(Vector3::zeros()), BUMP_PAD, 1.0),
            (ContactNormal::Away(Vector3::zeros()), REBOUND_PAD, -1.0),
        ] {
            let drawn = stop_on_rod("stop", &normal, [Vector3::zeros(), end], 0.03).expect("a stop");
            assert_eq!(drawn.ends[0], [0.0, 0.0, part * 0.4]);
            assert_eq!(drawn.ends[1], [0.0, 0.0, part * 0.4 + sign * 0.03]);
            assert_eq!((drawn.normal, drawn.gap), ([0.0, 0.0, sign], Some(0.03)));
        }
        let normal = ContactNormal::Toward(Vector3::zeros());
        assert_eq!(stop_on_rod("stop", &normal, [end, end], 0.03), None);
    }
}
