//! Tasks for timing and for counting instructions: prepared once, run repeatedly.

use crate::{Subject, chain_urdf, double_wishbone, loaded, subjects};
use percuss_dynamics::{
    Batch, BatchPositions, Conditions, Contact, Direction, EffectiveMass, Frame, Pose, RowColumns,
    RowResults, System,
};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_impact::{ImpactWorkspace, JointRates, RigidImpact, TimeConditions, impact_in_time};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_oracle::linkage;
use percuss_oracle::linkage::Linkage;
use percuss_spatial::lanes::Instructions;
use percuss_spatial::{Matrix3, Vector3};
use percuss_study::{Model, ask};
use std::hint::black_box;

/// Benchmark task.
pub struct Task {
    /// Runs the task once.
    pub run: Box<dyn FnMut()>,
    /// Number of work units per run: configurations or files.
    pub units: usize,
    /// Number of bodies per unit.
    pub bodies: usize,
}

/// Configurations per call.
const CONFIGURATIONS: usize = 256;

/// Returns the task with this name; `chain-N`, `chain-lanes-N`, `separate-N` and `ladder-N` have a size.
///
/// | name | work unit |
/// |---|---|
/// | `scalar` | m̄ of a six-hinge arm at a new configuration |
/// | `workspace` | m̄ of a random tree of 30 bodies at a new configuration, by the general recursion |
/// | `lanes` | as `scalar`, in lanes of AVX2 (of the baseline without AVX2) |
/// | `portable` | as `scalar`, in lanes of the baseline |
/// | `response` | complete response at a closed pose of the double wishbone, with error budget |
/// | `linkage` | m̄ of the double wishbone at a closed pose |
/// | `step` | closing the loops of the double wishbone 1 mrad from the last pose |
/// | `load` | reading a URDF of 1,000 links |
/// | `moment`, `line` | as `scalar`, for a moment about an axis, and for the line to a point of the ground |
/// | `gradient` | as `lanes`, with the gradient |
/// | `response-arm` | complete response of a six-hinge arm at a pose |
/// | `impact`, `impact-arm` | a single rigid impact of the double wishbone, of the arm, with all reactions |
/// | `impact-pose`, `impact-pose-arm` | the same in a workspace at a new pose |
/// | `impact-time`, `impact-time-arm` | an impact in time with all reactions of all samples |
/// | `ask-KEY` | a question about the double wishbone of the suspension sheets: [`QUESTIONS`] |
/// | `chain-N` | m̄ at the end of a chain of N hinges, one configuration |
/// | `chain-lanes-N` | as `chain-N`, in lanes |
/// | `separate-N` | m̄ at one of N independent four-bars |
/// | `ladder-N` | m̄ at the middle of a ladder of N four-bars, in which consecutive loops share a link |
pub fn task(name: &str) -> Option<Task> {
    let avx2 = if Instructions::Avx2.is_available() { Instructions::Avx2 } else { Instructions::Baseline };
    let arm = || subjects().swap_remove(0);
    Some(match name {
        "scalar" => scalar(arm()),
        "workspace" => workspace(subjects().swap_remove(1)),
        "lanes" => lanes(arm(), avx2),
        "portable" => lanes(arm(), Instructions::Baseline),
        "response" => response(),
        "linkage" => closed(),
        "step" => step(),
        "load" => load(),
        "moment" => {
            let arm = arm();
            let contact = arm.contact.normal(Direction::About(Vector3::new(0.3, -0.5, 0.8), Frame::Link));
            scalar(Subject { contact, ..arm })
        }
        "line" => {
            let arm = arm();
            let root = arm.system.mechanism().root();
            let contact = arm.contact.normal(Direction::TurningToward(root, Vector3::new(1.5, 0.3, 2.0)));
            scalar(Subject { contact, ..arm })
        }
        "gradient" => gradient(arm()),
        "response-arm" => respond_arm(),
        "impact" => impacts(&wishbone_poses(), false),
        "impact-arm" => impacts(&arm_poses(), false),
        "impact-pose" => impacts(&wishbone_poses(), true),
        "impact-pose-arm" => impacts(&arm_poses(), true),
        "impact-time" => impact_over_time(&wishbone_poses()),
        "impact-time-arm" => impact_over_time(&arm_poses()),
        _ if name.starts_with("ask-") => question(name.strip_prefix("ask-")?)?,
        _ => {
            let (kind, size) = name.rsplit_once('-')?;
            let size = size.parse().ok().filter(|size| *size > 0)?;
            match kind {
                "chain" => scalar(chain(size)),
                "chain-lanes" => lanes(chain(size), avx2),
                "separate" => loops(linkage::separate(size), "coupler_1"),
                "ladder" => loops(linkage::ladder(size), &format!("coupler_{}", size.div_ceil(2))),
                _ => return None,
            }
        }
    })
}

