//! Shapes of links as visuals and collisions.

use super::bodies::{Bodies, Form, path_pose, pose_text};
use crate::reading::unique_names::UniqueNames;
use crate::shape::{Shape, Solid};
use crate::writing::changes::lost_shape;
use crate::writing::parts::{ModelParts, has_positive_size};
use crate::writing::xml_text::{escape_attribute, format_number, format_vector, scale_text};
use percuss_mechanism::LinkId;
use percuss_spatial::{Transform, Vector3};

/// Visuals and collisions as XML.
pub(super) struct ShapeLines {
    /// XML of the shapes in each link, in link order.
    pub lines: Vec<String>,
    /// True if a shape is a capsule, which requires SDFormat 1.8.
    pub has_capsules: bool,
}

/// Writes the shapes of all links. Shapes of a link that becomes a frame are written in the link to which the frame is attached.
pub(super) fn write_shapes(parts: &ModelParts<'_>, bodies: &mut Bodies<'_>) -> ShapeLines {
    let mechanism = parts.mechanism;
    let mut written = ShapeLines { lines: vec![String::new(); mechanism.links().len()], has_capsules: false };
    let mut names: Vec<UniqueNames> = Vec::new();
    names.resize_with(mechanism.links().len(), UniqueNames::default);
    for (link, shapes) in mechanism.link_ids().zip(parts.shapes) {
        for shape in shapes {
            let line = holder(bodies, link).and_then(|holder| {
                let name = names[holder.index()].take(shape.purpose.name().to_owned());
                let frame = path_pose(mechanism, holder, link) * shape.frame;
                Ok((holder, shape_element(parts, shape, &name, &frame)?))
            });
            match line {
                Ok((holder, line)) => {
                    written.lines[holder.index()].push_str(&line);
                    written.has_capsules |= matches!(shape.solid, Solid::Capsule { .. });
                }
                Err(reason) => {
                    bodies.changes.push(lost_shape(mechanism, link, shape, reason));
                }
            }
        }
    }
    written
}

/// Returns the link that contains the shapes of `link` in the file. The error is the reason why the shapes are lost.
fn holder(bodies: &Bodies<'_>, mut link: LinkId) -> Result<LinkId, String> {
    loop {
        match (&bodies.forms[link.index()], bodies.mechanism.parent_joint(link)) {
            (Form::Link, _) => return Ok(link),
            (Form::Frame, Some(joint)) => link = bodies.mechanism.joint(joint).parent(),
            (Form::Merged, _) => return Err("its link is massless and merged into a joint".to_owned()),
            (Form::World | Form::Frame, _) => {
                return Err("its link is the world, which has no shapes in SDFormat".to_owned());
            }
        }
    }
}

/// Element `<visual>` or `<collision>`. The error is the reason why the shape is lost.
fn shape_element(
    parts: &ModelParts<'_>,
    shape: &Shape,
    name: &str,
    frame: &Transform<f64>,
) -> Result<String, String> {
    if !has_positive_size(&shape.solid) {
        return Err("SDFormat allows no dimension or scale factor of 0".to_owned());
    }
    let round = |tag: &str, radius: f64, length: f64| {
        let (radius, length) = (format_number(radius), format_number(length));
        format!("<{tag}><radius>{radius}</radius><length>{length}</length></{tag}>")
    };
    let geometry = match &shape.solid {
        Solid::Box { size } => format!("<box><size>{}</size></box>", format_vector(&Vector3::from(*size))),
        Solid::Sphere { radius } => format!("<sphere><radius>{}</radius></sphere>", format_number(*radius)),
        Solid::Cylinder { radius, length } => round("cylinder", *radius, *length),
        Solid::Capsule { radius, length } => round("capsule", *radius, *length),
        Solid::Mesh { file, scale } => {
            let uri = escape_attribute(&(parts.find_mesh)(file)?.name);
            let scale = scale_text("<scale>", scale, "</scale>");
            format!("<mesh><uri>{uri}</uri>{scale}</mesh>")
        }
    };
    let tag = shape.purpose.name();
    let pose = match *frame == Transform::identity() {
        true => String::new(),
        false => format!("<pose>{}</pose>", pose_text(frame)),
    };
    Ok(format!("      <{tag} name=\"{name}\">{pose}<geometry>{geometry}</geometry></{tag}>\n"))
}
