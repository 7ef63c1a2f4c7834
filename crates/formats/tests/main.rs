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
mod round_trip;
mod sdf;
mod support;
mod surfaces;
mod written_shapes;
