#![doc = include_str!("../README.md")]
//!
//! [`import`] reads a sheet (TOML), a table of hardpoints (CSV, XLSX) or a suspension file of Chrono (JSON, with
//! `"Type": "Suspension"`). It builds one corner of the vehicle, or both, at the design position. The chassis is the
//! root link. Arms turn on hinges. Loops are closed by ball joints, sliding bearings and massless rods. The axes of
//! the mechanism are those of ISO 8855: x forward, y left, z up. Units are m, kg, rad.
//!
//! Sheets use the templates of [`template_names`]; [`template_sheet`] writes a sheet to fill in. Templates of Chrono
//! are `DoubleWishbone`, `DoubleWishboneReduced`, `MacPhersonStrut`, `SemiTrailingArm`, `ThreeLinkIRS`, `MultiLink`.
//! Bodies, joints and inertia axes follow Chrono's classes of the same names; `docs/reference/SUSPENSIONS.md` has a table of
//! them, with the deviations.
//!
//! The mechanism contains no springs, dampers and stops, only their seats: `spring_seat` on the moving link,
//! `spring_chassis_seat`, and so on. Important joints are `spin` (the wheel bearing) and `rack` (fixed, unless
//! [`Rack::Sliding`]). Every template has mobility 2 per side: travel and spin.

mod changed;
mod chrono;
mod corner;
mod findings;
mod forces;
pub mod kinematics;
mod limits;
mod options;
mod reading;
mod sheet;
mod text;
mod understood;
mod units;

pub use changed::{ChangedFile, changed_file};
use chrono::{ChronoTemplate, Reader, Section};
use corner::design::THIRD_SPRING;
pub use corner::drawing::{Line, WheelCircle};
use corner::plausibility::masses_in_grams;
use corner::{Annotations, Body, Built, CHASSIS, Corner, RACK};
use findings::{Findings, Spot};
pub use forces::{ForceElements, SpringForce, TorsionBar, TyreForce};
pub use options::{ImportOptions, Rack, Side, Wheel};
use percuss_formats::reading::LONGEST_NAME;
use percuss_formats::reading::{Place, Report, cut, quoted};
use percuss_formats::{Comments, Diagnostic, LoadError, Source};
use percuss_mechanism::{
    Accept, BushDescription, ContactDescription, ContactKind, ContactNormal, Inertial, JointDescription,
    JointKind, LinkDescription, Mechanism, MechanismBuilder, Problem, Severity, SpringDamper, Subject,
};
use percuss_spatial::{Matrix3, Vector3};
pub use percuss_units::LengthUnit;
pub use reading::ReadFile;
use reading::{ReadSheet, check_options};
pub use sheet::{
    TABLE_COLUMNS, TemplateOptions, template_keys, template_names, template_rows, template_sheet,
};
pub use understood::Understood;
pub use units::VehicleAxes;
use units::{FilePlaces, Frame};

