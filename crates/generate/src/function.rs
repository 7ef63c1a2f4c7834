//! Expressions of the generated functions, and their comparison with the library at sampled configurations.

use crate::error::GenerateError;
use crate::expression::graph::{Expr, Graph};
use crate::expression::statements::Statements;
use crate::loops::constraint_rows::{Constraints, constraints, over_coordinates};
use crate::loops::rate_elimination::{Rates, eliminate_rates};
use crate::mechanics::body_frames::Bodies;
use crate::mechanics::mass_matrix::{
    Elimination, SymmetricMatrix, reduced_mass_matrix, sparse_dot, tree_mass_matrix,
};
use crate::mechanics::tree::Tree;
use crate::request::Request;
use crate::samples::{Sample, samples};
use percuss_dynamics::input::OPEN_ROW;
use percuss_dynamics::{Direction, EffectiveMass};
use percuss_mechanism::{ClosureKind, JointId, JointKind};

/// Number of random configurations for the choice of rows and for the reference values.
const SAMPLES: usize = 8;
/// Closing speed, relative to the speed of unit rates, below which a contact is immovable; as in the library.
const IMMOVABLE: f64 = 1e-10;
/// Pivot, relative to the largest of equal unit, below which a motion counts as massless.
const MASSLESS_PIVOT: f64 = 1e-13;
/// Relative difference from the library that is accepted at the samples, in addition to the stated error.
const DISAGREEMENT: f64 = 1e-9;
/// Twice the kinetic energy at unit rate, relative to the largest, below which a coordinate moves no mass: the square of
/// a rounding error.
const NO_MASS: f64 = 1e-20;
/// Closing speed at unit rate, relative, below which a coordinate without mass does not change the gap.
const NO_SPEED: f64 = 1e-10;
/// Largest number of operations.
const MOST_OPERATIONS: usize = 60_000;
/// Length of a line below this part of its length as drawn has no direction; as in the library.
const SHORTEST_LINE: f64 = 0.1;

/// Output of a function about one coordinate.
#[derive(Clone, Debug)]
pub(crate) struct NamedOutput {
    /// Joint, `None` for the floating base, and index of the velocity.
    pub joint: Option<JointId>,
    pub component: usize,
    pub turns: bool,
    pub value: Expr,
}

/// Change of the positions of a joint in a Newton step.
#[derive(Clone, Debug)]
pub(crate) struct PositionStep {
    pub kind: JointKind,
    /// First input of the joint.
    pub first: usize,
    /// Index of the velocity within the joint.
    pub component: usize,
    pub value: Expr,
}

impl PositionStep {
    /// Displacement, m, of a unit step: 1 for a translation, the moment arm `scale` (m) for a rotation of 1 rad.
    pub fn length(&self, scale: f64) -> f64 {
        let turns = match self.kind {
            JointKind::Revolute | JointKind::Continuous | JointKind::Spherical => true,
            JointKind::Prismatic | JointKind::Fixed => false,
            JointKind::Planar => self.component == 2,
            JointKind::Floating => self.component < 3,
        };
        if turns { scale } else { 1.0 }
    }
}

/// Expressions of all functions.
pub(crate) struct Functions {
    pub graph: Graph,
    pub tree: Tree,
    /// 1/m̄, 1/kg.
    pub response: Expr,
    /// Σ of squares that is at most 1 if the loops are closed.
    pub closure: Option<Expr>,
    /// Residual at which the loops count as open, m.
    pub closure_tolerance: f64,
    /// Σ of squares that is at most 1 if the choice of rows is valid.
    pub choice: Option<Expr>,
    /// Value that is at most 1 if the line of the normal is long enough.
    pub line: Option<Expr>,
    /// Responses below this limit are immovable, 1/kg.
    pub immovable: f64,
    /// Velocities at unit response: divided by the response they are v*.
    pub velocities: Vec<NamedOutput>,
    /// Derivatives of the response.
    pub gradient: Vec<NamedOutput>,
    /// Φ, 6×6 by rows.
    pub mobility: Vec<Expr>,
    /// Newton steps of the dependent positions.
    pub steps: Vec<PositionStep>,
    /// Names of the joints that drive the loops.
    pub drivers: Vec<JointId>,
    pub samples: Vec<Sample>,
}

