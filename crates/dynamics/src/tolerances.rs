//! Every threshold and every budget of work of this crate, with its unit and its reason.

/// Largest magnitude of a number that is given: sums of products of three of them are still finite. Any unit.
pub const LARGEST_NUMBER: f64 = 1e100;
/// Difference of a quaternion's norm from 1 that is the rounding of its four components, dimensionless.
pub(crate) const UNIT_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// A quaternion that is given may be this far from unit norm, and is normalised: two decimals. Relative.
pub const QUATERNION_TOLERANCE: f64 = 0.01;
/// A rotation matrix that is given may depart so far from RᵀR = 1, and is made orthonormal: numbers of single precision, and
/// six decimals. Absolute.
pub const ROTATION_TOLERANCE: f64 = 1e-5;
/// Loops of a row of positions that is given as closed may be open by this part of their size: rows of single precision, and
/// seven decimals. It changes m̄ by about as much. Relative.
pub const OPEN_ROW: f64 = 1e-6;

/// Below this, |j restricted to ker A| / |j| is immovable: rounding of j and of ker A leaves 1e-13 at most on the
/// reference files. Relative.
pub(crate) const IMMOVABLE: f64 = 1e-10;
/// Below this relative closing speed, a finite answer comes with a warning: it has lost six digits. Relative.
pub(crate) const NEARLY_IMMOVABLE: f64 = 1e-6;
/// A motion without mass closes the gap where the contact's force along it exceeds this part of the terms that it is
/// the sum of: the same as for [`IMMOVABLE`]. Relative.
pub(crate) const MASSLESS_CLOSING: f64 = 1e-10;
/// Pivots of the recursion count as zero below this part of the terms that they are sums of: 256 roundings.
pub(crate) const PIVOT: f64 = 256.0 * f64::EPSILON;
/// The recursion's answer stands alone up to this relative error; beyond, the careful route is asked too.
pub(crate) const TRUSTED_ERROR: f64 = 1e-11;
/// Least mass of a free body on the other side, kg: its inverse is still a number, with room for sums.
pub(crate) const LEAST_OTHER_MASS: f64 = 1e-100;
/// Coordinates up to which the careful route is taken: it is dense, O(n³) in time and 8n² bytes a matrix.
pub(crate) const CAREFUL_LIMIT: usize = 1000;
/// Bytes that the matrices of all clusters of bodies may take in one run of the recursion: two runs stand side by side
/// where an error is stated, within 1.5 GB with the model itself. A loop of 1,800 free links.
pub(crate) const CLUSTER_BYTES: usize = 400 << 20;
/// Multiplications that these may take: half a minute.
pub(crate) const CLUSTER_WORK: f64 = 3e10;
/// Coordinates up to which the condition of the mass matrix is asked: O(n³).
pub(crate) const CONDITION_LIMIT: usize = 300;

/// Singular values of A below this part of the largest count as zero, where the file is exact: rounding leaves 1e-14.
pub(crate) const RANK_FLOOR: f64 = 1e-10;
/// The floor of a rank is at most this part of the largest singular value: that one always counts.
pub(crate) const MOST_FLOOR: f64 = 0.1;
/// A group of loops is refused that stands further from the root link than this many times its size: its positions are
/// known to 6e-6 of the size, and ranks would be decided at a thousandth of the largest singular value.
pub(crate) const FARTHEST: f64 = 2.8e10;
/// Singular values of A below this part of the largest are rounding alone: it leaves 1e-14.
pub(crate) const RANK_ROUNDING: f64 = 3e-13;
/// Both sides of the gap lie more than this factor from the threshold where the rank is clear.
pub(crate) const RANK_MARGIN: f64 = 30.0;
/// Pivots under complete pivoting above this part of the first are beyond doubt: singular values are within a factor of
/// the number of coordinates of them, in practice of ten.
pub(crate) const SURE_PIVOT: f64 = 1e-4;
/// Coordinates of a group up to which its rank is decided by singular values; of larger ones by sparse pivots.
pub(crate) const SINGULAR_VALUES_LIMIT: usize = 160;

