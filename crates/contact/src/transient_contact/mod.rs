//! Speed limit of a robot that may hit a person: transient contact of ISO/TS 15066.
//!
//! The energy ½ μ v² of the relative motion compresses the spring of the body region, ½ F²/k, with the two-body mass
//! μ = 1/(1/m_H + 1/m_R). Hence F = v √(μ k): the peak force of an undamped linear contact.
//!
//! m_R is the effective mass of the robot at the contact. The standard uses M/2 + m_L, half the moving mass plus the
//! load, for every pose and direction. The effective mass along the direction of motion, (uᵀ J M⁻¹ Jᵀ u)⁻¹, follows
//! from the equations of motion and may be several times smaller or larger. [`TransientContact`] accepts both.
//! Damping in the contact changes the force: [`Damper::impact`](crate::Damper::impact) on a
//! [`CompliantContact`](crate::CompliantContact) with the mass μ and the stiffness k gives the factor: the smallest
//! is 0.81 at e = 0.49; below e = 0.30 it is more than 1.
//!
//! The equations are those of ISO/TS 15066:2016, Annex A (now in ISO 10218-2:2025), as quoted in public secondary
//! sources; the standard itself was not read. The limits of force and pressure are inputs from the standard.

mod body_region;

pub use body_region::BodyRegion;

use crate::ContactLawError;
use crate::error::{LawParameter, not_negative, positive, representable};
use serde::Serialize;

/// Mass M/2 + m_L of a robot according to the standard, in kg: half the mass of the moving parts, plus the load with
/// the tool.
///
/// Errors: M not a finite number above zero, m_L negative, NaN or infinite.
pub fn standard_robot_mass(moving_mass: f64, load: f64) -> Result<f64, ContactLawError> {
    let half = 0.5 * positive("mass of the moving parts, kg", moving_mass)?;
    representable("mass of the robot, kg", half + not_negative(LawParameter::Load, load)?)
}

/// Impact of a robot on a region of the body: two masses and a spring between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransientContact {
    reduced_mass: f64,
    stiffness: f64,
}

/// Speed limit, with force and energy of the impact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SafeSpeed {
    /// Largest relative speed, in m/s.
    pub speed: f64,
    /// Largest force, in N.
    pub force: f64,
    /// Energy of the impact, F²/(2k) = ½ μ v², in J.
    pub energy: f64,
}

impl TransientContact {
    /// Robot with the mass m_R, in kg, and a region of the body. Errors: m_R is not a finite number above zero.
    pub fn new(region: &BodyRegion, robot_mass: f64) -> Result<Self, ContactLawError> {
        Self::with_body(region.mass, region.stiffness, robot_mass)
    }

    /// Robot with an infinite mass: μ = m_H.
    pub fn immovable(region: &BodyRegion) -> Self {
        Self { reduced_mass: region.mass, stiffness: region.stiffness }
    }

    /// Robot with the mass m_R, and a body with a given mass m_H, in kg, and stiffness k, in N/m.
    ///
    /// Errors: one of the numbers is not a finite number above zero.
    pub fn with_body(body_mass: f64, stiffness: f64, robot_mass: f64) -> Result<Self, ContactLawError> {
        let body = positive("mass of the body's region, kg", body_mass)?;
        let robot = positive("mass of the robot, kg", robot_mass)?;
        let stiffness = positive("stiffness of the body's region, N/m", stiffness)?;
        // Smaller mass divided by 1 plus the ratio of the masses: no overflow.
        let (light, heavy) = if body < robot { (body, robot) } else { (robot, body) };
        Ok(Self { reduced_mass: light / (1.0 + light / heavy), stiffness })
    }

    /// μ = 1/(1/m_H + 1/m_R), in kg.
    pub fn reduced_mass(self) -> f64 {
        self.reduced_mass
    }

    /// k, in N/m.
    pub fn stiffness(self) -> f64 {
        self.stiffness
    }

    /// Force per speed √(μ k), in N·s/m.
    fn impedance(self) -> f64 {
        self.reduced_mass.sqrt() * self.stiffness.sqrt()
    }

    /// Force F = v √(μ k), in N, at the relative speed v, in m/s.
    ///
    /// Errors: v is negative, NaN or infinite; F overflows.
    pub fn force(self, speed: f64) -> Result<f64, ContactLawError> {
        let speed = not_negative("relative speed, m/s", speed)?;
        if speed == 0.0 { Ok(0.0) } else { representable("force, N", speed * self.impedance()) }
    }

    /// Speed limit v = F/√(μ k) for the largest permitted force F, in N.
    ///
    /// Errors: F is not a finite number above zero; the result overflows.
    pub fn speed_for_force(self, force: f64) -> Result<SafeSpeed, ContactLawError> {
        let force = positive(LawParameter::Force, force)?;
        let speed = representable("relative speed, m/s", force / self.impedance())?;
        let energy = representable("energy, J", 0.5 * force * (force / self.stiffness))?;
        Ok(SafeSpeed { speed, force, energy })
    }

    /// Robot with the mass m_R, in kg, and a rigid fixed body (a person held against a wall): μ = m_R. There is no
    /// spring, so a limit of force does not apply. Errors: m_R is not a finite number above zero.
    pub fn against_fixed_body(robot_mass: f64) -> Result<Self, ContactLawError> {
        Ok(Self { reduced_mass: positive("mass of the robot, kg", robot_mass)?, stiffness: f64::INFINITY })
    }

    /// Speed limit v = √(2E/μ) for the largest permitted energy E of the impact, in J.
    ///
    /// Errors: E is not a finite number above zero; the result overflows.
    pub fn speed_for_energy(self, energy: f64) -> Result<SafeSpeed, ContactLawError> {
        let energy = positive(LawParameter::Energy, energy)?;
        let speed = representable("relative speed, m/s", (2.0 * energy).sqrt() / self.reduced_mass.sqrt())?;
        Ok(SafeSpeed { speed, force: speed * self.impedance(), energy })
    }

    /// Speed limit v = P/μ for the largest permitted momentum P, in N·s, exchanged until both sides have the same
    /// speed.
    ///
    /// Errors: P is not a finite number above zero; the result overflows.
    pub fn speed_for_momentum(self, momentum: f64) -> Result<SafeSpeed, ContactLawError> {
        let momentum = positive(LawParameter::Momentum, momentum)?;
        let speed = representable("relative speed, m/s", momentum / self.reduced_mass)?;
        let energy = representable("energy, J", 0.5 * momentum * speed)?;
        Ok(SafeSpeed { speed, force: speed * self.impedance(), energy })
    }

    /// Speed limit v = p A/√(μ k) for the largest permitted pressure p, in Pa, on the contact area A, in m².
    ///
    /// Errors: one of the two is not a finite number above zero; the result overflows.
    pub fn speed_for_pressure(self, pressure: f64, area: f64) -> Result<SafeSpeed, ContactLawError> {
        let force = positive(LawParameter::Pressure, pressure)? * positive(LawParameter::Area, area)?;
        self.speed_for_force(representable("force, N", force)?)
    }
}
