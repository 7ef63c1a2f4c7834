//! Commented starting study for a model: links and joints by name, and a contact with a result.

use crate::checks::model_check::{CheckReport, JointRecord, check};
use crate::evaluation::status::Status;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::names::{Names, conditions_error_key};
use crate::question::tables::contact::{BaseName, ConditionsTable, ContactTable};
use crate::reports::answer_mass::mass;
use crate::reports::mass_report::MassReport;
use percuss_dynamics::{Base, Conditions, System};
use percuss_mechanism::{ContactKind, LinkId, Mechanism, NamedContact};
use percuss_units::{Dimension, Unit};
use std::fmt::Write;
use std::sync::Arc;

/// Largest number of contacts tried; for a robot with many tips the first is sufficient.
const CANDIDATES: usize = 60;
/// Largest number of names listed in a comment.
const LISTED: usize = 40;
/// Starting study of a model, as TOML with comments. The contact is the first with a finite effective mass:
/// named contacts first, stops before all, then tips of the mechanism.
/// Further keys are commented out. `path`: model path written to the study.
///
/// # Errors
/// [`StudyError`]: loops that do not close, no contact with a result.
pub fn starting_study(model: &Model, path: &str) -> Result<String, StudyError> {
    let seen = check(model)?;
    let (question, report) = contact(model, base(&seen))?;
    let conditions = Conditions::new().base(question.conditions.base());
    let system = System::new(Arc::clone(&model.mechanism), &conditions)
        .map_err(|error| StudyError::input(conditions_error_key(&error), error))?;
    let mechanism = &model.mechanism;
    let bound = mechanism.joint_ids().filter(|joint| system.is_bound(*joint));
    let bound = bound.map(|joint| mechanism.joint(joint).name()).collect();
    Ok(StarterWriter { model, check: &seen, question: &question, report: &report, loop_joints: bound }
        .text(path))
}

/// Contact and base of the starting study of a model.
///
/// # Errors
/// As for [`starting_study`].
pub fn starting_contact(model: &Model) -> Result<(ContactTable, BaseName), StudyError> {
    let (question, _) = contact(model, base(&check(model)?))?;
    Ok((question.contact, question.conditions.base.unwrap_or_default()))
}

/// Base for which the mechanism moves.
fn base(seen: &CheckReport) -> BaseName {
    if seen.degrees_of_freedom == 0 { BaseName::Floating } else { BaseName::Fixed }
}

/// First contact with a finite mass at a regular pose; otherwise the best result found.
fn contact(model: &Model, base: BaseName) -> Result<(MassQuestion, MassReport), StudyError> {
    let rank = |report: &MassReport| match (report.status, report.singular_pose) {
        (Status::Finite, false) => 0,
        (Status::Finite, true) => 1,
        (Status::Immovable | Status::Massless, _) => 2,
    };
    let mut best: Option<(MassQuestion, MassReport)> = None;
    let mut failed = None;
    for question in candidate_contacts(model, base).into_iter().take(CANDIDATES) {
        match mass(model, &question) {
            Ok(report) => {
                if best.as_ref().is_none_or(|(_, so_far)| rank(&report) < rank(so_far)) {
                    best = Some((question, report));
                }
                if best.as_ref().is_some_and(|(_, report)| rank(report) == 0) {
                    break;
                }
            }
            Err(error) => failed = Some(error),
        }
    }
    // Every mechanism has a link, so there is at least one candidate.
    match (best, failed) {
        (Some(best), _) => Ok(best),
        (None, Some(error)) => Err(error),
        (None, None) => mass(model, &MassQuestion::default()).map(|report| (MassQuestion::default(), report)),
    }
}

/// Candidate contacts, in order of plausibility.
fn candidate_contacts(model: &Model, base: BaseName) -> Vec<MassQuestion> {
    let mechanism = &model.mechanism;
    let name = |id: LinkId| mechanism.link(id).name();
    let of = |contact: ContactTable| MassQuestion {
        contact,
        conditions: ConditionsTable { base: Some(base), ..ConditionsTable::default() },
        names: Names::KEYS,
        ..MassQuestion::default()
    };
    let mut found = Vec::new();
    let mut named: Vec<&NamedContact> = mechanism.contacts().iter().collect();
    // The bump stop is the usual question; on the rod of the damper it is the last stop of the model.
    named.sort_by_key(|contact| {
        (contact.kind() != ContactKind::Stop, !contact.name().starts_with("bump_stop"))
    });
    let at = |contact: &NamedContact| Some(contact.name().to_owned());
    found.extend(
        named.into_iter().map(|contact| of(ContactTable { at: at(contact), ..ContactTable::default() })),
    );
    for link in links_by_depth(mechanism) {
        for point in points(mechanism, link) {
            for axis in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
                found.push(of(ContactTable::at_point(name(link), point, axis)));
            }
        }
    }
    found
}

