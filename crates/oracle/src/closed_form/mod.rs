//! Effective masses in closed form.
//!
//! Lengths in m, masses in kg, inertias in kg·m²; every result is m̄ in kg.

mod planar;
mod train;

use nalgebra::{Matrix3, Vector2, Vector3};
pub use planar::{
    Crossing, FourBar, PlanarBody, PlanarPose, SliderCrank, antiparallelogram, planar_effective_mass,
};
pub use train::{
    elliptic_trammel, gear_pair, hooke_output_angle, hooke_ratio, hooke_shaft, massless_arm_suspension,
    planetary_gear, rack_and_pinion, slider,
};

/// Point mass m at r_A from a hinge on a massless rod, contact at r_B: m̄ = m (r_A / r_B)².
///
/// Source: Euler's note (Fayzullin 2018), the worked example.
pub fn point_mass_pendulum(mass: f64, r_a: f64, r_b: f64) -> f64 {
    mass * (r_a / r_b).powi(2)
}

/// Rigid body on a hinge, contact line at the moment arm r_B: m̄ = J_O / r_B².
///
/// Source: Euler's note (Fayzullin 2018; there as m (r_i / r_B)², r_i = √(J_O / m)).
pub fn physical_pendulum(inertia_about_hinge: f64, r_b: f64) -> f64 {
    inertia_about_hinge / (r_b * r_b)
}

/// Two sides of a contact without common body, such as free bodies in central impact: 1/m̄ = 1/m̄₁ + 1/m̄₂.
///
/// The form m̄₁ (m̄₂ / (m̄₁ + m̄₂)) does not overflow and tends to m̄₁ for a heavy second side.
pub fn series(mass_1: f64, mass_2: f64) -> f64 {
    mass_1 * (mass_2 / (mass_1 + mass_2))
}

/// Free body with an eccentric contact: 1/m̄ = 1/m + (r × n)ᵀ I⁻¹ (r × n).
///
/// r is the vector from the centre of mass to the contact point, n the unit normal, I the inertia about the
/// centre of mass, all in the same axes. `None` if I is singular. Source: Routh, Dynamics of a System of Rigid
/// Bodies, the chapter on impact.
pub fn free_body(
    mass: f64,
    inertia_about_com: &Matrix3<f64>,
    r: &Vector3<f64>,
    n: &Vector3<f64>,
) -> Option<f64> {
    let arm = r.cross(n);
    let spin = inertia_about_com.cholesky()?.solve(&arm);
    Some(1.0 / (1.0 / mass + arm.dot(&spin)))
}

/// Uniform thin rod hinged at one end, contact normal to the rod at the other end: m̄ = m / 3 (J_O = m l² / 3,
/// r_B = l).
pub fn rod_tip(mass: f64) -> f64 {
    mass / 3.0
}

/// Rod of [`rod_tip`] with its hinge on a base of mass M that translates along the normal: m̄ = m (4M + m) / (4
/// (3M + m)); m/3 for M → ∞, m/4 for M = 0.
///
/// From M = [M+m, ml/2; ml/2, ml²/3], j = (1, l).
pub fn rod_tip_on_sliding_base(mass: f64, base: f64) -> f64 {
    mass * (4.0 * base + mass) / (4.0 * (3.0 * base + mass))
}

/// Two masses on parallel guides, coupled by a gear with the ratio k: m₁ + m₂ k².
///
/// Kinetic energy of the coupling (mimic) referred to the master.
pub fn geared(mass_1: f64, mass_2: f64, ratio: f64) -> f64 {
    mass_1 + mass_2 * ratio * ratio
}

/// Link of a planar arm with its centre of mass on the line between its joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarLink {
    /// Mass, kg.
    pub mass: f64,
    /// Distance from joint to tip, m.
    pub length: f64,
    /// Distance from joint to centre of mass, m.
    pub com: f64,
    /// Moment of inertia about the centre of mass, normal to the plane, kg·m².
    pub inertia: f64,
}

impl PlanarLink {
    /// Uniform thin rod: c = l/2, I = m l²/12.
    pub fn rod(mass: f64, length: f64) -> Self {
        Self { mass, length, com: length / 2.0, inertia: mass * length * length / 12.0 }
    }

    /// Point mass at the tip of a massless rod.
    pub fn point(mass: f64, length: f64) -> Self {
        Self { mass, length, com: length, inertia: 0.0 }
    }
}

