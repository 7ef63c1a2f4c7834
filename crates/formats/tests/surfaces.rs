//! Surfaces of links: areas, volumes and normals compared with closed forms; valid and invalid mesh files.

use nalgebra::Vector3;
use percuss_formats::{
    Facet, FileSystem, LoadOptions, MeshError, MeshFolders, Purpose, Shape, Solid, Source, Surface, load,
    read_mesh,
};
use percuss_spatial::{Transform, rotation_from_rpy};
use std::f64::consts::PI;
use std::fs;
use std::path::PathBuf;

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("percuss-surfaces-{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn shape(solid: Solid) -> Shape {
    let frame = Transform::new(rotation_from_rpy([0.3, -0.7, 1.1]), Vector3::new(0.2, -0.1, 0.4));
    Shape { purpose: Purpose::Collision, solid, frame }
}

fn facets(shape: &Shape, edge: f64) -> Vec<Facet> {
    let surface = Surface::read([shape], &MeshFolders::default(), 1 << 20).expect("no mesh");
    surface.facets(edge, 1 << 22).expect("not too many")
}

/// Area, ∮ n dA, and the volume ∮ p·n dA / 3 by the divergence theorem.
fn sums(facets: &[Facet]) -> (f64, Vector3<f64>, f64) {
    facets.iter().fold((0.0, Vector3::zeros(), 0.0), |(area, normal, volume), f| {
        (area + f.area, normal + f.normal * f.area, volume + f.point.dot(&f.normal) * f.area / 3.0)
    })
}

#[test]
fn primitives_have_their_area_and_volume() {
    let (r, l) = (0.13, 0.5);
    let cases = [
        (Solid::Box { size: [0.3, 0.2, 0.1] }, 0.22, 0.006, 1e-12),
        (Solid::Sphere { radius: r }, 4.0 * PI * r * r, 4.0 / 3.0 * PI * r.powi(3), 2e-3),
        (Solid::Cylinder { radius: r, length: l }, 2.0 * PI * r * l + 2.0 * PI * r * r, PI * r * r * l, 2e-3),
        (
            Solid::Capsule { radius: r, length: l },
            2.0 * PI * r * l + 4.0 * PI * r * r,
            PI * r * r * l + 4.0 / 3.0 * PI * r.powi(3),
            2e-3,
        ),
    ];
    for (solid, area, volume, slack) in cases {
        let shape = shape(solid);
        let facets = facets(&shape, 0.01);
        let (own_area, normal, own_volume) = sums(&facets);
        // Facets are flat: the relative error of the area is of the order of (edge/radius)², about 1e-2 / 8.
        assert!((own_area / area - 1.0).abs() < slack, "{shape:?}: {own_area} {area}");
        assert!((own_volume / volume - 1.0).abs() < slack, "{shape:?}: {own_volume} {volume}");
        assert!(normal.norm() < 1e-9, "{shape:?}: {normal}");
        for f in &facets {
            assert!((f.normal.norm() - 1.0).abs() < 1e-12);
            let [a, b, c] = f.corners;
            assert!((b - a).cross(&(c - a)).dot(&f.normal) > 0.0, "wound the other way: {f:?}");
            let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
            assert!(longest < 0.01 * 1.5, "{longest}");
        }
    }
}

#[test]
fn points_lie_on_the_round_itself() {
    let radius = 0.2;
    let shape = shape(Solid::Sphere { radius });
    for f in facets(&shape, 0.05) {
        let from_centre = f.point - shape.frame.translation;
        assert!((from_centre.norm() - radius).abs() < 1e-12);
        assert!((f.normal - from_centre / radius).norm() < 1e-12);
    }
}

/// Triangles of a box of 0.3 × 0.2 × 0.1 m.
fn box_triangles() -> Vec<[[f64; 3]; 3]> {
    let shape = Shape {
        purpose: Purpose::Visual,
        solid: Solid::Box { size: [0.3, 0.2, 0.1] },
        frame: Transform::identity(),
    };
    facets(&shape, 1.0).iter().map(|f| f.corners.map(Into::into)).collect()
}