/// Links in order of decreasing number of movable joints between link and root; among equal numbers, links
/// without children first.
fn links_by_depth(mechanism: &Mechanism) -> Vec<LinkId> {
    let depth = |link: LinkId| {
        let above = std::iter::successors(mechanism.parent_joint(link), |joint| {
            mechanism.parent_joint(mechanism.joint(*joint).parent())
        });
        above.filter(|joint| mechanism.joint(*joint).kind().dofs() > 0).count()
    };
    let carries = |link: LinkId| mechanism.joints().iter().any(|joint| joint.parent() == link);
    let mut links: Vec<LinkId> = mechanism.link_ids().collect();
    links.sort_by_key(|link| (std::cmp::Reverse(depth(*link)), carries(*link)));
    links
}

/// Points of a link: centre of mass, origin, and a point away from both.
fn points(mechanism: &Mechanism, link: LinkId) -> Vec<[f64; 3]> {
    let size = 0.1 * mechanism.characteristic_length();
    let mass = mechanism.link(link).inertial().filter(|inertial| inertial.mass > 0.0);
    let com: Option<[f64; 3]> = mass.map(|inertial| inertial.com.into());
    let com = com.map(|com| com.map(|x| (x * 1e6).round() / 1e6 + 0.0));
    let beside = [1.0, 0.5, 0.25].map(|x| (x * size * 1e3).round().max(1.0) / 1e3);
    let mut points: Vec<[f64; 3]> = com.into_iter().collect();
    points.extend([[0.0; 3], beside]);
    points.dedup();
    points
}

/// Quoted TOML string; line breaks are escaped.
fn toml_string(text: &str) -> String {
    let json = serde_json::to_string(text).unwrap_or_default();
    json.replace('\u{7f}', "\\u007f")
}

/// TOML key, quoted if necessary.
fn key(name: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !name.is_empty() && name.chars().all(is_bare) { name.to_owned() } else { toml_string(name) }
}

/// Three numbers as a TOML array.
fn triple(values: &[f64; 3]) -> String {
    format!("[{}, {}, {}]", values[0], values[1], values[2])
}

struct StarterWriter<'a> {
    model: &'a Model,
    check: &'a CheckReport,
    question: &'a MassQuestion,
    report: &'a MassReport,
    /// Joints bound by loops.
    loop_joints: Vec<&'a str>,
}

