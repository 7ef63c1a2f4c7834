//! Wheel of a sheet: mass, radius or size of the tyre, and its centre from the track.

use crate::findings::Spot;
use crate::options::Wheel;
use crate::sheet::entries::Quantity;
use crate::sheet::read::SheetReader;
use crate::sheet::sections::estimates::Estimates;
use crate::units::{Frame, short};
use percuss_formats::reading::quoted;
use percuss_spatial::Vector3;
use percuss_units::{LengthUnit, Unit};

/// Largest difference (m) between a stated half track and that of the wheel centre.
const MAX_TRACK_DIFFERENCE: f64 = 1e-3;

/// Diameter (m) of an unloaded tyre of this size: `205/55 R16` (width in mm, height in % of it, rim in inches) or `18.0x7.5-10` (diameter,
/// width and rim in inches). `None` for another text.
fn tyre_diameter(size: &str) -> Option<f64> {
    let numbers = |text: &str| -> Vec<f64> {
        let parts = text.split(|c: char| !c.is_ascii_digit() && c != '.');
        parts.filter(|part| !part.is_empty()).map_while(|part| part.parse().ok()).collect()
    };
    let diameter = match size.split_once('/') {
        Some((width, rest)) => {
            let (width, rest) = (numbers(width), numbers(rest));
            let ([width], [height, rim, ..]) = (&width[..], &rest[..]) else { return None };
            let is_usual = (60.0..=500.0).contains(width) && (20.0..=110.0).contains(height);
            is_usual.then_some(2e-5 * width * height + 0.0254 * rim)?
        }
        None => {
            let (diameter, rest) = size.split_once(['x', 'X', '×'])?;
            let ([diameter], [_, rim, ..]) = (&numbers(diameter)[..], &numbers(rest)[..]) else {
                return None;
            };
            (rim < diameter).then_some(0.0254 * diameter)?
        }
    };
    (0.1..3.0).contains(&diameter).then_some(diameter)
}

