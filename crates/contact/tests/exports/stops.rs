//! Joint stops: supported tools; models of the engines' steps reach the required restitution at the stop.

use percuss_contact::CompliantContact;
use percuss_contact::exports::{Export, ExportError, Options, Request, StopMotion, Tool};

const INERTIA: f64 = 0.6;
const STIFFNESS: f64 = 700.0;
const RESTITUTIONS: [f64; 12] = [0.005, 0.01, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99];
const SUPPORTED: [Tool; 4] = [Tool::MUJOCO, Tool::ODE, Tool::NEWTON, Tool::PHYSX];

fn request(restitution: f64, motion: StopMotion) -> Request<'static> {
    let options = Options { stop: Some(motion), ..Options::default() };
    Request {
        options,
        ..Request::new(CompliantContact::new(INERTIA, STIFFNESS).unwrap(), restitution).at(0.1)
    }
}

/// Error by single precision in the bound: the rounding of an angle from 0.25 to 0.5 rad divided by the travel of a step.
fn single(step: f64) -> f64 {
    1.5e-8 / (0.1 * step)
}

fn number(export: &Export, name: &str) -> f64 {
    export.number(name).unwrap_or_else(|| panic!("{}: no {name}", export.tool))
}

/// Restitution with the time step x, v ↦ v⁺ of an engine (x displacement beyond the stop, v speed into the stop): of all
/// phases, the value with the largest deviation from `e`. The stop acts in steps that begin beyond the stop.
fn worst(e: f64, step: f64, next: impl Fn(f64, f64) -> f64) -> f64 {
    let mut worst: f64 = 0.0;
    for phase in 0..40 {
        let (mut x, mut v) = (-(f64::from(phase) + 0.5) / 40.0 * step, 1.0);
        while x > 0.0 || v > 0.0 {
            v = if x > 0.0 { next(x, v) } else { v };
            x += step * v;
        }
        worst = worst.max((-v - e).abs());
    }
    worst
}

#[test]
fn implicit_engines_reach_the_restitution_at_stops() {
    for e in RESTITUTIONS {
        for tool in [Tool::ODE, Tool::PHYSX] {
            let export = tool.export(&request(e, StopMotion::Turn)).unwrap();
            let h = export.time_step.unwrap();
            let bound = export.error_bound.unwrap() - if tool == Tool::PHYSX { single(h) } else { 0.0 };
            let (k, c) = if tool == Tool::ODE {
                let (erp, cfm) = (number(&export, "stop_erp"), number(&export, "stop_cfm"));
                (erp / (h * cfm), (1.0 - erp) / cfm)
            } else {
                (number(&export, "limit_stiffness"), number(&export, "limit_damping"))
            };
            assert!((k / STIFFNESS - 1.0).abs() < 1e-9, "{tool} {e}: {k}");
            let found = worst(e, h, |x, v| {
                let stopped = (v - h / INERTIA * k * x) / (1.0 + h / INERTIA * (h * k + c));
                // Joint limits of PhysX pull.
                let pulls = tool == Tool::PHYSX || k * (x + h * stopped) + c * stopped > 0.0;
                if pulls { stopped } else { v }
            });
            assert!(found <= bound && bound <= 1.0001e-3, "{tool} {e}: {found:e}, bound {bound:e}");
        }
    }
}

#[test]
fn newton_reaches_the_restitution_at_stops_with_a_pulling_damper() {
    for e in RESTITUTIONS {
        for accuracy in [1e-2, 1e-3, 1e-4] {
            // At 40 rad/s the error by single precision is small.
            let mut request = request(e, StopMotion::Turn).at(40.0);
            request.options.accuracy = accuracy;
            if accuracy > e {
                assert!(matches!(Tool::NEWTON.export(&request), Err(ExportError::Unreachable { .. })), "{e}");
                continue;
            }
            let export = Tool::NEWTON.export(&request).unwrap();
            let h = export.time_step.unwrap();
            let bound = export.error_bound.unwrap() - single(h) * 0.1 / 40.0;
            let (k, c) = (number(&export, "limit_ke"), number(&export, "limit_kd"));
            let found = worst(e, h, |x, v| v - h / INERTIA * (k * x + c * v));
            assert!(
                found <= bound && bound <= accuracy * (1.0 + 1e-12),
                "{e} {accuracy}: {found:e}, bound {bound:e}"
            );
        }
    }
}

#[test]
fn tools_without_stops_give_reason_and_remedy() {
    for tool in Tool::ALL {
        for motion in [StopMotion::Turn, StopMotion::Slide] {
            match tool.export(&request(0.5, motion)) {
                Ok(export) => {
                    assert!(SUPPORTED.contains(&tool) && !export.snippets.is_empty(), "{tool}");
                    for snippet in &export.snippets {
                        let step = format!("{:?}", export.time_step.unwrap());
                        assert!(snippet.text.contains(&step) && !snippet.text.contains("inf"), "{tool}");
                    }
                    let rounds = tool == Tool::NEWTON || tool == Tool::PHYSX;
                    let added = if rounds { single(export.time_step.unwrap()) } else { 0.0 };
                    assert!(
                        export.error_bound.unwrap() - added <= 1.0001e-3 && !export.assumptions.is_empty()
                    );
                }
                Err(error) => {
                    assert!(!SUPPORTED.contains(&tool), "{tool}: {error}");
                    let ExportError::NoStop { why, remedy, known, .. } = &error else {
                        panic!("{tool}: {error}")
                    };
                    assert!(!why.is_empty() && !remedy.is_empty() && known.contains("newton"), "{error}");
                }
            }
        }
    }
}

/// At a step that is too long, the numerical damping ratio ωh/2 alone gives the restitution exp(−πζ/√(1−ζ²)).
#[test]
fn a_step_too_long_states_its_restitution() {
    let frequency = (STIFFNESS / INERTIA).sqrt();
    let mut stop = request(0.9, StopMotion::Turn);
    for ratio in [0.1_f64, 0.4, 0.9] {
        stop.options.time_step = Some(2.0 * ratio / frequency);
        let error = Tool::PHYSX.export(&stop).unwrap_err();
        let ExportError::StepTooLong { reached, .. } = error else { panic!("{error}") };
        let expected = (-std::f64::consts::PI * ratio / (1.0 - ratio * ratio).sqrt()).exp();
        assert!((reached / expected - 1.0).abs() < 1e-12, "{ratio}: {reached}, {expected}");
    }
}

#[test]
fn units_are_those_of_the_motion() {
    for (motion, units) in [
        (StopMotion::Turn, ["rad/(N·m·s)", "N·m/rad", "N·m·s/rad"]),
        (StopMotion::Slide, ["m/(N·s)", "N/m", "N·s/m"]),
    ] {
        let ask = |tool: Tool| tool.export(&request(0.5, motion)).unwrap();
        let unit = |export: &Export, name| {
            export.parameters.iter().find(|p| p.name == name).expect("a parameter").unit
        };
        assert_eq!(unit(&ask(Tool::ODE), "stop_cfm"), units[0]);
        assert_eq!(unit(&ask(Tool::NEWTON), "limit_ke"), units[1]);
        assert_eq!(unit(&ask(Tool::PHYSX), "limit_damping"), units[2]);
    }
    let slide = Tool::ODE.export(&request(0.5, StopMotion::Slide)).unwrap();
    assert!(slide.snippets[0].text.contains("dJointSetSliderParam(joint, dParamStopERP"), "{slide:?}");
}
