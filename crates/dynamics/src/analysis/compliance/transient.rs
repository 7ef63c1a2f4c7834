//! Motion in time of a mechanism with elastic bushes: first-order equations, in which massless motions are eliminated.

use super::elements::{ElasticDirection, ElasticRow};
use super::residual::{solve_positive, solve_positive_columns};
use super::response::symmetric_eigen;
use super::system::{ComplianceError, ElasticSystem};
use crate::analysis::pose::Pose;
use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use crate::tolerances::NO_INERTIA;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_mechanism::LinkId;

/// Force on a mechanism with bushes beside those of its linear elements; a value of the input multiplies it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ElasticInput {
    /// Force of 1 N against the penetration of the contact.
    Contact,
    /// Force of 1 N against the motion of the element with this number in the list of [`ElasticSystem::new`].
    Element(usize),
    /// Weight of all links in a gravity of these components, m/s², root axes.
    Gravity(Vector3<f64>),
}

/// Displacement (m, rad) and velocity of a motion as linear functions of the state y and of the inputs u.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticOutput {
    /// Displacement per state.
    pub position: DVector<f64>,
    /// Displacement per input, for motions without mass and damping.
    pub position_input: DVector<f64>,
    /// Velocity per state.
    pub velocity: DVector<f64>,
    /// Velocity per input, for motions without mass.
    pub velocity_input: DVector<f64>,
}

/// Row of a bush, a spring, a damper or a gear: its force is preload − (k x + c ẋ).
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticRowOutput {
    /// Name of the bush or element.
    pub element: String,
    /// Direction.
    pub direction: ElasticDirection,
    /// Number of the element in the list of [`ElasticSystem::new`]; `None` for a bush.
    pub number: Option<usize>,
    /// True for a rotation, with a moment in N·m.
    pub is_moment: bool,
    /// k in motion, N/m or N·m/rad.
    pub stiffness: f64,
    /// c with the equivalent damping of the loss factor, N·s/m or N·m·s/rad.
    pub damping: f64,
    /// Force of a bush at the touch in the direction of the force −(k x + c ẋ), N or N·m.
    pub preload: f64,
    /// Displacement and velocity of the row.
    pub output: ElasticOutput,
}

/// Motion of a mechanism with elastic bushes, ẏ = A y + B u.
///
/// ```text
/// M z̈ + C ż + K z = G u,   z = W a + U_d d + U_a e,   y = (a, d, ȧ)
/// ```
///
/// | symbol | meaning                                                                       |
/// |--------|-------------------------------------------------------------------------------|
/// | W      | motions with mass, WᵀMW = 1                                                   |
/// | U_d    | massless motions with damping: states of first order                          |
/// | U_a    | massless motions without damping: in balance, K_aa e = G_a u − K_a(a, d)      |
///
/// The velocities of massless motions jump when a force jumps. Loss factors act as dampers c = ηk/ω at one angular frequency ω.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticMotion {
    /// A, n×n.
    pub rate: DMatrix<f64>,
    /// B, n×p: one column per input.
    pub input: DMatrix<f64>,
    /// Penetration of the contact and its rate.
    pub contact: ElasticOutput,
    /// Displacement in the direction of each input: its power is u times the velocity.
    pub applied: Vec<ElasticOutput>,
    /// Rows of the bushes and elements.
    pub rows: Vec<ElasticRowOutput>,
    /// Highest natural angular frequency without damping, rad/s.
    pub highest_frequency: f64,
    /// Number of coordinates a.
    masses: usize,
    pub(super) coordinates: ElasticCoordinates,
    /// State per coordinates z and per velocities ż.
    state: [DMatrix<f64>; 2],
}

/// All coordinates z as functions of the state and of the inputs, and their velocities.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ElasticCoordinates {
    position: DMatrix<f64>,
    position_input: DMatrix<f64>,
    pub(super) velocity: DMatrix<f64>,
    velocity_input: DMatrix<f64>,
}

