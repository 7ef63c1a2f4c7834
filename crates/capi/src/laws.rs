//! Contact laws: the damper for a restitution, and the characteristics of an impact.

use crate::boundary::arrays::{enumeration_value, input_text, nan_if_unknown};
use crate::boundary::handle::{argument_mut, read_argument};
use crate::boundary::names::element_at;
use crate::boundary::status::{Failure, PERCUSS_ERROR_LAW, PERCUSS_ERROR_NAME, guard_call, percuss_status};
use percuss::contact::{CompliantContact, ContactLawError, Damper, Law, Separation};
use std::ffi::{CStr, c_char};

/// Number of a contact law, from percuss_law_find.
pub type percuss_law = i32;
/// A spring in parallel with a damper, solved exactly.
pub const PERCUSS_LAW_KELVIN_VOIGT: percuss_law = 0;
/// A damper proportional to the spring force, solved exactly.
pub const PERCUSS_LAW_HUNT_CROSSLEY: percuss_law = 1;

/// End of a contact, for a law whose force would pull before the gap closes.
pub type percuss_separation = i32;
/// The contact ends when the force has fallen to zero: contacts that do not stick, and simulators that use max(0, F).
pub const PERCUSS_FORCE_VANISHES: percuss_separation = 0;
/// The contact ends when the spring has its free length again; the damper pulls shortly before.
pub const PERCUSS_GAP_CLOSES: percuss_separation = 1;

/// F = k xᵖ + c x^((p−1)/2) ẋ.
pub const PERCUSS_DAMPER_KELVIN_VOIGT: i32 = 0;
/// F = k xᵖ (1 + d ẋ).
pub const PERCUSS_DAMPER_HUNT_CROSSLEY: i32 = 1;
/// F = k xᵖ (1 + (π/2) η sgn ẋ).
pub const PERCUSS_DAMPER_LOSS_FACTOR: i32 = 2;

/// An effective mass and the spring between the two surfaces: force k xᵖ at the penetration x.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_spring {
    /// m̄, kg.
    pub effective_mass: f64,
    /// k, N/mᵖ.
    pub stiffness: f64,
    /// p, 1 to 10: 1 for a linear spring, 1.5 for Hertz's spheres.
    pub exponent: f64,
}

/// A damper in parallel with the spring.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_damper {
    /// PERCUSS_DAMPER_KELVIN_VOIGT, PERCUSS_DAMPER_HUNT_CROSSLEY or PERCUSS_DAMPER_LOSS_FACTOR.
    pub kind: i32,
    /// End of the contact, for a Kelvin–Voigt damper.
    pub separation: percuss_separation,
    /// c of a Kelvin–Voigt damper, N·s/m^((p+1)/2), N·s/m for p = 1; else NaN.
    pub coefficient: f64,
    /// Damping ratio ζ of a Kelvin–Voigt damper on its design contact; loss factor η; else NaN.
    pub ratio: f64,
    /// d of a Hunt–Crossley damper, s/m; else NaN.
    pub dissipation: f64,
}

/// Characteristics of one impact.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_impact {
    /// Rebound speed over approach speed.
    pub restitution: f64,
    /// From the first touch to the end, s; NaN if the gap needs infinite time to close.
    pub duration: f64,
    /// Greatest penetration, m.
    pub max_penetration: f64,
    /// From the first touch, s.
    pub time_of_max_penetration: f64,
    /// Greatest contact force, N.
    pub peak_force: f64,
    /// From the first touch, s.
    pub time_of_peak_force: f64,
    /// Dissipated energy, J.
    pub energy_lost: f64,
    /// Rebound speed, m/s.
    pub rebound_speed: f64,
}

const NAMES: [&CStr; Law::ALL.len()] = [
    c"kelvin-voigt",
    c"hunt-crossley",
    c"hunt-crossley-1975",
    c"herbert-mcwhannell",
    c"lee-wang",
    c"lankarani-nikravesh",
    c"gonthier",
    c"zhiying-qishao",
    c"flores",
    c"gharib-hurmuzlu",
    c"hu-guo",
    c"carvalho-martins",
    c"safaeifar-farshidianfar",
    c"exudyn-mixed",
    c"loss-factor",
];

/// Converts the error of a contact law to a failure with PERCUSS_ERROR_LAW.
fn with_law_status<T>(result: Result<T, ContactLawError>) -> Result<T, Failure> {
    result.map_err(Failure::with_status(PERCUSS_ERROR_LAW))
}

impl percuss_spring {
    /// Compliant contact with this mass, stiffness and exponent; checks the numbers.
    fn to_contact(self) -> Result<CompliantContact<'static>, Failure> {
        let linear = with_law_status(CompliantContact::new(self.effective_mass, self.stiffness))?;
        with_law_status(linear.with_exponent(self.exponent))
    }
}

impl percuss_damper {
    /// Damper for C; NaN for coefficients of the other kind.
    fn from_damper(damper: Damper) -> Self {
        match damper {
            Damper::KelvinVoigt { ratio, coefficient, separation } => Self {
                kind: PERCUSS_DAMPER_KELVIN_VOIGT,
                separation: match separation {
                    Separation::ForceVanishes => PERCUSS_FORCE_VANISHES,
                    Separation::GapCloses => PERCUSS_GAP_CLOSES,
                },
                coefficient,
                ratio,
                dissipation: f64::NAN,
            },
            Damper::HuntCrossley { dissipation } => Self {
                kind: PERCUSS_DAMPER_HUNT_CROSSLEY,
                separation: PERCUSS_FORCE_VANISHES,
                coefficient: f64::NAN,
                ratio: f64::NAN,
                dissipation,
            },
            Damper::LossFactor { loss_factor } => Self {
                kind: PERCUSS_DAMPER_LOSS_FACTOR,
                separation: PERCUSS_FORCE_VANISHES,
                coefficient: f64::NAN,
                ratio: loss_factor,
                dissipation: f64::NAN,
            },
        }
    }

