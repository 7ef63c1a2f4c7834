//! m̄ for the robots, poses and contacts that other programs were timed with. `NAME.json` contains the URDF,
//! the contact link, the normal in the world, joint names, poses and the expected m̄. Without poses, m̄ is computed at
//! the pose as drawn, and mimic joints stay mimic joints. `NAME.urdf` is a suspension written by `percuss import`, with the contact at the
//! spring seat along the spring, at closed poses over the travel of its lower arm.
//!
//! Prints `percuss NAME scalar|lanes|workspace NS` (nanoseconds of thread CPU time for one m̄ at a new
//! configuration, the minimum of many runs), after all m̄ agreed within 1e-9.

use cpu_time::ThreadTime;
use percuss_dynamics::{
    Base, Batch, BatchPositions, Conditions, Contact, Direction, EffectiveMass, Frame, Pose, RowResults,
    System,
};
use percuss_mechanism::Mechanism;
use percuss_spatial::lanes::Instructions;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Configurations per task of a thread.
const BLOCK: usize = 512;
/// Runs of the loop over all poses; the minimum counts.
const RUNS: usize = 200;

/// Configurations shared between threads.
const MANY: usize = 100_000;

/// Robot with contact and poses.
struct Question {
    name: String,
    system: System,
    contact: Contact,
    /// Positions of all joints for each pose.
    rows: Vec<Vec<f64>>,
    expected: Vec<f64>,
}

fn main() {
    let folder = std::env::args().nth(1).expect("the folder of the questions");
    let mut names: Vec<_> = std::fs::read_dir(&folder)
        .expect("a folder")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|e| e == "json" || e == "urdf"))
        .collect();
    names.sort();
    for path in names {
        if path.extension().is_some_and(|e| e == "urdf") {
            let question = Question::of_suspension(&path);
            time(&question);
            time_closing(&question);
        } else {
            time(&Question::read(&path));
        }
    }
}

/// Number of poses of a suspension, and travel of its lower arm to either side, rad.
const POSES: usize = 256;
const TRAVEL: f64 = 0.15;

/// Driving joint of a suspension, and number of steps in which the loops are closed.
const DRIVER: &str = "lower_arm_hinge";
const STEPS: usize = 1_000;

impl Question {
    fn read(path: &Path) -> Self {
        let text = std::fs::read_to_string(path).expect("a question");
        let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let numbers = |v: &serde_json::Value| -> Vec<f64> {
            v.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
        };
        let word = |key: &str| value[key].as_str().expect("a word").to_owned();
        let urdf = std::fs::read_to_string(word("urdf")).expect("the URDF");
        let poses = value["poses"].as_array();
        let mechanism = match poses {
            Some(_) => percuss_benches::loaded(&without_mimics(&urdf)),
            None => percuss_benches::loaded(&urdf),
        };
        let normal: [f64; 3] = numbers(&value["normal_world"]).try_into().expect("three numbers");
        let point: [f64; 3] = numbers(&value["point"]).try_into().expect("three numbers");
        let link = mechanism.find_link(&word("link")).expect("the link");
        let contact = Contact::new(link, point, normal).normal(Direction::Along(normal.into(), Frame::World));
        let mut conditions = Conditions::new();
        if value["base"] == "floating" {
            conditions = conditions.base(Base::Floating);
        }
        let expected = numbers(&value["effective_mass"]);
        let rows = poses.map(|poses| {
            let names = value["joints"].as_array().expect("names");
            let places: Vec<usize> =
                names.iter().map(|name| place(&mechanism, name.as_str().expect("a name"))).collect();
            let positions: usize = mechanism.joints().iter().map(|j| j.kind().positions()).sum();
            let row = |pose| {
                let mut row = vec![0.0; positions];
                places.iter().zip(numbers(pose)).for_each(|(place, q)| row[*place] = q);
                row
            };
            poses.iter().map(row).collect()
        });
        let system = System::new(mechanism, &conditions).expect("conditions that fit");
        let drawn = || {
            let pose = system.pose(&system.configuration()).expect("it closes as drawn");
            vec![pose.positions().to_vec(); POSES]
        };
        Self {
            name: path.file_stem().expect("a name").to_string_lossy().into_owned(),
            rows: rows.unwrap_or_else(drawn),
            expected: expected.into_iter().cycle().take(poses.map_or(POSES, Vec::len)).collect(),
            contact,
            system,
        }
    }
}

