//! Travels beyond the dead centre of the joint that drives them first: four-bars whose rocker pin moves on where the crank
//! or the coupler turns back, against the closed form.

use crate::support::{Scratch, run_in};
use rand::{Rng, SeedableRng, rngs::StdRng};
use serde_json::Value;
use std::fs;

/// Steps of the scan from the drawn pose to the requested one.
const STEPS: i32 = 2000;

type Vector = [f64; 2];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Uniform rods: ground, crank, coupler, rocker lengths (m) and masses of the three moving rods (kg).
#[derive(Debug)]
struct FourBar {
    lengths: [f64; 4],
    masses: [f64; 3],
    /// Side of the crank pin on the line from the crank pivot to the rocker pin.
    side: f64,
}

/// A pose given by the rocker angle: pins, and rates of crank and coupler per unit rate of the rocker.
struct Posed {
    crank_pin: Vector,
    rocker_pin: Vector,
    rates: [f64; 2],
    /// 2 T per squared rate of the rocker, kg·m².
    inertia: f64,
}

impl FourBar {
    fn random(rng: &mut StdRng) -> Self {
        Self {
            lengths: [1.0; 4].map(|x| x * rng.random_range(0.3..1.2)),
            masses: [1.0; 3].map(|x| x * rng.random_range(0.3..5.0)),
            side: if rng.random_bool(0.5) { 1.0 } else { -1.0 },
        }
    }

    /// Pose at a rocker angle; `None` if the linkage cannot be assembled, or nearly so.
    fn at(&self, psi: f64) -> Option<Posed> {
        let [ground, crank, coupler, rocker] = self.lengths;
        let rocker_pin = [ground + rocker * psi.cos(), rocker * psi.sin()];
        let distance = rocker_pin[0].hypot(rocker_pin[1]);
        let along = (crank * crank + distance * distance - coupler * coupler) / (2.0 * distance);
        let across = crank * crank - along * along;
        if across.is_nan() || across < 1e-3 * crank * crank {
            return None;
        }
        let e = rocker_pin.map(|x| x / distance);
        let across = self.side * across.sqrt();
        let crank_pin = [along * e[0] - across * e[1], along * e[1] + across * e[0]];
        let rod = [rocker_pin[0] - crank_pin[0], rocker_pin[1] - crank_pin[1]];
        // Velocities: of the rocker pin per rate of the rocker, of the crank pin per rate of the crank, of the coupler.
        let pin = [-rocker * psi.sin(), rocker * psi.cos()];
        let crank_velocity = [-crank_pin[1], crank_pin[0]];
        let rod_velocity = [-rod[1], rod[0]];
        let crank_rate = dot(pin, rod) / dot(crank_velocity, rod);
        let left = [0, 1].map(|k| pin[k] - crank_rate * crank_velocity[k]);
        let coupler_rate = dot(left, rod_velocity) / (coupler * coupler);
        let middle = [0, 1].map(|k| 0.5 * (pin[k] + crank_rate * crank_velocity[k]));
        let [m, n, o] = self.masses;
        let inertia = m * crank * crank / 3.0 * crank_rate * crank_rate
            + n * (dot(middle, middle) + coupler * coupler / 12.0 * coupler_rate * coupler_rate)
            + o * rocker * rocker / 3.0;
        Some(Posed { crank_pin, rocker_pin, rates: [crank_rate, coupler_rate], inertia })
    }

