//! Loops written as SDF joints in `<gazebo>`, compared with the same loops as `<loop>`, with frames computed by the
//! test: equal results, or both files are refused.

use nalgebra::{Rotation3, Vector3};
use percuss_dynamics::{Conditions, Contact, EffectiveMass, System};
use percuss_formats::{LoadOptions, Source, load};
use percuss_spatial::{Transform, rotation_from_rpy};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::fmt::Write;
use std::sync::Arc;

const MECHANISMS: u64 = 200;
/// Relative difference. Both files describe one mechanism; their frames are products of a few rotations in another
/// order.
const AGREEMENT: f64 = 1e-12;
const LINKS_A_SIDE: usize = 4;

fn numbers(values: &[f64]) -> String {
    values.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}

fn triple(rng: &mut StdRng, most: f64) -> [f64; 3] {
    [(); 3].map(|()| rng.random_range(-most..most))
}

/// Roll, pitch and yaw: R = Rz(yaw) Ry(pitch) Rx(roll).
fn rpy(transform: &Transform<f64>) -> [f64; 3] {
    Rotation3::from_matrix_unchecked(transform.rotation).euler_angles().into()
}

/// Two chains of hinges, balls and slides from the ground, and X_wl of each link as drawn.
fn chains(rng: &mut StdRng) -> (String, Vec<(String, Transform<f64>)>) {
    let mut text = String::from("<link name=\"ground\"/>\n");
    let mut drawn = vec![("ground".to_owned(), Transform::identity())];
    for side in ["a", "b"] {
        let (mut parent, mut frame) = ("ground".to_owned(), Transform::identity());
        for number in 0..LINKS_A_SIDE {
            let name = format!("{side}{number}");
            let (xyz, turn, axis) = (triple(rng, 0.6), triple(rng, 1.4), triple(rng, 1.0));
            let kind = ["continuous", "continuous", "prismatic", "spherical"][rng.random_range(0..4)];
            let com = triple(rng, 0.2);
            let mass = rng.random_range(0.2..3.0);
            let moments = [(); 3].map(|()| mass * rng.random_range(0.02..0.03));
            write!(
                text,
                "<link name=\"{name}\"><inertial><origin xyz=\"{}\"/><mass value=\"{mass}\"/><inertia ixx=\"{}\" iyy=\"{}\" \
                 izz=\"{}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n<joint name=\"to_{name}\" type=\"{kind}\">\
                 <origin xyz=\"{}\" rpy=\"{}\"/><parent link=\"{parent}\"/><child link=\"{name}\"/><axis xyz=\"{}\"/></joint>\n",
                numbers(&com),
                moments[0],
                moments[1],
                moments[2],
                numbers(&xyz),
                numbers(&turn),
                numbers(Vector3::from(axis).normalize().as_slice()),
            )
            .unwrap();
            frame = frame * Transform::new(rotation_from_rpy(turn), xyz.into());
            drawn.push((name.clone(), frame));
            parent = name;
        }
    }
    (text, drawn)
}

