//! Figures without data, with too few data or with invalid data are drawn without an error.

use percuss_render::{Figure, Mark, Panel, Picture, Series, Style};
use rand::rngs::StdRng;
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use roxmltree::Document;

const STYLES: [Style; 3] = [Style::Line, Style::Dashed, Style::Dots];

fn one_series(style: Style, points: Vec<(f64, Option<f64>)>) -> Figure {
    let series = vec![Series { name: "s".into(), style, points }];
    Figure { panels: vec![Panel { y_label: "y".into(), series, ..Panel::default() }], ..Figure::default() }
}

/// Asserts that the SVG of a figure is well-formed and that every coordinate is on the page. Returns its texts.
fn check_svg(figure: &Figure) -> Vec<String> {
    let svg = figure.to_svg();
    let document = Document::parse(&svg).unwrap_or_else(|e| panic!("{e}: {svg}"));
    let root = document.root_element();
    let number = |s: &str| s.parse::<f64>().unwrap_or_else(|_| panic!("{s:?} is no number"));
    let size = ["width", "height"].map(|name| number(root.attribute(name).unwrap()));
    let inside = |x: f64, y: f64| (0.0..=size[0]).contains(&x) && (0.0..=size[1]).contains(&y);
    for node in root.descendants().filter(|n| n.is_element()) {
        if let (Some(x), Some(y)) = (node.attribute("x"), node.attribute("y")) {
            assert!(inside(number(x), number(y)), "{node:?} is off the page");
        }
        for coordinates in node.attribute("d").unwrap_or_default().split(['M', 'L']).filter(|s| !s.is_empty())
        {
            let (x, y) = coordinates.trim_end_matches("h0").split_once(' ').expect("two numbers");
            assert!(inside(number(x), number(y)), "{coordinates} is off the page");
        }
    }
    let texts = root.descendants().filter(|n| n.has_tag_name("text"));
    texts.map(|n| n.text().unwrap_or_default().to_owned()).collect()
}

/// Number of paths in a colour of the palette: curves and dots.
fn count_blue_paths(figure: &Figure) -> usize {
    figure.to_svg().matches("#0072b2").count()
}

#[test]
fn empty_figures_have_a_note() {
    assert_eq!(check_svg(&Figure::default()), ["nothing to draw"]);
    assert!(Figure::default().to_png(1.0).is_ok());
    let no_series = Figure { panels: vec![Panel::default()], ..Figure::default() };
    let gaps = one_series(Style::Line, vec![(0.0, None), (1.0, None), (2.0, Some(f64::NAN))]);
    for figure in [no_series, one_series(Style::Dots, Vec::new()), gaps] {
        assert!(check_svg(&figure).contains(&"no value to draw".into()));
        assert_eq!(count_blue_paths(&figure), 0);
        assert!(figure.to_png(1.0).is_ok());
    }
}

#[test]
fn one_point_is_a_dot_between_ticks() {
    for style in STYLES {
        let figure = one_series(style, vec![(3.0, Some(12.5))]);
        let texts = check_svg(&figure);
        assert!(texts.contains(&"3.00".into()) && texts.contains(&"12.5".into()), "{texts:?}");
        assert_eq!(count_blue_paths(&figure), 1);
    }
}

#[test]
fn equal_values_are_a_level_line_in_the_middle() {
    for value in [0.0, 207.342, -1e-12, 1e300, -1e300] {
        let figure = one_series(Style::Line, vec![(0.0, Some(value)), (1.0, Some(value))]);
        check_svg(&figure);
        assert_eq!(count_blue_paths(&figure), 1, "{value:e}");
    }
    // One x with several y.
    check_svg(&one_series(Style::Line, vec![(5.0, Some(1.0)), (5.0, Some(2.0))]));
}

#[test]
fn points_without_a_value_extend_the_x_axis() {
    let points = vec![(-80.0, None), (0.0, Some(1.0)), (10.0, Some(2.0)), (80.0, None)];
    let texts = check_svg(&one_series(Style::Line, points));
    assert!(texts.contains(&"−80".into()) && texts.contains(&"80".into()), "{texts:?}");
}

#[test]
fn marks_alone_make_a_range() {
    let marks = vec![Mark { x: -80.0, label: "rebound".into() }, Mark { x: 80.0, label: "bump".into() }];
    let texts = check_svg(&Figure { panels: vec![Panel::default()], marks, ..Figure::default() });
    assert!(texts.contains(&"rebound".into()) && texts.contains(&"bump".into()), "{texts:?}");
}

fn random_number(random: &mut StdRng) -> f64 {
    const ODD: [f64; 12] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -0.0,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        5e-324,
        1e300,
        -1e300,
        f64::EPSILON,
    ];
    match random.random_range(0..4) {
        0 => *ODD.choose(random).expect("not empty"),
        1 => f64::from_bits(random.random()),
        2 => 207.0 + 1e-9 * random.random::<f64>(),
        _ => random.random_range(-100.0..100.0),
    }
}

fn random_words(random: &mut StdRng) -> String {
    const ODD: [char; 16] = [
        '<', '&', '"', '\'', '>', '\0', '\n', '\u{304}', 'm', '質', '\u{FFFF}', '🚗', '\u{202E}', ' ', ']',
        'ﷺ',
    ];
    let length = *[0, 1, 5, 30, 400].choose(random).expect("not empty");
    let character = |random: &mut StdRng| match random.random_bool(0.5) {
        true => *ODD.choose(random).expect("not empty"),
        false => random.random(),
    };
    (0..length).map(|_| character(random)).collect()
}

fn random_figure(random: &mut StdRng) -> Figure {
    let points = |random: &mut StdRng| {
        let length = *[0, 1, 2, 3, 50, 3000].choose(random).expect("not empty");
        let sane = random.random_bool(0.5);
        let number =
            |random: &mut StdRng| if sane { random.random_range(-1.0..1.0) } else { random_number(random) };
        (0..length).map(|_| (number(random), random.random_bool(0.8).then(|| number(random)))).collect()
    };
    let series = |random: &mut StdRng| Series {
        name: random_words(random),
        style: *STYLES.choose(random).expect("not empty"),
        points: points(random),
    };
    let limits =
        |random: &mut StdRng| random.random_bool(0.3).then(|| (random_number(random), random_number(random)));
    let panel = |random: &mut StdRng| Panel {
        y_limits: limits(random),
        y_label: random_words(random),
        series: (0..random.random_range(0..5)).map(|_| series(random)).collect(),
        values: vec![percuss_render::LabelledPoint {
            x: random_number(random),
            y: random_number(random),
            spread: Some(random_number(random)),
            label: "v".into(),
        }],
    };
    let mark = |random: &mut StdRng| Mark { x: random_number(random), label: random_words(random) };
    Figure {
        title: random_words(random),
        x_limits: limits(random),
        subtitle: random_words(random),
        x_label: random_words(random),
        panels: (0..random.random_range(0..4)).map(|_| panel(random)).collect(),
        marks: (0..random.random_range(0..6)).map(|_| mark(random)).collect(),
        is_logarithmic: false,
        is_half: random.random(),
    }
}

#[test]
fn whatever_is_in_it_a_figure_is_drawn() {
    let mut random = StdRng::seed_from_u64(0x9e_7c05);
    for i in 0..400 {
        let figure = random_figure(&mut random);
        check_svg(&figure);
        if i % 8 == 0 {
            figure.to_png(0.5).unwrap_or_else(|e| panic!("{e}: {figure:?}"));
        }
        if i % 80 == 0 {
            figure.to_pdf().unwrap_or_else(|e| panic!("{e}: {figure:?}"));
        }
    }
}