/// Chain of hinges about alternating axes with a contact at the end.
fn chain(bodies: usize) -> Subject {
    let mut builder = MechanismBuilder::new("chain").link(LinkDescription::massless("b0"));
    for i in 1..=bodies {
        let name = format!("b{i}");
        let about_com = Matrix3::from_diagonal(&Vector3::new(0.001, 0.002, 0.0025));
        let inertial = Inertial { mass: 1.25, com: Vector3::new(0.05, 0.01, -0.02), about_com };
        let axis = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.6, 0.0, 0.8]][i % 3];
        let hinge =
            JointDescription::new(format!("j{i}"), JointKind::Continuous, format!("b{}", i - 1), &name);
        builder =
            builder.link(LinkDescription::new(name, inertial)).joint(hinge.axis(axis).at([0.1, 0.0, 0.02]));
    }
    let mechanism: Mechanism = builder.build().expect("a chain").mechanism;
    let end = mechanism.find_link(&format!("b{bodies}")).expect("its end");
    let contact = Contact::new(end, [0.05, -0.02, 0.03], [0.3, -0.5, 0.8]);
    // Small angles keep a long chain extended: randomly folded, the effective mass at the end would be that of
    // a few links.
    let angle = |c: usize, i: usize| 0.3 * ((c * 7919 + i * 104_729) % 1000) as f64 / 1000.0;
    let row = |c: usize| (0..bodies).map(|i| angle(c, i)).collect();
    let system = System::new(mechanism, &Conditions::new()).expect("default conditions fit");
    let count = (1 << 21) / bodies;
    Subject {
        name: "chain",
        system,
        positions: (0..count.clamp(16, CONFIGURATIONS)).map(row).collect(),
        contact,
    }
}

fn batch(subject: &Subject) -> Batch {
    subject.system.reference_or_open().batch(&subject.contact).expect("a contact that fits")
}

fn bodies(subject: &Subject) -> usize {
    subject.system.mechanism().joints().len()
}

fn scalar(subject: Subject) -> Task {
    let (mut batch, bodies) = (batch(&subject), bodies(&subject));
    let units = subject.positions.len();
    let run = move || {
        for row in &subject.positions {
            let answer = batch.effective_mass(black_box(row)).expect("positions that fit");
            assert!(matches!(answer.mass, Some(EffectiveMass::Finite(m)) if m > 0.0));
        }
    };
    Task { run: Box::new(run), units, bodies }
}

fn workspace(subject: Subject) -> Task {
    let (mut workspace, bodies) = (subject.system.reference_or_open().workspace(), bodies(&subject));
    let units = subject.positions.len();
    let run = move || {
        for row in &subject.positions {
            workspace.set_positions(black_box(row)).expect("positions that fit");
            _ = black_box(workspace.effective_mass(&subject.contact));
        }
    };
    Task { run: Box::new(run), units, bodies }
}

fn lanes(subject: Subject, set: Instructions) -> Task {
    let (batch, bodies) = (batch(&subject).with_instructions(set), bodies(&subject));
    assert!(batch.has_lanes());
    let units = subject.positions.len();
    let width = subject.positions[0].len();
    let columns: Vec<f64> =
        (0..width).flat_map(|q| subject.positions.iter().map(move |row| row[q])).collect();
    let mut results = RowResults::new(units);
    let run = move || {
        let positions = BatchPositions::Columns { values: black_box(&columns), stride: units };
        batch.run(positions, results.columns(), usize::MAX).expect("positions that fit");
        assert!(results.masses[0] > 0.0);
    };
    Task { run: Box::new(run), units, bodies }
}

