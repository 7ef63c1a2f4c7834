//! All input rules at all entry points, and findings as data.

use nalgebra::{Matrix3, Vector3};
use percuss_dynamics::{
    Assembly, AssemblyError, Base, BatchAnswer, BatchPositions, Conditions, Configuration, Contact,
    ContactColumns, ContactStatus, Direction, EffectiveMass, Frame, MapAnswers, MatrixOptions, MatrixView,
    Pose, Remark, RemarkFlags, ResponseError, RowResults, System, Travel, effective_mass, input,
};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, LinkId,
    MechanismBuilder,
};
use percuss_spatial::{Transform, Twist, rotation_from_rpy};
use std::sync::Arc;

/// A rod on a spherical joint, with a revolute joint at its tip.
fn ball() -> System {
    system(
        MechanismBuilder::new("ball")
            .link(LinkDescription::massless("ground"))
            .link(LinkDescription::new("rod", Inertial::diagonal(2.0, [0.3, 0.0, 0.0], [0.01, 0.07, 0.08])))
            .link(LinkDescription::new(
                "tip",
                Inertial::diagonal(0.5, [0.1, 0.0, 0.0], [0.001, 0.002, 0.002]),
            ))
            .joint(JointDescription::new("ball", JointKind::Spherical, "ground", "rod"))
            .joint(
                JointDescription::new("hinge", JointKind::Continuous, "rod", "tip")
                    .origin(at([0.6, 0.0, 0.0]))
                    .axis([0.0, 1.0, 0.0]),
            ),
        &Conditions::new(),
    )
}

fn at(p: [f64; 3]) -> Transform<f64> {
    Transform::new(Matrix3::identity(), Vector3::from(p))
}

fn system(builder: MechanismBuilder, conditions: &Conditions) -> System {
    System::new(builder.build().expect("a good mechanism").mechanism, conditions)
        .expect("conditions that fit")
}

/// Planar four-bar with spherical pins and the lengths crank, coupler, rocker and ground. Drawn closed with the crank
/// along +x, except for `gap` (m) in the rocker's pin. `kind`: kind of the loop closure.
fn four_bar(lengths: [f64; 4], gap: f64, kind: ClosureKind) -> System {
    let [crank, coupler, rocker, ground] = lengths;
    // Pin between coupler and rocker, with the crank along x.
    let d = ground - crank;
    let x = (d * d + coupler * coupler - rocker * rocker) / (2.0 * d);
    let y = (coupler * coupler - x * x).sqrt();
    let (coupler_angle, rocker_angle) = (y.atan2(x), y.atan2(x - d));
    let bar = |name: &str, length: f64, mass: f64| {
        let i = mass * length * length / 12.0;
        LinkDescription::new(name, Inertial::diagonal(mass, [length / 2.0, 0.0, 0.0], [i / 10.0, i, i]))
    };
    let hinge = |name: &str, parent: &str, child: &str, x: f64, angle: f64| {
        let origin = Transform::new(rotation_from_rpy([0.0, 0.0, angle]), Vector3::new(x, 0.0, 0.0));
        JointDescription::new(name, JointKind::Continuous, parent, child).origin(origin).axis([0.0, 0.0, 1.0])
    };
    system(
        MechanismBuilder::new("four_bar")
            .link(LinkDescription::massless("ground"))
            .link(bar("crank", crank, 1.0))
            .link(bar("coupler", coupler, 2.0))
            .link(bar("rocker", rocker, 1.5))
            .joint(hinge("crank_hinge", "ground", "crank", 0.0, 0.0))
            .joint(hinge("coupler_hinge", "crank", "coupler", crank, coupler_angle))
            .joint(hinge("rocker_hinge", "ground", "rocker", ground, rocker_angle))
            .closure(
                ClosureDescription::new("pin", kind, "coupler", "rocker")
                    .at([coupler + gap, 0.0, 0.0], [rocker, 0.0, 0.0])
                    .axis([0.0, 0.0, 1.0]),
            ),
        &Conditions::new(),
    )
}

const ORDINARY: [f64; 4] = [0.2, 0.7, 0.5, 0.6];

