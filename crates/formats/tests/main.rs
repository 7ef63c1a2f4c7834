//! Readers and writers.

mod closing_pairs;
mod gazebo_joints;
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

/// Written files are read as the same models.
mod writing {
    mod round_trip;
    mod shapes;
}
