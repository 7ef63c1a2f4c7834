//! Elastokinematics (K&C): motion of the wheels under loads, with the bushes of the sheet.

use crate::kinematics::force_element::ForceElement;
use crate::kinematics::linkage_motion::Linkage;
use crate::kinematics::loads::{ComplianceLoads, LoadCase, LoadedWheels};
use crate::kinematics::parts::SuspensionParts;
use crate::kinematics::values::{KinematicUnit, KinematicValues};
use crate::kinematics::wheel::{WheelParts, no_radius};
use crate::kinematics::wheel_points::sliding_rack;
use nalgebra::{DMatrix, Vector3};
use percuss_dynamics::{
    Contact, ElasticSystem, ElementMotion, LinearElement, Load, Pose, StaticDisplacement, StaticSystem,
};
use percuss_mechanism::Bush;

impl LoadCase {
    /// Load on a wheel of a pose, of 1 N or 1 N·m times `factor`.
    fn on(&self, pose: &Pose, wheel: &WheelParts, factor: f64) -> Result<Load, String> {
        let here = wheel.at(pose);
        let patch = here.contact.ok_or_else(no_radius);
        let at = if self.is_at_centre || self.is_moment { here.centre } else { patch? };
        let vector = pose.base().inverse_vector(&self.vector) * factor;
        let zero = Vector3::zeros();
        let (force, moment) = if self.is_moment { (zero, vector) } else { (vector, zero) };
        let point = pose.link(wheel.spindle).inverse_point(&at);
        Ok(Load { moment, ..Load::force(wheel.spindle, point, force) })
    }
}

/// Value of a rotation of a wheel and a displacement of its centre, or the reason for its absence.
type ValueOf<'v> = dyn Fn(&[Vector3<f64>; 2]) -> Result<f64, String> + 'v;

/// Reason for the absence of values if the sheet has no bushes.
const NO_BUSH: &str = "the sheet has no bush: [bush.POINT] or [rack] stiffness";
/// Way out of a motion without stiffness.
const OR_HELD: &str = "give it, or hold the travel of the wheels (--travel-held)";
/// Reason for the absence of values if a motion without stiffness gives way.
const NO_STIFFNESS: &str = "a motion without stiffness gives way to the load: give torsional and conical of the bushes at single points";

impl SuspensionParts {
    /// Mechanism with bushes at a pose: wheels do not turn relative to their carriers, a sliding rack stays, springs and touched stops have
    /// their rates at the pose. Tyres are left out: the loads act on the wheels.
    fn elastic_system(&self, pose: &Pose, loads: ComplianceLoads) -> Result<ElasticSystem, String> {
        let mechanism = &**pose.mechanism();
        if mechanism.bushes().is_empty() {
            return Err(NO_BUSH.to_owned());
        }
        if !loads.travel_held && !self.elements.iter().any(|element| element.spring.is_some()) {
            return Err(format!("{}: {OR_HELD}", self.missing_rate));
        }
        let held = |motion| LinearElement::spring("held", motion, f64::INFINITY);
        let zero = Vector3::zeros();
        let mut elements: Vec<LinearElement> =
            self.elements.iter().filter_map(|element| element.as_linear(pose)).collect();
        elements.extend(self.anti_roll_bar.map(|bar| bar.element()));
        elements.extend(self.wheels.iter().map(|wheel| held(ElementMotion::Twist(wheel.spin, None))));
        if loads.travel_held {
            let along = |wheel: &WheelParts| ElementMotion::Along(wheel.centre, zero, Vector3::z());
            elements.extend(self.wheels.iter().map(|wheel| held(along(wheel))));
        }
        let is_replaced = |rack| mechanism.bushes().iter().any(|bush| bush.joints().contains(&rack));
        if let Some(rack) = sliding_rack(mechanism).filter(|rack| !is_replaced(*rack)) {
            elements.push(held(ElementMotion::Along(mechanism.joint(rack).child(), zero, Vector3::y())));
        }
        let contact = Contact::new(self.wheels[0].centre, zero, Vector3::z());
        let contact = pose.locate(&contact).map_err(|error| error.to_string())?;
        ElasticSystem::new(pose, &contact, &elements, None).map_err(|error| error.to_string())
    }

