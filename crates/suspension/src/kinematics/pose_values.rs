//! All quantities of a suspension at one pose.

use crate::kinematics::force_element::{ElementRates, ForceElement};
use crate::kinematics::linkage_motion::{Linkage, LinkageMotion, MotionError};
use crate::kinematics::loads::ComplianceLoads;
use crate::kinematics::parts::SuspensionParts;
use crate::kinematics::values::{KinematicUnit, KinematicValues};
use crate::kinematics::wheel::{WheelState, no_radius};
use crate::kinematics::wheel_points::wheel_of_patch;
use crate::limits::LEAST_TILT_RATE;
use nalgebra::{Matrix2, Vector3};
use percuss_dynamics::{Contact, EffectiveMass, PointVelocity, Pose};
use std::f64::consts::TAU;

/// Data of the vehicle that no suspension sheet contains. A quantity that requires missing data has a reason instead of a value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vehicle {
    /// True for the front axle, false for the rear axle.
    pub is_front: Option<bool>,
    /// Share of the front axle in the braking force.
    pub brake_bias: Option<f64>,
    /// Share of this axle in the driving force.
    pub drive_share: Option<f64>,
    /// Height of the centre of mass above the ground, m.
    pub cg_height: Option<f64>,
    /// Distance of the axles, m.
    pub wheelbase: Option<f64>,
    /// True if the braking force acts at the wheel centre.
    pub inboard_brakes: bool,
    /// True if the driving force acts at the wheel centre.
    pub inboard_drive: bool,
    /// Sprung mass above one wheel, kg.
    pub sprung_mass: Option<f64>,
    /// Vertical rate of the tyre, N/m; a rigid tyre without it.
    pub tyre_rate: Option<f64>,
    /// Loads of the elastokinematics; `None`: no quantities of the bushes.
    pub loads: Option<ComplianceLoads>,
}

impl SuspensionParts {
    /// All quantities at a pose of the mechanism, as derivatives along heave (all wheels up), or along roll (left up, right down) if
    /// `rolls`; or the reason for their absence.
    ///
    /// # Errors
    /// [`MotionError`]: a joint or a closure of a kind that suspensions do not have.
    pub fn values(
        &self,
        pose: &Pose,
        vehicle: &Vehicle,
        rolls: bool,
    ) -> Result<Result<KinematicValues, String>, MotionError> {
        let linkage = Linkage::new(pose)?;
        Ok(PoseEvaluation::evaluate(self, vehicle, pose, &linkage, rolls))
    }
}

/// Rates of the wheel travels along the motion of the derivatives: heave (all wheels up) or roll (left up, right down).
fn travel_rates(kinematics: &SuspensionParts, rolls: bool) -> Vec<f64> {
    kinematics.wheels.iter().map(|wheel| if rolls { wheel.sign } else { 1.0 }).collect()
}

/// Evaluation of the quantities at one pose.
pub(super) struct PoseEvaluation<'k> {
    kinematics: &'k SuspensionParts,
    vehicle: &'k Vehicle,
    pose: &'k Pose,
    linkage: &'k Linkage,
    /// Motion of the derivatives.
    motion: LinkageMotion<'k>,
    /// Rate of each wheel's travel along the motion.
    rates: Vec<f64>,
    values: KinematicValues,
}

