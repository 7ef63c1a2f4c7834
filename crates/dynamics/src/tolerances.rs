//! Every threshold of this crate, with its unit and its reason.

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
/// Coordinates up to which the careful route is taken: it is dense, O(n³) in time and 8n² bytes a matrix.
pub(crate) const CAREFUL_LIMIT: usize = 1000;
/// Coordinates up to which the condition of the mass matrix is asked: O(n³).
pub(crate) const CONDITION_LIMIT: usize = 300;

/// Singular values of A below this part of the largest count as zero, where the file is exact: rounding leaves 1e-14.
pub(crate) const RANK_FLOOR: f64 = 1e-10;
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

// How the travel of a point is reached. Steps of the driving joint are in rad, or in parts of the size; rates are in
// sizes a unit of these.

/// A shorter vector has no direction. Any unit.
pub(crate) const SHORTEST_DIRECTION: f64 = 1e-9;
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
