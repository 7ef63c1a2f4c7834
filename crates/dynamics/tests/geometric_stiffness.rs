//! Geometric stiffness of preloads and loads in frequencies, residual compliance and receptance.

use nalgebra::Vector3;
use percuss_dynamics::{
    ComplianceError, Conditions, Configuration, Contact, ElasticSystem, ElementMotion, LinearElement, Load,
    Pose, System,
};
use percuss_mechanism::{
    BushDescription, Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder,
};
use percuss_spatial::Transform;
use std::sync::Arc;

/// Length of the rod, m; mass at its end, kg; rotational stiffness of its foot, N·m/rad.
const ROD: [f64; 3] = [0.8, 3.0, 40.0];

/// Rod along z whose foot is in a bush without translations, with a point mass at its end.
fn rod() -> Pose {
    let [length, mass, rate] = ROD;
    let mut bush = BushDescription::new("foot", "rod", "ground").replacing("mount");
    bush.stiffness = [rate, rate, f64::INFINITY, f64::INFINITY, f64::INFINITY, f64::INFINITY];
    bush.rigid = [true; 6];
    let built = MechanismBuilder::new("rod")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("rod", Inertial::point(mass, [0.0, 0.0, length])))
        .joint(JointDescription::new("mount", JointKind::Fixed, "ground", "rod"))
        .bush(bush)
        .build();
    posed(built.expect("a mechanism").mechanism)
}

fn posed(mechanism: Mechanism) -> Pose {
    let mechanism = Arc::new(mechanism);
    let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("valid conditions");
    system.pose(&Configuration::zero(&mechanism)).expect("a tree has a pose")
}

/// System with a contact at a point of a link along x.
fn system(pose: &Pose, link: &str, at: [f64; 3], elements: &[LinearElement]) -> ElasticSystem {
    let link = pose.mechanism().find_link(link).expect("a link");
    let contact = pose.locate(&Contact::new(link, at, [1.0, 0.0, 0.0])).expect("a contact");
    ElasticSystem::new(pose, &contact, elements, None).expect("a system")
}

#[test]
fn a_pull_stiffens_a_rod_as_in_closed_form() {
    let ([length, mass, rate], pose) = (ROD, rod());
    let link = pose.mechanism().find_link("rod").expect("the rod");
    let end = [0.0, 0.0, length];
    for pull in [0.0, 25.0, 900.0, -30.0] {
        let load = Load::force(link, end.into(), Vector3::new(0.0, 0.0, pull));
        let loaded =
            system(&pose, "rod", end, &[]).with_geometric_stiffness(&[load], &[]).expect("in balance");
        let stiffness = rate + pull * length;
        let omega = (stiffness / (mass * length * length)).sqrt();
        let modes = loaded.modes().expect("stable");
        assert!(modes.iter().all(|mode| (mode.angular_frequency / omega - 1.0).abs() < 1e-11), "{pull}");
        let found = loaded.residual().expect("stable");
        let compliance = length * length / stiffness;
        assert!((found.compliance.expect("finite") / compliance - 1.0).abs() < 1e-11, "{pull}");
        assert!((found.free.kilograms().expect("finite") / mass - 1.0).abs() < 1e-13);
        let w = 0.7 * omega;
        let h = loaded.receptance(&[w]).expect("a solution")[0].expect("off the resonance").receptance;
        assert!((h.re * (stiffness / (length * length) - w * w * mass) - 1.0).abs() < 1e-10, "{pull}");
    }
    // A push above the critical force.
    let load = Load::force(link, end.into(), Vector3::new(0.0, 0.0, -1.01 * rate / length));
    let loaded = system(&pose, "rod", end, &[]).with_geometric_stiffness(&[load], &[]).expect("in balance");
    assert!(matches!(loaded.modes(), Err(ComplianceError::Unstable)));
    assert!(matches!(loaded.residual(), Err(ComplianceError::Unstable)));
}

