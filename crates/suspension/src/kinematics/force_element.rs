//! Springs, torsion bars, dampers and stops of a suspension: motion ratios and forces.

use crate::kinematics::linkage_motion::{Linkage, LinkageMotion, LinkedPoint, MotionRow};
use crate::kinematics::wheel::WheelParts;
use crate::{ForceElements, SpringForce};
use nalgebra::Vector3;
use percuss_contact::ForceCurve;
use percuss_dynamics::{ElementMotion, Gap, LinearElement, Pose};
use percuss_mechanism::{ContactKind, ContactNormal, JointId, LinkId, Mechanism, NamedContact};

/// Spring, torsion bar, damper or stop.
#[derive(Clone, Debug)]
pub struct ForceElement {
    /// Name without the ending of the side.
    pub name: String,
    /// Ending of the side; empty for a single side and for an element of both sides.
    pub side: &'static str,
    /// True if the element belongs to both wheels of an axle.
    pub is_shared: bool,
    acting: Acting,
    /// Force of a spring, if the sheet states it; of a torsion bar its rate (N·m/rad) and moment (N·m).
    pub spring: Option<SpringForce>,
    /// Force of a stop, if the sheet states it.
    pub stop: Option<ForceCurve>,
}

/// Place at which an element acts.
#[derive(Clone, Debug)]
enum Acting {
    Points(PointPair),
    /// Hinge of a torsion bar, its position as drawn (rad), and the sign of its rotation in bump; `None`: the hinge is at rest.
    Hinge {
        joint: JointId,
        drawn: f64,
        sign: Option<f64>,
    },
}

/// Two points of a spring, damper or stop.
#[derive(Clone, Debug)]
struct PointPair {
    kind: ContactKind,
    link: LinkId,
    point: Vector3<f64>,
    other: LinkId,
    normal: ContactNormal,
    /// Gap over the pose; `None` for parts that always touch.
    gap: Option<Gap>,
    /// Length as drawn, m, of a spring or damper.
    drawn_length: f64,
}

/// Name of the torsion bar in columns, and its section in a sheet.
const TORSION_BAR: &str = "torsion_bar";

/// Force of an element and its motion ratio at a pose, along a motion with one parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ElementRates {
    /// Compression (of a torsion bar: twist, rad) per parameter, and its derivative with respect to the parameter.
    pub ratio: [f64; 2],
    /// Force, N, or moment of a torsion bar, N·m; positive in compression. `None` if the sheet does not state the force.
    pub force: Option<f64>,
    /// Rate of the force with the compression, N/m or N·m/rad.
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
        let mut pair = PointPair {
            kind,
            link: contact.link(),
            point: *contact.point(),
            other,
            normal: *contact.normal(),
            gap: Gap::new(drawn, contact),
            drawn_length: 0.0,
        };
        let [(_, from), (_, to)] = pair.ends(drawn);
        pair.drawn_length = (to - from).norm();
        Some(ForceElement {
            side: side.unwrap_or_default(),
            is_shared: side.is_none(),
            acting: Acting::Points(pair),
            spring: forces.springs.iter().find(|(section, _)| *section == name).map(|(_, spring)| *spring),
            stop: forces.stops.iter().find(|(section, _)| *section == name).map(|(_, stop)| stop.clone()),
            name,
        })
    };
    let bar = |wheel: &WheelParts| {
        let bar = forces.torsion_bar.as_ref()?;
        let joint = mechanism.find_joint(&bar.joint(wheel.side)).ok()?;
        let drawn = drawn.joint(joint).first().copied()?;
        Some(ForceElement {
            name: TORSION_BAR.to_owned(),
            side: wheel.side,
            is_shared: false,
            acting: Acting::Hinge { joint, drawn, sign: None },
            spring: Some(SpringForce { rate: bar.rate, preload: bar.preload }),
            stop: None,
        })
    };
    mechanism.contacts().iter().filter_map(element).chain(wheels.iter().filter_map(bar)).collect()
}

impl PointPair {
    /// Points at both ends: on the link, and on the other side. For a fixed normal, both are at the contact point.
    fn ends(&self, pose: &Pose) -> [LinkedPoint; 2] {
        let at = pose.link(self.link).point(&self.point);
        let other = match self.normal {
            ContactNormal::Fixed(_) => at,
            ContactNormal::Toward(point) | ContactNormal::Away(point) => pose.link(self.other).point(&point),
        };
        [(Some(self.link), at), (Some(self.other), other)]
    }

    /// Compression per parameter of the motion, and its derivative.
    fn ratio(&self, pose: &Pose, motion: &LinkageMotion<'_>) -> [f64; 2] {
        let [on_link, on_other] = self.ends(pose);
        match self.normal {
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
        }
    }

