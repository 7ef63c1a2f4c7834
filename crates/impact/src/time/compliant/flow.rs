//! Propagation of the linear motion ẏ = A y + B u with a few forces that are not linear.
//!
//! The linear part is exact: exponentials of A over steps h/2ᵏ. The forces uᵢ = fᵢ(qᵢ, q̇ᵢ) that are not linear are polynomials of degree 3 over
//! a step, equal to fᵢ at four Gauss points (collocation; Hairer, Lubich, Wanner 2006, §II.1.2), with the exact response of the linear part
//! to a polynomial force.

use nalgebra::{DMatrix, DVector};
use percuss_dynamics::{ElasticMotion, ElasticOutput, JointForce};

/// Number of Gauss points of a step.
const POINTS: usize = 4;
/// Gauss points in a step of length 1: roots of the Legendre polynomial of degree 4.
const GAUSS: [f64; POINTS] =
    [0.069_431_844_202_973_71, 0.330_009_478_207_571_87, 0.669_990_521_792_428_1, 0.930_568_155_797_026_3];
/// Iterations for the forces of a step: Newton's method doubles the digits.
const MOST_ITERATIONS: usize = 25;
/// Change of the forces, relative to their size, at which the iteration ends.
const CONVERGED: f64 = 1e-13;
/// Part of the displacement and speed of a force for its slopes: half of the digits.
const SLOPE_STEP: f64 = 1e-7;

/// Force over displacement (m, rad) and speed.
pub(super) type Law<'a> = Box<dyn Fn(f64, f64) -> f64 + 'a>;

/// Displacement and speed as functions of the scaled state and of the forces that are not linear.
#[derive(Clone, Debug)]
pub(super) struct Line {
    position: DVector<f64>,
    position_input: DVector<f64>,
    velocity: DVector<f64>,
    velocity_input: DVector<f64>,
}

impl Line {
    /// Displacement and speed.
    pub fn at(&self, state: &DVector<f64>, forces: &DVector<f64>) -> (f64, f64) {
        (
            self.position.dot(state) + self.position_input.dot(forces),
            self.velocity.dot(state) + self.velocity_input.dot(forces),
        )
    }

    fn slope(&self, part: usize, force: usize) -> f64 {
        if part == 0 { self.position_input[force] } else { self.velocity_input[force] }
    }
}

/// Units of the scaled state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales {
    /// Angular frequency, rad/s.
    pub frequency: f64,
    /// Mass, kg.
    pub mass: f64,
    /// Speed, m/s.
    pub speed: f64,
}

/// Matrices of a step.
struct Step {
    /// Change of the scaled state without forces that are not linear.
    alone: DMatrix<f64>,
    /// State at the Gauss points and at the end, per state and per force at the Gauss points (force by force within a point).
    points: Vec<DMatrix<f64>>,
}

/// Motion with its propagators. The scaled state is (y, impulse of the contact, 1).
pub(super) struct Flow<'a> {
    rate: DMatrix<f64>,
    input: DMatrix<f64>,
    scale: DVector<f64>,
    /// Penetration.
    pub contact: Line,
    /// Rows of bushes and elements.
    pub rows: Vec<Line>,
    /// Components of the forces of the ideal joints, as displacements.
    pub joints: Vec<Vec<Line>>,
    /// Displacement along each input, and its constant value.
    pub applied: Vec<(Line, f64)>,
    /// Forces that are not linear: number of the input, displacement and law.
    pub laws: Vec<(usize, Line, Law<'a>)>,
    /// Stiffness and damping of the linear part of the contact.
    contact_law: [f64; 2],
    /// Number of the law of the contact.
    law_of_contact: Option<usize>,
    /// Duration of a step of level 0, s.
    step: f64,
    steps: Vec<Option<Step>>,
}

