//! Many contacts on one link, or between two links, at one pose. After one computation of Φ, each contact needs only
//! algebra on Φ.
//!
//! A force along n̂ at p is the wrench w = ((p − o) × n̂, n̂) about a point o of the contact link, in its axes, and
//!
//! ```text
//! 1/m̄ = wᵀ Φ w = |R w|²,   Φ = J M_c⁻¹ Jᵀ = RᵀR
//! ```
//!
//! J is the Jacobian of the relative motion of the two links at o, and M_c⁻¹ the inverse mass matrix under the
//! constraints. The recursion gives Φ as a sum of squares, one for each pivot. R is the triangular factor of the sum,
//! computed by Givens rotations. m̄ = 1/|R w|² therefore loses no digits by squaring. Wrenches to which a motion
//! without mass responds are stored separately from R. Loops, mimics, held contacts and free bases are included in
//! both.

mod kernel;
mod probes;
mod scale;

pub use self::kernel::ContactColumns;
use self::kernel::{Constants, Evaluate};
pub use self::scale::PrincipalMass;
use self::scale::{FreeWrenches, InertiaFactor};
use crate::analysis::pose::Pose;
use crate::batch::row_results::{BatchAnswer, ContactStatus, RowResults};
use crate::kinematics::contact::{Contact, ContactError, ContactPart};
use crate::kinematics::outcome::EffectiveMass;
use crate::kinematics::remarks::RemarkFlags;
use crate::model::interruption;
use crate::recursion::{Pivoting, Recursion};
use crate::tolerances::{MAP_FREE_CLEAR, MAP_PORTION, MAP_STILL, MAP_TRUSTED_ERROR, MASSLESS_CLOSING};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use percuss_mechanism::LinkId;
use percuss_spatial::Wrench;
use percuss_spatial::lanes::Instructions;

/// Output columns of a map, as long as the columns of the contacts.
#[derive(Debug)]
pub struct MapAnswers<'a> {
    /// m̄, kg; 0 if massless, NaN if the status is neither finite nor massless.
    pub masses: &'a mut [f64],
    /// Relative error of m̄; NaN if m̄ is not finite or the error is unknown.
    pub relative_errors: &'a mut [f64],
    /// Status of each contact.
    pub statuses: &'a mut [ContactStatus],
}

/// Error of filling a map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// Columns have different lengths.
    #[error("the columns have {got} and {expected} numbers; expected columns of one length")]
    Lengths {
        /// Length of the column.
        got: usize,
        /// Length of the first column.
        expected: usize,
    },
    /// Invalid links, or numbers that are not finite.
    #[error(transparent)]
    Contact(#[from] ContactError),
}

/// Φ of a link, or of a pair of links, at a pose, ready for many contacts.
#[derive(Clone, Debug)]
pub struct ContactMap<'a> {
    pose: &'a Pose,
    link: LinkId,
    against: Option<LinkId>,
    constants: Constants,
    massless_wrenches: FreeWrenches,
    /// True if no eigenvalue of Φ is ambiguous: what Φ leaves of a wrench is either rounding or clearly larger.
    is_clear: bool,
    /// True if Φ is known.
    has_inertia: bool,
    uses_inertia: bool,
    instructions: Instructions,
}

