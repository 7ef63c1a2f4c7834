//! The two routes to m̄ and the choice between them, shared by poses and workspaces.

use crate::dense::direct::{LeastEnergySolution, Minimum};
use crate::error::budget::{BudgetWorkspace, RelativeErrors, UnitImpulse};
use crate::kinematics::contact::LocatedContact;
use crate::kinematics::contact_row::ContactRow;
use crate::kinematics::frames::Kinematics;
use crate::kinematics::outcome::{DenseReason, EffectiveMass, Remark, Route, RouteChoice, RouteError};
use crate::kinematics::remarks::RemarkFlags;
use crate::mobility::GroupMobility;
use crate::model::Model;
use crate::recursion::closing_speed::{ClosingWorkspace, closing_floor, relative_closing_speed};
use crate::recursion::{ClusterElimination, Pivoting, Recursion, RecursionMotion};
use crate::tolerances::{
    DENSE_ROUTE_LIMIT, IMMOVABLE, KEPT_BODIES, KEPT_NUMBERS, NEARLY_IMMOVABLE, NEGLIGIBLE_MASS, NOTHING_LEFT,
    POOLED_WORKSPACES, ROUTE_ROUNDINGS, TRUSTED_ERROR,
};
use percuss_spatial::Twist;
use std::sync::Mutex;

/// A contact at given frames: the input of both routes.
pub(crate) struct RouteInput<'a> {
    pub model: &'a Model,
    pub kinematics: &'a Kinematics,
    pub groups: &'a [GroupMobility],
    /// For each group: residual misfit of its loops, relative to the group's size.
    pub misfits: &'a [f64],
    pub located: &'a LocatedContact,
}

/// Result of a route.
pub(crate) struct RouteResult {
    pub mass: EffectiveMass,
    pub route: Route,
    /// Reason for running the dense route.
    pub dense_reason: Option<DenseReason>,
    pub closing_speed: f64,
    /// Relative errors of m̄.
    pub errors: RelativeErrors,
    /// v* over the tree velocities.
    pub velocities: Vec<f64>,
    pub remarks: Vec<Remark>,
}

/// m̄ by the recursion, or by the dense route if the recursion is not accurate enough.
pub(crate) struct EvaluatedMass {
    pub mass: EffectiveMass,
    /// Error by rounding, kg; `None` unless m̄ is finite.
    pub error: Option<f64>,
    pub flags: RemarkFlags,
    /// Result of the dense route, if used.
    dense: Option<RouteResult>,
}

impl RouteResult {
    /// Number of motions left out as massless.
    fn massless_motion_count(&self) -> usize {
        let directions = |remark: &Remark| match remark {
            Remark::MasslessMotions { directions } => *directions,
            _ => 0,
        };
        self.remarks.iter().map(directions).sum()
    }
}

/// Order of magnitude of the largest possible m̄: the sum of the bodies' masses, kg; for a moment, multiplied by the square of the
/// characteristic length, kg·m².
fn total_mass(model: &Model, row: &ContactRow) -> f64 {
    row.unit_mass() * model.bodies.iter().map(|body| body.inertia.mass.abs()).sum::<f64>()
}

/// Pool of reusable recursion workspaces. Results do not depend on their contents.
#[derive(Debug, Default)]
pub(crate) struct WorkspacePool(Mutex<Vec<RecursionWorkspace>>);

impl WorkspacePool {
    /// Takes a workspace from the pool, or allocates a new one.
    pub fn acquire(&self, model: &Model) -> RecursionWorkspace {
        let kept = self.0.try_lock().ok().and_then(|mut pool| pool.pop());
        kept.unwrap_or_else(|| RecursionWorkspace::new(model))
    }

    /// Returns a workspace to the pool, unless the workspace is large or the pool is full.
    pub fn release(&self, workspace: RecursionWorkspace) {
        let numbers: usize = workspace.recursion.clusters.iter().map(ClusterElimination::stored_count).sum();
        if workspace.recursion.inertias.len() <= KEPT_BODIES
            && numbers <= KEPT_NUMBERS
            && let Ok(mut pool) = self.0.try_lock()
            && pool.len() < POOLED_WORKSPACES
        {
            pool.push(workspace);
        }
    }
}

/// Workspace of the recursion, with its results at the frames of the last question; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct RecursionWorkspace {
    pub recursion: Recursion<1>,
    pub deciding: Pivoting<1>,
    pub closing_speed: f64,
    /// 1/m̄ from the pivots alone, 1/kg.
    response: f64,
    pub row: ContactRow,
    closing: ClosingWorkspace,
    motion: RecursionMotion,
    budget: BudgetWorkspace,
}

