//! Reader of the entries of a sheet according to its template.

use super::catalogue;
use super::entries::{Entries, Quantity};
use super::point_table::{self, Files};
use super::sections::{bushes, contacts};
use super::template::{Shape, Template, symmetric_matrix};
use super::{adams, aliases, table, toml_text};
use crate::corner;
use crate::corner::design::{Design, FirstPins, GivenBody, STOPS, Stop};
use crate::findings::{Findings, Spot};
use crate::forces::ForceElements;
use crate::limits::{MAX_CAMBER, MAX_TOE};
use crate::options::{ImportOptions, Rack, Side, Wheel};
use crate::units::{Frame, VehicleAxes, check_size};
use percuss_formats::Source;
use percuss_formats::reading::LONGEST_NAME;
use percuss_formats::reading::{cut, quoted};
use percuss_spatial::{Matrix3, Vector3};
use percuss_units::{Dimension, LengthUnit, Unit};
use std::collections::BTreeMap;

/// Content of a sheet in metres and the axes of ISO 8855. Points of a side are those of the left side.
pub(in super::super) struct Sheet {
    pub template: &'static Template,
    pub name: String,
    pub frame: Frame,
    pub side: Side,
    pub rack: Rack,
    /// Stiffness of the rack along y, N/m.
    pub rack_stiffness: Option<f64>,
    pub design: Design,
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
    } else if source.name.ends_with(".csv") || table::looks_like_table(text) {
        table::read_text(text, 0, &mut entries, findings);
    } else {
        is_table = false;
        if !toml_text::read(text, &mut entries, findings) {
            return None;
        }
    }
    let is_worksheet_given = options.worksheet.is_some() || entries.has("worksheet");
    if is_worksheet_given && !entries.has("points") && !table::is_workbook(&source.bytes) {
        let message =
            "a worksheet is given, and the file is no workbook and names no table of points".to_owned();
        findings.error("conflict", &Spot::default(), message);
    }
    if is_table && !findings.has_errors() && point_table::has_points_only(&entries) {
        point_table::refuse_points_only(findings, source, options);
        return None;
    }
    point_table::read(source, options, &mut entries, findings, files);
    if findings.has_errors() {
        return None;
    }
    entries.masses_optional = options.masses_optional;
    let sheet = SheetReader { entries: &mut entries, findings, options }.read_sheet();
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
struct SheetReader<'s> {
    entries: &'s mut Entries,
    findings: &'s mut Findings,
    options: &'s ImportOptions,
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
        self.entries.set_known_keys(catalogue::keys_of(template));
        aliases::rename_points(template, self.entries, self.findings);
        let name = name.filter(|n| !n.is_empty()).unwrap_or_else(|| template.name.clone());
        let name = if name.len() > LONGEST_NAME { cut(&name, LONGEST_NAME / 4) } else { name };
        let side = self.side(template, points_side);
        let points = self.points(template, frame, points_side);
        let bodies = self.bodies(template, frame, points_side, inertia_unit);
        let chassis = self.chassis(template, frame, points_side, inertia_unit);
        let wheel = self.wheel(frame, inertia_unit);
        let camber = self.entries.wheel_angle(self.findings, "wheel.camber", MAX_CAMBER);
        let toe = self.entries.wheel_angle(self.findings, "wheel.toe", MAX_TOE);
        let axle_inertia =
            self.scalar("spindle.axle_inertia", Quantity::Inertia(inertia_unit)).map_or(0.0, |(x, _)| x);
        let on = self.attachments(template);
        let sections = catalogue::force_sections(template);
        let forces = self.entries.force_elements(self.findings, &sections, frame.unit);
        let rack = self.rack(template);
        let stops = self.stops(template, frame, points_side);
        let bar = catalogue::keys().anti_roll_bar.iter().filter(|_| points.contains_key("drop_link_bar"));
        let contacts = contacts::read_contacts(self.entries, self.findings, frame, points_side);
        let rack_stiffness =
            if template.has_rack() { bushes::read_rack(self.entries, self.findings) } else { None };
        let design = Design {
            unit: frame.unit,
            contacts,
            bushes: bushes::read_bushes(self.entries, self.findings, template, (frame, points_side)),
            parts: template.parts.iter().chain(bar).collect(),
            axle: template.axle,
            points,
            derived: &template.derived,
            bodies,
            first_pins: self.first_pins(template, frame, points_side),
            on,
            stops,
            rods_are_links: self.options.movable,
            hinge_comment: "about the line through its two points, first to second",
            ..Design::default()
        };
        point_table::warn_unbuilt_parts(self.entries, self.findings);
        Some(Sheet {
            template,
            name,
            frame,
            side,
            rack,
            rack_stiffness,
            design,
            wheel,
            camber,
            toe,
            axle_inertia,
            points_side,
            chassis,
            forces,
            missing_masses: std::mem::take(&mut self.entries.missing_masses),
        })
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
        let choices = "iso (x forward, y left, z up) or adams (x backward, y right, z up)";
        self.keyword("axes", self.options.axes, VehicleAxes::from_name, choices)
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
        let has_unknown = aliases::report_unknown_points(template, self.entries, self.findings);
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
        points
    }

    /// Reads the bodies that the template requires or the sheet contains.
    fn bodies(
        &mut self,
        template: &'static Template,
        frame: Frame,
        points_side: Side,
        inertia_unit: &'static Unit,
    ) -> BTreeMap<&'static str, GivenBody> {
        let mut bodies = BTreeMap::new();
        for (key, body) in &template.bodies {
            // The bodies of a bar are not required if the sheet has no bar.
            let of_bar = ["anti_roll_bar", "drop_link"].contains(&&**key);
            let absent = !self.entries.has_section(key);
            if absent
                && (body.shape != Shape::Any && body.shape != Shape::Spindle
                    || of_bar && !self.entries.has("points.drop_link_bar"))
            {
                continue;
            }
            if let Some(given_body) = self.body(template, (key, body.shape), frame, points_side, inertia_unit)
            {
                bodies.insert(&**key, given_body);
            }
        }
        bodies
    }

    /// Reads the body of the chassis, if the sheet has one.
    fn chassis(
        &mut self,
        template: &Template,
        frame: Frame,
        points_side: Side,
        inertia_unit: &'static Unit,
    ) -> Option<corner::Body> {
        if !self.entries.has_section(corner::CHASSIS) {
            return None;
        }
        let key = (corner::CHASSIS, Shape::Optional);
        match self.body(template, key, frame, points_side, inertia_unit)? {
            GivenBody::Body(body) => Some(body),
            GivenBody::Rod(..) => None,
        }
    }

    /// Reads one body, mirrored to the left side; `None` if it is absent or invalid.
    fn body(
        &mut self,
        template: &Template,
        (key, shape): (&str, Shape),
        frame: Frame,
        points_side: Side,
        inertia_unit: &'static Unit,
    ) -> Option<GivenBody> {
        let [mass_key, com_key, inertia_key] = ["mass", "com", "inertia"].map(|name| format!("{key}.{name}"));
        let is_rod = shape == Shape::Rod;
        let spot = |spot: Spot| Spot { path: Some(key.to_owned()), ..spot };
        let Some((mass, at)) = self.scalar(&mass_key, Quantity::Mass) else {
            if !self.entries.has(&mass_key) && (!is_rod || self.entries.has(&com_key)) {
                let text = catalogue::description_of(&catalogue::keys().bodies, key);
                self.entries.missing(
                    self.findings,
                    &mass_key,
                    &format!("the mass of {text}, kg (0 is legal),"),
                );
                for key in [&com_key, &inertia_key] {
                    self.entries.find(key);
                }
            }
            return None;
        };
        let spot = spot(at);
        let is_spindle = shape == Shape::Spindle;
        if is_rod && !self.entries.has(&com_key) && !self.entries.has(&inertia_key) {
            return Some(GivenBody::Rod(mass, spot));
        }
        let (com, com_spot) = match self.entries.point(self.findings, &com_key, frame) {
            Some((com, at)) => (Some(com), at),
            None if self.entries.has(&com_key) => return None,
            None => (None, spot.clone()),
        };
        let is_mirrored = points_side == Side::Right && !template.is_central_body(key);
        // NaN: the default for a spindle is the wheel centre, which is computed later. A massless body needs no centre of mass.
        let com = match com {
            Some(com) => Vector3::new(com.x, if is_mirrored { 0.0 - com.y } else { com.y }, com.z),
            None if is_spindle => Vector3::repeat(f64::NAN),
            None if mass == 0.0 => Vector3::zeros(),
            None => {
                self.entries.missing(self.findings, &com_key, "the centre of mass, [x, y, z],");
                return None;
            }
        };
        let about_com = match self.entries.numbers(
            self.findings,
            &inertia_key,
            Quantity::Inertia(inertia_unit),
            // Along the wheel's axes the products of inertia are zero.
            if is_spindle { &[3] } else { &[3, 6] },
        ) {
            Some((values, _)) => symmetric_matrix(&values),
            None if self.entries.has(&inertia_key) => return None,
            None if mass == 0.0 => Matrix3::zeros(),
            None => {
                let expected =
                    "the inertia about the centre of mass, [xx, yy, zz] or [xx, yy, zz, xy, xz, yz],";
                self.entries.missing(self.findings, &inertia_key, expected);
                return None;
            }
        };
        // The inertia of a spindle is along the wheel's axes, the inertia of other bodies along the vehicle's axes.
        let mut about_com = if is_spindle { about_com } else { frame.axes.inertia_to_iso(about_com) };
        if is_mirrored && !is_spindle {
            for (row, column) in [(0, 1), (1, 0), (1, 2), (2, 1)] {
                about_com[(row, column)] = 0.0 - about_com[(row, column)];
            }
        }
        Some(GivenBody::Body(corner::Body { mass, com, about_com, spot, com_spot }))
    }

    /// Reads one number.
    fn scalar(&mut self, key: &str, kind: Quantity) -> Option<(f64, Spot)> {
        let (values, spot) = self.entries.numbers(self.findings, key, kind, &[1])?;
        Some((values[0], spot))
    }

    /// Wheel of the options, or else of the sheet.
    fn wheel(&mut self, frame: Frame, inertia_unit: &'static Unit) -> Option<Wheel> {
        let mass = self.scalar("wheel.mass", Quantity::Mass);
        let inertia =
            self.entries.numbers(self.findings, "wheel.inertia", Quantity::Inertia(inertia_unit), &[3]);
        let radius = self.scalar("wheel.radius", Quantity::Length(frame.unit));
        if self.options.wheel.is_some() {
            return self.options.wheel;
        }
        let mass = match mass {
            Some((mass, _)) => mass,
            // The radius alone defines the contact point.
            None if self.options.masses_optional && radius.is_some() && !self.entries.has("wheel.mass") => {
                self.entries.missing(self.findings, "wheel.mass", "the mass of the wheel, kg,");
                0.0
            }
            None => return None,
        };
        let inertia = match inertia {
            Some((values, _)) => [values[0], values[1], values[2]],
            None => {
                if mass != 0.0 && !self.entries.has("wheel.inertia") {
                    let expected = "[xx, yy, zz] about the wheel's centre, y along the spin axis,";
                    self.entries.missing(self.findings, "wheel.inertia", expected);
                }
                [0.0; 3]
            }
        };
        Some(Wheel { mass, inertia, radius: radius.map(|(r, _)| r) })
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