/// Imported mechanism with a description of its parts and the findings about its file.
#[derive(Debug)]
pub struct Imported {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Description of each part, for [`write_urdf_with`](percuss_formats::write_urdf_with).
    pub comments: Comments,
    /// Summary of the file's contents, for comparison with the design.
    pub understood: Understood,
    /// Names of the files: the file named by the user, and a table named by the sheet.
    pub inputs: Vec<String>,
    /// Warnings and notes, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a sheet, a table of hardpoints, or a suspension file of Chrono::Vehicle (comments in the JSON are allowed).
///
/// The format is detected from the bytes; a file name ending in `.csv` denotes a table. For a Chrono file, an inertia
/// I′ in the axes R becomes R I′ Rᵀ. The inertia J of an axle about the spin axis a adds J a aᵀ to the inertia of the
/// spindle. Force laws are ignored. A table of points named by a sheet is read from the folder of the sheet. Sources:
/// Project Chrono, `src/chrono_vehicle/wheeled_vehicle/suspension`.
///
/// # Errors
/// [`LoadError`] with all findings if at least one is an error: neither TOML, table nor JSON; an unknown template; a
/// missing key; an unknown key of a sheet; a value of the wrong type or length; no unit or axes in a sheet;
/// coordinates implausible for a vehicle in the given unit; hardpoints that define no joint axis; an error of the
/// mechanism's builder.
pub fn import(source: &Source, options: &ImportOptions) -> Result<Imported, LoadError> {
    ReadFile::new(source, options)?.import(&[])
}

impl ReadFile {
    /// Imports the file with points moved by `moves` (name; m, in the axes of the file) after those of the options.
    ///
    /// # Errors
    /// [`LoadError`], as [`import`].
    pub fn import(&self, moves: &[(String, [f64; 3])]) -> Result<Imported, LoadError> {
        let (source, options) = (&self.source, &self.options);
        let moves = [&options.moves, moves].concat();
        let Some(read) = &self.sheet else {
            let mut report = Report::default();
            return match source.text(&mut report) {
                Some(text) => {
                    import_chrono(source, &text, &ImportOptions { moves, ..options.clone() }, report)
                }
                None => Err(LoadError { diagnostics: report.finish(&source.name, "") }),
            };
        };
        import_sheet(read.clone(), source, options, &moves)
    }
}

/// Imports a sheet with moved points.
fn import_sheet(
    read: ReadSheet,
    source: &Source,
    options: &ImportOptions,
    moves: &[(String, [f64; 3])],
) -> Result<Imported, LoadError> {
    let ReadSheet { sheet, mut findings, files } = read;
    let imported = sheet.and_then(|mut sheet| {
        sheet::apply_moves(&mut sheet, moves, &mut findings);
        let built = sheet::build(&sheet, &mut findings).filter(|_| !findings.has_errors())?;
        if sheet.wheel.is_none() && sheet.missing_masses.is_empty() {
            warn_no_wheel(&mut findings, "and the sheet has no [wheel]");
        }
        let facts = SuspensionFacts {
            name: &sheet.name,
            template: &sheet.template.name,
            kind: "sheet",
            side: sheet.side,
            rack: sheet.rack,
            rack_stiffness: sheet.rack_stiffness,
            wheel: sheet.wheel,
            places: FilePlaces { frame: sheet.frame, is_right: sheet.points_side == Side::Right },
            points: sheet.point_names(),
            chassis: sheet.chassis.clone(),
            coordinates: coordinates(&sheet),
            steering_axes: steering_axes(&sheet),
            axle: sheet.template.axle,
            middle: sheet.template.middle,
            forces: sheet.forces.clone(),
        };
        let (mechanism, comments, mut understood) =
            build_mechanism(&mut findings, built, &facts, source, options)?;
        understood.missing_masses = sheet.missing_masses;
        understood.rack_travel = sheet.rack_travel;
        Some((mechanism, comments, understood))
    });
    let failed = findings.has_errors();
    let inputs = files.iter().map(|(name, _)| name.clone()).collect();
    let files: Vec<(&str, &str)> = files.iter().map(|(name, text)| (&**name, &**text)).collect();
    let diagnostics = findings.finish(&files);
    match imported {
        Some((mechanism, comments, understood)) if !failed => {
            Ok(Imported { mechanism, comments, understood, inputs, diagnostics })
        }
        Some(_) | None => Err(LoadError { diagnostics }),
    }
}

/// Hardpoints of a sheet, m, in the axes of the sheet and on the side of its points.
fn coordinates(sheet: &sheet::Sheet) -> Vec<(String, [f64; 3])> {
    let given = |(key, (at, _)): (&&str, &(Vector3<f64>, Spot))| {
        let is_mirrored = sheet.points_side == Side::Right && !sheet.template.is_central(key);
        let at = Vector3::new(at.x, if is_mirrored { 0.0 - at.y } else { at.y }, at.z);
        ((*key).to_owned(), sheet.frame.axes.from_iso(at).into())
    };
    let word = sheet.points_side.other_word();
    let of_other = |(key, (at, _)): (&&str, &(Vector3<f64>, Spot))| {
        let y = if sheet.points_side == Side::Right { at.y } else { 0.0 - at.y };
        (format!("{word}.{key}"), sheet.frame.axes.from_iso(Vector3::new(at.x, y, at.z)).into())
    };
    sheet.design.points.iter().map(given).chain(sheet.unequal_points().iter().map(of_other)).collect()
}

/// Two points of the steering axis of the left and of the right side of a sheet, m, as points of the left side, each with its link.
fn steering_axes(sheet: &sheet::Sheet) -> [Vec<(String, [f64; 3])>; 2] {
    let own = |key: &str| sheet.design.point(key);
    let other = |key: &str| sheet.other_points.get(key).map(|(at, _)| *at).or_else(|| own(key));
    let axis = |point: &dyn Fn(&str) -> Option<Vector3<f64>>| {
        let of_link = |(link, key): &(String, String)| Some((link.clone(), point(key)?.into()));
        sheet.template.steering_axis.iter().filter_map(of_link).collect()
    };
    if sheet.points_side == Side::Right { [axis(&other), axis(&own)] } else { [axis(&own), axis(&other)] }
}

/// Imports a suspension in the JSON of Chrono::Vehicle.
fn import_chrono(
    source: &Source,
    text: &str,
    options: &ImportOptions,
    mut report: Report,
) -> Result<Imported, LoadError> {
    let clean = match text::blank_comments(text) {
        Ok(clean) => clean,
        Err(defect) => {
            report.error(defect.code, Place::Offset(defect.at), || defect.message.to_owned());
            return Err(LoadError { diagnostics: report.finish(&source.name, text) });
        }
    };
    let frame = Frame { unit: options.unit.unwrap_or_default(), axes: options.axes.unwrap_or_default() };
    let mut reader = Reader::new(&clean, frame, &options.moves);
    let imported = read_chrono(&mut reader, source, options);
    let failed = reader.has_errors();
    let diagnostics = reader.finish(&source.name);
    match imported {
        Some((mechanism, comments, understood)) if !failed => {
            Ok(Imported { mechanism, comments, understood, inputs: vec![source.name.clone()], diagnostics })
        }
        Some(_) | None => Err(LoadError { diagnostics }),
    }
}

/// Properties of a suspension apart from links and joints.
struct SuspensionFacts<'d> {
    name: &'d str,
    template: &'d str,
    kind: &'static str,
    side: Side,
    rack: Rack,
    /// Stiffness of the rack and its housing along y, N/m.
    rack_stiffness: Option<f64>,
    wheel: Option<Wheel>,
    places: FilePlaces,
    points: Vec<String>,
    /// Body of the chassis; `None` for a massless root link.
    chassis: Option<Body>,
    /// Hardpoints, m, in the axes of the file.
    coordinates: Vec<(String, [f64; 3])>,
    /// Two points of the steering axis of the left side, m, each with its link, and of the mirror image of the right side.
    steering_axes: [Vec<(String, [f64; 3])>; 2],
    axle: bool,
    /// True if the wheel is in the middle plane.
    middle: bool,
    forces: ForceElements,
}

