//! Impact of given parameters, the inverse of an export.

use crate::support::relative_difference;
use percuss_contact::CompliantContact;
use percuss_contact::exports::{
    ContactModel, Export, ExportError, ImpactFunction, Options, Request, Tool, Value,
};
use rand::{Rng, SeedableRng, rngs::StdRng};

/// Numbers of an export by their names, without those of other uses.
fn numbers(export: &Export) -> Vec<(String, Vec<f64>)> {
    let of = |value: &Value| match value {
        Value::Number(number) => Some(vec![*number]),
        Value::Numbers(numbers) => Some(numbers.clone()),
        Value::Word(_) => None,
    };
    let is_read = |name: &str| name != "solref_standard" && !name.starts_with("equality_");
    let parameters = export.parameters.iter().filter(|parameter| is_read(parameter.name));
    parameters.filter_map(|parameter| Some((parameter.name.to_owned(), of(&parameter.value)?))).collect()
}

/// The exported parameters of every tool give the required restitution back, and the penetration that the export states, for 500
/// contacts. Tolerances: the exports of rigid tools and of linear ones are closed forms with the condition 1/ζ; the damping for IMPACT is found
/// to 1e-9 of the restitution.
#[test]
fn an_export_gives_its_restitution_back() {
    let mut random = StdRng::seed_from_u64(5);
    let mut counts = [0; Tool::ALL.len()];
    for _ in 0..500 {
        let mut between = |low: f64, high: f64| (low.ln() + random.random::<f64>() * (high / low).ln()).exp();
        let (mass, stiffness, speed) = (between(0.01, 1e4), between(1e2, 1e8), between(0.3, 10.0));
        let (own, diagonal_ratio) = (between(0.5, 2.0) * mass, between(0.3, 8.0));
        let e = 0.02 + 0.97 * random.random::<f64>();
        for (tool, count) in Tool::ALL.into_iter().zip(&mut counts) {
            let exponent = if tool == Tool::OPENSIM { 1.5 } else { 1.0 };
            let contact = CompliantContact::new(mass, stiffness).unwrap().with_exponent(exponent).unwrap();
            let options = Options {
                own_mass: Some(own),
                diagonal_ratio: (tool == Tool::MUJOCO).then_some(diagonal_ratio),
                ..Options::default()
            };
            let request = Request { contact, restitution: e, speed: Some(speed), options };
            let Ok(export) = tool.export(&request) else { continue };
            let mut given = numbers(&export);
            if tool == Tool::MUJOCO {
                given.push(("diagonal_ratio".into(), vec![diagonal_ratio]));
            }
            *count += 1;
            let found = tool.simulated(mass, &given).unwrap();
            for simulated in &found {
                let impact = simulated.impact(mass, speed).unwrap();
                let tolerance = if tool == Tool::ADAMS { 1e-8 } else { 1e-11 };
                let close = (impact.restitution - e).abs() < tolerance;
                assert!(close, "{tool} {}: {} for {e}, {given:?}", simulated.solver, impact.restitution);
                let stated = export.penetrations.iter().find(|stated| stated.solver == simulated.solver);
                if let Some((stated, depth)) = stated.zip(impact.max_penetration) {
                    assert!(
                        relative_difference(depth, stated.value) < 1e-7,
                        "{tool}: {depth} for {stated:?}"
                    );
                }
            }
        }
    }
    // Most contacts of a random stiffness have an export of every tool.
    assert!(counts.iter().all(|count| *count > 200), "{counts:?}");
}

/// Impact by steps of the fourth order of Runge and Kutta: restitution and largest penetration.
fn integrated(mass: f64, speed: f64, step: f64, force: &dyn Fn(f64, f64) -> f64) -> (f64, f64) {
    let rates = |[x, v]: [f64; 2]| [v, -force(x, v).max(0.0) / mass];
    let moved = |[x, v]: [f64; 2], [dx, dv]: [f64; 2], h: f64| [x + h * dx, v + h * dv];
    let (mut state, mut deepest) = ([0.0, speed], 0.0_f64);
    loop {
        let a = rates(state);
        let b = rates(moved(state, a, step / 2.0));
        let c = rates(moved(state, b, step / 2.0));
        let d = rates(moved(state, c, step));
        let mean = [0, 1].map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0);
        state = moved(state, mean, step);
        deepest = deepest.max(state[0]);
        if state[0] < 0.0 {
            return (-state[1] / speed, deepest);
        }
    }
}

