//! Mesh assets, and their inertias. A file is opened only if an inertia depends on it.

use crate::SharedFiles;
use crate::meshes::files::{DEFAULT_MAX_MESH_SIZE, MeshContents, MeshError, Triangles, read_mesh_file};
use crate::meshes::surface::hull::{HullDefect, convex_hull};
use crate::mjcf::bodies::mesh_inertia::{MeshInertia, MeshRule, mesh_inertia};
use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::classes::DefaultKind;
use crate::mjcf::values::models::Models;
use crate::mjcf::values::orientation::rotation_from_quat;
use crate::mjcf::values::settings::Settings;
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::{Findings, similar_name};
use crate::reading::limits::{MAX_HULL_WORK, MAX_INERTIA_TRIANGLES, MAX_MESH_BYTES, MAX_TOTAL_ATTRIBUTES};
use crate::reading::report::quoted;
use crate::shape::Solid;
use percuss_mechanism::Severity;
use percuss_spatial::{Matrix3, Transform, Vector3};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Mesh asset.
#[derive(Debug)]
struct Mesh {
    element: ElementId,
    /// File relative to the folder of the model; `None` for vertices in the model.
    file: Option<String>,
    scale: [f64; 3],
    /// Origin and orientation of the mesh in the coordinates of the file.
    reference: Transform<f64>,
    rule: MeshRule,
    /// Inertia in the frame of the mesh; computed at the first use. `None` inside: an error is reported.
    inertia: Option<Option<MeshInertia>>,
}

impl Mesh {
    /// Key of the inertia by a rule; `None` for vertices in the model.
    fn key(&self, rule: MeshRule) -> Option<MeshKey> {
        let values = self.scale.iter().chain(self.reference.rotation.iter());
        let values = values.chain(self.reference.translation.iter());
        Some((self.file.clone()?, rule, values.map(|value| value.to_bits()).collect()))
    }
}

/// Mesh assets by name.
#[derive(Debug)]
pub(crate) struct Meshes<'t> {
    tree: &'t ElementTree,
    files: SharedFiles,
    /// Folder of the main file.
    folder: PathBuf,
    meshes: HashMap<String, Mesh>,
    /// Files that were opened.
    pub opened: Vec<PathBuf>,
    /// Inertias by file, rule, scale and reference pose: files and hulls that several assets share are read and computed once.
    known: HashMap<MeshKey, Option<MeshInertia>>,
    /// Total number of triangles and total size of the files (bytes) that were read.
    triangles: usize,
    bytes: u64,
    /// Number of distances that hulls may still compute.
    hull_work: usize,
}

/// File with the scale and the pose of its mesh, as bits, and the rule of its inertia.
type MeshKey = (String, MeshRule, Vec<u64>);

impl<'t> Meshes<'t> {
    /// Reads the assets of a model. `files`: store of the mesh files.
    pub fn read(files: &SharedFiles, models: &Models<'_>, findings: &mut Findings<'t>) -> Self {
        let tree = findings.tree;
        let folder = Path::new(&tree.files[0].name).parent().map(Path::to_owned).unwrap_or_default();
        let mut meshes = HashMap::new();
        for element in tree.in_sections("asset").filter(|element| tree.tag(*element) == "mesh") {
            let attributes = models.attributes(element, DefaultKind::Mesh, None, findings);
            let settings = models.settings(element);
            let Some((name, mut mesh)) = read_mesh_asset(attributes, settings, findings) else { continue };
            let own = tree.model_of(element);
            if own > 0 {
                // Files of an attached model are in its folder.
                let file = tree.files.iter().find(|file| file.model == own);
                let own = file.and_then(|file| Path::new(&file.name).parent()).unwrap_or(Path::new(""));
                let own = own.strip_prefix(&folder).unwrap_or(own);
                mesh.file = mesh.file.map(|file| own.join(file).to_string_lossy().into_owned());
            }
            if meshes.insert(name, mesh).is_some() {
                findings.error("duplicate-name", element, || {
                    "the name of the mesh was given before; names must be unique".to_owned()
                });
            }
        }
        Self {
            tree,
            files: files.clone(),
            folder,
            meshes,
            opened: Vec::new(),
            known: HashMap::new(),
            triangles: 0,
            bytes: 0,
            hull_work: MAX_HULL_WORK,
        }
    }

