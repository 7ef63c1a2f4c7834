//! Drawings in two views: positions of the items, and random or invalid input.

use percuss_render::{Drawing, DrawnArrow, DrawnCircle, DrawnLine, SkinMark};
use roxmltree::Document;

fn corner() -> Drawing {
    Drawing {
        title: "Corner <left>".into(),
        shading: "share".into(),
        lines: vec![
            DrawnLine { ends: [[0.0, 0.3, 0.2], [0.0, 0.7, 0.2]], intensity: Some(0.9) },
            DrawnLine { ends: [[-0.2, 0.3, 0.2], [0.2, 0.3, 0.2]], intensity: None },
        ],
        circles: vec![DrawnCircle { centre: [0.0, 0.75, 0.3], axis: [0.0, 1.0, 0.0], radius: 0.3 }],
        arrows: vec![DrawnArrow { from: [0.0, 0.5, 0.2], vector: [0.0, 0.0, 1.0], label: "n".into() }],
        marks: vec![SkinMark { at: [0.0, 0.5, 0.2], label: "contact".into() }],
        ..Drawing::default()
    }
}

#[test]
fn both_views_show_it_at_one_scale() {
    let svg = corner().to_svg();
    let document = Document::parse(&svg).expect("well-formed");
    let texts: Vec<&str> =
        document.descendants().filter(|n| n.has_tag_name("text")).filter_map(|n| n.text()).collect();
    assert_eq!(texts.iter().filter(|t| **t == "contact").count(), 2, "{texts:?}");
    assert!(texts.iter().any(|t| t.starts_with("from the front")) && texts.contains(&"Corner <left>"));
    // The wheel is a line in the front view, as high as its circle in the side view.
    let extents: Vec<(f64, f64)> = document
        .descendants()
        .filter_map(|n| n.attribute("d"))
        .filter(|d| d.matches('L').count() == 64)
        .map(|d| {
            let points = d.split(['M', 'L']).filter_map(|p| p.split_once(' '));
            let points: Vec<(f64, f64)> =
                points.map(|(x, y)| (x.parse().expect("x"), y.parse().expect("y"))).collect();
            let span = |of: fn(&(f64, f64)) -> f64| {
                let values = || points.iter().map(of);
                values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)
            };
            (span(|p| p.0), span(|p| p.1))
        })
        .collect();
    let [front, side] = extents[..] else { panic!("{extents:?}") };
    assert!(front.0 < 0.1 && (side.0 - side.1).abs() < 1.0 && (front.1 - side.1).abs() < 0.1, "{extents:?}");
    assert!(corner().to_png(1.0).is_ok() && corner().to_pdf().is_ok());
}

#[test]
fn random_drawings_are_valid_pictures() {
    let odd = [0.0, f64::NAN, f64::INFINITY, 1e300, -1e-300];
    for a in odd {
        for b in odd {
            let mut drawing = corner();
            drawing.lines.push(DrawnLine { ends: [[a, b, 0.0], [b, a, 1.0]], intensity: Some(a) });
            drawing.circles.push(DrawnCircle { centre: [a, 0.0, b], axis: [b, a, 0.0], radius: b });
            drawing.arrows.push(DrawnArrow { from: [0.0, a, b], vector: [b, a, b], label: String::new() });
            assert!(Document::parse(&drawing.to_svg()).is_ok(), "{a} {b}");
            assert!(drawing.to_png(0.5).is_ok(), "{a} {b}");
        }
    }
    assert!(Document::parse(&Drawing::default().to_svg()).is_ok());
}
