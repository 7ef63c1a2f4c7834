//! Inertias of the bodies: declared, or computed from the geoms; then changed by the settings of `<compiler>`.

use crate::mjcf::bodies::body::Body;
use crate::mjcf::bodies::geom::{Geom, GeomShape};
use crate::mjcf::bodies::mesh::Meshes;
use crate::mjcf::bodies::solids::{self, UnitInertia};
use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::models::Models;
use crate::mjcf::values::orientation::read_pose;
use crate::mjcf::values::settings::{InertiaFromGeom, Settings};
use crate::reading::document::element_tree::ElementId;
use crate::reading::findings::Findings;
use percuss_mechanism::{Inertial, Severity};
use percuss_spatial::{Matrix3, Transform, Vector3};

/// Geoms with less mass do not count, kg, as in MuJoCo.
const LEAST_GEOM_MASS: f64 = 1e-14;

/// Reads `<inertial>` in a frame of its body; `None`, with an error, without mass or position.
pub(crate) fn read_inertial(
    attributes: Attributes<'_>,
    x_bf: &Transform<f64>,
    settings: &Settings,
    findings: &mut Findings<'_>,
) -> Option<Inertial> {
    let element = attributes.element;
    for name in ["pos", "mass"] {
        if attributes.text(name).is_none() {
            findings
                .error("missing-attribute", element, || format!("<inertial> has no attribute \"{name}\""));
        }
    }
    let frame = *x_bf * read_pose(attributes, settings, findings);
    let full = attributes.numbers::<6>("fullinertia", findings);
    let principal = attributes.numbers::<3>("diaginertia", findings);
    let turned = ["quat", "axisangle", "xyaxes", "zaxis", "euler"]
        .into_iter()
        .find(|name| full.is_some() && attributes.text(name).is_some());
    if let Some(name) = turned {
        findings.attribute_error("two-orientations", element, name, || {
            format!("fullinertia and {name} are both given; fullinertia is in the axes of the body")
        });
    }
    if full.is_some() && principal.is_some() {
        findings.attribute_error("two-inertias", element, "diaginertia", || {
            "fullinertia and diaginertia are both given; one of them is expected".to_owned()
        });
    }
    let tensor = match (full, principal) {
        (Some([xx, yy, zz, xy, xz, yz]), _) => Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
        (None, Some(moments)) => Matrix3::from_diagonal(&moments.into()),
        (None, None) => {
            findings.note("partial-inertial", element, || {
                "neither diaginertia nor fullinertia: a point mass (MuJoCo refuses it for a body that moves)".to_owned()
            });
            Matrix3::zeros()
        }
    };
    let mass = attributes.number("mass", findings)?;
    Some(Inertial { mass, com: frame.translation, about_com: turn(&frame.rotation, &tensor) })
}

/// R T Rᵀ, exactly symmetric.
pub(crate) fn turn(rotation: &Matrix3<f64>, tensor: &Matrix3<f64>) -> Matrix3<f64> {
    if *rotation == Matrix3::identity() {
        return *tensor;
    }
    let turned = rotation * tensor * rotation.transpose();
    turned * 0.5 + turned.transpose() * 0.5
}

/// Inertias of all bodies; `None` for a body without mass and inertia, and for the world.
pub(crate) fn body_inertias(
    bodies: &[Body],
    meshes: &mut Meshes<'_>,
    models: &Models<'_>,
    findings: &mut Findings<'_>,
) -> Vec<Option<Inertial>> {
    let mut inertias = vec![None; bodies.len()];
    for (inertia, body) in inertias.iter_mut().zip(bodies).skip(1) {
        let settings = models.settings(body.element);
        let mut own = body_inertia(body, meshes, settings, findings);
        let bounded = apply_bounds(&mut own, settings);
        if bounded {
            findings.add_once(Severity::Warning, "changed-inertia", "bound", body.element, || {
                "boundmass or boundinertia of <compiler> raised the mass or a moment of the body".to_owned()
            });
        }
        if settings.balance_inertia && balance(&mut own) {
            findings.add_once(Severity::Warning, "changed-inertia", "balance", body.element, || {
                "balanceinertia of <compiler> replaced the moments of the body by their mean: no body has moments A + B < C"
                    .to_owned()
            });
        }
        *inertia = own;
    }
    let total: f64 = inertias.iter().flatten().map(|inertia: &Inertial| inertia.mass).sum();
    if let Some(wanted) = models.main().total_mass.filter(|_| total > 0.0) {
        let factor = wanted / total;
        for inertia in inertias.iter_mut().flatten() {
            inertia.mass *= factor;
            inertia.about_com *= factor;
        }
        findings.add_once(Severity::Warning, "changed-inertia", "total", bodies[0].element, || {
            format!("settotalmass of <compiler> scaled all masses and inertias by {factor}, from {total} kg to {wanted} kg")
        });
    }
    inertias
}

/// Inertia of a body before the changes of the compiler.
fn body_inertia(
    body: &Body,
    meshes: &mut Meshes<'_>,
    settings: &Settings,
    findings: &mut Findings<'_>,
) -> Option<Inertial> {
    let declared = body.inertial.map(|(inertial, _)| inertial);
    let from_geoms = match settings.inertia_from_geom {
        InertiaFromGeom::Never => false,
        InertiaFromGeom::Always => true,
        InertiaFromGeom::WithoutInertial => declared.is_none(),
    };
    if !from_geoms {
        return declared;
    }
    inertia_of_geoms(body, meshes, settings, findings).or(declared)
}

