//! Declared mass and inertia, about the centre of mass.

use nalgebra::{Matrix3, Vector3};
use percuss_spatial::SpatialInertia;

/// Declared mass, centre of mass and inertia of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertial {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the link frame, m.
    pub com: Vector3<f64>,
    /// Rotational inertia about the centre of mass, in the link's axes, kg·m².
    pub about_com: Matrix3<f64>,
}

impl Inertial {
    /// Point mass (kg) at `com` (m).
    pub fn point(mass: f64, com: [f64; 3]) -> Self {
        Self { mass, com: com.into(), about_com: Matrix3::zeros() }
    }

    /// Inertia from the mass (kg), the centre of mass (m) and principal moments about the centre of mass along
    /// the link's axes (kg·m²).
    pub fn diagonal(mass: f64, com: [f64; 3], moments: [f64; 3]) -> Self {
        Self { mass, com: com.into(), about_com: Matrix3::from_diagonal(&moments.into()) }
    }

    /// Spatial inertia about the link's origin.
    pub fn spatial(&self) -> SpatialInertia<f64> {
        SpatialInertia::about_com(self.mass, self.com, self.about_com)
    }
}
