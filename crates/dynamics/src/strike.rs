//! The strike: effective mass, the velocity field of the blow, and who carries the mass.

use crate::articulated::{Articulated, Trust};
use crate::contact::{LocatedContact, locate, row_over_tree};
use crate::kinematics::Kinematics;
use crate::least_energy::{IMMOVABLE, LeastEnergy, Minimum, Solution, condition_of};
use crate::{Contact, ContactError, Pose, System, mass_matrix};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::{Twist, Wrench};

/// What the mechanism opposes to the contact along its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EffectiveMass {
    /// m̄, kg.
    Finite(f64),
    /// No admissible motion closes the gap.
    Immovable,
    /// A motion without energy closes the gap: m̄ = 0.
    Massless,
}

/// How m̄ was computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// Mass matrix, kernel of the constraints, least energy. Takes every mechanism.
    Dense,
    /// Articulated-body recursion. Open chains without mimics and with a regular mass matrix.
    Articulated,
}

/// Which route to take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RouteChoice {
    /// The recursion where it holds, else the dense route.
    #[default]
    Auto,
    /// This one, or an error that says why not.
    Only(Route),
}

/// Why a route does not take a mechanism.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RouteError {
    /// The recursion follows one joint at a time.
    #[error("the articulated route does not take joints that mimic others; the dense route does")]
    Mimics,
    /// The recursion follows open chains.
    #[error("the articulated route does not take closed loops; the dense route does")]
    Loops,
    /// The recursion knows nothing of held contacts.
    #[error("the articulated route does not take held contacts; the dense route does")]
    Holds,
    /// A joint moves (almost) no mass.
    #[error(
        "the articulated route meets a joint that moves no mass (least pivot {least_pivot:.1e} of its terms); \
         the dense route takes it"
    )]
    SingularPivot {
        /// Smallest pivot relative to the size of its terms.
        least_pivot: f64,
    },
    /// Accepted indefinite inertias leave no positive mass at the contact.
    #[error(
        "the mass matrix is indefinite and the contact's effective mass comes out as {value} kg: \
         inertias with negative moments have no meaning here"
    )]
    IndefiniteMass {
        /// The stationary value, kg.
        value: f64,
    },
}

/// Why a strike has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StrikeError {
    /// The contact means nothing.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The route does not take the mechanism.
    #[error(transparent)]
    Route(#[from] RouteError),
}

/// Something about a strike that its reader should know.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// The gap hardly closes: the answer is large and uncertain.
    NearlyImmovable {
        /// Closing speed relative to the size of its terms.
        approach: f64,
        /// Relative uncertainty of m̄ that follows.
        uncertainty: f64,
    },
    /// M is singular: some motions carry no mass. They do not matter for a finite m̄.
    MasslessMotions {
        /// How many.
        directions: usize,
    },
    /// v* is open by a massless motion; m̄ and the shares are not.
    UndeterminedMotion,
    /// The pose is so near to where branches cross that the rank of its constraints is in doubt.
    UnclearRank {
        /// Between the singular values that count and those that do not.
        gap: f64,
    },
    /// M has negative directions (accepted indefinite inertias): m̄ is a stationary value, no minimum.
    IndefiniteMassMatrix,
}

/// The answer to a contact at a pose.
#[derive(Clone, Debug)]
pub struct Strike {
    /// m̄, or why it is not finite.
    pub effective_mass: EffectiveMass,
    /// How it was computed.
    pub route: Route,
    /// Condition of M scaled to unit diagonal; none where M is singular or too large to ask.
    pub condition: Option<f64>,
    /// First-order bound on the error of m̄ from rounding and from what the loops' residual leaves open, kg; none
    /// unless finite.
    pub effective_mass_error: Option<f64>,
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
    /// Motions (over the coordinates) that carry no mass and leave the gap as it is: v* is open by them.
    pub(crate) free_motions: Vec<Vec<f64>>,
    /// Share of each link in m̄; together with the rotors' and the other mass's, 1. None unless finite.
    pub shares: Option<Shares>,
}

