//! MJCF: reading, refusals, and writing.

mod attach;
mod hostile;
mod reading;
mod refusals;
mod relations;
mod writing;

use percuss_formats::{LoadError, LoadOptions, Loaded, Source, load};

/// Loads a model in MJCF.
pub fn load_mjcf(text: &str) -> Result<Loaded, LoadError> {
    load(&Source::from_text("model.xml", text), &LoadOptions::default())
}

/// Model of the contents of `<worldbody>` and further sections, with angles in radians.
pub fn model(worldbody: &str, sections: &str) -> String {
    format!(
        "<mujoco model=\"test\"><compiler angle=\"radian\"/><worldbody>{worldbody}</worldbody>{sections}</mujoco>"
    )
}
