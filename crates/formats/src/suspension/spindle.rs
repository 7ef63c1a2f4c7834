//! The spindle with the axle on it, and the wheel.

use super::corner::{Body, Corner};
use super::parts::{Inertias, Stated, body, close, spanned};
use super::reader::{Reader, Section, Spot};
use super::{ImportOptions, Wheel, frames};
use crate::limits::MOMENT_SLACK;
use percuss_mechanism::{JointKind, Problem};
use percuss_spatial::{Matrix3, Vector3, rotation_about};

/// The spindle with the axle's inertia in it, and the wheel.
pub(super) struct Spindle {
    body: Body,
    axis: Vector3<f64>,
    axle: f64,
    wheel: Option<(Wheel, Matrix3<f64>)>,
}

/// Reads `Spindle`, `Axle`, camber and toe of the left side.
///
/// The spindle's axes are R_z(−toe) R_x(−camber); it turns about its y. The axle is a shaft that follows the
/// spindle's absolute rotation about that axis, ½ J (ω·a)²: J a aᵀ of inertia, not an armature.
pub(super) fn read<'t>(reader: &mut Reader<'t>, root: &mut Section<'t>, options: &ImportOptions) -> Spindle {
    let camber = reader.number_or_zero(root, "Camber Angle (deg)", "an angle in degrees").to_radians();
    let toe = reader.number_or_zero(root, "Toe Angle (deg)", "an angle in degrees").to_radians();
    let frame = rotation_about(&Vector3::z(), -toe) * rotation_about(&Vector3::x(), -camber);
    let mut section = reader.section(root, "Spindle");
    let mut stated = body(reader, &mut section, Inertias::Moments);
    close(reader, section);
    let mut section = reader.section(root, "Axle");
    let axle = reader.number(&mut section, "Inertia", "an inertia in kg·m²");
    if axle < 0.0 {
        reader.error(
            "negative-inertia",
            &section.spot,
            format!("Inertia is {axle} kg·m²; 0 or more is expected"),
        );
    }
    reader.close(section, &[]);
    check_moments(reader, &stated);
    if stated.com.y <= 0.0 && !reader.has_errors() {
        let message = format!(
            "the spindle is at y = {}: these files describe the left side, which has y > 0; left and right are \
             exchanged",
            stated.com.y
        );
        reader.warning("right-side", &stated.spot, message);
    }
    stated.inertia[(1, 1)] += axle;
    // + 0 makes −0 a plain 0.
    let axis = frame.column(1).map(|x| x + 0.0);
    Spindle { body: stated.in_frame(&frame), axis, axle, wheel: options.wheel.map(|w| (w, frame)) }
}

/// Warns where the spindle alone breaks the triangle inequality: with the axle in it, it nearly always does.
fn check_moments(reader: &mut Reader<'_>, stated: &Stated) {
    let mut principal: [f64; 3] = stated.inertia.diagonal().into();
    principal.sort_by(f64::total_cmp);
    let [a, b, c] = principal;
    if c > (a + b) * (1.0 + MOMENT_SLACK) {
        let problem = Problem::TriangleInequality { principal };
        reader.add(problem.severity(), problem.code(), &stated.spot, problem.to_string());
    }
}

impl Spindle {
    /// Attaches the spindle to its parent link.
    pub fn attach(&self, reader: &mut Reader<'_>, corner: &mut Corner, parent: &str) {
        let at = self.body.com;
        let comment = format!(
            "Spindle, with the axle's {} kg·m² about the axis of spin in its inertia: frame at its centre",
            self.axle
        );
        corner.link("spindle", at, Some(&self.body), comment);
        let spot = &self.body.spot;
        corner.joint(
            ("spin", JointKind::Continuous),
            [parent, "spindle"],
            self.axis,
            spot,
            "the wheel's bearing",
        );
        corner.frame("wheel_centre", "spindle", at, "the wheel's centre");
        let Some((wheel, frame)) = &self.wheel else { return };
        let about_com = frames::turned(frame, &Matrix3::from_diagonal(&wheel.inertia.into()));
        let body = Body { mass: wheel.mass, com: at, about_com, spot: Spot::default() };
        corner.link("wheel", at, Some(&body), "the wheel, as given on import");
        let joint = ("wheel_fixed", JointKind::Fixed);
        corner.joint(joint, ["spindle", "wheel"], Vector3::x(), spot, "the wheel's bolts");
        let Some(radius) = wheel.radius else { return };
        // The lowest direction in the wheel's plane.
        let down = frames::unit(self.axis * self.axis.z - Vector3::z());
        let down = spanned(reader, down, spot, "the axis of spin is vertical: the wheel has no lowest point");
        let comment = "the wheel's lowest point; it turns with the wheel";
        corner.frame("contact_patch", "spindle", at + down * radius, comment);
    }
}
