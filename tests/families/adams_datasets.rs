//! Random trees and linkages, written as datasets of Adams Solver at a random position by this test, with random frames of parts and markers, units
//! and layouts: m̄ of the dataset is that of route C on the original at this position.

use nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use percuss_dynamics::{Conditions, Contact, Direction, EffectiveMass, Frame, System};
use percuss_formats::{LoadOptions, Source, load};
use percuss_mechanism::{ClosureDescription, ClosureKind, JointKind, Mechanism};
use percuss_oracle::alter::{build_with_loops, describe, describe_loops};
use percuss_oracle::maximal::{self, Outcome, Question};
use percuss_oracle::random;
use percuss_spatial::Transform;
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::collections::BTreeMap;
use std::fmt::Write;

const MECHANISMS: u64 = 300;
/// Relative difference of two mechanisms in other frames, with singular values of the loops of at least 1e-3.
const AGREEMENT: f64 = 1e-8;
const LEAST_SINGULAR_VALUE: f64 = 1e-3;

/// Names of a unit of length and of mass, with their factors to metres and kilograms.
const UNITS: [(&str, f64, &str, f64); 5] = [
    ("METER", 1.0, "KILOGRAM", 1.0),
    ("MILLIMETER", 1e-3, "KILOGRAM", 1.0),
    ("MILLIMETER", 1e-3, "TONNE", 1e3),
    ("INCH", 0.0254, "POUND_MASS", 0.45359237),
    ("FOOT", 0.3048, "SLUG", 0.45359237 * 9.80665 / 0.3048),
];

fn vector(rng: &mut StdRng, most: f64) -> Vector3<f64> {
    Vector3::from([(); 3].map(|()| rng.random_range(-most..most)))
}

fn rotation(rng: &mut StdRng) -> Matrix3<f64> {
    Rotation3::from_scaled_axis(vector(rng, 3.0)).into_inner()
}

/// Rotation whose third column is the axis.
fn to_z(axis: &Vector3<f64>) -> Matrix3<f64> {
    let z = axis.normalize();
    let mut other = Vector3::zeros();
    other[z.iamin()] = 1.0;
    let x = other.cross(&z).normalize();
    Matrix3::from_columns(&[x, z.cross(&x), z])
}

/// Angles a, b, c of R = R_z(a) R_x(b) R_z(c).
fn euler(r: &Matrix3<f64>) -> [f64; 3] {
    let sine = r[(0, 2)].hypot(r[(1, 2)]);
    if sine > 1e-8 {
        return [r[(0, 2)].atan2(-r[(1, 2)]), sine.atan2(r[(2, 2)]), r[(2, 0)].atan2(r[(2, 1)])];
    }
    let b = if r[(2, 2)] > 0.0 { 0.0 } else { std::f64::consts::PI };
    [r[(1, 0)].atan2(r[(0, 0)]), b, 0.0]
}

/// Dataset under construction.
struct Dataset {
    text: String,
    unit: (&'static str, f64, &'static str, f64),
    markers: usize,
}

impl Dataset {
    fn list(values: impl IntoIterator<Item = f64>) -> String {
        values.into_iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ")
    }

    /// Origin and orientation as arguments, in degrees or radians, on one line or two.
    fn frame(&self, rng: &mut StdRng, origin: &str, at: &Transform<f64>) -> String {
        let xyz = Self::list((at.translation / self.unit.1).iter().copied());
        let angles = euler(&at.rotation);
        let angles = if rng.random_bool(0.5) {
            angles.map(|angle| format!("{:?}D", angle.to_degrees())).join(", ")
        } else {
            Self::list(angles)
        };
        let newline = if rng.random_bool(0.5) { "\n" } else { "" };
        format!(", {origin} = {xyz}{newline}, reuler = {angles}")
    }

    /// Adds a marker of a part, given its frame and that of the part in the ground; its identifier.
    fn marker(
        &mut self,
        rng: &mut StdRng,
        part: usize,
        frame: &Transform<f64>,
        own: &Transform<f64>,
    ) -> usize {
        self.markers += 1;
        let local = own.inverse() * *frame;
        let arguments = self.frame(rng, "QP", &local);
        let _ = writeln!(self.text, "MARKER/{:04}, PART = {part}{arguments}", self.markers);
        self.markers
    }
}