impl SheetReader<'_> {
    /// Radius of the wheel, m: stated, or that of the unloaded tyre.
    pub fn wheel_radius(&mut self, frame: Frame) -> Option<f64> {
        let tyre = self.entries.text(self.findings, "wheel.tyre", "a size such as \"205/55 R16\"");
        if let Some((radius, _)) = self.scalar("wheel.radius", Quantity::Length(frame.unit)) {
            return Some(radius);
        }
        let (size, spot) = tyre?;
        match tyre_diameter(&size) {
            Some(diameter) => {
                let radius = diameter / 2.0;
                let message = format!(
                    "{}: radius {} mm, that of the unloaded tyre; wheel.radius states another one",
                    quoted(&size),
                    short(1e3 * radius)
                );
                self.findings.note("tyre-size", &spot, message);
                Some(radius)
            }
            None => {
                let message = format!(
                    "{} is no size of a tyre; \"205/55 R16\" or \"18.0x7.5-10\" is expected",
                    quoted(&size)
                );
                self.findings.error("wrong-type", &spot, message);
                None
            }
        }
    }

    /// Centre of the wheel (m, left side) from the half track, the radius and the static camber, for a sheet without `wheel_centre`:
    /// y = h + r sin γ, z = r cos γ above the road z = 0, because the track is measured between the contact points (ISO 8855). Of a stated
    /// centre, the half track is compared.
    pub fn wheel_centre(
        &mut self,
        frame: Frame,
        camber: f64,
        stated: Option<Vector3<f64>>,
    ) -> Option<(Vector3<f64>, Spot)> {
        let (half, spot) = self.scalar("wheel.half_track", Quantity::Length(frame.unit))?;
        let [along, across, up] = ["longitudinal_offset", "lateral_offset", "vertical_offset"].map(|key| {
            self.scalar(&format!("wheel.{key}"), Quantity::Length(frame.unit)).map_or(0.0, |(x, _)| x)
        });
        let radius = self.wheel_radius(frame);
        if let Some(centre) = stated {
            let of_centre = centre.y - across - radius.unwrap_or(0.0) * camber.sin();
            if (of_centre - half).abs() > MAX_TRACK_DIFFERENCE
                && (centre.y - half).abs() > MAX_TRACK_DIFFERENCE
            {
                let in_unit = |x: f64| short(frame.unit.of_metres(x));
                let message = format!(
                    "the half track is {0} {2}, and that of wheel_centre {1} {2}: the centre is used",
                    in_unit(half),
                    in_unit(of_centre),
                    frame.unit.name()
                );
                self.findings.warning("unequal-track", &spot, message);
            }
            return None;
        }
        let Some(radius) = radius else {
            let message = "the half track gives the centre of the wheel with the radius: wheel.radius or wheel.tyre is expected, or the \
                           point wheel_centre";
            self.findings.error("missing-key", &spot, message.to_owned());
            return None;
        };
        let along = frame.axes.coordinate(0, along);
        let centre = Vector3::new(along, half + across + radius * camber.sin(), radius * camber.cos() + up);
        let stated = frame.axes.from_iso(centre).map(|x| short(LengthUnit::of_metres(frame.unit, x)));
        let message = format!(
            "wheel_centre = [{}, {}, {}] {} on the left side, from the half track at the road (z = 0), the radius and the camber",
            stated.x,
            stated.y,
            stated.z,
            frame.unit.name()
        );
        self.findings.note("wheel-centre", &spot, message);
        Some((centre, spot))
    }

    /// Wheel of the options, or else of the sheet.
    pub fn wheel(&mut self, frame: Frame, inertia_unit: &'static Unit) -> Option<Wheel> {
        let mass = self.scalar("wheel.mass", Quantity::Mass);
        let inertia =
            self.entries.numbers(self.findings, "wheel.inertia", Quantity::Inertia(inertia_unit), &[3]);
        let radius = self.wheel_radius(frame);
        if self.options.wheel.is_some() {
            return self.options.wheel;
        }
        let has_mass = self.entries.has("wheel.mass");
        let estimate = radius.filter(|_| self.estimates.is_some()).map(Estimates::wheel);
        let mass = match mass {
            Some((mass, _)) => mass,
            None if estimate.is_some() && !has_mass => estimate?.0,
            // The radius alone defines the contact point.
            None if self.options.masses_optional && radius.is_some() && !self.entries.has("wheel.mass") => {
                self.entries.missing(self.findings, "wheel.mass", "the mass of the wheel, kg,");
                0.0
            }
            None => return None,
        };
        let inertia = match inertia {
            Some((values, _)) => [values[0], values[1], values[2]],
            None if estimate.is_some() && !self.entries.has("wheel.inertia") => {
                let (of_mass, moments) = estimate?;
                if let Some(estimates) = &mut self.estimates {
                    estimates.add("wheel", mass, !has_mass);
                }
                moments.map(|moment| moment * mass / of_mass)
            }
            None => {
                if mass != 0.0 && !self.entries.has("wheel.inertia") {
                    let expected = "[xx, yy, zz] about the wheel's centre, y along the spin axis,";
                    self.entries.missing(self.findings, "wheel.inertia", expected);
                }
                [0.0; 3]
            }
        };
        Some(Wheel { mass, inertia, radius })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_of_tyres() {
        for (size, diameter) in [
            ("205/55 R16", 0.6319),
            ("P205/55R16 91V", 0.6319),
            ("LT265/75R16", 0.8039),
            ("120/70 ZR17", 0.5998),
            ("18.0x7.5-10", 0.4572),
        ] {
            let found = tyre_diameter(size).expect(size);
            assert!((found - diameter).abs() < 1e-9, "{size}: {found}");
        }
        for size in ["", "205", "205/55", "R16", "55/205 R16", "16x7", "a/b Rc"] {
            assert_eq!(tyre_diameter(size), None, "{size}");
        }
    }
}
