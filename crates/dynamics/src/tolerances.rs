//! All thresholds and work limits of this crate, with units and reasons.

pub(crate) use percuss_kernel::tolerances::{
    CLOSED, DRIFT_ITERATIONS, LONGEST_BRANCH_STEP, ROUTE_ROUNDINGS, STRAIGHT,
};

/// Largest magnitude of an input number. Sums of products of three such numbers are still finite. Any unit.
pub const LARGEST_NUMBER: f64 = 1e100;
/// Deviation of a quaternion's norm from 1 by rounding of its four components, dimensionless.
pub(crate) const UNIT_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Largest accepted deviation of a given quaternion from unit norm, before normalisation: two decimals. Relative.
pub const QUATERNION_TOLERANCE: f64 = 0.01;
/// Largest accepted deviation of a given rotation matrix from RᵀR = 1, before orthonormalisation: numbers in single
/// precision, or with six decimals. Absolute.
pub const ROTATION_TOLERANCE: f64 = 1e-5;
/// Largest accepted gap of the loops at given positions, relative to their size: positions in single precision, or
/// with seven decimals. The gap changes m̄ by about the same fraction.
pub const OPEN_ROW: f64 = 1e-6;
/// Largest gap at which a contact touches, in characteristic lengths: positions in single precision, or with seven decimals.
pub(crate) const OPEN_GAP: f64 = 1e-6;

/// Relative closing speed |j restricted to ker A| / |j| below which a contact is immovable. Rounding of j and of ker
/// A leaves at most 1e-13 on the reference files.
pub(crate) const IMMOVABLE: f64 = 1e-10;
/// Relative closing speed below which a finite result has a warning, after a loss of six digits.
pub(crate) const NEARLY_IMMOVABLE: f64 = 1e-6;
/// Threshold for a massless motion to close the gap: the contact force along the motion relative to its summed terms.
/// Equal to [`IMMOVABLE`].
pub(crate) const MASSLESS_CLOSING: f64 = 1e-10;
/// Part of its terms above which the coupling U of a frozen motion, or the test wrench along it, is resolved: four roundings.
/// Coincident axes leave one or two.
pub(crate) const RESOLVED: f64 = 4.0 * f64::EPSILON;
/// Largest relative change of 1/m̄ by a frozen motion that is stated as estimated; a larger one puts all of m̄ in doubt.
pub(crate) const SMALL_CHANGE: f64 = 1e-11;
/// Pivots of the recursion below this fraction of their summed terms count as zero: 256 roundings.
pub(crate) const PIVOT: f64 = 256.0 * f64::EPSILON;
/// Largest relative error of a result of the recursion alone; beyond this limit the dense route also runs.
pub(crate) const TRUSTED_ERROR: f64 = 1e-11;
/// Relative error of m̄ that causes a warning: engineers compare about six digits, and rounded files are about as accurate.
pub(crate) const WARNED_RELATIVE_ERROR: f64 = 1e-6;
/// Largest relative difference of m̄ between the kernel of derivatives and the batch. Both round each sum of the recursion once; a
/// larger difference means that one of them has lost digits: as large as [`LANES_TRUSTED_ERROR`](percuss_kernel::tolerances::LANES_TRUSTED_ERROR).
pub(crate) const DERIVATIVE_AGREEMENT: f64 = 1e-9;
/// Largest ratio of the summed terms of a pivot to the pivot in the kernel of derivatives: of 16 digits, 5 are lost. Arms of robots
/// reach some hundreds, with links in line some thousands.
pub(crate) const LARGEST_DERIVATIVE_LOSS: f64 = 1e5;
/// Smallest mass of a free body on the other side, kg. Its inverse, and sums of such inverses, do not overflow.
pub(crate) const LEAST_OTHER_MASS: f64 = 1e-100;
/// Largest number of coordinates for the dense route: O(n³) time, and 8n² bytes per matrix.
pub(crate) const DENSE_ROUTE_LIMIT: usize = 1000;
/// Largest number of coordinates of a mechanism with free bushes: its decompositions cost O(n³).
pub(crate) const COMPLIANT_COORDINATES: usize = 600;
/// Threshold for singular values of constraint rows in multiples of the inexactness of the loops per length: angles of redundant rows
/// deviate by some of it.
pub(crate) const INEXACT_RANK_FACTOR: f64 = 100.0;
/// Largest such threshold; independent rows of linkages have singular values of at least some thousandths.
pub(crate) const LARGEST_RANK_FLOOR: f64 = 1e-4;
/// Eigenvalues of the mass matrix below this fraction of the largest count as zero; rounding leaves some 1e-16, and a rotor of 1e-6 kg·m²
/// beside 1000 kg is 1e-9.
pub(crate) const NO_INERTIA: f64 = 1e-12;
/// Relative error of the matrices of a mechanism with bushes: the roundings of two products with an orthonormal basis.
pub(crate) const REDUCED_ACCURACY: f64 = 100.0 * f64::EPSILON;
/// Frequencies below this fraction of the highest belong to motions without stiffness. The elastic energy of such a motion is the square of
/// rounding, 1e-15 of the highest frequency; 1 Hz beside 100 kHz is 1e-5.
pub(crate) const RIGID_MODE: f64 = 1e-9;
/// Displacement between two forces whose difference gives a geometric stiffness, relative to the size of the mechanism. The error of the fourth
/// order and that of rounding are both near 1e-12 of the force per size.
pub(crate) const DIFFERENCE_OF_FORCES: f64 = 1e-3;
/// Part of the forces at a pose, relative to their size, that no bush carries and that counts as rounding of the balance.
pub(crate) const IN_BALANCE: f64 = 1e-7;
/// Speed of an elastic row along the rigid motion, relative to the product of their sizes, below which the row does not resist the motion.
pub(crate) const CLEAR_OF_RIGID_MOTION: f64 = 1e-9;
/// Largest memory, in bytes, of the matrices of all clusters in one run of the recursion. An error estimate needs two
/// runs at the same time, which together with the model stay within 1.5 GB. Sufficient for a loop of 1,800 free
/// links.
pub(crate) const CLUSTER_BYTES: usize = 400 << 20;
/// Largest number of multiplications for these matrices: half a minute.
pub(crate) const CLUSTER_WORK: f64 = 3e10;
/// Largest number of coordinates for the condition number of the mass matrix, which costs O(n³).
pub(crate) const CONDITION_LIMIT: usize = 300;

