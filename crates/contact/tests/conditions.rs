//! Conditions of the stated errors (mechanisms, drift of the effective mass, single precision, gravity), and penetrations.

use percuss_contact::exports::{Export, ExportError, MassDrift, Options, Request, StopMotion, Tool};
use percuss_contact::{CompliantContact, LawParameter};

const STIFFNESS: f64 = 1e5;
const SPEED: f64 = 1.0;

/// Contact with m̄ = 24 kg on a hinged body whose effective mass without the hinge is `free` kg.
fn hinged(e: f64, free: f64) -> Request<'static> {
    let options = Options { free_mass: Some(free), moving_bodies: Some(1), ..Options::default() };
    Request { options, ..Request::new(CompliantContact::new(24.0, STIFFNESS).unwrap(), e).at(SPEED) }
}

fn bound(tool: Tool, request: &Request) -> f64 {
    tool.export(request).unwrap().error_bound.unwrap()
}

fn penetration(export: &Export) -> f64 {
    export.penetrations[0].value
}

/// Block Gauss–Seidel of a hinge and a contact leaves (1 + e)(1 − m_f/m̄)^N.
#[test]
fn jolt_has_the_velocity_steps_that_the_mass_ratio_needs() {
    for e in [0.15, 0.5, 0.9] {
        for free in [24.0 / 48.0, 24.0 / 12.0, 24.0 / 3.0] {
            let export = Tool::JOLT.export(&hinged(e, free)).unwrap();
            let turns = export.number("mNumVelocitySteps").unwrap();
            let left = (1.0 + e) * (1.0 - free / 24.0_f64).powf(turns);
            assert!(left <= 5.001e-5 && turns >= 50.0, "{e} {free}: {turns} leave {left:e}");
            assert!(export.error_bound.unwrap() > left);
        }
    }
    let turns = Tool::JOLT.export(&hinged(0.9, 0.5)).unwrap().number("mNumVelocitySteps").unwrap();
    assert!((400.0..600.0).contains(&turns), "{turns}");
    let error = Tool::JOLT.export(&hinged(0.9, 1e-3)).unwrap_err();
    assert!(matches!(error, ExportError::Unreachable { .. }), "{error}");
    let mut chain = hinged(0.5, 2.0);
    chain.options.moving_bodies = Some(2);
    assert!(Tool::JOLT.export(&chain).unwrap().error_bound.is_none());
}

#[test]
fn rigid_contacts_of_mechanisms_have_an_error_in_proportion_to_the_travel() {
    for tool in [Tool::RAPIER, Tool::DART, Tool::GAZEBO, Tool::JOLT] {
        let request = hinged(0.5, 2.0);
        let recommended = tool.export(&request).unwrap();
        assert!(recommended.error_bound.unwrap() <= 1e-3, "{tool}: {:?}", recommended.error_bound);
        let stepping = |step: f64| {
            let mut request = request;
            request.options.time_step = Some(step);
            tool.export(&request).unwrap().error_bound
        };
        let step = recommended.time_step.unwrap();
        let slope = (stepping(4.0 * step).unwrap() - stepping(2.0 * step).unwrap()) / (2.0 * step * SPEED);
        assert!((slope / 15.0 - 1.0).abs() < 1e-6, "{tool}: {slope}");
        // Measured error of a double pendulum in Rapier: 1.2e-2 at 1/60 s and 0.3 m/s.
        if tool == Tool::RAPIER {
            assert!(stepping(0.3 / 60.0).unwrap() > 1.2e-2);
        }
        let free = hinged(0.5, 24.0);
        assert!(bound(tool, &free) <= 1.1e-4, "{tool}");
        if tool == Tool::RAPIER {
            let unknown = tool.export(&Request { speed: None, ..request }).unwrap();
            assert!(unknown.error_bound.is_none() && unknown.missing.len() == 1);
        }
    }
}

