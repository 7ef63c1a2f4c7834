//! Contacts given as one text: the name of a contact of the model, a point with its normal, a moment about an axis, a cable, or the stop
//! of a joint.

use crate::question::errors::fault::Fault;
use crate::question::errors::question_error::StudyError;
use crate::question::link_points::Hold;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::{ContactTable, FrameName};
use crate::values::position::GivenPosition;
use crate::values::quantities::{LinkPoint, Point, Vector};
use percuss_contact::exports::StopMotion;
use percuss_dynamics::{Contact, Direction, Frame};
use percuss_mechanism::{Joint, JointId, JointKind, Mechanism, near_names};
use percuss_spatial::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

/// Stop of a joint, in reports.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StopRecord {
    /// The joint.
    pub joint: String,
    /// Motion of the joint. `turn`: the mass is an inertia in kg·m², the stiffness is in N·m/rad, the speed in
    /// rad/s, and so on. `slide`: kg, N/m, m/s.
    pub motion: StopMotion,
}

/// Motion of a joint into a stop; `None` unless the joint has exactly one position.
pub(crate) fn stop_motion(joint: &Joint) -> Option<StopMotion> {
    match joint.kind() {
        JointKind::Revolute | JointKind::Continuous => Some(StopMotion::Turn),
        JointKind::Prismatic => Some(StopMotion::Slide),
        JointKind::Fixed | JointKind::Planar | JointKind::Spherical | JointKind::Floating => None,
    }
}

/// Error message for a text `JOINT:END` with a misspelled end; `None` for other texts. Names of joints may contain colons, so only words
/// that are similar to an end count as misspelled.
pub(crate) fn misspelled_end(text: &str) -> Option<String> {
    let (joint, word) = text.rsplit_once(':').filter(|(_, word)| !word.contains([',', '=']))?;
    let near = near_names(word, ["lower", "upper"]).concat();
    (!near.is_empty()).then(|| {
        format!(
            "\"{word}\" is not an end of the joint range; did you mean {joint}:{near}? The ends are lower and upper"
        )
    })
}

/// End of the range of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum StopEnd {
    /// Lower limit.
    Lower,
    /// Upper limit.
    Upper,
}

/// Stop of a joint with one degree of freedom.
#[derive(Clone, Debug, PartialEq)]
pub struct JointStop {
    /// The joint.
    pub joint: String,
    /// End of the range. The joint is set to this limit unless the question sets the joint. `None`: stop at the
    /// position in the pose, against motion in the positive direction.
    pub end: Option<StopEnd>,
}

impl std::str::FromStr for JointStop {
    type Err = String;
    /// Reads `JOINT`, `JOINT:lower` or `JOINT:upper`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (joint, end) = match text.rsplit_once(':') {
            Some((joint, "lower")) => (joint, Some(StopEnd::Lower)),
            Some((joint, "upper")) => (joint, Some(StopEnd::Upper)),
            _ => (text, None),
        };
        if let Some(error) = misspelled_end(text).filter(|_| end.is_none()) {
            return Err(error);
        }
        match joint {
            "" => Err("expected JOINT, JOINT:lower or JOINT:upper, such as elbow:upper".into()),
            _ => Ok(JointStop { joint: joint.to_owned(), end }),
        }
    }
}

