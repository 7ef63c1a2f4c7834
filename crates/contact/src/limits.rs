//! Thresholds of this crate, each with its unit and its reason. Numbers without a unit are dimensionless.

use std::ops::RangeInclusive;

// Newton's method and bisection.

/// Most steps of an iteration for a root: Newton's converge in fewer than 10, and as many bisections reach the last bit
/// of any bracket within a factor of 2⁵³.
pub(crate) const MAX_ITERATIONS: usize = 60;
/// Relative change at which Newton's method has converged: two roundings.
pub(crate) const CONVERGED: f64 = 2.0 * f64::EPSILON;

// The exact laws.

/// Largest dissipation number d v for which the motion is computed; sums and products of the solution stay below the
/// overflow at 1.8e308.
pub(crate) const MAX_DISSIPATION_NUMBER: f64 = 1e300;
/// Smallest dissipation number for which the motion is computed. Smaller damping affects only 1 − e, which is below
/// ε, and gives quotients 0/0 elsewhere.
pub(crate) const MIN_DISSIPATION_NUMBER: f64 = 1e-17;
/// Largest h for the series of the slope of Langevin's function: the next term, 2h⁴/189, is below 1e-17.
pub(crate) const LANGEVIN_SERIES: f64 = 1e-4;
/// Largest h for 16 levels of the continued fraction of Langevin's function, with an error of 1e-17; for larger h,
/// coth h − 1/h loses less than one bit.
pub(crate) const LANGEVIN_FRACTION: f64 = 3.0;
/// Largest 1 − 𝓛 for the approximation h = 1/(1 − 𝓛): the next term is e^(−2h), 1e-43 at h = 50.
pub(crate) const LANGEVIN_ASYMPTOTE: f64 = 0.02;
/// Largest |ζ − 1| for which the slope of ζ C(ζ) at ζ = 1 is used. Only Newton's method uses the slope, and corrects
/// the relative error of 1e-5.
pub(crate) const CRITICAL_SLOPE: f64 = 1e-5;
/// Largest ratio √|1−ζ²|/(r + ζ) for the series of the arctangent to fifth order: the next term is 1e-24/7.
pub(crate) const SMALL_ANGLE: f64 = 1e-4;
/// Damping ratio below which the integral over time is treated as singular at the end of the contact: when the force
/// vanishes, the gap is almost closed.
pub(crate) const LIGHT_DAMPING: f64 = 0.05;
/// Angle before the largest penetration on a force curve below which the time rate is that of a constant force: its relative error is of the
/// order of the angle, on as small a part of the duration.
pub(crate) const TURNING_ANGLE: f64 = 1e-7;
/// Length of the history of a contact that does not end, in time constants of the slow return: e⁻⁸ = 3e-4 of the
/// penetration remains.
pub(crate) const SLOW_RETURN: f64 = 8.0;
/// Number of samples of a force history: at least the two ends, at most 32 MB.
pub(crate) const SAMPLES: RangeInclusive<usize> = 2..=1_000_000;

// The quadrature of times.

/// Range of the variable of the double-exponential rule: at −6.1 the abscissa is 1e-304 of the span, near the
/// smallest float; at 3.25 the weight at the regular end is 1e-16.
pub(crate) const QUADRATURE_RANGE: [f64; 2] = [-6.0, 3.25];
/// Relative difference of two successive halvings of the step. Each halving doubles the number of correct digits, so
/// the last result is better than this value.
pub(crate) const QUADRATURE_AGREEMENT: f64 = 1e-13;

// Adams' IMPACT function, integrated numerically.

