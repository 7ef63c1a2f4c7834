//! Pairs of links that mark a loop: `closing_NAME_1` and `closing_NAME_2`, as onshape-to-robot writes them.
//!
//! The two links coincide as drawn. With the links `closing_NAME_1_z` and `closing_NAME_2_z` on the axis of the mate the loop is
//! revolute. Without them the file does not give its kind, which may be fixed, spherical or prismatic.

use crate::reading::report::{Place, Report, quoted};
use crate::urdf::elements::joints::gazebo_joint::ZeroPoseFrames;
use crate::urdf::elements::nodes::Nodes;
use crate::urdf::references::index_by_name;
use crate::urdf::texts::Texts;
use percuss_mechanism::{ClosureDescription, ClosureKind, Severity};
use percuss_spatial::{Matrix3, Transform, Vector3, plane_basis};
use std::collections::HashSet;

/// Adds a loop for each pair with axes. Another pair is an error, or a warning if `open_pairs` is set, unless a loop of the file holds
/// the two links.
pub(crate) fn close_pairs<'a>(
    nodes: &mut Nodes<'a>,
    texts: &mut Texts<'a>,
    open_pairs: bool,
    report: &mut Report,
) {
    let links = index_by_name(texts.links.iter().map(|link| link.name));
    let first_links = texts.links.iter().map(|link| link.name);
    let pairs = first_links.filter_map(|first| {
        let name = first.strip_prefix("closing_")?.strip_suffix("_1")?;
        let second = links.get_key_value(format!("closing_{name}_2").as_str())?;
        Some((name, first, *second.0))
    });
    let pairs: Vec<(&str, &str, &str)> = pairs.collect();
    if pairs.is_empty() {
        return;
    }
    let held: HashSet<(String, String)> = texts
        .closures
        .iter()
        .flat_map(|closure| {
            let ends = (closure.predecessor.clone(), closure.successor.clone());
            [(ends.1.clone(), ends.0.clone()), ends]
        })
        .collect();
    let zero_pose = ZeroPoseFrames::new(&texts.joints);
    let mut added = Vec::new();
    for (name, first, second) in pairs {
        if held.contains(&(first.to_owned(), second.to_owned())) {
            continue;
        }
        let node = nodes.links[links[first]];
        let frames = [first, second].map(|link| frame_along_axis(&zero_pose, &links, link));
        if let [Some(predecessor_frame), Some(successor_frame)] = frames {
            report.note("closing-pair", Place::Element(node), || {
                format!("the links {} and {} are read as a revolute loop", quoted(first), quoted(second))
            });
            let closure = ClosureDescription {
                predecessor_frame,
                successor_frame,
                axis: Vector3::z(),
                ..ClosureDescription::new(format!("closing_{name}"), ClosureKind::Revolute, first, second)
            };
            added.push((closure, node));
            continue;
        }
        let severity = if open_pairs { Severity::Warning } else { Severity::Error };
        report.add(severity, "closing-pair", Place::Element(node), || {
            format!(
                "the links {} and {} mark a loop, and the file does not give its kind: write <loop name=\"{name}\" type=\"KIND\"> with these \
                 links, or [[closure]] with predecessor, successor and type in a study; KIND is fixed, spherical or prismatic",
                quoted(first),
                quoted(second)
            )
        });
    }
    for (closure, node) in added {
        texts.closures.push(closure);
        nodes.closures.push(node);
    }
}

/// Frame at the origin of a link with its z-axis towards the link `LINK_z`, as drawn; `None` if there is no such link, or if it coincides
/// with the first.
fn frame_along_axis(
    zero_pose: &ZeroPoseFrames<'_, '_>,
    links: &std::collections::HashMap<&str, usize>,
    link: &str,
) -> Option<Transform<f64>> {
    let (tip, _) = links.get_key_value(format!("{link}_z").as_str())?;
    let to_tip = (zero_pose.link_frame(link).inverse() * zero_pose.link_frame(tip)).translation;
    let axis = to_tip.try_normalize(f64::MIN_POSITIVE)?;
    if axis == Vector3::z() {
        return Some(Transform::identity());
    }
    let (x, y) = plane_basis(&axis);
    Some(Transform::new(Matrix3::from_columns(&[x, y, axis]), Vector3::zeros()))
}
