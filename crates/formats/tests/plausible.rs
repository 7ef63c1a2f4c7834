//! Inertias that are impossible for the size of the link are found; inertias of real models are accepted.

use crate::support::{load_text, told};
use percuss_formats::{LoadOptions, MeshFolders, Source, inertias_beyond_meshes, load};
use percuss_mechanism::{Accept, Severity};
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::path::Path;

const CODE: &str = "implausible-inertia";

/// Arm of length 0.5 m with a tip link; mass and inertia are about the midpoint.
fn arm(mass: f64, moments: [f64; 3]) -> String {
    let [xx, yy, zz] = moments;
    format!(
        "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"><inertial><origin xyz=\"0.25 0 0\"/><mass value=\"{mass:e}\"/>\n\
         <inertia ixx=\"{xx:e}\" iyy=\"{yy:e}\" izz=\"{zz:e}\"/></inertial></link><link name=\"tip\"/>\
         <joint name=\"hinge\" type=\"continuous\"><parent link=\"base\"/><child link=\"arm\"/><axis xyz=\"0 0 1\"/></joint>\
         <joint name=\"fixed\" type=\"fixed\"><origin xyz=\"0.5 0 0\"/><parent link=\"arm\"/><child link=\"tip\"/></joint></robot>"
    )
}

/// Severity of the finding about the arm.
fn found(mass: f64, moments: [f64; 3]) -> Option<Severity> {
    let loaded = load_text(&arm(mass, moments));
    told(&loaded).iter().find(|d| d.code == CODE).map(|d| d.severity)
}

/// Box of random size and density: mass and moments.
fn solid(rng: &mut StdRng) -> (f64, [f64; 3]) {
    let [a, b, c] = [0.5, rng.random_range(0.02..0.2), rng.random_range(0.02..0.2)];
    let mass = a * b * c * rng.random_range(300.0..8000.0);
    let moment = |p: f64, q: f64| mass / 12.0 * (p * p + q * q);
    (mass, [moment(b, c), moment(a, c), moment(a, b)])
}

#[test]
fn wrong_units_are_found_and_right_ones_are_not() {
    let rng = &mut StdRng::seed_from_u64(4);
    let (mut dense, arms) = (0, 500);
    for _ in 0..arms {
        let (mass, moments) = solid(rng);
        assert_eq!(found(mass, moments), None, "{mass} {moments:?}");
        // kg·mm² read as kg·m².
        assert_eq!(found(mass, moments.map(|x| x * 1e6)), Some(Severity::Error), "{mass} {moments:?}");
        // Mass in grams with an inertia in kg·m², then mass in grams with an inertia in g·m².
        assert_eq!(found(mass * 1e3, moments), Some(Severity::Warning), "{mass} {moments:?}");
        dense += usize::from(found(mass * 1e3, moments.map(|x| x * 1e3)).is_some());
        // Inertia without mass.
        assert_eq!(found(0.0, moments), Some(Severity::Warning), "{moments:?}");
        // Point mass.
        assert_eq!(found(mass, [0.0; 3]), None);
    }
    // By the radius of gyration, a slender wooden arm in grams has the density of a compact metal arm.
    println!("{dense} of {arms} arms in grams and g·m² are found");
    assert!(dense > arms / 2, "{dense}");
}

#[test]
fn the_message_names_the_element_the_numbers_and_the_remedy() {
    let text = arm(2.0, [1.0, 41_667.0, 41_667.0]);
    let error = load_text(&text).expect_err("far out");
    let [found] = &error.diagnostics.iter().filter(|d| d.code == CODE).collect::<Vec<_>>()[..] else {
        panic!("{error}")
    };
    assert_eq!(found.line, Some(2));
    for part in ["2.0000e0 kg", "1.4434e2 m", "kg·mm²", "--accept implausible-inertia"] {
        assert!(found.message.contains(part), "{}", found.message);
    }
    let options = LoadOptions {
        accept: Accept { implausible_inertia: true, ..Accept::default() },
        ..LoadOptions::default()
    };
    let accepted = load(&Source::from_text("arm.urdf", text), &options).expect("accepted");
    assert!(accepted.diagnostics.iter().any(|d| d.code == CODE && d.severity == Severity::Warning));
}

