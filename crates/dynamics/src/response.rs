//! The contact response: effective mass, the motion at unit closing speed, and the contribution of each link.

use crate::assembly::Assembly;
use crate::careful::{Minimum, Solution};
use crate::closing_speed::{ClosingRoom, closing_floor, relative_closing_speed};
use crate::contact::{Contact, LocatedContact};
use crate::error_budget::{ErrorBudget, RelativeErrors, UnitImpulse};
use crate::kinematics::Kinematics;
use crate::mobility::GroupMobility;
use crate::model::Model;
use crate::outcome::{EffectiveMass, Remark, ResponseError, Route, RouteChoice, RouteError};
use crate::pose::Pose;
use crate::recursion::{Deciding, Decisions, Recursion};
use crate::tolerances::{CAREFUL_LIMIT, IMMOVABLE, NEARLY_IMMOVABLE, TRUSTED_ERROR};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::{Twist, Wrench};

/// The answer to a contact at a pose.
#[derive(Clone, Debug)]
pub struct ContactResponse {
    /// m̄, or why it is not finite.
    pub effective_mass: EffectiveMass,
    /// How it was computed.
    pub route: Route,
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

    /// What m̄ may be off by as far as that is known, kg: [`ErrorBudget::known`]. What a file's figures are off by is in it
    /// only where redundant rows show it.
    pub fn effective_mass_error(&self) -> Option<f64> {
        self.error.and_then(|error| error.known())
    }

    /// The same where the other side is a free mass (kg) of its own: 1/m̄ = 1/m̄₁ + 1/m₂.
    ///
    /// An immovable mechanism leaves m̄ = m₂; a massless one stays massless. `other` must be finite and > 0.
    pub fn against_mass(mut self, other: f64) -> Self {
        let (m, factor) = match self.effective_mass {
            EffectiveMass::Finite(own) => {
                let m = own / (1.0 + own / other);
                (m, m / own)
            }
            EffectiveMass::Immovable => (other, 0.0),
            EffectiveMass::Massless => return self,
        };
        self.effective_mass = EffectiveMass::Finite(m);
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
        self
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
        let question = Question { pose: self, model: self.assembly.model(), contact, located: &located };
        Ok(question.answer(choice)?)
    }
}

/// A contact at a pose.
struct Question<'a> {
    pose: &'a Pose,
    model: &'a Model,
    contact: &'a Contact,
    located: &'a LocatedContact,
}

/// What a route found.
struct Found {
    mass: EffectiveMass,
    route: Route,
    closing_speed: f64,
    /// Relative.
    errors: RelativeErrors,
    /// v* over the tree's velocities.
    velocities: Vec<f64>,
    remarks: Vec<Remark>,
}

/// The recursion after it ran at some frames.
struct Ran {
    recursion: Recursion<f64, 1>,
    deciding: Deciding<1>,
    closing_speed: f64,
}

impl Ran {
    fn mass(&self) -> EffectiveMass {
        let response = self.recursion.response(0, 0);
        if self.closing_speed <= IMMOVABLE {
            EffectiveMass::Immovable
        } else if self.deciding.massless[0] || response.is_nan() || response <= 0.0 {
            EffectiveMass::Massless
        } else {
            EffectiveMass::Finite(1.0 / response)
        }
    }
}

