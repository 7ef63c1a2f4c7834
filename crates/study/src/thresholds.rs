//! All thresholds of this crate, with units and reasons.

use std::ops::RangeInclusive;

// Compliance.

/// Change of the impulse of an impact per product of contact stiffness and residual compliance: the slope for a soft contact on a mechanism with
/// bushes, from random systems. The rule gives 1 % at k = 1/(130 c_res) and 5 % at 1/(26 c_res).
pub(crate) const IMPULSE_CHANGE: f64 = 1.3;
/// The same for the peak force.
pub(crate) const FORCE_CHANGE: f64 = 1.2;
/// Speed at which the slope of a damper is taken, m/s: far below the first bend of a curve.
pub(crate) const DAMPER_SLOPE_SPEED: f64 = 1e-4;

/// Number of frequencies of a response: more than a figure shows.
pub(crate) const FREQUENCIES: RangeInclusive<usize> = 2..=20_000;

// Limits of queries.

/// Largest distance of a joint from its stop, rad or m, at which the joint counts as at the stop: a position given with six decimals.
pub(crate) const RESTING_DISTANCE: f64 = 1e-6;
/// Turns of a continuous joint above which a set number without a unit is taken for degrees. A second turn changes nothing.
pub(crate) const MOST_TURNS_SET: f64 = 1.0;
/// The same for the ends of a range, which may follow a path over more than a turn.
pub(crate) const MOST_TURNS_VARIED: f64 = 2.0;

/// Wheel travel (m) against the sense of a bump or rebound stop beyond which it touches the wrong way. A stop drawn in touch is
/// a fraction of a millimetre off.
pub(crate) const TOUCH_WRONG_WAY: f64 = 1e-3;
/// Largest wheel travel of a question, m: no vehicle has a longer one, and a number of millimetres is above.
pub(crate) const MAX_WHEEL_TRAVEL: f64 = 2.0;
/// Wheel travel (m) to the touch of a stop that few vehicles have: gaps in a wrong unit lead to more.
pub(crate) const FAR_TOUCH: f64 = 0.2;
/// Cosine of the angle between the direction of a stop and the motion of its pad (60°), below which a note names the angle: a rocker
/// may turn so, and so does a pad with a wrong direction.
pub(crate) const STOP_ALIGNMENT: f64 = 0.5;
/// Largest change (m) of a coordinate in a search: the size of a suspension.
pub(crate) const FARTHEST_COORDINATE: f64 = 2.0;
/// Length, in any unit, up to which a vector has no direction. A vector typed with a few digits is longer; the difference
/// of equal points is shorter.
pub(crate) const SHORTEST_DIRECTION: f64 = 1e-9;
/// Number of joints tried in place of a driver that reached its limit before the requested travel.
pub(crate) const OTHER_DRIVERS: usize = 4;
/// Largest number of consecutive drivers of a travel past their dead centres. One turn of a linkage passes some four dead
/// centres.
pub(crate) const TRAVEL_STAGES: usize = 6;
/// Part of the distance to a driver's dead centre after which another joint drives. Close to the dead centre digits are lost.
pub(crate) const DEAD_CENTRE_APPROACH: f64 = 0.98;
/// Least advance of a travel by a driver, in characteristic lengths. A smaller advance ends the search.
pub(crate) const LEAST_ADVANCE: f64 = 1e-4;
/// Least rate of a point per joint velocity for a driver, in characteristic lengths per radian, or per characteristic length
/// for a prismatic joint.
pub(crate) const LEAST_POINT_RATE: f64 = 1e-6;
/// Largest coordinate, m: sums of squares do not overflow.
pub(crate) const LARGEST_COORDINATE: f64 = 1e100;
/// Least mass of a free body on the other side, kg: sums of inverse masses do not overflow.
pub(crate) const LEAST_OTHER_MASS: f64 = 1e-100;
/// Number of rows of a sweep. The largest number is more than a plot shows, and takes some 20 minutes at 1 ms per row.
pub(crate) const ROWS: RangeInclusive<usize> = 1..=1_000_000;
/// Largest number of rows of a grid: some twenty minutes at 10 µs per row. Rows are not kept in memory.
pub(crate) const GRID_ROWS: usize = 100_000_000;
/// Largest study file, bytes; a variant takes some hundred bytes. The parser takes some hundred bytes of memory per value, and
/// a value may have two bytes of text.
pub(crate) const LARGEST_STUDY: u64 = 4 << 20;
/// Largest number of variants of a study: more than a table shows.
pub(crate) const MOST_VARIANTS: usize = 10_000;
/// Largest size of the copies of the query in all variants, bytes.
pub(crate) const LARGEST_VARIANTS: usize = 1 << 28;
/// Largest number of links in all variants together: some 900 MB.
pub(crate) const MOST_VARIANT_LINKS: usize = 1_000_000;
/// Longest line of a study that is shown with an error, bytes.
pub(crate) const LONGEST_LINE_SHOWN: usize = 400;
/// Largest number of rows in a block with poses: some milliseconds for a small linkage, and the poses fit in the caches.
pub(crate) const POSED_BLOCK_ROWS: usize = 256;
/// Largest number of links in a block with poses, rows times links of the mechanism: some 10 MB of poses.
pub(crate) const POSED_BLOCK_LINKS: usize = 10_000;
/// Largest number of rows in a block without poses: a millisecond for a small tree.
pub(crate) const BATCH_BLOCK_ROWS: usize = 4096;
/// Number of consecutive rows without poses per thread: 1/32 of a block, so that the wait for the last thread is short.
pub(crate) const BATCH_ROWS_PER_TASK: usize = 128;
/// Number of rows of the first block: few, so that the first results appear soon. Later blocks double in size.
pub(crate) const FIRST_BLOCK: usize = 8;
/// Number of consecutive rows with poses per thread.
pub(crate) const POSED_ROWS_PER_TASK: usize = 32;