/// Threshold for singular values of A relative to the largest, for an exact file; smaller values count as zero.
/// Rounding leaves 1e-14.
pub(crate) const RANK_FLOOR: f64 = 1e-10;
/// Largest rank threshold relative to the largest singular value, which therefore always counts as nonzero.
pub(crate) const MOST_FLOOR: f64 = 0.1;
/// Largest distance of a group of loops from the root link, relative to the size of the group. At this distance
/// positions are accurate to 6e-6 of the size, and ranks would be decided at a thousandth of the largest singular
/// value.
pub(crate) const FARTHEST: f64 = 2.8e10;
/// Singular values of A below this fraction of the largest are only rounding, which leaves 1e-14.
pub(crate) const RANK_ROUNDING: f64 = 3e-13;
/// Smallest factor between the threshold and both sides of the gap, for a clear rank.
pub(crate) const RANK_MARGIN: f64 = 30.0;
/// Pivots of complete pivoting above this fraction of the first are certainly nonzero. Singular values differ from
/// pivots by at most the number of coordinates, in practice by a factor of ten.
pub(crate) const SURE_PIVOT: f64 = 1e-4;
/// Largest number of coordinates of a group for a rank decision by singular values; larger groups use sparse pivots.
pub(crate) const SINGULAR_VALUES_LIMIT: usize = 160;

/// Largest residual, relative to the group's size, that is accepted as rounding of a file: three decimals.
pub(crate) const ROUNDING: f64 = 1e-3;
/// Largest residual, relative to the group's size, of a pose in which the file draws the group closed: a file that is
/// rounded more is drawn open.
pub(crate) const DRAWN_CLOSED: f64 = 10.0 * ROUNDING;
/// Largest misfit of a rounded file's loops at other poses, as a multiple of the measured inexactness.
pub(crate) const ROUNDED: f64 = 10.0;
/// Largest residual of a pose near the first one in the search for the generic rank, as a multiple of the inexactness
/// at the first pose.
pub(crate) const OTHER_POSE_RESIDUAL: f64 = 2.0;
/// Smallest singular value of directions used by a step, as a multiple of the relative residual. A smaller singular
/// value may be caused by the residual itself.
pub(crate) const FIRM_DIRECTION: f64 = 10.0;
/// Smallest relative zero threshold for pivots in least-norm steps.
pub(crate) const STEP_RANK: f64 = 1e-9;
/// Largest Newton step, relative to the size, at a converged pose.
pub(crate) const CONVERGED_STEP: f64 = 1e-8;
/// Gap of a loop as drawn, relative to its size, above which a warning is given: not rounding, but a mistyped point.
pub(crate) const DRAWN_OPEN: f64 = 0.01;

/// Smallest nonzero singular value of the loops' rows, relative to the largest, below which the mechanism is weakly
/// constrained: figures rounded to four digits may free one more motion.
pub(crate) const WEAKLY_CONSTRAINED: f64 = 1e-4;

// Travel of a point. Steps of the driving joint are in rad or relative to the size; rates are in sizes per unit of
// these steps.

