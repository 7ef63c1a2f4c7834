//! m̄ over the surfaces of links at one pose.

use crate::checks::findings::{point_mass_base_finding, singular_map_finding};
use crate::evaluation::passed_stops::passed_stop_findings;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::map::contact_findings::{MapResults, OF_POSE, map_contact_findings};
use crate::map::map_report::{
    Extreme, LinkMap, MapAnswer, MapReport, OmittedLink, OrientationRecord, SkinFacets,
};
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::pose::positions::{PoseLayout, Positions};
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::ContactTable;
use crate::question::tables::map::{MapQuestion, MapShapes};
use crate::reports::mass_report::ConditionsRecord;
use crate::thresholds::{EDGES_ACROSS, FACETS, LEAST_EDGE};
use percuss_dynamics::{Contact, ContactColumns, ContactMap, ContactStatus, MapAnswers, Pose};
use percuss_formats::{DEFAULT_MAX_MESH_SIZE, Facet, MeshFolders, Purpose, Shape, Surface, SurfaceError};
use percuss_mechanism::LinkId;
use rayon::prelude::*;
use std::cell::RefCell;

/// Number of contacts per work item of a thread.
const CONTACTS_PER_TASK: usize = 1 << 14;

/// Reason for a link without a map.
enum LinkMapError {
    /// Fault of the link; the link can be omitted.
    NoSurface(String),
    /// Error of the question.
    Question(StudyError),
}

/// Evaluates a contact at every facet of the surfaces of links, along the outward normal. The contact of `conditions` is ignored, except its
/// other side.
///
/// # Errors
/// [`StudyError`]: unknown names, an unreachable pose; for named links, a missing or unreadable shape. With
/// [`MapQuestion::all`] such links are listed in `left_out`; a map without any link is an error.
pub fn map(
    model: &Model,
    conditions: &MassQuestion,
    question: &MapQuestion,
) -> Result<MapAnswer, StudyError> {
    if question.directions.is_some() || question.point.is_some() {
        let why = "they belong to a map at a point; expected neither `directions` nor `point` for a map of surfaces";
        return Err(InvalidKey::new("map.directions", why).into());
    }
    let mechanism = &model.mechanism;
    let edge = question.edge.map(|edge| edge.0);
    if let Some(edge) = edge.filter(|e| !(e.is_finite() && *e >= LEAST_EDGE)) {
        let why = format!("the longest edge is {edge} m; expected a number of at least {LEAST_EDGE:e} m");
        return Err(StudyError::input("map.edge", why));
    }
    let find = |name: &String| mechanism.find_link(name).map_err(StudyError::about("contact.link"));
    let links: Vec<LinkId> = match question.all {
        true => mechanism.link_ids().collect(),
        false => question.link.iter().map(find).collect::<Result<_, _>>()?,
    };
    let mut conditions = question_with_placeholder_contact(model, conditions);
    conditions.contact.estimate = None;
    let prepared = PreparedQuestion::new(model, &conditions)?;
    let pose = prepared.pose()?;
    let mut found = prepared.pose_findings(&pose);
    found.extend(point_mass_base_finding(&prepared.system));
    found.extend(passed_stop_findings(&prepared, &pose));
    let mut diagnostics: Vec<DiagnosticRecord> = model.diagnostics.clone();
    diagnostics.extend(found.into_iter().map(DiagnosticRecord::from));
    let folders = model.mesh_folders(question.package.clone());
    let meshes = RefCell::new(Vec::new());
    let context = MapContext { model, question, folders, meshes: &meshes, prepared: &prepared, pose: &pose };
    let (mut maps, mut skins, mut left_out) = (Vec::new(), Vec::new(), Vec::new());
    let mut facets_left = FACETS;
    for link in links {
        let name = mechanism.link(link).name();
        match context.map_link(link, facets_left) {
            Ok((map, skin, found)) => {
                for finding in found {
                    if !diagnostics.contains(&finding) {
                        diagnostics.push(finding);
                    }
                }
                facets_left -= skin.facets.len();
                maps.push(map);
                skins.push(skin);
            }
            Err(LinkMapError::NoSurface(fault)) if question.all => {
                left_out.push(OmittedLink { link: name.to_owned(), reason: fault });
            }
            Err(LinkMapError::NoSurface(fault)) => return Err(StudyError::input("contact.link", fault)),
            Err(LinkMapError::Question(error)) => return Err(error),
        }
    }
    if maps.is_empty() {
        let reasons: Vec<String> = left_out.iter().take(3).map(|l| l.reason.clone()).collect();
        let why = format!("no link has a surface that can be mapped: {}", reasons.join("; "));
        return Err(StudyError::input("contact.link", why));
    }
    diagnostics.extend(singular_map_finding(&pose).map(DiagnosticRecord::from));
    let report = MapReport {
        schema: "percuss.map/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: prepared.inputs().into_iter().chain(meshes.take()).collect(),
        links: maps,
        left_out,
        edge,
        against: prepared.other_link().map(|id| mechanism.link(id).name().to_owned()),
        conditions: ConditionsRecord::of(&conditions),
        singular_pose: pose.rank().singular,
        degrees_of_freedom: pose.degrees_of_freedom(),
        pose: Positions::from_pose(&PoseLayout::new(mechanism), &pose),
        diagnostics,
    };
    Ok(MapAnswer { report, skins })
}

