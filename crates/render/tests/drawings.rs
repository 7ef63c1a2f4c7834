//! Drawings in two views: positions of the items, and random or invalid input.

use percuss_render::{
    Drawing, DrawnArrow, DrawnCircle, DrawnLine, DrawnName, DrawnSymbol, Picture, SkinMark, SymbolKind,
    Tornado, TornadoBar, Views,
};
use roxmltree::Document;

fn corner() -> Drawing {
    Drawing {
        title: "Corner <left>".into(),
        shading: Some(("share".into(), 55.7)),
        lines: vec![
            DrawnLine { ends: [[0.0, 0.3, 0.2], [0.0, 0.7, 0.2]], intensity: Some(0.9) },
            DrawnLine { ends: [[-0.2, 0.3, 0.2], [0.2, 0.3, 0.2]], intensity: None },
        ],
        circles: vec![DrawnCircle {
            centre: [0.0, 0.75, 0.3],
            axis: [0.0, 1.0, 0.0],
            radius: 0.3,
            width: 0.0,
            intensity: None,
        }],
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

/// Straight lines of a picture, in the order of drawing, as ends on the page.
fn strokes(drawing: &Drawing) -> Vec<[(f64, f64); 2]> {
    let svg = drawing.to_svg();
    let document = Document::parse(&svg).expect("well-formed");
    let paths = document.descendants().filter_map(|n| n.attribute("d"));
    let ends = paths.filter_map(|d| {
        let numbers = d.split(['M', 'L']).filter_map(|p| p.split_once(' '));
        let points: Vec<(f64, f64)> =
            numbers.filter_map(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?))).collect();
        <[(f64, f64); 2]>::try_from(points).ok()
    });
    ends.collect()
}

/// Loads have lengths in proportion to their magnitudes, also those with a label, point along their vectors, and stay on the page.
#[test]
fn loads_are_in_proportion_and_inside_the_page() {
    let load =
        |vector: [f64; 3], label: &str| DrawnArrow { from: [0.0, 0.5, 0.2], vector, label: label.into() };
    let plain = Drawing { arrows: Vec::new(), marks: Vec::new(), shading: None, ..corner() };
    let loads = vec![load([0.0, 0.0, 40.0], ""), load([0.0, 30.0, 0.0], "p")];
    let loaded = Drawing { loads, ..plain };
    let all = strokes(&loaded);
    let vertical = |[a, b]: &[(f64, f64); 2]| (a.0 - b.0).abs() < 0.02 && b.1 - a.1 < -70.0;
    let horizontal = |[a, b]: &[(f64, f64); 2]| (a.1 - b.1).abs() < 0.02 && (b.0 - a.0 - 60.0).abs() < 0.1;
    // From the front up and to the right; from the left, the second load points at the reader.
    let up: Vec<_> = all.iter().filter(|line| vertical(line)).collect();
    assert_eq!((up.len(), all.iter().filter(|line| horizontal(line)).count()), (2, 1), "{all:?}");
    assert!(up.iter().all(|[a, b]| (a.1 - b.1 - 80.0).abs() < 0.1), "{up:?}");
    // A load at the upper end of the drawing widens the view.
    let high = DrawnArrow { from: [0.0, 0.5, 0.6], vector: [0.0, 0.0, 1.0], label: "p".into() };
    let drawn = strokes(&Drawing { loads: vec![high], ..loaded });
    assert!(drawn.iter().flatten().all(|(x, y)| (0.0..=900.0).contains(x) && *y > 16.0), "{drawn:?}");
}

/// A planar drawing has one view, and the view beside text is that with the largest area.
#[test]
fn views_that_are_lines_are_left_out() {
    let line = |ends| DrawnLine { ends, intensity: Some(1.0) };
    let planar = Drawing {
        lines: vec![line([[0.0; 3], [0.4, 0.0, 0.3]]), line([[0.4, 0.0, 0.3], [0.6, 0.0, 0.0]])],
        views: Views::Three,
        ..Drawing::default()
    };
    let titles = |drawing: &Drawing| {
        texts(&drawing.to_svg()).into_iter().filter(|t| t.starts_with("from ")).collect::<Vec<_>>()
    };
    assert_eq!(titles(&planar), ["from the left (x to the left, z up)"]);
    // An arm stretched along x with a normal along y is seen from above, where both are in the plane; along z, from the left.
    for (normal, title) in [
        ([0.0, 1.0, 0.0], "from above (y to the right, x down)"),
        ([0.0, 0.0, 1.0], "from the left (x to the left, z up)"),
    ] {
        let arrow = DrawnArrow { from: [0.9, 0.0, 0.0], vector: normal, label: "n".into() };
        for views in [Views::Two, Views::Three, Views::Best] {
            let lines = vec![line([[0.0; 3], [0.5, 0.0, 0.0]]), line([[0.5, 0.0, 0.0], [0.9, 0.0, 0.0]])];
            let stretched = Drawing { lines, arrows: vec![arrow.clone()], views, ..Drawing::default() };
            assert_eq!(titles(&stretched), [title], "{views:?}");
        }
    }
    let half = Drawing { views: Views::Best, ..corner() };
    assert_eq!(titles(&half).len(), 1);
    assert!(half.to_svg().contains("width=\"360\""));
}

/// Texts of a picture.
fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).expect("well-formed");
    let texts = document.descendants().filter(|n| n.has_tag_name("text")).filter_map(|n| n.text());
    texts.map(str::to_owned).collect()
}

