//! Planar linkages with one degree of freedom: positions and velocity ratios from triangles.
//!
//! With the velocity of every body per unit rate of the input, m̄ = 2T / V² needs no matrix:
//!
//! m̄ = Σ (mᵢ |vᵢ|² + Iᵢ ωᵢ²) / (n · v_P)²
//!
//! vᵢ is the velocity of the centre of mass, ωᵢ the angular velocity, v_P the velocity of the contact point.
//! The rate of the input cancels. Source: loop equation as in Norton, Design of Machinery, the chapters on
//! position and velocity; kinematic coefficients as in Uicker, Pennock and Shigley, Theory of Machines and
//! Mechanisms. The formulas are derived below.

use nalgebra::Vector2;

/// Body of a planar linkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarBody {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the body frame, m.
    pub com: Vector2<f64>,
    /// Moment of inertia about the centre of mass, normal to the plane, kg·m².
    pub inertia: f64,
}

impl PlanarBody {
    /// Body without mass.
    pub const MASSLESS: PlanarBody = PlanarBody { mass: 0.0, com: Vector2::new(0.0, 0.0), inertia: 0.0 };

    /// Creates a body from mass (kg), centre of mass (m) and central moment of inertia (kg·m²).
    pub fn new(mass: f64, com: [f64; 2], inertia: f64) -> Self {
        Self { mass, com: com.into(), inertia }
    }
}

/// Pose of a body, and velocity per unit rate of the input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarPose {
    /// Origin of the body frame, m.
    pub origin: Vector2<f64>,
    /// Angle from the x-axis, rad.
    pub angle: f64,
    /// Velocity of the origin per unit rate of the input, m.
    pub velocity: Vector2<f64>,
    /// Angular velocity per unit rate of the input.
    pub rate: f64,
}

impl PlanarPose {
    /// Position of a body point.
    pub fn point(&self, local: Vector2<f64>) -> Vector2<f64> {
        self.origin + local.x * unit_vector(self.angle) + local.y * unit_normal(self.angle)
    }

    /// Velocity of a body point per unit rate of the input.
    pub fn velocity_of(&self, local: Vector2<f64>) -> Vector2<f64> {
        self.velocity + self.rate * (local.x * unit_normal(self.angle) - local.y * unit_vector(self.angle))
    }
}

/// m̄ of a planar mechanism with one degree of freedom: Σ (m v² + I ω²) / (n · v_P)². The contact is at `point`
/// of body `contact_body`, along the unit vector `normal` of the plane.
pub fn planar_effective_mass(
    bodies: &[(PlanarBody, PlanarPose)],
    contact_body: usize,
    point: Vector2<f64>,
    normal: Vector2<f64>,
) -> f64 {
    let energy = |(body, pose): &(PlanarBody, PlanarPose)| {
        body.mass * pose.velocity_of(body.com).norm_squared() + body.inertia * pose.rate * pose.rate
    };
    let closing = normal.dot(&bodies[contact_body].1.velocity_of(point));
    bodies.iter().map(energy).sum::<f64>() / (closing * closing)
}

/// e(θ), the unit vector at the angle θ.
fn unit_vector(angle: f64) -> Vector2<f64> {
    Vector2::new(angle.cos(), angle.sin())
}

/// e(θ + 90°).
fn unit_normal(angle: f64) -> Vector2<f64> {
    Vector2::new(-angle.sin(), angle.cos())
}

/// The two assemblies of a four-bar linkage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// The coupler is to the left of the line to the rocker's pivot.
    Left,
    /// The coupler is to the right.
    Right,
}

/// Four-bar linkage: pivot of the crank at the origin, pivot of the rocker at (ground, 0). The frames of crank
/// and rocker are at their pivots, the frame of the coupler at the crank pin; the x-axis of each link points to
/// its other pin. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourBar {
    /// Distance between the pivots.
    pub ground: f64,
    /// Distance between pivot and pin of the crank.
    pub crank: f64,
    /// Distance between the pins of the coupler.
    pub coupler: f64,
    /// Distance between pivot and pin of the rocker.
    pub rocker: f64,
}

