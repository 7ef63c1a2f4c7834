//! Masses, centres of mass and inertias of the bodies and of the wheel.

use crate::corner;
use crate::corner::design::GivenBody;
use crate::findings::Spot;
use crate::options::Side;
use crate::sheet::catalogue;
use crate::sheet::entries::Quantity;
use crate::sheet::read::SheetReader;
use crate::sheet::sections::estimates::{Estimate, Estimates};
use crate::sheet::template::{Shape, Template, symmetric_matrix};
use crate::units::Frame;
use percuss_spatial::{Matrix3, Vector3};
use percuss_units::Unit;
use std::collections::BTreeMap;

impl SheetReader<'_> {
    /// Reads the bodies that the template requires or the sheet contains.
    pub fn bodies(
        &mut self,
        template: &'static Template,
        frame: Frame,
        (points_side, points): (Side, &BTreeMap<&'static str, (Vector3<f64>, Spot)>),
        inertia_unit: &'static Unit,
    ) -> BTreeMap<&'static str, GivenBody> {
        let mut bodies = BTreeMap::new();
        let radius = self.wheel_radius(frame);
        for (key, body) in &template.bodies {
            // The bodies of a bar are not required if the sheet has no bar.
            let of_bar = ["anti_roll_bar", "drop_link"].contains(&&**key);
            let absent = !self.entries.has_section(key);
            if absent
                && (body.shape != Shape::Any
                    && body.shape != Shape::Spindle
                    && (self.estimates.is_none() || body.shape == Shape::Optional)
                    || of_bar && !self.entries.has("points.drop_link_bar"))
            {
                continue;
            }
            let estimate =
                self.estimates.as_ref().and_then(|_| Estimates::body(template, key, points, radius));
            let kind = (&**key, body.shape);
            if let Some(given_body) = self.body(template, kind, frame, points_side, inertia_unit, estimate) {
                bodies.insert(&**key, given_body);
            }
        }
        bodies
    }

    /// Reads the body of the chassis, if the sheet has one.
    pub fn chassis(
        &mut self,
        template: &Template,
        frame: Frame,
        points_side: Side,
        inertia_unit: &'static Unit,
    ) -> Option<corner::Body> {
        if !self.entries.has_section(corner::CHASSIS) {
            return None;
        }
        let key = (corner::CHASSIS, Shape::Optional);
        match self.body(template, key, frame, points_side, inertia_unit, None)? {
            GivenBody::Body(body) => Some(body),
            GivenBody::Rod(..) => None,
        }
    }

    /// Reads one body, mirrored to the left side; `None` if it is absent or invalid.
    fn body(
        &mut self,
        template: &Template,
        (key, shape): (&str, Shape),
        frame: Frame,
        points_side: Side,
        inertia_unit: &'static Unit,
        estimate: Option<Estimate>,
    ) -> Option<GivenBody> {
        let [mass_key, com_key, inertia_key] = ["mass", "com", "inertia"].map(|name| format!("{key}.{name}"));
        let is_rod = shape == Shape::Rod;
        let spot = |spot: Spot| Spot { path: Some(key.to_owned()), ..spot };
        let given_mass = self.scalar(&mass_key, Quantity::Mass);
        let is_estimated = given_mass.is_none() && estimate.is_some() && !self.entries.has(&mass_key);
        let estimated_mass = estimate.as_ref().filter(|_| is_estimated).map(|of| (of.mass, Spot::default()));
        let Some((mass, at)) = given_mass.or(estimated_mass) else {
            if !self.entries.has(&mass_key) && (!is_rod || self.entries.has(&com_key)) {
                let text = catalogue::description_of(&catalogue::keys().bodies, key);
                self.entries.missing(
                    self.findings,
                    &mass_key,
                    &format!("the mass of {text}, kg (0 is legal),"),
                );
                for key in [&com_key, &inertia_key] {
                    self.entries.find(key);
                }
            }
            return None;
        };
        let spot = spot(at);
        let is_spindle = shape == Shape::Spindle;
        let is_complete = self.entries.has(&com_key) || is_spindle || mass == 0.0;
        let is_slender = is_rod && !self.entries.has(&com_key) && !self.entries.has(&inertia_key);
        if let Some(estimates) = self.estimates.as_mut().filter(|_| estimate.is_some())
            && (is_estimated
                || !is_slender && !(is_complete && (self.entries.has(&inertia_key) || mass == 0.0)))
        {
            estimates.add(key, mass, is_estimated);
        }
        if is_slender {
            return Some(GivenBody::Rod(mass, spot));
        }
        let (com, com_spot) = match self.entries.point(self.findings, &com_key, frame) {
            Some((com, at)) => (Some(com), at),
            None if self.entries.has(&com_key) => return None,
            None => (None, spot.clone()),
        };
        let is_mirrored = points_side == Side::Right && !template.is_central_body(key);
        // NaN: the default for a spindle is the wheel centre, which is computed later. A massless body needs no centre of mass.
        let com = match com {
            Some(com) => Vector3::new(com.x, if is_mirrored { 0.0 - com.y } else { com.y }, com.z),
            None if is_spindle => Vector3::repeat(f64::NAN),
            None if mass == 0.0 => Vector3::zeros(),
            None if estimate.is_some() => estimate.as_ref().map(|of| of.com)?,
            None => {
                self.entries.missing(self.findings, &com_key, "the centre of mass, [x, y, z],");
                return None;
            }
        };
        let stated = match self.entries.numbers(
            self.findings,
            &inertia_key,
            Quantity::Inertia(inertia_unit),
            // Along the wheel's axes the products of inertia are zero.
            if is_spindle { &[3] } else { &[3, 6] },
        ) {
            Some((values, _)) => Some(symmetric_matrix(&values)),
            None if self.entries.has(&inertia_key) => return None,
            None if mass == 0.0 => Some(Matrix3::zeros()),
            None if estimate.is_some() => None,
            None => {
                let expected =
                    "the inertia about the centre of mass, [xx, yy, zz] or [xx, yy, zz, xy, xz, yz],";
                self.entries.missing(self.findings, &inertia_key, expected);
                return None;
            }
        };
        // The inertia of a spindle is along the wheel's axes, the inertia of other bodies along the vehicle's axes.
        let to_left_iso = |stated: Matrix3<f64>| {
            let mut about_com = if is_spindle { stated } else { frame.axes.inertia_to_iso(stated) };
            if is_mirrored && !is_spindle {
                for (row, column) in [(0, 1), (1, 0), (1, 2), (2, 1)] {
                    about_com[(row, column)] = 0.0 - about_com[(row, column)];
                }
            }
            about_com
        };
        let estimated = || estimate.as_ref().map(|of| of.about_com * (mass / of.mass));
        let about_com = stated.map(to_left_iso).or_else(estimated)?;
        Some(GivenBody::Body(corner::Body { mass, com, about_com, spot, com_spot }))
    }
}
