//! Contacts, with links given by name.

use crate::conversion::arrays::triple;
use crate::conversion::errors::{self, extract, input, of_argument};
use percuss::nalgebra::Vector3;
use percuss::study::contact_of_text;
use percuss::{Contact as Resolved, Direction, Frame, Mechanism};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyAny;

/// Contact(link, point, normal=None, *, against=None, toward=None, normal_frame="link", turning=False, cable=False)
/// --
///
/// Contact between a point of a link and another link or the ground.
///
/// link: the contact link. point: (3,) m, in its frame. normal: (3,), out of the contact link into the other side; its
/// length does not matter. against: the other link; None: the ground. toward: (link, point), instead of normal: the
/// normal points from the contact towards that point (m, in that link's frame). normal_frame: "link": the normal turns
/// with the contact link; "world"; "against". turning: True if the line of toward may turn: a spring, a damper, a rod.
/// cable: True if the line of toward is a cable, which resists lengthening; without against, the other side is its link.
/// Contact.about_axis creates a contact by a moment about an axis.
///
///     >>> contact = percuss.Contact("coupler", point=[0.35, 0.1, 0.0], normal=[0.0, 1.0, 0.0])
#[pyclass(frozen, eq, module = "percuss")]
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// The contact link.
    #[pyo3(get)]
    pub link: String,
    /// The other link; None: the ground.
    #[pyo3(get)]
    pub against: Option<String>,
    point: [f64; 3],
    normal: NormalGiven,
}

#[derive(Clone, Debug, PartialEq)]
enum NormalGiven {
    Along([f64; 3], Frame),
    Toward(String, [f64; 3]),
    /// Toward a point, along a line that may turn.
    TurningToward(String, [f64; 3]),
    /// Away from a point, along a line that may turn: a cable.
    TurningAwayFrom(String, [f64; 3]),
    /// Axis of a moment.
    About([f64; 3], Frame),
}

/// Parses a frame name.
pub fn frame(name: &str, what: &str) -> PyResult<Frame> {
    match name {
        "link" => Ok(Frame::Link),
        "world" => Ok(Frame::World),
        "against" => Ok(Frame::Against),
        _ => Err(input(format_args!("{what} is \"{name}\"; expected \"link\", \"world\" or \"against\""))),
    }
}

/// Name of a frame in Python.
fn name(frame: Frame) -> &'static str {
    match frame {
        Frame::Link => "link",
        Frame::World => "world",
        Frame::Against => "against",
    }
}

