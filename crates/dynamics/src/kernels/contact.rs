//! Converts a contact to the input of the crate `kernel`.

use crate::kinematics::contact::{Contact, Direction, Frame};
use crate::model::Model;
use crate::tolerances::SHORTEST_LINE;
use nalgebra::Vector3;
use percuss_kernel::{LinkFrame, Normal, NormalFrame};
use percuss_mechanism::LinkId;

/// Converts a checked contact of a model to a contact of the crate `kernel`.
pub(crate) fn kernel_contact(model: &Model, contact: &Contact) -> percuss_kernel::Contact {
    let link = |link: LinkId| {
        let own = &model.link_frames[link.index()];
        LinkFrame { body: own.body, frame: own.frame }
    };
    let normal = match contact.normal {
        Direction::Along(n, frame) | Direction::About(n, frame) => {
            let frame = match frame {
                Frame::Link => NormalFrame::Link,
                Frame::Against => NormalFrame::Against,
                Frame::World => NormalFrame::Root,
            };
            Normal::Along(n, frame)
        }
        Direction::Toward(end, point)
        | Direction::TurningToward(end, point)
        | Direction::TurningAwayFrom(end, point) => {
            let drawn = model.drawn_line(contact);
            Normal::Toward {
                end: link(end),
                point,
                drawn: drawn.map_or_else(Vector3::x, |drawn| drawn.unit),
                shortest: SHORTEST_LINE * drawn.map_or(f64::INFINITY, |drawn| drawn.length),
                least_cosine: contact.normal.least_cosine(),
            }
        }
    };
    let (on, against) = (link(contact.link), contact.against.map(link));
    let is_moment = contact.normal.is_moment();
    percuss_kernel::Contact { on, against, point: contact.point, normal, is_moment }
}
