//! Builds the corner of a sheet.

use super::catalogue;
use super::read::Sheet;
use super::sections::mirror_images::{Points, mirror_images};
use crate::corner::design::GivenBody;
use crate::corner::spindle::Spindle;
use crate::corner::{Body, Built, build};
use crate::findings::{Findings, Spot};
use crate::limits::MAX_SHIFT;
use crate::options::Side;
use crate::units::{VehicleAxes, short};
use percuss_formats::reading::quoted;
use percuss_spatial::{Matrix3, Vector3};
use percuss_units::LengthUnit;

/// Smallest moment of inertia of a link about its own line, relative to the sum of its principal moments, at which the pins of its
/// universal joint change the digits of a report.
const LEAST_ABOUT_LINE: f64 = 1e-6;

/// Builds the corner of a sheet; reports points that determine no axis or line.
pub(in super::super) fn build(sheet: &Sheet, findings: &mut Findings) -> Option<Built> {
    let own = spindle(sheet, findings);
    let mut built = build::build(&sheet.design, &own, None, findings)?;
    note_unstated_pins(sheet, findings);
    let unequal = sheet.unequal_points();
    if !unequal.is_empty() {
        let mut other = sheet.clone();
        other.design.points.extend(unequal.clone());
        other.points_side = if sheet.points_side == Side::Right { Side::Left } else { Side::Right };
        if sheet.template.axle && unequal.contains_key("wheel_centre") {
            let message = "both wheels are on one axle: their centres are mirror images".to_owned();
            findings.error("unequal-sides", &other.design.spot("wheel_centre"), message);
        }
        let spindle = spindle(&other, findings);
        let corner = build::build(&other.design, &spindle, Some(&built.left), findings)?.left;
        let right = if sheet.points_side == Side::Right {
            std::mem::replace(&mut built.left, corner)
        } else {
            corner
        };
        built.right = Some(right);
    }
    Some(built)
}

/// Notes once which universal joints with an influence on the effective mass have assumed pins: the pins determine the rotation of
/// a link about its own line, which counts if the link has a moment of inertia about this line.
fn note_unstated_pins(sheet: &Sheet, findings: &mut Findings) {
    let design = &sheet.design;
    let links = design.parts.iter().filter_map(|part| part.universal_link());
    let assumed = links.filter_map(|(link, ends)| {
        let Some(GivenBody::Body(body)) = design.bodies.get(link) else { return None };
        let [from, to] = ends.map(|end| design.point(end));
        let line = (to? - from?).normalize();
        let about_line = line.dot(&(body.about_com * line));
        let is_assumed = !design.first_pins.contains_key(link);
        (is_assumed && about_line > LEAST_ABOUT_LINE * body.about_com.trace()).then_some((link, &body.spot))
    });
    let (links, spots): (Vec<&str>, Vec<&Spot>) = assumed.unzip();
    if let ([first, ..], [spot, ..]) = (&links[..], &spots[..]) {
        let message = format!(
            "the directions of the pins of the universal joint of {} are assumed: the first pin, on the chassis or rack, is \
             normal to the link and to the x axis; state it by the key {first}.pin = [x, y, z]",
            links.join(", ")
        );
        findings.note("assumed-pins", spot, message);
    }
}

impl Sheet {
    /// Points of the other side that are no mirror images, as points of the left side.
    pub fn unequal_points(&self) -> Points {
        let mirrored = mirror_images(&self.other_points, &self.design.points);
        let unequal = self.other_points.iter().filter(|(name, _)| !mirrored.contains(name));
        unequal.map(|(name, point)| (*name, point.clone())).collect()
    }

    /// Names of the hardpoints, without mirror images; those of the other side begin with its word: `right.lower_ball`.
    pub fn point_names(&self) -> Vec<String> {
        let word = self.points_side.other_word();
        let own = self.design.points.keys().map(|name| (*name).to_owned());
        own.chain(self.unequal_points().keys().map(|name| format!("{word}.{name}"))).collect()
    }
}

