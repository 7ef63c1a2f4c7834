//! Local searches for an extreme along a path of the driving joints.

use crate::ranges::extreme_question::{DriverPath, JointRange};
use crate::ranges::extremes_error::ExtremesError;
use crate::ranges::quasi_newton::Point;
use crate::ranges::search::{Search, Variable};
use percuss_dynamics::Pose;

/// Smallest number of samples of a path. Each segment has at least two samples: its first row and its middle.
const LEAST_SAMPLES: usize = 256;
/// Largest number of local searches.
const MOST_SEARCHES: usize = 32;

/// Search along the straight lines between the rows of a path.
pub(super) struct PathSearch<'a> {
    search: Search<'a>,
    /// Motion of the joints in each segment between two rows.
    segments: Vec<Vec<JointRange>>,
}

/// Result of a local search: a point of a segment. Its only variable is 0 at the first row of the segment and 1 at the second.
pub(super) struct PathEnd {
    pub segment: usize,
    pub point: Point,
}

impl PathEnd {
    /// Fractional row number, from 0.
    pub fn row(&self) -> f64 {
        self.segment as f64 + self.point.unit[0]
    }
}

/// Sample of a path.
struct Sample {
    segment: usize,
    unit: f64,
    /// Sign times measure, to be minimised; infinite for a pose without a finite value.
    value: f64,
    pose: Option<Pose>,
}

impl<'a> PathSearch<'a> {
    /// Search along a path of at least one row. `search` has no variables.
    pub fn new(search: Search<'a>, path: &DriverPath) -> Self {
        let segment = |from: &[f64], to: &[f64]| -> Vec<JointRange> {
            let ends = path.joints.iter().zip(from.iter().zip(to));
            ends.map(|(&joint, (&lower, &upper))| JointRange { joint, lower, upper }).collect()
        };
        let segments: Vec<Vec<JointRange>> = match path.rows {
            [row] => vec![segment(row, row)],
            rows => rows.windows(2).map(|pair| segment(&pair[0], &pair[1])).collect(),
        };
        Self { search, segments }
    }

    /// The same search for the effective mass of the contact.
    pub fn of_masses(&self) -> Self {
        let search = Search { work: self.search.work.clone(), ..self.search.of_masses() };
        Self { search, segments: self.segments.clone() }
    }

    /// Search within a segment.
    pub fn segment(&self, number: usize) -> Search<'a> {
        Search { variables: vec![Variable { moves: self.segments[number].clone() }], ..self.search.clone() }
    }

    /// True if all joints rest in a segment.
    fn is_at_rest(&self, number: usize) -> bool {
        self.segments[number].iter().all(|range| range.lower == range.upper)
    }

    /// Ends of the local searches, and the largest measure of all points.
    pub fn run(&self) -> Result<(Vec<PathEnd>, f64), ExtremesError> {
        let (samples, largest) = self.local_extremes();
        let mut largest = largest;
        let mut ends = Vec::new();
        for sample in &samples {
            // A row is the end of one segment and the beginning of the next.
            let previous = sample.segment.checked_sub(1).filter(|_| sample.unit == 0.0);
            let places = [Some((sample.segment, sample.unit)), previous.map(|segment| (segment, 1.0))];
            let mut of_sample: Vec<PathEnd> = Vec::new();
            for (segment, unit) in places.into_iter().flatten() {
                let search = self.segment(segment);
                let found = if self.is_at_rest(segment) {
                    search
                        .point(vec![unit], sample.pose.as_ref())?
                        .map(|(point, _)| (point.clone(), point.inverse_mass))
                } else {
                    search.run(vec![unit], largest, sample.pose.as_ref())?
                };
                if let Some((point, at_start)) = found {
                    largest = largest.max(at_start).max(point.inverse_mass);
                    of_sample.push(PathEnd { segment, point });
                }
            }
            let better = |a: &PathEnd, b: &PathEnd| a.point.value.total_cmp(&b.point.value);
            ends.extend(of_sample.into_iter().min_by(better));
        }
        Ok((ends, largest))
    }

    /// Returns the best `MOST_SEARCHES` samples that are at least as good as both neighbours, and the largest measure of all samples.
    fn local_extremes(&self) -> (Vec<Sample>, f64) {
        let count = LEAST_SAMPLES.div_ceil(self.segments.len()).max(2);
        let mut largest: f64 = 0.0;
        let mut best: Vec<Sample> = Vec::new();
        let mut last: Option<Pose> = None;
        // Value of the sample before `current`; the latest sample, whose successor is not known yet.
        let (mut before, mut current): (f64, Option<Sample>) = (f64::INFINITY, None);
        let mut keep = |sample: Sample, before: f64, after: f64| {
            if sample.value.is_finite() && sample.value <= before && sample.value <= after {
                best.push(sample);
                if best.len() > 2 * MOST_SEARCHES {
                    best.sort_by(|a, b| a.value.total_cmp(&b.value));
                    best.truncate(MOST_SEARCHES);
                }
            }
        };
        for number in 0..self.segments.len() {
            let search = self.segment(number);
            let is_last = number + 1 == self.segments.len();
            for k in 0..count + usize::from(is_last) {
                let unit = k as f64 / count as f64;
                let pose = search.pose(&[unit], last.as_ref()).ok();
                let measure = pose.as_ref().and_then(|pose| search.measure(pose));
                largest = largest.max(measure.unwrap_or(0.0));
                let value = measure.map_or(f64::INFINITY, |measure| search.sign() * measure);
                last = pose.clone().or(last);
                let next = Sample { segment: number, unit, value, pose };
                if let Some(sample) = current.take() {
                    let own = sample.value;
                    keep(sample, before, value);
                    before = own;
                }
                current = Some(next);
            }
        }
        if let Some(sample) = current {
            keep(sample, before, f64::INFINITY);
        }
        best.sort_by(|a, b| a.value.total_cmp(&b.value));
        best.truncate(MOST_SEARCHES);
        (best, largest)
    }
}