/// Who carries the effective mass: parts of twice the energy at unit closing speed, divided by m̄.
#[derive(Clone, Debug, PartialEq)]
pub struct Shares {
    /// One for each link, in link order.
    pub links: Vec<f64>,
    /// Armatures, where a joint has any.
    pub rotors: Vec<(JointId, f64)>,
    /// The other body, where it was given as a number.
    pub other_mass: Option<f64>,
}

/// Larger mass matrices are not asked for their condition beside the recursion.
const CONDITION_LIMIT: usize = 300;
/// The recursion's answer stands up to this relative error from its pivots.
const TRUSTED_ERROR: f64 = 1e-11;
/// The recursions' pivots count as zero below this: what should vanish keeps the rounding of all that was subtracted
/// before, up to 1e-12 where joints nearly line up.
pub(crate) const LEAST_PIVOT: f64 = 1e-10;
/// Below this relative closing speed, a finite answer comes with a remark.
const NEARLY_IMMOVABLE: f64 = 1e-6;

impl Strike {
    /// Whether the mechanism itself gives way: v* is not zero.
    pub fn gives_way(&self) -> bool {
        self.joint_velocities.iter().flatten().any(|v| *v != 0.0)
            || self.base_velocity.linear.norm() > 0.0
            || self.base_velocity.angular.norm() > 0.0
    }
}

impl System {
    /// Effective mass of a contact along its normal, in kilograms, with the strike that goes with it.
    ///
    /// m̄ = min { vᵀMv : Av = 0, jv = 1 }; 1/(j M⁻¹ jᵀ) where M is regular and nothing closes a loop.
    ///
    /// | symbol | meaning                        | shape | unit            |
    /// |--------|--------------------------------|-------|-----------------|
    /// | M      | joint-space mass matrix        | n×n   | kg, kg·m, kg·m² |
    /// | j      | closing speed per joint rate   | 1×n   | m, 1            |
    ///
    /// A gap that no admissible motion can close is `Immovable`, not infinity; one that closes without energy is
    /// `Massless`. Cost: O(n) by the recursion, O(n³) by the dense route.
    /// Source: Khatib 1987, §IV; Featherstone 2008, §7.3 and §8.
    ///
    /// # Errors
    /// [`StrikeError`]: a contact that means nothing; a route that was asked for and does not take the mechanism.
    pub fn strike(&self, pose: &Pose, asked: &Contact, choice: RouteChoice) -> Result<Strike, StrikeError> {
        let contact = self.locate(pose, asked)?;
        Ok(match choice {
            RouteChoice::Only(Route::Dense) => self.strike_dense(pose, asked, &contact)?,
            RouteChoice::Only(Route::Articulated) => self.strike_articulated(pose, &contact)?,
            RouteChoice::Auto => match self.strike_articulated(pose, &contact) {
                Ok(strike) => strike,
                Err(_) => self.strike_dense(pose, asked, &contact)?,
            },
        })
    }

    /// Route A on bare kinematics.
    pub(crate) fn least_energy(&self, kinematics: &Kinematics<f64>, contact: &LocatedContact) -> Solution {
        let mass = self.reduce(&mass_matrix::over_tree(self, kinematics));
        let sizes = mass_matrix::diagonal_sizes(self, kinematics);
        let (row, row_size) = row_over_tree(self, kinematics, contact);
        LeastEnergy {
            mass: &mass,
            mass_size: &self.reduce_vector(&sizes, |multiplier| multiplier * multiplier),
            constraints: &self.constraint_rows(kinematics),
            rank_floor: self.rank_floor(),
            row: &self.reduce_vector(&row, |multiplier| multiplier),
            row_size: &self.reduce_vector(&row_size, f64::abs),
            lengths: &self.coordinate_lengths(),
        }
        .solve()
    }

