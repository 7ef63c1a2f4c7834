//! Figure in the style of `percuss sweep` with invented numbers: `cargo run -p percuss-render --example sweep -- FILE.png`.

use percuss_render::{Figure, Mark, Panel, Picture, Series, Style};
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = PathBuf::from(std::env::args_os().nth(1).ok_or("give a file ending in .svg or .png")?);
    let figure = example();
    match path.extension().and_then(|e| e.to_str()) {
        Some("svg") => std::fs::write(path, figure.to_svg())?,
        _ => std::fs::write(path, figure.to_png(2.0)?)?,
    }
    Ok(())
}

fn series(name: &str, style: Style, y: impl Fn(f64) -> Option<f64>) -> Series {
    let travel = (0..=160).map(|i| f64::from(i) - 80.0);
    Series { name: name.into(), style, points: travel.map(|x| (x, y(x))).collect() }
}

fn example() -> Figure {
    let mass = |x: f64| 207.34 - 0.028 * x - 6.1e-4 * x * x + 1.4e-6 * x * x * x;
    let ratio = |x: f64| 2.2148 - 7.2e-4 * x - 4.1e-6 * x * x;
    Figure {
        title: "Effective mass at the spring seat".into(),
        subtitle: "hmmwv_front.urdf · lower arm (0.31, 0.12, 0.02) along the spring · chassis fixed".into(),
        x_label: "Wheel travel (mm)".into(),
        panels: vec![
            Panel {
                y_label: "Effective mass m̄ (kg)".into(),
                series: vec![
                    series("formula (D)", Style::Line, |x| (!(52.0..58.0).contains(&x)).then(|| mass(x))),
                    series("estimate: spindle, upright", Style::Dashed, |x| Some(mass(x) - 2.6 + 0.012 * x)),
                ],
                ..Panel::default()
            },
            Panel {
                y_label: "Motion ratio (–)".into(),
                series: vec![series("ratio", Style::Line, |x| Some(ratio(x)))],
                ..Panel::default()
            },
        ],
        marks: vec![
            Mark { x: 55.0, label: "singular pose".into() },
            Mark { x: 78.0, label: "limit of the lower arm".into() },
        ],
        ..Figure::default()
    }
}
