//! Sheets: every template unchanged, one car in all notations, closed forms.

use super::mechanics::{place, residuals, respond};
use super::on;
use nalgebra::{Matrix3, Vector3};
use percuss_formats::{LoadOptions, Source, load, write_urdf_with};
use percuss_mechanism::{Mechanism, Severity};
use percuss_suspension::{
    ImportOptions, Imported, LengthUnit, Side, TemplateOptions, VehicleAxes, import, template_keys,
    template_names, template_sheet,
};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::fmt::Write;
use std::path::Path;

pub fn sheet(name: &str) -> String {
    template_sheet(name, &TemplateOptions::default()).expect(name)
}

fn built(text: &str, options: &ImportOptions) -> Imported {
    import(&Source::from_text("my.toml", text), options).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// m̄ at a seat, along the line to the seat on the chassis.
pub fn at_seat(mechanism: &Mechanism, [seat, above]: [&str; 2], ending: &str) -> f64 {
    let [seat, above] = [seat, above].map(|name| format!("{name}{ending}"));
    let line = (place(mechanism, &above) - place(mechanism, &seat)).normalize();
    respond(mechanism, &seat, line, &[]).mass
}

const BUMP: [&str; 2] = ["bump_stop_pad", "bump_stop"];

/// Contents of a sheet, in mm and ISO 8855, left side.
#[derive(Clone)]
pub struct Car {
    pub template: &'static str,
    pub points: Vec<(String, [f64; 3])>,
    /// Section, mass, centre of mass, xx, yy, zz, xy, xz, yz.
    #[allow(clippy::type_complexity, reason = "read in one place")]
    pub bodies: Vec<(String, f64, Option<[f64; 3]>, Vec<f64>)>,
}

/// Notation of a car.
#[derive(Clone, Copy, Debug)]
pub struct Spelling {
    pub unit: LengthUnit,
    pub axes: VehicleAxes,
    pub right: bool,
    pub table: Option<(char, bool)>,
}

fn list(text: &str) -> Vec<f64> {
    let inner = text.trim().trim_start_matches('[').split(']').next().unwrap();
    inner.split(',').map(|x| x.trim().parse().unwrap()).collect()
}

impl Car {
    /// Car of the template's example.
    pub fn example(template: &'static str) -> Self {
        let mut car = Self { template, points: Vec::new(), bodies: Vec::new() };
        let text = sheet(template);
        let mut section = String::new();
        for line in text.lines().map(|l| l.split('#').next().unwrap().trim()).filter(|l| !l.is_empty()) {
            if let Some(name) = line.strip_prefix('[') {
                section = name.trim_end_matches(']').to_owned();
                continue;
            }
            let (key, value) = line.split_once(" = ").unwrap();
            let triple = |value| -> [f64; 3] { list(value).try_into().unwrap() };
            match (&*section, key) {
                ("points", key) => car.points.push((key.to_owned(), triple(value))),
                ("" | "wheel" | "rack", _) => {}
                (_, "mass") => car.bodies.push((section.clone(), value.parse().unwrap(), None, Vec::new())),
                (_, "com") => car.bodies.last_mut().unwrap().2 = Some(triple(value)),
                (_, "inertia") => car.bodies.last_mut().unwrap().3 = list(value),
                _ => {}
            }
        }
        car
    }

    pub fn set(&mut self, point: &str, at: [f64; 3]) -> &mut Self {
        self.points.iter_mut().find(|(key, _)| key == point).expect(point).1 = at;
        self
    }

    pub fn point(&self, point: &str) -> Vector3<f64> {
        Vector3::from(self.points.iter().find(|(key, _)| key == point).expect(point).1) / 1e3
    }

    pub fn body(&self, name: &str) -> (f64, Vector3<f64>, Matrix3<f64>) {
        let (_, mass, com, i) = self.bodies.iter().find(|(key, ..)| key == name).expect(name);
        let at = |k: usize| i.get(k).copied().unwrap_or(0.0);
        let inertia = Matrix3::new(at(0), at(3), at(4), at(3), at(1), at(5), at(4), at(5), at(2));
        (*mass, Vector3::from(com.unwrap_or_default()) / 1e3, inertia)
    }

    /// Removes the anti-roll bar and the given bodies.
    pub fn without(&mut self, bodies: &[&str]) -> &mut Self {
        self.points.retain(|(key, _)| !key.starts_with("anti_roll_bar") && !key.starts_with("drop_link"));
        let bar = ["anti_roll_bar", "drop_link"];
        self.bodies.retain(|(key, ..)| !bar.contains(&&**key) && !bodies.contains(&&**key));
        self
    }

    fn is_central(&self, name: &str) -> bool {
        self.template.starts_with("solid")
            && ["axle", "middle_link", "panhard", "watt"].iter().any(|start| name.starts_with(start))
    }

    /// Keys and values in the given notation.
    fn keys(&self, spelling: Spelling) -> Vec<(String, Vec<f64>)> {
        let side = |name: &str| if spelling.right && !self.is_central(name) { -1.0 } else { 1.0 };
        let length = |x: f64| spelling.unit.of_metres(x / 1e3);
        let place = |name: &str, [x, y, z]: [f64; 3]| {
            let at = spelling.axes.from_iso(Vector3::new(x, side(name) * y, z));
            at.iter().map(|x| length(*x)).collect()
        };
        let mut keys = Vec::new();
        for (name, at) in &self.points {
            keys.push((format!("points.{name}"), place(name, *at)));
        }
        for (name, mass, com, inertia) in &self.bodies {
            keys.push((format!("{name}.mass"), vec![*mass]));
            if let Some(com) = com {
                keys.push((format!("{name}.com"), place(name, *com)));
            }
            if let [xx, yy, zz, xy, xz, yz] = inertia[..] {
                let s = side(name);
                let inertia = Matrix3::new(xx, s * xy, xz, s * xy, yy, s * yz, xz, s * yz, zz);
                // The spindle has the axes of the wheel.
                let i = if name == "spindle" { inertia } else { spelling.axes.inertia_from_iso(inertia) };
                keys.push((format!("{name}.inertia"), [0, 4, 8, 1, 2, 5].map(|at| i[at]).to_vec()));
            } else if let [xx, yy, zz] = inertia[..] {
                let i = Matrix3::from_diagonal(&Vector3::new(xx, yy, zz));
                let i = if name == "spindle" { i } else { spelling.axes.inertia_from_iso(i) };
                keys.push((format!("{name}.inertia"), [0, 4, 8].map(|at| i[at]).to_vec()));
            }
        }
        keys.push(("wheel.mass".into(), vec![18.5]));
        keys.push(("wheel.inertia".into(), vec![0.62, 1.05, 0.62]));
        keys.push(("wheel.radius".into(), vec![length(300.0)]));
        keys
    }

    pub fn spelled(&self, spelling: Spelling) -> String {
        let (unit, axes) = (spelling.unit.name(), spelling.axes.name());
        let side = if spelling.right { "right" } else { "left" };
        let keys = self.keys(spelling);
        let mut out = String::new();
        match spelling.table {
            None => {
                write!(
                    out,
                    "template = \"{}\"\nunit = \"{unit}\"\naxes = \"{axes}\"\nside = \"{side}\"\n",
                    self.template
                )
                .unwrap();
                writeln!(out, "wheel.camber = \"-1.5 deg\"\nwheel.toe = \"0.01 rad\"").unwrap();
                for (key, values) in keys {
                    match &values[..] {
                        [one] => writeln!(out, "{key} = {one:?}").unwrap(),
                        all => writeln!(out, "{key} = {all:?}").unwrap(),
                    }
                }
            }
            Some((separator, comma)) => {
                let s = separator;
                write!(out, "template{s}{}\nunit{s}{unit}\naxes{s}{axes}\nside{s}{side}\n", self.template)
                    .unwrap();
                let mark = |text: String| if comma { text.replace('.', ",") } else { text };
                writeln!(
                    out,
                    "wheel.camber{s}{} deg\nwheel.toe{s}{} rad",
                    mark("-1.5".into()),
                    mark("0.01".into())
                )
                .unwrap();
                for (key, values) in keys {
                    // The section "points" may be left out.
                    let key = key.strip_prefix("points.").unwrap_or(&key);
                    let values: Vec<String> = values.iter().map(|x| mark(format!("{x:?}"))).collect();
                    writeln!(out, "{key}{s}{}", values.join(&s.to_string())).unwrap();
                }
            }
        }
        out
    }

    pub fn text(&self) -> String {
        let unit = LengthUnit::Millimetre;
        self.spelled(Spelling { unit, axes: VehicleAxes::ISO, right: false, table: None })
            .replace("wheel.camber = \"-1.5 deg\"\nwheel.toe = \"0.01 rad\"\n", "")
    }

    pub fn mechanism(&self, side: Side) -> Mechanism {
        built(&self.text(), &on(side)).mechanism
    }

    /// Random variation of the car.
    fn varied(&self, random: &mut StdRng) -> Self {
        let mut car = self.clone();
        for (_, at) in &mut car.points {
            *at = at.map(|x| ((x + random.random_range(-9.0..9.0)) * 64.0).round() / 64.0);
        }
        if is_middle(self.template) {
            car.points.iter_mut().filter(|(key, _)| *key == "wheel_centre").for_each(|(_, at)| at[1] = 0.0);
        }
        for (_, mass, com, inertia) in &mut car.bodies {
            let factor = random.random_range(0.5..2.0);
            *mass *= factor;
            *com = com.map(|com| com.map(|x| x + random.random_range(-9.0..9.0)));
            inertia.iter_mut().for_each(|x| *x *= factor);
        }
        car
    }
}

/// True if the wheel of a template is in the middle plane.
fn is_middle(template: &str) -> bool {
    ["swing-arm", "telescopic-fork"].contains(&template) || template.starts_with("rear-")
}

fn names() -> Vec<&'static str> {
    template_names().into_iter().map(|(name, _)| name).collect()
}