impl<'k> PoseEvaluation<'k> {
    /// All quantities at a pose; `rolls`: derivatives along roll instead of heave.
    pub fn evaluate(
        kinematics: &'k SuspensionParts,
        vehicle: &'k Vehicle,
        pose: &'k Pose,
        linkage: &'k Linkage,
        rolls: bool,
    ) -> Result<KinematicValues, String> {
        let rates = travel_rates(kinematics, rolls);
        let motion = kinematics.wheel_motion(linkage, pose, &rates).map_err(|error| error.to_string())?;
        let values = KinematicValues::default();
        let mut row = Self { kinematics, vehicle, pose, linkage, motion, rates, values };
        let masses = row.unsprung_masses();
        for wheel in 0..kinematics.wheels.len() {
            let here = kinematics.wheels[wheel].at(pose);
            let drawn = kinematics.wheels[wheel].at(&kinematics.drawn);
            row.add_angles(wheel, &here, &drawn);
            row.add_steering_axis(wheel, &here);
            row.add_steering_ratio(wheel, &here);
            row.add_displacements(wheel, &here, &drawn);
            row.add_front_view(wheel, &here);
            row.add_side_view(wheel, &here);
            let rate = row.add_forces(wheel);
            row.add_frequencies(wheel, rate, masses.get(wheel).cloned());
        }
        row.add_roll_centre();
        if let Some(loads) = vehicle.loads {
            kinematics.add_compliance(linkage, pose, loads, &mut row.values);
        }
        Ok(row.values)
    }

