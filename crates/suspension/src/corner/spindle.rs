//! Spindle, including the axle's inertia, and wheel.

use super::drawing::WheelCircle;
use super::frames;
use super::{Body, Corner, GROUND};
use crate::Wheel;
use crate::findings::{Findings, Spot};
use crate::limits::{MAX_WHEEL_MASS, MOMENT_TOLERANCE, WHEEL_RADII};
use percuss_mechanism::{ContactKind, ContactNormal, JointKind, Problem};
use percuss_spatial::{Matrix3, Vector3, rotation_about};
use percuss_units::LengthUnit;

/// Spindle, including the axle's inertia, and wheel.
pub(crate) struct Spindle {
    /// Body with the inertia of the axle.
    body: Body,
    centre: Vector3<f64>,
    /// Spin axis, a unit vector.
    axis: Vector3<f64>,
    /// Inertia of the axle about the spin axis, included in `body`, kg·m².
    axle_inertia: f64,
    /// Wheel, and the axes of its inertia.
    wheel: Option<(Wheel, Matrix3<f64>)>,
}

/// Warns if the spindle without the axle violates the triangle inequality; with the axle, the violation is normal.
fn check_moments(findings: &mut Findings, body: &Body) {
    let mut principal: [f64; 3] = body.about_com.diagonal().into();
    principal.sort_by(f64::total_cmp);
    let [a, b, c] = principal;
    if c > (a + b) * (1.0 + MOMENT_TOLERANCE) {
        let problem = Problem::TriangleInequality { principal };
        findings.add(problem.severity(), problem.code(), &body.spot, problem.to_string());
    }
}

impl Spindle {
    /// Creates a spindle. The inertia of `body` is in the spindle's axes, about the centre of mass; camber and toe in
    /// rad.
    pub fn new(
        findings: &mut Findings,
        mut body: Body,
        centre: Vector3<f64>,
        [camber, toe]: [f64; 2],
        axle_inertia: f64,
        wheel: Option<Wheel>,
    ) -> Self {
        let frame = rotation_about(&Vector3::z(), -toe) * rotation_about(&Vector3::x(), -camber);
        check_moments(findings, &body);
        body.about_com[(1, 1)] += axle_inertia;
        body.about_com = frames::rotate_inertia(&frame, &body.about_com);
        // Adding 0 turns −0 into 0.
        let axis = frame.column(1).map(|x| x + 0.0);
        Spindle { body, centre, axis, axle_inertia, wheel: wheel.map(|w| (w, frame)) }
    }

    /// Adds the spindle and the wheel to the parent link.
    pub fn attach(&self, findings: &mut Findings, corner: &mut Corner, parent: &str) {
        let at = self.centre;
        let with_axle = match self.axle_inertia {
            0.0 => String::new(),
            axle => format!(", with the axle's {axle} kg·m² about the spin axis in its inertia"),
        };
        let comment = format!("Spindle{with_axle}: frame at its centre");
        corner.add_link("spindle", at, Some(&self.body), comment);
        let spot = &self.body.spot;
        corner.add_joint(
            ("spin", JointKind::Continuous),
            [parent, "spindle"],
            self.axis,
            spot,
            "the wheel's bearing",
        );
        corner.add_frame("wheel_centre", "spindle", at, "the wheel's centre");
        let radius = self.wheel.and_then(|(wheel, _)| wheel.radius);
        corner.drawing.wheels.push(WheelCircle { centre: at.into(), axis: self.axis.into(), radius });
        let Some((wheel, frame)) = &self.wheel else { return };
        let about_com = frames::rotate_inertia(frame, &Matrix3::from_diagonal(&wheel.inertia.into()));
        let body =
            Body { mass: wheel.mass, com: at, about_com, spot: Spot::default(), com_spot: Spot::default() };
        corner.add_link("wheel", at, Some(&body), "the wheel, as given on import");
        let joint = ("wheel_fixed", JointKind::Fixed);
        corner.add_joint(joint, ["spindle", "wheel"], Vector3::x(), spot, "the wheel's bolts");
        if wheel.mass > MAX_WHEEL_MASS {
            let message =
                format!("the wheel's mass is {} kg; no wheel is so heavy: check its unit", wheel.mass);
            findings.warning("implausible-wheel", spot, message);
        }
        let Some(radius) = wheel.radius else { return };
        if !WHEEL_RADII.contains(&radius) {
            let message = format!(
                "the wheel's radius is {:.1} mm ({:.2} in); no vehicle has such a wheel: check its unit",
                1e3 * radius,
                LengthUnit::Inch.of_metres(radius)
            );
            findings.warning("implausible-wheel", spot, message);
        }
        // Lowest direction in the plane of the wheel.
        let down = frames::unit(self.axis * self.axis.z - Vector3::z());
        let defect = "the spin axis is vertical: the wheel has no lowest point";
        let down = findings.unwrap_geometry(down, spot, defect);
        let comment = "the wheel's lowest point; it turns with the wheel";
        corner.add_frame("contact_patch", "spindle", at + down * radius, comment);
        let normal = ContactNormal::Fixed(Vector3::new(0.0, 0.0, -1.0));
        corner.add_contact(("contact_patch", ContactKind::Patch), ["contact_patch", GROUND], normal, None);
    }
}