#[test]
fn a_preloaded_spring_agrees_with_second_differences_of_the_energy() {
    let ([length, _, rate], pose) = (ROD, rod());
    let [link, ground] = ["rod", "ground"].map(|name| pose.mechanism().find_link(name).expect("a link"));
    let (seat, anchor) = (Vector3::new(0.1, 0.0, 0.6), Vector3::new(0.35, 0.0, 1.4));
    let (stiffness, force) = (700.0, 26.0);
    let motion = ElementMotion::Length([(link, seat), (ground, anchor)]);
    let spring = LinearElement { force, ..LinearElement::spring("spring", motion, stiffness) };
    // A moment holds the rod at rest; it does not change with small rotations about one axis.
    let lever = seat.cross(&((seat - anchor).normalize() * force)).y;
    let holding =
        Load { moment: Vector3::new(0.0, -lever, 0.0), ..Load::force(link, seat, Vector3::zeros()) };
    let end = [0.0, 0.0, length];
    let loaded = system(&pose, "rod", end, &[spring]).with_geometric_stiffness(&[holding], &[]);
    let found = loaded.expect("in balance").static_compliance().expect("a solution").expect("stiff");
    let whole = (seat - anchor).norm() + force / stiffness;
    let energy = |angle: f64| {
        let (s, c) = angle.sin_cos();
        let turned = Vector3::new(c * seat.x + s * seat.z, 0.0, c * seat.z - s * seat.x);
        let change = whole - (turned - anchor).norm();
        0.5 * rate * angle * angle + 0.5 * stiffness * change * change + lever * angle
    };
    let h = 1e-3;
    let second =
        (16.0 * (energy(h) + energy(-h)) - (energy(2.0 * h) + energy(-2.0 * h)) - 30.0 * energy(0.0))
            / (12.0 * h * h);
    // The part of the force is a tenth of the stiffness: a difference of fourth order of a sum of 100 J has seven digits.
    assert!((found * second / (length * length) - 1.0).abs() < 1e-7, "{found} {second}");
    let plain = rate + stiffness * ((seat - anchor).normalize().cross(&seat).y).powi(2);
    assert!((second / plain - 1.0).abs() > 0.03, "the force changes the stiffness: {second} {plain}");
}

#[test]
fn a_drive_carries_what_no_bush_carries() {
    // A cart on a rail with a lamp on a bush; the preload of the bush along the rail needs a drive.
    let mut bush = BushDescription::new("rubber", "lamp", "cart").replacing("mount");
    bush.stiffness = [5.0, 5.0, 5.0, 4e4, 4e4, 4e4];
    bush.preload = [0.0, 0.0, 0.0, 120.0, 0.0, 0.0];
    bush.frame = Transform::from_translation(Vector3::new(0.0, 0.0, 0.05));
    let built = MechanismBuilder::new("cart")
        .link(LinkDescription::massless("ground"))
        .link(LinkDescription::new("cart", Inertial::point(4.0, [0.0; 3])))
        .link(LinkDescription::new("lamp", Inertial::point(1.0, [0.0, 0.0, 0.3])))
        .joint(JointDescription::new("rail", JointKind::Prismatic, "ground", "cart"))
        .joint(JointDescription::new("mount", JointKind::Fixed, "cart", "lamp"))
        .bush(bush)
        .build();
    let pose = posed(built.expect("a mechanism").mechanism);
    let lamp = pose.mechanism().find_link("lamp").expect("the lamp");
    let rail = pose.mechanism().find_joint("rail").expect("the rail");
    let pull = Load::force(lamp, Vector3::new(0.0, 0.0, 0.3), Vector3::new(20.0, 0.0, 0.0));
    let at = || system(&pose, "lamp", [0.0, 0.0, 0.3], &[]);
    let refused = at().with_geometric_stiffness(std::slice::from_ref(&pull), &[]);
    assert!(matches!(refused, Err(ComplianceError::Unbalanced)));
    let held =
        at().with_geometric_stiffness(std::slice::from_ref(&pull), &[rail]).expect("held by the drive");
    // The drive carries the pull along the rail: a load of the cart with a constant direction.
    let cart = pose.mechanism().find_link("cart").expect("the cart");
    let drive = Load::force(cart, Vector3::zeros(), Vector3::new(-20.0, 0.0, 0.0));
    let loaded = at().with_geometric_stiffness(&[pull, drive], &[]).expect("in balance");
    let frequencies = |system: ElasticSystem| -> Vec<f64> {
        system.modes().expect("stable").iter().map(|mode| mode.angular_frequency).collect()
    };
    let (held, loaded, alone) = (frequencies(held), frequencies(loaded), frequencies(at()));
    assert!(held.len() == loaded.len() && held.len() == alone.len(), "{held:?} {loaded:?} {alone:?}");
    let largest = held.iter().copied().fold(0.0, f64::max);
    for (own, expected) in held.iter().zip(&loaded) {
        // Frequencies of 0 are roots of rounding.
        assert!((own - expected).abs() < 1e-7 * largest, "{own} {expected}");
    }
    let differs = held.iter().zip(&alone).any(|(own, alone)| (own / alone - 1.0).abs() > 1e-3);
    assert!(differs, "the forces change the frequencies: {held:?} {alone:?}");
}
