//! Is the contact point where the link is? A frame mistaken, or millimetres for metres, is the commonest slip.

use crate::DiagnosticRecord;
use nalgebra::Vector3;
use percuss_mechanism::{Geometry, LinkId, Mechanism, Severity};

/// A warning where the point lies beyond three times the reach of the link: of its declared shape, or, where that is
/// unknown, of the largest link.
pub(crate) fn doubt(mechanism: &Mechanism, link: LinkId, point: &Vector3<f64>) -> Option<DiagnosticRecord> {
    const FAR: f64 = 3.0;
    let body = mechanism.link(link);
    let reach = match body.geometry() {
        Geometry::Within(_) => body.extent(),
        Geometry::None | Geometry::Mesh => body.extent().max(mechanism.characteristic_length()),
    };
    let distance = point.norm();
    if reach <= 0.0 || distance <= FAR * reach {
        return None;
    }
    let millimetres = distance / 1000.0 <= FAR * reach && distance / 1000.0 >= 0.01 * reach;
    let hint = if millimetres {
        "is it in millimetres (write 12mm), or in another frame (--frame)?"
    } else {
        "is it in another frame (--frame), or another unit?"
    };
    let message = format!(
        "the contact point is {distance:.4} m from the origin of link \"{}\", which reaches about {reach:.4} m: {hint}",
        body.name()
    );
    Some(DiagnosticRecord::about_answer(Severity::Warning, "far-point", message))
}
