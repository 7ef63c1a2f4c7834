//! Laws of several simultaneous contacts without friction.

use crate::error::ImpactError;
use crate::mobility::delassus::Delassus;
use crate::mobility::semidefinite::contact_scale;
use crate::several::complementarity::{complementarity, speed_rounding};
use crate::several::energetic::{ContactStiffness, energetic_impulses};
use crate::tolerances::{CREATED_ENERGY, MOST_CONTACTS};
use nalgebra::{DMatrix, DVector};

/// Law of several simultaneous contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SimultaneousLaw {
    /// Newton: 0 ≤ u⁺ + e min(u⁻, 0) ⊥ P ≥ 0. Deviation from Moreau, whose form has e u⁻ in place of e min(u⁻, 0): the sides of a contact
    /// that opens before the impact could then move into each other.
    Newton,
    /// Poisson (Glocker and Pfeiffer 1995): compression u ≥ 0 ⊥ P_c ≥ 0, then expansion u⁺ ≥ 0 ⊥ P_e − e P_c ≥ 0.
    Poisson,
    /// Energetic with the stiffness ratios of the contacts (Liu, Zhao and Brogliato 2008).
    Energetic,
}

impl SimultaneousLaw {
    /// All laws.
    pub const ALL: [Self; 3] = [Self::Newton, Self::Poisson, Self::Energetic];

    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Newton => "newton",
            Self::Poisson => "poisson",
            Self::Energetic => "energetic",
        }
    }
}

/// Result of a law for several contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct SimultaneousImpact {
    /// The law.
    pub law: SimultaneousLaw,
    /// Normal impulse of each contact, N·s; `None` if redundant contacts leave it open, or if the contact cannot move.
    pub impulses: Vec<Option<f64>>,
    /// Opening speed of each contact after the impact, m/s.
    pub after: Vec<f64>,
    /// Lost kinetic energy, J; negative if the law creates energy.
    pub energy_loss: f64,
    /// True if the law creates energy: it is not valid here.
    pub creates_energy: bool,
    /// Impulses of which the rates follow; of least norm if open.
    pub solution: DVector<f64>,
}

/// Frictionless impact of several contacts by one law.
///
/// Masses, constraints and e do not determine the rates after several simultaneous impacts: the rates also depend on the ratios of the
/// contact stiffnesses. The energetic law takes these ratios as input; Newton's and Poisson's laws make other assumptions. The spread of
/// the laws shows the uncertainty.
///
/// `before`: opening speeds, k; `restitution`: e of each contact. An immovable contact takes part in no law: its impulse is open, and its
/// speed after the impact is zero.
///
/// # Errors
/// [`ImpactError`]: values out of range, no movable contact that closes, no solution.
pub fn simultaneous_impact(
    delassus: &Delassus,
    before: &DVector<f64>,
    restitution: &[f64],
    law: SimultaneousLaw,
    stiffness: &ContactStiffness,
) -> Result<SimultaneousImpact, ImpactError> {
    simultaneous_impact_of_matrix(&delassus.normal_matrix(), before, restitution, law, stiffness)
}

/// As [`simultaneous_impact`], from the Delassus matrix of the normals, k×k.
///
/// # Errors
/// As for [`simultaneous_impact`].
pub fn simultaneous_impact_of_matrix(
    matrix: &DMatrix<f64>,
    before: &DVector<f64>,
    restitution: &[f64],
    law: SimultaneousLaw,
    stiffness: &ContactStiffness,
) -> Result<SimultaneousImpact, ImpactError> {
    let k = before.len();
    if k > MOST_CONTACTS {
        return Err(ImpactError::TooManyContacts { got: k, most: MOST_CONTACTS });
    }
    for (what, got) in [
        ("restitution", restitution.len()),
        ("stiffness", stiffness.ratios.len()),
        ("rows of the Delassus matrix", matrix.nrows()),
    ] {
        if got != k {
            return Err(ImpactError::ContactValues { what, got, expected: k });
        }
    }
    if let Some(&got) = restitution.iter().find(|e| !(0.0..=1.0).contains(*e)) {
        return Err(ImpactError::Restitution { got });
    }
    let closing = before.iter().fold(f64::NEG_INFINITY, |most, u| most.max(-u));
    if !(closing.is_finite() && closing > 0.0) {
        return Err(ImpactError::ClosingSpeed { got: closing });
    }
    let scale = contact_scale(matrix);
    let matrix = &DMatrix::from_fn(k, k, |r, c| if scale[r] * scale[c] > 0.0 { matrix[(r, c)] } else { 0.0 });
    let before = &before.zip_map(&scale, |u, scale| if scale > 0.0 { u } else { 0.0 });
    if before.min() >= 0.0 {
        return Err(ImpactError::Immovable);
    }
    let no_end = || ImpactError::NoEnd { law: law.name() };
    let (solution, is_open) = match law {
        SimultaneousLaw::Newton => {
            let q = DVector::from_fn(k, |i, _| before[i] + restitution[i] * before[i].min(0.0));
            let found = complementarity(matrix, &q).ok_or_else(no_end)?;
            (found.z, found.is_open)
        }
        SimultaneousLaw::Poisson => {
            let compression = complementarity(matrix, before).ok_or_else(no_end)?;
            let least = DVector::from_fn(k, |i, _| restitution[i] * compression.z[i]);
            let at_least = &compression.z + &least;
            let q = before + matrix * &at_least;
            // Rounding of a vanishing opening speed is no further impulse.
            let limit = speed_rounding(&scale, before);
            let q = DVector::from_fn(k, |i, _| if q[i].abs() * scale[i] <= limit[i] { 0.0 } else { q[i] });
            let more = complementarity(matrix, &q).ok_or_else(no_end)?;
            let is_open = compression.is_open.iter().zip(&more.is_open).map(|(a, b)| *a || *b).collect();
            (at_least + more.z, is_open)
        }
        SimultaneousLaw::Energetic => {
            let is_open = scale.iter().map(|scale| *scale == 0.0).collect();
            (energetic_impulses(matrix, before, restitution, stiffness)?, is_open)
        }
    };
    let after = before + matrix * &solution;
    let energy_loss = -0.5 * solution.dot(&(before + &after));
    let size = 0.5 * (0..k).map(|i| solution[i] * solution[i] * matrix[(i, i)]).sum::<f64>();
    Ok(SimultaneousImpact {
        law,
        impulses: (0..k).map(|i| (!is_open[i]).then_some(solution[i])).collect(),
        after: after.iter().copied().collect(),
        energy_loss,
        creates_energy: energy_loss < -CREATED_ENERGY * size,
        solution,
    })
}
