//! Search for coordinates of hardpoints, masses of links, and factors on curves and dampers of stops at which quantities have required values.
//!
//! One unknown: Newton's method with a derivative by differences; once two values have opposite signs, a step outside of
//! their interval is replaced by its middle. Without two such values, the range is scanned. Several unknowns: damped
//! Gauss-Newton (Levenberg-Marquardt) in the box of the ranges. Every step is the same in each run.

use crate::model::changes::Changes;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::kinematics::KinematicsQuestion;
use crate::reports::kinematics::column_names::{target_column, unknown_column};
use crate::reports::kinematics::contact_values::{
    CONTACT_IMPACT, CONTACT_MASS, ContactFactors, contact_findings, contact_impact, impact_values, is_named,
    is_required, mass_value,
};
use crate::reports::kinematics::errors::KinematicsError;
use crate::reports::kinematics::load_cases::KinematicLoads;
use crate::reports::kinematics::report::evaluate_state;
use crate::reports::kinematics::suspension_kinematics::SuspensionKinematics;
use crate::reports::kinematics::target_question::{KinematicTarget, SearchUnknown, TargetSearch};
use crate::thresholds::{
    DIFFERENCE_OF_POINTS, FARTHEST_COORDINATE, LARGEST_FACTOR, MOST_EVALUATIONS, SCANNED_COORDINATES,
    SMALL_PART, SMALLEST_INFLUENCE, SMALLEST_SEARCH_STEP, TARGET_ACCURACY,
};
use nalgebra::{DMatrix, DVector};
use percuss_contact::Damper;
use percuss_mechanism::near_names;
use percuss_suspension::kinematics::{KinematicUnit, KinematicValue, KinematicValues};
use percuss_units::LengthUnit;
use schemars::JsonSchema;
use serde::Serialize;

/// Unknown before and after a search: coordinates in the unit and axes of the sheet, masses in kg.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FoundCoordinate {
    /// Name `POINT.AXIS`, `LINK.mass`, `CONTACT.curve` or `CONTACT.damping`.
    pub coordinate: String,
    /// Unit; × for a factor on the forces of a curve or on a stiffness.
    pub unit: &'static str,
    /// Value in the sheet.
    pub old: f64,
    /// Value found.
    pub new: f64,
}

/// Value reached for a target, SI units.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ReachedTarget {
    /// Column.
    pub quantity: String,
    /// Required value.
    pub required: f64,
    /// Value before the search.
    pub old: f64,
    /// Value at the new coordinates.
    pub reached: f64,
    /// Unit of the quantity.
    #[serde(skip)]
    pub unit: KinematicUnit,
}

/// Result of a search.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TargetReport {
    /// `percuss.target/1`.
    #[schemars(extend("const" = "percuss.target/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Source files.
    pub inputs: Vec<Input>,
    /// True if all values are reached.
    pub is_reached: bool,
    /// Largest change of a coordinate, m.
    pub within: f64,
    /// Loads of the motions per load; null without compliance.
    pub loads: Option<KinematicLoads>,
    /// Coordinates.
    pub coordinates: Vec<FoundCoordinate>,
    /// Quantities.
    pub targets: Vec<ReachedTarget>,
    /// Number of evaluated designs.
    pub evaluations: usize,
    /// Displacements of the hardpoints, m, in the axes of the sheet, as for `--move`.
    pub moves: Vec<(String, [f64; 3])>,
    /// Masses of links, kg, as for `--link-mass`.
    pub link_masses: Vec<(String, f64)>,
    /// Findings about the file, and about the contacts of the values in the design found.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// Unit of lengths in tables.
    #[serde(skip)]
    pub length_unit: LengthUnit,
}

/// Designs with changed coordinates.
struct Designs<'s> {
    model: &'s Model,
    question: &'s KinematicsQuestion,
    search: &'s TargetSearch,
    /// Required values, and the scale of each quantity.
    required: Vec<(f64, f64)>,
    evaluations: usize,
}

/// Point of a search: displacements (m), values, and scaled differences from the required values.
#[derive(Clone, Debug)]
struct Trial {
    x: DVector<f64>,
    values: Vec<f64>,
    differences: DVector<f64>,
}

impl Trial {
    fn error(&self) -> f64 {
        self.differences.amax()
    }
}

