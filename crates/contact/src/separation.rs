//! End of a contact.

/// Definition of the end of a contact, for laws with a force that would pull before the gap closes.
///
/// Laws of the Hunt–Crossley family never pull, so their contacts end when the gap closes with both choices.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, PartialEq)]
pub enum Separation {
    /// Zero force, with the spring still compressed: contacts without adhesion, and simulators with the force max(0,
    /// F).
    #[default]
    ForceVanishes,
    /// Free length of the spring; the damper pulls shortly before. The half-period formula of textbooks.
    GapCloses,
}

impl Separation {
    /// Both choices, the default first.
    pub const ALL: [Self; 2] = [Self::ForceVanishes, Self::GapCloses];

    /// Name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::ForceVanishes => "force",
            Self::GapCloses => "gap",
        }
    }

    /// Returns the choice with a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|separation| separation.name() == name)
    }
}
