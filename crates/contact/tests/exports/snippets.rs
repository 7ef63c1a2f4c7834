//! Exports: numbers, snippets and errors; models of the engines' steps reach the required restitution with them.

use percuss_contact::exports::{Export, ExportError, ImpactFunction, Options, Request, Tool, Value};
use percuss_contact::{CompliantContact, ContactLawError, Separation, hunt_crossley, kelvin_voigt};

const MASS: f64 = 2.28125;
const STIFFNESS: f64 = 1e5;
const SPEED: f64 = 0.4;
/// Rounding of a coordinate from 0.25 to 0.5 m in single precision, m.
const ROUNDING: f64 = 1.5e-8;

fn request(restitution: f64) -> Request<'static> {
    let options = Options { own_mass: Some(1.5), other_own_mass: Some(3.0), ..Options::default() };
    Request {
        options,
        ..Request::new(CompliantContact::new(MASS, STIFFNESS).unwrap(), restitution).at(SPEED)
    }
}

/// Request that the tool supports: OpenSim has a Hertz spring, and DART suppresses slow rebounds.
fn request_for(tool: Tool, restitution: f64) -> Request<'static> {
    let request = request(restitution);
    match tool.name() {
        "opensim" => Request { contact: request.contact.with_exponent(1.5).unwrap(), ..request },
        "dart" => request.at(1.0),
        _ => request,
    }
}

fn numbers(export: &Export, name: &str) -> Vec<f64> {
    match export.parameter(name).unwrap_or_else(|| panic!("{}: no {name}", export.tool)) {
        Value::Number(number) => vec![*number],
        Value::Numbers(numbers) => numbers.clone(),
        other => panic!("{name} is {other:?}"),
    }
}

fn number(export: &Export, name: &str) -> f64 {
    numbers(export, name)[0]
}

fn close(got: f64, expected: f64, relative: f64) {
    assert!((got - expected).abs() <= relative * expected.abs(), "{got:?}, expected {expected:?}");
}

/// Restitution with the time step x, v ↦ v⁺ of an engine (x penetration, v approach speed): of all phases, the value
/// with the largest deviation from `e`.
fn worst(e: f64, step: f64, next: impl Fn(f64, f64) -> f64) -> f64 {
    let mut worst: f64 = 0.0;
    for phase in 0..40 {
        let (mut x, mut v) = (-(f64::from(phase) + 0.5) / 40.0 * step, 1.0);
        loop {
            v = if x > 0.0 || x + step * v > 0.0 { next(x, v) } else { v };
            x += step * v;
            if x < 0.0 && v <= 0.0 {
                break;
            }
        }
        worst = worst.max((-v - e).abs());
    }
    worst
}

/// max(0, k(x + h v⁺) + c v⁺) by implicit Euler: ODE, Bullet, PhysX, SAP.
/// `early`: the force also acts in the step in which the touch occurs.
fn implicit(k: f64, c: f64, mass: f64, h: f64, early: bool) -> impl Fn(f64, f64) -> f64 {
    move |x, v| {
        if x <= 0.0 && !early {
            return v;
        }
        let contact = (v - h / mass * k * x) / (1.0 + h / mass * (h * k + c));
        if k * (x + h * contact) + c * contact > 0.0 { contact } else { v }
    }
}

/// max(0, kx + cv) by semi-implicit Euler, only for x > 0: MuJoCo, Chrono.
fn explicit(k: f64, c: f64, mass: f64, h: f64) -> impl Fn(f64, f64) -> f64 {
    move |x, v| if x > 0.0 { v - h / mass * (k * x + c * v).max(0.0) } else { v }
}

const RESTITUTIONS: [f64; 12] = [0.005, 0.01, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99];