/// The rotor of a gear may have an inertia without a mass.
#[test]
fn rotors_of_couplings_need_no_mass() {
    let text = arm(2.0, [0.01, 0.05, 0.05]).replace(
        "</robot>",
        "<link name=\"rotor\"><inertial><mass value=\"0\"/><inertia ixx=\"1e-4\" iyy=\"1e-4\" izz=\"1e-4\"/></inertial></link>\
         <joint name=\"spin\" type=\"continuous\"><parent link=\"base\"/><child link=\"rotor\"/><axis xyz=\"0 0 1\"/></joint>\
         <coupling name=\"gear\"><predecessor link=\"arm\"/><successor link=\"rotor\"/><ratio value=\"6\"/></coupling></robot>",
    );
    let coupled = load_text(&text);
    assert!(coupled.is_ok() && told(&coupled).iter().all(|d| d.code != CODE), "{:?}", told(&coupled));
    let (before, rest) = text.split_once("<coupling").unwrap();
    let (_, after) = rest.split_once("</coupling>").unwrap();
    let free = load_text(&format!("{before}{after}"));
    assert!(told(&free).iter().any(|d| d.code == CODE), "{:?}", told(&free));
}

#[test]
fn shipped_models_are_plausible() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("models").flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|ending| ending != "urdf") {
            continue;
        }
        let name = path.to_string_lossy().into_owned();
        let loaded =
            load(&Source::read(&name, percuss_formats::DEFAULT_MAX_SIZE).unwrap(), &LoadOptions::default());
        assert!(told(&loaded).iter().all(|d| d.code != CODE), "{name}: {:?}", told(&loaded));
        count += 1;
    }
    assert!(count > 15, "{count}");
}

/// Wheel with collision shapes on a hinge, and a link that gives the mechanism its size.
fn wheel(shapes: &str, com: [f64; 3], mass: f64, moments: [f64; 3]) -> String {
    let [x, y, z] = com;
    let [xx, yy, zz] = moments;
    arm(2.0, [0.001, 0.05, 0.05]).replace(
        "</robot>",
        &format!(
            "<link name=\"wheel\"><inertial><origin xyz=\"{x:e} {y:e} {z:e}\"/><mass value=\"{mass:e}\"/>\n\
             <inertia ixx=\"{xx:e}\" iyy=\"{yy:e}\" izz=\"{zz:e}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>{shapes}</link>\
             <joint name=\"w\" type=\"continuous\"><parent link=\"tip\"/><child link=\"wheel\"/></joint></robot>"
        ),
    )
}

