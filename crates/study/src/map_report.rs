//! A map as plain data: what is said of every link, and its facets.

use crate::mass_report::ConditionsRecord;
use crate::model::Input;
use crate::positions::Positions;
use crate::record::DiagnosticRecord;
use percuss_dynamics::ContactStatus;
use percuss_formats::{Facet, Orientation};
use percuss_spatial::Transform;
use serde::ser::{Serialize, SerializeSeq, Serializer};

/// A contact of a map where m̄ is smallest or largest.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Extreme {
    /// m̄, kg.
    pub effective_mass: f64,
    /// What it may be off by, kg; null where unknown.
    pub effective_mass_error: Option<f64>,
    /// m, link's frame.
    pub point_link: [f64; 3],
    /// Unit vector out of the link, link's axes.
    pub normal_link: [f64; 3],
    /// m.
    pub point_world: [f64; 3],
    /// Unit vector out of the link.
    pub normal_world: [f64; 3],
}

/// What was done so that normals of meshes point outward.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct OrientationRecord {
    /// Connected pieces of the meshes.
    pub pieces: usize,
    /// Triangles that were turned over.
    pub turned: usize,
    /// Pieces without an inside: turned away from the centre of their mesh.
    pub open: usize,
    /// Pieces that cannot be turned alike.
    pub conflicting: usize,
}

impl From<&Orientation> for OrientationRecord {
    fn from(o: &Orientation) -> Self {
        Self { pieces: o.pieces, turned: o.turned, open: o.open, conflicting: o.conflicting }
    }
}

/// What is said of a link.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct LinkMap {
    /// The link.
    pub link: String,
    /// Which shapes make its surface: `collision` or `visual`.
    pub shapes: &'static str,
    /// How many contacts: one in each facet, along its outward normal.
    pub contacts: usize,
    /// How many of them have a mass.
    pub finite: usize,
    /// How many no motion yields at.
    pub immovable: usize,
    /// How many a motion without mass yields at.
    pub massless: usize,
    /// How many have no answer.
    pub unanswered: usize,
    /// Area of the surface, m².
    pub area: f64,
    /// Where m̄ is smallest; null where none is finite.
    pub smallest: Option<Extreme>,
    /// Where it is largest among the finite ones.
    pub largest: Option<Extreme>,
    /// Mean over the area, kg: 1 over the mean of 1/m̄, which is 0 where it is immovable. Null where it is nowhere finite, or
    /// somewhere massless.
    pub area_mean: Option<f64>,
    /// The largest relative error stated; null where none is known.
    pub worst_relative_error: Option<f64>,
    /// What was done to the windings of meshes; null without a mesh.
    pub orientation: Option<OrientationRecord>,
}

/// A link that is not in the map.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct LeftOut {
    /// The link.
    pub link: String,
    /// Why.
    pub reason: String,
}

/// `percuss map`, as JSON. Keys are always present, null where they do not apply.
#[derive(Clone, Debug, serde::Serialize)]
pub struct MapReport {
    /// `percuss.map/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The files.
    pub inputs: Vec<Input>,
    /// The links.
    pub links: Vec<LinkMap>,
    /// Links that are not in it.
    pub left_out: Vec<LeftOut>,
    /// Longest edge of a facet asked for, m; null: a part of each link's size.
    pub edge: Option<f64>,
    /// The other link; null: the ground.
    pub against: Option<String>,
    /// What it was asked under.
    pub conditions: ConditionsRecord,
    /// Whether the pose is singular: every m̄ is a lower bound there.
    pub singular_pose: bool,
    /// dim ker A at the pose, a floating base's 6 included.
    pub degrees_of_freedom: usize,
    /// Where the joints stand.
    pub pose: Positions,
    /// Warnings and notes.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// The facets of a link and m̄ on each.
#[derive(Clone, Debug)]
pub struct SkinFacets {
    /// The link.
    pub link: String,
    /// X_wl: the link in the world.
    pub frame: Transform<f64>,
    /// In the link's frame.
    pub facets: Vec<Facet>,
    /// m̄, kg; NaN unless finite or massless.
    pub masses: Vec<f64>,
    /// Relative; NaN where unknown.
    pub errors: Vec<f64>,
    /// What each is.
    pub statuses: Vec<ContactStatus>,
}

/// A contact of a map.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FacetRecord<'a> {
    /// The link.
    pub link: &'a str,
    /// m, link's frame.
    pub point_link: [f64; 3],
    /// Unit vector out of the link.
    pub normal_link: [f64; 3],
    /// m.
    pub point_world: [f64; 3],
    /// Area of its facet, m².
    pub area: f64,
    /// `finite`, `immovable`, `massless` or `no answer`.
    pub status: &'static str,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// What it may be off by, kg; null where unknown.
    pub effective_mass_error: Option<f64>,
}

/// As it stands in JSON and CSV.
pub(crate) fn name_of(status: ContactStatus) -> &'static str {
    match status {
        ContactStatus::Finite => "finite",
        ContactStatus::Immovable => "immovable",
        ContactStatus::Massless => "massless",
        ContactStatus::Unanswered => "no answer",
    }
}

impl SkinFacets {
    /// m̄ of a facet, kg; none unless finite.
    pub fn mass(&self, i: usize) -> Option<f64> {
        (self.statuses[i] == ContactStatus::Finite).then_some(self.masses[i])
    }

    /// A contact.
    pub fn record(&self, i: usize) -> FacetRecord<'_> {
        let facet = &self.facets[i];
        let mass = self.mass(i);
        FacetRecord {
            link: &self.link,
            point_link: facet.point.into(),
            normal_link: facet.normal.into(),
            point_world: self.frame.point(&facet.point).into(),
            area: facet.area,
            status: name_of(self.statuses[i]),
            effective_mass: mass,
            effective_mass_error: mass.map(|m| m * self.errors[i]).filter(|e| e.is_finite()),
        }
    }

    /// All contacts.
    pub fn records(&self) -> impl Iterator<Item = FacetRecord<'_>> {
        (0..self.facets.len()).map(|i| self.record(i))
    }
}

/// A map: what is said, and what it is said of.
#[derive(Clone, Debug)]
pub struct MapAnswer {
    /// What is said.
    pub report: MapReport,
    /// The facets of the links, in the order of the report's.
    pub skins: Vec<SkinFacets>,
}

/// As JSON with all contacts: the keys of the report, and `contacts`.
impl Serialize for MapAnswer {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Whole<'a> {
            #[serde(flatten)]
            report: &'a MapReport,
            contacts: Contacts<'a>,
        }
        Whole { report: &self.report, contacts: Contacts(&self.skins) }.serialize(serializer)
    }
}

struct Contacts<'a>(&'a [SkinFacets]);

impl Serialize for Contacts<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(None)?;
        for record in self.0.iter().flat_map(SkinFacets::records) {
            list.serialize_element(&record)?;
        }
        list.end()
    }
}