#[test]
fn mujoco_reaches_the_restitution_for_every_diagonal() {
    for e in RESTITUTIONS {
        for accuracy in [1e-2, 1e-3, 1e-4] {
            for alpha in [None, Some(0.165), Some(55.7)] {
                let mut request = request(e);
                request.options.accuracy = accuracy;
                request.options.diagonal_ratio = alpha;
                let export = Tool::MUJOCO.export(&request).unwrap();
                let (h, solref) = (export.time_step.unwrap(), numbers(&export, "solref"));
                let d = numbers(&export, "solimp")[0];
                let f = d + (1.0 - d) * alpha.unwrap_or(1.0);
                // Constraint row of MuJoCo: stiffness −solref₀/f, damping −solref₁/f, per unit of m̄.
                close(-solref[0] / f * MASS, STIFFNESS, 1e-14);
                let engine = explicit(-solref[0] / f, -solref[1] / f, 1.0, h);
                let (found, bound) = (worst(e, h, engine), export.error_bound.unwrap());
                assert!(
                    found <= bound && bound <= accuracy * (1.0 + 1e-12),
                    "{e} {accuracy}: {found:e} {bound:e}"
                );
                let standard = numbers(&export, "solref_standard");
                close(1.0 / (standard[0] * standard[1]).powi(2), -solref[0], 1e-13);
                close(2.0 / standard[0], -solref[1], 1e-13);
                assert!(standard[0] >= 2.0 * h, "refsafe would act");
            }
        }
    }
}

#[test]
fn mujoco_exports_parameters_of_equality_constraints() {
    let mut request = request(0.5);
    assert!(Tool::MUJOCO.export(&request).unwrap().parameter("equality_solref").is_none());
    request.options.constrained = true;
    let export = Tool::MUJOCO.export(&request).unwrap();
    assert_eq!(numbers(&export, "equality_solref"), [2.0 * export.time_step.unwrap(), 1.0]);
    assert_eq!(numbers(&export, "equality_solimp"), [0.9999, 0.9999, 1.0]);
    assert!(export.snippets[0].text.contains("<equality solref="));
}

#[test]
fn implicit_engines_reach_the_restitution() {
    for e in RESTITUTIONS {
        let request = request(e);
        for tool in [Tool::ODE, Tool::BULLET, Tool::GAZEBO_CLASSIC, Tool::PHYSX, Tool::DRAKE] {
            if tool == Tool::PHYSX && e < 0.01 {
                // The error by single precision is larger than e.
                assert!(matches!(tool.export(&request), Err(ExportError::Unreachable { .. })), "{e}");
                continue;
            }
            let export = tool.export(&request).unwrap();
            let h = export.time_step.unwrap();
            let (k, c) = match tool.name() {
                "ode" => {
                    let (erp, cfm) = (number(&export, "soft_erp"), number(&export, "soft_cfm"));
                    (erp / (h * cfm), (1.0 - erp) / cfm)
                }
                "bullet" => {
                    (number(&export, "contactStiffness") / 2.0, number(&export, "contactDamping") * 2.0)
                }
                "gazebo-classic" => (number(&export, "kp") / 2.0, number(&export, "kd") * 2.0),
                "physx" => {
                    // TGS with N position iterations is PGS with N shorter steps.
                    let shorter = h / number(&export, "tgs_position_iterations");
                    let k = number(&export, "compliant_contact_stiffness");
                    let tgs = number(&export, "compliant_contact_damping_tgs");
                    let found = worst(e, shorter, implicit(k, tgs, MASS, shorter, true));
                    assert!(
                        found <= export.error_bound.unwrap() - ROUNDING / (SPEED * shorter),
                        "TGS {e}: {found:e}"
                    );
                    (k, number(&export, "compliant_contact_damping"))
                }
                _ => {
                    let k = number(&export, "point_contact_stiffness") / 2.0;
                    (k, k * 2.0 * number(&export, "relaxation_time"))
                }
            };
            close(k, STIFFNESS, 1e-9);
            // Bound without the part of single precision in PhysX; the bound of Drake also covers lagged plants.
            let shorter = h / 4.0;
            let single = if tool == Tool::PHYSX { ROUNDING / (SPEED * shorter) } else { 0.0 };
            let bound = export.error_bound.unwrap() - single;
            for early in [false, true] {
                let found = worst(e, h, implicit(k, c, MASS, h, early));
                assert!(found <= bound && bound <= 1.0001e-3, "{tool} {e}: {found:e}, bound {bound:e}");
            }
        }
    }
}