/// Residual at which a loop counts as closed, as a part of the group's size: some thousand roundings.
pub(crate) const CLOSED: f64 = 1e-12;
/// Residuals below this part of the group's size pass as a file's rounding: three decimals.
pub(crate) const ROUNDING: f64 = 1e-3;
/// A rounded file's loops fit to within this many times their inexactness at poses other than where it was measured.
pub(crate) const ROUNDED: f64 = 10.0;
/// A pose around the first one, at which the generic rank is looked for, is as closed as a rounded file lets it be within
/// this many times the inexactness at the first.
pub(crate) const ELSEWHERE: f64 = 2.0;
/// Steps follow directions down to this many times the residual, as a part of the size: below, a direction owes its
/// singular value to the residual itself.
pub(crate) const FOLLOWED: f64 = 10.0;
/// Relative size of pivots that a least step takes for zero at least.
pub(crate) const STEP_RANK: f64 = 1e-9;
/// A step of Newton's method shorter than this part of the size changes nothing.
pub(crate) const SETTLED: f64 = 1e-8;
/// A loop that is open by more than this part of its size as drawn is a warning: no rounding, a mistyped point.
pub(crate) const DRAWN_OPEN: f64 = 0.01;

/// Where the least singular value of the loops' rows that counts is below this part of the largest, figures rounded to four
/// digits may leave one motion more. Relative.
pub(crate) const WEAKLY_CONSTRAINED: f64 = 1e-4;

// How the travel of a point is reached. Steps of the driving joint are in rad, or in parts of the size; rates are in
// sizes a unit of these.

/// A shorter vector has no direction. Any unit.
pub(crate) const SHORTEST_DIRECTION: f64 = 1e-9;
/// A contact's line that is shorter than this part of its length as drawn has no direction to go by: a millimetre aside turns
/// the line of a stop drawn 30 mm away by more than 18°.
pub(crate) const SHORTEST_LINE: f64 = 0.1;
/// Cosine of the angle that the line of a stop may turn by from the line as drawn: 5°, which changes m̄ by some per cent.
pub(crate) const LINE_TURNED: f64 = 0.996_194_698_091_745_5;
/// First step where the rate is not determined, or none: long against rounding, short against what a mechanism bends.
pub(crate) const FIRST_STEP: f64 = 1e-4;
/// Longest step: about 11°, where the tangent still leads to the same solution.
pub(crate) const LONGEST_STEP: f64 = 0.2;
/// Longest steps to a displacement: ranges of 12 rad.
pub(crate) const TRAVEL_STEPS: usize = 60;
/// Steps between two values of the driver that enclose what is looked for: halvings from the longest step to rounding.
pub(crate) const ENCLOSED_STEPS: usize = 60;
/// A displacement is met to this part of the size: the tolerance to which loops close.
pub(crate) const MET: f64 = 1e-12;
/// A miss beyond this part is not yet rounding: one step of the tangent more takes it away.
pub(crate) const POLISHED: f64 = 1e-14;
/// And this part is rounding of the pose, not a miss, where a point far from the joint moves fast.
pub(crate) const MET_TO_ROUNDING: f64 = 1e-9;
/// A joint that moves the point more slowly does not drive it: digits that files have lost would decide.
pub(crate) const UNMOVED: f64 = 1e-6;
/// A rate below this has no sign: loops closed to 1e-12 of the size leave so much of it.
pub(crate) const STATIONARY: f64 = 1e-11;
/// A rate that exceeds another by less than this part of it is the same rate: of joints alike, the first drives.
pub(crate) const SAME_RATE: f64 = 1e-9;
/// A joint drives weakly where the least pivot of the dependent coordinates' Jacobian is below this part of its generic
/// size: near its dead centre everything is fast, and it is at its end soon.
pub(crate) const WEAK_DRIVER: f64 = 1e-2;

// Bodies, and what is compiled.

