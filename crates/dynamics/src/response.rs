//! The contact response: effective mass, the motion at unit closing speed, and the contribution of each link.

use crate::assembly::Assembly;
use crate::careful::Minimum;
use crate::closing_speed::closing_floor;
use crate::contact::{Contact, ContactError, LocatedContact};
use crate::error_budget::ErrorBudget;
use crate::outcome::{CarefulReason, EffectiveMass, Remark, ResponseError, Route, RouteChoice, RouteError};
use crate::pose::Pose;
use crate::recursion::Decisions;
use crate::remarks::RemarkFlags;
use crate::routes::{Found, Question, RecursionRoom};
use crate::tolerances::{FILE_MISFITS, IMMOVABLE, LEAST_OTHER_MASS, NEARLY_IMMOVABLE, SAME_BOTH_WAYS};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::Twist;

/// The answer to a contact at a pose.
#[derive(Clone, Debug)]
pub struct ContactResponse {
    /// m̄, or why it is not finite.
    pub effective_mass: EffectiveMass,
    /// How it was computed.
    pub route: Route,
    /// Why the careful route was asked beside the recursion; none where it was not, or a route was asked for. The answer
    /// is the recursion's all the same where the careful route had none better.
    pub careful_reason: Option<CarefulReason>,
    /// Whether the recursion's m̄ was held to the stationary value of its energy, where its pivots add up too much.
    pub held_to_energy: bool,
    /// What m̄ may be off by, kg; none unless finite.
    pub error: Option<ErrorBudget>,
    /// dim ker A at the pose; a floating base's 6 included.
    pub degrees_of_freedom: usize,
    /// Whether the constraints have less than their generic rank here: branches cross, and m̄ is a lower bound that no
    /// branch attains.
    pub singular_pose: bool,
    /// What the reader should know.
    pub remarks: Vec<Remark>,
    /// The contact at the pose.
    pub contact: LocatedContact,
    /// v*: every joint's velocities at unit closing speed, in joint order (layouts of `JointKind`).
    pub joint_velocities: Vec<Vec<f64>>,
    /// v* of the root link in its own axes at its origin; zero where it is the ground.
    pub base_velocity: Twist<f64>,
    /// Contribution of each link; together with the rotors' and the other mass's, 1. None unless finite.
    pub contributions: Option<Contributions>,
}

/// Contributions to the effective mass: parts of twice the kinetic energy at unit closing speed, divided by m̄.
#[derive(Clone, Debug, PartialEq)]
pub struct Contributions {
    /// One for each link, in link order.
    pub links: Vec<f64>,
    /// Armatures, where a joint has any.
    pub rotors: Vec<(JointId, f64)>,
    /// The other body, where it was given as a number.
    pub other_mass: Option<f64>,
}

impl ContactResponse {
    /// Whether the mechanism itself gives way: v* is not zero.
    pub fn gives_way(&self) -> bool {
        self.joint_velocities.iter().flatten().any(|v| *v != 0.0)
            || self.base_velocity.linear.norm() > 0.0
            || self.base_velocity.angular.norm() > 0.0
    }

    /// The kinds of [`remarks`](Self::remarks), with [`RemarkFlags::SINGULAR_POSE`] where the pose is singular.
    pub fn remark_flags(&self) -> RemarkFlags {
        let singular = if self.singular_pose { RemarkFlags::SINGULAR_POSE } else { RemarkFlags::NONE };
        self.remarks.iter().collect::<RemarkFlags>() | singular
    }

    /// What m̄ may be off by as far as that is known, kg: [`ErrorBudget::known`]. What a file's figures are off by is in it
    /// only where redundant rows show it.
    pub fn effective_mass_error(&self) -> Option<f64> {
        self.error.and_then(|error| error.known())
    }

    /// The same where the other side is a free mass (kg) of its own: 1/m̄ = 1/m̄₁ + 1/m₂.
    ///
    /// An immovable mechanism leaves m̄ = m₂; a massless one stays massless.
    ///
    /// # Errors
    /// [`ContactError::OtherMass`]: not finite, or not above 1e-100 kg.
    pub fn against_mass(mut self, other: f64) -> Result<Self, ContactError> {
        if !(other.is_finite() && other > LEAST_OTHER_MASS) {
            return Err(ContactError::OtherMass { mass: other, least: LEAST_OTHER_MASS });
        }
        let together = self.effective_mass.against_mass(Some(other));
        let (m, factor) = match (self.effective_mass, together) {
            (EffectiveMass::Finite(own), EffectiveMass::Finite(m)) => (m, m / own),
            (EffectiveMass::Immovable, EffectiveMass::Finite(m)) => (m, 0.0),
            _ => return Ok(self),
        };
        self.effective_mass = together;
        // dm̄ = (m̄/m̄₁)² dm̄₁; the other mass is taken as exact, but for one rounding.
        let rounding = ErrorBudget { rounding: Some(0.0), closing: Some(0.0), file: None };
        let own = self.error.unwrap_or(rounding).scaled(factor * factor);
        self.error = Some(ErrorBudget { rounding: own.rounding.map(|r| r + 4.0 * f64::EPSILON * m), ..own });
        self.joint_velocities.iter_mut().flatten().for_each(|v| *v *= factor);
        self.base_velocity = self.base_velocity * factor;
        let zero = || Contributions { links: vec![], rotors: vec![], other_mass: None };
        let mut contributions = self.contributions.take().unwrap_or_else(zero);
        contributions.links.iter_mut().for_each(|s| *s *= factor);
        contributions.rotors.iter_mut().for_each(|(_, s)| *s *= factor);
        contributions.other_mass = Some(m / other);
        self.contributions = Some(contributions);
        Ok(self)
    }
}