impl Question {
    fn of_suspension(path: &Path) -> Self {
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let mechanism = percuss_benches::loaded(&std::fs::read_to_string(path).expect("the URDF"));
        let link = |name: &str| mechanism.find_link(name).expect("a seat of the spring");
        let contact = Contact::new(link("spring_seat"), [0.0; 3], [0.0, 0.0, 1.0])
            .against(link("chassis"))
            .normal(Direction::Toward(link("spring_chassis_seat"), [0.0; 3].into()));
        let system = System::new(mechanism, &Conditions::new()).expect("conditions that fit");
        let at = |angle: f64| {
            let mut configuration = system.configuration();
            configuration.set(DRIVER, &[angle]).expect("the lower arm drives");
            configuration
        };
        let mass = |pose: &Pose| match pose.respond(&contact).map(|r| r.effective_mass) {
            Ok(EffectiveMass::Finite(m)) => m,
            other => panic!("{name}: {other:?}"),
        };
        let mut pose = system.pose(&at(0.0)).expect("it closes as drawn");
        println!("percuss {name} {:.6} kg agrees as drawn", mass(&pose));
        let (mut rows, mut expected) = (Vec::new(), Vec::new());
        for k in 0..POSES {
            let angle = TRAVEL * (2.0 * k as f64 / (POSES - 1) as f64 - 1.0);
            pose = system.pose_from(&pose, &at(angle)).expect("the travel is in reach");
            rows.push(pose.positions().to_vec());
            expected.push(mass(&pose));
        }
        Self { name, system, contact, rows, expected }
    }
}

/// The other programs ignore mimics, so the comparison must too.
fn without_mimics(urdf: &str) -> String {
    let mut text = String::with_capacity(urdf.len());
    let mut rest = urdf;
    while let Some(start) = rest.find("<mimic ") {
        let end = start + rest[start..].find('>').expect("a tag that ends") + 1;
        text.push_str(&rest[..start]);
        rest = &rest[end..];
    }
    text + rest
}

/// Index of a joint's position among all positions.
fn place(mechanism: &Mechanism, name: &str) -> usize {
    let joint = mechanism.find_joint(name).expect("the joint");
    mechanism.joints()[..joint.index()].iter().map(|j| j.kind().positions()).sum()
}

fn time(question: &Question) {
    let assembly = question.system.reference_or_open();
    let mut batch: Batch = assembly.batch(&question.contact).expect("a contact that fits");
    let count = question.rows.len();
    let width = question.rows[0].len();
    let mut columns = vec![0.0; width * count];
    for (c, row) in question.rows.iter().enumerate() {
        row.iter().enumerate().for_each(|(q, value)| columns[q * count + c] = *value);
    }
    let positions = BatchPositions::Columns { values: &columns, stride: count };
    let rows: Vec<f64> = question.rows.concat();
    let by_rows = BatchPositions::Rows { values: &rows, stride: width };
    let mut results = RowResults::new(count);
    time_threads(question, &batch);
    let line = |what: &str, ns: f64| println!("percuss {} {what} {ns:.1}", question.name);

    let mut workspace = assembly.workspace();
    let mut ask = |row: &[f64]| {
        workspace.set_positions(row).expect("positions that fit");
        workspace.effective_mass(&question.contact).expect("an answer")
    };
    compare(question, "workspace", question.rows.iter().map(|row| Some(ask(row))));
    line(
        "workspace",
        least(count, || question.rows.iter().for_each(|row| _ = black_box(ask(black_box(row))))),
    );

    compare(
        question,
        "scalar",
        question.rows.iter().map(|row| batch.effective_mass(row).expect("positions").mass),
    );
    let uncertain_rows =
        question.rows.iter().filter(|row| batch.effective_mass(row).is_ok_and(|a| a.error.is_none())).count();
    println!("percuss {} lanes: {}, asked again: {uncertain_rows}", question.name, batch.has_lanes());
    line(
        "scalar",
        least(count, || {
            question.rows.iter().for_each(|row| _ = black_box(batch.effective_mass(black_box(row))));
        }),
    );
    for set in [Instructions::Baseline, Instructions::Avx2, Instructions::Avx512] {
        if !set.is_available() {
            continue;
        }
        let batch = batch.clone().with_instructions(set);
        batch.run(positions, results.columns(), BLOCK).expect("positions that fit");
        compare(question, set.name(), (0..count).map(|row| results.answer(row).mass));
        line(
            &format!("lanes {}", set.name()),
            least(count, || {
                batch.run(black_box(positions), results.columns(), usize::MAX).expect("positions that fit");
            }),
        );
        line(
            &format!("lanes {} by rows", set.name()),
            least(count, || {
                batch.run(black_box(by_rows), results.columns(), usize::MAX).expect("positions that fit");
            }),
        );
    }
}