impl FourBar {
    /// Poses of crank, coupler and rocker at the crank angle θ, with velocities per unit rate of θ. `None` if
    /// the linkage cannot be assembled.
    ///
    /// With D the vector from the crank pin A = a e(θ) to the rocker's pivot, d its length, the rocker pin lies
    /// x = (b² + d² − c²) / 2d along D and y = ±√(b² − x²) across it. The derivative of
    /// a e(θ) + b e(φ) = g e(0) + c e(ψ), multiplied by e(ψ) and by e(φ), gives
    ///
    /// φ' = a sin(θ − ψ) / (b sin(ψ − φ)),  ψ' = a sin(θ − φ) / (c sin(ψ − φ)).
    pub fn poses(&self, theta: f64, crossing: Crossing) -> Option<[PlanarPose; 3]> {
        let pin = self.crank * unit_vector(theta);
        let pivot = Vector2::new(self.ground, 0.0);
        let line = pivot - pin;
        let d = line.norm();
        let x = (self.coupler * self.coupler + d * d - self.rocker * self.rocker) / (2.0 * d);
        let rest = self.coupler * self.coupler - x * x;
        if rest.is_nan() || rest < 0.0 {
            return None;
        }
        let y = if crossing == Crossing::Left { rest.sqrt() } else { -rest.sqrt() };
        let forward = line / d;
        let coupler = x * forward + y * Vector2::new(-forward.y, forward.x);
        let rocker = pin + coupler - pivot;
        let (phi, psi) = (coupler.y.atan2(coupler.x), rocker.y.atan2(rocker.x));
        let transmission = (psi - phi).sin();
        let phi_rate = self.crank * (theta - psi).sin() / (self.coupler * transmission);
        let psi_rate = self.crank * (theta - phi).sin() / (self.rocker * transmission);
        let still = Vector2::zeros();
        Some([
            PlanarPose { origin: Vector2::zeros(), angle: theta, velocity: still, rate: 1.0 },
            PlanarPose { origin: pin, angle: phi, velocity: self.crank * unit_normal(theta), rate: phi_rate },
            PlanarPose { origin: pivot, angle: psi, velocity: still, rate: psi_rate },
        ])
    }

    /// Parallelogram with two given sides: the coupler stays parallel to the ground.
    ///
    /// φ = 0, φ' = 0, ψ = θ, ψ' = 1: the coupler translates without rotation.
    pub fn parallelogram(ground: f64, crank: f64) -> Self {
        Self { ground, crank, coupler: ground, rocker: crank }
    }
}

/// The angle ψ of the rocker and its ratio ψ' for the crossed four-bar with sides g, a, g, a (a < g):
/// tan(ψ/2) = −k tan(θ/2), k = (g + a) / (g − a).
///
/// From |a e(θ) − g e(0) − a e(ψ)|² = g²: a (1 − cos(θ − ψ)) = g (cos θ − cos ψ). With σ, δ half of θ + ψ and θ − ψ:
/// a sin² δ = −g sin σ sin δ. Not the parallelogram, δ = 0, so a sin δ = −g sin σ; divided by cos(θ/2) cos(ψ/2),
/// with the tangents s and t of θ/2 and ψ/2: a (s − t) = −g (s + t), t = −s (g + a) / (g − a). A derivative follows.
/// θ within ±180°, ends excluded.
pub fn antiparallelogram(ground: f64, crank: f64, theta: f64) -> (f64, f64) {
    let k = (ground + crank) / (ground - crank);
    let t = (theta / 2.0).tan();
    (2.0 * (-k * t).atan(), -k * (1.0 + t * t) / (1.0 + k * k * t * t))
}

/// Slider-crank: pivot of the crank at the origin, pin of the slider on the line y = offset with x > 0. The
/// rod's frame is at the crank pin with the x-axis to the slider's pin; the slider's frame stays parallel to
/// the ground. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderCrank {
    /// Distance between pivot and pin of the crank.
    pub crank: f64,
    /// Distance between the pins of the rod.
    pub rod: f64,
    /// Distance of the slider's line from the pivot.
    pub offset: f64,
}

