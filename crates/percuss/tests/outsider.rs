//! Tests of the public interface: uses only `percuss`, and names every returned type.

use percuss::nalgebra::{DMatrix, Vector3};
use percuss::spatial::{Transform, Twist};
use percuss::{
    Assembly, AssemblyError, Base, BranchLimits, Conditions, ConditionsError, Configuration,
    ConfigurationError, Contact, ContactError, ContactResponse, Contributions, Diagnostic, DrawnGap,
    EffectiveMass, ErrorBudget, InverseOperationalInertia, JointId, LinkId, LoadError, LoadOptions, Loaded,
    LocatedContact, LoopState, MassGradient, Mechanism, PointVelocity, Pose, PoseRank, ResponseError, Route,
    RouteError, Severity, Singularity, Source, StateSizeError, System, UnknownName, Workspace, load,
};
use std::sync::Arc;

#[path = "../examples/gradients.rs"]
mod gradients;
#[path = "../examples/own_solver.rs"]
mod own_solver;

const FOUR_BAR: &str = include_str!("../../../models/four_bar.urdf");
const ANTIPARALLELOGRAM: &str = include_str!("../../../models/antiparallelogram.urdf");

fn mechanism(name: &str, text: &str) -> Mechanism {
    let loaded: Result<Loaded, LoadError> = load(&Source::from_text(name, text), &LoadOptions::default());
    let Loaded { mechanism, diagnostics, .. } = loaded.unwrap();
    let diagnostics: Vec<Diagnostic> = diagnostics;
    assert!(diagnostics.iter().all(|d| d.severity != Severity::Error));
    mechanism
}

fn system(mechanism: Mechanism, conditions: &Conditions) -> System {
    let system: Result<System, ConditionsError> = System::new(mechanism, conditions);
    system.unwrap()
}

fn coupler(mechanism: &Mechanism) -> Contact {
    let link: Result<LinkId, UnknownName> = mechanism.find_link("coupler");
    Contact::new(link.unwrap(), [0.35, 0.1, 0.0], [0.0, 1.0, 0.0])
}

#[test]
fn what_an_assembly_knows() {
    let system = system(mechanism("four_bar.urdf", FOUR_BAR), &Conditions::new().base(Base::Fixed));
    let assembly: Result<&Arc<Assembly>, AssemblyError> = system.reference();
    let assembly: &Arc<Assembly> = assembly.unwrap();
    let groups: Vec<Vec<String>> = assembly.groups();
    let ranks: Vec<usize> = assembly.group_ranks();
    let drivers: Vec<JointId> = assembly.drivers();
    let redundant: &[Vec<String>] = assembly.redundant_loops();
    let gaps: Vec<DrawnGap> = assembly.drawn_gaps();
    assert_eq!(groups, [["rocker_pin"]]);
    assert_eq!(ranks, [2]);
    assert_eq!(drivers, [system.mechanism().find_joint("crank_hinge").unwrap()]);
    assert_eq!(redundant, [["rocker_pin"]]);
    assert_eq!((assembly.redundant_constraints(), assembly.degrees_of_freedom()), (3, 1));
    assert!(gaps.is_empty() && assembly.rank_is_clear());
}

