//! Contact response: effective mass, motion at unit closing speed, and contribution of each link.

use crate::analysis::assembly::Assembly;
use crate::analysis::pose::Pose;
use crate::analysis::routes::{RecursionWorkspace, RouteInput, RouteResult};
use crate::dense::direct::Minimum;
use crate::error::budget::ErrorBudget;
use crate::kinematics::contact::{Contact, ContactError, LocatedContact};
use crate::kinematics::gap::Gap;
use crate::kinematics::outcome::{
    DenseReason, EffectiveMass, Remark, ResponseError, Route, RouteChoice, RouteError,
};
use crate::kinematics::remarks::RemarkFlags;
use crate::model::interruption;
use crate::recursion::closing_speed::closing_floor;
use crate::tolerances::{FILE_MISFITS, IMMOVABLE, LEAST_OTHER_MASS, NEARLY_IMMOVABLE, SAME_BOTH_WAYS};
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::Twist;

/// Result for a contact at a pose.
#[must_use]
#[derive(Clone, Debug)]
pub struct ContactResponse {
    /// m̄, or the reason for m̄ not being finite.
    pub effective_mass: EffectiveMass,
    /// Route that computed m̄.
    pub route: Route,
    /// Reason for running the dense route in addition to the recursion; `None` if only one route ran. The result is
    /// still the recursion's unless the dense route is more accurate.
    pub dense_reason: Option<DenseReason>,
    /// True if m̄ is the stationary value of the energy, used if the sum over the pivots loses too much accuracy.
    pub is_energy_value: bool,
    /// Error budget of m̄, kg; `None` unless m̄ is finite.
    pub error: Option<ErrorBudget>,
    /// dim ker A at the pose, including the 6 of a floating base.
    pub degrees_of_freedom: usize,
    /// True if the constraints have less than their generic rank here: branches cross, and m̄ is a lower bound not
    /// attained on any branch.
    pub singular_pose: bool,
    /// Findings about the result.
    pub remarks: Vec<Remark>,
    /// The contact at the pose.
    pub contact: LocatedContact,
    /// v*: velocities of every joint at unit closing speed, in joint order (layouts of `JointKind`).
    pub joint_velocities: Vec<Vec<f64>>,
    /// v* of the root link, in root axes at the root origin; zero if the root link is the ground.
    pub base_velocity: Twist<f64>,
    /// Contribution of each link. Links, rotors and the other mass sum to 1. `None` unless m̄ is finite.
    pub contributions: Option<Contributions>,
}

impl ContactResponse {
    /// Unit of m̄ and of its error: `kg`, or `kg·m²` for a moment about an axis.
    pub fn unit(&self) -> &'static str {
        if self.contact.is_moment { "kg·m²" } else { "kg" }
    }
}

/// Contributions to the effective mass: shares of twice the kinetic energy at unit closing speed, divided by m̄.
#[derive(Clone, Debug, PartialEq)]
pub struct Contributions {
    /// Contribution of each link, in link order.
    pub links: Vec<f64>,
    /// Contributions of the armatures, for joints with an armature.
    pub rotors: Vec<(JointId, f64)>,
    /// Contribution of the other body, if the body was given as a mass.
    pub other_mass: Option<f64>,
}

impl ContactResponse {
    /// True if the mechanism itself moves: v* is not zero.
    pub fn mechanism_moves(&self) -> bool {
        self.joint_velocities.iter().flatten().any(|v| *v != 0.0)
            || self.base_velocity.linear.norm() > 0.0
            || self.base_velocity.angular.norm() > 0.0
    }

    /// Kinds of the [`remarks`](Self::remarks), with [`RemarkFlags::SINGULAR_POSE`] if the pose is singular, and the flags of the
    /// [error](RemarkFlags::of_error).
    pub fn remark_flags(&self) -> RemarkFlags {
        let singular = if self.singular_pose { RemarkFlags::SINGULAR_POSE } else { RemarkFlags::NONE };
        let uncertain = RemarkFlags::of_error(self.effective_mass, self.effective_mass_error());
        self.remarks.iter().collect::<RemarkFlags>() | singular | uncertain
    }

    /// Known error of m̄, kg: [`ErrorBudget::known`]. Errors in the figures of a file are included only if redundant
    /// rows reveal them.
    pub fn effective_mass_error(&self) -> Option<f64> {
        self.error.and_then(|error| error.known())
    }