impl RecursionWorkspace {
    /// Allocates the buffers for a model.
    pub fn new(model: &Model) -> Self {
        Self {
            recursion: Recursion::new(model),
            deciding: Pivoting::new(model),
            closing_speed: 0.0,
            response: 0.0,
            row: ContactRow::default(),
            closing: ClosingWorkspace::default(),
            motion: RecursionMotion::new(model),
            budget: BudgetWorkspace::default(),
        }
    }

    /// m̄ from the pivots alone.
    pub fn mass(&self) -> EffectiveMass {
        let response = self.response;
        if self.closing_speed <= IMMOVABLE {
            EffectiveMass::Immovable
        } else if self.deciding.massless[0] || response.is_nan() || response <= 0.0 {
            EffectiveMass::Massless
        } else {
            EffectiveMass::Finite(1.0 / response)
        }
    }

    /// True if the rounding of the recursion is negligible, before errors are estimated. The remaining error is
    /// caused by the data and affects every route.
    fn is_clear(&self) -> bool {
        !self.deciding.couples_to_parent
            && !self.deciding.closes_faintly
            && self.has_small_rounding(self.deciding.roundings)
    }

    /// Upper limit of m̄ (kg) for a contact found massless; `None` if negligible.
    pub fn massless_limit(&self, model: &Model) -> Option<f64> {
        let up_to = self.deciding.massless_limit[0];
        (up_to > 0.0 && up_to > NEGLIGIBLE_MASS * total_mass(model, &self.row)).then_some(up_to)
    }

    /// True if m̄ is finite, no motion has a negative mass, the closing speed is well above zero, and the rounding error
    /// ε · `roundings` (1/kg) of 1/m̄ is negligible.
    fn has_small_rounding(&self, roundings: f64) -> bool {
        let most = f64::EPSILON * roundings;
        !self.deciding.indefinite
            && matches!(self.mass(), EffectiveMass::Finite(_))
            && self.closing_speed > NEARLY_IMMOVABLE
            && most <= TRUSTED_ERROR * self.response
    }

    /// Part of the error that the dense route could avoid. The dense route is less sensitive to constraint rows near
    /// a dead centre, and equally sensitive to frames.
    fn avoidable_error(&self, errors: &RelativeErrors) -> f64 {
        if self.recursion.clusters.is_empty() { errors.route } else { errors.rounding }
    }

    /// Reason to run the dense route, given the errors of the recursion; `None` if the recursion is accurate enough.
    fn dense_reason(&self, errors: &RelativeErrors) -> Option<DenseReason> {
        if self.deciding.indefinite {
            return Some(DenseReason::NegativeMass);
        }
        if self.is_clear() {
            return None;
        }
        let relative = self.avoidable_error(errors);
        match self.mass() {
            // After the correction by the energy, the remaining error is caused by the data and affects every route.
            EffectiveMass::Finite(_) if relative <= TRUSTED_ERROR || errors.stationary.is_some() => None,
            // An error of NaN also reaches this arm.
            EffectiveMass::Finite(_) => Some(DenseReason::Error { relative }),
            EffectiveMass::Immovable => None,
            // The recursion classified a sum of possibly large terms as zero; the dense route checks the
            // classification.
            EffectiveMass::Massless => Some(DenseReason::Massless),
        }
    }
}

