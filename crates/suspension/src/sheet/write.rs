//! Writer of sheets to fill in, and of the tables in the documentation.

use super::catalogue::{DAMPER, HEAD};
use super::catalogue::{description_of, keys, templates, universal_links};
use super::template::{Shape, Template, symmetric_matrix};
use crate::corner::CHASSIS;
use crate::corner::design::{Part, STOPS, THIRD_SPRING};
use crate::units::VehicleAxes;
use percuss_spatial::Vector3;
use percuss_units::LengthUnit;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Unit and axes of a sheet to fill in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TemplateOptions {
    /// Unit of all lengths.
    pub unit: LengthUnit,
    /// Axes of the vehicle.
    pub axes: VehicleAxes,
}

impl Default for TemplateOptions {
    fn default() -> Self {
        Self { unit: LengthUnit::Millimetre, axes: VehicleAxes::ISO }
    }
}

/// Name and title of every template.
pub fn template_names() -> Vec<(&'static str, &'static str)> {
    templates().map(|t| (&*t.name, &*t.title)).collect()
}

/// Writes a commented sheet of a template, to fill in; `None` for an unknown template.
///
/// The values are an example that can be imported unchanged. They describe the same suspension in all units and axes
/// (inches to 2.5 µm).
pub fn template_sheet(name: &str, options: &TemplateOptions) -> Option<String> {
    let template = templates().find(|t| t.name == name)?;
    let mut sheet = SheetWriter { out: String::new(), options };
    sheet.write_head(template);
    sheet.write_points(template);
    sheet.write_bodies(template);
    sheet.write_wheel(template);
    sheet.write_attachments(template);
    Some(sheet.out)
}

/// Columns of a sheet as a table.
pub const TABLE_COLUMNS: [&str; 5] = ["name", "x", "y", "z", "remark"];

/// Sheet of a template as the rows of a table (CSV, XLSX) with the columns [`TABLE_COLUMNS`]: a key and its values, `lower_arm.mass`, or a
/// comment that begins with #. `None` for an unknown template. Values and errors: those of [`template_sheet`].
pub fn template_rows(name: &str, options: &TemplateOptions) -> Option<Vec<Vec<String>>> {
    let text = template_sheet(name, options)?;
    let (mut rows, mut section): (Vec<Vec<String>>, _) = (Vec::new(), "");
    for line in text.lines().filter(|line| !line.is_empty()) {
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            section = name;
            continue;
        }
        let Some((key, value)) = line.split_once(" = ").filter(|_| !line.starts_with('#')) else {
            rows.push(vec![line.replace("THIS.toml", "THIS")]);
            continue;
        };
        let (value, comment) = value.split_once(" # ").unwrap_or((value, ""));
        let value = value.trim();
        let cells: Vec<String> = match value.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            Some(list) => list.split(", ").map(str::to_owned).collect(),
            None => vec![value.trim_matches('"').to_owned()],
        };
        let key = if section == "points" || section.is_empty() {
            key.to_owned()
        } else {
            format!("{section}.{key}")
        };
        // Only points may have a remark in their row.
        if section == "points" {
            rows.push([key].into_iter().chain(cells).chain([comment.to_owned()]).collect());
        } else {
            rows.extend((!comment.is_empty()).then(|| vec![format!("# {key}: {comment}")]));
            rows.push([key].into_iter().chain(cells).collect());
        }
    }
    Some(rows)
}

struct SheetWriter<'o> {
    out: String,
    options: &'o TemplateOptions,
}

