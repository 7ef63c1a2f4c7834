//! Shapes of links as geoms without mass.

use super::body_tree::{BodyTree, pose_attributes};
use crate::meshes::files::binary_stl_facets;
use crate::reading::unique_names::UniqueNames;
use crate::urdf::elements::shapes::shape::{Purpose, Shape, Solid};
use crate::writing::changes::Change;
use crate::writing::parts::{ModelParts, has_extent};
use crate::writing::structure::links_at_rest;
use crate::writing::xml_text::{append, escape_attribute, format_number, format_vector};
use percuss_mechanism::{LinkId, Mechanism};
use percuss_spatial::Vector3;
use std::collections::{BTreeSet, HashMap};

/// Classes of the geoms: `group` selects what MuJoCo's viewers show, and visual shapes touch nothing.
const CLASSES: &str = "  <default>\n    <default class=\"visual\">\n      <geom group=\"2\" contype=\"0\" conaffinity=\"0\"/>\n    \
                       </default>\n    <default class=\"collision\">\n      <geom group=\"3\"/>\n    </default>\n  </default>\n";

/// Numbers of facets of an STL file that MuJoCo accepts.
const FACETS: std::ops::RangeInclusive<usize> = 1..=200_000;

/// Sections of the file for the shapes.
#[derive(Default)]
pub(super) struct ShapeSections {
    /// Defaults of the geoms.
    pub classes: &'static str,
    /// Meshes.
    pub assets: String,
    /// Pairs of joined bodies whose shapes do not touch.
    pub excludes: String,
}

/// Mesh assets by file name and scale.
#[derive(Default)]
struct Assets {
    names: HashMap<(String, [u64; 3]), String>,
    used: UniqueNames,
    lines: String,
}

/// Adds a geom for each shape. `touching`: whether collision shapes touch other bodies.
pub(super) fn add_shapes(parts: &ModelParts<'_>, tree: &mut BodyTree, touching: bool) -> ShapeSections {
    let mechanism = parts.mechanism;
    let mut assets = Assets::default();
    let mut with_collisions = vec![false; mechanism.links().len()];
    let mut has_geoms = false;
    for (link, shapes) in mechanism.link_ids().zip(parts.shapes) {
        for shape in shapes {
            let is_visual = shape.purpose == Purpose::Visual || !touching;
            let line = match tree.has_body(link) {
                true => geom(parts, shape, is_visual, &mut assets),
                false => Err("its link has no body of its own in MJCF".to_owned()),
            };
            match line {
                Ok(line) => {
                    tree.append_content(mechanism, Some(link), &line);
                    with_collisions[link.index()] |= !is_visual;
                    has_geoms = true;
                }
                Err(reason) => {
                    let what = format!("a shape ({})", shape.purpose.name());
                    tree.changes.push(Change::lost("link", mechanism.link(link).name(), what, reason));
                }
            }
        }
    }
    ShapeSections {
        classes: if has_geoms { CLASSES } else { "" },
        assets: assets.lines,
        excludes: excluded_pairs(mechanism, tree, &with_collisions),
    }
}

/// Element `<geom>`; the error is the reason for the loss of the shape.
fn geom(
    parts: &ModelParts<'_>,
    shape: &Shape,
    is_visual: bool,
    assets: &mut Assets,
) -> Result<String, String> {
    if !has_extent(&shape.solid) {
        return Err("MuJoCo refuses a length of 0".to_owned());
    }
    let sizes = |kind: &str, sizes: &[f64]| {
        let sizes: Vec<String> = sizes.iter().map(|size| format_number(*size)).collect();
        format!("type=\"{kind}\" size=\"{}\"", sizes.join(" "))
    };
    let form = match &shape.solid {
        Solid::Box { size } => sizes("box", &size.map(|edge| edge / 2.0)),
        Solid::Sphere { radius } => sizes("sphere", &[*radius]),
        Solid::Cylinder { radius, length } => sizes("cylinder", &[*radius, length / 2.0]),
        Solid::Capsule { radius, length } => sizes("capsule", &[*radius, length / 2.0]),
        Solid::Mesh { file, scale } => {
            let mesh = (parts.find_mesh)(file)?;
            if let Some(path) = &mesh.path {
                let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
                match ending.as_deref() {
                    Some("obj" | "msh") => {}
                    Some("stl") if binary_stl_facets(path).is_some_and(|count| FACETS.contains(&count)) => {}
                    Some("stl") => {
                        let most = FACETS.end();
                        return Err(format!("{file}: MuJoCo reads binary STL of at most {most} facets"));
                    }
                    _ => return Err(format!("{file}: MuJoCo reads STL, OBJ and MSH")),
                }
            }
            format!("type=\"mesh\" mesh=\"{}\"", escape_attribute(&assets.name(&mesh.name, *scale)))
        }
    };
    let class = if is_visual { "visual" } else { "collision" };
    Ok(format!("<geom class=\"{class}\" {form}{}/>\n", pose_attributes(&shape.frame)))
}

impl Assets {
    /// Name of the asset for a file with scale factors.
    fn name(&mut self, file: &str, scale: [f64; 3]) -> String {
        let key = (file.to_owned(), scale.map(f64::to_bits));
        if let Some(name) = self.names.get(&key) {
            return name.clone();
        }
        let stem = file.rsplit(['/', '\\']).next().unwrap_or(file);
        let stem = stem.rsplit_once('.').map_or(stem, |(stem, _)| stem);
        let name = self.used.take(if stem.is_empty() { "mesh".to_owned() } else { stem.to_owned() });
        let scale = match scale {
            [1.0, 1.0, 1.0] => String::new(),
            factors => format!(" scale=\"{}\"", format_vector(&Vector3::from(factors))),
        };
        // The mass of the shell always exists; no mass comes from the shapes.
        append(
            &mut self.lines,
            format_args!(
                "    <mesh name=\"{}\" file=\"{}\"{scale} inertia=\"shell\"/>\n",
                escape_attribute(&name),
                escape_attribute(file)
            ),
        );
        self.names.insert(key, name.clone());
        name
    }
}

/// Elements `<exclude>` for the bodies that a loop joins, and for those on bodies at rest: MuJoCo itself excludes other neighbours.
fn excluded_pairs(mechanism: &Mechanism, tree: &BodyTree, with_collisions: &[bool]) -> String {
    let at_rest = links_at_rest(mechanism);
    let mut pairs = BTreeSet::new();
    let root = mechanism.root();
    let mut exclude = |one: LinkId, other: LinkId| {
        if one != other && with_collisions[one.index()] && with_collisions[other.index()] {
            pairs.insert((one.index().min(other.index()), one.index().max(other.index())));
        }
    };
    for &link in mechanism.order() {
        let Some(joint) = mechanism.parent_joint(link).map(|id| mechanism.joint(id)) else { continue };
        let mut above = joint.parent();
        while !tree.has_body(above)
            && let Some(id) = mechanism.parent_joint(above)
        {
            above = mechanism.joint(id).parent();
        }
        if at_rest[above.index()] {
            exclude(above, link);
        }
    }
    for closure in mechanism.closures() {
        let [one, other] = [closure.predecessor(), closure.successor()].map(|end| end.link.unwrap_or(root));
        exclude(one, other);
    }
    let name = |index: usize| escape_attribute(mechanism.links()[index].name());
    pairs.iter().fold(String::new(), |mut out, (one, other)| {
        append(
            &mut out,
            format_args!("    <exclude body1=\"{}\" body2=\"{}\"/>\n", name(*one), name(*other)),
        );
        out
    })
}
