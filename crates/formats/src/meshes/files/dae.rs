//! Reader of COLLADA 1.4 and 1.5: `triangles`, `polylist` and `polygons` of the visual scene, with node transforms and the unit
//! of length.

use super::triangles::{Triangles, check_triangle_count};
use crate::reading::limits::{MAX_MESH_NUMBERS, MAX_SCENE_DEPTH, MAX_SCENE_NODES};
use crate::reading::prescan;
use crate::reading::report::{Report, quoted};
use crate::reading::xml::Node;
use nalgebra::{Matrix4, Rotation3, Unit, Vector3, Vector4};
use roxmltree::{Document, ParsingOptions};
use std::collections::HashMap;
use std::rc::Rc;

/// Triangles of a COLLADA document, m.
pub(super) fn read_collada(bytes: &[u8]) -> Result<Triangles, String> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let text = std::str::from_utf8(bytes).map_err(|_| "no UTF-8 text".to_owned())?;
    let mut report = Report::default();
    if !prescan::check_bounds(text, &mut report) {
        let first = report.finish("", text).into_iter().next();
        return Err(first.map_or_else(|| "too complex".to_owned(), |d| d.message));
    }
    let parsing = ParsingOptions {
        allow_dtd: true,
        nodes_limit: crate::reading::limits::MAX_NODES,
        entity_resolver: None,
    };
    let document = Document::parse_with_options(text, parsing).map_err(|e| format!("no XML: {e}"))?;
    let root = document.root_element();
    if root.tag_name().name() != "COLLADA" {
        return Err(format!("its root is <{}>; <COLLADA> is expected", root.tag_name().name()));
    }
    let elements_by_id = root.descendants().filter_map(|node| Some((node.attribute("id")?, node))).collect();
    let mut scene = Scene {
        elements_by_id,
        geometries: HashMap::new(),
        positions: HashMap::new(),
        scene_nodes: HashMap::new(),
        numbers: 0,
        visits: 0,
        triangles: Triangles::new(),
    };
    let unit = child_elements(root, "asset").flat_map(|asset| child_elements(asset, "unit")).next();
    let metre = match unit.and_then(|unit| unit.attribute("meter")) {
        Some(text) => text.trim().parse::<f64>().ok().filter(|m| m.is_finite() && *m > 0.0),
        None => Some(1.0),
    };
    let metre = metre.ok_or("the unit's metres are no number above 0")?;
    let root_transform = Matrix4::new_scaling(metre);
    let named = child_elements(root, "scene").flat_map(|s| child_elements(s, "instance_visual_scene")).next();
    let visual = named.and_then(|n| scene.resolve_reference(n)).or_else(|| {
        child_elements(root, "library_visual_scenes").flat_map(|l| child_elements(l, "visual_scene")).next()
    });
    match visual {
        Some(visual) => {
            for node in child_elements(visual, "node") {
                scene.append_node(node, &root_transform, 0)?;
            }
        }
        None => {
            for geometry in
                child_elements(root, "library_geometries").flat_map(|l| child_elements(l, "geometry"))
            {
                scene.append_geometry(geometry, &root_transform)?;
            }
        }
    }
    Ok(scene.triangles)
}

/// Child elements with this tag, in any namespace.
fn child_elements<'a>(node: Node<'a>, tag: &'static str) -> impl Iterator<Item = Node<'a>> {
    node.children().filter(move |c| c.is_element() && c.tag_name().name() == tag)
}

/// Finite numbers in the text of an element.
fn parse_finite_numbers(node: Node<'_>) -> Result<Vec<f64>, String> {
    let read = |word: &str| word.parse::<f64>().ok().filter(|value| value.is_finite());
    parse_words(node, read, "finite number")
}

/// Indices or counts in the text of an element.
fn parse_indices(node: Node<'_>) -> Result<Vec<u32>, String> {
    parse_words(node, |word| word.parse().ok(), "index")
}