/// Size of a difference that matters, by unit.
fn scale(unit: KinematicUnit) -> f64 {
    match unit {
        KinematicUnit::Length | KinematicUnit::Angle => 1e-3,
        KinematicUnit::AnglePerLength | KinematicUnit::Ratio | KinematicUnit::Percent => 1e-2,
        KinematicUnit::Frequency | KinematicUnit::PerLength => 1e-1,
        KinematicUnit::Mass => 1.0,
        KinematicUnit::Stiffness => 1e3,
        KinematicUnit::Force | KinematicUnit::Moment => 1e2,
        KinematicUnit::AnglePerForce | KinematicUnit::LengthPerForce => 1e-7,
        KinematicUnit::AnglePerMoment | KinematicUnit::LengthPerMoment => 1e-6,
    }
}

/// Mass of a link, kg; `None` for an unknown link and a link without mass.
fn mass_of(model: &Model, link: &str) -> Option<f64> {
    let link = model.mechanism.find_link(link).ok()?;
    Some(model.mechanism.link(link).inertial()?.mass).filter(|mass| *mass > 0.0)
}

impl Designs<'_> {
    /// Factors on the curve and the damping of a contact.
    fn factors(&self, x: &DVector<f64>, contact: &str) -> ContactFactors {
        let mut factors = ContactFactors { curve: 1.0, damping: 1.0 };
        for (unknown, by) in self.search.unknowns.iter().zip(x.iter()) {
            let factor = LARGEST_FACTOR.powf(by / self.search.within);
            match unknown {
                SearchUnknown::Curve(name) if is_named(contact, name) => factors.curve *= factor,
                SearchUnknown::Damping(name) if is_named(contact, name) => factors.damping *= factor,
                _ => {}
            }
        }
        factors
    }

    /// Changes of the design. A mass unknown changes the mass by half at the largest displacement.
    fn changes(&self, x: &DVector<f64>) -> Changes {
        let mut changes = Changes::default();
        for (unknown, by) in self.search.unknowns.iter().zip(x.iter()) {
            match unknown {
                SearchUnknown::Mass(link) => {
                    let mass = mass_of(self.model, link).unwrap_or_default();
                    changes.link_mass.push((link.clone(), mass * (1.0 + 0.5 * by / self.search.within)));
                }
                SearchUnknown::Curve(_) | SearchUnknown::Damping(_) => {}
                SearchUnknown::Coordinate(point, axis) => {
                    match changes.moves.iter_mut().find(|(known, _)| known == point) {
                        Some((_, shift)) => shift[*axis] += by,
                        None => {
                            let mut shift = [0.0; 3];
                            shift[*axis] = *by;
                            changes.moves.push((point.clone(), shift));
                        }
                    }
                }
            }
        }
        changes
    }

    /// All quantities of a design, with the effective masses that are required; the inner error is a pose that is not reached.
    fn quantities(&mut self, x: &DVector<f64>) -> Result<Result<KinematicValues, String>, KinematicsError> {
        self.evaluations += 1;
        let model =
            if x.amax() == 0.0 { self.model.clone() } else { self.model.with_changes(&self.changes(x))? };
        let prepared = SuspensionKinematics::new(&model, self.question.steers())?;
        let mut values = evaluate_state(&prepared, self.question, &self.question.state)?;
        if let Ok(values) = &mut values {
            for contact in model.mechanism.contacts() {
                let is_required = |start: &str| is_required(self.search, start, contact.name());
                if CONTACT_IMPACT.into_iter().any(is_required) {
                    let factors = self.factors(x, contact.name());
                    values.0.extend(impact_values(
                        &model,
                        contact.name(),
                        self.search.impact.as_ref(),
                        factors,
                    ));
                }
                if is_required(CONTACT_MASS) {
                    let name = format!("{CONTACT_MASS}{}", contact.name());
                    // A stop at its touch.
                    let question = MassQuestion::default().at_contact(contact.name());
                    values.0.push(mass_value(&model, name, &question));
                }
            }
            if let Some(question) = &self.search.mass {
                values.0.push(mass_value(&model, "effective_mass".to_owned(), question));
            }
        }
        Ok(values)
    }

    /// Trial at displacements; `None` for a design without the quantities.
    fn trial(&mut self, x: &DVector<f64>) -> Option<Trial> {
        let values = self.quantities(x).ok()?.ok()?;
        let values: Option<Vec<f64>> =
            self.search.targets.iter().map(|target| find(&values, &target.quantity).ok()).collect();
        let values = values?;
        let differences =
            values.iter().zip(&self.required).map(|(value, (goal, scale))| (value - goal) / scale);
        let differences = DVector::from_iterator(values.len(), differences);
        Some(Trial { x: x.clone(), values, differences })
    }

    fn is_exhausted(&self) -> bool {
        self.evaluations >= MOST_EVALUATIONS
    }

    /// One unknown; returns the best trial.
    fn solve_one(&mut self, start: Trial) -> Trial {
        let within = self.search.within;
        let mut tried = vec![start.clone()];
        let one = |x: f64| DVector::from_element(1, x);
        let mut here = start;
        let mut has_scanned = false;
        while here.error() > TARGET_ACCURACY && !self.is_exhausted() {
            let bracket = bracket(&tried, here.x[0]);
            let step = self.newton_step(&here);
            let limits = bracket.unwrap_or([-within, within]);
            let inside =
                |x: f64| x > limits[0] && x < limits[1] && tried.iter().all(|t| (t.x[0] - x).abs() > 0.0);
            let next = step.map(|step| here.x[0] + step).filter(|x| inside(*x));
            let next = match (next, bracket) {
                (Some(next), _) => Some(next),
                (None, Some([low, high])) if high - low > SMALLEST_SEARCH_STEP => Some(0.5 * (low + high)),
                (None, _) => None,
            };
            let trial = next.and_then(|next| self.trial(&one(next)));
            match trial {
                // Newton's method without an interval continues only if the error decreases.
                Some(trial) if bracket.is_some() || trial.error() < 0.9 * here.error() => {
                    tried.push(trial.clone());
                    here = trial;
                }
                other => {
                    tried.extend(other);
                    if has_scanned {
                        break;
                    }
                    has_scanned = true;
                    for k in 0..=SCANNED_COORDINATES {
                        let x = within * (2.0 * k as f64 / SCANNED_COORDINATES as f64 - 1.0);
                        tried.extend(self.trial(&one(x)));
                    }
                    here = nearest_crossing(&tried).unwrap_or_else(|| best(&tried));
                }
            }
        }
        let mut best = best(&tried);
        if best.error() > TARGET_ACCURACY {
            best = self.refine_minimum(best, &tried);
        }
        best
    }

    /// Newton step by a central difference; `None` for a vanishing derivative.
    fn newton_step(&mut self, here: &Trial) -> Option<f64> {
        let h = DIFFERENCE_OF_POINTS;
        let shifted = |by: f64| DVector::from_element(1, here.x[0] + by);
        let (ahead, behind) = (self.trial(&shifted(h))?, self.trial(&shifted(-h))?);
        let slope = (ahead.differences[0] - behind.differences[0]) / (2.0 * h);
        let step = -here.differences[0] / slope;
        step.is_finite().then_some(step)
    }

    /// Nearest value: golden-section search of the smallest error next to the best of the trials.
    fn refine_minimum(&mut self, best: Trial, tried: &[Trial]) -> Trial {
        let within = self.search.within;
        let mut sorted: Vec<f64> = tried.iter().map(|t| t.x[0]).chain([-within, within]).collect();
        sorted.sort_by(f64::total_cmp);
        let mut low = sorted.iter().copied().rfind(|x| *x < best.x[0]).unwrap_or(-within);
        let mut high = sorted.iter().copied().find(|x| *x > best.x[0]).unwrap_or(within);
        let golden = 0.5 * (5.0f64.sqrt() - 1.0);
        let mut best = best;
        while high - low > DIFFERENCE_OF_POINTS && !self.is_exhausted() {
            let (a, b) = (high - golden * (high - low), low + golden * (high - low));
            let [at_a, at_b] = [a, b].map(|x| self.trial(&DVector::from_element(1, x)));
            let error = |trial: &Option<Trial>| trial.as_ref().map_or(f64::INFINITY, Trial::error);
            if error(&at_a) <= error(&at_b) {
                high = b
            } else {
                low = a
            }
            for trial in [at_a, at_b].into_iter().flatten() {
                if trial.error() < best.error() {
                    best = trial;
                }
            }
        }
        best
    }

    /// Several unknowns; returns the best trial.
    fn solve_several(&mut self, start: Trial) -> Trial {
        let (within, count) = (self.search.within, start.x.len());
        let mut here = start;
        let mut damping = 0.0f64;
        while here.error() > TARGET_ACCURACY && !self.is_exhausted() {
            let Some(jacobian) = self.jacobian(&here) else { break };
            let gradient = jacobian.transpose() * &here.differences;
            // A coordinate at its limit moves only inward.
            let is_held = |k: usize| here.x[k].abs() >= within && gradient[k] * here.x[k] < 0.0;
            let held: Vec<bool> = (0..count).map(is_held).collect();
            let mut accepted = None;
            for _ in 0..20 {
                let mut normal = jacobian.transpose() * &jacobian;
                let mut target = -gradient.clone();
                let diagonal = normal.diagonal().amax();
                for k in 0..count {
                    normal[(k, k)] += damping * normal[(k, k)].max(1e-12 * diagonal);
                    if held[k] {
                        normal.row_mut(k).fill(0.0);
                        normal.column_mut(k).fill(0.0);
                        (normal[(k, k)], target[k]) = (1.0, 0.0);
                    }
                }
                let Some(step) = normal.lu().solve(&target) else {
                    damping = (10.0 * damping).max(1e-6);
                    continue;
                };
                let x = (&here.x + step).map(|x| x.clamp(-within, within));
                if (&x - &here.x).amax() <= SMALLEST_SEARCH_STEP || self.is_exhausted() {
                    break;
                }
                let trial = self.trial(&x).filter(|t| t.differences.norm() < here.differences.norm());
                if trial.is_some() {
                    accepted = trial;
                    damping = if damping < 1e-9 { 0.0 } else { 0.1 * damping };
                    break;
                }
                damping = (10.0 * damping).max(1e-4);
            }
            match accepted {
                Some(trial) => here = trial,
                None => break,
            }
        }
        here
    }

    /// Derivatives of the scaled quantities by the coordinates (1/m), by central differences.
    fn jacobian(&mut self, here: &Trial) -> Option<DMatrix<f64>> {
        let count = here.x.len();
        let mut jacobian = DMatrix::zeros(here.differences.len(), count);
        for k in 0..count {
            let mut shifted = |by: f64| {
                let mut x = here.x.clone();
                x[k] += by;
                self.trial(&x)
            };
            let (ahead, behind) = (shifted(DIFFERENCE_OF_POINTS)?, shifted(-DIFFERENCE_OF_POINTS)?);
            let column = (ahead.differences - behind.differences) / (2.0 * DIFFERENCE_OF_POINTS);
            jacobian.set_column(k, &column);
        }
        Some(jacobian)
    }
}