#[test]
fn drift_of_the_mass_enlarges_every_bound() {
    for tool in [
        Tool::MUJOCO,
        Tool::DRAKE,
        Tool::ODE,
        Tool::BULLET,
        Tool::PHYSX,
        Tool::EXUDYN,
        Tool::NEWTON,
        Tool::SIMSCAPE,
    ] {
        let still = hinged(0.5, 24.0);
        let mut moving = still;
        let own = penetration(&Tool::MUJOCO.export(&still).unwrap());
        moving.options.drift = Some(MassDrift { relative: -0.01, penetration: own });
        let added = bound(tool, &moving) - bound(tool, &still);
        // 0.423 of the drift for e = 0.5, at the penetration of the tool.
        let linear = 0.01 * 0.5 * (1.0 + 2.0_f64.ln()) / 2.0;
        assert!(added > 0.6 * linear && added < 2.5 * linear, "{tool}: {added:e}, {linear:e}");
    }
}

#[test]
fn single_precision_is_in_the_bound_or_refused() {
    let at = |stiffness: f64, speed: f64| {
        Request::new(CompliantContact::new(2.0, stiffness).unwrap(), 0.5).at(speed)
    };
    for tool in [Tool::PHYSX, Tool::NEWTON] {
        assert!(bound(tool, &at(1e4, 2.0)) < 2e-3, "{tool}");
        assert!(bound(tool, &at(1e5, 0.3)) > 4e-3, "{tool}");
        let error = tool.export(&at(1e6, 0.02)).unwrap_err();
        assert!(matches!(error, ExportError::Unreachable { .. }), "{tool}: {error}");
        assert!(tool.export(&Request { speed: None, ..at(1e5, 1.0) }).unwrap().error_bound.is_none());
    }
    let bullet = Tool::BULLET.export(&at(1e5, 0.02)).unwrap();
    assert!(bullet.error_bound.unwrap() < 1.001e-3 && bullet.single_precision_error.unwrap() > 1.4e-2);
}

#[test]
fn stops_in_loops_and_chains_state_no_error() {
    for tool in [Tool::PHYSX, Tool::NEWTON] {
        let mut request = Request::new(CompliantContact::new(0.6, 700.0).unwrap(), 0.5).at(0.1);
        request.options.stop = Some(StopMotion::Turn);
        let one = tool.export(&request).unwrap();
        assert!(one.error_bound.is_some() && one.penetrations[0].unit == "rad");
        request.options.constrained = true;
        request.options.closed_loops = true;
        let looped = tool.export(&request).unwrap();
        assert!(looped.error_bound.is_none(), "{tool}");
        assert!(looped.assumptions.iter().any(|text| text.contains("no error is stated")), "{tool}");
    }
    let mut chain = Request::new(CompliantContact::new(0.6, 700.0).unwrap(), 0.5).at(0.1);
    chain.options.stop = Some(StopMotion::Turn);
    chain.options.moving_bodies = Some(2);
    assert!(Tool::PHYSX.export(&chain).unwrap().error_bound.is_none());
    assert!(Tool::NEWTON.export(&chain).unwrap().error_bound.is_some());
}

#[test]
fn drake_at_a_given_step_states_the_error_of_lagged_too() {
    let mut request = hinged(0.9, 24.0);
    request.options.time_step = Some(1e-4);
    let frequency = (STIFFNESS / 24.0_f64).sqrt();
    let lagged = std::f64::consts::FRAC_PI_2 * 0.9 * frequency * 1e-4;
    assert!((bound(Tool::DRAKE, &request) / lagged - 1.0).abs() < 1e-12);
}