/// The sine of an angle between axes below which they are parallel to rounding.
pub(crate) const NO_TURN: f64 = 2.0 * f64::EPSILON;
/// The sine of an angle between axes below which their common normal is too far away to be of use.
pub(crate) const PARALLEL_AXES: f64 = 0.05;
/// Distance between parallel axes below which it is rounding, relative to the distance of the points that they are given by.
pub(crate) const NO_ACROSS: f64 = 16.0 * f64::EPSILON;
/// The travels of slides, in lengths of the mechanism, that sizes are bounded with once for all; larger ones stretch them.
pub(crate) const SLIDE_REACH: f64 = 0.5;
/// How far the square of a quaternion may be from 1 by rounding; beyond, what it turns by is no rotation.
pub(crate) const UNIT_QUATERNION: f64 = 32.0 * f64::EPSILON;
/// Axes with a cosine below this with all joints at 0 were written to point opposite ways: within 8°.
pub(crate) const REVERSED_AXES: f64 = -0.99;
/// Independent coordinates of a cluster beyond which its blocks are formed from its mass matrix: O(n²) where sums over its
/// bodies take O(n d²).
pub(crate) const LARGE_CLUSTER: usize = 48;
/// A pivot of a joint with several velocities below this part of its terms is left for last.
pub(crate) const LATE_PIVOT: f64 = 1e-3;
/// A pivot below minus this part of its terms is no rounding: an indefinite inertia.
pub(crate) const NEGATIVE_PIVOT: f64 = 1e-9;
/// Rounding of G enters D squared.
pub(crate) const PIVOT_SQUARED: f64 = PIVOT * PIVOT;
/// In coordinates where M has unit diagonal, a direction whose root energy is below this carries no mass: a real one
/// has at least √ε = 1.5e-8, rounding leaves 1e-13.
pub(crate) const ROOT_ENERGY: f64 = 1e-10;
/// Forward dynamics count pivots as zero below this part of their terms: what should vanish keeps the rounding of all that was subtracted
/// before, up to 1e-12 where joints nearly line up.
pub(crate) const ACCELERATION_PIVOT: f64 = 1e-10;
/// How many roundings an entry of G has gone through, each of its terms' size.
pub(crate) const RATE_ROUNDINGS: f64 = 16.0;
/// A relative error of 1/m̄ beyond which the pivots that it stands on are rounding, and may be zero.
pub(crate) const NOTHING_LEFT: f64 = 1.0;
/// Roundings of a pivot and a test force, each of its terms' size, by which the recursion's own rounding is bounded before its
/// errors are counted: those of a sum of a few products, three times over; more where a pivot is smaller than its terms by a
/// larger factor.
pub(crate) const ROUTE_ROUNDINGS: f64 = 16.0;
/// Roundings of a pivot's largest term that the pivot and what it leaves are off by in lanes: those of the products and sums
/// of an elimination and of two turns and shifts.
pub(crate) const LOSS_ROUNDINGS: f64 = 4.0;
/// Ratio of a pivot's terms to the pivot above which the elimination amplifies the errors of the subtree, in lanes. Pivots of
/// common arms and long chains are below it, or amplify nothing.
pub(crate) const COMMON_LOSS: f64 = 64.0;
/// Relative error of a bound cluster's response from which on it is held to its stationary value: a tenth of what is trusted.
pub(crate) const VAGUE_RESPONSE: f64 = 1e-12;
/// A part of the mechanism's mass that does not matter.
pub(crate) const NEGLIGIBLE_MASS: f64 = 1e-9;
/// A relative change of m̄ by what leaves a pose open that is the same both ways.
pub(crate) const SAME_BOTH_WAYS: f64 = 1e-9;

// The error budget; the first four in roundings.