#[test]
fn a_step_too_long_for_an_implicit_engine_names_the_longest() {
    let mut request = request(0.8);
    let frequency = (STIFFNESS / MASS).sqrt();
    let largest = 2.0 * kelvin_voigt::ratio(0.8, Separation::ForceVanishes).unwrap() / frequency;
    for tool in [Tool::ODE, Tool::BULLET, Tool::GAZEBO_CLASSIC, Tool::PHYSX, Tool::DRAKE] {
        request.options.time_step = Some(1.01 * largest);
        let error = tool.export(&request).unwrap_err();
        let ExportError::StepTooLong { reached, largest: named, .. } = error else {
            panic!("{tool}: {error}")
        };
        close(named, largest, 1e-12);
        assert!(reached < 0.8);
        request.options.time_step = Some(0.99 * largest);
        assert!(tool.export(&request).is_ok());
        request.options.time_step = None;
        let rigid = Request { restitution: 1.0, ..request };
        match tool.export(&rigid) {
            Ok(export) => {
                assert!(tool == Tool::DRAKE && export.parameter("relaxation_time").is_none(), "{export:?}");
            }
            Err(error) => assert!(matches!(error, ExportError::Unreachable { .. }), "{tool}: {error}"),
        }
    }
}

/// max(0, k(x + h v⁺))(1 + d v⁺)₊ by implicit Euler: Drake's approximation `similar`, and `lagged` along the normal.
fn drake_lagged(k: f64, d: f64, mass: f64, h: f64) -> impl Fn(f64, f64) -> f64 {
    move |x, v| {
        let force = |u: f64| (k * (x + h * u)).max(0.0) * (1.0 + d * u).max(0.0);
        // v⁺ + h f(v⁺)/m = v has one root, because the left side increases.
        let (mut low, mut high) = (-2.0_f64.max(v.abs()), v);
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            if middle + h / mass * force(middle) > v { high = middle } else { low = middle }
        }
        high
    }
}

#[test]
fn drake_reaches_the_restitution_continuous_and_lagged() {
    for e in [0.05, 0.1, 0.2, 0.5, 0.8, 0.95] {
        let export = Tool::DRAKE.export(&request(e)).unwrap();
        let d = number(&export, "hunt_crossley_dissipation");
        close(hunt_crossley::restitution(d * SPEED).unwrap(), e, 1e-12);
        let h = number(&export, "time_step_lagged");
        let frequency = (STIFFNESS / MASS).sqrt();
        // At 1 m/s instead of the speed of the request.
        let found = worst(e, h, drake_lagged(STIFFNESS, d * SPEED, MASS, h));
        assert!(found <= 1e-3, "{e}: {found:e} at ωh = {}", frequency * h);
    }
}

#[test]
fn drake_without_a_speed_exports_the_other_parameters() {
    let export = Tool::DRAKE.export(&Request { speed: None, ..request(0.5) }).unwrap();
    assert!(export.parameter("hunt_crossley_dissipation").is_none());
    assert_eq!(export.missing.len(), 1);
    assert!(export.parameter("relaxation_time").is_some());
    for tool in [Tool::ADAMS, Tool::SIMSCAPE] {
        let export = tool.export(&Request { speed: None, ..request(0.5) }).unwrap();
        assert_eq!(export.missing.len(), 1, "{tool}");
    }
}

