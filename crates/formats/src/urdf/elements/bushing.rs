//! Parser of `<bushing>` in the robot: an elastic connection of two links.
//!
//! ```xml
//! <bushing name="lower_front" parent="lower_arm" child="chassis">
//!   <origin xyz="0 0.1 0" rpy="0 1.5708 0"/>          <!-- in the parent; the z-axis is the axis of the bush -->
//!   <stiffness xyz="9e6 9e6 1.1e6" rpy="250 250 60" loss_factor="0.12" dynamic_factor="1.4"/>
//!   <damping xyz="800 800 200" rpy="0 0 0"/>
//!   <preload xyz="0 0 500" rpy="0 0 0"/>              <!-- force and moment on the parent -->
//!   <joint name="lower_arm_hinge"/>                   <!-- joints and loops in whose place the bush is -->
//!   <rigid xyz="1 1 1" rpy="0 0 0"/>                  <!-- rows that they hold; default: the translations -->
//! </bushing>
//! ```

use crate::reading::report::{Place, Report};
use crate::reading::xml::Node;
use crate::urdf::elements::link::read_name;
use crate::urdf::elements::numbers::{optional_numbers, report_missing_attribute};
use crate::urdf::elements::origin::read_origin;
use crate::urdf::elements::survey::{child, children};
use percuss_mechanism::BushDescription;

/// Reads a `<bushing>` of the robot. Each number of the result is finite; defects are reported.
pub(crate) fn read_bushing(node: Node<'_>, report: &mut Report) -> BushDescription {
    let name = read_name(node, report).to_owned();
    let [link, against] = ["parent", "child"].map(|key| {
        if node.attribute(key).is_none() {
            report_missing_attribute(node, key, report);
        }
        node.attribute(key).unwrap_or_default().to_owned()
    });
    let Some(stiffness) = child(node, "stiffness") else {
        report.error("missing-element", Place::Element(node), || {
            "<bushing> has no <stiffness xyz=\"…\" rpy=\"…\"/> in N/m and N·m/rad".to_owned()
        });
        return BushDescription::new(name, link, against);
    };
    let replaces: Vec<String> =
        children(node, "joint").map(|joint| read_name(joint, report).to_owned()).collect();
    // Rotations come first in a bush.
    let mut rows = |element: Option<Node<'_>>, default: [f64; 6]| {
        let Some(element) = element else { return default };
        let [a, b, c] = optional_numbers(element, "rpy", [0.0; 3], report);
        let [x, y, z] = optional_numbers(element, "xyz", [0.0; 3], report);
        [a, b, c, x, y, z]
    };
    let held = if replaces.is_empty() { [0.0; 6] } else { [0.0, 0.0, 0.0, 1.0, 1.0, 1.0] };
    let rigid = rows(child(node, "rigid"), held).map(|held| held != 0.0);
    let [damping, preload] = ["damping", "preload"].map(|tag| rows(child(node, tag), [0.0; 6]));
    let rates = rows(Some(stiffness), [0.0; 6]);
    let [[loss_factor], [dynamic_factor]] = [("loss_factor", 0.0), ("dynamic_factor", 1.0)]
        .map(|(key, default)| optional_numbers(stiffness, key, [default], report));
    BushDescription {
        frame: read_origin(node, report).transform,
        stiffness: rates,
        damping,
        loss_factor,
        dynamic_factor,
        preload,
        rigid,
        replaces,
        ..BushDescription::new(name, link, against)
    }
}