/// Question with a valid contact, required by `PreparedQuestion`; the contact itself is not evaluated.
pub(crate) fn question_with_placeholder_contact(model: &Model, conditions: &MassQuestion) -> MassQuestion {
    let given = &conditions.contact;
    let link =
        model.mechanism.links().iter().map(|l| l.name()).find(|name| Some(*name) != given.against.as_deref());
    let contact = ContactTable {
        link: Some(link.unwrap_or_default().to_owned()),
        ..given.with_normal([1.0, 0.0, 0.0], given.normal_frame())
    };
    MassQuestion { contact, ..conditions.clone() }
}

/// Shapes of a purpose; `Auto` takes collision shapes, or visual shapes if there are none.
fn select_shapes(shapes: &[Shape], which: MapShapes) -> (Purpose, Vec<&Shape>) {
    let of = |purpose| shapes.iter().filter(|s| s.purpose == purpose).collect::<Vec<_>>();
    match which {
        MapShapes::Visual => (Purpose::Visual, of(Purpose::Visual)),
        MapShapes::Collision => (Purpose::Collision, of(Purpose::Collision)),
        MapShapes::Auto => match of(Purpose::Collision) {
            none if none.is_empty() => (Purpose::Visual, of(Purpose::Visual)),
            some => (Purpose::Collision, some),
        },
    }
}

/// Question at the pose of the map.
struct MapContext<'a> {
    model: &'a Model,
    question: &'a MapQuestion,
    folders: MeshFolders,
    /// Mesh files read so far.
    meshes: &'a RefCell<Vec<Input>>,
    prepared: &'a PreparedQuestion<'a>,
    pose: &'a Pose,
}

impl MapContext<'_> {
    /// Map of one link with at most `facets_left` facets.
    fn map_link(
        &self,
        link: LinkId,
        facets_left: usize,
    ) -> Result<(LinkMap, SkinFacets, Vec<DiagnosticRecord>), LinkMapError> {
        let (question, prepared) = (self.question, self.prepared);
        let name = self.model.mechanism.link(link).name();
        let no_shape = || {
            LinkMapError::NoSurface(format!(
                "link \"{name}\" has no shape that can be used: no <collision> and no <visual> with a geometry"
            ))
        };
        if prepared.other_link() == Some(link) {
            return Err(LinkMapError::NoSurface(format!("link \"{name}\" is the other side")));
        }
        let shapes = self.model.shapes.get(link.index()).ok_or_else(no_shape)?;
        let (purpose, shapes) = select_shapes(shapes, question.shapes);
        let surface =
            Surface::read(shapes, &self.folders, question.max_mesh_size.unwrap_or(DEFAULT_MAX_MESH_SIZE))
                .map_err(|error| LinkMapError::NoSurface(format!("link \"{name}\": {error}")))?;
        for file in surface.files() {
            let mut meshes = self.meshes.borrow_mut();
            let input = Input::from_file(&*self.folders.files, file).filter(|input| !meshes.contains(input));
            meshes.extend(input);
        }
        let (centre, radius) = surface.bounds().ok_or_else(no_shape)?;
        let edge = question.edge.map_or(2.0 * radius / EDGES_ACROSS, |edge| edge.0).max(f64::MIN_POSITIVE);
        let too_many = |error: SurfaceError| {
            LinkMapError::Question(StudyError::input("map.edge", format!("link \"{name}\": {error}")))
        };
        let facets = surface.facets(edge, facets_left).map_err(too_many)?;
        if facets.is_empty() {
            return Err(no_shape());
        }
        let map = self
            .pose
            .contact_map(link, prepared.other_link(), centre, radius)
            .map_err(|error| LinkMapError::Question(StudyError::input("contact.link", error)))?;
        let mut skin = self.evaluate_facets(link, facets, &map);
        let found = self.findings(link, &skin);
        if let Some(other) = prepared.other_mass() {
            add_free_body(&mut skin, other);
        }
        let has_mesh = surface.orientation().pieces > 0;
        let orientation = has_mesh.then(|| OrientationRecord::from(surface.orientation()));
        Ok((summarize_link(&skin, purpose, orientation), skin, found))
    }

    /// Findings about the contacts of a link; the messages of all but those of the pose name the link.
    fn findings(&self, link: LinkId, skin: &SkinFacets) -> Vec<DiagnosticRecord> {
        let at = |i: usize| {
            let Facet { point, normal, .. } = &skin.facets[i];
            Contact { against: self.prepared.other_link(), ..Contact::new(link, *point, *normal) }
        };
        let (statuses, errors) = (&skin.statuses, &skin.errors);
        let results = MapResults { statuses, errors, contact: at, word: "contact of the map" };
        let mut found = map_contact_findings(self.prepared, self.pose, &results);
        let is_of_pose =
            |finding: &&mut DiagnosticRecord| OF_POSE.iter().any(|kind| kind.code() == finding.code);
        for finding in found.iter_mut().filter(|finding| !is_of_pose(finding)) {
            finding.message = format!("link \"{}\": {}", skin.link, finding.message);
        }
        found
    }

    /// Evaluates all facets in parallel.
    fn evaluate_facets(&self, link: LinkId, facets: Vec<Facet>, map: &ContactMap<'_>) -> SkinFacets {
        let count = facets.len();
        let points: [Vec<f64>; 3] =
            std::array::from_fn(|k| facets.iter().map(|facet| facet.point[k]).collect());
        let normals: [Vec<f64>; 3] =
            std::array::from_fn(|k| facets.iter().map(|facet| facet.normal[k]).collect());
        let mut masses = vec![f64::NAN; count];
        let mut errors = vec![f64::NAN; count];
        let mut statuses = vec![ContactStatus::Unanswered; count];
        let portions = masses.par_chunks_mut(CONTACTS_PER_TASK).zip(errors.par_chunks_mut(CONTACTS_PER_TASK));
        let portions = portions.zip(statuses.par_chunks_mut(CONTACTS_PER_TASK)).enumerate();
        portions.for_each(|(i, ((masses, errors), statuses))| {
            let part = i * CONTACTS_PER_TASK..i * CONTACTS_PER_TASK + masses.len();
            let [points, normals] =
                [&points, &normals].map(|c| c.each_ref().map(|column| &column[part.clone()]));
            let mut answers = MapAnswers { masses, relative_errors: errors, statuses };
            // The call cannot fail: all columns have the same length.
            let _ = map.fill_answers(ContactColumns { points, normals }, &mut answers);
        });
        let name = self.model.mechanism.link(link).name();
        SkinFacets { link: name.to_owned(), frame: self.pose.link(link), facets, masses, errors, statuses }
    }
}