/// A closing joint in both notations.
fn closing(rng: &mut StdRng, drawn: &[(String, Transform<f64>)]) -> (String, String) {
    let frame_of = |name: &str| drawn.iter().find(|(link, _)| link == name).expect("a link").1;
    let (parent, child) = match rng.random_range(0..3) {
        0 => ("world", "b3"),
        1 => ("a3", "b3"),
        _ => ("b2", "a3"),
    };
    let x_wp = if parent == "world" { Transform::identity() } else { frame_of(parent) };
    let x_wc = frame_of(child);
    // The pose, with or without a frame name.
    let (xyz, turn) = (triple(rng, 0.4), triple(rng, 1.4));
    let (attribute, x_wf) = match rng.random_range(0..6) {
        0 => (String::new(), x_wc),
        1 => (format!(" relative_to=\"{child}\""), x_wc),
        2 => (" relative_to=\"a1\"".to_owned(), frame_of("a1")),
        3 => (" relative_to=\"__model__\"".to_owned(), Transform::identity()),
        4 => (" relative_to=\"to_b1\"".to_owned(), frame_of("b1")),
        _ => (" relative_to=\"\"".to_owned(), x_wc),
    };
    let own = Transform::new(rotation_from_rpy(turn), xyz.into());
    let pose = match rng.random_range(0..4) {
        0 => {
            let degrees = turn.map(f64::to_degrees);
            format!("<pose degrees=\"true\"{attribute}>{} {}</pose>", numbers(&xyz), numbers(&degrees))
        }
        1 => {
            let q = nalgebra::UnitQuaternion::from_matrix(&own.rotation);
            let q = [q.i, q.j, q.k, q.w];
            format!("<pose rotation_format=\"quat_xyzw\"{attribute}>{} {}</pose>", numbers(&xyz), numbers(&q))
        }
        _ => format!("<pose{attribute}>\n  {}\n  {} </pose>", numbers(&xyz), numbers(&turn)),
    };
    let x_wj = x_wf * own;
    // Axes: in a named frame, or SDF's default.
    let mut inside = String::new();
    let mut axis = |rng: &mut StdRng, tag: &str, in_joint: Option<Vector3<f64>>| {
        let in_joint = in_joint.unwrap_or_else(|| Vector3::from(triple(rng, 1.0)).normalize());
        let (attribute, x_wf, extra) = match rng.random_range(0..5) {
            0 => (" expressed_in=\"__model__\"", Transform::identity(), ""),
            1 => (" expressed_in=\"b1\"", frame_of("b1"), ""),
            2 => ("", Transform::identity(), "<use_parent_model_frame>true</use_parent_model_frame>"),
            _ => ("", x_wj, "<use_parent_model_frame>0</use_parent_model_frame>"),
        };
        let given = x_wf.inverse_vector(&x_wj.vector(&in_joint));
        write!(
            inside,
            "<{tag}><xyz{attribute}>{}</xyz>{extra}<limit><lower>-1</lower></limit></{tag}>",
            numbers(given.as_slice())
        )
        .unwrap();
        in_joint
    };
    let (sdf, ours) = [
        ("revolute", "revolute"),
        ("continuous", "revolute"),
        ("prismatic", "prismatic"),
        ("ball", "spherical"),
        ("fixed", "fixed"),
        ("universal", "universal"),
    ][rng.random_range(0..6)];
    let mut axes = String::new();
    match sdf {
        "ball" | "fixed" => {}
        "universal" => {
            let first = axis(rng, "axis", None);
            let second = first.cross(&Vector3::from(triple(rng, 1.0))).normalize();
            axis(rng, "axis2", Some(second));
            axes = format!(
                "<axis xyz=\"{}\"/><axis2 xyz=\"{}\"/>",
                numbers(first.as_slice()),
                numbers(second.as_slice())
            );
        }
        _ if rng.random_bool(0.2) => axes = "<axis xyz=\"0 0 1\"/>".to_owned(),
        _ => axes = format!("<axis xyz=\"{}\"/>", numbers(axis(rng, "axis", None).as_slice())),
    }
    let gazebo = format!(
        "<gazebo><self_collide>true</self_collide><joint name=\"closing\" type=\"{sdf}\">{pose}<parent>{parent}</parent>\
         <child> {child} </child>{inside}</joint></gazebo>"
    );
    let end = |tag: &str, link: &str, frame: Transform<f64>| {
        format!(
            "<{tag} link=\"{link}\"><origin xyz=\"{}\" rpy=\"{}\"/></{tag}>",
            numbers(frame.translation.as_slice()),
            numbers(&rpy(&frame))
        )
    };
    let own = format!(
        "<loop name=\"closing\" type=\"{ours}\">{}{}{axes}</loop>",
        end("predecessor", parent, x_wp.inverse() * x_wj),
        end("successor", child, x_wc.inverse() * x_wj)
    );
    (gazebo, own)
}

/// m̄ of a contact with all joints as drawn, or the error message.
fn answer(text: &str, link: &str, point: [f64; 3], normal: [f64; 3]) -> Result<EffectiveMass, String> {
    let source = Source::from_text("model.urdf", text);
    let loaded = load(&source, &LoadOptions::default()).map_err(|error| error.to_string())?;
    let system = System::new(Arc::new(loaded.mechanism), &Conditions::new()).map_err(|e| e.to_string())?;
    let pose = system.pose(&system.configuration()).map_err(|e| e.to_string())?;
    let contact = Contact::new(system.mechanism().find_link(link).expect("a link"), point, normal);
    let response = pose.respond(&contact).map_err(|e| e.to_string())?;
    Ok(response.effective_mass)
}

