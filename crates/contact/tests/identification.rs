//! Identification of planted contacts: the equation of motion, integrated here with other steps and another method, sampled with noise, drift,
//! limits and filters.

use percuss_contact::identification::{
    DamperForm, Estimate, Identification, IdentifiedSignal, Known, Measured, Record, Signal, identify,
};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// Planted contact.
#[derive(Clone, Copy, Debug)]
struct Planted {
    mass: f64,
    stiffness: f64,
    exponent: f64,
    damping: f64,
    form: DamperForm,
    speed: f64,
    gravity: f64,
    /// Spring of another law, F(x).
    spring: Option<fn(f64) -> f64>,
}

/// Signals of the motion.
struct Motion {
    restitution: f64,
    peak_force: f64,
    max_penetration: f64,
    duration: f64,
    /// Time after the touch, penetration, rate and force.
    states: Vec<[f64; 4]>,
    step: f64,
}

impl Planted {
    fn force(&self, x: f64, v: f64) -> f64 {
        let x = x.max(0.0);
        let spring = self.spring.map_or_else(|| self.stiffness * x.powf(self.exponent), |law| law(x));
        match self.form {
            DamperForm::HuntCrossley => spring * (1.0 + self.damping * v),
            DamperForm::KelvinVoigt => spring + self.damping * x.powf(0.5 * (self.exponent - 1.0)) * v,
        }
    }

    /// Midpoint rule with 40,000 steps per duration of an undamped linear contact.
    fn motion(&self) -> Motion {
        let depth = ((self.exponent + 1.0) * self.mass * self.speed.powi(2) / 2.0 / self.stiffness)
            .powf(1.0 / (self.exponent + 1.0));
        let step = std::f64::consts::PI * depth / self.speed / 40_000.0;
        let (mut x, mut v) = (0.0f64, self.speed);
        let mut states = vec![[0.0, x, v, self.force(x, v)]];
        let (mut peak, mut deepest) = (states[0][3], 0.0f64);
        loop {
            let a = self.gravity - self.force(x, v) / self.mass;
            let (xm, vm) = (x + 0.5 * step * v, v + 0.5 * step * a);
            let am = self.gravity - self.force(xm, vm) / self.mass;
            (x, v) = (x + step * vm, v + step * am);
            let force = self.force(x, v);
            if v < 0.0 && (force <= 0.0 || x <= 0.0) {
                break;
            }
            (peak, deepest) = (peak.max(force), deepest.max(x));
            states.push([states.len() as f64 * step, x, v, force]);
        }
        let duration = states.len() as f64 * step;
        Motion {
            restitution: -v / self.speed,
            peak_force: peak,
            max_penetration: deepest,
            duration,
            states,
            step,
        }
    }
}

impl Motion {
    fn at(&self, planted: &Planted, time: f64) -> [f64; 3] {
        let g = planted.gravity;
        let free = |x: f64, v: f64, dt: f64| [x + v * dt + 0.5 * g * dt * dt, v + g * dt, 0.0];
        if time < 0.0 {
            return free(0.0, planted.speed, time);
        }
        let last = self.states[self.states.len() - 1];
        let number = (time / self.step) as usize;
        if number + 1 >= self.states.len() {
            return free(last[1], last[2], time - last[0]);
        }
        let (a, b, t) = (self.states[number], self.states[number + 1], time / self.step - number as f64);
        [1, 2, 3].map(|k| a[k] + t * (b[k] - a[k]))
    }
}