/// Chrono's conversion from the restitution of a material to a damping ratio for the own masses of the bodies.
fn chrono_ratio(cr: f64) -> f64 {
    1.0 / (1.0 + (std::f64::consts::PI / cr.ln()).powi(2)).sqrt()
}

#[test]
fn chrono_uses_the_masses_of_the_bodies() {
    let own = 1.5 * 3.0 / 4.5;
    for e in RESTITUTIONS {
        let export = Tool::CHRONO.export(&request(e)).unwrap();
        assert!(export.assumptions.iter().any(|text| text.contains("a fixed body counts with its own mass")));
        close(number(&export, "m_eff"), own, 1e-15);
        let (k, c) = (number(&export, "kn"), number(&export, "gn") * own);
        let h = export.time_step.unwrap();
        let (found, bound) = (worst(e, h, explicit(k, c, MASS, h)), export.error_bound.unwrap());
        assert!(found <= bound, "{e}: {found:e}, bound {bound:e}");
        let Some(cr) = export.number("cr") else {
            assert!(e < 0.4, "{e}");
            continue;
        };
        let ratio = chrono_ratio(cr) * (own / MASS).sqrt();
        close(kelvin_voigt::restitution(ratio, Separation::ForceVanishes).unwrap(), e, 1e-12);
    }
    let without = Request { options: Options::default(), ..request(0.5) };
    let missing = Tool::CHRONO.export(&without).unwrap_err().parameter();
    assert_eq!(missing, Some(percuss_contact::LawParameter::OwnMass));
}

#[test]
fn chrono_corrects_a_material_restitution() {
    // Published with the law: restitutions 0.2, 0.5, 0.8 need these values for m_eff = m̄.
    for (e, cr) in [(0.2, 0.034462), (0.5, 0.436288), (0.8, 0.791170)] {
        let contact = CompliantContact::new(1.0, STIFFNESS).unwrap().with_exponent(1.5).unwrap();
        let options = Options { own_mass: Some(2.0), other_own_mass: Some(2.0), ..Options::default() };
        let export = Tool::CHRONO.export(&Request { options, ..Request::new(contact, e) }).unwrap();
        assert!((number(&export, "cr") - cr).abs() < 5e-7);
        close(number(&export, "E_eff·sqrt(R_eff)"), 0.75 * STIFFNESS, 1e-15);
    }
    let contact = CompliantContact::new(1.0, STIFFNESS).unwrap().with_exponent(1.5).unwrap();
    let options = Options { own_mass: Some(2.0), other_own_mass: Some(2.0), ..Options::default() };
    let error = Tool::CHRONO.export(&Request { options, ..Request::new(contact, 0.1) }).unwrap_err();
    assert!(matches!(error, ExportError::Unreachable { .. }), "{error}");
}

/// (p, D, ĉ for e = 0.2, 0.5, 0.8).
const REFERENCE: [(f64, f64, [f64; 3]); 9] = [
    (1.0, 0.01, [1.4717479222, 0.512723669401, 0.149230383833]),
    (1.0, 0.1, [1.55932664674, 0.533070579204, 0.154265473498]),
    (1.0, 1.0, [9.76460214383, 1.72366981422, 0.397345740291]),
    (1.5, 0.01, [1.06538495223, 0.39689235781, 0.117586501651]),
    (1.5, 0.1, [1.13073871121, 0.413438869799, 0.121509688498]),
    (1.5, 1.0, [3.92572367608, 1.06441438273, 0.28244549713]),
    (2.2, 0.01, [0.757433788629, 0.303054913911, 0.0920771375658]),
    (2.2, 0.1, [0.804006523556, 0.31617618235, 0.0952605676018]),
    (2.2, 1.0, [2.13092070002, 0.675529169447, 0.197826853762]),
];

