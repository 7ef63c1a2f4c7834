//! Parts that a sheet describes apart from points and bodies: the axis of a rocker, a torsion bar, the half shaft, the ratio of the rack.

use crate::findings::Spot;
use crate::forces::TorsionBar;
use crate::limits::TORSION_RATES;
use crate::options::Side;
use crate::sheet::catalogue::{HALF_SHAFT, ROCKER_AXIS, TORSION_BAR, suggestion};
use crate::sheet::entries::Quantity;
use crate::sheet::read::SheetReader;
use crate::sheet::template::Template;
use crate::units::Frame;
use percuss_formats::reading::quoted;
use percuss_spatial::Vector3;
use std::collections::BTreeMap;

/// Distance (m) of the two points of such an axis; it has no influence.
const ROCKER_AXIS_LENGTH: f64 = 0.05;
/// Shortest product (m²) of two arms of a rocker that determine its plane, and shortest direction.
const SHORTEST_AXIS: f64 = 1e-9;

impl SheetReader<'_> {
    /// Adds two points of the axis of a rocker through its pivot (m, left side): along the key `rocker.axis`, or normal to the plane of the
    /// pivot, the end of the pushrod and the end of the damper or spring on the rocker.
    pub fn rocker_axis(
        &mut self,
        pivot: Vector3<f64>,
        spot: &Spot,
        frame: Frame,
        points_side: Side,
        points: &mut BTreeMap<&'static str, (Vector3<f64>, Spot)>,
    ) {
        let stated = self.entries.direction(self.findings, ROCKER_AXIS, frame, points_side);
        let arm = |key: &str| points.get(key).map(|(at, _)| at - pivot);
        let plane = arm("pushrod_rocker").zip(arm("damper_seat").or_else(|| arm("spring_seat")));
        let (axis, of) = match stated {
            Some((axis, _)) => (axis, "along rocker.axis"),
            None => (
                plane.map_or_else(Vector3::zeros, |(a, b)| a.cross(&b)),
                "normal to the plane of the rocker's points",
            ),
        };
        if points.contains_key("rocker_front") || points.contains_key("rocker_back") {
            let message = "rocker_pivot is given with rocker_front or rocker_back: give the pivot, or both points of the axis";
            return self.findings.error("conflict", spot, message.to_owned());
        }
        let Some(axis) = axis.try_normalize(SHORTEST_AXIS) else {
            let message = "the axis of the rocker is not determined: its points are on one line; give rocker.axis = [x, y, z]";
            return self.findings.error("degenerate-geometry", spot, message.to_owned());
        };
        // The second point lies behind the first one.
        let axis = if axis.x > 0.0 { -axis } else { axis };
        let message = format!("the axis of the rocker is {of}, through rocker_pivot");
        self.findings.note("rocker-axis", spot, message);
        points.insert("rocker_front", (pivot, spot.clone()));
        points.insert("rocker_back", (pivot + axis * ROCKER_AXIS_LENGTH, spot.clone()));
    }

    /// Mass of the half shaft (kg), and its joint on the wheel's side (m, left side), if stated.
    pub fn half_shaft(&mut self, frame: Frame, points_side: Side) -> Option<(f64, Option<Vector3<f64>>)> {
        let outer =
            self.entries.point(self.findings, &format!("{HALF_SHAFT}.outer"), frame).map(|(mut at, _)| {
                if points_side == Side::Right {
                    at.y = 0.0 - at.y;
                }
                at
            });
        let (mass, spot) = self.scalar(&format!("{HALF_SHAFT}.mass"), Quantity::Mass)?;
        if mass < 0.0 {
            self.findings.error("bad-mass", &spot, format!("{mass} kg; a mass of at least 0 is expected"));
        }
        Some((mass, outer))
    }

    /// Torsion bar on the hinge of a link.
    pub fn torsion_bar(&mut self, template: &'static Template) -> Option<TorsionBar> {
        let [on, rate, preload] = ["on", "rate", "preload"].map(|key| format!("{TORSION_BAR}.{key}"));
        let place = self.entries.spot_in(&format!("{TORSION_BAR}."))?;
        let links: Vec<&str> = template.hinged_links().collect();
        let given = self.entries.text(self.findings, &on, "the name of a link on a hinge on the chassis");
        let is_stated = self.entries.has(&on);
        let (link, spot) = match (given, &links[..]) {
            (Some(given), _) => given,
            (None, [only]) if !is_stated => ((*only).to_owned(), place.clone()),
            _ => {
                if !is_stated {
                    self.entries.missing(self.findings, &on, &format!("one of {}", links.join(", ")));
                }
                (links.first()?.to_string(), place.clone())
            }
        };
        if !links.contains(&link.as_str()) {
            let near = suggestion(&link, links.iter().copied());
            let message = format!(
                "{} is no link on a hinge on the chassis{near} (these are: {})",
                quoted(&link),
                links.join(", ")
            );
            self.findings.error("unknown-link", &spot, message);
        }
        let moment = self.scalar(&preload, Quantity::Moment).map(|(moment, _)| moment);
        let Some((stiffness, spot)) = self.scalar(&rate, Quantity::RotationalStiffness) else {
            if !self.entries.has(&rate) {
                self.entries.missing(self.findings, &rate, "a torsional rate, such as \"60 N·m/deg\",");
            }
            return None;
        };
        if stiffness <= 0.0 {
            let message = format!("{stiffness} N·m/rad; a rate above 0 is expected");
            self.findings.error("bad-rate", &spot, message);
        } else if !TORSION_RATES.contains(&stiffness) {
            let message = format!(
                "{}; a rate from {} to {} N·m/rad is usual for a torsion bar: check its unit",
                self.entries.given(&rate),
                TORSION_RATES.start(),
                TORSION_RATES.end()
            );
            self.findings.warning("implausible-force", &spot, message);
        }
        Some(TorsionBar { link, rate: stiffness, preload: moment })
    }

    /// Travel of the rack per turn of the steering wheel, m.
    pub fn rack_travel(&mut self, frame: Frame) -> Option<f64> {
        let (travel, spot) = self.scalar("rack.travel_per_turn", Quantity::Length(frame.unit))?;
        if travel <= 0.0 {
            let message = format!("{travel} m; a length above 0 is expected");
            self.findings.error("bad-travel", &spot, message);
        }
        Some(travel)
    }
}
