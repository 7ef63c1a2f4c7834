//! Friction of an impact of a mechanism.

use crate::error::ImpactError;
use crate::friction::collision::frictional_collision;
use crate::friction::one_motion::OneMotion;
use crate::friction::phases::{Phase, PhaseKind, RestitutionLaw, add_phase};
use crate::friction::rounding::resolved_velocity;
use crate::friction::thresholds::{FrictionThresholds, check_contact_point, contact_mobility};
use crate::motion::joint_rates::JointRates;
use crate::reactions::reaction::Reactions;
use crate::reactions::reaction_map::ReactionMap;
use crate::tolerances::{CREATED_ENERGY, SAME_DIRECTION};
use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{Contact, ContactResponse, Direction, EffectiveMass, Frame, Pose};

/// Coulomb friction of an impact.
///
/// At a contact of one relative motion, such as the stop of a suspension, the point moves along one direction only: at unit closing speed
/// it slides with t = |J_t v*|, and it sticks only if it stops. Then, with the energetic restitution e:
///
/// | quantity               | equation                                        | unit |
/// |------------------------|-------------------------------------------------|------|
/// | normal impulse         | p = m̄ c [1/(1+µt) + e/√(1−µ²t²)]                | N·s  |
/// | kinematic restitution  | e √((1−µt)/(1+µt)); 0 if wedged                 | 1    |
/// | wedging                | µt ≥ 1: no rebound, p = m̄ c/(1+µt)              | –    |
///
/// All other contacts: [`frictional_collision`]. Derived from the energetic restitution of Stronge 1990.
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    /// µ: coefficient of friction.
    pub coefficient: f64,
    /// Meaning of the coefficient of restitution.
    pub law: RestitutionLaw,
    /// Coefficients of friction at which the behaviour changes.
    pub thresholds: FrictionThresholds,
    /// The contact sticks and does not rebound; µt ≥ 1 for one relative motion.
    pub is_wedged: bool,
    /// Separation speed divided by closing speed.
    pub kinematic_restitution: f64,
    /// Impulse of the friction on the contact link, N·s, in the link's axes.
    pub tangential_impulse: Vector3<f64>,
    /// Sliding velocity of the contact link against the other side before the impact, m/s, in the link's axes.
    pub sliding_before: Vector3<f64>,
    /// Sliding velocity after the impact, m/s, in the link's axes.
    pub sliding_after: Vector3<f64>,
    /// Phases of the impact in order.
    pub phases: Vec<Phase>,
    /// Compression phase, by the energetic law.
    pub compression: FrictionalCompression,
    /// Results of all laws of restitution with the same e.
    pub laws: Vec<LawResult>,
}

/// Compression of an impact with friction, from the touch to the end of the closing motion.
///
/// The normal force is largest in compression. Let W be the work of the normal force in compression, c the closing speed and U(δ) the
/// energy of the contact spring. At constant pose and with little damping, U(δ) = W determines the largest penetration δ. A frictionless
/// contact of the mass 2W/c² has the same W, and therefore the same peak normal force. If the point sticks, or slides in one direction,
/// during the whole compression, the contact force has the direction of its impulse.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionalCompression {
    /// Normal impulse, N·s.
    pub normal_impulse: f64,
    /// Impulse of the friction on the contact link, N·s, in the link's axes.
    pub tangential_impulse: Vector3<f64>,
    /// Mass 2W/c² of a frictionless contact with the same work W of compression, kg; m̄/(1+µt) for one relative motion.
    pub equivalent_mass: f64,
    /// True if the contact force has a constant direction: in the whole compression the point sticks, or slides in one direction.
    pub has_constant_direction: bool,
    /// Reactions to the impulse of compression.
    pub reactions: Reactions,
}

/// Result of one law of restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawResult {
    /// The law.
    pub law: RestitutionLaw,
    /// Normal impulse, N·s; all values are NaN if the law has no solution.
    pub normal_impulse: f64,
    /// Magnitude of the friction, N·s.
    pub tangential_impulse: f64,
    /// Separation speed, m/s.
    pub separation_speed: f64,
    /// Lost kinetic energy, J; negative if the law creates energy.
    pub energy_loss: f64,
    /// True if the law creates energy: it is not valid here.
    pub creates_energy: bool,
}

/// Impulse of an impact with friction, and its direction.
pub(crate) struct FrictionalImpulse {
    pub friction: Friction,
    /// Normal impulse, N·s.
    pub normal: f64,
    /// Lost kinetic energy, J.
    pub energy_loss: f64,
    /// Magnitude of the whole impulse, N·s.
    pub total: f64,
    /// Response of the contact along the whole impulse.
    pub response: ContactResponse,
    /// Change of the rates.
    pub change: JointRates,
}

