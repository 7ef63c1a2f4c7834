//! Impacts of contacts at many states, from arrays to arrays.

use crate::analysis::contact::GivenContact;
use crate::analysis::motion::opening;
use crate::analysis::system::position_names;
use crate::conversion::arrays::{float64, float64_matrix, shape};
use crate::conversion::errors::{input, of_argument};
use crate::conversion::threads::Threads;
use crate::sweep::parts_of;
use crate::sweep::portions::{Progress, run_portions};
use crate::sweep::row_contacts::BasePose;
use numpy::{PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use percuss::impact::{
    Component, ContactsLaw, JointRates, ReactionMap, SimultaneousLaw, StateImpact, friction_thresholds,
    state_impact,
};
use percuss::nalgebra::{Matrix3, Vector3};
use percuss::spatial::Twist;
use percuss::{
    Assembly as Assembled, Base, Configuration, Contact as Resolved, ContactStatus, Direction, Frame,
    LocatedContact, Pose as Posed, System as Compiled,
};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;

/// Law from its name.
fn law_of(name: &str) -> PyResult<ContactsLaw> {
    if name == "sticking" {
        return Ok(ContactsLaw::Sticking);
    }
    let found = SimultaneousLaw::ALL.into_iter().find(|law| law.name() == name);
    found.map(ContactsLaw::Simultaneous).ok_or_else(|| {
        input(format_args!(
            "law is \"{name}\"; expected \"newton\", \"poisson\", \"energetic\" or \"sticking\""
        ))
    })
}

/// Positions of a call.
struct Positions<'a> {
    system: &'a Compiled,
    assembly: &'a Arc<Assembled>,
    /// Positions of all joints, row by row.
    numbers: Vec<f64>,
    width: usize,
    bases: BasePose,
}

/// States and contacts of a call.
struct Question<'a> {
    system: &'a Compiled,
    contacts: Vec<Resolved>,
    positions: Positions<'a>,
    /// Velocities of all joints, row by row.
    velocities: Vec<f64>,
    /// Twists of the root link in its axes, row by row; empty if it is at rest.
    twists: Vec<f64>,
    restitution: Vec<f64>,
    law: ContactsLaw,
    wants_reactions: bool,
    wants_map: bool,
    /// Numbers of velocities of the joints.
    widths: Vec<usize>,
}

/// Impact at a state.
struct Impact {
    closing_speeds: Vec<f64>,
    /// Impulses on the contact links, world axes, three for each contact.
    impulses: Vec<f64>,
    normal_impulses: Vec<f64>,
    velocities: Vec<f64>,
    twist: Vec<f64>,
    energy_loss: f64,
    sticks: Vec<bool>,
    map: Vec<f64>,
    reactions: Vec<f64>,
}

/// Reason why a row has no impact.
enum Refusal {
    /// The state is invalid.
    State(String),
    /// The state is valid and has no result.
    NoAnswer(String),
}

impl Positions<'_> {
    /// Pose of a row.
    fn pose(&self, row: usize) -> Result<Posed, Refusal> {
        let own = &self.numbers[self.width * row..][..self.width];
        let mut configuration = Configuration::from_positions(self.system.mechanism(), own)
            .map_err(|error| Refusal::State(format!("positions: {error}")))?;
        if let Some(base) = self.bases.at(row) {
            configuration.set_base(*base);
        }
        self.assembly.pose(&configuration).map_err(|error| Refusal::NoAnswer(error.to_string()))
    }
}