impl SheetWriter<'_> {
    fn write_line(&mut self, text: &str) {
        self.out.push_str(text.trim_end());
        self.out.push('\n');
    }

    /// Writes a key with its value and its comment, in columns.
    fn write_key(&mut self, key: &str, value: &str, comment: &str) {
        let pair = format!("{key} = {value}");
        self.write_line(&if comment.is_empty() { pair } else { format!("{pair:<46} # {comment}") });
    }

    fn write_head(&mut self, template: &Template) {
        let (unit, axes) = (self.options.unit.name(), self.options.axes);
        self.write_line(&format!("# A suspension for percuss: {}.", template.title));
        for line in &template.about {
            self.write_line(&format!("# {line}"));
        }
        self.write_line("#");
        self.write_line("# The values are an example and describe no actual vehicle: replace them. Then");
        let is_both = template.axle || template.point(THIRD_SPRING.1).is_some();
        let side = if is_both { "_left" } else { "" };
        self.write_line("#   percuss mass THIS.toml --at all");
        self.write_line(&format!("#   percuss mass THIS.toml --at bump_stop{side}"));
        self.write_line(
            "# print the effective masses at all contacts, and the effective mass at the touch of the bump stop.",
        );
        self.write_line("");
        self.write_key("template", &format!("\"{}\"", template.name), "");
        self.write_key("name", &format!("\"{}\"", template.title), "yours");
        self.write_key("unit", &format!("\"{unit}\""), "unit of all lengths: m, cm, mm or in");
        self.write_key("inertia_unit", "\"kg m2\"", "or kg mm2, kg cm2, g mm2, t mm2");
        let other = axes.turned();
        let words = format!("{}; or {}: {}", axes.words(), other.name(), other.words());
        self.write_key("axes", &format!("\"{}\"", axes.name()), &words);
        self.write_key("side", "\"left\"", "side of the points: left or right");
        let build = if is_both { "\"both\"" } else { "\"left\"" };
        let comment = match template.only_build() {
            Some(_) if template.axle => "both sides are on one axle",
            Some(_) => "the wheel is in the middle plane",
            None => "left, right or both",
        };
        self.write_key("build", build, &format!("what is built: {comment}"));
        self.write_line(
            "# points = \"points.csv\"   a table of names, x, y, z (CSV or XLSX) instead of [points]",
        );
    }

    /// Formats a length given in millimetres, in the unit of the sheet.
    fn length_text(&self, millimetres: f64) -> String {
        let value = match self.options.unit {
            LengthUnit::Millimetre => millimetres,
            LengthUnit::Centimetre => millimetres / 10.0,
            LengthUnit::Metre => millimetres / 1000.0,
            LengthUnit::Inch => (millimetres / 25.4 * 1e4).round() / 1e4,
        };
        number(value)
    }

    /// Formats a point given in millimetres and the axes of ISO 8855, in the unit and axes of the sheet.
    fn point_text(&self, at: [f64; 3]) -> String {
        let at = self.options.axes.from_iso(Vector3::from(at));
        let [x, y, z] = [at.x, at.y, at.z].map(|x| self.length_text(x));
        format!("[{x}, {y}, {z}]")
    }

    fn write_points(&mut self, template: &Template) {
        self.write_line("");
        self.write_line("# Hardpoints, [x, y, z] at the design position. A spring, damper or stop may be left out with its");
        let bar =
            if template.middle { "" } else { ", the anti-roll bar with its two sections and four points" };
        self.write_line(&format!("# section and both points{bar}."));
        self.write_line("[points]");
        for (key, at) in &template.points {
            let at = self.point_text(*at);
            self.write_key(key, &at, description_of(&keys().points, key));
        }
    }

    fn write_bodies(&mut self, template: &Template) {
        self.write_line("");
        self.write_line("# Bodies: mass in kg (0 is legal); centre of mass; inertia about it in the vehicle's axes, [xx, yy, zz]");
        self.write_line("# or [xx, yy, zz, xy, xz, yz], the entries of the matrix (xy = −∫ x y dm).");
        for (key, body) in &template.bodies {
            self.write_line("");
            self.write_line(&format!("# {}", description_of(&keys().bodies, key)));
            match body.shape {
                Shape::Rod => {
                    self.write_line("# With only a mass, a slender rod; with com and inertia, any body; without this section, massless.");
                    self.write_rod_ends(template, key);
                }
                Shape::Optional => self.write_line("# May be left out."),
                Shape::Spindle => self.write_line("# Its centre of mass is the wheel centre unless com is given; inertia in the wheel's axes, y along the spin axis."),
                Shape::Any => {}
            }
            self.write_line(&format!("[{key}]"));
            self.write_key("mass", &number(body.mass), "");
            if let Some((_, link)) = template.on.iter().find(|(section, _)| section == key) {
                self.write_key("on", &format!("\"{link}\""), "the link at its outer end");
            }
            if body.shape == Shape::Rod {
                continue;
            }
            if body.shape != Shape::Spindle {
                let com = self.point_text(body.com);
                self.write_key("com", &com, "");
            }
            let matrix = self.options.axes.inertia_from_iso(symmetric_matrix(&body.inertia));
            let all = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|at| matrix[at] + 0.0);
            let kept = if all[3..] == [0.0; 3] { &all[..3] } else { &all[..] };
            let list: Vec<String> = kept.iter().map(|x| number(*x)).collect();
            self.write_key("inertia", &format!("[{}]", list.join(", ")), "");
            if body.shape == Shape::Spindle {
                let comment = "of the drive shaft about the spin axis, if the wheel is driven";
                self.write_key("axle_inertia", "0.0", comment);
            }
        }
    }

    /// Writes the end of the universal joint of a rod. The end matters if the rod has an inertia about the rod axis.
    fn write_rod_ends(&mut self, template: &Template, rod: &str) {
        let first = template.parts_with_bar().find_map(|part| match part {
            Part::Rod { link, ends: [(_, first), _], .. } if link == rod => Some(first),
            _ => None,
        });
        if let Some(first) = first {
            self.write_line(&format!(
                "# Its universal joint is at {first}, its ball joint at the other end."
            ));
        }
    }

    fn write_wheel(&mut self, template: &Template) {
        self.write_line("");
        self.write_line("# the wheel with its tyre; inertia about its centre, y along the spin axis");
        self.write_line("[wheel]");
        self.write_key("mass", "18.5", "");
        self.write_key("inertia", "[0.62, 1.05, 0.62]", "");
        let radius = self.length_text(template.point("wheel_centre").map_or(300.0, |at| at[2]));
        self.write_key("radius", &radius, "its lowest point is named contact_patch");
        self.write_key("camber", "\"0 deg\"", "positive: the top leans outward");
        self.write_key("toe", "\"0 deg\"", "positive: toe-in");
    }

    /// Writes the links to which springs, dampers and stops are attached, the gaps of stops, and the rack.
    fn write_attachments(&mut self, template: &Template) {
        let holders: Vec<&str> = template.holders_of("spring").collect();
        self.write_line("");
        self.write_line(&format!("# Each is on one of these links: {}.", holders.join(", ")));
        let is_body = |section: &str| template.bodies.iter().any(|(key, _)| key == section);
        for (section, link) in template.on.iter().filter(|(section, _)| !is_body(section)) {
            self.write_line(&format!("[{section}]"));
            self.write_key("on", &format!("\"{link}\""), "");
            let forces = match &**section {
                DAMPER => {
                    "# damping = \"1500 N·s/m\"   or speeds = [-1.0, 0.0, 0.5] (m/s) and forces = [-900, 0, 1300] (N), positive in rebound"
                }
                stop if STOPS.contains(&stop) => {
                    "# deflections and forces (N), [0, …] each; or coefficients, exponents and to: sum of c x^p in N"
                }
                spring if spring.ends_with("spring") => {
                    "# rate = \"28 N/mm\" and preload = 3200 (N, compressed): for kinematics and impacts in time"
                }
                _ => "",
            };
            if !forces.is_empty() {
                self.write_line(forces);
            }
            let Some((_, gap)) = template.gaps.iter().find(|(stop, _)| stop == section) else { continue };
            let gap = self.length_text(*gap);
            self.write_key("gap", &gap, "at the design position; default: the distance of its points");
        }
        self.write_line("# A stop may have the key direction = [x, y, z], from the pad to the stop; default: the line of its points.");
        self.write_line("# Any other contact: [contact.NAME] with point and direction, [x, y, z], on (a link); optional: against, gap.");
        self.write_line("# A stop on the rod of the damper has on = \"damper\", a gap (a change of the damper's length) and no points.");
        self.write_line("# For impacts in time: [tyre] with vertical = \"210 N/mm\", damping; stiffness = \"12 N·m/deg\" in [anti_roll_bar].");
        if template.has_rack() {
            self.write_line("");
            self.write_line("# The rack holds the tie rods' inner ends: fixed to the chassis, or sliding along y to steer.");
            self.write_line("[rack]");
            self.write_key("slides", "false", "");
            self.write_key("mass", "2.5", "has an influence if the rack slides");
        }
    }
}