/// Planar arm of two links with a contact at `reach` along the second: m̄ = det M / (M₂₂ j₁² − 2 M₁₂ j₁ j₂ +
/// M₁₁ j₂²).
///
/// | symbol | in the rates of the absolute angles θ₁, θ₂               |
/// |--------|----------------------------------------------------------|
/// | M₁₁    | I₁ + m₁ c₁² + m₂ l₁² + a₁ + a₂                           |
/// | M₁₂    | m₂ l₁ c₂ cos(θ₁ − θ₂) − a₂                               |
/// | M₂₂    | I₂ + m₂ c₂² + a₂                                         |
/// | j      | l₁ n·e(θ₁ + 90°), b n·e(θ₂ + 90°), e(θ) = (cos θ, sin θ) |
///
/// Angles absolute, rad, from x; `armature` a₁ at the base joint, a₂ at the elbow (rate θ̇₂ − θ̇₁); `normal` in the
/// plane, of unit length. Covers the double pendulum (point masses or rods). By hand from the kinetic energy.
pub fn planar_2r(
    links: [PlanarLink; 2],
    armature: [f64; 2],
    angles: [f64; 2],
    reach: f64,
    normal: Vector2<f64>,
) -> f64 {
    let [first, second] = links;
    let m11 = first.inertia
        + first.mass * first.com * first.com
        + second.mass * first.length * first.length
        + armature[0]
        + armature[1];
    let m12 = second.mass * first.length * second.com * (angles[0] - angles[1]).cos() - armature[1];
    let m22 = second.inertia + second.mass * second.com * second.com + armature[1];
    let across = |angle: f64| Vector2::new(-angle.sin(), angle.cos());
    let (j1, j2) = (first.length * normal.dot(&across(angles[0])), reach * normal.dot(&across(angles[1])));
    (m11 * m22 - m12 * m12) / (m22 * j1 * j1 - 2.0 * m12 * j1 * j2 + m11 * j2 * j2)
}

#[cfg(test)]
mod tests {
    use super::*;

    // A dozen roundings of well-conditioned expressions.
    const TOL: f64 = 1e-14;

    fn assert_close(got: f64, expected: f64, tolerance: f64) {
        assert!((got - expected).abs() <= tolerance * expected.abs(), "got {got}, expected {expected}");
    }

    #[test]
    fn pendulums_by_hand() {
        assert_close(point_mass_pendulum(3.0, 1.0, 0.5), 12.0, TOL);
        // m = 2.3, h = .35, I_c = .04, b = .5: J_O = .04 + 2.3·.1225 = .32175.
        assert_close(physical_pendulum(0.32175, 0.5), 1.287, TOL);
        assert_close(rod_tip(0.6), physical_pendulum(0.6 * 4.0 / 3.0, 2.0), TOL);
    }

    #[test]
    fn central_impact_lies_between_half_the_lighter_and_the_lighter() {
        assert_close(series(2.0, 2.0), 1.0, TOL);
        assert_close(series(1.0, 3.0), 0.75, TOL);
        assert_close(series(1.0, 1e30), 1.0, TOL);
        assert_close(geared(2.0, 1.0, -3.0), 11.0, TOL);
    }

    #[test]
    fn a_free_rod_weighs_a_quarter_at_its_tip() {
        let (m, l) = (1.2, 0.8);
        let moment = m * l * l / 12.0;
        let inertia = Matrix3::from_diagonal(&Vector3::new(1e-6, moment, moment));
        let r = Vector3::new(l / 2.0, 0.0, 0.0);
        assert_close(free_body(m, &inertia, &r, &Vector3::y()).unwrap(), m / 4.0, TOL);
        assert_close(free_body(m, &inertia, &r, &Vector3::x()).unwrap(), m, TOL);
        assert_eq!(free_body(m, &Matrix3::zeros(), &r, &Vector3::y()), None);
    }

    #[test]
    fn the_sliding_base_has_its_limits() {
        assert_close(rod_tip_on_sliding_base(0.8, 0.0), 0.2, TOL);
        assert_close(rod_tip_on_sliding_base(0.9, 1e20), 0.3, TOL);
        // M = m = 1, l = 1: det = 2/3 − 1/4 = 5/12; jᵀ adj M j = 1/3 − 1 + 2 = 4/3.
        assert_close(rod_tip_on_sliding_base(1.0, 1.0), 5.0 / 16.0, TOL);
    }

    #[test]
    fn stretched_and_folded_double_pendulums_by_hand() {
        // Stretched along x, point masses 1 at distances 1 and 2, contact normal to x at the tip: M = [2, 1; 1,
        // 1], j = (1, 1); det 1, jᵀ adj M j = 1 − 2 + 2 = 1.
        let links = [PlanarLink::point(1.0, 1.0); 2];
        let y = Vector2::new(0.0, 1.0);
        assert_close(planar_2r(links, [0.0; 2], [0.0, 0.0], 1.0, y), 1.0, TOL);
        // At a right angle the second rod is along y and transmits the whole force: both masses move together.
        let angles = [0.0, std::f64::consts::FRAC_PI_2];
        assert_close(planar_2r(links, [0.0; 2], angles, 1.0, y), 2.0, TOL);
        // Normal to the second rod only the mass at the tip moves.
        assert_close(planar_2r(links, [0.0; 2], angles, 1.0, Vector2::new(1.0, 0.0)), 1.0, TOL);
    }

    #[test]
    fn double_pendulum_of_the_contact_page() {
        // CONTACT.md §6, verified there against a KKT solution with 14, 9 and 10 digits.
        let links = [PlanarLink::rod(1.4, 0.6), PlanarLink::rod(0.9, 0.5)];
        let angles = [-30f64.to_radians(), 25f64.to_radians()];
        let n = Vector2::new(0.2, 0.98).normalize();
        let at = |armature| planar_2r(links, armature, angles, 0.5, n);
        assert_close(at([0.0, 0.0]), 0.45252397213682, 1e-13);
        assert_close(at([0.05, 0.02]), 0.526092113, 2e-9);
        assert_close(at([0.5, 0.5]), 1.095216791, 1e-9);
    }
}
