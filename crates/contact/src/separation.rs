//! When a contact ends.

/// When a contact ends, for a law whose force would pull before the gap closes.
///
/// Laws of the Hunt–Crossley family never pull, and end when the gap closes under either choice.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, PartialEq)]
pub enum Separation {
    /// When the force has fallen to zero, the spring still pressed in: contacts that do not stick, and every
    /// simulator that takes max(0, F).
    #[default]
    ForceVanishes,
    /// When the spring has its free length again; the damper pulls shortly before. The half period of textbooks.
    GapCloses,
}

impl Separation {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::ForceVanishes, Self::GapCloses];

    /// As it is written in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::ForceVanishes => "force",
            Self::GapCloses => "gap",
        }
    }

    /// The one of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|separation| separation.name() == name)
    }
}