/// Formats a number for TOML.
fn number(x: f64) -> String {
    format!("{x:?}")
}

/// Markdown table of all keys of all templates, for the documentation.
pub fn template_keys() -> String {
    let mut out = String::from("| key | meaning | templates |\n|---|---|---|\n");
    let mut row = |key: &str, meaning: &str, within: &str| {
        let _ = writeln!(out, "| `{key}` | {meaning} | {within} |");
    };
    let of = |has: &dyn Fn(&Template) -> bool| {
        let names: Vec<String> = templates().filter(|t| has(t)).map(|t| format!("`{}`", t.name)).collect();
        if names.len() == templates().count() { "all".to_owned() } else { names.join(", ") }
    };
    let head = [
        "name of the template",
        "name of the suspension; default: the name of the template",
        "unit of all lengths that have no unit of their own: m, cm, mm, in; required",
        "unit of all inertias that have no unit of their own: kg m2 (default), kg cm2, kg mm2, g mm2, t mm2, lb in2",
        "`iso` (x forward, y left, z up), `adams` (x backward, y right, z up), `sae` (x forward, y right, z down), `rfactor` (x left, y up, \
         z backward), or the axes of the file that point forward, left and up: `\"-z x y\"`; required",
        "side of the points: left (default) or right",
        "side to build: left, right or both; default: the side of the points",
        "file of a table in place of the section `[points]`, relative to the folder of the sheet",
        "name of the worksheet if the table of points is a workbook; default: the first one",
        "file of the names of the table's points, in place of a section `[names]`: `lower_ball = \"LBJ\"`",
        "`\"estimate\"`: masses, centres of mass and inertias that are missing are those of the template's example, scaled to the size of each \
         part; a warning lists them",
    ];
    for (key, meaning) in HEAD.iter().zip(head) {
        row(key, meaning, "all");
    }
    for (key, meaning) in &keys().points {
        row(&format!("points.{key}"), meaning, &of(&|t| t.point(key).is_some()));
    }
    for (key, meaning) in &keys().bodies {
        let body = templates().flat_map(|t| &t.bodies).find(|(known, _)| known == key);
        let shape = body.map(|(_, body)| body.shape);
        let remark = match shape {
            Some(Shape::Rod) => "; with only `mass` a slender rod, without this section massless",
            Some(Shape::Optional) => "; may be left out",
            Some(Shape::Spindle) => "; default of `com`: the wheel centre; `inertia` along the wheel's axes",
            Some(Shape::Any) | None => "",
        };
        let of_body = format!("{key}.mass`, `.com`, `.inertia");
        row(
            &of_body,
            &format!("{meaning}{remark}"),
            &of(&|t| key == CHASSIS || t.bodies.iter().any(|(known, _)| known == key)),
        );
    }
    let on_pins: BTreeSet<&str> = templates().flat_map(universal_links).collect();
    let pins: Vec<String> = on_pins.into_iter().map(|link| format!("{link}.pin")).collect();
    row(
        &pins.join("`, `"),
        "direction of the first pin of its universal joint, `[x, y, z]`: the pin is fixed to the body at the first end (chassis, rack \
         or bar); the second pin is normal to this pin and to the link. Default: normal to the link and to the x axis. The pins have \
         an influence if the link has a moment of inertia about its line",
        "templates with this link",
    );
    row(
        "spindle.axle_inertia",
        "inertia of the drive shaft about the spin axis, added to that of the spindle",
        "all",
    );
    row(
        "wheel.mass`, `.inertia",
        "the wheel with its tyre: inertia about its centre, y along the spin axis",
        "all",
    );
    row("wheel.radius", "with a radius, the lowest point of the wheel is named `contact_patch`", "all");
    row(
        "wheel.tyre",
        "in place of the radius, that of the unloaded tyre: `\"205/55 R16\"`, `\"18.0x7.5-10\"`",
        "all",
    );
    row(
        "wheel.half_track`, `.longitudinal_offset`, `.lateral_offset`, `.vertical_offset",
        "in place of the point `wheel_centre`: half of the track at the road z = 0; with the radius r and the camber γ, y = half track + \
         r sin γ and z = r cos γ, each with its offset (default 0; longitudinal in the axes of the sheet)",
        "all",
    );
    row("wheel.camber`, `.toe", "with a unit: `\"-1 deg\"`; positive: top outward, toe-in", "all");
    for section in ["spring", "third_spring", "damper", "bump_stop", "rebound_stop", "drop_link", "pushrod"] {
        let with = of(&|t| t.on.iter().any(|(key, _)| key == section));
        let meaning = if STOPS.contains(&section) {
            "the link that its pad is on, or `\"damper\"` for a stop on the rod of the damper"
        } else {
            "the link of its attachment: a link of one side; for a pushrod no rod"
        };
        row(&format!("{section}.on"), meaning, &with);
    }
    row(
        "bump_stop.gap`, `rebound_stop.gap",
        "the gap at the design position; without it, the distance of pad and stop along the direction. For a stop on the \
         damper (a gap, no points), the change of the damper's length",
        "all",
    );
    row(
        "bump_stop.direction`, `rebound_stop.direction",
        "from the pad to the stop; without it, the line between the two points",
        "all",
    );
    row(
        "spring.rate",
        "with a unit: `\"28 N/mm\"`; for `percuss kinematics`, and for impacts in time",
        "all",
    );
    row(
        "spring.mass`, `damper.mass",
        "mass of the spring and of the damper: half of it moves with the moving seat as a point mass, the other half is on the chassis",
        "all",
    );
    row(
        "half_shaft.mass`, `.outer",
        "mass of the half shaft: half of it moves with the wheel as a point mass at its outer joint (a point; default: the wheel centre), the other \
         half is on the chassis",
        &of(&|t| !t.middle),
    );
    row(
        "points.rocker_pivot`, `rocker.axis",
        "in place of `points.rocker_front` and `.rocker_back`: the pivot of the rocker, and the direction of its axis; default: normal to the \
         plane of the pivot, `pushrod_rocker` and `damper_seat` (or `spring_seat`)",
        &of(&|t| t.point("rocker_front").is_some()),
    );
    row(
        "points.right.NAME`, `points.left.NAME",
        "a point of the other side that is no mirror image, of the side that `side` does not state; with `build = \"both\"`",
        &of(&|t| !t.middle),
    );
    row("spring.preload", "the force at the design position, N; positive: compressed", "all");
    let third = of(&|t| t.on.iter().any(|(key, _)| key == "third_spring"));
    row("third_spring.rate`, `.preload", "rate and preload of the spring between both sides", &third);
    row(
        "damper.damping`, or `damper.speeds`, `.forces",
        "with a unit: `\"1500 N·s/m\"`; or the force over the speed, two lists of the same length through 0, positive in rebound (the damper gets \
         longer; speeds in m/s, forces in N without a unit): for impacts in time",
        "all",
    );
    row(
        "bump_stop.deflections`, `.forces`, `rebound_stop.deflections`, `.forces",
        "the stop's force over its compression: two lists of the same length, the compressions from 0; for `percuss kinematics`, and the \
         stiffness of the contact in `percuss damp`, `percuss restitution` and `percuss impact`",
        "all",
    );
    row(
        "bump_stop.coefficients`, `.exponents`, `.to`, and those of `rebound_stop",
        "in place of the lists: the force Σ cᵢ x^pᵢ, a polynomial or k xᵖ, with x in the unit of the sheet and the force in N. `exponents`: \
         default 1, 2, 3 …; `to`: the last deflection of this law, beyond which its slope continues",
        "all",
    );
    row(
        "tyre.vertical`, `.damping`, `.load",
        "vertical stiffness and damping of the tyre (N/mm, N·s/m): in an impact in time it acts on the wheel centre and leaves the road; `load`: its \
         force at the touch, N; default: the force that balances the spring",
        "all",
    );
    row(
        "anti_roll_bar.stiffness",
        "torsional stiffness of the bar between its two arms (`\"12 N·m/deg\"`), for impacts in time and the column `anti_roll_bar_rate` of \
         `percuss kinematics`; with one side the other half is at rest",
        &of(&|t| t.bodies.iter().any(|(body, _)| body == "anti_roll_bar")),
    );
    row(
        "torsion_bar.on`, `.rate`, `.preload",
        "a torsion bar as the spring: the link whose hinge on the chassis it is on (default: the only one), its rate with a unit \
         (`\"60 N·m/deg\"`), its moment at the design position (N·m; positive: twisted as by a wheel that moves up)",
        &of(&|t| t.hinged_links().next().is_some()),
    );
    row(
        "contact.NAME.point`, `.on`, `.direction`, `.against`, `.gap",
        "a contact that the sheet names itself, for `--at NAME`: its point, the link of the point, the direction to the obstacle; \
         optional: the other link (default: the ground), and the gap at the design position. A contact with a gap is a stop",
        "all",
    );
    row(
        "bush.POINT.radial`, `.axial`, `.torsional`, `.conical`, `.axis`, `.x_axis`, `.damping`, `.rotational_damping`, `.loss_factor`, \
         `.dynamic_factor`, `.preload`, `.preload_torque`, `.file",
        "a bush at this point, where two links are joined ([Bushes](../howto/BUSHES.md)): stiffness across and along its axis with a unit \
         (`\"9 kN/mm\"`); optional: about its axis and across it (`\"60 N·m/rad\"`), the axis (default: of the hinge), damping of the \
         translations (one number, or radial and axial), loss factor, stiffness in motion divided by the static one; force and moment of the bush on its \
         link at the design position; or the rates from a bushing file of Adams/Car",
        "all",
    );
    let steered = of(&|t| t.has_rack());
    row(
        "rack.slides`, `rack.mass",
        "true if the inner ends of the tie rods slide along y; mass of the rack",
        &steered,
    );
    row(
        "rack.travel_per_turn",
        "travel of the rack per turn of the steering wheel: `percuss kinematics` gives the steering ratio",
        &steered,
    );
    row(
        "rack.stiffness",
        "stiffness of the rack and its housing along y: a bush in place of the rack's joint",
        &steered,
    );
    out
}
