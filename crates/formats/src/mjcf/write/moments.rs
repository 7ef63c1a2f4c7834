//! Moments of inertia that MuJoCo accepts.

use super::error::MjcfError;
use crate::writing::changes::Change;
use percuss_mechanism::{Inertial, LinkDescription, Mechanism};
use percuss_spatial::Vector3;

/// Least moment of a moving body, kg·m², and least mass, kg, that MuJoCo accepts (mjMINVAL).
pub(super) const LEAST_INERTIA: f64 = 1e-15;
/// Moment that replaces a smaller one, relative to the largest moment and to m·(size of the mechanism)²: a change of the
/// kinetic energy of a few roundings.
const RELATIVE_MOMENT: f64 = 1e-13;
/// Least moment that replaces a smaller one, kg·m².
const RAISED_MOMENT: f64 = 2.0 * LEAST_INERTIA;
/// Excess C − A − B relative to C up to which a file has rounded the moments of a plate.
const ROUNDED_EXCESS: f64 = 1e-10;
/// Tolerance of A + B ≥ C relative to the largest moment: rounding of the principal moments.
const TRIANGLE_SLACK: f64 = 2e-15;
/// Distance from A + B = C of balanced moments, relative to the largest: above the rounding of MuJoCo's principal moments.
const BALANCED: f64 = 1e-12;

/// Excess C − A − B of the principal moments of a body relative to C, if it is more than a rounding; A + B ≥ C holds for every rigid body.
fn triangle_excess(moments: &Vector3<f64>) -> Option<f64> {
    let (sum, largest) = (moments.sum(), moments.max());
    // Smaller moments are raised.
    let violates = largest >= LEAST_INERTIA && sum - largest < largest * (1.0 - TRIANGLE_SLACK);
    violates.then(|| 2.0 - sum / largest)
}

/// Returns an error if MuJoCo refuses the moments of a link.
pub(super) fn check_moments(inertial: Option<&Inertial>, name: &str) -> Result<(), MjcfError> {
    let Some(inertial) = inertial else { return Ok(()) };
    let moments = inertial.about_com.symmetric_eigenvalues();
    if triangle_excess(&moments).is_some() {
        let reason = format!(
            "MuJoCo refuses moments with A + B < C, which no body has ({:.6e}, {:.6e}, {:.6e} kg·m²); correct the inertia, or write the \
             nearest possible one (--balance-inertia)",
            moments[0], moments[1], moments[2]
        );
        return Err(MjcfError::new("link", name, reason));
    }
    Ok(())
}

/// Removes an excess C − A − B of the moments that is rounding of the file.
pub(super) fn round_moments(inertial: &mut Inertial, name: &str) {
    if triangle_excess(&inertial.about_com.symmetric_eigenvalues()).is_some_and(|e| e <= ROUNDED_EXCESS) {
        balance_moments(inertial, name);
    }
}

/// Mechanism in which the moments of each link with A + B < C, which no body has, are the nearest ones with A + B = C; and the changes. `None` if no
/// link has such moments.
pub fn balance_inertia(mechanism: &Mechanism) -> Option<(Mechanism, Vec<Change>)> {
    let mut changes = Vec::new();
    let builder = mechanism.to_builder().map_links(|mut link: LinkDescription| {
        let change = link.inertial.as_mut().and_then(|inertial| balance_moments(inertial, &link.name));
        changes.extend(change);
        link
    });
    let built = builder.build().ok()?;
    (!changes.is_empty()).then_some((built.mechanism, changes))
}

/// Replaces moments A + B < C by the nearest ones with A + B = C, which differ by a third of the excess. Returns the change, unless it is a rounding.
fn balance_moments(inertial: &mut Inertial, name: &str) -> Option<Change> {
    let principal = inertial.about_com.symmetric_eigen();
    let (old, c) = (principal.eigenvalues, principal.eigenvalues.imax());
    let excess = triangle_excess(&old)?;
    // Moments below 0, which another finding reports, would leave an excess.
    let mut new = old.map(|moment| moment.max(0.0));
    let third = (2.0 * new[c] - new.sum()) / 3.0 + BALANCED * new[c];
    for k in 0..3 {
        new[k] += if k == c { -third } else { third };
    }
    for k in 0..3 {
        let axis = principal.eigenvectors.column(k);
        inertial.about_com += axis * axis.transpose() * (new[k] - old[k]);
    }
    inertial.about_com = inertial.about_com * 0.5 + inertial.about_com.transpose() * 0.5;
    let text = |moments: &Vector3<f64>| format!("{:.6e}, {:.6e}, {:.6e}", moments[0], moments[1], moments[2]);
    let what = format!(
        "principal moments {} kg·m² in place of {}, a change by {:.2} % of the largest",
        text(&new),
        text(&old),
        100.0 * (new - old).amax() / old.max()
    );
    let reason = "MuJoCo refuses moments with A + B < C, which no body has";
    (excess > ROUNDED_EXCESS).then(|| Change::changed("link", name, what, reason))
}

/// Raises moments near 0 of a body with mass. Returns the new value if a moment changed. `size`: that of the mechanism, m.
pub(super) fn raise_moments(inertial: &mut Inertial, size: f64) -> Option<f64> {
    let principal = inertial.about_com.symmetric_eigen();
    let scale = principal.eigenvalues.max().max(inertial.mass * size * size);
    let least = (RELATIVE_MOMENT * scale).max(RAISED_MOMENT);
    if principal.eigenvalues.min() >= LEAST_INERTIA.max(least * 1e-2) {
        return None;
    }
    for (moment, axis) in principal.eigenvalues.iter().zip(principal.eigenvectors.column_iter()) {
        if *moment < least {
            inertial.about_com += axis * axis.transpose() * (least - moment);
        }
    }
    Some(least)
}