/// Deviation from the penetration of the linear law at e = 0.15: −61 % in Newton, +39 % in Exudyn.
#[test]
fn penetrations_are_those_of_the_tools_own_laws() {
    let request = hinged(0.15, 24.0);
    let of = |tool: Tool, request: &Request| penetration(&tool.export(request).unwrap());
    let linear = of(Tool::MUJOCO, &request);
    let frequency = (STIFFNESS / 24.0_f64).sqrt();
    assert!((linear * frequency / SPEED - 0.15_f64.sqrt()).abs() < 1e-9);
    assert!((of(Tool::NEWTON, &request) / linear - 0.39).abs() < 0.01);
    assert!((of(Tool::EXUDYN, &request) / linear - 1.39).abs() < 0.01);
    let hertz = Request { contact: request.contact.with_exponent(1.5).unwrap(), ..request };
    let chrono = Request {
        options: Options { own_mass: Some(24.0), other_own_mass: Some(1e6), ..request.options },
        ..hertz
    };
    // Hertz contact: the penetration in OpenSim is 14 % larger than with the damper proportional to x^(1/4).
    let ratio = of(Tool::OPENSIM, &hertz) / of(Tool::CHRONO, &chrono);
    assert!((ratio - 1.14).abs() < 0.02, "{ratio}");
    let adams = of(Tool::ADAMS, &request);
    assert!((0.8..1.6).contains(&(adams / linear)), "{}", adams / linear);
    assert!(Tool::RAPIER.export(&request).unwrap().penetrations.is_empty());
    assert!(Tool::MUJOCO.export(&Request { speed: None, ..request }).unwrap().penetrations.is_empty());
}

#[test]
fn gravity_is_a_stated_condition() {
    // Integrated: 2.3 g/(v ω) for e = 0.15, 0.27 for 0.8.
    for (e, slope) in [(0.15, 2.3), (0.3, 1.33), (0.5, 0.78), (0.8, 0.27), (0.9, 0.13)] {
        let request = hinged(e, 24.0);
        let loss = request.gravity_loss().unwrap() / (9.81 / (SPEED * (STIFFNESS / 24.0_f64).sqrt()));
        assert!((loss / slope - 1.0).abs() < 0.1, "{e}: {loss}");
        for tool in [Tool::MUJOCO, Tool::DRAKE, Tool::ODE, Tool::NEWTON] {
            let export = tool.export(&request).unwrap();
            assert!(export.assumptions.iter().any(|text| text.contains("gravity")), "{tool}");
        }
    }
    assert!(Request { speed: None, ..hinged(0.5, 24.0) }.gravity_loss().is_none());
    assert!(hinged(0.0, 24.0).gravity_loss().is_none());
    let stop = Options { stop: Some(StopMotion::Turn), ..Options::default() };
    assert!(Request { options: stop, ..hinged(0.5, 24.0) }.gravity_loss().is_none());
    // The loss is proportional to 1/v; from e/3 on the body does not rebound.
    for (part, prevents) in [(0.3, false), (0.35, true), (0.9, true), (1.2, true)] {
        let request = hinged(0.6, 24.0);
        let speed = SPEED * request.gravity_loss().unwrap() / (part * 0.6);
        let export = Tool::MUJOCO.export(&request.at(speed)).unwrap();
        assert_eq!(export.weight_prevents_rebound, prevents, "{part}");
    }
}

#[test]
fn an_error_larger_than_the_restitution_is_refused() {
    let mut request = hinged(0.005, 24.0);
    assert!(bound(Tool::MUJOCO, &request) <= 1e-3);
    request.options.accuracy = 0.1;
    let error = Tool::EXUDYN.export(&request).unwrap_err();
    assert!(matches!(error, ExportError::Unreachable { .. }), "{error}");
    assert_eq!(error.parameter(), Some(LawParameter::Restitution));
}

/// A lever of 0.05 m has a shorter step than a lever of 0.5 m.
#[test]
fn the_step_of_rigid_contacts_follows_the_curvature_of_the_motion() {
    for tool in [Tool::RAPIER, Tool::DART, Tool::GAZEBO, Tool::JOLT] {
        let step = |curvature: f64| {
            let mut request = hinged(0.5, 12.0);
            request.options.motion_curvature = Some(curvature);
            let export = tool.export(&request).unwrap();
            assert!(export.error_bound.unwrap() <= 1e-3, "{tool}: {:?}", export.error_bound);
            export.time_step.unwrap()
        };
        assert!((step(40.0) / step(400.0) / 10.0 - 1.0).abs() < 1e-9, "{tool}");
        assert_eq!(step(0.0), step(1e-3), "{tool}");
        let mut request = hinged(0.5, 12.0);
        request.options.motion_curvature = Some(5.0);
        let export = tool.export(&request).unwrap();
        assert!(export.assumptions.iter().any(|text| text.contains("L = 0.20 m")), "{tool}");
    }
}