/// Shortest vector with a defined direction. Any unit.
pub(crate) const SHORTEST_DIRECTION: f64 = 1e-9;
/// Shortest line of a contact relative to its length as drawn. At this limit, a lateral displacement of one
/// millimetre turns the line of a stop drawn with a length of 30 mm by more than 18°.
pub(crate) const SHORTEST_LINE: f64 = 0.1;
/// Cosine of the largest accepted rotation of a stop's line from its direction as drawn: 5°, which changes m̄ by some
/// per cent.
pub(crate) const LINE_TURNED: f64 = 0.996_194_698_091_745_5;
/// First step at an undetermined or zero rate: long compared with rounding, short compared with the curvature of the
/// motion.
pub(crate) const FIRST_STEP: f64 = 1e-4;
/// Longest step: about 11°, for which the tangent still leads to the same solution.
pub(crate) const LONGEST_STEP: f64 = 0.2;
/// Largest number of longest steps to a displacement: a range of 12 rad.
pub(crate) const TRAVEL_STEPS: usize = 60;
/// Largest number of steps within a bracket: bisections from the longest step down to rounding.
pub(crate) const ENCLOSED_STEPS: usize = 60;
/// Accuracy of a displacement relative to the size: equal to the closing tolerance of loops.
pub(crate) const DISPLACEMENT_ACCURACY: f64 = 1e-12;
/// Error of a displacement, relative to the size, above which one more Newton step is taken.
pub(crate) const POLISHED: f64 = 1e-14;
/// Error of a displacement, relative to the size, that is accepted as rounding of the pose, if the point is far from
/// the joint and moves fast.
pub(crate) const MET_TO_ROUNDING: f64 = 1e-9;
/// Smallest rate of a driving joint. Below this rate, digits lost in the file would decide.
pub(crate) const UNMOVED: f64 = 1e-6;
/// Smallest rate with a determined sign. Loops closed to 1e-12 of the size cause this uncertainty.
pub(crate) const STATIONARY: f64 = 1e-11;
/// Relative difference below which two rates are equal; of joints with equal rates, the first drives.
pub(crate) const SAME_RATE: f64 = 1e-9;
/// Smallest pivot of the dependent coordinates' Jacobian, relative to its generic size, below which a joint drives
/// weakly: close to its dead centre, where the other velocities are large and the limit is near.
pub(crate) const WEAK_DRIVER: f64 = 1e-2;

// Bodies and compiled models.

/// Cosine between two axes with all joints at 0, below which the axes are opposite: within 8°.
pub(crate) const REVERSED_AXES: f64 = -0.99;
/// Number of independent coordinates of a cluster above which its blocks are formed from its mass matrix: O(n²),
/// whereas sums over its bodies cost O(n d²).
pub(crate) const LARGE_CLUSTER: usize = 48;
/// A pivot of a joint with several velocities below this fraction of its terms is eliminated last.
pub(crate) const LATE_PIVOT: f64 = 1e-3;
/// A pivot below minus this fraction of its terms is not rounding: the inertia is indefinite.
pub(crate) const NEGATIVE_PIVOT: f64 = 1e-9;
/// Zero threshold for squared quantities: the rounding of G enters D squared.
pub(crate) const PIVOT_SQUARED: f64 = PIVOT * PIVOT;
/// Root energy below which a direction is massless, in coordinates with unit diagonal of M. A direction with mass has
/// at least √ε = 1.5e-8; rounding leaves 1e-13.
pub(crate) const ROOT_ENERGY: f64 = 1e-10;
/// Zero threshold for pivots of forward dynamics relative to their terms. A vanishing pivot retains the rounding of
/// all subtracted terms, up to 1e-12 for nearly aligned joints.
pub(crate) const ACCELERATION_PIVOT: f64 = 1e-10;
/// Roundings of an entry of G, relative to its terms.
pub(crate) const RATE_ROUNDINGS: f64 = 16.0;
/// Relative error of 1/m̄ above which its pivots are only rounding, and may be zero.
pub(crate) const NOTHING_LEFT: f64 = 1.0;
/// Relative error of the response of a cluster with constraints above which the stationary value is used: a tenth of
/// the accepted error.
pub(crate) const VAGUE_RESPONSE: f64 = 1e-12;
/// Negligible fraction of the mechanism's mass.
pub(crate) const NEGLIGIBLE_MASS: f64 = 1e-9;
/// Relative change of m̄ below which the changes in both directions of the closing uncertainty are equal.
pub(crate) const SAME_BOTH_WAYS: f64 = 1e-9;

// Error budget. The first four values are in roundings.

/// Roundings that a product of rotations adds to the orientation of a frame; along a chain they add as a random walk.
pub(crate) const TURN_ROUNDINGS: f64 = 3.0;
/// Rounding of a joint's own sine, cosine and origin: equal at every link of a repetitive chain, and therefore added
/// linearly.
pub(crate) const REPEATED_ROUNDINGS: f64 = 1.0;
/// Roundings of a sum of a few products: an entry of an inertia, a wrench, or a pivot.
pub(crate) const SUM_ROUNDINGS: f64 = 5.0;
/// Roundings of a row of A and its elimination, relative to its terms.
pub(crate) const ROW_ROUNDINGS: f64 = 8.0;
/// Factor from misfit to row error. A row depends on several separately rounded figures, and the misfit shows only a
/// part of their errors. For 17,000 results of linkages written with 4 to 12 decimals, 110 is sufficient.
pub(crate) const FILE_MISFITS: f64 = 128.0;

// Matrices.

/// Smallest accepted pivot relative to its row's largest entry.
pub(crate) const SPARSE_PIVOT: f64 = 0.1;
/// Number of rows with the fewest entries in the search for a pivot.
pub(crate) const SPARSE_CANDIDATES: usize = 4;
/// Smallest ratio of pivots for which JᵀJ is formed instead of a factorisation of J.
pub(crate) const WELL_CONDITIONED: f64 = 1e-4;
/// Largest number of entries of JJᵀ, counted with repetition: 100 MB.
pub(crate) const NORMAL_EQUATIONS_FILL: usize = 4_000_000;
/// Largest number of sweeps of the one-sided Jacobi method, which converges in about ten.
pub(crate) const JACOBI_SWEEPS: usize = 40;
/// Largest number of rows or columns of a group for dense matrices; larger groups are faster with sparse matrices.
pub(crate) const DENSE_LIMIT: usize = 64;

