//! Forces of springs, dampers and stops in a sheet.

use super::{Entries, Quantity};
use crate::corner::design::STOPS;
use crate::findings::{Findings, Spot};
use crate::forces::{ForceElements, SpringForce, TyreForce};
use crate::limits::{
    DAMPER_SPEEDS, MAX_CURVE_POINTS, MAX_POWERS, PRELOADS, SPRING_RATES, STOP_DEPTHS, STOP_FORCES, TYRE_RATES,
};
use crate::sheet::catalogue::DAMPER;
use crate::units::short;
use percuss_contact::{DamperCurve, ForceCurve};
use percuss_units::LengthUnit;
use std::sync::Arc;

impl Entries {
    /// Reads the forces of springs, dampers and stops, by the sections of a template.
    pub fn force_elements(
        &mut self,
        findings: &mut Findings,
        sections: &[&str],
        unit: LengthUnit,
    ) -> ForceElements {
        let mut elements = ForceElements::default();
        for section in sections {
            if STOPS.contains(section) {
                let stop = self.stop_force(findings, section, unit);
                elements.stops.extend(stop.map(|stop| ((*section).to_owned(), stop)));
            } else if *section == DAMPER {
                let damper = self.damper_force(findings);
                elements.dampers.extend(damper.map(|damper| ((*section).to_owned(), Arc::new(damper))));
            } else {
                let spring = self.spring_force(findings, section);
                elements.springs.extend(spring.map(|spring| ((*section).to_owned(), spring)));
            }
        }
        elements.tyre = self.tyre_force(findings);
        elements.anti_roll_bar = self.bar_stiffness(findings);
        elements
    }

    /// Reads the tyre.
    fn tyre_force(&mut self, findings: &mut Findings) -> Option<TyreForce> {
        let vertical = self.numbers(findings, "tyre.vertical", Quantity::Stiffness, &[1]);
        let damping = self.numbers(findings, "tyre.damping", Quantity::Damping, &[1]);
        let load = self.numbers(findings, "tyre.load", Quantity::Force, &[1]);
        let given = [&vertical, &damping, &load].into_iter().flatten();
        for (values, spot) in given.clone() {
            if values[0] < 0.0 {
                findings.error(
                    "bad-tyre",
                    spot,
                    format!("{}; a number of at least 0 is expected", values[0]),
                );
                return None;
            }
        }
        let spot = given.map(|(_, spot)| spot.clone()).next()?;
        let Some((vertical, rate_spot)) = vertical else {
            let message = "tyre.vertical is missing: the vertical stiffness of the tyre";
            findings.error("missing-key", &spot, message.to_owned());
            return None;
        };
        if !TYRE_RATES.contains(&vertical[0]) {
            let message = format!(
                "{}; a vertical stiffness from {} to {} N/mm is usual for a tyre: check its unit",
                self.given("tyre.vertical"),
                TYRE_RATES.start() / 1e3,
                TYRE_RATES.end() / 1e3
            );
            findings.warning("implausible-force", &rate_spot, message);
        }
        let number = |given: Option<(Vec<f64>, Spot)>| given.map(|(values, _)| values[0]);
        let damping = number(damping).unwrap_or(0.0);
        Some(TyreForce { rate: vertical[0], damping, load: number(load) })
    }

    /// Reads the torsional stiffness of the anti-roll bar, N·m/rad.
    fn bar_stiffness(&mut self, findings: &mut Findings) -> Option<f64> {
        let (values, spot) =
            self.numbers(findings, "anti_roll_bar.stiffness", Quantity::RotationalStiffness, &[1])?;
        let message = if values[0] < 0.0 {
            format!("{} N·m/rad; a stiffness of at least 0 is expected", values[0])
        } else if !self.has("points.drop_link_bar") {
            "the sheet has no anti-roll bar: give its four points, or remove the stiffness".to_owned()
        } else {
            return Some(values[0]);
        };
        findings.error("bad-rate", &spot, message);
        None
    }

