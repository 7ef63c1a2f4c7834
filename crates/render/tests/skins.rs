//! Contents of pictures and files of skins, including skins without facets.

use percuss_render::{Picture, Skin, SkinFacet, SkinMark, SkinPiece};

/// Tetrahedron with a value on three of its four facets.
fn skin() -> Skin {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let normals = [[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.577, 0.577, 0.577]];
    let facet = |i: usize| SkinFacet {
        corners: faces[i].map(|k: usize| corners[k]),
        normal: normals[i],
        value: (i > 0).then_some(i as f64),
        status: u8::from(i == 0),
    };
    let mark = SkinMark { at: [0.34, 0.33, 0.33], label: "largest <3 kg>".into() };
    Skin {
        title: "Tetra & co".into(),
        subtitle: "a test".into(),
        quantity: "mass (kg)".into(),
        without_value: "none".into(),
        property: "mass".into(),
        pieces: vec![SkinPiece { name: "one\ntwo".into(), facets: (0..4).map(facet).collect() }],
        marks: vec![mark],
    }
}

#[test]
fn the_picture_is_well_formed_and_names_what_it_shows() {
    let svg = skin().to_svg();
    let document = roxmltree::Document::parse(&svg).expect("well formed");
    let images = document.descendants().filter(|n| n.tag_name().name() == "image").count();
    assert_eq!(images, 2, "two sides");
    let texts: Vec<&str> =
        document.descendants().filter(|n| n.tag_name().name() == "text").filter_map(|n| n.text()).collect();
    for part in ["Tetra & co", "a test", "mass (kg)", "none", "largest <3 kg>", "1", "3"] {
        assert!(texts.contains(&part), "{part}: {texts:?}");
    }
    let png = skin().to_png(1.0).expect("a picture");
    assert!(png.starts_with(b"\x89PNG"));
    assert_eq!(png, skin().to_png(1.0).expect("a picture"), "the same bytes");
}

#[test]
fn a_ply_has_the_announced_bytes() {
    let mut bytes = Vec::new();
    skin().write_ply(&mut bytes).expect("memory");
    let text = String::from_utf8_lossy(&bytes);
    let header = &text[..text.find("end_header\n").expect("a header")];
    assert!(header.contains("element vertex 12") && header.contains("element face 4"), "{header}");
    assert!(header.contains("comment 4 facets of one two\n"), "{header}");
    assert!(header.contains("property double mass"));
    assert_eq!(bytes.len(), header.len() + 11 + 12 * 35 + 4 * 25);
}

#[test]
fn empty_skins_are_no_error() {
    let odd =
        SkinFacet { corners: [[f64::NAN; 3]; 3], normal: [0.0; 3], value: Some(f64::INFINITY), status: 9 };
    let piece = SkinPiece { name: String::new(), facets: vec![odd] };
    for skin in [Skin::default(), Skin { pieces: vec![piece], ..Skin::default() }] {
        assert!(roxmltree::Document::parse(&skin.to_svg()).is_ok());
        assert!(skin.to_png(0.5).is_ok());
        assert!(skin.to_glb().starts_with(b"glTF"));
        assert!(skin.to_gltf().starts_with('{'));
        skin.write_ply(&mut Vec::new()).expect("memory");
    }
    assert!(skin().to_png(0.0).is_err());
}
