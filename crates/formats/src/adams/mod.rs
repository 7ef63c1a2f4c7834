//! Rigid parts and joints of a dataset of Adams Solver (`.adm`).
//!
//! | statement | read as |
//! |-----------|---------|
//! | `UNITS` | factors of all lengths and masses |
//! | `PART` | link; `IP` is about the marker `IM` (default `CM`), with products of inertia ∫ x y dm |
//! | `MARKER` | frame of its part |
//! | `JOINT` REVOLUTE, TRANSLATIONAL, CYLINDRICAL, SPHERICAL, UNIVERSAL, PLANAR, FIXED; `JPRIM` ATPOINT | joint of the spanning tree, or closure |
//!
//! Angles of `REULER` are those of body-fixed rotations about z, x, z: R = R_z(a) R_x(b) R_z(c). The z-axes of the markers I and J are the axis of a
//! joint, of a universal joint its two pins. Source: Adams Solver, statements PART, MARKER, JOINT, JPRIM, UNITS.

mod graph;
mod statements;

use crate::reading::findings::similar_name;
use crate::reading::report::{Place, Report, quoted};
use crate::urdf::load::{LoadOptions, Loaded};
use crate::{LoadError, Source};
use graph::{Connection, ConnectionKind, Marker, Part, mechanism_of};
use percuss_mechanism::{Built, Inertial, Subject};
use percuss_spatial::{Matrix3, Transform, Vector3};
use statements::{Statement, number, read};
use std::collections::{HashMap, HashSet};

/// Units of length (m) and of mass (kg).
const LENGTHS: [(&str, f64); 13] = [
    ("ANGSTROM", 1e-10),
    ("CENTIMETER", 1e-2),
    ("FOOT", 0.3048),
    ("KILOMETER", 1e3),
    ("INCH", 0.0254),
    ("METER", 1.0),
    ("MICROINCH", 2.54e-8),
    ("MICROMETER", 1e-6),
    ("MILE", 1609.344),
    ("MILLIMETER", 1e-3),
    ("MILS", 2.54e-5),
    ("NANOMETER", 1e-9),
    ("YARD", 0.9144),
];
const MASSES: [(&str, f64); 12] = [
    ("GRAM", 1e-3),
    ("KILOGRAM", 1.0),
    ("KPOUND_MASS", 453.59237),
    ("MILLIGRAM", 1e-6),
    ("MICROGRAM", 1e-9),
    ("NANOGRAM", 1e-12),
    ("OUNCE_MASS", 0.028_349_523_125),
    ("POUND_MASS", 0.453_592_37),
    // lbf s²/in and lbf s²/ft.
    ("SLINCH", 4.448_221_615_260_5 / 0.0254),
    ("SLUG", 4.448_221_615_260_5 / 0.3048),
    ("TONNE", 1e3),
    ("US_TON", 907.184_74),
];
/// Systems of units: length and mass.
const SYSTEMS: [(&str, &str, &str); 4] = [
    ("MKS", "METER", "KILOGRAM"),
    ("CGS", "CENTIMETER", "GRAM"),
    ("FPS", "FOOT", "POUND_MASS"),
    ("IPS", "INCH", "POUND_MASS"),
];

/// Statements without an influence on the motion of the parts.
const WITHOUT_EFFECT: &str = "ACCGRAV ADAMS ANALYSIS ARRAY CURVE DEBUG EQUILIBRIUM FEMDATA FINISH GRAPHICS GRAPHIC HOTPOINTS IC INTEGRATOR \
    KINEMATICS LIST LSOLVER MATERIAL MATRIX MREQUEST OUTPUT PINPUT PLANT POINT POUTPUT PREFERENCES REQUEST RESULTS SENSOR SPLINE STRING SURFACE \
    TITLE VARIABLE GSE LSE TFSISO DIFF TIMER MESH PARAMETER";
/// Forces: they have no influence on effective masses.
const FORCES: &str =
    "BEAM BUSHING CONTACT FIELD FRICTION GFORCE MFORCE NFORCE SFORCE SPRINGDAMPER TIRE VFORCE VTORQUE";