/// Templates whose example has a link on a universal joint with a moment of inertia about its line.
const ASSUMED_PINS: [&str; 2] = ["macpherson-strut", "multi-link"];

/// Only pins that are assumed are noted.
#[test]
fn every_template_imports_as_it_stands_without_a_word() {
    for name in names() {
        for unit in LengthUnit::ALL {
            for axes in VehicleAxes::ALL {
                let text = template_sheet(name, &TemplateOptions { unit, axes }).unwrap();
                let imported = built(&text, &ImportOptions::default());
                let codes: Vec<&str> = imported.diagnostics.iter().map(|d| d.code).collect();
                let is_noted = ![VehicleAxes::ISO, VehicleAxes::ADAMS].contains(&axes);
                let expected = [(is_noted, "axes"), (ASSUMED_PINS.contains(&name), "assumed-pins")];
                let expected: Vec<&str> =
                    expected.into_iter().filter(|(is_found, _)| *is_found).map(|(_, code)| code).collect();
                assert_eq!(codes, expected, "{name}, {}, {}", unit.name(), axes.name());
                // The exported URDF loads without a warning too.
                let urdf = write_urdf_with(&imported.mechanism, &imported.comments);
                let loaded = load(&Source::from_text("my.urdf", urdf), &LoadOptions::default()).unwrap();
                let notes = loaded.diagnostics.iter().all(|d| d.severity == Severity::Note);
                assert!(notes, "{name}: {:?}", loaded.diagnostics);
            }
        }
        let both = built(&sheet(name), &on(Side::Both)).mechanism;
        let (pad, mobility) = if is_middle(name) { ("bump_stop_pad", 2) } else { ("bump_stop_pad_left", 4) };
        let found = respond(&both, pad, Vector3::z(), &[]);
        assert_eq!(found.mobility, mobility, "{name}: travel and spin on each side");
        assert!(residuals(&both).iter().all(|r| *r < 1e-15), "{name}");
    }
    assert!(template_sheet("no such", &TemplateOptions::default()).is_none());
}