impl Question<'_> {
    /// Impact at a row.
    fn solve(&self, row: usize) -> Result<Impact, Refusal> {
        let no_answer = |error: &dyn ToString| Refusal::NoAnswer(error.to_string());
        let pose = self.positions.pose(row)?;
        let locate = |contact| pose.locate(contact).map_err(|error| Refusal::State(error.to_string()));
        let located: Vec<LocatedContact> = self.contacts.iter().map(locate).collect::<Result<_, _>>()?;
        let rates = self.rates(row);
        if let Some(reason) = opening(self.system, &pose, &rates.joints) {
            return Err(Refusal::State(reason));
        }
        let found = state_impact(&pose, &located, &rates, self.law, &self.restitution, self.wants_map)
            .map_err(|error| no_answer(&error))?;
        let reactions = match self.wants_reactions {
            true => self.reactions(&pose, &located, &found).map_err(|error| no_answer(&error))?,
            false => Vec::new(),
        };
        let vector = |(contact, axes): (usize, &Matrix3<f64>)| -> [f64; 3] {
            pose.base().vector(&(axes * found.impulses.fixed_rows::<3>(3 * contact))).into()
        };
        let (twist, open) = (&found.after.base, |impulse: &Option<f64>| impulse.unwrap_or(f64::NAN));
        Ok(Impact {
            closing_speeds: found.before.iter().step_by(3).map(|speed| -speed).collect(),
            impulses: found.axes.iter().enumerate().flat_map(vector).collect(),
            normal_impulses: found.normal_impulses.iter().map(open).collect(),
            velocities: found.after.joints.concat(),
            twist: twist.angular.iter().chain(twist.linear.iter()).copied().collect(),
            energy_loss: found.energy_loss,
            sticks: found.sticks,
            map: found.map.map_or_else(Vec::new, |map| map.transpose().as_slice().to_vec()),
            reactions,
        })
    }

    /// Rates before the impact.
    fn rates(&self, row: usize) -> JointRates {
        let width: usize = self.widths.iter().sum();
        let mut own = self.velocities[width * row..][..width].iter().copied();
        let joints = self.widths.iter().map(|count| own.by_ref().take(*count).collect()).collect();
        let base = match self.twists.get(6 * row..6 * row + 6) {
            Some([a, b, c, x, y, z]) => Twist::new(Vector3::new(*a, *b, *c), Vector3::new(*x, *y, *z)),
            _ => Twist::zero(),
        };
        JointRates { joints, base }
    }

    /// Reactions in all joints: force, then moment; NaN if redundant constraints or contacts leave them open.
    fn reactions(
        &self,
        pose: &Posed,
        located: &[LocatedContact],
        found: &StateImpact,
    ) -> Result<Vec<f64>, Box<dyn std::error::Error>> {
        let joints = self.widths.len();
        if found.normal_impulses.contains(&None) {
            return Ok(vec![f64::NAN; 6 * joints]);
        }
        let map = ReactionMap::new(pose);
        let mut sum = vec![0.0; 6 * joints];
        for (row, impulse) in found.impulses.iter().enumerate().filter(|(_, impulse)| **impulse != 0.0) {
            let (contact, is_moment) = (self.contacts[row / 3], located[row / 3].is_moment);
            // The unit impulse of a response on the contact link is opposite to its normal.
            let axis = pose.base().vector(&-found.axes[row / 3].column(row % 3).into_owned());
            let along = if is_moment { Direction::About } else { Direction::Along };
            let response = pose.respond(&Resolved { normal: along(axis, Frame::World), ..contact })?;
            let reactions = map.reactions(&response, *impulse)?;
            for (own, joint) in sum.chunks_exact_mut(6).zip(&reactions.joints) {
                let components = joint.reaction.force.iter().chain(&joint.reaction.moment);
                let value = |component: &Component| component.value().unwrap_or(f64::NAN);
                own.iter_mut().zip(components).for_each(|(sum, component)| *sum += value(component));
            }
        }
        Ok(sum)
    }
}

