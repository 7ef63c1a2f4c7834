//! Spatial algebra: rigid transforms, twists, wrenches and inertias.
//!
//! All types are generic over a [`Scalar`]: `f64` or SIMD lanes. No operation
//! branches on a value, so a recursion with these types runs unchanged on any scalar.
//!
//! Conventions (`docs/reference/NOTATION.md`): `X_ab` maps b-coordinates to a-coordinates; the angular part comes first;
//! twist and wrench refer to the origin of the frame in which they are expressed. This crate contains no
//! bodies, joints or files.

mod articulated;
mod inertia;
pub mod lanes;
mod packed;
mod rotation;
mod scalar;
mod screw;
mod transform;

pub use articulated::ArticulatedInertia;
pub use inertia::SpatialInertia;
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
