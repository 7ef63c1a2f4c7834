//! `percuss-probe`: results in JSON, for comparison with other programs.
//!
//! One request on the standard input (a model, a base, configurations, contacts), one result on the standard output:
//! diagnostics, mass matrices, poses, contact rows and effective masses. For a file that does not load, the result
//! contains the errors; an invalid request ends with a message on the standard error and exit code 2. The README in
//! this folder describes the layout. All values come from the public interface of the crates.

use nalgebra::{DMatrix, Quaternion, UnitQuaternion, Vector3};
use percuss_dynamics::{
    Base, Conditions, Contact, ContactResponse, EffectiveMass, Pose, ResponseError, Route, RouteChoice,
    System,
};
use percuss_formats::{DEFAULT_MAX_SIZE, Diagnostic, LoadOptions, Loaded, Source, load};
use percuss_mechanism::{Accept, Mechanism};
use percuss_spatial::Transform;
use percuss_tests::routes::reason;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::process::ExitCode;

/// Name of the floating base among the coordinates.
const BASE: &str = "<base>";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    /// Path of a URDF.
    model: String,
    /// Accepts inertias with a negative moment.
    #[serde(default)]
    accept_indefinite_inertia: bool,
    #[serde(default)]
    base: BaseKind,
    #[serde(default)]
    configurations: Vec<ConfigurationRequest>,
}

