//! Results of an impact in time.

use crate::motion::joint_rates::JointRates;
use crate::reactions::reaction::Reactions;
use percuss_spatial::Transform;

/// State of an impact at one time.
#[derive(Clone, Debug)]
pub struct ImpactSample {
    /// Time since the touch, s.
    pub time: f64,
    /// Penetration δ: integral of the closing speed, m.
    pub penetration: f64,
    /// Closing speed δ̇, m/s.
    pub rate: f64,
    /// Force of the contact, N: −F n̂ acts on the contact link.
    pub force: f64,
    /// m̄ of the contact at this pose, kg; `None` if it is not finite.
    pub effective_mass: Option<f64>,
    /// Largest gap of the loops, m: error of the integration.
    pub loop_gap: f64,
    /// Positions of all joints (layout of [`Pose::positions`](percuss_dynamics::Pose::positions)), rad and m.
    pub positions: Vec<f64>,
    /// X_wr: pose of the root link in the world.
    pub base: Transform<f64>,
    /// Rates of all joints.
    pub rates: JointRates,
    /// Forces (N) and moments (N·m) in all joints and loops.
    pub reactions: Reactions,
}

/// Energies of an impact in time, J. Kinetic energies include a free body on the other side.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyBalance {
    /// Kinetic energy at the touch.
    pub kinetic_before: f64,
    /// Kinetic energy at the end of the contact.
    pub kinetic_after: f64,
    /// Work ∫ F δ̇ dt that the contact takes.
    pub taken_by_contact: f64,
    /// Work of gravity, springs and dampers on the mechanism.
    pub work_of_other_forces: f64,
}

impl EnergyBalance {
    /// Error of the balance, J: kinetic energy after − before + taken by the contact − work of the other forces.
    pub fn residual(self) -> f64 {
        self.kinetic_after - self.kinetic_before + self.taken_by_contact - self.work_of_other_forces
    }
}

/// Second touch of the sides after the end of a contact, at the position of the first touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondTouch {
    /// Time after the end of the contact, s.
    pub after_end: f64,
    /// Closing speed, m/s.
    pub closing_speed: f64,
}

/// Impact in time, from the touch to the separation.
#[derive(Clone, Debug)]
pub struct ImpactInTime {
    /// Separation speed divided by closing speed; 0 if the sides do not separate.
    pub restitution: f64,
    /// Duration of the contact, s; time of the last sample if the sides do not separate.
    pub duration: f64,
    /// False if the sides do not separate: a strongly damped return, or a load that presses them together. The motion ends when the closing and
    /// opening speed stay below a thousandth of the closing speed at the touch.
    pub separates: bool,
    /// Largest penetration, m.
    pub max_penetration: f64,
    /// Largest force, N.
    pub peak_force: f64,
    /// Largest force (N) in each bearing and its time (s), in the order of [`Reactions::determinate_forces`]; computed with samples within the steps.
    pub bearing_peaks: Vec<(f64, f64)>,
    /// m̄ at the largest penetration, kg; `None` if it is not finite.
    pub mass_at_max_penetration: Option<f64>,
    /// Energies of the motion.
    pub energy: EnergyBalance,
    /// Second touch within three durations of the contact after its end, which springs or gravity cause; computed with samples within the steps.
    pub second_touch: Option<SecondTouch>,
    /// Samples at the steps of the integration; the last one is the end of the contact.
    pub samples: Vec<ImpactSample>,
}

/// Largest value of a smooth quantity and its time: vertex of the parabola through the largest sample and its neighbours. A quantity that jumps
/// has two samples at one time. `None` without samples.
///
/// # Panics
/// If there are fewer times than values.
pub fn peak_over_time(times: &[f64], values: &[f64]) -> Option<(f64, f64)> {
    let best = (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
    let (time, largest) = (times[best], values[best]);
    let jumps = |k: usize| times[k] == time;
    if best == 0 || best + 1 >= values.len() || jumps(best - 1) || jumps(best + 1) {
        return Some((largest, time));
    }
    let point = |k: usize| (times[k] - time, values[k] - largest);
    let ((a, fa), (b, fb)) = (point(best - 1), point(best + 1));
    // f = s t + c t² through both neighbours.
    let c = (fa / a - fb / b) / (a - b);
    let s = fa / a - c * a;
    Some(if c < 0.0 { (largest - s * s / (4.0 * c), time - s / (2.0 * c)) } else { (largest, time) })
}
