//! Data for the construction of one corner: hardpoints, bodies and the steps that build links, joints and loops.

use super::Body;
use crate::findings::Spot;
use percuss_formats::reading::shortened;
use percuss_spatial::Vector3;
use percuss_units::LengthUnit;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Step in building a mechanism. The link name `SECTION.on` stands for the link chosen in the file. A `comment`
/// describes the link in the model; without it, the comment names the point of the link frame.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub(crate) enum Part {
    /// Link on a hinge through two points; the link frame is at the first. `outer`: end of the arm in the drawing;
    /// without it, the first ball joint, rod or wheel on the link.
    Hinge {
        link: String,
        parent: String,
        points: [String; 2],
        comment: Option<String>,
        outer: Option<String>,
    },
    /// Link on a hinge parallel to an axis of the vehicle: x, or `axis`.
    Swivel { link: String, parent: String, at: String, axis: Option<[f64; 3]> },
    /// Link on a ball joint. `outer`: other end in the drawing of a link on the chassis; without it, the wheel centre.
    Ball {
        link: String,
        joint: String,
        parent: String,
        at: String,
        comment: Option<String>,
        outer: Option<String>,
    },
    /// Link constrained only by its closures.
    Free { link: String, at: String, comment: Option<String>, joint_comment: Option<String> },
    /// Free body of the axle, with its frame half way between the wheels.
    Axle,
    /// Axle that moves forward and upward, yaws and rolls about the point `at` of the vehicle's middle plane, but neither
    /// moves sideways there nor pitches; the link frame is at this point.
    GuidedAxle { at: String },
    /// Link fixed to another.
    Fixed { link: String, on: String, at: String },
    /// Spindle and wheel.
    Wheel { on: String },
    /// Link between two points: a massless rod or a body. An end: link and point.
    Rod {
        link: String,
        ends: [(String, String); 2],
        comment: Option<String>,
        massless_comment: Option<String>,
    },
    /// Strut on a universal joint at the top; slides along its axis.
    Strut {
        link: String,
        on: String,
        line: [String; 2],
        comment: Option<String>,
        #[serde(default)]
        undrawn: bool,
    },
    /// Link that slides along a line, from the first point to the second; the link frame is at the first.
    Slide { link: String, parent: String, line: [String; 2] },
    /// Ball joint that closes a loop.
    Close { joint: String, links: [String; 2], at: String },
}

/// Directions of pins with their positions in the file, by link.
pub(crate) type FirstPins = BTreeMap<&'static str, (Vector3<f64>, Spot)>;

/// Mass and inertia of a link as given in a file.
#[derive(Clone, Debug)]
pub(crate) enum GivenBody {
    /// Complete body, in metres and the axes of ISO 8855.
    Body(Body),
    /// A slender rod of this mass, kg.
    Rod(f64, Spot),
}

/// Data of the left side, and of the parts common to both sides, in metres and the axes of ISO 8855.
#[derive(Clone, Debug, Default)]
pub(crate) struct Design {
    /// Unit of the file's lengths, for messages.
    pub unit: LengthUnit,
    /// Construction steps, parents first.
    pub parts: Vec<&'static Part>,
    /// True if both sides are on one axle.
    pub axle: bool,
    /// Hardpoints with their positions in the file.
    pub points: BTreeMap<&'static str, (Vector3<f64>, Spot)>,
    /// Points that follow from the hardpoints, by name.
    pub derived: &'static [(String, DerivedPoint)],
    /// Bodies by link.
    pub bodies: BTreeMap<&'static str, GivenBody>,
    /// Pins of universal joints by link: fixed in the parent, fixed in the link. Without them, the first pin is
    /// normal to the link and to the vehicle's x axis.
    pub pins: BTreeMap<&'static str, [Vector3<f64>; 2]>,
    /// First pins of universal joints by link, as stated by a sheet; the second pin is normal to this pin and to the link.
    pub first_pins: FirstPins,
    /// Links with spring, damper or bar mounts, by section.
    pub on: BTreeMap<&'static str, (String, Spot)>,
    /// Masses of springs and dampers by section, kg.
    pub part_masses: BTreeMap<&'static str, f64>,
    /// Mass of the half shaft, kg, and its joint on the wheel's side; `None`: the wheel centre.
    pub half_shaft: Option<(f64, Option<Vector3<f64>>)>,
    /// Gap and direction of stops, as given in the file, by section.
    pub stops: BTreeMap<&'static str, Stop>,
    /// Contacts that the file names itself.
    pub contacts: Vec<OwnContact>,
    /// Bushes, by the point or the link whose joints they replace.
    pub bushes: BTreeMap<String, GivenBush>,
    /// True if every rod without mass becomes a massless link on a universal joint instead of a distance closure.
    pub rods_are_links: bool,
    /// True if a massless rod without length is left to the checks of the mechanism.
    pub unchecked_rods: bool,
    /// Comment of each hinge in the model.
    pub hinge_comment: &'static str,
}