impl Pose {
    /// Prepares a map for many contacts of a link with the ground or with another link. Φ is computed about `centre`
    /// (m, frame of the contact link), and errors are calibrated for contacts within about `reach` (m) of `centre`.
    /// Results for contacts farther away are correct, with larger errors.
    ///
    /// Cost: the recursion with six unit wrenches, and [`respond`](Self::respond) at some dozen contacts, used to
    /// calibrate the errors of the map. Source of Φ: Khatib 1987, §IV; Featherstone 2008, §7.3.
    ///
    /// # Errors
    /// [`ContactError`]: links of another mechanism, a link against itself, a centre or reach that is not finite.
    pub fn contact_map(
        &self,
        link: LinkId,
        against: Option<LinkId>,
        centre: impl Into<Vector3<f64>>,
        reach: f64,
    ) -> Result<ContactMap<'_>, ContactError> {
        let mut map = self.uncalibrated_map(link, against, centre.into(), reach)?;
        map.uses_inertia = map.has_inertia && map.calibrate_errors();
        Ok(map)
    }

    /// Principal masses at a point (m, frame of the contact link), as [`ContactMap::principal_masses`]; each mass is that of
    /// [`respond`](Self::respond). Cost: the recursion with six unit wrenches, and three contacts.
    ///
    /// # Errors
    /// [`ContactError`], as for [`contact_map`](Self::contact_map).
    pub fn principal_masses(
        &self,
        link: LinkId,
        against: Option<LinkId>,
        point: impl Into<Vector3<f64>>,
    ) -> Result<Option<[PrincipalMass; 3]>, ContactError> {
        let point = point.into();
        Ok(self.uncalibrated_map(link, against, point, 0.0)?.principal_masses(&point))
    }

    /// Map of which each contact is computed separately.
    fn uncalibrated_map(
        &self,
        link: LinkId,
        against: Option<LinkId>,
        centre: Vector3<f64>,
        reach: f64,
    ) -> Result<ContactMap<'_>, ContactError> {
        let model = self.assembly.model();
        let any = Contact { against, ..Contact::new(link, centre, Vector3::x()) };
        model.check_contact(&any)?;
        if !(reach.is_finite() && reach >= 0.0) {
            return Err(ContactError::NotFinite { part: ContactPart::Point, value: reach });
        }
        // For a reach of zero, any positive length can be used.
        let reach = if reach > 0.0 { reach } else { 1.0 };
        let mut map = ContactMap {
            pose: self,
            link,
            against,
            constants: Constants::new(centre, reach),
            massless_wrenches: FreeWrenches::default(),
            is_clear: false,
            has_inertia: false,
            uses_inertia: false,
            instructions: Instructions::best(),
        };
        map.compute_inertia();
        Ok(map)
    }

    /// m̄ of many contacts of a link: points (m) and normals (any nonzero length) in its frame. Φ refers to the middle of a box around
    /// the points; the error bounds hold in this box. The remarks are those of the pose.
    ///
    /// # Errors
    /// [`MapError`]: as for [`contact_map`](Self::contact_map); as many normals as points are expected.
    pub fn contact_masses(
        &self,
        link: LinkId,
        against: Option<LinkId>,
        points: &[[f64; 3]],
        normals: &[[f64; 3]],
    ) -> Result<RowResults, MapError> {
        if points.len() != normals.len() {
            return Err(MapError::Lengths { got: normals.len(), expected: points.len() });
        }
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for point in points {
            for ([least, most], x) in bounds.iter_mut().zip(point) {
                (*least, *most) = (least.min(*x), most.max(*x));
            }
        }
        if points.is_empty() {
            bounds = [[0.0; 2]; 3];
        }
        let centre = Vector3::from_fn(|axis, _| 0.5 * (bounds[axis][0] + bounds[axis][1]));
        let reach = Vector3::from_fn(|axis, _| 0.5 * (bounds[axis][1] - bounds[axis][0])).norm();
        let map = self.contact_map(link, against, centre, reach)?;
        let mut results = RowResults::new(points.len());
        results.remarks.fill(self.remarks().iter().collect::<RemarkFlags>().bits());
        for start in (0..points.len()).step_by(MAP_PORTION) {
            let rows = start..points.len().min(start + MAP_PORTION);
            let columns = |values: &[[f64; 3]]| {
                [0, 1, 2].map(|axis| values[rows.clone()].iter().map(|v| v[axis]).collect::<Vec<f64>>())
            };
            let (points, normals) = (columns(points), columns(normals));
            let contacts = ContactColumns {
                points: points.each_ref().map(Vec::as_slice),
                normals: normals.each_ref().map(Vec::as_slice),
            };
            let mut answers = MapAnswers {
                masses: &mut results.masses[rows.clone()],
                relative_errors: &mut results.errors[rows.clone()],
                statuses: &mut results.statuses[rows.clone()],
            };
            map.fill_answers(contacts, &mut answers)?;
        }
        for ((mass, error), status) in
            results.masses.iter_mut().zip(&mut results.errors).zip(&results.statuses)
        {
            // Errors of a map are relative.
            *error *= *mass;
            if *status != ContactStatus::Finite {
                (*mass, *error) = (f64::NAN, f64::NAN);
            }
        }
        Ok(results)
    }
}

