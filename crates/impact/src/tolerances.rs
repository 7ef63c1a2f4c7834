//! Numerical thresholds of this crate.

/// Sensitivity to the open multipliers, relative to a unit multiplier, above which a component of a reaction is
/// indeterminate. Sensitivities of determinate components are rounding: about 1e-15 for exact files.
pub const OPEN_COMPONENT: f64 = 1e-9;

/// Factor by which the accuracy of the constraint rows, divided by the smallest relative singular value, is multiplied
/// to give the same threshold for rounded files. The null space of the rows has errors of this size.
pub const OPEN_PER_FLOOR: f64 = 30.0;

/// Upper limit of the threshold: above it a component of order 1 would count as determinate.
pub const MOST_OPEN: f64 = 1e-2;

/// Part of an open combination of multipliers, relative to the largest part, above which the combination involves a
/// constraint. Parts of uninvolved constraints are rounding.
pub const INVOLVED: f64 = 1e-6;

/// Ratio of the pivots of the driver rows to the largest, above which a freedom is determined by the given rates.
pub const DETERMINED: f64 = 1e-9;

/// Part of the displacement rate of a joint, in a motion of unit displacement rates, that earlier driving joints do not determine, above which
/// the joint can drive. At a smaller part the joint is near its dead centre.
pub const DRIVES: f64 = 1e-6;

/// Residual of given rates, relative to the largest displacement rate, above which they are inadmissible. Values
/// typed with six digits are accepted.
pub const INADMISSIBLE: f64 = 1e-5;

/// Change of a joint's reaction over the characteristic length, relative to the reaction, below which the contact
/// point has no influence.
pub const NO_INFLUENCE: f64 = 1e-12;

/// Energy of an admissible motion, relative to the largest of a motion of the same displacement, below which the
/// motion is massless.
pub const MASSLESS_ENERGY: f64 = 1e-13;

/// Displacement of a joint in a massless motion of unit displacement, above which its rate is undetermined.
pub const UNDETERMINED: f64 = 1e-6;

/// Distance of the mobility matrix from rank one, relative to its norm, up to which a contact has one relative motion:
/// rounding of matrices of linkages, and the misfit of files with nine digits.
pub const ONE_MOTION: f64 = 1e-8;

/// Sliding speed of a contact point, relative to its speed, that counts as zero: rounding of linkages, and the misfit of files with nine
/// digits. The direction of a smaller speed is arbitrary, but friction would have its full size.
pub const NO_SLIDING: f64 = 1e-9;

/// Eigenvalue of a mobility matrix, relative to the largest, below which a contact point cannot move in a direction:
/// rounding of W.
pub const MASSLESS_RESPONSE: f64 = 1e-12;

/// Speed of a contact, relative to that of the other contacts at the same energy, up to which the contact counts as immovable: rounding of
/// the contact rows. The mobility has the square of this ratio.
pub const UNMOVED: f64 = 1e-10;

/// Component of a speed, relative to the summed terms of the coordinates, that is rounding.
pub const SPEED_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Change of the normal velocity per normal impulse, relative to that without friction, up to which the impulse does not change the
/// velocity: rounding of the Schur complement of a sticking contact, and of the difference of a sliding one.
pub const WEDGED: f64 = 1e-12;

/// Coupling out of a plane, relative to the norm of the mobility matrix, up to which a frictional impact is planar.
pub const PLANAR: f64 = 1e-13;

/// Error of one integration step, relative to the closing speed.
pub const STEP_ERROR: f64 = 1e-14;

/// Sliding speed, relative to the closing speed, at which the sliding ends in the integration. The remaining part is
/// linear to this order.
pub const SLIDING_ENDS: f64 = 1e-14;

/// Largest number of integration steps of one impact.
pub const MOST_STEPS: usize = 20_000;

/// Violation of a complementarity condition, relative to the largest speed or impulse, that is rounding.
pub const COMPLEMENTARY: f64 = 1e-10;

/// Pivot of M, relative to its diagonal entry, above which M is clearly regular: its factorisation keeps ten digits.
pub const REGULAR_MASS: f64 = 1e-6;

/// Pivots of a mobility of contacts with a unit diagonal: above the first a direction can clearly move, up to the second it is rounding.
pub const CLEAR_PIVOT: f64 = 1e-6;

/// See [`CLEAR_PIVOT`].
pub const ROUNDING_PIVOT: f64 = 1e-12;

/// Largest number of simultaneous contacts: all subsets of contacts are examined.
pub const MOST_CONTACTS: usize = 12;

/// Largest number of integration steps of the energetic law of several contacts: contacts with small e close some hundred times.
pub const MOST_ENERGETIC_STEPS: usize = 200_000;

/// Ratio of the natural frequencies of two contacts above which it is stated as the reason for too many steps of the energetic law.
pub const DIFFERENT_FREQUENCIES: f64 = 100.0;