/// Point that follows from hardpoints.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, untagged)]
pub(crate) enum DerivedPoint {
    /// Point of a line, at a part of the distance from the first end.
    OnLine { from: String, to: String, part: f64 },
    /// Point of the vehicle's middle plane at the height of a line in side view, above or below another point.
    InMiddlePlane { line: [String; 2], above: String },
}

/// Gap and direction of a stop, as given in the file.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stop {
    /// Gap at the design position, m; without it, the distance of the two points along the normal.
    pub gap: Option<f64>,
    /// Direction from the pad to the stop; without it, the line between the two points.
    pub direction: Option<Vector3<f64>>,
    /// Position in the file.
    pub spot: Spot,
}

/// Contact that a file names itself: a point of a link that moves toward the ground or another link.
#[derive(Clone, Debug)]
pub(crate) struct OwnContact {
    pub name: String,
    /// Link of the point, and the place of its name in the file.
    pub link: (String, Spot),
    /// The point, m.
    pub at: Vector3<f64>,
    /// Direction from the point to the obstacle, of any length.
    pub direction: Vector3<f64>,
    /// Link of the obstacle and the place of its name; `None`: the ground.
    pub against: Option<(String, Spot)>,
    /// Gap at the design position, m; `None` for parts that always touch.
    pub gap: Option<f64>,
    /// Position in the file.
    pub spot: Spot,
}

/// Bush as given in a file.
#[derive(Clone, Debug)]
pub(crate) struct GivenBush {
    pub data: BushData,
    pub loss_factor: f64,
    pub dynamic_factor: f64,
    /// Axis z of the bush, of any length; `None`: the axis of the joint.
    pub axis: Option<Vector3<f64>>,
    /// Direction with the axis x of the bush in its plane with z, of any length; `None`: any.
    pub x_axis: Option<Vector3<f64>>,
    /// Force (N) and moment (N·m) of the bush on its link at the design position, axes of the vehicle.
    pub preload: [Vector3<f64>; 2],
    /// The same in the axes of the bush, rotations first, from a file.
    pub own_preload: [f64; 6],
    pub spot: Spot,
}

/// Stiffness and damping of a bush, SI units.
#[derive(Clone, Debug)]
pub(crate) enum BushData {
    /// Rates in the directions of the bush: conical x and y, torsional, radial x and y, axial.
    Rates { stiffness: [f64; 6], damping: [f64; 6] },
    /// Chrono: stiffness and damping of translations, of the rotations that the joint holds, and of its free rotations.
    ByJoint { linear: [f64; 2], rotational: [f64; 2], free: [f64; 2] },
}

impl GivenBush {
    /// Ball joint without compliance.
    pub fn ball_joint() -> Self {
        let (rigid, free) = (f64::INFINITY, 0.0);
        let stiffness = [free, free, free, rigid, rigid, rigid];
        Self::new(BushData::Rates { stiffness, damping: [0.0; 6] }, Spot::default())
    }