/// Trial with the smallest error; of equal ones, the nearest to the start.
fn best(tried: &[Trial]) -> Trial {
    let order =
        |a: &&Trial, b: &&Trial| a.error().total_cmp(&b.error()).then(a.x.amax().total_cmp(&b.x.amax()));
    tried.iter().min_by(order).cloned().expect("the start is a trial")
}

/// Neighbours among the trials, around `x`, with differences of opposite signs.
fn bracket(tried: &[Trial], x: f64) -> Option<[f64; 2]> {
    let mut sorted: Vec<(f64, f64)> = tried.iter().map(|t| (t.x[0], t.differences[0])).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let changes = sorted.windows(2).filter(|pair| pair[0].1 * pair[1].1 <= 0.0);
    let distance = |pair: &&[(f64, f64)]| (pair[0].0 - x).abs().min((pair[1].0 - x).abs());
    let nearest = changes.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    Some([nearest[0].0, nearest[1].0])
}

/// End of the interval with opposite signs that is nearest to the start.
fn nearest_crossing(tried: &[Trial]) -> Option<Trial> {
    let ends = bracket(tried, 0.0)?;
    tried.iter().filter(|t| ends.contains(&t.x[0])).min_by(|a, b| a.error().total_cmp(&b.error())).cloned()
}

