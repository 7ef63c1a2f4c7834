//! Readers and writers.

mod hostile_files;
mod loading;
mod loops;
mod malformed;
mod mjcf;
mod mutation;
mod plausible;
mod sdf;
mod support;
mod surfaces;

/// Elements of a URDF beside its links and joints.
mod urdf {
    mod closing_pairs;
    #[cfg(feature = "urdf-rs")]
    mod from_urdf_rs;
    mod gazebo_joints;
    mod simulator_elements;
}

/// Written files are read as the same models.
mod writing {
    mod round_trip;
    mod shapes;
}