/// Contact given as one text: in `at`, or as a further contact of an impact.
#[derive(Clone, Debug, PartialEq)]
pub enum FurtherContact {
    /// Contact of the model.
    Named(String),
    /// Point of a link (m, link's frame), with the normal out of the link (world axes).
    Point {
        /// The link.
        link: String,
        /// The point.
        point: [f64; 3],
        /// The normal.
        normal: [f64; 3],
        /// Link on the other side; `None` for the ground.
        against: Option<String>,
    },
    /// Moment about an axis. Impulses are N·m·s, speeds rad/s and masses kg·m².
    Moment {
        /// The link.
        link: String,
        /// The axis, frame of the link.
        axis: [f64; 3],
        /// Link on the other side; `None` for the ground.
        against: Option<String>,
    },
    /// Cable between points (m, frames of the links) of two links: it resists lengthening.
    Cable {
        /// The link.
        link: String,
        /// Its end of the cable.
        point: [f64; 3],
        /// The other link.
        other: String,
        /// Its end of the cable.
        end: [f64; 3],
    },
    /// Stop of a joint with one velocity. Impulses are N·m·s, speeds rad/s and masses kg·m² if the joint turns.
    JointStop {
        /// The joint.
        joint: String,
        /// True for the upper limit: the stop acts against a positive rate.
        is_upper: bool,
    },
    /// Contact of the mechanism of the question.
    Resolved(Contact),
}

/// Forms of a contact as text, for messages.
const FORMS: &str = "the name of a contact, a point LINK:X,Y,Z:NX,NY,NZ such as foot:0,0,0:0,0,-1, a moment LINK:about:X,Y,Z (points and \
                     moments against another link end with =OTHER), a cable LINK:X,Y,Z=LINK:X,Y,Z, or the stop JOINT:lower or JOINT:upper";

impl std::str::FromStr for FurtherContact {
    type Err = String;
    /// Reads `NAME`, `LINK:X,Y,Z:NX,NY,NZ[=OTHER]`, `LINK:about:X,Y,Z[=OTHER]`, `LINK:X,Y,Z=LINK:X,Y,Z`, `JOINT:lower` or `JOINT:upper`.
    fn from_str(text: &str) -> Result<Self, String> {
        if !text.contains(':') {
            return Ok(Self::Named(text.to_owned()));
        }
        if let Some((joint, end @ ("lower" | "upper"))) = text.rsplit_once(':') {
            return Ok(Self::JointStop { joint: joint.to_owned(), is_upper: end == "upper" });
        }
        if let Some(error) = misspelled_end(text) {
            return Err(error);
        }
        let (first, second) = match text.split_once('=') {
            Some((first, second)) => (first, Some(second)),
            None => (text, None),
        };
        // Link on the other side of a point or a moment: the whole text after `=`.
        let other = || match second {
            Some(other) if other.is_empty() || other.contains(':') => {
                Err(format!("\"{other}\" after =: expected the name of the link on the other side"))
            }
            other => Ok(other.map(str::to_owned)),
        };
        let axis = first.rsplit_once(':').and_then(|(rest, axis)| Some((rest.strip_suffix(":about")?, axis)));
        if let Some((link, axis)) = axis {
            let axis = percuss_units::parse_triple(axis, percuss_units::Dimension::Plain);
            let axis = axis.map_err(|error| format!("the axis of the moment LINK:about:X,Y,Z: {error}"))?;
            return Ok(Self::Moment { link: link.to_owned(), axis, against: other()? });
        }
        let read = |text: &str| {
            let hold: Result<Hold, String> = text.parse();
            hold.map_err(|error| format!("expected {FORMS}: {error}"))
        };
        let Hold { link, point, normal } = read(first)?;
        match (normal, second) {
            (Some(normal), _) => Ok(Self::Point { link, point, normal, against: other()? }),
            (None, Some(second)) => {
                let end = read(second)?;
                if end.normal.is_some() {
                    return Err(
                        "expected a cable LINK:X,Y,Z=LINK:X,Y,Z, such as hook:0,0,0=frame:0,0,1".into()
                    );
                }
                Ok(Self::Cable { link, point, other: end.link, end: end.point })
            }
            (None, None) => Err(format!("expected {FORMS}")),
        }
    }
}

/// Contact of a mechanism from its text: the name of a contact of the model, or a form of [`FurtherContact`].
///
/// # Errors
/// Unknown names; a text of another form.
pub fn contact_of_text(mechanism: &Mechanism, text: &str) -> Result<Contact, StudyError> {
    let spelled = match mechanism.find_contact(text) {
        Ok(_) => Ok(FurtherContact::Named(text.to_owned())),
        Err(_) => text.parse(),
    };
    let refuse = |message: String| StudyError::input("contact.at", message);
    spelled.map_err(refuse)?.resolve(mechanism, "contact.at")
}