/// Roundings that a product of rotations adds to a frame's orientation; down a chain they add as a random walk.
pub(crate) const TURN_ROUNDINGS: f64 = 3.0;
/// Rounding of a joint's own sine, cosine and origin: alike at every link of a repetitive chain, it adds up.
pub(crate) const REPEATED_ROUNDINGS: f64 = 1.0;
/// Roundings of a sum of a few products: of an entry of an inertia, a wrench, a pivot.
pub(crate) const SUM_ROUNDINGS: f64 = 5.0;
/// Roundings of a row of A and its elimination, each of its terms' size.
pub(crate) const ROW_ROUNDINGS: f64 = 8.0;
/// How much of a misfit enters a row: several of a file's figures, each rounded by itself, of which the misfit shows a
/// part. Over 17,000 answers of linkages written with 4 to 12 decimals, 110 would do.
pub(crate) const FILE_MISFITS: f64 = 128.0;

// Matrices.

/// A pivot is at least this part of its row's largest entry.
pub(crate) const SPARSE_PIVOT: f64 = 0.1;
/// Rows with the fewest entries among which a pivot is looked for.
pub(crate) const SPARSE_CANDIDATES: usize = 4;
/// Least over largest pivot from which JᵀJ is formed instead of factorising J.
pub(crate) const WELL_CONDITIONED: f64 = 1e-4;
/// Entries of JJᵀ, counted with repetition, up to which it is formed: 100 MB.
pub(crate) const NORMAL_EQUATIONS_FILL: usize = 4_000_000;
/// Most sweeps of the one-sided Jacobi method: it converges in about ten.
pub(crate) const JACOBI_SWEEPS: usize = 40;
/// Rows or columns of a group up to which its matrices are dense; beyond, sparse ones take less time.
pub(crate) const DENSE_LIMIT: usize = 64;

// Mobility.

/// Dependent coordinates whose Jacobian's least pivot is below this part of its generic size stand at a dead centre.
pub(crate) const DEAD_CENTRE: f64 = 1e-6;
/// Where the least singular value that should count is below this part of the largest, a change point is near.
pub(crate) const NEAR_CHANGE_POINT: f64 = 1e-4;
/// Coordinates up to which a mode is named: of larger groups only that they are regular.
pub(crate) const MODE_LIMIT: usize = 160;
/// A coefficient below this part of the largest means that a row has no part in a dependency.
pub(crate) const FAINT_COEFFICIENT: f64 = 1e-7;
/// A column counts as independent of others where more than this part of the largest is left of it; the second, where
/// that leaves too few.
pub(crate) const INDEPENDENT_COLUMNS: [f64; 2] = [1e-6, 1e-10];
/// An axis of a rigid loop departs from the others where these fit one another to this part of its own departure.
pub(crate) const DEPARTING_AXIS: f64 = 0.1;
/// Coordinates up to which redundant rows are separated by loop.
pub(crate) const REDUNDANCY_LIMIT: usize = 400;

// Closing loops.