fn on(system: &System, link: &str, point: [f64; 3], normal: [f64; 3]) -> Contact {
    Contact::new(system.mechanism().find_link(link).expect("a link"), point, normal)
}

/// A mechanism, a contact, and valid positions.
struct Subject {
    system: System,
    assembly: Arc<Assembly>,
    contact: Contact,
    good: Vec<f64>,
}

impl Subject {
    fn new(system: System, contact: Contact) -> Self {
        let assembly = Arc::clone(system.reference().expect("loops that close"));
        let good = assembly.pose(&system.configuration()).expect("a pose").positions().to_vec();
        Self { system, assembly, contact, good }
    }

    fn ball() -> Self {
        let system = ball();
        let contact = on(&system, "tip", [0.1, 0.0, 0.2], [0.2, 0.1, 1.0]);
        Self::new(system, contact)
    }

    fn four_bar(kind: ClosureKind) -> Self {
        let system = four_bar(ORDINARY, 0.0, kind);
        let contact = on(&system, "coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
        Self::new(system, contact)
    }

    fn pose(&self) -> Pose {
        self.assembly.pose(&self.system.configuration()).expect("a pose")
    }

    /// Result of each entry point for a row of positions: m̄, or the reason for a missing result.
    fn entries(&self, row: &[f64]) -> Vec<(&'static str, Result<EffectiveMass, String>)> {
        let of = |answer: BatchAnswer| answer.mass.ok_or_else(|| format!("{:?}", answer.remarks));
        let batch = self.assembly.batch(&self.contact).expect("a contact");
        let mut alone = batch.clone();
        let one = alone.effective_mass(row).map_err(|error| error.to_string()).and_then(of);
        let mut all = vec![("workspace", self.workspace(row)), ("batch, one row", one)];
        if row.len() != self.good.len() {
            return all;
        }
        let mut results = RowResults::new(1);
        let one = BatchPositions::Rows { values: row, stride: row.len() };
        batch.run(one, results.columns(), 1).expect("a row");
        all.push(("batch, rows", of(results.answer(0))));
        // Sixteen lanes, one of which breaks the rule; the others must have results.
        let number = |q: usize, c: usize| if c == 5 { row[q] } else { self.good[q] };
        let values: Vec<f64> = (0..row.len()).flat_map(|q| (0..16).map(move |c| number(q, c))).collect();
        let mut results = RowResults::new(16);
        batch
            .run(BatchPositions::Columns { values: &values, stride: 16 }, results.columns(), 16)
            .expect("16 rows");
        assert!((0..16).all(|c| c == 5 || results.answer(c).mass.is_some()), "{results:?}");
        all.push(("batch, columns", of(results.answer(5))));
        all
    }

    fn workspace(&self, row: &[f64]) -> Result<EffectiveMass, String> {
        let mut workspace = self.assembly.workspace();
        workspace.set_positions(row).map_err(|error| error.to_string())?;
        workspace.effective_mass(&self.contact).map_err(|error| error.to_string())
    }

    /// The row with some positions replaced.
    fn with(&self, change: impl FnOnce(&mut Vec<f64>)) -> Vec<f64> {
        let mut row = self.good.clone();
        change(&mut row);
        row
    }
}

/// Cases of the table: rule, entry point, and a flag for refused input.
type Table = Vec<(&'static str, &'static str, bool)>;

fn add_rows(table: &mut Table, rule: &'static str, subject: &Subject, row: &[f64]) {
    for (entry, answer) in subject.entries(&subject.good) {
        assert!(answer.is_ok(), "{rule}, {entry}: a good row is refused: {answer:?}");
    }
    for (entry, answer) in subject.entries(row) {
        table.push((rule, entry, answer.is_err()));
    }
}

#[test]
fn every_rule_holds_at_every_entry_point() {
    let mut table = Table::new();
    let (ball, bars) = (Subject::ball(), Subject::four_bar(ClosureKind::Spherical));
    let spatial = Subject::four_bar(ClosureKind::Revolute);
    // Rows of positions.
    add_rows(&mut table, "length", &ball, &[1.0, 0.0]);
    for bad in [f64::NAN, f64::INFINITY, 1e101] {
        add_rows(&mut table, "finite", &ball, &ball.with(|row| row[4] = bad));
        add_rows(&mut table, "finite", &ball, &ball.with(|row| row[1] = bad));
        add_rows(&mut table, "finite", &bars, &bars.with(|row| row[0] = bad));
    }
    for norm in [0.0, 0.5, 0.98, 1.02, 3.0] {
        add_rows(&mut table, "unit quaternion", &ball, &ball.with(|row| row[0] = norm));
    }
    for subject in [&bars, &spatial] {
        for gap in [3e-6, 1e-3, 0.5] {
            add_rows(&mut table, "closed loops", subject, &subject.with(|row| row[0] += gap));
        }
    }
    // A configuration and its pose.
    let ball_set = |values: &[f64]| ball.system.configuration().set("ball", values).is_err();
    let whole = |row: &[f64]| {
        let mechanism = ball.system.mechanism();
        Configuration::from_positions(mechanism, row).is_err()
    };
    let guess = |values: &[f64]| ball.system.configuration().guess("ball", values).is_err();
    assert!(!ball_set(&[1.0, 0.0, 0.0, 0.0]) && !whole(&ball.good) && !guess(&[1.005, 0.0, 0.0, 0.0]));
    for (rule, values) in [
        ("length", vec![1.0, 0.0]),
        ("finite", vec![f64::NAN, 0.0, 0.0, 0.0]),
        ("finite", vec![1.0, 1e101, 0.0, 0.0]),
        ("unit quaternion", vec![0.98, 0.0, 0.0, 0.0]),
        ("unit quaternion", vec![0.0; 4]),
    ] {
        table.push((rule, "configuration", ball_set(&values)));
        table.push((rule, "guess", guess(&values)));
        let row = if values.len() == 4 { [&values[..], &[0.0]].concat() } else { values };
        table.push((rule, "whole configuration", whole(&row)));
    }
    // Pose of the base.
    let turned = |factor: f64| {
        let rotation = rotation_from_rpy([0.3, 0.1, -0.2]) * factor;
        Transform::new(rotation, Vector3::new(1.0, 2.0, 3.0))
    };
    let mirrored = Transform::new(Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0)), Vector3::zeros());
    let far = Transform::new(Matrix3::identity(), Vector3::new(f64::NAN, 0.0, 0.0));
    let based = |x_wr: &Transform<f64>| {
        let mut configuration = ball.system.configuration();
        configuration.set_base(*x_wr);
        let refused = ball.system.pose(&configuration);
        assert!(refused.is_ok() || matches!(refused, Err(AssemblyError::Base(_))));
        [refused.is_err(), ball.assembly.workspace().set_base(x_wr).is_err()]
    };
    assert_eq!(based(&turned(1.0)), [false; 2]);
    assert_eq!(based(&turned(1.0 + 1e-7)), [false; 2]);
    for bad in [turned(1.001), turned(0.0), mirrored, far] {
        let [pose, workspace] = based(&bad);
        table.push(("base pose", "pose", pose));
        table.push(("base pose", "workspace", workspace));
    }
    for (position, quaternion) in [
        ([f64::INFINITY, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]),
        ([0.0; 3], [2.0, 0.0, 0.0, 0.0]),
        ([0.0; 3], [f64::NAN, 0.0, 0.0, 0.0]),
    ] {
        table.push(("base pose", "position and quaternion", input::base_pose(position, quaternion).is_err()));
    }
    // Contacts.
    let pose = ball.pose();
    let contacts = |contact: &Contact| {
        [
            ("pose", pose.respond(contact).is_err()),
            ("workspace", ball.assembly.workspace().effective_mass(contact).is_err()),
            ("batch", ball.assembly.batch(contact).is_err()),
            ("path", pose.driven_path(contact, &[]).is_err()),
            ("derivatives", pose.effective_mass_gradient(contact).is_err()),
        ]
    };
    assert!(contacts(&ball.contact).iter().all(|(_, refused)| !refused));
    let along =
        |normal: [f64; 3]| Contact { normal: Direction::Along(normal.into(), Frame::Link), ..ball.contact };
    let with_point = |x: f64| Contact { point: Vector3::new(x, 0.0, 0.0), ..ball.contact };
    let foreign = bars.contact.link;
    let to_foreign = Direction::Toward(foreign, Vector3::x());
    for (rule, contact) in [
        ("direction", along([0.0; 3])),
        ("direction", along([1e-12, 0.0, 0.0])),
        ("finite", along([f64::NAN, 0.0, 1.0])),
        ("finite", along([f64::INFINITY, 0.0, 1.0])),
        ("finite", with_point(f64::NAN)),
        ("finite", with_point(1e101)),
        ("own link", Contact { link: foreign, ..ball.contact }),
        ("own link", Contact { against: Some(foreign), ..ball.contact }),
        ("own link", Contact { normal: to_foreign, ..ball.contact }),
    ] {
        for (entry, refused) in contacts(&contact) {
            table.push((rule, entry, refused));
        }
    }
    // Maps.
    let map = pose.contact_map(ball.contact.link, None, Vector3::zeros(), 0.3).expect("a map");
    let status = |point: [f64; 3], normal: [f64; 3]| {
        let (mut masses, mut errors, mut statuses) = ([0.0], [0.0], [ContactStatus::Finite]);
        let contacts = ContactColumns {
            points: [&[point[0]], &[point[1]], &[point[2]]],
            normals: [&[normal[0]], &[normal[1]], &[normal[2]]],
        };
        let mut answers =
            MapAnswers { masses: &mut masses, relative_errors: &mut errors, statuses: &mut statuses };
        map.fill_answers(contacts, &mut answers).expect("columns of one length");
        statuses[0]
    };
    assert_eq!(status([0.1, 0.0, 0.2], [0.2, 0.1, 1.0]), ContactStatus::Finite);
    for (rule, point, normal) in [
        ("direction", [0.1, 0.0, 0.2], [0.0; 3]),
        ("finite", [0.1, 0.0, 0.2], [f64::NAN, 0.0, 1.0]),
        ("finite", [0.1, 0.0, 0.2], [f64::INFINITY, 0.0, 1.0]),
        ("finite", [f64::NAN, 0.0, 0.2], [0.0, 0.0, 1.0]),
        ("finite", [1e101, 0.0, 0.2], [0.0, 0.0, 1.0]),
    ] {
        table.push((rule, "map", status(point, normal) == ContactStatus::Unanswered));
    }
    table.push(("own link", "map", pose.contact_map(foreign, None, Vector3::zeros(), 0.3).is_err()));
    table.push(("finite", "map", pose.contact_map(ball.contact.link, None, [f64::NAN; 3], 0.3).is_err()));
    let short = ContactColumns { points: [&[0.0][..], &[0.0], &[]], normals: [&[0.0], &[0.0], &[1.0]] };
    let (mut masses, mut errors, mut statuses) = ([0.0], [0.0], [ContactStatus::Finite]);
    let mut answers =
        MapAnswers { masses: &mut masses, relative_errors: &mut errors, statuses: &mut statuses };
    table.push(("length", "map", map.fill_answers(short, &mut answers).is_err()));
    // Matrices, travels, held contacts, forces.
    let one = |m: f64, j: &[f64]| {
        effective_mass(MatrixView::row_major(&[m], 1, 1).expect("1×1"), j, None, &MatrixOptions::new())
    };
    assert!(one(2.0, &[1.0]).is_ok());
    table.push(("finite", "matrices", one(f64::NAN, &[1.0]).is_err()));
    table.push(("finite", "matrices", one(2.0, &[f64::INFINITY]).is_err()));
    table.push(("length", "matrices", one(2.0, &[1.0, 1.0]).is_err()));
    let travel =
        |link: LinkId, direction: [f64; 3]| Travel::new(&pose, link, Vector3::zeros(), direction.into());
    assert!(travel(ball.contact.link, [0.0, 0.0, 1.0]).is_ok());
    table.push(("own link", "travel", travel(foreign, [0.0, 0.0, 1.0]).is_err()));
    table.push(("direction", "travel", travel(ball.contact.link, [0.0; 3]).is_err()));
    table.push(("finite", "travel", travel(ball.contact.link, [f64::NAN; 3]).is_err()));
    let held = |normal: [f64; 3]| {
        let conditions = Conditions::new().hold("tip", [0.0; 3], Some(normal.into()));
        System::new(Arc::clone(ball.system.mechanism()), &conditions).is_err()
    };
    assert!(!held([0.0, 0.0, 1.0]));
    table.push(("direction", "held contact", held([0.0; 3])));
    table.push(("finite", "held contact", held([f64::NAN, 0.0, 1.0])));
    let still: Vec<Vec<f64>> =
        ball.system.mechanism().joints().iter().map(|j| vec![0.0; j.kind().dofs()]).collect();
    let accelerations = pose.accelerations(&still, &Twist::zero(), &Vector3::zeros(), &[]).expect("a tree");
    let at_foreign = pose.point_acceleration(&accelerations, foreign, &Vector3::zeros());
    table.push(("own link", "acceleration", at_foreign.is_err()));
    let response = pose.respond(&ball.contact).expect("a response");
    table.push((
        "own link",
        "point velocity",
        pose.point_velocity(&response, foreign, &Vector3::zeros()).is_none(),
    ));
    table.push(("own link", "rigid body mass", ball.system.rigid_body_mass(foreign).is_none()));

    let accepted: Vec<_> = table.iter().filter(|(_, _, refused)| !refused).collect();
    assert!(accepted.is_empty(), "accepted: {accepted:?}");
    println!("{} cases of rule × entry point", table.len());
    assert_eq!(table.len(), COUNT);
}