/// Closes the loops of a suspension in steps over the travel, each from the previous step: m̄ and all positions
/// of each step.
fn time_closing(question: &Question) {
    let mechanism = question.system.mechanism();
    let driver = mechanism.find_joint(DRIVER).expect("the lower arm");
    let place = place(mechanism, DRIVER);
    let at = |angle: f64| {
        let mut configuration = question.system.configuration();
        configuration.set(DRIVER, &[angle]).expect("the lower arm drives");
        configuration
    };
    let start = question.system.pose(&at(question.rows[0][place])).expect("the travel is in reach");
    let path = start.driven_path(&question.contact, &[driver]).expect("a contact");
    let Some(mut path) = path else {
        println!("percuss {}: its loops are not closed in lanes", question.name);
        return;
    };
    let angles: Vec<f64> = (0..STEPS).map(|k| TRAVEL * (2.0 * k as f64 / (STEPS - 1) as f64 - 1.0)).collect();
    let (mut answers, mut positions) = (Vec::new(), Vec::new());
    for (what, at_once) in [("closing scalar", 1), ("closing lanes", STEPS)] {
        let mut go = || {
            answers.clear();
            positions.clear();
            assert!(path.restart(&start), "it stands at the start");
            let go = |rows| path.follow(rows, &mut answers, &mut positions);
            let reached: usize = angles.chunks(at_once).map(go).sum();
            assert_eq!(reached, STEPS, "the travel is in reach");
        };
        go();
        let ns = least(STEPS, go);
        let worst = answers.iter().map(|a| a.residual).fold(0.0, f64::max);
        let known = answers.iter().filter(|a| a.mass.is_some()).count();
        let mut pose = start.clone();
        let mut off = 0.0f64;
        for (k, answer) in answers.iter().enumerate() {
            pose = question.system.pose_from(&pose, &at(angles[k])).expect("the travel is in reach");
            let Some((mass, _)) = answer.mass else { continue };
            let Ok(EffectiveMass::Finite(m)) = pose.respond(&question.contact).map(|r| r.effective_mass)
            else {
                panic!("{}: no mass at {}", question.name, angles[k])
            };
            off = off.max((mass / m - 1.0).abs());
        }
        assert!(off < 1e-9, "{}, {what}: off by {off:.1e}", question.name);
        println!(
            "percuss {} {what} agrees to {off:.1e}, closed to {worst:.1e} m, {known} of {STEPS} masses known",
            question.name
        );
        println!("percuss {} {what} {ns:.1}", question.name);
    }
}

/// Wall time of many configurations with one thread divided by that with two threads; minimum of alternating runs.
fn time_threads(question: &Question, batch: &Batch) {
    let width = question.rows[0].len();
    let rows: Vec<f64> = question.rows.iter().cycle().take(MANY).flatten().copied().collect();
    let positions = BatchPositions::Rows { values: &rows, stride: width };
    let mut results = RowResults::new(MANY);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("two threads");
    let (mut one, mut two) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..20 {
        let start = Instant::now();
        batch.run(black_box(positions), results.columns(), usize::MAX).expect("positions that fit");
        one = one.min(start.elapsed().as_secs_f64());
        let start = Instant::now();
        pool.install(|| batch.run(black_box(positions), results.columns(), BLOCK))
            .expect("positions that fit");
        two = two.min(start.elapsed().as_secs_f64());
    }
    println!("percuss {} two threads times one: {:.2}", question.name, one / two);
}

/// Nanoseconds of thread CPU time per item.
fn least(count: usize, mut all: impl FnMut()) -> f64 {
    let run = |_| {
        let start = ThreadTime::now();
        all();
        start.elapsed().as_nanos() as f64
    };
    (0..RUNS).map(run).fold(f64::INFINITY, f64::min) / count as f64
}

fn compare(question: &Question, route: &str, masses: impl Iterator<Item = Option<EffectiveMass>>) {
    let mut worst = 0.0f64;
    for (mass, expected) in masses.zip(&question.expected) {
        let Some(EffectiveMass::Finite(mass)) = mass else { panic!("{}, {route}: {mass:?}", question.name) };
        worst = worst.max((mass / expected - 1.0).abs());
    }
    assert!(worst < 1e-9, "{}, {route}: off by {worst:.1e}", question.name);
    println!("percuss {} {route} agrees to {worst:.1e}", question.name);
}
