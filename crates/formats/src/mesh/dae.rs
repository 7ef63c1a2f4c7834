//! COLLADA 1.4 and 1.5: `triangles`, `polylist` and `polygons` of the visual scene, with the transforms of its nodes and the unit.

use super::triangles::{Triangles, bounded};
use crate::limits::{DEEPEST_NODES, MOST_SCENE_NODES};
use crate::prescan;
use crate::report::Report;
use nalgebra::{Matrix4, Rotation3, Unit, Vector3, Vector4};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::HashMap;

pub(super) fn read(bytes: &[u8]) -> Result<Triangles, String> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let text = std::str::from_utf8(bytes).map_err(|_| "no UTF-8 text".to_owned())?;
    let mut report = Report::default();
    if !prescan::check(text, &mut report) {
        let first = report.finish("", text).into_iter().next();
        return Err(first.map_or_else(|| "too complex".to_owned(), |d| d.message));
    }
    let parsing =
        ParsingOptions { allow_dtd: true, nodes_limit: crate::limits::MOST_NODES, entity_resolver: None };
    let document = Document::parse_with_options(text, parsing).map_err(|e| format!("no XML: {e}"))?;
    let root = document.root_element();
    if root.tag_name().name() != "COLLADA" {
        return Err(format!("its root is <{}>; <COLLADA> is expected", root.tag_name().name()));
    }
    let ids = root.descendants().filter_map(|node| Some((node.attribute("id")?, node))).collect();
    let mut scene = Scene { ids, meshes: HashMap::new(), nodes: 0, triangles: Triangles::new() };
    let unit = elements(root, "asset").flat_map(|asset| elements(asset, "unit")).next();
    let metre = match unit.and_then(|unit| unit.attribute("meter")) {
        Some(text) => text.trim().parse::<f64>().ok().filter(|m| m.is_finite() && *m > 0.0),
        None => Some(1.0),
    };
    let metre = metre.ok_or("the unit's metres are no number above 0")?;
    let start = Matrix4::new_scaling(metre);
    let named = elements(root, "scene").flat_map(|s| elements(s, "instance_visual_scene")).next();
    let visual = named
        .and_then(|n| scene.target(n))
        .or_else(|| elements(root, "library_visual_scenes").flat_map(|l| elements(l, "visual_scene")).next());
    match visual {
        Some(visual) => {
            for node in elements(visual, "node") {
                scene.node(node, &start, 0)?;
            }
        }
        None => {
            for geometry in elements(root, "library_geometries").flat_map(|l| elements(l, "geometry")) {
                scene.geometry(geometry, &start)?;
            }
        }
    }
    Ok(scene.triangles)
}

fn elements<'a, 'i: 'a>(node: Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(move |c| c.is_element() && c.tag_name().name() == name)
}

fn numbers(node: Node<'_, '_>) -> Result<Vec<f64>, String> {
    let text = node.text().unwrap_or("");
    let read = |word: &str| match word.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("<{}> has {word:?}, which is no finite number", node.tag_name().name())),
    };
    text.split_ascii_whitespace().map(read).collect()
}

fn indices(node: Node<'_, '_>) -> Result<Vec<usize>, String> {
    let text = node.text().unwrap_or("");
    let read = |word: &str| {
        word.parse::<usize>()
            .map_err(|_| format!("<{}> has {word:?}, which is no index", node.tag_name().name()))
    };
    text.split_ascii_whitespace().map(read).collect()
}

struct Scene<'a, 'i> {
    ids: HashMap<&'a str, Node<'a, 'i>>,
    /// Triangles of geometries that were read, by the place of their element.
    meshes: HashMap<usize, Triangles>,
    nodes: usize,
    triangles: Triangles,
}