/// Largest number of designs that a search for coordinates evaluates: some seconds.
pub(crate) const MOST_EVALUATIONS: usize = 400;
/// Intervals of a scan of the range of a coordinate, if Newton's method does not find the required value.
pub(crate) const SCANNED_COORDINATES: usize = 32;
/// Half of the step of differences by the coordinates of a hardpoint, m: the error of second order is some 1e-12, rounding
/// 1e-15/1e-6 = 1e-9 of the derivative.
pub(crate) const DIFFERENCE_OF_POINTS: f64 = 1e-6;
/// Rounding of a closing speed, relative to the largest rate times the largest entry of the contact row.
pub(crate) const SPEED_ROUNDING: f64 = 1e-13;
/// Displacement of a coordinate that shows its influence on the required values, relative to its range.
pub(crate) const SMALL_PART: f64 = 1e-3;
/// Largest factor of a search on the forces of a curve and on a damping; the least is its inverse.
pub(crate) const LARGEST_FACTOR: f64 = 4.0;
/// Least change of a required value by this displacement, in scales of the quantity: rounding is some 1e-10.
pub(crate) const SMALLEST_INFLUENCE: f64 = 1e-8;
/// Steps of a search that are shorter (m) do not change the coordinate.
pub(crate) const SMALLEST_SEARCH_STEP: f64 = 1e-13;
/// Largest difference from a required value, in scales of the quantity: 1e-11 m, 1e-11 rad, 1e-10 of a ratio.
pub(crate) const TARGET_ACCURACY: f64 = 1e-8;
/// Tolerance of a travel if several travels drive a pose, in characteristic lengths. A single travel is met to 1e-12.
pub(crate) const TRAVEL_TOLERANCE: f64 = 1e-11;
/// Largest difference of positions (rad or m) after the way to a stop and back, if both are on one branch: the square root of
/// the tolerance of travels, for a pose near a minimum of the gap.
pub(crate) const SAME_START: f64 = 1e-6;
/// Halvings of the gap in the search for the nearest pose to a stop that is not reached: six digits.
pub(crate) const NEAREST_HALVINGS: usize = 20;
/// Least part of the way in one step of this search: each halving starts at the nearest pose known.
pub(crate) const LEAST_PART_OF_HALVING: f64 = 0.1;
/// Part of the gap above which a halving that fails in such steps is tried again, and the least part then.
pub(crate) const LONG_HALVING: f64 = 0.125;
pub(crate) const LEAST_PART_OF_LONG_HALVING: f64 = 0.01;
/// Accuracy of the smallest gap of a stop that is not reached, m.
pub(crate) const NEAREST_ACCURACY: f64 = 1e-9;
/// Largest gradient of the difference of two gaps, m per unit of the drivers, at a pose at which both are stationary. Roundings are some
/// 1e-15, regular poses above 1e-4.
pub(crate) const STATIONARY_GAPS: f64 = 1e-9;
/// First, longest and shortest step along the path to the smallest gap, rad or characteristic lengths. The first step is short because
/// only some 1e-3 of the path remains after the halvings of the gap.
pub(crate) const FIRST_APPROACH_STEP: f64 = 1e-4;
pub(crate) const LONGEST_APPROACH_STEP: f64 = 0.05;
pub(crate) const LEAST_APPROACH_STEP: f64 = 1e-8;
/// Largest number of these steps: some ten steps of growing length for each of five drivers, one revolution in the longest steps, and
/// the interpolations.
pub(crate) const APPROACH_STEPS: usize = 200;
/// Largest number of Newton steps back to this path.
pub(crate) const APPROACH_ROUNDS: usize = 8;
/// Least cosine of the angle between the tangents before and after a step.
pub(crate) const LEAST_TANGENT_COSINE: f64 = 0.95;
/// Relative error of m̄ up to which a contact of a map has no finding of its own: below that of a nearly immovable contact, 2ε/10⁻⁶.
pub(crate) const PLAIN_CONTACT_ERROR: f64 = 1e-10;
/// Largest number of contacts of a map that are examined for findings: a tenth of a second.
pub(crate) const EXAMINED_CONTACTS: usize = 2000;
/// Penetration, m, from which a stop counts as passed by a travel: half of the last digit of the message.
pub(crate) const PASSED_STOP: f64 = 5e-5;
/// Largest gap at which a stop touches, in characteristic lengths: the tolerance of several travels, with a margin.
pub(crate) const TOUCH_TOLERANCE: f64 = 1e-10;
/// Largest number of Newton steps for several travels: from a near pose some five steps are needed.
pub(crate) const TRAVEL_ROUNDS: usize = 12;
/// Largest ratio of the distances from the targets after and before a step of Newton's method.
pub(crate) const LARGEST_RETREAT: f64 = 2.0;
/// Longest step of a driver in Newton's method for several travels, rad or characteristic lengths. The first part of a travel of
/// 0.1 m turns an arm of 0.1 m by 0.25 rad.
pub(crate) const LONGEST_DRIVER_STEP: f64 = 1.0;
/// Growth of the rate of a joint along the way of several travels at which the end of the way is called its dead centre. The
/// rate grows with the inverse square root of the remaining way.
pub(crate) const DEAD_CENTRE_GROWTH: f64 = 4.0;
/// Number of parts in which several travels are first divided.
pub(crate) const TRAVEL_PARTS: f64 = 4.0;
/// Least part of several travels in one step: a travel of 0.1 m in steps of 0.1 mm.
pub(crate) const LEAST_PART: f64 = 1e-3;
/// Largest number of halvings of a travel that is too long for one step: 2⁻³² of a turn is negligible.
pub(crate) const HALVINGS: usize = 32;

