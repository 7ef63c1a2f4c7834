//! Contact laws.

mod approximate;
mod exact;
mod facts;

use crate::error::{LawParameter, nearest, positive, unit_interval};
use crate::solutions::{hunt_crossley, kelvin_voigt, loss_factor};
use crate::{CompliantContact, ContactLawError, Damper, Separation};
use approximate::{
    carvalho_martins, exudyn_mixed, flores, gharib_hurmuzlu, gonthier, herbert_mcwhannell, hu_guo,
    hunt_crossley_1975, lankarani_nikravesh, lee_wang, safaeifar_farshidianfar, zhiying_qishao,
};
use facts::Facts;
use serde::Serialize;

/// Contact law: determines the damper from the required restitution.
///
/// A new law needs a file, a variant, and a line in [`Law::ALL`] and in `facts`.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
pub enum Law {
    /// Spring in parallel with a damper, solved exactly.
    KelvinVoigt,
    /// Damper force proportional to the spring force, solved exactly.
    HuntCrossley,
    /// Hunt and Crossley 1975, linearised.
    HuntCrossley1975,
    /// Herbert and McWhannell 1977.
    HerbertMcwhannell,
    /// Lee and Wang 1983.
    LeeWang,
    /// Lankarani and Nikravesh 1990.
    LankaraniNikravesh,
    /// Gonthier and others 2004.
    Gonthier,
    /// Zhiying and Qishao 2006.
    ZhiyingQishao,
    /// Flores and others 2011.
    Flores,
    /// Gharib and Hurmuzlu 2012.
    GharibHurmuzlu,
    /// Hu and Guo 2015.
    HuGuo,
    /// Carvalho and Martins 2019.
    CarvalhoMartins,
    /// Safaeifar and Farshidianfar 2020.
    SafaeifarFarshidianfar,
    /// Mixed formula of EXUDYN.
    ExudynMixed,
    /// Hysteresis with a loss factor, solved exactly.
    LossFactor,
}

/// Alternative name of a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alias {
    /// Alternative name.
    pub name: &'static str,
    /// Law.
    pub law: Law,
    /// Exponent implied by the name; `None` if the name applies to every exponent.
    pub exponent: Option<f64>,
    /// End of the contact implied by the name.
    pub separation: Option<Separation>,
    /// Condition under which the name and the law are equivalent.
    pub note: &'static str,
}

/// Normalises a name for the search.
fn canonical(name: &str) -> String {
    name.trim().to_lowercase().replace(['_', ' '], "-")
}

/// Error of an approximation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ApproximationError {
    /// Required restitution.
    pub requested: f64,
    /// Restitution that results from the damping of the law.
    pub achieved: f64,
}

impl ApproximationError {
    /// Error: achieved − requested.
    pub fn error(self) -> f64 {
        self.achieved - self.requested
    }
}

impl Law {
    /// All laws. The order is that of the numbers in C.
    pub const ALL: [Self; 15] = [
        Self::KelvinVoigt,
        Self::HuntCrossley,
        Self::HuntCrossley1975,
        Self::HerbertMcwhannell,
        Self::LeeWang,
        Self::LankaraniNikravesh,
        Self::Gonthier,
        Self::ZhiyingQishao,
        Self::Flores,
        Self::GharibHurmuzlu,
        Self::HuGuo,
        Self::CarvalhoMartins,
        Self::SafaeifarFarshidianfar,
        Self::ExudynMixed,
        Self::LossFactor,
    ];

    /// Alternative names of all laws.
    pub const ALIASES: [Alias; 5] = [
        Alias {
            name: "tsuji",
            law: Self::KelvinVoigt,
            exponent: Some(1.5),
            separation: None,
            note: "Tsuji, Tanaka and Ishida 1992: the same with the exponent 3/2",
        },
        Alias {
            name: "anagnostopoulos",
            law: Self::KelvinVoigt,
            exponent: Some(1.0),
            separation: Some(Separation::GapCloses),
            note: "Anagnostopoulos 1988, 2004: the same with the exponent 1 if the contact ends when the gap \
                closes (cited from memory, not read)",
        },
        Alias {
            name: "zhang-sharf",
            law: Self::HuntCrossley,
            exponent: None,
            separation: None,
            note: "Zhang and Sharf 2004, 2009: the same implicit relation (cited from memory, not read)",
        },
        Alias {
            name: "marhefka-orin",
            law: Self::HuntCrossley1975,
            exponent: None,
            separation: None,
            note: "Marhefka and Orin 1999: the same (cited from memory, not read)",
        },
        Alias {
            name: "ye",
            law: Self::HuGuo,
            exponent: Some(1.0),
            separation: None,
            note: "Ye, Li and Zhu 2009: the same with the exponent 1",
        },
    ];