    /// Relative change of m̄ between a pose and where it may be, as far as its loops are from closed.
    fn closing_error(&self, pose: &Pose, contact: &Contact, m: f64) -> f64 {
        let Some(doubtful) = self.doubtful_poses(pose) else { return 0.0 };
        let mut most = 0.0;
        for kinematics in doubtful {
            let Ok(moved) = locate(self, &kinematics, &pose.base, contact) else { continue };
            if let Minimum::Finite(other) = self.least_energy(&kinematics, &moved).minimum {
                most = f64::max(most, (other / m - 1.0).abs());
            }
        }
        most
    }

    /// Route A.
    fn strike_dense(
        &self,
        pose: &Pose,
        asked: &Contact,
        contact: &LocatedContact,
    ) -> Result<Strike, RouteError> {
        let solution = self.least_energy(&pose.kinematics, contact);
        let mut remarks = Vec::new();
        if solution.massless_directions > 0 {
            remarks.push(Remark::MasslessMotions { directions: solution.massless_directions });
        }
        let effective_mass = match solution.minimum {
            Minimum::Finite(m) => EffectiveMass::Finite(m),
            Minimum::Immovable => EffectiveMass::Immovable,
            Minimum::Massless => EffectiveMass::Massless,
            Minimum::Stationary(m) if m > 0.0 && m.is_finite() => {
                remarks.push(Remark::IndefiniteMassMatrix);
                EffectiveMass::Finite(m)
            }
            Minimum::Stationary(value) => return Err(RouteError::IndefiniteMass { value }),
        };
        if !solution.free_motions.is_empty() && matches!(effective_mass, EffectiveMass::Finite(_)) {
            remarks.push(Remark::UndeterminedMotion);
        }
        let mut strike = self.finish(pose, contact, effective_mass, &self.expand(&solution.velocity));
        strike.condition = solution.condition;
        strike.degrees_of_freedom = solution.mobility;
        let rank = self.rank_at(pose);
        strike.singular_pose = rank.singular;
        if let Some(gap) = rank.gap.filter(|_| !rank.clear) {
            remarks.push(Remark::UnclearRank { gap });
        }
        strike.remarks = remarks;
        // A singular M has no condition; its pivots say how far the rest of it stretches rounding.
        let spread = if strike.condition.is_none() { solution.pivot_spread } else { 0.0 };
        let rounding = f64::EPSILON * self.coordinates as f64 * spread;
        let closing = match strike.effective_mass {
            EffectiveMass::Finite(m) => self.closing_error(pose, asked, m),
            EffectiveMass::Immovable | EffectiveMass::Massless => 0.0,
        };
        // The rows of an inexact file are off by as much as its frames are; so is the closing speed that m̄ goes by.
        let inexact =
            pose.loops.as_ref().map_or(0.0, |l| l.inexactness) / self.mechanism.characteristic_length();
        let frames = 4.0 * inexact / solution.approach.max(IMMOVABLE);
        strike.free_motions = solution.free_motions;
        self.judge(&mut strike, solution.approach, rounding + closing + frames);
        Ok(strike)
    }

    /// Route B, with the strike found by back substitution.
    fn strike_articulated(&self, pose: &Pose, contact: &LocatedContact) -> Result<Strike, RouteError> {
        self.articulated_support()?;
        let mut recursion = Articulated::<f64, 1>::new(self);
        recursion.load(self, contact);
        recursion.eliminate(self, &pose.kinematics, &contact.point_root);
        let trust = recursion.trust();
        self.trusted(&trust)?;
        let (row, size) = row_over_tree(self, &pose.kinematics, contact);
        let approach = relative_approach(self, &row, &size);
        let effective_mass = recursion.effective_mass(approach);
        let mut velocities = vec![0.0; self.follows.len()];
        if let EffectiveMass::Finite(m) = effective_mass {
            let mut motions = vec![Twist::zero(); self.bodies.len()];
            recursion.velocities(self, &mut motions, &mut velocities);
            velocities.iter_mut().for_each(|v| *v *= m);
        }
        let mut strike = self.finish(pose, contact, effective_mass, &velocities);
        strike.route = Route::Articulated;
        if self.coordinates <= CONDITION_LIMIT {
            strike.condition = condition_of(&self.mass_matrix(pose));
        }
        self.judge(&mut strike, approach, trust.relative_error);
        Ok(strike)
    }

