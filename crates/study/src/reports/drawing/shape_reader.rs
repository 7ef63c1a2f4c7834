//! Triangles of the shapes of links.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::thresholds::FACETS;
use percuss_formats::{DEFAULT_MAX_MESH_SIZE, MeshFolders, Purpose, Shape, Surface};
use percuss_mechanism::LinkId;

/// Largest extent of a shape of the root link, as a multiple of the characteristic length. A larger shape is
/// taken for the surroundings (a floor, a hall) and is not drawn.
const FAR_SHAPE: f64 = 5.0;

/// Reader of the shapes of links, with the number of triangles that may still be read.
pub(super) struct ShapeReader<'a> {
    model: &'a Model,
    folders: MeshFolders,
    triangles_left: usize,
    /// Mesh files read.
    pub meshes: Vec<Input>,
    /// Shapes that are not drawn, with the reason.
    pub diagnostics: Vec<DiagnosticRecord>,
}

impl<'a> ShapeReader<'a> {
    /// Reader of the shapes of a model; meshes are searched from the folder of the model file.
    pub fn new(model: &'a Model) -> Self {
        let folders = model.mesh_folders(Vec::new());
        Self { model, folders, triangles_left: FACETS, meshes: Vec::new(), diagnostics: Vec::new() }
    }

    /// Triangles of a link, m, in its frame, from `<visual>`, otherwise from `<collision>`.
    pub fn link_triangles(&mut self, link: LinkId) -> Vec<[[f64; 3]; 3]> {
        let all = self.model.shapes.get(link.index()).map_or(&[][..], Vec::as_slice);
        let of = |purpose| all.iter().filter(move |shape: &&Shape| shape.purpose == purpose);
        let any_visual = of(Purpose::Visual).next().is_some();
        let shapes = of(if any_visual { Purpose::Visual } else { Purpose::Collision });
        let surface = match Surface::read(shapes, &self.folders, DEFAULT_MAX_MESH_SIZE) {
            Ok(surface) => surface,
            Err(error) => {
                self.add_omitted_shape(link, error.to_string());
                return Vec::new();
            }
        };
        // A floor would shrink the mechanism to a small part of the drawing.
        let far = FAR_SHAPE * self.model.mechanism.characteristic_length();
        let reach = surface.bounds().map_or(0.0, |(centre, radius)| centre.norm() + radius);
        if link == self.model.mechanism.root() && reach > far {
            self.add_omitted_shape(link, format!("it reaches {reach:.3} m, far beyond the mechanism"));
            return Vec::new();
        }
        for file in surface.files() {
            let input = Input::from_file(&*self.folders.files, file);
            self.meshes.extend(input.filter(|input| !self.meshes.contains(input)));
        }
        // Infinite edge length: as few triangles as possible.
        match surface.facets(f64::INFINITY, self.triangles_left) {
            Ok(facets) => {
                self.triangles_left -= facets.len();
                facets.iter().map(|facet| facet.corners.map(Into::into)).collect()
            }
            Err(error) => {
                self.add_omitted_shape(link, error.to_string());
                Vec::new()
            }
        }
    }

    /// Records a shape that is not drawn, with the reason.
    fn add_omitted_shape(&mut self, link: LinkId, why: String) {
        let link = self.model.mechanism.link(link).name();
        let message = format!("link \"{link}\" is drawn without its shape: {why}");
        self.diagnostics.push(Finding::about_result(FindingKind::ShapeNotDrawn, message).into());
    }
}