/// Reads a file of Chrono::Vehicle and builds its mechanism; `None` after an error in the report.
fn read_chrono(
    reader: &mut Reader<'_>,
    source: &Source,
    options: &ImportOptions,
) -> Option<(Mechanism, Comments, Understood)> {
    check_options(reader, options);
    if options.wheel.is_none() {
        warn_no_wheel(reader, "and files of Chrono::Vehicle contain none");
    }
    if options.template.is_some() {
        let message = "--template is for sheets and tables; this is a file of Chrono::Vehicle".to_owned();
        reader.error("conflict", &Spot::default(), message);
    }
    let mut root = reader.root()?;
    let name = header(reader, &mut root);
    let template = find_template(reader, &mut root)?;
    let spindle = chrono::read_spindle(reader, &mut root, options);
    let corner = chrono::read_corner(reader, &mut root, template, &spindle);
    // `Output` controls only the output of Chrono.
    reader.warn_unread_keys(root, &["Output"]);
    reader.check_unit();
    let names: Vec<String> = reader.written.iter().map(|point| point.name.clone()).collect();
    let known: Vec<&str> = names.iter().map(String::as_str).collect();
    sheet::check_moves(&options.moves, reader.frame.unit, &known, reader);
    let corner = corner.filter(|_| !reader.has_errors())?;
    let side = options.side.unwrap_or_default();
    if side != Side::Left
        && let Some(spot) = reader.products.take()
    {
        let message = "the right side is the mirror image of the left; Chrono gives both sides the same products of inertia";
        reader.note("mirrored-products", &spot, message.to_owned());
    }
    let facts = SuspensionFacts {
        name: &name,
        template: &template.name,
        kind: "Chrono::Vehicle's template",
        side,
        rack: options.rack.unwrap_or_default(),
        rack_stiffness: None,
        wheel: options.wheel,
        places: FilePlaces { frame: reader.frame, is_right: false },
        points: Vec::new(),
        chassis: None,
        coordinates: reader.coordinates(),
        steering_axes: Default::default(),
        axle: false,
        middle: false,
        forces: ForceElements::default(),
    };
    build_mechanism(reader, Built { left: corner, middle: None, right: None }, &facts, source, options)
}

