//! Simulators: names and constant facts.

/// Simulator with an export of contacts.
#[derive(Clone, Copy)]
pub struct Tool(&'static Facts);

/// Facts of a tool that do not depend on the request.
#[derive(Debug)]
pub struct Facts {
    /// Name in files and on the command line.
    pub name: &'static str,
    /// Name as written by its developers.
    pub title: &'static str,
    /// Other names that [`Tool::from_name`](super::Tool::from_name) accepts.
    pub aliases: &'static [&'static str],
    /// Contact law and integration method, in words.
    pub law: &'static str,
    /// Rule that combines the values of the two sides of a contact.
    pub combines: &'static str,
    /// Measured restitutions with exported parameters. Empty: not measured.
    pub measured: &'static [Measurement],
    /// Main limitation for users, in one line.
    pub caution: &'static str,
    /// Documentation and source files that these facts are based on.
    pub sources: &'static [&'static str],
}

/// Measurement: the tool, run with exported parameters at the exported time step and accuracy 1e-3.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Measurement {
    /// Program and version.
    pub engine: &'static str,
    /// Solver or mode; empty if there is only one.
    pub solver: &'static str,
    /// Colliding bodies.
    pub scenes: &'static str,
    /// Largest error of e over all scenes and phases, rounded up, for e = 0.2, 0.5, 0.8; `None` if the export refuses
    /// this e.
    pub worst: [Option<f64>; 3],
    /// Repetition: with every run of the checks, or by hand on a date.
    pub by_hand: Option<&'static str>,
}

impl Tool {
    /// Tool with these facts.
    pub(super) const fn of(facts: &'static Facts) -> Self {
        Self(facts)
    }

    /// Facts of the tool.
    pub fn facts(self) -> &'static Facts {
        self.0
    }

    /// Name in files and on the command line.
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// Name as written by its developers.
    pub fn title(self) -> &'static str {
        self.0.title
    }

    /// Other names that [`Tool::from_name`](super::Tool::from_name) accepts.
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
