//! Common parts of the benchmarks: systems with configurations and contacts.

mod cpu_time;
mod tasks;

pub use cpu_time::{CpuTime, criterion};
pub use tasks::{Task, task};

use percuss_dynamics::{Conditions, Contact, Direction, System};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions, Source, load};
use percuss_mechanism::Mechanism;
use percuss_oracle::{random, zoo};
use rand::SeedableRng;
use rand::rngs::StdRng;
use std::fmt::Write;

/// System with a contact and many configurations.
pub struct Subject {
    /// Name.
    pub name: &'static str,
    /// The system.
    pub system: System,
    /// Positions of all joints in sequence, for 256 configurations.
    pub positions: Vec<Vec<f64>>,
    /// The contact.
    pub contact: Contact,
}

impl Subject {
    fn new(name: &'static str, mechanism: Mechanism) -> Self {
        let mut rng = StdRng::seed_from_u64(7);
        let positions = (0..256).map(|_| random::positions(&mut rng, &mechanism).concat()).collect();
        // Contact near the origin of the last link of the tree.
        let link = *mechanism.order().last().expect("a mechanism has links");
        let contact = Contact::new(link, [0.05, -0.02, 0.03], [0.3, -0.5, 0.8]);
        let system = System::new(mechanism, &Conditions::new()).expect("default conditions fit");
        Self { name, system, positions, contact }
    }
}

/// Six-hinge arm, and a random tree of 30 bodies without mimics.
pub fn subjects() -> Vec<Subject> {
    let tree = (0..).find_map(|seed| {
        let mechanism = random::mechanism(&mut StdRng::seed_from_u64(seed), 30);
        mechanism.joints().iter().all(|j| j.mimic().is_none()).then_some(mechanism)
    });
    vec![
        Subject::new("six_r_arm", zoo::six_r_arm()),
        Subject::new("tree_of_30", tree.expect("some seed has no mimic")),
    ]
}

/// Double wishbone model of the distribution, with the contact of its bump stop on the chassis, and its driving
/// joint.
pub fn double_wishbone() -> (System, Contact, &'static str) {
    let text = include_str!("../models/double_wishbone.urdf");
    let mechanism = loaded(text);
    let link = |name: &str| mechanism.find_link(name).expect("a link of the model");
    let contact = Contact::new(link("bump_stop_pad"), [0.0; 3], [0.0, 0.0, 1.0])
        .against(link("chassis"))
        .normal(Direction::Toward(link("bump_stop"), [0.0; 3].into()));
    let system = System::new(mechanism, &Conditions::new()).expect("default conditions fit");
    (system, contact, "lower_arm_hinge")
}

/// URDF of a chain with this number of links, with shapes.
pub fn chain_urdf(links: usize) -> String {
    let mut text = String::from("<?xml version=\"1.0\"?>\n<robot name=\"chain\">\n");
    for i in 0..links {
        let _ = write!(
            text,
            "  <link name=\"link_{i}\">\n    <inertial>\n      <origin xyz=\"0.05 0 0\" rpy=\"0 0 0\"/>\n      \
             <mass value=\"1.25\"/>\n      <inertia ixx=\"0.001\" ixy=\"0\" ixz=\"0\" iyy=\"0.002\" iyz=\"0\" \
             izz=\"0.0025\"/>\n    </inertial>\n    <visual>\n      <origin xyz=\"0.05 0 0\" rpy=\"0 0 0\"/>\n      \
             <geometry>\n        <box size=\"0.1 0.02 0.02\"/>\n      </geometry>\n    </visual>\n  </link>\n"
        );
        if i > 0 {
            let _ = write!(
                text,
                "  <joint name=\"joint_{i}\" type=\"revolute\">\n    <parent link=\"link_{}\"/>\n    <child \
                 link=\"link_{i}\"/>\n    <origin xyz=\"0.1 0 0\" rpy=\"0 0 0\"/>\n    <axis xyz=\"0 0 1\"/>\n    \
                 <limit lower=\"-1\" upper=\"1\" effort=\"10\" velocity=\"1\"/>\n  </joint>\n",
                i - 1
            );
        }
    }
    text + "</robot>\n"
}

/// Loads a URDF from text.
pub fn loaded(text: &str) -> Mechanism {
    assert!((text.len() as u64) < DEFAULT_MAX_SIZE);
    load(&Source::from_text("bench.urdf", text), &LoadOptions::default()).expect("a good file").mechanism
}