    fn side(&self, wheel: usize) -> &'static str {
        self.kinematics.wheels[wheel].side
    }

    fn add(&mut self, wheel: usize, name: &str, unit: KinematicUnit, value: Result<f64, String>) {
        let side = self.side(wheel);
        self.values.add(side, name, unit, value);
    }

    fn add_angles(&mut self, wheel: usize, here: &WheelState, drawn: &WheelState) {
        let spindle = self.kinematics.wheels[wheel].spindle;
        let per_travel =
            here.angle_rates(&self.motion.angular_velocity(spindle)).map(|x| x / self.rates[wheel]);
        self.add(wheel, "wheel_travel", KinematicUnit::Length, Ok(here.centre.z - drawn.centre.z));
        self.add(wheel, "camber", KinematicUnit::Angle, Ok(here.camber()));
        self.add(wheel, "toe", KinematicUnit::Angle, Ok(here.toe()));
        self.add(wheel, "camber_gradient", KinematicUnit::AnglePerLength, Ok(per_travel[0]));
        self.add(wheel, "toe_gradient", KinematicUnit::AnglePerLength, Ok(per_travel[1]));
    }

    fn add_steering_axis(&mut self, wheel: usize, here: &WheelState) {
        let axis = self.kinematics.steering_axis(self.linkage, self.pose, wheel);
        let angle = |k: usize| axis.as_ref().map(|axis| here.steering_angles(axis)[k]).map_err(Clone::clone);
        let offset = |k: usize| {
            let axis = axis.as_ref().map_err(Clone::clone)?;
            Ok(here.ground_offsets(axis).ok_or_else(no_radius)?[k])
        };
        let (angles, offsets) = ([angle(0), angle(1)], [offset(0), offset(1)]);
        for (name, angle) in ["caster", "kingpin_inclination"].into_iter().zip(angles) {
            self.add(wheel, name, KinematicUnit::Angle, angle);
        }
        for (name, offset) in ["scrub_radius", "mechanical_trail"].into_iter().zip(offsets) {
            self.add(wheel, name, KinematicUnit::Length, offset);
        }
    }

    /// Angle of the steering wheel per steer angle of the wheel, |2π/(s dδ/dy)| with the travel s of the rack per turn and the steer angle δ
    /// over the travel y of the rack, at a wheel centre of constant height.
    fn add_steering_ratio(&mut self, wheel: usize, here: &WheelState) {
        let Some(travel) = self.kinematics.rack_travel else { return };
        let mut conditions = self.kinematics.held_joints(self.linkage, self.pose, 1.0);
        for parts in &self.kinematics.wheels {
            let centre = self.pose.link(parts.centre).translation;
            conditions.push((self.linkage.point_row(parts.on_wheel(centre), Vector3::z()), 0.0));
        }
        let spindle = self.kinematics.wheels[wheel].spindle;
        let motion = self.linkage.solve(&conditions).map_err(|error| error.to_string());
        let ratio = motion.map(|motion| {
            let [_, steer] = here.angle_rates(&motion.angular_velocity(spindle));
            (TAU / (travel * steer)).abs()
        });
        self.add(wheel, "steering_ratio", KinematicUnit::Ratio, ratio);
    }

    /// Adds the displacements of the contact point from its drawn position: lateral, and forward.
    fn add_displacements(&mut self, wheel: usize, here: &WheelState, drawn: &WheelState) {
        let both = here.contact.zip(drawn.contact).ok_or_else(no_radius);
        let lateral =
            both.clone().map(|(here_at, drawn_at)| here.lateral(&here_at) - drawn.lateral(&drawn_at));
        let forward = both.map(|(here, drawn)| here.x - drawn.x);
        self.add(wheel, "half_track_change", KinematicUnit::Length, lateral);
        self.add(wheel, "forward_displacement", KinematicUnit::Length, forward);
    }

    /// Instant centre of the wheel carrier in the front view, from the contact point: distance inward and height above the
    /// ground.
    fn add_front_view(&mut self, wheel: usize, here: &WheelState) {
        let parts = &self.kinematics.wheels[wheel];
        let centre = if self.kinematics.solid_axle {
            Err("both wheels are on one axle: see roll_centre_height".to_owned())
        } else {
            let tilt = self.motion.angular_velocity(parts.spindle).x / self.rates[wheel];
            match here.contact_velocity(parts, &self.motion) {
                None => Err(no_radius()),
                Some(_) if tilt.abs() < LEAST_TILT_RATE => {
                    Err("the instant centre is at infinity: the wheel does not tilt".to_owned())
                }
                Some(v) => {
                    let v = v / self.rates[wheel];
                    Ok([parts.sign * v.z / tilt, v.y / tilt])
                }
            }
        };
        for (k, name) in ["instant_centre_distance", "instant_centre_height"].into_iter().enumerate() {
            let value = centre.as_ref().map(|at| at[k]).map_err(Clone::clone);
            self.add(wheel, name, KinematicUnit::Length, value);
        }
    }

    /// Angle of the path in the side view, and the support angles of braking and driving.
    fn add_side_view(&mut self, wheel: usize, here: &WheelState) {
        let parts = &self.kinematics.wheels[wheel];
        let slope = |v: Vector3<f64>| v.x / v.z;
        let at_centre = slope(self.motion.velocity(parts.on_wheel(here.centre)));
        let at_contact = here.contact_velocity(parts, &self.motion).map(slope).ok_or_else(no_radius);
        self.add(wheel, "side_view_angle", KinematicUnit::Angle, at_contact.clone().map(f64::atan));
        self.add(wheel, "side_view_angle_centre", KinematicUnit::Angle, Ok(at_centre.atan()));
        let of = |is_inboard: bool| if is_inboard { Ok(at_centre) } else { at_contact.clone() };
        let vehicle = *self.vehicle;
        let (braking, driving) = (support(&vehicle, true), support(&vehicle, false));
        let braking = braking.and_then(|factor| Ok(factor * of(vehicle.inboard_brakes)?));
        let driving = driving.and_then(|factor| Ok(factor * of(vehicle.inboard_drive)?));
        let names = match vehicle.is_front {
            Some(true) => ["anti_dive", "anti_lift_driving"],
            Some(false) => ["anti_lift_braking", "anti_squat"],
            None => ["anti_dive_or_lift_braking", "anti_squat_or_lift_driving"],
        };
        for (name, value) in names.into_iter().zip([braking, driving]) {
            self.add(wheel, name, KinematicUnit::Percent, value);
        }
    }

    /// Motion ratios and rates of the springs, dampers and stops of a wheel; returns the wheel rate (N/m).
    fn add_forces(&mut self, wheel: usize) -> Result<f64, String> {
        let (side, rate) = (self.side(wheel), self.rates[wheel]);
        let kinematics = self.kinematics;
        let wheels = kinematics.wheels.len() as f64;
        // The travel of a wheel on a solid axle moves the springs of both sides: the rate of the axle is divided equally.
        let share =
            |element: &ForceElement| match (element.is_shared || kinematics.solid_axle, element.side == side)
            {
                (true, _) => 1.0 / wheels,
                (false, true) => 1.0,
                (false, false) => 0.0,
            };
        let of_wheel = |element: &ForceElement| -> ElementRates {
            let mut rates = element.rates(self.pose, &self.motion);
            rates.ratio[0] /= rate;
            rates
        };
        let found: Vec<(&ForceElement, ElementRates, f64)> = kinematics
            .elements
            .iter()
            .map(|element| (element, of_wheel(element), share(element)))
            .filter(|(_, _, share)| *share > 0.0)
            .collect();
        let shown = |element: &ForceElement| element.is_shared || element.side == side;
        for (element, rates, _) in found.iter().filter(|(element, ..)| shown(element)) {
            let name = format!("motion_ratio_{}", element.name);
            let unit =
                if element.is_torsion_bar() { KinematicUnit::AnglePerLength } else { KinematicUnit::Ratio };
            self.values.add(side, name, unit, Ok(rates.ratio[0]));
        }
        // Bicycles and motorcycles: wheel travel per compression.
        let is_in_middle = kinematics.wheels[wheel].is_in_middle();
        for (element, rates, _) in found.iter().filter(|(element, ..)| is_in_middle && element.is_line()) {
            let name = format!("leverage_ratio_{}", element.name);
            self.values.add(side, name, KinematicUnit::Ratio, Ok(rates.ratio[0].recip()));
        }
        let has_gradient = |element: &ForceElement| shown(element) && !element.is_torsion_bar();
        for (element, rates, _) in found.iter().filter(|(element, ..)| has_gradient(element)) {
            let name = format!("ratio_gradient_{}", element.name);
            self.values.add(side, name, KinematicUnit::PerLength, Ok(rates.ratio[1] / rate.powi(2)));
        }
        let total = if found.iter().any(|(element, ..)| element.spring.is_some()) {
            Ok(found.iter().filter_map(|(_, rates, share)| Some(share * rates.parameter_rate()?)).sum())
        } else {
            Err(kinematics.missing_rate.to_owned())
        };
        for (element, rates, _) in found.iter().filter(|(element, ..)| shown(element)) {
            let name = &element.name;
            if element.spring.is_some() {
                let force = rates.force.ok_or_else(|| format!("{name}.preload is missing in the sheet"));
                let (quantity, unit) = if element.is_torsion_bar() {
                    ("moment", KinematicUnit::Moment)
                } else {
                    ("force", KinematicUnit::Force)
                };
                self.values.add(side, format!("{quantity}_{name}"), unit, force);
            } else if element.stop.is_some() {
                let force = rates.force.ok_or_else(String::new);
                self.values.add(side, format!("force_{name}"), KinematicUnit::Force, force);
            }
        }
        self.add(wheel, "wheel_rate", KinematicUnit::Stiffness, total.clone());
        if let Some(bar) = kinematics.anti_roll_bar {
            let of_bar = (rate, kinematics.wheels.len());
            let rate = bar.rate_at_wheel(self.pose, &kinematics.drawn, &self.motion, of_bar);
            self.add(wheel, "anti_roll_bar_rate", KinematicUnit::Stiffness, Ok(rate));
        }
        total
    }

    /// Effective mass at each contact patch along the vertical, kg. Two wheels on one axle move together as in the motion of
    /// the derivatives: with the inverse masses Λ at both patches and the signs s of their motion, mᵢ = sᵢ Σ (Λ⁻¹)ᵢⱼ sⱼ.
    fn unsprung_masses(&self) -> Vec<Result<f64, String>> {
        let missing = &self.kinematics.missing_masses;
        if !missing.is_empty() {
            let reason = format!("masses are missing in the sheet: {}", missing.join(", "));
            return self.kinematics.wheels.iter().map(|_| Err(reason.clone())).collect();
        }
        let (pose, mechanism) = (self.pose, &**self.pose.mechanism());
        let patches: Vec<_> = self
            .kinematics
            .wheels
            .iter()
            .map(|wheel| mechanism.find_contact(&format!("contact_patch{}", wheel.side)).ok())
            .collect();
        let mut inverse = Matrix2::zeros();
        for (i, patch) in patches.iter().enumerate() {
            let Some(patch) = patch else { return patches.iter().map(|_| Err(no_radius())).collect() };
            let lowest = wheel_of_patch(mechanism, patch).and_then(|wheel| wheel.at(pose));
            let contact = Contact {
                point: lowest.unwrap_or(*patch.point()),
                ..Contact::named(patch, mechanism.root())
            };
            let answer = pose.respond(&contact);
            let (response, mass) = match answer.map(|response| (response.effective_mass, response)) {
                Ok((EffectiveMass::Finite(mass), response)) => (response, mass),
                Ok((EffectiveMass::Massless, _)) => {
                    return patches.iter().map(|_| Err("massless".to_owned())).collect();
                }
                Ok((EffectiveMass::Immovable, _)) => {
                    return patches.iter().map(|_| Err("immovable".to_owned())).collect();
                }
                Err(error) => return patches.iter().map(|_| Err(error.to_string())).collect(),
            };
            for (j, other) in patches.iter().enumerate() {
                let Some(other) = other else { continue };
                let ratio = if i == j {
                    1.0
                } else {
                    let lowest = wheel_of_patch(mechanism, other).and_then(|wheel| wheel.at(pose));
                    match pose.point_velocity(&response, other.link(), &lowest.unwrap_or(*other.point())) {
                        Some(PointVelocity::Known(v)) => -v.z,
                        _ => return patches.iter().map(|_| Err("undetermined".to_owned())).collect(),
                    }
                };
                inverse[(i, j)] = ratio / mass;
            }
        }
        if patches.len() == 1 {
            return vec![Ok(1.0 / inverse[(0, 0)])];
        }
        let Some(masses) = inverse.try_inverse() else {
            return patches.iter().map(|_| Err("undetermined".to_owned())).collect();
        };
        (0..2).map(|i| Ok((0..2).map(|j| self.rates[i] * masses[(i, j)] * self.rates[j]).sum())).collect()
    }

    /// Unsprung mass, and the natural frequencies of a quarter of the vehicle, undamped.
    fn add_frequencies(
        &mut self,
        wheel: usize,
        rate: Result<f64, String>,
        mass: Option<Result<f64, String>>,
    ) {
        let mass = mass.unwrap_or_else(|| Err(no_radius()));
        self.add(wheel, "unsprung_mass", KinematicUnit::Mass, mass.clone());
        let sprung = self.vehicle.sprung_mass.ok_or_else(|| "missing: --sprung-mass".to_owned());
        let tyre = self.vehicle.tyre_rate.ok_or_else(|| "missing: --tyre-rate".to_owned());
        let body = match (&tyre, &sprung) {
            (Ok(tyre), Ok(sprung)) => frequencies(&rate, &mass, *sprung, *tyre).map(|both| both[0]),
            // Without its rate, the tyre is rigid.
            (Err(_), Ok(sprung)) => rate.clone().and_then(|rate| root(rate / sprung)),
            (_, Err(why)) => Err(why.clone()),
        };
        let hop = sprung.and_then(|sprung| frequencies(&rate, &mass, sprung, tyre?).map(|both| both[1]));
        self.add(wheel, "body_frequency", KinematicUnit::Frequency, body);
        self.add(wheel, "wheel_hop_frequency", KinematicUnit::Frequency, hop);
    }

    /// Roll centre: intersection of the normals of the velocities of both contact points in roll, in the front view; with
    /// one side, the intersection with the middle plane. Height above the line of the contact points.
    fn add_roll_centre(&mut self) {
        let centre = self.roll_centre();
        for (k, name) in ["roll_centre_lateral", "roll_centre_height"].into_iter().enumerate() {
            let value = centre.as_ref().map(|at| at[k]).map_err(Clone::clone);
            self.values.add("", name, KinematicUnit::Length, value);
        }
    }

    fn roll_centre(&self) -> Result<[f64; 2], String> {
        let kinematics = self.kinematics;
        if kinematics.wheels.iter().any(|wheel| wheel.is_in_middle()) {
            return Err("the wheel is in the middle plane: there is no axle that rolls".to_owned());
        }
        let rates = travel_rates(kinematics, true);
        let rolling =
            kinematics.wheel_motion(self.linkage, self.pose, &rates).map_err(|error| error.to_string())?;
        let mut lines = Vec::new();
        for wheel in &kinematics.wheels {
            let state = wheel.at(self.pose);
            let (Some(at), Some(v)) = (state.contact, state.contact_velocity(wheel, &rolling)) else {
                return Err(no_radius());
            };
            lines.push((at, -v.y / v.z));
        }
        match lines[..] {
            [(at, slope)] => Ok([0.0, -at.y * slope]),
            [(left, left_slope), (right, right_slope)] => {
                let difference = left_slope - right_slope;
                let lateral = (right.z - left.z + left_slope * left.y - right_slope * right.y) / difference;
                // Parallel normals coincide with the line of the contact points.
                let lateral = if lateral.is_finite() { lateral } else { 0.5 * (left.y + right.y) };
                let ground = left.z + (lateral - left.y) * (right.z - left.z) / (right.y - left.y);
                Ok([lateral, left.z + left_slope * (lateral - left.y) - ground])
            }
            _ => Err("a suspension has one or two wheels".to_owned()),
        }
    }
}