/// Builds the expressions of a request.
pub(crate) fn build(request: &Request) -> Result<Functions, GenerateError> {
    refuse_unsupported(request)?;
    let mut g = Graph::default();
    let tree = Tree::new(request);
    let body_of = |link: percuss_mechanism::LinkId| tree.links[link.index()].0;
    let mut preferred = tree.ancestors(body_of(request.contact.link));
    preferred.extend(request.contact.against.into_iter().flat_map(|link| tree.ancestors(body_of(link))));
    let bodies = Bodies::new(&mut g, tree, &preferred, request.scale());
    let samples = samples(request, &bodies.tree, SAMPLES);
    if !samples.iter().any(|s| matches!(s.outcome, EffectiveMass::Finite(_))) {
        return Err(first_refusal(request, &samples));
    }
    let contact = bodies.contact(&mut g, request);
    let loops = constraints(&mut g, &bodies, request);
    let mut rates = rates(&mut g, &bodies, request, &loops, &samples)?;
    let matrix = tree_mass_matrix(&mut g, &bodies);
    let lengths = coordinate_lengths(request, &bodies.tree);
    leave_out_massless(&mut g, &bodies, &matrix, &contact.row, &lengths, &samples, &mut rates);
    let velocity_rates = velocity_rates(&mut g, &bodies, &rates);
    let reduced = reduced_mass_matrix(&mut g, &matrix, &velocity_rates, rates.independent.len());
    let diagonal: Vec<Expr> = (0..reduced.len()).map(|k| reduced[k][k]).collect();
    let elimination = Elimination::new(&mut g, reduced);
    let reduce = |g: &mut Graph, row: &[Expr]| -> Vec<Expr> {
        let row = over_coordinates(g, &bodies, row);
        let column = |y: usize| rates.rates.iter().map(move |r| r[y]);
        (0..rates.independent.len()).map(|y| sparse_dot(g, row.iter().copied().zip(column(y)))).collect()
    };
    let row = reduce(&mut g, &contact.row);
    let eliminated = elimination.eliminate(&mut g, &row);
    let mut response = elimination.response(&mut g, &eliminated, &eliminated);
    if let Some(mass) = request.other_mass {
        let other = g.constant(1.0 / mass);
        response = g.add(response, other);
    }
    let scaled: Vec<f64> = rates.independent.iter().map(|&c| lengths[c]).collect();
    let immovable = check_pivots(&g, request, &bodies, &rates, &diagonal, &elimination, &scaled, &samples)?;
    compare(&g, response, immovable, &samples)?;
    let line = contact.line_square.map(|square| {
        let drawn = drawn_line(request, &bodies.tree);
        let least = g.constant((SHORTEST_LINE * drawn).powi(2));
        g.div(least, square)
    });
    let has_loops = !loops.rows.is_empty();
    let closure_tolerance = closure_tolerance(&g, &loops, request, &samples);
    let closure = has_loops.then(|| closure_violation(&mut g, &loops, closure_tolerance));
    let choice = Some(rates.violation).filter(|v| !g.is_zero(*v));
    let mut functions = Functions {
        response,
        closure: closure.filter(|c| !g.is_zero(*c)),
        closure_tolerance,
        choice,
        line,
        immovable,
        velocities: Vec::new(),
        gradient: Vec::new(),
        mobility: Vec::new(),
        steps: Vec::new(),
        drivers: Vec::new(),
        samples,
        tree: bodies.tree.clone(),
        graph: Graph::default(),
    };
    let operations = Statements::new(&g, &[response]).operations;
    if operations > MOST_OPERATIONS {
        return Err(GenerateError::TooLong { operations, limit: MOST_OPERATIONS });
    }
    if request.additions.velocity {
        let independent = elimination.velocities(&mut g, &eliminated);
        for (v, velocity) in bodies.tree.velocities.iter().enumerate() {
            let pairs = velocity_rates[v].iter().copied().zip(independent.iter().copied());
            let value = sparse_dot(&mut g, pairs);
            let joint = bodies.tree.bodies[velocity.body].joint;
            let (component, turns) = (velocity.component, velocity.turns);
            functions.velocities.push(NamedOutput { joint, component, turns, value });
        }
        functions.velocities.sort_by_key(|v| (v.joint, v.component));
    }
    if request.additions.gradient {
        functions.gradient = gradient(&mut g, &bodies.tree, response, &rates);
    }
    if request.additions.mobility {
        let rows = bodies.unit_wrench_rows(&mut g, request);
        let rows: Vec<Vec<Expr>> = rows
            .iter()
            .map(|row| {
                let row = reduce(&mut g, row);
                elimination.eliminate(&mut g, &row)
            })
            .collect();
        for a in &rows {
            for b in &rows {
                let entry = elimination.response(&mut g, a, b);
                functions.mobility.push(entry);
            }
        }
    }
    if request.additions.close {
        add_position_steps(&mut functions, &bodies, request, &rates)?;
    }
    functions.graph = g;
    Ok(functions)
}

