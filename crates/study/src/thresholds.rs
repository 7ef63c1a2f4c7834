//! All thresholds of this crate, with units and reasons.

use std::ops::RangeInclusive;

// What a question may ask.

/// A shorter vector has no direction: one typed with a few digits is longer, the difference of equal points shorter.
/// Any unit.
pub(crate) const SHORTEST_DIRECTION: f64 = 1e-9;
/// Number of joints tried in place of a driver that reached its limit before the requested travel.
pub(crate) const OTHER_DRIVERS: usize = 4;
/// Joints that drive a travel one after another past each other's dead centres, at most: one turn of a linkage passes some four.
pub(crate) const TRAVEL_STAGES: usize = 6;
/// Part of the way to a joint's end that it drives before another takes over: near its dead centre digits are lost.
pub(crate) const SHORT_OF_END: f64 = 0.98;
/// A joint that advances a travel by less than this part of the mechanism's size does not take it further.
pub(crate) const LEAST_ADVANCE: f64 = 1e-4;
/// A joint that moves a point by less than this part of the mechanism's size a radian does not drive it.
pub(crate) const UNMOVED: f64 = 1e-6;
/// Largest coordinate, m: its square is still a number, with room for sums.
pub(crate) const LARGEST_COORDINATE: f64 = 1e100;
/// Least mass of a free body on the other side, kg: its inverse is still a number, with room for sums.
pub(crate) const LEAST_OTHER_MASS: f64 = 1e-100;
/// Rows of a sweep: an hour's work at 1 ms each, and more than any plot shows.
pub(crate) const ROWS: RangeInclusive<usize> = 1..=1_000_000;
/// Rows of a grid: some twenty minutes at 10 µs each. None is kept.
pub(crate) const GRID_ROWS: usize = 100_000_000;
/// Bytes of a study file: some hundred bytes a variant. The parser takes some hundred bytes of memory for each value, and a
/// value may have two.
pub(crate) const LARGEST_STUDY: u64 = 4 << 20;
/// Variants of a study: more than any table shows.
pub(crate) const MOST_VARIANTS: usize = 10_000;
/// Bytes of the copies of the question in all variants.
pub(crate) const LARGEST_VARIANTS: usize = 1 << 28;
/// Links of the mechanisms of all variants together: some 900 MB.
pub(crate) const MOST_VARIANT_LINKS: usize = 1_000_000;
/// Bytes of a line of a study that is shown with an error.
pub(crate) const LONGEST_LINE_SHOWN: usize = 400;
/// Bytes of a record of a table: a thousand joints with 17 digits take 20 kB.
pub(crate) const LONGEST_RECORD: usize = 1 << 20;
/// Bytes of what a Parquet file says of its columns: a thousand columns in a thousand groups of rows take some 100 MB, more
/// than anybody reads; those of a robot take some 100 kB.
pub(crate) const LARGEST_DESCRIPTION: u64 = 1 << 26;
/// Entries of a list there: columns, or groups of rows.
pub(crate) const MOST_IN_A_LIST: u64 = 1 << 20;
/// Columns of a Parquet file within one another: lists of records nest some ten deep.
pub(crate) const DEEPEST_COLUMN: usize = 64;
/// Bytes in memory that the pages of a Parquet file may take, all columns together.
pub(crate) const PAGES: u64 = 1 << 30;
/// A page may have as many bytes however many columns there are: writers make pages of 1 MiB, or somewhat more.
pub(crate) const SMALLEST_LARGEST_PAGE: u64 = 1 << 22;
/// Bytes of a page's header: twenty, and its statistics.
pub(crate) const USUAL_PAGE_HEADER: u64 = 1 << 12;
/// The same where statistics are long texts.
pub(crate) const LONGEST_PAGE_HEADER: u64 = 1 << 20;
/// Rows of a Parquet file that are taken from its pages at once.
pub(crate) const PARQUET_ROWS: usize = 1024;
/// Rows that are posed, answered and handed out at once where they follow one another: some milliseconds of a small
/// linkage, and its poses stay in the caches.
pub(crate) const BLOCK_OF_POSES: usize = 256;
/// The same for a mechanism of many links, in links: some 10 MB of poses.
pub(crate) const BLOCK_OF_LINKS: usize = 10_000;
/// Rows without poses that are answered and handed out at once: a millisecond of a small tree.
pub(crate) const BLOCK_IN_LANES: usize = 4096;
/// Rows of a line that are worth preparing to follow them several at once: it costs as much as a few of them.
pub(crate) const FOLLOWED_ROWS: usize = 4;
/// Largest number of restarts of the path follower along a line. More frequent stops gain nothing.
pub(crate) const FOLLOWED_BEGINNINGS: usize = 16;
/// Rows without poses that are answered by one thread without a break: of a block a thirty-second, so that no thread waits
/// long for the last one.
pub(crate) const PORTION_IN_LANES: usize = 128;
/// Rows of the first block: a reader has them soon. Blocks then double.
pub(crate) const FIRST_BLOCK: usize = 8;
/// Rows that are answered by one thread without a break.
pub(crate) const PORTION: usize = 32;