    /// Whether the recursion takes this system at all.
    pub(crate) fn articulated_support(&self) -> Result<(), RouteError> {
        if !self.groups.is_empty() {
            Err(RouteError::Loops)
        } else if !self.held.is_empty() {
            Err(RouteError::Holds)
        } else if self.has_active_mimics {
            Err(RouteError::Mimics)
        } else {
            Ok(())
        }
    }

    /// Whether its pivots can be relied on.
    pub(crate) fn trusted(&self, trust: &Trust) -> Result<(), RouteError> {
        if trust.least_pivot > LEAST_PIVOT && trust.relative_error < TRUSTED_ERROR {
            Ok(())
        } else {
            Err(RouteError::SingularPivot { least_pivot: trust.least_pivot })
        }
    }

    /// How far a unit rate of each coordinate moves a point at the characteristic length; a coordinate that mimics
    /// share is measured at its master.
    pub(crate) fn coordinate_lengths(&self) -> Vec<f64> {
        let length = self.mechanism.characteristic_length();
        self.turning_coordinates().into_iter().map(|turns| if turns { length } else { 1.0 }).collect()
    }

    /// Which coordinates turn.
    pub(crate) fn turning_coordinates(&self) -> Vec<bool> {
        let mut turning = vec![false; self.coordinates];
        for body in &self.bodies {
            if body.joint.is_some_and(|id| self.mechanism.joint(id).mimic().is_some()) {
                continue;
            }
            for (k, v) in body.v.clone().enumerate() {
                if let Some(f) = self.follows[v] {
                    turning[f.index] = body.motion.turns(k);
                }
            }
        }
        turning
    }

    fn tree_lengths(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let length = self.mechanism.characteristic_length();
        self.bodies.iter().flat_map(move |body| {
            let scale = move |(k, v): (usize, usize)| (v, if body.motion.turns(k) { length } else { 1.0 });
            body.v.clone().enumerate().map(scale)
        })
    }