impl FurtherContact {
    /// Finds the links and joints of the contact. `field`: field of the question that errors name.
    ///
    /// # Errors
    /// Unknown names; the stop of a joint that has several velocities, or none.
    pub(crate) fn resolve(&self, mechanism: &Mechanism, field: &'static str) -> Result<Contact, StudyError> {
        let find = |name: &String| mechanism.find_link(name).map_err(StudyError::about(field));
        let other = |name: &Option<String>| name.as_ref().map(find).transpose();
        match self {
            Self::Named(name) => {
                let named = mechanism.find_contact(name).map_err(StudyError::about(field))?;
                Ok(Contact::named(named, mechanism.root()))
            }
            Self::Point { link, point, normal, against } => {
                let normal = Direction::Along(Vector3::from(*normal), Frame::World);
                Ok(Contact { link: find(link)?, against: other(against)?, point: (*point).into(), normal })
            }
            Self::Moment { link, axis, against } => {
                Ok(Contact { against: other(against)?, ..Contact::about_axis(find(link)?, *axis) })
            }
            Self::Cable { link, point, other, end } => {
                Ok(Contact::cable(find(link)?, *point, find(other)?, *end))
            }
            Self::JointStop { joint, is_upper } => {
                let id = mechanism.find_joint(joint).map_err(StudyError::about(field))?;
                let kind = mechanism.joint(id).kind();
                let no_stop = || StudyError::input(field, Fault::NoStop { joint: joint.clone(), kind });
                Contact::joint_stop(mechanism, id, *is_upper).ok_or_else(no_stop)
            }
            Self::Resolved(contact) => Ok(*contact),
        }
    }
}

impl MassQuestion {
    /// Point, moment, cable or joint stop given by the text of `at`. `None` without `at`, for a text without a colon, and for the name of
    /// a contact of the model.
    ///
    /// # Errors
    /// A text with a colon that is neither a contact of the model nor one of these forms.
    pub(crate) fn spelled_contact(
        &self,
        mechanism: &Mechanism,
    ) -> Result<Option<FurtherContact>, StudyError> {
        let is_spelled = |text: &&String| text.contains(':') && mechanism.find_contact(text).is_err();
        let Some(text) = self.contact.at.as_ref().filter(is_spelled) else { return Ok(None) };
        let refuse = |message: String| StudyError::input("contact.at", message);
        text.parse().map(Some).map_err(refuse)
    }

    /// Joint of the stop that `at` describes, and its motion; `None` for other contacts.
    pub(crate) fn stop_of_joint(&self, mechanism: &Mechanism) -> Option<(JointId, StopMotion)> {
        let Ok(Some(FurtherContact::JointStop { joint, .. })) = self.spelled_contact(mechanism) else {
            return None;
        };
        let id = mechanism.find_joint(&joint).ok()?;
        Some((id, stop_motion(mechanism.joint(id))?))
    }

    /// True for a moment about an axis, and for the stop of a revolute joint: m̄ in kg·m², speeds in rad/s.
    pub fn is_moment(&self, mechanism: &Mechanism) -> bool {
        let is_stop = || self.stop_of_joint(mechanism).is_some_and(|(_, motion)| motion == StopMotion::Turn);
        let is_spelled =
            || matches!(self.spelled_contact(mechanism), Ok(Some(FurtherContact::Moment { .. })));
        self.contact.about_axis.is_some() || is_stop() || is_spelled()
    }