/// Error of one step, for a penetration and a speed of order 1. The error of the restitution is then about 1e-9.
pub(crate) const STEP_TOLERANCE: f64 = 1e-12;
/// Error of a step at which the next step has the largest increase, a factor of four.
pub(crate) const MIN_STEP_ERROR: f64 = 1e-30;
/// First step, relative to the shorter of the ramp and the undamped time.
pub(crate) const FIRST_STEP: f64 = 1e-3;
/// Number of steps after which a contact counts as endless; bounds the computing time.
pub(crate) const MAX_STEPS: usize = 400_000;
/// Smallest 1 − e that is integrated; a smaller loss is proportional to the damping within 1e-6.
pub(crate) const MIN_LOSS: f64 = 1e-6;
/// Smallest restitution: for smaller values the mass almost comes to rest in the contact.
pub(crate) const MIN_RESTITUTION: f64 = 1e-3;
/// Penetration, relative to the undamped penetration, below which the gap counts as closed: the tolerance of the steps.
pub(crate) const CLOSED_GAP: f64 = 1e-12;
/// Ratio of the search for the penetration at which the force is positive again.
pub(crate) const SEARCH_RATIO: f64 = 0.98;
/// Largest dimensionless damping in the search; a restitution that needs more damping counts as unreachable.
pub(crate) const MAX_IMPACT_DAMPING: f64 = 1e8;
/// Range of the depth of full damping relative to the undamped penetration: below, the force is practically a jump;
/// above, practically undamped.
pub(crate) const RAMPS: RangeInclusive<f64> = 1e-4..=1e4;
/// Tolerance of ln e in the search for a damping: ten step tolerances.
pub(crate) const RESTITUTION_TOLERANCE: f64 = 1e-11;
/// Width of the bracket, relative to the logarithm of the damping or 1, at which the search for a damping ends: a few
/// roundings.
pub(crate) const BRACKET_TOLERANCE: f64 = 1e-15;
/// Largest number of steps of the search for a damping; the Illinois method needs about ten.
pub(crate) const MAX_SEARCH_STEPS: usize = 200;

// Parameters of simulators.