#[pymethods]
impl Contact {
    #[new]
    #[pyo3(signature = (link, point, normal=None, *, against=None, toward=None, normal_frame=None, turning=None, cable=None), text_signature = "(link, point, normal=None, *, against=None, toward=None, normal_frame='link', turning=False, cable=False)")]
    #[allow(clippy::too_many_arguments, reason = "the description of a contact")]
    fn new(
        link: &Bound<'_, PyAny>,
        point: &Bound<'_, PyAny>,
        normal: Option<&Bound<'_, PyAny>>,
        against: Option<&Bound<'_, PyAny>>,
        toward: Option<&Bound<'_, PyAny>>,
        normal_frame: Option<&Bound<'_, PyAny>>,
        turning: Option<&Bound<'_, PyAny>>,
        cable: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let link = extract(link, "link")?;
        let mut against: Option<String> = against.map(|given| extract(given, "against")).transpose()?;
        let toward: Option<(String, Bound<'_, PyAny>)> =
            toward.map(|given| extract(given, "toward")).transpose()?;
        let normal_frame: String =
            normal_frame.map_or_else(|| Ok("link".to_owned()), |given| extract(given, "normal_frame"))?;
        let turning = turning.map_or(Ok(false), |given| extract(given, "turning"))?;
        let cable = cable.map_or(Ok(false), |given| extract(given, "cable"))?;
        if cable && turning {
            return Err(input("give one of cable and turning: the line of a cable always turns"));
        }
        let normal = match (normal, toward) {
            (Some(_), None) if cable => {
                return Err(input("cable needs toward: a given normal is no line to a point"));
            }
            (Some(_), None) if turning => {
                return Err(input("turning needs toward: a given normal does not turn with a line"));
            }
            (Some(normal), None) => {
                NormalGiven::Along(triple(normal, "normal")?, frame(&normal_frame, "normal_frame")?)
            }
            (None, Some((link, point))) => {
                let point = triple(&point, "point of toward")?;
                if cable {
                    against.get_or_insert_with(|| link.clone());
                    NormalGiven::TurningAwayFrom(link, point)
                } else if turning {
                    NormalGiven::TurningToward(link, point)
                } else {
                    NormalGiven::Toward(link, point)
                }
            }
            _ => return Err(input("give one of normal and toward")),
        };
        Ok(Self { link, against, point: triple(point, "point")?, normal })
    }

    /// about_axis(link, axis, *, against=None, axis_frame="link")
    /// --
    ///
    /// Contact by a moment about an axis (a couple), such as a rotational stop: effective masses are inertias in kg·m²; the units of
    /// speeds, impulses and forces are rad/s, N·m·s and N·m.
    ///
    /// axis: (3,), its length does not matter. axis_frame: "link", "world" or "against".
    #[staticmethod]
    #[pyo3(signature = (link, axis, *, against=None, axis_frame=None), text_signature = "(link, axis, *, against=None, axis_frame='link')")]
    fn about_axis(
        link: &Bound<'_, PyAny>,
        axis: &Bound<'_, PyAny>,
        against: Option<&Bound<'_, PyAny>>,
        axis_frame: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let link = extract(link, "link")?;
        let against: Option<String> = against.map(|given| extract(given, "against")).transpose()?;
        let axis_frame: String =
            axis_frame.map_or_else(|| Ok("link".to_owned()), |given| extract(given, "axis_frame"))?;
        let normal = NormalGiven::About(triple(axis, "axis")?, frame(&axis_frame, "axis_frame")?);
        Ok(Self { link, against, point: [0.0; 3], normal })
    }

    /// The axis of a moment as given; None for other contacts.
    #[getter]
    fn axis(&self) -> Option<(f64, f64, f64)> {
        match &self.normal {
            NormalGiven::About(axis, _) => Some((*axis).into()),
            _ => None,
        }
    }

    /// The contact point in the contact link's frame, m.
    #[getter]
    fn point(&self) -> (f64, f64, f64) {
        self.point.into()
    }

    /// The normal as given; None if toward is given, and for a moment.
    #[getter]
    fn normal(&self) -> Option<(f64, f64, f64)> {
        match &self.normal {
            NormalGiven::Along(normal, _) => Some((*normal).into()),
            NormalGiven::About(..)
            | NormalGiven::Toward(..)
            | NormalGiven::TurningToward(..)
            | NormalGiven::TurningAwayFrom(..) => None,
        }
    }

    /// The link and the point (m, its frame) that the normal points to; None if normal is given, and for a moment.
    #[getter]
    fn toward(&self) -> Option<(String, (f64, f64, f64))> {
        match &self.normal {
            NormalGiven::Along(..) | NormalGiven::About(..) => None,
            NormalGiven::Toward(link, point)
            | NormalGiven::TurningToward(link, point)
            | NormalGiven::TurningAwayFrom(link, point) => Some((link.clone(), (*point).into())),
        }
    }

    /// True if the line of toward may turn: a spring, a damper, a rod.
    #[getter]
    fn turning(&self) -> bool {
        matches!(self.normal, NormalGiven::TurningToward(..))
    }

    /// True if the line of toward is a cable, which resists lengthening.
    #[getter]
    fn cable(&self) -> bool {
        matches!(self.normal, NormalGiven::TurningAwayFrom(..))
    }

    /// Frame of the normal or the axis: "link", "world" or "against".
    #[getter]
    fn normal_frame(&self) -> &'static str {
        match &self.normal {
            NormalGiven::Along(_, frame) | NormalGiven::About(_, frame) => name(*frame),
            NormalGiven::Toward(..) | NormalGiven::TurningToward(..) | NormalGiven::TurningAwayFrom(..) => {
                name(Frame::Link)
            }
        }
    }