/// Poses of the double wishbone in steps of 1 mrad, forwards and backwards.
fn wishbone() -> (System, Contact, Vec<percuss_dynamics::Configuration>) {
    let (system, contact, driver) = double_wishbone();
    let steps = 100;
    let at = |step: usize| {
        let step = step as f64;
        let angle = 1e-3 * (step - 2.0 * (step - f64::from(steps)).max(0.0) - f64::from(steps) / 2.0);
        let mut configuration = system.configuration();
        configuration.set(driver, &[angle]).expect("the lower arm drives");
        configuration
    };
    let configurations = (0..2 * steps as usize).map(at).collect();
    (system, contact, configurations)
}

fn poses(system: &System, configurations: &[percuss_dynamics::Configuration]) -> Vec<Pose> {
    let mut poses = vec![system.pose(&configurations[0]).expect("the start is in reach")];
    for configuration in &configurations[1..] {
        let last = poses.last().expect("there is one");
        poses.push(system.pose_from(last, configuration).expect("the range is in reach"));
    }
    poses
}

fn response() -> Task {
    let (system, contact, configurations) = wishbone();
    let poses = poses(&system, &configurations);
    let (units, bodies) = (poses.len(), system.mechanism().joints().len());
    let run = move || {
        for pose in &poses {
            _ = black_box(black_box(pose).respond(&contact).expect("a contact"));
        }
    };
    Task { run: Box::new(run), units, bodies }
}

fn closed() -> Task {
    let (system, contact, configurations) = wishbone();
    let rows: Vec<Vec<f64>> =
        poses(&system, &configurations).iter().map(|pose| pose.positions().to_vec()).collect();
    let mut batch = system.reference_or_open().batch(&contact).expect("a contact that fits");
    let (units, bodies) = (rows.len(), system.mechanism().joints().len());
    let run = move || {
        for row in &rows {
            _ = black_box(batch.effective_mass(black_box(row)).expect("positions that fit"));
        }
    };
    Task { run: Box::new(run), units, bodies }
}

fn step() -> Task {
    let (system, _, configurations) = wishbone();
    let mut pose = system.pose(&configurations[0]).expect("the start is in reach");
    let (units, bodies) = (configurations.len(), system.mechanism().joints().len());
    let run = move || {
        for configuration in &configurations {
            pose = system.pose_from(&pose, black_box(configuration)).expect("the range is in reach");
        }
    };
    Task { run: Box::new(run), units, bodies }
}

fn load() -> Task {
    let text = chain_urdf(1000);
    Task { run: Box::new(move || _ = black_box(loaded(black_box(&text)))), units: 1, bodies: 1000 }
}

fn loops(linkage: Linkage, contact_link: &str) -> Task {
    let row = linkage.closed_start().concat();
    let system = System::new(linkage.mechanism, &Conditions::new()).expect("default conditions fit");
    let link = system.mechanism().find_link(contact_link).expect("a coupler");
    let contact = Contact::new(link, [0.35, 0.1, 0.0], [0.2, 0.9, 0.1]);
    let mut workspace = system.reference().expect("it closes").workspace();
    let bodies = system.mechanism().joints().len();
    let run = move || {
        workspace.set_positions(black_box(&row)).expect("positions that fit");
        let mass = workspace.effective_mass(&contact).expect("an answer");
        assert!(matches!(mass, EffectiveMass::Finite(m) if m > 0.0), "{mass:?}");
    };
    Task { run: Box::new(run), units: 1, bodies }
}

fn gradient(subject: Subject) -> Task {
    let (batch, bodies) = (batch(&subject), bodies(&subject));
    let batch = batch.with_instructions(Instructions::Avx2);
    let units = subject.positions.len();
    let values = subject.positions.concat();
    let stride = values.len() / units;
    let mut results = RowResults::new(units);
    let mut gradients = vec![0.0; units * batch.velocities()];
    let run = move || {
        let positions = BatchPositions::Rows { values: black_box(&values), stride };
        let columns = RowColumns { gradients: Some(&mut gradients), ..results.columns() };
        batch.run(positions, columns, usize::MAX).expect("positions that fit");
    };
    Task { run: Box::new(run), units, bodies }
}

/// Poses of the double wishbone with its contact.
fn wishbone_poses() -> (Vec<Pose>, Contact) {
    let (system, contact, configurations) = wishbone();
    (poses(&system, &configurations), contact)
}

