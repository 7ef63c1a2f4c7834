//! Gear trains, shafts and rods, and the suspension of Euler's note (Fayzullin 2018).

/// Mass on a guide, with a contact normal at a given angle to the guide: m̄ = m / cos².
///
/// The closing speed is the cosine times the speed along the guide.
pub fn slider(mass: f64, cosine: f64) -> f64 {
    mass / (cosine * cosine)
}

/// Rack of mass m that drives a pinion of moment of inertia J and radius r, contact along the rack: m̄ = m + J / r².
///
/// The pinion rotates by 1/r per unit displacement of the rack.
pub fn rack_and_pinion(mass: f64, inertia: f64, radius: f64) -> f64 {
    mass + inertia / (radius * radius)
}

/// Two geared shafts with the speed ratio i, contact at the moment arm r of the first: m̄ = (J₁ + i² J₂) / r².
pub fn gear_pair(inertia_1: f64, inertia_2: f64, ratio: f64, arm: f64) -> f64 {
    (inertia_1 + ratio * ratio * inertia_2) / (arm * arm)
}

/// Speed ratio of a Hooke's joint, driven shaft to driving shaft: cos β / (1 − sin² β cos² θ).
///
/// β is the angle between the shafts, θ the angle of the driving shaft, with θ = 0 if its pin lies in the plane
/// of both shafts.
///
/// With m the normal of that plane and u₁, u₂ the shafts, the pins are a = sin θ m + cos θ m×u₁ and
/// b = cos φ m − sin φ m×u₂ (at right angles at θ = φ = 0). a·b = sin θ cos φ − cos θ sin φ cos β = 0, so
/// tan φ = tan θ / cos β, and φ' = cos β / (cos² β cos² θ + sin² θ).
/// Source: any text on machines, e.g. Norton; the sign convention is ours.
pub fn hooke_ratio(beta: f64, theta: f64) -> f64 {
    beta.cos() / (1.0 - (beta.sin() * theta.cos()).powi(2))
}

/// Angle φ of the driven shaft, tan φ = tan θ / cos β, for any number of turns; see [`hooke_ratio`].
///
/// φ is computed as θ plus a difference within ±90°: tan (φ − θ) = sin θ cos θ (1 − cos β) / (cos β cos² θ + sin² θ).
pub fn hooke_output_angle(beta: f64, theta: f64) -> f64 {
    let (sin, cos) = theta.sin_cos();
    theta + (sin * cos * (1.0 - beta.cos()) / (beta.cos() * cos * cos + sin * sin)).atan()
}

/// Two shafts with a massless Hooke's joint, contact at the moment arm r of the driving shaft: m̄ = (J₁ + J₂
/// φ'²) / r².
pub fn hooke_shaft(inertia_1: f64, inertia_2: f64, beta: f64, theta: f64, arm: f64) -> f64 {
    gear_pair(inertia_1, inertia_2, hooke_ratio(beta, theta), arm)
}

/// Two sliders on perpendicular lines, connected by a massless rod, at distances x and y from the intersection;
/// contact at the first slider along its line: m̄ = m₁ + m₂ (x / y)².
///
/// x² + y² = l² gives x ẋ + y ẏ = 0.
pub fn elliptic_trammel(mass_1: f64, mass_2: f64, x: f64, y: f64) -> f64 {
    mass_1 + mass_2 * (x / y).powi(2)
}

/// Planetary gear with a fixed ring, contact at the moment arm r of the carrier: m̄ = (J_c + J_s (1 + z_r/z_s)²
/// + k (m_p ρ² + J_p (1 − z_r/z_p)²)) / r².
///
/// `inertias` of carrier, sun and one planet (about its axis), `planet_mass` at the radius `planet_radius` ρ
/// from the centre, `planets` the number k of planets, teeth z of sun, planet and ring. Relative to the
/// carrier, with rate 1, the rates are −1 of the ring, −z_r/z_p of a planet and z_r/z_s of the sun (Willis).
pub fn planetary_gear(
    inertias: [f64; 3],
    planet_mass: f64,
    planet_radius: f64,
    planets: f64,
    teeth: [f64; 3],
    arm: f64,
) -> f64 {
    let [carrier, sun, planet] = inertias;
    let [sun_teeth, planet_teeth, ring_teeth] = teeth;
    let orbit = planet_mass * planet_radius * planet_radius;
    let spin = planet * (1.0 - ring_teeth / planet_teeth).powi(2);
    (carrier + sun * (1.0 + ring_teeth / sun_teeth).powi(2) + planets * (orbit + spin)) / (arm * arm)
}

/// Wheel of mass m_K on a parallelogram of massless arms; contact of a bump stop on the arm at r_B, joint of
/// the upright at r_A: m̄ = m_K / l̄², l̄ = r_B / r_A. Exact, since the upright does not rotate.
///
/// Source: Euler's note (Fayzullin 2018; there as an estimate for light arms).
pub fn massless_arm_suspension(wheel_mass: f64, r_a: f64, r_b: f64) -> f64 {
    wheel_mass / (r_b / r_a).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hooke_ratio_is_a_derivative() {
        // Central differences with the errors h² and ε/h.
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