/// Refuses contacts and closures for which no code is generated.
fn refuse_unsupported(request: &Request) -> Result<(), GenerateError> {
    match request.contact.normal {
        Direction::Toward(..) => return Err(GenerateError::LimitedLine),
        Direction::About(..) => return Err(GenerateError::Moment),
        Direction::Along(..) | Direction::TurningToward(..) | Direction::TurningAwayFrom(..) => {}
    }
    for closure in request.system.mechanism().closures() {
        if closure.kind() == ClosureKind::Distance && closure.distance().is_some_and(|d| d <= 0.0) {
            return Err(GenerateError::ZeroDistance { closure: closure.name().to_owned() });
        }
    }
    Ok(())
}

/// Reason why no sample has a finite m̄.
fn first_refusal(request: &Request, samples: &[Sample]) -> GenerateError {
    match samples.first().map(|sample| sample.outcome) {
        Some(EffectiveMass::Massless) => GenerateError::Massless,
        Some(_) => GenerateError::Immovable,
        None => match request.pose.respond(&request.contact) {
            Err(error) => error.into(),
            Ok(_) => GenerateError::SingularPose,
        },
    }
}

/// Displacement, m, of every coordinate at unit rate.
fn coordinate_lengths(request: &Request, tree: &Tree) -> Vec<f64> {
    let mut lengths = vec![1.0; tree.coordinates];
    for velocity in &tree.velocities {
        if velocity.turns {
            lengths[velocity.coordinate] = request.scale();
        }
    }
    lengths
}

/// Rates of the coordinates over the independent ones. The driving joints of the loops are independent if the code
/// closes the loops or gives derivatives, or if they are at least as good as any other choice.
fn rates(
    g: &mut Graph,
    bodies: &Bodies,
    request: &Request,
    loops: &Constraints,
    samples: &[Sample],
) -> Result<Rates, GenerateError> {
    let tree = &bodies.tree;
    let lengths = coordinate_lengths(request, tree);
    let assembly = request.pose.assembly();
    let rank = assembly.coordinates() - assembly.degrees_of_freedom();
    let inputs: Vec<Vec<f64>> = samples.iter().map(|s| s.inputs.clone()).collect();
    let free = vec![false; tree.coordinates];
    if loops.rows.is_empty() {
        return eliminate_rates(g, loops, 0, &free, &lengths, &inputs);
    }
    let drivers = assembly.drivers();
    let mut fixed = free.clone();
    for velocity in &tree.velocities {
        let joint = tree.bodies[velocity.body].joint;
        fixed[velocity.coordinate] |= joint.is_some_and(|id| drivers.contains(&id));
    }
    let driven = eliminate_rates(g, loops, rank, &fixed, &lengths, &inputs);
    if request.additions.close || request.additions.gradient {
        let names = drivers.iter().map(|&id| request.system.mechanism().joint(id).name().to_owned());
        return driven.map_err(|_| GenerateError::Drivers { drivers: names.collect::<Vec<_>>().join(", ") });
    }
    let best = eliminate_rates(g, loops, rank, &free, &lengths, &inputs)?;
    Ok(driven.ok().filter(|driven| driven.score >= 0.5 * best.score).unwrap_or(best))
}

/// Rates of the tree velocities over the independent coordinates.
fn velocity_rates(g: &mut Graph, bodies: &Bodies, rates: &Rates) -> Vec<Vec<Expr>> {
    let velocities = bodies.tree.velocities.iter();
    velocities
        .map(|v| rates.rates[v.coordinate].iter().map(|rate| g.scale(*rate, v.multiplier)).collect())
        .collect()
}