// Mobility.

/// Smallest pivot of the dependent coordinates' Jacobian, relative to its generic size, below which a pose is at a
/// dead centre.
pub(crate) const DEAD_CENTRE: f64 = 1e-6;
/// Singular value at the generic rank, relative to the largest, below which a change point is near.
pub(crate) const NEAR_CHANGE_POINT: f64 = 1e-4;
/// Largest number of coordinates for a signed assembly mode; for larger groups only singularity is reported.
pub(crate) const MODE_LIMIT: usize = 160;
/// Coefficient, relative to the largest, below which a row does not take part in a dependency.
pub(crate) const FAINT_COEFFICIENT: f64 = 1e-7;
/// Smallest remainder of an independent column, relative to the largest column. The second value is used if the first
/// gives too few columns.
pub(crate) const INDEPENDENT_COLUMNS: [f64; 2] = [1e-6, 1e-10];
/// Deviation of the other axes, relative to the deviation of one axis, below which this axis is reported for a rigid
/// loop.
pub(crate) const DEPARTING_AXIS: f64 = 0.1;
/// Largest number of coordinates for which redundant rows are separated by loop.
pub(crate) const REDUNDANCY_LIMIT: usize = 400;

// Closing of loops.

/// Residual, relative to the group's size, that is rounding of the figures in a file: 12 digits.
pub(crate) const CLOSED_AS_DRAWN: f64 = 1e-9;
/// Largest number of iterations of a correction. Newton's method needs about five, a damped method some tens.
pub(crate) const CORRECTION_ITERATIONS: usize = 60;
/// Most work of these iterations, in cubes of a group's coordinates: all of them up to 100 coordinates.
pub(crate) const CORRECTION_WORK: usize = 60_000_000;
/// Fewest iterations, however large the group is: those of Newton's method, some of them damped.
pub(crate) const FEWEST_CORRECTION_ITERATIONS: usize = 20;
/// Largest closing motion of a loop, as a multiple of its residual as drawn. A longer motion follows a direction that
/// is caused by the residual itself.
pub(crate) const CLOSING_MOTION_FACTOR: f64 = 100.0;
/// Predicted residual, relative to the size, below which a correction's Jacobian is reused. The prediction assumes
/// the same reduction as in the last step; the result is below rounding, as with a new Jacobian.
pub(crate) const KEPT_JACOBIAN: f64 = 1e-17;
/// Shortest step along a branch, relative to the characteristic length; shorter steps end the path.
pub(crate) const SHORTEST_BRANCH_STEP: f64 = 1e-9;
/// Largest number of steps: some thousand turns of a small group. Large groups take fewer steps in the same time.
pub(crate) const BRANCH_STEPS: usize = 100_000;
/// Smallest step limit, even for large groups.
pub(crate) const FEWEST_BRANCH_STEPS: usize = 500;
/// Largest change ‖X₀⁺(X − X₀)‖ of the linearised curve between consecutive points of a branch. At 1 another branch
/// may cross.
pub(crate) const CHART_DRIFT: f64 = 0.5;
/// Largest change of the dependent coordinates' Jacobian, divided by the slope of the drivers, that needs no further
/// check.
pub(crate) const BESIDE_DRIFT: f64 = 0.25;
/// Limit of second-order terms: squared step relative to the size, divided by the smallest singular value of X.
pub(crate) const TURNING_DRIFT: f64 = 0.5;
/// Smallest slope of the drivers in the middle of a step, relative to the slope at its ends: 1 along a straight
/// branch.
pub(crate) const LEAST_MIDDLE_SLOPE: f64 = 0.25;
/// Minimum of the squared smallest singular value near a point, relative to its value at the point, below which
/// branches cross. Branches that approach each other within the square root of the closing tolerance leave at least
/// 0.01.
pub(crate) const SAME_CROSSING: f64 = 1e-3;
/// Length of a step over a crossing, as a multiple of the distance below which two branches count as one crossing.
pub(crate) const LEAP_OVER: f64 = 1e3;
/// Number of lengths tried for such a step, each an eighth of the previous one.
pub(crate) const LEAP_LENGTHS: usize = 3;
/// Smallest pivot of the dependent coordinates' Jacobian, relative to its generic size, below which a pose is
/// near-singular.
pub(crate) const NEARLY_SINGULAR: f64 = 1e-2;
/// Number of places on each side of a crossing for the interpolation of a pose.
pub(crate) const CROSSING_PLACES: usize = 4;
/// Distance of these places along the curve, relative to the characteristic length. The remaining error is η⁸/35
/// times the eighth derivative.
pub(crate) const CROSSING_STEP: f64 = 0.015;
/// Largest number of coordinates for a dense search of the weakest direction.
pub(crate) const WEAKEST_DIRECTION_LIMIT: usize = 64;
/// Singular values below this fraction of the largest are rounding.
pub(crate) const FAINT_SINGULAR_VALUE: f64 = 1e-13;
/// Squared singular values below this fraction of the largest are indistinguishable from rounding in JᵀJ.
pub(crate) const REGULAR_SQUARE: f64 = 1e-10;
/// Number of inverse iterations. Each one amplifies the weakest direction by the squared ratio of singular values.
pub(crate) const INVERSE_ITERATIONS: usize = 3;
/// Largest number of corrections that close a group again after an advance.
pub(crate) const ADVANCE_CORRECTIONS: usize = 8;