    /// Vertical forces on the wheels at a pose: see [`ElasticSystem::with_geometric_stiffness`].
    ///
    /// # Errors
    /// The reason for their absence.
    pub fn wheel_loads(&self, pose: &Pose) -> Result<Vec<Load>, String> {
        self.resting_loads(&Linkage::new(pose).map_err(|error| error.to_string())?, pose)
    }

    /// Vertical forces on the wheels that balance the springs and touched stops with a known force and the preloads of bushes, at the contact points,
    /// which roll.
    fn resting_loads(&self, linkage: &Linkage, pose: &Pose) -> Result<Vec<Load>, String> {
        let mut loads = Vec::new();
        let is_unloaded =
            |element: &ForceElement| element.as_linear(pose).is_none_or(|spring| spring.force == 0.0);
        let bushes = pose.mechanism().bushes();
        if self.elements.iter().all(is_unloaded)
            && bushes.iter().all(|bush| bush.description().preload == [0.0; 6])
        {
            return Ok(loads);
        }
        for (k, wheel) in self.wheels.iter().enumerate() {
            let rates: Vec<f64> = (0..self.wheels.len()).map(|i| if i == k { 1.0 } else { 0.0 }).collect();
            let motion = self.wheel_motion(linkage, pose, &rates).map_err(|error| error.to_string())?;
            let power = |element: &ForceElement| {
                let rates = element.rates(pose, &motion);
                rates.force.unwrap_or(0.0) * rates.ratio[0]
            };
            let here = wheel.at(pose);
            let at = here.contact.unwrap_or(here.centre);
            let rise = motion.velocity(wheel.on_wheel(at)).z;
            // Power of the preload of a bush, negative.
            let of_bush = |bush: &Bush| {
                let description = bush.description();
                let frame = pose.link(bush.link()) * description.frame;
                let rates =
                    |link| [motion.angular_velocity(link), motion.velocity((Some(link), frame.translation))];
                let [own, other] =
                    [rates(bush.link()), rates(bush.against().unwrap_or(pose.mechanism().root()))];
                let relative = [own[0] - other[0], own[1] - other[1]].map(|rate| frame.inverse_vector(&rate));
                -(0..6).map(|i| description.preload[i] * relative[i / 3][i % 3]).sum::<f64>()
            };
            let compressing = self.elements.iter().map(power).sum::<f64>();
            let force = (compressing + bushes.iter().map(of_bush).sum::<f64>()) / rise;
            let frame = pose.link(wheel.spindle);
            // The contact point stays below the centre of a wheel that rolls, also under a force downward.
            let radius = wheel.radius.map(|radius| radius.copysign(force));
            let disc = radius.map(|radius| (frame.inverse_vector(&here.outward), radius));
            let force = pose.base().inverse_vector(&(Vector3::z() * force));
            let centre = frame.inverse_point(&here.centre);
            loads.push(Load { disc, ..Load::force(wheel.spindle, centre, force) });
        }
        Ok(loads)
    }

