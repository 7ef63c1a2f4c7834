//! Reader of the entries of a sheet according to its template.

use super::catalogue::{self, MASSIVE_PARTS, ROCKER_PIVOT};
use super::entries::{Entries, Quantity, WrittenPoint};
use super::foreign::{self, adams};
use super::point_table::{self, Files};
use super::sections::bush_file::BushFile;
use super::sections::estimates::Estimates;
use super::sections::mirror_images::{Points, mirror_images};
use super::sections::{bushes, contacts};
use super::template::Template;
use super::{names, table, toml_text};
use crate::corner;
use crate::corner::design::{Design, FirstPins, STOPS, Stop};
use crate::findings::{Findings, Spot};
use crate::forces::ForceElements;
use crate::limits::{MAX_CAMBER, MAX_TOE};
use crate::options::{ImportOptions, Rack, Side, Wheel};
use crate::units::{Frame, VehicleAxes, check_size};
use percuss_formats::Source;
use percuss_formats::reading::LONGEST_NAME;
use percuss_formats::reading::{cut, quoted};
use percuss_spatial::Vector3;
use percuss_units::{Dimension, LengthUnit, Unit};
use std::collections::BTreeMap;

/// Content of a sheet in metres and the axes of ISO 8855. Points of a side are those of the left side.
#[derive(Clone, Debug)]
pub(in super::super) struct Sheet {
    pub template: &'static Template,
    pub name: String,
    pub frame: Frame,
    pub side: Side,
    pub rack: Rack,
    /// Stiffness of the rack along y, N/m.
    pub rack_stiffness: Option<f64>,
    /// Travel of the rack per turn of the steering wheel, m.
    pub rack_travel: Option<f64>,
    pub design: Design,
    /// Points of the other side, as points of the left side; empty if only one side is built.
    pub other_points: Points,
    /// Names of the points whose mirror images the file has too.
    pub mirrored: Vec<&'static str>,
    pub wheel: Option<Wheel>,
    /// Camber, rad.
    pub camber: f64,
    /// Toe, rad.
    pub toe: f64,
    /// Inertia that the axle adds to the spindle about the spin axis, kg·m².
    pub axle_inertia: f64,
    /// Side that the points describe.
    pub points_side: Side,
    /// Body of the chassis.
    pub chassis: Option<corner::Body>,
    pub forces: ForceElements,
    /// Keys of masses that are missing and optional: they are zero.
    pub missing_masses: Vec<String>,
    /// Hardpoints as written in the files, and the axes of these numbers.
    pub written: (Vec<WrittenPoint>, VehicleAxes),
    /// Name of the worksheet of the points.
    pub worksheet: Option<String>,
}

/// Reads a sheet; `None` after an error in the report.
pub(in super::super) fn read(
    source: &Source,
    text: &str,
    options: &ImportOptions,
    findings: &mut Findings,
    files: &mut Files,
) -> Option<Sheet> {
    let (mut entries, mut is_table) = (Entries::default(), true);
    files.push((source.name.clone(), text.to_owned()));
    if table::is_workbook(&source.bytes) {
        table::read_workbook(&source.bytes, 0, options.worksheet.as_deref(), &mut entries, findings);
    } else if adams::is_subsystem(text) {
        point_table::refuse_points_only(findings, source, options);
        return None;
    } else if foreign::is_foreign(&source.name, text) {
        is_table = false;
        let part = options.worksheet.as_deref();
        foreign::read((&source.name, text), 0, options, part, (&mut entries, findings));
    } else if source.name.ends_with(".csv") || table::looks_like_table(text) {
        table::read_text(text, 0, &mut entries, findings);
    } else {
        is_table = false;
        if !toml_text::read(text, 0, &mut entries, findings) {
            return None;
        }
    }
    let is_worksheet_given = options.worksheet.is_some() || entries.has("worksheet");
    if is_worksheet_given
        && entries.worksheet.is_none()
        && !entries.has("points")
        && !table::is_workbook(&source.bytes)
    {
        let message =
            "a worksheet is given, and the file is no workbook and names no table of points".to_owned();
        findings.error("conflict", &Spot::default(), message);
    }
    if is_table && !findings.has_errors() && point_table::has_points_only(&entries) {
        point_table::refuse_points_only(findings, source, options);
        return None;
    }
    point_table::read_names(source, options, &mut entries, findings, files);
    point_table::read(source, options, &mut entries, findings, files);
    let bush_files = bushes::read_files(source, options, &mut entries, findings, files);
    if findings.has_errors() {
        return None;
    }
    entries.masses_optional = options.masses_optional;
    let sheet =
        SheetReader { entries: &mut entries, findings, options, estimates: None, bush_files }.read_sheet();
    if let Some(sheet) = &sheet {
        let mut known = catalogue::keys_of(sheet.template);
        known.extend(contacts::contact_keys(&entries));
        known.extend(bushes::bush_keys(&entries));
        for entry in entries.unread() {
            findings.error("unknown-key", &entry.spot, catalogue::unknown_key_message(&entry.key, &known));
        }
    }
    sheet.filter(|_| !findings.has_errors())
}