/// Inertia of the geoms in the groups that count; `None` if they have no mass.
fn inertia_of_geoms(
    body: &Body,
    meshes: &mut Meshes<'_>,
    settings: &Settings,
    findings: &mut Findings<'_>,
) -> Option<Inertial> {
    let [first, last] = settings.inertia_groups;
    let counts = |geom: &&Geom| geom.group >= first && geom.group <= last && geom.mass != Some(0.0);
    let mut parts: Vec<Inertial> = Vec::new();
    for geom in body.geoms.iter().filter(counts) {
        let part = geom_inertia(geom, body.moving_ancestor == 0, meshes, findings);
        parts.extend(part.filter(|part| part.mass > LEAST_GEOM_MASS));
    }
    match parts[..] {
        [] => None,
        // A single part is returned without rounding.
        [part] => Some(part),
        _ => Some(sum(&parts)),
    }
}

/// Inertia of one body made of several.
pub(crate) fn sum(parts: &[Inertial]) -> Inertial {
    let mass: f64 = parts.iter().map(|part| part.mass).sum();
    let com = parts.iter().map(|part| part.com * part.mass).sum::<Vector3<f64>>() / mass;
    let about_com = parts.iter().map(|part| {
        let arm = part.com - com;
        part.about_com
            + (Matrix3::from_diagonal_element(arm.norm_squared()) - arm * arm.transpose()) * part.mass
    });
    Inertial { mass, com, about_com: about_com.sum() }
}

/// Inertia of a geom in the frame of its body; `None` for a shape without mass, or, with an error, if it cannot be computed.
/// `is_fixed`: the body cannot move, so that an unknown inertia is only a warning.
fn geom_inertia(
    geom: &Geom,
    is_fixed: bool,
    meshes: &mut Meshes<'_>,
    findings: &mut Findings<'_>,
) -> Option<Inertial> {
    let refuse = |findings: &mut Findings<'_>, what: &str| {
        let severity = if is_fixed { Severity::Warning } else { Severity::Error };
        findings.add(severity, "unsupported", geom.element, || {
            format!(
                "the inertia of {what} is not computed; give the body an <inertial>, or the geom mass=\"0\""
            )
        });
        None
    };
    let unit = match &geom.shape {
        GeomShape::Solid(solid) => solids::unit_inertia(solid, geom.is_shell)?,
        GeomShape::Ellipsoid { semi_axes } if !geom.is_shell => solids::ellipsoid(*semi_axes),
        GeomShape::Ellipsoid { .. } => return refuse(findings, "the shell of an ellipsoid"),
        // A body that cannot move needs no inertia, so that no mesh is opened for it.
        GeomShape::Mesh(_) if is_fixed => return None,
        GeomShape::Mesh(name) => {
            let mesh = meshes.inertia(name, geom.element, geom.is_shell, findings)?;
            let density = geom.mass.map_or(geom.density, |mass| mass / mesh.volume);
            return Some(Inertial {
                mass: geom.mass.unwrap_or(density * mesh.volume),
                com: geom.frame.point(&mesh.com),
                about_com: turn(&geom.frame.rotation, &(mesh.about_com * density)),
            });
        }
        GeomShape::FittedToMesh => return refuse(findings, "a primitive shape that MuJoCo fits to a mesh"),
        GeomShape::DistanceField => return refuse(findings, "a signed distance field"),
        GeomShape::Plane | GeomShape::HeightField => {
            if !is_fixed {
                findings.error("moving-plane", geom.element, || {
                    "planes and height fields belong to bodies that cannot move".to_owned()
                });
            }
            return None;
        }
    };
    Some(primitive_inertia(geom, unit))
}

/// Inertia of a primitive shape with the mass or the density of its geom.
fn primitive_inertia(geom: &Geom, unit: UnitInertia) -> Inertial {
    let mass = geom.mass.unwrap_or(geom.density * unit.volume);
    let tensor = Matrix3::from_diagonal(&Vector3::from(unit.moments)) * mass;
    Inertial { mass, com: geom.frame.translation, about_com: turn(&geom.frame.rotation, &tensor) }
}

/// Raises the mass and the principal moments to the bounds. Returns true if a value changed.
fn apply_bounds(inertia: &mut Option<Inertial>, settings: &Settings) -> bool {
    if settings.bound_mass <= 0.0 && settings.bound_inertia <= 0.0 {
        return false;
    }
    let massless = Inertial { mass: 0.0, com: Vector3::zeros(), about_com: Matrix3::zeros() };
    let mut own = inertia.unwrap_or(massless);
    let mut changed = own.mass < settings.bound_mass;
    own.mass = own.mass.max(settings.bound_mass);
    if settings.bound_inertia > 0.0 {
        let principal = own.about_com.symmetric_eigen();
        if principal.eigenvalues.min() < settings.bound_inertia {
            changed = true;
            let moments = principal.eigenvalues.map(|moment| moment.max(settings.bound_inertia));
            own.about_com = turn(&principal.eigenvectors, &Matrix3::from_diagonal(&moments));
        }
    }
    if changed {
        *inertia = Some(own);
    }
    changed
}

/// Replaces moments A + B < C by their mean. Returns true if the moments changed.
fn balance(inertia: &mut Option<Inertial>) -> bool {
    let Some(inertia) = inertia else { return false };
    let moments = inertia.about_com.symmetric_eigenvalues();
    let (sum, largest) = (moments.sum(), moments.max());
    let is_impossible = sum - largest < largest;
    // A rounding error of a thin plate, for which A + B = C, is not balanced.
    let is_impossible = is_impossible && 2.0 * largest - sum > f64::EPSILON * largest * 8.0;
    if is_impossible {
        inertia.about_com = Matrix3::from_diagonal_element(sum / 3.0);
    }
    is_impossible
}

/// Element of the inertia of a body, for findings.
pub(crate) fn inertia_element(body: &Body) -> ElementId {
    body.inertial.map_or(body.element, |(_, element)| element)
}