impl<'a, 'i: 'a> Scene<'a, 'i> {
    fn target(&self, node: Node<'a, 'i>) -> Option<Node<'a, 'i>> {
        self.reference(node.attribute("url").or_else(|| node.attribute("source"))?)
    }

    fn reference(&self, url: &str) -> Option<Node<'a, 'i>> {
        self.ids.get(url.strip_prefix('#')?).copied()
    }

    fn node(&mut self, node: Node<'a, 'i>, above: &Matrix4<f64>, depth: usize) -> Result<(), String> {
        self.nodes += 1;
        if depth > DEEPEST_NODES || self.nodes > MOST_SCENE_NODES {
            return Err("its nodes are nested too deep, or are too many".to_owned());
        }
        let mut place = *above;
        for child in node.children().filter(Node::is_element) {
            if let Some(step) = transform(child)? {
                place *= step;
            }
        }
        for child in node.children().filter(Node::is_element) {
            match child.tag_name().name() {
                "node" => self.node(child, &place, depth + 1)?,
                "instance_node" => {
                    let target = self.target(child).ok_or_else(|| missing(child))?;
                    self.node(target, &place, depth + 1)?;
                }
                "instance_geometry" => {
                    let target = self.target(child).ok_or_else(|| missing(child))?;
                    self.geometry(target, &place)?;
                }
                "instance_controller" => {
                    return Err("it has a skin (instance_controller), which is not read; export it without"
                        .to_owned());
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn geometry(&mut self, geometry: Node<'a, 'i>, place: &Matrix4<f64>) -> Result<(), String> {
        let key = geometry.range().start;
        if !self.meshes.contains_key(&key) {
            let mut own = Triangles::new();
            for mesh in elements(geometry, "mesh") {
                self.mesh(mesh, &mut own)?;
            }
            self.meshes.insert(key, own);
        }
        let own = &self.meshes[&key];
        bounded(self.triangles.len() + own.len())?;
        let move_to = |p: &[f64; 3]| {
            let q = place * Vector4::new(p[0], p[1], p[2], 1.0);
            [q.x, q.y, q.z]
        };
        self.triangles.extend(own.iter().map(|corners| corners.each_ref().map(move_to)));
        Ok(())
    }

    fn mesh(&self, mesh: Node<'a, 'i>, out: &mut Triangles) -> Result<(), String> {
        for primitive in mesh.children().filter(Node::is_element) {
            let kind = primitive.tag_name().name();
            match kind {
                "triangles" | "polylist" | "polygons" => {}
                "tristrips" | "trifans" => {
                    return Err(format!("it has <{kind}>, which is not read; export triangles"));
                }
                // Sources, vertices, lines, what others add.
                _ => continue,
            }
            let mut positions = None;
            let mut stride = 0;
            for input in elements(primitive, "input") {
                let offset = match input.attribute("offset").map(str::parse::<usize>) {
                    Some(Ok(offset)) if offset < 64 => offset,
                    None => 0,
                    Some(_) => return Err("an <input> has an offset that is none".to_owned()),
                };
                stride = stride.max(offset + 1);
                if input.attribute("semantic") == Some("VERTEX") {
                    let vertices = self.target(input).ok_or_else(|| missing(input))?;
                    let of =
                        elements(vertices, "input").find(|i| i.attribute("semantic") == Some("POSITION"));
                    let source = of.and_then(|i| self.target(i)).ok_or("its vertices have no positions")?;
                    positions = Some((offset, self.positions(source)?));
                }
            }
            let Some((offset, positions)) = positions else {
                return Err(format!("<{kind}> has no vertices"));
            };
            let counts = match elements(primitive, "vcount").next() {
                Some(vcount) => Some(indices(vcount)?),
                None => None,
            };
            for p in elements(primitive, "p") {
                let all = indices(p)?;
                let corners: Vec<usize> = all.chunks_exact(stride).map(|chunk| chunk[offset]).collect();
                let mut rest = &corners[..];
                let mut counts = counts.iter().flatten().copied();
                while !rest.is_empty() {
                    let count = match kind {
                        "triangles" => 3,
                        "polylist" => counts.next().ok_or("<vcount> counts fewer corners than there are")?,
                        _ => rest.len(),
                    };
                    if count > rest.len() {
                        return Err("a polygon has more corners than there are".to_owned());
                    }
                    let (polygon, after) = rest.split_at(count);
                    // An empty polygon would be counted for ever only where there is no list of counts.
                    rest = after;
                    fan(polygon, &positions, out)?;
                }
            }
        }
        Ok(())
    }

    fn positions(&self, source: Node<'a, 'i>) -> Result<Vec<[f64; 3]>, String> {
        let array = elements(source, "float_array").next().ok_or("a <source> has no <float_array>")?;
        let accessor = elements(source, "technique_common").flat_map(|t| elements(t, "accessor")).next();
        let number = |name: &str, otherwise: usize| match accessor.and_then(|a| a.attribute(name)) {
            None => Ok(otherwise),
            Some(text) => {
                text.trim().parse::<usize>().map_err(|_| format!("an <accessor> has {name}=\"{text}\""))
            }
        };
        let (stride, first) = (number("stride", 3)?, number("offset", 0)?);
        if stride < 3 {
            return Err(format!("positions of {stride} numbers; 3 are expected"));
        }
        let values = numbers(array)?;
        let used = values.get(first..).unwrap_or_default();
        Ok(used.chunks_exact(stride).map(|v| [v[0], v[1], v[2]]).collect())
    }
}

fn fan(polygon: &[usize], positions: &[[f64; 3]], out: &mut Triangles) -> Result<(), String> {
    let at = |i: usize| {
        positions.get(i).copied().ok_or_else(|| format!("a face names vertex {i} of {}", positions.len()))
    };
    for k in 2..polygon.len() {
        out.push([at(polygon[0])?, at(polygon[k - 1])?, at(polygon[k])?]);
        bounded(out.len())?;
    }
    Ok(())
}

fn missing(node: Node<'_, '_>) -> String {
    let url = node.attribute("url").or_else(|| node.attribute("source")).unwrap_or("");
    format!("<{}> refers to {url:?}, which there is not", node.tag_name().name())
}

/// The transform that an element of a node is; none for other elements.
fn transform(node: Node<'_, '_>) -> Result<Option<Matrix4<f64>>, String> {
    let name = node.tag_name().name();
    let count = match name {
        "matrix" => 16,
        "rotate" => 4,
        "translate" | "scale" => 3,
        "lookat" | "skew" => return Err(format!("a node has <{name}>, which is not read")),
        _ => return Ok(None),
    };
    let v = numbers(node)?;
    if v.len() != count {
        return Err(format!("<{name}> has {} numbers; {count} are expected", v.len()));
    }
    Ok(Some(match name {
        "matrix" => Matrix4::from_row_slice(&v),
        "translate" => Matrix4::new_translation(&Vector3::new(v[0], v[1], v[2])),
        "scale" => Matrix4::new_nonuniform_scaling(&Vector3::new(v[0], v[1], v[2])),
        _ => match Unit::try_new(Vector3::new(v[0], v[1], v[2]), 1e-12) {
            Some(axis) => Rotation3::from_axis_angle(&axis, v[3].to_radians()).to_homogeneous(),
            None => Matrix4::identity(),
        },
    }))
}