/// Residuals below this part of a group's size are rounding of the figures that a file is written with: 12 digits.
pub(crate) const CLOSED_AS_DRAWN: f64 = 1e-9;
/// Most iterations of a correction: Newton's method takes a handful, a damped one some tens.
pub(crate) const CORRECTION_ITERATIONS: usize = 60;
/// Most work of these iterations, in cubes of a group's coordinates: all of them up to 100 coordinates.
pub(crate) const CORRECTION_WORK: usize = 60_000_000;
/// Fewest iterations, however large the group is: those of Newton's method, some of them damped.
pub(crate) const FEWEST_CORRECTION_ITERATIONS: usize = 20;
/// A loop that fits is closed by a motion of at most this many times its residual as drawn; beyond, the motion follows a
/// direction that owes its weight to the residual itself.
pub(crate) const COMMENSURATE: f64 = 100.0;
/// A correction's Jacobian serves for the next one too where that, shrinking the residuals once more as the last did, leaves
/// no more than this part of the size: below rounding, as Newton's method would.
pub(crate) const KEPT_JACOBIAN: f64 = 1e-17;
/// Longest step along a branch, as a part of the characteristic length that no coordinate moves beyond.
pub(crate) const LONGEST_BRANCH_STEP: f64 = 0.15;
/// A shorter step than this part of the length is not worth going on with.
pub(crate) const SHORTEST_BRANCH_STEP: f64 = 1e-9;
/// Most steps: some thousand turns of a small group; of a large one fewer, which take as long.
pub(crate) const BRANCH_STEPS: usize = 100_000;
/// Fewest of these steps, however large the group is.
pub(crate) const FEWEST_BRANCH_STEPS: usize = 500;
/// The tangent turns by less than about 25° in a step.
pub(crate) const STRAIGHT: f64 = 0.9;
/// Largest change of the linearised curve, ‖X₀⁺(X − X₀)‖, from one point of a branch to the next: at 1 another branch may cross.
pub(crate) const CHART_DRIFT: f64 = 0.5;
/// The same of the followers' Jacobian alone, over the slope of the drivers, from which on it is not looked at more closely.
pub(crate) const BESIDE_DRIFT: f64 = 0.25;
/// Square of a step, as a part of the size, over the least singular value of X: terms of the second order of that change.
pub(crate) const TURNING_DRIFT: f64 = 0.5;
/// Power iterations for norms of these changes: a tenth of the norm suffices.
pub(crate) const DRIFT_ITERATIONS: usize = 4;
/// Least slope of the drivers in the middle of a step, as a part of that at its ends: 1 along a straight branch.
pub(crate) const LEAST_MIDDLE_SLOPE: f64 = 0.25;
/// Square of the least singular value at its minimum beside a point, relative: below, branches cross; branches that come within the
/// root of the closing tolerance of each other leave 0.01 or more.
pub(crate) const SAME_CROSSING: f64 = 1e-3;
/// Length of a step over a crossing, as a multiple of the distance at which branches are one crossing.
pub(crate) const LEAP_OVER: f64 = 1e3;
/// How many lengths of such a step are tried, each an eighth of the last.
pub(crate) const LEAP_LENGTHS: usize = 3;
/// Followers' Jacobians whose least pivot is below this part of its size at the generic pose are near-singular.
pub(crate) const NEARLY_SINGULAR: f64 = 1e-2;
/// Places on each side of a crossing from which a pose there is interpolated.
pub(crate) const CROSSING_PLACES: usize = 4;
/// Distance of the places on the curve, as a part of the characteristic length: η⁸/35 of the eighth derivative remains.
pub(crate) const CROSSING_STEP: f64 = 0.015;
/// Coordinates up to which the weakest direction is looked for.
pub(crate) const WEAKEST_DIRECTION_LIMIT: usize = 64;
/// Singular values below this part of the largest are rounding.
pub(crate) const FAINT_SINGULAR_VALUE: f64 = 1e-13;
/// Squares of singular values below this part of the largest are no longer told from rounding in JᵀJ.
pub(crate) const REGULAR_SQUARE: f64 = 1e-10;
/// Inverse iterations: each brings the weakest direction forward by the square of the ratio of singular values.
pub(crate) const INVERSE_ITERATIONS: usize = 3;
/// Most corrections that close a group again after it has advanced.
pub(crate) const ADVANCE_CORRECTIONS: usize = 8;

// Putting loops together.