// Assembly of loops.

/// Distance from the first pose, relative to the size, below which two poses are the same.
pub(crate) const SAME_POSE: f64 = 1e-5;
/// Number of seeded starts before a group fails to close.
pub(crate) const FIRST_STARTS: u64 = 24;
/// Number of starts of a group with independent rows that is nearly, but not exactly, closed at the best of them.
pub(crate) const MOST_FIRST_STARTS: u64 = 10 * FIRST_STARTS;
/// Largest work of these starts: rows times the squared number of a group's coordinates. All starts up to 65 coordinates
/// with three times as many rows.
pub(crate) const FIRST_STARTS_WORK: u64 = 20_000_000;
/// Fewest starts, however large the group is: the drawn pose, with the declared drivers fixed and with all coordinates free.
pub(crate) const FEWEST_FIRST_STARTS: u64 = 2;
/// Perturbations of these starts, rad or relative to the size.
pub(crate) const FIRST_STARTS_ASIDE: [f64; 6] = [0.01, 0.1, 0.3, 1.0, 3.0, 2.0];
/// Number of seeded poses near the first one in the search for the generic rank.
pub(crate) const GENERIC_POSES: u64 = 12;
/// Number of these poses that are sufficient.
pub(crate) const GENERIC_POSES_ENOUGH: usize = 3;
/// Number of coordinates of a group above which fewer of these poses are tried: one pose shows the rank of a large
/// group.
pub(crate) const LARGE_GROUP: usize = 160;
/// Number of starts with the drivers at the requested positions, if the branch does not reach these. A Cassie leg
/// closes from one start in seven.
pub(crate) const MODE_STARTS: usize = 48;
/// Perturbations of these starts, rad or relative to the size.
pub(crate) const MODE_STARTS_ASIDE: [f64; 4] = [0.3, 1.0, 2.0, 3.0];
/// Largest work of these starts, in cubes of a group's coordinates.
pub(crate) const MODE_STARTS_WORK: usize = 20_000_000;
/// Distance, relative to the size, within which a joint with several set positions has reached them: values given
/// with eight decimals or fewer.
pub(crate) const MATCHED: f64 = 1e-6;
/// Largest number of corrections per step of set joints. Newton's method needs a few, if the loops permit the
/// positions.
pub(crate) const SET_CORRECTIONS: usize = 30;
/// Perturbation (rad, or relative to the size) of the joints of a mechanism with held contacts at its generic pose.
pub(crate) const HELD_ASIDE: f64 = 0.2;

// Branches at a crossing, and the limits along the branches.

/// Distance from the pose in the search for branches, relative to the group's size.
pub(crate) const BRANCH_DISTANCE: f64 = 1e-3;
/// Number of directions tried with two admissible motions.
pub(crate) const DIRECTIONS_IN_A_PLANE: usize = 96;
/// Smallest number of directions tried with more admissible motions.
pub(crate) const FEWEST_DIRECTIONS: usize = 256;
/// Largest number of these directions.
pub(crate) const MOST_DIRECTIONS: usize = 2048;
/// Largest number of corrections on the path to a branch.
pub(crate) const BRANCH_CORRECTIONS: usize = 40;
/// Number of nested intermediate branches that identify a cone.
pub(crate) const CONE_HALVINGS: usize = 4;
/// Largest work of the search for directions, in cubes of a group's coordinates: about a second.
pub(crate) const DIRECTIONS_WORK: usize = 2_500_000;
/// Angle (rad) between tangents of curves below which both belong to one branch.
pub(crate) const SAME_TANGENT: f64 = 2e-3;
/// Angle (rad) between tangent spaces below which both belong to one branch with several degrees of freedom. These
/// spaces are known only at poses near the crossing.
pub(crate) const SAME_TANGENT_SPACE: f64 = 0.02;
/// Smallest nonzero singular value at a pose near a crossing, relative to the largest.
pub(crate) const NEAR_CROSSING_RANK_FLOOR: f64 = 1e-8;
/// Distances between the places for the extrapolation of m̄ to the crossing, relative to the groups' sizes. The next
/// distance is tried if the values vary too much.
pub(crate) const LIMIT_STEPS: [f64; 4] = [0.01, 2.5e-3, 6e-4, 1.5e-4];
/// Difference between two orders of the interpolation below which the limit is accepted; the higher order is much
/// more accurate.
pub(crate) const LIMITS_AGREE: f64 = 1e-7;
/// Largest number of combinations of branches of several groups.
pub(crate) const BRANCH_COMBINATIONS: usize = 256;
/// Limit, relative to the values used in its extrapolation, below which the limit is zero.
pub(crate) const VANISHING_LIMIT: f64 = 1e-7;
/// Smallest cosine between a branch and the displacement at these places; a smaller cosine means that the branch is
/// too curved.
pub(crate) const LEAST_BRANCH_COSINE: f64 = 0.9;