    /// Reads the rate and the preload of a spring.
    fn spring_force(&mut self, findings: &mut Findings, section: &str) -> Option<SpringForce> {
        let [rate_key, preload_key] = ["rate", "preload"].map(|key| format!("{section}.{key}"));
        let rate = self.numbers(findings, &rate_key, Quantity::Stiffness, &[1]);
        let preload = self.numbers(findings, &preload_key, Quantity::Force, &[1]);
        let preload = preload.map(|(values, spot)| (values[0], spot));
        match (rate, preload) {
            (Some((rate, spot)), _) if rate[0] < 0.0 => {
                findings.error(
                    "bad-rate",
                    &spot,
                    format!("{} N/m; a rate of at least 0 is expected", rate[0]),
                );
                None
            }
            (Some((rate, spot)), preload) => {
                if rate[0] > 0.0 && !SPRING_RATES.contains(&rate[0]) {
                    let usual = SPRING_RATES.start() / 1e3..=SPRING_RATES.end() / 1e3;
                    let message = format!(
                        "{}; a rate from {} to {} N/mm is usual: check its unit",
                        self.given(&rate_key),
                        usual.start(),
                        usual.end()
                    );
                    findings.warning("implausible-force", &spot, message);
                }
                if let Some((force, spot)) = &preload
                    && *force != 0.0
                    && !PRELOADS.contains(&force.abs())
                {
                    let message = format!(
                        "{}; a preload from {} N to {} kN is usual: check its unit, N without one",
                        self.given(&preload_key),
                        PRELOADS.start(),
                        PRELOADS.end() / 1e3
                    );
                    findings.warning("implausible-force", spot, message);
                }
                Some(SpringForce { rate: rate[0], preload: preload.map(|(force, _)| force) })
            }
            (None, Some((_, spot))) if !self.has(&rate_key) => {
                let message = format!("a preload without {rate_key}: the rate of the spring is expected");
                findings.error("missing-key", &spot, message);
                None
            }
            (None, _) => None,
        }
    }

    /// Reads the damping or the curve of the damper.
    fn damper_force(&mut self, findings: &mut Findings) -> Option<DamperCurve> {
        let counts: Vec<usize> = (2..=MAX_CURVE_POINTS).collect();
        let damping = self.numbers(findings, "damper.damping", Quantity::Damping, &[1]);
        let speeds = self.numbers(findings, "damper.speeds", Quantity::Speed, &counts);
        let forces = self.numbers(findings, "damper.forces", Quantity::Force, &counts);
        let spot = [&damping, &speeds, &forces].into_iter().flatten().map(|(_, spot)| spot.clone()).next()?;
        if let Some((speeds, spot)) = &speeds
            && let Some(fastest) = speeds.iter().map(|v| v.abs()).reduce(f64::max)
            && !DAMPER_SPEEDS.contains(&fastest)
        {
            let message = format!(
                "the fastest speed is {} m/s; the curve of a damper usually ends between {} and {} m/s: check the unit, m/s without one",
                short(fastest),
                DAMPER_SPEEDS.start(),
                DAMPER_SPEEDS.end()
            );
            findings.warning("implausible-curve", spot, message);
        }
        let curve = match (damping, speeds, forces) {
            (Some((damping, _)), None, None) => DamperCurve::linear(damping[0]),
            (None, Some((speeds, _)), Some((forces, _))) => DamperCurve::new(speeds, forces),
            _ => {
                let message = "damper.damping, or damper.speeds and damper.forces are expected";
                findings.error("bad-curve", &spot, message.to_owned());
                return None;
            }
        };
        curve.map_err(|error| findings.error("bad-curve", &spot, error.to_string())).ok()
    }

    /// Reads the powers of a stop, F = Σ cᵢ x^pᵢ up to the last deflection; the unit of x is that of the sheet.
    fn stop_powers(
        &mut self,
        findings: &mut Findings,
        section: &str,
        unit: LengthUnit,
    ) -> Option<(ForceCurve, Spot)> {
        let [coefficients, exponents, to] =
            ["coefficients", "exponents", "to"].map(|key| format!("{section}.{key}"));
        let counts: Vec<usize> = (1..=MAX_POWERS).collect();
        let given = self.numbers(findings, &coefficients, Quantity::Component, &counts);
        let powers = self.numbers(findings, &exponents, Quantity::Component, &counts);
        let last = self.numbers(findings, &to, Quantity::Length(unit), &[1]);
        let spot = [&given, &powers, &last].into_iter().flatten().map(|(_, spot)| spot.clone()).next()?;
        let is_two = ["deflections", "forces"].iter().any(|key| self.has(&format!("{section}.{key}")));
        let (Some((given, _)), Some((last, _)), false) = (given, last, is_two) else {
            let message = format!(
                "{coefficients} and {to} are expected, with {exponents} unless these are 1, 2, 3 …; or points, {section}.deflections and \
                 {section}.forces"
            );
            findings.error("bad-curve", &spot, message);
            return None;
        };
        let powers =
            powers.map_or_else(|| (1..=given.len()).map(|p| p as f64).collect(), |(powers, _)| powers);
        if powers.len() != given.len() {
            let message =
                format!("{} coefficients and {} exponents; expected one for each", given.len(), powers.len());
            findings.error("bad-curve", &spot, message);
            return None;
        }
        let per_metre = unit.of_metres(1.0);
        let terms = given.iter().zip(&powers).map(|(c, p)| (c * per_metre.powf(*p), *p)).collect();
        let curve = ForceCurve::powers(terms, last[0]);
        let curve = curve.map_err(|error| findings.error("bad-curve", &spot, error.to_string())).ok()?;
        Some((curve, spot))
    }

