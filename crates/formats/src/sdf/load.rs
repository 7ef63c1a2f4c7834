//! Construction of a mechanism from a model in SDFormat.

use crate::hull::collision_shapes;
use crate::parts::Parts;
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::findings::Findings;
use crate::reading::limits::LONGEST_NAME;
use crate::reading::report::{Report, cut};
use crate::sdf::document::files::read_files;
use crate::sdf::elements::selection::select_model;
use crate::sdf::frames::poses::resolve_poses;
use crate::sdf::frames::walk::{collect_scopes, model_name};
use crate::sdf::tree::assembly::assemble;
use crate::shape::Shape;
use crate::urdf::load::{LoadOptions, Loaded};
use crate::{LoadError, Source};
use percuss_mechanism::{Problem, Subject};

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
    let tree = findings.tree;
    let name = model_name(tree, selected.model);
    let mechanism = parts.build(
        cut(name, LONGEST_NAME),
        options.accept,
        (&shapes, |_, own| collision_shapes(own)),
        |element, subject, problem| locate(tree, &parts, element, subject, problem),
        findings,
    )?;
    Some(Loaded::new(mechanism, shapes))
}

/// Element of a finding of the builder, given the element of its part; `None` for a finding that has another message, or that SDFormat
/// does not have.
fn locate(
    tree: &ElementTree,
    parts: &Parts,
    element: ElementId,
    subject: &Subject,
    problem: &Problem,
) -> Option<ElementId> {
    let origin = match subject {
        Subject::Link { index, .. } => parts.links.get(*index).map(|(_, origin)| origin),
        _ => None,
    };
    let has_default_inertia = origin.is_some_and(|origin| origin.has_default_inertia);
    let within: &[&str] = match problem {
        // Frames, the ground and the links of chains have no mass.
        Problem::Massless if origin.is_some_and(|origin| origin.link.is_none()) => return None,
        // The missing inertia is reported.
        Problem::WideInertia { .. }
        | Problem::DenseInertia { .. }
        | Problem::InertiaBeyondShape { .. }
        | Problem::ComBeyondShape { .. }
            if has_default_inertia =>
        {
            return None;
        }
        Problem::EqualInertias { .. } if parts.links.iter().any(|(_, origin)| origin.has_default_inertia) => {
            return None;
        }
        // SDFormat normalises every axis.
        Problem::AxisNotUnit { .. } => return None,
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
    within.iter().try_fold(element, |element, tag| tree.child(element, tag)).or(Some(element))
}