impl StarterWriter<'_> {
    /// Text of the study.
    fn text(&self, path: &str) -> String {
        let mut out = String::new();
        // Writing to a string does not fail.
        let _ = self.write(path, &mut out);
        out
    }

    /// Writes all parts of the study.
    fn write(&self, path: &str, out: &mut String) -> std::fmt::Result {
        let question = self.question;
        writeln!(out, "# A study to start from, as percuss init writes it.")?;
        writeln!(out, "#   percuss run STUDY.toml                          the answer")?;
        writeln!(out, "#   percuss run STUDY.toml --report report.html     all of it, on one page")?;
        writeln!(
            out,
            "# Lines that begin with \"# \" and a key or a [table] are suggestions: take the \"# \" away."
        )?;
        writeln!(out, "# All keys: docs/reference/STUDIES.md; `percuss schema` prints them for editors.\n")?;
        writeln!(out, "[model]\npath = {}\n", toml_string(path))?;
        self.links(out)?;
        match &question.contact.at {
            Some(name) => {
                writeln!(out, "\n# A named contact of the model; a stop is brought to the touch.")?;
                writeln!(out, "[contact]\nat = {}", toml_string(name))?;
                let others = self.model.mechanism.contacts().iter().map(NamedContact::name);
                let others: Vec<String> = others.filter(|other| other != name).map(toml_string).collect();
                if !others.is_empty() {
                    writeln!(out, "#   other contacts: {}; \"all\" for every contact", others.join(", "))?;
                }
            }
            None => self.contact(out)?,
        }
        if question.conditions.base() == Base::Floating {
            writeln!(out, "\n# With a fixed root nothing moves.\n[conditions]\nbase = \"floating\"")?;
        }
        self.pose(out)?;
        self.sweep(out)?;
        writeln!(out, "\n# What the effective mass depends on, and what tolerances leave of it.")?;
        writeln!(out, "# [mass]\n# explain = true\n# tolerance = \"mass=2%\"")?;
        writeln!(out, "\n# The damper that gives a restitution, and the parameters for simulators.")?;
        writeln!(
            out,
            "# [damping]\n# restitution = 0.3\n# stiffness = \"200 N/mm\"\n# speed = 0.5\n# for = [\"mujoco\"]"
        )?;
        self.variant(out)?;
        self.map(out)?;
        if self.report.contact.against.is_none() && self.report.status == Status::Finite {
            writeln!(
                out,
                "\n# How fast this contact may go where it may hit a person; the limit is that of your standard."
            )?;
            writeln!(out, "# [safe_speed]\n# region = \"chest\"\n# force = 280")?;
        }
        let title = toml_string(&format!("Effective mass of {}", self.model.mechanism.name()));
        writeln!(
            out,
            "\n# Title, author and date of the report. percuss does not insert the current date, so that a repeated run writes the same page."
        )?;
        writeln!(out, "# [report]\n# title = {title}\n# author = \"A. Author\"\n# date = \"DATE\"")
    }

    /// Writes the link, point and normal of a contact without a name.
    fn contact(&self, out: &mut String) -> std::fmt::Result {
        let question = self.question;
        writeln!(
            out,
            "\n# Point and normal are in the frame of the link. The normal points out of it; its length does not matter."
        )?;
        let link = toml_string(question.contact.link());
        writeln!(out, "[contact]\nlink = {link}\npoint = {}", triple(&question.contact.point()))?;
        let normal = question.contact.normal.unwrap_or_default().0;
        writeln!(out, "normal = {}", triple(&normal))?;
        writeln!(
            out,
            "#   against = \"LINK\": another link in place of the ground; or against_mass = \"2 kg\""
        )
    }

    /// Writes the names of the links as a comment.
    fn links(&self, out: &mut String) -> std::fmt::Result {
        writeln!(out, "# Links (kg):")?;
        for link in self.check.links.iter().take(LISTED) {
            writeln!(out, "#   {} {}", toml_string(&link.name), link.mass)?;
        }
        self.write_omitted_count(self.check.links.len(), out)
    }

    /// Writes the number of names that are not listed.
    fn write_omitted_count(&self, count: usize, out: &mut String) -> std::fmt::Result {
        if count > LISTED { writeln!(out, "#   and {} more: percuss check", count - LISTED) } else { Ok(()) }
    }

    /// Joints that can be set: drivers of loops, and joints outside of loops.
    fn free(&self) -> Vec<&JointRecord> {
        let (seen, assumed) = (self.check, &self.report.assumptions);
        let is_free = |joint: &&JointRecord| {
            let in_loops = self.loop_joints.contains(&joint.name.as_str());
            assumed.free.contains(&joint.name) && (!in_loops || seen.drivers.contains(&joint.name))
        };
        seen.joints.iter().filter(is_free).collect()
    }

    /// Writes the table of the pose, with suggestions.
    fn pose(&self, out: &mut String) -> std::fmt::Result {
        let free = self.free();
        let single: Vec<&&JointRecord> = free.iter().filter(|joint| unit(joint).is_some()).collect();
        if free.is_empty() {
            return Ok(());
        }
        writeln!(out, "\n# Joints that can be set (what follows from loops follows):")?;
        for joint in free.iter().take(LISTED) {
            writeln!(out, "#   {} {}{}", toml_string(&joint.name), joint.kind, limits_text(joint))?;
        }
        self.write_omitted_count(free.len(), out)?;
        let varied = self.suggested_range();
        let other = single.iter().find(|joint| match &varied {
            None => true,
            Some((varied, _)) => varied.is_some_and(|varied| varied != joint.name),
        });
        let set = |joint: &JointRecord| {
            let at = self.report.pose.get(&joint.name).and_then(|values| values.first().copied());
            format!("set = {{ {} = {:?} }}", key(&joint.name), at.unwrap_or_default() + 0.0)
        };
        match (other, single.first()) {
            (Some(joint), _) => writeln!(out, "# [pose]\n# {}", set(joint)),
            // The only joint is the varied joint, or the driver of the travel.
            (None, Some(joint)) => {
                writeln!(out, "#   [pose] {}, not together with a [sweep] that moves it", set(joint))
            }
            (None, None) => Ok(()),
        }
    }

    /// Writes a suggested sweep.
    fn sweep(&self, out: &mut String) -> std::fmt::Result {
        let Some((_, vary)) = self.suggested_range() else { return Ok(()) };
        writeln!(out, "\n# The contact over a range. In place of output: CSV on stdout.")?;
        writeln!(out, "# [sweep]\n# vary = {}\n# output = \"sweep.svg\"", toml_string(&vary))?;
        let is_of_wheels = ["wheel-travel=", "heave="].iter().any(|motion| vary.starts_with(motion));
        if self.model.origin.sheet.is_none() || !is_of_wheels {
            return Ok(());
        }
        writeln!(
            out,
            "\n# Camber, toe, motion ratios over the travel.\n#   columns = [\"camber\", \"toe\"] selects some"
        )?;
        writeln!(out, "# [kinematics]\n# vary = {}\n# output = \"kinematics.svg\"", toml_string(&vary))
    }

    /// Range of a sweep, and the name of the varied joint: the wheel travel if there is a wheel (without a
    /// joint name), otherwise a joint between the contact link and the root.
    fn suggested_range(&self) -> Option<(Option<&str>, String)> {
        let mechanism = &self.model.mechanism;
        let mut names = mechanism.links().iter().map(|link| link.name());
        if let Some(wheel) = names.find(|name| name.starts_with("wheel_centre"))
            && !mechanism.closures().is_empty()
        {
            let motion = if wheel == "wheel_centre" { "wheel-travel" } else { "heave" };
            return Some((None, format!("{motion}=-30mm:30mm:25")));
        }
        let free = self.free();
        let link = mechanism.find_link(&self.report.contact.link).ok()?;
        let above = std::iter::successors(mechanism.parent_joint(link), |joint| {
            mechanism.parent_joint(mechanism.joint(*joint).parent())
        });
        let carrying: Vec<&str> = above.map(|joint| mechanism.joint(joint).name()).collect();
        let is_single = |joint: &&&JointRecord| unit(joint).is_some();
        let joint = free.iter().filter(is_single).find(|joint| carrying.contains(&joint.name.as_str()));
        let joint = joint.or_else(|| free.iter().find(is_single))?;
        let at = self.report.pose.get(&joint.name)?.first().copied()?;
        let Unit { name: unit, per_si: scale, .. } = *unit(joint)?;
        // Small range on both sides, within the limits.
        let side = if unit == "deg" { 10_f64.to_radians() } else { 0.02 };
        let [low, high] = joint.limits.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let (from, to) = ((at - side).max(low), (at + side).min(high));
        let shown = |x: f64| (x * scale * 1e6).round() / 1e6 + 0.0;
        let range = format!("{}={}{unit}:{}{unit}:21", joint.name, shown(from), shown(to));
        let name = free.iter().find(|one| one.name == joint.name).map(|one| one.name.as_str());
        (from < to).then_some((name, range))
    }

    /// Writes a suggested variant.
    fn variant(&self, out: &mut String) -> std::fmt::Result {
        let most = self.report.bodies.iter().filter_map(|body| Some((body.share?, &body.link)));
        let most = most.filter(|(share, _)| *share > 0.0).max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, link)) = most else { return Ok(()) };
        let Some(mass) = self.check.links.iter().find(|l| l.name == *link).map(|l| l.mass) else {
            return Ok(());
        };
        writeln!(
            out,
            "\n# The same with something changed, side by side: link_mass, link_com, link_inertia, armature, set, move, \
             model, contact."
        )?;
        let lighter = (0.9 * mass * 1e6).round() / 1e6;
        let name = toml_string(&format!("{link} 10 % lighter"));
        writeln!(out, "# [[variant]]\n# name = {name}\n# link_mass = {{ {} = {lighter:?} }}", key(link))?;
        let points = self.model.hardpoints();
        let Some(point) = points.iter().find(|point| point.contains("ball")).or(points.first()) else {
            return Ok(());
        };
        let name = toml_string(&format!("{point} 5 mm higher"));
        writeln!(out, "# [[variant]]\n# name = {name}\n# move = {{ {} = [0, 0, \"5 mm\"] }}", key(point))
    }

    /// Writes a suggested map.
    fn map(&self, out: &mut String) -> std::fmt::Result {
        let link = self.model.mechanism.find_link(&self.report.contact.link).ok();
        let shapes = |id: LinkId| self.model.shapes.get(id.index()).is_some_and(|shapes| !shapes.is_empty());
        if !link.is_some_and(shapes) {
            return Ok(());
        }
        writeln!(out, "\n# The effective mass over the surface of a link.")?;
        writeln!(out, "# [map]\n# link = {}\n# output = \"map.png\"", toml_string(&self.report.contact.link))
    }
}

/// Display unit of a position; `None` unless the position is a single number.
fn unit(joint: &JointRecord) -> Option<&'static Unit> {
    match joint.kind {
        "revolute" | "continuous" => Dimension::Angle.display_unit(),
        "prismatic" => Dimension::Length.display_unit(),
        _ => None,
    }
}

/// Limits of a joint as text, in the unit of the study; empty without limits.
fn limits_text(joint: &JointRecord) -> String {
    let shown = |x: f64, scale: f64| (x * scale * 1e3).round() / 1e3 + 0.0;
    match (joint.limits, unit(joint)) {
        (Some([low, high]), Some(&Unit { name: unit, per_si: scale, .. })) => {
            format!(", {} to {} {unit}", shown(low, scale), shown(high, scale))
        }
        _ => String::new(),
    }
}
