//! Thresholds of the kernels.

/// Largest relative error of a result in SIMD lanes, except for large linkages ([`LARGE_TRUSTED_ERROR`]); beyond this limit the recursion
/// computes the row again. The stated bound is a hundred to a thousand times the true error: rows of common robots exceed 1e-11.
pub const LANES_TRUSTED_ERROR: f64 = 1e-9;
/// Largest relative error of a result in SIMD lanes for a linkage with more than [`QUICK_COORDINATES`] coordinates. The recursion takes some
/// twenty times as long and states no error.
pub const LARGE_TRUSTED_ERROR: f64 = 1e-5;
/// Largest relative error by the quick bound of linkages in SIMD lanes; beyond this limit the refined bound is computed, which takes
/// longer and is smaller.
pub const QUICK_ERROR: f64 = 1e-11;
/// Residual of a closed loop relative to the group's size: some thousand roundings.
pub const CLOSED: f64 = 1e-12;
/// Sine of the angle below which two axes are parallel within rounding.
pub const NO_TURN: f64 = 2.0 * f64::EPSILON;
/// Sine of the angle between two axes below which their common normal is too far away to be used.
pub const PARALLEL_AXES: f64 = 0.05;
/// Distance between parallel axes that counts as rounding, relative to the distance of their defining points.
pub const NO_ACROSS: f64 = 16.0 * f64::EPSILON;
/// Range of prismatic positions, relative to the length of the mechanism, for which size bounds are computed once;
/// larger positions scale the bounds.
pub const SLIDE_REACH: f64 = 0.5;
/// Largest deviation of a quaternion's squared norm from 1 by rounding; a larger deviation gives no rotation.
pub const UNIT_QUATERNION: f64 = 32.0 * f64::EPSILON;
/// Roundings of a pivot and of a test force, relative to their terms, in the a-priori bound of the recursion's
/// rounding: three times those of a sum of a few products. The factor is larger for pivots much smaller than their
/// terms.
pub const ROUTE_ROUNDINGS: f64 = 16.0;
/// Roundings of a pivot and its remainder in SIMD lanes, relative to the pivot's largest term: the products and sums
/// of an elimination, and two rotations and translations.
pub const LOSS_ROUNDINGS: f64 = 4.0;
/// Ratio of a pivot's terms to the pivot above which the elimination amplifies the errors of the subtree, in SIMD
/// lanes. Pivots of common arms and long chains are below this ratio, or have no errors to amplify.
pub const COMMON_LOSS: f64 = 64.0;
/// Roundings of the normal for each joint between the root link and the contact link, in SIMD lanes: two rotations.
pub const NORMAL_ROUNDINGS: f64 = 4.0;
/// Amplification of rounding errors above which a body is light compared with its subtree: bodies below this value contribute less
/// than half of the accepted error in SIMD lanes.
pub const LIGHT_BODY: f64 = 2.5e4;
/// Amplification above which the mass matrix in SIMD lanes may be in error by more than 1e-3, relative: twists computed with it are
/// then not used in bounds.
pub const LARGEST_AMPLIFICATION: f64 = 5e11;
/// Largest relative error, from the constants of a contact alone, for which the sizes of terms are not computed: a tenth of
/// [`LANES_TRUSTED_ERROR`].
pub const LARGEST_ENERGY_ERROR: f64 = 1e-10;
/// Value of a bound that does not exist, in any unit. Unlike infinity, its product with 0 is a number.
pub const NO_BOUND: f64 = 1e150;
/// Smallest principal moment about the centre of mass, relative to the trace about the origin of the joint, that is certainly
/// not rounding.
pub const LEAST_MOMENT: f64 = 1e-12;
/// Longest step along a branch, for the coordinate that moves most, relative to the characteristic length.
pub const LONGEST_BRANCH_STEP: f64 = 0.15;
/// Cosine of the largest rotation of the tangent in a step: about 25°.
pub const STRAIGHT: f64 = 0.9;
/// Number of power iterations for the norm of a change of rows; a tenth of the norm is accurate enough.
pub const DRIFT_ITERATIONS: usize = 4;
/// Largest number of coordinates and bodies of a linkage with a compiled kernel: the time to order its rows grows with the square of this
/// number.
pub const LINKAGE_COORDINATES: usize = 1024;
/// Largest number of coordinates of a linkage for which 1/(smallest pivot) is used as an estimate of the norm of the inverse. The estimate
/// is empirical: no stated error of the tested linkages is too small with it.
pub const QUICK_COORDINATES: usize = 64;
/// Smallest admissible pivot when the rows are ordered, relative to the largest remaining entry. Of the admissible pivots, the one with the
/// smallest Markowitz count comes first (Markowitz 1957).
pub const PIVOT_CHOICE: f64 = 0.5;
/// Largest number of further kernels of a linkage, for results that its first kernel does not certify.
pub const ALTERNATIVE_KERNELS: usize = 3;
/// Factor of the entries of a coordinate in the choice of pivots for each earlier kernel in which the coordinate is dependent: another
/// coordinate is preferred unless its pivot is sixteen times as small.
pub const DEPENDED_BEFORE: f64 = 1.0 / 16.0;
/// Largest number of degrees of freedom of such a linkage, whose energy is a full matrix over these.
pub const LINKAGE_FREEDOMS: usize = 64;
/// Largest remainder of a redundant row, as a fraction of the remainder below which a row counts as redundant: a factor of four
/// leaves no doubt.
pub const REDUNDANT_ROW: f64 = 0.25;
/// Largest ratio of the largest entry of A to a pivot at the pose for which a linkage is compiled. Linkages drawn near a change
/// point have a ratio of some hundred; at each configuration the pivots are bounded again.
pub const LINKAGE_PIVOT: f64 = 1024.0;
/// Residual, relative to the smallest size of a group, at which lanes need no further Newton iteration: rounding.
pub const CLOSED_IN_LANES: f64 = 4e-15;
/// Largest number of Newton iterations in lanes; from a prediction two or three are sufficient.
pub const CLOSING_PASSES: usize = 5;
/// Largest correction of dependent coordinates relative to the step.
pub const SMALL_CORRECTION: f64 = 0.25;
/// Largest change ‖A₀⁻¹(A − A₀)‖ of the dependent coordinates' Jacobian, over rows followed from one pose without
/// another check. At 1 a second branch may come near. The rates of the dependent coordinates change by at most a
/// half.
pub const FOLLOWERS_DRIFT: f64 = 1.0 / 3.0;
/// Largest ratio of the length of a branch to its tangent over such rows: rates g increase to at most (g + 1/3)·3/2.
pub const LONGEST_FOLLOWED: f64 = 2.0;
/// Step of the finite differences for ‖A′‖, relative to the size; leaves five digits.
pub const CURVATURE_STEP: f64 = 1e-5;
/// Error of a linkage's rows as a multiple of the motion that would close its loops, divided by its smallest length. The factor is
/// empirical: with this factor the true errors of the tested linkages are at most a twentieth of the stated bound.
pub const OPEN_ROUNDINGS: f64 = 1.0;
/// Roundings of a linkage's rows in lanes, for the frame of the ground and for the root of the depth of the tree. With these
/// constants the true errors of the tested linkages are at most a twentieth of the stated bound.
pub const LANE_ROW_ROUNDINGS: f64 = 1.0;
/// Roundings of an arm between two positions, relative to the relevant length.
pub const FAR_ROUNDINGS: f64 = 2.0;