/// How far a travel may end from where it was asked to, in parts of the characteristic length, where several drive a pose:
/// each is met to 1e-12 by itself.
pub(crate) const TRAVEL_MET: f64 = 1e-11;
/// Newton steps of several travels: from a near place some five are needed.
pub(crate) const TRAVEL_ROUNDS: usize = 12;
/// Parts of the way of several travels that are tried first.
pub(crate) const TRAVEL_PARTS: f64 = 4.0;
/// The least part of the way: a travel of 0.1 m in steps of 0.1 mm.
pub(crate) const LEAST_PART: f64 = 1e-3;
/// Largest number of halvings of a travel that is too long for one step: 2⁻³² of a turn is negligible.
pub(crate) const HALVINGS: usize = 32;

/// Samples of a tolerance: a minute's work at a millisecond each on a few processors; one alone says nothing.
pub(crate) const SAMPLES: RangeInclusive<usize> = 2..=100_000;
/// Step of a hardpoint for differences of four values, in parts of the characteristic length: their truncation grows with its
/// fourth power, 1e-16 relative; m̄ is found to some 1e-12, which leaves 1e-8.
pub(crate) const POINT_STEP: f64 = 1e-4;
/// Changes that an explanation names of each kind.
pub(crate) const STRONGEST: usize = 3;
/// How far from 1 the product of a motion ratio and its inverse may be for a mechanism with one travel: the loops' closing and
/// rounding leave some 1e-11.
pub(crate) const ONE_TRAVEL: f64 = 1e-9;

// What is reported with an answer.

/// Distance of a contact point from its link's origin, in reaches of the link, from which on it is doubted: parts fixed
/// to a link by hand stand out of it by its own size at most.
pub(crate) const FAR_POINT: f64 = 3.0;
/// A distance that divided by 1000 is at least this part of the reach may have been given in millimetres.
pub(crate) const MILLIMETRES: f64 = 0.01;
/// A relative error of m̄ above this comes with a warning: the digits that engineers compare, and what rounded files
/// leave.
pub(crate) const UNCERTAIN: f64 = 1e-6;
/// Limits of m̄ along branches that agree to this (relative) are one mass: they are carried on to some 1e-7 at worst.
pub(crate) const SAME_LIMIT: f64 = 1e-6;
/// An assembly is far from its guess from this angle on (rad), or from this part of the size: assembly modes are
/// further apart, a guess read off a drawing is nearer.
pub(crate) const FAR_FROM_GUESS: f64 = 0.5;
/// Velocity per unit closing speed from which a held point counts as leaving: the rounding of unit velocities is far
/// below.
pub(crate) const LEAVES: f64 = 1e-9;
/// Half the distance of the differences that give dm̄/dδ, in parts of the characteristic length: the cube root of
/// rounding, where truncation and rounding are alike.
pub(crate) const DIFFERENCE: f64 = 1e-5;
/// First step of the motion over the penetration, as a part of it.
pub(crate) const FIRST_PENETRATION: f64 = 0.5;
/// The next step over the last one that was good.
pub(crate) const PENETRATION_GROWTH: f64 = 1.25;
/// Relative difference of m̄ between one step and two halves that is good: some hundred steps leave four digits.
pub(crate) const PENETRATION_MASS: f64 = 1e-6;
/// Distance of the contact point between these, as a part of the step: depths are good to four digits.
pub(crate) const PENETRATION_MOTION: f64 = 1e-5;
/// The least step over the penetration: near a dead centre good steps are a hundredth of what is left of the motion, whose end is
/// found to a few ten-thousandths, after some thousand steps.
pub(crate) const LEAST_PENETRATION: f64 = 1e-6;
/// Relative change of m̄ over the penetration from which one number comes with a warning: restitutions are measured to
/// some per cent.
pub(crate) const DRIFTING: f64 = 0.01;

// How often rows out of reach are tried.

/// Rows tried from one start between where the first search ended and where it was to go: the end of a travel is found
/// to a few per cent at the first, and closer at each.
pub(crate) const PROBABLE: usize = 16;
/// Rows tried one after another without an answer where each starts otherwise: some ten seconds of a small linkage.
pub(crate) const UNRELATED: usize = 10_000;
/// A value this close to an end (relative, and absolutely below 1) may be the end itself, found to rounding.
pub(crate) const AT_END: f64 = 1e-9;

// Maps.

/// Edges of facets across a link where none is asked for: a picture of 400 pixels shows them.
pub(crate) const EDGES_ACROSS: f64 = 60.0;
/// Facets of a map at most: 2 GB.
pub(crate) const FACETS: usize = 8_000_000;
/// Shortest edge that can be asked for, m.
pub(crate) const LEAST_EDGE: f64 = 1e-6;
/// Directions at a point: fewest and most.
pub(crate) const DIRECTIONS: std::ops::RangeInclusive<usize> = 1..=1_000_000;