impl RouteInput<'_> {
    /// Runs the recursion and computes the relative closing speed.
    pub fn run_recursion(&self, workspace: &mut RecursionWorkspace) {
        self.eliminate(workspace);
        let RecursionWorkspace { recursion, closing_speed, row, closing, .. } = workspace;
        self.model.contact_row_into(self.kinematics, self.located, row);
        *closing_speed = relative_closing_speed(closing, self.model, self.groups, recursion, row);
    }

    /// Runs the recursion; the closing speed of the last question is kept.
    pub fn eliminate(&self, workspace: &mut RecursionWorkspace) {
        let (model, located) = (self.model, self.located);
        let RecursionWorkspace { recursion, deciding, response, .. } = workspace;
        recursion.clear();
        let unit = located.wrench_root();
        recursion.add_wrench(model.body_of(located.link), 0, unit);
        recursion.add_wrench(located.against.and_then(|link| model.body_of(link)), 0, -unit);
        deciding.reset();
        recursion.eliminate(model, self.kinematics, self.groups, &located.point_root, deciding);
        *response = recursion.response(0, 0);
    }

    /// Selects the result after the recursion ran.
    pub fn select_result(
        &self,
        workspace: &mut RecursionWorkspace,
        choice: RouteChoice,
    ) -> Result<RouteResult, RouteError> {
        let errors = self.recursion_errors(workspace);
        match choice {
            RouteChoice::Only(Route::Dense) => self.dense_result_checked(workspace, errors),
            RouteChoice::Only(Route::Articulated) if workspace.deciding.indefinite => {
                Err(RouteError::Indefinite)
            }
            RouteChoice::Only(Route::Articulated) => Ok(self.recursion_result(workspace, errors)),
            RouteChoice::Auto => match workspace.dense_reason(&errors) {
                None => Ok(self.recursion_result(workspace, errors)),
                Some(reason) => {
                    let found = self.more_accurate_result(workspace, errors)?;
                    Ok(RouteResult { dense_reason: Some(reason), ..found })
                }
            },
        }
    }

    /// m̄ after the recursion ran, as [`Self::answer`] with the automatic choice. Allocates nothing if the recursion
    /// is accurate enough.
    pub fn effective_mass(
        &self,
        workspace: &mut RecursionWorkspace,
    ) -> Result<(EffectiveMass, RemarkFlags), RouteError> {
        // The errors are estimated at least once, so that the error buffers are allocated before they are needed.
        if workspace.budget.is_filled() && (workspace.is_clear() || self.is_recursion_trusted(workspace)) {
            return Ok((workspace.mass(), self.recursive_flags(workspace, workspace.mass())));
        }
        let found = self.evaluate(workspace)?;
        Ok((found.mass, found.flags))
    }

    /// m̄ with its error, after the recursion ran. Allocates nothing after the first call if the recursion is accurate enough.
    pub fn evaluate(&self, workspace: &mut RecursionWorkspace) -> Result<EvaluatedMass, RouteError> {
        let errors = self.recursion_errors(workspace);
        if workspace.dense_reason(&errors).is_none() {
            let mass = apply_energy_value(workspace.mass(), &errors);
            let error = rounding_error(mass, &errors, workspace.closing_speed);
            let flags = self.recursive_flags(workspace, mass);
            return Ok(EvaluatedMass { mass, error, flags, dense: None });
        }
        let found = self.more_accurate_result(workspace, errors)?;
        let flags = found.remarks.iter().collect::<RemarkFlags>()
            | self.remark_flags(workspace, found.mass, found.closing_speed);
        let error = rounding_error(found.mass, &found.errors, found.closing_speed);
        Ok(EvaluatedMass { mass: found.mass, error, flags, dense: Some(found) })
    }

    /// m̄, its error by rounding (kg; `None` unless finite), findings, and v* in `velocities` (tree velocities at unit closing speed; zeros
    /// without a motion), after the recursion ran. Allocates nothing after the first call if the recursion is accurate enough.
    pub fn respond_into(
        &self,
        workspace: &mut RecursionWorkspace,
        velocities: &mut [f64],
    ) -> Result<(EffectiveMass, Option<f64>, RemarkFlags), RouteError> {
        let found = self.evaluate(workspace)?;
        match (&found.dense, found.mass) {
            (Some(dense), _) => velocities.copy_from_slice(&dense.velocities),
            (None, EffectiveMass::Finite(m)) => {
                velocities.iter_mut().zip(&workspace.motion.velocities).for_each(|(to, v)| *to = v * m);
            }
            (None, _) => velocities.fill(0.0),
        }
        Ok((found.mass, found.error, found.flags))
    }

    /// m̄, and v* in `velocities`, as by [`respond_into`](Self::respond_into). The error is not computed if the rounding is negligible.
    pub fn move_into(
        &self,
        workspace: &mut RecursionWorkspace,
        velocities: &mut [f64],
    ) -> Result<(EffectiveMass, RemarkFlags), RouteError> {
        if workspace.deciding.indefinite || !workspace.is_clear() {
            let (mass, _, flags) = self.respond_into(workspace, velocities)?;
            return Ok((mass, flags));
        }
        let mass = workspace.mass();
        velocities.fill(0.0);
        if let EffectiveMass::Finite(m) = mass {
            let RecursionWorkspace { recursion, motion, .. } = &mut *workspace;
            recursion.velocities(self.model, &self.located.point_root, motion);
            velocities.iter_mut().zip(&motion.velocities).for_each(|(to, v)| *to = v * m);
        }
        Ok((mass, self.recursive_flags(workspace, mass)))
    }

    /// [`remark_flags`](Self::remark_flags) of the recursion's result.
    fn recursive_flags(&self, workspace: &RecursionWorkspace, mass: EffectiveMass) -> RemarkFlags {
        let mut flags = self.remark_flags(workspace, mass, workspace.closing_speed);
        if workspace.deciding.dropped > 0 {
            flags |= RemarkFlags::MASSLESS_MOTIONS;
            if matches!(mass, EffectiveMass::Finite(_)) {
                flags |= RemarkFlags::UNDETERMINED_MOTION;
            }
        }
        flags
    }

    /// Upper limit of m̄ (kg) for a contact that is massless only within rounding; `None` if negligible compared with
    /// the mass of the mechanism.
    pub fn massless_limit(&self, workspace: &RecursionWorkspace, mass: EffectiveMass) -> Option<f64> {
        workspace.massless_limit(self.model).filter(|_| mass == EffectiveMass::Massless)
    }

    /// Kinds of findings about a result, as in [`Pose::respond`](crate::Pose::respond), without the findings of the
    /// route. `closing_speed`: see [`relative_closing_speed`], dimensionless. Allocates nothing.
    fn remark_flags(
        &self,
        workspace: &RecursionWorkspace,
        mass: EffectiveMass,
        closing_speed: f64,
    ) -> RemarkFlags {
        let mut flags = RemarkFlags::NONE;
        let is_finite = matches!(mass, EffectiveMass::Finite(_));
        if is_finite
            && closing_speed < NEARLY_IMMOVABLE.max(closing_floor(self.model, self.groups, &workspace.row))
        {
            flags |= RemarkFlags::NEARLY_IMMOVABLE;
        }
        if self.massless_limit(workspace, mass).is_some() {
            flags |= RemarkFlags::MASSLESS_TO_ROUNDING;
        }
        if self.groups.iter().any(|group| !group.rank.clear) {
            flags |= RemarkFlags::UNCLEAR_RANK;
        }
        flags
    }

    /// True if the recursion's own error is small, for a tree only. Stores the motion in the workspace.
    fn is_recursion_trusted(&self, workspace: &mut RecursionWorkspace) -> bool {
        let finite = !workspace.deciding.indefinite && matches!(workspace.mass(), EffectiveMass::Finite(_));
        let RecursionWorkspace { recursion, motion, budget, .. } = workspace;
        if !finite || !recursion.clusters.is_empty() {
            return false;
        }
        recursion.velocities(self.model, &self.located.point_root, motion);
        let impulse = self.impulse(&motion.twists, &motion.velocities);
        impulse.route_error(budget, recursion) <= TRUSTED_ERROR && !workspace.deciding.closes_faintly
    }

    /// Result of the dense route if more accurate than the recursion, otherwise the result of the recursion. Used if
    /// the recursion is in doubt.
    fn more_accurate_result(
        &self,
        workspace: &mut RecursionWorkspace,
        errors: RelativeErrors,
    ) -> Result<RouteResult, RouteError> {
        if workspace.deciding.indefinite {
            let found = self.dense_result(workspace)?;
            if found.massless_motion_count() > 0 {
                // The recursion has no result, so no bound for the mass of the left-out motions.
                workspace.deciding.massless_limit[0] = total_mass(self.model, &workspace.row);
                return Ok(RouteResult { errors: found.errors.with_frozen(1.0), ..found });
            }
            return Ok(found);
        }
        let recursive = self.recursion_result(workspace, errors);
        let dense = self.dense_result(workspace).map(|found| {
            // Both routes leave out a massless motion: the bound for the frozen motions of the recursion holds for both.
            let frozen = if recursive.mass == EffectiveMass::Massless { 1.0 } else { errors.frozen };
            let errors = if found.massless_motion_count() > 0 {
                found.errors.with_frozen(frozen)
            } else {
                found.errors
            };
            RouteResult { errors, ..found }
        });
        Ok(match dense {
            Ok(dense) if recursive.mass == EffectiveMass::Massless => dense,
            // A motion whose pivot the recursion keeps has a mass, even if an uncertain one.
            Ok(dense)
                if dense.mass == EffectiveMass::Massless
                    || dense.massless_motion_count() > recursive.massless_motion_count() =>
            {
                recursive
            }
            // `total_cmp` ranks NaN as the largest error.
            Ok(dense) if dense.errors.rounding.total_cmp(&recursive.errors.rounding).is_lt() => dense,
            _ => recursive,
        })
    }

    /// Result of the dense route with the doubts of the recursion: motions that both leave out, and masses that the
    /// recursion finds where the dense route finds none.
    fn dense_result_checked(
        &self,
        workspace: &mut RecursionWorkspace,
        errors: RelativeErrors,
    ) -> Result<RouteResult, RouteError> {
        if workspace.deciding.indefinite {
            return self.more_accurate_result(workspace, errors);
        }
        let recursive = self.recursion_result(workspace, errors).mass;
        let found = self.dense_result(workspace)?;
        match (found.mass, recursive) {
            (EffectiveMass::Massless, EffectiveMass::Finite(m)) => {
                let most = m * (1.0 + errors.rounding);
                let most = if most.is_finite() { most } else { total_mass(self.model, &workspace.row) };
                let up_to = &mut workspace.deciding.massless_limit[0];
                *up_to = up_to.max(most);
                Ok(found)
            }
            (EffectiveMass::Finite(_), _) if found.massless_motion_count() > 0 => {
                let frozen = if recursive == EffectiveMass::Massless { 1.0 } else { errors.frozen };
                Ok(RouteResult { errors: found.errors.with_frozen(frozen), ..found })
            }
            _ => Ok(found),
        }
    }

    /// Errors of a finite result of the recursion. Stores the motion in the workspace.
    fn recursion_errors(&self, workspace: &mut RecursionWorkspace) -> RelativeErrors {
        if workspace.deciding.indefinite || !matches!(workspace.mass(), EffectiveMass::Finite(_)) {
            return RelativeErrors::default();
        }
        let is_clear = workspace.is_clear();
        let RecursionWorkspace { recursion, motion, budget, deciding, .. } = workspace;
        recursion.velocities(self.model, &self.located.point_root, motion);
        let errors =
            self.impulse(&motion.twists, &motion.velocities).recursion_errors(budget, recursion, is_clear);
        if deciding.closes_faintly { errors.with_frozen(1.0) } else { errors }
    }

    /// 1/m̄ as the stationary value of the energy, after the recursion ran; `None` if motions have no mass.
    pub fn response_by_energy(&self, workspace: &mut RecursionWorkspace) -> Option<f64> {
        let RecursionWorkspace { recursion, motion, .. } = workspace;
        recursion.velocities(self.model, &self.located.point_root, motion);
        let value = self.impulse(&motion.twists, &motion.velocities).stationary(recursion).value();
        value.map(|(response, _)| response).filter(|response| *response > 0.0)
    }

    /// Result of the recursion, corrected according to its errors.
    fn recursion_result(&self, workspace: &mut RecursionWorkspace, errors: RelativeErrors) -> RouteResult {
        let mut mass = apply_energy_value(workspace.mass(), &errors);
        let mut velocities = vec![0.0; self.model.velocity_coordinates.len()];
        match mass {
            EffectiveMass::Finite(m) => {
                velocities.iter_mut().zip(&workspace.motion.velocities).for_each(|(to, v)| *to = v * m);
                if workspace.avoidable_error(&errors) - errors.frozen > NOTHING_LEFT
                    && !workspace.has_small_rounding(ROUTE_ROUNDINGS * workspace.deciding.terms)
                {
                    // The remaining energy is only rounding.
                    mass = EffectiveMass::Massless;
                    let most = m * (1.0 + workspace.avoidable_error(&errors));
                    let up_to = &mut workspace.deciding.massless_limit[0];
                    *up_to = up_to.max(most);
                }
            }
            EffectiveMass::Massless => {
                let free = workspace.deciding.best_free.map(|free| {
                    workspace.recursion.massless_velocities(self.model, &self.located.point_root, free)
                });
                velocities =
                    free.and_then(|free| scale_to_unit_speed(&workspace.row, free)).unwrap_or(velocities);
            }
            EffectiveMass::Immovable => {}
        }
        let mut remarks = Vec::new();
        if workspace.deciding.dropped > 0 {
            remarks.push(Remark::MasslessMotions { directions: workspace.deciding.dropped });
            if matches!(mass, EffectiveMass::Finite(_)) {
                remarks.push(Remark::UndeterminedMotion);
            }
        }
        RouteResult {
            mass,
            route: Route::Articulated,
            dense_reason: None,
            closing_speed: workspace.closing_speed,
            errors,
            velocities,
            remarks,
        }
    }

    /// Input of the error budget for a motion at a unit impulse.
    fn impulse<'b>(&'b self, twists: &'b [Twist<f64>], velocities: &'b [f64]) -> UnitImpulse<'b> {
        UnitImpulse {
            model: self.model,
            kinematics: self.kinematics,
            groups: self.groups,
            misfits: self.misfits,
            contact: self.located,
            twists,
            velocities,
        }
    }

    /// Result of the dense route.
    fn dense_result(&self, workspace: &mut RecursionWorkspace) -> Result<RouteResult, RouteError> {
        let model = self.model;
        // M is formed over the tree velocities; mimics are folded afterwards.
        let coordinates = model.velocity_coordinates.len();
        if coordinates > DENSE_ROUTE_LIMIT {
            return Err(RouteError::TooLarge { coordinates, limit: DENSE_ROUTE_LIMIT });
        }
        let solution = model.least_energy(self.kinematics, self.groups, self.located);
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
        if solution.has_massless_motion && matches!(mass, EffectiveMass::Finite(_)) {
            remarks.push(Remark::UndeterminedMotion);
        }
        let velocities = model.expand(&solution.velocity);
        let errors = match mass {
            EffectiveMass::Finite(m) => self.dense_errors(workspace, &solution, m),
            EffectiveMass::Immovable | EffectiveMass::Massless => RelativeErrors::default(),
        };
        Ok(RouteResult {
            mass,
            route: Route::Dense,
            dense_reason: None,
            closing_speed: solution.closing_speed,
            errors,
            velocities,
            remarks,
        })
    }

    /// Errors of the dense route, from its motion scaled to a unit impulse.
    fn dense_errors(
        &self,
        workspace: &mut RecursionWorkspace,
        solution: &LeastEnergySolution,
        m: f64,
    ) -> RelativeErrors {
        let model = self.model;
        let u: Vec<f64> = solution.velocity.iter().map(|v| v / m).collect();
        let velocities = model.expand(&u);
        let twists = self.twists(&velocities);
        let sizes = model.mass_sizes(self.kinematics);
        let RecursionWorkspace { recursion, budget, .. } = workspace;
        let (impulse, result) = (self.impulse(&twists, &velocities), (1.0 / m, solution.row_sensitivity));
        let errors = impulse.dense_errors(budget, recursion, &sizes, &u, result);
        if solution.massless_couples { errors.with_frozen(1.0) } else { errors }
    }

    /// Twists of the bodies, in root axes at the contact point.
    fn twists(&self, velocities: &[f64]) -> Vec<Twist<f64>> {
        let (model, point) = (self.model, &self.located.point_root);
        let mut twists: Vec<Twist<f64>> = Vec::with_capacity(model.bodies.len());
        for (i, body) in model.bodies.iter().enumerate() {
            let mut twist = body.parent.map_or_else(Twist::zero, |p| twists[p]);
            for (k, v) in body.v.clone().enumerate() {
                twist += self.kinematics.column_at(model, i, k, point) * velocities[v];
            }
            twists.push(twist);
        }
        twists
    }
}

/// Error of m̄ by rounding, kg: of the route and of the closing speed; `None` unless m̄ is finite.
fn rounding_error(mass: EffectiveMass, errors: &RelativeErrors, closing_speed: f64) -> Option<f64> {
    match mass {
        EffectiveMass::Finite(m) => Some(m * (errors.rounding + 2.0 * f64::EPSILON / closing_speed)),
        EffectiveMass::Immovable | EffectiveMass::Massless => None,
    }
}

/// Replaces a finite m̄ by the stationary value of the energy, if one was computed.
fn apply_energy_value(mass: EffectiveMass, errors: &RelativeErrors) -> EffectiveMass {
    match (mass, errors.stationary) {
        (EffectiveMass::Finite(_), Some(response)) => EffectiveMass::Finite(1.0 / response),
        _ => mass,
    }
}

/// Scales a motion to unit closing speed; `None` if the motion does not close the gap.
fn scale_to_unit_speed(row: &ContactRow, mut velocities: Vec<f64>) -> Option<Vec<f64>> {
    let speed: f64 = row.entries.iter().map(|e| e.value * velocities[e.velocity]).sum();
    velocities.iter_mut().for_each(|v| *v /= speed);
    (speed != 0.0).then_some(velocities)
}
