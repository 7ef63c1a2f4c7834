//! Construction of a mechanism from a model in MJCF.

use crate::mjcf::bodies::body::{Bodies, Body, Site};
use crate::mjcf::bodies::geom::GeomShape;
use crate::mjcf::bodies::inertia::{body_inertias, inertia_element};
use crate::mjcf::bodies::mesh::Meshes;
use crate::mjcf::bodies::walk::read_bodies;
use crate::mjcf::chain::{Chains, build_chains};
use crate::mjcf::document::attach::attach_models;
use crate::mjcf::document::check::check_element;
use crate::mjcf::document::files::{AttachedModel, read_files};
use crate::mjcf::document::grammar::ROOT;
use crate::mjcf::relations::actuator::reflected_armatures;
use crate::mjcf::relations::equality::{BodyClosure, Constraints, EqualityReader};
use crate::mjcf::relations::keyframe::{qpos_layout, read_keyframes};
use crate::mjcf::relations::tendon::read_tendons;
use crate::mjcf::values::models::Models;
use crate::reading::document::element_tree::ElementTree;
use crate::reading::findings::Findings;
use crate::reading::limits::{LONGEST_NAME, MAX_ELEMENTS_PER_KIND};
use crate::reading::report::{Report, cut};
use crate::reading::unique_names::UniqueNames;
use crate::shape::Shape;
use crate::urdf::load::{LoadOptions, Loaded};
use crate::{LoadError, SharedFiles, Source};
use percuss_mechanism::{
    ClosureDescription, ContactDescription, ContactKind, ContactNormal, Geometry, Problem, Subject,
};
use percuss_spatial::Vector3;
use std::collections::HashSet;

/// Reads a model. `text`: the decoded text of `source`; `report`: findings about its bytes.
pub(crate) fn load_text(
    source: &Source,
    text: &str,
    options: &LoadOptions,
    report: Report,
) -> Result<Loaded, LoadError> {
    let (mut files, models) = read_files(source, text, report);
    // After an error of a file the tree may be empty.
    if !files.reports.iter().any(Report::has_errors) {
        let mut findings = Findings::new(&files.tree, files.reports);
        models.iter().for_each(|model| check_element(model.root, &ROOT, &mut findings));
        files.reports = findings.into_reports();
        if !files.reports.iter().any(Report::has_errors) {
            attach_models(&mut files, &models);
        }
    }
    Loaded::from_files(files, |findings| read_model(&models, &source.files, options, findings))
}

/// Contents of a model; `None` after an error.
fn read_model(
    models: &[AttachedModel],
    files: &SharedFiles,
    options: &LoadOptions,
    findings: &mut Findings<'_>,
) -> Option<Loaded> {
    let tree = findings.tree;
    let models = Models::read(models, findings);
    let mut bodies = read_bodies(&models, findings);
    if findings.has_errors() {
        return None;
    }
    let tendons = read_tendons(&models, &bodies, findings);
    let added = reflected_armatures(&models, &bodies, &tendons, findings);
    let reader = EqualityReader { models: &models, bodies: &bodies, tendons: &tendons };
    let Constraints { closures, joints: mut relations } = reader.read(findings);
    if closures.len() > MAX_ELEMENTS_PER_KIND {
        findings.error("too-complex", tree.root(), || {
            format!("{} constraints; at most {MAX_ELEMENTS_PER_KIND} are read", closures.len())
        });
    }
    for ((body, position), armature) in added.joints {
        bodies.bodies[body].joints[position].armature += armature;
    }
    let mut meshes = Meshes::read(files, &models, findings);
    let inertias = body_inertias(&bodies.bodies, &mut meshes, &models, findings);
    if findings.has_errors() {
        return None;
    }
    let body_shapes: Vec<(Vec<Shape>, bool)> = bodies
        .bodies
        .iter()
        .map(|body| {
            let own = shapes(body, &meshes, findings);
            let is_whole = own.len() == body.geoms.len();
            (own, is_whole)
        })
        .collect();
    let extents = bodies.bodies.iter().map(extent).collect();
    let sums = match relations.sums() {
        Ok(sums) => sums,
        Err(element) => {
            findings.error("contradiction", element, || {
                "other constraints lock all joints of this one, at other positions".to_owned()
            });
            return None;
        }
    };
    let mut chains = build_chains(&bodies, inertias, extents, &mut relations, &added.rotors, sums);
    name_relations(closures, &mut chains, tree);
    chains.parts.contacts = named_contacts(tree, &bodies, &chains);
    let parts = &chains.parts;
    // Auxiliary links have no shapes.
    let mut of_bodies = body_shapes.into_iter();
    let of_links = parts.links.iter().map(|(_, origin)| origin.link.and_then(|_| of_bodies.next()));
    let (shapes, is_whole): (Vec<Vec<Shape>>, Vec<bool>) = of_links.map(Option::unwrap_or_default).unzip();
    let name = cut(tree.attribute(tree.root(), "model").unwrap_or("MuJoCo Model"), LONGEST_NAME);
    // A geom without a counterpart among the shapes may contain the mass.
    let whole = |link: usize, own| Vec::from_iter(<[Shape]>::iter(own).filter(|_| is_whole[link]));
    let is_auxiliary = |link: usize| parts.links.get(link).is_some_and(|(_, origin)| origin.link.is_none());
    let place = |element, subject: &Subject, problem: &Problem| match (subject, problem) {
        // The links within a body are massless, and so is a link without geoms in MJCF.
        (Subject::Link { index, .. }, Problem::Massless) if is_auxiliary(*index) => None,
        // MJCF normalises every axis.
        (_, Problem::AxisNotUnit { .. }) => None,
        (
            Subject::Link { name, .. },
            Problem::NegativeMass { .. }
            | Problem::IndefiniteInertia { .. }
            | Problem::TriangleInequality { .. }
            | Problem::WideInertia { .. }
            | Problem::DenseInertia { .. }
            | Problem::InertiaBeyondShape { .. }
            | Problem::ComBeyondShape { .. }
            | Problem::InertiaWithoutMass { .. },
        ) => {
            let body = bodies.body_by_name.get(name).map(|body| &bodies.bodies[*body]);
            Some(body.map_or(element, inertia_element))
        }
        _ => Some(element),
    };
    let mechanism = parts.build(name, options.accept, (&shapes, whole), place, findings)?;
    let qpos = qpos_layout(tree, &bodies, &chains, &mechanism);
    let poses = read_keyframes(&qpos, findings);
    Some(Loaded { poses, qpos: Some(qpos), files: meshes.opened, ..Loaded::new(mechanism, shapes) })
}