    /// URDF drawn at a rocker angle, all frames parallel.
    fn urdf(&self, psi: f64) -> Option<String> {
        let Posed { crank_pin, rocker_pin, .. } = self.at(psi)?;
        let [ground, crank, coupler, rocker] = self.lengths;
        let link = |name: &str, mass: f64, length: f64, end: Vector| {
            let i = mass * length * length / 12.0;
            format!(
                "<link name=\"{name}\"><inertial><origin xyz=\"{} {} 0\"/><mass value=\"{mass}\"/>\
                 <inertia ixx=\"{i}\" ixy=\"0\" ixz=\"0\" iyy=\"{i}\" iyz=\"0\" izz=\"{i}\"/></inertial></link>",
                end[0] / 2.0,
                end[1] / 2.0
            )
        };
        let joint = |name: &str, parent: &str, child: &str, at: Vector| {
            format!(
                "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
                 <origin xyz=\"{} {} 0\"/><axis xyz=\"0 0 1\"/></joint>",
                at[0], at[1]
            )
        };
        let rod = [rocker_pin[0] - crank_pin[0], rocker_pin[1] - crank_pin[1]];
        let arm = [rocker_pin[0] - ground, rocker_pin[1]];
        let [m, n, o] = self.masses;
        Some(
            [
                "<robot name=\"four_bar\"><link name=\"ground\"/>".to_owned(),
                link("crank", m, crank, crank_pin),
                link("coupler", n, coupler, rod),
                link("rocker", o, rocker, arm),
                joint("crank_hinge", "ground", "crank", [0.0, 0.0]),
                joint("crank_pin", "crank", "coupler", crank_pin),
                joint("rocker_hinge", "ground", "rocker", [ground, 0.0]),
                format!(
                    "<loop name=\"rocker_pin\" type=\"revolute\"><predecessor link=\"coupler\"><origin xyz=\"{} {} 0\"/>\
                     </predecessor><successor link=\"rocker\"><origin xyz=\"{} {} 0\"/></successor><axis xyz=\"0 0 1\"/>\
                     </loop></robot>",
                    rod[0], rod[1], arm[0], arm[1]
                ),
            ]
            .concat(),
        )
    }

    /// Number of reversals of crank or coupler between two rocker angles; `None` if the linkage does not reach.
    fn reversals(&self, from: f64, to: f64) -> Option<usize> {
        let mut rates = self.at(from)?.rates;
        let mut count = 0;
        for k in 1..=STEPS {
            let next = self.at(from + (to - from) * f64::from(k) / f64::from(STEPS))?.rates;
            count += (0..2).filter(|&i| next[i] * rates[i] < 0.0).count();
            rates = next;
        }
        Some(count)
    }
}

#[test]
fn a_travel_goes_on_beyond_dead_centres_of_its_drivers() {
    let folder = Scratch::new("travel-ends");
    let mut rng = StdRng::seed_from_u64(5);
    let (mut asked, mut reversed, mut worst) = (0, 0, 0.0f64);
    while asked < 60 {
        let bar = FourBar::random(&mut rng);
        let psi = rng.random_range(-3.0..3.0);
        let part: f64 = rng.random_range(0.2..0.9) * if rng.random_bool(0.5) { 1.0 } else { -1.0 };
        let to = psi + part.asin();
        let (Some(reversals), Some(urdf)) = (bar.reversals(psi, to), bar.urdf(psi)) else { continue };
        // Half of the cases have a reversal on the way.
        if reversals == 0 && 2 * reversed < asked {
            continue;
        }
        asked += 1;
        reversed += usize::from(reversals > 0);
        let Some(Posed { inertia, .. }) = bar.at(to) else { panic!("reached before") };
        let rocker = bar.lengths[3];
        let expected = inertia / (rocker * rocker);
        fs::write(folder.path("four_bar.urdf"), urdf).expect("a file");
        let (point, normal) = (
            format!("{},{},0", rocker * psi.cos(), rocker * psi.sin()),
            format!("{},{},0", -psi.sin(), psi.cos()),
        );
        let travel = format!("rocker:{point}:{normal}={}", rocker * part);
        let words = [
            "mass",
            "four_bar.urdf",
            "--link",
            "rocker",
            "--point",
            &point,
            "--normal",
            &normal,
            "--travel",
            &travel,
            "--format",
            "json",
        ];
        let outcome = run_in(&folder, &words);
        assert_eq!(outcome.code, 0, "{bar:?} from {psi} to {to}, {reversals} reversals: {}", outcome.stderr);
        let report: Value = serde_json::from_str(&outcome.stdout).expect("JSON");
        let mass = report["effective_mass"].as_f64().expect("a number");
        let off = (mass / expected - 1.0).abs();
        worst = worst.max(off);
        // Positions are closed to 1e-12 of the size, and rates near a limit amplify this.
        assert!(off < 1e-8, "{bar:?} from {psi} to {to}: {mass}, expected {expected}");
    }
    println!("{asked} travels, {reversed} beyond a reversal, worst {worst:.1e}");
    assert!(reversed >= 30);
}