    /// Arguments for the constructor, so that contacts can be sent to other processes.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let py = slf.py();
        let contact = slf.get();
        let package = py.import("percuss")?;
        let arguments = (
            contact.link.clone(),
            contact.point(),
            contact.normal(),
            contact.against.clone(),
            contact.toward(),
            contact.normal_frame(),
            contact.turning(),
            contact.cable(),
            contact.axis(),
        );
        Ok((package.getattr("_contact")?, arguments.into_pyobject(py)?.into_any()))
    }

    fn __repr__(&self) -> String {
        let against = self.against.as_ref().map_or_else(String::new, |link| format!(", against=\"{link}\""));
        if let NormalGiven::About(axis, of) = &self.normal {
            let frame = match of {
                Frame::Link => String::new(),
                other => format!(", axis_frame=\"{}\"", name(*other)),
            };
            return format!("Contact.about_axis(\"{}\", axis={axis:?}{frame}{against})", self.link);
        }
        let normal = match &self.normal {
            NormalGiven::About(..) => String::new(),
            NormalGiven::Along(normal, Frame::Link) => format!("normal={normal:?}"),
            NormalGiven::Along(normal, frame) => {
                format!("normal={normal:?}, normal_frame=\"{}\"", name(*frame))
            }
            NormalGiven::Toward(link, point) => format!("toward=(\"{link}\", {point:?})"),
            NormalGiven::TurningToward(link, point) => {
                format!("toward=(\"{link}\", {point:?}), turning=True")
            }
            NormalGiven::TurningAwayFrom(link, point) => {
                format!("toward=(\"{link}\", {point:?}), cable=True")
            }
        };
        format!("Contact(\"{}\", point={:?}, {normal}{against})", self.link, self.point)
    }
}

/// Contact of a question: a `percuss.Contact`, or the name of a contact of the model.
pub enum GivenContact<'py> {
    /// Name of a contact of the model, or a contact as text.
    Named(String),
    /// Contact by link, point and normal.
    Contact(Bound<'py, Contact>),
}

impl<'py> FromPyObject<'_, 'py> for GivenContact<'py> {
    type Error = PyErr;
    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(contact) = given.cast::<Contact>() {
            return Ok(Self::Contact(contact.to_owned()));
        }
        given.extract().map(Self::Named).map_err(|_: PyErr| {
            let kind = given.get_type().name();
            PyTypeError::new_err(match kind {
                Ok(kind) => format!(
                    "{kind} is no contact; expected a Contact, or the name of a contact (Model.contacts)"
                ),
                Err(error) => error.to_string(),
            })
        })
    }
}

impl GivenContact<'_> {
    /// Resolves the names of links, or of the contact, in a mechanism.
    pub fn resolve(&self, mechanism: &Mechanism) -> PyResult<Resolved> {
        match self {
            Self::Contact(contact) => contact.get().resolve(mechanism),
            Self::Named(name) => {
                contact_of_text(mechanism, name).map_err(|error| of_argument("contact")(errors::study(error)))
            }
        }
    }
}

impl Contact {
    /// Contact with the links by name.
    pub fn of_resolved(mechanism: &Mechanism, contact: &Resolved) -> Self {
        let name = |link| mechanism.link(link).name().to_owned();
        let normal = match contact.normal {
            Direction::Along(normal, frame) => NormalGiven::Along(normal.into(), frame),
            Direction::About(axis, frame) => NormalGiven::About(axis.into(), frame),
            Direction::Toward(link, point) => NormalGiven::Toward(name(link), point.into()),
            Direction::TurningToward(link, point) => NormalGiven::TurningToward(name(link), point.into()),
            Direction::TurningAwayFrom(link, point) => NormalGiven::TurningAwayFrom(name(link), point.into()),
        };
        let (link, against) = (name(contact.link), contact.against.map(name));
        Self { link, against, point: contact.point.into(), normal }
    }

    /// Resolves the link names in a mechanism.
    pub fn resolve(&self, mechanism: &Mechanism) -> PyResult<Resolved> {
        let find = |name: &str, part: &str| {
            mechanism.find_link(name).map_err(|error| of_argument(part)(input(error)))
        };
        let normal = match &self.normal {
            NormalGiven::Along(normal, frame) => Direction::Along(Vector3::from(*normal), *frame),
            NormalGiven::About(axis, frame) => Direction::About(Vector3::from(*axis), *frame),
            NormalGiven::Toward(link, point) => {
                Direction::Toward(find(link, "contact.toward")?, Vector3::from(*point))
            }
            NormalGiven::TurningToward(link, point) => {
                Direction::TurningToward(find(link, "contact.toward")?, Vector3::from(*point))
            }
            NormalGiven::TurningAwayFrom(link, point) => {
                Direction::TurningAwayFrom(find(link, "contact.toward")?, Vector3::from(*point))
            }
        };
        Ok(Resolved {
            link: find(&self.link, "contact.link")?,
            against: self.against.as_deref().map(|name| find(name, "contact.against")).transpose()?,
            point: self.point.into(),
            normal,
        })
    }
}
