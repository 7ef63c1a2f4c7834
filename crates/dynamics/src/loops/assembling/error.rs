//! Errors of assembly: loops that do not close, or do not close at the requested positions of the drivers.

use crate::model::input::InputError;

/// Error of assembly: loops that do not close, or do not close at the requested positions of the drivers.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AssemblyError {
    /// No closed pose was found.
    #[error(
        "the loops do not close: {} is {residual:.3e} m apart at best (permitted: a thousandth of the size, \
         {allowed:.1e} m){}; check its frames and axes, or give a starting pose",
        quoted(loops),
        cut_search(*cut)
    )]
    DoesNotClose {
        /// Loops and couplings of the group, the largest residual first.
        loops: Vec<String>,
        /// Largest residual of the best pose, m.
        residual: f64,
        /// Largest accepted residual, m.
        allowed: f64,
        /// If the search was cut short: starting poses that were tried, those of smaller groups, and the coordinates of the
        /// group, which are the reason.
        cut: Option<(u64, u64, usize)>,
    },
    /// The drivers cannot reach the requested positions.
    #[error(
        "{} cannot be reached: {} would not close; nearest reached: {}{}",
        positions(requested),
        quoted(loops),
        positions(nearest),
        after(*starts)
    )]
    Unreachable {
        /// Driving joints and requested positions.
        requested: Vec<(String, f64)>,
        /// Nearest positions on the same branch.
        nearest: Vec<(String, f64)>,
        /// Loops of the group.
        loops: Vec<String>,
        /// Number of other starts that were tried.
        starts: usize,
    },
    /// The branch of the first closed pose ends before the requested positions of the drivers. The loops close there
    /// in another assembly mode.
    #[error(
        "{} is on another assembly mode: the branch of the first closed pose ends at {}, because {} would open \
         (another mode \
         was found from {starts} of the seeded starts); keep within the branch, or give a starting pose on the \
         required mode",
        positions(requested),
        positions(nearest),
        quoted(loops)
    )]
    OtherAssembly {
        /// Driving joints and requested positions.
        requested: Vec<(String, f64)>,
        /// Positions at the end of the branch of the first closed pose.
        nearest: Vec<(String, f64)>,
        /// Loops of the group.
        loops: Vec<String>,
        /// Number of other starts until the other mode was found.
        starts: usize,
    },
    /// The pose of the base is not a rigid frame.
    #[error(transparent)]
    Base(#[from] InputError),
    /// The requested positions are too far for the step limit of the path follower.
    #[error(
        "{} is too far away to follow the loops in one call: they closed up to {}; omit whole turns if the \
         mechanism repeats after a turn, or give a starting pose there",
        positions(requested),
        positions(reached)
    )]
    TooFar {
        /// Driving joints and requested positions.
        requested: Vec<(String, f64)>,
        /// Positions reached.
        reached: Vec<(String, f64)>,
    },
    /// Two branches on the path are too close to each other to be distinguished.
    #[error(
        "branch uncertain: on the way to {} two assembly modes of {} meet within the closing tolerance at {}, \
         so the continuation is ambiguous; start beyond this point with a guess",
        positions(requested),
        quoted(loops),
        positions(reached)
    )]
    BranchUncertain {
        /// Driving joints and requested positions.
        requested: Vec<(String, f64)>,
        /// Positions of the drivers at the point where the branches meet.
        reached: Vec<(String, f64)>,
        /// Loops of the group.
        loops: Vec<String>,
    },
    /// The pose belongs to another system.
    #[error("the pose belongs to another system; create the pose with this system")]
    ForeignPose,
    /// The configuration belongs to another mechanism.
    #[error("the configuration belongs to another mechanism, \"{got}\"; this one is \"{expected}\"")]
    ForeignConfiguration {
        /// Mechanism of the configuration.
        got: String,
        /// Mechanism of the system.
        expected: String,
    },
    /// A distance closure has no declared length, and its ends coincide with all joints at 0. Its direction is
    /// undefined.
    #[error(
        "rod \"{name}\" has no distance, and its ends coincide with all joints at 0; give it a <distance>, or hold the points \
         together with a spherical loop"
    )]
    NoDistance {
        /// Name of the closure.
        name: String,
    },
    /// The loops are too far from the root link for their positions to be resolved.
    #[error(
        "the loops {} are {size:.3e} m in size and {far:.3e} m away from the root link, where positions are known to \
         {known:.1e} m; expected: at most {farthest:.3e} m; correct the origins of their joints, or move the root link \
         to them",
        quoted(loops)
    )]
    TooFarOut {
        /// Loops and couplings of the group.
        loops: Vec<String>,
        /// Size of the group, m.
        size: f64,
        /// Distance from the root link with all joints at 0, m.
        far: f64,
        /// Largest accepted distance, m.
        farthest: f64,
        /// Accuracy of positions at this distance, m.
        known: f64,
    },
    /// A dependent joint was set.
    #[error(
        "joint \"{joint}\" depends on others through the loops; {}, or start from another assembly",
        setting_advice(drivers, set)
    )]
    Dependent {
        /// The dependent joint.
        joint: String,
        /// Driving joints of its group.
        drivers: Vec<String>,
        /// Those driving joints that were set in addition.
        set: Vec<String>,
    },
}