#[test]
fn one_car_has_one_mass_however_it_is_said() {
    let mut random = StdRng::seed_from_u64(11);
    let mut said = 0;
    for name in names() {
        for _ in 0..2 {
            let car = Car::example(name).varied(&mut random);
            let mut expected = None;
            let mut spellings = Vec::new();
            for unit in LengthUnit::ALL {
                for axes in VehicleAxes::ALL {
                    for right in [false, true] {
                        let tables = [
                            None,
                            Some((',', false)),
                            Some((';', true)),
                            None,
                            Some((';', false)),
                            Some(('\t', true)),
                        ];
                        spellings.push(Spelling { unit, axes, right, table: tables[spellings.len() % 6] });
                    }
                }
            }
            for (i, spelling) in spellings.into_iter().enumerate() {
                let text = car.spelled(spelling);
                // The large system of both sides is solved only for some notations.
                let sides = [Side::Left, Side::Right, Side::Both];
                for side in sides.into_iter().filter(|side| *side != Side::Both || i % 5 == 0) {
                    let imported = built(&text, &on(side));
                    let (of_axle, of_middle) = (name.starts_with("solid"), is_middle(name));
                    // An axle is always built with both sides, a motorcycle with one; a request for other sides gives a
                    // note, as does a third spring with one side.
                    let codes = imported.diagnostics.iter().map(|d| d.code);
                    let codes: Vec<&str> = codes
                        .filter(|code| !["assumed-pins", "assumed-body", "axes"].contains(code))
                        .collect();
                    let silent = codes.is_empty()
                        || (of_axle || of_middle) && codes == ["one-axle"]
                        || name.ends_with("third-spring") && side != Side::Both && codes == ["one-side"];
                    assert!(silent, "{name}: {:?}", imported.diagnostics);
                    let endings: &[&str] = match side {
                        _ if of_axle => &["_left"],
                        _ if of_middle => &[""],
                        Side::Left | Side::Right => &[""],
                        Side::Both => &["_left", "_right"],
                    };
                    for ending in endings {
                        let mass = at_seat(&imported.mechanism, BUMP, ending);
                        let expected = *expected.get_or_insert(mass);
                        // Roundings of coordinates, multiplied by a condition number of some hundred.
                        assert!(
                            (mass / expected - 1.0).abs() < 1e-12,
                            "{name}, {spelling:?}, {side:?}: {mass} and {expected}"
                        );
                        said += 1;
                    }
                }
            }
        }
    }
    assert!(said > 600, "{said}");
}