/// Normal number.
fn normal(random: &mut StdRng) -> f64 {
    let (a, b): (f64, f64) = (random.random::<f64>().max(1e-300), random.random());
    (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
}

/// How a record is spoiled.
#[derive(Clone, Copy, Debug, Default)]
struct Spoiled {
    noise: f64,
    drift: f64,
    offset: f64,
    clip: Option<f64>,
    /// Coefficient of a filter of first order on the noise.
    smooth: f64,
    outliers: usize,
}

fn record(
    planted: &Planted,
    signals: &[Measured],
    samples: usize,
    spoiled: Spoiled,
    random: &mut StdRng,
) -> Record {
    let motion = planted.motion();
    let start = 3.0 + random.random::<f64>();
    let span = 3.0 * motion.duration;
    let times: Vec<f64> = (0..samples).map(|i| start + span * i as f64 / samples as f64).collect();
    let touch = start + motion.duration * (0.6 + 0.3 * random.random::<f64>());
    let of = |quantity: Measured, random: &mut StdRng| {
        let mut colored = 0.0;
        let exact: Vec<f64> = times
            .iter()
            .map(|time| {
                let [x, v, force] = motion.at(planted, time - touch);
                match quantity {
                    Measured::Force => force,
                    Measured::Acceleration => -force / planted.mass,
                    Measured::Velocity => v,
                    Measured::Displacement => 0.2 - x,
                }
            })
            .collect();
        let amplitude = match quantity {
            Measured::Force => motion.peak_force,
            Measured::Acceleration => motion.peak_force / planted.mass,
            Measured::Velocity => planted.speed,
            Measured::Displacement => motion.max_penetration,
        };
        let has_zero = matches!(quantity, Measured::Force | Measured::Acceleration);
        let limit = if has_zero { spoiled.clip.unwrap_or(f64::INFINITY) * amplitude } else { f64::INFINITY };
        let mut values: Vec<f64> = exact
            .iter()
            .zip(&times)
            .map(|(value, time)| {
                colored = spoiled.smooth * colored
                    + (1.0 - spoiled.smooth * spoiled.smooth).sqrt() * normal(random);
                let zero = if has_zero {
                    amplitude * (spoiled.offset + spoiled.drift * (time - start) / span)
                } else {
                    0.0
                };
                (value + zero + spoiled.noise * amplitude * colored).clamp(-limit, limit)
            })
            .collect();
        for _ in 0..spoiled.outliers {
            let at = random.random_range(0..samples);
            values[at] += amplitude * (0.5 + random.random::<f64>());
        }
        Signal { quantity, values }
    };
    let signals = signals.iter().map(|quantity| of(*quantity, random)).collect();
    Record { times, signals, speed: None }
}

/// Planted contact with random values over the ranges of stops, feet and hammers.
fn random_contact(random: &mut StdRng) -> Planted {
    let exponent = [1.0, 1.5, 1.0 + random.random::<f64>() * 2.0][random.random_range(0..3)];
    let form =
        if exponent > 1.2 && random.random() { DamperForm::HuntCrossley } else { DamperForm::KelvinVoigt };
    let mass = 10f64.powf(random.random_range(-1.0..2.5));
    let speed = 10f64.powf(random.random_range(-1.0..1.0));
    let depth = speed * 10f64.powf(random.random_range(-3.0..-1.5));
    let stiffness = 0.5 * (exponent + 1.0) * mass * speed * speed / depth.powf(exponent + 1.0);
    let damping = random.random_range(0.05..0.5);
    let damping = match form {
        DamperForm::HuntCrossley => damping / speed,
        DamperForm::KelvinVoigt => damping * stiffness * depth.powf(0.5 * (exponent + 1.0)) / speed,
    };
    let gravity = if random.random() { 9.80665f64.min(0.02 * speed * speed / depth) } else { 0.0 };
    Planted { mass, stiffness, exponent, damping, form, speed, gravity, spring: None }
}

/// Signals of the records in turn.
const SIGNALS: [&[Measured]; 7] = [
    &[Measured::Force, Measured::Acceleration],
    &[Measured::Force, Measured::Displacement],
    &[Measured::Force],
    &[Measured::Acceleration],
    &[Measured::Displacement],
    &[Measured::Force, Measured::Acceleration, Measured::Displacement],
    &[Measured::Velocity],
];

/// Identified and planted values.
fn pairs(found: &Identification, planted: &Planted, motion: &Motion) -> [(Estimate, f64); 9] {
    let record = &found.records[0];
    [
        (found.mass, planted.mass),
        (found.stiffness, planted.stiffness),
        (found.exponent, planted.exponent),
        (found.damping, planted.damping),
        (record.restitution, motion.restitution),
        (record.speed, planted.speed),
        (record.peak_force, motion.peak_force),
        (record.max_penetration, motion.max_penetration),
        (record.contact_duration, motion.duration),
    ]
}

/// Two standard uncertainties contain 95 of 100 values of a linear problem. Noise that is correlated, samples that are missing and kinks of
/// the law take some of them; an uncertainty above a fifth of the value is outside of the first-order propagation.
#[test]
fn planted_values_lie_within_the_stated_uncertainty() {
    let cases: usize = std::env::var("PERCUSS_FAMILY").map_or(21, |text| text.parse().expect("a number"));
    let mut random = StdRng::seed_from_u64(7);
    let (mut inside, mut all, mut refused, mut guesses) = (0, 0, 0, 0);
    for case in 0..cases {
        let planted = random_contact(&mut random);
        let spoiled = Spoiled {
            noise: 10f64.powf(random.random_range(-3.0..-1.5)),
            drift: if random.random() { random.random_range(-0.05..0.05) } else { 0.0 },
            offset: random.random_range(-0.1..0.1),
            clip: if random.random_range(0..4) == 0 { Some(random.random_range(0.7..0.95)) } else { None },
            smooth: if random.random_range(0..3) == 0 { random.random_range(0.3..0.8) } else { 0.0 },
            outliers: random.random_range(0..3),
        };
        let samples = random.random_range(200..1500);
        let record = record(&planted, SIGNALS[case % SIGNALS.len()], samples, spoiled, &mut random);
        let known = Known {
            mass: Some(planted.mass),
            gravity: planted.gravity,
            damper: Some(planted.form),
            ..Known::default()
        };
        let Ok(found) = identify(&[record], &known) else {
            refused += 1;
            continue;
        };
        for (estimate, value) in pairs(&found, &planted, &planted.motion()) {
            // A known mass has no uncertainty.
            if estimate.uncertainty == 0.0 {
                continue;
            }
            if estimate.uncertainty > 0.2 * value {
                guesses += 1;
                continue;
            }
            // The planted numbers have the error of their own integration, 1e-4 in the duration.
            let allowed = 2.0 * estimate.uncertainty + 1e-4 * value;
            all += 1;
            inside += usize::from((estimate.value - value).abs() <= allowed);
        }
    }
    println!(
        "{inside} of {all} within two standard uncertainties, {guesses} guesses; {refused} of {cases} refused"
    );
    assert!(guesses * 5 <= all, "{guesses} uncertainties above a fifth of the value, {all} below");
    assert!(inside as f64 >= 0.92 * f64::from(all), "{inside} of {all}");
    assert!(refused * 50 <= cases, "{refused} refused");
}

#[test]
fn a_record_without_noise_gives_the_planted_values() {
    let mut random = StdRng::seed_from_u64(5);
    for case in 0..14 {
        let planted = random_contact(&mut random);
        // A jump of the damper's force between two samples limits the other form to 1e-3.
        let planted = Planted { form: DamperForm::HuntCrossley, damping: 0.3 / planted.speed, ..planted };
        let record = record(&planted, SIGNALS[case % SIGNALS.len()], 800, Spoiled::default(), &mut random);
        let known = Known { mass: Some(planted.mass), gravity: planted.gravity, ..Known::default() };
        let found = identify(&[record], &known).expect("a contact");
        assert_eq!(found.damper, DamperForm::HuntCrossley, "{planted:?}");
        // The planted duration ends at a step, and the stiffness multiplies the error of the exponent.
        for (k, (estimate, value)) in pairs(&found, &planted, &planted.motion()).into_iter().enumerate() {
            let allowed = if k == 1 { 1e-2 } else { 1e-3 };
            assert!(
                (estimate.value / value - 1.0).abs() < allowed,
                "{case}, {k}: {estimate:?} {value:?} {planted:?}"
            );
        }
    }
}

/// Several impacts of one contact, without a damper: the mass is that of all files, and the restitution is 1 within its uncertainty.
#[test]
fn several_records_of_an_elastic_contact_share_their_unknowns() {
    let mut random = StdRng::seed_from_u64(17);
    let elastic = Planted {
        mass: 10.0,
        stiffness: 1e5,
        exponent: 1.0,
        damping: 0.0,
        form: DamperForm::KelvinVoigt,
        speed: 1.0,
        gravity: 0.0,
        spring: None,
    };
    let mut last = f64::INFINITY;
    for count in [1, 4, 12] {
        let signals = &[Measured::Force, Measured::Acceleration];
        let spoiled = Spoiled { noise: 0.01, ..Spoiled::default() };
        let records: Vec<Record> = (0..count)
            .map(|number| {
                let planted = Planted { speed: 0.5 + 0.1 * f64::from(number), ..elastic };
                record(&planted, signals, 60, spoiled, &mut random)
            })
            .collect();
        let known = Known { damper: Some(DamperForm::KelvinVoigt), exponent: Some(1.0), ..Known::default() };
        let found = identify(&records, &known).expect("a contact");
        let mass = found.mass;
        assert!((mass.value - 10.0).abs() < 3.0 * mass.uncertainty, "{count}: {mass:?}");
        assert!(mass.uncertainty < 0.7 * last, "{count}: {mass:?} after {last}");
        last = mass.uncertainty;
        for (number, record) in found.records.iter().enumerate() {
            let (e, t) = (record.restitution, record.contact_duration);
            assert!(
                e.uncertainty > 0.0 && (e.value - 1.0).abs() < 4.0 * e.uncertainty,
                "{count}, {number}: {e:?}"
            );
            // The half period of the spring.
            let half = std::f64::consts::PI * (10.0f64 / 1e5).sqrt();
            assert!(
                t.uncertainty > 0.0 && (t.value - half).abs() < 4.0 * t.uncertainty,
                "{count}, {number}: {t:?}"
            );
        }
    }
}

/// The velocity of a free fall from rest.
#[test]
fn a_fall_from_rest_is_an_approach() {
    let planted = Planted {
        mass: 3.0,
        stiffness: 4e4,
        exponent: 1.0,
        damping: 40.0,
        form: DamperForm::KelvinVoigt,
        speed: 0.8,
        gravity: 9.80665,
        spring: None,
    };
    let motion = planted.motion();
    let fall = planted.speed / planted.gravity;
    let times: Vec<f64> = (0..600).map(|i| (fall + 2.0 * motion.duration) * f64::from(i) / 600.0).collect();
    let values = times.iter().map(|time| motion.at(&planted, time - fall)[1]).collect();
    let record = Record {
        times,
        signals: vec![Signal { quantity: Measured::Velocity, values }],
        speed: Some(planted.speed),
    };
    let known = Known { mass: Some(3.0), gravity: 9.80665, damper: Some(planted.form), ..Known::default() };
    let found = identify(&[record], &known).expect("a contact");
    assert!((found.stiffness.value / planted.stiffness - 1.0).abs() < 1e-2, "{:?}", found.stiffness);
    assert!((found.records[0].restitution.value - motion.restitution).abs() < 1e-3, "{:?}", found.records[0]);
}

/// Channel frequency class: the constants of SAE J211-1, appendix C.
fn filtered(values: &[f64], step: f64, class: f64) -> Vec<f64> {
    let wd = 2.0 * std::f64::consts::PI * class * 2.0775;
    let wa = (wd * step / 2.0).sin() / (wd * step / 2.0).cos();
    let sum = 1.0 + 2f64.sqrt() * wa + wa * wa;
    let b = [wa * wa / sum, 2.0 * wa * wa / sum, wa * wa / sum];
    let a = [-2.0 * (wa * wa - 1.0) / sum, (-1.0 + 2f64.sqrt() * wa - wa * wa) / sum];
    let once = |x: &[f64]| {
        let mut y = x.to_vec();
        for i in 2..x.len() {
            y[i] = b[0] * x[i] + b[1] * x[i - 1] + b[2] * x[i - 2] + a[0] * y[i - 1] + a[1] * y[i - 2];
        }
        y.reverse();
        y
    };
    once(&once(values))
}

#[test]
fn filtered_records_give_the_planted_values_with_their_class() {
    let mut random = StdRng::seed_from_u64(11);
    let planted = Planted {
        mass: 12.0,
        stiffness: 3e6,
        exponent: 1.5,
        damping: 0.25,
        form: DamperForm::HuntCrossley,
        speed: 1.4,
        gravity: 0.0,
        spring: None,
    };
    let spoiled = Spoiled { noise: 0.01, offset: 0.03, ..Spoiled::default() };
    let mut record = record(&planted, &[Measured::Force, Measured::Acceleration], 1000, spoiled, &mut random);
    let step = record.times[1] - record.times[0];
    for signal in &mut record.signals {
        signal.values = filtered(&signal.values, step, 60.0);
    }
    let known = |filter_class| Known { filter_class, damper: Some(planted.form), ..Known::default() };
    let right = identify(std::slice::from_ref(&record), &known(Some(60.0))).expect("a contact");
    for (estimate, value) in pairs(&right, &planted, &planted.motion()) {
        assert!(
            (estimate.value - value).abs() < 3.0 * estimate.uncertainty + 1e-3 * value,
            "{estimate:?} {value}"
        );
    }
    let wrong = identify(&[record], &known(None)).expect("a contact");
    assert!(wrong.records[0].signals[0].correlation_time > 5.0 * step, "{:?}", wrong.records[0].signals[0]);
}

#[test]
fn samples_at_a_limit_and_outliers_are_named() {
    let mut random = StdRng::seed_from_u64(2);
    let planted = random_contact(&mut random);
    let spoiled = Spoiled { noise: 0.002, clip: Some(0.8), outliers: 2, ..Spoiled::default() };
    let record = record(&planted, &[Measured::Force], 900, spoiled, &mut random);
    let known = Known { mass: Some(planted.mass), gravity: planted.gravity, ..Known::default() };
    let found = identify(&[record], &known).expect("a contact");
    let signal = &found.records[0].signals[0];
    assert!(
        signal.clipped > 20 && (1..=2).contains(&signal.outliers.len()),
        "{} {:?}",
        signal.clipped,
        signal.outliers
    );
}

/// Planted contact of a stop: 45 kg at 1 m/s.
const STOP: Planted = Planted {
    mass: 45.0,
    stiffness: 1.2e6,
    exponent: 1.4,
    damping: 0.35,
    form: DamperForm::HuntCrossley,
    speed: 1.0,
    gravity: 0.0,
    spring: None,
};

/// Force over penetration of a progressive stop: a line between six points.
fn six_points(x: f64) -> f64 {
    let points = [(0.0, 0.0), (0.01, 180.0), (0.02, 520.0), (0.03, 1300.0), (0.04, 3300.0), (0.05, 9000.0)];
    let line = points.windows(2).find(|pair| x <= pair[1].0).unwrap_or(&points[4..]);
    let [(x0, f0), (x1, f1)] = [line[0], line[1]];
    f0 + (f1 - f0) * (x - x0) / (x1 - x0)
}

/// A law with two powers is found exactly; a line between points is near it, and its contradiction is stated.
#[test]
fn springs_of_more_than_one_power_are_found() {
    let mut random = StdRng::seed_from_u64(3);
    let spoiled = Spoiled { noise: 0.002, offset: 0.01, ..Spoiled::default() };
    let signals = &[Measured::Force, Measured::Acceleration];
    let cubic = Planted { spring: Some(|x| 2e4 * x + 6e7 * x.powi(3)), speed: 1.5, ..STOP };
    let motion = cubic.motion();
    let found = identify(&[record(&cubic, signals, 600, spoiled, &mut random)], &Known::default())
        .expect("a contact");
    let (second, power) = found.second_term.expect("two terms");
    assert!(power == 1.0 && (second.value - 2e4).abs() < 3.0 * second.uncertainty, "{second:?}");
    let figures = |found: &Identification| {
        let record = &found.records[0];
        [
            record.restitution,
            record.speed,
            record.peak_force,
            record.max_penetration,
            record.contact_duration,
            found.mass,
        ]
    };
    let planted = |motion: &Motion, planted: &Planted| {
        [
            motion.restitution,
            planted.speed,
            motion.peak_force,
            motion.max_penetration,
            motion.duration,
            planted.mass,
        ]
    };
    for (estimate, value) in figures(&found).into_iter().zip(planted(&motion, &cubic)) {
        assert!(
            (estimate.value - value).abs() < 3.0 * estimate.uncertainty + 1e-4 * value,
            "{estimate:?} {value}"
        );
    }
    for speed in [1.0, 2.0] {
        let stop = Planted { spring: Some(six_points), damping: 0.4 / speed, speed, ..STOP };
        let motion = stop.motion();
        let record = record(&stop, signals, 600, spoiled, &mut random);
        for (exponent, mass, given) in
            [(None, None, None), (None, Some(45.0), Some(speed)), (Some(3.0), None, None)]
        {
            let known = Known { exponent, mass, ..Known::default() };
            let found = identify(&[Record { speed: given, ..record.clone() }], &known).expect("a contact");
            let contradicts =
                |signal: &IdentifiedSignal| signal.contradicts(found.records[0].contact_duration.value);
            assert!(found.records[0].signals.iter().any(contradicts), "{speed} {exponent:?}");
            for (estimate, value) in figures(&found).into_iter().zip(planted(&motion, &stop)) {
                // A law with a given exponent has an error that its residuals do not show.
                let allowed =
                    2.0 * estimate.uncertainty + if exponent.is_some() { 0.5 * value } else { 1e-4 * value };
                assert!(
                    (estimate.value - value).abs() < allowed,
                    "{speed} {exponent:?}: {estimate:?} {value}"
                );
            }
        }
    }
}

/// A force with an acceleration does not show the weight; a known speed does.
#[test]
fn the_weight_is_named_where_it_changes_the_result() {
    let mut random = StdRng::seed_from_u64(4);
    let fall = Planted { gravity: 9.80665, ..STOP };
    let spoiled = Spoiled { noise: 0.002, ..Spoiled::default() };
    let record = record(&fall, &[Measured::Force, Measured::Acceleration], 600, spoiled, &mut random);
    let blind = identify(std::slice::from_ref(&record), &Known::default()).expect("a contact");
    let (_, other) = blind.other_weight.expect("a weight");
    assert!((other.speed - 1.0).abs() < 0.01 && blind.records[0].speed.value > 1.1, "{other:?}");
    let record = Record { speed: Some(1.0), ..record };
    let without = identify(std::slice::from_ref(&record), &Known::default()).expect("a contact");
    assert!(without.other_weight.is_some_and(|(is_better, _)| is_better), "{:?}", without.other_weight);
    let known = Known { gravity: 9.80665, ..Known::default() };
    let found = identify(&[record], &known).expect("a contact");
    assert!(found.other_weight.is_none_or(|(is_better, _)| !is_better), "{:?}", found.other_weight);
    for (estimate, value) in pairs(&found, &fall, &fall.motion()) {
        assert!(
            (estimate.value - value).abs() < 3.0 * estimate.uncertainty + 1e-4 * value,
            "{estimate:?} {value}"
        );
    }
}

/// The force of a linear damper jumps between two samples, at any phase.
#[test]
fn a_jump_at_the_touch_has_no_influence_on_the_uncertainty() {
    let mut random = StdRng::seed_from_u64(6);
    let stiff =
        Planted { stiffness: 1e5, exponent: 1.0, damping: 600.0, form: DamperForm::KelvinVoigt, ..STOP };
    let motion = stiff.motion();
    let spoiled = Spoiled { noise: 0.004, offset: 0.01, ..Spoiled::default() };
    let (mut inside, mut all) = (0, 0);
    for _ in 0..12 {
        let record = record(&stiff, &[Measured::Force, Measured::Acceleration], 900, spoiled, &mut random);
        let found = identify(&[record], &Known::default()).expect("a contact");
        assert!(found.records[0].signals.iter().all(|signal| signal.at_touch == 2), "{:?}", found.records[0]);
        for (estimate, value) in pairs(&found, &stiff, &motion) {
            all += 1;
            inside +=
                usize::from((estimate.value - value).abs() <= 2.0 * estimate.uncertainty + 1e-4 * value);
        }
    }
    assert!(inside as f64 >= 0.85 * f64::from(all), "{inside} of {all}");
}

#[test]
fn records_that_do_not_determine_the_contact_are_refused() {
    let mut random = StdRng::seed_from_u64(1);
    let planted = random_contact(&mut random);
    let good = record(
        &planted,
        &[Measured::Force],
        300,
        Spoiled { noise: 0.001, ..Spoiled::default() },
        &mut random,
    );
    let refusal =
        |record: Record, known: Known| identify(&[record], &known).expect_err("a refusal").to_string();
    assert!(refusal(good.clone(), Known::default()).contains("does not determine the mass"));
    let known = Known { mass: Some(planted.mass), ..Known::default() };
    let changed = |change: &dyn Fn(&mut Record)| {
        let mut record = good.clone();
        change(&mut record);
        refusal(record, known)
    };
    assert!(changed(&|record| record.times[7] = record.times[6]).contains("increasing times"));
    assert!(changed(&|record| record.signals[0].values[3] = f64::NAN).contains("finite"));
    assert!(changed(&|record| record.signals[0].values.fill(1.0)).contains("no impact"));
    assert!(changed(&|record| record.times.truncate(10)).contains("10 samples"));
    assert!(changed(&|record| record.speed = Some(-1.0)).contains("closing speed"));
    for class in [1e9, 1e-6, 1e-300, f64::NAN] {
        let filter = Known { filter_class: Some(class), ..known };
        assert!(refusal(good.clone(), filter).contains("filter class"), "{class}");
    }
    for quantity in [Measured::Acceleration, Measured::Velocity, Measured::Displacement] {
        for value in [0.0, 0.5] {
            let constant = Signal { quantity, values: vec![value; 300] };
            let message = changed(&|record| record.signals.push(constant.clone()));
            assert!(message.contains("no impact in its values"), "{quantity:?}: {message}");
        }
    }
    assert!(identify(&[], &known).is_err());
}
