//! Velocities, derivatives, mobility, batches and the closing of loops, in C and in Rust, against the library.

use crate::support::{WARNINGS, folder, inputs, pose, request};
use nalgebra::{Matrix3, SMatrix};
use percuss_dynamics::{Conditions, Configuration, Contact, EffectiveMass, Pose, System};
use percuss_generate::{Additions, Language, generate};
use percuss_mechanism::{JointId, Mechanism};
use percuss_oracle::{linkage, random, zoo};
use rand::SeedableRng;
use rand::rngs::StdRng;
use std::fmt::Write;
use std::process::Command;
use std::sync::Arc;

/// Expected results at a pose.
struct Expected {
    system: System,
    contact: Contact,
    mass: f64,
    velocities: Vec<f64>,
    gradient: Vec<f64>,
    mobility: Vec<f64>,
}

fn mass(pose: &Pose, contact: &Contact) -> f64 {
    match pose.respond(contact).expect("a response").effective_mass {
        EffectiveMass::Finite(m) => m,
        other => panic!("{other:?}"),
    }
}

/// Difference quotient of m̄ along the motion of one joint; `move_joint` returns the pose at a displacement.
fn slope(contact: &Contact, move_joint: impl Fn(f64) -> Pose) -> f64 {
    let h = 1e-4;
    let of = |x: f64| mass(&move_joint(x), contact);
    (8.0 * (of(h) - of(-h)) - (of(2.0 * h) - of(-2.0 * h))) / (12.0 * h)
}

fn expected(system: &System, pose: &Pose, contact: &Contact, drivers: &[usize]) -> Expected {
    let response = pose.respond(contact).expect("a response");
    let located = pose.locate(contact).expect("a contact");
    let phi = pose.inverse_operational_inertia(&located).expect("a mobility");
    // Relative motion of both sides, in the axes of the contact link.
    let phi = phi.matrix();
    let block = |a: usize, b: usize| phi.fixed_view::<6, 6>(6 * a, 6 * b).into_owned();
    let relative = block(0, 0) - block(0, 1) - block(1, 0) + block(1, 1);
    let r: Matrix3<f64> = pose.link(contact.link).rotation;
    let mut turn = SMatrix::<f64, 6, 6>::zeros();
    turn.fixed_view_mut::<3, 3>(0, 0).copy_from(&r);
    turn.fixed_view_mut::<3, 3>(3, 3).copy_from(&r);
    let mobility = turn.transpose() * relative * turn;
    let gradient = drivers
        .iter()
        .map(|&at| {
            slope(contact, |x| {
                let mut q = pose.positions().to_vec();
                q[at] += x;
                let configuration = Configuration::from_positions(system.mechanism(), &q).expect("positions");
                system.pose_from(pose, &configuration).expect("a pose")
            })
        })
        .collect();
    Expected {
        system: system.clone(),
        contact: *contact,
        mass: mass(pose, contact),
        velocities: response.joint_velocities.concat(),
        gradient,
        mobility: mobility.transpose().as_slice().to_vec(),
    }
}

/// Mechanism with a contact, poses, and the positions along which derivatives are taken.
struct Specimen {
    name: String,
    mechanism: Arc<Mechanism>,
    contact: Contact,
    poses: Vec<Pose>,
    system: System,
    varied: Vec<usize>,
    has_loops: bool,
}

