//! Requests of the page. The tables are those of a study file.

use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::{
    ConditionsTable, ContactTable, DampingQuestion, Hold, ImpactQuestion, MassQuestion, ModelTable, Names,
    PoseTable, SafeSpeedQuestion,
};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// Request of the page.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Request {
    /// Reads a model and returns its scene, its named contacts and a first contact with a result.
    Open {
        /// Table of the model with its file name.
        model: ModelTable,
        /// Text of the file.
        text: String,
        /// Further files to which the model may refer, in base64 by path. The paths and the path of the model refer to the same folder.
        #[serde(default)]
        files: BTreeMap<String, String>,
        /// True if the reply must contain the shapes of the links.
        #[serde(default)]
        shapes: bool,
    },
    /// Result at a pose with the frames of the links.
    Show {
        /// Question.
        question: QuestionRequest,
    },
    /// m̄ over a range.
    Curve {
        /// Question.
        question: QuestionRequest,
        /// Range, as in `percuss sweep --vary`.
        vary: String,
    },
    /// Results at all named contacts, under the conditions and the pose of a question.
    Contacts {
        /// Question; its contact is not evaluated.
        question: QuestionRequest,
    },
    /// Sensitivities of m̄ to hardpoints, masses and centres of mass.
    Explain {
        /// Question.
        question: QuestionRequest,
    },
    /// Search for the coordinate of a hardpoint, or for the mass of a link, at which m̄ has a required value.
    Solve {
        /// Question.
        question: QuestionRequest,
        /// `POINT.AXIS` with an axis of the sheet, or `LINK.mass`.
        unknown: String,
        /// Required m̄, kg.
        mass: f64,
        /// Largest change of a coordinate, m; a mass changes by at most half.
        within: f64,
    },
    /// Damper for a restitution, and the parameters of simulators.
    Damp {
        /// Question; the contact is ignored if `damping` names a joint stop.
        question: QuestionRequest,
        /// Table of the damper.
        damping: DampingQuestion,
    },
    /// Rigid impact with the reactions of the joints.
    Impact {
        /// Question.
        question: QuestionRequest,
        /// Table of the impact.
        impact: ImpactQuestion,
    },
    /// Safe speed of a contact with a person.
    SafeSpeed {
        /// Question.
        question: QuestionRequest,
        /// Table of the limit.
        safe_speed: SafeSpeedQuestion,
    },
    /// Angles, motion ratios and further kinematics of the wheels.
    Kinematics {
        /// Table of the model with its changes.
        model: ModelTable,
        /// Values of `wheel-travel`, `heave`, `roll` and `steer`, m.
        #[serde(default)]
        state: BTreeMap<String, f64>,
        /// Variable of the rows and its values, m; without it, one row.
        #[serde(default)]
        range: Option<(String, Vec<f64>)>,
    },
    /// m̄ of many contacts of a link, for a map of its surface.
    Map {
        /// Question; its contact is not evaluated.
        question: QuestionRequest,
        /// Link.
        link: String,
        /// Points and outward normals, frame of the link: six numbers a contact, m and 1.
        contacts: Vec<[f64; 6]>,
    },
    /// Principal directions of m̄ at the contact point.
    Directions {
        /// Question.
        question: QuestionRequest,
    },
    /// Text of the sheet with the moves of the model.
    Sheet {
        /// Table of the model with its moves.
        model: ModelTable,
    },
}

/// Question with the tables of a study file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuestionRequest {
    /// Model with its changes.
    pub model: ModelTable,
    /// Contact.
    #[serde(default)]
    contact: ContactTable,
    /// Pose.
    #[serde(default)]
    pose: PoseTable,
    /// Conditions.
    #[serde(default)]
    conditions: ConditionsTable,
    /// Held points.
    #[serde(default)]
    hold: Vec<Hold>,
}

impl QuestionRequest {
    /// Converts the tables to a question.
    ///
    /// # Errors
    /// Message: keys that exclude each other, an incomplete contact, or a file of positions.
    pub fn question(&self) -> Result<MassQuestion, String> {
        if let Some(part) = self.contact.missing() {
            return Err(format!("contact: {part} is missing"));
        }
        self.with_contact(&self.contact)
    }

    /// Question without a contact: pose, conditions and held points.
    ///
    /// # Errors
    /// Message: keys that exclude each other, or a file of positions.
    pub fn conditions(&self) -> Result<MassQuestion, String> {
        self.with_contact(&ContactTable::default())
    }

    /// Combines the pose, conditions and held points of the request with the given contact.
    fn with_contact(&self, contact: &ContactTable) -> Result<MassQuestion, String> {
        let Self { pose, conditions, hold, .. } = self;
        let question = MassQuestion::of_tables(contact, pose, conditions, hold, Names::KEYS);
        question.checked(Path::new(""), DEFAULT_MAX_SIZE).map_err(|error| error.message(Names::KEYS))
    }
}
