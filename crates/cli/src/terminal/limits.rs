//! Thresholds of the text and CSV output, each with its unit and its reason.

/// Default relative tolerance of --expect: larger than the rounding of the computation, smaller than any change of
/// the model.
pub const DEFAULT_TOLERANCE: f64 = 1e-9;
/// Number of warnings or notes of one kind shown in full: enough to recognise their common cause.
pub const DIAGNOSTICS_SHOWN: usize = 3;
/// Joints listed on one line of text; more do not fit in a terminal.
pub const JOINTS_SHOWN: usize = 8;
/// Share of the effective mass below which a contribution is only counted, because it would be shown as 0.0 %.
pub const MIN_CONTRIBUTION: f64 = 5e-4;
/// Length of the bar of a contribution of 100 %, in characters; half of a terminal of 80 columns remains for names.
pub const BAR_WIDTH: usize = 30;
/// Smallest width of a wrapped last column, in characters: about four words per line.
pub const MIN_COLUMN: usize = 24;
/// Indentation of continued table columns, in characters, to distinguish them from the next row.
pub const BAND_INDENT: usize = 4;
/// Error of the estimate, in percent, below which zero is shown: half of the last digit shown (two decimals).
pub const ESTIMATE_ROUNDING: f64 = 0.005;
/// Drift of the mass, in percent, below which zero is shown: half of the last digit shown (three decimals).
pub const DRIFT_ROUNDING: f64 = 5e-4;
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
