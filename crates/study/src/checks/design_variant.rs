//! Design variants: a model with changes applied.

use crate::model::changes::Changes;
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::thresholds::{LARGEST_COORDINATE, MAX_MASS_RATIO};
use percuss_formats::{LoadError, inertia_of_shapes};
use percuss_mechanism::{
    BuildError, BushDescription, Inertial, Link, LinkDescription, Mechanism, Problem, Severity, Subject,
};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Tolerance for the rounding of moments of inertia in files, relative: six digits are usual.
const MOMENT_ROUNDING: f64 = 1e-5;

/// Bytes of meshes that are read for masses.
const MESHES_OF_MASSES: u64 = 256 << 20;

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
                return Err(StudyError::input("model.move", no_sheet(&path)).into());
            }
        };
        if to_do.changes_inertia() {
            let (of_shapes, told) = with_masses_of_shapes(&model, to_do)?;
            let changed = with_changed_inertia(&of_shapes, to_do)?;
            let changed = with_total_mass(changed, to_do)?;
            model.diagnostics.extend(told);
            model.diagnostics.extend(implausible_masses(&model.mechanism, &changed));
            let is_settled = |code| match code {
                "no-moving-mass" => changed.has_moving_mass(),
                "equal-inertias" => !to_do.link_mass.is_empty() || to_do.shape_density.is_some(),
                _ => false,
            };
            model.diagnostics.retain(|record| !is_settled(record.code));
            model.mechanism = Arc::new(changed);
        }
        model.origin.closures.clone_from(&self.origin.closures);
        model.origin.changes = all;
        Ok(model)
    }

    /// Model with further bushes, which also act after later changes.
    ///
    /// # Errors
    /// [`StudyError`]: names that do not exist, invalid numbers, joints that a bush cannot replace.
    pub fn with_bushes(mut self, bushes: &[BushDescription]) -> Result<Model, StudyError> {
        let builder = bushes.iter().cloned().fold(self.mechanism.to_builder(), |b, bush| b.bush(bush));
        self.mechanism = Arc::new(builder.build().map_err(build_error_as_fault("model.path"))?.mechanism);
        self.origin.bushes.extend_from_slice(bushes);
        Ok(self)
    }

    /// Model with the loops that a study added to `other`, and with its further bushes.
    pub(crate) fn with_closures_of(mut self, other: &Model) -> Result<Model, StudyError> {
        if !other.origin.closures.is_empty() {
            let closures = other.origin.closures.iter().cloned();
            let builder = closures.fold(self.mechanism.to_builder(), |b, closure| b.closure(closure));
            self.mechanism = Arc::new(builder.build().map_err(build_error_as_fault("model.path"))?.mechanism);
            self.origin.closures.clone_from(&other.origin.closures);
        }
        if !other.origin.bushes.is_empty() {
            self = self.with_bushes(&other.origin.bushes)?;
        }
        Ok(self)
    }

    /// Names of the hardpoints of the sheet; empty for a URDF.
    pub fn hardpoints(&self) -> &[String] {
        self.origin.sheet.as_deref().map_or(&[], |origin| &origin.understood.points)
    }
}

