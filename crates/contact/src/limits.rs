//! The thresholds of this crate, each with its unit and its reason. Numbers without a unit are dimensionless.

use std::ops::RangeInclusive;

// Newton's method and bisection.

/// Most steps of an iteration for a root: Newton's converge in fewer than 10, and as many bisections reach the last bit
/// of any bracket within a factor of 2⁵³.
pub(crate) const MOST_ITERATIONS: usize = 60;
/// Relative change at which Newton's method has converged: two roundings.
pub(crate) const CONVERGED: f64 = 2.0 * f64::EPSILON;

// The exact laws.

/// The greatest dissipation number d v of which the motion is computed: the overflow at 1.8e308 is far
/// enough for the sums and products of the solution.
pub(crate) const GREATEST_DISSIPATION_NUMBER: f64 = 1e300;
/// The least dissipation number of which the motion is computed. Less damping is visible in 1 − e only (it is below ε),
/// and would give quotients 0/0 elsewhere.
pub(crate) const LEAST_DISSIPATION_NUMBER: f64 = 1e-17;
/// Below this h the slope of Langevin's function is taken from its series, whose next term, 2h⁴/189, is below 1e-17.
pub(crate) const LANGEVIN_SERIES: f64 = 1e-4;
/// Below this h Langevin's function is taken from 16 levels of its continued fraction, which reach 1e-17 there; above,
/// from coth h − 1/h, which loses less than one bit there.
pub(crate) const LANGEVIN_FRACTION: f64 = 3.0;
/// Below this 1 − 𝓛, h is 1/(1 − 𝓛): the next term is e^(−2h), 1e-43 at h = 50.
pub(crate) const LANGEVIN_ASYMPTOTE: f64 = 0.02;
/// Within this |ζ − 1| the slope of ζ C(ζ) is taken as its value at ζ = 1; it serves Newton's method only, which
/// corrects the relative error of 1e-5.
pub(crate) const CRITICAL_SLOPE: f64 = 1e-5;
/// Below this √|1−ζ²| over r + ζ, the arctangent is taken to the fifth order: the next term is 1e-24/7.
pub(crate) const SMALL_ANGLE: f64 = 1e-4;
/// Below this damping ratio the end of a contact, where the force vanishes, is so near the closed gap that the
/// integral over time is treated as singular there.
pub(crate) const LIGHT_DAMPING: f64 = 0.05;
/// Time constants of the slow return that are shown where the contact does not end: e⁻⁸ = 3e-4 of the penetration is
/// left.
pub(crate) const SLOW_RETURN: f64 = 8.0;
/// Samples of a force history: two ends at least, and 32 MB at most.
pub(crate) const SAMPLES: RangeInclusive<usize> = 2..=1_000_000;

// The quadrature of times.

/// Ends of the double-exponential rule's variable: at −6.1 the abscissa is 1e-304 of the span, near the least float; at
/// 3.25 the weight at the regular end is 1e-16.
pub(crate) const QUADRATURE_RANGE: [f64; 2] = [-6.0, 3.25];
/// Relative agreement of two halvings of the step; the rule doubles the digits with each, so that the second is better.
pub(crate) const QUADRATURE_AGREEMENT: f64 = 1e-13;

// Adams' IMPACT function, integrated numerically.

/// Error of one step, in penetration and speed that are both of order 1. The restitution is then right to
/// about 1e-9.
pub(crate) const STEP_TOLERANCE: f64 = 1e-12;
/// An error of a step below this does not enlarge the next step further (it is enlarged four times at most).
pub(crate) const LEAST_STEP_ERROR: f64 = 1e-30;
/// The first step, as a part of the ramp or of the undamped time, whichever is shorter.
pub(crate) const FIRST_STEP: f64 = 1e-3;
/// Steps after which a contact counts as endless; it bounds the computing time.
pub(crate) const MOST_STEPS: usize = 400_000;
/// The least 1 − e that is integrated; below, the loss is proportional to the damping to 1e-6.
pub(crate) const LEAST_LOSS: f64 = 1e-6;
/// The least restitution: below, the mass nearly comes to rest in the contact.
pub(crate) const LEAST_RESTITUTION: f64 = 1e-3;
/// The penetration, as a part of the undamped one, below which the gap counts as closed: the step's own tolerance.
pub(crate) const CLOSED_GAP: f64 = 1e-12;
/// Ratio of the search for the penetration at which the force is positive again.
pub(crate) const SEARCH_RATIO: f64 = 0.98;
/// The greatest dimensionless damping that is tried; a restitution that needs more counts as
/// unreachable.
pub(crate) const GREATEST_IMPACT_DAMPING: f64 = 1e8;
/// Depth of full damping over the undamped penetration: outside, the force is practically a jump, or
/// practically undamped.
pub(crate) const RAMPS: RangeInclusive<f64> = 1e-4..=1e4;
/// Tolerance of ln e in the search for a damping: ten step tolerances.
pub(crate) const RESTITUTION_TOLERANCE: f64 = 1e-11;
/// Width of the bracket, relative to the logarithm of the damping or 1, at which that search ends: a few roundings.
pub(crate) const BRACKET_TOLERANCE: f64 = 1e-15;
/// Most steps of that search; the Illinois method needs about ten.
pub(crate) const MOST_SEARCH_STEPS: usize = 200;