#[test]
fn adams_impact_agrees_with_an_independent_integration() {
    // ĉ by SciPy's DOP853 at 1e-12, steps of at most 0.002, and Brent's method, e = 0.2, 0.5, 0.8.
    for (p, ramp, expected) in REFERENCE {
        let impact = ImpactFunction::new(p, ramp).unwrap();
        for (e, expected) in [0.2, 0.5, 0.8].into_iter().zip(expected) {
            let damping = impact.damping(e).unwrap();
            close(damping, expected, 1e-7);
            assert!((impact.restitution(damping).unwrap() - e).abs() < 1e-9);
        }
    }
    // Without a ramp the force is that of the linear damper.
    let ratio = kelvin_voigt::ratio(0.5, Separation::ForceVanishes).unwrap();
    close(ImpactFunction::new(1.0, 1e-4).unwrap().damping(0.5).unwrap(), 2.0 * ratio, 1e-4);
}

#[test]
fn adams_gives_its_numbers_in_si() {
    let contact = CompliantContact::new(MASS, 3e8).unwrap().with_exponent(1.5).unwrap();
    let export = Tool::ADAMS.export(&Request::new(contact, 0.5).at(0.7)).unwrap();
    let (cmax, d) = (number(&export, "cmax"), number(&export, "d"));
    // Motion in kg, m, s by the classical fourth-order Runge–Kutta method with small steps.
    let rates = |[x, v]: [f64; 2]| {
        let part = (x.max(0.0) / d).min(1.0);
        let force = 3e8 * x.max(0.0).powf(1.5) + cmax * part * part * (3.0 - 2.0 * part) * v;
        [v, -force.max(0.0) / MASS]
    };
    let (mut state, h) = ([0.0, 0.7], 1e-7);
    while state[0] > 0.0 || state[1] > 0.0 {
        let along = |k: [f64; 2], h: f64| [state[0] + h * k[0], state[1] + h * k[1]];
        let k1 = rates(state);
        let k2 = rates(along(k1, h / 2.0));
        let k3 = rates(along(k2, h / 2.0));
        let k4 = rates(along(k3, h));
        for i in 0..2 {
            state[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    close(-state[1] / 0.7, 0.5, 1e-6);
}

#[test]
fn simscape_and_rapier_export_the_request() {
    let export = Tool::SIMSCAPE.export(&request(0.5)).unwrap();
    let ratio = kelvin_voigt::ratio(0.5, Separation::ForceVanishes).unwrap();
    close(number(&export, "Damping"), 2.0 * ratio * (STIFFNESS * MASS).sqrt(), 1e-14);
    let width = number(&export, "Transition Region Width");
    assert!(width < 0.01 * SPEED / (STIFFNESS / MASS).sqrt());
    let export = Tool::RAPIER.export(&request(0.5)).unwrap();
    assert_eq!(number(&export, "restitution"), 0.5);
    assert!(!export.cannot.is_empty());
}

#[test]
fn defaults_that_change_the_restitution_are_overridden() {
    let export = Tool::GAZEBO_CLASSIC.export(&request(0.5)).unwrap();
    assert!(number(&export, "max_vel") >= 3.0);
    for text in ["<type>world</type>", "<mu>0.0</mu>", "<max_vel>"] {
        assert!(export.snippets[0].text.contains(text), "{text}");
    }
    assert!(export.parameter("restitution_coefficient").is_none());
    let export = Tool::BULLET.export(&request(0.5)).unwrap();
    let python = &export.snippets[0].text;
    for text in ["lateralFriction=0.0", "rollingFriction=0.0", "spinningFriction=0.0", "contactSlop=0.0"] {
        assert!(python.contains(text), "{text}");
    }
    let cpp = &export.snippets[1].text;
    for text in ["setFriction(0.0)", "setRollingFriction(0.0)", "setSpinningFriction(0.0)"] {
        assert!(cpp.contains(text), "{text}");
    }
    assert!(Tool::ODE.export(&request(0.5)).unwrap().snippets[0].text.contains("mu = 0.0"));
    let rapier = Tool::RAPIER.export(&request(0.5)).unwrap();
    assert!(rapier.snippets[0].text.contains("damping_mut().fill(0.0)"));
}

#[test]
fn dart_multiplies_restitutions_and_refuses_slow_rebounds() {
    let export = Tool::DART.export(&request(0.5)).unwrap();
    assert_eq!(number(&export, "RestitutionCoeff") * number(&export, "RestitutionCoeff_other"), 0.5);
    // The constraint force mixing reduces e by (1 + e)·1e-5.
    assert!((1.5e-5..2e-5).contains(&export.error_bound.unwrap()));
    for (e, speed) in [(0.5, 0.19), (0.2, 0.4), (1e-3, 200.0), (0.5, 201.0)] {
        let error = Tool::DART.export(&request(e).at(speed)).unwrap_err();
        assert!(matches!(error, ExportError::Unreachable { .. }), "{e} at {speed}: {error}");
    }
    let dead = Tool::DART.export(&request(0.0)).unwrap();
    close(dead.error_bound.unwrap(), 1e-3 / SPEED, 1e-15);
    let unknown = Tool::DART.export(&Request { speed: None, ..request(0.5) }).unwrap();
    assert!(unknown.error_bound.is_none() && unknown.missing.len() == 1);
}

#[test]
fn jolt_lowers_its_threshold_and_states_bounds_for_short_travels() {
    let mut free = request(0.5);
    free.options.free_mass = Some(MASS);
    let export = Tool::JOLT.export(&free).unwrap();
    assert_eq!(number(&export, "mRestitution"), 0.5);
    assert_eq!(number(&export, "mMinVelocityForRestitution"), SPEED / 2.0);
    let step = export.time_step.unwrap();
    let stepping = |step| {
        let mut request = free;
        request.options.time_step = Some(step);
        Tool::JOLT.export(&request).unwrap().error_bound
    };
    assert!(stepping(2.0 * step).is_some() && stepping(3.0 * step).is_none());
    let unknown = Tool::JOLT.export(&Request { speed: None, ..request(0.5) }).unwrap();
    assert_eq!(number(&unknown, "mMinVelocityForRestitution"), 0.0);
    assert!(unknown.error_bound.is_none() && unknown.missing.len() == 1);
}

#[test]
fn opensim_takes_the_dissipation_number_and_hertz() {
    for e in [0.05, 0.2, 0.5, 0.8, 0.95] {
        let export = Tool::OPENSIM.export(&request_for(Tool::OPENSIM, e)).unwrap();
        let number_of = 1.5 * number(&export, "dissipation") * SPEED;
        close(hunt_crossley::restitution(number_of).unwrap(), e, 1e-12);
        // Simbody's 4/3 E √(R E) for two moduli stiffness^(2/3) in series, here with R = 1 m.
        let modulus = number(&export, "stiffness·sqrt(R)").powf(2.0 / 3.0) / 2.0;
        close(4.0 / 3.0 * modulus * modulus.sqrt(), STIFFNESS, 1e-14);
    }
    let error = Tool::OPENSIM.export(&request(0.5)).unwrap_err().to_string();
    assert!(error.contains("1.5"), "{error}");
}

/// v⁺ after a step of the trapezoidal rule with kx + cv, as in Exudyn: the force acts if the step ends with x > 0.
fn trapezoidal(k: f64, c: f64, mass: f64, h: f64) -> impl Fn(f64, f64) -> f64 {
    move |x, v| {
        let (now, half) = (if x > 0.0 { k * x + c * v } else { 0.0 }, h / 2.0 / mass);
        // The step ends with x > 0: v⁺ = v − half (now + k x⁺ + c v⁺), x⁺ = x + h (v + v⁺)/2.
        let inside = (v - half * (now + k * (x + h * v / 2.0))) / (1.0 + half * (c + k * h / 2.0));
        if x + h * (v + inside) / 2.0 > 0.0 { inside } else { v - half * now }
    }
}

#[test]
fn exudyn_reaches_the_restitution_with_the_half_period() {
    for e in RESTITUTIONS {
        for accuracy in [1e-2, 1e-3, 1e-4] {
            let mut request = request(e);
            request.options.accuracy = accuracy;
            if accuracy > e {
                assert!(matches!(Tool::EXUDYN.export(&request), Err(ExportError::Unreachable { .. })), "{e}");
                continue;
            }
            let export = Tool::EXUDYN.export(&request).unwrap();
            let (k, c) = (number(&export, "contactStiffness"), number(&export, "contactDamping"));
            let ratio = c / (2.0 * (k * MASS).sqrt());
            close(kelvin_voigt::restitution(ratio, Separation::GapCloses).unwrap(), e, 1e-12);
            let (h, bound) = (export.time_step.unwrap(), export.error_bound.unwrap());
            assert!(bound <= accuracy * (1.0 + 1e-12), "{e}: {bound:e}");
            let (next, mut found) = (trapezoidal(k, c, MASS, h), 0.0_f64);
            for phase in 0..40 {
                let (mut x, mut v) = (-(f64::from(phase) + 0.5) / 40.0 * h, 1.0);
                while x >= 0.0 || v > 0.0 {
                    let after = next(x, v);
                    x += h * (v + after) / 2.0;
                    v = after;
                }
                found = found.max((-v - e).abs());
            }
            let most = 3.0 * found + k / MASS * h * h / 2.0;
            assert!(found <= bound && bound <= most, "{e} {accuracy}: {found:e}, bound {bound:e}");
        }
    }
    let mut request = request(0.5);
    request.options.time_step = Some(0.21 / (STIFFNESS / MASS).sqrt());
    let error = Tool::EXUDYN.export(&request).unwrap_err();
    assert_eq!(error.parameter(), Some(percuss_contact::LawParameter::TimeStep), "{error}");
}

#[test]
fn newton_reaches_the_restitution_with_a_damper_on_approach() {
    for e in RESTITUTIONS {
        for accuracy in [1e-2, 1e-3, 1e-4] {
            // At this speed single precision is not the largest part of the error.
            let mut request = request(e).at(40.0);
            request.options.accuracy = accuracy;
            let export = Tool::NEWTON.export(&request).unwrap();
            let (k, c) = (number(&export, "ke"), number(&export, "kd"));
            let h = export.time_step.unwrap();
            let bound = export.error_bound.unwrap() - ROUNDING / (40.0 * h);
            let engine =
                move |x: f64, v: f64| if x > 0.0 { v - h / MASS * (k * x + c * v.max(0.0)) } else { v };
            let found = worst(e, h, engine);
            assert!(
                found <= bound && bound <= accuracy * (1.0 + 1e-12),
                "{e} {accuracy}: {found:e}, bound {bound:e}"
            );
            assert_eq!(number(&export, "restitution"), e);
        }
    }
}

#[test]
fn every_snippet_is_well_formed_and_holds_the_numbers_in_full() {
    let mut seen = 0;
    for tool in Tool::ALL {
        for e in [0.2, 0.5, 0.8] {
            for loops in [false, true] {
                // At 0.4 m/s new Gazebo suppresses a rebound with e = 0.2.
                let mut request = request_for(tool, e).at(0.6);
                request.options.constrained = loops;
                let export = tool.export(&request).unwrap();
                assert!(
                    !export.snippets.is_empty()
                        && !tool.facts().sources.is_empty()
                        && !export.assumptions.is_empty()
                );
                for snippet in &export.snippets {
                    well_formed(snippet.language, &snippet.text);
                    seen += 1;
                }
                let first = &export.snippets[0].text;
                if let Some(step) = export.time_step {
                    assert!(first.contains(&format!("{step:?}")), "{tool}: {first}");
                }
                let json = serde_json::to_value(&export).unwrap();
                assert_eq!(json["tool"], tool.name());
                // `null` for tools with builds of one precision.
                let text = json.to_string().replace("\"single_precision_error\":null", "");
                assert!(!text.contains("null") || export.time_step.is_none() || export.error_bound.is_none());
            }
        }
    }
    assert!(seen > 120, "{seen}");
}

fn well_formed(language: &str, text: &str) {
    assert!(text.ends_with('\n') && !text.contains("NaN") && !text.contains("inf"), "{text}");
    match language {
        "xml" => {
            roxmltree::Document::parse(text).unwrap_or_else(|error| panic!("{error}: {text}"));
        }
        "python" | "cpp" | "rust" | "javascript" => {
            for (open, shut) in [('(', ')'), ('{', '}'), ('[', ']')] {
                assert_eq!(text.matches(open).count(), text.matches(shut).count(), "{text}");
            }
            assert_eq!(text.matches('"').count() % 2, 0, "{text}");
        }
        "matlab" | "adams" => assert!(text.is_ascii(), "{text}"),
        other => panic!("a language no one checks: {other}"),
    }
}

#[test]
fn tools_are_found_by_name_and_alias() {
    for tool in Tool::ALL {
        assert_eq!(Tool::from_name(tool.name()), Ok(tool));
        assert!(!tool.title().is_empty());
        for alias in tool.aliases() {
            assert_eq!(Tool::from_name(&alias.to_uppercase()), Ok(tool));
        }
    }
    assert_eq!(Tool::from_name("Isaac Lab"), Ok(Tool::PHYSX));
    let error = Tool::from_name("mujocko").unwrap_err().to_string();
    assert!(error.contains("did you mean \"mujoco\"") && error.contains("simscape"), "{error}");
}

#[test]
fn other_exponents_are_refused_by_linear_tools() {
    let curved = CompliantContact::new(MASS, STIFFNESS).unwrap().with_exponent(2.0).unwrap();
    for tool in Tool::ALL {
        let answer = tool.export(&Request { contact: curved, ..request(0.5) });
        match tool.name() {
            "adams" | "rapier" | "gazebo" | "dart" | "jolt" => assert!(answer.is_ok(), "{tool}"),
            _ => assert!(matches!(answer, Err(ExportError::Exponent { .. })), "{tool}: {answer:?}"),
        }
    }
}

#[test]
fn numbers_out_of_range_are_refused_and_nothing_overflows() {
    let wrong = [
        Request { restitution: -0.1, ..request(0.5) },
        Request { restitution: f64::NAN, ..request(0.5) },
        request(0.5).at(0.0),
        request(0.5).at(f64::INFINITY),
        Request { options: Options { accuracy: 0.0, ..Options::default() }, ..request(0.5) },
        Request { options: Options { time_step: Some(-1.0), ..Options::default() }, ..request(0.5) },
        Request { options: Options { own_mass: Some(0.0), ..Options::default() }, ..request(0.5) },
        Request { options: Options { diagonal_ratio: Some(f64::NAN), ..Options::default() }, ..request(0.5) },
    ];
    for tool in Tool::ALL {
        for request in wrong {
            let error = tool.export(&request).unwrap_err();
            assert!(
                matches!(error, ExportError::Contact(ContactLawError::OutOfRange { .. })),
                "{tool}: {error}"
            );
        }
        for (mass, stiffness) in [(1e300, 1e-300), (1e-300, 1e300), (1e300, 1e300), (1e-300, 1e-300)] {
            for e in [1e-300, 1e-9, 0.5, 1.0 - 1e-16, 0.0, 1.0] {
                for speed in [1e-300, 1.0, 1e300] {
                    let contact = CompliantContact::new(mass, stiffness).unwrap();
                    if let Ok(export) = tool.export(&Request { contact, ..request(e) }.at(speed)) {
                        for snippet in &export.snippets {
                            well_formed(snippet.language, &snippet.text);
                        }
                    }
                }
            }
        }
    }
}