/// Largest total correction that closes a group after a displacement, relative to the displacement. Corrections are
/// of second order, and far shorter unless the branch is lost.
pub(crate) const MOST_CLOSING: f64 = 1.0;
/// Largest number of places for the extrapolation of a limit: four on each side, at every distance.
pub(crate) const LIMIT_PLACES: usize = 8 * LIMIT_STEPS.len();
/// Largest work of the dense route at the places for limits, in cubes of the coordinates: two branches of a mechanism
/// of 160 coordinates, some seconds. For more work, the recursion is used.
pub(crate) const LIMITS_BY_DENSE_ROUTE: usize = 300_000_000;
/// Largest work of the recursion at these places, in bodies: 256 combinations for a mechanism of 1,000 bodies, some
/// ten seconds. For more work, fewer combinations are computed.
pub(crate) const LIMITS_BY_RECURSION: usize = 10_000_000;
/// Largest work, in cubes of a group's coordinates, of the search for branches with at most two admissible motions,
/// and of the proof that a pose is regular: every direction of a plane for 160 coordinates, or every motion for 64.
pub(crate) const DIRECTIONS_WORK_IN_ALL: usize = 400_000_000;
/// Largest work for setting joints with several positions, in cubes of a group's coordinates. Large groups may use at
/// least [`FEWEST_SET_CORRECTIONS`] corrections.
pub(crate) const SET_WORK: usize = 200_000_000;
pub(crate) const FEWEST_SET_CORRECTIONS: usize = 1_000;
/// Ratio of consecutive corrections above which converged corrections are only rounding.
pub(crate) const CORRECTIONS_SHRINK: f64 = 0.5;
/// Difference between two orders of the interpolation above which there is no limit. At this difference the limit
/// would have three digits at the smallest possible distance of the places.
pub(crate) const DOUBTFUL_LIMIT: f64 = 1e-3;
/// Largest number of bodies for keeping a workspace in the pool: some hundred kilobytes.
pub(crate) const KEPT_BODIES: usize = 256;
/// Largest number of workspaces in the pool: the number of concurrent threads.
pub(crate) const POOLED_WORKSPACES: usize = 64;
/// Largest gap of the loops as drawn, relative to the mechanism's size, that counts as rounding of the file: 64 roundings.
pub(crate) const EXACT_AS_DRAWN: f64 = 64.0 * f64::EPSILON;
/// Largest distance of positions from those of a pose (rad, or lengths of the mechanism) for reuse of its pivots: far
/// too small to move a nonzero singular value to zero.
pub(crate) const SAME_PIVOTS_DISTANCE: f64 = 1e-9;
/// Largest number of values in the clusters of a workspace kept in the pool: some hundred kilobytes.
pub(crate) const KEPT_NUMBERS: usize = 1 << 15;

// Maps of many contacts.

/// Number of contacts evaluated before the check of their errors; the columns stay in the cache.
pub(crate) const MAP_PORTION: usize = 512;
/// Largest relative error of a contact computed from Φ: eight digits. Other contacts are computed separately.
pub(crate) const MAP_TRUSTED_ERROR: f64 = 1e-8;
/// Roundings of the triangular factor and of a contact's own algebra: 6 columns of some rotations each, Higham 2002,
/// §19.6 (cited from memory), times four.
pub(crate) const MAP_OWN_ROUNDINGS: f64 = 96.0;
/// Safety factor from the errors at some dozen sample contacts to the errors of all contacts. For about 60,000
/// contacts of random trees and linkages, no result exceeded the error stated with this factor.
pub(crate) const MAP_SAFETY: f64 = 16.0;
/// |R w|, relative to its largest value, that may be rounding. A contact that nothing moves leaves 1e-15.
pub(crate) const MAP_STILL: f64 = 1e-13;
/// Eigenvalues of Φ (squares) below the first fraction of the largest are rounding. All others must be above the
/// second, so that [`MAP_STILL`] stays below [`IMMOVABLE`].
pub(crate) const MAP_CLEAR_SPECTRUM: [f64; 2] = [1e-14, 1e-6];
/// Fraction of a contact's wrench with a massless response above which the contact is certainly massless.
pub(crate) const MAP_FREE_CLEAR: f64 = 1e-6;

// Matrices of the caller.