impl ElasticCoordinates {
    fn output(&self, row: &DVector<f64>) -> ElasticOutput {
        ElasticOutput {
            position: self.position.tr_mul(row),
            position_input: self.position_input.tr_mul(row),
            velocity: self.velocity.tr_mul(row),
            velocity_input: self.velocity_input.tr_mul(row),
        }
    }
}

impl ElasticMotion {
    /// State of undeflected elements with the velocities ż (coordinates of [`ElasticSystem::rigid_velocities`]).
    pub fn start(&self, velocities: &DVector<f64>) -> DVector<f64> {
        &self.state[1] * velocities
    }

    /// State of this motion at the state and inputs of another motion of the same system, such as that after the end of a contact.
    pub fn continued(
        &self,
        other: &ElasticMotion,
        state: &DVector<f64>,
        inputs: &DVector<f64>,
    ) -> DVector<f64> {
        let of = &other.coordinates;
        let z = &of.position * state + &of.position_input * inputs;
        let velocity = &of.velocity * state + &of.velocity_input * inputs;
        &self.state[0] * z + &self.state[1] * velocity
    }

    /// Number of motions with mass: the last entries of the state are their velocities.
    pub fn masses(&self) -> usize {
        self.masses
    }

    /// Kinetic energy ½|ȧ|², J, with a free body on the other side.
    pub fn kinetic_energy(&self, state: &DVector<f64>) -> f64 {
        0.5 * state.rows(state.len() - self.masses, self.masses).norm_squared()
    }
}

impl ElasticSystem {
    /// Velocities ż of the rigid mechanism with the rates `rates` of its coordinates (those of [`Pose::mass_matrix`]), at the given closing speed
    /// (m/s), which determines the speed of a free body on the other side. `None` if the mechanism with bushes does not determine them.
    pub fn rigid_velocities(&self, pose: &Pose, rates: &[f64], closing_speed: f64) -> Option<DVector<f64>> {
        let rates = DVector::from_column_slice(rates);
        let (model, origin) = (pose.assembly.model(), Vector3::zeros());
        let mut rows = Vec::new();
        let mut right = Vec::new();
        let mut add = |row: DVector<f64>, value: f64| {
            rows.push(row);
            right.push(value);
        };
        let length = model.mechanism.characteristic_length();
        for link in model.mechanism.link_ids() {
            let own = model.point_jacobian(&pose.kinematics, link, &origin) * &rates;
            let turning = model.angular_jacobian(&pose.kinematics, link) * &rates * length;
            let released = self.model.point_jacobian(&self.kinematics, link, &origin) * &self.basis;
            let released_turning = self.model.angular_jacobian(&self.kinematics, link) * &self.basis * length;
            for i in 0..3 {
                add(released.row(i).transpose(), own[i]);
                add(released_turning.row(i).transpose(), turning[i]);
            }
        }
        add(self.contact.clone(), closing_speed);
        self.rows.iter().filter(|row| row.is_rigid).for_each(|row| add(row.row.clone(), 0.0));
        let matrix = DMatrix::from_fn(rows.len(), self.contact.len(), |r, c| rows[r][c]);
        let right = DVector::from_vec(right);
        let normal = matrix.tr_mul(&matrix);
        let first = solve_positive(&normal, &matrix.tr_mul(&right))?;
        // One refinement removes the error of the normal equations.
        let residual = &right - &matrix * &first;
        Some(first + solve_positive(&normal, &matrix.tr_mul(&residual))?)
    }