/// Words in the text of an element, converted by `parse_word`. `kind` names the expected words in errors.
fn parse_words<T>(
    node: Node<'_>,
    parse_word: impl Fn(&str) -> Option<T>,
    kind: &str,
) -> Result<Vec<T>, String> {
    let mut list = Vec::new();
    for word in node.text().unwrap_or("").split_ascii_whitespace() {
        if list.len() == MAX_MESH_NUMBERS {
            return Err(too_many_numbers_message());
        }
        list.push(parse_word(word).ok_or_else(|| invalid_word_message(node, word, kind))?);
    }
    Ok(list)
}

fn invalid_word_message(node: Node<'_>, word: &str, kind: &str) -> String {
    format!("<{}> has {}, which is no {kind}", node.tag_name().name(), quoted(word))
}

/// Scene with caches by the offset of an element: an element is read once, even with many references.
struct Scene<'a> {
    elements_by_id: HashMap<&'a str, Node<'a>>,
    /// Triangles of geometries, in their own frames.
    geometries: HashMap<usize, Triangles>,
    /// Positions of `source` and `vertices` elements.
    positions: HashMap<usize, Rc<Vec<[f64; 3]>>>,
    /// Nodes of the scene.
    scene_nodes: HashMap<usize, Rc<SceneNode<'a>>>,
    /// Number of values read so far.
    numbers: usize,
    visits: usize,
    triangles: Triangles,
}

/// Node of the scene: transform, child nodes and instances.
struct SceneNode<'a> {
    transform: Matrix4<f64>,
    contents: Vec<Content<'a>>,
}

