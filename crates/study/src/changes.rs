//! What is changed of a model, to ask the same question of several designs.

/// What is changed of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Masses of links, kg; moments about the centre of mass change in proportion.
    pub link_mass: Vec<(String, f64)>,
    /// Centres of mass of links, m, in the link's frame; moments about them stay.
    pub link_com: Vec<(String, [f64; 3])>,
    /// Hardpoints of a suspension's sheet that are moved: by how much, m, in the sheet's axes.
    pub moves: Vec<(String, [f64; 3])>,
}

impl Changes {
    /// Whether nothing is changed.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// These with others after them.
    #[must_use]
    pub fn and(&self, more: &Self) -> Self {
        let mut all = self.clone();
        all.link_mass.extend(more.link_mass.iter().cloned());
        all.link_com.extend(more.link_com.iter().cloned());
        all.moves.extend(more.moves.iter().cloned());
        all
    }
}