/// Laws with parameters that no export has, against an integration in time. Tolerance: the steps change the force at most by 1e-4 of a period,
/// and the clamp of the force within a step costs 1e-6.
#[test]
fn given_parameters_agree_with_an_integration() {
    let (mass, speed, k) = (3.0, 0.7, 5e4_f64);
    let step = 2e-5 / (k / mass).sqrt();
    let given = |parameters: &[(&str, &[f64])]| -> Vec<(String, Vec<f64>)> {
        parameters.iter().map(|(name, numbers)| ((*name).to_owned(), numbers.to_vec())).collect()
    };
    let parameters = |c: f64| {
        [
            (Tool::SIMSCAPE, given(&[("Stiffness", &[k]), ("Damping", &[c])])),
            (
                Tool::MUJOCO,
                given(&[
                    ("solref", &[-k / mass * 0.99, -c / mass * 0.99]),
                    ("solimp", &[0.97, 0.97, 1.0]),
                    ("diagonal_ratio", &[2.0 / 3.0]),
                ]),
            ),
            (Tool::NEWTON, given(&[("ke", &[k]), ("kd", &[c])])),
            (
                Tool::ADAMS,
                given(&[("stiffness", &[k]), ("exponent", &[1.0]), ("cmax", &[c]), ("d", &[2e-3])]),
            ),
            (
                Tool::DRAKE,
                given(&[
                    ("point_contact_stiffness", &[2.0 * k]),
                    ("hunt_crossley_dissipation", &[c / 200.0]),
                ]),
            ),
        ]
    };
    for c in [20.0, 200.0, 900.0] {
        for (tool, parameters) in parameters(c) {
            let simulated = tool.simulated(mass, &parameters).unwrap();
            let impact = simulated[0].impact(mass, speed).unwrap();
            let ramp = |x: f64| {
                let u = (x / 2e-3).clamp(0.0, 1.0);
                u * u * (3.0 - 2.0 * u)
            };
            let force = |x: f64, v: f64| match simulated[0].model {
                ContactModel::ApproachDamper(..) => k * x + c * v.max(0.0),
                ContactModel::ImpactFunction { .. } => k * x + c * ramp(x) * v,
                _ if tool == Tool::DRAKE => k * x * (1.0 + c / 200.0 * v),
                _ => k * x + c * v,
            };
            let (e, depth) = integrated(mass, speed, step, &force);
            assert!((impact.restitution - e).abs() < 1e-4, "{tool} {c}: {} for {e}", impact.restitution);
            assert!(relative_difference(impact.max_penetration.unwrap(), depth) < 1e-4, "{tool} {c}");
        }
    }
    assert!(ImpactFunction::new(1.0, 1.0).is_ok());
}

/// Wrong parameters of every tool are refused with their name.
#[test]
fn wrong_parameters_are_refused() {
    let of = |parameters: &[(&str, &[f64])], tool: Tool| {
        let given: Vec<_> =
            parameters.iter().map(|(name, numbers)| ((*name).to_owned(), numbers.to_vec())).collect();
        match tool.simulated(2.0, &given).unwrap_err() {
            ExportError::Parameter { name, .. } => name,
            other => other.to_string(),
        }
    };
    for tool in Tool::ALL {
        assert_eq!(of(&[("x", &[1.0, f64::NAN])], tool), "x", "{tool}");
        assert_ne!(of(&[], tool), "", "{tool}");
    }
    let spring: [(&str, &[f64]); 2] = [("Stiffness", &[1e4]), ("Damping", &[10.0])];
    assert_eq!(of(&[spring[0], spring[1], ("friction", &[0.5])], Tool::SIMSCAPE), "friction");
    assert_eq!(of(&[spring[0], spring[0]], Tool::SIMSCAPE), "Stiffness");
    assert_eq!(of(&[spring[0]], Tool::SIMSCAPE), "Damping");
    assert_eq!(of(&[("solref", &[0.02, 1.0]), ("solimp", &[0.9, 1.2, 0.1])], Tool::MUJOCO), "solimp");
    assert_eq!(of(&[("solref", &[0.02, 1.0]), ("solimp", &[0.9, 0.9])], Tool::MUJOCO), "solimp");
    assert_eq!(of(&[("solref", &[-1e4, 1.0]), ("solimp", &[0.9, 0.9, 1.0])], Tool::MUJOCO), "solref");
    assert_eq!(
        of(&[("soft_erp", &[1.2]), ("soft_cfm", &[0.1]), ("time_step", &[1e-3])], Tool::ODE),
        "soft_erp"
    );
    assert_eq!(of(&[("RestitutionCoeff", &[0.5]), ("FrictionCoeff", &[1.0])], Tool::DART), "FrictionCoeff");
    assert_eq!(of(&[("restitution", &[1.5])], Tool::RAPIER), "restitution");
}

