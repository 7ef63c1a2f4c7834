//! Thresholds of the text and CSV output, each with its unit and its reason.

/// Significant digits in texts for people: those that a sheet of masses and points supports.
pub const DIGITS: usize = 4;
/// Load from which its unit has the prefix kilo.
pub const KILO: f64 = 1e3;
/// Default relative tolerance of --expect: larger than the rounding of the computation, smaller than any change of
/// the model.
pub const DEFAULT_TOLERANCE: f64 = 1e-9;
/// Number of warnings or notes of one kind shown in full: enough to recognise their common cause.
pub const DIAGNOSTICS_SHOWN: usize = 3;
/// Largest number of differences per design in the text of a comparison; JSON has all differences.
pub const CHANGES_SHOWN: usize = 6;
/// Share of the effective mass below which a contribution is only counted, because it would be shown as 0.0 %.
pub const MIN_CONTRIBUTION: f64 = 5e-4;
/// Estimated change of an impulse by the bushes above which the rule of thumb has no meaning.
pub const MUCH_COMPLIANCE: f64 = 0.25;
/// Number of natural modes without --details.
pub const MODES_SHOWN: usize = 12;
/// Share of a row in the elastic energy of the bushes, of a link in a mode, or of a mode in the free mass, from which the row is named.
pub const SEEN_SHARE: f64 = 0.05;
/// Length of the longest bar beside a table, in characters: a quarter of a line of 80 columns.
pub const BAR_WIDTH: usize = 20;
/// Length of the longest bar below which a table has no bars: bars of a few characters cannot be compared.
pub const LEAST_BAR_WIDTH: usize = 6;
/// Smallest width of a wrapped last column, in characters: about four words per line.
pub const MIN_COLUMN: usize = 24;
/// Indentation of continued table columns, in characters, to distinguish them from the next row.
pub const BAND_INDENT: usize = 4;
/// Difference of wheel travels, m, below which two touches count as the same: half of the last digit shown.
pub const SAME_TRAVEL: f64 = 5e-6;
/// Relative difference up to which two curves are equal and drawn once: rounding.
pub const EQUAL_CURVES: f64 = 1e-9;
/// Component of a vector, relative to the largest, below which zero is shown: some tens of roundings.
pub const COMPONENT_ROUNDING: f64 = 1e-14;
/// Samples of a force history in a plot or CSV file: two per unit of the plot's width.
pub const HISTORY_SAMPLES: usize = 2000;
/// Range of magnitudes written in decimal notation in CSV. Other numbers use scientific notation, because zeros would
/// fill the cell.
pub const DECIMAL_NUMBERS: std::ops::Range<f64> = 1e-5..1e16;
/// Cells of a row group in Parquet: about 8 MB, the memory of a writer with several columns.
#[cfg(feature = "tables")]
pub const CELLS_OF_A_GROUP: usize = 1 << 20;
/// Rows of a row group; readers load one group at a time.
#[cfg(feature = "tables")]
pub const ROWS_OF_A_GROUP: std::ops::RangeInclusive<usize> = 1024..=1 << 17;
/// Parts with a name in the picture of a report; more names would cover the mechanism.
pub const NAMED_PARTS: usize = 24;
/// Rows of the first page of a report: what fits on one sheet of A4.
pub const PARTS_ON_FIRST_PAGE: usize = 8;
pub const VARIANTS_ON_FIRST_PAGE: usize = 3;
pub const RATES_ON_FIRST_PAGE: usize = 5;
/// Cosine of the angle to an axis from which a direction is named by the axis: 20 degrees.
pub const ALONG_AXIS: f64 = 0.94;
/// Change of the restitution that needs no action: below the accuracy of a measured restitution.
pub const SMALL_RESTITUTION_CHANGE: f64 = 0.005;
/// Main numbers of a report.
pub const MAIN_NUMBERS: usize = 4;
/// Bars of a tornado chart: the largest effects, half a page of A4.
pub const TORNADO_BARS: usize = 16;
/// Largest number of bins of a histogram: a bin is then wider than ten units of the plot's width.
pub const HISTOGRAM_BINS: usize = 60;
/// Rows of a sweep of which a report keeps the varied number, for the effect of tolerances.
pub const ROWS_KEPT: usize = 10_000;
/// Rows of the table of a sweep on a terminal: about a screen.
pub const SWEEP_ROWS_ON_TERMINAL: usize = 40;
/// Rows of a sweep in the table of a report.
pub const SWEEP_ROWS_SHOWN: usize = 11;
/// Smallest number of values of a curve that may be clipped; of fewer values each counts.
pub const LEAST_CLIPPED: usize = 8;
/// Part of the values at each end that may be outliers.
pub const OUTLIERS: f64 = 0.1;
/// Distance of an outlier from the other values, as a multiple of their spread, above which a curve is clipped: the other
/// values would take less than a third of the axis.
pub const OUTLIER_DISTANCE: f64 = 2.2;
/// Spread of a curve, relative to its largest value, below which a report states the constant instead of a plot: the four digits
/// that its axis shows.
pub const FLAT_CURVE: f64 = 1e-4;
/// Relative difference below which two curves of a report are the same: less than the width of a line.
pub const SAME_CURVE: f64 = 1e-6;
/// Rows of a sweep with the effect of the tolerances in a report; each takes some ten evaluations, and twelve per hardpoint
/// if designs are not near one another.
pub const TOLERANCE_ROWS: usize = 9;
/// The same for several contacts together: with more than a third as many contacts, figures have no tolerances.
pub const TOLERANCE_ROWS_OF_ALL: usize = 20;
/// Least number of rows with tolerances in a figure.
pub const LEAST_TOLERANCE_ROWS: usize = 3;