/// Refuses displacements of unknown hardpoints, and displacements (m) beyond the limit; `unit`: unit of the file.
pub(in super::super) fn check_moves(
    moves: &[(String, [f64; 3])],
    unit: LengthUnit,
    known: &[&str],
    findings: &mut Findings,
) {
    for (name, by) in moves {
        let shift = Vector3::from(*by).amax();
        if !known.contains(&name.as_str()) {
            let near = catalogue::suggestion(name, known.iter().copied());
            let message = format!("no hardpoint {} in the sheet{near} (--move)", quoted(name));
            findings.error("unknown-point", &Spot::default(), message);
        } else if shift > MAX_SHIFT {
            let message = format!(
                "the point {} is moved by {shift} m; at most {MAX_SHIFT} m are expected. A number without a unit is in m, \
                 also if the sheet is in {}: write {shift}mm for millimetres (--move)",
                quoted(name),
                unit.name()
            );
            findings.error("wrong-unit", &Spot::default(), message);
        }
    }
}

/// Applies the displacements of hardpoints (name; m, in the axes of the sheet and on the side of its points).
pub(in super::super) fn apply_moves(
    sheet: &mut Sheet,
    moves: &[(String, [f64; 3])],
    findings: &mut Findings,
) {
    let word = sheet.points_side.other_word();
    let mirrored = mirror_images(&sheet.other_points, &sheet.design.points);
    let own = sheet.design.points.keys().map(|name| (*name).to_owned());
    let names: Vec<String> =
        own.chain(sheet.other_points.keys().map(|name| format!("{word}.{name}"))).collect();
    let known: Vec<&str> = names.iter().map(String::as_str).collect();
    check_moves(moves, sheet.frame.unit, &known, findings);
    for (name, by) in moves {
        let mut by = sheet.frame.axes.to_iso(Vector3::from(*by));
        let of_other = name.strip_prefix(word).and_then(|rest| rest.strip_prefix('.'));
        if let Some((at, _)) = of_other.and_then(|name| sheet.other_points.get_mut(name)) {
            by.y = if sheet.points_side == Side::Right { by.y } else { 0.0 - by.y };
            *at += by;
            continue;
        }
        if sheet.points_side == Side::Right && !sheet.template.is_central(name) {
            by.y = 0.0 - by.y;
        }
        // The mirror image of a moved point stays its mirror image.
        let mirror_image = sheet.other_points.iter_mut().filter(|(key, _)| mirrored.contains(key));
        for (key, (at, _)) in sheet.design.points.iter_mut().chain(mirror_image) {
            if *key == name {
                *at += by;
            }
        }
    }
}

/// Spindle and wheel of the left side. A wheel centre on the wrong side is an error.
fn spindle(sheet: &Sheet, findings: &mut Findings) -> Spindle {
    let at = sheet.design.point("wheel_centre").unwrap_or_default();
    let spot = sheet.design.spot("wheel_centre");
    let body = match sheet.design.bodies.get("spindle") {
        Some(GivenBody::Body(body)) => {
            Body { com: if body.com.x.is_nan() { at } else { body.com }, ..body.clone() }
        }
        Some(GivenBody::Rod(..)) | None => Body {
            mass: 0.0,
            com: at,
            about_com: Matrix3::zeros(),
            spot: spot.clone(),
            com_spot: spot.clone(),
        },
    };
    if sheet.template.middle {
        if at.y != 0.0 {
            let message =
                "the wheel of this template is in the vehicle's middle plane: y = 0 is expected".to_owned();
            findings.error("wrong-side", &spot, message);
        }
    } else if at.y <= 0.0 && !findings.has_errors() {
        findings.error("wrong-side", &spot, wrong_side_message(sheet, at.y));
    }
    warn_reversed_x(sheet, findings);
    Spindle::new(findings, body, at, [sheet.camber, sheet.toe], sheet.axle_inertia, sheet.wheel)
}

/// Warns about a vehicle whose front points lie behind the rear ones. Masses do not depend on the direction of x, but caster, toe and
/// anti-dive have the wrong sign.
fn warn_reversed_x(sheet: &Sheet, findings: &mut Findings) {
    let pairs = front_points(sheet);
    let behind: Vec<&FrontPoint> = pairs.iter().filter(|pair| pair.is_behind()).collect();
    if findings.has_errors() || 2 * behind.len() <= pairs.len() {
        return;
    }
    let Some(FrontPoint { front, back, at: [front_x, back_x] }) = behind.first() else { return };
    let axes = sheet.frame.axes;
    let of_file = |x: &f64| short(axes.coordinate(0, sheet.frame.unit.of_metres(*x)) + 0.0);
    let letter = axes.letter(0);
    let side = match sheet.points_side {
        Side::Both => String::new(),
        _ if sheet.template.middle => String::new(),
        Side::Left => " and side = \"right\"".to_owned(),
        Side::Right => " and side = \"left\"".to_owned(),
    };
    let message = format!(
        "{front} ({letter} = {}) lies behind {back} ({letter} = {}) in the axes \"{}\" ({}), and so do {} of {} such points: angles and anti-dive would \
         have the wrong sign. Write {}{side}, or change the sign of every {letter}",
        of_file(front_x),
        of_file(back_x),
        axes.name(),
        axes.words(),
        behind.len(),
        pairs.len(),
        other_axes(axes)
    );
    findings.warning("reversed-x", &sheet.design.spot(front), message);
}