    /// Bush without loss factor, own axes and preload.
    pub fn new(data: BushData, spot: Spot) -> Self {
        Self {
            data,
            loss_factor: 0.0,
            dynamic_factor: 1.0,
            axis: None,
            x_axis: None,
            preload: [Vector3::zeros(); 2],
            own_preload: [0.0; 6],
            spot,
        }
    }

    /// Axes of the bush that have an influence: `[true, true]` for x and z, `[false, true]` for z alone. Values of one axis differ from those of others.
    pub fn has_axes(&self) -> [bool; 2] {
        let BushData::Rates { stiffness, damping } = self.data else { return [false; 2] };
        let differ = |one: usize, other: usize| {
            [stiffness, damping]
                .iter()
                .any(|rows| rows[one] != rows[other] || rows[one + 3] != rows[other + 3])
        };
        let own = |row: usize| self.own_preload[row] != 0.0 || self.own_preload[row + 3] != 0.0;
        let x = differ(0, 1) || own(0) || own(1);
        [x, x || differ(1, 2) || own(2)]
    }

    /// Stiffness, damping and rigid rows of a bush in place of a joint that holds these rotations about x, y and z.
    pub fn rows(&self, held_rotations: [bool; 3]) -> ([f64; 6], [f64; 6], [bool; 6]) {
        match self.data {
            // The two bushes of a hinge hold its conical rotations by their distance; that of a rod's end alone holds its spin.
            BushData::Rates { stiffness, damping } => (
                stiffness,
                damping,
                [false, false, held_rotations[2] && stiffness[2] > 0.0, true, true, true],
            ),
            BushData::ByJoint { linear: [k, c], rotational, free } => {
                let [x, y, z] = held_rotations.map(|is_held| if is_held { rotational } else { free });
                let [held_x, held_y, held_z] = held_rotations;
                let rigid = [held_x, held_y, held_z, true, true, true];
                ([x[0], y[0], z[0], k, k, k], [x[1], y[1], z[1], c, c, c], rigid)
            }
        }
    }
}

/// Value of `on` for a stop on the rod of the damper.
pub(crate) const ON_DAMPER: &str = "damper";

/// Sections of stops.
pub(crate) const STOPS: [&str; 2] = ["bump_stop", "rebound_stop"];

/// Optional pairs of points between two bodies: section, points. A pair is given or left out as a whole.
pub(crate) const SEATS: [(&str, [&str; 2]); 5] = [
    ("spring", ["spring_seat", "spring_chassis_seat"]),
    ("damper", ["damper_seat", "damper_chassis_seat"]),
    // Name of Chrono for a damper.
    ("shock", ["shock_seat", "shock_chassis_seat"]),
    ("bump_stop", ["bump_stop_pad", "bump_stop"]),
    ("rebound_stop", ["rebound_stop_pad", "rebound_stop"]),
];

impl Part {
    /// Points of this step that are on a link.
    pub fn points_on(&self, link: &str) -> Vec<&str> {
        let wheel = "wheel_centre";
        let ends: Vec<[&str; 2]> = match self {
            Part::Hinge { link: own, points: [a, b], .. } | Part::Slide { link: own, line: [a, b], .. } => {
                vec![[own, a], [own, b]]
            }
            Part::Swivel { link: own, parent, at, .. } | Part::Ball { link: own, parent, at, .. } => {
                vec![[own, at], [parent, at]]
            }
            Part::Fixed { link: own, on, at } => vec![[own, at], [on, at]],
            Part::Free { link: own, at, .. } => vec![[own, at]],
            Part::GuidedAxle { at } => vec![["axle", at]],
            Part::Rod { link: own, ends: [(first, a), (second, b)], .. } => {
                vec![[own, a], [own, b], [first, a], [second, b]]
            }
            Part::Strut { link: own, on, line: [bottom, top], .. } => {
                vec![[own, bottom], [own, top], [on, bottom]]
            }
            Part::Close { links: [first, second], at, .. } => vec![[first, at], [second, at]],
            Part::Wheel { on } => vec![[on, wheel]],
            Part::Axle => vec![["axle", wheel]],
        };
        ends.into_iter().filter(|[own, _]| *own == link).map(|[_, point]| point).collect()
    }