/// Builds the mechanism from the corners, with the comments and the summary.
fn build_mechanism(
    findings: &mut Findings,
    mut built: Built,
    facts: &SuspensionFacts<'_>,
    source: &Source,
    options: &ImportOptions,
) -> Option<(Mechanism, Comments, Understood)> {
    let places = |is_right: bool| FilePlaces { is_right, ..facts.places };
    built.left.check(findings, places(facts.places.is_right && built.right.is_none()));
    if let Some(right) = &built.right {
        right.check(findings, places(true));
    }
    let corner = &built.left;
    if let Some(middle) = &built.middle {
        let track = corner.drawing.track();
        // Parts common to both sides are not mirrored: messages have the coordinates of the file.
        middle.check_parts(track, &[], findings, places(false));
        middle.drawing.check_short_links(findings, places(false));
    }
    let in_grams = check_grams(corner, built.middle.as_ref(), options.accept, findings);
    if findings.has_errors() {
        return None;
    }
    let drawing = corner.drawing.clone();
    let right_drawing = built.right.as_ref().map(|right| right.drawing.clone());
    let middle_drawing = built.middle.as_ref().map(|m| m.drawing.clone());
    let is_unequal = built.right.is_some();
    set_torsion_bar(findings, &mut built, facts, options);
    let (builder, annotations) = assemble(findings, built, facts);
    let mut comments = annotations.comments;
    comments.heading = heading(facts, is_unequal, source);
    let (mechanism, problems) = match builder.accept(options.accept).build() {
        Ok(percuss_mechanism::Built { mechanism, mut findings }) => {
            findings.extend(mechanism.implausible_inertias(options.accept));
            (Some(mechanism), findings)
        }
        Err(error) => (None, error.findings),
    };
    for (subject, problem) in problems {
        let name = match &subject {
            Subject::Mechanism => "",
            Subject::Link { name, .. }
            | Subject::Joint { name, .. }
            | Subject::Closure { name, .. }
            | Subject::Coupling { name, .. }
            | Subject::Contact { name, .. }
            | Subject::Bush { name, .. } => name,
        };
        let is_triangle_inequality = matches!(problem, Problem::TriangleInequality { .. });
        if is_triangle_inequality {
            // The finding is reported here, with its position in this file. The mark keeps later readers of the URDF
            // from repeating the warning.
            comments.known.push((problem.code(), name.to_owned()));
        }
        // Frames and crosses are massless by design. The spindle's moments are checked before the axle is added.
        let known = matches!(problem, Problem::Massless)
            || options.masses_optional && matches!(problem, Problem::NoMovingMass)
            || is_triangle_inequality && name.starts_with("spindle")
            || is_explained(&problem, name, in_grams, findings);
        if !known {
            let spot = annotations.spots.get(name).cloned().unwrap_or_default();
            let label = if spot.has_path() { String::new() } else { format!("{subject}: ") };
            findings.add(problem.severity(), problem.code(), &spot, format!("{label}{problem}"));
        }
    }
    let mechanism = mechanism?;
    let understood = Understood {
        name: facts.name.to_owned(),
        template: facts.template.to_owned(),
        unit: facts.places.frame.unit,
        axes: facts.places.frame.axes,
        side: facts.side,
        wheel: facts.wheel,
        points: facts.points.clone(),
        coordinates: facts.coordinates.clone(),
        steering_axis: facts.steering_axes[0].clone(),
        right_steering_axis: facts.steering_axes[1].clone(),
        axle: facts.axle,
        forces: facts.forces.clone(),
        ..Understood::of(
            &mechanism,
            [&drawing, right_drawing.as_ref().unwrap_or(&drawing)],
            middle_drawing.as_ref(),
            facts.side,
        )
    };
    Some((mechanism, comments, understood))
}