/// Arrays of a call by name: results of N states, k contacts, n velocities, c coordinates and the joints.
///
/// velocities: (N, n). base_twist: (N, 6) in root axes. restitution: one for each contact. law: "newton", "poisson", "energetic", "sticking".
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "the states and the law")]
pub fn impact_rows<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    contacts: Vec<GivenContact<'py>>,
    positions: &Bound<'py, PyAny>,
    velocities: &Bound<'py, PyAny>,
    base_pose: Option<&Bound<'py, PyAny>>,
    base_twist: Option<&Bound<'py, PyAny>>,
    restitution: Vec<f64>,
    law: &str,
    wants: (bool, bool),
    threads: Option<usize>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (threads, progress) = (Threads::of(threads)?, Progress::of(progress)?);
    let (model, system, assembly) = parts_of(model)?;
    let mechanism = &model.read.mechanism;
    let names = position_names(mechanism);
    let q = float64_matrix(positions, "positions", "(N, p)", &names, "")?;
    let widths: Vec<usize> = mechanism.joints().iter().map(|joint| joint.kind().dofs()).collect();
    let (count, width): (usize, usize) = (q.shape()[0], widths.iter().sum());
    let table = |given: &Bound<'py, PyAny>, what: &str, width| table(given, what, [count, width]);
    let twists = base_twist.map(|twist| table(twist, "base_twist", 6)).transpose()?.unwrap_or_default();
    if system.base() == Base::Fixed
        && let Some(row) = twists.chunks(6).position(|twist| twist.iter().any(|x| *x != 0.0))
    {
        return Err(input(format_args!(
            "base_twist: the root link is fixed, and state {row} moves it; expected Model.system(base=\"floating\")"
        )));
    }
    let question = Question {
        system: &system,
        contacts: contacts
            .iter()
            .map(|contact| contact.resolve(mechanism).map_err(of_argument("contacts")))
            .collect::<PyResult<_>>()?,
        positions: Positions {
            system: &system,
            assembly: &assembly,
            numbers: table(q.as_any(), "positions", names.len())?,
            width: names.len(),
            bases: BasePose::of(base_pose, count)?,
        },
        velocities: table(velocities, "velocities", width)?,
        twists,
        restitution,
        law: law_of(law)?,
        wants_reactions: wants.0,
        wants_map: wants.1,
        widths,
    };
    let mut rows: Vec<Result<Impact, Refusal>> = Vec::with_capacity(count);
    run_portions(py, count, false, (threads, &progress), |range: Range<usize>| {
        let solved: Vec<_> = range.into_par_iter().map(|row| question.solve(row)).collect();
        rows.extend(solved);
        Ok(())
    })?;
    arrays(py, &question, &rows)
}

/// Numbers of a table of a given shape, which must be finite.
fn table(given: &Bound<'_, PyAny>, what: &str, expected: [usize; 2]) -> PyResult<Vec<f64>> {
    let found = float64(given, what, &[2], "(N, …)")?;
    if found.shape() != expected {
        let [got, expected] = [shape(found.shape()), shape(&expected)];
        return Err(input(format_args!("{what} has shape {got}; expected {expected}")));
    }
    let values: Vec<f64> = found.as_array().iter().copied().collect();
    match values.iter().position(|x| !x.is_finite()) {
        Some(at) => {
            let (row, column) = (at / expected[1], at % expected[1]);
            Err(input(format_args!("{what}[{row}, {column}] is {}; expected finite numbers", values[at])))
        }
        None => Ok(values),
    }
}

/// Thresholds of friction of a contact at N positions, (N, 3): sliding per closing speed, sticking, jamming; NaN without a value.
#[pyfunction]
pub fn friction_rows<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    contact: GivenContact<'py>,
    positions: &Bound<'py, PyAny>,
    base_pose: Option<&Bound<'py, PyAny>>,
    threads: Option<usize>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (threads, progress) = (Threads::of(threads)?, Progress::of(progress)?);
    let (model, system, assembly) = parts_of(model)?;
    let mechanism = &model.read.mechanism;
    let names = position_names(mechanism);
    let q = float64_matrix(positions, "q", "(N, p)", &names, "")?;
    let (count, width) = (q.shape()[0], names.len());
    let contact = contact.resolve(mechanism)?;
    if contact.normal.is_moment() {
        return Err(input("contact: a moment about an axis has no friction; expected a contact point"));
    }
    let numbers = table(q.as_any(), "q", [count, width])?;
    let bases = BasePose::of(base_pose, count)?;
    let positions = Positions { system: &system, assembly: &assembly, numbers, width, bases };
    let solve = |row: usize| -> Result<[f64; 3], String> {
        let pose = match positions.pose(row) {
            Ok(pose) => pose,
            Err(Refusal::State(reason)) => return Err(format!("q[{row}]: {reason}")),
            Err(Refusal::NoAnswer(_)) => return Ok([f64::NAN; 3]),
        };
        let found = pose.respond(&contact).ok().filter(|response| !response.singular_pose);
        let found = found.and_then(|response| friction_thresholds(&pose, &response).ok());
        let number = |x: Option<f64>| x.unwrap_or(f64::NAN);
        Ok(found.map_or([f64::NAN; 3], |found| [found.slope, found.sticking, found.jamming].map(number)))
    };
    let mut rows: Vec<f64> = Vec::with_capacity(3 * count);
    run_portions(py, count, false, (threads, &progress), |range: Range<usize>| {
        let solved: Result<Vec<_>, String> = range.into_par_iter().map(solve).collect();
        rows.extend(solved.map_err(input)?.into_flattened());
        Ok(())
    })?;
    PyArray1::from_vec(py, rows).call_method1("reshape", ((count, 3),))
}

