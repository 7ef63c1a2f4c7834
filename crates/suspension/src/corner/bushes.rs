//! Adds the bushes of a design to a corner.

use super::CHASSIS;
use super::build::CornerBuilder;
use super::design::{GivenBush, Part};
use super::frames;
use percuss_mechanism::BushDescription;
use percuss_spatial::{Matrix3, Transform, Vector3};

/// Rotations about x, y and z that a hinge about z holds.
const HINGE: [bool; 3] = [true, true, false];
/// Rotations that a universal joint with pins along x and y holds.
const UNIVERSAL: [bool; 3] = [false, false, true];
/// Rotations that a ball joint holds.
const BALL: [bool; 3] = [false; 3];

/// Joint whose place a bush takes.
struct Place<'a> {
    name: &'a str,
    links: [&'a str; 2],
    replaces: Vec<String>,
    at: Vector3<f64>,
    held_rotations: [bool; 3],
    /// Axes of the joint; z is the axis of a bush without an own axis. `None` if the joint has no axis.
    axes: Option<Matrix3<f64>>,
}

/// Points at which a part joins two links, in whose place a sheet may state a bush.
pub(crate) fn bush_points(part: &Part) -> Vec<&str> {
    match part {
        Part::Hinge { points, .. } => points.iter().map(String::as_str).collect(),
        Part::Ball { at, .. } | Part::Close { at, .. } => vec![at],
        Part::Rod { ends, .. } => ends.iter().map(|(_, point)| point.as_str()).collect(),
        Part::Strut { line: [_, top], .. } => vec![top],
        Part::Swivel { .. }
        | Part::Free { .. }
        | Part::Axle
        | Part::GuidedAxle { .. }
        | Part::Fixed { .. }
        | Part::Wheel { .. }
        | Part::Slide { .. } => Vec::new(),
    }
}

