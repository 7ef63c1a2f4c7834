//! Thresholds of the readers of suspensions, with units and reasons.
//!
//! Files may be hostile: every count below bounds time or memory.

use std::ops::RangeInclusive;

// Suspension files.

/// Deepest nesting of JSON objects and arrays.
pub(crate) const MAX_JSON_DEPTH: usize = 256;
/// Largest number of keys of one object; the search among them is linear.
pub(crate) const MAX_KEYS: usize = 1000;
/// Upper bound of the largest hardpoint coordinate of a vehicle, m. Vehicles are shorter; a vehicle in millimetres that is
/// read in metres is far above this bound.
pub(crate) const MAX_VEHICLE_EXTENT: f64 = 20.0;
/// Lower bound of the largest hardpoint coordinate of a vehicle, m. A vehicle in metres that is read in millimetres is below
/// this bound; a soapbox car is above.
pub(crate) const MIN_VEHICLE_EXTENT: f64 = 0.02;
/// Lower bound of the track of a vehicle that carries a person, m; a vehicle in another unit is often below.
pub(crate) const MIN_TRACK: f64 = 0.4;
/// Tracks of usual vehicles, m: a unit that gives such a track is suggested in place of a wrong one.
pub(crate) const USUAL_TRACKS: std::ops::RangeInclusive<f64> = 0.8..=3.0;
/// Sine of the largest angle between directions that count as parallel and span no plane: smaller than any angle that a
/// hardpoint file resolves.
pub(crate) const MAX_PARALLEL_SINE: f64 = 1e-9;
/// Tolerance of the triangle inequality of principal moments, relative: files have nine digits.
pub(crate) const MOMENT_TOLERANCE: f64 = 1e-9;

// Sheets and tables of hardpoints.