impl Question<'_> {
    fn answer(&self, choice: RouteChoice) -> Result<ContactResponse, RouteError> {
        let ran = self.run(&self.pose.kinematics, &self.pose.groups, self.located);
        let found = match choice {
            RouteChoice::Only(Route::Dense) => self.careful(&ran)?,
            RouteChoice::Only(Route::Articulated) if ran.deciding.indefinite => {
                return Err(RouteError::Indefinite);
            }
            RouteChoice::Only(Route::Articulated) => self.recursive(&ran),
            RouteChoice::Auto if ran.deciding.indefinite => self.careful(&ran)?,
            RouteChoice::Auto => self.better(&ran),
        };
        let up_to = ran.deciding.massless_to[0];
        let all: f64 = self.model.bodies.iter().map(|b| b.inertia.mass.abs()).sum();
        let mut response = self.finish(found);
        if response.effective_mass == EffectiveMass::Massless && up_to > NEGLIGIBLE * all {
            response.remarks.push(Remark::MasslessToRounding { up_to });
        }
        Ok(response)
    }

    /// The recursion's answer where it is accurate; else the careful route's, if that is better.
    fn better(&self, ran: &Ran) -> Found {
        let recursive = self.recursive(ran);
        let accurate = match recursive.mass {
            EffectiveMass::Finite(_) => recursive.errors.rounding <= TRUSTED_ERROR,
            EffectiveMass::Immovable => true,
            // Zero is claimed against terms that may be large: a second opinion.
            EffectiveMass::Massless => false,
        };
        if accurate {
            return recursive;
        }
        match self.careful(ran) {
            Ok(careful) if recursive.mass == EffectiveMass::Massless => careful,
            // An error that is NaN is beaten by any.
            Ok(careful) if careful.errors.rounding.total_cmp(&recursive.errors.rounding).is_lt() => careful,
            _ => recursive,
        }
    }

    fn run(&self, kinematics: &Kinematics<f64>, groups: &[GroupMobility], located: &LocatedContact) -> Ran {
        let model = self.model;
        let mut recursion = Recursion::new(model);
        let mut deciding = Deciding::new(model);
        let unit = Wrench::new(Vector3::zeros(), located.normal_root);
        recursion.add_wrench(model.body_of(located.link), 0, unit);
        recursion.add_wrench(located.against.and_then(|link| model.body_of(link)), 0, -unit);
        recursion.eliminate(model, kinematics, groups, &located.point_root, &mut deciding);
        let row = model.contact_row(kinematics, located);
        let closing_speed =
            relative_closing_speed(&mut ClosingRoom::default(), model, kinematics, groups, &recursion, &row);
        Ran { recursion, deciding, closing_speed }
    }

    fn recursive(&self, ran: &Ran) -> Found {
        let model = self.model;
        let recursion = &ran.recursion;
        let mut mass = ran.mass();
        let mut velocities = vec![0.0; model.follows.len()];
        let mut twists = vec![Twist::zero(); model.bodies.len()];
        let mut errors = RelativeErrors::default();
        match mass {
            EffectiveMass::Finite(m) => {
                recursion.velocities(model, &self.located.point_root, &mut twists, &mut velocities);
                errors = self.impulse(&twists, &velocities).of_recursion(recursion);
                velocities.iter_mut().for_each(|v| *v *= m);
                if errors.rounding > NOTHING_LEFT {
                    // The energy that is left is rounding.
                    mass = EffectiveMass::Massless;
                }
            }
            EffectiveMass::Massless => {
                let free = ran
                    .deciding
                    .best_free
                    .map(|free| recursion.free_motion(model, &self.located.point_root, free));
                velocities = free.and_then(|free| self.at_unit_speed(free)).unwrap_or(velocities);
            }
            EffectiveMass::Immovable => {}
        }
        let mut remarks = Vec::new();
        if ran.deciding.dropped > 0 {
            remarks.push(Remark::MasslessMotions { directions: ran.deciding.dropped });
            if matches!(mass, EffectiveMass::Finite(_)) {
                remarks.push(Remark::UndeterminedMotion);
            }
        }
        Found {
            mass,
            route: Route::Articulated,
            closing_speed: ran.closing_speed,
            errors,
            velocities,
            remarks,
        }
    }

    /// A motion at unit closing speed; none where it does not close the gap.
    fn at_unit_speed(&self, mut velocities: Vec<f64>) -> Option<Vec<f64>> {
        let row = self.model.contact_row(&self.pose.kinematics, self.located);
        let speed: f64 = row.entries.iter().map(|e| e.value * velocities[e.velocity]).sum();
        velocities.iter_mut().for_each(|v| *v /= speed);
        (speed != 0.0).then_some(velocities)
    }

    fn impulse<'b>(&'b self, twists: &'b [Twist<f64>], velocities: &'b [f64]) -> UnitImpulse<'b> {
        UnitImpulse {
            model: self.model,
            kinematics: &self.pose.kinematics,
            groups: &self.pose.groups,
            misfits: self.pose.assembly.misfits(),
            contact: self.located,
            twists,
            velocities,
        }
    }

    fn careful(&self, ran: &Ran) -> Result<Found, RouteError> {
        let model = self.model;
        // M is formed over the tree's velocities, mimics folded afterwards.
        let coordinates = model.follows.len();
        if coordinates > CAREFUL_LIMIT {
            return Err(RouteError::TooLarge { coordinates, limit: CAREFUL_LIMIT });
        }
        let kinematics = &self.pose.kinematics;
        let solution = model.least_energy(kinematics, &self.pose.groups, self.located);
        let mut remarks = Vec::new();
        if solution.massless_directions > 0 {
            remarks.push(Remark::MasslessMotions { directions: solution.massless_directions });
        }
        let mass = match solution.minimum {
            Minimum::Finite(m) => EffectiveMass::Finite(m),
            Minimum::Immovable => EffectiveMass::Immovable,
            Minimum::Massless => EffectiveMass::Massless,
            Minimum::Stationary(m) if m > 0.0 && m.is_finite() => {
                remarks.push(Remark::IndefiniteMassMatrix);
                EffectiveMass::Finite(m)
            }
            Minimum::Stationary(value) => return Err(RouteError::IndefiniteMass { value }),
        };
        if solution.is_open && matches!(mass, EffectiveMass::Finite(_)) {
            remarks.push(Remark::UndeterminedMotion);
        }
        let velocities = model.expand(&solution.velocity);
        let errors = match mass {
            EffectiveMass::Finite(m) => self.errors_of(ran, &solution, m),
            EffectiveMass::Immovable | EffectiveMass::Massless => RelativeErrors::default(),
        };
        Ok(Found { mass, route: Route::Dense, closing_speed: solution.approach, errors, velocities, remarks })
    }

    /// The careful route's own error, by its motion scaled to a unit impulse.
    fn errors_of(&self, ran: &Ran, solution: &Solution, m: f64) -> RelativeErrors {
        let model = self.model;
        let u: Vec<f64> = solution.velocity.iter().map(|v| v / m).collect();
        let velocities = model.expand(&u);
        let twists = self.twists(&velocities);
        let sizes = model.mass_sizes(&self.pose.kinematics);
        self.impulse(&twists, &velocities).of_least_energy(&ran.recursion, &sizes, &u, 1.0 / m)
    }

    /// Twists of the bodies, root axes at the contact point.
    fn twists(&self, velocities: &[f64]) -> Vec<Twist<f64>> {
        let (model, point) = (self.model, &self.located.point_root);
        let mut twists: Vec<Twist<f64>> = Vec::with_capacity(model.bodies.len());
        for (i, body) in model.bodies.iter().enumerate() {
            let mut twist = body.parent.map_or_else(Twist::zero, |p| twists[p]);
            for (k, v) in body.v.clone().enumerate() {
                twist += self.pose.kinematics.column_at(model, i, k, point) * velocities[v];
            }
            twists.push(twist);
        }
        twists
    }

    fn finish(&self, mut found: Found) -> ContactResponse {
        let (model, pose) = (self.model, self.pose);
        let rank = pose.rank();
        let mut remarks = std::mem::take(&mut found.remarks);
        let mut error = None;
        let mut contributions = None;
        if let EffectiveMass::Finite(m) = found.mass {
            contributions = Some(self.contributions(&found.velocities, m));
            error = Some(self.budget(m, &found));
            // What loops that do not quite fit leave of a closing speed may be all of it.
            let floor =
                closing_floor(model, &pose.groups, &model.contact_row(&pose.kinematics, self.located));
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

    fn budget(&self, m: f64, found: &Found) -> ErrorBudget {
        let (closing_speed, errors) = (found.closing_speed, &found.errors);
        let own = errors.rounding + 2.0 * f64::EPSILON / closing_speed;
        if self.pose.loops().is_none() {
            return ErrorBudget { rounding: Some(m * own), closing: Some(0.0), file: None };
        }
        // The rows of an inexact file are off by as much as its frames are; so is the closing speed that m̄ goes by.
        let file = FILE * (errors.file + errors.misfit / closing_speed);
        let closing = self.closing_error(m, found.route).map(|c| m * c);
        ErrorBudget { rounding: Some(m * own), closing, file: errors.is_measured.then_some(m * file) }
    }

    /// Relative change of m̄ between the pose and where it may be, as far as its loops are from closed; none where that
    /// cannot be found. Asked by the route that answered.
    fn closing_error(&self, m: f64, route: Route) -> Option<f64> {
        let assembly: &Assembly = &self.pose.assembly;
        let mut most = 0.0_f64;
        for sign in [1.0, -1.0] {
            let moved = assembly.doubtful_pose(self.pose, sign)?;
            let groups = self.pose.groups_at(&moved);
            let located = self.model.locate(&moved, self.pose.base(), self.contact).ok()?;
            let other = match route {
                Route::Articulated => match self.run(&moved, &groups, &located).mass() {
                    EffectiveMass::Finite(other) => other,
                    EffectiveMass::Immovable | EffectiveMass::Massless => return None,
                },
                Route::Dense => match self.model.least_energy(&moved, &groups, &located).minimum {
                    Minimum::Finite(other) | Minimum::Stationary(other) => other,
                    Minimum::Immovable | Minimum::Massless => return None,
                },
            };
            let change = (other / m - 1.0).abs();
            most = most.max(change);
            if change < SMOOTH {
                // Far from a singularity both ways are alike.
                break;
            }
        }
        Some(most)
    }

    /// Parts of twice the energy of the tree velocities `v`, divided by `m` (the formula's, so that their sum is a
    /// check).
    fn contributions(&self, v: &[f64], m: f64) -> Contributions {
        let (model, kinematics) = (self.model, &self.pose.kinematics);
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

/// How much of a misfit enters a row: several of a file's figures, each rounded by itself, of which the misfit shows a
/// part. Over 17,000 answers of linkages written with 4 to 12 decimals, 110 would do.
const FILE: f64 = 128.0;
/// A part of the mechanism's mass that nobody misses.
const NEGLIGIBLE: f64 = 1e-9;
/// A relative error of 1/m̄ beyond which the pivots that it stands on are rounding, and may be zero.
const NOTHING_LEFT: f64 = 1.0;
/// A relative change of m̄ by what leaves a pose open that is the same both ways.
const SMOOTH: f64 = 1e-9;

impl Pose {
    /// What the recursion decides at this pose for a contact: pivots that duals and lanes follow.
    ///
    /// # Errors
    /// Where it has no 1/m̄: a motion of negative mass, or one without mass that closes the gap.
    pub(crate) fn decisions(
        &self,
        located: &LocatedContact,
        contact: &Contact,
    ) -> Result<Decisions, RouteError> {
        let question = Question { pose: self, model: self.assembly.model(), contact, located };
        let ran = question.run(&self.kinematics, &self.groups, located);
        if ran.deciding.indefinite {
            return Err(RouteError::Indefinite);
        }
        match question.recursive(&ran).mass {
            EffectiveMass::Massless => Err(RouteError::MasslessMotion),
            EffectiveMass::Finite(_) | EffectiveMass::Immovable => Ok(ran.deciding.decisions),
        }
    }
}