#[test]
fn everything_at_a_pose() {
    let mechanism = mechanism("four_bar.urdf", FOUR_BAR);
    let contact = coupler(&mechanism);
    let system = system(mechanism, &Conditions::new().armature("crank_hinge", [0.01]));
    let assembly: Arc<Assembly> = Arc::clone(system.reference().unwrap());

    // Configuration in joint order: the crank is given, the other positions are initial guesses.
    let there: Result<Configuration, ConfigurationError> =
        Configuration::from_positions(system.mechanism(), &[0.4, -0.3, 0.1]);
    let pose: Result<Pose, AssemblyError> = assembly.pose(&there.unwrap());
    let pose: Pose = pose.unwrap();
    assert!((pose.positions()[0] - 0.4).abs() < 1e-12);
    let rank: PoseRank = pose.rank();
    let loops: Option<&LoopState> = pose.loops();
    let loops: &LoopState = loops.unwrap();
    let singularities: &Vec<Singularity> = &loops.singularities;
    assert_eq!((rank.rank, rank.singular, singularities[0]), (2, false, Singularity::None));
    assert!(loops.residual < 1e-12);

    let response: Result<ContactResponse, ResponseError> = pose.respond(&contact);
    let response: ContactResponse = response.unwrap();
    let EffectiveMass::Finite(m) = response.effective_mass else { panic!("{response:?}") };
    let budget: Option<ErrorBudget> = response.error;
    let ErrorBudget { rounding, closing, file } = budget.unwrap();
    let parts: [Option<f64>; 3] = [rounding, closing, file];
    assert!(parts[0].unwrap() < 1e-10 * m && parts[1].is_some());
    assert!(response.effective_mass_error().unwrap() < 1e-8 * m);
    let contributions: Option<Contributions> = response.contributions.clone();
    let Contributions { links, rotors, other_mass } = contributions.unwrap();
    let sum = links.iter().sum::<f64>() + rotors.iter().map(|(_, share)| share).sum::<f64>();
    assert!((sum - 1.0).abs() < 1e-12 && other_mass.is_none());
    let route: Route = response.route;
    assert_eq!(route, Route::Articulated);

    let located: Result<LocatedContact, ContactError> = pose.locate(&contact);
    let located: LocatedContact = located.unwrap();
    let (mass, rows): (DMatrix<f64>, DMatrix<f64>) = (pose.mass_matrix(), pose.constraint_matrix());
    let j: Vec<f64> = pose.contact_row(&located);
    assert_eq!((mass.shape(), rows.shape(), j.len()), ((3, 3), (5, 3), 3));
    let phi: Result<InverseOperationalInertia, RouteError> = pose.inverse_operational_inertia(&located);
    let inverse: f64 = phi.unwrap().inverse_effective_mass(&located.normal_world);
    assert!((inverse * m - 1.0).abs() < 1e-11);

    let velocity: Option<PointVelocity> = pose.point_velocity(&response, contact.link, &contact.point);
    let Some(PointVelocity::Known(velocity)) = velocity else { panic!("{velocity:?}") };
    assert!((velocity.dot(&located.normal_world) - 1.0).abs() < 1e-12);
    let base: &Twist<f64> = &response.base_velocity;
    let later: Result<Pose, StateSizeError> = pose.advanced(&response.joint_velocities, base, 1e-3);
    let frame: Transform<f64> = later.unwrap().link(contact.link);
    let moved: Vector3<f64> = frame.point(&contact.point) - located.point_world;
    assert!((moved.dot(&located.normal_world) - 1e-3).abs() < 1e-5);

    let mut workspace: Workspace = assembly.workspace();
    workspace.set_positions(pose.positions()).expect("positions that fit");
    // The kernel of a workspace states at most 1e-10.
    let again = workspace.effective_mass(&contact).unwrap().kilograms().unwrap();
    assert!((again - m).abs() < 1e-10 * m);
    let gradient: Option<MassGradient> = pose.effective_mass_gradient(&contact).unwrap();
    assert_eq!(gradient.unwrap().effective_mass, m);

    let limits: BranchLimits = pose.branch_limits(&contact);
    assert!(limits.limits.is_empty() && limits.complete);
}

#[test]
fn limits_where_branches_cross() {
    let mechanism = mechanism("antiparallelogram.urdf", ANTIPARALLELOGRAM);
    let contact = Contact::new(mechanism.find_link("rocker").unwrap(), [0.4, -0.3, 0.0], [3.0, 4.0, 0.0]);
    let system = system(mechanism, &Conditions::new());
    let mut folded: Configuration = system.configuration();
    // The crank is collinear with the hinges on the ground.
    folded.set("crank_hinge", &[f64::atan2(0.3, 0.72) - f64::atan2(0.3, 0.4)]).unwrap();
    let pose = system.pose(&folded).unwrap();
    let limits: BranchLimits = pose.branch_limits(&contact);
    let values: Vec<EffectiveMass> = limits.limits;
    assert!(pose.rank().singular && values.len() == 2 && !limits.continuous, "{values:?}");
}