/// MuJoCo 4.0.0 (RK4, time step 1e-5 s, ball of 2 kg, condim 1): restitution, largest penetration and force at a speed, and the penetration at rest
/// under the weight, with the default impedance and with others.
#[test]
fn impedances_of_mujoco_are_as_measured() {
    type Measured<'a> = (&'a [f64], Option<&'a [f64]>, f64, [f64; 3], f64);
    let cases: [Measured; 6] = [
        (&[-1e4, -50.0], Some(&[0.9, 0.9, 0.001]), 1.0, [0.506234, 7.11472e-3, 162.1272], 9.81000e-5),
        (&[0.02, 1.0], None, 1.0, [0.135675, 7.37608e-3, 189.4737], 3.671818e-4),
        (&[0.02, 1.0], None, 0.1, [0.137689, 7.58806e-4, 18.94737], 3.671818e-4),
        (&[-1e4, -50.0], None, 0.1, [0.508992, 7.32437e-4, 16.24358], 1.0775542e-4),
        (&[0.02, 0.3], None, 1.0, [0.452286, 4.04099e-3, 271.9225], 3.927484e-5),
        (
            &[0.02, 0.3],
            Some(&[0.5, 0.9, 0.01, 0.3, 3.0]),
            1.0,
            [0.488968, 5.411155e-3, 278.2093],
            5.6931170e-4,
        ),
    ];
    for (solref, solimp, speed, expected, at_rest) in cases {
        let mut given = vec![("solref".to_owned(), solref.to_vec())];
        given.extend(solimp.map(|solimp| ("solimp".to_owned(), solimp.to_vec())));
        let simulated = Tool::MUJOCO.simulated(2.0, &given).expect("a contact")[0];
        let found = simulated.impact(2.0, speed).expect("an impact");
        let found = [found.restitution, found.max_penetration.unwrap(), found.peak_force.unwrap()];
        // A step of MuJoCo is 1e-3 of the contact; the touch is within one step.
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(relative_difference(found, expected) < 1e-3, "{solref:?} {solimp:?}: {found} {expected}");
        }
        let rest = simulated.penetration_at_rest(2.0 * 9.81).expect("a force").expect("a depth");
        assert!(relative_difference(rest, at_rest) < 1e-6, "{solref:?} {solimp:?}: {rest} {at_rest}");
    }
}

/// DART has no rebound below 0.1 m/s, that is at a closing speed below 0.1/e m/s.
#[test]
fn gazebo_rebounds_from_the_slowest_rebound_on() {
    let given = [("restitution_coefficient".to_owned(), vec![0.5])];
    let simulated = Tool::GAZEBO.simulated(2.0, &given).expect("a contact")[0];
    for (speed, restitution) in [(0.04, 0.0), (0.19, 0.0), (0.21, 0.5), (3.0, 0.5)] {
        assert_eq!(simulated.impact(2.0, speed).expect("an impact").restitution, restitution, "{speed}");
    }
}

/// The standard format of MuJoCo has a time constant, which an undamped contact lacks.
#[test]
fn only_an_undamped_contact_has_no_standard_format() {
    let contact = CompliantContact::new(2.0, 1e5).unwrap();
    for restitution in [0.5, 1.0] {
        let options = Options { own_mass: Some(2.0), ..Options::default() };
        let request = Request { contact, restitution, speed: Some(1.0), options };
        let export = Tool::MUJOCO.export(&request).unwrap();
        let lacks = export.cannot.iter().any(|what| what.contains("standard format"));
        assert_eq!(lacks, restitution == 1.0, "{restitution}: {:?}", export.cannot);
    }
}
