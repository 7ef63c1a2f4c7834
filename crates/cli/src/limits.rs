//! The thresholds of the text and CSV output, each with its unit and its reason.

/// The default relative tolerance of --expect: above the rounding of the computation, below any change of the model.
pub const DEFAULT_TOLERANCE: f64 = 1e-9;
/// Warnings or notes of one kind that are shown in full: enough to see what they have in common.
pub const DIAGNOSTICS_SHOWN: usize = 3;
/// Joints listed on one line of text; more do not fit in a terminal.
pub const JOINTS_SHOWN: usize = 8;
/// Contributions below this share of the effective mass are counted, not listed: they would be shown as 0.0 %.
pub const LEAST_CONTRIBUTION: f64 = 5e-4;
/// Length of the bar of a contribution of 100 %, in characters: half of a terminal of 80 columns is left for names.
pub const BAR_WIDTH: usize = 30;
/// A last column of text is divided between words down to this width, in characters: some four words on a line.
pub const LEAST_COLUMN: usize = 24;
/// Columns of a table that go on in a further line are indented by this many characters, to tell it from the next row.
pub const BAND_INDENT: usize = 4;
/// An error of the estimate, in percent, below which it is shown as zero: half of the last digit shown (two decimals).
pub const ESTIMATE_ROUNDING: f64 = 0.005;
/// A drift of the mass, in percent, below which it is shown as zero: half of the last digit shown (three decimals).
pub const DRIFT_ROUNDING: f64 = 5e-4;
/// A component of a vector, relative to the largest, that is shown as zero: some tens of roundings.
pub const COMPONENT_ROUNDING: f64 = 1e-14;
/// Samples of a force history in a plot or CSV file: two for each unit of the plot's width.
pub const HISTORY_SAMPLES: usize = 2000;
/// Numbers in CSV of this size are written in decimal notation, others in scientific, since zeros would fill the
/// cell.
pub const DECIMAL_NUMBERS: std::ops::Range<f64> = 1e-5..1e16;
/// Cells of a group of rows in Parquet: some 8 MB, which is what a writer of some columns keeps.
pub const CELLS_OF_A_GROUP: usize = 1 << 20;
/// Rows of a group: readers take one group at a time.
pub const ROWS_OF_A_GROUP: std::ops::RangeInclusive<usize> = 1024..=1 << 17;