#[test]
fn sdf_joints_are_the_loops_that_they_close() {
    let (mut finite, mut worst) = (0, 0.0_f64);
    for seed in 0..MECHANISMS {
        let rng = &mut StdRng::seed_from_u64(seed);
        let (tree, drawn) = chains(rng);
        let (gazebo, own) = closing(rng, &drawn);
        let (point, normal) = (triple(rng, 0.3), triple(rng, 1.0));
        let of = |closing: &str| {
            answer(&format!("<robot name=\"r\">\n{tree}{closing}\n</robot>"), "a3", point, normal)
        };
        match (of(&gazebo), of(&own)) {
            (Ok(EffectiveMass::Finite(a)), Ok(EffectiveMass::Finite(b))) => {
                finite += 1;
                worst = worst.max((a / b - 1.0).abs());
                assert!((a / b - 1.0).abs() < AGREEMENT, "seed {seed}: {a} and {b}\n{gazebo}\n{own}");
            }
            (Ok(a), Ok(b)) => assert_eq!(a, b, "seed {seed}\n{gazebo}\n{own}"),
            (a, b) => assert!(a.is_err() && b.is_err(), "seed {seed}: {a:?} and {b:?}\n{gazebo}\n{own}"),
        }
    }
    println!("{finite} of {MECHANISMS} finite, worst relative difference {worst:.1e}");
    assert!(finite > MECHANISMS * 8 / 10, "{finite} finite");
}
/// A parallelogram with a split coupler. A fixed SDF joint connects its halves, as on Gazebo's page on loops. At the
/// radius r on a crank, m̄ = (2 I_A + m_c l²)/r². With the split left open, m̄ would be 1.707 kg.
#[test]
fn a_split_coupler_is_whole() {
    let body = |name: &str, com: [f64; 3], mass: f64, moments: [f64; 3]| {
        let [xx, yy, zz] = moments;
        format!(
            "<link name=\"{name}\"><inertial><origin xyz=\"{}\"/><mass value=\"{mass}\"/>\
             <inertia ixx=\"{xx}\" iyy=\"{yy}\" izz=\"{zz}\"/></inertial></link>",
            numbers(&com)
        )
    };
    let hinge = |parent: &str, child: &str, at: [f64; 3]| {
        format!(
            "<joint name=\"{parent}_{child}\" type=\"continuous\"><origin xyz=\"{}\"/><parent link=\"{parent}\"/>\
             <child link=\"{child}\"/><axis xyz=\"0 0 1\"/></joint>",
            numbers(&at)
        )
    };
    let (rod, half) = ([0.000_542_4, 4.8e-6, 0.000_542_4], [1.6e-6, 2.08e-5, 2.08e-5]);
    let text = format!(
        "<robot name=\"split\"><link name=\"world\"/>{}{}{}{}{}{}{}{}<gazebo><joint name=\"glue\" type=\"fixed\">\
         <pose>-0.1 -0.01 0 0 0 0</pose><parent>front</parent><child>back</child></joint></gazebo></robot>",
        body("left", [-0.01, -0.15, 0.0], 0.072, rod),
        body("front", [0.05, -0.01, 0.0], 0.024, half),
        body("back", [-0.05, -0.01, 0.0], 0.024, half),
        body("right", [0.01, -0.15, 0.0], 0.072, rod),
        hinge("world", "left", [0.0, 0.0, 0.04]),
        hinge("left", "front", [0.0, -0.3, 0.0]),
        hinge("world", "right", [0.2, 0.0, 0.04]),
        hinge("right", "back", [0.0, -0.3, 0.0]),
    );
    let about_hinge = 0.000_542_4 + 0.072 * (0.15_f64.powi(2) + 0.01_f64.powi(2));
    let expected = (2.0 * about_hinge + 0.048 * 0.3_f64.powi(2)) / 0.05_f64.powi(2);
    let Ok(EffectiveMass::Finite(mass)) = answer(&text, "left", [0.0, -0.05, 0.0], [1.0, 0.0, 0.0]) else {
        panic!("no mass")
    };
    assert!((expected - 3.46368).abs() < 1e-12 && (mass / expected - 1.0).abs() < AGREEMENT, "{mass}");
}