/// Largest magnitude of an entry. Any unit.
pub(crate) const LARGEST_ENTRY: f64 = LARGEST_NUMBER;
/// Entries below this magnitude count as zero; products of two larger entries do not underflow. Any unit.
pub(crate) const LEAST_ENTRY: f64 = 1e-100;
/// Largest length of a coordinate; the smallest is the inverse. Products with entries do not overflow.
pub(crate) const LENGTH_LIMIT: f64 = 1e30;
/// Safety factor from the change of m̄ in one trial with perturbed entries to its error bound, because other signs
/// may be worse.
pub(crate) const MOVED_SAFETY: f64 = 8.0;
/// Relative error of the entries above which several trials search for errors beyond first order: half precision.
pub(crate) const FEW_DIGITS: f64 = 1e-6;
/// Number of these trials.
pub(crate) const FEW_DIGITS_TRIALS: usize = 8;
/// Largest accepted relative error of the entries: three decimals.
pub(crate) const MOST_ACCURACY: f64 = 1e-3;
/// Rows of A without an entry above this fraction of the largest entry with shared coordinates are rounding: some
/// tens of roundings of cancelling terms.
pub(crate) const ROW_NOISE: f64 = 1e-14;
/// Zero threshold for singular values of A, as a multiple of the accuracy of the entries.
pub(crate) const FLOOR_ACCURACY: f64 = 10.0;
/// Largest number of coordinates of matrices in a batch that are solved in small arrays.
pub(crate) const MOST_REGULAR: usize = 32;
/// Largest relative error of entries in the quick solution: single precision.
pub(crate) const REGULAR_ACCURACY: f64 = 1e-7;
/// Least diagonal entry of M in the quick solution; its inverse does not overflow.
pub(crate) const LEAST_DIAGONAL: f64 = 1e-90;
/// Least diagonal entry of M in the quick solution, as a multiple of the noise of a coordinate without mass ([`MATRIX_NOISE`]).
pub(crate) const CLEAR_MASS: f64 = 1e3;
/// Least part of the rows across each other, as a product of ratios, in the quick solution. Singular values are then above 6e-4, far
/// from [`RANK_FLOOR`] and [`NEARLY_IMMOVABLE`].
pub(crate) const CLEAR_ROWS: f64 = 1e-3;
/// Least ratio of two rows of A in the quick solution: no row may be rounding of others.
pub(crate) const SIMILAR_ROWS: f64 = 1e-5;
/// Largest loss of digits in the quick solution: error of the entries times the condition. Terms of second order in an error are then
/// below a hundredth of the error, which [`SECOND_ORDER`] adds.
pub(crate) const REGULAR_LOSS: f64 = 1e-4;
/// Factor for terms of second order.
pub(crate) const SECOND_ORDER: f64 = 1.01;
/// Largest accepted difference of M from its transpose, relative to √(M_rr M_cc). Two methods of summation differ by
/// about 1e-13.
pub(crate) const SYMMETRIC: f64 = 1e-9;
/// Largest accepted difference of M from its transpose as a multiple of the entries' accuracy, for entries with fewer
/// digits: sums of a few products.
pub(crate) const SYMMETRIC_ROUNDINGS: f64 = 16.0;
/// Largest entry of M relative to √(M_rr M_cc). A larger entry is not rounding: a negative energy, or noise of a
/// coordinate without mass.
pub(crate) const PAIR_BOUND: f64 = 1.0 + 1e-6;
/// Excess of [`PAIR_BOUND`] over 1 as a multiple of the entries' accuracy: the errors of the entry and of both
/// diagonal entries, doubled.
pub(crate) const PAIR_ROUNDINGS: f64 = 4.0;
/// Noise of a coordinate without mass, in roundings of the largest mass: sums of a few products.
pub(crate) const MATRIX_NOISE: f64 = 16.0;
/// Magnitude, in roundings, of a negative eigenvalue of M scaled to unit diagonal above which the energy is negative
/// (n roundings, and the entries' accuracy). Equal to the limit for pivots of the dense route.
pub(crate) const NEGATIVE_MASS: f64 = 4e3;