/// m̄ of a body on a hinge: inertia about the hinge, divided by the square of the arm.
#[test]
fn a_swing_axle_is_a_pendulum() {
    let mut car = Car::example("swing-axle");
    car.without(&[]);
    let (tube, com, inertia) = car.body("axle_tube");
    let (spindle, _, of_spindle) = car.body("spindle");
    let (centre, pivot) = (car.point("wheel_centre"), car.point("pivot_front"));
    let arm = |p: Vector3<f64>| (p.y - pivot.y).powi(2) + (p.z - pivot.z).powi(2);
    let about =
        inertia[(0, 0)] + tube * arm(com) + of_spindle[(0, 0)] + 0.62 + (spindle + 18.5) * arm(centre);
    let expected = about / (centre.y - pivot.y).powi(2);
    let found = respond(&car.mechanism(Side::Left), "wheel_centre", Vector3::z(), &[]).mass;
    assert!((found / expected - 1.0).abs() < 1e-14, "{found} and {expected}");
}

#[test]
fn a_twist_beam_is_a_trailing_arm_with_half_a_beam() {
    let mut car = Car::example("twist-beam");
    car.without(&[]);
    let (centre, pivot) = (car.point("wheel_centre"), car.point("arm_outer"));
    let arm = |p: Vector3<f64>| (p.x - pivot.x).powi(2) + (p.z - pivot.z).powi(2);
    let turning = ["trailing_arm", "beam"].map(|name| {
        let (mass, com, inertia) = car.body(name);
        inertia[(1, 1)] + mass * arm(com)
    });
    // The wheel does not spin with the arm.
    let about = turning[0] + turning[1] + (car.body("spindle").0 + 18.5) * arm(centre);
    let expected = about / (centre.x - pivot.x).powi(2);
    let found = respond(&car.mechanism(Side::Left), "wheel_centre", Vector3::z(), &[]).mass;
    assert!((found / expected - 1.0).abs() < 1e-14, "{found} and {expected}");
}