    /// Reads the curve of a stop.
    fn stop_force(&mut self, findings: &mut Findings, section: &str, unit: LengthUnit) -> Option<ForceCurve> {
        if ["coefficients", "exponents", "to"].iter().any(|key| self.has(&format!("{section}.{key}"))) {
            let (curve, spot) = self.stop_powers(findings, section, unit)?;
            let (depth, force) = curve.end();
            self.check_stop_end(findings, (depth, &spot), (force, &spot), unit);
            return Some(curve);
        }
        let counts: Vec<usize> = (2..=MAX_CURVE_POINTS).collect();
        let [deflections_key, forces_key] = ["deflections", "forces"].map(|key| format!("{section}.{key}"));
        let is_given = self.has(&deflections_key) || self.has(&forces_key);
        let deflections = self.numbers(findings, &deflections_key, Quantity::Length(unit), &counts);
        let forces = self.numbers(findings, &forces_key, Quantity::Force, &counts);
        let spot = [&deflections, &forces].into_iter().flatten().map(|(_, spot)| spot.clone()).next();
        let ends = deflections.as_ref().zip(forces.as_ref());
        if let Some(([.., depth], depth_spot, [.., force], force_spot)) =
            ends.map(|((x, at_x), (f, at_f))| (&x[..], at_x, &f[..], at_f))
        {
            self.check_stop_end(findings, (*depth, depth_spot), (*force, force_spot), unit);
        }
        let has_negative = forces.iter().any(|(forces, _)| forces.iter().any(|force| *force < 0.0));
        if let Some((forces, spot)) = &forces {
            if has_negative {
                let message = "the forces of a stop are compressions: numbers of 0 or more are expected";
                findings.error("bad-curve", spot, message.to_owned());
            } else if let Some(pair) = forces.windows(2).find(|pair| pair[1] < pair[0]) {
                let [high, low] = [pair[0], pair[1]].map(short);
                let message = format!(
                    "the force decreases from {high} N to {low} N while the stop is compressed: check the values"
                );
                findings.warning("implausible-curve", spot, message);
            }
        }
        let curve = deflections.zip(forces).and_then(|((x, _), (f, _))| ForceCurve::new(x, f).ok());
        if let (None, true, Some(spot)) = (&curve, is_given && !has_negative, spot) {
            let message = format!(
                "{deflections_key} and {forces_key} are expected as two lists of the same length, the deflections from 0 and \
                 increasing"
            );
            findings.error("bad-curve", &spot, message);
        }
        curve
    }

    /// Warns about an implausible end of the curve of a stop: deflection (m) and force (N), each with its place.
    fn check_stop_end(
        &self,
        findings: &mut Findings,
        (depth, depth_spot): (f64, &Spot),
        (force, force_spot): (f64, &Spot),
        unit: LengthUnit,
    ) {
        if !STOP_DEPTHS.contains(&depth) {
            let message = format!(
                "the last deflection is {} {1}; a stop is usually compressed by {2} to {3} {1}: check the unit",
                short(unit.of_metres(depth)),
                unit.name(),
                short(unit.of_metres(*STOP_DEPTHS.start())),
                short(unit.of_metres(*STOP_DEPTHS.end()))
            );
            findings.warning("implausible-curve", depth_spot, message);
        }
        if !STOP_FORCES.contains(&force.abs()) {
            let message = format!(
                "the last force is {} N; the force of a stop is usually {} N to {} kN: check the unit, N without one",
                short(force),
                STOP_FORCES.start(),
                STOP_FORCES.end() / 1e3
            );
            findings.warning("implausible-curve", force_spot, message);
        }
    }
}