impl Pose {
    /// Effective mass of a contact along its normal, in kilograms, with all that goes with it.
    ///
    /// m̄ = min { vᵀMv : Av = 0, jv = 1 }; 1/(j M⁻¹ jᵀ) where M is regular and nothing closes a loop.
    ///
    /// | symbol | meaning                        | shape | unit            |
    /// |--------|--------------------------------|-------|-----------------|
    /// | M      | joint-space mass matrix        | n×n   | kg, kg·m, kg·m² |
    /// | A      | Jacobian of the constraints    | m×n   | m, 1            |
    /// | j      | closing speed per joint rate   | 1×n   | m, 1            |
    ///
    /// A gap that no admissible motion can close is `Immovable`, not infinity; one that closes without energy is
    /// `Massless`. Cost: O(n) by the recursion over clusters, O(n³) by the careful route, which is asked where the
    /// recursion may be off by more than 1e-11.
    /// Source: Khatib 1987, §IV; Featherstone 2008, §7.3 and §8.
    ///
    /// # Errors
    /// [`ResponseError`]: a contact that means nothing; a route that was asked for and does not take the mechanism.
    pub fn respond(&self, contact: &Contact, choice: RouteChoice) -> Result<ContactResponse, ResponseError> {
        let located = self.locate(contact)?;
        let room = self.assembly.rooms().take(self.assembly.model());
        let mut asked = Asked { pose: self, contact, located: &located, room };
        let answer = asked.answer(choice);
        self.assembly.rooms().put(asked.room);
        Ok(answer?)
    }

    fn question<'a>(&'a self, located: &'a LocatedContact) -> Question<'a> {
        Question {
            model: self.assembly.model(),
            kinematics: &self.kinematics,
            groups: &self.groups,
            misfits: self.assembly.misfits(),
            located,
        }
    }
}

/// A contact at a pose, and the room that its routes ran in.
struct Asked<'a> {
    pose: &'a Pose,
    contact: &'a Contact,
    located: &'a LocatedContact,
    room: RecursionRoom,
}

