//! Points of the other side of a suspension.

use crate::options::Side;
use crate::sheet::catalogue::suggestion;
use crate::sheet::read::SheetReader;
use crate::sheet::sections::mirror_images::{Points, mirror_images};
use crate::sheet::template::Template;
use crate::units::Frame;
use percuss_formats::reading::quoted;
use percuss_spatial::Vector3;

impl SheetReader<'_> {
    /// Points of the section `[points.right]` (or `[points.left]`, if the points are those of the right side), as points of the left side.
    pub fn other_points(
        &mut self,
        template: &'static Template,
        frame: Frame,
        points_side: Side,
        own: &Points,
    ) -> Points {
        let word = points_side.other_word();
        let prefix = format!("points.{word}.");
        let unread = self.entries.unread();
        let names: Vec<String> =
            unread.filter_map(|entry| Some(entry.key.strip_prefix(&prefix)?.to_owned())).collect();
        let mut points = Points::new();
        for name in &names {
            let read = self.entries.point(self.findings, &format!("{prefix}{name}"), frame);
            let Some((at, spot)) = read else { continue };
            let of_side =
                || template.points.iter().map(|(key, _)| &**key).filter(|key| !template.is_central(key));
            let Some(key) = of_side().find(|key| key == name) else {
                let near = suggestion(name, of_side());
                let message = format!("{} has no point {} of a side{near}", template.name, quoted(name));
                self.findings.error("unknown-point", &spot, message);
                continue;
            };
            if !own.contains_key(key) {
                let message =
                    format!("the point {key} is given for the {word} side only: give it for both sides");
                self.findings.error("missing-key", &spot, message);
            }
            let y = if points_side == Side::Right { at.y } else { 0.0 - at.y };
            points.insert(key, (Vector3::new(at.x, y, at.z), spot));
        }
        points
    }

    /// States the points of the other side that are no mirror images: in a note, or in a warning if only one side is built.
    pub fn report_unequal_points(&mut self, other: &Points, own: &Points, points_side: Side, side: Side) {
        let mirrored = mirror_images(other, own);
        let unequal: Vec<&str> = other.keys().filter(|name| !mirrored.contains(name)).copied().collect();
        let Some((_, spot)) = unequal.first().and_then(|name| other.get(name)) else { return };
        let word = points_side.other_word();
        let is_across = |name: &&&str| {
            let [of_other, of_own] =
                [other, own].map(|points| points.get(**name).map_or(0.0, |(at, _)| at.y));
            of_other * of_own < 0.0
        };
        let list = unequal.join(", ");
        if 2 * unequal.iter().filter(is_across).count() > unequal.len() {
            let message = format!(
                "the points of the {word} side lie on the side of the other points: change the sign of their coordinate across the vehicle"
            );
            self.findings.error("wrong-side", spot, message);
        } else if side == Side::Both {
            let message = format!(
                "the {word} side has points of its own ({list}); its other points, masses, centres of mass and inertias are mirror images"
            );
            self.findings.note("unequal-sides", spot, message);
        } else {
            let message = format!(
                "the {word} side is no mirror image at {list}; only one side is built, and build = \"both\" uses these points"
            );
            self.findings.warning("unequal-sides", spot, message);
        }
    }
}