#[test]
fn an_axle_on_level_links_is_its_mass() {
    for (name, rods) in [
        ("solid-axle-four-links", &["lower_link", "upper_link"][..]),
        ("solid-axle-panhard", &["lower_link", "middle_link", "panhard_rod"]),
        ("solid-axle-watt", &["lower_link", "middle_link", "watt_left_rod", "watt_right_rod"]),
        ("solid-axle-leaf-springs", &["leaf_front", "leaf_back"]),
    ] {
        let mut car = Car::example(name);
        car.without(rods);
        let level = |car: &mut Car, from: &str, to: &str| {
            let (a, b) = (car.point(from) * 1e3, car.point(to) * 1e3);
            car.set(to, [b.x, b.y, a.z]);
        };
        if name != "solid-axle-leaf-springs" {
            level(&mut car, "lower_link_chassis", "lower_link_outer");
        }
        let crank = match name {
            "solid-axle-four-links" => {
                level(&mut car, "upper_link_chassis", "upper_link_outer");
                0.0
            }
            "solid-axle-panhard" => {
                level(&mut car, "middle_link_chassis", "middle_link_axle");
                level(&mut car, "panhard_chassis", "panhard_axle");
                0.0
            }
            "solid-axle-watt" => {
                level(&mut car, "middle_link_chassis", "middle_link_axle");
                car.body("watt_crank").0
            }
            _ => {
                // The links to the rear eyes are level: eyes and shackles are at rest.
                level(&mut car, "leaf_front_eye", "leaf_clamp_front");
                level(&mut car, "leaf_back_eye", "leaf_clamp_back");
                0.0
            }
        };
        // The axle rises without pitch, yaw and roll: all its parts have the same speed, and the rods' ends on the
        // chassis are at rest.
        let expected = car.body("axle").0 + 2.0 * (car.body("spindle").0 + 18.5) + crank;
        let found = respond(&car.mechanism(Side::Both), "axle", Vector3::z(), &[]).mass;
        // Rounding of the dense system of this test: 30 unknowns, with kilograms and metres in one matrix.
        assert!((found / expected - 1.0).abs() < 1e-9, "{name}: {found} and {expected}");
    }
}

/// A leaf of uniform stress bends to an arc: its end moves on a circle of 3/4 of the free length (f²/(2R) = κ²l³/6 with f = κl²/2).
#[test]
fn leaf_links_have_three_quarters_of_the_free_length() {
    let car = Car::example("solid-axle-leaf-springs");
    let imported = built(&sheet("solid-axle-leaf-springs"), &ImportOptions::default());
    for (link, eye, clamp) in [
        ("leaf_front", "leaf_front_eye", "leaf_clamp_front"),
        ("leaf_back", "leaf_back_eye", "leaf_clamp_back"),
    ] {
        let (_, found) = imported.understood.lengths.iter().find(|(name, _)| name == link).expect(link);
        let expected = 0.75 * (car.point(eye) - car.point(clamp)).norm();
        assert!((found / expected - 1.0).abs() < 1e-14, "{link}: {found} and {expected}");
    }
    let (_, found) =
        imported.understood.lengths.iter().find(|(name, _)| name == "shackle").expect("a shackle");
    let expected = (car.point("leaf_back_eye") - car.point("shackle_chassis")).norm();
    assert!((found / expected - 1.0).abs() < 1e-14, "{found} and {expected}");
}

