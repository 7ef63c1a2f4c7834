//! Rigid links.

use crate::Inertial;
use crate::names::name_mark::NameMark;
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

/// Extent of the declared shape of a link. Used only for warnings about distant contact points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Geometry {
    /// No declared shape.
    #[default]
    None,
    /// Distance from the link's origin that contains the whole shape, m.
    Within(f64),
    /// Mesh of unknown size.
    Mesh,
}

/// Rigid link with name, mass and inertia.
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
    /// Name, unique in the mechanism.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Spatial inertia about the origin of the link frame, in the link's axes; zero for a massless link.
    pub fn inertia(&self) -> &SpatialInertia<f64> {
        &self.inertia
    }

    /// Declared inertia about the centre of mass; `None` if none was declared.
    pub fn inertial(&self) -> Option<&Inertial> {
        self.inertial.as_ref()
    }

    /// True if an inertia was declared (also with mass 0).
    pub fn has_inertial(&self) -> bool {
        self.inertial.is_some()
    }

    /// Extent of the declared shape.
    pub fn geometry(&self) -> Geometry {
        self.geometry
    }

    /// Largest known distance from the origin, m, of: centre of mass, radius of gyration, joints to children,
    /// declared shape. Zero for a link without any.
    pub fn extent(&self) -> f64 {
        self.extent
    }
}