    /// Solid of an asset for drawings, with the frame of its file in the geom; `None` for an unknown name or vertices in the model.
    pub fn solid(&self, name: &str) -> Option<(Solid, Transform<f64>)> {
        let mesh = self.meshes.get(name)?;
        let solid = Solid::Mesh { file: mesh.file.clone()?, scale: mesh.scale };
        // The scale acts along the axes of the rotated mesh; without a rotation it commutes with the shift.
        let shift = mesh.reference.translation.component_mul(&Vector3::from(mesh.scale));
        let is_turned = mesh.reference.rotation != Matrix3::identity();
        (!is_turned).then(|| (solid, Transform::from_translation(-shift)))
    }

    /// Inertia of an asset as a solid or shell, in the frame of the mesh; `None`, with an error at the geom, if it cannot be computed.
    pub fn inertia(
        &mut self,
        name: &str,
        geom: ElementId,
        is_shell: bool,
        findings: &mut Findings<'_>,
    ) -> Option<MeshInertia> {
        let Some(mesh) = self.meshes.get(name) else {
            findings.attribute_error("unknown-mesh", geom, "mesh", || {
                let guess = similar_name(name, self.meshes.keys().map(String::as_str));
                format!("the mesh {} does not exist{guess}", quoted(name))
            });
            return None;
        };
        if let Some(known) = mesh.inertia.filter(|_| !is_shell) {
            return known;
        }
        let rule = if is_shell { MeshRule::Shell } else { mesh.rule };
        let key = mesh.key(rule);
        let computed = match key.as_ref().and_then(|key| self.known.get(key)) {
            Some(known) => *known,
            None => self.compute(name, rule, geom, findings),
        };
        self.known.extend(key.map(|key| (key, computed)));
        if let Some(mesh) = self.meshes.get_mut(name).filter(|_| !is_shell) {
            mesh.inertia = Some(computed);
        }
        computed
    }

