//! Loops that do not close, or not where the drivers are to go.

use crate::input::InputError;

/// Loops that do not close, or not where the drivers are to go.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AssemblyError {
    /// No closed pose was found at all.
    #[error(
        "the loops do not close: {} is {residual:.3e} m apart at best (a thousandth of the size, {allowed:.1e} m, \
         would pass as rounding){}; check its frames and axes, or give a starting pose",
        quoted(loops),
        cut_search(*cut)
    )]
    DoesNotClose {
        /// The loops and couplings of the group, the worst first.
        loops: Vec<String>,
        /// Largest residual of the best pose, m.
        residual: f64,
        /// What would pass, m.
        allowed: f64,
        /// If the search was cut short: starting poses that were tried, those of smaller groups, and the coordinates of the
        /// group, which are the reason.
        cut: Option<(u64, u64, usize)>,
    },
    /// The drivers cannot reach the positions asked for.
    #[error(
        "{} cannot be reached: {} would not close; nearest reached: {}{}",
        positions(requested),
        quoted(loops),
        positions(nearest),
        after(*starts)
    )]
    Unreachable {
        /// Driving joints and the positions asked for.
        requested: Vec<(String, f64)>,
        /// Where they came to on the same branch.
        nearest: Vec<(String, f64)>,
        /// The loops of the group.
        loops: Vec<String>,
        /// From how many other starts it was tried.
        starts: usize,
    },
    /// The branch of the first closed pose ends before the drivers are where they were set; the loops close there on another
    /// assembly mode.
    #[error(
        "{} is on another assembly mode: the branch of the first closed pose ends at {}, and {} would open there (another mode \
         was found from {starts} of the seeded starts); keep within the branch, or give a starting pose on the mode that is \
         meant",
        positions(requested),
        positions(nearest),
        quoted(loops)
    )]
    OtherAssembly {
        /// Driving joints and the positions asked for.
        requested: Vec<(String, f64)>,
        /// The end of the branch of the first closed pose.
        nearest: Vec<(String, f64)>,
        /// The loops of the group.
        loops: Vec<String>,
        /// From how many other starts the other mode was found.
        starts: usize,
    },
    /// The pose of the base is no rigid frame.
    #[error(transparent)]
    Base(#[from] InputError),
    /// The positions asked for are so far off that the branch cannot be followed there in one go.
    #[error(
        "{} is too far to follow the loops there in one go: they still closed at {}; whole turns can be left out if the \
         mechanism repeats after them, or give a starting pose there",
        positions(requested),
        positions(reached)
    )]
    TooFar {
        /// Driving joints and the positions asked for.
        requested: Vec<(String, f64)>,
        /// How far they came.
        reached: Vec<(String, f64)>,
    },
    /// Two branches come so close to each other on the path that they cannot be told apart.
    #[error(
        "branch uncertain: on the way to {} two assembly modes of {} meet within the closing tolerance at {}, and which of them \
         goes on is not known; start on the other side with a guess",
        positions(requested),
        quoted(loops),
        positions(reached)
    )]
    BranchUncertain {
        /// Driving joints and the positions asked for.
        requested: Vec<(String, f64)>,
        /// The drivers where the branches meet.
        reached: Vec<(String, f64)>,
        /// The loops of the group.
        loops: Vec<String>,
    },
    /// A pose of another system.
    #[error("the pose was made by another system; ask it for a pose of its own")]
    ForeignPose,
    /// A configuration of another mechanism.
    #[error("the configuration was made for another mechanism, \"{got}\"; this one is \"{expected}\"")]
    ForeignConfiguration {
        /// The mechanism of the configuration.
        got: String,
        /// The mechanism of the system.
        expected: String,
    },
    /// A rod without a declared length whose ends coincide with all joints at 0: no direction to hold.
    #[error(
        "rod \"{name}\" has no distance, and its ends coincide with all joints at 0; give it a <distance>, or hold the points \
         together with a spherical loop"
    )]
    NoDistance {
        /// The closure.
        name: String,
    },
    /// Loops so far from the root link that their positions cannot be told apart.
    #[error(
        "the loops {} are {size:.3e} m in size and stand {far:.3e} m from the root link, where positions are known to \
         {known:.1e} m; expected: at most {farthest:.3e} m; correct the origins of their joints, or move the root link \
         to them",
        quoted(loops)
    )]
    TooFarOut {
        /// The loops and couplings of the group.
        loops: Vec<String>,
        /// The size of the group, m.
        size: f64,
        /// How far from the root link it is with all joints at 0, m.
        far: f64,
        /// How far it may be, m.
        farthest: f64,
        /// What positions there are known to, m.
        known: f64,
    },
    /// A joint was set that follows others.
    #[error(
        "joint \"{joint}\" depends on others through the loops; {}, or start from another assembly",
        what_to_set(drivers, set)
    )]
    Dependent {
        /// The joint.
        joint: String,
        /// The joints that drive its group.
        drivers: Vec<String>,
        /// Those of them that were set beside it.
        set: Vec<String>,
    },
}

impl AssemblyError {
    /// The same after so many other starts were tried.
    pub(super) fn after_starts(mut self, tried: usize) -> Self {
        if let AssemblyError::Unreachable { starts, .. } = &mut self {
            *starts = tried;
        }
        self
    }

    /// The same where another assembly mode was found from so many starts.
    pub(super) fn on_other_assembly(self, starts: usize) -> Self {
        match self {
            AssemblyError::Unreachable { requested, nearest, loops, .. } => {
                AssemblyError::OtherAssembly { requested, nearest, loops, starts }
            }
            other => other,
        }
    }

    /// Whether a guess may help: the message ends in that, and whoever asks may add how a guess is given.
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

    /// Whether the input is at fault (and not merely the place asked for).
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

/// What drives instead of a joint that depends, or that more were set than can drive.
fn what_to_set(drivers: &[String], set: &[String]) -> String {
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

fn cut_search(cut: Option<(u64, u64, usize)>) -> String {
    cut.map_or_else(String::new, |(tried, most, coordinates)| {
        format!(
            "; the loops bind {coordinates} coordinates together, so that the search was cut short: {tried} starts of {most}"
        )
    })
}

fn after(starts: usize) -> String {
    if starts == 0 {
        String::new()
    } else {
        format!(" (other assembly modes were looked for from {starts} starts)")
    }
}

fn quoted(names: &[String]) -> String {
    if names.is_empty() {
        return "nothing".into();
    }
    names.iter().take(6).map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ")
}

fn positions(places: &[(String, f64)]) -> String {
    places.iter().take(6).map(|(n, v)| format!("{n} = {v:.12}")).collect::<Vec<_>>().join(", ")
}