/// Number of samples of a tolerance. The largest number takes a minute at 1 ms per sample on a few processors; one sample
/// gives no spread.
pub(crate) const SAMPLES: RangeInclusive<usize> = 2..=100_000;
/// Step of a hardpoint for four-point differences, in characteristic lengths. The truncation error grows with the fourth
/// power of the step, 1e-16 relative; m̄ is accurate to some 1e-12, which gives 1e-8 for the derivative.
pub(crate) const POINT_STEP: f64 = 1e-4;
/// Step of a hardpoint for differences of designs near a pose, in characteristic lengths, at which rounding is some 1e-15/3e-7.
pub(crate) const NEARBY_STEP: f64 = 3e-7;
/// Truncation of these differences, relative, for parts of a five-hundredth of this length: (3e-7 · 500)²/6.
pub(crate) const NEARBY_TRUNCATION: f64 = 4e-9;
/// Rounding of m̄ of such a design, relative.
pub(crate) const NEARBY_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Largest relative change of m̄ over two such steps, and of its slope over one: for the same parts 3e-4 and 2e-8. An exchanged direction
/// changes some part by about 1.
pub(crate) const LARGEST_NEARBY_CHANGE: f64 = 1e-2;
pub(crate) const NEARBY_CURVATURE: f64 = 1e-6;
/// Number of changes of each kind listed in an explanation.
pub(crate) const LISTED_CHANGES: usize = 3;
/// Tolerance of |product − 1| for a motion ratio and its inverse in a mechanism with one travel. Loop closure and rounding
/// cause some 1e-11.
pub(crate) const INVERSE_RATIO_TOLERANCE: f64 = 1e-9;

// Findings about results.