    /// Reads the triangles of a mesh and computes its inertia.
    fn compute(
        &mut self,
        name: &str,
        rule: MeshRule,
        geom: ElementId,
        findings: &mut Findings<'_>,
    ) -> Option<MeshInertia> {
        let mesh = self.meshes.get(name)?;
        let element = mesh.element;
        let (remedy, shown) = ("give the body an <inertial>", quoted(name));
        let refuse = |findings: &mut Findings<'_>, message: &dyn Fn() -> String| {
            findings.error("bad-mesh", element, message);
            None
        };
        let attributes = Attributes::new(self.tree, element);
        if rule == MeshRule::Convex
            && attributes.number("maxhullvert", findings).is_some_and(|most| most >= 0.0)
        {
            findings.attribute_error("unsupported", element, "maxhullvert", || {
                format!(
                    "the inertia of a convex hull with fewer vertices (maxhullvert) is not computed; {remedy}"
                )
            });
            return None;
        }
        let read = match &mesh.file {
            Some(file) => {
                let path = self.folder.join(file);
                let left = MAX_MESH_BYTES.saturating_sub(self.bytes);
                let read = read_mesh_file(&*self.files, &path, DEFAULT_MAX_MESH_SIZE.min(left));
                self.opened.push(path);
                match read {
                    Ok(MeshContents { mut triangles, in_first_shape, size }) => {
                        self.bytes += size;
                        // MuJoCo computes a hull of all vertices.
                        if rule != MeshRule::Convex && in_first_shape < triangles.len() {
                            findings.note("first-object", element, || {
                                format!(
                                    "only the first object or group of the file {} counts, as in MuJoCo: {in_first_shape} of {} triangles; \
                                     join the objects if all are meant",
                                    quoted(file),
                                    triangles.len()
                                )
                            });
                            triangles.truncate(in_first_shape);
                        }
                        Ok(triangles)
                    }
                    Err(MeshError::TooLarge { .. }) if left < DEFAULT_MAX_MESH_SIZE => Err(format!(
                        "the mesh files of the model have more than {} MiB in all",
                        MAX_MESH_BYTES >> 20
                    )),
                    Err(error) => Err(error.to_string()),
                }
            }
            None => inline_triangles(attributes, &mut self.hull_work, findings),
        };
        let triangles = match read {
            Ok(triangles) => triangles,
            Err(message) => {
                return refuse(findings, &|| {
                    format!("the inertia of a body depends on the mesh {shown}: {message}; or {remedy}")
                });
            }
        };
        self.triangles = self.triangles.saturating_add(triangles.len());
        if self.triangles > MAX_INERTIA_TRIANGLES {
            findings.error("too-complex", element, || {
                format!(
                    "the meshes of the inertias have more than {MAX_INERTIA_TRIANGLES} triangles; {remedy}"
                )
            });
            return None;
        }
        let mesh = self.meshes.get(name)?;
        let (scale, reference) = (Vector3::from(mesh.scale), mesh.reference);
        let place = |p: [f64; 3]| reference.inverse_point(&p.into()).component_mul(&scale).into();
        let triangles: Triangles = triangles.into_iter().map(|corners| corners.map(place)).collect();
        let hull = match rule {
            MeshRule::Convex => hull_of(&triangles, &mut self.hull_work),
            _ => Ok(triangles),
        };
        let triangles = match hull {
            Ok(triangles) => triangles,
            Err(message) => {
                return refuse(findings, &|| {
                    format!("the convex hull of the mesh {shown} is not computed: {message}; {remedy}")
                });
            }
        };
        let inertia = mesh_inertia(&triangles, rule);
        if inertia.volume <= 0.0 {
            let volume = inertia.volume;
            return refuse(findings, &|| {
                format!(
                    "the mesh {shown} encloses no volume ({volume} m³); its faces may be oriented inward: {remedy}"
                )
            });
        }
        let unit = if rule == MeshRule::Shell { "m²" } else { "m³" };
        let words = match rule {
            MeshRule::Legacy => {
                "legacy (absolute volumes of pyramids, wrong for hollow or concave meshes; \"exact\" is right)"
            }
            MeshRule::Exact => "exact",
            MeshRule::Shell => "shell",
            MeshRule::Convex => "convex",
        };
        findings.add_once(Severity::Note, "mesh-inertia", words, geom, || {
            format!("the inertia follows from the mesh {shown}: {:.6e} {unit}, rule {words}", inertia.volume)
        });
        Some(inertia)
    }
}

/// Name and description of a mesh asset; `None`, with an error, if it has no name.
fn read_mesh_asset(
    attributes: Attributes<'_>,
    settings: &Settings,
    findings: &mut Findings<'_>,
) -> Option<(String, Mesh)> {
    let file = attributes.text("file").map(str::trim);
    let base = |file: &str| file.rsplit(['/', '\\']).next().unwrap_or(file).to_owned();
    let stem = |file: &str| {
        let base = base(file);
        base.rsplit_once('.').map_or(base.clone(), |(stem, _)| stem.to_owned())
    };
    let Some(name) = attributes.text("name").map(str::to_owned).or_else(|| file.map(stem)) else {
        findings.error("missing-attribute", attributes.element, || {
            "<mesh> has neither a name nor a file".to_owned()
        });
        return None;
    };
    let rules = [
        ("convex", MeshRule::Convex),
        ("legacy", MeshRule::Legacy),
        ("exact", MeshRule::Exact),
        ("shell", MeshRule::Shell),
    ];
    let default = if settings.exact_mesh_inertia { MeshRule::Exact } else { MeshRule::Legacy };
    let rule = attributes.word("inertia", &rules, findings).unwrap_or(default);
    let rotation = attributes.numbers::<4>("refquat", findings).map(rotation_from_quat);
    if rotation == Some(None) {
        findings.attribute_error("zero-axis", attributes.element, "refquat", || {
            "refquat is zero; a quaternion w x y z is expected".to_owned()
        });
    }
    let file = file.map(|file| {
        let file = if settings.strip_path { base(file) } else { file.to_owned() };
        match settings.mesh_folder.as_str() {
            "" => file,
            folder => Path::new(folder).join(file).to_string_lossy().into_owned(),
        }
    });
    let mesh = Mesh {
        element: attributes.element,
        file,
        scale: attributes.numbers::<3>("scale", findings).unwrap_or([1.0; 3]),
        reference: Transform::new(
            rotation.flatten().unwrap_or_else(Matrix3::identity),
            attributes.numbers::<3>("refpos", findings).unwrap_or_default().into(),
        ),
        rule,
        inertia: None,
    };
    Some((name, mesh))
}

