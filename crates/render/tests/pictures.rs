//! Contents of a picture and their positions; equality of the two back ends.

use percuss_render::{Figure, Mark, Panel, Picture, RenderError, Series, Style};
use resvg::tiny_skia::Pixmap;
use roxmltree::Document;

const BLUE: (u8, u8, u8) = (0, 114, 178);
const VERMILION: (u8, u8, u8) = (213, 94, 0);

fn series(name: &str, style: Style, y: impl Fn(f64) -> Option<f64>) -> Series {
    let travel = (-80..=80).map(f64::from);
    Series { name: name.into(), style, points: travel.map(|x| (x, y(x))).collect() }
}

/// Effective mass with a gap from 20 to 40 mm, its estimate, and the motion ratio.
fn sweep() -> Figure {
    let mass = |x: f64| 207.0 - 6e-4 * x * x;
    let gap = move |x: f64| (!(20.0..=40.0).contains(&x)).then(|| mass(x));
    Figure {
        title: "Effective mass at the spring seat".into(),
        subtitle: "arm <lower> & \"upper\"".into(),
        x_label: "Wheel travel (mm)".into(),
        panels: vec![
            Panel {
                y_label: "Effective mass m̄ (kg)".into(),
                series: vec![
                    series("formula", Style::Line, gap),
                    series("estimate", Style::Dashed, move |x| Some(mass(x) - 3.0)),
                ],
                ..Panel::default()
            },
            Panel {
                y_label: "Motion ratio".into(),
                series: vec![series("ratio", Style::Line, |x| Some(2.2 - 1e-3 * x))],
                ..Panel::default()
            },
        ],
        marks: vec![
            Mark { x: 30.0, label: "singular pose".into() },
            Mark { x: 90.0, label: "beyond".into() },
        ],
        ..Figure::default()
    }
}

fn hex(colour: (u8, u8, u8)) -> String {
    format!("#{:02x}{:02x}{:02x}", colour.0, colour.1, colour.2)
}

/// Polylines of the widest path of this colour, which is the curve and not its sample in the legend.
fn curve(svg: &str, colour: (u8, u8, u8)) -> Vec<Vec<(f64, f64)>> {
    let document = Document::parse(svg).expect("well-formed");
    let paths = document.descendants().filter(|n| n.attribute("stroke") == Some(&hex(colour)));
    let data = paths.filter_map(|n| n.attribute("d")).max_by_key(|d| d.len()).expect("a path of this colour");
    let number = |s: &str| s.parse::<f64>().expect("a number");
    let place = |s: &str| s.split_once(' ').map(|(x, y)| (number(x), number(y))).expect("a place");
    data.split('M').skip(1).map(|chain| chain.split('L').map(place).collect()).collect()
}

fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).expect("well-formed");
    let texts = document.descendants().filter(|n| n.has_tag_name("text"));
    texts.filter_map(|n| n.text().map(str::to_owned)).collect()
}

fn pixel(picture: &Pixmap, (x, y): (f64, f64), scale: f64) -> (u8, u8, u8) {
    let colour = picture.pixel((x * scale) as u32, (y * scale) as u32).expect("on the picture");
    (colour.red(), colour.green(), colour.blue())
}

#[test]
fn every_word_and_number_is_on_the_picture() {
    let texts = texts(&sweep().to_svg());
    for expected in [
        "Effective mass at the spring seat",
        "arm <lower> & \"upper\"",
        "Effective mass m̄ (kg)",
        "Motion ratio",
        "Wheel travel (mm)",
        "formula",
        "estimate",
        "singular pose",
        "−80",
        "60",
        "206",
        "2.25",
    ] {
        assert!(texts.iter().any(|t| t == expected), "{expected:?} is not among {texts:?}");
    }
    // A panel of one series needs no legend; a mark beyond the sweep is not drawn.
    assert!(!texts.iter().any(|t| t == "ratio" || t == "beyond"), "{texts:?}");
}

#[test]
fn values_are_where_the_numbers_say() {
    let svg = sweep().to_svg();
    let document = Document::parse(&svg).unwrap();
    let tick = |content: &str, axis: &str| {
        let text = document.descendants().find(|n| n.text() == Some(content) && n.has_tag_name("text"));
        text.unwrap().attribute(axis).unwrap().parse::<f64>().unwrap()
    };
    let estimate = &curve(&svg, VERMILION)[0];
    let (x0, x60) = (tick("0", "x"), tick("60", "x"));
    // The baseline of a label is a fixed distance below its grid line.
    let (y202, y204) = (tick("202", "y"), tick("204", "y"));
    assert!(y204 < y202, "greater is higher");
    let value = |y: f64| 204.0 - 2.0 * (y - (y204 - 4.3)) / (y202 - y204);
    let at = |x: f64| estimate.iter().min_by(|a, b| (a.0 - x).abs().total_cmp(&(b.0 - x).abs())).unwrap();
    assert!((value(at(x0).1) - 204.0).abs() < 0.01);
    assert!((value(at(x60).1) - (204.0 - 6e-4 * 3600.0)).abs() < 0.02);
}