// Parameters of simulators.

/// How far a simulator's restitution may be from the one asked for, where nothing else is asked for.
pub(crate) const DEFAULT_ACCURACY: f64 = 1e-3;
/// Accuracies that may be asked for: below, the time steps become impracticably short; above, the error bounds, of first
/// order, do not hold.
pub(crate) const ACCURACIES: RangeInclusive<f64> = 1e-9..=0.1;
/// The greatest ωh of a recommended step: 31 steps in a half period, and the bounds of the error hold.
pub(crate) const LONGEST_STEP: f64 = 0.1;
/// The greatest 2ζωh, so that the damping stays well inside the stability limit 2 of an explicit step.
pub(crate) const STIFFEST_STEP: f64 = 0.1;
/// Error bound of the restitution stated for Adams: three times what a BDF integrator showed at the exported settings.
pub(crate) const ADAMS_ERROR: f64 = 3e-4;
/// Adams' greatest step (HMAX), in times that the approach takes for the ramp.
pub(crate) const ADAMS_STEP: f64 = 0.3;
/// Adams' ERROR, over the penetration that the spring alone would reach.
pub(crate) const ADAMS_TOLERANCE: f64 = 1e-3;
/// The depth of full damping over the penetration that the spring alone would reach, for Adams: a compromise between a
/// force that jumps (0) and a damper with little effect (1).
pub(crate) const ADAMS_RAMP: f64 = 0.1;
/// The accuracy setting of Drake's integrator, at most.
pub(crate) const DRAKE_ACCURACY: f64 = 1e-3;
/// Gazebo Classic's `max_vel` where no speed is given, m/s: above the speed of any impact.
pub(crate) const GAZEBO_FASTEST: f64 = 100.0;
/// `max_vel` over the approach speed: the spring pushes with up to ωx/(2ζ) of it, and must not be capped.
pub(crate) const GAZEBO_PUSH_RATIO: f64 = 10.0;
/// The least `max_vel`, m/s; the default 0.01 caps the spring.
pub(crate) const GAZEBO_SLOWEST_PUSH: f64 = 3.0;
/// DART's DART_BOUNCING_VELOCITY_THRESHOLD, m/s: contacts that would rebound with less do not.
pub(crate) const DART_SLOWEST_REBOUND: f64 = 0.1;
/// DART's DART_MAX_BOUNCING_VELOCITY, m/s.
pub(crate) const DART_FASTEST_REBOUND: f64 = 100.0;
/// What a bounce in DART loses, over 1 + e: its DART_CFM of 1e-5, and half as much for the turn of a lever in a step.
pub(crate) const DART_BOUNCE_ERROR: f64 = 1.5e-5;
/// Error of a bounce in Rapier: measured below 1e-9, ball and multibody; the rest is for other masses and levers.
pub(crate) const RAPIER_ERROR: f64 = 1e-6;
/// The greatest impedance that MuJoCo takes (mjMAXIMP); a wrong diagonal has the least effect with it.
pub(crate) const MUJOCO_IMPEDANCE: f64 = 0.9999;
/// Upper bound of the change of e for each v/ω of Simscape's transition width.
pub(crate) const SIMSCAPE_ERROR_PER_WIDTH: f64 = 0.16;
/// Simscape's relative tolerance over the accuracy: 1e-6 for the default.
pub(crate) const SIMSCAPE_TOLERANCE: f64 = 1e-3;
/// The greatest transition width, in units of v/ω, for which that bound holds.
pub(crate) const SIMSCAPE_WIDEST: f64 = 0.1;
/// The rebound, m/s, below which DART lets a contact not bounce (DART_BOUNCING_VELOCITY_THRESHOLD).
pub(crate) const DART_SLOWEST: f64 = 0.1;
/// The product of the restitutions up to which it does not either (DART_RESTITUTION_COEFF_THRESHOLD).
pub(crate) const DART_LEAST: f64 = 1.1e-3;
/// The fastest rebound, m/s (DART_MAX_BOUNCING_VELOCITY).
pub(crate) const DART_FASTEST: f64 = 100.0;
/// The speed, m/s, at which DART removes overlap (DART_MAX_ERV): what is left of a contact that does not bounce.
pub(crate) const DART_CORRECTION: f64 = 1e-3;
/// What DART's constraint force mixing (DART_CFM, 1e-5) takes from e for each 1 + e, and a tenth for rounding.
pub(crate) const DART_SOFTENING: f64 = 1.1e-5;
/// Greatest travel of a body in a recommended step of a rigid contact, m: at most 1e-3 rad on the measured lever of 0.4 m.
pub(crate) const RIGID_TRAVEL: f64 = 3e-4;
/// Greatest travel with a measured error, m: twice the recommended travel.
pub(crate) const RIGID_LONGEST_TRAVEL: f64 = 2.0001 * RIGID_TRAVEL;
/// Least number of Jolt's velocity steps: with the default 10 the error of a hinged body with a rotor is (1 + e)·8e-4, with 50 zero.
pub(crate) const JOLT_TURNS: f64 = 50.0;
/// Error that the velocity steps of a hinged body may leave: half of [`JOLT_ERROR`].
pub(crate) const JOLT_REST: f64 = JOLT_ERROR / 2.0;
/// Greatest number of velocity steps: sufficient for m̄ of 1,000 times the effective mass without the hinge; a larger number
/// needs seconds per impact.
pub(crate) const JOLT_MOST_TURNS: f64 = 10_000.0;
/// Relative difference of m̄ and the effective mass without joints that counts as equal: rounding of both.
pub(crate) const SAME_MASS: f64 = 1e-9;
/// Curvature of the motion of a mechanism without a model, 1/m: that of a lever of 0.2 m with the centre of mass at the contact.
pub(crate) const RIGID_CURVATURE: f64 = 10.0;
/// Least curvature of the motion of a mechanism, 1/m: rounding of second differences; the effect is below 1e-8 at the recommended travel.
pub(crate) const LEAST_CURVATURE: f64 = 1e-5;
/// Standard gravity, m/s², rounded.
pub(crate) const GRAVITY: f64 = 9.81;
/// Half of a unit in the last place of coordinates from 0.25 to 0.5 m in single precision, m.
pub(crate) const SINGLE_PLACE: f64 = 1.5e-8;
/// Jolt's velocity steps of closed loops: a four-bar (m̄ = 68.1 kg, open 2.5 kg) has converged; with 500 the error is 1e-3.
pub(crate) const JOLT_LOOP_TURNS: f64 = 1000.0;
/// Error bound of the restitution stated for Jolt: measured 3e-5 at the longest travel.
pub(crate) const JOLT_ERROR: f64 = 1e-4;
/// The accuracy setting of OpenSim's integrator at the default accuracy.
pub(crate) const OPENSIM_ACCURACY: f64 = 1e-5;
/// Error bound of the restitution stated for OpenSim, of the accuracy asked for: measured 0.02.
pub(crate) const OPENSIM_ERROR: f64 = 0.1;
/// The greatest ωh up to which Exudyn's error bound was measured: twice [`LONGEST_STEP`].
pub(crate) const EXUDYN_LONGEST_STEP: f64 = 2.0 * LONGEST_STEP;
/// Exudyn's iteration tolerance of contacts over k v h: a hundredth of a step's travel.
pub(crate) const EXUDYN_TOLERANCE: f64 = 0.01;
/// Its iterations of contacts, at most.
pub(crate) const EXUDYN_TURNS: f64 = 10.0;
/// The position iterations for which TGS's damping is exported: Isaac Lab's assets mostly have 4.
pub(crate) const TGS_POSITION_ITERATIONS: f64 = 4.0;
