//! Report of a map: a summary of each link, and the facets.

use crate::model::loading::Input;
use crate::model::record::DiagnosticRecord;
use crate::pose::positions::Positions;
use crate::reports::mass_report::ConditionsRecord;
use percuss_dynamics::ContactStatus;
use percuss_formats::{Facet, Orientation};
use percuss_spatial::Transform;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// Contact with the smallest or largest m̄.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Extreme {
    /// m̄, kg.
    pub effective_mass: f64,
    /// Error bound of m̄, kg; null if unknown.
    pub effective_mass_error: Option<f64>,
    /// Contact point, link's frame, m.
    pub point_link: [f64; 3],
    /// Unit normal out of the link, link's axes.
    pub normal_link: [f64; 3],
    /// Contact point, world frame, m.
    pub point_world: [f64; 3],
    /// Unit normal out of the link, world axes.
    pub normal_world: [f64; 3],
}

/// Orientation of mesh triangles, so that the normals point outward.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OrientationRecord {
    /// Connected pieces of the meshes.
    pub pieces: usize,
    /// Number of reversed triangles.
    pub turned: usize,
    /// Open pieces without an interior; the normals point away from the centre of the mesh.
    pub open: usize,
    /// Pieces without a consistent orientation.
    pub conflicting: usize,
}

impl From<&Orientation> for OrientationRecord {
    fn from(o: &Orientation) -> Self {
        Self { pieces: o.pieces, turned: o.turned, open: o.open, conflicting: o.conflicting }
    }
}

/// Summary of a link.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LinkMap {
    /// The link.
    pub link: String,
    /// Shapes that form the surface: `collision` or `visual`.
    pub shapes: &'static str,
    /// Number of contacts, one per facet, along the outward normal.
    pub contacts: usize,
    /// Number of contacts with a finite m̄.
    pub finite: usize,
    /// Number of immovable contacts: no motion closes the gap.
    pub immovable: usize,
    /// Number of massless contacts: a motion without mass closes the gap.
    pub massless: usize,
    /// Number of contacts without a result.
    pub unanswered: usize,
    /// Area of the surface, m².
    pub area: f64,
    /// Contact with the smallest m̄; null without a finite m̄.
    pub smallest: Option<Extreme>,
    /// Contact with the largest finite m̄.
    pub largest: Option<Extreme>,
    /// Harmonic mean of m̄ over the area, kg: 1 over the mean of 1/m̄; 1/m̄ is 0 at immovable contacts. Null if
    /// no contact is finite or any contact is massless.
    pub area_mean: Option<f64>,
    /// Largest stated relative error; null if unknown.
    pub worst_relative_error: Option<f64>,
    /// Orientation of the mesh triangles; null without a mesh.
    pub orientation: Option<OrientationRecord>,
}

/// Link omitted from the map.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OmittedLink {
    /// The link.
    pub link: String,
    /// Reason.
    pub reason: String,
}

/// Report of `percuss map`, as JSON. All keys are always present; a value is null if not applicable.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct MapReport {
    /// `percuss.map/1`.
    #[schemars(extend("const" = "percuss.map/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Summaries of the links.
    pub links: Vec<LinkMap>,
    /// Omitted links.
    pub left_out: Vec<OmittedLink>,
    /// Requested longest edge of a facet, m; null for a fraction of each link's size.
    pub edge: Option<f64>,
    /// Other link; null for the ground.
    pub against: Option<String>,
    /// Conditions of the question.
    pub conditions: ConditionsRecord,
    /// True if the pose is singular; every m̄ is then a lower bound.
    pub singular_pose: bool,
    /// dim ker A at the pose, including the 6 of a floating base.
    pub degrees_of_freedom: usize,
    /// Joint positions.
    pub pose: Positions,
    /// Warnings and notes.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Facets of a link and m̄ at each facet.
#[derive(Clone, Debug)]
pub struct SkinFacets {
    /// The link.
    pub link: String,
    /// X_wl: transform from link to world coordinates.
    pub frame: Transform<f64>,
    /// Facets in the link's frame.
    pub facets: Vec<Facet>,
    /// m̄, kg; NaN unless finite or massless.
    pub masses: Vec<f64>,
    /// Relative error bounds; NaN if unknown.
    pub errors: Vec<f64>,
    /// Kinds of results.
    pub statuses: Vec<ContactStatus>,
}

/// Contact of a map.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FacetRecord<'a> {
    /// The link.
    pub link: &'a str,
    /// Contact point, link's frame, m.
    pub point_link: [f64; 3],
    /// Unit normal out of the link, link's axes.
    pub normal_link: [f64; 3],
    /// Contact point, world frame, m.
    pub point_world: [f64; 3],
    /// Area of the facet, m².
    pub area: f64,
    /// `finite`, `immovable`, `massless` or `no answer`.
    pub status: &'static str,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// Error bound of m̄, kg; null if unknown.
    pub effective_mass_error: Option<f64>,
}

/// Name of a status in JSON and CSV.
pub(crate) fn status_name(status: ContactStatus) -> &'static str {
    match status {
        ContactStatus::Finite => "finite",
        ContactStatus::Immovable => "immovable",
        ContactStatus::Massless | ContactStatus::MasslessToRounding => "massless",
        ContactStatus::Unanswered => "no answer",
    }
}

impl SkinFacets {
    /// m̄ of facet `i`, kg; `None` unless finite.
    pub fn mass(&self, i: usize) -> Option<f64> {
        (self.statuses[i] == ContactStatus::Finite).then_some(self.masses[i])
    }

    /// Record of contact `i`.
    pub fn record(&self, i: usize) -> FacetRecord<'_> {
        let facet = &self.facets[i];
        let mass = self.mass(i);
        FacetRecord {
            link: &self.link,
            point_link: facet.point.into(),
            normal_link: facet.normal.into(),
            point_world: self.frame.point(&facet.point).into(),
            area: facet.area,
            status: status_name(self.statuses[i]),
            effective_mass: mass,
            effective_mass_error: mass.map(|m| m * self.errors[i]).filter(|e| e.is_finite()),
        }
    }

    /// Records of all contacts.
    pub fn records(&self) -> impl Iterator<Item = FacetRecord<'_>> {
        (0..self.facets.len()).map(|i| self.record(i))
    }
}

/// Map: the report and the facets.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct MapAnswer {
    /// Report.
    #[serde(flatten)]
    pub report: MapReport,
    /// Contacts, one for each facet of the links, in the order of the report's links.
    #[serde(rename = "contacts", serialize_with = "contacts")]
    #[schemars(with = "Vec<FacetRecord<'_>>")]
    pub skins: Vec<SkinFacets>,
}

/// Serializes all contacts.
fn contacts<S: Serializer>(skins: &[SkinFacets], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(skins.iter().flat_map(SkinFacets::records))
}