/// Number of cases in the table; fewer cases mean that a rule or an entry point is no longer tested.
const COUNT: usize = 172;

#[test]
fn a_nearly_unit_quaternion_is_normalised() {
    let subject = Subject::ball();
    let unit = [0.5, 0.5, -0.5, 0.5];
    let row = |factor: f64| [&unit.map(|x| x * factor)[..], &[0.4]].concat();
    let expected = subject.workspace(&row(1.0)).expect("a unit quaternion");
    let EffectiveMass::Finite(expected) = expected else { panic!("{expected:?}") };
    for factor in [0.991, 0.999, 1.0 + 1e-9, 1.009] {
        for (entry, answer) in subject.entries(&row(factor)) {
            let Ok(EffectiveMass::Finite(m)) = answer else { panic!("{entry}: {answer:?}") };
            // Some roundings of a tree of two bodies.
            assert!((m / expected - 1.0).abs() < 1e-13, "{entry}, {factor}: {m} for {expected}");
        }
    }
}

#[test]
fn an_open_row_is_refused_with_its_gap() {
    for kind in [ClosureKind::Spherical, ClosureKind::Revolute] {
        let subject = Subject::four_bar(kind);
        for turn in [1e-5_f64, 0.01, 0.5, -1.0] {
            let row = subject.with(|row| row[0] += turn);
            let mut workspace = subject.assembly.workspace();
            workspace.set_positions(&row).expect("as many as there are");
            let error = workspace.effective_mass(&subject.contact).expect_err("an open loop");
            let ResponseError::OpenLoops { loops, gap, tolerance } = &error else { panic!("{error}") };
            // The coupler's pin moves around the crank's joint, 0.5 m from the rocker's pin and its joint.
            let arm = Vector3::new(0.6, 0.0, 0.0) + Vector3::new(-0.1, 0.24_f64.sqrt(), 0.0) * 0.0;
            assert_eq!(loops, &["pin"]);
            assert!(*gap > 0.1 * turn.abs() * arm.x && *gap < 2.0 * turn.abs(), "{gap} after {turn}");
            assert!(*tolerance > 1e-8 && *tolerance < 1e-5, "{tolerance}");
            let text = error.to_string();
            assert!(text.contains("pin") && text.contains(" m"), "{text}");
        }
        // Positions in single precision are accepted.
        let mut configuration = subject.system.configuration();
        configuration.set("crank_hinge", &[0.7]).expect("a driver");
        let pose = subject.assembly.pose(&configuration).expect("it turns");
        let rounded: Vec<f64> = pose.positions().iter().map(|q| f64::from(*q as f32)).collect();
        let exact = pose.respond(&subject.contact).expect("a response").effective_mass;
        let EffectiveMass::Finite(exact) = exact else { panic!("{exact:?}") };
        for (entry, answer) in subject.entries(&rounded) {
            let Ok(EffectiveMass::Finite(m)) = answer else { panic!("{entry}: {answer:?}") };
            assert!((m / exact - 1.0).abs() < 1e-5, "{entry}: {m} for {exact}");
        }
    }
}

