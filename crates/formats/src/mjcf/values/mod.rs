//! Values of attributes: settings of the compiler, classes of defaults, numbers and orientations.

pub(crate) mod attributes;
pub(crate) mod classes;
pub(crate) mod models;
pub(crate) mod orientation;
pub(crate) mod settings;
