//! Design variants: a model with changes applied.

use crate::model::changes::Changes;
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::field::Field;
use crate::thresholds::{LARGEST_COORDINATE, MAX_MASS_RATIO};
use percuss_formats::LoadError;
use percuss_mechanism::{BuildError, Inertial, Link, LinkDescription, Mechanism, Problem, Severity, Subject};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Tolerance for the rounding of moments of inertia in files, relative: six digits are usual.
const MOMENT_ROUNDING: f64 = 1e-5;

/// Error of a design variant.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DesignError {
    /// Unreadable file.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Invalid change.
    #[error(transparent)]
    Change(#[from] StudyError),
}

impl Model {
    /// Model with `changes` applied after earlier changes.
    ///
    /// # Errors
    /// [`DesignError`]: unknown links or points, invalid masses, moved points of a model without a sheet,
    /// errors of the importer for the moved points.
    pub fn with_changes(&self, changes: &Changes) -> Result<Model, DesignError> {
        let all = self.origin.changes.and(changes);
        let (mut model, to_do) = match (&changes.moves[..], self.origin.sheet.as_deref()) {
            ([], _) => (self.clone(), changes),
            (_, Some(origin)) => {
                let model = Model::from_sheet(&origin.sheet, &all.moves, self.inputs.clone())?;
                let model = model.with_closures_of(self)?;
                (model, &all)
            }
            (_, None) => {
                let path = self.inputs.first().map_or_else(String::new, |input| input.path.clone());
                return Err(StudyError::input(Field::Move, no_sheet(&path)).into());
            }
        };
        if to_do.changes_inertia() {
            let changed = with_changed_inertia(&model.mechanism, to_do)?;
            model.diagnostics.extend(implausible_masses(&model.mechanism, &changed));
            let is_settled = |code| match code {
                "no-moving-mass" => changed.has_moving_mass(),
                "equal-inertias" => !to_do.link_mass.is_empty(),
                _ => false,
            };
            model.diagnostics.retain(|record| !is_settled(record.code));
            model.mechanism = Arc::new(changed);
        }
        model.origin.closures.clone_from(&self.origin.closures);
        model.origin.changes = all;
        Ok(model)
    }

    /// Model with the loops that a study added to `other`.
    pub(crate) fn with_closures_of(mut self, other: &Model) -> Result<Model, StudyError> {
        if !other.origin.closures.is_empty() {
            let closures = other.origin.closures.iter().cloned();
            let builder = closures.fold(self.mechanism.to_builder(), |b, closure| b.closure(closure));
            self.mechanism = Arc::new(builder.build().map_err(build_error_as_fault(Field::Model))?.mechanism);
            self.origin.closures.clone_from(&other.origin.closures);
        }
        Ok(self)
    }

    /// Names of the hardpoints of the sheet; empty for a URDF.
    pub fn hardpoints(&self) -> &[String] {
        self.origin.sheet.as_deref().map_or(&[], |origin| &origin.understood.points)
    }
}

/// Conversion of a build error to an invalid field, with the first finding about a link.
fn build_error_as_fault(field: Field) -> impl Fn(BuildError) -> StudyError {
    move |error| {
        let of_link = |(subject, _): &&(Subject, Problem)| matches!(subject, Subject::Link { .. });
        let message = error
            .findings
            .iter()
            .filter(|(_, problem)| problem.severity() == Severity::Error)
            .find(of_link)
            .map_or_else(|| error.to_string(), |(subject, problem)| format!("{subject}: {problem}"));
        StudyError::input(field, format!("the changed model is invalid: {message}"))
    }
}

/// Message: a model without hardpoints, from the file `path`.
pub(crate) fn no_sheet(path: &str) -> String {
    format!(
        "{path} is a URDF without hardpoints; give the suspension sheet (.toml, .csv, .xlsx) instead, or move \
         the joints' <origin> in the file"
    )
}

/// Warnings for links whose new mass is a large multiple of both their old mass and the mass of all other links.
fn implausible_masses(before: &Mechanism, after: &Mechanism) -> Vec<DiagnosticRecord> {
    let mass = |link: &Link| link.inertial().map_or(0.0, |inertial| inertial.mass);
    let total = after.total_mass();
    let pairs = before.links().iter().zip(after.links());
    let grown = pairs.filter_map(|(old, new)| {
        let (old, own) = (mass(old), mass(new));
        let others = total - own;
        let is_implausible = own > MAX_MASS_RATIO * others.max(f64::MIN_POSITIVE) && own > MAX_MASS_RATIO * old;
        (is_implausible && old > 0.0 && others > 0.0).then(|| DiagnosticRecord {
            severity: Severity::Warning,
            code: "implausible-mass",
            path: None,
            line: None,
            column: None,
            element: None,
            message: format!(
                "link \"{}\" is changed from {old} kg to {own} kg; all other links together have {:.3} kg. A number without a \
                 unit is in kg: for grams write {own}g",
                new.name(),
                others
            ),
        })
    });
    grown.collect()
}

