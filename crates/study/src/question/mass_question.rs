//! Question about a contact of a model, in terms of names: the tables of a study.

use crate::model::loading::refuse_pipe;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::names::Names;
use crate::question::pose_file::GivenPose;
use crate::question::row_source::path_in;
use crate::question::tables::contact::{ConditionsTable, ContactTable, PoseTable};
use crate::values::quantities::{self, Point, Vector};
use percuss_dynamics::Contact;
use percuss_mechanism::{Mechanism, NamedContact};
use percuss_spatial::Transform;
use percuss_units::QuantityError;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt::Display;
use std::path::Path;
use std::str::FromStr;

/// Held contact: a point (m, link's frame) of a link that stays in place along a normal (world axes, out of the
/// link) or in all directions.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hold {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    #[serde(deserialize_with = "quantities::point")]
    #[schemars(with = "Point")]
    pub point: [f64; 3],
    /// The normal, world axes, out of the link; without a normal all directions are held.
    #[serde(default, deserialize_with = "quantities::some_vector", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vector>")]
    pub normal: Option<[f64; 3]>,
}

/// Splits `NAME[:X,Y,Z[:X,Y,Z]]` into the name, which may contain colons, and the texts of the triples.
pub(crate) fn triples(text: &str) -> (&str, Vec<&str>) {
    let (mut name, mut found) = (text, Vec::new());
    while found.len() < 2
        && let Some((rest, last)) = name.rsplit_once(':')
        && last.contains(',')
        && last.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
    {
        found.insert(0, last);
        name = rest;
    }
    (name, found)
}

/// Point of a flag.
fn parse_point(text: &str) -> Result<[f64; 3], String> {
    text.parse().map(|Point(point)| point).map_err(|error: QuantityError| error.to_string())
}

/// Vector of a flag.
fn parse_vector(text: &str) -> Result<[f64; 3], String> {
    text.parse().map(|Vector(vector)| vector).map_err(|error: QuantityError| error.to_string())
}

impl FromStr for Hold {
    type Err = String;
    /// Reads `LINK:X,Y,Z[:NX,NY,NZ]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (link, found) = triples(text);
        let (point, normal) = match found[..] {
            [point] => (point, None),
            [point, normal] => (point, Some(parse_vector(normal)?)),
            _ => return Err("expected LINK:X,Y,Z or LINK:X,Y,Z:NX,NY,NZ, such as foot:0,0,0:0,0,-1".into()),
        };
        Ok(Self { link: link.to_owned(), point: parse_point(point)?, normal })
    }
}

/// Request for the classical estimate: mass of some links, moving with a point of the first link.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EstimateQuestion {
    /// Links with a mass counted in the estimate.
    pub links: Vec<String>,
    /// Point A, m, in the first link's frame; default origin.
    #[serde(default, deserialize_with = "quantities::point")]
    #[schemars(with = "Option<Point>")]
    pub point: [f64; 3],
    /// Direction of the counted component of A's velocity, world axes; default: upwards in a suspension, otherwise the full speed.
    #[serde(default, deserialize_with = "quantities::some_vector", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vector>")]
    pub direction: Option<[f64; 3]>,
}

impl FromStr for EstimateQuestion {
    type Err = String;
    /// Reads `LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (links, found) = triples(text);
        let links: Vec<String> = links.split(',').map(str::to_owned).collect();
        if links.iter().any(String::is_empty) {
            return Err(
                "expected LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]], such as spindle,upright:0,0,0:0,0,1".into()
            );
        }
        let point = found.first().map_or(Ok([0.0; 3]), |text| parse_point(text))?;
        let direction = found.get(1).map(|text| parse_vector(text)).transpose()?;
        Ok(Self { links, point, direction })
    }
}

/// Default direction of a motion ratio: upwards, as for wheel travel.
pub const UPWARDS: [f64; 3] = [0.0, 0.0, 1.0];

/// Point of a motion ratio relative to the contact.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RatioPoint {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    #[serde(default, deserialize_with = "quantities::point")]
    #[schemars(with = "Option<Point>")]
    pub point: [f64; 3],
    /// Direction of the speed, world axes, of any length; default z.
    #[serde(default = "upwards", deserialize_with = "quantities::vector")]
    #[schemars(with = "Option<Vector>")]
    pub direction: [f64; 3],
}

/// Default of the `direction` key.
fn upwards() -> [f64; 3] {
    UPWARDS
}

impl FromStr for RatioPoint {
    type Err = String;
    /// Reads `LINK:X,Y,Z[:DX,DY,DZ]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (link, found) = triples(text);
        let (point, direction) = match found[..] {
            [point] => (point, UPWARDS),
            [point, direction] => (point, parse_vector(direction)?),
            _ => return Err("expected LINK:X,Y,Z or LINK:X,Y,Z:DX,DY,DZ, such as wheel:0,0,0:0,0,1".into()),
        };
        Ok(Self { link: link.to_owned(), point: parse_point(point)?, direction })
    }
}

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
        let find =
            |name: &String| mechanism.find_contact(name).map_err(|e| StudyError::input("contact.at", e));
        self.contact.at.as_ref().map(find).transpose()
    }

    /// Question at a named contact of the model, or at a contact as text in a form of [`FurtherContact`](crate::FurtherContact), in place of
    /// its own contact.
    pub fn at_contact(&self, name: &str) -> Self {
        let contact = ContactTable { at: Some(name.to_owned()), ..self.contact.without_geometry() };
        Self { contact, ..self.clone() }
    }
}