impl<'a> Flow<'a> {
    /// Flow of a motion. `constants`: constant value of each input; `laws`: inputs with further forces and the row (`None`: the contact) whose
    /// displacement they have; `contact_law`: linear part of the contact.
    pub fn new(
        motion: &ElasticMotion,
        constants: &DVector<f64>,
        laws: Vec<(usize, Option<usize>, Law<'a>)>,
        contact_law: [f64; 2],
        (scales, step): (Scales, f64),
        joints: &[JointForce],
    ) -> Self {
        let n = motion.rate.nrows();
        let total = n + 2;
        let masses = motion.masses();
        let length = scales.speed * scales.mass.sqrt() / scales.frequency;
        let mut scale = DVector::from_element(total, length);
        scale.rows_mut(n - masses, masses).fill(length * scales.frequency);
        (scale[n], scale[n + 1]) = (scales.mass * scales.speed, 1.0);
        let ports: Vec<usize> = laws.iter().map(|(input, ..)| *input).collect();
        let line = |output: &ElasticOutput| {
            let row = |of_state: &DVector<f64>, of_input: &DVector<f64>| {
                let mut row = DVector::zeros(total);
                row.rows_mut(0, n).copy_from(of_state);
                row[n + 1] = of_input.dot(constants);
                row.component_mul(&scale)
            };
            let of_ports = |of_input: &DVector<f64>| DVector::from_fn(ports.len(), |p, _| of_input[ports[p]]);
            Line {
                position: row(&output.position, &output.position_input),
                velocity: row(&output.velocity, &output.velocity_input),
                position_input: of_ports(&output.position_input),
                velocity_input: of_ports(&output.velocity_input),
            }
        };
        let contact = line(&motion.contact);
        let law_of_contact = laws.iter().position(|(_, row, _)| row.is_none());
        let [k, c] = contact_law;
        let mut rate = DMatrix::zeros(total, total);
        rate.view_mut((0, 0), (n, n)).copy_from(&motion.rate);
        rate.view_mut((0, n + 1), (n, 1)).copy_from(&(&motion.input * constants));
        for r in 0..n {
            for column in 0..total {
                rate[(r, column)] *= scale[column] / scale[r];
            }
        }
        let force = (&contact.position * k + &contact.velocity * c) / scale[n];
        rate.row_mut(n).copy_from(&force.transpose());
        let mut input = DMatrix::zeros(total, ports.len());
        for (p, &port) in ports.iter().enumerate() {
            input.view_mut((0, p), (n, 1)).copy_from(&motion.input.column(port));
            input[(n, p)] = contact.position_input[p] * k + contact.velocity_input[p] * c;
            if law_of_contact == Some(p) {
                input[(n, p)] += 1.0;
            }
        }
        for r in 0..total {
            input.row_mut(r).scale_mut(1.0 / scale[r]);
        }
        let line_of = |row: Option<usize>| match row {
            None => contact.clone(),
            Some(row) => line(&motion.rows[row].output),
        };
        Self {
            laws: laws.into_iter().map(|(input, row, law)| (input, line_of(row), law)).collect(),
            rows: motion.rows.iter().map(|row| line(&row.output)).collect(),
            joints: joints.iter().map(|joint| joint.components.iter().map(line).collect()).collect(),
            applied: motion.applied.iter().map(line).zip(constants.iter().copied()).collect(),
            rate,
            input,
            scale,
            contact,
            contact_law,
            law_of_contact,
            step,
            steps: Vec::new(),
        }
    }

    /// Duration of a step of a level, s.
    pub fn step_of(&self, level: usize) -> f64 {
        self.step * 0.5_f64.powi(i32::try_from(level).unwrap_or(i32::MAX))
    }

    /// Scaled state of a state y.
    pub fn scaled(&self, state: &DVector<f64>) -> DVector<f64> {
        let n = state.len();
        let value = |i: usize| if i < n { state[i] } else { f64::from(u8::from(i == n + 1)) };
        DVector::from_fn(self.scale.len(), |i, _| value(i) / self.scale[i])
    }

    /// State y of a scaled state.
    pub fn unscaled(&self, scaled: &DVector<f64>) -> DVector<f64> {
        DVector::from_fn(scaled.len() - 2, |i, _| scaled[i] * self.scale[i])
    }

    /// Impulse of the contact, N·s.
    pub fn impulse(&self, scaled: &DVector<f64>) -> f64 {
        let n = scaled.len() - 2;
        scaled[n] * self.scale[n]
    }

    /// Force of the contact, N.
    pub fn contact_force(&self, state: &DVector<f64>, forces: &DVector<f64>) -> f64 {
        let ((x, rate), [k, c]) = (self.contact.at(state, forces), self.contact_law);
        k * x + c * rate + self.law_of_contact.map_or(0.0, |law| forces[law])
    }

    /// Values of all inputs at the forces that are not linear.
    pub fn inputs(&self, forces: &DVector<f64>) -> DVector<f64> {
        let mut inputs = DVector::from_fn(self.applied.len(), |i, _| self.applied[i].1);
        self.laws.iter().zip(forces.iter()).for_each(|((input, ..), force)| inputs[*input] += force);
        inputs
    }

    /// Forces that are not linear at a state: uᵢ = fᵢ(qᵢ(y, u), q̇ᵢ(y, u)).
    pub fn forces(&self, state: &DVector<f64>) -> DVector<f64> {
        self.solve(std::slice::from_ref(state), |_, _, _, _| 0.0)
    }

    /// Forces uᵢ = fᵢ at several points, by Newton's method. `states`: the states at the points without these forces; `response`: change of the
    /// displacement (part 0) or speed (part 1) of a law at a point, per force of the list, through the state.
    fn solve(
        &self,
        states: &[DVector<f64>],
        response: impl Fn(usize, usize, usize, usize) -> f64,
    ) -> DVector<f64> {
        let (p, count) = (self.laws.len(), states.len());
        let mut unknown = DVector::zeros(p * count);
        if p == 0 {
            return unknown;
        }
        for _ in 0..MOST_ITERATIONS {
            let mut residual = unknown.clone();
            let mut jacobian = DMatrix::identity(p * count, p * count);
            for point in 0..count {
                let own = unknown.rows(point * p, p).into_owned();
                for (i, (_, line, law)) in self.laws.iter().enumerate() {
                    let row = point * p + i;
                    let (mut x, mut v) = line.at(&states[point], &own);
                    for column in 0..p * count {
                        x += response(point, i, 0, column) * unknown[column];
                        v += response(point, i, 1, column) * unknown[column];
                    }
                    let value = law(x, v);
                    residual[row] -= value;
                    let (dx, dv) = (SLOPE_STEP * (x.abs() + 1e-6), SLOPE_STEP * (v.abs() + 1e-3));
                    let slopes = [
                        (law(x + dx, v) - law(x - dx, v)) / (2.0 * dx),
                        (law(x, v + dv) - law(x, v - dv)) / (2.0 * dv),
                    ];
                    for column in 0..p * count {
                        for (part, slope) in slopes.iter().enumerate() {
                            let direct = match column.checked_sub(point * p) {
                                Some(force) if force < p => line.slope(part, force),
                                _ => 0.0,
                            };
                            jacobian[(row, column)] -= slope * (direct + response(point, i, part, column));
                        }
                    }
                }
            }
            let Some(change) = jacobian.lu().solve(&residual) else { break };
            unknown -= &change;
            if change.amax() <= CONVERGED * (unknown.amax() + f64::MIN_POSITIVE) {
                break;
            }
        }
        unknown
    }

    /// State after the duration step/2^level.
    pub fn advance(&mut self, state: &DVector<f64>, level: usize) -> DVector<f64> {
        if self.steps.len() <= level {
            self.steps.resize_with(level + 1, || None);
        }
        if self.steps[level].is_none() {
            let step = self.matrices(level);
            self.steps[level] = Some(step);
        }
        let Some(step) = &self.steps[level] else { return state.clone() };
        let p = self.laws.len();
        if p == 0 {
            return &step.alone * state;
        }
        let n = state.len();
        let states: Vec<DVector<f64>> = step.points.iter().map(|point| point.columns(0, n) * state).collect();
        let lines: Vec<[&DVector<f64>; 2]> =
            self.laws.iter().map(|(_, line, _)| [&line.position, &line.velocity]).collect();
        let table: Vec<DVector<f64>> = (0..POINTS * p * 2)
            .map(|i| {
                let (point, law, part) = (i / (2 * p), i / 2 % p, i % 2);
                step.points[point].columns(n, POINTS * p).tr_mul(lines[law][part])
            })
            .collect();
        let response = |point: usize, law: usize, part: usize, column: usize| {
            table[(point * p + law) * 2 + part][column]
        };
        let forces = self.solve(&states[..POINTS], response);
        &states[POINTS] + step.points[POINTS].columns(n, POINTS * p) * forces
    }

    /// Matrices of the step of a level.
    fn matrices(&self, level: usize) -> Step {
        let h = self.step_of(level);
        let (n, p) = (self.rate.nrows(), self.laws.len());
        if p == 0 {
            return Step { alone: (&self.rate * h).exp(), points: Vec::new() };
        }
        // Derivatives of the polynomial force follow the state: w₀ is the force, ẇₘ = wₘ₊₁.
        let mut matrix = DMatrix::zeros(n + POINTS * p, n + POINTS * p);
        matrix.view_mut((0, 0), (n, n)).copy_from(&(&self.rate * h));
        matrix.view_mut((0, n), (n, p)).copy_from(&(&self.input * h));
        for i in 0..(POINTS - 1) * p {
            matrix[(n + i, n + i + p)] = 1.0;
        }
        let factorial = |m: usize| (1..=m).product::<usize>() as f64;
        let values = DMatrix::from_fn(POINTS, POINTS, |i, m| {
            GAUSS[i].powi(i32::try_from(m).unwrap_or(0)) / factorial(m)
        });
        let of_values = values.try_inverse().unwrap_or_else(|| DMatrix::zeros(POINTS, POINTS));
        let spread = of_values.kronecker(&DMatrix::identity(p, p));
        let at = |place: f64| {
            let all = (&matrix * place).exp();
            let mut own = DMatrix::zeros(n, n + POINTS * p);
            own.columns_mut(0, n).copy_from(&all.view((0, 0), (n, n)));
            own.columns_mut(n, POINTS * p).copy_from(&(all.view((0, n), (n, POINTS * p)) * &spread));
            own
        };
        let points = GAUSS.iter().copied().chain([1.0]).map(at).collect();
        Step { alone: DMatrix::zeros(0, 0), points }
    }
}