    /// Velocities by joint, shares by link.
    fn finish(
        &self,
        pose: &Pose,
        contact: &LocatedContact,
        effective_mass: EffectiveMass,
        velocities: &[f64],
    ) -> Strike {
        let mut joint_velocities: Vec<Vec<f64>> =
            self.mechanism.joints().iter().map(|j| vec![0.0; j.kind().dofs()]).collect();
        let mut base_velocity = Twist::zero();
        for body in self.bodies.iter().filter(|b| !b.v.is_empty()) {
            let v = &velocities[body.v.clone()];
            match body.joint {
                Some(id) => joint_velocities[id.index()].copy_from_slice(v),
                None => {
                    base_velocity =
                        Twist::new(Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]));
                }
            }
        }
        let shares = match effective_mass {
            EffectiveMass::Finite(m) => Some(self.shares(pose, velocities, m)),
            EffectiveMass::Immovable | EffectiveMass::Massless => None,
        };
        Strike {
            effective_mass,
            route: Route::Dense,
            condition: None,
            effective_mass_error: None,
            degrees_of_freedom: self.coordinates,
            singular_pose: false,
            remarks: Vec::new(),
            contact: *contact,
            joint_velocities,
            base_velocity,
            free_motions: Vec::new(),
            shares,
        }
    }

    /// Parts of twice the energy of the tree velocities `v`, divided by `m` (the formula's, so that their sum is a
    /// check).
    fn shares(&self, pose: &Pose, v: &[f64], m: f64) -> Shares {
        let mut motions = vec![Twist::zero(); self.bodies.len()];
        let mut rotors = Vec::new();
        for (i, body) in self.bodies.iter().enumerate() {
            let mut motion =
                body.parent.map_or_else(Twist::zero, |p| pose.kinematics.steps[i].inverse_twist(&motions[p]));
            let mut rotor = 0.0;
            for (k, index) in body.v.clone().enumerate() {
                motion += pose.kinematics.column(self, i, k) * v[index];
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
            let seat = &self.seats[link.index()];
            let motion = seat.body.map_or_else(Twist::zero, |b| seat.frame.inverse_twist(&motions[b]));
            self.mechanism.link(link).inertia().twice_energy(&motion) / m
        };
        rotors.sort_by_key(|(id, _)| *id);
        Shares { links: self.mechanism.link_ids().map(energy).collect(), rotors, other_mass: None }
    }

    /// Error bound and the remark on a gap that hardly closes.
    fn judge(&self, strike: &mut Strike, approach: f64, route_error: f64) {
        let EffectiveMass::Finite(m) = strike.effective_mass else { return };
        let n = self.coordinates.max(1) as f64;
        let rounding = f64::EPSILON * n * strike.condition.unwrap_or(1.0);
        let uncertainty = 2.0 * f64::EPSILON / approach;
        strike.effective_mass_error = Some(m * (rounding + uncertainty + route_error));
        if approach < NEARLY_IMMOVABLE {
            strike.remarks.push(Remark::NearlyImmovable { approach, uncertainty });
        }
    }
}

/// |j| / |size of j's terms| over tree velocities, scaled by lengths.
pub(crate) fn relative_approach(system: &System, row: &[f64], size: &[f64]) -> f64 {
    let (mut of_row, mut of_size) = (0.0, 0.0);
    for (v, length) in system.tree_lengths() {
        of_row += (row[v] / length).powi(2);
        of_size += (size[v] / length).powi(2);
    }
    if of_size > 0.0 { f64::sqrt(of_row / of_size) } else { 0.0 }
}

impl Articulated<f64, 1> {
    /// Loads the unit wrench of a contact: n̂ on the struck side, −n̂ on the other.
    pub(crate) fn load(&mut self, system: &System, contact: &LocatedContact) {
        self.clear();
        let unit = Wrench::new(Vector3::zeros(), contact.normal_root);
        self.push(system.seats[contact.link.index()].body, 0, unit);
        if let Some(against) = contact.against {
            self.push(system.seats[against.index()].body, 0, -unit);
        }
    }

    /// Reads the answer off, given the relative closing speed of the contact row.
    pub(crate) fn effective_mass(&self, approach: f64) -> EffectiveMass {
        if approach <= IMMOVABLE {
            EffectiveMass::Immovable
        } else {
            EffectiveMass::Finite(1.0 / self.response(0, 0))
        }
    }
}

impl Strike {
    /// The same strike where the other side is a free mass (kg) of its own: 1/m̄ = 1/m̄₁ + 1/m₂.
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
        // dm̄ = (m̄/m̄₁)² dm̄₁
        self.effective_mass_error = Some(self.effective_mass_error.unwrap_or(0.0) * factor * factor);
        self.joint_velocities.iter_mut().flatten().for_each(|v| *v *= factor);
        self.base_velocity = self.base_velocity * factor;
        let zero = || Shares { links: vec![], rotors: vec![], other_mass: None };
        let mut shares = self.shares.take().unwrap_or_else(zero);
        shares.links.iter_mut().for_each(|s| *s *= factor);
        shares.rotors.iter_mut().for_each(|(_, s)| *s *= factor);
        shares.other_mass = Some(m / other);
        self.shares = Some(shares);
        self
    }
}