/// Adds the closures to the parts, and gives all closures and relations a name.
fn name_relations(closures: Vec<BodyClosure>, chains: &mut Chains, tree: &ElementTree) {
    let mut names = UniqueNames::default();
    names.reserve(closures.iter().map(|closure| closure.name.as_str()).filter(|name| !name.is_empty()));
    for BodyClosure { element, name, kind, ends, distance } in closures {
        let name = if name.is_empty() { names.take(tree.tag(element).to_owned()) } else { name };
        let [(first, predecessor_frame), (second, successor_frame)] = ends;
        let [first, second] = [first, second].map(|body| &chains.link_names[body]);
        let description = ClosureDescription::new(name, kind, first, second);
        let description = ClosureDescription { predecessor_frame, successor_frame, distance, ..description };
        chains.parts.closures.push((description, element));
    }
    for (relation, element) in &mut chains.parts.relations {
        let own = tree.attribute(*element, "name").unwrap_or_default();
        let given = [relation.name.as_str(), own, tree.tag(*element)];
        let name = given.into_iter().find(|name| !name.is_empty()).unwrap_or_default();
        relation.name = names.take(name.to_owned());
    }
}

/// Sites of moving bodies as contacts with the world, without those of constraints and tendons. The normal is the z-axis of the site
/// as drawn.
fn named_contacts(tree: &ElementTree, bodies: &Bodies, chains: &Chains) -> Vec<ContactDescription> {
    let in_constraints = ["equality", "tendon"].into_iter().flat_map(|section| tree.in_sections(section));
    let elements = in_constraints.flat_map(|id| [id].into_iter().chain(tree.children(id).iter().copied()));
    let used: HashSet<&str> = elements
        .flat_map(|id| {
            ["site", "site1", "site2"].into_iter().filter_map(move |name| tree.attribute(id, name))
        })
        .collect();
    let is_contact = |(name, site): &(&String, &Site)| {
        bodies.bodies[site.body].moving_ancestor != 0 && !used.contains(name.as_str())
    };
    let moving = bodies.sites.iter().filter(is_contact);
    let contact = |(name, site): (&String, &Site)| ContactDescription {
        name: name.clone(),
        kind: ContactKind::Other,
        link: chains.link_names[site.body].clone(),
        point: site.frame.translation,
        against: chains.link_names[0].clone(),
        normal: ContactNormal::Fixed(
            (bodies.bodies[site.body].world_pose * site.frame).vector(&Vector3::z()),
        ),
        gap: None,
    };
    let mut contacts: Vec<ContactDescription> = moving.map(contact).collect();
    contacts.sort_by(|a, b| a.name.cmp(&b.name));
    contacts.truncate(MAX_ELEMENTS_PER_KIND);
    contacts
}

/// Shapes of a body: collision shapes first, then visual shapes.
fn shapes(body: &Body, meshes: &Meshes<'_>, findings: &mut Findings<'_>) -> Vec<Shape> {
    let mut found = Vec::new();
    for geom in &body.geoms {
        match geom.shape(|name| meshes.solid(name)) {
            Some(shape) => found.push(shape),
            None => findings.add_unread(geom.element, || {
                "<geom> of an unsupported type (plane, hfield, ellipsoid, sdf or fitted mesh)".to_owned()
            }),
        }
    }
    // Stable sort: shapes of one purpose keep the order of the file.
    found.sort_by_key(|shape: &Shape| shape.purpose);
    found
}

/// Extent of the shapes of a body; unknown if one of them is a mesh.
fn extent(body: &Body) -> Geometry {
    let is_mesh = |shape: &GeomShape| matches!(shape, GeomShape::Mesh(_) | GeomShape::FittedToMesh);
    if body.geoms.iter().any(|geom| is_mesh(&geom.shape)) {
        return Geometry::Mesh;
    }
    let radius = body.geoms.iter().filter_map(|geom| geom.radius()).reduce(f64::max);
    radius.map_or(Geometry::None, Geometry::Within)
}
