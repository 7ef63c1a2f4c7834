//! Shapes of links as geoms. `inertiafromgeom="false"` keeps their mass out of the bodies.

use super::body_tree::{BodyTree, pose_attributes};
use crate::meshes::files::binary_stl_facets;
use crate::reading::unique_names::UniqueNames;
use crate::shape::{Purpose, Shape, Solid};
use crate::writing::changes::{Change, lost_shape};
use crate::writing::parts::{ModelParts, has_positive_size};
use crate::writing::structure::immovable_links;
use crate::writing::xml_text::{append, escape_attribute, format_numbers, scale_text};
use percuss_mechanism::{JointKind, LinkId};
use std::collections::{BTreeSet, HashMap};

/// Default classes of the geoms. Contacts of visual geoms are disabled. Groups 2 and 3 are MuJoCo's convention: viewers hide group 3.
const CLASSES: &str = "  <default>\n    <default class=\"visual\">\n      <geom group=\"2\" contype=\"0\" conaffinity=\"0\"/>\n    \
                       </default>\n    <default class=\"collision\">\n      <geom group=\"3\"/>\n    </default>\n  </default>\n";

/// Range of the number of facets in an STL file that MuJoCo accepts.
const FACETS: std::ops::RangeInclusive<usize> = 1..=200_000;

/// Sections of the MJCF file that the shapes require.
#[derive(Default)]
pub(super) struct ShapeSections {
    /// `<default>`: classes of the geoms.
    pub classes: &'static str,
    /// Lines of `<asset>`: meshes.
    pub assets: String,
    /// Lines of `<contact>`: pairs of joined bodies without contact.
    pub excludes: String,
}

/// Mesh assets, one for each file name and scale.
#[derive(Default)]
struct Assets {
    names: HashMap<(String, [u64; 3]), String>,
    used: UniqueNames,
    lines: String,
}

/// Adds a geom for each shape, and returns the sections that the geoms require. `with_contacts`: true if collision shapes make contact; if false, all shapes are
/// visual.
pub(super) fn add_shapes(
    parts: &ModelParts<'_>,
    tree: &mut BodyTree<'_>,
    with_contacts: bool,
) -> ShapeSections {
    let mechanism = parts.mechanism;
    let mut assets = Assets::default();
    let mut with_collisions = vec![false; mechanism.links().len()];
    let mut has_geoms = false;
    for (link, shapes) in mechanism.link_ids().zip(parts.shapes) {
        for shape in shapes {
            let is_visual = shape.purpose == Purpose::Visual || !with_contacts;
            let line = match tree.has_body(link) {
                true => geom(parts, shape, is_visual, &mut assets),
                false => Err("its link is massless and merged into the body of another link".to_owned()),
            };
            match line {
                Ok(line) => {
                    tree.append_content(Some(link), &line);
                    with_collisions[link.index()] |= !is_visual;
                    has_geoms = true;
                }
                Err(reason) => {
                    tree.changes.push(lost_shape(mechanism, link, shape, reason));
                }
            }
        }
    }
    ShapeSections {
        classes: if has_geoms { CLASSES } else { "" },
        assets: assets.lines,
        excludes: excluded_pairs(tree, &with_collisions),
    }
}

/// Element `<geom>`; the error is the reason for the loss of the shape.
fn geom(
    parts: &ModelParts<'_>,
    shape: &Shape,
    is_visual: bool,
    assets: &mut Assets,
) -> Result<String, String> {
    if !has_positive_size(&shape.solid) {
        return Err("MuJoCo refuses a dimension or a scale factor of 0".to_owned());
    }
    let sizes = |kind: &str, sizes: &[f64]| format!("type=\"{kind}\" size=\"{}\"", format_numbers(sizes));
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
                        return Err(format!(
                            "{file}: MuJoCo reads only binary STL files with 1 to {most} facets; convert the mesh"
                        ));
                    }
                    _ => return Err(format!("{file}: MuJoCo reads only STL, OBJ and MSH; convert the mesh")),
                }
            }
            format!("type=\"mesh\" mesh=\"{}\"", escape_attribute(&assets.name(&mesh.name, *scale)))
        }
    };
    let class = if is_visual { "visual" } else { "collision" };
    Ok(format!("<geom class=\"{class}\" {form}{}/>\n", pose_attributes(&shape.frame)))
}