impl SliderCrank {
    /// Poses of crank, rod and slider at the crank angle θ, with velocities per unit rate of θ. `None` if the
    /// rod is too short.
    ///
    /// r sin θ + l sin φ = e gives φ; x = r cos θ + l cos φ; differentiation gives φ' = −r cos θ / (l cos φ),
    /// x' = −r sin θ − l sin φ φ'.
    pub fn poses(&self, theta: f64) -> Option<[PlanarPose; 3]> {
        let sine = (self.offset - self.crank * theta.sin()) / self.rod;
        if sine.is_nan() || sine.abs() >= 1.0 {
            return None;
        }
        let phi = sine.asin();
        let rate = -self.crank * theta.cos() / (self.rod * phi.cos());
        let slider_x = self.crank * theta.cos() + self.rod * phi.cos();
        let speed = -self.crank * theta.sin() - self.rod * sine * rate;
        let pin = self.crank * unit_vector(theta);
        Some([
            PlanarPose { origin: Vector2::zeros(), angle: theta, velocity: Vector2::zeros(), rate: 1.0 },
            PlanarPose { origin: pin, angle: phi, velocity: self.crank * unit_normal(theta), rate },
            PlanarPose {
                origin: Vector2::new(slider_x, self.offset),
                angle: 0.0,
                velocity: Vector2::new(speed, 0.0),
                rate: 0.0,
            },
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences with the errors h² and ε/h.
    const H: f64 = 1e-5;
    const TOL: f64 = 2e-10;

    fn coefficients_are_derivatives(poses: impl Fn(f64) -> [PlanarPose; 3], theta: f64) {
        let (exact, plus, minus) = (poses(theta), poses(theta + H), poses(theta - H));
        for i in 0..3 {
            let velocity = (plus[i].origin - minus[i].origin) / (2.0 * H);
            assert!((velocity - exact[i].velocity).norm() < TOL, "{i} at {theta}");
            let turn = (plus[i].angle - minus[i].angle).sin() / (2.0 * H);
            assert!((turn - exact[i].rate).abs() < TOL * (1.0 + turn.abs()), "{i} at {theta}: {turn}");
        }
    }

    #[test]
    fn velocity_ratios_are_derivatives_of_positions() {
        let bar = FourBar { ground: 0.9, crank: 0.25, coupler: 0.8, rocker: 0.6 };
        let engine = SliderCrank { crank: 0.3, rod: 1.1, offset: 0.12 };
        for i in 0..36 {
            let theta = 0.05 + f64::from(i) * 0.17;
            for crossing in [Crossing::Left, Crossing::Right] {
                coefficients_are_derivatives(|t| bar.poses(t, crossing).unwrap(), theta);
            }
            coefficients_are_derivatives(|t| engine.poses(t).unwrap(), theta);
        }
    }

    #[test]
    fn four_bars_close() {
        let bar = FourBar { ground: 0.9, crank: 0.25, coupler: 0.8, rocker: 0.6 };
        for crossing in [Crossing::Left, Crossing::Right] {
            let [_, coupler, rocker] = bar.poses(0.7, crossing).unwrap();
            let gap = coupler.point([0.8, 0.0].into()) - rocker.point([0.6, 0.0].into());
            assert!(gap.norm() < 1e-15, "{gap}");
        }
        let short = FourBar { ground: 2.0, crank: 0.1, coupler: 0.5, rocker: 0.5 };
        assert_eq!(short.poses(0.0, Crossing::Left), None);
    }

    #[test]
    fn parallelograms_open_and_crossed() {
        let bar = FourBar::parallelogram(1.0, 0.4);
        for theta in [-2.5, -0.8, 0.3, 1.2, 2.9] {
            // The crank and the open assembly are on the same side.
            let (open, crossed) = if theta > 0.0 {
                (Crossing::Left, Crossing::Right)
            } else {
                (Crossing::Right, Crossing::Left)
            };
            let [_, coupler, rocker] = bar.poses(theta, open).unwrap();
            assert!(coupler.angle.abs() < 1e-14 && coupler.rate.abs() < 1e-14);
            assert!((rocker.angle - theta).abs() < 1e-14);
            assert!((rocker.rate - 1.0).abs() < 1e-13, "{}", rocker.rate);
            let (psi, ratio) = antiparallelogram(1.0, 0.4, theta);
            let [_, _, rocker] = bar.poses(theta, crossed).unwrap();
            assert!((rocker.angle - psi).abs() < 1e-14, "{theta}: {} {psi}", rocker.angle);
            assert!((rocker.rate - ratio).abs() < 1e-13 * ratio.abs(), "{theta}: {} {ratio}", rocker.rate);
        }
    }
}
