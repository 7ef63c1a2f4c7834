//! Layout of the workspace of a linkage, per lane.

use percuss_spatial::lanes::Lanes;

/// Offsets of the tables.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Layout {
    /// Entries of A that are nonzero before or during the elimination, row by row. The pivot rows come first, in order; redundant rows
    /// follow.
    pub entries: usize,
    /// 1 over each pivot.
    pub inverse_pivots: usize,
    /// Rates of the coordinates, columns × freedoms.
    pub rates: usize,
    /// Twists of the bodies at their origins, root axes: bodies × freedoms × 6.
    pub twists: usize,
    /// Constraint residuals, m: rows.
    pub residuals: usize,
    /// Newton steps of the coordinates, m: columns.
    pub steps: usize,
    /// Growth of the errors of the entries in the elimination: rows.
    pub growth: usize,
    /// Errors of the rates per error of an entry, 1/m: columns × freedoms.
    pub rate_errors: usize,
    /// Twists of one body in its own axes: freedoms × 6.
    pub known: usize,
    /// D on and below the diagonal, row by row.
    pub energy: usize,
    /// Slope, residual (m) and rounding of the slope of each relation.
    pub relations: usize,
    /// Number of values per lane.
    pub total: usize,
    /// Number of pivot rows, and of dependent coordinates.
    pub count: usize,
}

/// Frame of a body: nine numbers for its rotation, three for its position.
pub(super) const FRAME: usize = 12;
/// Values of a relation.
pub(super) const RELATION: usize = 3;

impl Layout {
    /// Layout for `bodies` bodies, `all` rows of A with `nonzero` entries, `columns` coordinates, of which `freedoms` are independent, and
    /// `curves` relations. The frames of the bodies come first.
    pub fn of(
        bodies: usize,
        (all, nonzero): (usize, usize),
        columns: usize,
        freedoms: usize,
        curves: usize,
    ) -> Self {
        let count = columns - freedoms;
        let entries = FRAME * bodies;
        let over = entries + nonzero;
        let rates = over + count;
        let twists = rates + columns * freedoms;
        let residuals = twists + 6 * bodies * freedoms;
        let steps = residuals + all;
        let growth = steps + columns;
        let rate_errors = growth + all;
        let known = rate_errors + columns * freedoms;
        let energy = known + 6 * freedoms;
        let relations = energy + freedoms * (freedoms + 1) / 2;
        Self {
            entries,
            inverse_pivots: over,
            rates,
            twists,
            residuals,
            steps,
            growth,
            rate_errors,
            known,
            energy,
            relations,
            total: relations + RELATION * curves,
            count,
        }
    }

    /// Offset of the entry of D in row `y` and column `z`, z ≤ y.
    #[inline(always)]
    pub fn energy_entry(&self, y: usize, z: usize) -> usize {
        self.energy + y * (y + 1) / 2 + z
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn get<T: Lanes>(scratch: &[f64], at: usize) -> T {
    T::load(&scratch[at * T::WIDTH..])
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn store<T: Lanes>(scratch: &mut [f64], at: usize, x: T) {
    x.store(&mut scratch[at * T::WIDTH..]);
}

/// Loads a vector stored by [`put_vector`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn get_vector<T: Lanes>(scratch: &[f64], at: usize) -> [T; 3] {
    let own = &scratch[at * T::WIDTH..][..3 * T::WIDTH];
    [T::load(own), T::load(&own[T::WIDTH..]), T::load(&own[2 * T::WIDTH..])]
}

/// Stores a vector at index `at` of the workspace: three numbers, each with lane width.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn put_vector<T: Lanes>(scratch: &mut [f64], at: usize, v: [T; 3]) {
    let own = &mut scratch[at * T::WIDTH..][..3 * T::WIDTH];
    v[0].store(own);
    v[1].store(&mut own[T::WIDTH..]);
    v[2].store(&mut own[2 * T::WIDTH..]);
}

/// a · b.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn dot<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> T {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

/// a × b.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn cross<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [
        a[1].mul_add(b[2], -(a[2] * b[1])),
        a[2].mul_add(b[0], -(a[0] * b[2])),
        a[0].mul_add(b[1], -(a[1] * b[0])),
    ]
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn minus<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn plus<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn times<T: Lanes>(a: &[T; 3], x: T) -> [T; 3] {
    [a[0] * x, a[1] * x, a[2] * x]
}

/// a·x + b.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn add_scaled<T: Lanes>(a: &[T; 3], x: T, b: &[T; 3]) -> [T; 3] {
    [a[0].mul_add(x, b[0]), a[1].mul_add(x, b[1]), a[2].mul_add(x, b[2])]
}

/// Σ |aᵢ|, an upper bound of the length.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn size<T: Lanes>(a: &[T; 3]) -> T {
    a[0].abs() + a[1].abs() + a[2].abs()
}