#[test]
fn another_assembly_mode_is_an_error_unless_it_is_accepted() {
    // The rocker of a double rocker, beyond its range: the other range belongs to the other mode.
    let mut refused = 0;
    for (k, lengths) in
        [[0.2, 0.7, 0.5, 0.6], [0.25, 0.6, 0.5, 0.6], [0.3, 0.8, 0.6, 0.7]].into_iter().enumerate()
    {
        let system = four_bar(lengths, 0.0, ClosureKind::Spherical);
        let contact = on(&system, "coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
        // Mirror image of the drawing about the line of the ground joints.
        let d = lengths[3] - lengths[0];
        let x = (d * d + lengths[1].powi(2) - lengths[2].powi(2)) / (2.0 * d);
        let y = (lengths[1].powi(2) - x * x).sqrt();
        let mirrored = -2.0 * y.atan2(x - d);
        for step in 0..5 {
            let target = mirrored - 0.02 * f64::from(step);
            let mut configuration = system.configuration();
            configuration.set("rocker_hinge", &[target]).expect("a joint");
            match system.pose(&configuration) {
                Err(error @ AssemblyError::OtherAssembly { .. }) => {
                    let text = error.to_string();
                    for words in
                        ["another assembly mode", "rocker_hinge", "branch of the first closed pose ends at"]
                    {
                        assert!(text.contains(words), "{words} is missing in {text}");
                    }
                    assert!(!error.is_bad_input() && error.ends_in_another_start());
                }
                other => {
                    panic!("four-bar {k} at {target}: {:?}", other.map(|pose| pose.positions().to_vec()))
                }
            }
            refused += 1;
            configuration.allow_other_assembly();
            let pose = system.pose(&configuration).expect("it was accepted");
            let response = pose.respond(&contact).expect("a response");
            assert!(
                response.remarks.iter().any(|r| matches!(r, Remark::OtherAssembly { .. })),
                "{response:?}"
            );
            assert!(response.remark_flags().contains(RemarkFlags::OTHER_ASSEMBLY));
        }
        // No remark on the branch of the drawing.
        let mut configuration = system.configuration();
        configuration.set("rocker_hinge", &[0.05]).expect("a joint");
        let pose = system.pose(&configuration).expect("within its range");
        assert_eq!(pose.remarks(), []);
    }
    assert_eq!(refused, 15);
}

#[test]
fn a_loop_open_as_drawn_is_a_remark_of_every_answer() {
    for (gap, is_wide) in [(0.0, false), (1e-3, false), (0.03, true), (-0.03, true)] {
        let system = four_bar(ORDINARY, gap, ClosureKind::Spherical);
        let contact = on(&system, "coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
        let assembly = system.reference().expect("it closes");
        let pose = assembly.pose(&system.configuration()).expect("a pose");
        let response = pose.respond(&contact).expect("a response");
        let found = response.remarks.iter().find_map(|remark| match remark {
            Remark::DrawnOpen { gap, .. } => Some(*gap),
            _ => None,
        });
        assert_eq!(found.is_some(), is_wide, "{gap}: {found:?}");
        // The residual as drawn is the largest component of the gap along the coupler.
        assert!(
            found.is_none_or(|found| found > 0.5 * f64::abs(gap) && found <= 1.01 * f64::abs(gap)),
            "{found:?}"
        );
        let flag = |flags: RemarkFlags| flags.contains(RemarkFlags::DRAWN_OPEN);
        assert_eq!(flag(response.remark_flags()), is_wide);
        let mut workspace = assembly.workspace();
        workspace.set_positions(pose.positions()).expect("positions");
        let _ = workspace.effective_mass(&contact).expect("closed loops");
        assert_eq!(flag(workspace.remarks()), is_wide);
        let mut batch = assembly.batch(&contact).expect("a contact");
        assert_eq!(flag(batch.effective_mass(pose.positions()).expect("positions").remarks), is_wide);
    }
}

#[test]
fn a_nearly_immovable_contact_is_a_remark_of_a_workspace() {
    let subject = Subject::ball();
    let mut checked = 0;
    for tilt in [1e-7, 1e-8, 3e-9, 1e-3] {
        // Along the rod the point does not move, except for the tilt.
        let contact = on(&subject.system, "rod", [0.5, 0.0, 0.0], [1.0, tilt, 0.0]);
        let response = subject.pose().respond(&contact).expect("a response");
        let EffectiveMass::Finite(m) = response.effective_mass else { panic!("{response:?}") };
        let expected = tilt < 1e-6;
        let mut workspace = subject.assembly.workspace();
        workspace.set_positions(&subject.good).expect("positions");
        let EffectiveMass::Finite(own) = workspace.effective_mass(&contact).expect("a mass") else {
            panic!()
        };
        assert!((own / m - 1.0).abs() < 1e-6, "{own} for {m}");
        assert_eq!(workspace.remarks().contains(RemarkFlags::NEARLY_IMMOVABLE), expected, "{tilt}: {m}");
        assert_eq!(response.remark_flags().contains(RemarkFlags::NEARLY_IMMOVABLE), expected, "{tilt}");
        let mut batch = subject.assembly.batch(&contact).expect("a contact");
        let answer = batch.effective_mass(&subject.good).expect("positions");
        assert_eq!(answer.remarks.contains(RemarkFlags::NEARLY_IMMOVABLE), expected, "{tilt}: {answer:?}");
        checked += 1;
    }
    assert_eq!(checked, 4);
}

#[test]
fn normals_in_the_world_go_by_the_base_that_is_given() {
    let conditions = Conditions::new().base(Base::Floating);
    let system = System::new(Arc::clone(ball().mechanism()), &conditions).expect("conditions that fit");
    let mut contact = on(&system, "tip", [0.1, 0.0, 0.2], [0.2, 0.1, 1.0]);
    contact.normal = Direction::Along(Vector3::new(0.2, 0.1, 1.0), Frame::World);
    let assembly = system.reference().expect("a tree");
    let row = [0.5, 0.5, -0.5, 0.5, 0.3];
    let turned = Transform::new(rotation_from_rpy([0.4, -0.9, 1.3]), Vector3::new(5.0, 6.0, 7.0));
    let mut configuration = Configuration::from_positions(system.mechanism(), &row).expect("positions");
    let mut workspace = assembly.workspace();
    workspace.set_positions(&row).expect("positions");
    for base in [None, Some(turned)] {
        if let Some(x_wr) = base {
            configuration.set_base(x_wr);
            workspace.set_base(&x_wr).expect("a rigid frame");
        }
        let pose = system.pose(&configuration).expect("a tree");
        let response = pose.respond(&contact).expect("a response");
        let EffectiveMass::Finite(expected) = response.effective_mass else { panic!("{response:?}") };
        let EffectiveMass::Finite(own) = workspace.effective_mass(&contact).expect("a mass") else {
            panic!()
        };
        let mut batch = workspace.batch(&contact).expect("a contact");
        let answer = batch.effective_mass(&row).expect("positions");
        let Some(EffectiveMass::Finite(of_batch)) = answer.mass else { panic!("{answer:?}") };
        assert!((own / expected - 1.0).abs() < 1e-13 && (of_batch / expected - 1.0).abs() < 1e-13);
        for flags in [response.remark_flags(), workspace.remarks(), answer.remarks] {
            assert_eq!(flags.contains(RemarkFlags::BASE_NOT_GIVEN), base.is_none(), "{flags:?}");
        }
    }
    // The base rotates the normal.
    let here =
        assembly.workspace().batch(&contact).expect("a contact").effective_mass(&row).expect("positions");
    let there = workspace.batch(&contact).expect("a contact").effective_mass(&row).expect("positions");
    assert_ne!(here.mass, there.mass);
}

#[test]
fn a_workspace_of_loops_that_do_not_close_refuses() {
    // The coupler is too short by half a metre.
    let system = {
        let built = MechanismBuilder::new("open")
            .link(LinkDescription::massless("ground"))
            .link(LinkDescription::new("arm", Inertial::diagonal(1.0, [0.1, 0.0, 0.0], [0.01, 0.01, 0.01])))
            .joint(
                JointDescription::new("hinge", JointKind::Continuous, "ground", "arm").axis([0.0, 0.0, 1.0]),
            )
            .closure(
                ClosureDescription::new("tie", ClosureKind::Spherical, "arm", "ground")
                    .at([0.2, 0.0, 0.0], [0.7, 0.0, 0.0])
                    .axis([0.0, 0.0, 1.0]),
            )
            .build()
            .expect("a good mechanism");
        System::new(built.mechanism, &Conditions::new()).expect("conditions that fit")
    };
    let contact = on(&system, "arm", [0.2, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let refused = system.workspace().effective_mass(&contact);
    assert!(matches!(refused, Err(ResponseError::OpenLoops { .. })), "{refused:?}");
}

#[test]
fn handles_hold_in_variants_and_nowhere_else() {
    let (long, short) = (
        four_bar([0.2, 0.7, 0.5, 0.6], 0.0, ClosureKind::Spherical),
        four_bar([0.3, 0.8, 0.6, 0.7], 0.0, ClosureKind::Spherical),
    );
    let other = ball();
    let link = long.mechanism().find_link("crank").expect("a link");
    assert!(long.mechanism().has_link(link) && short.mechanism().has_link(link));
    // The mechanism with the spherical joint has a link of this index.
    assert!(link.index() < other.mechanism().links().len() && !other.mechanism().has_link(link));
    let joint = long.mechanism().find_joint("crank_hinge").expect("a joint");
    assert!(short.mechanism().has_joint(joint) && !other.mechanism().has_joint(joint));
    assert!(!other.is_locked(joint));
}

/// A free body translates without rotation under a force through its centre of mass, and rotates without translation under a moment: it
/// moves in both. A held body does not move.
#[test]
fn a_body_that_only_translates_or_rotates_moves() {
    let body = |base| {
        let free = Inertial::diagonal(2.0, [0.0; 3], [0.1, 0.2, 0.3]);
        let builder = MechanismBuilder::new("body").link(LinkDescription::new("body", free));
        system(builder, &Conditions::new().base(base))
    };
    let link = |system: &System| system.mechanism().root();
    let free = body(Base::Floating);
    let force = Contact::new(link(&free), [0.0; 3], [1.0, 0.0, 0.0]);
    let moment = Contact { normal: Direction::About(Vector3::z(), Frame::Link), ..force };
    let pose = free.pose(&free.configuration()).expect("a pose");
    for (contact, mass) in [(force, 2.0), (moment, 0.3)] {
        let response = pose.respond(&contact).expect("a response");
        let EffectiveMass::Finite(found) = response.effective_mass else { panic!("{response:?}") };
        assert!((found - mass).abs() < 1e-15);
        let velocity = &response.base_velocity;
        assert!(velocity.angular.norm() == 0.0 || velocity.linear.norm() == 0.0);
        assert!(response.mechanism_moves());
    }
    let held = body(Base::Fixed);
    let pose = held.pose(&held.configuration()).expect("a pose");
    let response = pose.respond(&Contact { link: link(&held), ..force }).expect("a response");
    assert!(response.effective_mass == EffectiveMass::Immovable && !response.mechanism_moves());
}