#[test]
fn a_line_breaks_at_a_gap_in_both() {
    let figure = sweep();
    let chains = curve(&figure.to_svg(), BLUE);
    assert_eq!(chains.len(), 2);
    let (end, start) = (*chains[0].last().unwrap(), chains[1][0]);
    assert!(start.0 - end.0 > 100.0, "from 19 to 41 mm");
    let picture = Pixmap::decode_png(&figure.to_png(1.0).unwrap()).unwrap();
    for i in 1..20 {
        let x = end.0 + (start.0 - end.0) * f64::from(i) / 20.0;
        for y in end.1 as u32 - 10..start.1 as u32 + 10 {
            assert_ne!(pixel(&picture, (x, f64::from(y)), 1.0), BLUE, "ink in the gap at {x}, {y}");
        }
    }
}

#[test]
fn the_png_has_its_size_and_its_ink_where_the_svg_has_it() {
    let figure = sweep();
    let svg = figure.to_svg();
    let document = Document::parse(&svg).unwrap();
    let size = |name| document.root_element().attribute(name).unwrap().parse::<f64>().unwrap();
    for scale in [1.0, 2.0, 2.5] {
        let bytes = figure.to_png(scale as f32).unwrap();
        assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
        let picture = Pixmap::decode_png(&bytes).unwrap();
        assert_eq!(f64::from(picture.width()), (size("width") * scale).round());
        assert_eq!(f64::from(picture.height()), (size("height") * scale).round());
        assert_eq!(pixel(&picture, (2.0, 2.0), scale), (255, 255, 255));
        // The first series is drawn on top: every interior point of its polylines has its colour.
        for chain in curve(&svg, BLUE) {
            for &place in &chain[1..chain.len() - 1] {
                let (r, g, b) = pixel(&picture, place, scale);
                let near = |a: u8, b: u8| a.abs_diff(b) < 70;
                assert!(near(r, BLUE.0) && near(g, BLUE.1) && near(b, BLUE.2), "{place:?}: {r} {g} {b}");
            }
        }
        // The title is dark and in the upper left corner.
        let dark = |x, y| pixel(&picture, (f64::from(x), f64::from(y)), scale).0 < 100;
        assert!((20..45).any(|y| (28..300).any(|x| dark(x, y))), "no title");
    }
}

#[test]
fn letters_stand_on_their_baseline() {
    let figure = Figure { title: "LLLL".into(), ..Figure::default() };
    let document = figure.to_svg();
    let baseline = Document::parse(&document).unwrap();
    let title = baseline.descendants().find(|n| n.text() == Some("LLLL") && n.has_tag_name("text")).unwrap();
    let y = title.attribute("y").unwrap().parse::<u32>().unwrap() * 4;
    let picture = Pixmap::decode_png(&figure.to_png(4.0).unwrap()).unwrap();
    let ink = |row: u32| (0..800).filter(|&x| picture.pixel(x, row).unwrap().red() < 128).count();
    // The letter L is wide at the bottom and narrow at the top; capitals are 0.71 em high and the title has 19 units.
    assert!(ink(y - 2) > 3 * ink(y - 45) && ink(y - 45) > 0);
    assert_eq!((ink(y + 2), ink(y - 56)), (0, 0));
}

#[test]
fn a_name_keeps_its_colour_from_panel_to_panel() {
    let mut figure = sweep();
    figure.panels[1].series[0].name = "estimate".into();
    assert!(!figure.to_svg().contains("#009e73"));
    figure.panels[1].series[0].name = "ratio".into();
    assert!(figure.to_svg().contains("#009e73"));
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    let (one, two) = (sweep(), sweep());
    assert_eq!(one.to_svg(), two.to_svg());
    assert_eq!(one.to_png(1.5).unwrap(), two.to_png(1.5).unwrap());
}

#[test]
fn more_points_do_not_make_a_longer_document() {
    let with = |n: u32| {
        let wave = |i: u32| (f64::from(i), Some((f64::from(i) * 0.37).sin()));
        let points = (0..n).map(wave).collect();
        let series = vec![Series { name: "wave".into(), style: Style::Line, points }];
        Figure {
            panels: vec![Panel { y_label: "y".into(), series, ..Panel::default() }],
            ..Figure::default()
        }
        .to_svg()
        .len()
    };
    assert!(with(1_000_000) < 150_000, "{}", with(1_000_000));
    assert!(with(1_000_000) < 2 * with(20_000));
}

#[test]
fn a_scale_that_cannot_be_is_an_error_that_says_so() {
    for scale in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        assert!(matches!(sweep().to_png(scale), Err(RenderError::Scale { .. })));
    }
    let error = sweep().to_png(100.0).unwrap_err();
    let RenderError::TooLarge { max_scale, .. } = error else { panic!("{error}") };
    assert!(sweep().to_png((max_scale * 0.99) as f32).is_ok());
    assert!(error.to_string().contains("take a scale below 7.2"), "{error}");
}