/// Support per slope dx/dz of the path: p L/h with the share p of this axle in the force, positive if a forward (front,
/// braking) or backward path supports the body. Missing data are named.
fn support(vehicle: &Vehicle, braking: bool) -> Result<f64, String> {
    let front = vehicle.is_front;
    let share = if braking {
        vehicle.brake_bias.map(|bias| if front == Some(true) { bias } else { 1.0 - bias })
    } else {
        vehicle.drive_share
    };
    let flag = if braking { "--brake-bias" } else { "--drive-share" };
    let given = [
        ("--axle", front.is_some()),
        (flag, share.is_some()),
        ("--cg-height", vehicle.cg_height.is_some()),
        ("--wheelbase", vehicle.wheelbase.is_some()),
    ];
    let missing: Vec<&str> =
        given.into_iter().filter(|(_, is_given)| !is_given).map(|(flag, _)| flag).collect();
    let (Some(front), Some(share), Some(height), Some(wheelbase)) =
        (front, share, vehicle.cg_height, vehicle.wheelbase)
    else {
        return Err(format!("missing: {}", missing.join(", ")));
    };
    let sign = if front { 1.0 } else { -1.0 };
    Ok(sign * share * wheelbase / height)
}

/// √x/(2π), Hz.
fn root(x: f64) -> Result<f64, String> {
    if x >= 0.0 {
        Ok(x.sqrt() / TAU)
    } else {
        Err("the wheel rate is negative: the pose is unstable".to_owned())
    }
}

/// Undamped natural frequencies of the body and of the wheel, Hz, from the wheel rate k (`rate`, N/m), the unsprung mass m_u
/// (`mass`, kg), the sprung mass m_s (kg) and the stiffness k_t of the tyre (N/m). Roots of
/// m_s m_u λ² − (m_s (k + k_t) + m_u k) λ + k k_t = 0 with λ = ω².
fn frequencies(
    rate: &Result<f64, String>,
    mass: &Result<f64, String>,
    sprung: f64,
    tyre: f64,
) -> Result<[f64; 2], String> {
    let (k, unsprung) = (rate.clone()?, mass.clone()?);
    let (a, b, c) = (sprung * unsprung, sprung * (k + tyre) + unsprung * k, k * tyre);
    let large = (b + (b * b - 4.0 * a * c).max(0.0).sqrt()) / (2.0 * a);
    // The product of the roots is c/a: no cancellation.
    Ok([root(c / (a * large))?, root(large)?])
}
