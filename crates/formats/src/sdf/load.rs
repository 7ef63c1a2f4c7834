//! Construction of a mechanism from a model in SDFormat.

use crate::hull::{build_with_shapes, collision_shapes};
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::limits::LONGEST_NAME;
use crate::reading::report::{Report, cut};
use crate::sdf::document::files::read_files;
use crate::sdf::elements::selection::select_model;
use crate::sdf::frames::poses::resolve_poses;
use crate::sdf::frames::walk::{collect_scopes, model_name};
use crate::sdf::tree::assembly::assemble;
use crate::sdf::tree::parts::Parts;
use crate::shape::Shape;
use crate::urdf::load::{LoadOptions, Loaded};
use crate::{LoadError, Source};
use percuss_mechanism::{Mechanism, MechanismBuilder, Problem, Subject};

/// Reads a model. `text`: the decoded text of `source`; `report`: findings about its bytes. The name `FILE#MODEL` selects a model of the
/// file.
pub(crate) fn load_text(
    source: &Source,
    text: &str,
    options: &LoadOptions,
    report: Report,
) -> Result<Loaded, LoadError> {
    let (file, wanted) = (source.file(), source.model());
    let files = read_files(&source.files, (file, wanted), text, report);
    Loaded::from_files(files, |findings| read_model(wanted, options, findings))
}

/// Mechanism, and shapes of its links; `None` after an error.
fn read_model(wanted: Option<&str>, options: &LoadOptions, findings: &mut Findings<'_>) -> Option<Loaded> {
    let selected = select_model(wanted, findings)?;
    let mut scopes = collect_scopes(selected.container, selected.model, findings);
    if findings.has_errors() {
        return None;
    }
    scopes.resolve_attachments(findings.tree);
    resolve_poses(&mut scopes, findings);
    if findings.has_errors() {
        return None;
    }
    let (parts, mut bodies) = assemble(&scopes, selected.model, findings)?;
    let of_links = parts.links.iter().map(|(_, origin)| match origin.link {
        Some(link) => bodies.get_mut(link).and_then(Option::take).unwrap_or_default(),
        None => Vec::new(),
    });
    let shapes: Vec<Vec<Shape>> = of_links.collect();
    let name = model_name(findings.tree, selected.model);
    let mechanism = build_mechanism(name, &parts, &shapes, options, findings)?;
    Some(Loaded::new(mechanism, shapes))
}

/// Builds the mechanism; findings of the builder get the positions of their elements.
fn build_mechanism(
    name: &str,
    parts: &Parts,
    shapes: &[Vec<Shape>],
    options: &LoadOptions,
    findings: &mut Findings<'_>,
) -> Option<Mechanism> {
    let mut builder = MechanismBuilder::new(cut(name, LONGEST_NAME));
    builder = parts.links.iter().map(|(link, _)| link.clone()).fold(builder, MechanismBuilder::link);
    builder = parts.joints.iter().map(|(joint, _)| joint.clone()).fold(builder, MechanismBuilder::joint);
    builder =
        parts.closures.iter().map(|(closure, _)| closure.clone()).fold(builder, MechanismBuilder::closure);
    builder = parts
        .couplings
        .iter()
        .map(|(coupling, _)| coupling.clone())
        .fold(builder, MechanismBuilder::coupling);
    let (mechanism, found) =
        build_with_shapes(builder, options.accept, shapes, |_, own| collision_shapes(own));
    for (subject, problem) in found {
        if !is_expected(parts, &subject, &problem) {
            let element = locate(findings.tree, parts, &subject, &problem);
            findings.add(problem.severity(), problem.code(), element, || problem.to_string());
        }
    }
    mechanism
}

/// True for a finding of the builder that has another message, or that SDFormat does not have.
fn is_expected(parts: &Parts, subject: &Subject, problem: &Problem) -> bool {
    match (subject, problem) {
        // Frames, the ground and the links of chains have no mass.
        (Subject::Link { index, .. }, Problem::Massless) => {
            parts.links.get(*index).is_some_and(|(_, origin)| origin.link.is_none())
        }
        // The missing inertia is reported.
        (
            Subject::Link { index, .. },
            Problem::WideInertia { .. }
            | Problem::DenseInertia { .. }
            | Problem::InertiaBeyondShape { .. }
            | Problem::ComBeyondShape { .. },
        ) => parts.links.get(*index).is_some_and(|(_, origin)| origin.has_default_inertia),
        (Subject::Mechanism, Problem::EqualInertias { .. }) => {
            parts.links.iter().any(|(_, origin)| origin.has_default_inertia)
        }
        // SDFormat normalises every axis.
        (_, Problem::AxisNotUnit { .. }) => true,
        _ => false,
    }
}

/// Element of a finding of the builder.
fn locate(tree: &ElementTree, parts: &Parts, subject: &Subject, problem: &Problem) -> ElementId {
    let element = match subject {
        Subject::Link { index, .. } => parts.links.get(*index).map(|(_, origin)| origin.element),
        Subject::Joint { index, .. } => parts.joints.get(*index).map(|(_, element)| *element),
        Subject::Closure { index, .. } => parts.closures.get(*index).map(|(_, element)| *element),
        Subject::Coupling { index, .. } => parts.couplings.get(*index).map(|(_, element)| *element),
        Subject::Mechanism | Subject::Contact { .. } => None,
    };
    let element = element.unwrap_or_else(|| tree.root());
    let within: &[&str] = match problem {
        Problem::NegativeMass { .. } | Problem::InertiaWithoutMass { .. } => &["inertial", "mass"],
        Problem::IndefiniteInertia { .. }
        | Problem::TriangleInequality { .. }
        | Problem::WideInertia { .. }
        | Problem::DenseInertia { .. }
        | Problem::InertiaBeyondShape { .. } => &["inertial", "inertia"],
        Problem::ComBeyondShape { .. } => &["inertial", "pose"],
        Problem::LimitsReversed { .. } => &["axis", "limit"],
        _ => &[],
    };
    within.iter().try_fold(element, |element, tag| tree.child(element, tag)).unwrap_or(element)
}