/// Point masses at random points of the shapes are never implausible; the same inertia, enlarged beyond m·max |x − c|², always is.
#[test]
fn inertias_are_compared_with_the_shapes_of_the_link() {
    let rng = &mut StdRng::seed_from_u64(11);
    for case in 0..200 {
        let [a, b, c] = [0; 3].map(|_| rng.random_range(0.02..0.3));
        let at: [f64; 3] = [0; 3].map(|_| rng.random_range(-0.2..0.2));
        let [u, v, w] = [0; 3].map(|_| rng.random_range(-1.0..1.0));
        let (solid, point) = match case % 3 {
            0 => (format!("<box size=\"{a} {b} {c}\"/>"), [u * a / 2.0, v * b / 2.0, w * c / 2.0]),
            1 => (
                format!("<cylinder radius=\"{a}\" length=\"{b}\"/>"),
                [u * a * 0.7, v * a * 0.7, w * b / 2.0],
            ),
            _ => (format!("<sphere radius=\"{a}\"/>"), [u * a * 0.57, v * a * 0.57, w * a * 0.57]),
        };
        let shape = |tag: &str, solid: &str| {
            format!(
                "<{tag}><origin xyz=\"{} {} {}\"/><geometry>{solid}</geometry></{tag}>",
                at[0], at[1], at[2]
            )
        };
        // Two equal masses at the point and its mirror image about the centre of the shape.
        let mass = rng.random_range(0.1..10.0);
        let square = |i: usize, j: usize| mass * (point[i] * point[i] + point[j] * point[j]);
        let moments = [square(1, 2), square(0, 2), square(0, 1)];
        let warned = |text: String| {
            let loaded = load_text(&text);
            assert!(loaded.is_ok(), "{text}: {:?}", told(&loaded));
            told(&loaded).iter().any(|d| d.code == CODE && d.message.contains("shapes"))
        };
        let tags = ["collision", "visual"];
        for tag in tags {
            assert!(!warned(wheel(&shape(tag, &solid), at, mass, moments)), "{solid} {moments:?}");
            let noise = at.map(|x| x + 1e-9);
            assert!(!warned(wheel(&shape(tag, &solid), noise, mass, moments)), "{solid} {moments:?}");
            let farthest = a.max(b).max(c).powi(2);
            let large = [2.5 * mass * farthest; 3];
            assert!(warned(wheel(&shape(tag, &solid), at, mass, large)), "{solid} {large:?}");
            let outside = [at[0] + 2.0 * a.max(b).max(c), at[1], at[2]];
            assert!(warned(wheel(&shape(tag, &solid), outside, mass, moments)), "{solid} {outside:?}");
        }
        // Collision shapes count before visual ones, and a mesh has an unknown size.
        let sphere = shape("collision", "<sphere radius=\"9\"/>") + &shape("visual", &solid);
        assert!(!warned(wheel(&sphere, at, mass, [a * a * mass; 3])));
        let mesh = shape("collision", "<mesh filename=\"x.stl\"/>") + &shape("visual", &solid);
        assert!(!warned(wheel(&mesh, at, mass, [3.0 * a * a * mass; 3])));
    }
}