/// The joints of SemiImplicit are springs, and XPBD has no armature.
#[test]
fn newton_exports_only_featherstone_for_mechanisms() {
    let solvers = |request: &Request| {
        let export = Tool::NEWTON.export(request).unwrap();
        let text = &export.snippets[0].text;
        let found =
            ["SolverFeatherstone", "SolverSemiImplicit", "SolverXPBD"].map(|name| text.contains(name));
        (found, export.number("dt_xpbd").is_some())
    };
    assert_eq!(solvers(&hinged(0.5, 2.0)), ([true, false, false], false));
    assert_eq!(solvers(&hinged(0.5, 24.0)), ([true; 3], true));
}

#[test]
fn errors_name_their_parameter() {
    let own_mass = Options { own_mass: Some(0.0), ..Options::default() };
    for (request, parameter) in [
        (Request { restitution: -0.1, ..hinged(0.5, 24.0) }, LawParameter::Restitution),
        (Request { options: own_mass, ..hinged(0.5, 24.0) }, LawParameter::OwnMass),
        (hinged(0.5, 24.0).at(0.0), LawParameter::Speed),
    ] {
        assert_eq!(Tool::MUJOCO.export(&request).unwrap_err().parameter(), Some(parameter));
    }
}

/// The largest step of Drake's integrator falls with the root of the accuracy, and in units of 1/ω it does not depend on the contact. That of
/// Adams is a part of the time in which the ramp of the damping is crossed.
#[test]
fn largest_steps_scale_with_the_contact() {
    let drake = |accuracy: f64, stiffness: f64| {
        let mut request = hinged(0.5, 24.0);
        request.contact = CompliantContact::new(request.contact.mass(), stiffness).unwrap();
        request.options.accuracy = accuracy;
        Tool::DRAKE.export(&request).unwrap().number("max_step_size").unwrap() * stiffness.sqrt()
    };
    let usual = drake(1e-3, 1e4);
    assert!((drake(1e-3, 1e6) / usual - 1.0).abs() < 1e-12);
    assert!((drake(1e-5, 1e4) / usual / 0.1 - 1.0).abs() < 1e-12);
    let adams = |speed: f64, stiffness: f64| {
        let mut request = hinged(0.5, 24.0);
        request.contact = CompliantContact::new(request.contact.mass(), stiffness).unwrap();
        request.speed = Some(speed);
        let export = Tool::ADAMS.export(&request).unwrap();
        ["HMAX", "d"].map(|name| export.number(name).unwrap())
    };
    let ([first, ramp], [other, longer]) = (adams(1.0, 1e6), adams(3.0, 1e4));
    assert!(longer > 2.0 * ramp && (other * 3.0 / longer / (first / ramp) - 1.0).abs() < 1e-12);
}

/// A smaller required error reduces the accuracy of OpenSim's integrator in proportion, and its largest step by the square root.
#[test]
fn opensim_integrates_as_accurately_as_required() {
    let numbers = |accuracy: f64| {
        let mut request = hinged(0.5, 24.0);
        request.contact = request.contact.with_exponent(1.5).unwrap();
        request.options.accuracy = accuracy;
        let export = Tool::OPENSIM.export(&request).unwrap();
        ["integrator_accuracy", "maximum_step_size"].map(|name| export.number(name).unwrap())
    };
    let ([usual, step], [finer, shorter], coarser) = (numbers(1e-3), numbers(1e-5), numbers(1e-2));
    assert!((finer / usual / 0.01 - 1.0).abs() < 1e-12 && (shorter / step / 0.1 - 1.0).abs() < 1e-12);
    assert_eq!(coarser, [usual, step]);
}