/// Leaves out the independent coordinates that move no mass and do not change the gap at any sample, such as the spin
/// of a massless rod. The choice is invalid where such a coordinate changes the gap.
fn leave_out_massless(
    g: &mut Graph,
    bodies: &Bodies,
    matrix: &SymmetricMatrix,
    contact_row: &[Expr],
    lengths: &[f64],
    samples: &[Sample],
    rates: &mut Rates,
) {
    let velocity_rates = velocity_rates(g, bodies, rates);
    let count = rates.independent.len();
    let mut energies = Vec::new();
    let mut speeds = Vec::new();
    for y in 0..count {
        let momentum: Vec<Expr> = (0..matrix.len())
            .map(|u| sparse_dot(g, matrix[u].iter().zip(&velocity_rates).map(|(m, r)| (*m, r[y]))))
            .collect();
        let length = lengths[rates.independent[y]];
        let energy = sparse_dot(g, velocity_rates.iter().zip(&momentum).map(|(r, p)| (r[y], *p)));
        energies.push(g.scale(energy, 1.0 / (length * length)));
        let speed = sparse_dot(g, contact_row.iter().zip(&velocity_rates).map(|(j, r)| (*j, r[y])));
        speeds.push(g.scale(speed, 1.0 / length));
    }
    let mut is_massless = vec![true; count];
    for sample in samples {
        let values = g.evaluate(&sample.inputs);
        let of = |e: Expr| values[e.index()].abs();
        let heaviest = energies.iter().map(|e| of(*e)).fold(0.0, f64::max);
        for y in 0..count {
            is_massless[y] &= of(energies[y]) <= NO_MASS * heaviest && of(speeds[y]) <= NO_SPEED;
        }
    }
    for y in (0..count).filter(|&y| is_massless[y]) {
        let scaled = g.scale(speeds[y], 0.1 / NO_SPEED);
        let square = g.square(scaled);
        rates.violation = g.add(rates.violation, square);
    }
    let keep = |y: &usize| !is_massless[*y];
    rates.independent = (0..count).filter(keep).map(|y| rates.independent[y]).collect();
    for row in &mut rates.rates {
        *row = (0..count).filter(keep).map(|y| row[y]).collect();
    }
}

/// Refuses pivots without mass, and returns the response below which the contact is immovable.
#[allow(clippy::too_many_arguments)]
fn check_pivots(
    g: &Graph,
    request: &Request,
    bodies: &Bodies,
    rates: &Rates,
    diagonal: &[Expr],
    elimination: &Elimination,
    lengths: &[f64],
    samples: &[Sample],
) -> Result<f64, GenerateError> {
    let mut limit = f64::INFINITY;
    for sample in samples {
        let values = g.evaluate(&sample.inputs);
        let of = |e: Expr| values[e.index()];
        let heaviest = diagonal.iter().zip(lengths).map(|(d, l)| of(*d) / (l * l)).fold(0.0, f64::max);
        let mut reference = 0.0;
        for (k, pivot) in elimination.pivots.iter().enumerate() {
            let (pivot, own) = (of(*pivot), of(diagonal[k]));
            let scaled = pivot / (lengths[k] * lengths[k]);
            if !(pivot > MASSLESS_PIVOT * own && scaled > 1e-18 * heaviest) {
                let coordinate = rates.independent[k];
                let velocity = bodies.tree.velocities.iter().find(|v| v.coordinate == coordinate);
                let joint = velocity.and_then(|v| bodies.tree.bodies[v.body].joint);
                let name =
                    joint.map(|id| format!("joint \"{}\"", request.system.mechanism().joint(id).name()));
                let joint = name.unwrap_or_else(|| "floating base".to_owned());
                return Err(GenerateError::MasslessMotion { joint, value: scaled / heaviest });
            }
            reference += lengths[k] * lengths[k] / pivot;
        }
        limit = limit.min(reference);
    }
    Ok(IMMOVABLE * IMMOVABLE * limit)
}

/// Compares the expressions with the library at all samples.
fn compare(g: &Graph, response: Expr, immovable: f64, samples: &[Sample]) -> Result<(), GenerateError> {
    for sample in samples {
        let value = g.evaluate(&sample.inputs)[response.index()];
        if let EffectiveMass::Finite(expected) = sample.outcome {
            let found = 1.0 / value;
            let difference = (found / expected - 1.0).abs();
            if !(value > immovable && difference <= DISAGREEMENT + 10.0 * sample.error) {
                return Err(GenerateError::Disagreement { found, expected, difference });
            }
        }
    }
    Ok(())
}

/// Length of the line of the normal with all joints at 0, m.
fn drawn_line(request: &Request, tree: &Tree) -> f64 {
    let contact = &request.contact;
    contact.normal.line().map_or(0.0, |(link, to)| {
        let end = tree.drawn_frame(request, link).point(&to);
        (end - tree.drawn_frame(request, contact.link).point(&contact.point)).norm()
    })
}

/// Residual at which loops count as open, m: that of the library, and more for the misfit of rounded files.
fn closure_tolerance(g: &Graph, loops: &Constraints, request: &Request, samples: &[Sample]) -> f64 {
    let worst = |sample: &Sample| {
        let values = g.evaluate(&sample.inputs);
        let residuals = loops.rows.iter().map(|row| row.residual).chain(loops.directions.iter().copied());
        residuals.map(|e| values[e.index()].abs()).fold(0.0, f64::max)
    };
    let worst = samples.iter().map(worst).fold(0.0, f64::max);
    (OPEN_ROW * request.scale()).max(10.0 * worst)
}