    /// Equations of motion under inputs. `contact`: stiffness (N/m) and damping (N·s/m) of a linear contact, zeros for none; `loss_frequency`:
    /// angular frequency of the dampers in place of loss factors, rad/s. `None` if a motion without mass, stiffness and damping closes the gap.
    ///
    /// # Errors
    /// [`ComplianceError`]: a decomposition that does not converge.
    pub fn motion(
        &self,
        contact: [f64; 2],
        inputs: &[ElasticInput],
        loss_frequency: f64,
    ) -> Result<Option<ElasticMotion>, ComplianceError> {
        let failed = || ComplianceError::Decomposition;
        let Some(basis) = self.resisting_motions(ElasticRow::acts)? else { return Ok(None) };
        let closing = basis.tr_mul(&self.contact);
        let mass = basis.tr_mul(&self.mass) * &basis;
        let damping_of = |row: &ElasticRow| row.damping + row.stiffness * row.loss_factor / loss_frequency;
        let reduced: Vec<DVector<f64>> = self.rows.iter().map(|row| basis.tr_mul(&row.row)).collect();
        let contact_row = [(&closing, contact)];
        let elements =
            self.rows.iter().zip(&reduced).map(|(row, own)| (own, [row.stiffness, damping_of(row)]));
        let all: Vec<(&DVector<f64>, [f64; 2])> = elements.chain(contact_row).collect();
        let (values, vectors) = symmetric_eigen(&mass).ok_or_else(failed)?;
        let largest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let with_mass: Vec<usize> = (0..values.len()).filter(|&i| values[i] > NO_INERTIA * largest).collect();
        let without: Vec<usize> = (0..values.len()).filter(|i| !with_mass.contains(i)).collect();
        let mut w = vectors.select_columns(&with_mass);
        for (c, &i) in with_mass.iter().enumerate() {
            w.column_mut(c).scale_mut(1.0 / values[i].sqrt());
        }
        let damped_rows = all.iter().filter(|(_, [_, c])| *c > 0.0).map(|(row, _)| *row);
        let massless = self.acting_part(damped_rows, &vectors.select_columns(&without))?;
        let (r, q, s) = (w.ncols(), massless.range.ncols(), massless.null.ncols());
        let mut t = DMatrix::zeros(basis.ncols(), r + q + s);
        t.columns_mut(0, r).copy_from(&w);
        t.columns_mut(r, q).copy_from(&massless.range);
        t.columns_mut(r + q, s).copy_from(&massless.null);
        let sum = |part: usize| {
            let mut sum = DMatrix::zeros(r + q + s, r + q + s);
            for (row, factors) in all.iter().filter(|(_, factors)| factors[part] != 0.0) {
                let row = t.tr_mul(*row);
                sum.ger(factors[part], &row, &row, 1.0);
            }
            sum
        };
        let (stiffness, damping) = (sum(0), sum(1));
        let force = |input: &ElasticInput| match input {
            ElasticInput::Contact => -&closing,
            ElasticInput::Element(number) => {
                let row = self.rows.iter().position(|row| row.number == Some(*number));
                row.map_or_else(|| DVector::zeros(basis.ncols()), |row| -&reduced[row])
            }
            ElasticInput::Gravity(gravity) => {
                basis.tr_mul(&self.basis.tr_mul(&weight(&self.model, &self.kinematics, gravity)))
            }
        };
        let forces: Vec<DVector<f64>> = inputs.iter().map(force).collect();
        let mut g = DMatrix::zeros(r + q + s, inputs.len());
        forces.iter().enumerate().for_each(|(c, force)| g.set_column(c, &t.tr_mul(force)));
        // e = X (a, d) + E u.
        let of_balance = stiffness.view((r + q, r + q), (s, s)).into_owned();
        let solve = |right: DMatrix<f64>| solve_positive_columns(&of_balance, right).ok_or_else(failed);
        let x = -solve(stiffness.view((r + q, 0), (s, r + q)).into_owned())?;
        let e = solve(g.rows(r + q, s).into_owned())?;
        let coupling = stiffness.view((0, r + q), (r + q, s));
        let k = stiffness.view((0, 0), (r + q, r + q)) + coupling * &x;
        let g = g.rows(0, r + q) - coupling * &e;
        let c = damping.view((0, 0), (r + q, r + q));
        // ḋ = D_y y + D_u u.
        let n = 2 * r + q;
        let mut force = DMatrix::zeros(r + q, n);
        force.columns_mut(0, r + q).copy_from(&-&k);
        let mut of_rates = force.clone();
        of_rates.columns_mut(r + q, r).copy_from(&-c.columns(0, r));
        let c_dd = c.view((r, r), (q, q)).into_owned();
        let d_y = solve_positive_columns(&c_dd, of_rates.rows(r, q).into_owned()).ok_or_else(failed)?;
        let d_u = solve_positive_columns(&c_dd, g.rows(r, q).into_owned()).ok_or_else(failed)?;
        let c_wd = c.view((0, r), (r, q));
        let mut rate = DMatrix::zeros(n, n);
        rate.view_mut((0, r + q), (r, r)).fill_with_identity();
        rate.rows_mut(r, q).copy_from(&d_y);
        rate.rows_mut(r + q, r).copy_from(&(of_rates.rows(0, r) - c_wd * &d_y));
        let mut input = DMatrix::zeros(n, inputs.len());
        input.rows_mut(r, q).copy_from(&d_u);
        input.rows_mut(r + q, r).copy_from(&(g.rows(0, r) - c_wd * &d_u));
        // z = T (a, d, e).
        let follows = t.columns(0, r + q) + &massless.null * &x;
        let mut position = DMatrix::zeros(t.nrows(), n);
        position.columns_mut(0, r + q).copy_from(&follows);
        let mut velocity = follows.columns(r, q) * &d_y;
        let with_rates = velocity.columns(r + q, r) + follows.columns(0, r);
        velocity.columns_mut(r + q, r).copy_from(&with_rates);
        let coordinates = ElasticCoordinates {
            position,
            position_input: &massless.null * &e,
            velocity_input: follows.columns(r, q) * &d_u,
            velocity,
        };
        let of_mass = w.tr_mul(&mass) * basis.transpose();
        let mut state = [DMatrix::zeros(n, basis.nrows()), DMatrix::zeros(n, basis.nrows())];
        state[0].rows_mut(0, r).copy_from(&of_mass);
        state[0].rows_mut(r, q).copy_from(&(massless.range.transpose() * basis.transpose()));
        state[1].rows_mut(r + q, r).copy_from(&of_mass);
        let row_output = |(row, own): (&ElasticRow, &DVector<f64>)| ElasticRowOutput {
            element: row.element.clone(),
            direction: row.direction,
            number: row.number,
            is_moment: row.is_moment,
            stiffness: row.stiffness,
            damping: damping_of(row),
            preload: if row.number.is_none() { row.force } else { 0.0 },
            output: coordinates.output(own),
        };
        let (squares, _) = symmetric_eigen(&k.view((0, 0), (r, r)).into_owned()).ok_or_else(failed)?;
        Ok(Some(ElasticMotion {
            rate,
            input,
            contact: coordinates.output(&closing),
            applied: forces.iter().map(|force| coordinates.output(force)).collect(),
            rows: self.rows.iter().zip(&reduced).map(row_output).collect(),
            highest_frequency: squares.last().map_or(0.0, |most| most.max(0.0).sqrt()),
            masses: r,
            coordinates: ElasticCoordinates {
                position: &basis * &coordinates.position,
                position_input: &basis * &coordinates.position_input,
                velocity: &basis * &coordinates.velocity,
                velocity_input: &basis * &coordinates.velocity_input,
            },
            state,
        }))
    }
}

/// Generalised forces of the weight of all links over the coordinates. `gravity`: m/s², root axes.
pub(super) fn weight(model: &Model, kinematics: &Kinematics, gravity: &Vector3<f64>) -> DVector<f64> {
    let mechanism = &model.mechanism;
    let force = |link: LinkId| {
        let inertial = mechanism.link(link).inertial()?;
        let jacobian = model.point_jacobian(kinematics, link, &inertial.com);
        Some(jacobian.tr_mul(gravity) * inertial.mass)
    };
    let start = DVector::zeros(model.coordinates.len());
    mechanism.link_ids().filter_map(force).fold(start, |sum, force| sum + force)
}