    /// Damper on this contact: its force depends on the coefficient.
    fn to_damper(self, contact: CompliantContact) -> Result<Damper, Failure> {
        let kinds = [PERCUSS_DAMPER_KELVIN_VOIGT, PERCUSS_DAMPER_HUNT_CROSSLEY, PERCUSS_DAMPER_LOSS_FACTOR];
        match enumeration_value(&kinds, self.kind, "kind of the damper")? {
            PERCUSS_DAMPER_KELVIN_VOIGT => {
                let separation = enumeration_value(&Separation::ALL, self.separation, "separation")?;
                with_law_status(Damper::kelvin_voigt_from_coefficient(contact, self.coefficient, separation))
            }
            PERCUSS_DAMPER_HUNT_CROSSLEY => with_law_status(Damper::hunt_crossley(self.dissipation)),
            _ => with_law_status(Damper::loss_factor(self.ratio)),
        }
    }
}

/// Number of laws: a law has a number from 0 to this count − 1.
#[unsafe(no_mangle)]
pub extern "C" fn percuss_law_count() -> usize {
    Law::ALL.len()
}

/// The name of a law; valid until the program ends.
///
/// # Safety
/// name is null or points to storage for a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_law_name(law: percuss_law, name: *mut *const c_char) -> percuss_status {
    guard_call(|| {
        let index = usize::try_from(law).unwrap_or(usize::MAX);
        *argument_mut(name, "name")? = element_at(&NAMES, index, "law")?.as_ptr();
        Ok(())
    })
}

/// The law of this name or alias, upper and lower case alike. Errors: PERCUSS_ERROR_NAME, with the most similar name.
///
/// # Safety
/// name ends with a zero byte; law is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_law_find(name: *const c_char, law: *mut percuss_law) -> percuss_status {
    guard_call(|| {
        let found =
            Law::from_name(input_text(name, "name")?).map_err(Failure::with_status(PERCUSS_ERROR_NAME))?;
        let number = Law::ALL.iter().position(|law| *law == found).unwrap_or_default();
        *argument_mut(law, "law")? = number as percuss_law;
        Ok(())
    })
}

/// The damper of a law for the restitution e on this spring, at the approach speed in m/s; speed 0 means unknown
/// (Kelvin–Voigt needs no speed). separation is used by Kelvin–Voigt only.
///
/// Errors: PERCUSS_ERROR_LAW: out of range, missing speed, an e that the law cannot reach.
///
/// # Safety
/// spring is null or points to one; damper is null or points to storage for one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_law_damper(
    law: percuss_law,
    spring: *const percuss_spring,
    restitution: f64,
    speed: f64,
    separation: percuss_separation,
    damper: *mut percuss_damper,
) -> percuss_status {
    guard_call(|| {
        let index = usize::try_from(law).unwrap_or(usize::MAX);
        let law = *element_at(&Law::ALL, index, "law")?;
        let contact = read_argument(spring, "spring")?.to_contact()?;
        let separation = enumeration_value(&Separation::ALL, separation, "separation")?;
        let speed = (speed != 0.0).then_some(speed);
        let found = with_law_status(law.damper(contact, restitution, speed, separation))?;
        *argument_mut(damper, "damper")? = percuss_damper::from_damper(found);
        Ok(())
    })
}

/// The restitution of a damper on this spring at this approach speed, m/s. Exact for the force law.
///
/// Errors: PERCUSS_ERROR_LAW.
///
/// # Safety
/// spring and damper are null or point to one; restitution is null or points to storage for a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_damper_restitution(
    damper: *const percuss_damper,
    spring: *const percuss_spring,
    speed: f64,
    restitution: *mut f64,
) -> percuss_status {
    guard_call(|| {
        let contact = read_argument(spring, "spring")?.to_contact()?;
        let found = read_argument(damper, "damper")?.to_damper(contact)?.restitution(contact, speed);
        *argument_mut(restitution, "restitution")? = with_law_status(found)?;
        Ok(())
    })
}

/// Characteristics of the impact on this spring at this approach speed, m/s.
///
/// Errors: PERCUSS_ERROR_LAW.
///
/// # Safety
/// spring and damper are null or point to one; impact is null or points to storage for one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_damper_impact(
    damper: *const percuss_damper,
    spring: *const percuss_spring,
    speed: f64,
    impact: *mut percuss_impact,
) -> percuss_status {
    guard_call(|| {
        let contact = read_argument(spring, "spring")?.to_contact()?;
        let found =
            with_law_status(read_argument(damper, "damper")?.to_damper(contact)?.impact(contact, speed))?;
        *argument_mut(impact, "impact")? = percuss_impact {
            restitution: found.restitution,
            duration: nan_if_unknown(found.duration),
            max_penetration: found.max_penetration,
            time_of_max_penetration: found.time_of_max_penetration,
            peak_force: found.peak_force,
            time_of_peak_force: found.time_of_peak_force,
            energy_lost: found.energy_lost,
            rebound_speed: found.rebound_speed,
        };
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_laws() {
        for (law, name) in Law::ALL.into_iter().zip(NAMES) {
            assert_eq!(Ok(law.name()), name.to_str());
        }
        assert_eq!(Law::ALL[PERCUSS_LAW_KELVIN_VOIGT as usize], Law::KelvinVoigt);
        assert_eq!(Law::ALL[PERCUSS_LAW_HUNT_CROSSLEY as usize], Law::HuntCrossley);
    }
}
