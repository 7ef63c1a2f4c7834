//! Random joint positions within the limits. The numbers are the same on every machine, and a row does not
//! depend on other rows.

use crate::evaluation::prepared_question::PreparedQuestion;
use crate::question::errors::question_error::{Fault, StudyError};
use percuss_mechanism::{JointId, JointKind};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use std::f64::consts::PI;

/// Distribution of the position of a joint.
#[derive(Clone, Copy, Debug)]
enum SampleDistribution {
    /// Uniform between the limits.
    Between { lower: f64, upper: f64 },
    /// Uniform over all orientations.
    RandomOrientation,
}

/// Rows of random positions.
#[derive(Debug)]
pub(crate) struct RandomRows {
    pub joints: Vec<JointId>,
    ranges: Vec<SampleDistribution>,
    pub width: usize,
    pub count: usize,
    pub seed: u64,
}

impl RandomRows {
    /// Random rows for the free joints: joints that the question does not set; within loops, only the driving
    /// joints.
    pub fn new(prepared: &PreparedQuestion, count: usize, seed: u64) -> Result<Self, StudyError> {
        let (system, question) = (&prepared.system, &*prepared.question);
        let mechanism = system.mechanism();
        let pose = system.pose(&prepared.configuration)?;
        let drivers = pose.loops().map_or(&[][..], |loops| &loops.drivers);
        let is_free = |joint: &JointId| {
            let found = mechanism.joint(*joint);
            let positions = found.kind().positions();
            // A single component of a spherical joint that drives a loop cannot be set.
            let drives = !system.is_bound(*joint) || (drivers.contains(joint) && positions == 1);
            let set = question.pose.set.iter().any(|(set, _)| set == found.name());
            positions > 0 && found.mimic().is_none() && drives && !set
        };
        let joints: Vec<JointId> = mechanism.joint_ids().filter(is_free).collect();
        let refuse = |fault: Fault| StudyError::input("sweep.random", fault);
        if joints.is_empty() {
            let why = "no joint can be sampled: all movable joints are set, or depend on other joints";
            return Err(refuse(why.into()));
        }
        let range = |&joint: &JointId| {
            let found = mechanism.joint(joint);
            let limits = found.limits().filter(|l| (l.upper - l.lower).is_finite());
            match (found.kind(), limits) {
                (JointKind::Spherical, _) => Ok(SampleDistribution::RandomOrientation),
                (JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic, Some(limits)) => {
                    Ok(SampleDistribution::Between { lower: limits.lower, upper: limits.upper })
                }
                (JointKind::Continuous, None) => Ok(SampleDistribution::Between { lower: -PI, upper: PI }),
                (kind, _) => Err(refuse(Fault::NothingToSampleBetween { joint: found.name().into(), kind })),
            }
        };
        let ranges = joints.iter().map(range).collect::<Result<Vec<_>, _>>()?;
        let width = joints.iter().map(|joint| mechanism.joint(*joint).kind().positions()).sum();
        Ok(Self { joints, ranges, width, count, seed })
    }

    /// Appends the numbers of a row, from a [`RandomStream`] with the row number as the stream.
    pub fn append_row(&self, row: usize, values: &mut Vec<f64>) {
        let RandomStream(mut generator) = RandomStream::new(self.seed, row as u64);
        for range in &self.ranges {
            match *range {
                SampleDistribution::Between { lower, upper } => {
                    values.push((lower + (upper - lower) * unit(&mut generator)).min(upper));
                }
                SampleDistribution::RandomOrientation => values.extend(orientation(&mut generator)),
            }
        }
    }
}

/// Uniform random numbers in [0, 1) from a seed and a stream; the same on every machine.
#[derive(Debug)]
pub(crate) struct RandomStream(ChaCha8Rng);

impl RandomStream {
    /// ChaCha with 8 rounds; the key is the seed (eight bytes, little-endian) followed by zeros. The sequence
    /// is specified, in contrast to a general-purpose generator, which may change between versions.
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        let mut generator = ChaCha8Rng::from_seed(key);
        generator.set_stream(stream);
        Self(generator)
    }

    /// Next number.
    pub fn next(&mut self) -> f64 {
        unit(&mut self.0)
    }
}

/// Random number in [0, 1) with 53 random bits.
fn unit(generator: &mut ChaCha8Rng) -> f64 {
    (generator.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// Random unit quaternion w,x,y,z, uniform over all orientations. Source: Marsaglia 1972, "Choosing a point
/// from the surface of a sphere". The method uses only operations with identical results on every machine; sines
/// differ between machines.
fn orientation(generator: &mut ChaCha8Rng) -> [f64; 4] {
    let mut in_disc = || {
        loop {
            let [x, y] = [(); 2].map(|()| 2.0 * unit(generator) - 1.0);
            let square = x * x + y * y;
            if square < 1.0 && square > 0.0 {
                return (x, y, square);
            }
        }
    };
    let ((w, x, first), (y, z, second)) = (in_disc(), in_disc());
    let scale = ((1.0 - first) / second).sqrt();
    [w, x, y * scale, z * scale]
}