/// Arguments of the statements that are read; those without an influence on the pose and the masses are included.
const ARGUMENTS: [(&str, &str); 5] = [
    ("UNITS", "SYSTEM FORCE LENGTH MASS TIME UCF"),
    (
        "PART",
        "GROUND MASS CM IM IP QG REULER XG ZG VX VY VZ WX WY WZ VM WM EXACT MATERIAL RM USEXP FLEX_BODY POINT_MASS CURVE SURFACE FLOATING",
    ),
    ("MARKER", "PART QP REULER XP ZP XG ZG USEXP RM FLEX_BODY POINT_MASS CURVE SURFACE FLOATING NODE_ID"),
    (
        "JOINT",
        "I J IC ICTRAN ICROT REVOLUTE TRANSLATIONAL CYLINDRICAL SPHERICAL UNIVERSAL PLANAR FIXED HOOKE CONVEL RACKPIN SCREW PD PITCH",
    ),
    ("JPRIM", "I J ATPOINT INPLANE INLINE ORIENTATION PARALLEL_AXES PERPENDICULAR"),
];

/// True for a file with the ending of a dataset.
pub(crate) fn is_dataset(source: &Source) -> bool {
    let name = source.file().to_ascii_lowercase();
    name.ends_with(".adm") && !source.bytes.trim_ascii_start().starts_with(b"<")
}

/// Reads a dataset.
pub(crate) fn load_dataset(source: &Source, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let mut report = Report::default();
    let Some(text) = source.text(&mut report) else {
        return Err(LoadError { diagnostics: report.finish(&source.name, "") });
    };
    source.refuse_model("a dataset of Adams", &mut report);
    let loaded = Reader { report: &mut report, length: 0.0, mass: 0.0 }.read(&text, options);
    let failed = report.has_errors();
    let diagnostics = report.finish(&source.name, &text);
    match loaded {
        Some(loaded) if !failed => Ok(Loaded { diagnostics, ..loaded }),
        Some(_) | None => Err(LoadError { diagnostics }),
    }
}

/// Identifier without leading zeros.
fn id_of(text: &str) -> String {
    text.trim().trim_start_matches('0').to_owned()
}

/// Reader of one dataset, with the factors of its units.
struct Reader<'r> {
    report: &'r mut Report,
    length: f64,
    mass: f64,
}