/// Dataset of a mechanism with links at `poses`.
fn dataset(rng: &mut StdRng, mechanism: &Mechanism, poses: &[Transform<f64>]) -> String {
    let unit = UNITS[rng.random_range(0..UNITS.len())];
    let mut out = Dataset { text: String::new(), unit, markers: 0 };
    let root = mechanism.root().index();
    let own: Vec<Transform<f64>> =
        (0..poses.len())
            .map(|i| {
                if i == root {
                    Transform::identity()
                } else {
                    Transform::new(rotation(rng), vector(rng, 1.0))
                }
            })
            .collect();
    out.text.push_str("ADAMS/View model name: family\n!\nUNITS/\n");
    let _ = writeln!(out.text, ", FORCE = NEWTON\n, MASS = {}, LENGTH = {}\n, TIME = SECOND", unit.2, unit.0);
    for (i, link) in mechanism.links().iter().enumerate() {
        let (id, name) = (i + 1, link.name());
        if i == root {
            let _ = writeln!(out.text, "! adams_view_name='{name}'\nPART/{id}, GROUND");
            continue;
        }
        let inertial = link.inertial().expect("every link has mass");
        let (mass, at) = (inertial.mass, poses[i].point(&inertial.com));
        let r = poses[i].rotation;
        let about_com = r * inertial.about_com * r.transpose();
        let cm = Transform::new(rotation(rng), at);
        let im = rng.random_bool(0.5).then(|| Transform::new(rotation(rng), at + vector(rng, 0.3)));
        let d = at - im.map_or(at, |im| im.translation);
        let about = about_com + (Matrix3::identity() * d.norm_squared() - d * d.transpose()) * mass;
        let axes = im.unwrap_or(cm).rotation;
        let unit_of_inertia = unit.3 * unit.1 * unit.1;
        let m = axes.transpose() * about * axes / unit_of_inertia;
        let ip = Dataset::list([m[(0, 0)], m[(1, 1)], m[(2, 2)], -m[(0, 1)], -m[(0, 2)], -m[(1, 2)]]);
        let cm = out.marker(rng, id, &cm, &own[i]);
        let im = im.map_or_else(String::new, |im| format!(", IM = {}", out.marker(rng, id, &im, &own[i])));
        let place = out.frame(rng, "QG", &own[i]);
        if i % 3 > 0 {
            let _ = writeln!(out.text, "!                            adams_view_name='{name}'");
        }
        let _ = writeln!(
            out.text,
            "Part/{id}{place}, MASS = {:?} ! of {name}\n, CM = {cm}{im}\n, IP = {ip}",
            mass / unit.3
        );
    }
    let mut count = 0;
    let mut connect =
        |rng: &mut StdRng, out: &mut Dataset, kind: &str, ends: [(usize, Transform<f64>); 2]| {
            let mut ids = ends.map(|(link, frame)| out.marker(rng, link + 1, &frame, &own[link]));
            if rng.random_bool(0.5) && kind != "UNIVERSAL" {
                ids.reverse();
            }
            count += 1;
            let name = if kind == "SPHERICAL" && rng.random_bool(0.5) { "JPRIM" } else { "JOINT" };
            let kind = if name == "JPRIM" { "ATPOINT" } else { kind };
            let _ = writeln!(out.text, "{name}/{count}, {kind}, I = {}\n, J = {}", ids[0], ids[1]);
        };
    let spin = |rng: &mut StdRng| {
        *Rotation3::from_axis_angle(&Vector3::z_axis(), rng.random_range(-3.0..3.0)).matrix()
    };
    for joint in mechanism.joints() {
        let (parent, child) = (joint.parent().index(), joint.child().index());
        let (base, moved) = (poses[parent] * *joint.origin(), poses[child]);
        let z = moved.rotation * to_z(joint.axis());
        let at = |rotation: Matrix3<f64>, frame: &Transform<f64>| Transform::new(rotation, frame.translation);
        let (kind, on_parent, on_child) = match joint.kind() {
            JointKind::Fixed => ("FIXED", at(z, &moved), at(z, &moved)),
            JointKind::Revolute | JointKind::Continuous => {
                ("REVOLUTE", at(z * spin(rng), &moved), at(z * spin(rng), &moved))
            }
            JointKind::Prismatic => ("TRANSLATIONAL", at(z, &base), at(z, &moved)),
            JointKind::Planar => ("PLANAR", at(z * spin(rng), &base), at(z * spin(rng), &moved)),
            JointKind::Spherical => ("SPHERICAL", at(rotation(rng), &moved), at(rotation(rng), &moved)),
            JointKind::Floating => continue,
        };
        connect(rng, &mut out, kind, [(child, on_child), (parent, on_parent)]);
    }
    for closure in mechanism.closures() {
        let [first, second] = [closure.predecessor(), closure.successor()].map(|end| {
            let link = end.link.map_or(root, |link| link.index());
            (link, poses[link] * end.frame)
        });
        let turned = |(link, frame): (usize, Transform<f64>), axis: &Vector3<f64>, by: Matrix3<f64>| {
            (link, Transform::new(frame.rotation * to_z(axis) * by, frame.translation))
        };
        let (kind, spins) = match closure.kind() {
            ClosureKind::Fixed => ("FIXED", false),
            ClosureKind::Prismatic => ("TRANSLATIONAL", false),
            ClosureKind::Revolute => ("REVOLUTE", true),
            ClosureKind::Cylindrical => ("CYLINDRICAL", true),
            ClosureKind::Planar => ("PLANAR", true),
            ClosureKind::Spherical => ("SPHERICAL", true),
            ClosureKind::Universal => ("UNIVERSAL", true),
            ClosureKind::Distance => unreachable!("filtered"),
        };
        let by = [(); 2].map(|()| if spins { spin(rng) } else { Matrix3::identity() });
        let axis2 = if kind == "UNIVERSAL" { closure.axis2() } else { closure.axis() };
        connect(rng, &mut out, kind, [turned(second, axis2, by[1]), turned(first, closure.axis(), by[0])]);
    }
    out.text.push_str("REQUEST/1, DISPLACEMENT, I = 1, J = 2\nACCGRAV/KGRAV = -9.81\nOUTPUT/REQSAVE\nEND\n");
    out.text
}