impl AssemblyError {
    /// Sets the number of starts that were tried.
    pub(super) fn after_starts(mut self, tried: usize) -> Self {
        if let AssemblyError::Unreachable { starts, .. } = &mut self {
            *starts = tried;
        }
        self
    }

    /// Converts `Unreachable` to `OtherAssembly`, if another assembly mode was found.
    pub(super) fn on_other_assembly(self, starts: usize) -> Self {
        match self {
            AssemblyError::Unreachable { requested, nearest, loops, .. } => {
                AssemblyError::OtherAssembly { requested, nearest, loops, starts }
            }
            other => other,
        }
    }

    /// True if a guess may help. The message then ends with this advice, and a caller may append how to give a guess.
    pub fn ends_in_another_start(&self) -> bool {
        match self {
            AssemblyError::DoesNotClose { .. }
            | AssemblyError::OtherAssembly { .. }
            | AssemblyError::TooFar { .. }
            | AssemblyError::BranchUncertain { .. }
            | AssemblyError::Dependent { .. } => true,
            AssemblyError::Unreachable { .. }
            | AssemblyError::Base(_)
            | AssemblyError::ForeignPose
            | AssemblyError::ForeignConfiguration { .. }
            | AssemblyError::TooFarOut { .. }
            | AssemblyError::NoDistance { .. } => false,
        }
    }

    /// True if the input is invalid, and not only the requested position.
    pub fn is_bad_input(&self) -> bool {
        matches!(
            self,
            AssemblyError::Dependent { .. }
                | AssemblyError::NoDistance { .. }
                | AssemblyError::Base(_)
                | AssemblyError::TooFarOut { .. }
                | AssemblyError::ForeignPose
                | AssemblyError::ForeignConfiguration { .. }
        )
    }
}

/// Advice on joints to set instead of a dependent joint, or on joints to leave out.
fn setting_advice(drivers: &[String], set: &[String]) -> String {
    let free: Vec<String> = drivers.iter().filter(|driver| !set.contains(driver)).cloned().collect();
    match (drivers.is_empty(), set.is_empty(), free.is_empty()) {
        (true, ..) => "these leave no motion: set none of their joints".into(),
        (_, true, _) => format!("set {} instead", quoted(drivers)),
        (_, _, false) => {
            format!(
                "of the joints that drive them {} are set, and {} are free: set one of these instead",
                quoted(set),
                quoted(&free)
            )
        }
        (_, _, true) => format!(
            "too many joints are set: its loops follow from {}, and none of the others is free; leave this one out",
            quoted(set)
        ),
    }
}

/// Part of a message, for a search that was cut short: starts that were tried, starts allowed, bound coordinates. Empty
/// if `None`.
fn cut_search(cut: Option<(u64, u64, usize)>) -> String {
    cut.map_or_else(String::new, |(tried, most, coordinates)| {
        format!(
            "; the loops bind {coordinates} coordinates together, so that the search was cut short: {tried} starts of {most}"
        )
    })
}

/// Part of a message: number of starts of the search for other assembly modes. Empty if 0.
fn after(starts: usize) -> String {
    if starts == 0 {
        String::new()
    } else {
        format!(" (other assembly modes were looked for from {starts} starts)")
    }
}

/// Up to six names in quotation marks; `nothing` if empty.
fn quoted(names: &[String]) -> String {
    if names.is_empty() {
        return "nothing".into();
    }
    names.iter().take(6).map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ")
}

/// Up to six joints with their positions, for messages.
fn positions(places: &[(String, f64)]) -> String {
    places.iter().take(6).map(|(n, v)| format!("{n} = {v:.12}")).collect::<Vec<_>>().join(", ")
}