#[test]
fn three_views_have_names_beside_their_parts() {
    let names = ["ball <lower>", "arm 56 %", "spring"];
    let at = [[0.0, 0.7, 0.2], [0.0, 0.4, 0.2], [0.1, 0.6, 0.5]];
    let named = names.iter().zip(at).map(|(name, at)| DrawnName {
        text: (*name).into(),
        points: vec![at],
        intensity: Some(0.5),
    });
    let points =
        vec![SkinMark { at: at[0], label: "ball".into() }, SkinMark { at: at[0], label: "pin".into() }];
    let kinds = [SymbolKind::Spring, SymbolKind::Damper, SymbolKind::Stop, SymbolKind::Ground];
    let symbols = kinds.map(|kind| DrawnSymbol {
        kind,
        ends: [[0.0, 0.5, 0.2], [0.0, 0.45, 0.6]],
        normal: [0.0, 0.0, 1.0],
    });
    let plain = Drawing { views: Views::Three, points, names: named.collect(), ..corner() };
    let svg = plain.to_svg();
    let shown = texts(&svg);
    for name in names {
        assert_eq!(shown.iter().filter(|text| *text == name).count(), 3, "{name} in {shown:?}");
    }
    // The scale of the shading has its largest value.
    assert!(
        shown.iter().any(|text| text == "56 %") && shown.iter().any(|text| text == "share: 0"),
        "{shown:?}"
    );
    // Names do not overlap.
    let document = Document::parse(&svg).expect("well-formed");
    let place = |node: roxmltree::Node| {
        let number = |name: &str| node.attribute(name).and_then(|x| x.parse::<f64>().ok()).expect("a number");
        (number("x"), number("y"))
    };
    let places: Vec<(f64, f64)> = document
        .descendants()
        .filter(|n| n.has_tag_name("text") && names.contains(&n.text().unwrap_or("")))
        .map(place)
        .collect();
    for (i, a) in places.iter().enumerate() {
        let is_apart = |b: &(f64, f64)| (a.0 - b.0).abs() > 40.0 || (a.1 - b.1).abs() > 12.0;
        assert!(places[..i].iter().all(is_apart), "{places:?}");
    }
    // Coincident points share the names under the pointer.
    let titles = document.descendants().filter(|n| n.has_tag_name("circle"));
    let titles: Vec<&str> = titles.filter_map(|n| n.first_element_child()?.text()).collect();
    assert!(titles.len() == 6 && titles.iter().all(|title| *title == "ball\npin"), "{titles:?}");
    // Every symbol adds lines in the three views.
    let plain = Drawing { names: Vec::new(), ..plain };
    let svg = plain.to_svg();
    for symbol in symbols {
        let with = Drawing { symbols: vec![symbol], ..plain.clone() }.to_svg();
        assert!(with.matches("<path").count() >= svg.matches("<path").count() + 2, "{:?}", symbol.kind);
    }
    assert!(plain.to_png(1.0).is_ok() && plain.to_pdf().is_ok());
}

#[test]
fn a_tornado_has_a_bar_to_both_sides_for_each_number() {
    let bar =
        |name: &str, effect: f64| TornadoBar { name: name.into(), effect, value: format!("± {effect}") };
    let mut chart = Tornado {
        title: "Effects".into(),
        directions: ["more".into(), "less".into()],
        bars: vec![bar("a & b", 2.0), bar("c", -1.0)],
        ..Tornado::default()
    };
    let svg = chart.to_svg();
    let shown = texts(&svg);
    for text in ["Effects", "more", "less", "a & b", "c", "± 2", "± -1", "−2", "2"] {
        assert!(shown.iter().any(|shown| shown == text), "{text} in {shown:?}");
    }
    for odd in [f64::NAN, f64::INFINITY, 1e300, 1e-320, 0.0] {
        chart.bars.push(bar("odd", odd));
        assert!(Document::parse(&chart.to_svg()).is_ok() && chart.to_png(0.5).is_ok(), "{odd}");
    }
    assert!(Document::parse(&Tornado::default().to_svg()).is_ok());
}

#[test]
fn random_drawings_are_valid_pictures() {
    let odd = [0.0, f64::NAN, f64::INFINITY, 1e300, -1e-300];
    for a in odd {
        for b in odd {
            let mut drawing = corner();
            drawing.lines.push(DrawnLine { ends: [[a, b, 0.0], [b, a, 1.0]], intensity: Some(a) });
            drawing.circles.push(DrawnCircle {
                centre: [a, 0.0, b],
                axis: [b, a, 0.0],
                radius: b,
                width: a,
                intensity: Some(b),
            });
            drawing.views = Views::Three;
            drawing.points.push(SkinMark { at: [a, b, 0.0], label: "odd".into() });
            for kind in [SymbolKind::Spring, SymbolKind::Stop] {
                let ends = [[a, b, 0.0], [0.0, a, b]];
                drawing.symbols.push(DrawnSymbol { kind, ends, normal: [b, a, 0.0] });
            }
            drawing.arrows.push(DrawnArrow { from: [0.0, a, b], vector: [b, a, b], label: String::new() });
            assert!(Document::parse(&drawing.to_svg()).is_ok(), "{a} {b}");
            assert!(drawing.to_png(0.5).is_ok(), "{a} {b}");
        }
    }
    assert!(Document::parse(&Drawing::default().to_svg()).is_ok());
}