/// Ratio of the changed mass of a link to its former mass, and to the mass of all other links, that causes a warning: the
/// number is probably in grams.
pub(crate) const MAX_MASS_RATIO: f64 = 50.0;
/// Least number of turning joints of a robot arm, whose drives usually have rotors with gears.
pub(crate) const ROBOT_JOINTS: usize = 4;
/// Travel that is too long for a mechanism in metres, m: an unreached travel gets a hint about its unit.
pub(crate) const LONG_TRAVEL: f64 = 1.0;

/// Distance of a contact point from the origin of its link, relative to the reach of the link, that causes a finding. Parts
/// attached to a link protrude by at most the size of the link.
pub(crate) const FAR_POINT: f64 = 3.0;
/// Least plausible distance of a contact point, relative to the reach of the link. If a far distance divided by 1000 is
/// plausible, the unit may be millimetres.
pub(crate) const NEAR_POINT: f64 = 0.01;
/// Relative difference up to which limits of m̄ along branches count as equal: their errors are at most some 1e-7.
pub(crate) const SAME_LIMIT: f64 = 1e-6;
/// Distance of an assembly from its guess that causes a finding: rad, or characteristic lengths. Assembly modes are farther
/// apart; a guess from a drawing is closer.
pub(crate) const FAR_FROM_GUESS: f64 = 0.5;
/// Velocity per unit closing speed above which a held point lifts off: far above the rounding of unit velocities.
pub(crate) const LIFT_OFF_SPEED: f64 = 1e-9;
/// Step of the central difference for dm̄/dδ, in characteristic lengths: the cube root of the rounding unit, at which
/// truncation and rounding errors are equal.
pub(crate) const DIFFERENCE: f64 = 1e-5;
/// Depths to which m̄ is followed for an impact with the varying mass, relative to the penetration of the constant mass.
pub(crate) const STROKES: [f64; 3] = [1.05, 1.3, 2.0];
/// Depth to which m̄ is followed if the motion ends before that, relative to the depth at the end: at a dead centre m̄ has no limit.
pub(crate) const BEFORE_END: f64 = 0.98;
/// Largest step over the penetration, relative to the depth.
pub(crate) const LARGEST_PENETRATION: f64 = 1.0 / 16.0;
/// First step of the motion over the penetration, relative to the penetration.
pub(crate) const FIRST_PENETRATION: f64 = 0.5;
/// Ratio of the next step to the last accepted step.
pub(crate) const PENETRATION_GROWTH: f64 = 1.25;
/// Largest relative difference of m̄ between one step and two half steps: after some hundred steps four digits are accurate.
pub(crate) const PENETRATION_MASS: f64 = 1e-6;
/// Largest distance between the contact points after one step and after two half steps, relative to the step: depths are
/// accurate to four digits.
pub(crate) const PENETRATION_MOTION: f64 = 1e-5;
/// Least step, relative to the penetration. Near a dead centre accepted steps are a hundredth of the remaining motion, and the
/// end is found to a few ten-thousandths after some thousand steps.
pub(crate) const LEAST_PENETRATION: f64 = 1e-6;
/// Difference from the wanted restitution at which the search for the damping ends: above the error of the integration, below every shown digit.
pub(crate) const REACHED_RESTITUTION: f64 = 1e-9;
/// Greatest loss factor of this search: 0.999·2/π, the restitution 0.02 on the spring alone.
pub(crate) const LARGEST_LOSS_FACTOR: f64 = 0.636;
/// Greatest number of impacts of each part of this search.
pub(crate) const STEPS_TO_REACH: usize = 60;
/// Change of the restitution by springs during the contact above which there is a warning: the second digit.
pub(crate) const SPRING_EFFECT: f64 = 0.01;
/// Relative change of m̄ over the penetration that causes a warning: restitutions are measured to some per cent.
pub(crate) const WARNED_MASS_DRIFT: f64 = 0.01;
/// Step of the second difference of a motion, m: rounding of positions of 1 m gives 2e-6/m, closed loops 1e-2/m.
pub(crate) const CURVATURE_STEP: f64 = 1e-5;

// Searches for rows out of reach.

/// Number of searches from one start that end short before farther rows count as unreachable. The first search finds the end
/// of a travel to a few per cent, and each further search is closer.
pub(crate) const SEARCHES_BEFORE_EXCLUSION: usize = 16;
/// Largest number of consecutive rows without a result if each row has its own start: some ten seconds for a small linkage.
pub(crate) const MOST_UNREACHED_ROWS: usize = 10_000;
/// Distance (relative; absolute for values below 1) up to which a value may equal the end of a range within rounding.
pub(crate) const RANGE_END_TOLERANCE: f64 = 1e-9;

