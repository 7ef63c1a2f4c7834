//! Trains of couplings, shafts and rods, and the suspension of Euler's note (Fayzullin 2018).

/// A mass on a guide, struck at an angle to it whose cosine is given: m̄ = m / cos².
///
/// The closing speed is the cosine times the speed along the guide.
pub fn slider(mass: f64, cosine: f64) -> f64 {
    mass / (cosine * cosine)
}

/// A rack of mass m that turns a pinion of moment J and radius r, contact along the rack: m̄ = m + J / r².
///
/// The pinion turns by 1/r per unit of the rack's way.
pub fn rack_and_pinion(mass: f64, inertia: f64, radius: f64) -> f64 {
    mass + inertia / (radius * radius)
}

/// Two geared shafts, the second turning `ratio` times as fast; contact at the arm r of the first:
/// m̄ = (J₁ + i² J₂) / r².
pub fn gear_pair(inertia_1: f64, inertia_2: f64, ratio: f64, arm: f64) -> f64 {
    (inertia_1 + ratio * ratio * inertia_2) / (arm * arm)
}

/// Speed of the driven shaft of a Hooke's joint over that of the driving one: cos β / (1 − sin² β cos² θ).
///
/// β the angle between the shafts; θ the driving shaft's angle, 0 where its pin lies in the plane of both shafts.
///
/// With m the normal of that plane and u₁, u₂ the shafts, the pins are a = sin θ m + cos θ m×u₁ and
/// b = cos φ m − sin φ m×u₂ (at right angles at θ = φ = 0). a·b = sin θ cos φ − cos θ sin φ cos β = 0, so
/// tan φ = tan θ / cos β, and φ' = cos β / (cos² β cos² θ + sin² θ).
/// Source: any text on machines, e.g. Norton; the sign convention is ours.
pub fn hooke_ratio(beta: f64, theta: f64) -> f64 {
    beta.cos() / (1.0 - (beta.sin() * theta.cos()).powi(2))
}

/// The driven shaft's angle φ, tan φ = tan θ / cos β, on any turn: see [`hooke_ratio`].
///
/// Written as θ and the rest, which never leaves ±90°: tan (φ − θ) = sin θ cos θ (1 − cos β) / (cos β cos² θ + sin² θ).
pub fn hooke_output_angle(beta: f64, theta: f64) -> f64 {
    let (sin, cos) = theta.sin_cos();
    theta + (sin * cos * (1.0 - beta.cos()) / (beta.cos() * cos * cos + sin * sin)).atan()
}

/// Two shafts and a Hooke's joint without mass, contact at the arm r of the driving one: m̄ = (J₁ + J₂ φ'²) / r².
pub fn hooke_shaft(inertia_1: f64, inertia_2: f64, beta: f64, theta: f64, arm: f64) -> f64 {
    gear_pair(inertia_1, inertia_2, hooke_ratio(beta, theta), arm)
}

/// Two sliders on lines at a right angle, x and y from where these cross, joined by a rod without mass; contact at the
/// first along its line: m̄ = m₁ + m₂ (x / y)².
///
/// x² + y² = l² gives x ẋ + y ẏ = 0.
pub fn elliptic_trammel(mass_1: f64, mass_2: f64, x: f64, y: f64) -> f64 {
    mass_1 + mass_2 * (x / y).powi(2)
}

/// A planetary gear with its ring fixed, contact at the arm r of the carrier:
/// m̄ = (J_c + J_s (1 + z_r/z_s)² + k (m_p ρ² + J_p (1 − z_r/z_p)²)) / r².
///
/// `inertias` of carrier, sun and one planet (about its own axis), `planet_mass` at the radius `planet_radius` ρ from
/// the centre, `planets` k of them, teeth z of sun, planet and ring. Seen from the carrier, which turns at 1, the
/// ring turns at −1, a planet at −z_r/z_p and the sun at z_r/z_s (Willis).
pub fn planetary_gear(
    inertias: [f64; 3],
    planet_mass: f64,
    planet_radius: f64,
    planets: f64,
    teeth: [f64; 3],
    arm: f64,
) -> f64 {
    let [carrier, sun, planet] = inertias;
    let [of_sun, of_planet, of_ring] = teeth;
    let orbit = planet_mass * planet_radius * planet_radius;
    let spin = planet * (1.0 - of_ring / of_planet).powi(2);
    (carrier + sun * (1.0 + of_ring / of_sun).powi(2) + planets * (orbit + spin)) / (arm * arm)
}

/// A wheel of mass m_K on a parallelogram of arms without mass, contact with a bump stop on the arm at r_B, the upright's
/// joint being at r_A: m̄ = m_K / l̄², l̄ = r_B / r_A. Exact, since the upright does not turn.
///
/// Source: Euler's note (Fayzullin 2018; there the estimate for arms that are light).
pub fn massless_arm_suspension(wheel_mass: f64, r_a: f64, r_b: f64) -> f64 {
    wheel_mass / (r_b / r_a).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hooke_ratio_is_a_derivative() {
        // Central differences: h² and ε/h.
        const H: f64 = 1e-5;
        let angle = |t| hooke_output_angle(0.6, t);
        for i in 0..36 {
            let theta = 0.05 + f64::from(i) * 0.17;
            let ratio = (angle(theta + H) - angle(theta - H)).sin() / (2.0 * H);
            assert!((ratio - hooke_ratio(0.6, theta)).abs() < 2e-10, "{theta}");
        }
    }

    #[test]
    fn trains_by_hand() {
        // z_s = 20, z_p = 20, z_r = 60, one planet: 1 + 16·1 + (2·0.25 + 4·1) at r = 1.
        let gear = planetary_gear([1.0, 1.0, 1.0], 2.0, 0.5, 1.0, [20.0, 20.0, 60.0], 1.0);
        assert!((gear - 21.5).abs() < 1e-13);
        assert!((hooke_ratio(1.0, 0.0) - 1.0 / 1f64.cos()).abs() < 1e-15);
        assert!((hooke_ratio(1.0, std::f64::consts::FRAC_PI_2) - 1f64.cos()).abs() < 1e-15);
        assert!((massless_arm_suspension(40.0, 0.5, 0.25) - 160.0).abs() < 1e-13);
        assert!((rack_and_pinion(2.0, 0.01, 0.1) - 3.0).abs() < 1e-15);
        assert!((elliptic_trammel(1.0, 2.0, 3.0, 4.0) - 2.125).abs() < 1e-15);
        assert!((slider(2.0, 0.5) - 8.0).abs() < 1e-15);
    }
}
