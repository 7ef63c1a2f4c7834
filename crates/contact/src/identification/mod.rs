//! Parameters of a contact from measured impacts: least squares with the motion of a constant mass on k xᵖ and a damper.
//!
//! m̄ δ̈ = m̄ g − F, F = k δᵖ + c δ^((p−1)/2) δ̇ or k δᵖ (1 + d δ̇), while F pushes; free motion before and after. Each record has its own touch,
//! its own approach speed, and for each signal an offset, for forces and accelerations also a linear drift. The weights are the variances of
//! the residuals. The covariance is that of correlated residuals, H⁻¹ G H⁻¹ with H = JᵀJ and G = Σ ρ(|s−t|) JₛJₜᵀ; ρ is their
//! autocorrelation. Source: Seber and Wild, Nonlinear Regression, sections 2.1 and 6.2; first-order error propagation as in the GUM, 5.2.

mod fit;
mod motion;
mod record;
mod result;
mod search;
mod start;

pub use record::{
    DamperForm, EXPONENTS, Estimate, Identification, IdentifiedRecord, IdentifiedSignal, Known,
    LEAST_SAMPLES, MOST_SAMPLES, Measured, OtherModel, Record, SampleUse, Signal,
};

use crate::ContactLawError;
use crate::error::{LawParameter, positive};
use fit::Fit;
use record::{finds_mass, has};
use search::no_motion;

/// Identifies the contact of measured impacts.
///
/// The mass is identified if a record has a force with another signal or a known speed; otherwise `known.mass` is used.
///
/// # Errors
/// [`ContactLawError`]: no record, or more than [`MOST_SAMPLES`] around the impacts; a record with less than [`LEAST_SAMPLES`] or without an impact; times that do
/// not increase; numbers that are not finite; a mass that is needed and not known; a search without a result.
pub fn identify(records: &[Record], known: &Known) -> Result<Identification, ContactLawError> {
    check(records, known)?;
    let forms = match known.damper {
        Some(form) => vec![form],
        None => vec![DamperForm::HuntCrossley, DamperForm::KelvinVoigt],
    };
    let fits = forms.into_iter().map(|form| Fit::new(records, *known, form).and_then(Fit::best));
    let (fits, errors): (Vec<_>, Vec<_>) = fits.partition(Result::is_ok);
    let fits: Vec<Fit> = fits.into_iter().flatten().collect();
    let seconds = fits.iter().filter_map(|fit| fit.with_second_term()?.best().ok());
    let second = best_form(seconds.collect());
    let Some((fit, other_form)) = best_form(fits) else {
        return Err(errors.into_iter().find_map(Result::err).unwrap_or_else(no_motion));
    };
    match second.filter(|(second, _)| fit.needs_second_term(second)) {
        Some((second, other_form)) if known.exponent.is_none() => {
            second.identification(&second.compared(other_form, Some(&fit)))
        }
        second => fit.identification(&fit.compared(other_form, second.as_ref().map(|(second, _)| second))),
    }
}

/// The fit with the better form of the damper, and the mean square of the residuals with the other form divided by its. A contact that gains
/// energy is the worse one.
fn best_form(mut fits: Vec<Fit<'_>>) -> Option<(Fit<'_>, Option<f64>)> {
    let rank = |fit: &Fit| (fit.gains_energy(&fit.unknowns), fit.misfit());
    fits.sort_by(|a, b| rank(a).partial_cmp(&rank(b)).unwrap_or(std::cmp::Ordering::Equal));
    let mut fits = fits.into_iter();
    let best = fits.next()?;
    let ratio = fits.next().map(|other| best.ratio_of(&other));
    Some((best, ratio))
}

/// Checks the records and the known values.
fn check(records: &[Record], known: &Known) -> Result<(), ContactLawError> {
    let refuse = |why: String| Err(ContactLawError::Record { record: None, why });
    if records.is_empty() {
        return refuse("no record is given; expected the times and signals of at least one impact".into());
    }
    for (number, record) in records.iter().enumerate() {
        let refuse = |why: String| Err(ContactLawError::Record { record: Some(number), why });
        let count = record.times.len();
        if count < LEAST_SAMPLES {
            return refuse(format!("{count} samples; expected {LEAST_SAMPLES} at least"));
        }
        if record.signals.is_empty() {
            let names = Measured::ALL.map(|quantity| quantity.name_and_unit().0).join(", ");
            return refuse(format!("no signal; expected one or more of {names}"));
        }
        for (i, signal) in record.signals.iter().enumerate() {
            let (name, _) = signal.quantity.name_and_unit();
            if record.signals[..i].iter().any(|other| other.quantity == signal.quantity) {
                return refuse(format!("{name} is given twice; expected one signal of each quantity"));
            }
            if signal.values.len() != count {
                return refuse(format!("{} values of {name} and {count} times", signal.values.len()));
            }
        }
        let numbers = record.times.iter().chain(record.signals.iter().flat_map(|signal| &signal.values));
        if let Some(number) = numbers.into_iter().find(|number| !number.is_finite()) {
            return refuse(format!("{number} is given; finite numbers are expected"));
        }
        if let Some(at) = record.times.windows(2).position(|pair| pair[0] >= pair[1]) {
            let (before, after) = (record.times[at], record.times[at + 1]);
            return refuse(format!("the time {after} s follows {before} s; expected increasing times"));
        }
        record.speed.map_or(Ok(0.0), |speed| positive(LawParameter::Speed, speed))?;
    }
    known.mass.map_or(Ok(0.0), |mass| positive(LawParameter::Mass, mass))?;
    if let Some(got) = known.exponent.filter(|exponent| !EXPONENTS.contains(exponent)) {
        let valid = "a number from 0.5 to 8";
        return Err(ContactLawError::OutOfRange { what: LawParameter::Exponent, got, valid });
    }
    if !known.gravity.is_finite() {
        let valid = "a finite number";
        return Err(ContactLawError::OutOfRange {
            what: "gravity along the motion, m/s²".into(),
            got: known.gravity,
            valid,
        });
    }
    if known.mass.is_none() && !records.iter().any(finds_mass) {
        let is_forced = records.iter().any(|record| has(record, Measured::Force));
        return refuse(
            if is_forced {
                "a force alone does not determine the mass; give the approach speed or the drop height, another signal, or the mass"
            } else {
                "signals without a force determine the stiffness and the damping per mass only; give the mass, or a force"
            }
            .into(),
        );
    }
    Ok(())
}
