//! Hardpoint files of Chrono::Vehicle (JSON) to a mechanism with loops.
//!
//! [`import`] reads one suspension file, the kind with `"Type": "Suspension"`, and builds one corner of the vehicle
//! or both at the design position: the chassis is the root; arms turn on hinges; what closes a loop is a ball joint,
//! a sliding bearing or a massless rod. Axes are the vehicle's, x forward, y left, z up; m, kg, rad.
//!
//! Six templates: `DoubleWishbone`, `DoubleWishboneReduced`, `MacPhersonStrut`, `SemiTrailingArm`, `ThreeLinkIRS`,
//! `MultiLink`. Bodies, joints and the axes in which inertias are stated are those that Chrono's classes of these
//! names build; `docs/SUSPENSIONS.md` has them in a table, and where this departs from them.
//!
//! Springs and shocks are not in the mechanism, only their seats: `spring_seat` on the link that moves,
//! `spring_chassis_seat`, `shock_seat`, `shock_chassis_seat`. Joints to know: `spin` (the wheel's bearing) and `rack`
//! (fixed, unless [`Rack::Sliding`]). Every template has mobility 2 a side: travel and spin.

mod corner;
mod frames;
mod json;
mod options;
mod parts;
mod reader;
mod spindle;
mod templates;
mod text;

use crate::limits::LONGEST_NAME;
use crate::report::{Place, Report, cut, quoted};
use crate::{Comments, Diagnostic, LoadError, Source};
use corner::{About, CHASSIS, Corner, RACK};
pub use options::{ImportOptions, Rack, Side, Wheel};
use percuss_mechanism::{
    Inertial, JointDescription, JointKind, LinkDescription, Mechanism, MechanismBuilder, Problem, Subject,
};
use percuss_spatial::Vector3;
use reader::{Reader, Section, Spot};

/// A mechanism, what its parts are, and what was noticed in its file.
#[derive(Debug)]
pub struct Imported {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// What each part is, for [`write_urdf_with`](crate::write_urdf_with).
    pub comments: Comments,
    /// Warnings and notes, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a suspension file of Chrono::Vehicle; comments in the JSON are allowed.
///
/// An inertia I′ stated in axes R becomes R I′ Rᵀ. The axle's inertia J about the axis of spin a adds J a aᵀ to the
/// spindle's. Force laws are ignored. Sources: Project Chrono, `src/chrono_vehicle/wheeled_vehicle/suspension`.
///
/// # Errors
/// [`LoadError`] with every finding, where one is an error: no JSON, an unknown template, a missing key, a value of
/// the wrong type or length, hardpoints that define no joint axis, and what the mechanism's builder refuses.
pub fn import(source: &Source, options: &ImportOptions) -> Result<Imported, LoadError> {
    let mut report = Report::default();
    let text = decoded(source, &mut report);
    let Some(text) = text else {
        return Err(LoadError { diagnostics: report.finish(&source.name, "") });
    };
    let clean = match text::without_comments(text) {
        Ok(clean) => clean,
        Err(defect) => {
            report.error(defect.code, Place::Offset(defect.at), || defect.message.to_owned());
            return Err(LoadError { diagnostics: report.finish(&source.name, text) });
        }
    };
    let mut reader = Reader::new(&clean);
    let imported = read(&mut reader, source, options);
    let failed = reader.has_errors();
    let diagnostics = reader.finish(&source.name);
    match imported {
        Some((mechanism, comments)) if !failed => Ok(Imported { mechanism, comments, diagnostics }),
        Some(_) | None => Err(LoadError { diagnostics }),
    }
}

/// The bytes as text; what a URDF's reader would say of other bytes is said in words that fit.
fn decoded<'s>(source: &'s Source, report: &mut Report) -> Option<&'s str> {
    let wide = [&b"\xFF\xFE"[..], b"\xFE\xFF"].iter().any(|mark| source.bytes.starts_with(mark));
    if source.bytes.trim_ascii().is_empty() {
        report.error("empty-file", Place::File, || "the file is empty; JSON is expected".to_owned());
        None
    } else if source.bytes.contains(&0) && !wide {
        report.error("binary", Place::File, || {
            "this is not a text file (it has zero bytes); JSON in UTF-8 is expected".to_owned()
        });
        None
    } else {
        source.text(report)
    }
}

fn read(reader: &mut Reader<'_>, source: &Source, options: &ImportOptions) -> Option<(Mechanism, Comments)> {
    check_options(reader, options);
    let mut root = reader.root()?;
    let name = header(reader, &mut root);
    let (template_name, build) = template(reader, &mut root)?;
    let spindle = spindle::read(reader, &mut root, options);
    let corner = build(reader, &mut root, &spindle);
    // Chrono's switch for its own output.
    reader.close(root, &["Output"]);
    reader.check_unit();
    let corner = corner.filter(|_| !reader.has_errors())?;
    let (builder, about) = assemble(reader, corner, &name, options);
    let mut comments = about.comments;
    comments.heading = heading(&name, template_name, source, options);
    let (mechanism, findings) = match builder.accept(options.accept).build() {
        Ok(built) => (Some(built.mechanism), built.findings),
        Err(error) => (None, error.findings),
    };
    for (subject, problem) in findings {
        let name = match &subject {
            Subject::Mechanism => "",
            Subject::Link { name, .. }
            | Subject::Joint { name, .. }
            | Subject::Closure { name, .. }
            | Subject::Coupling { name, .. } => name,
        };
        // Frames and crosses are massless on purpose; of the spindle, which has the axle in it, all was said.
        let known = matches!(problem, Problem::Massless)
            || matches!(problem, Problem::TriangleInequality { .. }) && name.starts_with("spindle");
        if !known {
            let spot = about.spots.get(name).cloned().unwrap_or_default();
            let label = if spot.is_somewhere() { String::new() } else { format!("{subject}: ") };
            reader.add(problem.severity(), problem.code(), &spot, format!("{label}{problem}"));
        }
    }
    mechanism.map(|mechanism| (mechanism, comments))
}