impl Reader<'_> {
    fn error(&mut self, code: &'static str, statement: &Statement, message: impl Into<String>) {
        let message = message.into();
        self.report.error(code, Place::Named(statement.at, &statement.name()), || message);
    }

    /// Reads all statements; `None` after an error.
    fn read(&mut self, text: &str, options: &LoadOptions) -> Option<Loaded> {
        let statements = read(text);
        let of = |kind: &'static str| statements.iter().filter(move |statement| statement.kind == kind);
        self.units(of("UNITS").next());
        if let Some(second) = of("UNITS").nth(1) {
            self.error("duplicate-name", second, "a second UNITS; one is expected");
        }
        let mut markers: HashMap<String, Marker> = HashMap::new();
        for statement in of("MARKER") {
            let marker = self.marker(statement);
            if markers.insert(statement.id.clone(), marker).is_some() {
                self.error("duplicate-name", statement, "the marker is defined twice");
            }
        }
        let (mut parts, mut index, mut names) = (Vec::<Part>::new(), HashMap::new(), HashSet::new());
        for statement in of("PART") {
            let part = self.part(statement, &markers, &mut names);
            if index.insert(part.id.clone(), parts.len()).is_some()
                || part.is_ground && parts.iter().any(|part| part.is_ground)
            {
                self.error("duplicate-name", statement, "the part or the ground is defined twice");
            }
            parts.push(part);
        }
        let mut connections = Vec::new();
        for statement in &statements {
            let name = statement.name();
            let place = Place::Named(statement.at, &name);
            let is_in = |list: &str| list.split_whitespace().any(|word| word == statement.kind);
            self.check_arguments(statement);
            match statement.kind.as_str() {
                "PART" | "MARKER" | "UNITS" => {}
                "JOINT" | "JPRIM" => connections.extend(self.connection(statement, &index, &markers)),
                "MOTION" => {
                    let joint = id_of(statement.value("JOINT"));
                    let message = || {
                        format!(
                            "the prescribed motion of joint {joint} is not read: the joint moves freely; --lock holds it"
                        )
                    };
                    self.report.warning("motion", place, message);
                }
                _ if is_in(FORCES) => {
                    let kind = statement.kind.clone();
                    let message = || {
                        format!(
                            "{kind}: forces have no influence on the effective mass and are not read; parts that only they join move freely, and an \
                             impact in time leaves them out"
                        )
                    };
                    self.report.add_once(
                        percuss_mechanism::Severity::Warning,
                        "forces",
                        kind.clone(),
                        place,
                        message,
                    );
                }
                _ if is_in(WITHOUT_EFFECT) => self.report.add_unread(place, || statement.kind.clone()),
                kind => {
                    let message = format!(
                        "{kind} is not read; rigid parts (PART, MARKER) with joints (JOINT, JPRIM) are: a statement that could constrain the motion is \
                         not left out"
                    );
                    self.error("unsupported-element", statement, message);
                }
            }
        }
        if !parts.iter().any(|part| part.is_ground) && !self.report.has_errors() {
            self.report.error("no-links", Place::File, || "no PART has the argument GROUND".to_owned());
        }
        if self.report.has_errors() {
            return None;
        }
        let title = text.lines().next().unwrap_or_default();
        let title = title.split_once("name:").map_or(title, |(_, name)| name).trim();
        let title = if title.is_empty() { "adams" } else { title };
        let (builder, places) = mechanism_of(title, &parts, &connections, self.report)?;
        let (mechanism, problems) = match builder.accept(options.accept).build() {
            Ok(Built { mechanism, mut findings }) => {
                findings.extend(mechanism.implausible_inertias(options.accept));
                (Some(mechanism), findings)
            }
            Err(error) => (None, error.findings),
        };
        for (subject, problem) in problems {
            let name = match &subject {
                Subject::Link { name, .. } | Subject::Joint { name, .. } | Subject::Closure { name, .. } => {
                    name
                }
                _ => "",
            };
            let label = format!("{subject}");
            let place = places.get(name).map_or(Place::File, |at| Place::Named(*at, &label));
            // The ground has no mass, and neither has a link between the axes of a joint.
            if places.contains_key(name) || problem.severity() == percuss_mechanism::Severity::Error {
                self.report.add_problem(place, &problem);
            }
        }
        let mechanism = mechanism?;
        let shapes = vec![Vec::new(); mechanism.links().len()];
        Some(Loaded::new(mechanism, shapes))
    }

    /// Names arguments of a statement that are not read, and arguments that are given twice.
    fn check_arguments(&mut self, statement: &Statement) {
        let Some((_, known)) = ARGUMENTS.iter().find(|(kind, _)| *kind == statement.kind) else { return };
        let mut seen = HashSet::new();
        for (name, _) in &statement.arguments {
            if !seen.insert(name) {
                self.error(
                    "duplicate-name",
                    statement,
                    format!("the argument {} is given twice", quoted(name)),
                );
            } else if !known.split(' ').any(|known| known == name) {
                let similar = similar_name(name, known.split(' '));
                self.report.warning("ignored", Place::Named(statement.at, &statement.name()), || {
                    format!("the argument {} is not known and ignored{similar}", quoted(name))
                });
            }
        }
    }

    /// Reads the units.
    fn units(&mut self, statement: Option<&Statement>) {
        let Some(statement) = statement else {
            let message = "the statement UNITS is missing: the units of length and mass are unknown";
            return self.report.error("wrong-unit", Place::File, || message.to_owned());
        };
        let system = statement.value("SYSTEM").to_ascii_uppercase();
        let of_system = SYSTEMS.iter().find(|(name, ..)| *name == system);
        let named = |argument: &str, of_system: Option<&str>| {
            let given = statement.value(argument).to_ascii_uppercase();
            if given.is_empty() { of_system.unwrap_or_default().to_owned() } else { given }
        };
        let names = [
            named("LENGTH", of_system.map(|(_, length, _)| *length)),
            named("MASS", of_system.map(|(.., mass)| *mass)),
        ];
        let tables: [&[(&str, f64)]; 2] = [&LENGTHS, &MASSES];
        let factors =
            [0, 1].map(|k| tables[k].iter().find(|(name, _)| *name == names[k]).map(|(_, factor)| *factor));
        match factors {
            [Some(length), Some(mass)] if statement.values("UCF").is_none() => {
                (self.length, self.mass) = (length, mass)
            }
            _ => {
                let message = format!(
                    "LENGTH {} and MASS {} are no known units; a unit of Adams for both is expected (MILLIMETER, KILOGRAM), without UCF",
                    quoted(&names[0]),
                    quoted(&names[1])
                );
                self.error("wrong-unit", statement, message);
            }
        }
    }

    /// Numbers of an argument; `None` if absent, or, with an error, if they are not `counts` numbers.
    fn numbers(&mut self, statement: &Statement, argument: &str, counts: &[usize]) -> Option<Vec<f64>> {
        let values = statement.values(argument)?;
        let found: Option<Vec<f64>> = values.iter().map(|value| number(value)).collect();
        let found = found.filter(|found| counts.contains(&found.len()));
        if found.is_none() {
            let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
            let message = format!(
                "{argument} = {}; {} numbers are expected",
                quoted(&values.join(", ")),
                counts.join(" or ")
            );
            self.error("not-a-number", statement, message);
        }
        found
    }

    /// Frame by its origin and REULER; an error for other orientations.
    fn frame(&mut self, statement: &Statement, origin: &str) -> Transform<f64> {
        let at = self
            .numbers(statement, origin, &[3])
            .map_or_else(Vector3::zeros, |p| Vector3::new(p[0], p[1], p[2]));
        let angles = self.numbers(statement, "REULER", &[3]).unwrap_or_else(|| vec![0.0; 3]);
        let turn = |about: usize, angle: f64| {
            let (s, c) = angle.sin_cos();
            if about == 0 {
                Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
            } else {
                Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
            }
        };
        Transform::new(turn(2, angles[0]) * turn(0, angles[1]) * turn(2, angles[2]), at * self.length)
    }

    /// Names an argument that determines a frame and is not read.
    fn other_orientation(statement: &Statement) -> Option<String> {
        let others = [
            "XP",
            "ZP",
            "XG",
            "ZG",
            "USEXP",
            "RM",
            "FLEX_BODY",
            "POINT_MASS",
            "CURVE",
            "SURFACE",
            "FLOATING",
        ];
        others.iter().find(|name| statement.values(name).is_some()).map(|name| (*name).to_owned())
    }

    fn marker(&mut self, statement: &Statement) -> Marker {
        let unread = Self::other_orientation(statement);
        let frame = if unread.is_some() { Transform::identity() } else { self.frame(statement, "QP") };
        Marker { part: id_of(statement.value("PART")), frame, unread }
    }

    /// Marker of an argument that belongs to the part; `None` with an error.
    fn marker_of<'m>(
        &mut self,
        statement: &Statement,
        argument: &str,
        markers: &'m HashMap<String, Marker>,
    ) -> Option<&'m Marker> {
        let id = id_of(statement.value(argument));
        let Some(marker) = markers.get(&id) else {
            let message = format!(
                "{argument} = {}: a marker of the dataset is expected",
                quoted(statement.value(argument))
            );
            self.error("unknown-link", statement, message);
            return None;
        };
        if let Some(unread) = &marker.unread {
            let message = format!("MARKER/{id} is given by {unread}, which is not read; QP and REULER are");
            self.error("unsupported-element", statement, message);
            return None;
        }
        Some(marker)
    }

    /// Reads a part: its frame in the ground, and its inertia in this frame.
    fn part(
        &mut self,
        statement: &Statement,
        markers: &HashMap<String, Marker>,
        names: &mut HashSet<String>,
    ) -> Part {
        if let Some(unread) = Self::other_orientation(statement) {
            self.error("unsupported-element", statement, format!("{unread} is not read; QG and REULER are"));
        }
        let frame = self.frame(statement, "QG");
        let is_ground = statement.has_flag("GROUND");
        let default = if is_ground { "ground".to_owned() } else { format!("part_{}", statement.id) };
        let wanted = if statement.view_name.is_empty() { default } else { statement.view_name.clone() };
        let with_id = format!("{wanted}_{}", statement.id);
        let name = if names.contains(&wanted) { with_id } else { wanted };
        if !names.insert(name.clone()) {
            self.error("duplicate-name", statement, format!("the name {} is given twice", quoted(&name)));
        }
        let inertial = if is_ground { None } else { self.inertial(statement, markers) };
        Part { id: statement.id.clone(), name, frame, is_ground, inertial, at: statement.at }
    }

    /// Mass and inertia of a part in its own frame: IP of the marker IM, moved to the centre of mass.
    fn inertial(&mut self, statement: &Statement, markers: &HashMap<String, Marker>) -> Option<Inertial> {
        if let (None, Some(_)) = (statement.values("MASS"), statement.values("IP")) {
            self.error("missing-attribute", statement, "IP is given without MASS; give the mass of the part");
        }
        let mass = self.numbers(statement, "MASS", &[1])?[0] * self.mass;
        if mass == 0.0 && statement.values("CM").is_none() {
            return None;
        }
        let cm = self.marker_of(statement, "CM", markers)?;
        let im =
            if statement.values("IM").is_some() { self.marker_of(statement, "IM", markers)? } else { cm };
        if [cm, im].iter().any(|marker| marker.part != statement.id) {
            self.error("unknown-link", statement, "CM and IM are markers of this part");
        }
        let values = self.numbers(statement, "IP", &[3, 6]).unwrap_or_else(|| vec![0.0; 3]);
        let unit = self.mass * self.length * self.length;
        let at = |k: usize| values.get(k).copied().unwrap_or(0.0) * unit;
        // The products of the file are positive integrals, the entries of the matrix their negatives.
        let about_marker = Matrix3::new(at(0), -at(3), -at(4), -at(3), at(1), -at(5), -at(4), -at(5), at(2));
        let rotation = im.frame.rotation;
        let d = cm.frame.translation - im.frame.translation;
        let shift = (Matrix3::identity() * d.norm_squared() - d * d.transpose()) * mass;
        let about_com = rotation * about_marker * rotation.transpose() - shift;
        Some(Inertial { mass, com: cm.frame.translation, about_com })
    }

    /// Reads a joint between two parts.
    fn connection(
        &mut self,
        statement: &Statement,
        index: &HashMap<String, usize>,
        markers: &HashMap<String, Marker>,
    ) -> Option<Connection> {
        let kinds: &[(&str, ConnectionKind)] = if statement.kind == "JOINT" {
            &[
                ("REVOLUTE", ConnectionKind::Revolute),
                ("TRANSLATIONAL", ConnectionKind::Translational),
                ("CYLINDRICAL", ConnectionKind::Cylindrical),
                ("SPHERICAL", ConnectionKind::Spherical),
                ("UNIVERSAL", ConnectionKind::Universal),
                ("PLANAR", ConnectionKind::Planar),
                ("FIXED", ConnectionKind::Fixed),
            ]
        } else {
            &[("ATPOINT", ConnectionKind::Spherical)]
        };
        let Some((_, kind)) = kinds.iter().find(|(name, _)| statement.has_flag(name)) else {
            let names: Vec<&str> = kinds.iter().map(|(name, _)| *name).collect();
            let flags: Vec<&str> =
                statement.arguments.iter().filter(|(_, v)| v.is_empty()).map(|(n, _)| n.as_str()).collect();
            let message = format!(
                "the kind {} is not read; these are: {}",
                quoted(&flags.join(", ")),
                names.join(", ")
            );
            self.error("unsupported-element", statement, message);
            return None;
        };
        let (i, j) = (self.marker_of(statement, "I", markers), self.marker_of(statement, "J", markers));
        let ends = [i?, j?].map(|marker| Some((*index.get(&marker.part)?, marker.frame)));
        let [Some(i), Some(j)] = ends else {
            self.error("unknown-link", statement, "the markers I and J are on parts of the dataset");
            return None;
        };
        if i.0 == j.0 {
            self.error("self-joint", statement, "the markers I and J are on the same part");
            return None;
        }
        let label = if statement.kind == "JOINT" { "joint" } else { "primitive" };
        let default = format!("{label}_{}", statement.id);
        let name = if statement.view_name.is_empty() { default } else { statement.view_name.clone() };
        Some(Connection { name, id: statement.name(), kind: *kind, ends: [i, j], at: statement.at })
    }
}