#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum BaseKind {
    #[default]
    Fixed,
    Floating,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ConfigurationRequest {
    /// Joint name to position; other joints are at zero.
    #[serde(default)]
    joints: BTreeMap<String, Vec<f64>>,
    /// Pose of the root link in the world: x,y,z,w,x,y,z.
    base: Option<[f64; 7]>,
    #[serde(default)]
    contacts: Vec<ContactRequest>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ContactRequest {
    link: String,
    /// The other side; `None`: the ground.
    against: Option<String>,
    /// In the link's frame, m.
    point: [f64; 3],
    /// In the link's frame, out of the link.
    normal: [f64; 3],
}

#[derive(Default, Serialize)]
struct Answer {
    loaded: bool,
    diagnostics: Vec<DiagnosticAnswer>,
    /// Joint and velocity index for every column of M.
    coordinates: Vec<(String, usize)>,
    configurations: Vec<ConfigurationAnswer>,
}

#[derive(Serialize)]
struct DiagnosticAnswer {
    severity: &'static str,
    code: &'static str,
    line: Option<u32>,
    message: String,
}

#[derive(Serialize)]
struct ConfigurationAnswer {
    mass_matrix: Vec<Vec<f64>>,
    /// Every movable joint's position, mimics included.
    pose: BTreeMap<String, Vec<f64>>,
    contacts: Vec<ContactAnswer>,
}

#[derive(Serialize)]
struct ContactAnswer {
    row: Vec<f64>,
    point_world: [f64; 3],
    normal_world: [f64; 3],
    /// By the automatic route.
    #[serde(flatten)]
    chosen: ResponseAnswer,
    /// By the dense route.
    dense: ResponseAnswer,
}

#[derive(Serialize)]
struct ResponseAnswer {
    /// `finite`, `immovable`, `massless`, or `refused` with the reason in `error`.
    status: &'static str,
    effective_mass: Option<f64>,
    effective_mass_error: Option<f64>,
    route: Option<&'static str>,
    /// Reason for the dense route in addition to the recursion.
    careful_reason: Option<String>,
    condition: Option<f64>,
    error: Option<String>,
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("percuss-probe: {message}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<(), String> {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).map_err(|e| format!("the request cannot be read: {e}"))?;
    let request: Request = serde_json::from_str(&text).map_err(|e| format!("no request: {e}"))?;
    let answer = answer(&request)?;
    let json = serde_json::to_string(&answer).map_err(|e| format!("the answer cannot be written: {e}"))?;
    writeln!(std::io::stdout(), "{json}").map_err(|e| format!("the answer cannot be written: {e}"))
}

fn answer(request: &Request) -> Result<Answer, String> {
    let options = LoadOptions {
        accept: Accept { indefinite_inertia: request.accept_indefinite_inertia, ..Accept::default() },
        ..LoadOptions::default()
    };
    let loaded = Source::read(&request.model, DEFAULT_MAX_SIZE).and_then(|source| load(&source, &options));
    let Loaded { mechanism, diagnostics, .. } = match loaded {
        Ok(loaded) => loaded,
        Err(refused) => {
            let diagnostics = refused.diagnostics.iter().map(diagnostic).collect();
            return Ok(Answer { diagnostics, ..Answer::default() });
        }
    };
    let base = match request.base {
        BaseKind::Fixed => Base::Fixed,
        BaseKind::Floating => Base::Floating,
    };
    let system = System::new(mechanism, &Conditions::new().base(base)).map_err(|e| e.to_string())?;
    let one = |(i, wanted)| {
        configuration(&system, wanted).map_err(|message| format!("configuration {i}: {message}"))
    };
    Ok(Answer {
        loaded: true,
        diagnostics: diagnostics.iter().map(diagnostic).collect(),
        coordinates: coordinates(&system),
        configurations: request.configurations.iter().enumerate().map(one).collect::<Result<_, _>>()?,
    })
}

fn diagnostic(d: &Diagnostic) -> DiagnosticAnswer {
    let message = d.message.clone();
    DiagnosticAnswer { severity: d.severity.name(), code: d.code, line: d.line, message }
}

/// Joint and velocity number of every coordinate; the floating base has the name [`BASE`].
fn coordinates(system: &System) -> Vec<(String, usize)> {
    let name =
        |joint: Option<_>| joint.map_or(BASE.to_owned(), |id| system.mechanism().joint(id).name().to_owned());
    system.coordinate_joints().into_iter().map(|(joint, k)| (name(joint), k)).collect()
}

fn configuration(system: &System, wanted: &ConfigurationRequest) -> Result<ConfigurationAnswer, String> {
    let mut configuration = system.configuration();
    for (joint, values) in &wanted.joints {
        configuration.set(joint, values).map_err(|e| e.to_string())?;
    }
    if let Some(base) = wanted.base {
        configuration.set_base(base_transform(base)?);
    }
    let pose = system.pose(&configuration).map_err(|e| e.to_string())?;
    let one =
        |(i, wanted)| contact(system, &pose, wanted).map_err(|message| format!("contact {i}: {message}"));
    Ok(ConfigurationAnswer {
        mass_matrix: rows(&pose.mass_matrix()),
        pose: positions(system.mechanism(), &pose),
        contacts: wanted.contacts.iter().enumerate().map(one).collect::<Result<_, _>>()?,
    })
}

fn base_transform(values: [f64; 7]) -> Result<Transform<f64>, String> {
    let [x, y, z, w, i, j, k] = values;
    let quaternion = Quaternion::new(w, i, j, k);
    let norm = quaternion.norm();
    if !(values.iter().all(|v| v.is_finite()) && (norm - 1.0).abs() < 1e-6) {
        return Err(format!("the base {values:?} is no x,y,z and unit quaternion w,x,y,z"));
    }
    let rotation = UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix();
    Ok(Transform::new(rotation.into_inner(), Vector3::new(x, y, z)))
}

fn positions(mechanism: &Mechanism, pose: &Pose) -> BTreeMap<String, Vec<f64>> {
    let movable = mechanism.joint_ids().filter(|id| mechanism.joint(*id).kind().dofs() > 0);
    movable.map(|id| (mechanism.joint(id).name().to_owned(), pose.joint(id).to_vec())).collect()
}

fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

fn contact(system: &System, pose: &Pose, wanted: &ContactRequest) -> Result<ContactAnswer, String> {
    let find = |name: &str| system.mechanism().find_link(name).map_err(|e| e.to_string());
    let contact = Contact::new(find(&wanted.link)?, wanted.point, wanted.normal);
    let contact = match &wanted.against {
        Some(other) => contact.against(find(other)?),
        None => contact,
    };
    let located = pose.locate(&contact).map_err(|e| e.to_string())?;
    let condition = pose.condition();
    Ok(ContactAnswer {
        row: pose.contact_row(&located),
        point_world: located.point_world.into(),
        normal_world: located.normal_world.into(),
        chosen: response(pose.respond(&contact), condition),
        dense: response(pose.respond_by_route(&contact, RouteChoice::Only(Route::Dense)), condition),
    })
}

fn response(answer: Result<ContactResponse, ResponseError>, condition: Option<f64>) -> ResponseAnswer {
    let response = match answer {
        Ok(response) => response,
        Err(error) => {
            return ResponseAnswer {
                status: "refused",
                effective_mass: None,
                effective_mass_error: None,
                route: None,
                careful_reason: None,
                condition: None,
                error: Some(error.to_string()),
            };
        }
    };
    let (status, effective_mass) = match response.effective_mass {
        EffectiveMass::Finite(mass) => ("finite", Some(mass)),
        EffectiveMass::Immovable => ("immovable", None),
        EffectiveMass::Massless => ("massless", None),
    };
    let route = match response.route {
        Route::Dense => "dense",
        Route::Articulated => "articulated",
    };
    ResponseAnswer {
        status,
        effective_mass,
        effective_mass_error: response.effective_mass_error(),
        route: Some(route),
        careful_reason: response.dense_reason.as_ref().map(reason),
        condition,
        error: None,
    }
}
