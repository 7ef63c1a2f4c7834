//! Pairs of links that mark a loop, as onshape-to-robot writes them.

use crate::support::{codes, told};
use percuss_formats::{LoadError, LoadOptions, Loaded, Source, load};
use percuss_mechanism::{ClosureKind, Severity};
use percuss_spatial::Vector3;

const INERTIAL: &str = "<inertial><mass value=\"1\"/><inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";

/// Two bars whose ends coincide in (1, 0, 0), with links at the ends, and further elements. `axes`: links on the axis of the mate.
fn two_bars(axes: bool, more: &str, options: LoadOptions) -> Result<Loaded, LoadError> {
    let fixed = |link: &str, parent: &str, origin: &str| {
        format!(
            "<link name=\"{link}\"/><joint name=\"{link}_frame\" type=\"fixed\">{origin}<parent link=\"{parent}\"/><child link=\"{link}\"/></joint>"
        )
    };
    let mut text = format!("<robot name=\"r\"><link name=\"base\"/>{more}");
    for (bar, at) in [("1", "0 0 0"), ("2", "2 0 0")] {
        text += &format!(
            "<link name=\"bar{bar}\">{INERTIAL}</link><joint name=\"hinge{bar}\" type=\"continuous\"><origin xyz=\"{at}\"/>
             <parent link=\"base\"/><child link=\"bar{bar}\"/><axis xyz=\"0 1 0\"/></joint>"
        );
        let end = if bar == "1" { "1 0 0" } else { "-1 0 0" };
        // The frames of the ends are turned: their z-axes are along y.
        let origin = format!(
            "<origin xyz=\"{end}\" rpy=\"-1.5707963267948966 0 {}\"/>",
            if bar == "1" { 0.0 } else { 0.3 }
        );
        text += &fixed(&format!("closing_pin_{bar}"), &format!("bar{bar}"), &origin);
        if axes {
            let tip = if bar == "1" { "0 0 0.1" } else { "0.029552020666133956 0 0.0955336489125606" };
            text += &fixed(
                &format!("closing_pin_{bar}_z"),
                &format!("closing_pin_{bar}"),
                &format!("<origin xyz=\"{tip}\"/>"),
            );
        }
    }
    load(&Source::from_text("r.urdf", text + "</robot>"), &options)
}

#[test]
fn a_pair_with_axes_is_a_revolute_loop() {
    let loaded = two_bars(true, "", LoadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    let [closure] = loaded.mechanism.closures() else { panic!("one loop") };
    assert_eq!((closure.name(), closure.kind()), ("closing_pin", ClosureKind::Revolute));
    let axis = |frame: &percuss_spatial::Transform<f64>| frame.vector(closure.axis());
    assert!((axis(&closure.predecessor().frame) - Vector3::z()).norm() < 1e-15);
    let turned = Vector3::new(0.29552020666133956, 0.0, 0.955336489125606);
    assert!((axis(&closure.successor().frame) - turned).norm() < 1e-15);
    assert!(codes(&Ok(loaded)).contains(&(Severity::Note, "closing-pair")));
}

#[test]
fn a_pair_without_axes_is_never_silently_open() {
    let refused = two_bars(false, "", LoadOptions::default());
    let errors: Vec<_> = told(&refused).iter().filter(|found| found.severity == Severity::Error).collect();
    assert_eq!((refused.is_err(), errors.len(), errors[0].code), (true, 1, "closing-pair"));
    for word in ["closing_pin_1", "closing_pin_2", "[[closure]]", "<loop"] {
        assert!(errors[0].message.contains(word), "{}", errors[0]);
    }
    let told = two_bars(false, "", LoadOptions { open_pairs: true, ..LoadOptions::default() });
    assert!(codes(&told).contains(&(Severity::Warning, "closing-pair")));
    // A loop of the file holds the pair.
    let pin = "<loop name=\"pin\" type=\"spherical\"><predecessor link=\"closing_pin_2\"/><successor link=\"closing_pin_1\"/></loop>";
    let closed = two_bars(false, pin, LoadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(closed.mechanism.closures().len(), 1);
    // One link of the name alone is no pair.
    let alone = two_bars(
        true,
        "<link name=\"closing_lid_1\"/><joint name=\"lid\" type=\"fixed\"><parent link=\"base\"/><child link=\"closing_lid_1\"/></joint>",
        LoadOptions::default(),
    );
    assert_eq!(codes(&alone).iter().filter(|(_, code)| *code == "closing-pair").count(), 1);
}
