#![doc = include_str!("../README.md")]
//!
//! All types are generic over a [`Scalar`]. Conventions: `docs/reference/FORMULAS.md`.

mod articulated;
mod inertia;
mod interval;
pub mod lanes;
mod packed;
mod rotation;
mod scalar;
mod screw;
mod transform;

pub use articulated::ArticulatedInertia;
pub use inertia::SpatialInertia;
pub use interval::Interval;
pub use nalgebra::{Matrix3, Vector3};
pub use packed::{
    PackedInertia, PackedTwist, PackedWrench, Pivot, rotate_back, rotate_symmetric, rotated, rotation_rows,
    splat, turn_vector,
};
pub use rotation::{
    plane_basis, quaternion_product, rotation_about, rotation_from_quaternion, rotation_from_rpy,
    rpy_from_rotation,
};
pub use scalar::Scalar;
pub use screw::{Twist, Wrench};
pub use transform::Transform;