    /// Response against a free body of mass `other` (kg) on the other side: 1/m̄ = 1/m̄₁ + 1/m₂.
    ///
    /// An immovable mechanism gives m̄ = m₂; a massless mechanism stays massless.
    ///
    /// # Errors
    /// [`ContactError::OtherMass`]: `other` is not finite, or not above 1e-100 kg. [`ContactError::MassOfMoment`]: the contact is a moment.
    pub fn against_mass(mut self, other: f64) -> Result<Self, ContactError> {
        if self.contact.is_moment {
            return Err(ContactError::MassOfMoment { mass: other });
        }
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
        // dm̄ = (m̄/m̄₁)² dm̄₁. The other mass is taken as exact, apart from one rounding.
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
    /// Effective mass of a contact along its normal, in kilograms, with motion, contributions and errors. For a moment about an axis: the
    /// effective inertia in kg·m², with j = âᵀ(J_ω,on − J_ω,against).
    ///
    /// m̄ = min { vᵀMv : Av = 0, jv = 1 }; 1/(j M⁻¹ jᵀ) if M is regular and the mechanism has no loops.
    ///
    /// | symbol | meaning                        | shape | unit            |
    /// |--------|--------------------------------|-------|-----------------|
    /// | M      | joint-space mass matrix        | n×n   | kg, kg·m, kg·m² |
    /// | A      | Jacobian of the constraints    | m×n   | m, 1            |
    /// | j      | closing speed per joint rate   | 1×n   | m, 1            |
    ///
    /// The result is `Immovable` if no admissible motion closes the gap, and `Massless` if a motion without kinetic
    /// energy closes the gap. Cost: O(n) by the recursion over clusters; O(n³) by the dense route, which runs only if
    /// the error of the recursion may exceed 1e-11. Source: Khatib 1987, §IV; Featherstone 2008, §7.3 and §8.
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact.
    pub fn respond(&self, contact: &Contact) -> Result<ContactResponse, ResponseError> {
        self.respond_by_route(contact, RouteChoice::Auto)
    }

    /// Effective mass of a contact by a given route. See [`Self::respond`].
    ///
    /// # Errors
    /// [`ResponseError`]: an invalid contact; the given route refuses the mechanism.
    pub fn respond_by_route(
        &self,
        contact: &Contact,
        choice: RouteChoice,
    ) -> Result<ContactResponse, ResponseError> {
        interruption::check();
        let located = self.locate(contact)?;
        let workspace = self.assembly.workspaces().acquire(self.assembly.model());
        let mut query = ContactQuery { pose: self, contact, located: &located, workspace };
        let answer = query.respond(choice);
        self.assembly.workspaces().release(query.workspace);
        Ok(answer?)
    }

    /// Input of the routes to m̄: the contact with the frames and the mobility of this pose.
    fn route_input<'a>(&'a self, located: &'a LocatedContact) -> RouteInput<'a> {
        RouteInput {
            model: self.assembly.model(),
            kinematics: &self.kinematics,
            groups: &self.groups,
            misfits: self.assembly.misfits(),
            located,
        }
    }
}

/// A contact query at a pose, with the workspace of its routes.
struct ContactQuery<'a> {
    pose: &'a Pose,
    contact: &'a Contact,
    located: &'a LocatedContact,
    workspace: RecursionWorkspace,
}

