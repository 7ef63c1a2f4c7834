//! Closed forms compared with the integrated equation of motion.

use crate::support::integrated::{IntegratedImpact, Measured};
use crate::support::relative_difference;
use percuss_contact::{CompliantContact, Damper, Impact, Law, Separation};

/// Restitutions from nearly plastic to nearly elastic.
const RESTITUTIONS: [f64; 11] = [0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.65, 0.8, 0.95, 0.99];
const MASSES: [f64; 3] = [0.05, 2.3, 700.0];
const STIFFNESSES: [f64; 3] = [3e3, 1e5, 4e7];
const EXPONENTS: [f64; 3] = [1.0, 1.5, 3.0];

/// One impact: closed form and integration.
struct Case {
    name: String,
    impact: Impact,
    measured: Measured,
    energy: f64,
    required: f64,
}

fn run(law: Law, e: f64, contact: CompliantContact, speed: f64, separation: Separation) -> Case {
    let damper = law.damper(contact, e, Some(speed), separation).unwrap();
    let (k, p) = contact.power_law().expect("a spring");
    let force = |x: f64, rate: f64| match damper {
        Damper::KelvinVoigt { coefficient, .. } => {
            k * x.powf(p) + coefficient * x.powf(0.5 * (p - 1.0)) * rate
        }
        Damper::HuntCrossley { dissipation } => k * x.powf(p) * (1.0 + dissipation * rate),
        Damper::LossFactor { .. } => unreachable!("no law of these cases"),
    };
    let kelvin_voigt = matches!(damper, Damper::KelvinVoigt { .. });
    let impact = IntegratedImpact {
        mass: contact.mass(),
        speed,
        length: (contact.mass() * speed * speed / k).powf(1.0 / (p + 1.0)),
        force: &force,
        ends_with_the_force: kelvin_voigt && separation == Separation::ForceVanishes,
    };
    Case {
        name: format!("{} e={e} {contact:?} v={speed} {separation:?}", law.name()),
        impact: damper.impact(contact, speed).unwrap(),
        measured: impact.measure(),
        energy: 0.5 * contact.mass() * speed * speed,
        required: e,
    }
}

/// The integration has a tolerance of 1e-12 per step, and its events are located to rounding.
const TOLERANCE: f64 = 1e-11;

/// The force is stationary at the peak, so the time of the peak has an error of about √ε.
const TIME_OF_PEAK: f64 = 1e-6;

/// Largest relative error of each figure, with the name of its case.
#[derive(Default)]
struct Worst(Vec<(&'static str, f64, String)>);

impl Worst {
    fn record(&mut self, what: &'static str, error: f64, name: &str) {
        let tolerance = if what == "time of peak" { TIME_OF_PEAK } else { TOLERANCE };
        assert!(error < tolerance, "{what} is off by {error:e} at {name}");
        match self.0.iter_mut().find(|entry| entry.0 == what) {
            Some(entry) if error > entry.1 => *entry = (what, error, name.into()),
            Some(_) => {}
            None => self.0.push((what, error, name.into())),
        }
    }

    fn compare(&mut self, case: &Case) {
        let (impact, measured, name) = (&case.impact, &case.measured, case.name.as_str());
        self.record("restitution", relative_difference(measured.restitution, case.required), name);
        self.record(
            "restitution of the impact",
            relative_difference(impact.restitution, case.required),
            name,
        );
        self.record("duration", relative_difference(measured.duration, impact.duration.unwrap()), name);
        self.record(
            "penetration",
            relative_difference(measured.max_penetration, impact.max_penetration),
            name,
        );
        self.record("peak force", relative_difference(measured.peak_force, impact.peak_force), name);
        let compression = impact.time_of_max_penetration;
        self.record(
            "time of penetration",
            relative_difference(measured.time_of_max_penetration, compression),
            name,
        );
        let late = measured.time_of_peak_force - impact.time_of_peak_force;
        self.record("time of peak", (late / compression).abs(), name);
        self.record("work of the loop", relative_difference(measured.work, impact.energy_lost), name);
        let lost = case.energy * (1.0 - case.required) * (1.0 + case.required);
        self.record("energy", relative_difference(impact.energy_lost, lost), name);
    }

    /// Prints the errors; visible with `--nocapture`.
    fn print(&self) {
        for (what, error, name) in &self.0 {
            println!("{what}: {error:.1e} at {name}");
        }
    }
}

fn sweep(law: Law, separation: Separation, exponents: &[f64]) {
    let mut worst = Worst::default();
    let mut count = 0;
    for e in RESTITUTIONS {
        for &p in exponents {
            for mass in MASSES {
                for stiffness in STIFFNESSES {
                    let contact = CompliantContact::new(mass, stiffness).unwrap().with_exponent(p).unwrap();
                    let speed = if count % 2 == 0 { 0.3 } else { 4.0 };
                    worst.compare(&run(law, e, contact, speed, separation));
                    count += 1;
                }
            }
        }
    }
    assert_eq!(count, RESTITUTIONS.len() * exponents.len() * MASSES.len() * STIFFNESSES.len());
    worst.print();
}

#[test]
fn kelvin_voigt_until_the_force_vanishes() {
    sweep(Law::KelvinVoigt, Separation::ForceVanishes, &EXPONENTS);
}

#[test]
fn kelvin_voigt_until_the_gap_closes() {
    sweep(Law::KelvinVoigt, Separation::GapCloses, &EXPONENTS);
}

#[test]
fn hunt_crossley() {
    sweep(Law::HuntCrossley, Separation::ForceVanishes, &EXPONENTS);
}