// Maps.

/// Default number of facet edges across a link: visible in a picture of 400 pixels.
pub(crate) const EDGES_ACROSS: f64 = 60.0;
/// Largest number of facets of a map: 2 GB.
pub(crate) const FACETS: usize = 8_000_000;
/// Largest size of all meshes that `check` reads, bytes: seconds.
pub(crate) const CHECKED_MESHES: u64 = 64 << 20;
/// Shortest valid edge, m.
pub(crate) const LEAST_EDGE: f64 = 1e-6;
/// Number of directions at a point.
pub(crate) const DIRECTIONS: std::ops::RangeInclusive<usize> = 1..=1_000_000;

/// Relative difference between a given closing speed and that of given rates, up to which both agree: numbers typed
/// with six digits.
pub(crate) const SAME_SPEED: f64 = 1e-5;

/// Excess of the reached restitution over 1 from which a warning is given: larger than the error of the integration.
pub(crate) const CREATED_RESTITUTION: f64 = 1e-6;

/// Largest number of iterations for the closing speed of a given peak force: the first iteration is exact if F ∝ v^(2p/(p+1)).
pub(crate) const SPEED_ITERATIONS: usize = 20;

/// Relative change of the closing speed below which the iteration has converged: rounding.
pub(crate) const CONVERGED_SPEED: f64 = 1e-13;
/// Relative difference up to which values of two designs are equal: the rounding of conversions between units.
pub(crate) const EQUAL_VALUES: f64 = 1e-12;
/// Largest ratio of the smallest to the largest principal moment of a slender rod: zero, plus the rounding of rotated moments.
pub(crate) const SLENDER_ROD: f64 = 1e-9;

/// Approach speed of an exported impact without a given speed, m/s: at usual stiffnesses the mass changes little over the
/// penetration.
pub const SLOW_IMPACT: f64 = 0.01;
/// Radius of the sphere of an exported contact over the size of the mechanism: visible, and small against the links.
pub const IMPACT_RADIUS: f64 = 0.01;
/// Least radius of that sphere over the greatest penetration: the centre remains outside the other geom.
pub const LEAST_RADIUS_OVER_PENETRATION: f64 = 4.0;
/// Smallest number that MuJoCo does not take as zero, `mjMINVAL`, 1/kg.
pub(crate) const MUJOCO_MINVAL: f64 = 1e-15;
/// Shift of the restitution of an exported impact, relative to the permitted error, up to which the time step is not shortened. The bound
/// of the error of a time step contains a margin of 10 % of the largest measured error.
pub(crate) const NEGLIGIBLE_SHIFT: f64 = 0.01;
/// Distance of the other limit of a joint with an exported stop and without another limit, rad or m: more than any motion of the impact.
pub(crate) const FAR_LIMIT: f64 = 10.0;
/// Relative uncertainty of the shift of the restitution of an exported impact, because the error of the time step is bounded for a constant
/// mass only. MuJoCo 4.0.0 differs by 3 % of a shift of 0.035.
pub(crate) const SHIFT_UNCERTAINTY: f64 = 0.05;
/// Least error of the time step of an exported impact, relative to the permitted error: at most ten times
/// as many steps.
pub(crate) const LEAST_ACCURACY: f64 = 0.1;

/// Positions of the pads of stops on the rod of a damper in a drawing, as fractions of its length from the contact point. At these
/// positions the symbols of spring and damper do not hide the pads.
pub(crate) const BUMP_PAD: f64 = 0.55;
pub(crate) const REBOUND_PAD: f64 = 0.4;

/// Rate of a joint in the motion of an impact, relative to the largest rate, that is rounding of zero: a limit of this rate has no effect.
pub const UNCHANGED_RATE: f64 = 1e-12;

/// Relative difference of coefficients of friction up to which a given one suffices: rounding of the impulses of redundant contacts.
pub const SAME_FRICTION: f64 = 1e-6;
/// Relative difference of the limit of soft contacts from the rigid mass above which the residual stiffness judges nothing: the finest statement of
/// the verdict is 1 %.
pub(crate) const SAME_MASS: f64 = 1e-2;

/// Eigenvalue of a mass matrix, or square of that of constraint rows, relative to the largest, up to which it is rounding.
pub const MASSLESS_PART: f64 = 1e-12;
