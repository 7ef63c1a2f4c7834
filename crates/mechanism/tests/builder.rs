//! Findings of the builder, one defect each.

use percuss_mechanism::{
    Accept, ClosureDescription, ClosureKind, CouplingDescription, Geometry, Inertial, JointDescription,
    JointKind, LinkDescription, Mechanism, MechanismBuilder, Problem, Severity, Subject,
};

fn rod() -> LinkDescription {
    LinkDescription::new("rod", Inertial::point(2.0, [0.0, 0.0, -0.5]))
}

fn hinge() -> JointDescription {
    JointDescription::new("hinge", JointKind::Revolute, "ground", "rod").axis([0.0, 1.0, 0.0])
}

fn with(link: LinkDescription, joint: JointDescription) -> MechanismBuilder {
    MechanismBuilder::new("pendulum").link(LinkDescription::massless("ground")).link(link).joint(joint)
}

fn errors(builder: MechanismBuilder) -> Vec<&'static str> {
    let findings = builder.build().expect_err("an error is due").findings;
    findings.iter().filter(|(_, p)| p.severity() == Severity::Error).map(|(_, p)| p.code()).collect()
}

#[test]
fn a_pendulum_is_built_without_complaint() {
    let built = with(rod(), hinge()).build().unwrap();
    assert!(built.findings.is_empty(), "{:?}", built.findings);
    let m = built.mechanism;
    assert_eq!(m.link(m.root()).name(), "ground");
    assert_eq!(m.total_mass(), 2.0);
    assert_eq!(m.characteristic_length(), 0.5);
    let near = m.find_link("rode").unwrap_err().near;
    assert_eq!(near, ["rod"]);
    // The name of a fixed joint is similar, but the joint has no position to name.
    let weld = JointDescription::new("weld", JointKind::Fixed, "rod", "tip");
    let welded =
        with(rod(), hinge()).link(LinkDescription::massless("tip")).joint(weld).build().unwrap().mechanism;
    let unknown = welded.find_joint("wedl").unwrap_err();
    assert_eq!(unknown.near, ["weld"]);
    // Indices hold for another mechanism if it has the name at the same place.
    let [own, tip] = ["rod", "tip"].map(|name| welded.find_link(name).unwrap());
    assert!(m.has_link(own) && welded.has_link(tip) && !m.has_link(tip));
    let other = LinkDescription::new("arm", Inertial::point(2.0, [0.0, 0.0, -0.5]));
    let renamed = JointDescription { child: "arm".into(), ..hinge() };
    assert!(!with(other, renamed).build().unwrap().mechanism.has_link(own));
    // Without another length, the largest radius of gyration counts: √(tr I/m).
    let body = LinkDescription::new("rod", Inertial::diagonal(2.0, [0.0; 3], [4.0, 5.0, 6.0]));
    let length = with(body, hinge()).build().unwrap().mechanism.characteristic_length();
    assert!((length - 7.5f64.sqrt()).abs() < 1e-15, "{length}");
}

#[test]
fn a_mechanism_is_shared_between_threads() {
    fn shared<T: Send + Sync>() {}
    shared::<Mechanism>();
}

#[test]
fn every_defect_has_its_error() {
    assert_eq!(errors(MechanismBuilder::new("empty")), ["no-links"]);
    assert_eq!(errors(with(rod(), hinge()).link(rod())), ["duplicate-name"]);
    assert_eq!(errors(with(rod(), hinge()).link(LinkDescription::massless(""))), ["empty-name"]);
    assert_eq!(errors(with(rod(), hinge()).link(LinkDescription::massless("stray"))), ["several-roots"]);
    assert_eq!(errors(with(rod(), hinge().axis([0.0; 3]))), ["zero-axis"]);
    assert_eq!(errors(with(rod(), hinge().at([f64::NAN, 0.0, 0.0]))), ["not-finite"]);
    assert_eq!(errors(with(rod(), hinge().at([1e200, 0.0, 0.0]))), ["too-large"]);
    assert_eq!(errors(with(rod(), hinge().armature(-1.0))), ["negative-armature"]);
    assert_eq!(errors(with(rod(), hinge().mimic("hinge", 1.0, 0.0))), ["mimic-cycle"]);
    let negative = LinkDescription::new("rod", Inertial::point(-1.0, [0.0; 3]));
    assert_eq!(errors(with(negative, hinge())), ["negative-mass"]);
    let unknown = JointDescription { parent: "grund".into(), ..hinge() };
    assert_eq!(errors(with(rod(), unknown)), ["unknown-link"]);
    let itself = JointDescription { parent: "rod".into(), ..hinge() };
    assert!(errors(with(rod(), itself)).contains(&"joins-itself"));
    let second = JointDescription { name: "second".into(), kind: JointKind::Floating, ..hinge() };
    assert_eq!(errors(with(rod(), hinge()).joint(second)), ["two-parents"]);
    let mut skew = hinge();
    skew.origin.rotation *= 1.01;
    assert_eq!(errors(with(rod(), skew)), ["not-a-rotation"]);
    let free = JointDescription { kind: JointKind::Floating, ..hinge() };
    assert_eq!(errors(with(rod(), free.armature(1.0))), ["armature-count"]);
}