impl ContactQuery<'_> {
    /// Runs the recursion, selects the result, and adds motion, contributions and errors.
    fn respond(&mut self, choice: RouteChoice) -> Result<ContactResponse, RouteError> {
        let route_input = self.pose.route_input(self.located);
        route_input.model.refuse_large_clusters(&self.pose.groups)?;
        route_input.run_recursion(&mut self.workspace);
        let found = route_input.select_result(&mut self.workspace, choice)?;
        let up_to = route_input.massless_limit(&self.workspace, found.mass);
        let mut response = self.build_response(found);
        response.remarks.extend(up_to.map(|up_to| Remark::MasslessToRounding { up_to }));
        Ok(response)
    }

    /// Converts the result of a route to a contact response.
    fn build_response(&mut self, mut found: RouteResult) -> ContactResponse {
        let pose = self.pose;
        let model = pose.assembly.model();
        let rank = pose.rank();
        let mut remarks = std::mem::take(&mut found.remarks);
        remarks.extend(pose.remarks());
        remarks.extend(pose.assembly.base_remark(self.contact, pose.base_is_given));
        let gap = Gap::open_of(self.contact, model, &pose.kinematics);
        remarks.extend(gap.map(|gap| Remark::OpenGap { gap }));
        let mut error = None;
        let mut contributions = None;
        if let EffectiveMass::Finite(m) = found.mass {
            contributions = Some(self.contributions(&found.velocities, m));
            error = Some(self.budget(m, &found));
            // The misfit of loops that do not close exactly may account for the whole closing speed.
            let floor = closing_floor(model, &pose.groups, &self.workspace.row);
            if found.closing_speed < NEARLY_IMMOVABLE.max(floor) {
                let open = if floor > IMMOVABLE { floor } else { 2.0 * f64::EPSILON };
                let uncertainty = open / found.closing_speed;
                remarks.push(Remark::NearlyImmovable { closing_speed: found.closing_speed, uncertainty });
            }
        }
        if let Some(gap) = rank.gap.filter(|_| !rank.clear) {
            remarks.push(Remark::UnclearRank { gap });
        }
        let (joint_velocities, base_velocity) = model.split_velocities(&found.velocities);
        ContactResponse {
            effective_mass: found.mass,
            route: found.route,
            dense_reason: found.dense_reason,
            is_energy_value: found.route == Route::Articulated && found.errors.stationary.is_some(),
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

    /// Error budget of a finite m̄.
    fn budget(&mut self, m: f64, found: &RouteResult) -> ErrorBudget {
        let (closing_speed, errors) = (found.closing_speed, &found.errors);
        let own = errors.rounding + 2.0 * f64::EPSILON / closing_speed;
        if self.pose.loops().is_none() {
            return ErrorBudget { rounding: Some(m * own), closing: Some(0.0), file: None };
        }
        // The constraint rows of an inexact file have errors of the size of its frame errors. The closing speed has
        // the same errors.
        let file = FILE_MISFITS * (errors.file + errors.misfit / closing_speed);
        let closing = self.closing_error(m, found).map(|c| m * c);
        ErrorBudget { rounding: Some(m * own), closing, file: errors.is_measured.then_some(m * file) }
    }

    /// Relative change of m̄ between the pose and the nearby poses within the closing error of its loops. `None` if
    /// such a pose cannot be computed. Uses the method of the result: a route, or the energy.
    fn closing_error(&mut self, m: f64, found: &RouteResult) -> Option<f64> {
        let assembly: &Assembly = &self.pose.assembly;
        let mut most = 0.0_f64;
        for sign in [1.0, -1.0] {
            let moved = assembly.pose_within_uncertainty(self.pose, sign)?;
            let groups = self.pose.groups_near(&moved);
            let model = assembly.model();
            let located = model.locate(&moved, self.pose.base(), self.contact).ok()?;
            let beside = RouteInput {
                model,
                kinematics: &moved,
                groups: &groups,
                misfits: assembly.misfits(),
                located: &located,
            };
            let other = match found.route {
                Route::Articulated => {
                    beside.eliminate(&mut self.workspace);
                    let EffectiveMass::Finite(own) = self.workspace.mass() else { return None };
                    let by_energy =
                        found.errors.stationary.and_then(|_| beside.response_by_energy(&mut self.workspace));
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
                // Far from a singularity, both directions give the same change.
                break;
            }
        }
        Some(most)
    }

    /// Contributions: shares of twice the kinetic energy of the tree velocities `v`, divided by `m`. `m` is the m̄ of
    /// the route, so the sum of the shares is a check.
    fn contributions(&self, v: &[f64], m: f64) -> Contributions {
        let (model, kinematics) = (self.pose.assembly.model(), &self.pose.kinematics);
        let mut motions = vec![Twist::zero(); model.bodies.len()];
        let mut rotors = Vec::new();
        for (i, body) in model.bodies.iter().enumerate() {
            let mut motion = body
                .parent
                .map_or_else(Twist::zero, |p| kinematics.parent_transforms[i].inverse_twist(&motions[p]));
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