#[test]
fn limits_are_the_ends_of_the_axes_and_cut_what_is_beyond() {
    let mut figure = sweep();
    figure.x_limits = Some((-60.0, 60.0));
    figure.panels[0].y_limits = Some((202.0, 206.0));
    let (svg, texts) = (figure.to_svg(), texts(&figure.to_svg()));
    assert!(texts.iter().any(|t| t == "60") && !texts.iter().any(|t| t == "−80"), "{texts:?}");
    let document = Document::parse(&svg).unwrap();
    let place = |content: &str, axis: &str| {
        let text = document.descendants().find(|n| n.text() == Some(content) && n.has_tag_name("text"));
        text.unwrap().attribute(axis).unwrap().parse::<f64>().unwrap()
    };
    let (left, right) = (place("−60", "x"), place("60", "x"));
    let tolerance = 0.02;
    let (top, bottom) = (place("206", "y") - 4.3, place("202", "y") - 4.3);
    for chain in curve(&svg, VERMILION) {
        for (x, y) in chain {
            assert!(
                x >= left - tolerance && x <= right + tolerance && y >= top - 0.02 && y <= bottom + 0.02,
                "({x}, {y})"
            );
        }
    }
}

#[test]
fn a_pdf_has_its_fonts_and_its_mark() {
    let bytes = sweep().to_pdf().unwrap();
    assert!(bytes.starts_with(b"%PDF-"));
    let has = |word: &[u8]| bytes.windows(word.len()).any(|w| w == word);
    assert!(has(b"Roboto") && has(b"/FontFile") && has(percuss_render::MADE_BY.as_bytes()));
}

/// The hash tables of svg2pdf have a different order in every call.
#[test]
fn a_pdf_has_the_same_bytes_each_time_and_its_table_of_objects_is_right() {
    let first = sweep().to_pdf().unwrap();
    for _ in 0..8 {
        assert!(sweep().to_pdf().unwrap() == first, "two PDFs of one figure differ");
    }
    let text = String::from_utf8_lossy(&first);
    let table = first.windows(6).rposition(|w| w == b"\nxref\n").unwrap() + 6;
    let table = String::from_utf8_lossy(&first[table..]);
    let in_use = table
        .lines()
        .take_while(|line| !line.starts_with("trailer"))
        .filter(|l| l.ends_with("n") || l.ends_with("n "));
    let offsets: Vec<usize> = in_use.map(|line| line[..10].parse().unwrap()).collect();
    assert!(offsets.len() > 8, "{table}");
    for offset in offsets {
        let object = String::from_utf8_lossy(&first[offset..offset + 20]).into_owned();
        assert!(object.contains(" 0 obj"), "{object:?} at {offset}");
    }
    assert_eq!(text.matches("/FontFile2").count(), 2);
}

/// A band is a filled polygon between its edges, under the lines, and never outside the frame.
#[test]
fn a_band_is_filled_between_its_edges() {
    let line =
        Series { name: "m".into(), points: vec![(0.0, Some(1.0)), (2.0, Some(3.0))], ..Series::default() };
    let edges = [(0.0, 0.5), (2.0, 2.0), (2.0, 4.0), (0.0, 1.5)].map(|(x, y)| (x, Some(y)));
    let band = Series { name: "tolerance".into(), style: Style::Band, points: edges.to_vec() };
    let svg = |limits| {
        let panel = Panel {
            y_label: "kg".into(),
            series: vec![line.clone(), band.clone()],
            y_limits: limits,
            ..Panel::default()
        };
        Figure { panels: vec![panel], ..Figure::default() }.to_svg()
    };
    let corners = |svg: &str| -> Vec<(f64, f64)> {
        let path = svg.split("<path d=\"").find(|path| path.contains("Z\" fill=\"#")).expect("an area");
        let path = path.split('Z').next().expect("corners");
        let pairs = path.split(['M', 'L']).filter_map(|pair| pair.split_once(' '));
        pairs.map(|(x, y)| (x.parse().expect("x"), y.parse().expect("y"))).collect()
    };
    let free = svg(None);
    let [a, b, c, d] = corners(&free)[..] else { panic!("{free}") };
    assert!(a.0 == d.0 && b.0 == c.0 && b.0 > a.0, "the edges begin and end at the same x");
    // 1 kg is as high at both ends of the edges.
    assert!(((a.1 - d.1) - 0.5 * (b.1 - c.1)).abs() < 0.02, "{a:?} {b:?} {c:?} {d:?}");
    let (area, curve) = (free.find("Z\" fill"), free.rfind("stroke-width=\"2\""));
    assert!(area < curve, "the line is above the band");
    let clipped = svg(Some((1.0, 2.0)));
    let heights: Vec<f64> = corners(&clipped).iter().map(|corner| corner.1).collect();
    let (top, bottom) = (heights[2], heights[0]);
    assert!(heights.iter().all(|y| (top..=bottom).contains(y)), "{heights:?}");
}