#[test]
fn cycles_are_named_with_and_without_a_root() {
    let ring = |b: MechanismBuilder| {
        b.link(LinkDescription::massless("a"))
            .link(LinkDescription::massless("b"))
            .joint(JointDescription::new("ab", JointKind::Revolute, "a", "b"))
            .joint(JointDescription::new("ba", JointKind::Revolute, "b", "a"))
    };
    for builder in [MechanismBuilder::new("ring"), with(rod(), hinge())] {
        let findings = ring(builder).build().unwrap_err().findings;
        let cycle = findings.iter().find_map(|(_, p)| match p {
            Problem::Cycle { links } => Some(links.clone()),
            _ => None,
        });
        let mut cycle = cycle.expect("a cycle");
        cycle.sort();
        assert_eq!(cycle, ["a", "b"]);
    }
}

#[test]
fn a_negative_moment_is_an_error_unless_accepted() {
    let bad = || LinkDescription::new("rod", Inertial::diagonal(1.0, [0.0; 3], [0.1, 0.1, -0.01]));
    assert_eq!(errors(with(bad(), hinge())), ["indefinite-inertia"]);
    let built = with(bad(), hinge())
        .accept(Accept { indefinite_inertia: true, ..Accept::default() })
        .build()
        .unwrap();
    assert_eq!(built.findings[0].1.severity(), Severity::Warning);
    // The tree of an accepted mechanism is accepted too.
    assert!(built.mechanism.to_open_tree().build().is_ok());
    let problem = |mass: f64, accept: Accept| {
        let inertial = Inertial::diagonal(mass, [0.0, 0.0, -0.5], [1e9; 3]);
        let wide =
            LinkDescription { geometry: Geometry::Within(0.5), ..LinkDescription::new("rod", inertial) };
        let found = with(wide, hinge()).build().unwrap().mechanism.implausible_inertias(accept);
        found.into_iter().next().expect("a finding").1
    };
    let accept = Accept { implausible_inertia: true, ..Accept::default() };
    assert!(matches!(problem(1.0, Accept::default()), Problem::WideInertia { far: true, .. }));
    assert!(matches!(problem(1.0, accept), Problem::WideInertia { far: false, .. }));
    // Without any mass there is no radius of gyration.
    assert!(matches!(problem(0.0, accept), Problem::InertiaWithoutMass { .. }));
    let heavy = LinkDescription::new("ground", Inertial::point(2.0, [0.0; 3]));
    let still =
        MechanismBuilder::new("door").link(heavy).link(LinkDescription::massless("rod")).joint(hinge());
    assert!(!still.build().unwrap().mechanism.has_moving_mass());
}

#[test]
fn chained_mimics_are_resolved_and_dangling_ones_move_freely() {
    let arm = |name: &str| LinkDescription::new(name, Inertial::point(1.0, [0.1, 0.0, 0.0]));
    let joint = |name: &str, parent: &str, child: &str| {
        JointDescription::new(name, JointKind::Revolute, parent, child)
    };
    let built = with(rod(), hinge())
        .link(arm("a"))
        .link(arm("b"))
        .link(arm("c"))
        .joint(joint("ja", "rod", "a").mimic("hinge", 2.0, 0.5))
        .joint(joint("jb", "a", "b").mimic("ja", -3.0, 0.25))
        .joint(joint("jc", "b", "c").mimic("jd", 1.0, 0.0))
        .build()
        .unwrap();
    let m = &built.mechanism;
    let mimic = m.joint(m.find_joint("jb").unwrap()).mimic().unwrap();
    assert_eq!(m.joint(mimic.master).name(), "hinge");
    assert_eq!((mimic.multiplier, mimic.offset), (-6.0, -3.0 * 0.5 + 0.25));
    assert!(m.joint(m.find_joint("jc").unwrap()).mimic().is_none());
    assert_eq!(built.findings[0].1.code(), "dangling-mimic");
}

#[test]
fn a_circle_of_mimics_is_told_once_and_long_chains_are_quick() {
    let arm = |i: usize| LinkDescription::new(format!("l{i}"), Inertial::point(1.0, [0.1, 0.0, 0.0]));
    let chain = |n: usize, first: usize| {
        (1..=n).fold(MechanismBuilder::new("chain").link(arm(0)), |b, i| {
            let master = if i == 1 { first } else { i - 1 };
            let joint = JointDescription::new(
                format!("j{i}"),
                JointKind::Revolute,
                format!("l{}", i - 1),
                format!("l{i}"),
            );
            let joint = if master == 0 { joint } else { joint.mimic(format!("j{master}"), 1.0, 0.5) };
            b.link(arm(i)).joint(joint)
        })
    };
    // j1 follows j3: a cycle of three joints, and a chain of seven that leads into the cycle.
    assert_eq!(errors(chain(10, 3)), ["mimic-cycle"]);
    // A chain of 100,000 mimics: the test takes hours unless the cost is linear.
    let built = chain(100_000, 0).build().unwrap().mechanism;
    let last = built.joint(built.find_joint("j100000").unwrap()).mimic().unwrap();
    assert_eq!((built.joint(last.master).name(), last.offset), ("j1", 0.5 * 99_999.0));
}