/// Mechanism with changed masses, centres of mass and moments of inertia.
fn with_changed_inertia(mechanism: &Mechanism, changes: &Changes) -> Result<Mechanism, StudyError> {
    let mut inertials = BTreeMap::new();
    for (name, mass) in &changes.link_mass {
        let link = find(mechanism, Field::LinkMass, name)?;
        if !(mass.is_finite() && *mass >= 0.0) {
            let why = format!("link \"{name}\": {mass:e} kg; expected a finite mass of 0 or more");
            return Err(StudyError::input(Field::LinkMass, why));
        }
        inertials.insert(name.clone(), scaled_inertia(link, *mass));
    }
    for (name, com) in &changes.link_com {
        let link = find(mechanism, Field::LinkCom, name)?;
        let inertial = inertials.get(name).copied().or(link);
        let Some(inertial) = inertial.filter(|inertial| inertial.mass > 0.0) else {
            let why = format!(
                "link \"{name}\" has no mass, so that no centre of mass can be set; give it a mass first"
            );
            return Err(StudyError::input(Field::LinkCom, why));
        };
        if let Some(value) = com.iter().find(|x| !x.is_finite() || x.abs() > LARGEST_COORDINATE) {
            let why = format!(
                "link \"{name}\": the centre of mass has a component {value:e}; expected finite numbers of at most {LARGEST_COORDINATE:e}"
            );
            return Err(StudyError::input(Field::LinkCom, why));
        }
        inertials.insert(name.clone(), Inertial { com: (*com).into(), ..inertial });
    }
    for (name, moments) in &changes.link_inertia {
        let link = find(mechanism, Field::LinkInertia, name)?;
        let inertial = inertials.get(name).copied().or(link);
        let Some(mut inertial) = inertial.filter(|inertial| inertial.mass > 0.0) else {
            let why = format!(
                "link \"{name}\" has no mass, so that no moments of inertia can be set; give it a mass first"
            );
            return Err(StudyError::input(Field::LinkInertia, why));
        };
        if !are_moments_of_a_body(moments) {
            let why = format!(
                "link \"{name}\": moments of inertia {moments:?} kg·m² about the centre of mass; expected finite moments of 0 or more, \
                 none larger than the sum of the other two"
            );
            return Err(StudyError::input(Field::LinkInertia, why));
        }
        inertial.about_com.set_diagonal(&(*moments).into());
        inertials.insert(name.clone(), inertial);
    }
    let mut builder = mechanism.to_builder();
    builder = builder.map_links(|mut link: LinkDescription| {
        if let Some(inertial) = inertials.get(&link.name) {
            link.inertial = Some(*inertial);
        }
        link
    });
    let built = builder.build().map_err(build_error_as_fault(Field::LinkMass))?;
    Ok(built.mechanism)
}

/// True if a body can have these moments of inertia about three perpendicular axes: each is at most the sum of the other two. For a thin
/// plate one equals this sum, so a rounding error is permitted.
fn are_moments_of_a_body(moments: &[f64; 3]) -> bool {
    let sum: f64 = moments.iter().sum();
    moments.iter().all(|moment| *moment >= 0.0 && 2.0 * moment <= sum * (1.0 + MOMENT_ROUNDING))
        && sum.is_finite()
}

/// Inertia of a link by name; `None` for a massless link.
fn find(mechanism: &Mechanism, field: Field, name: &str) -> Result<Option<Inertial>, StudyError> {
    let link = mechanism.find_link(name).map_err(|error| StudyError::input(field, error))?;
    Ok(mechanism.link(link).inertial().copied())
}

/// Inertia with the same shape and another density; for a link without mass, a point mass at the origin of the
/// link frame.
fn scaled_inertia(inertial: Option<Inertial>, mass: f64) -> Inertial {
    match inertial.filter(|inertial| inertial.mass > 0.0) {
        Some(inertial) => {
            let factor = mass / inertial.mass;
            Inertial { mass, about_com: inertial.about_com * factor, ..inertial }
        }
        None => {
            let own = inertial.unwrap_or_else(|| Inertial::point(0.0, [0.0; 3]));
            Inertial { mass, ..own }
        }
    }
}
