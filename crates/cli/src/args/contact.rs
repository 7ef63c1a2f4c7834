//! The contact and its conditions.

use super::headings::{BESIDE, CONDITIONS, CONTACT, POSE};
use super::words::{armature, estimate, hold, kilograms, line, normal, point, position, ratio_at, travel};
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_dynamics::{Base, Frame};
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::{
    EstimateQuestion, GivenPose, GivenPosition, GivenTravel, Hold, MassQuestion, Names, Normal, RatioPoint,
};

/// The frame of point and normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FrameArg {
    /// The struck link's.
    Link,
    /// The root link's at its reference pose.
    World,
    /// The other link's.
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

/// Whether the root link is fixed or moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BaseArg {
    /// It is the ground.
    Fixed,
    /// It moves freely.
    Floating,
}

/// The contact and the conditions: what `percuss mass` and `percuss sweep` share.
#[derive(Debug, Args)]
pub struct ContactArgs {
    /// The struck link.
    #[arg(long, value_name = "LINK", help_heading = CONTACT)]
    pub link: Option<String>,
    /// The contact point (m).
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point, help_heading = CONTACT)]
    pub point: Option<[f64; 3]>,
    /// The normal, out of the struck link.
    ///
    /// It points into the other side; neither its length nor its sign matters.
    #[arg(
        long,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        value_parser = normal,
        conflicts_with = "along_line",
        help_heading = CONTACT
    )]
    pub normal: Option<[f64; 3]>,
    /// Or the normal towards a point of a link.
    ///
    /// The normal points from the contact point towards this point (m) of a link, in that link's frame: the line of a spring, or
    /// of a stop near the drawing. For a stop over a travel, give --normal.
    #[arg(long, value_name = "LINK:X,Y,Z", value_parser = line, help_heading = CONTACT)]
    pub along_line: Option<(String, [f64; 3])>,
    /// Lets the line of --along-line turn: a spring, a damper or a rod.
    ///
    /// Without this a pose is refused where the line has turned by more than 5° from the line as drawn (all joints at 0, seen
    /// from the other side): it is no longer the normal of a stop. A line shorter than a tenth of the line as drawn is refused
    /// in any case.
    #[arg(long, requires = "along_line", help_heading = CONTACT)]
    pub turning_normal: bool,
    /// In which frame the point and the normal are given.
    ///
    /// Both are. A point in another frame than the link's is converted once, at the pose of --set with what is varied at 0,
    /// and moves with the link; a normal keeps its axes.
    #[arg(long, value_enum, default_value_t = FrameArg::Link, help_heading = CONTACT)]
    pub frame: FrameArg,
    /// The frame of the normal, where it differs from that of the point.
    #[arg(long, value_enum, help_heading = CONTACT)]
    pub normal_frame: Option<FrameArg>,
    /// The other link; the ground if none is given.
    #[arg(long, value_name = "LINK", help_heading = CONTACT)]
    pub against: Option<String>,
    /// A free body of this mass (kg) on the other side.
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = kilograms,
        conflicts_with = "against",
        help_heading = CONTACT
    )]
    pub against_mass: Option<f64>,
    /// Sets a driving joint (m, rad; 30deg, 5mm).
    ///
    /// The others stand at 0. Spherical: w,x,y,z; planar: x,y,angle; floating: x,y,z,w,x,y,z.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = position, help_heading = POSE)]
    pub set: Vec<(String, GivenPosition)>,
    /// First guess of a joint that depends on others through loops: selects the assembly mode.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = position, help_heading = POSE)]
    pub guess: Vec<(String, GivenPosition)>,
    /// Drives the pose until a point is displaced so far.
    ///
    /// The point (m, link's frame) of a link is displaced by so much along a direction (world axes) from where --set puts it,
    /// as sweep --vary does; once for each point that is driven.
    #[arg(long, value_name = "LINK:X,Y,Z:DX,DY,DZ=DISTANCE", value_parser = travel, help_heading = POSE)]
    pub travel: Vec<GivenTravel>,
    /// A whole configuration: what --format json wrote, or JSON with a position for each joint; --set and --guess go over it.
    #[arg(long, value_name = "FILE.json", help_heading = POSE)]
    pub pose: Option<String>,
    /// Holds a joint where it stands.
    #[arg(long, value_name = "JOINT", help_heading = CONDITIONS)]
    pub lock: Vec<String>,
    /// Holds a point (m, link's frame) of a link to the ground: along a normal (world axes, out of the link), or in all
    /// directions.
    #[arg(long, value_name = "LINK:X,Y,Z[:NX,NY,NZ]", value_parser = hold, help_heading = CONDITIONS)]
    pub hold: Vec<Hold>,
    /// Rotor inertia reflected to a joint (kg·m² or kg): one value, or one for each velocity between commas.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = armature, help_heading = CONDITIONS)]
    pub armature: Vec<(String, Vec<f64>)>,
    /// Whether the root link is fixed or moves.
    #[arg(long, value_enum, default_value_t = BaseArg::Fixed, help_heading = CONDITIONS)]
    pub base: BaseArg,
    /// The classical estimate next to the result.
    ///
    /// The mass of these links, moved with point A (m, first link's frame; default its origin), by A's full speed or its
    /// component along a direction (world axes).
    #[arg(long, value_name = "LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]]", value_parser = estimate, help_heading = BESIDE)]
    pub estimate: Option<EstimateQuestion>,
    /// The motion ratio at this point (m, link's frame), along a direction (world axes; default z).
    ///
    /// Its speed beside the contact's. The wheel's centre and contact patch are shown where the model has them and one travel.
    #[arg(long, value_name = "LINK:X,Y,Z[:DX,DY,DZ]", value_parser = ratio_at, help_heading = BESIDE)]
    pub ratio_at: Vec<RatioPoint>,
}

impl ContactArgs {
    /// The contact where one is needed and clap does not require it.
    pub fn needed(given: Option<&Self>) -> Result<&Self, Failure> {
        let whole = |c: &&Self| {
            c.link.is_some() && c.point.is_some() && (c.normal.is_some() || c.along_line.is_some())
        };
        given.filter(whole).ok_or_else(|| {
            Failure::bad_input(
                "a contact of the model is required: --link LINK, --point X,Y,Z, and --normal X,Y,Z or --along-line LINK:X,Y,Z",
            )
        })
    }

    /// As a question.
    pub fn question(&self) -> Result<MassQuestion, Failure> {
        Self::needed(Some(self))?.conditions()
    }

    /// As a question whose contact may be missing.
    pub fn conditions(&self) -> Result<MassQuestion, Failure> {
        let normal = match (&self.along_line, self.normal) {
            (Some((link, point)), _) if self.turning_normal => Normal::TurningToward(link.clone(), *point),
            (Some((link, point)), _) => Normal::Toward(link.clone(), *point),
            // `question` requires one of them.
            (None, normal) => Normal::Along(normal.unwrap_or_default()),
        };
        let pose = |path: &String| {
            GivenPose::read(path, DEFAULT_MAX_SIZE).map_err(|e| Failure::bad_input(format!("--pose: {e}")))
        };
        Ok(MassQuestion {
            // `question` requires link and point.
            link: self.link.clone().unwrap_or_default(),
            point: self.point.unwrap_or_default(),
            normal,
            frame: self.frame.into(),
            normal_frame: self.normal_frame.unwrap_or(self.frame).into(),
            against: self.against.clone(),
            against_mass: self.against_mass,
            set: self.set.clone(),
            guess: self.guess.clone(),
            pose: self.pose.as_ref().map(pose).transpose()?,
            travel: self.travel.clone(),
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
