//! Drawings in two views: positions of the items, and random or invalid input.

use percuss_render::{
    Drawing, DrawnArrow, DrawnCircle, DrawnLine, DrawnSymbol, Picture, SkinMark, SymbolKind, Tornado,
    TornadoBar,
};
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

/// Loads have lengths in proportion to their magnitudes, also those with a label, and point along their vectors.
#[test]
fn loads_are_in_proportion() {
    let load =
        |vector: [f64; 3], label: &str| DrawnArrow { from: [0.0, 0.5, 0.2], vector, label: label.into() };
    let plain = Drawing { arrows: Vec::new(), ..corner() };
    let loaded =
        Drawing { loads: vec![load([0.0, 0.0, 40.0], ""), load([0.0, 30.0, 0.0], "p")], ..plain.clone() };
    // Lines of two points that the loads add, as (dx, dy) on the page.
    let strokes = |drawing: &Drawing| -> Vec<[f64; 2]> {
        let svg = drawing.to_svg();
        let document = Document::parse(&svg).expect("well-formed");
        let paths = document.descendants().filter_map(|n| n.attribute("d"));
        let ends = paths.filter_map(|d| {
            let numbers = d.split(['M', 'L']).filter_map(|p| p.split_once(' '));
            let points: Vec<(f64, f64)> =
                numbers.filter_map(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?))).collect();
            match points[..] {
                [a, b] => Some([b.0 - a.0, b.1 - a.1]),
                _ => None,
            }
        });
        ends.collect()
    };
    let without = strokes(&plain);
    let mut added = strokes(&loaded);
    without.iter().for_each(|old| {
        let at = added.iter().position(|new| new == old).expect("the lines of the drawing without loads");
        added.remove(at);
    });
    // From the front: up and to the right. From the left, the second load points at the reader.
    let [up, right, up_again, towards] = added[..] else { panic!("{added:?}") };
    assert!(up[0].abs() < 0.02 && up[1] < 0.0 && right[1].abs() < 0.02 && right[0] > 0.0, "{added:?}");
    assert!((right[0] / -up[1] - 0.75).abs() < 1e-3, "{added:?}");
    assert!((up_again[1] - up[1]).abs() < 0.02 && towards[0].hypot(towards[1]) < 0.02, "{added:?}");
}

/// Texts of a picture.
fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).expect("well-formed");
    let texts = document.descendants().filter(|n| n.has_tag_name("text")).filter_map(|n| n.text());
    texts.map(str::to_owned).collect()
}

#[test]
fn three_views_have_numbers_and_a_key() {
    let names = ["ball <lower>", "hinge", "spring (spring)"];
    let at = [[0.0, 0.7, 0.2], [0.0, 0.3, 0.2], [0.0, 0.7, 0.2]];
    let points = names.iter().zip(at).map(|(name, at)| SkinMark { at, label: (*name).into() }).collect();
    let kinds = [SymbolKind::Spring, SymbolKind::Damper, SymbolKind::Stop, SymbolKind::Ground];
    let symbols = kinds.map(|kind| DrawnSymbol {
        kind,
        ends: [[0.0, 0.5, 0.2], [0.0, 0.45, 0.6]],
        normal: [0.0, 0.0, 1.0],
    });
    let plain = Drawing { has_top_view: true, points, ..corner() };
    let svg = plain.to_svg();
    let shown = texts(&svg);
    let count = |text: &str| shown.iter().filter(|shown| *shown == text).count();
    for (i, name) in names.iter().enumerate() {
        // In each view and in the key; from the left, the second point is behind the others.
        assert_eq!(count(&(i + 1).to_string()), if i == 1 { 3 } else { 4 }, "{shown:?}");
        assert_eq!(count(name), 1, "{shown:?}");
    }
    assert!(shown.iter().any(|text| text.starts_with("from above")), "{shown:?}");
    // Numbers of different points do not overlap, though two points coincide.
    let document = Document::parse(&svg).expect("well-formed");
    let place = |node: roxmltree::Node| {
        let number = |name: &str| node.attribute(name).and_then(|x| x.parse::<f64>().ok()).expect("a number");
        (number("x"), number("y"))
    };
    let numbers = document.descendants().filter(|n| n.has_tag_name("text"));
    let numbers: Vec<(f64, f64)> =
        numbers.filter(|n| ["1", "2", "3"].contains(&n.text().unwrap_or(""))).map(place).collect();
    for (i, a) in numbers.iter().enumerate() {
        assert!(numbers[..i].iter().all(|b| (a.0 - b.0).hypot(a.1 - b.1) > 8.0), "{numbers:?}");
    }
    // The name is shown under the pointer, at the dot and at the number of each view; coincident points share the dot.
    let titles: Vec<&str> = document
        .descendants()
        .filter(|n| n.has_tag_name("circle"))
        .filter_map(|n| n.first_element_child()?.text())
        .collect();
    // From the left, all three points coincide; from the front and from above, the first and the third.
    for (title, count) in [("1 ball <lower>", 9), ("2 hinge", 6), ("3 spring (spring)", 9)] {
        let shown = titles.iter().filter(|shown| shown.lines().any(|line| line == title)).count();
        assert_eq!(shown, count, "{title}");
    }
    // Every symbol adds lines in the three views.
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
            drawing.circles.push(DrawnCircle { centre: [a, 0.0, b], axis: [b, a, 0.0], radius: b });
            drawing.has_top_view = true;
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
