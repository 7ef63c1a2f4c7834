//! Flags of the contact and of its conditions.

use super::headings::{ADDITIONAL, CONDITIONS, CONTACT, POSE};
use super::value_parsers::{
    armature, edge, estimate, hold, kilograms, line, normal, point, position, ratio_at, travel,
};
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_dynamics::{Base, Frame};
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::{
    EstimateQuestion, GivenPose, GivenPosition, GivenTravel, Hold, MassQuestion, Moved, Names, Normal,
    RatioPoint, Vary, WheelMotion,
};

/// Frame of the contact point and the normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FrameArg {
    /// Frame of the contact link.
    Link,
    /// Frame of the root link at its reference pose.
    World,
    /// Frame of the other link.
    Against,
}

impl From<FrameArg> for Frame {
    fn from(frame: FrameArg) -> Self {
        match frame {
            FrameArg::Link => Frame::Link,
            FrameArg::World => Frame::World,
            FrameArg::Against => Frame::Against,
        }
    }
}

/// Motion of the root link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BaseArg {
    /// Fixed to the ground.
    Fixed,
    /// Free to move.
    Floating,
}

/// Flags of the contact and its conditions, shared by several commands.
#[derive(Debug, Args)]
pub struct ContactArgs {
    /// Named contact of the model, such as bump_stop; a stop is brought to the touch. mass --at all: a table.
    ///
    /// Suspension sheets name their stops, spring and damper seats and contact patches; a URDF does so by <contact>. The
    /// mechanism moves until the gap of a stop is closed, unless --travel or --pose gives the pose. On a vehicle with
    /// both sides, both stops touch.
    #[arg(
        long,
        value_name = "NAME",
        conflicts_with_all = ["link", "point", "normal", "along_line", "normal_frame", "against"],
        help_heading = CONTACT
    )]
    pub at: Option<String>,
    /// Contact link.
    #[arg(long, value_name = "LINK", help_heading = CONTACT)]
    pub link: Option<String>,
    /// Contact point (m).
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point, help_heading = CONTACT)]
    pub point: Option<[f64; 3]>,
    /// Contact normal, out of the contact link.
    ///
    /// The normal points into the other body. Its length and its sign do not affect the effective mass.
    #[arg(
        long,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        value_parser = normal,
        conflicts_with = "along_line",
        help_heading = CONTACT
    )]
    pub normal: Option<[f64; 3]>,
    /// Instead of --normal: towards a point of a link.
    ///
    /// The normal points from the contact point towards this point of a link (m, in the frame of that link). Use it
    /// for the line of a spring, or for a stop near the design pose. For a stop over a travel, use --normal.
    #[arg(long, value_name = "LINK:X,Y,Z", value_parser = line, help_heading = CONTACT)]
    pub along_line: Option<(String, [f64; 3])>,
    /// Allow the line of --along-line to rotate: a spring, a damper or a rod.
    ///
    /// Without this flag, a pose is refused if the line has rotated by more than 5° relative to the other body since
    /// the design pose (all joints at 0), because the line is then no longer the normal of a stop. A line shorter
    /// than a tenth of its length in the design pose is always refused.
    #[arg(long, requires = "along_line", help_heading = CONTACT)]
    pub turning_normal: bool,
    /// Frame of the point and the normal.
    ///
    /// Applies to both. A point given in another frame is converted to the link frame once, at the --set pose with
    /// all varied joints at 0, and then moves with the link. A normal stays constant in the given frame.
    #[arg(long, value_enum, default_value_t = FrameArg::Link, help_heading = CONTACT)]
    pub frame: FrameArg,
    /// Frame of the normal, if different from the frame of the point.
    #[arg(long, value_enum, help_heading = CONTACT)]
    pub normal_frame: Option<FrameArg>,
    /// Other link in contact; default: the ground.
    #[arg(long, value_name = "LINK", help_heading = CONTACT)]
    pub against: Option<String>,
    /// Mass (kg) of a free body as the other side of the contact.
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = kilograms,
        conflicts_with = "against",
        help_heading = CONTACT
    )]
    pub against_mass: Option<f64>,
    /// Position of a driving joint (m, rad; 30deg, 5mm).
    ///
    /// Driving joints without --set are at 0. Spherical: w,x,y,z; planar: x,y,angle; floating: x,y,z,w,x,y,z.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = position, help_heading = POSE)]
    pub set: Vec<(String, GivenPosition)>,
    /// Initial guess of a joint that depends on other joints through loops; selects the assembly mode.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = position, help_heading = POSE)]
    pub guess: Vec<(String, GivenPosition)>,
    /// Move the mechanism until a point has this travel.
    ///
    /// The point of a link (m, link frame) moves by DISTANCE along a direction (world axes) from its position in the
    /// --set pose, as with sweep --vary travel. Give the flag once for each driven point.
    #[arg(long, value_name = "LINK:X,Y,Z:DX,DY,DZ=DISTANCE", value_parser = travel, help_heading = POSE)]
    pub travel: Vec<GivenTravel>,
    /// Upward travel of the wheel: a length, or in a sweep FROM:TO:COUNT.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true, help_heading = POSE)]
    pub wheel_travel: Option<String>,
    /// Equal upward travel of both wheels.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true, help_heading = POSE)]
    pub heave: Option<String>,
    /// Opposite travel: the left wheel up, the right wheel down.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true, help_heading = POSE)]
    pub roll: Option<String>,
    /// Position of the rack of a suspension with a sliding rack; short for --set rack=DISTANCE.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true, help_heading = POSE)]
    pub steer: Option<String>,
    /// Complete configuration: output of --format json, or JSON with a position for each joint. --set and --guess
    /// override it.
    #[arg(long, value_name = "FILE.json", help_heading = POSE)]
    pub pose: Option<String>,
    /// Lock a joint at its position.
    #[arg(long, value_name = "JOINT", help_heading = CONDITIONS)]
    pub lock: Vec<String>,
    /// Fix a point of a link (m, link frame) to the ground: along a normal (world axes, out of the link), or in all
    /// directions.
    #[arg(long, value_name = "LINK:X,Y,Z[:NX,NY,NZ]", value_parser = hold, help_heading = CONDITIONS)]
    pub hold: Vec<Hold>,
    /// Rotor inertia reflected to a joint (kg·m² or kg): one value, or one value per velocity, separated by commas.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = armature, help_heading = CONDITIONS)]
    pub armature: Vec<(String, Vec<f64>)>,
    /// Root link fixed or floating.
    #[arg(long, value_enum, default_value_t = BaseArg::Fixed, help_heading = CONDITIONS)]
    pub base: BaseArg,
    /// Classical estimate, shown with the result.
    ///
    /// The total mass of these links is reduced to the contact by the motion ratio of point A (m, frame of the first
    /// link; default: its origin). The ratio uses the full speed of A, or its component along a direction (world
    /// axes).
    #[arg(long, value_name = "LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]]", value_parser = estimate, help_heading = ADDITIONAL)]
    pub estimate: Option<EstimateQuestion>,
    /// Motion ratio at this point (m, link frame), along a direction (world axes; default z).
    ///
    /// The ratio relates the speed of the point to the closing speed of the contact. If the model has a wheel and one
    /// degree of freedom, the ratios of the wheel centre and the contact patch are always shown.
    #[arg(long, value_name = "LINK:X,Y,Z[:DX,DY,DZ]", value_parser = ratio_at, help_heading = ADDITIONAL)]
    pub ratio_at: Vec<RatioPoint>,
}