    /// Refuses a result that requires a contact point if the resolved contact is a moment.
    pub(crate) fn refuse_moment(&self, result: &'static str) -> Result<(), StudyError> {
        if self.contact.about_axis.is_none() {
            return Ok(());
        }
        let is_moment = |text: &String| matches!(text.parse(), Ok(FurtherContact::Moment { .. }));
        let (field, contact) = match &self.contact.at {
            Some(text) if is_moment(text) => ("contact.at", "a moment about an axis"),
            Some(_) => ("contact.at", "the stop of a joint"),
            None => ("contact.about_axis", "a moment about an axis"),
        };
        Err(StudyError::input(field, Fault::NoContactPoint { contact, result }))
    }

    /// Question with the link, point, normal and other side of `contact`. The joint of a stop is set to its limit, a mimic through its
    /// master, unless the question gives the position of the joint or of the master.
    pub(crate) fn with_spelled(
        &self,
        contact: &FurtherContact,
        mechanism: &Mechanism,
    ) -> Result<Self, StudyError> {
        let refuse = |field, message: &str| Err(StudyError::input(field, message));
        if self.contact.has_normal() {
            return refuse(
                "contact.normal",
                "the contact of `at` has its own normal; expected no further normal",
            );
        }
        let with = |contact: ContactTable| {
            let ContactTable { at, against_mass, estimate, ratio_at, .. } = self.contact.clone();
            let contact = ContactTable { at, against_mass, estimate, ratio_at, ..contact };
            Self { contact, ..self.clone() }
        };
        match contact {
            FurtherContact::Named(_) | FurtherContact::Resolved(_) => Ok(self.clone()),
            FurtherContact::Point { link, point, normal, against } => Ok(with(ContactTable {
                normal_frame: Some(FrameName::World),
                against: against.clone(),
                ..ContactTable::at_point(link, *point, *normal)
            })),
            FurtherContact::Moment { link, axis, against } => Ok(with(ContactTable {
                link: Some(link.clone()),
                about_axis: Some(Vector(*axis)),
                against: against.clone(),
                ..ContactTable::default()
            })),
            FurtherContact::Cable { link, point, other, end } => Ok(with(ContactTable {
                link: Some(link.clone()),
                point: Some(Point(*point)),
                along_line: Some(LinkPoint { link: other.clone(), point: Point(*end) }),
                cable: true,
                against: self.contact.against_mass.is_none().then(|| other.clone()),
                ..ContactTable::default()
            })),
            FurtherContact::JointStop { joint, is_upper } => {
                if self.contact.against_mass.is_some() {
                    return refuse(
                        "contact.against_mass",
                        "the stop of a joint has no free body on the other side",
                    );
                }
                let unknown = StudyError::about("contact.at");
                let resolved = contact.resolve(mechanism, "contact.at")?;
                let declared = mechanism.joint(mechanism.find_joint(joint).map_err(unknown)?);
                let mut question = with(ContactTable::default().with_contact(&resolved, mechanism));
                let master = declared.mimic().map(|mimic| mechanism.joint(mimic.master).name());
                let is_set =
                    |(set, _): &(String, GivenPosition)| set == joint || Some(set.as_str()) == master;
                let is_given = self.pose.set.iter().any(is_set) || self.gives_pose();
                if !is_given {
                    let limits = declared.limits().ok_or_else(|| {
                        StudyError::input("contact.at", Fault::NoLimit { joint: joint.clone() })
                    })?;
                    let at = if *is_upper { limits.upper } else { limits.lower };
                    // A mimic cannot be set: the position of its master moves the mimic to its limit.
                    let (moved, at) = match declared.mimic().filter(|mimic| mimic.multiplier != 0.0) {
                        Some(mimic) => {
                            let master = mechanism.joint(mimic.master).name().to_owned();
                            (master, (at - mimic.offset) / mimic.multiplier)
                        }
                        None => (joint.clone(), at),
                    };
                    let position = GivenPosition::from_numbers(&[at]);
                    let wrong = |source| {
                        StudyError::input("contact.at", Fault::Position { joint: joint.clone(), source })
                    };
                    question.pose.set.push((moved, position.map_err(wrong)?));
                }
                Ok(question)
            }
        }
    }
}