/// Conversion of a build error to an invalid field, with the first finding about a link.
fn build_error_as_fault(field: &'static str) -> impl Fn(BuildError) -> StudyError {
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

/// Mechanism whose masses and inertias are those of the shapes of its links, with a warning; links without shapes keep theirs.
fn with_masses_of_shapes(
    model: &Model,
    changes: &Changes,
) -> Result<(Arc<Mechanism>, Option<DiagnosticRecord>), StudyError> {
    let mechanism = &model.mechanism;
    let Some(density) = changes.shape_density else { return Ok((Arc::clone(mechanism), None)) };
    if !(density.is_finite() && density > 0.0) {
        let why = format!(
            "the density is {density} kg/m³; a finite number above 0 is expected, such as shapes:2700"
        );
        return Err(StudyError::input("model.masses", why));
    }
    let (folders, mut max_size) = (model.mesh_folders(Vec::new()), MESHES_OF_MASSES);
    let (mut inertials, mut without) = (BTreeMap::new(), Vec::new());
    for (link, shapes) in mechanism.links().iter().zip(model.shapes.iter()) {
        let found = inertia_of_shapes(shapes, density, &folders, &mut max_size).map_err(|error| {
            StudyError::input("model.masses", format!("link \"{}\": {error}", link.name()))
        })?;
        match found {
            Some(inertial) => drop(inertials.insert(link.name().to_owned(), inertial)),
            None => without.push(link.name()),
        }
    }
    if inertials.is_empty() {
        let why = "no link of the model has a shape with a volume; give the masses by --link-mass";
        return Err(StudyError::input("model.masses", why.to_owned()));
    }
    let kept = match &without[..] {
        [] => String::new(),
        names => format!(
            "; links without a shape keep theirs: {}",
            names.iter().take(12).copied().collect::<Vec<_>>().join(", ")
        ),
    };
    let message = format!(
        "estimates, not data: the masses and inertias of {} links are those of their shapes at {density} kg/m³ (collision shapes, or visual \
         ones; of a mesh its convex hull){kept}",
        inertials.len()
    );
    let record = DiagnosticRecord {
        severity: Severity::Warning,
        code: "estimated-masses",
        path: None,
        line: None,
        column: None,
        element: None,
        message,
    };
    Ok((Arc::new(with_inertials(mechanism, &inertials, "model.masses")?), Some(record)))
}

/// Mechanism with all masses and inertias scaled to a total mass.
fn with_total_mass(mechanism: Mechanism, changes: &Changes) -> Result<Mechanism, StudyError> {
    let Some(total) = changes.total_mass else { return Ok(mechanism) };
    let own = mechanism.total_mass();
    if !(total.is_finite() && total > 0.0) || own <= 0.0 {
        let why = if own > 0.0 {
            format!("{total} kg; a finite mass above 0 is expected")
        } else {
            "no link has a mass that can be scaled; compute masses first by --masses shapes".to_owned()
        };
        return Err(StudyError::input("model.total_mass", why));
    }
    let scaled = mechanism.links().iter().filter_map(|link| {
        let inertial = *link.inertial()?;
        let factor = total / own;
        let (mass, about_com) = (inertial.mass * factor, inertial.about_com * factor);
        Some((link.name().to_owned(), Inertial { mass, about_com, ..inertial }))
    });
    with_inertials(&mechanism, &scaled.collect(), "model.total_mass")
}

/// Mechanism with other inertias, by link.
fn with_inertials(
    mechanism: &Mechanism,
    inertials: &BTreeMap<String, Inertial>,
    field: &'static str,
) -> Result<Mechanism, StudyError> {
    let builder = mechanism.to_builder().map_links(|mut link: LinkDescription| {
        if let Some(inertial) = inertials.get(&link.name) {
            link.inertial = Some(*inertial);
        }
        link
    });
    Ok(builder.build().map_err(build_error_as_fault(field))?.mechanism)
}

/// Mechanism with changed masses, centres of mass and moments of inertia.
fn with_changed_inertia(mechanism: &Mechanism, changes: &Changes) -> Result<Mechanism, StudyError> {
    let mut inertials = BTreeMap::new();
    for (name, mass) in &changes.link_mass {
        let link = find(mechanism, "model.link_mass", name)?;
        if !(mass.is_finite() && *mass >= 0.0) {
            let why = format!("link \"{name}\": {mass:e} kg; expected a finite mass of 0 or more");
            return Err(StudyError::input("model.link_mass", why));
        }
        inertials.insert(name.clone(), scaled_inertia(link, *mass));
    }
    for (name, com) in &changes.link_com {
        let link = find(mechanism, "model.link_com", name)?;
        let inertial = inertials.get(name).copied().or(link);
        let Some(inertial) = inertial.filter(|inertial| inertial.mass > 0.0) else {
            let why = format!(
                "link \"{name}\" has no mass, so that no centre of mass can be set; give it a mass first"
            );
            return Err(StudyError::input("model.link_com", why));
        };
        if let Some(value) = com.iter().find(|x| !x.is_finite() || x.abs() > LARGEST_COORDINATE) {
            let why = format!(
                "link \"{name}\": the centre of mass has a component {value:e}; expected finite numbers of at most {LARGEST_COORDINATE:e}"
            );
            return Err(StudyError::input("model.link_com", why));
        }
        inertials.insert(name.clone(), Inertial { com: (*com).into(), ..inertial });
    }
    for (name, moments) in &changes.link_inertia {
        let link = find(mechanism, "model.link_inertia", name)?;
        let inertial = inertials.get(name).copied().or(link);
        let Some(mut inertial) = inertial.filter(|inertial| inertial.mass > 0.0) else {
            let why = format!(
                "link \"{name}\" has no mass, so that no moments of inertia can be set; give it a mass first"
            );
            return Err(StudyError::input("model.link_inertia", why));
        };
        if !are_moments_of_a_body(moments) {
            let why = format!(
                "link \"{name}\": moments of inertia {moments:?} kg·m² about the centre of mass; expected finite moments of 0 or more, \
                 none larger than the sum of the other two"
            );
            return Err(StudyError::input("model.link_inertia", why));
        }
        inertial.about_com.set_diagonal(&(*moments).into());
        inertials.insert(name.clone(), inertial);
    }
    with_inertials(mechanism, &inertials, "model.link_mass")
}

/// True if a body can have these moments of inertia about three perpendicular axes: each is at most the sum of the other two. For a thin
/// plate one equals this sum, so a rounding error is permitted.
fn are_moments_of_a_body(moments: &[f64; 3]) -> bool {
    let sum: f64 = moments.iter().sum();
    moments.iter().all(|moment| *moment >= 0.0 && 2.0 * moment <= sum * (1.0 + MOMENT_ROUNDING))
        && sum.is_finite()
}

/// Inertia of a link by name; `None` for a massless link.
fn find(mechanism: &Mechanism, field: &'static str, name: &str) -> Result<Option<Inertial>, StudyError> {
    let link = mechanism.find_link(name).map_err(StudyError::about(field))?;
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