/// Sets the torsion bar as the spring of its hinge. The bar is without moment at the position q₀ = −s T/k of the hinge, with the moment T at the
/// design position, the rate k, and the sign s of the rotation of the hinge as the wheels move up.
fn set_torsion_bar(
    findings: &mut Findings,
    built: &mut Built,
    facts: &SuspensionFacts<'_>,
    options: &ImportOptions,
) {
    let Some(bar) = &facts.forces.torsion_bar else { return };
    let set = |built: &mut Built, reference: f64| {
        let spring = SpringDamper { stiffness: bar.rate, damping: 0.0, reference };
        let corners = [Some(&mut built.left), built.right.as_mut()];
        corners.into_iter().flatten().for_each(|corner| corner.set_spring(&bar.joint(""), spring));
    };
    set(built, 0.0);
    let Some(preload) = bar.preload.filter(|moment| *moment != 0.0) else { return };
    let (builder, _) = assemble(&mut Findings::default(), built.clone(), facts);
    // The errors of the builder are reported with the model.
    let Ok(without) = builder.accept(options.accept).build() else { return };
    let origin = Understood { forces: facts.forces.clone(), axle: facts.axle, ..Understood::default() };
    match kinematics::torsion_sign(without.mechanism, &origin) {
        Some(sign) => set(built, -sign * preload / bar.rate),
        None => {
            let message = "its hinge does not turn as the wheel moves up: the direction of its moment is not determined";
            let spot = Spot { path: Some("torsion_bar.preload".to_owned()), ..Spot::default() };
            findings.error("degenerate-geometry", &spot, message.to_owned());
        }
    }
}

/// True if a finding about an inertia has the cause of an earlier one: masses in grams, or the radius of gyration of the part.
fn is_explained(problem: &Problem, name: &str, in_grams: bool, findings: &Findings) -> bool {
    let is_about_inertia = matches!(problem, Problem::WideInertia { .. } | Problem::DenseInertia { .. });
    let part = name.trim_end_matches("_left").trim_end_matches("_right");
    problem.severity() != Severity::Error
        && is_about_inertia
        && (in_grams
            || findings.has("implausible-gyration", part)
            || part == "wheel" && findings.has("implausible-wheel", "spindle"))
}