/// Largest last step of Newton's method, relative to the requested distance, for a pose near a crossing.
pub(crate) const TINY_STEP: f64 = 1e-6;
/// Distance from a limit of a branch, relative to the size of the group, within which a target counts as the limit:
/// rounding of positions.
pub(crate) const LIMIT_OFFSET: f64 = 1e-13;
/// Slope of the driver along the branch that counts as zero in the search for a limit, dimensionless.
pub(crate) const FLAT_SLOPE: f64 = 1e-13;
/// Width of the bracket that ends the search for a limit, relative to the size of the group.
pub(crate) const BRACKET_WIDTH: f64 = 1e-15;
/// Part of the closing tolerance below which a further correction is useless.
pub(crate) const NEGLIGIBLE_GAP: f64 = 1e-3;
/// First damping of a correction (Levenberg–Marquardt), relative to the scaled Jacobian.
pub(crate) const FIRST_DAMPING: f64 = 1e-3;
/// Damping of a correction below which undamped steps are taken again.
pub(crate) const LEAST_DAMPING: f64 = 1e-5;
/// Damping of a correction above which it ends without success.
pub(crate) const MOST_DAMPING: f64 = 1e3;
/// Part of the residual that a stalled correction keeps.
pub(crate) const STALLED_REDUCTION: f64 = 0.99;
/// Step of a stalled correction, relative to the size of the group.
pub(crate) const STALLED_STEP: f64 = 1e-9;
/// Step of a correction below the rounding of positions, relative to the size of the group.
pub(crate) const ROUNDING_STEP: f64 = 1e-15;
/// Distances along a branch at which a pose near a crossing is sought, relative to the size of the group.
pub(crate) const DEPARTURES: [f64; 4] = [0.1, 0.03, 0.01, 1e-3];
/// Largest number of steps of driving joints to their requested positions.
pub(crate) const MOST_SET_STEPS: f64 = 1e4;
/// Correction of driving joints below the rounding of positions, relative to the size of the group.
pub(crate) const SET_ROUNDING: f64 = 1e-14;
/// Sine of the angle below which opposed axes count as exactly opposed: the direction of the residual is undefined
/// there.
pub(crate) const OPPOSED_AXES: f64 = 1e-9;
/// Sine of a rotation angle below which the rotation vector is taken from its first-order term; the error is 1e-12,
/// relative.
pub(crate) const SMALL_SINE: f64 = 1e-6;
/// Part of a column of G that remains after orthogonalisation if the column depends on the others: rounding.
pub(crate) const DEPENDENT_RATES: f64 = 1e-14;
/// Least relative singular value in the rounding of rates.
pub(crate) const LEAST_SINGULAR: f64 = 1e-6;
/// Largest factor |K⁻¹||A| in the rounding of rates.
pub(crate) const MOST_GROWTH: f64 = 1e6;
/// Magnitude of a negative pivot of M, in pivot tolerances, above which M is indefinite.
pub(crate) const INDEFINITE_PIVOT: f64 = 1e3;
/// Last correction of a pose moved along v*, relative to the distance moved.
pub(crate) const ADVANCE_STEP: f64 = 1e-9;
/// Slack of joint limits, relative to 1 + |position|: a limit typed with nine digits causes no violation.
pub(crate) const LIMIT_SLACK: f64 = 1e-9;
/// Least singular value or pivot in the denominator of a rank gap, relative to the largest.
pub(crate) const GAP_ROUNDING: f64 = 1e-3 * f64::EPSILON;
/// Inverse of the last decimal of a direction in messages. An error of 1e-6 rad changes m̄ by about 1e-12,
/// relative.
pub(crate) const DIRECTION_DECIMALS: f64 = 1e6;
/// Bytes per megabyte.
pub(crate) const MEGABYTE: f64 = 1e6;
/// Weights of pairs of positions at ±1, ±2, ±3, ±4 steps in the value between them (Lagrange), with all eight positions.
pub(crate) const LAGRANGE_EIGHT: [f64; 4] = [4.0 / 5.0, -2.0 / 5.0, 4.0 / 35.0, -1.0 / 70.0];
/// The same weights with the inner six positions.
pub(crate) const LAGRANGE_SIX: [f64; 4] = [3.0 / 4.0, -3.0 / 10.0, 1.0 / 20.0, 0.0];
/// Golden ratio minus 1: its multiples modulo 1 are evenly spread.
pub(crate) const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Least number of remaining rows for a start of a driven path: the start costs as much as a few rows.
pub(crate) const LEAST_FOLLOWED_ROWS: usize = 4;
/// Largest number of starts of a driven path along its rows. With more frequent stops a driven path saves no time.
pub(crate) const MOST_PATH_STARTS: usize = 16;
/// Units in the last place around each number of a model in a proof: readers convert units, normalise axes and rotate inertias. 0 and ±1
/// are exact.
pub(crate) const READING: f64 = 8.0;
/// Units in the last place around a position in a proof: converted units.
pub(crate) const POSITION_READING: f64 = 2.0;
/// Units in the last place of the size of a mechanism around a distance as drawn in a proof: the roundings of its frames.
pub(crate) const DRAWN_READING: f64 = 256.0;
/// Largest radius of a proof of uniqueness, rad or m: beyond it the cosines of the closures have further zeros.
pub(crate) const WIDEST_PROOF: f64 = 2.0;
/// Ratio of two tried radii of a proof of uniqueness.
pub(crate) const RADIUS_STEP: f64 = 0.8;
/// Smallest tried radius of a proof of uniqueness, rad or m.
pub(crate) const LEAST_RADIUS: f64 = 1e-12;
/// Least radius of the box of an assembly, rad or m: the rounding of its positions.
pub(crate) const LEAST_BOX: f64 = 1e-15;
/// Smallest accepted pivot of the rows in a proof, relative to the largest entry: smaller ones give no proof in `f64`.
pub(crate) const LEAST_PROVED_PIVOT: f64 = 1e-7;
/// Number of steps of Newton for a start far from the assembly of a proof.
pub(crate) const PROOF_NEWTON_STEPS: usize = 6;
/// Number of enlarged boxes that are tried for an assembly.
pub(crate) const MOST_PROOF_BOXES: usize = 12;
/// Largest number of ranges of a proof with loops: the number of boxes grows with their product.
pub(crate) const MOST_LINKAGE_RANGES: usize = 2;
/// Relative distance of the stated bounds of ranges from the computed ones: roundings of another program that checks the proof.
pub(crate) const CHECK_ROOM: f64 = 1e-11;
/// Smallest pivot of the rows of a linkage, relative to the largest entry, for which the conditions determine its motion; and
/// largest residual of conditions that do not exclude one another. Roundings are some 1e-15, regular poses above 1e-4.
pub(crate) const UNDETERMINED_MOTION: f64 = 1e-9;
/// Largest change of a unit vector or of a rotation between two designs whose frames correspond: a hardpoint that moves by 1e-5 of the
/// mechanism turns a part of a thousandth of its size by 1e-2; an exchanged direction is turned by about 1.
pub(crate) const SAME_DIRECTION: f64 = 0.03;
/// Largest residual of a nearby design after one Newton step, relative to the residual before: the step leaves second-order terms, some
/// 1e-5, and a design that does not close leaves about 1.
pub(crate) const CLOSED_PART: f64 = 3e-3;
/// Least such residual, relative to the size of the mechanism: rounding.
pub(crate) const CLOSED_ROUNDING: f64 = 1e-13;
/// Distance of a joint from its position at the start (rad or m) up to which it was held there.
pub(crate) const HELD_POSITION: f64 = 1e-13;