/// Poses of the six-hinge arm with its contact.
fn arm_poses() -> (Vec<Pose>, Contact) {
    let arm = subjects().swap_remove(0);
    let pose = |row: &Vec<f64>| {
        let configuration = percuss_dynamics::Configuration::from_positions(arm.system.mechanism(), row);
        arm.system.pose(&configuration.expect("positions that fit")).expect("a tree")
    };
    (arm.positions.iter().map(pose).collect(), arm.contact)
}

fn respond_arm() -> Task {
    let (poses, contact) = arm_poses();
    let units = poses.len();
    let run = move || {
        for pose in &poses {
            _ = black_box(black_box(pose).respond(&contact).expect("a contact"));
        }
    };
    Task { run: Box::new(run), units, bodies: 6 }
}

fn impacts((poses, contact): &(Vec<Pose>, Contact), is_in_workspace: bool) -> Task {
    let (poses, contact) = (poses.clone(), *contact);
    let (units, bodies) = (poses.len(), poses[0].mechanism().joints().len());
    let (mut workspace, mut found) = (ImpactWorkspace::new(&poses[0]), RigidImpact::none());
    let run = move || {
        for pose in &poses {
            if is_in_workspace {
                workspace.at(black_box(pose)).impact_into(&contact, 1.0, 0.3, &mut found).expect("an impact");
            } else {
                let response = black_box(pose).respond(&contact).expect("a contact");
                _ = black_box(RigidImpact::new(pose, &response, 1.0, 0.3, None));
            }
        }
    };
    Task { run: Box::new(run), units, bodies }
}

fn impact_over_time((poses, contact): &(Vec<Pose>, Contact)) -> Task {
    /// Penetration at 1 m/s, m.
    const DEPTH: f64 = 0.002;
    let (pose, contact) = (poses[0].clone(), *contact);
    let response = pose.respond(&contact).expect("a contact");
    let stiffness = response.effective_mass.kilograms().expect("a mass") / (DEPTH * DEPTH);
    let star = JointRates { joints: response.joint_velocities.clone(), base: response.base_velocity };
    let conditions = TimeConditions { ends_without_force: true, ..TimeConditions::default() };
    let bodies = pose.mechanism().joints().len();
    let run = move || {
        let force = |x: f64, _: f64| stiffness * x;
        let found = impact_in_time(black_box(&pose), &contact, 1.0, &star, &force, &conditions);
        assert!(found.expect("an end").samples.len() > 2);
    };
    Task { run: Box::new(run), units: 1, bodies }
}

/// Questions about a suspension sheet: key, request, and number of units, which are rows, samples or evaluations.
const QUESTIONS: [(&str, &str, usize); 8] = [
    ("mass", r#"{"contact": {"at": "bump_stop"}}"#, 1),
    ("explain", r#"{"contact": {"at": "bump_stop"}, "mass": {"explain": true}}"#, 1),
    (
        "tolerance",
        r#"{"contact": {"at": "bump_stop"}, "mass": {"tolerance": "mass=2%,com=2mm,point=0.5mm"}}"#,
        1,
    ),
    (
        "samples",
        r#"{"contact": {"at": "bump_stop"}, "mass": {"tolerance": "mass=2%,com=2mm,point=0.5mm", "samples": 2000}}"#,
        2000,
    ),
    ("row", r#"{"contact": {"at": "spring"}, "sweep": {"vary": "wheel-travel=0mm:0mm:1"}}"#, 1),
    ("sweep", r#"{"contact": {"at": "spring"}, "sweep": {"vary": "wheel-travel=-80mm:80mm:1001"}}"#, 1001),
    ("kinematics", r#"{"kinematics": {"vary": "wheel-travel=-80mm:80mm:101"}}"#, 101),
    ("extremes", r#"{"contact": {"at": "spring"}, "extremes": {"path": "wheel-travel=-80mm:80mm:17"}}"#, 1),
];

fn question(key: &str) -> Option<Task> {
    let (_, request, units) = QUESTIONS.iter().find(|(name, ..)| *name == key)?;
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/suspensions/double-wishbone.toml");
    let model = Model::load(path, DEFAULT_MAX_SIZE, &LoadOptions::default()).expect("a sheet");
    let run = move || {
        let answer = ask(black_box(&model), request);
        _ = black_box(answer.unwrap_or_else(|error| panic!("{request}: {error}")));
    };
    Some(Task { run: Box::new(run), units: *units, bodies: 1 })
}