/// Reports masses in grams as one finding, in place of those about single parts; an error unless implausible inertias are accepted.
/// Returns true if the masses look like grams.
fn check_grams(corner: &Corner, middle: Option<&Corner>, accept: Accept, findings: &mut Findings) -> bool {
    // Lengths in a wrong unit make parts too small for their masses.
    if findings.has_errors() {
        return false;
    }
    let mut parts = corner.masses(None);
    parts.extend(middle.map(|middle| middle.masses(corner.drawing.track())).unwrap_or_default());
    let Some(message) = masses_in_grams(&parts) else { return false };
    findings.remove(&["implausible-mass", "implausible-gyration", "implausible-wheel"]);
    let heavy = parts.iter().filter(|part| part.is_heavy());
    let Some(first) = heavy.min_by_key(|part| part.spot.at) else { return false };
    if accept.implausible_inertia {
        findings.warning("masses-in-grams", &first.spot, format!("{message} (accepted)"));
    } else {
        let remedy = format!(
            "write them in kg or with their unit (mass = \"{} g\"), or accept them with --accept implausible-inertia",
            first.mass
        );
        findings.error("masses-in-grams", &first.spot, format!("{message}; {remedy}"));
    }
    true
}

/// Checks the type of the file and returns the name.
fn header<'t>(reader: &mut Reader<'t>, root: &mut Section<'t>) -> String {
    if let Some((kind, spot)) = reader.string(root, "Type")
        && kind != "Suspension"
    {
        let message = format!("the file describes a {}; a \"Suspension\" is expected", quoted(&kind));
        reader.error("wrong-kind", &spot, message);
    }
    let name = reader.string(root, "Name").map(|(name, _)| name).unwrap_or_default();
    if name.len() > LONGEST_NAME { cut(&name, LONGEST_NAME / 4) } else { name }
}

/// Finds the template named in the file; an unknown name is an error.
fn find_template<'t>(reader: &mut Reader<'t>, root: &mut Section<'t>) -> Option<&'static ChronoTemplate> {
    let (name, spot) = reader.string(root, "Template")?;
    let found = chrono::templates().iter().find(|known| known.name == name);
    if found.is_none() {
        let known: Vec<&str> = chrono::templates().iter().map(|known| &*known.name).collect();
        let message = format!("the template {} is not known; these are: {}", quoted(&name), known.join(", "));
        reader.error("unknown-template", &spot, message);
    }
    found
}

/// Warns that the mechanism has no wheel; `why` completes the message.
fn warn_no_wheel(findings: &mut Findings, why: &str) {
    let message = format!("no wheel is given, {why}: the mechanism has no wheel mass");
    findings.warning("no-wheel", &Spot::default(), message);
}

/// Combines the chassis, the rack and the sides.
fn assemble(
    findings: &mut Findings,
    Built { left: corner, middle, right }: Built,
    facts: &SuspensionFacts<'_>,
) -> (MechanismBuilder, Annotations) {
    let mut annotations = Annotations::default();
    let (chassis, comment) = match &facts.chassis {
        None => (LinkDescription::massless(CHASSIS), "the vehicle's frame; its own mass is not given"),
        Some(Body { mass, com, about_com, spot, .. }) => {
            annotations.spots.insert(CHASSIS.to_owned(), spot.clone());
            let inertial = Inertial { mass: *mass, com: *com, about_com: *about_com };
            (LinkDescription::new(CHASSIS, inertial), "the vehicle's frame, with the body's mass")
        }
    };
    let mut builder = MechanismBuilder::new(facts.name).link(chassis);
    annotations.comments.links.insert(CHASSIS.to_owned(), comment.to_owned());
    match (corner.rack_origin(), facts.rack) {
        (Some(at), rack) => {
            builder = add_rack(builder, at, rack, &mut annotations);
            builder = facts
                .rack_stiffness
                .into_iter()
                .map(|k| rack_bush(rack, k))
                .fold(builder, MechanismBuilder::bush);
        }
        (None, Rack::Sliding { .. }) => {
            let message = "the template has no tie rod, so there is no rack to slide".to_owned();
            findings.warning("no-rack", &Spot::default(), message);
        }
        (None, Rack::Fixed) => {}
    }
    if let Some(middle) = middle {
        builder = middle.add_to("", builder, &mut annotations);
    }
    if facts.side != Side::Both && corner.has_link(THIRD_SPRING.1) {
        let message = "the third spring is not built: it needs both sides, build = \"both\"".to_owned();
        findings.note("one-side", &Spot::default(), message);
    }
    let builder = match facts.side {
        Side::Left => corner.add_to("", builder, &mut annotations),
        Side::Right => corner.mirrored().add_to("", builder, &mut annotations),
        Side::Both => {
            let right = right.as_ref().unwrap_or(&corner).mirrored();
            let has_third_spring = corner.has_link(THIRD_SPRING.1);
            let builder = corner.add_to("_left", builder, &mut annotations);
            let builder = right.add_to("_right", builder, &mut annotations);
            if has_third_spring { builder.contact(third_spring()) } else { builder }
        }
    };
    (builder, annotations)
}