impl ContactMap<'_> {
    /// Instruction set of the SIMD kernel.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }

    /// Selects another instruction set; the baseline if this processor does not support `set`.
    pub fn with_instructions(mut self, set: Instructions) -> Self {
        self.instructions = if set.is_available() { set } else { Instructions::Baseline };
        self
    }

    /// True if contacts are computed from Φ. Otherwise, with fewer than eight correct digits in Φ or a negative mass,
    /// each contact is computed separately by [`Pose::respond`].
    pub fn is_by_inertia(&self) -> bool {
        self.uses_inertia
    }

    /// Computes m̄ for contacts given by columns: points (m) and normals (any nonzero length) in the frame of the
    /// contact link. Contacts with a reliable result from Φ need no allocation. The other contacts are computed
    /// separately by [`Pose::respond`].
    ///
    /// # Errors
    /// [`MapError`]: columns of different lengths.
    pub fn fill_answers(
        &self,
        contacts: ContactColumns<'_>,
        answers: &mut MapAnswers<'_>,
    ) -> Result<(), MapError> {
        let expected = contacts.points[0].len();
        let lengths = contacts.points.iter().chain(&contacts.normals).map(|column| column.len());
        let outputs = [answers.masses.len(), answers.relative_errors.len(), answers.statuses.len()];
        if let Some(got) = lengths.chain(outputs).find(|length| *length != expected) {
            return Err(MapError::Lengths { got, expected });
        }
        let mut first = 0;
        while first < expected {
            interruption::check();
            let end = (first + MAP_PORTION).min(expected);
            let portion = contacts.slice(first, end);
            let masses = &mut answers.masses[first..end];
            let errors = &mut answers.relative_errors[first..end];
            let statuses = &mut answers.statuses[first..end];
            statuses.fill(ContactStatus::Finite);
            if !self.uses_inertia || self.evaluate(portion, masses, errors) || !portion.has_points() {
                self.resolve_uncertain(portion, masses, errors, statuses);
            }
            first = end;
        }
        Ok(())
    }

    /// m̄ of one contact; equal to the result of [`fill_answers`](Self::fill_answers) within the stated error.
    pub fn effective_mass(&self, point: &Vector3<f64>, normal: &Vector3<f64>) -> BatchAnswer {
        let (mut mass, mut error, mut status) = ([0.0], [0.0], [ContactStatus::Finite]);
        let (p, n) = (point, normal);
        let contacts = ContactColumns { points: [&[p.x], &[p.y], &[p.z]], normals: [&[n.x], &[n.y], &[n.z]] };
        let mut answers =
            MapAnswers { masses: &mut mass, relative_errors: &mut error, statuses: &mut status };
        // All columns have length one, so no error is possible.
        let _ = self.fill_answers(contacts, &mut answers);
        let mass = match status[0] {
            ContactStatus::Finite => Some(EffectiveMass::Finite(mass[0])),
            ContactStatus::Immovable => Some(EffectiveMass::Immovable),
            ContactStatus::Massless | ContactStatus::MasslessToRounding => Some(EffectiveMass::Massless),
            ContactStatus::Unanswered => None,
        };
        let error = Some(error[0]).filter(|e| e.is_finite());
        let remarks = self.pose.remarks().iter().collect();
        BatchAnswer { mass, error: error.map(|e| e * mass.map_or(0.0, finite)), remarks }
    }

    /// Principal masses at a point (m, frame of the contact link): the axes of the belted ellipsoid. m̄ is stationary
    /// along the three directions, sorted from the lightest to the heaviest. Λ⁻¹ = J_v M_c⁻¹ J_vᵀ, 3×3; 1/m̄(n̂) =
    /// n̂ᵀ Λ⁻¹ n̂. `None` if a principal mass cannot be computed.
    ///
    /// A direction is immovable if its inverse mass is only rounding. If motions without mass respond to forces at
    /// the point, the corresponding directions are massless and come first. Source: Khatib 1995, §4 (cited from
    /// memory).
    pub fn principal_masses(&self, point: &Vector3<f64>) -> Option<[PrincipalMass; 3]> {
        let arm = point - self.constants.centre();
        let free = self.massless_wrenches.project_forces(&arm);
        let free_part = free.transpose() * free;
        let strength = free_part.trace();
        let matrix = self.inverse_mass(point);
        // Massless directions come first; m̄ is stationary within the remaining subspace.
        let massless = if strength > MASSLESS_CLOSING {
            SymmetricEigen::new(free_part)
        } else {
            SymmetricEigen::new(Matrix3::zeros())
        };
        let mut directions: Vec<(Vector3<f64>, bool)> = Vec::with_capacity(3);
        let mut rest = Vec::with_capacity(3);
        for i in 0..3 {
            let direction: Vector3<f64> = massless.eigenvectors.column(i).into();
            if massless.eigenvalues[i] > MASSLESS_CLOSING * strength.max(f64::MIN_POSITIVE) {
                directions.push((direction, true));
            } else {
                rest.push(direction);
            }
        }
        let projected = Matrix3::from_fn(|a, b| match (rest.get(a), rest.get(b)) {
            (Some(x), Some(y)) => x.dot(&(matrix * y)),
            _ => 0.0,
        });
        let eigen = SymmetricEigen::new(projected);
        let mut found: Vec<(f64, Vector3<f64>)> = (0..3)
            .map(|i| {
                let v = eigen.eigenvectors.column(i);
                (eigen.eigenvalues[i], rest.iter().zip(v.iter()).map(|(r, c)| r * *c).sum::<Vector3<f64>>())
            })
            .filter(|(_, v)| v.norm() > 0.5)
            .collect();
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        directions.extend(found.into_iter().take(rest.len()).map(|(_, v)| (v.normalize(), false)));
        let mut principal = Vec::with_capacity(3);
        for (direction, _) in directions {
            // Choose the sign that makes the largest component positive.
            let largest =
                direction.iter().copied().fold(0.0, |m: f64, x| if x.abs() > m.abs() { x } else { m });
            let direction = if largest < 0.0 { -direction } else { direction };
            let answer = self.effective_mass(point, &direction);
            principal.push(PrincipalMass { mass: answer.mass?, error: answer.error, direction });
        }
        principal.try_into().ok()
    }

    /// Λ⁻¹ (1/kg) at a point, in the axes of the contact link, without the responses of massless motions.
    fn inverse_mass(&self, point: &Vector3<f64>) -> Matrix3<f64> {
        let forces = self.constants.project_forces(&(point - self.constants.centre()));
        forces.transpose() * forces
    }

    /// Computes Φ.
    fn compute_inertia(&mut self) {
        let pose = self.pose;
        let model = pose.assembly.model();
        if model.refuse_large_clusters(&pose.groups).is_err() {
            return;
        }
        let x_rl = pose.kinematics.link_frame(model, self.link);
        let centre = x_rl.point(&self.constants.centre());
        let mut recursion = Recursion::<6>::new(model);
        let mut deciding = Pivoting::<6>::new(model);
        for (link, sign) in [(Some(self.link), 1.0), (self.against, -1.0)] {
            let body = link.and_then(|link| model.body_of(link));
            for axis in 0..3 {
                let mut unit = Vector3::zeros();
                unit[axis] = sign;
                let unit = x_rl.vector(&unit);
                recursion.add_wrench(body, axis, Wrench::new(unit, Vector3::zeros()));
                recursion.add_wrench(body, 3 + axis, Wrench::new(Vector3::zeros(), unit));
            }
        }
        recursion.eliminate(model, &pose.kinematics, &pose.groups, &centre, &mut deciding);
        let mut factor = InertiaFactor::new(self.constants.reach());
        let is_sum = recursion.for_each_pivot(|t, pivot, motion| match pivot {
            Some(d) => factor.add(t, d),
            None => {
                factor.add_massless_motion(t, motion);
                true
            }
        });
        if deciding.indefinite || !is_sum {
            return;
        }
        self.is_clear = factor.is_clear();
        self.constants.set_factor(&factor);
        self.massless_wrenches = factor.into_massless_wrenches();
        self.has_inertia = true;
    }

    /// Computes m̄ and relative errors from Φ. Returns true if some contacts need a second check.
    fn evaluate(&self, contacts: ContactColumns<'_>, masses: &mut [f64], errors: &mut [f64]) -> bool {
        let mut doubt = false;
        let work = Evaluate { constants: &self.constants, contacts, masses, errors, doubt: &mut doubt };
        self.instructions.run(work);
        doubt || !self.massless_wrenches.is_empty()
    }

    /// Checks each contact again; contacts that Φ does not decide are computed separately.
    fn resolve_uncertain(
        &self,
        contacts: ContactColumns<'_>,
        masses: &mut [f64],
        errors: &mut [f64],
        statuses: &mut [ContactStatus],
    ) {
        for i in 0..masses.len() {
            let known = self.uses_inertia.then(|| self.known_status(contacts, i, errors[i])).flatten();
            match known {
                Some(ContactStatus::Finite) => {}
                Some(status) => (statuses[i], masses[i], errors[i]) = (status, number_of(status), f64::NAN),
                None => (statuses[i], masses[i], errors[i]) = self.respond_separately(contacts, i),
            }
        }
    }

    /// Status of a contact if Φ and the relative error decide the status reliably.
    fn known_status(&self, contacts: ContactColumns<'_>, i: usize, error: f64) -> Option<ContactStatus> {
        if !contacts.is_direction(i) {
            return None;
        }
        if !self.massless_wrenches.is_empty() {
            let (point, normal) = contacts.at(i);
            let part = self.massless_wrenches.fraction(&(point - self.constants.centre()), &normal);
            if part > MAP_FREE_CLEAR {
                return Some(ContactStatus::Massless);
            }
            // The comparison also rejects NaN.
            if part.is_nan() || part > MASSLESS_CLOSING {
                return None;
            }
        }
        if error <= MAP_TRUSTED_ERROR {
            return Some(ContactStatus::Finite);
        }
        let is_still = self.is_clear && error >= self.constants.coefficient() / MAP_STILL;
        is_still.then_some(ContactStatus::Immovable)
    }

    /// Computes status, m̄ and relative error of contact `i` by [`Pose::respond`].
    fn respond_separately(&self, contacts: ContactColumns<'_>, i: usize) -> (ContactStatus, f64, f64) {
        let (point, normal) = contacts.at(i);
        let contact = Contact { against: self.against, ..Contact::new(self.link, point, normal) };
        let Ok(response) = self.pose.respond(&contact) else {
            return (ContactStatus::Unanswered, f64::NAN, f64::NAN);
        };
        let error = response.effective_mass_error();
        match response.effective_mass {
            EffectiveMass::Finite(m) => (ContactStatus::Finite, m, error.map_or(f64::NAN, |e| e / m)),
            EffectiveMass::Immovable => (ContactStatus::Immovable, f64::NAN, f64::NAN),
            EffectiveMass::Massless => (ContactStatus::Massless, 0.0, f64::NAN),
        }
    }
}

/// m̄ reported for a status other than finite.
fn number_of(status: ContactStatus) -> f64 {
    if status == ContactStatus::Massless { 0.0 } else { f64::NAN }
}

/// m̄, if finite; otherwise 0.
fn finite(mass: EffectiveMass) -> f64 {
    match mass {
        EffectiveMass::Finite(m) => m,
        EffectiveMass::Immovable | EffectiveMass::Massless => 0.0,
    }
}