/// A pose nearer to the first one than this part of the size is that pose again.
pub(crate) const SAME_POSE: f64 = 1e-5;
/// Seeded starts that are tried before a group is given up.
pub(crate) const FIRST_STARTS: u64 = 24;
/// Most work of these starts, in rows times the square of a group's coordinates: all of them up to 65 coordinates of three times as
/// many rows.
pub(crate) const FIRST_STARTS_WORK: u64 = 20_000_000;
/// Fewest starts, however large the group is: the drawn pose, with the declared drivers fixed and with all coordinates free.
pub(crate) const FEWEST_FIRST_STARTS: u64 = 2;
/// The sizes of these starts, rad or parts of the size.
pub(crate) const FIRST_STARTS_ASIDE: [f64; 6] = [0.01, 0.1, 0.3, 1.0, 3.0, 2.0];
/// Seeded poses around the first one at which the generic rank is looked for.
pub(crate) const GENERIC_POSES: u64 = 12;
/// How many of these poses are enough.
pub(crate) const GENERIC_POSES_ENOUGH: usize = 3;
/// Coordinates of a group beyond which fewer of these poses are tried: the rank of a large group shows at one pose.
pub(crate) const LARGE_GROUP: usize = 160;
/// Starts from which drivers are put at the positions asked for, when the branch does not reach there: a Cassie leg closes
/// from one in seven.
pub(crate) const MODE_STARTS: usize = 48;
/// Sizes of these starts' motion aside, rad or parts of the size.
pub(crate) const MODE_STARTS_ASIDE: [f64; 4] = [0.3, 1.0, 2.0, 3.0];
/// Most work of these starts, in cubes of a group's coordinates.
pub(crate) const MODE_STARTS_WORK: usize = 20_000_000;
/// A joint with several positions that was set stands there when it is no further off than this part of the size: its
/// values are given with eight decimals or fewer.
pub(crate) const MATCHED: f64 = 1e-6;
/// Most corrections of a step of the joints that were set: Newton's method takes a few where the loops let them.
pub(crate) const SET_CORRECTIONS: usize = 30;
/// The joints of a held mechanism stand so far (rad, or parts of the size) off zero at its generic pose.
pub(crate) const HELD_ASIDE: f64 = 0.2;

// Branches at a crossing, and the limits along them.

/// How far from the pose branches are looked for, as a part of the group's size.
pub(crate) const BRANCH_DISTANCE: f64 = 1e-3;
/// Directions tried where two motions are admissible.
pub(crate) const DIRECTIONS_IN_A_PLANE: usize = 96;
/// Fewest directions tried where more motions are admissible.
pub(crate) const FEWEST_DIRECTIONS: usize = 256;
/// Most of these directions.
pub(crate) const MOST_DIRECTIONS: usize = 2048;
/// Most corrections on the way to a branch.
pub(crate) const BRANCH_CORRECTIONS: usize = 40;
/// Branches between branches that make a cone.
pub(crate) const CONE_HALVINGS: usize = 4;
/// Work, in cubes of a group's coordinates, after which no more directions are tried: about a second.
pub(crate) const DIRECTIONS_WORK: usize = 2_500_000;
/// Tangents of curves that differ by less than this (rad) belong to one branch.
pub(crate) const SAME_TANGENT: f64 = 2e-3;
/// The same of tangent spaces of branches with more freedoms, which are known beside the crossing only. rad.
pub(crate) const SAME_TANGENT_SPACE: f64 = 0.02;
/// Singular values beside a crossing count from this part of the largest on.
pub(crate) const BESIDE_A_CROSSING: f64 = 1e-8;
/// How far apart are the places from which m̄ is carried on to the crossing, in parts of the groups' sizes; the next is
/// tried where the values vary too much.
pub(crate) const LIMIT_STEPS: [f64; 4] = [0.01, 2.5e-3, 6e-4, 1.5e-4];
/// Two orders of the interpolation that agree to this are good: the higher one is much better than that.
pub(crate) const LIMITS_AGREE: f64 = 1e-7;
/// Most combinations of branches of several groups that are looked at.
pub(crate) const BRANCH_COMBINATIONS: usize = 256;
/// A limit below this part of the values it is carried on from is zero.
pub(crate) const VANISHING_LIMIT: f64 = 1e-7;
/// A branch is too bent where the cosine between it and where it is at these places is less.
pub(crate) const BENT: f64 = 0.9;

