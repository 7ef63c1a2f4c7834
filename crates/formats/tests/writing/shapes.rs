//! Shapes that are written and read back are equal.

use crate::support::load_text;
use approx::assert_relative_eq;
use percuss_formats::{
    Change, LoadOptions, Loaded, MeshFile, ModelParts, Purpose, Shape, Solid, Source, load, write_mjcf,
    write_sdf, write_urdf_model,
};
use percuss_spatial::{Transform, Vector3, rotation_from_rpy};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// An immovable link, a moving link, a massless link fixed to it, a massless link between two hinges, and a moving link.
const ARM: &str = r#"<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="mount"/>
  <link name="wrist"/>
  <link name="hand"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/></joint>
  <joint name="flange" type="fixed"><origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/><parent link="upper"/><child link="mount"/></joint>
  <joint name="turn" type="continuous"><origin xyz="1 0 0"/><parent link="upper"/><child link="wrist"/><axis xyz="1 0 0"/></joint>
  <joint name="tilt" type="continuous"><parent link="wrist"/><child link="hand"/><axis xyz="0 1 0"/></joint>
</robot>"#;

/// Random shapes in the order of the readers: collisions, then visuals.
fn random_shapes(random: &mut StdRng, count: usize) -> Vec<Shape> {
    let mut shapes: Vec<Shape> = (0..count)
        .map(|_| {
            let mut size = || random.random_range(0.01..0.5);
            let [a, b, c] = [size(), size(), size()];
            let solid = match random.random_range(0..5) {
                0 => Solid::Box { size: [a, b, c] },
                1 => Solid::Sphere { radius: a },
                2 => Solid::Cylinder { radius: a, length: b },
                3 => Solid::Capsule { radius: a, length: b },
                _ => {
                    let file = format!("meshes/part{}.stl", random.random_range(0..3));
                    Solid::Mesh { file, scale: if random.random() { [1.0; 3] } else { [a, b, c] } }
                }
            };
            let mut at = || random.random_range(-1.0..1.0);
            let frame = Transform::new(rotation_from_rpy([at(), at(), at()]), Vector3::new(at(), at(), at()));
            let purpose = if random.random() { Purpose::Collision } else { Purpose::Visual };
            let frame = if random.random_range(0..4) == 0 { Transform::identity() } else { frame };
            Shape { purpose, solid, frame }
        })
        .collect();
    shapes.sort_by_key(|shape| shape.purpose);
    shapes
}

/// Names of mesh files relative to the folder `written`.
fn from_other_folder(name: &str) -> Result<MeshFile, String> {
    Ok(MeshFile { name: format!("../{name}"), path: None })
}