/// Triangles of the attributes `vertex` and `face`.
fn inline_triangles(
    attributes: Attributes<'_>,
    hull_work: &mut usize,
    findings: &mut Findings<'_>,
) -> Result<Triangles, String> {
    if attributes.text("builtin").is_some_and(|name| name != "none") {
        return Err("meshes that MuJoCo makes itself (builtin) are not computed; use a file".to_owned());
    }
    if attributes.text("vertex").is_none() {
        return Err("it has neither a file nor vertices".to_owned());
    }
    let invalid = || "its numbers are invalid".to_owned();
    let vertices = attributes.list("vertex", MAX_TOTAL_ATTRIBUTES, findings).ok_or_else(invalid)?;
    if attributes.text("face").is_none() {
        // Without faces the mesh is the convex hull of its vertices.
        let points: Vec<Vector3<f64>> = vertices.chunks_exact(3).map(Vector3::from_column_slice).collect();
        return hull_triangles(&points, hull_work);
    }
    let faces = attributes.list("face", MAX_TOTAL_ATTRIBUTES, findings).ok_or_else(invalid)?;
    let vertex = |index: f64| {
        let start = if index >= 0.0 && index.fract() == 0.0 {
            (index as usize).saturating_mul(3)
        } else {
            usize::MAX
        };
        let values = vertices.get(start..start.saturating_add(3));
        values
            .map(|v| [v[0], v[1], v[2]])
            .ok_or_else(|| format!("a face names vertex {index} of {} (the first is 0)", vertices.len() / 3))
    };
    let triangle = |corners: &[f64]| Ok([vertex(corners[0])?, vertex(corners[1])?, vertex(corners[2])?]);
    if faces.len() % 3 != 0 {
        return Err(format!("face has {} numbers; three for each triangle are expected", faces.len()));
    }
    faces.chunks_exact(3).map(triangle).collect()
}

/// Triangles of the convex hull of the corners of triangles.
pub(crate) fn hull_of(triangles: &Triangles, work: &mut usize) -> Result<Triangles, String> {
    let mut known = std::collections::HashSet::new();
    // Bits of the coordinates: corners of neighbouring triangles are equal.
    let corners = triangles.iter().flatten().filter(|p| known.insert(p.map(f64::to_bits)));
    let points: Vec<Vector3<f64>> = corners.map(|p| Vector3::from(*p)).collect();
    hull_triangles(&points, work)
}

/// Triangles of the convex hull of points.
fn hull_triangles(points: &[Vector3<f64>], work: &mut usize) -> Result<Triangles, String> {
    let faces = convex_hull(points, work).map_err(|defect| match defect {
        HullDefect::Flat => "its vertices lie in a plane".to_owned(),
        HullDefect::TooMuchWork => "the hulls of the model have too many vertices in all".to_owned(),
    })?;
    Ok(faces.into_iter().map(|face| face.map(|corner| points[corner].into())).collect())
}
