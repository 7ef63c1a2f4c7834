//! A rigid link.

use crate::Inertial;
use crate::name_mark::NameMark;
use percuss_spatial::SpatialInertia;

/// Index of a link in its mechanism, in the order the links were given. It holds in every mechanism that has a link of the
/// same name at the same index, in variants with other masses too: [`Mechanism::has_link`](crate::Mechanism::has_link).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct LinkId {
    pub(crate) index: u32,
    pub(crate) mark: NameMark,
}

impl LinkId {
    pub(crate) fn new(index: usize, name: &str) -> Self {
        Self { index: index as u32, mark: NameMark::of(name) }
    }

    /// Position in [`Mechanism::links`](crate::Mechanism::links).
    pub fn index(self) -> usize {
        self.index as usize
    }
}

/// How far the declared shape of a link reaches. Used only to warn of a contact point far away, never in the mechanics.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Geometry {
    /// No shape was declared.
    #[default]
    None,
    /// All of it lies within this distance of the link's origin, m.
    Within(f64),
    /// It has a mesh, whose size is not known.
    Mesh,
}

/// A rigid link: its name, mass and inertia.
#[derive(Clone, Debug)]
pub struct Link {
    pub(crate) name: String,
    pub(crate) mark: NameMark,
    pub(crate) inertia: SpatialInertia<f64>,
    pub(crate) inertial: Option<Inertial>,
    pub(crate) geometry: Geometry,
    pub(crate) extent: f64,
}

impl Link {
    /// Its name, unique in the mechanism.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its inertia about the origin of the link frame, in the link's axes. Zero for a massless link.
    pub fn inertia(&self) -> &SpatialInertia<f64> {
        &self.inertia
    }

    /// Its inertia as it was declared, about the centre of mass; none for a link that declares nothing.
    pub fn inertial(&self) -> Option<&Inertial> {
        self.inertial.as_ref()
    }

    /// Whether an inertia was declared at all (a declared mass of 0 counts).
    pub fn has_inertial(&self) -> bool {
        self.inertial.is_some()
    }

    /// How far its declared shape reaches.
    pub fn geometry(&self) -> Geometry {
        self.geometry
    }

    /// How far from the origin anything of the link is known to lie, m: centre of mass, radius of gyration,
    /// joints to its children, declared shape. Zero for a bare frame.
    pub fn extent(&self) -> f64 {
        self.extent
    }
}