/// Largest number of keys of a sheet, or rows of a table. The search is linear; templates have fewer than 100 keys.
pub(crate) const MAX_SHEET_KEYS: usize = 1000;
/// Largest sheet in TOML, bytes: templates have 5 kB. The parser takes some hundred bytes of memory per value.
pub(crate) const MAX_SHEET_BYTES: usize = 4 << 20;
/// Largest number of columns read from a table: a key, three to six numbers, remarks.
pub(crate) const MAX_TABLE_COLUMNS: usize = 64;
/// Largest distance of a hardpoint beyond the vehicle's middle plane, m: tie rods and bars are close to this plane.
pub(crate) const MAX_ACROSS_MIDDLE_PLANE: f64 = 0.05;
/// Ratio of a link length to the median of its corner above which a typing error is probable. In real corners the largest
/// ratio (trailing arms with lateral links) is below 2.
pub(crate) const MAX_LENGTH_RATIO: f64 = 2.5;
/// Smallest length, m, of a link that is reported for this ratio: ratios between short links are no sign of an error.
pub(crate) const MIN_REPORTED_LENGTH: f64 = 0.6;
/// Largest displacement of a hardpoint between variants, m: a larger one is a number in another unit.
pub(crate) const MAX_SHIFT: f64 = 0.3;
/// Largest number of points of the curve of a stop: more than a data sheet has.
pub(crate) const MAX_CURVE_POINTS: usize = 64;
/// Greatest number of powers of a stop.
pub(crate) const MAX_POWERS: usize = 10;
/// Plausible radial and axial stiffness of a bush, N/m: from a soft mount to a ball joint.
pub(crate) const BUSH_STIFFNESS: RangeInclusive<f64> = 1e4..=1e9;
/// Largest plausible loss factor of a bush: that of a hydraulic one is 0.5 to 1.
pub(crate) const MAX_LOSS_FACTOR: f64 = 1.5;
/// Relative change of the slope of the curve of a bush from which a warning is given: the tolerance of rubber rates is 15 to 20 %.
pub(crate) const CURVED_BUSH: f64 = 0.2;
/// Range about zero in which the slope of the curve of a bush is compared, m and rad: usual deflections while driving straight ahead.
pub(crate) const NEAR_ZERO_LENGTH: f64 = 1e-3;
pub(crate) const NEAR_ZERO_ANGLE: f64 = std::f64::consts::PI / 180.0;
/// Longest plausible control arm or link of a corner, m.
pub(crate) const MAX_ARM_LENGTH: f64 = 1.8;
/// Plausible radii of a loaded wheel, m: from karts to trucks.
pub(crate) const WHEEL_RADII: RangeInclusive<f64> = 0.1..=1.0;
/// Largest plausible mass of a wheel with its tyre, kg: that of a truck.
pub(crate) const MAX_WHEEL_MASS: f64 = 150.0;
/// Plausible mass of a wheel with its tyre over the cube of its radius, kg/m³: 900 for a kart, 800 for a truck, 400 for a light racing
/// car. A radius in centimetres that is read in inches, or the reverse, changes it by a factor of 16.
pub(crate) const WHEEL_DENSITIES: RangeInclusive<f64> = 165.0..=3000.0;
/// Largest plausible mass of an arm, a rod, a carrier or a spindle, kg: that of a truck's hub.
pub(crate) const MAX_PART_MASS: f64 = 150.0;
/// Largest plausible mass of an axle or a beam, kg: that of a driven axle of a truck.
pub(crate) const MAX_AXLE_MASS: f64 = 1500.0;
/// Largest plausible mass of a part over the cube of its size, kg/m³; size: `CheckedPart::size`. Arms and rods have less than 100,
/// a short rocker has 1000. A mass in grams is a thousand times as large.
pub(crate) const MAX_PART_DENSITY: f64 = 5000.0;
/// The same for a rod, which has two joints and nothing else: 21 for a tie rod of a car, 60 for a tie rod of a truck.
pub(crate) const MAX_ROD_DENSITY: f64 = 600.0;
/// Mass of a rod, kg, that is plausible for every length.
pub(crate) const LIGHT_ROD: f64 = 10.0;
/// Smallest size of a part, m, for comparisons with its mass and inertia: the joints of a spindle are at one point.
pub(crate) const MIN_PART_SIZE: f64 = 0.05;
/// Smallest ratio of tr D to tr(I − D), D = m (r² 1 − r rᵀ), at which an inertia I is probably about the origin of the vehicle.
/// An inertia about the centre of mass seldom has so large a ratio together with a valid difference I − D.
pub(crate) const LEAST_DISTANCE_TERM: f64 = 2.0;
/// Plausible radius of gyration of a part over its size: 0.29 for a rod, 0.2 to 0.6 for arms and carriers. A unit of inertia that is a
/// hundred times too small or too large changes it by a factor of ten.
pub(crate) const GYRATION_RADII: RangeInclusive<f64> = 0.04..=2.0;
/// Size of a smaller part in the upper bound of this radius, m: a carrier is larger than the distances of its joints.
pub(crate) const LEAST_CARRIER_SIZE: f64 = 0.15;
/// Plausible radius of gyration of a wheel over its radius: 0.6 to 0.85 for a wheel with its tyre.
pub(crate) const WHEEL_GYRATION_RADII: RangeInclusive<f64> = 0.15..=2.0;
/// Shortest plausible rod between an axle and the chassis, m: a wrong sign of y at one end makes a Panhard rod shorter.
pub(crate) const MIN_CENTRAL_LENGTH: f64 = 0.1;
/// Plausible positive gaps of a stop as drawn, m: stops are not adjusted to a fifth of a millimetre, and no wheel travels further.
pub(crate) const STOP_GAPS: RangeInclusive<f64> = 2e-4..=0.4;
/// Largest usual camber, rad: 10°; racing tyres run at up to 6°.
pub(crate) const MAX_CAMBER: f64 = 10.0 * RADIANS_PER_DEGREE;
/// Largest usual toe at the design position, rad: 5°; cars have below 1°.
pub(crate) const MAX_TOE: f64 = 5.0 * RADIANS_PER_DEGREE;
/// Radians per degree.
const RADIANS_PER_DEGREE: f64 = std::f64::consts::PI / 180.0;
/// Usual rates of springs, N/m: from a light motorcycle or kart to the leaf springs of trucks and the heave springs of racing cars.
pub(crate) const SPRING_RATES: RangeInclusive<f64> = 1e3..=2e6;
/// Difference of mirror images, m: the rounding of formulas of a workbook. No hardpoint is measured to a nanometre.
pub(crate) const MIRROR_TOLERANCE: f64 = 1e-9;
/// Usual rates of torsion bars, N·m/rad: from the bar on the rocker of a light racing car to that on the arm of a truck.
pub(crate) const TORSION_RATES: RangeInclusive<f64> = 50.0..=2e5;
/// Usual last speeds of the force curve of a damper, m/s.
pub(crate) const DAMPER_SPEEDS: RangeInclusive<f64> = 0.05..=20.0;
/// Usual vertical stiffnesses of tyres, N/m: from a bicycle to a truck with dual tyres.
pub(crate) const TYRE_RATES: RangeInclusive<f64> = 5e4..=3e6;
/// Usual magnitudes of the force of a spring at the design position, N: up to the springs of trucks. A smaller one is in kN.
pub(crate) const PRELOADS: RangeInclusive<f64> = 20.0..=1e5;
/// Usual compressions at the end of the curve of a stop, m: from 1 mm for a hard one to 300 mm for a long foam stop.
pub(crate) const STOP_DEPTHS: RangeInclusive<f64> = 1e-3..=0.3;
/// Usual forces at the end of the curve of a stop, N: a smaller one is in kN.
pub(crate) const STOP_FORCES: RangeInclusive<f64> = 100.0..=1e6;
/// Largest plausible track, m: vehicles on roads are at most 2.6 m wide.
pub(crate) const MAX_TRACK: f64 = 3.0;
/// Largest plausible distance of a joint of an upright from the centre of the wheel, m: more than the radius of the wheel of a truck.
pub(crate) const MAX_UPRIGHT_REACH: f64 = 0.55;
/// Largest plausible length of a spring or damper, m: that of a strut or of the fork of a motorcycle.
pub(crate) const MAX_SPRING_LENGTH: f64 = 1.0;
/// The seats of a spring are regarded as exchanged if the moving seat is farther from the joints of the moving link than the chassis seat
/// by more than this distance, m. Springs and dampers are several times as long.
pub(crate) const EXCHANGED_SEATS: f64 = 0.05;
/// Largest plausible distance of a centre of mass or a spring mount from the box around the joints of its link, m. A larger
/// distance suggests a value from another vehicle or in other axes. For a joint the limit is twice as large: one end of a
/// trailing arm is 0.7 m away from all other joints.
pub(crate) const MAX_DISTANCE_FROM_JOINTS: f64 = 0.5;