/// Named contact between the seats of the third spring on both sides.
fn third_spring() -> ContactDescription {
    let (name, seat) = THIRD_SPRING;
    ContactDescription {
        name: name.to_owned(),
        kind: ContactKind::Spring,
        link: format!("{seat}_left"),
        point: Vector3::zeros(),
        against: format!("{seat}_right"),
        normal: ContactNormal::Toward(Vector3::zeros()),
        gap: None,
    }
}

/// Bush that holds the rack along y with this stiffness, N/m.
fn rack_bush(rack: Rack, stiffness: f64) -> BushDescription {
    let ideal = f64::INFINITY;
    let mut bush = BushDescription::new(RACK, RACK, CHASSIS).replacing(RACK);
    // x backward, z along y: the axis of the bush.
    bush.frame.rotation = Matrix3::from_columns(&[-Vector3::x(), Vector3::z(), Vector3::y()]);
    bush.stiffness = [ideal, ideal, ideal, ideal, ideal, stiffness];
    bush.rigid = [true, true, true, true, true, rack == Rack::Fixed];
    bush
}

/// Adds the rack, fixed or sliding along y, with its frame at `at`.
fn add_rack(
    builder: MechanismBuilder,
    at: Vector3<f64>,
    rack: Rack,
    annotations: &mut Annotations,
) -> MechanismBuilder {
    let (kind, link, comment) = match rack {
        Rack::Fixed => {
            let comment =
                "fixed: the inner ends of the tie rods do not move; a prismatic joint along y would steer";
            (JointKind::Fixed, LinkDescription::massless(RACK), comment)
        }
        Rack::Sliding { mass } => {
            let link = LinkDescription::new(RACK, Inertial::point(mass, [0.0; 3]));
            (JointKind::Prismatic, link, "steers")
        }
    };
    annotations.comments.links.insert(RACK.to_owned(), "holds the inner ends of the tie rods".to_owned());
    annotations.comments.joints.insert(RACK.to_owned(), comment.to_owned());
    let joint = JointDescription::new(RACK, kind, CHASSIS, RACK).at(at.into());
    let mut joint = if kind.has_axis() { joint.axis([0.0, 1.0, 0.0]) } else { joint };
    // Otherwise a travel of the wheel without a given position of the rack could move the rack.
    joint.independent = kind.has_axis().then_some(true);
    builder.link(link).joint(joint)
}

/// Comment lines at the top of the URDF.
fn heading(facts: &SuspensionFacts<'_>, is_unequal: bool, source: &Source) -> Vec<String> {
    let side = match facts.side {
        Side::Left if facts.middle => "wheel in the middle plane",
        Side::Left => "left side",
        Side::Right => "right side, the mirror image of the left one",
        Side::Both if is_unequal => "both sides, each with points of its own",
        Side::Both => "both sides, the right one the mirror image of the left one",
    };
    let wheel = match facts.wheel {
        Some(wheel) => format!("with a wheel of {} kg", wheel.mass),
        None => "without a wheel".to_owned(),
    };
    vec![
        format!("{}: {} {}, {side}, {wheel}", quoted(facts.name), facts.kind, facts.template),
        // The name is not shortened, because a shortened path would lose the file name.
        format!("imported by percuss from \"{}\"", source.name),
        "the chassis' frame: x forward, y left, z up; joints at 0 are the design position".to_owned(),
    ]
}