#[test]
fn a_solver_of_ones_own() {
    own_solver::main().unwrap();
}

#[cfg(feature = "suspension")]
mod suspensions {
    use super::{Conditions, Contact, Diagnostic, EffectiveMass, LoadError, Severity, Source, system};
    use percuss::suspension::{ImportOptions, Imported, Rack, Side, Wheel, import};

    #[test]
    fn a_suspension_from_its_hardpoints() {
        let options = ImportOptions {
            side: Some(Side::Left),
            wheel: Some(Wheel { mass: 10.0, inertia: [0.3, 0.5, 0.3], radius: None }),
            rack: Some(Rack::Fixed),
            ..ImportOptions::default()
        };
        let imported: Result<Imported, LoadError> =
            import(&Source::from_text("corner.json", HARDPOINTS), &options);
        let Imported { mechanism, diagnostics, .. } = imported.unwrap();
        let diagnostics: Vec<Diagnostic> = diagnostics;
        assert!(diagnostics.iter().all(|d| d.severity != Severity::Error));
        let contact = Contact::new(mechanism.find_link("shock_seat").unwrap(), [0.0; 3], [0.0, 0.0, 1.0]);
        let system = system(mechanism, &Conditions::new());
        assert_eq!(system.degrees_of_freedom(), 2, "travel and spin");
        let response = system.pose(&system.configuration()).unwrap().respond(&contact);
        assert!(matches!(response.unwrap().effective_mass, EffectiveMass::Finite(m) if m > 1.0));
    }

    /// Hardpoints with round numbers.
    const HARDPOINTS: &str = r#"{
  "Name": "corner", "Type": "Suspension", "Template": "DoubleWishboneReduced",
  "Spindle": { "Mass": 2.0, "COM": [0.0, 0.9, -0.02], "Inertia": [0.02, 0.03, 0.025], "Radius": 0.1, "Width": 0.05 },
  "Axle": { "Inertia": 0.3 },
  "Upright": { "Mass": 3.0, "COM": [0.01, 0.8, 0.0], "Inertia": [0.05, 0.04, 0.03] },
  "Upper Control Arm": {
    "Location Chassis Front": [0.1, 0.45, 0.2], "Location Chassis Back": [-0.2, 0.48, 0.17],
    "Location Upright": [-0.03, 0.75, 0.22]
  },
  "Lower Control Arm": {
    "Location Chassis Front": [0.2, 0.35, -0.1], "Location Chassis Back": [-0.25, 0.33, -0.08],
    "Location Upright": [0.01, 0.82, -0.16]
  },
  "Tierod": { "Location Chassis": [-0.2, 0.4, 0.02], "Location Upright": [-0.15, 0.8, -0.03] },
  "Shock": {
    "Location Chassis": [0.03, 0.53, 0.4], "Location Upright": [0.05, 0.65, -0.1], "Damping Coefficient": 1e4
  }
}"#;
}

#[test]
fn the_example_of_gradients_agrees_with_differences() {
    gradients::main().unwrap();
}

#[test]
fn a_configuration_is_set_again_and_reset() {
    let mechanism = mechanism("four_bar.urdf", FOUR_BAR);
    let joint: JointId = mechanism.find_joint("crank_hinge").unwrap();
    let system = system(mechanism, &Conditions::new());
    let mut configuration = system.configuration();
    configuration.set("crank_hinge", &[0.1]).unwrap();
    assert!(matches!(configuration.set("crank_hinge", &[0.2]), Err(ConfigurationError::Twice { .. })));
    configuration.replace("crank_hinge", &[0.2]).unwrap();
    assert_eq!(configuration.get(joint), [0.2]);
    // A refused value changes nothing: the joint stays set.
    assert!(configuration.replace("crank_hinge", &[f64::NAN]).is_err());
    assert_eq!(configuration.get(joint), [0.2]);
    assert!(configuration.set("crank_hinge", &[0.3]).is_err());
    configuration.reset();
    assert_eq!(configuration.get(joint), [0.0]);
    configuration.set("crank_hinge", &[0.3]).unwrap();
}
