//! Plausibility of the contact point. A wrong frame, or millimetres instead of metres, is the most common
//! mistake.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use crate::question::names::Names;
use crate::thresholds::{FAR_POINT, NEAR_POINT};
use nalgebra::Vector3;
use percuss_mechanism::{Geometry, LinkId, Mechanism};

/// Warning if the point lies farther from the link's origin than three times the extent of the link. The extent
/// is given by the declared shape; for an unknown shape, by the larger of the link's extent and the mechanism's
/// characteristic length.
pub(crate) fn far_point_finding(
    mechanism: &Mechanism,
    link: LinkId,
    point: &Vector3<f64>,
    names: Names,
) -> Option<Finding> {
    let body = mechanism.link(link);
    let reach = match body.geometry() {
        Geometry::Within(_) => body.extent(),
        Geometry::None | Geometry::Mesh => body.extent().max(mechanism.characteristic_length()),
    };
    let distance = point.norm();
    if reach <= 0.0 || distance <= FAR_POINT * reach {
        return None;
    }
    let millimetres = distance / 1000.0 <= FAR_POINT * reach && distance / 1000.0 >= NEAR_POINT * reach;
    let frame = names.hint("contact.frame");
    let hint = if millimetres {
        format!("is it in millimetres (write 12mm), or in another frame{frame}?")
    } else {
        format!("is it in another frame{frame}, or another unit?")
    };
    let message = format!(
        "the contact point is {distance:.4} m from the origin of link \"{}\", which extends to about {reach:.4} m: \
         {hint}",
        body.name()
    );
    Some(Finding::new(FindingKind::FarPoint, FindingSubject::Link(link), message))
}