/// Distance of a centre of mass from the box around the joints of its part, m, above which a wrong sign is considered. Correct centres of
/// mass are nearer; at smaller distances, a wrong sign changes the effective mass little.
pub(crate) const LEAST_SIGN_DISTANCE: f64 = 0.1;
/// Ratio of this distance with the other sign to the distance with the given sign, below which the sign is reported as wrong: 0.34 for
/// half of a beam, 0 for arms.
pub(crate) const MAX_SIGN_DISTANCE_RATIO: f64 = 0.4;
/// Ratio of a mass in grams to the same mass in kilograms.
pub(crate) const GRAMS_PER_KILOGRAM: f64 = 1000.0;
/// Share of parts that are too heavy, from which all masses are regarded as grams; a smaller share indicates typing errors.
pub(crate) const LEAST_SHARE_IN_GRAMS: f64 = 0.5;
/// Largest distance between two positions of one hardpoint, m: rounding of differences of positions.
pub(crate) const SAME_POINT: f64 = 1e-9;
/// Median length of the links of a corner, m, above which a small track is no sign of a wrong unit of the file.
pub(crate) const MIN_LINK_LENGTH: f64 = 0.1;
/// Resolution of lengths in messages, m.
pub(crate) const MESSAGE_LENGTH: f64 = 1e-4;

/// Limits of XLSX workbooks.
#[cfg(feature = "xlsx")]
pub(crate) mod workbook {
    /// Largest workbook, bytes: a table of hardpoints has some 10 kB.
    pub(crate) const MAX_WORKBOOK_BYTES: usize = 512 << 10;
    /// Largest total size of the unpacked parts of a workbook, bytes: workbooks are usually compressed five- to twentyfold.
    pub(crate) const MAX_UNPACKED_BYTES: usize = 16 << 20;
    /// Largest number of parts of a workbook: a few per sheet, one per picture.
    pub(crate) const MAX_WORKBOOK_PARTS: usize = 10_000;
    /// Largest number of cell formats of a workbook, twice the limit of spreadsheet programs: the count is the number of
    /// occurrences of `xf` in the text of the part.
    pub(crate) const MAX_CELL_FORMATS: usize = 1 << 17;
    /// Upper bound of the number of cell formats times the length of the longest element in their part, bytes.
    pub(crate) const MAX_CELL_FORMAT_BYTES: usize = 64 << 20;
    /// Largest index of a shared formula; spreadsheet programs number them from 0 in each worksheet.
    pub(crate) const MAX_SHARED_FORMULAS: usize = 1 << 16;
    /// Largest total size of the texts in the cells that are read, bytes: a name and remarks per row.
    pub(crate) const MAX_TABLE_TEXT_BYTES: usize = 16 << 20;
    /// Largest number of visited cells of a worksheet.
    pub(crate) const MAX_WORKSHEET_CELLS: usize = 1_000_000;
}

/// Largest distance (m) from the middle plane of a wheel that is in this plane: roundings of sums of coordinates.
pub(crate) const MIDDLE_PLANE: f64 = 1e-9;

/// Least rate of the tilt of a wheel, rad/m, for an instant centre: one that is farther away than 10,000 km is at infinity.
pub(crate) const LEAST_TILT_RATE: f64 = 1e-7;
