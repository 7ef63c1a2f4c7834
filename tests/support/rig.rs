//! A linkage for tests: driven along its branch, contacts by link name, compared with the oracle.

use nalgebra::{Vector2, Vector3};
use percuss_dynamics::{
    AssemblyError, Base, Conditions, Configuration, Contact, ContactResponse, Direction, EffectiveMass,
    Frame, Pose, System,
};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use percuss_oracle::linkage::{self, Linkage};
use percuss_oracle::{maximal, random};
use std::sync::Arc;

/// A linkage with its system.
#[derive(Debug)]
pub struct Rig {
    /// Name of the linkage.
    pub name: &'static str,
    /// The mechanism.
    pub mechanism: Arc<Mechanism>,
    /// System under the conditions.
    pub system: System,
    /// Driving joints.
    pub drivers: Vec<String>,
    /// Range of each driver.
    pub range: Vec<[f64; 2]>,
    /// A position close to a closed pose.
    pub start: Vec<Vec<f64>>,
}

/// Methods panic on invalid arguments and unexpected results.
impl Rig {
    /// Fixed base, all joints free.
    pub fn new(linkage: Linkage) -> Self {
        Self::under(linkage, &Conditions::new())
    }

    /// Under conditions.
    pub fn under(linkage: Linkage, conditions: &Conditions) -> Self {
        let Linkage { name, mechanism, drivers, start: near, range } = linkage;
        let mut start = random::zero_positions(&mechanism);
        for (joint, value) in &near {
            start[mechanism.find_joint(joint).expect("a joint").index()].clone_from(value);
        }
        random::follow(&mechanism, &mut start);
        let mechanism = Arc::new(mechanism);
        let system = System::new(Arc::clone(&mechanism), conditions).expect("conditions that fit");
        Self { name, mechanism, system, drivers, range, start }
    }

    /// The same linkage under other conditions.
    pub fn with(&self, conditions: &Conditions) -> System {
        System::new(Arc::clone(&self.mechanism), conditions).expect("conditions that fit")
    }

    /// A joint by name.
    pub fn joint(&self, name: &str) -> JointId {
        self.mechanism.find_joint(name).expect("a joint")
    }

    /// Positions of the drivers at the start.
    pub fn start_drivers(&self) -> Vec<f64> {
        self.drivers.iter().map(|name| self.start[self.joint(name).index()][0]).collect()
    }

    /// Configuration with these driver values.
    pub fn configuration(&self, drivers: &[f64]) -> Configuration {
        let mut configuration = self.system.configuration();
        for (name, value) in self.drivers.iter().zip(drivers) {
            configuration.set(name, &[*value]).expect("a driver");
        }
        configuration
    }

    /// Configuration with these driver values and guesses for all other joints.
    pub fn guessed(&self, drivers: &[f64], guess: &[Vec<f64>]) -> Configuration {
        let mut configuration = self.configuration(drivers);
        for (id, q) in self.mechanism.joint_ids().zip(guess) {
            let joint = self.mechanism.joint(id);
            let moves = joint.kind() != JointKind::Fixed && joint.mimic().is_none();
            if moves && !self.drivers.iter().any(|name| name == joint.name()) {
                configuration.guess(joint.name(), q).expect("a position that fits");
            }
        }
        configuration
    }

    /// The closed pose at the start.
    pub fn closed(&self) -> Pose {
        let configuration = self.guessed(&self.start_drivers(), &self.start);
        self.system.pose(&configuration).unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }

    /// Follows the branch to the drivers' values.
    pub fn move_drivers(&self, from: &Pose, drivers: &[f64]) -> Result<Pose, AssemblyError> {
        self.system.pose_from(from, &self.configuration(drivers))
    }

    /// Follows the branch to reachable driver values.
    #[track_caller]
    pub fn reach(&self, from: &Pose, drivers: &[f64]) -> Pose {
        self.move_drivers(from, drivers)
            .unwrap_or_else(|error| panic!("{} at {drivers:?}: {error}", self.name))
    }

    /// Driver values at a fraction of their ranges.
    pub fn at(&self, part: f64) -> Vec<f64> {
        self.range.iter().map(|[from, to]| from + part * (to - from)).collect()
    }

    /// Contact of a point (m) of a link with the ground, with the normal in the root's axes.
    pub fn contact(&self, link: &str, point: [f64; 3], normal: Vector3<f64>) -> Contact {
        let link = self.mechanism.find_link(link).expect("a link");
        Contact::new(link, point, normal).normal(Direction::Along(normal, Frame::World))
    }

    /// The response at a pose.
    pub fn respond(&self, pose: &Pose, contact: &Contact) -> ContactResponse {
        pose.respond(contact).expect("an answer")
    }

    /// Closure error by the oracle, relative to the mechanism's size.
    pub fn open(&self, pose: &Pose) -> f64 {
        let residual = maximal::residual(&self.mechanism, &positions(&self.mechanism, pose));
        residual / self.mechanism.characteristic_length()
    }
}

/// Positions of a pose, one list per joint.
pub fn positions(mechanism: &Mechanism, pose: &Pose) -> Vec<Vec<f64>> {
    mechanism.joint_ids().map(|id| pose.joint(id).to_vec()).collect()
}

/// The question for route C at a pose.
pub fn question<'a>(
    system: &System,
    mechanism: &'a Mechanism,
    pose: &Pose,
    contact: &Contact,
) -> maximal::Question<'a> {
    let located = pose.locate(contact).expect("a contact");
    maximal::Question {
        floating_base: system.base() == Base::Floating,
        against: located.against,
        is_moment: located.is_moment,
        ..maximal::Question::new(
            mechanism,
            positions(mechanism, pose),
            located.link,
            located.point_link,
            located.normal_world,
        )
    }
}

/// Direction in the plane of the planar linkages, in the ground's axes.
pub fn in_plane(n: Vector2<f64>) -> Vector3<f64> {
    linkage::plane().vector(&n.push(0.0))
}

/// m̄ (kg), which must be finite.
#[track_caller]
pub fn mass(response: &ContactResponse) -> f64 {
    match response.effective_mass {
        EffectiveMass::Finite(m) => m,
        other => panic!("{other:?}"),
    }
}
