//! Flags of the contact, its pose and its conditions.

use crate::terminal::failure::Failure;
use clap::Args;
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::headings::{CONDITIONS, POSE};
use percuss_study::{
    ConditionsTable, ContactTable, GivenTravel, Hold, MassQuestion, Names, PoseTable, Vary, WheelMotion,
};
use std::path::Path;

/// Flags of the contact, its pose and its conditions, shared by several commands.
#[derive(Debug, Args)]
pub struct ContactArgs {
    #[command(flatten)]
    pub contact: ContactTable,
    #[command(flatten)]
    pub pose: PoseTable,
    /// Upward travel of the wheel: a length, or in a sweep FROM:TO:COUNT.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true, help_heading = POSE)]
    pub wheel_travel: Option<String>,
    /// Equal upward travel of both wheels.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true, help_heading = POSE)]
    pub heave: Option<String>,
    /// Opposite travel: the left wheel up, the right wheel down.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true, help_heading = POSE)]
    pub roll: Option<String>,
    /// Position of a sliding rack: a length, or in a sweep FROM:TO:COUNT.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true, help_heading = POSE)]
    pub steer: Option<String>,
    #[command(flatten)]
    pub conditions: ConditionsTable,
    /// Fix a point of a link (m, link frame) to the ground: along a normal (world axes, out of the link), or in all
    /// directions.
    #[arg(long, value_name = "LINK:X,Y,Z[:NX,NY,NZ]", help_heading = CONDITIONS)]
    pub hold: Vec<Hold>,
}

/// Joint of the rack of an imported suspension.
const RACK: &str = "rack";

impl ContactArgs {
    /// True if a flag of the contact, its pose or its conditions is given.
    pub fn is_given(&self) -> bool {
        self.contact != ContactTable::default()
            || self.pose != PoseTable::default()
            || self.conditions != ConditionsTable::default()
            || self.wheel_motions().next().is_some()
            || self.steer.is_some()
            || !self.hold.is_empty()
    }

    /// Refuses a missing or incomplete contact.
    pub fn require(&self) -> Result<(), Failure> {
        if self.contact.missing().is_none() {
            return Ok(());
        }
        Err(Failure::bad_input(
            "a contact of the model is required: --at NAME; or --link LINK, --point X,Y,Z, and --normal X,Y,Z or --along-line LINK:X,Y,Z",
        ))
    }

    /// Converts the flags to a question about one pose.
    pub fn question(&self) -> Result<MassQuestion, Failure> {
        if let Some(range) = self.ranges()?.first() {
            return Err(Failure::bad_input(format!(
                "--{}: a range FROM:TO:COUNT is for percuss sweep; give one length",
                range.name()
            )));
        }
        self.question_of_rows()
    }

    /// Converts the flags to a question whose rows are given apart; ranges are left out.
    pub fn question_of_rows(&self) -> Result<MassQuestion, Failure> {
        self.require()?;
        self.conditions()
    }

    /// Motions of the wheels with their flags.
    fn wheel_motions(&self) -> impl Iterator<Item = (WheelMotion, &String)> {
        let given = [
            (WheelMotion::WheelTravel, &self.wheel_travel),
            (WheelMotion::Heave, &self.heave),
            (WheelMotion::Roll, &self.roll),
        ];
        given.into_iter().filter_map(|(motion, text)| Some((motion, text.as_ref()?)))
    }

    /// Ranges given by --steer, --wheel-travel, --heave and --roll. A travel starts from the positions of the joints, so the
    /// rack is first.
    pub fn ranges(&self) -> Result<Vec<Vary>, Failure> {
        let steer = self.steer.iter().map(|text| ("steer", RACK, text));
        let motions = self.wheel_motions().map(|(motion, text)| (motion.name(), motion.name(), text));
        let ranges = steer.chain(motions).filter(|(.., text)| text.contains(':'));
        let range = |(flag, varied, text): (&str, &str, &String)| {
            Vary::parse(&format!("{varied}={text}"))
                .map_err(|error| Failure::bad_input(format!("--{flag}: {error}")))
        };
        ranges.map(range).collect()
    }

    /// Travels given by --wheel-travel, --heave and --roll.
    fn wheel_travels(&self) -> Result<Vec<GivenTravel>, Failure> {
        let lengths = self.wheel_motions().filter(|(_, text)| !text.contains(':'));
        let travel = |(motion, text): (WheelMotion, &String)| {
            GivenTravel::parse(&format!("{}={text}", motion.name()))
                .map_err(|error| Failure::bad_input(format!("--{}: {error}", motion.name())))
        };
        lengths.map(travel).collect()
    }

    /// Converts the flags to a question; link, point and normal may be missing.
    pub fn conditions(&self) -> Result<MassQuestion, Failure> {
        let Self { contact, pose, conditions, hold, .. } = self;
        let question = MassQuestion::of_tables(contact, pose, conditions, hold, Names::Flags);
        let mut question = question.checked(Path::new(""), DEFAULT_MAX_SIZE)?;
        if let Some(text) = self.steer.as_ref().filter(|text| !text.contains(':')) {
            let position = text.parse().map_err(|error| Failure::bad_input(format!("--steer: {error}")))?;
            question.pose.set.push((RACK.to_owned(), position));
        }
        question.pose.travel.extend(self.wheel_travels()?);
        Ok(question)
    }
}
