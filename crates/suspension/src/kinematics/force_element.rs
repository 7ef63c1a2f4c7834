//! Springs, dampers and stops of a suspension: motion ratios and forces.

use crate::kinematics::linkage_motion::{LinkageMotion, LinkedPoint};
use crate::kinematics::wheel::WheelParts;
use crate::{ForceElements, SpringForce};
use nalgebra::Vector3;
use percuss_contact::ForceCurve;
use percuss_dynamics::{ElementMotion, Gap, LinearElement, Pose};
use percuss_mechanism::{ContactKind, ContactNormal, LinkId, Mechanism, NamedContact};

/// Spring, damper or stop.
#[derive(Clone, Debug)]
pub struct ForceElement {
    /// Name without the ending of the side.
    pub name: String,
    /// Ending of the side; empty for a single side and for an element of both sides.
    pub side: &'static str,
    /// True if the element belongs to both wheels of an axle.
    pub is_shared: bool,
    kind: ContactKind,
    link: LinkId,
    point: Vector3<f64>,
    other: LinkId,
    normal: ContactNormal,
    /// Gap over the pose; `None` for parts that always touch.
    gap: Option<Gap>,
    /// Length as drawn, m, of a spring or damper.
    drawn_length: f64,
    /// Force of a spring, if the sheet states it.
    pub spring: Option<SpringForce>,
    /// Force of a stop, if the sheet states it.
    pub stop: Option<ForceCurve>,
}

/// Force of an element and its motion ratio at a pose, along a motion with one parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ElementRates {
    /// Compression per parameter, and its derivative with respect to the parameter.
    pub ratio: [f64; 2],
    /// Force, N; positive in compression. `None` if the sheet does not state the force.
    pub force: Option<f64>,
    /// Rate of the force with the compression, N/m.
    pub rate: Option<f64>,
}

impl ElementRates {
    /// Derivative of the element's generalised force F i with respect to the motion parameter s: k i² + F di/ds, N/m if s is in
    /// metres; i is the motion ratio. An unknown force counts as zero.
    pub fn parameter_rate(&self) -> Option<f64> {
        let [ratio, slope] = self.ratio;
        Some(self.rate? * ratio * ratio + self.force.unwrap_or(0.0) * slope)
    }
}

/// Springs, dampers and stops of a mechanism with the forces of a sheet.
pub(crate) fn force_elements(
    mechanism: &Mechanism,
    drawn: &Pose,
    wheels: &[WheelParts],
    forces: &ForceElements,
) -> Vec<ForceElement> {
    let element = |contact: &NamedContact| {
        let kind = contact.kind();
        if !matches!(kind, ContactKind::Stop | ContactKind::Spring | ContactKind::Damper) {
            return None;
        }
        let side = wheels.iter().map(|wheel| wheel.side).find(|side| contact.name().ends_with(side));
        let name = contact.name().strip_suffix(side.unwrap_or_default())?.to_owned();
        let other = contact.against().unwrap_or(mechanism.root());
        let mut element = ForceElement {
            side: side.unwrap_or_default(),
            is_shared: side.is_none(),
            kind,
            link: contact.link(),
            point: *contact.point(),
            other,
            normal: *contact.normal(),
            gap: Gap::new(drawn, contact),
            drawn_length: 0.0,
            spring: forces.springs.iter().find(|(section, _)| *section == name).map(|(_, spring)| *spring),
            stop: forces.stops.iter().find(|(section, _)| *section == name).map(|(_, stop)| stop.clone()),
            name,
        };
        let [(_, from), (_, to)] = element.ends(drawn);
        element.drawn_length = (to - from).norm();
        Some(element)
    };
    mechanism.contacts().iter().filter_map(element).collect()
}

impl ForceElement {
    /// True for a spring.
    pub(super) fn is_spring(&self) -> bool {
        self.kind == ContactKind::Spring
    }

    /// True for a spring or damper, whose line turns with the mechanism.
    pub(super) fn is_line(&self) -> bool {
        matches!(self.kind, ContactKind::Spring | ContactKind::Damper)
    }

    /// Points at both ends: on the link, and on the other side. For a fixed normal, both are at the contact point.
    pub(super) fn ends(&self, pose: &Pose) -> [LinkedPoint; 2] {
        let at = pose.link(self.link).point(&self.point);
        let other = match self.normal {
            ContactNormal::Fixed(_) => at,
            ContactNormal::Toward(point) | ContactNormal::Away(point) => pose.link(self.other).point(&point),
        };
        [(Some(self.link), at), (Some(self.other), other)]
    }

    /// Spring with a rate or touched stop, with its rate at a pose; `None` for other elements.
    pub(super) fn as_linear(&self, pose: &Pose) -> Option<LinearElement> {
        let (force, rate) = self.force(pose);
        let stiffness = rate.filter(|rate| *rate > 0.0)?;
        // A point 1 m along a fixed normal has the same rate of distance.
        let other = match self.normal {
            ContactNormal::Fixed(normal) => {
                let at = pose.link(self.link).point(&self.point) - pose.link(self.other).vector(&normal);
                pose.link(self.other).inverse_point(&at)
            }
            ContactNormal::Toward(point) | ContactNormal::Away(point) => point,
        };
        let motion = ElementMotion::Length([(self.link, self.point), (self.other, other)]);
        let name = format!("{}{}", self.name, self.side);
        let force = force.unwrap_or(0.0);
        Some(LinearElement { force, ..LinearElement::spring(name, motion, stiffness) })
    }

    /// Force (N, positive in compression) and its rate with the compression (N/m) at a pose, if the sheet states them.
    fn force(&self, pose: &Pose) -> (Option<f64>, Option<f64>) {
        match (&self.spring, &self.stop) {
            (Some(spring), _) => {
                let [(_, on_link), (_, on_other)] = self.ends(pose);
                let compression = self.drawn_length - (on_other - on_link).norm();
                (spring.preload.map(|preload| preload + spring.rate * compression), Some(spring.rate))
            }
            (None, Some(stop)) => {
                let compression = self.gap.as_ref().map_or(0.0, |gap| -gap.at(pose));
                let (force, slope) = stop.at(compression);
                (Some(force), Some(slope))
            }
            (None, None) => (None, None),
        }
    }

    /// Motion ratio and force at a pose.
    pub(super) fn rates(&self, pose: &Pose, motion: &LinkageMotion<'_>) -> ElementRates {
        let [on_link, on_other] = self.ends(pose);
        let ratio = match self.normal {
            ContactNormal::Fixed(normal) => {
                let normal = pose.link(self.other).vector(&normal);
                let omega = motion.angular_velocity(self.other);
                let speed = motion.velocity(on_link) - motion.velocity(on_other);
                let acceleration = motion.acceleration(on_link) - motion.acceleration(on_other);
                // The normal turns with the other side.
                [normal.dot(&speed), normal.dot(&(acceleration - 2.0 * omega.cross(&speed)))]
            }
            ContactNormal::Toward(_) => motion.distance_rates(on_link, on_other).map(|rate| -rate),
            ContactNormal::Away(_) => motion.distance_rates(on_link, on_other),
        };
        let (force, rate) = self.force(pose);
        ElementRates { ratio, force, rate }
    }
}
