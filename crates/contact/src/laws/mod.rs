//! The contact laws, one a file.

mod carvalho_martins;
mod exact;
mod exudyn_mixed;
mod facts;
mod flores;
mod gharib_hurmuzlu;
mod gonthier;
mod herbert_mcwhannell;
mod hu_guo;
mod hunt_crossley_1975;
mod lankarani_nikravesh;
mod lee_wang;
mod safaeifar_farshidianfar;
mod zhiying_qishao;

use crate::error::{nearest, positive, unit_interval};
use crate::solutions::{hunt_crossley, kelvin_voigt};
use crate::{CompliantContact, ContactLawError, Damper, Separation};
use facts::Facts;
use serde::Serialize;

/// A contact law: which damper gives the restitution asked for.
///
/// Adding one is a file, a variant, and a line in [`Law::ALL`] and in `facts`.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
pub enum Law {
    /// A spring in parallel with a damper, solved exactly.
    KelvinVoigt,
    /// A damper that stiffens with the spring, solved exactly.
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
    /// EXUDYN's mixture.
    ExudynMixed,
}

/// Another name under which a law is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alias {
    /// The other name.
    pub name: &'static str,
    /// The law.
    pub law: Law,
    /// The exponent that the name stands for; none where the name fits every exponent.
    pub exponent: Option<f64>,
    /// The end of the contact that the name stands for.
    pub separation: Option<Separation>,
    /// Under which condition they are the same.
    pub note: &'static str,
}

/// A name as it is looked for.
fn canonical(name: &str) -> String {
    name.trim().to_lowercase().replace(['_', ' '], "-")
}

/// The error of an approximation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ApproximationError {
    /// The restitution asked for.
    pub requested: f64,
    /// The restitution that the law's damping gives.
    pub achieved: f64,
}

impl ApproximationError {
    /// achieved − requested.
    pub fn error(self) -> f64 {
        self.achieved - self.requested
    }
}

impl Law {
    /// All of them, the exact ones first.
    pub const ALL: [Self; 14] = [
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
    ];

    /// Other names.
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
            note: "Anagnostopoulos 1988, 2004: the same with the exponent 1 where the contact ends when the gap closes \
                   (from memory of the literature, not opened)",
        },
        Alias {
            name: "zhang-sharf",
            law: Self::HuntCrossley,
            exponent: None,
            separation: None,
            note: "Zhang and Sharf 2004, 2009: the same implicit relation (from memory of the literature, not opened)",
        },
        Alias {
            name: "marhefka-orin",
            law: Self::HuntCrossley1975,
            exponent: None,
            separation: None,
            note: "Marhefka and Orin 1999: the same (from memory of the literature, not opened)",
        },
        Alias {
            name: "ye",
            law: Self::HuGuo,
            exponent: Some(1.0),
            separation: None,
            note: "Ye, Li and Zhu 2009: the same with the exponent 1",
        },
    ];

    /// The alias of this name, upper and lower case alike.
    pub fn alias(name: &str) -> Option<&'static Alias> {
        const ALIASES: &[Alias] = &Law::ALIASES;
        let wanted = canonical(name);
        ALIASES.iter().find(|alias| alias.name == wanted)
    }

    /// The law of this name or alias, upper and lower case alike. Errors: [`ContactLawError::UnknownLaw`].
    pub fn from_name(name: &str) -> Result<Self, ContactLawError> {
        let wanted = canonical(name);
        let names =
            || Self::ALL.into_iter().map(Self::name).chain(Self::ALIASES.iter().map(|alias| alias.name));
        Self::ALL
            .into_iter()
            .find(|law| law.name() == wanted)
            .or_else(|| Self::alias(name).map(|alias| alias.law))
            .ok_or_else(|| ContactLawError::UnknownLaw {
                name: name.into(),
                nearest: nearest(&wanted, names()),
                known: names().collect::<Vec<_>>().join(", "),
            })
    }

    /// As it is written in files and on the command line.
    pub fn name(self) -> &'static str {
        self.facts().name
    }

    /// A title for display.
    pub fn title(self) -> &'static str {
        self.facts().title
    }

    /// The force and how its damping follows from the restitution e, in plain text; v the approach speed.
    pub fn formula(self) -> &'static str {
        self.facts().formula
    }

    /// Author and year, and which documents were read.
    pub fn source(self) -> &'static str {
        self.facts().source
    }

    /// Whether the damper gives the restitution asked for, or nearly.
    pub fn is_exact(self) -> bool {
        self.facts().approximation.is_none()
    }

    /// Whether the damping depends on the approach speed, and so must be given it.
    pub fn needs_speed(self) -> bool {
        self != Self::KelvinVoigt
    }

    /// The damper of this law for the restitution e on this contact, at the approach speed in m/s where the law
    /// needs one ([`Law::needs_speed`]).
    ///
    /// `separation` matters to Kelvin–Voigt alone. Errors: e or the speed out of range, also where no speed is needed, the speed missing, an e that
    /// the law does not reach, a damping beyond a 64-bit float.
    pub fn damper(
        self,
        contact: CompliantContact,
        restitution: f64,
        speed: Option<f64>,
        separation: Separation,
    ) -> Result<Damper, ContactLawError> {
        let speed = speed.map(|speed| positive("approach speed, m/s", speed)).transpose()?;
        let number = match self {
            Self::KelvinVoigt => {
                return Damper::kelvin_voigt(
                    contact,
                    kelvin_voigt::ratio(restitution, separation)?,
                    separation,
                );
            }
            _ => self.number(restitution)?,
        };
        let speed = speed.ok_or(ContactLawError::SpeedNeeded { law: self.name() })?;
        Damper::hunt_crossley(number / speed)
    }

    /// The restitution that the law's damping gives where e is asked for: e itself of an exact law.
    ///
    /// Errors: e is not from 0 to 1, or one that the law does not reach.
    pub fn approximation_error(self, restitution: f64) -> Result<ApproximationError, ContactLawError> {
        let requested = unit_interval("restitution", restitution)?;
        let achieved =
            if self.is_exact() { requested } else { hunt_crossley::restitution(self.number(requested)?)? };
        Ok(ApproximationError { requested, achieved })
    }

    /// a = d v of the Hunt–Crossley family.
    fn number(self, restitution: f64) -> Result<f64, ContactLawError> {
        let e = unit_interval("restitution", restitution)?;
        let Some(formula) = self.facts().approximation else {
            return hunt_crossley::dissipation_number(e);
        };
        let number = formula(e);
        if number.is_finite() {
            return Ok(number);
        }
        Err(ContactLawError::Unreachable {
            law: self.name(),
            restitution: e,
            why: "its damping grows without bound towards 0",
            remedy: "ask for a small restitution, such as 0.01",
        })
    }

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
        }
    }
}