/// Value of a quantity: by its full name, or without the side (the first side).
fn find(values: &KinematicValues, name: &str) -> Result<f64, String> {
    let full = |value: &&KinematicValue| format!("{}{}", value.name, value.side) == name;
    let found = values.0.iter().find(full).or_else(|| values.0.iter().find(|value| value.name == name));
    match found {
        Some(value) => value.value.clone(),
        None => {
            let names: Vec<String> =
                values.0.iter().map(|value| format!("{}{}", value.name, value.side)).collect();
            Err(unknown_column(name, &names))
        }
    }
}

/// Searches coordinates of hardpoints, masses of links and factors on curves and dampers of stops at which quantities have required values.
///
/// # Errors
/// [`KinematicsError`]: unknown hardpoints or quantities, a value in another unit, another number of unknowns and
/// values, a design without a pose. A value that is not reached is no error: [`TargetReport::is_reached`].
pub fn search_targets(
    model: &Model,
    question: &KinematicsQuestion,
    search: &TargetSearch,
) -> Result<TargetReport, KinematicsError> {
    let refuse = |why: String| KinematicsError::Search { why };
    let (unknowns, targets) = (search.unknowns.len(), search.targets.len());
    if unknowns != targets || unknowns == 0 {
        return Err(refuse(format!(
            "{unknowns} unknown coordinates (--solve) and {targets} values (--for); the same number of both is required"
        )));
    }
    if search.within > FARTHEST_COORDINATE {
        return Err(refuse(format!(
            "--within {0} is {0} m, larger than a suspension; write the unit, such as {0}mm",
            search.within
        )));
    }
    let mut search = search.clone();
    let start = DVector::zeros(unknowns);
    let mut first = Designs { model, question, search: &search, required: Vec::new(), evaluations: 0 };
    let values = first.quantities(&start)?.map_err(refuse)?;
    let evaluations = first.evaluations;
    let names: Vec<String> = values.0.iter().map(|value| format!("{}{}", value.name, value.side)).collect();
    search.targets.iter_mut().for_each(|target| target.quantity = target_column(&target.quantity, &names));
    let unknown =
        search.unknowns.iter().enumerate().find(|(i, unknown)| search.unknowns[..*i].contains(unknown));
    if let Some((_, twice)) = unknown {
        return Err(refuse(format!("--solve {} is given twice", twice.name())));
    }
    let names = search.targets.iter().map(|target| &target.quantity);
    if let Some(twice) =
        names.clone().enumerate().find(|(i, name)| names.clone().take(*i).any(|other| other == *name))
    {
        return Err(refuse(format!(
            "--for {} is given twice; each value needs a quantity of its own",
            twice.1
        )));
    }
    let search = &search;
    let mut designs = Designs { model, question, search, required: Vec::new(), evaluations };
    for target in &search.targets {
        find(&values, &target.quantity)
            .map_err(|why| KinematicsError::Search { why: format!("--for: {why}") })?;
        let unit = unit_of(&values, &target.quantity);
        let goal = target.goal(unit, model.length_unit()).map_err(refuse)?;
        designs.required.push((goal, scale(unit)));
    }
    let coordinates = model.origin.sheet.as_deref().map(|origin| &origin.understood.coordinates[..]);
    let coordinates = coordinates.unwrap_or_default();
    let unknown_name = |what: &str, name: &str, names: Vec<&str>| {
        let near = near_names(name, names.iter().copied()).into_iter().next();
        let near = near.map_or_else(
            || format!("; these are: {}", names.join(", ")),
            |near| format!(" (did you mean \"{near}\"?)"),
        );
        refuse(format!("no {what} \"{name}\" in the sheet (--solve){near}"))
    };
    let contact_of = |name: &str| {
        let contacts = || model.mechanism.contacts().iter().map(|contact| contact.name());
        let found = contacts().find(|contact| is_named(contact, name));
        found.ok_or_else(|| unknown_name("contact", name, contacts().collect()))
    };
    let one = ContactFactors { curve: 1.0, damping: 1.0 };
    let unit = model.origin.sheet.as_deref().map_or(LengthUnit::default(), |origin| origin.understood.unit);
    let old = |unknown: &SearchUnknown| match unknown {
        SearchUnknown::Coordinate(name, axis) => {
            let found =
                coordinates.iter().find(|(point, _)| point == name).map(|(_, at)| (at[*axis], unit.name()));
            let names = || coordinates.iter().map(|(point, _)| point.as_str()).collect();
            found.ok_or_else(|| unknown_name("hardpoint", name, names()))
        }
        SearchUnknown::Mass(name) => {
            let links = model.mechanism.links().iter().map(|link| link.name());
            let names = || links.filter(|link| mass_of(model, link).is_some()).collect();
            let mass = mass_of(model, name).map(|mass| (mass, "kg"));
            mass.ok_or_else(|| unknown_name("link with mass", name, names()))
        }
        SearchUnknown::Curve(name) => contact_of(name).map(|_| (1.0, "×")),
        SearchUnknown::Damping(name) => {
            let contact = contact_of(name)?;
            let impact = search
                .impact
                .as_ref()
                .ok_or_else(|| refuse(format!("--solve {name}.damping: missing: --speed")))?;
            let found =
                contact_impact(model, contact, impact, one).map_err(|error| refuse(error.to_string()))?;
            Ok(match found.damper {
                Damper::KelvinVoigt { coefficient, .. } => (coefficient, "N·s/m"),
                Damper::HuntCrossley { dissipation } => (dissipation, "s/m"),
                Damper::LossFactor { loss_factor } => (loss_factor, ""),
            })
        }
    };
    let old: Vec<(f64, &str)> = search.unknowns.iter().map(old).collect::<Result<_, _>>()?;
    let first = designs.trial(&start).ok_or_else(|| KinematicsError::Search {
        why: "a required quantity has no value at the pose".to_owned(),
    })?;
    for (k, unknown) in search.unknowns.iter().enumerate() {
        let mut x = start.clone();
        x[k] = SMALL_PART * search.within;
        let moved = designs.trial(&x);
        let is_idle =
            moved.is_some_and(|moved| (moved.differences - &first.differences).amax() < SMALLEST_INFLUENCE);
        if is_idle {
            return Err(refuse(format!(
                "{} has no influence on the required values (--solve)",
                unknown.name()
            )));
        }
    }
    let found =
        if unknowns == 1 { designs.solve_one(first.clone()) } else { designs.solve_several(first.clone()) };
    let changes = designs.changes(&found.x);
    let of_contacts = contact_findings(&model.with_changes(&changes)?, search);
    let coordinate = |(k, unknown): (usize, &SearchUnknown)| {
        let (old, name) = old[k];
        let (old, new) = match unknown {
            SearchUnknown::Coordinate(..) => (unit.of_metres(old), unit.of_metres(old + found.x[k])),
            SearchUnknown::Mass(link) => {
                let new = changes.link_mass.iter().find(|(changed, _)| changed == link);
                (old, new.map_or(old, |(_, mass)| *mass))
            }
            SearchUnknown::Curve(_) | SearchUnknown::Damping(_) => {
                (old, old * LARGEST_FACTOR.powf(found.x[k] / search.within))
            }
        };
        FoundCoordinate { coordinate: unknown.name(), unit: name, old, new }
    };
    let reached = |(k, target): (usize, &KinematicTarget)| ReachedTarget {
        quantity: target.quantity.clone(),
        required: designs.required[k].0,
        old: first.values[k],
        reached: found.values[k],
        unit: unit_of(&values, &target.quantity),
    };
    Ok(TargetReport {
        schema: "percuss.target/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        is_reached: found.error() <= TARGET_ACCURACY,
        within: search.within,
        loads: question.vehicle.vehicle().loads.map(KinematicLoads::of),
        coordinates: search.unknowns.iter().enumerate().map(coordinate).collect(),
        targets: search.targets.iter().enumerate().map(reached).collect(),
        evaluations: designs.evaluations,
        diagnostics: model.diagnostics.iter().cloned().chain(of_contacts).collect(),
        moves: changes.moves,
        link_masses: changes.link_mass,
        length_unit: model.length_unit(),
    })
}

/// Unit of a quantity.
fn unit_of(values: &KinematicValues, name: &str) -> KinematicUnit {
    let found =
        values.0.iter().find(|value| format!("{}{}", value.name, value.side) == name || value.name == name);
    found.map_or(KinematicUnit::Ratio, |value| value.unit)
}