/// Corrections that close a group again after a step aside are together at most this many times the step: of second order in
/// it, they are far shorter unless the branch is lost.
pub(crate) const MOST_CLOSING: f64 = 1.0;
/// Places from which a limit is carried on, at most: four on either side, at every distance.
pub(crate) const LIMIT_PLACES: usize = 8 * LIMIT_STEPS.len();
/// Work of the careful route at the places from which limits are carried on, in cubes of the coordinates; beyond, the recursion
/// is asked: two branches of a mechanism of 160 coordinates, some seconds.
pub(crate) const LIMITS_BY_CAREFUL_ROUTE: usize = 300_000_000;
/// Work of the recursion at these places, in bodies; fewer combinations are looked at where it would be more: 256 of a
/// mechanism of 1,000 bodies, some ten seconds.
pub(crate) const LIMITS_BY_RECURSION: usize = 10_000_000;
/// Work, in cubes of a group's coordinates, of looking for branches where two motions are admissible or fewer, and of the proof
/// that a pose is regular: every direction of a plane of 160 coordinates, or every motion of 64.
pub(crate) const DIRECTIONS_WORK_IN_ALL: usize = 400_000_000;
/// Most work of setting joints with several positions, in cubes of a group's coordinates; of a large group so many corrections
/// at least.
pub(crate) const SET_WORK: usize = 200_000_000;
pub(crate) const FEWEST_SET_CORRECTIONS: usize = 1_000;
/// Corrections that no longer come to this part of the one before are rounding, once they have settled.
pub(crate) const CORRECTIONS_SHRINK: f64 = 0.5;
/// Two orders of the interpolation that differ by more than this part leave no limit to speak of: it would have three digits,
/// where the places are as near as rounding lets them be.
pub(crate) const DOUBTFUL_LIMIT: f64 = 1e-3;
/// Bodies up to which the room of an answer is kept for the next: some hundred kilobytes.
pub(crate) const KEPT_BODIES: usize = 256;
/// Rooms kept at most: as many as threads ask at once.
pub(crate) const KEPT_ROOMS: usize = 64;
/// Coordinates and bodies up to which a linkage is compiled for its velocities.
pub(crate) const LINKAGE_COORDINATES: usize = 64;
/// Freedoms up to which it is: its energy is a full matrix over them.
pub(crate) const LINKAGE_FREEDOMS: usize = 8;
/// How much smaller than the largest a pivot may be at the pose that a linkage is compiled at: what is eliminated in the same
/// order elsewhere is to be far from singular.
pub(crate) const LINKAGE_PIVOT: f64 = 64.0;
/// Residual, as a part of the least size of a group, at which lanes need no further pass of Newton's method: rounding.
pub(crate) const CLOSED_IN_LANES: f64 = 4e-15;
/// Passes of Newton's method in lanes at most: from a prediction two or three do.
pub(crate) const CLOSING_PASSES: usize = 5;
/// How far what depends may go beyond its prediction, as a part of the step.
pub(crate) const SMALL_CORRECTION: f64 = 0.25;
/// Largest change of the followers' Jacobian, ‖A₀⁻¹(A − A₀)‖, over rows that are followed from one pose without another check: at 1 a
/// second branch may come near. The followers' rates change by a half at most.
pub(crate) const FOLLOWERS_DRIFT: f64 = 1.0 / 3.0;
/// How much longer a branch may be than its tangent over such rows: rates g grow to (g + 1/3)·3/2 at most.
pub(crate) const LONGEST_FOLLOWED: f64 = 2.0;
/// Step of the differences that give ‖A′‖, as a part of the size: leaves five digits.
pub(crate) const CURVATURE_STEP: f64 = 1e-5;
/// By how many times as much as its loops are open, over its least length, the rows of a linkage are taken to be off.
pub(crate) const OPEN_ROUNDINGS: f64 = 8.0;
/// Roundings of a place, over the length that counts there, by which an arm between two places is off.
pub(crate) const FAR_ROUNDINGS: f64 = 4.0;
/// How far positions may be from those of a pose, rad or lengths of the mechanism, for its pivots to serve: far below what
/// any singular value that counts as one can move them to.
pub(crate) const BESIDE: f64 = 1e-9;
/// Numbers up to which the clusters of a room that is kept may have: some hundred kilobytes.
pub(crate) const KEPT_NUMBERS: usize = 1 << 15;

// Maps of many contacts.