impl Assets {
    /// Returns the name of the asset for a file and its scale factors; adds the asset if it is new.
    fn name(&mut self, file: &str, scale: [f64; 3]) -> String {
        let key = (file.to_owned(), scale.map(f64::to_bits));
        if let Some(name) = self.names.get(&key) {
            return name.clone();
        }
        let stem = file.rsplit(['/', '\\']).next().unwrap_or(file);
        let stem = stem.rsplit_once('.').map_or(stem, |(stem, _)| stem);
        let name = self.used.take(if stem.is_empty() { "mesh".to_owned() } else { stem.to_owned() });
        let scale = scale_text(" scale=\"", &scale, "\"");
        // Without `shell`, MuJoCo refuses flat meshes. The inertia of the mesh is not used.
        append!(
            self.lines,
            "    <mesh name=\"{}\" file=\"{}\"{scale} inertia=\"shell\"/>\n",
            escape_attribute(&name),
            escape_attribute(file)
        );
        self.names.insert(key, name.clone());
        name
    }
}

/// Elements `<exclude>` for pairs of bodies that a loop joins, and for pairs of an immovable body and its child, except the world. MuJoCo itself excludes the
/// other pairs of parent and child.
fn excluded_pairs(tree: &mut BodyTree<'_>, with_collisions: &[bool]) -> String {
    let mechanism = tree.mechanism;
    let immovable = immovable_links(mechanism);
    let root = mechanism.root();
    // Links that fixed joints connect move as one body. A link of the immovable group stays alone: the other links may be obstacles.
    let mut first_of_group: Vec<LinkId> = mechanism.link_ids().collect();
    for &link in mechanism.order() {
        if let Some(joint) = mechanism.parent_joint(link).map(|id| mechanism.joint(id))
            && joint.kind() == JointKind::Fixed
            && !immovable[link.index()]
        {
            first_of_group[link.index()] = first_of_group[joint.parent().index()];
        }
    }
    let mut groups = vec![Vec::new(); first_of_group.len()];
    for link in mechanism.link_ids().filter(|link| with_collisions[link.index()]) {
        groups[first_of_group[link.index()].index()].push(link.index());
    }
    let mut pairs = BTreeSet::new();
    let mut exclude = |one: LinkId, other: LinkId| {
        let [one, other] = [one, other].map(|link| first_of_group[link.index()]);
        if one != other {
            let all =
                groups[one.index()].iter().flat_map(|a| groups[other.index()].iter().map(move |b| (*a, *b)));
            pairs.extend(all.map(|(a, b)| (a.min(b), a.max(b))));
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
        // Shapes of the world are obstacles.
        if immovable[above.index()] && !tree.is_world(above) && joint.kind() != JointKind::Floating {
            exclude(above, link);
        }
    }
    for closure in mechanism.closures() {
        let [one, other] = [closure.predecessor(), closure.successor()].map(|end| end.link.unwrap_or(root));
        exclude(one, other);
    }
    for (one, other) in &pairs {
        let [one, other] = [one, other].map(|index| mechanism.links()[*index].name());
        let what = format!("its shapes do not touch those of link \"{other}\"");
        tree.changes.push(Change::changed("link", one, what, "a joint or a loop joins the two bodies"));
    }
    let name = |index: usize| escape_attribute(mechanism.links()[index].name());
    pairs.iter().fold(String::new(), |mut out, (one, other)| {
        append!(out, "    <exclude body1=\"{}\" body2=\"{}\"/>\n", name(*one), name(*other));
        out
    })
}