fn reread(name: &str, text: &str) -> Loaded {
    load(&Source::from_text(name, text), &LoadOptions::default())
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Asserts that shapes are equal. `in_link`: pose of the link of `before` in the link of the file that contains `after` (X_fl).
fn assert_same(before: &[Shape], in_link: &Transform<f64>, after: &[Shape]) {
    assert_eq!(before.len(), after.len());
    for (one, two) in before.iter().zip(after) {
        assert_eq!(one.purpose, two.purpose);
        match (&one.solid, &two.solid) {
            (Solid::Mesh { file, scale }, Solid::Mesh { file: other, scale: other_scale }) => {
                assert_eq!(&format!("../{file}"), other);
                assert_eq!(scale, other_scale);
            }
            // MJCF has half lengths; halving is exact.
            (one, two) => assert_eq!(one, two),
        }
        // Rounding of the conversion to quaternions or angles, and of the product of two frames.
        let frame = *in_link * one.frame;
        assert_relative_eq!(frame.translation, two.frame.translation, epsilon = 4e-16);
        assert_relative_eq!(frame.rotation, two.frame.rotation, epsilon = 2e-15);
    }
}

fn lost(changes: &[Change]) -> Vec<String> {
    let of_shapes = changes.iter().filter(|change| change.what.starts_with("a shape"));
    of_shapes.map(|change| format!("{}: {}", change.element, change.reason)).collect()
}

#[test]
fn shapes_are_written_and_read_back() {
    let mut random = StdRng::seed_from_u64(30);
    let mechanism = load_text(ARM).unwrap().mechanism;
    let flange = *mechanism.joint(mechanism.find_joint("flange").unwrap()).origin();
    let identity = Transform::identity();
    for _ in 0..100 {
        let counts = [0; 5].map(|_| random.random_range(0..4));
        let shapes = counts.map(|count| random_shapes(&mut random, count));
        let [base, upper, mount, wrist, hand] = &shapes;
        let parts =
            ModelParts { shapes: &shapes, find_mesh: &from_other_folder, ..ModelParts::from(&mechanism) };

        let urdf = write_urdf_model(parts, "");
        assert!(urdf.changes.is_empty());
        let after = reread("written/arm.urdf", &urdf.text).shapes;
        for (before, after) in shapes.iter().zip(&after) {
            assert_same(before, &identity, after);
        }

        let mjcf = write_mjcf(parts, "").unwrap();
        // The massless link between two hinges has no body.
        assert_eq!(
            lost(&mjcf.changes),
            vec![
                "link \"wrist\": its link is massless and merged into the body of another link";
                wrist.len()
            ]
        );
        let loaded = reread("written/arm.xml", &mjcf.text);
        let after = |link: &str| &loaded.shapes[loaded.mechanism.find_link(link).unwrap().index()];
        for (link, before) in [("base", base), ("upper", upper), ("mount", mount), ("hand", hand)] {
            assert_same(before, &identity, after(link));
        }
        for (link, other) in mechanism.links().iter().zip(loaded.mechanism.links().iter().skip(1)) {
            // The shapes add no mass.
            assert!(link.inertial().is_none_or(|own| Some(own) == other.inertial()));
        }

        let sdf = write_sdf(parts, "").unwrap();
        assert_eq!(
            lost(&sdf.changes),
            vec!["link \"wrist\": its link is massless and merged into a joint"; wrist.len()]
        );
        let loaded = reread("written/arm.sdf", &sdf.text);
        let after = |link: &str| &loaded.shapes[loaded.mechanism.find_link(link).unwrap().index()];
        for (link, before) in [("base", base), ("hand", hand)] {
            assert_same(before, &identity, after(link));
        }
        // `mount` is a frame of `upper`: for each purpose, its shapes follow those of `upper`.
        let both = after("upper");
        for purpose in [Purpose::Collision, Purpose::Visual] {
            let of = |shapes: &[Shape]| -> Vec<Shape> {
                shapes.iter().filter(|shape| shape.purpose == purpose).cloned().collect()
            };
            let (found, own) = (of(both), of(upper));
            let (first, rest) = found.split_at(own.len());
            assert_same(&own, &identity, first);
            assert_same(&of(mount), &flange, rest);
        }
    }
}

#[test]
fn bodies_that_are_joined_do_not_touch() {
    let mechanism = load_text(ARM).unwrap().mechanism;
    let ball =
        |purpose| Shape { purpose, solid: Solid::Sphere { radius: 1.0 }, frame: Transform::identity() };
    let shapes = vec![vec![ball(Purpose::Collision)]; 5];
    let parts = ModelParts { shapes: &shapes, ..ModelParts::from(&mechanism) };
    let written = write_mjcf(parts, "").unwrap();
    let text = written.text;
    // MuJoCo excludes contact of parent and child, unless the parent is fixed to the world. `mount` is fixed to `upper`.
    assert_eq!(text.matches("<exclude").count(), 2, "{text}");
    for other in ["upper", "mount"] {
        assert!(text.contains(&format!("<exclude body1=\"base\" body2=\"{other}\"/>")));
    }
    assert_eq!(written.changes.iter().filter(|change| change.what.contains("do not touch")).count(), 2);
    // Shapes of the world are obstacles, also for a body that hangs on it.
    let on_world = load_text(&ARM.replace("\"base\"", "\"world\"")).unwrap().mechanism;
    let parts = ModelParts { shapes: &shapes, ..ModelParts::from(&on_world) };
    assert!(!write_mjcf(parts, "").unwrap().text.contains("<exclude"));
    let shapes = vec![vec![ball(Purpose::Visual)]; 5];
    let parts = ModelParts { shapes: &shapes, ..ModelParts::from(&mechanism) };
    assert!(!write_mjcf(parts, "").unwrap().text.contains("<exclude"));
}

#[test]
fn shapes_without_a_form_are_lost_with_a_reason() {
    let mechanism = load_text(ARM).unwrap().mechanism;
    let shape = |solid| Shape { purpose: Purpose::Visual, solid, frame: Transform::identity() };
    let shapes = vec![vec![
        shape(Solid::Box { size: [1.0, 0.0, 1.0] }),
        shape(Solid::Mesh { file: "gone.stl".to_owned(), scale: [1.0; 3] }),
        shape(Solid::Mesh { file: "part.dae".to_owned(), scale: [1.0; 3] }),
    ]];
    let find_mesh = |name: &str| match name {
        "gone.stl" => Err("gone.stl: the file was not found".to_owned()),
        name => Ok(MeshFile { name: name.to_owned(), path: Some(name.into()) }),
    };
    let parts = ModelParts { shapes: &shapes, find_mesh: &find_mesh, ..ModelParts::from(&mechanism) };
    assert_eq!(
        lost(&write_mjcf(parts, "").unwrap().changes),
        [
            "link \"base\": MuJoCo refuses a dimension or a scale factor of 0",
            "link \"base\": gone.stl: the file was not found",
            "link \"base\": part.dae: MuJoCo reads only STL, OBJ and MSH; convert the mesh"
        ]
    );
    assert_eq!(
        lost(&write_sdf(parts, "").unwrap().changes),
        [
            "link \"base\": SDFormat allows no dimension or scale factor of 0",
            "link \"base\": gone.stl: the file was not found"
        ]
    );
}

#[test]
fn valid_names_stay_in_sdf() {
    let text = ARM.replace("\"upper\"", "\"a::b\"").replace("\"hand\"", "\"a_b\"");
    let mechanism = load_text(&text).unwrap().mechanism;
    let written = write_sdf(&mechanism, "").unwrap();
    let links = reread("arm.sdf", &written.text).mechanism;
    // Only the invalid name changes, and gets a number.
    assert!(links.find_link("a_b").is_ok() && links.find_link("a_b_2").is_ok());
    let changes: Vec<String> =
        written.changes.iter().map(|change| format!("{} {}", change.element, change.what)).collect();
    assert!(changes.contains(&"link \"a::b\" its name is \"a_b_2\"".to_owned()), "{changes:?}");
}