    /// Returns the alias with a name, ignoring case.
    pub fn alias(name: &str) -> Option<&'static Alias> {
        const ALIASES: &[Alias] = &Law::ALIASES;
        let normalised = canonical(name);
        ALIASES.iter().find(|alias| alias.name == normalised)
    }

    /// Returns the law with a name or alias, ignoring case. Errors: [`ContactLawError::UnknownLaw`].
    pub fn from_name(name: &str) -> Result<Self, ContactLawError> {
        let normalised = canonical(name);
        let names =
            || Self::ALL.into_iter().map(Self::name).chain(Self::ALIASES.iter().map(|alias| alias.name));
        Self::ALL
            .into_iter()
            .find(|law| law.name() == normalised)
            .or_else(|| Self::alias(name).map(|alias| alias.law))
            .ok_or_else(|| ContactLawError::UnknownLaw {
                name: name.into(),
                nearest: nearest(&normalised, names()),
                known: names().collect::<Vec<_>>().join(", "),
            })
    }

    /// Name in files and on the command line.
    pub fn name(self) -> &'static str {
        self.facts().name
    }

    /// Title for display.
    pub fn title(self) -> &'static str {
        self.facts().title
    }

    /// Force, and formula for the damping from the restitution e, as plain text; v is the approach speed.
    pub fn formula(self) -> &'static str {
        self.facts().formula
    }

    /// Author and year, and the documents that were read.
    pub fn source(self) -> &'static str {
        self.facts().source
    }

    /// True if the damper gives exactly the required restitution, false for an approximation.
    pub fn is_exact(self) -> bool {
        self.facts().approximation.is_none()
    }

    /// True if the damping depends on the approach speed, which is then required. On a force curve that of Kelvin–Voigt depends on it too.
    pub fn needs_speed(self) -> bool {
        !matches!(self, Self::KelvinVoigt | Self::LossFactor)
    }

    /// Damper of this law for the restitution e at a contact, for the approach speed in m/s if the law needs one
    /// ([`Law::needs_speed`]).
    ///
    /// `separation` affects only Kelvin–Voigt. Errors: e or the speed is out of range (also if the law needs no
    /// speed); the speed is missing; the law does not reach e; overflow of the damping.
    pub fn damper(
        self,
        contact: CompliantContact,
        restitution: f64,
        speed: Option<f64>,
        separation: Separation,
    ) -> Result<Damper, ContactLawError> {
        let speed = speed.map(|speed| positive(LawParameter::Speed, speed)).transpose()?;
        let needs_speed = || speed.ok_or(ContactLawError::SpeedNeeded { law: self.name() });
        let dissipation_number = match self {
            Self::KelvinVoigt if contact.power_law().is_none() => {
                return Damper::linear_on_curve(contact, restitution, needs_speed()?, separation);
            }
            Self::KelvinVoigt => {
                return Damper::kelvin_voigt(
                    contact,
                    kelvin_voigt::ratio(restitution, separation)?,
                    separation,
                );
            }
            Self::LossFactor => return Damper::loss_factor(loss_factor::loss_factor(restitution)?),
            _ => self.dissipation_number(restitution)?,
        };
        Damper::hunt_crossley(dissipation_number / needs_speed()?)
    }

    /// Restitution that results from the damping of the law for a required e; equal to e for an exact law.
    ///
    /// Errors: e is not from 0 to 1; the law does not reach e.
    pub fn approximation_error(self, restitution: f64) -> Result<ApproximationError, ContactLawError> {
        let requested = unit_interval(LawParameter::Restitution, restitution)?;
        let achieved = if self.is_exact() {
            requested
        } else {
            hunt_crossley::restitution(self.dissipation_number(requested)?)?
        };
        Ok(ApproximationError { requested, achieved })
    }

    /// Dissipation number a = d v by which a law of the Hunt–Crossley family gives e: exact, or by the law's approximation.
    fn dissipation_number(self, restitution: f64) -> Result<f64, ContactLawError> {
        let e = unit_interval(LawParameter::Restitution, restitution)?;
        let Some(formula) = self.facts().approximation else {
            return hunt_crossley::dissipation_number(e);
        };
        let dissipation_number = formula(e);
        if dissipation_number.is_finite() {
            return Ok(dissipation_number);
        }
        Err(ContactLawError::Unreachable {
            law: self.name(),
            restitution: e,
            why: "the damping becomes infinite for e → 0",
            remedy: "use a small restitution, such as 0.01",
        })
    }

    /// Name, formula, source and approximation of the law.
    fn facts(self) -> &'static Facts {
        match self {
            Self::KelvinVoigt => &exact::KELVIN_VOIGT,
            Self::HuntCrossley => &exact::HUNT_CROSSLEY,
            Self::HuntCrossley1975 => &hunt_crossley_1975::FACTS,
            Self::HerbertMcwhannell => &herbert_mcwhannell::FACTS,
            Self::LeeWang => &lee_wang::FACTS,
            Self::LankaraniNikravesh => &lankarani_nikravesh::FACTS,
            Self::Gonthier => &gonthier::FACTS,
            Self::ZhiyingQishao => &zhiying_qishao::FACTS,
            Self::Flores => &flores::FACTS,
            Self::GharibHurmuzlu => &gharib_hurmuzlu::FACTS,
            Self::HuGuo => &hu_guo::FACTS,
            Self::CarvalhoMartins => &carvalho_martins::FACTS,
            Self::SafaeifarFarshidianfar => &safaeifar_farshidianfar::FACTS,
            Self::ExudynMixed => &exudyn_mixed::FACTS,
            Self::LossFactor => &exact::LOSS_FACTOR,
        }
    }
}