/// Name and kind of the file.
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

type Build = for<'t> fn(&mut Reader<'t>, &mut Section<'t>, &spindle::Spindle) -> Option<Corner>;

fn template<'t>(reader: &mut Reader<'t>, root: &mut Section<'t>) -> Option<(&'static str, Build)> {
    let (name, spot) = reader.string(root, "Template")?;
    let found = templates::TEMPLATES.into_iter().find(|(known, _)| *known == name);
    if found.is_none() {
        let known: Vec<&str> = templates::TEMPLATES.iter().map(|(known, _)| *known).collect();
        let message = format!("the template {} is not known; these are: {}", quoted(&name), known.join(", "));
        reader.error("unknown-template", &spot, message);
    }
    found
}

fn check_options(reader: &mut Reader<'_>, options: &ImportOptions) {
    let nowhere = Spot::default();
    match options.wheel {
        None => reader.warning("no-wheel", &nowhere, {
            "no wheel was given, and suspension files hold none: its mass is not in the answer".to_owned()
        }),
        Some(Wheel { radius: Some(radius), .. }) if !(radius.is_finite() && radius > 0.0) => {
            let message = format!("the wheel's radius is {radius} m; more than 0 is expected");
            reader.error("bad-radius", &nowhere, message);
        }
        Some(_) => {}
    }
}

/// Chassis, rack and the sides.
fn assemble(
    reader: &mut Reader<'_>,
    corner: Corner,
    name: &str,
    options: &ImportOptions,
) -> (MechanismBuilder, About) {
    let mut about = About::default();
    let mut builder = MechanismBuilder::new(name).link(LinkDescription::massless(CHASSIS));
    about
        .comments
        .links
        .insert(CHASSIS.to_owned(), "the vehicle's frame; its own mass is not given".to_owned());
    match (corner.rack(), options.rack) {
        (Some(at), rack) => builder = put_rack(builder, at, rack, &mut about),
        (None, Rack::Sliding { .. }) => {
            let message = "the template has no tie rod, so there is no rack to slide".to_owned();
            reader.warning("no-rack", &Spot::default(), message);
        }
        (None, Rack::Fixed) => {}
    }
    if options.side != Side::Left
        && let Some(spot) = reader.products.take()
    {
        let message = "the right side is the mirror image of the left; Chrono gives both sides the same products of inertia";
        reader.note("mirrored-products", &spot, message.to_owned());
    }
    let builder = match options.side {
        Side::Left => corner.put("", builder, &mut about),
        Side::Right => corner.mirrored().put("", builder, &mut about),
        Side::Both => {
            let right = corner.mirrored();
            let builder = corner.put("_left", builder, &mut about);
            right.put("_right", builder, &mut about)
        }
    };
    (builder, about)
}

fn put_rack(builder: MechanismBuilder, at: Vector3<f64>, rack: Rack, about: &mut About) -> MechanismBuilder {
    let (kind, link, comment) = match rack {
        Rack::Fixed => {
            let comment = "the tie rods' inner ends do not move; prismatic along y, it would steer";
            (JointKind::Fixed, LinkDescription::massless(RACK), comment)
        }
        Rack::Sliding { mass } => {
            let link = LinkDescription::new(RACK, Inertial::point(mass, [0.0; 3]));
            (JointKind::Prismatic, link, "steers")
        }
    };
    about.comments.links.insert(RACK.to_owned(), "holds the tie rods' inner ends".to_owned());
    about.comments.joints.insert(RACK.to_owned(), comment.to_owned());
    let joint = JointDescription::new(RACK, kind, CHASSIS, RACK).at(at.into());
    let joint = if kind.has_axis() { joint.axis([0.0, 1.0, 0.0]) } else { joint };
    builder.link(link).joint(joint)
}

fn heading(name: &str, template: &str, source: &Source, options: &ImportOptions) -> Vec<String> {
    let side = match options.side {
        Side::Left => "left side",
        Side::Right => "right side, the mirror image of the file's left one",
        Side::Both => "both sides, the right one the mirror image of the file's left one",
    };
    let wheel = match options.wheel {
        Some(wheel) => format!("with a wheel of {} kg", wheel.mass),
        None => "without a wheel".to_owned(),
    };
    vec![
        format!("{}: Chrono::Vehicle's template {template}, {side}, {wheel}", quoted(name)),
        format!("imported by percuss from {}", quoted(&source.name)),
        "the chassis' frame: x forward, y left, z up; joints at 0 are the design position".to_owned(),
    ]
}