/// Expected mass: a double wishbone at the pushrod's outer end, plus the rocker's inertia over its lever arms.
#[test]
fn a_rocker_is_a_lever() {
    let mut car = Car::example("pushrod-rocker");
    car.without(&["pushrod"]);
    let rod = (car.point("pushrod_rocker") - car.point("pushrod_outer")).normalize();
    let (pivot, front) = (car.point("rocker_front"), car.point("rocker_back"));
    let axis = (front - pivot).normalize();
    // Speed along a line per unit rate of the rocker.
    let arm = |p: Vector3<f64>, along: Vector3<f64>| axis.cross(&(p - pivot)).dot(&along);
    let (mass, com, inertia) = car.body("rocker");
    let about = axis.dot(&(inertia * axis)) + mass * axis.cross(&(com - pivot)).norm_squared();
    // Double wishbone alone, with a spring seat at the pushrod's end.
    let mut wishbone = car.clone();
    wishbone.template = "double-wishbone";
    let of_rocker = ["pushrod", "rocker", "spring", "damper", "bump", "rebound"];
    let outer = car.point("pushrod_outer") * 1e3;
    let inner = car.point("pushrod_rocker") * 1e3;
    wishbone.points.retain(|(key, _)| !of_rocker.iter().any(|start| key.starts_with(start)));
    wishbone.points.push(("spring_seat".into(), outer.into()));
    wishbone.points.push(("spring_chassis_seat".into(), inner.into()));
    wishbone.bodies.retain(|(key, ..)| key != "rocker");
    let alone = respond(&wishbone.mechanism(Side::Left), "spring_seat", rod, &[]).mass;
    let (seat, above) = (car.point("damper_seat"), car.point("damper_chassis_seat"));
    let (at_rod, at_damper) = (arm(car.point("pushrod_rocker"), rod), arm(seat, (above - seat).normalize()));
    let expected = (alone * at_rod.powi(2) + about) / at_damper.powi(2);
    let found = at_seat(&car.mechanism(Side::Left), ["damper_seat", "damper_chassis_seat"], "");
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} and {expected}");
}

/// An anti-roll bar adds the inertia of its half, divided by the square of the drop link's lever arm.
#[test]
fn a_bar_counts_by_its_inertia() {
    let mut car = Car::example("swing-axle");
    car.bodies.retain(|(key, ..)| key != "drop_link");
    let with = respond(&car.mechanism(Side::Left), "wheel_centre", Vector3::z(), &[]).mass;
    let (mass, com, inertia) = car.body("anti_roll_bar");
    let [at, inner, from, to, pivot, centre] = [
        "anti_roll_bar_outer",
        "anti_roll_bar_inner",
        "drop_link_bar",
        "drop_link_end",
        "pivot_front",
        "wheel_centre",
    ]
    .map(|key| car.point(key));
    let axis = (inner - at).normalize();
    let about = axis.dot(&(inertia * axis)) + mass * axis.cross(&(com - at)).norm_squared();
    let along = (to - from).normalize();
    // The tube rotates by 1/(y − y_pivot) per unit speed of the wheel centre.
    let speed = Vector3::x().cross(&(to - pivot)).dot(&along) / (centre.y - pivot.y);
    let rate = speed / axis.cross(&(from - at)).dot(&along);
    let without = respond(&car.without(&[]).mechanism(Side::Left), "wheel_centre", Vector3::z(), &[]).mass;
    let expected = without + about * rate.powi(2);
    assert!((with / expected - 1.0).abs() < 1e-13, "{with} and {expected}");
    assert!(with > without * 1.001, "the bar is felt: {with} and {without}");
}

#[test]
fn a_moved_hardpoint_is_moved_in_the_sheets_own_axes() {
    let mut car = Car::example("double-wishbone");
    let moved = |text: &str, by: [f64; 3]| {
        let moves = vec![("lower_ball".to_owned(), by)];
        let options = ImportOptions { moves, ..ImportOptions::default() };
        at_seat(&built(text, &options).mechanism, BUMP, "")
    };
    let found = moved(&car.text(), [0.0, 0.002, 0.005]);
    let axes = VehicleAxes::ADAMS;
    let spelling = Spelling { unit: LengthUnit::Millimetre, axes, right: true, table: None };
    let other = car.spelled(spelling).replace("-1.5 deg", "0 deg").replace("0.01 rad", "0 rad");
    // Right side and y to the right: outward is +y.
    let other = moved(&other, [0.0, 0.002, 0.005]);
    let at = car.point("lower_ball") * 1e3;
    let expected =
        at_seat(&car.set("lower_ball", [at.x, at.y + 2.0, at.z + 5.0]).mechanism(Side::Left), BUMP, "");
    for mass in [found, other] {
        assert!((mass / expected - 1.0).abs() < 1e-12, "{mass} and {expected}");
    }
}

