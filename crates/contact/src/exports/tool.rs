//! The simulators: their names, and what is known of each whatever is asked.

/// A simulator that contacts are written for.
#[derive(Clone, Copy)]
pub struct Tool(&'static Facts);

/// What is known of a tool, whatever is asked.
#[derive(Debug)]
pub struct Facts {
    /// As it is written in files and on the command line.
    pub name: &'static str,
    /// As its makers write it.
    pub title: &'static str,
    /// Other names that [`Tool::from_name`](super::Tool::from_name) takes.
    pub aliases: &'static [&'static str],
    /// What the tool integrates, in plain words.
    pub law: &'static str,
    /// How it makes one value of those of the two sides of a contact.
    pub combines: &'static str,
    /// What came out where the tool was run with exported parameters. Empty: it was not measured.
    pub measured: &'static [Measurement],
    /// What a user has to watch for, in one line.
    pub caution: &'static str,
    /// The documentation and source files on which this is based.
    pub sources: &'static [&'static str],
}

/// A tool run with the parameters that were exported for it, at the exported step and accuracy 1e-3.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Measurement {
    /// Program and version.
    pub engine: &'static str,
    /// Solver or mode, empty where there is but one.
    pub solver: &'static str,
    /// What collided.
    pub scenes: &'static str,
    /// The worst error of e over all scenes and phases, rounded up, for e = 0.2, 0.5, 0.8; none where the export refuses it.
    pub worst: [Option<f64>; 3],
    /// Whether the checks repeat it every time; else it was run by hand, on this day.
    pub by_hand: Option<&'static str>,
}

impl Tool {
    pub(super) const fn of(facts: &'static Facts) -> Self {
        Self(facts)
    }

    /// What is known of it.
    pub fn facts(self) -> &'static Facts {
        self.0
    }

    /// As it is written in files and on the command line.
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// As its makers write it.
    pub fn title(self) -> &'static str {
        self.0.title
    }

    /// Other names that [`Tool::from_name`](super::Tool::from_name) takes.
    pub fn aliases(self) -> &'static [&'static str] {
        self.0.aliases
    }
}

impl PartialEq for Tool {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for Tool {}

impl std::hash::Hash for Tool {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.name().hash(state);
    }
}

impl std::fmt::Debug for Tool {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Tool({})", self.name())
    }
}

impl std::fmt::Display for Tool {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl serde::Serialize for Tool {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