/// Mechanism without what a dataset cannot state: armatures, mimics, rods; with its positions.
fn mechanism(rng: &mut StdRng) -> (Mechanism, Vec<Vec<f64>>) {
    let (made, positions) = random::linkage(rng, 6, 3);
    let (links, mut joints) = describe(&made);
    for joint in &mut joints {
        (joint.armature, joint.mimic) = (Vec::new(), None);
    }
    let (closures, _) = describe_loops(&made);
    let root = made.link(made.root()).name();
    let is_ground = |name: &str| name == root || name == "world";
    let is_stated = |closure: &ClosureDescription| {
        closure.kind != ClosureKind::Distance
            && !(is_ground(&closure.predecessor) && is_ground(&closure.successor))
    };
    let closures = closures.into_iter().filter(is_stated).collect();
    (build_with_loops("family", links, joints, closures, Vec::new()), positions)
}

#[test]
fn datasets_have_the_masses_of_route_c() {
    let (mut counts, mut kinds) = ([0; 3], BTreeMap::new());
    for seed in 0..MECHANISMS {
        let rng = &mut StdRng::seed_from_u64(seed);
        let (mechanism, positions) = mechanism(rng);
        let poses: Vec<Transform<f64>> = maximal::poses(&mechanism, &positions)
            .iter()
            .map(|m| {
                Transform::new(
                    m.fixed_view::<3, 3>(0, 0).into_owned(),
                    m.fixed_view::<3, 1>(0, 3).into_owned(),
                )
            })
            .collect();
        let text = dataset(rng, &mechanism, &poses);
        let loaded = load(&Source::from_text("family.adm", text.as_str()), &LoadOptions::default());
        let loaded = loaded.unwrap_or_else(|error| panic!("{seed}: {error}\n{text}"));
        let system = System::new(loaded.mechanism, &Conditions::new()).expect("a system");
        let pose =
            system.pose(&system.configuration()).unwrap_or_else(|error| panic!("{seed}: {error}\n{text}"));
        for (i, link) in mechanism.links().iter().enumerate().filter(|(i, _)| *i != mechanism.root().index())
        {
            let at = poses[i].point(&vector(rng, 0.4));
            let normal = Unit::new_normalize(vector(rng, 1.0)).into_inner();
            let id = mechanism.find_link(link.name()).expect("a link");
            let question =
                Question::new(&mechanism, positions.clone(), id, poses[i].inverse_point(&at), normal);
            let answer = maximal::solve(&question);
            let least =
                answer.singular_values.iter().copied().filter(|s| *s > answer.threshold).fold(1.0, f64::min);
            if least < LEAST_SINGULAR_VALUE {
                continue;
            }
            let of_dataset = pose.mechanism();
            let own = of_dataset
                .find_link(link.name())
                .or_else(|_| of_dataset.find_link(&format!("part_{}", i + 1)));
            let own = own.unwrap_or_else(|error| panic!("{seed}: {error}\n{text}"));
            let contact = Contact::new(own, pose.link(own).inverse_point(&at), normal);
            let contact = contact.normal(Direction::Along(normal, Frame::World));
            let found = pose.respond(&contact).expect("a response").effective_mass;
            match (found, answer.outcome) {
                (EffectiveMass::Finite(a), Outcome::Finite(b)) => {
                    assert!((a / b - 1.0).abs() < AGREEMENT, "{seed} {}: {a} {b}\n{text}", link.name());
                    counts[0] += 1;
                }
                (EffectiveMass::Immovable, Outcome::Immovable) => counts[1] += 1,
                (EffectiveMass::Massless, Outcome::Massless) => counts[2] += 1,
                (a, b) => panic!("{seed} {}: {a:?} {b:?}\n{text}", link.name()),
            }
        }
        for closure in mechanism.closures() {
            *kinds.entry(closure.kind().name()).or_insert(0) += 1;
        }
    }
    assert!(counts[0] > 1200, "{counts:?}");
    assert!(kinds.len() == 7 && kinds.values().all(|count| *count > 5), "{kinds:?}");
}