/// Ground and two arms on revolute joints.
fn arms() -> MechanismBuilder {
    let arm = |name: &str| LinkDescription::new(name, Inertial::point(1.0, [0.1, 0.0, 0.0]));
    let joint = |name: &str, child: &str| JointDescription::new(name, JointKind::Revolute, "ground", child);
    MechanismBuilder::new("arms")
        .link(LinkDescription::massless("ground"))
        .link(arm("a"))
        .link(arm("b"))
        .joint(joint("ja", "a"))
        .joint(joint("jb", "b"))
}

fn ratio(name: &str, predecessor: &str, successor: &str) -> CouplingDescription {
    CouplingDescription {
        name: name.into(),
        predecessor: predecessor.into(),
        successor: successor.into(),
        ratio: 2.0,
    }
}

#[test]
fn bad_loops_have_their_errors() {
    let rod = |from: &str, to: &str| ClosureDescription::new("rod", ClosureKind::Distance, from, to);
    assert_eq!(errors(arms().closure(rod("a", "nowhere"))), ["unknown-link"]);
    assert_eq!(errors(arms().closure(rod("a", "a"))), ["closes-on-itself"]);
    assert_eq!(errors(arms().closure(rod("a", "b").distance(0.0))), ["bad-distance"]);
    assert_eq!(errors(arms().closure(rod("a", "b").distance(f64::NAN))), ["not-finite"]);
    let pin = ClosureDescription::new("pin", ClosureKind::Revolute, "a", "b");
    assert_eq!(errors(arms().closure(pin.clone().axis([0.0; 3]))), ["zero-axis"]);
    assert_eq!(errors(arms().closure(pin.clone()).closure(pin.clone())), ["duplicate-name"]);
    let hooke = ClosureDescription { kind: ClosureKind::Universal, ..pin };
    assert_eq!(errors(arms().closure(hooke.axis2([0.0; 3]))), ["zero-axis"]);
    assert_eq!(errors(arms().coupling(ratio("c", "a", "a"))), ["closes-on-itself"]);
    assert_eq!(errors(arms().coupling(ratio("c", "a", "world"))), ["unknown-link"]);
    assert_eq!(
        errors(arms().coupling(ratio("c", "a", "b")).coupling(ratio("d", "b", "a"))),
        ["coupling-cycle"]
    );
    let free = JointDescription::new("free", JointKind::Spherical, "ground", "ball");
    let ball = arms().link(LinkDescription::new("ball", Inertial::point(1.0, [0.1, 0.0, 0.0]))).joint(free);
    assert_eq!(errors(ball.coupling(ratio("c", "a", "ball"))), ["coupling-kind"]);
}

#[test]
fn a_second_parent_closes_a_loop_and_indices_stay_those_given() {
    let pin =
        JointDescription::new("pin", JointKind::Revolute, "a", "b").at([0.2, 0.0, 0.0]).axis([0.0, 0.0, 2.0]);
    let tip = LinkDescription::new("tip", Inertial::point(1.0, [0.1, 0.0, 0.0]));
    let last = JointDescription::new("last", JointKind::Revolute, "b", "tip").mimic("nobody", 1.0, 0.0);
    let built = arms().joint(pin).link(tip).joint(last).build().unwrap();
    let m = &built.mechanism;
    assert_eq!((m.joints().len(), m.closures().len()), (3, 1));
    let closure = &m.closures()[0];
    assert_eq!((closure.name(), closure.kind()), ("pin", ClosureKind::Revolute));
    assert_eq!(closure.predecessor().frame.translation.x, 0.2);
    assert_eq!(closure.axis().z, 1.0);
    let codes: Vec<_> = built.findings.iter().map(|(s, p)| (s.clone(), p.code())).collect();
    assert!(codes.contains(&(Subject::Joint { index: 2, name: "pin".into() }, "second-parent")), "{codes:?}");
    assert!(
        codes.contains(&(Subject::Joint { index: 3, name: "last".into() }, "dangling-mimic")),
        "{codes:?}"
    );
}

#[test]
fn a_coupling_sums_the_joints_from_the_common_ancestor() {
    let built = arms().coupling(ratio("gear", "a", "b")).build().unwrap().mechanism;
    let terms: Vec<_> =
        built.couplings()[0].terms().iter().map(|(j, f)| (built.joint(*j).name(), *f)).collect();
    assert_eq!(terms, [("jb", 1.0), ("ja", -2.0)]);
}