/// Smallest coefficient of restitution above 0 of the energetic law of several contacts: the expansion is shorter by this factor.
pub const LEAST_ENERGETIC: f64 = 0.01;

/// Energy created by a law of restitution, relative to the energy of the closing motion, that is rounding.
pub const CREATED_ENERGY: f64 = 1e-10;

/// Relative difference between µ times the normal impulse and the impulse of the friction up to which the sliding direction counts as
/// constant. It corresponds to a turn of about 1e-4 rad.
pub const SAME_DIRECTION: f64 = 1e-9;

/// Ratio of the closing speed of the admissible motions to the closing speed of free joints up to which no motion closes the gap: rounding.
pub const CLOSES: f64 = 1e-10;

/// Relative size up to which a projected gradient, a rate or a multiplier of a limit counts as zero in the search for the reachable speed.
pub const ACTIVE_RATE: f64 = 1e-9;

/// Largest number of steps of the search for the reachable speed, one active set each: far more than a mechanism requires.
pub const MOST_VERTICES: usize = 10_000;

/// Change of a joint position over a range, rad or m, up to which the joint counts as unmoved: loops are closed to about 1e-12.
pub const UNMOVED_JOINT: f64 = 1e-9;

/// Bisections of the interval of the best constant armature: the remaining interval is rounding.
pub const ARMATURE_STEPS: u32 = 120;

/// Error of one step of an impact in time, relative to the penetration and the largest rate.
pub const TIME_STEP_ERROR: f64 = 1e-12;

/// Largest step of an impact in time, relative to stopping depth / closing speed: about 50 samples of the force. The error of a step of
/// order 10 is then 0.007 · 0.0625¹¹; the error of a Runge-Kutta step of order 8 is far below 0.0625⁹.
pub const LARGEST_TIME_STEP: f64 = 0.0625;

/// Largest number of steps of an impact in time: about 80 times the duration of an elastic impact.
pub const MOST_TIME_STEPS: usize = 4_000;

/// Speeds over the closing speed below which a contact is without rebound: the first ends the integration, the second applies at its last step,
/// for a slow return.
pub const NO_REBOUND: [f64; 2] = [1e-3, 1e-2];

/// Steps in a row with these speeds: longer than a half oscillation, in which the speed passes through zero.
pub const STEPS_WITHOUT_REBOUND: usize = 64;

/// Distance from a point of the force curve, over the penetration without damping, within which the integration is at the point: its location
/// has an error of [`CONTACT_ENDS`].
pub const CORNER_DISTANCE: f64 = 1e-12;
/// Part of the largest sample of a force above which a maximum of the samples is refined: samples have two digits.
pub const NEAR_PEAK: f64 = 0.98;
/// Largest number of refined maxima of one force.
pub const MOST_PEAKS: usize = 8;
/// Force in a bearing over that of the contact, up to which its maxima are rounding.
pub const NO_FORCE: f64 = 1e-9;
/// Width, relative to the distance of the samples, at which the search of the largest force ends: a corner of a damper curve then has an error of 1e-9 of
/// the force.
pub const PEAK_WIDTH: f64 = 1e-9;
/// Ratio of the golden section.
pub const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Distance from the end of the contact, relative to the step and the penetration, at which the end is found: rounding.
pub const CONTACT_ENDS: f64 = 1e-14;

/// Largest number of iterations for the end of the contact.
pub const END_ITERATIONS: usize = 60;

/// Largest number of doublings or halvings of the stopping depth from 1 m: beyond any size of a mechanism.
pub const MOST_DOUBLINGS: usize = 600;

/// Intervals of the work of the contact force; only a scale follows from it.
pub const WORK_INTERVALS: u32 = 64;

/// Number of angles at which a trigonometric polynomial of degree 2, with at most four extremes, is compared.
pub const CIRCLE_ANGLES: u32 = 64;

/// Newton iterations from the best angle: each squares the error, from about 0.1 rad to rounding.
pub const CIRCLE_ITERATIONS: usize = 8;

/// Step h of a difference quotient, relative to the range of a position. The truncation of the formula with four points, h⁴/30 times the
/// fifth derivative, is then similar to the rounding ε/h.
pub const DIFFERENCE_STEP: f64 = 1e-3;

/// Pulling impulse of a contact, and tangential impulse, relative to the largest impulse, that are rounding: the errors of impulses of
/// redundant contacts are about 1e-10.
pub const PULLING: f64 = 1e-8;

/// Coefficient of friction above which a contact cannot stick: its normal impulse is rounding of zero, far above any material.
pub const MOST_FRICTION: f64 = 1e4;

/// Largest impulse that redundant contacts exchange, relative to the determinate impulses.
pub const OPEN_IMPULSES: f64 = 1e3;

/// Accuracy of open impulses at the least coefficient of friction, relative to the determinate impulses.
pub const OPEN_PER_IMPULSE: f64 = 1e-10;
