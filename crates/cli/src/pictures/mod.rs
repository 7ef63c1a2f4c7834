//! Figures of sweeps, ellipsoids, suspensions and maps.

pub(crate) mod clipping;
pub(crate) mod ellipsoid;
pub(crate) mod import_picture;
pub(crate) mod impulses;
pub(crate) mod kinematics_figure;
pub(crate) mod map_files;
pub(crate) mod mechanism;
pub(crate) mod sweep_figure;