fn ascii_stl(triangles: &[[[f64; 3]; 3]]) -> String {
    let mut text = String::from("solid box\n");
    for t in triangles {
        text += "facet normal 0 0 0\nouter loop\n";
        t.iter().for_each(|[x, y, z]| text += &format!("vertex {x} {y} {z}\n"));
        text += "endloop\nendfacet\n";
    }
    text + "endsolid box\n"
}

fn binary_stl(triangles: &[[[f64; 3]; 3]]) -> Vec<u8> {
    let mut bytes = b"solid, says a binary file too".to_vec();
    bytes.resize(80, b' ');
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for t in triangles {
        bytes.extend([0; 12]);
        t.iter().flatten().for_each(|x| bytes.extend((*x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn obj(triangles: &[[[f64; 3]; 3]]) -> String {
    let mut text = String::from("mtllib none.mtl\no box\n");
    for t in triangles {
        t.iter().for_each(|[x, y, z]| text += &format!("v {x} {y} {z}\n"));
        text += "f -3 -2 -1\n";
    }
    text
}

fn dae(triangles: &[[[f64; 3]; 3]]) -> String {
    let numbers: Vec<String> = triangles.iter().flatten().flatten().map(|x| (x * 1e3).to_string()).collect();
    let p: Vec<String> = (0..3 * triangles.len()).map(|i| format!("{i} 0")).collect();
    format!(
        r##"<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit name="millimeter" meter="0.001"/>
<up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="s"><float_array id="a" count="{}">{}</float_array>
<technique_common><accessor source="#a" count="{}" stride="3"/></technique_common></source><vertices id="v"><input semantic="POSITION"
source="#s"/></vertices><triangles count="{}"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="NORMAL" source="#s"
offset="1"/><p>{}</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="vs"><node>
<translate>10 0 0</translate><rotate>0 0 1 90</rotate><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#vs"/></scene></COLLADA>"##,
        numbers.len(),
        numbers.join(" "),
        numbers.len() / 3,
        triangles.len(),
        p.join(" ")
    )
}

#[test]
fn every_format_gives_the_same_box() {
    let folder = folder("formats");
    let triangles = box_triangles();
    let files: [(&str, Vec<u8>); 4] = [
        ("ascii.stl", ascii_stl(&triangles).into_bytes()),
        ("binary.STL", binary_stl(&triangles)),
        ("box.obj", obj(&triangles).into_bytes()),
        ("box.dae", dae(&triangles).into_bytes()),
    ];
    for (name, bytes) in files {
        fs::write(folder.join(name), bytes).expect("written");
        let folders = MeshFolders::of_model(&folder.join("robot.urdf"), Vec::new());
        let shape = Shape {
            solid: Solid::Mesh { file: name.into(), scale: [2.0, 1.0, -1.0] },
            ..shape(Solid::Sphere { radius: 1.0 })
        };
        let surface = Surface::read([&shape], &folders, 1 << 20).unwrap_or_else(|e| panic!("{name}: {e}"));
        let (area, normal, volume) = sums(&surface.facets(0.02, 1 << 20).expect("not too many"));
        // The COLLADA node rotates x into y before the scale is applied.
        let [x, y, z] = if name == "box.dae" { [0.4, 0.3, 0.1] } else { [0.6, 0.2, 0.1] };
        let expected = 2.0 * (x * y + y * z + z * x);
        // Positions in STL have 24 bits.
        assert!((area / expected - 1.0).abs() < 1e-6, "{name}: {area} {expected}");
        assert!(
            (volume / (x * y * z) - 1.0).abs() < 1e-6,
            "{name}: {volume}, a mirrored mesh is turned outward"
        );
        assert!(normal.norm() < 1e-6, "{name}");
        let done = surface.orientation();
        assert_eq!((done.pieces, done.turned, done.open), (1, 12, 0), "{name}");
    }
    let moved = read_mesh(&FileSystem, &folder.join("box.dae"), 1 << 20).expect("good");
    let low = moved.iter().flatten().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    assert!((low - (0.01 - 0.1)).abs() < 1e-12, "the node's transform and the unit: {low}");
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn bad_meshes_are_refused_with_what_is_wrong() {
    let folder = folder("bad");
    let triangles = box_triangles();
    let mut cut = binary_stl(&triangles);
    cut.truncate(300);
    let mut endless = binary_stl(&triangles);
    endless[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let deep = format!("<COLLADA>{}{}</COLLADA>", "<a>".repeat(100_000), "</a>".repeat(100_000));
    let looped = r##"<COLLADA><library_visual_scenes><visual_scene id="v"><node id="n"><instance_node url="#n"/></node>
        </visual_scene></library_visual_scenes></COLLADA>"##;
    // Each node contains the next one twice: 2^60 nodes.
    let nodes: String = (0..60)
        .map(|i| {
            format!(
                r##"<node id="n{i}"><instance_node url="#n{0}"/><instance_node url="#n{0}"/></node>"##,
                i + 1
            )
        })
        .collect();
    let bomb = format!(
        r##"<COLLADA><library_nodes>{nodes}<node id="n60"/></library_nodes><library_visual_scenes><visual_scene id="v"><node>
        <instance_node url="#n0"/></node></visual_scene></library_visual_scenes></COLLADA>"##
    );
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("cut.stl", cut, "announces 12 triangles"),
        ("endless.stl", endless, "announces 4294967295 triangles"),
        ("empty.stl", Vec::new(), "0 bytes are no STL"),
        ("words.stl", b"solid x\nfacet normal a b c\n".to_vec(), "facet 1"),
        ("none.stl", b"solid x\nendsolid x\n".to_vec(), "no triangle"),
        ("nan.obj", b"v 0 0 0\nv 1 0 0\nv 0 NaN 0\nf 1 2 3\n".to_vec(), "finite"),
        ("far.obj", b"v 0 0 0\nf 1 2 3\n".to_vec(), ""),
        ("none.obj", b"v 0 0 0\n".to_vec(), "no triangle"),
        ("no.dae", b"<html/>".to_vec(), "<COLLADA> is expected"),
        ("broken.dae", b"<COLLADA>".to_vec(), "no XML"),
        ("deep.dae", deep.into_bytes(), "nest"),
        ("looped.dae", looped.as_bytes().to_vec(), "nested too deep"),
        ("bomb.dae", bomb.into_bytes(), "too many"),
        ("index.dae", dae(&triangles).replace("<p>0 0", "<p>99 0").into_bytes(), "names vertex 99"),
        ("number.dae", dae(&triangles).replace("<p>0 0", "<p>x 0").into_bytes(), "no index"),
        ("missing.dae", dae(&triangles).replace(r##"url="#g""##, r##"url="#h""##).into_bytes(), "refers to"),
        ("mesh.glb", b"glTF".to_vec(), "expected STL, OBJ, COLLADA or MSH"),
    ];
    for (name, bytes, what) in cases {
        let path = folder.join(name);
        fs::write(&path, bytes).expect("written");
        let error = read_mesh(&FileSystem, &path, 1 << 22).expect_err(name).to_string();
        assert!(error.contains(what) && error.contains(name), "{name}: {error}");
    }
    fs::write(folder.join("big.stl"), vec![b' '; 5000]).expect("written");
    assert!(matches!(read_mesh(&FileSystem, &folder.join("big.stl"), 4999), Err(MeshError::TooLarge { .. })));
    assert!(matches!(read_mesh(&FileSystem, &folder.join("none"), 10), Err(MeshError::Unreadable { .. })));
    fs::remove_dir_all(folder).expect("removed");
}

/// A file truncated anywhere, or with any byte changed, is read or refused without a panic.
#[test]
fn damaged_meshes_are_read_or_refused() {
    let folder = folder("damaged");
    let triangles = box_triangles();
    let files = [
        ("a.stl", ascii_stl(&triangles).into_bytes()),
        ("b.stl", binary_stl(&triangles)),
        ("c.obj", obj(&triangles).into_bytes()),
        ("d.dae", dae(&triangles).into_bytes()),
    ];
    let mut refused = 0;
    for (name, bytes) in files {
        for k in 0..60 {
            let mut damaged = bytes.clone();
            let at = k * bytes.len() / 60;
            if k % 2 == 0 {
                damaged.truncate(at)
            } else {
                damaged[at] ^= 0x15
            }
            fs::write(folder.join(name), damaged).expect("written");
            refused += usize::from(read_mesh(&FileSystem, &folder.join(name), 1 << 20).is_err());
        }
    }
    assert!(refused > 50, "{refused} refused");
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn packages_are_found_as_their_users_expect() {
    let folder = folder("packages");
    let put = |path: &str| {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        fs::write(&path, "").expect("written");
        fs::canonicalize(path).expect("there")
    };
    let above = put("ws/my_robot/meshes/a.stl");
    let beside = put("ws/other/meshes/b.stl");
    let given = put("elsewhere/meshes/c.stl");
    let plain = put("ws/my_robot/urdf/d.stl");
    let held = put("share/held/e.stl");
    put("ws/my_robot/urdf/robot.urdf");
    let mut folders = MeshFolders::of_model(
        &folder.join("ws/my_robot/urdf/robot.urdf"),
        vec![("given".into(), folder.join("elsewhere"))],
    );
    folders.holders.push(folder.join("share"));
    let find = |file: &str| folders.find(file).map(|p| fs::canonicalize(p).expect("there"));
    assert_eq!(find("package://my_robot/meshes/a.stl"), Ok(above.clone()));
    assert_eq!(find("package://other/meshes/b.stl"), Ok(beside));
    assert_eq!(find("package://given/meshes/c.stl"), Ok(given));
    assert_eq!(find("package://held/e.stl"), Ok(held));
    assert_eq!(find("d.stl"), Ok(plain));
    assert_eq!(find("../meshes/a.stl"), Ok(above.clone()));
    assert_eq!(find(&format!("file://{}", above.display())), Ok(above.clone()));
    assert_eq!(find(&above.display().to_string()), Ok(above));
    let error = find("package://nowhere/x.stl").expect_err("missing").to_string();
    assert!(error.contains("--package NAME=FOLDER") && error.contains("nowhere/x.stl"), "{error}");
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn shapes_of_a_urdf_are_kept() {
    let text = r#"<robot name="r"><link name="a">
        <visual><origin xyz="1 2 3" rpy="0 0 1.5"/><geometry><mesh filename=" m.stl " scale="0.001 0.001 0.001"/></geometry></visual>
        <collision><geometry><box size="1 2 3"/></geometry></collision>
        <collision><geometry><sphere radius="x"/></geometry></collision></link><link name="b"/>
        <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>"#;
    let loaded =
        load(&Source::from_text("r.urdf", text), &LoadOptions::default()).expect("good but for a shape");
    let [a, b] = &loaded.shapes[..] else { panic!("two links") };
    assert!(b.is_empty());
    assert_eq!(a.len(), 2, "the sphere without a radius is left out, with the reader's warning");
    assert_eq!((a[0].purpose, &a[0].solid), (Purpose::Collision, &Solid::Box { size: [1.0, 2.0, 3.0] }));
    assert_eq!(a[1].solid, Solid::Mesh { file: "m.stl".into(), scale: [0.001; 3] });
    assert_eq!(a[1].frame.translation, Vector3::new(1.0, 2.0, 3.0));
    assert!(loaded.diagnostics.iter().any(|d| d.code == "bad-shape"));
}

#[test]
fn too_many_facets_are_refused() {
    let shape = shape(Solid::Box { size: [1.0; 3] });
    let surface = Surface::read([&shape], &MeshFolders::default(), 0).expect("no mesh");
    let error = surface.facets(1e-9, 1000).expect_err("too many").to_string();
    assert!(error.contains("at most 1000"), "{error}");
    assert!(surface.facets(1e-300, usize::MAX - 1).is_err());
    assert_eq!(Surface::read([], &MeshFolders::default(), 0).expect("nothing").bounds(), None);
}