impl Asked<'_> {
    fn answer(&mut self, choice: RouteChoice) -> Result<ContactResponse, RouteError> {
        let question = self.pose.question(self.located);
        question.model.refuse_large_clusters::<f64>(&self.pose.groups)?;
        question.run(&mut self.room);
        let found = question.answer(&mut self.room, choice)?;
        let up_to = question.massless_to_rounding(&self.room, found.mass);
        let mut response = self.finish(found);
        response.remarks.extend(up_to.map(|up_to| Remark::MasslessToRounding { up_to }));
        Ok(response)
    }

    fn finish(&mut self, mut found: Found) -> ContactResponse {
        let pose = self.pose;
        let model = pose.assembly.model();
        let rank = pose.rank();
        let mut remarks = std::mem::take(&mut found.remarks);
        remarks.extend(pose.remarks());
        remarks.extend(pose.assembly.base_remark(self.contact, pose.base_is_given));
        let mut error = None;
        let mut contributions = None;
        if let EffectiveMass::Finite(m) = found.mass {
            contributions = Some(self.contributions(&found.velocities, m));
            error = Some(self.budget(m, &found));
            // What loops that do not quite fit leave of a closing speed may be all of it.
            let floor = closing_floor(model, &pose.groups, &self.room.row);
            if found.closing_speed < NEARLY_IMMOVABLE.max(floor) {
                let open = if floor > IMMOVABLE { floor } else { 2.0 * f64::EPSILON };
                let uncertainty = open / found.closing_speed;
                remarks.push(Remark::NearlyImmovable { closing_speed: found.closing_speed, uncertainty });
            }
        }
        if let Some(gap) = rank.gap.filter(|_| !rank.clear) {
            remarks.push(Remark::UnclearRank { gap });
        }
        let mut joint_velocities: Vec<Vec<f64>> =
            model.mechanism.joints().iter().map(|j| vec![0.0; j.kind().dofs()]).collect();
        let mut base_velocity = Twist::zero();
        for body in model.bodies.iter().filter(|b| !b.v.is_empty()) {
            let v = &found.velocities[body.v.clone()];
            match body.joint {
                Some(id) => joint_velocities[id.index()].copy_from_slice(v),
                None => {
                    base_velocity =
                        Twist::new(Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]));
                }
            }
        }
        ContactResponse {
            effective_mass: found.mass,
            route: found.route,
            careful_reason: found.careful_reason,
            held_to_energy: found.route == Route::Articulated && found.errors.stationary.is_some(),
            error,
            degrees_of_freedom: model.coordinates.len() - rank.rank,
            singular_pose: rank.singular,
            remarks,
            contact: *self.located,
            joint_velocities,
            base_velocity,
            contributions,
        }
    }

    fn budget(&mut self, m: f64, found: &Found) -> ErrorBudget {
        let (closing_speed, errors) = (found.closing_speed, &found.errors);
        let own = errors.rounding + 2.0 * f64::EPSILON / closing_speed;
        if self.pose.loops().is_none() {
            return ErrorBudget { rounding: Some(m * own), closing: Some(0.0), file: None };
        }
        // The rows of an inexact file are off by as much as its frames are; so is the closing speed that m̄ goes by.
        let file = FILE_MISFITS * (errors.file + errors.misfit / closing_speed);
        let closing = self.closing_error(m, found).map(|c| m * c);
        ErrorBudget { rounding: Some(m * own), closing, file: errors.is_measured.then_some(m * file) }
    }

    /// Relative change of m̄ between the pose and where it may be, as far as its loops are from closed; none where that
    /// cannot be found. Asked by what answered: a route, or the energy.
    fn closing_error(&mut self, m: f64, found: &Found) -> Option<f64> {
        let assembly: &Assembly = &self.pose.assembly;
        let mut most = 0.0_f64;
        for sign in [1.0, -1.0] {
            let moved = assembly.doubtful_pose(self.pose, sign)?;
            let groups = self.pose.groups_beside(&moved);
            let model = assembly.model();
            let located = model.locate(&moved, self.pose.base(), self.contact).ok()?;
            let beside = Question {
                model,
                kinematics: &moved,
                groups: &groups,
                misfits: assembly.misfits(),
                located: &located,
            };
            let other = match found.route {
                Route::Articulated => {
                    beside.eliminate(&mut self.room);
                    let EffectiveMass::Finite(own) = self.room.mass() else { return None };
                    let by_energy =
                        found.errors.stationary.and_then(|_| beside.response_by_energy(&mut self.room));
                    by_energy.map_or(own, |response| 1.0 / response)
                }
                Route::Dense => match model.least_energy(&moved, &groups, &located).minimum {
                    Minimum::Finite(other) | Minimum::Stationary(other) => other,
                    Minimum::Immovable | Minimum::Massless => return None,
                },
            };
            let change = (other / m - 1.0).abs();
            most = most.max(change);
            if change < SAME_BOTH_WAYS {
                // Far from a singularity both ways are alike.
                break;
            }
        }
        Some(most)
    }

    /// Parts of twice the energy of the tree velocities `v`, divided by `m` (the formula's, so that their sum is a
    /// check).
    fn contributions(&self, v: &[f64], m: f64) -> Contributions {
        let (model, kinematics) = (self.pose.assembly.model(), &self.pose.kinematics);
        let mut motions = vec![Twist::zero(); model.bodies.len()];
        let mut rotors = Vec::new();
        for (i, body) in model.bodies.iter().enumerate() {
            let mut motion =
                body.parent.map_or_else(Twist::zero, |p| kinematics.steps[i].inverse_twist(&motions[p]));
            let mut rotor = 0.0;
            for (k, index) in body.v.clone().enumerate() {
                motion += kinematics.column(model, i, k) * v[index];
                rotor += body.armature[k] * v[index] * v[index];
            }
            motions[i] = motion;
            if let Some(id) = body.joint
                && body.armature.iter().any(|a| *a > 0.0)
            {
                rotors.push((id, rotor / m));
            }
        }
        let energy = |link: LinkId| {
            let on = &model.link_frames[link.index()];
            let motion = on.body.map_or_else(Twist::zero, |b| on.frame.inverse_twist(&motions[b]));
            model.mechanism.link(link).inertia().twice_energy(&motion) / m
        };
        rotors.sort_by_key(|(id, _)| *id);
        Contributions { links: model.mechanism.link_ids().map(energy).collect(), rotors, other_mass: None }
    }
}

impl Pose {
    /// What the recursion decides at this pose for a contact: pivots that duals and lanes follow.
    ///
    /// # Errors
    /// Where it has no 1/m̄: a motion of negative mass, or one without mass that closes the gap.
    pub(crate) fn decisions(&self, located: &LocatedContact) -> Result<Decisions, RouteError> {
        let mut room = RecursionRoom::new(self.assembly.model());
        let question = self.question(located);
        question.run(&mut room);
        if room.deciding.indefinite {
            return Err(RouteError::Indefinite);
        }
        match question.recursive_mass(&mut room) {
            EffectiveMass::Massless => Err(RouteError::MasslessMotion),
            EffectiveMass::Finite(_) | EffectiveMass::Immovable => Ok(room.deciding.decisions),
        }
    }
}
