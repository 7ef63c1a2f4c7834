//! Bodies and spindle in the sections of a file of Chrono::Vehicle.

use super::reader::{Reader, Section};
use super::template::Notation;
use crate::corner::Body;
use crate::corner::frames;
use crate::corner::spindle::Spindle;
use crate::findings::Spot;
use crate::options::ImportOptions;
use crate::units::VehicleAxes;
use percuss_spatial::{Matrix3, Vector3};

/// Keys that affect only the visualisation.
pub(super) const VISUAL_KEYS: [&str; 2] = ["Radius", "Width"];

pub(super) const MASS: &str = "a mass in kg";
const MOMENTS: &str = "three moments in kg·m², [xx, yy, zz],";

/// Body as given in the file: the template defines the axes of the inertia.
pub(super) struct SectionBody {
    pub mass: f64,
    pub com: Vector3<f64>,
    pub inertia: Matrix3<f64>,
    pub spot: Spot,
    /// Vehicle axes of the file.
    pub axes: VehicleAxes,
}

impl SectionBody {
    /// Converts an inertia given in the vehicle's axes.
    pub fn into_vehicle(self) -> Body {
        let about_com = self.axes.inertia_to_iso(self.inertia);
        Body { mass: self.mass, com: self.com, about_com, com_spot: self.spot.clone(), spot: self.spot }
    }

    /// Converts an inertia given in `frame`.
    pub fn in_frame(self, frame: &Matrix3<f64>) -> Body {
        let about_com = frames::rotate_inertia(frame, &self.inertia);
        Body { mass: self.mass, com: self.com, about_com, com_spot: self.spot.clone(), spot: self.spot }
    }
}

/// Reads mass, centre of mass and inertia of a section.
pub(super) fn read_body<'t>(
    reader: &mut Reader<'t>,
    section: &mut Section<'t>,
    notation: Notation,
) -> SectionBody {
    let mass = reader.number(section, "Mass", MASS);
    let com = reader.point(section, "COM");
    let inertia = read_inertia(reader, section, notation);
    SectionBody { mass, com, inertia, spot: section.spot.clone(), axes: reader.frame.axes }
}

/// Reads the inertia of a section.
pub(super) fn read_inertia<'t>(
    reader: &mut Reader<'t>,
    section: &mut Section<'t>,
    notation: Notation,
) -> Matrix3<f64> {
    match notation {
        Notation::Moments => Matrix3::from_diagonal(&reader.triple(section, "Inertia", MOMENTS)),
        Notation::Products => {
            let moments = reader.triple(section, "Moments of Inertia", MOMENTS);
            let expected = "the inertia matrix's entries [xy, xz, yz] in kg·m²";
            let products = reader.triple(section, "Products of Inertia", expected);
            if products != Vector3::zeros() {
                reader.products.get_or_insert_with(|| section.spot.clone());
            }
            let mut matrix = Matrix3::from_diagonal(&moments);
            for (value, (row, column)) in products.iter().zip([(0, 1), (0, 2), (1, 2)]) {
                matrix[(row, column)] = *value;
                matrix[(column, row)] = *value;
            }
            matrix
        }
    }
}

/// Reads `Spindle`, `Axle`, camber and toe of the left side.
///
/// The axes of the spindle are R_z(−toe) R_x(−camber); the spin axis is the y axis. The axle is a shaft that follows
/// the absolute rotation of the spindle about the spin axis, with the energy ½ J (ω·a)².
/// It is therefore an inertia J a aᵀ, not an armature.
pub(in super::super) fn read_spindle<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    options: &ImportOptions,
) -> Spindle {
    let camber = reader.number_or_zero(root, "Camber Angle (deg)", "an angle in degrees").to_radians();
    let toe = reader.number_or_zero(root, "Toe Angle (deg)", "an angle in degrees").to_radians();
    let mut section = reader.section(root, "Spindle");
    let given = read_body(reader, &mut section, Notation::Moments);
    reader.warn_unread_keys(section, &VISUAL_KEYS);
    let mut section = reader.section(root, "Axle");
    let axle = reader.number(&mut section, "Inertia", "an inertia in kg·m²");
    if axle < 0.0 {
        reader.error(
            "negative-inertia",
            &section.spot,
            format!("Inertia is {axle} kg·m²; 0 or more is expected"),
        );
    }
    reader.warn_unread_keys(section, &[]);
    if given.com.y <= 0.0 && !reader.has_errors() {
        let message = format!(
            "the spindle is at y = {}: these files describe the left side, y > 0; left and right are therefore \
             exchanged",
            given.com.y
        );
        reader.warning("right-side", &given.spot, message);
    }
    let body = Body {
        mass: given.mass,
        com: given.com,
        about_com: given.inertia,
        com_spot: given.spot.clone(),
        spot: given.spot,
    };
    let at = body.com;
    Spindle::new(reader, body, at, [camber, toe], axle, options.wheel)
}
