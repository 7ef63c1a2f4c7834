//! Laws of restitution and phases of a frictional impact.

use nalgebra::Vector3;

/// Meaning of the coefficient of restitution e in an impact with friction. Without friction all laws agree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RestitutionLaw {
    /// Energetic (Stronge 1990): the normal impulse returns e² of the work of compression. Never creates energy.
    #[default]
    Energetic,
    /// Poisson: the normal impulse of expansion is e times that of compression. Never creates energy at one contact.
    Poisson,
    /// Newton: the separation speed is e times the closing speed, with the sliding and sticking of the process. Can create
    /// energy.
    Newton,
    /// Algebraic form (Whittaker 1904, Kane and Levinson 1985): Newton's speeds, and either no sliding after the impact or
    /// friction µ times the normal impulse against the first sliding direction. Can create energy.
    Algebraic,
}

impl RestitutionLaw {
    /// All laws.
    pub const ALL: [Self; 4] = [Self::Energetic, Self::Poisson, Self::Newton, Self::Algebraic];

    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Energetic => "energetic",
            Self::Poisson => "poisson",
            Self::Newton => "newton",
            Self::Algebraic => "algebraic",
        }
    }
}

/// Kind of a phase of the impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseKind {
    /// The point slides.
    Slip,
    /// The point slides, and the friction accelerates the approach: the normal impulse grows without compression. A jam ends
    /// in sticking.
    Jam,
    /// The point does not slide.
    Stick,
    /// The point slides again after its sliding has stopped.
    ReverseSlip,
}

impl PhaseKind {
    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Slip => "slip",
            Self::Jam => "jam",
            Self::Stick => "stick",
            Self::ReverseSlip => "reverse slip",
        }
    }
}

/// Part of an impact with one kind of motion, within compression or expansion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase {
    /// Kind of motion.
    pub kind: PhaseKind,
    /// True during expansion.
    pub is_expansion: bool,
    /// Normal impulse of the phase, N·s.
    pub normal_impulse: f64,
}

/// Impact with friction at one contact, in the axes of the contact (−n̂ and two tangents).
#[derive(Clone, Debug, PartialEq)]
pub struct Collision {
    /// Impulse on the contact link, N·s.
    pub impulse: Vector3<f64>,
    /// Relative velocity after the impact, m/s: opening speed and sliding velocity.
    pub after: Vector3<f64>,
    /// Phases in order; empty for the algebraic form.
    pub phases: Vec<Phase>,
    /// Normal impulse of compression, N·s; that of all compressions if there are several.
    pub compression: f64,
    /// Work of the normal impulse in compression (negative) and expansion, J; zero for the algebraic form.
    pub normal_work: [f64; 2],
    /// Change of the kinetic energy, J: ½ P·(u⁻ + u⁺), negative for a loss.
    pub energy_change: f64,
    /// True if the contact sticks and cannot rebound: a mechanism in which every motion of the point along the normal needs
    /// sliding.
    pub is_wedged: bool,
}

/// Adds a phase, or extends the last one.
pub(crate) fn add_phase(phases: &mut Vec<Phase>, kind: PhaseKind, is_expansion: bool, normal_impulse: f64) {
    match phases.last_mut() {
        Some(last) if last.kind == kind && last.is_expansion == is_expansion => {
            last.normal_impulse += normal_impulse;
        }
        _ if normal_impulse > 0.0 => phases.push(Phase { kind, is_expansion, normal_impulse }),
        _ => {}
    }
}