impl CornerBuilder<'_> {
    /// Adds the bushes in place of the joints of a part, which has been added.
    pub(super) fn add_bushes(&mut self, part: &Part) {
        let bush = |key: &str| self.design.bushes.get(key).cloned();
        match part {
            Part::Hinge { link, parent, points, .. } => {
                let hinge = format!("{link}_hinge");
                let axes = self.corner.joint_axis(&hinge).and_then(any_axes);
                let ends = [link.as_str(), parent];
                let place = |name, at| Place {
                    name,
                    links: ends,
                    replaces: vec![hinge.clone()],
                    at,
                    held_rotations: HINGE,
                    axes,
                };
                if let Some(given) = bush(link) {
                    let middle = (self.point(&points[0]) + self.point(&points[1])) / 2.0;
                    self.add_bush(&given, place(link, middle));
                } else if points.iter().any(|point| bush(point).is_some()) {
                    for point in points {
                        // The end of the hinge without a bush is a ball joint.
                        let given = bush(point).unwrap_or_else(GivenBush::ball_joint);
                        self.add_bush(&given, place(point, self.point(point)));
                    }
                }
            }
            Part::Ball { link, joint, parent, at, .. } => {
                self.add_bush_at_ball(at, [link, parent], joint, at);
            }
            Part::Close { joint, links: [predecessor, successor], at } => {
                self.add_bush_at_ball(at, [successor, predecessor], joint, at);
            }
            Part::Rod { link, ends: [(from, a), (to, b)], .. } if self.corner.has_link(link) => {
                let (from, to) = (self.resolve_link(from).to_owned(), self.resolve_link(to).to_owned());
                self.add_bush_at_universal(a, link, &from);
                self.add_bush_at_ball(b, [link, &to], &format!("{link}_ball"), link);
            }
            Part::Strut { link, line: [_, top], .. } => self.add_bush_at_universal(top, link, CHASSIS),
            Part::Rod { .. }
            | Part::Swivel { .. }
            | Part::Free { .. }
            | Part::Axle
            | Part::GuidedAxle { .. }
            | Part::Fixed { .. }
            | Part::Wheel { .. }
            | Part::Slide { .. } => {}
        }
    }

    /// Adds the bush at a point, or that of the link `other_key`, in place of a ball joint.
    fn add_bush_at_ball(&mut self, point: &str, links: [&str; 2], joint: &str, other_key: &str) {
        let bushes = &self.design.bushes;
        let Some(given) = bushes.get(point).or_else(|| bushes.get(other_key)).cloned() else { return };
        let replaces = vec![joint.to_owned()];
        let at = self.point(point);
        self.add_bush(&given, Place { name: point, links, replaces, at, held_rotations: BALL, axes: None });
    }

    /// Adds the bush at a point, or that of the link, in place of the universal joint of a rod or strut.
    fn add_bush_at_universal(&mut self, point: &str, link: &str, parent: &str) {
        let bushes = &self.design.bushes;
        let Some(given) = bushes.get(point).or_else(|| bushes.get(link)).cloned() else { return };
        let pins = ["first", "second"].map(|pin| format!("{link}_{pin}_pin"));
        let [first, second] = pins.each_ref().map(|pin| self.corner.joint_axis(pin));
        let axes = first.zip(second).and_then(|(x, y)| frames::along_z(frames::normal(x, y)?, y));
        let at = self.point(point);
        let (links, replaces) = ([link, parent], pins.to_vec());
        self.add_bush(&given, Place { name: point, links, replaces, at, held_rotations: UNIVERSAL, axes });
    }

    /// Adds a bush in place of a joint.
    fn add_bush(&mut self, given: &GivenBush, place: Place<'_>) {
        let Place { name, links: [link, against], replaces, at, held_rotations, axes } = place;
        let [has_x, has_z] = given.has_axes();
        let own = given.axis.map(any_axes);
        let axes = match own {
            Some(own) => self.findings.unwrap_geometry(own, &given.spot, "the axis of the bush is zero"),
            None if has_z => axes.unwrap_or_else(|| {
                let message = "the stiffness depends on the direction: the axis of the bush is expected, axis = [x, y, z]";
                self.findings.error("missing-key", &given.spot, message.to_owned());
                Matrix3::identity()
            }),
            None => axes.unwrap_or_else(Matrix3::identity),
        };
        let axes = match given.x_axis {
            Some(x) => {
                let z = axes.column(2).into_owned();
                let own = frames::normal(z, x).and_then(|y| frames::along_z(z, y));
                self.findings.unwrap_geometry(
                    own,
                    &given.spot,
                    "the x_axis of the bush is zero or along its axis",
                )
            }
            None => {
                if has_x {
                    let message = "the values along x and y of the bush differ: its axis x is expected, x_axis = [x, y, z]";
                    self.findings.error("missing-key", &given.spot, message.to_owned());
                }
                axes
            }
        };
        let mut preload = given.own_preload;
        for (first, vector) in [(3, given.preload[0]), (0, given.preload[1])] {
            (0..3).for_each(|i| preload[first + i] += axes.column(i).dot(&vector));
        }
        let (stiffness, damping, rigid) = given.rows(held_rotations);
        let frame = Transform { rotation: axes, translation: at - self.corner.origin(link) };
        self.corner.bushes.push(BushDescription {
            frame,
            stiffness,
            damping,
            loss_factor: given.loss_factor,
            dynamic_factor: given.dynamic_factor,
            preload,
            rigid,
            replaces,
            ..BushDescription::new(name, link, against)
        });
        self.corner.set_spot_of_bush(name, &given.spot);
    }
}

/// Right-handed axes with z along a direction; `None` for a zero direction.
fn any_axes(along: Vector3<f64>) -> Option<Matrix3<f64>> {
    let y = frames::normal(along, Vector3::x()).or_else(|| frames::normal(along, Vector3::z()))?;
    frames::along_z(along, y)
}
