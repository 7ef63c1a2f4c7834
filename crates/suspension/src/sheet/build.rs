//! Builds the corner of a sheet.

use super::read::Sheet;
use crate::corner::Body;
use crate::corner::build::{self, Built};
use crate::corner::design::GivenBody;
use crate::corner::spindle::Spindle;
use crate::findings::Findings;
use percuss_spatial::Matrix3;

/// Builds the corner of a sheet; reports points that determine no axis or line.
pub(in super::super) fn build(sheet: &Sheet, findings: &mut Findings) -> Option<Built> {
    let spindle = spindle(sheet, findings);
    build::build(&sheet.design, &spindle, findings)
}

/// Spindle and wheel of the left side.
fn spindle(sheet: &Sheet, findings: &mut Findings) -> Spindle {
    let at = sheet.design.point("wheel_centre").unwrap_or_default();
    let spot = sheet.design.spot("wheel_centre");
    let body = match sheet.design.bodies.get("spindle") {
        Some(GivenBody::Body(body)) => {
            Body { com: if body.com.x.is_nan() { at } else { body.com }, ..body.clone() }
        }
        Some(GivenBody::Rod(..)) | None => {
            Body { mass: 0.0, com: at, about_com: Matrix3::zeros(), spot: spot.clone() }
        }
    };
    if at.y <= 0.0 && !findings.has_errors() {
        let message = format!(
            "the wheel's centre is at y = {} m, seen from the side that the points describe: 0 or the other side. \
             side = \"left\" or \"right\" says which it is, axes which way y points",
            at.y
        );
        findings.error("wrong-side", &spot, message);
    }
    Spindle::new(findings, body, at, [sheet.camber, sheet.toe], sheet.axle_inertia, sheet.wheel)
}