/// Reads the entries of a sheet, with the options of the import.
pub(super) struct SheetReader<'s> {
    pub entries: &'s mut Entries,
    pub findings: &'s mut Findings,
    pub options: &'s ImportOptions,
    /// Estimates of missing masses, if the sheet requests them.
    pub estimates: Option<Estimates>,
    /// Bushing files by the names of the bushes.
    pub bush_files: BTreeMap<String, BushFile>,
}

impl SheetReader<'_> {
    /// Reads all entries; `None` without template, unit, axes and side of the points.
    fn read_sheet(&mut self) -> Option<Sheet> {
        let template = self.template();
        let unit = self.unit();
        let axes = self.axes();
        let name = self.entries.text(self.findings, "name", "a name").map(|(name, _)| name);
        let points_side = self.side_of_points();
        let inertia_unit = self.inertia_unit();
        let (template, unit, axes, points_side) = (template?, unit?, axes?, points_side?);
        let frame = Frame { unit, axes };
        self.note_axes(axes);
        self.entries.set_known_keys(catalogue::keys_of(template));
        let side = self.side(template, points_side);
        names::rename_points(template, (points_side, side == Side::Both), self.entries, self.findings);
        let name = name.filter(|n| !n.is_empty()).unwrap_or_else(|| template.name.clone());
        let name = if name.len() > LONGEST_NAME { cut(&name, LONGEST_NAME / 4) } else { name };
        let camber = self.entries.wheel_angle(self.findings, "wheel.camber", MAX_CAMBER);
        let mut points = self.points(template, frame, points_side);
        let stated = points.get("wheel_centre").map(|(at, _)| *at);
        points.extend(self.wheel_centre(frame, camber, stated).map(|centre| ("wheel_centre", centre)));
        let masses_spot = self.masses();
        let bodies = self.bodies(template, frame, (points_side, &points), inertia_unit);
        let chassis = self.chassis(template, frame, points_side, inertia_unit);
        let wheel = self.wheel(frame, inertia_unit);
        let toe = self.entries.wheel_angle(self.findings, "wheel.toe", MAX_TOE);
        let axle_inertia =
            self.scalar("spindle.axle_inertia", Quantity::Inertia(inertia_unit)).map_or(0.0, |(x, _)| x);
        let on = self.attachments(template);
        let sections = catalogue::force_sections(template);
        let mut forces = self.entries.force_elements(self.findings, &sections, frame.unit);
        forces.torsion_bar = self.torsion_bar(template);
        let part_masses = MASSIVE_PARTS.into_iter().filter_map(|section| {
            let (mass, spot) = self.scalar(&format!("{section}.mass"), Quantity::Mass)?;
            if mass < 0.0 {
                self.findings.error(
                    "bad-mass",
                    &spot,
                    format!("{mass} kg; a mass of at least 0 is expected"),
                );
            }
            Some((section, mass))
        });
        let part_masses = part_masses.collect();
        let half_shaft = if template.middle { None } else { self.half_shaft(frame, points_side) };
        let rack = self.rack(template);
        let stops = self.stops(template, frame, points_side);
        let bar = catalogue::keys().anti_roll_bar.iter().filter(|_| points.contains_key("drop_link_bar"));
        let contacts = contacts::read_contacts(self.entries, self.findings, frame, points_side);
        let rack_travel = if template.has_rack() { self.rack_travel(frame) } else { None };
        let rack_stiffness =
            if template.has_rack() { bushes::read_rack(self.entries, self.findings) } else { None };
        let design = Design {
            unit: frame.unit,
            contacts,
            bushes: bushes::read_bushes(
                self.entries,
                self.findings,
                template,
                (frame, points_side),
                &self.bush_files,
            ),
            parts: template.parts.iter().chain(bar).collect(),
            axle: template.axle,
            points,
            derived: &template.derived,
            bodies,
            first_pins: self.first_pins(template, frame, points_side),
            on,
            part_masses,
            half_shaft,
            stops,
            rods_are_links: self.options.movable,
            hinge_comment: "about the line through its two points, first to second",
            ..Design::default()
        };
        point_table::warn_unbuilt_parts(self.entries, self.findings);
        let mut other_points = self.other_points(template, frame, points_side, &design.points);
        let mirrored = mirror_images(&other_points, &design.points);
        self.report_unequal_points(&other_points, &design.points, points_side, side);
        let word = points_side.other_word();
        let others: Vec<String> = other_points.keys().map(|name| format!("{word}.{name}")).collect();
        if side != Side::Both {
            other_points.clear();
        }
        let names = template.points.iter().map(|(name, _)| name.clone()).chain(others);
        let axes_of_file = self.entries.axes_of_file.unwrap_or(axes);
        let written = names.filter_map(|name| self.entries.written_point(&name, frame.unit));
        let written = written.map(|point| point.in_axes(axes, axes_of_file)).collect();
        let missing_masses = self.entries.report_missing_masses(self.findings);
        if let Some(estimates) = &self.estimates {
            estimates.warn(self.findings, &masses_spot);
        }
        Some(Sheet {
            template,
            name,
            frame,
            side,
            rack,
            rack_stiffness,
            rack_travel,
            design,
            other_points,
            mirrored,
            wheel,
            camber,
            toe,
            axle_inertia,
            points_side,
            chassis,
            forces,
            missing_masses,
            written: (written, axes_of_file),
            worksheet: self.entries.worksheet.clone(),
        })
    }

    /// Reads the key `masses`; the place of the key.
    fn masses(&mut self) -> Spot {
        match self.entries.text(self.findings, "masses", "\"estimate\"") {
            Some((word, spot)) if word == "estimate" => {
                self.estimates = Some(Estimates::default());
                spot
            }
            Some((word, spot)) => {
                let message = format!(
                    "{} is not known; \"estimate\" is expected, for estimates of missing masses",
                    quoted(&word)
                );
                self.findings.error("unknown-word", &spot, message);
                spot
            }
            None => Spot::default(),
        }
    }

    /// Template named in the sheet or by the option.
    fn template(&mut self) -> Option<&'static Template> {
        let in_file = self.entries.text(self.findings, "template", "the name of a template");
        let (name, spot) = match (in_file, &self.options.template) {
            (Some((name, spot)), Some(flag)) if *flag != name => {
                let message = format!("the file says {}, --template {}", quoted(&name), quoted(flag));
                self.findings.error("conflict", &spot, message);
                return None;
            }
            (Some(in_file), _) => in_file,
            (None, Some(flag)) => (flag.clone(), Spot::default()),
            (None, None) => {
                if !self.findings.has_errors() {
                    let message = format!(
                        "the key is missing; a template is expected, in the file or by `percuss import … --template NAME`: {}",
                        catalogue::template_names().join(", ")
                    );
                    let spot = Spot { path: Some("template".to_owned()), ..Spot::default() };
                    self.findings.error("missing-key", &spot, message);
                }
                return None;
            }
        };
        let found = catalogue::templates().find(|t| t.name == name);
        if found.is_none() {
            let near = catalogue::suggestion(&name, catalogue::template_names());
            let message = format!(
                "the template {} is not known{near} (the templates are {})",
                quoted(&name),
                catalogue::template_names().join(", ")
            );
            self.findings.error("unknown-template", &spot, message);
        }
        found
    }

    /// Reads a keyword of the head, or the value of its flag; two different values are an error. `named` parses the keyword,
    /// and `choices` describes the valid ones.
    fn keyword<T: Copy + PartialEq>(
        &mut self,
        key: &'static str,
        flag: Option<T>,
        named: fn(&str) -> Option<T>,
        choices: &str,
    ) -> Option<T> {
        let spot = Spot { path: Some(key.to_owned()), ..Spot::default() };
        match (self.entries.text(self.findings, key, choices), flag) {
            (Some((word, spot)), flag) => match (named(&word), flag) {
                (None, _) => {
                    let message = format!("{} is not known; {choices} is expected", quoted(&word));
                    self.findings.error("unknown-word", &spot, message);
                    None
                }
                (Some(found), Some(flag)) if found != flag => {
                    let message = format!("the file says {}, the flag --{key} something else", quoted(&word));
                    self.findings.error("conflict", &spot, message);
                    None
                }
                (found, _) => found,
            },
            (None, Some(flag)) => Some(flag),
            (None, None) => {
                if !self.entries.has(key) {
                    let message = format!(
                        "the key is missing; {choices} is expected, in the file or by `percuss import … --{key}`"
                    );
                    self.findings.error("missing-key", &spot, message);
                }
                None
            }
        }
    }

    fn unit(&mut self) -> Option<LengthUnit> {
        self.keyword("unit", self.options.unit, LengthUnit::from_name, "a unit of length (m, cm, mm, in)")
    }

    fn axes(&mut self) -> Option<VehicleAxes> {
        self.keyword("axes", self.options.axes, VehicleAxes::from_name, VehicleAxes::CHOICES)
    }

    /// Notes axes that are neither those of ISO 8855 nor those of Adams/Car.
    fn note_axes(&mut self, axes: VehicleAxes) {
        if [VehicleAxes::ISO, VehicleAxes::ADAMS].contains(&axes) {
            return;
        }
        if let Some(spot) = self.entries.directions.clone().filter(|_| !axes.is_in_order()) {
            let message = format!(
                "the header names directions of the vehicle, and x, y, z of the axes \"{}\" are {}: name the columns x, y, z, or write \
                 axes = \"iso\" with the signs of ISO 8855",
                axes.name(),
                axes.words()
            );
            self.findings.error("unknown-header", &spot, message);
        }
        let explorer = if axes.is_in_order() {
            ""
        } else {
            "; the page of percuss explore shows points in the frames of their links"
        };
        let message = format!("axes \"{}\": {}{explorer}", axes.name(), axes.words());
        let spot = Spot { path: Some("axes".to_owned()), ..self.entries.spot_in("axes").unwrap_or_default() };
        self.findings.note("axes", &spot, message);
    }

    /// Side of the points in the file; default left; `None`, with an error, if invalid.
    fn side_of_points(&mut self) -> Option<Side> {
        let named = |word: &str| match word {
            "left" => Some(Side::Left),
            "right" => Some(Side::Right),
            _ => None,
        };
        if !self.entries.has("side") {
            return Some(Side::Left);
        }
        self.keyword("side", None, named, "left or right, the side of the points,")
    }

    /// Unit of inertias that are given without a unit.
    fn inertia_unit(&mut self) -> &'static Unit {
        let default = Dimension::Inertia.default_unit().expect("the table has units of inertia");
        let Some((word, spot)) = self.entries.text(self.findings, "inertia_unit", "a unit of inertia") else {
            return default;
        };
        Unit::named(&word, &[Dimension::Inertia]).unwrap_or_else(|| {
            let known: Vec<&str> = Dimension::Inertia.units().map(|unit| unit.name).collect();
            let message = format!("{} is not known; these are: {}", quoted(&word), known.join(", "));
            self.findings.error("unknown-word", &spot, message);
            default
        })
    }

    /// Side to build, from the template, the flag, the sheet or the side of the points, in this order.
    fn side(&mut self, template: &Template, points_side: Side) -> Side {
        let named = |word: &str| match word {
            "left" => Some(Side::Left),
            "right" => Some(Side::Right),
            "both" => Some(Side::Both),
            _ => None,
        };
        let in_file = if self.entries.has("build") {
            self.keyword("build", None, named, "left, right or both, the side to build,")
        } else {
            None
        };
        let side = self.options.side.or(in_file);
        if let Some((only, reason)) = template.only_build() {
            if side.is_some_and(|side| side != only) {
                let spot = Spot { path: Some("build".to_owned()), ..Spot::default() };
                self.findings.warning("one-axle", &spot, reason.to_owned());
            }
            return only;
        }
        side.unwrap_or(points_side)
    }

    /// Reads the hardpoints, mirrored to the left side. Missing mandatory points are errors.
    fn points(
        &mut self,
        template: &'static Template,
        frame: Frame,
        points_side: Side,
    ) -> BTreeMap<&'static str, (Vector3<f64>, Spot)> {
        let mut points = BTreeMap::new();
        if !self.entries.has_section("points") {
            let message = format!(
                "no hardpoint is given; the section [points] is expected, or in the head points = \"FILE.csv\", with {} and \
                 what else percuss template {} has",
                template.points.iter().take(3).map(|(key, _)| &**key).collect::<Vec<_>>().join(", "),
                template.name
            );
            let spot = Spot { path: Some("points".to_owned()), ..Spot::default() };
            self.findings.error("missing-key", &spot, message);
            return points;
        }
        let pivot = match template.point("rocker_front") {
            Some(_) => self.entries.point(self.findings, ROCKER_PIVOT, frame),
            None => None,
        };
        let has_unknown = names::report_unknown_points(template, self.entries, self.findings);
        let (mut farthest, mut farthest_spot): (f64, Spot) = (0.0, Spot::default());
        for (key, _) in &template.points {
            let path = format!("points.{key}");
            match self.entries.point(self.findings, &path, frame) {
                Some((mut at, spot)) => {
                    if points_side == Side::Right && !template.is_central(key) {
                        at.y = 0.0 - at.y;
                    }
                    if at.amax() > farthest {
                        (farthest, farthest_spot) = (at.amax(), spot.clone());
                    }
                    points.insert(&**key, (at, spot));
                }
                None if has_unknown || self.entries.has(&path) => {}
                None if key == "wheel_centre" && self.entries.has("wheel.half_track") => {}
                None if pivot.is_some() && key.starts_with("rocker_") => {}
                None if key == "anti_roll_bar_inner" && points.contains_key("anti_roll_bar_outer") => {
                    let (outer, spot) = points["anti_roll_bar_outer"].clone();
                    let message = "the axis of the anti-roll bar is across the vehicle, through anti_roll_bar_outer: the sheet has no \
                                   second point, anti_roll_bar_inner";
                    self.findings.note("bar-axis", &spot, message.to_owned());
                    points.insert(&**key, (Vector3::new(outer.x, 0.5 * outer.y, outer.z), spot));
                }
                None => {
                    let group = Template::optional_group(key);
                    let is_group_given = group.is_some_and(|group| {
                        group.iter().any(|other| self.entries.has(&format!("points.{other}")))
                    });
                    if group.is_none() || is_group_given {
                        let expected = format!(
                            "{} ([x, y, z] in {})",
                            catalogue::description_of(&catalogue::keys().points, key),
                            frame.unit.name()
                        );
                        self.entries.missing(self.findings, &path, &expected);
                    }
                }
            }
        }
        if !self.findings.has_errors() {
            check_size(self.findings, farthest, &farthest_spot, frame.unit);
        }
        if let Some((mut at, spot)) = pivot.filter(|_| !self.findings.has_errors()) {
            if points_side == Side::Right {
                at.y = 0.0 - at.y;
            }
            self.rocker_axis(at, &spot, frame, points_side, &mut points);
        }
        points
    }

    /// Reads one number.
    pub fn scalar(&mut self, key: &str, kind: Quantity) -> Option<(f64, Spot)> {
        let (values, spot) = self.entries.numbers(self.findings, key, kind, &[1])?;
        Some((values[0], spot))
    }

    /// Reads the links to which springs and similar parts are attached, by section.
    fn attachments(&mut self, template: &'static Template) -> BTreeMap<&'static str, (String, Spot)> {
        let (mut on, mut assumed) = (BTreeMap::new(), Vec::new());
        for (section, default) in &template.on {
            let key = format!("{section}.on");
            let found = self.entries.text(self.findings, &key, "the name of a link");
            if !self.entries.has(&key)
                && !template.has_usual_body(section)
                && let Some(spot) = self.entries.spot_in(&format!("points.{section}_"))
            {
                assumed.push((&**section, spot));
            }
            let (link, spot) = found.unwrap_or_else(|| (default.clone(), Spot::default()));
            if let Err(message) = template.check_holder(section, &link) {
                self.findings.error("unknown-link", &spot, message);
            }
            on.insert(&**section, (link, spot));
        }
        let (sections, spots): (Vec<&str>, Vec<Spot>) = assumed.into_iter().unzip();
        if let Some(spot) = spots.first() {
            self.findings.warning("assumed-body", spot, template.assumed_bodies(&sections));
        }
        on
    }

    /// Reads the gap and the direction of the stops, mirrored to the left side.
    fn stops(
        &mut self,
        template: &Template,
        frame: Frame,
        points_side: Side,
    ) -> BTreeMap<&'static str, Stop> {
        let mut stops = BTreeMap::new();
        for section in STOPS.into_iter().filter(|section| template.on.iter().any(|(key, _)| key == section)) {
            let gap = self.scalar(&format!("{section}.gap"), Quantity::Length(frame.unit));
            let key = format!("{section}.direction");
            let direction = self.entries.direction(self.findings, &key, frame, points_side);
            let spot = direction.iter().map(|(_, spot)| spot).chain(gap.iter().map(|(_, spot)| spot)).next();
            let Some(spot) = spot.cloned() else { continue };
            let (gap, direction) = (gap.map(|(gap, _)| gap), direction.map(|(direction, _)| direction));
            stops.insert(section, Stop { gap, direction, spot });
        }
        stops
    }

    /// Reads the first pins of the universal joints, mirrored to the left side.
    fn first_pins(&mut self, template: &'static Template, frame: Frame, points_side: Side) -> FirstPins {
        let pin = |link: &'static str| {
            let side = if template.is_central_body(link) { Side::Left } else { points_side };
            Some((link, self.entries.direction(self.findings, &format!("{link}.pin"), frame, side)?))
        };
        catalogue::universal_links(template).filter_map(pin).collect()
    }

    /// Rack of the options, or else of the sheet; fixed by default.
    fn rack(&mut self, template: &Template) -> Rack {
        let mass = self.scalar("rack.mass", Quantity::Mass);
        let slides = self.entries.switch(self.findings, "rack.slides").unwrap_or(false);
        if let Some(rack) = self.options.rack {
            return rack;
        }
        match (slides && template.has_rack(), mass) {
            (true, mass) => Rack::Sliding { mass: mass.map_or(0.0, |(mass, _)| mass) },
            (false, _) => Rack::Fixed,
        }
    }
}
