//! Question about a contact of a model, in terms of names: the tables of a study.

use crate::model::loading::refuse_pipe;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::link_points::Hold;
use crate::question::names::Names;
use crate::question::pose_file::GivenPose;
use crate::question::tables::contact::{ConditionsTable, ContactTable, PoseTable};
use crate::values::value::path_in;
use percuss_dynamics::Contact;
use percuss_mechanism::{Mechanism, NamedContact};
use percuss_spatial::Transform;
use std::borrow::Cow;
use std::fmt::Display;
use std::path::Path;

/// Question about a contact of a model: tables of a study, and the positions that they name.
///
/// The mechanism moves to the touch of a named stop, unless a travel or positions give the pose, or all joints that move the stop are set.
/// The joint of a joint stop moves to its limit, unless its position is given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MassQuestion {
    /// Contact.
    pub contact: ContactTable,
    /// Pose.
    pub pose: PoseTable,
    /// Positions of all joints, from the file of the pose; `set` and `guess` of the pose take precedence.
    pub positions: Option<GivenPose>,
    /// Conditions.
    pub conditions: ConditionsTable,
    /// Held contacts.
    pub hold: Vec<Hold>,
    /// Set of names used in messages for the parts of the question.
    pub names: Names,
}

impl MassQuestion {
    /// Question of the tables of a study; the positions of its file are not read.
    pub fn of_tables(
        contact: &ContactTable,
        pose: &PoseTable,
        conditions: &ConditionsTable,
        hold: &[Hold],
        names: Names,
    ) -> Self {
        let (contact, pose, conditions) = (contact.clone(), pose.clone(), conditions.clone());
        Self { contact, pose, positions: None, conditions, hold: hold.to_vec(), names }
    }

    /// The question with the positions of its file and a checked contact, which may be incomplete. Paths are relative to `folder`; the file
    /// has at most `max_size` bytes.
    ///
    /// # Errors
    /// [`InvalidKey`]: keys that exclude each other, or an unreadable file of positions.
    pub fn checked(mut self, folder: &Path, max_size: u64) -> Result<Self, InvalidKey> {
        let refuse = |error: &dyn Display| InvalidKey::new("pose.file", error.to_string());
        if let Some(file) = &self.pose.file {
            // The standard input and absolute paths are kept.
            let path = path_in(folder, file);
            if matches!(self.names, Names::Keys(_)) {
                refuse_pipe(&path).map_err(|error| refuse(&error))?;
            }
            let read = GivenPose::read_as(&path, file, max_size).map_err(|error| refuse(&error))?;
            self.positions = Some(read);
        }
        self.contact = self.contact.checked()?;
        Ok(self)
    }

    /// Question with the link, point, normal and other side of its named contact; the name remains, so that a stop is
    /// still brought to the touch. A question that has a link is resolved already.
    ///
    /// # Errors
    /// Unknown contact.
    pub(crate) fn resolve_contact(&self, mechanism: &Mechanism) -> Result<Cow<'_, Self>, StudyError> {
        if self.contact.link.is_some() {
            return Ok(Cow::Borrowed(self));
        }
        if let Some(spelled) = self.spelled_contact(mechanism)? {
            return Ok(Cow::Owned(self.with_spelled(&spelled, mechanism)?));
        }
        let Some(named) = self.named_contact(mechanism)? else { return Ok(Cow::Borrowed(self)) };
        let mut contact = self.contact.with_contact(&Contact::named(named, mechanism.root()), mechanism);
        if self.contact.has_normal() {
            if named.gap().is_some() {
                let why = "the named contact is a stop, whose normal belongs to its gap; remove the normal, or give link, point and normal";
                return Err(StudyError::input("contact.normal", why));
            }
            let [x, y, z] = self.contact.normal.unwrap_or_default().0;
            contact = contact.with_normal([x, y, z], self.contact.normal_frame());
        }
        Ok(Cow::Owned(Self { contact, ..self.clone() }))
    }

    /// True if a travel or a file of positions gives the pose.
    pub(crate) fn gives_pose(&self) -> bool {
        !self.pose.travel.is_empty() || self.positions.is_some()
    }

    /// X_wr of the pose of the question; `None` if the root link is at the origin of the world.
    pub(crate) fn base_pose(&self) -> Option<&Transform<f64>> {
        self.positions.as_ref().map(|pose| &pose.base).filter(|base| **base != Transform::identity())
    }

    /// Named contact of the question; `None` if `at` is empty, or describes a contact in one of the other forms of
    /// [`FurtherContact`](crate::FurtherContact).
    pub(crate) fn named_contact<'m>(
        &self,
        mechanism: &'m Mechanism,
    ) -> Result<Option<&'m NamedContact>, StudyError> {
        if self.spelled_contact(mechanism)?.is_some() {
            return Ok(None);
        }
        let find = |name: &String| mechanism.find_contact(name).map_err(StudyError::about("contact.at"));
        self.contact.at.as_ref().map(find).transpose()
    }

    /// Question at a named contact of the model, or at a contact as text in a form of [`FurtherContact`](crate::FurtherContact), in place of
    /// its own contact.
    pub fn at_contact(&self, name: &str) -> Self {
        let contact = ContactTable { at: Some(name.to_owned()), ..self.contact.without_geometry() };
        Self { contact, ..self.clone() }
    }
}
