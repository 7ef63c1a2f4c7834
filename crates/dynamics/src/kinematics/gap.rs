//! Named contacts: the contact at their point, and their gap.

use crate::kinematics::contact::{Contact, Direction, Frame};
use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use crate::tolerances::OPEN_GAP;
use nalgebra::Vector3;
use percuss_mechanism::{ContactNormal, LinkId, Mechanism, NamedContact};

/// Gap of a named contact: distance along its normal between the contact point and the other side, as a function of the pose.
///
/// g = g₀ − s, m. s is the approach since all joints were at 0: for a fixed normal n, s = n · (p − p₀) in the frame of
/// the other side; for a line of length L, s = L₀ − L, or L − L₀ for a stop of the extension. ds/dt is the closing speed j q̇ of the contact.
#[derive(Clone, Debug)]
pub struct Gap {
    pub(crate) link: LinkId,
    pub(crate) point: Vector3<f64>,
    /// The other side; the root link for the ground.
    pub(crate) other: LinkId,
    pub(crate) normal: ContactNormal,
    /// n · p₀ + g₀ for a fixed normal; for a line, its length at the touch.
    touch: f64,
}

impl Contact {
    /// Contact of a named contact: a fixed normal in the frame of the other side, or a line that turns with the
    /// mechanism.
    pub fn named(contact: &NamedContact, root: LinkId) -> Self {
        let other = contact.against().unwrap_or(root);
        Self {
            link: contact.link(),
            against: contact.against(),
            point: *contact.point(),
            normal: match *contact.normal() {
                ContactNormal::Fixed(normal) => Direction::Along(normal, Frame::Against),
                ContactNormal::Toward(point) => Direction::TurningToward(other, point),
                ContactNormal::Away(point) => Direction::TurningAwayFrom(other, point),
            },
        }
    }
}

impl Gap {
    /// Gap of a named contact of the model's mechanism; `None` if its parts always touch.
    pub(crate) fn named(model: &Model, contact: &NamedContact) -> Option<Self> {
        let gap = contact.gap()?;
        let other = contact.against().unwrap_or(model.mechanism.root());
        let drawn =
            model.drawn_frame(other).inverse_point(&model.drawn_frame(contact.link()).point(contact.point()));
        let touch = match contact.normal() {
            ContactNormal::Fixed(normal) => normal.dot(&drawn) + gap,
            ContactNormal::Toward(point) => (point - drawn).norm() - gap,
            ContactNormal::Away(point) => (point - drawn).norm() + gap,
        };
        Some(Self { link: contact.link(), point: *contact.point(), other, normal: *contact.normal(), touch })
    }

    /// Named contacts with a gap, as contacts.
    pub(crate) fn all(model: &Model) -> Vec<(Contact, Self)> {
        let mechanism = &model.mechanism;
        let with_gap = |named| Some((Contact::named(named, mechanism.root()), Self::named(model, named)?));
        mechanism.contacts().iter().filter_map(with_gap).collect()
    }

    /// Gap of the named contact that has the link, point and normal of a contact; `None` without such a contact.
    pub(crate) fn of_contact(model: &Model, contact: &Contact) -> Option<Self> {
        let mechanism = &model.mechanism;
        let is_same = |named: &&NamedContact| Contact::named(named, mechanism.root()) == *contact;
        Self::named(model, mechanism.contacts().iter().find(is_same)?)
    }

    /// Gap of a contact at given frames, m, if it is a named contact and does not touch there.
    pub(crate) fn open_of(contact: &Contact, model: &Model, kinematics: &Kinematics) -> Option<f64> {
        Self::of_contact(model, contact)?.open_at(model, kinematics)
    }

    /// Gap for a position of the contact point in the frame of the other side, m; negative for a penetration.
    fn of_point(&self, here: &Vector3<f64>) -> f64 {
        match &self.normal {
            ContactNormal::Fixed(normal) => self.touch - normal.dot(here),
            ContactNormal::Toward(point) => (point - here).norm() - self.touch,
            ContactNormal::Away(point) => self.touch - (point - here).norm(),
        }
    }

    /// Gap at given frames, m.
    pub(crate) fn at_frames(&self, model: &Model, kinematics: &Kinematics) -> f64 {
        self.of_point(&self.point_on_other(model, kinematics))
    }

    /// Gap at given frames, m, if the contact does not touch there.
    pub(crate) fn open_at(&self, model: &Model, kinematics: &Kinematics) -> Option<f64> {
        Some(self.at_frames(model, kinematics)).filter(|gap| Self::is_open(*gap, &model.mechanism))
    }

    /// True if a contact of the mechanism with this gap (m) does not touch.
    pub fn is_open(gap: f64, mechanism: &Mechanism) -> bool {
        gap > OPEN_GAP * mechanism.characteristic_length()
    }

    /// Contact point in the frame of the other side, m.
    pub(crate) fn point_on_other(&self, model: &Model, kinematics: &Kinematics) -> Vector3<f64> {
        let at = kinematics.link_frame(model, self.link).point(&self.point);
        kinematics.link_frame(model, self.other).inverse_point(&at)
    }
}