impl ContactArgs {
    /// The contact, or an error if the contact is missing or incomplete; for commands in which clap does not require
    /// it.
    pub fn require(given: Option<&Self>) -> Result<&Self, Failure> {
        let whole = |c: &&Self| {
            let has_normal = c.normal.is_some() || c.along_line.is_some();
            c.at.is_some() || c.link.is_some() && c.point.is_some() && has_normal
        };
        given.filter(whole).ok_or_else(|| {
            Failure::bad_input(
                "a contact of the model is required: --at NAME; or --link LINK, --point X,Y,Z, and --normal X,Y,Z or --along-line LINK:X,Y,Z",
            )
        })
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
        Self::require(Some(self))?.conditions()
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

    /// Ranges given by --wheel-travel, --heave and --roll.
    pub fn ranges(&self) -> Result<Vec<Vary>, Failure> {
        let ranges = self.wheel_motions().filter(|(_, text)| text.contains(':'));
        let range = |(motion, text): (WheelMotion, &String)| {
            Vary::parse(&format!("{}={text}", motion.name()))
                .map_err(|error| Failure::bad_input(format!("--{}: {error}", motion.name())))
        };
        ranges.map(range).collect()
    }

    /// Travels given by --wheel-travel, --heave and --roll.
    fn wheel_travels(&self) -> Result<Vec<GivenTravel>, Failure> {
        let lengths = self.wheel_motions().filter(|(_, text)| !text.contains(':'));
        let travel = |(motion, text): (WheelMotion, &String)| {
            let distance =
                edge(text).map_err(|error| Failure::bad_input(format!("--{}: {error}", motion.name())))?;
            Ok(GivenTravel { moved: Moved::Wheels(motion), distance })
        };
        lengths.map(travel).collect()
    }

    /// Converts the flags to a question; link, point and normal may be missing.
    pub fn conditions(&self) -> Result<MassQuestion, Failure> {
        let normal = match (&self.along_line, self.normal) {
            (Some((link, point)), _) if self.turning_normal => Normal::TurningToward(link.clone(), *point),
            (Some((link, point)), _) => Normal::Toward(link.clone(), *point),
            // `question` has checked that one of the two is present.
            (None, normal) => Normal::Along(normal.unwrap_or_default()),
        };
        let rack = |text: &String| {
            GivenPosition::parse(text)
                .map(|position| ("rack".to_owned(), position))
                .map_err(|error| Failure::bad_input(format!("--steer: {error}")))
        };
        let steer = self.steer.as_ref().map(rack).transpose()?;
        let pose = |path: &String| {
            GivenPose::read(path, DEFAULT_MAX_SIZE).map_err(|e| Failure::bad_input(format!("--pose: {e}")))
        };
        Ok(MassQuestion {
            at: self.at.clone(),
            // `question` has checked that link and point are present, or `at`.
            link: self.link.clone().unwrap_or_default(),
            point: self.point.unwrap_or_default(),
            normal,
            frame: self.frame.into(),
            normal_frame: self.normal_frame.unwrap_or(self.frame).into(),
            against: self.against.clone(),
            against_mass: self.against_mass,
            set: self.set.iter().cloned().chain(steer).collect(),
            guess: self.guess.clone(),
            pose: self.pose.as_ref().map(pose).transpose()?,
            travel: self.travel.iter().cloned().chain(self.wheel_travels()?).collect(),
            lock: self.lock.clone(),
            hold: self.hold.clone(),
            armature: self.armature.clone(),
            base: match self.base {
                BaseArg::Fixed => Base::Fixed,
                BaseArg::Floating => Base::Floating,
            },
            estimate: self.estimate.clone(),
            ratio_at: self.ratio_at.clone(),
            names: Names::Flags,
        })
    }
}
