//! Changes of a model, used to evaluate the same question for several designs.

/// Changes of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Density (kg/m³) of the shapes from which all masses, centres of mass and inertias are computed first.
    pub shape_density: Option<f64>,
    /// Mass of all links (kg), to which masses and inertias are scaled last.
    pub total_mass: Option<f64>,
    /// Masses of links, kg; moments about the centre of mass change in proportion.
    pub link_mass: Vec<(String, f64)>,
    /// Centres of mass of links, m, in the link's frame; moments about the centre of mass stay the same.
    pub link_com: Vec<(String, [f64; 3])>,
    /// Moments of inertia of links about the centre of mass and the axes of the link frame, kg·m²; products of inertia are unchanged.
    /// Applied after the masses.
    pub link_inertia: Vec<(String, [f64; 3])>,
    /// Displacements of hardpoints of a suspension's sheet, m, in the sheet's axes.
    pub moves: Vec<(String, [f64; 3])>,
}

impl Changes {
    /// True if there are no changes.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// True if masses, centres of mass or moments of inertia change.
    pub fn changes_inertia(&self) -> bool {
        let is_whole = self.shape_density.is_some() || self.total_mass.is_some();
        is_whole || !(self.link_mass.is_empty() && self.link_com.is_empty() && self.link_inertia.is_empty())
    }

    /// These changes followed by `more`.
    #[must_use]
    pub fn and(&self, more: &Self) -> Self {
        let mut all = self.clone();
        all.shape_density = more.shape_density.or(self.shape_density);
        all.total_mass = more.total_mass.or(self.total_mass);
        all.link_mass.extend(more.link_mass.iter().cloned());
        all.link_com.extend(more.link_com.iter().cloned());
        all.link_inertia.extend(more.link_inertia.iter().cloned());
        all.moves.extend(more.moves.iter().cloned());
        all
    }
}