/// Adds a free body on the other side: 1/m̄ = 1/m̄₁ + 1/m₂.
fn add_free_body(skin: &mut SkinFacets, other: f64) {
    for ((mass, error), status) in skin.masses.iter_mut().zip(&mut skin.errors).zip(&mut skin.statuses) {
        match *status {
            ContactStatus::Finite => {
                let together = *mass / (1.0 + *mass / other);
                // dm̄/m̄ = (m̄/m̄₁) dm̄₁/m̄₁, plus the rounding of this formula.
                *error = *error * together / *mass + 4.0 * f64::EPSILON;
                *mass = together;
            }
            ContactStatus::Immovable => {
                (*status, *mass, *error) = (ContactStatus::Finite, other, 4.0 * f64::EPSILON);
            }
            _ => {}
        }
    }
}

/// Counts, extremes and area mean of the contacts of a link.
fn summarize_link(skin: &SkinFacets, purpose: Purpose, orientation: Option<OrientationRecord>) -> LinkMap {
    let count = |status| skin.statuses.iter().filter(|s| **s == status).count();
    let finite = || (0..skin.facets.len()).filter_map(|i| Some((i, skin.mass(i)?)));
    let smallest = finite().min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| extreme(skin, i));
    let largest = finite().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| extreme(skin, i));
    // The mean of 1/m̄ exists on any surface; m̄ itself is unbounded near immovable contacts.
    let inverse: f64 = finite().map(|(i, m)| skin.facets[i].area / m).sum();
    let has_mass = |i: &usize| matches!(skin.statuses[*i], ContactStatus::Finite | ContactStatus::Immovable);
    let area: f64 = (0..skin.facets.len()).filter(has_mass).map(|i| skin.facets[i].area).sum();
    let has_mean = inverse > 0.0 && count(ContactStatus::Massless) == 0;
    let errors = finite().map(|(i, _)| skin.errors[i]).filter(|e| e.is_finite());
    LinkMap {
        link: skin.link.clone(),
        shapes: purpose.name(),
        contacts: skin.facets.len(),
        finite: count(ContactStatus::Finite),
        immovable: count(ContactStatus::Immovable),
        massless: count(ContactStatus::Massless),
        unanswered: count(ContactStatus::Unanswered),
        area: skin.facets.iter().map(|f| f.area).sum(),
        smallest,
        largest,
        area_mean: has_mean.then(|| area / inverse),
        worst_relative_error: errors.reduce(f64::max),
        orientation,
    }
}

/// Record of the contact at facet `i`, as smallest or largest mass.
fn extreme(skin: &SkinFacets, i: usize) -> Extreme {
    let record = skin.record(i);
    Extreme {
        effective_mass: skin.masses[i],
        effective_mass_error: record.effective_mass_error,
        point_link: record.point_link,
        normal_link: record.normal_link,
        point_world: record.point_world,
        normal_world: skin.frame.vector(&skin.facets[i].normal).into(),
    }
}