    /// Motion that a linear element resists. A point 1 m along a fixed normal has the same rate of distance.
    fn element_motion(&self, pose: &Pose) -> ElementMotion {
        let other = match self.normal {
            ContactNormal::Fixed(normal) => {
                let at = pose.link(self.link).point(&self.point) - pose.link(self.other).vector(&normal);
                pose.link(self.other).inverse_point(&at)
            }
            ContactNormal::Toward(point) | ContactNormal::Away(point) => point,
        };
        ElementMotion::Length([(self.link, self.point), (self.other, other)])
    }
}

impl ForceElement {
    /// True for a spring or a torsion bar.
    pub(super) fn is_spring(&self) -> bool {
        match &self.acting {
            Acting::Points(pair) => pair.kind == ContactKind::Spring,
            Acting::Hinge { .. } => true,
        }
    }

    /// True for a spring or damper, whose line turns with the mechanism.
    pub(super) fn is_line(&self) -> bool {
        matches!(&self.acting, Acting::Points(pair) if matches!(pair.kind, ContactKind::Spring | ContactKind::Damper))
    }

    /// True for a torsion bar: its compression is an angle, its force a moment.
    pub(super) fn is_torsion_bar(&self) -> bool {
        matches!(self.acting, Acting::Hinge { .. })
    }

    /// Sets the sign of the rotation of a torsion bar in bump: that of the motion, with all wheels up.
    pub(super) fn orient(&mut self, pose: &Pose, bump: &LinkageMotion<'_>) {
        if let Acting::Hinge { joint, sign, .. } = &mut self.acting {
            let rate = bump.hinge_rates(pose, *joint)[0];
            *sign = (rate != 0.0).then(|| rate.signum());
        }
    }

    /// Sign of the rotation of a torsion bar in bump; `None` for other elements.
    pub(super) fn sign(&self) -> Option<f64> {
        if let Acting::Hinge { sign, .. } = self.acting { sign } else { None }
    }

    /// Condition that keeps the length of a spring or damper, or the twist of a torsion bar; `None` for a stop.
    pub(super) fn hold(&self, linkage: &Linkage, pose: &Pose) -> Option<MotionRow> {
        match &self.acting {
            Acting::Points(pair) => {
                let [first, second] = pair.ends(pose);
                self.is_line().then(|| linkage.distance_row(first, second))
            }
            Acting::Hinge { joint, .. } => {
                let joint = pose.mechanism().joint(*joint);
                let axis = pose.link(joint.child()).vector(joint.axis());
                Some(linkage.turn_row(joint.parent(), joint.child(), axis))
            }
        }
    }

    /// Spring with a rate or touched stop, with its rate at a pose; `None` for other elements.
    pub(super) fn as_linear(&self, pose: &Pose) -> Option<LinearElement> {
        let (force, rate) = self.force(pose);
        let stiffness = rate.filter(|rate| *rate > 0.0)?;
        let name = format!("{}{}", self.name, self.side);
        let force = force.unwrap_or(0.0);
        let (motion, force) = match &self.acting {
            Acting::Points(pair) => (pair.element_motion(pose), force),
            Acting::Hinge { joint, sign, .. } => {
                (ElementMotion::Twist(*joint, None), -sign.unwrap_or(1.0) * force)
            }
        };
        Some(LinearElement { force, ..LinearElement::spring(name, motion, stiffness) })
    }

    /// Force (N, positive in compression) and its rate with the compression (N/m) at a pose, if the sheet states them; moment (N·m) and rate
    /// (N·m/rad) of a torsion bar.
    fn force(&self, pose: &Pose) -> (Option<f64>, Option<f64>) {
        match (&self.spring, &self.stop) {
            (Some(spring), _) => {
                let compression = match &self.acting {
                    Acting::Points(pair) => {
                        let [(_, on_link), (_, on_other)] = pair.ends(pose);
                        pair.drawn_length - (on_other - on_link).norm()
                    }
                    Acting::Hinge { joint, drawn, sign } => {
                        sign.unwrap_or(1.0) * (pose.joint(*joint)[0] - drawn)
                    }
                };
                (spring.preload.map(|preload| preload + spring.rate * compression), Some(spring.rate))
            }
            (None, Some(stop)) => {
                let gap = if let Acting::Points(pair) = &self.acting { pair.gap.as_ref() } else { None };
                let (force, slope) = stop.at(gap.map_or(0.0, |gap| -gap.at(pose)));
                (Some(force), Some(slope))
            }
            (None, None) => (None, None),
        }
    }

    /// Motion ratio and force at a pose.
    pub(super) fn rates(&self, pose: &Pose, motion: &LinkageMotion<'_>) -> ElementRates {
        let ratio = match &self.acting {
            Acting::Points(pair) => pair.ratio(pose, motion),
            Acting::Hinge { joint, sign, .. } => {
                motion.hinge_rates(pose, *joint).map(|rate| sign.unwrap_or(1.0) * rate)
            }
        };
        let (force, rate) = self.force(pose);
        ElementRates { ratio, force, rate }
    }
}