/// Trees and linkages.
fn specimens() -> Vec<Specimen> {
    let mut all = Vec::new();
    let mut rng = StdRng::seed_from_u64(41);
    for (name, mechanism) in [("arm", zoo::six_r_arm()), ("gripper", zoo::mimic_gripper())] {
        let mechanism = Arc::new(mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let (link, _, point, normal) = random::contact(&mut rng, &mechanism);
        let poses: Vec<Pose> =
            (0..3).filter_map(|_| pose(&system, &random::positions(&mut rng, &mechanism).concat())).collect();
        let mut at = 0;
        let mut varied = Vec::new();
        for joint in mechanism.joints() {
            if joint.mimic().is_none() && joint.kind().dofs() == 1 {
                varied.push(at);
            }
            at += joint.kind().positions();
        }
        let contact = Contact::new(link, point, normal);
        let name = name.to_owned();
        all.push(Specimen { name, mechanism, contact, poses, system, varied, has_loops: false });
    }
    for one in linkage::all() {
        if !["four_bar", "six_bar", "double_wishbone"].contains(&one.name.replace(['-', ' '], "_").as_str()) {
            continue;
        }
        let positions = one.sweep(3);
        let mechanism = Arc::new(one.mechanism);
        let system = System::new(Arc::clone(&mechanism), &Conditions::new()).expect("a system");
        let (link, _, point, normal) = random::contact(&mut rng, &mechanism);
        let poses: Vec<Pose> = positions.iter().filter_map(|p| pose(&system, &p.concat())).collect();
        let drivers = poses[0].assembly().drivers();
        let positions_before = |id: JointId| {
            let before = mechanism.joint_ids().take_while(|other| *other != id);
            before.map(|j| mechanism.joint(j).kind().positions()).sum::<usize>()
        };
        let varied = drivers.iter().map(|id| positions_before(*id)).collect();
        let name = one.name.replace(['-', ' '], "_");
        let contact = Contact::new(link, point, normal);
        all.push(Specimen { name, mechanism, contact, poses, system, varied, has_loops: true });
    }
    assert_eq!(all.len(), 5);
    all
}

fn numbers(values: &[f64]) -> String {
    values.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ")
}

#[test]
fn additional_functions_in_c() {
    let folder = folder("additions");
    let mut program = String::from("#include <stdio.h>\n");
    let mut main = String::new();
    let mut all_expected = Vec::new();
    for specimen in specimens() {
        let Specimen { name, mechanism, contact, poses, system, varied, has_loops } = specimen;
        let mut request = request(&name, &mechanism, poses[0].clone(), contact);
        let close = has_loops;
        request.additions = Additions { velocity: true, gradient: true, mobility: true, batch: true, close };
        let generated = generate(&request).unwrap_or_else(|error| panic!("{name}: {error}"));
        for file in &generated.files {
            std::fs::write(folder.join(&file.name), &file.text).expect("a file");
        }
        let _ = writeln!(program, "#include \"{name}.c\"");
        let upper = name.to_uppercase();
        for pose in &poses {
            let expected = expected(&system, pose, &contact, &varied);
            let q = inputs(pose);
            let mut near = q.clone();
            if close {
                let given = inputs(pose);
                let driver_values: Vec<f64> = varied.iter().map(|&at| pose.positions()[at]).collect();
                for x in near.iter_mut().filter(|x| !driver_values.contains(x)) {
                    *x += 0.02;
                }
                assert!(near != given);
                normalise_quaternions(&mechanism, &mut near);
            }
            let n = q.len();
            let _ = write!(
                main,
                "    {{\n        const double q[] = {{{}}};\n        double near[] = {{{}}};\n        double m, v[{upper}_VELOCITIES], \
                 d[{upper}_DERIVATIVES], phi[36], columns[{n}*5], masses[5];\n        int i;\n        printf(\"%d\", {name}_velocity(q, \
                 &m, v));\n        for (i = 0; i < {upper}_VELOCITIES; ++i) printf(\" %.17g\", v[i]);\n        printf(\"\\n%d\", \
                 {name}_gradient(q, &m, d));\n        for (i = 0; i < {upper}_DERIVATIVES; ++i) printf(\" %.17g\", d[i]);\n        \
                 printf(\"\\n%d\", {name}_mobility(q, phi));\n        for (i = 0; i < 36; ++i) printf(\" %.17g\", phi[i]);\n        for \
                 (i = 0; i < {n}*5; ++i) columns[i] = q[i/5];\n        columns[1] = 1e9;\n        printf(\"\\n%d\", \
                 (int){name}_batch(5, columns, 5, masses));\n        for (i = 0; i < 5; ++i) printf(\" %.17g\", masses[i]);\n",
                numbers(&q),
                numbers(&near),
            );
            if close {
                // An input that a loop depends on.
                let loop_input = varied[0];
                let _ = write!(
                    main,
                    "        {{\n            double residual;\n            const int closing = {name}_close(near, \
                     &residual);\n            printf(\"\\n%d %.17g\", closing, residual);\n            for (i = 0; i < {n}; ++i) printf(\" %.17g\", near[i]);\n            \
                     printf(\"\\n%d\", {name}_mass(near, &m));\n            printf(\" %.17g\", m);\n            \
                     near[{loop_input}] += 0.1;\n            printf(\"\\n%d\\n\", {name}_mass(near, &m));\n        }}\n    }}\n"
                );
            } else {
                main += "        printf(\"\\n\");\n        (void)near;\n    }\n";
            }
            all_expected.push((name.clone(), close, q, expected));
        }
    }
    program += &format!("int main(void)\n{{\n{main}    return 0;\n}}\n");
    std::fs::write(folder.join("all.c"), program).expect("a file");
    let output = Command::new("cc")
        .args(WARNINGS)
        .args(["-O1", "all.c", "-o", "all", "-lm"])
        .current_dir(&folder)
        .output()
        .expect("a C compiler");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(folder.join("all")).output().expect("the program runs");
    let text = String::from_utf8(output.stdout).expect("text");
    let mut lines = text.lines();
    let mut next = || -> (i32, Vec<f64>) {
        let line = lines.next().expect("a line");
        let mut words = line.split(' ');
        let status = words.next().and_then(|w| w.parse().ok()).expect("a status");
        (status, words.map(|w| w.parse().unwrap_or(f64::NAN)).collect())
    };
    for (name, close, q, expected) in all_expected {
        let near = |found: &[f64], expected: &[f64], tolerance: f64, what: &str| {
            assert_eq!(found.len(), expected.len(), "{name} {what}");
            let scale = expected.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            for (a, b) in found.iter().zip(expected) {
                assert!((a - b).abs() <= tolerance * scale, "{name} {what}: {found:?} {expected:?}");
            }
        };
        let (status, v) = next();
        assert_eq!(status, 0, "{name}");
        // Rounding, amplified by the conditions of the elimination and of the loops.
        near(&v, &expected.velocities, 1e-10, "velocities");
        let (status, d) = next();
        assert_eq!(status, 0, "{name}");
        // Truncation h⁴ and rounding ε/h of the difference quotient, relative to m̄.
        let scale = expected.mass.max(expected.gradient.iter().fold(0.0f64, |most, x| most.max(x.abs())));
        // Rods that turn about their own axes add coordinates without a driving joint.
        assert!(d.len() >= expected.gradient.len(), "{name}");
        for b in &expected.gradient {
            let found = d.iter().any(|a| (a - b).abs() <= 1e-7 * scale);
            assert!(found, "{name}: {d:?} {:?}", expected.gradient);
        }
        let (status, phi) = next();
        assert_eq!(status, 0, "{name}");
        near(&phi, &expected.mobility, 1e-10, "mobility");
        let (failed, masses) = next();
        // Position 0 of configuration 1 is out of range, unless m̄ does not depend on it.
        assert!(failed <= 1, "{name}");
        near(&masses[2..], &[expected.mass; 3], 1e-11, "batch");
        if close {
            let (status, closed) = next();
            assert_eq!(status, 0, "{name}");
            assert!(closed[0] < 1e-8, "{name}: residual {}", closed[0]);
            // Joints that the loops do not determine keep their changed positions, near the pose.
            let is_near = closed[1..].iter().zip(&q).all(|(a, b)| (a - b).abs() < 0.05);
            assert!(is_near, "{name}: {closed:?} {q:?}");
            let (status, found) = next();
            assert_eq!(status, 0, "{name}");
            let library = pose(&expected.system, &closed[1..]).expect("a closed pose");
            near(&found, &[mass(&library, &expected.contact)], 1e-9, "mass of closed positions");
            let (status, _) = next();
            assert!(status == 3, "{name}: open loops give {status}");
        }
    }
}

/// Normalises the quaternions of spherical joints among inputs.
fn normalise_quaternions(mechanism: &Mechanism, q: &mut [f64]) {
    let mut at = 0;
    for joint in mechanism.joints().iter().filter(|joint| joint.mimic().is_none()) {
        let positions = joint.kind().positions();
        if joint.kind() == percuss_mechanism::JointKind::Spherical {
            let norm = q[at..at + 4].iter().map(|x| x * x).sum::<f64>().sqrt();
            q[at..at + 4].iter_mut().for_each(|x| *x /= norm);
        }
        at += positions;
    }
}

#[test]
fn rust_code_passes_its_tests() {
    let folder = folder("rust");
    let mut program = String::new();
    for specimen in specimens() {
        let Specimen { name, mechanism, contact, poses, has_loops, .. } = specimen;
        let mut request = request(&name, &mechanism, poses[0].clone(), contact);
        request.language = Language::Rust;
        request.additions =
            Additions { velocity: true, gradient: true, mobility: true, batch: true, close: has_loops };
        let generated = generate(&request).unwrap_or_else(|error| panic!("{name}: {error}"));
        std::fs::write(folder.join(&generated.files[0].name), &generated.files[0].text).expect("a file");
        let _ = writeln!(program, "mod {name};");
    }
    // The code uses nothing of the standard library; its tests do.
    program = format!("#![cfg_attr(not(test), no_std)]\n{program}");
    std::fs::write(folder.join("all.rs"), program).expect("a file");
    let rustc = |arguments: &[&str]| {
        let output = Command::new("rustc")
            .args(["--edition", "2021", "-D", "warnings"])
            .args(arguments)
            .current_dir(&folder)
            .output()
            .expect("a Rust compiler");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    rustc(&["--crate-type", "lib", "all.rs"]);
    rustc(&["--test", "all.rs", "-o", "all"]);
    let output = Command::new(folder.join("all")).output().expect("the tests run");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}