/// Meshes are compared by their bounding box where a caller opens them, geoms of MJCF by the hull of all.
#[test]
fn inertias_are_compared_with_meshes_and_geoms() {
    let rng = &mut StdRng::seed_from_u64(12);
    let folder = std::env::temp_dir().join(format!("percuss-plausible-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    // A tetrahedron with the bounding box −1 … 1.
    let corners = ["1 1 1", "1 -1 -1", "-1 1 -1", "-1 -1 1"].map(|corner| format!("v {corner}\n")).concat();
    std::fs::write(folder.join("t.obj"), corners + "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n").expect("written");
    let folders = MeshFolders { model: folder.clone(), ..MeshFolders::default() };
    for _ in 0..50 {
        let half: [f64; 3] = [0; 3].map(|_| rng.random_range(0.02..0.3));
        let at: [f64; 3] = [0; 3].map(|_| rng.random_range(-0.2..0.2));
        let [u, v, w] = half.map(|x| x * x);
        let (mass, [x, y, z], [a, b, c]) = (rng.random_range(0.1..10.0), at, half);
        // Two masses at opposite corners of the box, and an inertia of twice the radius.
        let corner = [v + w, u + w, u + v].map(|square| mass * square);
        let far = corner.map(|moment| 2.5 * moment);
        let beside = [x + 2.5 * a, y + 2.5 * b, z + 2.5 * c];
        for (com, moments, expected) in [(at, corner, 0), (at, far, 1), (beside, corner, 1)] {
            let mesh = format!(
                "<collision><origin xyz=\"{x} {y} {z}\"/><geometry><mesh filename=\"t.obj\" scale=\"{a} {b} {c}\"/></geometry></collision>"
            );
            let urdf = load_text(&wheel(&mesh, com, mass, moments)).expect("a model");
            assert!(urdf.diagnostics.iter().all(|d| !d.message.contains("shapes")), "meshes are not opened");
            let found = |size| inertias_beyond_meshes(&urdf.mechanism, &urdf.shapes, &folders, size).len();
            assert_eq!((found(1 << 20), found(50)), (expected, 0), "{half:?} {com:?} {moments:?}");
            let [xx, yy, zz] = moments;
            let mjcf = |geoms: &str| {
                let text = format!(
                    "<mujoco><worldbody><body><joint/><inertial pos=\"{} {} {}\" mass=\"{mass}\" diaginertia=\"{xx} {yy} {zz}\"/>\
                     <geom type=\"box\" pos=\"{x} {y} {z}\" size=\"{a} {b} {c}\"/>{geoms}</body></worldbody></mujoco>",
                    com[0], com[1], com[2]
                );
                told(&load_text(&text)).iter().filter(|d| d.message.contains("shapes")).count()
            };
            assert_eq!(mjcf(""), expected, "{half:?} {com:?} {moments:?}");
            assert_eq!(mjcf("<geom type=\"sphere\" size=\"3\" contype=\"0\" conaffinity=\"0\"/>"), 0);
            assert_eq!(
                mjcf("<geom type=\"ellipsoid\" size=\".1 .1 .1\"/>"),
                0,
                "no counterpart among the shapes"
            );
        }
    }
    std::fs::remove_dir_all(&folder).expect("removed");
}

/// A centre of mass alone is no size of a link: it may be rounding.
#[test]
fn a_centre_of_mass_is_no_size() {
    for off in [0.0, 1e-9, 1e-6, 1e-3, 0.01] {
        let text = format!(
            "<robot name=\"w\"><link name=\"base\"/><link name=\"wheel\"><inertial><origin xyz=\"{off} 0 0\"/><mass value=\"5\"/>\
             <inertia ixx=\"0.05\" iyy=\"0.08\" izz=\"0.05\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\
             <joint name=\"h\" type=\"continuous\"><parent link=\"base\"/><child link=\"wheel\"/><axis xyz=\"0 1 0\"/></joint></robot>"
        );
        let loaded = load_text(&text);
        assert!(loaded.is_ok() && told(&loaded).iter().all(|d| d.code != CODE), "{off}: {:?}", told(&loaded));
    }
}

/// Chain of links with the given lengths and masses, 0 for none, at `com` (m) in each link.
fn chain(lengths: &[f64], masses: &[f64], com: f64) -> String {
    let mut text = "<robot name=\"c\"><link name=\"l0\"/>".to_owned();
    for (i, (length, mass)) in lengths.iter().zip(masses).enumerate() {
        let inertial = format!(
            "<inertial><origin xyz=\"{com} 0 0\"/><mass value=\"{mass}\"/><inertia ixx=\"0.01\" iyy=\"0.01\" izz=\"0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>"
        );
        let inertial = if *mass > 0.0 { inertial } else { String::new() };
        let child = i + 1;
        text += &format!(
            "<link name=\"l{child}\">{inertial}</link><joint name=\"j{child}\" type=\"continuous\"><parent link=\"l{i}\"/>\
             <child link=\"l{child}\"/><origin xyz=\"{length} 0 0\"/><axis xyz=\"0 0 1\"/></joint>"
        );
    }
    text + "</robot>"
}

#[test]
fn absent_masses_and_placeholders_are_named() {
    let warned = |lengths: &[f64], masses: &[f64], com: f64| {
        let loaded = load_text(&chain(lengths, masses, com));
        told(&loaded).iter().filter(|d| d.severity == Severity::Warning).map(|d| d.code).collect::<Vec<_>>()
    };
    let (lengths, equal) = ([0.1, 0.4, 0.3, 0.5, 0.2, 0.3], [0.2; 6]);
    assert_eq!(warned(&lengths, &[0.0; 6], 0.1), ["no-moving-mass"]);
    assert_eq!(warned(&lengths, &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0], 0.1), [""; 0]);
    assert_eq!(warned(&lengths, &[2.0; 6], 0.1), ["equal-inertias"]);
    assert_eq!(warned(&lengths, &[2.0, 2.0, 2.0, 2.0, 2.0, 0.3], 0.1), ["equal-inertias"]);
    assert_eq!(warned(&lengths, &[6.0, 5.0, 4.0, 3.0, 2.0, 1.0], 0.1), [""; 0]);
    assert_eq!(warned(&equal, &[2.0; 6], 0.1), [""; 0], "a chain of equal links");
    assert_eq!(warned(&equal, &[2.0; 6], 0.0), ["equal-inertias"], "balls at the joints of long links");
    assert_eq!(warned(&lengths[..3], &[2.0; 3], 0.1), [""; 0], "few links");
}
