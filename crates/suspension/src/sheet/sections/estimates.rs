//! Estimates of missing masses: the parts of the template's example, scaled to the size of each part.
//!
//! Similar bodies of one density have masses as s³ and moments of inertia as s⁵, with the ratio s of their lengths.

use crate::findings::{Findings, Spot};
use crate::sheet::template::{Template, symmetric_matrix};
use percuss_spatial::{Matrix3, Vector3};
use std::collections::BTreeMap;

/// Mass (kg) and radius (m) of the wheel in the examples, and its inertia, kg·m².
const WHEEL: (f64, f64, [f64; 3]) = (18.5, 0.3, [0.62, 1.05, 0.62]);

/// Estimate of one body, in the axes of ISO 8855, left side.
pub(in crate::sheet) struct Estimate {
    /// Mass, kg.
    pub mass: f64,
    /// Middle of its joints, m.
    pub com: Vector3<f64>,
    /// Inertia about this point, kg·m².
    pub about_com: Matrix3<f64>,
}

/// Masses that are estimated.
#[derive(Default)]
pub(in crate::sheet) struct Estimates {
    list: Vec<String>,
}

impl Estimates {
    /// Estimate of a body; `points`: hardpoints of the left side, m.
    pub fn body(
        template: &Template,
        key: &str,
        points: &BTreeMap<&'static str, (Vector3<f64>, Spot)>,
        radius: Option<f64>,
    ) -> Option<Estimate> {
        let example = &template.bodies.iter().find(|(body, _)| body == key)?.1;
        let names: Vec<&str> = template.parts_with_bar().flat_map(|part| part.points_on(key)).collect();
        let is_central = template.is_central_body(key);
        let joints = |at: &dyn Fn(&str) -> Option<Vector3<f64>>| -> Vec<Vector3<f64>> {
            let mut joints: Vec<Vector3<f64>> = Vec::new();
            for at in names.iter().filter_map(|name| at(name)) {
                let mirrored = Vector3::new(at.x, -at.y, at.z);
                let both = if is_central { vec![at, mirrored] } else { vec![at] };
                both.into_iter().for_each(|at| {
                    if !joints.contains(&at) {
                        joints.push(at)
                    }
                });
            }
            joints
        };
        let own = joints(&|name| points.get(name).map(|(at, _)| *at));
        let of_example = joints(&|name| template.point(name).map(|at| Vector3::from(at) / 1e3));
        let com = middle(&own);
        let height = |at: Option<Vector3<f64>>| at.map_or(WHEEL.1, |at| at.z);
        let centre = points.get("wheel_centre").map(|(at, _)| *at);
        let of_wheel = || {
            let example = height(template.point("wheel_centre").map(|at| Vector3::from(at) / 1e3));
            radius.unwrap_or(example) / example
        };
        let scale = match [size(&own), size(&of_example)] {
            [own, example] if key != "spindle" && own > 0.0 && example > 0.0 => own / example,
            _ => of_wheel(),
        };
        let com = if key == "spindle" { centre? } else { com };
        let about_com = symmetric_matrix(&example.inertia) * scale.powi(5);
        Some(Estimate { mass: example.mass * scale.powi(3), com, about_com })
    }

    /// Mass and inertia of a wheel of this radius, m.
    pub fn wheel(radius: f64) -> (f64, [f64; 3]) {
        let scale = radius / WHEEL.1;
        (WHEEL.0 * scale.powi(3), WHEEL.2.map(|moment| moment * scale.powi(5)))
    }

    /// Notes an estimate for the warning. `is_mass`: the mass is an estimate too.
    pub fn add(&mut self, key: &str, mass: f64, is_mass: bool) {
        let rounded: f64 = format!("{mass:.1e}").parse().unwrap_or(mass);
        self.list.push(if is_mass { format!("{key} {rounded} kg") } else { format!("{key} (its inertia)") });
    }

    /// Warns about the estimates.
    pub fn warn(&self, findings: &mut Findings, spot: &Spot) {
        if !self.list.is_empty() {
            let message = format!(
                "estimates, not data: {}. They are the parts of the template's example, scaled to the size of each part (mass as s³, inertia \
                 as s⁵, centre of mass in the middle of its joints). Every mass that follows is an estimate; replace them by data",
                self.list.join(", ")
            );
            findings.warning("estimated-masses", spot, message);
        }
    }
}

/// Mean of some points.
fn middle(points: &[Vector3<f64>]) -> Vector3<f64> {
    points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64
}

/// Root mean square of the distances of some points from their mean.
fn size(points: &[Vector3<f64>]) -> f64 {
    let middle = middle(points);
    (points.iter().map(|at| (at - middle).norm_squared()).sum::<f64>() / points.len().max(1) as f64).sqrt()
}
