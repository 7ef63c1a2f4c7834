//! Model with balanced moments of inertia, and its change of the effective mass.

use super::change_record::ChangeRecord;
use crate::model::loading::Model;
use crate::thresholds::MASSLESS_PART;
use nalgebra::{DMatrix, DVector};
use percuss_dynamics::{Conditions, Contact, Pose, System};
use percuss_formats::{Effect, balance_inertia};
use percuss_mechanism::Mechanism;
use std::sync::Arc;

/// Model with possible moments of inertia.
pub(super) struct BalancedModel {
    pub model: Model,
    /// Changed links, and the change of the effective mass.
    pub changes: Vec<ChangeRecord>,
    /// Least and largest relative change of m̄; `None` without changed links, without a pose as drawn, or without a bound.
    pub mass_change: Option<[f64; 2]>,
}

/// Replaces moments A + B < C by the nearest possible ones.
///
/// With the mass matrices M before and M′ after, m̄ of each contact changes by a part between the extremes of
///
/// ```text
/// vᵀ(M′ − M)v / vᵀMv,   A v = 0
/// ```
pub(super) fn balanced(model: &Model) -> BalancedModel {
    let Some((mechanism, changed)) = balance_inertia(&model.mechanism) else {
        return BalancedModel { model: model.clone(), changes: Vec::new(), mass_change: None };
    };
    let balanced = Model { mechanism: Arc::new(mechanism), ..model.clone() };
    let drawn = |mechanism: &Arc<Mechanism>| {
        let system = System::new(Arc::clone(mechanism), &Conditions::new()).ok()?;
        system.pose(&system.configuration()).ok()
    };
    let poses = drawn(&model.mechanism).zip(drawn(&balanced.mechanism));
    let mass_change = poses.as_ref().and_then(|(before, after)| range_of_change(before, after));
    let percent = |part: f64| format!("{:+.3} %", 100.0 * part).replace('-', "−");
    let mut what = match mass_change {
        Some([least, most]) => format!("between {} and {} at the drawn pose", percent(least), percent(most)),
        None => "without a bound: a motion gets its mass from the balanced moments".to_owned(),
    };
    let root = model.mechanism.root();
    for contact in model.mechanism.contacts().iter().take(MOST_CONTACTS) {
        let mass =
            |pose: &Pose| pose.respond(&Contact::named(contact, root)).ok()?.effective_mass.kilograms();
        let change = poses.as_ref().and_then(|(before, after)| Some(mass(after)? / mass(before)? - 1.0));
        what +=
            &change.map_or_else(String::new, |change| format!("; {} {}", contact.name(), percent(change)));
    }
    let of_mass = ChangeRecord {
        effect: Effect::Changed.name(),
        element: "effective mass of any contact".to_owned(),
        path: None,
        line: None,
        what,
        reason: "the balanced moments".to_owned(),
    };
    let changes = changed.into_iter().map(ChangeRecord::from).chain([of_mass]).collect();
    BalancedModel { model: balanced, changes, mass_change }
}

/// Named contacts whose change is stated.
const MOST_CONTACTS: usize = 8;

/// Extremes of vᵀ(M′ − M)v / vᵀMv over the admissible motions; `None` without a bound.
fn range_of_change(before: &Pose, after: &Pose) -> Option<[f64; 2]> {
    let mass = before.mass_matrix();
    let change = after.mass_matrix() - &mass;
    let rows = before.constraint_matrix();
    let of_rows = rows.tr_mul(&rows).symmetric_eigen();
    let largest = of_rows.eigenvalues.amax();
    let admissible: Vec<usize> =
        (0..mass.nrows()).filter(|&i| of_rows.eigenvalues[i] <= MASSLESS_PART * largest).collect();
    let basis = of_rows.eigenvectors.select_columns(&admissible);
    let reduced = |matrix: &DMatrix<f64>| basis.tr_mul(matrix) * &basis;
    let (of_mass, change) = (reduced(&mass).symmetric_eigen(), reduced(&change));
    let largest = of_mass.eigenvalues.amax();
    let (moving, massless): (Vec<usize>, Vec<usize>) =
        (0..change.nrows()).partition(|&i| of_mass.eigenvalues[i] > MASSLESS_PART * largest);
    let massless = of_mass.eigenvectors.select_columns(&massless);
    if (massless.tr_mul(&change) * &massless).amax() > MASSLESS_PART * largest || moving.is_empty() {
        return None;
    }
    let scale =
        DVector::from_iterator(moving.len(), moving.iter().map(|&i| 1.0 / of_mass.eigenvalues[i].sqrt()));
    let unit = of_mass.eigenvectors.select_columns(&moving) * DMatrix::from_diagonal(&scale);
    let parts = (unit.tr_mul(&change) * unit).symmetric_eigenvalues();
    Some([parts.min(), parts.max()])
}