/// Coefficient of friction, and meaning of the restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionLaw {
    /// µ: coefficient of friction.
    pub coefficient: f64,
    /// Meaning of the coefficient of restitution.
    pub restitution: RestitutionLaw,
}

/// Impulse of an impact with friction at the closing speed `speed` (m/s), with the rates `before`.
///
/// # Errors
/// [`ImpactError`]: a coefficient of friction out of range; a motion without mass; an impact without an end.
pub(crate) fn frictional_impulse(
    pose: &Pose,
    map: &ReactionMap,
    response: &ContactResponse,
    speed: f64,
    restitution: f64,
    law: FrictionLaw,
    before: &JointRates,
) -> Result<FrictionalImpulse, ImpactError> {
    let coefficient = law.coefficient;
    if !(coefficient.is_finite() && coefficient >= 0.0) {
        return Err(ImpactError::Friction { got: coefficient });
    }
    check_contact_point(response)?;
    match OneMotion::new(pose, response) {
        Some(motion) => one_motion_impulse(pose, map, response, &motion, speed, restitution, law),
        None => general_impulse(pose, map, response, speed, restitution, law, before),
    }
}

/// Contact of one relative motion.
fn one_motion_impulse(
    pose: &Pose,
    map: &ReactionMap,
    response: &ContactResponse,
    motion: &OneMotion,
    speed: f64,
    restitution: f64,
    law: FrictionLaw,
) -> Result<FrictionalImpulse, ImpactError> {
    let loss = |kinematic: f64| 0.5 * motion.mass * speed * speed * (1.0 - kinematic * kinematic);
    let all = RestitutionLaw::ALL.map(|law_of| {
        let found = motion.impact(speed, restitution, law.coefficient, law_of);
        law_result(
            law_of,
            found.impulses[0] + found.impulses[1],
            (found.frictions[0] + found.frictions[1]).abs(),
            found.kinematic_restitution * speed,
            loss(found.kinematic_restitution),
            loss(0.0),
        )
    });
    let found = motion.impact(speed, restitution, law.coefficient, law.restitution);
    let tangential_impulse = motion.direction * (found.frictions[0] + found.frictions[1]);
    let mut phases = Vec::new();
    if law.restitution != RestitutionLaw::Algebraic {
        let kinds = match motion.slope > 0.0 {
            true => [PhaseKind::Slip, PhaseKind::ReverseSlip],
            false => [PhaseKind::Stick; 2],
        };
        add_phase(&mut phases, kinds[0], false, found.impulses[0]);
        add_phase(&mut phases, kinds[1], true, found.impulses[1]);
    }
    let closing = motion.impact(speed, 0.0, law.coefficient, RestitutionLaw::Energetic);
    let compression = FrictionalCompression {
        normal_impulse: closing.impulses[0],
        tangential_impulse: motion.direction * closing.frictions[0],
        // The closing speed decreases linearly with the impulse p, so W = p c / 2 and 2W/c² = p/c.
        equivalent_mass: closing.impulses[0] / speed,
        has_constant_direction: true,
        reactions: reactions_to(
            pose,
            map,
            response,
            closing.impulses[0],
            &(motion.direction * closing.frictions[0]),
        )?,
    };
    let friction = Friction {
        coefficient: law.coefficient,
        law: law.restitution,
        thresholds: FrictionThresholds::of_one_motion(motion),
        is_wedged: found.is_wedged,
        kinematic_restitution: found.kinematic_restitution,
        tangential_impulse,
        sliding_before: motion.direction * (motion.slope * speed),
        sliding_after: motion.direction * (-motion.slope * speed * found.kinematic_restitution),
        phases,
        compression,
        laws: all.to_vec(),
    };
    let normal = found.impulses[0] + found.impulses[1];
    let (total, whole) = whole_response(pose, response, normal, &tangential_impulse)?;
    let star = JointRates { joints: response.joint_velocities.clone(), base: response.base_velocity };
    let rest = JointRates::at_rest(pose.mechanism());
    Ok(FrictionalImpulse {
        normal,
        energy_loss: loss(found.kinematic_restitution),
        total,
        response: whole,
        change: rest.plus_scaled(&star, -(1.0 + found.kinematic_restitution) * speed),
        friction,
    })
}

