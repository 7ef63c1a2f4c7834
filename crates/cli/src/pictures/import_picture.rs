//! Picture of an import: hardpoints, links and wheels.

use percuss_render::{Drawing, DrawnCircle, DrawnLine, DrawnName};
use percuss_suspension::Understood;

/// Drawing from the front and from the left.
pub fn picture(of: &Understood, source: &str) -> Drawing {
    let line = |line: &percuss_suspension::Line| DrawnLine { ends: line.ends, intensity: None };
    let circle = |wheel: &percuss_suspension::WheelCircle| {
        let (centre, axis) = (wheel.centre, wheel.axis);
        Some(DrawnCircle { centre, axis, radius: wheel.radius?, ..DrawnCircle::default() })
    };
    let mut names: Vec<DrawnName> = Vec::new();
    for line in &of.lines {
        let [a, b] = line.ends;
        let middle = std::array::from_fn(|k| 0.5 * (a[k] + b[k]));
        match names.iter_mut().find(|name| name.text == line.name) {
            Some(name) => name.points.push(middle),
            None => names.push(DrawnName { text: line.name.clone(), points: vec![middle], intensity: None }),
        }
    }
    Drawing {
        names,
        title: format!("{} ({})", of.name, of.template),
        subtitle: source.to_owned(),
        lines: of.lines.iter().map(line).collect(),
        circles: of.wheels.iter().filter_map(circle).collect(),
        ..Drawing::default()
    }
}
