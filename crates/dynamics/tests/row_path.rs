//! Rows of a path: each row has the result of the general method, and rows beyond the end of the branch have none.

use percuss_dynamics::{
    AssemblyError, Conditions, Contact, DrivenPath, EffectiveMass, Pose, RowAnswer, RowHandler, RowPath,
    System,
};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointId, JointKind, LinkDescription,
    MechanismBuilder,
};
use std::sync::Arc;

/// Two arms with their tips connected by a rod: neither arm turns fully.
fn arms() -> System {
    let arm = |name: &str, mass| LinkDescription::new(name, Inertial::point(mass, [0.4, 0.1, 0.0]));
    let hinge = |name: &str, child: &str, x: f64| {
        JointDescription::new(name, JointKind::Continuous, "ground", child)
            .at([x, 0.0, 0.0])
            .axis([0.0, 0.0, 1.0])
    };
    let rod = ClosureDescription::new("rod", ClosureKind::Distance, "a", "b");
    let built = MechanismBuilder::new("arms")
        .link(LinkDescription::massless("ground"))
        .link(arm("a", 2.0))
        .link(arm("b", 3.0))
        .joint(hinge("ja", "a", 0.0))
        .joint(hinge("jb", "b", 1.2))
        .closure(rod.at([1.0, 0.0, 0.0], [1.0, 0.2, 0.0]).distance(1.5))
        .build()
        .expect("a good mechanism");
    System::new(built.mechanism, &Conditions::new()).expect("a system")
}

/// Pose of a row, from the pose of another row.
fn pose_of_row(from: &Pose, joint: JointId, value: f64) -> Result<Pose, AssemblyError> {
    let mut configuration = percuss_dynamics::Configuration::zero(from.mechanism());
    configuration.set(from.mechanism().joint(joint).name(), &[value]).expect("one position");
    from.assembly().pose_from(from, &configuration)
}

/// m̄ and its error, kg.
fn mass(pose: &Pose, contact: &Contact) -> (f64, f64) {
    let response = pose.respond(contact).expect("a response");
    match response.effective_mass {
        EffectiveMass::Finite(mass) => (mass, response.effective_mass_error().expect("an error")),
        other => panic!("{other:?}"),
    }
}

/// Results of the rows, and the numbers of single poses and of paths.
struct Recorder {
    contact: Contact,
    joint: JointId,
    masses: Vec<Option<(f64, f64)>>,
    singles: usize,
    paths: usize,
}

impl RowHandler for Recorder {
    type Shared = usize;
    type Error = AssemblyError;

    fn pose(&mut self, _: usize, values: &[f64], last: Option<&Pose>) -> Result<Arc<Pose>, AssemblyError> {
        self.singles += 1;
        pose_of_row(last.expect("a start"), self.joint, values[0]).map(Arc::new)
    }

    fn driven_path(&mut self, pose: &Pose) -> Option<(DrivenPath, usize)> {
        self.paths += 1;
        let path = pose.driven_path(&self.contact, &[self.joint]).expect("a good contact")?;
        Some((path, self.paths))
    }

    fn receive(&mut self, row: usize, _: &[f64], answer: RowAnswer<'_, usize, AssemblyError>) {
        assert_eq!(row, self.masses.len() % 100, "rows are in order");
        self.masses.push(match answer {
            RowAnswer::Followed { shared, mass, .. } => {
                assert_eq!(*shared, self.paths);
                Some(mass)
            }
            RowAnswer::Posed(pose) => Some(mass(&pose, &self.contact)),
            RowAnswer::Unreached(_) => None,
        });
    }
}

#[test]
fn rows_have_the_results_of_their_poses() {
    let system = arms();
    let start = system.pose(&system.configuration()).expect("a pose");
    let joint = start.loops().expect("loops").drivers[0];
    let contact = Contact::new(system.mechanism().find_link("b").unwrap(), [1.0, 0.2, 0.0], [0.0, 1.0, 0.0]);
    let first = start.joint(joint)[0];
    let rows: Vec<f64> = (0..400).map(|row| first + 3.0 * (f64::from(row) / 50.0).sin()).collect();
    let mut recorder = Recorder { contact, joint, masses: Vec::new(), singles: 0, paths: 0 };
    let mut path = RowPath::new(Some(Arc::new(start.clone())));
    for portion in rows.chunks(100) {
        path.follow(portion, portion.len(), &mut recorder);
    }
    let mut here = start;
    for (row, found) in rows.iter().zip(&recorder.masses) {
        let expected = pose_of_row(&here, joint, *row);
        assert_eq!(expected.is_ok(), found.is_some(), "{row}");
        if let (Ok(pose), Some((found, error))) = (expected, found) {
            let (expected, own_error) = mass(&pose, &contact);
            assert!((found - expected).abs() <= error + own_error, "{row}: {found} for {expected}");
            here = pose;
        }
    }
    let unreached = recorder.masses.iter().filter(|mass| mass.is_none()).count();
    let reached = rows.len() - unreached;
    assert!(unreached > 20 && reached > 100, "{unreached} of {}", rows.len());
    assert!(recorder.singles < unreached + reached / 4, "{} poses", recorder.singles);
    assert!((2..=16).contains(&recorder.paths), "{} paths", recorder.paths);
}

/// After 16 paths each row is posed alone.
#[test]
fn the_number_of_paths_is_limited() {
    let system = arms();
    let start = system.pose(&system.configuration()).expect("a pose");
    let joint = start.loops().expect("loops").drivers[0];
    let contact = Contact::new(system.mechanism().find_link("b").unwrap(), [1.0, 0.2, 0.0], [0.0, 1.0, 0.0]);
    let first = start.joint(joint)[0];
    // Every tenth row is beyond the end of the branch.
    let rows: Vec<f64> =
        (0..300).map(|row| first + if row % 10 == 9 { 3.0 } else { 1e-3 * f64::from(row) }).collect();
    let mut recorder = Recorder { contact, joint, masses: Vec::new(), singles: 0, paths: 0 };
    let mut path = RowPath::new(Some(Arc::new(start)));
    rows.chunks(100).for_each(|portion| path.follow(portion, portion.len(), &mut recorder));
    assert_eq!(recorder.paths, 16);
    assert_eq!(recorder.masses.iter().filter(|mass| mass.is_none()).count(), 30);
    assert!(recorder.singles > 140, "{} poses", recorder.singles);
}