/// Contacts that are answered before they are looked at again: they stay in the cache.
pub(crate) const MAP_PORTION: usize = 512;
/// The stated relative error up to which Φ answers a contact; beyond, it is asked by itself: eight digits.
pub(crate) const MAP_TRUSTED_ERROR: f64 = 1e-8;
/// Roundings of the triangular factor and of a contact's own algebra: 6 columns of some rotations each, Higham 2002, §19.6
/// (cited from memory), times four.
pub(crate) const MAP_OWN_ROUNDINGS: f64 = 96.0;
/// By how much the errors of all contacts may exceed what those of some dozen need: these are a sample of directions and places.
/// Over some 60,000 contacts of random trees and linkages no answer was off by more than is stated with it.
pub(crate) const MAP_SAFETY: f64 = 16.0;
/// |R w| below this part of the largest there is may be rounding: a contact that nothing moves leaves 1e-15.
pub(crate) const MAP_STILL: f64 = 1e-13;
/// Eigenvalues of Φ (squares) below the first part of the largest are rounding; all others are to be above the second, for
/// [`MAP_STILL`] to stay below [`IMMOVABLE`].
pub(crate) const MAP_CLEAR_SPECTRUM: [f64; 2] = [1e-14, 1e-6];
/// A contact whose wrench a motion without mass answers by more than this part is massless beyond doubt.
pub(crate) const MAP_FREE_CLEAR: f64 = 1e-6;

// Matrices of the caller's.

/// Numbers beyond this are no input. Any unit.
pub(crate) const LARGEST_ENTRY: f64 = LARGEST_NUMBER;
/// Entries below this count as zero: products of two are still numbers. Any unit.
pub(crate) const LEAST_ENTRY: f64 = 1e-100;
/// Lengths of coordinates from 1 over this to this: products with entries are still numbers.
pub(crate) const LENGTH_LIMIT: f64 = 1e30;
/// How many times as much as one trial with entries off by their accuracy moves m̄ it may be off: signs that are worse.
pub(crate) const MOVED_SAFETY: f64 = 8.0;
/// Relative accuracy of entries above which errors beyond first order are looked for by several trials: half precision.
pub(crate) const FEW_DIGITS: f64 = 1e-6;
/// How many trials.
pub(crate) const FEW_DIGITS_TRIALS: usize = 8;
/// The greatest relative error that entries may be said to have: three decimals.
pub(crate) const MOST_ACCURACY: f64 = 1e-3;
/// Rows of A without an entry above this part of the largest entry that binds the same coordinates are rounding: terms of its
/// size that cancel, some tens of roundings.
pub(crate) const ROW_NOISE: f64 = 1e-14;
/// Singular values of A below this many times the accuracy of its entries count as zero.
pub(crate) const FLOOR_ACCURACY: f64 = 10.0;
/// M may differ from its transpose by this part of √(M_rr M_cc): two ways of summing it up differ by some 1e-13.
pub(crate) const SYMMETRIC: f64 = 1e-9;
/// The same in units of the accuracy of M's entries, where these are known to fewer digits: sums of a few products.
pub(crate) const SYMMETRIC_ROUNDINGS: f64 = 16.0;
/// An entry of M beyond this many times √(M_rr M_cc) is no rounding: a negative energy, or noise of a coordinate without mass.
pub(crate) const PAIR_BOUND: f64 = 1.0 + 1e-6;
/// The same excess over 1 in units of the accuracy of M's entries: that of the entry and of both diagonal entries, twice over.
pub(crate) const PAIR_ROUNDINGS: f64 = 4.0;
/// Noise of a coordinate without mass, in roundings of the largest mass: those of sums of a few products.
pub(crate) const MATRIX_NOISE: f64 = 16.0;
/// A negative eigenvalue of M scaled to unit diagonal beyond so many roundings (n of them, and the entries' accuracy) is a
/// negative energy: the same as for pivots of the careful route.
pub(crate) const NEGATIVE_MASS: f64 = 4e3;