/// Point that lies in front of another one on every vehicle, and the x of both, m.
struct FrontPoint {
    front: String,
    back: String,
    at: [f64; 2],
}

impl FrontPoint {
    /// True if the point lies behind the other one.
    fn is_behind(&self) -> bool {
        self.at[0] < self.at[1]
    }
}

/// Points of a sheet that lie in front of others: those named `front`, apart from the ends of an axis of a rocker; pivots of trailing arms,
/// in front of the wheel; the lower end of a fork.
fn front_points(sheet: &Sheet) -> Vec<FrontPoint> {
    let x = |name: &str| sheet.design.point(name).map(|at| at.x);
    let pair = |key: &&'static str| {
        let back = match *key {
            "arm_inner" | "arm_outer" | "arm_chassis" | "swing_arm_left" | "lower_pivot" => {
                "wheel_centre".to_owned()
            }
            "fork_bottom" => "fork_top".to_owned(),
            name if name.starts_with("rocker") || !name.contains("front") => return None,
            name => name.replace("front", "back"),
        };
        Some(FrontPoint { front: (*key).to_owned(), at: [x(key)?, x(&back)?], back })
    };
    sheet.design.points.keys().filter_map(pair).collect()
}

/// Axes turned by 180° about the vertical, as the key of a sheet.
fn other_axes(axes: VehicleAxes) -> String {
    let turned = axes.turned();
    format!("axes = \"{}\" ({})", turned.name(), turned.words())
}

/// Message for a wheel at `y` ≤ 0 (m) on the side that the points describe, with the key to change: `axes` if the front points
/// are behind the rear ones too, `side` if the other points are on the same side as the wheel, or else the sign of y.
fn wrong_side_message(sheet: &Sheet, y: f64) -> String {
    let (unit, axes) = (sheet.frame.unit, sheet.frame.axes);
    let is_left = sheet.points_side == Side::Left;
    let (stated, other) = if is_left { ("left", "right") } else { ("right", "left") };
    let (letter, y_of_side) = (axes.letter(1), if is_left { y } else { -y });
    let given = short(axes.coordinate(1, unit.of_metres(y_of_side)));
    if y == 0.0 {
        return format!(
            "{letter} = 0: the wheel's centre is in the middle plane of the vehicle; enter half of the track, in {}",
            unit.name()
        );
    }
    let points = || sheet.design.points.iter().filter(|(key, _)| **key != "wheel_centre");
    let lateral = || points().filter(|(key, (at, _))| !sheet.template.is_central(key) && at.y != 0.0);
    let across = lateral().filter(|(_, (at, _))| at.y < 0.0).count();
    let pairs = front_points(sheet);
    let reversed = pairs.iter().filter(|pair| pair.is_behind()).count();
    let remedy = if 2 * across < lateral().count() {
        format!("only this point is on that side: change the sign of its {letter} to {}", -given)
    } else if pairs.is_empty() {
        format!(
            "the other points are on that side too: write side = \"{other}\", or, if the axes along and across the vehicle point the other way, {}",
            other_axes(axes)
        )
    } else if 2 * reversed > pairs.len() {
        format!(
            "the other points are on that side too, and front points lie behind rear ones, so the stated axes are wrong: write {}",
            other_axes(axes)
        )
    } else {
        format!("the other points are on that side too: write side = \"{other}\"")
    };
    format!(
        "{letter} = {given} {} is on the {other} side of the vehicle in the axes \"{}\" ({}), and the points describe the {stated} \
         side (key side); {remedy}",
        unit.name(),
        axes.name(),
        axes.words()
    )
}
