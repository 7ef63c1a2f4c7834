//! How fast a robot may hit a person: the transient contact of ISO/TS 15066.
//!
//! The energy ½ μ v² of the relative motion goes into the spring of the body's region, ½ F²/k, with the two-body mass
//! μ = 1/(1/m_H + 1/m_R). So F = v √(μ k): the peak force of an undamped linear contact.
//!
//! m_R is the effective mass of the robot at the contact. The standard's is M/2 + m_L, half the moving mass and the load,
//! whatever the pose and the direction; the effective mass along the direction of motion, (uᵀ J M⁻¹ Jᵀ u)⁻¹, is what
//! F = m a gives, and may be several times smaller or larger. [`TransientContact`] takes either.
//! Damping in the contact changes the force: [`Damper::impact`](crate::Damper::impact) on a [`CompliantContact`](crate::CompliantContact) of
//! the mass μ and the stiffness k gives the factor: 0.81 times at e = 0.49, the least, and more than 1 below e = 0.30.
//!
//! The equations are ISO/TS 15066:2016's (now in ISO 10218-2:2025), Annex A, as public secondary sources give them;
//! the standard itself was not opened. The limits of force and pressure are input, to be taken from the standard.

use crate::error::{not_negative, positive, representable};
use crate::{BodyRegion, ContactLawError};
use serde::Serialize;

/// The mass M/2 + m_L that the standard takes for a robot, in kg: half the mass of its moving parts, and the load
/// with the tool.
///
/// Errors: M not a finite number above zero, m_L negative, NaN or infinite.
pub fn standard_robot_mass(moving_mass: f64, load: f64) -> Result<f64, ContactLawError> {
    let half = 0.5 * positive("mass of the moving parts, kg", moving_mass)?;
    representable("mass of the robot, kg", half + not_negative("load, kg", load)?)
}

/// A robot that hits a region of the body: two masses and the spring between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransientContact {
    reduced_mass: f64,
    stiffness: f64,
}

/// How fast, and what it comes to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SafeSpeed {
    /// The greatest relative speed, in m/s.
    pub speed: f64,
    /// The greatest force, in N.
    pub force: f64,
    /// The energy of the impact, F²/(2k) = ½ μ v², in J.
    pub energy: f64,
}

impl TransientContact {
    /// A robot of the mass m_R, in kg, that hits this region. Errors: m_R is not a finite number above zero.
    pub fn new(region: &BodyRegion, robot_mass: f64) -> Result<Self, ContactLawError> {
        Self::with_body(region.mass, region.stiffness, robot_mass)
    }

    /// A robot that does not give way: μ = m_H.
    pub fn immovable(region: &BodyRegion) -> Self {
        Self { reduced_mass: region.mass, stiffness: region.stiffness }
    }

    /// The same with a body's mass m_H, in kg, and stiffness k, in N/m, of the user's own.
    ///
    /// Errors: any of them is not a finite number above zero.
    pub fn with_body(body_mass: f64, stiffness: f64, robot_mass: f64) -> Result<Self, ContactLawError> {
        let body = positive("mass of the body's region, kg", body_mass)?;
        let robot = positive("mass of the robot, kg", robot_mass)?;
        let stiffness = positive("stiffness of the body's region, N/m", stiffness)?;
        // The lighter one over 1 and their ratio: nothing overflows.
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

    /// √(μ k), in N·s/m: the force of each m/s.
    fn impedance(self) -> f64 {
        self.reduced_mass.sqrt() * self.stiffness.sqrt()
    }

    /// F = v √(μ k), in N, at the relative speed v, in m/s.
    ///
    /// Errors: v is negative, NaN or infinite; F is beyond a 64-bit float.
    pub fn force(self, speed: f64) -> Result<f64, ContactLawError> {
        let speed = not_negative("relative speed, m/s", speed)?;
        if speed == 0.0 { Ok(0.0) } else { representable("force, N", speed * self.impedance()) }
    }

    /// v = F/√(μ k) for the greatest force that the user allows, in N.
    ///
    /// Errors: F is not a finite number above zero; the result is beyond a 64-bit float.
    pub fn speed_for_force(self, force: f64) -> Result<SafeSpeed, ContactLawError> {
        let force = positive("greatest force, N", force)?;
        let speed = representable("relative speed, m/s", force / self.impedance())?;
        let energy = representable("energy, J", 0.5 * force * (force / self.stiffness))?;
        Ok(SafeSpeed { speed, force, energy })
    }

    /// A robot of the mass m_R, in kg, that hits what does not give way (a person held against a wall): μ = m_R, without a
    /// spring, so that no force limits it. Errors: m_R is not a finite number above zero.
    pub fn against_nothing_that_moves(robot_mass: f64) -> Result<Self, ContactLawError> {
        Ok(Self { reduced_mass: positive("mass of the robot, kg", robot_mass)?, stiffness: f64::INFINITY })
    }

    /// v = √(2E/μ) for the greatest energy of the impact that the user allows, in J.
    ///
    /// Errors: E is not a finite number above zero; the result is beyond a 64-bit float.
    pub fn speed_for_energy(self, energy: f64) -> Result<SafeSpeed, ContactLawError> {
        let energy = positive("greatest energy, J", energy)?;
        let speed = representable("relative speed, m/s", (2.0 * energy).sqrt() / self.reduced_mass.sqrt())?;
        Ok(SafeSpeed { speed, force: speed * self.impedance(), energy })
    }

    /// v = P/μ for the greatest momentum that the user allows to be exchanged until both sides move alike, in N·s.
    ///
    /// Errors: P is not a finite number above zero; the result is beyond a 64-bit float.
    pub fn speed_for_momentum(self, momentum: f64) -> Result<SafeSpeed, ContactLawError> {
        let momentum = positive("greatest momentum, N·s", momentum)?;
        let speed = representable("relative speed, m/s", momentum / self.reduced_mass)?;
        let energy = representable("energy, J", 0.5 * momentum * speed)?;
        Ok(SafeSpeed { speed, force: speed * self.impedance(), energy })
    }

    /// v = p A/√(μ k) for the greatest pressure that the user allows, in Pa, on the area of the contact, in m².
    ///
    /// Errors: either is not a finite number above zero; the result is beyond a 64-bit float.
    pub fn speed_for_pressure(self, pressure: f64, area: f64) -> Result<SafeSpeed, ContactLawError> {
        let force =
            positive("greatest pressure, Pa", pressure)? * positive("area of the contact, m^2", area)?;
        self.speed_for_force(representable("force, N", force)?)
    }
}