/// Σ (residual/tolerance)².
fn closure_violation(g: &mut Graph, loops: &Constraints, tolerance: f64) -> Expr {
    let residuals: Vec<Expr> =
        loops.rows.iter().map(|row| row.residual).chain(loops.directions.iter().copied()).collect();
    let terms: Vec<Expr> = residuals
        .into_iter()
        .map(|residual| {
            let scaled = g.scale(residual, 1.0 / tolerance);
            g.square(scaled)
        })
        .collect();
    g.sum(terms)
}

/// Derivatives of `response` (1/m̄) by the independent coordinates of joints; dependent joints follow the loops.
fn gradient(g: &mut Graph, tree: &Tree, response: Expr, rates: &Rates) -> Vec<NamedOutput> {
    let by_input = g.gradient(response, tree.inputs);
    let zero = g.zero();
    let mut by_coordinate = vec![zero; tree.coordinates];
    for body in tree.bodies.iter().filter(|b| b.mimic.is_none() && b.joint.is_some() && !b.is_locked) {
        let derivatives = &by_input[body.inputs.clone()];
        let first = tree.velocities[body.velocities.start].coordinate;
        let positions: Vec<Expr> = body.inputs.clone().map(|i| g.input(i)).collect();
        for (k, value) in position_derivatives(g, body.kind, &positions, derivatives).into_iter().enumerate()
        {
            by_coordinate[first + k] = value;
        }
    }
    let mut outputs = Vec::new();
    for (y, &c) in rates.independent.iter().enumerate() {
        let velocity =
            tree.velocities.iter().find(|v| v.coordinate == c && tree.bodies[v.body].mimic.is_none());
        let Some((velocity, Some(joint))) = velocity.map(|v| (v, tree.bodies[v.body].joint)) else {
            continue;
        };
        let column = rates.rates.iter().map(|r| r[y]);
        let value = sparse_dot(g, by_coordinate.iter().copied().zip(column));
        let (component, turns) = (velocity.component, velocity.turns);
        outputs.push(NamedOutput { joint: Some(joint), component, turns, value });
    }
    outputs
}

/// Derivatives along the velocities of one joint, from the derivatives over its positions.
fn position_derivatives(g: &mut Graph, kind: JointKind, q: &[Expr], d: &[Expr]) -> Vec<Expr> {
    let spin = |g: &mut Graph, q: &[Expr], d: &[Expr]| -> Vec<Expr> {
        // q̇ = ½ q ∘ (0, ω).
        let (w, x, y, z) = (q[0], q[1], q[2], q[3]);
        let minus = [x, y, z].map(|a| g.neg(a));
        let columns = [[minus[0], w, z, minus[1]], [minus[1], minus[2], w, x], [minus[2], y, minus[0], w]];
        columns
            .iter()
            .map(|column| {
                let sum = sparse_dot(g, column.iter().copied().zip(d.iter().copied()));
                g.scale(sum, 0.5)
            })
            .collect()
    };
    match kind {
        JointKind::Spherical => spin(g, q, d),
        JointKind::Floating => {
            let mut all = spin(g, &q[3..], &d[3..]);
            let rotation = crate::mechanics::body_frames::rotation_of_quaternion(g, &q[3..]);
            all.extend(g.rotate_back(&rotation, [d[0], d[1], d[2]]));
            all
        }
        JointKind::Fixed
        | JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Prismatic
        | JointKind::Planar => d.to_vec(),
    }
}

/// Newton steps of the dependent positions.
fn add_position_steps(
    functions: &mut Functions,
    bodies: &Bodies,
    request: &Request,
    rates: &Rates,
) -> Result<(), GenerateError> {
    if functions.closure.is_none() {
        return Err(GenerateError::NoLoops);
    }
    functions.drivers = request.pose.assembly().drivers();
    for &(coordinate, value) in &rates.corrections {
        let tree = &bodies.tree;
        let velocity = tree
            .velocities
            .iter()
            .find(|v| v.coordinate == coordinate && tree.bodies[v.body].mimic.is_none());
        let Some(velocity) = velocity else { continue };
        let body = &tree.bodies[velocity.body];
        let (kind, first, component) = (body.kind, body.inputs.start, velocity.component);
        functions.steps.push(PositionStep { kind, first, component, value });
    }
    Ok(())
}
