//! SDFormat: reading, frames, refusals, and writing.

mod frames;
mod hostile;
mod includes;
mod joints;
mod loops;
mod refusals;
mod variants;
mod writing;

use percuss_formats::{LoadError, LoadOptions, Loaded, Source, load};
use percuss_mechanism::{Inertial, Joint, Mechanism};
use percuss_spatial::Transform;

/// Loads a model in SDFormat.
pub fn load_sdf(text: &str) -> Result<Loaded, LoadError> {
    load(&Source::from_text("model.sdf", text), &LoadOptions::default())
}

/// Loads a model that is valid.
pub fn read(text: &str) -> Loaded {
    load_sdf(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// File of version 1.`minor` with one model.
pub fn model(minor: u32, contents: &str) -> String {
    format!("<sdf version=\"1.{minor}\"><model name=\"m\">{contents}</model></sdf>")
}

/// Link with 2 kg and moments of 1, 2 and 2.5 kg·m²; `pose`: elements before the inertia.
pub fn link(name: &str, pose: &str) -> String {
    format!(
        "<link name=\"{name}\">{pose}<inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz></inertia></inertial></link>"
    )
}

/// Joint between two links; `contents`: elements behind the ends.
pub fn joint(name: &str, kind: &str, parent: &str, child: &str, contents: &str) -> String {
    format!(
        "<joint name=\"{name}\" type=\"{kind}\"><parent>{parent}</parent><child>{child}</child>{contents}</joint>"
    )
}

/// `<axis>` with a direction and further elements.
pub fn axis(xyz: &str, contents: &str) -> String {
    format!("<axis><xyz>{xyz}</xyz>{contents}</axis>")
}

/// Joint of the mechanism.
pub fn find<'m>(mechanism: &'m Mechanism, name: &str) -> &'m Joint {
    mechanism.joint(mechanism.find_joint(name).unwrap_or_else(|error| panic!("{error:?}")))
}

/// Inertia of a link.
pub fn inertial(mechanism: &Mechanism, link: &str) -> Inertial {
    *mechanism.link(mechanism.find_link(link).unwrap()).inertial().expect("an inertia")
}

/// Pose of a link in the world with all joints at 0.
pub fn drawn_pose(mechanism: &Mechanism, link: &str) -> Transform<f64> {
    let mut pose = Transform::identity();
    let mut current = mechanism.find_link(link).unwrap_or_else(|error| panic!("{error:?}"));
    while let Some(id) = mechanism.parent_joint(current) {
        let joint = mechanism.joint(id);
        pose = *joint.origin() * pose;
        current = joint.parent();
    }
    pose
}