/// Contact with several relative motions.
fn general_impulse(
    pose: &Pose,
    map: &ReactionMap,
    response: &ContactResponse,
    speed: f64,
    restitution: f64,
    law: FrictionLaw,
    before: &JointRates,
) -> Result<FrictionalImpulse, ImpactError> {
    let contact = &response.contact;
    let delassus = contact_mobility(pose, response)?;
    let velocities = delassus.velocities(pose, before);
    let mobility = delassus.block(0);
    let velocity = resolved_velocity(&Vector3::new(-speed, velocities[1], velocities[2]));
    let solve = |law_of| frictional_collision(&mobility, &velocity, law.coefficient, restitution, law_of);
    let size = 0.5 * speed * speed / mobility[(0, 0)];
    let all = RestitutionLaw::ALL.map(|law_of| match solve(law_of) {
        Ok(found) => law_result(
            law_of,
            found.impulse[0],
            found.impulse[1].hypot(found.impulse[2]),
            found.after[0],
            -found.energy_change,
            size,
        ),
        Err(_) => law_result(law_of, f64::NAN, f64::NAN, f64::NAN, f64::NAN, size),
    });
    let found = solve(law.restitution)?;
    let own = pose.link_in_root(contact.link);
    let axes: &Matrix3<f64> = delassus.axes(0);
    let in_link = |v: &Vector3<f64>| own.inverse_vector(&(axes * Vector3::new(0.0, v[1], v[2])));
    let tangential_impulse = in_link(&found.impulse);
    let (total, whole) = whole_response(pose, response, found.impulse[0], &tangential_impulse)?;
    let star = JointRates { joints: whole.joint_velocities.clone(), base: whole.base_velocity };
    let factor = match whole.effective_mass {
        EffectiveMass::Finite(mass) => -total / mass,
        _ => 0.0,
    };
    let closing =
        frictional_collision(&mobility, &velocity, law.coefficient, 0.0, RestitutionLaw::Energetic)?;
    let friction_of_closing = in_link(&closing.impulse);
    // If the sliding direction turns, the impulse of the friction is smaller than µ times the normal impulse.
    let limit = law.coefficient * closing.impulse[0];
    let is_full = closing.impulse[1].hypot(closing.impulse[2]) >= limit * (1.0 - SAME_DIRECTION);
    let compression = FrictionalCompression {
        normal_impulse: closing.impulse[0],
        tangential_impulse: friction_of_closing,
        equivalent_mass: -2.0 * closing.normal_work[0] / (speed * speed),
        has_constant_direction: match &closing.phases[..] {
            [phase] => phase.kind == PhaseKind::Stick || is_full,
            _ => false,
        },
        reactions: reactions_to(pose, map, response, closing.impulse[0], &friction_of_closing)?,
    };
    let friction = Friction {
        coefficient: law.coefficient,
        law: law.restitution,
        thresholds: FrictionThresholds::of_mobility(&mobility),
        is_wedged: found.is_wedged,
        kinematic_restitution: found.after[0] / speed,
        tangential_impulse,
        sliding_before: in_link(&velocity),
        sliding_after: in_link(&found.after),
        phases: found.phases,
        compression,
        laws: all.to_vec(),
    };
    Ok(FrictionalImpulse {
        friction,
        normal: found.impulse[0],
        energy_loss: -found.energy_change,
        total,
        change: JointRates::at_rest(pose.mechanism()).plus_scaled(&star, factor),
        response: whole,
    })
}

/// Result of a law. `size`: energy of the closing motion.
fn law_result(
    law: RestitutionLaw,
    normal_impulse: f64,
    tangential_impulse: f64,
    separation_speed: f64,
    energy_loss: f64,
    size: f64,
) -> LawResult {
    let creates_energy = energy_loss < -CREATED_ENERGY * size;
    LawResult { law, normal_impulse, tangential_impulse, separation_speed, energy_loss, creates_energy }
}

/// Reactions to a normal impulse and an impulse of friction. `tangential`: friction on the contact link, in its axes.
fn reactions_to(
    pose: &Pose,
    map: &ReactionMap,
    response: &ContactResponse,
    normal: f64,
    tangential: &Vector3<f64>,
) -> Result<Reactions, ImpactError> {
    let (total, whole) = whole_response(pose, response, normal, tangential)?;
    Ok(map.reactions(&whole, total)?)
}

/// Magnitude of the whole impulse, and the response of the mechanism along it. `tangential`: friction on the contact link, in
/// its axes.
fn whole_response(
    pose: &Pose,
    response: &ContactResponse,
    normal: f64,
    tangential: &Vector3<f64>,
) -> Result<(f64, ContactResponse), ImpactError> {
    let contact = &response.contact;
    let impulse = contact.normal_link * normal - tangential;
    let whole = Contact {
        link: contact.link,
        against: contact.against,
        point: contact.point_link,
        normal: Direction::Along(impulse, Frame::Link),
    };
    let found = pose.respond(&whole).map_err(|_| ImpactError::Immovable)?;
    Ok((impulse.norm(), found))
}