/// Arrays of the results; NaN for rows without a result. An invalid state is an error.
fn arrays<'py>(
    py: Python<'py>,
    question: &Question<'_>,
    rows: &[Result<Impact, Refusal>],
) -> PyResult<Bound<'py, PyDict>> {
    let reason = |(row, found): (usize, &Result<Impact, Refusal>)| match found {
        Err(Refusal::State(reason)) => Some(input(format_args!("state {row}: {reason}"))),
        _ => None,
    };
    if let Some(error) = rows.iter().enumerate().find_map(reason) {
        return Err(error);
    }
    let (k, joints) = (question.contacts.len(), question.widths.len());
    let n: usize = question.widths.iter().sum();
    let c = question.system.coordinates();
    let found = PyDict::new(py);
    let add = |name: &str, axes: &[usize], of: &dyn Fn(&Impact) -> Vec<f64>| -> PyResult<()> {
        let width: usize = axes.iter().product();
        let mut values = Vec::with_capacity(rows.len() * width);
        for row in rows {
            match row {
                Ok(impact) => values.extend(of(impact)),
                Err(_) => values.resize(values.len() + width, f64::NAN),
            }
        }
        let all: Vec<usize> = [rows.len()].iter().chain(axes).copied().collect();
        found.set_item(name, PyArray1::from_vec(py, values).call_method1("reshape", (all,))?)
    };
    add("closing_speeds", &[k], &|impact| impact.closing_speeds.clone())?;
    add("impulses", &[k, 3], &|impact| impact.impulses.clone())?;
    add("normal_impulses", &[k], &|impact| impact.normal_impulses.clone())?;
    add("velocities", &[n], &|impact| impact.velocities.clone())?;
    add("base_twist", &[6], &|impact| impact.twist.clone())?;
    add("energy_loss", &[], &|impact| vec![impact.energy_loss])?;
    if question.wants_map {
        add("impact_map", &[c, c], &|impact| impact.map.clone())?;
    }
    if question.wants_reactions {
        add("reactions", &[joints, 6], &|impact| impact.reactions.clone())?;
    }
    let sticks =
        rows.iter().flat_map(|row| row.as_ref().map_or(vec![false; k], |impact| impact.sticks.clone()));
    let sticks = PyArray1::from_vec(py, sticks.collect());
    found.set_item("sticks", sticks.reshape([rows.len(), k])?)?;
    let status = |row: &Result<Impact, Refusal>| {
        u8::from(if row.is_ok() { ContactStatus::Finite } else { ContactStatus::Unanswered })
    };
    found.set_item("status", PyArray1::from_vec(py, rows.iter().map(status).collect()))?;
    let reasons = rows.iter().enumerate().filter_map(|(row, found)| match found {
        Err(Refusal::NoAnswer(reason)) => Some((row, reason.clone())),
        _ => None,
    });
    found.set_item("reasons", reasons.collect::<Vec<(usize, String)>>())?;
    Ok(found)
}