/// Root folder of the repository.
fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

#[test]
fn the_documentation_has_the_table_of_all_keys() {
    let text = std::fs::read_to_string(root().join("docs/reference/SUSPENSIONS.md")).unwrap();
    let table = template_keys();
    assert!(text.contains(&table), "docs/reference/SUSPENSIONS.md is to hold this table:\n{table}");
}

#[test]
fn an_example_of_each_template_is_shipped() {
    for name in names() {
        let path = root().join(format!("models/suspensions/{name}.toml"));
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(text == sheet(name), "{} is to be what `percuss template {name}` prints", path.display());
    }
}

/// Watt's crank is not mirrored, even off the middle plane; seats on the crank are mirrored.
#[test]
fn seats_of_both_sides_may_be_on_a_link_that_both_share() {
    let text = sheet("solid-axle-watt");
    let changed = text
        .replace("[spring]\non = \"axle\"", "[spring]\non = \"watt_crank\"")
        .replace("watt_pivot = [-130.0, 0.0,", "watt_pivot = [-130.0, 40.0,");
    assert_eq!(changed.len(), text.len() + 7, "both were replaced");
    let mechanism = built(&changed, &ImportOptions::default()).mechanism;
    let [left, right] = ["spring_seat_left", "spring_seat_right"].map(|seat| {
        let joint = mechanism.parent_joint(mechanism.find_link(seat).unwrap()).unwrap();
        assert_eq!(mechanism.link(mechanism.joint(joint).parent()).name(), "watt_crank");
        place(&mechanism, seat)
    });
    // Some roundings of lengths below 1 m.
    let mirrored = Vector3::new(right.x, -right.y, right.z);
    assert!((left - mirrored).amax() < 1e-15, "{left} {right}");
    assert!((left - Vector3::new(-0.02, 0.48, 0.4)).amax() < 1e-15, "{left}");
}

/// A seat may be on any link, also on a rod with or without mass: half way along the rod, the mass along the same line is four times that
/// at the outer end, because the closing speed is half as large.
#[test]
fn a_spring_may_be_on_a_rod() {
    for (template, rods) in [
        ("five-link", &["upper_front_link", "upper_back_link", "lower_front_link", "lower_back_link"][..]),
        ("multi-link", &["lateral", "trailing_link"]),
        ("three-link", &["upper_link", "lower_link"]),
    ] {
        let car = Car::example(template);
        for rod in rods {
            let [inner, outer] = ["chassis", "outer"].map(|end| 1e3 * car.point(&format!("{rod}_{end}")));
            // Only the links of five-link may be left out.
            for is_massless in [false, true].into_iter().filter(|x| !x || template == "five-link") {
                let mass = |part: f64| {
                    let at = inner + part * (outer - inner);
                    let above = at + Vector3::new(40.0, -60.0, 300.0);
                    let point = |at: Vector3<f64>| format!("[{}, {}, {}]", at.x, at.y, at.z);
                    let (mut lines, mut section) = (Vec::new(), String::new());
                    for line in sheet(template).lines() {
                        if let Some(name) = line.strip_prefix('[') {
                            section = name.trim_end_matches(']').to_owned();
                        }
                        if is_massless && section == *rod && !line.starts_with('#') {
                            continue;
                        }
                        lines.push(match line.split(" = ").next() {
                            Some("spring_seat") => format!("spring_seat = {}", point(at)),
                            Some("spring_chassis_seat") => format!("spring_chassis_seat = {}", point(above)),
                            Some("on") if section == "spring" => format!("on = \"{rod}\""),
                            _ => line.to_owned(),
                        });
                    }
                    let mechanism = built(&lines.join("\n"), &ImportOptions::default()).mechanism;
                    at_seat(&mechanism, ["spring_seat", "spring_chassis_seat"], "")
                };
                let (half, whole) = (mass(0.5), mass(1.0));
                // Roundings times the condition of the mass matrix, some 1e4.
                let off = half / (4.0 * whole) - 1.0;
                assert!(off.abs() < 1e-10, "{template} {rod} {is_massless}: {half} {whole}");
            }
        }
    }
}