/// Default of the permitted error of a simulator's restitution.
pub(crate) const DEFAULT_ACCURACY: f64 = 1e-3;
/// Range of the requested accuracy: smaller values need impractically short time steps; for larger values, the
/// first-order error bounds do not hold.
pub(crate) const ACCURACIES: RangeInclusive<f64> = 1e-9..=0.1;
/// Largest ωh of a recommended step: 31 steps in a half period, and the error bounds hold.
pub(crate) const LONGEST_STEP: f64 = 0.1;
/// Largest 2ζωh: well below the stability limit 2 of an explicit step.
pub(crate) const STIFFEST_STEP: f64 = 0.1;
/// Error bound of the restitution stated for Adams: three times the error of a BDF integrator at the exported settings.
pub(crate) const ADAMS_ERROR: f64 = 3e-4;
/// Longest step of Adams (HMAX), relative to the time in which the approach passes the ramp.
pub(crate) const ADAMS_STEP: f64 = 0.3;
/// ERROR of Adams, relative to the undamped penetration.
pub(crate) const ADAMS_TOLERANCE: f64 = 1e-3;
/// Steps of a sum of powers in the code of a tool, joined by lines: the force is right to (p − 1) p/8 of their square, 1e-4.
pub(crate) const POINTS_OF_POWERS: u32 = 64;
/// Depth of full damping for Adams, relative to the undamped penetration: a compromise between a force that jumps (0)
/// and a damper with little effect (1).
pub(crate) const ADAMS_RAMP: f64 = 0.1;
/// Largest accuracy setting of Drake's integrator.
pub(crate) const DRAKE_ACCURACY: f64 = 1e-3;
/// Default `max_vel` of Gazebo Classic without a given speed, m/s: above the speed of any impact.
pub(crate) const GAZEBO_FASTEST: f64 = 100.0;
/// `max_vel` relative to the approach speed: the spring separates with up to ωx/(2ζ) of the approach speed, which
/// must not be limited.
pub(crate) const GAZEBO_PUSH_RATIO: f64 = 10.0;
/// Smallest `max_vel`, m/s; the default 0.01 limits the spring.
pub(crate) const GAZEBO_SLOWEST_PUSH: f64 = 3.0;
/// DART_BOUNCING_VELOCITY_THRESHOLD, m/s: there is no rebound below this speed.
pub(crate) const DART_SLOWEST_REBOUND: f64 = 0.1;
/// DART_MAX_BOUNCING_VELOCITY, m/s: the largest rebound speed.
pub(crate) const DART_FASTEST_REBOUND: f64 = 100.0;
/// Loss of restitution in DART, divided by 1 + e: DART_CFM, 1e-5, and half as much for the rotation of a lever in a
/// step.
pub(crate) const DART_BOUNCE_ERROR: f64 = 1.5e-5;
/// Error of the restitution in Rapier: measured below 1e-9 for ball and multibody; the rest is a margin for other
/// masses and levers.
pub(crate) const RAPIER_ERROR: f64 = 1e-6;
/// Largest impedance of MuJoCo (mjMAXIMP), with the smallest effect of a wrong diagonal.
pub(crate) const MUJOCO_IMPEDANCE: f64 = 0.9999;
/// Upper bound of the change of e for each v/ω of Simscape's transition width.
pub(crate) const SIMSCAPE_ERROR_PER_WIDTH: f64 = 0.16;
/// Simscape's relative tolerance over the accuracy: 1e-6 for the default.
pub(crate) const SIMSCAPE_TOLERANCE: f64 = 1e-3;
/// Largest transition width, in units of v/ω, for which this upper bound holds.
pub(crate) const SIMSCAPE_WIDEST: f64 = 0.1;
/// Rebound speed, m/s, below which DART suppresses the rebound (DART_BOUNCING_VELOCITY_THRESHOLD).
pub(crate) const DART_SLOWEST: f64 = 0.1;
/// Product of the restitutions up to which DART suppresses the rebound (DART_RESTITUTION_COEFF_THRESHOLD).
pub(crate) const DART_LEAST: f64 = 1.1e-3;
/// Largest rebound speed, m/s (DART_MAX_BOUNCING_VELOCITY).
pub(crate) const DART_FASTEST: f64 = 100.0;
/// Speed, m/s, at which DART removes overlap (DART_MAX_ERV): the remaining speed of a contact without rebound.
pub(crate) const DART_CORRECTION: f64 = 1e-3;
/// Loss of e per 1 + e by DART's constraint force mixing (DART_CFM, 1e-5), plus a tenth for rounding.
pub(crate) const DART_SOFTENING: f64 = 1.1e-5;
/// Greatest travel of a body in a recommended step of a rigid contact, m: at most 1e-3 rad on the measured lever of
/// 0.4 m.
pub(crate) const RIGID_TRAVEL: f64 = 3e-4;
/// Greatest travel with a measured error, m: twice the recommended travel.
pub(crate) const RIGID_LONGEST_TRAVEL: f64 = 2.0001 * RIGID_TRAVEL;
/// Least number of Jolt's velocity steps: with the default 10 the error of a hinged body with a rotor is (1 +
/// e)·8e-4, with 50 zero.
pub(crate) const JOLT_VELOCITY_STEPS: f64 = 50.0;
/// Error that the velocity steps of a hinged body may leave: half of [`JOLT_ERROR`].
pub(crate) const JOLT_CONVERGENCE: f64 = JOLT_ERROR / 2.0;
/// Greatest number of velocity steps: sufficient for m̄ of 1,000 times the effective mass without the hinge; a larger
/// number needs seconds per impact.
pub(crate) const JOLT_MAX_VELOCITY_STEPS: f64 = 10_000.0;
/// Relative difference of m̄ and the effective mass without joints that counts as equal: rounding of both.
pub(crate) const SAME_MASS: f64 = 1e-9;
/// Curvature of the motion of a mechanism without a model, 1/m: that of a lever of 0.2 m with the centre of mass at
/// the contact.
pub(crate) const RIGID_CURVATURE: f64 = 10.0;
/// Least curvature of the motion of a mechanism, 1/m: rounding of second differences; the effect is below 1e-8 at the
/// recommended travel.
pub(crate) const MIN_CURVATURE: f64 = 1e-5;
/// Standard gravity, m/s², rounded.
pub(crate) const GRAVITY: f64 = 9.81;
/// Half of a unit in the last place of coordinates from 0.25 to 0.5 m in single precision, m.
pub(crate) const SINGLE_PRECISION_ROUNDING: f64 = 1.5e-8;
/// Jolt's velocity steps of closed loops: a four-bar (m̄ = 68.1 kg, open 2.5 kg) has converged; with 500 the error is
/// 1e-3.
pub(crate) const JOLT_LOOP_VELOCITY_STEPS: f64 = 1000.0;
/// Error bound of the restitution stated for Jolt: measured 3e-5 at the longest travel.
pub(crate) const JOLT_ERROR: f64 = 1e-4;
/// Accuracy setting of OpenSim's integrator at the default accuracy.
pub(crate) const OPENSIM_ACCURACY: f64 = 1e-5;
/// Error bound of the restitution stated for OpenSim, relative to the requested accuracy: measured 0.02.
pub(crate) const OPENSIM_ERROR: f64 = 0.1;
/// Largest ωh for which Exudyn's error bound was measured: twice [`LONGEST_STEP`].
pub(crate) const EXUDYN_LONGEST_STEP: f64 = 2.0 * LONGEST_STEP;
/// Iteration tolerance of contacts in Exudyn, relative to k v h: a hundredth of the travel in a step.
pub(crate) const EXUDYN_TOLERANCE: f64 = 0.01;
/// Largest number of iterations of contacts in Exudyn.
pub(crate) const EXUDYN_MAX_ITERATIONS: f64 = 10.0;
/// Number of position iterations for the exported damping of TGS: most assets of Isaac Lab have 4.
pub(crate) const TGS_POSITION_ITERATIONS: f64 = 4.0;