    /// Link on a universal joint, and the two points of its line; `None` for any other part.
    pub fn universal_link(&self) -> Option<(&str, [&str; 2])> {
        match self {
            Part::Rod { link, ends: [(_, first), (_, second)], .. } => Some((link, [first, second])),
            Part::Strut { link, line: [bottom, top], .. } => Some((link, [bottom, top])),
            Part::Hinge { .. }
            | Part::Swivel { .. }
            | Part::Ball { .. }
            | Part::Free { .. }
            | Part::Axle
            | Part::GuidedAxle { .. }
            | Part::Fixed { .. }
            | Part::Wheel { .. }
            | Part::Slide { .. }
            | Part::Close { .. } => None,
        }
    }
}

impl Design {
    /// True if rods without mass become massless links on universal joints: on request, or if the suspension has no other
    /// joint with a single position. Without such a joint, no joint would drive the wheel travel.
    pub fn builds_rods_as_links(&self) -> bool {
        let has_pin = |part: &&Part| match part {
            Part::Hinge { .. }
            | Part::Swivel { .. }
            | Part::GuidedAxle { .. }
            | Part::Strut { .. }
            | Part::Slide { .. } => true,
            Part::Rod { link, .. } => self.bodies.contains_key(link.as_str()),
            Part::Ball { .. }
            | Part::Free { .. }
            | Part::Axle
            | Part::Fixed { .. }
            | Part::Wheel { .. }
            | Part::Close { .. } => false,
        };
        // A rod without length is left to the checks of the mechanism as a closure.
        self.rods_are_links || !self.unchecked_rods && !self.parts.iter().any(has_pin)
    }

    /// True if a bush is at one of these points.
    pub fn has_bush(&self, points: [&str; 2]) -> bool {
        points.iter().any(|point| self.bushes.contains_key(*point))
    }

    /// True if a section (spring, damper, stop, drop link, pushrod) names this link in its key `on`.
    pub fn is_holder(&self, link: &str) -> bool {
        self.on.values().any(|(holder, _)| holder == link)
    }

    /// Position of a point; `None` if the file does not contain the point, or a hardpoint from which it follows.
    pub fn point(&self, key: &str) -> Option<Vector3<f64>> {
        if let Some((at, _)) = self.points.get(key) {
            return Some(*at);
        }
        match &self.derived.iter().find(|(name, _)| name == key)?.1 {
            DerivedPoint::OnLine { from, to, part } => {
                let from = self.point(from)?;
                Some(from + *part * (self.point(to)? - from))
            }
            DerivedPoint::InMiddlePlane { line: [first, second], above } => {
                let (first, second, above) = (self.point(first)?, self.point(second)?, self.point(above)?);
                let part = (above.x - first.x) / (second.x - first.x);
                // For a line that is vertical in side view: the height of its middle.
                let part = if part.is_finite() { part } else { 0.5 };
                Some(Vector3::new(above.x, 0.0, first.z + part * (second.z - first.z)))
            }
        }
    }

    /// Place of a point in the file; the key alone if the file does not contain the point.
    pub fn spot(&self, key: &str) -> Spot {
        let derived = self.derived.iter().find(|(name, _)| name == key);
        let key = match derived.map(|(_, point)| point) {
            Some(
                DerivedPoint::OnLine { from: given, .. }
                | DerivedPoint::InMiddlePlane { line: [given, _], .. },
            ) => given,
            None => key,
        };
        self.points
            .get(key)
            .map_or_else(|| Spot { path: Some(shortened(key)), ..Spot::default() }, |(_, spot)| spot.clone())
    }
}

/// Spring between both sides: section, and the point on the moving link; the other end is the mirror image of this point.
pub(crate) const THIRD_SPRING: (&str, &str) = ("third_spring", "third_spring_seat");

/// True if a hardpoint belongs to the axle as a whole, not to one side.
pub(crate) fn is_central(axle: bool, point: &str) -> bool {
    axle && ["middle_link", "panhard", "watt"].iter().any(|start| point.starts_with(start))
}