    /// Adds toe, camber and the displacements of the wheel centre and of the contact point per load. Displacements are in the axes of the
    /// vehicle.
    pub(super) fn add_compliance(
        &self,
        linkage: &Linkage,
        pose: &Pose,
        loads: ComplianceLoads,
        values: &mut KinematicValues,
    ) {
        let system = self.elastic_system(pose, loads);
        let statics = system.as_ref().map_err(Clone::clone).and_then(|system| {
            let resting = self.resting_loads(linkage, pose)?;
            system.statics(&resting).map_err(|error| error.to_string())
        });
        for (k, wheel) in self.wheels.iter().enumerate() {
            let here = wheel.at(pose);
            for case in LoadCase::all() {
                let found = match &statics {
                    _ if loads.travel_held && case.vector.z != 0.0 && !case.is_moment => {
                        Err("the travel of the wheels is held".to_owned())
                    }
                    Ok(statics) => self.wheel_under(statics, pose, loads.wheels, &case, k),
                    Err(why) => Err(why.clone()),
                };
                let (angle, length) = if case.is_moment {
                    (KinematicUnit::AnglePerMoment, KinematicUnit::LengthPerMoment)
                } else {
                    (KinematicUnit::AnglePerForce, KinematicUnit::LengthPerForce)
                };
                let mut add = |name: &str, unit, value: &ValueOf<'_>| {
                    let value = found.as_ref().map_err(Clone::clone).and_then(value);
                    values.add(wheel.side, format!("{name}_per_{}", case.name), unit, value);
                };
                add("toe", angle, &|[turn, _]| Ok(here.angle_rates(turn)[1]));
                add("camber", angle, &|[turn, _]| Ok(here.angle_rates(turn)[0]));
                for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
                    add(&format!("wheel_centre_{axis}"), length, &|[_, centre]| Ok(centre[i]));
                }
                for (i, axis) in ["x", "y"].into_iter().enumerate() {
                    add(&format!("contact_patch_{axis}"), length, &|[turn, centre]| {
                        let arm = here.contact.ok_or_else(no_radius)? - here.centre;
                        Ok((centre + turn.cross(&arm))[i])
                    });
                }
            }
        }
    }

    /// Rotation of a wheel and displacement of its centre under a unit load, in the axes of the vehicle.
    fn wheel_under(
        &self,
        statics: &StaticSystem<'_>,
        pose: &Pose,
        loaded: LoadedWheels,
        case: &LoadCase,
        wheel: usize,
    ) -> Result<[Vector3<f64>; 2], String> {
        if loaded != LoadedWheels::Single && self.wheels.len() < 2 {
            return Err("parallel and opposed loads need both wheels: build = \"both\"".to_owned());
        }
        let mut acting = Vec::new();
        for (k, parts) in self.wheels.iter().enumerate() {
            let is_right = parts.sign < 0.0;
            let factor = match loaded {
                LoadedWheels::Single if k != wheel => continue,
                _ if is_right => case.factor_on_right(loaded),
                _ => 1.0,
            };
            acting.push(case.on(pose, parts, factor)?);
        }
        let found = statics.displacement(&acting).ok_or(NO_STIFFNESS)?;
        self.of_wheel(&found, pose, wheel).ok_or_else(|| NO_STIFFNESS.to_owned())
    }

    /// Rotation of a wheel and displacement of its centre, in the axes of the vehicle.
    fn of_wheel(
        &self,
        found: &StaticDisplacement<'_>,
        pose: &Pose,
        wheel: usize,
    ) -> Option<[Vector3<f64>; 2]> {
        let parts = &self.wheels[wheel];
        let at = pose.link(parts.spindle).inverse_point(&pose.link(parts.centre).translation);
        Some(found.of(parts.spindle, &at)?.map(|vector| pose.base().vector(&vector)))
    }

    /// Compliance matrix of the wheel centres: displacement (m) and rotation (rad) of each wheel centre along x, y, z of the vehicle per unit force
    /// (N) and moment (N·m) on each, 6×6 or 12×12, the left wheel first.
    ///
    /// # Errors
    /// The reason for its absence.
    pub fn compliance_matrix(&self, pose: &Pose, loads: ComplianceLoads) -> Result<DMatrix<f64>, String> {
        let system = self.elastic_system(pose, loads)?;
        let linkage = Linkage::new(pose).map_err(|error| error.to_string())?;
        let resting = self.resting_loads(&linkage, pose)?;
        let statics = system.statics(&resting).map_err(|error| error.to_string())?;
        let n = 6 * self.wheels.len();
        let mut matrix = DMatrix::zeros(n, n);
        for column in 0..n {
            let wheel = &self.wheels[column / 6];
            let (vector, is_moment) = (Vector3::ith(column % 3, 1.0), column % 6 > 2);
            let case = LoadCase { name: "", vector, direction: "", is_moment, is_at_centre: true };
            let found = statics.displacement(&[case.on(pose, wheel, 1.0)?]).ok_or(NO_STIFFNESS)?;
            for k in 0..self.wheels.len() {
                let [turn, centre] = self.of_wheel(&found, pose, k).ok_or(NO_STIFFNESS)?;
                matrix.fixed_view_mut::<3, 1>(6 * k, column).copy_from(&centre);
                matrix.fixed_view_mut::<3, 1>(6 * k + 3, column).copy_from(&turn);
            }
        }
        Ok(matrix)
    }
}
