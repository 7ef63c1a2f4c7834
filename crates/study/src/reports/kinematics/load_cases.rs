//! Loads of the motions per load, in words and numbers.

use percuss_suspension::kinematics::{ComplianceLoads, LoadCase, LoadedWheels};
use schemars::JsonSchema;
use serde::Serialize;

/// Loads of the motions per load: elastokinematics.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct KinematicLoads {
    /// `single`: the wheel of the quantity alone, on the right wheel the mirror image of the load on the left; `parallel`: both wheels, the same
    /// vector; `opposed`: both wheels, opposite vectors.
    pub wheels: &'static str,
    /// True if the heights of the wheel centres are held; false if springs, touched stops and anti-roll bar hold the wheels.
    pub travel_held: bool,
    /// Loads of the columns. The wheels are locked to their carriers, and the tyres are left out.
    pub cases: Vec<KinematicLoadCase>,
}

/// Load on the wheels.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct KinematicLoadCase {
    /// Name in the columns.
    pub name: &'static str,
    /// `contact point` or `wheel centre` of a force, `wheel` of a moment.
    pub acts_at: &'static str,
    /// Direction of a positive load, on the left wheel.
    pub direction: &'static str,
    /// Force (N) or moment (N·m) on the left wheel, axes of the vehicle.
    pub left: [f64; 3],
    /// Force or moment on the right wheel; for `single`, that of the columns of the right wheel.
    pub right: [f64; 3],
}

impl KinematicLoads {
    /// Loads of a question.
    pub(crate) fn of(loads: ComplianceLoads) -> Self {
        let wheels = match loads.wheels {
            LoadedWheels::Single => "single",
            LoadedWheels::Parallel => "parallel",
            LoadedWheels::Opposed => "opposed",
        };
        let case = |case: LoadCase| KinematicLoadCase {
            name: case.name,
            acts_at: match (case.is_moment, case.is_at_centre) {
                (true, _) => "wheel",
                (false, true) => "wheel centre",
                (false, false) => "contact point",
            },
            direction: case.direction,
            left: case.vector.into(),
            // Adding 0 turns −0 into 0.
            right: (case.vector * case.factor_on_right(loads.wheels)).add_scalar(0.0).into(),
        };
        Self { wheels, travel_held: loads.travel_held, cases: LoadCase::all().map(case).to_vec() }
    }

    /// Loaded wheels and their support in a few words, for figures.
    pub fn wheels_text(&self) -> String {
        let wheels = match self.wheels {
            "parallel" => "the same load on both wheels",
            "opposed" => "opposite loads on both wheels, positive on the left",
            _ => "load on a single wheel, on the right its mirror image",
        };
        let held = if self.travel_held { "at held height" } else { "held by the springs" };
        format!("{wheels}; wheels {held}, locked to their carriers, without tyres")
    }

    /// Loads in a sentence.
    pub fn text(&self) -> String {
        let case = |case: &KinematicLoadCase| {
            format!("{} {} at the {}", case.name.replace('_', " "), case.direction, case.acts_at)
        };
        let cases: Vec<String> = self.cases.iter().map(case).collect();
        format!("{}; {}", self.wheels_text(), cases.join(", "))
    }
}