/// Child of a node, or target of an instance.
enum Content<'a> {
    Node(Node<'a>),
    Geometry(Node<'a>),
}

impl<'a> Scene<'a> {
    /// Element to which the attribute `url` or `source` refers.
    fn resolve_reference(&self, node: Node<'a>) -> Option<Node<'a>> {
        let url = node.attribute("url").or_else(|| node.attribute("source"))?;
        self.elements_by_id.get(url.strip_prefix('#')?).copied()
    }

    /// As [`resolve_reference`](Self::resolve_reference); an error for an unknown name.
    fn referenced(&self, node: Node<'a>) -> Result<Node<'a>, String> {
        self.resolve_reference(node).ok_or_else(|| {
            let url = node.attribute("url").or_else(|| node.attribute("source")).unwrap_or("");
            format!("<{}> refers to {url:?}, which there is not", node.tag_name().name())
        })
    }

    /// Appends the triangles of a node and its descendants. `parent_transform` maps the parent node's frame to the mesh frame, m.
    fn append_node(
        &mut self,
        node: Node<'a>,
        parent_transform: &Matrix4<f64>,
        depth: usize,
    ) -> Result<(), String> {
        self.count_visit()?;
        if depth > MAX_SCENE_DEPTH {
            return Err(format!(
                "its nodes are nested too deep; at most {MAX_SCENE_DEPTH} within one another are read"
            ));
        }
        let scene_node = self.read_scene_node(node)?;
        let transform = parent_transform * scene_node.transform;
        for contents in &scene_node.contents {
            match *contents {
                Content::Node(node) => self.append_node(node, &transform, depth + 1)?,
                Content::Geometry(geometry) => {
                    self.count_visit()?;
                    self.append_geometry(geometry, &transform)?;
                }
            }
        }
        Ok(())
    }

    /// Counts a visit to a node or geometry, and checks the limit.
    fn count_visit(&mut self) -> Result<(), String> {
        self.visits += 1;
        if self.visits > MAX_SCENE_NODES {
            return Err(format!("its nodes and instances are too many; at most {MAX_SCENE_NODES} are read"));
        }
        Ok(())
    }

    /// Transform to the parent node, child nodes and geometries of a `node` element; each element is read once.
    fn read_scene_node(&mut self, node: Node<'a>) -> Result<Rc<SceneNode<'a>>, String> {
        let key = node.range().start;
        if let Some(scene_node) = self.scene_nodes.get(&key) {
            return Ok(scene_node.clone());
        }
        let mut scene_node = SceneNode { transform: Matrix4::identity(), contents: Vec::new() };
        for child in node.children().filter(Node::is_element) {
            match child.tag_name().name() {
                "node" => scene_node.contents.push(Content::Node(child)),
                "instance_node" => {
                    scene_node.contents.push(Content::Node(self.referenced(child)?));
                }
                "instance_geometry" => {
                    scene_node.contents.push(Content::Geometry(self.referenced(child)?));
                }
                "instance_controller" => {
                    return Err("it has a skin (instance_controller), which is not read; export it without"
                        .to_owned());
                }
                _ => {
                    if let Some(step) = transform_of_element(child)? {
                        scene_node.transform *= step;
                    }
                }
            }
        }
        let scene_node = Rc::new(scene_node);
        self.scene_nodes.insert(key, scene_node.clone());
        Ok(scene_node)
    }

    /// Appends the triangles of a `geometry` element; `transform` maps its frame to the mesh frame, m.
    fn append_geometry(&mut self, geometry: Node<'a>, transform: &Matrix4<f64>) -> Result<(), String> {
        let key = geometry.range().start;
        if !self.geometries.contains_key(&key) {
            let mut local_triangles = Triangles::new();
            for mesh in child_elements(geometry, "mesh") {
                self.append_mesh(mesh, &mut local_triangles)?;
            }
            self.geometries.insert(key, local_triangles);
        }
        let local_triangles = &self.geometries[&key];
        check_triangle_count(self.triangles.len() + local_triangles.len())?;
        let transformed = |p: &[f64; 3]| {
            let q = transform * Vector4::new(p[0], p[1], p[2], 1.0);
            [q.x, q.y, q.z]
        };
        self.triangles.extend(local_triangles.iter().map(|corners| corners.each_ref().map(transformed)));
        Ok(())
    }

    /// Appends the triangles of a `mesh` element to `out`, in the frame and unit of the geometry.
    fn append_mesh(&mut self, mesh: Node<'a>, out: &mut Triangles) -> Result<(), String> {
        for primitive in mesh.children().filter(Node::is_element) {
            let kind = primitive.tag_name().name();
            match kind {
                "triangles" | "polylist" | "polygons" => {}
                "tristrips" | "trifans" => {
                    return Err(format!("it has <{kind}>, which is not read; export triangles"));
                }
                // Sources, vertices, lines and extensions.
                _ => continue,
            }
            let mut positions = None;
            let mut stride = 0;
            for input in child_elements(primitive, "input") {
                let offset = match input.attribute("offset").map(str::parse::<usize>) {
                    Some(Ok(offset)) if offset < 64 => offset,
                    None => 0,
                    Some(_) => return Err("an <input> has an offset that is none".to_owned()),
                };
                stride = stride.max(offset + 1);
                if input.attribute("semantic") == Some("VERTEX") {
                    positions = Some((offset, self.vertex_positions(self.referenced(input)?)?));
                }
            }
            let Some((offset, positions)) = positions else {
                return Err(format!("<{kind}> has no vertices"));
            };
            let counts = match child_elements(primitive, "vcount").next() {
                Some(vcount) => {
                    let counts = parse_indices(vcount)?;
                    self.count_numbers(counts.len())?;
                    Some(counts)
                }
                None => None,
            };
            for p in child_elements(primitive, "p") {
                let all = parse_indices(p)?;
                self.count_numbers(all.len())?;
                let corners: Vec<u32> = all.chunks_exact(stride).map(|chunk| chunk[offset]).collect();
                drop(all);
                let mut rest = &corners[..];
                let mut counts = counts.iter().flatten().copied();
                while !rest.is_empty() {
                    let count = match kind {
                        "triangles" => 3,
                        "polylist" => {
                            counts.next().ok_or("<vcount> counts fewer corners than there are")? as usize
                        }
                        _ => rest.len(),
                    };
                    if count > rest.len() {
                        return Err("a polygon has more corners than there are".to_owned());
                    }
                    let (polygon, after) = rest.split_at(count);
                    // Only a list of counts contains empty polygons, and the list is finite, so the loop ends.
                    rest = after;
                    append_polygon(polygon, &positions, out)?;
                }
            }
        }
        Ok(())
    }

    /// Positions of a `vertices` element, in the frame and unit of the geometry.
    fn vertex_positions(&mut self, vertices: Node<'a>) -> Result<Rc<Vec<[f64; 3]>>, String> {
        let key = vertices.range().start;
        if let Some(positions) = self.positions.get(&key) {
            return Ok(positions.clone());
        }
        let input = child_elements(vertices, "input").find(|i| i.attribute("semantic") == Some("POSITION"));
        let source = input.and_then(|i| self.resolve_reference(i)).ok_or("its vertices have no positions")?;
        let positions = self.source_positions(source)?;
        self.positions.insert(key, positions.clone());
        Ok(positions)
    }

    /// Positions of a `source` element, in the frame and unit of the geometry.
    fn source_positions(&mut self, source: Node<'a>) -> Result<Rc<Vec<[f64; 3]>>, String> {
        let key = source.range().start;
        if let Some(positions) = self.positions.get(&key) {
            return Ok(positions.clone());
        }
        let array = child_elements(source, "float_array").next().ok_or("a <source> has no <float_array>")?;
        let accessor =
            child_elements(source, "technique_common").flat_map(|t| child_elements(t, "accessor")).next();
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
        let mut positions = Vec::new();
        let mut position = [0.0; 3];
        for (i, word) in array.text().unwrap_or("").split_ascii_whitespace().enumerate() {
            let value = word.parse::<f64>().ok().filter(|value| value.is_finite());
            let value = value.ok_or_else(|| invalid_word_message(array, word, "finite number"))?;
            let Some(i) = i.checked_sub(first) else { continue };
            if let Some(axis) = position.get_mut(i % stride) {
                *axis = value;
            }
            if i % stride == stride - 1 {
                positions.push(position);
            }
            self.count_numbers(1)?;
        }
        let positions = Rc::new(positions);
        self.positions.insert(key, positions.clone());
        Ok(positions)
    }

    /// Adds to the number of positions and indices read, and checks the limit.
    fn count_numbers(&mut self, numbers: usize) -> Result<(), String> {
        self.numbers += numbers;
        if self.numbers > MAX_MESH_NUMBERS { Err(too_many_numbers_message()) } else { Ok(()) }
    }
}

fn too_many_numbers_message() -> String {
    format!("more than {MAX_MESH_NUMBERS} numbers; simplify the mesh")
}

/// Appends a polygon as a fan of triangles about its first corner. `polygon`: indices into `positions`.
fn append_polygon(polygon: &[u32], positions: &[[f64; 3]], out: &mut Triangles) -> Result<(), String> {
    let at = |i: u32| {
        positions
            .get(i as usize)
            .copied()
            .ok_or_else(|| format!("a face names vertex {i} of {}", positions.len()))
    };
    for k in 2..polygon.len() {
        out.push([at(polygon[0])?, at(polygon[k - 1])?, at(polygon[k])?]);
        check_triangle_count(out.len())?;
    }
    Ok(())
}

/// Transform of a `matrix`, `rotate`, `translate` or `scale` element; `None` for an element of another kind.
fn transform_of_element(node: Node<'_>) -> Result<Option<Matrix4<f64>>, String> {
    let name = node.tag_name().name();
    let count = match name {
        "matrix" => 16,
        "rotate" => 4,
        "translate" | "scale" => 3,
        "lookat" | "skew" => return Err(format!("a node has <{name}>, which is not read")),
        _ => return Ok(None),
    };
    let v = parse_finite_numbers(node)?;
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
